//! Thousands of random tools, parts, positions and moves against dense points and dense angles.

use std::f64::consts::{PI, TAU};

use proptest::prelude::*;

use super::super::arcs::{Arc, Witness};
use super::super::forbidden::{ObstacleBody, ObstacleScene, PlaceSearch, View};
use super::super::moves::even_move;
use super::super::options::ChannelOptions;
use super::super::profile::ToolProfile;
use super::super::region::EvenMove;
use super::super::samples::Sample;
use super::super::track::Tracker;
use super::super::tree::SphereTree;
use super::location::{TOL, inside, open_options};
use super::world::{deepest, least_margin};
use crate::artifact::Cone;
use crate::geometry::mesh::Mesh;
use crate::geometry::{Point, Vector};
use crate::tool::{HolderStage, Tool};

/// Points on each triangle: a grid of this many along each side.
const GRID: usize = 9;
const ROOM: (f64, f64) = (0.2, 1.0);

/// Cases of a test: so many times what the environment says.
pub fn cases(some: u32) -> u32 {
    let times = std::env::var("BLADEWRIGHT_CASES").ok().and_then(|v| v.parse().ok());
    some.saturating_mul(times.unwrap_or(1))
}

/// A tool with a taper or none, a shank and up to three holder stages, narrower or wider than one
/// another.
pub fn any_tool() -> impl Strategy<Value = Tool> {
    let stages = prop::collection::vec((1.0..20.0f64, 3.0..25.0f64), 0..4);
    (0.8..5.0f64, 0.0..20.0f64, 1.0..2.5f64, 4.0..30.0f64, stages).prop_map(|(r, taper, shank, stickout, stages)| {
        Tool {
            radius_mm: r,
            corner_radius_mm: None,
            taper_deg: if taper < 3.0 { 0.0 } else { taper },
            shank_radius_mm: shank * r,
            stickout_mm: r + stickout,
            holder: stages.into_iter().map(|(radius_mm, length_mm)| HolderStage { radius_mm, length_mm }).collect(),
        }
    })
}

/// Triangles at random, in a body of its own each if `bodies`; the ball centre is at the origin
/// before all is turned.
pub fn any_mesh() -> impl Strategy<Value = Mesh> {
    let point = || prop::array::uniform3(-35.0..35.0f64);
    let triangle = (point(), prop::array::uniform6(-9.0..9.0f64));
    prop::collection::vec(triangle, 1..6).prop_map(|triangles| {
        let mut mesh = Mesh::default();
        for (p, d) in triangles {
            // Nothing inside the ball.
            let p = Vector::from(p);
            let p = Point::from(if p.norm() < 16.0 { p.normalize() * 16.0 } else { p });
            let n = mesh.points.len() as u32;
            mesh.points.extend([p, p + Vector::new(d[0], d[1], d[2]), p + Vector::new(d[3], d[4], d[5])]);
            mesh.triangles.push([n, n + 1, n + 2]);
        }
        mesh
    })
}

fn with_scene<T>(mesh: &Mesh, tool: &Tool, options: &ChannelOptions, f: impl FnOnce(&mut PlaceSearch) -> T) -> T {
    let tree = SphereTree::new(mesh, 4.0);
    let profile = ToolProfile::new(tool, [ROOM.0, ROOM.1], 0.0);
    let scene = ObstacleScene { bodies: vec![ObstacleBody { name: "part", mesh, tree: &tree, profile }], options };
    f(&mut PlaceSearch::new(&scene))
}

/// Dense points of all triangles.
fn dense(mesh: &Mesh) -> Vec<Point> {
    let mut out = Vec::new();
    for t in 0..mesh.triangles.len() {
        let [a, b, c] = mesh.corners(t);
        for i in 0..=GRID {
            for j in 0..=GRID - i {
                out.push(a + (b - a) * (i as f64 / GRID as f64) + (c - a) * (j as f64 / GRID as f64));
            }
        }
    }
    out
}

/// The one triangle that an end of an interval names.
fn named(mesh: &Mesh, w: Witness, tree_side: f64) -> Option<Mesh> {
    let Witness::Tool { leaf, .. } = w else { return None };
    let tree = SphereTree::new(mesh, tree_side);
    let points = mesh.corners(tree.triangle(leaf) as usize).to_vec();
    Some(Mesh { points, triangles: vec![[0, 1, 2]], ..Mesh::default() })
}

