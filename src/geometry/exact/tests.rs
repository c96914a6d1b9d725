#![allow(clippy::unwrap_used)]
use nalgebra::Vector4;

use super::Exact;
use super::search::{NEGLIGIBLE_MM, counted};

use crate::geometry::brep::{Brep, Coedge, Edge, Face, FaceName, SurfaceKind};
use crate::geometry::mesh::topology;
use crate::geometry::nurbs::shapes::{cone, cylinder, loft, sphere, torus};
use crate::geometry::nurbs::{NurbsCurve, NurbsSurface};
use crate::geometry::part::Part;
use crate::geometry::tessellate::edges::closed_gaps;
use crate::geometry::tessellate::{TessellateOptions, tessellate};
use crate::geometry::{Point, Vector};
use crate::observe::Silent;

/// A part of one face without loops.
fn part(surface: NurbsSurface, deflection_mm: f64) -> Part {
    let face =
        Face { name: FaceName::Numbered(1), kind: SurfaceKind::BSpline, surface, reversed: false, loops: vec![] };
    Part::from_brep(Brep { faces: vec![face], edges: vec![] }, deflection_mm, &Silent).unwrap()
}

fn face(surface: NurbsSurface, reversed: bool, loops: Vec<Vec<Coedge>>) -> Face {
    Face { name: "a face".into(), kind: SurfaceKind::BSpline, surface, reversed, loops }
}

/// A plane through `o` along `u` and `v`.
pub fn plane(o: Point, u: Vector, v: Vector) -> NurbsSurface {
    let h = |p: Point| Vector4::new(p.x, p.y, p.z, 1.0);
    NurbsSurface::bilinear([h(o), h(o + v), h(o + u), h(o + u + v)])
}

/// The circle of a cylinder's or cone's end.
fn circle(surface: &NurbsSurface, v: f64) -> Edge {
    let curve = crate::geometry::tessellate::edges::iso_curve(surface, 0, v);
    Edge { t: curve.domain(), curve }
}

fn used(edge: usize, reversed: bool) -> Coedge {
    Coedge { edge, reversed }
}

/// A cylinder with caps; its wall has two loops and no seam. The caps' planes are larger than their
/// circles.
pub fn can(radius: f64, height: f64) -> Brep {
    let wall = cylinder(radius, height);
    let edges = vec![circle(&wall, 0.0), circle(&wall, 1.0)];
    let (x, y) = (Vector::x() * 3.0 * radius, Vector::y() * 3.0 * radius);
    let cap = |z: f64| plane(Point::new(-1.5 * radius, -1.5 * radius, z), x, y);
    let faces = vec![
        face(wall, false, vec![vec![used(0, false)], vec![used(1, true)]]),
        face(cap(0.0), true, vec![vec![used(0, true)]]),
        face(cap(height), false, vec![vec![used(1, false)]]),
    ];
    Brep { faces, edges }
}

/// A box of these sides with a corner at the origin; each face has edges of its own, which coincide
/// in pairs.
pub fn block(size: Vector) -> Brep {
    let mut brep = Brep::default();
    for axis in 0..3 {
        let [u, v] = [(axis + 1) % 3, (axis + 2) % 3].map(|k| {
            let mut e = Vector::zeros();
            e[k] = size[k];
            e
        });
        for (at, reversed) in [(0.0, true), (size[axis], false)] {
            let mut o = Point::origin();
            o[axis] = at;
            let corners = [o, o + u, o + u + v, o + v];
            let base = brep.edges.len();
            for k in 0..4 {
                let points = [corners[k], corners[(k + 1) % 4]].map(|p| Vector4::new(p.x, p.y, p.z, 1.0));
                let curve = NurbsCurve { degree: 1, knots: vec![0.0, 0.0, 1.0, 1.0], points: points.to_vec() };
                brep.edges.push(Edge { curve, t: [0.0, 1.0] });
            }
            let one = (base..base + 4).map(|e| used(e, false)).collect();
            brep.faces.push(face(plane(o, u, v), reversed, vec![one]));
        }
    }
    brep
}

/// Points in a cube of this half side, in a fixed order (a linear congruential generator).
fn points(half: f64, count: usize) -> impl Iterator<Item = Point> {
    let mut state = 12345u64;
    let mut next = move || {
        state = state.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
        ((state >> 11) as f64 / (1u64 << 53) as f64 * 2.0 - 1.0) * half
    };
    (0..count).map(move |_| Point::new(next(), next(), next()))
}

