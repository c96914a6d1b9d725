//! The frame of a cone, in which the search looks at the bodies.

use crate::artifact::Cone;
use crate::geometry::Vector;

/// The frame of a cone: its axis, its reference, and what is square to both.
#[derive(Clone, Copy, Debug)]
pub(super) struct Sight {
    /// `None`: the blade frame itself.
    rows: Option<[Vector; 3]>,
}

impl Sight {
    pub fn of(cone: &Cone) -> Self {
        let rows = [cone.axis, cone.reference, cone.axis.cross(&cone.reference)];
        Sight { rows: (!cone.is_about_blade()).then_some(rows) }
    }

    /// The axes of the frame in the blade frame; `None`: it is the blade frame.
    pub fn rows(&self) -> Option<&[Vector; 3]> {
        self.rows.as_ref()
    }

    /// A vector of the blade frame in this one.
    #[inline]
    pub fn seen(&self, v: &Vector) -> Vector {
        self.rows.as_ref().map_or(*v, |[c, e, f]| Vector::new(c.dot(v), e.dot(v), f.dot(v)))
    }

    /// Vectors of the blade frame in this one.
    pub fn all_seen(&self, v: &[Vector; 3]) -> [Vector; 3] {
        if self.rows.is_none() { *v } else { v.map(|v| self.seen(&v)) }
    }

    /// A vector of this frame in the blade frame.
    pub fn unseen(&self, v: &Vector) -> Vector {
        self.rows.as_ref().map_or(*v, |[c, e, f]| c * v.x + e * v.y + f * v.z)
    }
}
