//! NC programs of every grammar, to be damaged: short ones that are written as bladewright's posts
//! and as others write them, and mutations that know words and keep the block numbers of Klartext.
//! Used by `examples/fuzz_readers.rs`, by the short form in the test suite, and by the targets of
//! this folder.

use bladewright::artifact::program::{Grammar, Language, Programmed};
use bladewright::error::Result;
use bladewright::machine::Machine;
use bladewright::read::program::{self, Bench, Moved, Zero};
use bladewright::tool::{HolderStage, Tool};

use super::mutate::{Random, mutated};

/// A grammar or family of controls: its name, a program of each kind that bladewright writes, one
/// of others.
type Family = (&'static str, &'static [&'static str], &'static str);

const FAMILIES: [Family; 5] = [
    (
        "siemens",
        &[
            include_str!("../tests/snapshots/program.mpf"),
            include_str!("../tests/snapshots/program.vector.mpf"),
            include_str!("../tests/snapshots/program.poly.mpf"),
        ],
        "%_N_A_MPF\nN10 G500 G17 G71 G90 MSG(\"a; b\")\nT=\"BALL_6\" M6 D1\nS8000 M3\nG54\nCYCLE800()\nCYCLE832(0.01,_FINISH,1)\nTRAORI\nORIWKS ORIAXES FFWON SOFT COMPCAD FNORM\nR1=5\nR2=-R1\nTRANS X1 Y2\nAROT Z30\nG0 X0 Y0 Z50 A=DC(10) B=AC(5)\nG94 G1 X1 Y2 Z3 F500\nX=IC(1) Y=AC(2) A=ACP(20) B=ACN(4)\nG91 UPATH POLY PO[X]=(1,0.1,0.2) PO[A]=(2,0.1) PL=1.5 F100\nX2 A=PO(10,4)\nSPATH G90 G1 X4 A3=0 B3=0.1 C3=1\nORIVECT\nX=R1 A3=0.1 B3=0.2 C3=1\nORIAXES\nG3 X=R1 Y=R2 CR=40\nSTEP\nROT\nTRAFOOF\nCYCLE800(0,\"TC\",0,57,1,2,3,20,0,0,0,0,0,-1)\nG0 X1 Y2 Z50\nG1 Z3\nCYCLE800()\nSUPA G0 Z500 D0\nM5\nM30\n%_N_STEP_SPF\nPROC STEP\nG1 X1\nRET\n",
    ),
    (
        "fanuc",
        &[include_str!("../tests/snapshots/program.nc"), include_str!("../tests/snapshots/program.vector.nc")],
        "%\nO1 (NOTE)\nG17 G21 G40 G49 G80 G90 G94\nG53 G0 Z600.\nT1 M6\nS8000M3\nG5.1 Q1\nG54\nG05 P10000\nG0A0B5.\nG43.4H1X0Y0Z50.\nG1X1.Y2.F500.\nG93\nG1X2.A3.F100.\nG91X.1A1.F90.\nG90G94\nG43.5 H1\nG1 X1. I0. J0.1 K1. F200\nG1 X1. Y2. Z3. I0. J0. K1.\nG43.4 H1\nX1.\n#1=4.\nM98 P7 L2\nG52 X1.\nG68 X0 Y0 R30.\nG1 X 2 . Y#1\nG69\nG49\nG5.1 Q0\nG28 G91 Z0\nG90\nM5\nM30\nO7\nG91 G2 X4. Y0 I2. J0\nG90\nM99\n%\n",
    ),
    (
        "linuxcnc",
        &[
            include_str!("../tests/snapshots/program.ngc"),
            include_str!("../tests/snapshots/program.feed.ngc"),
            include_str!("../tests/snapshots/program.iso.nc"),
        ],
        "%\ng17 g21 g90 g91.1\ng64 p0.01\nt1 m6 g43 h1\ns8000 m3 (a note)\ng53 g0 z600\ng0 x0 y0 z50 a0 b5\ng1 x1 f500\ng20 g1 x1 f20\ng21 g94 g1 x3 f60\ng18 g3 x5 z51 r9\ng17 g2 x5 y0 i-2 p2\no100 sub\ng91 g1 x1\ng90\no100 endsub\no100 call\ng93 g1 x3 a400 f60\nm9 m5\nm2\n%\n",
    ),
    (
        "heidenhain",
        &[include_str!("../tests/snapshots/program.h"), include_str!("../tests/snapshots/program.vector.h")],
        "0 BEGIN PGM A MM\n1 BLK FORM 0.1 Z X-50 Y-50 Z-20\n2 * - Ball\n3 TOOL CALL \"BALL 6\" Z S8000 F500 DL+0\n4 M3 M8\n5 M126\n6 L Z+500 R0 FMAX M91\n7 L A+10 B-5 FMAX\n8 CYCL DEF 32.0 TOLERANCE\n9 CYCL DEF 32.1 T0,01\n10 M128 F2000\n11 L X+1,5 Y+2 Z+3 F500\n12 SPL X+2 K3X+0.1 K2X-0.2 K1X-4 E-1\n13 L A+350\n14 LN X+1 Y+2 TX+0 TY+0.1 TZ+1\n15 STOP\n16 Q1 = +3\n17 CYCL DEF 7.0 DATUM SHIFT\n18 CYCL DEF 7.1 X+Q1\n19 L X+4 IY-2\n20 L Y+0 IX+0\n21 CC X+0 Y+0\n22 C X-4 Y+0 DR+\n23 CR X+4 Y+0 R-5 DR-\n24 CALL LBL 1\n25 M129\n26 PLANE SPATIAL SPA+20 SPB+0 SPC+0 TURN FMAX\n27 L X+1 Y+2 Z+9\n28 PLANE RESET STAY\n29 L Z+500 FMAX M91 M5\n30 M30\n31 LBL 1\n32 L IZ+1\n33 LBL 0\n34 END PGM A MM\n",
    ),
    (
        "apt",
        &[include_str!("../tests/snapshots/program.apt")],
        "PARTNO/A\n$$ a note\nMACHIN/ANY,1\nUNITS/INCHES\nMULTAX/ON\nCUTTER/0.5,0.25\nLOADTL/1\nSPINDL/RPM,8000,CLW\nCOOLNT/ON\nRAPID\nGOTO/1,2,3,$\n0,0,1\nFEDRAT/IPM,20\nGOTO/1,2,2.5,0,0.1,1\nGOTO/1,2,2.6,0,0.2,1\nMSYS/1,2,3,0,1,0,-1,0,0\nGOTO/1,0,0\nCIRCLE/0,0,0,0,0,1,1\nGOTO/0,1,0\nGODLTA/0,0,1\nGOHOME\nSPINDL/OFF\nEND\nFINI\n",
    ),
];

/// Lines of a program that are kept at its beginning and at its end, comments not counted: short
/// ones are read more often.
const KEPT: [usize; 2] = [26, 14];

/// Words that a program may have, of all grammars.
const WORDS: [&str; 91] = [
    "G2",
    "G3 I1",
    "R5",
    "G18",
    "G28",
    "G52 X1",
    "G68.2 J9",
    "G53.1",
    "M98 P7",
    "M99",
    "R1=2",
    "#1=2",
    "TRANS X1",
    "ROT Z1",
    "CYCLE800()",
    "ORIVECT",
    "CALL LBL 1",
    "LBL 1",
    "LBL 0",
    "CC X1 Y1",
    "C X0 Y1 DR-",
    "PLANE RESET TURN",
    "CYCL DEF 7.1 X1",
    "MSYS/0,0,0,1,0,0,0,1,0",
    "CIRCLE/0,0,0,0,0,1,1",
    "GODLTA/1,0,0",
    "G90.1",
    "X 1 2",
    "M30",
    "%",
    "M98",
    "M5",
    "M4",
    "M6",
    "T2",
    "D0",
    "D1",
    "H0",
    "G43",
    "G49",
    "G43.4",
    "G43.5",
    "G20",
    "G21",
    "G70",
    "G91",
    "G90",
    "G93",
    "G94",
    "G0",
    "G1",
    "G53",
    "G54",
    "G55",
    "G64",
    "P5",
    "S0",
    "F0",
    "F1",
    "F1e300",
    "POLY",
    "PL=0",
    "PO[X]=(1,2,3)",
    "A=IC(1)",
    "A=DC(-1e9)",
    "B=ACP(7)",
    "A1e15",
    "TRAORI",
    "TRAFOOF",
    "SUPA",
    "CYCLE832(1)",
    "A3=0",
    "C3=0",
    "I0",
    "K0",
    "L",
    "LN",
    "FMAX",
    "M91",
    "M128",
    "M129",
    "TX0",
    "TZ0",
    "TOOL CALL 0",
    "CYCL DEF 32.1 T1",
    "END PGM",
    "GOTO/0,0,0,0,0,0",
    "UNITS/INCHES",
    "FEDRAT/0",
    "GOHOME",
    "FINI",
];

/// Names of the families.
pub const NAMES: [&str; 5] = [FAMILIES[0].0, FAMILIES[1].0, FAMILIES[2].0, FAMILIES[3].0, FAMILIES[4].0];

/// How a family's programs are to be read, by its name or a file name that ends in it.
fn language(name: &str) -> Language {
    let of = |grammar, programmed| Language { grammar, programmed, shortest_way: false, feed_counts_degrees: false };
    match name.rsplit('.').next() {
        Some("heidenhain") => of(Grammar::Heidenhain, Programmed::Centre),
        Some("apt") => of(Grammar::Apt, Programmed::Tip),
        Some("linuxcnc") => of(Grammar::Gcode, Programmed::Machine),
        _ => of(Grammar::Gcode, Programmed::Tip),
    }
}

/// All seeds: names that end in their family's, and their texts.
pub fn seeds() -> Vec<(String, Vec<u8>)> {
    let of = |(name, own, other): &Family| {
        let own = own.iter().enumerate().map(|(k, text)| (format!("own{k}.{name}"), shortened(text, name)));
        own.chain([(format!("other.{name}"), other.as_bytes().to_vec())]).collect::<Vec<_>>()
    };
    FAMILIES.iter().flat_map(of).collect()
}

/// The beginning and the end of a program without its comments.
fn shortened(text: &str, name: &str) -> Vec<u8> {
    let comment = |l: &str| {
        let code = if name == "heidenhain" { l.split_once(' ').map_or("", |(_, code)| code) } else { l };
        [";", "(", "$$"].iter().any(|c| code.starts_with(c))
    };
    let lines: Vec<&str> = text.lines().filter(|l| !comment(l)).collect();
    let last = lines.len().saturating_sub(KEPT[1]);
    let kept = lines.iter().enumerate().filter(|(i, _)| *i < KEPT[0] || *i >= last);
    let text: String = kept.map(|(_, l)| format!("{l}\n")).collect();
    if name == "heidenhain" { numbered(text.as_bytes()) } else { text.into_bytes() }
}

/// The lines with block numbers from 0 on, whatever numbers they have.
fn numbered(bytes: &[u8]) -> Vec<u8> {
    let lines = bytes.split(|b| *b == b'\n').enumerate();
    let code = |l: &[u8]| l.iter().position(|b| !b.is_ascii_digit()).map_or(Vec::new(), |at| l[at..].to_vec());
    lines.flat_map(|(i, l)| [i.to_string().into_bytes(), code(l), vec![b'\n']].concat()).collect()
}

/// A damaged program: numbers, lines and bytes as in model files, and words that decide what a
/// control does. Klartext mostly keeps its block numbers.
pub fn damaged(name: &str, bytes: &[u8], random: &mut Random) -> Vec<u8> {
    let mut out = bytes.to_vec();
    for _ in 0..random.below(3) {
        put_word(name, &mut out, random);
    }
    if random.below(4) > 0 {
        out = mutated(&out, random);
    }
    if name.ends_with("heidenhain") && random.below(8) > 0 { numbered(&out) } else { out }
}

/// A word is put in at the end of a line, or as a line of its own.
fn put_word(name: &str, out: &mut Vec<u8>, random: &mut Random) {
    let from = random.below(out.len());
    let at = out.iter().skip(from).position(|b| *b == b'\n').map_or(out.len(), |k| k + from);
    let word = WORDS[random.below(WORDS.len())];
    let line = match (random.below(2), name.ends_with("heidenhain")) {
        (0, _) => format!(" {word}"),
        (_, true) => format!("\n0 {word}"),
        (_, false) => format!("\n{word}"),
    };
    out.splice(at..at, line.bytes());
}

/// The machine and the tool that programs are followed with.
pub struct Shop {
    machine: Machine,
    tool: Tool,
}

impl Shop {
    /// The built-in machine and a ball-end tool.
    ///
    /// # Errors
    /// None that the built-in machine file does not have.
    pub fn new() -> Result<Self> {
        let holder = vec![HolderStage { radius_mm: 20.0, length_mm: 40.0 }];
        let tool = Tool {
            radius_mm: 3.0,
            corner_radius_mm: None,
            taper_deg: 3.0,
            shank_radius_mm: 6.0,
            stickout_mm: 50.0,
            holder,
        };
        Ok(Shop { machine: Machine::demo()?, tool })
    }

    /// Reads a program and moves the machine through it; what it says must hold together.
    ///
    /// # Errors
    /// A line that is not read or cannot be followed.
    pub fn moved(&self, name: &str, bytes: &[u8]) -> Result<Vec<Moved>> {
        let text = String::from_utf8_lossy(bytes);
        let _ = program::guess(&text);
        let language = language(name);
        let script = program::read(&text, language)?;
        let bench = Bench { language, zero: Zero::default(), tool: &self.tool, machine: &self.machine };
        let lines = text.lines().count();
        let end = script.end.unwrap_or(lines);
        assert!(script.blocks.iter().all(|b| b.line <= lines && b.tool_calls <= script.calls.len()), "{name}");
        assert!(script.behind.iter().all(|l| *l > end && *l <= lines), "{name}");
        let moves = program::follow(&script.blocks, &bench)?;
        assert!(moves.iter().all(|m| m.seconds.is_none_or(|s| s >= 0.0 || s.is_nan())), "{name}");
        Ok(moves)
    }
}