#[test]
fn sphere_and_torus_in_closed_form() {
    let ball = part(sphere(10.0), 0.02);
    for q in points(16.0, 2000) {
        let c = ball.closest(&q, f64::INFINITY).unwrap();
        assert!((c.distance_mm - (q.coords.norm() - 10.0).abs()).abs() < 1e-9, "{q}: {}", c.distance_mm);
        assert!((c.normal - c.point.coords / 10.0).norm() < 1e-6);
    }
    let ring = part(torus(10.0, 3.0), 0.02);
    for q in points(16.0, 2000) {
        let c = ring.closest(&q, f64::INFINITY).unwrap();
        let exact = ((q.x.hypot(q.y) - 10.0).hypot(q.z) - 3.0).abs();
        assert!((c.distance_mm - exact).abs() < 1e-9, "{q}: {} {exact}", c.distance_mm);
        let tube = q - Vector::new(q.x, q.y, 0.0).normalize() * 10.0;
        assert!((c.normal - tube.coords.normalize()).norm() < 1e-6);
    }
}

#[test]
fn can_with_sharp_rims_in_closed_form() {
    let (radius, height) = (5.0, 8.0);
    let part = Part::from_brep(can(radius, height), 0.02, &Silent).unwrap();
    assert!(topology(&part.mesh).closed(), "{:?}", topology(&part.mesh));
    let volume = std::f64::consts::PI * radius * radius * height;
    assert!((part.mesh.volume_mm3() / volume - 1.0).abs() < 0.01);
    for q in points(10.0, 3000) {
        let (r, z) = (q.x.hypot(q.y) - radius, (-q.z).max(q.z - height));
        let exact = if r <= 0.0 && z <= 0.0 { r.max(z).abs() } else { r.max(0.0).hypot(z.max(0.0)) };
        let c = part.closest(&q, f64::INFINITY).unwrap();
        assert!((c.distance_mm - exact).abs() < 1e-7, "{q}: {} {exact}", c.distance_mm);
        assert!((c.normal.norm() - 1.0).abs() < 1e-12);
        if exact > 0.05 {
            assert_eq!(part.inside(&q), r < 0.0 && z < 0.0, "{q}");
        }
    }
    assert!(part.closest(&Point::new(0.0, 0.0, 20.0), 11.9).is_none());
    assert!(part.closest(&Point::new(0.0, 0.0, 20.0), 12.1).is_some());
}

#[test]
fn box_whose_faces_share_no_edges_is_closed_and_exact() {
    let size = Vector::new(3.0, 4.0, 6.0);
    let part = Part::from_brep(block(size), 0.02, &Silent).unwrap();
    assert!(topology(&part.mesh).closed(), "{:?}", topology(&part.mesh));
    assert!((part.mesh.volume_mm3() - 72.0).abs() < 1e-9);
    for q in points(9.0, 2000) {
        let over = Vector::from_fn(|k, _| (-q[k]).max(q[k] - size[k]));
        let outside = over.map(|x| x.max(0.0)).norm();
        let exact = if outside > 0.0 { outside } else { over.max().abs() };
        let c = part.closest(&q, f64::INFINITY).unwrap();
        assert!((c.distance_mm - exact).abs() < 1e-8, "{q}: {} {exact}", c.distance_mm);
    }
}

#[test]
fn cone_over_its_apex() {
    // The wall has one loop and a pole; the lid closes it.
    let wall = cone(3.0, 4.0);
    let edges = vec![circle(&wall, 1.0)];
    let lid = plane(Point::new(-4.0, -4.0, 4.0), Vector::x() * 8.0, Vector::y() * 8.0);
    let faces = vec![face(wall, false, vec![vec![used(0, true)]]), face(lid, false, vec![vec![used(0, false)]])];
    let part = Part::from_brep(Brep { faces, edges }, 0.02, &Silent).unwrap();
    assert!(topology(&part.mesh).closed(), "{:?}", topology(&part.mesh));
    for q in points(3.0, 2000).filter(|q| q.z < 1.0) {
        // Distance to the generatrix from (0, 0) along (3, 4) / 5 in the half plane (r, z).
        let r = q.x.hypot(q.y);
        let along = (0.6 * r + 0.8 * q.z).max(0.0);
        let exact = (r - 0.6 * along).hypot(q.z - 0.8 * along);
        let c = part.closest(&q, f64::INFINITY).unwrap();
        assert!((c.distance_mm - exact).abs() < 1e-7, "{q}: {} {exact}", c.distance_mm);
    }
}

