//! The tool as a surface of revolution: origin at the ball centre, +Z towards the spindle.

use std::f64::consts::FRAC_PI_2;

use gltf_json as json;
use json::Index;
use json::scene::Node;
use serde_json::json;

use super::glb::Glb;
use super::revolved::{ProfileRing, revolved};
use super::{Scene, mesh_node, single, triple};
use crate::artifact::Plan;
use crate::error::Result;
use crate::tool::Tool;

/// Facets from the tip to where the cone leaves the ball.
const BALL: u32 = 16;

/// The node with a child for each part of the tool and one for the machine's head, where the path
/// begins.
pub(super) fn node(glb: &mut Glb, plan: &Plan, scene: &Scene) -> Result<Index<Node>> {
    let tool = scene.tool;
    let mut children = Vec::new();
    for (name, rings) in &parts(tool) {
        let shown = revolved(glb, name, look(name), rings)?;
        children.push(mesh_node(glb, name, vec![shown], json!({ "part_of": "tool" })));
    }
    children.push(super::machine::head(glb, plan, scene)?);
    let note = json!({
        "origin": "ball centre", "z": "towards the spindle", "ball_radius_mm": tool.radius_mm,
        "taper_half_angle_deg": tool.taper_deg, "stickout_mm": tool.stickout_mm,
    });
    let node = super::group(glb, "tool", children, &note);
    if let Some(stand) = plan.stand(0) {
        let q = scene.blade.model_from_blade.rotation * super::motion::attitude(&stand);
        let at = triple(&(scene.blade.model_from_blade * stand.centre).coords)?;
        glb.place(node, at, [single(q.i)?, single(q.j)?, single(q.k)?, single(q.w)?]);
    }
    Ok(node)
}

/// Ball, taper, shank and holder stages as rings.
fn parts(tool: &Tool) -> Vec<(String, Vec<ProfileRing>)> {
    let mut parts: Vec<(String, Vec<ProfileRing>)> = vec![("ball".into(), ball(tool))];
    let mut before = tool.radius_mm * tool.taper_deg.to_radians().cos();
    for s in tool.segments() {
        let slope = (s.r1 - s.r0).atan2(s.z1 - s.z0);
        let (nz, nr) = (-slope.sin(), slope.cos());
        // A step of the radius is a ring across the axis, facing the side that is open.
        let face = if s.r0 > before { -1.0 } else { 1.0 };
        let mut rings = Vec::new();
        if (s.r0 - before).abs() > 1e-9 {
            rings.extend([[s.z0, before, 0.0, face], [s.z0, s.r0, 0.0, face]]);
        }
        rings.extend([[s.z0, s.r0, nr, nz], [s.z1, s.r1, nr, nz]]);
        before = s.r1;
        parts.push((s.part.to_string(), rings));
    }
    if let Some((_, rings)) = parts.last_mut() {
        let top = rings.last().map_or(0.0, |r| r[0]);
        rings.extend([[top, before, 0.0, 1.0], [top, 0.0, 0.0, 1.0]]);
    }
    parts
}

fn ball(tool: &Tool) -> Vec<ProfileRing> {
    let end = tool.taper_deg.to_radians();
    (0..=BALL)
        .map(|i| {
            let angle = -FRAC_PI_2 + (end + FRAC_PI_2) * f64::from(i) / f64::from(BALL);
            let (s, c) = angle.sin_cos();
            [tool.radius_mm * s, tool.radius_mm * c.max(0.0), c.max(0.0), s]
        })
        .collect()
}

fn look(name: &str) -> [f32; 3] {
    match name {
        "ball" => [0.80, 0.25, 0.02],
        "taper" | "shank" => [0.70, 0.45, 0.05],
        _ => [0.10, 0.25, 0.42],
    }
}
