//! Lower bounds of the room between the tool, turned through whole intervals of θ, and nodes of a
//! tree, in the frame of the place's cone, seen from the ball centre.

use std::f64::consts::{PI, TAU};

use crate::geometry::{Point, Vector};

use super::clear;
use super::profile::{Frustum, ToolProfile};

/// Steps after which a walk over angles is given up.
const WALK: usize = 48;
/// Room that is none, mm.
const NONE_MM: f64 = 1e-9;

/// A free interval, absolute angles, with the tool axes at its ends.
#[derive(Clone, Copy, Debug)]
pub(super) struct FreeSweep {
    pub lo: f64,
    pub hi: f64,
    pub axes: [Vector; 2],
    /// (cos, sin) of the ends.
    pub ends: [(f64, f64); 2],
}

/// How much room a node has.
#[derive(Clone, Copy, Debug)]
pub(super) struct NodeRoom {
    pub mm: f64,
    /// What a radian of growth of the intervals may cost, mm.
    pub across: f64,
    /// What a radian by which the cone turns may cost, mm.
    pub reach: f64,
    /// At both ends of the one interval, where that decides.
    pub facets: Option<[Facet; 2]>,
}

impl NodeRoom {
    pub fn new(mm: f64, across: f64, reach: f64) -> Self {
        NodeRoom { mm, across, reach, facets: None }
    }

    /// Of what is out of the tool's reach however it turns, or not clear at all.
    pub fn anyhow(mm: f64) -> Self {
        NodeRoom::new(mm, 0.0, 0.0)
    }
}

/// The tool axis at θ; `b` is (sin B, cos B).
pub(super) fn axis(b: (f64, f64), theta: f64) -> Vector {
    let (sin, cos) = theta.sin_cos();
    Vector::new(b.0, b.1 * cos, b.1 * sin)
}

impl FreeSweep {
    pub fn new(lo: f64, hi: f64, b: (f64, f64)) -> Self {
        let ends = [lo, hi].map(|t| {
            let (sin, cos) = t.sin_cos();
            (cos, sin)
        });
        FreeSweep { lo, hi, axes: ends.map(|(cos, sin)| Vector::new(b.0, b.1 * cos, b.1 * sin)), ends }
    }

    /// A direction of space in the frame of the tool at the end `k`.
    pub fn tool_slope(&self, k: usize, s: &Vector) -> Vector {
        let (along, across) = self.seen(k, s);
        Vector::new(s.x, along, across)
    }

    /// What a vector has along the direction of the end `k` about the blade axis, and across it.
    fn seen(&self, k: usize, v: &Vector) -> (f64, f64) {
        let (cos, sin) = self.ends[k];
        (cos * v.y + sin * v.z, cos * v.z - sin * v.y)
    }

    /// `v` in the frames of the tool at both ends.
    fn in_tools(&self, v: &Vector) -> [Vector; 2] {
        [self.tool_slope(0, v), self.tool_slope(1, v)]
    }

    /// The azimuths of all points within `radius` of `v` are outside the interval.
    pub fn is_beside(&self, v: &Vector, radius: f64) -> bool {
        let [at_lo, at_hi] = self.in_tools(v);
        let (before, after) = (at_lo.z < -radius, at_hi.z > radius);
        let width = self.hi - self.lo;
        if width > PI {
            return width < TAU && before && after;
        }
        // An angle of the interval is within a quarter turn of one of its ends.
        before || after || (at_lo.y < -radius && at_hi.y < -radius)
    }

    /// As [`Self::is_beside`] for the convex hull of some points, as `seen` has them; never said of
    /// an interval over half a turn.
    pub fn have_beside(&self, points: &[Point], seen: impl Fn(&Point) -> Vector) -> bool {
        let (mut before, mut after, mut behind) = (true, true, true);
        for point in points {
            let [lo, hi] = self.in_tools(&seen(point));
            before &= lo.z < 0.0;
            after &= hi.z > 0.0;
            behind &= lo.y < 0.0 && hi.y < 0.0;
            if !(before || after || behind) {
                return false;
            }
        }
        !points.is_empty() && self.hi - self.lo <= PI
    }
}

