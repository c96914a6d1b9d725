//! Readers on small texts; programs of all dialects are read back in the tests of the posts.
#![allow(clippy::unwrap_used)]

use super::*;
use crate::artifact::program::Programmed;
use crate::machine::Machine;

fn gcode(text: &str) -> Result<Vec<Block>> {
    read(
        text,
        Language {
            grammar: Grammar::Gcode,
            programmed: Programmed::Machine,
            shortest_way: false,
            feed_counts_degrees: false,
        },
    )
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
        ("G2 X1 F1", "without I, J, K or radius"),
        ("WIBBLE", "WIBBLE"),
        ("n1 wibble=5", "the word wibble=5 is not known: `n1 wibble=5`"),
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
    let language = Language {
        grammar: Grammar::Heidenhain,
        programmed: Programmed::Centre,
        shortest_way: true,
        feed_counts_degrees: false,
    };
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
    let language = Language {
        grammar: Grammar::Apt,
        programmed: Programmed::Tip,
        shortest_way: false,
        feed_counts_degrees: false,
    };
    let read = |text: &str| super::read(text, language).map(|s| s.blocks);
    let b = read("PARTNO/X\n$$ c\nRAPID\nGOTO/1,2,3,$\n0,0,1\nFEDRAT/20,MMPM\nGOTO/1,2,4,0,0,1\n").unwrap();
    assert_eq!((b.len(), b[0].line, b[0].feed, b[1].feed), (2, 5, Feed::Rapid, Feed::PerMinute(20.0)));
    assert!(read("GOTO/1,2").is_err() && read("FLY/1").is_err());
}

#[test]
fn steps_and_polynomials_of_g_code() {
    // The example of the manual: end, coefficients of p² and p³, PL the length of the interval;
    // what is left of p brings it to its end.
    let b = gcode(
        "N10 G1 X0 Y0 Z0 F600\nN11 UPATH POLY PO[X]=(1, 2.5, 0.7) PO[Y]=(0.3,1,3.2) PL=1.5\nX2 A=PO(10,4)\nG1 X3",
    )
    .unwrap();
    let bend = |b: &Block| if let Interpolation::Bent(bend) = b.course { Some(bend) } else { None };
    assert_eq!((b[0].course, b[3].course), (Interpolation::Straight, Interpolation::Straight));
    let of_y = bend(&b[2]).unwrap();
    let bend = bend(&b[1]).unwrap();
    assert_eq!(bend.point[0], [2.5 * 1.5 * 1.5, 0.7 * 1.5 * 1.5 * 1.5, 0.0, 0.0]);
    assert_eq!((bend.point[2], of_y.rotary[0]), ([0.0; 4], [4.0, 0.0, 0.0, 0.0]));
    let (tool, machine) = (crate::sample::tool(), Machine::demo().unwrap());
    let language = Language {
        grammar: Grammar::Gcode,
        programmed: Programmed::Machine,
        shortest_way: false,
        feed_counts_degrees: false,
    };
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
    assert_eq!(b[0].course, Interpolation::Straight);
}

fn language(grammar: Grammar, programmed: Programmed) -> Language {
    Language { grammar, programmed, shortest_way: false, feed_counts_degrees: false }
}

fn followed(text: &str, grammar: Grammar, programmed: Programmed) -> Result<Vec<Moved>> {
    let language = language(grammar, programmed);
    let (tool, machine) = (crate::sample::tool(), Machine::demo()?);
    let script = read(text, language)?;
    follow(&script.blocks, &Bench { language, zero: Zero::default(), tool: &tool, machine: &machine })
}

/// Every word that changes where the tool goes and is not read is refused with its line; the
/// program without it is read.
#[track_caller]
fn refused_between(before: &str, words: &[&str], after: &str, grammar: Grammar, programmed: Programmed) {
    for word in words {
        let number =
            |line: String, at: usize| if grammar == Grammar::Heidenhain { format!("{at} {line}") } else { line };
        let lines = [before, "\n", word, "\n", after].concat();
        let text: Vec<String> = lines.lines().enumerate().map(|(k, l)| number(l.to_owned(), k)).collect();
        let line = before.lines().count() + 1;
        let e = followed(&text.join("\n"), grammar, programmed).map(|m| m.len()).expect_err(word);
        let last = line + word.lines().count() - 1;
        let told = (line..=last).any(|l| e.message.starts_with(&format!("line {l} of the program")));
        assert!(told, "{word}: {}", e.message);
    }
    let without = [before, "\n", after].concat();
    let numbered = without.lines().enumerate().map(|(k, l)| match grammar {
        Grammar::Heidenhain => format!("{k} {l}\n"),
        _ => format!("{l}\n"),
    });
    assert!(followed(&numbered.collect::<String>(), grammar, programmed).is_ok(), "{before}");
}

