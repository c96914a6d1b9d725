//! Every stage on models/prism.step against its closed form: a stadium (60 × 20, straight sides of
//! 40)
//! standing on a platform with a fillet of R 6, cut with a ball of R 4 above the fillet.

use std::f64::consts::{PI, TAU};

use bladewright::artifact::region::Extent;
use bladewright::artifact::schedule::ScheduleKind;
use bladewright::artifact::toolpath::PathKind;
use bladewright::artifact::{Blade, Channel, Plan, Schedule, Toolpath};
use bladewright::channel::{self, ChannelOptions};
use bladewright::feed::{self, FeedOptions};
use bladewright::geometry::Point;
use bladewright::machine::Machine;
use bladewright::observe::Silent;
use bladewright::path::{self, PathOptions};
use bladewright::read::model::{self, ModelOptions};
use bladewright::schedule::{self, ScheduleOptions};
use bladewright::section::{self, SectionOptions};
use bladewright::tool::{HolderStage, Tool};
use bladewright::verify::{self, VerifyOptions};

/// Radius of the profile's ends and half the length of its straight sides, mm.
const END: f64 = 10.0;
const HALF_SIDE: f64 = 20.0;
/// Ball radius, scallop, heights of the region, feed.
const R: f64 = 4.0;
const SCALLOP: f64 = 0.01;
const REGION: [f64; 2] = [20.0, 14.0];
const FEED_MM_MIN: f64 = 2000.0;

fn blade(file: &str) -> Blade {
    let path = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("models").join(file);
    model::load(&path, &ModelOptions::default(), &Silent).expect("the model loads")
}

fn tool() -> Tool {
    let holder = vec![HolderStage { radius_mm: 12.0, length_mm: 40.0 }];
    Tool { radius_mm: R, corner_radius_mm: None, taper_deg: 4.0, shank_radius_mm: 6.0, stickout_mm: 60.0, holder }
}

fn toolpath(blade: &Blade) -> Toolpath {
    let options =
        PathOptions { extent: Extent::heights(Some(REGION[0]), Some(REGION[1])), ..PathOptions::new(R, SCALLOP) }
            .with(|s| s.kind = PathKind::ConstantHeight);
    path::plan(blade, &options, &Silent).expect("a helix")
}

/// Distance to the prism's profile and the direction away from it, in the plane of the model's X
/// and Y.
fn from_profile(p: &Point) -> (f64, [f64; 2]) {
    let (dx, dy) = (p.x - p.x.clamp(-HALF_SIDE, HALF_SIDE), p.y);
    let r = dx.hypot(dy);
    (r - END, [dx / r, dy / r])
}

/// Length of a curve that keeps `off` from the profile.
fn perimeter(off: f64) -> f64 {
    4.0 * HALF_SIDE + TAU * (END + off)
}

#[test]
fn model_is_the_design() {
    let b = blade("prism.step");
    // Blade 80 high on a platform with its top at z = 0; the axis is +Z.
    assert_eq!(b.regions.part_x_mm.map(|x| x.round()), [-50.0, 80.0]);
    let axis = b.model_from_blade * nalgebra::Vector3::x();
    assert!((axis - nalgebra::Vector3::z()).norm() < 1e-9, "{axis}");
    let platform = b.regions.platform_x_mm().expect("a platform");
    assert!(platform.abs() < 0.05, "{platform}");
    // The fillet ends 6 over the platform.
    assert!((-0.1..6.5).contains(&b.regions.airfoil_x_mm()[0]), "{:?}", b.regions.airfoil_x_mm());
    assert!((b.regions.airfoil_x_mm()[1] - 80.0).abs() < 0.05);
    for (x, y, z) in [(7.0, 25.0, 40.0), (41.0, 3.0, 30.0), (-33.0, -20.0, 55.0), (0.0, -10.5, 70.0)] {
        let q = b.model_from_blade.inverse() * Point::new(x, y, z);
        let (expected, _) = from_profile(&Point::new(x, y, z));
        let found = b.part.closest(&q, f64::INFINITY).expect("a closest point");
        assert!((found.distance_mm - expected).abs() < 1e-6, "{} {expected}", found.distance_mm);
    }
}

