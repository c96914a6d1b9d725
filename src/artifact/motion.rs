//! What the tool does from row to row: the one answer for feed, programs, previews and checks.

use super::plan::{Row, Stretch};
use super::programmed::Polynomial;
use super::schedule::ScheduleKind;
use super::{AxisRows, Plan, ProgrammedCurve, Schedule, Stand, Toolpath};
use crate::numerics::spline::{CubicSpline, SplineEnds, SplineError};

impl Schedule {
    /// At a share of the straight move from a row to the next: an offset that stays does so between
    /// rows too, else θ turns evenly.
    pub fn between(&self, from: &Stand, to: &Stand, share: f64) -> Stand {
        match self.kind {
            ScheduleKind::Eccentric => from.towards_at_offset(to, share),
            _ => from.towards(to, share),
        }
    }

    /// By how much θ is then over that of even turning, rad.
    pub fn bent(&self, from: &Stand, to: &Stand, share: f64) -> f64 {
        match self.kind {
            ScheduleKind::Eccentric => self.between(from, to, share).theta - from.towards(to, share).theta,
            _ => 0.0,
        }
    }

    /// θ of the schedule's curve at a share of the way between two neighbouring locations, given by
    /// their numbers and arc lengths, rad; `None` where the curve does not go through the angles of
    /// both.
    pub fn theta_on_curve(&self, rows: [usize; 2], s_mm: [f64; 2], share: f64) -> Option<f64> {
        let meets = (0..2).all(|k| self.curve_meets(rows[k], s_mm[k]));
        meets.then(|| self.curve_at(s_mm[0] + (s_mm[1] - s_mm[0]) * share)).flatten()
    }
}

/// How θ goes from a location to the next.
#[derive(Clone, Copy, Debug)]
struct Turning<'a> {
    schedule: &'a Schedule,
    rows: [usize; 2],
    s_mm: [f64; 2],
}

impl Turning<'_> {
    /// θ of the schedule's curve at a share of the way, rad, where the curve goes through the
    /// angles of both locations.
    fn at(&self, share: f64) -> Option<f64> {
        self.schedule.theta_on_curve(self.rows, self.s_mm, share)
    }

    /// The first joint of two pieces of the curve strictly between two shares of the way.
    fn joint_between(&self, from: f64, to: f64) -> Option<f64> {
        self.at(0.0)?;
        let [s, s1] = self.s_mm;
        let (low, high) = (s + (s1 - s) * from, s + (s1 - s) * to);
        let pieces = &self.schedule.pieces;
        let joint = pieces.get(pieces.partition_point(|p| p[3][0] <= low)).map(|p| p[3][0]);
        joint.filter(|j| *j < high).map(|j| (j - s) / (s1 - s))
    }
}

/// The motion of the tool over lead-in, path and lead-out, row by row.
///
/// Between two rows the ball centre moves straight. θ turns evenly on what is written as straight
/// moves, or as an offset that stays asks for ([`Motion::straight`]); where a control takes
/// polynomials it follows the schedule's curve ([`Motion::curved`]). No machine follows the corners
/// between straight moves: what its axes do is taken to be [`smooth`], which meets both at the
/// rows. A plan with a programmed curve goes on that, ball centre and θ ([`Motion::curved`]);
/// straight moves are its chords.
#[derive(Clone, Debug)]
pub struct Motion<'a> {
    rows: Vec<Row>,
    toolpath: &'a Toolpath,
    schedule: &'a Schedule,
    programmed: Option<&'a ProgrammedCurve>,
    /// Rows before the first location.
    before: usize,
}

impl<'a> Motion<'a> {
    /// That of a plan. Ends with the shortest list of each part where their lengths differ.
    pub fn of(plan: &'a Plan) -> Self {
        let rows = plan.rows().collect();
        let before = plan.leads[0].centres.len();
        let programmed = plan.curve.as_ref();
        Motion { rows, toolpath: &plan.toolpath, schedule: &plan.schedule, programmed, before }
    }

    /// All rows, in order of time.
    pub fn rows(&self) -> &[Row] {
        &self.rows
    }

    /// On the straight move from a row to the next; beyond the last row, there.
    pub fn straight(&self, row: usize, share: f64) -> Option<Stand> {
        let from = self.rows.get(row)?.stand;
        Some(self.rows.get(row + 1).map_or(from, |to| self.schedule.between(&from, &to.stand, share)))
    }

    /// By how much θ on the straight move from a row to the next is over that of even turning,
    /// rad.
    pub fn bent(&self, row: usize, share: f64) -> f64 {
        let ends = self.rows.get(row).zip(self.rows.get(row + 1));
        ends.map_or(0.0, |(a, b)| self.schedule.bent(&a.stand, &b.stand, share))
    }

    /// The polynomial from a row to the next; `None` where the way is straight.
    pub fn polynomial(&self, row: usize) -> Option<Polynomial> {
        let location = row.checked_sub(self.before)?;
        self.programmed?.polynomial(self.toolpath, &self.schedule.theta, location)
    }

    /// Where the plan's curve goes, a share of its parameter on from a row to the next. Without
    /// one, or where it leaves the path as it is: as [`Motion::straight`], θ on the schedule's
    /// curve where there is one through both rows.
    pub fn curved(&self, row: usize, share: f64) -> Option<Stand> {
        let straight = self.straight(row, share)?;
        if let Some(polynomial) = self.polynomial(row) {
            let at = polynomial.at(share);
            return Some(Stand { centre: at.point(), theta: at.theta[0], ..straight });
        }
        let theta = self.turning(row).and_then(|t| t.at(share)).unwrap_or(straight.theta);
        Some(Stand { theta, ..straight })
    }

    /// The first joint of two pieces of the schedule's curve strictly between two shares of the way
    /// from a row to the next.
    pub fn joint_between(&self, row: usize, from: f64, to: f64) -> Option<f64> {
        self.turning(row)?.joint_between(from, to)
    }

    /// What a place between two rows belongs to: from the last location on, the ball leaves.
    pub fn stretch_between(from: Stretch, to: Stretch) -> Stretch {
        if to == Stretch::LeadOut { to } else { from }
    }

    fn turning(&self, row: usize) -> Option<Turning<'a>> {
        let location = row.checked_sub(self.before)?;
        let rows = [location, location + 1];
        let s_mm = rows.map(|k| self.toolpath.locations.get(k).map_or(f64::NAN, |l| l.s_mm));
        let known = rows.iter().all(|k| self.schedule.theta.get(*k).is_some_and(|t| t.is_finite()));
        if !known || !s_mm.iter().all(|v| v.is_finite()) {
            return None;
        }
        Some(Turning { schedule: self.schedule, rows, s_mm })
    }
}

/// The axes of a machine over the arc length of ball centres (mm), through their positions at the
/// rows: the natural cubic spline, twice continuously differentiable, one function for each axis.
///
/// # Errors
/// Where arc lengths do not rise or a position is not finite.
pub fn smooth(s_mm: &[f64], positions: &AxisRows) -> Result<CubicSpline, SplineError> {
    CubicSpline::new(s_mm, positions.values(), positions.axes(), &SplineEnds::Natural)
}

impl Toolpath {
    /// Where the tool stands at each location with these angles, rad; without leads.
    pub fn stands(&self, theta: &[f64]) -> impl Iterator<Item = Stand> {
        let rows = self.locations.iter().zip(theta).enumerate();
        rows.map(|(k, (l, theta))| Stand { centre: l.centre, cone: self.cone(k), theta: *theta })
    }
}
