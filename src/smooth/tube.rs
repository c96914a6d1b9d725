//! The tube: where the part lets the ball centre go, as limits on the ordinates of a correction to
//! a curve.
//!
//! A span of a curve is one cell, or where it is long several of some moves each. On every cell the
//! part is looked at from five places. The ball's distance off it is a polynomial of degree 4
//! through what they see, the normal one of degree 2 through three of them. With both, the distance
//! of the corrected curve is a polynomial of degree 7, and limits on its ordinates hold all over
//! the cell. What these polynomials miss between the places is left to [`super::prove`], which
//! measures the part itself.
//!
//! Across the path the curve keeps near to the polyline of the locations. Where these lie unevenly
//! about the curve, the cell is cut at them, so that the polyline is straight on each interval.

use super::form::Form;
use super::room::TubeRoom;
use crate::artifact::toolpath::CutterLocation;
use crate::geometry::allowance::Allowed;
use crate::geometry::{Point, Vector};
use crate::numerics::bounded::{Span, Strip, SumLimit};
use crate::numerics::quintic::{Breaks, Map, ORDER, apply, weighed};
use crate::parallel;

/// Places of a cell from which the part is looked at, evenly spread over it.
const PLACES: usize = 5;
/// Degree of the distance as a polynomial: that of the spline and of the normal.
const WHOLE: usize = 7;
/// A cell is cut at locations where these are spread by more than this share of the room across.
const UNEVEN: f64 = 0.25;
/// Spans of a unit of parallel work at least.
const PER_THREAD: usize = 32;
/// Locations inside a long span for each of its cells, at least.
const PER_CELL: usize = 3;

/// Normal, across and along the path at a location; unit vectors.
pub(super) fn frame_at(locations: &[CutterLocation], k: usize) -> [Vector; 3] {
    let (a, b) = (k.saturating_sub(1), (k + 1).min(locations.len() - 1));
    frame(&locations[k].normal, &(locations[b].centre - locations[a].centre))
}

fn frame(normal: &Vector, way: &Vector) -> [Vector; 3] {
    let along = (way - normal * normal.dot(way)).try_normalize(1e-12);
    // A way along the normal has no side: any will do.
    let along = along.unwrap_or_else(|| normal.cross(&Vector::ith(normal.iamin(), 1.0)).normalize());
    [*normal, along.cross(normal), along]
}

/// What a place of the curve sees of the part.
#[derive(Clone, Copy, Debug)]
pub(super) struct TubePlace {
    /// Distance of the centre from the part less the radius, mm.
    pub off_mm: f64,
    /// Unit vector from the part to the centre.
    pub normal: Vector,
}

/// An interval of a span.
#[derive(Clone, Copy, Debug)]
struct Cell {
    span: usize,
    ends: [f64; 2],
}

/// Cells of all spans, in order.
#[derive(Clone, Debug)]
pub(super) struct Cells {
    all: Vec<Cell>,
    /// The first cell of each span, and one more for the end.
    first: Vec<usize>,
}

impl Cells {
    /// One for each span.
    pub fn whole(breaks: &Breaks) -> Cells {
        let all = (0..breaks.spans()).map(|span| Cell { span, ends: breaks.span(span) }).collect();
        Cells { all, first: (0..=breaks.spans()).collect() }
    }

    /// Of some moves each, from location to location.
    pub fn of_moves(breaks: &Breaks, locations: &[CutterLocation]) -> Cells {
        let (mut all, mut first) = (Vec::new(), vec![0]);
        for span in 0..breaks.spans() {
            let [a, b] = breaks.span(span);
            let from = locations.partition_point(|l| l.s_mm <= a);
            let inside = locations.partition_point(|l| l.s_mm < b).saturating_sub(from);
            let parts = (inside / PER_CELL).max(1);
            let end = |j: usize| match j {
                0 => a,
                j if j == parts => b,
                j => locations[from + j * inside / parts].s_mm,
            };
            all.extend((0..parts).map(|j| Cell { span, ends: [end(j), end(j + 1)] }));
            first.push(all.len());
        }
        Cells { all, first }
    }

    fn of(&self, span: usize) -> std::ops::Range<usize> {
        self.first[span]..self.first[span + 1]
    }
}

/// Looks at the part from all cells of a curve. `None` where it is nowhere near.
pub(super) fn look(
    part: &Allowed,
    radius_mm: f64,
    (breaks, cells): (&Breaks, &Cells),
    x: &[[f64; 3]],
) -> Option<Vec<[TubePlace; PLACES]>> {
    let see = |cell: &Cell| {
        let (i, [a, b]) = (cell.span, cell.ends);
        let mut out = [TubePlace { off_mm: 0.0, normal: Vector::zeros() }; PLACES];
        for (k, seen) in out.iter_mut().enumerate() {
            let s = a + (b - a) * k as f64 / (PLACES - 1) as f64;
            let c = Point::from(weighed(&x[i..], &breaks.weights(i, s)));
            let near = part.closest(&c, 2.0 * radius_mm)?;
            let normal = (c - near.point).try_normalize(1e-9)?;
            *seen = TubePlace { off_mm: near.distance_mm - radius_mm, normal };
        }
        Some(out)
    };
    parallel::map_short(PER_THREAD, &cells.all, see).into_iter().collect()
}

