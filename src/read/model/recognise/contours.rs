//! The contours of a wheel's hub and of the tips of its blades in the half-plane through the rotor
//! axis.
//!
//! In: the mesh of a whole wheel, cut by half-planes through the rotor axis at evenly spaced angles
//! over one repeat. Out: two polylines, each from the end of the blades nearer to the rotor axis to
//! the other. A place that all half-planes find inside is in the hub, one that some find inside
//! passes through blades, the others are outside. Blades lie between the two contours; where they
//! begin and end along the flow, the outside reaches down to the hub, and the corner there parts
//! that edge from the tips.
//!
//! Limits: a wheel whose blades carry a shroud has no tips, and no contours.

use std::f64::consts::{FRAC_PI_2, TAU};

use super::wheel::Wheel;
use crate::geometry::mesh::Mesh;
use crate::geometry::slice::{Loop, slice_triangles};
use crate::geometry::{Point, Rigid, Vector};
use crate::parallel;

/// Half-planes stand this far apart at the outside of the wheel, as a share of its radius …
const APART: f64 = 0.006;
/// … and so many there are at least, and at most.
const PLANES: [f64; 2] = [90.0, 240.0];
/// Places of the grid over the half-plane, each way.
const GRID: usize = 96;
/// What this share of the half-planes finds inside is in the hub: facets of round surfaces let some
/// miss.
const ALL: f64 = 0.97;
/// Halvings of an edge of the grid on a border.
const HALVINGS: u32 = 12;
/// A corner turns by this within this share of the outer border either side, …
const CORNER_RAD: f64 = 0.5;
/// See [`CORNER_RAD`].
const WINDOW: f64 = 0.05;
/// … within this share of it from its end. A rounded one is where the border comes farthest up and
/// out, seen along the hub over this share of its length.
const FROM_END: f64 = 0.45;
/// See [`FROM_END`].
const ENTRY: f64 = 0.15;
/// The border comes no farther out beyond a dip of this share of its length.
const DIP: f64 = 0.02;
/// Contours have fewer points than this only where there is hardly a blade.
const FEWEST: usize = 6;

/// A point of the half-plane: along the rotor axis, radius; mm.
pub type Place = [f64; 2];

/// Sections of a wheel by half-planes through its axis.
pub struct HalfPlanes {
    sections: Vec<Vec<Loop>>,
    frame: Rigid,
    repeat_rad: f64,
    bounds: [Place; 2],
}

/// Contours of a wheel.
pub struct Contours {
    /// Of the hub under the blades.
    pub hub: Vec<Place>,
    /// Of the tips.
    pub tip: Vec<Place>,
}

impl HalfPlanes {
    /// Cuts a wheel.
    pub fn new(mesh: &Mesh, wheel: &Wheel) -> HalfPlanes {
        let rotation = super::run::frame_along(&wheel.axis).rotation;
        let frame = Rigid::from_parts(wheel.through.into(), rotation);
        let seen = mesh.clone().moved(&frame.inverse());
        let (mut low, mut high) = ([f64::INFINITY, 0.0], [f64::NEG_INFINITY, 0.0f64]);
        for p in &seen.points {
            (low[0], high[0]) = (low[0].min(p.x), high[0].max(p.x));
            high[1] = high[1].max(p.y.hypot(p.z));
        }
        let repeat_rad = TAU / wheel.fold.max(1) as f64;
        let [fewest, most] = PLANES;
        let count = (repeat_rad / APART).ceil().clamp(fewest, most) as usize;
        let all: Vec<u32> = (0..seen.triangles.len() as u32).collect();
        let cut = |k: usize| {
            // The half-plane comes to lie on that of y and z, with the axis along y.
            let angle = repeat_rad * k as f64 / count as f64;
            let (s, c) = angle.sin_cos();
            let place = |p: &Point| Point::new(c * p.z - s * p.y, p.x, c * p.y + s * p.z);
            let turned = Mesh {
                points: seen.points.iter().map(place).collect(),
                triangles: seen.triangles.clone(),
                ..Mesh::default()
            };
            slice_triangles(&turned, &all, 0.0)
        };
        let sections = parallel::map(0..count, cut);
        HalfPlanes { sections, frame, repeat_rad, bounds: [low, high] }
    }

    /// Whether a place is inside on a half-plane: of any body, where bodies reach into one another.
    fn is_inside(&self, plane: usize, q: Place) -> bool {
        let turns = |l: &Loop| if l.area_mm2() > 0.0 { 1 } else { -1 };
        self.sections[plane].iter().filter(|l| l.contains(q)).map(turns).sum::<i32>() > 0
    }

    /// Share of the half-planes on which a place is inside.
    fn share(&self, q: Place) -> f64 {
        let inside = (0..self.sections.len()).filter(|k| self.is_inside(*k, q)).count();
        inside as f64 / self.sections.len() as f64
    }

