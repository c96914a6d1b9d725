//! Numbers of a program, in fixed point.

use crate::error::{Error, Result, Stage};

/// A number in fixed point, exactly as rounded: an integer count of `10^-decimals`.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(super) struct Fixed {
    units: i64,
    decimals: usize,
}

impl Fixed {
    /// Rounds to `decimals` digits after the point.
    ///
    /// # Errors
    /// A value that is not finite or beyond ±10⁹.
    pub(super) fn new(value: f64, decimals: usize) -> Result<Self> {
        if !(value.is_finite() && value.abs() < 1e9) {
            return Err(Error::usage(Stage::Post, format!("{value} cannot be written as a word of a program")));
        }
        let scale = 10f64.powi(i32::try_from(decimals).unwrap_or(6));
        // The cast is exact: |value · scale| < 1e15 for at most 6 decimals.
        Ok(Fixed { units: (value * scale).round() as i64, decimals })
    }
    /// The difference from an earlier rounded number: adds up without error.
    pub(super) fn since(self, earlier: Fixed) -> Fixed {
        Fixed { units: self.units - earlier.units, decimals: self.decimals }
    }
    /// The number that it is written as.
    pub(super) fn value(self) -> f64 {
        self.units as f64 / 10f64.powi(i32::try_from(self.decimals).unwrap_or(6))
    }
    /// It is written as 0.
    pub(super) fn is_zero(self) -> bool {
        self.units == 0
    }
    /// The number reduced to `0 … range`, without `range` itself.
    pub(super) fn modulo(self, range: i64) -> Fixed {
        let one = 10i64.pow(u32::try_from(self.decimals).unwrap_or(6));
        Fixed { units: self.units.rem_euclid(range * one), decimals: self.decimals }
    }
    /// The number as text: `plus` puts a sign before what is not negative, `trim` takes zeros off
    /// the end.
    pub(super) fn text(self, plus: bool, trim: bool) -> String {
        let sign = match self.units {
            u if u < 0 => "-",
            _ if plus => "+",
            _ => "",
        };
        let magnitude = self.units.unsigned_abs();
        if self.decimals == 0 {
            return format!("{sign}{magnitude}");
        }
        let one = 10u64.pow(u32::try_from(self.decimals).unwrap_or(6));
        let mut text = format!("{sign}{}.{:0width$}", magnitude / one, magnitude % one, width = self.decimals);
        if trim {
            text.truncate(text.trim_end_matches('0').len());
        }
        text
    }
}
