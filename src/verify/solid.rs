//! Signed distance to one frustum of the moving tool, and its least value over a triangle and a
//! move.
//!
//! A frustum is a convex solid of revolution, so its signed distance (negative inside) is a convex
//! function of the point, and equals the signed distance in the half plane (z, r) to the trapezoid
//! `z0 ≤ z ≤ z1`, `|r| ≤ r(z)`. A convex function lies above its tangent planes, so value `d` and
//! gradient `g` at one point `q` bound it everywhere: `d(p) ≥ d + g·(p − q)`.
//!
//! Seen from the tool, a part point `p` moves during a move. With the move's parameter `τ` from −1
//! to 1, half its translation `m`, half its turn `ω` about the axis `x` of its cone (through the
//! ball centre `c`), half its lean `β` about `n`, the unit vector across x and the tool axis, and
//! half the turn `φ` of the cone itself, a rotation vector:
//! ```text
//! p(τ) = p + τ w(p) + ε,   w(p) = −m − (ω x + β n + φ) × (p − c),   |ε| ≤ ½ Ω² (ρ + |m|) + Ω |m|,   Ω = |ω| + |β| + |φ|
//! ```
//! (Taylor; `ρ` is the distance of `p` from the blade axis through `c` where the tool turns about
//! that alone, else from `c`). Both bounds together are linear in `p` and in `τ`, so the least
//! value over a triangle or box and the whole move is read off its corners. Where the part slides
//! along the tool the bound is good to second order in the move.
//!
//! The tangent plane at the place of a triangle that is nearest to the frustum does not fall over
//! the triangle at all. That place is found by the algorithm of Gilbert, Johnson and Keerthi
//! (1988); what it finds is only where to look: with `h` the frustum's support function, any unit
//! vector `n` gives the bound `d(p) ≥ n·p − h(n)`. Where the tool is in the triangle there is no
//! such plane, and halving the triangle until its own share is within the tolerance finds the least
//! distance to that tolerance.

use parry3d_f64::math::{Pose, Vector as ParryVector};
use parry3d_f64::query::gjk::{self, CsoPoint, GJKResult, VoronoiSimplex};
use parry3d_f64::shape::SupportMap;

use crate::artifact::Stand;
use crate::geometry::{Point, Vector};
use crate::tool::Segment;

/// A frustum in the middle of a move.
#[derive(Clone, Copy, Debug)]
pub(super) struct Moving<'a> {
    /// The frustum.
    frustum: &'a Segment,
    /// Outward unit normal of its side in the half plane (z, r).
    side: [f64; 2],
    /// Length of its side there, mm.
    slant_mm: f64,
    motion: MidMotion,
}

/// How the tool moves, seen in the middle of the move.
#[derive(Clone, Copy, Debug)]
struct MidMotion {
    /// Ball centre, mm.
    centre: Point,
    /// Tool axis, unit, from tip to spindle.
    axis: Vector,
    /// Half the move of the ball centre, mm.
    half_move: Vector,
    /// `ω x + β n + φ` of the module's page, rad.
    half_turn: Vector,
    /// `Ω` there, rad.
    most_turn: f64,
    /// Whether the tool turns about the blade axis alone.
    about_the_blade: bool,
}

impl<'a> Moving<'a> {
    /// On the straight move from a stand to another, about a share of the way and so far to both
    /// sides of it.
    pub fn between(frustum: &'a Segment, from: &Stand, to: &Stand, [mid, half]: [f64; 2]) -> Self {
        let at = from.towards(to, mid);
        let (about, axis) = (at.cone.axis, at.axis());
        let turn = (to.theta - from.theta) * half;
        let lean = (to.cone.lean_rad - from.cone.lean_rad) * half;
        let frame = from.cone.rotation_to(&to.cone) * half;
        // Turning about a × x brings the axis a towards x.
        let leaning = axis.cross(&about).try_normalize(1e-12).unwrap_or_else(Vector::zeros) * lean;
        let motion = MidMotion {
            centre: at.centre,
            axis,
            half_move: (to.centre - from.centre) * half,
            half_turn: about * turn + frame + leaning,
            most_turn: turn.abs() + lean.abs() + frame.norm(),
            about_the_blade: lean == 0.0 && about == Vector::x() && frame == Vector::zeros(),
        };
        Self::of(frustum, motion)
    }

