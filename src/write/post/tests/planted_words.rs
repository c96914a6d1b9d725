//! Words planted one by one into programs of every grammar: each decides where the tool goes, with
//! which tool, in which frame or unit, or whether the program goes on. Each must be refused with
//! its line or be a finding, whoever wrote the program; what is harmless must stay so.

use super::planted::Shop;
use super::*;
use crate::artifact::CheckId;
use crate::error::Result;
use crate::verify::audit::{Audit, AuditOptions, audit};

/// Where a text is changed.
#[derive(Clone, Copy, Debug)]
enum Edit {
    /// A line behind the one in the middle of the cut.
    Line(&'static str),
    /// The first of the one becomes the other.
    Word(&'static str, &'static str),
    /// The file ends in the middle of the cut.
    CutOff,
}

/// What must come of it: no reading, a finding, one or the other, or nothing.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Told {
    Refused,
    Found(&'static str),
    Felt,
    Nothing,
}

use Edit::{CutOff, Line, Word};
use Told::{Felt, Found, Nothing, Refused};

/// A fault, what comes of it in a program of others, and in an own one.
type Fault = (Edit, Told, Told);

const fn both(edit: Edit, name: &'static str, own: &'static str) -> Fault {
    (edit, Found(name), Found(own))
}

const fn refused(line: &'static str) -> Fault {
    (Line(line), Refused, Refused)
}

/// A line that is read, and leads the tool elsewhere.
const fn led(line: &'static str) -> Fault {
    (Line(line), Felt, Felt)
}

/// A line that does nothing before another uses what it says.
const fn idle(line: &'static str) -> Fault {
    (Line(line), Nothing, Nothing)
}

const fn ended(line: &'static str) -> Fault {
    both(Line(line), "end", "program-end")
}

const fn spindle(edit: Edit) -> Fault {
    both(edit, "spindle", "program-spindle")
}

const fn length(edit: Edit) -> Fault {
    both(edit, "tool-length", "program-tool-length")
}

const fn smoothing(edit: Edit) -> Fault {
    both(edit, "smoothing", "program-smoothing")
}

/// Of all G code.
const GCODE: &[Fault] = &[
    ended("M30"),
    ended("M2"),
    ended("M02"),
    ended("M17"),
    ended("RET"),
    ended("%"),
    both(CutOff, "end", "program-end"),
    refused("M98 P100"),
    refused("M99"),
    refused("M198 P1"),
    refused("M97 P1"),
    refused("M140"),
    refused("G65 P100"),
    refused("O100 CALL"),
    refused("O2"),
    spindle(Line("M5")),
    spindle(Line("M4")),
    spindle(Line("M14")),
    spindle(Line("M19")),
    spindle(Line("S600000")),
    spindle(Line("S0 M3")),
    spindle(Word(" M3\n", "\n")),
    (Line("S3000"), Nothing, Found("program-spindle")),
    (Line("T2 M6"), Found("tool"), Refused),
    (Word("T1 M6", "T0 M6"), Found("tool"), Found("program-tool")),
    (Word("G54\n", "G55\n"), Nothing, Found("program-frame")),
    refused("G55"),
    refused("G54.1 P1"),
    refused("G54 P2"),
    led("G68 X0 Y0 R30"),
    refused("G51 X0 Y0 P2"),
    led("G52 Z-5"),
    refused("G92 X0"),
    refused("G10 L2 P1 X5"),
    led("G28 X0"),
    refused("G81 X0 Y0 Z-5 R2 F100"),
    idle("G18"),
    refused("G41 D1"),
    refused("G95"),
    refused("G2 X1 Y1 I1 J0 F1"),
    refused("G3 X1 Y1 I1 J0 F1"),
    refused("G5 X1 Y1 I1 J0 P0 Q1"),
    refused("G5.1 X1 Y1 I1 J0"),
    refused("G50 X0 Z0"),
    idle("#1=5"),
    refused("/G1 X5 F1"),
];

const SIEMENS: &[Fault] = &[
    length(Line("D0")),
    length(Line("D2")),
    (Word("D1\n", "D5\n"), Nothing, Found("program-tool-length")),
    (Word("T1 M6", "T7 M6"), Nothing, Found("program-tool")),
    smoothing(Word("CYCLE832(0.", "CYCLE832(5.")),
    (Word("CYCLE832(0.", "CYCLE832() ; (0."), Nothing, Found("program-smoothing")),
    (Word("ORIWKS ORIAXES", "ORIWKS"), Nothing, Found("program-smoothing")),
    (Line("ORIVECT"), Nothing, Found("program-smoothing")),
    led("TRANS Y5"),
    led("ATRANS Y5"),
    led("ROT Z30"),
    refused("SCALE X2"),
    refused("MIRROR X0"),
    led("CYCLE800(1,\"\",0,57,0,0,0,30,0,0,0,0,0,1)"),
    refused("CYCLE81(100,0,2,-50)"),
    refused("CYCLE832(0.002,11,1) G1 X5 F1"),
    refused("G500"),
    refused("L100"),
    refused("SUB1"),
    refused("CALL \"A\""),
    refused("GOTOF END"),
    idle("R1=5"),
    refused("TOFFL=-0.5"),
    refused("FGROUP(X,Y,Z,A)"),
    refused("TRAORI(2)"),
    (Line("TRAFOOF"), Refused, Refused),
    (Line("G1 X=IC(26) F2000"), Found("x-velocity"), Found("program-centre")),
];

const FANUC: &[Fault] = &[
    refused("G49"),
    length(Line("H0")),
    length(Line("G43 H2")),
    length(Line("G43.4 H2")),
    length(Line("G43.4 H99")),
    length(Word("G43.4 H1", "G43.4 H99")),
    (Word("G43.4 H1 ", "G43.4 "), Refused, Refused),
    (Word("T1 M6", "T7 M6"), Found("tool-length"), Found("program-tool")),
    led("G68.2 X0 Y0 Z0 I0 J30 K0"),
    refused("G1 X1 I0 J0 K1 F1"),
];

const LINUXCNC: &[Fault] = &[
    length(Line("G43 H2")),
    length(Line("G43 H1")),
    refused("G43"),
    (Word("T1 M6", "T7 M6"), Nothing, Found("program-tool")),
    smoothing(Word("G64 P0.00200", "G64 P5.0")),
    (Word("G64 P0.00200", "G64"), Nothing, Found("program-smoothing")),
];

const HEIDENHAIN: &[Fault] = &[
    ended("M30"),
    ended("M2"),
    ended("STOP M30"),
    ended("END PGM CYL_ROOT MM"),
    both(CutOff, "end", "program-end"),
    refused("M97"),
    refused("M98 P1"),
    refused("M99"),
    refused("M140 MB MAX"),
    refused("M92"),
    refused("M136"),
    refused("CYCL CALL"),
    idle("CYCL DEF 7.0 DATUM SHIFT"),
    led("CYCL DEF 7.1 Y+5"),
    refused("CYCL DEF 8.0 MIRROR IMAGE"),
    refused("CYCL DEF 10.0 ROTATION"),
    refused("CYCL DEF 11.0 SCALING"),
    refused("CYCL DEF 19.0 WORKING PLANE"),
    refused("CYCL DEF 26.0 AXIS-SPEC. SCALING"),
    led("PLANE SPATIAL SPA+0 SPB+30 SPC+0 STAY"),
    led("TRANS DATUM AXIS Y+5"),
    refused("CALL LBL 1"),
    refused("CALL PGM A"),
    idle("FN 0: Q1 = +5"),
    idle("CC X+0 Y+0"),
    refused("L X+1 RL F100"),
    led("L IY-30 IZ-30 F100"),
    refused("FUNCTION TCPM F CONT AXIS SPAT PATHCTRL VECTOR"),
    refused("FUNCTION TCPM F TCP AXIS POS PATHCTRL AXIS REFPNT TIP-TIP"),
    refused("FUNCTION RESET TCPM"),
    refused("M129"),
    refused("TOOL CALL 1 Z S6000 DL-5"),
    refused("TOOL CALL 1 Z S6000 DR+1"),
    refused("TOOL CALL 1 Z S6000 DR2:+0,1"),
    (Line("TOOL CALL 0 Z"), Found("tool"), Refused),
    (Line("TOOL CALL 2 Z S6000"), Found("tool"), Refused),
    (Word("TOOL CALL 1 Z", "TOOL CALL 0 Z"), Found("tool-length"), Found("program-tool-length")),
    (Word("TOOL CALL 1 Z", "TOOL CALL 7 Z"), Nothing, Found("program-tool")),
    spindle(Line("M5")),
    spindle(Line("M4")),
    spindle(Line("M14")),
    spindle(Line("TOOL CALL S600000")),
    spindle(Line("TOOL CALL Z S0")),
    smoothing(Line("CYCL DEF 32.1 T5.0")),
    (Word(" MM\n", " INCH\n"), Refused, Refused),
];

const APT: &[Fault] = &[
    ended("FINI"),
    ended("END"),
    both(CutOff, "end", "program-end"),
    (Word("UNITS/MM", "UNITS/INCHES"), Found("contact"), Found("program-missing")),
    refused("UNITS/INCHES"),
    refused("TRANS/5,0,0"),
    refused("ROTATE/30"),
    refused("CYCLE/DRILL,5,MMPM,100"),
    refused("CUTCOM/LEFT"),
    refused("MULTAX/OFF"),
    led("GODLTA/0,-30,-30"),
    refused("CIRCLE/0,0,0,5"),
    refused("MODE/INCR"),
    spindle(Line("SPINDL/OFF")),
    spindle(Line("SPINDL/6000,CCLW")),
    spindle(Line("SPINDL/600000,CLW")),
    (Line("LOADTL/2"), Found("tool"), Refused),
    (Word("LOADTL/1", "LOADTL/7"), Nothing, Found("program-tool")),
    both(Word("CUTTER/10.000000,5.000000", "CUTTER/12.000000,6.000000"), "tool", "program-tool"),
];

/// What changes nothing wherever it stands.
fn harmless(control: Control) -> Vec<&'static str> {
    let lines = match control {
        Control::Siemens => {
            "; a comment|N1|MSG(\"a word; another\")|M0|M1|M7|M8|M9|M3|S6000|G17|G40|G80|G9|G60|G601|G602|G603|G642|G645|G64|D1|SOFT|BRISK\
             |FFWON|FFWOF|COMPCAD|COMPCURV|COMPSURF|COMPON|COMPOF|STOPRE|CDOF|CDOF2|FNORM|DYNNORM|DYNPOS|DYNROUGH|DYNSEMIFIN|DYNFINISH\
             |CYCLE800()|FGROUP()|FGROUP(X,Y,Z)|POLYPATH()|POLYPATH(\"AXES\",\"VECT\")|UPATH|SPATH|ORIWKS|ORIMKS|M10|M11|M41|T2|G54\
             |CYCLE832(0.001,11,0.05)|CYCLE832(0.001,_FINISH,1)|G93"
        }
        Control::Fanuc | Control::Linuxcnc => {
            "(a comment)|N1|M0|M1|M7|M8|M9|M3|M13|S6000|G17|G40|G69|G80|G98|G99|G97|G61|G61.1|G50|G90.1|G91.1|G5.1 Q1|G5.1 Q0\
             |G05 P10000|G05 P0|G08 P1|G08 P0|T2|G54|M48|M49|G21|G90"
        }
        Control::HeidenhainVector => {
            "; a comment|* - structure|M0|M1|STOP|STOP M8|M3|M8|M9|M13|M7|M126|BLK FORM 0.1 Z X-50 Y-50 Z-20|BLK FORM 0.2 X+50 Y+50 Z+0\
             |CYCL DEF 9.0 DWELL TIME|CYCL DEF 9.1 DWELL 1|CYCL DEF 32.0 TOLERANCE|CYCL DEF 32.1 T0.002|CYCL DEF 32.2 HSC-MODE:1 TA0.5\
             |TOOL DEF 2|TOOL CALL S6000|M128|M128 F1000|FUNCTION MODE MILL|PLANE RESET STAY\
             |FUNCTION TCPM F TCP AXIS POS PATHCTRL AXIS REFPNT CENTER-CENTER"
        }
        _ => {
            "$$ a comment|PPRINT/a word|REMARK a word|STOP|OPSTOP|COOLNT/ON|COOLNT/OFF|MACHIN/ANY,1|MULTAX/ON|UNITS/MM|SPINDL/6000,CLW"
        }
    };
    lines.split('|').collect()
}

