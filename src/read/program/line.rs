//! The words of a line with where their numbers stand, for a line to be written anew in place.
//!
//! What the words do to the machine is read by [`super::read`]: this looks at the text alone, and
//! knows of each language the words that carry positions and feeds.

use std::ops::Range;

use crate::artifact::program::Grammar;

/// Names of the words of an `LN` block, longest first, and of all others that carry positions.
const KLARTEXT: [&str; 13] = ["TX", "TY", "TZ", "NX", "NY", "NZ", "X", "Y", "Z", "A", "B", "C", "F"];
/// Names of the numbers behind `GOTO/`.
const GOTO: [&str; 6] = ["X", "Y", "Z", "I", "J", "K"];

/// A word with a number.
#[derive(Clone, Debug, PartialEq)]
pub struct Word {
    /// `X`, `A3`, `TX`; of `GOTO` by their order.
    pub name: String,
    /// Bytes of the line that are its number.
    pub number: Range<usize>,
    /// Bytes of the line that are all of the word.
    pub whole: Range<usize>,
}

impl Word {
    /// The number as it is read; `None`: it is none.
    pub fn value(&self, line: &str) -> Option<f64> {
        line.get(self.number.clone())?.replace(',', ".").parse().ok().filter(|v: &f64| v.is_finite())
    }
}

/// The words of a line that have numbers; `None` where the line has a form that is not written
/// anew.
pub fn words(line: &str, grammar: Grammar) -> Option<Vec<Word>> {
    match grammar {
        Grammar::Gcode => of_gcode(line),
        Grammar::Heidenhain => Some(of_klartext(line)),
        Grammar::Apt => of_goto(line),
    }
}

/// The end of a number that begins at `from`: digits with at most one of the points, signed.
fn number_end(text: &[u8], from: usize, points: &[u8]) -> Option<usize> {
    let sign = usize::from(matches!(text.get(from), Some(b'+' | b'-')));
    let digits = text.iter().skip(from + sign).take_while(|b| b.is_ascii_digit() || points.contains(b)).count();
    let end = from + sign + digits;
    let body = text.get(from + sign..end)?;
    let marks = body.iter().filter(|b| !b.is_ascii_digit()).count();
    (body.len() > marks && marks <= 1).then_some(end)
}

fn of_gcode(line: &str) -> Option<Vec<Word>> {
    let text = line.as_bytes();
    let blanks = |from: usize| from + text.iter().skip(from).take_while(|b| b.is_ascii_whitespace()).count();
    let (mut out, mut at) = (Vec::new(), blanks(0));
    while let Some(first) = text.get(at) {
        match first {
            b';' => break,
            b'(' => {
                at = blanks(at + text.iter().skip(at).position(|b| *b == b')')? + 1);
                continue;
            }
            letter if !letter.is_ascii_alphabetic() => return None,
            _ => {}
        }
        let start = at;
        // `A3=0.5` has a digit in its name, `A=5` and `A5` have none.
        let digits = text.iter().skip(at + 1).take_while(|b| b.is_ascii_digit()).count();
        let is_indexed = digits > 0 && text.get(at + 1 + digits) == Some(&b'=');
        at += 1 + if is_indexed { digits } else { 0 };
        let name = line.get(start..at)?.to_ascii_uppercase();
        at = blanks(at);
        if text.get(at) == Some(&b'=') {
            at = blanks(at + 1);
        }
        // A position within a turn or of an axis: `DC(…)`, `AC(…)`.
        let inner = ["DC(", "AC("].iter().find(|f| line.get(at..at + 3).is_some_and(|t| t.eq_ignore_ascii_case(f)));
        at = if inner.is_some() { blanks(at + 3) } else { at };
        let end = number_end(text, at, b".")?;
        let number = at..end;
        at = end;
        if inner.is_some() {
            at = blanks(at);
            if text.get(at) != Some(&b')') {
                return None;
            }
            at += 1;
        }
        out.push(Word { name, number, whole: start..at });
        at = blanks(at);
    }
    Some(out)
}

fn of_klartext(line: &str) -> Vec<Word> {
    let code = line.split(';').next().unwrap_or("");
    let mut out = Vec::new();
    let mut at = 0;
    for token in code.split(char::is_whitespace) {
        let end = at + token.len();
        let name = KLARTEXT.iter().find(|name| token.starts_with(**name));
        if let Some(name) = name
            && number_end(line.as_bytes(), at + name.len(), b".,") == Some(end)
        {
            out.push(Word { name: (*name).to_owned(), number: at + name.len()..end, whole: at..end });
        }
        at = end + 1;
    }
    out
}

fn of_goto(line: &str) -> Option<Vec<Word>> {
    let code = line.split('$').next().unwrap_or("");
    let (major, numbers) = code.split_once('/')?;
    if !major.trim().eq_ignore_ascii_case("GOTO") {
        return None;
    }
    let mut out = Vec::new();
    let mut at = major.len() + 1;
    for (k, part) in numbers.split(',').enumerate() {
        let from = at + (part.len() - part.trim_start().len());
        let number = from..from + part.trim().len();
        number_end(line.as_bytes(), number.start, b".").filter(|end| *end == number.end)?;
        out.push(Word { name: (*GOTO.get(k)?).to_owned(), whole: number.clone(), number });
        at += part.len() + 1;
    }
    Some(out)
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used)]
    use super::*;

    fn read(line: &str, grammar: Grammar) -> Vec<(String, f64)> {
        let words = words(line, grammar).unwrap();
        words.iter().map(|w| (w.name.clone(), w.value(line).unwrap())).collect()
    }

    #[test]
    fn words_of_a_line_and_where_their_numbers_are() {
        let pairs = |line, grammar| read(line, grammar).into_iter().map(|(n, v)| format!("{n}{v}")).collect::<Vec<_>>();
        assert_eq!(
            pairs("N10 G1 X 1.5Y-2. A=DC( 30.5 ) (X9) F500 ; Z1", Grammar::Gcode),
            ["N10", "G1", "X1.5", "Y-2", "A30.5", "F500"]
        );
        assert_eq!(pairs("X=1 A3=0.5 B3=-.25 C3=+1", Grammar::Gcode), ["X1", "A30.5", "B3-0.25", "C31"]);
        assert_eq!(pairs("12 LN X+1,5 Y-2 TX+0.1 R0 F500 ; X3", Grammar::Heidenhain), ["X1.5", "Y-2", "TX0.1", "F500"]);
        assert_eq!(
            pairs("GOTO  /  1.5 , -2,3,  0, .6,0.8 $$ end", Grammar::Apt),
            ["X1.5", "Y-2", "Z3", "I0", "J0.6", "K0.8"]
        );
        for (line, grammar) in [
            ("X=R1", Grammar::Gcode),
            ("MSG(\"a\")", Grammar::Gcode),
            ("G1 X1..2", Grammar::Gcode),
            ("FEDRAT/5", Grammar::Apt),
            ("GOTO/1,2,A", Grammar::Apt),
        ] {
            assert_eq!(words(line, grammar), None, "{line}");
        }
    }
}
