//! A plan written in a dialect.

use super::dialect::{Dialect, FeedWord, Rotary};
use super::fixed::Fixed;
use super::moves::{self, Move, WordBends};
use super::nurbs::{self, Piece};
use super::polynomial;
use super::spline;
use super::template::{Class, KEYS, TemplateLine, TemplateWord, Value, WordPiece, key};
use super::text::{Lines, ascii, header, title};
use super::{OperationRun, WayEnd, cycle, merge, smoothing, turn_in};
use crate::artifact::plan::Stretch;
use crate::artifact::program::{CutLine, Programmed};
use crate::artifact::{Axes, Stand};
use crate::error::{Error, Infeasible, Result, Stage};
use crate::geometry::{Point, Rigid, Vector};
use crate::machine::Machine;
use crate::tool;

/// The whole program: one operation after another.
pub(super) fn write(runs: &[OperationRun], dialect: &Dialect) -> Result<(String, Vec<CutLine>)> {
    let mut lines = Lines::new(&dialect.file);
    for (k, run) in runs.iter().enumerate() {
        let mut w = Writer::new(run, dialect, lines);
        if k == 0 {
            w.put(&dialect.file_begin)?;
            w.lines.size_to_come();
        }
        if runs.len() > 1 {
            w.lines.comment(&"#".repeat(78));
            w.lines.comment(&format!("Operation {} of {}", run.number, runs.len() + runs[0].number - 1));
        }
        operation(&mut w, run, dialect)?;
        if k + 1 < runs.len() {
            w.put(&dialect.operation_end)?;
        } else {
            w.put(&dialect.end)?;
            w.put(&dialect.file_end)?;
        }
        lines = w.lines;
    }
    Ok(lines.finished())
}

/// From the tool call to the unwound axis.
fn operation(w: &mut Writer, run: &OperationRun, dialect: &Dialect) -> Result<()> {
    title(run, &mut w.lines, &dialect.file.name);
    w.put(&dialect.warnings)?;
    let beyond_mm = if run.options.settings.look_ahead { smoothing::of(run, &dialect.file).beyond_mm } else { 0.0 };
    header(run, &cycle::time(run, dialect), beyond_mm, &mut w.lines);
    w.put(&dialect.notes)?;
    w.lines.mark();
    let [first, last] = run.ends;
    let height = run.feed_height(&first);
    let places = dialect.turns_in().then(|| turn_in::places(run, dialect.file.programmed));
    match places.as_deref() {
        Some([zero, then @ ..]) => {
            w.stand(zero)?;
            w.put(&dialect.start)?;
            for place in then {
                w.stand(place)?;
                w.put(&dialect.turn_in)?;
            }
        }
        _ => {
            w.at(&first, first.safe_mm)?;
            w.put(&dialect.start)?;
        }
    }
    w.at(&first, height)?;
    w.put(&dialect.approach)?;
    w.at(&first, 0.0)?;
    w.put(&dialect.plunge)?;
    w.put(&dialect.cutting)?;
    w.cuts()?;
    w.lines.mark();
    w.put(&dialect.cutting_end)?;
    w.at(&last, run.feed_height(&last))?;
    w.put(&dialect.leave)?;
    w.at(&last, last.safe_mm)?;
    w.put(&dialect.retract)?;
    if run.ends.iter().all(|e| e.clear) {
        match places.as_deref() {
            Some([zero, ..]) => w.stand(zero)?,
            _ => w.at(&first, 0.0)?,
        }
        w.put(&dialect.unwind)?;
    }
    Ok(())
}

/// Values, and the lines written with them.
struct Writer<'a> {
    run: &'a OperationRun<'a>,
    dialect: &'a Dialect,
    lines: Lines<'a>,
    values: Vec<Value>,
    /// The programmed point in place of X, Y, Z, and the rotary axes, as last rounded.
    stands: Option<Axes<Fixed>>,
    /// The same before it was rounded.
    exact: Option<Axes>,
    /// What each modal word last was.
    modal: Vec<(TemplateWord, String)>,
}

