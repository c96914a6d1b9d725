#![allow(clippy::unwrap_used)]
use std::f64::consts::TAU;

use super::*;
use crate::artifact::channel::{Binding, ChannelRow};
use crate::artifact::schedule::ScheduleKind;
use crate::artifact::toolpath::{CutterLocation, PathKind, Turn};
use crate::artifact::{Cones, Toolpath};
use crate::error::EndReason;
use crate::geometry::exact::tests::can;
use crate::geometry::{Point, Vector};
use crate::numerics::quintic::weighed;
use crate::numerics::spline::{CubicSpline, SplineEnds};
use crate::observe::Silent;

const BALL: f64 = 2.0;
const CAN: f64 = 10.0;
const PITCH: f64 = 0.5;
const TURNS: u32 = 4;
const PER_TURN: u32 = 260;

fn part() -> Part {
    Part::from_brep(can(CAN, 40.0), 0.02, &Silent).unwrap()
}

/// Numbers between −1 and 1 in a fixed order.
fn noise(k: u32) -> f64 {
    f64::from(k.wrapping_mul(2_654_435_761).wrapping_add(0x9e37) >> 8) / f64::from(1u32 << 23) - 1.0
}

/// A helix of ball centres round a can, each moved along it by `across_mm` at most; its
/// angle about the can.
fn helix(across_mm: f64) -> (Toolpath, Vec<f64>) {
    let count = TURNS * PER_TURN;
    let mut locations: Vec<CutterLocation> = Vec::new();
    let mut angles = Vec::new();
    for k in 0..=count {
        let angle = TAU * f64::from(k) / f64::from(PER_TURN) + 2e-4 * noise(3 * k + 1);
        let normal = Vector::new(angle.cos(), angle.sin(), 0.0);
        let z = 20.0 - PITCH * angle / TAU + across_mm * noise(k);
        let axis = Point::new(0.0, 0.0, z);
        let centre = axis + normal * (CAN + BALL);
        let s_mm = locations.last().map_or(0.0, |l| l.s_mm + (centre - l.centre).norm());
        let turn = (k / PER_TURN).min(TURNS - 1);
        locations.push(CutterLocation { turn, turn_s_mm: 0.0, s_mm, centre, contact: axis + normal * CAN, normal });
        angles.push(angle);
    }
    let turn = |t: u32| {
        let first = (t * PER_TURN) as usize;
        Turn { first, count: PER_TURN as usize, length_mm: TAU * (CAN + BALL) }
    };
    let path = Toolpath {
        kind: PathKind::default(),
        radius_mm: BALL,
        disc_radius_mm: 0.0,
        stock_mm: 0.0,
        scallop_mm: 0.01,
        chord_mm: 0.001,
        region_x_mm: [0.0; 2],
        end_reason: EndReason::Region,
        planned_scallop_mm: 0.01,
        cones: Cones::about_blade(0.0),
        axis_turning: None,
        turns: (0..TURNS).map(turn).collect(),
        locations,
    };
    (path, angles)
}

/// A channel about those angles, and a schedule in it that rises unevenly.
fn turning(angles: &[f64]) -> (Channel, Schedule) {
    let row = |angle: &f64| ChannelRow {
        theta_min: angle - 0.4,
        theta_max: angle + 0.4,
        hull_min: angle - 0.4,
        hull_max: angle + 0.4,
        tangent_min: angle - 0.4,
        tangent_max: angle + 0.4,
        binds_min: Binding::Free,
        binds_max: Binding::Free,
    };
    let channel = Channel {
        tolerance_rad: 1e-6,
        rows: angles.iter().map(row).collect(),
        narrowest_row: 0,
        chains: 1,
        proven_at: Vec::new(),
        sweep: Default::default(),
    };
    let theta = angles.iter().map(|a| a + 0.3 * a.sin()).collect();
    (channel, Schedule { kind: ScheduleKind::Optimal, ..Schedule::of_angles(theta) })
}

fn smoothed(path: &Toolpath, angles: &[f64], options: &SmoothOptions) -> Result<Curve> {
    let (channel, schedule) = turning(angles);
    plan(&part(), path, &channel, &schedule, &Objective::Part, options, &Silent)
}

