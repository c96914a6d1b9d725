//! Clearance: the least distance between the tool without its ball and the part, over the whole
//! motion.
//!
//! Between two locations the control moves the ball centre on a straight line and θ evenly.
//! [`super::solid`] bounds the distance over a whole move from its middle; a move is halved until
//! that bound is within the resolution of the least distance measured so far. At one place a tree
//! over the part's triangles is searched with the same bound over its boxes: no triangle and no
//! moment is left out that could matter.
//!
//! Most moves of a long motion are far from mattering. Moves that follow one another are looked at
//! as one straight move first ([`Run`]), with the greatest distance of any point of the tool from
//! where that one would have it taken off the bound. What this does not clear is cut into shorter
//! runs, and at last into its moves.

use parry3d_f64::partitioning::TraversalAction;

use super::apart::Apart;
use super::options::VerifyOptions;
use super::solid::Moving;
use crate::artifact::report::Check;
use crate::artifact::{Blade, CheckId, Plan, Stand, Toolpath};
use crate::geometry::part::Part;
use crate::geometry::{Point, Vector};
use crate::parallel;
use crate::tool::Segment;

/// Moves per unit of parallel work; fixed, so that the result does not depend on the number of
/// threads.
const CHUNK: usize = 128;
/// So many moves are looked at as one at first; what is not clear is cut into so many runs.
const LONGEST_RUN: usize = 64;
const CUT: usize = 4;
/// Places of the first, coarse look over the path.
const COARSE: usize = 400;
/// Halvings of one move at most.
const DEEPEST: u32 = 24;
/// The same where it is only asked whether it falls short.
const DEEPEST_SHORT: u32 = 10;

/// Points of a triangle are resolved to this where it is only asked whether it is touched, mm.
pub(super) const TOUCH_MM: f64 = 0.002;

/// Share of large distances that may be missed.
const SHARE: f64 = 0.02;
/// The same, and the least that is resolved, mm, where a clearance is only just kept or missed.
pub(super) const CLOSELY: (f64, f64) = (0.001, 0.0005);

/// Distances beyond this are not measured, mm.
const FAR_MM: f64 = 1000.0;

/// Where the tool comes nearest to the part.
#[derive(Clone, Copy, Debug)]
pub(super) struct Nearest {
    /// Distance measured, mm; negative: depth of the interference.
    pub found_mm: f64,
    /// Move of the least distance.
    pub row: usize,
    /// Segment of the tool.
    pub segment: usize,
    /// Triangle of the part.
    pub triangle: u32,
    /// Its point.
    pub point: Point,
}

impl Nearest {
    fn far(cap: f64) -> Self {
        Nearest { found_mm: cap, row: 0, segment: 0, triangle: u32::MAX, point: Point::origin() }
    }
    fn nearer(self, other: Self) -> Self {
        if other.found_mm < self.found_mm { other } else { self }
    }
}

/// Where the tool is at each row; between rows it moves as [`Stand::towards`] says.
#[derive(Clone, Copy)]
pub(super) struct Track<'a> {
    /// Where the tool stands.
    pub stands: &'a [Stand],
    /// Moves to look at, by their first row; `None`: all.
    pub wanted: Option<&'a [bool]>,
}

impl Track<'_> {
    fn wants(&self, row: usize) -> bool {
        self.wanted.is_none_or(|w| w.get(row) == Some(&true))
    }
}

/// Moves that follow one another: from row `first` to row `last`.
#[derive(Clone, Copy)]
struct Run {
    first: usize,
    last: usize,
}

impl Run {
    /// The longest runs of these moves, the first one last.
    fn all_of(moves: std::ops::Range<usize>) -> Vec<Run> {
        let end = moves.end;
        let run = |first: usize| Run { first, last: (first + LONGEST_RUN).min(end) };
        moves.step_by(LONGEST_RUN).map(run).rev().collect()
    }

    fn count(&self) -> usize {
        self.last - self.first
    }

