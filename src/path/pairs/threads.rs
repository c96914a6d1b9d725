//! Two threads of one helix: both tools go round the blade, half a turn apart.
//!
//! **In**: the helix of one tool, `N` turns. **Out**: places of both tools on threads that together
//! leave the ridges of that helix.
//!
//! ## Method
//! The helix makes a sheet of ball centres: at the share `u` of a turn those of turn `k` and of the
//! next lie beside each other, and the level `m` between them is a share of the way from one to the
//! other. With `ρ = m + u` the helix itself is `ρ = φ`, where `φ` counts turns. A thread is `ρ =
//! 2φ − c`: two levels down in each turn, and the other one, whose `c` differs by 1, runs midway
//! between its turns. So two neighbours are one level apart everywhere, as turns of the helix are.
//!
//! The first turn of the helix is cut by both threads together: thread 1 from its start to the
//! place where thread 2 begins (share `b`), thread 2 from there on; and thread 2 goes on along the
//! helix for as much as thread 1 did. That makes `c = b` for thread 1 and `1 + b` for thread 2, and
//! passes that are at most one level apart from the first one on. The last turn is the same
//! backwards. Each thread has `(N + 1) / 2` turns.
//!
//! Both threads pass the blade's two edges at the same time, each another one. Between edges they
//! go on as their ways do and as much as asked for as their normals do: so their normals turn
//! together, and one table serves both.
//!
//! Across a hollow corner the straight way from turn to turn leads off the level set. There the
//! share of it is that of the way on the level set.
//!
//! ## Guarantees
//! Every ball is within 1e-6 mm of its level set. The straight moves stay within the chord
//! tolerance at their middles, but for those so short that a path which bends no more than the ball
//! does is within it: in a crease. That ridges are those of the helix is measured by the checks.
//!
//! ## Limits
//! Balls of one radius. Nothing is held: the forces of both tools are a couple.

use std::f64::consts::TAU;

use super::super::curve::arc_lengths;
use super::super::level::{LevelSet, Touch};
use super::super::stepover::{Pass, ridge_height};
use super::super::{PathOptions, chords, loses_surface, plain_level, region};
use super::sheet::Standing;
use crate::artifact::along::Along;
use crate::artifact::paired::{PairPlace, PairedRows};
use crate::artifact::region::Region;
use crate::artifact::toolpath::{CutterLocation, PathKind};
use crate::artifact::{Blade, Toolpath};
use crate::error::{Error, Infeasible, Result, Stage};
use crate::geometry::Point;
use crate::geometry::triangle::closest_on_segment;
use crate::numerics::angle::within_half_turn;
use crate::numerics::monotone::{Monotone, hermite};
use crate::numerics::spline::{CubicSpline, SplineEnds};
use crate::observe::Observer;
use crate::parallel;

/// A helix of fewer turns has no room for two threads.
const LEAST_TURNS: usize = 3;
/// Halvings of a move until its chord counts as near enough.
const MOST_HALVINGS: u32 = 12;
/// The same where the chord is short.
const SHORT_HALVINGS: u32 = 4;
/// Thread 2 begins at this share of the first turn at least, and at one less this at most.
const LEAST_BEGIN: f64 = 0.2;
/// Rounds in which the place of an edge on a thread is found.
const ROUNDS: usize = 4;
/// A way across that leaves the straight line by this share of it is followed on the level set …
const STRAIGHT: f64 = 0.05;
/// … in so many pieces.
const PIECES: usize = 16;
/// Places in a turn at which it is looked how levels lie between turns.
const BEND_PLACES: usize = 96;
/// Between turns nearer than this share of the radius levels lie evenly.
const NARROW: f64 = 1e-3;
/// Levels that lie apart come nearer to one another than this share of the way nowhere.
const LEAST_BEND: f64 = 0.02;
/// Shares of the way that differ by less are the same.
const SAME_SHARE: f64 = 0.002;
/// Places in a turn at which it is taken how far threads have come.
const IN_A_TURN: f64 = 200.0;
/// How far thread 2 is ahead of thread 1 there is smoothed so often, by means over so many places
/// to both sides: its speed then changes gently.
const SMOOTHED: usize = 3;
/// See [`SMOOTHED`].
const AVERAGED: usize = 5;
/// Where the normal turns back, a thread comes on by this share of its way at least.
const SLOWEST: f64 = 0.1;

