//! First guesses all over, and the ones that hold: coarse on a grid of distances, then on the mesh,
//! then on the exact faces.

use super::field::{DistanceGrid, Exact, Field, Triangles};
use super::places::{FeedEnd, FeedEnds, Lay};
use super::solve::{Centres, Change, Normal, Task, UNKNOWNS};
use crate::error::{Error, Result, Stage};
use crate::geometry::part::Part;
use crate::geometry::{Point, Rigid, Vector};
use crate::observe::Observer;
use crate::parallel;

type Matrix3 = nalgebra::Matrix3<f64>;
type Rotation = nalgebra::UnitQuaternion<f64>;

/// Turns that are spread over all of them.
const TURNS: usize = 720;
/// Slabs across the blade axis whose middles the places are laid about.
const SLABS: usize = 12;
/// Shifts beside a middle to either side, where no turn is looked for.
const BESIDE: [f64; 5] = [-0.3, -0.12, 0.0, 0.12, 0.3];
/// Places to either side of a lay to which it is swept.
const SWEEP: i32 = 60;
/// Lays that are swept and turned once more, to see whether the part is touched as well.
const CHALLENGED: usize = 4;
/// Parts of a turn by which lays are turned.
const TWELFTHS: u32 = 12;
/// Most dips of a sweep that are gone down.
const DIPS: usize = 4;
/// Share of the places that a guess is measured by, the nearest: approach and retract are off.
const MEASURED: f64 = 0.9;

/// A lay that cannot be bettered nearby.
#[derive(Clone, Copy, Debug)]
pub(super) struct Candidate {
    pub lay: Lay,
    /// Root mean square of the residuals of the nearest nine tenths of the places, mm.
    pub rms_mm: f64,
}

/// What is searched.
pub(super) struct Search<'a> {
    pub part: &'a Part,
    pub places: &'a FeedEnds,
    pub stock_mm: f64,
    /// Tips, centres, or both.
    pub words: Vec<bool>,
    pub free_radius: bool,
    pub observer: &'a dyn Observer,
}

/// How one stage of the search goes.
#[derive(Clone, Copy)]
struct Sieve<'a> {
    field: &'a dyn Field,
    places: &'a [FeedEnd],
    /// See [`Task::huber_mm`].
    huber_mm: f64,
    /// See [`Task::most_mm`].
    most_mm: f64,
    /// Steps with nothing left out, and those after them.
    rough_steps: usize,
    steps: usize,
    /// How many lays are kept.
    keep: usize,
    /// Lays nearer than this to a better one are the same, mm.
    same_mm: f64,
    /// The radius of the ball is free as well.
    free_radius: bool,
}

impl<'a> Sieve<'a> {
    /// Fifteen steps; all lays that differ at all are kept.
    fn new(field: &'a dyn Field, places: &'a [FeedEnd], huber_mm: f64, most_mm: f64) -> Self {
        let (rough_steps, steps, keep) = (0, 15, usize::MAX);
        Sieve { field, places, huber_mm, most_mm, rough_steps, steps, keep, same_mm: 0.0, free_radius: false }
    }
}

