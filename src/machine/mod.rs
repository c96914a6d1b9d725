//! The machine: axes, limits, forward and inverse kinematics.
//!
//! In: a machine file (TOML, [`MachineFile`]) or the built-in [`Machine::demo`]. Out: the axes of
//! the machine ([`Machine::axes`]: name, direction, place, limits, what each carries), axis
//! positions of a pose of the tool and the pose of axis positions ([`Machine::inverse`],
//! [`Machine::forward`]), and travel findings ([`Machine::check_travel`]).
//!
//! ## Axes and heads
//! A row of positions ([`crate::artifact::Axes`]) has a column for every axis. Callers ask for a
//! column by its role: [`Machine::linear`], [`Machine::rotary`], [`Machine::turning_axis`]. A head
//! ([`Head`]) is a tool with the chain of axes between the workpiece and it; two heads share the
//! axes that carry the workpiece. A plan is made for the first head. Every machine file gives one.
//!
//! ## Frames
//! *Machine frame*: axes X, Y, Z of the machine, right-handed. *Blade frame* (also *part frame*):
//! fixed to the workpiece, `x` along the blade axis from root to tip. While all axes read 0, the
//! blade axis points along `mount.along` of the machine file, X where it says nothing.
//!
//! ## Chains
//! A machine file lists in its `chain` all axes from the workpiece to the tool, each with
//! direction, point and travel. One or two of them are rotary, in any order: two tables, table and
//! head, two heads, four axes. Directions need not be square to one another (nutating heads).
//! Positive is always the tool against the workpiece (ISO 841). Equations are on the page of
//! `chain.rs`. The chain is built once, when the file is read.
//!
//! A process engineer would clamp a blade along the first rotary axis. That axis then turns the
//! blade, and the second stands still at what the lean of the job asks for. Otherwise both rotary
//! axes move, all five axes at once, and programs say so.
//!
//! [`Machine::check_lean`] refuses before anything is planned what a machine cannot do at a lean:
//! out of reach, beyond travel on either branch, or the tool axis within 0.06 degrees of the first
//! rotary axis.
//!
//! ## Table and head
//! A file may have a `table` about X and a pivoting `head` in place of a chain: another way to
//! write the chain A X Y Z B. The table turns the workpiece about the line
//! `(y, z) = (axis_y, axis_z)` by the right-hand angle `φ = σA`, with `σ = −1` where positive `A`
//! means "the tool goes round the workpiece" (the default) and `σ = +1` where positive `A` turns
//! the workpiece itself. The head leans the spindle in the XZ plane, towards +X (the blade's tip)
//! for a positive lean `β`, which is `B`, or `−B` where positive `B` leans it towards −X. So
//!
//! ```text
//! A = −σ (θ + clamping − 90°):   ISO 841: A = θ + clamping − 90°
//! ```
//!
//! up to whole turns, and unwrapped `A` follows unwrapped `θ`.
//!
//! ## What X, Y, Z mean
//! The axes read the gauge point that the spindle would have while the rotary axes read 0. With
//! table and head: the spindle's axis passes the pivot at the distance `e` (`spindle_offset_mm`,
//! along X while `B = 0`; along Y an offset changes nothing). Ball centre `C` (machine frame) and
//! pivot `P` are `P = C + (pivot_length + gauge_length) a − e x'` with `x' = (cos β, 0, −sin β)`,
//! and `gauge_length` from the ball centre to the spindle's gauge line (stick-out and holder). Then
//! `(X, Y, Z) = P + e · (1, 0, 0) − pivot_length · (0, 0, 1)`. These are the positions of
//! [`crate::artifact::AxisMotion`], the travel limits are for them, and a control without
//! tool-centre-point kinematics (LinuxCNC with trivial kinematics) is programmed with them
//! directly, with no tool length offset active and machine zero as work zero. A control with
//! tool-centre-point kinematics (Siemens `TRAORI`) is programmed with the tool tip in the blade
//! frame instead.
//!
//! ## Limits
//! A head has one or two rotary axes, a machine at most [`crate::artifact::axes::MOST_AXES`] axes.
//! The `B` of a file with table and head must keep within ±89.9°: at 90° the tool axis is along X
//! and `A` places nothing. Velocity, acceleration and jerk say where they come from
//! ([`Provenance`]).

mod along;
mod axis;
mod chain;
#[cfg(test)]
mod chain_tests;
mod config;
mod file;
mod kinematics;
mod model;
mod pair;
mod peaks;
mod settings;
#[cfg(test)]
mod table_head;
mod travel;

pub use axis::{Axis, AxisLimits, AxisName, Carries, Provenance};
pub use chain::{Head, Pose};
pub use config::{
    AxisTables, DEMO_TOML, HeadTable, LinearAxis, MachineFile, Mount, PositiveA, PositiveB, RotaryAxis, Spindle, Table,
    Words,
};
pub use model::Machine;
pub use peaks::AxisPeak;
pub use settings::{MachineKeys, MachineSettings};
pub use travel::TravelFinding;
