//! What the user says about regions: faces by number or name, heights. It takes the place of what
//! was found.

use super::super::ModelOptions;
use super::Heights;
use crate::error::{Error, Result, Stage};
use crate::geometry::mesh::Mesh;
use crate::geometry::part::Part;

/// One flag for each face that the user named; `None` where none was named. A number counts from 1;
/// a name is that of a face or group, in any case.
///
/// # Errors
/// `Usage`: a number or name that no face has.
pub fn faces(wanted: &[String], names: &[String]) -> Result<Option<Vec<bool>>> {
    if wanted.is_empty() {
        return Ok(None);
    }
    let mut flags = vec![false; names.len()];
    for text in wanted {
        let number = text.trim_start_matches('#').parse::<usize>().ok();
        let mut hit = false;
        for (k, name) in names.iter().enumerate() {
            let plain = name.split('"').nth(1).unwrap_or(name);
            if number == Some(k + 1) || plain.eq_ignore_ascii_case(text) || name.eq_ignore_ascii_case(text) {
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
    let names: Vec<String> = match &part.brep {
        Some(brep) => brep.faces.iter().map(|f| f.name.clone()).collect(),
        None => vec![String::new(); part.mesh.face_of.iter().max().map_or(1, |most| *most as usize + 1)],
    };
    Ok(faces(wanted, &names)?.unwrap_or_default())
}

/// Puts what the user gave in the place of what was found.
///
/// # Errors
/// `Usage`: heights outside the part, faces that are not there.
pub fn apply(heights: &mut Heights, mesh: &Mesh, names: &[String], options: &ModelOptions) -> Result<()> {
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
