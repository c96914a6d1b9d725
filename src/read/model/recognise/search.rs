//! The blade axis: the direction along which sections look like an airfoil for longest.
//!
//! In: the part's mesh; perhaps the line along which a table stacks its sections. Out: the best
//! [`Run`], its sense from root to tip, why, and a doubt where the geometry does not decide.
//!
//! Candidates are the coordinate axes, principal axes of the surface and of its normals, and the
//! normals of flat patches. Each good run proposes two better directions: that in which its normals
//! have the least share, and the line through the middles of its sections. A direction that its own
//! run contradicts scores less ([`run`]), so what wins is (nearly) a fixed point, and a cut aslant
//! through the same airfoil is no rival. A datum direction near the winner, coordinate axis or
//! normal of flat faces, is taken for it, as blades are drawn and mounted along datum directions.
//!
//! What sections leave open, two other marks may decide: the ends of an airfoil alone
//! ([`caps::end_to_end`]), and where a part stands in its rotor ([`rotor`]).

use nalgebra::Matrix3;

use super::caps::{self, AirfoilEnds, FlatPatch};
use super::run::{self, Run};
use super::{DOUBTFUL, named, rotor, words};
use crate::error::{Error, Result, Stage};
use crate::geometry::Vector;
use crate::geometry::mesh::{Mesh, edge_uses};
use crate::observe::Remark;
use crate::parallel;
use crate::read::model::faces::Stacking;

/// A datum direction within this angle of the best one is taken without further ado, degrees …
const SNAP_DEG: f64 = 3.0;
/// … and a coordinate axis, or the common normal of two flat patches, within this angle where it
/// scores at least [`DATUM_SCORE`] of the best.
const DATUM_DEG: f64 = 15.0;
/// See [`DATUM_DEG`].
const DATUM_SCORE: f64 = 0.65;
/// Normals of flat patches within this angle are common, degrees.
const COMMON_DEG: f64 = 0.5;

/// Sections that are no airfoils and cover less than this share of the part are no blade either.
const COVERED: f64 = 0.4;
/// A lid with an airfoil's outline at an end of the run is worth this much of its score.
const LID: f64 = 1.0;
/// A direction farther than this from the chosen one, degrees, that scores this share of it, is
/// reported to the user.
const RIVAL_DEG: f64 = 35.0;
/// See [`RIVAL_DEG`].
const RIVAL: f64 = 0.5;
/// The blade of a sector stands at least this far off the rotor axis, degrees.
const OFF_SHAFT_DEG: f64 = 45.0;
/// As [`RIVAL_DEG`] where the chosen direction is a radius on which the part stands off its shaft:
/// what lies nearer cuts the same blade aslant.
const LEANS_DEG: f64 = 60.0;
/// Two runs with measures within this ratio, in different places, are two airfoils.
const ALIKE: f64 = 0.8;
/// Where the middles of the sections run farther than this from the direction of the sections,
/// degrees, the blade leans so much that either may be meant.
const LEAN_DEG: f64 = 25.0;
/// Rounds in which runs propose better directions.
const ROUNDS: usize = 4;
/// Runs that score this share of the best propose.
const PROPOSES: f64 = 0.3;

/// The axis that the search settled on.
pub struct FoundAxis {
    /// The run along it, from root to tip.
    pub run: Run,
    /// Axis and sense, and why.
    pub reason: String,
    /// Why the root is at the low end; `None` where nothing tells the ends apart.
    pub sense: Option<String>,
    /// Why the axis is not certain.
    pub doubt: Option<Remark>,
}

