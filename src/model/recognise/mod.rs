//! Finds the blade axis and the regions of a part from its mesh.
//!
//! In: a closed mesh in the model frame, mm; perhaps the axis, if the user gave it. Out: the blade frame and the
//! [`Regions`]. Method: every candidate direction (coordinate axes; principal axes of the surface; the direction least
//! present in the normals, which on a blade is nearly its axis since an airfoil is nearly a generalised cylinder; the
//! normals of flat patches, which may be the blade's ends ([`caps`])) is cut
//! at [`run::HEIGHTS`] heights. Along the chain of loops that looks most like an airfoil for longest the normals give a
//! better direction, which is tried in turn. The best direction wins, but a coordinate axis near it wins over it, as
//! blades are drawn and mounted along datum directions. The root is the side with more of the part beyond the airfoil.
//!
//! Guarantees: deterministic; the same part turned by a rotation gives the same regions (up to the sampling of heights,
//! and up to the preference for coordinate axes). Limits: one airfoil; several blades on a disc are not told apart.

pub mod areas;
pub mod caps;
pub mod named;
pub mod regions;
pub mod run;
pub mod shape;

use nalgebra::Matrix3;
use rayon::prelude::*;

use super::ModelOptions;
use crate::artifact::blade::Regions;
use crate::error::{Error, Result, Stage};
use crate::geometry::bvh::MeshBvh;
use crate::geometry::mesh::Mesh;
use crate::geometry::{Point, Rigid, Vector};
use run::Run;

/// A coordinate axis within this angle of the best direction is taken without further ado, degrees …
const SNAP_DEG: f64 = 3.0;
/// … and within this angle where it scores at least [`DATUM_SCORE`] of the best.
const DATUM_DEG: f64 = 15.0;
/// See [`DATUM_DEG`].
const DATUM_SCORE: f64 = 0.65;
/// Below this mean likeness the sections are steady but not airfoils …
const DOUBTFUL: f64 = 0.25;
/// … and below this one they carry something besides an airfoil.
const PARTLY: f64 = 0.55;

/// Sections that are no airfoils and cover less than this share of the part are no blade either.
const COVERED: f64 = 0.4;
/// A lid at an end of the run is worth this much of its score.
const LID: f64 = 1.0;
/// A direction farther than this from the chosen one, degrees, that scores this share of it, is told to the user.
const RIVAL_DEG: f64 = 35.0;
/// See [`RIVAL_DEG`].
const RIVAL: f64 = 0.5;

/// What was recognised.
pub struct Recognised {
    /// Blade frame to model frame.
    pub model_from_blade: Rigid,
    /// The part's mesh in the blade frame.
    pub mesh: Mesh,
    /// Regions, with reasons (the axis first).
    pub regions: Regions,
    /// What the user should know.
    pub doubts: Vec<String>,
    /// Boxes around the airfoil's sections: height, then least y, least z, greatest y, greatest z, blade frame, mm.
    pub outline: Vec<(f64, [f64; 4])>,
}

/// Finds axis and regions.
///
/// # Errors
/// `Usage`: an axis of no length. `InputOutput`: no direction along which sections continue.
pub fn recognise(mesh: &Mesh, face_names: &[String], options: &ModelOptions) -> Result<Recognised> {
    let airfoil = named::faces(&options.airfoil_faces, face_names)?;
    let airfoil = airfoil.as_deref();
    let mut doubts = Vec::new();
    let (mut run, reason) = match options.axis {
        Some(a) => given(mesh, a, airfoil)?,
        None => {
            let found = search(mesh, airfoil)?;
            doubts.extend(found.rival);
            (found.run, found.reason)
        }
    };
    if run.likeness < DOUBTFUL {
        doubts.push(format!(
            "no section looks like an airfoil (likeness {:.2}): the longest steady run of sections was taken; \
             give the axis if it is wrong",
            run.likeness
        ));
    } else if run.likeness < PARTLY {
        doubts.push(format!(
            "sections look only partly like an airfoil (likeness {:.2}): something seems to be attached to the blade, \
             such as a back plate, a web or another blade",
            run.likeness
        ));
    }
    let (model_from_blade, origin) = frame(&run);
    for link in &mut run.links {
        link.shape = link.shape.seen_from(origin);
    }
    let blade_mesh = mesh.clone().moved(&model_from_blade.inverse());
    let bvh = MeshBvh::new(&blade_mesh);
    let mut regions = regions::find(&blade_mesh, &bvh, &run).ok_or_else(no_blade)?;
    regions.reasons.insert(0, reason);
    named::apply(&mut regions, &blade_mesh, face_names, options)?;
    let outline = run.links.iter().map(|l| (l.height_mm, l.shape.bounds)).collect();
    Ok(Recognised { model_from_blade, mesh: blade_mesh, regions, doubts, outline })
}

