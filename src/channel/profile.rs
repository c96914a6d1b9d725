//! The tool's profile, inflated: which heights over the ball centre a point at a given distance
//! from it may not have.
//!
//! A frustum of the profile together with its clearance `c` is the set of points no farther than
//! `c` from the frustum (its Minkowski sum with a ball: sides moved out by `c`, rims rounded with
//! radius `c`). A point at distance `d` from the ball centre moves on a circle of radius `d` in the
//! profile's half plane (height `z`, radius `r`) as the tool turns about the centre; it is inside
//! the inflated frustum exactly for one interval of `z`, found here in closed form. Since inflating
//! by `c + e` is the same as inflating by `c` and then by `e`, the interval for a ball of radius
//! `e` about the point contains those of all points of that ball: this is the bound that the search
//! for the channel rests on. The distance from a frustum is also convex, so that its tangent plane
//! bounds it from below over a whole triangle.

use crate::artifact::ToolPart;
use crate::geometry::Vector;
use crate::tool::Tool;

/// A frustum of the profile with its clearance.
#[derive(Clone, Debug)]
pub(super) struct Frustum {
    z0: f64,
    z1: f64,
    r0: f64,
    r1: f64,
    /// Radius of the cone at height 0, and its growth per height.
    c0: f64,
    c1: f64,
    sin: f64,
    cos: f64,
    /// Length of the side, mm.
    slant: f64,
    clearance: f64,
}

impl Frustum {
    /// From height to height over the ball centre, with the radii there and the clearance that it
    /// keeps, at least 0; mm.
    pub fn new([z0, z1]: [f64; 2], [r0, r1]: [f64; 2], clearance: f64) -> Self {
        let c1 = (r1 - r0) / (z1 - z0);
        let slant = (z1 - z0).hypot(r1 - r0);
        Frustum {
            z0,
            z1,
            r0,
            r1,
            c0: r0 - c1 * z0,
            c1,
            sin: (r1 - r0) / slant,
            cos: (z1 - z0) / slant,
            slant,
            clearance,
        }
    }

    /// Margin of the plane `normal · p = offset`, its slope, and a point of the plane that has it;
    /// of several, one near `by`.
    pub fn off_plane(&self, axis: &Vector, normal: &Vector, offset: f64, by: &Vector) -> (f64, Vector, Vector) {
        let up = normal.dot(axis);
        let out = normal - axis * up;
        let off = out.norm();
        // Farthest point of the frustum along the normal, times `sense`.
        let farthest = |sense: f64| {
            let ends = [(self.z0, self.r0), (self.z1, self.r1)];
            let reach = ends.map(|(z, r)| sense * up * z + off * r);
            let (z, r) = if reach[0] > reach[1] { ends[0] } else { ends[1] };
            if off > 1e-12 {
                return axis * z + out * (sense * r / off);
            }
            let across = by - axis * by.dot(axis);
            let far = across.norm();
            axis * z + if far > r { across * (r / far) } else { across }
        };
        let (top, bottom) = (farthest(1.0), farthest(-1.0));
        let (high, low) = (normal.dot(&top), normal.dot(&bottom));
        if offset > high {
            (offset - high - self.clearance, *normal, top + normal * (offset - high))
        } else if offset < low {
            (low - offset - self.clearance, -normal, bottom + normal * (offset - low))
        } else {
            let share = if high > low { (offset - low) / (high - low) } else { 0.5 };
            (-self.clearance, Vector::zeros(), bottom + (top - bottom) * share)
        }
    }

    /// The least of `normal · p` over the frustum with its clearance; `normal` of unit length or
    /// zero.
    pub fn lowest(&self, axis: &Vector, normal: &Vector) -> f64 {
        let up = normal.dot(axis);
        let off = (normal - axis * up).norm();
        (up * self.z0 - off * self.r0).min(up * self.z1 - off * self.r1) - self.clearance
    }

    /// Heights that are inside, for points at distance `d` from the ball centre, the frustum
    /// inflated by its clearance and `extra`; `None` where there are none.
    pub fn inside(&self, d: f64, extra: f64) -> Option<(f64, f64)> {
        let c = self.clearance + extra;
        let (bottom, top) = (self.z0 - c, self.z1 + c);
        if d < bottom || d > self.z1.hypot(self.r1) + c {
            return None;
        }
        let d2 = d * d;
        let low = self.low(d, d2, c, bottom);
        let high = if d <= top {
            d
        } else if d2 <= top * top + self.r1 * self.r1 {
            top
        } else {
            rim(d2, self.z1, self.r1, c, 1.0)
        };
        (low <= high).then_some((low, high))
    }

