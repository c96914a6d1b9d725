//! The contours of a wheel's hub and of the tips of its blades in the half-plane through the rotor
//! axis.
//!
//! In: the mesh of a whole wheel or of one sector, cut by half-planes through the rotor axis at
//! evenly spaced angles over one repeat. Out: two polylines, each from the end of the blades nearer
//! to the rotor axis to the other. A place that all half-planes find inside is in the hub. One that
//! some find inside, and that a blade's own surface passes over, is in blades: so a disc that is
//! cut out between them, as that of a turbocharger's turbine, is none. Blades lie between the two
//! contours. Where the border of the blades has something inside beyond it, at the angle of the
//! blade, it is on the hub. Where blades begin and end along the flow, the outside reaches down to
//! the hub, and the corner there parts that edge from the tips.
//!
//! Limits: a wheel whose blades carry a shroud has no tips, and no contours.

use std::f64::consts::{FRAC_PI_2, TAU};

use super::wheel::Wheel;
use crate::geometry::mesh::Mesh;
use crate::geometry::slice::{Loop, slice_triangles};
use crate::geometry::{Point, Rigid, Vector};
use crate::numerics::angle::within_half_turn;
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
/// Beyond the border, by this share of the grid's step, hub is told from outside.
const BEYOND: f64 = 0.1;
/// Halvings of an edge of the grid on a border.
const HALVINGS: u32 = 12;
/// Tips that turn by this from one place to the next at their end go over into an edge there.
const HOOK_RAD: f64 = 0.25;
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

/// What a blade's surface passes over in the half-plane.
pub struct Silhouette {
    triangles: Vec<[Place; 3]>,
    /// Angle of each, rad.
    angles: Vec<f64>,
}

impl Silhouette {
    fn covers(&self, q: Place) -> bool {
        self.triangles.iter().any(|t| {
            let side = |a: Place, b: Place| (b[0] - a[0]) * (q[1] - a[1]) - (b[1] - a[1]) * (q[0] - a[0]);
            let sides = [side(t[0], t[1]), side(t[1], t[2]), side(t[2], t[0])];
            sides.iter().all(|s| *s >= 0.0) || sides.iter().all(|s| *s <= 0.0)
        })
    }

    /// Angle of the surface nearest to a place, rad.
    fn angle(&self, q: Place) -> Option<f64> {
        let off = |t: &[Place; 3]| (t[0][0] - q[0]).hypot(t[0][1] - q[1]);
        let near = self.triangles.iter().zip(&self.angles).min_by(|a, b| off(a.0).total_cmp(&off(b.0)));
        near.map(|(_, angle)| *angle)
    }
}

/// Contours of a wheel.
pub struct Contours {
    /// Of the hub under the blades.
    pub hub: Vec<Place>,
    /// Of the tips.
    pub tip: Vec<Place>,
}

impl HalfPlanes {
    /// Cuts a wheel. `is_sector`: the mesh is one sector, and the wheel is made of as many as it
    /// has repeats.
    pub fn new(mesh: &Mesh, wheel: &Wheel, is_sector: bool) -> HalfPlanes {
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
        let cut = |angle: f64| {
            // The half-plane comes to lie on that of y and z, with the axis along y.
            let (s, c) = angle.sin_cos();
            let place = |p: &Point| Point::new(c * p.z - s * p.y, p.x, c * p.y + s * p.z);
            let turned = Mesh {
                points: seen.points.iter().map(place).collect(),
                triangles: seen.triangles.clone(),
                ..Mesh::default()
            };
            slice_triangles(&turned, &all, 0.0)
        };
        // What a sector has in the other repeats, its copies have in the first one.
        let repeats = if is_sector { repeats_with(&seen, repeat_rad) } else { vec![0] };
        let angle = |k: usize, repeat: usize| repeat_rad * (repeat as f64 + k as f64 / count as f64);
        let sections = parallel::map(0..count, |k| repeats.iter().flat_map(|repeat| cut(angle(k, *repeat))).collect());
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

    /// What some triangles of the mesh, which is seen in the model frame, pass over.
    pub fn silhouette(&self, mesh: &Mesh, triangles: &[u32]) -> Silhouette {
        let seen = |p: &Point| {
            let p = self.frame.inverse_transform_point(p);
            ([p.x, p.y.hypot(p.z)], p.z.atan2(p.y))
        };
        let of = |t: &u32| mesh.corners(*t as usize).map(|p| seen(&p));
        let (triangles, angles) = triangles.iter().map(of).map(|t| (t.map(|p| p.0), t[0].1)).unzip();
        Silhouette { triangles, angles }
    }

    /// Shares of the half-planes over a grid.
    pub fn grid(&self) -> Grid<'_> {
        let mut grid = Grid { planes: self, share: Vec::new() };
        grid.share = parallel::map(0..GRID * GRID, |k| self.share(grid.place(k / GRID, k % GRID)));
        grid
    }

