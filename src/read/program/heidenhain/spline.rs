//! Blocks of Klartext that go along cubic polynomials: `SPL`.

use super::{HeidenhainReader, Read};
use crate::read::program::block::{Bend, Destination, Interpolation};

impl HeidenhainReader {
    /// One `SPL` block: `X(t) = K3X t³ + K2X t² + K1X t + X`, `t` from 1 to 0, and likewise of
    /// every axis that it names. An exponent may stand apart from its number.
    pub(super) fn spline(&mut self, line: usize, words: &[&str]) -> Read<()> {
        // K1, K2, K3 of the point and the rotary axes.
        let mut factors = [[[None; 3]; 3]; 2];
        let mut rest: Vec<&str> = Vec::new();
        let mut words = words.iter().peekable();
        while let Some(word) = words.next() {
            let Some(named) = word.strip_prefix('K') else {
                rest.push(word);
                continue;
            };
            let mut letters = named.chars();
            let order = letters.next().and_then(|c| c.to_digit(10)).filter(|k| (1..=3).contains(k));
            let axis = letters.next().and_then(|c| "XYZABC".find(c));
            let (Some(order), Some(axis)) = (order, axis) else { return Err(format!("\"{word}\" is not known")) };
            let is_exponent = |next: &&&str| next.starts_with('E') && next.len() > 1;
            let whole = format!("{word}{}", words.next_if(is_exponent).unwrap_or(&""));
            let factor = self.value(&whole, word.get(..3).unwrap_or(""))?;
            if factors[axis / 3][axis % 3][order as usize - 1].replace(factor).is_some() {
                return Err(format!("\"{word}\" is a second word of its axis"));
            }
        }
        let before = self.script.blocks.len();
        self.moves(line, "SPL", &rest)?;
        let Some(block) = self.script.blocks.get_mut(before) else { return Err("an SPL block goes nowhere".into()) };
        let Destination::Words { point, rotary } = block.place else { return Err("a vector in an SPL block".into()) };
        if rest.iter().any(|word| word.starts_with('I')) {
            return Err("steps in an SPL block".into());
        }
        let mut bend = Bend { begins: Some([[0.0; 3]; 2]), ..Bend::default() };
        for (kind, ends) in [point, rotary].into_iter().enumerate() {
            for axis in 0..3 {
                let (k1, k2, k3) = match (ends[axis], factors[kind][axis]) {
                    (None, [None, None, None]) => continue,
                    (Some(_), [Some(k1), Some(k2), Some(k3)]) => (k1, k2, k3),
                    _ => return Err("an SPL block needs the end and K3, K2, K1 of every axis that it names".into()),
                };
                // From t to p = 1 - t.
                let of = if kind == 0 { &mut bend.point } else { &mut bend.rotary };
                of[axis] = [k2 + 3.0 * k3, -k3, 0.0, 0.0];
                if let Some(begins) = &mut bend.begins {
                    begins[kind][axis] = k1 + k2 + k3;
                }
            }
        }
        block.course = Interpolation::Bent(bend);
        Ok(())
    }
}
