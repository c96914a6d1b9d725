//! The programmed curve of a plan: ball and tool along it, between cutter locations too.
//!
//! Nothing is taken from how the curve was made: it is what its rows say, polynomials of degree 5
//! between locations ([`crate::artifact::programmed`]). Each is cut into parts so short that chords
//! with θ even are within [`OFF_MM`] and [`OFF_RAD`] of it at the same parameter, by
//! `h² max |c''|/8`. What is measured on the chords then holds on the curve but for that: distances
//! to the part change by no more than the ball or the tool moves.
//!
//! | check | measured |
//! | --- | --- |
//! | `curve-gouge` | depth of the ball in the part along the curve, as `gouge`: also in surface that the part's file has otherwise |
//! | `curve-chord` | greatest distance of straight moves from location to location from the curve |
//! | `curve-scallop` | 99th percentile of the heights over the part under the ball along the curve |
//! | `curve-clearance` | how much less than asked for the tool without its ball keeps from part, fixtures and stock |
//! | `curve-theta` | how far θ turns back, or lies outside the channel with walls straight between locations |
//! | `curve-joints` | greatest jump of a third derivative at a location within the curve beyond rounding, as a share of the greatest there is; also that places join |

use super::apart::Apart;
use super::clearance::{self, Track};
use super::height::percentile;
use super::options::VerifyOptions;
use super::sweep::Sweep;
use super::{gouge, scallop};
use crate::artifact::programmed::Polynomial;
use crate::artifact::report::Check;
use crate::artifact::{Blade, CheckId, Plan, ProgrammedCurve, Stand, Toolpath};
use crate::geometry::Point;
use crate::geometry::allowance::Allowed;
use crate::parallel;
use crate::tool::Segment;

/// Chords of the curve are off it by at most this, mm, but for pieces that would take too many.
const OFF_MM: f64 = 1e-4;
/// The same of θ, rad.
const OFF_RAD: f64 = 1e-5;
/// Chords of one polynomial at most.
const MOST_CHORDS: usize = 64;
/// Polynomials lead to the next location within this, mm or rad: what rounding makes.
const GAP: f64 = 1e-9;
/// Rounding of third derivatives, over the cube of a length and of a value of size 1: two ends,
/// each of some roundings.
const ROUNDING: f64 = 4.0 * 60.0 * f64::EPSILON;
/// Third derivatives at a joint may differ by this share of the greatest.
const JUMP: f64 = 0.01;

/// A curve as chords.
struct Chords {
    stands: Vec<Stand>,
    contacts: Vec<Point>,
    /// Location that each stand is at or behind.
    rows: Vec<usize>,
    /// Chords are off the curve by at most this, mm and rad, at the same parameter.
    off: [f64; 2],
}

impl Chords {
    fn of(path: &Toolpath, theta: &[f64], polynomials: &[Option<Polynomial>]) -> Chords {
        let l = &path.locations;
        let all: Vec<Stand> = path.stands(theta).collect();
        let mut out = Chords { stands: Vec::new(), contacts: Vec::new(), rows: Vec::new(), off: [0.0; 2] };
        for (k, polynomial) in polynomials.iter().enumerate() {
            let mut put = |stand: Stand, contact: Point| {
                out.stands.push(stand);
                out.contacts.push(contact);
                out.rows.push(k);
            };
            put(all[k], l[k].contact);
            let Some(p) = polynomial else { continue };
            let [bend, turn] = p.sagitta();
            let parts = (bend / OFF_MM).max(turn / OFF_RAD).sqrt().ceil().clamp(1.0, MOST_CHORDS as f64);
            out.off = [out.off[0].max(bend / (parts * parts)), out.off[1].max(turn / (parts * parts))];
            for j in 1..parts as usize {
                let share = j as f64 / parts;
                let at = p.at(share);
                let stand = Stand { centre: at.point(), theta: at.theta[0], ..all[k] };
                put(stand, l[k].contact + (l[k + 1].contact - l[k].contact) * share);
            }
        }
        out
    }

