//! The sheet midway between the sides of a blade, with both balls at each of its places.

use std::collections::BTreeSet;

use super::super::curve::cubic;
use super::super::level::{LevelSet, Touch};
use super::super::stepover::{Pass, ridge_height};
use super::{PairOptions, no_pairs};
use crate::artifact::Blade;
use crate::artifact::along::Along;
use crate::artifact::paired::{BallContact, PairPlace, RowEnd};
use crate::artifact::region::{Area, Region};
use crate::error::{Error, Result, Stage};
use crate::geometry::allowance::Allowed;
use crate::geometry::opposite::{Pair, SurfacePlace, has_inside, partner, partner_across_creases};
use crate::geometry::profile::Sides;
use crate::geometry::triangle::closest_on_segment;
use crate::geometry::{Point, Vector};

/// The second ball has room where it comes to rest within this share of its radius of where its
/// contact is opposite the first: on a wall of many faces it rests on two of them beside a crease.
const ROOM: f64 = 0.01;
/// Beside such a crease the ball inside may hold so much of the wall, as a share of its radius: as
/// where two faces meet at 8°.
const CREASED: f64 = 0.01;
/// From place to place the ball inside grows by less than this.
const LARGER: f64 = 2.0;
/// Both balls stay so much farther apart than the tools are asked to, mm.
const APART_MM: f64 = 0.01;
/// Heights of the row before, on each side, among which its nearest place is looked for.
const NEAR: usize = 12;
/// Pieces of a row's curve between two heights where distances to it are taken.
const PIECES: usize = 8;

/// Something, or why a row ends where it would be.
pub(super) type OrEnd<T> = std::result::Result<T, RowEnd>;

/// Both balls at a place of the sheet.
#[derive(Clone, Copy, Debug)]
pub(super) struct Standing {
    pub touches: [Touch; 2],
    pub pair: Pair,
}

impl Standing {
    /// Balls at both edges, which hold nothing between them: what is midway between their contacts
    /// stands for it.
    pub fn round_edges(touches: [Touch; 2], stock_mm: f64) -> Self {
        let [first, second] =
            touches.map(|t| SurfacePlace { point: t.contact - t.normal * stock_mm, normal: t.normal });
        let pair = Pair {
            first,
            second,
            face: touches[1].face,
            triangle: None,
            centre: nalgebra::center(&first.point, &second.point),
            radius_mm: 0.5 * (second.point - first.point).norm(),
        };
        Standing { touches, pair }
    }

    /// The same as it is carried on.
    pub fn place(&self) -> PairPlace {
        let contact = |t: &Touch| BallContact { centre: t.centre, contact: t.contact, normal: t.normal, face: t.face };
        PairPlace {
            contacts: [contact(&self.touches[0]), contact(&self.touches[1])],
            held_centre: self.pair.centre,
            held_radius_mm: self.pair.radius_mm,
            angle_rad: self.pair.angle_rad(),
            apart_mm: self.pair.apart_mm(),
        }
    }
}

/// The part as both tools see it.
pub(super) struct Sheet<'a> {
    pub blade: &'a Blade,
    pub options: &'a PairOptions,
    /// The level sets of both radii.
    pub levels: [LevelSet<'a>; 2],
    pub sides: &'a Sides,
    airfoil: &'a Region,
    /// Faces of the airfoil.
    faces: BTreeSet<u32>,
    /// No ball inside the part is larger, mm.
    within_mm: f64,
}

impl<'a> Sheet<'a> {
    /// That of a blade.
    ///
    /// # Errors
    /// Kind `Infeasible` where the part has no exact faces, no inside, no airfoil or no known
    /// edges.
    pub fn of(blade: &'a Blade, options: &'a PairOptions) -> Result<Self> {
        let part = &blade.part;
        if part.brep.is_none() {
            return Err(no_pairs(
                "the part is a mesh: a ball inside it touches the facet beside its own first, and no other side".into(),
                "take the CAD model with its exact faces (STEP or IGES)",
            ));
        }
        has_inside(part, Stage::Path)?;
        let Some(airfoil) = blade.regions.first(Area::Airfoil) else {
            return Err(no_pairs("no airfoil was found on the part".into(), "say where it is: --faces or --region"));
        };
        let Some(sides) = &airfoil.sides else {
            return Err(no_pairs(
                "the airfoil's leading and trailing edge are not known, so it has no two sides".into(),
                "one tool can machine it",
            ));
        };
        let stock_mm = options.settings.stock_mm;
        let level = |radius_mm| LevelSet {
            part: Allowed::new(part, stock_mm),
            along: Along::BLADE,
            radius_mm,
            inclined: None,
            rim: None,
            lowest_mm: f64::NEG_INFINITY,
        };
        let flags = (0..part.mesh.triangles.len() as u32).filter(|t| airfoil.patch.has(&part.mesh, *t));
        let faces: BTreeSet<u32> = flags.map(|t| part.mesh.face(t as usize)).collect();
        let within_mm = part.mesh.aabb().map_or(0.0, |b| b.diagonal_mm());
        Ok(Sheet { blade, options, levels: options.radius_mm.map(level), sides, airfoil, faces, within_mm })
    }

