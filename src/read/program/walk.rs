//! The order in which lines are run: one after the other, but for calls of subprograms.

/// Most subprograms within one another.
const DEEPEST: usize = 16;
/// Most lines that are run beside those of the text: millions of repeats end here.
const MOST: usize = 500_000;

/// A subprogram that runs.
struct Running {
    /// Its first line, from 0.
    first: usize,
    /// The line behind the call.
    back: usize,
    /// Runs that are left behind this one.
    left: u32,
}

/// Where a program is.
#[derive(Default)]
pub(super) struct Walk {
    next: usize,
    running: Vec<Running>,
    steps: usize,
}

impl Walk {
    /// The line to be run, from 0, of so many; `None`: the text is at its end.
    ///
    /// # Errors
    /// What is wrong: the text ends in a subprogram, or more lines would run than are followed.
    pub fn step(&mut self, lines: usize) -> Result<Option<usize>, String> {
        if self.next >= lines {
            return match self.running.last() {
                Some(_) => Err("the subprogram that is called does not end".into()),
                None => Ok(None),
            };
        }
        self.steps += 1;
        if self.steps > lines + MOST {
            return Err(format!("the calls of the program run more than {MOST} lines"));
        }
        self.next += 1;
        Ok(Some(self.next - 1))
    }

    /// Goes on with a line, from 0.
    pub fn skip_to(&mut self, line: usize) {
        self.next = line;
    }

    /// Calls the subprogram that begins with a line, from 0, so many times.
    ///
    /// # Errors
    /// What is wrong: calls within calls.
    pub fn call(&mut self, first: usize, times: u32) -> Result<(), String> {
        if self.running.len() == DEEPEST {
            return Err(format!("calls within calls, more than {DEEPEST} deep"));
        }
        if times > 0 {
            self.running.push(Running { first, back: self.next, left: times - 1 });
            self.next = first;
        }
        Ok(())
    }

    /// Ends the subprogram that runs; `false`: none does.
    pub fn done(&mut self) -> bool {
        let Some(running) = self.running.last_mut() else { return false };
        if running.left > 0 {
            running.left -= 1;
            self.next = running.first;
        } else {
            self.next = running.back;
            self.running.pop();
        }
        true
    }
}
