//! Machine files: reading, their checks, and the machine that is built from one.

use nalgebra::{Unit, UnitQuaternion};

use super::Machine;
use super::axis::{Axis, AxisLimits, AxisName, Carries};
use super::chain::Head;
use super::config::{DEMO_TOML, LinearAxis, MachineFile, PositiveA, PositiveB, RotaryAxis, Spindle, Words, brought};
use crate::error::{Error, Result, Stage};
use crate::geometry::{Point, Rigid, Vector};
use crate::settings::from_toml;

/// Positions of an axis that the machine has not are 0 but for rounding, mm.
const MISSING_MM: f64 = 1e-6;

impl Machine {
    /// The built-in demo machine ([`DEMO_TOML`]).
    ///
    /// # Errors
    /// As [`Machine::from_toml`]; the built-in file passes.
    pub fn demo() -> Result<Self> {
        Self::from_toml(DEMO_TOML, "built-in demo machine")
    }

    /// Builds the machine of a file's text; `origin` names the file in messages.
    ///
    /// # Errors
    /// Kind `Usage`: not TOML, an unknown or missing key, or a value outside its range.
    pub fn from_toml(text: &str, origin: &str) -> Result<Self> {
        MachineFile::from_toml(text, origin)?.build(origin)
    }
}

impl MachineFile {
    /// What a text says; [`MachineFile::build`] judges the values. `origin` names the file in
    /// messages.
    ///
    /// # Errors
    /// Kind `Usage`: not TOML, an unknown or missing key.
    pub fn from_toml(text: &str, origin: &str) -> Result<Self> {
        from_toml(text).map_err(|e| {
            let place = e.line.map(|n| format!(" line {n}")).unwrap_or_default();
            Error::usage(Stage::Machine, format!("{origin}{place}: {}", e.words))
                .advise("models/machines/demo_table_head.toml shows every key with its unit")
        })
    }

    /// The machine that the file describes; `origin` names the file in messages.
    ///
    /// # Errors
    /// Kind `Usage`: a value outside its range, axes that are no chain.
    pub fn build(&self, origin: &str) -> Result<Machine> {
        self.numbers(origin)?;
        self.travels(origin)?;
        if self.chain.is_empty() {
            self.table_and_head(origin)?;
            return self.as_chain().assembled(origin, "table.positive_a_turns");
        }
        self.links(origin)?;
        self.assembled(origin, "its direction")
    }

    /// A table about X and a pivoting head, written as a chain. A file that has a chain stays as it
    /// is.
    fn as_chain(&self) -> MachineFile {
        let mut out = self.clone();
        let (Some(table), Some(head)) = (out.table.take(), out.head.take()) else { return out };
        out.chain = vec![AxisName::A, AxisName::X, AxisName::Y, AxisName::Z, AxisName::B];
        if let Some(a) = &mut out.axes.a {
            let sense = if table.positive_a_turns == PositiveA::Tool { 1.0 } else { -1.0 };
            a.direction = Some([sense, 0.0, 0.0]);
            a.point_mm = Some([0.0, table.axis_y_mm, table.axis_z_mm]);
        }
        if let Some(b) = &mut out.axes.b {
            let sense = if head.positive_b_leans == PositiveB::PlusX { 1.0 } else { -1.0 };
            b.direction = Some([0.0, sense, 0.0]);
            b.point_mm = Some([-head.spindle_offset_mm, 0.0, head.pivot_length_mm]);
        }
        out
    }

    /// Letters of the axes in the order of the machine's columns: X, Y, Z, the rotary axes from the
    /// workpiece, and the second head's own.
    fn letters(&self) -> impl Iterator<Item = AxisName> {
        let own = self.second.iter().flat_map(|s| s.chain.iter().copied()).filter(|n| !self.chain.contains(n));
        let table_and_head = [AxisName::A, AxisName::B];
        let chain = if self.chain.is_empty() { &table_and_head[..] } else { &self.chain };
        let rotary = chain.iter().copied().filter(|n| n.linear().is_none()).collect::<Vec<_>>();
        AxisName::LINEAR.into_iter().chain(rotary).chain(own)
    }