/// A pose as a program sees it.
struct PlacedPose {
    /// The programmed point, mm.
    point: [f64; 3],
    /// A as the program counts it, and B, degrees.
    a_deg: f64,
    axes: Axes,
    axis: [f64; 3],
}

impl<'a> Writer<'a> {
    fn new(run: &'a OperationRun, dialect: &'a Dialect, lines: Lines<'a>) -> Self {
        let values = vec![Value::Number(0.0); KEYS.len()];
        let mut w = Writer { run, dialect, lines, values, stands: None, exact: None, modal: Vec::new() };
        w.fixed_values();
        w
    }

    fn set(&mut self, name: &str, value: Value) {
        if let Some(slot) = key(name).and_then(|k| self.values.get_mut(k)) {
            *slot = value;
        }
    }

    /// Values that stay the same through the program.
    fn fixed_values(&mut self) {
        let (run, o, tool) = (self.run, self.run.options, self.run.tool);
        let m = &run.machine.mount;
        let smoothing = smoothing::of(run, &self.dialect.file);
        for (name, v) in [
            ("approach_feed", o.settings.approach_feed_mm_min),
            ("plunge_feed", o.settings.plunge_feed_mm_min),
            ("safe_up", run.machine.axes()[run.up()].word_per_mm() * run.safe_up()),
            ("turns", run.plan.toolpath.locations.last().map_or(1.0, |l| f64::from(l.turn + 1))),
            ("tool", f64::from(o.settings.tool_number)),
            ("rpm", o.settings.spindle_rpm),
            ("tolerance", smoothing.mm),
            ("axis_tolerance", smoothing.axis_deg),
            ("length_to_tip", tool.length_mm() + tool.corner_mm()),
            ("length_to_centre", tool.length_mm()),
            ("radius", tool.corner_mm()),
            ("diameter", 2.0 * tool.radius_mm),
            ("mount_x", m.offset_mm[0]),
            ("mount_y", m.offset_mm[1]),
            ("mount_z", m.offset_mm[2]),
            ("clamping", m.clamping_deg),
        ] {
            self.set(name, Value::Number(v));
        }
        let [shift, rows] = cad(&run.blade.model_from_blade);
        let [row_1, row_2, row_3] = &rows[..] else { return };
        let (axes, leaning) = (run.machine.axes(), self.leaning());
        let turning = &axes[run.machine.turning_axis()];
        let (a_name, b_name) = (turning.name.as_str(), leaning.map_or("", |k| axes[k].name.as_str()));
        let cone = match (leaning, run.turns_the_blade_alone()) {
            (None, _) => "No axis leans the tool".to_owned(),
            (_, true) => format!("{b_name} is fixed"),
            (_, false) => format!("{a_name} and {b_name} move together"),
        };
        let along =
            m.along.map_or_else(String::new, |[x, y, z]| format!(" Blade axis along machine {x:.6} {y:.6} {z:.6}."));
        for (name, text) in [
            ("a_name", a_name),
            ("b_name", b_name),
            ("up_name", &axes[run.up()].name),
            ("side_1_name", &axes[sides(run.machine)[0]].name),
            ("side_2_name", &axes[sides(run.machine)[1]].name),
            ("moves_b", &leaning.map_or_else(String::new, |_| format!(" and move {b_name}"))),
            ("a_way", if turning.limits.travel.is_some() { "AC" } else { "DC" }),
            ("cone", &cone),
            ("along", &along),
            ("name", o.program_name.as_str()),
            ("program_number", "0001"),
            ("part", o.part_file.as_str()),
            ("cad_shift", &shift[0]),
            ("cad_row_1", row_1),
            ("cad_row_2", row_2),
            ("cad_row_3", row_3),
        ] {
            self.set(name, Value::Text(ascii(text)));
        }
    }

    /// Sets the values of a pose over an end of the path.
    fn at(&mut self, end: &WayEnd, lift_mm: f64) -> Result<()> {
        let placed = self.placed(&end.stand.lifted(lift_mm), &end.near);
        self.take(&placed, None)
    }

    /// Sets the values of axis positions.
    fn stand(&mut self, axes: &[f64]) -> Result<()> {
        let pose = self.run.machine.forward(axes, self.run.tool.length_mm());
        self.take(&self.placed_by(&pose.centre, &pose.axis, axes.into()), None)
    }

