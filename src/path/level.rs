//! Points of the `R` level set of the distance to the whole part, sought along its gradient or
//! within a plane.

use super::rim::Rim;
use crate::artifact::along::Along;
use crate::geometry::allowance::Allowed;
use crate::geometry::{Point, Vector};
use crate::tool::inclination::Inclined;

/// A ball that touches the part.
#[derive(Clone, Copy, Debug)]
pub struct Touch {
    /// Ball centre, blade frame, mm.
    pub centre: Point,
    /// Contact point, mm.
    pub contact: Point,
    /// Unit vector from contact to centre.
    pub normal: Vector,
    /// Face or group that is touched.
    pub face: u32,
}

impl Touch {
    /// Cosine of the angle between the normal and the plane across the region (1: wall along it).
    pub fn cos_lean(&self, along: &Along) -> f64 {
        let [a, b] = along.frame(&self.centre).across(&self.normal);
        a.hypot(b)
    }
    /// Direction of the path in the plane across the region, counter-clockwise seen from its start;
    /// unit.
    pub fn tangent(&self, along: &Along) -> Vector {
        let frame = along.frame(&self.centre);
        let [a, b] = frame.across(&self.normal);
        frame.vector(0.0, [-b, a]) / a.hypot(b).max(1e-12)
    }
    /// Angle of the normal about the way up, rad.
    pub fn azimuth(&self, along: &Along) -> f64 {
        let [a, b] = along.frame(&self.centre).across(&self.normal);
        b.atan2(a)
    }
}

/// The level set of one part and one radius.
#[derive(Clone, Copy)]
pub struct LevelSet<'a> {
    /// The part, with the stock that is to stay on it.
    pub part: Allowed<'a>,
    /// The way along the region that is milled.
    pub along: Along,
    /// Level, mm: the radius of the ball, or of the corner that rolls over a disc.
    pub radius_mm: f64,
    /// Where the airfoil ends without a platform.
    pub rim: Option<&'a Rim>,
    /// A cutter with a corner of that radius, which leans forwards; `None`: a ball.
    pub inclined: Option<Inclined>,
    /// Height below which the ball's centre may not go, mm: the end of the region that was asked
    /// for, or −∞.
    pub lowest_mm: f64,
}

/// Residual at which a centre counts as on the level set, mm: a thousandth of the finest tolerance
/// in use.
const ON_LEVEL_MM: f64 = 1e-6;
/// Moves of a touch back to its height over a hub that turns.
const MOST_LEVELLINGS: usize = 12;
/// Newton steps before giving up; smooth places need 3, concave creases converge linearly.
const MAX_STEPS: usize = 60;

/// Where on the rim of a disc it is looked for what it cuts, rad from the contact.
const RIM_RAD: [f64; 11] = [-2.4, -1.8, -1.2, -0.7, -0.3, 0.3, 0.7, 1.2, 1.8, 2.4, std::f64::consts::PI];
/// What the rim may come nearer to the part than its corner does at the contact, mm.
const RIM_MM: f64 = 1e-3;

