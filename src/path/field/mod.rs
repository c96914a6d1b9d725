//! Turns of constant scallop, read off a field.
//!
//! In: a blade and [`PathOptions`]. Out: a [`Toolpath`], as of
//! [`PathKind::ConstantScallop`](crate::artifact::toolpath::PathKind::ConstantScallop). It is not
//! the path that plans take: that is laid by a front ([`super::constant_scallop`]).
//! `cargo bench --bench field` lays both side by side.
//!
//! ## Method
//! The helix is its own neighbour: with `φ` the number of the turn plus the fraction of the way
//! round, `|∇φ| = 1/d` on the level set, where `d` is the distance that leaves the scallop `h`.
//! Two balls at the centres `c`, `c'` with the contacts `p`, `p'` leave the ridge
//! `(c' − c)·(p' − p) / 8R` to the second order, whatever the curvature, so that is the eikonal
//! equation of the metric `dc·dp / 8Rh`.
//!
//! * The level set becomes a mesh of cells somewhat smaller than a stepover, within the bounds of
//!   the region (`net`). Its border below the start is the end of the region, and the last turn.
//! * `φ` is solved once from the end (`eikonal`). The viscosity solution is the length of the
//!   shortest way to the end: fronts that meet end there, so that lines of equal `φ` have no folds
//!   that would have to be cut out.
//! * Turns are read off it and polished by the ridge to the turn before, measured on the part, so
//!   that no error adds up (`turns`). They are laid up from the end and run through in the reverse
//!   order. The last comes onto the end by a smooth ramp of 20 stepovers.
//! * Where a part of the way round comes to a border and the rest never does, the end is drawn at
//!   the height that the rest has when no more comes to it.
//! * The helix begins with the lowest turn that is nowhere under the start height, or along the
//!   faces at which the region begins. Places more than [`HIGHEST`] of the region's height above
//!   the start are waited at.
//! * **Meshes**: the field sees how contacts go on the average over some facets, so that facets do
//!   not shape it; each turn is polished by the ridge over the facets as they are. Ridges over
//!   facets scatter about those of the part they stand for; where their 99th percentile is too
//!   high, the turns are laid closer.
//!
//! ## Limits
//! Islands within the region that the ball may not go to are gone round by the turns that meet
//! them, and are not reported.

mod eikonal;
mod feet;
mod net;
mod rolling;
mod turns;
mod values;

use rayon::prelude::*;

use self::feet::Curve;
use self::net::{Edge, Net, lines};
use self::rolling::rolls_off;
use self::turns::{Reader, Turn};
use self::values::Field;
use super::bounds::{self, Bounds, Stop};
use super::constant_scallop::{end_reason, finish, named};
use super::level::{LevelSet, Touch};
use super::options::PathOptions;
use super::rim::Rim;
use super::ring::Ring;
use super::stepover::flat_stepover_mm;
use super::{curve, region, rings, spot, start_height, validate};
use crate::artifact::{Blade, Toolpath};
use crate::error::{Error, Infeasible, Result, Stage, Stopped};
use crate::geometry::Point;
use crate::geometry::allowance::Allowed;
use crate::observe::Observer;

