#![allow(clippy::unwrap_used)]
use std::f64::consts::{FRAC_PI_2, PI, TAU};

use proptest::prelude::*;

use super::*;
use crate::artifact::Cones;
use crate::artifact::toolpath::CutterLocation;
use crate::error::{EndReason, ErrorKind};
use crate::geometry::{Point, Vector};
use crate::observe::Silent;

/// Ball centres and angles at given arc lengths.
fn path(points: &[(f64, Point, f64)]) -> (Toolpath, Schedule) {
    let locations = points
        .iter()
        .map(|(s, p, _)| CutterLocation {
            turn: 0,
            turn_s_mm: *s,
            s_mm: *s,
            centre: *p,
            contact: *p,
            normal: Vector::y(),
        })
        .collect();
    let theta = points.iter().map(|p| p.2).collect();
    let toolpath = Toolpath {
        kind: crate::artifact::toolpath::PathKind::default(),
        stock_mm: 0.0,
        radius_mm: 1.0,
        disc_radius_mm: 0.0,
        scallop_mm: 0.01,
        chord_mm: 0.01,
        region_x_mm: [0.0, 0.0],
        planned_scallop_mm: 0.01,
        end_reason: EndReason::Region,
        cones: Cones::about_blade(0.1),
        axis_turning: None,
        turns: Vec::new(),
        locations,
    };
    (toolpath, Schedule::of_angles(theta))
}

fn options(feed_mm_min: f64) -> FeedOptions {
    FeedOptions { limit_jerk: false, chord_mm: 10.0, ..FeedOptions::new(feed_mm_min, 120.0) }
}

/// Every limit, at the locations (both sides) and densely between them.
fn assert_within_limits(p: &Toolpath, s: &Schedule, machine: &Machine, o: &FeedOptions) {
    let (curve, _) = axis_curve(p, s, None, machine, o).unwrap();
    let limits: Vec<_> = machine.axes().iter().map(|a| [a.limits.velocity, a.limits.acceleration]).collect();
    let feed = o.settings.feed_mm_min / 60.0;
    let at_s = curve.abscissae();
    let profile = topp::fastest(&curve, &limits, &vec![feed * feed; at_s.len()].into(), &Silent).unwrap();
    for i in 0..at_s.len() - 1 {
        let h = at_s[i + 1] - at_s[i];
        for k in 0..=8 {
            let t = h * f64::from(k) / 8.0;
            let more = 1.0 + 1e-6;
            let x = (profile.x[i] + 2.0 * t * profile.u[i]).max(0.0);
            assert!(x.sqrt() <= feed * more);
            for (axis, [v, a]) in limits.iter().enumerate() {
                let [_, q1, q2] = curve.at(i, axis, t);
                assert!(q1.abs() * x.sqrt() <= v * more, "velocity at {i} + {k}/8");
                assert!((q1 * profile.u[i] + q2 * x).abs() <= a * more, "acceleration at {i} + {k}/8");
            }
        }
    }
}

/// A ball centre on a wavy helix, with θ that follows it unevenly.
fn wavy(n: usize, step: f64, wave: f64) -> Vec<(f64, Point, f64)> {
    let mut out: Vec<(f64, Point, f64)> = Vec::new();
    for i in 0..n {
        let f = step * i as f64 / 30.0;
        let r = 30.0 + wave * (3.0 * f).sin();
        let p = Point::new(0.2 * f, r * f.cos(), 0.5 * r * f.sin());
        let s = out.last().map_or(0.0, |(s, q, _)| s + (p - q).norm());
        out.push((s, p, f + 0.4 * (2.0 * f).sin()));
    }
    out
}