    /// Distance of the point at height `z` and radius `r` from the frustum, less its clearance, and
    /// its derivatives by `z` and `r` (0 inside). It is a convex function of the point in space,
    /// since the frustum is convex.
    pub fn margin(&self, z: f64, r: f64) -> (f64, f64, f64) {
        let (ez, er) = (z - self.z0, r - self.r0);
        let (along, off) = (ez * self.cos + er * self.sin, er * self.cos - ez * self.sin);
        let from = |ez: f64, er: f64| {
            let d = (ez * ez + er * er).sqrt();
            if d > 0.0 { (d, ez / d, er / d) } else { (0.0, 0.0, 0.0) }
        };
        let (d, gz, gr) = if off > 0.0 && (0.0..=self.slant).contains(&along) {
            (off, -self.sin, self.cos)
        } else if ez < 0.0 {
            from(ez, er.max(0.0))
        } else if off > 0.0 || z > self.z1 {
            from(z - self.z1, (r - self.r1).max(0.0))
        } else {
            (0.0, 0.0, 0.0)
        };
        (d - self.clearance, gz, gr)
    }

    /// No point at the height `z` has a lesser margin: how far above it the frustum begins, less
    /// its clearance. For most points most of the tool is far above, and need not be looked at.
    pub fn above(&self, z: f64) -> f64 {
        self.z0 - z - self.clearance
    }

    /// The circle's lowest point inside: on the front face, the lower rim, the side or the upper
    /// rim, in this order as the distance grows.
    fn low(&self, d: f64, d2: f64, c: f64, bottom: f64) -> f64 {
        let square = |z: f64, r: f64| z * z + r * r;
        if d2 <= square(bottom, self.r0) {
            bottom.max(-d)
        } else if d2 <= square(self.z0 - c * self.sin, self.r0 + c * self.cos) {
            rim(d2, self.z0, self.r0, c, -1.0)
        } else if d2 <= square(self.z1 - c * self.sin, self.r1 + c * self.cos) {
            let c0 = self.c0 + c / self.cos;
            let (a, b) = (1.0 + self.c1 * self.c1, c0 * self.c1);
            (-b + (b * b + a * (d2 - c0 * c0)).max(0.0).sqrt()) / a
        } else {
            rim(d2, self.z1, self.r1, c, -1.0)
        }
    }
}

/// Height where a circle of squared radius `d2` about the ball centre meets the circle of radius
/// `c` about the rim `(z, r)`: the upper (`side` 1) or lower (-1) of the two points.
fn rim(d2: f64, z: f64, r: f64, c: f64, side: f64) -> f64 {
    let d0 = z.hypot(r).max(1e-300);
    let along = (d2 + d0 * d0 - c * c) / (2.0 * d0);
    let across = (d2 - along * along).max(0.0).sqrt();
    (along * z + side * across * r) / d0
}

/// The whole tool above the ball.
#[derive(Clone, Debug)]
pub(super) struct ToolProfile {
    pub frusta: Vec<Frustum>,
    pub parts: Vec<ToolPart>,
    /// Height of the upper end, mm.
    pub length: f64,
    /// No point of the tool with its clearances is farther from the ball centre, mm.
    pub farthest: f64,
    /// Nowhere does the profile, clearances included, become narrower upwards, and nowhere does its
    /// outline come nearer to the ball centre: a point that leaves the tool as the tool turns away
    /// from it does not come into it again.
    pub widens: bool,
    /// A tool around this one that widens and is longer than all that this one reaches; none where
    /// there is no such simple one.
    pub tall: Option<Box<ToolProfile>>,
}

/// Nowhere narrower upwards, and nowhere is the outline nearer to the ball centre.
fn widens(frusta: &[Frustum]) -> bool {
    const ROUNDING: f64 = 1e-9;
    frusta.iter().all(|f| f.c1 >= 0.0 && f.z0 * f.cos + f.r0 * f.sin >= -ROUNDING)
        && frusta.windows(2).all(|w| {
            let (a, b) = (&w[0], &w[1]);
            a.z1 >= b.z0 - ROUNDING && a.r1 <= b.r0 + ROUNDING && a.clearance <= b.clearance
        })
}

