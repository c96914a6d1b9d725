//! The path's lines, the channel's limits and the animation of the tool.

use gltf_json as json;
use json::animation::{Animation, Channel, Interpolation, Property, Sampler, Target};
use json::mesh::{Mode, Semantic};
use json::scene::Node;
use json::validation::Checked;
use json::{Index, accessor::Accessor};
use nalgebra::UnitQuaternion;
use serde_json::json;

use super::glb::Glb;
use super::{GltfOptions, extras, mesh_node, single, triple};
use crate::artifact::{Blade, Plan};
use crate::error::Result;
use crate::geometry::Vector;
use crate::tool::{self, Tool};

/// Locations at which the channel's limits are drawn, at most.
const LIMITS: usize = 1500;

/// `count` of `0..n` at most, evenly, first and last among them.
fn evenly(n: usize, count: usize) -> Vec<usize> {
    let count = count.clamp(2, n.max(2));
    if n <= count {
        return (0..n).collect();
    }
    (0..count).map(|k| k * (n - 1) / (count - 1)).collect()
}

/// Colour of a turn, linear, from dark violet over green-blue to yellow (in the manner of the viridis map, told apart
/// also without colour vision because lightness grows all along); every other turn a little darker.
fn colour(turn: usize, turns: usize) -> [u8; 4] {
    const STOPS: [[f64; 3]; 5] =
        [[0.06, 0.0, 0.09], [0.04, 0.08, 0.26], [0.01, 0.28, 0.26], [0.11, 0.58, 0.12], [0.98, 0.80, 0.02]];
    let x = if turns > 1 { turn as f64 / (turns - 1) as f64 } else { 0.5 } * 4.0;
    let i = (x.floor() as usize).min(3);
    let (f, shade) = (x - i as f64, if turn.is_multiple_of(2) { 1.0 } else { 0.75 });
    let mix = |k: usize| ((STOPS[i][k] * (1.0 - f) + STOPS[i + 1][k] * f) * shade * 255.0).round() as u8;
    [mix(0), mix(1), mix(2), 255]
}

/// One line strip a turn; `None` without locations.
pub(super) fn path_node(
    glb: &mut Glb,
    plan: &Plan,
    blade: &Blade,
    options: &GltfOptions,
) -> Result<Option<Index<Node>>> {
    let path = &plan.toolpath;
    let n = path.locations.len();
    let stride = n.div_ceil(options.max_path_points.max(2)).max(1);
    let material = glb.material("path by turn", [1.0; 3], false);
    let mut primitives = Vec::new();
    for (t, turn) in path.turns.iter().enumerate() {
        // To the next turn's base point, so that the strips join.
        let end = turn.first.saturating_add(turn.count).min(n.saturating_sub(1));
        let mut points = Vec::new();
        for i in (turn.first..end).step_by(stride).chain([end]) {
            if let Some(l) = path.locations.get(i) {
                points.push(triple(&(blade.model_from_blade * l.centre).coords)?);
            }
        }
        if points.len() < 2 {
            continue;
        }
        let colours = vec![colour(t, path.turns.len()); points.len()];
        let attributes = [(Semantic::Positions, glb.positions(&points)), (Semantic::Colors(0), glb.colours(&colours))];
        primitives.push(Glb::primitive(attributes, None, material, Mode::LineStrip));
    }
    if primitives.is_empty() {
        return Ok(None);
    }
    let note = json!({
        "what": "ball centres, one strip a turn", "turns": path.turns.len(), "locations": n, "every": stride,
    });
    Ok(Some(mesh_node(glb, "path", primitives, note)))
}

