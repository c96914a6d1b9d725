//! Travel of a linear axis as a limit of the angle θ.
//!
//! While the lean stays, the rotary axis turns the blade under the tool, or the tool round the
//! blade. For a ball centre `c` every linear axis then stands at
//!
//! ```text
//! q(θ) = mean(c) + cos(c) cos θ + sin(c) sin θ
//! ```
//!
//! with three affine functions of `c`: where the axis may not be is an arc of θ or two.
//!
//! A cutter with a corner has the centre of its disc in the place of `c`, and that goes about the
//! corner's with θ ([`CornerPlace`]). What is left of θ is then found by halving intervals, whose
//! middle and the greatest rate of `q` say whether all of them is within the travel or beyond it.

use std::f64::consts::TAU;

use super::Cone;
use crate::geometry::disc::Disc;
use crate::geometry::{Point, Vector};
use crate::numerics::angle::nearest_turn;

/// Less than this is rounding where arcs meet, rad.
const SLIVER: f64 = 1e-12;

/// Intervals of θ are halved down to this, rad: what is left is short of the travel by so much.
const HALVED_RAD: f64 = 2e-5;
/// The sine of the angle between tool axis and normal is no less than this where a disc's centre is
/// followed.
const LEAST_SINE: f64 = 1e-3;

/// Factors that differ by less are the same.
const SAME: f64 = 1e-9;

/// An affine function of a point: a constant and a factor for each coordinate.
pub type Affine = [f64; 4];

/// A linear axis, where it stands, and where it may be.
#[derive(Clone, Debug, PartialEq)]
pub struct AxisTravel {
    /// Its name in messages.
    pub name: String,
    /// Its column among the machine's axes; `None`: the job limits the offset.
    pub column: Option<usize>,
    /// Least and greatest position, mm.
    pub limits_mm: [f64; 2],
    /// Mean of its position over a turn, mm.
    pub mean: Affine,
    /// Factor of `cos θ`, mm.
    pub cos: Affine,
    /// Factor of `sin θ`, mm.
    pub sin: Affine,
}

impl AxisTravel {
    /// Offset of the plane of tool axes from the blade axis, limited: see [`offset_mm`].
    pub fn of_offset(name: &str, limits_mm: [f64; 2]) -> Self {
        AxisTravel {
            name: name.into(),
            column: None,
            limits_mm,
            mean: [0.0; 4],
            cos: [0.0, 0.0, 0.0, -1.0],
            sin: [0.0, 0.0, 1.0, 0.0],
        }
    }

    /// The range of offsets ([`offset_mm`]) that it leaves, mm, where the axis stands still as long
    /// as the offset does: a lathe's Y.
    pub fn as_offsets(&self) -> Option<[f64; 2]> {
        let sense = self.sin[2];
        let same = |a: &Affine, b: Affine| a.iter().zip(b).all(|(a, b)| (a - b).abs() < SAME);
        let is_offset = (sense.abs() - 1.0).abs() < SAME
            && same(&self.sin, [0.0, 0.0, sense, 0.0])
            && same(&self.cos, [0.0, 0.0, 0.0, -sense])
            && same(&self.mean, [self.mean[0], 0.0, 0.0, 0.0]);
        let [a, b] = self.limits_mm.map(|limit| (limit - self.mean[0]) * sense);
        is_offset.then(|| [a.min(b), a.max(b)])
    }

    /// Where the axis stands, mm.
    pub fn at(&self, centre: &Point, theta_rad: f64) -> f64 {
        let [mean, cos, sin] = self.wave(centre);
        mean + cos * theta_rad.cos() + sin * theta_rad.sin()
    }

    fn wave(&self, c: &Point) -> [f64; 3] {
        [&self.mean, &self.cos, &self.sin].map(|f| f[0] + f[1] * c.x + f[2] * c.y + f[3] * c.z)
    }

    /// The angles at which the axis would be beyond its travel: up to two open arcs, from an angle
    /// within −2π..2π on, each shorter than a turn or a whole one.
    pub fn forbidden(&self, centre: &Point) -> impl Iterator<Item = [f64; 2]> + use<> {
        let [mean, cos, sin] = self.wave(centre);
        let (size, phase) = (cos.hypot(sin), sin.atan2(cos));
        let [least, greatest] = self.limits_mm;
        // Half width of the arc about the phase on which the axis is above a value.
        let above = |value: f64| ((value - mean) / size).clamp(-1.0, 1.0).acos();
        let over = (mean + size > greatest).then(|| [phase - above(greatest), phase + above(greatest)]);
        let under = (mean - size < least).then(|| [phase + above(least), phase - above(least) + TAU]);
        [over, under].into_iter().flatten()
    }