#[test]
fn no_word_of_g_code_that_moves_or_changes_the_frame_is_passed_over() {
    let words = [
        "G10 L2 P1 X5",
        "G92 X0",
        "G92.1",
        "G51 X0 P2",
        "G51.1 X0",
        "G68.3 X0 Y0 Z0 R5",
        "G68 X0 Y0 I1 R5",
        "G16",
        "G7.1 C5",
        "G12.1",
        "G27 X0",
        "G29 X0",
        "G31 Z-5",
        "G33 Z5 K1",
        "G41 D1",
        "G42 D1",
        "G73 X1 Z-5 R1 Q1",
        "G76 X1 Z-5 R1",
        "G81 X1 Z-5 R1",
        "G83 X1 Z-5 R1 Q1",
        "G89 X1 Z-5",
        "G95 F0.1",
        "G96 S100",
        "G5.2 X1",
        "G6.2 X1",
        "G2.3 X1",
        "M98 P77",
        "M97 P7",
        "M198 P7",
        "M99",
        "M428",
        "G65 P9000",
        "G66 P9000",
        "X#1",
        "#<A>=5",
        "U5",
        "V5",
        "W5",
        "GOTO 5",
        "WHILE [#1 LT 5] DO1",
        "IF [1 EQ 1] GOTO 5",
        "o5 call",
        "o5 while [1]",
        "/X5",
        "X[1+2]",
        "G54.1 P3",
        "G52 A5",
        "G68.2 P1 X0 Y0 Z0 I0 J0 K0",
        "G53.1",
        "G4 X1 Y5",
        "G4 P1 F5",
        "G52 X1 M3",
        "G68 X0 Y0 R5 M30",
        "G2 X1",
        "G2 X1 I1 R1",
        "G2 X5 K3",
        "Z5 R3",
        "G90.1 G2 X5 I1",
    ];
    refused_between("G0 X0 Y0 Z0\nG1 X1 F100", &words, "X2\nM30", Grammar::Gcode, Programmed::Machine);
}

#[test]
fn no_word_of_siemens_that_moves_or_changes_the_frame_is_passed_over() {
    let words = [
        "SCALE X2",
        "ASCALE X2",
        "MIRROR X0",
        "AMIRROR X0",
        "ROTS X1 Y2",
        "AROTS X1",
        "CROTS X1 Y2",
        "ROT X1 Y2",
        "TRANS A5",
        "TRANS X5 M30",
        "CYCLE800(0,\"TC\",1,57,0,0,0,1,2,3,0,0,0,1)",
        "CYCLE800(0,\"TC\",0,192,0,0,0,1,2,3,0,0,0,1)",
        "CYCLE81(5,0,1,-5)",
        "MCALL CYCLE82(5,0,1,-5)",
        "HOLES1(0,0,0,5,5,3)",
        "POCKET3(5,0,1,-5)",
        "L77",
        "NAME",
        "NAME(5)",
        "CALL \"NAME\"",
        "EXTCALL \"NAME\"",
        "X=R5",
        "X=R1+1",
        "R5=R6",
        "X=SIN(5)",
        "DEF REAL Q",
        "GOTOF A",
        "REPEAT A B",
        "IF R1==1",
        "FROM A",
        "CIP X1 I1=2 J1=3",
        "CT X5",
        "ASPLINE",
        "BSPLINE",
        "TRACYL(20)",
        "TRANSMIT",
        "TCARR=1",
        "TOROT",
        "PAROT",
        "ORIRPY",
        "ORIEULER",
        "TOFFL=1",
        "G641 ADIS=5",
        "G147 DISR=5",
        "G75 X1=0",
        "G74 X1=0",
        "X=GP(5)",
        "AP=5 RP=5",
        "G110 X5",
        "M1=3 X5",
        "OFFN=1",
        "PRESETON(X,5)",
        "$P_UIFR[1]=CTRANS(X,5)",
        "G58 X5",
        "DIAMON",
    ];
    let before = "MSG(\"A\")\nG0 X0 Y0 Z0\nG1 X1 F100";
    refused_between(before, &words, "X2\nM30", Grammar::Gcode, Programmed::Machine);
}