#[test]
fn noise_across_a_helix_goes_and_the_curve_stays_where_the_part_wants_it() {
    let (path, angles) = helix(1e-3);
    let options = SmoothOptions { bound_of_any: true, ..SmoothOptions::default() };
    let curve = smoothed(&path, &angles, &options).unwrap();
    assert!(curve.left.is_empty() && curve.stretches.len() == 1, "{:?}", curve.left);
    let c = &curve.stretches[0];
    assert!(2 * curve.pieces() < path.locations.len());
    assert_eq!(c.s_mm(), [0.0, path.locations.last().unwrap().s_mm]);
    let (channel, _) = turning(&angles);
    let (mut peak, mut last) = (0.0_f64, f64::NEG_INFINITY);
    for i in 0..c.pieces() {
        let [a, b] = c.breaks.span(i);
        for k in 0..20 {
            let s = a + (b - a) * f64::from(k) / 20.0;
            let place = c.at(s);
            let p = place.point();
            // The distance to the can in closed form.
            assert!((p.x.hypot(p.y) - CAN - BALL).abs() <= 0.25e-3 + 1e-9);
            let row = path.locations.partition_point(|l| l.s_mm <= s).clamp(1, angles.len() - 1);
            let near = &path.locations[row - 1];
            assert!((p.z - near.centre.z).abs() < 0.03 * PITCH + PITCH * 2.0 / f64::from(PER_TURN) + 2e-3);
            peak = peak.max(place.derivative(3).norm());
            assert!(place.theta[0] >= last && place.theta[1] >= -1e-9);
            last = place.theta[0];
            let wall = |of: fn(&ChannelRow) -> f64| {
                let share = (s - near.s_mm) / (path.locations[row].s_mm - near.s_mm);
                of(&channel.rows[row - 1]) * (1.0 - share) + of(&channel.rows[row]) * share
            };
            let [lo, hi] = [wall(|r| r.hull_min), wall(|r| r.hull_max)];
            assert!((lo - 1e-9..=hi + 1e-9).contains(&place.theta[0]));
        }
    }
    // A helix itself has 1/r² but for its slope; the spline through the locations has noise.
    let own = (CAN + BALL).powi(-2);
    assert!(peak < 1.5 * own, "{peak} {own}");
    let s: Vec<f64> = path.locations.iter().map(|l| l.s_mm).collect();
    let z: Vec<f64> = path.locations.iter().map(|l| l.centre.z).collect();
    let through = CubicSpline::new(&s, &z, 1, &SplineEnds::Natural).unwrap();
    let before = (9..s.len() - 10).map(|i| (6.0 * through.coefficients(i, 0).unwrap()[3]).abs()).fold(0.0, f64::max);
    assert!(peak < before / 20.0, "{peak} {before}");
    let p = c.proof;
    assert!(p.inwards_mm <= 0.25e-3 && p.outwards_mm <= 0.25e-3);
    assert!(p.square <= 1.005 * p.bound && p.theta_square <= 1.006 * p.theta_bound, "{p:?}");
    let any = p.bound_of_any.unwrap();
    assert!(any <= p.square && p.square < 1.1 * any, "{p:?}");
}

