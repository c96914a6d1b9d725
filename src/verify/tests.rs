//! Faults of known size are planted into a plan with closed-form answers; each must be found,
//! measured and placed.
#![allow(clippy::unwrap_used)]

use std::f64::consts::{PI, TAU};

use super::*;
use crate::artifact::blade::{Diagnosis, Unit};
use crate::artifact::channel::{Binding, Channel, ChannelRow};
use crate::artifact::region::Regions;
use crate::artifact::report::Check;
use crate::artifact::schedule::{Schedule, ScheduleKind};
use crate::artifact::toolpath::{CutterLocation, Toolpath, Turn};
use crate::artifact::{AxisMotion, AxisRows, Cones, Plan, Stand};
use crate::error::EndReason;
use crate::geometry::mesh::Mesh;
use crate::geometry::part::Part;
use crate::geometry::{Point, Rigid, Vector};
use crate::observe::Silent;
use crate::tool::{self, HolderStage};

const PART_RADIUS: f64 = 20.0;
const BALL: f64 = 8.0;
const PITCH: f64 = 0.8;
const B: f64 = 5.0 * PI / 180.0;

/// A closed cylinder about x from −60 to 60 mm.
fn cylinder() -> Mesh {
    let (n, layers) = (720u32, 16u32);
    let mut mesh = Mesh::default();
    for l in 0..=layers {
        let x = -60.0 + 120.0 * f64::from(l) / f64::from(layers);
        mesh.points.extend((0..n).map(|k| {
            let (s, c) = (TAU * f64::from(k) / f64::from(n)).sin_cos();
            Point::new(x, PART_RADIUS * c, PART_RADIUS * s)
        }));
    }
    let top = layers * n;
    mesh.points.extend([Point::new(-60.0, 0.0, 0.0), Point::new(60.0, 0.0, 0.0)]);
    for k in 0..n {
        let l = (k + 1) % n;
        for at in (0..layers).map(|j| j * n) {
            mesh.triangles.extend([[at + k, at + l, at + n + l], [at + k, at + n + l, at + n + k]]);
        }
        mesh.triangles.extend([[top + n, l, k], [top + n + 1, top + k, top + l]]);
    }
    mesh
}

fn blade(mesh: Mesh, model_from_blade: Rigid) -> Blade {
    Blade {
        name: "cylinder".into(),
        unit: Unit::Mm,
        part: Part::from_mesh(mesh),
        model_from_blade,
        regions: Regions::at_heights([-60.0, 60.0], [-60.0, 60.0], None),
        wheel: None,
        diagnosis: Diagnosis { closed: true, ..Diagnosis::default() },
    }
}

fn tool() -> Tool {
    Tool {
        radius_mm: BALL,
        corner_radius_mm: None,
        taper_deg: 0.0,
        shank_radius_mm: BALL,
        stickout_mm: 60.0,
        holder: vec![HolderStage { radius_mm: 25.0, length_mm: 50.0 }],
    }
}

