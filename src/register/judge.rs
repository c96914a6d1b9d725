//! Whether a lay is the one: how well the balls touch, what is determined, and how near the next
//! best is.

use super::field::{Exact, Field, Triangles};
use super::places::{FeedEnd, FeedEnds, Lay, followed, zero};
use super::search::{Candidate, Search, rms_mm};
use super::solve::{Centres, Change, Residual, Task, UNKNOWNS};
use crate::error::Result;
use crate::geometry::{Point, Vector};
use crate::parallel;
use crate::read::program::{Bench, Script};
use crate::tool::Tool;

/// Places that the last steps are made with.
const PLACES: usize = 4000;
/// Groups of neighbouring places that are left out one by one for the uncertainty.
const GROUPS: usize = 16;
/// Farther off the part than this no place is taken into the last steps, mm.
const OFF_MM: f64 = 0.1;
/// First band of [`sharpened`], in root mean squares of all places; a narrower one tells no more
/// than [`LAST_BAND`].
const FIRST_BAND: f64 = 3.0;
const LAST_BAND: f64 = 0.04;
/// Each band over the one before.
const NARROWER: f64 = 0.75;
/// Share of the places that the narrowest band must hold.
const PEAK_SHARE: f64 = 0.25;
/// A band that is no wider than this, in root mean squares of all places, is a peak: of places that
/// scatter evenly it would hold an eighth, of those that do as errors do a sixth.
const PEAK_BAND: f64 = 0.2;
/// Least width of Huber's weights, mm: rounding of words.
const ROUNDED_MM: f64 = 0.000_05;
/// A turn is reported as such where it moves the places by more than this share of the shift.
const TURNS: f64 = 0.2;

/// What the balls do in a lay.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Touch {
    /// Root mean square of the residuals of the places that touch, µm.
    pub rms_um: f64,
    /// 95th percentile of all residuals between the first and the last contact, µm.
    pub p95_um: f64,
    /// Share of these places that touch, they being half of all places at least.
    pub share: f64,
    /// Their number.
    pub places: usize,
}

/// What the places say about the unknowns.
#[derive(Clone, Debug)]
pub(super) struct Determined {
    /// Greatest over least eigenvalue of the normal equations.
    pub condition: f64,
    /// Directions that are not determined, in words; the weakest first.
    pub loose: Vec<String>,
    /// The weakest direction, in words.
    pub weakest: String,
    /// What the frame may be off, by leaving out groups of places: shift, µm, and turn, degrees.
    pub uncertainty: (f64, f64),
    /// See [`Fit::bound_um`](super::Fit::bound_um).
    pub bound_um: f64,
}

/// A lay that was bettered, and how places weighed in it.
#[derive(Clone, Copy)]
pub(super) struct Polished {
    pub lay: Lay,
    /// See [`Task::huber_mm`].
    pub huber_mm: f64,
    /// See [`Task::most_mm`].
    pub most_mm: f64,
}

impl Polished {
    /// A task on a field that weighs places as in this lay.
    pub fn task<'a>(&self, search: &Search, field: &'a dyn Field, places: &'a [FeedEnd]) -> Task<'a> {
        Task { most_mm: self.most_mm, ..search.task(field, places, self.huber_mm, search.free_radius) }
    }
}

/// The lay bettered on many places, those off the part left out.
pub(super) fn polished(search: &Search, places: &[FeedEnd], lay: &Lay) -> Polished {
    let exact = Exact(search.part);
    let mut task = search.task(&exact, places, 0.02, search.free_radius);
    task.most_mm = OFF_MM;
    let (mut lay, _) = task.descend(lay, 15);
    let mut offs: Vec<f64> =
        task.residuals(&lay).iter().flatten().map(|r| r.off_mm.abs()).filter(|a| *a <= OFF_MM).collect();
    offs.sort_by(f64::total_cmp);
    // One and a half standard deviations, by the lower quartile: chords of others are off to one
    // side, and may be half of the places.
    task.huber_mm = (4.7 * offs.get(offs.len() / 4).copied().unwrap_or(OFF_MM)).max(ROUNDED_MM);
    lay = task.descend(&lay, 30).0;
    sharpened(&task, &lay).unwrap_or(Polished { lay, huber_mm: task.huber_mm, most_mm: task.most_mm })
}

