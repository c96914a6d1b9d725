//! Lines of the program that move the tool, for the page's script to show beside it.
//!
//! A program is several megabytes of text, nearly all of them numbers that change little from line
//! to line. What stands around the numbers is kept once for all lines that have it in common
//! (*frame*), the numbers as whole numbers of their last digit in lists ([`super::pack`]), one for
//! each place in a frame that has the same letters before it and as many digits. Nothing is lost:
//! the script makes the same bytes of it.

use std::collections::HashMap;
use std::hash::Hash;

use serde_json::{Value, json};

use super::pack::{Pack, TIME};
use crate::artifact::Program;
use crate::error::{Error, Result, Stage};

/// Most lines that the page carries; of longer programs every so many.
const LINES: usize = 120_000;
/// Most digits of a number: as whole numbers of the script are exact up to 2⁴⁸, longer ones are
/// kept as letters.
const MOST_DIGITS: usize = 14;

/// The element; without a program it is empty.
///
/// # Errors
/// `InputOutput` where the lines cannot be encoded.
pub(super) fn element(program: Option<&Program>) -> Result<String> {
    let data = program.map(data).transpose()?.unwrap_or(Value::Null);
    let text = serde_json::to_string(&data)
        .map_err(|e| Error::io(Stage::Preview, format!("the program's lines cannot be encoded: {e}")).caused_by(e))?;
    // Inside a script element the text must not contain `</script` or `<!--`.
    let text = text.replace('<', "\\u003c");
    Ok(format!("<script id=\"program\" type=\"application/json\">{text}</script>\n"))
}

/// Letters between numbers, and numbers.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
enum LinePiece<'a> {
    Letters(&'a str),
    /// A number of the column.
    Number(usize),
}

/// How the numbers of a column are written.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
struct Column<'a> {
    /// What stands before them.
    letters: &'a str,
    /// Digits after the point.
    decimals: usize,
    /// What is not negative has a `+`.
    plus: bool,
}

/// Things by their numbers, in the order in which they were first met.
struct Known<T>(HashMap<T, usize>);

impl<T: Eq + Hash> Known<T> {
    fn number(&mut self, what: T) -> usize {
        let next = self.0.len();
        *self.0.entry(what).or_insert(next)
    }

    fn all(self) -> Vec<T> {
        let mut all: Vec<(T, usize)> = self.0.into_iter().collect();
        all.sort_unstable_by_key(|(_, k)| *k);
        all.into_iter().map(|(what, _)| what).collect()
    }
}

fn data(program: &Program) -> Result<Value> {
    let texts: Vec<&str> = program.text.lines().collect();
    let every = program.cut_lines.len().div_ceil(LINES).max(1);
    let shown: Vec<_> =
        program.cut_lines.iter().step_by(every).filter(|c| (1..=texts.len()).contains(&c.line)).collect();
    let (mut frames, mut columns) = (Known(HashMap::new()), Known(HashMap::new()));
    let (mut frame_of, mut numbers): (_, Vec<Vec<f64>>) = (Vec::with_capacity(shown.len()), Vec::new());
    for cut in &shown {
        let mut frame = Vec::new();
        for (letters, number) in pieces(texts[cut.line - 1]) {
            frame.push(LinePiece::Letters(letters));
            let Some((value, decimals, plus)) = number else { continue };
            let column = columns.number(Column { letters, decimals, plus });
            numbers.resize_with(numbers.len().max(column + 1), Vec::new);
            numbers[column].push(value);
            frame.push(LinePiece::Number(column));
        }
        frame_of.push(frames.number(frame) as f64);
    }
    let mut pack = Pack::default();
    let columns: Vec<Value> = columns
        .all()
        .iter()
        .zip(numbers)
        .map(|(c, numbers)| json!([c.decimals, c.plus, pack.list(0, numbers)]))
        .collect();
    let piece = |p: &LinePiece| match p {
        LinePiece::Letters(l) => json!(l),
        LinePiece::Number(column) => json!(column),
    };
    let frames: Vec<Vec<Value>> = frames.all().iter().map(|f| f.iter().map(piece).collect()).collect();
    Ok(json!({
        "file": program.file_name, "every": every, "frames": frames, "columns": columns,
        "frame_of": pack.list(0, frame_of),
        "line": pack.list(0, shown.iter().map(|c| c.line as f64)),
        "until": pack.list(TIME, shown.iter().map(|c| c.until_s)),
        "block": pack.text()?,
    }))
}

/// A number of a line: as a whole number of its last digit, digits after the point, and whether it
/// has a `+`.
type Number = (f64, usize, bool);

/// A line as letters, each piece with the number behind it where there is one.
fn pieces(line: &str) -> Vec<(&str, Option<Number>)> {
    let (mut out, mut from, mut at) = (Vec::new(), 0, 0);
    let bytes = line.as_bytes();
    let digits = |at: usize| bytes[at..].iter().take_while(|b| b.is_ascii_digit()).count();
    while at < bytes.len() {
        let sign = usize::from(matches!(bytes[at], b'+' | b'-'));
        let whole = digits(at + sign);
        if whole == 0 {
            at += 1;
            continue;
        }
        let mut end = at + sign + whole;
        let after = if bytes.get(end) == Some(&b'.') { digits(end + 1) } else { 0 };
        end += if after > 0 { 1 + after } else { 0 };
        let (text, plus) = (&line[at..end], bytes[at] == b'+');
        let value = text.replace('.', "").parse::<i64>().ok().filter(|_| whole + after <= MOST_DIGITS);
        // What would not be written alike, as 007 and −0, stays with the letters.
        if let Some(value) = value.filter(|v| written(*v, after, plus) == text) {
            out.push((&line[from..at], Some((value as f64, after, plus))));
            from = end;
        }
        at = end;
    }
    if from < line.len() {
        out.push((&line[from..], None));
    }
    out
}