/// A helix of `turns` turns with `per_turn` rows each on the cylinder; the ball centre's height at
/// angle φ is `x(φ)`; θ leads the normal by `lead`.
fn plan(turns: usize, per_turn: usize, lead: f64, x: impl Fn(f64) -> f64) -> Plan {
    let n = turns * per_turn;
    let angle = |i: usize| TAU * i as f64 / per_turn as f64;
    let normal = |i: usize| Vector::new(0.0, angle(i).cos(), angle(i).sin());
    let centre = |i: usize| Point::new(x(angle(i)), 0.0, 0.0) + normal(i) * (PART_RADIUS + BALL);
    let mut s = vec![0.0];
    for i in 1..n {
        s.push(s[i - 1] + (centre(i) - centre(i - 1)).norm());
    }
    let locations = (0..n).map(|i| CutterLocation {
        turn: (i / per_turn) as u32,
        turn_s_mm: s[i] - s[i / per_turn * per_turn],
        s_mm: s[i],
        centre: centre(i),
        contact: centre(i) - normal(i) * BALL,
        normal: normal(i),
    });
    let theta: Vec<f64> = (0..n).map(|i| angle(i) + lead).collect();
    let row = |t: &f64| ChannelRow {
        theta_min: t - 0.1,
        theta_max: t + 0.1,
        hull_min: t - 0.1,
        hull_max: t + 0.1,
        tangent_min: t - 0.1,
        tangent_max: t + 0.1,
        binds_min: Binding::ContactAngle,
        binds_max: Binding::Free,
    };
    let zeros: AxisRows = vec![[0.0; 5]; n].into_iter().collect();
    with_motion(Plan {
        curve: None,
        leads: Default::default(),
        toolpath: Toolpath {
            kind: crate::artifact::toolpath::PathKind::default(),
            stock_mm: 0.0,
            radius_mm: BALL,
            disc_radius_mm: 0.0,
            scallop_mm: 0.01,
            chord_mm: 0.001,
            region_x_mm: [x(0.0), x(angle(n - 1))],
            planned_scallop_mm: 0.01,
            end_reason: EndReason::Region,
            cones: Cones::about_blade(B),
            axis_turning: None,
            turns: (0..turns)
                .map(|k| Turn { first: k * per_turn, count: per_turn, length_mm: TAU * (PART_RADIUS + BALL) })
                .collect(),
            locations: locations.collect(),
        },
        channel: Channel {
            tolerance_rad: 1e-4,
            rows: theta.iter().map(row).collect(),
            narrowest_row: 0,
            chains: 1,
            proven_at: Vec::new(),
            sweep: Default::default(),
        },
        schedule: Schedule {
            kind: ScheduleKind::Fixed,
            theta,
            pieces: vec![],
            key_points: vec![],
            reversals: 0,
            peak_rate: 0.0,
            peak_acceleration: 0.0,
            quality: crate::artifact::schedule::Quality::default(),
            rates: Vec::new(),
            spread: 1.0,
        },
        motion: AxisMotion {
            t_s: s.iter().map(|s| s / 30.0).collect(),
            position: zeros.clone(),
            velocity: zeros.clone(),
            acceleration: zeros.clone(),
            jerk: zeros,
            feed: vec![30.0; n],
            time_s: s[n - 1] / 30.0,
        },
    })
}

fn machine() -> Machine {
    Machine::demo().unwrap()
}

/// Axis positions of the plan as it is, at 30 mm/s, with its times.
fn with_motion(mut plan: Plan) -> Plan {
    let (gauge, machine) = (tool().length_mm(), machine());
    let rows = plan.toolpath.locations.iter().zip(&plan.schedule.theta);
    plan.motion.position = rows.map(|(l, t)| machine.inverse(&l.centre, *t, B, gauge)).collect();
    plan
}

fn helix(phi: f64) -> f64 {
    -PITCH * phi / TAU
}

fn options() -> VerifyOptions {
    VerifyOptions::default().with(|s| s.surface_samples = 20_000)
}

fn run(plan: Plan, blade: &Blade, options: &VerifyOptions) -> Verdict<Plan> {
    check(plan, blade, &tool(), &machine(), options, &Silent).unwrap()
}

fn find<'a>(report: &'a CheckReport, name: &str) -> &'a Check {
    report.checks.iter().find(|c| c.id == name.parse().unwrap()).unwrap()
}

/// The same plan a hundred times slower, so that no axis meets its limits.
fn slowly(mut plan: Plan) -> Plan {
    plan.motion.t_s.iter_mut().for_each(|t| *t *= 100.0);
    plan
}

fn failed(report: &CheckReport) -> Vec<String> {
    report.checks.iter().filter(|c| !c.passed).map(|c| c.id.to_string()).collect()
}

