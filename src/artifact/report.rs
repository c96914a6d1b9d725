//! What the checks found.

use super::{Blade, CheckId, Plan};
use crate::error::Missed;
use crate::geometry::{Point, Vector};

/// One check.
#[derive(Clone, Debug, PartialEq, serde::Serialize, serde::Deserialize)]
pub struct Check {
    /// Which check; files hold its name, e.g. `gouge`.
    #[serde(rename = "name")]
    pub id: CheckId,
    /// What was measured, in words, with its unit.
    pub quantity: String,
    /// Worst value found.
    pub worst: f64,
    /// Its limit.
    pub limit: f64,
    /// Unit of both.
    pub unit: String,
    /// The worst value is on the right side of the limit.
    pub passed: bool,
    /// Where: cutter location, if it has one.
    pub row: Option<usize>,
    /// Where: turn, if it has one.
    pub turn: Option<u32>,
    /// Where: point in the model frame, mm.
    pub point_mm: Option<[f64; 3]>,
    /// More, in words (which face, which part of the tool).
    pub note: String,
}

impl Check {
    /// A check without a place, passed where the worst value is at most its limit. What is not
    /// finite is worse than everything.
    pub fn at_most(id: CheckId, quantity: &str, worst: f64, limit: f64, unit: &str, note: String) -> Self {
        let worst = if worst.is_finite() { worst } else { f64::MAX };
        Check {
            id,
            quantity: quantity.into(),
            worst,
            limit,
            unit: unit.into(),
            passed: worst <= limit,
            row: None,
            turn: None,
            point_mm: None,
            note,
        }
    }

    /// The check at a cutter location of a plan, its place the ball centre.
    #[must_use]
    pub fn at_location(self, row: usize, plan: &Plan, blade: &Blade) -> Self {
        let location = plan.toolpath.locations.get(row);
        let point = location.map(|l| blade.model_from_blade * l.centre);
        Check { row: Some(row), turn: location.map(|l| l.turn), point_mm: point.map(|p| [p.x, p.y, p.z]), ..self }
    }
}

/// What a limit was computed from.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, serde::Serialize, serde::Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum LimitSource {
    /// The true curvature of the exact faces.
    Curvature,
    /// The measured ridges, where the part is a mesh.
    #[default]
    Ridges,
}

/// The inner turns of a path (all but the first and the last) beside the least length that their
/// area needs.
#[derive(Clone, Copy, Debug, Default, PartialEq, serde::Serialize, serde::Deserialize)]
pub struct LimitFigures {
    /// Area that the inner turns machine, mm².
    pub area_mm2: f64,
    /// Length of the inner turns along their contacts, mm.
    pub path_length_mm: f64,
    /// `∬ dA / d(h, ρ)` over that area: no path of this scallop is shorter, mm.
    pub limit_length_mm: f64,
    /// Length over limit.
    pub ratio: f64,
    /// What the limit was computed from.
    pub source: LimitSource,
    /// The same ratio from the measured ridges: a second opinion.
    pub ratio_by_ridges: f64,
    /// Ridges between the inner turns, each counting by the area that it stands on, mm: 5th
    /// percentile.
    pub ridge_p05_mm: f64,
    /// Median, mm.
    pub ridge_p50_mm: f64,
    /// 95th percentile, mm.
    pub ridge_p95_mm: f64,
    /// 99th percentile, mm.
    pub ridge_p99_mm: f64,
    /// Greatest, mm.
    pub ridge_max_mm: f64,
}

/// A place of the part that no ball of the tool's radius can reach.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct UncutPlace {
    /// The place, blade frame, mm.
    pub point: Point,
    /// Outward unit normal there.
    pub normal: Vector,
    /// What is left over it, mm.
    pub left_mm: f64,
}

/// A height over the part, and where it was measured.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Place {
    /// The place, blade frame, mm.
    pub point: Point,
    /// Row of the path.
    pub row: usize,
    /// Height, mm.
    pub height_mm: f64,
}

