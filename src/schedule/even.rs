//! The blade turns at one speed all through each turn (turn-milling).
//!
//! With θ growing at `ω`, the ball goes at `ṡ = ω / θ'(s)`. So a speed between `v_min` and `v_max`
//! is a slope between `ω / v_max` and `ω / v_min`: a band of slopes between the walls.
//!
//! *Greatest speeds*: the schedule that begins on the lower wall and rises no more than it must is
//! the last that may meet the upper wall ([`crossing`]). Bisection finds the greatest speed that
//! each turn has alone. The shares of these that all turns have are then raised together; where the
//! schedule meets the upper wall, the turns from its last place on the lower wall to there stay as
//! they are, and the others go on. Exact at the locations; the two places are the certificate: with
//! more speed of all turns between them no schedule exists.
//!
//! *Least spread*: where the ball may not be as slow as one speed of turning would have it, the
//! speed varies within turns, from `ω / spread` to `ω`. That is a wider band of slopes, from
//! `ω / (spread v_max)` to `ω / v_min`. The least spread with a schedule is found by bisection, up
//! to [`MOST_SPREAD`]. With [`SPREAD_BY`] less there is none, between two places that are named.
//!
//! *The curve*: of all in the band with a small share less than these speeds that with the least
//! `∫ θ'''² ds`, by the solver of kind `optimal`.

use super::bezier;
use super::check;
use super::corridor::Corridor;
use super::piecewise::walls_with_margin;
use super::rounds::{Goal, SolverUnits, round_from, values};
use super::{ScheduleOptions, curve};
use crate::artifact::schedule::{MOST_SPREAD, ScheduleKind};
use crate::artifact::{Channel, Schedule, Toolpath};
use crate::error::{Along, Error, Infeasible, Result, Stage, turn_number};
use crate::observe::{Doubt, Observer, Warning};

/// Factors by which greatest rates are greater, and least ones less, than with the least spread.
const WIDER: [f64; 6] = [1.005, 1.01, 1.02, 1.05, 1.1, 1.2];
/// Shares of the greatest speeds that are tried.
const SHARES: [f64; 7] = [0.99, 0.97, 0.94, 0.9, 0.82, 0.7, 0.5];
/// Bisections of a turn's speed.
const HALVINGS: usize = 50;
/// What a crossing may be by rounding, rad.
const ROUNDING: f64 = 1e-10;
/// The least spread is found to this factor.
const SPREAD_BY: f64 = 1.001;
/// Less than this share of what a turn has alone is standing still.
const STANDS: f64 = 1e-3;

/// How fast the ball may go.
#[derive(Clone, Copy, Debug)]
pub struct Speeds<'a> {
    /// Greatest speed of the ball centre in each interval between locations, mm/s; without end
    /// where the speed of turning is not to be kept.
    pub greatest_mm_s: &'a [f64],
    /// Least, mm/s; 0 where any will do.
    pub least_mm_s: &'a [f64],
    /// Greatest rate of θ, rad/s.
    pub most_rad_s: f64,
}

