//! The sphere of tool axes against dense angles, circles and closed forms.

use proptest::prelude::*;

use super::super::forbidden::{ObstacleBody, ObstacleScene, PlaceSearch, View};
use super::super::options::ChannelOptions;
use super::super::profile::ToolProfile;
use super::super::region::EvenMove;
use super::super::sphere::SphereSearch;
use super::super::tree::SphereTree;
use super::brute::{any_cone, any_mesh, any_tool, cases};
use super::location::open_options;
use super::world::{least_margin, tool};
use crate::artifact::Cone;
use crate::artifact::sphere::{CellState, FreeSphere};
use crate::geometry::mesh::Mesh;
use crate::geometry::{Point, Vector};
use crate::tool::Tool;

const ROOM: (f64, f64) = (0.2, 1.0);

fn with_scene<T>(mesh: &Mesh, tool: &Tool, options: &ChannelOptions, f: impl FnOnce(&ObstacleScene) -> T) -> T {
    let tree = SphereTree::new(mesh, 4.0);
    let profile = ToolProfile::new(tool, [ROOM.0, ROOM.1], 0.0);
    f(&ObstacleScene { bodies: vec![ObstacleBody { name: "part", mesh, tree: &tree, profile }], options })
}

fn sphere(mesh: &Mesh, tool: &Tool, options: &ChannelOptions, finest_deg: f64) -> FreeSphere {
    with_scene(mesh, tool, options, |scene| {
        SphereSearch::new(scene, finest_deg.to_radians()).at(&Point::origin(), &Vector::x())
    })
}

/// Axes spread evenly over the sphere: a spiral of the golden angle.
fn axes(count: usize) -> impl Iterator<Item = Vector> {
    let golden = std::f64::consts::PI * (3.0 - 5f64.sqrt());
    (0..count).map(move |k| {
        let x = 1.0 - (2.0 * k as f64 + 1.0) / count as f64;
        let (s, c) = (golden * k as f64).sin_cos();
        let across = (1.0 - x * x).sqrt();
        Vector::new(x, across * c, across * s)
    })
}

/// The cone of which an axis is the one at θ = 0.
fn cone_to(axis: &Vector) -> Cone {
    let square = axis.cross(&if axis.x.abs() < 0.7 { Vector::x() } else { Vector::y() });
    Cone::new(square, *axis, 0.0).unwrap()
}

proptest! {
    #![proptest_config(ProptestConfig { cases: cases(60), ..ProptestConfig::default() })]

    /// With an axis of a free cell the tool is clear of dense points, with one of a taken cell it
    /// is not; the cells cover the sphere once.
    #[test]
    fn cells_are_those_of_brute_force(mesh in any_mesh(), tool in any_tool()) {
        let found = sphere(&mesh, &tool, &open_options(), 3.0);
        let shares = found.shares();
        prop_assert!((shares.iter().sum::<f64>() - 1.0).abs() < 1e-9, "{shares:?}");
        for axis in axes(150) {
            let cell = found.cell_at(&axis).unwrap();
            let margin = || least_margin(&mesh, &tool, ROOM, cone_to(&axis), &Point::origin(), 0.0);
            match cell.state {
                CellState::Free => prop_assert!(margin() > -1e-7, "free at {axis:?}: {}", margin()),
                CellState::Taken(_) => prop_assert!(margin() < 1e-4, "taken at {axis:?}: {}", margin()),
                CellState::Open => {}
            }
        }
    }

    /// On a circle of axes free cells lie in its free intervals and taken ones beside them.
    #[test]
    fn circles_agree(mesh in any_mesh(), tool in any_tool(), cone in any_cone()) {
        let options = open_options();
        let found = sphere(&mesh, &tool, &options, 2.0);
        let free = with_scene(&mesh, &tool, &options, |scene| {
            let view = View { centre: Point::origin(), cone, azimuth: 0.0, within_rad: None, motion: EvenMove::none() };
            PlaceSearch::new(scene).free(&view, &Vector::x(), None)
        });
        let tolerance = 2.0 * options.settings.tolerance_deg.to_radians();
        for k in -180..180 {
            let theta = f64::from(k).to_radians();
            let within = |by: f64| free.iter().any(|f| [-1.0, 0.0, 1.0].iter().any(|t| {
                (f.lo - by..=f.hi + by).contains(&(theta + t * std::f64::consts::TAU))
            }));
            match found.cell_at(&cone.tool_axis(theta)).unwrap().state {
                CellState::Free => prop_assert!(within(tolerance), "{k}°"),
                CellState::Taken(_) => prop_assert!(!within(-tolerance), "{k}°"),
                CellState::Open => {}
            }
        }
    }
}

/// Midway between two plates that end at the height `t` over the ball a cylinder may tilt towards
/// one of them until it touches its rim: `(g/2) cos φ − t sin φ = R + c`.
#[test]
fn between_plates_the_tilt_is_the_closed_form() {
    let (gap, height, radius_mm) = (14.0, 12.0, 3.0);
    let mut mesh = Mesh::default();
    for y in [-0.5 * gap, 0.5 * gap] {
        let n = mesh.points.len() as u32;
        let corners = [[-30.0, -80.0], [height, -80.0], [height, 80.0], [-30.0, 80.0]];
        mesh.points.extend(corners.map(|[x, z]| Point::new(x, y, z)));
        mesh.triangles.extend([[n, n + 1, n + 2], [n, n + 2, n + 3]]);
    }
    let mut cylinder = tool(radius_mm, 0.0);
    (cylinder.stickout_mm, cylinder.holder) = (60.0, Vec::new());
    let found = sphere(&mesh, &cylinder, &open_options(), 0.25);
    let half = 0.5 * gap;
    let tilt = ((radius_mm + ROOM.0) / half.hypot(height)).acos() - height.atan2(half);
    let state = |phi: f64| found.cell_at(&Vector::new(phi.cos(), phi.sin(), 1e-3)).unwrap().state;
    // A cell that is open reaches over the limit by less than its size.
    let off = 1.5 * f64::to_radians(0.5);
    for sense in [-1.0, 1.0] {
        assert_eq!(state(sense * (tilt - off)), CellState::Free, "{tilt}");
        assert!(matches!(state(sense * (tilt + off)), CellState::Taken(_)), "{tilt}");
    }
    let [_, _, open] = found.shares();
    assert!(open < 0.03, "{open}");
    // Along the plates there is room all the way round.
    assert_eq!(found.cell_at(&Vector::new(0.5, 0.01, 0.8)).unwrap().state, CellState::Free);
}

/// Ball contact outside of its range takes axes, and nothing else does far from all.
#[test]
fn the_contact_angle_is_a_cap() {
    let far = Mesh { points: vec![Point::new(0.0, 0.0, 500.0); 3], triangles: vec![[0, 1, 2]], ..Mesh::default() };
    let options = ChannelOptions::default().with(|s| (s.contact_angle_min_deg, s.contact_angle_max_deg) = (10.0, 60.0));
    let [free, taken, open] = sphere(&far, &tool(3.0, 4.0), &options, 0.3).shares();
    let exact = 0.5 * (10f64.to_radians().cos() - 60f64.to_radians().cos());
    assert!(free <= exact && free + open >= exact && open < 0.02, "{free} {taken} {open} for {exact}");
    // A range that begins at 0 cuts nothing off along the normal.
    let found = sphere(&far, &tool(3.0, 4.0), &ChannelOptions::default(), 0.3);
    assert_eq!(found.cell_at(&Vector::new(1.0, 1e-3, 2e-3)).unwrap().state, CellState::Free);
}