/// Both threads of a helix.
pub struct Threads<'a> {
    level: LevelSet<'a>,
    options: &'a PathOptions,
    path: &'a Toolpath,
    /// Ball centres of the helix over its arc length: smooth to the second derivative, since
    /// threads are cut at places much nearer to each other than its locations.
    centres: CubicSpline,
    turns: Vec<Strand>,
    /// Where it passes the blade's edges, see [`edges`].
    edges: Option<[Vec<f64>; 2]>,
    /// Share of the first turn at which thread 2 begins.
    begin: f64,
    /// The turn of thread 2 by that of thread 1; `None`: half a turn behind all along.
    second: Option<CubicSpline>,
    /// What that is off at the start and the end, turns.
    off: [f64; 2],
    /// How levels lie between each turn and the next.
    bends: Vec<Bends>,
}

/// One turn of the helix, up to the start of the next.
struct Strand {
    /// Arc length of the helix at its start, mm.
    from_mm: f64,
    /// Share of the turn at each of its locations.
    share: Vec<f64>,
    /// What the normal has turned there since the helix began, less a turn for each turn of it, in
    /// turns.
    turned: Vec<f64>,
    length_mm: f64,
}

/// Both balls, and the turn of thread 1 at which they are there.
struct Place {
    turn: f64,
    touches: [Touch; 2],
}

/// Places of both threads.
pub struct Threaded {
    /// As they are carried on: one row.
    pub rows: PairedRows,
    /// The turn of thread 1 at each place.
    at: Vec<f64>,
}

impl<'a> Threads<'a> {
    /// The threads of a helix, half a turn apart.
    ///
    /// # Errors
    /// Kind `Usage` where the path is no helix, kind `Infeasible` where it has too few turns.
    pub fn of(blade: &'a Blade, options: &'a PathOptions, path: &'a Toolpath) -> Result<Self> {
        if !PathKind::ROUND.contains(&path.kind) {
            let message =
                format!("a double helix is two threads of a helix, and path.kind {} is none", path.kind.name());
            return Err(Error::usage(Stage::Path, message).advise("set path.kind to constant-scallop"));
        }
        let turned = turned(path, &region(blade, options)?.along);
        let turns: Vec<Strand> = (0..path.turns.len()).map(|k| Strand::of(path, k, &turned)).collect();
        if turns.len() < LEAST_TURNS {
            let message = format!(
                "the helix between these heights has {} turns, a double helix needs {LEAST_TURNS} at least",
                turns.len()
            );
            return Err(Error::infeasible(Stage::Path, message, Infeasible::NoPairs)
                .advise("give a lower region.end_mm, or a lower path.scallop_mm"));
        }
        let level = plain_level(blade, options)?;
        let none = Threads {
            level,
            options,
            path,
            centres: centres(path)?,
            turns,
            edges: edges(region(blade, options)?, path),
            begin: 0.5,
            second: None,
            off: [0.0; 2],
            bends: Vec::new(),
        };
        Ok(Threads { bends: none.bends(), ..none })
    }

    /// How both threads keep in step: by as much as this, from 0 to 1, they go on as their normals
    /// turn, and for the rest as their ways do. By the ways both tools are as fast as each other;
    /// by the normals more angles of the table are free for both.
    pub fn keep_step(&mut self, by_normal: f64) {
        let (turns, edges) = (&self.turns, self.edges.as_ref());
        let half = Laws { turns: turns.len(), begin: 0.5 };
        let at_first = paired(by_normal, &half, turns, edges).map_or(0.5, |second| second.value(0.0, 0));
        let laws = Laws { begin: at_first.clamp(LEAST_BEGIN, 1.0 - LEAST_BEGIN), ..half };
        let second = paired(by_normal, &laws, turns, edges);
        let [first_end, second_end] = laws.ends();
        let off = |second: &CubicSpline| [laws.begin - second.value(0.0, 0), second_end - second.value(first_end, 0)];
        self.off = second.as_ref().map_or([0.0; 2], off);
        (self.begin, self.second) = (laws.begin, second);
    }

