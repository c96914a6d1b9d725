//! The smooth curve in place of the path: made, laid out row by row, and given up where it does not
//! keep clear.
//!
//! A row is where a piece of the curve begins, and as many more within a piece, evenly, as keep
//! straight moves from row to row within the chord tolerance: the same rows serve programs of
//! polynomials, which take the pieces whole, and programs of straight moves. Where the ridges of
//! the whole path would fail their check, the room across the path is narrowed about those that
//! grew too much, in the end all along the path. The channel is looked at anew at the rows: it is
//! known at locations, and between them its walls need not be straight. Where θ leaves it, θ is
//! made again between the walls that the rows saw, and the ball keeps its curve. Where that does
//! not help, or the tool comes too near to something between rows, the curve is made again nearer
//! to the path there; in the end those pieces are given up and the path's own locations come back.

use super::leads::MotionAndLeads;
use super::{Setup, leads};
use crate::artifact::curve::{Curve, CurveProof, CurveStretch, LeftAsIs};
use crate::artifact::programmed::{BeforeCurve, CurveRow, Polynomial, Way};
use crate::artifact::schedule::Quality;
use crate::artifact::toolpath::{CutterLocation, Turn};
use crate::artifact::{Channel, ProgrammedCurve, Schedule, Toolpath};
use crate::error::{ErrorKind, Result, Stage, WhyLeft, WhyNone};
use crate::feed;
use crate::geometry::Point;
use crate::geometry::allowance::Allowed;
use crate::observe::{Doubt, Observer, Silent, Warning, timed};
use crate::parallel;
use crate::smooth::{self, Aim, Near, Objective, SeenWall, Share, SmoothOptions};
use crate::verify;

/// How often the room across the path is narrowed where ridges would fail their check: about ridges
/// that grew, but the last times all along the path.
const NARROWER: usize = 6;
const NARROWER_ALL: usize = 3;
/// Ridges are looked at in so many places then, …
const RIDGES: usize = 60_000;
/// … and the room about one that grew is narrowed to between these shares of what it was, …
const NARROWED: [f64; 2] = [0.2, 0.7];
/// … so far around both passes, mm.
const ABOUT_RIDGE_MM: f64 = 1.0;
/// A curve of few pieces may be off the part by this share of what ridges may grow by: they also
/// grow by what it goes across, and at its own rows others are counted.
const OFF: f64 = 0.25;
/// How often θ is made anew between walls that were seen from the curve, …
const TURNED: usize = 4;
/// … at places as far around those where it was outside of them, mm.
const SEEN_MM: f64 = 0.5;
/// How often the curve is made anew, nearer to the path at places where it does not keep clear, …
const NEARER: usize = 2;
/// … each time with this share of the room there, and so far around them, mm.
const SHARE: f64 = 0.2;
const AROUND_MM: f64 = 1.0;
/// How often places are given up then, before the whole path stays as it is.
const ROUNDS: usize = 3;
/// Share of the chord tolerance that straight moves from row to row take.
const CHORD: f64 = 0.9;
/// In hollows they take so much of it, as the path's own locations do: there they leave ridges.
const IN_HOLLOWS: f64 = 0.25;
/// Where the contact goes so many times as far as the ball it is an edge, no hollow.
const EDGE: f64 = 2.0;
/// Locations that come back are no nearer to the curve's end than this share of a move.
const APART: f64 = 0.2;

/// What is smoothed.
#[derive(Clone, Copy)]
pub(crate) struct Before<'a> {
    pub path: &'a Toolpath,
    pub channel: &'a Channel,
    pub schedule: &'a Schedule,
}

/// The same along the curve.
pub(crate) struct SmoothedPlan {
    pub path: Toolpath,
    pub channel: Channel,
    pub schedule: Schedule,
    pub curve: ProgrammedCurve,
}

