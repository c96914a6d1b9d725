//! One location: closed forms, and the oracle on random meshes.

use std::f64::consts::{FRAC_PI_2, PI, TAU};

use proptest::prelude::*;

use super::super::arcs::{Arc, Witness};
use super::super::forbidden::{ObstacleBody, ObstacleScene, PlaceSearch, View};
use super::super::options::ChannelOptions;
use super::super::profile::ToolProfile;
use super::super::region::EvenMove;
use super::super::tree::SphereTree;
use super::world::{least_margin, tool};
use crate::artifact::Cone;
use crate::geometry::mesh::Mesh;
use crate::geometry::{Point, Vector};
use crate::tool::Tool;

pub const TOL: f64 = 1.745e-4;

pub fn open_options() -> ChannelOptions {
    ChannelOptions { max_step_mm: 1.0, ..ChannelOptions::default() }.with(|s| {
        (s.clearance_mm, s.contact_angle_max_deg, s.tolerance_deg) = (0.2, 180.0, TOL.to_degrees());
    })
}

/// A lean and the options, for [`free`].
fn leaning(b: f64) -> (f64, ChannelOptions) {
    (b, open_options())
}

fn free(mesh: &Mesh, tool: &Tool, (b, options): &(f64, ChannelOptions), centre: &Point, normal: &Vector) -> Vec<Arc> {
    let tree = SphereTree::new(mesh, 2.5);
    let profile = ToolProfile::new(tool, [options.settings.clearance_mm, options.settings.holder_clearance_mm], 0.0);
    let scene = ObstacleScene { bodies: vec![ObstacleBody { name: "part", mesh, tree: &tree, profile }], options };
    let azimuth = normal.z.atan2(normal.y);
    let view =
        View { centre: *centre, cone: Cone::about_blade(*b), azimuth, within_rad: None, motion: EvenMove::none() };
    PlaceSearch::new(&scene).free(&view, normal, None)
}

fn triangle(a: Point, b: Point, c: Point) -> Mesh {
    Mesh { points: vec![a, b, c], triangles: vec![[0, 1, 2]], ..Mesh::default() }
}

#[test]
fn a_point_forbids_the_arc_in_which_a_cylinder_holds_it() {
    let (t, b) = (tool(4.0, 0.0), 0.1f64);
    let o = leaning(b);
    // At 20 mm from the axis' foot: inside the cylinder of radius 4.2 where the height exceeds
    // sqrt(20² − 4.2²).
    let p = Point::new(0.0, 0.0, 20.0);
    let found = free(&triangle(p, p, p), &t, &o, &Point::origin(), &Vector::y());
    let half = ((400.0f64 - 4.2 * 4.2).sqrt() / (20.0 * b.cos())).acos();
    assert_eq!(found.len(), 1);
    assert!((found[0].lo - (FRAC_PI_2 + half - TAU)).abs() <= TOL, "{found:?} {half}");
    assert!((found[0].hi - (FRAC_PI_2 - half)).abs() <= TOL, "{found:?} {half}");
    assert!(matches!(found[0].hi_by, Witness::Tool { segment: 0, body: 0, leaf: 0 }));
}

#[test]
fn a_wall_leaves_the_angles_at_which_the_cylinder_keeps_its_clearance() {
    // Wall y = -R, wide enough for the whole tool; B = 0, no holder. The lower rim is nearest: R (1
    // − sin) = clearance.
    let mut t = tool(4.0, 0.0);
    t.holder.clear();
    let o = leaning(0.0);
    let w = 200.0;
    let corner = |x: f64, z: f64| Point::new(x, -4.0, z);
    let mesh = Mesh {
        points: vec![corner(-w, -w), corner(-w, w), corner(w, w), corner(w, -w)],
        triangles: vec![[0, 1, 2], [0, 2, 3]],
        ..Mesh::default()
    };
    let found = free(&mesh, &t, &o, &Point::origin(), &Vector::y());
    let limit = (1.0f64 - 0.2 / 4.0).asin();
    assert_eq!(found.len(), 1);
    assert!((found[0].hi - limit).abs() <= 2.0 * TOL && found[0].hi <= limit, "{} {limit}", found[0].hi);
    assert!((found[0].lo + limit).abs() <= 2.0 * TOL && found[0].lo >= -limit, "{} {limit}", found[0].lo);
}

