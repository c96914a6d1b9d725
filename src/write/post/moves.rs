//! The cutting moves, the same for all dialects: cutter locations, and between them as many more as
//! the control's own interpolation asks for.
//!
//! Between two lines a control moves every word evenly: the programmed point goes straight, and `A`
//! turns evenly. The ball centre then leaves the straight way between two cutter locations: under
//! tool-centre-point control by tip by at most `R (1 − cos(Δθ/2))`, and with positions of machine
//! axes by the sagitta of the arc on which a fixed axis position goes round the turning part. Where
//! that is more than the chord tolerance of the path, the move is written in equal parts. Where the
//! schedule keeps one offset the parts keep it too: between two lines Y then has nowhere to go.

use crate::artifact::plan::{Row, Stretch};
use crate::artifact::program::{Programmed, WordRange};
use crate::artifact::{Axes, Motion, Plan, Stand};
use crate::error::{Error, Infeasible, Result, Stage};
use crate::geometry::{Point, Vector};

use super::OperationRun;

/// Most parts that a move is written in.
const MOST_PARTS: usize = 1000;

/// Where five axes move at once: the tool axis within a line is within this of the plan's, rad
/// (0.01 degrees).
const ASKEW_RAD: f64 = 1.7e-4;

/// Coefficients of `p²` to `p⁵` of every word, linear ones in mm, those of rotary axes in degrees.
pub(super) type WordBends = Axes<[f64; 4]>;

/// Gives the words of a place, mm and degrees: a column for each axis of the machine, those of X,
/// Y, Z being the programmed point.
pub(super) type WordsOf<'a> = dyn Fn(&Move) -> Axes + Sync + 'a;

/// The end of a cutting move.
#[derive(Clone, Copy, Debug)]
pub(super) struct Move {
    /// Where the tool stands.
    pub(super) stand: Stand,
    /// Where the plan's axes stand at the row beside it: of several ways to bring the tool there
    /// the nearest is taken.
    pub(super) near: Axes,
    /// Time, s.
    pub(super) t_s: f64,
    /// What it belongs to.
    pub(super) stretch: Stretch,
    /// How its words bend on the way.
    pub(super) bend: Option<WordBends>,
    /// Length of its piece of the programmed curve, in the curve's own parameter, mm; 0 where it is
    /// none.
    pub(super) span_mm: f64,
    /// Its words where they are not to the last digit those of the stand, mm and degrees, a column
    /// for each axis of the machine, those of X, Y, Z being the programmed point.
    pub(super) words: Option<Axes>,
}

impl Move {
    /// The rows of the plan, each as the end of a straight move to it.
    pub(super) fn rows(plan: &Plan) -> impl Iterator<Item = Move> + '_ {
        let one = |(Row { stand, t_s, stretch }, near): (Row, &[f64])| Move {
            stand,
            near: near.into(),
            t_s,
            stretch,
            bend: None,
            span_mm: 0.0,
            words: None,
        };
        plan.rows().zip(plan.axes()).map(one)
    }

    /// Axis positions there.
    pub(super) fn axes(&self, run: &OperationRun) -> Axes {
        run.machine.place(&self.stand, Some(&self.near), run.tool.length_mm())
    }
}

