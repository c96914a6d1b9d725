//! A glTF 2.0 scene in one binary file (`.glb`): what a run did, for any viewer.
//!
//! Below the root node everything is in the model frame in millimetres; the root node scales to
//! metres and turns the model's +Z up (glTF's +Y). Nodes:
//!
//! * `workpiece`, moved by the machine's animation:
//!   * `blade`: one primitive and material for each kind of face, smooth normals up to a crease
//!     angle;
//!   * `path`: a ribbon through the ball centres, one primitive a turn; its material is chosen by
//!     `KHR_materials_variants`: coloured by turn, scallop, width of the channel, feed or axis
//!     acceleration, dark for low values and bright for high ones (the scales stand in the node's
//!     `extras`); the last variant shows contacts, channel, base vectors and altered points too,
//!     which are unseen otherwise;
//!   * `leads`: ball centres of lead-in and lead-out, and the beginning of the straight way along
//!     the tool axis;
//!   * `cutter contacts`: where the ball touches the part;
//!   * `uncut`, where there is any: what no ball of this radius can reach, red;
//!   * `channel`: the angles that the whole tool may take, as fans, at the narrowest place of turns
//!     and, orange, of all;
//!   * `base vectors`: the tool axis at each turn's base point; `altered points`: where the
//!     curvature of sections changes sign;
//!   * `neighbours`, where the blade is one of a wheel: the other blades and the hub that the
//!     checks keep the tool from, one node for each; those beside the blade share its triangles,
//!     all others share a thinner mesh;
//!   * `table`: the machine's table, schematic;
//! * `tool`: origin at the ball centre, +Z towards the spindle, moved by both animations; its parts
//!   are nodes of their own (`ball`, `taper`, `shank`, `holder 1` …), and so is `head`: spindle and
//!   pivot, schematic, true in length only.
//!
//! Animations: the part fixed, and as on the machine ([`motion`]); real time × the factor in their
//! names.
//!
//! **Size**: [`GltfOptions::budget_bytes`] is kept by drawing fewer triangles (vertices clustered
//! on a grid), fewer path points (every so many locations) and fewer keys, all by the same share;
//! each node says in its `extras` what it shows.

mod blade;
mod deviation;
mod glb;
mod machine;
mod marks;
mod motion;
mod neighbours;
mod path;
mod pinch;
mod revolved;
mod tool;
mod uncut;

use gltf_json as json;
use json::Index;
use json::scene::{Node, UnitQuaternion};
use serde_json::json;

use crate::artifact::region::Area;
use crate::artifact::{Blade, CheckReport, Obstacle, Plan, Section};
use crate::error::{Error, Result, Stage};
use crate::geometry::mesh::Mesh;
use crate::machine::Machine;
use crate::tool::Tool;
pub use deviation::deviation;
use glb::Glb;
pub use pinch::{PinchKey, PinchScene, pinch, pinch_parts};

/// How large the file may be and how it is played.
#[derive(Clone, Debug, PartialEq)]
pub struct GltfOptions {
    /// Most bytes. Default 10 MB. What cannot be left out (a few triangles, two points a turn) may
    /// exceed a smaller one.
    pub budget_bytes: usize,
    /// Triangles whose normals differ by more meet at an edge, degrees. Default 30.
    pub crease_deg: f64,
    /// A longer machining time is played faster, to take this long, s. Default 120.
    pub max_play_s: f64,
    /// Path with its colours and animations: what a viewer with colours and motions of its own
    /// leaves out. Default true.
    pub path_and_motion: bool,
    /// Coordinates of points and normals are rounded, so that the file packs well: points by at
    /// most 2⁻¹⁶ of the greatest size of a coordinate of their mesh (1.6 µm in 100 mm), normals by
    /// at most 2⁻¹⁰. Default false.
    pub rounded: bool,
}

impl Default for GltfOptions {
    fn default() -> Self {
        GltfOptions {
            budget_bytes: 10_000_000,
            crease_deg: 30.0,
            max_play_s: 120.0,
            path_and_motion: true,
            rounded: false,
        }
    }
}

