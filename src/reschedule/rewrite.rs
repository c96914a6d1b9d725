//! New orientations written into the lines of a program, in its own manner.
//!
//! Only numbers of the stretches' own lines change, words that these lines lack are added, and
//! lines are put between two of them where θ turns so far that the ball would leave its way. The
//! line that follows a stretch gets the feed that it had.

use std::borrow::Cow;
use std::collections::{BTreeMap, HashMap};

use super::manner::{self, Manner};
use super::planned::Planned;
use super::stretches::{Found, LineEnd};
use super::{Program, RescheduleOptions};
use crate::artifact::program::{Grammar, Programmed};
use crate::artifact::{Axes, Stand};
use crate::geometry::{Point, Vector};
use crate::parallel;
use crate::read::program::line::{self, Word};
use crate::read::program::{Block, Destination, Feed, Moved, RotaryWay};

/// A feed is written anew where it differs by more than this share.
const FEED_SHARE: f64 = 0.005;
/// Most lines that are put between two.
const MOST_PARTS: f64 = 64.0;
/// Numbers of a line are those that were read of it within this, mm or degrees.
const AS_READ: f64 = 1e-6;
/// What reading and turning of frames may add to the rounding of words, mm.
const READ_MM: f64 = 1e-7;
/// Columns of a line of APT: what comes behind them is not read by old systems.
const COLUMNS: usize = 72;
/// Lines that are looked at together.
const TOGETHER: usize = 2048;
/// Millimetres of an inch.
const INCH_MM: f64 = 25.4;
const POINT: [&str; 3] = ["X", "Y", "Z"];

/// What becomes of lines: by their index.
#[derive(Clone, Debug, Default)]
pub(super) struct Edits(BTreeMap<usize, Edit>);

#[derive(Clone, Debug, Default)]
struct Edit {
    /// Lines to be put before it.
    before: Vec<String>,
    /// What it says now; `None`: what it said.
    text: Option<Vec<String>>,
    /// Lines before it that belong to it: a statement over several.
    more: usize,
}

impl Edit {
    /// Lets all its lines end as the line that it takes the place of.
    fn ending_as(mut self, line: &str) -> Self {
        let all = self.before.iter_mut().chain(self.text.iter_mut().flatten());
        all.filter(|l| line.ends_with('\r') && !l.ends_with('\r')).for_each(|l| l.push('\r'));
        self
    }
}

impl Edits {
    /// How many lines say something else, and how many are new.
    pub fn count(&self) -> [usize; 2] {
        let changed = self.0.values().filter_map(|e| e.text.as_ref()).map(Vec::len).sum();
        [changed, self.0.values().map(|e| e.before.len()).sum()]
    }

    pub fn extend(&mut self, other: Edits) {
        self.0.extend(other.0);
    }

    /// The text with the edits, and the number, from 1, that each line has in it now: of a
    /// statement over several, that of its last.
    pub fn applied(&self, text: &str, grammar: Grammar) -> (String, Vec<usize>) {
        let old: Vec<&str> = text.split('\n').collect();
        let mut lines: Vec<&str> = Vec::new();
        let mut numbers = Vec::new();
        for (k, line) in old.iter().enumerate() {
            if let Some(edit) = self.0.get(&k) {
                let own = lines.len().saturating_sub(edit.more);
                let kept = lines.split_off(own);
                lines.extend(edit.before.iter().map(String::as_str));
                match &edit.text {
                    Some(text) => lines.extend(text.iter().map(String::as_str)),
                    None => lines.extend(kept.into_iter().chain([*line])),
                }
            } else {
                lines.push(line);
            }
            numbers.push(lines.len());
        }
        if grammar != Grammar::Heidenhain || self.count()[1] == 0 {
            return (lines.join("\n"), numbers);
        }
        let renumbered = |(k, line): (usize, &&str)| match line.find(|c: char| !c.is_ascii_digit()) {
            Some(0) | None => (*line).to_owned(),
            Some(end) => format!("{k}{}", &line[end..]),
        };
        (lines.iter().enumerate().map(renumbered).collect::<Vec<_>>().join("\n"), numbers)
    }
}