/// Checks that a plan can be written at all.
pub(super) fn well_formed(plan: &Plan) -> Result<()> {
    let n = plan.toolpath.locations.len();
    let bad = |m: String| Err(Error::usage(Stage::Post, m));
    if n < 2 {
        return bad(format!("the plan has {n} cutter locations, a program needs at least 2"));
    }
    for (name, rows) in [
        ("angles", plan.schedule.theta.len()),
        ("axis positions", plan.motion.position.len()),
        ("times", plan.motion.t_s.len()),
    ] {
        if rows != n {
            return bad(format!("the plan has {n} cutter locations but {rows} {name}"));
        }
    }
    let rows = plan.toolpath.locations.iter().zip(&plan.schedule.theta).zip(&plan.motion.position);
    for (i, ((l, theta), q)) in rows.enumerate() {
        let numbers = l.centre.iter().chain(l.normal.iter()).chain(q.iter()).chain([theta]);
        if !numbers.into_iter().all(|x| x.is_finite()) {
            return bad(format!("cutter location {i} of the plan has a value that is not a finite number"));
        }
    }
    if !plan.toolpath.cones.fit(n) {
        return bad("the head's angle B, or a cone of tool axes, is not a finite number".into());
    }
    if let Some(i) = plan.motion.t_s.windows(2).position(|w| !(w[1] >= w[0] && w[1].is_finite())) {
        return bad(format!("time goes back or is not finite after cutter location {i}"));
    }
    let rows: Vec<Row> = plan.rows().collect();
    let leads: usize = plan.leads.iter().map(|l| l.centres.len()).sum();
    let finite = |r: &Row| r.stand.centre.iter().chain([&r.stand.theta, &r.t_s]).all(|x| x.is_finite());
    if rows.len() != n + leads
        || plan.axes().count() != rows.len()
        || !rows.iter().all(finite)
        || !rows.windows(2).all(|w| w[1].t_s >= w[0].t_s)
    {
        return bad("a lead of the plan misses angles or times, or they go back or are not finite".into());
    }
    Ok(())
}

/// Feed as text with at least six digits that count where the control reads as many; `None`: it is
/// out of the control's range.
pub(super) fn feed_word(f: f64, range: &WordRange) -> Option<String> {
    // What is over by the last digits of a division is within.
    let f = if f > range.greatest && f < range.greatest * (1.0 + 1e-9) { range.greatest } else { f };
    if !(range.least..=range.greatest).contains(&f) {
        return None;
    }
    let before_point = f.log10().floor().max(0.0) as usize + 1;
    Some(format!("{f:.*}", 8usize.saturating_sub(before_point).clamp(3, 6).min(range.decimals)))
}

/// The first row and all moves after it.
pub(super) fn all(run: &OperationRun, programmed: Programmed) -> Result<Vec<Move>> {
    let plan = run.plan;
    let mut out: Vec<Move> = Vec::with_capacity(plan.toolpath.locations.len());
    for (row, next) in Move::rows(plan).enumerate() {
        match out.last().copied() {
            Some(from) => out.extend(straight(run, programmed, row, (&from, &next))?),
            None => out.push(next),
        }
    }
    Ok(out)
}

/// The straight moves to a row of the plan from the one before.
pub(super) fn straight(
    run: &OperationRun,
    programmed: Programmed,
    row: usize,
    (from, next): (&Move, &Move),
) -> Result<Vec<Move>> {
    let plan = run.plan;
    let parts = parts(run, programmed, from, next);
    if parts > MOST_PARTS {
        return Err(Error::infeasible(
            Stage::Post,
            format!("the move to row {row} of the motion turns so far that it would take {parts} blocks to keep the chord tolerance of {} mm", plan.toolpath.chord_mm),
            Infeasible::MoveTurnsTooFar { row, lines: parts, most_lines: MOST_PARTS, chord_mm: plan.toolpath.chord_mm },
        )
        .advise("allow a larger path.chord_mm, or plan closer locations with path.max_step_mm"));
    }
    let part = |k: usize| {
        let f = k as f64 / parts as f64;
        Move {
            stand: plan.schedule.between(&from.stand, &next.stand, f),
            t_s: from.t_s + (next.t_s - from.t_s) * f,
            stretch: Motion::stretch_between(from.stretch, next.stretch),
            ..*from
        }
    };
    Ok((1..parts).map(part).chain([*next]).collect())
}

/// In how many equal parts a move has to be written: the deviation falls with the square of their
/// number.
fn parts(run: &OperationRun, programmed: Programmed, a: &Move, b: &Move) -> usize {
    // Half of the tolerance: the other half is for the rounding of words and the path's own chords.
    let allowed = 0.5 * run.plan.toolpath.chord_mm.max(1e-6);
    let mid = deviation_mm(run, programmed, a, b);
    (mid / allowed).sqrt().ceil().clamp(1.0, 1e9) as usize
}

