//! Ridges between neighbouring turns.
//!
//! Two neighbouring passes with centres `c1`, `c2`, `d` apart, meet in a circle of radius
//! `sqrt(R² − d²/4)` about their middle, across `c2 − c1`. The ridge left between them is the
//! circle's point nearest to the part; its distance from the part is the cusp's height. Each ridge
//! counts by the area between the two passes that it stands for: the length of the contacts' way
//! there times `d`.
//!
//! What other moves take off there is no ridge: where a ball runs round a thin edge, moves before
//! and after cut through the meeting of the two. The height is where the line up to the ridge
//! enters the swept ball, which is the ridge itself unless another move is lower by more than
//! chords sag. Such a place counts by no area in percentiles: what is left there is not what these
//! two passes leave.

use super::height::{Height, REACH_SLACK, flat_stepover, lift, percentile, sort};
use super::options::VerifyOptions;
use super::sweep::Sweep;
use crate::artifact::Toolpath;
use crate::geometry::allowance::Allowed;
use crate::geometry::part::Part;
use crate::geometry::{Point, Vector};
use crate::parallel;

/// Ridges are measured at most at so many places.
const MOST_RIDGES: usize = 6000;

/// Its multiples are spread evenly between whole numbers.
const GOLDEN: f64 = 0.618_033_988_749_895;
/// A ridge that other moves lower by this share of what two passes leave on a plane is cut by them.
const CUT: f64 = 0.25;
/// Moves within so many times the distance of the two passes may cut a ridge down.
const REACH_STEPOVERS: f64 = 2.5;
/// Two passes as near as this share of the stepover on a plane leave a four-hundredth of its ridge;
/// where one runs into the other the way from one to the other may be along them, and the circle of
/// the two balls is then no ridge.
const APART: f64 = 0.05;

/// First and last turn, which have a neighbour on one side only.
pub(super) fn outer_turns(sweep: &Sweep) -> (u32, u32) {
    (sweep.turns.first().copied().unwrap_or(0), sweep.turns.last().copied().unwrap_or(0))
}

/// The 99th percentile of the ridges that a path leaves, mm, as its check measures it; 0 where
/// there are none, and on meshes, whose facets bend each ridge by more than the scallop.
pub fn ridges_p99(path: &Toolpath, part: &Part, options: &VerifyOptions) -> f64 {
    if part.brep.is_none() || path.locations.len() < 2 {
        return 0.0;
    }
    let on = Allowed::new(part, path.stock_mm);
    percentile(&all(&on, &Sweep::cutting(path), options.scallop_mm, false), 0.99)
}

/// A ridge between a turn and the next.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RidgeAt {
    /// Locations of the two passes: each pass is at this one or behind it, before the next.
    pub rows: [usize; 2],
    /// Height over the part, mm.
    pub height_mm: f64,
}

/// Ridges that a path leaves between each turn and the next, at most so many, in order of the first
/// pass; none on meshes, whose facets bend each ridge by more than the scallop.
pub fn ridges(path: &Toolpath, part: &Part, options: &VerifyOptions, most: usize) -> Vec<RidgeAt> {
    if part.brep.is_none() || path.locations.len() < 2 {
        return Vec::new();
    }
    let (on, sweep) = (Allowed::new(part, path.stock_mm), Sweep::cutting(path));
    let of = looked_for(&on, &sweep, options.scallop_mm, most);
    let one = |row: usize| {
        if !sweep.touches(row) {
            return None;
        }
        let (ridge, other) = of.with_other(row, sweep.turns[row] + 1)?;
        Some(RidgeAt { rows: [row, other], height_mm: ridge.height_mm })
    };
    parallel::filter_map((0..sweep.centres.len()).step_by(of.every), one)
}

fn looked_for<'a>(part: &'a Allowed<'a>, sweep: &'a Sweep, scallop_mm: f64, most: usize) -> Ridges<'a> {
    let every = sweep.centres.len().div_ceil(most);
    Ridges { part, sweep, every, apart_mm: apart_mm(sweep.radius_mm, scallop_mm), slack_mm: REACH_SLACK * scallop_mm }
}

/// Ridges between each turn and the next, sorted; `inner`: only those between two turns that are
/// neither the first nor the last, where there are any.
pub(super) fn all(part: &Allowed, sweep: &Sweep, scallop_mm: f64, inner: bool) -> Vec<Height> {
    let n = sweep.centres.len();
    let ridges = looked_for(part, sweep, scallop_mm, MOST_RIDGES);
    let (first, last) = outer_turns(sweep);
    let inner = inner && last >= first + 3;
    let is_inner = |row: usize| !inner || (sweep.turns[row] > first && sweep.turns[row] + 1 < last);
    let counts = |row: usize| sweep.touches(row) && is_inner(row);
    let rows = (0..n).step_by(ridges.every).filter(|row| counts(*row));
    sort(parallel::filter_map(rows, |row| ridges.at(row, sweep.turns[row] + 1)))
}