/// The best run of all candidates, its sense from root to tip, and why. `faces`: as for
/// [`run::along`]; `rotor`: axis of the wheel that the part is a sector of.
///
/// # Errors
/// `InputOutput`: no direction along which sections continue; several airfoils; nothing like an
/// airfoil.
pub fn search(mesh: &Mesh, faces: Option<&[bool]>, rotor: Option<&Vector>) -> Result<FoundAxis> {
    let sides = edge_uses(&mesh.triangles);
    let patches = caps::patches(mesh, &sides);
    let along = |d: &Vector| run_along(mesh, d, faces, &patches);
    let mut runs = tried(mesh, &patches, along);
    // A sector's sections along its rotor axis are cut through blade, hub and plate at once.
    let off = |r: &Run| rotor.is_none_or(|axis| between_deg(axis, &r.direction) > OFF_SHAFT_DEG);
    if runs.iter().any(|r| off(r) && r.score > 0.0) {
        runs.retain(off);
    }
    let top = best(&runs).map(|top| drawn(&runs, top)).ok_or_else(|| named::nothing(mesh, &candidates(mesh), faces))?;
    let (mut chosen, mut why) = datum(&mut runs, top, &patches, along);
    let radius = rotor::radius(mesh);
    let along_radius = radius.and_then(|k| coordinate(&runs, k));
    if let Some(k) = along_radius.filter(|&k| stands(&runs[k], &runs[chosen], &patches)) {
        why = format!(
            "the coordinate axis {:.1}° from the direction in which sections look most like an airfoil, along which alone the part \
             stands clear of the origin, as a blade of its shaft",
            between_deg(&runs[k].direction, &runs[chosen].direction)
        );
        chosen = k;
    }
    // Faces that the user named are the airfoil, whatever they look like.
    if faces.is_none() {
        refuse_wheels(&runs, chosen)?;
    }
    let ends = caps::end_to_end(mesh, &sides, &patches);
    let mut doubt = doubted(mesh, &runs, chosen, &patches, ends, radius);
    let mut sense = None;
    if let Some(other) = aslant(&runs[chosen], &patches, ends) {
        let run = along(&other.line);
        if run.links.len() > 1 {
            (doubt, why, sense) = (Some(other.doubt), other.why.into(), other.sense);
            runs.push(run);
            chosen = runs.len() - 1;
        }
    }
    let (flip, sense) = sense.unwrap_or_else(|| root_is_high(mesh, &runs[chosen]));
    let run = runs.swap_remove(chosen);
    let direction = if flip { -run.direction } else { run.direction };
    let run = if flip { run::along(mesh, &direction, faces) } else { run };
    let reason = format!("axis: {}, {why}; {sense}", words(&direction));
    Ok(FoundAxis { run, reason, sense: Some(sense).filter(|s| s != ENDS_ALIKE), doubt })
}

/// The run along the line of a table's sections, from the first to the last.
///
/// # Errors
/// `InputOutput`: no sections along it.
pub fn stacked(mesh: &Mesh, stacking: &Stacking, faces: Option<&[bool]>) -> Result<FoundAxis> {
    let (mut direction, what) = if stacking.parallel {
        (stacking.normal, "normal to the sections of the table, which are parallel planes")
    } else {
        (stacking.line, "the line through the middles of the table's sections")
    };
    let mut run = run::along(mesh, &direction, faces);
    let (axis, off_deg) = nearest_axis(&direction);
    let snap = axis * direction[axis.iamax()].signum();
    let mut why = format!("{what}, {off_deg:.1}° from the nearest coordinate axis");
    if off_deg < DATUM_DEG {
        let at = run::along(mesh, &snap, faces);
        if !at.links.is_empty() && (off_deg < SNAP_DEG || at.score > DATUM_SCORE * run.score) {
            (run, direction) = (at, snap);
            why = format!("the coordinate axis {off_deg:.1}° from {what}");
        }
    }
    if run.links.is_empty() {
        return Err(named::nothing(mesh, &[direction], faces));
    }
    let lean_deg = stacking.line.angle(&stacking.normal).to_degrees();
    let growth = stacking.growth;
    let doubt = if lean_deg > LEAN_DEG && !stacking.parallel {
        Some(leaning(&stacking.line, &stacking.normal, lean_deg))
    } else if growth > GROWS {
        Some(Remark::RootNotCertain { growth })
    } else {
        fading(&run, 0)
    };
    let sense = "root at the table's first section".to_owned();
    let reason = format!("axis: {}, {why}; {sense}", words(&direction));
    Ok(FoundAxis { run, reason, sense: Some(sense), doubt })
}