/// Every part at least as thick as those below it, the last drawn out upwards.
fn tall(frusta: &[Frustum], farthest: f64) -> Option<Box<ToolProfile>> {
    let (mut radius, mut clearance) = (0.0f64, 0.0f64);
    let mut out: Vec<Frustum> = Vec::with_capacity(frusta.len());
    for (k, f) in frusta.iter().enumerate() {
        let drawn_out = if k + 1 == frusta.len() { 8.0 * farthest } else { 0.0 };
        let (z1, r1) = (f.z1 + drawn_out, f.r1 + drawn_out * f.c1.max(0.0));
        let r0 = f.r0.max(radius);
        // Of a cone that begins thinner than what is below it the cylinder at its upper end is
        // enough.
        let (r0, r1) = if r0 > f.r0 { (r0.max(r1), r0.max(r1)) } else { (r0, r1.max(r0)) };
        clearance = clearance.max(f.clearance);
        radius = r1;
        out.push(Frustum::new([f.z0, z1], [r0, r1], clearance));
    }
    let length = out.last().map_or(0.0, |f| f.z1);
    widens(&out).then(|| {
        Box::new(ToolProfile {
            frusta: out,
            parts: Vec::new(),
            length,
            farthest: 2.0 * length,
            widens: true,
            tall: None,
        })
    })
}

impl ToolProfile {
    /// `room_mm`: what taper and shank, and what the holder must keep; enlarged by `deflection_mm`,
    /// what the body's mesh may lie off the body.
    pub fn new(tool: &Tool, room_mm: [f64; 2], deflection_mm: f64) -> Self {
        let segments = tool.segments();
        let frusta: Vec<Frustum> = segments
            .iter()
            .map(|s| {
                let c = room_mm[usize::from(s.part.is_holder())];
                Frustum::new([s.z0, s.z1], [s.r0, s.r1], c + deflection_mm)
            })
            .collect();
        Self::of(frusta, segments.into_iter().map(|s| s.part).collect())
    }

    fn of(frusta: Vec<Frustum>, parts: Vec<ToolPart>) -> Self {
        let widens = widens(&frusta);
        let length = frusta.last().map_or(0.0, |f| f.z1);
        let reach = |f: &Frustum| f.z0.hypot(f.r0).max(f.z1.hypot(f.r1)) + f.clearance;
        let farthest = frusta.iter().map(reach).fold(0.0, f64::max);
        let tall = tall(&frusta, farthest);
        ToolProfile { frusta, parts, length, farthest, widens, tall }
    }

    /// The same with only some of its parts, by index.
    pub fn only(&self, keep: impl Fn(usize) -> bool) -> Self {
        let kept = (0..self.frusta.len()).filter(|&k| keep(k));
        let (frusta, parts) = kept.map(|k| (self.frusta[k].clone(), self.parts[k])).unzip();
        Self::of(frusta, parts)
    }

    /// The holder alone.
    pub fn holder(&self) -> Self {
        self.only(|k| self.parts[k].is_holder())
    }

    /// Heights inside the whole tool inflated by `extra`, for points at distance `d` whose heights
    /// lie in `within`: disjoint intervals with the frusta that their ends belong to, in `out`.
    pub fn inside(&self, d: f64, extra: f64, within: (f64, f64), out: &mut Vec<HeightRange>) {
        out.clear();
        for (k, f) in self.frusta.iter().enumerate() {
            let Some((low, high)) = f.inside(d, extra) else { continue };
            if high < within.0 || low > within.1 {
                continue;
            }
            let new = HeightRange { low, high, low_by: k as u16, high_by: k as u16 };
            // Frusta follow one another upwards: only the last interval can meet the new one, but
            // for holder stages that are wider than what precedes them, whose intervals may begin
            // lower.
            match out.last_mut() {
                Some(last) if new.low <= last.high && new.high >= last.low => {
                    if new.low < last.low {
                        (last.low, last.low_by) = (new.low, new.low_by);
                    }
                    if new.high > last.high {
                        (last.high, last.high_by) = (new.high, new.high_by);
                    }
                }
                _ => out.push(new),
            }
        }
    }
}

/// An interval of heights and the frusta that end it.
#[derive(Clone, Copy, Debug)]
pub(super) struct HeightRange {
    pub low: f64,
    pub high: f64,
    pub low_by: u16,
    pub high_by: u16,
}
