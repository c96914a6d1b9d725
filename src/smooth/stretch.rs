//! One stretch of a path: a curve from its first location to its last.

use super::form;
use super::prove::{self, Proof};
use super::room::TubeRoom;
use super::start;
use super::tube::{self, Cells, Tube};
use super::turn::{Turned, TurningFit};
use super::{Aim, Objective, SmoothOptions, fewest};
use crate::artifact::curve::{CurveProof, CurveStretch};
use crate::artifact::toolpath::CutterLocation;
use crate::geometry::Vector;
use crate::geometry::allowance::Allowed;
use crate::numerics::bounded::{self, Enough, Missed, Solution};
use crate::numerics::quintic::{Breaks, CONDITION, weighed};

/// The first fit may miss the locations along the normal by this share of the room.
const FIT: f64 = 0.5;
/// Weight of evenness in the fit that decides on the breaks, and in that which the search begins
/// with; against distances over the room.
const EVEN: [f64; 2] = [10.0, 1e3];
/// A third derivative that is nothing, 1/mm²: at 100 mm/s a jerk of 10 mm/s³.
const NOTHING: f64 = 1e-5;
/// Rounds in which breaks are added.
const ROUNDS: usize = 6;
/// Corrections between two looks at the part, at most.
const LOOKS: usize = 2;
/// Breaks over locations, at most: beyond this nothing is gained.
const MOST_BREAKS: usize = 3;

/// A stretch of a path with all that belongs to it, one entry per location.
pub(super) struct SmoothStretch<'a> {
    pub part: &'a Allowed<'a>,
    pub radius_mm: f64,
    pub locations: &'a [CutterLocation],
    /// The room inside the tube.
    pub room: &'a [TubeRoom],
    pub turning: TurningFit,
    pub options: &'a SmoothOptions,
    pub objective: &'a Objective<'a>,
}

/// Places that have no curve: arc lengths from and to, mm.
pub(super) type Broken = Vec<[f64; 2]>;

