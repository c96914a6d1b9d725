//! A glTF 2.0 scene in one binary file (`.glb`): the blade, the path coloured by turn, the tool, and the tool's motion.
//!
//! Below the root node everything is in the model frame in millimetres; the root node scales to metres and turns
//! the model's +Z up (glTF's +Y). Nodes:
//!
//! * `blade`: one primitive and material for each kind of face, smooth normals up to a crease angle;
//! * `path`: ball centres, one `LINE_STRIP` a turn, coloured from the first turn (dark violet) to the last (yellow);
//! * `uncut`, where there is any: what no ball of this radius can reach, red;
//! * `channel` (optional): at some locations the two limits of the tool axis;
//! * `tool`: surface of revolution, origin at the ball centre, +Z towards the spindle; moved by the animation.
//!
//! Limits: meshes over the budget are thinned by clustering vertices on a grid, the path by leaving out locations, the
//! animation to at most [`GltfOptions::max_keys`] keys; each says so in its node's `extras`.

mod blade;
mod glb;
mod motion;
mod tool;
mod uncut;

use gltf_json as json;
use json::Index;
use json::scene::{Node, UnitQuaternion};
use serde_json::json;

use crate::artifact::blade::Area;
use crate::artifact::report::UncutPlace;
use crate::artifact::{Blade, Plan};
use crate::error::{Error, Result, Stage};
use crate::geometry::mesh::Mesh;
use crate::tool::Tool;
use glb::Glb;

/// What the scene shows besides blade, path and tool, and how large it may be.
#[derive(Clone, Debug, PartialEq)]
pub struct GltfOptions {
    /// Most triangles of the blade. Default 300 000.
    pub max_triangles: usize,
    /// Most points of the path. Default 200 000.
    pub max_path_points: usize,
    /// Most keys of the animation. Default 5000.
    pub max_keys: usize,
    /// Triangles whose normals differ by more meet at an edge, degrees. Default 30.
    pub crease_deg: f64,
    /// A longer machining time is played faster, to take this long, s. Default 120.
    pub max_play_s: f64,
    /// Show limits of the channel at some locations. Default true.
    pub channel_limits: bool,
    /// Places that stay uncut, blade frame. Default: none.
    pub uncut: Vec<UncutPlace>,
    /// Area that each of them stands for, mm².
    pub uncut_cell_mm2: f64,
}

impl Default for GltfOptions {
    fn default() -> Self {
        GltfOptions {
            max_triangles: 300_000,
            max_path_points: 200_000,
            max_keys: 5000,
            crease_deg: 30.0,
            max_play_s: 120.0,
            channel_limits: true,
            uncut: Vec::new(),
            uncut_cell_mm2: 0.0,
        }
    }
}

/// The scene as the bytes of a `.glb` file. `plan`: `None` shows the blade alone.
///
/// # Errors
/// `Usage` where a coordinate, angle or time is not a finite number; `InputOutput` where the scene cannot be encoded
/// (over 4 GiB).
pub fn gltf(plan: Option<&Plan>, blade: &Blade, tool: &Tool, options: &GltfOptions) -> Result<Vec<u8>> {
    let mut glb = Glb::default();
    let mut children = Vec::new();
    children.extend(blade::node(&mut glb, blade, options)?);
    children.extend(uncut::node(&mut glb, blade, options)?);
    let mut animations = Vec::new();
    if let Some(plan) = plan {
        children.extend(motion::path_node(&mut glb, plan, blade, options)?);
        if options.channel_limits {
            children.extend(motion::channel_node(&mut glb, plan, blade, tool, options)?);
        }
        let tool_node = tool::node(&mut glb, tool)?;
        children.push(tool_node);
        animations.extend(motion::animation(&mut glb, plan, blade, tool_node, options)?);
    }
    let half = std::f32::consts::FRAC_1_SQRT_2;
    let root = glb.node(Node {
        name: Some(format!("{} (model frame, mm)", blade.name)),
        children: (!children.is_empty()).then_some(children),
        scale: Some([0.001; 3]),
        rotation: Some(UnitQuaternion([-half, 0.0, 0.0, half])),
        extras: extras(&json!({
            "frame": "model frame of the CAD file, mm, below this node",
            "head_angle_b_deg": plan.map(|p| p.channel.b_rad.to_degrees()),
            "ball_radius_mm": tool.radius_mm,
        })),
        ..empty_node()
    });
    glb.finish(root, animations)
}

/// The part coloured by what its surface belongs to, one entry of `areas` for each triangle, as the bytes of a `.glb` file. The mesh
/// is in the model frame, mm, and is not thinned.
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