#[test]
fn a_straight_line_takes_the_time_of_a_trapezoid() {
    let machine = Machine::demo().unwrap();
    let a = machine.axes()[0].limits.acceleration;
    for (length, feed) in [(100.0, 100.0), (2.0, 400.0)] {
        let n = 4001;
        let points: Vec<_> = (0..n)
            .map(|i| {
                let s = length * f64::from(i) / f64::from(n - 1);
                (s, Point::new(s, 5.0, 7.0), 1.0)
            })
            .collect();
        let (p, s) = path(&points);
        let m = plan(&p, &s, &machine, &options(feed * 60.0), &Silent).unwrap();
        let want = if length > feed * feed / a { length / feed + feed / a } else { 2.0 * (length / a).sqrt() };
        assert!((m.time_s / want - 1.0).abs() < 1e-3, "{} {want}", m.time_s);
        assert_eq!((m.velocity[0][0], m.velocity[m.velocity.len() - 1][0]), (0.0, 0.0));
        assert!(m.acceleration.iter().all(|q| q[0].abs() <= a * (1.0 + 1e-6)));
        assert!(m.feed.iter().all(|f| *f > 0.0 && *f <= feed * (1.0 + 1e-9)));
        assert!(m.t_s.windows(2).all(|w| w[1] > w[0]));
        assert_within_limits(&p, &s, &machine, &options(feed * 60.0));
    }
}

#[test]
fn on_a_circle_the_speed_is_held_by_the_centripetal_acceleration() {
    // θ = 90°: blade x, y are machine X, Y; nothing turns. Where the radius is along an axis, v² /
    // r ≤ a.
    let machine = Machine::demo().unwrap();
    let (r, n) = (1.0, 1440);
    let points: Vec<_> = (0..=n)
        .map(|i| {
            let f = 3.0 * TAU * f64::from(i) / f64::from(n);
            (r * f, Point::new(r * f.cos(), r * f.sin(), 0.0), FRAC_PI_2)
        })
        .collect();
    let (p, s) = path(&points);
    let o = options(400.0 * 60.0);
    let m = plan(&p, &s, &machine, &o, &Silent).unwrap();
    let most = (machine.axes()[0].limits.acceleration * r).sqrt();
    for quarter in 2..10 {
        let i = quarter * 120;
        let v = m.velocity[i][0].hypot(m.velocity[i][1]);
        assert!(v <= most * (1.0 + 1e-4) && v >= most * 0.999, "{v} {most}");
    }
    assert_within_limits(&p, &s, &machine, &o);
    // Slow enough, the circle costs nothing: a trapezoid along its length.
    let slow = plan(&p, &s, &machine, &options(20.0 * 60.0), &Silent).unwrap();
    let length = 3.0 * TAU * r;
    assert!((slow.time_s - (length / 20.0 + 20.0 / 3000.0)).abs() < 0.01 * 20.0 / 3000.0);
}

#[test]
fn a_turning_table_is_held_by_its_own_limits() {
    // The ball centre on the axis of rotation, θ = k s: only A moves besides X; A's velocity
    // decides.
    let machine = Machine::demo().unwrap();
    let k = 1.0;
    let points: Vec<_> = (0..=5000)
        .map(|i| (0.01 * f64::from(i), Point::new(0.01 * f64::from(i), 0.0, 0.0), k * 0.01 * f64::from(i)))
        .collect();
    let (p, s) = path(&points);
    let m = plan(&p, &s, &machine, &options(60000.0), &Silent).unwrap();
    let (v, a) = (PI, machine.axes()[3].limits.acceleration);
    let want = 50.0 * k / v + v / a;
    assert!((m.time_s / want - 1.0).abs() < 1e-3, "{} {want}", m.time_s);
    let double = plan(&p, &s, &machine.with_limits_scaled(4.0), &options(60000.0), &Silent).unwrap();
    assert!(double.time_s < 0.3 * m.time_s);
}

#[test]
fn motion_is_consistent_with_its_own_positions() {
    let (p, s) = path(&wavy(3000, 0.1, 2.0));
    let machine = Machine::demo().unwrap();
    let o = options(3000.0);
    let m = plan(&p, &s, &machine, &o, &Silent).unwrap();
    for i in 0..m.t_s.len() - 1 {
        let dt = m.t_s[i + 1] - m.t_s[i];
        for k in 0..5 {
            let v = (m.position[i + 1][k] - m.position[i][k]) / dt;
            let mean = 0.5 * (m.velocity[i][k] + m.velocity[i + 1][k]);
            assert!((v - mean).abs() < 0.02 * (0.1 + v.abs()), "{i} {k}: {v} {mean}");
        }
        let back = machine.forward(&m.position[i], o.gauge_length_mm);
        assert!((back.centre - p.locations[i].centre).norm() < 1e-9);
    }
    assert_within_limits(&p, &s, &machine, &o);
}