const CONTROLS: [Control; 5] =
    [Control::Siemens, Control::Fanuc, Control::Linuxcnc, Control::HeidenhainVector, Control::Apt];

/// The faults of a control's grammar.
fn faults(control: Control) -> Vec<Fault> {
    match control {
        Control::Siemens => [GCODE, SIEMENS].concat(),
        Control::Fanuc => [GCODE, FANUC].concat(),
        Control::Linuxcnc => [GCODE, LINUXCNC].concat(),
        Control::Apt => APT.to_vec(),
        _ => HEIDENHAIN.to_vec(),
    }
}

struct Bench {
    shop: Shop,
    plan: Plan,
    /// The line in the middle of the cut.
    middle: usize,
}

impl Bench {
    fn new(control: Control) -> Self {
        let plan = sample::plan(2, 90);
        let shop = Shop::new(control, &sample::blade(), &plan);
        let moves = shop.moves(&shop.program.text);
        let feeds: Vec<usize> = moves.iter().filter(|m| m.seconds.is_some()).map(|m| m.line).collect();
        Bench { shop, plan, middle: feeds[feeds.len() / 2] }
    }

    fn edited(&self, edit: Edit) -> String {
        let text = &self.shop.program.text;
        match edit {
            Line(line) => self.inserted(&[line]),
            Word(from, to) => {
                assert!(text.contains(from), "{:?}: {from}", self.shop.control);
                text.replacen(from, to, 1)
            }
            CutOff => text.lines().take(self.middle).map(|l| format!("{l}\n")).collect(),
        }
    }

