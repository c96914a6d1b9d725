//! A post file: how one control wants its programs, as data. The built-in ones are such files too.
//!
//! A program is a list of *sections* in a fixed order, each a list of lines:
//!
//! ```text
//! file_begin  header (warnings within)  notes  start  turn_in …  approach  plunge  cutting  turn cut …  cutting_end  leave  retract  unwind  end  file_end
//! ```
//!
//! In a program of several operations all from `header` to `unwind` comes once for each, with
//! `operation_end` between two. `start` sees the safe position over the first location, `approach`
//! the feed height, `plunge` the first location, `cut` (once for each move) every location after
//! it, `turn` (before the first cut of each turn) its number and the place where it begins, `leave`
//! the feed height over the last location, `retract` the safe position over it, `unwind` the first
//! location again. With `turn_in` the table stands at 0 in `start` and behind `unwind`, and
//! `turn_in` is written for each place on the way from there to the safe position. A line beginning
//! with `; ` is a comment; any other is a block. `{key}` stands for a value and `{key:3}` for one
//! with three digits after the point; the keys are those of [`KEYS`]. Words that repeat the value
//! before are left out for the keys in `modal`. The line `{look_ahead}` in `start` stands for all
//! lines of `look_ahead`, `{look_ahead_end}` in `retract` for those of `look_ahead_end`; both are
//! left out where the job says `post.look_ahead = false`.
//!
//! `[ranges]` is what the control reads in its words: the writer keeps within it, or says where it
//! cannot, and the program's text is held against it once more when it is read back.
//!
//! `[pinch]` and `[pinch_channels]` are the lines of programs of two tools: [`PinchText`].
//!
//! With `poly_degree` cuts are polynomials, `{px}` to `{pb}`, or spline lines of degree 3, `{kx}`
//! to `{ka}`: see [`super::polynomial`].

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::pinch_text::PinchText;
use super::template::{TemplateLine, lines};
use crate::artifact::program::{Control, Grammar, Language, Programmed, Ranges, WordRange};
use crate::error::{Error, Result, Stage};
use crate::settings::from_toml;

/// What rotary words say.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum Rotary {
    /// Positions, growing over all turns: right where `A` is a linear axis to the control.
    Accumulate,
    /// Steps from line to line (`{da}`): right on a modulo axis and on a linear one, since absolute
    /// words beyond 360° mean different things on modulo axes, depending on machine data. Steps are
    /// of rounded positions: nothing adds up.
    Incremental,
    /// Positions in `0 … 360`; the control goes the shorter way: by itself, or because the word
    /// says so (`{a_way}({a})`). Nothing adds up.
    Modulo,
    /// None: the tool axis as a vector (`{i} {j} {k}`).
    Vector,
}

/// What F means on cutting lines.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum FeedWord {
    /// `F = 1 / Δt`, 1/min: the control needs no notion of what a feed means for a line that turns
    /// and moves at once.
    InverseTime,
    /// mm/min of the programmed point; degrees/min on lines that turn only.
    PerMinute,
    /// Along all axes of the line together, each degree counted as a millimetre: what Fanuc means
    /// by F where linear and rotary axes are interpolated without tool-centre-point control.
    PerMinuteOfAll,
}

/// Which blocks have a number.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum Numbered {
    /// All.
    #[default]
    Blocks,
    /// The first of every operation, of every turn and of the retract: where an operator goes on.
    Turns,
}

/// Numbers of lines.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Numbering {
    /// Before the number.
    #[serde(default)]
    pub prefix: String,
    /// First number; counting begins there again behind the greatest that `ranges` has for the
    /// prefix.
    pub first: u64,
    /// From line to line.
    pub step: u64,
    /// Comments and the lines around the program are numbered too.
    #[serde(default)]
    pub everything: bool,
    /// Which blocks have one.
    #[serde(default)]
    pub at: Numbered,
}

/// How numbers are written.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Numbers {
    /// Digits after the point of lengths, 3 to 6.
    pub length_decimals: usize,
    /// Digits after the point of angles in degrees, 3 to 6.
    pub angle_decimals: usize,
    /// Digits after the point of a vector's components, 5 to 9.
    #[serde(default = "Numbers::eight")]
    pub vector_decimals: usize,
    /// A plus sign before what is not negative.
    #[serde(default)]
    pub plus: bool,
    /// No zeros at the end, but the point stays: `10.` and `0.5`.
    #[serde(default)]
    pub trim: bool,
}

