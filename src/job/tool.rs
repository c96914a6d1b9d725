//! The tool that a job leaves open, from what can be bought and from what the part's shape asks.
//!
//! * Ball: places are spread evenly over the airfoil's wall near the platform, and over the fillet.
//!   They vote on which balls have room. The largest ball of the catalogue is taken that goes to
//!   nearly all of these places, with room to spare, and is sold long enough to reach. It is at
//!   most [`SHARE_OF_CHORD`] of the chord near the platform: about half the thickness of usual
//!   profiles, since larger balls do not follow the neighbourhood of the edges. Places where not
//!   even the smallest ball has room are slits and damage, and do not vote.
//! * Stick-out: a tenth more than the part's reach from the blade axis, so that the holder stays
//!   outside the platform.
//! * Shank: the thinnest that the cutter is sold on and that is stiff enough for the stick-out.
//!   Chuck: the one for the shank.

use super::room::{Share, WallPlaces};
use super::sections::ToolKeys;
use crate::artifact::Blade;
use crate::error::{Error, Frame, Infeasible, Result, Spot, Stage};
use crate::geometry::Point;
use crate::observe::{self, Doubt, LeftOver};
use crate::tool::catalogue::{Catalogue, Cutter};
use crate::tool::{HolderStage, Tool};

/// Balls of more than this share of the chord are not tried.
const SHARE_OF_CHORD: f64 = 0.07;
/// Shares of the wall and of the fillet that a ball is to go to.
const MOST_OF: [f64; 2] = [0.97, 0.9];
/// A ball has room to spare where one so much larger fits too. On the wall a tenth more leaves the
/// tool room to turn. In the fillet a ball as large as the fillet itself could go only along one
/// line.
const TO_SPARE: [f64; 2] = [0.9, 0.85];
/// A ball that just fits.
const NONE_TO_SPARE: [f64; 2] = [1.0; 2];
/// Below this share of all places that any ball goes to, the surface is folded over itself, or is
/// none.
const LEAST_SOUND: f64 = 0.5;
/// Slits and damage over more than this share are reported.
const TOLD: f64 = 0.01;

/// A tool and what is to be said of it.
#[derive(Clone, Debug, PartialEq)]
pub struct Chosen {
    /// The tool, complete.
    pub tool: Tool,
    /// Why this one, one sentence.
    pub why: String,
    /// What it leaves to another tool.
    pub warnings: Vec<Doubt>,
}

impl Chosen {
    /// The tool in one line.
    pub fn in_words(&self) -> String {
        let t = &self.tool;
        let neck = if t.taper_deg > 0.0 {
            format!("taper {}°, shank {} mm", t.taper_deg, round(2.0 * t.shank_radius_mm))
        } else {
            "straight".into()
        };
        let holder = match (t.holder.first(), t.holder.last()) {
            (Some(a), Some(b)) if a.radius_mm != b.radius_mm => {
                format!("holder {} to {} mm", round(2.0 * a.radius_mm), round(2.0 * b.radius_mm))
            }
            (Some(a), _) => format!("holder {} mm", round(2.0 * a.radius_mm)),
            _ => "no holder".into(),
        };
        let end = match t.corner_radius_mm {
            Some(corner) => format!("cutter R {} mm, corner R {} mm", round(t.radius_mm), round(corner)),
            None => format!("ball R {} mm", round(t.radius_mm)),
        };
        format!("{end}, {neck}, stick-out {} mm, {holder}", round(t.stickout_mm))
    }
}

/// To a thousandth.
fn round(x: f64) -> f64 {
    (x * 1000.0).round() / 1000.0
}