    /// Limits of an axis; `None`: the file has no table for it.
    fn limits(&self, letter: AxisName) -> Option<AxisLimits> {
        let linear = self.axes.linear(letter).map(LinearAxis::limits);
        linear.or_else(|| self.axes.rotary(letter).map(RotaryAxis::limits))
    }

    /// Limits of a linear axis that the machine has not: those of the first that it has, at 0.
    fn limits_of_missing(&self) -> Option<AxisLimits> {
        let there = AxisName::LINEAR.into_iter().find_map(|n| self.limits(n))?;
        Some(AxisLimits { travel: Some([-MISSING_MM, MISSING_MM]), ..there })
    }

    /// The axis of a letter; `None`: its direction is none. `carries`: see [`carried`].
    fn axis(&self, letter: AxisName, carries: Carries, sense_key: &'static str) -> Option<Axis> {
        let (linear, rotary) = (self.axes.linear(letter), self.axes.rotary(letter));
        let direction = linear.and_then(|l| l.direction).or_else(|| rotary.and_then(|r| r.direction));
        let is_missing = linear.is_none() && rotary.is_none();
        Some(Axis {
            name: letter.letter().into(),
            letter,
            direction: Unit::try_new(Vector::from(direction.unwrap_or_else(|| letter.unit())), 1e-9)?,
            point: Point::from(rotary.and_then(|r| r.point_mm).unwrap_or([0.0; 3])),
            carries,
            limits: if is_missing { self.limits_of_missing()? } else { self.limits(letter)? },
            is_missing,
            counts_diameter: linear.is_some_and(|l| l.words == Words::Diameter),
            sense_key,
        })
    }

    /// The machine of a chain; `sense_key` says where the file has the senses of rotary axes.
    fn assembled(&self, origin: &str, sense_key: &'static str) -> Result<Machine> {
        let no_direction =
            || bad(origin, "a direction of an axis, of the spindle or of mount.along is no direction".into());
        let of_second =
            |letter: AxisName| self.second.is_some() && !self.chain.contains(&letter) && self.axes.has(letter);
        let carries = |letter: AxisName| match of_second(letter) {
            true => Carries::Head(1),
            false => carried(&self.chain, letter),
        };
        let axes: Option<Vec<Axis>> = self.letters().map(|n| self.axis(n, carries(n), sense_key)).collect();
        let (Some(axes), Some(mount), Some(spindle)) =
            (axes, self.blade_on_machine(), placed(self.spindle.unwrap_or_default()))
        else {
            return no_direction();
        };
        let column = |letter: &AxisName| axes.iter().position(|a| a.letter == *letter);
        // An axis that never moves may stand anywhere in the chain: it carries the tool.
        let missing = axes.iter().filter(|a| a.is_missing).map(|a| &a.letter);
        let links: Vec<usize> = self.chain.iter().chain(missing).filter_map(column).collect();
        let Some(head) = Head::new(&axes, &links, spindle, mount) else { return no_direction() };
        if !head.spans_space() {
            return bad(origin, "X, Y and Z do not reach all places: their directions lie in a plane".into());
        }
        let mut heads = vec![head];
        if let Some(second) = &self.second {
            let links: Vec<usize> = second.chain.iter().filter_map(column).collect();
            let head = placed(second.spindle).and_then(|s| Head::new(&axes, &links, s, mount));
            let Some(head) = head else { return no_direction() };
            if !head.spans_space() {
                return bad(origin, "U, V and W do not reach all places: their directions lie in a plane".into());
            }
            heads.push(head);
        }
        let (name, mount) = (self.name.clone(), self.mount);
        Ok(Machine { name, swing_diameter_mm: self.swing_diameter_mm, mount, axes, heads })
    }

