#![allow(clippy::unwrap_used)]
use std::f64::consts::{PI, TAU};

use proptest::prelude::*;

use super::*;
use crate::artifact::channel::{Binding, ChannelRow};
use crate::artifact::schedule::BaseAngle;
use crate::artifact::toolpath::{CutterLocation, Turn};
use crate::artifact::{Cones, ToolPart};
use crate::error::{EndReason, ErrorKind, Infeasible};
use crate::geometry::{Point, Vector};
use crate::observe::Silent;

/// A path of `turns` turns of `per` steps of 1 mm around a cylinder.
pub(super) fn path(turns: usize, per: usize) -> Toolpath {
    let n = turns * per + 1;
    let locations = (0..n)
        .map(|i| {
            let turn = (i / per).min(turns - 1);
            let phi = TAU * i as f64 / per as f64;
            let normal = Vector::new(0.0, phi.cos(), phi.sin());
            let contact = Point::origin() + normal * 10.0;
            CutterLocation {
                turn: turn as u32,
                turn_s_mm: (i - turn * per) as f64,
                s_mm: i as f64,
                centre: contact + normal * 2.0,
                contact,
                normal,
            }
        })
        .collect();
    let turns = (0..turns)
        .map(|k| Turn { first: k * per, count: per + usize::from(k + 1 == turns), length_mm: per as f64 })
        .collect();
    Toolpath {
        kind: crate::artifact::toolpath::PathKind::default(),
        stock_mm: 0.0,
        radius_mm: 2.0,
        disc_radius_mm: 0.0,
        scallop_mm: 0.01,
        chord_mm: 0.01,
        region_x_mm: [0.0, 1.0],
        end_reason: EndReason::Region,
        planned_scallop_mm: 0.01,
        cones: Cones::about_blade(0.1),
        axis_turning: None,
        turns,
        locations,
    }
}

/// A channel from raw limits, with its monotone hull.
pub(super) fn channel(limits: &[[f64; 2]]) -> Channel {
    let mut rows: Vec<ChannelRow> = limits
        .iter()
        .map(|[lo, hi]| ChannelRow {
            theta_min: *lo,
            theta_max: *hi,
            hull_min: *lo,
            hull_max: *hi,
            tangent_min: *lo,
            tangent_max: *hi,
            binds_min: Binding::Part { tool: ToolPart::Taper, face: 7, triangle: 0 },
            binds_max: Binding::ContactAngle,
        })
        .collect();
    for i in 1..rows.len() {
        rows[i].hull_min = rows[i].hull_min.max(rows[i - 1].hull_min);
        let k = rows.len() - 1 - i;
        rows[k].hull_max = rows[k].hull_max.min(rows[k + 1].hull_max);
    }
    Channel { tolerance_rad: 1e-6, rows, narrowest_row: 0, chains: 1, proven_at: Vec::new(), sweep: Default::default() }
}

/// A blade's turn: θ runs fast round two edges and slowly along two sides; `dip` makes the forward
/// limit of the concave side dip.
pub(super) fn blade_like(turns: usize, per: usize, width: f64, dip: f64) -> Vec<[f64; 2]> {
    (0..=turns * per)
        .map(|i| {
            let u = TAU * i as f64 / per as f64;
            let middle = u - 0.45 * (2.0 * u).sin() + PI;
            let concave = (u.sin()).max(0.0).powi(2);
            [middle - width + dip * concave, middle + width - dip * concave]
        })
        .collect()
}

fn run(path: &Toolpath, channel: &Channel) -> Result<Schedule> {
    plan(ScheduleKind::Piecewise, path, channel, &ScheduleOptions::default(), &Silent)
}

