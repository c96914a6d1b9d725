//! From the free intervals of each location to one channel: a layered graph.
//!
//! A node is a free interval, unwrapped about the unwrapped azimuth of the surface normal; an edge
//! joins intervals of neighbouring locations that overlap. Chosen is, among the chains with the
//! greatest least overlap, the one with the greatest sum of overlaps.

use super::forbidden::Free;

/// Where no chain goes on: the location, and the intervals of the location before it from which
/// none is reached.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Closed {
    /// First location that no chain reaches.
    pub at: usize,
}

/// The chain and how many separate ones there are.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Chain {
    /// Per location: index of the interval chosen.
    pub chosen: Vec<usize>,
    /// Groups of chains that cannot be changed into one another on the way.
    pub count: usize,
}

/// Finds the chain; `layers[i]` are the unwrapped free intervals of location `i`, in rising order.
///
/// # Errors
/// [`Closed`] where no chain leads from the first location to the last.
pub(super) fn widest(layers: &[Vec<Free>], least: f64) -> Result<Chain, Closed> {
    let width = greatest_least_overlap(layers, least)?;
    let chosen = longest(layers, width.min(f64::MAX));
    Ok(Chain { chosen, count: count(layers, least) })
}

fn overlap(a: &Free, b: &Free) -> f64 {
    a.hi.min(b.hi) - a.lo.max(b.lo)
}

/// Some interval of the one place overlaps one of the other by so much.
pub(super) fn meet(from: &[Free], to: &[Free], least: f64) -> bool {
    from.iter().any(|a| to.iter().any(|b| overlap(a, b) >= least))
}

/// Where chains end: each location none of whose intervals is reached from the one before by what
/// has been reached since the last such location.
pub(super) fn gaps(layers: &[Vec<Free>], least: f64) -> Vec<usize> {
    let mut out = Vec::new();
    let mut reached: Vec<&Free> = layers.first().map(|l| l.iter().collect()).unwrap_or_default();
    if reached.is_empty() && !layers.is_empty() {
        out.push(0);
    }
    for (k, layer) in layers.iter().enumerate().skip(1) {
        let next: Vec<&Free> = layer.iter().filter(|b| reached.iter().any(|a| overlap(a, b) >= least)).collect();
        let ends = next.is_empty();
        if ends {
            out.push(k);
        }
        reached = if ends { layer.iter().collect() } else { next };
    }
    out
}

/// The greatest overlap that some chain has everywhere.
fn greatest_least_overlap(layers: &[Vec<Free>], least: f64) -> Result<f64, Closed> {
    let mut best: Vec<f64> = layers.first().map(|l| l.iter().map(|f| f.hi - f.lo).collect()).unwrap_or_default();
    if best.is_empty() {
        return Err(Closed { at: 0 });
    }
    for (i, pair) in layers.windows(2).enumerate() {
        let [from, to] = pair else { continue };
        let next: Vec<f64> = to
            .iter()
            .map(|b| from.iter().zip(&best).map(|(a, &w)| w.min(overlap(a, b))).fold(f64::NEG_INFINITY, f64::max))
            .collect();
        if !next.iter().any(|&w| w >= least) {
            return Err(Closed { at: i + 1 });
        }
        best = next;
    }
    Ok(best.into_iter().fold(f64::NEG_INFINITY, f64::max))
}

/// The chain with the greatest sum of overlaps among those that overlap by at least `least`
/// everywhere.
fn longest(layers: &[Vec<Free>], least: f64) -> Vec<usize> {
    let mut sum: Vec<f64> = layers.first().map(|l| l.iter().map(|f| f.hi - f.lo).collect()).unwrap_or_default();
    if let Some(first) = layers.first() {
        for (s, f) in sum.iter_mut().zip(first) {
            if f.hi - f.lo < least {
                *s = f64::NEG_INFINITY;
            }
        }
    }
    let mut back: Vec<Vec<usize>> = Vec::with_capacity(layers.len());
    for pair in layers.windows(2) {
        let [from, to] = pair else { continue };
        let step = |b: &Free| {
            let mut best = (0, f64::NEG_INFINITY);
            for (k, (a, &s)) in from.iter().zip(&sum).enumerate() {
                let o = overlap(a, b);
                if o >= least && s + o > best.1 {
                    best = (k, s + o);
                }
            }
            best
        };
        let found: Vec<(usize, f64)> = to.iter().map(step).collect();
        back.push(found.iter().map(|f| f.0).collect());
        sum = found.into_iter().map(|f| f.1).collect();
    }
    let mut at = 0;
    for (k, &s) in sum.iter().enumerate() {
        if s > sum.get(at).copied().unwrap_or(f64::NEG_INFINITY) {
            at = k;
        }
    }
    let mut chosen = vec![at];
    for b in back.iter().rev() {
        at = b.get(at).copied().unwrap_or(0);
        chosen.push(at);
    }
    chosen.reverse();
    chosen
}

/// Connected groups among the nodes that lie on some whole chain.
fn count(layers: &[Vec<Free>], least: f64) -> usize {
    let joined = |a: &Free, b: &Free| overlap(a, b) >= least;
    let mut ahead: Vec<Vec<bool>> = vec![layers.last().map(|l| vec![true; l.len()]).unwrap_or_default()];
    for pair in layers.windows(2).rev() {
        let [from, to] = pair else { continue };
        let last = ahead.last().cloned().unwrap_or_default();
        ahead.push(from.iter().map(|a| to.iter().zip(&last).any(|(b, &ok)| ok && joined(a, b))).collect());
    }
    ahead.reverse();
    // Groups of the current layer's live nodes by number; groups that meet are merged.
    let mut group: Vec<Option<usize>> =
        ahead.first().map(|a| a.iter().enumerate().map(|(k, &ok)| ok.then_some(k)).collect()).unwrap_or_default();
    for (i, pair) in layers.windows(2).enumerate() {
        let [from, to] = pair else { continue };
        let mut next: Vec<Option<usize>> = vec![None; to.len()];
        for (k, b) in to.iter().enumerate() {
            if !ahead[i + 1].get(k).copied().unwrap_or(false) {
                continue;
            }
            for j in (0..from.len()).filter(|&j| joined(&from[j], b)) {
                match (next[k], group[j]) {
                    (None, g) => next[k] = g,
                    (Some(g), Some(h)) if g != h => merge(&mut group, &mut next, h, g),
                    _ => {}
                }
            }
        }
        group = next;
    }
    let mut groups: Vec<usize> = group.into_iter().flatten().collect();
    groups.sort_unstable();
    groups.dedup();
    groups.len()
}

/// Renames group `from` to `to`.
fn merge(a: &mut [Option<usize>], b: &mut [Option<usize>], from: usize, to: usize) {
    for g in a.iter_mut().chain(b).flatten() {
        if *g == from {
            *g = to;
        }
    }
}
