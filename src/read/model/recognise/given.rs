//! The blade axis as the user gave it: the run along it, and what speaks against it.
//!
//! In: the mesh, the axis, perhaps the faces that the user named. Out: the run along it, and a
//! sentence where the search without an axis settles on another one: the opposite, so that the
//! helix would go round the airfoil's free end, or one far away along which sections look far more
//! like an airfoil. What the user gave stands in any case.

use super::run::{self, Run};
use super::search::{self, FoundAxis};
use super::{Known, named, words};
use crate::error::{Error, Result, Stage};
use crate::geometry::Vector;
use crate::geometry::mesh::Mesh;
use crate::observe::Remark;

/// Directions farther apart than this are not the same axis, degrees; the search has rivals from
/// the same angle on.
const APART_DEG: f64 = 35.0;
/// An axis far from the one found is reported where it scores less than this share of it.
const FAR_LESS: f64 = 0.5;

/// The run along the axis that was given.
pub struct Given {
    /// The run along it.
    pub run: Run,
    /// Which axis, in words.
    pub reason: String,
    /// What speaks against it.
    pub against: Option<Remark>,
}

/// The run along `axis`; `faces`: as for [`run::along`].
///
/// # Errors
/// `Usage`: an axis of no length. `InputOutput`: no sections along it that continue, with the
/// cause.
pub fn given(mesh: &Mesh, axis: [f64; 3], faces: Option<&[bool]>, known: &Known) -> Result<Given> {
    let direction = direction(axis)?;
    let run = run::along(mesh, &direction, faces);
    let found = match known.stacking {
        Some(s) => search::stacked(mesh, s, faces),
        None => search::search(mesh, faces, known.sector_of.map(|w| &w.axis)),
    };
    if run.links.is_empty() {
        return Err(nothing_along(mesh, &direction, faces, found.ok()));
    }
    let against = found.ok().and_then(|f| against(mesh, &run, &f, faces));
    Ok(Given { run, reason: format!("axis: {}, as given", words(&direction)), against })
}

/// The axis that was given, of unit length.
///
/// # Errors
/// `Usage`: it has no length.
pub(super) fn direction(axis: [f64; 3]) -> Result<Vector> {
    let v = Vector::from(axis).try_normalize(1e-12).filter(|d| d.iter().all(|x| x.is_finite()));
    v.ok_or_else(|| {
        Error::usage(Stage::Model, format!("the blade axis {axis:?} has no direction")).advise("give three numbers")
    })
}

/// What is said where the search settles on another axis.
fn against(mesh: &Mesh, run: &Run, found: &FoundAxis, faces: Option<&[bool]>) -> Option<Remark> {
    let (given, other) = (&run.direction, &found.run.direction);
    let apart_deg = given.angle(other).to_degrees();
    if apart_deg > 180.0 - APART_DEG {
        let reason = found.sense.clone()?;
        return Some(Remark::AxisOpposite { given: (*given).into(), found: (*other).into(), reason });
    }
    // Lids count in the search only: both are weighed without.
    let score = run::along(mesh, other, faces).score;
    (apart_deg > APART_DEG && run.score < FAR_LESS * score).then(|| Remark::AxisElsewhere {
        given: (*given).into(),
        found: (*other).into(),
        apart_deg,
        scores: [score, run.score],
    })
}

/// No sections along the axis that was given.
fn nothing_along(mesh: &Mesh, direction: &Vector, faces: Option<&[bool]>, found: Option<FoundAxis>) -> Error {
    if let Some(e) = faces.and_then(|f| named::beside_named(mesh, &[*direction], f)) {
        return e;
    }
    let e = Error::io(
        Stage::Model,
        format!(
            "no airfoil was found along {}, the axis that was given: sections across it are no closed loops that continue",
            words(direction)
        ),
    );
    match found {
        Some(f) => e.advise(format!("without --axis {} is found: leave --axis out", words(&f.run.direction))),
        None => e.advise("close the part, or export it again"),
    }
}
