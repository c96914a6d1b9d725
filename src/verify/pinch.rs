//! Rows of two tools that hold a blade between them, judged apart from their planner.
//!
//! Each tool by itself: the swept ball in the part, ridges from row to row and where rows round the
//! edges meet the other tool's, the rest of the tool to the part, over the straight moves of each
//! stretch, while the table stands still or turns evenly. Both together: whether their normals face
//! each other, by the part's own normals under both ball centres, and how far the tools are apart.
//!
//! The least distance of two tools is taken piece by piece, ball and frusta. Each piece is convex:
//! parry's search for the nearest points of two convex bodies gives a direction, and the pieces'
//! own extents along it bound their distance from below, whatever the search has found. Between two
//! places they go straight and evenly, so a direction bounds it there too; where the table turns,
//! points leave the chords of their arcs by what is taken off.

use parry3d_f64::math::{Pose, Vector as ParryVector};
use parry3d_f64::query::gjk::{self, CsoPoint, GJKResult, VoronoiSimplex};
use parry3d_f64::shape::SupportMap;

use super::apart::{Apart, apart};
use super::clearance::{Track, kept};
use super::cuts::{self, EndWay};
use super::height::{Height, REACH_SLACK, percentile, sort};
use super::options::VerifyOptions;
use super::ridge::{Ridges, apart_mm};
use super::sweep::{Nearest, Sweep};
use crate::artifact::paired::Held;
use crate::artifact::report::Check;
use crate::artifact::{Blade, CheckId, Cone, Obstacle, PairedRows, Stand};
use crate::geometry::allowance::Allowed;
use crate::geometry::opposite::SurfacePlace;
use crate::geometry::part::Part;
use crate::geometry::{Point, Vector};
use crate::parallel;
use crate::tool::{Segment, Tool};

/// Ridges are measured on each side at about so many places.
const RIDGES: usize = 6000;

/// Two tools, and how they stand along rows.
pub struct PinchWork<'a> {
    /// The part.
    pub blade: &'a Blade,
    /// What stands about it.
    pub obstacles: &'a [Obstacle],
    /// Both cutters.
    pub tools: [&'a Tool; 2],
    /// The cones of their axes.
    pub cones: [Cone; 2],
    /// What the angle of tool 2 is over the table's, rad.
    pub between_rad: f64,
    /// The rows.
    pub rows: &'a PairedRows,
    /// Stretches with the angles of the table.
    pub held: &'a [Held],
    /// Room that the tools keep from each other, mm.
    pub tools_apart_mm: f64,
    /// Greatest distance of the two normal lines, mm.
    pub line_distance_mm: f64,
    /// What the normals may lack of being opposite, rad.
    pub max_angle_rad: f64,
}

impl PinchWork<'_> {
    /// How a tool stands at a place of a stretch.
    pub(super) fn stand(&self, held: &Held, place: usize, tool: usize) -> Stand {
        let over = if tool == 0 { 0.0 } else { self.between_rad };
        let centre = self.rows.places[place].contacts[tool].centre;
        Stand { centre, cone: self.cones[tool], theta: held.theta_at(place) + over }
    }
}

/// What was measured on rows of two tools. Lengths in mm.
#[derive(Clone, Debug, Default, PartialEq, serde::Serialize)]
pub struct PinchFigures {
    /// Ridges of each side: 5th percentile, median, 95th and 99th percentile, greatest.
    pub ridges_mm: [[f64; 5]; 2],
    /// The same of the higher of both sides at each place: that which binds the distance of rows.
    pub binding_ridges_mm: [f64; 5],
    /// The same where rows round the edges lie beside rows of opposite places, of either tool;
    /// zeros where there are none.
    pub border_ridges_mm: [f64; 5],
    /// Distance of the two normal lines: median, 99th percentile, greatest. Here and of the angle,
    /// rows round the edges are left out; a double helix is not.
    pub line_distance_mm: [f64; 3],
    /// What the normals lack of being opposite: median, 99th percentile, greatest, degrees.
    pub angle_deg: [f64; 3],
    /// The tools are nowhere nearer to each other.
    pub tools_apart_mm: f64,
    /// What the axis of each tool turns by per mm of its contact's way at most, rad/mm; 0 where the
    /// table stands still all along.
    pub turning_rad_mm: [f64; 2],
}

