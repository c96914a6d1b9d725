//! Sections of exact faces as smooth curves.
//!
//! **In**: a part with exact faces, a height, a tolerance. **Out**: each closed loop of the section
//! as a chain of cubic B-splines in the plane. The chain is cut where the plane crosses edges of
//! the part (not seams of one face), at points of the edges' own curves; between them each curve is
//! C². A loop that crosses no edge is one closed curve, C² all round but at its first point, where
//! it is C² as well and only its knots end.
//!
//! **Method.** Points of the loop lie on the faces to 10⁻⁸ mm (`outline`); a spline interpolates
//! some of them over chord length (*The NURBS Book*, 9.2). Between every two of them it is measured
//! at three places how far the nearest point of the section is; where that is more than the
//! tolerance, the section's point there is interpolated too, and so on.
//!
//! **Error**: [`SectionCurves::off_mm`] is the greatest distance measured and a quarter more for
//! what lies between the places: a measured bound. It exceeds the tolerance only where faces have
//! creases inside.
//!
//! **Fails** where the part is a mesh, where the section does not close, and where it runs along a
//! face.

use nalgebra::Vector4;

use crate::artifact::section::SectionCurves;
use crate::error::{Error, Frame, Infeasible, Result, SectionFault, Spot, Stage};
use crate::geometry::brep::Brep;
use crate::geometry::nurbs::NurbsCurve;
use crate::geometry::nurbs::fit::{FitError, PeriodicRows, interpolate_curve};
use crate::geometry::nurbs::pieces;
use crate::geometry::part::Part;
use crate::geometry::profile::outline::{ON_SURFACE_MM, POINTS, arc_length, distance, on_part};
use crate::geometry::slice::slice;

/// Of the dense points every so many are interpolated at first.
const COARSE: usize = 12;
/// Rounds of finer interpolation.
const ROUNDS: usize = 14;
/// No curve interpolates more points.
const MOST_NODES: usize = 4000;
/// A crossing with an edge this near to another one is the same, mm.
const SAME_MM: f64 = 1e-6;
/// A curve is halved at most so often in the search for its crossings.
const DEEPEST: u32 = 60;

type Pair = [f64; 2];

/// The section of a part at a height as curves, the outer loops counter-clockwise seen from the
/// tip, holes the other way.
///
/// # Errors
/// Kind `Usage` for a mesh and for a tolerance that is not greater than 0; `Infeasible` for a
/// section that is not there, does not close, or runs along a face.
pub fn curves(part: &Part, x_mm: f64, tolerance_mm: f64) -> Result<Vec<SectionCurves>> {
    if !(tolerance_mm > 0.0 && tolerance_mm.is_finite()) {
        let m = format!("the tolerance of a section's curves is {tolerance_mm} mm, it must be greater than 0");
        return Err(Error::usage(Stage::Section, m));
    }
    let Some(brep) = &part.brep else {
        return Err(Error::usage(Stage::Section, "a mesh has no exact faces to cut: its sections are polygons"));
    };
    let loops = slice(&part.mesh, &part.bvh, x_mm);
    if loops.is_empty() || loops.iter().any(|l| !l.closed) {
        let (what, fault) = match loops.is_empty() {
            true => ("has no loop", SectionFault::NoLoop),
            false => ("has a loop that does not close", SectionFault::OpenLoop),
        };
        let since = Infeasible::NoSection { height_mm: x_mm, fault };
        return Err(Error::infeasible(Stage::Section, format!("the section at {x_mm:.3} mm {what}"), since));
    }
    let crossings = crossings(brep, x_mm);
    loops.iter().filter(|l| l.points.len() >= 3).map(|l| one(part, x_mm, &l.points, &crossings, tolerance_mm)).collect()
}

/// One loop.
fn one(part: &Part, x_mm: f64, polygon: &[Pair], crossings: &[Pair], tolerance_mm: f64) -> Result<SectionCurves> {
    let stretches = stretches(part, x_mm, polygon, crossings)?;
    let mut out = SectionCurves { pieces: Vec::with_capacity(stretches.len()), off_mm: 0.0 };
    for s in stretches {
        let (curve, off_mm) = fit(part, x_mm, s, tolerance_mm).map_err(|e| {
            let since = Infeasible::NoSection { height_mm: x_mm, fault: SectionFault::NoCurve };
            Error::infeasible(Stage::Section, format!("the section at {x_mm:.3} mm is no curve: {e}"), since)
        })?;
        out.pieces.push(curve);
        out.off_mm = out.off_mm.max(1.25 * off_mm);
    }
    Ok(out)
}

