//! Newton for the closest point of one piece of a face or of an edge.
//!
//! In: the piece, a point. Out: the foot to which the distance falls from the piece's own first
//! guess, kept on the piece. A step that would lengthen the distance is shortened; where the
//! Hessian is not positive definite a Gauss–Newton step is taken.

use super::leaf::{FaceForm, Leaf, LeafArc};
use super::patch::CurveTable;
use crate::geometry::nurbs::SurfaceDerivatives;
use crate::geometry::{Point, Vector};

/// Newton's last step, mm: after it the foot is right to the square of this over the radius of
/// curvature.
const LAST_STEP_MM: f64 = 1e-5;
const MOST_STEPS: usize = 30;

/// Where Newton ended on a piece of a face.
pub(super) struct Foot {
    pub st: [f64; 2],
    pub point: Point,
    pub d2: f64,
    /// Derivatives, by the span's coordinates.
    pub at: SurfaceDerivatives,
    /// It is a minimum of the piece, sides included.
    pub settled: bool,
}

/// Newton for ½|S − q|² on a rectangle; at its sides along them. Where the Hessian is not positive
/// definite a Gauss–Newton step, where the distance would grow a shorter one.
pub(super) fn foot_on_piece(shape: &FaceForm, leaf: &Leaf, q: &Point) -> Foot {
    let [[s0, s1], [t0, t1]] = leaf.rect.range;
    let clamp = |st: [f64; 2]| [st[0].max(s0).min(s1), st[1].max(t0).min(t1)];
    let r = q - leaf.slab.middle;
    let mut st = clamp([leaf.start[0] + leaf.inverse[0].dot(&r), leaf.start[1] + leaf.inverse[1].dot(&r)]);
    let mut at = shape.local(leaf.rect.span, st);
    let mut d2 = (at.p - q).norm_squared();
    let mut settled = false;
    for _ in 0..MOST_STEPS {
        let step = newton_step(&at, &(at.p - q), st, [[s0, s1], [t0, t1]]);
        let next = clamp([st[0] + step[0], st[1] + step[1]]);
        let d = [next[0] - st[0], next[1] - st[1]];
        let length = (at.du * d[0] + at.dv * d[1]).norm();
        if length < LAST_STEP_MM {
            // So near, Taylor's polynomial is the surface.
            let by = at.du * d[0]
                + at.dv * d[1]
                + at.duu * (0.5 * d[0] * d[0])
                + at.duv * (d[0] * d[1])
                + at.dvv * (0.5 * d[1] * d[1]);
            at.p += by;
            at.du += at.duu * d[0] + at.duv * d[1];
            at.dv += at.duv * d[0] + at.dvv * d[1];
            st = next;
            d2 = (at.p - q).norm_squared();
            settled = true;
            break;
        }
        let mut share = 1.0;
        let mut moved = false;
        for _ in 0..12 {
            let trial = [st[0] + share * d[0], st[1] + share * d[1]];
            let there = shape.local(leaf.rect.span, trial);
            let new2 = (there.p - q).norm_squared();
            if new2 <= d2 * (1.0 + 1e-13) + 1e-24 {
                (st, at, d2, moved) = (trial, there, new2, true);
                break;
            }
            share *= 0.3;
        }
        if !moved {
            break;
        }
    }
    Foot { st, point: at.p, d2, at, settled }
}

/// The step in both parameters, or in the one that is free where the other is held by a side of the
/// rectangle.
fn newton_step(at: &SurfaceDerivatives, r: &Vector, st: [f64; 2], range: [[f64; 2]; 2]) -> [f64; 2] {
    let g = [r.dot(&at.du), r.dot(&at.dv)];
    let (e, f, gg) = (at.du.norm_squared(), at.du.dot(&at.dv), at.dv.norm_squared());
    let (mut a, mut b, mut c) = (e + r.dot(&at.duu), f + r.dot(&at.duv), gg + r.dot(&at.dvv));
    let indefinite = a <= 1e-6 * e || a * c - b * b <= 1e-6 * e * gg;
    if indefinite {
        (a, b, c) = (e, f, gg);
    }
    let alone = |g: f64, h: f64| if h > 0.0 { -g / h } else { 0.0 };
    let held = |k: usize, step: f64| (st[k] <= range[k][0] && step < 0.0) || (st[k] >= range[k][1] && step > 0.0);
    let det = a * c - b * b;
    let both = if det > 1e-12 * a * c {
        [(b * g[1] - c * g[0]) / det, (b * g[0] - a * g[1]) / det]
    } else {
        // Degenerate (a pole): each direction by itself, at half length.
        [0.5 * alone(g[0], a), 0.5 * alone(g[1], c)]
    };
    match (held(0, -g[0]), held(1, -g[1])) {
        (true, true) => [0.0, 0.0],
        (true, false) => [0.0, alone(g[1], c)],
        (false, true) => [alone(g[0], a), 0.0],
        (false, false) => {
            // A step beyond a side ends on it; the other parameter then goes to its own minimum
            // there.
            let over = |k: usize| {
                let x = st[k] + both[k];
                if x < range[k][0] {
                    Some(range[k][0] - st[k])
                } else if x > range[k][1] {
                    Some(range[k][1] - st[k])
                } else {
                    None
                }
            };
            match (over(0), over(1)) {
                (Some(ds), None) => [ds, alone(g[1] + b * ds, c)],
                (None, Some(dt)) => [alone(g[0] + b * dt, a), dt],
                _ => both,
            }
        }
    }
}

/// Where Newton ended on a piece of an edge.
pub(super) struct ArcFoot {
    pub s: f64,
    pub point: Point,
    pub d2: f64,
    pub settled: bool,
}

pub(super) fn foot_on_arc(table: &CurveTable, arc: &LeafArc, q: &Point) -> ArcFoot {
    let [from, to] = arc.range;
    let d = arc.ends[1] - arc.ends[0];
    let share = if d.norm_squared() > 0.0 { (q - arc.ends[0]).dot(&d) / d.norm_squared() } else { 0.5 };
    let mut s = from + share.clamp(0.0, 1.0) * (to - from);
    let (mut p, mut d1, mut d2) = table.local(arc.span as usize, s);
    let mut best = (p - q).norm_squared();
    for _ in 0..MOST_STEPS {
        let r = p - q;
        let (g, gauss) = (r.dot(&d1), d1.norm_squared());
        let newton = gauss + r.dot(&d2);
        let h = if newton > 1e-6 * gauss { newton } else { gauss };
        let step = if h > 0.0 { (s - g / h).clamp(from, to) - s } else { 0.0 };
        if step.abs() * d1.norm() < LAST_STEP_MM {
            p += d1 * step + d2 * (0.5 * step * step);
            return ArcFoot { s: s + step, point: p, d2: (p - q).norm_squared(), settled: true };
        }
        let mut scale = 1.0;
        let mut moved = false;
        for _ in 0..12 {
            let next = s + scale * step;
            let at = table.local(arc.span as usize, next);
            let new2 = (at.0 - q).norm_squared();
            if new2 <= best * (1.0 + 1e-13) + 1e-24 {
                (s, p, d1, d2, best, moved) = (next, at.0, at.1, at.2, new2, true);
                break;
            }
            scale *= 0.3;
        }
        if !moved {
            break;
        }
    }
    ArcFoot { s, point: p, d2: best, settled: false }
}