fn no_blade() -> Error {
    Error::io(
        Stage::Model,
        "no airfoil was found in the part: sections in no direction tried are closed loops that continue",
    )
    .advise("close the part, or give the blade axis from root to tip with --axis")
}

/// The run along the axis that the user gave.
fn given(mesh: &Mesh, axis: [f64; 3], faces: Option<&[bool]>) -> Result<(Run, String)> {
    let v = Vector::from(axis);
    let direction = v.try_normalize(1e-12).filter(|d| d.iter().all(|x| x.is_finite())).ok_or_else(|| {
        Error::usage(Stage::Model, format!("the blade axis {axis:?} has no direction")).advise("give three numbers")
    })?;
    let run = run::along(mesh, &direction, faces);
    if run.links.is_empty() {
        return Err(no_blade());
    }
    Ok((run, format!("axis: {}, as given", words(&direction))))
}

/// The axis that the search settled on.
struct Found {
    run: Run,
    reason: String,
    /// A direction far from it that looks nearly as good.
    rival: Option<String>,
}

/// The best run of all candidates, its sense from root to tip, and why.
fn search(mesh: &Mesh, faces: Option<&[bool]>) -> Result<Found> {
    let patches = caps::patches(mesh);
    let along = |d: &Vector| {
        let mut run = run::along(mesh, d, faces);
        run.score *= 1.0 + LID * caps::lids(&patches, &run) as f64;
        run
    };
    let mut tried = candidates(mesh);
    tried.extend(caps::directions(&patches));
    let mut runs: Vec<Run> = tried.par_iter().map(along).collect();
    // Each good run proposes a better direction; twice, since a better run proposes better.
    let mut from = 0;
    for _ in 0..3 {
        let best = runs.iter().map(|r| r.score).fold(0.0, f64::max);
        let next: Vec<Vector> =
            runs[from..].iter().filter(|r| r.score > 0.4 * best && best > 0.0).map(|r| r.least_normal).collect();
        from = runs.len();
        runs.extend(next.par_iter().map(along).collect::<Vec<_>>());
    }
    let top = (0..runs.len())
        .filter(|&i| !runs[i].links.is_empty())
        .max_by(|&i, &j| runs[i].score.total_cmp(&runs[j].score).then(j.cmp(&i)))
        .filter(|&i| runs[i].score > 0.0)
        .ok_or_else(no_blade)?;
    let (direction, score) = (runs[top].direction, runs[top].score);
    // The coordinate axes are the first three candidates.
    let axis = (0..3).max_by(|&i, &j| direction[i].abs().total_cmp(&direction[j].abs()).then(j.cmp(&i))).unwrap_or(0);
    let off_deg = direction[axis].abs().clamp(0.0, 1.0).acos().to_degrees();
    let close = off_deg < SNAP_DEG || (off_deg < DATUM_DEG && runs[axis].score > DATUM_SCORE * score);
    let (chosen, why) = if close && !runs[axis].links.is_empty() {
        (
            axis,
            format!("the coordinate axis {off_deg:.1}° from the direction in which sections look most like an airfoil"),
        )
    } else {
        (
            top,
            format!(
                "the direction in which sections look most like an airfoil, {off_deg:.1}° from the nearest coordinate axis"
            ),
        )
    };
    // Faces that the user named are the airfoil, whatever they look like.
    if faces.is_none() && runs[chosen].likeness < DOUBTFUL && runs[chosen].covered() < COVERED {
        return Err(no_single_blade(&runs[chosen]));
    }
    let rival = rival(&runs, chosen);
    let (flip, sense) = root_is_high(mesh, &runs[chosen]);
    let run = runs.swap_remove(chosen);
    let direction = if flip { -run.direction } else { run.direction };
    let run = if flip { run::along(mesh, &direction, faces) } else { run };
    Ok(Found { run, reason: format!("axis: {}, {why}; {sense}", words(&direction)), rival })
}

