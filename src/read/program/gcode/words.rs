//! Lines of G code taken apart.

/// A word of a line.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Word<'a> {
    /// Letter or name, in capitals.
    pub address: &'a str,
    /// What follows it, in capitals.
    pub value: &'a str,
    /// The word as it is written.
    pub raw: &'a str,
}

impl Word<'_> {
    /// The value of the word.
    pub fn number(&self) -> Result<f64, String> {
        self.number_of(self.value)
    }

    /// A number within the word.
    pub fn number_of(&self, text: &str) -> Result<f64, String> {
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

/// The line without comments.
pub(super) fn code(line: &str) -> Result<String, String> {
    let mut out = String::new();
    let mut rest = line.trim();
    while let Some(at) = rest.find(['(', ';']) {
        let (before, from) = rest.split_at(at);
        out.push_str(before);
        if from.starts_with(';') {
            return Ok(out);
        }
        let close = closing(from).ok_or("a ( without its )")?;
        // A bracket right after a letter, a digit or = belongs to a word (IC(…), CYCLE832(…),
        // PO[X]=(…)); any other opens a comment.
        if before.ends_with(|c: char| c.is_ascii_alphanumeric() || c == '=') {
            out.extend(from[..=close].chars().filter(|c| !c.is_whitespace()));
        }
        rest = &from[close + 1..];
    }
    out.push_str(rest);
    Ok(out)
}

/// Where the bracket that a text begins with is closed.
fn closing(text: &str) -> Option<usize> {
    let mut depth = 0i32;
    text.char_indices().find_map(|(i, c)| {
        depth += i32::from(c == '(') - i32::from(c == ')');
        (depth == 0).then_some(i)
    })
}

/// Words of a line; `upper` is the line in capitals.
pub(super) fn words<'a>(code: &'a str, upper: &'a str) -> Result<Vec<Word<'a>>, String> {
    let mut out = Vec::new();
    for token in upper.split_whitespace() {
        // Capitals are as long as what they are made from.
        let at = token.as_ptr() as usize - upper.as_ptr() as usize;
        let raw = &code[at..at + token.len()];
        if let Some((address, value)) = token.split_once('=') {
            out.push(Word { address, value, raw });
            continue;
        }
        if token.contains('(') || long(token) {
            out.push(Word { address: token, value: "", raw });
            continue;
        }
        // Words may stand without spaces: G1X2.5Y-3.
        let mut from = 0;
        while let Some(letter) = token[from..].chars().next() {
            if !letter.is_ascii_alphabetic() {
                return Err(format!("\"{raw}\" is not a word"));
            }
            let next = token[from + 1..].find(|c: char| c.is_ascii_alphabetic());
            let end = next.map_or(token.len(), |e| from + 1 + e);
            out.push(Word { address: &token[from..=from], value: &token[from + 1..end], raw: &raw[from..end] });
            from = end;
        }
    }
    Ok(out)
}

/// A keyword, not a row of words: letters follow one another.
fn long(token: &str) -> bool {
    token.as_bytes().windows(2).any(|w| w[0].is_ascii_alphabetic() && w[1].is_ascii_alphabetic())
}
