//! Two animations of the same run: the part fixed, and as on the machine.
//!
//! * *part fixed*: the tool moves in the model frame, the workpiece rests;
//! * *as on the machine*: the table turns the workpiece, the head keeps its direction and its axes
//!   carry the ball centre. The machine's Z is the model's z (up in a viewer), its X the model's x;
//!   the table's axis passes through where the middle of the part rests, so that nothing jumps out
//!   of sight.

use gltf_json as json;
use json::animation::{Animation, Channel, Interpolation, Property, Sampler, Target};
use json::scene::Node;
use json::validation::Checked;
use json::{Index, accessor::Accessor};
use nalgebra::{Matrix3, Rotation3, UnitQuaternion};
use serde_json::json;

use super::glb::Glb;
use super::{Detail, Scene, extras, single, triple};
use crate::artifact::{Plan, Stand};
use crate::error::Result;
use crate::geometry::{Rigid, Vector};

/// `count` of `0..n` at most, evenly, first and last among them.
fn evenly(n: usize, count: usize) -> Vec<usize> {
    let count = count.clamp(2, n.max(2));
    if n <= count {
        return (0..n).collect();
    }
    (0..count).map(|k| k * (n - 1) / (count - 1)).collect()
}

/// Places of a node over time, translations and rotations `(x, y, z, w)`.
#[derive(Default)]
pub(super) struct Track {
    at: Vec<[f32; 3]>,
    turned: Vec<[f32; 4]>,
    last: Option<nalgebra::Quaternion<f64>>,
}

impl Track {
    pub(super) fn push(&mut self, place: &Rigid) -> Result<()> {
        let mut q = *place.rotation.quaternion();
        // Both signs are the same rotation; the one near the key before is interpolated the short
        // way.
        if self.last.is_some_and(|l| l.dot(&q) < 0.0) {
            q = -q;
        }
        self.last = Some(q);
        self.at.push(triple(&place.translation.vector)?);
        self.turned.push([single(q.i)?, single(q.j)?, single(q.k)?, single(q.w)?]);
        Ok(())
    }

    /// The first place.
    pub(super) fn first(&self) -> Option<([f32; 3], [f32; 4])> {
        Some((*self.at.first()?, *self.turned.first()?))
    }
}

/// The tool's +Z to its axis: leaning, then turning about the axis of its cone by θ, without any
/// jump.
pub(super) fn attitude(stand: &Stand) -> UnitQuaternion<f64> {
    let turn = UnitQuaternion::from_axis_angle(&Vector::x_axis(), stand.theta) * lean(stand.cone.lean_rad);
    if stand.cone.is_about_blade() {
        return turn;
    }
    let (c, e) = (stand.cone.axis, stand.cone.reference);
    let frame = Rotation3::from_matrix_unchecked(Matrix3::from_columns(&[c, e, c.cross(&e)]));
    UnitQuaternion::from_rotation_matrix(&frame) * turn
}

/// The angle of the tool axis about the blade axis, which the table of a machine turns the part by,
/// rad.
fn about_the_blade(stand: &Stand) -> f64 {
    let a = stand.axis();
    if stand.cone.is_about_blade() { stand.theta } else { a.z.atan2(a.y) }
}

/// The tool's +Z to the tool axis at θ = 0, in the frame of a cone.
pub(super) fn lean(b_rad: f64) -> UnitQuaternion<f64> {
    let (sb, cb) = b_rad.sin_cos();
    UnitQuaternion::rotation_between(&Vector::z(), &Vector::new(sb, cb, 0.0)).unwrap_or_default()
}

/// The part's place on the machine at a location: where its axes stand, where each location has a
/// cone of its own; else as [`crate::machine::Machine::shown_part`] shows it.
fn part_on_machine(plan: &Plan, scene: &Scene, stand: &Stand, row: usize) -> Rigid {
    let at = plan.motion.position.get(row).filter(|_| plan.toolpath.cones.same().is_none());
    at.map_or_else(|| scene.machine.shown_part(about_the_blade(stand)), |at| scene.machine.part_at(at))
}