#[test]
fn no_word_of_klartext_that_moves_or_changes_the_frame_is_passed_over() {
    let words = [
        "CYCL DEF 8.0 MIRROR IMAGE\nCYCL DEF 8.1 X",
        "CYCL DEF 10.0 ROTATION\nCYCL DEF 10.1 ROT+5",
        "CYCL DEF 11.0 SCALING",
        "CYCL DEF 19.0 WORKING PLANE",
        "CYCL DEF 26.0 AXIS-SPEC. SCALING",
        "CYCL DEF 247 DATUM SETTING",
        "CYCL DEF 200 DRILLING",
        "CYCL CALL",
        "CYCL DEF 7.0\nCYCL DEF 7.1 #5",
        "CYCL DEF 7.1 A+5",
        "PLANE VECTOR BX1 BY0 BZ0 NX0 NY0 NZ1 STAY",
        "PLANE EULER EULPR1 EULNU2 EULROT3 STAY",
        "PLANE AXIAL A+5 STAY",
        "PLANE RELATIV SPB+5 STAY",
        "PLANE SPATIAL SPA+1 SPB+0 SPC+0",
        "M140 MB MAX",
        "M140 MB5",
        "M92",
        "M94",
        "M97",
        "M99",
        "M89",
        "M110",
        "M116",
        "M118 X1",
        "M120 LA5",
        "M136",
        "M144",
        "CT X+5 Y+5",
        "CP IPA+90 DR+",
        "LP PR+5 PA+5",
        "RND R5",
        "CHF 5",
        "APPR LT X+1 Y+1",
        "DEP LT LEN5",
        "FL X+5",
        "FPOL X+0 Y+0",
        "C X+1 Y+1 DR+",
        "CR X+5 Y+0 DR+",
        "CR X+5 Y+0 R+5",
        "L X+Q5",
        "Q5 = Q6 + 1",
        "FN 1: Q5 = +Q1 + +5",
        "FN 9: IF +Q1 EQU +1 GOTO LBL 5",
        "CALL LBL 7",
        "CALL PGM OTHER",
        "L X+5 RL",
        "L X+5 RR F5",
        "FUNCTION TCPM F CONT AXIS POS PATHCTRL AXIS",
        "FUNCTION TCPM F TCP AXIS SPAT PATHCTRL AXIS",
        "FUNCTION PARAXMODE X Y W",
        "TRANS MIRROR AXIS X",
        "TRANS ROTATION ROT+5",
        "TRANS SCALE SCL2",
        "TOOL CALL 1 Z S1 DL+1",
        "TOOL CALL 1 Y S1",
        "SPL X+1",
        "LN X+1 NX0 NY0 NZ1",
        "L X+1 TX0 TY0 TZ1 A+5",
    ];
    let before = "BEGIN PGM A MM\nTOOL CALL 1 Z S1000 F100\nM128\nL X+0 Y+0 Z+0 FMAX";
    refused_between(before, &words, "L X+1\nM30", Grammar::Heidenhain, Programmed::Centre);
    refused_between("M3\nM4", &["BEGIN PGM A INCH"], "M30", Grammar::Heidenhain, Programmed::Centre);
}

