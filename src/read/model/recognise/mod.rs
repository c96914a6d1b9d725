//! Finds the blade axis and the regions of a part from its mesh.
//!
//! In: a mesh in the model frame, mm, closed or two sheets that face each other; perhaps the axis,
//! if the user gave it, or the line along which a table stacks its sections. Out: the blade frame
//! and the [`Heights`] of the regions; of the part in that frame, the
//! [`crate::artifact::region::Regions`] themselves ([`pieces`]). Every candidate direction is cut
//! at [`run::HEIGHTS`] heights; the chain of loops that looks most like an airfoil for longest, and
//! that does not itself point another way, wins ([`search`]). Regions are then sought along the
//! axis ([`mod@regions`]), and each triangle gets its area ([`mod@areas`]). Where a wheel has no
//! such direction, since its hub turns from along the rotor axis to across it, heights over that
//! hub take the place of an axis ([`impeller`]).
//!
//! Guarantees: deterministic; the same part turned by a rotation gives the same regions (up to the
//! sampling of heights, and up to the preference for datum directions); where the geometry leaves
//! the axis open, a doubt says so. Of a wheel one blade is taken ([`one_blade`]). Limits: one
//! airfoil; several blades alike that are no wheel are refused.

pub mod areas;
pub mod caps;
pub mod contours;
pub mod foot;
pub mod given;
pub mod impeller;
pub mod named;
pub mod one_blade;
pub mod pieces;
pub mod regions;
pub mod rotor;
pub mod run;
pub mod search;
pub mod sector;
pub mod shape;
pub mod sides;
pub mod stitch;
pub mod turned;
pub mod wheel;

use super::ModelOptions;
use super::faces::Stacking;
use crate::artifact::along::Along;
use crate::artifact::meridian::Meridian;
use crate::artifact::region::Patch;
use crate::error::{Error, Result, Stage};
use crate::geometry::brep::FaceName;
use crate::geometry::bvh::MeshBvh;
use crate::geometry::mesh::Mesh;
use crate::geometry::{Point, Rigid, Vector};
use crate::observe::{Remark, direction};
use impeller::ImpellerBlade;
use run::Run;
use wheel::Wheel;

/// Below this mean likeness the sections are steady but not airfoils, …
const DOUBTFUL: f64 = 0.25;
/// … below this one the part is refused unless the user says where the blade is: a cube cut aslant
/// comes to 0.27, …
const HARDLY: f64 = 0.35;
/// … and below this one they carry something besides an airfoil.
const PARTLY: f64 = 0.55;

/// Where along the blade axis what was found, mm in the blade frame (`x` from root to tip).
#[derive(Clone, Debug, PartialEq)]
pub struct Heights {
    /// The whole part.
    pub part_x_mm: [f64; 2],
    /// Sections here are one airfoil loop, clear of platform, shroud and tenon.
    pub airfoil_x_mm: [f64; 2],
    /// Top of the platform on the airfoil's side, where there is a platform.
    pub platform_x_mm: Option<f64>,
    /// Foot and top of the fillet between airfoil and platform, where there is one that heights
    /// bound.
    pub fillet_x_mm: Option<[f64; 2]>,
    /// How each was found, one sentence each.
    pub reasons: Vec<String>,
}

/// What was recognised.
pub struct Recognised {
    /// Blade frame to model frame.
    pub model_from_blade: Rigid,
    /// The part's mesh in the blade frame.
    pub mesh: Mesh,
    /// Heights of the regions, with reasons (the axis first).
    pub heights: Heights,
    /// What the user should know.
    pub doubts: Vec<Remark>,
    /// What speaks against the axis that was given.
    pub against: Option<Remark>,
    /// Why this is hardly a blade: no section looks like an airfoil.
    pub unlike: Option<String>,
    /// Boxes around the airfoil's sections: height, then least y, least z, greatest y, greatest z,
    /// blade frame, mm.
    pub outline: Vec<(f64, [f64; 4])>,
    /// Upper and lower ends of a fillet at places round the airfoil, blade frame, where its foot
    /// climbs; else empty.
    pub fillet: Vec<[Point; 2]>,
    /// Heights and surface of a blade whose hub turns; all of the above but frame and mesh are
    /// along these heights then.
    pub round: Option<Round>,
}

/// A blade over a hub that turns.
pub struct Round {
    /// Heights, blade frame.
    pub along: Along,
    /// Its triangles, by numbers from 0 that rise.
    pub triangles: Vec<u32>,
    /// Faces or groups that are its by most of their surface.
    pub faces: Vec<u32>,
}

impl Recognised {
    /// Mean width of the airfoil's sections, corner to corner of their boxes, mm.
    pub fn chord_mm(&self) -> f64 {
        let chords = self.outline.iter().map(|(_, b)| (b[2] - b[0]).hypot(b[3] - b[1]));
        chords.sum::<f64>() / self.outline.len().max(1) as f64
    }
}

/// The search without what the user said: for telling what a body is.
pub fn looks_like_airfoil(mesh: &Mesh) -> Option<String> {
    let found = search::search(mesh, None, None).ok()?;
    (found.run.likeness >= PARTLY).then(|| format!("an airfoil along {}", words(&found.run.direction)))
}

