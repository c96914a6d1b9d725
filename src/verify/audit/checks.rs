//! Gouge, clearance, rapids and travel of a program.

use super::legs::LegKind;
use super::line_check::{LineCheck, LineLimit};
use super::report::WorstMove;
use super::{AuditScene, MovesSource};
use crate::artifact::program::Programmed;
use crate::artifact::{AxisCheck, CheckId};
use crate::geometry::part::Part;
use crate::parallel;
use crate::tool::Segment;
use crate::verify::clearance::{self, Nearest, Track};
use crate::verify::gouge::Gouge;
use crate::verify::setting;
use crate::verify::sweep::Sweep;

/// Legs that another motion is tried at first.
const A_FEW: usize = 200;
/// Distances of the ball in rapids are reported up to this, mm.
const FAR_MM: f64 = 1000.0;
/// A feed may ask for this many times the velocity of an axis: words are rounded, and short lines
/// are over within milliseconds.
const OVER_VELOCITY: f64 = 1.1;
/// Rounding of positions at the end of a travel, mm or rad.
const ROUNDING: f64 = 1e-9;

/// How much of the feed moves runs along the part.
pub(super) fn contact(scene: &AuditScene, passes: &Sweep) -> LineCheck {
    let cut = scene.legs.of(LegKind::Cut);
    let along: Vec<usize> = (0..cut.len()).filter(|i| passes.counts(*i)).collect();
    let share = along.len() as f64 / cut.iter().filter(|c| **c).count().max(1) as f64;
    let limit = LineLimit {
        id: CheckId::Contact,
        quantity: format!(
            "share of the feed legs in which the {} is at the part, greater than the limit",
            scene.end_name()
        ),
        limit: 0.0,
        unit: "",
        passed: share > 0.0,
    };
    let first = along.first().copied().or_else(|| cut.iter().position(|c| *c)).unwrap_or(0);
    let point = scene.legs.stands.get(first).map(|s| s.centre);
    scene.judged(limit, &scene.on_leg(share, first, point), format!("{} legs", along.len()))
}

/// The deepest cut of the ball, or of the cutter's corner.
pub(super) fn gouge(scene: &AuditScene) -> LineCheck {
    let options = scene.options;
    let found = match inside(scene) {
        Some((leg, depth)) => {
            Gouge { found_mm: depth, bound_mm: depth, segment: leg, centre: scene.legs.stands[leg].centre }
        }
        None => scene.deepest(scene.legs.of(LegKind::Cut), options.settings.resolution_mm, 0.0),
    };
    let bound = found.bound_mm.max(found.found_mm).max(0.0);
    let limit = LineLimit {
        id: CheckId::Gouge,
        quantity: format!("depth of the swept {} in the part at a feed", scene.end_name()),
        limit: options.settings.gouge_mm,
        unit: "mm",
        passed: bound <= options.settings.gouge_mm,
    };
    let at = scene.part.closest(&found.centre, f64::INFINITY);
    let face = at.map(|c| scene.part.face_name(c.face)).unwrap_or_default();
    let note = format!("measured {:.6}, nowhere deeper than {bound:.6}; {face}", found.found_mm.max(0.0));
    let mut check = scene.judged(limit, &scene.on_leg(bound, found.segment, at.map(|c| c.point)), note);
    if !check.check.passed {
        let deeper = scene.deeper_than(scene.legs.of(LegKind::Cut), options.settings.gouge_mm);
        scene.tell_spans(&mut check, &deeper, found.segment);
    }
    check
}

/// A place where the way begins inside the part, and how deep the ball is there: from then on
/// distances to the surface mean nothing.
fn inside(scene: &AuditScene) -> Option<(usize, f64)> {
    let legs = &scene.legs.legs;
    let begins = |i: &usize| *i == 0 || legs.get(i.wrapping_sub(1)).is_some_and(|l| l.kind == LegKind::Gap);
    (0..legs.len()).filter(begins).find_map(|i| {
        let c = &scene.legs.stands[i].centre;
        let depth = || scene.part.closest(c, f64::INFINITY).map_or(0.0, |f| f.distance_mm);
        scene.part.inside(c).then(|| (i, scene.bench.tool.corner_mm() + depth()))
    })
}