/// Judges rows of two tools.
pub fn check(work: &PinchWork, options: &VerifyOptions) -> (Vec<Check>, PinchFigures) {
    let mut checks = Vec::new();
    let mut figures = PinchFigures::default();
    // Every place at the angles of its stretches, stretch by stretch, for either tool.
    let order: Vec<(usize, usize)> =
        work.held.iter().enumerate().flat_map(|(n, h)| h.places.clone().map(move |k| (n, k))).collect();
    let cuts: Vec<bool> = order.windows(2).map(|w| w[0].0 == w[1].0).collect();
    checks.push(covered(work));
    if order.len() < 2 {
        return (checks, figures);
    }
    let places: Vec<usize> = order.iter().map(|(_, k)| *k).collect();
    let sweeps = swept(work.rows, &places, work.tools.map(|t| t.radius_mm), Some(&cuts));
    let part = Allowed::new(&work.blade.part, work.rows.stock_mm);
    let (mut sides, mut borders, mut both) = (Vec::new(), Vec::new(), Vec::new());
    for (tool, sweep) in sweeps.iter().enumerate() {
        // Places are named as the rows number them, not as stretches pass them.
        let place = |i: usize| order.get(i).map_or(i, |(_, k)| *k);
        let name = |check: Check| {
            let quantity = format!("tool {}: {}", tool + 1, check.quantity);
            Check { quantity, row: check.row.map(place), ..check }
        };
        checks.push(name(cuts::check(work.blade, &part, &EndWay::of_ball(sweep), options)));
        checks.extend(cuts::check_obstacles(work.blade, work.obstacles, &EndWay::of_ball(sweep), options).map(name));
        let side = ridges(&part, &sweeps, tool, work.rows, options.scallop_mm);
        let border = border_ridges(&part, &sweeps, tool, work, options.scallop_mm);
        let heights = sort(side.iter().copied().flatten().chain(border.iter().copied()).collect());
        borders.extend(border);
        figures.ridges_mm[tool] = five(&heights);
        checks.push(name(ridge_check(&heights, work, options)));
        sides.push(side);
        let stands: Vec<Stand> = order.iter().map(|(n, k)| work.stand(&work.held[*n], *k, tool)).collect();
        let track = Track { stands: &stands, wanted: Some(&cuts) };
        for a in apart(work.blade, work.obstacles, work.tools[tool], options) {
            checks.push(name(clearance(&a, track, work.blade, options)));
        }
        both.push(stands);
    }
    figures.binding_ridges_mm = five(&binding(&sides));
    figures.border_ridges_mm = five(&sort(borders));
    let (check, opposition) = opposed(work);
    checks.extend(check);
    (figures.line_distance_mm, figures.angle_deg) = opposition;
    figures.turning_rad_mm = turning_rad_mm(work);
    let (least_mm, at) = tools_apart(work.tools, [&both[0], &both[1]], &cuts);
    let k = order.get(at).map_or(0, |(_, k)| *k);
    figures.tools_apart_mm = least_mm;
    checks.push(apart_check((least_mm, work.tools_apart_mm), k, &work.rows.places[k].held_centre, work.blade));
    (checks, figures)
}