/// A table whose last section is larger than the first by this factor may run from tip to root.
const GROWS: f64 = 1.5;

/// A run with its lids counted.
fn run_along(mesh: &Mesh, d: &Vector, faces: Option<&[bool]>, patches: &[FlatPatch]) -> Run {
    let mut run = run::along(mesh, d, faces);
    run.score *= 1.0 + LID * caps::airfoil_lids(patches, &run);
    run
}

/// Runs along all candidates and along what good runs propose.
fn tried(mesh: &Mesh, patches: &[FlatPatch], along: impl Fn(&Vector) -> Run + Sync) -> Vec<Run> {
    let mut directions = candidates(mesh);
    directions.extend(caps::directions(patches));
    let mut runs: Vec<Run> = parallel::map(&directions, &along);
    let mut from = 0;
    for _ in 0..ROUNDS {
        let least = PROPOSES * runs.iter().map(|r| r.score).fold(0.0, f64::max);
        let mut next: Vec<Vector> = Vec::new();
        for r in runs[from..].iter().filter(|r| r.score > least) {
            for d in [r.least_normal, r.stack] {
                // What was tried within half a degree says nothing new.
                if !directions.iter().any(|t| t.dot(&d).abs() > 0.5f64.to_radians().cos()) {
                    directions.push(d);
                    next.push(d);
                }
            }
        }
        from = runs.len();
        runs.extend(parallel::map(&next, &along));
    }
    runs
}

/// The run with the greatest score, the first of equals; `None` where none has sections.
fn best(runs: &[Run]) -> Option<usize> {
    (0..runs.len())
        .filter(|&i| !runs[i].links.is_empty())
        .max_by(|&i, &j| runs[i].score.total_cmp(&runs[j].score).then(j.cmp(&i)))
        .filter(|&i| runs[i].score > 0.0)
}

/// Where the best run is oblique, one nearly along a coordinate axis that scores nearly as much:
/// blades are drawn along datum directions. The oblique one stays its rival.
fn drawn(runs: &[Run], top: usize) -> usize {
    let along = |i: usize| nearest_axis(&runs[i].direction).1 < DATUM_DEG;
    if along(top) {
        return top;
    }
    (0..runs.len())
        .filter(|&i| along(i) && !runs[i].links.is_empty() && runs[i].score > DRAWN * runs[top].score)
        .max_by(|&i, &j| runs[i].score.total_cmp(&runs[j].score).then(j.cmp(&i)))
        .unwrap_or(top)
}

/// See [`drawn`]: share of the best score.
const DRAWN: f64 = 0.85;

/// Coordinate axis nearest to a direction, either sense, and the angle, degrees.
fn nearest_axis(direction: &Vector) -> (Vector, f64) {
    let k = (0..3).max_by(|&i, &j| direction[i].abs().total_cmp(&direction[j].abs()).then(j.cmp(&i))).unwrap_or(0);
    let mut axis = Vector::zeros();
    axis[k] = 1.0;
    (axis, direction[k].abs().clamp(0.0, 1.0).acos().to_degrees())
}