/// Monotone, inside the hull everywhere (dense), G2 at all joints, key points in order.
fn assert_sound(s: &Schedule, path: &Toolpath, channel: &Channel) {
    let first = path.locations[0].s_mm;
    let last = path.locations[path.locations.len() - 1].s_mm;
    assert_eq!((s.pieces[0][0][0], s.pieces[s.pieces.len() - 1][3][0]), (first, last));
    for w in s.pieces.windows(2) {
        assert_eq!(w[0][3], w[1][0]);
        let (a, b) = (bezier::derivatives(&w[0], 1.0), bezier::derivatives(&w[1], 0.0));
        let scale = 1e-9 + s.peak_rate;
        assert!((a[1] - b[1]).abs() < 1e-5 * scale, "slope {a:?} {b:?}");
        let zero = |piece: &[[f64; 2]; 4], d: [f64; 3]| {
            let rounding = 1e-14 * (1.0 + d[0].abs()) / (piece[3][0] - piece[0][0]).powi(2);
            d[2].abs() < 1e-6 * s.peak_acceleration + rounding
        };
        assert!(zero(&w[0], a) && zero(&w[1], b), "curvature {a:?} {b:?} of {}", s.peak_acceleration);
    }
    let rows = &channel.rows;
    let mut before = f64::NEG_INFINITY;
    for i in 0..rows.len() - 1 {
        for k in 0..8 {
            let f = f64::from(k) / 8.0;
            let mix = |a: f64, b: f64| a + f * (b - a);
            let at = mix(path.locations[i].s_mm, path.locations[i + 1].s_mm);
            let theta = bezier::sample(&s.pieces, [at])[0];
            assert!(theta >= mix(rows[i].hull_min, rows[i + 1].hull_min) - 1e-9);
            assert!(theta <= mix(rows[i].hull_max, rows[i + 1].hull_max) + 1e-9);
            assert!(theta >= before - 1e-12);
            before = theta;
            if k == 0 {
                assert!((theta - s.theta[i]).abs() < 1e-12);
            }
        }
    }
    assert_eq!(s.reversals, 0);
    assert!(s.key_points.windows(2).all(|w| w[0][0] < w[1][0] && w[0][1] <= w[1][1] + 1e-12));
}

#[test]
fn a_channel_that_holds_a_straight_line_gets_it() {
    let p = path(5, 50);
    let limits: Vec<[f64; 2]> = p.locations.iter().map(|l| [0.1 * l.s_mm, 0.1 * l.s_mm + 0.4]).collect();
    let c = channel(&limits);
    let s = run(&p, &c).unwrap();
    assert_sound(&s, &p, &c);
    assert!(s.peak_acceleration < 1e-15);
    assert!((s.peak_rate - 0.1).abs() < 1e-6);
    assert_eq!(s.pieces.len(), 1);
}

#[test]
fn a_blade_like_channel_is_level_at_base_points_and_gentle() {
    let p = path(6, 240);
    let c = channel(&blade_like(6, 240, 0.35, 0.1));
    let s = run(&p, &c).unwrap();
    assert_sound(&s, &p, &c);
    // The middle of the channel itself: peak 4 · 0.45 · (2π/240)² rad/mm². A corner with zero
    // curvature at all joints has a peak of 8/3 of its mean.
    let middle = 1.8 * (TAU / 240.0).powi(2);
    assert!(s.peak_acceleration < 8.0 / 3.0 * middle, "{} {middle}", s.peak_acceleration);
    // Level at every base point.
    for k in 1..6 {
        let at = 240.0 * f64::from(k);
        let piece = s.pieces.iter().find(|p| p[3][0] == at).unwrap();
        assert!(bezier::derivatives(piece, 1.0)[1].abs() < 1e-12);
    }
}

#[test]
fn a_dipping_channel_uses_its_hull() {
    let p = path(3, 200);
    let raw = blade_like(3, 200, 0.9, 0.75);
    assert!(
        raw.windows(2).any(|w| w[1][1] < w[0][1] - 1e-6),
        "the raw forward limit must dip for this test to mean much"
    );
    let c = channel(&raw);
    assert_sound(&run(&p, &c).unwrap(), &p, &c);
}

#[test]
fn a_closed_hull_is_infeasible_and_says_where_and_why() {
    let p = path(2, 100);
    let mut raw = blade_like(2, 100, 0.5, 0.0);
    raw[130][0] += 1.2;
    let e = run(&p, &channel(&raw)).unwrap_err();
    assert_eq!(e.kind, ErrorKind::Infeasible);
    assert!(e.message.contains("turn 2, S = ") && e.message.contains("taper against the part"), "{e}");
    assert!(e.message.contains("contact angle") && e.advice.is_some());
    let Some(Infeasible::HullClosed { at, short_deg, lower_at, upper_at }) = e.infeasible.as_deref() else {
        panic!("{e:?}")
    };
    assert!(at.turn == 1 && *short_deg > 0.0 && lower_at.location <= upper_at.location, "{e:?}");
}