#[test]
fn peaks_are_those_of_constant_feed() {
    let points: Vec<_> = (0..=900)
        .map(|i| {
            let f = TAU * f64::from(i) / 300.0;
            (20.0 * f, Point::new(0.0, 20.0 * f.cos(), 20.0 * f.sin()), f)
        })
        .collect();
    let (p, s) = path(&points);
    let peak = peaks(&p, &s, &Machine::demo().unwrap(), &options(1200.0)).unwrap();
    // The table turns against the ball centre: A at 20 mm/s / 20 mm, everything else stands still.
    assert!((peak.velocity[3] - 1.0).abs() < 1e-9);
    assert!([0, 1, 2, 4].iter().all(|k| peak.velocity[*k] < 1e-6 && peak.acceleration[*k] < 1e-3));
    let mut wobbly = s.clone();
    wobbly.theta.iter_mut().enumerate().for_each(|(i, t)| *t += 0.1 * (0.2 * i as f64).sin());
    let worse = peaks(&p, &wobbly, &Machine::demo().unwrap(), &options(1200.0)).unwrap();
    assert!(worse.acceleration[3] > 10.0 * peak.acceleration[3].max(0.01));
}

#[test]
fn a_corner_in_the_path_slows_the_motion_down() {
    let points: Vec<_> = (0..=2000)
        .map(|i| {
            let s = 0.02 * f64::from(i);
            let p = if s < 20.0 { Point::new(s, 0.0, 0.0) } else { Point::new(20.0, s - 20.0, 0.0) };
            (s, p, FRAC_PI_2)
        })
        .collect();
    let (p, s) = path(&points);
    let machine = Machine::demo().unwrap();
    let m = plan(&p, &s, &machine, &options(6000.0), &Silent).unwrap();
    assert!(m.feed[1000] < 0.2 * m.feed[500]);
    assert_within_limits(&p, &s, &machine, &options(6000.0));
}

#[test]
fn bad_input_is_refused() {
    let machine = Machine::demo().unwrap();
    let (p, s) = path(&wavy(100, 1.0, 0.0));
    let kind = |p: &Toolpath, s: &Schedule, o: FeedOptions| plan(p, s, &machine, &o, &Silent).unwrap_err().kind;
    assert_eq!(kind(&p, &s, options(0.0)), ErrorKind::Usage);
    assert_eq!(kind(&p.clone().with_cones(Cones::about_blade(1.6)), &s, options(1.0)), ErrorKind::Usage);
    assert_eq!(kind(&p, &s, FeedOptions { gauge_length_mm: f64::NAN, ..options(1.0) }), ErrorKind::Usage);
    let mut short = s.clone();
    short.theta.pop();
    assert_eq!(kind(&p, &short, options(100.0)), ErrorKind::Usage);
    let mut broken = s.clone();
    broken.theta[50] = f64::NAN;
    assert_eq!(kind(&p, &broken, options(100.0)), ErrorKind::Usage);
    let mut stuck = p.clone();
    stuck.locations[7].s_mm = stuck.locations[6].s_mm;
    assert_eq!(kind(&stuck, &s, options(100.0)), ErrorKind::Usage);
    let (tiny, theta) = path(&wavy(2, 1.0, 0.0));
    assert_eq!(kind(&tiny, &theta, options(100.0)), ErrorKind::Usage);
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(24))]
    #[test]
    fn no_limit_is_exceeded(step in 0.05..2.0f64, wave in 0.0..3.0f64, feed in 100.0..20000.0f64, scale in 0.1..4.0f64) {
        let (p, s) = path(&wavy(400, step, wave));
        let machine = Machine::demo().unwrap().with_limits_scaled(scale);
        assert_within_limits(&p, &s, &machine, &options(feed));
    }
}