/// The machine frame's place in the scene, which is the model frame.
fn scene_from_machine(plan: &Plan, scene: &Scene) -> Rigid {
    let mid = scene.blade.part.mesh.aabb().map_or(crate::geometry::Point::origin(), |b| b.min + (b.max - b.min) * 0.5);
    if plan.toolpath.cones.same().is_none()
        && let Some(stand) = plan.stand(0)
    {
        let at_first = part_on_machine(plan, scene, &stand, 0) * mid;
        return Rigid::from_parts((scene.blade.model_from_blade * mid - at_first).into(), UnitQuaternion::identity());
    }
    let (at_zero, [axis_y, axis_z], _) = scene.machine.shown_table();
    let mut axis = at_zero * mid;
    (axis.y, axis.z) = (axis_y, axis_z);
    Rigid::from_parts((scene.blade.model_from_blade * mid - axis).into(), UnitQuaternion::identity())
}

/// Both animations; none where there are not two keys. `workpiece` and `tool` are the nodes that
/// move.
pub(super) fn animations(
    glb: &mut Glb,
    plan: &Plan,
    scene: &Scene,
    (workpiece, tool): (Index<Node>, Index<Node>),
    detail: &Detail,
) -> Result<Vec<Animation>> {
    let n = plan.toolpath.locations.len().min(plan.schedule.theta.len()).min(plan.motion.t_s.len());
    let speed = scene.play_speed(plan);
    let model = &scene.blade.model_from_blade;
    let (to_scene, part_from_model) = (scene_from_machine(plan, scene), model.inverse());
    let mut times: Vec<f32> = Vec::new();
    let [mut fixed, mut carried, mut turned] = [Track::default(), Track::default(), Track::default()];
    for i in evenly(n, detail.keys) {
        let time = single(plan.motion.t_s[i] / speed)?;
        if times.last().is_some_and(|t| time <= *t) {
            continue;
        }
        times.push(time);
        let Some(stand) = plan.stand(i) else { continue };
        let in_part = Rigid::from_parts(stand.centre.coords.into(), attitude(&stand));
        let table = to_scene * part_on_machine(plan, scene, &stand, i);
        fixed.push(&(model * in_part))?;
        carried.push(&(table * in_part))?;
        turned.push(&(table * part_from_model))?;
    }
    if times.len() < 2 {
        return Ok(Vec::new());
    }
    let input = glb.times(&times);
    let note =
        |what: &str| json!({ "what": what, "machining_time_s": plan.motion.time_s, "played_times_faster": speed });
    let ends = [times[0], times[times.len() - 1]];
    let (mut rest, ends) = (Track::default(), glb.times(&ends));
    rest.push(&Rigid::identity())?;
    rest.push(&Rigid::identity())?;
    let name = |what: &str| format!("{what}, {speed:.1} x real time");
    Ok(vec![
        animation(
            glb,
            &[(tool, input, fixed), (workpiece, ends, rest)],
            name("part fixed"),
            &note("the tool moves, the part rests"),
        ),
        animation(
            glb,
            &[(tool, input, carried), (workpiece, input, turned)],
            name("as on the machine"),
            &note("the table turns the part, the head keeps its direction"),
        ),
    ])
}

/// A node that moves, its key times, its places.
pub(super) type MovedNode = (Index<Node>, Index<Accessor>, Track);

pub(super) fn animation(glb: &mut Glb, tracks: &[MovedNode], name: String, note: &serde_json::Value) -> Animation {
    let (mut channels, mut samplers) = (Vec::new(), Vec::new());
    for (node, input, track) in tracks {
        for (path, output) in
            [(Property::Translation, glb.translations(&track.at)), (Property::Rotation, glb.rotations(&track.turned))]
        {
            channels.push(Channel {
                sampler: Index::new(u32::try_from(samplers.len()).unwrap_or(0)),
                target: Target { extensions: None, extras: None, node: *node, path: Checked::Valid(path) },
                extensions: None,
                extras: None,
            });
            samplers.push(Sampler {
                extensions: None,
                extras: None,
                input: *input,
                interpolation: Checked::Valid(Interpolation::Linear),
                output,
            });
        }
    }
    Animation { extensions: None, extras: extras(note), channels, name: Some(name), samplers }
}
