//! The job: what the user typed, merged with `--set`, settled into a complete job that is saved
//! with the run.
//!
//! ```text
//! job file -> JobFile -> (--set) -> JobFile -> resolve -> Draft -> (the blade is read) -> complete -> Job
//! ```
//! Relative paths are relative to the job file. Lengths in mm, angles in degrees, units in the
//! names of the keys; an unknown key is an error. Tolerances are options with a default and its
//! reason, see the fields of [`Job`]'s sections. The JSON schema of the file is [`schema`], saved
//! in `models/job.schema.json`.

mod axis;
mod defaults;
mod load;
mod resolved;
mod room;
mod sections;
#[cfg(test)]
mod tests;
mod tool;
mod typed;
mod wheel;

pub use axis::AxisChoice;
pub use defaults::{Draft, resolve};
pub use load::{insert, parse, read_value};
pub use resolved::Job;
pub use sections::{
    FixtureKeys, FixtureSettings, LibraryEntry, ModelKeys, ModelSettings, RegionKeys, RegionReference, RegionSettings,
    ToolKeys, WheelKeys, WheelSettings,
};
pub use tool::Chosen;
pub use typed::JobFile;

/// JSON schema of the job file.
pub fn schema() -> schemars::Schema {
    crate::settings::schema::<JobFile>()
}
