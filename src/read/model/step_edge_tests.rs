//! Edges of every kind of curve, in STEP files written by hand: a flat face between a curve from
//! (0, 0, 0) to (4, 0, 0) and the line back.
#![allow(clippy::unwrap_used)]

use std::path::Path;

use super::step_tests::Sheet;
use super::*;
use crate::geometry::Point;
use crate::geometry::brep::Edge;
use crate::geometry::part::Part;
use crate::observe::Silent;

const A: [f64; 3] = [0.0, 0.0, 0.0];
const B: [f64; 3] = [4.0, 0.0, 0.0];

/// The file whose face is bounded by `curve`, and by straight lines from vertex to vertex back to
/// the first.
fn sheet(curve: impl Fn(&mut Sheet) -> usize, sense: bool, vertices: &[[f64; 3]]) -> String {
    let mut sheet = Sheet::default();
    let frame = sheet.frame([0.0; 3], [0.0, 0.0, 1.0], [1.0, 0.0, 0.0]);
    let plane = sheet.add(format!("PLANE('',#{frame})"));
    let at: Vec<([f64; 3], usize)> = vertices.iter().map(|p| (*p, sheet.vertex(*p))).collect();
    let curve = curve(&mut sheet);
    let flag = if sense { ".T." } else { ".F." };
    let last = at[at.len() - 1].1;
    let mut edges = vec![(sheet.add(format!("EDGE_CURVE('',#{},#{last},#{curve},{flag})", at[0].1)), true)];
    for k in (1..at.len()).rev() {
        edges.push((sheet.line(at[k], at[k - 1]), true));
    }
    let face = sheet.face(plane, true, &edges);
    let shell = sheet.add(format!("OPEN_SHELL('',(#{face}))"));
    let model = sheet.add(format!("SHELL_BASED_SURFACE_MODEL('',(#{shell}))"));
    sheet.file("mm", &[model])
}

fn read(text: &str) -> Result<faces::FaceModel> {
    step::read(Path::new("test.step"), text.as_bytes(), None)
}

/// Points along the first edge; the face can be meshed.
fn along(text: &str) -> Vec<Point> {
    let model = read(text).unwrap();
    let edge: Edge = model.brep.edges[0].clone();
    Part::meshed(model.brep, 0.01, &Silent).unwrap();
    (0..=64).map(|k| edge.at(f64::from(k) / 64.0)).collect()
}

fn check(name: &str, text: &str, off: impl Fn(&Point) -> f64, through: [f64; 3]) {
    let points = along(text);
    let [first, last] = [points[0], points[64]];
    assert!((first - Point::from(A)).norm() < 1e-6 && (last - Point::from(B)).norm() < 1e-6, "{name}: {first} {last}");
    let worst = points.iter().map(|p| off(p).abs()).fold(0.0, f64::max);
    assert!(worst < 1e-9, "{name}: {worst:e}");
    let through = Point::from(through);
    let near = points.windows(2).map(|w| crate::geometry::triangle::closest_on_segment(&w[0], &w[1], &through));
    let near = near.map(|p| (p - through).norm()).fold(f64::INFINITY, f64::min);
    assert!(near < 0.01, "{name}: {near}");
}

fn ids(sheet: &mut Sheet, points: &[[f64; 3]]) -> String {
    let ids: Vec<usize> = points.iter().map(|p| sheet.point(*p)).collect();
    Sheet::list(&ids)
}

#[test]
fn conics() {
    let circle = |s: &mut Sheet| {
        let f = s.frame([2., 0., 0.], [0., 0., 1.], [1., 0., 0.]);
        s.add(format!("CIRCLE('',#{f},2.0)"))
    };
    let on_circle = |p: &Point| (p - Point::new(2., 0., 0.)).norm() - 2.0;
    check("circle", &sheet(circle, true, &[A, B]), on_circle, [2., -2., 0.]);
    check("circle against its sense", &sheet(circle, false, &[A, B]), on_circle, [2., 2., 0.]);
    let ellipse = |s: &mut Sheet| {
        let f = s.frame([2., 0., 0.], [0., 0., 1.], [1., 0., 0.]);
        s.add(format!("ELLIPSE('',#{f},2.0,1.0)"))
    };
    check("ellipse", &sheet(ellipse, true, &[A, B]), |p| (0.5 * p.x - 1.0).hypot(p.y) - 1.0, [2., -1., 0.]);
    let parabola = |s: &mut Sheet| {
        let f = s.frame([2., -1., 0.], [0., 0., 1.], [0., 1., 0.]);
        s.add(format!("PARABOLA('',#{f},1.0)"))
    };
    let on_parabola = |p: &Point| p.y + 1.0 - 0.25 * (p.x - 2.0).powi(2);
    check("parabola", &sheet(parabola, true, &[A, B]), on_parabola, [2., -1., 0.]);
    let b = 2.0 / 1.25_f64.sqrt();
    let hyperbola = |s: &mut Sheet| {
        let f = s.frame([2., -3., 0.], [0., 0., 1.], [0., 1., 0.]);
        s.add(format!("HYPERBOLA('',#{f},2.0,{b:?})"))
    };
    let on_hyperbola = |p: &Point| ((p.y + 3.0) / 2.0).powi(2) - ((p.x - 2.0) / b).powi(2) - 1.0;
    check("hyperbola", &sheet(hyperbola, true, &[A, B]), on_hyperbola, [2., -1., 0.]);
}