#[test]
fn a_sphere_forbids_a_cone_of_angles() {
    // A sphere of radius 6 at 30 mm: the cylinder's axis keeps 6 + 4 + 0.2 from its centre.
    let mut t = tool(4.0, 0.0);
    t.holder.clear();
    t.stickout_mm = 90.0;
    let o = leaning(0.0);
    let mesh = sphere(Point::new(0.0, 0.0, 30.0), 6.0, 160);
    let found = free(&mesh, &t, &o, &Point::origin(), &-Vector::z());
    let half = (10.2f64 / 30.0).asin();
    // Angles are relative to the normal at azimuth −90°: the sphere lies at ±180°.
    assert_eq!(found.len(), 1);
    assert!((found[0].hi - (PI - half)).abs() < 5e-4, "{found:?}");
    assert!((found[0].lo + (PI - half)).abs() < 5e-4, "{found:?}");
}

fn sphere(centre: Point, radius: f64, n: usize) -> Mesh {
    let mut mesh = Mesh::default();
    for i in 0..=n {
        for j in 0..2 * n {
            let (u, v) = (PI * i as f64 / n as f64, PI * j as f64 / n as f64);
            let (su, cu) = u.sin_cos();
            mesh.points.push(centre + Vector::new(su * v.cos(), su * v.sin(), cu) * radius);
        }
    }
    let m = 2 * n as u32;
    for i in 0..n as u32 {
        for j in 0..m {
            let (a, b) = (i * m + j, i * m + (j + 1) % m);
            mesh.triangles.extend([[a, a + m, b], [b, a + m, b + m]]);
        }
    }
    mesh
}

/// The tilt at which a cylinder of that radius about an axis through the ball's centre reaches the
/// point `over_mm` over the ball and `beside_mm` beside it: `beside cos φ − over sin φ = radius`.
fn tilt_to_a_rim(over_mm: f64, beside_mm: f64, radius_mm: f64) -> f64 {
    (radius_mm / beside_mm.hypot(over_mm)).acos() - over_mm.atan2(beside_mm)
}

/// What is free about straight up, +y, for a cylinder of R 3 with a clearance of 0.2, is what a rim
/// on either side leaves, to 0.01°.
fn leaves_the_tilt_of_its_rim(mesh: &Mesh, over_mm: f64, beside_mm: f64) {
    let mut cylinder = tool(3.0, 0.0);
    cylinder.holder.clear();
    cylinder.stickout_mm = 60.0;
    let tilt = tilt_to_a_rim(over_mm, beside_mm, 3.2);
    let all = free(mesh, &cylinder, &leaning(0.0), &Point::origin(), &Vector::y());
    let up = all.iter().find(|f| f.lo <= 0.0 && 0.0 <= f.hi).expect("free straight up");
    assert!(up.hi <= tilt + 1e-9 && up.hi >= tilt - TOL, "{} {tilt}", up.hi);
    assert!(up.lo >= -tilt - 1e-9 && up.lo <= TOL - tilt, "{} {tilt}", up.lo);
}

/// A wall round +y: for each corner of the base a height and a radius below and above.
fn wall_round_y(facets: u32, centre: Point, [below, above]: [[f64; 2]; 2]) -> Mesh {
    let mut mesh = Mesh::default();
    for [height, radius] in [below, above] {
        mesh.points.extend((0..facets).map(|k| {
            let (s, c) = (TAU * f64::from(k) / f64::from(facets)).sin_cos();
            centre + Vector::new(radius * s, height, radius * c)
        }));
    }
    for k in 0..facets {
        let (a, b) = (k, (k + 1) % facets);
        mesh.triangles.extend([[a, b, a + facets], [b, b + facets, a + facets]]);
    }
    mesh
}