/// Writes orientations into lines.
pub(super) struct Rewriter<'a> {
    program: &'a Program<'a>,
    options: &'a RescheduleOptions,
    lines: Vec<&'a str>,
    /// How often a line is run.
    runs: HashMap<usize, usize>,
    manners: HashMap<String, Manner>,
    /// Millimetres of the program's unit of length.
    unit_mm: f64,
    /// A line that sets a feed, with the bytes of its number: files of cutter locations.
    feed_line: Option<(&'a str, std::ops::Range<usize>)>,
    /// Columns that a line of a file of cutter locations has at most.
    columns: usize,
}

/// Words as they stand in the text now.
struct Modal {
    texts: HashMap<String, String>,
    /// What stands before and behind the number of a word.
    around: HashMap<String, [String; 2]>,
    feed: Feed,
    /// The feed is said again: the stretch before may have left another.
    says_feed: bool,
}

/// What the words of some lines have in common.
#[derive(Default)]
struct Words {
    manners: HashMap<String, Manner>,
    /// The least and the greatest of what was read of X, Y and Z over what they say.
    units: Option<[f64; 2]>,
}

impl Words {
    fn add(&mut self, block: &Block, lines: &[&str], grammar: Grammar, is_wanted: impl Fn(&str) -> bool) {
        let Some((text, _)) = statement(lines, block.line, grammar) else { return };
        let text = text.as_ref();
        for word in line::words(text, grammar).unwrap_or_default().into_iter().filter(|w| is_wanted(&w.name)) {
            if let (Some(value), Some(read)) = (word.value(text), read_of(block, &word.name))
                && value.abs() > 1e-3
                && POINT.contains(&word.name.as_str())
            {
                let unit = read / value;
                let [least, most] = self.units.unwrap_or([unit; 2]);
                self.units = Some([least.min(unit), most.max(unit)]);
            }
            let Some(manner) = text.get(word.number.clone()).map(Manner::of_number) else { continue };
            self.manners.entry(word.name).and_modify(|m| *m = m.and(manner)).or_insert(manner);
        }
    }
}

/// A place written: its words by name, and the columns that they come to: positions of the axes, as
/// they are rounded.
#[derive(Clone)]
struct Written {
    words: Vec<(String, String)>,
    columns: Axes,
}

/// A line as it stands, and the moves that take its place, with their feeds.
struct NewLine<'a> {
    text: Cow<'a, str>,
    /// Lines before it that belong to it.
    more: usize,
    words: Vec<Word>,
    moves: Vec<(Written, Feed)>,
}

impl<'a> Rewriter<'a> {
    /// # Errors
    /// Why no line of the stretches can be written anew.
    pub fn new(program: &'a Program<'a>, options: &'a RescheduleOptions, found: &[Found]) -> Result<Self, String> {
        let lines: Vec<&str> = program.text.split('\n').collect();
        let grammar = program.bench.language.grammar;
        let mut runs = HashMap::new();
        program.blocks().iter().for_each(|b| *runs.entry(b.line).or_default() += 1);
        let places: Vec<&LineEnd> = found.iter().flat_map(|f| f.places.iter().skip(1)).collect();
        let own = parallel::map(places.chunks(TOGETHER), |places| {
            let mut out = Words::default();
            let blocks = places.iter().filter_map(|place| program.blocks().get(place.block));
            blocks.for_each(|block| out.add(block, &lines, grammar, |_| true));
            out
        });
        // A feed may be said once, before the stretches.
        let feeds = parallel::map(program.blocks().chunks(TOGETHER), |blocks| {
            let mut out = Words::default();
            blocks.iter().for_each(|block| out.add(block, &lines, grammar, |name| name == "F"));
            out
        });
        let is =
            |unit: f64| own.iter().all(|o| o.units.is_none_or(|u| u.iter().all(|u| (u / unit - 1.0).abs() < 1e-3)));
        let unit_mm = [1.0, INCH_MM].into_iter().find(|unit| is(*unit));
        let unit_mm = unit_mm.ok_or("its lines are not in the coordinates that they are read in")?;
        let mut manners: HashMap<String, Manner> = HashMap::new();
        for (name, manner) in own.into_iter().chain(feeds).flat_map(|o| o.manners) {
            manners.entry(name).and_modify(|m| *m = m.and(manner)).or_insert(manner);
        }
        let is_goto = |l: &&&str| l.trim_start().get(..4).is_some_and(|w| w.eq_ignore_ascii_case("GOTO"));
        let widest = lines.iter().filter(is_goto).map(|l| l.trim_end().len()).max().unwrap_or(0);
        let columns = if widest <= COLUMNS { COLUMNS } else { usize::MAX };
        let feed_line = lines.iter().rev().find_map(|l| Some((*l, feed_number(l)?)));
        Ok(Rewriter { program, options, lines, runs, manners, unit_mm, feed_line, columns })
    }