/// How far apart two passes must be to leave a ridge, mm.
pub(super) fn apart_mm(radius_mm: f64, scallop_mm: f64) -> f64 {
    APART * flat_stepover(radius_mm, scallop_mm)
}

/// How ridges between the passes of a sweep are looked for.
pub(super) struct Ridges<'a> {
    pub part: &'a Allowed<'a>,
    pub sweep: &'a Sweep,
    /// Moves of a stretch: each ridge stands for one.
    pub every: usize,
    /// What is cut twice, so passes nearer to one another than this, leaves no ridge, mm.
    pub apart_mm: f64,
    /// Where a ball stays farther than this over the part, no ball reaches it, mm.
    pub slack_mm: f64,
}

impl Ridges<'_> {
    /// The ridge between the pass at `row` and the turn `other` beside it. `None` where the other
    /// turn has no pass beside this one, or no ball reaches the part under the ridge; a height of 0
    /// where the two are not apart.
    pub fn at(&self, row: usize, other: u32) -> Option<Height> {
        self.with_other(row, other).map(|(ridge, _)| ridge)
    }

    /// The same with the row that the other pass is at or behind.
    fn with_other(&self, row: usize, other: u32) -> Option<(Height, usize)> {
        self.beside(row, (self.sweep, other))
    }

    /// The same where the pass beside is that of a turn of a sweep of its own, of another ball.
    pub fn beside(&self, row: usize, (beside, other): (&Sweep, u32)) -> Option<(Height, usize)> {
        let Ridges { part, sweep, every, apart_mm, slack_mm } = *self;
        let radius = sweep.radius_mm;
        let c1 = midway(sweep, row);
        let reach = 0.95 * (radius + beside.radius_mm);
        let next = beside.nearest(&c1, reach, |i| beside.turns[i] == other && beside.turns[i + 1] == other)?;
        let (i, d) = (next.segment, next.distance_mm);
        // An end of the other turn is not its nearest pass.
        let at_start = next.t == 0.0 && beside.turns.get(i.wrapping_sub(1)) != Some(&other);
        let at_end = next.t == 1.0 && beside.turns.get(i + 2) != Some(&other);
        if at_start || at_end {
            return None;
        }
        // Where both balls meet: midway, or nearer to the smaller.
        let more = radius * radius - beside.radius_mm * beside.radius_mm;
        let share = if more == 0.0 { 0.5 } else { 0.5 + 0.5 * more / (d * d) };
        let middle = c1 + (next.centre - c1) * share;
        let e = (next.centre - c1) / d;
        let foot = part.closest(&middle, 2.0 * radius)?.point;
        // Balls of two radii that touch at one place are as far apart as these differ.
        let across_mm = if more == 0.0 { d } else { (d * d - (radius - beside.radius_mm).powi(2)).max(0.0).sqrt() };
        let weight = across_mm * stretch_mm(sweep, row, every);
        if across_mm < apart_mm {
            return Some((Height { height_mm: 0.0, point: foot, row, weight }, i));
        }
        // Of two radii the way from ball to ball may lead up or down: up is from their contacts.
        let up = match more == 0.0 {
            true => middle - foot,
            false => self.outwards(&c1)? + self.outwards(&next.centre)?,
        };
        let g = (up - e * up.dot(&e)).try_normalize(1e-9)?;
        let side = e.cross(&g);
        let circle = (radius * radius - (share * d).powi(2)).sqrt();
        if circle.is_nan() {
            return None;
        }
        let point = |angle: f64| middle - (g * angle.cos() + side * angle.sin()) * circle;
        let (height_mm, point) = lowest(part, point, radius)?;
        let under = part.closest(&point, radius)?;
        // Up to the ridge itself: the normal of a facet may point past it.
        let up_to = (point - under.point).try_normalize(1e-6).filter(|_| height_mm > 0.0);
        let entry = |of: &Sweep| up_to.and_then(|n| of.entry(&under.point, &n, REACH_STEPOVERS * d));
        let entry = match (entry(sweep), std::ptr::eq(sweep, beside)) {
            (Some(own), false) => entry(beside).map(|t| t.min(own)).or(Some(own)),
            (None, false) => entry(beside),
            (own, true) => own,
        };
        // By less than this it is the chords of the same two passes.
        let sag = match more == 0.0 {
            true => CUT * (radius - circle),
            false => CUT * across_mm * across_mm / (4.0 * (radius + beside.radius_mm)),
        };
        let (left, weight) = match entry.filter(|t| *t < height_mm - sag) {
            Some(lower) => (lower, 0.0),
            None => (height_mm, weight),
        };
        // A ridge over a corner that no ball can reach is not one of the stepover's.
        let lifted_mm = lift(part, &under.point, &under.normal, radius, slack_mm);
        (lifted_mm == 0.0).then_some((Height { height_mm: left, point, row, weight }, i))
    }

    /// The unit direction from the part to the centre of a ball beside it.
    fn outwards(&self, centre: &Point) -> Option<Vector> {
        (centre - self.part.closest(centre, f64::INFINITY)?.point).try_normalize(1e-9)
    }
}