    /// See the field of this name.
    ///
    /// Between a turn and the next the ball goes from one level to another by constant scallop, and
    /// so do places between them: what lies between two turns goes over into what lies between the
    /// next two, as far down as leaves the same ridge. Where the curvature across the turns changes
    /// that is not at the same share of the way.
    fn bends(&self) -> Vec<Bends> {
        let gaps = self.turns.len() - 1;
        // A gap goes on as the next one where a turn ends: the first gap is, at its end, what the
        // second is at its start.
        let at_end = if gaps > 1 { self.next_shares(0, 0.0, LEVELS) } else { LEVELS };
        let places: Vec<f64> = (0..=BEND_PLACES).map(|k| k as f64 / BEND_PLACES as f64).collect();
        let columns: Vec<Vec<[f64; 3]>> = parallel::map(&places, |place| {
            let first = [0, 1, 2].map(|n| LEVELS[n] + (at_end[n] - LEVELS[n]) * place);
            let mut all = vec![first];
            for k in 1..gaps {
                all.push(self.next_shares(k - 1, *place, all[k - 1]));
            }
            all
        });
        (0..gaps).map(|k| columns.iter().map(|column| column[k]).collect()).collect()
    }

    /// Shares of the way from turn `k + 1` to the next that leave the same ridges below shares of
    /// the way from turn `k` to that one as the turns themselves do.
    fn next_shares(&self, k: usize, place: f64, shares: [f64; 3]) -> [f64; 3] {
        let [p, q, r] = [0, 1, 2].map(|n| self.centre(k + n, place));
        let Some(gap) = Gap::of(self, [&p, &q, &r]) else { return shares };
        let mut out = shares.map(|share| gap.next(share).unwrap_or(share));
        // In order, and off the turns.
        for n in 0..3usize {
            let least = n.checked_sub(1).map_or(0.0, |before| out[before]) + LEAST_BEND;
            out[n] = out[n].max(least).min(1.0 - LEAST_BEND * (3 - n) as f64);
        }
        out
    }

    fn laws(&self) -> Laws {
        Laws { turns: self.turns.len(), begin: self.begin }
    }

    /// The turn of thread 2 while thread 1 is at one: it begins and ends with thread 1, and
    /// otherwise passes edges as that does.
    fn second(&self, turn: f64) -> f64 {
        let [end, second_end] = self.laws().ends();
        let Some(second) = &self.second else { return self.begin + (second_end - self.begin) * turn / end };
        let near = |away: f64| (1.0 - away).max(0.0).powi(2);
        second.value(turn, 0) + self.off[0] * near(turn) + self.off[1] * near(end - turn)
    }

    /// Places as the chord tolerance asks for.
    ///
    /// # Errors
    /// Kind `Infeasible` where a ball loses the surface; kind `Cancelled`.
    pub fn lay(&self, observer: &dyn Observer) -> Result<Threaded> {
        let longest_mm = self.turns.iter().map(|t| t.length_mm).fold(0.0, f64::max);
        let in_a_turn = (longest_mm / self.options.settings.max_step_mm).ceil().max(8.0);
        let [end, _] = self.laws().ends();
        let count = (end * in_a_turn).ceil() as usize;
        let first: Vec<f64> = (0..=count).map(|k| end * k as f64 / count as f64).collect();
        let pieces: Vec<&[f64]> = first.windows(2).collect();
        let of = |w: &&[f64]| {
            observer.check(Stage::Path)?;
            let [a, b] = [self.at(w[0])?, self.at(w[1])?];
            let mut out = vec![w[0]];
            self.between([&a, &b], 0, &mut out)?;
            Ok(out)
        };
        let mut at = parallel::try_map(&pieces, of)?.concat();
        at.push(end);
        self.threaded(at)
    }

    /// The same places with each move parted into so many.
    ///
    /// # Errors
    /// Those of [`Threads::lay`].
    pub fn parted(&self, before: &Threaded, parts: &[usize]) -> Result<Threaded> {
        let between = |(w, parts): (&[f64], &usize)| -> Vec<f64> {
            (0..(*parts).max(1)).map(|k| w[0] + (w[1] - w[0]) * k as f64 / (*parts).max(1) as f64).collect()
        };
        let mut at: Vec<f64> = before.at.windows(2).zip(parts).flat_map(between).collect();
        at.extend(before.at.last());
        self.threaded(at)
    }

    fn threaded(&self, at: Vec<f64>) -> Result<Threaded> {
        let stock_mm = self.options.settings.stock_mm;
        let places =
            parallel::try_map(&at, |turn| Ok(Standing::round_edges(self.at(*turn)?.touches, stock_mm).place()))?;
        let [first, second] = [0, 1].map(|tool| self.numbers(&at, tool));
        let rows = self.rows(places, [first, second]);
        Ok(Threaded { rows, at })
    }

