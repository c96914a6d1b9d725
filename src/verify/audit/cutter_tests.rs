//! Programs of bull-nose and flat cutters, and faults planted in them. Programs and depths are made
//! from closed forms of these tests, not from what is tested.
#![allow(clippy::unwrap_used)]

use super::*;
use crate::artifact::CheckId;
use crate::artifact::program::{Grammar, Language, Programmed};
use crate::geometry::exact::tests::{block, can};
use crate::geometry::part::Part;
use crate::geometry::{Point, Rigid, Vector};
use crate::machine::Machine;
use crate::observe::Silent;
use crate::read::program::Zero;
use crate::sample;
use std::fmt::Write;

const TIPS: Language =
    Language { grammar: Grammar::Gcode, programmed: Programmed::Tip, shortest_way: false, feed_counts_degrees: false };
/// Cutter and corner, mm; the lead of the axis, rad.
const RADIUS: f64 = 8.0;
const CORNER: f64 = 2.0;
const LEAD: f64 = 0.09;
/// Radius of the round part, height of the top of the flat one, mm.
const TOP: f64 = 20.0;

fn tool(corner: f64) -> Tool {
    let corner_radius_mm = Some(corner);
    Tool { radius_mm: RADIUS, corner_radius_mm, taper_deg: 0.0, shank_radius_mm: RADIUS, ..sample::tool() }
}

/// A block with its top at y = 20.
fn flat() -> Blade {
    let part = Part::from_brep(block(Vector::new(60.0, 10.0, 40.0)), 0.05, &Silent).unwrap();
    Blade { part: part.moved(&Rigid::translation(0.0, TOP - 10.0, -20.0)), ..sample::blade() }
}

/// A cylinder of radius 20 about x.
fn round() -> Blade {
    let part = Part::from_brep(can(TOP, 60.0), 0.05, &Silent).unwrap();
    let x_from_z = Rigid::rotation(Vector::y() * std::f64::consts::FRAC_PI_2);
    Blade { part: part.moved(&x_from_z), ..sample::blade() }
}

/// The tip of the cutter that touches at `p` with the normal `n`, its axis leaning by [`LEAD`] from
/// that towards the unit vector `t` across it: the disc's point over the contact lies back from its
/// centre by `cos` along `t`, and the centre over it by `sin`.
fn tip_and_axis(p: Point, n: Vector, t: Vector) -> (Point, Vector) {
    let (s, c) = LEAD.sin_cos();
    let axis = n * c + t * s;
    let centre = p + n * CORNER + (n * s - t * c) * (RADIUS - CORNER);
    (centre - axis * CORNER, axis)
}

/// What is changed at each place.
type Fault<'a> = &'a dyn Fn(&mut (Point, Vector), Vector);

const SOUND: Fault = &|_, _| {};

fn line(out: &mut String, (p, a): (Point, Vector)) {
    let _ = writeln!(out, "G1 X{:.6} Y{:.6} Z{:.6} I{:.9} J{:.9} K{:.9}", p.x, p.y, p.z, a.x, a.y, a.z);
}

/// Rows along x on the block's top, `pitch` apart, each from a place over it to another.
fn rows(pitch: f64, fault: Fault) -> String {
    let mut out = "T1 M6 S6000 M3\nG43.5 H1\nG94 G1 F500\n".to_owned();
    for k in -6..=6 {
        for (x, up) in [(12.0, 6.0), (12.0, 0.0), (25.0, 0.0), (48.0, 0.0), (48.0, 6.0)] {
            let mut at = tip_and_axis(Point::new(x, TOP, f64::from(k) * pitch), Vector::y(), Vector::x());
            fault(&mut at, Vector::y());
            at.0.y += up;
            line(&mut out, at);
        }
    }
    out + "M30\n"
}

/// Turns round the cylinder, the axis leading along the feed, a quarter of a degree a line.
fn helix(pitch: f64, fault: Fault) -> String {
    let mut out = "T1 M6 S6000 M3\nG43.5 H1\nG94 G1 F500\n".to_owned();
    for k in 0..=3 * 1440 {
        let turns = f64::from(k) / 1440.0;
        let (s, c) = (std::f64::consts::TAU * turns).sin_cos();
        let (n, t) = (Vector::new(0.0, c, s), Vector::new(0.0, -s, c));
        let mut at = tip_and_axis(Point::from(n * TOP + Vector::x() * (25.0 + pitch * turns)), n, t);
        fault(&mut at, n);
        line(&mut out, at);
    }
    out + "M30\n"
}