/// The curve with all that is along it; `None`, with a warning, where the whole path stays as it
/// is. `motion`: that of the path as it is, where it is known.
///
/// # Errors
/// Those of the stages, but that a channel which closes along the curve is none.
pub(crate) fn smoothed(
    setup: &Setup,
    before: Before,
    motion: Option<&MotionAndLeads>,
    observer: &dyn Observer,
) -> Result<Option<SmoothedPlan>> {
    let given_up = |reason: WhyNone| {
        observer.warn(Warning { stage: Stage::Smooth, doubt: Doubt::NothingSmoothed { reason } });
        Ok(None)
    };
    if before.schedule.kind.is_wall() {
        return given_up(WhyNone::AlongWall);
    }
    if before.path.cones.same().is_none() {
        return given_up(WhyNone::OtherCones);
    }
    let (mut options, objective) = (setup.smooth_options(), Objective::Part);
    let Before { path: old, channel: walls, schedule } = before;
    let mut shares = vec![Share::WHOLE; old.locations.len()];
    let make = |options: &SmoothOptions, shares: &[Share], seen: &[SeenWall], like: Option<&Curve>| {
        timed(observer, Stage::Smooth, || {
            let near = Near { shares, like, walls: seen };
            smooth::plan_near(&setup.blade.part, old, walls, schedule, &objective, options, near, observer)
        })
    };
    let verify_options = setup.verify_options();
    let ridges_mm = |path: &Toolpath| verify::ridges_p99(path, &setup.blade.part, &verify_options);
    // What the check lets pass, or what the path has anyway.
    let own_mm = ridges_mm(old);
    let most_mm = (verify_options.settings.scallop_ratio * verify_options.scallop_mm).max(own_mm);
    less_off(&mut options, OFF * (most_mm - own_mm));
    let mut seen: Vec<SeenWall> = Vec::new();
    let mut found = make(&options, &shares, &seen, None)?;
    let mut kept: Vec<[f64; 2]> = Vec::new();
    let (mut nearer, mut narrower, mut turned) = (0, 0, 0);
    for _ in 0..NEARER + ROUNDS + NARROWER + TURNED {
        if found.stretches.is_empty() {
            return given_up(longest(&found.left).map_or(WhyNone::TooShort, |l| WhyNone::Left { longest: l.why }));
        }
        let laid = LaidCurve { setup, before, found: &found, kept: &kept };
        let Some((path, schedule, curve)) = timed(observer, Stage::Smooth, || laid.out()) else {
            return given_up(WhyNone::PartNotNear);
        };
        if timed(observer, Stage::Smooth, || ridges_mm(&path)) > most_mm {
            if narrower == NARROWER {
                return given_up(WhyNone::Ridges);
            }
            narrower += 1;
            // A curve with more room off the part has too few breaks to begin with.
            let is_same = !less_off(&mut options, 0.0);
            if narrower > NARROWER - NARROWER_ALL {
                options.across *= 0.5;
            } else {
                let on = OnRidges { setup, options: &verify_options, most_mm };
                timed(observer, Stage::Smooth, || on.narrow(old, &path, &curve, &mut shares));
            }
            found = make(&options, &shares, &seen, Some(&found).filter(|_| is_same))?;
            continue;
        }
        let channel = match channel_on(setup, before, &path, &curve, observer) {
            Err(e) if e.kind == ErrorKind::Infeasible => {
                return given_up(WhyNone::Channel { words: e.message, cause: e.infeasible });
            }
            channel => channel?,
        };
        let bad = timed(observer, Stage::Smooth, || NotClear::on(setup, &path, &schedule, &channel, &curve));
        if bad.outside.is_empty() && bad.near.is_empty() {
            let curve = compared(setup, before, motion, (&path, &schedule), curve)?;
            told(&curve, &before, observer);
            return Ok(Some(SmoothedPlan { path, channel, schedule, curve }));
        }
        observer.check(Stage::Smooth)?;
        if turned < TURNED && !bad.outside.is_empty() {
            turned += 1;
            see(&bad.outside, &channel, &curve, &mut seen);
            let again = timed(observer, Stage::Smooth, || {
                let near = Near { shares: &shares, like: None, walls: &seen };
                smooth::turned_anew(&found, old, walls, before.schedule, &options, near)
            })?;
            if again == found {
                // There is no such θ.
                turned = TURNED;
            }
            found = again;
        } else if nearer < NEARER {
            nearer += 1;
            nearer_about(&bad.all(), old, &mut shares);
            found = make(&options, &shares, &seen, Some(&found))?;
        } else {
            kept.extend(bad.all());
        }
    }
    given_up(WhyNone::MoreAndMore)
}

