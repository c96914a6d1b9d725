//! What the job asks for, against the plan: the region, the tool, the scallop and all that a plan
//! holds of its job.
//!
//! Planning makes a plan from its job, so these checks pass then. They are for plans that are read
//! from files: a plan of another job is a good plan by itself, and leaves uncut what its job did
//! not ask for.
//!
//! | check | measured |
//! | --- | --- |
//! | `job` | values of the plan that are not those of the job |
//! | `job-region` | how far the path ends before the heights that the job asks for, or goes beyond them; of rows over a hub, how far from the outer ones the blades stand |
//! | `job-feed` | feed of the ball centre between two locations, from their distance and their times |
//!
//! **Limits**: a path may end higher than asked for where the wall leans too far, the ball loses
//! the surface or comes to an edge, a face or a corner. Of these reasons only the lean is measured
//! here; any other is repeated in the note.

use super::height::flat_stepover;
use super::options::{Asked, VerifyOptions};
use crate::artifact::along::Along;
use crate::artifact::report::Check;
use crate::artifact::toolpath::{CutterLocation, Direction, PathKind, Turn};
use crate::artifact::{Blade, CheckId, Cone, Plan, Toolpath};
use crate::error::EndReason;
use crate::geometry::allowance::Allowed;

/// Values that JSON and arithmetic in radians keep.
const SAME: f64 = 1e-9;
/// A path ends at the height that was asked for within so many chord tolerances: turns are smooth
/// curves through places at that height.
const CHORDS: f64 = 10.0;
/// ... and at its beginning, which slants with the end, within so many stepovers on flat ground.
const STEPOVERS: f64 = 3.0;
/// A smooth curve is beside the path that it was made from by no more than this share of that.
const BESIDE: f64 = 0.05;
/// A wall that ends the path leans by the greatest lean, but for this, rad: places of a turn are
/// some tenths of a stepover apart.
const LEAN_RAD: f64 = 0.1;
/// Feeds from rounded times and straight distances may be so much higher, relative.
const FEED: f64 = 1e-4;

/// The checks of this module.
pub(super) fn check(plan: &Plan, blade: &Blade, asked: &Asked, options: &VerifyOptions) -> Vec<Check> {
    let region = match asked.kind {
        PathKind::HubRows => hub(plan, blade, options),
        _ => region(plan, blade, asked, options),
    };
    vec![values(plan, asked, options), region, feed(plan, blade, asked)]
}

/// Single values.
fn values(plan: &Plan, asked: &Asked, options: &VerifyOptions) -> Check {
    let (path, channel) = (&plan.toolpath, &plan.channel);
    let mut wrong = Vec::new();
    let mut number = |key: &str, is: f64, want: f64| {
        if !((is - want).abs() <= SAME * (1.0 + want.abs())) {
            wrong.push(format!("{key} is {is} in plan.json, the job asks for {want}"));
        }
    };
    number("tool.radius_mm", path.radius_mm, asked.radius_mm);
    number("path.scallop_mm", path.scallop_mm, options.scallop_mm);
    number("path.stock_mm", path.stock_mm, asked.stock_mm);
    number("path.chord_mm", path.chord_mm, asked.chord_mm);
    let lean_rad = path.cones.same().filter(Cone::is_about_blade).map_or(f64::NAN, |c| c.lean_rad);
    if let Some(b_rad) = asked.b_rad {
        number("machine.b_deg", lean_rad.to_degrees(), b_rad.to_degrees());
    }
    number("channel.tolerance_deg", channel.tolerance_rad.to_degrees(), asked.tolerance_rad.to_degrees());
    if path.kind != asked.kind {
        wrong.push(format!("path.kind is {} in plan.json, the job asks for {}", path.kind.name(), asked.kind.name()));
    }
    if plan.schedule.kind != asked.schedule {
        let (is, want) = (plan.schedule.kind, asked.schedule);
        wrong.push(format!("schedule.kind is {is:?} in plan.json, the job asks for {want:?}").to_lowercase());
    }
    for (name, lead) in ["lead-in", "lead-out"].into_iter().zip(&plan.leads) {
        let most = asked.lead_radius_mm;
        if lead.is_arc() && !(lead.radius_mm > 0.0 && lead.radius_mm <= most * (1.0 + SAME)) {
            wrong.push(format!("the {name} has radius {} in plan.json, feed.lead_radius_mm is {most}", lead.radius_mm));
        } else if !lead.is_arc() && most > 0.0 && lead.reason.is_none() {
            wrong.push(format!("the {name} is no arc in plan.json, without a reason; feed.lead_radius_mm is {most}"));
        }
    }
    let quantity = "values of the plan that are not those of the job";
    Check::at_most(CheckId::Job, quantity, wrong.len() as f64, 0.0, "", wrong.join("; "))
}

