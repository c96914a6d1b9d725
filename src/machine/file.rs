//! Reading machine files, their checks, and what follows from the file alone.

use super::chain::Chain;
use super::config::{AxisLimits, AxisName, DEMO_TOML, Machine, Provenance, RotaryAxis};
use crate::error::{Error, Result, Stage};

impl Machine {
    /// The built-in demo machine ([`DEMO_TOML`]).
    ///
    /// # Errors
    /// As [`Machine::from_toml`]; the built-in file passes.
    pub fn demo() -> Result<Self> {
        Self::from_toml(DEMO_TOML, "built-in demo machine")
    }

    /// Reads a machine from the text of its file; `origin` names the file in messages.
    ///
    /// # Errors
    /// Kind `Usage`: not TOML, an unknown or missing key, or a value outside its range.
    pub fn from_toml(text: &str, origin: &str) -> Result<Self> {
        let machine: Machine = toml::from_str(text).map_err(|e| {
            let place = e.span().map(|s| {
                let before = text.get(..s.start).unwrap_or(text);
                format!(" line {}", before.matches('\n').count() + 1)
            });
            Error::usage(Stage::Machine, format!("{origin}{}: {}", place.unwrap_or_default(), e.message()))
                .advise("models/machines/demo_table_head.toml shows every key with its unit")
        })?;
        machine.validate(origin)?;
        Ok(machine)
    }

    /// The rotary axes: first the one nearest to the workpiece. The second is missing on a machine of four axes.
    pub fn rotary_axes(&self) -> [Option<AxisName>; 2] {
        if self.chain.is_empty() {
            return [Some(AxisName::A), Some(AxisName::B)];
        }
        let mut turns = self.chain.iter().copied().filter(|n| n.linear().is_none());
        [turns.next(), turns.next()]
    }

    /// Letters of the axes, in the order of the arrays of [`crate::artifact::AxisMotion`]: X, Y, Z, the rotary axis nearest to the workpiece, the
    /// other one. Where there is no other one: a letter that is free, for an axis that stands at 0.
    pub fn axis_names(&self) -> [&'static str; 5] {
        let [first, second] = self.rotary_axes();
        let first = first.unwrap_or(AxisName::A);
        let free = if first == AxisName::B { AxisName::A } else { AxisName::B };
        ["X", "Y", "Z", first.letter(), second.unwrap_or(free).letter()]
    }

    /// Limits of all axes in the order of [`Machine::axis_names`]. An axis that is not there has no ends of travel.
    pub fn limits(&self) -> [AxisLimits; 5] {
        let a = &self.axes;
        let [first, second] =
            self.rotary_axes().map(|n| n.and_then(|n| a.rotary(n)).map_or(NO_AXIS, RotaryAxis::limits));
        [a.x.limits(), a.y.limits(), a.z.limits(), first, second]
    }