#[test]
fn sections_are_the_profile() {
    let options = SectionOptions { heights_mm: vec![20.0, 50.0], ..SectionOptions::default() };
    let sections = section::plan(&blade("prism.step"), &options, &Silent).expect("sections");
    for s in &sections {
        let l = &s.loops[0];
        let area = 4.0 * HALF_SIDE * END + PI * END * END;
        // Points are on the profile; the chords between them are inside by their sagitta.
        assert!((l.length_mm - perimeter(0.0)).abs() < 2e-3 * perimeter(0.0), "{}", l.length_mm);
        assert!((l.area_mm2 - area).abs() < 2e-3 * area, "{}", l.area_mm2);
        assert!((l.chord_mm - 60.0).abs() < 0.01 && (l.thickness_mm - 20.0).abs() < 0.01);
        assert!(l.altered_points.is_empty(), "a convex profile has none: {:?}", l.altered_points);
        let at = |s_mm: f64| l.points_mm[l.s_mm.partition_point(|s| *s < s_mm).min(l.points_mm.len() - 1)];
        let extent = |p: [f64; 2]| p[0].hypot(p[1]);
        for edge in [l.leading_edge_s_mm, l.trailing_edge_s_mm] {
            assert!((extent(at(edge)) - 30.0).abs() < 1.0, "{:?}", at(edge));
        }
    }
}

#[test]
fn cutter_locations_are_on_the_offset_at_the_pitch_of_the_scallop() {
    let b = blade("prism.step");
    let path = toolpath(&b);
    let turns = path.turns.len();
    for l in &path.locations {
        let centre = b.model_from_blade * l.centre;
        let (distance, away) = from_profile(&centre);
        assert!((distance - R).abs() < 2e-6, "{distance}");
        let normal = b.model_from_blade * l.normal;
        assert!((normal.x - away[0]).abs() < 1e-5 && (normal.y - away[1]).abs() < 1e-5 && normal.z.abs() < 1e-5);
        assert!(((b.model_from_blade * l.contact) - (centre - normal * R)).norm() < 1e-5);
    }
    // Straight rulings along the axis: two balls a pitch p apart leave R − √(R² − p²/4), whatever
    // the profile.
    let x_of = |k: usize| path.locations[path.turns[k].first].centre.x;
    let pitches: Vec<f64> = (1..turns).map(|k| x_of(k - 1) - x_of(k)).collect();
    let widest = pitches.iter().fold(0.0, |a: f64, b| a.max(*b));
    let ridge = R - (R * R - 0.25 * widest * widest).sqrt();
    assert!((path.planned_scallop_mm - ridge).abs() < 0.02 * ridge, "{} {ridge}", path.planned_scallop_mm);
    assert!(ridge <= SCALLOP && ridge > 0.9 * SCALLOP, "{ridge}");
    // All turns but the last, which ends the region, have the same pitch; each is a helix on the
    // offset.
    for (k, pitch) in pitches.iter().enumerate().take(turns - 2) {
        assert!((pitch - widest).abs() < 0.03 * widest, "{pitches:?}");
        let length = perimeter(R).hypot(*pitch);
        assert!((path.turns[k].length_mm - length).abs() < 1e-4 * length, "{} {length}", path.turns[k].length_mm);
    }
    assert!((path.region_x_mm[0] - REGION[0]).abs() < 1e-6 && (path.region_x_mm[1] - REGION[1]).abs() < 1e-6);
}

/// The mesh gives the same path within its tolerance: both helices begin at the same height and
/// base point, keep the same pitch, and are R from the profile.
#[test]
fn mesh_gives_the_path_of_the_step() {
    let (exact, mesh) = (blade("prism.step"), blade("prism.obj"));
    let (a, b) = (toolpath(&exact), toolpath(&mesh));
    assert!((a.turns.len() as i64 - b.turns.len() as i64).abs() <= 1, "{} {}", a.turns.len(), b.turns.len());
    for l in &b.locations {
        let (distance, _) = from_profile(&(mesh.model_from_blade * l.centre));
        // Vertices on the profile, facets inside by at most the deflection of the model's file,
        // 0.01 mm.
        assert!((R - 0.0101..=R + 2e-6).contains(&distance), "{distance}");
    }
}

/// What a wall leaves: the cone's rim clears it by R (1 − cos(τ + φ)), φ being the axis' elevation
/// over the wall.
#[test]
fn channel_beside_a_straight_side() {
    let b = blade("prism.step");
    let path = toolpath(&b);
    let (tool, options) = (tool(), ChannelOptions::default());
    let channel = channel::plan(&b, &tool, &path, &options, &Silent).expect("a channel");
    let tau = tool.taper_deg.to_radians();
    let half_width = |clearance: f64| {
        let elevation = (1.0 - clearance / R).acos() - tau;
        (elevation.sin() / path.cone(0).lean_rad.cos()).acos()
    };
    // The clearance is kept from the mesh, which is within its deflection of the part.
    let (least, most) =
        (half_width(options.settings.clearance_mm + b.part.deflection_mm), half_width(options.settings.clearance_mm));
    let slack = options.settings.tolerance_deg.to_radians() + 1e-6;
    let mut seen = 0;
    for (l, row) in path.locations.iter().zip(&channel.rows) {
        let centre = b.model_from_blade * l.centre;
        // Between places where the angles are worked out, walls are taken from both neighbours:
        // stay off the ends.
        if centre.x.abs() > HALF_SIDE - 3.0 {
            continue;
        }
        seen += 1;
        let azimuth = l.normal.z.atan2(l.normal.y);
        let wrap = |x: f64| x - TAU * (x / TAU).round();
        for side in [wrap(azimuth - row.theta_min), wrap(row.theta_max - azimuth)] {
            assert!(side >= least - slack && side <= most + slack, "{side} not in {least}..{most} at {centre}");
        }
        assert!(row.hull_min <= row.hull_max);
    }
    assert!(seen > 100);
}