    /// The turn of a thread at each place, from 0.
    fn numbers(&self, at: &[f64], tool: usize) -> Vec<u32> {
        let last = (self.laws().ends()[tool].ceil() as u32).saturating_sub(1);
        let of = |turn: &f64| if tool == 0 { *turn } else { self.second(*turn) };
        at.iter().map(|turn| (of(turn).max(0.0).floor() as u32).min(last)).collect()
    }

    fn rows(&self, places: Vec<PairPlace>, turns: [Vec<u32>; 2]) -> PairedRows {
        let [a, b] = self.path.region_x_mm;
        let contacts = places.iter().flat_map(|p| p.contacts.iter().map(|c| self.level.along.height_mm(&c.contact)));
        let lowest_mm = contacts.fold(f64::INFINITY, f64::min);
        PairedRows {
            radius_mm: [self.options.radius_mm; 2],
            stock_mm: self.path.stock_mm,
            scallop_mm: self.path.scallop_mm,
            chord_mm: self.path.chord_mm,
            heights_mm: [a.min(b), a.max(b)],
            planned_scallop_mm: [self.path.planned_scallop_mm; 2],
            rows: std::iter::once(0..places.len()).collect(),
            edge_rows: 1,
            edge_heights_mm: Some([lowest_mm, a.max(b)]),
            turns: Some(turns),
            places,
            ends: Vec::new(),
        }
    }

    /// Both balls while thread 1 is at a turn.
    fn at(&self, turn: f64) -> Result<Place> {
        let touches = [self.touch(0, turn)?, self.touch(1, self.second(turn))?];
        Ok(Place { turn, touches })
    }

    /// The ball of a thread at one of its turns.
    fn touch(&self, tool: usize, turn: f64) -> Result<Touch> {
        let (mut share, mut level) = self.laws().on_sheet(tool, turn);
        let last = (self.turns.len() - 1) as f64;
        // The end of a turn is the start of the next; the last one has an end only.
        if level > last && share < 0.5 {
            (share, level) = (share + 1.0, level - 1.0);
        }
        let level = level.clamp(0.0, last);
        let k = (level.floor() as usize).min(self.turns.len() - 1);
        let share = share.clamp(0.0, 1.0);
        let f = self.bends.get(k).map_or(level - k as f64, |bends| bent(bends, level - k as f64, share));
        let p = self.centre(k, share);
        let q = if f > 0.0 { self.centre(k + 1, share) } else { p };
        let guess = p + (q - p) * f;
        self.across([&p, &q], f).map(|t| self.closer(t)).ok_or_else(|| {
            Error::infeasible(
                Stage::Path,
                format!(
                    "between turns {} and {} of the helix a ball of radius {} mm loses the surface near \
                     ({:.3}, {:.3}, {:.3}) of the blade frame",
                    k + 1,
                    k + 2,
                    self.level.radius_mm,
                    guess.x,
                    guess.y,
                    guess.z
                ),
                loses_surface(self.level.radius_mm, &[guess]),
            )
            .advise("take a smaller ball, or end the region higher")
        })
    }

    /// The ball centre of the helix at a share of one of its turns.
    fn centre(&self, turn: usize, share: f64) -> Point {
        let s_mm = self.turns[turn].from_mm + share * self.turns[turn].length_mm;
        Point::from([0, 1, 2].map(|k| self.centres.value(s_mm, k)))
    }

    /// The ridge between two passes, mm; `None` where nothing is known of it.
    fn ridge_mm(&self, a: &Point, b: &Point) -> Option<f64> {
        let ridge = ridge_height(&self.level, [a, b].map(Pass::of_ball).each_ref());
        ridge.filter(|h| h.is_finite() && *h > 0.0)
    }