    fn placed(&self, stand: &Stand, near: &[f64]) -> PlacedPose {
        let axes = self.run.machine.place(stand, Some(near), self.run.tool.length_mm());
        self.placed_by(&stand.centre, &stand.axis(), axes)
    }

    /// A pose by its centre and tool axis, and the axis positions that bring it about.
    fn placed_by(&self, centre: &Point, axis: &Vector, axes: Axes) -> PlacedPose {
        let point = match self.dialect.file.programmed {
            Programmed::Tip => tool::tip(centre, axis, self.run.tool.corner_mm()).into(),
            Programmed::Centre => (*centre).into(),
            Programmed::Machine => self.run.machine.linear().map(|k| axes[k]),
        };
        let turning = self.run.machine.turning_axis();
        PlacedPose { point, a_deg: self.a_deg(axes[turning]), axes, axis: (*axis).into() }
    }

    /// `A` in degrees as the program counts it.
    fn a_deg(&self, a_rad: f64) -> f64 {
        let a = a_rad.to_degrees();
        match self.dialect.file.rotary {
            // An axis with ends of travel stands where it is programmed.
            _ if !self.turns_without_end() => a,
            Rotary::Modulo => a.rem_euclid(360.0),
            Rotary::Accumulate | Rotary::Vector | Rotary::Incremental => a - self.run.turns_before_rad().to_degrees(),
        }
    }

    /// Whether the rotary axis nearest to the workpiece has no ends of travel.
    fn turns_without_end(&self) -> bool {
        let machine = self.run.machine;
        machine.axes()[machine.turning_axis()].limits.travel.is_none()
    }

    /// Column of the other rotary axis, where there is one.
    fn leaning(&self) -> Option<usize> {
        self.run.machine.rotary().nth(1)
    }

    /// Takes over a pose, reached with words that bend; the step of `A` is from the pose before.
    fn take(&mut self, p: &PlacedPose, bend: Option<&WordBends>) -> Result<()> {
        let numbers = &self.dialect.file.numbers;
        let length = |v: f64| Fixed::new(v, numbers.length_decimals);
        let mut a = Fixed::new(p.a_deg, numbers.angle_decimals)?;
        if self.dialect.file.rotary == Rotary::Modulo && self.turns_without_end() {
            a = a.modulo(360);
        }
        let (machine, leaning) = (self.run.machine, self.leaning());
        let (turning, b_deg) = (machine.turning_axis(), leaning.map_or(0.0, |k| p.axes[k].to_degrees()));
        let mut stands = Axes::of_default(p.axes.len());
        for (k, v) in machine.linear().into_iter().zip(p.point) {
            stands[k] = length(v)?;
        }
        stands[turning] = a;
        if let Some(k) = leaning {
            stands[k] = Fixed::new(b_deg, numbers.angle_decimals)?;
        }
        let mut exact = p.axes.map(f64::to_degrees);
        machine.linear().into_iter().zip(p.point).for_each(|(k, v)| exact[k] = v);
        exact[turning] = p.a_deg;
        let since = self.exact.replace(exact);
        if self.dialect.file.has_spline_lines() {
            self.take_splines(since, bend);
        }
        let before = self.stands.replace(stands);
        if let Some(before) = before {
            self.set("da", Value::Rounded(a.since(before[turning])));
        }
        if self.dialect.file.poly_degree.is_some() {
            self.take_polynomials(&stands, before, bend)?;
        }
        self.set("a", Value::Rounded(a));
        for name in ["b", "b_moving"] {
            self.set(name, Value::Number(b_deg));
        }
        let numbers = ["x", "y", "z", "mx", "my", "mz", "i", "j", "k"].into_iter();
        let reached = machine.linear().map(|k| p.axes[k]);
        // Of axes: programs over the part are refused where an axis counts diameters.
        let counted = machine.linear().map(|k| machine.axes()[k].word_per_mm());
        let factors = counted.into_iter().chain(counted).chain([1.0; 3]);
        for ((name, v), factor) in numbers.zip(p.point.into_iter().chain(reached).chain(p.axis)).zip(factors) {
            self.set(name, Value::Number(factor * v));
        }
        for (name, k) in ["side_1", "side_2"].into_iter().zip(sides(machine)) {
            self.set(name, Value::Number(machine.axes()[k].word_per_mm() * p.axes[k]));
        }
        Ok(())
    }

