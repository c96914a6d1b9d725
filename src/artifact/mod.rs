//! What is carried between stages: one file per datum, plain, validated, without algorithms.
//! Everything is in the blade frame, mm, radians, seconds (see the crate's page).
pub mod axis_motion;
pub mod blade;
pub mod channel;
pub mod deviation;
pub mod lead;
pub mod obstacle;
pub mod plan;
pub mod program;
pub mod report;
pub mod schedule;
pub mod section;
pub mod toolpath;

pub use axis_motion::AxisMotion;
pub use blade::Blade;
pub use channel::Channel;
pub use lead::Lead;
pub use obstacle::Obstacle;
pub use plan::Plan;
pub use program::Program;
pub use report::CheckReport;
pub use schedule::Schedule;
pub use section::Section;
pub use toolpath::Toolpath;