/// Margin of a point from the tool about `axis`, mm.
pub(super) fn margin(profile: &ToolProfile, axis: &Vector, v: &Vector) -> f64 {
    let (z, r) = height_and_radius(axis, v);
    least_of(profile, z, r)
}

/// Margin of points at the height `z` and the radius `r`, mm.
fn least_of(profile: &ToolProfile, z: f64, r: f64) -> f64 {
    profile
        .frusta
        .iter()
        .fold(f64::INFINITY, |least, f| if f.above(z) >= least { least } else { least.min(f.margin(z, r).0) })
}

/// A plane that bounds a part's margin from below, in space.
#[derive(Clone, Copy, Debug)]
pub(super) struct Flat {
    /// Over a whole node, mm.
    pub least: f64,
    /// At the middle of the node's box, mm. With the slope it bounds what is left of the margin
    /// wherever node and tool move.
    pub middle: f64,
    pub slope: Vector,
}

/// Lower bounds of the margin over a node at one axis.
#[derive(Clone, Copy, Debug)]
pub(super) struct Facet {
    /// Of the nearest part.
    pub flat: Flat,
    /// The nearest part, by index.
    pub part: u16,
    /// Over all parts but the nearest, mm.
    pub others: f64,
}

impl Facet {
    pub fn none() -> Self {
        let flat = Flat { least: f64::INFINITY, middle: f64::INFINITY, slope: Vector::zeros() };
        Facet { flat, part: 0, others: f64::INFINITY }
    }

    pub fn add(&mut self, part: usize, flat: Flat) {
        if flat.least < self.flat.least {
            *self = Facet { flat, part: part as u16, others: self.flat.least };
        } else if flat.least < self.others {
            self.others = flat.least;
        }
    }
}

/// Bounds of the margin over a box with half sides `half` within `radius` of `v`, by tangent planes
/// of the convex distance: that at the middle, or where it leaves little of the room there one
/// between it and that at the corner where it is lowest. Near the place where tool and part touch
/// the margin is curved so much that the one at the middle would do only for much smaller boxes.
pub(super) fn facet(profile: &ToolProfile, axis: &Vector, v: &Vector, radius: f64, half: &[Vector; 3]) -> Facet {
    let (z, r) = height_and_radius(axis, v);
    let mut out = Facet::none();
    let none = (f64::INFINITY, 0.0, 0.0);
    let (mut nearest, mut part, mut second) = (none, 0, f64::INFINITY);
    for (k, f) in profile.frusta.iter().enumerate() {
        let above = f.above(z);
        if above >= nearest.0 {
            second = second.min(above);
            continue;
        }
        let at = f.margin(z, r);
        if at.0 < nearest.0 {
            (second, nearest, part) = (nearest.0, at, k);
        } else {
            second = second.min(at.0);
        }
    }
    let Some(f) = profile.frusta.get(part) else { return out };
    out.add(part, plane(f, axis, (v, radius, half), (z, r), nearest));
    if second - radius > out.flat.least.max(SHARE_OF_ROOM * second) {
        out.others = second - radius;
        return out;
    }
    for (k, f) in profile.frusta.iter().enumerate().filter(|(k, _)| *k != part) {
        if out.flat.least <= 0.0 {
            break;
        }
        let at = f.margin(z, r);
        if at.0 - radius < out.others {
            out.add(k, plane(f, axis, (v, radius, half), (z, r), at));
        }
    }
    out
}

/// As [`facet`] for one part alone.
pub(super) fn facet_of(f: &Frustum, axis: &Vector, v: &Vector, radius: f64, half: &[Vector; 3]) -> Flat {
    let (z, r) = height_and_radius(axis, v);
    plane(f, axis, (v, radius, half), (z, r), f.margin(z, r))
}