    /// Sets the polynomials that end at a pose: steps or positions as the rotary axes are
    /// programmed.
    fn take_polynomials(
        &mut self,
        ends: &Axes<Fixed>,
        before: Option<Axes<Fixed>>,
        bend: Option<&WordBends>,
    ) -> Result<()> {
        let numbers = &self.dialect.file.numbers;
        let steps = before.filter(|_| self.dialect.file.rotary == Rotary::Incremental);
        let axes = self.run.machine.axes();
        for name in ["px", "py", "pz", "pa", "pb", "pb_moving"] {
            // An axis that the machine has not: its word is left out.
            let Some(w) = self.column(name) else { continue };
            let decimals = if axes[w].is_rotary() { numbers.angle_decimals } else { numbers.length_decimals };
            let end = steps.map_or(ends[w], |before| ends[w].since(before[w]));
            let bent = bend.map_or([0.0; 4], |bend| bend[w]);
            let rounded: Vec<Fixed> = bent.iter().map(|a| Fixed::new(*a, decimals)).collect::<Result<_>>()?;
            let kept = rounded.iter().rposition(|a| !a.is_zero()).map_or(0, |last| last + 1);
            let all = std::iter::once(&end).chain(&rounded[..kept]);
            let text = all.map(|n| n.text(numbers.plus, numbers.trim)).collect::<Vec<_>>().join(",");
            self.set(name, Value::Text(text));
        }
        Ok(())
    }

    /// Sets the splines that end at a pose, from where the words were before. Their factors are
    /// those of the words before rounding: derivatives then meet where lines do, and only places
    /// are off, by what the ends are rounded to.
    fn take_splines(&mut self, from: Option<Axes>, bend: Option<&WordBends>) {
        let Some((from, to)) = from.zip(self.exact) else { return };
        for (name, letter) in [("kx", "X"), ("ky", "Y"), ("kz", "Z"), ("ka", ""), ("kb_moving", "")] {
            let Some(w) = self.column(name) else { continue };
            let letter = if letter.is_empty() { self.run.machine.axes()[w].name.clone() } else { letter.into() };
            let [square, cube, ..] = bend.map_or([0.0; 4], |bend| bend[w]);
            let even = to[w] - from[w] - square - cube;
            // From p to t = 1 - p.
            let factors = [-cube, square + 3.0 * cube, -even - 2.0 * square - 3.0 * cube];
            let sign = if self.dialect.file.numbers.plus { "+" } else { "" };
            let word = |(k, factor): (usize, f64)| {
                // Adding 0 turns a rounded -0 into 0.
                let factor = factor + 0.0;
                let sign = if factor < 0.0 { "" } else { sign };
                format!("K{}{letter}{sign}{factor:.8E}", 3 - k)
            };
            let text = factors.into_iter().enumerate().map(word).collect::<Vec<_>>().join(" ");
            self.set(name, Value::Text(text));
        }
    }

    /// Column of the axis that a value of a polynomial is about.
    fn column(&self, value: &str) -> Option<usize> {
        let (machine, [x, y, z]) = (self.run.machine, self.run.machine.linear());
        match value {
            "px" | "kx" => Some(x),
            "py" | "ky" => Some(y),
            "pz" | "kz" => Some(z),
            "pa" | "ka" => Some(machine.turning_axis()),
            "pb" | "pb_moving" | "kb_moving" => self.leaning(),
            _ => None,
        }
    }

