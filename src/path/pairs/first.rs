//! The first row: midway on what of the suction side has an opposite one.

use nalgebra::{DMatrix, DVector};

use super::super::level::Touch;
use super::super::ring::{self, Ring, Tracing};
use super::no_pairs;
use super::sheet::{OrEnd, Sheet, Standing};
use crate::artifact::along::Along;
use crate::artifact::paired::RowEnd;
use crate::error::{Result, Stage};
use crate::geometry::Point;
use crate::numerics::runs::longest;
use crate::observe::Observer;
use crate::parallel;

/// Heights at which the suction side is looked at.
const LOOKS: usize = 24;
/// Places that are looked at along it, about.
const PLACES: usize = 64;
/// Halvings of the way between two of them, to where partners end.
const HALVINGS: usize = 14;
/// Coefficients of the row's curve over the height, at most: a cubic.
const COEFFICIENTS: usize = 4;

/// The first row at heights that fall.
///
/// # Errors
/// Kind `Infeasible` where no place of the suction side has an opposite one at two heights at
/// least.
pub(super) fn row(sheet: &Sheet, heights_mm: &[f64], observer: &dyn Observer) -> Result<Vec<Option<Standing>>> {
    let step = heights_mm.len().div_ceil(LOOKS).max(1);
    let looks: Vec<f64> = heights_mm.iter().copied().step_by(step).collect();
    let look = |x_mm: &f64| {
        observer.check(Stage::Path)?;
        // A height without a contour of the airfoil has no row.
        Ok(sheet.seed(*x_mm).ok().flatten().and_then(|seed| middle(sheet, seed, *x_mm)))
    };
    let found: Vec<Option<Point>> = parallel::try_map(&looks, look)?;
    let middles: Vec<Point> = found.into_iter().flatten().collect();
    let curve = Curve::through(&middles).ok_or_else(|| {
        no_pairs(
            format!(
                "no place of the suction side has an opposite one within {:.1}°, at {} of {} heights",
                sheet.options.max_angle_rad.to_degrees(),
                looks.len() - middles.len(),
                looks.len()
            ),
            "one tool can machine it; `inspect --pairs` shows what faces what",
        )
    })?;
    let reach = 0.5 * sheet.levels[0].radius_mm;
    let at = |x_mm: &f64| {
        let touch = sheet.levels[0].touch_in_plane(&curve.at(*x_mm), reach).ok_or(RowEnd::NoBall);
        touch.and_then(|t| sheet.stand(t))
    };
    let all: Vec<OrEnd<Standing>> = parallel::map(heights_mm, at);
    let kept = longest(&all.iter().map(OrEnd::is_ok).collect::<Vec<_>>());
    if kept.len() < 2 {
        let (k, end) =
            all.iter().enumerate().find_map(|(k, s)| Some((k, s.as_ref().err()?))).unwrap_or((0, &RowEnd::NoBall));
        return Err(sheet.lost(*end, heights_mm[k]));
    }
    Ok(all.into_iter().enumerate().map(|(k, s)| s.ok().filter(|_| kept.contains(&k))).collect())
}

/// The middle of the longest stretch of the suction side at a height whose places have opposite
/// ones, as a ball centre of tool 1.
fn middle(sheet: &Sheet, seed: Touch, x_mm: f64) -> Option<Point> {
    let radius_mm = sheet.levels[0].radius_mm;
    let how =
        Tracing { max_step_mm: 0.25 * radius_mm, max_turn_rad: 0.12, min_step_mm: 1e-3 * radius_mm, min_cos_lean: 0.1 };
    let ring = ring::trace(&sheet.levels[0], seed, &how).ok()?;
    let places = suction_side(sheet, &ring, x_mm);
    let every = places.len().div_ceil(PLACES).max(1);
    let places: Vec<Touch> = places.into_iter().step_by(every).collect();
    let paired: Vec<bool> = parallel::map(&places, |t| sheet.stand(*t).is_ok());
    let run = longest(&paired);
    let kept = places.get(run.clone()).filter(|kept| !kept.is_empty())?;
    // Where partners end lies between two places.
    let before = run.start.checked_sub(1).map(|k| end(sheet, kept[0], places[k]));
    let after = places.get(run.end).map(|beyond| end(sheet, kept[kept.len() - 1], *beyond));
    let all = before.iter().chain(kept).chain(&after);
    let centres: Vec<Point> = all.map(|t| t.centre).collect();
    let s_mm = super::super::curve::arc_lengths(centres.iter());
    let half = 0.5 * s_mm.last()?;
    let k = s_mm.partition_point(|s| *s < half).min(s_mm.len() - 1);
    match k.checked_sub(1) {
        None => Some(centres[k]),
        Some(before) => {
            let share = (half - s_mm[before]) / (s_mm[k] - s_mm[before]).max(1e-12);
            Some(centres[before] + (centres[k] - centres[before]) * share)
        }
    }
}