impl Search<'_> {
    /// Half the diagonal of the part's box, mm.
    pub fn size_mm(&self) -> f64 {
        self.part.mesh.aabb().map_or(1.0, |b| 0.5 * b.diagonal_mm())
    }

    /// Which unknowns are free.
    pub fn free(&self, radius: bool) -> [bool; UNKNOWNS] {
        let turns = self.places.turns;
        [true, true, true, turns, turns, turns, radius]
    }

    /// Places at which lays are compared: evenly along the way.
    pub fn probe(&self) -> Vec<FeedEnd> {
        self.places.sampled(60)
    }

    /// All lays that cannot be bettered nearby, the best first.
    ///
    /// # Errors
    /// `Usage`: the part has no surface; `Cancelled`.
    pub fn run(&self) -> Result<Vec<Candidate>> {
        let reach = self.places.all.iter().map(|p| p.radius_mm).fold(0.0, f64::max) + self.stock_mm;
        let grid = DistanceGrid::new(self.part, 1.5 * reach + 0.05 * self.size_mm())
            .ok_or_else(|| Error::usage(Stage::Verify, "the part has no surface to lay a program over"))?;
        let (exact, more) = (Exact(self.part), self.places.sampled(300));
        let mut lays = Vec::new();
        for tip in &self.words {
            lays.extend(self.roughly(&grid, *tip)?);
        }
        let mm = grid.step_mm;
        let last = Sieve { free_radius: self.free_radius, ..Sieve::new(&exact, &more, 0.01 * mm, 0.3 * mm) };
        let lays = self.sieved(&Sieve { steps: 10, keep: 12, same_mm: 0.05 * mm, ..last }, lays)?;
        let task = self.task(&exact, &more, 0.01 * mm, self.free_radius);
        let measured = |lay: Lay| Candidate { lay, rms_mm: rms_mm(&task, &lay) };
        let mut out: Vec<Candidate> = lays.into_iter().map(measured).collect();
        out.sort_by(|a, b| a.rms_mm.total_cmp(&b.rms_mm));
        Ok(out)
    }

    /// Lays on the grid and on the mesh, points being tips or centres.
    fn roughly(&self, grid: &DistanceGrid, tip: bool) -> Result<Vec<Lay>> {
        let [few, some] = [80, 300].map(|n| self.places.sampled(n));
        let (mesh, mm) = (Triangles::new(self.part), grid.step_mm);
        let fewest = self.places.sampled(30);
        let first = Sieve::new(grid, &few, 0.5 * mm, 2.0 * mm);
        // Most guesses lead nowhere, and few steps at few places tell.
        let first = Sieve { rough_steps: 4, steps: 4, keep: 160, same_mm: 0.4 * mm, ..first };
        let all = Sieve { places: &fewest, rough_steps: 4, steps: 0, keep: 2500, same_mm: 0.0, ..first };
        let on_grid = Sieve { keep: 32, same_mm: 0.2 * mm, ..Sieve::new(grid, &some, 0.15 * mm, mm) };
        let few_on_grid = Sieve { places: &few, ..on_grid };
        let on_mesh = Sieve { keep: 20, same_mm: 0.1 * mm, ..Sieve::new(&mesh, &some, 0.03 * mm, 0.5 * mm) };
        let few_on_mesh = Sieve { places: &few, ..on_mesh };
        let guesses = self.sieved(&all, self.guesses(&few, tip))?;
        let mut lays = self.sieved(&on_grid, self.sieved(&first, guesses)?)?;
        lays.extend(parallel::flat_map(&lays, |lay| self.swept(&few_on_grid, lay)));
        lays = self.sieved(&on_mesh, self.sieved(&on_grid, lays)?)?;
        // From where the mesh has led to, once more: grooves and fillets are narrower than cells.
        let other = |lay: &Lay| [self.swept(&few_on_grid, lay), self.turned(&few, lay)].concat();
        let others: Vec<Lay> = parallel::flat_map(lays.iter().take(CHALLENGED), other);
        lays.extend(self.sieved(&few_on_mesh, self.sieved(&few_on_grid, others)?)?);
        self.sieved(&Sieve { keep: 8, ..on_mesh }, lays)
    }

    /// A task on a field, nothing left out.
    pub fn task<'b>(&self, field: &'b dyn Field, places: &'b [FeedEnd], huber_mm: f64, radius: bool) -> Task<'b> {
        let (free, size_mm) = (self.free(radius), self.size_mm());
        Task { field, places, stock_mm: self.stock_mm, free, size_mm, huber_mm, most_mm: f64::INFINITY }
    }

    /// Goes down from each of some lays; the best of those that differ.
    fn sieved(&self, sieve: &Sieve, lays: Vec<Lay>) -> Result<Vec<Lay>> {
        self.observer.check(Stage::Verify)?;
        let rough = self.task(sieve.field, sieve.places, sieve.huber_mm, sieve.free_radius);
        let task = Task { most_mm: sieve.most_mm, ..rough };
        let down = |lay: Lay| {
            let (lay, _) = task.descend(&rough.descend(&lay, sieve.rough_steps).0, sieve.steps);
            (lay, task.nearest_cost(&lay, MEASURED))
        };
        let mut ended: Vec<(Lay, f64)> = parallel::map(lays, down);
        ended.retain(|e| e.1.is_finite());
        ended.sort_by(|a, b| a.1.total_cmp(&b.1));
        let probe = self.probe();
        let mut out: Vec<(Lay, Centres)> = Vec::new();
        for (lay, _) in ended {
            if out.len() >= sieve.keep {
                break;
            }
            let centres = Centres::of(&probe, &lay);
            if out.iter().all(|(kept, there)| kept.tip != lay.tip || there.apart(&centres, sieve.same_mm)) {
                out.push((lay, centres));
            }
        }
        Ok(out.into_iter().map(|(lay, _)| lay).collect())
    }

    /// The lay moved along a valley to where it fits better again: along the blade axis, about it,
    /// and in the direction that is determined least. Walls that are drawn along an axis let a
    /// program slide, and say nothing of which way.
    fn swept(&self, sieve: &Sieve, lay: &Lay) -> Vec<Lay> {
        let mut task = self.task(sieve.field, sieve.places, sieve.huber_mm, false);
        task.most_mm = sieve.most_mm;
        let (normal, _) = task.normal(&task.residuals(lay));
        let (size, most) = (2.0 * self.size_mm(), std::f64::consts::PI * self.size_mm());
        let mut ways: Vec<(Change, f64)> = vec![(weakest(&normal, &task.free), 0.5 * size)];
        if self.places.in_axes {
            ways.extend((0..3).map(|k| (unit(k), 0.5 * size)));
        } else {
            ways.push((unit(0), size));
        }
        if self.places.turns {
            ways.push((unit(3), most));
        }
        let mut out = Vec::new();
        for (way, reach) in ways {
            let at = |k: i32| task.changed(lay, &(way * (reach * f64::from(k) / f64::from(SWEEP))));
            let tried: Vec<(Lay, f64)> = (-SWEEP..=SWEEP).map(at).map(|lay| (lay, task.cost_at(&lay))).collect();
            // That in the middle is the lay itself.
            let is_dip = |(k, w): &(usize, &[(Lay, f64)])| {
                w[1].1 < w[0].1 && w[1].1 <= w[2].1 && k.abs_diff(SWEEP as usize - 1) > 1
            };
            let mut dips: Vec<&(Lay, f64)> = tried.windows(3).enumerate().filter(is_dip).map(|(_, w)| &w[1]).collect();
            dips.sort_by(|a, b| a.1.total_cmp(&b.1));
            out.extend(dips.into_iter().take(DIPS).map(|d| d.0));
        }
        out
    }

    /// The lay turned about its own axes and those of the blade: how a part that is symmetric, or
    /// nearly so, is touched as well.
    fn turned(&self, places: &[FeedEnd], lay: &Lay) -> Vec<Lay> {
        if !self.places.turns {
            return Vec::new();
        }
        let points: Vec<(Point, f64)> = places.iter().map(|p| (p.centre(lay), 1.0)).collect();
        let Some((middle, scatter)) = moments(&points) else { return Vec::new() };
        let own = axes_of(&scatter);
        let units = [Vector::x(), Vector::y(), Vector::z()];
        let axes = units.into_iter().chain(units.into_iter().map(|u| own * u));
        let about = |pivot: Point| {
            let (there, back) = (Rigid::from_parts(pivot.coords.into(), Rotation::identity()), -pivot.coords);
            let back = Rigid::from_parts(back.into(), Rotation::identity());
            axes.clone().flat_map(move |axis| {
                (1..TWELFTHS).map(move |k| {
                    let angle = std::f64::consts::TAU * f64::from(k) / f64::from(TWELFTHS);
                    Lay { frame: there * Rigid::rotation(axis * angle) * back * lay.frame, ..*lay }
                })
            })
        };
        about(middle).chain(about(Point::origin())).collect()
    }

    /// First guesses: the middle of the places on middles of the part, turned in all ways.
    fn guesses(&self, places: &[FeedEnd], tip: bool) -> Vec<Lay> {
        let at = |turn: Rotation, to: &Point, beside: Vector| laid(places, tip, turn, to, beside);
        let middles = middles(self.part);
        if !self.places.turns {
            let size = 2.0 * self.size_mm();
            let around = || {
                BESIDE.into_iter().flat_map(|x| {
                    BESIDE.into_iter().flat_map(move |y| BESIDE.into_iter().map(move |z| Vector::new(x, y, z)))
                })
            };
            let guess =
                |m: &(Point, Matrix3)| around().map(|b| at(Rotation::identity(), &m.0, b * size)).collect::<Vec<_>>();
            return middles.iter().flat_map(guess).collect();
        }
        let spread: Vec<Rotation> = turns(TURNS).chain(quarters()).collect();
        let own = axes_of(&scatter_of(places, tip));
        let guess = |(middle, scatter): &(Point, Matrix3)| {
            let section = axes_of(scatter);
            let aligned = quarters().map(move |q| section * q * own.inverse());
            spread.iter().copied().chain(aligned).map(|turn| at(turn, middle, Vector::zeros())).collect::<Vec<_>>()
        };
        middles.iter().flat_map(guess).collect()
    }
}

