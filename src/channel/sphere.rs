//! The free tool axes at a place, all over the sphere.
//!
//! A point of a body at `v` from the ball centre is inside a part of the tool with the unit axis
//! `a` exactly where its height `v·a` lies in the interval that [`super::profile`] gives: on the
//! sphere of axes an annulus about `v`, a cap where the interval reaches up to `|v|`. The free set
//! is what no annulus holds, within the annulus about the surface normal that the contact angle
//! allows. (Circles of the sphere are cones, see [`super::track`]; the reference planes of Chen, Xu
//! and Tang, Journal of Computational Design and Engineering 2, 2015, are great circles of it.)
//!
//! The sphere is cut into spherical triangles, each within `ρ` of its middle. Such a cell is
//!
//! - **taken** where one point's annulus holds all of it;
//! - **free** where every node of the bodies' trees is clear: its margin at the cell's middle,
//!   bounded from below by tangent planes, is more than what it may fall by as the tool turns by
//!   `ρ`. Points within `r` of `v` move by no more than `2 sin(ρ/2) (|v| + r)`; and along the
//!   slope `g` of a tangent plane by no more than `ρ |v × g| + ρ² |v| / 2`, which is little where
//!   the tool passes beside the contact;
//! - else it is quartered, down to a size that is asked for; cells of that size stay **open**.
//!
//! Nodes that are clear for a cell are clear for its quarters, and annuli that do not meet it do
//! not meet them: both lists become shorter on the way down. Points that were found at one place
//! are looked at first at the next.
//!
//! **Guaranteed**: with an axis of a free cell no point of a body's mesh is nearer to taper, shank
//! or holder than its clearance plus the mesh's deflection; with one of a taken cell some point
//! is, or the contact angle is out of its range. **Not looked at**: whether the machine reaches an
//! axis, and moves between places.

use std::collections::BinaryHeap;
use std::f64::consts::PI;

use crate::artifact::Toolpath;
use crate::artifact::sphere::{self, CellState, FreeSphere, SphereCell};
use crate::error::{Error, Result, Stage};
use crate::geometry::{Point, Vector};
use crate::observe::Observer;
use crate::parallel;
use crate::tool::Tool;

use super::arcs::Witness;
use super::bound;
use super::clear;
use super::forbidden::{ObstacleScene, Start};
use super::options::ChannelOptions;
use super::profile::HeightRange;
use super::tree;
use super::{Surroundings, check_input, walls};

/// A node is opened where its radius is more than this share of what its points move by.
const FINER: f64 = 1.0;
/// Places that one thread works on in a row; fixed, so that the result does not depend on the
/// number of threads.
const BATCH: usize = 16;
/// Points that are carried from place to place.
const CARRIED: usize = 160;
/// Annuli of points found last that are looked at first.
const RECENT: usize = 16;
/// Nodes that are looked below in search of one more point.
const PROBES: usize = 24;
/// Cells may be as small as this, and the first ones are no larger, degrees.
const SIZES_DEG: [f64; 2] = [0.05, 20.0];

/// The free tool axes at every location of a path; the cones of the path are not looked at. Cells
/// lie within `finest_deg` of their middle where it is not known whether all of them is free.
///
/// # Errors
/// Kind `Usage` for impossible options, tool or size; `Cancelled`.
pub fn spheres(
    surroundings: &Surroundings,
    tool: &Tool,
    path: &Toolpath,
    options: &ChannelOptions,
    finest_deg: f64,
    observer: &dyn Observer,
) -> Result<Vec<FreeSphere>> {
    check_input(tool, path, options)?;
    check_size(finest_deg)?;
    let scene = surroundings.scene(tool, options);
    let done = std::sync::atomic::AtomicUsize::new(0);
    let all: Vec<Vec<FreeSphere>> = parallel::try_map(path.locations.chunks(BATCH), |batch| {
        observer.check(Stage::Channel)?;
        let mut search = SphereSearch::new(&scene, finest_deg.to_radians());
        let found = batch.iter().map(|l| search.at(&l.centre, &l.normal)).collect();
        let so_far = done.fetch_add(batch.len(), std::sync::atomic::Ordering::Relaxed) + batch.len();
        observer.progress(Stage::Channel, so_far, path.locations.len());
        Ok(found)
    })?;
    Ok(all.into_iter().flatten().collect())
}

