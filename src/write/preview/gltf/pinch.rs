//! Two tools on one blade: the part, the rows of both on it, and both tools moving along them.

use gltf_json as json;
use json::Index;
use json::mesh::{Mode, Semantic};
use json::scene::{Node, UnitQuaternion};
use serde_json::json;

use super::glb::Glb;
use super::motion::Track;
use super::{Detail, GltfOptions, blade, empty_node, extras, group, mesh_node, motion, single, tool, triple};
use crate::artifact::region::Area;
use crate::artifact::{Blade, Stand};
use crate::error::Result;
use crate::geometry::mesh::Mesh;
use crate::geometry::{Point, Rigid};
use crate::tool::Tool;
use crate::write::preview::thin::thinned;

/// Most triangles of the part.
const TRIANGLES: usize = 150_000;
/// The animation takes about so long, s.
const PLAYED_S: f64 = 90.0;
/// Colours of the rows of tool 1 and tool 2.
const ROWS: [(&str, [f32; 3]); 2] = [("rows of tool 1", [0.0, 0.17, 0.44]), ("rows of tool 2", [0.66, 0.11, 0.0])];
/// Colours of both tools: those of their rows, paler towards the spindle.
const LOOKS: [tool::Look; 2] = [
    tool::Look { end: [0.0, 0.17, 0.44], shank: [0.09, 0.45, 0.80], holder: [0.10, 0.25, 0.42] },
    tool::Look { end: [0.66, 0.11, 0.0], shank: [0.90, 0.42, 0.13], holder: [0.38, 0.17, 0.09] },
];

/// Where both tools stand at a time.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PinchKey {
    /// Time, s.
    pub t_s: f64,
    /// The stretch of a row, from 0.
    pub stretch: usize,
    /// The place in the rows where both tools cut; `None`: both are lifted from it.
    pub place: Option<usize>,
    /// Tool 1 and tool 2.
    pub stands: [Stand; 2],
}

/// What the scene of two tools is made from; blade frame.
pub struct PinchScene<'a> {
    /// Name of the blade.
    pub name: &'a str,
    /// The part.
    pub mesh: &'a Mesh,
    /// What each triangle belongs to.
    pub areas: &'a [Area],
    /// Blade frame to model frame.
    pub model_from_blade: &'a Rigid,
    /// Both cutters.
    pub tools: [&'a Tool; 2],
    /// Contacts of the rows of both, a little over the surface.
    pub rows: [Vec<Vec<Point>>; 2],
    /// Both tools over time, which rises.
    pub keys: &'a [PinchKey],
}

/// Name of a tool's node, by its number from 0.
fn tool_name(tool: usize) -> String {
    format!("tool {}", tool + 1)
}

/// The part and both tools without rows and motion, as GLB: for a viewer that has these itself. The
/// part is the node `blade` of `workpiece`, in the model frame, mm; `tool 1` and `tool 2` stand at
/// the origin.
///
/// # Errors
/// As [`super::gltf()`].
pub fn pinch_parts(blade: &Blade, tools: [&Tool; 2], options: &GltfOptions) -> Result<Vec<u8>> {
    let mut glb = Glb::new(options.rounded);
    let triangles = Detail::of(options.budget_bytes).triangles;
    let shown = blade::primitives(&mut glb, blade, triangles, options.crease_deg)?;
    let part = shown.iter().map(|shown| blade::node(&mut glb, shown)).collect();
    let mut children = vec![group(&mut glb, "workpiece", part, &json!({ "what": "all that the table turns" }))];
    for (k, look) in LOOKS.iter().enumerate() {
        children.push(tool::alone(&mut glb, tools[k], &tool_name(k), look)?);
    }
    let root = group(&mut glb, "model frame, mm", children, &json!({ "frame": "model frame of the CAD file, mm" }));
    glb.finish(root, Vec::new())
}

/// The scene as GLB.
///
/// # Errors
/// As [`super::gltf()`].
pub fn pinch(scene: &PinchScene) -> Result<Vec<u8>> {
    let mut glb = Glb::default();
    let (thin, _) = thinned(scene.mesh, TRIANGLES);
    // What each triangle is is known of the whole mesh only.
    let areas: &[Area] = if thin.triangles.len() == scene.mesh.triangles.len() { scene.areas } else { &[] };
    let mesh = thin.moved(scene.model_from_blade);
    let mut children: Vec<Index<Node>> =
        blade::regions_node(&mut glb, &mesh, areas, GltfOptions::default().crease_deg)?.into_iter().collect();
    for (rows, (name, rgb)) in scene.rows.iter().zip(ROWS) {
        let material = glb.material(name, rgb, false);
        let mut primitives = Vec::new();
        for row in rows.iter().filter(|row| row.len() > 1) {
            let placed = row.iter().map(|p| triple(&(scene.model_from_blade * p).coords));
            let points = placed.collect::<Result<Vec<_>>>()?;
            let attributes = [(Semantic::Positions, glb.positions(&points))];
            primitives.push(Glb::primitive(attributes, None, material, Mode::LineStrip));
        }
        if !primitives.is_empty() {
            children.push(mesh_node(&mut glb, name, primitives, json!({ "what": "contacts, one strip a row" })));
        }
    }
    let mut moved = Vec::new();
    let total_s = scene.keys.last().map_or(0.0, |k| k.t_s);
    let speed = (total_s / PLAYED_S).max(1.0);
    let mut times: Vec<f32> = Vec::new();
    let mut kept = Vec::new();
    for key in scene.keys {
        let time = single(key.t_s / speed)?;
        if times.last().is_none_or(|t| time > *t) {
            times.push(time);
            kept.push(key);
        }
    }
    let input = glb.times(&times);
    for k in 0..2 {
        let node = tool::alone(&mut glb, scene.tools[k], &tool_name(k), &LOOKS[k])?;
        let mut track = Track::default();
        for key in &kept {
            let stand = &key.stands[k];
            let in_part = Rigid::from_parts(stand.centre.coords.into(), motion::attitude(stand));
            track.push(&(scene.model_from_blade * in_part))?;
        }
        if let Some((at, turned)) = track.first() {
            glb.place(node, at, turned);
        }
        children.push(node);
        moved.push((node, input, track));
    }
    let animations = match times.len() {
        0 | 1 => Vec::new(),
        _ => {
            let note = json!({ "what": "both tools move, the part rests", "played_times_faster": speed });
            vec![motion::animation(&mut glb, &moved, format!("part fixed, {speed:.1} x real time"), &note)]
        }
    };
    let half = std::f32::consts::FRAC_1_SQRT_2;
    let root = glb.node(Node {
        name: Some(format!("{} (model frame, mm)", scene.name)),
        children: Some(children),
        scale: Some([0.001; 3]),
        rotation: Some(UnitQuaternion([-half, 0.0, 0.0, half])),
        extras: extras(&json!({ "frame": "model frame of the CAD file, mm, below this node" })),
        ..empty_node()
    });
    glb.finish(root, animations)
}
