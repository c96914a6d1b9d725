//! Axis positions of a tool that stands on a cone of its own.
//!
//! On the cone about the blade axis a position is a function of θ over all turns, whatever came
//! before ([`Machine::inverse`]). On any other cone the rotary axes reach a tool axis in two ways
//! and over many turns: there the way nearest to where they stood is taken, so that they move on
//! without a jump.

use super::Machine;
use super::chain::Held;
use crate::artifact::{Axes, AxisRows, Cone, Stand};
use crate::numerics::series::Series;

/// Rotary axes that turn by more than this from one place to the next go over to the other posture.
const GOES_OVER_RAD: f64 = 0.7;

impl Machine {
    /// Axis positions (mm, rad) of a tool that stands so, those nearest to `near` where several
    /// bring it there; `None`: near 0. `gauge_length_mm` as in [`Machine::inverse`]. Not numbers
    /// where the machine does not reach it.
    pub fn place(&self, stand: &Stand, near: Option<&[f64]>, gauge_length_mm: f64) -> Axes {
        if stand.cone.is_about_blade() {
            return self.inverse(&stand.centre, stand.theta, stand.cone.lean_rad, gauge_length_mm);
        }
        self.linear_at(&stand.centre, &self.turn_to(stand, near), gauge_length_mm)
    }

    /// The rotary axes (rad) where a tool stands so, as [`Machine::place`] has them.
    pub fn turn_to(&self, stand: &Stand, near: Option<&[f64]>) -> Axes {
        if stand.cone.is_about_blade() {
            return self.rotary_of(stand.theta, stand.cone.lean_rad);
        }
        let count = self.axes().len();
        let near = near.map_or(Axes::of_default(count), Axes::from);
        self.rotary_of_axis(&stand.axis(), &near).unwrap_or(Axes::from_fn(count, |_| f64::NAN))
    }

    /// Axis positions along a motion, each nearest to those before it. Of the two ways to reach the
    /// first tool axis that one which turns the rotary axes less along the motion: from the other
    /// they may have to go over to it halfway, where an axis comes to an end of its travel.
    pub fn along(&self, stands: impl IntoIterator<Item = Stand>, gauge_length_mm: f64) -> AxisRows {
        let (head, count) = (self.head(), self.axes().len());
        let stands: Vec<Stand> = stands.into_iter().collect();
        let first = self.first_posture(&stands);
        let mut out = AxisRows::with_capacity(count, stands.len());
        let mut held: Option<Held> = None;
        for stand in stands {
            let lean_rad = stand.cone.lean_rad;
            if stand.cone.is_about_blade() && !held.as_ref().is_some_and(|h| h.is_at(lean_rad)) {
                held = head.held(lean_rad, gauge_length_mm);
            }
            if let Some(held) = held.as_ref().filter(|_| stand.cone.is_about_blade()) {
                let mut row = Axes::of_default(count);
                head.place_held(&stand.centre, stand.theta, held, &mut row);
                out.push(&row);
            } else {
                let last = out.len().checked_sub(1).and_then(|k| out.get(k)).or(first.as_deref());
                let placed = self.place(&stand, last, gauge_length_mm);
                out.push(&placed);
            }
        }
        out
    }

    /// Where the rotary axes best stand before a motion; `None`: near 0, or the motion begins on
    /// the cone about the blade axis.
    fn first_posture(&self, stands: &[Stand]) -> Option<Axes> {
        let first = stands.first().filter(|s| !s.cone.is_about_blade())?;
        let rotary: Vec<usize> = self.rotary().collect();
        // How far they turn from there, and how far at most at once.
        let way = |from: &[f64]| {
            let mut last = self.turn_to(first, Some(from));
            let (mut sum, mut most) = (0.0, 0.0f64);
            for stand in &stands[1..] {
                let next = self.turn_to(stand, Some(&last[..]));
                let turned: f64 = rotary.iter().map(|k| (next[*k] - last[*k]).abs()).sum();
                (sum, most, last) = (sum + turned, most.max(turned), next);
            }
            (sum, most)
        };
        let near = self.turn_to(first, None);
        let (sum, most) = way(&near[..]);
        if most < GOES_OVER_RAD {
            return None;
        }
        let other = self.head().other_posture(&first.axis(), &near[..])?;
        (way(&other[..]).0 < sum).then_some(other)
    }