/// The lay in which a good part of the places touches far more closely than all do.
///
/// A program that was made from the part touches it at its locations to the rounding of words. Ends
/// that only part a move, and middles of polynomials, are off by the chord, and all to one side.
/// Huber's weights move the frame for these where they are many. So a band about the part is
/// narrowed step by step, and only places within it count (a skipped mean: F. R. Hampel and others,
/// *Robust Statistics*, 1986). `None` where no narrow band holds enough of them.
fn sharpened(task: &Task, lay: &Lay) -> Option<Polished> {
    let within = |lay: &Lay, mm: f64| {
        let residuals = task.residuals(lay);
        residuals.iter().flatten().filter(|r| r.off_mm.abs() <= mm).count() as f64 / residuals.len().max(1) as f64
    };
    let all_mm = rms_mm(task, lay);
    let (mut band_mm, mut lay, mut narrowest) = (FIRST_BAND * all_mm, *lay, None);
    while band_mm > LAST_BAND * all_mm {
        let narrow = Task { huber_mm: band_mm, most_mm: band_mm, ..*task };
        lay = narrow.descend(&lay, 12).0;
        if within(&lay, band_mm) < PEAK_SHARE {
            break;
        }
        narrowest = Some(Polished { lay, huber_mm: band_mm, most_mm: band_mm });
        band_mm *= NARROWER;
    }
    narrowest.filter(|p| p.most_mm <= PEAK_BAND * all_mm)
}

/// Places for [`polished`].
pub(super) fn many(places: &FeedEnds) -> Vec<FeedEnd> {
    places.sampled(PLACES)
}

/// Measures a lay as the program is checked with it: followed with its zero.
pub(super) fn touch(search: &Search, script: &Script, benches: &[Bench], lay: &Lay, touching_mm: f64) -> Result<Touch> {
    let mut benches: Vec<Bench> = benches.to_vec();
    for bench in &mut benches {
        bench.language = super::language(bench.language, lay.tip);
    }
    let all = followed(script, &benches, zero(&lay.frame, search.places.in_axes))?;
    let every = all.len().div_ceil(MEASURED);
    let exact = Exact(search.part);
    let off = |f: &super::places::Followed| {
        let bench = benches.get(f.tool)?;
        let centre = f.moved.pose(f.share, bench.tool, bench.machine).centre;
        let grown = if lay.tip { 0.0 } else { lay.grown_mm };
        Some(exact.at(&centre)?.0 - bench.tool.radius_mm - grown - search.stock_mm)
    };
    let offs: Vec<f64> = parallel::map(all.iter().step_by(every.max(1)), |f| off(f).map_or(f64::INFINITY, f64::abs));
    Ok(summed(&offs, touching_mm))
}

/// Most places that a lay is measured at.
const MEASURED: usize = 20_000;

/// Sums up how far places are off the part, mm.
pub(super) fn summed(offs: &[f64], touching_mm: f64) -> Touch {
    let touches = |off: &f64| *off <= touching_mm;
    let (first, last) = (offs.iter().position(touches), offs.iter().rposition(touches));
    let (Some(first), Some(last)) = (first, last) else { return Touch::default() };
    // A single contact is no stretch: half of all places are one at least.
    let least = offs.len().div_ceil(2);
    let mut within: Vec<f64> = offs.get(first..=last).unwrap_or_default().to_vec();
    within.sort_by(f64::total_cmp);
    let count = within.partition_point(|off| *off <= touching_mm);
    let square: f64 = within.iter().take(count).map(|off| off * off).sum();
    let p95 = within.get((within.len() * 95 / 100).min(within.len() - 1)).copied().unwrap_or(f64::INFINITY);
    Touch {
        rms_um: 1000.0 * (square / count.max(1) as f64).sqrt(),
        p95_um: 1000.0 * p95,
        share: count as f64 / within.len().max(least) as f64,
        places: within.len(),
    }
}