/// Divided differences of the written positions: averages of the derivative, so none may exceed its
/// limit. As anybody would take them from `axes.csv`.
fn assert_differences_within_limits(m: &AxisMotion, machine: &Machine) {
    let limits: Vec<_> = machine.axes().iter().map(|a| a.limits).collect();
    for k in 0..5 {
        let mut values: Vec<f64> = m.position.iter().map(|q| q[k]).collect();
        for (order, most) in [limits[k].velocity, limits[k].acceleration, limits[k].jerk].into_iter().enumerate() {
            let span = order + 1;
            values = (0..values.len() - 1)
                .map(|i| span as f64 * (values[i + 1] - values[i]) / (m.t_s[i + span] - m.t_s[i]))
                .collect();
            for (i, v) in values.iter().enumerate() {
                // Positions of some hundred mm are known to 1e-13.
                let step = (m.t_s[i + span] - m.t_s[i]) / span as f64;
                let rounding = 1e-11 / step.powi(span as i32);
                assert!(v.abs() <= most * 1.001 + rounding, "axis {k}, derivative {span} at {i}: {v} {most}");
            }
        }
    }
}

#[test]
fn within_jerk_a_straight_line_takes_the_time_of_its_s_curve() {
    let machine = Machine::demo().unwrap();
    let (length, feed, jerk) = (100.0, 100.0, machine.axes()[0].limits.jerk);
    let points: Vec<_> = (0..=800)
        .map(|i| (length * f64::from(i) / 800.0, Point::new(length * f64::from(i) / 800.0, 5.0, 7.0), 1.0))
        .collect();
    let (p, s) = path(&points);
    let o = FeedOptions { limit_jerk: true, ..options(feed * 60.0) };
    let m = plan(&p, &s, &machine, &o, &Silent).unwrap();
    // Up to speed in 2 √(v/j) without reaching the acceleration's limit; at half speed on average.
    let want = length / feed + 2.0 * (feed / jerk).sqrt();
    // Each end costs some milliseconds, since speed squared is made of parabolas.
    assert!(m.time_s >= want * (1.0 - 1e-6) && m.time_s < want + 0.004, "{} {want}", m.time_s);
    assert_differences_within_limits(&m, &machine);
}

#[test]
fn within_jerk_acceleration_is_continuous_and_time_hardly_more() {
    let (p, s) = path(&wavy(1500, 0.1, 2.0));
    let machine = Machine::demo().unwrap();
    let fast = plan(&p, &s, &machine, &options(3000.0), &Silent).unwrap();
    let m = plan(&p, &s, &machine, &FeedOptions { limit_jerk: true, ..options(3000.0) }, &Silent).unwrap();
    assert!(m.time_s > 0.998 * fast.time_s && m.time_s < 1.1 * fast.time_s, "{} {}", m.time_s, fast.time_s);
    assert_differences_within_limits(&m, &machine);
    let limits: Vec<_> = machine.axes().iter().map(|a| a.limits).collect();
    for i in 1..m.t_s.len() {
        let dt = m.t_s[i] - m.t_s[i - 1];
        for k in 0..5 {
            let jump = (m.acceleration[i][k] - m.acceleration[i - 1][k]).abs();
            assert!(jump <= limits[k].jerk * dt * 1.001 + 1e-9, "{i} {k}");
        }
    }
}