/// A place of the pass at `row`, on the way to the next location. Shares of that way are spread
/// evenly over the rows: chords lie off the part where it is concave and in it where it is convex,
/// and at the locations alone, which on some paths stand beside one another from turn to turn,
/// nothing would be seen of that.
fn midway(sweep: &Sweep, row: usize) -> Point {
    let from = sweep.centres[row];
    let goes_on = sweep.turns.get(row + 1) == Some(&sweep.turns[row]);
    let to = sweep.centres.get(row + 1).filter(|_| goes_on).unwrap_or(&from);
    from + (to - from) * (row as f64 * GOLDEN).fract()
}

/// Half the way of the contacts from `every` moves before the row to as many after it, without
/// those that only lead to another row, mm.
pub(super) fn stretch_mm(sweep: &Sweep, row: usize, every: usize) -> f64 {
    let (from, to) = (row.saturating_sub(every), (row + every).min(sweep.centres.len() - 1));
    0.5 * (from..to).filter(|i| sweep.counts(*i)).map(|i| sweep.contact_way_mm(i)).sum::<f64>()
}

/// Lowest height of the points of a short arc about angle 0 over the part: three heights, a
/// parabola through them.
fn lowest(part: &Allowed, point: impl Fn(f64) -> Point, radius: f64) -> Option<(f64, Point)> {
    const WIDTH: f64 = 0.02;
    let height = |angle: f64| {
        let q = point(angle);
        part.closest(&q, radius).map(|c| signed(&(q - c.point), &c.normal, c.distance_mm)).map(|h| (h, q))
    };
    let (lo, at, hi) = (height(-WIDTH)?.0, height(0.0)?.0, height(WIDTH)?.0);
    let bend = lo - 2.0 * at + hi;
    let best = if bend > 1e-9 { (0.5 * (lo - hi) / bend).clamp(-2.0, 2.0) * WIDTH } else { 0.0 };
    height(best)
}