fn judged(text: &str, blade: &Blade, tool: &Tool, scallop_mm: f64) -> Audit {
    let machine = Machine::demo().unwrap();
    let bench = Bench { language: TIPS, zero: Zero::default(), tool, machine: &machine };
    let options =
        AuditOptions { scallop_mm: Some(scallop_mm), ..AuditOptions::default() }.with(|s| s.surface_samples = 6000);
    audit(text, blade, &bench, &options, &Silent).unwrap()
}

fn find(audit: &Audit, id: CheckId) -> &LineCheck {
    audit.checks.iter().find(|c| c.check.id == id).unwrap()
}

/// Height of the ridge between passes: the balls of the corner go with the rim of the disc, and
/// seen across the feed each leaves the deepest place of its circle. On the round part the balls
/// beside the contact run behind it, and so farther from the axis.
fn ridge(pitch: f64, is_round: bool) -> f64 {
    let (disc, (s, c)) = (RADIUS - CORNER, LEAD.sin_cos());
    let height = |phi: f64| {
        let (aside, back) = (disc * phi.sin(), disc * (1.0 - phi.cos()));
        let up = CORNER + back * s;
        let over = if is_round { (TOP + up).hypot(back * c) - TOP } else { up };
        over - (CORNER * CORNER - (0.5 * pitch - aside).powi(2)).max(0.0).sqrt()
    };
    let (mut low, mut high) = (0.0, 0.6);
    for _ in 0..80 {
        let (a, b) = (low + 0.382 * (high - low), low + 0.618 * (high - low));
        if height(a) < height(b) { high = b } else { low = a }
    }
    height(0.5 * (low + high))
}

#[test]
fn sound_programs_pass_and_their_ridges_are_measured() {
    let tool = tool(CORNER);
    for pitch in [2.0, 3.0] {
        let [ridge, on_round] = [ridge(pitch, false), ridge(pitch, true)];
        let rows = judged(&rows(pitch, SOUND), &flat(), &tool, ridge);
        let gouge = &find(&rows, CheckId::Gouge).check;
        assert!(gouge.passed && gouge.worst < 0.0006, "{gouge:?}");
        assert!(find(&rows, CheckId::Scallop).check.passed && find(&rows, CheckId::Contact).check.passed);
        assert!(find(&rows, CheckId::Clearance).check.passed && find(&rows, CheckId::HolderClearance).check.passed);
        assert!(((rows.scallop_max_mm / ridge).sqrt() - 1.0).abs() < 0.01, "{pitch}: {} {ridge}", rows.scallop_max_mm);
        // Stepovers go with the root of the ridge.
        let turns = judged(&helix(pitch, SOUND), &round(), &tool, on_round);
        let gouge = &find(&turns, CheckId::Gouge).check;
        assert!(gouge.passed && gouge.worst < 0.001, "{gouge:?}");
        assert!(
            ((turns.scallop_max_mm / on_round).sqrt() - 1.0).abs() < 0.01,
            "{pitch}: {} {on_round}",
            turns.scallop_max_mm
        );
        assert!(turns.turns >= 3 && find(&turns, CheckId::Scallop).check.passed);
    }
}

#[test]
fn five_micrometres_too_deep_are_found() {
    let deeper: Fault = &|at, n| at.0 -= n * 0.005;
    for (text, blade) in [(rows(1.2, deeper), flat()), (helix(1.2, deeper), round())] {
        let gouge = find(&judged(&text, &blade, &tool(CORNER), 0.01), CheckId::Gouge).clone();
        assert!(!gouge.check.passed && (gouge.check.worst - 0.005).abs() < 0.0008, "{gouge:?}");
        assert!(gouge.line.is_some() && gouge.span_count > 0, "{gouge:?}");
    }
}

/// Half a degree more lead turns the heel into the part; half a degree less leaves a gap, which is
/// found as height.
#[test]
fn an_axis_turned_by_half_a_degree_is_found() {
    let by = 0.5f64.to_radians();
    let turned = |by: f64| {
        move |at: &mut (Point, Vector), n: Vector| {
            let across = (at.1 - n * at.1.dot(&n)).normalize();
            at.1 = n * (LEAD + by).cos() + across * (LEAD + by).sin();
        }
    };
    // How much lower the rim hangs with the same tip.
    let low = |lead: f64| (RADIUS - CORNER) * lead.sin() + CORNER * (1.0 - lead.cos());
    let deep = low(LEAD + by) - low(LEAD);
    for (text, blade) in [(rows(1.2, &turned(by)), flat()), (helix(1.2, &turned(by)), round())] {
        let gouge = find(&judged(&text, &blade, &tool(CORNER), 0.01), CheckId::Gouge).clone();
        // On the round part the rim comes down beside the contact.
        assert!(
            !gouge.check.passed && gouge.check.worst > 0.6 * deep && gouge.check.worst < 1.03 * deep,
            "{deep} {gouge:?}"
        );
    }
    // With half a degree less the cutter is no longer at the part at all, with a fifth of one it
    // leaves so much more.
    let off = judged(&rows(1.2, &turned(-by)), &flat(), &tool(CORNER), 0.01);
    assert!(!find(&off, CheckId::Contact).check.passed, "{off:?}");
    let by = 0.4 * by;
    let left = low(LEAD) - low(LEAD - by);
    let found = judged(&rows(1.2, &turned(-by)), &flat(), &tool(CORNER), 0.01);
    assert!(find(&found, CheckId::Gouge).check.passed);
    let scallop = find(&found, CheckId::Scallop);
    assert!(!scallop.check.passed && scallop.check.worst > left, "{left} {scallop:?}");
}