/// What is known of a part before its sections are looked at.
pub struct Known<'a> {
    /// The line along which a table stacks its sections, if the part comes from one.
    pub stacking: Option<&'a Stacking>,
    /// The wheel that the part is.
    pub wheel: Option<&'a Wheel>,
    /// The wheel that it is one sector of.
    pub sector_of: Option<&'a Wheel>,
}

/// Finds axis and regions.
///
/// # Errors
/// `Usage`: an axis of no length. `InputOutput`: no direction along which sections continue.
pub fn recognise(mesh: &Mesh, face_names: &[FaceName], options: &ModelOptions, known: &Known) -> Result<Recognised> {
    let Known { stacking, wheel, sector_of } = *known;
    let airfoil = named::faces(&options.airfoil_faces, face_names)?;
    let airfoil = airfoil.as_deref();
    let (mut doubts, mut against) = (Vec::new(), None);
    // The axis of a sector says along what its blade stands, since there is one blade to choose.
    let of_sector = sector_of.filter(|_| options.axis.is_none()).map(|w| (w, true));
    if let (Some((w, is_sector)), None) = (wheel.map(|w| (w, false)).or(of_sector), airfoil)
        && let Some(blade) = impeller::blade(mesh, w, is_sector, options.axis)
    {
        return Ok(over_hub(mesh, blade));
    }
    let (mut run, reason) = match options.axis {
        Some(a) => {
            let given = match wheel {
                Some(w) => one_blade::given(mesh, w, a, airfoil)?,
                None => given::given(mesh, a, airfoil, known)?,
            };
            against = given.against;
            (given.run, given.reason)
        }
        None => {
            let found = match (stacking, wheel) {
                (Some(s), _) => search::stacked(mesh, s, airfoil)?,
                (None, Some(w)) => one_blade::search(mesh, w, airfoil)?,
                (None, None) => search::search(mesh, airfoil, sector_of.map(|w| &w.axis))?,
            };
            doubts.extend(found.doubt);
            (found.run, found.reason)
        }
    };
    let unlike = (run.likeness < HARDLY).then(|| {
        format!(
            "no blade was recognised: no section looks like an airfoil (likeness {:.2}, at least {HARDLY} is asked)",
            run.likeness
        )
    });
    if run.likeness < DOUBTFUL {
        doubts.push(Remark::NoAirfoil { likeness: run.likeness, axis_given: options.axis.is_some() });
    } else if run.likeness < PARTLY {
        doubts.push(Remark::PartlyAirfoil { likeness: run.likeness });
    }
    if wheel.is_some() {
        // Found on one side of the rotor axis.
        run.part_mm = run::extent_mm(mesh, &run.direction);
    }
    let (model_from_blade, origin) = frame(&run);
    for link in &mut run.links {
        link.shape = link.shape.seen_from(origin);
    }
    let blade_mesh = mesh.clone().moved(&model_from_blade.inverse());
    let bvh = MeshBvh::new(&blade_mesh);
    let (mut heights, foot) = regions::find(&blade_mesh, &bvh, &run).ok_or_else(no_blade)?;
    heights.reasons.insert(0, reason);
    named::apply(&mut heights, &blade_mesh, face_names, options)?;
    let outline = run.links.iter().map(|l| (l.height_mm, l.shape.bounds)).collect();
    let fillet = foot.map_or_else(Vec::new, |f| f.ends);
    let (mesh, round) = (blade_mesh, None);
    Ok(Recognised { model_from_blade, mesh, heights, doubts, against, unlike, outline, fillet, round })
}

/// What was recognised on a wheel whose hub turns.
fn over_hub(mesh: &Mesh, blade: ImpellerBlade) -> Recognised {
    let ImpellerBlade { model_from_blade, along, triangles, reasons } = blade;
    let tip_mm = along.round().map_or(0.0, Meridian::tip_mm);
    let faces = match Patch::most_of(mesh, triangles.clone(), true) {
        Patch::Faces(faces) => faces,
        Patch::Facets(_) => Vec::new(),
    };
    let heights = Heights {
        part_x_mm: [0.0, tip_mm],
        airfoil_x_mm: [0.0, tip_mm],
        platform_x_mm: Some(0.0),
        fillet_x_mm: None,
        reasons,
    };
    Recognised {
        model_from_blade,
        mesh: mesh.clone().moved(&model_from_blade.inverse()),
        heights,
        doubts: Vec::new(),
        against: None,
        unlike: None,
        outline: Vec::new(),
        fillet: Vec::new(),
        round: Some(Round { along, triangles, faces }),
    }
}

fn no_blade() -> Error {
    Error::io(
        Stage::Model,
        "no airfoil was found in the part: sections in no direction tried are closed loops that continue",
    )
    .advise("close the part, or name what is the airfoil: its axis from root to tip (--axis), its faces (--faces airfoil=…)")
}

/// Blade frame: x along the run's direction with x = direction · model point, origin on the mean
/// centroid of the airfoil, which is returned too (in the run's own frame).
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
    direction(&(*d).into())
}
