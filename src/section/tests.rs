//! Tests of sections.
#![allow(clippy::unwrap_used)]

use std::f64::consts::{PI, TAU};

use nalgebra::Matrix3;
use proptest::prelude::*;

use super::{SectionOptions, plan};
use crate::artifact::Blade;
use crate::artifact::blade::{Diagnosis, Unit};
use crate::artifact::region::Regions;
use crate::artifact::section::{SectionLoop, Side};
use crate::error::{ErrorKind, Infeasible};
use crate::geometry::brep::{Brep, Face, SurfaceKind};
use crate::geometry::mesh::Mesh;
use crate::geometry::nurbs::NurbsSurface;
use crate::geometry::nurbs::shapes::{cone, cylinder, torus};
use crate::geometry::part::Part;
use crate::geometry::profile::outline::outlines;
use crate::geometry::profile::{Names, Outline, Sides};
use crate::geometry::{Point, Rigid, Vector};
use crate::observe::{Recorder, Silent};

const TOL: f64 = 0.002;

fn measured(points: Vec<[f64; 2]>, tolerance_mm: f64) -> SectionLoop {
    let (mut l, ends) = super::measured(Outline::polygon(points), tolerance_mm);
    super::name(&mut l, &ends, Names::alone(&ends));
    l
}

fn sampled(n: usize, f: impl Fn(f64) -> [f64; 2]) -> Vec<[f64; 2]> {
    (0..n).map(|i| f(i as f64 / n as f64)).collect()
}

/// At the point nearest to `p`.
fn curvature_at(l: &SectionLoop, p: [f64; 2]) -> f64 {
    let d = |q: &[f64; 2]| (q[0] - p[0]).hypot(q[1] - p[1]);
    let i = (0..l.points_mm.len()).min_by(|&a, &b| d(&l.points_mm[a]).total_cmp(&d(&l.points_mm[b]))).unwrap();
    l.curvature_per_mm[i]
}

#[test]
fn circle() {
    let l = measured(sampled(200, |t| [10.0 * (TAU * t).cos(), 10.0 * (TAU * t).sin()]), TOL);
    assert!(l.curvature_per_mm.iter().all(|k| (k - 0.1).abs() < 1e-3));
    assert!(l.altered_points.is_empty());
    assert!((l.thickness_mm - 20.0).abs() < 0.01, "{}", l.thickness_mm);
    assert!((l.length_mm - 20.0 * PI).abs() < 0.01 && (l.area_mm2 - 100.0 * PI).abs() < 0.1);
    assert!(l.fit_error_mm <= TOL);
}

#[test]
fn ellipse() {
    let l = measured(sampled(360, |t| [20.0 * (TAU * t).cos(), 8.0 * (TAU * t).sin()]), TOL);
    assert!((curvature_at(&l, [20.0, 0.0]) - 20.0 / 64.0).abs() < 0.0125, "{}", curvature_at(&l, [20.0, 0.0]));
    assert!((curvature_at(&l, [0.0, 8.0]) - 8.0 / 400.0).abs() < 1e-3, "{}", curvature_at(&l, [0.0, 8.0]));
    assert!(l.altered_points.is_empty());
    assert!((l.chord_mm - 40.0).abs() < 0.01, "{}", l.chord_mm);
    assert!((l.thickness_mm - 16.0).abs() < 0.02, "{}", l.thickness_mm);
    // Equally blunt ends: the one with the lesser y leads.
    assert!((l.leading_edge_s_mm - 0.5 * l.length_mm).abs() < 0.02);
}

/// A straight strip with round ends of radius `r[0]` at -h and `r[1]` at +h along y, joined by
/// tangents.
fn strip(n: usize, h: f64, r: [f64; 2]) -> Vec<[f64; 2]> {
    let lean = ((r[0] - r[1]) / (2.0 * h)).asin();
    let side = (4.0 * h * h - (r[0] - r[1]).powi(2)).sqrt();
    let lengths = [r[1] * (PI - 2.0 * lean), side, r[0] * (PI + 2.0 * lean), side];
    let whole: f64 = lengths.iter().sum();
    sampled(n, |t| {
        let mut s = t * whole;
        let up = PI / 2.0 - lean;
        if s < lengths[0] {
            let e = -up + s / r[1];
            return [h + r[1] * e.cos(), r[1] * e.sin()];
        }
        s -= lengths[0];
        let (from, to) = ([h + r[1] * up.cos(), r[1] * up.sin()], [-h + r[0] * up.cos(), r[0] * up.sin()]);
        let line = |f: f64, m: f64| [from[0] + f * (to[0] - from[0]), m * (from[1] + f * (to[1] - from[1]))];
        if s < lengths[1] {
            return line(s / side, 1.0);
        }
        s -= lengths[1];
        if s < lengths[2] {
            let e = up + s / r[0];
            return [-h + r[0] * e.cos(), r[0] * e.sin()];
        }
        line(1.0 - (s - lengths[2]) / side, -1.0)
    })
}

