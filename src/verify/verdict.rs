//! Evidence as a type: what passed the checks, and what did not.

use crate::artifact::CheckReport;

/// A value together with the report of the checks that it went through. Only [`super::check`] makes
/// one, or [`super::seal::recall`] from a report that it sealed (or [`Rejected::write_anyway`],
/// which marks it as forced); writers of programs take nothing else.
#[derive(Clone, Debug, PartialEq)]
pub struct Verified<T> {
    value: T,
    report: CheckReport,
    forced: bool,
}

impl<T> Verified<T> {
    /// The checked value.
    pub fn value(&self) -> &T {
        &self.value
    }
    /// What the checks found.
    pub fn report(&self) -> &CheckReport {
        &self.report
    }
    /// The checks failed and the user asked for the program all the same: its header must say so.
    pub fn forced(&self) -> bool {
        self.forced
    }
    /// The same, marked as forced: evidence that rests on such.
    #[must_use]
    pub fn as_forced(self) -> Self {
        Verified { forced: true, ..self }
    }
    /// For unit tests of the writers only: evidence without checks. Not compiled into the library.
    #[cfg(test)]
    pub(crate) fn for_tests(value: T, report: CheckReport, forced: bool) -> Self {
        Verified { value, report, forced }
    }
}

/// A value that failed at least one check.
#[derive(Clone, Debug, PartialEq)]
pub struct Rejected<T> {
    value: T,
    report: CheckReport,
}

impl<T> Rejected<T> {
    /// The rejected value, to look at.
    pub fn value(&self) -> &T {
        &self.value
    }
    /// What the checks found.
    pub fn report(&self) -> &CheckReport {
        &self.report
    }
    /// On the user's explicit request: the value for writing, marked as [`Verified::forced`].
    pub fn write_anyway(self) -> Verified<T> {
        Verified { value: self.value, report: self.report, forced: true }
    }
}

/// How the checks ended.
#[derive(Clone, Debug, PartialEq)]
pub enum Verdict<T> {
    /// Every check passed.
    Passed(Verified<T>),
    /// At least one check failed.
    Failed(Rejected<T>),
}

impl<T> Verdict<T> {
    /// Judges `value` by its report: the only way to unforced evidence.
    pub(super) fn of(value: T, report: CheckReport) -> Self {
        if report.passed() {
            Verdict::Passed(Verified { value, report, forced: false })
        } else {
            Verdict::Failed(Rejected { value, report })
        }
    }
    /// What was checked.
    pub fn value(&self) -> &T {
        match self {
            Verdict::Passed(v) => v.value(),
            Verdict::Failed(r) => r.value(),
        }
    }
    /// What the checks found.
    pub fn report(&self) -> &CheckReport {
        match self {
            Verdict::Passed(v) => v.report(),
            Verdict::Failed(r) => r.report(),
        }
    }
}