/// The channel as the curve's rows about places see it, with what was seen before.
fn see(places: &[[f64; 2]], channel: &Channel, curve: &ProgrammedCurve, seen: &mut Vec<SeenWall>) {
    let is_near = |s: f64| places.iter().any(|[a, b]| s > a - SEEN_MM && s < b + SEEN_MM);
    let rows = curve.rows.iter().zip(&channel.rows).enumerate();
    let here = rows.filter(|(k, (r, _))| curve.is_on(*k) && is_near(r.s_mm));
    seen.retain(|w| !is_near(w.s_mm));
    seen.extend(here.map(|(_, (r, c))| SeenWall { s_mm: r.s_mm, theta_min: c.hull_min, theta_max: c.hull_max }));
    seen.sort_by(|a, b| a.s_mm.total_cmp(&b.s_mm));
}

/// Less room about places, which the path's own parameter tells.
fn nearer_about(places: &[[f64; 2]], old: &Toolpath, shares: &mut [Share]) {
    for (l, share) in old.locations.iter().zip(shares) {
        let is_near = |[a, b]: &[f64; 2]| l.s_mm > a - AROUND_MM && l.s_mm < b + AROUND_MM;
        if places.iter().any(is_near) {
            *share = Share { across: SHARE * share.across, turn: SHARE * share.turn };
        }
    }
}

/// Ridges grow by what the ball is farther off the part. A curve of few pieces uses all of its
/// room: where that is more than ridges may grow by, it gets what the smoothest curve has. Whether
/// it had more.
fn less_off(options: &mut SmoothOptions, may_grow_mm: f64) -> bool {
    let usual_mm = SmoothOptions::default().outwards_mm;
    let is_less = options.aim == Aim::Fewest && options.outwards_mm > usual_mm.max(may_grow_mm);
    if is_less {
        options.outwards_mm = usual_mm;
    }
    is_less
}

/// Ridges beside those of the path as it is.
struct OnRidges<'a> {
    setup: &'a Setup,
    options: &'a verify::VerifyOptions,
    /// What a ridge may come up to, mm.
    most_mm: f64,
}

impl OnRidges<'_> {
    /// Less room where ridges grew beyond what they may: the share of it that would have kept them,
    /// since a ridge grows about as its passes move apart.
    fn narrow(&self, old: &Toolpath, path: &Toolpath, curve: &ProgrammedCurve, shares: &mut [Share]) {
        let part = &self.setup.blade.part;
        let [before, now] = [old, path].map(|p| verify::ridges(p, part, self.options, RIDGES));
        let old = &old.locations;
        let begins: Vec<f64> = before.iter().map(|r| old[r.rows[0]].s_mm).collect();
        let mut least = vec![1.0_f64; shares.len()];
        for r in now.iter().filter(|r| r.height_mm > self.most_mm) {
            let s_mm = r.rows.map(|row| curve.rows[row].s_mm);
            let k = begins.partition_point(|s| *s <= s_mm[0]);
            let was = before[k.saturating_sub(1)..(k + 1).min(before.len())].iter().map(|r| r.height_mm);
            let was = was.fold(0.0, f64::max);
            if was < r.height_mm {
                let share = ((self.most_mm - was) / (r.height_mm - was)).clamp(NARROWED[0], NARROWED[1]);
                for s in s_mm {
                    let from = old.partition_point(|l| l.s_mm < s - ABOUT_RIDGE_MM);
                    let to = old.partition_point(|l| l.s_mm <= s + ABOUT_RIDGE_MM);
                    least[from..to].iter_mut().for_each(|l| *l = l.min(share));
                }
            }
        }
        shares.iter_mut().zip(least).for_each(|(share, l)| share.across *= l);
    }
}