    /// Whether the blade at a place goes on inside at another place: on a hub it does.
    fn goes_on(&self, silhouette: &Silhouette, from: Place, to: Place) -> bool {
        let Some(angle) = silhouette.angle(from) else { return false };
        let off = |middle: f64| {
            let turns = (middle - angle) / self.repeat_rad;
            (turns - turns.round()).abs()
        };
        let middles = self.blades(from).into_iter().map(|[a, b]| 0.5 * (a + b));
        let nearest = middles.min_by(|a, b| off(*a).total_cmp(&off(*b)));
        let n = self.sections.len();
        nearest.is_some_and(|m| self.is_inside((m / self.repeat_rad * n as f64).round() as usize % n, to))
    }
}

/// The repeats of a wheel about x in which a mesh has something, counted from y towards z.
fn repeats_with(mesh: &Mesh, repeat_rad: f64) -> Vec<usize> {
    let count = (TAU / repeat_rad).round() as usize;
    let angles: Vec<f64> = mesh.points.iter().map(|p| p.z.atan2(p.y)).collect();
    let mut has = vec![false; count];
    for [a, b] in mesh.triangles.iter().flat_map(|&[a, b, c]| [[a, b], [b, c], [c, a]]) {
        let (from, by) = (angles[a as usize], within_half_turn(angles[b as usize] - angles[a as usize]));
        let [low, high] = [from.min(from + by), from.max(from + by)].map(|x| (x / repeat_rad).floor() as i64);
        (low..=high).for_each(|k| has[k.rem_euclid(count as i64) as usize] = true);
    }
    (0..count).filter(|k| has[*k]).collect()
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

/// Tips without what turns into the edge of the blades at their last end: heights that follow such
/// a hook fold.
fn unhooked(mut tip: Vec<Place>) -> Vec<Place> {
    let window = WINDOW * length(&tip);
    while let [.., before, last] = &tip[..] {
        let from = (1..tip.len() - 1).rev().find(|k| length(&tip[*k..tip.len() - 1]) >= window).unwrap_or(0);
        let [u, v] = [[tip[from], *before], [*before, *last]].map(|[a, b]| [b[0] - a[0], b[1] - a[1]]);
        let turn = (u[0] * v[1] - u[1] * v[0]).atan2(u[0] * v[0] + u[1] * v[1]).abs();
        if tip.len() <= FEWEST || turn <= HOOK_RAD {
            break;
        }
        tip.pop();
    }
    tip
}

/// A point on the border of the blades.
struct OnBorder {
    at: Place,
    of_hub: bool,
}

/// Shares of the half-planes over a grid.
pub struct Grid<'a> {
    planes: &'a HalfPlanes,
    share: Vec<f64>,
}