/// The best run far from the chosen one, in words, where it scores nearly as much.
fn rival(runs: &[Run], chosen: usize) -> Option<String> {
    let axis = runs[chosen].direction;
    let far = |r: &&Run| r.direction.dot(&axis).abs() < RIVAL_DEG.to_radians().cos();
    let best = runs.iter().filter(far).max_by(|a, b| a.score.total_cmp(&b.score))?;
    (best.score > RIVAL * runs[chosen].score).then(|| {
        let d = best.direction;
        format!(
            "the blade axis is not certain: sections along ({:.2}, {:.2}, {:.2}) look like an airfoil too (score {:.2} against {:.2}); \
             give it with --axis if it is wrong",
            d.x, d.y, d.z, best.score, runs[chosen].score
        )
    })
}

fn no_single_blade(run: &Run) -> Error {
    Error::io(
        Stage::Model,
        format!(
            "no single blade was found: in no direction do sections look like one airfoil for long (at best over {:.0} % of the \
             part, likeness {:.2}); a whole wheel or several blades look like this",
            100.0 * run.covered(),
            run.likeness
        ),
    )
    .advise("export one blade with its platform, or give the blade's axis with --axis")
}

/// Directions to try: coordinate axes, principal axes of the surface, eigenvectors of its normals' covariance.
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
    if (below - above).abs() > 0.05 * total {
        let (big, small) = (below.max(above), below.min(above));
        let share = |x: f64| 100.0 * x / total;
        return (
            above > below,
            format!(
                "root where {:.0} % of the surface lies beyond the airfoil ({:.0} % at the tip)",
                share(big),
                share(small)
            ),
        );
    }
    let (a, b) = (low.shape.area_mm2, high.shape.area_mm2);
    if a.max(b) > 1.02 * a.min(b) {
        return (b > a, format!("tip where sections are smaller ({:.1} against {:.1} mm²)", a.min(b), a.max(b)));
    }
    // Nothing tells the ends apart: the tip is taken where the coordinate grows.
    let main = run.direction.iamax();
    (run.direction[main] < 0.0, "both ends are alike, so root to tip was taken along the growing coordinate".into())
}

/// Blade frame: x along the run's direction with x = direction · model point, origin on the mean centroid of the airfoil,
/// which is returned too (in the run's own frame).
fn frame(run: &Run) -> (Rigid, [f64; 2]) {
    let rotation = run::frame_along(&run.direction).rotation;
    let n = run.links.len().max(1) as f64;
    let (y, z) =
        run.links.iter().fold((0.0, 0.0), |(y, z), l| (y + l.shape.centroid[0] / n, z + l.shape.centroid[1] / n));
    // Round to a micrometre: the origin is a choice, and a short number reads better in headers.
    let round = |x: f64| (x * 1e3).round() / 1e3;
    let (y, z) = (round(y), round(z));
    let origin = rotation * Point::new(0.0, y, z);
    (Rigid::from_parts(origin.into(), rotation), [y, z])
}

/// A direction in words.
fn words(d: &Vector) -> String {
    for (k, name) in ["X", "Y", "Z"].iter().enumerate() {
        if d[k].abs() > 1.0 - 1e-12 {
            return format!("{}{name} of the model", if d[k] < 0.0 { "-" } else { "+" });
        }
    }
    format!("({:.4}, {:.4}, {:.4}) in the model", d.x, d.y, d.z)
}
