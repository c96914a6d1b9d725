//! Where a path may go, and what ends it: the boundaries of its region as bounds for the ball that
//! touches the part.
//!
//! Another kind of boundary is one more case of [`Bounds::hold`] and [`Bounds::why`]. Turns at
//! constant heights alone count on starts and ends at heights.

use super::level::Touch;
use super::rim::Rim;
use crate::artifact::along::Along;
use crate::artifact::region::Boundary;
use crate::geometry::Point;

/// What ends a path.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Stop {
    /// The region's lower end, or as far up as a path may go.
    Height,
    /// A wall that leans over too much, met at this contact.
    Lean(Point),
    /// A sharp edge of the part: farther on the ball would only roll over it, at this contact.
    Edge(Point),
    /// A face that ends the region, with the contact on it.
    Face(Point, u32),
    /// The rim at which the airfoil ends without a platform, with the contact there.
    Rim(Point),
    /// Two walls at once, of which the farther one leans over too much: its contact.
    Corner(Point),
    /// A cutter with a corner would cut the part beside its contact, farther on than this one.
    Disc(Point),
}

/// Turn of the normal in a step of a walk, rad.
pub(super) const STEP_RAD: f64 = 0.15;

/// Where a path may go.
#[derive(Clone, Copy, Debug)]
pub struct Bounds<'a> {
    /// The way along the region.
    pub along: Along,
    /// Least and greatest height of the ball centre, mm.
    pub x_mm: [f64; 2],
    /// Greatest sine of the angle by which a wall leans towards the region's start, or, round a
    /// lower edge, away from it.
    pub max_sin_lean: f64,
    /// Where the region ends, its heights and rim besides.
    pub ends: &'a [Boundary],
    /// The rim that may not be touched.
    pub rim: Option<&'a Rim>,
    /// Whether the disc of a cutter with a corner must have room at the part. To look at that takes
    /// long: it is done once for each neighbour that is found, and not by [`Bounds::hold`] for each
    /// place on the way to it.
    pub disc_fits: bool,
}

impl<'a> Bounds<'a> {
    /// The bounds that the ends of a region set to the places of a path.
    pub fn of(along: Along, ends: &'a [Boundary], rim: Option<&'a Rim>, max_lean_rad: f64) -> Bounds<'a> {
        Bounds {
            along,
            x_mm: [lowest_mm(ends), f64::INFINITY],
            max_sin_lean: max_lean_rad.sin(),
            ends,
            rim,
            disc_fits: false,
        }
    }

    /// No bounds.
    pub(super) const NONE: Bounds<'static> = Bounds {
        along: Along::BLADE,
        x_mm: [f64::NEG_INFINITY, f64::INFINITY],
        max_sin_lean: f64::INFINITY,
        ends: &[],
        rim: None,
        disc_fits: false,
    };

    /// Whether a touch is on a face that may not be touched.
    fn is_on_end_face(&self, t: &Touch) -> bool {
        let marks = |end: &Boundary| match end {
            Boundary::Faces(flags) => flags.get(t.face as usize).copied().unwrap_or(false),
            Boundary::Height(_) | Boundary::Rim(_) => false,
        };
        self.ends.iter().any(marks)
    }

    /// Whether a touch is within.
    pub fn hold(&self, t: &Touch) -> bool {
        (self.x_mm[0]..=self.x_mm[1]).contains(&self.along.height_mm(&t.centre))
            && self.lean(t).abs() <= self.max_sin_lean
            && !self.is_on_end_face(t)
            && !self.is_at_rim(t)
    }

    /// Sine of the lean of the wall at a touch.
    fn lean(&self, t: &Touch) -> f64 {
        self.along.frame(&t.centre).lean(&t.normal)
    }

    /// Whether a touch is at the rim that may not be touched.
    fn is_at_rim(&self, t: &Touch) -> bool {
        self.rim.is_some_and(|r| r.is_near(&t.contact))
    }

    /// Why the path stops between two touches, the second of which is out of bounds.
    pub(super) fn why(&self, inside: &Touch, outside: &Touch) -> Stop {
        if self.is_on_end_face(outside) {
            Stop::Face(outside.contact, outside.face)
        } else if self.is_at_rim(outside) {
            Stop::Rim(outside.contact)
        } else if self.lean(outside).abs() <= self.max_sin_lean {
            Stop::Height
        } else if inside.normal.dot(&outside.normal) < STEP_RAD.cos() {
            Stop::Corner(outside.contact)
        } else {
            Stop::Lean(outside.contact)
        }
    }
}

/// The highest of the heights at which a region ends, mm: the ball's centre may not go below it; −∞
/// where there is none.
pub fn lowest_mm(ends: &[Boundary]) -> f64 {
    let heights = ends.iter().filter_map(|end| match end {
        Boundary::Height(x_mm) => Some(*x_mm),
        Boundary::Rim(_) | Boundary::Faces(_) => None,
    });
    heights.fold(f64::NEG_INFINITY, f64::max)
}
