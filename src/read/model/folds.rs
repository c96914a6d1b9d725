//! Edges that fold back on themselves.
//!
//! **In**: edges as their file has them. **Out**: the same without their folds: an edge that goes
//! some tenths of a millimetre on, comes back beside itself and goes on again becomes two, the part
//! before and the part after. Kernels write such edges where they prolong the border of a fillet
//! beyond what they computed. Loops of such edges cross themselves at any fineness of chords.
//!
//! **Guarantees**: every place that is left out lies within [`BESIDE_MM`] of what stays. Where the
//! edge itself begins or ends within the fold, what is left out beyond that is a spike, whose two
//! sides are as near to one another. Loops use both parts in place of the edge. Nothing else
//! changes.
//!
//! **Limits**: an edge whose sides part by more stays as it is, and its faces may be refused. A
//! fold is seen where samples of the edge lie in it, of which each polynomial piece has twice as
//! many as its order; and where it is longer than its sides are apart.

use crate::geometry::Point;
use crate::geometry::brep::{Brep, Coedge, Edge};

/// All sides of a fold lie as near to one another, mm.
const BESIDE_MM: f64 = 0.01;
/// No fold is longer, mm: a slot or a spike that is drawn so stays.
const LONGEST_MM: f64 = 2.0;
/// Places along a fold at which its sides are compared, but one.
const CUTS: usize = 16;
/// Halvings on the way to a place along a side.
const HALVINGS: usize = 52;
/// Thirds that are cut off on the way to the place where an edge turns, each time.
const THIRDS: usize = 60;

/// What was left out of the edges.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(super) struct Folds {
    /// How many.
    pub count: usize,
    /// Length of the longest, from one turning place to the other, mm.
    pub longest_mm: f64,
    /// Where that is.
    pub at: Point,
}

/// Leaves folds out of all edges.
pub(super) fn leave_out(brep: &mut Brep) -> Folds {
    let mut folds = Folds::default();
    // The parts of each edge, in order.
    let mut parts: Vec<Vec<usize>> = Vec::with_capacity(brep.edges.len());
    for e in 0..brep.edges.len() {
        let mut kept = vec![brep.edges[e].t];
        for fold in folds_of(&brep.edges[e]) {
            folds.count += 1;
            if fold.length_mm > folds.longest_mm {
                (folds.longest_mm, folds.at) = (fold.length_mm, fold.at);
            }
            if let Some(last) = kept.pop() {
                kept.extend([[last[0], fold.t[0]], [fold.t[1], last[1]]].into_iter().filter(|t| t[0] < t[1]));
            }
        }
        let mut own = vec![e];
        for t in kept.iter().skip(1) {
            own.push(brep.edges.len());
            brep.edges.push(Edge { curve: brep.edges[e].curve.clone(), t: *t });
        }
        if let Some(first) = kept.first() {
            brep.edges[e].t = *first;
        }
        parts.push(own);
    }
    if folds.count == 0 {
        return folds;
    }
    for one in brep.faces.iter_mut().flat_map(|f| &mut f.loops) {
        let coedges = one.iter().flat_map(|c| {
            let mut of: Vec<usize> = parts.get(c.edge).cloned().unwrap_or_else(|| vec![c.edge]);
            if c.reversed {
                of.reverse();
            }
            of.into_iter().map(|edge| Coedge { edge, reversed: c.reversed })
        });
        *one = coedges.collect();
    }
    folds
}

/// A stretch of an edge that is left out.
struct Fold {
    /// Parameters of its ends, which are nearly the same place.
    t: [f64; 2],
    /// Length, mm.
    length_mm: f64,
    /// Where the edge goes on.
    at: Point,
}

/// The folds of an edge, in order.
fn folds_of(edge: &Edge) -> Vec<Fold> {
    // Meshing says what is broken.
    if edge.curve.validate().is_err() || !(edge.t[0] < edge.t[1]) || edge.t.iter().any(|t| !t.is_finite()) {
        return Vec::new();
    }
    let (ts, points) = samples(edge);
    let turns_back = |k: usize| (points[k] - points[k - 1]).dot(&(points[k + 1] - points[k])) < 0.0;
    let turns: Vec<usize> = (1..points.len().saturating_sub(1)).filter(|k| turns_back(*k)).collect();
    let mut folds: Vec<Fold> = Vec::new();
    let mut k = 0;
    while k + 1 < turns.len() {
        let from = folds.last().map_or(edge.t[0], |f| f.t[1]);
        let found = fold_between(edge, (&ts, &points), [turns[k], turns[k + 1]], from);
        k += if found.is_some() { 2 } else { 1 };
        folds.extend(found);
    }
    folds
}

