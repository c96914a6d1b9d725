//! The machine: axes, limits, forward and inverse kinematics.
//!
//! In: a machine file (TOML, [`Machine::from_toml`]) or the built-in [`Machine::demo`]. Out: axis positions of a pose
//! of the tool and the pose of axis positions ([`Machine::inverse`], [`Machine::forward`]), limits
//! ([`Machine::limits`]) and travel findings ([`Machine::check_travel`]).
//!
//! ## Frames
//! *Machine frame*: axes X, Y, Z of the machine, right-handed; `Z` from workpiece to spindle while `B = 0`.
//! *Blade frame* (also *part frame*): fixed to the workpiece, `x` along the blade axis from root to tip. While
//! `A = 0` a part point `p` lies at `offset + Rx(clamping) p`, so blade `x` is along machine `X`.
//!
//! ## Kinematics
//! The table turns the workpiece about the line `(y, z) = (axis_y, axis_z)` along X by the right-hand angle
//! `φ = σA`, with `σ = −1` where positive `A` means "the tool goes round the workpiece" (ISO 841, the default) and
//! `σ = +1` where positive `A` turns the workpiece itself:
//!
//! ```text
//! m = c + Rx(φ) (offset + Rx(clamping) p − c),   c = (0, axis_y, axis_z)
//! ```
//!
//! The head leans the spindle in the XZ plane, towards +X (the blade's tip) for positive lean (equations with `B` for it): the tool axis from tip
//! to spindle is `(sin B, 0, cos B)` in the machine frame. In the blade frame it shall be
//! `a(θ) = (sin B, cos B cos θ, cos B sin θ)`, whose angle about X is `θ`; in the machine its angle is 90°, so
//! `θ + clamping + φ = 90°`, that is
//!
//! ```text
//! A = −σ (θ + clamping − 90°):   ISO 841: A = θ + clamping − 90°
//! ```
//!
//! without any reduction to one turn: unwrapped `A` follows unwrapped `θ`.
//!
//! ## What X, Y, Z mean
//! The lean `β` is `B`, or `−B` on a machine whose positive `B` leans the spindle towards −X. The spindle's axis passes the pivot at the distance
//! `e` (`spindle_offset_mm`, along X while `B = 0`; along Y an offset changes nothing). Ball centre `C` (machine frame) and pivot `P` of the
//! head are `P = C + (pivot_length + gauge_length) a − e x'` with `x' = (cos β, 0, −sin β)`, and
//! `gauge_length` from the ball centre to the spindle's gauge line (stick-out and holder). The axes read the gauge
//! point that the same pivot has while `B = 0`: `(X, Y, Z) = P + e · (1, 0, 0) − pivot_length · (0, 0, 1)`. These are the positions of
//! [`crate::artifact::AxisMotion`], the travel limits are for them, and a control without tool-centre-point
//! kinematics (LinuxCNC with trivial kinematics) is programmed with them directly, with no tool length offset active
//! and machine zero as work zero. A control with tool-centre-point kinematics (Siemens `TRAORI`) is programmed with
//! the tool tip in the blade frame instead.
//!
//! ## Chains
//! A machine file may have a `chain` instead of table and head: all axes from the workpiece to the
//! tool, each with direction, point and travel. One or two of them are rotary, in any order: two
//! tables, table and head, two heads, four axes. Directions need not be square to one another
//! (nutating heads). Positive is always the tool against the workpiece (ISO 841). Equations are on
//! the page of `chain.rs`. The table-head form above is a chain too and keeps its own closed form;
//! a test holds both against each other.
//!
//! `mount.along` says where the blade axis points. A process engineer would clamp a blade along the
//! first rotary axis. That axis then turns the blade, and the second stands still at what the lean
//! of the job asks for. Otherwise both rotary axes move, all five axes at once, and programs say
//! so.
//!
//! [`Machine::check_lean`] refuses before anything is planned what a chain cannot do at a lean: out
//! of reach, beyond travel on either branch, or the tool axis within 0.06 degrees of the first
//! rotary axis.
//!
//! ## Limits
//! `|B| < 90°`: at 90° the tool axis is along X and `A` places nothing; machine files must keep within ±89.9°.
//! Without a chain there is one branch: the other solution, `180° − B`, is outside that range. Velocity, acceleration and jerk say
//! where they come from ([`Provenance`]).

mod along;
mod chain;
#[cfg(test)]
mod chain_tests;
mod config;
mod file;
mod kinematics;
mod travel;

pub use config::{
    Axes, AxisLimits, AxisName, DEMO_TOML, Head, LinearAxis, Machine, Mount, PositiveA, PositiveB, Provenance,
    RotaryAxis, Spindle, Table,
};
pub use kinematics::Pose;
pub use travel::TravelFinding;
