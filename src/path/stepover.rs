//! The scallop between two neighbouring passes, measured on the part itself.
//!
//! A ball between two passes, on the level set like them, would touch the part at a contact point
//! `p` with normal `n`. What the two passes leave standing there is the height at which the ray
//! from `p` along `n` enters one of their balls, and the ridge is where both leave the same. On a
//! part of constant curvature across the passes this is the cusp of the two-ball construction,
//! `h = |ρ cos α ∓ √(R² − ρ² sin² α) − r|`, `sin α = d/2ρ`; measured on the part it needs no
//! curvature, so it holds on meshes, creases and saddles alike, and what no ball of this radius can
//! reach (sharp inner corners) does not count.

use super::level::{LevelSet, Touch};
use crate::geometry::disc::Disc;
use crate::geometry::{Point, Vector};
use crate::tool::inclination::{BEND, Bending};

/// Places between two passes that are looked at; one does where the curvature is steady.
const RIDGE_STEPS: usize = 9;
/// A ridge's place is known well enough within this share of the way from pass to pass.
const RIDGE_PLACE: f64 = 1e-3;
/// Contacts with normals this near to one another are on facets of one wall, rad.
const ONE_WALL_RAD: f64 = 0.2;
/// A contact that goes so many times as far as the ball jumps over a crease.
const JUMP: f64 = 3.0;
/// Halvings of the turn between the contacts of a ball in a crease.
const CREASE_HALVINGS: usize = 12;
/// The roots of both heights are equal within this share of their sum where the ridge is.
const EVEN: f64 = 0.01;
/// The same under cutters with a corner: noise of their turns hardly fades from one to the next.
const EVENLY: f64 = 1e-4;

/// What is left is known from three stands, [`BEND`] apart, as far as so many from the one amid
/// them.
const NEAR_STANDS: f64 = 1.5;
/// Where a stand farther off leaves less, others are looked at no farther off than this, so often.
const MOST_STANDS: f64 = 8.0;
const MOST_MOVES: usize = 6;

/// A place of a pass, as its neighbour sees it.
pub struct Pass {
    /// Centre of the ball, or of the corner that rolls over a disc.
    centre: Point,
    /// A cutter with a corner on its way there.
    cutter: Option<Passing>,
}

/// A cutter with a corner on its way past a place: where it touches a step before the place, there,
/// and a step beyond it, with its discs at the greatest contact angle.
///
/// What the cutter leaves over a point beside its pass is the least of what its stands leave, and
/// grows as the square of the way from the one that leaves it. The part bends along the way, and
/// the axis goes with the normal: round the edges of a blade both matter much.
struct Passing {
    touches: [Touch; 3],
    discs: [Disc; 3],
    way: Vector,
    /// The contact there, and the unit vector across the line of contacts.
    contact: Point,
    across: Vector,
    /// What passes are laid for leaves so much more at a distance `D` beside the line, over `D²/2`,
    /// 1/mm ([`Inclined::curvatures`](crate::tool::inclination::Inclined::curvatures)).
    more: f64,
}

impl Passing {
    /// `None` where the level set has no place a step before or beyond.
    fn new(level: &LevelSet, at: &Touch, way: &Vector) -> Option<Self> {
        let (inclined, corner) = (level.inclined.as_ref()?, level.radius_mm);
        // Square to the normal, or the cutter would come down and go up on its way.
        let way = (way - at.normal * way.dot(&at.normal)).try_normalize(1e-9)?;
        let touches = beside(level, at, &way)?;
        let discs = touches.each_ref().map(|t| inclined.disc(&t.centre, &t.normal));
        let bending = bending(&touches, corner);
        let frame = bending.frame()?;
        let sharp = inclined.curvatures(&round(level, at)?, &frame).map(|both| both.map(|c| bending.sharpness(&c)));
        let more = match sharp {
            Some([Some(own), Some(laid)]) => (laid - own).max(0.0),
            _ => 0.0,
        };
        let contact = at.centre - at.normal * corner;
        Some(Passing { touches, discs, way, contact, across: frame[1], more })
    }

