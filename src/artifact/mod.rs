//! What is carried between stages: one file per datum, plain, validated, without algorithms.
//! Everything is in the blade frame, mm, radians, seconds (see the crate's page).
pub mod along;
pub mod axes;
pub mod axis_motion;
pub mod axis_travel;
pub mod blade;
pub mod channel;
pub mod check_id;
pub mod cone;
pub mod curve;
pub mod deviation;
pub mod lead;
pub mod meridian;
pub mod motion;
pub mod obstacle;
mod packed;
pub mod paired;
pub mod plan;
pub mod program;
pub mod programmed;
pub mod region;
pub mod report;
pub mod schedule;
pub mod section;
pub mod sphere;
pub mod stand;
pub mod tool_part;
pub mod toolpath;
pub mod wheel;

pub use axes::{Axes, AxisRows};
pub use axis_motion::AxisMotion;
pub use axis_travel::{AxisTravel, CornerPlace};
pub use blade::Blade;
pub use channel::{Channel, Sweep};
pub use check_id::{AxisCheck, CheckId};
pub use cone::{Cone, Cones};
pub use curve::Curve;
pub use lead::Lead;
pub use motion::Motion;
pub use obstacle::{Obstacle, PartAmong};
pub use paired::PairedRows;
pub use plan::Plan;
pub use program::Program;
pub use programmed::ProgrammedCurve;
pub use report::CheckReport;
pub use schedule::Schedule;
pub use section::Section;
pub use stand::Stand;
pub use tool_part::ToolPart;
pub use toolpath::Toolpath;
pub use wheel::{RotorFrame, Wheel};

/// The word by which files and the command line know a value: that of a variant without fields.
fn word(value: &impl serde::Serialize) -> String {
    serde_json::to_value(value).ok().and_then(|v| Some(v.as_str()?.to_owned())).unwrap_or_default()
}