#[test]
fn no_word_of_apt_that_moves_or_changes_the_frame_is_passed_over() {
    let words = [
        "MSYS/0,0,0,1,0,0",
        "MSYS/0,0,0,2,0,0,0,1,0",
        "TRANS/1,0,0",
        "ORIGIN/1,0,0",
        "TRACUT/M1",
        "ROTATE/TABLE,5",
        "ROTABL/5",
        "ROTHED/5",
        "COPY/1",
        "INDEX/1",
        "CALL/SUB",
        "CYCLE/DRILL,5",
        "CUTCOM/LEFT",
        "INSERT/G92",
        "AUXFUN/98",
        "PREFUN/92",
        "UNITS/INCHES",
        "UNITS/FEET",
        "ARC/1,2,3",
        "CIRCLE/0,0,0,0,0,1\nGOTO/1,0,0",
        "CIRCLE/0,0,0,0,0,1,9\nGOTO/1,0,0",
        "THREAD/TURN",
        "CLEARP/5",
        "RETRCT",
        "GOCLER",
        "PIVOTZ/5",
        "COUPLE/ON",
        "MODE/INCR",
        "$$-> CSYS / 0,1,0,0,1,0,0,0,0,0,1,0",
        "GOTO/1,2",
        "GOTO/1,2,3,4",
        "GOTO/A,B,C",
        "TLAXIS/1,2",
        "TLDATA/DRILL,5",
    ];
    refused_between("PARTNO/X\nFEDRAT/100\nGOTO/0,0,1", &words, "GOTO/1,0,0\nFINI", Grammar::Apt, Programmed::Tip);
}

#[test]
fn a_tool_axis_on_a_great_circle_stays_in_the_plane_of_its_ends() {
    let text = |how: &str| {
        format!(
            "TRAORI\n{how}\nG1 X0 Y0 Z0 A3=0 B3=0 C3=1 F100\nX10 A3=0.3 B3=0.6 C3=0.7\nY10 A3=-0.5 B3=0.7 C3=0.2\nM30"
        )
    };
    let machine = Machine::demo().unwrap();
    let off = |how: &str| {
        let moves = followed(&text(how), Grammar::Gcode, Programmed::Tip).unwrap();
        let mut worst = 0.0f64;
        for line in moves.chunk_by(|a, b| a.block == b.block).skip(1) {
            let axis = |m: &Moved, f: f64| machine.axis_at(&m.at(f));
            let (a, b) = (axis(&line[0], 0.0), axis(line.last().unwrap(), 1.0));
            let seconds: f64 = line.iter().map(|m| m.seconds.unwrap()).sum();
            assert!((seconds - 6.0).abs() < 1e-9, "{seconds}");
            let angle = a.angle(&b);
            for (k, m) in line.iter().enumerate() {
                for f in [0.0, 0.3, 0.7, 1.0] {
                    let share = (k as f64 + f) / line.len() as f64;
                    let want = (a * ((1.0 - share) * angle).sin() + b * (share * angle).sin()) / angle.sin();
                    worst = worst.max(axis(m, f).angle(&want));
                    let point = m.at(f)[machine.linear()[if line[0].line == 4 { 0 } else { 1 }]];
                    assert!((point - 10.0 * share).abs() < 1e-9, "{point}");
                }
            }
        }
        worst
    };
    let vectors = off("ORIWKS ORIVECT");
    assert!(vectors < 2e-6, "{vectors}");
    // Rotary axes that turn evenly leave it.
    let axes = off("ORIWKS ORIAXES");
    assert!(axes > 0.01, "{axes}");
}

#[test]
fn a_tilted_plane_is_where_the_kinematics_bring_it() {
    // Without a tilt the plane is that of positions of the axes with the tool's length (G43).
    let moves = |text: &str| followed(text, Grammar::Gcode, Programmed::Machine).unwrap();
    let (tool, machine) = (crate::sample::tool(), Machine::demo().unwrap());
    let pose = |m: &[Moved]| m.last().unwrap().pose(1.0, &tool, &machine);
    let flat = pose(&moves("G43 H1\nG0 X1410 Y5 Z30\nX1415 Y7\nM30"));
    let plane = pose(&moves("G43 H1\nG68.2 X0 Y0 Z0 I0 J0 K0\nG53.1\nG0 X1410 Y5 Z30\nX1415 Y7\nM30"));
    assert!((flat.centre - plane.centre).norm() < 1e-9 && flat.axis.angle(&plane.axis) < 1e-9, "{flat:?} {plane:?}");
    // A plane turned about X: the tool is square to it, and its zero stays.
    let at = |words: &str| pose(&moves(&format!("G43 H1\nG68.2 X1410 Y0 Z0 I0 J30 K0\nG53.1\nG0 {words}\nM30")));
    let (zero, up, across) = (at("X0 Y0 Z0"), at("X0 Y0 Z10"), at("X0 Y10 Z0"));
    let origin = pose(&moves("G43 H1\nG0 X1410 Y0 Z0\nM30"));
    assert!((zero.tip(tool.radius_mm) - origin.tip(tool.radius_mm)).norm() < 1e-9);
    assert!(((up.centre - zero.centre) - zero.axis * 10.0).norm() < 1e-9);
    assert!((across.centre - zero.centre).dot(&zero.axis).abs() < 1e-9);
    assert!((zero.axis.angle(&origin.axis).to_degrees() - 30.0).abs() < 1e-6);
    // A tool that is not square to it is reported.
    let e = followed("G68.2 X0 Y0 Z0 I0 J30 K0\nG0 X1 Y2 Z3", Grammar::Gcode, Programmed::Machine).unwrap_err();
    assert!(e.message.contains("line 2 of the program: the tool is 30.000° off"), "{}", e.message);
}

