//! The places at which the channel is computed: all cutter locations, and places between them where
//! moves are long or the surface turns fast.

use crate::artifact::{Cone, Sweep, Toolpath};
use crate::geometry::{Point, Vector};
use crate::numerics::angle::nearest_turn;

use super::forbidden::View;
use super::region::EvenMove;

/// Turning of the surface normal that a move may have without a place between its ends, rad.
const MAX_TURN_RAD: f64 = 0.1;

/// What the lean of the cone may change by likewise, rad.
const MAX_LEAN_RAD: f64 = 0.02;

/// A normal with less than this square to the axis of its cone has no angle about it.
const PARALLEL: f64 = 1e-6;

/// A place on the path.
#[derive(Clone, Copy, Debug)]
pub(super) struct Sample {
    /// The location at or before it.
    pub row: usize,
    /// How far on to the next location, 0..1.
    pub fraction: f64,
    pub centre: Point,
    pub normal: Vector,
    /// The tool axes that it allows.
    pub cone: Cone,
    /// The angle θ about which angles are unwrapped, rad: that of the normal, unwrapped over the
    /// path, or 0 where θ swings.
    pub azimuth: f64,
    /// Angles farther than this from the azimuth are not asked for, rad.
    pub within_rad: Option<f64>,
}

impl Sample {
    /// The tool there, seen in the frame in which the azimuth is at 0.
    pub fn view(&self) -> View {
        View {
            centre: self.centre,
            cone: self.cone,
            azimuth: self.azimuth,
            within_rad: self.within_rad,
            motion: EvenMove::none(),
        }
    }
}

/// All places in order; azimuths unwrapped from the first one's, which lies within -π..=π.
pub(super) fn along(path: &Toolpath, max_step_mm: f64, sweep: Sweep) -> Vec<Sample> {
    along_finely(path, max_step_mm, MAX_TURN_RAD, sweep)
}

/// As [`along`], the surface normal turning by no more than so much from place to place, rad.
pub(super) fn along_finely(path: &Toolpath, max_step_mm: f64, max_turn_rad: f64, sweep: Sweep) -> Vec<Sample> {
    let mut out: Vec<Sample> = Vec::with_capacity(path.locations.len() * 2);
    let mut azimuth = 0.0;
    let mut push = |row: usize, fraction: f64, centre: Point, normal: Vector| {
        let cone = path.cones.between(row, fraction);
        azimuth = unwrapped(azimuth, &normal, &cone, sweep);
        out.push(Sample { row, fraction, centre, normal, cone, azimuth, within_rad: None });
    };
    for (row, here) in path.locations.iter().enumerate() {
        push(row, 0.0, here.centre, here.normal);
        let Some(next) = path.locations.get(row + 1) else { continue };
        let length = (next.centre - here.centre).norm();
        let turn = here.normal.angle(&next.normal);
        let lean = (path.cone(row + 1).lean_rad - path.cone(row).lean_rad).abs();
        let parts =
            (length / max_step_mm).max(turn / max_turn_rad).max(lean / MAX_LEAN_RAD).ceil().clamp(1.0, 1000.0) as usize;
        for k in 1..parts {
            let f = k as f64 / parts as f64;
            let normal = here.normal.lerp(&next.normal, f).try_normalize(1e-9).unwrap_or(here.normal);
            push(row, f, here.centre + (next.centre - here.centre) * f, normal);
        }
    }
    out
}

/// The place midway between two places that follow one another; the angle of its normal is
/// unwrapped from the first.
pub(super) fn midway(path: &Toolpath, [a, b]: [&Sample; 2], sweep: Sweep) -> Sample {
    let to = if b.row > a.row { 1.0 } else { b.fraction };
    let fraction = 0.5 * (a.fraction + to);
    let cone = path.cones.between(a.row, fraction);
    let normal = a.normal.lerp(&b.normal, 0.5).try_normalize(1e-9).unwrap_or(a.normal);
    let azimuth = unwrapped(a.azimuth, &normal, &cone, sweep);
    Sample {
        row: a.row,
        fraction,
        centre: nalgebra::center(&a.centre, &b.centre),
        normal,
        cone,
        azimuth,
        within_rad: None,
    }
}

/// The azimuth at every location, like those of the places.
pub(super) fn azimuths(path: &Toolpath, sweep: Sweep) -> Vec<f64> {
    let mut azimuth = 0.0;
    let unwrap = |(row, l): (usize, &crate::artifact::toolpath::CutterLocation)| {
        azimuth = unwrapped(azimuth, &l.normal, &path.cone(row), sweep);
        azimuth
    };
    path.locations.iter().enumerate().map(unwrap).collect()
}

/// The angle θ of `normal` nearest to `last`; `last` itself where the normal is parallel to the
/// cone's axis. 0 where θ swings.
fn unwrapped(last: f64, normal: &Vector, cone: &Cone, sweep: Sweep) -> f64 {
    if sweep == Sweep::Swing {
        return 0.0;
    }
    cone.theta_of(normal, PARALLEL).map_or(last, |a| nearest_turn(a, last))
}