/// Cells of the mesh, in stepovers on flat ground, ...
const CELL: f64 = 0.8;
/// ... and at most so many ball radii: the mesh is to follow the level set round edges.
const CELL_RADII: f64 = 0.3;
/// Cells of the mesh that only tells how far down the end is, over those.
const COARSER: f64 = 2.0;
/// Distance of places along a turn, in stepovers on flat ground, and in ball radii: turns that go
/// round something small are shaped by it.
const STEP: [f64; 2] = [0.8, 0.2];
/// Reach of the fits to the field, in cells, on exact faces and over facets.
const REACH: [f64; 2] = [2.0, 3.0];
/// Reach over which the ways of contacts are averaged over facets, in edges of facets and in cells,
/// at least and at most.
const AVERAGE: [f64; 3] = [2.0, 2.0, 4.0];
/// Within so many cells of the end φ is taken from the ridge to it.
const BESIDE_END: f64 = 1.1;
/// How far over the start height a place may be cut, as a share of the height of the region.
const HIGHEST: f64 = 0.5;
/// Share of a turn from which on it counts as being at the end in part: a burr may stop the ball at
/// a place.
const LEAST_PART: f64 = 0.05;
/// Stepovers by which the part of the way round that is not at the end may not become less before
/// the end is drawn.
const PATIENCE: usize = 3;
/// More turns than this is a mistake in the options.
const MOST_TURNS: usize = 20_000;
/// How often turns over facets are laid closer, where their ridges are over this share of the
/// scallop, and by no more than this at a time.
const MOST_AIMS: usize = 1;
const MOST_OVER: f64 = 1.15;
const LEAST_AIM: f64 = 0.9;
/// Places about the end for each cell.
const END_PLACES: f64 = 4.0;

/// Lays the helix, climb milling.
///
/// # Errors
/// As [`super::plan`].
pub fn plan(blade: &Blade, options: &PathOptions, observer: &dyn Observer) -> Result<Toolpath> {
    validate(blade, options)?;
    let region = region(blade, options)?;
    let rim = Rim::of(blade, region, options);
    let part = Allowed::new(&blade.part, options.settings.stock_mm);
    let lowest_mm = bounds::lowest_mm(&options.extent.ends);
    let level = LevelSet { part, along: region.along, radius_mm: options.radius_mm, rim: rim.as_ref(), lowest_mm };
    Laying::new(blade, &level, options, start_height(blade, options)?, observer)?.lay()
}

/// What a helix is laid by.
struct Laying<'a> {
    blade: &'a Blade,
    level: &'a LevelSet<'a>,
    options: &'a PathOptions,
    observer: &'a dyn Observer,
    /// Height that is to be cut from, mm.
    start_x: f64,
    /// The ring there.
    ring: Ring,
    /// Mean height of the ring's centres, mm.
    ring_x: f64,
    bounds: Bounds<'a>,
    /// Stepover on flat ground, mm.
    flat_mm: f64,
    cell_mm: f64,
}

/// The end of the region: where the helix comes to.
struct End {
    /// Closed, at even places; the region lies to the left of it seen from outside.
    curve: Vec<Touch>,
    stop: (Stopped, Option<Point>),
}

impl<'a> Laying<'a> {
    fn new(
        blade: &'a Blade,
        level: &'a LevelSet,
        options: &'a PathOptions,
        start_x: f64,
        observer: &'a dyn Observer,
    ) -> Result<Self> {
        let flat_mm = flat_stepover_mm(options.radius_mm, options.settings.scallop_mm);
        let tracing = rings::tracing_along(options, flat_mm);
        let ring = rings::first_ring(blade, level, options, start_x, &tracing)?;
        let bounds =
            Bounds::of(level.along, &options.extent.ends, level.rim, options.settings.max_lean_deg.to_radians());
        let ring_x = mean(ring.touches.iter().map(|t| level.along.height_mm(&t.centre)));
        let cell_mm = (CELL * flat_mm).min(CELL_RADII * options.radius_mm);
        Ok(Laying { blade, level, options, observer, start_x, ring, ring_x, bounds, flat_mm, cell_mm })
    }

    fn height_mm(&self, t: &Touch) -> f64 {
        self.level.along.height_mm(&t.centre)
    }

    /// Whether a touch is where the helix may go, between two heights.
    fn holds(&self, t: &Touch, [low, high]: [f64; 2]) -> bool {
        let begin = Bounds { ends: self.options.extent.start_faces(), ..Bounds::NONE };
        (low..=high).contains(&self.height_mm(t)) && self.bounds.hold(t) && begin.hold(t) && !rolls_off(self.level, t)
    }

    fn progress(&self, done: usize) -> Result<()> {
        self.observer.progress(Stage::Path, done, 2000);
        self.observer.check(Stage::Path)
    }

