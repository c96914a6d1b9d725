//! Cutter locations: one continuous helix of ball centres round the airfoil.
//!
//! In: a [`Blade`] and [`PathOptions`]. Out: a [`Toolpath`].
//!
//! ## Method
//! The centre of a ball that touches the part without cutting into it lies on the `R` level set of
//! the distance to the whole part: airfoil, fillet and platform alike. *Rings* are that set's
//! closed curves at constant height (`ring`). The helix (`helix`) runs from each of a stack of
//! curves to the next, at the fraction `u` of the way round `(1 − u)` of the one and `u` of the
//! other, and every one of its locations is brought onto the level set again, so the curves only
//! guide it. It runs down from the airfoil towards the platform, counter-clockwise seen from the
//! tip. How the curves of the stack lie is the [`PathKind`], one file each:
//!
//! * [`PathKind::ConstantHeight`] (`constant_height`): rings, with a pitch as large as the scallop
//!   allows at the worst place of the turn, the scallop being measured on the part (`stepover`),
//!   not derived from curvature.
//! * [`PathKind::IsoParametric`] (`iso_parametric`): equal parts of the way from start to end at
//!   each place round the blade.
//! * [`PathKind::ConstantScallop`] (`constant_scallop`): no stack; every turn of the helix is laid
//!   from the turn beside it, touch by touch, straight across, as far as leaves the scallop
//!   (`front`). The last turn runs along the end of the region, the others alongside it, and
//!   the first is the lowest that is nowhere under the start height.
//! * [`PathKind::FirstOrder`] and [`PathKind::FirstOrderRings`] (`first_order`): the same by a
//!   published method for turn-milling, to compare with.
//!
//! Heights and lean are those along the region's own axis ([`crate::artifact::along`]). Planar
//! turns lie at one height and count on a region that begins and ends at heights; constant scallop
//! begins and ends at faces, too.
//!
//! [`PathKind::HubRows`] (`hub`) is no helix: rows over the hub of a wheel between two blades.
//!
//! With [`Direction::Conventional`] the same turns are run the other way, upwards (`direction`).
//! With [`PathSettings::stock_mm`], all this is on the part with so much stock on it
//! ([`crate::geometry::allowance`]).
//!
//! Turns begin at a *base point*, the concave–convex altered point where the path enters the
//! greatest concave stretch (Section 2.1 of the paper on S–θ re-scheduling for four-axis blade
//! milling), or the altered point nearest to the trailing edge ([`PathOptions::start_near`]); on a
//! convex airfoil, at the point furthest along `y`, or the one nearest to the trailing edge.
//!
//! ## Guarantees
//! Every location is within 1e-6 mm of the level set. The straight move between two locations stays
//! within `chord_mm` of it, in smooth hollows of exact faces within a quarter of that, measured at
//! its middle and, where it is long, at its quarters. The scallop between turns, measured at every
//! location, is in [`Toolpath::planned_scallop_mm`] (on a mesh the 99th percentile).
//!
//! ## Limits
//! The helix ends where a wall leans towards the tip by more than [`PathSettings::max_lean_deg`];
//! turns at constant height leave too much beyond it. With those the scallop is at or under the
//! limit everywhere, not constant along a turn. With constant scallop turns slant as the end does.

mod bounds;
mod chords;
mod constant_height;
mod constant_scallop;
#[cfg(test)]
mod constant_scallop_tests;
mod curve;
mod direction;
mod first_order;
mod front;
mod helix;
mod hub;
mod iso_parametric;
mod level;
mod options;
pub mod pairs;
mod rim;
mod ring;
mod rings;
mod seed;
mod settings;
mod stepover;
#[cfg(test)]
mod tests;

pub use crate::tool::stepover::flat_stepover_mm;
pub use options::PathOptions;
pub use settings::{CHORDS_MM, PathKeys, PathSettings, SCALLOPS_MM, most_lean_deg};

use crate::artifact::along::Along;
use crate::artifact::meridian::Meridian;
use crate::artifact::region::{Boundary, Region};
use crate::artifact::toolpath::{CutterLocation, Direction, PathKind};
use crate::artifact::{Blade, Toolpath};
use crate::error::{Error, Frame, Infeasible, Result, Spot, Stage, Stopped, SurfaceEnd};
use crate::geometry::Point;
use crate::geometry::allowance::Allowed;
use crate::observe::Observer;
use level::LevelSet;
use rim::Rim;

/// A ball in the corner between blade and hub is on the hub; what else ends turns is lower by this
/// share of its radius.
const OFF_HUB: f64 = 0.1;
/// Over a hub that the part does not have, a ball keeps so far off its contour beside the
/// clearance: smooth curves take the place of that.
const ABOVE_CONTOUR_MM: f64 = 0.05;

