//! The frame of a program that others wrote, found from where its balls touch the part.
//!
//! **In**: the text of a program, how it is to be read and with which tools ([`Bench`]; its zero is
//! not looked at), the [`Blade`]. **Out**: a [`Fit`], whose [`Fit::zero`] the benches of
//! [`crate::verify::audit`](mod@crate::verify::audit) take as it is.
//!
//! **Formulation**: a cutter with a ball end of radius `R` that leaves the stock `h` touches the
//! part where the distance `d` of its ball centre is `R + h`. Looked for is the rigid motion `T`
//! with the least `Σ φ(d(T Qᵢ) − R − h)` over the ends `Qᵢ` of the feed moves, `φ` being Huber's
//! function. Programs in positions of the machine's axes have three unknowns, the work offset; so
//! have programs in tilted planes, whose frame the machine must meet. Whether X Y Z are tips or
//! ball centres is tried both ways where nobody says it.
//!
//! **Method**: some ten thousand first guesses (the places' middle on middles of the part's slabs,
//! in turns spread over all of them and along principal axes), each brought down by Levenberg and
//! Marquardt's method on a grid of distances, a few steps at few places first; the best of those
//! that differ go on to the mesh, the best of these to the exact faces. A solution in which the
//! shaft passes through the part gives way to one that fits alike and in which it does not.
//!
//! **Guarantees**: a frame is given only where 95 % of the feed places between the first and the
//! last contact touch within 20 µm, followed with the frame that was found; where the normal
//! equations say that every direction is determined; and where every other motion that was found
//! fits five times worse. Whoever asks gets the same digits on any number of threads.
//!
//! **Limits**: another frame that no first guess leads to is not seen. Where tool axes come from
//! rotary words they are the machine's, and do not turn with the frame.
//!
//! **Fails** with kind `Infeasible` where no frame, or more than one, fits; `Usage`: as
//! [`program::read`] and [`program::follow`], and too few moves; `Cancelled`.

mod field;
mod judge;
mod places;
mod refuse;
mod search;
mod solve;
#[cfg(test)]
mod tests;

use crate::artifact::Blade;
use crate::artifact::program::{Language, Programmed, TOUCHES_MM};
use crate::error::{Error, Result, Stage};
use crate::observe::Observer;
use crate::read::program::{self, Bench, Script, Zero};
use crate::tool::Tool;
use places::FeedEnds;
use search::Search;

/// What is asked of a fit.
#[derive(Clone, Debug, PartialEq)]
pub struct FitOptions {
    /// Stock that the program leaves on the part, mm. Default 0.
    pub stock_mm: f64,
    /// Whether X Y Z over the part are tips or ball centres is not known: both are tried. Default
    /// false: as the language says.
    pub either: bool,
    /// The radius of the ball is looked for as well; of several tools it is the same difference of
    /// all. Default false: as the tool says.
    pub free_radius: bool,
    /// A ball nearer to the part than this, or as deep in it, touches, mm. Default:
    /// [`TOUCHES_MM`].
    pub touching_mm: f64,
    /// Least share of the places between the first and the last contact that touch. Default 0.95.
    pub touching_share: f64,
    /// Greatest condition of the normal equations. Default 1e4: beyond, chords move the frame by
    /// tens of micrometres.
    pub condition: f64,
    /// Least ratio of the next best residual to the best. Default 5.
    pub runner_up_ratio: f64,
}

impl Default for FitOptions {
    fn default() -> Self {
        FitOptions {
            stock_mm: 0.0,
            either: false,
            free_radius: false,
            touching_mm: TOUCHES_MM,
            touching_share: 0.95,
            condition: 1e4,
            runner_up_ratio: 5.0,
        }
    }
}

/// A frame that was found.
#[derive(Clone, Debug, PartialEq, serde::Serialize)]
pub struct Fit {
    /// For the benches.
    #[serde(skip)]
    pub zero: Zero,
    /// Where the program's zero is, blade frame, mm; of a program in positions of the machine's
    /// axes what is added to its X Y Z.
    pub translation_mm: [f64; 3],
    /// Turns of the program's coordinates about x, then y, then z of the blade frame, degrees.
    pub turns_deg: [f64; 3],
    /// What X Y Z are.
    pub programmed: Programmed,
    /// Both tips and ball centres were tried.
    pub either: bool,
    /// Radius of the (first) tool's ball, mm: as given, or as fitted.
    pub radius_mm: f64,
    /// Feed places between the first and the last contact.
    pub places: usize,
    /// Share of these that touch, they being half of all feed places at least.
    pub touching_share: f64,
    /// Root mean square of how far those that touch are off, µm.
    pub rms_um: f64,
    /// 95th percentile of how far all of them are off, µm.
    pub p95_um: f64,
    /// Greatest over least eigenvalue of the normal equations, turns times the part's size.
    pub condition: f64,
    /// Residual of the next best motion over that of the best; `None`: there is no other.
    pub runner_up_ratio: Option<f64>,
    /// A motion that fits alike was left out, since the shaft passes through the part in it.
    pub by_shaft: bool,
    /// Standard deviation of the translation of the places' middle, µm.
    pub uncertainty_um: f64,
    /// Standard deviation of the turn, degrees.
    pub uncertainty_deg: f64,
    /// Errors of the places whose root mean square is that of the residuals move the frame by no
    /// more than this, whatever pattern they have: shift, and turn times the part's size, µm.
    pub bound_um: f64,
}

