//! Numbers of a line written anew in the manner of its program.

use std::ops::Range;

use crate::read::program::line::Word;

/// How numbers of a name are written.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Manner {
    pub decimals: usize,
    /// Zeros at the end are left out.
    pub trims: bool,
    /// Numbers that are not negative have a sign.
    pub plus: bool,
    /// The point is a comma.
    pub comma: bool,
}

impl Manner {
    /// Of a number as it stands in the program.
    pub fn of_number(number: &str) -> Manner {
        let decimals = number.find(['.', ',']).map_or(0, |at| number.len() - at - 1);
        Manner { decimals, trims: false, plus: number.starts_with('+'), comma: number.contains(',') }
    }

    /// Of these numbers and others.
    pub fn and(&self, other: Manner) -> Manner {
        Manner {
            decimals: self.decimals.max(other.decimals),
            trims: self.trims || other.trims || self.decimals != other.decimals,
            plus: self.plus || other.plus,
            comma: self.comma || other.comma,
        }
    }

    /// The value as it is rounded.
    pub fn rounded(&self, value: f64) -> f64 {
        self.said(value).1
    }

    /// The number as text, and the value that it says.
    pub fn said(&self, value: f64) -> (String, f64) {
        let text = self.text(value);
        let said = if self.comma { text.replace(',', ".").parse() } else { text.parse() };
        (text, said.unwrap_or(value))
    }

    /// The number as text.
    pub fn text(&self, value: f64) -> String {
        let mut out = format!("{value:.*}", self.decimals);
        if self.trims && out.contains('.') {
            let kept = out.trim_end_matches('0').len();
            // A number without its point may be read in another unit.
            out.truncate(if out.as_bytes().get(kept - 1) == Some(&b'.') { kept + 1 } else { kept });
        }
        if out.trim_start_matches(['-', '0', '.']).is_empty() {
            out = out.trim_start_matches('-').to_owned();
        }
        if self.plus && !out.starts_with('-') {
            out.insert(0, '+');
        }
        if self.comma { out.replace('.', ",") } else { out }
    }

    /// Half of the last digit.
    pub fn half(&self) -> f64 {
        0.5 * 0.1f64.powi(i32::try_from(self.decimals).unwrap_or(i32::MAX))
    }
}

/// The line with numbers of its words replaced, and words put behind the last that has a position:
/// `added` as they are to stand, each with the blank before it.
pub(super) fn written(line: &str, words: &[Word], new: &[(usize, String)], added: &str) -> String {
    let carries = |w: &&Word| w.name != "N" && w.name != "G" && w.name != "M" && w.name != "F";
    let last = words.iter().rfind(carries).or(words.last()).map_or(line.trim_end().len(), |w| w.whole.end);
    let mut edits: Vec<(Range<usize>, &str)> =
        new.iter().filter_map(|(k, text)| Some((words.get(*k)?.number.clone(), text.as_str()))).collect();
    edits.push((last..last, added));
    edits.sort_by_key(|(at, _)| at.start);
    let mut out = String::with_capacity(line.len() + added.len() + 8);
    let mut from = 0;
    for (at, text) in edits {
        out.push_str(line.get(from..at.start).unwrap_or(""));
        out.push_str(text);
        from = at.end;
    }
    out.push_str(line.get(from..).unwrap_or(""));
    out
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used)]
    use super::*;
    use crate::artifact::program::Grammar;
    use crate::read::program::line::words;

    #[test]
    fn numbers_keep_the_manner_of_the_program() {
        let of = |numbers: &[&str]| numbers.iter().map(|n| Manner::of_number(n)).reduce(|a, b| a.and(b));
        let text = |numbers: &[&str], value: f64| of(numbers).unwrap().text(value);
        assert_eq!(text(&["1.250", "3.500"], 1.5), "1.500");
        assert_eq!(text(&["1.25", "3.5"], 2.0), "2.0");
        assert_eq!(text(&["500"], 512.6), "513");
        assert_eq!(text(&["+1,250"], 0.5), "+0,500");
        assert_eq!(text(&["1.250"], -0.0001), "0.000");
        assert_eq!(text(&["1", "2.500", "3.500"], 1.5), "1.5");
    }

    #[test]
    fn only_numbers_change_and_words_go_behind_the_last_position() {
        let line = "N10 G1 X1.5  Y2 F500 (end)";
        let all = words(line, Grammar::Gcode).unwrap();
        assert_eq!(written(line, &all, &[(3, "7.25".into())], " A9"), "N10 G1 X1.5  Y7.25 A9 F500 (end)");
        let line = "GOTO/1,2,3";
        let all = words(line, Grammar::Apt).unwrap();
        assert_eq!(written(line, &all, &[], ",0,0,1"), "GOTO/1,2,3,0,0,1");
    }
}
