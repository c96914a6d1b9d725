//! `[verify]` of the job file.

use crate::settings::{TINY, section};

section! {
    /// `[verify]`
    #[derive(Copy)]
    "verify" VerifySettings, VerifyKeys, s {
        /// Deepest gouge allowed, mm.
        ///
        /// Default: the chord tolerance between locations and as much again for the location itself
        /// and the measurement; three chord tolerances where that is more.
        gouge_mm: f64 = 0.003, TINY..=10.0;
        /// The 99th percentile of the scallop may be this many times `path.scallop_mm`.
        scallop_ratio: f64 = 1.05, 0.01..=1000.0;
        /// Greatest error that a check along the motion may make between its samples, mm.
        ///
        /// Default: half the chord tolerance.
        resolution_mm: f64 = 0.0005, 1e-5..=1.0;
        /// Number of surface samples in the machined band, about.
        ///
        /// With the default percentiles are good to 1 %.
        surface_samples: u32 = 120_000, 1000.0..=1e7;
    }
}
