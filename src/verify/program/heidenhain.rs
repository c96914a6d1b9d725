//! Heidenhain Klartext: `L` and `LN` blocks, `TCPM`, machine coordinates by `M91`.

use super::block::{Block, Feed, Place};
use super::unreadable;
use crate::error::Result;

/// Reads a program.
///
/// # Errors
/// A block that is not understood or not in sequence, with the line.
pub(super) fn read(text: &str) -> Result<Vec<Block>> {
    let mut out = Vec::new();
    let (mut centre_point, mut feed, mut tool_calls) = (false, None, 0);
    for (i, line) in text.lines().enumerate() {
        let number = i + 1;
        let code = line.split(';').next().unwrap_or("").trim();
        let (count, rest) = code.split_once(' ').unwrap_or((code, ""));
        if count.parse::<usize>() != Ok(i) {
            return Err(unreadable(number, &format!("the block number is \"{count}\", it must be {i}")));
        }
        let rest = rest.trim();
        match rest.split_whitespace().next() {
            Some("L" | "LN") => {
                for word in rest.split_whitespace() {
                    centre_point = word == "M128" || centre_point && word != "M129";
                }
                let block = straight(number, rest, centre_point, &mut feed).map_err(|e| unreadable(number, &e))?;
                out.extend(block.map(|b| Block { tool_calls, ..b }));
            }
            Some("FUNCTION") if rest.starts_with("FUNCTION TCPM ") => centre_point = true,
            Some("FUNCTION") if rest == "FUNCTION RESET TCPM" => centre_point = false,
            Some("M128") => centre_point = true,
            Some("M129") => centre_point = false,
            Some("TOOL") => tool_calls += usize::from(rest.starts_with("TOOL CALL")),
            None | Some("BEGIN" | "END" | "CYCL" | "BLK") => {}
            Some(word) if word.strip_prefix('M').is_some_and(|n| n.parse::<u32>().is_ok()) => {}
            Some(word) => return Err(unreadable(number, &format!("\"{word}\" is not known"))),
        }
    }
    Ok(out)
}

/// One `L` or `LN` block.
fn straight(
    line: usize,
    code: &str,
    centre_point: bool,
    feed: &mut Option<f64>,
) -> std::result::Result<Option<Block>, String> {
    let mut point = [None; 3];
    let mut rotary = [None; 3];
    let mut axis = [None; 3];
    let (mut machine, mut rapid) = (false, false);
    for word in code.split_whitespace().skip(1) {
        let number = |prefix: &str| -> std::result::Result<f64, String> {
            let text = word.strip_prefix(prefix).unwrap_or("").replace(',', ".");
            text.parse().ok().filter(|v: &f64| v.is_finite()).ok_or_else(|| format!("\"{word}\" is not a number"))
        };
        match word {
            "R0" => {}
            "FMAX" => rapid = true,
            "M91" => machine = true,
            _ if word.starts_with("TX") => axis[0] = Some(number("TX")?),
            _ if word.starts_with("TY") => axis[1] = Some(number("TY")?),
            _ if word.starts_with("TZ") => axis[2] = Some(number("TZ")?),
            _ if word.starts_with('X') => point[0] = Some(number("X")?),
            _ if word.starts_with('Y') => point[1] = Some(number("Y")?),
            _ if word.starts_with('Z') => point[2] = Some(number("Z")?),
            _ if word.starts_with('A') => rotary[0] = Some(number("A")?),
            _ if word.starts_with('B') => rotary[1] = Some(number("B")?),
            _ if word.starts_with('C') => rotary[2] = Some(number("C")?),
            _ if word.starts_with('F') => *feed = Some(number("F")?),
            _ if word.starts_with('M') => {
                number("M")?;
            }
            _ => return Err(format!("\"{word}\" is not known")),
        }
    }
    let place = match axis {
        [None, None, None] => Place::Words { point, rotary },
        [Some(x), Some(y), Some(z)] => Place::Vector { point, axis: [x, y, z] },
        _ => return Err("an LN block needs TX, TY and TZ".into()),
    };
    if point.iter().chain(&rotary).all(Option::is_none) {
        return Ok(None);
    }
    let feed = match (rapid, *feed) {
        (true, _) => Feed::Rapid,
        (false, Some(f)) if f > 0.0 => Feed::PerMinute(f),
        _ => return Err("a straight block before any F".into()),
    };
    Ok(Some(Block { machine, centre_point, ..Block::straight(line, place, feed) }))
}