    /// All cutting lines. A move whose words would all repeat those before is left out; its time
    /// goes to the next, so the whole time is kept.
    fn cuts(&mut self) -> Result<()> {
        let dialect = self.dialect;
        let lines = &dialect.cut;
        let words = |m: &Move| {
            let PlacedPose { point, a_deg, axes, .. } = self.placed(&m.stand, &m.near);
            let mut words = axes.map(f64::to_degrees);
            self.run.machine.linear().into_iter().zip(point).for_each(|(k, v)| words[k] = v);
            words[self.run.machine.turning_axis()] = a_deg;
            words
        };
        let moves = match (dialect.file.poly_degree, dialect.file.feed) {
            (Some(degree), _) => polynomial::all(self.run, degree, dialect.file.has_spline_lines(), &words)?,
            (None, _) if let Some(curve) = self.run.plan.curve.as_ref().filter(|_| dialect.has_curves()) => {
                spline::all(self.run, curve, nurbs::DEGREE, &words, |_, row, from, to, _| {
                    moves::straight(self.run, dialect.file.programmed, row + 1, (from, to))
                })?
            }
            (None, FeedWord::PerMinute | FeedWord::PerMinuteOfAll) => moves::all(self.run, dialect.file.programmed)?,
            (None, FeedWord::InverseTime) => {
                let least_s = 60.0 / dialect.file.feed_range().greatest;
                merge::joined(self.run, dialect, moves::all(self.run, dialect.file.programmed)?, least_s)?
            }
        };
        let mut written = 0usize;
        let mut last: Option<(Vec<Fixed>, f64, PlacedPose)> = None;
        // The move to a turn's first location still cuts the turn before.
        let mut begun = None;
        let mut stretch = moves.first().map_or(Stretch::Turn(0), |m| m.stretch);
        let mut k = 0;
        while let Some(Move { t_s, stretch: next, bend, words, .. }) = moves.get(k) {
            let is_piece = dialect.has_curves() && bend.is_some() && words.is_some();
            if let (true, Some((_, since, _))) = (is_piece, &last) {
                if begun != Some(stretch) {
                    begun = Some(stretch);
                    self.begin(stretch)?;
                }
                let pieces = self.curves(&moves[k..], stretch, *since)?;
                k += pieces;
                written += pieces;
                let end = &moves[k - 1];
                last = Some((self.position(lines)?, end.t_s, self.placed_as_said(end)));
                stretch = end.stretch;
                continue;
            }
            k += 1;
            if *next == Stretch::LeadOut {
                stretch = *next;
            }
            let placed = self.placed_as_said(&moves[k - 1]);
            let before = self.stands;
            self.take(&placed, bend.as_ref())?;
            let position = self.position(lines)?;
            match &last {
                None => last = Some((position, *t_s, placed)),
                Some((same, ..)) if *same == position => {}
                Some((_, since, from)) => {
                    let until = self.no_sooner(*since, *t_s);
                    let f = self.feed_word(before, from, (&placed, bend.as_ref()), [*since, until])?;
                    self.set("f", Value::Text(f));
                    if begun != Some(stretch) {
                        begun = Some(stretch);
                        // What is said of a turn is said where it begins.
                        self.take(from, None)?;
                        self.begin(stretch)?;
                        self.take(&placed, bend.as_ref())?;
                    }
                    self.put(lines)?;
                    self.lines.cut_until(until);
                    last = Some((position, until, placed));
                    written += 1;
                }
            }
            stretch = *next;
        }
        if written == 0 {
            return Err(Error::usage(
                Stage::Post,
                "the whole path rounds to a single position, there is nothing to cut",
            ));
        }
        Ok(())
    }

    /// The end of a move, its words as it says itself where it does.
    fn placed_as_said(&self, end: &Move) -> PlacedPose {
        let placed = self.placed(&end.stand, &end.near);
        match &end.words {
            Some(words) => self.with_words(placed, words),
            None => placed,
        }
    }

    /// The same with other words, mm and degrees.
    fn with_words(&self, mut placed: PlacedPose, words: &[f64]) -> PlacedPose {
        placed.point = self.run.machine.linear().map(|k| words[k]);
        placed.a_deg = words[self.run.machine.turning_axis()];
        if let Some(k) = self.leaning() {
            placed.axes[k] = words[k].to_radians();
        }
        placed
    }