/// The 99th percentile of the ridges that two threads of a double helix leave, mm, as the check of
/// it measures them; the greater of both tools.
pub fn threads_p99_mm(rows: &PairedRows, part: &Part, scallop_mm: f64) -> f64 {
    if !rows.is_double_helix() || rows.places.len() < 2 {
        return 0.0;
    }
    let part = Allowed::new(part, rows.stock_mm);
    let places: Vec<usize> = (0..rows.places.len()).collect();
    let sweeps = swept(rows, &places, rows.radius_mm, None);
    let of = |tool: usize| sort(ridges(&part, &sweeps, tool, rows, scallop_mm).into_iter().flatten().collect());
    [0, 1].map(|tool| percentile(&of(tool), 0.99)).into_iter().fold(0.0, f64::max)
}

/// The swept balls of both tools from place to place; `wanted`: the moves that count, all where it
/// is left out.
fn swept(rows: &PairedRows, places: &[usize], radius_mm: [f64; 2], wanted: Option<&[bool]>) -> [Sweep; 2] {
    [0, 1].map(|tool| {
        let contact = |k: &usize| &rows.places[*k].contacts[tool];
        Sweep::of(
            places.iter().map(|k| contact(k).centre).collect(),
            places.iter().map(|k| contact(k).contact).collect(),
            places.iter().map(|k| rows.turn_of(tool, *k)).collect(),
            radius_mm[tool],
            wanted.map(<[bool]>::to_vec),
        )
    })
}

/// Every move of every row is cut by some stretch.
fn covered(work: &PinchWork) -> Check {
    let mut cut = vec![false; work.rows.places.len()];
    for Held { places, .. } in work.held {
        for k in places.start..places.end.saturating_sub(1) {
            if let Some(cut) = cut.get_mut(k) {
                *cut = true;
            }
        }
    }
    let of_rows = work.rows.rows.iter().flat_map(|r| r.start..r.end.saturating_sub(1));
    let left = of_rows.filter(|k| !cut[*k]).count();
    let note = format!("{} rows in {} stretches", work.rows.rows.len(), work.held.len());
    Check::at_most(CheckId::PairRows, "moves of rows that no stretch cuts", left as f64, 0.0, "", note)
}

/// Ridges from each row to the next, at the same places for either tool; `None`: there is none.
/// Behind the last row of opposite places come those round the edges, elsewhere. Beside a thread of
/// a double helix lies the other one: below the turn of tool 1 the next of tool 2, below that of
/// tool 2 the same of tool 1. At its ends it is the one above; where the other thread is not there,
/// the next turn of its own.
fn ridges(
    part: &Allowed,
    sweeps: &[Sweep; 2],
    tool: usize,
    of_rows: &PairedRows,
    scallop_mm: f64,
) -> Vec<Option<Height>> {
    let sweep = &sweeps[tool];
    let [held, all] = [of_rows.held_rows(), of_rows.rows.len()].map(|n| n as u32);
    let every = sweep.centres.len().div_ceil(RIDGES);
    let apart_mm = apart_mm(sweep.radius_mm, scallop_mm);
    let of = Ridges { part, sweep, every, apart_mm, slack_mm: REACH_SLACK * scallop_mm };
    let rows: Vec<usize> = (0..sweep.centres.len()).step_by(every).collect();
    // A row may be in pieces, and end amid others: the next is the first that goes past.
    let to_next = |row: usize| {
        let own = sweep.turns[row];
        if of_rows.is_double_helix() {
            let other = |turn: u32| of.beside(row, (&sweeps[1 - tool], turn)).map(|(height, _)| height);
            let [below, above] = if tool == 0 { [Some(own + 1), Some(own)] } else { [Some(own), own.checked_sub(1)] };
            let beside = below.and_then(other).or_else(|| above.and_then(other));
            let own_next = || of.at(row, own + 1).filter(|_| is_nearer_to_itself(sweeps, tool, row));
            return beside.or_else(own_next);
        }
        let end = if own < held { held } else { all };
        (own + 1..end).find_map(|other| of.at(row, other))
    };
    parallel::map(rows, to_next)
}