    /// The touch at a share of the way from one centre to another on the level set.
    fn across(&self, [p, q]: [&Point; 2], f: f64) -> Option<Touch> {
        let width_mm = (q - p).norm();
        let reach_mm = width_mm + 0.25 * self.level.radius_mm;
        let at = |f: f64| self.level.touch(&(p + (q - p) * f), reach_mm);
        let touch = at(f)?;
        let off_mm = (touch.centre - (p + (q - p) * f)).norm();
        // Little by little, so that a thread has no step where it begins to matter.
        let counts = (off_mm / (STRAIGHT * width_mm).max(f64::MIN_POSITIVE) - 1.0).clamp(0.0, 1.0);
        if counts == 0.0 {
            return Some(touch);
        }
        let along: Vec<Point> =
            (0..=PIECES).map(|k| at(k as f64 / PIECES as f64).map(|t| t.centre)).collect::<Option<_>>()?;
        let s_mm = arc_lengths(along.iter());
        let want_mm = f * s_mm[PIECES];
        let k = s_mm.partition_point(|s| *s <= want_mm).clamp(1, PIECES) - 1;
        let piece_mm = s_mm[k + 1] - s_mm[k];
        let g = if piece_mm > 0.0 { (want_mm - s_mm[k]) / piece_mm } else { 0.0 };
        let there = along[k] + (along[k + 1] - along[k]) * g;
        self.level.touch(&(touch.centre + (there - touch.centre) * counts), reach_mm)
    }

    /// The same touch by one more step: places may be a tenth of a millimetre apart, and over so
    /// short a way what a centre is off its level set by becomes jerk of the axes.
    fn closer(&self, touch: Touch) -> Touch {
        let Some(c) = self.level.part.closest(&touch.centre, 2.0 * self.level.radius_mm) else { return touch };
        let Some(normal) = (touch.centre - c.point).try_normalize(1e-9) else { return touch };
        let centre = touch.centre + normal * (self.level.radius_mm - c.distance_mm);
        Touch { centre, contact: c.point, normal, face: c.face }
    }

    /// Adds the turns of places strictly between two.
    fn between(&self, [a, b]: [&Place; 2], depth: u32, out: &mut Vec<f64>) -> Result<()> {
        let longest_mm = (0..2).map(|j| (b.touches[j].centre - a.touches[j].centre).norm()).fold(0.0, f64::max);
        // No bend is tighter than the ball: so short a chord is within the tolerance, and finer
        // places would follow what is left of the search for touches.
        let short = longest_mm * longest_mm <= 8.0 * self.options.radius_mm * self.options.chord_mm();
        if depth >= MOST_HALVINGS || short && depth >= SHORT_HALVINGS {
            return Ok(());
        }
        let middle = self.at(0.5 * (a.turn + b.turn))?;
        let splits = (0..2).any(|j| {
            let [l, m, r] = [a, &middle, b].map(|p| &p.touches[j]);
            let off_mm = (m.centre - closest_on_segment(&l.centre, &r.centre, &m.centre)).norm();
            let long = (r.centre - l.centre).norm() > self.options.settings.max_step_mm;
            long || off_mm > chords::tolerance_mm(&self.level, l, r, self.options)
        });
        if splits {
            self.between([a, &middle], depth + 1, out)?;
            out.push(middle.turn);
            self.between([&middle, b], depth + 1, out)?;
        }
        Ok(())
    }
}

impl Strand {
    fn of(path: &Toolpath, turn: usize, turned: &[f64]) -> Self {
        let own = path.turns[turn];
        let end = (own.first + own.count + 1).min(path.locations.len());
        let locations = &path.locations[own.first..end];
        let from_mm = locations[0].s_mm;
        let s_mm: Vec<f64> = locations.iter().map(|l| l.s_mm - from_mm).collect();
        let length_mm = s_mm.last().copied().unwrap_or(0.0);
        let share = s_mm.iter().map(|s| s / length_mm.max(f64::MIN_POSITIVE)).collect();
        let turned = turned[own.first..end].iter().map(|all| all - turn as f64).collect();
        Strand { from_mm, share, turned, length_mm }
    }

    /// What the normal has turned at a share of the turn, see `turned`.
    fn turned(&self, share: f64) -> f64 {
        let last = self.share.len() - 1;
        let i = self.share.partition_point(|s| *s <= share).clamp(1, last.max(1)) - 1;
        let (Some(b), width) = (self.turned.get(i + 1), self.share.get(i + 1).map_or(0.0, |s| s - self.share[i]))
        else {
            return self.turned[i];
        };
        let a = self.turned[i];
        if width > 0.0 { a + (b - a) * ((share - self.share[i]) / width).clamp(0.0, 1.0) } else { *b }
    }
}