    fn lay(&self) -> Result<Toolpath> {
        let lowest_mm = self.drawn_mm()?;
        let to_faces = !self.options.extent.start_faces().is_empty();
        // How far down the end is tells how far up turns may go.
        let highest_mm = if to_faces { f64::INFINITY } else { self.start_x + HIGHEST * (self.start_x - lowest_mm[1]) };
        let within = |t: &Touch| self.holds(t, [lowest_mm[0], highest_mm]);
        let net = Net::grow(self.level, &self.ring.touches, self.cell_mm, &within, &|| self.progress(300))?;
        let end = self.end_of(&net, &within)?;
        let flat_end = Curve::new(end.curve.clone(), true);
        let phi = self.solved(&net, &flat_end)?;
        let mut aim_mm = self.options.settings.scallop_mm;
        let mut best: Option<Toolpath> = None;
        for _ in 0..=MOST_AIMS {
            let path = self.turns(&net, &flat_end, &phi, aim_mm, &within, &end)?;
            let over = path.planned_scallop_mm / self.options.settings.scallop_mm;
            if best.as_ref().is_none_or(|b| path.planned_scallop_mm < b.planned_scallop_mm) {
                best = Some(path);
            }
            if !self.level.is_over_facets() || over <= MOST_OVER {
                break;
            }
            aim_mm *= (MOST_OVER / over).max(LEAST_AIM);
        }
        best.ok_or_else(|| Error::infeasible(Stage::Path, "no helix was laid", Infeasible::NoHelix))
    }

    /// The least height of the helix, mm, −∞ where its bounds end it all round, and about how far
    /// down it comes.
    ///
    /// A front goes down from the ring, a stepover at a time, on a coarse mesh. Where a part of it
    /// has come to its bounds and the rest has not become less for [`PATIENCE`] stepovers, the end
    /// is drawn at the lowest place of that front. Ends that were asked for stay.
    fn drawn_mm(&self) -> Result<[f64; 2]> {
        let cell_mm = (COARSER * self.cell_mm).min(CELL_RADII * self.options.radius_mm);
        let highest_mm =
            if self.options.extent.start_faces().is_empty() { self.start_x + 4.0 * cell_mm } else { f64::INFINITY };
        let within = |t: &Touch| self.holds(t, [f64::NEG_INFINITY, highest_mm]);
        let net = Net::grow(self.level, &self.ring.touches, cell_mm, &within, &|| self.progress(100))?;
        let heights = || (0..net.touches.len()).filter(|v| net.within[*v]).map(|v| self.height_mm(&net.touches[v]));
        let lowest_mm = heights().fold(f64::INFINITY, f64::min);
        if self.bounds.x_mm[0] > f64::NEG_INFINITY || !self.options.extent.ends.is_empty() {
            return Ok([f64::NEG_INFINITY, lowest_mm]);
        }
        let ring = Curve::new(self.ring.touches.clone(), true);
        let step_mm = COARSER * self.flat_mm;
        let beside = net.beside(&ring.touches, 3);
        let given: Vec<Option<f64>> = (0..net.touches.len())
            .into_par_iter()
            .map(|v| {
                let t = &net.touches[v];
                if !net.within[v] {
                    return Some(f64::INFINITY);
                }
                if !beside[v] {
                    return None;
                }
                let off_mm = ring.foot(&t.centre).map_or(f64::INFINITY, |f| (f - t.centre).norm());
                (off_mm < BESIDE_END * cell_mm).then_some(off_mm / step_mm)
            })
            .collect();
        let phi = eikonal::solve(&net, &given, |a, b| {
            let [a, b] = [a, b].map(|v| &net.touches[v as usize]);
            eikonal::stepovers(self.level, a, b, step_mm, self.options.settings.scallop_mm * COARSER * COARSER)
        });
        let most = phi.iter().filter(|p| p.is_finite()).fold(0.0f64, |a, b| a.max(*b));
        let (mut least_mm, mut since, mut lows) = (f64::INFINITY, 0, Vec::new());
        for k in 1..=most.floor() as usize {
            let [free_mm, whole_mm, low_mm] = self.front(&net, &phi, k as f64);
            lows.push(low_mm);
            if free_mm < least_mm || free_mm > (1.0 - LEAST_PART) * whole_mm {
                (least_mm, since) = (free_mm, 0);
            } else {
                since += 1;
            }
            if since >= PATIENCE {
                let drawn_mm = lows[k - 1 - since];
                return Ok([drawn_mm, drawn_mm]);
            }
        }
        Ok([f64::NEG_INFINITY, lowest_mm])
    }

