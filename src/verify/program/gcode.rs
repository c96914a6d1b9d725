//! G code: ISO 6983 as LinuxCNC, Fanuc and Siemens 840D speak it.

use super::block::{Bend, Block, Feed, Place, Way};
use super::unreadable;
use crate::error::Result;

/// State that stays from line to line.
struct Modal {
    rapid: bool,
    /// `POLY` is on.
    polynomial: bool,
    inverse: bool,
    steps: bool,
    inch: bool,
    centre_point: bool,
    tool_length: bool,
    feed: Option<f64>,
    tool_calls: usize,
}

/// What a line says.
#[derive(Default)]
struct Said {
    point: [Option<f64>; 3],
    rotary: [Option<f64>; 3],
    /// Of X, Y, Z and of A, B, C; `None`: as G90 or G91 says.
    ways: [[Option<Way>; 3]; 2],
    /// Coefficients of `p²` and on, of X, Y, Z and of A, B, C.
    bend: [[[f64; 4]; 3]; 2],
    /// Length of the interval of `p`.
    interval: Option<f64>,
    vector: [Option<f64>; 3],
    feed: Option<f64>,
    machine: bool,
    /// Words are a call's, not a move's.
    call: bool,
}

/// Reads a program.
///
/// # Errors
/// A word that is not understood, with the line.
pub(super) fn read(text: &str) -> Result<Vec<Block>> {
    let mut modal = Modal {
        rapid: true,
        polynomial: false,
        inverse: false,
        steps: false,
        inch: false,
        centre_point: false,
        tool_length: false,
        feed: None,
        tool_calls: 0,
    };
    let mut out = Vec::new();
    for (i, line) in text.lines().enumerate() {
        let number = i + 1;
        let code = code(line).map_err(|e| unreadable(number, &e))?;
        let mut said = Said::default();
        for (address, value) in words(&code).map_err(|e| unreadable(number, &e))? {
            take(&address, &value, &mut modal, &mut said).map_err(|e| unreadable(number, &e))?;
        }
        out.extend(block(number, &mut modal, said).map_err(|e| unreadable(number, &e))?);
    }
    Ok(out)
}