/// The ball centres of a helix over its arc length.
///
/// # Errors
/// Kind `Usage` where two locations are in one place.
fn centres(path: &Toolpath) -> Result<CubicSpline> {
    let s_mm: Vec<f64> = path.locations.iter().map(|l| l.s_mm).collect();
    let values: Vec<f64> = path.locations.iter().flat_map(|l| [l.centre.x, l.centre.y, l.centre.z]).collect();
    CubicSpline::new(&s_mm, &values, 3, &SplineEnds::Natural)
        .map_err(|e| Error::usage(Stage::Path, format!("the helix has no smooth curve through its locations: {e}")))
}

/// What the normal has turned about the region's axis at each location, in turns, counted so that
/// it grows along the path.
fn turned(path: &Toolpath, along: &Along) -> Vec<f64> {
    let azimuth = |l: &CutterLocation| {
        let [a, b] = along.frame(&l.centre).across(&l.normal);
        b.atan2(a)
    };
    let (mut all, mut sum, mut last) = (Vec::with_capacity(path.locations.len()), 0.0, None::<f64>);
    for l in &path.locations {
        let here = azimuth(l);
        sum += last.replace(here).map_or(0.0, |before| within_half_turn(here - before) / TAU);
        all.push(sum);
    }
    if sum < 0.0 {
        all.iter_mut().for_each(|v| *v = -*v);
    }
    all
}

/// How the threads of a helix of so many turns go over its sheet.
#[derive(Clone, Copy)]
struct Laws {
    turns: usize,
    begin: f64,
}

impl Laws {
    /// The turns at which both threads end; thread 1 begins at 0, thread 2 at `begin`.
    fn ends(&self) -> [f64; 2] {
        let n = self.turns as f64;
        match self.turns % 2 {
            1 => [0.5 * (n + 1.0), 0.5 * (n + 1.0) + self.begin],
            _ => [0.5 * n + self.begin, 0.5 * n + 1.0],
        }
    }

    /// `ρ` of a thread at one of its turns.
    fn rho(&self, tool: usize, turn: f64) -> f64 {
        let leaves = [self.begin, 1.0 + self.begin][tool];
        let end = self.ends()[tool];
        let n = self.turns as f64;
        // The one that ends with a turn ends with the helix.
        let ends_last = (tool == 0) == (self.turns % 2 == 1);
        let last = if ends_last { n } else { n - 1.0 + self.begin };
        turn.max(2.0 * turn - leaves).min(last - (end - turn))
    }

    /// The share of the turn and the level on the sheet.
    fn on_sheet(&self, tool: usize, turn: f64) -> (f64, f64) {
        let share = turn - turn.floor();
        (share, self.rho(tool, turn) - share)
    }
}

/// Shares of a turn at which the helix passes the leading and the trailing edge, turn by turn,
/// without jumps; `None`: they are not known.
fn edges(region: &Region, path: &Toolpath) -> Option<[Vec<f64>; 2]> {
    let sides = region.sides.as_ref()?;
    let mut out = [Vec::new(), Vec::new()];
    for turn in &path.turns {
        let own = &path.locations[turn.first..turn.first + turn.count];
        for (e, shares) in out.iter_mut().enumerate() {
            let off = |at: &Point| {
                let [y, z] = sides.at(at.x)[e];
                (at.y - y).hypot(at.z - z)
            };
            let nearest = own.iter().min_by(|a, b| off(&a.contact).total_cmp(&off(&b.contact)))?;
            let share = nearest.turn_s_mm / turn.length_mm.max(f64::MIN_POSITIVE);
            let before = shares.last().copied().unwrap_or(share);
            shares.push(share + (before - share).round());
        }
    }
    Some(out)
}

/// How far a thread has come round the blade, in turns: by what its normal has turned, and for the
/// rest by its way between the edges. Where the normal hardly turns the way counts, and round edges
/// the normal.
struct Phase<'a> {
    by_normal: f64,
    laws: &'a Laws,
    turns: &'a [Strand],
    tool: usize,
    /// By the edges; `None`: by the way alone.
    by_edges: Option<Monotone>,
}

