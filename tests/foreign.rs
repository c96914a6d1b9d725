//! Programs as other systems write them: every excerpt of `tests/foreign` is read, and moves the
//! machine to where an independent little reader (`little_reader.py` beside them) says, or it is
//! refused with its line and the reason.
//!
//! An excerpt begins with `=== name | grammar meaning`, and ends in `| refused LINE words` where it
//! must be refused. `meaning`: of X, Y, Z. `plane` and `vectors` are tips, in a tilted plane and
//! with the tool axis as I, J, K.

use std::collections::HashMap;
use std::path::Path;

use bladewright::artifact::program::{Grammar, Language, Programmed};
use bladewright::error::ErrorKind;
use bladewright::machine::Machine;
use bladewright::read::program::{self, Bench, Block, Feed, Moved, Zero};
use bladewright::tool::Tool;

/// Families of systems and controls.
const FAMILIES: [&str; 9] =
    ["nx_cls", "catia_apt", "creo_cl", "ncl_apt", "icam_apt", "fanuc", "siemens", "heidenhain", "mach3"];
/// Excerpts of each.
const EACH: usize = 20;
/// Places are the same within this, mm; an arc may be this far off, mm; angles, degrees.
const SAME: [f64; 3] = [1e-6, 1.5e-7, 1e-6];

/// A move that the little reader expects: line, point, tool axis, rotary axes, feed, places on an
/// arc.
type Expected =
    (usize, [Option<f64>; 3], Option<[f64; 3]>, HashMap<String, f64>, serde_json::Value, Option<Vec<[f64; 3]>>);

struct Excerpt {
    name: String,
    language: Language,
    /// Line and words of its refusal.
    refused: Option<(usize, String)>,
    text: String,
}

fn folder() -> std::path::PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/foreign")
}

fn excerpts(family: &str) -> Vec<Excerpt> {
    let text = std::fs::read_to_string(folder().join(format!("{family}.txt"))).expect("readable");
    let one = |part: &str| {
        let (head, body) = part.split_once('\n').expect("a text");
        let head: Vec<&str> = head.split('|').map(str::trim).collect();
        let (grammar, meaning) = head[1].split_once(' ').expect("grammar and meaning");
        let grammar = match grammar {
            "apt" => Grammar::Apt,
            "gcode" => Grammar::Gcode,
            "heidenhain" => Grammar::Heidenhain,
            other => panic!("{other} is no grammar"),
        };
        let programmed = match meaning {
            "machine" => Programmed::Machine,
            "centre" => Programmed::Centre,
            "tip" | "plane" | "vectors" => Programmed::Tip,
            other => panic!("{other} is no meaning"),
        };
        let refused = head.get(2).map(|r| {
            let mut words = r.splitn(3, ' ');
            assert_eq!(words.next(), Some("refused"), "{r}");
            let line = words.next().and_then(|l| l.parse().ok()).expect("a line");
            (line, words.next().expect("words of the refusal").to_owned())
        });
        let language = Language { grammar, programmed, shortest_way: false, feed_counts_degrees: false };
        Excerpt { name: head[0].to_owned(), language, refused, text: body.to_owned() }
    };
    text.split("=== ").skip(1).map(one).collect()
}

fn tool() -> Tool {
    Tool {
        radius_mm: 5.0,
        corner_radius_mm: None,
        taper_deg: 3.0,
        shank_radius_mm: 8.0,
        stickout_mm: 70.0,
        holder: Vec::new(),
    }
}

fn moves(excerpt: &Excerpt, tool: &Tool, machine: &Machine) -> bladewright::error::Result<(Vec<Block>, Vec<Moved>)> {
    let script = program::read(&excerpt.text, excerpt.language)?;
    let bench = Bench { language: excerpt.language, zero: Zero::default(), tool, machine };
    let moves = program::follow(&script.blocks, &bench)?;
    Ok((script.blocks, moves))
}

/// The moves of each line, one after the other.
fn by_line(moves: &[Moved]) -> Vec<&[Moved]> {
    moves.chunk_by(|a, b| a.line == b.line).collect()
}

fn near(got: f64, want: f64, within: f64, what: &str) {
    assert!((got - want).abs() <= within, "{what}: {got}, expected {want}");
}