/// Points of a curve to be, both ends included; a closed one does not repeat its first.
struct CurvePoints {
    points: Vec<Pair>,
    closed: bool,
}

/// The loop between its crossings with edges, as points on the part.
fn stretches(part: &Part, x_mm: f64, polygon: &[Pair], crossings: &[Pair]) -> Result<Vec<CurvePoints>> {
    let step = arc_length(polygon).1 / POINTS;
    let near = (2.0 * step).max(10.0 * part.deflection_mm);
    // (place along the polygon, point, whether it is a crossing)
    let mut all: Vec<(f64, Pair, bool)> = Vec::new();
    for c in crossings {
        let (off, place) = nearest(polygon, *c);
        if off < near && !all.iter().any(|a| distance(a.1, *c) < SAME_MM) {
            all.push((place, *c, true));
        }
    }
    let cuts: Vec<Pair> = all.iter().map(|a| a.1).collect();
    // Points so near to a crossing may have gone to the face beyond it.
    let clear = (0.3 * step).max(3.0 * part.deflection_mm).min(step);
    for (i, &a) in polygon.iter().enumerate() {
        let b = polygon[(i + 1) % polygon.len()];
        let parts = (distance(a, b) / step).ceil().clamp(1.0, POINTS) as usize;
        for k in 0..parts {
            let f = k as f64 / parts as f64;
            let guess = [a[0] + f * (b[0] - a[0]), a[1] + f * (b[1] - a[1])];
            if cuts.iter().any(|c| distance(*c, guess) < clear) {
                continue;
            }
            let placed = on_part(part, x_mm, guess);
            if !(placed.off_mm < ON_SURFACE_MM) {
                let m =
                    format!("the section at {x_mm:.3} mm runs along a face at y {:.3}, z {:.3} mm", guess[0], guess[1]);
                let at = Spot { frame: Frame::Blade, point_mm: [x_mm, guess[0], guess[1]] };
                let since = Infeasible::NoSection { height_mm: x_mm, fault: SectionFault::AlongFace { at } };
                return Err(Error::infeasible(Stage::Section, m, since).advise("cut at another height"));
            }
            all.push((i as f64 + f, placed.at, false));
        }
    }
    all.sort_by(|a, b| a.0.total_cmp(&b.0));
    all.dedup_by(|b, a| distance(a.1, b.1) < SAME_MM && !b.2);
    let Some(first) = all.iter().position(|a| a.2) else {
        let points = all.into_iter().map(|a| a.1).collect();
        return Ok(vec![CurvePoints { points, closed: true }]);
    };
    all.rotate_left(first);
    all.push(all[0]);
    let at: Vec<usize> = (0..all.len()).filter(|k| all[*k].2).collect();
    let between = |w: &[usize]| CurvePoints { points: all[w[0]..=w[1]].iter().map(|a| a.1).collect(), closed: false };
    Ok(at.windows(2).map(between).collect())
}

/// Distance of a point from a closed polygon, and where on it that is: side and share.
fn nearest(polygon: &[Pair], q: Pair) -> (f64, f64) {
    let mut best = (f64::INFINITY, 0.0);
    for (i, a) in polygon.iter().enumerate() {
        let b = polygon[(i + 1) % polygon.len()];
        let d = [b[0] - a[0], b[1] - a[1]];
        let length2 = d[0] * d[0] + d[1] * d[1];
        let s = ((q[0] - a[0]) * d[0] + (q[1] - a[1]) * d[1]) / length2.max(f64::MIN_POSITIVE);
        let s = s.clamp(0.0, 1.0);
        let off = distance(q, [a[0] + s * d[0], a[1] + s * d[1]]);
        if off < best.0 {
            best = (off, i as f64 + s);
        }
    }
    best
}

