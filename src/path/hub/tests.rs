#![allow(clippy::unwrap_used)]
use std::f64::consts::TAU;

use super::*;
use crate::artifact::along::Along;
use crate::artifact::toolpath::{CutterLocation, PathKind};
use crate::error::ErrorKind;
use crate::geometry::allowance::Allowed;
use crate::geometry::part::Part;
use crate::observe::Silent;
use crate::path::plan as planned;
use crate::sample::{self, HUB_RADIUS, HUB_Z, PLATES_Z};

const BALL: f64 = 3.0;
const HALF: f64 = 2.0;

fn level(part: &Part) -> LevelSet<'_> {
    let part = Allowed::new(part, 0.0);
    LevelSet { part, along: Along::BLADE, radius_mm: BALL, inclined: None, rim: None, lowest_mm: f64::NEG_INFINITY }
}

fn foot() -> BladeFoot {
    BladeFoot { at: Point::new(HUB_RADIUS + 0.5, 0.0, 0.0), blade_mm: 20.0 }
}

fn options(wheel: Wheel, scallop_mm: f64) -> PathOptions {
    let options = PathOptions { hub_of: Some(wheel), ..PathOptions::new(BALL, scallop_mm) };
    options.with(|s| s.kind = PathKind::HubRows)
}

/// Between plates the ball stands off either by its radius; before and behind them the passage is
/// one pitch wide. Along the axis stations reach the hub's ends.
#[test]
fn passages_are_as_wide_as_the_closed_form() {
    let (blade, wheel) = sample::plates(12, HALF);
    let (level, frame) = (level(&blade.part), RotorFrame::new(&wheel).unwrap());
    let stations = Passage { level: &level, frame: &frame }.stations(&foot());
    let stations = stations.unwrap_or_else(|_| panic!("closed"));
    let pitch = TAU / 12.0;
    let between = 0.5 * pitch - ((HALF + BALL) / (HUB_RADIUS + BALL)).asin();
    let (mut inside, mut beyond) = (0, 0);
    for s in &stations {
        assert!((s.middle_rad - 0.5 * pitch).abs() < 1e-6 && (s.radius_mm - HUB_RADIUS - BALL).abs() < 1e-6, "{s:?}");
        let [z0, z1] = PLATES_Z;
        if (z0 + BALL..z1 - BALL).contains(&s.z_mm) {
            inside += 1;
            assert!((s.half_rad - between).abs() < 1e-6, "{s:?} {between}");
        } else if s.z_mm < z0 - BALL - 2.0 || s.z_mm > z1 + BALL + 2.0 {
            beyond += 1;
            assert!((s.half_rad - 0.5 * pitch).abs() < 1e-6, "{s:?}");
        } else {
            assert!((between - 1e-6..=0.5 * pitch + 1e-6).contains(&s.half_rad), "{s:?}");
        }
    }
    assert!(inside > 40 && beyond > 0, "{inside} {beyond}");
    let ends = [stations[0].z_mm, stations[stations.len() - 1].z_mm];
    // One radius beyond the balls that touch the plates' ends, where there is hub.
    assert!(ends[0] > HUB_Z[0] && ends[0] < PLATES_Z[0] - 1.5 * BALL, "{ends:?}");
    assert!(ends[1] < HUB_Z[1] && ends[1] > PLATES_Z[1] + 1.5 * BALL, "{ends:?}");
}

/// Every ball touches the hub and nothing else, chords keep the tolerance, the outer rows run at
/// the plates, and there are as many rows as the widest place needs.
#[test]
fn rows_divide_the_hub_as_the_scallop_asks() {
    let (blade, wheel) = sample::plates(12, HALF);
    let scallop_mm = 0.1;
    let path = planned(&blade, &options(wheel, scallop_mm), &Silent).unwrap();
    assert_eq!(path.kind, PathKind::HubRows);
    let off_axis = |p: &Point| p.x.hypot(p.y);
    for l in &path.locations {
        assert!(
            (off_axis(&l.centre) - HUB_RADIUS - BALL).abs() < 1e-5 && (off_axis(&l.contact) - HUB_RADIUS).abs() < 1e-5
        );
        let near = blade.part.closest(&l.centre, 2.0 * BALL).unwrap();
        assert!((near.distance_mm - BALL).abs() < 2e-6, "{}", near.distance_mm);
    }
    let far = |w: &[CutterLocation]| HUB_RADIUS + BALL - off_axis(&nalgebra::center(&w[0].centre, &w[1].centre));
    let sag = path.locations.windows(2).map(far).fold(0.0, f64::max);
    assert!(sag <= path.chord_mm + 1e-6, "{sag}");
    // Ridges between rows that divide one pitch of the hub.
    let ridge = |rows: usize| {
        let d = 2.0 * (HUB_RADIUS + BALL) * (0.5 * TAU / 12.0 / (rows - 1) as f64).sin();
        let [out, in_ball] = [HUB_RADIUS + BALL, BALL].map(|r| (r * r - 0.25 * d * d).sqrt());
        out - in_ball - HUB_RADIUS
    };
    let rows = path.turns.len();
    // What is foreseen beside the corner of a row is the ridge to that corner, which is a little
    // higher.
    let foreseen = path.planned_scallop_mm / ridge(rows);
    assert!((0.99..1.06).contains(&foreseen), "{foreseen}");
    assert!(path.planned_scallop_mm <= scallop_mm && ridge(rows - 1) > 0.92 * scallop_mm);
    let angle = |l: &CutterLocation| l.centre.y.atan2(l.centre.x);
    let amid = |row: usize| {
        let turn = path.turns[row];
        let of = &path.locations[turn.first..turn.first + turn.count];
        *of.iter().min_by(|a, b| a.centre.z.abs().total_cmp(&b.centre.z.abs())).unwrap()
    };
    let wall = ((HALF + BALL) / (HUB_RADIUS + BALL)).asin();
    let off = OFF_BLADE * scallop_mm / (HUB_RADIUS + BALL);
    assert!((angle(&amid(0)) - wall - off).abs() < 1e-5);
    assert!((TAU / 12.0 - angle(&amid(rows - 1)) - wall - off).abs() < 1e-5);
}

/// Plates that are too near, a wheel without a hub, and no wheel at all.
#[test]
fn what_cannot_be_is_refused_with_the_place() {
    let (blade, wheel) = sample::plates(60, 0.5);
    let e = planned(&blade, &options(wheel, 0.1), &Silent).unwrap_err();
    let s = (0.5 * TAU / 60.0).sin();
    let fits = (HUB_RADIUS * s - 0.5) / (1.0 - s);
    let Some(Infeasible::BladesTooClose { room_mm, radius_mm, .. }) = e.infeasible.as_deref() else { panic!("{e}") };
    assert!(*radius_mm == BALL && *room_mm <= fits && *room_mm > 0.995 * fits, "{room_mm} {fits}");
    assert!(e.kind == ErrorKind::Infeasible && e.message.contains("no room on the hub"), "{e}");

    let bare = sample::blade();
    let far = Wheel {
        axis: nalgebra::Unit::new_normalize(crate::geometry::Vector::z()),
        origin: Point::new(-300.0, 0.0, 0.0),
        blades: 12,
    };
    let e = planned(&bare, &options(far, 0.1), &Silent).unwrap_err();
    assert!(matches!(e.infeasible.as_deref(), Some(Infeasible::NoHub { .. })), "{e}");

    let none = PathOptions { hub_of: None, ..options(wheel, 0.1) };
    let e = planned(&blade, &none, &Silent).unwrap_err();
    assert!(e.kind == ErrorKind::Usage && e.message.contains("no wheel"), "{e}");
}
