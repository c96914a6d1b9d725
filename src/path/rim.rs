//! The rim at which an airfoil without a platform ends: beyond it there is only the cap that closes
//! it, round which a ball would roll.
//!
//! In: the part's mesh. Out: the edges near the airfoil's foot at which its wall turns sharply
//! towards the root, and those at which it ends in an opening, as points so near to one another
//! that a contact at the rim is near one. A foot that is rounded has none; there the lean of the
//! wall ends the path.

use std::collections::HashSet;

use super::options::PathOptions;
use super::span_mm;
use crate::artifact::Blade;
use crate::artifact::along::Upright;
use crate::artifact::region::{Boundary, Region};
use crate::geometry::mesh::edge_uses;
use crate::geometry::{Point, Vector};

/// Edges at which the surface turns by more than this are sharp (cosine of 34°, as where a ball
/// rolls over an edge).
const SHARP: f64 = 0.83;
/// A cap faces the root by more than this (sine of 60°, the lean that ends a path unless another is
/// asked for): what leans less is a wall, and turns go over it, as over the end of a slanted or
/// twisted foot …
const FACES_ROOT: f64 = 0.866;
/// … and by so much more than the wall at it …
const MORE: f64 = 0.3;
/// … which leans by less than this (sine of 50°).
const WALL: f64 = 0.77;
/// A level rim lies within this share of the airfoil's height from its foot; one that slants, as
/// far above the whole sections' end as the part goes on below it, and so much more. Creases
/// farther up are folds of the wall.
const LOWEST: f64 = 0.02;
/// A contact at the rim is within this share of the ball radius.
const NEAR: f64 = 0.01;
/// Cells along an edge at most: a part of nothing but huge triangles.
const MOST_CELLS: f64 = 1e5;

/// Places at the rim.
#[derive(Clone, Debug)]
pub struct Rim {
    near_mm: f64,
    cells: HashSet<[i64; 3]>,
}

impl Rim {
    /// The rim of a region, for the ball and the stock that is to stay on the part; `None` where
    /// neither the region nor the path is to end at one, or no sharp edge is there.
    pub fn of(blade: &Blade, region: &Region, options: &PathOptions) -> Option<Rim> {
        let mut ends = region.end.iter().chain(&options.extent.ends);
        if !ends.any(|end| matches!(end, Boundary::Rim(_))) {
            return None;
        }
        let [a, b] = region.x_mm()?;
        let slant_mm = (a - span_mm(blade, region)[0]).max(0.0).min(0.3 * (b - a));
        let (mesh, highest) = (&blade.part.mesh, a + slant_mm + LOWEST * (b - a));
        let near_mm = NEAR * options.radius_mm + 2.0 * blade.part.deflection_mm + options.settings.stock_mm;
        let mut rim = Rim { near_mm, cells: HashSet::new() };
        for group in edge_uses(&mesh.triangles).chunk_by(|a, b| a.edge == b.edge) {
            let [p, q] = group[0].edge.map(|v| mesh.points[v as usize]);
            let heights = [p, q].map(|p| region.along.height_mm(&p));
            if heights[0].max(heights[1]) > highest {
                continue;
            }
            let normals: Vec<Vector> = group.iter().map(|u| mesh.normal(u.triangle as usize)).collect();
            let ends = match &normals[..] {
                [wall] => {
                    region.along.frame(&p).lean(wall).abs() < WALL
                        && (heights[0] - heights[1]).abs() < WALL * (p - q).norm()
                }
                all => all.iter().any(|wall| all.iter().any(|cap| ends_at(&region.along.frame(&p), wall, cap))),
            };
            if ends {
                rim.add(&p, &q);
            }
        }
        (!rim.cells.is_empty()).then_some(rim)
    }

    /// Whether a contact is at the rim.
    pub fn is_near(&self, contact: &Point) -> bool {
        self.cells.contains(&self.cell(contact))
    }

    fn cell(&self, p: &Point) -> [i64; 3] {
        [p.x, p.y, p.z].map(|v| (v / self.near_mm).floor() as i64)
    }

    /// All cells within reach of an edge.
    fn add(&mut self, p: &Point, q: &Point) {
        let steps = (2.0 * (q - p).norm() / self.near_mm).ceil().clamp(1.0, MOST_CELLS);
        for k in 0..=steps as u32 {
            let [x, y, z] = self.cell(&(p + (q - p) * (f64::from(k) / steps)));
            for dx in -1..=1 {
                for dy in -1..=1 {
                    self.cells.extend((-1..=1).map(|dz| [x + dx, y + dy, z + dz]));
                }
            }
        }
    }
}

