//! # bladewright
//!
//! Machine programs for the roots of turbine and compressor blades, straight from their CAD.
//!
//! ## The problem
//! A cutter mills the airfoil of a blade near its platform. In the plain case it ends in a ball of
//! radius `R`. Its centre moves on the `R` level set of the distance to the whole part, so nothing
//! is gouged. The spindle's pivot `B` is fixed and a rotary table `A` turns the blade about its own
//! axis. So the tool axis lies on a cone about the blade axis, and one angle `θ` places it. Each
//! cutter location has a set of `θ` for which the whole tool is clear of the whole part. Over the
//! arc length `S` of a turn that is the *S–θ channel*. A schedule `θ(S)` inside it that never turns
//! back lets the machine run smoothly.
//!
//! Other cases differ in one thing each. A bull-nose or flat cutter is a disc with a ball rolled
//! over its rim. Among the blades of a wheel each location has a cone of its own, and five axes
//! move. In turn-milling the tool passes the blade axis at an offset. Two tools may pinch the blade
//! between them, and the table then stands still along each row.
//!
//! ## Frames and units
//! Millimetres, radians and seconds inside; millimetres and degrees at every border.
//!
//! * **model frame**: the frame of the CAD file, scaled to mm. Files that a run writes are in it.
//! * **blade frame**: `x` along the blade axis from root to tip; everything between reading and
//!   writing is in it. The tool axis of a root, from tip to spindle, is
//!   `a(θ) = (sin B, cos B cos θ, cos B sin θ)`.
//! * **machine frame**: see [`machine`].
//!
//! ## The pipeline
//! ```text
//! model -> Blade -> section -> Section -> path -> Toolpath -> channel -> Channel -> schedule -> Schedule
//!       -> lead, machine, feed -> AxisMotion -> verify -> Verified -> post, preview -> files
//! ```
//! Each arrow is a type of [`artifact`]; each name is a folder. Stages never import one another.

pub mod artifact;
pub mod batch;
pub mod channel;
pub mod cli;
pub mod error;
pub mod feed;
pub mod files;
pub mod geometry;
pub mod job;
pub mod lead;
pub mod machine;
pub mod make;
pub mod numerics;
pub mod observe;
pub mod orient;
pub mod pair;
pub(crate) mod parallel;
pub mod path;
pub mod plan;
pub mod read;
pub mod register;
pub mod reschedule;
pub mod run;
#[cfg(test)]
pub(crate) mod sample;
pub mod schedule;
pub mod section;
pub(crate) mod settings;
pub mod smooth;
pub mod tool;
pub mod verify;
pub mod write;

pub use error::{Error, ErrorKind, Stage};