/// What a scene is made from.
#[derive(Clone, Copy)]
pub struct Scene<'a> {
    /// The blade.
    pub blade: &'a Blade,
    /// What stands about it: of this the rest of its wheel is drawn. May be empty.
    pub obstacles: &'a [Obstacle],
    /// The tool.
    pub tool: &'a Tool,
    /// The machine.
    pub machine: &'a Machine,
    /// The plan; `None`: the blade alone.
    pub plan: Option<&'a Plan>,
    /// Plane sections; may be empty.
    pub sections: &'a [Section],
    /// What the checks found.
    pub checks: Option<&'a CheckReport>,
    /// Figures of the run, for the root's `extras`.
    pub figures: Option<&'a serde_json::Value>,
    /// How.
    pub options: &'a GltfOptions,
}

impl Scene<'_> {
    /// How many times faster than real time the animations run.
    fn play_speed(&self, plan: &Plan) -> f64 {
        (plan.motion.time_s / self.options.max_play_s.max(1e-3)).max(1.0)
    }
}

/// How much is drawn.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Detail {
    triangles: usize,
    path_points: usize,
    keys: usize,
}

impl Detail {
    /// Shares of a budget by what each takes: 30 bytes a triangle, 78 a point of path and contacts,
    /// 116 a key.
    fn of(budget_bytes: usize) -> Self {
        Detail { triangles: budget_bytes / 75, path_points: budget_bytes / 170, keys: (budget_bytes / 1500).min(6000) }
    }

    fn scaled(self, share: f64) -> Self {
        let less = |n: usize| (n as f64 * share) as usize;
        Detail { triangles: less(self.triangles), path_points: less(self.path_points), keys: less(self.keys) }
    }
}

/// What is unseen but in the variant of all layers: it would hide the path.
const UNSEEN: [&str; 4] = ["altered points", "cutter contacts", "channel", "base vectors"];
/// Times that a scene too large is made again, smaller.
const TRIES: usize = 6;

/// The scene as the bytes of a `.glb` file.
///
/// # Errors
/// `Usage` where a coordinate, angle or time is not a finite number; `InputOutput` where the scene
/// cannot be encoded (over 4 GiB).
pub fn gltf(scene: &Scene) -> Result<Vec<u8>> {
    let budget = scene.options.budget_bytes.max(1);
    let mut detail = Detail::of(budget);
    // A turn of the table needs some keys, or it would be played as another one.
    let least_keys = 24 * scene.plan.map_or(0, |p| p.toolpath.turns.len());
    for _ in 0..TRIES {
        let bytes = built(scene, &Detail { keys: detail.keys.max(least_keys), ..detail })?;
        if bytes.len() <= budget {
            return Ok(bytes);
        }
        detail = detail.scaled(0.9 * budget as f64 / bytes.len() as f64);
    }
    built(scene, &Detail { keys: detail.keys.max(least_keys), ..detail })
}

fn built(scene: &Scene, detail: &Detail) -> Result<Vec<u8>> {
    let mut glb = Glb::new(scene.options.rounded);
    let mut on_table = Vec::new();
    let shown = blade::primitives(&mut glb, scene.blade, detail.triangles, scene.options.crease_deg)?;
    on_table.extend(shown.as_ref().map(|shown| blade::node(&mut glb, shown)));
    on_table.extend(neighbours::node(&mut glb, scene, shown.as_ref(), detail)?);
    on_table.extend(uncut::node(&mut glb, scene)?);
    on_table.extend(marks::altered_points(&mut glb, scene)?);
    let (mut children, mut animations) = (Vec::new(), Vec::new());
    if let Some(plan) = scene.plan {
        if scene.options.path_and_motion {
            on_table.extend(path::node(&mut glb, plan, scene, detail)?);
        }
        on_table.extend(path::leads(&mut glb, plan, scene)?);
        on_table.extend(path::contacts(&mut glb, plan, scene, detail)?);
        on_table.extend(marks::fans(&mut glb, plan, scene)?);
        on_table.extend(marks::base_vectors(&mut glb, plan, scene)?);
        on_table.extend(machine::table(&mut glb, scene)?);
    }
    glb.only_in_last_variant(&UNSEEN);
    let workpiece = group(&mut glb, "workpiece", on_table, &json!({ "what": "all that the table turns" }));
    children.push(workpiece);
    if let Some(plan) = scene.plan {
        let tool = tool::node(&mut glb, plan, scene)?;
        children.push(tool);
        if scene.options.path_and_motion {
            animations = motion::animations(&mut glb, plan, scene, (workpiece, tool), detail)?;
        }
    }
    let half = std::f32::consts::FRAC_1_SQRT_2;
    let root = glb.node(Node {
        name: Some(format!("{} (model frame, mm)", scene.blade.name)),
        children: Some(children),
        scale: Some([0.001; 3]),
        rotation: Some(UnitQuaternion([-half, 0.0, 0.0, half])),
        extras: extras(&json!({
            "frame": "model frame of the CAD file, mm, below this node",
            lean_key(scene): scene.plan.map(lean_deg),
            "ball_radius_mm": scene.tool.radius_mm,
            "machine": scene.machine.name,
            "figures": scene.figures,
        })),
        ..empty_node()
    });
    glb.finish(root, animations)
}