    /// Letters of the axes whose velocity, acceleration and jerk are assumed, not measured.
    pub fn assumed_limits(&self) -> Vec<&'static str> {
        let a = &self.axes;
        let linear = [("X", a.x.limits), ("Y", a.y.limits), ("Z", a.z.limits)].map(Some);
        let rotary = self.rotary_axes().map(|n| n.and_then(|n| Some((n.letter(), a.rotary(n)?.limits))));
        let all = linear.into_iter().chain(rotary).flatten();
        all.filter(|(_, from)| *from == Provenance::Assumed).map(|(letter, _)| letter).collect()
    }

    /// The same machine with velocity, acceleration and jerk of all axes multiplied by `factor` (for sweeps over
    /// assumed limits).
    #[must_use]
    pub fn with_limits_scaled(mut self, factor: f64) -> Self {
        let a = &mut self.axes;
        for l in [&mut a.x, &mut a.y, &mut a.z] {
            l.velocity_mm_s *= factor;
            l.acceleration_mm_s2 *= factor;
            l.jerk_mm_s3 *= factor;
        }
        for r in [&mut a.a, &mut a.b, &mut a.c].into_iter().flatten() {
            r.velocity_deg_s *= factor;
            r.acceleration_deg_s2 *= factor;
            r.jerk_deg_s3 *= factor;
        }
        self
    }

    /// Checks all values; see [`Machine::from_toml`].
    fn validate(&self, origin: &str) -> Result<()> {
        self.numbers(origin)?;
        self.travels(origin)?;
        if self.chain.is_empty() { self.table_and_head(origin) } else { self.links(origin) }
    }

    fn numbers(&self, origin: &str) -> Result<()> {
        let mut all = vec![("mount.clamping_deg", self.mount.clamping_deg)];
        all.extend(self.mount.offset_mm.map(|v| ("mount.offset_mm", v)));
        all.extend(self.mount.along.into_iter().flatten().map(|v| ("mount.along", v)));
        if let (Some(t), Some(h)) = (&self.table, &self.head) {
            all.extend([("table.axis_y_mm", t.axis_y_mm), ("table.axis_z_mm", t.axis_z_mm)]);
            all.push(("head.spindle_offset_mm", h.spindle_offset_mm));
        }
        if let Some(s) = &self.spindle {
            all.extend(s.gauge_mm.map(|v| ("spindle.gauge_mm", v)));
            all.extend(s.direction.map(|v| ("spindle.direction", v)));
        }
        for r in [&self.axes.a, &self.axes.b, &self.axes.c].into_iter().flatten() {
            all.extend(r.direction.into_iter().flatten().map(|v| ("direction of a rotary axis", v)));
            all.extend(r.point_mm.into_iter().flatten().map(|v| ("point_mm of a rotary axis", v)));
        }
        for k in 0..3 {
            all.extend(self.axes.linear(k).direction.into_iter().flatten().map(|v| ("direction of a linear axis", v)));
        }
        if let Some((key, v)) = all.into_iter().find(|(_, v)| !v.is_finite()) {
            return bad(origin, format!("{key} is {v}, it must be a finite number"));
        }
        if let Some(h) = &self.head
            && !(h.pivot_length_mm >= 0.0 && h.pivot_length_mm.is_finite())
        {
            return bad(origin, format!("head.pivot_length_mm is {}, it must be at least 0", h.pivot_length_mm));
        }
        if !(self.swing_diameter_mm > 0.0 && self.swing_diameter_mm.is_finite()) {
            return bad(origin, format!("swing_diameter_mm is {}, it must be greater than 0", self.swing_diameter_mm));
        }
        Ok(())
    }

    fn travels(&self, origin: &str) -> Result<()> {
        let axes = [("a", &self.axes.a), ("b", &self.axes.b), ("c", &self.axes.c)];
        for (axis, r) in axes.into_iter().filter_map(|(n, r)| r.as_ref().map(|r| (n, r))) {
            if r.min_deg.is_some() != r.max_deg.is_some() {
                return bad(origin, format!("axes.{axis} has only one of min_deg and max_deg, give both or none"));
            }
        }
        for (name, l) in self.axis_names().iter().zip(self.limits()) {
            let key = format!("axes.{}", name.to_lowercase());
            for (what, v) in [("velocity", l.velocity), ("acceleration", l.acceleration), ("jerk", l.jerk)] {
                if !(v > 0.0 && v.is_finite()) {
                    return bad(origin, format!("{key}: {what} is {v}, it must be greater than 0"));
                }
            }
            if let Some([lo, hi]) = l.travel
                && !(lo < hi && lo.is_finite() && hi.is_finite())
            {
                return bad(origin, format!("{key}: its least position is not below its greatest"));
            }
        }
        Ok(())
    }

    /// A machine without a chain.
    fn table_and_head(&self, origin: &str) -> Result<()> {
        let a = &self.axes;
        if self.table.is_none() || self.head.is_none() {
            return bad(origin, "it has neither [table] and [head] nor a chain of axes".into());
        }
        if a.a.is_none() || a.b.is_none() || a.c.is_some() {
            return bad(origin, "a machine without a chain has the rotary axes [axes.a] and [axes.b]".into());
        }
        let placed = [&a.a, &a.b].into_iter().flatten().any(|r| r.direction.is_some() || r.point_mm.is_some());
        if placed
            || (0..3).any(|k| a.linear(k).direction.is_some())
            || self.mount.along.is_some()
            || self.spindle.is_some()
        {
            return bad(origin, "direction, point_mm, mount.along and [spindle] are for machines with a chain".into());
        }
        match self.limits()[4].travel {
            Some([lo, hi]) if lo.to_degrees() >= -89.9 && hi.to_degrees() <= 89.9 => Ok(()),
            _ => bad(origin, "axes.b must be limited to -89.9 … 89.9 degrees: at 90 the tool axis is along X".into()),
        }
    }

    /// A machine with a chain.
    fn links(&self, origin: &str) -> Result<()> {
        if self.table.is_some() || self.head.is_some() {
            return bad(origin, "it has both a chain and [table] or [head]".into());
        }
        for (k, name) in self.chain.iter().enumerate() {
            if self.chain[..k].contains(name) {
                return bad(origin, format!("the chain has axis {} twice", name.letter()));
            }
        }
        let count = |linear: bool| self.chain.iter().filter(|n| n.linear().is_some() == linear).count();
        if count(true) != 3 || !(1..=2).contains(&count(false)) {
            return bad(origin, "a chain has X, Y, Z and one or two of A, B, C".into());
        }
        for name in [AxisName::A, AxisName::B, AxisName::C] {
            let key = name.letter().to_lowercase();
            if self.chain.contains(&name) != self.axes.rotary(name).is_some() {
                return bad(
                    origin,
                    format!("axis {} must be in the chain and have a table [axes.{key}]", name.letter()),
                );
            }
        }
        match Chain::of(self) {
            None => bad(origin, "a direction of an axis, of the spindle or of mount.along is no direction".into()),
            Some(chain) if !chain.spans_space() => {
                bad(origin, "X, Y and Z do not reach all places: their directions lie in a plane".into())
            }
            Some(_) => Ok(()),
        }
    }
}