/// The free tool axes at one location.
///
/// # Errors
/// As [`spheres`], and where the path has no such location.
pub fn sphere(
    surroundings: &Surroundings,
    tool: &Tool,
    (path, row): (&Toolpath, usize),
    options: &ChannelOptions,
    finest_deg: f64,
) -> Result<FreeSphere> {
    check_input(tool, path, options)?;
    check_size(finest_deg)?;
    let Some(at) = path.locations.get(row) else {
        let message = format!("location {row} is asked for, the path has {}, from 0 up", path.locations.len());
        return Err(Error::usage(Stage::Channel, message));
    };
    let scene = surroundings.scene(tool, options);
    Ok(SphereSearch::new(&scene, finest_deg.to_radians()).at(&at.centre, &at.normal))
}

fn check_size(finest_deg: f64) -> Result<()> {
    let [least, most] = SIZES_DEG;
    if (least..=most).contains(&finest_deg) {
        return Ok(());
    }
    let message = format!("cells of {finest_deg}° are asked for, they must be of {least}° to {most}°");
    Err(Error::usage(Stage::Channel, message))
}

/// What a point forbids: the axes between two angles from a direction.
#[derive(Clone, Copy)]
struct Annulus {
    direction: Vector,
    /// Least and greatest angle, rad; all up to the one, or from the other on, where the annulus is
    /// a cap.
    from: f64,
    to: f64,
    /// Of the search's points.
    point: u32,
    by: Witness,
}

impl Annulus {
    fn angle_to(&self, axis: &Vector) -> f64 {
        self.direction.dot(axis).clamp(-1.0, 1.0).acos()
    }

    /// Whether it holds some of the axes within `rho` of one.
    fn meets(&self, axis: &Vector, rho: f64) -> bool {
        let angle = self.angle_to(axis);
        angle >= self.from - rho && angle <= self.to + rho
    }

    /// Whether it holds all axes within `rho` of one.
    fn holds(&self, axis: &Vector, rho: f64) -> bool {
        let angle = self.angle_to(axis);
        angle >= self.from + rho && angle <= self.to - rho
    }
}

/// A point that was found inside the tool.
#[derive(Clone, Copy)]
struct PointInTool {
    body: u16,
    leaf: u32,
    point: Point,
    /// How many cells it takes at this place.
    uses: u32,
}

/// A cell while it is looked at.
#[derive(Clone, Copy)]
struct Cell {
    corners: [Vector; 3],
    /// Its middle, and how far it reaches from there, rad.
    axis: Vector,
    rho: f64,
    /// By what share of its distance a point moves as the tool turns by that.
    turn: f64,
}

impl Cell {
    fn new(corners: [Vector; 3]) -> Self {
        let axis = (corners[0] + corners[1] + corners[2]).normalize();
        let rho = corners.iter().map(|c| c.dot(&axis).clamp(-1.0, 1.0).acos()).fold(0.0, f64::max) * (1.0 + 1e-9);
        Cell { corners, axis, rho, turn: 2.0 * (0.5 * rho).sin() }
    }

    /// By how much a point at `v` may come nearer to the tool, whose margin has this slope there
    /// with the axis in the middle, as the tool turns to any axis of the cell, mm. The margin is
    /// convex, so that it stays over its tangent plane; a turn by `ω` moves the point by `ω × v`
    /// but for `|ω|² |v| / 2`.
    fn nearer(&self, v: &Vector, slope: &Vector) -> f64 {
        self.rho * (v.cross(slope).norm() + 0.5 * self.rho * v.norm())
    }

    fn quarters(&self) -> [Cell; 4] {
        sphere::quarters(&self.corners).map(Cell::new)
    }
}

/// How a cell lies to what the contact angle allows.
#[derive(Clone, Copy, PartialEq)]
enum Contact {
    Inside,
    Cut,
    Outside,
}

/// What a node leaves of axes within a turn of one.
enum Cover {
    /// All.
    Clear,
    /// It is not known before these nodes are looked at.
    Below([Start; 2]),
    /// Some may be held.
    Kept,
}

/// What is handed down to the quarters of a cell: the nodes and annuli that may hold some of it.
#[derive(Clone, Copy)]
struct Below {
    nodes: [usize; 2],
    rings: [usize; 2],
}

