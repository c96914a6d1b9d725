#![allow(clippy::unwrap_used)]
use super::tests::{blade_like, channel, path};
use super::*;
use crate::artifact::Sweep;
use crate::artifact::schedule::{Measure, Scope};
use crate::error::{ErrorKind, Infeasible};
use crate::observe::Silent;

const MEASURES: [Measure; 4] = [Measure::PeakSecond, Measure::PeakThird, Measure::SquareSecond, Measure::SquareThird];

fn options(measure: Measure) -> ScheduleOptions {
    ScheduleOptions::default().with(|s| (s.margin_deg, s.measure) = (0.0, measure))
}

fn optimal(p: &Toolpath, limits: &[[f64; 2]], measure: Measure) -> Schedule {
    plan(ScheduleKind::Optimal, p, &channel(limits), &options(measure), &Silent).unwrap()
}

/// What every optimal schedule must be.
fn assert_sound(s: &Schedule) {
    assert_eq!(s.reversals, 0);
    assert!(s.quality.outside_rad < 1e-8 && s.quality.curvature_continuous);
    let (_, value, bound) = s.quality.measure.unwrap();
    assert!(bound <= value * (1.0 + 1e-9), "{value} {bound}");
    assert!(s.theta.windows(2).all(|w| w[1] >= w[0]));
}

/// At rest at 0 up to `from`, at rest at 1 from `to` on, anything between.
fn step(n: usize, from: usize, to: usize, width: f64) -> Vec<[f64; 2]> {
    (0..=n)
        .map(|i| match i {
            _ if i <= from => [0.0, width],
            _ if i >= to => [1.0 - width, 1.0],
            _ => [0.0, 1.0],
        })
        .collect()
}

#[test]
fn from_rest_to_rest_the_least_peaks_have_closed_forms() {
    // Over a length T: θ'' 4/T² (bang-bang), θ''' 32/T³, ∫ θ''² 12/T³, ∫ θ'''² 720/T⁵.
    let (p, walls) = (path(2, 150), step(300, 100, 200, 1e-4));
    let t = 100f64;
    let wants = [4.0 / t.powi(2), 32.0 / t.powi(3), 12.0 / t.powi(3), 720.0 / t.powi(5)];
    for (m, want) in MEASURES.into_iter().zip(wants) {
        let s = optimal(&p, &walls, m);
        assert_sound(&s);
        let (_, value, bound) = s.quality.measure.unwrap();
        // The width of the flats lengthens the way: by its cube root for third derivatives.
        assert!(value > 0.75 * want && value < 1.03 * want, "{m:?} {value} {want}");
        // Where the walls leave hardly any width the proof loses, since its weight is left open
        // there.
        if m == Measure::PeakSecond {
            assert!(bound > 0.5 * want, "{m:?} {bound} {want}");
        }
    }
}

#[test]
fn each_measure_is_least_in_its_own_and_near_its_bound() {
    let (p, walls) = (path(4, 90), blade_like(4, 90, 0.35, 0.2));
    let all = MEASURES.map(|m| optimal(&p, &walls, m));
    let value = |s: &Schedule| {
        let [second, third] = curve::squares(&s.pieces);
        [s.peak_acceleration, s.quality.peak_third.unwrap(), second, third]
    };
    for (k, s) in all.iter().enumerate() {
        assert_sound(s);
        let (_, v, bound) = s.quality.measure.unwrap();
        assert!(v < 1.03 * bound, "{k} {v} {bound}");
        assert!(all.iter().all(|o| v <= value(o)[k] * 1.005), "{k}");
    }
    // The bound of the second derivative holds for all of them, and the thin one nearly as well.
    let bound = all[0].quality.bound_second.unwrap();
    assert!(all.iter().all(|s| s.peak_acceleration >= bound));
    assert!(all[1].quality.bound_second.unwrap() > 0.97 * bound);
}

#[test]
fn never_worse_than_piecewise() {
    for (width, dip) in [(0.6, 0.0), (0.4, 0.1), (0.8, 0.5)] {
        let (p, walls) = (path(3, 120), blade_like(3, 120, width, dip));
        let o = ScheduleOptions::default();
        let piecewise = plan(ScheduleKind::Piecewise, &p, &channel(&walls), &o, &Silent).unwrap();
        let best = plan(ScheduleKind::Optimal, &p, &channel(&walls), &o, &Silent).unwrap();
        assert!(best.peak_acceleration <= piecewise.peak_acceleration, "{width} {dip}");
    }
}

#[test]
fn a_straight_line_that_fits_is_the_answer() {
    let walls: Vec<[f64; 2]> = (0..=180).map(|i| 0.05 * f64::from(i)).map(|t| [t, t]).collect();
    for m in MEASURES {
        let s = optimal(&path(2, 90), &walls, m);
        assert_eq!((s.pieces.len(), s.reversals), (1, 0));
        assert!(s.peak_acceleration < 1e-12 && s.quality.measure.unwrap().2 == 0.0);
    }
}