#[test]
fn between_two_plates_the_tilt_is_the_closed_form() {
    let mut mesh = Mesh::default();
    for z in [-7.0, 7.0] {
        let n = mesh.points.len() as u32;
        let corners = [[-80.0, -30.0], [80.0, -30.0], [80.0, 12.0], [-80.0, 12.0]];
        mesh.points.extend(corners.map(|[x, y]| Point::new(x, y, z)));
        mesh.triangles.extend([[n, n + 1, n + 2], [n, n + 2, n + 3]]);
    }
    leaves_the_tilt_of_its_rim(&mesh, 12.0, 7.0);
}

/// The wall leans by 10° outward, less than the tool may tilt: its rim is in the way.
#[test]
fn in_a_cone_shaped_well_the_tilt_is_the_closed_form() {
    let (rim, over) = (9.0, 20.0);
    let foot = rim - (over + 6.0) * 10f64.to_radians().tan();
    let mesh = wall_round_y(360, Point::origin(), [[-6.0, foot], [over, rim]]);
    assert!(tilt_to_a_rim(over, rim, 3.2) > 10f64.to_radians());
    leaves_the_tilt_of_its_rim(&mesh, over, rim);
}

/// Eight posts stand round the ball; in the plane of the tilt two of them, and no other is as near
/// to the tool as their tops.
#[test]
fn in_a_ring_of_posts_the_tilt_is_the_closed_form() {
    let (away, radius, over) = (12.0, 2.0, 25.0);
    let mut mesh = Mesh::default();
    for k in 0..8 {
        let (s, c) = (TAU * f64::from(k) / 8.0).sin_cos();
        let post = wall_round_y(180, Point::new(away * s, 0.0, away * c), [[-20.0, radius], [over, radius]]);
        let n = mesh.points.len() as u32;
        mesh.points.extend(post.points);
        mesh.triangles.extend(post.triangles.iter().map(|t| t.map(|p| p + n)));
    }
    leaves_the_tilt_of_its_rim(&mesh, over, away - radius);
}

#[test]
fn contact_angles_limit_in_closed_form() {
    let t = tool(4.0, 0.0);
    let mut o = leaning(0.1);
    let s = &mut o.1.settings;
    (s.contact_angle_min_deg, s.contact_angle_max_deg) = (0.5f64.to_degrees(), 1.4f64.to_degrees());
    let far = Point::new(1e4, 0.0, 0.0);
    let n = Vector::new(0.2, 0.6, -0.7).normalize();
    let found = free(&triangle(far, far, far), &t, &o, &Point::origin(), &n);
    let m = n.y.hypot(n.z) * 0.1f64.cos();
    let at = |c: f64| ((c.cos() - n.x * 0.1f64.sin()) / m).acos();
    assert_eq!(found.len(), 2);
    assert!((found[1].lo - at(0.5)).abs() <= TOL && (found[1].hi - at(1.4)).abs() <= TOL, "{found:?}");
    assert!((found[0].hi + at(0.5)).abs() <= TOL && (found[0].lo + at(1.4)).abs() <= TOL, "{found:?}");
    assert!(found.iter().all(|f| f.lo_by == Witness::Contact && f.hi_by == Witness::Contact));
}

#[test]
fn nothing_near_leaves_the_whole_circle() {
    let far = Point::new(0.0, 500.0, 0.0);
    let found = free(&triangle(far, far, far), &tool(4.0, 3.0), &leaning(0.1), &Point::origin(), &Vector::y());
    assert_eq!(found.len(), 1);
    assert!(found[0].hi - found[0].lo == TAU && found[0].lo_by == Witness::Cut);
}

#[test]
fn a_point_on_the_turning_axis_is_free_or_not_at_all() {
    // On the line through the centre along the blade axis the height is the same for all angles.
    let t = tool(4.0, 0.0);
    let o = leaning(0.3);
    let on_axis = |x: f64| triangle(Point::new(x, 0.0, 0.0), Point::new(x, 0.0, 0.0), Point::new(x, 0.0, 0.0));
    // 12 mm up: distance from the tool axis 12 cos B = 11.5, clear of the cylinder; 4.3 mm: 4.1,
    // not clear.
    assert_eq!(free(&on_axis(12.0), &t, &o, &Point::origin(), &Vector::y()).len(), 1);
    assert!(free(&on_axis(4.3), &t, &o, &Point::origin(), &Vector::y()).is_empty());
}

