//! Heights of a blade that stands on a hub which turns from along the rotor axis to across it, as
//! those of impellers do.
//!
//! In the half-plane through the rotor axis the hub and the tips of the blades are two curves.
//! Lines from places of the one to places of the other lead from the hub to the tip. The share of
//! such a line is the height of a place, the same all round the rotor axis. Surfaces of one height
//! lie like nested hubs, and a blade's section by one of them is an airfoil.
//!
//! Both curves are uniform cubic B-splines over the same parameter, so that heights are smooth.
//! They only say what a height is: where the part is, the part itself says.

use nalgebra::{DMatrix, Matrix2, Vector2};

use crate::geometry::{Point, Vector};

/// Control points of a contour.
const POLES: usize = 16;
/// Places of a contour at which one that is offset is sampled.
const OFFSET_PLACES: usize = 96;
/// Lines from hub to tip that are tried for the one through a place.
const LINES: usize = 24;
/// They go on beyond both ends by this share.
const BEYOND: f64 = 0.25;
/// Beyond both ends lines stop to turn over this share of a contour.
const SOON: f64 = 0.05;
/// The edges of a blade are within this share of its length.
const AT_END: f64 = 0.1;
/// Newton steps for the line through a place.
const STEPS: usize = 20;
/// The line is known to this share of a contour.
const EXACT: f64 = 1e-12;

/// A curve in the half-plane through the rotor axis: along the axis, radius; mm.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Contour([[f64; 2]; POLES]);

impl Contour {
    /// The curve nearest to points at parameters within [0, 1], by least squares. `None` where they
    /// do not say it.
    fn fitted(places: &[(f64, [f64; 2])]) -> Option<Self> {
        let mut normal = DMatrix::<f64>::zeros(POLES, POLES);
        let mut right = DMatrix::<f64>::zeros(POLES, 2);
        for (t, p) in places {
            let (first, weights, _) = basis(*t);
            for (i, a) in weights.iter().enumerate() {
                for (j, b) in weights.iter().enumerate() {
                    normal[(first + i, first + j)] += a * b;
                }
                for (k, x) in p.iter().enumerate() {
                    right[(first + i, k)] += a * x;
                }
            }
        }
        // A little stiffness settles poles that hardly any place says.
        let stiffness = 1e-9 * places.len() as f64;
        for k in 1..POLES - 1 {
            for (i, a) in [(k - 1, 1.0), (k, -2.0), (k + 1, 1.0)] {
                for (j, b) in [(k - 1, 1.0), (k, -2.0), (k + 1, 1.0)] {
                    normal[(i, j)] += stiffness * a * b;
                }
            }
        }
        let poles = normal.cholesky()?.solve(&right);
        let out = Contour(std::array::from_fn(|k| [poles[(k, 0)], poles[(k, 1)]]));
        out.0.iter().flatten().all(|x| x.is_finite()).then_some(out)
    }

    /// Place and derivative at a parameter within [0, 1].
    fn at(&self, t: f64) -> [Vector2<f64>; 2] {
        let (first, weights, slopes) = basis(t);
        [weights, slopes].map(|w| (0..4).map(|k| Vector2::from(self.0[first + k]) * w[k]).sum())
    }
}

/// First of the four poles that say a place at a parameter within [0, 1], their weights, and those
/// of the derivative.
fn basis(t: f64) -> (usize, [f64; 4], [f64; 4]) {
    let spans = (POLES - 3) as f64;
    let first = ((t * spans) as usize).min(POLES - 4);
    let u = t * spans - first as f64;
    let v = 1.0 - u;
    let weights = [
        v * v * v / 6.0,
        (3.0 * u * u * u - 6.0 * u * u + 4.0) / 6.0,
        (3.0 * v * v * v - 6.0 * v * v + 4.0) / 6.0,
        u * u * u / 6.0,
    ];
    let slopes = [-0.5 * v * v, 0.5 * u * (3.0 * u - 4.0), -0.5 * v * (3.0 * v - 4.0), 0.5 * u * u];
    (first, weights, slopes.map(|x| x * spans))
}

