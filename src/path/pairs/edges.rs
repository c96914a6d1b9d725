//! Rows round both edges: one tool goes round one edge while the other goes round the other.
//!
//! Rows of opposite places end where nothing is opposite. What is left of the airfoil at each
//! height is two strips of its contour, each round an edge, from the outermost row of one side to
//! that of the other. Tool 1 goes over the strip beyond the first row, from its own side to tool
//! 2's, and tool 2 over the strip beyond the last row, from its own side to tool 1's. Seen from the
//! tip both go clockwise, and both normals turn by about as much: so the table turns for both.
//!
//! Where a row stands on its strip is a share `F` of the way over it, the same for both strips: the
//! mean of the share of the stepovers and the share of the turning of the normal. Between two
//! places of a contour a ball of radius R leaves `√(c C / 8Rh)` stepovers of scallop h, where c is
//! the way of the contact and C that of the centre: to first order, on any curvature, and none
//! where the ball turns about a sharp edge. All heights have the same number of rows, of which each
//! is as far from the next as the closer of both strips asks for, and ridges are measured.

use std::ops::Range;

use super::super::ring::{self, Ring, Tracing, wrap};
use super::fill;
use super::sheet::{RowCurves, Sheet, Standing};
use super::{MOST_ROWS, no_pairs};
use crate::error::{Result, Stage};
use crate::geometry::Point;
use crate::geometry::triangle::share_of_segment;
use crate::numerics::runs::longest;
use crate::observe::Observer;
use crate::parallel;
use crate::tool::stepover::flat_stepover_mm;

/// Borders of strips bend by at most so much, over one by the radius of the ball.
const BEND: f64 = 0.5;
/// Contours are traced in steps of at most this share of the radius …
const STEP: f64 = 0.1;
/// … and this turn of the normal, rad.
const TURN_RAD: f64 = 0.03;
/// Rows are measured and laid anew so many times …
const CORRECTIONS: usize = 3;
/// … and then one by one closer, so many trials in all.
const TRIALS: usize = 12;
/// The share of the scallop that rows aim at; chords and places between heights take the rest.
const AIM: f64 = 0.98;
/// The number of stepovers between two rows is corrected by no more than this factor at a time, or
/// its inverse.
const MOST_CORRECTION: f64 = 1.5;
/// A correction is the greatest of so many heights to either side …
const BESIDE: usize = 4;
/// … evened so many times with the heights beside it.
const MEAN: usize = 12;
/// Rows are low enough where this share of their ridges is no higher than the scallop …
const LOW: f64 = 0.99;
/// … and none by more than this factor.
const MOST_OVER: f64 = 1.15;
/// A height is taken in where this share of what its rows would go over is needed there.
const WORTH: f64 = 1.0 / 3.0;
/// So many ranges of heights are looked at: those whose strips have at most so many stepovers, each
/// time by this factor fewer.
const RANGES: i32 = 32;
const FEWER: f64 = 0.93;
/// A strip over fewer heights is left.
const LEAST_HEIGHTS: usize = 4;

/// The contour at a height as the balls of both tools see it, counter-clockwise seen from the tip
/// from the first row's place on, with the borders of the rows on it.
struct Contour {
    /// Rings of either radius, from the first row's place on tool 1's side.
    rings: [Ring; 2],
    /// Way on either ring from its start to the first row's place on the other side, mm.
    other_mm: [f64; 2],
    /// Ways from the first row's places to those of the outermost row towards an edge, on tool 1's
    /// side and on the other, mm: of the first row on the ring of tool 1, of the last on that of
    /// tool 2.
    own_mm: [[f64; 2]; 2],
}

