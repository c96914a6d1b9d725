//! A check of an audit, with where in the program.

use serde::Serialize;

use crate::artifact::CheckId;
use crate::artifact::report::Check;

/// Lines that follow one another and break a limit.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct LineRun {
    /// First line, from 1.
    pub first_line: usize,
    /// Last line.
    pub last_line: usize,
}

/// A check, with where in the program.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct LineCheck {
    /// The check; `row` is not used.
    #[serde(flatten)]
    pub check: Check,
    /// Line of the worst value, from 1.
    pub line: Option<usize>,
    /// That line.
    pub block: Option<String>,
    /// Lines that break the limit, in order, at most 20 spans.
    pub spans: Vec<LineRun>,
    /// How many such spans there are.
    pub span_count: usize,
}

/// How a check is called and judged.
pub(super) struct LineLimit {
    pub id: CheckId,
    pub quantity: String,
    pub limit: f64,
    pub unit: &'static str,
    pub passed: bool,
}