/// Workspace for one place after another.
pub(super) struct SphereSearch<'a> {
    scene: &'a ObstacleScene<'a>,
    finest_rad: f64,
    centre: Point,
    normal: Vector,
    contact_rad: [f64; 2],
    points: Vec<PointInTool>,
    annuli: Vec<Annulus>,
    heights: Vec<HeightRange>,
    /// Nodes and annuli that may matter, those of each cell on the way down after one another.
    nodes: Vec<Start>,
    rings: Vec<u32>,
    opened: Vec<Start>,
    hopeful: BinaryHeap<Hopeful>,
    takers: Vec<Witness>,
    cells: Vec<SphereCell>,
}

impl<'a> SphereSearch<'a> {
    pub fn new(scene: &'a ObstacleScene<'a>, finest_rad: f64) -> Self {
        let settings = &scene.options.settings;
        SphereSearch {
            scene,
            finest_rad,
            centre: Point::origin(),
            normal: Vector::x(),
            contact_rad: [settings.contact_angle_min_deg, settings.contact_angle_max_deg].map(f64::to_radians),
            points: Vec::new(),
            annuli: Vec::new(),
            heights: Vec::new(),
            nodes: Vec::new(),
            rings: Vec::new(),
            opened: Vec::new(),
            hopeful: BinaryHeap::new(),
            takers: Vec::new(),
            cells: Vec::new(),
        }
    }

    /// The free axes with the ball centre at a place, where it touches a surface with this normal.
    pub fn at(&mut self, centre: &Point, normal: &Vector) -> FreeSphere {
        (self.centre, self.normal) = (*centre, *normal);
        self.annuli.clear();
        self.takers.clear();
        // Those that took most come first.
        self.points.retain(|p| p.uses > 0);
        self.points.sort_by_key(|p| std::cmp::Reverse(p.uses));
        self.points.truncate(CARRIED);
        for k in 0..self.points.len() {
            self.points[k].uses = 0;
            self.add_annuli(k);
        }
        let roots = self.scene.bodies.iter().enumerate().filter_map(|(k, b)| Some((k as u16, b.tree.root()?)));
        (self.nodes, self.rings) = (roots.collect(), (0..self.annuli.len() as u32).collect());
        let from = Below { nodes: [0, self.nodes.len()], rings: [0, self.rings.len()] };
        sphere::octants().into_iter().for_each(|corners| self.look(Cell::new(corners), from));
        let bindings = self.takers.iter().map(|by| walls::binding(*by, self.scene)).collect();
        FreeSphere { cells: std::mem::take(&mut self.cells), bindings }
    }

    fn take(&mut self, cell: &Cell, by: Witness) {
        let k = self.takers.iter().position(|t| *t == by).unwrap_or_else(|| {
            self.takers.push(by);
            self.takers.len() - 1
        });
        self.cells.push(SphereCell { corners: cell.corners, state: CellState::Taken(k as u32) });
    }

    fn take_by(&mut self, cell: &Cell, ring: usize) {
        let Annulus { point, by, .. } = self.annuli[ring];
        self.points[point as usize].uses += 1;
        self.take(cell, by);
    }

    /// How a cell lies to what the contact angle allows.
    fn contact(&self, Cell { axis, rho, .. }: &Cell) -> Contact {
        // What all angles are within cuts nothing.
        let [least, greatest] = self.contact_rad;
        let least = if least > 0.0 { least } else { f64::NEG_INFINITY };
        let greatest = if greatest < PI { greatest } else { f64::INFINITY };
        let contact = self.normal.dot(axis).clamp(-1.0, 1.0).acos();
        if contact + rho < least || contact - rho > greatest {
            Contact::Outside
        } else if contact - rho < least || contact + rho > greatest {
            Contact::Cut
        } else {
            Contact::Inside
        }
    }

    /// The annuli of a point that was found.
    fn add_annuli(&mut self, k: usize) {
        let PointInTool { body, leaf, point, .. } = self.points[k];
        let v = point - self.centre;
        let distance = v.norm();
        let Some(direction) = v.try_normalize(1e-12) else { return };
        let profile = &self.scene.bodies[usize::from(body)].profile;
        profile.inside(distance, 0.0, (-distance, distance), &mut self.heights);
        for h in &self.heights {
            let angle = |height: f64| (height / distance).clamp(-1.0, 1.0).acos();
            self.annuli.push(Annulus {
                direction,
                from: if h.high >= distance { f64::NEG_INFINITY } else { angle(h.high) },
                to: if h.low <= -distance { f64::INFINITY } else { angle(h.low) },
                point: k as u32,
                by: Witness::Tool { segment: h.low_by, body, leaf },
            });
        }
    }

