//! What a path can be coloured by: one value for each cutter location.

use crate::artifact::{CheckReport, Plan};
use crate::error::turn_number;
use crate::machine::Machine;

/// A quantity along the path.
#[derive(Clone, Debug, PartialEq)]
pub struct Values {
    /// Short name for programs.
    pub key: &'static str,
    /// What it is.
    pub name: &'static str,
    /// Its unit; empty for counts.
    pub unit: &'static str,
    /// One value for each location; not a number where there is none.
    pub of: Vec<f64>,
    /// Least and greatest value.
    pub range: [f64; 2],
    /// What colours span: [`spanned`] by the values.
    pub shown: [f64; 2],
}

/// Part of the values that colours may leave out at either end.
pub const LEFT_OUT: f64 = 0.02;

/// From the least to the greatest value, but for the ends that are rare: where [`LEFT_OUT`] of the
/// values take more than half of the way from the least to the greatest, colours end where these
/// begin. A few peaks would leave all the rest in one colour. Zeros where there is no value.
pub fn spanned(values: impl IntoIterator<Item = f64>) -> [f64; 2] {
    let mut all: Vec<f64> = values.into_iter().filter(|v| v.is_finite()).collect();
    all.sort_unstable_by(f64::total_cmp);
    let (Some(&lo), Some(&hi)) = (all.first(), all.last()) else { return [0.0; 2] };
    let off = (LEFT_OUT * (all.len() - 1) as f64).ceil() as usize;
    let (low, high) = (all[off.min(all.len() - 1)], all[all.len() - 1 - off.min(all.len() - 1)]);
    let half = 0.5 * (hi - lo);
    let ends = [if low - lo > half { low } else { lo }, if hi - high > half { high } else { hi }];
    // Where nearly all values are one, the others are what there is to see.
    if ends[1] > ends[0] { ends } else { [lo, hi] }
}

impl Values {
    /// Values with their range. `unit` is empty for counts.
    pub fn new(key: &'static str, name: &'static str, unit: &'static str, of: Vec<f64>) -> Self {
        let finite = of.iter().copied().filter(|v| v.is_finite());
        let [lo, hi] = finite.fold([f64::INFINITY, f64::NEG_INFINITY], |[lo, hi], v| [lo.min(v), hi.max(v)]);
        let shown = spanned(of.iter().copied());
        Values { key, name, unit, of, range: if lo <= hi { [lo, hi] } else { [0.0, 0.0] }, shown }
    }

    /// Where the value of a location lies in what colours span, 0 to 1; ½ where all are alike.
    pub fn share(&self, row: usize) -> f64 {
        let v = self.of.get(row).copied().unwrap_or(f64::NAN);
        let [lo, hi] = self.shown;
        if !v.is_finite() {
            f64::NAN
        } else if hi - lo > 1e-9 * hi.abs().max(lo.abs()) {
            ((v - lo) / (hi - lo)).clamp(0.0, 1.0)
        } else {
            0.5
        }
    }
}

/// All quantities, in the order in which they are offered: turn, scallop, width of the channel,
/// feed, axis acceleration.
///
/// * *scallop*: the ridge measured between this turn and the next, at the nearest place of the turn
///   where one was measured;
/// * *acceleration*: of the axis that is nearest to its limit there, as a share of that limit.
pub fn all(plan: &Plan, machine: &Machine, checks: Option<&CheckReport>) -> Vec<Values> {
    let locations = &plan.toolpath.locations;
    let n = locations.len();
    let most: Vec<f64> = machine.axes().iter().map(|a| a.limits.acceleration).collect();
    let busiest = |r: &[f64]| {
        let share = |(a, most): (&f64, &f64)| if *most > 0.0 { a.abs() / most } else { 0.0 };
        100.0 * r.iter().zip(&most).map(share).fold(0.0, f64::max)
    };
    let fitted = |mut v: Vec<f64>| {
        v.resize(n, f64::NAN);
        v
    };
    let widths = plan.channel.rows.iter().map(|r| (r.theta_max - r.theta_min).to_degrees()).collect();
    vec![
        Values::new("turn", "turn", "", locations.iter().map(|l| turn_number(l.turn) as f64).collect()),
        Values::new("scallop", "scallop to the next turn", "mm", scallop(plan, checks)),
        Values::new("width", "width of the channel", "°", fitted(widths)),
        Values::new("feed", "feed", "mm/min", fitted(plan.motion.feed.iter().map(|v| v * 60.0).collect())),
        Values::new(
            "acceleration",
            "acceleration of the busiest axis",
            "% of its limit",
            fitted(plan.motion.acceleration.iter().map(busiest).collect()),
        ),
    ]
}