/// The datum direction for the best run, or the run itself, and why.
fn datum(runs: &mut Vec<Run>, top: usize, patches: &[FlatPatch], along: impl Fn(&Vector) -> Run) -> (usize, String) {
    let (direction, score) = (runs[top].direction, runs[top].score);
    let (axis, off_deg) = nearest_axis(&direction);
    let k = axis.iamax();
    let told =
        || format!("the coordinate axis {off_deg:.1}° from the direction in which sections look most like an airfoil");
    // The run along the axis was among the candidates.
    let at_axis = coordinate(runs, k).filter(|&at| !runs[at].links.is_empty());
    if let Some(at) = at_axis.filter(|_| off_deg < SNAP_DEG) {
        return (at, told());
    }
    for (normal, common) in caps::flat_normals(patches, COMMON_DEG) {
        let flat_deg = normal.dot(&direction).abs().clamp(0.0, 1.0).acos().to_degrees();
        if flat_deg > if common { DATUM_DEG.min(off_deg) } else { SNAP_DEG } {
            continue;
        }
        let run = along(&(normal * normal.dot(&direction).signum()));
        if !run.links.is_empty() && (flat_deg < SNAP_DEG || run.score > DATUM_SCORE * score) {
            runs.push(run);
            let why = format!(
                "normal to flat faces, {flat_deg:.1}° from the direction in which sections look most like an airfoil"
            );
            return (runs.len() - 1, why);
        }
    }
    // Farther away only where the sections across the axis do not say that the blade runs aslant to
    // it.
    let lean_deg = |r: &Run| r.stack.dot(&r.direction).abs().clamp(0.0, 1.0).acos().to_degrees();
    let straight = |at: usize| lean_deg(&runs[at]) < 2.0 * lean_deg(&runs[top]) + SNAP_DEG;
    // … or where flat faces along or across it say that the part is drawn along it and the blade
    // leans.
    let aligned = caps::flat_normals(patches, COMMON_DEG).iter().any(|(n, _)| {
        let along = n.dot(&axis).abs();
        along < COMMON_DEG.to_radians().sin() || along > COMMON_DEG.to_radians().cos()
    });
    let near = at_axis.filter(|&at| runs[at].score > DATUM_SCORE * score && (straight(at) || aligned));
    if let Some(at) = near.filter(|_| off_deg < DATUM_DEG) {
        return (at, told());
    }
    let why = format!(
        "the direction in which sections look most like an airfoil, {off_deg:.1}° from the nearest coordinate axis"
    );
    (top, why)
}

/// The run along coordinate axis `k`, 0 to 2.
fn coordinate(runs: &[Run], k: usize) -> Option<usize> {
    runs.iter().position(|r| nearest_axis(&r.direction) == (Vector::ith(k, 1.0), 0.0))
}

/// Angle between two lines, degrees.
fn between_deg(a: &Vector, b: &Vector) -> f64 {
    (a.dot(b) / (a.norm() * b.norm())).abs().clamp(0.0, 1.0).acos().to_degrees()
}

/// Whether the blade stands along the first run rather than along the second, whose sections are
/// cut short by its ends: along the first they are so less, and look like an airfoil over as much
/// of the surface. Normals are not asked, since those of a wide blade with much twist say little.
fn stands(radius: &Run, chosen: &Run, patches: &[FlatPatch]) -> bool {
    if fading(chosen, caps::lids(patches, chosen)).is_none() || radius.covered() < chosen.covered() {
        return false;
    }
    let off_deg = between_deg(&radius.direction, &chosen.direction);
    let much = |r: &Run| r.share * r.free;
    let enough = |of: &dyn Fn(&Run) -> f64| of(radius) > STANDS * of(chosen);
    !radius.links.is_empty() && off_deg > 0.0 && off_deg < STANDS_DEG && enough(&much) && enough(&|r| r.likeness)
}

/// See [`stands`]: share of what is found along the best direction …
const STANDS: f64 = 0.8;
/// … and the farthest that this one may be, degrees.
const STANDS_DEG: f64 = 30.0;

/// Why the chosen axis is not certain; `None` where it is. Two marks that do not come from sections
/// make it certain against other directions: the line from one end of an airfoil to the other, and
/// a radius on which the part stands off its shaft.
fn doubted(
    mesh: &Mesh,
    runs: &[Run],
    chosen: usize,
    patches: &[FlatPatch],
    ends: Option<AirfoilEnds>,
    radius: Option<usize>,
) -> Option<Remark> {
    let run = &runs[chosen];
    let ended = ends.is_some_and(|e| between_deg(&e.line, &run.direction) < DATUM_DEG);
    let stood = radius.is_some_and(|k| nearest_axis(&run.direction) == (Vector::ith(k, 1.0), 0.0));
    let near_deg = if stood { LEANS_DEG } else { RIVAL_DEG };
    let other = || rival(runs, chosen, near_deg, rotor::shaft(mesh).map(|k| Vector::ith(k, 1.0)));
    let short = || fading(run, caps::lids(patches, run));
    (!ended)
        .then(other)
        .flatten()
        .or_else(|| (!ended && !stood).then(short).flatten())
        .or_else(|| slanted(run, patches))
}

