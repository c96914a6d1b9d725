//! Cutters with a corner: walls in closed form.

use std::f64::consts::TAU;

use nalgebra::Isometry3;
use proptest::prelude::*;

use super::super::arcs::Witness;
use super::super::cornered::apart;
use super::super::forbidden::Free;
use super::super::report::Reporter;
use super::super::samples::Sample;
use super::super::{ChannelOptions, Surroundings, advise, intervals, plan, samples_of};
use super::brute::{any_mesh, cases};
use super::world;
use crate::artifact::channel::Binding;
use crate::artifact::toolpath::{CutterLocation, Turn};
use crate::artifact::{Cones, Obstacle, Sweep, ToolPart, Toolpath};
use crate::error::{Bound, ErrorKind, Infeasible};
use crate::geometry::mesh::Mesh;
use crate::geometry::part::Part;
use crate::geometry::{Point, Vector};
use crate::observe::Silent;
use crate::sample;
use crate::tool::{HolderStage, Tool};

const HOLLOW_MM: f64 = 40.0;

fn bull() -> Tool {
    Tool { radius_mm: 8.0, corner_radius_mm: Some(2.0), holder: Vec::new(), stickout_mm: 20.0, ..world::tool(8.0, 0.0) }
}

fn trough(steps: u32) -> Mesh {
    sample::trough(HOLLOW_MM, steps)
}

/// A path along its middle, of corners of a radius; amid it the cutter has room at both ends.
fn along_the_trough(corner_mm: f64) -> Toolpath {
    let at = |k: usize| {
        let angle = 0.9 + 0.01 * k as f64;
        let out = Vector::new(0.0, angle.cos(), angle.sin());
        let (contact, s) = (Point::from(out * HOLLOW_MM), 0.01 * (HOLLOW_MM - corner_mm) * k as f64);
        CutterLocation { turn: 0, turn_s_mm: s, s_mm: s, centre: contact - out * corner_mm, contact, normal: -out }
    };
    let locations: Vec<CutterLocation> = (0..30).map(at).collect();
    let turns = vec![Turn { first: 0, count: 30, length_mm: 10.0 }];
    let path = world::helix(&world::ellipse(9.0, 4.0), corner_mm, 30, 1, 10.0, 1.0);
    Toolpath { locations, turns, cones: Cones::about_blade(0.0), ..path }
}

fn options(least_deg: f64, most_deg: f64) -> ChannelOptions {
    ChannelOptions { sweep: Sweep::Follow, ..ChannelOptions::default() }.with(|s| {
        (s.contact_angle_min_deg, s.contact_angle_max_deg) = (least_deg, most_deg);
    })
}

/// In a round trough of radius ρ the back of a disc of radius R comes to the wall where
/// `sin α = R / (ρ − r)`.
#[test]
fn on_hollow_ground_the_back_of_the_disc_is_the_wall() {
    let (blade, tool, path) = (world::blade(trough(4000)), bull(), along_the_trough(2.0));
    let channel = plan(&blade, &tool, &path, &options(3.0, 20.0), &Silent).unwrap();
    let least = (tool.disc_radius_mm() / (HOLLOW_MM - tool.corner_mm())).asin();
    for (row, l) in channel.rows.iter().zip(&path.locations) {
        let azimuth = path.cone(0).theta_of(&l.normal, 0.0).unwrap();
        let on = |theta: f64| (theta - azimuth).rem_euclid(std::f64::consts::TAU);
        assert!((on(row.theta_min) - least).abs() < 0.002, "{} {least}", on(row.theta_min));
        assert!((on(row.theta_max) - 20f64.to_radians()).abs() < 1e-9, "{}", on(row.theta_max));
        assert!(matches!(row.binds_min, Binding::Part { tool: ToolPart::Cutter, .. }), "{:?}", row.binds_min);
        assert_eq!(row.binds_max, Binding::ContactAngle);
    }
    // The lists of all free angles are the same.
    let around = Surroundings::new(&blade, &[], tool.radius_mm).unwrap();
    let free = intervals(&around, &tool, &path, &options(3.0, 20.0), &Silent).unwrap();
    assert!(free.iter().zip(&channel.rows).all(|(f, r)| f.len() == 1 && f[0].theta_max == r.theta_max));
}