/// A free-form sheet against a dense search on its surface; with open borders, so edges count.
#[test]
fn free_form_sheet_against_a_dense_search() {
    let sheet = loft();
    let part = part(sheet.clone(), 0.01);
    let n = 200;
    let samples: Vec<([f64; 2], Point)> = (0..=n)
        .flat_map(|i| (0..=n).map(move |j| [f64::from(i) / f64::from(n), f64::from(j) / f64::from(n)]))
        .map(|uv| (uv, sheet.point(uv[0], uv[1])))
        .collect();
    let space = crate::geometry::nurbs::foot::ParameterSpace::of(&sheet, 1e-9);
    for q in points(20.0, 150).map(|q| q + Vector::z() * 20.0) {
        let seed = samples.iter().min_by(|a, b| (a.1 - q).norm().total_cmp(&(b.1 - q).norm())).unwrap();
        let exact = sheet.foot(&q, seed.0, &space).distance_mm;
        let c = part.closest(&q, f64::INFINITY).unwrap();
        assert!((c.distance_mm - exact).abs() < 1e-7, "{q}: {} {exact}", c.distance_mm);
    }
}

/// Along straight walks past rims and across faces the distance never changes faster than the walk.
#[test]
fn distance_is_continuous() {
    let part = Part::from_brep(can(5.0, 8.0), 0.05, &Silent).unwrap();
    let ends: Vec<Point> = points(9.0, 40).collect();
    for pair in ends.chunks_exact(2) {
        let steps = 400;
        let step = (pair[1] - pair[0]).norm() / f64::from(steps);
        let mut before: Option<f64> = None;
        for k in 0..=steps {
            let q = pair[0] + (pair[1] - pair[0]) * (f64::from(k) / f64::from(steps));
            let d = part.closest(&q, f64::INFINITY).unwrap().distance_mm;
            if let Some(b) = before {
                assert!((d - b).abs() <= step + 1e-8, "{q}: {b} to {d}, step {step}");
            }
            before = Some(d);
        }
    }
}

#[test]
fn moving_the_part_moves_its_feet() {
    let to_from = crate::geometry::Rigid::new(Vector::new(3.0, -7.0, 11.0), Vector::new(0.4, 1.1, -0.7));
    let part = Part::from_brep(can(5.0, 8.0), 0.05, &Silent).unwrap();
    let moved = part.clone().moved(&to_from);
    for q in points(9.0, 200) {
        let (a, b) = (part.closest(&q, 100.0).unwrap(), moved.closest(&(to_from * q), 100.0).unwrap());
        assert!((a.distance_mm - b.distance_mm).abs() < 1e-9);
    }
}

#[test]
fn broken_faces_are_named() {
    let mut brep = can(5.0, 8.0);
    brep.faces[0].loops.pop();
    let e = Part::from_brep(brep, 0.05, &Silent).err().unwrap();
    assert!(e.message.contains("a face") && e.message.contains("second one"), "{e}");
    let mut brep = can(5.0, 8.0);
    brep.edges[1].curve.points.iter_mut().for_each(|p| p.z += 0.3 * p.w);
    let e = Part::from_brep(brep, 0.05, &Silent).err().unwrap();
    assert!(e.message.contains("leaves its surface"), "{e}");
    // An edge that ends short of the next one: by a little less than what is healed, and by more.
    for (short_mm, healed) in [(0.04, true), (0.08, false)] {
        let mut brep = block(Vector::new(1.0, 2.0, 3.0));
        let edge = &mut brep.edges[brep.faces[3].loops[0][1].edge].curve.points;
        let way = (edge[0] - edge[1]).xyz().normalize() * short_mm;
        edge[1] += Vector4::new(way.x, way.y, way.z, 0.0);
        let gaps = closed_gaps(&brep, 0.02);
        assert!(gaps.len() == usize::from(healed) && gaps.iter().all(|gap| (gap.0 - short_mm).abs() < 1e-12));
        match Part::from_brep(brep, 0.05, &Silent) {
            Ok(part) => assert!(healed && (part.mesh.volume_mm3() - 6.0).abs() < 0.3),
            Err(e) => assert!(!healed && e.message.contains("a gap of 0.0800 mm"), "{e}"),
        }
    }
    let mut brep = block(Vector::new(1.0, 2.0, 3.0));
    brep.faces[3].loops[0].pop();
    assert!(Part::from_brep(brep, 0.05, &Silent).err().unwrap().message.contains("instead of closing"));
    let mut brep = can(5.0, 8.0);
    brep.faces[1].loops[0][0].edge = 99;
    assert!(Part::from_brep(brep, 0.05, &Silent).is_err());
    assert!(Part::from_brep(can(5.0, 8.0), 0.0, &Silent).is_err());
}