fn longest(left: &[LeftAsIs]) -> Option<&LeftAsIs> {
    left.iter().max_by(|a, b| (a.s_mm[1] - a.s_mm[0]).total_cmp(&(b.s_mm[1] - b.s_mm[0])))
}

/// Warns of places that stay as they are.
fn told(curve: &ProgrammedCurve, before: &Before, observer: &dyn Observer) {
    let Some(place) = longest(&curve.left) else { return };
    let doubt = Doubt::NotSmoothed {
        length_mm: curve.left.iter().map(|l| l.s_mm[1] - l.s_mm[0]).sum(),
        of_mm: before.path.locations.last().map_or(0.0, |l| l.s_mm),
        places: curve.left.len(),
        longest_at_mm: place.s_mm[0],
        why: place.why,
    };
    observer.warn(Warning { stage: Stage::Smooth, doubt });
}

/// The curve with the figures of what it is compared with.
fn compared(
    setup: &Setup,
    before: Before,
    motion: Option<&MotionAndLeads>,
    (path, schedule): (&Toolpath, &Schedule),
    mut curve: ProgrammedCurve,
) -> Result<ProgrammedCurve> {
    let options = setup.feed_options();
    let time_s = match motion {
        Some((motion, _)) => motion.time_s,
        None => {
            let chosen = leads::choose(setup, before.path, before.schedule, &Silent)?;
            leads::motion(setup, before.path, before.schedule, None, chosen, &Silent)?.0.time_s
        }
    };
    let jerk = feed::peaks(before.path, before.schedule, &setup.machine, &options)?.jerk;
    let jerk_now = feed::peaks_on(path, schedule, Some(&curve), &setup.machine, &options)?.jerk;
    curve.before = BeforeCurve { locations: before.path.locations.len(), time_s, jerk, jerk_now };
    Ok(curve)
}

/// The channel at the curve's rows, proven for moves where that of the path was.
fn channel_on(
    setup: &Setup,
    before: Before,
    path: &Toolpath,
    curve: &ProgrammedCurve,
    observer: &dyn Observer,
) -> Result<Channel> {
    let old = &before.path.locations;
    let mut prove_at: Vec<usize> = Vec::new();
    for k in &before.channel.proven_at {
        let (Some(a), Some(b)) = (old.get(*k), old.get(k + 1)) else { continue };
        let from = curve.rows.partition_point(|r| r.s_mm <= a.s_mm).saturating_sub(1);
        let to = curve.rows.partition_point(|r| r.s_mm < b.s_mm).min(curve.rows.len() - 1);
        prove_at.extend(from..to);
    }
    prove_at.sort_unstable();
    prove_at.dedup();
    let plan = |exact_ends: bool| setup.channel_proven(path, &prove_at, exact_ends, observer);
    let is_exact = setup.job.channel.exact_ends;
    timed(observer, Stage::Channel, || match plan(is_exact) {
        Err(e) if e.kind == ErrorKind::Infeasible && !is_exact && setup.blade.part.brep.is_some() => plan(true),
        made => made,
    })
}

/// Where the curve cannot be as it is, in its parameter, mm.
struct NotClear {
    /// θ is outside the channel.
    outside: Vec<[f64; 2]>,
    /// The tool comes nearer to something than the checks let pass, on the curve or on a straight
    /// move beside it.
    near: Vec<[f64; 2]>,
}

