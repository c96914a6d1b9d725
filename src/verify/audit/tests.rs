//! Small programs as others might write them; faults of all dialects are planted in the tests of
//! the posts.
#![allow(clippy::unwrap_used)]

use super::*;
use crate::artifact::CheckId;
use crate::artifact::program::{Grammar, Language, Programmed};
use crate::machine::Machine;
use crate::observe::Silent;
use crate::read::program::Zero;
use crate::sample;

const ISO: Language = Language {
    grammar: Grammar::Gcode,
    programmed: Programmed::Machine,
    shortest_way: false,
    feed_counts_degrees: false,
};

fn run(text: &str, language: Language, zero: Zero) -> Result<Audit> {
    let (tool, machine) = (sample::tool(), Machine::demo().unwrap());
    let bench = Bench { language, zero, tool: &tool, machine: &machine };
    let options = AuditOptions::default().with(|s| s.surface_samples = 2000);
    audit(text, &sample::blade(), &bench, &options, &Silent)
}

fn find<'a>(audit: &'a Audit, name: &str) -> &'a LineCheck {
    audit.checks.iter().find(|c| c.check.id == name.parse().unwrap()).unwrap()
}

/// Over the top of the cylinder (radius 20) along x, B = 0: the tip is at height 20, the gauge line
/// 140 mm above it.
fn along(height: f64) -> String {
    format!("G90 G94 G0 A0 B0 S6000 M3\nG0 X1410 Y0 Z300\nG1 Z{height} F500\nG1 X1450\nG0 Z300\nM30\n")
}

#[test]
fn machine_axes_work_offsets_and_tool_lengths() {
    let clean = run(&along(160.0), ISO, Zero::default()).unwrap();
    assert!(clean.passed(), "{clean:?}");
    assert_eq!((clean.feed_moves, clean.rapids, clean.unknown_moves, clean.turns), (2, 3, 2, 1));
    assert!((clean.feed_mm - 180.0).abs() < 1e-9 && (clean.feed_s - 60.0 * 180.0 / 500.0).abs() < 1e-6);
    let deep = run(&along(159.99), ISO, Zero::default()).unwrap();
    let gouge = find(&deep, "gouge");
    assert!((gouge.check.worst - 0.01).abs() < 0.001 && gouge.line == Some(3), "{gouge:?}");
    assert_eq!(gouge.block.as_deref(), Some("G1 Z159.99 F500"));
    // Neither sign of B nor sense of A would mend it.
    assert!(!deep.checks.iter().any(|c| c.check.id == CheckId::BSign || c.check.id == CheckId::ASense));
    // The same with a work offset, and with the length to the tip by G43.
    let offset = Zero { axes_mm: [1400.0, 0.0, 100.0], ..Zero::default() };
    let text = along(60.0).replace("X14", "X").replace("Z300", "Z200");
    assert!(run(&text, ISO, offset).unwrap().passed());
    let long = along(20.0).replace("G0 A0", "G43 H1 G0 A0").replace("Z300", "Z160");
    assert!(run(&long, ISO, Zero::default()).unwrap().passed());
    assert!(!run(&along(20.0), ISO, Zero::default()).unwrap().passed());
}

#[test]
fn b_may_move_and_rapids_are_looked_at() {
    // The head swings away while the axes stand.
    let text = along(160.0).replace("G0 Z300\nM30", "G1 B-60 F500\nG0 Z300\nM30");
    let audit = run(&text, ISO, Zero::default()).unwrap();
    assert!(audit.passed(), "{audit:?}");
    assert!((audit.b_deg[0] + 60.0).abs() < 1e-9);
    let text = along(160.0).replace("G1 X1450\nG0 Z300", "G1 X1450\nG0 Z140\nG0 Z300");
    let audit = run(&text, ISO, Zero::default()).unwrap();
    let rapid = find(&audit, "rapid");
    assert!(rapid.check.worst < -4.9 && rapid.line == Some(5), "{rapid:?}");
    assert!(find(&audit, "gouge").check.passed);
    let far = run(&along(160.0).replace("Z300\nM30", "Z631\nM30"), ISO, Zero::default()).unwrap();
    let z = find(&far, "z-travel");
    assert!((z.check.worst - 1.0).abs() < 1e-9 && z.line == Some(5) && z.span_count == 1, "{z:?}");
}

#[test]
fn the_zero_may_be_turned_and_moved() {
    // In the CAD model's frame, as the sample's blade has it: tool tips under tool-centre-point
    // control.
    let tip = Language { programmed: Programmed::Tip, ..ISO };
    let blade = sample::blade();
    let block = |x: f64| {
        let (p, a) = (
            blade.model_from_blade * crate::geometry::Point::new(x, 20.0, 0.0),
            blade.model_from_blade.rotation * crate::geometry::Vector::y(),
        );
        format!("X{:.5} Y{:.5} Z{:.5} I{:.7} J{:.7} K{:.7}", p.x, p.y, p.z, a.x, a.y, a.z)
    };
    let text = format!("T1 M6 S6000 M3\nG43.5 H1\nG94 G1 F500 {}\nG1 {}\n", block(10.0), block(50.0));
    let zero = Zero { blade_from_program: blade.model_from_blade.inverse(), ..Zero::default() };
    let audit = run(&text, tip, zero).unwrap();
    assert!(find(&audit, "gouge").check.passed && (audit.feed_mm - 40.0).abs() < 1e-3, "{audit:?}");
    // Elsewhere there is nothing to cut.
    let elsewhere = run(&text, tip, Zero::default()).unwrap();
    assert!(!find(&elsewhere, "contact").check.passed);
}

#[test]
fn what_cannot_be_audited_is_one_sentence() {
    for (text, names) in [
        ("G1 X1 Y2 Z3", "before any F"),
        ("G0 X1 Y2\nM30", "no feed move"),
        ("G94 F1 G1 X1 Y2 Z500\nG2 X4 I1", "the arc begins 1.0000 mm from its centre and ends 2.0000 mm"),
        ("G94 F1 G0 X1 Y2 Z500 A0\nG1 A1000000000", "turns too far"),
    ] {
        let e = run(text, ISO, Zero::default()).unwrap_err();
        assert!(e.message.contains(names), "{text}: {}", e.message);
    }
}