    /// Its parts, the first one last.
    fn cut(self) -> impl Iterator<Item = Run> {
        let each = self.count().div_ceil(CUT);
        let part = move |first: usize| Run { first, last: (first + each).min(self.last) };
        (self.first..self.last).step_by(each.max(1)).map(part).rev()
    }
}

/// How far a point of a segment may be from the ball centre, mm.
fn reach_mm(segment: &Segment) -> f64 {
    segment.z0.abs().max(segment.z1.abs()).hypot(segment.r0.max(segment.r1))
}

/// How far a point of the tool within `reach_mm` of the ball centre may be from where it would be
/// if all of these moves were the one straight move from the first stand to the last; `None` where
/// their cones have different frames.
///
/// Any place of the one move will do for comparison, the nearest along its chord is taken. Between
/// two stands both moves are straight, and so is their difference: it is greatest at a stand.
fn bend_mm(stands: &[Stand], reach_mm: f64) -> Option<f64> {
    let (first, last) = (stands.first()?, stands.last()?);
    let is_same = |s: &Stand| s.cone.axis == first.cone.axis && s.cone.reference == first.cone.reference;
    let chord = last.centre - first.centre;
    let length2 = chord.norm_squared();
    let mut most = 0.0f64;
    for (k, s) in stands.iter().enumerate() {
        if !is_same(s) {
            return None;
        }
        let even = k as f64 / (stands.len() - 1) as f64;
        let share = if length2 > 0.0 { (s.centre - first.centre).dot(&chord) / length2 } else { even };
        let there = first.towards(last, share.clamp(0.0, 1.0));
        let turned = (s.theta - there.theta).abs() + (s.cone.lean_rad - there.cone.lean_rad).abs();
        let off = (s.centre - there.centre).norm() + turned * reach_mm;
        if !off.is_finite() {
            return None;
        }
        most = most.max(off);
    }
    Some(most)
}

/// The motion as it is looked at, and the tool's segments.
struct TrackSearch<'a> {
    part: &'a Part,
    track: Track<'a>,
    segments: &'a [Segment],
    resolution: f64,
    /// Share of a distance that may be missed, where that is more.
    share: f64,
}

impl<'a> TrackSearch<'a> {
    /// What may be missed where the least distance is `found`: the resolution, or a share of large
    /// distances, a tenth of depths: a collision need not be measured more finely.
    fn may_miss(&self, found: f64) -> f64 {
        self.resolution.max(self.share * found).max(-0.1 * found)
    }

