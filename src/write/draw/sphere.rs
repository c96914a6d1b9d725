//! The free tool axes of a location: a map of the sphere, and its cells as a table.

use std::fmt::Write;

use nalgebra::UnitQuaternion;

use super::chart::{BLACK, BLUE};
use crate::artifact::channel::Binding;
use crate::artifact::sphere::{CellState, FreeSphere};
use crate::geometry::Vector;

/// Radius of the circle of axes square to the normal, px.
const RIM: f64 = 300.0;
/// Cells beyond this are not drawn: cosine of the angle to the normal.
const BEYOND: f64 = -0.1;
const COLOURS: [(&str, &str); 3] = [("free", "#7bc47f"), ("taken", "#d8d8d8"), ("not decided", "#f2b134")];

/// One line for each cell: its corners, unit vectors of the blade frame, what it is, and what takes
/// it.
pub fn sphere_csv(sphere: &FreeSphere, name: impl Fn(&Binding) -> String) -> String {
    let mut out = String::from("x1,y1,z1,x2,y2,z2,x3,y3,z3,state,taken_by\n");
    for cell in &sphere.cells {
        for v in cell.corners.iter().flat_map(|c| c.iter()) {
            let _ = write!(out, "{v:.6},");
        }
        let _ = match cell.state {
            CellState::Free => writeln!(out, "free,"),
            CellState::Open => writeln!(out, "open,"),
            CellState::Taken(k) => {
                writeln!(out, "taken,{}", sphere.bindings.get(k as usize).map_or_else(String::new, &name))
            }
        };
    }
    out
}

/// The sphere as an SVG file, seen from over the surface normal, areas as they are; the circle is
/// the tangent plane. `circle` are the axes of the cone that the path has there, and `free` those
/// of its free intervals.
pub fn sphere_svg(sphere: &FreeSphere, normal: &Vector, circle: &[Vector], free: &[Vec<Vector>]) -> String {
    let turned = UnitQuaternion::rotation_between(normal, &Vector::z()).unwrap_or_default();
    let place = |axis: &Vector| {
        let v = turned * axis;
        // Lambert's azimuthal projection: √2 of it is the rim.
        let scale = RIM / (1.0 + v.z).max(1e-6).sqrt();
        format!("{:.1},{:.1}", v.x * scale, -v.y * scale)
    };
    let size = 1.25 * RIM;
    let mut out = format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"{} {} {} {}\" font-family=\"DejaVu Sans, sans-serif\" font-size=\"15\">\n<rect x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\" fill=\"#ffffff\"/>\n",
        -size,
        -size,
        2.0 * size,
        2.0 * size,
        -size,
        -size,
        2.0 * size,
        2.0 * size
    );
    for cell in sphere.cells.iter().filter(|c| c.corners.iter().all(|a| a.dot(normal) > BEYOND)) {
        let (_, colour) = match cell.state {
            CellState::Free => COLOURS[0],
            CellState::Taken(_) => COLOURS[1],
            CellState::Open => COLOURS[2],
        };
        let [a, b, c] = cell.corners.each_ref().map(place);
        let _ = writeln!(
            out,
            "<polygon points=\"{a} {b} {c}\" fill=\"{colour}\" stroke=\"{colour}\" stroke-width=\"0.8\"/>"
        );
    }
    let mut line = |axes: &[Vector], width: f64| {
        // What lies beyond the rim is left out, and breaks the line.
        for piece in axes.split(|a| a.dot(normal) < BEYOND).filter(|p| p.len() > 1) {
            let points: Vec<String> = piece.iter().map(place).collect();
            let _ = writeln!(
                out,
                "<polyline points=\"{}\" fill=\"none\" stroke=\"{BLUE}\" stroke-width=\"{width}\"/>",
                points.join(" ")
            );
        }
    };
    line(circle, 1.0);
    free.iter().for_each(|f| line(f, 5.0));
    let _ = writeln!(out, "<circle r=\"{RIM}\" fill=\"none\" stroke=\"{BLACK}\" stroke-width=\"1.5\"/>");
    let _ = writeln!(out, "<circle r=\"3\" fill=\"{BLACK}\"/><text x=\"8\" y=\"5\">surface normal</text>");
    let shares = sphere.shares();
    for (k, ((what, colour), share)) in COLOURS.iter().zip(shares).enumerate() {
        let y = -size + 18.0 + 20.0 * k as f64;
        let _ = writeln!(
            out,
            "<rect x=\"{}\" y=\"{}\" width=\"14\" height=\"14\" fill=\"{colour}\"/><text x=\"{}\" y=\"{y}\">{what}, {:.1} % of all axes</text>",
            -size + 6.0,
            y - 12.0,
            -size + 26.0,
            100.0 * share
        );
    }
    let _ = writeln!(
        out,
        "<line x1=\"{0}\" y1=\"{1}\" x2=\"{2}\" y2=\"{1}\" stroke=\"{BLUE}\" stroke-width=\"5\"/><text x=\"{3}\" y=\"{4}\">free at this lean B</text>\n</svg>",
        -size + 6.0,
        size - 14.0,
        -size + 34.0,
        -size + 42.0,
        size - 9.0
    );
    out
}