/// Ordinates of degree 7 of the polynomial of degree 4 through values at the five places.
fn through(values: [f64; PLACES]) -> [f64; WHOLE + 1] {
    // Newton's forward differences in u = 4 t, as powers of u, as Bernstein ordinates.
    let mut differences = values;
    for r in 1..PLACES {
        for j in (r..PLACES).rev() {
            differences[j] -= differences[j - 1];
        }
    }
    let mut powers = [0.0; PLACES];
    let mut newton = [1.0, 0.0, 0.0, 0.0, 0.0];
    for (r, difference) in differences.iter().enumerate() {
        powers.iter_mut().zip(newton).for_each(|(p, n)| *p += difference * n);
        // Times (u − r) / (r + 1).
        let mut next = newton.map(|n| -n * r as f64);
        next[1..].iter_mut().zip(newton).for_each(|(n, below)| *n += below);
        newton = next.map(|n| n / (r + 1) as f64);
    }
    let mut out = [0.0; WHOLE + 1];
    for (k, power) in powers.iter().enumerate() {
        let power = power * ((PLACES - 1) as f64).powi(k as i32) / binomial(WHOLE, k);
        out.iter_mut().enumerate().skip(k).for_each(|(j, o)| *o += power * binomial(j, k));
    }
    out
}

fn binomial(n: usize, k: usize) -> f64 {
    (0..k).map(|i| (n - i) as f64 / (i + 1) as f64).product()
}

/// A curve, and what stands still while it is corrected.
pub(super) struct Tube<'a> {
    pub locations: &'a [CutterLocation],
    pub breaks: &'a Breaks,
    pub cells: &'a Cells,
    /// Control points.
    pub x: &'a [[f64; 3]],
    /// What each cell sees.
    pub seen: &'a [[TubePlace; PLACES]],
    /// The room by location.
    pub room: &'a [TubeRoom],
}