#[test]
fn a_gate_of_one_sample_is_passed() {
    let p = path(2, 100);
    let mut raw = blade_like(2, 100, 0.8, 0.0);
    for (i, side) in [(40, 0.79), (130, -0.79)] {
        let middle = 0.5 * (raw[i][0] + raw[i][1]);
        raw[i] = [middle + side - 0.01, middle + side + 0.01];
    }
    let c = channel(&raw);
    assert_sound(&run(&p, &c).unwrap(), &p, &c);
}

#[test]
fn walls_that_touch_on_a_straight_line_are_passed_and_in_a_bend_are_refused() {
    let p = path(1, 100);
    let straight: Vec<[f64; 2]> = (0..=100)
        .map(|i| if i == 50 { [5.0, 5.0] } else { [0.1 * f64::from(i) - 0.5, 0.1 * f64::from(i) + 0.5] })
        .collect();
    let c = channel(&straight);
    assert!(run(&p, &c).unwrap().peak_acceleration < 1e-15);
    let bent: Vec<[f64; 2]> = (0..=100)
        .map(|i| {
            let s = f64::from(i);
            let t = if s < 50.0 { 0.02 * s } else { 1.0 + 0.2 * (s - 50.0) };
            let w = 0.002 * (s - 50.0).abs();
            [t - w, t + w]
        })
        .collect();
    let e = run(&p, &channel(&bent)).unwrap_err();
    assert_eq!(e.kind, ErrorKind::Infeasible);
    assert!(e.message.contains("no room to turn"), "{e}");
    assert!(matches!(e.infeasible.as_deref(), Some(Infeasible::NoRoomToTurn { at, .. }) if at.turn == 0), "{e:?}");
}

#[test]
fn scaling_and_shifting_the_plane_moves_the_schedule_along() {
    let p = path(3, 120);
    let raw = blade_like(3, 120, 1.0, 0.4);
    let shifted: Vec<[f64; 2]> = raw.iter().map(|r| r.map(|v| v + 100.0)).collect();
    let (a, b) = (run(&p, &channel(&raw)).unwrap(), run(&p, &channel(&shifted)).unwrap());
    assert!(a.theta.iter().zip(&b.theta).all(|(x, y)| (x + 100.0 - y).abs() < 1e-9));
    let mut long = p.clone();
    long.locations.iter_mut().for_each(|l| {
        l.s_mm *= 3.0;
        l.turn_s_mm *= 3.0;
    });
    long.turns.iter_mut().for_each(|t| t.length_mm *= 3.0);
    let d = run(&long, &channel(&raw)).unwrap();
    assert!(a.theta.iter().zip(&d.theta).all(|(x, y)| (x - y).abs() < 1e-7));
}

#[test]
fn the_fixed_schedule_follows_the_normal_and_counts() {
    let p = path(2, 90);
    let c = channel(&blade_like(2, 90, 3.0, 0.0));
    let options = ScheduleOptions::default().with(|s| s.lead_deg = 15.0);
    let s = plan(ScheduleKind::Fixed, &p, &c, &options, &Silent).unwrap();
    for (i, t) in s.theta.iter().enumerate() {
        let want = TAU * i as f64 / 90.0 + 15f64.to_radians();
        let turns = (t - want) / TAU;
        assert!((turns - turns.round()).abs() < 1e-9);
    }
    assert_eq!(s.reversals, 0);
    assert!((s.peak_rate - TAU / 90.0).abs() < 1e-9 && s.peak_acceleration < 1e-9);
}