/// A straight prism over a counter-clockwise polygon, from z = 0 to `height`; faces do not share
/// edges.
fn prism(polygon: &[[f64; 2]], height: f64) -> Brep {
    let mut brep = Brep::default();
    let mut add = |surface: NurbsSurface, corners: &[Point]| {
        let base = brep.edges.len();
        for k in 0..corners.len() {
            let points = [corners[k], corners[(k + 1) % corners.len()]].map(|p| Vector4::new(p.x, p.y, p.z, 1.0));
            let curve = NurbsCurve { degree: 1, knots: vec![0.0, 0.0, 1.0, 1.0], points: points.to_vec() };
            brep.edges.push(Edge { curve, t: [0.0, 1.0] });
        }
        let ring = (base..base + corners.len()).map(|e| used(e, false)).collect();
        brep.faces.push(face(surface, false, vec![ring]));
    };
    let up = Vector::z() * height;
    let ground: Vec<Point> = polygon.iter().map(|p| Point::new(p[0], p[1], 0.0)).collect();
    for k in 0..ground.len() {
        let (a, b) = (ground[k], ground[(k + 1) % ground.len()]);
        add(plane(a, b - a, up), &[a, b, b + up, a + up]);
    }
    let top: Vec<Point> = ground.iter().map(|p| p + up).collect();
    let bottom: Vec<Point> = ground.iter().rev().copied().collect();
    add(plane(Point::new(-20.0, -20.0, height), Vector::x() * 40.0, Vector::y() * 40.0), &top);
    add(plane(Point::new(-20.0, -20.0, 0.0), Vector::y() * 40.0, Vector::x() * 40.0), &bottom);
    brep
}

/// Even and odd crossings of a ray along x.
fn within(polygon: &[[f64; 2]], p: &Point) -> bool {
    let n = polygon.len();
    let crossed = |k: &usize| {
        let (a, b) = (polygon[*k], polygon[(*k + 1) % n]);
        (a[1] > p.y) != (b[1] > p.y) && p.x < a[0] + (p.y - a[1]) / (b[1] - a[1]) * (b[0] - a[0])
    };
    (0..n).filter(crossed).count() % 2 == 1
}

/// Sharp, blunt and inward corners: about every edge and vertex, as near as 10⁻³ mm, the sign is
/// right.
#[test]
fn inside_is_exact_about_edges_and_vertices() {
    // A dart with a tip of 9° and an inward corner.
    let arrow = [[-3.0, 0.0], [10.0, 1.0], [-3.0, 2.0], [-1.0, 1.0]];
    let height = 3.0;
    let part = Part::from_brep(prism(&arrow, height), 0.02, &Silent).unwrap();
    assert!(topology(&part.mesh).closed());
    let corners: Vec<Point> = arrow.iter().flat_map(|p| [0.0, height].map(|z| Point::new(p[0], p[1], z))).collect();
    let middles: Vec<Point> = (0..arrow.len())
        .map(|k| Point::new(arrow[k][0], arrow[k][1], 1.3))
        .chain(corners.iter().zip(&corners[2..]).map(|(a, b)| nalgebra::center(a, b)))
        .collect();
    let mut tried = 0;
    for about in corners.iter().chain(&middles) {
        for scale in [1e-3, 0.02, 1.0] {
            for q in points(scale, 40).map(|q| about + q.coords) {
                let truth = within(&arrow, &q) && q.z > 0.0 && q.z < height;
                let d = part.closest(&q, f64::INFINITY).unwrap().distance_mm;
                // Feet may lie 10⁻⁴ mm beyond an edge: nearer than that nothing is promised.
                if d > 2e-4 {
                    assert_eq!(part.inside(&q), truth, "{q} at {d}");
                    tried += 1;
                }
            }
        }
    }
    assert!(tried > 1000, "{tried}");
}

