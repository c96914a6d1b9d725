//! Long lists of numbers as one block of bytes, deflated, in base 64.
//!
//! A number is kept as a whole number of steps, a step being a power of ten that is given for the
//! list: it comes back **within half a step**. Most lists are smooth, so what is written is how far
//! each number lies from where those before it point: from 0, from the last, from the line through
//! the last two or from the parabola through the last three, whichever leaves the least for the
//! whole list. These are small, and take a byte or two each even before the block is deflated.
//!
//! A list in the block: how many numbers, digits after the point (+ 32) and kind of forecast, then
//! the numbers. Whole numbers are written seven bits at a time, the lowest first, the eighth bit
//! set where more follow; those with a sign as 1, 2, 3, 4 … for 0, −1, 1, −2 …; 0 is a missing
//! value.

use base64::Engine;
use base64::engine::general_purpose::STANDARD;
use flate2::Compression;
use flate2::write::DeflateEncoder;
use serde_json::{Value, json};
use std::io::Write;

use crate::error::{Error, Result, Stage};

/// Digits after the point of lengths (mm) and angles (degrees) in lists.
pub(super) const DIGITS: i32 = 3;
/// The same of times (s).
pub(super) const TIME: i32 = 4;
/// The greatest number of steps: a script's numbers are whole up to 2⁵³, and so is twice what a
/// number of this size may lie off a parabola through others.
const MOST_STEPS: f64 = (1u64 << 48) as f64;
/// Steps that the greatest number of a list [`Pack::scaled`] has at least.
const SCALED_STEPS: f64 = 4_000.0;
/// Digits after the point that a list may have: −`MOST_DIGITS` to `MOST_DIGITS`.
const MOST_DIGITS: i32 = 30;

/// A block being filled.
#[derive(Default)]
pub(super) struct Pack {
    bytes: Vec<u8>,
    lists: usize,
}

impl Pack {
    /// Adds a list with `digits` after the point; in the page's JSON it is its number in the block.
    /// Missing values, and those of more than 2⁴⁸ steps, are not a number.
    pub(super) fn list(&mut self, digits: i32, values: impl IntoIterator<Item = f64>) -> Value {
        let digits = digits.clamp(-MOST_DIGITS, MOST_DIGITS);
        let scale = 10f64.powi(digits);
        let steps: Vec<Option<i64>> = values
            .into_iter()
            .map(|v| Some((v * scale).round()).filter(|k| k.abs() <= MOST_STEPS).map(|k| k as i64))
            .collect();
        let bits = |off: Option<i64>| off.map_or(0, |off| u64::BITS - off.unsigned_abs().leading_zeros());
        let size = |order: &u8| offs(&steps, *order).map(|off| u64::from(bits(off))).sum::<u64>();
        let order = (0..=3).min_by_key(size).unwrap_or(0);
        self.bytes.extend(varint(steps.len() as u64));
        self.bytes.extend([u8::try_from(digits + 32).unwrap_or(32), order]);
        self.bytes.extend(offs(&steps, order).flat_map(written));
        self.lists += 1;
        json!(self.lists - 1)
    }

    /// Adds a list whose step is at most a 4000th of the number of greatest size in it: for
    /// what a plot scales to its own height.
    pub(super) fn scaled(&mut self, values: impl IntoIterator<Item = f64>) -> Value {
        let values: Vec<f64> = values.into_iter().collect();
        let most = values.iter().filter(|v| v.is_finite()).fold(0.0f64, |most, v| most.max(v.abs()));
        let digits = if most > 0.0 { (SCALED_STEPS / most).log10().ceil() as i32 } else { 0 };
        self.list(digits, values)
    }

    /// The block as it stands in the page.
    ///
    /// # Errors
    /// As [`deflated`].
    pub(super) fn text(&self) -> Result<String> {
        deflated(&self.bytes)
    }
}

/// What each number lies off the forecast from those before it; missing ones are passed over.
fn offs(steps: &[Option<i64>], order: u8) -> impl Iterator<Item = Option<i64>> {
    let mut before = [0; 3];
    steps.iter().map(move |step| {
        let step = (*step)?;
        let off = step - forecast(order, before);
        before = [step, before[0], before[1]];
        Some(off)
    })
}

/// The next number by those before it, the last first.
fn forecast(order: u8, [a, b, c]: [i64; 3]) -> i64 {
    match order {
        0 => 0,
        1 => a,
        2 => 2 * a - b,
        _ => 3 * (a - b) + c,
    }
}

fn written(off: Option<i64>) -> impl Iterator<Item = u8> {
    varint(off.map_or(0, |off| 1 + (((off << 1) ^ (off >> 63)) as u64)))
}

fn varint(mut value: u64) -> std::vec::IntoIter<u8> {
    let mut out = Vec::with_capacity(2);
    while value >= 0x80 {
        out.push((value & 0x7f) as u8 | 0x80);
        value >>= 7;
    }
    out.push(value as u8);
    out.into_iter()
}