/// From some ball centres, lines along the two limits of the tool axis; `None` without locations.
pub(super) fn channel_node(
    glb: &mut Glb,
    plan: &Plan,
    blade: &Blade,
    tool: &Tool,
    options: &GltfOptions,
) -> Result<Option<Index<Node>>> {
    let n = plan.toolpath.locations.len().min(plan.channel.rows.len());
    if n < 2 {
        return Ok(None);
    }
    let mut ends = [Vec::new(), Vec::new()];
    for i in evenly(n, LIMITS.min(options.max_path_points)) {
        let (l, row) = (&plan.toolpath.locations[i], &plan.channel.rows[i]);
        for (side, theta) in ends.iter_mut().zip([row.theta_min, row.theta_max]) {
            let to = l.centre + tool::axis(plan.channel.b_rad, theta) * (2.0 * tool.radius_mm);
            side.push(triple(&(blade.model_from_blade * l.centre).coords)?);
            side.push(triple(&(blade.model_from_blade * to).coords)?);
        }
    }
    let looks =
        [("least angle of the tool axis", [0.0, 0.17, 0.45]), ("greatest angle of the tool axis", [0.66, 0.11, 0.0])];
    let mut primitives = Vec::new();
    for ((name, rgb), points) in looks.into_iter().zip(&ends) {
        let (positions, material) = (glb.positions(points), glb.material(name, rgb, false));
        primitives.push(Glb::primitive([(Semantic::Positions, positions)], None, material, Mode::Lines));
    }
    let note =
        json!({ "what": "limits of the tool axis, blue: least angle, red: greatest", "shown": ends[0].len() / 2 });
    Ok(Some(mesh_node(glb, "channel", primitives, note)))
}

/// Keys of the tool's motion in the model frame: times as played, ball centres, rotations of the tool's node.
struct Keys {
    times: Vec<f32>,
    centres: Vec<[f32; 3]>,
    rotations: Vec<[f32; 4]>,
}

fn keys(plan: &Plan, blade: &Blade, options: &GltfOptions, speed: f64) -> Result<Keys> {
    let n = plan.toolpath.locations.len().min(plan.schedule.theta.len()).min(plan.motion.t_s.len());
    let (sb, cb) = plan.channel.b_rad.sin_cos();
    // The tool's +Z to the tool axis at θ = 0; turning about the blade axis by θ does the rest without any jump.
    let lean = UnitQuaternion::rotation_between(&Vector::z(), &Vector::new(sb, cb, 0.0)).unwrap_or_default();
    let mut out = Keys { times: Vec::new(), centres: Vec::new(), rotations: Vec::new() };
    let mut last: Option<nalgebra::Quaternion<f64>> = None;
    for i in evenly(n, options.max_keys) {
        let time = single(plan.motion.t_s[i] / speed)?;
        if out.times.last().is_some_and(|t| time <= *t) {
            continue;
        }
        let turn = UnitQuaternion::from_axis_angle(&Vector::x_axis(), plan.schedule.theta[i]);
        let mut q = *(blade.model_from_blade.rotation * turn * lean).quaternion();
        // Both signs are the same rotation; the one near the key before is interpolated the short way.
        if last.is_some_and(|l| l.dot(&q) < 0.0) {
            q = -q;
        }
        last = Some(q);
        out.times.push(time);
        out.centres.push(triple(&(blade.model_from_blade * plan.toolpath.locations[i].centre).coords)?);
        out.rotations.push([single(q.i)?, single(q.j)?, single(q.k)?, single(q.w)?]);
    }
    Ok(out)
}

/// The tool's motion; `None` where there are not two keys.
pub(super) fn animation(
    glb: &mut Glb,
    plan: &Plan,
    blade: &Blade,
    node: Index<Node>,
    options: &GltfOptions,
) -> Result<Option<Animation>> {
    let speed = (plan.motion.time_s / options.max_play_s.max(1e-3)).max(1.0);
    let keys = keys(plan, blade, options, speed)?;
    if keys.times.len() < 2 {
        return Ok(None);
    }
    let input = glb.times(&keys.times);
    let outputs = [
        (Property::Translation, glb.translations(&keys.centres)),
        (Property::Rotation, glb.rotations(&keys.rotations)),
    ];
    let sampler = |output: Index<Accessor>| Sampler {
        extensions: None,
        extras: None,
        input,
        interpolation: Checked::Valid(Interpolation::Linear),
        output,
    };
    let channel = |k: u32, path: Property| Channel {
        sampler: Index::new(k),
        target: Target { extensions: None, extras: None, node, path: Checked::Valid(path) },
        extensions: None,
        extras: None,
    };
    Ok(Some(Animation {
        extensions: None,
        extras: extras(&json!({ "machining_time_s": plan.motion.time_s, "played_times_faster": speed })),
        channels: (0u32..).zip(&outputs).map(|(k, (p, _))| channel(k, *p)).collect(),
        name: Some(format!("tool motion, {speed:.1} x real time")),
        samplers: outputs.iter().map(|(_, o)| sampler(*o)).collect(),
    }))
}
