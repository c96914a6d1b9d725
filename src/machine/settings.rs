//! `[machine]` of the job file.

use std::path::PathBuf;

use crate::settings::section;

section! {
    /// `[machine]`
    "machine" MachineSettings, MachineKeys, s {
        /// Machine file, relative to the job file; default: the built-in demo machine.
        ///
        /// Absolute once the job is complete.
        #[serde(skip_serializing_if = "Option::is_none")]
        file: String as Option<PathBuf> = None;
        /// Angle of the pivoting head B, degrees; positive leans the spindle away from the
        /// platform.
        ///
        /// The default is enough to lift the holder off the platform, as in the S–θ paper.
        b_deg: f64 = 5.0, -85.0..=85.0;
    }
}