    /// The edits for a stretch, or why its lines are left as they are.
    ///
    /// # Errors
    /// The reason, with the line.
    pub fn edits(&self, found: &Found, planned: &Planned) -> Result<Edits, String> {
        let count = planned.schedule.theta.len();
        let places = found.places.get(planned.first..planned.first + count).unwrap_or_default();
        let [Some(first), Some(last)] = [places.first(), places.last()] else { return Err("it has no lines".into()) };
        let at_line = |place: &LineEnd| {
            let line = self.program.line(place);
            move |why: String| format!("line {line}: {why}")
        };
        let begin = self.moved(first)?.to;
        let stand = |k: usize, place: &LineEnd| self.stand(planned, planned.location(planned.first + k), place);
        // Where the axes stand before each line decides which of several positions of the rotary
        // axes is meant. Rounding does not.
        let unsaid = self.unsaid(places);
        let mut near = begin;
        let mut rows: Vec<(usize, Axes)> = Vec::with_capacity(places.len());
        for (k, place) in places.iter().enumerate().skip(1) {
            rows.push((k, near));
            let columns = self.moved(place).and_then(|m| self.columns(m.words, &stand(k, place), &near));
            let mut next = columns.map_err(at_line(place))?;
            unsaid.iter().for_each(|k| next[*k] = near[*k]);
            near = next;
        }
        let ends = parallel::try_map(&rows, |(k, near)| {
            let place = &places[*k];
            self.written(self.block(place)?, self.moved(place)?, &stand(*k, place), near).map_err(at_line(place))
        })?;
        let lines = parallel::try_map(&rows, |(k, _)| {
            let from = k.checked_sub(2).and_then(|before| ends.get(before)).map_or(begin, |e| e.columns);
            let of_line = self.line([&places[k - 1], &places[*k]], (planned, planned.first + k), (from, &ends[k - 1]));
            of_line.map_err(at_line(&places[*k]))
        })?;
        let feed = self.block(first)?.feed;
        let mut modal = Modal { texts: HashMap::new(), around: HashMap::new(), feed, says_feed: true };
        let mut edits = Edits::default();
        for (line, w) in lines.into_iter().zip(places.windows(2)) {
            let block = self.block(&w[1])?;
            let own_text = self.lines.get(block.line - 1).copied().unwrap_or("");
            let edit = self.edit(line, [self.block(&w[0])?, block], &mut modal).map_err(at_line(&w[1]))?;
            edits.0.insert(block.line - 1, edit.ending_as(own_text));
        }
        let columns = ends.last().map_or(begin, |end| end.columns);
        let there = self.moved(last)?.to;
        if columns.iter().zip(there.iter()).any(|(a, b)| (a - b).abs() > 0.01) {
            return Err("its axes would not come to where the program goes on".into());
        }
        self.restore_feed(last, &modal, &mut edits)?;
        Ok(edits)
    }

    /// Rotary axes that the lines of a stretch have no word for: they stay where they are.
    fn unsaid(&self, places: &[LineEnd]) -> Vec<usize> {
        let machine = self.program.bench.machine;
        let has_words = |place: &LineEnd| self.block(place).is_ok_and(|b| matches!(b.place, Destination::Words { .. }));
        if !places.iter().skip(1).all(has_words) {
            return Vec::new();
        }
        machine.rotary().filter(|k| !self.manners.contains_key(machine.axes()[*k].letter.letter())).collect()
    }

    /// The statement that ends in a line, from 1, and how many lines before that belong to it.
    fn statement(&self, line: usize) -> Option<(Cow<'a, str>, usize)> {
        statement(&self.lines, line, self.program.bench.language.grammar)
    }

    /// A statement in lines, as the program breaks them.
    fn broken(&self, text: String) -> Vec<String> {
        if self.program.bench.language.grammar != Grammar::Apt || text.trim_end().len() <= self.columns {
            return vec![text];
        }
        let mut out = vec![String::new()];
        for part in text.split_inclusive(',') {
            let last = out.last().map_or(0, String::len);
            // Room for the sign that the statement goes on.
            if last > 0 && last + part.trim_end().len() + 1 > self.columns {
                if let Some(full) = out.last_mut() {
                    full.push('$');
                }
                out.push(part.trim_start().to_owned());
            } else if let Some(open) = out.last_mut() {
                open.push_str(part);
            }
        }
        out
    }

