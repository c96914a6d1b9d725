//! The point of a part that is nearest to a disc.
//!
//! In: a part, a disc, how closely. Out: the nearest points of both, and a distance that no point
//! of the part is nearer than.
//!
//! The distance from the disc is a convex function of the point ([`super::disc`]), so its tangent
//! plane at one place bounds it over a box, and over the hull of a piece's control points. Boxes
//! and pieces that cannot hold a nearer point by more than the tolerance are left out, others are
//! halved: on exact faces by [`super::exact::pieces`], on meshes by the tree over their triangles,
//! each of which has its nearest point in closed form.
//!
//! On exact faces the point found is then followed to where it is nearest: to a point of the disc
//! belongs the closest point of the part, and to that again one of the disc. Of this map the fixed
//! point is sought by Broyden's method (*A class of methods for solving nonlinear simultaneous
//! equations*, 1965), and by the plain map where a step would lead farther away.
//!
//! **Guarantees.** The distance found is that of two points, one of the part and one of the disc.
//! No other point of the part is nearer by more than the tolerance, but beside edges, where what is
//! known of the faces is known to 10⁻⁴ mm ([`super::exact::pieces`]). The bounds hold for faces
//! whose pieces have control points; others are bounded by samples.

use super::disc::Disc;
use super::exact::pieces::{SeenPiece, Visitor, Walker};
use super::measured::Closest;
use super::part::Part;
use super::{Point, Vector};

/// A query halves at most so many pieces; after that its bound is what they leave.
const MOST_CUTS: usize = 20_000;
/// The fixed point is known where the map moves the disc's point by less than this, mm: then the
/// distance is known to the square of it.
const SETTLED_MM: f64 = 1e-9;
const MOST_STEPS: usize = 60;

/// The nearest points of a part and a disc.
#[derive(Clone, Copy, Debug)]
pub struct NearDisc {
    /// The part's, as seen from the disc's: with distance, outward normal and face.
    pub at: Closest,
    /// The disc's.
    pub on_disc: Point,
    /// How far they are apart, mm.
    pub distance_mm: f64,
    /// No point of the part is nearer to the disc than this, mm.
    pub least_mm: f64,
}

/// Queries to one part, one after another. What one has cut the next ones use; answers do not
/// depend on that.
pub struct DiscSearch<'a> {
    part: &'a Part,
    walker: Option<Walker<'a>>,
    published: Option<Box<DiscSearch<'a>>>,
}

/// Looks for what is nearest to a disc.
struct Nearest<'d> {
    disc: &'d Disc,
    tolerance_mm: f64,
    best_mm: f64,
    point: Option<Point>,
    /// The least bound of what was left out.
    least_mm: f64,
    found: u32,
}

impl Nearest<'_> {
    /// Whether what is no nearer than a bound may be left out.
    fn leaves_out(&mut self, bound_mm: f64) -> bool {
        // Nothing is nearer than nothing: once the disc cuts the part all is known.
        let bound_mm = bound_mm.max(0.0);
        let out = bound_mm >= self.best_mm - self.tolerance_mm;
        if out {
            self.least_mm = self.least_mm.min(bound_mm);
        }
        out
    }

    fn see(&mut self, point: &Point) {
        let d = self.disc.distance_mm(point);
        if d < self.best_mm {
            (self.best_mm, self.point, self.found) = (d, Some(*point), self.found + 1);
        }
    }
}

impl Visitor for Nearest<'_> {
    fn enters(&mut self, middle: &Point, sides: &[Vector; 3]) -> bool {
        let bound = self.disc.least_in_box_mm(middle, sides);
        !self.leaves_out(bound)
    }
    fn presses(&mut self, piece: &SeenPiece) -> Option<f64> {
        let bound = self.disc.least_in_hull_mm(&piece.middle, piece.hull);
        (!self.leaves_out(bound)).then_some(bound)
    }
    fn takes(&mut self, point: &Point) -> bool {
        self.see(point);
        true
    }
    fn state(&self) -> u32 {
        self.found
    }
}

/// Looks for anything nearer to a disc than a cap, but about one place.
struct Cuts<'d> {
    disc: &'d Disc,
    cap_mm: f64,
    /// The place, and how far about it is not looked, mm.
    spared: (&'d Point, f64),
    found: Option<Point>,
}