    fn inserted(&self, new: &[&str]) -> String {
        let numbered =
            matches!(self.shop.control, Control::Heidenhain | Control::HeidenhainSpl | Control::HeidenhainVector);
        let mut lines: Vec<String> = self.shop.program.text.lines().map(String::from).collect();
        let new = new.iter().map(|l| if numbered { format!("0 {l}") } else { (*l).to_owned() });
        lines.splice(self.middle..self.middle, new);
        self.shop.numbered(lines)
    }

    fn theirs(&self, text: &str) -> Result<Audit> {
        // Few long moves along a coarse part: what is planted is not a matter of micrometres.
        let options = AuditOptions::default().with(|s| (s.surface_samples, s.gouge_mm) = (500, 0.05));
        audit(text, &self.shop.blade, &self.shop.bench(), &options, &crate::observe::Silent)
    }

    /// Names of what fails, and the line of the first of them, by an audit.
    fn told_theirs(&self, text: &str) -> Result<Vec<(CheckId, Option<usize>)>> {
        let audit = self.theirs(text)?;
        Ok(audit.checks.into_iter().filter(|c| !c.check.passed).map(|c| (c.check.id, c.line)).collect())
    }

    /// The same by reading the own program back.
    fn told_own(&self, text: &str) -> Result<Vec<(CheckId, Option<usize>)>> {
        let program = Program { text: text.to_owned(), ..self.shop.program.clone() };
        let s = &self.shop;
        let checks = read_back(&program, &self.plan, &s.blade, &s.tool, &s.machine)?;
        let line = |note: &str| note.split("line ").nth(1)?.split(|c: char| !c.is_ascii_digit()).next()?.parse().ok();
        Ok(checks.into_iter().filter(|c| !c.passed).map(|c| (c.id, line(&c.note))).collect())
    }