    /// The tool in the middle of the parts `t0 … t1` of move `row`.
    fn place(&self, row: usize, t0: f64, t1: f64) -> Vec<Moving<'a>> {
        let next = (row + 1).min(self.track.stands.len() - 1);
        self.place_on(row, next, 0.5 * (t0 + t1), 0.5 * (t1 - t0))
    }

    /// The tool on the straight move from the stand of one row to that of another, about a share of
    /// the way and so far to both sides of it.
    fn place_on(&self, from: usize, to: usize, mid: f64, half: f64) -> Vec<Moving<'a>> {
        let stands = self.track.stands;
        let Some((first, others)) = self.segments.split_first() else { return Vec::new() };
        let first = Moving::between(first, &stands[from], &stands[to], [mid, half]);
        std::iter::once(first).chain(others.iter().map(|frustum| first.with(frustum))).collect()
    }

    /// A lower bound of the distance over all segments, triangles and the whole move, or `cap`
    /// where that is less; and the least distance below `cap` seen in the middle of the move. The
    /// triangle `hint` is looked at first.
    fn least(&self, place: &[Moving<'_>], cap: f64, hint: u32, row: usize) -> (f64, Nearest) {
        let mut lower = cap;
        let mut seen = Nearest::far(f64::INFINITY);
        let tolerance = 0.2 * self.may_miss(cap.min(FAR_MM));
        let mut look = |threshold: &mut f64, triangle: u32| {
            let corners = self.part.mesh.corners(triangle as usize);
            for (segment, solid) in place.iter().enumerate() {
                let (bound, at) = solid.least_over_triangle(&corners, *threshold, tolerance);
                lower = lower.min(bound);
                if let Some((d, point)) = at {
                    *threshold = d;
                    seen = Nearest { found_mm: d, row, segment, triangle, point };
                }
            }
        };
        // Only what has been seen closes boxes.
        let mut threshold = cap;
        if (hint as usize) < self.part.mesh.triangles.len() {
            look(&mut threshold, hint);
        }
        self.part.bvh.tree.traverse(|node| {
            let (lo, hi) = (node.mins(), node.maxs());
            let half = Vector::new(0.5 * (hi.x - lo.x), 0.5 * (hi.y - lo.y), 0.5 * (hi.z - lo.z));
            let middle = Point::new(lo.x + half.x, lo.y + half.y, lo.z + half.z);
            if place.iter().all(|solid| solid.bound_over_box(&middle, &half) >= threshold) {
                return TraversalAction::Prune;
            }
            if let Some(triangle) = node.leaf_data().filter(|t| *t != hint) {
                look(&mut threshold, triangle);
            }
            TraversalAction::Continue
        });
        (lower, seen)
    }

    /// Least distance over moves `rows` where it is less than that of `start`, else `start`.
    fn over(&self, rows: std::ops::Range<usize>, start: Nearest) -> Nearest {
        let mut best = start;
        let mut hint = start.triangle;
        let mut runs = Run::all_of(rows);
        // Half of what may be missed is left for telling points apart and for the move itself.
        let cap = |best: &Nearest| best.found_mm - 0.5 * self.may_miss(best.found_mm);
        while let Some(row) = self.next_open(&mut runs, cap(&best), &mut hint) {
            let mut open = vec![(0.0, 1.0, 0)];
            while let Some((t0, t1, depth)) = open.pop() {
                let cap = cap(&best);
                let (lower, seen) = self.least(&self.place(row, t0, t1), cap, hint, row);
                if lower >= cap {
                    continue;
                }
                if seen.triangle != u32::MAX {
                    hint = seen.triangle;
                }
                if seen.found_mm < best.found_mm {
                    best = seen;
                }
                if lower < best.found_mm - self.may_miss(best.found_mm) && depth < DEEPEST {
                    let mid = 0.5 * (t0 + t1);
                    open.push((mid, t1, depth + 1));
                    open.push((t0, mid, depth + 1));
                }
            }
        }
        best
    }

    /// The next move that is wanted and no run shows to be clear of `limit_mm`.
    fn next_open(&self, runs: &mut Vec<Run>, limit_mm: f64, hint: &mut u32) -> Option<usize> {
        while let Some(run) = runs.pop() {
            if run.count() == 1 {
                if self.track.wants(run.first) {
                    return Some(run.first);
                }
            } else if !self.clears(&run, limit_mm, hint) {
                runs.extend(run.cut());
            }
        }
        None
    }

    /// Whether nothing is nearer than `limit_mm` on any move of a run, as far as one straight move
    /// shows it. A triangle that is nearer becomes the hint.
    fn clears(&self, run: &Run, limit_mm: f64, hint: &mut u32) -> bool {
        let Some(stands) = self.track.stands.get(run.first..=run.last) else { return false };
        if !(run.first..run.last).all(|row| self.track.wants(row)) {
            return false;
        }
        let reach_mm = self.segments.iter().map(reach_mm).fold(0.0, f64::max);
        let Some(off_mm) = bend_mm(stands, reach_mm) else { return false };
        let cap = limit_mm + off_mm;
        let (lower, seen) = self.least(&self.place_on(run.first, run.last, 0.5, 0.5), cap, *hint, run.first);
        if seen.triangle != u32::MAX {
            *hint = seen.triangle;
        }
        lower >= cap
    }

    /// Least distance over the whole path.
    fn whole(&self) -> Nearest {
        let n = self.track.stands.len();
        // A coarse look first: its least distance lets the fine one skip nearly everything.
        let few = (0..n).step_by(n.div_ceil(COARSE)).filter(|row| self.track.wants(*row));
        let coarse: Vec<Nearest> =
            parallel::map(few, |row| self.least(&self.place(row, 0.5, 0.5), FAR_MM, u32::MAX, row).1);
        let start = coarse.into_iter().fold(Nearest::far(FAR_MM), Nearest::nearer);
        let moves = n - 1;
        let fine: Vec<Nearest> =
            parallel::map(0..moves.div_ceil(CHUNK), |k| self.over(k * CHUNK..((k + 1) * CHUNK).min(moves), start));
        fine.into_iter().fold(start, Nearest::nearer)
    }
}