impl Visitor for Cuts<'_> {
    fn enters(&mut self, middle: &Point, sides: &[Vector; 3]) -> bool {
        let size = sides.iter().map(Vector::norm_squared).sum::<f64>().sqrt();
        let is_spared = (middle - self.spared.0).norm() + size <= self.spared.1;
        !is_spared && self.disc.least_in_box_mm(middle, sides) < self.cap_mm
    }
    fn presses(&mut self, piece: &SeenPiece) -> Option<f64> {
        if (piece.middle - self.spared.0).norm() + piece.radius <= self.spared.1 {
            return None;
        }
        let bound = self.disc.least_in_hull_mm(&piece.middle, piece.hull);
        (bound < self.cap_mm).then_some(bound)
    }
    fn takes(&mut self, point: &Point) -> bool {
        let cuts = (point - self.spared.0).norm() > self.spared.1 && self.disc.distance_mm(point) < self.cap_mm;
        self.found = self.found.or(cuts.then_some(*point));
        self.found.is_none()
    }
    fn state(&self) -> u32 {
        0
    }
}

impl<'a> DiscSearch<'a> {
    /// To a part.
    pub fn new(part: &'a Part) -> Self {
        let walker = part.exact().map(|(brep, exact)| Walker::new(exact, brep));
        DiscSearch { part, walker, published: part.published().map(|p| Box::new(DiscSearch::new(p))) }
    }

    /// The nearest point of the part, told apart to `tolerance_mm`; `None` where it is farther from
    /// the disc than `cap_mm`, or the disc is none. A disc of radius 0 is a point, and the answer
    /// that of [`Part::closest`].
    pub fn closest(&mut self, disc: &Disc, cap_mm: f64, tolerance_mm: f64) -> Option<NearDisc> {
        if disc.radius_mm == 0.0 {
            let at = self.part.closest(&disc.centre, cap_mm)?;
            return Some(NearDisc { at, on_disc: disc.centre, distance_mm: at.distance_mm, least_mm: at.distance_mm });
        }
        let finite = disc.centre.iter().chain(disc.axis.iter()).chain([&disc.radius_mm]).all(|x| x.is_finite());
        if !finite || !(disc.radius_mm > 0.0) || !(cap_mm >= 0.0) {
            return None;
        }
        // A point at the cap itself counts.
        let cap_mm = cap_mm * (1.0 + 4.0 * f64::EPSILON);
        // A place where the part is nearest among those about closes most of it.
        let about = self.part.closest(&disc.centre, cap_mm + disc.radius_mm)?;
        let first = settle(self.part, disc, disc.foot(&about.point))?;
        let best_mm = first.distance_mm.min(cap_mm + tolerance_mm);
        let mut look = Nearest { disc, tolerance_mm, best_mm, point: None, least_mm: f64::INFINITY, found: 0 };
        self.look(&mut look);
        let near = match look.point {
            Some(point) => settle(self.part, disc, disc.foot(&point))?,
            None => first,
        };
        let near = NearDisc { least_mm: look.least_mm.min(near.distance_mm), ..near };
        (near.distance_mm <= cap_mm).then_some(near)
    }

    /// A point of the part that is nearer to the disc than `cap_mm`; `spared` is a place about
    /// which it is not looked on exact faces, no farther than so much, mm. Where a query halves too
    /// many pieces without an answer, that place.
    ///
    /// A cutter touches at such a place, and to tell a touch from a cut takes most of a query.
    pub fn cut(&mut self, disc: &Disc, cap_mm: f64, spared: (&Point, f64)) -> Option<Point> {
        let mut look = Cuts { disc, cap_mm, spared, found: None };
        let own = match &mut self.walker {
            Some(walker) => {
                let done = walker.visit(&mut look, MOST_CUTS);
                look.found.or((!done).then_some(*spared.0))
            }
            None => {
                let (best_mm, least_mm) = (cap_mm, f64::INFINITY);
                let mut look = Nearest { disc, tolerance_mm: 0.0, best_mm, point: None, least_mm, found: 0 };
                on_mesh(self.part, &mut look);
                look.point
            }
        };
        own.or_else(|| self.published.as_mut()?.cut(disc, cap_mm, spared))
    }