    /// Length of a front below the ring that is not at its bounds, the whole, and its lowest
    /// height, mm.
    fn front(&self, net: &Net, phi: &[f64], value: f64) -> [f64; 3] {
        let (mut free_mm, mut whole_mm, mut low_mm) = (0.0, 0.0, f64::INFINITY);
        for line in lines(&net.triangles, |v| phi[v as usize] < value) {
            let places: Vec<(Point, bool)> = line
                .iter()
                .map(|&(a, b)| match net.crossing((a, b), phi, value) {
                    Some(p) => (p, true),
                    None => (nalgebra::center(&net.centre(a), &net.centre(b)), false),
                })
                .collect();
            let height = |p: &Point| self.level.along.height_mm(p);
            if mean(places.iter().map(|p| height(&p.0))) > self.ring_x {
                continue;
            }
            for (i, (p, is_free)) in places.iter().enumerate() {
                let (q, next_is_free) = places[(i + 1) % places.len()];
                whole_mm += (q - p).norm();
                free_mm += if *is_free && next_is_free { (q - p).norm() } else { 0.0 };
                low_mm = low_mm.min(height(p));
            }
        }
        [free_mm, whole_mm, low_mm]
    }

    /// The border below the ring.
    fn end_of(&self, net: &Net, within: &(impl Fn(&Touch) -> bool + Sync)) -> Result<End> {
        let mut longest: Option<(f64, Vec<[Touch; 2]>)> = None;
        let mut nearest: Option<[Touch; 2]> = None;
        for line in lines(&net.triangles, |v| net.within[v as usize]) {
            let border: Vec<[Touch; 2]> = line.par_iter().map(|e| net.border(self.level, *e, within)).collect();
            nearest = nearest.or(border.first().copied());
            let heights = border.iter().map(|b| self.height_mm(&b[0]));
            let length_mm: f64 = (0..border.len())
                .map(|i| (border[(i + 1) % border.len()][0].centre - border[i][0].centre).norm())
                .sum();
            if mean(heights) < self.ring_x && longest.as_ref().is_none_or(|l| length_mm > l.0) {
                longest = Some((length_mm, border));
            }
        }
        let Some((length_mm, border)) = longest.filter(|l| l.0 > self.flat_mm) else {
            let at = nearest.map(|b| b[0].centre);
            return Err(self.not_one_turn((Stopped::BallTooLarge, at)));
        };
        let stop = self.stopped(&border);
        let mut curve =
            self.even(&border.iter().map(|b| b[0]).collect::<Vec<_>>(), length_mm, self.cell_mm / END_PLACES);
        let n = curve.len();
        let up: f64 = (0..n)
            .map(|i| {
                let side = curve[i].normal.cross(&(curve[(i + 1) % n].centre - curve[i].centre));
                self.level.along.axis().dot(&side)
            })
            .sum();
        if up < 0.0 {
            curve.reverse();
        }
        Ok(End { curve, stop })
    }

    /// What ends the helix, and where.
    fn stopped(&self, border: &[[Touch; 2]]) -> (Stopped, Option<Point>) {
        let why = border.iter().map(|[inside, outside]| {
            if self.bounds.hold(outside) && rolls_off(self.level, outside) {
                Stop::Edge(outside.contact)
            } else {
                self.bounds.why(inside, outside)
            }
        });
        why.into_iter().find(|s| *s != Stop::Height).map_or((Stopped::Region, None), named)
    }