/// A line that is taken instead of the direction of the sections.
struct Other {
    line: Vector,
    why: &'static str,
    doubt: Remark,
    /// Whether the root is at its high end, and why, where the ends show it.
    sense: Option<(bool, String)>,
}

/// The line to take where the blade leans; also where both ends of an airfoil are known, curved or
/// askew, and no section square to the direction comes near them. `None`: neither.
fn aslant(run: &Run, patches: &[FlatPatch], ends: Option<AirfoilEnds>) -> Option<Other> {
    const WHY: &str = "the line from the middle of one end to that of the other";
    let sense = |e: AirfoilEnds| {
        (e.ratio > TAPERS).then(|| (false, format!("root at the larger of both ends, by {:.1} times", e.ratio)))
    };
    let d = run.direction;
    let lean_deg = between_deg(&run.stack, &d);
    if lean_deg > LEAN_DEG {
        let (line, why) = match ends {
            Some(e) => (e.line, WHY),
            None => (run.stack, "the line through the middles of the sections"),
        };
        let told = line * line.dot(&run.stack).signum();
        return Some(Other { line, why, doubt: leaning(&told, &d, lean_deg), sense: ends.and_then(sense) });
    }
    let ends = ends.filter(|e| !e.flat && between_deg(&e.line, &d) > LEAN_DEG && caps::lids(patches, run) == 0)?;
    let doubt = Remark::EndsNotReached { square_to: d.into() };
    Some(Other { line: ends.line, why: WHY, doubt, sense: sense(ends) })
}

/// Where one end of an airfoil is larger than the other by this factor it is the root's.
const TAPERS: f64 = 1.5;

/// The best run far from the chosen one, in words, where it scores nearly as much as what is near
/// the chosen one. Not along the shaft of the rotor where that is known and the chosen one stands
/// off it: the flow runs there, and no blade.
fn rival(runs: &[Run], chosen: usize, near_deg: f64, shaft: Option<Vector>) -> Option<Remark> {
    let axis = runs[chosen].direction;
    let off = |r: &&Run, d: &Vector, deg: f64| between_deg(&r.direction, d) > deg;
    let shaft = shaft.filter(|s| between_deg(s, &axis) > 90.0 - RIVAL_DEG);
    let far = |r: &&Run| off(r, &axis, near_deg) && shaft.is_none_or(|s| off(r, &s, RIVAL_DEG));
    let best = runs.iter().filter(far).max_by(|a, b| a.score.total_cmp(&b.score))?;
    let own = runs.iter().filter(|r| !off(r, &axis, near_deg)).map(|r| r.score).fold(0.0, f64::max);
    let scores = [best.score, own];
    (best.score > RIVAL * own).then(|| Remark::AxisRivalled { other: best.direction.into(), scores })
}

/// What is said where sections fade out towards the ends, with no flat end and nothing larger that
/// closes the airfoil there.
fn fading(run: &Run, lids: usize) -> Option<Remark> {
    let length = run.part_mm[1] - run.part_mm[0];
    let (first, last) = (run.links.first()?, run.links.last()?);
    let gaps = [first.height_mm - run.part_mm[0], run.part_mm[1] - last.height_mm];
    let faded: f64 = gaps.iter().zip(run.body).filter(|(_, body)| !body).map(|(g, _)| g / length).sum();
    (faded > FADED && lids == 0).then_some(Remark::EndsCutSections { share: faded })
}

/// What is said where both ends are flat, parallel, and far from square to the axis.
fn slanted(run: &Run, patches: &[FlatPatch]) -> Option<Remark> {
    let normal = caps::slanted_ends(patches, run, COMMON_DEG, LEAN_DEG)?;
    let off_deg = normal.dot(&run.direction).abs().clamp(0.0, 1.0).acos().to_degrees();
    Some(Remark::EndsSlanted { normal: normal.into(), off_deg })
}

