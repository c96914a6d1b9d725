//! The tube: where the part lets the ball centre go, as limits on the ordinates of a correction to
//! a curve.
//!
//! On every span of a curve the part is looked at from five places. The ball's distance off it is a
//! polynomial of degree 4 through what they see, the normal one of degree 2 through three of them.
//! With both, the distance of the corrected curve is a polynomial of degree 7, and limits on its
//! ordinates hold all over the span. What these polynomials miss between the places is left to
//! [`super::prove`], which measures the part itself.
//!
//! Across the path the curve keeps near to the polyline of the locations. Where these lie unevenly
//! about the curve, the span is cut at them, so that the polyline is straight on each interval.

use super::form::Form;
use super::room::TubeRoom;
use crate::artifact::toolpath::CutterLocation;
use crate::geometry::allowance::Allowed;
use crate::geometry::{Point, Vector};
use crate::numerics::bounded::{Span, Strip, SumLimit};
use crate::numerics::quintic::{Breaks, Map, ORDER, apply, weighed};
use crate::parallel;

/// Places of a span from which the part is looked at, evenly spread over it.
const PLACES: usize = 5;
/// Degree of the distance as a polynomial: that of the spline and of the normal.
const WHOLE: usize = 7;
/// A span is cut at locations where these are spread by more than this share of the room across.
const UNEVEN: f64 = 0.25;
/// Spans of a unit of parallel work at least.
const PER_THREAD: usize = 32;

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

/// Looks at the part from all spans of a curve. `None` where it is nowhere near.
pub(super) fn look(
    part: &Allowed,
    radius_mm: f64,
    breaks: &Breaks,
    x: &[[f64; 3]],
) -> Option<Vec<[TubePlace; PLACES]>> {
    let see = |i: usize| {
        let [a, b] = breaks.span(i);
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
    parallel::map_short(PER_THREAD, 0..breaks.spans(), see).into_iter().collect()
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
    /// Control points.
    pub x: &'a [[f64; 3]],
    pub seen: &'a [[TubePlace; PLACES]],
    /// The room by location.
    pub room: &'a [TubeRoom],
}

impl Tube<'_> {
    /// Limits and objective of the correction, span by span, and the objective of the curve itself.
    pub fn spans(&self, form: &(dyn Fn(usize) -> Form<18> + Sync)) -> (Vec<Span<3, 18>>, f64) {
        self.each(form, |i| (self.normal_rows(i), self.strips(i)))
    }

    /// As [`Tube::spans`] with limits at the breaks alone: no curve in the tube has less than what
    /// is least within these.
    pub fn at_breaks(&self, form: &(dyn Fn(usize) -> Form<18> + Sync)) -> (Vec<Span<3, 18>>, f64) {
        let last = self.breaks.spans() - 1;
        self.each(form, |i| {
            let ends = if i == last { vec![0, PLACES - 1] } else { vec![0] };
            (ends.into_iter().flat_map(|k| self.rows_at(i, k)).collect(), Vec::new())
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

    /// Locations of a span, and one on either side.
    fn near(&self, i: usize) -> std::ops::Range<usize> {
        let [a, b] = self.breaks.span(i);
        let from = self.locations.partition_point(|l| l.s_mm < a).saturating_sub(1);
        from..(self.locations.partition_point(|l| l.s_mm <= b) + 1).min(self.locations.len())
    }

    /// The least room of the locations about a span.
    fn room(&self, i: usize) -> TubeRoom {
        self.room[self.near(i)].iter().fold(TubeRoom::UNLIMITED, |a, b| a.and(b))
    }

    /// Limits along the normal, all over a span.
    fn normal_rows(&self, i: usize) -> Vec<SumLimit<18>> {
        let (seen, room, map) = (&self.seen[i], self.room(i), self.map(i, self.breaks.span(i)));
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

    /// Across and along at place `k` of a span.
    fn sides(&self, i: usize, k: usize) -> [Vector; 2] {
        let map = self.map(i, self.breaks.span(i));
        let [first, .., last] = apply(&map, &self.x[i..]);
        let [_, across, along] = frame(&self.seen[i][k].normal, &(Vector::from(last) - Vector::from(first)));
        [across, along]
    }

    /// Limits across and along the path, all over a span.
    fn strips(&self, i: usize) -> Vec<Strip<3>> {
        let ([a, b], room) = (self.breaks.span(i), self.room(i));
        let map = self.map(i, [a, b]);
        let [across, along] = self.sides(i, PLACES / 2);
        let strip = |map, direction: Vector, lo, hi| Strip { map, direction: direction.into(), lo, hi };
        let mut out = vec![strip(map, along, [-room.along_mm; ORDER], [room.along_mm; ORDER])];
        let moves = self.locations[self.near(i)].windows(2);
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

    /// Limits at a place of a span.
    fn rows_at(&self, i: usize, k: usize) -> Vec<SumLimit<18>> {
        let ([a, b], room, seen) = (self.breaks.span(i), self.room(i), self.seen[i][k]);
        let s = a + (b - a) * k as f64 / (PLACES - 1) as f64;
        let w = self.breaks.weights(i, s);
        let [across, along] = self.sides(i, k);
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