impl Contour {
    /// That at a height; `None` where there is no row, or the contour cannot be followed.
    fn of(sheet: &Sheet, rows: &Rows, x_mm: f64) -> Option<Self> {
        let mut rings = Vec::with_capacity(2);
        for level in &sheet.levels {
            let first = rows.at(rows.first, (0, level.radius_mm), x_mm)?;
            let seed = level.touch_in_plane(&first, 0.5 * level.radius_mm)?;
            let how = Tracing {
                max_step_mm: STEP * level.radius_mm,
                max_turn_rad: TURN_RAD,
                min_step_mm: 1e-3 * level.radius_mm,
                min_cos_lean: 0.1,
            };
            rings.push(ring::trace(level, seed, &how).ok()?);
            if sheet.options.radius_mm[0] == sheet.options.radius_mm[1] {
                rings.push(rings[0].clone());
                break;
            }
        }
        let rings: [Ring; 2] = rings.try_into().ok()?;
        let place = |j: usize, q: Option<Point>| Some(place_on(&rings[j], &q?));
        let ball = |j: usize, side: usize| (side, sheet.levels[j].radius_mm);
        let first = |j: usize| place(j, rows.at(rows.first, ball(j, 1), x_mm));
        let other_mm = [first(0)?, first(1)?];
        let outer = |j: usize, side: usize| place(j, rows.outermost(j, ball(j, side), x_mm));
        let (one, two) = ([outer(0, 0)?, outer(0, 1)?], [outer(1, 0)?, outer(1, 1)?]);
        // A row that is the first one itself lies at the start of the ring or at its end.
        let clockwise = if one[0] > other_mm[0] { rings[0].length_mm - one[0] } else { 0.0 };
        let counter = if two[0] < other_mm[1] { two[0] } else { 0.0 };
        let own_mm = [[clockwise, one[1] - other_mm[0]], [counter, other_mm[1] - two[1]]];
        Some(Contour { own_mm, rings, other_mm })
    }

    /// Both strips between borders that are so far from the first row's places, mm.
    fn strips(&self, sheet: &Sheet, [one, two]: [[f64; 2]; 2]) -> Together {
        let ends = [[self.rings[0].length_mm - one[0], self.other_mm[0] + one[1]], [self.other_mm[1] - two[1], two[0]]];
        let scallop_mm = AIM * sheet.options.settings.scallop_mm;
        let strip =
            |j: usize| Strip::of(&self.rings[j], ends[j], flat_stepover_mm(sheet.levels[j].radius_mm, scallop_mm));
        Together::of(&[strip(0), strip(1)])
    }
}

/// Rows of opposite places, side by side, each in pieces.
struct Rows<'a> {
    rows: &'a [Vec<Vec<Standing>>],
    /// The one from which the others were laid.
    first: usize,
}

impl Rows<'_> {
    /// Where a row passes a height: the centre of a ball of a radius, mm, that touches where the
    /// tool of a side does.
    fn at(&self, row: usize, (side, radius_mm): (usize, f64), x_mm: f64) -> Option<Point> {
        let centre = |s: &Standing| s.touches[side].contact + s.touches[side].normal * radius_mm;
        let moves = self.rows[row].iter().flat_map(|piece| piece.windows(2));
        let mut ends = moves.map(|w| [centre(&w[0]), centre(&w[1])]);
        let [a, b] = ends.find(|[a, b]| (a.x - x_mm) * (b.x - x_mm) <= 0.0)?;
        let share = if a.x == b.x { 0.0 } else { (x_mm - a.x) / (b.x - a.x) };
        Some(Point::new(x_mm, a.y + (b.y - a.y) * share, a.z + (b.z - a.z) * share))
    }

    /// The same of the first row (edge 0) or the last (edge 1) that passes the height.
    fn outermost(&self, edge: usize, ball: (usize, f64), x_mm: f64) -> Option<Point> {
        let n = self.rows.len();
        (0..n).find_map(|k| self.at(if edge == 0 { k } else { n - 1 - k }, ball, x_mm))
    }
}

/// Way along a ring to its nearest place, mm.
fn place_on(ring: &Ring, q: &Point) -> f64 {
    let n = ring.touches.len();
    let one = |i: usize| {
        let (a, b) = (ring.touches[i].centre, ring.touches[(i + 1) % n].centre);
        let t = share_of_segment(&a, &b, q);
        ((a + (b - a) * t - q).norm_squared(), ring.s_mm[i] + t * (b - a).norm())
    };
    (0..n).map(one).min_by(|a, b| a.0.total_cmp(&b.0)).map_or(0.0, |(_, s)| s)
}

/// A strip of a contour, clockwise: knots of the way from its beginning, mm, the stepovers and the
/// turn of the normal up to there, rad.
struct Strip {
    from_mm: f64,
    knots: Vec<[f64; 3]>,
}