/// A change of one unknown.
fn unit(k: usize) -> Change {
    Change::from_fn(|i, _| if i == k { 1.0 } else { 0.0 })
}

/// The direction that is determined least.
fn weakest(normal: &Normal, free: &[bool; UNKNOWNS]) -> Change {
    let mut held = *normal;
    let most = normal.trace().max(1e-9);
    (0..UNKNOWNS).filter(|k| !free[*k]).for_each(|k| held[(k, k)] = most);
    let found = held.symmetric_eigen();
    found.eigenvectors.column(found.eigenvalues.imin()).into_owned()
}

/// Root mean square of the residuals of the nearest places, mm.
pub(super) fn rms_mm(task: &Task, lay: &Lay) -> f64 {
    let mut squares: Vec<f64> =
        task.residuals(lay).iter().map(|r| r.map_or(f64::INFINITY, |r| r.off_mm * r.off_mm)).collect();
    squares.sort_by(f64::total_cmp);
    squares.truncate(((squares.len() as f64 * MEASURED) as usize).max(1));
    (squares.iter().sum::<f64>() / squares.len().max(1) as f64).sqrt()
}

/// The frame with a turn in which the places are about a point, as near as least squares bring them
/// there, and shifted.
fn laid(places: &[FeedEnd], tip: bool, turn: Rotation, to: &Point, beside: Vector) -> Lay {
    let lay = Lay { frame: Rigid::from_parts(Vector::zeros().into(), turn), tip, grown_mm: 0.0 };
    let (mut normal, mut right) = (Matrix3::zeros(), Vector::zeros());
    for place in places {
        let at = place.reaction(&lay);
        normal += at.map.transpose() * at.map;
        right += at.map.transpose() * (to - at.centre);
    }
    // A turning table can leave a direction free: a little weight keeps the shift there small.
    normal += Matrix3::identity() * (1e-6 * normal.trace() + 1e-9);
    let shift = normal.try_inverse().map_or(Vector::zeros(), |inverse| inverse * right) + beside;
    Lay { frame: Rigid::from_parts(shift.into(), turn), ..lay }
}