/// The line without comments and tape signs.
fn code(line: &str) -> std::result::Result<String, String> {
    let mut out = String::new();
    let mut rest = line.trim();
    if rest == "%" {
        return Ok(out);
    }
    while let Some(at) = rest.find(['(', ';']) {
        let (before, from) = rest.split_at(at);
        out.push_str(before);
        if from.starts_with(';') {
            return Ok(out);
        }
        let close = closing(from).ok_or("a ( without its )")?;
        // A bracket right after a letter, a digit or = belongs to a word (IC(…), CYCLE832(…), PO[X]=(…)); any other opens a comment.
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

/// Words of a line: address and value as text.
fn words(code: &str) -> std::result::Result<Vec<(String, String)>, String> {
    let mut out = Vec::new();
    for token in code.split_whitespace() {
        if let Some((address, value)) = token.split_once('=') {
            out.push((address.to_ascii_uppercase(), value.to_owned()));
            continue;
        }
        if token.contains('(') || token.chars().skip(1).any(|c| c.is_ascii_alphabetic()) && long(token) {
            out.push((token.to_ascii_uppercase(), String::new()));
            continue;
        }
        // Words may stand without spaces: G1X2.5Y-3.
        let mut rest = token;
        while let Some(letter) = rest.chars().next() {
            if !letter.is_ascii_alphabetic() {
                return Err(format!("\"{token}\" is not a word"));
            }
            let end = rest[1..].find(|c: char| c.is_ascii_alphabetic()).map_or(rest.len(), |e| e + 1);
            out.push((letter.to_ascii_uppercase().to_string(), rest[1..end].to_owned()));
            rest = &rest[end..];
        }
    }
    Ok(out)
}

/// A keyword, not a row of words: letters follow one another.
fn long(token: &str) -> bool {
    token.as_bytes().windows(2).any(|w| w[0].is_ascii_alphabetic() && w[1].is_ascii_alphabetic())
}

fn take(address: &str, value: &str, modal: &mut Modal, said: &mut Said) -> std::result::Result<(), String> {
    let number = |v: &str| number(address, v);
    if let Some((rotary, axis)) = axis(address) {
        return to_axis(address, value, rotary, axis, modal, said);
    }
    match address {
        "G" => preparatory(value, modal, said)?,
        "POLY" => (modal.rapid, modal.polynomial) = (false, true),
        "PL" => said.interval = Some(number(value)?),
        "I" | "A3" => said.vector[0] = Some(number(value)?),
        "J" | "B3" => said.vector[1] = Some(number(value)?),
        "K" | "C3" => said.vector[2] = Some(number(value)?),
        "F" => said.feed = Some(number(value)?),
        "TRAORI" | "TRAORI(1)" => modal.centre_point = true,
        "TRAFOOF" => modal.centre_point = false,
        "SUPA" => said.machine = true,
        "M" => modal.tool_calls += usize::from(number(value)? == 6.0),
        "N" | "O" | "T" | "S" | "H" | "D" | "P" | "Q" => {
            number(value)?;
        }
        "ORIWKS" | "ORIMKS" | "ORIAXES" | "SOFT" | "BRISK" | "FFWON" | "FFWOF" | "COMPCAD" | "COMPCURV"
        | "COMPSURF" | "COMPOF" | "STOPRE" | "CDOF" | "CDOF2" | "UPATH" | "SPATH" => {}
        _ if ["CYCLE", "FGROUP(", "MSG(", "POLYPATH("].iter().any(|c| address.starts_with(c)) => said.call = true,
        _ => return Err(format!("the word {address}{value} is not known")),
    }
    Ok(())
}

fn number(address: &str, v: &str) -> std::result::Result<f64, String> {
    v.parse::<f64>().ok().filter(|x| x.is_finite()).ok_or_else(|| format!("{address}{v} is not a number"))
}

/// Whether an address is of a rotary axis, and which: `X`, `PO[X]`; `None` for any other.
fn axis(address: &str) -> Option<(bool, usize)> {
    let name = address.strip_prefix("PO[").and_then(|a| a.strip_suffix(']')).unwrap_or(address);
    let place = |names: [&str; 3]| names.iter().position(|n| *n == name);
    place(["X", "Y", "Z"]).map(|k| (false, k)).or(place(["A", "B", "C"]).map(|k| (true, k)))
}

/// A word of an axis: `X1`, `A=IC(1)`, `PO[X]=(1,2,3)`, `X=PO(1,2,3)`.
fn to_axis(
    address: &str,
    value: &str,
    rotary: bool,
    axis: usize,
    modal: &Modal,
    said: &mut Said,
) -> std::result::Result<(), String> {
    let inner =
        |name: &str| value.strip_prefix(name).and_then(|v| v.strip_prefix('(')).and_then(|v| v.strip_suffix(')'));
    let scale = if modal.inch && !rotary { 25.4 } else { 1.0 };
    let polynomial = if address.starts_with("PO[") { inner("") } else { inner("PO") };
    if address.starts_with("PO[") && polynomial.is_none() {
        return Err(format!("{address}={value} is no polynomial"));
    }
    let named = [("IC", Way::By), ("AC", Way::To), ("DC", Way::Shorter), ("ACP", Way::Up), ("ACN", Way::Down)];
    let called = named.iter().find_map(|(name, way)| inner(name).map(|v| (v, Some(*way))));
    let (plain, way) = called.unwrap_or((value, None));
    if !rotary && way.is_some_and(|w| w != Way::By && w != Way::To) {
        return Err(format!("{address}={value} is for rotary axes"));
    }
    let list = match polynomial {
        Some(list) => list.split(',').map(|v| number(address, v)).collect::<std::result::Result<Vec<f64>, _>>()?,
        None => vec![number(address, plain)?],
    };
    let (end, coefficients) = list.split_first().ok_or_else(|| format!("{address} has no end"))?;
    if coefficients.len() > 4 {
        return Err(format!("{address} has a polynomial of more than degree 5"));
    }
    let k = usize::from(rotary);
    said.ways[k][axis] = way;
    for (to, from) in said.bend[k][axis].iter_mut().zip(coefficients) {
        *to = scale * from;
    }
    let words = if rotary { &mut said.rotary } else { &mut said.point };
    words[axis] = Some(scale * end);
    Ok(())
}

fn preparatory(value: &str, modal: &mut Modal, said: &mut Said) -> std::result::Result<(), String> {
    match value.trim_start_matches('0') {
        "" => (modal.rapid, modal.polynomial) = (true, false),
        "1" => (modal.rapid, modal.polynomial) = (false, false),
        "20" | "70" | "700" => modal.inch = true,
        "21" | "71" | "710" => modal.inch = false,
        "43" => modal.tool_length = true,
        "43.4" | "43.5" => (modal.centre_point, modal.tool_length) = (true, false),
        "49" => (modal.centre_point, modal.tool_length) = (false, false),
        "53" => said.machine = true,
        "90" => modal.steps = false,
        "91" => modal.steps = true,
        "93" | "94" => {
            // The feed of one kind means nothing in the other.
            let inverse = value.ends_with('3');
            if inverse != modal.inverse {
                modal.feed = None;
            }
            modal.inverse = inverse;
        }
        "17" | "18" | "19" | "40" | "50" | "54" | "55" | "56" | "57" | "58" | "59" | "69" | "80" | "98" | "99"
        | "500" => {}
        // How corners are rounded, and looking ahead.
        "5.1" | "9" | "60" | "61" | "61.1" | "64" | "601" | "602" | "603" | "641" | "642" | "643" | "644" | "645" => {}
        _ => return Err(format!("G{value} is not known")),
    }
    Ok(())
}

/// The move that a line asks for, if any.
fn block(line: usize, modal: &mut Modal, said: Said) -> std::result::Result<Option<Block>, String> {
    if said.call {
        return Ok(None);
    }
    let vector = said.vector.iter().any(Option::is_some);
    let moves = vector || said.point.iter().chain(&said.rotary).any(Option::is_some);
    if let Some(f) = said.feed {
        modal.feed = Some(f);
    }
    if !moves {
        return Ok(None);
    }
    let feed = match (modal.rapid, modal.inverse, said.feed, modal.feed) {
        (true, ..) => Feed::Rapid,
        (false, true, Some(f), _) => Feed::PerMove(f),
        (false, true, None, _) => return Err("under G93 every line needs its own F".into()),
        (false, false, _, Some(f)) => Feed::PerMinute(if modal.inch { 25.4 * f } else { f }),
        (false, false, _, None) => return Err("a feed move before any F".into()),
    };
    if matches!(feed, Feed::PerMove(f) | Feed::PerMinute(f) if f <= 0.0) {
        return Err("F must be greater than 0".into());
    }
    if vector && modal.polynomial {
        return Err("vectors under POLY are not read".into());
    }
    let bend = if modal.polynomial { Some(bend(&said)?) } else { None };
    let usual = if modal.steps { Way::By } else { Way::To };
    let [point_ways, ways] = said.ways.map(|of| of.map(|way| way.unwrap_or(usual)));
    // A component that is left out is 0.
    let axis = said.vector.map(|v| v.unwrap_or(0.0));
    let place = if vector {
        Place::Vector { point: said.point, axis }
    } else {
        Place::Words { point: said.point, rotary: said.rotary }
    };
    Ok(Some(Block {
        line,
        place,
        steps: point_ways.map(|way| way == Way::By),
        ways,
        bend,
        feed,
        machine: said.machine,
        tool_length: modal.tool_length,
        centre_point: modal.centre_point,
        tool_calls: modal.tool_calls,
    }))
}

/// The polynomials of a line over `p` from 0 to 1.
fn bend(said: &Said) -> std::result::Result<Bend, String> {
    let interval = said.interval.unwrap_or(1.0);
    if interval <= 0.0 {
        return Err(format!("PL={interval} must be greater than 0"));
    }
    let powers: [f64; 4] = std::array::from_fn(|k| interval.powi(k as i32 + 2));
    let [point, rotary] = said.bend.map(|of| of.map(|a| std::array::from_fn(|k| a[k] * powers[k])));
    Ok(Bend { point, rotary })
}
