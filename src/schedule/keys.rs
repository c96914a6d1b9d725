//! The linear schedule of one stretch: few key points, placed so that their corners can be rounded
//! gently.
//!
//! The taut string has a key point at every sample that it wraps around. Of these the subsequence
//! is kept whose corners are gentlest, found by dynamic programming over the lines between two of
//! them that stay inside the walls; then each key point is moved up or down within the walls while
//! that helps.
//!
//! *Gentle*: a corner that turns the slope by Δ and may use the length `h` on either side gets a
//! curve with `|d²θ/ds²| ≈ (4/3) Δ / h`; where the wall leaves only the height ε, `h ≈ 4ε/Δ`, hence
//! `Δ²/(3ε)`. Both are exact in the limit of small symmetric corners; what counts in the end is the
//! peak of the curve itself. Costs are summed in their eighth power, which is close to the least
//! peak and still blunts the other corners.

use super::corridor::{Corridor, PathAngle, slope};
use super::taut;

/// Lines tried from each key point onwards.
const FAN: usize = 12;
/// Sweeps over all key points when they are moved, and the share of the local width by which they
/// move in the first.
const SWEEPS: usize = 14;
const FIRST_STEP: f64 = 0.25;

/// One end of a stretch.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum SpanEnd {
    /// Base point: θ and the length over which it stands still, rad and mm.
    Level(f64, f64),
    /// Outer end of the path; θ where it is given, rad.
    Free(Option<f64>),
}

impl SpanEnd {
    /// θ stands still there.
    pub fn is_level(self) -> bool {
        matches!(self, SpanEnd::Level(..))
    }
}

/// A stretch of the path, in mm from its start.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct PathSpan {
    pub from: f64,
    pub to: f64,
    pub start: SpanEnd,
    pub end: SpanEnd,
}

/// The walls of one stretch.
pub(super) struct Walls {
    /// Where the curve may be.
    pub curve: Corridor,
    /// Where the taut string may be.
    pub string: Corridor,
    /// Where the final straight lines may be.
    pub lines: Corridor,
}

/// Key points from end to end, with a level stretch at every base point.
pub(super) fn linear(walls: &Walls, stretch: &PathSpan, start: f64, end: f64) -> Vec<PathAngle> {
    let length = |e: SpanEnd| if let SpanEnd::Level(_, l) = e { l } else { 0.0 };
    let (a, b) = (stretch.from + length(stretch.start), stretch.to - length(stretch.end));
    let mut keys = Vec::new();
    if stretch.start.is_level() {
        keys.push([stretch.from, start]);
    }
    keys.extend(taut::string(&walls.string.between(a, b), start, end));
    if stretch.end.is_level() {
        keys.push([stretch.to, end]);
    }
    let mut keys = gentlest(&keys, walls, stretch);
    relax(&mut keys, walls, stretch);
    // A corner without a bend is none.
    let mut i = 1;
    while i + 1 < keys.len() {
        let (m1, m2) = (slope(keys[i - 1], keys[i]), slope(keys[i], keys[i + 1]));
        if (m2 - m1).abs() <= 1e-12 * (1.0 + m1.abs() + m2.abs()) {
            keys.remove(i);
        } else {
            i += 1;
        }
    }
    keys
}

/// Lengths of `s` that the corner at `p2` may use before and after it. Next to an end of the
/// stretch no other corner needs the other half of the segment.
pub(super) fn reaches(p: [PathAngle; 3], stretch: &PathSpan) -> [f64; 2] {
    let share = |outer: bool| if outer { 1.0 } else { 0.5 };
    [share(p[0][0] <= stretch.from) * (p[1][0] - p[0][0]), share(p[2][0] >= stretch.to) * (p[2][0] - p[1][0])]
}

/// See the module's page.
fn cost(p: [PathAngle; 3], curve: &Corridor, stretch: &PathSpan) -> f64 {
    let turn = slope(p[1], p[2]) - slope(p[0], p[1]);
    let [h1, h2] = reaches(p, stretch);
    let [lo, hi] = curve.at(p[1][0]);
    let room = if turn > 0.0 { hi - p[1][1] } else { p[1][1] - lo };
    let by_length = 4.0 / 3.0 * turn.abs() / h1.min(h2);
    let by_room = turn * turn / (3.0 * room.max(1e-12));
    by_length.max(by_room).powi(8)
}

/// A line that starts at key point `from`, with the least cost of all corners up to its start and
/// the line before it.
struct KeyLine {
    from: usize,
    cost: f64,
    before: Option<usize>,
}