    /// Whether what came of a fault is what must come of it, placed behind the middle of the cut
    /// where it was planted there.
    fn judge(&self, edit: Edit, told: Result<Vec<(CheckId, Option<usize>)>>, must: Told) {
        let who = format!("{:?} {edit:?}: {told:?}, not {must:?}", self.shop.control);
        match (told, must) {
            (Err(e), Refused) => {
                assert!(e.kind == ErrorKind::Usage, "{who}");
                if let Line(line) = edit {
                    let calls = e.message.contains("calls a tool");
                    let near = (1..=4).any(|k| e.message.contains(&format!("line {} of", self.middle + k)));
                    assert!(calls || near, "{who} {line}");
                }
            }
            (Ok(found), Found(name)) => {
                let (_, line) =
                    found.iter().find(|(id, _)| *id == name.parse().unwrap()).unwrap_or_else(|| panic!("{who}"));
                if matches!(edit, Line(_)) {
                    assert!(line.is_some_and(|l| (self.middle..self.middle + 8).contains(&l)), "{who}");
                }
            }
            (Err(e), Felt) => assert!(e.kind == ErrorKind::Usage, "{who}"),
            (Ok(found), Felt) => assert!(!found.is_empty(), "{who}"),
            (Ok(found), Nothing) => assert!(found.is_empty(), "{who}"),
            _ => panic!("{who}"),
        }
    }
}