/// Height over the ball centre and distance from the tool's axis.
pub(super) fn height_and_radius(axis: &Vector, v: &Vector) -> (f64, f64) {
    let z = v.dot(axis);
    (z, (v.norm_squared() - z * z).max(0.0).sqrt())
}

/// The plane for the box from margin and derivatives at the box's middle, of height `z` and radius
/// `r`.
fn plane(
    f: &Frustum,
    axis: &Vector,
    (v, radius, half): (&Vector, f64, &[Vector; 3]),
    (z, r): (f64, f64),
    (m, by_z, by_r): (f64, f64, f64),
) -> Flat {
    let k = if r > 0.0 { by_r / r } else { 0.0 };
    let slope = v * k + axis * (by_z - k * z);
    let along = half.map(|h| slope.dot(&h));
    let fall: f64 = along.iter().map(|a| a.abs()).sum();
    let least = m - fall.min(radius);
    if least < SHARE_OF_ROOM * m && m > NONE_MM {
        let two = by_two(f, axis, v, half, (m, &slope, &along));
        if two.least > least {
            return two;
        }
    }
    Flat { least, middle: m, slope }
}

/// Share of the room at a box's middle that one plane must leave, or two are tried: more room lasts
/// for more places.
const SHARE_OF_ROOM: f64 = 0.5;
/// Shares of the second plane that are tried.
const SHARES: [f64; 4] = [0.5, 0.75, 0.25, 1.0];

/// The best of some mixtures of the tangent plane at the box's middle, of value `m` there, and that
/// at the box's lowest corner by it.
fn by_two(
    f: &Frustum,
    axis: &Vector,
    v: &Vector,
    half: &[Vector; 3],
    (m, slope, along): (f64, &Vector, &[f64; 3]),
) -> Flat {
    let mut corner = *v;
    for (h, a) in half.iter().zip(along) {
        corner -= h * a.signum();
    }
    let (there, second) = clear::margin(f, axis, &corner);
    if there <= NONE_MM {
        return Flat { least: there.min(0.0), middle: m, slope: *slope };
    }
    let at_middle = there + second.dot(&(v - corner));
    let with = half.map(|h| second.dot(&h));
    let mut best = (f64::NEG_INFINITY, 0.0);
    for share in SHARES {
        let rest = 1.0 - share;
        let fall: f64 = along.iter().zip(&with).map(|(a, b)| (rest * a + share * b).abs()).sum();
        let least = rest * m + share * at_middle - fall;
        if least > best.0 {
            best = (least, share);
        }
        if least > SHARE_OF_ROOM * m {
            break;
        }
    }
    let (least, share) = best;
    let rest = 1.0 - share;
    Flat { least, middle: rest * m + share * at_middle, slope: slope * rest + second * share }
}

/// Lower bound of the margin over a box, mm.
pub(super) fn least_margin(profile: &ToolProfile, axis: &Vector, v: &Vector, radius: f64, half: &[Vector; 3]) -> f64 {
    facet(profile, axis, v, radius, half).flat.least
}

/// As [`least_margin`], with the tool turned to each point's own azimuth. There the margin depends
/// on the point's `x` and distance `ρ` from the turning axis alone and is convex in both; over the
/// node `ρ` exceeds its tangent plane at the centre by at most `radius² / 2(ρ − radius)`.
pub(super) fn least_at_own_azimuth(
    profile: &ToolProfile,
    b: (f64, f64),
    v: &Vector,
    radius: f64,
    half: &[Vector; 3],
) -> f64 {
    let rho = (v.y * v.y + v.z * v.z).sqrt();
    if rho <= 2.0 * radius {
        // A point of the turning axis has the same margin at all angles.
        let (z, r) = (v.x * b.0, (v.x * b.1).abs());
        return least_of(profile, z, r) - rho - radius;
    }
    let away = Vector::new(0.0, v.y / rho, v.z / rho);
    let axis = Vector::new(b.0, b.1 * away.y, b.1 * away.z);
    let bend = 0.5 * radius * radius / (rho - radius);
    let (z, r) = height_and_radius(&axis, v);
    let mut least = f64::INFINITY;
    for f in &profile.frusta {
        if f.above(z) - radius - bend >= least {
            continue;
        }
        let (m, by_z, by_r) = f.margin(z, r);
        if m - radius - bend >= least {
            continue;
        }
        let k = if r > 0.0 { by_r / r } else { 0.0 };
        let slope = v * k + axis * (by_z - k * z);
        let fall: f64 = half.iter().map(|h| slope.dot(h).abs()).sum();
        least = least.min(m - (fall + (-slope.dot(&away)).max(0.0) * bend).min(radius + bend));
    }
    least
}

