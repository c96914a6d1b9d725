//! The curve that the search begins with: a spline through the cutter locations, nearest along the
//! normal.

use super::form;
use super::tube::frame_at;
use crate::artifact::toolpath::CutterLocation;
use crate::geometry::Vector;
use crate::numerics::bounded::Factor;
use crate::numerics::quintic::{Breaks, weighed};

/// Breaks are about so many moves apart.
const MOVES: f64 = 2.5;
/// Moves on either side over which lengths are averaged.
const AROUND: usize = 8;
/// A span is longer than the one before it by this factor at most.
const GROWTH: f64 = 1.3;

/// Breaks along locations, as far apart as some moves are long there. `None` where arc lengths do
/// not rise.
pub(super) fn breaks(locations: &[CutterLocation]) -> Option<Breaks> {
    let (first, last) = (locations.first()?.s_mm, locations.last()?.s_mm);
    let move_mm = |k: usize| {
        let (a, b) = (k.saturating_sub(AROUND), (k + AROUND).min(locations.len() - 1));
        (locations[b].s_mm - locations[a].s_mm) / (b - a).max(1) as f64
    };
    let mut out = vec![first];
    let (mut at, mut k, mut length) = (first, 0, f64::INFINITY);
    while at < last {
        while k + 1 < locations.len() && locations[k + 1].s_mm <= at {
            k += 1;
        }
        length = (MOVES * move_mm(k)).min(GROWTH * length);
        if !(length > 0.0) || out.len() > locations.len() + 1 {
            return None;
        }
        at += length;
        out.push(at);
    }
    // All a little shorter, so that the last ends where the path does.
    let scale = (last - first) / (at - first);
    out.iter_mut().for_each(|s| *s = first + (*s - first) * scale);
    *out.last_mut()? = last;
    Breaks::new(out)
}

/// A further break in the middle of each span that is marked. `None` where floating-point numbers
/// are too coarse for that.
pub(super) fn halved(breaks: &Breaks, is_marked: impl Fn(usize) -> bool) -> Option<Breaks> {
    let mut out = Vec::with_capacity(breaks.all().len());
    for i in 0..breaks.spans() {
        let [a, b] = breaks.span(i);
        out.push(a);
        if is_marked(i) {
            out.push(0.5 * (a + b));
        }
    }
    out.push(*breaks.all().last()?);
    Breaks::new(out)
}

/// The polyline at Greville's abscissae: control points of a curve that is near to it, to second
/// order.
fn along(locations: &[CutterLocation], breaks: &Breaks) -> Vec<[f64; 3]> {
    let mut k = 0;
    let mut at = |s: f64| {
        while k + 2 < locations.len() && locations[k + 1].s_mm < s {
            k += 1;
        }
        let (a, b) = (&locations[k], &locations[k + 1]);
        let share = ((s - a.s_mm) / (b.s_mm - a.s_mm)).clamp(0.0, 1.0);
        <[f64; 3]>::from(a.centre + (b.centre - a.centre) * share)
    };
    breaks.greville().into_iter().map(&mut at).collect()
}

/// Control points of the spline nearest to the locations: least is the sum of the squares of the
/// distances over `allowed_mm` (along the normal, across, along the path), and of `even` times
/// `½ ∫ |c'''|²`. `None` where the locations are fewer than two, or the breaks too near to them for
/// floating-point numbers.
pub(super) fn fit(
    locations: &[CutterLocation],
    breaks: &Breaks,
    allowed_mm: [f64; 3],
    even: f64,
) -> Option<Vec<[f64; 3]>> {
    if locations.len() < 2 {
        return None;
    }
    let mut x = along(locations, breaks);
    let mut band = vec![[0.0; 18]; 3 * x.len()];
    let mut side = vec![[0.0; 3]; x.len()];
    for (k, l) in locations.iter().enumerate() {
        let i = breaks.span_of(l.s_mm);
        let w = breaks.weights(i, l.s_mm);
        let miss = l.centre.coords - Vector::from(weighed(&x[i..], &w));
        for (direction, allowed) in frame_at(locations, k).iter().zip(allowed_mm) {
            let g = direction / allowed;
            let row: [f64; 18] = std::array::from_fn(|a| w[a / 3] * g[a % 3]);
            for a in 0..18 {
                side[i + a / 3][a % 3] += row[a] * g.dot(&miss);
                for b in 0..=a {
                    band[3 * i + a][17 - a + b] += row[a] * row[b];
                }
            }
        }
    }
    for i in 0..breaks.spans() {
        let form = form::third::<3, 18>(breaks, i, &x[i..]);
        for a in 0..18 {
            side[i + a / 3][a % 3] -= even * form.gradient[a];
            for b in 0..=a {
                band[3 * i + a][17 - a + b] += even * form.hessian[a][b];
            }
        }
    }
    Factor::<18>::of(band)?.solve(side.as_flattened_mut());
    x.as_flattened_mut().iter_mut().zip(side.as_flattened()).for_each(|(x, d)| *x += d);
    x.as_flattened().iter().all(|v| v.is_finite()).then_some(x)
}
