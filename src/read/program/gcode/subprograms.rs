//! Subprograms that stand in the same text: `O1000` called by `M98 P1000`, `%_N_NAME_SPF` called by
//! its name, `O100 SUB` called by `O100 CALL`.

use std::collections::HashMap;

/// What a line does to the order of lines.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Jump {
    /// Calls the subprogram whose first line, from 0, this is.
    Call { first: usize, times: u32 },
    /// Ends a subprogram; in the main program it ends that, or is an error.
    Done { ends_main: bool },
    /// Goes on with a line, from 0.
    Skip(usize),
}

/// Lines of a subprogram, from 0, without the line that names it.
struct Section {
    first: usize,
    end: usize,
}

/// All of a text.
pub(super) struct Subprograms {
    sections: HashMap<String, Section>,
    /// Lines that are no blocks: headers, calls by O-words.
    jumps: HashMap<usize, Result<Jump, String>>,
}

impl Subprograms {
    /// Finds them.
    pub fn of(lines: &[&str]) -> Self {
        let mut out = Subprograms { sections: HashMap::new(), jumps: HashMap::new() };
        let mut open: Option<(String, usize)> = None;
        let mut inner: HashMap<String, usize> = HashMap::new();
        let mut calls = Vec::new();
        for (i, line) in lines.iter().enumerate() {
            let line = line.trim().to_ascii_uppercase();
            let head = header(&line);
            if head.is_some() || line.starts_with('%') {
                if let Some((name, first)) = open.take() {
                    out.sections.entry(name).or_insert(Section { first, end: i });
                }
                open = head.map(|name| (name, i + 1));
                continue;
            }
            match o_word(&line) {
                Some((name, "SUB")) => {
                    inner.insert(name.to_owned(), i);
                }
                Some((name, "ENDSUB")) => {
                    if let Some(head) = inner.remove(name) {
                        out.jumps.insert(head, Ok(Jump::Skip(i + 1)));
                        out.jumps.insert(i, Ok(Jump::Done { ends_main: false }));
                        out.sections.insert(name.to_owned(), Section { first: head + 1, end: i + 1 });
                    }
                }
                Some((name, "CALL")) => calls.push((i, name.to_owned())),
                Some((_, what)) => {
                    out.jumps.insert(i, Err(format!("O-words are read as SUB, ENDSUB and CALL, not {what}")));
                }
                None if named_call(&line).is_some() => {
                    calls.extend(named_call(&line).map(|name| (i, name.to_owned())));
                }
                None if line.starts_with("PROC ") && !line.contains('(') => {
                    out.jumps.insert(i, Ok(Jump::Skip(i + 1)));
                }
                None => {}
            }
        }
        if let Some((name, first)) = open {
            out.sections.entry(name).or_insert(Section { first, end: lines.len() });
        }
        for (i, name) in calls {
            let jump = out.by_name(&name, 1);
            out.jumps.insert(i, jump);
        }
        out
    }

    /// What a line does that is no block.
    ///
    /// # Errors
    /// A call of what the text does not have.
    pub fn at(&self, line: usize) -> Result<Option<Jump>, String> {
        self.jumps.get(&line).cloned().transpose()
    }

    /// The call of a subprogram.
    ///
    /// # Errors
    /// The text does not have it.
    pub fn by_name(&self, name: &str, times: u32) -> Result<Jump, String> {
        let section = self.sections.get(name);
        let missing = || format!("the subprogram {name} is not in this file; put it behind the main program");
        section.map(|s| Jump::Call { first: s.first, times }).ok_or_else(missing)
    }

    /// `M98 P1000 L2`, and `M98 P21000` of older controls.
    ///
    /// # Errors
    /// The text does not have it.
    pub fn by_number(&self, number: u32, repeats: Option<u32>) -> Result<Jump, String> {
        let (name, short) = (number.to_string(), (number % 10_000).to_string());
        if repeats.is_none() && number > 9999 && !self.sections.contains_key(&name) {
            return self.by_name(&short, number / 10_000);
        }
        self.by_name(&name, repeats.unwrap_or(1))
    }

    /// Whether there is one of this name.
    pub fn has(&self, name: &str) -> bool {
        self.sections.contains_key(name)
    }

    /// Whether a line is one of a subprogram that was called, named by its first line.
    pub fn has_called(&self, line: usize, called: &[usize]) -> bool {
        // The line that names a subprogram is one before its first.
        self.sections.values().any(|s| called.contains(&s.first) && (s.first..=s.end).contains(&(line + 1)))
    }
}

/// The name that a line gives to what follows: `O1000`, `%_N_POCKET_SPF`.
fn header(line: &str) -> Option<String> {
    if let Some(name) = line.strip_prefix("%_N_") {
        return Some(name.strip_suffix("_SPF").or_else(|| name.strip_suffix("_MPF")).unwrap_or(name).to_owned());
    }
    let number = line.strip_prefix('O')?.split(['(', ';', ' ']).next().filter(|n| !n.is_empty())?;
    (o_word(line).is_none() && number.bytes().all(|b| b.is_ascii_digit()))
        .then(|| number.trim_start_matches('0').to_owned())
}

/// Name and keyword of an O-word: `O100 SUB`, `O<POCKET> CALL`.
fn o_word(line: &str) -> Option<(&str, &str)> {
    let rest = line.strip_prefix('O')?;
    let at = if rest.starts_with('<') {
        rest.find('>')? + 1
    } else {
        rest.find(|c: char| !c.is_ascii_digit()).filter(|at| *at > 0)?
    };
    let (name, rest) = rest.split_at(at);
    let what = rest.split(['(', ';']).next().unwrap_or("").trim();
    what.starts_with(|c: char| c.is_ascii_alphabetic()).then_some((name, what))
}

/// `CALL "POCKET"`.
fn named_call(line: &str) -> Option<&str> {
    let code = line.trim_start_matches('N').trim_start_matches(|c: char| c.is_ascii_digit()).trim_start();
    let name = code.strip_prefix("CALL")?.trim().strip_prefix('"')?;
    name.split_once('"').filter(|(_, rest)| rest.trim().is_empty()).map(|(name, _)| name)
}
