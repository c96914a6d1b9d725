//! Arcs and helices as polynomials of degree 5.
//!
//! Each piece has place, velocity and acceleration of the arc at both ends. The remainder of such a
//! polynomial is at most `r Δ⁶ / 46080` for a piece of the angle `Δ` (sixth derivative `r Δ⁶`, over
//! 6!, times the greatest value 1/64 of `p³ (1 − p)³`), and `Δ` is chosen so that this is no more
//! than [`OFF_MM`].

use super::block::{Arc, Centre};
use crate::geometry::Vector;
use std::f64::consts::TAU;

/// Greatest distance of a polynomial from its arc, mm.
const OFF_MM: f64 = 1e-7;
/// Greatest difference of the radii at both ends, mm: what controls take for rounding. The radius
/// goes evenly from one to the other.
pub(super) const RADII_MM: f64 = 0.02;
/// Ends that are this near to one another in angle are those of a whole turn, rad.
const SAME_RAD: f64 = 1e-9;
/// Most pieces of an arc.
const MOST: f64 = 20_000.0;

/// One of the equal parts of an arc.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct ArcPiece {
    /// Where it ends, mm.
    pub to: [f64; 3],
    /// Coefficients of `p²` to `p⁵`, `p` going from 0 to 1 over the piece, mm.
    pub bend: [[f64; 4]; 3],
}

/// The pieces of an arc from one place to another, all of the same length.
///
/// # Errors
/// What is wrong with it, in words.
pub(super) fn pieces(arc: &Arc, from: [f64; 3], to: [f64; 3]) -> Result<Vec<ArcPiece>, String> {
    let [a, b] = [Vector::from(from), Vector::from(to)];
    let axis = Vector::from(arc.axis).try_normalize(0.0).ok_or("the axis of the arc is 0")?;
    let across = |v: Vector| v - axis * axis.dot(&v);
    if !(a - b).iter().all(|v| v.is_finite()) {
        return Err("an arc from a place that the program has not said".into());
    }
    let centre = match arc.centre {
        Centre::FromStart(c) => a + across(c.into()),
        Centre::At(c) => a + across(Vector::from(c) - a),
        Centre::Radius(r) => between(a, across(b - a), &axis, r)?,
    };
    let [first, last] = [across(a - centre), across(b - centre)];
    let radii = [first.norm(), last.norm()];
    if !(radii[0] > 0.0 && radii[1] > 0.0) {
        return Err("an arc without a radius".into());
    }
    if (radii[0] - radii[1]).abs() > RADII_MM {
        let what = format!("the arc begins {:.4} mm from its centre and ends {:.4} mm from it", radii[0], radii[1]);
        return Err(what);
    }
    let u = first / radii[0];
    let w = axis.cross(&u);
    let angle = last.dot(&w).atan2(last.dot(&u)).rem_euclid(TAU);
    let angle = if angle < SAME_RAD || TAU - angle < SAME_RAD { TAU } else { angle };
    let sweep = angle + TAU * f64::from(arc.turns);
    let greatest = (46080.0 * OFF_MM / radii[0].max(radii[1])).powf(1.0 / 6.0);
    let count = (sweep / greatest).ceil().max(1.0);
    if count > MOST {
        return Err(format!("an arc of radius {:.0} mm and {:.0} turns is too long", radii[0], sweep / TAU));
    }
    let step = sweep / count;
    let [grown, lifted] = [(radii[1] - radii[0]) / count, axis.dot(&(b - a)) / count];
    // Place, first and second derivative over a piece.
    let at = |k: f64| {
        let (sin, cos) = (k * step).sin_cos();
        let (out, along) = (u * cos + w * sin, w * cos - u * sin);
        let r = radii[0] + grown * k;
        let place = centre + out * r + axis * (lifted * k);
        [
            place,
            out * grown + along * (r * step) + axis * lifted,
            along * (2.0 * grown * step) - out * (r * step * step),
        ]
    };
    let pieces = (0..count as usize).map(|k| {
        let [from, until] = [at(k as f64), at((k + 1) as f64)];
        ArcPiece { to: until[0].into(), bend: bend(&from, &until) }
    });
    let mut pieces: Vec<ArcPiece> = pieces.collect();
    if let Some(piece) = pieces.last_mut() {
        piece.to = to;
    }
    Ok(pieces)
}

/// The centre that is as far from both ends.
fn between(from: Vector, chord: Vector, axis: &Vector, radius: f64) -> Result<Vector, String> {
    let half = 0.5 * chord.norm();
    if !(half > 0.0) {
        return Err("an arc by its radius whose ends are the same".into());
    }
    if half > radius.abs() + RADII_MM {
        return Err(format!("the ends of the arc are {:.4} mm apart, its radius is {:.4}", 2.0 * half, radius.abs()));
    }
    let height = (radius * radius - half * half).max(0.0).sqrt() * radius.signum();
    Ok(from + chord * 0.5 + axis.cross(&chord) * (0.5 * height / half))
}

