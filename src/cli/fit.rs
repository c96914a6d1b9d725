//! `--fit`: the frame of a program that others wrote, found and printed.

use super::args::Manner;
use super::out::sayln;
use crate::artifact::Blade;
use crate::artifact::program::Programmed;
use crate::error::Result;
use crate::observe::Observer;
use crate::read::program::Bench;
use crate::register::{self, Fit, FitOptions};
use crate::run::anew::WrittenAnew;

/// What a verb found with the frame that it was found in, as reports have it.
#[derive(serde::Serialize)]
pub struct Fitted<'a, T> {
    #[serde(flatten)]
    found: &'a T,
    /// `None`: the frame was given.
    #[serde(skip_serializing_if = "Option::is_none")]
    fit: Option<&'a Fit>,
    /// Programs that were written for other controls.
    #[serde(skip_serializing_if = "<[_]>::is_empty")]
    programs: &'a [WrittenAnew],
}

impl<'a, T> Fitted<'a, T> {
    /// With the frame.
    pub fn new(found: &'a T, fit: Option<&'a Fit>) -> Self {
        Fitted { found, fit, programs: &[] }
    }

    /// With programs for other controls.
    pub fn with_programs(self, programs: &'a [WrittenAnew]) -> Self {
        Fitted { programs, ..self }
    }
}

/// The frame of a program, where `--fit` asks for it: puts it and what X Y Z are into the benches.
///
/// # Errors
/// As [`register::fit`].
pub fn place(
    (manner, stock_mm): (&Manner, Option<f64>),
    text: &str,
    benches: &mut [Bench],
    blade: &Blade,
    observer: &dyn Observer,
) -> Result<Option<Fit>> {
    if !manner.fit {
        return Ok(None);
    }
    let stock_mm = stock_mm.unwrap_or(0.0);
    let either = manner.programmed.is_none() && manner.post_file.is_none();
    let options = FitOptions { stock_mm, either, ..FitOptions::default() };
    let fit = register::fit(text, benches, blade, &options, observer)?;
    for bench in benches {
        bench.zero = fit.zero;
        bench.language.programmed = fit.programmed;
    }
    Ok(Some(fit))
}

/// The frame as lines.
pub fn tell(fit: &Fit) {
    let [x, y, z] = fit.translation_mm;
    let [a, b, c] = fit.turns_deg;
    let what = match fit.programmed {
        Programmed::Tip => "tool tips",
        Programmed::Centre => "ball centres",
        Programmed::Machine => "positions of the machine's axes",
    };
    let tried = if fit.either && fit.programmed != Programmed::Machine { ", found by trying both" } else { "" };
    match fit.programmed {
        Programmed::Machine => sayln!("frame      added to X Y Z: {x:.4}, {y:.4}, {z:.4} mm; X Y Z are {what}"),
        _ => sayln!(
            "frame      zero at {x:.4}, {y:.4}, {z:.4} mm of the blade frame, turned by {a:.5}, {b:.5}, {c:.5} deg \
             about x, then y, then z; X Y Z are {what}{tried}"
        ),
    }
    let next = match fit.runner_up_ratio {
        Some(ratio) => format!("the next best frame is {ratio:.0} times as far off"),
        None => "no other frame was found".into(),
    };
    let shaft = if fit.by_shaft { ", others have the shaft in the part" } else { "" };
    sayln!(
        "           {:.2} % of {} feed places touch, {:.2} um off (root mean square; 95 %: {:.2} um); {next}{shaft}",
        100.0 * fit.touching_share,
        fit.places,
        fit.rms_um,
        fit.p95_um
    );
    sayln!(
        "           certain within {:.3} um and {:.5} deg (standard deviation); errors that are as far off move it by \
         {:.2} um at most; condition {:.0}",
        fit.uncertainty_um,
        fit.uncertainty_deg,
        fit.bound_um,
        fit.condition
    );
}