/// Whether a wall ends at a cap in a sharp edge.
fn ends_at(at: &Upright, wall: &Vector, cap: &Vector) -> bool {
    let [of_wall, of_cap] = [wall, cap].map(|normal| at.lean(normal));
    wall.dot(cap) < SHARP && of_wall.abs() < WALL && of_cap < -FACES_ROOT && of_cap < of_wall - MORE
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used)]
    use std::f64::consts::TAU;

    use super::*;
    use crate::artifact::blade::{Diagnosis, Unit};
    use crate::artifact::region::{Extent, Regions};
    use crate::artifact::toolpath::PathKind;
    use crate::geometry::Rigid;
    use crate::geometry::mesh::Mesh;
    use crate::geometry::part::Part;
    use crate::observe::Silent;
    use crate::path::plan;

    fn rim_of(blade: &Blade) -> Option<Rim> {
        Rim::of(blade, &blade.regions.list[0], &PathOptions::new(2.0, 0.2))
    }

    const LENGTH: f64 = 60.0;

    /// An elliptic column along x without a platform, closed at both ends; its foot slants by
    /// `slope` along y.
    fn column(slope: f64, capped: bool) -> Blade {
        let (n, layers) = (96u32, 20u32);
        let mut mesh = Mesh::default();
        for l in 0..=layers {
            let share = f64::from(l) / f64::from(layers);
            mesh.points.extend((0..n).map(|k| {
                let (s, c) = (TAU * f64::from(k) / f64::from(n)).sin_cos();
                Point::new(LENGTH * share + slope * 15.0 * c * (1.0 - share), 15.0 * c, 4.0 * s)
            }));
        }
        for l in 0..layers {
            for k in 0..n {
                let (a, b) = (l * n + k, l * n + (k + 1) % n);
                mesh.triangles.extend([[a, b, b + n], [a, b + n, a + n]]);
            }
        }
        let foot = mesh.points.len() as u32;
        mesh.points.extend([Point::new(0.0, 0.0, 0.0), Point::new(LENGTH, 0.0, 0.0)]);
        for k in 0..n {
            let (a, b) = (k, (k + 1) % n);
            if capped {
                mesh.triangles.push([foot, b, a]);
            }
            mesh.triangles.push([foot + 1, layers * n + a, layers * n + b]);
        }
        let low = 15.0 * slope;
        Blade {
            name: "column".into(),
            unit: Unit::Mm,
            part: Part::from_mesh(mesh),
            model_from_blade: Rigid::identity(),
            regions: Regions::at_heights([-low, LENGTH], [low, LENGTH], None),
            wheel: None,
            diagnosis: Diagnosis::default(),
        }
    }

    /// No turn rolls round the foot of an airfoil without a platform, level or slanted, with a cap
    /// or open, and the reason is the rim.
    #[test]
    fn turns_end_at_the_rim() {
        for (slope, capped) in [(0.0, true), (0.0, false), (0.2, true)] {
            let blade = column(slope, capped);
            for kind in [PathKind::ConstantHeight, PathKind::ConstantScallop] {
                let what = format!("slope {slope}, capped {capped}, {kind:?}");
                let start = 15.0 * slope + 3.0;
                let options = PathOptions { extent: Extent::heights(Some(start), None), ..PathOptions::new(2.0, 0.2) }
                    .with(|s| s.kind = kind);
                let path = plan(&blade, &options, &Silent).unwrap_or_else(|e| panic!("{what}: {e}"));
                for l in &path.locations {
                    let contact = l.centre - l.normal * 2.0;
                    assert!(
                        l.normal.x > -0.05,
                        "{what}: the ball rolls round the rim at {contact}, normal {}",
                        l.normal
                    );
                    assert!(contact.x > slope * contact.y - 0.01, "{what}: contact {contact} is below the rim");
                }
                let lowest = path.locations.iter().map(|l| l.centre.x).fold(f64::INFINITY, f64::min);
                let rim = if kind == PathKind::ConstantHeight { 15.0 * slope } else { -15.0 * slope };
                assert!(lowest < rim + 1.0, "{what}: the lowest ball is at {lowest}, the rim at {rim}");
                assert!(path.end_reason.to_string().contains("without a platform"), "{what}: {}", path.end_reason);
            }
        }
    }

    #[test]
    fn a_platform_or_a_rounded_foot_has_no_rim() {
        let mut blade = column(0.0, true);
        assert!(rim_of(&blade).is_some_and(|r| r.is_near(&Point::new(0.0, 15.0, 0.0))));
        assert!(rim_of(&blade).is_some_and(|r| !r.is_near(&Point::new(0.5, 15.0, 0.0))));
        // A crease of the wall above a level foot is no rim.
        let n = 96;
        blade.part.mesh.points[3 * n..4 * n].iter_mut().for_each(|p| (p.y, p.z) = (1.4 * p.y, 1.4 * p.z));
        assert!(rim_of(&blade).is_some_and(|r| !r.is_near(&blade.part.mesh.points[3 * n])));
        blade.regions = Regions::at_heights(blade.regions.part_x_mm, blade.regions.airfoil_x_mm(), Some(0.0));
        assert!(rim_of(&blade).is_none());
        // Where a foot is cut off at 75° from the axis it has a rim; at 50° the cut is a wall.
        let cut_at = |from_axis_deg: f64| column(1.0 / from_axis_deg.to_radians().tan(), true);
        assert!(rim_of(&cut_at(75.0)).is_some());
        assert!(rim_of(&cut_at(50.0)).is_none());
    }
}