fn signed(from_foot: &Vector, normal: &Vector, distance: f64) -> f64 {
    if from_foot.dot(normal) < 0.0 { -distance } else { distance }
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used)]
    use super::*;
    use crate::geometry::exact::tests::block;
    use crate::geometry::part::Part;
    use crate::observe::Silent;
    use crate::sample;

    /// Passes of two balls over a plane, some way apart: the ridge is where both are as high.
    #[test]
    fn ridges_between_two_balls_are_those_of_the_closed_form() {
        let part = Part::from_brep(block(Vector::new(60.0, 40.0, 5.0)), 0.05, &Silent).unwrap();
        let on = Allowed::new(&part, 0.0);
        let pass = |radius_mm: f64, y: f64| {
            let centres: Vec<Point> =
                (0..9).map(|k| Point::new(10.0 + 5.0 * f64::from(k), y, 5.0 + radius_mm)).collect();
            let contacts = centres.iter().map(|c| c - Vector::z() * radius_mm).collect();
            let turns = vec![0; centres.len()];
            Sweep::of(centres, contacts, turns, radius_mm, None)
        };
        for (one, two) in [(4.0, 3.0), (3.0, 4.0), (4.0, 4.0), (2.0, 9.0)] {
            for apart in [0.3, 0.9, 1.5] {
                let (own, other) = (pass(one, 20.0), pass(two, 20.0 + apart));
                let ridges = Ridges { part: &on, sweep: &own, every: 1, apart_mm: 0.05, slack_mm: 0.001 };
                let (found, _) = ridges.beside(3, (&other, 0)).unwrap();
                // Bisection of both arcs' heights.
                let height = |r: f64, x: f64| r - (r * r - x * x).sqrt();
                let (mut lo, mut hi) = (0.0, apart);
                for _ in 0..60 {
                    let x = 0.5 * (lo + hi);
                    *(if height(one, x) < height(two, apart - x) { &mut lo } else { &mut hi }) = x;
                }
                let exact = height(one, lo);
                assert!((found.height_mm - exact).abs() < 1e-9, "{one} {two} {apart}: {} {exact}", found.height_mm);
            }
            let (own, other) = (pass(one, 20.0), pass(two, 20.02));
            let ridges = Ridges { part: &on, sweep: &own, every: 1, apart_mm: 0.05, slack_mm: 0.001 };
            assert_eq!(ridges.beside(3, (&other, 0)).unwrap().0.height_mm, 0.0);
        }
    }

    #[test]
    fn what_another_move_takes_off_is_no_ridge() {
        let (blade, path) = (sample::blade(), sample::plan(4, 180).toolpath);
        let part = Allowed::new(&blade.part, 0.0);
        let ridges_1_to_2 = |sweep: &Sweep| -> Vec<Height> {
            let rows = (0..path.locations.len()).filter(|r| sweep.turns[*r] == 1).step_by(10);
            rows.filter_map(|row| Ridges { part: &part, sweep, every: 1, apart_mm: 0.01, slack_mm: 0.0002 }.at(row, 2))
                .collect()
        };
        let heights = |ridges: &[Height]| -> Vec<f64> { ridges.iter().map(|h| h.height_mm).collect() };
        let ridges_before = ridges_1_to_2(&Sweep::new(&path));
        let before = heights(&ridges_before);
        assert!(before.len() > 10);
        // A pass midway between the two, with a number that is no neighbour's.
        let mut centres: Vec<_> = path.locations.iter().map(|l| l.centre).collect();
        let mut turns: Vec<u32> = path.locations.iter().map(|l| l.turn).collect();
        let rows = |turn: u32| path.locations.iter().filter(move |l| l.turn == turn).map(|l| l.centre);
        let middle: Vec<_> = rows(1).zip(rows(2)).map(|(a, b)| nalgebra::center(&a, &b)).collect();
        let wanted = [vec![true; centres.len() - 1], vec![false], vec![true; middle.len() - 1]].concat();
        turns.extend(middle.iter().map(|_| 50));
        centres.extend(middle);
        let ridges_after = ridges_1_to_2(&Sweep::of(centres.clone(), centres, turns, path.radius_mm, Some(wanted)));
        let after = heights(&ridges_after);
        assert_eq!(after.len(), before.len());
        // The ball of 5 mm leaves ridges of 6 µm between passes 0.5 mm apart; facets are farther
        // off the round part than that.
        let lower: Vec<f64> = before.iter().zip(&after).filter(|(b, _)| **b > 0.01).map(|(b, a)| b - a).collect();
        assert!(lower.len() > 10 && lower.iter().all(|l| (0.005..0.0075).contains(l)), "{lower:?}");
        // What is left in such places says nothing of the ridges that stand.
        let cut: Vec<&Height> =
            ridges_after.iter().zip(&before).filter(|(a, b)| a.height_mm < **b).map(|p| p.0).collect();
        assert!(cut.len() > 10 && cut.iter().all(|h| h.weight == 0.0), "{cut:?}");
        let (stood, stands) =
            [&ridges_before, &ridges_after].map(|all| all.iter().filter(|h| h.weight > 0.0).count()).into();
        assert!(stood > stands, "{stood} {stands}");
    }

    #[test]
    fn passes_that_run_into_one_another_leave_no_ridge() {
        let (blade, path) = (sample::blade(), sample::plan(4, 180).toolpath);
        let part = Allowed::new(&blade.part, 0.0);
        // Before its end turn 2 comes onto turn 1, but for a hundredth of a millimetre.
        let mut centres: Vec<_> = path.locations.iter().map(|l| l.centre).collect();
        let turns: Vec<u32> = path.locations.iter().map(|l| l.turn).collect();
        let last = |turn: u32| turns.partition_point(|t| *t <= turn) - 1;
        let (one, two) = (last(1), last(2));
        for k in 2..8 {
            centres[two - k] = centres[one - k] + Vector::new(0.01, 0.0, 0.0);
        }
        let n = centres.len();
        let sweep = Sweep::of(centres.clone(), centres, turns, path.radius_mm, Some(vec![true; n - 1]));
        let apart = apart_mm(path.radius_mm, 0.006);
        assert!((apart - 0.05 * (8.0 * path.radius_mm * 0.006).sqrt()).abs() < 1e-12);
        let height = |row, apart_mm| {
            let ridges = Ridges { part: &part, sweep: &sweep, every: 1, apart_mm, slack_mm: 0.0002 };
            ridges.at(row, 2).map(|h| h.height_mm)
        };
        assert_eq!(height(one - 5, apart), Some(0.0));
        assert!(height(one - 5, 0.001).is_some_and(|h| h != 0.0));
        assert!(height(one - 60, apart).is_some_and(|h| h > 0.0));
    }
}