impl Strip {
    /// That from one place of a ring to another before it.
    fn of(ring: &Ring, [from_mm, to_mm]: [f64; 2], stepover_mm: f64) -> Self {
        let n = ring.touches.len();
        let mut knots: Vec<[f64; 3]> = Vec::new();
        let (mut steps, mut turn) = (0.0, 0.0);
        // Counter-clockwise, then turned round.
        for i in 0..n {
            let (a, b) = (&ring.touches[i], &ring.touches[(i + 1) % n]);
            let way = (b.centre - a.centre).norm();
            let [low, high] = [ring.s_mm[i].max(to_mm), (ring.s_mm[i] + way).min(from_mm)];
            if !(high > low) {
                continue;
            }
            if knots.is_empty() {
                knots.push([low, 0.0, 0.0]);
            }
            let share = (high - low) / way;
            steps += share * ((b.contact - a.contact).norm() * way).sqrt() / stepover_mm;
            turn += share * wrap(b.azimuth(&ring.along) - a.azimuth(&ring.along)).abs();
            knots.push([high, steps, turn]);
        }
        // Rows that run into one another leave no strip.
        if knots.is_empty() {
            knots.push([0.0; 3]);
        }
        let end = knots.last().copied().unwrap_or_default();
        let knots = knots.iter().rev().map(|k| [end[0] - k[0], end[1] - k[1], end[2] - k[2]]).collect();
        Strip { from_mm, knots }
    }

    /// Shares of the way over it at its knots.
    fn shares(&self) -> Vec<f64> {
        let [_, steps, turn] = self.knots.last().copied().unwrap_or_default();
        let of = |v: f64, all: f64| if all > 0.0 { v / all } else { 0.0 };
        self.knots.iter().map(|k| 0.5 * (of(k[1], steps) + of(k[2], turn))).collect()
    }
}

/// A value between the knots of a rising list.
fn between(rising: &[f64], of: impl Fn(usize) -> f64, at: f64) -> f64 {
    let k = rising.partition_point(|v| *v < at).clamp(1, rising.len().max(2) - 1);
    let (Some(a), Some(b)) = (rising.get(k - 1), rising.get(k)) else { return of(0) };
    let share = if b > a { ((at - a) / (b - a)).clamp(0.0, 1.0) } else { 0.0 };
    of(k - 1) + (of(k) - of(k - 1)) * share
}

/// Both strips of a height: shares of the way over them, rising, with the places on both rings, mm,
/// and the stepovers up to there of the strip that has more of them.
struct Together {
    places_mm: Vec<[f64; 2]>,
    steps: Vec<f64>,
}

impl Together {
    fn of(strips: &[Strip; 2]) -> Self {
        let shares = strips.each_ref().map(Strip::shares);
        let mut all: Vec<f64> = shares.concat();
        all.sort_by(f64::total_cmp);
        all.dedup();
        let value = |j: usize, column: usize, at: f64| between(&shares[j], |k| strips[j].knots[k][column], at);
        let (mut places_mm, mut steps) = (Vec::with_capacity(all.len()), Vec::with_capacity(all.len()));
        let (mut sum, mut before) = (0.0, [0.0; 2]);
        for at in all {
            let here = [0, 1].map(|j| value(j, 1, at));
            sum += (here[0] - before[0]).max(here[1] - before[1]);
            before = here;
            steps.push(sum);
            places_mm.push([0, 1].map(|j| strips[j].from_mm - value(j, 0, at)));
        }
        Together { places_mm, steps }
    }

    /// All stepovers.
    fn all(&self) -> f64 {
        self.steps.last().copied().unwrap_or(0.0)
    }

    /// Places on both rings, mm, of both borders and rows with so many gaps between them.
    fn rows(&self, gaps: usize) -> Vec<[f64; 2]> {
        let at = |n: usize| {
            let step = self.all() * n as f64 / gaps as f64;
            [0, 1].map(|j| between(&self.steps, |k| self.places_mm[k][j], step))
        };
        (0..=gaps).map(at).collect()
    }
}

