//! `[section]` of the job file.

use crate::settings::section;

section! {
    /// `[section]`
    #[derive(Copy)]
    "section" SectionSettings, SectionKeys, s {
        /// Number of plane sections to write, spread over the airfoil.
        count: u32 = 12, 1.0..=1000.0;
    }
}