impl<'a> Phase<'a> {
    fn of(by_normal: f64, laws: &'a Laws, turns: &'a [Strand], edges: Option<&[Vec<f64>; 2]>, tool: usize) -> Self {
        let by_edges = edges.and_then(|[leading, trailing]| {
            // Half turns at the first leading and trailing edge.
            let first = [0.0, if trailing.first()? > leading.first()? { 0.5 } else { -0.5 }];
            let count = laws.turns as i64 / 2 + 4;
            let mut passes: Vec<[f64; 2]> = (-2..=count)
                .flat_map(|turn| {
                    [(leading, first[0]), (trailing, first[1])].map(|(shares, phase)| {
                        let turn = turn as f64;
                        let mut at = turn + shares[0];
                        for _ in 0..ROUNDS {
                            at = turn + among(shares, laws.rho(tool, at) - (at - turn));
                        }
                        [at, turn + phase]
                    })
                })
                .collect();
            passes.sort_by(|a, b| a[0].total_cmp(&b[0]));
            let rises = passes.windows(2).all(|w| w[0][1] < w[1][1]);
            Monotone::new(&passes).filter(|_| rises)
        });
        Phase { by_normal, laws, turns, tool, by_edges }
    }

    /// The phase at a turn of the thread.
    fn at(&self, turn: f64) -> f64 {
        let (share, level) = self.laws.on_sheet(self.tool, turn);
        let level = level.clamp(0.0, (self.turns.len() - 1) as f64);
        let k = (level.floor() as usize).min(self.turns.len() - 1);
        let own = self.turns[k].turned(share);
        let next = self.turns.get(k + 1).map_or(own, |t| t.turned(share));
        let by_normal = turn.floor() + own + (next - own) * (level - k as f64);
        let by_way = self.by_edges.as_ref().map_or(turn, |by| by.at(turn));
        self.by_normal * by_normal + (1.0 - self.by_normal) * by_way
    }

    /// The phase at places of the thread, which grow: it grows too.
    fn rising(&self, places: &[f64]) -> Vec<f64> {
        let mut out: Vec<f64> = Vec::with_capacity(places.len());
        for (k, at) in places.iter().enumerate() {
            let least = k.checked_sub(1).map_or(f64::NEG_INFINITY, |b| out[b] + SLOWEST * (at - places[b]));
            out.push(self.at(*at).max(least));
        }
        out
    }
}

/// The turn of thread 2 by that of thread 1, half a turn of their phases apart.
fn paired(by_normal: f64, laws: &Laws, turns: &[Strand], edges: Option<&[Vec<f64>; 2]>) -> Option<CubicSpline> {
    let [first, second] = [0, 1].map(|tool| Phase::of(by_normal, laws, turns, edges, tool));
    let count = (laws.turns as f64 / 2.0 + 3.0) * IN_A_TURN;
    let places: Vec<f64> = (-(IN_A_TURN as i64)..count as i64).map(|k| k as f64 / IN_A_TURN).collect();
    let (phases, others) = (first.rising(&places), second.rising(&places));
    let back: Vec<[f64; 2]> = others.into_iter().zip(&places).map(|(phase, at)| [phase, *at]).collect();
    let back = Monotone::new(&back)?;
    let ahead: Vec<f64> = places.iter().zip(phases).map(|(at, phase)| back.at(phase + 0.5) - at).collect();
    let ahead = (0..SMOOTHED).fold(ahead, |ahead, _| averaged(&ahead));
    let values: Vec<f64> = places.iter().zip(ahead).map(|(at, ahead)| at + ahead).collect();
    CubicSpline::new(&places, &values, 1, &SplineEnds::Natural).ok()
}

/// Levels between two turns whose shares of the way are known.
const LEVELS: [f64; 3] = [0.25, 0.5, 0.75];

/// The shares of the way at those levels, at places that divide a turn evenly.
type Bends = Vec<[f64; 3]>;

/// The share of the way between two turns at a level between them and a place in the turn.
fn bent(bends: &Bends, level: f64, place: f64) -> f64 {
    let at = place.clamp(0.0, 1.0) * BEND_PLACES as f64;
    let k = (at.floor() as usize).min(BEND_PLACES - 1);
    // Without kinks: what a thread goes aside by within a step is jerk.
    let share = |n: usize| {
        let [before, a, b, after] =
            [k.saturating_sub(1), k, k + 1, (k + 2).min(BEND_PLACES)].map(|place| bends[place][n]);
        hermite([a, b], [0.5 * (b - before), 0.5 * (after - a)], at - k as f64)
    };
    let [a, b, c] = LEVELS;
    let known = [[0.0, 0.0], [a, share(0)], [b, share(1)], [c, share(2)], [1.0, 1.0]];
    Monotone::new(&known).map_or(level, |curve| curve.at(level))
}

