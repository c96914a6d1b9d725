//! Words of axes: where they go, and on which polynomials.

use super::words::CodeWord;
use super::{LineWords, Modal};
use crate::read::program::block::{Bend, RotaryWay};

/// Whether an address is of a rotary axis, and which: `X`, `PO[X]`; `None` for any other.
pub(super) fn axis(address: &str) -> Option<(bool, usize)> {
    let name = address.strip_prefix("PO[").and_then(|a| a.strip_suffix(']')).unwrap_or(address);
    let place = |names: [&str; 3]| names.iter().position(|n| *n == name);
    place(["X", "Y", "Z"]).map(|k| (false, k)).or(place(["A", "B", "C"]).map(|k| (true, k)))
}

/// A word of an axis: `X1`, `A=IC(1)`, `PO[X]=(1,2,3)`, `X=PO(1,2,3)`.
pub(super) fn to_axis(
    word: &CodeWord,
    (rotary, axis): (bool, usize),
    modal: &Modal,
    said: &mut LineWords,
) -> Result<(), String> {
    let CodeWord { address, ref value, raw, .. } = *word;
    let inner =
        |name: &str| value.strip_prefix(name).and_then(|v| v.strip_prefix('(')).and_then(|v| v.strip_suffix(')'));
    let scale = if modal.inch && !rotary { 25.4 } else { 1.0 };
    let polynomial = if address.starts_with("PO[") { inner("") } else { inner("PO") };
    if address.starts_with("PO[") && polynomial.is_none() {
        return Err(format!("{raw} is no polynomial"));
    }
    let named = [
        ("IC", RotaryWay::By),
        ("AC", RotaryWay::To),
        ("DC", RotaryWay::Shorter),
        ("ACP", RotaryWay::Up),
        ("ACN", RotaryWay::Down),
    ];
    let called = named.iter().find_map(|(name, way)| inner(name).map(|v| (v, Some(*way))));
    let (plain, way) = called.unwrap_or((value.as_str(), None));
    if !rotary && way.is_some_and(|w| w != RotaryWay::By && w != RotaryWay::To) {
        return Err(format!("{raw} is for rotary axes"));
    }
    let list = match polynomial {
        Some(list) => list.split(',').map(|v| word.number_of(v)).collect::<Result<Vec<f64>, _>>()?,
        None => vec![word.number_of(plain)?],
    };
    let (end, coefficients) = list.split_first().ok_or_else(|| format!("{raw} has no end"))?;
    if coefficients.len() > 4 {
        return Err(format!("{raw} has a polynomial of more than degree 5"));
    }
    let k = usize::from(rotary);
    let words = if rotary { &mut said.rotary } else { &mut said.point };
    if words[axis].replace(scale * end).is_some() {
        return Err(format!("{raw} is a second word of its axis"));
    }
    said.ways[k][axis] = way;
    for (to, from) in said.bend[k][axis].iter_mut().zip(coefficients) {
        *to = scale * from;
    }
    Ok(())
}

/// The polynomials of a line over `p` from 0 to 1.
pub(super) fn bend(said: &LineWords, with_path: bool) -> Result<Bend, String> {
    let interval = said.interval.unwrap_or(1.0);
    if interval <= 0.0 {
        return Err(format!("PL={interval} must be greater than 0"));
    }
    let powers: [f64; 4] = std::array::from_fn(|k| interval.powi(k as i32 + 2));
    let [point, rotary] = said.bend.map(|of| of.map(|a| std::array::from_fn(|k| a[k] * powers[k])));
    // A rotary axis goes with the length of a bent way then, not with p.
    let bent = point.as_flattened().iter().any(|a| *a != 0.0);
    if !with_path && bent && said.rotary.iter().any(Option::is_some) {
        return Err("a rotary axis beside a bent way is read under UPATH only".into());
    }
    Ok(Bend { point, rotary, begins: None })
}