    /// What the travel leaves of an interval of θ, unwrapped over the path, rising; each with
    /// whether its ends are those of the interval.
    pub fn left_of(&self, centre: &Point, interval: [f64; 2]) -> Vec<([f64; 2], [bool; 2])> {
        let mut left = vec![(interval, [true, true])];
        for [from, to] in self.forbidden(centre) {
            let mut next = Vec::with_capacity(left.len() + 1);
            for ([lo, hi], own) in left {
                let (mut at, mut own_at) = (lo, own[0]);
                // The first turn of the arc that ends after `lo`.
                let mut turn = ((lo - to) / TAU).ceil() * TAU;
                while from + turn < hi {
                    if from + turn > at + SLIVER {
                        next.push(([at, from + turn], [own_at, false]));
                    }
                    if to + turn > at {
                        (at, own_at) = (to + turn, false);
                    }
                    turn += TAU;
                }
                if at + SLIVER < hi || own_at {
                    next.push(([at, hi], [own_at, own[1]]));
                }
            }
            left = next;
        }
        left
    }
}

/// A cutter with a corner that touches the part at a place, whatever its axis.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CornerPlace {
    /// Centre of the corner, blade frame, mm.
    pub corner: Point,
    /// The part's outward normal there, unit.
    pub normal: Vector,
    /// The tool axes.
    pub cone: Cone,
    /// Radius of the disc that the corner rolls over, mm.
    pub disc_radius_mm: f64,
}

impl CornerPlace {
    /// Centre of the disc at an angle of the tool axis, blade frame, mm; the corner's where the
    /// axis is along the normal.
    pub fn disc_centre(&self, theta_rad: f64) -> Point {
        Disc::of_corner(&self.corner, &self.normal, self.cone.tool_axis(theta_rad), self.disc_radius_mm).centre
    }
}

impl AxisTravel {
    /// As [`Self::left_of`], for a cutter with a corner: no more than is within the travel, and
    /// short of that by [`HALVED_RAD`] at most. `least_angle_rad`: the angle between tool axis and
    /// normal is nowhere less.
    pub fn left_of_disc(
        &self,
        place: &CornerPlace,
        interval: [f64; 2],
        least_angle_rad: f64,
    ) -> Vec<([f64; 2], [bool; 2])> {
        // With the unit vector u from the corner's centre to the disc's, q = mean + cos cos θ + sin
        // sin θ of `corner + r u`. The axis turns by no more than θ, so u turns about the normal
        // and towards it by no more than θ over the sine of the angle between axis and normal.
        let size = |f: &Affine| Vector::new(f[1], f[2], f[3]).norm();
        let [_, cos, sin] = self.wave(&place.corner);
        let turns = size(&self.cos).hypot(size(&self.sin));
        let goes = (size(&self.mean) + turns) / least_angle_rad.sin().max(LEAST_SINE);
        let rate = cos.hypot(sin) + place.disc_radius_mm * (turns + goes);
        let mut left: Vec<[f64; 2]> = Vec::new();
        let mut open = vec![interval];
        while let Some([lo, hi]) = open.pop() {
            let (middle, most) = (0.5 * (lo + hi), 0.5 * rate * (hi - lo));
            let at = self.at(&place.disc_centre(middle), middle);
            let room = (at - self.limits_mm[0]).min(self.limits_mm[1] - at);
            if room >= most {
                match left.last_mut().filter(|before| before[1] == lo) {
                    Some(before) => before[1] = hi,
                    None => left.push([lo, hi]),
                }
            } else if room > -most && hi - lo > HALVED_RAD {
                open.extend([[middle, hi], [lo, middle]]);
            }
        }
        left.into_iter().map(|ends| (ends, [ends[0] == interval[0], ends[1] == interval[1]])).collect()
    }
}

/// Offset of the plane that the tool axes of an angle θ lie in from the blade axis, as seen from a
/// ball centre, mm: `y sin θ − z cos θ = ρ sin(θ − ψ)`. It is the Y of the ball centre where the
/// blade axis is X and the tool comes from +Z, whatever the lean (eccentricity in turn-milling).
pub fn offset_mm(centre: &Point, theta_rad: f64) -> f64 {
    centre.y * theta_rad.sin() - centre.z * theta_rad.cos()
}