impl AuditScene<'_> {
    fn track<'a>(&'a self, wanted: &'a [bool]) -> Track<'a> {
        Track { stands: &self.legs.stands, wanted: Some(wanted) }
    }

    /// Least distance of segments of the tool, what is known of the part taken off; and its check.
    /// `closely`: see [`super::AuditOptions::clearance_closely`].
    fn clearance(&self, limit: LineLimit, segments: &[Segment], wanted: &[bool], closely: bool) -> LineCheck {
        let to = if closely { clearance::CLOSELY } else { clearance::usual(self.options.clearance_resolution_mm) };
        let track = self.track(wanted);
        let measure = |on: &Part| {
            let (near, bound) = clearance::measure_track(track, on, segments, to);
            (near, bound - on.deflection_mm)
        };
        let usual = &self.blade.part;
        let mut on = if closely { usual.sharper().unwrap_or(usual) } else { usual };
        let (mut near, mut worst) = measure(on);
        // Just over a small corner the mesh may be too coarse to tell.
        if !self.bench.tool.is_ball()
            && worst < 0.0
            && let Some(sharper) = self.blade.part.sharper()
        {
            on = sharper;
            (near, worst) = measure(on);
        }
        let deflection = on.deflection_mm;
        let limit = LineLimit { passed: worst >= 0.0, ..limit };
        let note = format!(
            "{}; measured {:.6}, part known to {deflection:.6}, nowhere less than {worst:.6}",
            who(self, on, segments, &near),
            near.found_mm
        );
        let mut check = self.judged(limit, &self.on_leg(worst, near.row, Some(near.point)), note);
        if !check.check.passed {
            self.tell_spans(&mut check, &clearance::below(track, on, segments, deflection), near.row);
        }
        check
    }
}

fn who(scene: &AuditScene, on: &Part, segments: &[Segment], near: &Nearest) -> String {
    let name = segments.get(near.segment).map_or_else(String::new, |s| s.part.to_string());
    let mesh = &on.mesh;
    match near.triangle {
        u32::MAX => "nothing near".into(),
        t => format!("{name} to {}", scene.part.face_name(mesh.face(t as usize))),
    }
}

/// Taper and shank, and the holder, at a feed.
pub(super) fn clearances(scene: &AuditScene) -> Vec<LineCheck> {
    let [cutter, holder] = scene.bench.tool.cutter_and_holder();
    let wanted = scene.legs.of(LegKind::Cut);
    let groups = [(CheckId::Clearance, "taper and shank", cutter), (CheckId::HolderClearance, "the holder", holder)];
    let check = |(id, what, segments): (CheckId, &str, Vec<Segment>)| {
        let limit = LineLimit {
            id,
            quantity: format!("least distance of {what} to the part at a feed"),
            limit: 0.0,
            unit: "mm",
            passed: false,
        };
        (!segments.is_empty()).then(|| scene.clearance(limit, &segments, &wanted, scene.options.clearance_closely))
    };
    groups.into_iter().filter_map(check).collect()
}

/// The whole tool in rapids.
pub(super) fn rapid(scene: &AuditScene) -> Option<LineCheck> {
    let wanted = scene.legs.of(LegKind::Rapid);
    if !wanted.contains(&true) {
        return None;
    }
    let limit = || LineLimit {
        id: CheckId::Rapid,
        quantity: "least distance of the whole tool to the part in rapids".into(),
        limit: 0.0,
        unit: "mm",
        passed: false,
    };
    let upper = scene.clearance(limit(), &scene.bench.tool.segments(), &wanted, false);
    let ball = scene.deepest(wanted.clone(), scene.options.clearance_resolution_mm, FAR_MM);
    let least = -ball.bound_mm.max(ball.found_mm);
    if upper.check.worst <= least || !least.is_finite() {
        return Some(upper);
    }
    let at = scene.part.closest(&ball.centre, f64::INFINITY);
    let face = at.map(|c| scene.part.face_name(c.face)).unwrap_or_default();
    let note = format!("{} to {face}; measured {:.6}, nowhere less than {least:.6}", scene.end_name(), -ball.found_mm);
    let limit = LineLimit { passed: least >= 0.0, ..limit() };
    let mut check = scene.judged(limit, &scene.on_leg(least, ball.segment, at.map(|c| c.point)), note);
    if !check.check.passed {
        scene.tell_spans(&mut check, &scene.deeper_than(wanted, 0.0), ball.segment);
    }
    Some(check)
}