    fn of(frustum: &'a Segment, motion: MidMotion) -> Self {
        let (dz, dr) = (frustum.z1 - frustum.z0, frustum.r1 - frustum.r0);
        let slant_mm = (dz * dz + dr * dr).sqrt();
        Moving { frustum, side: [-dr / slant_mm, dz / slant_mm], slant_mm, motion }
    }

    /// Another frustum of the same tool.
    pub fn with(&self, frustum: &'a Segment) -> Self {
        Self::of(frustum, self.motion)
    }
}

impl Moving<'_> {
    /// Signed distance of `p` in the middle of the move, mm, and its gradient (unit length, save at
    /// kinks where it is one of the subgradients).
    pub fn signed(&self, p: &Point) -> (f64, Vector) {
        let axis = &self.motion.axis;
        let v = p - self.motion.centre;
        let z = v.dot(axis);
        let across = v - axis * z;
        let r = across.norm();
        let out = if r > 1e-12 { across / r } else { any_across(axis) };
        let (d, [gz, gr]) = self.trapezoid(z, r);
        (d, axis * gz + out * gr)
    }

    /// Signed distance of (z, r), `r ≥ 0`, to the trapezoid and its gradient (d/dz, d/dr).
    fn trapezoid(&self, z: f64, r: f64) -> (f64, [f64; 2]) {
        let (s, n) = (self.frustum, self.side);
        // Over the side, from its lower end on, and across it.
        let (w, e) = ([z - s.z0, r - s.r0], [n[1], -n[0]]);
        let (along, side) = (w[0] * e[0] + w[1] * e[1], w[0] * n[0] + w[1] * n[1]);
        let (below, above) = (s.z0 - z, z - s.z1);
        if side <= 0.0 && below <= 0.0 && above <= 0.0 {
            // Inside: the nearest of the three lines.
            return if side >= below && side >= above {
                (side, n)
            } else if below >= above {
                (below, [-1.0, 0.0])
            } else {
                (above, [1.0, 0.0])
            };
        }
        // Outside: over the side, over a lid, or about one of the two edges between them.
        if side > 0.0 && (0.0..=self.slant_mm).contains(&along) {
            return (side, n);
        }
        if below > 0.0 && r <= s.r0 {
            return (below, [-1.0, 0.0]);
        }
        if above > 0.0 && r <= s.r1 {
            return (above, [1.0, 0.0]);
        }
        let far = [z - s.z1, r - s.r1];
        let (low2, high2) = (w[0] * w[0] + w[1] * w[1], far[0] * far[0] + far[1] * far[1]);
        let (edge, d2) = if low2 < high2 { (w, low2) } else { (far, high2) };
        let d = d2.sqrt();
        (d, if d > 1e-12 { [edge[0] / d, edge[1] / d] } else { n })
    }

    /// `w(p)` of the module's page.
    fn drift(&self, p: &Point) -> Vector {
        (p - self.motion.centre).cross(&self.motion.half_turn) - self.motion.half_move
    }

    /// How far a point at `v` from the ball centre is from what it turns about, `v` taken without
    /// signs.
    fn off_the_axis(&self, v: &Vector) -> f64 {
        if self.motion.about_the_blade { (v.y * v.y + v.z * v.z).sqrt() } else { v.norm() }
    }

    /// Bound on `|ε|` of the module's page for points up to `rho` from the axis of the turn.
    fn remainder(&self, rho: f64) -> f64 {
        let (m, turn) = (self.motion.half_move.norm(), self.motion.most_turn);
        0.5 * turn * turn * (rho + m) + turn * m
    }

    /// Lower bound of the distance over a box given by middle and half sides, and over the whole
    /// move.
    pub fn bound_over_box(&self, middle: &Point, half: &Vector) -> f64 {
        let (d, g) = self.signed(middle);
        let v = middle - self.motion.centre;
        let rho = self.off_the_axis(&(v.abs() + half));
        let along = g.dot(&self.drift(middle));
        // g·w(p) changes with p by −(g × (ω x + β n + φ))·(p − middle).
        let tilt = g.cross(&self.motion.half_turn);
        let side = |tau: f64| tau * along - (g - tilt * tau).abs().dot(half);
        d + side(1.0).min(side(-1.0)) - self.remainder(rho)
    }

    /// Looks over a triangle for distances below `cap_mm` anywhere on the move. The first value is
    /// a lower bound for the triangle and the whole move, or `cap_mm` where that is less; the
    /// second the least distance below `cap_mm` seen in the middle of the move, with its point.
    /// Points of the triangle are resolved to the tolerance, or to the share that the move itself
    /// has in the bound: a shorter move will look again.
    pub fn least_over_triangle(
        &self,
        corners: &[Point; 3],
        cap_mm: f64,
        tolerance_mm: f64,
    ) -> (f64, Option<(f64, Point)>) {
        let rho = corners.iter().map(|c| self.off_the_axis(&(c - self.motion.centre))).fold(0.0, f64::max);
        let remainder = self.remainder(rho);
        // What has been seen closes pieces; bounds do not, else they would creep down from piece to
        // piece.
        let (mut threshold, mut lower) = (cap_mm, cap_mm);
        let mut seen: Option<(f64, Point)> = None;
        // Most triangles are done at once, and take no memory for pieces.
        let (mut next, mut open, mut whole) = (Some(self.tangent_over(*corners)), Vec::new(), true);
        while let Some(t) = next.take().or_else(|| open.pop()) {
            if t.value < threshold {
                (threshold, seen) = (t.value, Some((t.value, t.middle)));
            }
            let bound = t.value + t.moved - remainder;
            let told_apart = -t.still <= tolerance_mm.max(0.5 * (t.still - t.moved) + remainder);
            if bound >= threshold {
                continue;
            }
            if told_apart || seen.is_some_and(|s| bound >= s.0 - tolerance_mm) {
                lower = lower.min(bound);
            } else if whole {
                whole = false;
                // Beyond this the triangle is too far off, however the tool moves.
                let reach = threshold + (t.still - t.moved) + remainder;
                next = self.nearest_over(t.corners, reach).or(Some(t));
            } else {
                let [one, two] = halves(&t.corners).map(|c| self.tangent_over(c));
                // The nearer half is looked at first: what it finds may close the other.
                if one.value + one.moved < two.value + two.moved {
                    open.extend([two, one])
                } else {
                    open.extend([one, two])
                }
            }
        }
        (lower.min(threshold), seen)
    }

    /// The plane between the frustum in the middle of the move and a triangle where the two are
    /// nearest, or where they are farther apart than `reach_mm`; `None` where they are not apart.
    fn nearest_over(&self, corners: [Point; 3], reach_mm: f64) -> Option<Tangent> {
        let (one, two) = (FrustumSupport(self), TriangleSupport(&corners, self.motion.centre));
        let here = Pose::identity();
        let mut simplex = VoronoiSimplex::new();
        simplex.reset(CsoPoint::from_shapes(&here, &one, &two, ParryVector::X));
        let (near, direction) =
            match gjk::closest_points(&here, &one, &two, reach_mm.min(FARTHEST_MM), true, &mut simplex) {
                GJKResult::ClosestPoints(_, on_triangle, direction) => (on_triangle, direction),
                GJKResult::NoIntersection(direction) => (two.local_support_point(-direction), direction),
                GJKResult::Intersection | GJKResult::Proximity(_) => return None,
            };
        let middle = self.motion.centre + vector(near);
        let n = vector(direction).try_normalize(0.5)?;
        let frustum = self.motion.centre + self.farthest_along(&n);
        let value = self.signed(&middle).0;
        Some(self.plane_over(corners, (middle, value), &n, |c| n.dot(&(c - frustum)) - value))
    }

    /// The place of the frustum that is farthest along a vector, from the ball centre, mm.
    fn farthest_along(&self, n: &Vector) -> Vector {
        let (s, axis) = (self.frustum, &self.motion.axis);
        let along = n.dot(axis);
        let across = n - axis * along;
        let length = across.norm();
        let out = if length > 1e-12 { across / length } else { Vector::zeros() };
        let low = s.z0 * along + s.r0 * length >= s.z1 * along + s.r1 * length;
        let (z, r) = if low { (s.z0, s.r0) } else { (s.z1, s.r1) };
        axis * z + out * r
    }

    /// The tangent plane at the middle of a triangle, over the triangle and the move.
    fn tangent_over(&self, corners: [Point; 3]) -> Tangent {
        let middle = corners[0] + ((corners[1] - corners[0]) + (corners[2] - corners[0])) / 3.0;
        let (value, g) = self.signed(&middle);
        self.plane_over(corners, (middle, value), &g, |c| g.dot(&(c - middle)))
    }

    /// A plane with gradient `g`, whose height at a point is `over` that of the distance at
    /// `middle`.
    fn plane_over(
        &self,
        corners: [Point; 3],
        (middle, value): (Point, f64),
        g: &Vector,
        over: impl Fn(&Point) -> f64,
    ) -> Tangent {
        let (mut still, mut moved) = (f64::INFINITY, f64::INFINITY);
        for c in &corners {
            let (step, drift) = (over(c), g.dot(&self.drift(c)).abs());
            still = still.min(step);
            moved = moved.min(step - drift);
        }
        Tangent { corners, middle, value, still, moved }
    }
}

