//! The shortest path in a corridor from one point to another: the funnel algorithm.
//!
//! For walls over `s` the taut string does not depend on the scales of `s` and θ: it minimises
//! `∫ φ(θ') ds` for every convex `φ` at once (Davies and Kovac 2001, "Local extremes, runs, strings
//! and multiresolution"). With `φ = |·|` it follows that between walls that never fall it never
//! falls. It is the exact form of the first two steps of the piecewise linearisation: its corners
//! are the key points, with no redundant one among them.
//!
//! Linear time: every sample enters and leaves each side of the funnel at most once.

use std::collections::VecDeque;

use super::corridor::{Corridor, PathAngle, slope};

/// Corners of the shortest path from `[s₀, start]` to `[sₙ, end]`, both included. The walls at the
/// first and last sample do not matter: the points given do.
pub(super) fn string(corridor: &Corridor, start: f64, end: f64) -> Vec<PathAngle> {
    let n = corridor.s.len();
    let (Some(&s0), Some(&s1)) = (corridor.s.first(), corridor.s.last()) else { return Vec::new() };
    let apex = [s0, start];
    let mut funnel = Funnel { path: vec![apex], upper: VecDeque::from([apex]), lower: VecDeque::from([apex]) };
    for i in 1..n.saturating_sub(1) {
        let s = corridor.s[i];
        Funnel::add(&mut funnel.path, &mut funnel.upper, &mut funnel.lower, [s, corridor.hi[i]], 1.0);
        Funnel::add(&mut funnel.path, &mut funnel.lower, &mut funnel.upper, [s, corridor.lo[i]], -1.0);
    }
    Funnel::add(&mut funnel.path, &mut funnel.upper, &mut funnel.lower, [s1, end], 1.0);
    let mut path = funnel.path;
    path.extend(funnel.upper.into_iter().skip(1));
    path
}

/// Shortest paths from the apex to the last sample of either wall; both begin with the apex.
struct Funnel {
    path: Vec<PathAngle>,
    upper: VecDeque<PathAngle>,
    lower: VecDeque<PathAngle>,
}

impl Funnel {
    /// Adds a sample to the `own` side (`sign` +1: upper, whose slopes rise; −1: lower, whose
    /// slopes fall). Where it lies beyond the `other` side, that side's corners become corners of
    /// the path.
    fn add(
        path: &mut Vec<PathAngle>,
        own: &mut VecDeque<PathAngle>,
        other: &mut VecDeque<PathAngle>,
        p: PathAngle,
        sign: f64,
    ) {
        while own.len() >= 2
            && sign * slope(own[own.len() - 2], own[own.len() - 1]) >= sign * slope(own[own.len() - 2], p)
        {
            own.pop_back();
        }
        if own.len() == 1 {
            while other.len() >= 2 && sign * slope(other[0], p) < sign * slope(other[0], other[1]) {
                other.pop_front();
                path.push(other[0]);
            }
            own[0] = other[0];
        }
        own.push_back(p);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    #[test]
    fn bends_only_at_the_walls_that_are_in_the_way() {
        // Upper wall low until s = 4, lower wall high from s = 6.
        let s: Vec<f64> = (0..=10).map(f64::from).collect();
        let lo = s.iter().map(|s| if *s < 6.0 { -1.0 } else { 4.0 }).collect();
        let hi = s.iter().map(|s| if *s <= 4.0 { 1.0 } else { 9.0 }).collect();
        let c = Corridor { s, lo, hi, one_way: true };
        assert_eq!(string(&c, 0.0, 5.0), vec![[0.0, 0.0], [4.0, 1.0], [6.0, 4.0], [10.0, 5.0]]);
        assert_eq!(string(&c, 1.0, 4.5), vec![[0.0, 1.0], [4.0, 1.0], [6.0, 4.0], [10.0, 4.5]]);
        assert_eq!(string(&c, 1.0, 4.5).len(), 4);
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(500))]
        #[test]
        fn inside_monotone_and_taut(steps in prop::collection::vec((0.01..1.0f64, 0.0..1.0f64, 0.0..1.0f64), 3..60), f in 0.0..1.0f64) {
            let mut c = Corridor { s: vec![0.0], lo: vec![0.0], hi: vec![1.0], one_way: true };
            for (ds, a, b) in &steps {
                c.s.push(c.s[c.s.len() - 1] + ds);
                c.lo.push(c.lo[c.lo.len() - 1] + a);
                c.hi.push((c.hi[c.hi.len() - 1] + b).max(c.lo[c.lo.len() - 1] + 0.05));
            }
            let n = c.s.len() - 1;
            let (start, end) = (f, c.lo[n] + f * (c.hi[n] - c.lo[n]));
            prop_assume!(start <= end);
            let p = string(&c, start, end);
            for w in p.windows(2) {
                prop_assert!(w[1][0] > w[0][0] && w[1][1] >= w[0][1] - 1e-12);
                let [below, above] = c.room(w[0], w[1]);
                prop_assert!(below > -1e-9 && above > -1e-9);
            }
            // Taut: it bends up only under the upper wall and down only over the lower one.
            for w in p.windows(3) {
                let [lo, hi] = c.at(w[1][0]);
                let bend = slope(w[1], w[2]) - slope(w[0], w[1]);
                let off = if bend > 0.0 { hi - w[1][1] } else { w[1][1] - lo };
                prop_assert!(off.abs() < 1e-12);
            }
        }
    }
}