#[test]
fn splines_of_every_kind() {
    // y = −x (4 − x) / 4 as a quadratic.
    let on = |p: &Point| p.y + 0.25 * p.x * (4.0 - p.x);
    let poles = [A, [2., -2., 0.], B];
    let bezier = |s: &mut Sheet| {
        let p = ids(s, &poles);
        s.add(format!("BEZIER_CURVE('',2,({p}),.UNSPECIFIED.,.F.,.F.)"))
    };
    check("Bezier", &sheet(bezier, true, &[A, B]), on, [2., -1., 0.]);
    let quasi = |s: &mut Sheet| {
        let p = ids(s, &poles);
        s.add(format!("QUASI_UNIFORM_CURVE('',2,({p}),.UNSPECIFIED.,.F.,.F.)"))
    };
    check("quasi-uniform", &sheet(quasi, true, &[A, B]), on, [2., -1., 0.]);
    let knots = |s: &mut Sheet| {
        let p = ids(s, &poles);
        s.add(format!("B_SPLINE_CURVE_WITH_KNOTS('',2,({p}),.UNSPECIFIED.,.F.,.F.,(3,3),(0.,1.),.UNSPECIFIED.)"))
    };
    check("with knots", &sheet(knots, true, &[A, B]), on, [2., -1., 0.]);
    // The flag of the sense says otherwise than the vertices: these count.
    check("flag of the sense", &sheet(knots, false, &[A, B]), on, [2., -1., 0.]);
    // Not clamped: over its middle span the same parabola, from (0, 0) to (4, −0).
    let uniform = |s: &mut Sheet| {
        let p = ids(s, &[[-2., 2., 0.], [2., -2., 0.], [6., 2., 0.]]);
        s.add(format!("UNIFORM_CURVE('',2,({p}),.UNSPECIFIED.,.F.,.F.)"))
    };
    check("uniform", &sheet(uniform, true, &[A, B]), on, [2., -1., 0.]);
    let w = std::f64::consts::FRAC_1_SQRT_2;
    let rational = |s: &mut Sheet| {
        let p = ids(s, &[A, [0., -2., 0.], [2., -2., 0.], [4., -2., 0.], B]);
        s.add(format!(
            "(BOUNDED_CURVE()B_SPLINE_CURVE(2,({p}),.UNSPECIFIED.,.F.,.F.)\
             B_SPLINE_CURVE_WITH_KNOTS((3,2,3),(0.,1.,2.),.UNSPECIFIED.)CURVE()GEOMETRIC_REPRESENTATION_ITEM()\
             RATIONAL_B_SPLINE_CURVE((1.,{w:?},1.,{w:?},1.))REPRESENTATION_ITEM(''))"
        ))
    };
    check("rational", &sheet(rational, true, &[A, B]), |p| (p - Point::new(2., 0., 0.)).norm() - 2.0, [2., -2., 0.]);
}