    /// Blade frame to machine coordinates while all axes read 0; `None`: the blade points nowhere.
    fn blade_on_machine(&self) -> Option<Rigid> {
        let along = Vector::from(self.mount.along.unwrap_or([1.0, 0.0, 0.0])).try_normalize(1e-9)?;
        let clamped = UnitQuaternion::from_axis_angle(&Vector::x_axis(), self.mount.clamping_deg.to_radians());
        Some(Rigid::from_parts(Vector::from(self.mount.offset_mm).into(), brought(&along) * clamped))
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
        if let Some(s) = &self.second {
            all.extend(s.spindle.gauge_mm.map(|v| ("second.spindle.gauge_mm", v)));
            all.extend(s.spindle.direction.map(|v| ("second.spindle.direction", v)));
        }
        for l in AxisName::LINEAR.into_iter().chain(AxisName::SECOND).filter_map(|n| self.axes.linear(n)) {
            all.extend(l.direction.into_iter().flatten().map(|v| ("direction of a linear axis", v)));
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
        for (letter, l) in self.letters().filter_map(|n| Some((n, self.limits(n)?))) {
            let key = format!("axes.{}", letter.letter().to_lowercase());
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

    /// Checks a file without a chain.
    fn table_and_head(&self, origin: &str) -> Result<()> {
        let a = &self.axes;
        if self.table.is_none() || self.head.is_none() {
            return bad(origin, "it has neither [table] and [head] nor a chain of axes".into());
        }
        if a.a.is_none() || a.b.is_none() || a.c.is_some() {
            return bad(origin, "a machine without a chain has the rotary axes [axes.a] and [axes.b]".into());
        }
        if let Some(name) = AxisName::LINEAR.into_iter().find(|n| !a.has(*n)) {
            let key = name.letter().to_lowercase();
            return bad(
                origin,
                format!("[axes.{key}] is missing; only a machine with a chain may be without {}", name.letter()),
            );
        }
        let placed = [&a.a, &a.b].into_iter().flatten().any(|r| r.direction.is_some() || r.point_mm.is_some());
        if placed
            || AxisName::LINEAR.into_iter().filter_map(|n| a.linear(n)).any(|l| l.direction.is_some())
            || self.mount.along.is_some()
            || self.spindle.is_some()
            || self.second.is_some()
        {
            return bad(
                origin,
                "direction, point_mm, mount.along, [spindle] and [second] are for machines with a chain".into(),
            );
        }
        match a.b.and_then(|b| b.limits().travel) {
            Some([lo, hi]) if lo.to_degrees() >= -89.9 && hi.to_degrees() <= 89.9 => Ok(()),
            _ => bad(origin, "axes.b must be limited to -89.9 … 89.9 degrees: at 90 the tool axis is along X".into()),
        }
    }

    /// Checks a file with a chain.
    fn links(&self, origin: &str) -> Result<()> {
        if self.table.is_some() || self.head.is_some() {
            return bad(origin, "it has both a chain and [table] or [head]".into());
        }
        for (k, name) in self.chain.iter().enumerate() {
            if self.chain[..k].contains(name) {
                return bad(origin, format!("the chain has axis {} twice", name.letter()));
            }
        }
        if self.chain.iter().any(|n| AxisName::SECOND.contains(n)) {
            return bad(origin, "U, V and W are axes of the second head: they belong in second.chain".into());
        }
        let count = |linear: bool| self.chain.iter().filter(|n| n.linear().is_some() == linear).count();
        if !(2..=3).contains(&count(true)) || !(1..=2).contains(&count(false)) {
            return bad(origin, "a chain has X, Y, Z, or two of them, and one or two of A, B, C".into());
        }
        let in_second = |name: &AxisName| self.second.as_ref().is_some_and(|s| s.chain.contains(name));
        for name in AxisName::LINEAR.into_iter().chain(AxisName::SECOND).chain(AxisName::ROTARY) {
            let key = name.letter().to_lowercase();
            if (self.chain.contains(&name) || in_second(&name)) != self.axes.has(name) {
                return bad(
                    origin,
                    format!("axis {} must be in the chain and have a table [axes.{key}]", name.letter()),
                );
            }
        }
        self.second_links(origin)
    }

    /// Checks the chain of the second head.
    fn second_links(&self, origin: &str) -> Result<()> {
        let Some(second) = &self.second else { return Ok(()) };
        let own = second.chain.iter().position(|n| !self.chain.contains(n)).unwrap_or(second.chain.len());
        let (shared, own) = second.chain.split_at(own);
        let turns_workpiece = |n: &AxisName| n.linear().is_none() && carried(&self.chain, *n) == Carries::Workpiece;
        if shared.is_empty() || !self.chain.starts_with(shared) || !shared.iter().any(turns_workpiece) {
            return bad(
                origin,
                "second.chain must begin as the chain does, with the rotary axis that turns the workpiece for both heads".into(),
            );
        }
        let missing = AxisName::SECOND.into_iter().find(|n| own.iter().filter(|o| *o == n).count() != 1);
        let rotary = own.iter().filter(|n| n.linear().is_none()).count();
        if missing.is_some() || rotary > 1 || own.len() != 3 + rotary || shared.iter().any(|n| n.linear().is_some()) {
            return bad(
                origin,
                "second.chain has, behind the axes that it shares, U, V, W and at most one of A, B, C that the chain has not".into(),
            );
        }
        Ok(())
    }
}

/// The gauge point and the tool axis of a spindle while all axes read 0; `None`: the tool axis is
/// no direction.
fn placed(Spindle { gauge_mm, direction }: Spindle) -> Option<(Point, Unit<Vector>)> {
    Some((Point::from(gauge_mm), Unit::try_new(Vector::from(direction), 1e-9)?))
}

/// What an axis of a chain carries: rotary axes with a linear one between them and the tool carry
/// the workpiece, with all axes before them.
fn carried(chain: &[AxisName], letter: AxisName) -> Carries {
    let behind = |from: usize| chain[from..].iter();
    let turns_workpiece = |k: usize| chain[k].linear().is_none() && behind(k).any(|n| n.linear().is_some());
    let at = chain.iter().position(|n| *n == letter).unwrap_or(chain.len());
    if (at..chain.len()).any(turns_workpiece) { Carries::Workpiece } else { Carries::Head(0) }
}

fn bad<T>(origin: &str, what: String) -> Result<T> {
    Err(Error::usage(Stage::Machine, format!("{origin}: {what}")))
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used)]
    use super::*;
    use crate::error::ErrorKind;

    #[test]
    fn the_demo_machine_reads_and_round_trips() {
        let file = MachineFile::from_toml(DEMO_TOML, "demo").unwrap();
        assert_eq!(file, MachineFile::from_toml(&toml::to_string(&file).unwrap(), "again").unwrap());
        let m = file.build("demo").unwrap();
        assert_eq!(m, Machine::demo().unwrap());
        let limits = |m: &Machine, k: usize| m.axes()[k].limits;
        assert_eq!(limits(&m, 3).travel, None);
        assert!((limits(&m, 4).travel.unwrap()[1].to_degrees() - 87.0).abs() < 1e-12);
        assert_eq!(m.assumed_limits(), ["X", "Y", "Z", "A", "B"]);
        assert_eq!(limits(&m, 0).travel, Some([0.0, 2800.0]));
        assert_eq!(limits(&m.clone().with_limits_scaled(0.5), 1).velocity, 0.5 * limits(&m, 1).velocity);
    }

    #[test]
    fn a_machine_may_be_without_one_linear_axis() {
        let text = include_str!("../../models/machines/mill_turn_no_y.toml");
        let m = Machine::from_toml(text, "m.toml").unwrap();
        let missing = m.missing().unwrap();
        assert_eq!((missing.name.as_str(), m.axes().len()), ("Y", 5));
        assert_eq!(m.assumed_limits(), ["X", "Z", "C", "B"]);
        assert!(Machine::demo().unwrap().missing().is_none());
        let cases = [
            (
                "chain = [\"C\", \"Z\", \"X\", \"B\"]",
                "chain = [\"C\", \"Z\", \"X\", \"Y\", \"B\"]",
                "axis Y must be in the chain and have",
            ),
            ("chain = [\"C\", \"Z\", \"X\", \"B\"]", "chain = [\"C\", \"Z\", \"B\"]", "X, Y, Z, or two of them"),
        ];
        for (from, to, says) in cases {
            let text = text.replacen(from, to, 1);
            let e = Machine::from_toml(&text, "m.toml").unwrap_err();
            assert!(e.kind == ErrorKind::Usage && e.message.contains(says), "{}", e.message);
        }
        let from = DEMO_TOML.find("[axes.y]").unwrap();
        let to = DEMO_TOML.find("[axes.z]").unwrap();
        let e = Machine::from_toml(&[&DEMO_TOML[..from], &DEMO_TOML[to..]].concat(), "m.toml").unwrap_err();
        assert!(e.message.contains("only a machine with a chain may be without Y"), "{}", e.message);
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