impl NotClear {
    fn on(setup: &Setup, path: &Toolpath, schedule: &Schedule, channel: &Channel, curve: &ProgrammedCurve) -> Self {
        let options = setup.verify_options();
        let apart = verify::apart(&setup.blade, &setup.obstacles, &setup.job.tool, &options);
        let theta = &schedule.theta;
        let is_outside = |k: &usize| {
            let row = &channel.rows[*k];
            let by = (row.theta_min - theta[*k]).max(theta[*k] - row.theta_max);
            by.to_degrees() > 0.5 * options.angle_tolerance_deg && curve.is_on(*k)
        };
        let last = curve.rows.len() - 1;
        let s = |k: usize| curve.rows[k.min(last)].s_mm;
        let outside = (0..theta.len()).filter(is_outside).map(|k| [s(k.saturating_sub(1)), s(k + 1)]);
        let short = verify::short_on_curve(path, theta, curve, &apart, &options);
        let near = short.into_iter().filter(|k| curve.is_on(*k) || curve.is_on(k + 1)).map(|k| [s(k), s(k + 1)]);
        NotClear { outside: outside.collect(), near: near.collect() }
    }

    fn all(self) -> Vec<[f64; 2]> {
        [self.outside, self.near].concat()
    }
}

/// Where a row comes from.
#[derive(Clone, Copy)]
enum Source {
    /// A share of a span of a stretch.
    Curve { stretch: usize, span: usize, share: f64 },
    /// A location of the path.
    Location(usize),
}

/// A row with what begins there.
#[derive(Clone, Copy)]
struct RowOnCurve {
    s_mm: f64,
    source: Source,
    way: Way,
}

/// A curve that is laid out in rows.
struct LaidCurve<'a> {
    setup: &'a Setup,
    before: Before<'a>,
    found: &'a Curve,
    /// Where the path is to stay as it is although there is a curve.
    kept: &'a [[f64; 2]],
}