impl TrackSearch<'_> {
    /// Moves on which something comes nearer than `limit_mm`, or may, in their order.
    fn short(&self, limit_mm: f64) -> Vec<usize> {
        let moves = self.track.stands.len().saturating_sub(1);
        let short = |first: usize| {
            let mut runs = Run::all_of(first..(first + LONGEST_RUN).min(moves));
            let mut hint = u32::MAX;
            let open = std::iter::from_fn(|| self.next_open(&mut runs, limit_mm, &mut hint));
            open.filter(|row| self.may_fall_short(*row, limit_mm)).collect::<Vec<_>>()
        };
        parallel::map((0..moves).step_by(LONGEST_RUN), short).concat()
    }

    /// Whether something comes nearer than `limit_mm` at some time of a move, or may: it is halved
    /// until one or the other is known.
    fn may_fall_short(&self, row: usize, limit_mm: f64) -> bool {
        let cap = limit_mm + self.resolution;
        let mut open = vec![(0.0, 1.0, 0)];
        let mut hint = u32::MAX;
        while let Some((t0, t1, depth)) = open.pop() {
            let (lower, seen) = self.least(&self.place(row, t0, t1), cap, hint, row);
            if lower >= limit_mm {
                continue;
            }
            if seen.found_mm < limit_mm || depth >= DEEPEST_SHORT {
                return true;
            }
            hint = seen.triangle;
            let mid = 0.5 * (t0 + t1);
            open.extend([(mid, t1, depth + 1), (t0, mid, depth + 1)]);
        }
        false
    }
}

/// Moves between two locations, by their first, on which the tool may come nearer to something than
/// passes its check: where a motion keeps the clearance at its locations and not between them.
pub fn short_moves(path: &Toolpath, theta: &[f64], apart: &[Apart], options: &VerifyOptions) -> Vec<usize> {
    let stands = path.stands(theta).collect::<Vec<_>>();
    let mut out: Vec<usize> = apart.iter().flat_map(|a| short_stands(&stands, a, 0.0, options)).collect();
    out.sort_unstable();
    out.dedup();
    out
}

/// Moves from stand to stand, by their first, on which segments may come nearer to a body than
/// passes their check, with `more_mm` kept besides.
pub(super) fn short_stands(stands: &[Stand], a: &Apart, more_mm: f64, options: &VerifyOptions) -> Vec<usize> {
    let (share, resolution) = CLOSELY;
    let limit = options.least_clearance(a.asked_mm) + more_mm;
    // What the check takes off what it has measured.
    let needed = (limit + resolution).max(limit / (1.0 - share));
    let track = Track { stands, wanted: None };
    let on = |part| TrackSearch { part, track, segments: &a.segments, resolution, share };
    let short = on(a.part).short(needed + a.part.deflection_mm);
    match a.part.sharper().filter(|_| !short.is_empty()) {
        Some(sharper) => {
            let limit_mm = needed + sharper.deflection_mm;
            parallel::filter(short, |row| on(sharper).may_fall_short(*row, limit_mm))
        }
        None => short,
    }
}

/// How near a motion comes to a part.
#[derive(Clone, Copy, Debug)]
pub(super) struct NearestApproach {
    /// The nearest place.
    pub near: Nearest,
    /// Face of the part there.
    pub face: Option<u32>,
    /// No point of the tool is nearer to the part, mm.
    pub least_mm: f64,
    /// The part is known to this, mm.
    pub known_mm: f64,
}