/// All checks of a run.
#[derive(Clone, Debug, Default, PartialEq, serde::Serialize, serde::Deserialize)]
pub struct CheckReport {
    /// The checks.
    pub checks: Vec<Check>,
    /// Scallop heights over the machined band, mm: greatest, 99th, 95th, 50th, 5th percentile.
    pub scallop_max_mm: f64,
    /// 99th percentile, mm.
    pub scallop_p99_mm: f64,
    /// 95th percentile, mm.
    pub scallop_p95_mm: f64,
    /// Median, mm.
    pub scallop_p50_mm: f64,
    /// 5th percentile, mm.
    pub scallop_p05_mm: f64,
    /// Number of surface points in the machined band that the scallop was measured at.
    pub scallop_samples: usize,
    /// Heights of the ridges between neighbouring turns, each counting by the area that it stands
    /// on, mm: greatest.
    pub ridge_max_mm: f64,
    /// 99th percentile, mm.
    pub ridge_p99_mm: f64,
    /// Median, mm.
    pub ridge_p50_mm: f64,
    /// 5th percentile, mm.
    pub ridge_p05_mm: f64,
    /// Length of the inner turns beside the limit, and the ridges between them.
    pub limit: LimitFigures,
    /// Samples of the machined band that no ball of this radius can reach: inner corners that stay
    /// uncut.
    pub uncut_samples: usize,
    /// Area beside the path that no ball of this radius can reach, mm².
    pub uncut_area_mm2: f64,
    /// Most that is left there, mm.
    pub uncut_height_mm: f64,
    /// The places, for the preview; found anew by each check.
    #[serde(skip)]
    pub uncut: Vec<UncutPlace>,
    /// Area that each place stands for, mm².
    #[serde(skip)]
    pub uncut_cell_mm2: f64,
    /// Scallop at the samples of the machined band, the lowest first, for the report; found anew by
    /// each check.
    #[serde(skip)]
    pub scallop: Vec<Place>,
    /// Ridges between neighbouring turns, likewise.
    #[serde(skip)]
    pub ridges: Vec<Place>,
    /// Deepest gouge, mm.
    pub gouge_mm: f64,
    /// Least clearance between tool (without ball) and part, mm.
    pub clearance_mm: f64,
    /// What axes, times and contacts say of turn-milling, where the job asks for it.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub turning: Option<TurningFigures>,
}

/// Turn-milling in figures: by axis positions, times and contacts alone.
#[derive(Clone, Copy, Debug, Default, PartialEq, serde::Serialize, serde::Deserialize)]
pub struct TurningFigures {
    /// Least and greatest offset of the tool from the blade axis, mm.
    pub offset_mm: [f64; 2],
    /// Least and greatest mean speed of turning of a turn between the first and the last, 1/min,
    /// where the blade is to turn evenly; `None`: none is judged.
    pub turning_per_min: Option<[f64; 2]>,
    /// Share by which the speed leaves the mean of its turn there.
    pub ripple: Option<f64>,
    /// What each tooth does, where the job says how many there are.
    pub tooth: Option<ToothFigures>,
}

/// What each tooth cuts.
#[derive(Clone, Copy, Debug, Default, PartialEq, serde::Serialize, serde::Deserialize)]
pub struct ToothFigures {
    /// Greatest feed per tooth of the contact, mm.
    pub feed_mm: f64,
    /// Thickest chip, mm; `None`: the job says no depth.
    pub chip_mm: Option<f64>,
    /// Highest marks along the feed, mm.
    pub mark_mm: f64,
    /// Share of the time below the least feed per tooth.
    pub below_least: f64,
    /// Least cutting speed at the contact, m/min.
    pub least_speed_m_min: f64,
}

impl CheckReport {
    /// All checks passed.
    pub fn passed(&self) -> bool {
        self.checks.iter().all(|c| c.passed)
    }

    /// The checks that did not.
    pub fn missed(&self) -> Vec<Missed> {
        let failed = self.checks.iter().filter(|c| !c.passed);
        failed.map(|c| Missed { check: c.id.to_string(), worst: c.worst, limit: c.limit }).collect()
    }
}