/// Heights of a turn's ball centres: least, mean, greatest.
fn heights(along: &Along, locations: &[CutterLocation], turn: &Turn) -> [f64; 3] {
    let of = locations.get(turn.first..turn.first.saturating_add(turn.count)).unwrap_or_default();
    let all: Vec<f64> = of.iter().filter(|l| l.touches()).map(|l| along.height_mm(&l.centre)).collect();
    let (lo, hi) = all.iter().fold((f64::INFINITY, f64::NEG_INFINITY), |(a, b), x| (a.min(*x), b.max(*x)));
    [lo, all.iter().sum::<f64>() / all.len() as f64, hi]
}

/// What is high for balls on the region that the path goes round.
fn along(blade: &Blade, radius_mm: f64) -> Along {
    let own = blade.regions.list.first().map_or(Along::BLADE, |region| region.along);
    own.for_ball(radius_mm).unwrap_or(own)
}

/// The heights that the path covers.
fn region(plan: &Plan, blade: &Blade, asked: &Asked, options: &VerifyOptions) -> Check {
    let path = &plan.toolpath.of_corner();
    let quantity = "how far the path ends before the heights that the job asks for, or goes beyond them";
    let unit = "mm";
    let (Some(first), Some(last)) = (path.turns.first(), path.turns.last()) else {
        let note = "plan.json has no turns".into();
        let asked_mm = asked.end_mm.map_or(asked.radius_mm, |end| asked.start_mm - end);
        return Check::at_most(CheckId::JobRegion, quantity, asked_mm, 0.0, unit, note);
    };
    let climbs = asked.direction == Direction::Climb;
    let (upper, lower) = if climbs { (first, last) } else { (last, first) };
    let along = along(blade, asked.radius_mm + asked.stock_mm);
    let heights = |turn: &Turn| heights(&along, &path.locations, turn);
    let (top, bottom) = (heights(upper), heights(lower));
    let (r, h) = (asked.radius_mm, options.scallop_mm);
    let stepover = 2.0 * (h * (2.0 * r - h)).max(0.0).sqrt();
    let room = STEPOVERS * stepover;
    // A smooth curve leaves the path across it by a share of the stepover.
    let beside = if plan.curve.is_some() { BESIDE * stepover } else { 0.0 };
    let close = CHORDS * asked.chord_mm + beside;
    // How far over what is allowed, and what to say of it.
    let mut found: Vec<(f64, usize, String)> = Vec::new();
    let (hi, lo) = (top[2], bottom[0]);
    let start = asked.start_mm;
    let says = format!(
        "the path of plan.json begins between heights {:.3} and {hi:.3}, the job's region.start_mm is {start}",
        top[0]
    );
    found.push((start - hi - close, upper.first, says.clone()));
    found.push((top[0] - start - room, upper.first, says));
    if let Some(end) = asked.end_mm {
        let reason = if ends_as_asked(path) { String::new() } else { format!(", since {}", path.end_reason) };
        let says = format!("the path of plan.json ends at height {lo:.3}, the job's region.end_mm is {end}{reason}");
        found.push((end - lo - close, lower.first, says.clone()));
        if ends_as_asked(path) {
            found.push((lo - end - close, lower.first, says.clone()));
            found.push((
                bottom[1] - end - room,
                lower.first,
                format!("{says}, the mean of its last turn is {:.3}", bottom[1]),
            ));
        } else if path.end_reason.is_lean() {
            let leans = leans(&along, &path.locations, lower);
            let short = if leans >= asked.max_lean_rad - LEAN_RAD { f64::NEG_INFINITY } else { lo - end };
            found.push((short, lower.first, format!("{says}; the wall leans by {:.1}° there", leans.to_degrees())));
        }
    }
    let [a, b] = path.region_x_mm;
    let claimed = (a.max(b) - hi).abs().max((a.min(b) - lo).abs());
    found.push((
        claimed - close,
        lower.first,
        format!("plan.json says that it goes from {a:.3} to {b:.3}, its locations from {hi:.3} to {lo:.3}"),
    ));
    let down = heights(first)[1] - heights(last)[1];
    let wrong_way = if climbs { -down } else { down };
    found.push((
        if path.turns.len() > 1 { wrong_way } else { 0.0 },
        0,
        format!("the path of plan.json runs {:.3} mm the wrong way for {:?} milling", wrong_way, asked.direction),
    ));
    let worst = found.into_iter().reduce(|a, b| if b.0 > a.0 { b } else { a });
    let (over, row, says) = worst.unwrap_or_default();
    let note = if over > 0.0 { says } else { format!("heights {hi:.3} to {lo:.3}: {}", path.end_reason) };
    let check = Check::at_most(CheckId::JobRegion, quantity, over.max(0.0), 0.0, unit, note);
    check.at_location(row, plan, blade)
}

