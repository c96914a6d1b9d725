//! What the checks found.

/// One check.
#[derive(Clone, Debug, PartialEq, serde::Serialize, serde::Deserialize)]
pub struct Check {
    /// Name, e.g. `gouge`.
    pub name: String,
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
    /// Heights of the ridges between neighbouring turns, mm: greatest, 99th, 50th, 5th percentile.
    pub ridge_max_mm: f64,
    /// 99th percentile, mm.
    pub ridge_p99_mm: f64,
    /// Median, mm.
    pub ridge_p50_mm: f64,
    /// 5th percentile, mm.
    pub ridge_p05_mm: f64,
    /// Samples of the machined band that no ball of this radius can reach: inner corners that stay uncut.
    pub uncut_samples: usize,
    /// Deepest gouge, mm.
    pub gouge_mm: f64,
    /// Least clearance between tool (without ball) and part, mm.
    pub clearance_mm: f64,
}

impl CheckReport {
    /// All checks passed.
    pub fn passed(&self) -> bool {
        self.checks.iter().all(|c| c.passed)
    }
}
