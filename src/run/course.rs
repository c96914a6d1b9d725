//! How far a run goes, and what its stages after the model came to.

use super::summary::{StoppedFigures, Summary};
use crate::artifact::{CheckReport, Plan};
use crate::error::Stage;
use crate::verify::Verdict;

/// How far to go and what to do with a plan that fails its checks.
#[derive(Clone, Copy, Debug, Default)]
pub struct Course {
    /// Stop after this stage.
    pub until: Option<Stage>,
    /// Write programs even if the checks fail; their headers say so.
    pub force: bool,
    /// Leave times and memory out of `manifest.json`, so that the same job leaves the same bytes.
    pub timeless: bool,
    /// Most bytes of preview.glb; `None`: as [`GltfOptions`] has it.
    ///
    /// [`GltfOptions`]: crate::write::preview::GltfOptions
    pub preview_bytes: Option<usize>,
}

impl Course {
    pub(super) fn ends_at(self, stage: Stage) -> bool {
        self.until == Some(stage)
    }
}

/// A plan that fails its checks is taken all the same, marked as forced.
pub(super) fn forced(verdict: Verdict<Plan>) -> Verdict<Plan> {
    match verdict {
        Verdict::Failed(rejected) => Verdict::Passed(rejected.write_anyway()),
        passed => passed,
    }
}

/// What the stages after the model came to.
#[derive(Default)]
pub(super) struct Made {
    pub summary: Option<Summary>,
    pub stopped: Option<StoppedFigures>,
    pub report: Option<CheckReport>,
    pub verdict: Option<Verdict<Plan>>,
    pub seal: Option<String>,
    pub taken: Vec<Stage>,
}
