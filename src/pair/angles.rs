//! Sets of angles on a circle.

use std::f64::consts::{PI, TAU};

/// Angles from 0 to a whole turn: closed arcs `[from, to]`, rad, rising, apart from each other,
/// none across 0; what goes over 0 is two arcs.
#[derive(Clone, Debug, Default, PartialEq, serde::Serialize)]
pub struct FreeAngles(Vec<[f64; 2]>);

impl FreeAngles {
    /// All angles.
    pub fn all() -> Self {
        FreeAngles(vec![[0.0, TAU]])
    }

    /// Those of intervals `from ..= to`, rad, on any turn. An interval of a turn or more is all
    /// angles; one with `to < from`, or that is no number, is none.
    pub fn of(intervals: impl IntoIterator<Item = [f64; 2]>) -> Self {
        let mut arcs = Vec::new();
        for [from, to] in intervals {
            if to - from >= TAU {
                return Self::all();
            }
            if !(to >= from) {
                continue;
            }
            let low = from.rem_euclid(TAU);
            let high = low + (to - from);
            if high > TAU {
                arcs.extend([[low, TAU], [0.0, high - TAU]]);
            } else {
                arcs.push([low, high]);
            }
        }
        arcs.sort_by(|a, b| a[0].total_cmp(&b[0]));
        let mut joined: Vec<[f64; 2]> = Vec::with_capacity(arcs.len());
        for arc in arcs {
            match joined.last_mut().filter(|last| arc[0] <= last[1]) {
                Some(last) => last[1] = last[1].max(arc[1]),
                None => joined.push(arc),
            }
        }
        FreeAngles(joined)
    }

    /// Its arcs, rad.
    pub fn arcs(&self) -> &[[f64; 2]] {
        &self.0
    }

    /// No angle is free.
    pub fn is_empty(&self) -> bool {
        self.0.is_empty()
    }

    /// The same turned on by an angle, rad.
    #[must_use]
    pub fn turned(&self, by_rad: f64) -> Self {
        Self::of(self.0.iter().map(|arc| arc.map(|v| v + by_rad)))
    }

    /// The angles of both.
    #[must_use]
    pub fn and(&self, other: &Self) -> Self {
        let (mut a, mut b, mut out) = (0, 0, Vec::new());
        while let (Some(one), Some(two)) = (self.0.get(a), other.0.get(b)) {
            let (from, to) = (one[0].max(two[0]), one[1].min(two[1]));
            if from <= to {
                out.push([from, to]);
            }
            if one[1] < two[1] { a += 1 } else { b += 1 }
        }
        FreeAngles(out)
    }

    /// Whether it has this angle, on any turn, rad.
    pub fn has(&self, angle_rad: f64) -> bool {
        self.margin(angle_rad) >= 0.0
    }

    /// How far an angle lies from the nearest that is not free, rad; negative: how far from the
    /// nearest that is; ∞ where all are free, −∞ where none is.
    pub fn margin(&self, angle_rad: f64) -> f64 {
        let at = angle_rad.rem_euclid(TAU);
        let over_0 = self.is_over_0();
        match self.0[..] {
            [] => return f64::NEG_INFINITY,
            [[from, to]] if over_0 && to - from >= TAU => return f64::INFINITY,
            _ => {}
        }
        let inside = |[from, to]: [f64; 2]| {
            // What ends at 0 goes on behind it.
            let below = match over_0 && from == 0.0 {
                true => at + TAU - self.0.last().map_or(0.0, |last| last[0]),
                false => at - from,
            };
            let above = match over_0 && to == TAU {
                true => TAU - at + self.0.first().map_or(0.0, |first| first[1]),
                false => to - at,
            };
            below.min(above)
        };
        let apart = |[from, to]: [f64; 2]| {
            let to_angle = |end: f64| {
                let way = (at - end).rem_euclid(TAU);
                way.min(TAU - way)
            };
            to_angle(from).min(to_angle(to))
        };
        match self.0.iter().find(|arc| arc[0] <= at && at <= arc[1]) {
            Some(arc) => inside(*arc),
            None => -self.0.iter().map(|arc| apart(*arc)).fold(f64::INFINITY, f64::min),
        }
    }

    /// Width of its widest arc, rad, arcs on both sides of 0 taken as one.
    pub fn widest(&self) -> f64 {
        let own = self.0.iter().map(|[from, to]| to - from).fold(0.0, f64::max);
        match self.0[..] {
            [first, .., last] if self.is_over_0() => own.max(first[1] - first[0] + last[1] - last[0]),
            _ => own,
        }
    }

    /// The ends of the arc that has an angle, rad, on the turn of that angle; half a turn to either
    /// side where all are free, the angle itself where none has it.
    pub fn around(&self, angle_rad: f64) -> [f64; 2] {
        let at = angle_rad.rem_euclid(TAU);
        let Some([from, to]) = self.0.iter().find(|arc| arc[0] <= at && at <= arc[1]).copied() else {
            return [angle_rad; 2];
        };
        let (mut below, mut above) = (at - from, to - at);
        if self.is_over_0() {
            if self.0.len() == 1 {
                return [angle_rad - PI, angle_rad + PI];
            }
            if from == 0.0 {
                below += self.0.last().map_or(0.0, |last| TAU - last[0]);
            }
            if to == TAU {
                above += self.0.first().map_or(0.0, |first| first[1]);
            }
        }
        [angle_rad - below, angle_rad + above]
    }

