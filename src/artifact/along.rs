//! The way along a region: what is high on it, and what leans.

use nalgebra::Matrix3;

use super::meridian::Meridian;
use crate::geometry::mesh::Mesh;
use crate::geometry::{Point, Rigid, Vector};

/// A right-handed frame of unit vectors, blade frame: up along a region, from where it ends to
/// where it begins, and two directions across.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Upright([Vector; 3]);

impl Upright {
    /// Up, a unit vector.
    pub fn up(&self) -> &Vector {
        &self.0[0]
    }

    /// Sine of the angle by which a wall with this normal leans: over 0 where it faces the start.
    pub fn lean(&self, normal: &Vector) -> f64 {
        self.0[0].dot(normal)
    }

    /// The parts of a vector across.
    pub fn across(&self, v: &Vector) -> [f64; 2] {
        [self.0[1].dot(v), self.0[2].dot(v)]
    }

    /// The vector with these parts up and across.
    pub fn vector(&self, up: f64, [a, b]: [f64; 2]) -> Vector {
        self.0[0] * up + self.0[1] * a + self.0[2] * b
    }
}

/// What is high on a region: planes across an axis, or, on the blade of an impeller, surfaces of
/// revolution that lie like nested hubs.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Along {
    /// The frame of the axis.
    straight: Upright,
    /// Heights of a blade whose hub turns, which take the place of that axis.
    round: Option<Meridian>,
}

impl Along {
    /// Along the blade axis, from root to tip.
    pub const BLADE: Along = Along {
        straight: Upright([Vector::new(1.0, 0.0, 0.0), Vector::new(0.0, 1.0, 0.0), Vector::new(0.0, 0.0, 1.0)]),
        round: None,
    };

    /// Along a unit vector.
    pub fn of(axis: Vector) -> Along {
        let first = axis.cross(&Vector::ith(axis.imin(), 1.0)).normalize();
        Along { straight: Upright([axis, first, axis.cross(&first)]), round: None }
    }

    /// Over a hub that turns; blade frame.
    pub fn over_hub(meridian: Meridian) -> Along {
        Along { round: Some(meridian), ..Along::BLADE }
    }

    /// The heights over a hub that turns; `None` where they are straight along an axis.
    pub fn round(&self) -> Option<&Meridian> {
        self.round.as_ref()
    }

    /// Heights of the centres of balls of a radius, mm. Over a hub that turns a ball on the hub has
    /// that radius as its height. `None` where none has room under the tips.
    pub fn for_ball(&self, radius_mm: f64) -> Option<Along> {
        let round = match &self.round {
            Some(meridian) => Some(meridian.for_ball(radius_mm)?),
            None => None,
        };
        Some(Along { round, ..*self })
    }

    /// The frame at a place.
    pub fn frame(&self, p: &Point) -> Upright {
        self.round.as_ref().map_or(self.straight, |m| Upright(m.directions(p)))
    }

    /// Height of a point, mm.
    pub fn height_mm(&self, p: &Point) -> f64 {
        self.round.as_ref().map_or_else(|| self.straight.up().dot(&p.coords), |m| m.height_mm(p))
    }

    /// The point at another height, mm, straight up or down from there.
    pub fn at(&self, height_mm: f64, p: &Point) -> Point {
        match &self.round {
            Some(meridian) => meridian.at(height_mm, p),
            None => self.straight.vector(height_mm, self.straight.across(&p.coords)).into(),
        }
    }

    /// A mesh of the blade frame as seen in the frame of a straight axis, with heights along x.
    pub fn seen(&self, mesh: &Mesh) -> Mesh {
        let turn = nalgebra::Rotation3::from_matrix_unchecked(Matrix3::from_columns(&self.straight.0).transpose());
        mesh.clone().moved(&Rigid::from_parts(Vector::zeros().into(), turn.into()))
    }

    /// That of the mirror image of the part across z = 0.
    #[must_use]
    pub fn mirrored(&self) -> Along {
        let [axis, first, second] = self.straight.0.map(|v| Vector::new(v.x, v.y, -v.z));
        Along { straight: Upright([axis, first, -second]), round: self.round.as_ref().map(Meridian::mirrored) }
    }
}

/// Points of a contour in files.
const CONTOUR_POINTS: usize = 33;

/// In files, its axis; over a hub that turns the contours of hub and tips, along the rotor axis and
/// radius, mm.
impl serde::Serialize for Along {
    fn serialize<S: serde::Serializer>(&self, to: S) -> Result<S::Ok, S::Error> {
        let Some(meridian) = &self.round else { return self.straight.up().serialize(to) };
        let contours = [("hub_mm", 0), ("tip_mm", 1)];
        to.collect_map(contours.map(|(name, which)| (name, meridian.contour(which, CONTOUR_POINTS))))
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
            (blade.height_mm(&p), blade.frame(&p).lean(&p.coords), blade.at(7.7, &p)),
            (p.x, p.x, Point::new(7.7, p.y, p.z))
        );
        assert_eq!(blade.mirrored(), blade);
        for axis in [Vector::y(), Vector::new(-0.6, 0.0, 0.8), Vector::new(1.0, 2.0, 3.0).normalize()] {
            for along in [Along::of(axis), Along::of(axis).mirrored()] {
                let [a, b, c] = along.straight.0;
                assert!((a.cross(&b) - c).norm() < 1e-15 && (along.at(2.0, &p) - p).cross(&a).norm() < 1e-15);
            }
        }
        let mesh = Mesh { points: vec![p], ..Mesh::default() };
        let along = Along::of(Vector::new(0.36, 0.48, 0.8));
        assert!((along.seen(&mesh).points[0].x - along.height_mm(&p)).abs() < 1e-15);
    }
}