    /// The contour of the airfoil at a height, as a ball of tool 1 in that plane that touches it.
    pub fn seed(&self, x_mm: f64) -> Result<Option<Touch>> {
        let (own, _) = super::super::seed::contour(self.blade, self.airfoil, x_mm)?;
        Ok(super::super::seed::first_touch(&self.levels[0], &own, x_mm))
    }

    fn is_airfoil(&self, face: u32) -> bool {
        self.faces.contains(&face)
    }

    /// Both balls where the first touches.
    pub fn stand(&self, first: Touch) -> OrEnd<Standing> {
        self.stand_near(first, self.within_mm)
    }

    /// The same where the ball inside is probably smaller than this, mm: the search begins there.
    fn stand_near(&self, first: Touch, within_mm: f64) -> OrEnd<Standing> {
        if !self.is_airfoil(first.face) {
            return Err(RowEnd::Elsewhere);
        }
        let part = &self.blade.part;
        let stock_mm = self.options.settings.stock_mm;
        let place = SurfacePlace { point: first.contact - first.normal * stock_mm, normal: first.normal };
        let is_opposite = |pair: &Pair| pair.angle_rad() <= self.options.max_angle_rad;
        // A ball that holds nothing is as large as the search began with.
        let near = (within_mm < self.within_mm).then(|| partner(part, place, within_mm)).flatten();
        let exact = near.or_else(|| partner(part, place, self.within_mm));
        // Beside a crease the ball touches the next face of the same wall first.
        let creased = || partner_across_creases(part, place, self.within_mm, CREASED).filter(is_opposite);
        let none = if exact.is_some() { RowEnd::Angle } else { RowEnd::NoPartner };
        let pair = exact.filter(is_opposite).or_else(creased).ok_or(none)?;
        if !self.is_airfoil(pair.face) {
            return Err(RowEnd::Elsewhere);
        }
        let level = &self.levels[1];
        let rest = pair.second.point + pair.second.normal * (level.radius_mm + stock_mm);
        let room_mm = ROOM * level.radius_mm;
        let second = level.touch(&rest, room_mm).filter(|t| (t.centre - rest).norm() <= room_mm);
        // Beside the platform it may come to rest there, and the blade is out of its reach.
        let second = second.filter(|t| self.is_airfoil(t.face)).ok_or(RowEnd::NoRoom)?;
        let balls_mm = (second.centre - first.centre).norm() - self.options.radius_mm[0] - self.options.radius_mm[1];
        if balls_mm < self.options.apart_mm + APART_MM {
            return Err(RowEnd::TooNear);
        }
        Ok(Standing { touches: [first, second], pair })
    }

    /// Both balls where the first touches, beside a place.
    pub fn beside(&self, from: &Standing, first: Touch) -> OrEnd<Standing> {
        self.stand_near(first, LARGER * from.pair.radius_mm)
    }

    /// Both balls at a step across from a place, at the height of its first ball. The step goes
    /// counter-clockwise seen from the tip where it is positive, mm.
    pub fn across(&self, from: &Standing, step_mm: f64) -> OrEnd<Standing> {
        let level = &self.levels[0];
        let tangent = from.touches[0].tangent(&Along::BLADE);
        let reach = step_mm.abs() + 0.02 * level.radius_mm;
        let touch = level.touch_in_plane(&(from.touches[0].centre + tangent * step_mm), reach);
        let next = self.beside(from, touch.ok_or(RowEnd::NoBall)?)?;
        // On one sheet the partner goes about as far as the place itself.
        let gone = |a: &SurfacePlace, b: &SurfacePlace| (b.point - a.point).norm();
        let own = gone(&from.pair.first, &next.pair.first).max(0.02 * level.radius_mm);
        match gone(&from.pair.second, &next.pair.second) <= 3.0 * own {
            true => Ok(next),
            false => Err(RowEnd::Jump),
        }
    }