/// How near `segments` come to a part. Where the part's mesh is too coarse to tell whether
/// `limit_mm` is kept, by triangles that are nearer to its exact faces, and more closely.
pub(super) fn kept(
    track: Track,
    part: &Part,
    segments: &[Segment],
    limit_mm: f64,
    options: &VerifyOptions,
) -> NearestApproach {
    let of = |on: &Part, (near, bound_mm): (Nearest, f64)| NearestApproach {
        near,
        face: (near.triangle != u32::MAX).then(|| on.mesh.face(near.triangle as usize)),
        least_mm: bound_mm - on.deflection_mm,
        known_mm: on.deflection_mm,
    };
    let first = of(part, measure_track(track, part, segments, usual(options.clearance_resolution_mm)));
    if first.least_mm >= limit_mm || first.near.found_mm + first.known_mm < limit_mm {
        return first;
    }
    let on = part.sharper().unwrap_or(part);
    of(on, measure_track(track, on, segments, CLOSELY))
}

/// What may be missed: a share of large distances, and the least that is resolved, mm.
pub(super) fn usual(resolution_mm: f64) -> (f64, f64) {
    (SHARE, resolution_mm)
}

/// Least distance between `segments` of the tool and the part over a motion of at least two rows,
/// to a share of it or to a least length, mm, whichever is more: the nearest place measured, and
/// what the distance is nowhere less than, mm.
pub(super) fn measure_track(
    track: Track,
    part: &Part,
    segments: &[Segment],
    (share, resolution): (f64, f64),
) -> (Nearest, f64) {
    let motion = TrackSearch { part, track, segments, resolution, share };
    let near = motion.whole();
    let bound = near.found_mm - motion.may_miss(near.found_mm);
    (near, bound)
}

/// Where a tool that stands still comes nearest to a part.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Standing {
    /// Distance between a segment and a point of the part, mm; negative: that point lies so deep in
    /// it. No point is nearer than this less `resolution_mm`, or a fiftieth of large distances, a
    /// tenth of depths.
    pub distance_mm: f64,
    /// Which of the segments.
    pub segment: usize,
    /// Triangle of the part.
    pub triangle: u32,
    /// Its point.
    pub point: Point,
}

/// How near `segments` of a tool that stands still come to a part's triangles; `None`: they are
/// more than a metre away.
pub fn standing(part: &Part, segments: &[Segment], stand: &Stand, resolution_mm: f64) -> Option<Standing> {
    let track = Track { stands: &[*stand], wanted: None };
    let motion = TrackSearch { part, track, segments, resolution: resolution_mm, share: SHARE };
    let place = motion.place(0, 0.5, 0.5);
    let mut best = Nearest::far(FAR_MM);
    loop {
        let may_miss = motion.may_miss(best.found_mm);
        let cap = best.found_mm - 0.5 * may_miss;
        let (lower, seen) = motion.least(&place, cap, best.triangle, 0);
        best = best.nearer(seen);
        if seen.triangle == u32::MAX || lower >= best.found_mm - motion.may_miss(best.found_mm) {
            break;
        }
    }
    let Nearest { found_mm, segment, triangle, point, .. } = best;
    (triangle != u32::MAX).then_some(Standing { distance_mm: found_mm, segment, triangle, point })
}

/// As [`standing`], as far as a triangle is nearer than `limit_mm`; `None`: none is.
pub(super) fn nearer(part: &Part, segments: &[Segment], stand: &Stand, limit_mm: f64) -> Option<Standing> {
    let track = Track { stands: &[*stand], wanted: None };
    let motion = TrackSearch { part, track, segments, resolution: TOUCH_MM, share: SHARE };
    let (_, seen) = motion.least(&motion.place(0, 0.5, 0.5), limit_mm, u32::MAX, 0);
    let Nearest { found_mm, segment, triangle, point, .. } = seen;
    (triangle != u32::MAX).then_some(Standing { distance_mm: found_mm, segment, triangle, point })
}