/// The schedule with the greatest speeds of turning, one for each turn ([`Schedule::rates`]); where
/// none stays the same, those that vary least ([`Schedule::spread`]), with a warning.
///
/// # Errors
/// `Infeasible` where no speed is within the channel: the two places; `Usage` where there is not
/// one speed for each interval; `Cancelled`.
pub fn even(
    path: &Toolpath,
    channel: &Channel,
    speeds: &Speeds,
    options: &ScheduleOptions,
    observer: &dyn Observer,
) -> Result<Schedule> {
    options.validate()?;
    let intervals = path.locations.len().saturating_sub(1);
    if intervals == 0 || [speeds.greatest_mm_s, speeds.least_mm_s].iter().any(|v| v.len() != intervals) {
        return Err(Error::usage(Stage::Schedule, "each interval between locations needs its speeds"));
    }
    if !channel.sweep.is_round() {
        let message = "a schedule of kind even turns the blade round and round; here the tool axis swings";
        return Err(Error::usage(Stage::Schedule, message).advise("take schedule.kind time"));
    }
    let (hull, walls) = walls_with_margin(path, channel, options, observer)?;
    let (least, greatest, between) = least_varying(Band { path, walls: &walls, speeds, spread: 1.0 }, observer)?;
    // Without any less, or with the least spread, there is no room to be smooth.
    let even = SHARES.iter().filter(|_| least.spread == 1.0).map(|share| [*share, 1.0]);
    let wider = WIDER.iter().filter(|_| may_be_too_slow(speeds)).map(|more| [*more, least.spread * more * more]);
    let tries: Vec<[f64; 2]> = even.chain(wider).filter(|t| t[1] <= MOST_SPREAD).collect();
    for [share, spread] in tries {
        observer.check(Stage::Schedule)?;
        let band = Band { spread, ..least };
        let rates: Vec<f64> = greatest.iter().map(|rate| (share * rate).min(speeds.most_rad_s)).collect();
        let slopes: Vec<[f64; 2]> = (0..intervals).map(|i| band.slopes(i, rates[band.turn(i)])).collect();
        let scale = SolverUnits::of_slopes(&walls, path.turns.len(), &slopes);
        let found = round_from(&walls, &scale, &Goal::Even { slopes }, 1e-7, None);
        let Ok((theta, slope)) = found.map(|found| values(&walls, &scale, &found)) else { continue };
        let pieces = curve::hermite(&walls.s, &theta, &slope);
        let theta = bezier::sample_as(hull.one_way, &pieces, &hull.s);
        check::inside(&pieces, &theta, &hull, path)?;
        if spread > 1.0 {
            let doubt = Doubt::SpeedVaries { share: spread - 1.0, least_share: least.spread - 1.0, between };
            observer.warn(Warning { stage: Stage::Schedule, doubt });
        }
        return Ok(Schedule { rates, spread, ..curve::schedule(ScheduleKind::Even, pieces, theta, &hull) });
    }
    let since = Infeasible::NoSmoothSchedule { margin_deg: options.settings.margin_deg };
    let message = "the channel leaves no room for a smooth schedule that turns evenly";
    Err(Error::infeasible(Stage::Schedule, message, since)
        .advise("lower schedule.margin_deg, allow less clearance, or take schedule.kind time"))
}

/// The band whose speeds vary least, with its greatest speeds, and where they vary the two places
/// between which they have to.
fn least_varying<'a>(band: Band<'a>, observer: &dyn Observer) -> Result<(Band<'a>, Vec<f64>, Option<[Along; 2]>)> {
    let none = match band.greatest_rates() {
        Ok(rates) => return Ok((band, rates, None)),
        Err(e) => e,
    };
    let at = |spread: f64| {
        let band = Band { spread, ..band };
        band.greatest_rates().map(|rates| (band, rates))
    };
    if !may_be_too_slow(band.speeds) {
        return Err(none);
    }
    let Ok(mut found) = at(MOST_SPREAD) else { return Err(none) };
    let (mut low, mut why) = (1.0, none);
    while found.0.spread > SPREAD_BY * low {
        observer.check(Stage::Schedule)?;
        let middle = (low * found.0.spread).sqrt();
        match at(middle) {
            Ok(less) => found = less,
            Err(e) => (low, why) = (middle, e),
        }
    }
    let between = match why.infeasible.as_deref() {
        Some(Infeasible::NoEvenSpeed { from, to, .. }) => Some([from.clone(), to.clone()]),
        _ => None,
    };
    Ok((found.0, found.1, between))
}

/// Whether the ball may anywhere be too slow.
fn may_be_too_slow(speeds: &Speeds) -> bool {
    speeds.least_mm_s.iter().any(|least| *least > 0.0)
}

/// Walls, and slopes by the speed of turning.
#[derive(Clone, Copy)]
struct Band<'a> {
    path: &'a Toolpath,
    walls: &'a Corridor,
    speeds: &'a Speeds<'a>,
    /// Greatest over least speed of turning within a turn.
    spread: f64,
}