/// Parameters and points along an edge: the ends of its polynomial pieces and places within each,
/// those left out that lie beside the one before, since an edge turns round between the sides of a
/// fold.
fn samples(edge: &Edge) -> (Vec<f64>, Vec<Point>) {
    let [from, to] = edge.t;
    let mut stops = vec![from];
    stops.extend(edge.curve.knots.iter().copied().filter(|k| *k > from && *k < to));
    stops.push(to);
    stops.dedup();
    let count = 2 * (edge.curve.degree + 1);
    let within = |w: &[f64]| {
        let [a, b] = [w[0], w[1]];
        (0..count).map(move |k| a + (b - a) * k as f64 / count as f64)
    };
    let (mut ts, mut points) = (Vec::new(), Vec::<Point>::new());
    for t in stops.windows(2).flat_map(within).chain([to]) {
        let p = edge.curve.point(t);
        if points.last().is_none_or(|last| (p - last).norm() > BESIDE_MM) {
            ts.push(t);
            points.push(p);
        }
    }
    (ts, points)
}

/// The fold of an edge that turns back at one of its samples and on again at another, if it is one;
/// `from`: where the edge begins, or goes on after the fold before.
///
/// Its three sides, there, back and on again, are compared at the same places along it.
fn fold_between(edge: &Edge, (ts, points): (&[f64], &[Point]), [back, on]: [usize; 2], from: f64) -> Option<Fold> {
    let way = (points[back] - points[on]).try_normalize(1e-12)?;
    let along = |t: f64| (edge.curve.point(t) - points[on]).dot(&way);
    // The places between samples where it is farthest on, and farthest back.
    let far = least(|t| -along(t), [ts[back - 1].max(from), ts[back + 1]]);
    let near = least(along, [ts[on - 1].max(far), ts[on + 1]]);
    let length_mm = along(far) - along(near);
    if !(length_mm > 0.0 && length_mm <= LONGEST_MM && from < far && far < near) {
        return None;
    }
    // How far back the first side begins, and how far on the last one ends.
    let begin =
        ts[..back].iter().rev().copied().find(|t| *t <= from || along(*t) <= along(near)).unwrap_or(from).max(from);
    let end = ts[on + 1..].iter().copied().find(|t| along(*t) >= along(far)).unwrap_or(edge.t[1]);
    let (low, high) = (along(near).max(along(begin)), along(far).min(along(end)));
    let place = |s: f64| {
        [(begin, far, true), (far, near, false), (near, end, true)]
            .map(|(a, b, rises)| where_along(&along, [a, b], s, rises))
    };
    let beside = |k: usize| {
        let s = along(near) + length_mm * k as f64 / CUTS as f64;
        let [there, back, on] = place(s).map(|t| edge.curve.point(t));
        // A side that begins or ends within the fold is missing beyond that.
        let (is_there, is_on) = (s >= along(begin), s <= along(end));
        let near = |used: bool, p: Point, q: Point| !used || (p - q).norm() <= BESIDE_MM;
        near(is_there, there, back)
            && near(is_on, on, back)
            && near(is_there && is_on, there, on)
            && (is_there || is_on)
    };
    if !(low <= high && (0..=CUTS).all(beside)) {
        return None;
    }
    let [there, _, on] = place(0.5 * (low + high));
    Some(Fold { t: [there, on], length_mm, at: edge.curve.point(on) })
}

/// The parameter in a range over which a measure rises, or falls, and where it is as given; the end
/// nearer to that where it is so nowhere.
fn where_along(measure: &impl Fn(f64) -> f64, [mut low, mut high]: [f64; 2], value: f64, rises: bool) -> f64 {
    for _ in 0..HALVINGS {
        let middle = 0.5 * (low + high);
        if (measure(middle) < value) == rises { low = middle } else { high = middle }
    }
    0.5 * (low + high)
}

