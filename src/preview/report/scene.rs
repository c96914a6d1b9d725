//! The 3-D picture's data: a small mesh of the blade, the path, the tool's profile; blade frame, mm.

use serde_json::{Value, json};

use super::ReportInput;
use super::data::rounded;
use crate::preview::thin::thinned;

/// Most triangles.
const TRIANGLES: usize = 2500;
/// Most points of the path.
const PATH: usize = 5000;

pub(super) fn scene(input: &ReportInput) -> Value {
    let (mesh, _) = thinned(&input.blade.part.mesh, TRIANGLES);
    let path = input.plan.map(|plan| {
        let n = plan.toolpath.locations.len().min(plan.schedule.theta.len());
        let count = n.min(PATH);
        let pick = |k: usize| if count > 1 { k * (n - 1) / (count - 1) } else { 0 };
        let picked: Vec<usize> = (0..count).map(pick).collect();
        let at = |i: usize| &plan.toolpath.locations[i];
        json!({
            "p": picked.iter().flat_map(|&i| at(i).centre.iter().copied().collect::<Vec<_>>())
                .map(|v| rounded(v, 2)).collect::<Vec<_>>(),
            "turn": picked.iter().map(|&i| at(i).turn).collect::<Vec<_>>(),
            "theta": picked.iter().map(|&i| rounded(plan.schedule.theta[i], 4)).collect::<Vec<_>>(),
            "b": rounded(plan.channel.b_rad, 6),
            "turns": plan.toolpath.turns.len(),
        })
    });
    let segments = input.tool.segments();
    json!({
        "points": mesh.points.iter().flat_map(|p| [p.x, p.y, p.z]).map(|v| rounded(v, 2)).collect::<Vec<_>>(),
        "triangles": mesh.triangles.iter().flatten().collect::<Vec<_>>(),
        "path": path,
        "radius": rounded(input.tool.radius_mm, 4),
        "tool": segments.iter().map(|s| json!([
            rounded(s.z0, 3), rounded(s.r0, 3), rounded(s.z1, 3), rounded(s.r1, 3), s.name.starts_with("holder")
        ])).collect::<Vec<_>>(),
    })
}
