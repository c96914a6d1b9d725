//! The frame in which the balls touch the part best, from a first guess: Levenberg and Marquardt's
//! method on the rigid motions, with Huber's weights (P. J. Huber, *Robust Estimation of a Location
//! Parameter*, 1964).

use super::field::Field;
use super::places::{FeedEnd, Lay, Reaction};
use crate::geometry::{Point, Rigid, Vector};
use crate::parallel;

/// Unknowns: a shift, a turn (times the part's size, so that all are lengths), the ball's radius.
pub(super) const UNKNOWNS: usize = 7;
/// Changes of all unknowns, mm.
pub(super) type Change = nalgebra::SVector<f64, UNKNOWNS>;
pub(super) type Normal = nalgebra::SMatrix<f64, UNKNOWNS, UNKNOWNS>;

/// More places than these are shared among threads.
const SHARED: usize = 600;
/// Lengths below which a step changes nothing, mm.
const NOTHING_MM: f64 = 1e-8;

/// What is to be solved.
#[derive(Clone, Copy)]
pub(super) struct Task<'a> {
    pub field: &'a dyn Field,
    pub places: &'a [FeedEnd],
    /// Stock that the balls leave, mm.
    pub stock_mm: f64,
    /// Which unknowns are free.
    pub free: [bool; UNKNOWNS],
    /// Size of the part, mm.
    pub size_mm: f64,
    /// From here on a residual weighs less, mm.
    pub huber_mm: f64,
    /// From here on it is left out, mm.
    pub most_mm: f64,
}

/// How far a ball is off the part, and by what that changes.
#[derive(Clone, Copy)]
pub(super) struct Residual {
    /// Distance of the centre less radius and stock, mm.
    pub off_mm: f64,
    pub slope: Change,
}

impl Task<'_> {
    /// The residual at a place; `None` where there is no distance.
    fn residual(&self, place: &FeedEnd, at: &Reaction, lay: &Lay, pivot: &Vector) -> Option<Residual> {
        let (distance_mm, gradient) = self.field.at(&at.centre)?;
        let off_mm = distance_mm - place.radius_mm - lay.grown_mm - self.stock_mm;
        let by_shift = at.map.tr_mul(&gradient);
        let by_turn = (at.arm - pivot).cross(&by_shift) / self.size_mm;
        let by_radius = gradient.dot(&at.by_radius) - 1.0;
        let mut slope = Change::zeros();
        slope.fixed_rows_mut::<3>(0).copy_from(&by_shift);
        slope.fixed_rows_mut::<3>(3).copy_from(&by_turn);
        slope[6] = by_radius;
        slope.iter_mut().zip(self.free).filter(|f| !f.1).for_each(|(s, _)| *s = 0.0);
        off_mm.is_finite().then_some(Residual { off_mm, slope })
    }

    /// Residuals in the order of the places.
    pub fn residuals(&self, lay: &Lay) -> Vec<Option<Residual>> {
        let all: Vec<(&FeedEnd, Reaction)> = self.places.iter().map(|p| (p, p.reaction(lay))).collect();
        let pivot = self.middle(all.iter().map(|(_, at)| at.arm));
        let one = |(p, at): &(&FeedEnd, Reaction)| self.residual(p, at, lay, &pivot);
        match all.len() > SHARED {
            true => parallel::map(&all, one),
            false => all.iter().map(one).collect(),
        }
    }

    /// What turns are about: the middle of the places, before `map`.
    pub fn pivot(&self, lay: &Lay) -> Vector {
        self.middle(self.places.iter().map(|p| p.arm(lay)))
    }

    fn middle(&self, arms: impl Iterator<Item = Vector>) -> Vector {
        arms.sum::<Vector>() / self.places.len().max(1) as f64
    }

    /// Cost of a residual, mm², and its weight.
    fn robust(&self, off_mm: f64) -> (f64, f64) {
        let (a, h) = (off_mm.abs(), self.huber_mm);
        let cost = |a: f64| if a <= h { 0.5 * a * a } else { h * (a - 0.5 * h) };
        match a > self.most_mm {
            true => (cost(self.most_mm), 0.0),
            false => (cost(a), if a <= h { 1.0 } else { h / a }),
        }
    }

    /// Mean cost of residuals, mm².
    fn cost(&self, residuals: &[Option<Residual>]) -> f64 {
        let worst = self.robust(f64::MAX.sqrt()).0;
        let sum: f64 = residuals.iter().map(|r| r.map_or(worst, |r| self.robust(r.off_mm).0)).sum();
        sum / residuals.len().max(1) as f64
    }

    /// Mean cost of a lay, mm².
    pub fn cost_at(&self, lay: &Lay) -> f64 {
        self.cost(&self.residuals(lay))
    }

    /// Mean cost of a share of the places, the nearest, mm².
    pub fn nearest_cost(&self, lay: &Lay, share: f64) -> f64 {
        let residuals = self.residuals(lay);
        let cost = |r: &Option<Residual>| r.map_or(f64::INFINITY, |r| self.robust(r.off_mm).0);
        let mut costs: Vec<f64> = residuals.iter().map(cost).collect();
        costs.sort_by(f64::total_cmp);
        costs.truncate(((costs.len() as f64 * share) as usize).max(1));
        costs.iter().sum::<f64>() / costs.len().max(1) as f64
    }

    /// Mean of `slope slopeᵀ` and of `slope · residual`, by weight.
    pub fn normal(&self, residuals: &[Option<Residual>]) -> (Normal, Change) {
        let (mut normal, mut right) = (Normal::zeros(), Change::zeros());
        for r in residuals.iter().flatten() {
            let weight = self.robust(r.off_mm).1;
            if weight > 0.0 {
                normal.ger(weight, &r.slope, &r.slope, 1.0);
                right.axpy(weight * r.off_mm, &r.slope, 1.0);
            }
        }
        let count = residuals.len().max(1) as f64;
        (normal / count, right / count)
    }

    /// Mean square of residuals, by weight, mm².
    pub fn mean_square_mm2(&self, residuals: &[Option<Residual>]) -> f64 {
        let square = |r: &Residual| self.robust(r.off_mm).1 * r.off_mm * r.off_mm;
        residuals.iter().flatten().map(square).sum::<f64>() / residuals.len().max(1) as f64
    }

    /// Goes down from a guess: where it ends, and the cost there, mm².
    pub fn descend(&self, from: &Lay, steps: usize) -> (Lay, f64) {
        let (mut lay, mut damping) = (*from, 1e-3);
        let mut residuals = self.residuals(&lay);
        let mut cost = self.cost(&residuals);
        for _ in 0..steps {
            let (normal, right) = self.normal(&residuals);
            let mut moved = false;
            for _ in 0..4 {
                let Some(change) = step(&normal, &right, damping) else { break };
                let next = self.changed(&lay, &change);
                let there = self.residuals(&next);
                let cost_there = self.cost(&there);
                if cost_there < cost {
                    moved = change.norm() > NOTHING_MM;
                    (lay, residuals, cost) = (next, there, cost_there);
                    damping = (damping * 0.2).max(1e-9);
                    break;
                }
                damping *= 8.0;
            }
            if !moved {
                break;
            }
        }
        (lay, cost)
    }

    /// The lay after a change.
    pub fn changed(&self, lay: &Lay, change: &Change) -> Lay {
        let shift = Vector::new(change[0], change[1], change[2]);
        let turn = Rigid::rotation(Vector::new(change[3], change[4], change[5]) / self.size_mm);
        let pivot = self.pivot(lay);
        let about = Rigid::translation(pivot.x, pivot.y, pivot.z);
        let mut frame = Rigid::translation(shift.x, shift.y, shift.z) * about * turn * about.inverse() * lay.frame;
        frame.rotation.renormalize_fast();
        Lay { frame, grown_mm: lay.grown_mm + change[6], ..*lay }
    }
}