/// What the places determine about a lay.
pub(super) fn determined(search: &Search, places: &[FeedEnd], polished: &Polished, most: f64) -> Determined {
    let exact = Exact(search.part);
    let task = polished.task(search, &exact, places);
    let residuals = task.residuals(&polished.lay);
    let (own, right) = task.normal(&residuals);
    // What the places can tell at all is a matter of where they are, not of how near they touch.
    let even = Task { huber_mm: OFF_MM, most_mm: OFF_MM, ..task };
    let (normal, _) = even.normal(&residuals);
    let free: Vec<usize> = (0..UNKNOWNS).filter(|k| task.free[*k]).collect();
    let matrix = nalgebra::DMatrix::from_fn(free.len(), free.len(), |i, j| normal[(free[i], free[j])]);
    let found = matrix.symmetric_eigen();
    let mut order: Vec<usize> = (0..free.len()).collect();
    order.sort_by(|a, b| found.eigenvalues[*a].total_cmp(&found.eigenvalues[*b]));
    let greatest = found.eigenvalues.max().max(f64::MIN_POSITIVE);
    let change = |k: usize| {
        let mut change = Change::zeros();
        free.iter().enumerate().for_each(|(i, f)| change[*f] = found.eigenvectors[(i, k)]);
        change
    };
    let words = |k: usize| in_words(&change(k), search.places.in_axes);
    let least = order.first().map_or(0.0, |k| found.eigenvalues[*k].max(0.0));
    let is_loose = |k: &&usize| !(found.eigenvalues[**k] * most > greatest);
    Determined {
        condition: greatest / least.max(f64::MIN_POSITIVE),
        loose: order.iter().filter(is_loose).map(|k| words(*k)).collect(),
        weakest: order.first().map_or_else(String::new, |k| words(*k)),
        uncertainty: jackknife(&task, &residuals, &own, &right),
        // |A⁻¹ Sᵀ e| of errors e is no more than their root mean square over the root of the least
        // eigenvalue of A = Sᵀ S.
        bound_um: 1000.0 * (even.mean_square_mm2(&residuals) / least.max(f64::MIN_POSITIVE)).sqrt(),
    }
}

/// Standard deviations of shift (µm) and turn (degrees), each of the whole vector, by leaving out
/// groups of neighbouring places (B. Efron, *The Jackknife, the Bootstrap and Other Resampling
/// Plans*, 1982): residuals of neighbours go together, so that counting them one by one would
/// promise too much.
fn jackknife(task: &Task, residuals: &[Option<Residual>], normal: &super::solve::Normal, right: &Change) -> (f64, f64) {
    let count = residuals.len();
    let fixed = |mut m: super::solve::Normal| {
        (0..UNKNOWNS).filter(|k| !task.free[*k]).for_each(|k| m[(k, k)] = 1.0);
        m
    };
    let size = count.div_ceil(GROUPS).max(1);
    let moved: Vec<Change> = residuals
        .chunks(size)
        .filter_map(|group| {
            let share = group.len() as f64 / count as f64;
            let (own, own_right) = task.normal(group);
            let rest = fixed(normal - own * share).cholesky()?;
            Some(-rest.solve(&(right - own_right * share)))
        })
        .collect();
    let n = moved.len() as f64;
    if moved.len() < 3 {
        return (f64::INFINITY, f64::INFINITY);
    }
    let mean: Change = moved.iter().sum::<Change>() / n;
    let spread: Change = moved.iter().map(|m| (m - mean).component_mul(&(m - mean))).sum::<Change>() * ((n - 1.0) / n);
    let shift = (spread[0] + spread[1] + spread[2]).sqrt();
    let turn = (spread[3] + spread[4] + spread[5]).sqrt() / task.size_mm;
    (1000.0 * shift, turn.to_degrees())
}

/// A change in words.
fn in_words(change: &Change, in_axes: bool) -> String {
    let (shift, turn) = (Vector::new(change[0], change[1], change[2]), Vector::new(change[3], change[4], change[5]));
    let whose = if in_axes { "of the machine" } else { "of the blade" };
    let direction = |v: &Vector| format!("{} {whose}", direction(v));
    if change[6].abs() > 0.7 {
        return "the radius of the ball".into();
    }
    match turn.norm() > TURNS * shift.norm() {
        true => format!("turning about {}", direction(&turn)),
        false => format!("along {}", direction(&shift)),
    }
}

/// A direction in words; which way along it does not matter.
pub(super) fn direction(v: &Vector) -> String {
    let main = v.iamax();
    match v.amax() > 0.999 * v.norm() {
        true => ["x", "y", "z"].get(main).copied().unwrap_or("x").to_owned(),
        false => {
            let [x, y, z]: [f64; 3] = (v.normalize() * v[main].signum()).into();
            format!("({x:.3}, {y:.3}, {z:.3})")
        }
    }
}

