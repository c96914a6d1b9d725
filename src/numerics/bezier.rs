//! One coordinate of a cubic Bézier.

/// Value, first and second derivative at `t` of the cubic with control values `c`.
pub fn cubic(c: [f64; 4], t: f64) -> [f64; 3] {
    let u = 1.0 - t;
    let d = [c[1] - c[0], c[2] - c[1], c[3] - c[2]];
    [
        u * u * u * c[0] + 3.0 * u * t * (u * c[1] + t * c[2]) + t * t * t * c[3],
        3.0 * (u * u * d[0] + 2.0 * u * t * d[1] + t * t * d[2]),
        6.0 * (u * (d[1] - d[0]) + t * (d[2] - d[1])),
    ]
}

/// The parameter in `0 … 1` at which a cubic that rises reaches `value`: Newton's method kept
/// inside a shrinking bracket.
pub fn parameter(c: [f64; 4], value: f64) -> f64 {
    let (mut lo, mut hi) = (0.0, 1.0);
    let mut t = ((value - c[0]) / (c[3] - c[0])).clamp(0.0, 1.0);
    for _ in 0..80 {
        let [v, d, _] = cubic(c, t);
        if v < value {
            lo = t;
        } else {
            hi = t;
        }
        let newton = t - (v - value) / d;
        let next = if newton > lo && newton < hi { newton } else { 0.5 * (lo + hi) };
        if (next - t).abs() <= 1e-16 || hi - lo <= 1e-16 {
            return next;
        }
        t = next;
    }
    t
}
