//! Two tools on one blade: the part, the rows of both on it, and both tools moving along them.

use gltf_json as json;
use json::Index;
use json::mesh::{Mode, Semantic};
use json::scene::{Node, UnitQuaternion};
use serde_json::json;

use super::glb::Glb;
use super::motion::Track;
use super::{GltfOptions, blade, empty_node, extras, mesh_node, motion, single, tool, triple};
use crate::artifact::Stand;
use crate::artifact::region::Area;
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

/// Where both tools stand at a time.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PinchKey {
    /// Time, s.
    pub t_s: f64,
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
        let node = tool::alone(&mut glb, scene.tools[k], &format!("tool {}", k + 1))?;
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