impl Numbers {
    fn eight() -> usize {
        8
    }
}

/// How a smooth curve is written as polynomials.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct CurveNumbers {
    /// Digits after the point of lengths and angles, 5 to 9: derivatives at joints are as good as
    /// these.
    pub decimals: usize,
    /// Longest line then.
    pub longest_line: usize,
}

/// The sections of a program as they stand in the file.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Text {
    /// Comments right under the program's name: what must not be missed.
    #[serde(default)]
    pub warnings: Vec<String>,
    /// Comments after the header.
    #[serde(default)]
    pub notes: Vec<String>,
    /// Up to the safe position over the first location; with `turn_in` up to where
    /// tool-centre-point control comes on, with the table at 0.
    pub start: Vec<String>,
    /// From there in steps, the table turning, to the safe position: for a control that fixes X, Y,
    /// Z to the table as it stands when tool-centre-point control comes on. Without it the table
    /// has turned before.
    #[serde(default)]
    pub turn_in: Vec<String>,
    /// What switches the control's high-speed cutting on: stands for the line `{look_ahead}` of
    /// `start`.
    #[serde(default)]
    pub look_ahead: Vec<String>,
    /// What switches it off: stands for the line `{look_ahead_end}` of `retract`.
    #[serde(default)]
    pub look_ahead_end: Vec<String>,
    /// To the feed height.
    pub approach: Vec<String>,
    /// To the first location.
    pub plunge: Vec<String>,
    /// Before the first cut.
    #[serde(default)]
    pub cutting: Vec<String>,
    /// Before the first cut of each turn.
    #[serde(default)]
    pub turn: Vec<String>,
    /// Each cut.
    pub cut: Vec<String>,
    /// First line of a curve, with rank, first knot and control point, and the feed of all of it:
    /// where the plan has a programmed curve its cuts are B-splines of degree 3 then.
    #[serde(default)]
    pub curve_begin: Vec<String>,
    /// Each further control point with its knot.
    #[serde(default)]
    pub curve_point: Vec<String>,
    /// Each of the last four knots.
    #[serde(default)]
    pub curve_knot: Vec<String>,
    /// After the last cut.
    #[serde(default)]
    pub cutting_end: Vec<String>,
    /// Off the part to the feed height.
    pub leave: Vec<String>,
    /// To the safe position, and home.
    pub retract: Vec<String>,
    /// Back to the first position of `A`, with `turn_in` to 0; left out where the part may not turn
    /// freely.
    #[serde(default)]
    pub unwind: Vec<String>,
    /// Between two operations: behind the retract and the unwinding of one, before the tool call in
    /// `start` of the next.
    #[serde(default)]
    pub operation_end: Vec<String>,
    /// The end.
    pub end: Vec<String>,
}

/// The file.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct PostFile {
    /// The control, in words.
    pub name: String,
    /// File name of programs.
    pub file: String,
    /// How programs are read back.
    pub grammar: Grammar,
    /// What X, Y, Z mean.
    pub programmed: Programmed,
    /// What rotary words say.
    pub rotary: Rotary,
    /// Bare words of the rotary axis that turns the blade go the shorter way (M126, roll-over
    /// axes). Default: where `rotary` is `modulo` and its words do not say so themselves.
    #[serde(default)]
    pub shortest_way: Option<bool>,
    /// What F means.
    pub feed: FeedWord,
    /// What the control reads in its words, by address: `F = { least = 0.001, greatest = 99999.999,
    /// decimals = 3 }`. Words that are not named may be anything.
    #[serde(default)]
    pub ranges: Ranges,
    /// Step in which the control computes positions, mm. The tolerance that it may smooth by is
    /// then what the checks leave of the gouge limit, in whole steps and at least one; without this
    /// key it is the chord tolerance of the path times `tolerance_factor`.
    #[serde(default)]
    pub resolution_mm: Option<f64>,
    /// Before and after a comment.
    pub comment: [String; 2],
    /// Longest line.
    pub longest_line: usize,
    /// Cuts are polynomials of at most this degree, 3 to 5, instead of straight moves
    /// (`PO[X]=({px})`); each as its end and the coefficients of `p²`, `p³` … for `p` from 0 to 1.
    /// With `rotary = "incremental"` the ends of all words are steps: `text.cutting` then has to
    /// say `G91`.
    #[serde(default)]
    pub poly_degree: Option<usize>,
    /// At the end of a line that goes on, after a comma; without it a block that is too long is an
    /// error.
    #[serde(default)]
    pub continuation: Option<String>,
    /// The control's tolerance over the chord tolerance of the path.
    #[serde(default = "PostFile::one")]
    pub tolerance_factor: f64,
    /// Keys whose words are left out while their value stays.
    #[serde(default)]
    pub modal: Vec<String>,
    /// The first lines of the file.
    #[serde(default)]
    pub file_begin: Vec<String>,
    /// The last lines of the file.
    #[serde(default)]
    pub file_end: Vec<String>,
    /// Numbers of lines; without it there are none.
    #[serde(default)]
    pub numbering: Option<Numbering>,
    /// How numbers are written.
    pub numbers: Numbers,
    /// Where cuts are polynomials and the plan has a smooth curve: more digits, and the longer
    /// lines that they take.
    #[serde(default)]
    pub curve: Option<CurveNumbers>,
    /// The program.
    pub text: Text,
    /// Programs of two tools on one blade, all axes of both heads in one channel; without it there
    /// are none.
    #[serde(default)]
    pub pinch: Option<PinchText>,
    /// The same in two channels, a program for each.
    #[serde(default)]
    pub pinch_channels: Option<PinchText>,
}

