//! What the user says about regions: faces by number or name, heights. It takes the place of what
//! was found; where it leaves no airfoil, the error names the faces that belong to one.

use super::super::ModelOptions;
use super::{Heights, no_blade, run};
use crate::error::{Error, Result, Stage};
use crate::geometry::Vector;
use crate::geometry::brep::FaceName;
use crate::geometry::mesh::Mesh;
use crate::geometry::part::Part;

/// A face with less of an outline than this share is not named in advice.
const SHARE_NAMED: f64 = 0.01;

/// One flag for each face that the user named; `None` where none was named. A number counts from 1;
/// a name is that of a face or group, in any case.
///
/// # Errors
/// `Usage`: a number or name that no face has.
pub fn faces(wanted: &[String], names: &[FaceName]) -> Result<Option<Vec<bool>>> {
    if wanted.is_empty() {
        return Ok(None);
    }
    let mut flags = vec![false; names.len()];
    for text in wanted {
        let number = text.trim_start_matches('#').parse::<usize>().ok();
        let mut hit = false;
        for (k, name) in names.iter().enumerate() {
            let own = name.own();
            let is_own = !own.is_empty() && own.eq_ignore_ascii_case(text);
            if number == Some(k + 1) || is_own || name.to_string().eq_ignore_ascii_case(text) {
                (flags[k], hit) = (true, true);
            }
        }
        if !hit {
            let n = names.len();
            return Err(Error::usage(
                Stage::Model,
                format!("no face is called {text}; the part has {n} faces or groups"),
            )
            .advise("give numbers from 1 up, or names as inspect prints them"));
        }
    }
    Ok(Some(flags))
}

/// The same of a part that was read: the groups of a mesh go by their numbers.
///
/// # Errors
/// As [`faces`].
pub fn faces_of(wanted: &[String], part: &Part) -> Result<Vec<bool>> {
    let names: Vec<FaceName> = match &part.brep {
        Some(brep) => brep.faces.iter().map(|f| f.name.clone()).collect(),
        None => vec![FaceName::Own(String::new()); part.mesh.face_of.iter().max().map_or(1, |most| *most as usize + 1)],
    };
    Ok(faces(wanted, &names)?.unwrap_or_default())
}

/// Puts what the user gave in the place of what was found.
///
/// # Errors
/// `Usage`: heights outside the part, faces that are not there.
pub fn apply(heights: &mut Heights, mesh: &Mesh, names: &[FaceName], options: &ModelOptions) -> Result<()> {
    let [lo, hi] = heights.part_x_mm;
    let inside = |x: f64| (lo..=hi).contains(&x);
    if let Some([a, b]) = options.airfoil_mm {
        if !(inside(a) && inside(b) && a < b) {
            return Err(outside(&format!("airfoil heights {a} to {b} mm"), lo, hi));
        }
        heights.airfoil_x_mm = [a, b];
        heights.fillet_x_mm = heights.fillet_x_mm.filter(|f| f[0] < b);
        heights.reasons.push(format!("airfoil: x = {a} to {b} mm, as given"));
    }
    let platform = match (options.platform_mm, faces(&options.platform_faces, names)?) {
        (Some(x), _) => Some(x),
        (None, Some(flags)) => top(mesh, &flags),
        (None, None) => None,
    };
    if let Some(x) = platform {
        if !inside(x) {
            return Err(outside(&format!("platform height {x} mm"), lo, hi));
        }
        heights.platform_x_mm = Some(x);
        heights.fillet_x_mm = heights.fillet_x_mm.map(|f| [x, f[1]]).filter(|f| f[0] < f[1]);
        heights.airfoil_x_mm[0] = heights.airfoil_x_mm[0].max(x);
        heights.reasons.push(format!("platform: top at x = {x:.3} mm, as given"));
    }
    Ok(())
}