/// Whether beside a place of a thread its own next turn is nearer than the other thread.
fn is_nearer_to_itself(sweeps: &[Sweep; 2], tool: usize, row: usize) -> bool {
    let (own, other) = (&sweeps[tool], &sweeps[1 - tool]);
    let (here, next, reach) = (&own.centres[row], own.turns[row] + 1, 2.0 * own.radius_mm);
    let away = |found: Option<Nearest>| found.map_or(f64::INFINITY, |n| n.distance_mm);
    away(own.nearest(here, reach, |i| own.turns[i] == next)) < away(other.nearest(here, reach, |_| true))
}

/// Ridges of a tool's rows round its edge to the rows of opposite places beside them, which are its
/// own beside the first row and the other tool's beside the last.
fn border_ridges(part: &Allowed, sweeps: &[Sweep; 2], tool: usize, work: &PinchWork, scallop_mm: f64) -> Vec<Height> {
    let held = work.rows.held_rows();
    if held == 0 || work.rows.edge_rows == 0 {
        return Vec::new();
    }
    let sweep = &sweeps[tool];
    let apart_mm = apart_mm(sweep.radius_mm, scallop_mm);
    let of = Ridges { part, sweep, every: 1, apart_mm, slack_mm: REACH_SLACK * scallop_mm };
    let ends = [held, work.rows.rows.len() - 1];
    let one = |(row, turn): (usize, usize)| {
        // The outermost row that there is at this height: tool 1 begins beyond the first row.
        let inwards = |n: usize| if tool == 0 { n } else { held - 1 - n };
        let beside = |other: usize| {
            (0..held).find_map(|n| of.beside(row, (&sweeps[other], inwards(n) as u32)).map(|(height, _)| height))
        };
        let found = [(ends[0], tool), (ends[1], 1 - tool)].map(|(end, other)| {
            // Of one row both ends are its borders.
            if turn == end { beside(other) } else { None }
        });
        found.into_iter().flatten().collect::<Vec<_>>()
    };
    let rows = (0..sweep.centres.len()).map(|row| (row, sweep.turns[row] as usize));
    parallel::map(rows.filter(|(_, turn)| ends.contains(turn)), one).concat()
}

/// The higher of the ridges of both sides at each place that has one on both, sorted.
fn binding(sides: &[Vec<Option<Height>>]) -> Vec<Height> {
    let [one, two] = sides else { return Vec::new() };
    let higher = |(a, b): (&Option<Height>, &Option<Height>)| {
        let (a, b) = ((*a)?, (*b)?);
        Some(if a.height_mm > b.height_mm { a } else { b })
    };
    sort(one.iter().zip(two).filter_map(higher).collect())
}

/// 5th percentile, median, 95th and 99th percentile and greatest of sorted heights, mm.
fn five(sorted: &[Height]) -> [f64; 5] {
    let [a, b, c, d] = [0.05, 0.5, 0.95, 0.99].map(|q| percentile(sorted, q));
    [a, b, c, d, sorted.last().map_or(0.0, |h| h.height_mm)]
}

fn ridge_check(heights: &[Height], work: &PinchWork, options: &VerifyOptions) -> Check {
    let limit_mm = options.settings.scallop_ratio * options.scallop_mm;
    let p99_mm = percentile(heights, 0.99);
    let note = match heights.last() {
        Some(h) => {
            format!("{} ridges, the greatest {:.6}; asked for {}", heights.len(), h.height_mm, options.scallop_mm)
        }
        None => "there is one row only".into(),
    };
    let point = heights.last().map(|h| work.blade.model_from_blade * h.point);
    Check {
        point_mm: point.map(|p| [p.x, p.y, p.z]),
        ..Check::at_most(CheckId::Ridge, "99th percentile of the ridges between rows", p99_mm, limit_mm, "mm", note)
    }
}