/// Points within `radius` of `v` are inside the inflated tool for one arc about their own azimuth,
/// if at all.
pub(super) fn one_arc(profile: &ToolProfile, v: &Vector, radius: f64) -> bool {
    profile.widens && v.norm() + radius <= profile.length
}

/// The room that all intervals leave for a node; `None` where none can be shown.
pub(super) fn room(
    profile: &ToolProfile,
    sweeps: &[FreeSweep],
    b: (f64, f64),
    v: &Vector,
    radius: f64,
    half: &[Vector; 3],
) -> Option<NodeRoom> {
    let far = v.norm() - radius - profile.farthest;
    if far > NONE_MM {
        return Some(NodeRoom::anyhow(far));
    }
    if one_arc(profile, v, radius) {
        return room_beside(profile, sweeps, b, v, radius, half);
    }
    // What is clear of a longer and thicker tool is clear of this one.
    let tall = profile.tall.as_ref().filter(|t| one_arc(t, v, radius));
    if let Some(room) = tall.and_then(|t| room_beside(t, sweeps, b, v, radius, half)) {
        return Some(room);
    }
    walked(profile, sweeps, b, v, radius, half)
}

/// As [`room`] for a node whose points are inside the tool for one arc each.
fn room_beside(
    profile: &ToolProfile,
    sweeps: &[FreeSweep],
    b: (f64, f64),
    v: &Vector,
    radius: f64,
    half: &[Vector; 3],
) -> Option<NodeRoom> {
    let (rho, reach) = ((v.y * v.y + v.z * v.z).sqrt() + radius, v.norm() + radius);
    if !sweeps.iter().all(|s| s.is_beside(v, radius)) {
        let mm = least_at_own_azimuth(profile, b, v, radius, half);
        return (mm > NONE_MM).then_some(NodeRoom::new(mm, 0.0, reach + mm));
    }
    let (mut mm, mut facets) = (f64::INFINITY, None);
    for s in sweeps {
        let mut both = [Facet::none(); 2];
        for (out, axis) in both.iter_mut().zip(&s.axes) {
            *out = facet(profile, axis, v, radius, half);
            mm = mm.min(out.flat.least);
            if mm <= NONE_MM {
                return None;
            }
        }
        facets = Some(both);
    }
    if mm == f64::INFINITY {
        // Nothing is free: any room will do until something is.
        return Some(NodeRoom::new(radius, rho, reach + radius));
    }
    Some(NodeRoom { mm, across: rho + mm, reach: reach + mm, facets: facets.filter(|_| sweeps.len() == 1) })
}

/// Room from margins at angles so near to one another that none between them is less than half of
/// one of theirs.
fn walked(
    profile: &ToolProfile,
    sweeps: &[FreeSweep],
    b: (f64, f64),
    v: &Vector,
    radius: f64,
    half: &[Vector; 3],
) -> Option<NodeRoom> {
    // Most that are not clear at all are not clear at an end.
    let mut ends = sweeps.iter().flat_map(|s| s.axes);
    if ends.any(|axis| least_margin(profile, &axis, v, radius, half) <= NONE_MM) {
        return None;
    }
    let rho = (v.y * v.y + v.z * v.z).sqrt() + radius;
    let mut mm = f64::INFINITY;
    for s in sweeps {
        let mut at = s.lo;
        let mut steps = 0;
        loop {
            let here = least_margin(profile, &axis(b, at), v, radius, half);
            steps += 1;
            if here <= NONE_MM || steps > WALK {
                return None;
            }
            mm = mm.min(0.5 * here);
            if at >= s.hi {
                break;
            }
            at = (at + 0.5 * here / rho).min(s.hi);
        }
    }
    let mm = mm.min(radius.max(1.0));
    Some(NodeRoom::new(mm, rho + mm, v.norm() + radius + mm))
}