/// A number of a column, as the script writes it.
fn written(value: i64, decimals: usize, plus: bool) -> String {
    let sign = match value {
        v if v < 0 => "-",
        _ if plus => "+",
        _ => "",
    };
    let digits = format!("{:0>width$}", value.unsigned_abs(), width = decimals + 1);
    let (whole, after) = digits.split_at(digits.len() - decimals);
    if after.is_empty() { format!("{sign}{whole}") } else { format!("{sign}{whole}.{after}") }
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used)]
    use super::*;
    use crate::artifact::program::{CutLine, Grammar, Language, Programmed};
    use crate::write::preview::report::pack;

    /// The lines of an element, as the page's script makes them.
    fn lines(element: &str) -> Vec<(usize, f64, String)> {
        let json = element.split_once('>').unwrap().1.strip_suffix("</script>\n").unwrap();
        let data: Value = serde_json::from_str(json).unwrap();
        let lists = pack::unpacked(data["block"].as_str().unwrap());
        let list = |v: &Value| lists[v.as_u64().unwrap() as usize].clone();
        let columns: Vec<_> = data["columns"].as_array().unwrap().iter().collect();
        let mut numbers: Vec<_> = columns.iter().map(|c| list(&c[2]).into_iter()).collect();
        let mut text = |frame: f64| -> String {
            let pieces = data["frames"][frame as usize].as_array().unwrap().iter();
            let text = pieces.map(|p| match p.as_str() {
                Some(letters) => letters.to_owned(),
                None => {
                    let k = p.as_u64().unwrap() as usize;
                    let decimals = columns[k][0].as_u64().unwrap() as usize;
                    written(numbers[k].next().unwrap() as i64, decimals, columns[k][1].as_bool().unwrap())
                }
            });
            text.collect()
        };
        let all = list(&data["frame_of"]).into_iter().zip(list(&data["line"])).zip(list(&data["until"]));
        all.map(|((frame, line), until)| (line as usize, until, text(frame))).collect()
    }

    fn program(text: String, cut_lines: Vec<CutLine>) -> Program {
        let language = Language {
            grammar: Grammar::Gcode,
            programmed: Programmed::Tip,
            shortest_way: false,
            feed_counts_degrees: false,
        };
        let (control, file_name, ranges) = ("x".into(), "p.nc".into(), Default::default());
        Program { control, file_name, language, ranges, cycles: Vec::new(), text, cut_lines, asked: Vec::new() }
    }

    #[test]
    fn lines_come_back_as_they_are() {
        let odd = [
            "N477590 G94 G1 X15.06889 Y-15.19460 Z-0.00001 A=DC(129.24913) F14005.568",
            "12 L X+12.5 Y-3. Z+0 A-0 F007 R+-1 M9 ; <!-- 3.25.1 .5 1e-7 -.5 +",
            "LN X+0.000 Y-0.000 TX+0.99999999 1234567890123456789 12345678901234 123456789012345",
            "",
            "GOTO/-1.5,2.25,-0.125,$",
            "über 5 – 7",
        ];
        let mut all: Vec<String> = odd.iter().map(|l| (*l).to_owned()).collect();
        for k in 0..4000 {
            let x = 40.0 * (0.01 * f64::from(k)).sin();
            all.push(format!("N{} G1 X{x:.5} Y{:.5} F{:.3}", 10 * k, -x * x, 1000.0 + x));
        }
        let until = |k: usize| 0.0123 * k as f64;
        let cuts: Vec<_> = (0..all.len()).map(|k| CutLine { line: k + 1, until_s: until(k) }).collect();
        let made = element(Some(&program(all.join("\n") + "\n", cuts))).unwrap();
        let back = lines(&made);
        assert_eq!(back.len(), all.len());
        for (k, (line, at, text)) in back.iter().enumerate() {
            assert_eq!((*line, text), (k + 1, &all[k]));
            assert!((at - until(k)).abs() <= 0.5e-4 * 1.000_001, "{at}");
        }
        let size: usize = all.iter().map(String::len).sum();
        assert!(made.len() < size / 4, "{} of {size} bytes", made.len());
        assert!(!made[..made.len() - 10].contains("<!--"));
    }

    #[test]
    fn of_a_long_program_every_so_many_lines_are_kept_and_none_beyond_its_end() {
        let n = LINES + 5;
        let cuts = (0..n + 4).map(|k| CutLine { line: k + 1, until_s: k as f64 }).collect();
        let back = lines(&element(Some(&program("G1 X1.5\n".repeat(n), cuts))).unwrap());
        assert_eq!(back.len(), n.div_ceil(2));
        assert!(back.iter().enumerate().all(|(k, l)| (l.0, &*l.2) == (2 * k + 1, "G1 X1.5")));
        assert!(element(None).unwrap().contains(">null<"));
    }
}
