//! Lines of G code taken apart.

use std::collections::HashMap;

/// A word of a line.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct CodeWord<'a> {
    /// Letter or name, in capitals.
    pub address: &'a str,
    /// What follows it, in capitals, without blanks.
    pub value: String,
    /// The word as it is written.
    pub raw: &'a str,
    /// What the text has set before.
    constants: &'a Constants,
}

/// Values of `R1` and `#1` that the text has set.
#[derive(Clone, Debug, Default, PartialEq)]
pub(super) struct Constants(HashMap<String, f64>);

impl Constants {
    /// Whether an address is that of a constant.
    pub fn name(address: &str) -> bool {
        let number = address.strip_prefix(['R', '#']);
        number.is_some_and(|n| !n.is_empty() && n.bytes().all(|b| b.is_ascii_digit()))
    }

    pub fn set(&mut self, address: &str, value: f64) {
        self.0.insert(address.to_owned(), value);
    }
}

impl CodeWord<'_> {
    /// The value of the word.
    pub fn number(&self) -> Result<f64, String> {
        self.number_of(&self.value)
    }

    /// A number within the word.
    pub fn number_of(&self, text: &str) -> Result<f64, String> {
        let unsigned = text.trim_start_matches(['+', '-']);
        if text.len() <= unsigned.len() + 1 && Constants::name(unsigned) {
            let value = self.constants.0.get(unsigned);
            let value = value.ok_or_else(|| format!("{unsigned} has not been set to a number"))?;
            return Ok(if text.starts_with('-') { -value } else { *value });
        }
        let parsed = text.parse::<f64>().ok().filter(|x| x.is_finite());
        parsed.ok_or_else(|| format!("{} is not a number", self.raw))
    }

    /// The value of a word that counts: `D1`, `M03`.
    pub fn count(&self) -> Result<u32, String> {
        let n = self.number()?;
        let whole = n.fract() == 0.0 && (0.0..1e9).contains(&n);
        whole.then_some(n as u32).ok_or_else(|| format!("{} is not a whole number", self.raw))
    }
}

/// The line without comments, and without blanks around `=`.
pub(in crate::read::program) fn code(line: &str) -> Result<String, String> {
    let mut out = String::new();
    let mut rest = line.trim();
    while let Some(at) = rest.find(['(', ';']) {
        let (before, from) = rest.split_at(at);
        out.push_str(before);
        if from.starts_with(';') {
            rest = "";
            break;
        }
        let close = closing(from).ok_or("a ( without its )")?;
        // A bracket right after a name or = belongs to a word (IC(…), CYCLE832(…), PO[X]=(…)); any
        // other opens a comment, also behind a letter with its number.
        if before.ends_with('=') || named(before) {
            out.extend(from[..=close].chars().filter(|c| !c.is_whitespace()));
        }
        rest = &from[close + 1..];
    }
    out.push_str(rest);
    if !out.contains('=') {
        return Ok(out);
    }
    let parts: Vec<&str> = out.split('=').map(str::trim).collect();
    Ok(parts.join("="))
}

/// Whether a text ends in a name, not in a letter with its number.
fn named(text: &str) -> bool {
    text.rsplit(|c: char| !c.is_ascii_alphanumeric() && c != '_').next().is_some_and(long)
}

/// Where the bracket that a text begins with is closed.
fn closing(text: &str) -> Option<usize> {
    let mut depth = 0i32;
    text.char_indices().find_map(|(i, c)| {
        depth += i32::from(c == '(') - i32::from(c == ')');
        (depth == 0).then_some(i)
    })
}

/// Words of a line; `upper` is the line in capitals. Blanks between a letter and its number, and
/// within the number, mean nothing but to Siemens, who takes them for the end of the number.
pub(super) fn words<'a>(
    code: &'a str,
    upper: &'a str,
    constants: &'a Constants,
    siemens: bool,
) -> Result<Vec<CodeWord<'a>>, String> {
    let mut out: Vec<CodeWord> = Vec::new();
    // Whether the last word is a letter whose number may go on.
    let mut open = false;
    for token in upper.split_whitespace() {
        // Capitals are as long as what they are made from.
        let at = token.as_ptr() as usize - upper.as_ptr() as usize;
        let raw = &code[at..at + token.len()];
        if let Some((address, value)) = token.split_once('=') {
            out.push(CodeWord { address, value: value.to_owned(), raw, constants });
            open = false;
            continue;
        }
        if token.contains('(') || long(token) {
            out.push(CodeWord { address: token, value: String::new(), raw, constants });
            open = false;
            continue;
        }
        // Words may stand without spaces: G1X2.5Y-3.
        let mut from = 0;
        if let Some(last) = out.last_mut().filter(|w| open && (!siemens || w.value.trim_matches(['+', '-']).is_empty()))
        {
            from = token.find(|c: char| c.is_ascii_alphabetic()).unwrap_or(token.len());
            last.value.push_str(&token[..from]);
        }
        while let Some(letter) = token[from..].chars().next() {
            if letter == '/' {
                return Err("a line that may be skipped (/): write it with the line or without".into());
            }
            if !letter.is_ascii_alphabetic() {
                return Err(format!("\"{raw}\" is not a word"));
            }
            let next = token[from + 1..].find(|c: char| c.is_ascii_alphabetic());
            let end = next.map_or(token.len(), |e| from + 1 + e);
            let value = token[from + 1..end].to_owned();
            out.push(CodeWord { address: &token[from..=from], value, raw: &raw[from..end], constants });
            (from, open) = (end, true);
        }
    }
    Ok(out)
}

/// A keyword, not a row of words: letters follow one another.
fn long(token: &str) -> bool {
    token.as_bytes().windows(2).any(|w| w[0].is_ascii_alphabetic() && w[1].is_ascii_alphabetic())
}
