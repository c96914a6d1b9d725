//! Units: their names, whether a part's size can be a blade's, and what is taken where it cannot.
//!
//! A file that names no unit is taken in mm, as mesh files usually are. Where the part would then
//! have a size that no blade has, whatever the file declares, the unit in which it has a blade's
//! size is taken instead: for looking at the file ([`Guess::Other`]), with the reason; a plan is
//! refused until the unit is given, since a part of the wrong scale is scrap.

use std::path::Path;

use crate::artifact::blade::{Diagnosis, Unit};
use crate::error::{Error, Stage};
use crate::geometry::Aabb;
use crate::observe::{Remark, short};

/// Sizes (largest side of the box) that blades have, mm: below or above, the unit is probably
/// wrong.
const USUAL_MM: [f64; 2] = [3.0, 5000.0];
/// Sizes for which no plan can make sense, mm.
const POSSIBLE_MM: [f64; 2] = [0.5, 500_000.0];
/// Sizes of nearly all blades that are milled, mm: a unit that gives one of them is a likely one.
const LIKELY_MM: [f64; 2] = [20.0, 2000.0];

/// A blade this many times as long as its mean chord is as slender as those of wind turbines …
const SLENDER: f64 = 12.0;
/// … and these are their lengths, m.
const WIND_TURBINE_M: [f64; 2] = [15.0, 150.0];

/// Who says what unit a file is in.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum UnitSource {
    /// The user.
    Told,
    /// The file.
    Declared,
    /// Nobody: mm is taken.
    Assumed,
}

/// A unit's name, as the command line takes it.
pub fn name(unit: Unit) -> &'static str {
    match unit {
        Unit::Mm => "mm",
        Unit::Cm => "cm",
        Unit::M => "m",
        Unit::Inch => "inch",
    }
}

/// What is said of the unit where the file names none and mm is taken; `size`: longest side, file
/// units.
pub fn unnamed(size: Option<f64>) -> String {
    match size {
        Some(s) if (USUAL_MM[0]..=USUAL_MM[1]).contains(&s) => {
            format!("mm, since the file names no unit and {} mm across is a blade's size", short(s))
        }
        _ => "mm, since the file names no unit".to_owned(),
    }
}

/// What the size says about the unit.
pub enum Guess {
    /// Nothing against it.
    Fits,
    /// Unusual, but possible: a note.
    Odd(Remark),
    /// The user's own unit gives a size that is not possible: taken, but no plan is made.
    Refused(Remark, Error),
    /// The size is not possible; in another unit it is a blade's.
    Other {
        /// That unit.
        unit: Unit,
        /// Why.
        reason: String,
        /// What a plan is refused with.
        refusal: Error,
    },
}

impl Guess {
    /// Writes what was found into the diagnosis; the unit to go on with, and why no plan may be
    /// made.
    pub fn take(self, unit: Unit, diagnosis: &mut Diagnosis) -> (Unit, Option<Error>) {
        match self {
            Guess::Fits => (unit, None),
            Guess::Odd(note) => {
                diagnosis.notes.push(note);
                (unit, None)
            }
            Guess::Refused(remark, e) => {
                diagnosis.notes.push(remark);
                (unit, Some(e))
            }
            Guess::Other { unit: other, reason, refusal } => {
                diagnosis.unit_reason = format!("{}, guessed: {reason}", name(other));
                diagnosis.notes.push(Remark::UnitGuessed { unit: name(other).into(), reason });
                (other, Some(refusal))
            }
        }
    }
}

/// The unit with which a part of `size` file units would be of a blade's size, if another than
/// `unit` does.
fn likely(size: f64, unit: Unit) -> Option<Unit> {
    let fits = |u: Unit| (LIKELY_MM[0]..=LIKELY_MM[1]).contains(&(size * u.mm()));
    // Metres are what simulation programs write, so they come first.
    [Unit::M, Unit::Mm, Unit::Inch, Unit::Cm].into_iter().find(|&u| u != unit && fits(u))
}

/// What is said of a blade whose length over its mean chord is that of a wind turbine's blade, and
/// so is its length if the file's numbers are metres: such models are drawn in metres, whatever the
/// file says, and nothing else in the file shows it. Nothing is planned then before the user has
/// given the unit.
pub fn slender(length_mm: f64, chord_mm: f64, unit: Unit, source: UnitSource) -> Option<Remark> {
    let (ratio, metres) = (length_mm / chord_mm, length_mm / unit.mm());
    let fits = ratio > SLENDER && (WIND_TURBINE_M[0]..=WIND_TURBINE_M[1]).contains(&metres);
    let doubtful = fits && source != UnitSource::Told && unit != Unit::M;
    doubtful.then(|| Remark::WindTurbine { ratio, length_m: metres, unit: name(unit).into() })
}

/// Judges the unit by the part's box, mm. A unit that the user gave is taken whatever the size.
pub fn judge(path: &Path, b: Option<Aabb>, unit: Unit, source: UnitSource) -> Guess {
    judge_size(path, b.map(|b| (b.max - b.min).max()), unit, source)
}