/// A thousandth of the mesh's deflection from the surface the sign is still right.
#[test]
fn inside_is_exact_within_the_deflection() {
    let deflection = 0.1;
    let (ball, ring) = (part(sphere(10.0), deflection), part(torus(10.0, 3.0), deflection));
    for q in points(1.0, 400).filter(|q| q.coords.norm() > 0.1) {
        let direction = q.coords.normalize();
        let around = Vector::new(q.x, q.y, 0.0).try_normalize(1e-3).unwrap_or_else(Vector::x);
        for off in [1e-4, -1e-4, 0.05, -0.05, 0.2, -0.2] {
            assert_eq!(ball.inside(&Point::from(direction * (10.0 + off))), off < 0.0);
            let tube = (around * q.x + Vector::z() * q.z).try_normalize(1e-3).unwrap_or_else(Vector::z);
            assert_eq!(ring.inside(&Point::from(around * 10.0 + tube * (3.0 + off))), off < 0.0);
        }
    }
    let can = Part::from_brep(can(5.0, 8.0), deflection, &Silent).unwrap();
    for q in points(9.0, 2000) {
        let (r, z) = (q.x.hypot(q.y) - 5.0, (-q.z).max(q.z - 8.0));
        if r.abs().min(z.abs()) > 2e-4 {
            assert_eq!(can.inside(&q), r < 0.0 && z < 0.0, "{q}");
        }
    }
}

#[test]
fn curvature_at_a_foot_in_closed_form() {
    let ball = part(sphere(10.0), 0.05);
    let ring = part(torus(10.0, 3.0), 0.05);
    let wall = cone(3.0, 4.0);
    let edges = vec![circle(&wall, 1.0)];
    let funnel = face(wall, false, vec![vec![used(0, true)]]);
    let funnel = Part::from_brep(Brep { faces: vec![funnel], edges }, 0.05, &Silent).unwrap();
    let mut inward = can(5.0, 8.0);
    inward.faces.iter_mut().for_each(|f| f.reversed = !f.reversed);
    let (can, inward) =
        (Part::from_brep(can(5.0, 8.0), 0.05, &Silent).unwrap(), Part::from_brep(inward, 0.05, &Silent).unwrap());
    let is = |part: &Part, q: &Point, a: f64, b: f64| {
        let c = part.closest(q, f64::INFINITY).unwrap();
        let p = part.curvature_at(&c).unwrap();
        assert!((p.curvature[0] - a).abs() < 1e-8 && (p.curvature[1] - b).abs() < 1e-8, "{q}: {p:?} {a} {b}");
        assert!(p.direction.iter().all(|d| d.dot(&c.normal).abs() < 1e-7 && (d.norm() - 1.0).abs() < 1e-9));
    };
    for q in points(12.0, 300).filter(|q| q.x.hypot(q.y) > 0.5) {
        is(&ball, &q, -0.1, -0.1);
        let tube = q - Vector::new(q.x, q.y, 0.0).normalize() * 10.0;
        if tube.coords.norm() > 0.1 {
            let cosine = (q.x.hypot(q.y) - 10.0) / tube.coords.norm();
            is(&ring, &q, -cosine / (10.0 + 3.0 * cosine), -1.0 / 3.0);
        }
        let (wall, low) = (Point::new(q.x, q.y, 4.0), q.x.hypot(q.y));
        if low > 4.0 {
            is(&can, &wall, 0.0, -0.2);
            is(&inward, &wall, 0.2, 0.0);
            let c = can.closest(&wall, 100.0).unwrap();
            let p = can.brep.as_ref().unwrap().faces[c.face as usize].surface.point(c.uv[0], c.uv[1]);
            assert!((p - c.point).norm() < 1e-10);
        }
        // Beside the funnel, at 2.5 along its generatrix: the radius of curvature across is r over
        // the slant's cosine, 4/5.
        let out = Vector::new(q.x, q.y, 0.0).normalize();
        let at = Point::from(out * 1.5 + Vector::z() * 2.0) + (out * 0.8 - Vector::z() * 0.6) * 0.3;
        is(&funnel, &at, 0.0, -0.8 / 1.5);
    }
}