impl LevelSet<'_> {
    /// Whether the part is a mesh.
    pub fn is_over_facets(&self) -> bool {
        self.part.brep.is_none()
    }

    /// Whether the disc of a cutter with a corner, inclined as far as it may be less the room that
    /// θ needs, clears the part where the corner touches it. A ball always has. The rim is looked
    /// at in some places only: what the channel finds between them is refused there.
    pub fn disc_fits(&self, touch: &Touch) -> bool {
        let Some(inclined) = &self.inclined else { return true };
        let disc = inclined.disc_with_room(&touch.centre, &touch.normal);
        let to_contact = touch.centre - disc.centre;
        let aside = disc.axis.cross(&to_contact);
        let is_clear = |angle: &f64| {
            let at = disc.centre + to_contact * angle.cos() + aside * angle.sin();
            self.part.closest(&at, self.radius_mm - RIM_MM).is_none()
        };
        RIM_RAD.iter().all(is_clear)
    }

    /// Moves a guess at its own height onto the level set, see [`Self::touch_across`]: within the
    /// plane across the region, or, over a hub that turns, within the surface of that height.
    pub fn touch_in_plane(&self, guess: &Point, reach_mm: f64) -> Option<Touch> {
        let across = |q: &Point| self.touch_across(q, self.along.frame(q).up(), reach_mm);
        let mut touch = across(guess)?;
        if self.along.round().is_none() {
            return Some(touch);
        }
        // The plane leaves that surface by the square of the way.
        let height_mm = self.along.height_mm(guess);
        for _ in 0..MOST_LEVELLINGS {
            if (self.along.height_mm(&touch.centre) - height_mm).abs() <= ON_LEVEL_MM {
                break;
            }
            touch = across(&self.along.at(height_mm, &touch.centre))?;
        }
        ((touch.centre - guess).norm() <= 2.0 * reach_mm).then_some(touch)
    }

    /// Moves a guess onto the level set along the gradient of the distance,
    /// `∇d = (q − foot)/|q − foot|`. `None` where the guess would have to move by more than
    /// `reach_mm`.
    pub fn touch(&self, guess: &Point, reach_mm: f64) -> Option<Touch> {
        self.newton(guess, &Vector::zeros(), reach_mm)
    }

    /// Moves a guess within the plane through it across the unit vector `along` onto the level set
    /// by Newton steps along the in-plane gradient of the distance. In a concave crease, where two
    /// feet compete, the steps alternate between them and converge to the place where neither is
    /// nearer than `R`.
    ///
    /// `None` where the guess would have to move by more than `reach_mm` or where the wall leans
    /// over so much that the plane runs along it.
    pub fn touch_across(&self, guess: &Point, along: &Vector, reach_mm: f64) -> Option<Touch> {
        self.newton(guess, along, reach_mm)
    }

    /// Newton steps along the gradient less its part along `without`, which is a unit vector or
    /// nothing.
    fn newton(&self, guess: &Point, without: &Vector, reach_mm: f64) -> Option<Touch> {
        let mut q = *guess;
        for _ in 0..MAX_STEPS {
            let c = self.part.closest(&q, self.radius_mm + 2.0 * reach_mm + 1.0)?;
            let away = q - c.point;
            let normal = if c.distance_mm > 1e-9 * self.radius_mm { away / c.distance_mm } else { c.normal };
            let residual = self.radius_mm - c.distance_mm;
            if residual.abs() <= ON_LEVEL_MM {
                return Some(Touch { centre: q, contact: c.point, normal, face: c.face });
            }
            let gradient = normal - without * normal.dot(without);
            let slope = gradient.norm();
            if slope < 0.05 {
                return None;
            }
            // A step is exact on a plane; a ball's curvature asks for repetition. Limiting it keeps
            // far feet from throwing q.
            let step = (residual / slope).clamp(-0.5 * self.radius_mm, 0.5 * self.radius_mm);
            q += gradient * (step / slope);
            if (q - guess).norm() > reach_mm {
                return None;
            }
        }
        None
    }
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used)]
    use super::*;
    use crate::artifact::Cone;
    use crate::geometry::part::Part;
    use crate::sample;
    use crate::tool::Tool;

    /// A disc of radius `R` inclined by `α` has room in a trough of radius `ρ` where
    /// `sin α ≥ R / (ρ − r)`.
    #[test]
    fn a_disc_has_room_in_a_trough_that_is_wide_enough() {
        let tool = Tool { radius_mm: 8.0, corner_radius_mm: Some(2.0), ..sample::tool() };
        let inclined = Inclined::new(&tool, [3.0, 12.0], Cone::about_blade(0.0)).unwrap();
        let least_mm = |room_rad: f64| 2.0 + 6.0 / (12f64.to_radians() - room_rad).sin();
        let fits = |radius_mm: f64| {
            let part = Part::from_mesh(sample::trough(radius_mm, 4000));
            let level = LevelSet {
                part: Allowed::new(&part, 0.0),
                along: Along::BLADE,
                radius_mm: 2.0,
                rim: None,
                inclined: Some(inclined),
                lowest_mm: f64::NEG_INFINITY,
            };
            let towards = Point::new(0.0, 0.5, 0.75f64.sqrt()) * (radius_mm - 2.0);
            level.disc_fits(&level.touch(&towards, 1.0).unwrap())
        };
        // θ keeps 0.03 rad of room.
        assert!(fits(1.01 * least_mm(0.03)));
        assert!(!fits(0.99 * least_mm(0.03)));
        assert!(!fits(least_mm(0.0)));
    }
}
