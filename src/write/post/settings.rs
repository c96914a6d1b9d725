//! `[post]` of the job file.

use std::path::PathBuf;

use crate::artifact::program::Control;
use crate::settings::{TINY, section};

section! {
    /// `[post]`
    "post" PostSettings, PostKeys, s {
        /// Controls to write programs for.
        control: Vec<Control> = vec![Control::Siemens, Control::Linuxcnc];
        /// Own post files (TOML) to write programs with, besides.
        ///
        /// Absolute once the job is complete.
        #[serde(skip_serializing_if = "Vec::is_empty")]
        files: Vec<String> as Vec<PathBuf> = Vec::new();
        /// Number of the tool.
        tool_number: u32 = 1, 1.0..=99_999_999.0;
        /// Spindle speed, 1/min.
        spindle_rpm: f64 = 6000.0, 1.0..=1e6;
        /// Feed between the safe position and the feed height, mm/min.
        approach_feed_mm_min: f64 = 5000.0, 1.0..=1e6;
        /// Feed from the feed height to the part and back, mm/min.
        plunge_feed_mm_min: f64 = 300.0, 1.0..=1e6;
        /// Feed height over the first and last location, along the tool axis, mm.
        feed_height_mm: f64 = 5.0, TINY..=1000.0;
        /// Distance between the tool and the sphere around the part at the safe positions, mm.
        safe_clearance_mm: f64 = 20.0, TINY..=1000.0;
        /// Tolerance that the control may smooth positions by, mm.
        ///
        /// Left out: as the post file has it.
        #[serde(skip_serializing_if = "Option::is_none")]
        smoothing_mm: f64 as Option<f64> = None, TINY..=1.0;
        /// Write what switches the control's high-speed cutting on.
        look_ahead: bool = true;
    }
}