/// The gentlest subsequence of the key points; the ends of level stretches stay.
fn gentlest(keys: &[PathAngle], walls: &Walls, stretch: &PathSpan) -> Vec<PathAngle> {
    let n = keys.len();
    let level = [stretch.start.is_level(), stretch.end.is_level()];
    if n < 3 {
        return keys.to_vec();
    }
    let mut lines: Vec<KeyLine> = Vec::new();
    let mut into: Vec<Vec<usize>> = vec![Vec::new(); n];
    for from in 0..n - 1 {
        let targets = if from == 0 && level[0] { vec![1] } else { visible(keys, from, &walls.lines, level[1]) };
        for to in targets {
            let mut best = (if from == 0 { 0.0 } else { f64::INFINITY }, None);
            for &k in &into[from] {
                let c = lines[k].cost + cost([keys[lines[k].from], keys[from], keys[to]], &walls.curve, stretch);
                if c < best.0 || best.1.is_none() && from > 0 {
                    best = (c, Some(k));
                }
            }
            if from == 0 || best.1.is_some() {
                into[to].push(lines.len());
                lines.push(KeyLine { from, cost: best.0, before: best.1 });
            }
        }
    }
    let mut at = into[n - 1].iter().copied().min_by(|a, b| lines[*a].cost.total_cmp(&lines[*b].cost));
    let mut out = vec![keys[n - 1]];
    while let Some(k) = at {
        out.push(keys[lines[k].from]);
        at = lines[k].before;
    }
    out.reverse();
    if out.first() == keys.first() { out } else { keys.to_vec() }
}

/// Key points after `from` to which the straight line stays inside the walls: the next one, and a
/// fan of at most [`FAN`] up to the farthest, about evenly spread. With a level end the last is
/// reached only from the one before.
fn visible(keys: &[PathAngle], from: usize, lines: &Corridor, level_end: bool) -> Vec<usize> {
    let n = keys.len();
    let last = if level_end && from + 2 < n { n - 2 } else { n - 1 };
    let mut seen = vec![from + 1];
    let (mut low, mut high) = (f64::NEG_INFINITY, f64::INFINITY);
    let mut i = lines.inside(keys[from][0], keys[from][0]).start;
    for to in from + 1..=last {
        while i < lines.s.len() && lines.s[i] <= keys[to][0] {
            let s = lines.s[i];
            low = low.max(slope(keys[from], [s, lines.lo[i]]));
            high = high.min(slope(keys[from], [s, lines.hi[i]]));
            i += 1;
        }
        if low > high {
            break;
        }
        let m = slope(keys[from], keys[to]);
        if to > from + 1 && m >= low && m <= high {
            seen.push(to);
        }
    }
    if seen.len() <= FAN {
        return seen;
    }
    let s = |k: usize| keys[seen[k]][0];
    let (first, far) = (s(0), s(seen.len() - 1));
    let mut picked: Vec<usize> = (0..FAN)
        .map(|f| {
            let want = first + (far - first) * f as f64 / (FAN - 1) as f64;
            seen[seen.partition_point(|k| keys[*k][0] < want).min(seen.len() - 1)]
        })
        .collect();
    picked.dedup();
    picked
}

/// Moves each inner key point up or down while the corners around it become gentler and its lines
/// stay inside.
fn relax(keys: &mut [PathAngle], walls: &Walls, stretch: &PathSpan) {
    let fixed = |e: SpanEnd| if e.is_level() { 2 } else { 1 };
    let (first, last) = (fixed(stretch.start), fixed(stretch.end));
    let n = keys.len();
    let around = |keys: &[PathAngle], i: usize| -> f64 {
        (i.saturating_sub(1).max(1)..=(i + 1).min(n - 2))
            .map(|k| cost([keys[k - 1], keys[k], keys[k + 1]], &walls.curve, stretch))
            .sum()
    };
    let mut step = FIRST_STEP;
    for _ in 0..SWEEPS {
        let mut moved = false;
        for i in first..n.saturating_sub(last) {
            let [lo, hi] = walls.curve.at(keys[i][0]);
            let (here, now) = (keys[i], around(keys, i));
            for sign in [1.0, -1.0] {
                let theta = here[1] + sign * step * (hi - lo);
                if theta < keys[i - 1][1] || theta > keys[i + 1][1] {
                    continue;
                }
                keys[i][1] = theta;
                if around(keys, i) < now
                    && fits(&walls.lines, keys[i - 1], keys[i])
                    && fits(&walls.lines, keys[i], keys[i + 1])
                {
                    moved = true;
                    break;
                }
                keys[i] = here;
            }
        }
        if !moved {
            step *= 0.5;
        }
    }
}

/// The straight line from `p` to `q` is inside the walls (up to the rounding of a line along a
/// wall).
fn fits(lines: &Corridor, p: PathAngle, q: PathAngle) -> bool {
    let [below, above] = lines.room(p, q);
    below >= -1e-12 && above >= -1e-12
}
