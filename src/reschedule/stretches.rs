//! The cutting stretches of a program: where one ball runs along the part.

use super::Program;
use crate::artifact::{Cone, Cones, Stand};
use crate::geometry::measured::Closest;
use crate::geometry::part::Part;
use crate::parallel;
use crate::read::program::{Block, Interpolation, Moved};

/// Nearer to the part than this the stock is looked for, mm.
const STOCK_MM: f64 = 5.0;
/// Lines on which the lean differs by less are lines of one lean, rad: the words' rounding.
const SAME_LEAN_RAD: f64 = 0.02 * std::f64::consts::PI / 180.0;
/// A pass ends where the ball turns back by more than this, rad.
const BACK_RAD: f64 = 2.0 * std::f64::consts::FRAC_PI_3;
/// Ball centres nearer than this are one place, mm; θ that differs by more turns, rad.
const SAME_MM: f64 = 1e-6;
const TURNED_RAD: f64 = 1e-6;
/// A stretch has at least so many places.
pub(super) const FEWEST: usize = 8;

/// Where a line of the program ends.
#[derive(Clone, Debug)]
pub(super) struct LineEnd {
    /// Index of its block.
    pub block: usize,
    /// Index of the block's last move.
    pub moved: usize,
    /// Time from the place before, s; `None`: rapid.
    pub seconds: Option<f64>,
    /// Ball centre, θ over all turns and lean about the blade axis.
    pub stand: Stand,
    /// What the ball touches.
    pub at: Option<Closest>,
    /// Why the line cannot be one of a stretch; `None`: it can.
    pub barred: Option<&'static str>,
}

/// Places that follow one another; between them the ball cuts.
#[derive(Clone, Debug)]
pub(super) struct Found {
    /// The first place is where the first line of the stretch begins.
    pub places: Vec<LineEnd>,
    pub cones: Cones,
}

/// All lines of the program whose end is known.
pub(super) fn places(program: &Program, part: &Part) -> Vec<LineEnd> {
    let (tool, machine) = (program.bench.tool, program.bench.machine);
    let mut out: Vec<LineEnd> = Vec::new();
    let mut moves = program.moves.iter().enumerate().peekable();
    while let Some((first, m)) = moves.next() {
        let (mut last, mut seconds) = (first, m.seconds);
        let mut known = m.known();
        while let Some((k, next)) = moves.next_if(|(_, next)| next.block == m.block) {
            known &= next.known();
            seconds = seconds.zip(next.seconds).map(|(a, b)| a + b);
            last = k;
        }
        let Some((block, end)) = program.blocks().get(m.block).zip(program.moves.get(last)) else { continue };
        if !end.to.iter().all(|v| v.is_finite()) {
            continue;
        }
        let near = out.last().map_or(0.0, |p| p.stand.theta);
        let [theta, lean] = machine.theta_and_lean(&end.to, near);
        let stand = Stand::about_blade(end.pose(1.0, tool, machine).centre, theta, lean);
        let barred = barred(block, &program.moves[first..=last], known);
        out.push(LineEnd { block: m.block, moved: last, seconds, stand, at: None, barred });
    }
    let reach = tool.radius_mm + STOCK_MM;
    parallel::map(&mut out, |p| p.at = part.closest(&p.stand.centre, reach));
    out
}

/// Why a line is left as it is.
fn barred(block: &Block, moves: &[Moved], known: bool) -> Option<&'static str> {
    if !known {
        return Some("nobody knows where it begins");
    }
    if moves.iter().any(|m| m.seconds.is_none()) {
        return Some("it is a rapid");
    }
    if !matches!(block.course, Interpolation::Straight) {
        return Some("it is an arc or a polynomial");
    }
    block.machine.then_some("it is in positions of the machine's axes beside the program's zero")
}

/// The stock that most lines leave, mm: the middle of the narrowest range of distances that holds
/// half of all that are near the part; 0 where that is contact itself.
pub(super) fn stock_mm(places: &[LineEnd], radius_mm: f64, within_mm: f64) -> f64 {
    let cut = places.iter().filter(|p| p.barred.is_none());
    let mut left: Vec<f64> = cut.filter_map(|p| p.at.as_ref()).map(|c| c.distance_mm - radius_mm).collect();
    left.sort_by(f64::total_cmp);
    let half = left.len() / 2;
    let narrowest = left.windows(half + 1).min_by(|a, b| (a[half] - a[0]).total_cmp(&(b[half] - b[0])));
    narrowest.map(|w| 0.5 * (w[0] + w[half])).filter(|stock| stock.abs() > 0.5 * within_mm).unwrap_or(0.0)
}