/// Contours of hub and tips about a rotor axis.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Meridian {
    axis: Vector,
    origin: Point,
    hub: Contour,
    tip: Contour,
    /// Heights on the one and on the other, mm.
    heights_mm: [f64; 2],
}

/// A place in the half-plane through the rotor axis.
struct Place {
    /// Along the contours, from one end to the other: 0 to 1.
    along: f64,
    /// From hub to tip: 0 to 1.
    share: f64,
    /// Derivative of the share by place along the axis and radius, 1/mm.
    gradient: Vector2<f64>,
}

impl Meridian {
    /// From points of hub and tips, each in order along the flow: along the axis from its origin,
    /// radius; mm. `axis` is a unit vector. `None` where the points say no two curves apart.
    pub fn new(axis: Vector, origin: Point, hub: &[[f64; 2]], tip: &[[f64; 2]]) -> Option<Self> {
        let [hub, tip] = [hub, tip].map(|points| Contour::fitted(&by_length(points)?));
        let meridian = Meridian { axis, origin, hub: hub?, tip: tip?, heights_mm: [0.0; 2] };
        let tip_mm = meridian.mean_mm()?;
        Some(Meridian { heights_mm: [0.0, tip_mm], ..meridian })
    }

    /// Foot and head of the line from hub to tip at a parameter, with their derivatives. Beyond
    /// both ends lines soon move on side by side, so that none crosses another.
    fn line(&self, t: f64) -> [[Vector2<f64>; 2]; 2] {
        let within = t.clamp(0.0, 1.0);
        let ends = [self.hub.at(within), self.tip.at(within)];
        let beyond = t - within;
        if beyond == 0.0 {
            return ends;
        }
        let common = 0.5 * (ends[0][1] + ends[1][1]);
        let own = (-beyond.abs() / SOON).exp();
        ends.map(|[place, slope]| {
            let apart = slope - common;
            let way = SOON * (1.0 - own) * beyond.signum();
            [place + common * beyond + apart * way, common + apart * own]
        })
    }

    /// Mean length of the lines from hub to tip, mm. `None` where they cross.
    fn mean_mm(&self) -> Option<f64> {
        let lines = (0..=LINES).map(|k| {
            let t = k as f64 / LINES as f64;
            let ([foot, along], [head, beyond]) = (self.hub.at(t), self.tip.at(t));
            let up = head - foot;
            // Which way round the contours run does not matter.
            (up.norm(), [along, beyond].map(|d| d.x * up.y - d.y * up.x))
        });
        let lines: Vec<_> = lines.collect();
        let sense = lines[LINES / 2].1[0].signum();
        // Towards an end both contours may come together.
        let crosses = lines[1..LINES].iter().any(|(_, turns)| turns.iter().any(|t| t * sense <= 0.0));
        let height_mm = lines.iter().map(|l| l.0).sum::<f64>() / lines.len() as f64;
        (!crosses && height_mm > 0.0).then_some(height_mm)
    }

    /// Heights of the centres of balls of a radius, mm: that radius where a ball is on the hub.
    /// `None` where none has room under the tips.
    pub fn for_ball(&self, radius_mm: f64) -> Option<Self> {
        let offset = |k: usize| {
            let t = k as f64 / OFFSET_PLACES as f64;
            let [foot, along] = self.hub.at(t);
            let up = self.tip.at(t)[0] - foot;
            let normal = Vector2::new(-along.y, along.x).normalize();
            let out = foot + normal * (radius_mm * normal.dot(&up).signum());
            (t, [out.x, out.y])
        };
        let hub = Contour::fitted(&(0..=OFFSET_PLACES).map(offset).collect::<Vec<_>>())?;
        let offset = Meridian { hub, heights_mm: [radius_mm, self.heights_mm[1]], ..*self };
        (radius_mm < self.heights_mm[1] && offset.mean_mm().is_some()).then_some(offset)
    }

    /// Mean height of the tips over the hub, mm: the height of the tips.
    pub fn tip_mm(&self) -> f64 {
        self.heights_mm[1]
    }