/// In the same room there are far fewer pieces, and the curve is within it everywhere.
#[test]
fn the_fewest_pieces_keep_within_the_tube() {
    let (path, angles) = helix(1e-3);
    let usual = SmoothOptions { inwards_mm: 0.5e-3, outwards_mm: 0.5e-3, ..SmoothOptions::default() };
    let smoothest = smoothed(&path, &angles, &usual).unwrap();
    let few = smoothed(&path, &angles, &SmoothOptions { aim: Aim::Fewest, ..usual }).unwrap();
    assert!(few.left.is_empty() && few.stretches.len() == 1, "{:?}", few.left);
    assert!(4 * few.pieces() < smoothest.pieces(), "{} {}", few.pieces(), smoothest.pieces());
    let c = &few.stretches[0];
    let bound = c.proof.pieces_bound.unwrap();
    assert!(bound > 4 && bound <= c.pieces(), "{bound} {}", c.pieces());
    assert!(smoothest.stretches[0].proof.pieces_bound.is_none());
    assert!(c.proof.inwards_mm <= 0.5e-3 && c.proof.outwards_mm <= 0.5e-3);
    let (mut last, end) = (f64::NEG_INFINITY, c.s_mm()[1]);
    for k in 0..=20_000 {
        let s = end * f64::from(k) / 20_000.0;
        let place = c.at(s);
        let p = place.point();
        assert!((p.x.hypot(p.y) - CAN - BALL).abs() <= 0.5e-3 + 1e-9);
        let row = path.locations.partition_point(|l| l.s_mm <= s).clamp(1, angles.len() - 1);
        let near = &path.locations[row - 1];
        assert!((p.z - near.centre.z).abs() < 0.03 * PITCH + PITCH * 2.0 / f64::from(PER_TURN) + 2e-3);
        assert!(place.theta[0] >= last);
        last = place.theta[0];
    }
}

/// Locations on one polynomial of degree 5, over the flat end of the can: one piece is found.
#[test]
fn one_polynomial_is_one_piece() {
    let place = |s: f64| {
        let t = s / 8.0 - 1.0;
        Point::new(s - 8.0, 2.0 * t.powi(5) - 1.5 * t.powi(3) + 0.3 * t, 40.0 + BALL)
    };
    let (mut path, _) = helix(0.0);
    path.locations.truncate(0);
    for k in 0..=320 {
        let (s_mm, centre) = (0.05 * f64::from(k), place(0.05 * f64::from(k)));
        let contact = centre - Vector::z() * BALL;
        path.locations.push(CutterLocation { turn: 0, turn_s_mm: s_mm, s_mm, centre, contact, normal: Vector::z() });
    }
    path.turns = vec![Turn { first: 0, count: path.locations.len(), length_mm: 16.0 }];
    let angles: Vec<f64> = path.locations.iter().map(|l| 0.1 * l.s_mm).collect();
    let few = smoothed(&path, &angles, &SmoothOptions { aim: Aim::Fewest, ..SmoothOptions::default() }).unwrap();
    assert_eq!((few.pieces(), few.stretches[0].proof.pieces_bound), (1, Some(1)), "{:?}", few.left);
    for k in 0..=100 {
        let s = 0.16 * f64::from(k);
        // Across as far as ridges let it, up to 12 µm.
        let off = few.stretches[0].at(s).point() - place(s);
        assert!(off.norm() < 0.02 && off.z.abs() <= 0.25e-3 + 1e-9, "{off}");
    }
}

/// Evening takes noise across the path down to a share, about a half of independent numbers, and
/// leaves the ball on the part.
#[test]
fn evened_touches_lie_on_the_part() {
    let (path, angles) = helix(2e-3);
    let even = evened(&part(), &path).unwrap();
    let off = |p: &Toolpath| {
        let z = |k: usize| p.locations[k].centre.z - 20.0 + PITCH * angles[k] / TAU;
        (2..angles.len() - 2).map(|k| z(k).powi(2)).sum::<f64>().sqrt()
    };
    assert!(off(&even) < 0.6 * off(&path) && off(&even) > 0.1 * off(&path), "{} {}", off(&even), off(&path));
    for l in &even.locations {
        assert!((l.centre.x.hypot(l.centre.y) - CAN - BALL).abs() < 1e-9);
    }
    assert!(even.locations.windows(2).all(|w| w[1].s_mm > w[0].s_mm));
    let mut bad = path.clone();
    bad.locations[7].centre.x = f64::NAN;
    assert_eq!(evened(&part(), &bad).unwrap_err().kind, crate::error::ErrorKind::Usage);
}

#[test]
fn the_same_on_any_number_of_threads() {
    let (path, angles) = helix(1e-3);
    for aim in [Aim::Smoothest, Aim::Fewest] {
        let on = |threads: usize| {
            let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
            pool.install(|| smoothed(&path, &angles, &SmoothOptions { aim, ..SmoothOptions::default() }).unwrap())
        };
        assert!(on(1) == on(3), "{aim:?}");
    }
}