#[test]
fn angles_as_rough_as_those_of_facets_are_followed_within_jerk() {
    // The rotary axis jumps to and fro by half a degree every few locations, which are as near as
    // 0.01 mm: speed has to fall to less than a thousandth in places.
    let mut points = wavy(1200, 0.1, 2.0);
    for (i, p) in points.iter_mut().enumerate() {
        p.2 += if i % 7 < 3 { 0.008 } else { 0.0 } + 1e-4 * (i as f64 * 7.3).sin();
    }
    let mut s_mm = 0.0;
    for (i, p) in points.iter_mut().enumerate() {
        s_mm += if i % 50 < 4 { 0.01 } else { 0.1 };
        p.0 = s_mm;
    }
    let (p, s) = path(&points);
    let machine = Machine::demo().unwrap();
    let m = plan(&p, &s, &machine, &FeedOptions { limit_jerk: true, ..options(3000.0) }, &Silent).unwrap();
    assert_differences_within_limits(&m, &machine);
    let without = plan(&p, &s, &machine, &options(3000.0), &Silent).unwrap();
    assert!(m.time_s > without.time_s && m.time_s < 6.0 * without.time_s, "{} {}", m.time_s, without.time_s);
}

/// Patches of noise of very different size, at steps that are up to a hundred times shorter than
/// others.
fn patches(n: usize) -> Vec<(f64, Point, f64)> {
    let mut out: Vec<(f64, Point, f64)> = Vec::new();
    let (mut f, mut s_mm) = (0.0f64, 0.0);
    for i in 0..n {
        let wild = |k: f64| (i as f64 * k).sin();
        f += 0.1 / 20.0 * 10f64.powf(-2.0 * (0.5 + 0.5 * wild(12.9898)).powi(3));
        let amplitude = 10f64.powf(2.0 * ((i / 400) as f64 * 1.7).sin() - 1.0);
        let facet = (i / 7) as f64;
        let r = 20.0 + 0.02 * amplitude * (facet * 78.233).sin();
        let p = Point::new(0.05 * f + 0.02 * amplitude * (facet * 37.719).sin(), r * f.cos(), 0.6 * r * f.sin());
        s_mm += out.last().map_or(0.0, |(_, q, _)| (p - q).norm());
        out.push((s_mm, p, f + 0.005 * amplitude * (facet * 93.989).sin()));
    }
    out
}

#[test]
fn what_is_said_of_a_rough_path_is_known() {
    let (p, s) = path(&patches(2500));
    let machine = Machine::demo().unwrap();
    let o = FeedOptions { limit_jerk: true, ..options(2000.0) };
    let told = crate::observe::Recorder::new(&Silent);
    let m = plan(&p, &s, &machine, &o, &told).unwrap();
    assert_differences_within_limits(&m, &machine);
    let (same, gap) = plan_with_bound(&p, &s, None, &machine, &o, &Silent).unwrap();
    assert_eq!(same, m);
    let gap = gap.unwrap();
    assert!(gap > LARGE_GAP && gap < 0.6, "{gap}");
    let said = told.warnings();
    assert!(
        said.len() == 1 && said[0].doubt.to_string().contains(&format!("by more than {:.1} %", 100.0 * gap)),
        "{said:?}"
    );
}

#[test]
fn on_a_smooth_path_little_is_left_between_the_motion_and_its_bound() {
    let machine = Machine::demo().unwrap();
    let (p, s) = path(&wavy(4000, 0.1, 2.0));
    let o = FeedOptions { limit_jerk: true, ..options(3000.0) };
    let (m, gap) = plan_with_bound(&p, &s, None, &machine, &o, &Silent).unwrap();
    let gap = gap.unwrap();
    assert!((0.0..0.01).contains(&gap), "{gap}");
    // Whatever keeps the limits of jerk keeps the others, too.
    let without = plan(&p, &s, &machine, &options(3000.0), &Silent).unwrap();
    assert!(m.time_s * (1.0 - gap) < m.time_s && without.time_s < 1.001 * m.time_s);
}

#[test]
fn one_thread_and_eight_find_the_same_motion() {
    let machine = Machine::demo().unwrap();
    let mut points = wavy(2500, 0.07, 1.0);
    points.iter_mut().enumerate().for_each(|(i, p)| p.2 += 2e-4 * (i as f64 * 12.9898).sin());
    let (p, s) = path(&points);
    let o = FeedOptions { limit_jerk: true, ..options(2000.0) };
    let with = |threads: usize| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
        pool.install(|| plan_with_bound(&p, &s, None, &machine, &o, &Silent).unwrap())
    };
    assert_eq!(with(1), with(8));
}

