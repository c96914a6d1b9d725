//! Readers on small texts; programs of all dialects are read back in the tests of the posts.
#![allow(clippy::unwrap_used)]

use super::*;
use crate::artifact::program::Programmed;
use crate::machine::Machine;

fn gcode(text: &str) -> Result<Vec<Block>> {
    read(text, Language { grammar: Grammar::Gcode, programmed: Programmed::Machine, shortest_way: false })
        .map(|s| s.blocks)
}

#[test]
fn words_modes_and_comments() {
    assert!(gcode("%\nO1 (a (b)\nG0 X1").unwrap_err().message.contains("line 2"));
    let b = gcode(
        "%\nO1 (a b)\nN10 G21 G90 G94 ; x\nG0X1Y-2.5Z3\nG01 X2 F100 (c)\nG93 G1 A=IC(5) B3. F2\nG53 G0 Z9\nM30\n",
    )
    .unwrap();
    assert_eq!(b.len(), 4);
    assert_eq!((b[0].line, b[0].feed), (4, Feed::Rapid));
    assert_eq!(b[0].place, Destination::Words { point: [Some(1.0), Some(-2.5), Some(3.0)], rotary: [None; 3] });
    assert_eq!(b[1].feed, Feed::PerMinute(100.0));
    assert_eq!(b[2].feed, Feed::PerMove(2.0));
    assert_eq!(
        (b[2].ways, b[2].place),
        (
            [RotaryWay::By, RotaryWay::To, RotaryWay::To],
            Destination::Words { point: [None; 3], rotary: [Some(5.0), Some(3.0), None] }
        )
    );
    assert!(b[3].machine && b[3].feed == Feed::Rapid);
}

#[test]
fn inches_are_read_as_millimetres_and_vectors_as_vectors() {
    let b = gcode("G20 G94 G43.5 H1\nG1 X1 I0 K2 F10\nTRAORI\nG71 G1 X1 A3=0 B3=0 C3=1").unwrap();
    assert_eq!(b[0].place, Destination::Vector { point: [Some(25.4), None, None], axis: [0.0, 0.0, 2.0] });
    assert_eq!(
        (b[1].centre_point, b[1].place),
        (true, Destination::Vector { point: [Some(1.0), None, None], axis: [0.0, 0.0, 1.0] })
    );
}

#[test]
fn what_is_not_understood_is_named_with_its_line() {
    for (text, names) in [
        ("G1 X1", "before any F"),
        ("G93 G1 X1 F2\nX2", "line 2"),
        ("G1 X1.2.3 F1", "X1.2.3 is not a number"),
        ("X0 POLY PO[X]=(1,2,3,4,5,6) F1", "more than degree 5"),
        ("X0 POLY PO[U]=(1,2) F1", "PO[U]"),
        ("X0 POLY PO[]=(1,2) F1", "PO[]"),
        ("POLY PO[X]=7 F1", "no polynomial"),
        ("POLY PO[X]=(1) PL=0 F1", "PL=0"),
        ("POLY PO[X]=(1,z) F1", "not a number"),
        ("POLY X1 A3=0 B3=0 C3=1 F1", "vectors under POLY"),
        ("G1 X=DC(1) F1", "rotary axes"),
        ("G2 X1 I0 J1", "G2: arcs are not read: `G2 X1 I0 J1`"),
        ("WIBBLE", "WIBBLE"),
        ("n1 r1=5", "the word r1=5 is not known: `n1 r1=5`"),
        ("TOFFL=-0.5", "the word TOFFL=-0.5 is not known"),
        ("G1 X1 F-3", "greater than 0"),
        ("G1 (X1", "without its )"),
    ] {
        let e = gcode(text).unwrap_err();
        assert!(e.message.contains(names), "{text}: {}", e.message);
    }
}