/// The polynomial with place, first and second derivative as they are at both ends.
fn bend(from: &[Vector; 3], to: &[Vector; 3]) -> [[f64; 4]; 3] {
    std::array::from_fn(|i| {
        let ([v0, a0], [v1, a1]) = ([from[1][i], from[2][i]], [to[1][i], to[2][i]]);
        let way = to[0][i] - from[0][i];
        [
            0.5 * a0,
            10.0 * way - 6.0 * v0 - 4.0 * v1 - 1.5 * a0 + 0.5 * a1,
            -15.0 * way + 8.0 * v0 + 7.0 * v1 + 1.5 * a0 - a1,
            6.0 * way - 3.0 * v0 - 3.0 * v1 - 0.5 * a0 + 0.5 * a1,
        ]
    })
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used)]
    use super::*;
    use std::f64::consts::{FRAC_PI_2, PI};

    fn at(pieces: &[ArcPiece], from: [f64; 3], share: f64) -> Vector {
        let k = ((share * pieces.len() as f64) as usize).min(pieces.len() - 1);
        let p = share * pieces.len() as f64 - k as f64;
        let start = if k == 0 { from } else { pieces[k - 1].to };
        Vector::from_fn(|i, _| {
            let way = pieces[k].to[i] - start[i];
            let bent = (2..).zip(pieces[k].bend[i]).map(|(n, a)| a * (p.powi(n) - p)).sum::<f64>();
            start[i] + way * p + bent
        })
    }

    #[test]
    fn polynomials_keep_to_the_arc_at_any_radius_and_angle() {
        for radius in [0.01, 1.0, 37.0, 1000.0, 1e5] {
            for (angle, turns, lift) in
                [(0.3, 0, 0.0), (FRAC_PI_2, 0, 5.0), (PI, 2, -3.0), (TAU, 0, 0.0), (6.0, 1, 0.0)]
            {
                let from = [10.0 + radius, 20.0, 1.0];
                let to = [10.0 + radius * f64::cos(angle), 20.0 + radius * f64::sin(angle), 1.0 + lift];
                let to = if angle == TAU { from } else { to };
                let arc = Arc { centre: Centre::FromStart([-radius, 0.0, 99.0]), axis: [0.0, 0.0, 2.0], turns };
                let pieces = pieces(&arc, from, to).unwrap();
                let sweep = angle + TAU * f64::from(turns);
                for k in 0..=1000 {
                    let share = f64::from(k) / 1000.0;
                    let (sin, cos) = (share * sweep).sin_cos();
                    let want = Vector::new(10.0 + radius * cos, 20.0 + radius * sin, 1.0 + lift * share);
                    let off = (at(&pieces, from, share) - want).norm();
                    let rounding = 1e-14 * radius * sweep;
                    assert!(off <= OFF_MM + rounding, "radius {radius}, angle {angle}, {share}: {off:e}");
                }
            }
        }
    }

    #[test]
    fn a_radius_means_the_shorter_way_and_less_than_zero_the_longer() {
        let (from, to) = ([0.0; 3], [10.0, 0.0, 0.0]);
        let middle = |radius: f64, z: f64| {
            let arc = Arc { centre: Centre::Radius(radius), axis: [0.0, 0.0, z], turns: 0 };
            at(&pieces(&arc, from, to).unwrap(), from, 0.5)
        };
        // Counter-clockwise from left to right goes below, clockwise above.
        let sagitta = 13.0 - 12.0;
        assert!((middle(13.0, 1.0) - Vector::new(5.0, -sagitta, 0.0)).norm() < OFF_MM);
        assert!((middle(13.0, -1.0) - Vector::new(5.0, sagitta, 0.0)).norm() < OFF_MM);
        assert!((middle(-13.0, 1.0) - Vector::new(5.0, -25.0, 0.0)).norm() < OFF_MM);
        assert!((middle(-13.0, -1.0) - Vector::new(5.0, 25.0, 0.0)).norm() < OFF_MM);
        // Half a circle whose radius is rounded down.
        assert!((middle(4.999, 1.0) - Vector::new(5.0, -5.0, 0.0)).norm() < OFF_MM);
    }

    #[test]
    fn what_is_no_arc_is_said() {
        let said = |centre, to, axis| pieces(&Arc { centre, axis, turns: 0 }, [0.0; 3], to).unwrap_err();
        let z = [0.0, 0.0, 1.0];
        for (centre, to, axis, what) in [
            (Centre::Radius(1.0), [10.0, 0.0, 0.0], z, "10.0000 mm apart"),
            (Centre::Radius(1.0), [0.0, 0.0, 5.0], z, "ends are the same"),
            (Centre::FromStart([0.0; 3]), [1.0, 0.0, 0.0], z, "without a radius"),
            (Centre::FromStart([5.0, 0.0, 0.0]), [9.0, 0.0, 0.0], z, "ends 4.0000 mm from it"),
            (Centre::FromStart([5.0, 0.0, 0.0]), [10.0, 0.0, 0.0], [0.0; 3], "axis"),
            (Centre::FromStart([5.0, 0.0, 0.0]), [f64::NAN, 0.0, 0.0], z, "has not said"),
            (Centre::At([1e300, 0.0, 0.0]), [0.0; 3], z, "too long"),
        ] {
            let told = said(centre, to, axis);
            assert!(told.contains(what), "{told}");
        }
    }
}