    /// How far the rounding of X, Y and Z may move a ball centre, mm.
    pub fn rounding_mm(&self) -> f64 {
        let half = |name: &&str| self.manners.get(*name).map_or(0.0, |m| m.half() * self.unit_mm);
        POINT.iter().map(half).map(|h| h * h).sum::<f64>().sqrt() + READ_MM
    }

    fn block(&self, place: &LineEnd) -> Result<&'a Block, String> {
        self.program.blocks().get(place.block).ok_or_else(|| "a line has no move".into())
    }

    fn moved(&self, place: &LineEnd) -> Result<&'a Moved, String> {
        self.program.moves.get(place.moved).ok_or_else(|| "a line has no move".into())
    }

    /// One line, from the place before it, at which the axes stand in columns, to its end.
    fn line(
        &self,
        [before, place]: [&LineEnd; 2],
        (planned, k): (&Planned, usize),
        (begin, end): (Axes, &Written),
    ) -> Result<NewLine<'a>, String> {
        let block = self.block(place)?;
        let (text, more) = self.statement(block.line).ok_or("it is not there")?;
        let grammar = self.program.bench.language.grammar;
        let words = line::words(&text, grammar).ok_or("it has a form that is not written anew")?;
        self.fits(block, &text, &words)?;
        let own = self.moved(place)?;
        let stands = self.stands([before, place], own, (planned, k), &begin)?;
        let seconds = match self.options.feed_mm_min {
            Some(feed) => 60.0 * (place.stand.centre - before.stand.centre).norm() / feed,
            None => place.seconds.ok_or("it is a rapid")?,
        };
        let share = seconds / (stands.len() + 1) as f64;
        let mut from = begin;
        let mut moves = Vec::with_capacity(stands.len() + 1);
        for stand in stands.iter().map(Some).chain([None]) {
            let written = match stand {
                Some(between) => self.written(block, own, between, &from)?,
                None => end.clone(),
            };
            let share = share.max(self.least_s(own, seconds, (&from, &written.columns)));
            let feed = self.feed(block, own, (&from, &written.columns), share);
            from = written.columns;
            moves.push((written, feed));
        }
        Ok(NewLine { text, more, words, moves })
    }

    /// What becomes of a line, after those before it.
    fn edit(&self, line: NewLine, [before, block]: [&Block; 2], modal: &mut Modal) -> Result<Edit, String> {
        let text = line.text.as_ref();
        let says_feed = line.words.iter().any(|w| w.name == "F");
        if !says_feed && before.feed != block.feed {
            modal.feed = block.feed;
        }
        for word in &line.words {
            let ways = [word.whole.start..word.number.start, word.number.end..word.whole.end];
            let around = ways.map(|r| text.get(r).unwrap_or(""));
            if modal.around.get(&word.name).is_none_or(|was| *was != around) {
                modal.around.insert(word.name.clone(), around.map(str::to_owned));
            }
        }
        let mut edit = Edit { more: line.more, ..Edit::default() };
        let last = line.moves.len().saturating_sub(1);
        for (n, (written, feed)) in line.moves.into_iter().enumerate() {
            if n < last {
                edit.before.extend(self.fresh(&written, feed, modal, n == 0)?);
            } else {
                let (feed_line, new) = self.replaced(text, &line.words, &written, feed, modal)?;
                edit.before.extend(feed_line);
                edit.text = (new != text).then(|| self.broken(new));
            }
            modal.texts.extend(written.words);
        }
        Ok(edit)
    }

    /// The line says what was read of it, as places, and is run once.
    fn fits(&self, block: &Block, text: &str, words: &[Word]) -> Result<(), String> {
        if self.runs.get(&block.line) != Some(&1) {
            return Err("it is run more than once".into());
        }
        if block.steps.contains(&true) || block.ways.contains(&RotaryWay::By) {
            return Err("it says steps".into());
        }
        if block.ways.iter().any(|w| matches!(w, RotaryWay::Up | RotaryWay::Down)) {
            return Err("it says which way an axis turns".into());
        }
        for word in words {
            let Some(read) = read_of(block, &word.name) else { continue };
            let unit = if POINT.contains(&word.name.as_str()) { self.unit_mm } else { 1.0 };
            let said = word.value(text).ok_or("it has a number that is not read")? * unit;
            if (said - read).abs() > AS_READ * unit {
                return Err(format!("its {} says {said}, {read} was read", word.name));
            }
        }
        Ok(())
    }

    /// Where the tool stands at a place, with the new angle.
    fn stand(&self, planned: &Planned, row: usize, place: &LineEnd) -> Stand {
        let theta = planned.schedule.theta.get(row).copied().unwrap_or(f64::NAN);
        Stand { centre: place.stand.centre, cone: planned.course.path.cone(row), theta }
    }

    /// Where the tool is to stand between the ends of the line, as the schedule's motion has it, as
    /// often as keeps the ball on its straight way.
    fn stands(
        &self,
        [before, place]: [&LineEnd; 2],
        own: &Moved,
        (planned, k): (&Planned, usize),
        begin: &Axes,
    ) -> Result<Vec<Stand>, String> {
        let Program { bench, .. } = self.program;
        let place_of = |k: usize| planned.location(k);
        let [a, b] = [place_of(k - 1), place_of(k)];
        let all = &planned.course.path.locations;
        let [Some(from), Some(to)] = [all.get(a), all.get(b)] else { return Err("it has no place".into()) };
        let (start, end) = (self.stand(planned, a, before), self.stand(planned, b, place));
        let at = |share: f64| {
            let straight = planned.schedule.between(&start, &end, share);
            let on_curve = planned.schedule.theta_on_curve([a, b], [from.s_mm, to.s_mm], share);
            Stand { theta: on_curve.unwrap_or(straight.theta), ..straight }
        };
        let there = self.columns(own.words, &end, begin)?;
        let new = Moved { from: *begin, to: there, bend: None, ..*own };
        let off = |m: &Moved| {
            let centre = |f: f64| m.pose(f, bench.tool, bench.machine).centre;
            let (p, q) = (centre(0.0), centre(1.0));
            [0.25, 0.5, 0.75].map(|f| (centre(f) - (p + (q - p) * f)).norm()).into_iter().fold(0.0, f64::max)
        };
        let allowed = (0.5 * self.options.chord_mm).max(off(own));
        let parts = (off(&new) / allowed).sqrt().ceil();
        if parts.is_nan() || parts > MOST_PARTS {
            return Err("the ball would leave its way".into());
        }
        let parts = parts.max(1.0) as usize;
        Ok((1..parts).map(|n| at(n as f64 / parts as f64)).collect())
    }

    /// Positions of the axes, or of the programmed point and the rotary axes, where a tool stands.
    fn columns(&self, words: Programmed, stand: &Stand, near: &Axes) -> Result<Axes, String> {
        let machine = self.program.bench.machine;
        let turned = machine.rotary_of_axis(&stand.axis(), near).ok_or("the machine does not reach it")?;
        Ok(self.with_point(words, &stand.centre, turned))
    }

    fn with_point(&self, words: Programmed, centre: &Point, mut turned: Axes) -> Axes {
        let (tool, machine) = (self.program.bench.tool, self.program.bench.machine);
        let point = match words {
            Programmed::Machine => return machine.linear_at(centre, &turned, tool.length_mm()),
            Programmed::Centre => *centre,
            Programmed::Tip => centre - machine.axis_at(&turned) * tool.radius_mm,
        };
        machine.linear().into_iter().zip(point.iter()).for_each(|(k, v)| turned[k] = *v);
        turned
    }

    /// A stand in words: the rotary words are rounded first, so that the point keeps the ball where
    /// it is.
    fn written(&self, block: &Block, own: &Moved, stand: &Stand, near: &Axes) -> Result<Written, String> {
        let machine = self.program.bench.machine;
        let line_from_words = own.words_from_line.inverse();
        let turned = machine.rotary_of_axis(&stand.axis(), near).ok_or("the machine does not reach it")?;
        let mut words = Vec::new();
        let rounded = match block.place {
            Destination::Words { .. } => self.rotary_words(block, &turned, near, &mut words)?,
            Destination::Vector { .. } => {
                let names = self.vector_names();
                let manners = names.map(|n| self.manners.get(n).copied());
                let [Some(i), Some(j), Some(k)] = manners else { return Err("it has no vector".into()) };
                let axis = line_from_words.rotation * stand.axis();
                let values = [(i, axis.x), (j, axis.y), (k, axis.z)].map(|(m, v)| m.said(v));
                let said = Vector::from(values.each_ref().map(|(_, v)| *v));
                words.extend(names.iter().zip(values).map(|(n, (text, _))| ((*n).to_owned(), text)));
                let axis = own.words_from_line.rotation * said;
                machine.rotary_of_axis(&axis, near).ok_or("the machine does not reach it")?
            }
        };
        let mut columns = self.with_point(own.words, &stand.centre, rounded);
        let linear = machine.linear();
        let point = line_from_words * Point::from(linear.map(|k| columns[k]));
        let mut said = [0.0; 3];
        for (i, name) in POINT.iter().enumerate() {
            let manner = self.manners.get(*name).copied().ok_or_else(|| format!("no line has a word {name}"))?;
            let (text, value) = manner.said(point[i] / self.unit_mm);
            words.insert(i, ((*name).to_owned(), text));
            said[i] = value * self.unit_mm;
        }
        let place = own.words_from_line * Point::from(said);
        linear.into_iter().zip(place.iter()).for_each(|(k, v)| columns[k] = *v);
        Ok(Written { words, columns })
    }

    /// Words of the rotary axes, and these as the words have them.
    fn rotary_words(
        &self,
        block: &Block,
        turned: &Axes,
        near: &Axes,
        words: &mut Vec<(String, String)>,
    ) -> Result<Axes, String> {
        let machine = self.program.bench.machine;
        let mut rounded = *turned;
        for k in machine.rotary() {
            let letter = machine.axes()[k].letter.letter();
            let Some(manner) = self.manners.get(letter) else {
                if (turned[k] - near[k]).abs() > AS_READ {
                    return Err(format!("no line has a word {letter}"));
                }
                rounded[k] = near[k];
                continue;
            };
            let deg = turned[k].to_degrees();
            let way = ["A", "B", "C"].iter().position(|l| *l == letter).and_then(|w| block.ways.get(w));
            let is_within_turn = way == Some(&RotaryWay::Shorter);
            let (text, said) = manner.said(deg);
            let text = if is_within_turn { manner.text(said.rem_euclid(360.0)) } else { text };
            words.push((letter.to_owned(), text));
            rounded[k] = said.to_radians();
        }
        Ok(rounded)
    }

    fn vector_names(&self) -> [&'static str; 3] {
        match self.program.bench.language.grammar {
            Grammar::Heidenhain => ["TX", "TY", "TZ"],
            Grammar::Gcode if self.manners.contains_key("A3") => ["A3", "B3", "C3"],
            Grammar::Gcode | Grammar::Apt => ["I", "J", "K"],
        }
    }

    /// The least time of a move in which no axis is asked for more than it can, s, or than the line
    /// asked of it in `seconds`.
    fn least_s(&self, own: &Moved, seconds: f64, (from, to): (&Axes, &Axes)) -> f64 {
        let Program { bench, .. } = self.program;
        let ways = |m: &Moved| {
            let [a, b] = [0.0, 1.0].map(|f| m.axes(f, bench.tool, bench.machine));
            (0..bench.machine.axes().len()).map(move |k| (b[k] - a[k]).abs())
        };
        let new = ways(&Moved { from: *from, to: *to, bend: None, ..*own });
        let least =
            |((was, way), axis): ((f64, f64), &crate::machine::Axis)| way / axis.limits.velocity.max(was / seconds);
        ways(own).zip(new).zip(bench.machine.axes()).map(least).fold(0.0, f64::max)
    }

    /// The feed with which a move takes its time; that of the block where the move takes none.
    fn feed(&self, block: &Block, own: &Moved, (from, to): (&Axes, &Axes), seconds: f64) -> Feed {
        match block.feed {
            Feed::PerMinute(f) => {
                let (machine, language) = (self.program.bench.machine, self.program.bench.language);
                let way = |m: &Moved| {
                    let of = |k: usize| m.to[k] - m.from[k];
                    let goes: f64 = machine.linear().map(of).iter().map(|d| d * d).sum();
                    let turns: f64 = machine.rotary().map(|k| of(k).to_degrees().powi(2)).sum();
                    (goes + if language.feed_counts_degrees { turns } else { 0.0 }).sqrt()
                };
                let way = way(&Moved { from: *from, to: *to, bend: None, ..*own });
                if way > 0.0 && seconds > 0.0 { Feed::PerMinute(60.0 * way / seconds) } else { Feed::PerMinute(f) }
            }
            Feed::PerMove(_) => Feed::PerMove(60.0 / seconds),
            Feed::Rapid => Feed::Rapid,
        }
    }

    /// The number of a feed word, where the feed is not the one in force.
    fn feed_text(&self, feed: Feed, modal: &mut Modal, always: bool) -> Result<Option<String>, String> {
        let ([was, now], unit) = match (modal.feed, feed) {
            (Feed::PerMinute(was), Feed::PerMinute(now)) => ([was, now], self.unit_mm),
            (Feed::PerMove(was), Feed::PerMove(now)) => ([was, now], 1.0),
            _ => return Ok(None),
        };
        let per_move = matches!(feed, Feed::PerMove(_));
        if !always && !modal.says_feed && !per_move && (now / was - 1.0).abs() <= FEED_SHARE {
            return Ok(None);
        }
        let manner = self.feed_manner().ok_or("the program has no word of a feed")?;
        // A feed that changed little stays as it is written.
        let value = if (now / was - 1.0).abs() <= FEED_SHARE && !per_move { was } else { now };
        let said = manner.rounded(value / unit) * unit;
        if !(said > 0.0) {
            return Err("its feed is too low for the digits that the program has".into());
        }
        modal.says_feed = false;
        modal.feed = if per_move { Feed::PerMove(said) } else { Feed::PerMinute(said) };
        Ok(Some(manner.text(value / unit)))
    }

    fn feed_manner(&self) -> Option<Manner> {
        let of_line = || self.feed_line.as_ref().and_then(|(l, at)| l.get(at.clone()).map(Manner::of_number));
        self.manners.get("F").copied().or_else(of_line)
    }

    /// The line with its numbers replaced; and, in files of cutter locations, a line before it that
    /// sets its feed.
    fn replaced(
        &self,
        text: &str,
        words: &[Word],
        written: &Written,
        feed: Feed,
        modal: &mut Modal,
    ) -> Result<(Option<String>, String), String> {
        let (mut new, mut added) = (Vec::new(), String::new());
        let differs = |name: &str, number: &String| modal.texts.get(name) != Some(number);
        // A component that is left out is 0, or the next one's: of a vector all are said, or none.
        let vector = self.vector_names();
        let turns = written.words.iter().any(|(name, number)| vector.contains(&name.as_str()) && differs(name, number));
        for (name, number) in &written.words {
            if let Some(k) = words.iter().position(|w| w.name == *name) {
                new.push((k, number.clone()));
            } else if differs(name, number) || turns && vector.contains(&name.as_str()) {
                added.push_str(&self.word(name, number, modal));
            }
        }
        let at = words.iter().position(|w| w.name == "F");
        let number = self.feed_text(feed, modal, at.is_some())?;
        let mut feed_line = None;
        match (number, at) {
            (Some(number), Some(k)) => new.push((k, number)),
            (Some(number), None) if self.program.bench.language.grammar == Grammar::Apt => {
                feed_line = Some(self.feed_statement(&number)?);
            }
            (Some(number), None) => added.push_str(&self.word("F", &number, modal)),
            (None, _) => {}
        }
        Ok((feed_line, manner::written(text, words, &new, &added)))
    }

    /// A word to be added to a line.
    fn word(&self, name: &str, number: &str, modal: &Modal) -> String {
        if self.program.bench.language.grammar == Grammar::Apt {
            return format!(",{number}");
        }
        let usual = || [if name.len() > 1 { format!("{name}=") } else { name.to_owned() }, String::new()];
        let is_klartext = self.program.bench.language.grammar == Grammar::Heidenhain;
        let [before, behind] = modal
            .around
            .get(name)
            .cloned()
            .unwrap_or_else(|| if is_klartext { [name.to_owned(), String::new()] } else { usual() });
        format!(" {before}{number}{behind}")
    }

    /// A line of its own, and in files of cutter locations one before it that sets its feed.
    fn fresh(&self, written: &Written, feed: Feed, modal: &mut Modal, first: bool) -> Result<Vec<String>, String> {
        let number = self.feed_text(feed, modal, first)?;
        let all = |words: &[(String, String)]| words.iter().map(|(n, t)| self.word(n, t, modal)).collect::<String>();
        Ok(match self.program.bench.language.grammar {
            Grammar::Apt => {
                let numbers: Vec<&str> = written.words.iter().map(|(_, t)| t.as_str()).collect();
                let feed = number.map(|n| self.feed_statement(&n)).transpose()?;
                feed.into_iter().chain(self.broken(format!("GOTO/{}", numbers.join(",")))).collect()
            }
            grammar => {
                let is_vector = written.words.iter().any(|(n, _)| n == "TX");
                let begins = match (grammar, is_vector) {
                    (Grammar::Heidenhain, true) => "0 LN",
                    (Grammar::Heidenhain, false) => "0 L",
                    _ => "G1",
                };
                let feed = number.map(|n| self.word("F", &n, modal)).unwrap_or_default();
                vec![format!("{begins}{}{feed}", all(&written.words))]
            }
        })
    }

    /// `FEDRAT/500,MMPM` with another number.
    fn feed_statement(&self, number: &str) -> Result<String, String> {
        let (text, at) = self.feed_line.as_ref().ok_or("the program has no FEDRAT")?;
        let mut out = (*text).to_owned();
        out.replace_range(at.clone(), number);
        Ok(out)
    }

    /// The feed of the line behind a stretch, where that does not say its own.
    fn restore_feed(&self, last: &LineEnd, modal: &Modal, edits: &mut Edits) -> Result<(), String> {
        let blocks = self.program.blocks();
        let own = self.block(last)?.feed;
        let next = blocks.iter().skip(last.block + 1).find(|b| b.feed != Feed::Rapid);
        let Some(next) = next.filter(|b| b.feed == own && modal.feed != own) else { return Ok(()) };
        let (Feed::PerMinute(value), Some((text, more))) = (own, self.statement(next.line)) else { return Ok(()) };
        let text = text.as_ref();
        let grammar = self.program.bench.language.grammar;
        let manner = self.feed_manner().ok_or("the program has no word of a feed")?;
        let number = manner.text(value / self.unit_mm);
        if self.runs.get(&next.line) != Some(&1) {
            return Err(format!(
                "line {} behind it would need the feed that it had, and is run more than once",
                next.line
            ));
        }
        let edit = edits.0.entry(next.line - 1).or_insert_with(|| Edit { more, ..Edit::default() });
        if grammar == Grammar::Apt {
            edit.before.insert(0, self.feed_statement(&number)?);
            return Ok(());
        }
        let form = || format!("line {} behind it has a form that is not written anew", next.line);
        let words = line::words(text, grammar).ok_or_else(form)?;
        if !words.iter().any(|w| w.name == "F") {
            let added = self.word("F", &number, modal);
            edit.text = Some(vec![manner::written(text, &words, &[], &added)]);
        }
        Ok(())
    }
}