/// Distances beyond this are not looked for, mm.
const FARTHEST_MM: f64 = 1e6;

/// A frustum as the nearest places are looked for, seen from the ball centre.
struct FrustumSupport<'a>(&'a Moving<'a>);

/// A triangle as the nearest places are looked for, seen from that centre.
struct TriangleSupport<'a>(&'a [Point; 3], Point);

impl SupportMap for FrustumSupport<'_> {
    fn local_support_point(&self, direction: ParryVector) -> ParryVector {
        parry(&self.0.farthest_along(&vector(direction)))
    }
}

impl SupportMap for TriangleSupport<'_> {
    fn local_support_point(&self, direction: ParryVector) -> ParryVector {
        let n = vector(direction);
        let [a, b, c] = self.0.map(|c| c - self.1);
        let farther = |a: Vector, b: Vector| if n.dot(&a) >= n.dot(&b) { a } else { b };
        parry(&farther(farther(a, b), c))
    }
}

fn vector(v: ParryVector) -> Vector {
    Vector::new(v.x, v.y, v.z)
}

fn parry(v: &Vector) -> ParryVector {
    ParryVector::new(v.x, v.y, v.z)
}

/// A triangle with the distance at one of its places, and how far a plane that is nowhere over the
/// distance falls below that over the triangle alone (`still`), and over triangle and move
/// (`moved`).
struct Tangent {
    corners: [Point; 3],
    middle: Point,
    value: f64,
    still: f64,
    moved: f64,
}