#[test]
fn nothing_is_cut_from_a_reference_position() {
    let text = |next: &str| format!("G0 X1 Y2 Z3\nG28 G91 Z0\nG90\n{next}\nG1 Z1 F100\nM30");
    assert!(followed(&text("G0 Z3"), Grammar::Gcode, Programmed::Machine).is_ok());
    let e = followed(&text("G0 X3"), Grammar::Gcode, Programmed::Machine).unwrap_err();
    assert!(e.message.contains("line 5 of the program: a move at a feed from where only"), "{}", e.message);
}

#[test]
fn a_dwell_keeps_what_its_line_says() {
    let script = read("G4 P1 M3\nG4 X2\nG0 X1\nG4 P1 M30", language(Grammar::Gcode, Programmed::Machine)).unwrap();
    assert_eq!((script.blocks.len(), script.end), (1, Some(4)));
    assert_eq!(script.blocks[0].setting.turning, crate::artifact::program::Turning::Right);
}

#[test]
fn calls_end() {
    for (text, names) in [
        ("M98 P5\nM30\nO5\nM98 P5\nM99", "more than 16 deep"),
        ("M98 P5\nM30\nO5\nG4 P1", "does not end"),
        ("M98 P5 L999999999\nM30\nO5\nM98 P6 L999999999\nM99\nO6\nM99", "more than 500000 lines"),
    ] {
        let e = gcode(text).unwrap_err();
        assert!(e.message.contains(names), "{text}: {}", e.message);
    }
    let script =
        read("G0 X1\nM98 P5\nM30\nO5\nX2\nM99\nO6\nX3\nM99", language(Grammar::Gcode, Programmed::Machine)).unwrap();
    // What is not called is not machined.
    assert_eq!((script.end, script.behind), (Some(3), vec![7, 8, 9]));
}

