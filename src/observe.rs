//! Progress, warnings and cancellation: how a stage speaks while it works.

use crate::error::{Error, Result, Stage};

/// A structured warning: the run goes on, the reader should know.
#[derive(Clone, Debug, PartialEq, serde::Serialize, serde::Deserialize)]
pub struct Warning {
    /// Where it arose.
    pub stage: Stage,
    /// One sentence: what, where, what it means for the result.
    pub message: String,
}

/// Receives a stage's progress and warnings while it works. All methods may be called from any
/// thread.
pub trait Observer: Sync {
    /// `done` of `total` units of the stage's work are done (a unit is whatever the stage counts).
    fn progress(&self, _stage: Stage, _done: usize, _total: usize) {}
    /// Work on a stage begins; it ends before that on another one begins.
    fn begins(&self, _stage: Stage) {}
    /// Work on a stage ends, well or not.
    fn ends(&self, _stage: Stage) {}
    /// Something the user should know.
    fn warn(&self, _warning: Warning) {}
    /// True when the user has asked to stop.
    fn cancelled(&self) -> bool {
        false
    }
    /// `Err` of kind `Cancelled` when the user has asked to stop.
    fn check(&self, stage: Stage) -> Result<()> {
        if self.cancelled() { Err(Error::cancelled(stage)) } else { Ok(()) }
    }
}

/// Works on a stage and tells the observer when that begins and ends.
pub fn timed<T>(observer: &dyn Observer, stage: Stage, work: impl FnOnce() -> T) -> T {
    observer.begins(stage);
    let out = work();
    observer.ends(stage);
    out
}

/// Says nothing, never cancels.
pub struct Silent;
impl Observer for Silent {}

/// Passes everything on to another observer and keeps the warnings.
pub struct Recorder<'a> {
    inner: &'a dyn Observer,
    warnings: std::sync::Mutex<Vec<Warning>>,
}

impl<'a> Recorder<'a> {
    /// Records what `inner` is told.
    pub fn new(inner: &'a dyn Observer) -> Self {
        Recorder { inner, warnings: std::sync::Mutex::default() }
    }

    /// The warnings so far, each once, by stage and then by text: independent of threads.
    pub fn warnings(&self) -> Vec<Warning> {
        let mut all = self.warnings.lock().unwrap_or_else(std::sync::PoisonError::into_inner).clone();
        all.sort_by(|a, b| (a.stage as usize, &a.message).cmp(&(b.stage as usize, &b.message)));
        all.dedup();
        all
    }
}

impl Observer for Recorder<'_> {
    fn progress(&self, stage: Stage, done: usize, total: usize) {
        self.inner.progress(stage, done, total);
    }
    fn begins(&self, stage: Stage) {
        self.inner.begins(stage);
    }
    fn ends(&self, stage: Stage) {
        self.inner.ends(stage);
    }
    fn warn(&self, warning: Warning) {
        let mut all = self.warnings.lock().unwrap_or_else(std::sync::PoisonError::into_inner);
        if !all.contains(&warning) {
            self.inner.warn(warning.clone());
            all.push(warning);
        }
    }
    fn cancelled(&self) -> bool {
        self.inner.cancelled()
    }
}