#[test]
fn jerk_of_axes_can_be_least_instead() {
    let (path, angles) = helix(1e-3);
    let (channel, schedule) = turning(&angles);
    let machine = Machine::demo().unwrap();
    let objective = Objective::Axes { machine: &machine, gauge_length_mm: 100.0, lean_rad: 0.0 };
    let options = SmoothOptions::default();
    let of = |o: &Objective| plan(&part(), &path, &channel, &schedule, o, &options, &Silent).unwrap();
    // Half the integral of the square, differentiated on the machine's own positions.
    let square = |curve: &Curve| {
        let c = &curve.stretches[0];
        let mut sum = 0.0;
        for i in 0..c.pieces() {
            let [a, b] = c.breaks.span(i);
            let h = (b - a) / 6.0;
            let at = |k: usize| {
                let p = c.at(a + h * k as f64);
                machine.inverse(&p.point(), p.theta[0], 0.0, 100.0)
            };
            for k in 1..4 {
                for axis in machine.linear() {
                    let q = [k - 1, k, k + 1, k + 2].map(|k| at(k)[axis]);
                    let third = (q[3] - 3.0 * q[2] + 3.0 * q[1] - q[0]) / (h * h * h);
                    sum += 0.5 * third * third * 2.0 * h;
                }
            }
        }
        sum
    };
    let (on_part, on_axes) = (of(&Objective::Part), of(&objective));
    let proof = on_axes.stretches[0].proof;
    assert!(proof.square <= 1.005 * proof.bound);
    assert!((square(&on_axes) / proof.square - 1.0).abs() < 0.05, "{} {}", square(&on_axes), proof.square);
    assert!(square(&on_axes) <= 1.005 * square(&on_part));
}

#[test]
fn theta_goes_between_walls_seen_from_the_curve_and_the_ball_keeps_its_curve() {
    let (path, angles) = helix(1e-3);
    let (channel, schedule) = turning(&angles);
    let options = SmoothOptions::default();
    let curve = smoothed(&path, &angles, &options).unwrap();
    // The lower wall bulges by 0.01 rad over the schedule between two locations, the upper one by
    // as much below it between two others: more than θ may be from the schedule.
    let middle = |k: usize| 0.5 * (path.locations[k].s_mm + path.locations[k + 1].s_mm);
    let theta = |k: usize| 0.5 * (schedule.theta[k] + schedule.theta[k + 1]);
    let wall = |k: usize, least: f64, greatest: f64| SeenWall {
        s_mm: middle(k),
        theta_min: theta(k) + least,
        theta_max: theta(k) + greatest,
    };
    let walls = [wall(300, 0.01, 0.5), wall(700, -0.5, -0.01)];
    let is_within = |w: &SeenWall, c: &Curve| {
        let theta = c.stretch_at(w.s_mm).unwrap().at(w.s_mm).theta[0];
        (w.theta_min - 1e-8..=w.theta_max + 1e-8).contains(&theta)
    };
    assert!(walls.iter().all(|w| !is_within(w, &curve)));
    let shares = vec![Share::WHOLE; path.locations.len()];
    let near = Near { shares: &shares, like: None, walls: &walls };
    let again = turned_anew(&curve, &path, &channel, &schedule, &options, near).unwrap();
    let whole = plan_near(&part(), &path, &channel, &schedule, &Objective::Part, &options, near, &Silent).unwrap();
    for c in [&again, &whole] {
        assert!(c.left.is_empty() && c.stretches.len() == 1);
        assert!(walls.iter().all(|w| is_within(w, c)));
        let s = &c.stretches[0];
        let mut last = f64::NEG_INFINITY;
        for k in 0..=20_000 {
            let now = s.at(path.locations.last().unwrap().s_mm * f64::from(k) / 2e4).theta[0];
            assert!(now >= last - 1e-12, "{now} {last}");
            last = now;
        }
    }
    assert_eq!(again.stretches[0].centre, curve.stretches[0].centre);
    // Far from the walls θ is as before.
    let far = |c: &Curve| c.stretches[0].at(path.locations[100].s_mm).theta[0];
    assert!((far(&again) - far(&curve)).abs() < 1e-3, "{} {}", far(&again), far(&curve));
    // Walls that leave no θ which never falls: it stays.
    let walls = [wall(300, 0.2, 0.5), wall(301, -0.5, -0.2)];
    let near = Near { walls: &walls, ..near };
    assert_eq!(turned_anew(&curve, &path, &channel, &schedule, &options, near).unwrap(), curve);
    // A curve of another path has no location here: it stays.
    let mut other = curve.clone();
    let far = path.locations.last().unwrap().s_mm + 1.0;
    let breaks = other.stretches[0].breaks.all().iter().map(|s| s + far).collect();
    other.stretches[0].breaks = crate::numerics::quintic::Breaks::new(breaks).unwrap();
    assert_eq!(turned_anew(&other, &path, &channel, &schedule, &options, near).unwrap(), other);
    let back = [walls[1], walls[0]];
    let e = turned_anew(&curve, &path, &channel, &schedule, &options, Near { walls: &back, ..near }).unwrap_err();
    assert_eq!((e.kind, e.message.contains("order")), (crate::error::ErrorKind::Usage, true), "{e}");
}