/// A curve at most as high as the values and those beside them, since a row ends between two
/// heights, that bends by no more than `bend`, 1/mm, to either side: the least parabolas that open
/// upwards over each value, and under these the highest that open downwards and are twice as
/// narrow (the regularisation of Lasry and Lions, Israel Journal of Mathematics 55, 1986, 257).
pub(super) fn smooth_under(values: &[f64], x_mm: &[f64], bend: f64) -> Vec<f64> {
    let beside = |k: usize| values[k.saturating_sub(1)..(k + 2).min(values.len())].iter().copied();
    let least: Vec<f64> = (0..values.len()).map(|k| beside(k).fold(f64::INFINITY, f64::min)).collect();
    let (lo, hi) = least.iter().fold((f64::INFINITY, f64::NEG_INFINITY), |(lo, hi), v| (lo.min(*v), hi.max(*v)));
    // Farther off a parabola is beyond all values.
    let reach_mm = (4.0 * (hi - lo).max(0.0) / bend).sqrt();
    let near = |k: usize| {
        let below = (0..k).rev().take_while(move |j| (x_mm[*j] - x_mm[k]).abs() <= reach_mm);
        let above = (k..x_mm.len()).take_while(move |j| (x_mm[*j] - x_mm[k]).abs() <= reach_mm);
        below.chain(above)
    };
    let off = |j: usize, k: usize, bend: f64| 0.5 * bend * (x_mm[j] - x_mm[k]).powi(2);
    let under = |k: usize| near(k).map(|j| least[j] + off(j, k, 0.5 * bend)).fold(f64::INFINITY, f64::min);
    let under: Vec<f64> = (0..least.len()).map(under).collect();
    let over = |k: usize| near(k).map(|j| under[j] - off(j, k, bend)).fold(f64::NEG_INFINITY, f64::max);
    (0..under.len()).map(over).collect()
}

/// Rows round both edges.
pub(super) struct EdgeRows {
    /// The rows, with the places between heights.
    pub rows: Vec<Vec<Standing>>,
    /// Heights between which they run, mm.
    pub heights_mm: [f64; 2],
    /// Greatest ridge of either tool between two of them and beside the border, mm.
    pub greatest_mm: [f64; 2],
}

/// The rows round both edges at some of the heights, beside rows that were laid from the `first` of
/// them on and are side by side; `None` where no strip is worth a row.
///
/// # Errors
/// Kind `Infeasible` for more rows than can be meant; kind `Cancelled`.
pub(super) fn rows(
    sheet: &Sheet,
    (rows, first): (&[Vec<Vec<Standing>>], usize),
    heights_mm: &[f64],
    observer: &dyn Observer,
) -> Result<Option<EdgeRows>> {
    observer.check(Stage::Path)?;
    let rows = Rows { rows, first };
    let contours: Vec<Option<Contour>> = parallel::map(heights_mm, |x_mm| Contour::of(sheet, &rows, *x_mm));
    let run = longest(&contours.iter().map(Option::is_some).collect::<Vec<_>>());
    let contours: Vec<Contour> = contours.into_iter().skip(run.start).take(run.len()).flatten().collect();
    let Some((heights, mut strips)) = chosen(sheet, &contours) else { return Ok(None) };
    let contours = &contours[heights];
    let scallop_mm = sheet.options.settings.scallop_mm;
    let (mut best, mut more): (Option<Laid>, usize) = (None, 0);
    for trial in 0..TRIALS {
        observer.check(Stage::Path)?;
        let most = strips.iter().map(Together::all).fold(0.0, f64::max);
        // Of one gap there is no row: the border's rows leave nothing.
        let gaps = (most - 1e-6).ceil().max(1.0) as usize + more;
        if gaps > MOST_ROWS {
            return Err(no_pairs(
                format!("more than {MOST_ROWS} rows would be needed round the edges"),
                "allow a larger scallop, or leave pinch.edges out",
            ));
        }
        let Some(laid) = Laid::of(sheet, contours, &strips, gaps) else { break };
        let is_low = laid.is_low(scallop_mm);
        if trial < CORRECTIONS {
            laid.correct(&mut strips, AIM * scallop_mm);
        } else {
            more += 1;
        }
        // Of those that are low enough the one of fewest rows, else the lowest.
        let rank = |laid: &Laid| match laid.is_low(scallop_mm) {
            true => (false, laid.rows.len() as f64),
            false => (true, laid.greatest()),
        };
        if best.as_ref().is_none_or(|b| rank(&laid) < rank(b)) {
            best = Some(laid);
        }
        if is_low && trial >= CORRECTIONS {
            break;
        }
    }
    let Some(laid) = best else { return Ok(None) };
    let inner = laid.rows.get(1..laid.rows.len() - 1).unwrap_or_default();
    // Beside a gap of these rows there is no row of opposite places: the longest piece is kept.
    let rows = parallel::try_map(inner, |row| {
        observer.check(Stage::Path)?;
        Ok(fill::round_edges(sheet, row).into_iter().max_by_key(Vec::len).unwrap_or_default())
    })?;
    let rows = rows.into_iter().filter(|row| row.len() > 1).collect();
    let ends = [contours.last(), contours.first()].map(|c| c.map_or(f64::NAN, |c| c.rings[0].x_mm));
    Ok(Some(EdgeRows { rows, heights_mm: ends, greatest_mm: laid.greatest_mm }))
}