impl Grid<'_> {
    /// The place that is farthest from what is no blade, by steps of a grid.
    pub fn deepest(&self) -> Option<Place> {
        let mut steps = vec![0u32; GRID * GRID];
        let mut open: Vec<usize> = (0..GRID * GRID).filter(|k| self.has(k / GRID, k % GRID)).collect();
        let mut last = *open.first()?;
        for step in 1.. {
            let amid = |k: &usize| [k - 1, k + 1, k - GRID, k + GRID].iter().all(|k| steps[*k] + 1 >= step);
            open.retain(amid);
            let Some(one) = open.get(open.len() / 2) else { break };
            last = *one;
            open.iter().for_each(|k| steps[*k] = step);
        }
        Some(self.place(last / GRID, last % GRID))
    }

    /// The contours; `None` where there are no blades that stand on a hub and end in tips.
    pub fn contours(self, of: &Silhouette) -> Option<Contours> {
        let border = self.within(of).border(of)?;
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
        let tip = unhooked(reversed(&unhooked(outer[entry..=exit].to_vec())));
        let (mut hub, mut tip) = (hub, reversed(&tip));
        if hub[0][1] > hub[hub.len() - 1][1] {
            (hub, tip) = (reversed(&hub), reversed(&tip));
        }
        Some(Contours { hub, tip })
    }

    /// The grid without what a silhouette does not cover and the hub has not.
    fn within(mut self, silhouette: &Silhouette) -> Self {
        let kept = |k: usize| {
            let share = self.share[k];
            if Self::is_bladed(share) && !silhouette.covers(self.place(k / GRID, k % GRID)) { 0.0 } else { share }
        };
        self.share = parallel::map(0..GRID * GRID, kept);
        self
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
    fn border(&self, silhouette: &Silhouette) -> Option<Vec<OnBorder>> {
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
            let is_blade = |q: Place| Self::is_bladed(self.planes.share(q)) && silhouette.covers(q);
            let step = [bad[0] - good[0], bad[1] - good[1]];
            for _ in 0..HALVINGS {
                let middle = [0.5 * (good[0] + bad[0]), 0.5 * (good[1] + bad[1])];
                if is_blade(middle) { good = middle } else { bad = middle }
            }
            let beyond = [good[0] + BEYOND * step[0], good[1] + BEYOND * step[1]];
            let of_hub = self.share[m * GRID + n] >= ALL || self.planes.goes_on(silhouette, good, beyond);
            OnBorder { at: good, of_hub }
        };
        let border = parallel::map(&best.1, on_border);
        (border.len() >= 4 * FEWEST).then_some(border)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Tips that go over into an edge by a rounded corner end before it.
    #[test]
    fn tips_end_before_a_hook() {
        let arc = |k: u32| {
            let (s, c) = (0.02 * f64::from(k)).sin_cos();
            [20.0 * s, 20.0 * c]
        };
        let tips: Vec<Place> = (0..40).map(arc).collect();
        assert_eq!(unhooked(tips.clone()), tips);
        let [x, y] = tips[39];
        let hook = [[x + 0.25, y - 0.32], [x + 0.3, y - 0.7], [x + 0.25, y - 1.1]];
        let found = unhooked(tips.iter().copied().chain(hook).collect());
        assert!(found.len() <= 41 && found.len() >= 39 && found[..39] == tips[..39], "{}", found.len());
    }

    /// A silhouette is what triangles pass over, seen along circles about the rotor axis.
    #[test]
    fn a_silhouette_covers_what_its_triangles_do() {
        let of = Silhouette { triangles: vec![[[0.0, 0.0], [2.0, 0.0], [0.0, 2.0]]], angles: vec![0.3] };
        for (q, inside) in [([0.5, 0.5], true), ([1.2, 1.2], false), ([-0.1, 0.5], false), ([0.5, -0.1], false)] {
            assert_eq!(of.covers(q), inside, "{q:?}");
        }
        assert_eq!(of.angle([5.0, 5.0]), Some(0.3));
    }
}