/// The spline through some of the points, and through more of the section until it is within the
/// tolerance; with the greatest distance measured, mm.
fn fit(part: &Part, x_mm: f64, s: CurvePoints, tolerance_mm: f64) -> std::result::Result<(NurbsCurve, f64), FitError> {
    let last = s.points.len() - 1;
    let mut nodes: Vec<Pair> = s.points.iter().copied().step_by(COARSE.min(last.max(4) / 4)).collect();
    if !s.closed && !last.is_multiple_of(COARSE.min(last.max(4) / 4)) {
        nodes.push(s.points[last]);
    }
    let mut best: Option<(NurbsCurve, f64)> = None;
    for _ in 0..ROUNDS {
        let (curve, params) = through(x_mm, &nodes, s.closed)?;
        let mut finer = Vec::with_capacity(2 * nodes.len());
        let mut worst = 0.0f64;
        for (k, w) in params.windows(2).enumerate() {
            finer.push(nodes[k]);
            let at = |share: f64| {
                let p = curve.point(w[0] + share * (w[1] - w[0]));
                let placed = on_part(part, x_mm, [p.y, p.z]);
                (distance(placed.at, [p.y, p.z]), placed)
            };
            let [a, b, c] = [at(0.25), at(0.5), at(0.75)];
            let off = a.0.max(b.0).max(c.0);
            worst = worst.max(off);
            let chord = w[1] - w[0];
            if off > tolerance_mm && b.1.off_mm < ON_SURFACE_MM && b.0 < 0.3 * chord && chord > 1e3 * SAME_MM {
                finer.push(b.1.at);
            }
        }
        finer.extend((!s.closed).then(|| nodes[nodes.len() - 1]));
        if best.as_ref().is_none_or(|b| worst < b.1) {
            best = Some((curve, worst));
        }
        if worst <= tolerance_mm || finer.len() == nodes.len() || finer.len() > MOST_NODES {
            break;
        }
        nodes = finer;
    }
    best.ok_or(FitError::Singular)
}

/// The C² cubic (of lower degree through two or three points) through the nodes, over chord length,
/// and its parameters at them.
fn through(x_mm: f64, nodes: &[Pair], closed: bool) -> std::result::Result<(NurbsCurve, Vec<f64>), FitError> {
    let lift = |p: &Pair| Vector4::new(x_mm, p[0], p[1], 1.0);
    let points: Vec<Vector4<f64>> = nodes.iter().map(lift).collect();
    let mut params = vec![0.0];
    let mut to = 0.0;
    for (k, p) in nodes.iter().enumerate().skip(1) {
        to += distance(nodes[k - 1], *p);
        params.push(to);
    }
    let mut curve = if closed {
        params.push(to + distance(nodes[nodes.len() - 1], nodes[0]));
        let rows = PeriodicRows::interpolate(&points, 1, &params)?.open(0);
        NurbsCurve { degree: rows.degree, knots: rows.knots, points: rows.points }
    } else {
        interpolate_curve(&points, &params, 3.min(nodes.len() - 1))?
    };
    // Constants are interpolated to rounding only; ends are shared bit by bit.
    curve.points.iter_mut().for_each(|p| (p.x, p.w) = (x_mm, 1.0));
    if !closed && let ([first, .., last], [a, .., b]) = (curve.points.as_mut_slice(), &points[..]) {
        (*first, *last) = (*a, *b);
    }
    Ok((curve, params))
}

/// Where the plane crosses the edges between faces: points of their own curves.
fn crossings(brep: &Brep, x_mm: f64) -> Vec<Pair> {
    let mut faces: Vec<Vec<usize>> = vec![Vec::new(); brep.edges.len()];
    for (f, face) in brep.faces.iter().enumerate() {
        for c in face.loops.iter().flatten() {
            if let Some(users) = faces.get_mut(c.edge) {
                users.push(f);
            }
        }
    }
    let mut out = Vec::new();
    for (edge, faces) in brep.edges.iter().zip(faces) {
        // A seam is no edge of the part.
        let seam = faces.len() == 2 && faces[0] == faces[1];
        let [a, b] = edge.curve.domain();
        let range = [edge.t[0].max(a), edge.t[1].min(b)];
        if !seam && !faces.is_empty() && range[0] < range[1] {
            on_curve(&pieces::part(&edge.curve, range), x_mm, 0, &mut out);
        }
    }
    out
}