/// The heights whose strips are worth it, with both strips at each.
fn chosen(sheet: &Sheet, contours: &[Contour]) -> Option<(Range<usize>, Vec<Together>)> {
    let own: Vec<f64> = parallel::map(contours, |c| c.strips(sheet, c.own_mm).all());
    let most = own.iter().copied().fold(0.0, f64::max);
    let within = |n: i32| longest(&own.iter().map(|steps| *steps <= most * FEWER.powi(n)).collect::<Vec<_>>());
    let mut ranges: Vec<Range<usize>> = (0..RANGES).map(within).collect();
    ranges.dedup();
    let of = |heights: Range<usize>| {
        let x_mm: Vec<f64> = contours[heights.clone()].iter().map(|c| c.rings[0].x_mm).collect();
        let border = |j: usize, side: usize| {
            let own: Vec<f64> = contours[heights.clone()].iter().map(|c| c.own_mm[j][side]).collect();
            smooth_under(&own, &x_mm, BEND / sheet.levels[j].radius_mm)
        };
        let borders = [0, 1].map(|j| [0, 1].map(|side| border(j, side)));
        let strip = |n: usize| {
            contours[heights.start + n].strips(sheet, [0, 1].map(|j| [0, 1].map(|side| borders[j][side][n])))
        };
        let strips: Vec<Together> = parallel::map(0..heights.len(), strip);
        let rows = strips.iter().map(Together::all).fold(0.0, f64::max).ceil();
        let needed: f64 = own[heights.clone()].iter().sum();
        (needed - WORTH * rows * heights.len() as f64, heights, strips)
    };
    let all = ranges.into_iter().filter(|heights| heights.len() >= LEAST_HEIGHTS).map(of);
    all.max_by(|a, b| a.0.total_cmp(&b.0)).map(|(_, heights, strips)| (heights, strips))
}

/// Rows at the heights of the grid, both borders among them, with the ridges from each to the next.
struct Laid {
    rows: Vec<Vec<Option<Standing>>>,
    /// By gap and height, mm: of tool 1 and tool 2.
    ridges_mm: Vec<Vec<[f64; 2]>>,
    greatest_mm: [f64; 2],
}