/// Every axis that has an end of travel.
pub(super) fn travel(scene: &AuditScene) -> Vec<LineCheck> {
    let machine = scene.bench.machine;
    let reached = reached(scene);
    let mut out = Vec::new();
    for (axis, own) in machine.axes().iter().enumerate() {
        let Some([lo, hi]) = own.limits.travel else { continue };
        let (name, scale) = (&own.name, own.scale());
        let over: Vec<(usize, f64)> =
            reached[axis].iter().map(|(at, least, most)| (*at, (lo - least).max(most - hi))).collect();
        // The first of equals: the line that went there, not those that stay.
        let Some(worst) = over.iter().reduce(|best, o| if o.1 > best.1 + ROUNDING { o } else { best }) else {
            continue;
        };
        let range =
            reached[axis].iter().fold([f64::INFINITY, f64::NEG_INFINITY], |r, (_, a, b)| [r[0].min(*a), r[1].max(*b)]);
        let [a, b, c, d] = [range[0], range[1], lo, hi].map(|v| v * scale);
        let limit = LineLimit {
            id: CheckId::axis(name, AxisCheck::Travel),
            quantity: format!("how far axis {name} leaves its travel"),
            limit: 0.0,
            unit: own.unit(),
            passed: worst.1 <= ROUNDING,
        };
        let point =
            scene.moves.get(worst.0).filter(|m| m.known()).map(|m| m.pose(1.0, scene.bench.tool, machine).centre);
        let place = WorstMove { value: (worst.1 * scale).max(0.0), moved: Some(worst.0), turn: None, point };
        let mut check =
            scene.judged(limit, &place, format!("it runs from {a:.3} to {b:.3}, the travel is {c:.3} to {d:.3}"));
        if !check.check.passed {
            let outside = over.iter().filter(|o| o.1 > ROUNDING).map(|(at, _)| *at).collect();
            (check.spans, check.span_count) = scene.spans(outside);
        }
        out.push(check);
    }
    out
}

/// What the programmed feeds ask of every axis, leg by leg.
pub(super) fn velocity(scene: &AuditScene) -> Vec<LineCheck> {
    let (tool, machine) = (scene.bench.tool, scene.bench.machine);
    let axes = machine.axes();
    let cuts = scene.legs.legs.iter().enumerate().filter(|(_, l)| l.kind == LegKind::Cut);
    let ways = parallel::map(cuts, |(leg, l)| {
        let m = &scene.moves[l.moved];
        let time = m.seconds.unwrap_or(0.0) * (l.share[1] - l.share[0]);
        (leg, l.share.map(|f| m.axes(f, tool, machine)), time)
    });
    let mut fastest = vec![Vec::new(); axes.len()];
    for (leg, [from, to], time) in ways {
        for (axis, list) in fastest.iter_mut().enumerate() {
            let way = (to[axis] - from[axis]).abs();
            let velocity = if way > ROUNDING { way / time } else { 0.0 };
            list.push((leg, velocity));
        }
    }
    let judge = |(axis, list): (usize, Vec<(usize, f64)>)| {
        let own = &axes[axis];
        let allowed = OVER_VELOCITY * own.limits.velocity;
        let worst = list.iter().copied().reduce(|best, v| if v.1 > best.1 { v } else { best })?;
        let (scale, unit) = (own.scale(), if own.is_rotary() { "deg/s" } else { "mm/s" });
        let limit = LineLimit {
            id: CheckId::axis(&own.name, AxisCheck::Velocity),
            quantity: format!("velocity of axis {} that a programmed feed asks for", own.name),
            limit: allowed * scale,
            unit,
            passed: worst.1 <= allowed,
        };
        let note = format!("the axis' limit is {:.3}", own.limits.velocity * scale);
        let mut check = scene.judged(
            limit,
            &scene.on_leg(worst.1 * scale, worst.0, scene.legs.stands.get(worst.0 + 1).map(|s| s.centre)),
            note,
        );
        if !check.check.passed {
            let over: Vec<usize> = list.iter().filter(|v| v.1 > allowed).map(|v| v.0).collect();
            scene.tell_spans(&mut check, &over, worst.0);
        }
        Some(check)
    };
    fastest.into_iter().enumerate().filter_map(judge).collect()
}