impl PostFile {
    /// Cuts are spline lines, `{kx}` to `{ka}`.
    pub(super) fn has_spline_lines(&self) -> bool {
        self.text.cut.concat().contains("{kx}")
    }
    fn shortest_way(&self) -> bool {
        self.shortest_way.unwrap_or(self.rotary == Rotary::Modulo && !self.text.cut.concat().contains("{a_way}"))
    }
    /// What F may be.
    pub(super) fn feed_range(&self) -> WordRange {
        let any = WordRange { least: 0.001, greatest: 999_999.999, decimals: 6 };
        self.ranges.get("F").copied().unwrap_or(any)
    }
    /// The greatest number that a block may have.
    pub(super) fn greatest_number(&self) -> Option<u64> {
        let prefix = &self.numbering.as_ref()?.prefix;
        // Checked to be at least the first number.
        self.ranges.get(prefix).map(|r| r.greatest as u64)
    }
    fn one() -> f64 {
        1.0
    }
}

/// A post file that has been checked, its lines taken apart.
#[derive(Clone, Debug)]
pub struct Dialect {
    /// As in the file.
    pub(super) file: PostFile,
    pub(super) file_begin: Vec<TemplateLine>,
    pub(super) warnings: Vec<TemplateLine>,
    pub(super) notes: Vec<TemplateLine>,
    pub(super) start: Vec<TemplateLine>,
    pub(super) turn_in: Vec<TemplateLine>,
    pub(super) approach: Vec<TemplateLine>,
    pub(super) plunge: Vec<TemplateLine>,
    pub(super) cutting: Vec<TemplateLine>,
    pub(super) turn: Vec<TemplateLine>,
    pub(super) cut: Vec<TemplateLine>,
    pub(super) curve_begin: Vec<TemplateLine>,
    pub(super) curve_point: Vec<TemplateLine>,
    pub(super) curve_knot: Vec<TemplateLine>,
    pub(super) cutting_end: Vec<TemplateLine>,
    pub(super) leave: Vec<TemplateLine>,
    pub(super) retract: Vec<TemplateLine>,
    pub(super) unwind: Vec<TemplateLine>,
    pub(super) operation_end: Vec<TemplateLine>,
    pub(super) end: Vec<TemplateLine>,
    pub(super) file_end: Vec<TemplateLine>,
}

