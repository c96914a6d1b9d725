//! APT cutter-location files.
//!
//! A statement either is acted on, is known to be harmless, or is refused.

use super::block::{Block, Call, Destination, Feed, Script};
use super::unreadable;
use crate::artifact::program::{LengthOffset, Setting, Turning};
use crate::error::Result;

/// Longest line that APT processors take.
const LINE: usize = 72;

/// What a statement that is refused says.
type Read<T> = std::result::Result<T, String>;

/// State that stays from statement to statement.
struct AptReader {
    script: Script,
    feed: Option<f64>,
    rapid: bool,
    /// Length of the file's unit, mm.
    unit_mm: f64,
    setting: Setting,
    /// `FINI` has been read.
    closed: bool,
}

/// Reads a file.
///
/// # Errors
/// A statement that is not understood or a line that is too long, with the line.
pub(super) fn read(text: &str) -> Result<Script> {
    let mut reader = AptReader {
        script: Script::default(),
        feed: None,
        rapid: false,
        unit_mm: 1.0,
        setting: Setting::default(),
        closed: false,
    };
    let mut statement = String::new();
    for (i, raw) in text.lines().enumerate() {
        let line = i + 1;
        if raw.len() > LINE {
            return Err(unreadable(line, raw, &format!("{} characters, at most {LINE} are read", raw.len())));
        }
        let code = raw.split("$$").next().unwrap_or("").trim_end();
        if let Some(open) = code.strip_suffix('$') {
            statement.push_str(open.trim());
            continue;
        }
        statement.push_str(code.trim());
        let whole = std::mem::take(&mut statement);
        reader.statement(line, &whole).map_err(|e| unreadable(line, raw, &e))?;
    }
    Ok(reader.script)
}

impl AptReader {
    fn statement(&mut self, line: usize, whole: &str) -> Read<()> {
        let (major, minor) = whole.split_once('/').unwrap_or((whole, ""));
        let major = major.trim();
        let minor: Vec<&str> = minor.split(',').map(str::trim).filter(|m| !m.is_empty()).collect();
        if self.script.end.is_some() {
            if self.closed || major != "FINI" {
                self.script.behind.extend((!whole.is_empty()).then_some(line));
            }
            self.closed |= major == "FINI";
            return Ok(());
        }
        match (major, &minor[..]) {
            ("RAPID", []) => self.rapid = true,
            ("LOADTL", [tool]) => self.load(line, tool)?,
            // Where home is, is the machine's: from then on nothing is known.
            ("GOHOME", []) => {
                let unknown = Destination::Words { point: [Some(f64::NAN); 3], rotary: [None; 3] };
                let block = Block { machine: true, ..Block::straight(line, unknown, Feed::Rapid) };
                self.push(block);
            }
            ("FEDRAT", words) => self.feed = Some(self.feedrate(words)?),
            ("GOTO", numbers) => self.go(line, numbers)?,
            ("UNITS", ["MM"]) => self.unit(1.0)?,
            ("UNITS", ["INCHES" | "INCH"]) => self.unit(25.4)?,
            ("SPINDL", words) => self.spindle(words)?,
            ("CUTTER", [diameter, corner, ..]) => {
                let [d, r] = [number(diameter)?, number(corner)?].map(|v| v * self.unit_mm);
                self.script.cutters.push((line, [d, r]));
            }
            ("END", []) => self.script.ends(line),
            ("FINI", []) => {
                self.script.ends(line);
                self.closed = true;
            }
            ("MULTAX", [] | ["ON"]) | ("", []) | ("STOP" | "OPSTOP", []) | ("COOLNT" | "MACHIN", _) => {}
            (free, _) if ["PARTNO", "PPRINT", "REMARK"].iter().any(|f| free.starts_with(f)) => {}
            ("CIRCLE" | "ARC", _) => return Err("arcs are not read".into()),
            _ => return Err(format!("\"{major}\" is not known so")),
        }
        Ok(())
    }

    fn push(&mut self, block: Block) {
        let tool_calls = self.script.calls.len();
        self.script.blocks.push(Block { tool_calls, setting: self.setting, ..block });
    }

    fn load(&mut self, line: usize, tool: &str) -> Read<()> {
        let tool = number(tool)?.to_string();
        self.setting.length = if tool == "0" { LengthOffset::Off } else { LengthOffset::Unsaid };
        self.setting.turning = Turning::Off;
        self.script.calls.push(Call { line, tool: Some(tool) });
        Ok(())
    }

    fn unit(&mut self, unit_mm: f64) -> Read<()> {
        if unit_mm != self.unit_mm
            && !(self.script.blocks.is_empty() && self.feed.is_none() && self.script.cutters.is_empty())
        {
            return Err("the unit changes within the program".into());
        }
        self.unit_mm = unit_mm;
        Ok(())
    }

    /// `FEDRAT/200,MMPM`, mm/min.
    fn feedrate(&self, words: &[&str]) -> Read<f64> {
        let (mut feed, mut unit_mm) = (None, self.unit_mm);
        for word in words {
            match *word {
                "MMPM" => unit_mm = 1.0,
                "IPM" => unit_mm = 25.4,
                "PERMIN" => {}
                _ if feed.is_none() => feed = Some(number(word)?),
                _ => return Err(format!("\"{word}\" is not known in FEDRAT")),
            }
        }
        let feed = feed.map(|f| f * unit_mm).filter(|f| *f > 0.0 && f.is_finite());
        feed.ok_or_else(|| "FEDRAT needs a number greater than 0".into())
    }

    /// `SPINDL/6000,CLW`, `SPINDL/ON`, `SPINDL/OFF`.
    fn spindle(&mut self, words: &[&str]) -> Read<()> {
        let mut turning = Turning::Right;
        for word in words {
            match *word {
                "OFF" => turning = Turning::Off,
                "CCLW" => turning = Turning::Left,
                "CLW" | "ON" | "RPM" => {}
                _ => self.setting.rpm = Some(number(word)?),
            }
        }
        self.setting.turning = turning;
        Ok(())
    }

    fn go(&mut self, line: usize, numbers: &[&str]) -> Read<()> {
        let v = numbers.iter().map(|n| number(n)).collect::<Read<Vec<f64>>>()?;
        let &[x, y, z, i, j, k] = &v[..] else {
            return Err("GOTO needs x, y, z, i, j, k".into());
        };
        let point = [x, y, z].map(|c| Some(c * self.unit_mm));
        let place = Destination::Vector { point, axis: [i, j, k] };
        let feed = match (std::mem::take(&mut self.rapid), self.feed) {
            (true, _) => Feed::Rapid,
            (false, Some(f)) => Feed::PerMinute(f),
            (false, None) => return Err("GOTO before any FEDRAT".into()),
        };
        self.push(Block::straight(line, place, feed));
        Ok(())
    }
}

fn number(text: &str) -> Read<f64> {
    let value = text.parse::<f64>().ok().filter(|v| v.is_finite());
    value.ok_or_else(|| format!("\"{text}\" is not a number"))
}