/// The angle on the tool's half at which the plane of tool axes has an offset, rad, in the turn of
/// another angle: `θ = ψ + asin(e / ρ)`. A centre nearer to the blade axis than the offset has the
/// angle of the offset that it reaches.
pub fn theta_at_offset(centre: &Point, offset_mm: f64, near_rad: f64) -> f64 {
    let (rho_mm, psi) = (centre.y.hypot(centre.z), centre.z.atan2(centre.y));
    let lead = (offset_mm / rho_mm.max(f64::MIN_POSITIVE)).clamp(-1.0, 1.0).asin();
    nearest_turn(psi + lead, near_rad)
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used)]
    use super::*;

    fn inside(travel: &AxisTravel, c: &Point, theta: f64) -> bool {
        (travel.limits_mm[0]..=travel.limits_mm[1]).contains(&travel.at(c, theta))
    }

    #[test]
    fn what_is_left_is_where_the_axis_is_within_its_travel() {
        let mut of_both_kinds = [0, 0];
        for k in 0..400 {
            let f = f64::from(k);
            let c = Point::new(f, 20.0 * (0.37 * f).sin(), 15.0 * (0.71 * f).cos());
            let limits_mm = [-12.0 + 10.0 * (0.11 * f).sin(), -1.0 + 12.0 * (0.23 * f).sin().abs()];
            let travel = AxisTravel::of_offset("Y", limits_mm);
            let interval = [f, f + 0.1 + 0.02 * f];
            let left = travel.left_of(&c, interval);
            for i in 0..=2000 {
                let theta = interval[0] + (interval[1] - interval[0]) * f64::from(i) / 2000.0;
                let near = travel.limits_mm.iter().any(|l| (travel.at(&c, theta) - l).abs() < 1e-9);
                let is_left = left.iter().any(|([a, b], _)| (*a..=*b).contains(&theta));
                of_both_kinds[usize::from(is_left)] += 1;
                assert!(near || is_left == inside(&travel, &c, theta), "{k}: θ {theta} of {left:?}");
            }
            for ([a, b], own) in left {
                assert!(a < b && (!own[0] || a == interval[0]) && (!own[1] || b == interval[1]));
            }
        }
        assert!(of_both_kinds.iter().all(|n| *n > 100_000), "{of_both_kinds:?}");
    }

    #[test]
    fn what_is_left_of_a_disc_is_where_the_axis_is_within_its_travel() {
        let mut of_both_kinds = [0, 0];
        for k in 0..100 {
            let f = f64::from(k);
            let normal = Vector::new(0.3 * (0.9 * f).sin(), (0.37 * f).sin(), (0.37 * f).cos()).normalize();
            let corner = Point::new(f, 20.0 * (0.37 * f).sin(), 15.0 * (0.37 * f).cos());
            let cone = Cone::about_blade(0.1 * (0.5 * f).cos());
            let place = CornerPlace { corner, normal, cone, disc_radius_mm: 6.0 };
            let limits_mm = [-6.0 + 5.0 * (0.11 * f).sin(), 1.0 + 5.0 * (0.23 * f).sin().abs()];
            let travel = AxisTravel::of_offset("Y", limits_mm);
            let azimuth = normal.z.atan2(normal.y);
            let interval = [azimuth + 0.05, azimuth + 0.6];
            let angle = |theta: f64| cone.tool_axis(theta).angle(&normal);
            let least = (0..=100).map(|i| angle(interval[0] + 0.0055 * f64::from(i))).fold(f64::INFINITY, f64::min);
            let left = travel.left_of_disc(&place, interval, least);
            for i in 0..=2000 {
                let theta = interval[0] + (interval[1] - interval[0]) * f64::from(i) / 2000.0;
                let at = travel.at(&place.disc_centre(theta), theta);
                let room = (at - limits_mm[0]).min(limits_mm[1] - at);
                let is_left = left.iter().any(|([a, b], _)| (*a..=*b).contains(&theta));
                of_both_kinds[usize::from(is_left)] += 1;
                // Nothing beyond the travel is left, and all is that is within it by more than the
                // axis goes in the shortest interval.
                assert!(if is_left { room >= -1e-9 } else { room < 0.01 }, "{k}: θ {theta}, room {room}");
            }
            assert!(left.windows(2).all(|w| w[0].0[1] < w[1].0[0]), "{left:?}");
        }
        assert!(of_both_kinds.iter().all(|n| *n > 10_000), "{of_both_kinds:?}");
    }

    #[test]
    fn the_offset_is_that_of_a_point_from_a_plane() {
        let c = Point::new(7.0, 3.0, 4.0);
        let travel = AxisTravel::of_offset("Y", [0.0, 1.0]);
        for k in 0..20 {
            let theta = 0.5 * f64::from(k);
            // The plane of the blade axis and the tool axes has the normal (0, sin θ, −cos θ).
            let psi = 4f64.atan2(3.0);
            assert!((offset_mm(&c, theta) - 5.0 * (theta - psi).sin()).abs() < 1e-12);
            assert!((travel.at(&c, theta) - offset_mm(&c, theta)).abs() < 1e-12);
        }
        // Never within reach, and always.
        assert!(AxisTravel::of_offset("Y", [6.0, 7.0]).left_of(&c, [0.0, 9.0]).is_empty());
        let all = AxisTravel::of_offset("Y", [-6.0, 6.0]).left_of(&c, [0.0, 9.0]);
        assert_eq!(all, vec![([0.0, 9.0], [true, true])]);
    }
}