    fn not_one_turn(&self, stop: (Stopped, Option<Point>)) -> Error {
        let (by, at) = stop;
        let since = rings::not_one_turn(self.options, by, at.map(|p| spot(self.blade, &p)));
        let reason = end_reason(self.blade, stop, self.options);
        Error::infeasible(Stage::Path, format!("not one whole turn fits: {reason}"), since)
            .advise(rings::no_turn_advice(by == Stopped::BallTooLarge))
    }

    /// Balls at even places of a closed polyline.
    fn even(&self, line: &[Touch], length_mm: f64, step_mm: f64) -> Vec<Touch> {
        let n = line.len();
        let s_mm = curve::arc_lengths((0..=n).map(|i| &line[i % n].centre));
        let count = (length_mm / step_mm).ceil().max(12.0) as usize;
        (0..count)
            .into_par_iter()
            .filter_map(|k| {
                let s = s_mm[n] * k as f64 / count as f64;
                let i = s_mm.partition_point(|x| *x <= s).clamp(1, n) - 1;
                let (a, b) = (line[i].centre, line[(i + 1) % n].centre);
                let share = (s - s_mm[i]) / (s_mm[i + 1] - s_mm[i]).max(1e-300);
                self.level.touch(&(a + (b - a) * share), self.cell_mm)
            })
            .collect()
    }

    /// φ at the vertices.
    fn solved(&self, net: &Net, end: &Curve) -> Result<Vec<f64>> {
        let (level, scallop_mm) = (self.level, self.options.settings.scallop_mm);
        let over_facets = level.is_over_facets();
        let forms = if over_facets { eikonal::forms(net, self.average_mm()) } else { Vec::new() };
        self.progress(500)?;
        let beside = net.beside(&end.touches, 3);
        let given: Vec<Option<f64>> = (0..net.touches.len())
            .into_par_iter()
            .map(|v| {
                if !beside[v] {
                    return (!net.within[v]).then_some(f64::INFINITY);
                }
                let t = &net.touches[v];
                let foot = end.foot(&t.centre)?;
                let off_mm = (foot - t.centre).norm();
                if !net.within[v] {
                    // Beyond the end lines of low values close round the vertices within.
                    return Some(if off_mm < 2.0 * self.cell_mm { -0.5 } else { f64::INFINITY });
                }
                if off_mm > BESIDE_END * self.cell_mm {
                    return None;
                }
                let way = t.centre - foot;
                if over_facets {
                    return Some((way.dot(&(forms[v] * way))).max(0.0).sqrt() / self.flat_mm);
                }
                let foot = level.touch(&foot, 0.1 * level.radius_mm)?;
                let share = eikonal::share_of_scallop(level, &t.centre, &foot.centre, scallop_mm);
                Some(share.unwrap_or_else(|| eikonal::stepovers(level, t, &foot, self.flat_mm, scallop_mm)))
            })
            .collect();
        let phi = if over_facets {
            eikonal::solve(net, &given, |a, b| eikonal::stepovers_by_form(net, &forms, [a, b], self.flat_mm))
        } else {
            eikonal::solve(net, &given, |a, b| {
                let [a, b] = [a, b].map(|v| &net.touches[v as usize]);
                eikonal::stepovers(level, a, b, self.flat_mm, scallop_mm)
            })
        };
        self.progress(600)?;
        Ok(phi)
    }

    /// Reach over which the ways of contacts are averaged over facets, mm.
    fn average_mm(&self) -> f64 {
        (AVERAGE[0] * self.facet_mm()).clamp(AVERAGE[1] * self.cell_mm, AVERAGE[2] * self.cell_mm)
    }