impl Band<'_> {
    /// The turn of an interval.
    fn turn(&self, i: usize) -> usize {
        (self.path.locations[i].turn as usize).min(self.turns() - 1)
    }

    fn turns(&self) -> usize {
        self.path.turns.len().max(1)
    }

    fn length(&self, i: usize) -> f64 {
        self.walls.s[i + 1] - self.walls.s[i]
    }

    /// Least and greatest slope in an interval where a turn has that greatest rate, rad/mm.
    fn slopes(&self, i: usize, rate: f64) -> [f64; 2] {
        [rate / (self.spread * self.speeds.greatest_mm_s[i]), rate / self.speeds.least_mm_s[i]]
    }

    /// What θ rises at least or at most over an interval.
    fn rise(&self, i: usize, rates: &[f64], side: usize) -> f64 {
        self.slopes(i, rates[self.turn(i)])[side] * self.length(i)
    }

    /// The greatest rate of each turn, rad/s.
    fn greatest_rates(&self) -> Result<Vec<f64>> {
        let (n, most) = (self.walls.s.len(), self.speeds.most_rad_s);
        let mut rates = vec![most; self.turns()];
        let mut first = 0;
        while first + 1 < n {
            let turn = self.turn(first);
            let end = (first..n - 1).find(|i| self.turn(*i) != turn).unwrap_or(n - 1);
            let crosses = |rate: f64| {
                let rise = |i: usize| self.slopes(i, rate)[0] * self.length(i);
                crossing(self.walls, [first, end], rise).is_some()
            };
            if crosses(most) {
                let (mut low, mut high) = (0.0, most);
                for _ in 0..HALVINGS {
                    let middle = 0.5 * (low + high);
                    if crosses(middle) { high = middle } else { low = middle }
                }
                rates[turn] = low;
            }
            first = end;
        }
        self.raised_together(&rates)
    }

    /// The shares of what each turn has alone, raised together: where the schedule that rises no
    /// more than it must meets the upper wall, the turns between the two places stay, and the
    /// others go on.
    fn raised_together(&self, alone: &[f64]) -> Result<Vec<f64>> {
        let n = self.walls.s.len();
        let mut stays: Vec<Option<f64>> = vec![None; alone.len()];
        for _ in 0..=alone.len() {
            let at = |share: f64| -> Vec<f64> {
                alone.iter().zip(&stays).map(|(rate, stays)| stays.unwrap_or(share * rate)).collect()
            };
            let met = |share: f64| {
                let rates = at(share);
                crossing(self.walls, [0, n - 1], |i| self.rise(i, &rates, 0))
            };
            if met(1.0).is_none() {
                let rates = at(1.0);
                return self.fast_enough(&rates).map(|()| rates);
            }
            let (mut low, mut high) = (0.0, 1.0);
            for _ in 0..HALVINGS {
                let middle = 0.5 * (low + high);
                if met(middle).is_some() { high = middle } else { low = middle }
            }
            let Some(places) = met(high).filter(|_| low > STANDS) else {
                return Err(self.none(met(high).unwrap_or([0, n - 1]), None));
            };
            let held: Vec<usize> = (places[0]..places[1]).map(|i| self.turn(i)).collect();
            let before = stays.iter().flatten().count();
            for turn in held {
                stays[turn] = stays[turn].or(Some(low * alone[turn]));
            }
            if stays.iter().flatten().count() == before {
                return Err(self.none(places, None));
            }
        }
        Err(self.none([0, n - 1], None))
    }

    /// With these rates the ball need nowhere be slower than it is to be.
    fn fast_enough(&self, rates: &[f64]) -> Result<()> {
        let n = self.walls.s.len();
        let (mut at, mut from) = (self.walls.hi[0], 0);
        for i in 0..n - 1 {
            at += self.rise(i, rates, 1);
            if at >= self.walls.hi[i + 1] {
                (at, from) = (self.walls.hi[i + 1], i + 1);
            }
            if at < self.walls.lo[i + 1] - ROUNDING {
                let rises = [at, self.walls.lo[i + 1]].map(|theta| (theta - self.walls.hi[from]).to_degrees());
                return Err(self.none([from, i + 1], Some(rises)));
            }
        }
        Ok(())
    }

    /// No speed stays the same between two places. `rises_deg`: what the least speed of the ball
    /// lets θ rise by at most there, and what the channel asks for at least; `None`: the channel
    /// has nothing to rise by.
    fn none(&self, places: [usize; 2], rises_deg: Option<[f64; 2]>) -> Error {
        let [from, to] = places.map(|row| self.path.along(row));
        let said = |at: &Along| format!("turn {}, S = {:.2} mm", turn_number(at.turn), at.turn_s_mm);
        let (why, advice) = match rises_deg {
            Some([most, least]) => (
                format!(
                    "the channel asks θ to rise by {least:.3}° at least, and the ball would have to be slower than cut.fz_mm or \
                     cut.chip_mm allow: they let θ rise by {most:.3}° at most"
                ),
                "allow a smaller chip, turn the spindle slower, or take schedule.kind time",
            ),
            None => (
                "the channel leaves θ nothing to rise by".to_owned(),
                "allow less clearance, take a more slender or longer tool, or take schedule.kind time",
            ),
        };
        let message = format!("no speed of turning stays the same: from {} to {} {why}", said(&from), said(&to));
        let what = Infeasible::NoEvenSpeed { from, to, rises_deg };
        Error::infeasible(Stage::Schedule, message, what).advise(advice)
    }
}

