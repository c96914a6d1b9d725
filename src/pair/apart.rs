//! How far two tools that stand at opposite places are apart, at least.

use crate::artifact::cone::Cone;
use crate::artifact::paired::PairPlace;
use crate::geometry::{Point, Vector};
use crate::tool::{Segment, Tool, lowest_mm};

/// Two tools over one angle of the table.
pub struct Both {
    radius_mm: [f64; 2],
    segments: [Vec<Segment>; 2],
    cones: [Cone; 2],
    /// What tool 2's angle is over tool 1's, rad.
    between_rad: f64,
    /// Distances of the farthest points of both tools from their ball centres, added up, mm.
    reach_mm: f64,
}

/// Room between two tools.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Apart {
    /// The tools are nowhere nearer to each other than this, mm; negative where no plane is known
    /// that lies between them.
    pub least_mm: f64,
    /// Unit direction, from tool 2 to tool 1, square to the plane between them.
    pub across: Vector,
}

impl Both {
    /// Tool 1 and tool 2 with the cones of their axes; tool 2's angle is the table's plus
    /// `between_rad`.
    pub fn new(tools: [&Tool; 2], cones: [Cone; 2], between_rad: f64) -> Self {
        let reach_mm = tools.map(Tool::reach_mm).into_iter().sum();
        let (radius_mm, segments) = (tools.map(|t| t.radius_mm), tools.map(Tool::segments));
        Both { radius_mm, segments, cones, between_rad, reach_mm }
    }

    /// Both tool axes at an angle of the table, rad.
    pub fn axes(&self, theta_rad: f64) -> [Vector; 2] {
        [self.cones[0].tool_axis(theta_rad), self.cones[1].tool_axis(theta_rad + self.between_rad)]
    }

    /// How far both are apart on the straight moves from a place to the next, while the table turns
    /// from one angle to the other, by planes between them: the one midway between the sides of the
    /// blade, those square to the line from ball to ball and to the difference of the tool axes,
    /// and the mean of the first and the last. A plane that lies between them at both ends does so
    /// all the way, but for what points of turning tools leave the chord of their arcs by.
    pub fn apart(&self, places: [&PairPlace; 2], theta_rad: [f64; 2]) -> Apart {
        let [axes, next] = theta_rad.map(|theta| self.axes(theta));
        let turned = theta_rad[1] - theta_rad[0];
        let off_mm = if turned == 0.0 { 0.0 } else { self.reach_mm * turned * turned / 8.0 };
        let [one, two] = &places[0].contacts;
        let normals = one.normal - two.normal;
        let (balls, leans) = (one.centre - two.centre, axes[0] - axes[1]);
        let unit = |v: Vector| v.try_normalize(1e-9);
        let mean = unit(normals).unwrap_or_default() + unit(leans).unwrap_or_default();
        let none = Apart { least_mm: f64::NEG_INFINITY, across: Vector::zeros() };
        [normals, balls, leans, mean].into_iter().filter_map(unit).fold(none, |best, across| {
            // Of tool 1 what lies lowest along the direction, of tool 2 what lies highest.
            let room = |place: &PairPlace, axes: &[Vector; 2]| {
                let least = self.lowest_mm(0, &place.contacts[0].centre, &axes[0], &across);
                least + self.lowest_mm(1, &place.contacts[1].centre, &axes[1], &-across)
            };
            let least_mm = room(places[0], &axes).min(room(places[1], &next)) - off_mm;
            if least_mm > best.least_mm { Apart { least_mm, across } } else { best }
        })
    }

    /// How low a tool comes along a unit direction, mm.
    fn lowest_mm(&self, tool: usize, centre: &Point, axis: &Vector, along: &Vector) -> f64 {
        lowest_mm(&self.segments[tool], self.radius_mm[tool], centre, axis, along)
    }
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used)]
    use std::f64::consts::PI;

    use proptest::prelude::*;

    use super::*;
    use crate::artifact::paired::BallContact;
    use crate::tool::HolderStage;

    fn tool(radius_mm: f64) -> Tool {
        Tool {
            radius_mm,
            corner_radius_mm: None,
            taper_deg: 3.0,
            shank_radius_mm: radius_mm + 2.0,
            stickout_mm: 50.0,
            holder: vec![HolderStage { radius_mm: 20.0, length_mm: 40.0 }],
        }
    }

    fn place(thickness_mm: f64, radii: [f64; 2]) -> PairPlace {
        let contact = |side: f64, r: f64| {
            let normal = Vector::y() * side;
            let contact = Point::from(normal * 0.5 * thickness_mm);
            BallContact { centre: contact + normal * r, contact, normal, face: 0 }
        };
        PairPlace {
            contacts: [contact(1.0, radii[0]), contact(-1.0, radii[1])],
            held_centre: Point::origin(),
            held_radius_mm: 0.5 * thickness_mm,
            angle_rad: 0.0,
            apart_mm: 0.0,
        }
    }

    #[test]
    fn upright_tools_on_a_plate_are_its_thickness_apart() {
        let tools = [tool(4.0), tool(6.0)];
        let cones = [Cone::about_blade(0.1), Cone::about_blade(0.2)];
        let both = Both::new([&tools[0], &tools[1]], cones, PI);
        let plate = place(3.0, [4.0, 6.0]);
        let found = both.apart([&plate, &plate], [0.0; 2]);
        assert!((found.least_mm - 3.0).abs() < 1e-12, "{found:?}");
        // Lying down, the shanks are through the plate.
        assert!(both.apart([&plate, &plate], [0.5 * PI; 2]).least_mm < 0.0);
    }

    proptest! {
        /// No two points of the tools' surfaces are nearer than that.
        #[test]
        fn no_points_are_nearer(
            theta in -3.2f64..3.2, thickness in 1.0f64..60.0, b1 in -0.3f64..0.3, b2 in -0.3f64..0.3, delta in 2.6f64..3.7,
            turn in prop::sample::select(vec![0.0, 0.02, -0.3, 0.6]), share in 0.0f64..1.0
        ) {
            let tools = [tool(4.0), tool(6.0)];
            let cones = [Cone::about_blade(b1), Cone::about_blade(b2)];
            let both = Both::new([&tools[0], &tools[1]], cones, delta);
            let place = place(thickness, [4.0, 6.0]);
            let found = both.apart([&place, &place], [theta, theta + turn]);
            let axes = both.axes(theta + share * turn);
            let points = |k: usize| -> Vec<Point> {
                let (c, a) = (place.contacts[k].centre, axes[k]);
                let e = a.cross(&Vector::new(0.3, 0.5, 0.8)).normalize();
                let f = a.cross(&e);
                let mut out: Vec<Point> = [e, -e, f, -f, -a].iter().map(|v| c + v * both.radius_mm[k]).collect();
                for s in &both.segments[k] {
                    for n in 0..24 {
                        let (sin, cos) = (PI * f64::from(n) / 12.0).sin_cos();
                        out.extend([(s.z0, s.r0), (s.z1, s.r1)].map(|(z, r)| c + a * z + (e * cos + f * sin) * r));
                    }
                }
                out
            };
            let (one, two) = (points(0), points(1));
            let least = one.iter().flat_map(|p| two.iter().map(move |q| (p - q).norm())).fold(f64::INFINITY, f64::min);
            prop_assert!(found.least_mm <= least + 1e-9, "{found:?} {least}");
        }
    }
}