    /// Writes the pieces that moves begin with, as far as they belong to one stretch, as curves;
    /// how many they are. The first begins at a time, s.
    fn curves(&mut self, moves: &[Move], stretch: Stretch, since: f64) -> Result<usize> {
        let Some(from) = self.exact else { return Ok(0) };
        let (mut from, mut since, mut pieces) = (from, since, Vec::new());
        for (k, end) in moves.iter().enumerate() {
            let (Some(bend), Some(to)) = (end.bend, end.words) else { break };
            // The piece to a turn's first location still cuts the turn before.
            if k > 0 && moves[k - 1].stretch != stretch {
                break;
            }
            let (way, dt_s) = (self.way(&from, &to, &bend), end.t_s - since);
            pieces.push(Piece { bend, to, span_mm: end.span_mm, way, dt_s });
            (from, since) = (to, end.t_s);
        }
        let mut done = 0;
        while done < pieces.len() {
            let count = nurbs::together(&pieces[done..]);
            self.curve(&pieces[done..done + count], &moves[done..done + count])?;
            done += count;
        }
        Ok(done)
    }

    /// Writes one curve of pieces, which end with these moves.
    fn curve(&mut self, pieces: &[Piece], ends: &[Move]) -> Result<()> {
        let (dialect, decimals) = (self.dialect, self.dialect.file.numbers.length_decimals);
        let (Some(from), Some(last)) = (self.exact, ends.last()) else { return Ok(()) };
        let knots = nurbs::knots(pieces);
        let points = nurbs::control_points(&from, pieces, &knots);
        let (way, dt_s) = pieces.iter().fold((0.0, 0.0), |(way, dt_s), p| (way + p.way, dt_s + p.dt_s));
        let f = self.feed_text(60.0 * way / dt_s, last.t_s, dt_s)?;
        self.set("f", Value::Text(f));
        for (j, point) in points.iter().enumerate() {
            let placed = self.with_words(self.placed(&last.stand, &last.near), point);
            self.take(&placed, None)?;
            self.set("knot", Value::Text(format!("{:.decimals$}", knots[j])));
            self.put(if j == 0 { &dialect.curve_begin } else { &dialect.curve_point })?;
            // A piece is known from the fourth of its control points on.
            if let Some(end) = j.checked_sub(3).and_then(|i| ends.get(i)) {
                self.lines.cut_until(end.t_s);
            }
        }
        for knot in &knots[points.len()..] {
            self.set("knot", Value::Text(format!("{knot:.decimals$}")));
            self.put(&dialect.curve_knot)?;
        }
        Ok(())
    }

    /// What F counts along a polynomial between words, mm and degrees.
    fn way(&self, from: &Axes, to: &Axes, bend: &WordBends) -> f64 {
        let machine = self.run.machine;
        let linear = machine.linear();
        let way = polynomial::length(&linear.map(|k| from[k]), &linear.map(|k| to[k]), linear.map(|k| bend[k]));
        let turn = machine.rotary().map(|k| to[k] - from[k]).fold(0.0, f64::hypot);
        match self.dialect.file.feed {
            FeedWord::PerMinuteOfAll => way.hypot(turn),
            FeedWord::PerMinute | FeedWord::InverseTime if way > 0.0 => way,
            FeedWord::PerMinute | FeedWord::InverseTime => turn,
        }
    }

    /// Says what the lines that follow belong to.
    fn begin(&mut self, stretch: Stretch) -> Result<()> {
        self.lines.mark();
        match stretch {
            Stretch::LeadIn => self.lines.comment("Lead-in"),
            Stretch::LeadOut => self.lines.comment("Lead-out"),
            Stretch::Turn(turn) => {
                let dialect = self.dialect;
                self.set("turn", Value::Number(f64::from(turn + 1)));
                self.put(&dialect.turn)?;
            }
        }
        Ok(())
    }

    /// The rounded numbers of a cutting line that say where; steps are taken as positions.
    fn position(&self, lines: &[TemplateLine]) -> Result<Vec<Fixed>> {
        let mut out = Vec::new();
        for piece in lines.iter().flat_map(|l| &l.words).flat_map(|w| &w.pieces) {
            let WordPiece::Value(k, digits) = piece else { continue };
            let said = match KEYS.get(*k).map(|(name, ..)| *name) {
                Some("f") => None,
                Some("da") => self.rounded(key("a").unwrap_or(*k), *digits)?,
                Some(name) if self.column(name).is_some() => self.stands.zip(self.column(name)).map(|(s, k)| s[k]),
                _ => self.rounded(*k, *digits)?,
            };
            out.extend(said);
        }
        Ok(out)
    }

