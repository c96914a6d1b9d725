//! Lines of a post file taken apart: words, and values in them.

use super::fixed::Fixed;

/// What a value is, which decides how it is written.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Class {
    /// A position, mm: with a sign where the dialect asks for one.
    Length,
    /// A size, mm: never with a sign.
    Size,
    /// Degrees.
    Angle,
    /// Component of a unit vector.
    Direction,
    /// A whole number.
    Whole,
    /// A feed: already text.
    Feed,
    /// Any text.
    Text,
}

/// All values that lines may use, with what they are and what they mean.
pub const KEYS: [(&str, Class, &str); 61] = [
    ("x", Class::Length, "X of the programmed point, mm"),
    ("y", Class::Length, "Y of the programmed point, mm"),
    ("z", Class::Length, "Z of the programmed point, mm"),
    (
        "a",
        Class::Angle,
        "position of the rotary axis that turns the blade (the one nearest to the workpiece), degrees, as `rotary` counts",
    ),
    (
        "a_way",
        Class::Text,
        "how the position {a} is to be reached: DC, the shorter way to a position within a turn, where that axis turns without end; AC where it \
         has ends of travel",
    ),
    ("da", Class::Angle, "step of that axis since the block before, degrees"),
    ("a_name", Class::Text, "its letter: A on a machine with a table about X"),
    (
        "b",
        Class::Angle,
        "position of the other rotary axis, degrees; a word with it is left out on a machine that has none",
    ),
    ("b_moving", Class::Angle, "as b; a word with it is left out where that axis stands still while the blade turns"),
    ("b_name", Class::Text, "its letter: B on a machine with a table about X"),
    (
        "moves_b",
        Class::Text,
        "what leaving the cone would do besides: ` and move B`, nothing on a machine of four axes",
    ),
    (
        "cone",
        Class::Text,
        "what keeps the tool axis on its cone: the letters of rotary axes that stand still or move together",
    ),
    ("px", Class::Text, "polynomial of x within a cut: its end, and the coefficients of p^2, p^3 ..., p from 0 to 1"),
    ("py", Class::Text, "the same of y"),
    ("pz", Class::Text, "the same of z"),
    ("pa", Class::Text, "the same of a"),
    ("pb", Class::Text, "the same of b; a word with it is left out on a machine that has no such axis"),
    ("pb_moving", Class::Text, "as pb; a word with it is left out where that axis stands still while the blade turns"),
    (
        "kx",
        Class::Text,
        "X of a spline line: K3X, K2X and K1X of K3 t^3 + K2 t^2 + K1 t + {x}, t from 1 to 0, with an exponent",
    ),
    ("ky", Class::Text, "the same of y"),
    ("kz", Class::Text, "the same of z"),
    ("ka", Class::Text, "the same of a"),
    ("kb_moving", Class::Text, "the same of b; left out where that axis stands still while the blade turns"),
    ("knot", Class::Text, "knot of a line of a curve, micrometres along the path of the ball, from 0"),
    ("i", Class::Direction, "tool axis along blade x"),
    ("j", Class::Direction, "tool axis along blade y"),
    ("k", Class::Direction, "tool axis along blade z"),
    ("mx", Class::Length, "position of machine axis X, mm"),
    ("my", Class::Length, "position of machine axis Y, mm"),
    ("mz", Class::Length, "position of machine axis Z, mm"),
    ("f", Class::Feed, "feed of a cutting line, as `feed` says"),
    ("turn", Class::Whole, "number of the turn that begins, from 1"),
    ("turns", Class::Whole, "number of turns"),
    ("approach_feed", Class::Whole, "feed down to the feed height and back, mm/min"),
    ("plunge_feed", Class::Whole, "feed from the feed height to the part and back, mm/min"),
    (
        "up_name",
        Class::Text,
        "letter of the linear axis that programs retract by: the one nearest to the tool axis while all axes read 0, Z on most mills",
    ),
    ("safe_up", Class::Length, "end of travel of that axis away from the part, mm"),
    ("side_1_name", Class::Text, "letter of the first of the other two linear axes"),
    ("side_1", Class::Length, "position of it, mm; a word with it is left out on a machine that has no such axis"),
    ("side_2_name", Class::Text, "letter of the second of them"),
    ("side_2", Class::Length, "position of it, mm; left out likewise"),
    ("tool", Class::Whole, "tool number"),
    ("rpm", Class::Whole, "spindle speed, 1/min"),
    ("tolerance", Class::Size, "tolerance that the control may smooth by, mm"),
    ("axis_tolerance", Class::Size, "tolerance that the control may smooth the tool axis by, degrees"),
    ("length_to_tip", Class::Size, "gauge line to tool tip, mm"),
    ("length_to_centre", Class::Size, "gauge line to ball centre, mm"),
    ("radius", Class::Size, "ball radius, mm"),
    ("diameter", Class::Size, "ball diameter, mm"),
    ("mount_x", Class::Length, "machine X of the blade frame's origin at A = 0, mm"),
    ("mount_y", Class::Length, "machine Y of it, mm"),
    ("mount_z", Class::Length, "machine Z of it, mm"),
    (
        "along",
        Class::Text,
        "where the blade axis points while the rotary axes read 0, where that is not X; else nothing",
    ),
    ("clamping", Class::Angle, "angle about X by which the blade is clamped, degrees"),
    ("name", Class::Text, "program name"),
    ("program_number", Class::Text, "four digits for an O word"),
    ("cad_shift", Class::Text, "origin of the blade frame in the CAD model"),
    ("cad_row_1", Class::Text, "first row of the rotation from blade frame to CAD model"),
    ("cad_row_2", Class::Text, "second row"),
    ("cad_row_3", Class::Text, "third row"),
    ("part", Class::Text, "file of the part"),
];

