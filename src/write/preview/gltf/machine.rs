//! The machine's moving parts, schematic: a disc for the table, a cylinder and an axle for the
//! head. The machine file knows where they turn and how far the pivot is, not what they look like;
//! widths here are made up.

use gltf_json as json;
use json::Index;
use json::scene::Node;
use nalgebra::UnitQuaternion;
use serde_json::json;

use super::glb::Glb;
use super::revolved::{ProfileRing, revolved};
use super::{Scene, group, mesh_node, single, triple};
use crate::artifact::Plan;
use crate::error::Result;
use crate::geometry::{Point, Vector};

/// Colour of machine parts, linear.
const COLOUR: [f32; 3] = [0.30, 0.33, 0.36];

/// A closed cylinder along Z.
fn cylinder(from: f64, to: f64, radius: f64) -> Vec<ProfileRing> {
    vec![
        [from, 0.0, 0.0, -1.0],
        [from, radius, 0.0, -1.0],
        [from, radius, 1.0, 0.0],
        [to, radius, 1.0, 0.0],
        [to, radius, 0.0, 1.0],
        [to, 0.0, 0.0, 1.0],
    ]
}

/// The table: a disc under the root, about the axis that A turns about.
pub(super) fn table(glb: &mut Glb, scene: &Scene) -> Result<Option<Index<Node>>> {
    let Some(part) = scene.blade.part.mesh.aabb() else { return Ok(None) };
    let around = Vector::new(0.0, part.max.y - part.min.y, part.max.z - part.min.z).norm();
    let radius = (0.5 * around).min(0.5 * scene.machine.swing_diameter_mm);
    let thick = 0.12 * radius;
    let shown = revolved(glb, "machine", COLOUR, &cylinder(-thick, 0.0, radius))?;
    let node = mesh_node(
        glb,
        "table",
        vec![shown],
        json!({ "what": "the machine's table, schematic: its axis is true, its size is not", "axis": scene.machine.axes()[scene.machine.turning_axis()].name }),
    );
    let (at, along) = table_axis(scene, part.min.x);
    let to_axis = UnitQuaternion::rotation_between(&Vector::z(), &along).unwrap_or_default();
    let q = scene.blade.model_from_blade.rotation * to_axis;
    glb.place(
        node,
        triple(&(scene.blade.model_from_blade * at).coords)?,
        [single(q.i)?, single(q.j)?, single(q.k)?, single(q.w)?],
    );
    Ok(Some(node))
}

/// A point of the table's axis at the end of the part, and its direction, blade frame: about the
/// blade from its root on; of a wheel, its rotor axis.
fn table_axis(scene: &Scene, root_x_mm: f64) -> (Point, Vector) {
    let line = scene.machine.turning_line().filter(|_| !scene.machine.turns_the_blade());
    if let Some((through, along)) = line {
        let heights = scene.blade.part.mesh.points.iter().map(|p| (p - through).dot(&along));
        return (through + along * heights.fold(f64::INFINITY, f64::min), along);
    }
    let (clamped, [axis_y, axis_z], _) = scene.machine.shown_table();
    let mut at = clamped.inverse() * Point::new(0.0, axis_y, axis_z);
    at.x = root_x_mm;
    (at, Vector::x())
}

/// Spindle from the holder's end to the pivot, and the pivot's axle; in the tool's frame.
pub(super) fn head(glb: &mut Glb, plan: &Plan, scene: &Scene) -> Result<Index<Node>> {
    let gauge = scene.tool.length_mm();
    let pivot = gauge + scene.machine.shown_pivot_mm();
    let widest = scene.tool.holder.iter().map(|h| h.radius_mm).fold(scene.tool.shank_radius_mm, f64::max);
    let radius = 1.15 * widest;
    let spindle = revolved(glb, "machine", COLOUR, &cylinder(gauge, pivot + radius, radius))?;
    let leaning = scene.machine.leaning_axis().map(|k| scene.machine.axes()[k].name.as_str());
    let what = leaning.map_or("schematic".into(), |name| format!("from the gauge line to the pivot of {name}"));
    let spindle = mesh_node(glb, "spindle", vec![spindle], json!({ "what": what }));
    let Some(name) = leaning else {
        return Ok(group(glb, "head", vec![spindle], &json!({ "what": "the machine's head, schematic" })));
    };
    let axle = revolved(glb, "machine", COLOUR, &cylinder(-1.6 * radius, 1.6 * radius, 0.5 * radius))?;
    let axle = mesh_node(glb, &format!("pivot of {name}"), vec![axle], json!({ "axis": name }));
    // The pivot's axle is across blade axis and tool axis: at θ = 0 that is the blade's z. It
    // stands as where the path begins.
    let across = super::motion::lean(plan.toolpath.cone(0).lean_rad).inverse() * Vector::z();
    let q = UnitQuaternion::rotation_between(&Vector::z(), &across).unwrap_or_default();
    glb.place(axle, [0.0, 0.0, single(pivot)?], [single(q.i)?, single(q.j)?, single(q.k)?, single(q.w)?]);
    let note = json!({
        "what": "the machine's head, schematic: the pivot's place is true, widths are not",
        "pivot_length_mm": scene.machine.shown_pivot_mm(),
    });
    Ok(group(glb, "head", vec![spindle, axle], &note))
}