#[test]
fn a_clean_plan_passes_with_the_closed_form_figures() {
    let verdict = run(plan(5, 720, 0.0, helix), &blade(cylinder(), Rigid::identity()), &options());
    let report = verdict.report();
    assert_eq!(failed(report), Vec::<String>::new(), "{report:#?}");
    let h = |x: f64| BALL - (BALL * BALL - x * x).sqrt();
    let ridge = h(PITCH / 2.0);
    assert!((report.ridge_max_mm - ridge).abs() < 2e-5 && (report.ridge_p05_mm - ridge).abs() < 2e-5 * 20.0);
    for (q, got) in [
        (0.05, report.scallop_p05_mm),
        (0.5, report.scallop_p50_mm),
        (0.95, report.scallop_p95_mm),
        (0.99, report.scallop_p99_mm),
        (1.0, report.scallop_max_mm),
    ] {
        let expected = h(q * PITCH / 2.0);
        // Chord of the path and of the facets, and the samples' own spread.
        assert!((got - expected).abs() < 0.0004 + 0.01 * ridge, "{q}: {got} {expected}");
    }
    assert!(report.scallop_samples > 1000);
    // Sag of the straight moves.
    let sag = (PART_RADIUS + BALL) * (1.0 - (PI / 720.0).cos());
    let gouge = find(report, "gouge").worst;
    assert!(gouge >= sag - 1e-6 && gouge <= sag + 0.0005, "{gouge} {sag}");
    assert_eq!(report.gouge_mm, gouge);
    // The ball's equator, tilted by B, on the side of the part.
    let clear = BALL - BALL * B.sin();
    // What is reported is what was proven: a fiftieth less than what was measured.
    assert!((report.clearance_mm - 0.98 * clear).abs() < 0.02 * clear, "{} {clear}", report.clearance_mm);
    let Verdict::Passed(v) = verdict else { panic!("not passed") };
    assert!(!v.forced());
}

#[test]
fn a_gouge_of_five_micrometres_is_found_and_placed() {
    let mut p = plan(3, 360, 0.0, helix);
    let l = &mut p.toolpath.locations[500];
    l.centre -= l.normal * 0.005;
    let contact = l.contact;
    p = with_motion(p);
    let turned = Rigid::new(Vector::new(1.0, 2.0, 3.0), Vector::new(0.3, -0.4, 0.5));
    let verdict = run(p.clone(), &blade(cylinder(), turned), &options());
    let gouge = find(verdict.report(), "gouge");
    assert!(!gouge.passed && (0.0049..0.0056).contains(&gouge.worst), "{gouge:?}");
    assert!((499..=500).contains(&gouge.row.unwrap()) && gouge.turn == Some(1));
    assert!((Point::from(gouge.point_mm.unwrap()) - turned * contact).norm() < 0.2);
    let Verdict::Failed(rejected) = verdict else { panic!("passed") };
    assert_eq!(rejected.value(), &p);
    assert!(rejected.write_anyway().forced());
}

#[test]
fn a_path_inside_the_part_is_a_gouge() {
    let mut p = plan(3, 180, 0.0, helix);
    for l in &mut p.toolpath.locations {
        l.centre = Point::new(l.centre.x, l.centre.y * 0.1, l.centre.z * 0.1);
    }
    let verdict = run(p, &blade(cylinder(), Rigid::identity()), &options());
    let gouge = find(verdict.report(), "gouge");
    assert!(!gouge.passed && gouge.worst > 20.0, "{gouge:?}");
}

#[test]
fn a_scallop_twice_too_high_is_found() {
    let wide = |phi: f64| {
        let over = ((phi - 2.0 * TAU) / TAU).clamp(0.0, 1.0);
        helix(phi) - over * PITCH * (2f64.sqrt() - 1.0)
    };
    let verdict =
        run(plan(6, 360, 0.0, wide), &blade(cylinder(), Rigid::identity()), &options().with(|s| s.gouge_mm = 0.01));
    let report = verdict.report();
    assert_eq!(failed(report), ["scallop"]);
    assert!((report.ridge_max_mm - 0.02).abs() < 0.0003, "{}", report.ridge_max_mm);
    // The straight moves sag by a micrometre.
    assert!((report.scallop_max_mm - 0.02).abs() < 0.0013, "{}", report.scallop_max_mm);
}