#[test]
fn a_channel_that_touches_itself_is_passed() {
    let mut walls = blade_like(3, 60, 0.5, 0.3);
    for (i, width) in [(45, 1e-7), (100, 0.0)] {
        let middle = 0.5 * (walls[i][0] + walls[i][1]);
        walls[i] = [middle - width, middle + width];
    }
    let p = path(3, 60);
    let s = optimal(&p, &walls, Measure::PeakSecond);
    assert_sound(&s);
    let (_, value, bound) = s.quality.measure.unwrap();
    assert!(value < 1.05 * bound, "{value} {bound}");
}

#[test]
fn a_channel_of_no_width_with_a_corner_is_refused() {
    // lo = hi everywhere, with a corner: no twice differentiable curve.
    let walls: Vec<[f64; 2]> = (0..=60).map(|i| f64::from((i - 30).max(0))).map(|t| [t, t]).collect();
    let e = plan(ScheduleKind::Optimal, &path(1, 60), &channel(&walls), &options(Measure::PeakSecond), &Silent)
        .unwrap_err();
    assert_eq!(e.kind, ErrorKind::Infeasible);
    assert!(matches!(e.infeasible.as_deref(), Some(Infeasible::NoSmoothSchedule { .. })), "{e:?}");
}

#[test]
fn the_shortest_path_is_planned() {
    for n in [2, 3, 4] {
        let walls: Vec<[f64; 2]> = (0..=n).map(|i| f64::from(i).powi(2)).map(|t| [t, t + 0.1]).collect();
        assert_sound(&optimal(&path(1, n as usize), &walls, Measure::SquareSecond));
    }
}

#[test]
fn locations_moved_by_rounding_move_it_by_as_little() {
    let (p, walls) = (path(3, 90), blade_like(3, 90, 0.4, 0.25));
    let before = optimal(&p, &walls, Measure::PeakSecond);
    let mut moved = p.clone();
    for (i, l) in moved.locations.iter_mut().enumerate() {
        l.s_mm += 1e-10 * (i as f64).sin();
    }
    let after = optimal(&moved, &walls, Measure::PeakSecond);
    let worst = before.theta.iter().zip(&after.theta).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
    assert!(worst < 1e-6, "{worst}");
}

#[test]
fn turn_by_turn_is_sound_and_nearly_as_good() {
    let (p, walls) = (path(6, 90), blade_like(6, 90, 0.35, 0.2));
    for m in MEASURES {
        let by_turn = options(m).with(|s| s.scope = Scope::Turns);
        let s = plan(ScheduleKind::Optimal, &p, &channel(&walls), &by_turn, &Silent).unwrap();
        assert_sound(&s);
        let (best, value) = (optimal(&p, &walls, m).quality.measure.unwrap().1, s.quality.measure.unwrap().1);
        assert!(value > best * (1.0 - 1e-4) && value < best * 1.1, "{m:?} {value} {best}");
    }
}

#[test]
fn a_turn_does_not_wait_for_turns_farther_on() {
    let (p, walls) = (path(5, 80), blade_like(5, 80, 0.35, 0.2));
    let mut other = walls.clone();
    // The last turn and a half is much narrower.
    for w in &mut other[285..] {
        let middle = 0.5 * (w[0] + w[1]);
        *w = [middle - 0.05, middle + 0.05];
    }
    let theta = |walls: &[[f64; 2]]| {
        let o = options(Measure::PeakSecond).with(|s| s.scope = Scope::Turns);
        plan(ScheduleKind::Optimal, &p, &channel(walls), &o, &Silent).unwrap().theta
    };
    let (a, b) = (theta(&walls), theta(&other));
    let differ = |range: std::ops::Range<usize>| range.map(|i| (a[i] - b[i]).abs()).fold(0.0, f64::max);
    // The hull looks ahead by what it narrows, within a turn here; the schedule by one turn.
    assert!(differ(0..80) < 1e-4, "{}", differ(0..80));
    assert!(differ(300..400) > 1e-3);
}

#[test]
fn one_turn_alone_may_need_nothing_where_the_whole_does() {
    // Slopes 1, 2, 1: within any turn a straight line fits between any two ends, and a search that
    // looks at one turn alone finds zero. Where they meet the slope has to change.
    let mut walls = Vec::new();
    let mut t = 0.0;
    for i in 0..=240 {
        walls.push([t, t + 0.3]);
        t += 0.01 * if (80..160).contains(&i) { 2.0 } else { 1.0 };
    }
    let p = path(3, 80);
    let s = optimal(&p, &walls, Measure::PeakSecond);
    assert_sound(&s);
    assert!(s.quality.measure.unwrap().2 > 1e-5, "{:?}", s.quality.measure);
    let alone = optimal(&path(1, 80), &walls[80..=160], Measure::PeakSecond);
    assert!(alone.peak_acceleration < 1e-12);
}