    /// Middles of its arcs, rad, arcs on both sides of 0 taken as one.
    pub fn middles(&self) -> Vec<f64> {
        self.over_0().iter().map(|[from, to]| (0.5 * (from + to)).rem_euclid(TAU)).collect()
    }

    /// Its arcs, rad, those on both sides of 0 taken as one, which then begins below 0; all angles
    /// are from −∞ to ∞.
    pub fn joined(&self) -> Vec<[f64; 2]> {
        match self.margin(0.0) == f64::INFINITY {
            true => vec![[f64::NEG_INFINITY, f64::INFINITY]],
            false => self.over_0(),
        }
    }

    fn over_0(&self) -> Vec<[f64; 2]> {
        let mut arcs = self.0.clone();
        if self.is_over_0()
            && arcs.len() > 1
            && let Some(last) = arcs.pop()
        {
            arcs[0][0] = last[0] - TAU;
        }
        arcs
    }

    /// Whether 0 is amid free angles.
    fn is_over_0(&self) -> bool {
        matches!((self.0.first(), self.0.last()), (Some(first), Some(last)) if first[0] == 0.0 && last[1] == TAU)
    }
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used)]
    use proptest::prelude::*;

    use super::*;

    fn intervals() -> impl Strategy<Value = Vec<[f64; 2]>> {
        prop::collection::vec((-20.0f64..20.0, 0.0f64..3.0), 0..5)
            .prop_map(|all| all.into_iter().map(|(from, width)| [from, from + width]).collect())
    }

    proptest! {
        /// Against the intervals themselves, on all turns.
        #[test]
        fn has_and_margin_are_those_of_the_intervals(a in intervals(), b in intervals(), at in -9.0f64..9.0, by in -9.0f64..9.0) {
            let has = |list: &[[f64; 2]], at: f64| {
                list.iter().any(|[from, to]| (-8..8).any(|k| *from <= at + f64::from(k) * TAU && at + f64::from(k) * TAU <= *to))
            };
            let (one, two) = (FreeAngles::of(a.clone()), FreeAngles::of(b.clone()));
            prop_assert_eq!(one.has(at), has(&a, at));
            prop_assert_eq!(one.and(&two).has(at), has(&a, at) && has(&b, at));
            let turned = one.turned(by);
            // Rounding may move an end.
            if turned.margin(at).abs() > 1e-9 {
                prop_assert_eq!(turned.has(at), has(&a, at - by));
            }
            let margin = one.margin(at);
            if margin.is_finite() {
                // Just inside it the answer is the same, just beyond it is the other.
                let near = [-1.0, 1.0].map(|s| at + s * (margin.abs() - 1e-9).max(0.0));
                let far = [-1.0, 1.0].map(|s| at + s * (margin.abs() + 1e-9));
                prop_assert!(near.iter().all(|v| one.has(*v) == one.has(at)), "{one:?} {at} {margin}");
                prop_assert!(far.iter().any(|v| one.has(*v) != one.has(at)), "{one:?} {at} {margin}");
            }
            prop_assert!(one.arcs().windows(2).all(|w| w[0][1] < w[1][0]));
            for middle in one.middles() {
                prop_assert!(one.has(middle) && one.margin(middle) <= 0.5 * one.widest() + 1e-9 || one.margin(middle) == f64::INFINITY);
            }
        }
    }

    #[test]
    fn arcs_over_0_are_one() {
        let free = FreeAngles::of([[-0.5, 0.7]]);
        assert_eq!(free.arcs().len(), 2);
        assert!((free.widest() - 1.2).abs() < 1e-12 && (free.middles()[0] - 0.1).abs() < 1e-12);
        assert!((free.margin(0.0) - 0.5).abs() < 1e-12 && (free.margin(-0.1) - 0.4).abs() < 1e-12);
        assert!((free.margin(1.0) + 0.3).abs() < 1e-12);
        let [from, to] = free.around(TAU + 0.2);
        assert!((from - TAU + 0.5).abs() < 1e-12 && (to - TAU - 0.7).abs() < 1e-12);
        let [from, to] = free.around(-0.2);
        assert!((from + 0.5).abs() < 1e-12 && (to - 0.7).abs() < 1e-12);
        assert_eq!(FreeAngles::of([[0.0, 7.0]]), FreeAngles::all());
        assert_eq!(FreeAngles::all().margin(3.0), f64::INFINITY);
        assert_eq!(FreeAngles::all().around(7.0), [7.0 - PI, 7.0 + PI]);
        assert_eq!(FreeAngles::of([[0.0, 1.0]]).around(3.0), [3.0; 2]);
        assert_eq!(FreeAngles::default().margin(3.0), f64::NEG_INFINITY);
        assert!(FreeAngles::of([[f64::NAN, 1.0], [2.0, 1.0]]).is_empty());
    }
}