pub(super) fn clearance(a: &Apart, track: Track, blade: &Blade, options: &VerifyOptions) -> Check {
    let limit = options.least_clearance(a.asked_mm);
    let kept = kept(track, a.part, &a.segments, limit, options);
    let id = match (a.obstacle, a.is_holder) {
        (Some(_), _) => CheckId::ObstacleClearance,
        (None, true) => CheckId::HolderClearance,
        (None, false) => CheckId::Clearance,
    };
    let who = a.segments.get(kept.near.segment).map_or_else(String::new, |s| s.part.to_string());
    let note = format!(
        "{who} to {}; measured {:.6}, known to {:.6}; asked for {}",
        a.named(kept.face),
        kept.near.found_mm,
        kept.known_mm,
        a.asked_mm
    );
    let point = kept.face.map(|_| blade.model_from_blade * kept.near.point);
    let quantity = "least distance of the tool without its ball, between places too";
    Check {
        passed: kept.least_mm >= limit,
        point_mm: point.map(|p| [p.x, p.y, p.z]),
        ..Check::at_most(id, quantity, kept.least_mm, limit, "mm", note)
    }
}

/// Distance of the normal lines and angle between the normals, by the part itself: median, 99th
/// percentile and greatest of each, mm and degrees.
type Opposition = ([f64; 3], [f64; 3]);

/// Distance of the normal lines under two ball centres, mm, and half of what the normals' sum is
/// long: the sine of half the angle that they lack of being opposite.
pub(super) fn facing(part: &Part, centres: [&Point; 2]) -> Option<[f64; 2]> {
    let feet = centres.map(|c| {
        let near = part.closest(c, f64::INFINITY)?;
        Some(SurfacePlace { point: near.point, normal: (c - near.point).try_normalize(1e-9)? })
    });
    let [one, two] = [feet[0]?, feet[1]?];
    Some([one.lines_apart_mm(&two), (one.normal + two.normal).norm().clamp(0.0, 2.0) / 2.0])
}

/// Whether the tools hold the part between them; of a double helix, which does not, it is measured
/// and not checked.
fn opposed(work: &PinchWork) -> (Vec<Check>, Opposition) {
    let of = |k: &usize| facing(&work.blade.part, [0, 1].map(|tool| &work.rows.places[*k].contacts[tool].centre));
    let measured = if work.rows.is_double_helix() { work.rows.places.len() } else { work.rows.places_held() };
    let places: Vec<usize> = (0..measured).collect();
    let found: Vec<Option<[f64; 2]>> = parallel::map(&places, of);
    let sorted = |column: usize| {
        let mut all: Vec<f64> = found.iter().map(|f| f.map_or(f64::INFINITY, |f| f[column])).collect();
        all.sort_by(f64::total_cmp);
        [0.5, 0.99, 1.0]
            .map(|q| all.get(((all.len().saturating_sub(1)) as f64 * q).round() as usize).copied().unwrap_or(0.0))
    };
    let lines = sorted(0);
    let angles = sorted(1).map(|half| (2.0 * half.asin()).to_degrees());
    if work.rows.is_double_helix() {
        return (Vec::new(), (lines, angles));
    }
    let line = Check::at_most(
        CheckId::Opposition,
        "99th percentile of the distance of the two normal lines",
        lines[1],
        work.line_distance_mm,
        "mm",
        format!("greatest {:.6}", lines[2]),
    );
    let angle = Check::at_most(
        CheckId::Opposition,
        "what the normals lack of being opposite",
        angles[2],
        work.max_angle_rad.to_degrees() + 1e-6,
        "deg",
        format!("half of them under {:.3}", angles[0]),
    );
    let half = |k: &usize| found[*k].map_or(f64::INFINITY, |f| f[1]);
    let worst = places.iter().copied().max_by(|a, b| half(a).total_cmp(&half(b)));
    let centre = |k: usize| work.blade.model_from_blade * work.rows.places[k].contacts[0].centre;
    let angle = Check { row: worst, point_mm: worst.map(|k| centre(k).coords.into()), ..angle };
    (vec![line, angle], (lines, angles))
}

