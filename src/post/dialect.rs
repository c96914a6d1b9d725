//! A post file: how one control wants its programs, as data. The built-in ones are such files too.
//!
//! A program is a list of *sections* in a fixed order, each a list of lines:
//!
//! ```text
//! file_begin  header  notes  start  approach  plunge  cutting  turn cut …  cutting_end  leave  retract  unwind  end  file_end
//! ```
//!
//! In a program of several operations all from `header` to `unwind` comes once for each, with `operation_end` between two.
//! `start` sees the safe position over the first location, `approach` the feed height, `plunge` the first location, `cut` (once
//! for each move) every location after it, `turn` (before the first cut of each turn) its number, `leave` the feed height over the last location, `retract` the safe position over
//! it, `unwind` the first location again. A line beginning with `; ` is a comment; any other is a block. `{key}` stands for a value and
//! `{key:3}` for one with three digits after the point; the keys are those of [`KEYS`]. Words that repeat the
//! value before are left out for the keys in `modal`.
//!
//! With `poly_degree` cuts are polynomials, `{px}` to `{pb}`: see [`super::polynomial`].

use std::path::Path;

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::template::{Line, lines};
use crate::artifact::program::{Control, Grammar, Language, Programmed};
use crate::error::{Error, Result, Stage};
use crate::files;

/// What rotary words say.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum Rotary {
    /// Positions, growing over all turns: right where `A` is a linear axis to the control.
    Accumulate,
    /// Steps from line to line (`{da}`): right on a modulo axis and on a linear one, since absolute words beyond 360° mean different things on
    /// modulo axes, depending on machine data. Steps are of rounded positions: nothing adds up.
    Incremental,
    /// Positions in `0 … 360`; the control goes the shorter way.
    Modulo,
    /// None: the tool axis as a vector (`{i} {j} {k}`).
    Vector,
}

/// What F means on cutting lines.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum FeedWord {
    /// `F = 1 / Δt`, 1/min: the control needs no notion of what a feed means for a line that turns and moves at once.
    InverseTime,
    /// mm/min of the programmed point; degrees/min on lines that turn only.
    PerMinute,
}

/// Numbers of lines.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Numbering {
    /// Before the number.
    #[serde(default)]
    pub prefix: String,
    /// First number.
    pub first: u64,
    /// From line to line.
    pub step: u64,
    /// Comments and the lines around the program are numbered too.
    #[serde(default)]
    pub everything: bool,
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

/// The sections of a program as they stand in the file.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Text {
    /// Comments after the header.
    #[serde(default)]
    pub notes: Vec<String>,
    /// Up to the safe position over the first location.
    pub start: Vec<String>,
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
    /// After the last cut.
    #[serde(default)]
    pub cutting_end: Vec<String>,
    /// Off the part to the feed height.
    pub leave: Vec<String>,
    /// To the safe position, and home.
    pub retract: Vec<String>,
    /// Back to the first position of `A`; left out where the part may not turn freely.
    #[serde(default)]
    pub unwind: Vec<String>,
    /// Between two operations: behind the retract and the unwinding of one, before the tool call in `start` of the next.
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
    /// What F means.
    pub feed: FeedWord,
    /// Least and greatest F.
    #[serde(default = "PostFile::feed_range")]
    pub feed_range: [f64; 2],
    /// Before and after a comment.
    pub comment: [String; 2],
    /// Longest line.
    pub longest_line: usize,
    /// Cuts are polynomials of at most this degree, 3 to 5, instead of straight moves (`PO[X]=({px})`); each as its end and the coefficients of
    /// `p²`, `p³` … for `p` from 0 to 1. With `rotary = "incremental"` the ends of all words are steps: `text.cutting` then has to say `G91`.
    #[serde(default)]
    pub poly_degree: Option<usize>,
    /// At the end of a line that goes on, after a comma; without it a block that is too long is an error.
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
    /// The program.
    pub text: Text,
}