    /// The height at a share of the line from hub to tip, mm.
    fn height_at_mm(&self, share: f64) -> f64 {
        let [low, high] = self.heights_mm;
        low + (high - low) * share
    }

    /// The share of the line from hub to tip at a height, mm.
    fn share_at(&self, height_mm: f64) -> f64 {
        let [low, high] = self.heights_mm;
        (height_mm - low) / (high - low)
    }

    /// Along the axis and radius of a point, and the unit vector away from the axis there.
    fn seen(&self, p: &Point) -> (Vector2<f64>, Vector) {
        let v = p - self.origin;
        let along_mm = v.dot(&self.axis);
        let out = v - self.axis * along_mm;
        let radius_mm = out.norm();
        let out = if radius_mm > 1e-9 {
            out / radius_mm
        } else {
            self.axis.cross(&Vector::ith(self.axis.imin(), 1.0)).normalize()
        };
        (Vector2::new(along_mm, radius_mm), out)
    }

    /// Place on the line from hub to tip through a point of the half-plane.
    fn place(&self, q: &Vector2<f64>) -> Place {
        let line = |t: f64| {
            let [[foot, along], [head, beyond]] = self.line(t);
            (foot, head - foot, along, beyond)
        };
        let nearest = |t: f64| {
            let (foot, up, ..) = line(t);
            let share = ((q - foot).dot(&up) / up.norm_squared().max(1e-12)).clamp(-1.0, 2.0);
            ((q - foot - up * share).norm_squared(), t, share)
        };
        let tries = (0..=LINES).map(|k| nearest(-BEYOND + (1.0 + 2.0 * BEYOND) * k as f64 / LINES as f64));
        let (_, mut t, mut share) = tries.fold((f64::INFINITY, 0.0, 0.0), |a, b| if b.0 < a.0 { b } else { a });
        let mut gradient = Vector2::zeros();
        for _ in 0..STEPS {
            let (foot, up, along, beyond) = line(t);
            let by_t = along * (1.0 - share) + beyond * share;
            let Some(inverse) = Matrix2::from_columns(&[by_t, up]).try_inverse() else { break };
            gradient = inverse.row(1).transpose();
            let step = inverse * (q - foot - up * share);
            // A step beyond half a span of the curves is not to be trusted.
            let short = (0.5 / (POLES as f64 * step.x.abs()).max(0.5)).min(1.0);
            (t, share) = (t + step.x * short, share + step.y * short);
            if step.x.abs() < EXACT && step.y.abs() < EXACT {
                break;
            }
        }
        Place { along: t, share, gradient }
    }

    /// Height of a point, mm.
    pub fn height_mm(&self, p: &Point) -> f64 {
        self.height_at_mm(self.place(&self.seen(p).0).share)
    }

    /// Place along the contours of a point, from one end of the blade to the other: 0 to 1.
    pub fn along(&self, p: &Point) -> f64 {
        self.place(&self.seen(p).0).along
    }

    /// Directions at a point, unit: towards greater height, round the rotor axis, and across both.
    pub fn directions(&self, p: &Point) -> [Vector; 3] {
        let (q, out) = self.seen(p);
        self.directions_at(&self.place(&q), &out)
    }

    /// The directions at a place, where `out` leads away from the axis.
    fn directions_at(&self, place: &Place, out: &Vector) -> [Vector; 3] {
        let round = self.axis.cross(out);
        let up = (self.axis * place.gradient.x + out * place.gradient.y).try_normalize(1e-12).unwrap_or(*out);
        [up, round, up.cross(&round)]
    }

    /// The point at another height, mm, straight along the line from hub to tip.
    pub fn at(&self, height_mm: f64, p: &Point) -> Point {
        let (q, out) = self.seen(p);
        let place = self.place(&q);
        let [[foot, _], [head, _]] = self.line(place.along);
        let up = head - foot;
        let by = up * (self.share_at(height_mm) - place.share);
        p + self.axis * by.x + out * by.y
    }