/// A unit vector across a unit vector.
fn any_across(axis: &Vector) -> Vector {
    let other = if axis.x.abs() < 0.9 { Vector::x() } else { Vector::y() };
    axis.cross(&other).normalize()
}

/// Halves a triangle across its longest edge.
fn halves(c: &[Point; 3]) -> [[Point; 3]; 2] {
    let lengths = [(c[1] - c[0]).norm_squared(), (c[2] - c[1]).norm_squared(), (c[0] - c[2]).norm_squared()];
    let k = (0..3).fold(0, |best, i| if lengths[i] > lengths[best] { i } else { best });
    let (a, b, opposite) = (c[k], c[(k + 1) % 3], c[(k + 2) % 3]);
    let mid = a + (b - a) * 0.5;
    [[a, mid, opposite], [mid, b, opposite]]
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used)]
    use super::*;
    use crate::artifact::{Cone, Stand, ToolPart};
    use proptest::prelude::*;

    fn cone() -> Segment {
        Segment { part: ToolPart::Taper, z0: 1.0, z1: 6.0, r0: 2.0, r1: 3.0 }
    }
    fn point() -> impl Strategy<Value = Point> {
        [-8.0..8.0f64, -8.0..8.0f64, -8.0..8.0f64].prop_map(Point::from)
    }
    fn still(frustum: &Segment, axis: Vector) -> Moving<'_> {
        let motion = MidMotion {
            centre: Point::new(1.0, 0.0, 0.0),
            axis,
            half_move: Vector::zeros(),
            half_turn: Vector::zeros(),
            most_turn: 0.0,
            about_the_blade: true,
        };
        Moving::of(frustum, motion)
    }

    #[test]
    fn closed_forms_beside_over_and_inside_a_cylinder() {
        let s = Segment { part: ToolPart::Shank, z0: 0.0, z1: 10.0, r0: 3.0, r1: 3.0 };
        let solid = still(&s, Vector::z());
        let d = |x: f64, y: f64, z: f64| solid.signed(&Point::new(1.0 + x, y, z)).0;
        assert!((d(5.0, 0.0, 4.0) - 2.0).abs() < 1e-12);
        assert!((d(0.0, 0.0, 12.5) - 2.5).abs() < 1e-12);
        assert!((d(0.0, 6.0, -4.0) - 5.0).abs() < 1e-12);
        assert!((d(0.0, 2.5, 5.0) + 0.5).abs() < 1e-12);
        assert!((d(0.0, 0.0, 1.0) + 1.0).abs() < 1e-12);
    }

    proptest! {
        #[test]
        fn distance_is_convex_and_its_gradient_supports_it(p in point(), q in point(), axis in point()) {
            prop_assume!(axis.coords.norm() > 0.1);
            let s = cone();
            let solid = still(&s, axis.coords.normalize());
            let (d, g) = solid.signed(&p);
            prop_assert!(g.norm() < 1.0 + 1e-9);
            prop_assert!(solid.signed(&q).0 >= d + g.dot(&(q - p)) - 1e-9);
        }
        #[test]
        fn least_over_a_triangle_against_a_dense_grid(a in point(), b in point(), c in point()) {
            let s = cone();
            let solid = still(&s, Vector::z());
            let n = 60;
            let grid = (0..=n).flat_map(|i| (0..=n - i).map(move |j| (i, j))).map(|(i, j)| {
                let p = a + (b - a) * (f64::from(i) / f64::from(n)) + (c - a) * (f64::from(j) / f64::from(n));
                solid.signed(&p).0
            });
            let dense = grid.fold(f64::INFINITY, f64::min);
            let (lower, seen) = solid.least_over_triangle(&[a, b, c], f64::INFINITY, 1e-4);
            let (d, at) = seen.unwrap();
            prop_assert!(lower <= dense + 1e-9 && dense - lower < 0.5, "{lower} {dense}");
            prop_assert!(d - lower < 2e-4, "{lower} {d}");
            prop_assert!((solid.signed(&at).0 - d).abs() < 1e-12);
            prop_assert_eq!(solid.least_over_triangle(&[a, b, c], d - 0.01, 1e-4), (d - 0.01, None));
        }
        #[test]
        fn bounds_hold_over_the_whole_move(
            a in point(), b in point(), c in point(), m in point(), turn in -0.2..0.2f64, theta in 0.0..6.0f64,
            lean in prop_oneof![Just(0.0), -0.2..0.2f64], about in point(), frame in prop_oneof![Just(Point::origin()), point()],
        ) {
            let s = cone();
            let end = |tau: f64| {
                let by = nalgebra::UnitQuaternion::from_scaled_axis(frame.coords * (0.02 * tau));
                let still = Cone::new(about.coords, Vector::new(0.3, 1.0, -0.2), 0.3 + lean * tau)?;
                let cone = Cone { axis: by * still.axis, reference: by * still.reference, ..still };
                Some(Stand { centre: Point::origin() + m.coords * (0.1 * tau), cone, theta: theta + turn * tau })
            };
            let Some((from, to)) = end(-1.0).zip(end(1.0)) else { return Ok(()) };
            let pose = |tau: f64| Moving::between(&s, &from, &to, [0.5 + 0.5 * tau, 0.5]);
            let solid = pose(0.0);
            let n = 12;
            let grid = (0..=n).flat_map(|i| (0..=n - i).map(move |j| (i, j))).map(|(i, j)| {
                a + (b - a) * (f64::from(i) / f64::from(n)) + (c - a) * (f64::from(j) / f64::from(n))
            });
            let points: Vec<Point> = grid.collect();
            let over = |p: &Point| (-10..=10).map(|k| pose(f64::from(k) / 10.0).signed(p).0).fold(f64::INFINITY, f64::min);
            let dense = points.iter().map(over).fold(f64::INFINITY, f64::min);
            let (lower, _) = solid.least_over_triangle(&[a, b, c], f64::INFINITY, 1e-3);
            prop_assert!(lower <= dense + 1e-9, "{lower} {dense}");
            let (lo, hi) = (a.inf(&b).inf(&c), a.sup(&b).sup(&c));
            let half = (hi - lo) * 0.5;
            prop_assert!(solid.bound_over_box(&(lo + half), &half) <= dense + 1e-9);
        }
    }
}