/// Distance, halfway, of the ball centre as the control moves it from halfway between two
/// locations.
fn deviation_mm(run: &OperationRun, programmed: Programmed, a: &Move, b: &Move) -> f64 {
    let middle = nalgebra::center(&a.stand.centre, &b.stand.centre);
    let radius = run.tool.corner_mm();
    match programmed {
        Programmed::Centre => askew_mm(run, a, b),
        Programmed::Tip => {
            let [at_a, at_b, between] = [a.stand, b.stand, halfway(run, a, b)].map(|s| s.axis());
            if run.turns_the_blade_alone() {
                return radius * (0.5 * (at_a + at_b) - between).norm();
            }
            let ball = halfway_axis(run, a, b) * radius - 0.5 * radius * (at_a + at_b);
            ball.norm().max(askew_mm(run, a, b))
        }
        Programmed::Machine => {
            let gauge = run.tool.length_mm();
            let [p, q] = [a, b].map(|m| m.axes(run));
            let halfway = mean(&p, &q);
            (run.machine.forward(&halfway, gauge).centre - middle).norm().max(askew_mm(run, a, b))
        }
    }
}

/// The ball centre at a share of the move from one place to another, as the control moves it: every
/// word evenly.
pub(super) fn ball_centre(run: &OperationRun, programmed: Programmed, a: &Move, b: &Move, share: f64) -> Point {
    let (radius, gauge) = (run.tool.corner_mm(), run.tool.length_mm());
    let centre = a.stand.centre + (b.stand.centre - a.stand.centre) * share;
    let [p, q] = [a, b].map(|m| m.axes(run));
    let axes = p.toward(&q, share);
    match programmed {
        Programmed::Centre => centre,
        Programmed::Tip => {
            let [at_a, at_b] = [a.stand.axis(), b.stand.axis()];
            centre + (run.machine.axis_at(&axes) - (at_a + (at_b - at_a) * share)) * radius
        }
        Programmed::Machine => run.machine.forward(&axes, gauge).centre,
    }
}

/// Every axis halfway between two places.
fn mean(p: &[f64], q: &[f64]) -> Axes {
    Axes::from_fn(p.len(), |i| 0.5 * (p[i] + q[i]))
}

/// Halfway on the straight move, as it is cut into parts.
fn halfway(run: &OperationRun, a: &Move, b: &Move) -> Stand {
    run.plan.schedule.between(&a.stand, &b.stand, 0.5)
}

/// The tool axis halfway between two locations, the rotary axes turning evenly.
fn halfway_axis(run: &OperationRun, a: &Move, b: &Move) -> Vector {
    let [p, q] = [a, b].map(|m| run.machine.turn_to(&m.stand, Some(&m.near)));
    run.machine.axis_at(&mean(&p, &q))
}

/// How far the tool's gauge line is off halfway where both rotary axes move: evenly turning axes
/// then leave the cone. In mm of the chord tolerance, [`ASKEW_RAD`] being half of it.
fn askew_mm(run: &OperationRun, a: &Move, b: &Move) -> f64 {
    if run.turns_the_blade_alone() {
        return 0.0;
    }
    let between = halfway(run, a, b).axis();
    0.5 * run.plan.toolpath.chord_mm * (halfway_axis(run, a, b) - between).norm() / ASKEW_RAD
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used)]
    use super::*;

    const RANGE: WordRange = WordRange { least: 0.001, greatest: 999_999.999, decimals: 6 };

    #[test]
    fn feed_words_keep_time_and_are_never_zero() {
        for dt in [1e-9, 1e-4, 0.003, 0.02, 0.7, 3.0, 59.0, 4000.0, 1e9] {
            let word = feed_word(60.0 / dt, &RANGE);
            if (1e-4..1000.0).contains(&dt) {
                let f: f64 = word.unwrap().parse().unwrap();
                assert!(f > 0.0 && (60.0 / f / dt - 1.0).abs() < 1e-5, "{dt} {f}");
            } else {
                assert_eq!(word.is_some(), dt == 4000.0, "{dt}");
            }
        }
        assert_eq!(feed_word(f64::NAN, &RANGE), None);
        let three = WordRange { decimals: 3, ..RANGE };
        assert_eq!(feed_word(332.007_7, &three).unwrap(), "332.008");
        assert_eq!(feed_word(999_999.999_000_001, &RANGE).unwrap(), "999999.999");
    }
}