fn outside(what: &str, lo: f64, hi: f64) -> Error {
    Error::usage(Stage::Model, format!("{what}: the part spans {lo:.3} to {hi:.3} mm along the blade axis"))
        .advise("give heights along the blade axis, as inspect prints them")
}

/// Height of the middle of the area of these faces that faces the tip, or of all of it.
fn top(mesh: &Mesh, flags: &[bool]) -> Option<f64> {
    let heights = |least: f64| -> Vec<(f64, f64)> {
        (0..mesh.triangles.len())
            .filter(|&t| flags.get(mesh.face(t) as usize) == Some(&true))
            .filter_map(|t| {
                let [a, b, c] = mesh.corners(t);
                let n = (b - a).cross(&(c - a));
                (n.x > least * n.norm()).then_some(((a.x + b.x + c.x) / 3.0, 0.5 * n.norm()))
            })
            .collect()
    };
    let mut all = heights(0.7);
    if all.is_empty() {
        all = heights(-2.0);
    }
    all.sort_by(|a, b| a.0.total_cmp(&b.0));
    let total: f64 = all.iter().map(|h| h.1).sum();
    let mut sum = 0.0;
    all.iter()
        .find(|h| {
            sum += h.1;
            sum >= 0.5 * total
        })
        .map(|h| h.0)
}

/// No sections at all: the faces that were named are the cause where some section meets them.
pub(super) fn nothing(mesh: &Mesh, directions: &[Vector], faces: Option<&[bool]>) -> Error {
    faces.and_then(|f| beside_named(mesh, directions, f)).unwrap_or_else(no_blade)
}

/// Why no airfoil lies on the faces that were named: the direction whose sections run on them for
/// longest, and what else these run on. `None` where a part has one face only, so that naming
/// others is no help.
pub(super) fn beside_named(mesh: &Mesh, directions: &[Vector], faces: &[bool]) -> Option<Error> {
    let numbers = |of: &mut dyn Iterator<Item = usize>| of.map(|k| (k + 1).to_string()).collect::<Vec<_>>();
    let named = numbers(&mut (0..faces.len()).filter(|k| faces[*k]));
    let what = format!("face{} {}", if named.len() == 1 { "" } else { "s" }, named.join(", "));
    let on = |lengths: &[f64]| lengths.iter().zip(faces).filter(|(_, named)| **named).map(|(l, _)| l).sum::<f64>();
    let all = directions.iter().map(|d| run::on_faces(mesh, d, faces)).max_by(|a, b| on(a).total_cmp(&on(b)))?;
    let total: f64 = all.iter().sum();
    if !(total > 0.0) {
        let message =
            format!("no airfoil was found on {what}: no section across the blade axis that is closed meets them");
        return Some(
            Error::io(Stage::Model, message).advise("name the airfoil's faces, by number as inspect prints them"),
        );
    }
    let mut others: Vec<usize> =
        (0..all.len()).filter(|k| !faces.get(*k).is_some_and(|n| *n) && all[*k] > SHARE_NAMED * total).collect();
    others.sort_by(|a, b| all[*b].total_cmp(&all[*a]));
    let rest: Vec<String> = others.iter().map(|k| format!("{} ({:.0} %)", k + 1, 100.0 * all[*k] / total)).collect();
    let mut wanted: Vec<usize> = others.iter().copied().chain((0..faces.len()).filter(|k| faces[*k])).collect();
    wanted.sort_unstable();
    let message = format!(
        "no airfoil was found on {what}: of sections that meet them {:.0} % of the outline lies there, {:.0} % are asked; the rest lies on \
         face{} {}",
        100.0 * on(&all) / total,
        100.0 * run::ON_FACES,
        if rest.len() == 1 { "" } else { "s" },
        if rest.is_empty() { "too small to be named".into() } else { rest.join(", ") }
    );
    Some(Error::io(Stage::Model, message).advise(format!(
        "name all faces of the airfoil's outline, as in --faces airfoil={}",
        numbers(&mut wanted.into_iter()).join(",")
    )))
}