    fn sweep(&self, path: &Toolpath) -> Sweep {
        let centres = self.stands.iter().map(|s| s.centre).collect();
        let turns = self.rows.iter().map(|k| path.locations[*k].turn).collect();
        Sweep::of(centres, self.contacts.clone(), turns, path.radius_mm, None)
    }

    /// No point of the segments moves by more than this between curve and chord, mm.
    fn off_at(&self, a: &Apart) -> f64 {
        let far = |s: &Segment| s.z1.abs().max(s.z0.abs()).hypot(s.r0.max(s.r1));
        self.off[0] + a.segments.iter().map(far).fold(0.0, f64::max) * self.off[1]
    }
}

/// The ways from each location to the next.
fn polynomials(path: &Toolpath, theta: &[f64], curve: &ProgrammedCurve) -> Vec<Option<Polynomial>> {
    let one = |k: usize| curve.polynomial(path, theta, k);
    parallel::map_short(256, 0..path.locations.len(), one)
}

/// Moves between two locations, by their first, on which the tool may come nearer to something than
/// passes its check, on the curve or on a straight move from location to location.
pub fn short_on_curve(
    path: &Toolpath,
    theta: &[f64],
    curve: &ProgrammedCurve,
    apart: &[Apart],
    options: &VerifyOptions,
) -> Vec<usize> {
    let mut out = clearance::short_moves(path, theta, apart, options);
    let chords = Chords::of(path, theta, &polynomials(path, theta, curve));
    for a in apart {
        let short = clearance::short_stands(&chords.stands, a, chords.off_at(a), options);
        out.extend(short.into_iter().map(|k| chords.rows[k]));
    }
    out.sort_unstable();
    out.dedup();
    out
}

/// The checks of this module; none where the plan has no curve.
pub(super) fn check(
    plan: &Plan,
    blade: &Blade,
    part: &Allowed,
    apart: &[Apart],
    options: &VerifyOptions,
) -> Vec<Check> {
    let Some(curve) = &plan.curve else { return Vec::new() };
    let (path, theta) = (&plan.toolpath, &plan.schedule.theta);
    let polynomials = polynomials(path, theta, curve);
    let chords = Chords::of(path, theta, &polynomials);
    let sweep = chords.sweep(path);
    let of = OnCurve { plan, blade, part, apart, options, polynomials, chords, sweep };
    vec![of.gouges(), of.chord(), of.heights(), of.keeps_clear(), of.turning(), of.joints()]
}

/// Greatest value and its place, the first of equals.
fn greatest(values: impl Iterator<Item = f64>) -> (f64, usize) {
    values.enumerate().fold((0.0, 0), |best, (k, v)| if v > best.0 || v.is_nan() { (v, k) } else { best })
}

/// A plan's curve, and what it is judged by.
struct OnCurve<'a> {
    plan: &'a Plan,
    blade: &'a Blade,
    part: &'a Allowed<'a>,
    apart: &'a [Apart<'a>],
    options: &'a VerifyOptions,
    polynomials: Vec<Option<Polynomial>>,
    chords: Chords,
    sweep: Sweep,
}