impl PostFile {
    /// What controls read (Siemens: 0.001 to 999 999.999).
    fn feed_range() -> [f64; 2] {
        [0.001, 999_999.999]
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
    pub(super) file_begin: Vec<Line>,
    pub(super) notes: Vec<Line>,
    pub(super) start: Vec<Line>,
    pub(super) approach: Vec<Line>,
    pub(super) plunge: Vec<Line>,
    pub(super) cutting: Vec<Line>,
    pub(super) turn: Vec<Line>,
    pub(super) cut: Vec<Line>,
    pub(super) cutting_end: Vec<Line>,
    pub(super) leave: Vec<Line>,
    pub(super) retract: Vec<Line>,
    pub(super) unwind: Vec<Line>,
    pub(super) operation_end: Vec<Line>,
    pub(super) end: Vec<Line>,
    pub(super) file_end: Vec<Line>,
}

impl Control {
    /// The built-in post file.
    pub fn post_file(self) -> &'static str {
        match self {
            Control::Siemens => include_str!("../../models/posts/siemens.toml"),
            Control::SiemensVector => include_str!("../../models/posts/siemens_vector.toml"),
            Control::SiemensPoly => include_str!("../../models/posts/siemens_poly.toml"),
            Control::Heidenhain => include_str!("../../models/posts/heidenhain.toml"),
            Control::HeidenhainVector => include_str!("../../models/posts/heidenhain_vector.toml"),
            Control::Fanuc => include_str!("../../models/posts/fanuc.toml"),
            Control::FanucVector => include_str!("../../models/posts/fanuc_vector.toml"),
            Control::Linuxcnc => include_str!("../../models/posts/linuxcnc.toml"),
            Control::LinuxcncFeed => include_str!("../../models/posts/linuxcnc_feed.toml"),
            Control::Iso => include_str!("../../models/posts/iso.toml"),
            Control::Apt => include_str!("../../models/posts/apt.toml"),
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

    /// Reads a post file.
    ///
    /// # Errors
    /// Kind `InputOutput` where it cannot be read, else as [`Dialect::from_toml`].
    pub fn load(path: &Path) -> Result<Self> {
        let text = files::read_text(path, files::SHORT).map_err(|e| {
            Error::io(Stage::Post, format!("cannot read the post file {}: {e}", path.display())).caused_by(e)
        })?;
        Self::from_toml(&text, &path.display().to_string())
    }

    /// Reads the text of a post file; `origin` names it in messages.
    ///
    /// # Errors
    /// Kind `Usage`: not TOML, an unknown or missing key, an unknown value in a line, or a number out of its range; with the place.
    pub fn from_toml(text: &str, origin: &str) -> Result<Self> {
        let file: PostFile = toml::from_str(text).map_err(|e| {
            let line = e.span().map(|s| text.get(..s.start).unwrap_or(text).matches('\n').count() + 1);
            let place = line.map(|n| format!(" line {n}")).unwrap_or_default();
            Error::usage(Stage::Post, format!("{origin}{place}: {}", e.message()))
                .advise("models/posts/siemens.toml shows every key")
        })?;
        file.validate(origin)?;
        let take =
            |name: &str, text: &[String]| lines(text, &file.modal).map_err(|e| bad(origin, format!("{name}: {e}")));
        let t = &file.text;
        Ok(Dialect {
            file_begin: take("file_begin", &file.file_begin)?,
            notes: take("text.notes", &comments(&t.notes))?,
            start: take("text.start", &t.start)?,
            approach: take("text.approach", &t.approach)?,
            plunge: take("text.plunge", &t.plunge)?,
            cutting: take("text.cutting", &t.cutting)?,
            turn: take("text.turn", &t.turn)?,
            cut: take("text.cut", &t.cut)?,
            cutting_end: take("text.cutting_end", &t.cutting_end)?,
            leave: take("text.leave", &t.leave)?,
            retract: take("text.retract", &t.retract)?,
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

    /// How its programs are to be understood.
    pub fn language(&self) -> Language {
        Language {
            grammar: self.file.grammar,
            programmed: self.file.programmed,
            shortest_way: self.file.rotary == Rotary::Modulo,
        }
    }
}

fn bad(origin: &str, what: String) -> Error {
    Error::usage(Stage::Post, format!("{origin}: {what}")).advise("models/posts/siemens.toml shows every key")
}

/// Notes are comments without having to say so.
fn comments(notes: &[String]) -> Vec<String> {
    notes.iter().map(|n| format!("; {n}")).collect()
}

impl PostFile {
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
        let [lo, hi] = self.feed_range;
        if !(lo > 0.0 && lo < hi && hi.is_finite()) {
            return no("feed_range must be two numbers greater than 0, the least first");
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
        let cut = self.text.cut.concat();
        let polynomial = ["{px}", "{py}", "{pz}"].map(|key| cut.contains(key));
        let Some(degree) = self.poly_degree else {
            return if polynomial.contains(&true) { no("{px}, {py} and {pz} need poly_degree") } else { Ok(()) };
        };
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
