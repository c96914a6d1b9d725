//! What the schedule is made from, at its places: limits of the channel as fans, the axis at base
//! points, altered points.

use gltf_json as json;
use json::Index;
use json::mesh::{Mode, Primitive, Semantic};
use json::scene::Node;
use serde_json::json;

use super::glb::Glb;
use super::{Scene, mesh_node, single, triple};
use crate::artifact::Plan;
use crate::error::Result;
use crate::geometry::{Point, Vector};

/// Most fans: the narrowest place of so many turns.
const FANS: usize = 60;
/// Facets of a fan.
const FACETS: u32 = 24;
/// Length of fans and base vectors in ball radii.
const REACH: f64 = 2.5;

/// Rows at which the channel is shown: the narrowest of each turn (of some, where there are many),
/// the narrowest of all first.
fn chosen(plan: &Plan) -> Vec<usize> {
    let n = plan.toolpath.locations.len().min(plan.channel.rows.len());
    let width = |i: usize| plan.channel.rows[i].theta_max - plan.channel.rows[i].theta_min;
    let narrowest = |first: usize, count: usize| {
        (first.min(n)..first.saturating_add(count).min(n)).min_by(|a, b| width(*a).total_cmp(&width(*b)))
    };
    let every = plan.toolpath.turns.len().div_ceil(FANS).max(1);
    let mut rows: Vec<usize> =
        (plan.channel.narrowest_row < n).then_some(plan.channel.narrowest_row).into_iter().collect();
    let of_turns = plan.toolpath.turns.iter().step_by(every).filter_map(|t| narrowest(t.first, t.count));
    rows.extend(of_turns.filter(|i| *i != plan.channel.narrowest_row));
    rows
}

/// The angles that the whole tool may take, as fans about the ball centre; `None` without a
/// channel.
pub(super) fn fans(glb: &mut Glb, plan: &Plan, scene: &Scene) -> Result<Option<Index<Node>>> {
    let rows = chosen(plan);
    let (Some(narrowest), rest) = (rows.first(), rows.get(1..).unwrap_or_default()) else { return Ok(None) };
    let mut primitives = Vec::new();
    let looks = [
        ("narrowest place", [0.83, 0.21, 0.0], 0.75, std::slice::from_ref(narrowest)),
        ("channel", [0.05, 0.45, 0.75], 0.35, rest),
    ];
    for (name, rgb, opacity, rows) in looks {
        if !rows.is_empty() {
            primitives.push(sectors(glb, plan, scene, rows, (name, rgb, opacity))?);
        }
    }
    let at = |i: &usize| {
        let (l, r) = (&plan.toolpath.locations[*i], &plan.channel.rows[*i]);
        json!({ "row": i, "turn": l.turn, "S_mm": l.turn_s_mm, "theta_min_deg": r.theta_min.to_degrees(), "theta_max_deg": r.theta_max.to_degrees() })
    };
    let note = json!({
        "what": "angles that the whole tool may take, at the narrowest place of turns; the first is the narrowest of all",
        "places": rows.iter().map(at).collect::<Vec<_>>(),
    });
    Ok(Some(mesh_node(glb, "channel", primitives, note)))
}

fn sectors(
    glb: &mut Glb,
    plan: &Plan,
    scene: &Scene,
    rows: &[usize],
    look: (&str, [f32; 3], f32),
) -> Result<Primitive> {
    let (mut points, mut indices) = (Vec::new(), Vec::new());
    let reach = REACH * scene.tool.radius_mm;
    for &i in rows {
        let (centre, row) = (plan.toolpath.locations[i].centre, &plan.channel.rows[i]);
        let cone = plan.toolpath.cone(i);
        let hub = u32::try_from(points.len()).unwrap_or(0);
        points.push(triple(&(scene.blade.model_from_blade * centre).coords)?);
        for k in 0..=FACETS {
            let theta = row.theta_min + (row.theta_max - row.theta_min) * f64::from(k) / f64::from(FACETS);
            let rim = centre + cone.tool_axis(theta) * reach;
            points.push(triple(&(scene.blade.model_from_blade * rim).coords)?);
        }
        indices.extend((1..=FACETS).flat_map(|k| [hub, hub + k, hub + k + 1]));
    }
    let material = glb.glass(look.0, look.1, look.2);
    let attributes = [(Semantic::Positions, glb.positions(&points))];
    let indices = glb.indices(&indices);
    Ok(Glb::primitive(attributes, Some(indices), material, Mode::Triangles))
}