/// The last place with a partner on the way from one that has to one that has none.
fn end(sheet: &Sheet, mut has: Touch, mut has_not: Touch) -> Touch {
    for _ in 0..HALVINGS {
        let way = has_not.centre - has.centre;
        let middle = has.centre + way * 0.5;
        let Some(touch) = sheet.levels[0].touch_in_plane(&middle, 0.5 * way.norm() + 1e-3) else { break };
        *(if sheet.stand(touch).is_ok() { &mut has } else { &mut has_not }) = touch;
    }
    has
}

/// Touches of a ring from edge to edge on the suction side.
fn suction_side(sheet: &Sheet, ring: &Ring, x_mm: f64) -> Vec<Touch> {
    let edges = sheet.sides.at(x_mm).map(|edge| {
        let off = |t: &Touch| {
            let [y, z] = Along::BLADE.frame(&t.contact).across(&t.contact.coords);
            (y - edge[0]).hypot(z - edge[1])
        };
        let n = ring.touches.len();
        (0..n).min_by(|a, b| off(&ring.touches[*a]).total_cmp(&off(&ring.touches[*b]))).unwrap_or(0)
    });
    // Rings run counter-clockwise seen from the tip.
    let [from, to] = if sheet.sides.suction_follows_leading { edges } else { [edges[1], edges[0]] };
    let n = ring.touches.len();
    let count = (to + n - from) % n;
    (0..=count).map(|k| ring.touches[(from + k) % n]).collect()
}

/// Ball centres over the height, by least squares.
struct Curve {
    mid_mm: f64,
    half_mm: f64,
    /// Coefficients of y and z.
    coefficients: [DVector<f64>; 2],
}

impl Curve {
    /// Near points at different heights; `None` of fewer than two.
    fn through(points: &[Point]) -> Option<Self> {
        let (low, high) = points.iter().fold((f64::INFINITY, f64::NEG_INFINITY), |(a, b), p| (a.min(p.x), b.max(p.x)));
        let (mid_mm, half_mm) = (0.5 * (low + high), 0.5 * (high - low));
        if points.len() < 2 || !(half_mm > 0.0) {
            return None;
        }
        let terms = COEFFICIENTS.min(points.len());
        let matrix = DMatrix::from_fn(points.len(), terms, |r, c| ((points[r].x - mid_mm) / half_mm).powi(c as i32));
        let solve = matrix.svd(true, true);
        let of = |value: &dyn Fn(&Point) -> f64| {
            solve.solve(&DVector::from_iterator(points.len(), points.iter().map(value)), 1e-12).ok()
        };
        Some(Curve { mid_mm, half_mm, coefficients: [of(&|p| p.y)?, of(&|p| p.z)?] })
    }

    fn at(&self, x_mm: f64) -> Point {
        // Beyond the outermost points a cubic runs away: it goes on straight from them.
        let t = (x_mm - self.mid_mm) / self.half_mm;
        let inside = t.clamp(-1.0, 1.0);
        let [y, z] = [0, 1].map(|k| {
            let c = &self.coefficients[k];
            let value = c.iter().rev().fold(0.0, |sum, c| sum * inside + c);
            let slope = c.iter().enumerate().skip(1).rev().fold(0.0, |sum, (n, c)| sum * inside + n as f64 * c);
            value + slope * (t - inside)
        });
        Point::new(x_mm, y, z)
    }
}