/// What the axis of each tool turns by from place to place, over the way of its contact: the
/// greatest, rad/mm. Where a contact stands, that of its ball counts.
pub fn turning_rad_mm(work: &PinchWork) -> [f64; 2] {
    [0, 1].map(|j| {
        let axis = |h: &Held, k: usize| work.stand(h, k, j).axis();
        let of = |h: &Held, k: usize| {
            let turned = (axis(h, k + 1) - axis(h, k)).norm();
            let [a, b] = [k, k + 1].map(|k| work.rows.places[k].contacts[j]);
            let [way, over] = [(b.contact - a.contact).norm(), (b.centre - a.centre).norm()];
            if turned == 0.0 { 0.0 } else { turned / if way > 0.0 { way } else { over } }
        };
        let moves = |h: &Held| (h.places.start..h.places.end - 1).map(|k| of(h, k)).fold(0.0, f64::max);
        work.held.iter().filter(|h| !h.places.is_empty()).map(moves).fold(0.0, f64::max)
    })
}

/// How near two tools come to each other at least, mm, over all moves that count, and the first
/// place of the one where they do.
pub(super) fn tools_apart(tools: [&Tool; 2], stands: [&[Stand]; 2], cuts: &[bool]) -> (f64, usize) {
    let segments = tools.map(Tool::segments);
    let stand = |i: usize| {
        [0, 1].map(|j| {
            let at = &stands[j][i];
            solids(&segments[j], tools[j].radius_mm, &at.centre, &at.axis())
        })
    };
    let one = |i: &usize| {
        let here = stand(*i);
        let moves = cuts.get(*i) == Some(&true);
        let next = if moves { stand(*i + 1) } else { stand(*i) };
        // A point at a distance r from a ball centre leaves the chord of its arc by r (1 − cos φ/2)
        // at most.
        let off = |j: usize| {
            let [a, b] = [*i, *i + 1].map(|i| stands[j][i].axis());
            tools[j].reach_mm() * (1.0 - (0.5 * a.angle(&b)).cos())
        };
        let off_mm: f64 = if moves { (0..2).map(off).sum() } else { 0.0 };
        let mut least = f64::INFINITY;
        for (a, a_next) in here[0].iter().zip(&next[0]) {
            for (b, b_next) in here[1].iter().zip(&next[1]) {
                // A direction along which the pieces are apart at both ends of a move shows so much
                // all the way, but for arcs, since both go straight and evenly.
                let along = [a.towards(b), a_next.towards(b_next), a.between(b)].into_iter().flatten();
                let apart = along.map(|d| a.gap_mm(b, &d).min(a_next.gap_mm(b_next, &d)));
                least = least.min(apart.fold(f64::NEG_INFINITY, f64::max));
            }
        }
        (least - off_mm, *i)
    };
    let rows: Vec<usize> = (0..stands[0].len()).collect();
    let all: Vec<(f64, usize)> = parallel::map(&rows, one);
    all.into_iter().min_by(|a, b| a.0.total_cmp(&b.0)).unwrap_or((f64::INFINITY, 0))
}

/// The check of that, at a place.
fn apart_check((least_mm, asked_mm): (f64, f64), place: usize, at: &Point, blade: &Blade) -> Check {
    let point = blade.model_from_blade * at;
    let quantity = "least distance of the two tools, between places too";
    let note = format!("place {place}; asked for {asked_mm}");
    Check {
        passed: least_mm >= asked_mm,
        row: Some(place),
        point_mm: Some([point.x, point.y, point.z]),
        ..Check::at_most(CheckId::ToolsApart, quantity, least_mm, asked_mm, "mm", note)
    }
}

/// A ball, or the frustum of a cone, where it stands.
pub(super) enum ToolSolid {
    Ball { centre: Point, radius_mm: f64 },
    Frustum { ends: [Point; 2], radii_mm: [f64; 2], axis: Vector },
}