/// Share of the part's length that sections may be cut short by slanted ends before the axis is
/// doubted.
const FADED: f64 = 0.25;

/// What is said of a blade whose sections are far from square to its length.
fn leaning(line: &Vector, sections: &Vector, lean_deg: f64) -> Remark {
    Remark::BladeLeans { middle: (*line).into(), square_to: (*sections).into(), lean_deg }
}

/// # Errors
/// Where the part is not one blade: several airfoils alike, or none over a good part of it.
fn refuse_wheels(runs: &[Run], chosen: usize) -> Result<()> {
    let run = &runs[chosen];
    let wide = run.links.iter().map(|l| l.shape.perimeter_mm).sum::<f64>() / run.links.len().max(1) as f64;
    let mean_area = |r: &Run| r.links.iter().map(|l| l.shape.area_mm2).sum::<f64>() / r.links.len().max(1) as f64;
    let near = |a: f64, b: f64| a.min(b) > ALIKE * a.max(b);
    let elsewhere = runs.iter().any(|r| {
        near(r.score, run.score)
            && near(mean_area(r), mean_area(run))
            && near(r.covered(), run.covered())
            && (r.middle - run.middle).norm() > 0.5 * wide
    });
    let what = if run.twin || elsewhere {
        "several airfoils are alike"
    } else if run.likeness < DOUBTFUL && run.covered() < COVERED {
        "in no direction do sections look like one airfoil for long"
    } else {
        return Ok(());
    };
    Err(Error::io(
        Stage::Model,
        format!(
            "no single blade was found: {what} (at best over {:.0} % of the part, likeness {:.2}); a whole wheel or several \
             blades look like this",
            100.0 * run.covered(),
            run.likeness
        ),
    )
    .advise("export one blade with its platform, or give the blade's axis with --axis"))
}

/// Directions to try: coordinate axes, principal axes of the surface, eigenvectors of its normals'
/// covariance.
fn candidates(mesh: &Mesh) -> Vec<Vector> {
    let mut out = vec![Vector::x(), Vector::y(), Vector::z()];
    let (mut area, mut centre) = (0.0, Vector::zeros());
    for t in 0..mesh.triangles.len() {
        let [a, b, c] = mesh.corners(t);
        let w = mesh.triangle_area_mm2(t);
        area += w;
        centre += w * (a.coords + b.coords + c.coords) / 3.0;
    }
    if area <= 0.0 {
        return out;
    }
    centre /= area;
    let (mut spread, mut normals) = (Matrix3::zeros(), Matrix3::zeros());
    for t in 0..mesh.triangles.len() {
        let [a, b, c] = mesh.corners(t);
        let w = mesh.triangle_area_mm2(t);
        let r = (a.coords + b.coords + c.coords) / 3.0 - centre;
        let n = mesh.normal(t);
        spread += w * r * r.transpose();
        normals += w * n * n.transpose();
    }
    for m in [spread, normals] {
        let eigen = m.symmetric_eigen();
        out.extend(eigen.eigenvectors.column_iter().map(|c| c.into_owned()));
    }
    out
}

/// Surface beyond one end of the airfoil that is more by this share of the whole than that beyond
/// the other is a platform or root …
const BODY_BEYOND: f64 = 0.2;
/// … and by this share may come from the shape of the ends.
const LITTLE_BEYOND: f64 = 0.05;
/// An end this near to the origin, as a share of the part's length, counts as at the origin.
const AT_ORIGIN: f64 = 0.05;