/// Middle and scatter of the part's surface: of all of it, and of slabs across the blade axis.
fn middles(part: &Part) -> Vec<(Point, Matrix3)> {
    let Some(aabb) = part.mesh.aabb() else { return Vec::new() };
    let (low, height) = (aabb.min.x, (aabb.max.x - aabb.min.x).max(1e-9));
    let mut slabs = vec![Vec::new(); SLABS + 1];
    for t in 0..part.mesh.triangles.len() {
        let [a, b, c] = part.mesh.corners(t);
        let middle = Point::from((a.coords + b.coords + c.coords) / 3.0);
        let area = part.mesh.triangle_area_mm2(t);
        // A triangle counts in every slab that it reaches into: those of ruled walls are long.
        let ends = [a.x.min(b.x).min(c.x), a.x.max(b.x).max(c.x)];
        let [first, last] = ends.map(|x| ((((x - low) / height) * SLABS as f64) as usize).min(SLABS - 1));
        let share = area / (last - first + 1) as f64;
        for slab in slabs.iter_mut().take(last + 1).skip(first) {
            slab.push((middle, share));
        }
        if let Some(whole) = slabs.last_mut() {
            whole.push((middle, area));
        }
    }
    let all = slabs.iter().enumerate().filter_map(|(k, slab)| {
        let (mut middle, scatter) = moments(slab)?;
        if k < SLABS {
            middle.x = low + (k as f64 + 0.5) * height / SLABS as f64;
        }
        Some((middle, scatter))
    });
    all.collect()
}