/// The moves of a motion in the middle of which some triangle is nearer than `limit_mm`.
pub(super) fn below(track: Track, part: &Part, segments: &[Segment], limit_mm: f64) -> Vec<usize> {
    let motion = TrackSearch { part, track, segments, resolution: 0.0, share: SHARE };
    let touches = |row: &usize| {
        let place = motion.place(*row, 0.5, 0.5);
        let mut met = false;
        part.bvh.tree.traverse(|node| {
            let (lo, hi) = (node.mins(), node.maxs());
            let half = Vector::new(0.5 * (hi.x - lo.x), 0.5 * (hi.y - lo.y), 0.5 * (hi.z - lo.z));
            let middle = Point::new(lo.x + half.x, lo.y + half.y, lo.z + half.z);
            if place.iter().all(|solid| solid.bound_over_box(&middle, &half) >= limit_mm) {
                return TraversalAction::Prune;
            }
            if let Some(triangle) = node.leaf_data() {
                let corners = part.mesh.corners(triangle as usize);
                let near = |s: &Moving| s.least_over_triangle(&corners, limit_mm, TOUCH_MM).1.is_some();
                met |= place.iter().any(near);
            }
            if met { TraversalAction::EarlyExit } else { TraversalAction::Continue }
        });
        met
    };
    let moves = 0..track.stands.len().saturating_sub(1);
    parallel::filter(moves.filter(|row| track.wants(*row)), touches)
}

/// The checks `clearance` (taper, shank) and `holder-clearance` of the part, `obstacle-clearance`
/// of all else; and the least distance to the part, mm.
pub(super) fn check(plan: &Plan, blade: &Blade, apart: &[Apart], options: &VerifyOptions) -> (Vec<Check>, f64) {
    let stands = plan.toolpath.stands(&plan.schedule.theta).collect::<Vec<_>>();
    let track = Track { stands: &stands, wanted: None };
    let bent_rad = bent_rad(plan, &stands);
    let mut least = FAR_MM;
    let mut checks = Vec::new();
    for a in apart {
        let limit = options.least_clearance(a.asked_mm);
        let mut kept = kept(track, a.part, &a.segments, limit, options);
        kept.least_mm -= bent_rad * a.segments.iter().map(reach_mm).fold(0.0, f64::max);
        if a.obstacle.is_none() {
            least = least.min(kept.least_mm);
        }
        checks.push(judge(a, &kept, limit, plan, blade));
    }
    (checks, least)
}

/// Greatest angle between the tool axis and that of even turning between two locations, rad: the
/// difference is greatest about halfway, and a tenth is added for where it is not there.
fn bent_rad(plan: &Plan, stands: &[Stand]) -> f64 {
    let halfway = |w: &[Stand]| 1.1 * plan.schedule.bent(&w[0], &w[1], 0.5).abs();
    stands.windows(2).map(halfway).fold(0.0, f64::max)
}