impl Control {
    /// The built-in post file.
    pub fn post_file(self) -> &'static str {
        match self {
            Control::Siemens => include_str!("../../../models/posts/siemens.toml"),
            Control::SiemensVector => include_str!("../../../models/posts/siemens_vector.toml"),
            Control::SiemensPoly => include_str!("../../../models/posts/siemens_poly.toml"),
            Control::SiemensAxes => include_str!("../../../models/posts/siemens_axes.toml"),
            Control::Heidenhain => include_str!("../../../models/posts/heidenhain.toml"),
            Control::HeidenhainSpl => include_str!("../../../models/posts/heidenhain_spl.toml"),
            Control::HeidenhainVector => include_str!("../../../models/posts/heidenhain_vector.toml"),
            Control::Fanuc => include_str!("../../../models/posts/fanuc.toml"),
            Control::FanucVector => include_str!("../../../models/posts/fanuc_vector.toml"),
            Control::FanucAxes => include_str!("../../../models/posts/fanuc_axes.toml"),
            Control::FanucNurbs => include_str!("../../../models/posts/fanuc_nurbs.toml"),
            Control::Linuxcnc => include_str!("../../../models/posts/linuxcnc.toml"),
            Control::LinuxcncFeed => include_str!("../../../models/posts/linuxcnc_feed.toml"),
            Control::Iso => include_str!("../../../models/posts/iso.toml"),
            Control::Apt => include_str!("../../../models/posts/apt.toml"),
        }
    }
}

impl Dialect {
    /// A built-in one.
    ///
    /// # Errors
    /// As [`Dialect::from_toml`]; the built-in files pass.
    pub fn built_in(control: Control) -> Result<Self> {
        Self::from_toml(control.post_file(), "built-in post file")
    }

    /// As it is for a plan with a smooth curve.
    pub(super) fn on_curve(&self) -> std::borrow::Cow<'_, Dialect> {
        let Some(curve) = self.file.curve.filter(|_| self.file.poly_degree.is_some()) else {
            return std::borrow::Cow::Borrowed(self);
        };
        let mut finer = self.clone();
        finer.file.numbers.length_decimals = curve.decimals;
        finer.file.numbers.angle_decimals = curve.decimals;
        finer.file.longest_line = curve.longest_line;
        std::borrow::Cow::Owned(finer)
    }

    /// Reads the text of a post file; `origin` names it in messages.
    ///
    /// # Errors
    /// Kind `Usage`: not TOML, an unknown or missing key, an unknown value in a line, or a number
    /// out of its range; with the place.
    pub fn from_toml(text: &str, origin: &str) -> Result<Self> {
        let file: PostFile = from_toml(text).map_err(|e| {
            let place = e.line.map(|n| format!(" line {n}")).unwrap_or_default();
            Error::usage(Stage::Post, format!("{origin}{place}: {}", e.words))
                .advise("models/posts/siemens.toml shows every key")
        })?;
        file.validate(origin)?;
        let take =
            |name: &str, text: &[String]| lines(text, &file.modal).map_err(|e| bad(origin, format!("{name}: {e}")));
        let filled = |name: &str, text: &[String], mark: &str, with: &[String]| -> Result<Vec<TemplateLine>> {
            let mut out = Vec::new();
            for part in text.split_inclusive(|line| line == mark) {
                let (own, marked) = part.split_at(part.len() - usize::from(part.last().is_some_and(|l| l == mark)));
                out.extend(take(name, own)?);
                if !marked.is_empty() {
                    out.extend(take(name, with)?.into_iter().map(|l| TemplateLine { look_ahead: true, ..l }));
                }
            }
            Ok(out)
        };
        let t = &file.text;
        Ok(Dialect {
            file_begin: take("file_begin", &file.file_begin)?,
            warnings: take("text.warnings", &comments(&t.warnings))?,
            notes: take("text.notes", &comments(&t.notes))?,
            start: filled("text.start", &t.start, LOOK_AHEAD, &t.look_ahead)?,
            turn_in: take("text.turn_in", &t.turn_in)?,
            approach: take("text.approach", &t.approach)?,
            plunge: take("text.plunge", &t.plunge)?,
            cutting: take("text.cutting", &t.cutting)?,
            turn: take("text.turn", &t.turn)?,
            cut: take("text.cut", &t.cut)?,
            curve_begin: take("text.curve_begin", &t.curve_begin)?,
            curve_point: take("text.curve_point", &t.curve_point)?,
            curve_knot: take("text.curve_knot", &t.curve_knot)?,
            cutting_end: take("text.cutting_end", &t.cutting_end)?,
            leave: take("text.leave", &t.leave)?,
            retract: filled("text.retract", &t.retract, LOOK_AHEAD_END, &t.look_ahead_end)?,
            unwind: take("text.unwind", &t.unwind)?,
            operation_end: take("text.operation_end", &t.operation_end)?,
            end: take("text.end", &t.end)?,
            file_end: take("file_end", &file.file_end)?,
            file,
        })
    }

    /// The control, in words.
    pub fn name(&self) -> &str {
        &self.file.name
    }

    /// File name of its programs.
    pub fn file_name(&self) -> &str {
        &self.file.file
    }

    /// Curves are written as control points and knots.
    pub(super) fn has_curves(&self) -> bool {
        !self.curve_begin.is_empty()
    }

    /// The table turns in under tool-centre-point control.
    pub(super) fn turns_in(&self) -> bool {
        !self.turn_in.is_empty()
    }

    /// Its unwinding takes less than a turn on an axis that turns without end.
    pub(super) fn turns_back_by_the_shorter_way(&self) -> bool {
        self.file.shortest_way() || self.file.text.unwind.concat().contains("{a_way}")
    }

    /// How its programs are to be understood.
    pub fn language(&self) -> Language {
        Language {
            grammar: self.file.grammar,
            programmed: self.file.programmed,
            shortest_way: self.file.shortest_way(),
            feed_counts_degrees: self.file.feed == FeedWord::PerMinuteOfAll,
        }
    }
}