/// The tool axis at every turn's base point, from which θ of the turn is counted; `None` without
/// turns.
pub(super) fn base_vectors(glb: &mut Glb, plan: &Plan, scene: &Scene) -> Result<Option<Index<Node>>> {
    let mut points = Vec::new();
    for turn in &plan.toolpath.turns {
        let Some(stand) = plan.stand(turn.first) else { continue };
        for p in [stand.centre, stand.lifted(REACH * scene.tool.radius_mm).centre] {
            points.push(triple(&(scene.blade.model_from_blade * p).coords)?);
        }
    }
    if points.is_empty() {
        return Ok(None);
    }
    let material = glb.material("base vectors", [0.60, 0.03, 0.35], false);
    let attributes = [(Semantic::Positions, glb.positions(&points))];
    let lines = Glb::primitive(attributes, None, material, Mode::Lines);
    let note = json!({ "what": "tool axis at each turn's base point", "turns": points.len() / 2 });
    Ok(Some(mesh_node(glb, "base vectors", vec![lines], note)))
}

/// Where the curvature of plane sections changes sign, as little octahedra; `None` where it does
/// nowhere.
pub(super) fn altered_points(glb: &mut Glb, scene: &Scene) -> Result<Option<Index<Node>>> {
    let size = 0.12 * scene.tool.radius_mm;
    let mut primitives = Vec::new();
    let mut counts = [0, 0];
    for (k, (name, into)) in [("into concave", true), ("into convex", false)].into_iter().enumerate() {
        let mut at = Vec::new();
        for section in scene.sections {
            let loops = section.loops.iter().flat_map(|l| &l.altered_points).filter(|a| a.into_concave == into);
            at.extend(loops.map(|a| Point::new(section.x_mm, a.point_mm[0], a.point_mm[1])));
        }
        counts[k] = at.len();
        if !at.is_empty() {
            let rgb = if into { [0.90, 0.35, 0.0] } else { [0.0, 0.30, 0.70] };
            primitives.push(octahedra(glb, scene, &at, size, (name, rgb))?);
        }
    }
    if primitives.is_empty() {
        return Ok(None);
    }
    let note = json!({
        "what": "where the curvature of plane sections changes sign, counter-clockwise seen from the tip",
        "into_concave": counts[0], "into_convex": counts[1], "sections": scene.sections.len(),
    });
    Ok(Some(mesh_node(glb, "altered points", primitives, note)))
}

fn octahedra(glb: &mut Glb, scene: &Scene, at: &[Point], size_mm: f64, look: (&str, [f32; 3])) -> Result<Primitive> {
    let (mut points, mut normals, mut indices) = (Vec::new(), Vec::new(), Vec::new());
    for p in at {
        for signs in 0..8u32 {
            let sign = |k: u32| if signs >> k & 1 == 0 { 1.0 } else { -1.0 };
            let ends = [Vector::x() * sign(0), Vector::y() * sign(1), Vector::z() * sign(2)];
            let n = (scene.blade.model_from_blade * (ends[0] + ends[1] + ends[2])).normalize();
            let first = u32::try_from(points.len()).unwrap_or(0);
            for e in ends {
                points.push(triple(&(scene.blade.model_from_blade * (p + e * size_mm)).coords)?);
                normals.push([single(n.x)?, single(n.y)?, single(n.z)?]);
            }
            let outward = sign(0) * sign(1) * sign(2) > 0.0;
            indices.extend(if outward { [first, first + 1, first + 2] } else { [first, first + 2, first + 1] });
        }
    }
    let attributes = [(Semantic::Positions, glb.positions(&points)), (Semantic::Normals, glb.normals(&normals))];
    let (indices, material) = (glb.indices(&indices), glb.material(look.0, look.1, true));
    Ok(Glb::primitive(attributes, Some(indices), material, Mode::Triangles))
}