/// Crossings of a curve with the plane: none where its control points are all on one side, one
/// where their signs change once (*The NURBS Book* P3.8, variation diminishing), else those of its
/// halves. A curve within the plane has none.
fn on_curve(curve: &NurbsCurve, x_mm: f64, depth: u32, out: &mut Vec<Pair>) {
    let above: Vec<f64> = curve.points.iter().map(|p| p.x - x_mm * p.w).collect();
    if above.iter().all(|x| x.abs() < 1e-9) {
        return;
    }
    let changes = above.windows(2).filter(|w| (w[0] >= 0.0) != (w[1] >= 0.0)).count();
    let [mut from, mut to] = curve.domain();
    let middle = 0.5 * (from + to);
    match changes {
        0 => {}
        n if n > 1 && depth < DEEPEST && from < middle && middle < to => {
            on_curve(&pieces::part(curve, [from, middle]), x_mm, depth + 1, out);
            on_curve(&pieces::part(curve, [middle, to]), x_mm, depth + 1, out);
        }
        _ => {
            let rises = above[0] < 0.0;
            for _ in 0..100 {
                let m = 0.5 * (from + to);
                if ((curve.point(m).x >= x_mm) == rises) && m < to {
                    to = m;
                } else {
                    from = m;
                }
            }
            let p = curve.point(0.5 * (from + to));
            out.push([p.y, p.z]);
        }
    }
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used)]
    use super::*;
    use crate::error::ErrorKind;
    use crate::geometry::brep::{Face, SurfaceKind};
    use crate::geometry::exact::tests::can;
    use crate::geometry::mesh::Mesh;
    use crate::geometry::nurbs::NurbsSurface;
    use crate::geometry::nurbs::shapes::{cone, cylinder, loft, sphere, torus};
    use crate::geometry::{Point, Rigid, Vector};
    use crate::observe::Silent;

    const TOLERANCE: f64 = 1e-4;

    fn part(surface: NurbsSurface, to: &Rigid) -> Part {
        let face = Face { name: "a".into(), kind: SurfaceKind::BSpline, surface, reversed: false, loops: vec![] };
        Part::from_brep(Brep { faces: vec![face], edges: vec![] }, 0.01, &Silent).unwrap().moved(to)
    }

    /// The z axis of a shape, turned by `lean` from the section's normal x.
    fn leaning(lean: f64, shift: f64) -> Rigid {
        let upright = Rigid::rotation(Vector::y() * std::f64::consts::FRAC_PI_2);
        Rigid::translation(shift, 0.3, -0.2)
            * Rigid::rotation(Vector::new(0.3, 0.0, 0.0))
            * Rigid::rotation(Vector::z() * lean)
            * upright
    }

    fn sampled(curves: &SectionCurves) -> Vec<Point> {
        let one = |c: &NurbsCurve| {
            let [a, b] = c.domain();
            (0..=3000).map(|k| c.point(a + (b - a) * f64::from(k) / 3000.0)).collect::<Vec<_>>()
        };
        curves.pieces.iter().flat_map(one).collect()
    }

    /// Every curve lies in the plane, is C² inside, begins where the one before it ends, and is
    /// within its bound of the surface, by the shape's equation.
    fn check(part: &Part, to: &Rigid, x_mm: f64, loops: usize, off: impl Fn(Point) -> f64) -> Vec<SectionCurves> {
        let found = curves(part, x_mm, TOLERANCE).unwrap();
        assert_eq!(found.len(), loops);
        for l in &found {
            assert!(l.off_mm <= 1.25 * TOLERANCE, "{}", l.off_mm);
            for (k, c) in l.pieces.iter().enumerate() {
                c.validate().unwrap();
                let inner = &c.knots[c.degree + 1..c.points.len()];
                assert!(c.degree <= 3 && inner.windows(2).all(|w| w[0] < w[1]));
                let next = &l.pieces[(k + 1) % l.pieces.len()];
                assert!((c.point(c.domain()[1]) - next.point(next.domain()[0])).norm() < 1e-9);
            }
            for p in sampled(l) {
                assert!((p.x - x_mm).abs() < 1e-9);
                let d = off(to.inverse() * p).abs();
                assert!(d <= l.off_mm + 1e-9, "{d} against {}", l.off_mm);
            }
        }
        found
    }

    #[test]
    fn planes_through_round_shapes_in_closed_form() {
        for lean in [0.0, 0.6] {
            let to = leaning(lean, -20.0);
            check(&part(cylinder(5.0, 40.0), &to), &to, -2.0, 1, |p| p.x.hypot(p.y) - 5.0);
            let to = leaning(0.4 * lean, -20.0);
            // The apex lies at the origin; the wall's half angle has the tangent 0.2.
            let cosine = 1.0 / 0.2f64.hypot(1.0);
            check(&part(cone(8.0, 40.0), &to), &to, 1.3, 1, |p| (p.x.hypot(p.y) - 0.2 * p.z) * cosine);
            let to = leaning(lean, 1.0);
            let ball = check(&part(sphere(6.0), &to), &to, 3.0, 1, |p| p.coords.norm() - 6.0);
            let length: f64 = sampled(&ball[0]).windows(2).map(|w| (w[1] - w[0]).norm()).sum();
            assert!((length - std::f64::consts::TAU * 32.0f64.sqrt()).abs() < 1e-3, "{length}");
            // Upright: two circles; leaning by more than its slope: two ovals.
            let ring = |p: Point| (p.x.hypot(p.y) - 10.0).hypot(p.z) - 3.0;
            let to = leaning(lean, 0.0);
            check(&part(torus(10.0, 3.0), &to), &to, 0.4, 2, ring);
        }
        // Beside the axis: one spiric oval with a waist (Perseus), concave in places.
        let to = leaning(std::f64::consts::FRAC_PI_2, 0.0);
        check(&part(torus(10.0, 3.0), &to), &to, 8.0, 1, |p| (p.x.hypot(p.y) - 10.0).hypot(p.z) - 3.0);
    }

    #[test]
    fn corners_are_points_of_the_edges() {
        // A can along y, cut beside its axis: a rectangle, whose corners are on the rims.
        let to = leaning(std::f64::consts::FRAC_PI_2, 0.0);
        let part = Part::from_brep(can(5.0, 12.0), 0.01, &Silent).unwrap().moved(&to);
        let found = curves(&part, 3.0, TOLERANCE).unwrap();
        assert_eq!((found.len(), found[0].pieces.len()), (1, 4));
        let mut sides: Vec<f64> = found[0]
            .pieces
            .iter()
            .map(|c| {
                let [a, b] = c.domain().map(|t| c.point(t));
                (b - a).norm()
            })
            .collect();
        sides.sort_by(f64::total_cmp);
        for (side, wanted) in sides.iter().zip([8.0, 8.0, 12.0, 12.0]) {
            assert!((side - wanted).abs() < 1e-7, "{sides:?}");
        }
        assert!(found[0].off_mm < 1e-7);
        // Leaning: part of an ellipse, closed by a straight line across the upper cap.
        let to = leaning(1.0, 0.0);
        let part = Part::from_brep(can(5.0, 12.0), 0.01, &Silent).unwrap().moved(&to);
        let found = curves(&part, 5.0, TOLERANCE).unwrap();
        assert_eq!((found.len(), found[0].pieces.len()), (1, 2));
        for p in sampled(&found[0]).into_iter().map(|p| to.inverse() * p) {
            let off = (p.x.hypot(p.y) - 5.0).abs().min((p.z - 12.0).abs());
            assert!(off <= found[0].off_mm + 1e-9, "{off}");
        }
    }

    #[test]
    fn what_is_no_section_is_refused() {
        let whole = part(sphere(6.0), &Rigid::identity());
        assert_eq!(curves(&whole, 0.0, 0.0).unwrap_err().kind, ErrorKind::Usage);
        assert_eq!(curves(&whole, 9.0, TOLERANCE).unwrap_err().kind, ErrorKind::Infeasible);
        assert_eq!(curves(&Part::from_mesh(Mesh::default()), 0.0, TOLERANCE).unwrap_err().kind, ErrorKind::Usage);
        // A sheet: its section does not close.
        let open = part(loft(), &Rigid::rotation(Vector::y() * 1.5));
        assert_eq!(curves(&open, 0.5, TOLERANCE).unwrap_err().kind, ErrorKind::Infeasible);
    }
}