impl LaidCurve<'_> {
    /// Path, schedule and curve, row by row. `None` where the part is nowhere near.
    fn out(&self) -> Option<(Toolpath, Schedule, ProgrammedCurve)> {
        let (places, given_up) = self.places();
        let old = self.before.path;
        let part = Allowed::new(&self.setup.blade.part, old.stock_mm);
        let row = |p: &RowOnCurve| self.row(p, &part);
        let rows = parallel::map_short(256, &places, row);
        let rows: Vec<(CutterLocation, f64, CurveRow)> = rows.into_iter().collect::<Option<_>>()?;
        let starts: Vec<f64> = old.turns.iter().map(|t| old.locations[t.first].s_mm).collect();
        let mut locations = Vec::with_capacity(rows.len());
        let (mut s_mm, mut before): (f64, Option<Point>) = (0.0, None);
        for (l, _, row) in &rows {
            s_mm += before.map_or(0.0, |b| (l.centre - b).norm());
            before = Some(l.centre);
            let turn = starts.partition_point(|s| *s <= row.s_mm + 1e-9).max(1) - 1;
            locations.push(CutterLocation { turn: turn as u32, s_mm, ..*l });
        }
        let turns = turns(&mut locations, starts.len());
        let theta: Vec<f64> = rows.iter().map(|r| r.1).collect();
        let rows: Vec<CurveRow> = rows.into_iter().map(|r| r.2).collect();
        let region_x_mm = heights(&turns, &locations, old.region_x_mm);
        let path = Toolpath { turns, locations, region_x_mm, ..old.clone() };
        let is_whole = given_up.is_empty();
        let mut left = self.found.left.clone();
        left.extend(given_up.into_iter().map(|s_mm| LeftAsIs { s_mm, why: WhyLeft::NotClear }));
        left.sort_by(|a, b| a.s_mm[0].total_cmp(&b.s_mm[0]));
        let proofs = || self.found.stretches.iter().map(|s| s.proof);
        let mut proof = proofs().fold(CurveProof::default(), and);
        // Of stretches that are given up in part nothing is known.
        proof.pieces_bound = proofs().map(|p| p.pieces_bound).sum::<Option<usize>>().filter(|_| is_whole);
        let curve = ProgrammedCurve { rows, left, proof, before: BeforeCurve::default() };
        let schedule = along(&path, self.before.schedule, theta, &curve);
        Some((path, schedule, curve))
    }

    fn row(&self, place: &RowOnCurve, part: &Allowed) -> Option<(CutterLocation, f64, CurveRow)> {
        let old = &self.before.path.locations;
        let (stretch, span, share) = match place.source {
            Source::Location(k) => {
                let row = CurveRow { s_mm: place.s_mm, ..CurveRow::default() };
                return Some((old[k], self.before.schedule.theta[k], row));
            }
            Source::Curve { stretch, span, share } => (stretch, span, share),
        };
        let at = self.found.stretches[stretch].on_piece(span, share);
        let centre = at.point();
        let foot = part.closest(&centre, f64::INFINITY)?;
        let normal = (centre - foot.point).try_normalize(1e-12)?;
        let near = old.partition_point(|l| l.s_mm <= place.s_mm).clamp(1, old.len()) - 1;
        let location = CutterLocation { centre, contact: foot.point, normal, ..old[near] };
        let row = CurveRow {
            s_mm: place.s_mm,
            centre: [at.centre[1], at.centre[2], at.centre[3]],
            theta: [at.theta[1], at.theta[2], at.theta[3]],
            way: place.way,
        };
        Some((location, at.theta[0], row))
    }

    /// All rows in order, and where the curve is given up.
    fn places(&self) -> (Vec<RowOnCurve>, Vec<[f64; 2]>) {
        let old = &self.before.path.locations;
        let mut out: Vec<RowOnCurve> = Vec::with_capacity(old.len());
        let mut given_up = Vec::new();
        // The first location that is not behind the rows so far.
        let mut next = 0;
        let mut ranges: Vec<(usize, [usize; 2])> = Vec::new();
        for (k, stretch) in self.found.stretches.iter().enumerate() {
            let gone = self.given_up(stretch);
            let breaks = stretch.breaks.all();
            let mut from = 0;
            for [a, b] in &gone {
                if *a > from {
                    ranges.push((k, [from, *a]));
                }
                given_up.push([breaks[*a], breaks[*b]]);
                from = *b;
            }
            if from < stretch.breaks.spans() {
                ranges.push((k, [from, stretch.breaks.spans()]));
            }
        }
        for (stretch, [from, to]) in ranges {
            let breaks = self.found.stretches[stretch].breaks.all();
            let (begin, end) = (breaks[from], breaks[to]);
            let up_to = old.partition_point(|l| l.s_mm < begin);
            self.locations(next..up_to, out.last().map(|p| p.s_mm), Some(begin), &mut out);
            self.curve(stretch, from..to, &mut out);
            next = old.partition_point(|l| l.s_mm <= end);
        }
        self.locations(next..old.len(), out.last().map(|p| p.s_mm), None, &mut out);
        (out, given_up)
    }

    /// Locations as they are, but those that the ends of the curve come too near to.
    fn locations(
        &self,
        range: std::ops::Range<usize>,
        after: Option<f64>,
        until: Option<f64>,
        out: &mut Vec<RowOnCurve>,
    ) {
        let old = &self.before.path.locations;
        for k in range {
            let s_mm = old[k].s_mm;
            let (a, b) = (old[k.saturating_sub(1)].s_mm, old[(k + 1).min(old.len() - 1)].s_mm);
            let apart = APART * 0.5 * (b - a);
            if after.is_some_and(|s| s_mm - s < apart) || until.is_some_and(|s| s - s_mm < apart) {
                continue;
            }
            out.push(RowOnCurve { s_mm, source: Source::Location(k), way: Way::Straight });
        }
    }

    /// Rows on spans of a stretch.
    fn curve(&self, stretch: usize, spans: std::ops::Range<usize>, out: &mut Vec<RowOnCurve>) {
        let of = &self.found.stretches[stretch];
        let last = spans.end - 1;
        for span in spans {
            let [a, b] = of.breaks.span(span);
            let parts = self.parts(&piece(of, span), 0.5 * (a + b));
            for j in 0..parts {
                let share = j as f64 / parts as f64;
                let way = if j == 0 { Way::Piece } else { Way::Within };
                out.push(RowOnCurve { s_mm: a + (b - a) * share, source: Source::Curve { stretch, span, share }, way });
            }
            if span == last {
                out.push(RowOnCurve {
                    s_mm: b,
                    source: Source::Curve { stretch, span, share: 1.0 },
                    way: Way::Straight,
                });
            }
        }
    }

    /// In how many equal parts a piece is written as straight moves: their sagitta is at most
    /// `h² max |c''|/8`.
    fn parts(&self, piece: &Polynomial, middle_mm: f64) -> usize {
        let (path, old) = (self.before.path, &self.before.path.locations);
        let k = old.partition_point(|l| l.s_mm <= middle_mm).clamp(1, old.len() - 1);
        let (a, b) = (&old[k - 1], &old[k]);
        let is_edge = self.setup.blade.part.brep.is_none()
            || (b.contact - a.contact).norm() > EDGE * (b.centre - a.centre).norm();
        let is_hollow = piece.at(0.5).derivative(2).dot(&a.normal) > 0.0;
        let share = if is_hollow && !is_edge { IN_HOLLOWS } else { CHORD };
        let by_chord = (piece.sagitta()[0] / (share * path.chord_mm)).sqrt();
        let by_length = piece.length_mm * piece.greatest(1)[0] / self.setup.job.path.max_step_mm;
        by_chord.max(by_length).ceil().clamp(1.0, 1e6) as usize
    }

    /// Spans of a stretch from which to which it is given up. θ never falls where it is left and
    /// taken up again: the place is made longer until that is so.
    fn given_up(&self, stretch: &CurveStretch) -> Vec<[usize; 2]> {
        let (breaks, spans) = (stretch.breaks.all(), stretch.breaks.spans());
        let [first, last] = stretch.s_mm();
        let old = &self.before.path.locations;
        let theta = |k: usize| self.before.schedule.theta[k];
        let mut out: Vec<[usize; 2]> = Vec::new();
        let mut kept: Vec<[f64; 2]> = self.kept.iter().copied().filter(|[a, b]| *b > first && *a < last).collect();
        kept.sort_by(|a, b| a[0].total_cmp(&b[0]));
        for [a, b] in kept {
            let mut from = breaks.partition_point(|s| *s <= a).max(1) - 1;
            let mut to = breaks.partition_point(|s| *s < b).min(spans);
            let ahead = |s: f64| old.partition_point(|l| l.s_mm <= s);
            while from > 0 {
                let k = ahead(breaks[from]);
                if k >= old.len() || stretch.at(breaks[from]).theta[0] <= theta(k) {
                    break;
                }
                from -= 1;
            }
            while to < spans {
                let k = old.partition_point(|l| l.s_mm < breaks[to]);
                if k == 0 || theta(k - 1) <= stretch.at(breaks[to]).theta[0] {
                    break;
                }
                to += 1;
            }
            match out.last_mut() {
                // What is left between two places is too little.
                Some(before) if from <= before[1] + 1 => before[1] = before[1].max(to),
                _ => out.push([from, to]),
            }
        }
        if let Some(first) = out.first_mut().filter(|f| f[0] <= 1) {
            first[0] = 0;
        }
        if let Some(last) = out.last_mut().filter(|l| l[1] + 1 >= spans) {
            last[1] = spans;
        }
        out
    }
}