/// A cylinder with a spike whose tip the holder's side passes at a distance halfway between two
/// rows, near the holder's upper end; and that tip.
fn with_spike(p: &Plan, row: usize, distance_mm: f64) -> (Blade, Point) {
    let l = |i: usize| p.toolpath.locations[i].centre;
    let (centre, theta) =
        (l(row) + (l(row + 1) - l(row)) * 0.5, 0.5 * (p.schedule.theta[row] + p.schedule.theta[row + 1]));
    let a = tool::axis(B, theta);
    let out = (Vector::x() - a * a.x).normalize();
    let across = a.cross(&out);
    let tip = centre + a * 105.0 + out * (25.0 + distance_mm);
    let mut mesh = cylinder();
    let n = mesh.points.len() as u32;
    mesh.points.extend([tip, tip + out * 5.0 + across * 0.1, tip + out * 5.0 - across * 0.1]);
    mesh.triangles.push([n, n + 1, n + 2]);
    mesh.face_of = vec![0; mesh.triangles.len() - 1];
    mesh.face_of.push(7);
    (blade(mesh, Rigid::identity()), tip)
}

/// What planning takes for clear between locations passes its check, however near to the limit.
#[test]
fn moves_that_planning_leaves_pass_the_check() {
    let (p, row) = (plan(3, 180, 0.2, helix), 100);
    let options = options().with(|s| s.gouge_mm = 0.01);
    let mut seen = [0, 0];
    for k in -8..=8 {
        // The limit is 0.99.
        let (blade, _) = with_spike(&p, row, 0.99 + 0.0004 * f64::from(k));
        let tool = tool();
        let apart = apart(&blade, &[], &tool, &options);
        let short = short_moves(&p.toolpath, &p.schedule.theta, &apart, &options);
        let (checks, _) = clearance::check(&p, &blade, &apart, &options);
        let passed = checks.iter().all(|c| c.passed);
        assert!(passed || short == [row], "{k}: {short:?}, {checks:#?}");
        seen[usize::from(passed)] += 1;
        // Nor are walls moved in for what is farther off by twice what is resolved.
        assert!(k < 5 || short.is_empty(), "{k}");
    }
    assert!(seen[0] > 3 && seen[1] > 3, "{seen:?}");
}

#[test]
fn a_holder_touch_of_twenty_micrometres_between_two_rows_is_found() {
    let p = plan(3, 180, 0.2, helix);
    let row = 100;
    let (blade, tip) = with_spike(&p, row, -0.02);
    let report = run(p.clone(), &blade, &options().with(|s| s.gouge_mm = 0.01)).report().clone();
    assert_eq!(failed(&report), ["holder-clearance"]);
    let touch = find(&report, "holder-clearance");
    assert!((touch.worst + 0.02).abs() < 0.006, "{touch:?}");
    assert_eq!((touch.row, touch.turn), (Some(row), Some(0)));
    assert!((Point::from(touch.point_mm.unwrap()) - tip).norm() < 0.01);
    assert!(touch.note.contains("holder 1") && touch.note.contains("group 8"), "{}", touch.note);
    // At the rows themselves the holder is clear: a check of rows alone would miss it.
    let [_, holder] = tool().cutter_and_holder();
    for i in [row, row + 1] {
        let stands = [p.stand(i).unwrap(); 2];
        let still = clearance::Track { stands: &stands, wanted: None };
        assert!(clearance::measure_track(still, &blade.part, &holder, clearance::usual(0.001)).1 > 0.005);
    }
}