    /// What it leaves over a place with the unit `normal`, mm; infinite where it passes by. Where
    /// another stand leaves less, it is looked at from there.
    fn leaves_mm(&self, level: &LevelSet, p: &Point, normal: &Vector) -> f64 {
        let step_mm = BEND * level.radius_mm;
        let of = |passing: &Passing| {
            let (least, on) = least(passing.discs.each_ref().map(|d| d.entry_mm(p, normal, level.radius_mm)));
            (least + 0.5 * passing.more * passing.across.dot(&(p - passing.contact)).powi(2), on)
        };
        let (mut best, mut on) = of(self);
        let mut moved: Option<Passing> = None;
        for _ in 0..MOST_MOVES {
            if on.abs() <= NEAR_STANDS {
                break;
            }
            let from = moved.as_ref().unwrap_or(self);
            let next = &from.touches[if on > 0.0 { 2 } else { 0 }];
            let ahead = (on.abs() - 1.0).min(MOST_STANDS) * step_mm;
            let Some(to) = (next.centre - from.touches[1].centre).try_normalize(1e-9) else { break };
            let there = level.touch(&(next.centre + to * ahead), ahead + step_mm);
            let Some(there) = there.and_then(|t| Passing::new(level, &t, &from.way)) else { break };
            let found = of(&there);
            if !(found.0 < best) {
                break;
            }
            (best, on) = found;
            moved = Some(there);
        }
        best
    }
}

/// Where a corner touches a step before a place, there, and a step beyond it, along a unit vector.
fn beside(level: &LevelSet, at: &Touch, way: &Vector) -> Option<[Touch; 3]> {
    let step_mm = BEND * level.radius_mm;
    let to = |sign: f64| level.touch(&(at.centre + way * (sign * step_mm)), step_mm);
    Some([to(-1.0)?, *at, to(1.0)?])
}

fn bending([before, at, beyond]: &[Touch; 3], corner_mm: f64) -> Bending {
    Bending::of_corner(at.normal, beyond.centre - before.centre, beyond.normal - before.normal, corner_mm)
}

/// How the part bends along a turn, at the same height; `None` where the level set ends beside it.
pub fn round(level: &LevelSet, at: &Touch) -> Option<Bending> {
    Some(bending(&beside(level, at, &at.tangent(&level.along))?, level.radius_mm))
}

/// The least of what is left, by three stands one step from the other: that of the parabola through
/// them, and how many steps beyond the one amid them it is.
fn least([before, here, beyond]: [f64; 3]) -> (f64, f64) {
    let (bend, slope) = (0.5 * (before + beyond) - here, 0.5 * (beyond - before));
    if bend > 0.0 && bend.is_finite() {
        let at = -0.5 * slope / bend;
        let near = at.clamp(-NEAR_STANDS, NEAR_STANDS);
        return (here + (slope + bend * near) * near, at);
    }
    let least = before.min(here).min(beyond);
    let on = if least == here || !least.is_finite() {
        0.0
    } else if least == before {
        -MOST_STANDS
    } else {
        MOST_STANDS
    };
    (least, on)
}

impl Pass {
    /// Of a ball.
    pub fn of_ball(centre: &Point) -> Self {
        Pass { centre: *centre, cutter: None }
    }

    /// Of a pass that goes on along `way`, of any length.
    pub fn new(level: &LevelSet, at: &Touch, way: &Vector) -> Self {
        Pass { centre: at.centre, cutter: Passing::new(level, at, way) }
    }

    /// Two passes beside one another, taken to go on across the way from one to the other.
    pub fn pair(level: &LevelSet, a: &Touch, b: &Touch) -> [Self; 2] {
        let way = (a.normal + b.normal).cross(&(b.centre - a.centre));
        [a, b].map(|t| Pass::new(level, t, &way))
    }

    /// What it leaves standing at a place of the part with the unit `normal`, mm; infinite where it
    /// passes by.
    fn leaves_mm(&self, level: &LevelSet, p: &Point, normal: &Vector) -> f64 {
        match &self.cutter {
            None => ray_into_ball(p, normal, &self.centre, level.radius_mm),
            Some(passing) => passing.leaves_mm(level, p, normal),
        }
    }
}

/// Height of the ridge between two passes of the level set over the part, mm; infinite where
/// neither reaches over the contact between them, `None` where there is no ball of the level set
/// between them.
///
/// The ridge is where both balls leave the same height. That is midway only where the curvature
/// across the passes does not change, and much nearer to one of them where a wall runs into a
/// fillet: each height grows about as the square of the way from its own pass, `h_a ≈ (s_a a)²` at
/// the share `a` of the way, which says where to look next and, once that is near, how high the
/// ridge is: `(s_a s_b / (s_a + s_b))²`. Every place looked at is on the part, so where the
/// curvature jumps the greatest height found is left there indeed.
pub fn ridge_height(level: &LevelSet, passes: [&Pass; 2]) -> Option<f64> {
    ridge(level, passes, false)
}