    /// Looks at a cell.
    fn look(&mut self, cell: Cell, from: Below) {
        let Cell { axis, rho, .. } = cell;
        let contact = self.contact(&cell);
        if contact == Contact::Outside {
            return self.take(&cell, Witness::Contact);
        }
        let (first_node, first_ring) = (self.nodes.len(), self.rings.len());
        // Points that were found a moment ago were found beside this cell.
        let recent = self.annuli.len().saturating_sub(RECENT)..self.annuli.len();
        if let Some(ring) = recent.rev().find(|k| self.annuli[*k].holds(&axis, rho)) {
            return self.take_by(&cell, ring);
        }
        let (mut is_cut, mut is_middle_taken) = (contact == Contact::Cut, false);
        for i in from.rings[0]..from.rings[1] {
            let ring = self.rings[i];
            let a = &self.annuli[ring as usize];
            if a.holds(&axis, rho) {
                self.rings.truncate(first_ring);
                return self.take_by(&cell, ring as usize);
            }
            if a.meets(&axis, rho) {
                is_middle_taken |= a.holds(&axis, 0.0);
                is_cut = true;
                self.rings.push(ring);
            }
        }
        if !is_middle_taken && let Some(found) = self.probe(from.nodes, &axis) {
            if let Some(ring) = found.clone().find(|k| self.annuli[*k].holds(&axis, rho)) {
                self.rings.truncate(first_ring);
                return self.take_by(&cell, ring);
            }
            self.rings.extend(found.map(|k| k as u32));
            (is_middle_taken, is_cut) = (true, true);
        }
        let is_finest = rho <= self.finest_rad;
        let mut below = from;
        // Where the middle is taken the cell is not free, and nodes would be looked at in vain.
        if !is_middle_taken {
            self.keep_near(from.nodes, &cell, is_finest);
            below.nodes = [first_node, self.nodes.len()];
        }
        if !is_cut && below.nodes[0] == below.nodes[1] {
            self.cells.push(SphereCell { corners: cell.corners, state: CellState::Free });
        } else if is_finest {
            self.cells.push(SphereCell { corners: cell.corners, state: CellState::Open });
        } else {
            below.rings = [first_ring, self.rings.len()];
            cell.quarters().into_iter().for_each(|quarter| self.look(quarter, below));
        }
        self.nodes.truncate(first_node);
        self.rings.truncate(first_ring);
    }

    /// Adds the nodes below some of which points may hold axes of a cell; no more than one where it
    /// counts only whether there `is_any`.
    fn keep_near(&mut self, nodes: [usize; 2], cell: &Cell, is_any: bool) {
        let mut opened = std::mem::take(&mut self.opened);
        opened.clear();
        opened.extend_from_slice(&self.nodes[nodes[0]..nodes[1]]);
        while let Some(start) = opened.pop() {
            match self.near(start, cell) {
                Cover::Clear => {}
                Cover::Below(below) => opened.extend(below),
                Cover::Kept => {
                    self.nodes.push(start);
                    if is_any {
                        break;
                    }
                }
            }
        }
        self.opened = opened;
    }

    /// Whether points of a node may hold axes of a cell.
    fn near(&self, (body, index): Start, cell: &Cell) -> Cover {
        let on = &self.scene.bodies[usize::from(body)];
        let node = on.tree.node(index);
        let v = node.centre - self.centre;
        let distance = v.norm();
        if distance - node.radius > on.profile.farthest {
            return Cover::Clear;
        }
        let facet = bound::facet(&on.profile, &cell.axis, &v, node.radius, &node.half);
        let moved = cell.turn * (distance + node.radius);
        let nearer = cell.nearer(&v, &facet.flat.slope);
        let over_node = nearer + cell.rho * node.radius * (1.0 + 0.5 * cell.rho);
        if facet.flat.least > moved.min(over_node) && facet.others > moved {
            return Cover::Clear;
        }
        if node.radius <= FINER * moved.min(nearer) {
            return Cover::Kept;
        }
        let leaf = match on.tree.below(index) {
            tree::Below::Nodes(a, b) => return Cover::Below([(body, a), (body, b)]),
            tree::Below::Leaf(leaf) => leaf,
        };
        let corners = on.tree.corners(leaf).map(|c| c - self.centre);
        let middle = (corners[0] + corners[1] + corners[2]) / 3.0;
        let reach = corners.iter().map(|c| (c - middle).norm()).fold(0.0, f64::max);
        let is_clear = on.profile.frusta.iter().all(|f| {
            clear::margin(f, &cell.axis, &middle).0 > reach + moved
                || match clear::nearest(f, &cell.axis, &corners, &middle) {
                    // The bound is concave over the triangle: it is least at a corner.
                    clear::Nearness::Clear(t) => corners.iter().all(|c| t.over(c) > cell.nearer(c, &t.slope)),
                    _ => false,
                }
        });
        if is_clear { Cover::Clear } else { Cover::Kept }
    }