#[test]
fn klartext() {
    let language = Language { grammar: Grammar::Heidenhain, programmed: Programmed::Centre, shortest_way: true };
    let text = "0 BEGIN PGM T MM\n1 M126\n2 L Z+630,5 R0 FMAX M91\n3 FUNCTION TCPM F TCP AXIS POS PATHCTRL AXIS\n4 L X+1 A+350 F500 M8\n5 L A+10\n6 LN X+1 TX+0 TY+0 TZ+1\n7 END PGM T MM\n";
    let script = read(text, language).unwrap();
    let b = script.blocks;
    assert_eq!((b.len(), script.end), (4, Some(8)));
    assert!(b[0].machine && !b[0].centre_point && b[1].centre_point);
    assert_eq!(b[2].feed, Feed::PerMinute(500.0));
    let (tool, machine) = (crate::sample::tool(), Machine::demo().unwrap());
    let moved = follow(&b, &Bench { language, zero: Zero::default(), tool: &tool, machine: &machine }).unwrap();
    let turned = (moved[2].to[3] - moved[1].to[3]).to_degrees();
    assert!((turned - 20.0).abs() < 1e-9, "{turned}");
    for (bad, names) in [
        ("1 BEGIN", "must be 0"),
        ("0 LN X1 TX1 TY0", "TX, TY and TZ"),
        ("0 XYZ", "not known"),
        ("0 L X1", "before any F"),
    ] {
        assert!(read(bad, language).unwrap_err().message.contains(names));
    }
}

#[test]
fn apt() {
    let language = Language { grammar: Grammar::Apt, programmed: Programmed::Tip, shortest_way: false };
    let read = |text: &str| super::read(text, language).map(|s| s.blocks);
    let b = read("PARTNO/X\n$$ c\nRAPID\nGOTO/1,2,3,$\n0,0,1\nFEDRAT/20,MMPM\nGOTO/1,2,4,0,0,1\n").unwrap();
    assert_eq!((b.len(), b[0].line, b[0].feed, b[1].feed), (2, 5, Feed::Rapid, Feed::PerMinute(20.0)));
    assert!(read("GOTO/1,2").is_err() && read("FLY/1").is_err());
    assert!(read(&format!("GOTO/{}", "1".repeat(80))).unwrap_err().message.contains("72"));
}

#[test]
fn steps_and_polynomials_of_g_code() {
    // The example of the manual: end, coefficients of p² and p³, PL the length of the interval;
    // what is left of p brings it to its end.
    let b = gcode(
        "N10 G1 X0 Y0 Z0 F600\nN11 UPATH POLY PO[X]=(1, 2.5, 0.7) PO[Y]=(0.3,1,3.2) PL=1.5\nX2 A=PO(10,4)\nG1 X3",
    )
    .unwrap();
    assert_eq!((b[0].bend, b[3].bend), (None, None));
    let bend = b[1].bend.unwrap();
    assert_eq!(bend.point[0], [2.5 * 1.5 * 1.5, 0.7 * 1.5 * 1.5 * 1.5, 0.0, 0.0]);
    assert_eq!((bend.point[2], b[2].bend.unwrap().rotary[0]), ([0.0; 4], [4.0, 0.0, 0.0, 0.0]));
    let (tool, machine) = (crate::sample::tool(), Machine::demo().unwrap());
    let language = Language { grammar: Grammar::Gcode, programmed: Programmed::Machine, shortest_way: false };
    let m = follow(&b, &Bench { language, zero: Zero::default(), tool: &tool, machine: &machine }).unwrap();
    for p in [0.0, 0.4, 0.9, 1.5f64] {
        // x(p) = a₀ + a₁ p + 2.5 p² + 0.7 p³ with x(0) = 0 and x(1.5) = 1.
        let a1 = (1.0 - 2.5 * 2.25 - 0.7 * 3.375) / 1.5;
        let x = a1 * p + 2.5 * p * p + 0.7 * p.powi(3);
        assert!((m[1].at(p / 1.5)[0] - x).abs() < 1e-12);
    }
    assert!((m[2].at(0.5)[3].to_degrees() - (5.0 + 4.0 * (0.25 - 0.5))).abs() < 1e-12);
    assert!(m[1].even() != m[0].even());
    // The time is by the length of the curve, longer than its chord.
    assert!(m[1].seconds.unwrap() * 10.0 > 1.04f64.hypot(0.3));
    // Steps: all words under G91, single ones by IC(); AC() says where.
    let b = gcode("G1 X1 Y2 Z3 A10 F100\nG91 X1 A5\nY=AC(7) X=IC(-1)\nG90 X1 A=IC(5)\n").unwrap();
    let m = follow(&b, &Bench { language, zero: Zero::default(), tool: &tool, machine: &machine }).unwrap();
    let at = |k: usize| [m[k].to[0], m[k].to[1], m[k].to[3].to_degrees()];
    for (k, want) in [(1, [2.0, 2.0, 15.0]), (2, [1.0, 7.0, 15.0]), (3, [1.0, 7.0, 20.0])] {
        assert!(at(k).iter().zip(want).all(|(a, b)| (a - b).abs() < 1e-12), "{k}: {:?}", at(k));
    }
    // POLY that is off again: polynomials are not followed, as the control does not.
    let b = gcode("G1 PO[X]=(1,2) F1").unwrap();
    assert_eq!(b[0].bend, None);
}