fn random_case() -> impl Strategy<Value = (Mesh, Tool, f64, Point)> {
    let point = || (-25.0..40.0f64, -30.0..30.0f64, -30.0..30.0f64).prop_map(|(x, y, z)| Point::new(x, y, z));
    let triangles = prop::collection::vec((point(), -8.0..8.0f64, -8.0..8.0f64, -8.0..8.0f64, -8.0..8.0f64), 1..7);
    (triangles, 1.5..5.0f64, 0.0..12.0f64, -0.3..0.4f64).prop_map(|(triangles, radius, taper, b)| {
        let mut mesh = Mesh::default();
        for (p, a, b, c, d) in triangles {
            // Nothing inside the ball.
            let p = if p.coords.norm() < 20.0 { Point::from(p.coords.normalize() * 20.0) } else { p };
            let n = mesh.points.len() as u32;
            mesh.points.extend([p, p + Vector::new(a, b, c), p + Vector::new(d, a, b)]);
            mesh.triangles.push([n, n + 1, n + 2]);
        }
        let taper = if taper < 2.0 { 0.0 } else { taper };
        (mesh, tool(radius, taper), b, Point::origin())
    })
}

pub fn inside(found: &[Arc], t: f64, margin: f64) -> bool {
    found.iter().any(|f| [-TAU, 0.0, TAU].iter().any(|k| t + k >= f.lo - margin && t + k <= f.hi + margin))
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 48, ..ProptestConfig::default() })]

    /// Every angle that is declared free is free; every angle a tolerance outside is too near, but
    /// for a tool thinner by an eighth of the tolerance times the distance.
    #[test]
    fn ends_agree_with_the_distance_oracle((mesh, t, b, centre) in random_case()) {
        let o = leaning(b);
        let found = free(&mesh, &t, &o, &centre, &Vector::y());
        let mut at: Vec<f64> = (0..24).map(|k| -PI + TAU * k as f64 / 24.0).collect();
        for f in &found {
            at.extend([f.lo, f.hi, f.lo - 1.05 * TOL, f.hi + 1.05 * TOL]);
        }
        for theta in at {
            let margin = least_margin(&mesh, &t, (0.2, 1.0), Cone::about_blade(b), &centre, theta);
            if inside(&found, theta, 0.0) {
                prop_assert!(margin > -1e-9, "declared free at {theta} with margin {margin}");
            } else if !inside(&found, theta, TOL) {
                prop_assert!(margin < 3e-3, "declared taken at {theta} with margin {margin}");
            }
        }
    }

    /// Turning everything about the blade axis turns the free angles; mirroring mirrors them.
    #[test]
    fn symmetric((mesh, t, b, centre) in random_case(), turn in -3.0..3.0f64) {
        let o = leaning(b);
        let found = free(&mesh, &t, &o, &centre, &Vector::y());
        let rotation = nalgebra::Isometry3::rotation(Vector::x() * turn);
        let turned = free(&mesh.clone().moved(&rotation), &t, &o, &(rotation * centre), &(rotation * Vector::y()));
        prop_assert_eq!(found.len(), turned.len());
        for (f, g) in found.iter().zip(&turned) {
            prop_assert!((f.lo - g.lo).abs() < 3.0 * TOL && (f.hi - g.hi).abs() < 3.0 * TOL);
        }
        let mut mirror = mesh;
        for p in &mut mirror.points {
            p.z = -p.z;
        }
        let mirrored = free(&mirror, &t, &o, &centre, &Vector::y());
        for (f, g) in found.iter().rev().zip(&mirrored).filter(|(f, _)| f.hi <= PI) {
            if g.hi <= PI && found.len() == mirrored.len() {
                prop_assert!((f.lo + g.hi).abs() < 3.0 * TOL && (f.hi + g.lo).abs() < 3.0 * TOL);
            }
        }
    }
}