/// `−(A + λ diag A)⁻¹ g`; `None` where that is none.
fn step(normal: &Normal, right: &Change, damping: f64) -> Option<Change> {
    let mut damped = *normal;
    let floor = 1e-12 + 1e-9 * normal.trace();
    for i in 0..UNKNOWNS {
        // What is not free has neither slope nor diagonal, and stays.
        damped[(i, i)] += damping * normal[(i, i)] + damping * floor + if normal[(i, i)] == 0.0 { 1.0 } else { 0.0 };
    }
    let change = -damped.cholesky()?.solve(right);
    change.iter().all(|v| v.is_finite()).then_some(change)
}

/// Where places have their centres in a lay, to be compared with those in others.
pub(super) struct Centres {
    all: Vec<Point>,
    middle: Vector,
}

impl Centres {
    pub fn of(places: &[FeedEnd], lay: &Lay) -> Self {
        let all: Vec<Point> = places.iter().map(|p| p.centre(lay)).collect();
        let middle = all.iter().map(|p| p.coords).sum::<Vector>() / all.len().max(1) as f64;
        Centres { all, middle }
    }

    /// Whether the root mean square of how far the centres are apart is greater than `mm`.
    pub fn apart(&self, other: &Self, mm: f64) -> bool {
        // Their middles are no farther apart than that.
        if (self.middle - other.middle).norm_squared() > mm * mm {
            return true;
        }
        let most = mm * mm * self.all.len() as f64;
        let mut sum = 0.0;
        self.all.iter().zip(&other.all).any(|(a, b)| {
            sum += (a - b).norm_squared();
            sum > most
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    proptest! {
        #[test]
        fn lays_are_apart_by_the_root_of_the_mean_square(
            points in prop::collection::vec([-3.0..3.0f64, -3.0..3.0, -3.0..3.0], 1..20),
            moved in prop::collection::vec([-1.0..1.0f64, -1.0..1.0, -1.0..1.0], 20), shift in -1.0..1.0f64, mm in 0.0..2.0f64,
        ) {
            let of = |all: Vec<Point>| {
                let middle = all.iter().map(|p| p.coords).sum::<Vector>() / all.len() as f64;
                Centres { all, middle }
            };
            let here: Vec<Point> = points.into_iter().map(Point::from).collect();
            let by = moved.into_iter().map(|m| Vector::from(m) + Vector::x() * shift);
            let there: Vec<Point> = here.iter().zip(by).map(|(p, m)| p + m).collect();
            let sum: f64 = here.iter().zip(&there).map(|(a, b)| (a - b).norm_squared()).sum();
            let rms = (sum / here.len() as f64).sqrt();
            prop_assume!((rms - mm).abs() > 1e-9);
            prop_assert_eq!(of(here).apart(&of(there), mm), rms > mm);
        }
    }
}