impl Tube<'_> {
    /// Limits and objective of the correction, span by span, and the objective of the curve itself.
    pub fn spans(&self, form: &(dyn Fn(usize) -> Form<18> + Sync)) -> (Vec<Span<3, 18>>, f64) {
        self.each(form, |i| {
            let cells = self.cells.of(i);
            (cells.clone().flat_map(|c| self.normal_rows(c)).collect(), cells.flat_map(|c| self.strips(c)).collect())
        })
    }

    /// As [`Tube::spans`] with limits at the breaks alone: no curve in the tube has less than what
    /// is least within these.
    pub fn at_breaks(&self, form: &(dyn Fn(usize) -> Form<18> + Sync)) -> (Vec<Span<3, 18>>, f64) {
        let last = self.breaks.spans() - 1;
        self.each(form, |i| {
            let cells = self.cells.of(i);
            let mut rows = self.rows_at(cells.start, 0);
            if i == last {
                rows.extend(self.rows_at(cells.end - 1, PLACES - 1));
            }
            (rows, Vec::new())
        })
    }

    fn each(
        &self,
        form: &(dyn Fn(usize) -> Form<18> + Sync),
        limits: impl Fn(usize) -> (Vec<SumLimit<18>>, Vec<Strip<3>>) + Sync,
    ) -> (Vec<Span<3, 18>>, f64) {
        let of = |i: usize| {
            let Form { hessian, gradient, value } = form(i);
            let (rows, strips) = limits(i);
            (Span { hessian, gradient, rows, strips }, value)
        };
        let spans = parallel::map_short(PER_THREAD, 0..self.breaks.spans(), of);
        let (spans, values): (Vec<_>, Vec<f64>) = spans.into_iter().unzip();
        (spans, values.iter().sum())
    }

    fn map(&self, i: usize, interval: [f64; 2]) -> Map {
        self.breaks.ordinates(i, interval)
    }

    /// Locations of a cell, and one on either side.
    fn near(&self, cell: usize) -> std::ops::Range<usize> {
        let [a, b] = self.cells.all[cell].ends;
        let from = self.locations.partition_point(|l| l.s_mm < a).saturating_sub(1);
        from..(self.locations.partition_point(|l| l.s_mm <= b) + 1).min(self.locations.len())
    }

    /// The least room of the locations about a cell.
    fn room(&self, cell: usize) -> TubeRoom {
        self.room[self.near(cell)].iter().fold(TubeRoom::UNLIMITED, |a, b| a.and(b))
    }

    /// Limits along the normal, all over a cell.
    fn normal_rows(&self, cell: usize) -> Vec<SumLimit<18>> {
        let Cell { span, ends } = self.cells.all[cell];
        let (seen, room, map) = (&self.seen[cell], self.room(cell), self.map(span, ends));
        let [n0, n1, n2] = [0, 2, 4].map(|k| seen[k].normal);
        let normals = [n0, n1 * 2.0 - (n0 + n2) * 0.5, n2];
        let off = through(seen.map(|s| s.off_mm));
        let row = |j: usize| {
            let mut g = [0.0; 18];
            for q in j.saturating_sub(2)..=j.min(5) {
                let share = binomial(2, j - q) * binomial(5, q) / binomial(WHOLE, j);
                let normal = normals[j - q] * share;
                g.iter_mut().enumerate().for_each(|(a, g)| *g += normal[a % 3] * map[q][a / 3]);
            }
            SumLimit { g, lo: -room.inwards_mm - off[j], hi: room.outwards_mm - off[j] }
        };
        (0..=WHOLE).map(row).collect()
    }

    /// Across and along at place `k` of a cell.
    fn sides(&self, cell: usize, k: usize) -> [Vector; 2] {
        let Cell { span, ends } = self.cells.all[cell];
        let [first, .., last] = apply(&self.map(span, ends), &self.x[span..]);
        let [_, across, along] = frame(&self.seen[cell][k].normal, &(Vector::from(last) - Vector::from(first)));
        [across, along]
    }

    /// Limits across and along the path, all over a cell.
    fn strips(&self, cell: usize) -> Vec<Strip<3>> {
        let (Cell { span: i, ends: [a, b] }, room) = (self.cells.all[cell], self.room(cell));
        let map = self.map(i, [a, b]);
        let [across, along] = self.sides(cell, PLACES / 2);
        let strip = |map, direction: Vector, lo, hi| Strip { map, direction: direction.into(), lo, hi };
        let mut out = vec![strip(map, along, [-room.along_mm; ORDER], [room.along_mm; ORDER])];
        let moves = self.locations[self.near(cell)].windows(2);
        let moves = moves.map(|w| (w, [w[0].s_mm.max(a), w[1].s_mm.min(b)])).filter(|(_, [p, q])| p < q);
        let miss = |w: &[CutterLocation], s: f64| {
            across.dot(&(between(w, s) - Vector::from(weighed(&self.x[i..], &self.breaks.weights(i, s)))))
        };
        let mut most = [f64::INFINITY, f64::NEG_INFINITY];
        for (w, ends) in moves.clone() {
            for v in ends.map(|s| miss(w, s)) {
                most = [most[0].min(v), most[1].max(v)];
            }
        }
        if most[1] - most[0] < UNEVEN * room.across_mm {
            let (lo, hi) = (most[1] - room.across_mm, most[0] + room.across_mm);
            out.push(strip(map, across, [lo; ORDER], [hi; ORDER]));
            return out;
        }
        for (w, [p, q]) in moves {
            let map = self.map(i, [p, q]);
            let ordinates = apply(&map, &self.x[i..]);
            let ends = [p, q].map(|s| between(w, s));
            let miss: [f64; ORDER] = std::array::from_fn(|j| {
                let there = ends[0] + (ends[1] - ends[0]) * (j as f64 / (ORDER - 1) as f64);
                across.dot(&(there - Vector::from(ordinates[j])))
            });
            let [lo, hi] = [-1.0, 1.0].map(|sign| miss.map(|m| m + sign * room.across_mm));
            out.push(strip(map, across, lo, hi));
        }
        out
    }

    /// Limits at a place of a cell.
    fn rows_at(&self, cell: usize, k: usize) -> Vec<SumLimit<18>> {
        let (Cell { span: i, ends: [a, b] }, room) = (self.cells.all[cell], self.room(cell));
        let seen = self.seen[cell][k];
        let s = a + (b - a) * k as f64 / (PLACES - 1) as f64;
        let w = self.breaks.weights(i, s);
        let [across, along] = self.sides(cell, k);
        let after = self.locations.partition_point(|l| l.s_mm <= s).clamp(1, self.locations.len() - 1);
        let there = between(&self.locations[after - 1..=after], s);
        let miss = across.dot(&(there - Vector::from(weighed(&self.x[i..], &w))));
        let row =
            |direction: Vector, lo, hi| SumLimit { g: std::array::from_fn(|a| w[a / 3] * direction[a % 3]), lo, hi };
        vec![
            row(seen.normal, -room.inwards_mm - seen.off_mm, room.outwards_mm - seen.off_mm),
            row(across, miss - room.across_mm, miss + room.across_mm),
            row(along, -room.along_mm, room.along_mm),
        ]
    }
}

/// The polyline at an arc length between two locations.
fn between(ends: &[CutterLocation], s_mm: f64) -> Vector {
    let share = (s_mm - ends[0].s_mm) / (ends[1].s_mm - ends[0].s_mm);
    ends[0].centre.coords + (ends[1].centre - ends[0].centre) * share
}