    /// Angles of the blades within one repeat at a place, rad: where each begins and ends.
    pub fn blades(&self, q: Place) -> Vec<[f64; 2]> {
        let n = self.sections.len();
        let inside: Vec<bool> = (0..n).map(|k| self.is_inside(k, q)).collect();
        let Some(out) = inside.iter().position(|i| !i) else { return Vec::new() };
        let angle = |k: f64| self.repeat_rad * k / n as f64;
        let mut found = Vec::new();
        let mut began = None;
        for k in out..=out + n {
            match (began, inside[k % n]) {
                (None, true) => began = Some(k),
                (Some(from), false) => {
                    found.push([angle(from as f64 - 0.5), angle(k as f64 - 0.5)]);
                    began = None;
                }
                _ => {}
            }
        }
        found
    }

    /// The angle from one repeat of the wheel to the next, rad.
    pub fn repeat_rad(&self) -> f64 {
        self.repeat_rad
    }

    /// The point of the model at a place and an angle.
    pub fn point(&self, [along, radius]: Place, angle_rad: f64) -> Point {
        let (s, c) = angle_rad.sin_cos();
        self.frame * Point::new(along, radius * c, radius * s)
    }

    /// Place and angle of a direction of the model across the axis, rad.
    pub fn angle(&self, direction: &Vector) -> f64 {
        let d = self.frame.rotation.inverse() * direction;
        d.z.atan2(d.y)
    }

    /// The contours; `None` where there are no blades that stand on a hub and end in tips.
    pub fn contours(&self) -> Option<Contours> {
        let border = Grid::new(self).border()?;
        // From where the border leaves the hub to where it comes back to it, and along the hub.
        let n = border.len();
        let runs = |of_hub: bool| {
            let begins = (0..n).filter(|k| border[*k].of_hub == of_hub && border[(*k + n - 1) % n].of_hub != of_hub);
            begins
                .map(|from| {
                    let count = (0..n).take_while(|k| border[(from + k) % n].of_hub == of_hub).count();
                    (0..count).map(|k| border[(from + k) % n].at).collect::<Vec<Place>>()
                })
                .collect::<Vec<_>>()
        };
        let hub = runs(true).into_iter().max_by(|a, b| length(a).total_cmp(&length(b)))?;
        // All the way round from its one end to the other.
        let [first, last] = [hub.first()?, hub.last()?];
        let at = |p: &Place| border.iter().position(|b| b.at == *p);
        let (from, to) = (at(last)?, at(first)?);
        let count = (to + n - from) % n;
        let mut outer: Vec<Place> = (0..=count).map(|k| border[(from + k) % n].at).collect();
        outer.reverse();
        if hub.len() < FEWEST || outer.len() < FEWEST {
            return None;
        }
        let (whole, window) = (length(&outer), length(&hub) * ENTRY);
        let entry = corner(&outer, &hub, window, whole)?;
        let reversed = |of: &[Place]| of.iter().rev().copied().collect::<Vec<_>>();
        let exit = outer.len() - 1 - corner(&reversed(&outer), &reversed(&hub), window, whole)?;
        if entry + FEWEST > exit {
            return None;
        }
        let (mut hub, mut tip) = (hub, outer[entry..=exit].to_vec());
        if hub[0][1] > hub[hub.len() - 1][1] {
            (hub, tip) = (reversed(&hub), reversed(&tip));
        }
        Some(Contours { hub, tip })
    }
}

/// Length of a polyline.
fn length(of: &[Place]) -> f64 {
    of.windows(2).map(|w| (w[1][0] - w[0][0]).hypot(w[1][1] - w[0][1])).sum()
}

/// Where the outer border, which begins where the hub does, turns from the edge of the blades to
/// their tips.
fn corner(outer: &[Place], hub: &[Place], entry: f64, whole: f64) -> Option<usize> {
    let mut done = vec![0.0];
    for w in outer.windows(2) {
        done.push(done[done.len() - 1] + length(w));
    }
    let at = |s: f64| done.partition_point(|d| *d < s).min(outer.len() - 1);
    let way = |a: usize, b: usize| [outer[b][0] - outer[a][0], outer[b][1] - outer[a][1]];
    let turn = |k: usize| {
        let [u, v] = [way(at(done[k] - WINDOW * whole), k), way(k, at(done[k] + WINDOW * whole))];
        (u[0] * v[1] - u[1] * v[0]).atan2(u[0] * v[0] + u[1] * v[1]).abs()
    };
    let near = (0..outer.len()).filter(|k| (WINDOW * whole..FROM_END * whole).contains(&done[*k]));
    let sharpest = near.map(|k| (turn(k), k)).max_by(|a, b| a.0.total_cmp(&b.0))?;
    if sharpest.0 > CORNER_RAD {
        return Some(sharpest.1);
    }
    // Along the hub outwards, and across it to the side of the blades.
    let mut ahead = 1;
    while ahead + 1 < hub.len() && length(&hub[..=ahead]) < entry {
        ahead += 1;
    }
    let angle = (hub[0][1] - hub[ahead][1]).atan2(hub[0][0] - hub[ahead][0]);
    let to_tips = way(0, outer.len() / 2);
    let side = if angle.cos() * to_tips[1] - angle.sin() * to_tips[0] > 0.0 { 1.0 } else { -1.0 };
    let aslant = angle + side * 0.5 * FRAC_PI_2;
    let far = |p: &Place| p[0] * aslant.cos() + p[1] * aslant.sin();
    let (mut best, mut most) = (0, f64::NEG_INFINITY);
    for (k, p) in outer.iter().enumerate() {
        if far(p) > most {
            (best, most) = (k, far(p));
        } else if far(p) < most - DIP * whole {
            break;
        }
    }
    Some(best)
}