#[test]
fn whoever_asks_to_stop_gets_no_motion() {
    struct Stop;
    impl Observer for Stop {
        fn cancelled(&self) -> bool {
            true
        }
    }
    let (p, s) = path(&wavy(100, 0.1, 2.0));
    let o = FeedOptions { limit_jerk: true, ..options(3000.0) };
    assert_eq!(plan(&p, &s, &Machine::demo().unwrap(), &o, &Stop).unwrap_err().kind, ErrorKind::Cancelled);
}

#[test]
fn the_contact_point_is_not_to_outrun_the_feed() {
    // Inside a circle of radius 3 with a ball of radius 1, the contact runs 1.5 times as fast as
    // the centre.
    let points: Vec<_> = (0..=600)
        .map(|i| {
            let f = TAU * f64::from(i) / 300.0;
            (2.0 * f, Point::new(2.0 * f.cos(), 2.0 * f.sin(), 0.0), FRAC_PI_2)
        })
        .collect();
    let (mut p, s) = path(&points);
    for l in &mut p.locations {
        l.contact = Point::from(l.centre.coords * 1.5);
    }
    let o = options(600.0);
    let m = plan(&p, &s, &Machine::demo().unwrap(), &o, &Silent).unwrap();
    assert!((m.feed[300] - 10.0 / 1.5).abs() < 1e-2, "{}", m.feed[300]);
    let free = FeedOptions { limit_contact: false, ..o };
    assert!((plan(&p, &s, &Machine::demo().unwrap(), &free, &Silent).unwrap().feed[300] - 10.0).abs() < 1e-6);
    // The tip's chord over one period: v² T² / 8 r.
    let chord = FeedOptions { chord_mm: 1e-5, ..free };
    let slow = plan(&p, &s, &Machine::demo().unwrap(), &chord, &Silent).unwrap();
    let want = (8.0 * 1e-5 * 2.0f64).sqrt() / chord.period_s;
    assert!((slow.feed[300] / want.min(10.0) - 1.0).abs() < 0.02, "{} {want}", slow.feed[300]);
    assert!(least_time(&p, &o) <= m.time_s && least_time(&p, &o) > 0.99 * m.time_s);
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(6))]
    #[test]
    fn no_difference_of_the_motion_exceeds_a_limit(step in 0.05..1.0f64, wave in 0.0..3.0f64, feed in 300.0..8000.0f64, scale in 0.25..4.0f64) {
        let (p, s) = path(&wavy(250, step, wave));
        let machine = Machine::demo().unwrap().with_limits_scaled(scale);
        let o = FeedOptions { limit_jerk: true, ..options(feed) };
        assert_differences_within_limits(&plan(&p, &s, &machine, &o, &Silent).unwrap(), &machine);
    }
}

/// A plan on a curve, closely enough that its polynomials are the curve to some nanometres.
fn curved() -> (Toolpath, Schedule, ProgrammedCurve) {
    let plan = crate::sample::on_curve(crate::sample::plan(2, 360), 0.03, 40.0, 3);
    (plan.toolpath, plan.schedule, plan.curve.unwrap())
}

