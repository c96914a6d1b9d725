//! The windows of θ that contact angle and ridges leave to a cutter with a corner.

use super::samples::Sample;
use super::{ChannelOptions, Surroundings};
use crate::artifact::Toolpath;
use crate::geometry::{Point, Vector};
use crate::parallel;
use crate::tool::Tool;
use crate::tool::inclination::{BEND, Bending, Inclined};

/// Turning of the surface normal from place to place, rad: windows are hardly wider than what they
/// move by round an edge, and are to overlap.
pub(super) const TURN_RAD: f64 = 0.02;
/// The bend of the surface is looked at over so many places at most to either side.
const MOST_BEND: usize = 50;
/// A window begins so much lower than at the place beside it at most, rad, seen from the normal.
const OPENS_RAD: f64 = 0.01;

/// A cutter with a corner among bodies.
pub(super) struct WindowScene<'a> {
    pub around: &'a Surroundings<'a>,
    pub tool: &'a Tool,
    pub options: &'a ChannelOptions,
    pub path: &'a Toolpath,
}

/// θ from and to, rad.
pub(super) type Window = Option<[f64; 2]>;

impl WindowScene<'_> {
    /// θ that contact angle and ridges leave at a place.
    pub fn window(&self, samples: &[Sample], k: usize) -> Window {
        let (s, settings) = (&samples[k], &self.options.settings);
        let contact_deg = [settings.contact_angle_min_deg, settings.contact_angle_max_deg];
        let inclined = Inclined::new(self.tool, contact_deg, s.cone)?;
        Some(inclined.window_rad(&self.bending(samples, k))?.map(|on| s.azimuth + on))
    }

    /// The same at all places. Where the path turns, windows open fast; walls are straight between
    /// locations, so they open no faster than by [`OPENS_RAD`] from place to place.
    pub fn windows(&self, samples: &[Sample]) -> Vec<Window> {
        let mut windows: Vec<Window> = parallel::map(0..samples.len(), |k| self.window(samples, k));
        let mut ease = |k: usize, before: usize| {
            if let (Some([from, _]), Some([low, high])) = (windows[before], &mut windows[k]) {
                let turned = samples[k].azimuth - samples[before].azimuth;
                *low = low.max((from + turned - OPENS_RAD).min(*high));
            }
        };
        (1..samples.len()).for_each(|k| ease(k, k - 1));
        (1..samples.len()).rev().for_each(|k| ease(k - 1, k));
        windows
    }

    /// How the surface bends along the way, from a step before a place to one beyond it.
    fn bending(&self, samples: &[Sample], k: usize) -> Bending {
        let (s, corner) = (&samples[k], self.tool.corner_mm());
        let far = |other: &&Sample| (other.centre - s.centre).norm() >= BEND * corner;
        let before = samples[..k].iter().rev().take(MOST_BEND).find(far).or(samples[..k].last()).unwrap_or(s);
        let beyond = samples[k + 1..].iter().take(MOST_BEND).find(far).or(samples.get(k + 1)).unwrap_or(s);
        Bending::of_corner(s.normal, beyond.centre - before.centre, beyond.normal - before.normal, corner)
    }

    /// Centre of the disc at θ, on the corner's centre of a place.
    pub fn centre(&self, s: &Sample, theta: f64) -> Option<(Point, Vector)> {
        let axis = s.cone.tool_axis(theta);
        let contact = s.centre - s.normal * self.tool.corner_mm();
        Some((self.tool.centre_at(&contact, &s.normal, &axis, None)?, axis))
    }
}