    /// About the length of an edge of a facet, mm.
    fn facet_mm(&self) -> f64 {
        let mesh = &self.blade.part.mesh;
        let area_mm2 = |t: usize| {
            let [a, b, c] = mesh.corners(t);
            0.5 * (b - a).cross(&(c - a)).norm()
        };
        let count = mesh.triangles.len();
        (2.0 * (0..count).map(area_mm2).sum::<f64>() / count.max(1) as f64).sqrt()
    }

    /// The path of turns that leave a scallop.
    fn turns(
        &self,
        net: &Net,
        end: &Curve,
        phi: &[f64],
        aim_mm: f64,
        within: &(impl Fn(&Touch) -> bool + Sync),
        how: &End,
    ) -> Result<Toolpath> {
        let facets = usize::from(self.level.is_over_facets());
        let flat_mm = flat_stepover_mm(self.options.radius_mm, aim_mm);
        let scaled = phi.iter().map(|p| if *p > 0.0 { p * self.flat_mm / flat_mm } else { *p }).collect();
        let field = Field::new(self.level, net, scaled, end, REACH[facets], aim_mm);
        let step_mm = (STEP[0] * flat_mm).min(STEP[1] * self.options.radius_mm).min(self.options.settings.max_step_mm);
        let border = |e: Edge| net.border(self.level, e, within)[0];
        let reader = Reader { field: &field, flat_mm, step_mm, border: &border, within };
        let none = |at: Option<Point>| self.not_one_turn((Stopped::NoNearer, at));
        let to_faces = !self.options.extent.start_faces().is_empty();
        let mut last = Turn::of_end(self.first_turn(&field, step_mm)).ok_or_else(|| none(None))?;
        let mut turns = vec![last.touches()];
        loop {
            let turn = reader.next(&last).ok_or_else(|| none(last.curve.touches.last().map(|t| t.centre)))?;
            let touches = turn.touches();
            let is_over = |(t, waits): (&Touch, &bool)| *waits || !to_faces && self.height_mm(t) >= self.start_x;
            // The first node of a turn is the last of the one before.
            let enough = touches.iter().zip(&turn.waits).skip(1).all(is_over);
            turns.push(touches);
            last = turn;
            self.progress(600 + (400 * turns.len() / (turns.len() + 50)))?;
            if enough {
                break;
            }
            if turns.len() > MOST_TURNS {
                let since = Infeasible::TooManyTurns { most: MOST_TURNS, scallop_mm: aim_mm };
                return Err(Error::infeasible(
                    Stage::Path,
                    format!("more than {MOST_TURNS} turns would be needed"),
                    since,
                )
                .advise("allow a larger scallop or a smaller region"));
            }
        }
        let reversed: Vec<Vec<Touch>> = turns.into_iter().rev().map(|t| t.into_iter().rev().collect()).collect();
        let reason = end_reason(self.blade, how.stop, self.options);
        finish(self.level, self.options, &reversed, reason, self.observer)
    }

    /// The turn along the end, from where the way down from the ring's base point comes to it.
    fn first_turn(&self, field: &Field, step_mm: f64) -> Vec<Touch> {
        let mut base = self.ring.touches[0];
        while let Some((value, _)) = field.at(&base).filter(|v| v.0 > 0.6) {
            match field.onto(base, value - 0.5) {
                Some(t) if self.height_mm(&t) < self.height_mm(&base) + self.flat_mm && t.centre != base.centre => {
                    base = t;
                }
                _ => break,
            }
        }
        let end = &field.end.touches;
        let s_mm = curve::arc_lengths((0..=end.len()).map(|i| &end[i % end.len()].centre));
        let mut turn = self.even(end, s_mm[end.len()], step_mm);
        let nearest = Curve::new(turn.clone(), true).nearest(&base.centre).map_or(0, |p| p.number);
        turn.rotate_left(nearest);
        turn
    }
}

fn mean(values: impl Iterator<Item = f64>) -> f64 {
    let (sum, count) = values.fold((0.0, 0.0), |(s, n), v| (s + v, n + 1.0));
    sum / f64::max(count, 1.0)
}