/// A cone about the blade axis, or about any other.
pub fn any_cone() -> impl Strategy<Value = Cone> {
    let axis = prop_oneof![Just([0.0; 3]), prop::array::uniform3(-1.0..1.0f64)];
    (axis, prop::array::uniform3(-1.0..1.0f64), -0.5..0.6f64)
        .prop_map(|(c, e, lean)| Cone::new(Vector::from(c), Vector::from(e), lean).unwrap_or(Cone::about_blade(lean)))
}

/// A tool that stands still, seen in the frame whose angle 0 is at `azimuth`.
fn at(centre: Point, cone: Cone, azimuth: f64) -> View {
    View { centre, cone, azimuth, within_rad: None, motion: EvenMove::none() }
}

proptest! {
    #![proptest_config(ProptestConfig { cases: cases(200), ..ProptestConfig::default() })]

    /// No point of the part is inside the tool at an angle that is declared free; an angle that is
    /// declared taken is within the tolerance of one at which the triangle named by the nearest end
    /// is too near. All is turned about the blade axis and moved along, and the cone stands anyhow.
    #[test]
    fn free_intervals_are_those_of_brute_force(
        mesh in any_mesh(), tool in any_tool(), cone in any_cone(), turn in -PI..PI, shift in prop::array::uniform3(-50.0..50.0f64),
    ) {
        let o = open_options();
        let place = nalgebra::Isometry3::translation(shift[0], shift[1], shift[2]) * nalgebra::Isometry3::rotation(Vector::x() * turn);
        let mesh = mesh.moved(&place);
        let centre = place * Point::origin();
        let found = with_scene(&mesh, &tool, &o, |s| s.free(&at(centre, cone, 0.0), &Vector::y(), None));
        let (points, segments) = (dense(&mesh), tool.segments());
        for k in 0..180 {
            let theta = -PI + TAU * (f64::from(k) + 0.37) / 180.0;
            if inside(&found, theta, 0.0) {
                let hit = deepest(&points, &segments, ROOM, cone, &centre, theta);
                prop_assert!(hit < 1e-9, "declared free at {theta}: a point is {hit} inside");
            }
        }
        for (end, by, out) in found.iter().flat_map(|f| [(f.lo, f.lo_by, -1.0), (f.hi, f.hi_by, 1.0)]) {
            let hit = deepest(&points, &segments, ROOM, cone, &centre, end);
            prop_assert!(hit < 1e-9, "end {end}: a point is {hit} inside");
            if let Some(only) = named(&mesh, by, 4.0) {
                let margin = least_margin(&only, &tool, ROOM, cone, &centre, end + out * 1.05 * TOL);
                prop_assert!(margin < 0.125 * TOL * 60.0 + 1e-3, "beyond the end {end} there is still {margin} mm of room");
            }
        }
    }

}

proptest! {
    #![proptest_config(ProptestConfig { cases: cases(80), ..ProptestConfig::default() })]

    /// Along a path, with short and long steps, every place has the free angles that it has when
    /// looked at alone, and no dense point is inside the tool at one of them: with one cone, with
    /// cones that turn and lean from place to place, with references that jump, and where only a
    /// part of the circle is asked for.
    #[test]
    fn along_a_path_as_alone(
        mesh in any_mesh(), tool in any_tool(), mut cone in any_cone(), turn in -PI..PI, way in prop::array::uniform3(-1.0..1.0f64),
        steps in prop::collection::vec((prop_oneof![0.0..0.05f64, 0.0..0.4f64, 0.0..4.0f64], -0.05..0.05f64), 1..12),
        turns in prop_oneof![Just([0.0; 5]), prop::array::uniform5(-0.05..0.05f64), prop::array::uniform5(-0.8..0.8f64)],
        within in prop_oneof![Just(None), (0.01..2.0f64).prop_map(Some)],
    ) {
        let o = open_options();
        let place = nalgebra::Isometry3::rotation(Vector::x() * turn);
        let mesh = mesh.moved(&place);
        let way = place * Vector::from(way);
        let (points, segments) = (dense(&mesh), tool.segments());
        let tree = SphereTree::new(&mesh, 4.0);
        let profile = ToolProfile::new(&tool, [ROOM.0, ROOM.1], 0.0);
        let scene = ObstacleScene { bodies: vec![ObstacleBody { name: "part", mesh: &mesh, tree: &tree, profile }], options: &o };
        let (mut tracker, mut centre, mut azimuth) = (Tracker::new(&scene), Point::origin(), 0.0);
        for (step, bend) in steps {
            (centre, azimuth) = (centre + way * step, azimuth + bend);
            let [x, y, z, lean, about] = turns.map(|t| t * step.min(1.0));
            let by = nalgebra::UnitQuaternion::from_scaled_axis(Vector::new(x, y, z) + cone.axis * about);
            let lean_rad = (cone.lean_rad + lean).clamp(-1.0, 1.0);
            cone = if x == 0.0 { cone } else { Cone { axis: by * cone.axis, reference: by * cone.reference, lean_rad } };
            let normal = cone.unseen(&Vector::new(0.0, f64::cos(azimuth), f64::sin(azimuth)));
            let tracked = tracker.next(&Sample { row: 0, fraction: 0.0, centre, normal, cone, azimuth, within_rad: within });
            let mut alone = PlaceSearch::new(&scene).free(&at(centre, cone, azimuth), &normal, None);
            alone.iter_mut().for_each(|f| (f.lo, f.hi) = (f.lo + azimuth, f.hi + azimuth));
            if let Some(within) = within {
                prop_assert!(tracked.iter().all(|f| f.lo > azimuth - within && f.hi < azimuth + within));
                let parts = |f: Arc| [-TAU, 0.0, TAU].map(|turn| Arc {
                    lo: (f.lo + turn).max(azimuth - within),
                    hi: (f.hi + turn).min(azimuth + within),
                    ..f
                });
                alone = alone.into_iter().flat_map(parts).filter(|f| f.lo < f.hi).collect();
            }
            for (one, other) in [(&tracked, &alone), (&alone, &tracked)] {
                for f in one.iter().filter(|f| f.hi - f.lo > 8.0 * TOL) {
                    for theta in [f.lo + 2.0 * TOL, 0.5 * (f.lo + f.hi), f.hi - 2.0 * TOL] {
                        prop_assert!(inside(other, theta, 0.0), "{theta} is in one only: {tracked:?} {alone:?}");
                    }
                }
            }
            for k in 0..60 {
                let theta = -PI + TAU * (f64::from(k) + 0.37) / 60.0;
                if inside(&tracked, theta, 0.0) {
                    let hit = deepest(&points, &segments, ROOM, cone, &centre, theta);
                    prop_assert!(hit < 1e-9, "declared free at {theta}: a point is {hit} inside");
                }
            }
        }
    }
}