#[test]
fn strip_with_round_ends() {
    let l = measured(strip(380, 15.0, [4.0, 2.0]), TOL);
    assert!((l.chord_mm - 36.0).abs() < 0.02, "{}", l.chord_mm);
    assert!((l.thickness_mm - 8.0).abs() < 0.02, "{}", l.thickness_mm);
    assert!(l.altered_points.is_empty(), "{:?}", l.altered_points);
    assert!((curvature_at(&l, [-19.0, 0.0]) - 0.25).abs() < 0.01 && (curvature_at(&l, [17.0, 0.0]) - 0.5).abs() < 0.02);
    assert!(curvature_at(&l, [0.0, 3.0]).abs() < 1e-3);
    // The blunt end leads.
    let lead = l.points_mm[l.s_mm.partition_point(|s| *s < l.leading_edge_s_mm)];
    assert!((lead[0] + 19.0).abs() < 0.05 && lead[1].abs() < 0.2, "{lead:?}");
}

/// A strip bent to a circular arc of radius `bend` over `sweep` rad, half thickness `h`: its inner
/// side is concave.
fn bent(t: f64, bend: f64, sweep: f64, h: f64) -> [f64; 2] {
    let lengths = [(bend + h) * sweep, PI * h, (bend - h) * sweep, PI * h];
    let mut s = t * lengths.iter().sum::<f64>();
    let at = |r: f64, phi: f64| [r * phi.sin(), bend - r * phi.cos()];
    let half = 0.5 * sweep;
    if s < lengths[0] {
        return at(bend + h, -half + s / (bend + h));
    }
    s -= lengths[0];
    if s < lengths[1] {
        let (c, e) = (at(bend, half), half - PI / 2.0 + s / h);
        return [c[0] + h * e.cos(), c[1] + h * e.sin()];
    }
    s -= lengths[1];
    if s < lengths[2] {
        return at(bend - h, half - s / (bend - h));
    }
    s -= lengths[2];
    let (c, e) = (at(bend, -half), -half + PI / 2.0 + s / h);
    [c[0] + h * e.cos(), c[1] + h * e.sin()]
}

#[test]
fn a_bent_strip_has_two_altered_points_where_its_inner_side_begins_and_ends() {
    // Facets of about 1 % of the chord. Curvature jumps where the sides begin, so that a window
    // about that place sees both.
    let (bend, sweep, h) = (40.0, 1.0, 3.0);
    let l = measured(sampled(240, |t| bent(t, bend, sweep, h)), TOL);
    assert_eq!(l.altered_points.len(), 2, "{:?}", l.altered_points);
    let starts = (bend + h) * sweep + PI * h;
    let ends = starts + (bend - h) * sweep;
    let [a, b] = [l.altered_points[0], l.altered_points[1]];
    assert!(a.into_concave && !b.into_concave);
    assert!((a.s_mm - starts).abs() < 1.0 && (b.s_mm - ends).abs() < 1.0, "{a:?} {starts} {b:?} {ends}");
    assert!((l.thickness_mm - 2.0 * h).abs() < 0.05);
    // From the leading edge on: the end at lesser y comes after the inner side, so that the outer
    // side follows it.
    assert_eq!(l.side_after_leading_edge, Side::Suction);
    assert!((curvature_at(&l, [0.0, h]) + 1.0 / (bend - h)).abs() < 1e-3);
}

/// `r(φ) = 10 + 1.5 cos 3φ`: its inflections are the zeros of `r² + 2 r'² − r r''`.
fn clover(phi: f64) -> [f64; 2] {
    let r = 10.0 + 1.5 * (3.0 * phi).cos();
    [r * phi.cos(), r * phi.sin()]
}