/// The pieces of a tool that stands somewhere, its ball first.
pub(super) fn solids(segments: &[Segment], radius_mm: f64, centre: &Point, axis: &Vector) -> Vec<ToolSolid> {
    let frustum = |s: &Segment| ToolSolid::Frustum {
        ends: [s.z0, s.z1].map(|z| centre + axis * z),
        radii_mm: [s.r0, s.r1],
        axis: *axis,
    };
    std::iter::once(ToolSolid::Ball { centre: *centre, radius_mm }).chain(segments.iter().map(frustum)).collect()
}

impl ToolSolid {
    /// The point farthest along a direction.
    pub(super) fn farthest(&self, along: &Vector) -> Point {
        match self {
            ToolSolid::Ball { centre, radius_mm } => {
                centre + along.try_normalize(1e-300).unwrap_or_default() * *radius_mm
            }
            ToolSolid::Frustum { ends, radii_mm, axis } => {
                let across = along - axis * along.dot(axis);
                let out = across.try_normalize(1e-300).unwrap_or_default();
                let [a, b] = [0, 1].map(|k| ends[k] + out * radii_mm[k]);
                if a.coords.dot(along) > b.coords.dot(along) { a } else { b }
            }
        }
    }

    /// How far this one is from another along a unit direction, mm.
    fn gap_mm(&self, other: &ToolSolid, along: &Vector) -> f64 {
        self.farthest(&-along).coords.dot(along) - other.farthest(along).coords.dot(along)
    }

    /// The direction from the middle of another to that of this one.
    pub(super) fn between(&self, other: &ToolSolid) -> Option<Vector> {
        (self.middle() - other.middle()).try_normalize(1e-9)
    }

    /// The direction from another to this one along which both are farthest apart; `None` where
    /// they meet.
    pub(super) fn towards(&self, other: &ToolSolid) -> Option<Vector> {
        let start = self.between(other)?;
        let mut simplex = VoronoiSimplex::new();
        let still = Pose::default();
        simplex.reset(CsoPoint::from_shapes(&still, self, other, ParryVector::new(-start.x, -start.y, -start.z)));
        match gjk::closest_points(&still, self, other, f64::MAX, true, &mut simplex) {
            GJKResult::ClosestPoints(p, q, _) => Vector::new(p.x - q.x, p.y - q.y, p.z - q.z).try_normalize(1e-12),
            GJKResult::Intersection => None,
            // The search has ended without points.
            GJKResult::Proximity(_) | GJKResult::NoIntersection(_) => Some(start),
        }
    }

    fn middle(&self) -> Point {
        match self {
            ToolSolid::Ball { centre, .. } => *centre,
            ToolSolid::Frustum { ends, .. } => nalgebra::center(&ends[0], &ends[1]),
        }
    }
}

impl SupportMap for ToolSolid {
    fn local_support_point(&self, dir: ParryVector) -> ParryVector {
        let p = self.farthest(&Vector::new(dir.x, dir.y, dir.z));
        ParryVector::new(p.x, p.y, p.z)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Sides bind in turn; a place with a ridge on one side alone says nothing of which binds.
    #[test]
    fn the_higher_side_binds_at_each_place() {
        let side = |heights: [Option<f64>; 4]| -> Vec<Option<Height>> {
            let at = |(row, h): (usize, Option<f64>)| {
                h.map(|height_mm| Height { height_mm, point: Point::origin(), row, weight: 1.0 })
            };
            heights.into_iter().enumerate().map(at).collect()
        };
        let sides = [side([Some(0.4), Some(0.1), None, Some(0.3)]), side([Some(0.2), Some(0.5), Some(9.0), None])];
        let found: Vec<(f64, usize)> = binding(&sides).iter().map(|h| (h.height_mm, h.row)).collect();
        assert_eq!(found, [(0.4, 0), (0.5, 1)]);
        assert_eq!(five(&binding(&sides))[4], 0.5);
        assert!(binding(&sides[..1]).is_empty());
    }
}