proptest! {
    #![proptest_config(ProptestConfig { cases: cases(30), ..ProptestConfig::default() })]

    /// Angles declared free during a whole move are free at every time of it, in the frame that
    /// turns along; and every end is one at which something is too near at some time.
    #[test]
    fn moves_are_free_all_the_way(
        mesh in any_mesh(), tool in any_tool(), cone in any_cone(),
        along in prop::array::uniform3(-0.6..0.6f64), half_turn in -0.06..0.06f64, azimuth in -PI..PI,
        turns in prop_oneof![Just([0.0; 4]), prop::array::uniform4(-0.01..0.01f64)],
    ) {
        let o = open_options();
        let half_move = Vector::from(along);
        let end = |sense: f64| {
            let by = nalgebra::UnitQuaternion::from_scaled_axis(Vector::new(turns[0], turns[1], turns[2]) * sense);
            let (axis, reference, lean_rad) = (by * cone.axis, by * cone.reference, cone.lean_rad + 0.1 * turns[3] * sense);
            let cone = if turns[0] == 0.0 { cone } else { Cone { axis, reference, lean_rad } };
            Sample { row: 0, fraction: 0.0, centre: Point::origin() + half_move * sense, normal: Vector::y(), cone, azimuth, within_rad: None }
        };
        let (from, to) = (end(-1.0), end(1.0));
        let view = even_move(&from, &to, half_turn, [0.0, 1.0]);
        let found = with_scene(&mesh, &tool, &o, |s| s.free_moving(&view, &[], None));
        let (points, segments) = (dense(&mesh), tool.segments());
        for time in [-1.0, -0.7, -0.2, 0.0, 0.35, 0.8, 1.0] {
            let centre = Point::origin() + half_move * time;
            let ends = found.iter().filter(|f| f.hi - f.lo > 1e-6).flat_map(|f| [f.lo, 0.5 * (f.lo + f.hi), f.hi]);
            let spread = (0..40).map(|k| -PI + TAU * (f64::from(k) + 0.4) / 40.0).filter(|t| inside(&found, *t, 0.0));
            for phi in ends.chain(spread) {
                let theta = azimuth + half_turn * time + phi;
                let cone = from.cone.between(&to.cone, 0.5 + 0.5 * time);
                let hit = deepest(&points, &segments, ROOM, cone, &centre, theta);
                prop_assert!(hit < 1e-9, "declared free at {theta}, time {time}: a point is {hit} inside");
            }
        }
        for (end, by, out) in found.iter().flat_map(|f| [(f.lo, f.lo_by, -1.0), (f.hi, f.hi_by, 1.0)]) {
            // What is kept for a cone that turns or leans between the places is not to be tight.
            let Some(only) = named(&mesh, by, 4.0).filter(|_| turns[0] == 0.0) else { continue };
            let nearest = (0..=64).map(|k| {
                let time = -1.0 + f64::from(k) / 32.0;
                let theta = azimuth + half_turn * time + end + out * 5.5 * TOL;
                let centre = Point::origin() + half_move * time;
                least_margin(&only, &tool, ROOM, cone, &centre, theta)
            });
            let nearest = nearest.fold(f64::INFINITY, f64::min);
            prop_assert!(nearest < 0.02, "beyond the end {end} there are still {nearest} mm of room all the way");
        }
    }
}