fn clover_inflections() -> Vec<[f64; 2]> {
    let k = |p: f64| {
        let (r, d, e) = (10.0 + 1.5 * (3.0 * p).cos(), -4.5 * (3.0 * p).sin(), -13.5 * (3.0 * p).cos());
        r * r + 2.0 * d * d - r * e
    };
    let mut out = Vec::new();
    for i in 0..720 {
        let (mut a, mut b) = (TAU * i as f64 / 720.0, TAU * (i + 1) as f64 / 720.0);
        if k(a) * k(b) < 0.0 {
            for _ in 0..60 {
                let m = 0.5 * (a + b);
                if k(a) * k(m) <= 0.0 { b = m } else { a = m }
            }
            out.push(clover(a));
        }
    }
    out
}

#[test]
fn smooth_inflections_are_found_where_they_are_also_on_facets() {
    let expected = clover_inflections();
    assert_eq!(expected.len(), 6);
    for n in [180, 400, 1200] {
        let l = measured(sampled(n, |t| clover(TAU * t)), TOL);
        assert_eq!(l.altered_points.len(), 6, "{n}");
        for a in &l.altered_points {
            let d =
                expected.iter().map(|e| (e[0] - a.point_mm[0]).hypot(e[1] - a.point_mm[1])).fold(f64::MAX, f64::min);
            assert!(d < 0.15, "{n}: {d}");
        }
    }
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 12, ..ProptestConfig::default() })]

    /// Rough points within half the tolerance, turned and begun elsewhere: the same altered points,
    /// chord and thickness.
    #[test]
    fn robust_and_symmetric(noise in prop::collection::vec(-1.0..1.0f64, 480), turn in 0.0..6.0f64, first in 0usize..240) {
        let exact = measured(sampled(240, |t| bent(t, 40.0, 1.0, 3.0)), TOL);
        let (s, c) = turn.sin_cos();
        let mut rough: Vec<[f64; 2]> = (0..240)
            .map(|i| {
                let p = bent(i as f64 / 240.0, 40.0, 1.0, 3.0);
                let p = [p[0] + 5e-4 * noise[i], p[1] + 5e-4 * noise[i + 240]];
                [c * p[0] - s * p[1], s * p[0] + c * p[1]]
            })
            .collect();
        rough.rotate_left(first);
        let l = measured(rough, TOL);
        prop_assert_eq!(l.altered_points.len(), 2);
        prop_assert!((l.chord_mm - exact.chord_mm).abs() < 0.05);
        prop_assert!((l.thickness_mm - exact.thickness_mm).abs() < 0.05);
        let between = |l: &SectionLoop| {
            let [a, b] = [l.altered_points[0], l.altered_points[1]];
            let d = (b.s_mm - a.s_mm) * if a.into_concave { 1.0 } else { -1.0 };
            d.rem_euclid(l.length_mm)
        };
        prop_assert!((between(&l) - between(&exact)).abs() < 1.5);
    }
}

fn prism(profile: &[[f64; 2]], x: [f64; 2]) -> Blade {
    let n = profile.len() as u32;
    let mut mesh = Mesh::default();
    for h in x {
        mesh.points.extend(profile.iter().map(|p| Point::new(h, p[0], p[1])));
    }
    mesh.points.extend(x.map(|h| Point::new(h, 0.0, 0.0)));
    for i in 0..n {
        let j = (i + 1) % n;
        mesh.triangles.extend([[i, j, n + j], [i, n + j, n + i], [2 * n, j, i], [2 * n + 1, n + i, n + j]]);
    }
    Blade {
        name: "prism".into(),
        unit: Unit::Mm,
        part: Part::from_mesh(mesh),
        model_from_blade: Rigid::identity(),
        regions: Regions::at_heights(x, x, None),
        wheel: None,
        diagnosis: Diagnosis::default(),
    }
}

#[test]
fn sections_of_a_prism_are_its_profile() {
    let profile = sampled(240, |t| [20.0 * (TAU * t).cos(), 8.0 * (TAU * t).sin()]);
    let blade = prism(&profile, [0.0, 50.0]);
    let sections = plan(&blade, &SectionOptions::default().with(|s| s.count = 5), &Silent).unwrap();
    assert_eq!(sections.iter().map(|s| s.x_mm).collect::<Vec<_>>(), [5.0, 15.0, 25.0, 35.0, 45.0]);
    for s in &sections {
        assert_eq!(s.loops.len(), 1);
        assert!((s.loops[0].chord_mm - 40.0).abs() < 0.01 && (s.loops[0].area_mm2 - 160.0 * PI).abs() < 0.2);
        for p in &s.loops[0].points_mm {
            assert!((p[0] / 20.0).hypot(p[1] / 8.0) < 1.0 + 1e-9 && (p[0] / 20.0).hypot(p[1] / 8.0) > 0.999);
        }
    }
}