impl Laid {
    /// `None` where a ball finds no place.
    fn of(sheet: &Sheet, contours: &[Contour], strips: &[Together], gaps: usize) -> Option<Self> {
        let mut places: Vec<Vec<[f64; 2]>> = strips.iter().map(|strip| strip.rows(gaps)).collect();
        // From the first row's places on, which go on smoothly from height to height.
        let length = |k: usize| contours[k].rings[0].length_mm;
        places.iter_mut().enumerate().for_each(|(k, row)| row.iter_mut().for_each(|p| p[0] -= length(k)));
        let mut places = evened(&evened(&places));
        places.iter_mut().enumerate().for_each(|(k, row)| row.iter_mut().for_each(|p| p[0] += length(k)));
        let stand = |k: usize, n: usize| {
            let touch = |j: usize| {
                let (ring, level) = (&contours[k].rings[j], &sheet.levels[j]);
                level.touch_in_plane(&ring.at(places[k][n][j] / ring.length_mm), STEP * level.radius_mm)
            };
            Some(Standing::round_edges([touch(0)?, touch(1)?], sheet.options.settings.stock_mm))
        };
        let row = |n: usize| (0..contours.len()).map(|k| stand(k, n).map(Some)).collect::<Option<Vec<_>>>();
        let rows: Vec<Vec<Option<Standing>>> = parallel::map(0..=gaps, row).into_iter().collect::<Option<Vec<_>>>()?;
        let ridges = |n: usize| -> Vec<[f64; 2]> {
            let curves = RowCurves::of(&rows[n]);
            let at =
                |(k, s): (usize, &Option<Standing>)| s.as_ref().map_or([0.0; 2], |s| sheet.ridges_mm(&curves, k, s));
            rows[n + 1].iter().enumerate().map(at).collect()
        };
        let ridges_mm: Vec<Vec<[f64; 2]>> = parallel::map(0..gaps, ridges);
        let most = |j: usize| ridges_mm.iter().flatten().map(|r| r[j]).filter(|r| r.is_finite()).fold(0.0, f64::max);
        Some(Laid { greatest_mm: [most(0), most(1)], rows, ridges_mm })
    }

    fn greatest(&self) -> f64 {
        self.greatest_mm[0].max(self.greatest_mm[1])
    }

    fn is_low(&self, scallop_mm: f64) -> bool {
        let all = self.ridges_mm.iter().flatten().flatten().filter(|r| r.is_finite());
        let high = all.clone().filter(|r| **r > scallop_mm).count();
        self.greatest() <= MOST_OVER * scallop_mm && high as f64 <= (1.0 - LOW) * all.count() as f64
    }

    /// Makes the stepovers those that were measured: the most of heights beside one another, even.
    /// Ridges grow as their square.
    fn correct(&self, strips: &mut [Together], aim_mm: f64) {
        let gaps = self.ridges_mm.len();
        let counted: Vec<f64> = strips.iter().map(|strip| strip.all() / gaps as f64).collect();
        let measured = |k: usize, n: usize| {
            let [one, two] = self.ridges_mm[n][k];
            let ridge_mm = if one.max(two).is_finite() { one.max(two) } else { aim_mm };
            let steps = (ridge_mm / aim_mm).max(0.0).sqrt();
            steps.max(counted[k] / MOST_CORRECTION).min(counted[k] * MOST_CORRECTION)
        };
        let own: Vec<Vec<f64>> = (0..strips.len()).map(|k| (0..gaps).map(|n| measured(k, n)).collect()).collect();
        let most = |k: usize, n: usize| {
            let beside = &own[k.saturating_sub(BESIDE)..(k + BESIDE + 1).min(own.len())];
            beside.iter().map(|row| row[n]).fold(0.0, f64::max)
        };
        let mut steps: Vec<Vec<[f64; 1]>> =
            (0..strips.len()).map(|k| (0..gaps).map(|n| [most(k, n)]).collect()).collect();
        (0..MEAN).for_each(|_| steps = evened(&steps));
        for (strip, steps) in strips.iter_mut().zip(&steps) {
            let all = strip.all();
            let mut upto = vec![0.0];
            (0..gaps).for_each(|n| upto.push(upto[n] + steps[n][0]));
            let at = |counted: f64| {
                let gap = counted / all.max(f64::MIN_POSITIVE) * gaps as f64;
                let n = (gap as usize).min(gaps - 1);
                upto[n] + (upto[n + 1] - upto[n]) * (gap - n as f64)
            };
            strip.steps = strip.steps.iter().map(|s| at(*s)).collect();
        }
    }
}

/// Values of rows from height to height with what jumps between three heights taken off them.
fn evened<const N: usize>(values: &[Vec<[f64; N]>]) -> Vec<Vec<[f64; N]>> {
    let last = values.len().saturating_sub(1);
    let at = |k: usize, n: usize, j: usize| {
        let [before, here, after] = [k.saturating_sub(1), k, k + 1].map(|k| values[k.min(last)][n][j]);
        if k == 0 || k == last { here } else { 0.25 * (before + 2.0 * here + after) }
    };
    (0..values.len()).map(|k| (0..values[k].len()).map(|n| std::array::from_fn(|j| at(k, n, j))).collect()).collect()
}