/// Where a function with one minimum in a range is least.
fn least(of: impl Fn(f64) -> f64, [mut low, mut high]: [f64; 2]) -> f64 {
    for _ in 0..THIRDS {
        let third = (high - low) / 3.0;
        if of(low + third) <= of(high - third) { high -= third } else { low += third }
    }
    0.5 * (low + high)
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used)]
    use super::*;
    use crate::geometry::Vector;
    use crate::geometry::exact::tests::block;
    use crate::geometry::nurbs::NurbsCurve;
    use crate::geometry::part::Part;
    use crate::observe::Silent;
    use nalgebra::Vector4;

    /// A block of 20 by 10 by 5 mm; one of its edges along x goes 0.1 mm beyond x = 8, back to
    /// x = 8, and on, `aside_mm` beside itself there.
    fn folded(aside_mm: f64, beyond_mm: f64) -> Brep {
        let mut brep = block(Vector::new(20.0, 10.0, 5.0));
        let along_x = |e: &Edge| {
            let way = e.at(1.0) - e.at(0.0);
            (way.x.abs() - 20.0).abs() < 1e-9
        };
        let e = brep.edges.iter().position(along_x).unwrap();
        let edge = &brep.edges[e];
        let [a, b] = [edge.at(0.0), edge.at(1.0)];
        let way = (b - a).normalize();
        let inwards = Vector::new(0.0, 0.0, if a.z > 2.5 { -1.0 } else { 1.0 });
        let at = |s: f64, aside: f64| a + way * s + inwards * aside;
        let points =
            [at(0.0, 0.0), at(8.0 + beyond_mm, 0.0), at(8.0 + beyond_mm, aside_mm), at(8.0, aside_mm), at(20.0, 0.0)];
        let knots = vec![0.0, 0.0, 1.0, 2.0, 3.0, 4.0, 4.0];
        let points = points.iter().map(|p| Vector4::new(p.x, p.y, p.z, 1.0)).collect();
        // The other face beside it uses the same edge, the other way.
        let between = |other: &Edge, [p, q]: [Point; 2]| (other.at(0.0) - p).norm() + (other.at(1.0) - q).norm() < 1e-9;
        let is_other = |k: usize| k != e && (between(&brep.edges[k], [a, b]) || between(&brep.edges[k], [b, a]));
        let other = (0..brep.edges.len()).find(|k| is_other(*k)).unwrap();
        let is_turned = between(&brep.edges[other], [b, a]);
        let uses = brep.faces.iter_mut().flat_map(|f| f.loops.iter_mut().flatten());
        for coedge in uses.filter(|c| c.edge == other) {
            *coedge = Coedge { edge: e, reversed: is_turned };
        }
        brep.edges[e] = Edge { curve: NurbsCurve { degree: 1, knots, points }, t: [0.0, 4.0] };
        brep
    }

    #[test]
    fn an_edge_that_folds_back_becomes_two_and_its_faces_are_whole() {
        let mut brep = folded(0.001, 0.1);
        // As it is its faces cannot be meshed.
        assert!(Part::from_brep(brep.clone(), 0.01, &Silent).is_err());
        let (edges, used) = (brep.edges.len(), brep.faces.iter().flat_map(|f| f.loops.iter().flatten()).count());
        let folds = leave_out(&mut brep);
        assert_eq!(folds.count, 1);
        assert!((folds.longest_mm - 0.1).abs() < 1e-4, "{folds:?}");
        assert_eq!(brep.edges.len(), edges + 1);
        assert_eq!(brep.faces.iter().flat_map(|f| f.loops.iter().flatten()).count(), used + 2);
        let part = Part::from_brep(brep.clone(), 0.01, &Silent).unwrap();
        assert!((part.mesh.volume_mm3() - 1000.0).abs() < 0.1, "{}", part.mesh.volume_mm3());
        assert_eq!(leave_out(&mut brep).count, 0, "nothing is left to leave out");
    }

    #[test]
    fn what_is_no_fold_stays() {
        // Sides too far apart, and too long.
        for (aside_mm, beyond_mm) in [(0.05, 0.1), (0.001, 3.0)] {
            let mut brep = folded(aside_mm, beyond_mm);
            let before = brep.clone();
            assert_eq!(leave_out(&mut brep), Folds::default(), "{aside_mm} {beyond_mm}");
            assert!(brep == before);
        }
        let mut brep = block(Vector::new(1.0, 2.0, 3.0));
        assert_eq!(leave_out(&mut brep).count, 0);
    }
}