/// Name of the lean: with that of the axis that makes it.
fn lean_key(scene: &Scene) -> String {
    let leaning = scene.machine.leaning_axis().map(|k| scene.machine.axes()[k].name.to_lowercase());
    leaning.map_or_else(|| "lean_deg".into(), |axis| format!("head_angle_{axis}_deg"))
}

/// The tool's lean, degrees; the least and the greatest where it differs along the path.
fn lean_deg(plan: &Plan) -> serde_json::Value {
    let [least, most] = plan.leans_rad().map(f64::to_degrees);
    if least == most { json!(least) } else { json!([least, most]) }
}

/// A node that holds others.
fn group(glb: &mut Glb, name: &str, children: Vec<Index<Node>>, note: &serde_json::Value) -> Index<Node> {
    let children = (!children.is_empty()).then_some(children);
    glb.node(Node { name: Some(name.into()), children, extras: extras(note), ..empty_node() })
}

/// The part coloured by what its surface belongs to, one entry of `areas` for each triangle, as the
/// bytes of a `.glb` file. The mesh is in the model frame, mm, and is not thinned.
///
/// # Errors
/// As [`gltf()`].
pub fn regions(name: &str, mesh: &Mesh, areas: &[Area]) -> Result<Vec<u8>> {
    let mut glb = Glb::default();
    let child = blade::regions_node(&mut glb, mesh, areas, GltfOptions::default().crease_deg)?;
    let half = std::f32::consts::FRAC_1_SQRT_2;
    let root = glb.node(Node {
        name: Some(format!("{name} (model frame, mm)")),
        children: child.map(|c| vec![c]),
        scale: Some([0.001; 3]),
        rotation: Some(UnitQuaternion([-half, 0.0, 0.0, half])),
        extras: extras(&json!({ "frame": "model frame of the CAD file, mm, below this node" })),
        ..empty_node()
    });
    glb.finish(root, Vec::new())
}

/// A node with nothing in it.
fn empty_node() -> Node {
    Node {
        camera: None,
        children: None,
        extensions: None,
        extras: None,
        matrix: None,
        mesh: None,
        name: None,
        rotation: None,
        scale: None,
        translation: None,
        skin: None,
        weights: None,
    }
}

/// A node that shows a mesh.
fn mesh_node(
    glb: &mut Glb,
    name: &str,
    primitives: Vec<json::mesh::Primitive>,
    note: serde_json::Value,
) -> Index<Node> {
    let mesh = glb.mesh(name, primitives);
    glb.node(Node { mesh: Some(mesh), name: Some(name.into()), extras: extras(&note), ..empty_node() })
}

/// Extras of a glTF object.
fn extras(value: &serde_json::Value) -> json::Extras {
    serde_json::value::to_raw_value(value).ok()
}

/// A coordinate for the file.
fn single(value: f64) -> Result<f32> {
    let v = value as f32;
    if v.is_finite() {
        Ok(v)
    } else {
        Err(Error::usage(Stage::Preview, format!("a coordinate is {value}, the preview cannot show it")))
    }
}

/// A point or vector for the file.
fn triple(v: &crate::geometry::Vector) -> Result<[f32; 3]> {
    Ok([single(v.x)?, single(v.y)?, single(v.z)?])
}

#[cfg(test)]
mod tests;
