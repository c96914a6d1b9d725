//! The words of a program's text against what its control reads: `program-words`.
//!
//! A check and no reader: it looks at the text alone, token by token, so that it holds for lines
//! that no reader makes a move of as well.

use crate::artifact::CheckId;
use crate::artifact::program::{Grammar, Program, WordRange};
use crate::artifact::report::Check;

/// The check: how many words are out of range, with the first.
pub(super) fn check(program: &Program) -> Check {
    let mut found = 0usize;
    let mut first = None;
    for (i, line) in program.text.lines().enumerate() {
        for (address, value) in words(line, program.language.grammar) {
            let Some(range) = program.ranges.get(&address) else { continue };
            let Some(what) = outside(value, range) else { continue };
            found += 1;
            first.get_or_insert_with(|| format!("{} line {}: {address}{value} {what}", program.file_name, i + 1));
        }
    }
    let note = first.unwrap_or_else(|| program.file_name.clone());
    Check::at_most(CheckId::ProgramWords, "words that the control does not read", found as f64, 0.0, "words", note)
}

/// What is wrong with a value; `None`: nothing, or it is no number.
fn outside(value: &str, range: &WordRange) -> Option<String> {
    let number: f64 = value.parse().ok()?;
    if !(range.least..=range.greatest).contains(&number) {
        return Some(format!("is outside of what the control reads, {} to {}", range.least, range.greatest));
    }
    let digits = value.split_once('.').map_or(0, |(_, behind)| behind.len());
    (digits > range.decimals)
        .then(|| format!("has {digits} digits after the point, the control reads {}", range.decimals))
}

/// Addresses and values of a line, comments left out: `X1.5`, `A=DC(3)` as A and 3,
/// `FEDRAT/300,MMPM` as FEDRAT and 300.
fn words(line: &str, grammar: Grammar) -> Vec<(String, &str)> {
    let code = match grammar {
        Grammar::Apt => line.split("$$").next().unwrap_or(""),
        Grammar::Heidenhain => line.split(';').next().unwrap_or(""),
        // A bracket at the beginning of a word is a comment.
        Grammar::Gcode => line.split(';').next().and_then(|l| l.split(" (").next()).unwrap_or(""),
    };
    if grammar == Grammar::Apt {
        let (major, minor) = code.split_once('/').unwrap_or((code, ""));
        return vec![(major.trim().to_owned(), minor.split(',').next().unwrap_or("").trim())];
    }
    if code.trim_start().starts_with('(') {
        return Vec::new();
    }
    let of = |token| spline_factor(token, grammar).map_or_else(|| of_token(token), |word| vec![word]);
    code.split_whitespace().flat_map(of).collect()
}

/// A factor of a spline line, `K3X+1.25E-2`, as K and what stands before the exponent; `None`: it
/// is none.
fn spline_factor(token: &str, grammar: Grammar) -> Option<(String, &str)> {
    let (name, value) = token.split_at_checked(3).filter(|_| grammar == Grammar::Heidenhain)?;
    let [b'K', b'1'..=b'3', b'A'..=b'Z'] = name.as_bytes() else { return None };
    Some(("K".to_owned(), value.split('E').next()?.trim_start_matches('+')))
}

/// `G1X2.5`, `TX+0.5`, `A=DC(3)`.
fn of_token(token: &str) -> Vec<(String, &str)> {
    if let Some((address, value)) = token.split_once('=') {
        let inner = value.split_once('(').map_or(value, |(_, inner)| inner);
        return vec![(address.to_owned(), inner.split([',', ')']).next().unwrap_or(""))];
    }
    if token.contains('(') {
        return Vec::new();
    }
    let mut out = Vec::new();
    let mut rest = token;
    while !rest.is_empty() {
        let letters = rest.find(|c: char| !c.is_ascii_alphabetic()).unwrap_or(rest.len());
        let number = rest[letters..].find(|c: char| c.is_ascii_alphabetic()).map_or(rest.len(), |n| letters + n);
        if letters == 0 && number == 0 {
            break;
        }
        out.push((rest[..letters].to_owned(), rest[letters..number].trim_start_matches('+')));
        rest = &rest[number..];
    }
    out
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used)]
    use super::*;
    use crate::artifact::program::{Language, Programmed, Ranges};

    fn program(grammar: Grammar, text: &str) -> Program {
        let range = |least, greatest, decimals| WordRange { least, greatest, decimals };
        let ranges: Ranges = [
            ("F", range(0.001, 9999.999, 3)),
            ("N", range(1.0, 99999.0, 0)),
            ("A", range(-1e5, 1e5, 4)),
            ("TX", range(-10.0, 10.0, 8)),
            ("K", range(-9.999, 9.999, 3)),
            ("FEDRAT", range(1.0, 1e5, 3)),
        ]
        .map(|(address, range)| (address.to_owned(), range))
        .into();
        let language =
            Language { grammar, programmed: Programmed::Tip, shortest_way: false, feed_counts_degrees: false };
        let (control, file_name) = ("x".to_owned(), "p.nc".to_owned());
        Program {
            control,
            file_name,
            language,
            ranges,
            cycles: Vec::new(),
            text: text.into(),
            cut_lines: Vec::new(),
            asked: Vec::new(),
        }
    }

    #[test]
    fn a_word_outside_is_named_with_its_line_and_range() {
        for (grammar, text, names) in [
            (Grammar::Gcode, "N1 G1\nN100000 G1", "line 2: N100000 is outside of what the control reads, 1 to 99999"),
            (Grammar::Gcode, "N1 G1 X1 F42853.289", "line 1: F42853.289 is outside"),
            (Grammar::Gcode, "G1X1F0.0001", "F0.0001 is outside"),
            (Grammar::Gcode, "G1 A=DC(190.12345) F1", "A190.12345 has 5 digits after the point, the control reads 4"),
            (Grammar::Heidenhain, "7 L X+1 F332.00770", "F332.00770 has 5 digits"),
            (Grammar::Heidenhain, "7 LN TX+0.123456789 F3", "TX0.123456789 has 9 digits"),
            (Grammar::Heidenhain, "7 SPL X+1 K3X+10.5E-2 K2X+9.5E+4 F3", "K10.5 is outside"),
            (Grammar::Heidenhain, "7 SPL X+1 K3X-1.1234 F3", "K-1.1234 has 4 digits"),
            (Grammar::Apt, "FEDRAT/0.5,MMPM", "FEDRAT0.5 is outside"),
        ] {
            let c = check(&program(grammar, text));
            assert!(!c.passed && c.worst == 1.0 && c.note.contains(names), "{text}: {}", c.note);
        }
    }

    #[test]
    fn comments_calls_and_words_without_a_number_are_none() {
        for (grammar, text) in [
            (Grammar::Gcode, "(N100000 F99999)\nN5 G1 (F99999) F9999.999\n; F99999\nMSG(F99999)\nG1 ; F99999"),
            (Grammar::Heidenhain, "100000 L X+1 FMAX ; F999999\n100001 FUNCTION TCPM F TCP AXIS POS"),
            (Grammar::Apt, "$$ FEDRAT/0.5\nGOTO/1,2,3"),
        ] {
            assert!(check(&program(grammar, text)).passed, "{text}");
        }
    }
}
