#![allow(clippy::unwrap_used)]
use std::f64::consts::{FRAC_PI_2, TAU};

use proptest::prelude::*;

use super::*;
use crate::geometry::Rigid;
use crate::geometry::brep::{Brep, Face, FaceName, SurfaceKind};
use crate::geometry::exact::tests::block;
use crate::geometry::nurbs::NurbsSurface;
use crate::geometry::nurbs::shapes::{cone, cylinder, patch};
use crate::observe::Silent;

fn part_of(surfaces: Vec<(NurbsSurface, bool)>) -> Part {
    let face = |(k, (surface, reversed)): (usize, (NurbsSurface, bool))| Face {
        name: FaceName::Numbered(k),
        kind: SurfaceKind::BSpline,
        surface,
        reversed,
        loops: vec![],
    };
    let faces = surfaces.into_iter().enumerate().map(face).collect();
    Part::from_brep(Brep { faces, edges: vec![] }, 0.02, &Silent).unwrap()
}

/// A surface whose points are scaled and then shifted.
fn changed(mut surface: NurbsSurface, scale: [f64; 3], shift: [f64; 3]) -> NurbsSurface {
    for p in &mut surface.points {
        for k in 0..3 {
            p[k] = p[k] * scale[k] + shift[k] * p.w;
        }
    }
    surface
}

fn found(part: &Part, point: Point, normal: Vector) -> Pair {
    let pair = partner(part, SurfacePlace { point, normal }, 500.0).unwrap();
    assert!((pair.radius_mm - (pair.second.point - pair.centre).norm()).abs() < 1e-9, "{pair:?}");
    assert!(pair.apart_mm() < 1e-7, "{} {pair:?}", pair.apart_mm());
    // The partner's partner is the first place.
    let back = partner(part, pair.second, 500.0).unwrap();
    assert!((back.second.point - point).norm() < 1e-7, "{back:?}");
    pair
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 24, ..ProptestConfig::default() })]

    #[test]
    fn across_a_plate(u in 0.2f64..0.8, v in 0.2f64..0.8) {
        let part = Part::from_brep(block(Vector::new(90.0, 80.0, 10.0)), 0.05, &Silent).unwrap();
        let pair = found(&part, Point::new(90.0 * u, 80.0 * v, 10.0), Vector::z());
        prop_assert!((pair.second.point - Point::new(90.0 * u, 80.0 * v, 0.0)).norm() < 1e-8, "{pair:?}");
        prop_assert!((pair.radius_mm - 5.0).abs() < 1e-9 && pair.angle_rad() < 1e-9);
    }

    #[test]
    fn across_a_wedge(half_deg in 2.0f64..20.0, share in 0.15f64..0.5, y in -20.0f64..20.0) {
        let half = half_deg.to_radians();
        let (s, c) = half.sin_cos();
        let (l, w) = (100.0, 60.0);
        let [x, z] = [l * c, l * s];
        let [apex_l, apex_r] = [[0.0, -w, 0.0], [0.0, w, 0.0]];
        let [up_l, up_r, low_l, low_r] = [[x, -w, z], [x, w, z], [x, -w, -z], [x, w, -z]];
        let part = part_of(vec![
            (patch([apex_l, up_l, up_r, apex_r]), false),
            (patch([apex_l, apex_r, low_r, low_l]), false),
            (patch([low_l, low_r, up_r, up_l]), false),
            (patch([apex_l, low_l, up_l, apex_l]), false),
            (patch([apex_r, up_r, low_r, apex_r]), false),
        ]);
        let along = l * share;
        let pair = found(&part, Point::new(along * c, y, along * s), Vector::new(-s, 0.0, c));
        prop_assert!((pair.second.point - Point::new(along * c, y, -along * s)).norm() < 1e-8, "{pair:?}");
        prop_assert!((pair.radius_mm - along * half.tan()).abs() < 1e-8);
        prop_assert!((pair.angle_rad() - 2.0 * half).abs() < 1e-8);
    }

    #[test]
    fn across_shells_of_a_cylinder_and_a_cone(angle in 0.0f64..TAU, share in 0.4f64..0.6) {
        let (s, c) = angle.sin_cos();
        let out = Vector::new(c, s, 0.0);
        let tube = part_of(vec![(cylinder(20.0, 300.0), false), (cylinder(15.0, 300.0), true)]);
        let z = Vector::z() * 300.0 * share;
        let pair = found(&tube, Point::from(out * 20.0 + z), out);
        prop_assert!((pair.second.point - Point::from(out * 15.0 + z)).norm() < 1e-8, "{pair:?}");
        prop_assert!((pair.radius_mm - 2.5).abs() < 1e-9 && pair.angle_rad() < 1e-8);
        // A cone and the same cone farther up its axis are parallel.
        let (radius, height, up) = (40.0, 300.0, 20.0);
        let shell = part_of(vec![
            (cone(radius, height), false),
            (changed(cone(radius, height), [1.0; 3], [0.0, 0.0, up]), true),
        ]);
        let slope = (radius / height).atan();
        let normal = out * slope.cos() - Vector::z() * slope.sin();
        let first = Point::from(out * radius * share + z);
        let pair = found(&shell, first, normal);
        let thick = up * slope.sin();
        prop_assert!((pair.second.point - (first - normal * thick)).norm() < 1e-8, "{pair:?}");
        prop_assert!((pair.radius_mm - 0.5 * thick).abs() < 1e-9 && pair.angle_rad() < 1e-7);
    }

    #[test]
    fn across_an_elliptic_cylinder(t in 0.3f64..2.8, turn in 0.0f64..TAU) {
        let (a, b, length) = (10.0, 2.5, 200.0);
        let surface = changed(cylinder(1.0, length), [a, b, 1.0], [0.0; 3]);
        let place = Rigid::new(Vector::new(3.0, -5.0, 9.0), Vector::new(0.3, 0.7, -0.2) * turn);
        let part = part_of(vec![(surface, false)]);
        let part = part.moved(&place);
        let [x, y] = [a * t.cos(), b * t.sin()];
        let normal = Vector::new(x / (a * a), y / (b * b), 0.0).normalize();
        // Beyond, the ball is that of the curvature and touches once only.
        prop_assume!(x.abs() < 0.9 * (a - b * b / a));
        let pair = found(&part, place * Point::new(x, y, 90.0), place * normal);
        prop_assert!((pair.second.point - place * Point::new(x, -y, 90.0)).norm() < 1e-8, "{pair:?}");
        prop_assert!((pair.radius_mm - (y / normal.y).abs()).abs() < 1e-8);
        prop_assert!((0.5 * pair.angle_rad()).sin() - normal.x.abs() < 1e-8);
    }
}