#[test]
fn a_reversed_theta_and_one_outside_the_channel_are_found() {
    let mut p = plan(3, 180, 0.0, helix);
    p.schedule.theta.swap(77, 78);
    let report = run(p, &blade(cylinder(), Rigid::identity()), &options().with(|s| s.gouge_mm = 0.01)).report().clone();
    // The axes still do what was planned, so they contradict the changed angles as well.
    assert_eq!(failed(&report), ["theta-reversal", "axes-direction"]);
    let check = find(&report, "theta-reversal");
    assert!((check.worst - 2.0).abs() < 1e-9 && check.row == Some(78), "{check:?}");

    let mut p = plan(3, 180, 0.0, helix);
    p.channel.rows[100].theta_max = p.schedule.theta[100] - 0.25f64.to_radians();
    let report = run(p, &blade(cylinder(), Rigid::identity()), &options().with(|s| s.gouge_mm = 0.01)).report().clone();
    assert_eq!(failed(&report), ["theta-channel"]);
    let check = find(&report, "theta-channel");
    assert!((check.worst - 0.25).abs() < 1e-9 && check.row == Some(100), "{check:?}");
}

#[test]
fn axis_limits_exceeded_are_found_and_placed() {
    let blade = blade(cylinder(), Rigid::identity());
    let limits = options().with(|s| s.gouge_mm = 0.01);
    let clean = plan(3, 180, 0.0, helix);
    assert_eq!(failed(run(clean.clone(), &blade, &limits).report()), Vec::<String>::new());
    // One interval in a fifth of its time: A turns five times as fast, and jumps to it and back.
    let mut p = clean.clone();
    let step = p.motion.t_s[301] - p.motion.t_s[300];
    p.motion.t_s[301..].iter_mut().for_each(|t| *t -= 0.8 * step);
    let report = run(p.clone(), &blade, &limits).report().clone();
    assert_eq!(failed(&report), ["a-velocity", "a-acceleration"]);
    let v = find(&report, "a-velocity");
    let expected = 2.0 / (0.2 * step);
    assert!((v.worst - expected).abs() < 1e-6 * expected && v.row == Some(300) && v.limit == 180.0, "{v:?}");
    assert!((300..=301).contains(&find(&report, "a-acceleration").row.unwrap()));
    // Velocity columns are not trusted.
    p.motion = clean.motion.clone();
    p.motion.velocity = vec![[1e9; 5]; p.motion.velocity.len()].into_iter().collect();
    assert_eq!(failed(run(p, &blade, &limits).report()), Vec::<String>::new());
    // Far outside the stroke of X, and not where the plan says.
    let mut p = clean.clone();
    for q in p.motion.position.iter_mut() {
        q[0] += 2000.0;
    }
    let report = run(p, &blade, &limits).report().clone();
    assert_eq!(failed(&report), ["x-travel", "axes-centre"]);
    assert!((find(&report, "axes-centre").worst - 2000.0).abs() < 1e-6);
    let mut p = clean;
    p.motion.position[40][3] += 1e-4;
    let report = run(slowly(p), &blade, &limits).report().clone();
    assert_eq!(failed(&report), ["axes-centre", "axes-direction"]);
    assert_eq!(find(&report, "axes-direction").row, Some(40));
    let mut p = plan(3, 180, 0.0, helix);
    p.motion.t_s[9] = p.motion.t_s[8];
    assert!(failed(run(p, &blade, &limits).report()).contains(&"time".to_owned()));
}

#[test]
fn plans_that_are_none_are_refused() {
    let blade = blade(cylinder(), Rigid::identity());
    let mut short = plan(3, 180, 0.0, helix);
    short.schedule.theta.pop();
    let mut nan = plan(3, 180, 0.0, helix);
    nan.toolpath.locations[5].centre.y = f64::NAN;
    let mut empty = plan(3, 180, 0.0, helix);
    empty.toolpath.locations.clear();
    let mut narrow = plan(3, 180, 0.0, helix);
    narrow.motion.jerk = narrow.motion.jerk.iter().map(|row| &row[..4]).collect();
    let bad = [
        (short, "schedule"),
        (nan, "location 5"),
        (empty, "0 cutter locations"),
        (narrow, "the machine has 5 axes, a row of the plan's motion has 4"),
    ];
    for (bad, word) in bad {
        let e = check(bad, &blade, &tool(), &machine(), &options(), &Silent).unwrap_err();
        assert!(e.message.contains(word), "{e}");
    }
}