    /// The point at a place along the contours, a height, mm, and an angle about the axis from a
    /// direction across it, rad.
    pub fn point(&self, along: f64, height_mm: f64, from: &Vector, angle_rad: f64) -> Point {
        let share = self.share_at(height_mm);
        let q = self.hub.at(along)[0] * (1.0 - share) + self.tip.at(along)[0] * share;
        let (s, c) = angle_rad.sin_cos();
        self.origin + self.axis * q.x + (from * c + self.axis.cross(from) * s) * q.y
    }

    /// Whether surface with this place and normal is the blunt edge of a blade: at one end, between
    /// hub and tips, and facing along the flow rather than towards either.
    pub fn is_edge(&self, p: &Point, normal: &Vector) -> bool {
        let (q, out) = self.seen(p);
        let place = self.place(&q);
        let [up, _, across] = self.directions_at(&place, &out).map(|d| d.dot(normal).abs());
        let amid = AT_END..1.0 - AT_END;
        across > up && !amid.contains(&place.along) && (0.0..1.0).contains(&place.share)
    }

    /// Unit vector away from the axis at a point.
    pub fn out(&self, p: &Point) -> Vector {
        self.seen(p).1
    }

    /// That of the mirror image across z = 0.
    #[must_use]
    pub fn mirrored(&self) -> Self {
        let Meridian { axis, origin, .. } = self;
        let axis = Vector::new(axis.x, axis.y, -axis.z);
        Meridian { axis, origin: Point::new(origin.x, origin.y, -origin.z), ..*self }
    }

    /// Points of the contour of the hub (0) or of the tips (1): along the axis, radius; mm.
    pub fn contour(&self, which: usize, count: usize) -> Vec<[f64; 2]> {
        let contour = if which == 0 { &self.hub } else { &self.tip };
        (0..count).map(|k| contour.at(k as f64 / (count.max(2) - 1) as f64)[0].into()).collect()
    }
}

