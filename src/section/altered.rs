//! Altered points: where a section turns from convex to concave or back.
//!
//! The loop is cut into stretches of one sign of curvature. A stretch of length `L` that turns by
//! the angle `A` bulges by about `A L / 8`; one that bulges by less than the tolerance is noise and
//! joins its neighbours, the flattest first. What is left are the changes of sign that the section
//! really has.

use crate::artifact::section::AlteredPoint;

/// A stretch of one sign: points `first .. first + count` round the loop.
#[derive(Clone, Copy, Debug)]
struct SameSign {
    first: usize,
    count: usize,
    length: f64,
    /// Signed turning, rad.
    turning: f64,
}

impl SameSign {
    fn bulge(&self) -> f64 {
        self.turning.abs() * self.length / 8.0
    }
}

/// The altered points of a closed polygon, by rising arc length.
pub(super) fn points(
    points: &[[f64; 2]],
    s: &[f64],
    length: f64,
    curvature: &[f64],
    tolerance: f64,
) -> Vec<AlteredPoint> {
    let n = points.len();
    let mut stretches = by_sign(s, length, curvature);
    while stretches.len() > 1 {
        let flattest = (0..stretches.len()).min_by(|&a, &b| stretches[a].bulge().total_cmp(&stretches[b].bulge()));
        match flattest {
            Some(k) if stretches[k].bulge() < 2.0 * tolerance => join(&mut stretches, k),
            _ => break,
        }
    }
    if stretches.len() < 2 {
        return Vec::new();
    }
    let mut out: Vec<AlteredPoint> = stretches
        .iter()
        .map(|st| {
            // Between the last point of the stretch before and the first of this one, where
            // curvature is zero.
            let (j, i) = ((st.first + n - 1) % n, st.first);
            let (before, here) = (curvature[j], curvature[i]);
            let f = if before * here < 0.0 { before / (before - here) } else { 0.5 };
            let gap = if i == 0 { length - s[j] } else { s[i] - s[j] };
            let (p, q) = (points[j], points[i]);
            AlteredPoint {
                s_mm: (s[j] + f * gap).rem_euclid(length),
                point_mm: [p[0] + f * (q[0] - p[0]), p[1] + f * (q[1] - p[1])],
                into_concave: st.turning < 0.0,
            }
        })
        .collect();
    out.sort_by(|a, b| a.s_mm.total_cmp(&b.s_mm));
    out
}

/// Maximal stretches of one sign, round the loop.
fn by_sign(s: &[f64], length: f64, curvature: &[f64]) -> Vec<SameSign> {
    let n = s.len();
    let convex = |i: usize| curvature[i % n] >= 0.0;
    let Some(start) = (0..n).find(|&i| convex(i) != convex(i + n - 1)) else { return Vec::new() };
    let mut out: Vec<SameSign> = Vec::new();
    for k in 0..n {
        let i = (start + k) % n;
        let ahead = if i + 1 == n { length } else { s[i + 1] } - s[i];
        let behind = if i == 0 { length - s[n - 1] } else { s[i] - s[i - 1] };
        let own = 0.5 * (ahead + behind);
        match out.last_mut() {
            Some(last) if convex(last.first) == convex(i) => {
                last.count += 1;
                last.length += own;
                last.turning += own * curvature[i];
            }
            _ => out.push(SameSign { first: i, count: 1, length: own, turning: own * curvature[i] }),
        }
    }
    out
}

/// Joins stretch `k` with the two beside it, which have the other sign.
fn join(stretches: &mut Vec<SameSign>, k: usize) {
    let n = stretches.len();
    if n <= 2 {
        stretches.clear();
        return;
    }
    let (before, after) = ((k + n - 1) % n, (k + 1) % n);
    let parts = [stretches[before], stretches[k], stretches[after]];
    let joined = SameSign {
        first: parts[0].first,
        count: parts.iter().map(|p| p.count).sum(),
        length: parts.iter().map(|p| p.length).sum(),
        turning: parts.iter().map(|p| p.turning).sum(),
    };
    stretches[before] = joined;
    let mut gone = [k, after];
    gone.sort_unstable();
    stretches.remove(gone[1]);
    stretches.remove(gone[0]);
}