/// Lays the helix.
///
/// # Errors
/// Kind `Usage` for options out of their limits; kind `Infeasible` where no ball of this radius
/// goes round the airfoil, with the place; kind `Cancelled`.
pub fn plan(blade: &Blade, options: &PathOptions, observer: &dyn Observer) -> Result<Toolpath> {
    validate(blade, options)?;
    if options.settings.kind == PathKind::HubRows {
        return hub_rows(blade, options, observer);
    }
    match options.settings.direction {
        Direction::Climb => downwards(blade, options, observer),
        Direction::Conventional => direction::reversed(blade, options, |b, o| downwards(b, o, observer)),
    }
}

/// Lays the helix from the start height down to the end.
fn downwards(blade: &Blade, options: &PathOptions, observer: &dyn Observer) -> Result<Toolpath> {
    let over_hub = ends_on_hub(blade, options)?;
    let options = over_hub.as_ref().unwrap_or(options);
    let rim = Rim::of(blade, region(blade, options)?, options);
    let lowest_mm = bounds::lowest_mm(&options.extent.ends);
    let level = LevelSet { rim: rim.as_ref(), lowest_mm, ..plain_level(blade, options)? };
    let start_x = start_height(blade, options)?;
    match options.settings.kind {
        PathKind::ConstantHeight => constant_height::plan(blade, &level, options, start_x, observer),
        PathKind::IsoParametric => iso_parametric::plan(blade, &level, options, start_x, observer),
        PathKind::ConstantScallop => constant_scallop::plan(blade, &level, options, start_x, observer),
        PathKind::FirstOrder | PathKind::FirstOrderRings => {
            first_order::plan(blade, &level, options, start_x, observer)
        }
        PathKind::HubRows | PathKind::Given => Err(Error::usage(Stage::Path, "a helix does not lie so")),
    }
}

/// Over a hub that turns the path ends at the latest where a ball is on the hub: where blades end
/// flush with the rim, nothing else keeps turns from going on down there. `None` where nothing is
/// to be added.
fn ends_on_hub(blade: &Blade, options: &PathOptions) -> Result<Option<PathOptions>> {
    if region(blade, options)?.along.round().is_none() {
        return Ok(None);
    }
    let mut out = options.clone();
    let radius_mm = options.radius_mm + options.settings.stock_mm;
    let on_hub_mm = match options.hub_clearance_mm {
        None => radius_mm - OFF_HUB * options.radius_mm,
        Some(clearance_mm) => radius_mm + clearance_mm + ABOVE_CONTOUR_MM,
    };
    out.extent.ends.push(Boundary::Height(on_hub_mm));
    Ok(Some(out))
}

/// Lays rows over the hub.
fn hub_rows(blade: &Blade, options: &PathOptions, observer: &dyn Observer) -> Result<Toolpath> {
    let Some(wheel) = &options.hub_of else {
        return Err(Error::usage(Stage::Path, "path.kind is hub-rows, but the blade belongs to no wheel")
            .advise("give section wheel in the job"));
    };
    if blade.regions.over_hub().is_some() {
        let message =
            "path.kind is hub-rows, but the hub turns from along the rotor axis to across it: rows run along that axis";
        let of_sector = blade.wheel.is_some_and(|wheel| !wheel.whole);
        let or = if of_sector { ", or give the axis along which the blade of the sector stands (--axis)" } else { "" };
        let advice = format!("leave path.kind out: turns round the blade end on the hub{or}");
        return Err(Error::usage(Stage::Path, message).advise(advice));
    }
    hub::plan(blade, &plain_level(blade, options)?, wheel, options, observer)
}

/// The level set of a region, without what ends turns.
fn plain_level<'a>(blade: &'a Blade, options: &PathOptions) -> Result<LevelSet<'a>> {
    let own = region(blade, options)?.along;
    let along = own.for_ball(options.radius_mm + options.settings.stock_mm).ok_or_else(|| {
        let tip_mm = own.round().map_or(0.0, Meridian::tip_mm);
        let radius_mm = options.radius_mm;
        Error::infeasible(
            Stage::Path,
            format!("a ball of {radius_mm} mm has no room between the hub and the tips of the blades, {tip_mm:.3} mm above it"),
            Infeasible::AirfoilTooLow { height_mm: tip_mm, least_mm: radius_mm },
        )
        .advise("take a smaller ball")
    })?;
    Ok(LevelSet {
        part: Allowed::new(&blade.part, options.settings.stock_mm),
        along,
        radius_mm: options.radius_mm,
        inclined: options.inclined,
        rim: None,
        lowest_mm: f64::NEG_INFINITY,
    })
}

