//! Progress, warnings and cancellation: how a stage speaks while it works.

mod doubt;
mod remark;

pub use doubt::{Doubt, LeftOver, tightest};
pub use remark::{FarthestMove, Remark, direction, listed, short, standing_out};

use crate::error::{Error, Result, Stage};

/// A warning: the run goes on, the reader should know.
#[derive(Clone, Debug, PartialEq, serde::Serialize, serde::Deserialize)]
#[serde(from = "Told", into = "Told")]
pub struct Warning {
    /// Where it arose.
    pub stage: Stage,
    /// What, where, what it means for the result; its `Display` is one sentence.
    pub doubt: Doubt,
}

/// A warning as it stands in files: the sentence, and the data it was made of.
#[derive(serde::Serialize, serde::Deserialize)]
struct Told {
    stage: Stage,
    message: String,
    #[serde(default, skip_serializing_if = "Option::is_none")]
    doubt: Option<serde_json::Value>,
}

impl From<Warning> for Told {
    fn from(Warning { stage, doubt }: Warning) -> Self {
        let data = doubt.has_data().then(|| serde_json::to_value(&doubt).ok()).flatten();
        Told { stage, message: doubt.to_string(), doubt: data }
    }
}

impl From<Told> for Warning {
    /// What another version made of other data stays as its sentence.
    fn from(Told { stage, message, doubt }: Told) -> Self {
        let known = doubt.and_then(|d| serde_json::from_value::<Doubt>(d).ok()).filter(|d| d.to_string() == message);
        Warning { stage, doubt: known.unwrap_or(Doubt::Words(message)) }
    }
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

/// Works on a stage and reports its begin and end to the observer.
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
    /// Records what is reported to `inner`.
    pub fn new(inner: &'a dyn Observer) -> Self {
        Recorder { inner, warnings: std::sync::Mutex::default() }
    }

    /// The warnings so far, each once, by stage and then by text: independent of threads.
    pub fn warnings(&self) -> Vec<Warning> {
        let mut all = self.warnings.lock().unwrap_or_else(std::sync::PoisonError::into_inner).clone();
        all.sort_by_cached_key(|w| (w.stage as usize, w.doubt.to_string()));
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

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used)]
    use super::*;

    fn written(warning: &Warning) -> serde_json::Value {
        serde_json::to_value(warning).unwrap()
    }

    #[test]
    fn a_warning_holds_its_sentence_and_the_data_of_it() {
        let doubt = Doubt::NarrowChannel { width_deg: 0.1 + 0.2, turn: 3, turn_s_mm: 1.0 / 3.0 };
        let warning = Warning { stage: Stage::Channel, doubt };
        let json = written(&warning);
        let sentence =
            "the monotone channel is only 0.300° wide at turn 4, S = 0.333 mm: the schedule has little room there";
        assert_eq!((&json["message"], &json["doubt"]["what"]), (&sentence.into(), &"narrow-channel".into()));
        assert_eq!(json["doubt"]["turn"], 3);
        let text = serde_json::to_string(&warning).unwrap();
        assert_eq!(serde_json::from_str::<Warning>(&text).unwrap(), warning, "to the bit");
    }

    #[test]
    fn remarks_on_a_model_have_data_too() {
        let joined = Remark::EdgesJoined { count: 3, gap_mm: 0.1 + 0.2 };
        let farthest = FarthestMove { mm: 0.25, face: "face 7".into(), at_mm: [1.0, 1.0 / 3.0, -2.0] };
        let gaps = Remark::GapsClosed { count: 2, widest_mm: 0.0353, at_mm: [1.0, 1.0 / 3.0, -2.0] };
        let folds = Remark::FoldsLeftOut { count: 1, longest_mm: 0.13, at_mm: [1.0, 1.0 / 3.0, -2.0] };
        for (remark, says, key) in [
            (
                folds,
                "stretches in which edges fold back on themselves were left out: 1, the longest of 0.130 mm at (1.000, \
                 0.333, -2.000)",
                "longest_mm",
            ),
            (
                gaps,
                "2 gaps between edges of loops were closed, the widest of 0.035 mm at (1.000, 0.333, -2.000)",
                "at_mm",
            ),
            (joined, "3 edges that faces did not share were joined, at most 3.00e-1 mm apart", "gap_mm"),
            (Remark::TakenAtRest, "skins and morph targets are not applied: the mesh is taken at rest", "what"),
            (
                Remark::UnitNotCertain { across_mm: 7.4, unit: "mm".into(), others: vec![("cm".into(), 74.0)] },
                "the unit is not certain: the file names none, and 7.400 mm across in mm is unusual for a blade; in cm \
                 74.00 mm would be usual; give it with --unit",
                "others",
            ),
            (
                Remark::FacesChanged { count: 2, dropped: 1, farthest: Some(farthest) },
                "sewing changed 2 faces, 1 of them dropped, the most 0.2500 mm at face 7 near (1.000, 0.333, -2.000): \
                 the tool spares them as the file has them too",
                "farthest",
            ),
            (
                Remark::RepeatedFaces { faces: vec![["face 2".into(), "face 1".into()]] },
                "faces given twice were dropped: face 2 repeats face 1",
                "faces",
            ),
        ] {
            let warning = Warning { stage: Stage::Model, doubt: Doubt::Model(remark) };
            let json = written(&warning);
            assert_eq!(json["message"], says);
            assert!(json["doubt"]["what"].is_string() && !json["doubt"][key].is_null(), "{json}");
            assert_eq!(serde_json::from_value::<Warning>(json).unwrap(), warning);
        }
    }

    #[test]
    fn what_nobody_knows_stays_a_sentence() {
        let remark = Warning { stage: Stage::Model, doubt: Doubt::Words("a face is odd".into()) };
        let bare = serde_json::json!({ "stage": "model", "message": "a face is odd" });
        assert_eq!(written(&remark), bare);
        for doubt in [
            serde_json::json!({ "what": "odd-face", "face": 3 }),
            serde_json::json!({ "what": "several-channels", "count": null }),
            serde_json::json!({ "what": "several-channels", "count": 2 }),
        ] {
            let mut other = bare.clone();
            other["doubt"] = doubt;
            assert_eq!(serde_json::from_value::<Warning>(other).unwrap(), remark);
        }
    }
}