/// Mean of weighted points, and their scatter about it.
fn moments(points: &[(Point, f64)]) -> Option<(Point, Matrix3)> {
    let weight: f64 = points.iter().map(|p| p.1).sum();
    if !(weight > 0.0) {
        return None;
    }
    let mean = points.iter().map(|(p, w)| p.coords * *w).sum::<Vector>() / weight;
    let scatter = points.iter().map(|(p, w)| (p.coords - mean) * (p.coords - mean).transpose() * *w).sum::<Matrix3>();
    Some((Point::from(mean), scatter / weight))
}

fn scatter_of(places: &[FeedEnd], tip: bool) -> Matrix3 {
    let lay = Lay { frame: Rigid::identity(), tip, grown_mm: 0.0 };
    let points: Vec<(Point, f64)> = places.iter().map(|p| (p.centre(&lay), 1.0)).collect();
    moments(&points).map_or(Matrix3::identity(), |m| m.1)
}

/// The principal axes of a scatter as a turn: columns in the order of their extent.
fn axes_of(scatter: &Matrix3) -> Rotation {
    let found = scatter.symmetric_eigen();
    let mut order = [0usize, 1, 2];
    order.sort_by(|a, b| found.eigenvalues[*b].total_cmp(&found.eigenvalues[*a]));
    let [a, b] = [order[0], order[1]].map(|k| found.eigenvectors.column(k).into_owned());
    let matrix = Matrix3::from_columns(&[a, b, a.cross(&b)]);
    Rotation::from_rotation_matrix(&nalgebra::Rotation3::from_matrix_unchecked(matrix))
}

/// The 24 turns that bring the axes onto one another.
pub(super) fn quarters() -> impl Iterator<Item = Rotation> + Clone {
    let units = [Vector::x(), -Vector::x(), Vector::y(), -Vector::y(), Vector::z(), -Vector::z()];
    units.into_iter().flat_map(move |a| {
        units.into_iter().filter(move |b| a.dot(b) == 0.0).map(move |b| {
            let matrix = Matrix3::from_columns(&[a, b, a.cross(&b)]);
            Rotation::from_rotation_matrix(&nalgebra::Rotation3::from_matrix_unchecked(matrix))
        })
    })
}

/// Turns spread evenly over all of them (M. Alexa, *Super-Fibonacci Spirals: Fast, Low-Discrepancy
/// Sampling of SO(3)*, 2022).
pub(super) fn turns(count: usize) -> impl Iterator<Item = Rotation> + Clone {
    const PSI: f64 = 1.533_751_168_755_204_3;
    (0..count).map(move |k| {
        let s = k as f64 + 0.5;
        let t = s / count as f64;
        let (r, q) = (t.sqrt(), (1.0 - t).sqrt());
        let (a, b) = (std::f64::consts::TAU * s / std::f64::consts::SQRT_2, std::f64::consts::TAU * s / PSI);
        Rotation::from_quaternion(nalgebra::Quaternion::new(q * b.cos(), r * a.sin(), r * a.cos(), q * b.sin()))
    })
}