#[test]
fn where_there_is_no_room_the_path_stays() {
    // A schedule that turns back over some locations: no θ that never falls is near to it.
    let (path, angles) = helix(1e-3);
    let (channel, mut schedule) = turning(&angles);
    for (k, theta) in schedule.theta.iter_mut().enumerate().skip(500) {
        *theta -= 0.08 * (k.min(540) - 500) as f64;
    }
    let curve =
        plan(&part(), &path, &channel, &schedule, &Objective::Part, &SmoothOptions::default(), &Silent).unwrap();
    assert!(!curve.left.is_empty() && curve.stretches.len() >= 2, "{:?}", curve.left);
    for left in &curve.left {
        let [from, to] = [path.locations[470].s_mm, path.locations[570].s_mm];
        assert!(left.s_mm[0] >= from && left.s_mm[1] <= to, "{left:?}");
    }
    for pair in curve.stretches.windows(2) {
        assert!(pair[0].s_mm()[1] <= pair[1].s_mm()[0]);
    }
    for c in &curve.stretches {
        assert!(c.proof.inwards_mm <= 0.25e-3 && c.proof.outwards_mm <= 0.25e-3);
    }
    let s = 0.5 * (path.locations[519].s_mm + path.locations[520].s_mm);
    assert!(curve.stretch_at(s).is_none() && curve.stretch_at(path.locations[100].s_mm).is_some());
}

#[test]
fn the_path_is_cut_at_creases() {
    let (mut path, angles) = helix(0.0);
    let turned = nalgebra::Rotation3::from_axis_angle(&Vector::z_axis(), 0.5);
    path.locations[400..].iter_mut().for_each(|l| l.normal = turned * l.normal);
    let cut = cut_at_creases(&path);
    let ranges: Vec<_> = cut.iter().map(|(r, _)| r.clone()).collect();
    assert_eq!(ranges, [0..400, 399..401, 400..path.locations.len()]);
    assert!((cut[1].1.unwrap() - 0.5).abs() < 0.05);
    // Beyond the crease normals are wrong, which the part itself shows.
    let curve = smoothed(&path, &angles, &SmoothOptions::default()).unwrap();
    assert!(curve.left.iter().any(|l| matches!(l.why, WhyLeft::Crease { .. })));
}