/// Where the schedule that rises no more than it must meets the upper wall within these samples,
/// after the last place where it is on the lower one.
fn crossing(walls: &Corridor, [first, end]: [usize; 2], rise: impl Fn(usize) -> f64) -> Option<[usize; 2]> {
    let (mut at, mut from) = (walls.lo[first], first);
    for i in first..end {
        at += rise(i);
        if walls.lo[i + 1] >= at {
            (at, from) = (walls.lo[i + 1], i + 1);
        }
        if at > walls.hi[i + 1] + ROUNDING {
            return Some([from, i + 1]);
        }
    }
    None
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used)]
    use super::*;
    use crate::observe::{Recorder, Silent};
    use crate::sample;

    /// A path of some turns with walls about `2π` a turn that sway, and the ball slower in parts.
    fn swaying(turns: usize) -> (Toolpath, Channel, Vec<f64>) {
        let plan = sample::plan(turns, 240);
        let (path, mut channel) = (plan.toolpath, plan.channel);
        let whole = path.locations.last().unwrap().s_mm;
        let mut least = f64::NEG_INFINITY;
        for (row, l) in channel.rows.iter_mut().zip(&path.locations) {
            let share = l.s_mm / whole * turns as f64;
            let middle = std::f64::consts::TAU * share + 0.5 * (9.0 * share).sin();
            least = f64::max(least, middle - 0.7);
            (row.theta_min, row.hull_min) = (least, least);
        }
        let mut most = f64::INFINITY;
        for (row, l) in channel.rows.iter_mut().zip(&path.locations).rev() {
            let share = l.s_mm / whole * turns as f64;
            let middle = std::f64::consts::TAU * share + 0.5 * (9.0 * share).sin();
            most = f64::min(most, middle + 0.7);
            (row.theta_max, row.hull_max) = (most, most);
        }
        let speeds = path.locations.windows(2).map(|w| 20.0 + 12.0 * (0.05 * w[0].s_mm).sin()).collect();
        (path, channel, speeds)
    }

    #[test]
    fn speeds_are_the_greatest_and_the_ball_keeps_its_own() {
        let (path, channel, greatest) = swaying(4);
        let least = vec![0.0; greatest.len()];
        let speeds = Speeds { greatest_mm_s: &greatest, least_mm_s: &least, most_rad_s: 100.0 };
        let options = ScheduleOptions::default();
        let made = even(&path, &channel, &speeds, &options, &Silent).unwrap();
        assert!(made.kind == ScheduleKind::Even && made.reversals == 0 && made.rates.len() == path.turns.len());
        assert!(made.quality.outside_rad == 0.0 && made.quality.curvature_continuous);
        for (i, w) in path.locations.windows(2).enumerate() {
            let rate = made.rates[w[0].turn as usize];
            // No faster than the ball can, by the mean slope.
            let slope = (made.theta[i + 1] - made.theta[i]) / (w[1].s_mm - w[0].s_mm);
            assert!(rate / slope <= greatest[i] * (1.0 + 1e-6), "{i}");
        }
        // With a thousandth more of all speeds nothing is within the walls: the proof.
        let (_, walls) = walls_with_margin(&path, &channel, &options, &Silent).unwrap();
        let band = Band { path: &path, walls: &walls, speeds: &speeds, spread: 1.0 };
        let rates = band.greatest_rates().unwrap();
        let n = walls.s.len() - 1;
        assert_eq!(crossing(&walls, [0, n], |i| band.rise(i, &rates, 0)), None);
        let [from, to] = crossing(&walls, [0, n], |i| 1.001 * band.rise(i, &rates, 0)).unwrap();
        let rise: f64 = (from..to).map(|i| 1.001 * band.rise(i, &rates, 0)).sum();
        assert!(walls.lo[from] + rise > walls.hi[to] && made.rates.iter().zip(&rates).all(|(a, b)| a < b));
    }

    /// Where no speed stays the same the speeds vary least, and the ball keeps between its own.
    #[test]
    fn speeds_vary_no_more_than_they_have_to() {
        let (path, channel, greatest) = swaying(3);
        let least: Vec<f64> = greatest.iter().map(|v| 0.95 * v).collect();
        let speeds = Speeds { greatest_mm_s: &greatest, least_mm_s: &least, most_rad_s: 100.0 };
        let (options, told) = (ScheduleOptions::default(), Recorder::new(&Silent));
        let made = even(&path, &channel, &speeds, &options, &told).unwrap();
        assert!(made.spread > 1.0 && made.spread < MOST_SPREAD && made.quality.outside_rad == 0.0, "{}", made.spread);
        let warned = told.warnings();
        let share = warned.iter().find_map(|w| match &w.doubt {
            Doubt::SpeedVaries { share, least_share, between: Some(_) } => Some([*share, *least_share]),
            _ => None,
        });
        let [most, share] = share.unwrap_or_else(|| panic!("{warned:?}"));
        assert!(
            (1.0 + most - made.spread).abs() < 1e-12 && 1.0 + share < made.spread && made.spread < 1.25 * (1.0 + share),
            "{share} {}",
            made.spread
        );
        for (i, w) in path.locations.windows(2).enumerate() {
            let slope = (made.theta[i + 1] - made.theta[i]) / (w[1].s_mm - w[0].s_mm);
            // At its greatest speed the ball turns the blade at no less than the least rate, and at
            // the greatest rate it is no slower than its least.
            let rate = made.rates[w[0].turn as usize];
            assert!(greatest[i] * slope >= rate / made.spread * (1.0 - 1e-6), "{i}");
            assert!(rate / slope >= least[i] * (1.0 - 1e-6), "{i}");
        }
        // The proof: with a thousandth less there is none.
        let (_, walls) = walls_with_margin(&path, &channel, &options, &Silent).unwrap();
        let less = Band { path: &path, walls: &walls, speeds: &speeds, spread: (1.0 + share) / SPREAD_BY };
        assert!(less.greatest_rates().is_err());
    }

    #[test]
    fn a_least_speed_that_does_not_fit_is_named() {
        let (path, channel, greatest) = swaying(3);
        // Hardly any speed but one, in a channel that has no room for what turns by it.
        let least: Vec<f64> = greatest.iter().map(|v| 0.999 * v).collect();
        let speeds = Speeds { greatest_mm_s: &greatest, least_mm_s: &least, most_rad_s: 100.0 };
        let mut narrow = channel.clone();
        let middle = |k: usize| std::f64::consts::TAU * (path.locations[k].s_mm / 40.0).sin().abs();
        let sways: Vec<f64> = (0..narrow.rows.len()).map(middle).collect();
        let rises = sways.iter().scan(0.0, |most: &mut f64, v| {
            *most = most.max(*v) + 1e-4;
            Some(*most)
        });
        for (row, at) in narrow.rows.iter_mut().zip(rises) {
            (row.theta_min, row.hull_min, row.theta_max, row.hull_max) = (at - 0.1, at - 0.1, at + 0.1, at + 0.1);
        }
        let e = even(&path, &narrow, &speeds, &ScheduleOptions::default(), &Silent).unwrap_err();
        let Some(Infeasible::NoEvenSpeed { rises_deg, .. }) = e.infeasible.as_deref() else { panic!("{e:?}") };
        assert!(rises_deg.is_none_or(|[most, least]| most < least), "{e:?}");
        let slow: Vec<f64> = greatest.iter().map(|v| 0.2 * v).collect();
        let speeds = Speeds { greatest_mm_s: &greatest, least_mm_s: &slow, most_rad_s: 100.0 };
        let made = even(&path, &channel, &speeds, &ScheduleOptions::default(), &Silent).unwrap();
        for (i, w) in path.locations.windows(2).enumerate() {
            let slope = (made.theta[i + 1] - made.theta[i]) / (w[1].s_mm - w[0].s_mm);
            assert!(made.rates[w[0].turn as usize] / slope >= slow[i] * (1.0 - 1e-6), "{i}");
        }
    }
}
