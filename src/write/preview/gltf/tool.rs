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
    let mut children = part_nodes(glb, tool, &LOOK)?;
    children.push(super::machine::head(glb, plan, scene)?);
    let note = if tool.is_ball() {
        json!({
            "origin": "ball centre", "z": "towards the spindle", "ball_radius_mm": tool.radius_mm,
            "taper_half_angle_deg": tool.taper_deg, "stickout_mm": tool.stickout_mm,
        })
    } else {
        json!({
            "origin": "centre of the disc that the corner rolls over", "z": "towards the spindle",
            "radius_mm": tool.radius_mm, "corner_radius_mm": tool.corner_mm(),
            "taper_half_angle_deg": tool.taper_deg, "stickout_mm": tool.stickout_mm,
        })
    };
    let node = super::group(glb, "tool", children, &note);
    if let Some(stand) = plan.stand(0) {
        let q = scene.blade.model_from_blade.rotation * super::motion::attitude(&stand);
        let at = triple(&(scene.blade.model_from_blade * stand.centre).coords)?;
        glb.place(node, at, [single(q.i)?, single(q.j)?, single(q.k)?, single(q.w)?]);
    }
    Ok(node)
}

/// A tool without a machine's head, in no place yet, in colours of its own.
pub(super) fn alone(glb: &mut Glb, tool: &Tool, name: &str, look: &Look) -> Result<Index<Node>> {
    let children = part_nodes(glb, tool, look)?;
    Ok(super::group(glb, name, children, &json!({ "origin": "ball centre", "z": "towards the spindle" })))
}

/// A node for each part of a tool.
fn part_nodes(glb: &mut Glb, tool: &Tool, look: &Look) -> Result<Vec<Index<Node>>> {
    let mut out = Vec::new();
    for (name, rings) in &parts(tool) {
        let shown = revolved(glb, name, look.of(name), rings)?;
        out.push(mesh_node(glb, name, vec![shown], json!({ "part_of": "tool" })));
    }
    Ok(out)
}

/// Ball or corner, taper, shank and holder stages as rings.
fn parts(tool: &Tool) -> Vec<(String, Vec<ProfileRing>)> {
    let name = if tool.is_ball() { "ball" } else { "corner" };
    let mut parts: Vec<(String, Vec<ProfileRing>)> = vec![(name.into(), end(tool))];
    let mut before = tool.disc_radius_mm() + tool.corner_mm() * tool.taper_deg.to_radians().cos();
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

/// The ball, or the flat bottom and the corner.
fn end(tool: &Tool) -> Vec<ProfileRing> {
    let (end, disc, corner) = (tool.taper_deg.to_radians(), tool.disc_radius_mm(), tool.corner_mm());
    let arc = (0..=BALL).map(|i| {
        let angle = -FRAC_PI_2 + (end + FRAC_PI_2) * f64::from(i) / f64::from(BALL);
        let (s, c) = angle.sin_cos();
        [corner * s, disc + corner * c.max(0.0), c.max(0.0), s]
    });
    let bottom = (!tool.is_ball()).then_some([-corner, 0.0, 0.0, -1.0]);
    bottom.into_iter().chain(arc).collect()
}

/// Colours of a tool, linear RGB.
pub(super) struct Look {
    /// What cuts.
    pub(super) end: [f32; 3],
    /// Taper and shank.
    pub(super) shank: [f32; 3],
    /// Holder.
    pub(super) holder: [f32; 3],
}

/// A tool that is the only one.
const LOOK: Look = Look { end: [0.80, 0.25, 0.02], shank: [0.70, 0.45, 0.05], holder: [0.10, 0.25, 0.42] };

impl Look {
    fn of(&self, part: &str) -> [f32; 3] {
        match part {
            "ball" | "corner" => self.end,
            "taper" | "shank" => self.shank,
            _ => self.holder,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// From the middle of the flat bottom over the corner to where the cone begins, without a step.
    #[test]
    fn a_corner_has_a_flat_bottom() {
        let bull = Tool { radius_mm: 8.0, corner_radius_mm: Some(2.0), ..crate::sample::tool() };
        let parts = parts(&bull);
        assert_eq!(parts[0].0, "corner");
        let rings = &parts[0].1;
        assert_eq!(rings[0], [-2.0, 0.0, 0.0, -1.0]);
        assert!((rings[1][0] + 2.0).abs() < 1e-12 && (rings[1][1] - 6.0).abs() < 1e-12, "{:?}", rings[1]);
        let (last, next) = (rings[rings.len() - 1], parts[1].1[0]);
        assert!((last[0] - next[0]).abs() < 1e-12 && (last[1] - next[1]).abs() < 1e-12, "{last:?} {next:?}");
        assert_eq!(super::parts(&crate::sample::tool())[0].0, "ball");
    }
}
