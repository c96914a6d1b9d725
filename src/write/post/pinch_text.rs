//! Lines of programs of two tools in a post file: `[pinch]` and `[pinch_channels]`.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// Values that lines of these sections may use, and what they are.
pub const PINCH_KEYS: [(&str, &str); 23] = [
    ("axes", "words of all axes of the channel"),
    (
        "moving",
        "words of its linear axes, and of those rotary axes that do not stand where they stood in the line before",
    ),
    ("up", "words of the linear axes that lead the tools away from the part, at the ends of their travel"),
    ("sides", "words of its other linear axes"),
    ("rotary", "words of its rotary axes"),
    ("linear_names", "letters of its linear axes, with commas between them"),
    ("names", "letters of all its axes, with spaces between them"),
    ("f", "feed of a line, as `feed` says; per minute: over the way of all linear axes of the channel together"),
    ("seconds", "time of a line, s"),
    ("row", "number of the row, from 1"),
    ("stretch", "number of the stretch, from 1"),
    ("channel", "number of the channel: 1 or 2; its tool has the same"),
    ("other", "number of the other channel"),
    ("other_file", "file of the other channel's program"),
    ("mark", "number of the next wait mark: one more with each, and 1 again behind `last_mark`"),
    ("rpm", "spindle speed of the channel's tool, 1/min"),
    ("rpm_1", "spindle speed of tool 1"),
    ("rpm_2", "spindle speed of tool 2"),
    ("length_1", "from the gauge line to the tip of tool 1, mm"),
    ("length_2", "the same of tool 2"),
    ("turning_name", "letter of the axis that turns the blade"),
    ("tolerance", "tolerance that the control may smooth by, mm"),
    ("program_number", "four digits for an O word"),
];

/// How a control wants programs of two tools: positions of the machine's axes.
///
/// A program is these sections in this order; `row`, `down`, `cut` (once for each move) and `up`
/// come once for each stretch. Lines are as in [`super::Text`], with the values of
/// [`PINCH_KEYS`].
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct PinchText {
    /// The control in words, where `name` of the post file says what these programs do not use.
    #[serde(default)]
    pub name: Option<String>,
    /// File name of programs; `{channel}` stands for the number of the channel in
    /// `[pinch_channels]`.
    pub file: String,
    /// A word of an axis: `{name}` is its letter, `{at}` its position.
    #[serde(default = "PinchText::letter_and_number")]
    pub axis: String,
    /// The word of the axis that turns the blade; `{way}` is DC, the shorter way to a position
    /// within a turn, where it turns without end, else AC.
    #[serde(default)]
    pub turning_axis: Option<String>,
    /// Letters that the control has for axes; left out: X Y Z A B C U V W.
    #[serde(default = "PinchText::nine_letters")]
    pub letters: String,
    /// The greatest number of a wait mark; for `[pinch_channels]` alone.
    #[serde(default)]
    pub last_mark: Option<u32>,
    /// Comments after the header.
    #[serde(default)]
    pub notes: Vec<String>,
    /// Both tools go up to the ends of travel, spindles on; in two channels a wait mark.
    pub start: Vec<String>,
    /// What switches the control's high-speed cutting on; left out where the job says
    /// `post.look_ahead = false`.
    #[serde(default)]
    pub look_ahead: Vec<String>,
    /// The table and both leans turn, then the tools go over the first place.
    #[serde(default)]
    pub approach: Vec<String>,
    /// Over the first place of a stretch; in two channels a wait mark.
    pub row: Vec<String>,
    /// Down to it: to the feed height, and once more from there.
    pub down: Vec<String>,
    /// Each place after it.
    pub cut: Vec<String>,
    /// In two channels instead of `cut` where no axis of the channel moves: the channel waits as
    /// long.
    #[serde(default)]
    pub stand: Vec<String>,
    /// Up from the last place; in two channels a wait mark.
    pub up: Vec<String>,
    /// What switches high-speed cutting off.
    #[serde(default)]
    pub look_ahead_end: Vec<String>,
    /// The end.
    pub end: Vec<String>,
}