/// Share of the places at the part in which the shaft passes through it. The shaft is taken half as
/// thick as it is, so that a gouge counts as none.
pub(super) fn passing_share(search: &Search, tools: &[&Tool], places: &[FeedEnd], lay: &Lay) -> f64 {
    let mesh = Triangles::new(search.part);
    let passes = |place: &FeedEnd| {
        let tool = tools.get(place.tool)?;
        let (centre, axis) = (place.centre(lay), place.axis(lay));
        let segments = tool.segments();
        let radius = |z: f64| {
            let segment = segments.iter().find(|s| (s.z0..=s.z1).contains(&z))?;
            Some(segment.r0 + (segment.r1 - segment.r0) * (z - segment.z0) / (segment.z1 - segment.z0))
        };
        let step = tool.radius_mm;
        let heights = (1..).map(|k| f64::from(k) * step).take_while(|z| *z < tool.length_mm()).take(100);
        let inside = |z: f64| {
            let at: Point = centre + axis * z;
            mesh.at(&at).is_some_and(|d| d.0 < 0.5 * radius(z).unwrap_or(0.0))
        };
        Some(heights.into_iter().any(inside))
    };
    let seen: Vec<bool> = parallel::filter_map(places, passes);
    seen.iter().filter(|p| **p).count() as f64 / seen.len().max(1) as f64
}

/// Candidates without those whose shaft is in the part, the best first.
pub(super) struct Ranked {
    pub best: Candidate,
    pub rest: Vec<Candidate>,
    /// Some were left out because the shaft passes through the part there.
    pub by_shaft: bool,
}

/// Share of the places from which on the shaft counts as in the part.
const PASSES: f64 = 0.5;

/// Ranks candidates, the best first.
pub(super) fn ranked(search: &Search, tools: &[&Tool], found: &[Candidate], ratio: f64) -> Option<Ranked> {
    let first = found.first()?;
    let probe = search.probe();
    let alike: Vec<(Candidate, bool)> = found
        .iter()
        .filter(|c| c.rms_mm <= ratio * first.rms_mm.max(ROUNDED_MM))
        .map(|c| (*c, passing_share(search, tools, &probe, &c.lay) > PASSES))
        .collect();
    let by_shaft = alike.iter().any(|a| a.1) && alike.iter().any(|a| !a.1);
    let left_out = |c: &Candidate| by_shaft && alike.iter().any(|(a, passes)| *passes && a.lay.frame == c.lay.frame);
    let mut rest = found.iter().filter(|c| !left_out(c));
    let best = *rest.next()?;
    Some(Ranked { best, rest: rest.copied().collect(), by_shaft })
}

/// The best lay against the next best, both bettered on many places.
pub(super) struct Contest {
    pub best: Polished,
    /// The next best, and how many times as far its balls are off; `None`: there is no other.
    pub next: Option<(Lay, f64)>,
}

/// Least residual that ratios are taken of, mm: rounding of words.
const LEAST_MM: f64 = 0.000_1;

/// Motions whose places are nearer than this are the same, mm; or than a thousandth of the part's
/// size.
const SAME_MM: f64 = 0.1;

/// Betters the best lay, and the next best where it may come near. What ends where the best is, is
/// no other.
pub(super) fn contest(search: &Search, places: &[FeedEnd], ranked: &Ranked, ratio: f64) -> Contest {
    let mut best = polished(search, places, &ranked.best.lay);
    let (exact, probe) = (Exact(search.part), search.probe());
    let here = Centres::of(&probe, &best.lay);
    let same_mm = SAME_MM.max(1e-3 * search.size_mm());
    let is_other = |other: &Lay| here.apart(&Centres::of(&probe, other), same_mm);
    let task = search.task(&exact, places, best.huber_mm, search.free_radius);
    let off_mm = |lay: &Lay| rms_mm(&task, lay).max(LEAST_MM);
    let mut best_mm = off_mm(&best.lay);
    for next in ranked.rest.iter().filter(|c| is_other(&c.lay)) {
        let next_mm = off_mm(&next.lay);
        if next_mm > 100.0 * ratio * best_mm {
            return Contest { best, next: Some((next.lay, next_mm / best_mm)) };
        }
        let mut other = polished(search, places, &next.lay);
        if !is_other(&other.lay) {
            continue;
        }
        let mut other_mm = off_mm(&other.lay);
        if other_mm < best_mm {
            std::mem::swap(&mut best, &mut other);
            std::mem::swap(&mut best_mm, &mut other_mm);
        }
        return Contest { best, next: Some((other.lay, other_mm / best_mm)) };
    }
    Contest { best, next: None }
}