fn bad(origin: &str, what: String) -> Error {
    Error::usage(Stage::Post, format!("{origin}: {what}")).advise("models/posts/siemens.toml shows every key")
}

/// Lines that stand for those of `look_ahead` and `look_ahead_end`.
const LOOK_AHEAD: &str = "{look_ahead}";
const LOOK_AHEAD_END: &str = "{look_ahead_end}";

/// Notes are comments without having to say so.
fn comments(notes: &[String]) -> Vec<String> {
    notes.iter().map(|n| format!("; {n}")).collect()
}

impl PostFile {
    /// What is wrong with ranges and steps.
    fn ranges_do_not_fit(&self) -> Option<String> {
        for (address, r) in &self.ranges {
            if !(r.least < r.greatest && r.least.is_finite() && r.greatest.is_finite() && r.decimals <= 9) {
                return Some(format!("ranges.{address}: least must be smaller than greatest, and decimals at most 9"));
            }
        }
        if self.feed_range().least <= 0.0 {
            return Some("ranges.F: least must be greater than 0".into());
        }
        let first = self.numbering.as_ref().map(|n| (n.first, &n.prefix));
        match (first, self.greatest_number()) {
            (Some((first, prefix)), Some(greatest)) if first > greatest => {
                return Some(format!("numbering.first is {first}, ranges.{prefix} goes up to {greatest}"));
            }
            _ => {}
        }
        let step = self.resolution_mm.is_none_or(|r| r > 0.0 && r <= 1.0);
        (!step).then(|| "resolution_mm must be greater than 0 and at most 1".into())
    }

    /// Lines of `look_ahead` that no line of the program stands for.
    fn look_ahead_is_lost(&self) -> Option<String> {
        let t = &self.text;
        [
            ("look_ahead", &t.look_ahead, LOOK_AHEAD, &t.start),
            ("look_ahead_end", &t.look_ahead_end, LOOK_AHEAD_END, &t.retract),
        ]
        .into_iter()
        .find(|(_, with, mark, lines)| !with.is_empty() && !lines.iter().any(|l| l == mark))
        .map(|(name, _, mark, _)| format!("text.{name} has lines, but no line {mark} stands for them"))
    }

    /// What is wrong with lines of curves.
    fn curves_do_not_fit(&self) -> Option<String> {
        let t = &self.text;
        let lines = [("curve_begin", &t.curve_begin), ("curve_point", &t.curve_point), ("curve_knot", &t.curve_knot)];
        if lines.iter().all(|(_, l)| l.is_empty()) {
            return None;
        }
        let place = ["{knot}", "{x}", "{y}", "{z}", "{a}"];
        for ((name, line), keys) in lines.into_iter().zip([&place[..], &place, &place[..1]]) {
            if line.len() != 1 {
                return Some(format!(
                    "text.{name} must be one line, as curve_begin, curve_point and curve_knot all are"
                ));
            }
            if let Some(missing) = keys.iter().find(|key| !line.concat().contains(**key)) {
                return Some(format!("text.{name} must have {missing}"));
            }
        }
        if !t.curve_begin.concat().contains("{f}") {
            return Some("text.curve_begin must have {f}".into());
        }
        let fits = self.grammar == Grammar::Gcode && self.poly_degree.is_none() && self.feed != FeedWord::InverseTime;
        if !fits || self.rotary != Rotary::Accumulate || !self.modal.is_empty() {
            return Some(
                "curves need grammar = \"gcode\", rotary = \"accumulate\", F in mm/min, no modal words and no poly_degree"
                    .into(),
            );
        }
        None
    }