/// As [`inside`] for one arc.
#[test]
fn an_angle_is_inside_its_own_arc() {
    let arc = Arc { lo: -0.5, hi: 0.5, lo_by: Witness::Cut, hi_by: Witness::Cut };
    assert!(inside(&[arc], TAU, 0.0) && !inside(&[arc], 1.0, 0.0));
}

/// The frusta as polyhedra with `sides` sides, `scale` times as thick, about the middles of their
/// heights.
fn polyhedra(tool: &Tool, scale: f64) -> Vec<(parry3d_f64::shape::ConvexPolyhedron, f64)> {
    const SIDES: usize = 64;
    let of = |s: crate::tool::Segment| {
        let middle = 0.5 * (s.z0 + s.z1);
        let ring = |z: f64, r: f64| {
            (0..SIDES).map(move |k| {
                let (sin, cos) = (TAU * k as f64 / SIDES as f64).sin_cos();
                parry3d_f64::math::Vector::new(scale * r * cos, z - middle, scale * r * sin)
            })
        };
        let points: Vec<_> = ring(s.z0, s.r0).chain(ring(s.z1, s.r1)).collect();
        parry3d_f64::shape::ConvexPolyhedron::from_convex_hull(&points).map(|p| (p, middle))
    };
    tool.segments().into_iter().filter_map(of).collect()
}

/// parry's generic test of one of the triangles against one of the polyhedra.
fn touches(shapes: &[(parry3d_f64::shape::ConvexPolyhedron, f64)], mesh: &Mesh, b: f64, theta: f64) -> bool {
    use parry3d_f64::math::{Pose, Rotation, Vector as V};
    let a = crate::tool::axis(b, theta);
    let rotation = Rotation::from_rotation_arc(V::new(0.0, 1.0, 0.0), V::new(a.x, a.y, a.z));
    (0..mesh.triangles.len()).any(|t| {
        let [p, q, r] = mesh.corners(t).map(|c| V::new(c.x, c.y, c.z));
        let triangle = parry3d_f64::shape::Triangle::new(p, q, r);
        shapes.iter().any(|(shape, z)| {
            let pose = Pose::from_parts(V::new(a.x, a.y, a.z) * *z, rotation);
            parry3d_f64::query::intersection_test(&Pose::IDENTITY, &triangle, &pose, shape)
                .is_ok_and(|i| i.intersecting)
        })
    })
}

proptest! {
    #![proptest_config(ProptestConfig { cases: cases(80), ..ProptestConfig::default() })]

    /// Between a polyhedron inside each frustum and one around it, parry3d agrees on triangles.
    #[test]
    fn parry_agrees_on_convex_pieces(mesh in any_mesh(), tool in any_tool(), b in -0.3..0.4f64) {
        let o = open_options();
        let tree = SphereTree::new(&mesh, 4.0);
        let profile = ToolProfile::new(&tool, [0.0, 0.0], 0.0);
        let scene = ObstacleScene { bodies: vec![ObstacleBody { name: "part", mesh: &mesh, tree: &tree, profile }], options: &o };
        let found = PlaceSearch::new(&scene).free(&at(Point::origin(), Cone::about_blade(b), 0.0), &Vector::y(), None);
        // Inscribed, less a millionth; circumscribed, and a thousandth more for what is only nearly
        // touched.
        let (within, around) = (polyhedra(&tool, 1.0 - 1e-6), polyhedra(&tool, 1.0 / (PI / 64.0).cos() + 2e-3));
        for k in 0..36 {
            let theta = -PI + TAU * (f64::from(k) + 0.3) / 36.0;
            if inside(&found, theta, -1e-3) {
                prop_assert!(!touches(&within, &mesh, b, theta), "declared free at {theta}");
            } else if !inside(&found, theta, 2.0 * TOL) {
                prop_assert!(touches(&around, &mesh, b, theta), "declared taken at {theta}");
            }
        }
    }
}