/// Where no inclination within the range will do, the message names the one that would.
#[test]
fn a_hollow_too_narrow_is_refused_with_the_inclination_that_would_do() {
    let (blade, tool, path) = (world::blade(trough(4000)), bull(), along_the_trough(2.0));
    let e = plan(&blade, &tool, &path, &options(3.0, 8.0), &Silent).unwrap_err();
    assert_eq!(e.kind, ErrorKind::Infeasible);
    let needs_deg = (tool.disc_radius_mm() / (HOLLOW_MM - tool.corner_mm())).asin().to_degrees();
    let told = e.message.split("; at ").nth(1).and_then(|rest| rest.split('°').next()).unwrap();
    assert!((told.parse::<f64>().unwrap() - needs_deg).abs() < 0.15, "{e} {needs_deg}");
    let Some(Infeasible::NoFreeAngle { bounds, .. }) = e.infeasible.as_deref() else { panic!("{:?}", e.infeasible) };
    assert!(matches!(&bounds[..], [Bound::Part { tool, .. }] if tool == "cutter"), "{bounds:?}");
}

/// Where windows of 3 to 20° go on 25° farther at once, and the normal turns by 0.01 rad, they
/// would join at 28.57° before that.
#[test]
fn angles_that_do_not_join_are_told_with_the_one_that_would() {
    let (blade, tool, path) = (world::blade(trough(40)), bull(), along_the_trough(2.0));
    let options = options(3.0, 20.0);
    let around = Surroundings::new(&blade, &[], tool.radius_mm).unwrap();
    let samples = samples_of(&tool, &path, &options);
    let scene = around.scene(&tool, &options);
    let window = |s: &Sample| {
        let [lo, hi] = [3f64, 20.0].map(|angle| s.azimuth + angle.to_radians());
        Free { lo, hi, lo_by: Witness::Contact, hi_by: Witness::Contact }
    };
    let mut layers: Vec<Vec<Free>> = samples.iter().map(|s| vec![window(s)]).collect();
    for f in layers[15..].iter_mut().flatten() {
        (f.lo, f.hi) = (f.lo + 25f64.to_radians(), f.hi + 25f64.to_radians());
    }
    let reporter = Reporter { blade: &blade, path: &path, scene: &scene, samples: &samples, is_start: true };
    let refused = |at| apart(&layers, &reporter, at).unwrap().message;
    assert!(refused(15).contains("; at 28.57° just before they would"), "{}", refused(15));
    assert!(!refused(14).contains("just before they would"), "{}", refused(14));
}

/// What is advised is the closed form but for the way from place to place, of 0.01 rad, over which
/// windows overlap: the least inclination of the disc there is, and the widest disc that the range
/// of contact angle leaves.
#[test]
fn the_least_inclination_and_the_widest_cutter_are_advised() {
    let (blade, tool, mut path) = (world::blade(trough(400)), bull(), along_the_trough(2.0));
    path.locations.truncate(8);
    path.turns[0].count = 8;
    let around = Surroundings::new(&blade, &[], tool.radius_mm).unwrap();
    let (room_mm, most, step) = (HOLLOW_MM - tool.corner_mm(), 15f64.to_radians(), 0.01);
    let advice = advise(&around, &tool, &path, &options(3.0, 15.0), &[0.0], &Silent).unwrap();
    assert!(advice.now.is_open() && advice.least_travel.is_none(), "{:?}", advice.now);
    let corner = advice.corner.unwrap();
    let (needs, told) = ((tool.disc_radius_mm() / room_mm).asin(), corner.contact_deg.unwrap().to_radians());
    assert!(told > needs && told < needs + step + 0.004, "{told} {needs}");
    let widest_mm = [most - step, most].map(|angle| tool.corner_mm() + room_mm * angle.sin());
    let told_mm = corner.radius_mm.unwrap();
    assert!(told_mm > widest_mm[0] - 0.2 && told_mm < widest_mm[1], "{told_mm} {widest_mm:?}");
}