    fn validate(&self, origin: &str) -> Result<()> {
        let no = |what: &str| Err(bad(origin, what.into()));
        let plain = |name: &str| {
            !name.is_empty()
                && name.chars().all(|c| c.is_ascii_alphanumeric() || "._-".contains(c))
                && !name.starts_with('.')
        };
        if !plain(&self.file) {
            return no("`file` must be a file name of letters, digits, points, - and _");
        }
        for (name, digits, range) in [
            ("length_decimals", self.numbers.length_decimals, 3..=6),
            ("angle_decimals", self.numbers.angle_decimals, 3..=6),
            ("vector_decimals", self.numbers.vector_decimals, 5..=9),
        ] {
            if !range.contains(&digits) {
                return no(&format!("numbers.{name} is {digits}, it must be {} to {}", range.start(), range.end()));
            }
        }
        if let Some(curve) = &self.curve {
            if !(5..=9).contains(&curve.decimals) {
                return no(&format!("curve.decimals is {}, it must be 5 to 9", curve.decimals));
            }
            if !(40..=1000).contains(&curve.longest_line) {
                return no("curve.longest_line must be 40 to 1000");
            }
        }
        if let Some(what) = self.ranges_do_not_fit().or_else(|| self.look_ahead_is_lost()) {
            return no(&what);
        }
        if !(self.tolerance_factor > 0.0 && self.tolerance_factor <= 10.0) {
            return no("tolerance_factor must be greater than 0 and at most 10");
        }
        if !(40..=1000).contains(&self.longest_line) {
            return no("longest_line must be 40 to 1000");
        }
        if self.text.cut.is_empty() {
            return no("text.cut must have at least one line");
        }
        let two = [("pinch", &self.pinch), ("pinch_channels", &self.pinch_channels)];
        if let Some(what) = two.into_iter().find_map(|(name, text)| text.as_ref()?.wrong(name)) {
            return no(&what);
        }
        if self.grammar != Grammar::Gcode && two.iter().any(|(_, text)| text.is_some()) {
            return no("pinch and pinch_channels need grammar = \"gcode\"");
        }
        if let Some(what) = self.curves_do_not_fit() {
            return no(&what);
        }
        let cut = self.text.cut.concat();
        let polynomial = ["{px}", "{py}", "{pz}"].map(|key| cut.contains(key));
        let spline = ["{kx}", "{ky}", "{kz}", "{ka}"].map(|key| cut.contains(key));
        let is_more = self.poly_degree.is_some() || two.iter().any(|(_, text)| text.is_some());
        if self.feed == FeedWord::PerMinuteOfAll && (is_more || self.programmed != Programmed::Machine) {
            return no(
                "feed = \"per-minute-of-all\" needs programmed = \"machine\", and neither poly_degree nor pinch",
            );
        }
        let Some(degree) = self.poly_degree else {
            return match (polynomial.contains(&true), spline.contains(&true)) {
                (true, _) => no("{px}, {py} and {pz} need poly_degree"),
                (_, true) => no("{kx}, {ky}, {kz} and {ka} need poly_degree"),
                _ => Ok(()),
            };
        };
        if spline.contains(&true) {
            return match (degree, self.rotary, spline.contains(&false)) {
                (_, _, true) => no("spline lines need all of {kx}, {ky}, {kz} and {ka}"),
                (3, Rotary::Accumulate, _) => Ok(()),
                (3, ..) => no("spline lines need rotary = \"accumulate\""),
                _ => no("spline lines need poly_degree = 3"),
            };
        }
        if !(3..=5).contains(&degree) {
            return no(&format!("poly_degree is {degree}, it must be 3 to 5"));
        }
        if polynomial.contains(&false) {
            return no("with poly_degree text.cut must have {px}, {py} and {pz}");
        }
        match self.rotary {
            Rotary::Accumulate => Ok(()),
            Rotary::Incremental if self.text.cutting.iter().any(|l| l.split(' ').any(|w| w == "G91")) => Ok(()),
            Rotary::Incremental => {
                no("poly_degree with rotary = \"incremental\" writes steps: text.cutting must say G91")
            }
            Rotary::Modulo | Rotary::Vector => no("poly_degree needs rotary = \"incremental\" or \"accumulate\""),
        }
    }
}
