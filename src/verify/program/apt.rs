//! APT cutter-location files.

use super::block::{Block, Feed, Place};
use super::unreadable;
use crate::error::Result;

/// Longest line that APT processors take.
const LINE: usize = 72;

/// Reads a file.
///
/// # Errors
/// A statement that is not understood or a line that is too long, with the line.
pub(super) fn read(text: &str) -> Result<Vec<Block>> {
    let mut out = Vec::new();
    let (mut feed, mut rapid, mut tool_calls) = (None, false, 0);
    let mut statement = String::new();
    for (i, raw) in text.lines().enumerate() {
        let line = i + 1;
        if raw.len() > LINE {
            return Err(unreadable(line, &format!("{} characters, at most {LINE} are read", raw.len())));
        }
        let code = raw.split("$$").next().unwrap_or("").trim_end();
        if let Some(open) = code.strip_suffix('$') {
            statement.push_str(open.trim());
            continue;
        }
        statement.push_str(code.trim());
        let whole = std::mem::take(&mut statement);
        let (major, minor) = whole.split_once('/').unwrap_or((&whole, ""));
        match major {
            "RAPID" => rapid = true,
            "LOADTL" => tool_calls += 1,
            // Where home is, is the machine's: from then on nothing is known.
            "GOHOME" => {
                let unknown = Place::Words { point: [Some(f64::NAN); 3], rotary: [None; 3] };
                out.push(Block { machine: true, tool_calls, ..Block::straight(line, unknown, Feed::Rapid) });
            }
            "FEDRAT" => {
                let f = minor.split(',').next().and_then(|v| v.parse::<f64>().ok()).filter(|f| *f > 0.0);
                feed = Some(f.ok_or_else(|| unreadable(line, "FEDRAT needs a number greater than 0"))?);
            }
            "GOTO" => {
                let v: Vec<f64> = minor.split(',').filter_map(|v| v.trim().parse().ok()).collect();
                let &[x, y, z, i, j, k] = &v[..] else {
                    return Err(unreadable(line, "GOTO needs x, y, z, i, j, k"));
                };
                let place = Place::Vector { point: [Some(x), Some(y), Some(z)], axis: [i, j, k] };
                let feed = match (std::mem::take(&mut rapid), feed) {
                    (true, _) => Feed::Rapid,
                    (false, Some(f)) => Feed::PerMinute(f),
                    (false, None) => return Err(unreadable(line, "GOTO before any FEDRAT")),
                };
                out.push(Block { tool_calls, ..Block::straight(line, place, feed) });
            }
            "" | "PARTNO" | "PPRINT" | "UNITS" | "MULTAX" | "CUTTER" | "SPINDL" | "COOLNT" | "END" | "FINI" => {}
            _ => return Err(unreadable(line, &format!("\"{major}\" is not known"))),
        }
    }
    Ok(out)
}