/// The stretches, in the order of the program. A stretch ends where the ball leaves the part by
/// more than `within_mm`, where a line cannot be one of it, where θ turns while the ball stands,
/// and where a pass turns back.
pub(super) fn find(places: &[LineEnd], stock_mm: f64, radius_mm: f64, within_mm: f64) -> Vec<Found> {
    let touches =
        |p: &LineEnd| p.at.as_ref().is_some_and(|c| (c.distance_mm - radius_mm - stock_mm).abs() <= within_mm);
    let mut out = Vec::new();
    let mut open: Vec<LineEnd> = Vec::new();
    for w in places.windows(2) {
        let (from, to) = (&w[0], &w[1]);
        let goes = (to.stand.centre - from.stand.centre).norm() > SAME_MM;
        let turns = (to.stand.theta - from.stand.theta).abs() > TURNED_RAD;
        if !goes && !turns && !open.is_empty() && to.barred.is_none() {
            continue;
        }
        if to.barred.is_some() || !goes || !touches(to) {
            out.push(std::mem::take(&mut open));
            continue;
        }
        if open.is_empty() {
            if !touches(from) {
                continue;
            }
            open.push(from.clone());
        }
        open.push(to.clone());
    }
    out.push(open);
    let passes = out.into_iter().filter(|p| !p.is_empty()).flat_map(|p| passes(p, radius_mm));
    passes.filter(|p| p.len() >= FEWEST).map(|places| Found { cones: cones(&places), places }).collect()
}

/// Cut where the ball turns back: where the chords of a length before and behind a place point
/// against one another. Round an edge of the part a ball's centre has at least its own radius to
/// turn on, so that with chords as long as that they do not.
fn passes(places: Vec<LineEnd>, chord_mm: f64) -> Vec<Vec<LineEnd>> {
    let centre = |k: usize| places[k].stand.centre;
    let mut s = vec![0.0f64; places.len()];
    (1..places.len()).for_each(|k| s[k] = s[k - 1] + (centre(k) - centre(k - 1)).norm());
    let (mut behind, mut ahead) = (0, 0);
    // Places at which it turns back, in runs of neighbours: of each the one with the sharpest bend.
    let mut cuts: Vec<usize> = Vec::new();
    let mut run: Option<(usize, f64)> = None;
    for k in 0..places.len() {
        while behind + 1 < k && s[k] - s[behind + 1] >= chord_mm {
            behind += 1;
        }
        ahead = ahead.max(k);
        while ahead + 1 < places.len() && s[ahead] - s[k] < chord_mm {
            ahead += 1;
        }
        let (from, to) = (centre(k) - centre(behind), centre(ahead) - centre(k));
        let is_long = (s[k] - s[behind]).min(s[ahead] - s[k]) >= 0.3 * chord_mm;
        if is_long && from.angle(&to) > BACK_RAD {
            let bend = (centre(k) - centre(k - 1)).angle(&(centre(k + 1) - centre(k)));
            run = Some(run.filter(|(_, most)| *most >= bend).unwrap_or((k, bend)));
        } else if let Some((at, _)) = run.take() {
            cuts.push(at);
        }
    }
    cuts.extend(run.map(|(at, _)| at));
    cuts.push(places.len().saturating_sub(1));
    let mut from = 0;
    let mut out = Vec::new();
    for cut in cuts {
        out.push(places.get(from..=cut).unwrap_or_default().to_vec());
        from = cut;
    }
    out
}

/// The lean of the program, evened where only the rounding of its words makes it differ.
fn cones(places: &[LineEnd]) -> Cones {
    let leans: Vec<f64> = places.iter().map(|p| p.stand.cone.lean_rad).collect();
    let (least, most) = leans.iter().fold((f64::MAX, f64::MIN), |(a, b), v| (a.min(*v), b.max(*v)));
    if most - least <= SAME_LEAN_RAD {
        return Cones::about_blade(0.5 * (least + most));
    }
    Cones::along(leans.into_iter().map(Cone::about_blade).collect())
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used)]
    use super::*;
    use crate::geometry::Point;

    fn at(deg: f64) -> LineEnd {
        let (s, c) = deg.to_radians().sin_cos();
        let stand = Stand::about_blade(Point::new(0.0, 10.0 * c, 10.0 * s), 0.0, 0.0);
        LineEnd { block: 0, moved: 0, seconds: Some(0.1), stand, at: None, barred: None }
    }

    fn lengths(degrees: impl IntoIterator<Item = f64>) -> Vec<usize> {
        passes(degrees.into_iter().map(at).collect(), 3.0).iter().map(Vec::len).collect()
    }

    #[test]
    fn passes_end_where_the_ball_turns_back() {
        let up = || (0..=40).map(|k| f64::from(k) * 2.0);
        assert_eq!(lengths(up()), [41]);
        assert_eq!(lengths(up().map(|v| -v)), [41]);
        // Three passes share the places where they turn.
        let down = up().rev().skip(1);
        assert_eq!(lengths(up().chain(down).chain(up().skip(1))), [41, 41, 41]);
        // Two turns of a helix, wherever its axis is.
        assert_eq!(lengths((0..=100).map(|k| f64::from(k) * 7.2)), [101]);
        // A dent of four degrees is no pass.
        assert_eq!(lengths([0.0, 10.0, 20.0, 18.0, 16.0, 20.0, 30.0]), [7]);
        assert_eq!(lengths([0.0]), [1]);
    }
}