/// Area and volume in closed form, each within its stated error, whatever the tessellation.
#[test]
fn measures_in_closed_form() {
    use std::f64::consts::PI;
    for deflection in [0.2, 0.02] {
        let cases = [
            (part(sphere(10.0), deflection), 400.0 * PI, 4000.0 * PI / 3.0, 2e-4),
            (part(torus(10.0, 3.0), deflection), 120.0 * PI * PI, 180.0 * PI * PI, 2e-4),
            (Part::from_brep(can(5.0, 8.0), deflection, &Silent).unwrap(), 130.0 * PI, 200.0 * PI, 2e-4),
            (Part::from_brep(block(Vector::new(3.0, 4.0, 6.0)), deflection, &Silent).unwrap(), 108.0, 72.0, 1e-12),
        ];
        for (k, (part, area, volume, share)) in cases.iter().enumerate() {
            let m = part.measure();
            let (da, dv) = ((m.area_mm2 - area).abs(), (m.volume_mm3 - volume).abs());
            assert!(da <= m.area_error_mm2 + 1e-9 * area, "{k} at {deflection}: {m:?} {area}");
            assert!(dv <= m.volume_error_mm3 + 1e-9 * volume, "{k} at {deflection}: {m:?} {volume}");
            assert!(da < share * area && dv < share * volume, "{k} at {deflection}: {m:?} {area} {volume}");
            assert!(m.area_error_mm2 < 0.01 * area);
        }
    }
}

/// From the axis of a cylinder and the centre of a ball everything is equally far: found all the
/// same, and soon.
#[test]
fn centres_of_curvature() {
    let ball = part(sphere(10.0), 0.02);
    assert!((ball.closest(&Point::origin(), 100.0).unwrap().distance_mm - 10.0).abs() < 1e-9);
    let can = Part::from_brep(can(5.0, 80.0), 0.02, &Silent).unwrap();
    for k in 0..10 {
        let q = Point::new(1e-9 * f64::from(k), 0.0, 20.0 + 0.5 * f64::from(k));
        assert!((can.closest(&q, 100.0).unwrap().distance_mm - (5.0 - q.x)).abs() < 1.5e-7);
    }
    let ring = part(torus(10.0, 3.0), 0.02);
    for k in 0..10 {
        let a = 0.1 * f64::from(k);
        let q = Point::new(10.0 * a.cos(), 10.0 * a.sin(), 0.0);
        assert!((ring.closest(&q, 100.0).unwrap().distance_mm - 3.0).abs() < 1e-8);
    }
}

/// A wall between two circles of a longer, slightly uneven cylinder: for points of its axis all of
/// it, or all of a rim, is about equally far. Few pieces are halved wherever the point is, and the
/// distance is right.
#[test]
fn points_on_the_axis_of_a_round_face_are_soon_done() {
    let (radius, height) = (12.0, 100.0);
    for uneven in [0.0, 1e-6, 1e-4] {
        let mut wall = cylinder(radius, height);
        let bump = |k: usize| 1.0 + uneven / radius * [0.3, -1.0, 0.6, 0.1, 1.0][k % 5];
        for (k, p) in wall.points.iter_mut().enumerate() {
            // The two ends of the seam stay one.
            let scale = bump(if k / 2 == 8 { k % 2 } else { k });
            (p.x, p.y) = (p.x * scale, p.y * scale);
        }
        let edges = vec![circle(&wall, 0.2), circle(&wall, 0.8)];
        let loops = vec![vec![used(0, false)], vec![used(1, true)]];
        let brep = Brep { faces: vec![face(wall, false, loops)], edges };
        let t = tessellate(&brep, &TessellateOptions::with_deflection(0.02), &Silent).unwrap();
        let exact = Exact::new(&t);
        for k in 0..60 {
            for off in [0.0, 1e-6, 1e-3] {
                let q = Point::new(off, 0.3 * off, -120.0 + 5.0 * f64::from(k));
                let beyond = (20.0 - q.z).max(q.z - 80.0).max(0.0);
                let (found, cuts) = counted(&exact, &t.brep, &q, f64::INFINITY, NEGLIGIBLE_MM);
                let d = found.unwrap().d2.sqrt();
                let wrong = d - (radius - q.x.hypot(q.y)).hypot(beyond);
                assert!(wrong.abs() < 1.1 * uneven + 2e-4, "{uneven} at {q}: wrong by {wrong}");
                assert!(cuts < 1500, "{uneven} at {q}: {cuts}");
            }
        }
    }
}