    /// Looks for a point inside the tool at an axis, far from where its annulus ends: always below
    /// the node whose middle is farthest inside. Its annuli become known; their numbers.
    fn probe(&mut self, nodes: [usize; 2], axis: &Vector) -> Option<std::ops::Range<usize>> {
        self.hopeful.clear();
        for k in nodes[0]..nodes[1] {
            let start = self.nodes[k];
            let hope = self.depth_of_node(start, axis);
            self.hopeful.push(Hopeful { hope, start });
        }
        for _ in 0..PROBES {
            let Hopeful { hope, start: (body, index) } = self.hopeful.pop()?;
            let on = &self.scene.bodies[usize::from(body)];
            match on.tree.below(index) {
                tree::Below::Nodes(a, b) => {
                    for start in [(body, a), (body, b)] {
                        let hope = self.depth_of_node(start, axis);
                        self.hopeful.push(Hopeful { hope, start });
                    }
                }
                tree::Below::Leaf(leaf) => {
                    let corners = on.tree.corners(leaf);
                    let middle = nalgebra::center(&nalgebra::center(&corners[0], &corners[1]), &corners[2]);
                    let depths = [corners[0], corners[1], corners[2], middle].map(|p| (self.depth(body, &p, axis), p));
                    let deepest = depths.into_iter().max_by(|a, b| a.0.total_cmp(&b.0));
                    if let Some((_, point)) = deepest.filter(|d| d.0 > 0.0) {
                        let first = self.annuli.len();
                        self.points.push(PointInTool { body, leaf, point, uses: 0 });
                        self.add_annuli(self.points.len() - 1);
                        return Some(first..self.annuli.len());
                    }
                    if hope < 0.0 {
                        return None;
                    }
                }
            }
        }
        None
    }

    fn depth_of_node(&mut self, (body, index): Start, axis: &Vector) -> f64 {
        let centre = self.scene.bodies[usize::from(body)].tree.node(index).centre;
        self.depth(body, &centre, axis)
    }

    /// By how much an axis may turn until a point is outside the tool, rad; less than 0 where it
    /// is: by how far it is from that, in ball centre's distances.
    fn depth(&mut self, body: u16, point: &Point, axis: &Vector) -> f64 {
        let v = point - self.centre;
        let distance = v.norm();
        let profile = &self.scene.bodies[usize::from(body)].profile;
        let height = v.dot(axis);
        profile.inside(distance, 0.0, (height, height), &mut self.heights);
        let inside = self.heights.iter().find(|h| (h.low..=h.high).contains(&height));
        let Some(h) = inside else {
            return -bound::margin(profile, axis, &v).max(1e-12) / distance.max(1e-12);
        };
        let angle = |height: f64| (height / distance).clamp(-1.0, 1.0).acos();
        let here = angle(height);
        let up = if h.high >= distance { f64::INFINITY } else { here - angle(h.high) };
        let down = if h.low <= -distance { f64::INFINITY } else { angle(h.low) - here };
        up.min(down)
    }
}

/// A node and how far inside the tool its middle is.
struct Hopeful {
    hope: f64,
    start: Start,
}

impl PartialEq for Hopeful {
    fn eq(&self, other: &Self) -> bool {
        self.cmp(other).is_eq()
    }
}

impl Eq for Hopeful {}

impl PartialOrd for Hopeful {
    fn partial_cmp(&self, other: &Self) -> Option<std::cmp::Ordering> {
        Some(self.cmp(other))
    }
}

impl Ord for Hopeful {
    fn cmp(&self, other: &Self) -> std::cmp::Ordering {
        self.hope.total_cmp(&other.hope).then_with(|| other.start.cmp(&self.start))
    }
}
