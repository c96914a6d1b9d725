//! The disc of a cutter with a corner against the part and the bodies about it.
//!
//! Facets come first, in boxes that lie flat on them ([`SphereTree`]); exact faces are asked only
//! where these are near.

use super::arcs::Witness;
use super::forbidden::Free;
use super::samples::Sample;
use super::tree::{Below, SphereTree};
use super::windows::WindowScene;
use crate::artifact::Obstacle;
use crate::error::Bound;
use crate::geometry::Point;
use crate::geometry::disc::Disc;
use crate::geometry::near_disc::DiscSearch;
use crate::geometry::part::Part;

/// Angles at which the disc is looked at are no farther apart than this, rad.
const LOOK_RAD: f64 = 0.05;
/// The disc may come nearer than its corner's radius by this, mm: a third of a micrometre is what
/// gouges are judged to.
const CUT_MM: f64 = 3e-4;
/// About its contact the disc is not looked at, as far as it rises by this on flat ground, mm:
/// what fits farther off fits there.
const RISES_MM: f64 = 0.01;

/// What the disc would cut.
#[derive(Clone, Copy)]
pub(super) struct Cut {
    /// 0: the part; else the obstacle with the number less one.
    body: u16,
    /// A point of it that is cut.
    point: Point,
}

/// The disc against the part and the bodies about it.
pub(super) struct Discs<'a> {
    scene: &'a WindowScene<'a>,
    bodies: Vec<Body<'a>>,
    /// Nodes of a tree that are still to be looked at.
    open: Vec<u32>,
}

/// The part, or a body about it.
struct Body<'a> {
    /// 0: the part; else the obstacle with the number less one.
    number: u16,
    /// Its facets, in boxes that lie flat on them.
    tree: &'a SphereTree,
    /// How far these may lie off it, mm.
    off_mm: f64,
    /// What its exact faces are asked by, where it is more than facets.
    search: Option<DiscSearch<'a>>,
    /// How near the disc may come, mm.
    near_mm: f64,
}

impl<'a> Body<'a> {
    fn new(number: u16, part: &'a Part, (tree, off_mm): (&'a SphereTree, f64), near_mm: f64) -> Self {
        let is_facets = part.exact().is_none() && part.published().is_none();
        let search = (!is_facets).then(|| DiscSearch::new(part));
        Body { number, tree, off_mm, search, near_mm }
    }

    /// A point of it that is nearer to the disc than `cap_mm`, but about a place.
    fn cut(&mut self, open: &mut Vec<u32>, disc: &Disc, cap_mm: f64, spared: (&Point, f64)) -> Option<Point> {
        let found = facet_near(self.tree, open, disc, cap_mm + self.off_mm, spared)?;
        match &mut self.search {
            Some(search) => search.cut(disc, cap_mm, spared),
            None => Some(found),
        }
    }
}

/// A point of a facet that is nearer to the disc than `cap_mm`; facets that lie within a place that
/// is spared are not looked at.
fn facet_near(
    tree: &SphereTree,
    open: &mut Vec<u32>,
    disc: &Disc,
    cap_mm: f64,
    (place, spared_mm): (&Point, f64),
) -> Option<Point> {
    open.clear();
    open.extend(tree.root());
    while let Some(index) = open.pop() {
        let node = tree.node(index);
        let is_spared = (node.centre - place).norm() + node.radius <= spared_mm;
        if is_spared || disc.least_in_box_mm(&node.centre, &node.half) >= cap_mm {
            continue;
        }
        match tree.below(index) {
            Below::Nodes(left, right) => open.extend([right, left]),
            Below::Leaf(leaf) => {
                let corners = tree.corners(leaf);
                if disc.least_in_hull_mm(&tree.sphere(leaf).0, &corners) < cap_mm {
                    let (point, distance_mm) = disc.nearest_of_triangle(&corners);
                    if distance_mm < cap_mm {
                        return Some(point);
                    }
                }
            }
        }
    }
    None
}

impl<'a> Discs<'a> {
    pub fn new(scene: &'a WindowScene<'a>) -> Self {
        let (around, corner_mm) = (scene.around, scene.tool.corner_mm());
        let part = around.trees.first().map(|tree| {
            let near_mm = corner_mm + scene.path.stock_mm - CUT_MM;
            Body::new(0, &around.blade.part, (tree, around.part_off_mm), near_mm)
        });
        let others = around.obstacles.iter().zip(around.trees.iter().skip(1)).zip(1..);
        let others = others.filter(|((o, _), _)| !o.cut_by_the_tool).map(|((o, tree), number)| {
            Body::new(number, &o.part, (tree, o.part.deflection_mm), corner_mm + o.clearance_mm)
        });
        Discs { scene, bodies: part.into_iter().chain(others).collect(), open: Vec::new() }
    }

