//! Readers on small texts; programs of all dialects are read back in the tests of the posts.
#![allow(clippy::unwrap_used)]

use super::*;
use crate::artifact::program::Programmed;

fn gcode(text: &str) -> Result<Vec<Block>> {
    read(text, Language { grammar: Grammar::Gcode, programmed: Programmed::Machine, shortest_way: false })
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
    assert_eq!(b[0].place, Place::Words { point: [Some(1.0), Some(-2.5), Some(3.0)], rotary: [None; 3] });
    assert_eq!(b[1].feed, Feed::PerMinute(100.0));
    assert_eq!(b[2].feed, Feed::PerMove(2.0));
    assert_eq!(
        (b[2].ways, b[2].place),
        ([Way::By, Way::To, Way::To], Place::Words { point: [None; 3], rotary: [Some(5.0), Some(3.0), None] })
    );
    assert!(b[3].machine && b[3].feed == Feed::Rapid);
}

#[test]
fn inches_are_read_as_millimetres_and_vectors_as_vectors() {
    let b = gcode("G20 G94\nG1 X1 I0 K2 F10\nTRAORI\nG71 G1 X1 A3=0 B3=0 C3=1").unwrap();
    assert_eq!(b[0].place, Place::Vector { point: [Some(25.4), None, None], axis: [0.0, 0.0, 2.0] });
    assert_eq!(
        (b[1].centre_point, b[1].place),
        (true, Place::Vector { point: [Some(1.0), None, None], axis: [0.0, 0.0, 1.0] })
    );
}

#[test]
fn what_is_not_understood_is_named_with_its_line() {
    for (text, names) in [
        ("G1 X1", "before any F"),
        ("G93 G1 X1 F2\nX2", "line 2"),
        ("G1 X1.2.3 F1", "not a number"),
        ("G91 G1 X1 F1", "G91"),
        ("G2 X1 I0 J1", "G2 is not known"),
        ("WIBBLE", "WIBBLE"),
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
    let text = "0 BEGIN PGM T MM\n1 ; c\n2 L Z+630,5 R0 FMAX M91\n3 FUNCTION TCPM F TCP AXIS POS PATHCTRL AXIS\n4 L X+1 A+350 F500 M8\n5 L A+10\n6 LN X+1 TX+0 TY+0 TZ+1\n7 END PGM T MM\n";
    let b = read(text, language).unwrap();
    assert_eq!(b.len(), 4);
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
    let b = read("PARTNO/X\n$$ c\nRAPID\nGOTO/1,2,3,$\n0,0,1\nFEDRAT/20,MMPM\nGOTO/1,2,4,0,0,1\n", language).unwrap();
    assert_eq!((b.len(), b[0].line, b[0].feed, b[1].feed), (2, 5, Feed::Rapid, Feed::PerMinute(20.0)));
    assert!(read("GOTO/1,2", language).is_err() && read("FLY/1", language).is_err());
    assert!(read(&format!("GOTO/{}", "1".repeat(80)), language).unwrap_err().message.contains("72"));
}