/// The tool: what was typed, the rest as the module's page says. `start_mm` and `end_mm`: the
/// region as far as it is typed.
///
/// # Errors
/// `Usage`: values outside their limits. `Infeasible`: no ball has room.
pub(super) fn complete(keys: &ToolKeys, blade: &Blade, start_mm: Option<f64>, end_mm: Option<f64>) -> Result<Chosen> {
    let catalogue = Catalogue::built_in()?;
    let places = WallPlaces::new(blade, start_mm, end_mm);
    let reach_mm = blade.part.mesh.points.iter().map(|p| p.y.hypot(p.z)).fold(0.0, f64::max);
    let needed_mm = |r: f64| up_to_five(1.1 * reach_mm + 2.0 * r);
    let corner = keys.corner_mm();
    let mut warnings = Vec::new();
    let (cutter, why) = match keys.radius_mm {
        Some(r) => {
            // What of a cutter comes into fillets and round edges is its corner.
            let round_mm = corner.unwrap_or(r);
            let warned = if places.is_empty() { None } else { too_large(blade, &places, &catalogue, round_mm) };
            warnings.extend(warned);
            let end = if corner.is_some() { "cutter" } else { "ball" };
            (Cutter { radius_mm: r, ..catalogue.cutter_for(r) }, format!("its {end} as given"))
        }
        None => {
            let longest_mm = keys.stickout_mm;
            let reaches = |c: &Cutter| longest_mm.unwrap_or_else(|| needed_mm(c.radius_mm)) <= c.longest_mm();
            default_cutter(blade, &places, &catalogue, reaches, &mut warnings)?
        }
    };
    let radius_mm = cutter.radius_mm;
    // Cutters with a corner are sold straight.
    let taper_deg = keys.taper_deg.unwrap_or(if corner.is_some() { 0.0 } else { cutter.taper_deg });
    let wanted_mm = keys.stickout_mm.unwrap_or_else(|| needed_mm(radius_mm));
    let shank = if taper_deg > 0.0 { cutter.shank_for(wanted_mm) } else { 2.0 * radius_mm };
    let shank_radius_mm = keys.shank_radius_mm.unwrap_or(0.5 * shank);
    let longest_mm = cutter.longest_mm().max(2.0 * radius_mm);
    // A stick-out that nobody sells is used where it was asked for only.
    let stickout_mm = keys.stickout_mm.unwrap_or(wanted_mm.min(longest_mm));
    if stickout_mm < wanted_mm {
        warnings.push(Doubt::StickOutTooShort { reach_mm, wanted_mm, radius_mm, stickout_mm });
    }
    let holder: Vec<HolderStage> =
        keys.holder.clone().unwrap_or_else(|| catalogue.chuck_for(2.0 * shank_radius_mm).stages());
    let tool = Tool { radius_mm, corner_radius_mm: corner, taper_deg, shank_radius_mm, stickout_mm, holder };
    tool.validate()?;
    Ok(Chosen { tool, why, warnings })
}

/// The second of two tools: keys that are left out are those of the first, and its ball is as
/// large.
///
/// # Errors
/// As [`complete`], naming keys of `tool_2`.
pub(super) fn second(
    keys: &ToolKeys,
    (first, of_first): (&Tool, &ToolKeys),
    blade: &Blade,
    [start_mm, end_mm]: [Option<f64>; 2],
) -> Result<Chosen> {
    let keys = ToolKeys {
        radius_mm: keys.radius_mm.or(Some(first.radius_mm)),
        taper_deg: keys.taper_deg.or(of_first.taper_deg),
        shank_radius_mm: keys.shank_radius_mm.or(of_first.shank_radius_mm),
        stickout_mm: keys.stickout_mm.or(of_first.stickout_mm),
        holder: keys.holder.clone().or_else(|| of_first.holder.clone()),
        ..ToolKeys::default()
    };
    complete(&keys, blade, start_mm, end_mm).map_err(of_second)
}

/// The same error with the keys of the second tool.
pub(super) fn of_second(e: Error) -> Error {
    let named = |text: String| text.replace("tool.", "tool_2.");
    Error { message: named(e.message), advice: e.advice.map(named), ..e }
}