    /// Axis positions as power series of a parameter, one for each axis, from those of the ball
    /// centre (blade frame, mm) and of θ (rad) on one cone. `at`: where the axes stand at parameter
    /// 0, of which the rotary ones are taken ([`Machine::along`]). `None` where the linear axes do
    /// not reach all places. Terms of the axes follow from those given without differencing.
    pub fn along_series(
        &self,
        centre: &[Series; 3],
        theta: Series,
        cone: &Cone,
        at: &[f64],
        gauge_length_mm: f64,
    ) -> Option<Vec<Series>> {
        let head = self.head();
        let (sin, cos) = theta.sin_cos();
        let (sb, cb) = cone.lean_rad.sin_cos();
        let (c, e) = (cone.axis, cone.reference);
        let f = c.cross(&e);
        let axis = std::array::from_fn(|k| Series::constant(c[k] * sb) + cos.scaled(e[k] * cb) + sin.scaled(f[k] * cb));
        let rotary: Vec<usize> = head.rotary().collect();
        let stands = [rotary.first(), rotary.get(1)].map(|k| k.and_then(|k| at.get(*k)).copied().unwrap_or(0.0));
        let [x, y, z, q1, q2] = head.series(centre, &axis, stands, gauge_length_mm)?;
        let mut out: Vec<Series> = at.iter().map(|v| Series::constant(*v)).collect();
        let columns = head.linear().into_iter().chain(rotary).zip([x, y, z, q1, q2]);
        columns.for_each(|(k, s)| out[k] = s);
        Some(out)
    }
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used)]
    use super::*;
    use crate::geometry::Point;

    fn value(s: &Series, t: f64) -> f64 {
        s.0.iter().rev().fold(0.0, |sum, c| sum * t + c)
    }

    /// On every machine that comes with the program, tables and heads, four axes and five at once.
    #[test]
    fn series_are_the_axes_along_a_curve() {
        let folder = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("models/machines");
        let mut files: Vec<_> = std::fs::read_dir(folder).unwrap().map(|e| e.unwrap().path()).collect();
        files.sort();
        let (mut seen, mut moving) = (0, 0);
        for file in files {
            let machine = Machine::from_toml(&std::fs::read_to_string(&file).unwrap(), "test").unwrap();
            for lean_rad in [0.0, 0.2] {
                if !machine.leans(lean_rad) {
                    continue;
                }
                let cone = Cone::about_blade(lean_rad);
                let centre = [
                    Series([40.0, 0.3, 0.05, -0.02, 0.01, 0.003]),
                    Series([9.0, -0.8, -0.06, 0.03, 0.02, -0.01]),
                    Series([-4.0, 0.5, 0.1, 0.02, -0.03, 0.02]),
                ];
                let theta = Series([0.7, 0.2, 0.1, -0.05, 0.03, 0.02]);
                let stand =
                    |t: f64| Stand::about_blade(Point::from(centre.map(|s| value(&s, t))), value(&theta, t), lean_rad);
                let at = machine.place(&stand(0.0), None, 150.0);
                let series = machine.along_series(&centre, theta, &cone, &at, 150.0).unwrap();
                for t in [-0.02, 0.01, 0.02f64] {
                    let want = machine.place(&stand(t), Some(&at), 150.0);
                    for (k, s) in series.iter().enumerate() {
                        let off = (value(s, t) - want[k]).abs();
                        assert!(off < 2e3 * t.abs().powi(6) + 1e-11, "{} axis {k} at {t}: {off}", file.display());
                    }
                }
                let rotary = machine.rotary().filter(|k| series[*k].0[1] != 0.0).count();
                (seen, moving) = (seen + 1, moving + usize::from(rotary > 1));
            }
        }
        assert!(seen > 5, "{seen} {moving}");
    }
}
