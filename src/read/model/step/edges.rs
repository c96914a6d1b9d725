//! The course of an edge: its curve from the first vertex to the second, as NURBS.
//!
//! In: an edge of the file. Out: a curve in mm from vertex to vertex in the edge's sense; nothing
//! where the edge has no length.
//!
//! `step-io` writes every kind of curve that has an exact NURBS form as such, cut between the
//! vertices: lines, circles, ellipses, parabolas, hyperbolas, B-splines with and without knots of
//! their own (uniform, quasi-uniform, Bézier), rational ones, polylines, trimmed and composite
//! curves, and the curve in space of surface, seam and intersection curves. What it does not:
//! closed B-splines between two vertices of which the way passes the curve's own beginning,
//! vertices in the order against the flag of the sense, edges without length. These are done here
//! from the whole curve, which is only cut, so that nothing is approximated. Of two courses the one
//! that meets the vertices better is taken.

use nalgebra::Matrix4;
use step_io::scene::{CurveKind, Edge as StepEdge};

use super::{curve, pole};
use crate::geometry::Point;
use crate::geometry::nurbs::NurbsCurve;
use crate::geometry::nurbs::fit::split_curve;
use crate::read::model::sew::curve::foot;
use crate::read::model::sew::{backwards, from_vertex};

/// A curve that passes a vertex within this distance begins there, mm: far below any tessellation.
const VERTEX_MM: f64 = 1e-6;
/// A curve whose ends are this near to one another is closed, mm.
const CLOSED_MM: f64 = 1e-3;
/// An edge that meets its vertices by this is as the file means it, mm.
const MET_MM: f64 = 1e-3;

/// The course of an edge in mm where `to` puts it; `None`: it has no length.
///
/// # Errors
/// Why there is none, to follow "an edge of face 3".
pub(super) fn course(edge: &StepEdge, mm: f64, to: &Matrix4<f64>) -> Result<Option<NurbsCurve>, String> {
    let vertex = |v: Option<step_io::scene::Vertex>| v.and_then(|v| v.point()).map(|p| p.xyz());
    let (Some(start), Some(end)) = (vertex(edge.start()), vertex(edge.end())) else {
        return Err("has a vertex without a point".into());
    };
    let [start, end] = [start, end].map(|p| Point::from(pole(&p, 1.0, mm, to).xyz()));
    let one_vertex = edge.start().map(|v| v.key()) == edge.end().map(|v| v.key());
    let read = edge.to_nurbs().map(|n| curve(&n, mm, to));
    if let Some(c) = &read {
        c.validate().map_err(|e| format!("is damaged: {}", e.message))?;
    }
    if one_vertex {
        return match read {
            // The reader gives closed curves as the file does: from anywhere, and not yet in the
            // edge's sense.
            Some(c) => {
                let c = if edge.same_sense() { c } else { backwards(&c) };
                Ok(Some(from_vertex(c, &start, VERTEX_MM)))
            }
            // A straight line or an open conic that ends where it begins.
            None if is_open(&edge.curve().kind()) => Ok(None),
            None => Err(unknown(edge)),
        };
    }
    if let Some(c) = read.as_ref().filter(|c| misses(c, &start, &end) <= MET_MM) {
        return Ok(Some(c.clone()));
    }
    let whole = edge.curve().to_nurbs().map(|n| curve(&n, mm, to)).filter(|c| c.validate().is_ok());
    let own = whole.and_then(|w| between(w, edge.same_sense(), &start, &end));
    let best = read.into_iter().chain(own).min_by(|a, b| misses(a, &start, &end).total_cmp(&misses(b, &start, &end)));
    match best {
        None if (start - end).norm() <= VERTEX_MM => Ok(None),
        None => Err(unknown(edge)),
        // How far a loop may be from closing is decided where it is followed.
        Some(c) => Ok(Some(c)),
    }
}

/// Distance of the ends of a curve from two points, the greater one.
fn misses(c: &NurbsCurve, start: &Point, end: &Point) -> f64 {
    let [a, b] = c.domain();
    (c.point(a) - start).norm().max((c.point(b) - end).norm())
}

/// The part of a curve from one point to another one, walked in the sense of the curve or against
/// it.
fn between(whole: NurbsCurve, along: bool, start: &Point, end: &Point) -> Option<NurbsCurve> {
    let whole = if along { whole } else { backwards(&whole) };
    let [a, b] = whole.domain();
    if (whole.point(a) - whole.point(b)).norm() <= CLOSED_MM {
        // Round and round: from the first point on, up to the second. A vertex may lie off the
        // curve.
        let off_mm = foot(&whole, [a, b], start).1;
        let round = from_vertex(whole, start, MET_MM.max(2.0 * off_mm));
        let (t, _) = foot(&round, round.domain(), end);
        let begin = round.point(round.domain()[0]);
        // Both vertices belong to one place of the curve: it is the whole.
        if (round.point(t) - begin).norm() <= MET_MM {
            return Some(round);
        }
        return split_curve(&round, t).ok().map(|(first, _)| first);
    }
    let [from, to] = [start, end].map(|p| foot(&whole, [a, b], p).0);
    if from < to { piece(&whole, from, to) } else { piece(&whole, to, from).map(|c| backwards(&c)) }
}

/// The curve over a part of its range; ends of the range are left as they are.
fn piece(c: &NurbsCurve, from: f64, to: f64) -> Option<NurbsCurve> {
    let [a, b] = c.domain();
    let least = 1e-12 * (b - a);
    let tail = if from > a + least { split_curve(c, from).ok()?.1 } else { c.clone() };
    if to < b - least { split_curve(&tail, to).ok().map(|(head, _)| head) } else { Some(tail) }
}

fn is_open(kind: &CurveKind) -> bool {
    matches!(kind, CurveKind::Line(_) | CurveKind::Parabola(_) | CurveKind::Hyperbola(_))
}

/// What kind of curve has no NURBS form here.
fn unknown(edge: &StepEdge) -> String {
    let kind = edge.curve().kind();
    let name = match &kind {
        CurveKind::Other(name) => (*name).to_owned(),
        kind => {
            let text = format!("{kind:?}");
            text.split('(').next().unwrap_or_default().to_owned()
        }
    };
    format!("is a curve of a kind that cannot be written as NURBS ({name})")
}