/// A corner that is a tenth of a millimetre smaller than that of the program cuts, one that is
/// greater leaves material, by as much on a plane.
#[test]
fn another_corner_is_found() {
    let by = 0.1 * (LEAD.sin() + LEAD.cos() - 1.0);
    let text = rows(1.2, SOUND);
    let sharp = find(&judged(&text, &flat(), &tool(CORNER - 0.1), 0.01), CheckId::Gouge).clone();
    assert!(!sharp.check.passed && (sharp.check.worst - by).abs() < 0.0008, "{by} {sharp:?}");
    let ridge = ridge(1.2, false);
    let blunt = judged(&text, &flat(), &tool(CORNER + 0.1), ridge);
    assert!(find(&blunt, CheckId::Gouge).check.passed);
    let scallop = find(&blunt, CheckId::Scallop);
    assert!(!scallop.check.passed && scallop.check.worst > by, "{by} {scallop:?}");
}

/// Where the corner is nearly as round as the cutter the answers are those of the ball.
#[test]
fn nearly_a_ball_is_judged_as_one() {
    let text = rows(0.6, SOUND);
    let [ball, bull] = [None, Some(RADIUS - 1e-7)].map(|corner_radius_mm| {
        let tool = Tool { corner_radius_mm, ..tool(CORNER) };
        judged(&text, &flat(), &tool, 0.01)
    });
    for id in [CheckId::Gouge, CheckId::Clearance, CheckId::HolderClearance] {
        let [a, b] = [&ball, &bull].map(|audit| find(audit, id.clone()).check.worst);
        assert!((a - b).abs() < 0.02 * a.abs() + 0.001, "{id}: {a} {b}");
    }
}

#[test]
fn what_cannot_be_judged_with_a_corner_is_one_sentence() {
    let (machine, blade) = (Machine::demo().unwrap(), flat());
    let own = tool(0.05);
    let bench = Bench { language: TIPS, zero: Zero::default(), tool: &own, machine: &machine };
    let text = rows(1.2, SOUND);
    for (options, says) in [
        (AuditOptions { map_mm: Some(0.001), ..AuditOptions::default() }, "deviation maps are made for ball-end"),
        (AuditOptions::default().with(|s| s.gouge_mm = 0.06), "gouges of 0.06 mm are allowed"),
    ] {
        let e = audit(&text, &blade, &bench, &options, &Silent).unwrap_err();
        assert!(e.message.contains(says), "{}", e.message);
    }
    let e = crate::verify::audit::audit(
        &text,
        &blade,
        &Bench { tool: &tool(9.0), ..bench },
        &AuditOptions::default(),
        &Silent,
    );
    assert!(e.unwrap_err().message.contains("must not be greater"));
}

/// A flat cutter with the corner that such cutters have.
#[test]
fn a_flat_cutter_is_judged() {
    let corner = 0.05;
    let lead = |p: Point| {
        let (s, c) = LEAD.sin_cos();
        let axis = Vector::y() * c + Vector::x() * s;
        (p + Vector::y() * corner + (Vector::y() * s - Vector::x() * c) * (RADIUS - corner) - axis * corner, axis)
    };
    for (deep, passes) in [(0.0, true), (0.005, false)] {
        let mut text = "T1 M6 S6000 M3\nG43.5 H1\nG94 G1 F500\n".to_owned();
        for x in [14.0, 30.0, 47.0] {
            line(&mut text, lead(Point::new(x, TOP - deep, 0.0)));
        }
        let found = judged(&text, &flat(), &tool(corner), 0.01);
        let gouge = &find(&found, CheckId::Gouge).check;
        assert!(gouge.passed == passes && (gouge.worst - deep).abs() < 0.0008, "{gouge:?}");
        assert!(find(&found, CheckId::Clearance).check.passed, "{found:?}");
    }
}