/// A square whose edges lie above its plane: it ends below them, and what is nearer to the plane
/// than to its edges finds that end.
#[test]
fn faces_end_below_edges_that_lie_off_them() {
    let off = 0.02;
    let (x, y) = (Vector::x() * 30.0, Vector::y() * 30.0);
    let corner = |k: usize| Point::new([0.0, 10.0, 10.0, 0.0][k % 4], [0.0, 0.0, 10.0, 10.0][k % 4], off);
    let edge = |k: usize| {
        let points = [corner(k), corner(k + 1)].map(|p| Vector4::new(p.x, p.y, p.z, 1.0));
        let curve = NurbsCurve { degree: 1, knots: vec![0.0, 0.0, 1.0, 1.0], points: points.to_vec() };
        Edge { curve, t: [0.0, 1.0] }
    };
    let ring = (0..4).map(|k| used(k, false)).collect();
    let brep = Brep {
        faces: vec![face(plane(Point::new(-10.0, -10.0, 0.0), x, y), false, vec![ring])],
        edges: (0..4).map(edge).collect(),
    };
    let part = Part::from_brep(brep, 0.05, &Silent).unwrap();
    for q in points(25.0, 2000) {
        let beyond = [q.x, q.y].map(|c| (-c).max(c - 10.0).max(0.0));
        let aside = beyond[0].hypot(beyond[1]);
        // The face, and the edges themselves, which are of the part too.
        let exact = aside.hypot(q.z).min(if aside > 0.0 { aside.hypot(q.z - off) } else { f64::INFINITY });
        let c = part.closest(&q, f64::INFINITY).unwrap();
        assert!(
            (c.distance_mm - exact).abs() < 1e-6 || (aside == 0.0 && c.distance_mm < exact),
            "{q}: {} {exact}",
            c.distance_mm
        );
        assert!(c.face == 0 && (c.normal - Vector::z()).norm() < 1e-9, "{q}: {}", c.normal);
    }
}

/// A point on the seam of a closed surface belongs to it, wherever along the seam.
#[test]
fn seams_are_no_borders() {
    let turn = crate::geometry::Rigid::rotation(Vector::new(0.3, 1.1, 0.2));
    let surface = cylinder(5.0, 60.0);
    let brep = Brep { faces: vec![face(surface.clone(), false, vec![])], edges: vec![] };
    let part = Part::from_brep(brep.moved(&turn), 0.02, &Silent).unwrap();
    for k in 1..2000 {
        let q = turn * surface.point(0.0, f64::from(k) / 2000.0);
        for cap in [f64::INFINITY, 0.2] {
            let c = part.closest(&q, cap);
            assert!(c.is_some_and(|c| c.distance_mm < 1e-9), "{k}: {:?}", c.map(|c| c.distance_mm));
        }
    }
}

/// Newton's last step leaves a slope of about its square over the radius of the bend, which is no
/// reason to leave a foot out.
#[test]
fn a_sharp_bend_beside_an_edge_holds_its_own_points() {
    for radius in [0.05, 0.02, 0.005] {
        // A parabola with this radius at its vertex, along z; its ends are edges that all its
        // pieces reach.
        let (a, low) = (10.0 * radius, 50.0 * radius);
        let row = |x: f64, y: f64| [0.0, 10.0].map(|z| Vector4::new(x, y, z, 1.0));
        let wall = NurbsSurface {
            degree_u: 2,
            degree_v: 1,
            knots_u: vec![0.0, 0.0, 0.0, 1.0, 1.0, 1.0],
            knots_v: vec![0.0, 0.0, 1.0, 1.0],
            n_u: 3,
            n_v: 2,
            points: [row(-a, -low), row(0.0, low), row(a, -low)].concat(),
        };
        let wall = part(wall, 0.001);
        for k in 0..2000 {
            let [s, t] = [0.618_034, 0.754_877].map(|step| (f64::from(k) * step).fract());
            let x = 0.8 * a * (2.0 * s - 1.0);
            let on = Point::new(x, -0.5 * x * x / radius, 0.2 + 0.3 * t);
            let away = Vector::new(x / radius, 1.0, 0.0).normalize();
            let foot = wall.closest(&(on + away * 3.0), 10.0).unwrap().point;
            assert!((foot - on).norm() < 1e-9);
            for off in [0.0, 1e-6, 1e-4] {
                let d = wall.closest(&(foot + away * off), 10.0).unwrap().distance_mm;
                // The square of Newton's last step over the radius.
                let known = 1e-10 / radius + 1e-9;
                assert!((d - off).abs() < known, "radius {radius}, {off} mm above {foot}: {d}");
            }
        }
    }
}