#[test]
fn the_airfoil_is_the_first_loop_also_beside_a_larger_body() {
    let profile = sampled(240, |t| [20.0 * (TAU * t).cos(), 8.0 * (TAU * t).sin()]);
    let larger = sampled(240, |t| [60.0 + 25.0 * (TAU * t).cos(), 10.0 * (TAU * t).sin()]);
    let (mut blade, beside) = (prism(&profile, [0.0, 50.0]), prism(&larger, [0.0, 50.0]));
    let mut mesh = blade.part.mesh;
    let first = mesh.points.len() as u32;
    mesh.points.extend(&beside.part.mesh.points);
    mesh.triangles.extend(beside.part.mesh.triangles.iter().map(|t| t.map(|v| v + first)));
    blade.part = Part::from_mesh(mesh);
    let edge = |y: f64| [0.0, 50.0].map(|x| Point::new(x, y, 0.0)).to_vec();
    let sides = |leading: f64, trailing: f64| Sides {
        leading_edge_mm: edge(leading),
        trailing_edge_mm: edge(trailing),
        suction_follows_leading: true,
    };
    for (leading, trailing, area_mm2) in
        [(20.0, -20.0, 160.0 * PI), (-20.0, 20.0, 160.0 * PI), (85.0, 35.0, 250.0 * PI)]
    {
        blade.regions.list[0].sides = Some(sides(leading, trailing));
        for s in plan(&blade, &SectionOptions::default().with(|s| s.count = 3), &Silent).unwrap() {
            let airfoil = &s.loops[0];
            let k = airfoil.s_mm.iter().position(|s| *s >= airfoil.leading_edge_s_mm - 1e-9).unwrap_or(0);
            let [y, _] = airfoil.points_mm[k];
            assert!((airfoil.area_mm2 - area_mm2).abs() < 0.5 && (y - leading).abs() < 0.1, "{y} {}", airfoil.area_mm2);
            assert_eq!(s.loops.len(), 2);
        }
    }
}

/// A prism that lacks one triangle of its wall: at height x the profile is open by a share x / 50
/// of `width_mm`.
fn open_prism(width_mm: f64) -> Blade {
    let mut profile = sampled(240, |t| [20.0 * (TAU * t).cos(), 8.0 * (TAU * t).sin()]);
    let far = [profile[60][0] - width_mm, profile[60][1]];
    let next = (61..).find(|k| profile[*k][0] < far[0]).unwrap();
    profile.splice(61..next, [far]);
    let mut blade = prism(&profile, [0.0, 50.0]);
    let n = profile.len() as u32;
    let gone = blade.part.mesh.triangles.iter().position(|t| *t == [60, n + 61, n + 60]).unwrap();
    blade.part.mesh.triangles.remove(gone);
    blade.part = Part::from_mesh(blade.part.mesh);
    blade
}

#[test]
fn openings_are_bridged_or_told_and_do_not_refuse() {
    let ear = Recorder::new(&Silent);
    let options = SectionOptions::default().with(|s| s.count = 5);
    let of = |width_mm: f64| plan(&open_prism(width_mm), &options, &ear);
    // 93 mm round, so gaps up to 0.09 mm are bridged: at 5, 15 and 25 mm.
    let sections = of(0.15).unwrap();
    assert_eq!(sections.iter().map(|s| s.x_mm).collect::<Vec<_>>(), [5.0, 15.0, 25.0]);
    assert!(sections.iter().all(|s| (s.loops[0].area_mm2 - 160.0 * PI).abs() < 0.3));
    let words: Vec<String> = ear.warnings().into_iter().map(|w| w.doubt.to_string()).collect();
    assert_eq!(words.len(), 5, "{words:?}");
    assert!(
        words.iter().any(|w| w.contains("at 25.000 mm is drawn straight over gaps of the part, 0.075 mm")),
        "{words:?}"
    );
    assert!(
        words.iter().any(|w| w.contains("no section at 45.000 mm: the part is open there, by 0.135 mm")),
        "{words:?}"
    );
    // Nothing closes: the one case that refuses, with the reason.
    let e = of(2.0).unwrap_err();
    assert!(matches!(e.infeasible.as_deref(), Some(Infeasible::NoSectionCloses { count: 5, .. })), "{e:?}");
    assert!(
        e.message.contains("none of 5 sections from 5.000 to 45.000 mm") && e.message.contains("1.800 mm"),
        "{}",
        e.message
    );
}