#[test]
fn splines_of_klartext() {
    let language = Language { grammar: Grammar::Heidenhain, programmed: Programmed::Centre, shortest_way: false };
    let read = |text: &str| {
        let lines = ["BEGIN PGM S MM", "M128", "L X+1 Y+2 Z+3 A+10 F600", text];
        let numbered: Vec<String> = lines.iter().enumerate().map(|(i, l)| format!("{i} {l}")).collect();
        super::read(&numbered.join("\n"), language)
    };
    // x(t) = 0.5 t^3 - 0.2 t^2 - 1.3 t + 2, t from 1 to 0; A turns by 20 degrees, its factors with
    // exponents.
    let text = "SPL X+2 K3X+0.5 K2X-0.2 K1X-1.3 A+30 K3A+0.5 E+1 K2A-5.0E+0 K1A-2E1 F300";
    let b = read(text).unwrap().blocks;
    let (tool, machine) = (crate::sample::tool(), Machine::demo().unwrap());
    let bench = Bench { language, zero: Zero::default(), tool: &tool, machine: &machine };
    let m = follow(&b, &bench).unwrap();
    for p in [0.0, 0.3, 0.5, 1.0f64] {
        let t = 1.0 - p;
        let (x, a) = (0.5 * t.powi(3) - 0.2 * t * t - 1.3 * t + 2.0, 5.0 * t.powi(3) - 5.0 * t * t - 20.0 * t + 30.0);
        let at = m[1].at(p);
        assert!((at[0] - x).abs() < 1e-12 && (at[3].to_degrees() - a).abs() < 1e-9, "{p}: {at:?}");
        assert_eq!(at[1], 2.0);
    }
    for (bad, says) in [
        ("SPL X+2 K3X+0.5 K2X-0.2 F300", "K3, K2, K1 of every axis"),
        ("SPL X+2 K3X+0 K2X+0 K1X-1 K3Y+0 K2Y+0 K1Y+0 F300", "every axis that it names"),
        ("SPL X+2 K3X+0 K3X+0 K2X+0 K1X-1 F300", "a second word"),
        ("SPL X+2 K4X+0 K2X+0 K1X-1 F300", "is not known"),
        ("SPL K3X+0 F300", "goes nowhere"),
        ("SPL X+2 K3X+z K2X+0 K1X-1 F300", "not a number"),
    ] {
        let e = read(bad).unwrap_err();
        assert!(e.message.contains(says), "{bad}: {}", e.message);
    }
    // A spline that begins 2 micrometres off.
    let e = follow(&read("SPL X+2 K3X+0.5 K2X-0.2 K1X-1.302 F300").unwrap().blocks, &bench).unwrap_err();
    assert!(e.message.contains("0.002"), "{}", e.message);
}
