//! Curvature of a closed polygon: that of the exact faces where they are known, else by local least
//! squares.
//!
//! About each point, cubics `y(s)`, `z(s)` in arc length are fitted to the points of a window, each
//! weighted with the length it stands for. The window is the widest (found by doubling and halving)
//! on which no point is farther from the fit than the tolerance: as wide as a turbine's flank
//! allows, as narrow as its trailing edge asks for. With a window of half width `w` the tolerance
//! leaves an uncertainty of curvature of the order of `10 · tolerance / w²`.

use super::outline::{OnFace, distance};

/// Points on each side that a fit needs.
const LEAST: usize = 3;

/// What the fits give, per point.
pub struct Fit {
    /// Positive where convex, 1/mm.
    pub curvature: Vec<f64>,
    /// Outward unit normal.
    pub normal: Vec<[f64; 2]>,
    /// Greatest distance of a point from its own fit, mm.
    pub error_mm: f64,
}

/// Curvature at every point of a closed polygon of the given perimeter; fits only where the faces
/// say nothing.
pub fn fit(points: &[[f64; 2]], exact: &[Option<OnFace>], s: &[f64], length: f64, tolerance: f64) -> Fit {
    let ring = LoopPoints { points, s, length };
    let mut out =
        Fit { curvature: Vec::with_capacity(points.len()), normal: Vec::with_capacity(points.len()), error_mm: 0.0 };
    let mut width = 0.02 * length;
    for i in 0..points.len() {
        if let Some(Some(known)) = exact.get(i) {
            out.curvature.push(known.curvature);
            out.normal.push(known.normal);
            continue;
        }
        let (local, found) = ring.widest(i, width, tolerance);
        width = found;
        let ([_, a, b, _], [_, c, d, _]) = (local.y, local.z);
        let speed = a.hypot(c).max(1e-12);
        out.curvature.push(2.0 * (a * d - b * c) / speed.powi(3));
        out.normal.push([c / speed, -a / speed]);
        out.error_mm = out.error_mm.max(distance(points[i], [local.y[0], local.z[0]]));
    }
    out
}

/// Cubics about a point: coefficients of rising powers of arc length from it.
struct Local {
    y: [f64; 4],
    z: [f64; 4],
    /// Greatest distance of a point of the window from the fit.
    off: f64,
}

struct LoopPoints<'a> {
    points: &'a [[f64; 2]],
    s: &'a [f64],
    length: f64,
}

impl LoopPoints<'_> {
    /// The fit over the widest window about point `i`, and its half width; `start` is a guess at
    /// that.
    fn widest(&self, i: usize, start: f64, tolerance: f64) -> (Local, f64) {
        let (least, most) = (0.002 * self.length, 0.125 * self.length);
        let mut width = start.clamp(least, most);
        let mut best = self.local(i, width);
        if best.off <= tolerance {
            while width < most {
                let wider = (1.2 * width).min(most);
                let next = self.local(i, wider);
                if next.off > tolerance {
                    break;
                }
                (best, width) = (next, wider);
            }
            return (best, width);
        }
        while best.off > tolerance && width > least {
            width = (width / 1.2).max(least);
            best = self.local(i, width);
        }
        (best, width)
    }

    /// Least-squares cubics over the points within `width` of point `i`, and at least [`LEAST`] on
    /// each side.
    fn local(&self, i: usize, width: f64) -> Local {
        let n = self.points.len();
        let origin = self.points[i];
        let reach = n.saturating_sub(1) / 2;
        let mut window: Vec<(f64, f64, [f64; 2])> = Vec::new();
        let mut add = |j: usize, along: f64| {
            let weight = 0.5 * (self.gap(j) + self.gap((j + n - 1) % n));
            let p = self.points[j];
            window.push((along, weight, [p[0] - origin[0], p[1] - origin[1]]));
        };
        add(i, 0.0);
        for sense in [1, n - 1] {
            let (mut j, mut along) = (i, 0.0);
            for k in 1..=reach {
                let next = (j + sense) % n;
                along += if sense == 1 { self.gap(j) } else { -self.gap(next) };
                j = next;
                if along.abs() > width && k > LEAST {
                    break;
                }
                add(j, along);
            }
        }
        solve(&window, origin)
    }

    /// Distance from point `j` to the next.
    fn gap(&self, j: usize) -> f64 {
        let next = if j + 1 == self.s.len() { self.length } else { self.s[j + 1] };
        next - self.s[j]
    }
}

/// Weighted least squares by normal equations, with arc length scaled to -1..1.
fn solve(window: &[(f64, f64, [f64; 2])], origin: [f64; 2]) -> Local {
    use nalgebra::{Matrix4, Vector4};
    let scale = window.iter().map(|w| w.0.abs()).fold(1e-300, f64::max);
    let mut a = Matrix4::zeros();
    let (mut by, mut bz) = (Vector4::zeros(), Vector4::zeros());
    for &(along, weight, p) in window {
        let u = along / scale;
        let row = Vector4::new(1.0, u, u * u, u * u * u);
        a += row * row.transpose() * weight;
        by += row * (weight * p[0]);
        bz += row * (weight * p[1]);
    }
    // A trace of damping keeps polygons with fewer points than coefficients solvable.
    let trace = a.trace();
    for k in 0..4 {
        a[(k, k)] += 1e-13 * trace;
    }
    let (y, z) = a.cholesky().map_or((Vector4::zeros(), Vector4::zeros()), |c| (c.solve(&by), c.solve(&bz)));
    let off = window
        .iter()
        .map(|&(along, _, p)| {
            let u = along / scale;
            let at = |c: &Vector4<f64>| c[0] + u * (c[1] + u * (c[2] + u * c[3]));
            distance(p, [at(&y), at(&z)])
        })
        .fold(0.0, f64::max);
    let back =
        |c: &Vector4<f64>, o: f64| [c[0] + o, c[1] / scale, c[2] / (scale * scale), c[3] / (scale * scale * scale)];
    Local { y: back(&y, origin[0]), z: back(&z, origin[1]), off }
}