#[test]
fn bad_input_is_refused() {
    let p = path(2, 20);
    let c = channel(&blade_like(2, 19, 1.0, 0.0));
    assert_eq!(run(&p, &c).unwrap_err().kind, ErrorKind::Usage);
    let mut c = channel(&blade_like(2, 20, 1.0, 0.0));
    c.rows[3].hull_min = f64::NAN;
    assert_eq!(run(&p, &c).unwrap_err().kind, ErrorKind::Usage);
    let mut q = p.clone();
    q.locations[5].s_mm = 4.0;
    assert_eq!(run(&q, &channel(&blade_like(2, 20, 1.0, 0.0))).unwrap_err().kind, ErrorKind::Usage);
    for bad in [
        ScheduleOptions::default().with(|s| s.margin_deg = -1.0),
        ScheduleOptions::default().with(|s| s.lead_deg = f64::NAN),
        ScheduleOptions { level_stretch_mm: Some(0.0), ..Default::default() },
    ] {
        let e = plan(ScheduleKind::Piecewise, &p, &c, &bad, &Silent).unwrap_err();
        assert_eq!(e.kind, ErrorKind::Usage);
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(40))]
    #[test]
    fn every_open_channel_gets_a_sound_schedule(
        turns in 1..4usize, seed in prop::collection::vec((0.0..1.0f64, 0.0..1.0f64), 30), width in 0.02..2.0f64,
        power in 1..6i32,
    ) {
        let per = 30;
        let p = path(turns, per);
        // Random steps that repeat every turn, so that θ rises by 2π per turn.
        let total: f64 = seed.iter().map(|s| s.0.powi(power)).sum::<f64>() + 1e-3;
        let mut t = 0.0;
        let mut limits = Vec::new();
        for i in 0..=turns * per {
            let (step, extra) = seed[i % per];
            t += TAU * step.powi(power) / total;
            limits.push([t - width * extra, t + width * (1.0 - extra) + 1e-3]);
        }
        let c = channel(&limits);
        prop_assume!(c.rows.iter().all(|r| r.hull_max - r.hull_min > 1e-4));
        let s = run(&p, &c).unwrap();
        assert_sound(&s, &p, &c);
    }
}

#[test]
fn a_base_angle_inside_a_wide_channel_is_gentler_than_the_forward_limit() {
    // One round of the normal a turn, uneven by 0.9 rad, in a channel that is just too narrow for a
    // straight line.
    let limits: Vec<[f64; 2]> = (0..=240)
        .map(|i| {
            let u = TAU * f64::from(i) / 60.0;
            let middle = u + 0.9 * u.sin();
            [middle - 0.85, middle + 0.85]
        })
        .collect();
    let (path, channel) = (path(4, 60), channel(&limits));
    let with = |base_angle| {
        let options = ScheduleOptions::default().with(|s| s.base_angle = base_angle);
        plan(ScheduleKind::Piecewise, &path, &channel, &options, &Silent).unwrap()
    };
    let (best, published) = (with(BaseAngle::Best), with(BaseAngle::ForwardLimit));
    assert_sound(&best, &path, &channel);
    assert_sound(&published, &path, &channel);
    assert!(
        best.peak_acceleration < 0.75 * published.peak_acceleration,
        "{} {}",
        best.peak_acceleration,
        published.peak_acceleration
    );
    assert!(best.peak_rate < published.peak_rate);
    // Published: in the forward half of the channel at every base point, whatever inset was the
    // best.
    for turn in path.turns.iter().skip(1) {
        let (r, theta) = (&channel.rows[turn.first], published.theta[turn.first]);
        assert!(theta > 0.5 * (r.hull_min + r.hull_max) && theta < r.hull_max, "{} {theta}", r.hull_max);
    }
}

#[test]
fn walls_are_followed_and_passed_by_what_was_asked() {
    let (path, channel) = (path(2, 60), channel(&blade_like(2, 60, 0.6, 0.3)));
    let along = |kind, beyond_wall_deg| {
        let options = ScheduleOptions::default().with(|s| s.beyond_wall_deg = beyond_wall_deg);
        plan(kind, &path, &channel, &options, &Silent).unwrap().theta
    };
    let (low, high) = (along(ScheduleKind::LowerWall, 0.0), along(ScheduleKind::UpperWall, 0.2));
    for ((l, h), r) in low.iter().zip(&high).zip(&channel.rows) {
        assert_eq!(*l, r.theta_min);
        assert!((h - r.theta_max - 0.2f64.to_radians()).abs() < 1e-12);
    }
    let bad = ScheduleOptions::default().with(|s| s.beyond_wall_deg = -1.0);
    assert_eq!(plan(ScheduleKind::LowerWall, &path, &channel, &bad, &Silent).unwrap_err().kind, ErrorKind::Usage);
}
