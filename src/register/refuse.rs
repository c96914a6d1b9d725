//! Why no frame is given, in words and as data.

use super::FitOptions;
use super::field::Exact;
use super::judge::{Contest, Determined, Touch, determined, direction, many, polished, summed};
use super::places::{FeedEnd, Lay};
use super::search::{Candidate, Search};
use crate::error::{Error, Infeasible, Result, Stage};
use crate::geometry::Point;

/// Units that programs are taken for one another in.
const SCALES: [f64; 2] = [25.4, 1.0 / 25.4];
/// A frame that is less certain than this is none, µm: what touching is judged by.
const CERTAIN_UM: f64 = 20.0;

/// No frame lets the balls touch the part; whether another unit or another ball would.
pub(super) fn no_frame(search: &Search, found: &[Candidate], options: &FitOptions, touch: &Touch) -> Error {
    let best = found.first().map_or(f64::INFINITY, |c| 1000.0 * c.rms_mm);
    let share = 100.0 * touch.share;
    let what = format!(
        "no frame lays the program over the part: in the best that was found {share:.1} % of its feed places touch it \
         within {:.0} um, at least {:.0} % must; nine tenths of all places are {best:.1} um off (root mean square)",
        1000.0 * options.touching_mm,
        100.0 * options.touching_share
    );
    let scale = SCALES.into_iter().find(|scale| fits_scaled(search, *scale, options));
    let radius_mm = if scale.is_none() { other_radius(search, found, options) } else { None };
    let advice = match (scale, radius_mm) {
        (Some(scale), _) if scale > 1.0 => {
            "its lengths times 25.4 fit: they look like inches, which the program does not say".into()
        }
        (Some(_), _) => "its lengths divided by 25.4 fit: they look like millimetres, read as inches".into(),
        (None, Some(r)) => format!("a ball of radius {r:.4} mm would fit: is --tool the one that the program is for?"),
        (None, None) => "are --part and --tool those that the program is for, and is --stock what it leaves?".into(),
    };
    let data = Infeasible::NoFrame { touching_share: touch.share, rms_um: best, scale, radius_mm };
    Error::infeasible(Stage::Verify, what, data).advise(advice)
}

/// Whether the program fits with its lengths so many times as long.
fn fits_scaled(search: &Search, scale: f64, options: &FitOptions) -> bool {
    let places = search.places.scaled(scale);
    let scaled = Search { places: &places, words: search.words.clone(), ..*search };
    let Ok(found) = scaled.run() else { return false };
    let many = many(&places);
    found.first().is_some_and(|best| {
        let polished = polished(&scaled, &many, &best.lay);
        // What is small enough fits anywhere: the place must be determined, too.
        let determined = determined(&scaled, &many, &polished, options.condition);
        fits(&scaled, &many, &polished.lay, options) && loose(&determined, options).is_ok()
    })
}

/// The radius of a ball with which the program fits.
fn other_radius(search: &Search, found: &[Candidate], options: &FitOptions) -> Option<f64> {
    if search.free_radius {
        return None;
    }
    let grown = Search { free_radius: true, words: search.words.clone(), ..*search };
    let (some, many, exact) = (search.places.sampled(400), many(search.places), Exact(search.part));
    let task = grown.task(&exact, &some, 0.05, true);
    let best = found.iter().map(|c| task.descend(&c.lay, 25)).min_by(|a, b| a.1.total_cmp(&b.1))?;
    let lay = polished(&grown, &many, &best.0).lay;
    let radius_mm = search.places.all.first()?.radius_mm + lay.grown_mm;
    (radius_mm > 0.0 && fits(&grown, &many, &lay, options)).then_some(radius_mm)
}

fn fits(search: &Search, places: &[FeedEnd], lay: &Lay, options: &FitOptions) -> bool {
    let exact = Exact(search.part);
    let task = search.task(&exact, places, 1.0, false);
    let offs: Vec<f64> = task.residuals(lay).iter().map(|r| r.map_or(f64::INFINITY, |r| r.off_mm.abs())).collect();
    summed(&offs, options.touching_mm).share >= options.touching_share
}

/// # Errors
/// `Infeasible`: a direction is not determined.
pub(super) fn loose(determined: &Determined, options: &FitOptions) -> Result<()> {
    let (um, deg) = determined.uncertainty;
    let (directions, how) = match &determined.loose[..] {
        [] if um <= CERTAIN_UM => return Ok(()),
        [] => {
            let how = format!("it is certain within {um:.0} um and {deg:.4} deg only");
            (vec![determined.weakest.clone()], how)
        }
        loose => {
            let how =
                format!("the condition of the fit is {:.0e}, at most {:.0e}", determined.condition, options.condition);
            (loose.to_vec(), how)
        }
    };
    let what = format!(
        "the program fits the part, but not in one place alone: it may be moved {} and fits as well ({how})",
        directions.join(" and ")
    );
    let condition = determined.condition.is_finite().then_some(determined.condition);
    let data = Infeasible::FrameNotDetermined { directions, condition, uncertainty_um: um.is_finite().then_some(um) };
    Err(Error::infeasible(Stage::Verify, what, data).advise("give its zero: --origin X,Y,Z, or --cad"))
}

/// # Errors
/// `Infeasible`: another motion fits nearly as well.
pub(super) fn alike(search: &Search, places: &[FeedEnd], contest: &Contest, options: &FitOptions) -> Result<()> {
    let Some((next, ratio)) = contest.next.filter(|n| !(n.1 > options.runner_up_ratio)) else { return Ok(()) };
    let (lay, exact) = (&contest.best.lay, Exact(search.part));
    let middle = Point::from(search.task(&exact, places, 1.0, false).pivot(lay));
    let between = next.frame * lay.frame.inverse();
    let (turned_deg, moved_mm) = (between.rotation.angle().to_degrees(), (between * middle - middle).norm());
    let about = match between.rotation.axis() {
        Some(axis) => {
            format!("is turned by {turned_deg:.3} deg about {} of the blade against the first and", direction(&axis))
        }
        None => String::new(),
    };
    let kind = if next.tip == lay.tip { "" } else { ", X Y Z once as tips and once as ball centres" };
    let what = format!(
        "two frames fit alike: the second {about} moves the middle of the program by {moved_mm:.3} mm{kind}; its \
         residual is {ratio:.1} times that of the first, it must be {} times",
        options.runner_up_ratio
    );
    let data = Infeasible::FrameAmbiguous { turned_deg, moved_mm, ratio };
    Err(Error::infeasible(Stage::Verify, what, data).advise("give its zero: --origin X,Y,Z, or --cad"))
}