    /// When a line ends. Polynomials are parted where their curve wants it, also so short in time
    /// that the control reads no F as large; they cannot be joined again, so such a line takes the
    /// least time there is and the next has that much less: the whole time is kept.
    fn no_sooner(&self, since: f64, t_s: f64) -> f64 {
        let file = &self.dialect.file;
        match (file.poly_degree, file.feed) {
            (Some(_), FeedWord::InverseTime) => t_s.max(since + 60.0 / file.feed_range().greatest * (1.0 + 1e-6)),
            _ => t_s,
        }
    }

    /// F of a cutting line between two places and times, `before` being the first as it is rounded:
    /// so that the line takes its time to the control too.
    fn feed_word(
        &self,
        before: Option<Axes<Fixed>>,
        from: &PlacedPose,
        (to, bend): (&PlacedPose, Option<&WordBends>),
        [since, t_s]: [f64; 2],
    ) -> Result<String> {
        let (file, dt_s) = (&self.dialect.file, t_s - since);
        let f = match file.feed {
            FeedWord::InverseTime => 60.0 / dt_s,
            FeedWord::PerMinuteOfAll => {
                let count = self.run.machine.axes().len();
                let steps = before.zip(self.stands);
                let all = steps.map_or(0.0, |(a, b)| (0..count).map(|k| b[k].since(a[k]).value().powi(2)).sum::<f64>());
                60.0 * all.sqrt() / dt_s
            }
            FeedWord::PerMinute => {
                let linear = self.run.machine.linear();
                let steps = before.zip(self.stands).map(|(a, b)| linear.map(|i| b[i].since(a[i]).value()));
                let straight = steps.map_or(0.0, |s| s.iter().map(|d| d * d).sum::<f64>().sqrt());
                let way =
                    bend.map_or(straight, |bend| polynomial::length(&from.point, &to.point, linear.map(|k| bend[k])));
                let turned = self.run.machine.rotary().map(|k| to.axes[k] - from.axes[k]);
                let turn = turned.fold(0.0, f64::hypot).to_degrees();
                60.0 * if way > 0.0 { way } else { turn } / dt_s
            }
        };
        self.feed_text(f, t_s, dt_s)
    }

    /// F of lines that end at a time and take one, s.
    fn feed_text(&self, f: f64, t_s: f64, dt_s: f64) -> Result<String> {
        let (file, range) = (&self.dialect.file, self.dialect.file.feed_range());
        moves::feed_word(f, &range).ok_or_else(|| {
            let what = format!(
                "{}: the line that ends {t_s:.3} s after the beginning and takes {:.3} ms would need F {f:.6}, the control reads {} to {}",
                file.name,
                1e3 * dt_s,
                range.least,
                range.greatest
            );
            let range = [range.least, range.greatest];
            let since = Infeasible::FeedWordOutOfRange { at_s: t_s, takes_s: dt_s, needed: f, range };
            Error::infeasible(Stage::Post, what, since).advise("change feed.feed_mm_min or path.chord_mm, or ranges.F of the post file")
        })
    }

    /// Writes lines with the values as they are.
    fn put(&mut self, lines: &[TemplateLine]) -> Result<()> {
        let wanted = |l: &&TemplateLine| self.run.options.settings.look_ahead || !l.look_ahead;
        for line in lines.iter().filter(wanted) {
            let mut text = String::new();
            for word in &line.words {
                if !line.comment && self.left_out(word) {
                    continue;
                }
                let mut w = String::new();
                for piece in &word.pieces {
                    match piece {
                        WordPiece::Text(t) => w.push_str(t),
                        WordPiece::Value(k, digits) => w.push_str(&self.value_text(*k, *digits)?),
                    }
                }
                if word.modal && self.repeats(word, &w) {
                    continue;
                }
                if !text.is_empty() {
                    text.push(' ');
                }
                text.push_str(&w);
            }
            if line.comment {
                self.lines.comment(&text);
            } else {
                self.lines.block(&text)?;
            }
        }
        Ok(())
    }