impl OnCurve<'_> {
    fn gouges(&self) -> Check {
        let g = gouge::measure(self.part, &self.sweep, self.options.settings.resolution_mm);
        let bound = g.bound_mm.max(g.found_mm).max(0.0) + self.chords.off[0];
        let face = gouge::where_it_is(self.part, &g.centre, bound > self.options.settings.gouge_mm);
        let note = format!("measured {:.6}, nowhere deeper than {bound:.6}; {face}", g.found_mm.max(0.0));
        let quantity = "depth of the ball in the part along the programmed curve";
        let check = Check::at_most(CheckId::CurveGouge, quantity, bound, self.options.settings.gouge_mm, "mm", note);
        check.at_location(self.chords.rows[g.segment], self.plan, self.blade)
    }

    fn chord(&self) -> Check {
        let off = |p: &Option<Polynomial>| p.map_or(0.0, |p| p.sagitta()[0]);
        let (worst, row) = greatest(self.polynomials.iter().map(off));
        let quantity = "distance of straight moves between locations from the programmed curve, at most";
        let check =
            Check::at_most(CheckId::CurveChord, quantity, worst, self.plan.toolpath.chord_mm, "mm", String::new());
        check.at_location(row, self.plan, self.blade)
    }

    fn heights(&self) -> Check {
        let band = scallop::heights(
            self.part,
            &self.sweep,
            self.options.scallop_mm,
            self.options.settings.surface_samples as usize,
        );
        let most = percentile(&band.heights, 0.99) + self.chords.off[0];
        let limit = self.options.settings.scallop_ratio * self.options.scallop_mm;
        let at = band.heights.get(((band.heights.len() as f64 * 0.99) as usize).min(band.heights.len().max(1) - 1));
        let note = format!("at {} samples", band.heights.len());
        let quantity = "99th percentile of the height left over the part along the programmed curve";
        let check = Check::at_most(CheckId::CurveScallop, quantity, most, limit, "mm", note);
        check.at_location(
            at.map_or(0, |h| self.chords.rows[h.row.min(self.chords.rows.len() - 1)]),
            self.plan,
            self.blade,
        )
    }

    fn keeps_clear(&self) -> Check {
        let track = Track { stands: &self.chords.stands, wanted: None };
        let mut worst = (f64::NEG_INFINITY, 0, String::new());
        for a in self.apart {
            let limit = self.options.least_clearance(a.asked_mm);
            let off_mm = self.chords.off_at(a);
            let kept = clearance::kept(track, a.part, &a.segments, limit + off_mm, self.options);
            let least = kept.least_mm - off_mm;
            if limit - least > worst.0 {
                let who = if a.is_holder { "holder" } else { "taper and shank" };
                let note =
                    format!("{who} to {}: nowhere less than {least:.6} mm, {limit:.6} needed", a.named(kept.face));
                worst = (limit - least, self.chords.rows[kept.near.row.min(self.chords.rows.len() - 1)], note);
            }
        }
        let quantity = "how much less than needed the tool without its ball keeps along the programmed curve";
        let check = Check::at_most(CheckId::CurveClearance, quantity, worst.0.max(0.0), 0.0, "mm", worst.2);
        check.at_location(worst.1, self.plan, self.blade)
    }

    fn turning(&self) -> Check {
        let (theta, rows) = (&self.plan.schedule.theta, &self.plan.channel.rows);
        let forward = if theta[theta.len() - 1] >= theta[0] { 1.0 } else { -1.0 };
        let off = |k: usize| {
            let Some(p) = self.polynomials[k] else { return 0.0 };
            let o = p.derivative(0).0.map(|o| o[3]);
            let back = o.windows(2).map(|w| (w[0] - w[1]) * forward).fold(0.0, f64::max);
            let (a, b) = (&rows[k], &rows[k + 1]);
            let outside = |(j, theta): (usize, &f64)| {
                let share = j as f64 / 5.0;
                let wall = |a: f64, b: f64| a + (b - a) * share;
                (wall(a.theta_min, b.theta_min) - theta).max(theta - wall(a.theta_max, b.theta_max))
            };
            // At locations `theta-channel` judges; between them the walls are only known to this.
            let outside = o.iter().enumerate().map(outside).fold(0.0, f64::max) - self.plan.channel.tolerance_rad;
            back.max(outside).to_degrees()
        };
        let (worst, row) = greatest((0..theta.len()).map(off));
        let quantity = "how far θ turns back, or lies outside the channel, along the programmed curve, degrees";
        let limit = self.options.angle_tolerance_deg;
        Check::at_most(CheckId::CurveTheta, quantity, worst, limit, "deg", String::new())
            .at_location(row, self.plan, self.blade)
    }

    fn joints(&self) -> Check {
        let (path, theta) = (&self.plan.toolpath, &self.plan.schedule.theta);
        let third = |p: &Polynomial, share: f64| {
            let at = p.at(share);
            [at.centre[3][0], at.centre[3][1], at.centre[3][2], at.theta[3]]
        };
        let ends = |p: &Option<Polynomial>| p.map(|p| [0.0, 1.0].map(|share| third(&p, share)));
        let thirds: Vec<Option<[[f64; 4]; 2]>> = self.polynomials.iter().map(ends).collect();
        let size = |v: &[f64; 4]| [(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]).sqrt(), v[3].abs()];
        let most =
            thirds.iter().flatten().flatten().map(size).fold([0.0f64; 2], |m, v| [m[0].max(v[0]), m[1].max(v[1])]);
        let reach = path.locations.iter().map(|l| l.centre.coords.norm()).fold(0.0, f64::max);
        // The place that a polynomial leads to is the next location's.
        let gap = |k: usize| {
            let (p, to) = (self.polynomials[k]?, path.locations.get(k + 1)?);
            let end = p.at(1.0);
            Some((end.point() - to.centre).norm().max((end.theta[0] - theta[k + 1]).abs()))
        };
        let jump = |(k, w): (usize, &[Option<[[f64; 4]; 2]>])| {
            if gap(k).is_some_and(|g| !(g <= GAP)) {
                return f64::MAX;
            }
            let (Some([_, a]), Some([b, _])) = (&w[0], &w[1]) else { return 0.0 };
            let [c, t] = size(&std::array::from_fn(|j| a[j] - b[j]));
            // Control values are rounded as places and angles are: a third derivative over a length
            // has that by 60 over its cube.
            let length = |p: &Option<Polynomial>| p.map_or(f64::INFINITY, |p| p.length_mm);
            let h = length(&self.polynomials[k]).min(length(&self.polynomials[k + 1]));
            let rounding = ROUNDING / h.powi(3);
            let [c, t] = [c - rounding * reach, t - rounding * theta[k].abs()];
            (c / most[0].max(f64::MIN_POSITIVE)).max(t / most[1].max(f64::MIN_POSITIVE)).max(0.0)
        };
        let (worst, before) = greatest(thirds.windows(2).enumerate().map(jump));
        let note = format!(
            "greatest third derivatives: {:.4e} of the ball centre, 1/mm², {:.4e} of θ, rad/mm³",
            most[0], most[1]
        );
        let quantity =
            "jump of a third derivative at a location along the programmed curve, as a share of the greatest";
        Check::at_most(CheckId::CurveJoints, quantity, worst, JUMP, "", note).at_location(
            before + 1,
            self.plan,
            self.blade,
        )
    }
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used)]
    use super::*;
    use crate::geometry::mesh::Mesh;
    use crate::geometry::part::Part;
    use crate::sample;

    /// A flat rib 0.03 mm over the part that only its file has, under a place within the curve:
    /// where the ball is beside its middle it is some micrometres deeper.
    #[test]
    fn surface_that_only_the_file_has_is_gouged_along_the_curve() {
        let plan = sample::on_curve(sample::plan(2, 180), 0.05, 23.0, 3);
        let options = VerifyOptions::default();
        let gouge = |blade: &Blade| {
            let part = Allowed::new(&blade.part, 0.0);
            check(&plan, blade, &part, &[], &options).into_iter().find(|c| c.id == CheckId::CurveGouge).unwrap()
        };
        let sound = sample::blade();
        assert!(gouge(&sound).passed, "{:?}", gouge(&sound));
        let l = &plan.toolpath.locations[100];
        let across = l.normal.cross(&crate::geometry::Vector::x());
        let corner = |along: f64, beside: f64| {
            l.contact + l.normal * 0.03 + crate::geometry::Vector::x() * along + across * beside
        };
        let points = vec![corner(-2.0, -0.2), corner(2.0, -0.2), corner(0.0, 0.4)];
        let rib = Mesh { points, triangles: vec![[0, 1, 2]], face_of: vec![0], ..Mesh::default() };
        let mut torn = sample::blade();
        torn.part = torn.part.with_published(Part::from_mesh(rib), vec![None]);
        let found = gouge(&torn);
        assert!(!found.passed && (0.03..0.036).contains(&found.worst), "{found:?}");
        assert!(found.note.contains("as its file has it"), "{}", found.note);
        assert!(found.row.is_some_and(|row| row.abs_diff(100) <= 2), "{found:?}");
    }
}
