//! The 3-D view's data: the scene as glTF without path and motion, and the path with its values,
//! blade frame, mm.

use serde_json::{Value, json};

use super::ReportInput;
use super::pack::{self, DIGITS, Pack, TIME};
use crate::artifact::{Blade, Cone, Plan};
use crate::error::Result;
use crate::machine::Machine;
use crate::tool::Tool;
use crate::write::preview::gltf::{GltfOptions, Scene, gltf};
use crate::write::preview::values::{self, Values};

/// Most bytes of the glTF part.
const GLTF_BYTES: usize = 3_000_000;
/// Digits after the point of angles in radians, and of the parts of unit vectors.
pub(super) const RADIANS: i32 = 5;
/// The same of the channel's limits, which are read and not drawn.
pub(super) const LIMITS: i32 = 4;
/// Most points of the path.
const PATH: usize = 40_000;

/// How the glTF part is made.
pub(super) fn options() -> GltfOptions {
    GltfOptions { budget_bytes: GLTF_BYTES, path_and_motion: false, rounded: true, ..GltfOptions::default() }
}

/// The glTF part as it stands in the page.
///
/// # Errors
/// As [`gltf`] and [`pack::deflated`].
pub(super) fn glb(input: &ReportInput) -> Result<String> {
    let options = options();
    let bytes = gltf(&Scene {
        blade: input.blade,
        obstacles: input.obstacles,
        tool: input.tool,
        machine: input.machine,
        plan: input.plan.filter(|p| !p.toolpath.locations.is_empty()),
        sections: input.sections,
        checks: input.checks,
        figures: None,
        options: &options,
    })?;
    pack::deflated(&bytes)
}

pub(super) fn scene(input: &ReportInput, pack: &mut Pack) -> Value {
    let path = path(input, pack);
    around(input.blade, input.tool, input.machine, path)
}

/// A path with what is around it: the part's place in the model and on the machine, and the tool's
/// size.
pub(super) fn around(blade: &Blade, tool: &Tool, machine: &Machine, path: Value) -> Value {
    let q = blade.model_from_blade.rotation;
    let at = blade.model_from_blade.translation.vector;
    let (clamped, axis, turn) = machine.shown_table();
    let turned = clamped.rotation;
    let bounds = blade.part.mesh.aabb();
    json!({
        "path": path,
        "model_from_blade": { "q": [q.i, q.j, q.k, q.w], "t": [at.x, at.y, at.z] },
        "box": bounds.map(|b| json!([[b.min.x, b.min.y, b.min.z], [b.max.x, b.max.y, b.max.z]])),
        "radius": tool.radius_mm,
        "length": tool.length_mm(),
        "machine": {
            "part_at_zero": {
                "q": [turned.i, turned.j, turned.k, turned.w],
                "t": clamped.translation.vector.as_slice(),
            },
            "axis": axis,
            // Right-hand angle of the part about X: `turn[0] + turn[1] θ`.
            "turn": [turn(0.0), turn(1.0) - turn(0.0)],
        },
    })
}

/// What the path can be coloured by, with its values at the points of the path.
pub(super) fn quantity(v: &Values, of: impl Iterator<Item = f64>, pack: &mut Pack) -> Value {
    // Counts are whole.
    let of = if v.unit.is_empty() { pack.list(0, of) } else { pack.scaled(of) };
    json!({ "key": v.key, "name": v.name, "unit": v.unit, "range": v.range, "shown": v.shown, "of": of })
}

/// Locations of a plan that have all that is shown of them.
fn shown(plan: &Plan) -> usize {
    plan.toolpath.locations.len().min(plan.schedule.theta.len()).min(plan.channel.rows.len())
}

/// The locations that the path of the view goes through.
pub(super) fn picked(plan: Option<&Plan>) -> Vec<usize> {
    let n = plan.map_or(0, shown);
    let count = n.min(PATH);
    let pick = |k: usize| if count > 1 { k * (n - 1) / (count - 1) } else { 0 };
    (0..count).map(pick).collect()
}

fn path(input: &ReportInput, pack: &mut Pack) -> Value {
    let Some(plan) = input.plan else { return Value::Null };
    let (locations, n, picked) = (&plan.toolpath.locations, shown(plan), picked(input.plan));
    let quantities: Vec<Value> = values::all(plan, input.machine, input.checks)
        .iter()
        .map(|v| quantity(v, picked.iter().map(|&i| v.of.get(i).copied().unwrap_or(f64::NAN)), pack))
        .collect();
    let same = plan.toolpath.cones.same().filter(Cone::is_about_blade);
    let mut of = |digits: i32, f: &dyn Fn(usize) -> f64| pack.list(digits, picked.iter().map(|&i| f(i)));
    let mut out = json!({
        "x": of(DIGITS, &|i| locations[i].centre.x),
        "y": of(DIGITS, &|i| locations[i].centre.y),
        "z": of(DIGITS, &|i| locations[i].centre.z),
        "s": of(DIGITS, &|i| locations[i].s_mm),
        "turn_s": of(DIGITS, &|i| locations[i].turn_s_mm),
        "t": of(TIME, &|i| plan.motion.t_s.get(i).copied().unwrap_or(f64::NAN)),
        "theta": of(RADIANS, &|i| plan.schedule.theta[i]),
        "min": of(LIMITS, &|i| plan.channel.rows[i].theta_min),
        "max": of(LIMITS, &|i| plan.channel.rows[i].theta_max),
        "row": of(0, &|i| i as f64),
        "of": n, "b": same.map(|c| c.lean_rad), "turns": plan.toolpath.turns.len(),
        "quantities": quantities,
    });
    // Where one lean and θ do not say it: the tool axes themselves.
    if same.is_none() {
        let axis = |i: usize| plan.toolpath.cone(i).tool_axis(plan.schedule.theta[i]);
        for (key, k) in [("ix", 0), ("iy", 1), ("iz", 2)] {
            out[key] = of(RADIANS, &|i| axis(i)[k]);
        }
        out["part"] = part_on_machine(input, plan, &picked, pack);
    }
    out
}

/// Where the part is on the machine at locations of a plan: lists of its rotation's quaternion
/// (x, y, z, w) and of where the blade frame's origin is, mm.
fn part_on_machine(input: &ReportInput, plan: &Plan, picked: &[usize], pack: &mut Pack) -> Value {
    let mut last = None;
    let place = |i: &usize| {
        let Some(at) = plan.motion.position.get(*i) else { return [f64::NAN; 7] };
        let place = input.machine.part_at(at);
        let mut q = *place.rotation.quaternion();
        // Both signs are the same rotation; between neighbours the script takes the mean.
        if last.is_some_and(|l: nalgebra::Quaternion<f64>| l.dot(&q) < 0.0) {
            q = -q;
        }
        last = Some(q);
        let t = place.translation.vector;
        [q.i, q.j, q.k, q.w, t.x, t.y, t.z]
    };
    let places: Vec<[f64; 7]> = picked.iter().map(place).collect();
    let list = |k: usize| pack.list(if k < 4 { RADIANS } else { DIGITS }, places.iter().map(|p| p[k]));
    Value::Array((0..7).map(list).collect())
}
