//! Tests of the channel.
#![allow(clippy::unwrap_used)]

mod brute;
mod cornered;
mod exact;
mod location;
mod sphere;
mod whole;
pub mod world;