#[test]
fn a_single_place_that_stands_out_is_told_of() {
    let warnings = |plan: Plan| {
        let seen = crate::observe::Recorder::new(&Silent);
        let part = blade(cylinder(), Rigid::identity());
        let verdict = check(plan, &part, &tool(), &machine(), &options(), &seen).unwrap();
        (failed(verdict.report()).join(" "), seen.warnings())
    };
    assert_eq!(warnings(plan(6, 720, 0.0, helix)), (String::new(), vec![]));
    let mut p = plan(6, 720, 0.0, helix);
    for l in &mut p.toolpath.locations[3 * 720 + 100..][..8] {
        l.centre += l.normal * 0.02;
    }
    let contact = p.toolpath.locations[3 * 720 + 104].contact;
    let (failed, warnings) = warnings(with_motion(p));
    // Eight locations of 720 of one turn of four: by the 99th percentile all is well.
    assert_eq!(failed, "");
    let [warning] = &warnings[..] else { panic!("{warnings:?}") };
    let said = &warning.doubt.to_string();
    assert!(said.contains("1.5 times the scallop") && said.contains("at turn "), "{said}");
    let numbers = |text: &str| -> Vec<f64> { text.split(", ").map(|x| x.parse().unwrap()).collect() };
    let at = numbers(said.split(['(', ')']).nth(1).unwrap());
    assert!((Point::new(at[0], at[1], at[2]) - contact).norm() < 1.5, "{said} {contact}");
}

#[test]
fn figures_do_not_depend_on_the_number_of_threads() {
    let blade = blade(cylinder(), Rigid::identity());
    let on = |threads: usize| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
        pool.install(|| run(plan(4, 180, 0.3, helix), &blade, &options()).report().clone())
    };
    assert_eq!(serde_json::to_string(&on(1)).unwrap(), serde_json::to_string(&on(3)).unwrap());
}

#[test]
fn a_standing_tool_is_as_far_from_a_plane_as_its_profile_says() {
    let segments = tool::Tool {
        radius_mm: BALL,
        corner_radius_mm: None,
        taper_deg: 0.0,
        shank_radius_mm: BALL,
        stickout_mm: 60.0,
        holder: vec![HolderStage { radius_mm: 20.0, length_mm: 30.0 }],
    }
    .segments();
    // A wall at x = 0, the tool parallel to it or leaning towards it.
    let mut wall = Mesh::default();
    wall.points.extend([[-300.0, -300.0], [300.0, -300.0], [0.0, 400.0]].map(|[y, z]| Point::new(0.0, y, z)));
    wall.triangles.push([0, 1, 2]);
    let part = Part::from_mesh(wall);
    for (x, b_deg) in [(30.0, 0.0), (21.5, 0.0), (19.0, 0.0), (60.0, -20.0), (40.0, -20.0)] {
        let b = f64::to_radians(b_deg);
        let lowest =
            |s: &tool::Segment| [(s.z0, s.r0), (s.z1, s.r1)].map(|(z, r)| x + z * b.sin() - r * b.cos()).into_iter();
        let exact = segments.iter().flat_map(lowest).fold(f64::INFINITY, f64::min);
        for theta in [0.0, 1.0, -2.5] {
            let found =
                standing(&part, &segments, &Stand::about_blade(Point::new(x, 0.0, 0.0), theta, b), 1e-4).unwrap();
            // What is reported of depths is not the way out along the wall: the nearest side may be
            // another.
            let (least, most) = if exact > 0.0 { (exact, exact * 1.02 + 1e-4) } else { (exact, 0.0) };
            assert!(found.distance_mm >= least - 1e-9 && found.distance_mm <= most, "{x} {b_deg}: {found:?}, {exact}");
            assert!(segments[found.segment].part.is_holder() && found.triangle == 0);
        }
    }
    assert_eq!(standing(&part, &segments, &Stand::about_blade(Point::new(2000.0, 0.0, 0.0), 0.0, 0.0), 1e-4), None);
}