#[test]
fn curves_of_curves() {
    let on_lines = |p: &Point| p.y + 2.0 - (p.x - 2.0).abs();
    let polyline = |s: &mut Sheet| {
        let p = ids(s, &[A, [2., -2., 0.], B]);
        s.add(format!("POLYLINE('',({p}))"))
    };
    check("polyline", &sheet(polyline, true, &[A, B]), on_lines, [2., -2., 0.]);
    let trimmed = |s: &mut Sheet| {
        let f = s.frame([2., 0., 0.], [0., 0., 1.], [1., 0., 0.]);
        let (c, [a, b]) = (s.add(format!("CIRCLE('',#{f},2.0)")), [A, B].map(|p| s.point(p)));
        s.add(format!("TRIMMED_CURVE('',#{c},(#{a}),(#{b}),.T.,.CARTESIAN.)"))
    };
    let on_circle = |p: &Point| (p - Point::new(2., 0., 0.)).norm() - 2.0;
    check("trimmed", &sheet(trimmed, true, &[A, B]), on_circle, [2., -2., 0.]);
    let composite = |s: &mut Sheet| {
        let halves = [[A, [2., -2., 0.]], [[2., -2., 0.], B]].map(|ends| {
            let p = ids(s, &ends);
            let line = s.add(format!("POLYLINE('',({p}))"));
            s.add(format!("COMPOSITE_CURVE_SEGMENT(.CONTINUOUS.,.T.,#{line})"))
        });
        s.add(format!("COMPOSITE_CURVE('',({}),.F.)", Sheet::list(&halves)))
    };
    check("composite", &sheet(composite, true, &[A, B]), on_lines, [2., -2., 0.]);
    for kind in ["SURFACE_CURVE", "SEAM_CURVE", "INTERSECTION_CURVE"] {
        let on_surface = |s: &mut Sheet| {
            let c = trimmed(s);
            let frames = [0, 1].map(|_| s.frame([0.0; 3], [0., 0., 1.], [1., 0., 0.]));
            let planes = frames.map(|f| s.add(format!("PLANE('',#{f})")));
            s.add(format!("{kind}('',#{c},({}),.CURVE_3D.)", Sheet::list(&planes)))
        };
        check(kind, &sheet(on_surface, true, &[A, B]), on_circle, [2., -2., 0.]);
    }
}

/// A closed spline that begins in the middle of the edge, in both senses.
#[test]
fn a_closed_spline_whose_beginning_lies_on_the_edge() {
    let w = std::f64::consts::FRAC_1_SQRT_2;
    let closed = |s: &mut Sheet| {
        // The circle about (2, 0) from (2, −2) counter-clockwise.
        let p = ids(
            s,
            &[
                [2., -2., 0.],
                [4., -2., 0.],
                B,
                [4., 2., 0.],
                [2., 2., 0.],
                [0., 2., 0.],
                A,
                [0., -2., 0.],
                [2., -2., 0.],
            ],
        );
        s.add(format!(
            "(BOUNDED_CURVE()B_SPLINE_CURVE(2,({p}),.UNSPECIFIED.,.T.,.F.)\
             B_SPLINE_CURVE_WITH_KNOTS((3,2,2,2,3),(0.,1.,2.,3.,4.),.UNSPECIFIED.)CURVE()GEOMETRIC_REPRESENTATION_ITEM()\
             RATIONAL_B_SPLINE_CURVE((1.,{w:?},1.,{w:?},1.,{w:?},1.,{w:?},1.))REPRESENTATION_ITEM(''))"
        ))
    };
    let on_circle = |p: &Point| (p - Point::new(2., 0., 0.)).norm() - 2.0;
    check("through its beginning", &sheet(closed, true, &[A, B]), on_circle, [2., -2., 0.]);
    check("the other way", &sheet(closed, false, &[A, B]), on_circle, [2., 2., 0.]);
}

/// A closed spline cut at two vertices a hundredth apart, one of them its own beginning but for
/// rounding: nearly all of it, and the hundredth.
#[test]
fn a_closed_spline_cut_beside_its_beginning() {
    for sense in [true, false] {
        let mut s = Sheet::default();
        let frame = s.frame([0.0; 3], [0.0, 0.0, 1.0], [1.0, 0.0, 0.0]);
        let plane = s.add(format!("PLANE('',#{frame})"));
        let at = |angle: f64| [2.0 + 2.0 * angle.cos(), 2.0 * angle.sin(), 0.0];
        let [begin, cut] = [5e-6, 0.005].map(|angle| s.vertex(at(angle)));
        let w = std::f64::consts::FRAC_1_SQRT_2;
        let round = [B, [4., 2., 0.], [2., 2., 0.], [0., 2., 0.], A, [0., -2., 0.], [2., -2., 0.], [4., -2., 0.], B];
        let p = ids(&mut s, &round);
        let circle = s.add(format!(
            "(BOUNDED_CURVE()B_SPLINE_CURVE(2,({p}),.UNSPECIFIED.,.T.,.F.)\
             B_SPLINE_CURVE_WITH_KNOTS((3,2,2,2,3),(0.,1.,2.,3.,4.),.UNSPECIFIED.)CURVE()GEOMETRIC_REPRESENTATION_ITEM()\
             RATIONAL_B_SPLINE_CURVE((1.,{w:?},1.,{w:?},1.,{w:?},1.,{w:?},1.))REPRESENTATION_ITEM(''))"
        ));
        let (long, flag) = if sense { ([cut, begin], ".T.") } else { ([begin, cut], ".F.") };
        let edges = [long, [long[1], long[0]]]
            .map(|[a, b]| (s.add(format!("EDGE_CURVE('',#{a},#{b},#{circle},{flag})")), true));
        let face = s.face(plane, true, &edges);
        let shell = s.add(format!("OPEN_SHELL('',(#{face}))"));
        let model = s.add(format!("SHELL_BASED_SURFACE_MODEL('',(#{shell}))"));
        let read = read(&s.file("mm", &[model])).unwrap();
        let length = |edge: &Edge| -> f64 {
            (0..400).map(|k| (edge.at(f64::from(k + 1) / 400.0) - edge.at(f64::from(k) / 400.0)).norm()).sum()
        };
        let [long, short] = [0, 1].map(|k| length(&read.brep.edges[k]));
        assert!((long - (4.0 * std::f64::consts::PI - 0.01)).abs() < 1e-3, "{sense}: {long}");
        assert!((short - 0.00999).abs() < 1e-6, "{sense}: {short}");
        let part = Part::meshed(read.brep, 0.001, &Silent).unwrap();
        assert!((part.mesh.area_mm2() - 4.0 * std::f64::consts::PI).abs() < 0.02);
    }
}