    /// A word of a linear axis or of the second rotary axis that the machine has not, or of the
    /// latter where it stands still and need not be named again.
    fn left_out(&self, word: &TemplateWord) -> bool {
        let says =
            |name: &str| word.pieces.iter().any(|p| matches!(p, WordPiece::Value(k, _) if Some(*k) == key(name)));
        let machine = self.run.machine;
        if let Some(i) = machine.missing().and_then(|axis| axis.letter.linear()) {
            let own = [["x", "y", "z"], ["px", "py", "pz"], ["mx", "my", "mz"]].iter().any(|names| says(names[i]));
            let side = sides(machine).iter().position(|k| *k == machine.linear()[i]);
            if own || side.is_some_and(|s| says(["side_1", "side_2"][s])) {
                return true;
            }
        }
        let none = self.leaning().is_none();
        let still = none || self.run.turns_the_blade_alone();
        none && (says("b") || says("pb"))
            || still && ["b_moving", "pb_moving", "kb_moving"].iter().any(|name| says(name))
    }

    /// A modal word says what it said before; remembers what it says now.
    fn repeats(&mut self, word: &TemplateWord, text: &str) -> bool {
        match self.modal.iter_mut().find(|(w, _)| w == word) {
            Some((_, last)) if last == text => true,
            Some((_, last)) => {
                *last = text.into();
                false
            }
            None => {
                self.modal.push((word.clone(), text.into()));
                false
            }
        }
    }

    /// A value as it is rounded; `None`: it is no number.
    fn rounded(&self, k: usize, digits: Option<usize>) -> Result<Option<Fixed>> {
        let numbers = &self.dialect.file.numbers;
        let decimals = digits.unwrap_or(match class(k) {
            Class::Length | Class::Size => numbers.length_decimals,
            Class::Angle => numbers.angle_decimals,
            Class::Direction => numbers.vector_decimals,
            Class::Whole | Class::Feed | Class::Text => 0,
        });
        match self.values.get(k) {
            Some(Value::Rounded(r)) => Ok(Some(*r)),
            Some(Value::Number(v)) => Fixed::new(*v, decimals).map(Some),
            Some(Value::Text(_)) | None => Ok(None),
        }
    }

    fn value_text(&self, k: usize, digits: Option<usize>) -> Result<String> {
        let numbers = &self.dialect.file.numbers;
        let signed = numbers.plus && matches!(class(k), Class::Length | Class::Angle | Class::Direction);
        Ok(match (self.rounded(k, digits)?, self.values.get(k)) {
            (Some(number), _) => number.text(signed, numbers.trim),
            (None, Some(Value::Text(t))) => t.clone(),
            (None, _) => String::new(),
        })
    }
}

/// Columns of the two linear axes that programs do not retract by.
fn sides(machine: &Machine) -> [usize; 2] {
    let [x, y, z] = machine.linear();
    match machine.retract_axis().0 {
        up if up == x => [y, z],
        up if up == y => [x, z],
        _ => [x, y],
    }
}

/// What a value is.
fn class(k: usize) -> Class {
    KEYS.get(k).map_or(Class::Text, |(_, class, _)| *class)
}

/// Shift and rows of the rotation from the blade frame to the CAD model, as text.
fn cad(model_from_blade: &Rigid) -> [Vec<String>; 2] {
    let t = model_from_blade.translation.vector;
    let r = model_from_blade.rotation.to_rotation_matrix();
    let rows = r.matrix().row_iter().map(|row| {
        // Adding 0 turns a rounded -0 into 0.
        let [x, y, z] = [row[0], row[1], row[2]].map(|v: f64| (v * 1e9).round() / 1e9 + 0.0);
        format!("[{x:.9} {y:.9} {z:.9}]")
    });
    [vec![format!("({:.6}, {:.6}, {:.6})", t.x, t.y, t.z)], rows.collect()]
}