/// The ridge nearest along the path, of the same turn and no farther than twice the rows between
/// two ridges.
fn scallop(plan: &Plan, checks: Option<&CheckReport>) -> Vec<f64> {
    let locations = &plan.toolpath.locations;
    let mut out = vec![f64::NAN; locations.len()];
    let Some(ridges) = checks.map(|c| &c.ridges).filter(|r| !r.is_empty()) else { return out };
    let mut rows: Vec<(usize, f64)> = ridges.iter().map(|r| (r.row, r.height_mm)).collect();
    rows.sort_by(|a, b| a.0.cmp(&b.0).then(a.1.total_cmp(&b.1)));
    let every = rows.windows(2).map(|w| w[1].0 - w[0].0).filter(|d| *d > 0).min().unwrap_or(1);
    let near = |k: usize, row: usize| rows.get(k).map(|r| (r.0.abs_diff(row), *r));
    let mut k = 0;
    for (row, value) in out.iter_mut().enumerate() {
        while near(k + 1, row).zip(near(k, row)).is_some_and(|(next, this)| next.0 <= this.0) {
            k += 1;
        }
        if let Some((apart, (at, height))) = near(k, row)
            && apart <= 2 * every
            && locations.get(at).is_some_and(|l| l.turn == locations[row].turn)
        {
            *value = height;
        }
    }
    out
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used)]
    use super::*;
    use crate::artifact::report::Place;
    use crate::sample;

    #[test]
    fn values_stand_at_their_locations() {
        let plan = sample::plan(3, 60);
        let mut checks = sample::report();
        let place = |row: usize, height_mm: f64| Place { point: plan.toolpath.locations[row].contact, row, height_mm };
        checks.ridges = vec![place(70, 0.009), place(66, 0.012), place(74, 0.010)];
        let all = all(&plan, &Machine::demo().unwrap(), Some(&checks));
        let of = |key: &str| all.iter().find(|v| v.key == key).unwrap();
        let scallop = of("scallop");
        assert_eq!((scallop.of[66], scallop.of[69], scallop.of[72]), (0.012, 0.009, 0.010));
        // Too far along the path, and on another turn.
        assert!(scallop.of[90].is_nan() && scallop.of[59].is_nan() && scallop.share(90).is_nan());
        assert!((of("width").of[5] - (2.0 * sample::WIDTH_RAD).to_degrees()).abs() < 1e-9);
        assert!((of("feed").of[7] - 1200.0).abs() < 1e-9);
        assert_eq!(of("turn").range, [1.0, 3.0]);
        assert_eq!(of("turn").share(0), 0.0);
        assert_eq!(of("turn").share(180), 1.0);
    }

    #[test]
    fn a_few_peaks_do_not_take_all_colours() {
        let even = |k: i32| f64::from(k % 500);
        assert_eq!(spanned((0..5000).map(even)), [0.0, 499.0]);
        // One value in a hundred is a hundred times the others.
        let peaks = |k: i32| if k % 100 == 7 { 5e4 } else { even(k) };
        let [lo, hi] = spanned((0..5000).map(peaks).chain([f64::NAN]));
        assert!(lo == 0.0 && (480.0..=499.0).contains(&hi), "{lo} {hi}");
        let [lo, hi] = spanned((0..5000).map(|k| -peaks(k)));
        assert!(hi == 0.0 && (-499.0..=-480.0).contains(&lo), "{lo} {hi}");
        // Three in a hundred are too many to leave out; where all but one are alike, that one is
        // seen.
        assert_eq!(spanned((0..5000).map(|k| if k % 100 < 3 { 5e4 } else { 1.0 })), [1.0, 5e4]);
        assert_eq!(spanned((0..5000).map(|k| if k == 9 { 2.0 } else { 1.0 })), [1.0, 2.0]);
        assert_eq!((spanned([]), spanned([f64::NAN, 3.0])), ([0.0; 2], [3.0; 2]));
        let peaked = Values::new("k", "n", "u", (0..5000).map(peaks).collect());
        assert_eq!((peaked.range[1], peaked.share(7)), (5e4, 1.0));
        assert!(peaked.share(250) > 0.4);
    }

    #[test]
    fn nothing_measured_and_short_lists_are_no_numbers() {
        let mut plan = sample::plan(1, 12);
        plan.motion.feed.truncate(3);
        let all = all(&plan, &Machine::demo().unwrap(), None);
        assert!(all.iter().all(|v| v.of.len() == 13));
        assert!(all[1].of.iter().all(|v| v.is_nan()) && all[3].of[5].is_nan());
    }
}