#[test]
fn every_planted_word_is_refused_or_found_in_programs_of_others() {
    for control in CONTROLS {
        let bench = Bench::new(control);
        bench.judge(Line(""), bench.told_theirs(&bench.shop.program.text), Nothing);
        for (edit, theirs, _) in faults(control) {
            bench.judge(edit, bench.told_theirs(&bench.edited(edit)), theirs);
        }
    }
}

#[test]
fn every_planted_word_is_refused_or_found_in_own_programs() {
    for control in CONTROLS {
        let bench = Bench::new(control);
        bench.judge(Line(""), bench.told_own(&bench.shop.program.text), Nothing);
        for (edit, _, own) in faults(control) {
            bench.judge(edit, bench.told_own(&bench.edited(edit)), own);
        }
    }
}

#[test]
fn what_is_harmless_stays_so() {
    for control in CONTROLS {
        let bench = Bench::new(control);
        for line in harmless(control) {
            bench.judge(Line(line), bench.told_own(&bench.inserted(&[line])), Nothing);
        }
        bench.judge(Line("all"), bench.told_theirs(&bench.inserted(&harmless(control))), Nothing);
    }
}

#[test]
fn feeds_of_others_are_judged_by_the_limits_of_the_axes() {
    for control in CONTROLS {
        let bench = Bench::new(control);
        // Ten times as fast: A would have to turn faster than it can.
        let faster = |w: &str| match w.strip_prefix('F').and_then(|v| v.parse::<f64>().ok()) {
            Some(f) => format!("F{:.4}", 10.0 * f),
            None => w.to_owned(),
        };
        let line = |l: &str| match l.strip_prefix("FEDRAT/").and_then(|l| l.strip_suffix(",MMPM")) {
            Some(f) => format!("FEDRAT/{:.4},MMPM\n", 10.0 * f.parse::<f64>().unwrap()),
            None if l.contains(';') => format!("{l}\n"),
            None => format!("{}\n", l.split(' ').map(faster).collect::<Vec<_>>().join(" ")),
        };
        let text: String = bench.shop.program.text.lines().map(line).collect();
        bench.judge(Word("F", "10 F"), bench.told_theirs(&text), Found("a-velocity"));
        bench.judge(Word("F", "10 F"), bench.told_own(&text), Found("program-feed"));
    }
    // The same numbers as feeds per minute are another feed.
    let bench = Bench::new(Control::Siemens);
    let text = bench.edited(Word(" G93\n", " G94\n"));
    bench.judge(Word("G93", "G94"), bench.told_own(&text), Found("program-feed"));
}

#[test]
fn a_turn_the_other_way_round_is_found_in_own_programs() {
    // Without M126 the control turns A back by nearly a turn where it passes the end of one.
    let bench = Bench::new(Control::Heidenhain);
    let text = bench.edited(Word(" M126\n", " M127\n"));
    bench.judge(Word("M126", "M127"), bench.told_own(&text), Found("program-direction"));
    // A turn too many in one line ends in the same place.
    let bench = Bench::new(Control::Linuxcnc);
    let line = bench.shop.program.text.lines().nth(bench.middle).unwrap().to_owned();
    let (before, rest) = line.split_once(" A").unwrap();
    let (angle, after) = rest.split_once(' ').unwrap();
    let turned = format!("{before} A{:.4} {after}", angle.parse::<f64>().unwrap() + 360.0);
    let text = bench.shop.program.text.replacen(&line, &turned, 1);
    bench.judge(Word("A1", "A361"), bench.told_own(&text), Found("program-direction"));
}