/// A point that may be farther than the closest by some length is no farther than that, and takes
/// fewer pieces where much of the part is about as far.
#[test]
fn a_point_nearly_as_near_is_as_near_as_said() {
    let brick = Part::from_brep(block(Vector::new(30.0, 20.0, 10.0)), 0.02, &Silent).unwrap();
    let ring = part(torus(10.0, 3.0), 0.02);
    for part in [&brick, &ring] {
        for (k, q) in points(18.0, 600).enumerate() {
            let within = [0.0, 1e-6, 1e-3, 0.1, 2.0][k % 5];
            let least = part.closest(&q, f64::INFINITY).unwrap().distance_mm;
            let found = part.closest_within(&q, f64::INFINITY, within).unwrap();
            assert!((found.point - q).norm() - found.distance_mm <= 1e-9);
            assert!(found.distance_mm <= least + within + 1e-7, "{q}: {} {least} {within}", found.distance_mm);
            assert!(found.distance_mm >= least - 1e-7, "{q}");
            // What is nearer than a limit by more than that is found.
            let beside = part.closest_within(&q, least + 1.01 * within + 1e-6, within);
            assert!(beside.is_some_and(|c| c.distance_mm <= least + 1.01 * within + 1e-6), "{q}");
        }
    }
    let (brep, exact) = ring.exact().unwrap();
    let on_axis = Point::new(10.0, 0.0, 0.0);
    let cuts = |within: f64| counted(exact, brep, &on_axis, f64::INFINITY, within).1;
    assert!(cuts(0.1) < cuts(NEGLIGIBLE_MM), "{} {}", cuts(0.1), cuts(NEGLIGIBLE_MM));
}

/// A quarter of a cylinder whose wall is cut across by thousands of knots, as that of a loft
/// through splines of unlike knots is: as many strips of full length, each to be cut finely.
#[test]
fn of_thousands_of_strips_none_stays_whole() {
    let (radius, height, strips) = (60.0, 200.0, 4000);
    let at = |share: f64| {
        let turn = std::f64::consts::FRAC_1_SQRT_2;
        let row = [(1.0, 0.0, 1.0), (turn, turn, turn), (0.0, 1.0, 1.0)];
        row.map(|(x, y, w)| Vector4::new(radius * x, radius * y, height * share * w, w))
    };
    // Wider and wider.
    let shares: Vec<f64> =
        (0..=strips).map(|k| f64::from(k) / f64::from(strips)).map(|t| t * (0.5 + 0.5 * t)).collect();
    let knots_u = shares.first().into_iter().chain(&shares).chain(shares.last()).copied().collect();
    let wall = NurbsSurface {
        degree_u: 1,
        degree_v: 2,
        knots_u,
        knots_v: vec![0.0, 0.0, 0.0, 1.0, 1.0, 1.0],
        n_u: shares.len(),
        n_v: 3,
        points: shares.iter().flat_map(|share| at(*share)).collect(),
    };
    let wall = part(wall, 0.5);
    let (brep, exact) = wall.exact().unwrap();
    let thickest_mm = exact.leaves.iter().map(|leaf| leaf.slab.half[2]).fold(0.0, f64::max);
    assert!(exact.leaves.len() < 100_000 && thickest_mm < 0.1, "{} {thickest_mm}", exact.leaves.len());
    for k in 0..400 {
        let k = f64::from(k);
        let (turn, off_mm) = (0.1 + 0.003 * k, 3.0 * (0.7 * k).sin());
        let on = Point::new(0.0, 0.0, 20.0 + 0.4 * k) + Vector::new(turn.cos(), turn.sin(), 0.0) * (radius + off_mm);
        let (found, cuts) = counted(exact, brep, &on, f64::INFINITY, NEGLIGIBLE_MM);
        assert!((found.unwrap().d2.sqrt() - off_mm.abs()).abs() < 1e-9 && cuts < 20, "{k}: {cuts}");
    }
}
