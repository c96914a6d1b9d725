//! Which dialect a program is written in, found from its text.

use crate::artifact::program::{Grammar, Language, Programmed};

/// A guess, with the reason in words.
#[derive(Clone, Debug, PartialEq)]
pub struct Guess {
    /// How the text is to be read.
    pub language: Language,
    /// What it looks like, and by what.
    pub why: &'static str,
}

/// A program in tilted planes without tool-centre-point control.
const TILTED: &str = "Heidenhain Klartext in tilted planes, by BEGIN PGM and PLANE SPATIAL; X Y Z are tool tips there, \
                      elsewhere positions of the machine's axes, less the tool's length";

/// Major words of APT, with a slash behind or alone.
const APT: [&str; 8] = ["GOTO", "TOOL PATH", "TLDATA", "LOADTL", "FEDRAT", "UNITS", "CUTTER", "MSYS"];

/// Tells how a text is to be read, by words that only one family of controls has. A G code program
/// without a word for tool-centre-point control is taken to be in positions of the machine's axes.
/// `None`: no line of it looks like a program.
pub fn guess(text: &str) -> Option<Guess> {
    let mut axes = false;
    let (mut shortest_way, mut centre_point, mut tilts) = (false, false, false);
    let mut found = None;
    for line in text.lines() {
        let line = line.trim();
        let code = line.trim_start_matches(|c: char| c.is_ascii_digit() || c.is_whitespace());
        let major = line.split(['/', ',']).next().unwrap_or("").trim_end();
        if ["PARTNO", "MULTAX", "$$"].iter().any(|m| line.starts_with(m)) || APT.contains(&major) {
            found = found.or(Some((Grammar::Apt, Programmed::Tip, "an APT cutter-location file, by its major words")));
        } else if code.starts_with("BEGIN PGM") {
            let why = "Heidenhain Klartext, by BEGIN PGM; X Y Z are taken as ball centres";
            found = found.or(Some((Grammar::Heidenhain, Programmed::Centre, why)));
        } else {
            let code = code.split([';', '(']).next().unwrap_or("");
            let mut words = code.split_whitespace();
            shortest_way |= words.clone().any(|w| w == "M126");
            centre_point |= code.contains("TCPM") || words.clone().any(|w| w == "M128");
            tilts |= code.contains("PLANE SPATIAL");
            if words.clone().any(|w| w.starts_with("TRAORI")) {
                found = found.or(Some((Grammar::Gcode, Programmed::Tip, "Siemens 840D, by TRAORI")));
            } else if words.clone().any(|w| w.starts_with("G43.4") || w.starts_with("G43.5")) {
                found = found.or(Some((Grammar::Gcode, Programmed::Tip, "Fanuc, by G43.4 or G43.5")));
            }
            axes |= words.any(|w| {
                let mut letters = w.chars();
                letters.next().is_some_and(|c| "GgXxYyZz".contains(c))
                    && letters.next().is_some_and(|c| c.is_ascii_digit() || "-.=".contains(c))
            });
        }
    }
    let plain = "ISO G code without tool-centre-point control: positions of the machine's axes";
    let found = found.map(|(grammar, programmed, why)| match grammar {
        Grammar::Heidenhain if tilts && !centre_point => (grammar, Programmed::Machine, TILTED),
        _ => (grammar, programmed, why),
    });
    let (grammar, programmed, why) = found.or(axes.then_some((Grammar::Gcode, Programmed::Machine, plain)))?;
    let shortest_way = shortest_way && grammar == Grammar::Heidenhain;
    Some(Guess { language: Language { grammar, programmed, shortest_way, feed_counts_degrees: false }, why })
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used)]
    use super::*;

    #[test]
    fn every_family_is_told_by_its_own_words() {
        for (text, grammar, programmed, shortest_way) in [
            ("; x\nN10 G17\nN20 TRAORI\nN30 G1 X1", Grammar::Gcode, Programmed::Tip, false),
            ("%\nO1\nN10 G43.4 H1 X0", Grammar::Gcode, Programmed::Tip, false),
            ("0 BEGIN PGM X MM\n1 M126\n2 L X+1", Grammar::Heidenhain, Programmed::Centre, true),
            ("PARTNO/X\nGOTO/1,2,3,0,0,1", Grammar::Apt, Programmed::Tip, false),
            ("TOOL PATH/A,TOOL,B\nRAPID", Grammar::Apt, Programmed::Tip, false),
            ("FEDRAT / 100, MMPM\nGOTO / 1, 2, 3", Grammar::Apt, Programmed::Tip, false),
            (
                "0 BEGIN PGM X MM\n1 PLANE SPATIAL SPA+1 SPB+0 SPC+0 STAY",
                Grammar::Heidenhain,
                Programmed::Machine,
                false,
            ),
            ("(TRAORI is only told of)\nG1 X1 M126", Grammar::Gcode, Programmed::Machine, false),
        ] {
            assert_eq!(
                guess(text).unwrap().language,
                Language { grammar, programmed, shortest_way, feed_counts_degrees: false },
                "{text}"
            );
        }
        for text in ["", "Dear sir,\nplease mill this.", "{\"a\": 1}"] {
            assert_eq!(guess(text), None, "{text}");
        }
    }
}