/// Whether the root lies at the high end of the run, and why.
fn root_is_high(mesh: &Mesh, run: &Run) -> (bool, String) {
    let (Some(low), Some(high)) = (run.links.first(), run.links.last()) else { return (false, String::new()) };
    let (mut below, mut above) = (0.0, 0.0);
    for t in 0..mesh.triangles.len() {
        let [a, b, c] = mesh.corners(t);
        let h = (a.coords + b.coords + c.coords).dot(&run.direction) / 3.0;
        let w = mesh.triangle_area_mm2(t);
        if h < low.height_mm {
            below += w;
        } else if h > high.height_mm {
            above += w;
        }
    }
    let total = mesh.area_mm2();
    let (big, small) = (below.max(above), below.min(above));
    let beyond = || {
        let share = |x: f64| 100.0 * x / total;
        format!(
            "root where {:.0} % of the surface lies beyond the airfoil ({:.0} % at the tip)",
            share(big),
            share(small)
        )
    };
    if big - small > BODY_BEYOND * total {
        return (above > below, beyond());
    }
    // An airfoil alone is drawn upwards from the origin, or where it stands in its rotor, whose
    // axis passes the origin.
    let [lo, hi] = run.part_mm;
    let room = AT_ORIGIN * (hi - lo);
    if lo > -room || hi < room {
        return (hi < room, "root at the end nearer to the model's origin".into());
    }
    if big - small > LITTLE_BEYOND * total {
        return (above > below, beyond());
    }
    let (a, b) = (low.shape.area_mm2, high.shape.area_mm2);
    if a.max(b) > 1.02 * a.min(b) {
        return (b > a, format!("tip where sections are smaller ({:.1} against {:.1} mm²)", a.min(b), a.max(b)));
    }
    // Nothing tells the ends apart: the tip is taken where the coordinate grows.
    let main = run.direction.iamax();
    (run.direction[main] < 0.0, ENDS_ALIKE.into())
}

/// Said where nothing tells root and tip apart.
const ENDS_ALIKE: &str = "both ends are alike, so root to tip was taken along the growing coordinate";

#[cfg(test)]
mod tests {
    use super::*;
    use crate::read::model::sample;

    /// The run along the sample's axis, as if it were along another direction with another score.
    fn along(direction: [f64; 3], score: f64) -> Run {
        let direction = Vector::from(direction).normalize();
        Run { direction, score, ..run::along(&sample::blade(), &Vector::z(), None) }
    }

    #[test]
    fn a_direction_along_the_shaft_is_no_rival_of_a_blade_that_stands_off_it() {
        let runs = [along([0.0, 0.0, 1.0], 1.0), along([0.9, 0.1, -0.2], 0.8)];
        let told = |shaft: Option<Vector>| rival(&runs, 0, RIVAL_DEG, shaft).is_some();
        assert!(told(None) && !told(Some(Vector::x())) && told(Some(Vector::y())));
        assert!(told(Some(Vector::z())), "what was chosen lies along the shaft itself");
    }

    #[test]
    fn a_rival_is_weighed_against_the_best_near_the_chosen_one() {
        let mut runs = vec![along([0.0, 0.0, 1.0], 0.6), along([1.0, 0.0, 0.0], 0.45)];
        assert!(rival(&runs, 0, RIVAL_DEG, None).is_some());
        runs.push(along([0.1, 0.0, 1.0], 1.0));
        assert!(rival(&runs, 0, RIVAL_DEG, None).is_none());
    }

    #[test]
    fn a_radius_is_taken_where_sections_are_cut_short_less_along_it() {
        // So much of the part beyond either end of the sections, as a share of the airfoil.
        let beyond = |mut r: Run, share: f64| {
            let [lo, hi] = [0, r.links.len() - 1].map(|k| r.links[k].height_mm);
            r.part_mm = [lo - share * (hi - lo), hi + share * (hi - lo)];
            r.body = [false; 2];
            r
        };
        let aslant = || beyond(along([0.94, 0.34, 0.0], 1.0), 0.25);
        let radius = || beyond(along([1.0, 0.0, 0.0], 0.3), 0.2);
        assert!(stands(&radius(), &aslant(), &[]));
        assert!(!stands(&beyond(radius(), 0.3), &aslant(), &[]), "cut short more");
        assert!(!stands(&radius(), &beyond(aslant(), 0.1), &[]), "the other is not cut short");
        assert!(!stands(&Run { share: 0.5 * radius().share, ..radius() }, &aslant(), &[]), "less airfoil");
        assert!(
            !stands(&radius(), &Run { direction: Vector::new(0.7, 0.7, 0.0).normalize(), ..aslant() }, &[]),
            "too far"
        );
    }
}