/// What is said of a size that few blades have, where nothing but the size suggests the unit.
fn unlikely(size_mm: f64, unit: Unit) -> Remark {
    let size = size_mm / unit.mm();
    let others = [Unit::Cm, Unit::Inch, Unit::M].into_iter().filter(|u| *u != unit);
    let others = others
        .filter(|u| (LIKELY_MM[0]..=LIKELY_MM[1]).contains(&(size * u.mm())))
        .map(|u| (name(u).to_owned(), size * u.mm()))
        .collect();
    Remark::UnitNotCertain { across_mm: size_mm, unit: name(unit).into(), others }
}

/// As [`judge`], from the longest side of the box, mm.
pub fn judge_size(path: &Path, size_mm: Option<f64>, unit: Unit, source: UnitSource) -> Guess {
    let Some(size_mm) = size_mm.filter(|s| s.is_finite()) else { return Guess::Fits };
    let told = source == UnitSource::Told;
    if (USUAL_MM[0]..=USUAL_MM[1]).contains(&size_mm) {
        let sure = source != UnitSource::Assumed || (LIKELY_MM[0]..=LIKELY_MM[1]).contains(&size_mm);
        return if sure { Guess::Fits } else { Guess::Odd(unlikely(size_mm, unit)) };
    }
    let other = likely(size_mm / unit.mm(), unit);
    let advice = other
        .map(|u| format!("the file is probably in {}: pass --unit {0}", name(u)))
        .unwrap_or_else(|| "check the unit".to_owned());
    let side = if size_mm < USUAL_MM[0] { "small" } else { "large" };
    let remark = |advice: Option<String>| Remark::SizeUnusual {
        file: path.display().to_string(),
        across_mm: size_mm,
        unit: name(unit).into(),
        small: size_mm < USUAL_MM[0],
        advice,
    };
    if (POSSIBLE_MM[0]..=POSSIBLE_MM[1]).contains(&size_mm) {
        return Guess::Odd(remark(Some(advice)));
    }
    let refused = remark(None);
    let refusal = Error::io(Stage::Model, refused.to_string()).advise(advice);
    match other.filter(|_| !told) {
        Some(other) => {
            let across = short(size_mm / unit.mm() * other.mm());
            let reason = format!(
                "in {} the part would be {} mm across, too {side} for a blade; in {} it is {across} mm",
                name(unit),
                short(size_mm),
                name(other)
            );
            Guess::Other { unit: other, reason, refusal }
        }
        None => Guess::Refused(refused, refusal),
    }
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used)]
    use super::*;

    fn guess(size_mm: f64, unit: Unit, told: bool) -> Guess {
        let source = if told { UnitSource::Told } else { UnitSource::Declared };
        judge_size(Path::new("a.stl"), Some(size_mm), unit, source)
    }

    #[test]
    fn what_only_the_size_tells_is_told_to_be_uncertain_where_the_size_is_unusual() {
        let guess = |size| judge_size(Path::new("a.dat"), Some(size), Unit::Mm, UnitSource::Assumed);
        assert!(matches!(guess(90.0), Guess::Fits));
        assert!(
            matches!(guess(7.4), Guess::Odd(n) if n.to_string().contains("in cm 74.00 mm, in inch 188.0 mm would be usual"))
        );
        assert!(matches!(judge_size(Path::new("a.stp"), Some(7.4), Unit::Mm, UnitSource::Declared), Guess::Fits));
    }

    #[test]
    fn a_slender_blade_of_a_wind_turbines_length_in_metres_is_doubted() {
        assert!(
            slender(117.0, 4.0, Unit::Mm, UnitSource::Declared)
                .is_some_and(|n| n.to_string().contains("117.0 m") && n.to_string().contains("--unit m,"))
        );
        // As long, but a usual blade; slender, but of no such length; the user knows; it is in
        // metres.
        assert!(slender(117.0, 40.0, Unit::Mm, UnitSource::Assumed).is_none());
        assert!(slender(600.0, 30.0, Unit::Mm, UnitSource::Assumed).is_none());
        assert!(slender(117.0, 4.0, Unit::Mm, UnitSource::Told).is_none());
        assert!(slender(117_000.0, 4000.0, Unit::M, UnitSource::Declared).is_none());
    }

    #[test]
    fn sizes_decide() {
        assert!(matches!(guess(90.0, Unit::Mm, false), Guess::Fits));
        assert!(matches!(guess(2.0, Unit::Mm, false), Guess::Odd(n) if n.to_string().contains("too small")));
        assert!(matches!(guess(0.09, Unit::Mm, false), Guess::Other { unit: Unit::M, reason, refusal }
            if reason.contains("90.00 mm") && refusal.message.contains("too small")));
        // 300 mm that a file declares as metres.
        assert!(matches!(guess(3e5 * 1000.0, Unit::M, false), Guess::Refused(..)));
        assert!(matches!(guess(600_000.0, Unit::M, false), Guess::Other { unit: Unit::Mm, .. }));
        assert!(matches!(guess(0.09, Unit::Mm, true), Guess::Refused(..)));
        assert!(matches!(guess(f64::NAN, Unit::Mm, false), Guess::Fits));
    }

    #[test]
    fn four_digits() {
        assert_eq!([0.035_281, 92.314, 117.0, 4821.7, 0.0].map(short), ["0.03528", "92.31", "117.0", "4822", "0.0"]);
    }
}