/// A closed spline between two vertices of which one lies a hundredth off it, beside the other: the
/// edge is the whole curve.
#[test]
fn a_closed_spline_between_vertices_in_one_place() {
    let mut s = Sheet::default();
    let frame = s.frame([0.0; 3], [0.0, 0.0, 1.0], [1.0, 0.0, 0.0]);
    let plane = s.add(format!("PLANE('',#{frame})"));
    let [on, off] = [[4., 0., 0.], [4.01, 0., 0.]].map(|p| (p, s.vertex(p)));
    let w = std::f64::consts::FRAC_1_SQRT_2;
    let p =
        ids(&mut s, &[B, [4., 2., 0.], [2., 2., 0.], [0., 2., 0.], A, [0., -2., 0.], [2., -2., 0.], [4., -2., 0.], B]);
    let circle = s.add(format!(
        "(BOUNDED_CURVE()B_SPLINE_CURVE(2,({p}),.UNSPECIFIED.,.T.,.F.)\
         B_SPLINE_CURVE_WITH_KNOTS((3,2,2,2,3),(0.,1.,2.,3.,4.),.UNSPECIFIED.)CURVE()GEOMETRIC_REPRESENTATION_ITEM()\
         RATIONAL_B_SPLINE_CURVE((1.,{w:?},1.,{w:?},1.,{w:?},1.,{w:?},1.))REPRESENTATION_ITEM(''))"
    ));
    let edges = [(s.add(format!("EDGE_CURVE('',#{},#{},#{circle},.T.)", off.1, on.1)), true), (s.line(on, off), true)];
    let face = s.face(plane, true, &edges);
    let shell = s.add(format!("OPEN_SHELL('',(#{face}))"));
    let model = s.add(format!("SHELL_BASED_SURFACE_MODEL('',(#{shell}))"));
    let read = read(&s.file("mm", &[model])).unwrap();
    let edge = &read.brep.edges[0];
    let length: f64 =
        (0..400).map(|k| (edge.at(f64::from(k + 1) / 400.0) - edge.at(f64::from(k) / 400.0)).norm()).sum();
    assert!((length - 4.0 * std::f64::consts::PI).abs() < 1e-3, "{length}");
}

/// An edge from a vertex to itself on a straight line has no length; the loop goes on without it.
#[test]
fn edges_without_length_are_left_out() {
    let mut s = Sheet::default();
    let frame = s.frame([0.0; 3], [0.0, 0.0, 1.0], [1.0, 0.0, 0.0]);
    let plane = s.add(format!("PLANE('',#{frame})"));
    let corners = [A, B, [4., 3., 0.]].map(|p| (p, s.vertex(p)));
    let mut edges = Vec::new();
    for k in 0..3 {
        let next = corners[(k + 1) % 3];
        edges.push((s.line(corners[k], next), true));
        let (p, d) = (s.point(next.0), s.direction([0., 1., 0.]));
        let v = s.add(format!("VECTOR('',#{d},1.0)"));
        let line = s.add(format!("LINE('',#{p},#{v})"));
        edges.push((s.add(format!("EDGE_CURVE('',#{0},#{0},#{line},.T.)", next.1)), true));
    }
    let face = s.face(plane, true, &edges);
    let shell = s.add(format!("OPEN_SHELL('',(#{face}))"));
    let model = s.add(format!("SHELL_BASED_SURFACE_MODEL('',(#{shell}))"));
    let read = read(&s.file("mm", &[model])).unwrap();
    assert_eq!((read.brep.edges.len(), read.brep.faces[0].loops[0].len()), (3, 3));
    let part = Part::meshed(read.brep, 0.01, &Silent).unwrap();
    assert!((part.mesh.area_mm2() - 6.0).abs() < 1e-9);
}
