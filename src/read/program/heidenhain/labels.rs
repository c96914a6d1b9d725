//! Labels of Klartext, and which block comes next.

use std::collections::HashMap;

use super::{Jump, Read, parts};
use crate::read::program::walk::Walk;

/// Where labels stand, from 0.
pub(super) struct Labels {
    places: HashMap<String, usize>,
    /// The `LBL 0` behind each label.
    ends: HashMap<usize, usize>,
    called: Vec<usize>,
    /// Repeats that are left, by the line of their `CALL LBL … REP`.
    left: HashMap<usize, u32>,
}

impl Labels {
    /// All labels of a text.
    pub fn of(lines: &[&str]) -> Self {
        let mut out = Labels { places: HashMap::new(), ends: HashMap::new(), called: Vec::new(), left: HashMap::new() };
        let mut open = Vec::new();
        for (i, line) in lines.iter().enumerate() {
            match parts(line).1.split_whitespace().collect::<Vec<_>>()[..] {
                ["LBL", "0"] => open.drain(..).for_each(|at| {
                    out.ends.insert(at, i);
                }),
                ["LBL", name] => {
                    out.places.entry(name.to_owned()).or_insert(i);
                    open.push(i);
                }
                _ => {}
            }
        }
        out
    }

    /// Goes where a block leads.
    ///
    /// # Errors
    /// A label that the text does not have.
    pub fn jump(&mut self, line: usize, jump: Option<Jump>, walk: &mut Walk) -> Read<()> {
        let place = |name: &str| {
            let place = self.places.get(name).copied();
            place.ok_or_else(|| format!("the label {name} is not in this file"))
        };
        match jump {
            None => {}
            Some(Jump::Call(name)) => {
                let first = place(&name)?;
                if !self.ends.contains_key(&first) {
                    return Err(format!("the label {name} is called and has no LBL 0 behind it"));
                }
                self.called.push(first);
                walk.call(first, 1)?;
            }
            Some(Jump::Again(name, count)) => {
                let first = place(&name)?;
                if first > line {
                    return Err(format!("the label {name} is behind the block that repeats from it"));
                }
                let left = self.left.entry(line).or_insert(count);
                if *left > 0 {
                    *left -= 1;
                    walk.skip_to(first);
                } else {
                    self.left.remove(&line);
                }
            }
            // Where no label was called, the program goes on.
            Some(Jump::Done) => {
                walk.done();
            }
        }
        Ok(())
    }

    /// Whether a line, from 0, is one of a label that was called.
    pub fn has_called(&self, line: usize) -> bool {
        self.called.iter().any(|first| (*first..=*self.ends.get(first).unwrap_or(first)).contains(&line))
    }
}