    fn look(&mut self, look: &mut Nearest) {
        match &mut self.walker {
            Some(walker) => {
                if !walker.visit(look, MOST_CUTS) {
                    look.least_mm = look.least_mm.min(walker.left_open().unwrap_or(0.0).max(0.0));
                }
            }
            None => on_mesh(self.part, look),
        }
        if let Some(published) = &mut self.published {
            published.look(look);
        }
    }
}

/// Over the triangles of a part.
fn on_mesh(part: &Part, look: &mut Nearest) {
    let disc = look.disc;
    let found = part.bvh.tree.find_best(
        look.best_mm,
        |node, _| {
            let (lo, hi) = (node.mins(), node.maxs());
            let half = Vector::new(0.5 * (hi.x - lo.x), 0.5 * (hi.y - lo.y), 0.5 * (hi.z - lo.z));
            let middle = Point::new(lo.x + half.x, lo.y + half.y, lo.z + half.z);
            let sides = [Vector::x() * half.x, Vector::y() * half.y, Vector::z() * half.z];
            disc.least_in_box_mm(&middle, &sides)
        },
        |t, best| {
            let corners = part.mesh.corners(t as usize);
            let middle = corners[0] + ((corners[1] - corners[0]) + (corners[2] - corners[0])) / 3.0;
            if disc.least_in_hull_mm(&middle, &corners) >= best {
                return None;
            }
            let (point, d) = disc.nearest_of_triangle(&corners);
            Some((d, point))
        },
    );
    if let Some((_, (_, point))) = found {
        look.see(&point);
    }
    look.least_mm = look.least_mm.min(look.best_mm);
}

/// Follows a point of the disc to where the part is nearest to it.
fn settle(part: &Part, disc: &Disc, from: Point) -> Option<NearDisc> {
    let e = any_across(&disc.axis);
    let frame = [e, disc.axis.cross(&e)];
    // What the map moves a point by, in the disc's plane.
    let moved = |x: &Point, at: &Closest| {
        let by = disc.foot(&at.point) - x;
        frame.map(|f| f.dot(&by))
    };
    let mut x = from;
    let mut at = part.closest(&x, f64::INFINITY)?;
    let mut f = moved(&x, &at);
    // The inverse of the Jacobian of that; at first of a map to one point.
    let plain = [[-1.0, 0.0], [0.0, -1.0]];
    let mut inverse = plain;
    for _ in 0..MOST_STEPS {
        if f[0].hypot(f[1]) < SETTLED_MM {
            break;
        }
        let step = inverse.map(|row| -(row[0] * f[0] + row[1] * f[1]));
        let next = disc.foot(&(x + frame[0] * step[0] + frame[1] * step[1]));
        let next_at = part.closest(&next, f64::INFINITY)?;
        if next_at.distance_mm > at.distance_mm {
            if inverse == plain {
                // The plain map never leads farther away, but by rounding.
                break;
            }
            inverse = plain;
            continue;
        }
        let next_f = moved(&next, &next_at);
        let by = frame.map(|e| e.dot(&(next - x)));
        inverse = broyden(inverse, by, [next_f[0] - f[0], next_f[1] - f[1]]);
        (x, at, f) = (next, next_at, next_f);
    }
    Some(NearDisc { at, on_disc: x, distance_mm: at.distance_mm, least_mm: 0.0 })
}

/// The inverse after a step and what it changed, by Sherman and Morrison's formula; as before where
/// that is not known.
fn broyden(b: [[f64; 2]; 2], step: [f64; 2], change: [f64; 2]) -> [[f64; 2]; 2] {
    let by = b.map(|row| row[0] * change[0] + row[1] * change[1]);
    let row = [0, 1].map(|k| step[0] * b[0][k] + step[1] * b[1][k]);
    let size = step[0] * by[0] + step[1] * by[1];
    let off = [0, 1].map(|k| (step[k] - by[k]) / size);
    let next = [0, 1].map(|i| [0, 1].map(|j| b[i][j] + off[i] * row[j]));
    if next.iter().flatten().all(|x| x.is_finite()) { next } else { b }
}

/// A unit vector across a unit vector.
fn any_across(axis: &Vector) -> Vector {
    let other = if axis.x.abs() < 0.9 { Vector::x() } else { Vector::y() };
    axis.cross(&other).normalize()
}

#[cfg(test)]
mod tests;