fn planned(kind: ScheduleKind, path: &Toolpath, channel: &Channel) -> Schedule {
    schedule::plan(kind, path, channel, &ScheduleOptions::default(), &Silent).expect("a schedule")
}

/// A straight line fits into the channel of a stadium; the fixed lead turns at 1/(r + R) round the
/// ends and not at all on the sides.
#[test]
fn schedule_feed_and_checks() {
    let b = blade("prism.step");
    let path = toolpath(&b);
    let (tool, machine) = (tool(), Machine::demo().expect("the demo machine"));
    let options = ChannelOptions::default();
    let channel = channel::plan(&b, &tool, &path, &options, &Silent).expect("a channel");
    let (used, fixed) =
        (planned(ScheduleKind::Piecewise, &path, &channel), planned(ScheduleKind::Fixed, &path, &channel));
    let length = path.locations.last().expect("locations").s_mm;
    let turned = used.theta[used.theta.len() - 1] - used.theta[0];
    assert_eq!((used.reversals, used.key_points.len(), used.pieces.len()), (0, 2, 1));
    assert!(used.peak_acceleration < 1e-12 && (used.peak_rate - turned / length).abs() < 1e-12);
    let steepest = 1.0 / (END + R);
    let rows = path.locations.windows(2).zip(fixed.theta.windows(2));
    let quotient = rows.map(|(l, t)| ((t[1] - t[0]) / (l[1].s_mm - l[0].s_mm)).abs()).fold(0.0, f64::max);
    assert!((quotient - steepest).abs() < 0.02 * steepest, "{quotient} {steepest}");
    // The rate jumps where a side meets an end; the smooth curve through the same angles swings
    // over there.
    assert!((steepest..1.1 * steepest).contains(&fixed.peak_rate), "{} {steepest}", fixed.peak_rate);
    assert!(used.peak_rate < 0.75 * fixed.peak_rate);

    let feed_options = FeedOptions::new(FEED_MM_MIN, tool.length_mm());
    let motion = feed::plan(&path, &used, &machine, &feed_options, &Silent).expect("a motion");
    let full = FEED_MM_MIN / 60.0;
    // From rest and to rest again; no limit binds in between. A is the slowest axis to come up:
    // with limits a and j of acceleration and jerk it takes v/a + a/j to the speed v, half of which
    // is lost at either end.
    let limits = machine.axes()[machine.turning_axis()].limits;
    let speed = turned / length * full;
    let lost = speed / limits.acceleration + limits.acceleration / limits.jerk;
    let from_rest = motion.time_s - length / full;
    assert!(from_rest > 0.999 * lost && from_rest < 1.03 * lost && from_rest < 0.2, "{from_rest} {lost}");
    let n = path.locations.len();
    for i in n / 10..n - n / 10 {
        assert!((motion.feed[i] / full - 1.0).abs() < 1e-9, "{i}: {} {full}", motion.feed[i]);
        assert!((motion.velocity[i][3].abs() - full * used.peak_rate).abs() < 1e-3 * full * used.peak_rate);
    }
    for (i, l) in path.locations.iter().enumerate() {
        let pose = machine.forward(&motion.position[i], tool.length_mm());
        assert!((pose.centre - l.centre).norm() < 1e-9);
        assert!((pose.axis - path.cone(i).tool_axis(used.theta[i])).norm() < 1e-12);
    }

    let plan = Plan { toolpath: path.clone(), channel, schedule: used, motion, leads: Default::default(), curve: None };
    let limits = VerifyOptions { scallop_mm: SCALLOP, ..VerifyOptions::default() }.with(|s| s.surface_samples = 30_000);
    let verdict = verify::check(plan, &b, &tool, &machine, &limits, &Silent).expect("a verdict");
    let report = verdict.report();
    let failed: Vec<_> = report.checks.iter().filter(|c| !c.passed).collect();
    assert!(report.passed(), "{failed:?}");
    // The greatest ridge is the one planned, and no gouge is deeper than the chord's sagitta.
    assert!(report.gouge_mm <= path.chord_mm + 1e-6, "{}", report.gouge_mm);
    assert!((report.ridge_p99_mm - path.planned_scallop_mm).abs() < 0.05 * SCALLOP, "{}", report.ridge_p99_mm);
    assert!(report.clearance_mm >= limits.clearance_mm, "{}", report.clearance_mm);
}