/// Index of a key in [`KEYS`].
pub(super) fn key(name: &str) -> Option<usize> {
    KEYS.iter().position(|(k, ..)| *k == name)
}

/// Piece of a word.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum WordPiece {
    Text(String),
    /// Index into [`KEYS`], and digits after the point where given.
    Value(usize, Option<usize>),
}

/// What stands between two spaces.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct TemplateWord {
    pub(super) pieces: Vec<WordPiece>,
    /// Left out while its values stay.
    pub(super) modal: bool,
}

/// A line.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct TemplateLine {
    pub(super) comment: bool,
    /// Of `text.look_ahead` or `text.look_ahead_end`: left out where the job does without.
    pub(super) look_ahead: bool,
    pub(super) words: Vec<TemplateWord>,
}

/// A value to write.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum Value {
    Number(f64),
    /// An angle already rounded, for steps that must add up.
    Rounded(Fixed),
    Text(String),
}

/// Takes lines apart. `Err`: what is wrong, with the line.
pub(super) fn lines(text: &[String], modal: &[String]) -> Result<Vec<TemplateLine>, String> {
    let modal: Vec<usize> = modal.iter().map(|m| key(m).ok_or_else(|| unknown(m))).collect::<Result<_, String>>()?;
    text.iter().map(|t| line(t, &modal).map_err(|e| format!("line \"{t}\": {e}"))).collect()
}

fn unknown(name: &str) -> String {
    format!("there is no value {{{name}}}; values: {}", KEYS.map(|(k, ..)| k).join(", "))
}

fn line(text: &str, modal: &[usize]) -> Result<TemplateLine, String> {
    if !text.chars().all(|c| c.is_ascii_graphic() || c == ' ') {
        return Err("only printable ASCII can be written".into());
    }
    if let Some(comment) = text.strip_prefix("; ") {
        // Spaces in a comment are part of it.
        return Ok(TemplateLine { comment: true, look_ahead: false, words: vec![word(comment, &[])?] });
    }
    Ok(TemplateLine {
        comment: false,
        look_ahead: false,
        words: text.split_whitespace().map(|w| word(w, modal)).collect::<Result<_, _>>()?,
    })
}

fn word(text: &str, modal: &[usize]) -> Result<TemplateWord, String> {
    let mut pieces = Vec::new();
    let mut rest = text;
    while let Some((before, after)) = rest.split_once('{') {
        let (inside, behind) = after.split_once('}').ok_or("a { without its }")?;
        if !before.is_empty() {
            pieces.push(WordPiece::Text(before.into()));
        }
        let (name, digits) = match inside.split_once(':') {
            Some((name, digits)) => (name, Some(digits)),
            None => (inside, None),
        };
        let k = key(name).ok_or_else(|| unknown(name))?;
        let digits = digits
            .map(|d| d.parse().ok().filter(|n| *n <= 9).ok_or_else(|| format!("{{{inside}}}: digits must be 0 to 9")))
            .transpose()?;
        pieces.push(WordPiece::Value(k, digits));
        rest = behind;
    }
    if !rest.is_empty() {
        pieces.push(WordPiece::Text(rest.into()));
    }
    let modal = pieces.iter().any(|p| matches!(p, WordPiece::Value(k, _) if modal.contains(k)));
    Ok(TemplateWord { pieces, modal })
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used)]
    use super::*;

    #[test]
    fn lines_come_apart_into_words_and_values() {
        let got = lines(&["G1 X{x} A=IC({da}) F{f}".into(), "; two  spaces {tool}".into()], &["x".into()]).unwrap();
        assert_eq!(got[0].words.len(), 4);
        assert!(got[0].words[1].modal && !got[0].words[2].modal);
        assert_eq!(
            got[0].words[2].pieces,
            [WordPiece::Text("A=IC(".into()), WordPiece::Value(key("da").unwrap(), None), WordPiece::Text(")".into())]
        );
        assert!(got[1].comment);
        assert_eq!(got[1].words[0].pieces[0], WordPiece::Text("two  spaces ".into()));
    }

    #[test]
    fn what_is_wrong_is_named() {
        for (text, names) in
            [("G1 X{q}", "no value {q}"), ("X{x", "without its }"), ("X{x:z}", "digits"), ("X{x} ü", "ASCII")]
        {
            let e = lines(&[text.into()], &[]).unwrap_err();
            assert!(e.contains(names) && e.contains(text), "{e}");
        }
        assert!(lines(&[], &["q".into()]).unwrap_err().contains("no value {q}"));
    }
}