/// Finds the frame of a program. The language of the first bench counts for all.
///
/// # Errors `Infeasible`: no frame fits, or no single one; `Usage`: the text, the tools or the part
/// are none; `Cancelled`.
pub fn fit(text: &str, benches: &[Bench], blade: &Blade, options: &FitOptions, observer: &dyn Observer) -> Result<Fit> {
    for bench in benches {
        bench.tool.validate()?;
        bench.tool.ball_only("frames of programs are found")?;
    }
    let (script, benches, words) = read(text, benches, options)?;
    let step = |done| observer.progress(Stage::Verify, done, 4);
    step(0);
    let places = FeedEnds::of(&script, &benches)?;
    let part = &blade.part;
    let (stock_mm, free_radius) = (options.stock_mm, options.free_radius);
    let search = Search { part, places: &places, stock_mm, words, free_radius, observer };
    let found = search.run()?;
    step(2);
    let tools: Vec<&Tool> = benches.iter().map(|b| b.tool).collect();
    let ranked = judge::ranked(&search, &tools, &found, options.runner_up_ratio)
        .ok_or_else(|| Error::usage(Stage::Verify, "no place of the program has a distance to the part"))?;
    let many = judge::many(&places);
    let contest = judge::contest(&search, &many, &ranked, options.runner_up_ratio);
    let lay = contest.best.lay;
    let touch = judge::touch(&search, &script, &benches, &lay, options.touching_mm)?;
    step(3);
    if !(touch.share >= options.touching_share) {
        return Err(refuse::no_frame(&search, &found, options, &touch));
    }
    let determined = judge::determined(&search, &many, &contest.best, options.condition);
    refuse::loose(&determined, options)?;
    refuse::alike(&search, &many, &contest, options)?;
    step(4);
    let radius_mm = tools.first().map_or(0.0, |t| t.radius_mm) + lay.grown_mm;
    let (x, y, z) = lay.frame.rotation.euler_angles();
    Ok(Fit {
        zero: places::zero(&lay.frame, places.in_axes),
        translation_mm: lay.frame.translation.vector.into(),
        turns_deg: [x, y, z].map(f64::to_degrees),
        programmed: if places.in_axes { Programmed::Machine } else { programmed(lay.tip) },
        either: search.words.len() > 1,
        radius_mm,
        places: touch.places,
        touching_share: touch.share,
        rms_um: touch.rms_um,
        p95_um: touch.p95_um,
        condition: determined.condition,
        runner_up_ratio: contest.next.map(|n| n.1),
        by_shaft: ranked.by_shaft,
        uncertainty_um: determined.uncertainty.0,
        uncertainty_deg: determined.uncertainty.1,
        bound_um: determined.bound_um,
    })
}

/// The program as it was read, benches with the language that it was read with, and whether its
/// points are tips: one answer, or two to be tried.
fn read<'a>(text: &str, benches: &[Bench<'a>], options: &FitOptions) -> Result<(Script, Vec<Bench<'a>>, Vec<bool>)> {
    let Some(first) = benches.first() else {
        return Err(Error::usage(Stage::Verify, "a program needs a tool to be laid over a part"));
    };
    let with = |language: Language| benches.iter().map(|b| Bench { language, ..*b }).collect::<Vec<_>>();
    let own = first.language;
    let is_tip = |language: Language| language.programmed == Programmed::Tip;
    let said = program::read(text, own);
    // A program may say itself which of both it is: it can be read as that alone.
    let other = if options.either { places::other(own) } else { None };
    let other = other.and_then(|language| program::read(text, language).ok().map(|script| (language, script)));
    match (said, other) {
        (Ok(script), None) => Ok((script, with(own), vec![is_tip(own)])),
        (Ok(script), Some((language, _))) => Ok((script, with(own), vec![is_tip(own), is_tip(language)])),
        (Err(_), Some((language, script))) => Ok((script, with(language), vec![is_tip(language)])),
        (Err(e), None) => Err(e),
    }
}

fn programmed(tip: bool) -> Programmed {
    if tip { Programmed::Tip } else { Programmed::Centre }
}

/// A language whose points over the part are tips, or ball centres.
fn language(of: Language, tip: bool) -> Language {
    match of.programmed {
        Programmed::Machine => of,
        _ => Language { programmed: programmed(tip), ..of },
    }
}
