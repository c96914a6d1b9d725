//! The way along a region: what is high on it, and what leans.

use nalgebra::Matrix3;

use crate::geometry::mesh::Mesh;
use crate::geometry::{Point, Rigid, Vector};

/// A right-handed frame of unit vectors, blade frame: the axis of a region, from where it ends to
/// where it begins, and two directions across it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Along([Vector; 3]);

impl Along {
    /// Along the blade axis, from root to tip.
    pub const BLADE: Along =
        Along([Vector::new(1.0, 0.0, 0.0), Vector::new(0.0, 1.0, 0.0), Vector::new(0.0, 0.0, 1.0)]);

    /// Along a unit vector.
    pub fn of(axis: Vector) -> Along {
        let first = axis.cross(&Vector::ith(axis.imin(), 1.0)).normalize();
        Along([axis, first, axis.cross(&first)])
    }

    /// The axis, a unit vector.
    pub fn axis(&self) -> &Vector {
        &self.0[0]
    }

    /// Height of a point, mm.
    pub fn height_mm(&self, p: &Point) -> f64 {
        self.0[0].dot(&p.coords)
    }

    /// Sine of the angle by which a wall with this normal leans: over 0 where it faces the start.
    pub fn lean(&self, normal: &Vector) -> f64 {
        self.0[0].dot(normal)
    }

    /// The parts of a vector across the axis.
    pub fn across(&self, v: &Vector) -> [f64; 2] {
        [self.0[1].dot(v), self.0[2].dot(v)]
    }

    /// The vector with these parts along the axis and across it.
    pub fn vector(&self, along: f64, [a, b]: [f64; 2]) -> Vector {
        self.0[0] * along + self.0[1] * a + self.0[2] * b
    }

    /// The point at another height, mm, straight along the axis.
    pub fn at(&self, height_mm: f64, p: &Point) -> Point {
        self.vector(height_mm, self.across(&p.coords)).into()
    }

    /// A mesh of the blade frame as seen in this frame, with heights along x.
    pub fn seen(&self, mesh: &Mesh) -> Mesh {
        let turn = nalgebra::Rotation3::from_matrix_unchecked(Matrix3::from_columns(&self.0).transpose());
        mesh.clone().moved(&Rigid::from_parts(Vector::zeros().into(), turn.into()))
    }

    /// That of the mirror image of the part across z = 0.
    #[must_use]
    pub fn mirrored(&self) -> Along {
        let [axis, first, second] = self.0.map(|v| Vector::new(v.x, v.y, -v.z));
        Along([axis, first, -second])
    }
}

/// In files, its axis.
impl serde::Serialize for Along {
    fn serialize<S: serde::Serializer>(&self, to: S) -> Result<S::Ok, S::Error> {
        self.axis().serialize(to)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn frames_are_right_handed_and_that_of_the_blade_changes_no_bit() {
        let p = Point::new(0.1, -2.3, 1e-9);
        let blade = Along::BLADE;
        assert_eq!(
            (blade.height_mm(&p), blade.lean(&p.coords), blade.at(7.7, &p)),
            (p.x, p.x, Point::new(7.7, p.y, p.z))
        );
        assert_eq!(blade.mirrored(), blade);
        for axis in [Vector::y(), Vector::new(-0.6, 0.0, 0.8), Vector::new(1.0, 2.0, 3.0).normalize()] {
            for along in [Along::of(axis), Along::of(axis).mirrored()] {
                let [a, b, c] = along.0;
                assert!((a.cross(&b) - c).norm() < 1e-15 && (along.at(2.0, &p) - p).cross(&a).norm() < 1e-15);
            }
        }
        let mesh = Mesh { points: vec![p], ..Mesh::default() };
        let along = Along::of(Vector::new(0.36, 0.48, 0.8));
        assert!((along.seen(&mesh).points[0].x - along.height_mm(&p)).abs() < 1e-15);
    }
}