#[test]
fn an_edge_has_no_partner() {
    let (a, b) = (10.0, 2.5);
    let part = part_of(vec![(changed(cylinder(1.0, 200.0), [a, b, 1.0], [0.0; 3]), false)]);
    assert_eq!(partner(&part, SurfacePlace { point: Point::new(a, 0.0, 100.0), normal: Vector::x() }, 500.0), None);
    // Looked at from the wrong side there is no inside.
    assert_eq!(partner(&part, SurfacePlace { point: Point::new(0.0, b, 100.0), normal: -Vector::y() }, 500.0), None);
}

/// A slab between two round edges: its flat sides are opposite, and the edges, as far from their
/// axis everywhere, have no partner.
#[test]
fn a_round_edge_has_no_partner() {
    let (radius, half, length) = (1.5, 20.0, 120.0);
    let round = |x: f64| changed(cylinder(radius, length), [1.0; 3], [x, 0.0, 0.0]);
    let [a, b] = [-half, half];
    let side = |y: f64, [from, to]: [f64; 2]| patch([[from, y, 0.0], [to, y, 0.0], [to, y, length], [from, y, length]]);
    let part = part_of(vec![
        (round(a), false),
        (round(b), false),
        (side(-radius, [a, b]), false),
        (side(radius, [b, a]), false),
    ]);
    let at = |angle: f64| {
        let normal = Vector::new(angle.cos(), angle.sin(), 0.0);
        SurfacePlace { point: Point::new(b, 0.0, 60.0) + normal * radius, normal }
    };
    for k in 0..18 {
        let angle = 0.1 + 0.16 * f64::from(k) - FRAC_PI_2;
        assert_eq!(partner(&part, at(angle), 500.0), None, "{angle}");
        assert_eq!(partner_across_creases(&part, at(angle), 500.0, 0.01), None, "{angle}");
    }
    for x in [-12.0, -3.0, 11.0] {
        let first = SurfacePlace { point: Point::new(x, radius, 60.0), normal: Vector::y() };
        let pair = partner(&part, first, 500.0).unwrap();
        assert!((pair.second.point - Point::new(x, -radius, 60.0)).norm() < 1e-8, "{pair:?}");
    }
}