    /// What the disc cuts at θ, if anything.
    pub fn cut_at(&mut self, s: &Sample, theta: f64) -> Option<Cut> {
        let scene = self.scene;
        let (centre, axis) = scene.centre(s, theta)?;
        let disc = scene.tool.disc(centre, axis);
        let (corner, contact) = (scene.tool.corner_mm(), s.centre - s.normal * scene.tool.corner_mm());
        let flattest_mm = corner + disc.radius_mm / axis.cross(&s.normal).norm().max(1e-3);
        let spared_mm = (2.0 * RISES_MM * flattest_mm).sqrt().min(disc.radius_mm);
        let open = &mut self.open;
        self.bodies.iter_mut().find_map(|body| {
            // About its contact it is not looked at the part: under it where stock stays there.
            let foot = contact - s.normal * scene.path.stock_mm;
            let spared_mm = if body.number == 0 { spared_mm } else { 0.0 };
            // What places between locations may lie off the path.
            let off_mm = if s.fraction > 0.0 { scene.path.chord_mm } else { 0.0 };
            let point = body.cut(open, &disc, body.near_mm - off_mm, (&foot, spared_mm))?;
            Some(Cut { body: body.number, point })
        })
    }

    /// The fixture or other body that is cut; `None`: the part itself.
    fn obstacle(&self, cut: &Cut) -> Option<&'a Obstacle> {
        usize::from(cut.body).checked_sub(1).and_then(|k| self.scene.around.obstacles.get(k))
    }

    /// The triangle that is cut.
    fn triangle(&self, cut: &Cut) -> u32 {
        let part = self.obstacle(cut).map_or(&self.scene.around.blade.part, |o| &o.part);
        part.closest_on_mesh(&cut.point, f64::INFINITY).and_then(|c| c.triangle).unwrap_or(0)
    }

    /// What stands in the way, and its name.
    pub fn bound(&self, cut: &Cut) -> (Bound, String) {
        if let Some(obstacle) = self.obstacle(cut) {
            return (Bound::Fixture { tool: "cutter".into(), name: obstacle.name.clone() }, obstacle.name.clone());
        }
        let part = &self.scene.around.blade.part;
        let face = part.face_name(part.mesh.face(self.triangle(cut) as usize)).to_string();
        (Bound::Part { tool: "cutter".into(), face: face.clone() }, face)
    }

    /// What of a free interval the disc leaves.
    pub fn clear(&mut self, s: &Sample, free: &Free) -> Vec<Free> {
        let steps = ((free.hi - free.lo) / LOOK_RAD).ceil().max(2.0) as usize;
        let at = |k: usize| if k == steps { free.hi } else { free.lo + (free.hi - free.lo) * k as f64 / steps as f64 };
        let seen: Vec<Option<Cut>> = (0..=steps).map(|k| self.cut_at(s, at(k))).collect();
        let mut out: Vec<Free> = Vec::new();
        for k in 0..=steps {
            if seen[k].is_some() {
                continue;
            }
            let goes_on = k > 0 && seen[k - 1].is_none();
            match out.last_mut() {
                Some(last) if goes_on => last.hi = at(k),
                _ => {
                    let mut new = Free { lo: at(k), hi: at(k), ..*free };
                    if let Some(cut) = k.checked_sub(1).and_then(|j| seen[j]) {
                        (new.lo, new.lo_by) = self.end(s, (at(k), at(k - 1)), cut);
                    }
                    out.push(new);
                }
            }
            if let (Some(last), Some(Some(cut))) = (out.last_mut(), seen.get(k + 1)) {
                (last.hi, last.hi_by) = self.end(s, (at(k), at(k + 1)), *cut);
            }
        }
        out.retain(|f| f.lo < f.hi);
        out
    }

    /// Where between an angle that is clear and one that is not the disc begins to cut, on the
    /// clear side, and what it cuts.
    pub fn end(&mut self, s: &Sample, (mut clear, mut taken): (f64, f64), mut cut: Cut) -> (f64, Witness) {
        let tolerance = self.scene.options.settings.tolerance_deg.to_radians();
        while (taken - clear).abs() > tolerance {
            let middle = 0.5 * (clear + taken);
            match self.cut_at(s, middle) {
                Some(found) => (taken, cut) = (middle, found),
                None => clear = middle,
            }
        }
        (clear, Witness::Cutter { body: cut.body, triangle: self.triangle(&cut) })
    }
}
