//! The motion of a program in short legs: the ball centre goes straight, θ and B change evenly.

use std::f64::consts::{PI, TAU};

use crate::artifact::Stand;
use crate::error::{Error, Result, Stage};
use crate::geometry::Point;
use crate::numerics::angle::within_half_turn;
use crate::parallel;
use crate::read::program::{Bench, Moved};

/// How far the ball centre may be off a leg in feed moves, mm: well below what the checks resolve.
const OFF_MM: f64 = 0.0002;
/// How far the gauge line may be off a leg on which the rotary axes do not turn evenly, mm: below
/// what the checks of clearance resolve.
const OFF_GAUGE_MM: f64 = 0.001;
/// The same as the first in rapids, mm.
const OFF_RAPID_MM: f64 = 0.01;
/// No leg turns further than this, rad, before the distance above is asked for.
const COARSE_RAD: f64 = 5.0 * PI / 180.0;
/// A place left out between two moves is a gap from this on, mm. Each coordinate of a spline line
/// may begin 1 µm off the end of the line before.
const GAP_MM: f64 = 2e-3;
/// Most legs of one move and of a program: what takes seconds, not hours.
const MOST: [usize; 2] = [2_000_000, 10_000_000];

/// What a leg is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum LegKind {
    /// At a feed.
    Cut,
    /// Rapid.
    Rapid,
    /// Nothing is known of the way.
    Gap,
}

/// From place `i` to place `i + 1`.
#[derive(Clone, Copy, Debug)]
pub(super) struct Leg {
    pub kind: LegKind,
    /// Index of the move.
    pub moved: usize,
    /// From which to which share of the move.
    pub share: [f64; 2],
}

/// The places and the legs between them.
#[derive(Default)]
pub(super) struct Legs {
    /// Where the tool stands, on a cone about the blade axis whose lean may change.
    pub stands: Vec<Stand>,
    /// One fewer than places.
    pub legs: Vec<Leg>,
    /// Moves left out because where they begin or end is not known.
    pub unknown: usize,
}

impl Legs {
    /// Legs of all moves that are known.
    ///
    /// # Errors
    /// `Usage` where a move or the whole program would take more than [`MOST`] legs, with the line.
    pub fn new(moves: &[Moved], bench: &Bench) -> Result<Self> {
        let counts = parallel::map(moves, |m| m.known().then(|| parts(m, bench)));
        // A line that only says a feed or a function again moves nothing.
        let goes = |m: &Moved| m.from != m.to || !m.even();
        let check = |m: &Moved, parts: usize, before: usize| {
            if parts <= MOST[0] && before + parts <= MOST[1] {
                return Ok(());
            }
            let what = format!("line {} of the program turns too far to be followed: {parts} legs", m.line);
            Err(Error::usage(Stage::Verify, what))
        };
        let mut before = 0;
        for (m, count) in moves.iter().zip(&counts) {
            let Some(parts) = *count else { continue };
            check(m, parts, before)?;
            before += if goes(m) { parts } else { 0 };
        }
        let shares = |parts: usize| (0..=parts).map(move |k| k as f64 / parts as f64);
        // Where a move begins, and where its legs end.
        let centres = parallel::map(moves.iter().zip(&counts), |(m, count)| -> Vec<Point> {
            let centre = |f: f64| m.pose(f, bench.tool, bench.machine).centre;
            count.map_or_else(Vec::new, |parts| shares(parts).map(centre).collect())
        });
        let mut out = Legs::default();
        for (moved, ((m, count), centres)) in moves.iter().zip(counts).zip(centres).enumerate() {
            let Some(parts) = count else {
                out.unknown += 1;
                continue;
            };
            // Places behind gaps count, too.
            check(m, parts, out.stands.len())?;
            let kind = if m.seconds.is_some() { LegKind::Cut } else { LegKind::Rapid };
            let mut ends = shares(parts).zip(centres);
            if let Some((_, begin)) = ends.next()
                && out.stands.last().is_none_or(|s| (s.centre - begin).norm() > GAP_MM)
            {
                out.push((m, begin), Leg { kind: LegKind::Gap, moved, share: [0.0; 2] }, bench);
            }
            if goes(m) {
                let mut from = 0.0;
                for (to, centre) in ends {
                    out.push((m, centre), Leg { kind, moved, share: [from, to] }, bench);
                    from = to;
                }
            }
        }
        Ok(out)
    }

