//! What is in a model, in words.

use std::collections::BTreeMap;
use std::fmt::Write;

use serde_json::{Map, Value, json};

use super::bodies::{Body, LISTED};
use super::recognise::{self, wheel};
use super::survey::{Bladed, Survey};
use crate::artifact::blade::Diagnosis;
use crate::artifact::region::{Area, Patch, Region, of_faces};
use crate::error::Error;
use crate::geometry::brep::FaceName;

/// Openings that are listed.
const OPENINGS: usize = 5;
/// Faces of one area that are listed.
const FACES: usize = 16;

/// A report for people: bodies, faces, unit, box, openings, area, volume, axis, regions with
/// reasons, or why none were found.
pub fn inspect_text(survey: &Survey) -> String {
    let mut out = Lines::default();
    let d = &survey.diagnosis;
    let mesh = &survey.part.mesh;
    out.line("model", &survey.name);
    out.line("format", &d.format);
    out.line("unit", &d.unit_reason);
    out.line("bodies", &d.bodies.to_string());
    if let [_, _, ..] = survey.bodies[..] {
        let one = |(k, b): (usize, &Body)| format!("{}: {}{}", k + 1, b.in_words(), kind(b));
        let more = survey.bodies.len().saturating_sub(LISTED);
        let rest = (more > 0).then(|| format!("and {more} more"));
        out.list("assembly", survey.bodies.iter().take(LISTED).enumerate().map(one).chain(rest));
    }
    let faces: Vec<String> = d.faces.iter().map(|(kind, n)| format!("{n} {kind}")).collect();
    out.line("faces", &faces.join(", "));
    let triangles = mesh.triangles.len();
    if survey.part.brep.is_some() {
        out.line("mesh", &format!("{triangles} triangles, within {:.4} mm of the faces", survey.part.deflection_mm));
    } else {
        out.line("mesh", &format!("{triangles} triangles, {} vertices", mesh.points.len()));
    }
    if let Some(b) = mesh.aabb() {
        let s = b.max - b.min;
        out.line("box", &format!("{:.3} × {:.3} × {:.3} mm", s.x, s.y, s.z));
        out.line("", &format!("from ({:.3}, {:.3}, {:.3})", b.min.x, b.min.y, b.min.z));
        out.line("", &format!("to   ({:.3}, {:.3}, {:.3})", b.max.x, b.max.y, b.max.z));
    }
    openings(&mut out, d);
    let measured = survey.part.measure();
    out.line("area", &format!("{:.3} mm²{}", measured.area_mm2, about(measured.area_error_mm2, "mm²")));
    if d.closed {
        out.line("volume", &format!("{:.3} mm³{}", measured.volume_mm3, about(measured.volume_error_mm3, "mm³")));
    } else {
        out.line("volume", "none, since the part is open");
    }
    if let Some(bladed) = &survey.wheel {
        let off_mm = bladed.wheel().off_mm;
        let alike = match bladed {
            Bladed::Whole(_) => format!("its blades are alike within {off_mm:.4} mm (root of the mean square)"),
            Bladed::Sector(_) => {
                format!("its sides lie on one another within {off_mm:.4} mm (root of the mean square)")
            }
        };
        out.list("wheel", [bladed.in_words(), alike]);
    }
    found(&mut out, survey);
    if let Some(e) = &survey.obstacle {
        out.list("plan", [format!("not possible as it is: {}", e.message)].into_iter().chain(e.advice.clone()));
    }
    out.list("notes", d.notes.iter().map(ToString::to_string));
    out.text
}

/// The same figures for other programs: lengths in mm, the box in the model frame. What was not
/// found is null.
pub fn inspect_json(survey: &Survey) -> Value {
    let (d, measured) = (&survey.diagnosis, survey.part.measure());
    let corners = survey.part.mesh.aabb().map(|b| [b.min, b.max].map(|p| [p.x, p.y, p.z]));
    let said = |e: &Error| json!({ "stage": e.stage, "message": e.message, "advice": e.advice });
    let regions = survey.regions().map(|r| r.list.iter().map(region_json).collect::<Vec<_>>());
    json!({
        "name": survey.name,
        "format": d.format,
        "unit": survey.unit,
        "unit_reason": d.unit_reason,
        "bodies": d.bodies,
        "faces": d.faces.iter().map(|(kind, n)| (kind.clone(), json!(n))).collect::<Map<_, _>>(),
        "triangles": survey.part.mesh.triangles.len(),
        "box_mm": corners,
        "area_mm2": measured.area_mm2,
        "volume_mm3": d.closed.then_some(measured.volume_mm3),
        "closed": d.closed,
        "openings": d.openings,
        "model_from_blade": survey.found.as_ref().ok().map(|f| {
            let m = f.model_from_blade.to_homogeneous();
            std::array::from_fn::<[f64; 4], 4, _>(|i| std::array::from_fn(|k| m[(i, k)]))
        }),
        "wheel": survey.wheel.as_ref().map(wheel_json),
        "reasons": survey.found.as_ref().ok().map(|f| &f.heights.reasons),
        "regions": regions,
        "problem": survey.found.as_ref().err().or(survey.obstacle.as_ref()).map(said),
        "notes": d.notes.iter().map(ToString::to_string).collect::<Vec<_>>(),
        "remarks": d.notes,
    })
}

/// A wheel for other programs: model frame, mm.
fn wheel_json(bladed: &Bladed) -> Value {
    let wheel = bladed.wheel();
    json!({
        "axis": [wheel.axis.x, wheel.axis.y, wheel.axis.z],
        "through_mm": [wheel.through.x, wheel.through.y, wheel.through.z],
        "blades": wheel.blades,
        "repeats": wheel.fold,
        "whole": matches!(bladed, Bladed::Whole(_)),
        "alike_within_mm": wheel.off_mm,
    })
}