/// Any bytes, deflated (RFC 1951), in base 64.
///
/// # Errors
/// `InputOutput` where they cannot be deflated.
pub(super) fn deflated(bytes: &[u8]) -> Result<String> {
    let mut out = DeflateEncoder::new(Vec::new(), Compression::best());
    out.write_all(bytes)
        .and_then(|()| out.finish())
        .map(|bytes| STANDARD.encode(bytes))
        .map_err(|e| Error::io(Stage::Preview, format!("the report's data cannot be deflated: {e}")).caused_by(e))
}

/// The lists of a block, as the page's script reads them.
#[cfg(test)]
pub(super) fn unpacked(text: &str) -> Vec<Vec<f64>> {
    let bytes = inflated(text);
    let (mut at, mut lists) = (0, Vec::new());
    let next = |at: &mut usize| {
        let (mut value, mut shift) = (0u64, 0);
        loop {
            let byte = bytes[*at];
            *at += 1;
            value |= u64::from(byte & 0x7f) << shift;
            shift += 7;
            if byte < 0x80 {
                return value;
            }
        }
    };
    while at < bytes.len() {
        let count = next(&mut at);
        let (digits, order) = (i32::from(bytes[at]) - 32, bytes[at + 1]);
        at += 2;
        let mut before = [0; 3];
        let mut one = || {
            let code = next(&mut at).checked_sub(1)?;
            let off = (code >> 1) as i64 ^ -((code & 1) as i64);
            let step = off + forecast(order, before);
            before = [step, before[0], before[1]];
            Some(step as f64 / 10f64.powi(digits))
        };
        lists.push((0..count).map(|_| one().unwrap_or(f64::NAN)).collect());
    }
    lists
}

/// The bytes that a text of the page stands for.
#[cfg(test)]
pub(super) fn inflated(text: &str) -> Vec<u8> {
    use std::io::Read;
    let bytes = STANDARD.decode(text).unwrap_or_default();
    let mut out = Vec::new();
    let read = flate2::read::DeflateDecoder::new(&bytes[..]).read_to_end(&mut out);
    assert!(read.is_ok(), "{read:?}");
    out
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used)]
    use super::*;

    #[test]
    fn numbers_come_back_within_half_a_step() {
        let smooth: Vec<f64> = (0..3000).map(|k| 1e5 + 37.123_456 * (0.01 * f64::from(k)).sin()).collect();
        let mut noise = 1u64;
        let mut rough = || {
            noise = noise.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1);
            (noise >> 40) as f64 / 101.37 - 8e4
        };
        let rough: Vec<f64> = (0..3000).map(|_| rough()).collect();
        let mut pack = Pack::default();
        let lists = [&smooth, &rough];
        for digits in [-2, 0, 3, 5] {
            lists.iter().for_each(|l| drop(pack.list(digits, l.iter().copied())));
        }
        let mut scaled = rough.clone();
        scaled.push(-3.5e9);
        assert_eq!(pack.scaled(scaled.iter().copied()), json!(8));
        let back = unpacked(&pack.text().unwrap());
        assert_eq!(back.len(), 9);
        for (k, back) in back[..8].iter().enumerate() {
            let half = 0.5 * 10f64.powi(-[-2, 0, 3, 5][k / 2]);
            let most = lists[k % 2].iter().zip(back).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
            // The bound is kept, and no list is finer than it was asked for.
            assert!(most <= half * (1.0 + 1e-6) && most > 0.5 * half, "list {k}: {most} for {half}");
            assert_eq!(lists[k % 2].len(), back.len());
        }
        let most = scaled.iter().zip(&back[8]).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
        assert!(most <= 3.5e9 / 8_000.0 && most > 3.5e9 / 160_000.0, "{most}");
    }

    #[test]
    fn missing_odd_and_no_numbers_pass() {
        let mut pack = Pack::default();
        pack.list(3, [1.0, f64::NAN, 1.5, f64::INFINITY, 1e300, -2.0]);
        pack.list(0, []);
        pack.scaled([f64::NAN, 0.0]);
        pack.scaled([1e-280, -1e-281]);
        let back = unpacked(&pack.text().unwrap());
        assert_eq!((back[0][0], back[0][2], back[0][5]), (1.0, 1.5, -2.0));
        assert!([1, 3, 4].iter().all(|&k| back[0][k].is_nan()) && back[1].is_empty());
        assert!(back[2][0].is_nan() && back[2][1] == 0.0 && back[3] == [0.0, 0.0]);
    }

    #[test]
    fn what_is_smooth_is_small() {
        let mut pack = Pack::default();
        pack.list(3, (0..10_000).map(|k| 40.0 * (0.01 * f64::from(k)).sin()));
        assert!(pack.bytes.len() < 10_100, "{} bytes for 10 000 numbers", pack.bytes.len());
    }
}
