//! The same turns the other way: from the end of the region up, still counter-clockwise seen from
//! the tip.
//!
//! A helix that is laid down the mirror image of the part, mirrored back, runs clockwise downwards;
//! run backwards, it runs counter-clockwise upwards. So every kind of path is turned round without
//! knowing of it, and the stages that follow, which count on counter-clockwise turns, need not know
//! either.

use super::helix;
use super::level::Touch;
use super::options::PathOptions;
use crate::artifact::blade::Diagnosis;
use crate::artifact::{Blade, Toolpath};
use crate::error::Result;
use crate::geometry::{Point, Vector};
use crate::observe::Silent;
use crate::tool::inclination::Inclined;

/// Lays the path with `downwards` on the mirror image and turns it round.
///
/// # Errors
/// Those of `downwards`; kind `Infeasible` where the mirror image cannot be meshed.
pub fn reversed(
    blade: &Blade,
    options: &PathOptions,
    downwards: impl Fn(&Blade, &PathOptions) -> Result<Toolpath>,
) -> Result<Toolpath> {
    let diagnosis = Diagnosis { mirrored: !blade.diagnosis.mirrored, ..blade.diagnosis.clone() };
    let regions = blade.regions.mirrored();
    let image = Blade { part: blade.part.mirrored(&Silent)?, regions, diagnosis, ..blade.clone() };
    let start_near = options.start_near.map(|[x, y, z]| [x, y, -z]);
    // The image is run through the other way round.
    let inclined = options.inclined.map(|i| Inclined { rises: !i.rises, ..i });
    let path = downwards(&image, &PathOptions { start_near, inclined, ..options.clone() })?;
    Ok(turned_round(path))
}

/// Mirrored back and run backwards.
fn turned_round(path: Toolpath) -> Toolpath {
    let touches: Vec<Touch> = path
        .locations
        .iter()
        .rev()
        .map(|l| Touch {
            // No one asks any more.
            face: 0,
            centre: Point::new(l.centre.x, l.centre.y, -l.centre.z),
            contact: Point::new(l.contact.x, l.contact.y, -l.contact.z),
            normal: Vector::new(l.normal.x, l.normal.y, -l.normal.z),
        })
        .collect();
    let Some((end, _)) = touches.split_last() else { return path };
    let n = touches.len();
    // Every turn but the first begins where it began before; the first begins where the path ended.
    let mut firsts: Vec<usize> = path.turns.iter().skip(1).rev().map(|t| n - 1 - t.first).collect();
    firsts.insert(0, 0);
    firsts.push(n - 1);
    let turns: Vec<Vec<Touch>> = firsts.windows(2).map(|w| touches[w[0]..w[1]].to_vec()).collect();
    let (turns, locations) = helix::number(&turns, *end);
    let [a, b] = path.region_x_mm;
    Toolpath { turns, locations, region_x_mm: [b, a], ..path }
}