/// One closed loop of ball centres round the airfoil at the height `x_mm`, counter-clockwise seen
/// from the tip, its chords within the tolerance; the first location is not repeated.
///
/// # Errors
/// As [`plan`].
pub fn level(blade: &Blade, options: &PathOptions, x_mm: f64) -> Result<Vec<CutterLocation>> {
    validate(blade, options)?;
    let level = plain_level(blade, options)?;
    let ring = rings::first_ring(blade, &level, options, x_mm, &rings::tracing(options))?;
    helix::closed(&level, &ring, options)
}

/// The height of the first ring, mm: where the path begins, given, or far enough above the platform
/// for the root region; amid the region where it begins at faces.
///
/// The root region is taken as the lowest 30 % of the airfoil, at least three ball radii and at
/// most 40 mm: what the wide-line operation of the airfoil cannot reach because of the platform.
///
/// # Errors
/// Kind `Usage` where the region begins at a rim: only edges near the foot are asked whether they
/// are one.
fn start_height(blade: &Blade, options: &PathOptions) -> Result<f64> {
    match &options.extent.start {
        Some(Boundary::Height(x_mm)) => Ok(*x_mm),
        Some(Boundary::Rim(_)) => {
            Err(Error::usage(Stage::Path, "the region begins at a rim: a path begins at a height or at faces")
                .advise("give region.start_mm"))
        }
        Some(Boundary::Faces(_)) => {
            let [lo, hi] = patch_mm(blade, region(blade, options)?);
            Ok(0.5 * (lo + hi))
        }
        None => {
            let [a, b] = heights_mm(blade, options)?;
            let height = (0.3 * (b - a)).max(3.0 * options.radius_mm).min(40.0).min(0.9 * (b - a));
            Ok(a + height)
        }
    }
}

/// The region of the blade that the path goes round.
///
/// # Errors
/// Kind `Usage` where the blade has no region of this number.
fn region<'b>(blade: &'b Blade, options: &PathOptions) -> Result<&'b Region> {
    let number = options.extent.region;
    blade.regions.list.get(number).ok_or_else(|| {
        let count = blade.regions.list.len();
        Error::usage(
            Stage::Path,
            format!("the path is to go round region {number}, but the blade has {count}, from 0 up"),
        )
    })
}

/// Heights of the foot and the top of that region, mm; those of the part where no heights bound it.
fn heights_mm(blade: &Blade, options: &PathOptions) -> Result<[f64; 2]> {
    let region = region(blade, options)?;
    Ok(region.x_mm().unwrap_or_else(|| span_mm(blade, region)))
}

/// Least and greatest height of a region's surface, mm; those of the part where none is known.
fn patch_mm(blade: &Blade, region: &Region) -> [f64; 2] {
    let mesh = &blade.part.mesh;
    let own = (0..mesh.triangles.len()).filter(|t| region.patch.has(mesh, *t as u32));
    let heights = own.flat_map(|t| mesh.corners(t)).map(|p| region.along.height_mm(&p));
    let [lo, hi] = least_and_greatest(heights);
    if lo <= hi { [lo, hi] } else { span_mm(blade, region) }
}

fn least_and_greatest(heights: impl Iterator<Item = f64>) -> [f64; 2] {
    heights.fold([f64::INFINITY, f64::NEG_INFINITY], |[lo, hi], x| [lo.min(x), hi.max(x)])
}

/// Least and greatest height of the part along a region, mm.
fn span_mm(blade: &Blade, region: &Region) -> [f64; 2] {
    if region.along == Along::BLADE {
        return blade.regions.part_x_mm;
    }
    // Far from the blade heights over a hub that turns mean nothing.
    if let Some(meridian) = region.along.round() {
        return [0.0, meridian.tip_mm()];
    }
    least_and_greatest(blade.part.mesh.points.iter().map(|p| region.along.height_mm(p)))
}