/// The ways from a turn to the next and on to the one after that, at one place of the turn.
struct Gap<'t, 'a> {
    threads: &'t Threads<'a>,
    ends: [&'t Point; 3],
    /// Lengths of both ways, mm.
    ways_mm: [f64; 2],
    /// Ridges that the turns leave there, mm.
    ridges_mm: [f64; 2],
}

impl<'t, 'a> Gap<'t, 'a> {
    /// `None` where turns are hardly apart, or ridges between them say nothing.
    fn of(threads: &'t Threads<'a>, ends: [&'t Point; 3]) -> Option<Self> {
        let [p, q, r] = ends;
        let way = |a: &Point, b: &Point| {
            let middle = threads.across([a, b], 0.5)?.centre;
            Some((middle - a).norm() + (b - middle).norm())
        };
        let ways_mm = [way(p, q)?, way(q, r)?];
        let ridges_mm = [threads.ridge_mm(p, q)?, threads.ridge_mm(q, r)?];
        let narrow = ways_mm[0].min(ways_mm[1]) < NARROW * threads.level.radius_mm;
        (!narrow).then_some(Gap { threads, ends, ways_mm, ridges_mm })
    }

    /// The share of the second way that leaves the same ridge below a share of the first.
    fn next(&self, share: f64) -> Option<f64> {
        let ([p, q, r], [own_mm, next_mm]) = (self.ends, self.ways_mm);
        let wanted_mm = self.ridges_mm[0] + (self.ridges_mm[1] - self.ridges_mm[0]) * share;
        let here = self.threads.across([p, q], share)?.centre;
        let above_mm = (1.0 - share) * own_mm;
        let mut f = share;
        for _ in 0..ROUNDS {
            let at = self.threads.across([q, r], f)?.centre;
            let factor = (wanted_mm / self.threads.ridge_mm(&here, &at)?).sqrt();
            let next = (((above_mm + f * next_mm) * factor - above_mm) / next_mm).clamp(0.0, 1.0);
            let moved = (next - f).abs();
            f = next;
            if moved < SAME_SHARE {
                break;
            }
        }
        Some(f)
    }
}

/// Means of each value and so many to both sides of it, fewer near the ends.
fn averaged(values: &[f64]) -> Vec<f64> {
    let last = values.len().saturating_sub(1);
    let mean = |k: usize| {
        let half = AVERAGED.min(k).min(last - k);
        let of = &values[k - half..=k + half];
        of.iter().sum::<f64>() / of.len() as f64
    };
    (0..values.len()).map(mean).collect()
}

/// The value at a place among values at 0, 1, 2 …
fn among(values: &[f64], at: f64) -> f64 {
    let last = values.len().saturating_sub(1);
    let at = at.clamp(0.0, last as f64);
    let k = (at.floor() as usize).min(last.saturating_sub(1));
    let next = values.get(k + 1).copied().unwrap_or(values[k]);
    values[k] + (next - values[k]) * (at - k as f64)
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used)]
    use proptest::prelude::*;

    use super::*;

    proptest! {
        /// At every share of a turn both threads together pass levels at most one apart, from the
        /// first turn of the helix to its last, and one apart in between.
        #[test]
        fn neighbours_are_one_level_apart(turns in 3usize..40, begin in 0.2f64..0.8, share in 0.0f64..1.0) {
            let laws = Laws { turns, begin };
            let ends = laws.ends();
            let mut levels: Vec<f64> = (0..2).flat_map(|tool| {
                let from = [0.0, begin][tool];
                (0..turns + 2).map(|k| k as f64 + share).filter(move |at| *at >= from && *at <= ends[tool])
                    .map(move |at| laws.on_sheet(tool, at).1)
            }).collect();
            levels.sort_by(f64::total_cmp);
            let last = turns as f64 - 1.0;
            prop_assert!(levels[0].abs() < 1e-9 && (levels[levels.len() - 1] - last).abs() < 1e-9, "{levels:?}");
            let steps: Vec<f64> = levels.windows(2).map(|w| w[1] - w[0]).collect();
            prop_assert!(steps.iter().all(|step| *step <= 1.0 + 1e-9), "{levels:?}");
            // Where a thread joins the helix or leaves it, two passes lie nearer.
            let near = steps.iter().filter(|step| **step < 1.0 - 1e-9).count();
            prop_assert!(near <= 4, "{levels:?}");
            // Both take as many turns.
            prop_assert!((ends[0] - (ends[1] - begin)).abs() < 1.0 + 1e-9);
        }
    }
}