/// A point on the border of the blades.
struct OnBorder {
    at: Place,
    of_hub: bool,
}

/// Shares of the half-planes over a grid.
struct Grid<'a> {
    planes: &'a HalfPlanes,
    share: Vec<f64>,
}

impl<'a> Grid<'a> {
    fn new(planes: &'a HalfPlanes) -> Self {
        let mut grid = Grid { planes, share: Vec::new() };
        grid.share = parallel::map(0..GRID * GRID, |k| planes.share(grid.place(k / GRID, k % GRID)));
        grid
    }

    /// The place of a node. The outermost nodes lie outside the wheel, the innermost on its axis.
    fn place(&self, i: usize, j: usize) -> Place {
        let [low, high] = self.planes.bounds;
        let steps = (GRID - 1) as f64;
        let margin = (high[0] - low[0]) / (steps - 2.0);
        let along = low[0] - margin + (high[0] - low[0] + 2.0 * margin) * i as f64 / steps;
        [along, high[1] * (1.0 + 2.0 / steps) * j as f64 / steps]
    }

    fn is_bladed(share: f64) -> bool {
        share > 0.0 && share < ALL
    }

    /// Whether a node lies among blades; none at the grid's border does.
    fn has(&self, i: usize, j: usize) -> bool {
        let amid = 1..GRID - 1;
        amid.contains(&i) && amid.contains(&j) && Self::is_bladed(self.share[i * GRID + j])
    }

    /// The border of the largest piece, blades to the left.
    fn border(&self) -> Option<Vec<OnBorder>> {
        let squares = GRID - 1;
        let corner = |square: usize, k: usize| {
            let [di, dj] = [[0, 0], [1, 0], [1, 1], [0, 1]][k % 4];
            (square / squares + di, square % squares + dj)
        };
        let inside = |square: usize, k: usize| {
            let (i, j) = corner(square, k);
            self.has(i, j)
        };
        // The border leaves a square's corners that are inside behind the last of them and comes
        // back before the first.
        let leaves = |square: usize, k: usize| inside(square, k) && !inside(square, k + 1);
        let enters = |square: usize, leaving: usize| {
            (0..4).map(|back| (leaving + 4 - back - 1) % 4).find(|k| !inside(square, *k) && inside(square, k + 1))
        };
        // The square beyond an edge, and that edge's number there.
        let beyond = |square: usize, k: usize| {
            let (i, j) = (square / squares, square % squares);
            let (i, j) = match k {
                0 => (Some(i), j.checked_sub(1)),
                1 => (Some(i + 1), Some(j)),
                2 => (Some(i), Some(j + 1)),
                _ => (i.checked_sub(1), Some(j)),
            };
            Some((i? * squares + j?, (k + 2) % 4))
        };
        let mut seen = vec![false; 4 * squares * squares];
        let mut best: (f64, Vec<(usize, usize)>) = (0.0, Vec::new());
        for first in 0..4 * squares * squares {
            let (mut square, mut k) = (first / 4, first % 4);
            if seen[first] || !leaves(square, k) {
                continue;
            }
            let mut edges = Vec::new();
            while !seen[4 * square + k] {
                seen[4 * square + k] = true;
                edges.push((square, k));
                let Some(next) = enters(square, k).and_then(|entering| beyond(square, entering)) else { break };
                (square, k) = next;
            }
            let points: Vec<Place> = edges
                .iter()
                .map(|(s, k)| {
                    let (i, j) = corner(*s, *k);
                    [i as f64, j as f64]
                })
                .collect();
            let area: f64 = (0..points.len())
                .map(|i| (points[i], points[(i + 1) % points.len()]))
                .map(|(a, b)| 0.5 * (a[0] * b[1] - b[0] * a[1]))
                .sum();
            if area > best.0 {
                best = (area, edges);
            }
        }
        let on_border = |(square, k): &(usize, usize)| {
            let ((i, j), (m, n)) = (corner(*square, *k), corner(*square, *k + 1));
            let (mut good, mut bad) = (self.place(i, j), self.place(m, n));
            for _ in 0..HALVINGS {
                let middle = [0.5 * (good[0] + bad[0]), 0.5 * (good[1] + bad[1])];
                if Self::is_bladed(self.planes.share(middle)) { good = middle } else { bad = middle }
            }
            OnBorder { at: good, of_hub: self.share[m * GRID + n] >= ALL }
        };
        let border = parallel::map(&best.1, on_border);
        (border.len() >= 4 * FEWEST).then_some(border)
    }
}