/// As [`ridge_height`], and over what a ball in a crease between the passes, at two contacts at
/// once, would leave standing in the corner under it: two passes on both sides of a crease leave
/// more there than at any contact.
pub fn ridge_over_creases(level: &LevelSet, passes: [&Pass; 2]) -> Option<f64> {
    ridge(level, passes, true)
}

fn ridge(level: &LevelSet, passes: [&Pass; 2], in_creases: bool) -> Option<f64> {
    let [a, b] = [passes[0].centre, passes[1].centre];
    let reach = 0.5 * (b - a).norm() + 0.02 * level.radius_mm;
    let even = if level.inclined.is_some() { EVENLY } else { EVEN };
    let mut share = 0.5;
    // The nearest places known at which `a` leaves less than `b`, and more.
    let (mut less, mut more): (Option<BetweenPasses>, Option<BetweenPasses>) = (None, None);
    let mut ridge: Option<f64> = None;
    for _ in 0..RIDGE_STEPS {
        let Some(between) = level.touch(&(a + (b - a) * share), reach) else { break };
        let [of_a, of_b] = [0, 1].map(|k| passes[k].leaves_mm(level, &between.contact, &between.normal));
        ridge = Some(ridge.map_or(of_a.min(of_b), |r| r.max(of_a.min(of_b))));
        if of_a.is_infinite() && of_b.is_infinite() {
            break;
        }
        let (root_a, root_b) = (of_a.max(0.0).sqrt(), of_b.max(0.0).sqrt());
        let (rate_a, rate_b) = (root_a / share, root_b / (1.0 - share));
        if (root_a - root_b).abs() <= even * (root_a + root_b) {
            return Some((rate_a * rate_b / (rate_a + rate_b).max(1e-300)).powi(2));
        }
        let side = BetweenPasses { share, root_a, root_b, contact: between.contact, normal: between.normal };
        if root_a > root_b {
            more = Some(side)
        } else {
            less = Some(side)
        }
        let (low, high) = (less.map_or(0.0, |s| s.share), more.map_or(1.0, |s| s.share));
        if high - low < RIDGE_PLACE {
            break;
        }
        // Where one of them is infinite this is no number, and the middle is taken.
        let next = match (&less, &more) {
            (Some(l), Some(m)) => low + l.crossing(m) * (high - low),
            _ => rate_b / (rate_a + rate_b),
        };
        share = if next > low && next < high { next } else { 0.5 * (low + high) };
    }
    match (less, more) {
        (Some(l), Some(m)) if in_creases && l.is_over_a_crease(&m, level.radius_mm) => {
            let under = l.crease(&m, passes, level);
            Some(ridge.map_or(under, |r| r.max(under)))
        }
        // Between neighbouring facets the contact jumps; the ridge is between the two contacts.
        (Some(l), Some(m)) if l.finite() && m.finite() && l.normal.angle(&m.normal) < ONE_WALL_RAD => {
            Some((l.root_a + l.crossing(&m) * (m.root_a - l.root_a)).powi(2))
        }
        _ => ridge,
    }
}

/// What two passes leave at a place between them.
#[derive(Clone, Copy)]
struct BetweenPasses {
    share: f64,
    /// Roots of the heights left by the one and the other.
    root_a: f64,
    root_b: f64,
    contact: Point,
    normal: Vector,
}

impl BetweenPasses {
    /// Whether the ball goes less far from here to `more` than its contact jumps: in a hollow
    /// narrower than itself. Round an edge it goes farther.
    fn is_over_a_crease(&self, more: &BetweenPasses, radius_mm: f64) -> bool {
        let jump = more.contact - self.contact;
        let gone = jump + (more.normal - self.normal) * radius_mm;
        jump.norm() > JUMP * gone.norm()
    }

    /// The height that both passes leave over the ball between them, which touches here and at
    /// `more`: between its contacts it is the lowest that any ball comes to.
    fn crease(&self, more: &BetweenPasses, passes: [&Pass; 2], level: &LevelSet) -> f64 {
        let radius_mm = level.radius_mm;
        // The ball that touches the planes of both contacts.
        let centres = [self, more].map(|s| s.contact + s.normal * radius_mm);
        let middle = nalgebra::center(&centres[0], &centres[1]);
        let off = [0, 1].map(|k| (centres[k] - middle).dot(&[self, more][k].normal));
        let cos = self.normal.dot(&more.normal);
        let [here, there] = [off[0] - cos * off[1], off[1] - cos * off[0]].map(|d| d / (1.0 - cos * cos).max(1e-9));
        let centre = middle + self.normal * here + more.normal * there;
        let (mut low, mut high, mut height) = (0.0, 1.0, 0.0f64);
        for _ in 0..CREASE_HALVINGS {
            let share = 0.5 * (low + high);
            let Some(normal) = self.normal.lerp(&more.normal, share).try_normalize(1e-6) else { break };
            let p = centre - normal * radius_mm;
            let [of_a, of_b] = [0, 1].map(|k| passes[k].leaves_mm(level, &p, &normal));
            height = of_a.min(of_b);
            if of_a > of_b { high = share } else { low = share }
        }
        height
    }