/// Refuses cutters with a corner, for which rows of two tools are not planned.
///
/// # Errors
/// `Usage`: what is wrong with the corner, or that it is one.
pub(super) fn balls_only(keys: &ToolKeys) -> Result<()> {
    check_corner(keys)?.map_or(Ok(()), |tool| tool.ball_only("rows for two tools are planned"))
}

/// A cutter with a corner in its shortest form; `None` where none is given.
///
/// # Errors
/// `Usage`: what is wrong with the corner on any blade, with the limit.
pub(super) fn check_corner(keys: &ToolKeys) -> Result<Option<Tool>> {
    let Some(corner) = keys.corner_mm() else { return Ok(None) };
    let Some(radius_mm) = keys.radius_mm else {
        return Err(Error::usage(Stage::Job, "tool.corner_radius_mm is given without tool.radius_mm")
            .advise("give the radius of the cutter too; a ball has no corner"));
    };
    let tool = Tool {
        radius_mm,
        corner_radius_mm: Some(corner),
        taper_deg: 0.0,
        shank_radius_mm: radius_mm,
        stickout_mm: 2.0 * radius_mm,
        holder: Vec::new(),
    };
    tool.validate()?;
    Ok(Some(tool))
}

/// The cutter that the part's shape asks for, and why.
fn default_cutter(
    blade: &Blade,
    places: &WallPlaces,
    catalogue: &Catalogue,
    reaches: impl Fn(&Cutter) -> bool,
    warnings: &mut Vec<Doubt>,
) -> Result<(Cutter, String)> {
    if blade.regions.over_hub().is_some() {
        let message = "tool.radius_mm is missing, and none is chosen for a blade whose hub turns from along the rotor axis to across it";
        return Err(Error::usage(Stage::Job, message)
            .advise("give the radius of a ball that has room between two blades and in the fillets"));
    }
    let none = || Error::infeasible(Stage::Job, "the tool catalogue is empty", Infeasible::NoTools);
    let [smallest, largest] = [catalogue.cutter.first(), catalogue.cutter.last()];
    let (smallest, largest) = smallest.zip(largest).ok_or_else(none)?;
    let (chord_mm, chord_at_mm) = places.chord_mm;
    let most_mm = SHARE_OF_CHORD * chord_mm;
    let sound = places.sound(blade, smallest.radius_mm);
    if sound.share < LEAST_SOUND {
        return Err(no_room(blade, smallest.radius_mm, &sound, places));
    }
    if 1.0 - sound.share > TOLD {
        warnings.push(Doubt::NoRoomAtWall {
            share: sound.share,
            radius_mm: smallest.radius_mm,
            tightest_mm: in_model(blade, sound.tightest),
        });
    }
    let long_enough = catalogue.cutter.iter().any(&reaches);
    // Where none is long enough the longest are; the stick-out's message says so.
    let able = |c: &&Cutter| !long_enough || reaches(c);
    let goes = |c: &Cutter| has_room(&places.shares(blade, c.radius_mm, TO_SPARE, &sound.places));
    let slim = |c: &&Cutter| c.radius_mm <= most_mm;
    if let Some(c) = catalogue.cutter.iter().rev().filter(slim).filter(able).find(|c| goes(c)) {
        let more = catalogue.cutter.iter().find(|d| d.radius_mm > c.radius_mm);
        let why = match more {
            Some(d) if d.radius_mm > most_mm => format!(
                "the largest within {:.0} % of the chord, {chord_mm:.1} mm at height {chord_at_mm:.1} mm, and with room on wall and fillet",
                100.0 * SHARE_OF_CHORD
            ),
            Some(_) => "the largest with room on wall and fillet".to_owned(),
            None => format!("with room on wall and fillet, the largest there is (R {})", largest.radius_mm),
        };
        return Ok((c.clone(), why));
    }
    // What the part asks for is not to be had: the smallest that is long enough, and what it
    // leaves.
    let c = catalogue.cutter.iter().find(able).unwrap_or(smallest);
    let left = left_over(blade, &places.shares(blade, c.radius_mm, NONE_TO_SPARE, &sound.places));
    let short = catalogue.cutter.iter().find(|d| goes(d)).filter(|d| d.radius_mm < c.radius_mm);
    warnings.push(if left.is_empty() {
        let (share_of_chord, height_mm, radius_mm) = (SHARE_OF_CHORD, chord_at_mm, c.radius_mm);
        Doubt::AirfoilTooThin { most_mm, share_of_chord, chord_mm, height_mm, radius_mm }
    } else {
        Doubt::BallNotLongEnough { wanted_mm: short.map(|d| d.radius_mm), radius_mm: c.radius_mm, left }
    });
    Ok((c.clone(), "the smallest that is sold long enough for the part".into()))
}