/// What there is to say about a triangle between the ends of the intervals.
pub(super) enum Between<'a> {
    /// It has this room at all angles, mm.
    Room(f64),
    /// The margins at the ends decide.
    Ends,
    /// If it is clear of this tool around the tool at the ends, it is clear.
    Around(&'a ToolProfile),
    /// Nothing: it is too large to tell.
    Nothing,
}

/// As [`room`] for a triangle within `radius` of its point `v`, but for the margins at the ends of
/// the intervals.
pub(super) fn between_ends<'a>(
    profile: &'a ToolProfile,
    sweeps: &[FreeSweep],
    b: (f64, f64),
    corners: &[Vector; 3],
    v: &Vector,
    radius: f64,
) -> Between<'a> {
    let beside = sweeps.iter().all(|s| s.is_beside(v, radius));
    let one = one_arc(profile, v, radius);
    if one && beside {
        return Between::Ends;
    }
    let tall = profile.tall.as_deref().filter(|t| !one && one_arc(t, v, radius));
    if let Some(tall) = tall.filter(|_| beside) {
        return Between::Around(tall);
    }
    let half = [corners[1] - corners[0], corners[2] - corners[0], Vector::zeros()];
    let own = if one { Some(profile) } else { tall };
    let mm = own.map_or(0.0, |p| least_at_own_azimuth(p, b, v, radius, &half));
    if mm > NONE_MM {
        Between::Room(mm)
    } else if one {
        Between::Nothing
    } else {
        by_steps(profile, sweeps, b, corners, v, radius)
    }
}

/// As [`between_ends`] for any profile, angle by angle.
pub(super) fn by_steps(
    profile: &ToolProfile,
    sweeps: &[FreeSweep],
    b: (f64, f64),
    corners: &[Vector; 3],
    v: &Vector,
    radius: f64,
) -> Between<'static> {
    let half = [corners[1] - corners[0], corners[2] - corners[0], Vector::zeros()];
    walked(profile, sweeps, b, v, radius, &half).map_or(Between::Nothing, |r| Between::Room(r.mm))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// What is said to be beside an interval has no azimuth in it; points well away from it all
    /// round are, also behind a narrow one.
    #[test]
    fn beside_is_beside() {
        for (lo, width) in [(0.3, 1e-3), (-2.0, 0.5), (5.0, 3.0), (1.0, 5.0)] {
            let sweep = FreeSweep::new(lo, lo + width, (0.1, 0.99));
            for k in 0..360 {
                let psi = f64::from(k).to_radians();
                let from = (psi - lo).rem_euclid(TAU);
                let inside = from <= width;
                let v = Vector::new(3.0, 10.0 * psi.cos(), 10.0 * psi.sin());
                let away = (from - width).min(TAU - from);
                for radius in [0.0, 1.0] {
                    let spread: f64 = f64::asin(radius / 10.0);
                    let beside = sweep.is_beside(&v, radius);
                    assert!(!beside || !inside && away >= spread - 1e-9, "{lo} {width} {psi}");
                    assert!(beside || inside || away <= 1.5 * spread + 1e-9, "{lo} {width} {psi} {radius}");
                }
                if sweep.have_beside(&[Point::from(v)], |p| p.coords) {
                    assert!(!inside, "{lo} {width} {psi}");
                } else {
                    assert!(inside || width > PI || away < 1e-9, "{lo} {width} {psi}");
                }
            }
        }
    }
}