/// A region for other programs: lengths in mm, blade frame; sides counter-clockwise seen from its
/// start.
pub fn region_json(region: &Region) -> Value {
    let faces = if let Patch::Faces(faces) = &region.patch {
        json!(faces.iter().map(|f| f + 1).collect::<Vec<_>>())
    } else {
        Value::Null
    };
    let sides = region.sides.as_ref().map(|s| match s.suction_follows_leading {
        true => ["leading-edge", "suction-side", "trailing-edge", "pressure-side"],
        false => ["leading-edge", "pressure-side", "trailing-edge", "suction-side"],
    });
    json!({
        "name": region.area,
        "along": region.along,
        "heights_mm": region.x_mm(),
        "start": region.start,
        "end": region.end,
        "faces": faces,
        "sides": sides,
    })
}

/// What a body of an assembly is, where that is known.
fn kind(body: &Body) -> String {
    let wheel = wheel::wheel(&body.mesh).map(|w| w.in_words());
    wheel.or_else(|| recognise::looks_like_airfoil(&body.mesh)).map_or_else(String::new, |k| format!(": {k}"))
}

/// By about how much a figure is wrong, if anything that its last digit shows: an estimate, not a
/// bound.
fn about(error: f64, unit: &str) -> String {
    if error > 5e-4 { format!(", error about {error:.1e} {unit}") } else { String::new() }
}

#[derive(Default)]
struct Lines {
    text: String,
}

impl Lines {
    fn line(&mut self, key: &str, value: &str) {
        // Writing to a String cannot fail. A line of a value would pass for one of ours.
        let _ = writeln!(self.text, "{key:<10} {}", value.replace('\n', "\\n"));
    }
    fn list(&mut self, key: &str, values: impl IntoIterator<Item = String>) {
        for (k, value) in values.into_iter().enumerate() {
            self.line(if k == 0 { key } else { "" }, &value);
        }
    }
}

fn openings(out: &mut Lines, d: &Diagnosis) {
    if d.closed {
        out.line("closed", "yes");
    } else {
        let n = d.openings.len();
        out.line("closed", &format!("no: {} open edges in {n} opening{}", d.open_edges, if n == 1 { "" } else { "s" }));
        for o in d.openings.iter().take(OPENINGS) {
            let [x, y, z] = o.at_mm;
            let (length, width) = (o.length_mm, o.width_mm);
            let edges = o.edges;
            out.line(
                "",
                &format!("{edges} edges, {length:.3} mm long, {width:.3} mm wide, at ({x:.3}, {y:.3}, {z:.3}) mm"),
            );
        }
        if n > OPENINGS {
            out.line("", &format!("and {} shorter ones", n - OPENINGS));
        }
    }
    if let Some([x, y, z]) = d.first_nonmanifold_edge {
        let n = d.nonmanifold_edges;
        out.line(
            "manifold",
            &format!("no: {n} edges have more than two triangles, the first at ({x:.3}, {y:.3}, {z:.3}) mm"),
        );
    }
    if d.inconsistent_edges > 0 {
        out.line("winding", &format!("{} edges have triangles that wind against one another", d.inconsistent_edges));
    }
    out.line("pieces", &d.pieces.to_string());
}

fn found(out: &mut Lines, survey: &Survey) {
    let found = match &survey.found {
        Ok(found) => found,
        Err(e) => {
            out.list("found", [format!("no blade: {}", e.message)].into_iter().chain(e.advice.clone()));
            return;
        }
    };
    let origin = found.model_from_blade.translation.vector;
    out.line("frame", &format!("origin at ({:.3}, {:.3}, {:.3}) mm in the model", origin.x, origin.y, origin.z));
    let r = found.model_from_blade.rotation.to_rotation_matrix();
    for (k, name) in ["x", "y", "z"].iter().enumerate() {
        let c = r.matrix().column(k);
        out.line("", &format!("{name} = ({:.6}, {:.6}, {:.6})", c[0] + 0.0, c[1] + 0.0, c[2] + 0.0));
    }
    out.list("found", found.heights.reasons.iter().cloned());
    out.list("regions", regions(survey));
}

/// Surface and faces of each area.
fn regions(survey: &Survey) -> Vec<String> {
    let mesh = &survey.part.mesh;
    let mut surface: BTreeMap<Area, f64> = BTreeMap::new();
    let areas = survey.areas();
    for (t, area) in areas.iter().enumerate() {
        *surface.entry(*area).or_default() += mesh.triangle_area_mm2(t);
    }
    let by_face = of_faces(mesh, &areas);
    let mut out = Vec::new();
    for (area, s) in &surface {
        let faces: Vec<u32> = by_face.iter().filter(|(_, own)| *own == area).map(|(f, _)| f + 1).collect();
        let shown: Vec<String> = faces.iter().take(FACES).map(|f| named(survey, *f)).collect();
        let more = if faces.len() > FACES { format!(" and {} more", faces.len() - FACES) } else { String::new() };
        let list = if faces.is_empty() { String::new() } else { format!(", faces {}{more}", shown.join(", ")) };
        let name = format!("{area:?}").to_lowercase();
        out.push(format!("{name}: {s:.2} mm²{list}"));
    }
    out
}

/// Number of a face, with its name where it has one of its own.
fn named(survey: &Survey, number: u32) -> String {
    let own = survey.face_names.get(number as usize - 1).map_or("", FaceName::own);
    if own.is_empty() { number.to_string() } else { format!("{number} \"{own}\"") }
}