/// The doubt about a given ball that does not go to all of wall and fillet.
fn too_large(blade: &Blade, places: &WallPlaces, catalogue: &Catalogue, radius_mm: f64) -> Option<Doubt> {
    let smallest = catalogue.cutter.first()?.radius_mm.min(radius_mm);
    let sound = places.sound(blade, smallest);
    let shares = places.shares(blade, radius_mm, NONE_TO_SPARE, &sound.places);
    let left = left_over(blade, &shares);
    if has_room(&shares) || left.is_empty() {
        return None;
    }
    let goes = |r: f64| has_room(&places.shares(blade, r, TO_SPARE, &sound.places));
    let fits_mm = catalogue.cutter.iter().map(|c| c.radius_mm).rev().find(|r| *r < radius_mm && goes(*r));
    Some(Doubt::BallTooLarge { radius_mm, left, fits_mm })
}

/// Whether a ball goes to nearly all of wall and fillet.
fn has_room(shares: &[Share; 2]) -> bool {
    shares.iter().zip(MOST_OF).all(|(s, least)| s.share >= least)
}

/// Where a ball does not go; empty where it goes everywhere.
fn left_over(blade: &Blade, shares: &[Share; 2]) -> Vec<LeftOver> {
    let names = ["wall near the platform", "fillet"];
    let missed = shares.iter().zip(names).filter(|(s, _)| s.area_mm2 > 0.0 && s.share < 1.0);
    let left = |(s, of): (&Share, &str)| LeftOver {
        of: of.into(),
        share: s.share,
        area_mm2: s.area_mm2,
        tightest_mm: in_model(blade, s.tightest),
    };
    missed.map(left).collect()
}

/// Where it is tightest, in the frame of the model, mm.
fn in_model(blade: &Blade, tightest: Option<(Point, f64)>) -> Option<[f64; 3]> {
    tightest.map(|(p, _)| (blade.model_from_blade * p).into())
}

/// Not even the smallest ball has room.
fn no_room(blade: &Blade, radius_mm: f64, sound: &Share, places: &WallPlaces) -> Error {
    let [lo, hi] = places.heights_mm;
    let tightest_mm = in_model(blade, sound.tightest);
    Error::infeasible(
        Stage::Job,
        format!(
            "no ball fits the airfoil: the smallest, of {radius_mm} mm, has room at {:.1} % of the wall between the heights {lo:.3} and {hi:.3} mm{}",
            100.0 * sound.share,
            observe::tightest(&tightest_mm)
        ),
        Infeasible::NoBallFits {
            radius_mm,
            share: sound.share,
            heights_mm: [lo, hi],
            at: tightest_mm.map(|point_mm| Spot { frame: Frame::Model, point_mm }),
        },
    )
    .advise(
        "look whether the surface folds over itself there, and check unit, axis and where the airfoil is (--unit, --axis, --region airfoil=LO,HI); or give \
         tool.radius_mm",
    )
}

/// Rounded up to a multiple of 5 mm (of 0.5 mm below 5 mm): tools are set by such steps.
fn up_to_five(x: f64) -> f64 {
    let unit = if x < 5.0 { 0.5 } else { 5.0 };
    (x / unit).ceil() * unit
}