#[test]
fn splines_of_klartext() {
    let language = Language {
        grammar: Grammar::Heidenhain,
        programmed: Programmed::Centre,
        shortest_way: false,
        feed_counts_degrees: false,
    };
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

/// Curves of rank 2 to 4, with inner knots; what is not read of them is refused with its line.
#[test]
fn curves_of_g_code() {
    let head = "G90 G94 G1 X0 Y0 Z0 A0 F500\n";
    // Rank 4 with one inner knot; the control points are those of y = x² over 0 to 3, A = 2 x³:
    // products of knots.
    let good = "G06.2 P4 K0 X0 Y0 A0 F900\nK0 X0.3333333333 Y0 A0 (note)\nK0 X1.3333333333 Y1 A0\nK0 X2.3333333333 Y5 A18\n\
                K1 X3 Y9 A54\nK3\nK3\nK3\nK3\nG1 X4 F200\n";
    let text = format!("{head}{good}");
    let blocks = gcode(&text).unwrap();
    assert_eq!(blocks.len(), 4);
    assert_eq!((blocks[1].line, blocks[2].line, blocks[3].line), (5, 6, 11));
    assert_eq!((blocks[1].feed, blocks[3].feed), (Feed::PerMinute(900.0), Feed::PerMinute(200.0)));
    let moves = followed(&text, Grammar::Gcode, Programmed::Machine).unwrap();
    let machine = Machine::demo().unwrap();
    let ([x, y, _], a) = (machine.linear(), machine.turning_axis());
    for (m, [from, to]) in [(&moves[1], [0.0, 1.0]), (&moves[2], [1.0, 3.0])] {
        for f in [0.0, 0.2, 0.7, 1.0] {
            let (u, at): (f64, _) = (from + (to - from) * f, m.at(f));
            assert!((at[x] - u).abs() < 1e-9 && (at[y] - u * u).abs() < 1e-9, "{u}: {at:?}");
            assert!((at[a].to_degrees() - 2.0 * u.powi(3)).abs() < 1e-8, "{u}: {at:?}");
        }
    }
    // A polygon, and a parabola.
    let two = gcode(&format!("{head}G6.2 P2 K0 X0\nK0 X1\nK1 X3\nK2\nK2")).unwrap();
    assert_eq!(two.len(), 3);
    let three = gcode(&format!("{head}G6.2 P3 K0 X0\nK0 X1\nK0 X3\nK2\nK2\nK2")).unwrap();
    let Interpolation::Bent(bend) = three[1].course else { panic!("{:?}", three[1]) };
    assert_eq!(bend.point[0], [1.0, 0.0, 0.0, 0.0]);
    // Rank 4 where none is said.
    assert!(gcode(&format!("{head}{}", good.replace("P4 ", ""))).is_ok());
    for (from, to, says) in [
        ("P4", "P5", "rank P5"),
        ("P4", "P2.5", "rank P2.5"),
        ("K0 X0 Y0 A0", "K0", "without a control point"),
        ("K0 X1.3", "X1.3", "without its knot"),
        ("K1 X3", "K1 Z3", "does not name"),
        ("K1 X3", "K-1 X3", "smaller"),
        ("K0 X2.3", "K1 X2.3", "equal knots at either end"),
        ("K3\nK3\nK3\nK3", "K3\nK3\nK3\nK4", "equal knots at either end"),
        ("K1 X3", "K3 X3", "within the curve"),
        ("K3\nK3\nK3\nK3\nG1 X4 F200", "K3\nK3\nK3\nG1", "has 8 knots for 5 control points of rank 4: 9 are needed"),
        ("K3\nK3\nK3\nK3\nG1 X4 F200", "K3\nK3\nK3", "has 8 knots for 5 control points of rank 4: 9 are needed"),
        ("K3\nK3\nK3\nK3", "K3\nK3\nK3\nM30", "M30 within a curve"),
        ("K3\nK3\nK3\nK3", "K3\nK3\nK3\nK3\nK3", "behind the end of its curve"),
        ("K3\nK3\nK3\nK3", "K3\nX3 K3\nK3\nK3", "behind a knot that stands alone"),
        ("K0 X1.3", "K0 R2 X1.3", "weights"),
        ("K0 X1.3", "K0 I1 X1.3", "a vector within a curve"),
        ("K0 X1.3", "K0 F100 X1.3", "F100 within a curve"),
        ("K0 X1.3", "M8\nK0 X1.3", "M8 within a curve"),
        ("K0 X1.3", "G55\nK0 X1.3", "G55 within a curve"),
        ("K0 X1.3", "TRAFOOF\nK0 X1.3", "TRAFOOF within a curve"),
        ("K0 X1.3333333333", "K0 X=IC(1.3)", "steps within a curve"),
        ("G06.2", "G91 G06.2", "G90, G94"),
        ("G06.2", "G93 G06.2", "G90, G94"),
        ("G06.2", "G20 G06.2", "G90, G94"),
        ("G06.2", "G53 G06.2", "G90, G94"),
        ("K0 X1.3", "G91 K0 X1.3", "G91 within a curve"),
        ("K0 X1.3", "G06.2 K0 X1.3", "has 2 knots"),
    ] {
        let text = format!("{head}{}", good.replacen(from, to, 1));
        let refused = gcode(&text).map(|b| format!("{b:?}")).unwrap_err();
        assert!(refused.message.contains(says), "{from} -> {to}: {}", refused.message);
    }
    // Rapids and tools wait for the end of a curve, and it begins where the tool stands.
    assert!(gcode(&format!("{head}G06.2 K0 X0\nK0 X1\nG0 X3")).unwrap_err().message.contains("line 2 begins"));
    let off = followed(&text.replacen("G06.2 P4 K0 X0", "G06.2 P4 K0 X0.01", 1), Grammar::Gcode, Programmed::Machine);
    assert!(off.unwrap_err().message.contains("begins 0.01"));
}