/// Places of an outer row from which a blade is looked for.
const HUB_PLACES: usize = 200;
/// How far from an outer row the next blade may stand at most of its places, in stepovers on flat
/// ground.
const HUB_STEPOVERS: f64 = 2.0;
/// A blade is looked for at steps of this share of the stepover, so many.
const HUB_LOOK: f64 = 0.25;
const HUB_LOOKS: u32 = 16;
/// A ball aside of an outer row meets the blade where it would cut so much deeper than the row, in
/// scallops.
const HUB_CUTS: f64 = 0.5;

/// Whether the outer rows over a hub run at the blades: from the middle of their places, in order
/// of the way sideways over the hub until a ball would cut into a blade. Before and behind the
/// blades there is none.
fn hub(plan: &Plan, blade: &Blade, options: &VerifyOptions) -> Check {
    let path = &plan.toolpath;
    let part = Allowed::new(&blade.part, path.stock_mm);
    let stepover_mm = flat_stepover(path.radius_mm, options.scallop_mm);
    let quantity = "way from an outer row sideways to the blade, at the middle of its places in order of that way";
    // Farther than a blade is looked for.
    let far_mm = HUB_LOOK * f64::from(HUB_LOOKS + 1) * stepover_mm;
    let rows = |turn: &Turn| turn.first..(turn.first + turn.count).min(path.locations.len());
    let n = path.turns.len();
    let outer = [(0, 1), (n.wrapping_sub(1), n.wrapping_sub(2))];
    let mut worst: (f64, usize) = if n < 2 { (far_mm, 0) } else { (0.0, 0) };
    for (own, other) in outer.into_iter().filter(|_| n >= 2) {
        let (own, other) = (rows(&path.turns[own]), rows(&path.turns[other]));
        let every = own.len().div_ceil(HUB_PLACES).max(1);
        let at = |row: usize| -> Option<(f64, usize)> {
            let l = path.locations[row];
            let way = path.locations.get(row + 1)?.centre - l.centre;
            let beside = path.locations[other.clone()].iter().map(|o| o.centre - l.centre);
            let beside = beside.min_by(|a, b| a.norm_squared().total_cmp(&b.norm_squared()))?;
            let side = l.normal.cross(&way).try_normalize(1e-12)?;
            let side = if side.dot(&beside) > 0.0 { -side } else { side };
            let depth = |way_mm: f64| {
                let near = part.closest(&(l.centre + side * way_mm), path.radius_mm);
                near.map_or(0.0, |c| path.radius_mm - c.distance_mm)
            };
            let ways = (1..=HUB_LOOKS).map(|k| HUB_LOOK * f64::from(k) * stepover_mm);
            let met = ways.into_iter().find(|way_mm| depth(*way_mm) > HUB_CUTS * options.scallop_mm);
            Some((met.unwrap_or(far_mm), row))
        };
        let mut ways: Vec<(f64, usize)> = own.step_by(every).filter_map(at).collect();
        ways.sort_by(|a, b| a.0.total_cmp(&b.0));
        let middle = ways.get(ways.len() / 2).copied().unwrap_or((far_mm, 0));
        worst = if middle.0 > worst.0 { middle } else { worst };
    }
    let note = format!("{n} rows, {:.3} mm apart on flat ground", stepover_mm);
    let limit = HUB_STEPOVERS * stepover_mm;
    Check::at_most(CheckId::JobRegion, quantity, worst.0, limit, "mm", note).at_location(worst.1, plan, blade)
}

fn ends_as_asked(path: &Toolpath) -> bool {
    path.end_reason == EndReason::Region
}

/// Greatest lean of the wall towards the tip along a turn, rad.
fn leans(along: &Along, locations: &[CutterLocation], turn: &Turn) -> f64 {
    let of = locations.get(turn.first..turn.first.saturating_add(turn.count)).unwrap_or_default();
    let on_part = of.iter().filter(|l| l.touches());
    on_part.map(|l| along.frame(&l.centre).lean(&l.normal)).fold(-1.0, f64::max).clamp(-1.0, 1.0).asin()
}

/// The greatest feed.
fn feed(plan: &Plan, blade: &Blade, asked: &Asked) -> Check {
    let rows: Vec<_> = plan.feed_points().into_iter().zip(plan.rows().map(|r| r.t_s)).collect();
    let speeds = rows.windows(2).map(|w| (w[1].0 - w[0].0).norm() / (w[1].1 - w[0].1) * 60.0);
    let worst = speeds.enumerate().fold((0.0f64, 0), |best, (row, v)| {
        let v = if v >= 0.0 { v } else { f64::MAX };
        if v > best.0 { (v, row) } else { best }
    });
    let limit = asked.feed_mm_min * (1.0 + FEED);
    let quantity = "greatest feed of the ball centre, from locations and times";
    let row = worst.1.saturating_sub(plan.leads[0].centres.len()).min(plan.toolpath.locations.len().saturating_sub(1));
    let note = format!("the job asks for at most {}", asked.feed_mm_min);
    Check::at_most(CheckId::JobFeed, quantity, worst.0, limit, "mm/min", note).at_location(row, plan, blade)
}