fn validate(blade: &Blade, o: &PathOptions) -> Result<()> {
    if !(o.radius_mm > 0.0 && o.radius_mm.is_finite()) {
        return Err(Error::usage(Stage::Path, format!("tool.radius_mm is {}, it must be greater than 0", o.radius_mm)));
    }
    o.settings.check(Stage::Path)?;
    if o.settings.scallop_mm >= 0.5 * o.radius_mm {
        return Err(Error::usage(
            Stage::Path,
            format!(
                "path.scallop_mm is {}, it must be less than half the ball radius ({} mm)",
                o.settings.scallop_mm, o.radius_mm
            ),
        ));
    }
    validate_extent(blade, o)?;
    if let Some(size) = blade.part.mesh.aabb().map(|b| b.max - b.min).filter(|s| s.max() < 2.0 * o.radius_mm) {
        return Err(Error::infeasible(
            Stage::Path,
            format!(
                "the part ({:.3} × {:.3} × {:.3} mm) is smaller than the tool, a ball of {} mm in diameter",
                size.x,
                size.y,
                size.z,
                2.0 * o.radius_mm
            ),
            Infeasible::PartSmallerThanTool { size_mm: size.into(), radius_mm: o.radius_mm },
        )
        .advise("take a smaller ball, or check the model's unit with --unit"));
    }
    let [a, b] = heights_mm(blade, o)?;
    if b - a < 0.5 * o.radius_mm {
        return Err(Error::infeasible(
            Stage::Path,
            format!("the airfoil is {:.3} mm high, less than half the ball radius of {} mm: the part is smaller than the tool", b - a, o.radius_mm),
            Infeasible::AirfoilTooLow { height_mm: b - a, least_mm: 0.5 * o.radius_mm },
        )
        .advise("take a smaller ball, or check the model's unit with --unit"));
    }
    Ok(())
}

/// Whether a path of this kind can begin and end where it is to.
fn validate_extent(blade: &Blade, o: &PathOptions) -> Result<()> {
    let marks = |end: &Boundary| matches!(end, Boundary::Faces(flags) if flags.contains(&true));
    if o.extent.ends.iter().any(marks) && o.settings.kind != PathKind::ConstantScallop {
        return Err(Error::usage(
            Stage::Path,
            "region.end_faces ends turns of constant scallop only: other turns do not run along the edge of a face",
        )
        .advise("set path.kind to constant-scallop, or give region.end_mm"));
    }
    if matches!(o.extent.start, Some(Boundary::Faces(_))) && o.settings.kind != PathKind::ConstantScallop {
        return Err(Error::usage(
            Stage::Path,
            "the region begins at faces: only turns of constant scallop run along their edge",
        )
        .advise("set path.kind to constant-scallop, or give region.start_mm"));
    }
    let [lo, hi] = span_mm(blade, region(blade, o)?);
    let height = |b: &Boundary| if let Boundary::Height(x_mm) = b { Some(*x_mm) } else { None };
    let start = o.extent.start.as_ref().and_then(height).map(|x| ("region.start_mm", x));
    let ends = o.extent.ends.iter().filter_map(height).map(|x| ("region.end_mm", x));
    if let Some((key, x)) = start.into_iter().chain(ends.clone()).find(|(_, x)| !(lo..=hi).contains(x)) {
        return Err(Error::usage(
            Stage::Path,
            format!("{key} is {x} mm, outside the part, which spans {lo:.3} to {hi:.3} mm along the blade axis"),
        )
        .advise("choose heights inside the part; `inspect` prints where the airfoil and the platform are"));
    }
    if let Some((_, a)) = start
        && let Some((_, b)) = ends.into_iter().find(|(_, b)| *b >= a)
    {
        return Err(Error::usage(
            Stage::Path,
            format!(
                "region.end_mm ({b} mm) must be below region.start_mm ({a} mm): the helix runs from the airfoil towards the platform"
            ),
        ));
    }
    Ok(())
}

/// A point of the blade frame in words, with its place in the model.
fn place(blade: &Blade, p: &Point) -> String {
    spot(blade, p).at_height(p.x)
}

/// A point of the blade frame in the model.
fn spot(blade: &Blade, p: &Point) -> Spot {
    let turned = if blade.diagnosis.mirrored { Point::new(p.x, p.y, -p.z) } else { *p };
    Spot { frame: Frame::Model, point_mm: (blade.model_from_blade * turned).into() }
}

/// What ends turns at a ball centre, blade frame.
fn surface_end(blade: &Blade, by: Stopped, p: &Point, options: &PathOptions) -> SurfaceEnd {
    let along = region(blade, options).map_or(Along::BLADE, |region| region.along);
    SurfaceEnd {
        by,
        height_mm: along.height_mm(p),
        at: spot(blade, p),
        radius_mm: options.radius_mm,
        max_lean_deg: options.settings.max_lean_deg,
    }
}

/// A ball that loses the surface near some of its centres, blade frame, as data.
fn loses_surface(radius_mm: f64, near: &[Point]) -> Infeasible {
    let near = near.iter().map(|p| Spot { frame: Frame::Blade, point_mm: (*p).into() }).collect();
    Infeasible::BallLosesSurface { radius_mm, near }
}