impl PinchText {
    fn letter_and_number() -> String {
        "{name}{at}".into()
    }
    fn nine_letters() -> String {
        "XYZABCUVW".into()
    }

    /// What is wrong with the section of this name.
    pub(in super::super) fn wrong(&self, section: &str) -> Option<String> {
        let of = |what: &str| Some(format!("{section}.{what}"));
        let plain = self.file.replace("{channel}", "1");
        let is_plain = plain.chars().all(|c| c.is_ascii_alphanumeric() || "._-".contains(c));
        if plain.is_empty() || !is_plain || plain.starts_with('.') {
            return of("file must be a file name of letters, digits, points, - and _");
        }
        if [".json", ".csv", ".svg", ".glb", ".toml", ".html"].iter().any(|end| plain.ends_with(end)) {
            return of("file has the ending of a file of another kind");
        }
        let in_channels = section == "pinch_channels";
        if in_channels != self.file.contains("{channel}") {
            return of(if in_channels { "file must have {channel}" } else { "file has {channel}, but there is one" });
        }
        for (name, word) in [("axis", Some(&self.axis)), ("turning_axis", self.turning_axis.as_ref())] {
            if word.is_some_and(|w| !w.contains("{name}") || !w.contains("{at}") || w.contains(' ')) {
                return of(&format!("{name} must be one word with {{name}} and {{at}}"));
            }
        }
        if self.cut.is_empty() || self.down.is_empty() || self.up.is_empty() {
            return of("down, cut and up must have at least one line each");
        }
        if in_channels != self.last_mark.is_some_and(|m| (2..=9999).contains(&m)) {
            return of("last_mark must be 2 to 9999 for two channels, and be left out for one");
        }
        if in_channels == self.stand.is_empty() {
            return of("stand must have a line for two channels, and be left out for one");
        }
        for (name, lines) in self.sections() {
            for line in lines {
                if !line.chars().all(|c| c.is_ascii_graphic() || c == ' ') {
                    return of(&format!("{name}: line \"{line}\": only printable ASCII can be written"));
                }
                let known = |key: &str| PINCH_KEYS.iter().any(|(k, _)| *k == key).then(String::new).ok_or(());
                if let Err(key) = filled(line, known) {
                    let all = PINCH_KEYS.map(|(k, _)| k).join(", ");
                    return of(&format!("{name}: line \"{line}\": there is no value {{{key}}}; values: {all}"));
                }
            }
            let marks: usize = lines.iter().map(|l| l.matches("{mark}").count()).sum();
            let wanted = usize::from(in_channels && ["start", "row", "up"].contains(&name));
            if marks != wanted {
                return of(&format!("{name} has {{mark}} {marks} times, it must have it {wanted} times"));
            }
        }
        None
    }

    fn sections(&self) -> [(&'static str, &[String]); 11] {
        [
            ("notes", &self.notes),
            ("start", &self.start),
            ("look_ahead", &self.look_ahead),
            ("approach", &self.approach),
            ("row", &self.row),
            ("down", &self.down),
            ("cut", &self.cut),
            ("stand", &self.stand),
            ("up", &self.up),
            ("look_ahead_end", &self.look_ahead_end),
            ("end", &self.end),
        ]
    }
}

/// A line with its values. `Err`: the key that has none, or what stands behind a `{` without `}`.
pub(super) fn filled<E>(
    line: &str,
    value: impl Fn(&str) -> std::result::Result<String, E>,
) -> std::result::Result<String, String> {
    let (mut out, mut rest) = (String::with_capacity(line.len()), line);
    while let Some((before, after)) = rest.split_once('{') {
        let (key, behind) = after.split_once('}').ok_or_else(|| after.to_owned())?;
        out.push_str(before);
        out.push_str(&value(key).map_err(|_| key.to_owned())?);
        rest = behind;
    }
    out.push_str(rest);
    Ok(out)
}