fn piece(stretch: &CurveStretch, span: usize) -> Polynomial {
    let [a, b] = stretch.breaks.span(span);
    Polynomial { from: [0.0; 4], ordinates: stretch.ordinates(span), length_mm: b - a }
}

fn and(a: CurveProof, b: CurveProof) -> CurveProof {
    CurveProof {
        inwards_mm: a.inwards_mm.max(b.inwards_mm),
        outwards_mm: a.outwards_mm.max(b.outwards_mm),
        square: a.square + b.square,
        bound: a.bound + b.bound,
        bound_of_any: None,
        theta_square: a.theta_square + b.theta_square,
        theta_bound: a.theta_bound + b.theta_bound,
        pieces_bound: None,
    }
}

/// Heights of the first and last ball centres: the outermost of the first and the last turn.
fn heights(turns: &[Turn], locations: &[CutterLocation], before: [f64; 2]) -> [f64; 2] {
    let of = |turn: Option<&Turn>, most: fn(f64, f64) -> f64, start: f64| {
        let rows = turn.and_then(|t| locations.get(t.first..t.first + t.count)).unwrap_or_default();
        rows.iter().map(|l| l.centre.x).fold(start, most)
    };
    let [first, last] = [turns.first(), turns.last()];
    if before[0] >= before[1] {
        [of(first, f64::max, f64::NEG_INFINITY), of(last, f64::min, f64::INFINITY)]
    } else {
        [of(first, f64::min, f64::INFINITY), of(last, f64::max, f64::NEG_INFINITY)]
    }
}