/// Points with their share of the length of the polyline through them. `None` for fewer than two.
fn by_length(points: &[[f64; 2]]) -> Option<Vec<(f64, [f64; 2])>> {
    let mut length_mm = vec![0.0];
    for w in points.windows(2) {
        let last = length_mm[length_mm.len() - 1];
        length_mm.push(last + (w[1][0] - w[0][0]).hypot(w[1][1] - w[0][1]));
    }
    let whole = *length_mm.last().filter(|l| **l > 0.0)?;
    Some(length_mm.iter().map(|l| l / whole).zip(points.iter().copied()).collect())
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used)]
    use super::*;

    /// Quarters of circles of these radii about one place; between them the height is the distance
    /// from the hub.
    const RADII: [f64; 2] = [40.0, 24.0];
    const CENTRE: [f64; 2] = [70.0, 80.0];

    fn quarter(radius: f64) -> Vec<[f64; 2]> {
        let at = |k: usize| (std::f64::consts::FRAC_PI_2 * k as f64 / 50.0).sin_cos();
        (0..=50).map(at).map(|(s, c)| [CENTRE[0] - radius * s, CENTRE[1] - radius * c]).collect()
    }

    fn meridian() -> Meridian {
        let axis = Vector::new(0.0, 0.6, 0.8);
        Meridian::new(axis, Point::new(1.0, 2.0, 3.0), &quarter(RADII[0]), &quarter(RADII[1])).unwrap()
    }

    /// A point at an angle from across, a radius about the centre of the quarters, and an angle
    /// about the rotor axis.
    fn point(m: &Meridian, from_across: f64, radius: f64, round: f64) -> Point {
        let (s, c) = from_across.sin_cos();
        let (along, away) = (CENTRE[0] - radius * s, CENTRE[1] - radius * c);
        let (s, c) = round.sin_cos();
        let first = Vector::x();
        m.origin + m.axis * along + (first * c + m.axis.cross(&first) * s) * away
    }

    #[test]
    fn heights_between_round_contours_are_distances_from_the_hub() {
        let m = meridian();
        assert!((m.tip_mm() - 16.0).abs() < 1e-3, "{}", m.tip_mm());
        let ball = m.for_ball(3.0).unwrap();
        for k in 0..60 {
            let share = f64::from(k) / 59.0;
            let p = point(&m, 0.02 + 1.53 * share, 40.0 - 16.0 * (0.5 + 0.5 * (7.0 * share).sin()), 11.0 * share);
            let height = 16.0 * (0.5 + 0.5 * (7.0 * share).sin());
            assert!((m.height_mm(&p) - height).abs() < 1e-3, "{} {height}", m.height_mm(&p));
            assert!((ball.height_mm(&p) - height).abs() < 2e-3, "{} {height}", ball.height_mm(&p));
            let [up, round, across] = m.directions(&p);
            assert!((up.cross(&round) - across).norm() < 1e-12 && up.dot(&m.axis.cross(&m.out(&p))).abs() < 1e-12);
            // Along the line through the place, and back.
            let q = m.at(height + 2.0, &p);
            let off = [m.height_mm(&q) - m.height_mm(&p), (m.at(m.height_mm(&p), &q) - p).norm()];
            assert!((off[0] - (height + 2.0 - m.height_mm(&p))).abs() < 1e-9 && off[1] < 1e-9, "{off:?}");
            assert!(((q - p).norm() - 2.0).abs() < 1e-2 && (q - p).normalize().dot(&up) > 0.999);
            let along = m.along(&p);
            assert!((along - (0.02 + 1.53 * share) / std::f64::consts::FRAC_PI_2).abs() < 1e-2, "{along}");
        }
    }

    /// Beyond the ends of the contours heights go on without a jump, and lines do not cross.
    #[test]
    fn heights_go_on_beyond_both_ends() {
        let m = meridian();
        for (t, sign) in [(0.0, -1.0), (1.0, 1.0)] {
            let from = m.out(&point(&m, 0.5, 30.0, 0.3));
            let mut last = m.point(t, 8.0, &from, 0.0);
            for k in 1..=20 {
                let p = m.point(t, 8.0, &from, 0.0) + m.directions(&last)[2] * (-sign * 0.25 * f64::from(k));
                assert!((m.height_mm(&p) - 8.0).abs() < 2.0, "{} at {k}", m.height_mm(&p));
                assert!((m.along(&p) - t) * sign >= -1e-9, "{}", m.along(&p));
                last = p;
            }
        }
    }

    /// Blunt edges face along the flow at either end; hub, tips, sides and what lies amid do not.
    #[test]
    fn edges_face_along_the_flow_at_the_ends() {
        let m = meridian();
        let from = m.out(&point(&m, 0.5, 30.0, 0.3));
        for t in [0.0, 0.5, 1.0] {
            let p = m.point(t, 8.0, &from, 0.0);
            let [up, round, across] = m.directions(&p);
            let is_end = t != 0.5;
            let aslant = (across + up * 0.4 + round * 0.3).normalize();
            for (n, is_edge) in [(across, is_end), (-across, is_end), (aslant, is_end), (up, false), (-up, false)] {
                assert_eq!(m.is_edge(&p, &n), is_edge, "{t} {n}");
            }
            // Ends of hub and shroud beyond the blade are none.
            for height in [-1.0, 17.0] {
                assert!(!m.is_edge(&m.point(t, height, &from, 0.0), &across), "{t} {height}");
            }
        }
    }

    #[test]
    fn contours_that_say_nothing_are_refused() {
        let hub = quarter(RADII[0]);
        let new = |hub: &[[f64; 2]], tip: &[[f64; 2]]| Meridian::new(Vector::z(), Point::origin(), hub, tip);
        assert!(new(&hub, &hub[..1]).is_none() && new(&[], &hub).is_none());
        // Lines from the one to the other cross.
        let backwards: Vec<[f64; 2]> = quarter(RADII[1]).into_iter().rev().collect();
        assert!(new(&hub, &backwards).is_none());
        assert!(new(&[[0.0, f64::NAN]; 9], &hub).is_none());
        assert!(meridian().for_ball(16.5).is_none());
    }
}
