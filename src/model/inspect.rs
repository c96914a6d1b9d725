//! What is in a model, in words.

use std::fmt::Write;

use crate::artifact::blade::Blade;

/// A report for people: bodies, faces, unit, box, closedness, area, volume, axis, regions with reasons.
pub fn inspect_text(blade: &Blade) -> String {
    let mut out = String::new();
    let d = &blade.diagnosis;
    let mut line = |key: &str, value: &str| {
        // Writing to a String cannot fail.
        let _ = writeln!(out, "{key:<10} {value}");
    };
    let mesh = blade.part.mesh.clone().moved(&blade.model_from_blade);
    line("model", &blade.name);
    line("format", &d.format);
    line("unit", &d.unit_reason);
    line("bodies", &d.bodies.to_string());
    let faces: Vec<String> = d.faces.iter().map(|(kind, n)| format!("{n} {kind}")).collect();
    line("faces", &faces.join(", "));
    let triangles = mesh.triangles.len();
    if blade.part.brep.is_some() {
        line("mesh", &format!("{triangles} triangles, within {} mm of the faces", blade.part.deflection_mm));
    } else {
        line("mesh", &format!("{triangles} triangles, {} vertices", mesh.points.len()));
    }
    if let Some(b) = mesh.aabb() {
        let s = b.max - b.min;
        line("box", &format!("{:.3} × {:.3} × {:.3} mm", s.x, s.y, s.z));
        line("", &format!("from ({:.3}, {:.3}, {:.3})", b.min.x, b.min.y, b.min.z));
        line("", &format!("to   ({:.3}, {:.3}, {:.3})", b.max.x, b.max.y, b.max.z));
    }
    line(
        "closed",
        &match (d.closed, d.first_open_edge) {
            (true, _) => "yes".to_owned(),
            (false, Some(p)) => {
                format!("no: {} open edges, the first at ({:.3}, {:.3}, {:.3}) mm", d.open_edges, p[0], p[1], p[2])
            }
            (false, None) => format!("no: {} open edges", d.open_edges),
        },
    );
    line("area", &format!("{:.3} mm²", mesh.area_mm2()));
    line("volume", &format!("{:.3} mm³", mesh.volume_mm3()));
    let origin = blade.model_from_blade.translation.vector;
    line("frame", &format!("origin at ({:.3}, {:.3}, {:.3}) mm in the model", origin.x, origin.y, origin.z));
    let r = blade.model_from_blade.rotation.to_rotation_matrix();
    for (k, name) in ["x", "y", "z"].iter().enumerate() {
        let c = r.matrix().column(k);
        line("", &format!("{name} = ({:.6}, {:.6}, {:.6})", c[0] + 0.0, c[1] + 0.0, c[2] + 0.0));
    }
    for (k, reason) in blade.regions.reasons.iter().enumerate() {
        line(if k == 0 { "found" } else { "" }, reason);
    }
    for (k, note) in d.notes.iter().enumerate() {
        line(if k == 0 { "notes" } else { "" }, note);
    }
    out
}