    /// Adds where a leg of a move ends.
    fn push(&mut self, (m, centre): (&Moved, Point), leg: Leg, bench: &Bench) {
        if !self.stands.is_empty() {
            self.legs.push(leg);
        }
        let near = self.stands.last().map_or(0.0, |s| s.theta);
        let [theta, lean] = bench.machine.theta_and_lean(&m.at(leg.share[1]), near);
        self.stands.push(Stand::about_blade(centre, theta, lean));
    }

    /// Which legs are of a kind.
    pub fn of(&self, kind: LegKind) -> Vec<bool> {
        self.legs.iter().map(|l| l.kind == kind).collect()
    }

    /// Turns about the blade axis at each place, counted from the first place at a feed that
    /// `touches`, where there is one.
    pub fn turns(&self, touches: impl Fn(&Stand) -> bool) -> Vec<u32> {
        let angle = |c: &Point| c.z.atan2(c.y);
        let mut turned = vec![0.0f64; self.stands.len()];
        for (i, w) in self.stands.windows(2).enumerate() {
            let step = angle(&w[1].centre) - angle(&w[0].centre);
            turned[i + 1] = turned[i] + within_half_turn(step);
        }
        let cuts = |i: &usize| self.legs.get(*i).is_some_and(|l| l.kind == LegKind::Cut);
        let first = (0..self.stands.len()).filter(cuts).find(|i| touches(&self.stands[*i])).unwrap_or(0);
        let from = turned.get(first).copied().unwrap_or(0.0);
        let count = |(i, t): (usize, &f64)| if i < first { 0 } else { ((t - from).abs() / TAU + 1e-9) as u32 };
        turned.iter().enumerate().map(count).collect()
    }
}

/// In how many equal legs a move has to be looked at.
fn parts(m: &Moved, bench: &Bench) -> usize {
    let bent = |k: usize| m.bend.map_or(0.0, |b| b[k].iter().map(|a| a.abs()).sum::<f64>());
    let turn = |k: usize| (m.to[k] - m.from[k]).abs() + bent(k);
    let (machine, reach) = (bench.machine, bench.tool.length_mm());
    let rotary = machine.rotary();
    let least = if m.even() { 1.0 } else { 4.0 };
    let farthest = rotary.clone().map(turn).fold(0.0, f64::max);
    let coarse = (farthest / COARSE_RAD).ceil().clamp(least, 1e9);
    let pose = |f: f64| (m.pose(f, bench.tool, machine).centre, m.at(f));
    let allowed = if m.seconds.is_some() { OFF_MM } else { OFF_RAPID_MM };
    // The deviation of a leg falls with the square of its length; it may differ along the move.
    let off = |k: f64| {
        let [a, mid, b] = [k, k + 0.5, k + 1.0].map(|k| pose(k / coarse));
        let centre = (mid.0 - nalgebra::center(&a.0, &b.0)).norm();
        // θ and lean change evenly with the rotary axes where one of these turns the blade.
        if m.even() && machine.turns_the_blade() && rotary.clone().skip(1).all(|k| a.1[k] == b.1[k]) {
            return centre;
        }
        let from = machine.theta_and_lean(&a.1, 0.0);
        let [middle, to] = [mid.1, b.1].map(|at| machine.theta_and_lean(&at, from[0]));
        let turned = (middle[0] - 0.5 * (from[0] + to[0])).hypot(middle[1] - 0.5 * (from[1] + to[1]));
        centre.max(turned * reach * allowed / OFF_GAUGE_MM.max(allowed))
    };
    let mut worst = [0.0, (0.5 * coarse).floor(), coarse - 1.0].map(off).into_iter().fold(0.0, f64::max);
    if !m.even() {
        worst = (0..coarse as usize).map(|k| off(k as f64)).fold(worst, f64::max);
    }
    let fine = (worst / allowed).sqrt().ceil().clamp(1.0, 1e9);
    (coarse * fine) as usize
}
