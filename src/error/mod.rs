//! One error for all stages: what went wrong, where, which limit, what to do; and the exit code
//! that follows.

mod infeasible;
mod reason;

pub use infeasible::{Along, At, Bound, DesignFault, Frame, Infeasible, Missed, SectionFault, Spot, Stopped};
pub use reason::{EndReason, InTheWay, LeadReason, SurfaceEnd, WhyLeft, WhyNone};

use std::fmt;

/// The stage in which an error arose.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, serde::Serialize, serde::Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Stage {
    /// Job file, options, command line.
    Job,
    /// The parametric blade generator.
    Make,
    /// Reading, healing and recognising a model.
    Model,
    /// Plane sections.
    Section,
    /// Cutter locations.
    Path,
    /// The S–θ channel.
    Channel,
    /// Orientation schedule.
    Schedule,
    /// The smooth curve of ball centre and tool axis.
    Smooth,
    /// Machine kinematics.
    Machine,
    /// Feed and time.
    Feed,
    /// Checks.
    Verify,
    /// NC programs.
    Post,
    /// glTF preview and report.
    Preview,
    /// Writing the files of a run.
    Output,
    /// A family: its file, its members, its tables.
    Batch,
}

impl fmt::Display for Stage {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let name = format!("{self:?}").to_lowercase();
        f.write_str(&name)
    }
}

/// What kind of failure: decides the exit code.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ErrorKind {
    /// The run ended but its checks found something (exit code 1).
    Findings,
    /// Command line or job file (exit code 2).
    Usage,
    /// No plan exists within the limits given (exit code 3).
    Infeasible,
    /// A file cannot be read, understood or written (exit code 4).
    InputOutput,
    /// Interrupted by the user (exit code 130).
    Cancelled,
}

impl ErrorKind {
    /// The exit code of the process.
    pub fn exit_code(self) -> u8 {
        match self {
            ErrorKind::Findings => 1,
            ErrorKind::Usage => 2,
            ErrorKind::Infeasible => 3,
            ErrorKind::InputOutput => 4,
            ErrorKind::Cancelled => 130,
        }
    }
}

/// An error of any stage. `message` is one clear sentence: what, where (line, face, turn), which
/// limit; `advice` says what to do about it.
#[derive(Debug, thiserror::Error)]
#[error("{stage}: {message}{}", advice.as_ref().map(|a| format!(" ({a})")).unwrap_or_default())]
pub struct Error {
    /// Where it arose.
    pub stage: Stage,
    /// What kind it is.
    pub kind: ErrorKind,
    /// What, where, which limit.
    pub message: String,
    /// What to do.
    pub advice: Option<String>,
    /// What stands in the way of a plan, as data, where the message says it.
    pub infeasible: Option<Box<Infeasible>>,
    /// The cause, if another error caused it.
    #[source]
    pub source: Option<Box<dyn std::error::Error + Send + Sync>>,
}

impl Error {
    /// A new error without advice or cause.
    pub fn new(stage: Stage, kind: ErrorKind, message: impl Into<String>) -> Self {
        Error { stage, kind, message: message.into(), advice: None, infeasible: None, source: None }
    }
    /// Command line or job file.
    pub fn usage(stage: Stage, message: impl Into<String>) -> Self {
        Self::new(stage, ErrorKind::Usage, message)
    }
    /// No plan exists: in words and as data.
    pub fn infeasible(stage: Stage, message: impl Into<String>, what: Infeasible) -> Self {
        Error { infeasible: Some(Box::new(what)), ..Self::new(stage, ErrorKind::Infeasible, message) }
    }
    /// File trouble.
    pub fn io(stage: Stage, message: impl Into<String>) -> Self {
        Self::new(stage, ErrorKind::InputOutput, message)
    }
    /// Interrupted.
    pub fn cancelled(stage: Stage) -> Self {
        Self::new(stage, ErrorKind::Cancelled, "cancelled by the user")
    }
    /// Adds what to do.
    #[must_use]
    pub fn advise(mut self, advice: impl Into<String>) -> Self {
        self.advice = Some(advice.into());
        self
    }
    /// A plan may exist if the region ended at this height along the blade axis already, mm (blade
    /// frame).
    pub fn region_may_end_mm(&self) -> Option<f64> {
        self.infeasible.as_ref()?.region_may_end_mm()
    }
    /// A copy without its cause.
    #[must_use]
    pub fn without_cause(&self) -> Self {
        let (message, advice, infeasible) = (self.message.clone(), self.advice.clone(), self.infeasible.clone());
        Error { stage: self.stage, kind: self.kind, message, advice, infeasible, source: None }
    }
    /// Adds the cause.
    #[must_use]
    pub fn caused_by(mut self, source: impl std::error::Error + Send + Sync + 'static) -> Self {
        self.source = Some(Box::new(source));
        self
    }
}

/// The number of a turn as people read it. Data, tables and code count turns from 0; sentences, the
/// report, programs and options from 1.
pub fn turn_number(index: u32) -> u64 {
    u64::from(index) + 1
}

/// Result of a stage.
pub type Result<T> = std::result::Result<T, Error>;