/// The statement that ends in a line, from 1, and how many lines before that belong to it: in files
/// of cutter locations a line that ends in `$` goes on in the next.
fn statement<'a>(lines: &[&'a str], line: usize, grammar: Grammar) -> Option<(Cow<'a, str>, usize)> {
    let last = line.checked_sub(1)?;
    let text = *lines.get(last)?;
    let goes_on = |k: usize| lines.get(k).is_some_and(|l| l.trim_end().ends_with('$') && !l.contains("$$"));
    let more = (0..last).rev().take_while(|k| grammar == Grammar::Apt && goes_on(*k)).count();
    if more == 0 {
        return Some((Cow::Borrowed(text), 0));
    }
    let parts = lines.get(last - more..last)?.iter().map(|l| l.trim_end().trim_end_matches('$').trim_end());
    Some((Cow::Owned(parts.chain([text.trim_start()]).collect()), more))
}

/// What was read of a word of a line, mm or degrees, or of its vector; `None`: it has no position.
fn read_of(block: &Block, name: &str) -> Option<f64> {
    let axis = ["X", "Y", "Z", "A", "B", "C"].iter().position(|n| *n == name);
    match (block.place, axis) {
        (Destination::Words { point, rotary }, Some(k)) => {
            if k < 3 {
                point[k]
            } else {
                rotary[k - 3]
            }
        }
        (Destination::Vector { point, .. }, Some(k)) if k < 3 => point[k],
        _ => None,
    }
}

/// The bytes of the number of a `FEDRAT` statement.
fn feed_number(line: &str) -> Option<std::ops::Range<usize>> {
    let code = line.split('$').next().unwrap_or("");
    let (major, rest) = code.split_once('/')?;
    if !major.trim().eq_ignore_ascii_case("FEDRAT") {
        return None;
    }
    let mut at = major.len() + 1;
    for part in rest.split(',') {
        let from = at + (part.len() - part.trim_start().len());
        if part.trim().parse::<f64>().is_ok() {
            return Some(from..from + part.trim().len());
        }
        at += part.len() + 1;
    }
    None
}