#[test]
fn impossible_requests_are_usage_errors() {
    let blade = prism(&sampled(40, |t| [20.0 * (TAU * t).cos(), 8.0 * (TAU * t).sin()]), [0.0, 50.0]);
    for o in [
        SectionOptions::default().with(|s| s.count = 0),
        SectionOptions { heights_mm: vec![60.0], ..SectionOptions::default() },
        SectionOptions { heights_mm: vec![f64::NAN], ..SectionOptions::default() },
        SectionOptions { tolerance_mm: 0.0, ..SectionOptions::default() },
    ] {
        assert_eq!(plan(&blade, &o, &Silent).unwrap_err().kind, ErrorKind::Usage);
    }
}

/// An implicit surface: value, gradient, second derivatives; greater than zero outside.
type Implicit = Box<dyn Fn(&Point) -> (f64, Vector, Matrix3<f64>)>;

/// Oblique exact faces: the shape, where its axis points, and its equation.
fn oblique() -> Vec<(&'static str, Part, Implicit)> {
    let turn = Rigid::rotation(Vector::new(0.3, 1.1, 0.2));
    let axis = turn * Vector::z();
    let part = |surface: NurbsSurface| {
        let face = Face { name: "a".into(), kind: SurfaceKind::Other, surface, reversed: false, loops: vec![] };
        Part::from_brep(Brep { faces: vec![face], edges: vec![] }.moved(&turn), 0.02, &Silent).unwrap()
    };
    let across = Matrix3::identity() - axis * axis.transpose();
    let quadric = move |m: Matrix3<f64>, c: f64| -> Implicit {
        Box::new(move |p| ((p.coords.transpose() * m * p.coords)[0] - c, m * p.coords * 2.0, m * 2.0))
    };
    let torus_f = move |p: &Point| {
        let (r2, s) = (p.coords.norm_squared() + 100.0 - 9.0, across * p.coords);
        let value = r2 * r2 - 400.0 * s.norm_squared();
        let hessian = Matrix3::identity() * (4.0 * r2) + p.coords * p.coords.transpose() * 8.0 - across * 800.0;
        (value, p.coords * (4.0 * r2) - s * 800.0, hessian)
    };
    vec![
        ("cylinder", part(cylinder(5.0, 60.0)), quadric(across, 25.0)),
        ("cone", part(cone(6.0, 30.0)), quadric(across - axis * axis.transpose() * 0.04, 0.0)),
        ("torus", part(torus(10.0, 3.0)), Box::new(torus_f)),
    ]
}

/// Curvature of an implicit curve in the plane, positive where convex: second derivative along it
/// over the slope.
fn implicit_curvature(f: &Implicit, x: f64, p: [f64; 2]) -> f64 {
    let (_, g, h) = f(&Point::new(x, p[0], p[1]));
    let slope = g.y.hypot(g.z);
    let t = Vector::new(0.0, -g.z / slope, g.y / slope);
    (t.transpose() * h * t)[0] / slope
}

#[test]
fn oblique_sections_of_exact_faces_in_closed_form() {
    for (name, part, f) in oblique() {
        let b = part.mesh.aabb().unwrap();
        let mut found = 0;
        for share in [0.35, 0.5, 0.62] {
            let x = b.min.x + share * (b.max.x - b.min.x);
            for outline in outlines(&part, x).loops {
                found += 1;
                assert!(outline.off_part_mm < 1e-8, "{name}: {}", outline.off_part_mm);
                for p in &outline.points {
                    let (value, g, _) = f(&Point::new(x, p[0], p[1]));
                    assert!((value / g.norm()).abs() < 2e-8, "{name} {p:?}: {}", value / g.norm());
                }
                let (l, _) = super::measured(outline, TOL);
                let mut changes = 0;
                for (i, p) in l.points_mm.iter().enumerate() {
                    let k = implicit_curvature(&f, x, *p);
                    assert!((l.curvature_per_mm[i] - k).abs() < 1e-5, "{name} {p:?}: {} {k}", l.curvature_per_mm[i]);
                    let next = l.points_mm[(i + 1) % l.points_mm.len()];
                    changes += usize::from(k * implicit_curvature(&f, x, next) < 0.0);
                }
                assert_eq!(l.altered_points.len(), changes, "{name}");
                for a in &l.altered_points {
                    // Curvature grows by about 0.1 a mm there: zero lies within some hundredths.
                    assert!(implicit_curvature(&f, x, a.point_mm).abs() < 2e-3, "{name} {a:?}");
                }
            }
        }
        assert!(found >= 3, "{name}");
    }
}