#[test]
fn a_channel_one_sample_wide_is_passed() {
    // Open everywhere but at single samples, where it has no width at all, on either side of its
    // middle.
    let mut walls = blade_like(3, 60, 0.8, 0.0);
    for (i, side) in [(40, 0.7), (100, -0.7), (101, -0.69), (150, 0.0)] {
        let middle = 0.5 * (walls[i][0] + walls[i][1]);
        walls[i] = [middle + side, middle + side];
    }
    for m in [Measure::PeakSecond, Measure::SquareSecond] {
        let s = optimal(&path(3, 60), &walls, m);
        assert_sound(&s);
        for i in [40, 100, 150] {
            assert!((s.theta[i] - walls[i][0]).abs() < 1e-8, "{i}");
        }
    }
}

#[test]
fn a_machine_that_is_too_slow_by_far_changes_the_least_time_by_a_factor_only() {
    // Where every place is slowed by the axis, its limits divide out.
    let (p, walls) = (path(4, 90), blade_like(4, 90, 0.35, 0.2));
    let paced = |share: f64| {
        let pace = Some(Pace { rate: share * 1e-2, second: share * 1e-3, standing_mm: 0.0 });
        let options = ScheduleOptions { pace, ..options(Measure::PeakSecond) };
        let s = plan(ScheduleKind::Time, &p, &channel(&walls), &options, &Silent).unwrap();
        assert!(s.reversals == 0 && s.quality.outside_rad < 1e-8);
        s.theta
    };
    let known = paced(1e-3);
    for share in [1e-5, 1e-7, 1e-9] {
        let apart = paced(share).iter().zip(&known).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
        assert!(apart < 1e-3, "{share}: {apart}");
    }
}

/// Second derivatives do not know a straight line: a corridor to and fro, and the same on a slope
/// on which nothing could turn back, have the same least peak.
#[test]
fn to_and_fro_is_the_same_as_on_a_slope() {
    let p = path(3, 80);
    let waves = |slope: f64| -> Vec<[f64; 2]> {
        let middle = |i: usize| 0.8 * (0.13 * i as f64).sin() + 0.3 * (0.041 * i as f64).cos() + slope * i as f64;
        let width = |i: usize| 0.12 + 0.08 * (0.31 * i as f64).sin();
        (0..=240).map(|i| [middle(i) - width(i), middle(i) + width(i)]).collect()
    };
    let swinging = |measure| {
        let limits = waves(0.0);
        let mut walls = channel(&limits);
        walls.sweep = Sweep::Swing;
        for (row, [lo, hi]) in walls.rows.iter_mut().zip(&limits) {
            (row.hull_min, row.hull_max) = (*lo, *hi);
        }
        plan(ScheduleKind::Optimal, &p, &walls, &options(measure), &Silent).unwrap()
    };
    for measure in MEASURES {
        let (to_and_fro, sloping) = (swinging(measure), optimal(&p, &waves(0.5), measure));
        assert!(to_and_fro.reversals > 5 && to_and_fro.quality.outside_rad < 1e-8);
        let value = |s: &Schedule| s.quality.measure.unwrap();
        let ((_, a, bound), (_, b, other)) = (value(&to_and_fro), value(&sloping));
        assert!((a - b).abs() < 5e-3 * b, "{measure:?} {a} {b}");
        assert!(bound <= a * (1.0 + 1e-9) && bound > 0.95 * a, "{measure:?} {a} {bound} {other}");
    }
}

/// The rate counts in both senses where the axis swings: for the least time it turns no faster
/// there than back.
#[test]
fn paced_schedules_count_both_senses() {
    let p = path(2, 100);
    let limits: Vec<[f64; 2]> = (0..=200)
        .map(|i| {
            let saw = ((i % 100) as f64 - 30.0).max(0.0) / 70.0;
            [saw.sqrt() - 0.1, saw.sqrt() + 0.1]
        })
        .collect();
    let mut walls = channel(&limits);
    walls.sweep = Sweep::Swing;
    for (row, [lo, hi]) in walls.rows.iter_mut().zip(&limits) {
        (row.hull_min, row.hull_max) = (*lo, *hi);
    }
    let pace = Some(Pace { rate: 1e-3, second: 1.0, standing_mm: 0.0 });
    let plan = |walls: &Channel| {
        plan(ScheduleKind::Time, &p, walls, &ScheduleOptions { pace, ..options(Measure::PeakSecond) }, &Silent).unwrap()
    };
    let mirrored = {
        let mut walls = walls.clone();
        for row in &mut walls.rows {
            (row.hull_min, row.hull_max) = (-row.hull_max, -row.hull_min);
            (row.theta_min, row.theta_max) = (-row.theta_max, -row.theta_min);
        }
        walls
    };
    let (a, b) = (plan(&walls), plan(&mirrored));
    let off = a.theta.iter().zip(&b.theta).map(|(x, y)| (x + y).abs()).fold(0.0, f64::max);
    assert!(off < 1e-3, "{off}");
}
