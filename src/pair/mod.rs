//! Two tools on one blade, opposite each other.
//!
//! **In**: free angles of both tools at the places of rows that both run in lock step
//! ([`crate::artifact::PairedRows`]). **Out**: the angles that are free for both ([`FreeAngles`]),
//! and for each row an angle of the table at which it stands still while both tools cut ([`hold`]).
//!
//! The workpiece turns for both tools at once. With `a(B, θ)` the axis on a cone about the blade
//! axis, tool 1 stands at `a(B₁, θ)` and tool 2 at `a(B₂, θ + δ)`, where δ is a constant of the
//! machine: half a turn for heads on opposite sides. So what is free for the pair is what is free
//! for tool 1 and, turned back by δ, for tool 2; free sets are intersected before any chain of
//! intervals is chosen, since the widest of each tool alone may miss the other's.
//!
//! How near the tools come to each other is [`Both`]'s; how much of an airfoil has an opposite side
//! at all is [`share`]'s.

mod angles;
mod apart;
mod hold;
mod settings;
mod share;

pub use angles::FreeAngles;
pub use apart::{Apart, Both};
pub use hold::{Held, HoldOptions, hold};
pub use settings::{PinchKeys, PinchSettings};
pub use share::{HOLDS_DEG, Share, share};