    /// Ridges that both balls of a place leave beside the row before, mm, on each side; `k`: the
    /// height at which the place is. Infinite where a ball does not reach over what is between.
    pub fn ridges_mm(&self, before: &RowCurves, k: usize, at: &Standing) -> [f64; 2] {
        [0, 1].map(|j| {
            let here = &at.touches[j].centre;
            let foot = before.nearest(k, j, here);
            let ridge = |foot| ridge_height(&self.levels[j], [foot, *here].map(|c| Pass::of_ball(&c)).each_ref());
            foot.and_then(ridge).unwrap_or(f64::INFINITY)
        })
    }

    /// The higher of the ridges that both tools leave between a row and the next, midway from the
    /// height `k` to the one below it, mm.
    pub fn ridge_between_mm(&self, [before, after]: [&RowCurves; 2], k: usize) -> f64 {
        let of = |j: usize| {
            let level = &self.levels[j];
            let here = level.touch(after.middle(k, j)?, 0.1 * level.radius_mm)?.centre;
            ridge_height(level, [before.nearest(k, j, &here)?, here].map(|c| Pass::of_ball(&c)).each_ref())
        };
        (0..2).map(|j| of(j).unwrap_or(0.0)).fold(0.0, f64::max)
    }

    /// The first row has no place at a height.
    pub fn lost(&self, end: RowEnd, x_mm: f64) -> Error {
        Error::infeasible(
            Stage::Path,
            format!("no row for two tools begins at height {x_mm:.3} mm: {end}"),
            crate::error::Infeasible::NoPairs,
        )
        .advise("move pinch.heights_mm, or take a smaller ball")
    }
}

/// A row's curves of both ball centres: cubics through its places, in pieces.
pub(super) struct RowCurves {
    first: usize,
    pieces: [Vec<Point>; 2],
}

impl RowCurves {
    /// Those of a row whose places follow one another.
    pub fn of(row: &[Option<Standing>]) -> Self {
        let first = row.iter().position(Option::is_some).unwrap_or(0);
        let pieces = [0, 1].map(|j| {
            let centres: Vec<Point> = row.iter().flatten().map(|s| s.touches[j].centre).collect();
            // Of the parabola through three neighbours, per height.
            let slope = |k: usize| match (k.checked_sub(1).map(|b| centres[b]), centres.get(k + 1)) {
                (Some(b), Some(a)) => (a - b) * 0.5,
                (None, Some(a)) => a - centres[k],
                (Some(b), None) => centres[k] - b,
                (None, None) => Vector::zeros(),
            };
            let mut out = Vec::with_capacity(PIECES * centres.len());
            for k in 0..centres.len().saturating_sub(1) {
                let (ends, slopes) = ([&centres[k], &centres[k + 1]], [slope(k), slope(k + 1)]);
                out.extend((0..PIECES).map(|n| cubic(ends, slopes, n as f64 / PIECES as f64)));
            }
            out.extend(centres.last());
            out
        });
        RowCurves { first, pieces }
    }

    /// The middle of a tool's curve between the heights `k` and `k + 1`.
    fn middle(&self, k: usize, tool: usize) -> Option<&Point> {
        self.pieces[tool].get(PIECES * k.checked_sub(self.first)? + PIECES / 2)
    }

    /// The nearest place of a tool's curve to a centre at the height `k`.
    fn nearest(&self, k: usize, tool: usize, q: &Point) -> Option<Point> {
        let all = &self.pieces[tool];
        let at = PIECES * k.saturating_sub(self.first);
        let near = all.get(at.saturating_sub(PIECES * NEAR).min(all.len())..(at + PIECES * NEAR + 1).min(all.len()))?;
        let feet = near.windows(2).map(|w| closest_on_segment(&w[0], &w[1], q));
        feet.min_by(|a, b| (a - q).norm_squared().total_cmp(&(b - q).norm_squared()))
    }
}

/// The direction of a row at one of its heights, unit.
pub(super) fn along_row(row: &[Option<Standing>], k: usize) -> Option<Vector> {
    let centre = |k: usize| row.get(k)?.as_ref().map(|s| s.touches[0].centre);
    let (before, here, after) = (k.checked_sub(1).and_then(centre), centre(k)?, centre(k + 1));
    (after.unwrap_or(here) - before.unwrap_or(here)).try_normalize(1e-12)
}
