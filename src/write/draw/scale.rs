//! Scales of the plots that are drawn as SVG.

/// Straight scale from values to pixels.
pub(super) struct Scale {
    /// Values at both ends.
    pub from: [f64; 2],
    /// Pixels at both ends.
    pub to: [f64; 2],
}

impl Scale {
    /// Where a value stands, px.
    pub fn at(&self, v: f64) -> f64 {
        let span = self.from[1] - self.from[0];
        // All values alike stand in the middle.
        let share = if span == 0.0 { 0.5 } else { (v - self.from[0]) / span };
        self.to[0] + share * (self.to[1] - self.to[0])
    }

    /// About `count` round values, and the digits after the point that they need.
    pub fn ticks(&self, count: f64) -> (Vec<f64>, usize) {
        let raw = (self.from[1] - self.from[0]).abs() / count;
        let ten = 10f64.powf(raw.log10().floor());
        let step = [1.0, 2.0, 5.0, 10.0].into_iter().map(|m| m * ten).find(|s| *s >= raw * 0.999).unwrap_or(raw);
        let first = (self.from[0] / step - 1e-9).ceil() as i64;
        let last = (self.from[1] / step + 1e-9).floor() as i64;
        let digits = (-(step.log10() + 1e-9).floor()).clamp(0.0, 9.0) as usize;
        // Adding 0 turns -0 into 0.
        ((first..=last.min(first + 60)).map(|k| k as f64 * step + 0.0).collect(), digits)
    }
}