    fn finite(&self) -> bool {
        self.root_a.is_finite() && self.root_b.is_finite()
    }

    /// The share of the way from here to `more` at which both leave the same if the roots run
    /// straight; no number where one is infinite.
    fn crossing(&self, more: &BetweenPasses) -> f64 {
        let here = self.root_b - self.root_a;
        here / (here + more.root_a - more.root_b).max(1e-300)
    }
}

/// Where the ray from `p` along the unit vector `n` enters the ball round `c`; infinite where it
/// passes it by.
fn ray_into_ball(p: &Point, n: &Vector, c: &Point, radius_mm: f64) -> f64 {
    let to_centre = c - p;
    let along = to_centre.dot(n);
    let under_root = radius_mm * radius_mm - (to_centre.norm_squared() - along * along);
    if under_root < 0.0 { f64::INFINITY } else { along - under_root.sqrt() }
}

/// The figure of many ridge heights that a pitch is judged by, mm: the greatest on exact faces; on
/// a mesh the 99th percentile, since single ridges on the edges between facets show the facets
/// and not the part. Of cutters with a corner too, since they are foreseen as if turns went
/// straight on: where these bend sharply that is too much. 0 without heights.
pub fn decisive_mm(level: &LevelSet, mut heights_mm: Vec<f64>) -> f64 {
    heights_mm.sort_by(f64::total_cmp);
    let rank = if level.is_over_facets() || level.inclined.is_some() { 0.99 } else { 1.0 };
    let last = heights_mm.len().saturating_sub(1);
    heights_mm.get((last as f64 * rank).round() as usize).copied().unwrap_or(0.0)
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used)]
    use super::*;
    use crate::artifact::along::Along;
    use crate::geometry::allowance::Allowed;
    use crate::geometry::mesh::Mesh;
    use crate::geometry::part::Part;

    /// Two passes to both sides of a hollow edge, `s` from the ball that touches both its flanks:
    /// over that ball the ridge is `R + s sin(δ/2) − √(R² − s² cos²(δ/2))`; at its contacts alone
    /// it is `R − √(R² − s²)`.
    #[test]
    fn a_ridge_over_a_hollow_edge_is_that_over_the_ball_in_it() {
        let (radius_mm, s) = (0.3, 0.05);
        for (bend_deg, of_contacts) in [(16.0, 0.65), (32.0, 0.4), (90.0, 0.2)] {
            let half = 0.5 * f64::to_radians(bend_deg);
            let mut mesh = Mesh::default();
            for x in [-9.0, 9.0] {
                mesh.points.extend([-5.0, 0.0, 5.0].map(|y: f64| Point::new(x, y, y.abs() * half.tan())));
            }
            mesh.triangles.extend([[0, 3, 1], [1, 3, 4], [1, 4, 2], [2, 4, 5]]);
            let part = Part::from_mesh(mesh);
            let level = LevelSet {
                part: Allowed::new(&part, 0.0),
                along: Along::BLADE,
                radius_mm,
                inclined: None,
                rim: None,
                lowest_mm: f64::NEG_INFINITY,
            };
            let passes = [-s, s].map(|t| Point::new(0.0, t * half.cos(), radius_mm / half.cos() + s * half.sin()));
            for p in &passes {
                assert!((level.touch(p, 0.1).unwrap().centre - p).norm() < 1e-6);
            }
            let balls = [0, 1].map(|k| Pass::of_ball(&passes[k]));
            let found = ridge_over_creases(&level, balls.each_ref()).unwrap();
            let expected = radius_mm + s * half.sin() - (radius_mm.powi(2) - (s * half.cos()).powi(2)).sqrt();
            assert!((found / expected - 1.0).abs() < 0.005, "{bend_deg}°: {found} for {expected}");
            if bend_deg > 20.0 {
                assert!(ridge_height(&level, balls.each_ref()).unwrap() < of_contacts * expected);
            }
        }
    }
}