fn compare(expected: &[Expected], blocks: &[Block], moves: &[Moved], machine: &Machine, name: &str) {
    let lines = by_line(moves);
    let got: Vec<usize> = lines.iter().map(|m| m[0].line).collect();
    assert_eq!(got, expected.iter().map(|e| e.0).collect::<Vec<_>>(), "{name}: lines that move");
    for (of_line, (line, point, axis, rotary, feed, via)) in lines.iter().zip(expected) {
        let what = format!("{name}, line {line}");
        let last = of_line.last().expect("a move");
        let at = last.at(1.0);
        for (k, want) in machine.linear().into_iter().zip(point) {
            if let Some(want) = want {
                near(at[k], *want, SAME[0], &what);
            }
        }
        if let Some(axis) = axis {
            let [x, y, z] = *axis;
            let [a, b, c] = machine.axis_at(&at).into();
            let cross = [b * z - c * y, c * x - a * z, a * y - b * x];
            let sine = cross.iter().map(|v| v * v).sum::<f64>().sqrt();
            near(sine.asin().to_degrees(), 0.0, SAME[2], &what);
            assert!(a * x + b * y + c * z > 0.0, "{what}: the tool axis points the other way");
        }
        for (letter, want) in rotary {
            let k = machine.rotary().find(|k| machine.axes()[*k].name == *letter).expect("an axis of the machine");
            near(at[k].to_degrees(), *want, SAME[2], &what);
        }
        match (feed, blocks[last.block].feed) {
            (serde_json::Value::String(_), Feed::Rapid) | (serde_json::Value::Null, Feed::PerMove(_)) => {}
            (serde_json::Value::Number(want), Feed::PerMinute(got)) => {
                near(got, want.as_f64().expect("a number"), 1e-9 * got, &what);
            }
            (want, got) => panic!("{what}: {got:?}, expected {want}"),
        }
        for (share, want) in [0.25, 0.5, 0.75].into_iter().zip(via.iter().flatten()) {
            let along = share * of_line.len() as f64;
            let at = of_line[along as usize].at(along.fract());
            for (k, want) in machine.linear().into_iter().zip(want) {
                near(at[k], *want, SAME[1], &format!("{what}, at {share} of the arc"));
            }
        }
        if via.is_none() && of_line.len() == 1 {
            assert!(last.even(), "{what}: the way is bent");
        }
    }
}

#[test]
fn each_excerpt_is_read_as_the_little_reader_does_or_refused() {
    let (tool, machine) = (tool(), Machine::demo().expect("the built-in machine"));
    let (mut count, mut wrong) = ([0, 0], Vec::new());
    for family in FAMILIES {
        let json = std::fs::read_to_string(folder().join(format!("{family}.json"))).expect("readable");
        let mut expected: HashMap<String, Vec<Expected>> = serde_json::from_str(&json).expect("poses");
        let all = excerpts(family);
        assert_eq!(all.len(), EACH, "{family}");
        for excerpt in all {
            let name = format!("{family}, {}", excerpt.name);
            match (moves(&excerpt, &tool, &machine), &excerpt.refused) {
                (Ok((blocks, moves)), None) => {
                    let expected = expected.remove(&excerpt.name).expect("poses of the excerpt");
                    assert!(!expected.is_empty(), "{name}");
                    compare(&expected, &blocks, &moves, &machine, &name);
                    count[0] += 1;
                }
                (Err(e), Some((line, words))) => {
                    let told =
                        e.message.starts_with(&format!("line {line} of the program")) && e.message.contains(words);
                    if !told || e.kind != ErrorKind::Usage {
                        wrong.push(format!("{name}: {}; expected line {line}, {words}", e.message));
                    }
                    count[1] += 1;
                }
                (Ok(_), Some((line, words))) => {
                    wrong.push(format!("{name}: read; line {line} should be refused: {words}"))
                }
                (Err(e), None) => {
                    expected.remove(&excerpt.name);
                    wrong.push(format!("{name}: {}", e.message));
                }
            }
        }
        assert!(expected.is_empty(), "{family}: poses of no excerpt: {:?}", expected.keys());
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
    assert!(count[0] >= 110 && count[1] >= 40, "{count:?} were read and refused");
}

#[test]
fn no_excerpt_is_taken_for_another_grammar() {
    for family in FAMILIES {
        for excerpt in excerpts(family) {
            let guess = program::guess(&excerpt.text).unwrap_or_else(|| panic!("{family}, {}: no guess", excerpt.name));
            assert_eq!(guess.language.grammar, excerpt.language.grammar, "{family}, {}", excerpt.name);
        }
    }
}