/// What the program sets beside its motion, in the feed moves at the part.
pub(super) fn settings(scene: &AuditScene, source: &MovesSource, passes: &Sweep) -> Vec<LineCheck> {
    let mut cuts = vec![false; source.blocks.len()];
    let first = source.moves.first().map_or(0, |m| m.block);
    let block = |moved: usize| source.moves.get(moved).map(|m| m.block - first);
    for (leg, l) in scene.legs.legs.iter().enumerate() {
        if let (true, Some(cut)) = (passes.counts(leg), block(l.moved).and_then(|k| cuts.get_mut(k))) {
            *cut = true;
        }
    }
    let at_part = source.blocks.iter().zip(&cuts).filter(|(_, cut)| **cut).map(|(b, _)| b);
    let tolerance_mm = scene.options.settings.gouge_mm.max(scene.options.scallop_mm.unwrap_or(0.0));
    let theirs = setting::theirs(source.script, source.blocks, at_part, tolerance_mm, scene.bench.tool);
    let end = source.last.then(|| setting::end(CheckId::End, source.script));
    theirs.into_iter().chain(end).map(|f| scene.set(f)).collect()
}

/// Move, least and greatest position of each axis in it, in order; positions that are not known are
/// left out.
type Reached = Vec<Vec<(usize, f64, f64)>>;

fn reached(scene: &AuditScene) -> Reached {
    let (tool, machine) = (scene.bench.tool, scene.bench.machine);
    let mut out: Reached = vec![Vec::new(); machine.axes().len()];
    for (k, m) in scene.moves.iter().enumerate() {
        if m.words == Programmed::Machine && m.even() || !m.known() {
            // Axes go straight from where they were: the end decides.
            for (axis, to) in m.axes(1.0, tool, machine).iter().copied().enumerate().filter(|(_, v)| v.is_finite()) {
                out[axis].push((k, to, to));
            }
        }
    }
    let legs = scene.legs.legs.iter().filter(|l| l.kind != LegKind::Gap);
    let legs = parallel::filter_map(legs, |leg| {
        let m = &scene.moves[leg.moved];
        if m.words == Programmed::Machine && m.even() {
            return None;
        }
        let [from, to] = leg.share;
        Some((leg, [from, 0.5 * (from + to), to].map(|f| m.axes(f, tool, machine))))
    });
    for (leg, at) in legs {
        for (axis, list) in out.iter_mut().enumerate() {
            let [a, mid, b] = at.map(|q| q[axis]);
            let (least, most) = extent(a, mid, b);
            list.push((leg.moved, least, most));
        }
    }
    out.iter_mut().for_each(|list| list.sort_by_key(|(k, ..)| *k));
    out
}

/// Least and greatest value of the parabola through three values at 0, ½ and 1, between 0 and 1.
fn extent(a: f64, mid: f64, b: f64) -> (f64, f64) {
    let (bend, slope) = (2.0 * (a - 2.0 * mid + b), 4.0 * mid - 3.0 * a - b);
    let t = -slope / (2.0 * bend);
    let top = if bend != 0.0 && (0.0..=1.0).contains(&t) { a + t * (slope + t * bend) } else { mid };
    (a.min(b).min(top), a.max(b).max(top))
}

/// The share of feed legs with a gouge or a touch, of a few looked at.
pub(super) fn share_bad(scene: &AuditScene) -> f64 {
    let cuts: Vec<usize> = (0..scene.legs.legs.len()).filter(|i| scene.legs.legs[*i].kind == LegKind::Cut).collect();
    let mut few = vec![false; scene.legs.legs.len()];
    cuts.iter().step_by(cuts.len().div_ceil(A_FEW).max(1)).for_each(|i| few[*i] = true);
    let looked = few.iter().filter(|w| **w).count();
    let mut bad = scene.deeper_than(few.clone(), scene.options.settings.gouge_mm);
    bad.extend(clearance::below(scene.track(&few), &scene.blade.part, &scene.bench.tool.segments(), 0.0));
    bad.sort_unstable();
    bad.dedup();
    bad.len() as f64 / looked.max(1) as f64
}

/// Whether there is contact but neither gouge nor touch, for trying another motion. Looks at a few
/// places first: most motions that are wrong are so nearly everywhere.
pub(super) fn clean(scene: &AuditScene) -> bool {
    let wanted = scene.legs.of(LegKind::Cut);
    let first = wanted.iter().position(|w| *w).and_then(|i| scene.legs.stands.get(i).map(|s| s.centre));
    if first.is_none_or(|c| scene.part.inside(&c)) {
        return false;
    }
    let limit = scene.options.settings.gouge_mm;
    if share_bad(scene) > 0.0 || !contact(scene, &scene.passes()).check.passed {
        return false;
    }
    let gouge = scene.deepest(wanted, scene.options.settings.resolution_mm, 0.0);
    gouge.bound_mm <= limit && clearances(scene).iter().all(|c| c.check.passed)
}
