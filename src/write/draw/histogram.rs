//! How often which height of the scallop occurs, on the surface and on the ridges.

use crate::artifact::CheckReport;
use crate::artifact::report::Place;

/// Bars of the histogram, about.
const BARS: usize = 40;

/// A width of bars that people count in: 1, 2 or 5 times a power of ten.
fn round_step(span: f64) -> f64 {
    let raw = span / BARS as f64;
    let ten = 10f64.powf(raw.log10().floor());
    [1.0, 2.0, 5.0, 10.0].into_iter().map(|m| m * ten).find(|s| *s >= raw).unwrap_or(raw)
}

/// Counts of heights in bars from `from`, `step` wide; every height is in one of them.
fn counts(places: &[Place], from: f64, step: f64, bars: usize) -> Vec<usize> {
    let mut out = vec![0; bars];
    for p in places {
        let k = ((p.height_mm - from) / step).floor().max(0.0) as usize;
        if let Some(n) = out.get_mut(k.min(bars.saturating_sub(1))) {
            *n += 1;
        }
    }
    out
}

/// Counts of heights in bars.
#[derive(Clone, Debug, PartialEq, serde::Serialize)]
pub struct Histogram {
    /// Lower edge of the first bar, mm.
    pub from: f64,
    /// Width of a bar, mm.
    pub step: f64,
    /// Samples of the surface in each bar.
    pub samples: Vec<usize>,
    /// Ridges in each bar.
    pub ridges: Vec<usize>,
}

/// Histogram of samples and of ridges over the same bars; nothing where nothing was measured.
pub fn histogram(checks: &CheckReport) -> Option<Histogram> {
    let heights = || checks.scallop.iter().chain(&checks.ridges).map(|p| p.height_mm).filter(|h| h.is_finite());
    let (lo, hi) = heights().fold((f64::INFINITY, f64::NEG_INFINITY), |(a, b), h| (a.min(h), b.max(h)));
    if !(lo <= hi) {
        return None;
    }
    let step = round_step((hi - lo).max(1e-6));
    let from = (lo / step).floor() * step;
    let bars = ((hi - from) / step).floor() as usize + 1;
    let (samples, ridges) = (counts(&checks.scallop, from, step, bars), counts(&checks.ridges, from, step, bars));
    Some(Histogram { from, step, samples, ridges })
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used)]
    use super::*;
    use crate::geometry::Point;
    use crate::sample;

    #[test]
    fn every_height_is_counted_once() {
        let place = |k: usize| Place { point: Point::origin(), row: k, height_mm: 0.002 + 1e-5 * k as f64 };
        let mut checks = sample::report();
        assert!(histogram(&checks).is_none());
        checks.scallop = (0..1000).map(place).collect();
        checks.ridges = (500..600).map(place).collect();
        let h = histogram(&checks).unwrap();
        let sum = |counts: &[usize]| counts.iter().sum::<usize>();
        assert_eq!((sum(&h.samples), sum(&h.ridges)), (1000, 100));
        assert!((20..=BARS + 1).contains(&h.samples.len()), "{}", h.samples.len());
        // Bar k holds what lies from `from + k step` on.
        let k = ((0.007_05 - h.from) / h.step) as usize;
        assert!(h.ridges[k] > 0 && h.ridges[0] == 0);
    }
}