/// Turns of locations that know theirs; puts their lengths into them.
fn turns(locations: &mut [CutterLocation], count: usize) -> Vec<Turn> {
    let first = |turn: usize, l: &[CutterLocation]| l.partition_point(|l| (l.turn as usize) < turn);
    let end_mm = locations.last().map_or(0.0, |l| l.s_mm);
    let mut out = Vec::with_capacity(count);
    for turn in 0..count {
        let (from, to) = (first(turn, locations), first(turn + 1, locations));
        let base = locations.get(from).map_or(end_mm, |l| l.s_mm);
        let length_mm = locations.get(to).map_or(end_mm, |l| l.s_mm) - base;
        locations[from..to].iter_mut().for_each(|l| l.turn_s_mm = l.s_mm - base);
        out.push(Turn { first: from, count: to - from, length_mm });
    }
    out
}

/// The schedule along the curve. Its curve θ(S) is the programmed one.
fn along(path: &Toolpath, before: &Schedule, theta: Vec<f64>, curve: &ProgrammedCurve) -> Schedule {
    let of = |k: usize| match curve.polynomial(path, &theta, k) {
        Some(p) => [1, 2, 3].map(|order| p.greatest(order)[1]),
        None => {
            let way = path.locations[k + 1].s_mm - path.locations[k].s_mm;
            [((theta[k + 1] - theta[k]) / way).abs(), 0.0, 0.0]
        }
    };
    let most = |a: [f64; 3], b: [f64; 3]| std::array::from_fn(|k| f64::max(a[k], b[k]));
    let [rate, second, third] = parallel::map_short(256, 0..theta.len() - 1, of).into_iter().fold([0.0; 3], most);
    let whole = curve.blocks() > 0 && curve.rows[..theta.len() - 1].iter().all(|r| r.way.is_curved());
    Schedule {
        kind: before.kind,
        reversals: theta.windows(2).filter(|w| w[1] < w[0]).count(),
        theta,
        pieces: Vec::new(),
        key_points: before.key_points.clone(),
        rates: before.rates.clone(),
        spread: before.spread,
        peak_rate: rate,
        peak_acceleration: second,
        quality: Quality { peak_third: whole.then_some(third), curvature_continuous: whole, ..Quality::default() },
    }
}