fn bad<T>(origin: &str, what: String) -> Result<T> {
    Err(Error::usage(Stage::Machine, format!("{origin}: {what}")))
}

/// An axis that is not there: it stands still.
const NO_AXIS: AxisLimits =
    AxisLimits { travel: None, velocity: 1.0, acceleration: 1.0, jerk: 1.0, provenance: Provenance::Measured };

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used)]
    use super::*;
    use crate::error::ErrorKind;

    #[test]
    fn the_demo_machine_reads_and_round_trips() {
        let m = Machine::demo().unwrap();
        let again = Machine::from_toml(&toml::to_string(&m).unwrap(), "again").unwrap();
        assert_eq!(m, again);
        let l = m.limits();
        assert_eq!(l[3].travel, None);
        assert!((l[4].travel.unwrap()[1].to_degrees() - 87.0).abs() < 1e-12);
        assert!(l.iter().all(|l| l.provenance == Provenance::Assumed));
        assert_eq!(l[0].travel, Some([0.0, 2800.0]));
        assert_eq!(m.with_limits_scaled(0.5).limits()[1].velocity, 0.5 * l[1].velocity);
    }

    #[test]
    fn bad_files_are_usage_errors_that_name_the_key() {
        let cases = [
            ("pivot_length_mm = 200.0", "pivot_length_mm = -1.0", "pivot_length_mm"),
            ("pivot_length_mm = 200.0", "pivot_length = 200.0", "pivot_length"),
            ("spindle_offset_mm = 0.0", "spindle_offset_mm = inf", "head.spindle_offset_mm"),
            ("positive_b_leans = \"plus-x\"", "positive_b_leans = \"up\"", "up"),
            ("velocity_deg_s = 180.0", "velocity_deg_s = 0.0", "axes.a: velocity"),
            ("max_deg = 87.0", "max_deg = 90.0", "axes.b"),
            ("max_deg = 87.0", "", "only one of"),
            ("max_mm = 330.0", "max_mm = -400.0", "axes.y"),
            ("offset_mm = [1400.0", "offset_mm = [nan", "offset_mm"),
            ("limits = \"assumed\"\n\n[axes.y]", "limits = \"guessed\"\n\n[axes.y]", "guessed"),
        ];
        for (from, to, names) in cases {
            let text = DEMO_TOML.replacen(from, to, 1);
            assert_ne!(text, DEMO_TOML, "{from}");
            let e = Machine::from_toml(&text, "m.toml").unwrap_err();
            assert_eq!(e.kind, ErrorKind::Usage);
            assert!(e.message.contains(names) && e.message.contains("m.toml"), "{}", e.message);
        }
    }
}