impl SmoothStretch<'_> {
    /// The curve, or where there is none. `None` where arc lengths do not rise or numbers are not
    /// finite. `like`: breaks on which there is one in a wider tube.
    pub fn smooth(&self, like: Option<&Breaks>) -> Option<Result<CurveStretch, Broken>> {
        let is_few = self.options.aim == Aim::Fewest;
        let few = if is_few { self.few_breaks(like) } else { None };
        let mut breaks = few.or_else(|| self.first_breaks())?;
        let mut broken = Broken::new();
        for _ in 0..ROUNDS {
            let marks = match self.attempt(&breaks) {
                Some(Ok(found)) => return Some(Ok(found)),
                Some(Err(marks)) => marks,
                // What was marked before was halved beyond what numbers can hold.
                None if !broken.is_empty() => break,
                None => return None,
            };
            let beside = usize::from(!is_few);
            let marked = |i: usize| marks[i.saturating_sub(beside)..(i + beside + 1).min(marks.len())].contains(&true);
            let named: Broken = (0..marks.len()).filter(|i| marks[*i]).map(|i| breaks.span(i)).collect();
            // What is named again and again stays; on very short spans others are named with it.
            let is_still = |[a, b]: &[f64; 2]| broken.iter().any(|[p, q]: &[f64; 2]| a < q && p < b);
            let still: Broken = named.iter().copied().filter(is_still).collect();
            broken = if still.is_empty() { named } else { still };
            if breaks.spans() > MOST_BREAKS * self.locations.len() {
                break;
            }
            let Some(finer) = start::halved(&breaks, marked) else { break };
            breaks = finer;
        }
        Some(Err(broken))
    }

    /// Breaks so near to one another that a fit meets the locations along the normal.
    fn first_breaks(&self) -> Option<Breaks> {
        let mut breaks = start::breaks(self.locations)?;
        for _ in 0..ROUNDS {
            let x = start::fit(self.locations, &breaks, self.allowed(), EVEN[0])?;
            let mut marks = vec![false; breaks.spans()];
            for (l, room) in self.locations.iter().zip(self.room) {
                let i = breaks.span_of(l.s_mm);
                let miss = l.centre.coords - Vector::from(weighed(&x[i..], &breaks.weights(i, l.s_mm)));
                marks[i] |= l.normal.dot(&miss).abs() > FIT * room.inwards_mm.min(room.outwards_mm);
            }
            if !marks.contains(&true) || breaks.spans() > MOST_BREAKS * self.locations.len() {
                break;
            }
            breaks = start::halved(&breaks, |i| marks[i])?;
        }
        Some(breaks)
    }

    /// The room of the stretch as one.
    pub fn allowed(&self) -> [f64; 3] {
        let r = self.room.iter().fold(TubeRoom::UNLIMITED, |a, b| a.and(b));
        [r.inwards_mm.min(r.outwards_mm), r.across_mm, r.along_mm]
    }

    /// A curve on given breaks, or the spans that keep it from being one.
    fn attempt(&self, breaks: &Breaks) -> Option<Result<CurveStretch, Vec<bool>>> {
        let marked = |missed: Missed| {
            let mut marks = vec![false; breaks.spans()];
            missed.0.iter().for_each(|(i, _)| marks[*i] = true);
            Some(Err(marks))
        };
        let turned = match self.turning.smooth(breaks, self.options) {
            Ok(turned) => turned,
            Err(missed) => return marked(missed),
        };
        let Turned { breaks: theta_breaks, theta, square: [theta_square, theta_bound] } = turned;
        let angle = |s: f64| {
            let k = theta_breaks.span_of(s);
            theta_breaks.weights(k, s).iter().zip(&theta[k..]).map(|(w, t)| w * t).sum::<f64>()
        };
        let is_few = self.options.aim == Aim::Fewest;
        let even = if is_few { fewest::EVEN } else { EVEN[1] };
        let cells = if is_few { Cells::of_moves(breaks, self.locations) } else { Cells::whole(breaks) };
        let mut x = start::fit(self.locations, breaks, self.allowed(), even)?;
        let limits = [self.options.inwards_mm, self.options.outwards_mm];
        let mut marks = Vec::new();
        for _ in 0..LOOKS {
            let seen = tube::look(self.part, self.radius_mm, (breaks, &cells), &x)?;
            let tube = Tube { locations: self.locations, breaks, cells: &cells, x: &x, seen: &seen, room: self.room };
            let (corrected, [square, bound]) = match self.correct(&tube, &angle, true) {
                Ok(found) => found,
                Err(missed) => return marked(missed),
            };
            // Axes' derivatives are no polynomials: for them nothing is known of other forms.
            let is_asked = self.options.bound_of_any && matches!(self.objective, Objective::Part);
            let any = is_asked.then(|| self.correct(&tube, &angle, false)).and_then(Result::ok);
            let bound_of_any = any.map(|(_, [_, bound])| bound);
            x = corrected;
            let proofs = prove::prove(self.part, self.radius_mm, breaks, &x, limits);
            let kept = |p: &Proof| p.inwards_mm <= limits[0] && p.outwards_mm <= limits[1];
            if proofs.iter().all(kept) {
                let Proof { inwards_mm, outwards_mm } = prove::worst(&proofs);
                let pieces_bound = is_few.then(|| self.least_pieces(breaks, &x));
                let proof = CurveProof {
                    inwards_mm,
                    outwards_mm,
                    square,
                    bound,
                    bound_of_any,
                    theta_square,
                    theta_bound,
                    pieces_bound,
                };
                return Some(Ok(CurveStretch { breaks: breaks.clone(), centre: x, theta_breaks, theta, proof }));
            }
            marks = proofs.iter().map(|p| !kept(p)).collect();
        }
        Some(Err(marks))
    }

    /// Control points with the least objective in a tube, or within its limits at the breaks alone,
    /// and that objective with its bound.
    fn correct(
        &self,
        tube: &Tube,
        theta: &(dyn Fn(f64) -> f64 + Sync),
        whole: bool,
    ) -> Result<(Vec<[f64; 3]>, [f64; 2]), Missed> {
        let form = |i: usize| match self.objective {
            Objective::Part => form::third::<3, 18>(tube.breaks, i, &tube.x[i..]),
            Objective::Axes { machine, gauge_length_mm, lean_rad } => {
                let linear = |s: f64| form::Linear::of(machine, theta(s), *lean_rad, *gauge_length_mm);
                form::axes(tube.breaks, i, &tube.x[i..], form::weights(machine), linear)
            }
        };
        let all = tube.breaks.all();
        let nothing = 0.5 * NOTHING * NOTHING * (all[all.len() - 1] - all[0]);
        let enough = Enough { gap: self.options.gap, nothing };
        let (spans, value) = if whole { tube.spans(&form) } else { tube.at_breaks(&form) };
        // Each of three directions, which are at right angles but for what the normal turns on a
        // span, has its room.
        let whole = |r: &TubeRoom| 2.0 * (r.inwards_mm + r.outwards_mm + r.across_mm + r.along_mm);
        let reach = 2.0 * CONDITION * self.room.iter().map(whole).fold(0.0, f64::max);
        let Solution { x: found, objective, bound, .. } = bounded::solve(&spans, value, enough, reach)?;
        let x = tube.x.iter().zip(&found).map(|(a, b)| std::array::from_fn(|d| a[d] + b[d])).collect();
        Ok((x, [value + objective, (value + bound).max(0.0)]))
    }
}