#[test]
fn bad_input_is_refused_in_words() {
    let (path, angles) = helix(0.0);
    let refused = |path: &Toolpath, angles: &[f64], options: &SmoothOptions, word: &str| {
        let e = smoothed(path, angles, options).unwrap_err();
        assert_eq!(e.kind, crate::error::ErrorKind::Usage);
        assert!(e.message.contains(word), "{}", e.message);
    };
    let usual = SmoothOptions::default();
    refused(&path, &angles, &SmoothOptions { across: f64::NAN, ..usual }, "across");
    refused(&path, &angles, &SmoothOptions { inwards_mm: 0.0, ..usual }, "inwards_mm");
    refused(&path, &angles[1..], &usual, "angles");
    let mut bad = path.clone();
    bad.locations[7].centre.x = f64::NAN;
    refused(&bad, &angles, &usual, "location 7");
    let mut bad = path.clone();
    bad.locations[9].s_mm = bad.locations[8].s_mm;
    refused(&bad, &angles, &usual, "location 9");
    let mut bad = path.clone();
    bad.radius_mm = 0.0;
    refused(&bad, &angles, &usual, "radius");
    let mut few = path.clone();
    few.locations.truncate(1);
    refused(&few, &angles[..1], &usual, "at least 2");
    few = path.clone();
    few.locations.truncate(5);
    few.turns.truncate(1);
    let curve = smoothed(&few, &angles[..5], &usual).unwrap();
    assert!(curve.stretches.is_empty() && curve.left[0].why == WhyLeft::Short);
}

#[test]
fn a_proof_holds_at_every_place() {
    let part = part();
    let part = Allowed::new(&part, 0.0);
    // Along the can, then over its rim, then away, with a dent.
    let breaks = crate::numerics::quintic::Breaks::new((0..=6).map(f64::from).collect()).unwrap();
    let x: Vec<[f64; 3]> = breaks
        .greville()
        .iter()
        .enumerate()
        .map(|(k, s)| [CAN + BALL + 2e-3 * noise(k as u32), 0.3 * s, 36.0 + s])
        .collect();
    for limits in [[0.25e-3; 2], [3e-3, 0.3]] {
        let proofs = prove::prove(&part, BALL, &breaks, &x, limits);
        for (i, proof) in proofs.iter().enumerate() {
            let [a, b] = breaks.span(i);
            let mut worst = [0.0_f64; 2];
            for k in 0..=500 {
                let s = a + (b - a) * f64::from(k) / 500.0;
                let p = Point::from(weighed(&x[i..], &breaks.weights(i, s)));
                let off = part.closest(&p, f64::INFINITY).unwrap().distance_mm - BALL;
                worst = [worst[0].max(-off), worst[1].max(off)];
            }
            assert!(proof.inwards_mm >= worst[0] - 1e-9 && proof.outwards_mm >= worst[1] - 1e-9, "{proof:?} {worst:?}");
            // Not by more than halving can tell, where the limits are kept.
            assert!(proof.inwards_mm <= worst[0].max(limits[0]) + 1e-5, "{proof:?} {worst:?}");
        }
    }
}

#[test]
fn forms_agree_with_quadrature() {
    use crate::numerics::quintic::{self, Breaks, apply};
    let breaks = Breaks::new(vec![0.0, 0.7, 1.1, 2.0, 2.4]).unwrap();
    let x: Vec<[f64; 3]> = (0..breaks.controls() as u32).map(|k| [noise(k), noise(k + 90), noise(k + 300)]).collect();
    for i in 0..breaks.spans() {
        let [a, b] = breaks.span(i);
        let ordinates = apply(&breaks.ordinates(i, [a, b]), &x[i..]);
        let n = 4000;
        let square = |k: usize| {
            let d = quintic::at(&ordinates, b - a, (k as f64 + 0.5) / n as f64)[3];
            d.iter().map(|v| v * v).sum::<f64>()
        };
        let value = 0.5 * (b - a) / n as f64 * (0..n).map(square).sum::<f64>();
        let third = form::third::<3, 18>(&breaks, i, &x[i..]);
        assert!((third.value / value - 1.0).abs() < 1e-6);
        // A machine whose axes are those of the part.
        let same = form::Linear { columns: [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]], offset: [0.0; 3] };
        let axes = form::axes(&breaks, i, &x[i..], [1.0; 3], |_| same);
        assert!((axes.value / value - 1.0).abs() < 1e-6);
        for p in 0..18 {
            assert!((axes.gradient[p] - third.gradient[p]).abs() < 1e-5 * third.value, "{p}");
            for q in 0..18 {
                assert!((axes.hessian[p][q] - third.hessian[p][q]).abs() < 1e-5 * third.hessian[0][0].max(1.0));
            }
        }
    }
}