#[test]
fn the_axes_on_a_curve_are_those_of_the_machine() {
    let machine = Machine::demo().unwrap();
    let (path, schedule, on) = curved();
    let o = FeedOptions { limit_jerk: true, ..options(2000.0) };
    let (curve, rates) = axis_curve(&path, &schedule, Some(&on), &machine, &o).unwrap();
    assert!(curve.is_bent() && rates.iter().all(|r| (r - 1.0).abs() < 1e-4), "{rates:?}");
    // What the series cut off, as its bound says: (h/2)⁶ q⁽⁶⁾/720 with waves of θ at 40/L.
    let s = curve.abscissae();
    let (h, wave) = (s[1], 40.0 / s[s.len() - 1]);
    let reach = 300.0;
    let bound = (0.5 * h).powi(6) * reach * (0.03 * wave.powi(6) + 0.05f64.powi(6)) / 720.0;
    let off = curve.cut_off();
    assert!(off < bound + 1e-9 && off < 1e-7, "{off} {bound}");
    // Third derivatives against differences of positions along the polynomials.
    for i in [5, 200, 500] {
        let p = on.polynomial(&path, &schedule.theta, i).unwrap();
        let place = |t: f64| {
            let at = p.at(t / p.length_mm);
            machine.inverse(&at.point(), at.theta[0], path.cone(i).lean_rad, o.gauge_length_mm)
        };
        let (t, d) = (0.5 * p.length_mm, 0.05);
        let rows = [-2.0, -1.0, 1.0, 2.0].map(|k| place(t + k * d));
        for k in 0..curve.functions() {
            let third = (rows[3][k] - 2.0 * rows[2][k] + 2.0 * rows[1][k] - rows[0][k]) / (2.0 * d.powi(3));
            let is = curve.third(i, k, t);
            assert!((is - third).abs() < 1e-3 * third.abs() + 2e-7, "axis {k} at {i}: {is} {third}");
        }
    }
}

#[test]
fn every_limit_is_kept_between_locations_of_a_curve() {
    let (path, schedule, on) = curved();
    for (feed, scale) in [(2000.0, 1.0), (12000.0, 0.3)] {
        let machine = Machine::demo().unwrap().with_limits_scaled(scale);
        let o = FeedOptions { limit_jerk: true, ..options(feed) };
        let (curve, rates) = axis_curve(&path, &schedule, Some(&on), &machine, &o).unwrap();
        let axes = machine.axes();
        let limits = jerk::Limits::from_fn(axes.len(), |k| {
            let l = axes[k].limits;
            [l.velocity, l.acceleration, l.jerk]
        });
        let speed = feed / 60.0;
        let caps: Vec<f64> = rates.iter().map(|r| (speed / r).powi(2)).collect();
        let p = jerk::fastest(&curve, &limits, (speed, true), &caps.into(), &Silent).unwrap();
        assert!((0.0..0.06).contains(&p.gap), "{}", p.gap);
        let s = curve.abscissae();
        let mut reached = [0.0f64; 3];
        // Without the end cells, where jerk along the path is constant instead.
        for g in 1..p.s.len() - 2 {
            let i = s.partition_point(|v| *v <= p.s[g] + 1e-12).clamp(1, s.len() - 1) - 1;
            for f in [0.0, 0.2, 0.5, 0.9] {
                let d = f * (p.s[g + 1] - p.s[g]);
                let (u, x) = (p.u[g] + p.w[g] * d, p.x[g] + 2.0 * p.u[g] * d + p.w[g] * d * d);
                let (v, t) = (x.max(0.0).sqrt(), p.s[g] + d - s[i]);
                for (k, most) in limits.iter().enumerate() {
                    let [_, q1, q2] = curve.at(i, k, t);
                    let third = curve.third(i, k, t);
                    let is = [q1 * v, q1 * u + q2 * x, v * (q1 * p.w[g] + 3.0 * q2 * u + third * x)];
                    for order in 0..3 {
                        let share = is[order].abs() / most[order];
                        assert!(share <= 1.0 + 1e-5, "axis {k}, derivative {order} at {g} + {f}: {share}");
                        reached[order] = reached[order].max(share);
                    }
                }
            }
        }
        assert!(reached[2] > 0.95, "{reached:?}");
        let motion = plan_on(&path, &schedule, Some(&on), &machine, &o, &Silent).unwrap();
        assert_differences_within_limits(&motion, &machine);
    }
}

#[test]
fn a_curve_that_is_another_path_s_is_refused() {
    let (path, schedule, mut on) = curved();
    on.rows.pop();
    let e = plan_on(&path, &schedule, Some(&on), &Machine::demo().unwrap(), &options(100.0), &Silent).unwrap_err();
    assert!(e.kind == ErrorKind::Usage && e.message.contains("the curve"), "{}", e.message);
}