fn judge(a: &Apart, kept: &NearestApproach, limit: f64, plan: &Plan, blade: &Blade) -> Check {
    let near = &kept.near;
    let (id, quantity) = match (a.obstacle, a.is_holder) {
        (None, false) => (CheckId::Clearance, "the tool without its ball to the part".to_owned()),
        (None, true) => (CheckId::HolderClearance, "the tool without its ball to the part".to_owned()),
        (Some(o), false) => (CheckId::ObstacleClearance, format!("taper and shank to {}", o.name)),
        (Some(o), true) => (CheckId::ObstacleClearance, format!("holder to {}", o.name)),
    };
    let quantity = format!("least distance of {quantity}, between locations too");
    let who = a.segments.get(near.segment).map_or_else(String::new, |s| s.part.to_string());
    let place = match kept.face {
        Some(_) => format!("{who} to {}", a.named(kept.face)),
        None => format!("nothing within {FAR_MM} mm"),
    };
    let note = format!(
        "{place}; measured {:.6}, known to {:.6}, nowhere less than {:.6}; asked for {}",
        near.found_mm, kept.known_mm, kept.least_mm, a.asked_mm
    );
    let point = kept.face.map(|_| blade.model_from_blade * near.point);
    Check {
        passed: kept.least_mm >= limit,
        row: point.map(|_| near.row),
        turn: point.map(|_| plan.toolpath.locations[near.row].turn),
        point_mm: point.map(|p| [p.x, p.y, p.z]),
        ..Check::at_most(id, &quantity, kept.least_mm, limit, "mm", note)
    }
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used)]
    use proptest::prelude::*;

    use super::*;
    use crate::artifact::Cone;
    use crate::sample;

    /// A wavy way about the sample's cylinder, with a lean that changes by `lean_rad`. The shares
    /// are of waves, swing, pace and distance.
    fn stands(shares: [f64; 4], count: usize, lean_rad: f64) -> Vec<Stand> {
        let [wave, swing, pace] = [0.5 * shares[0], 0.3 * shares[1], 0.002 + 0.05 * shares[2]];
        let radius = sample::PART_RADIUS + sample::tool().radius_mm + 0.5 * shares[3];
        let stand = |k: usize| {
            let azimuth = pace * k as f64;
            let r = radius + wave * (7.0 * azimuth).sin();
            let centre = Point::new(30.0 - azimuth, r * azimuth.cos(), r * azimuth.sin());
            let lean = sample::B_RAD + lean_rad * (5.0 * azimuth).cos();
            Stand { centre, cone: Cone::about_blade(lean), theta: azimuth + 0.3 + swing * (9.0 * azimuth).sin() }
        };
        (0..count).map(stand).collect()
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(32))]
        #[test]
        fn runs_find_what_single_moves_find(
            shares in prop::array::uniform4(0.0..1.0f64), count in 2..250usize, lean_rad in prop::sample::select(vec![0.0, 0.05]),
        ) {
            let (blade, tool) = (sample::blade(), sample::tool());
            let (stands, segments) = (stands(shares, count, lean_rad), tool.segments());
            let track = Track { stands: &stands, wanted: None };
            let motion = TrackSearch { part: &blade.part, track, segments: &segments, resolution: 0.0005, share: 0.001 };
            let near = motion.whole().found_mm;
            // The same, every move by itself.
            let each = |best: Nearest, row: usize| motion.over(row..row + 1, best);
            let singly = (0..count - 1).fold(Nearest::far(FAR_MM), each).found_mm;
            prop_assert!((near - singly).abs() <= motion.may_miss(singly), "{near} {singly}");
            for more in [-0.3, 0.02, 0.1, 0.4] {
                let limit = singly + more;
                let one_by_one: Vec<usize> = (0..count - 1).filter(|row| motion.may_fall_short(*row, limit)).collect();
                prop_assert_eq!(one_by_one.is_empty(), more < 0.0);
                prop_assert_eq!(motion.short(limit), one_by_one);
            }
        }

        /// The gauge point is always as near to some place of the one move.
        #[test]
        fn no_point_of_the_tool_leaves_a_run_farther_than_it_says(
            shares in prop::array::uniform4(0.0..1.0f64), row in 0..16usize, share in 0.0..=1.0f64,
        ) {
            let mut stands = stands(shares, 17, 0.05);
            let off_mm = bend_mm(&stands, 80.0).unwrap();
            let (first, last) = (stands[0], stands[16]);
            let gauge = |s: &Stand| s.centre + s.axis() * 80.0;
            let here = gauge(&stands[row].towards(&stands[row + 1], share));
            let there = |k: u32| (gauge(&first.towards(&last, f64::from(k) / 2000.0)) - here).norm();
            let off = (0..=2000).map(there).fold(f64::INFINITY, f64::min);
            prop_assert!(off <= off_mm + 0.01, "{off} {off_mm}");
            stands[2].cone = Cone::new(Vector::new(1.0, 0.1, 0.0), Vector::y(), 0.1).unwrap();
            prop_assert!(bend_mm(&stands, 80.0).is_none());
        }
    }

    #[test]
    fn runs_are_cut_into_all_their_moves_in_order() {
        for (from, to) in [(0, 1), (5, 69), (0, 128), (3, 200), (7, 7)] {
            let (mut runs, mut moves) = (Run::all_of(from..to), Vec::new());
            while let Some(run) = runs.pop() {
                if run.count() > 1 {
                    runs.extend(run.cut());
                } else {
                    moves.push(run.first);
                }
            }
            assert_eq!(moves, (from..to).collect::<Vec<_>>());
        }
    }
}