/// On a round wall the window is the range of contact angle, forwards; where the wall leans by more
/// than the range there is none.
#[test]
fn on_round_walls_the_window_is_the_range_of_contact_angle() {
    let blade = world::on_platform(&world::ellipse(20.0, 20.0), 1440, 45.0);
    let path = world::helix(&world::ellipse(20.0, 20.0), 2.0, 360, 1, 30.0, 1.0);
    let upright = Toolpath { cones: Cones::about_blade(0.0), ..path.clone() };
    let tool = bull();
    let channel = plan(&blade, &tool, &upright, &options(3.0, 12.0), &Silent).unwrap();
    for (row, l) in channel.rows.iter().zip(&upright.locations) {
        let azimuth = upright.cone(0).theta_of(&l.normal, 0.0).unwrap();
        let on = [row.theta_min, row.theta_max].map(|t| (t - azimuth).rem_euclid(std::f64::consts::TAU).to_degrees());
        assert!((on[0] - 3.0).abs() < 1e-6 && (on[1] - 12.0).abs() < 1e-6, "{on:?}");
    }
    let leaning = Toolpath { cones: Cones::about_blade(14f64.to_radians()), ..path };
    let e = plan(&blade, &tool, &leaning, &options(3.0, 12.0), &Silent).unwrap_err();
    assert!(e.message.contains("head and wall lean apart by 14.00°"), "{e}");
}

proptest! {
    #![proptest_config(ProptestConfig { cases: cases(16), ..ProptestConfig::default() })]

    /// Beside random facets, what is free is clear of taper, shank and holder, and what is taken
    /// lies no farther off than twice the room of a piece, or the disc is there.
    #[test]
    fn windows_beside_random_facets_are_what_the_tool_leaves(
        mesh in any_mesh(), turn in 0.0..TAU, out_mm in 25.0..60.0f64, up_mm in 5.0..50.0f64,
        corner_mm in 0.5..4.0f64, stickout_mm in 15.0..40.0f64, holder_mm in 6.0..20.0f64, lean in -0.05..0.05f64,
    ) {
        let blade = world::on_platform(&world::ellipse(20.0, 20.0), 360, 21.0);
        let path = world::helix(&world::ellipse(20.0, 20.0), corner_mm, 36, 1, 30.0, 1.0);
        let path = Toolpath { cones: Cones::about_blade(lean), ..path };
        let stage = HolderStage { radius_mm: holder_mm, length_mm: 30.0 };
        let tool = Tool { corner_radius_mm: Some(corner_mm), stickout_mm, holder: vec![stage], ..bull() };
        let place = Isometry3::new(Vector::new(up_mm, out_mm * turn.cos(), out_mm * turn.sin()), Vector::zeros());
        let mesh = mesh.moved(&place);
        prop_assume!(mesh.points.iter().all(|p| p.coords.norm() < 1e3));
        let obstacle = Obstacle {
            name: "facets".into(),
            part: Part::from_mesh(mesh.clone()),
            clearance_mm: 0.3,
            holder_clearance_mm: 1.0,
            cut_by_the_tool: false,
            of_the_wheel: false,
            copies: Vec::new(),
        };
        let options = options(4.0, 30.0);
        let free_among = |obstacles: &[Obstacle]| {
            let around = Surroundings::new(&blade, obstacles, tool.radius_mm).unwrap();
            intervals(&around, &tool, &path, &options, &Silent).unwrap()
        };
        let obstacles = [obstacle];
        let (windows, left) = (free_among(&[]), free_among(&obstacles));
        for ((l, window), left) in path.locations.iter().zip(&windows).zip(&left) {
            for theta in window.iter().flat_map(|w| (0..=20).map(|k| w.theta_min + (w.theta_max - w.theta_min) * f64::from(k) / 20.0)) {
                let cone = path.cone(0);
                let axis = cone.tool_axis(theta);
                let centre = tool.centre_at(&l.contact, &l.normal, &axis, None).unwrap();
                let margin_mm = world::least_margin(&mesh, &tool, (0.3, 1.0), cone, &centre, theta);
                if left.iter().any(|f| f.theta_min - 1e-12 <= theta && theta <= f.theta_max + 1e-12) {
                    prop_assert!(margin_mm > -1e-6, "declared free at {theta}: {margin_mm} mm");
                    continue;
                }
                let disc = tool.disc(centre, axis);
                let corners = (0..mesh.triangles.len()).map(|t| mesh.corners(t));
                let disc_mm = corners.map(|c| disc.nearest_of_triangle(&c).1).fold(f64::INFINITY, f64::min);
                prop_assert!(
                    margin_mm < 0.11 || disc_mm < corner_mm + 0.3 + 0.01,
                    "declared taken at {theta}: {margin_mm} mm, the disc {disc_mm} mm"
                );
            }
        }
    }
}
