//! The path's lines with a colouring for each quantity, and the contacts on the part.
//!
//! Colours are a texture of one row (or column) of pixels; what a line shows is which texture
//! coordinate its material reads. Two quantities share a set of coordinates, one along each
//! direction, so five need three sets: all viewers know four.

use gltf_json as json;
use json::Index;
use json::material::Material;
use json::mesh::{Mode, Semantic};
use json::scene::Node;
use serde_json::json;

use super::glb::Glb;
use super::{Detail, Scene, mesh_node, triple};
use crate::artifact::Plan;
use crate::error::{Error, Result, Stage};
use crate::write::draw::colour;
use crate::write::preview::values::{self, Values};

/// So many ball radii of the straight way along the tool axis are drawn.
const SHOWN_RADII: f64 = 2.0;
/// Pixels of the texture: the first for places without a value.
const PIXELS: u32 = 256;

/// Rows of each turn that are shown, the next turn's base point last, so that the strips join.
pub(super) fn strips(plan: &Plan, most: usize) -> Vec<Vec<usize>> {
    let n = plan.toolpath.locations.len();
    let stride = n.div_ceil(most.max(2)).max(1);
    let strip = |first: usize, count: usize| {
        let end = first.saturating_add(count).min(n.saturating_sub(1));
        let mut rows: Vec<usize> = (first..end).step_by(stride).collect();
        rows.extend((end < n && rows.last() != Some(&end)).then_some(end));
        rows
    };
    let all = plan.toolpath.turns.iter().map(|t| strip(t.first, t.count));
    all.filter(|rows| rows.len() >= 2).collect()
}

/// One line strip a turn, switchable by variants; `None` without locations.
pub(super) fn node(glb: &mut Glb, plan: &Plan, scene: &Scene, detail: &Detail) -> Result<Option<Index<Node>>> {
    let strips = strips(plan, detail.path_points);
    if strips.is_empty() {
        return Ok(None);
    }
    let quantities = values::all(plan, scene.machine, scene.checks);
    let materials = materials(glb, &quantities)?;
    let mut primitives = Vec::new();
    for rows in &strips {
        let mut points = Vec::with_capacity(rows.len());
        for &i in rows {
            points.push(triple(&(scene.blade.model_from_blade * plan.toolpath.locations[i].centre).coords)?);
        }
        let mut attributes = vec![(Semantic::Positions, glb.positions(&points))];
        for (set, pair) in (0u32..).zip(quantities.chunks(2)) {
            let at = |k: usize, i: usize| pair.get(k).map_or(0.5, |v| pixel(v.share(i)));
            let rows: Vec<[f32; 2]> = rows.iter().map(|&i| [at(0, i), at(1, i)]).collect();
            attributes.push((Semantic::TexCoords(set), glb.coordinates(&rows)));
        }
        let strip = Glb::primitive(attributes, None, materials[0], Mode::LineStrip);
        primitives.push(Glb::by_variant(strip, &materials));
    }
    let scales: Vec<_> = quantities
        .iter()
        .map(|v| {
            json!({ "variant": variant(v), "unit": v.unit, "dark": v.shown[0], "bright": v.shown[1], "least_and_greatest": v.range })
        })
        .collect();
    let shown: usize = strips.iter().map(Vec::len).sum();
    let note = json!({
        "what": "ball centres, one strip a turn; grey: not measured", "turns": plan.toolpath.turns.len(),
        "locations": plan.toolpath.locations.len(), "points_shown": shown, "scales": scales,
    });
    Ok(Some(mesh_node(glb, "path", primitives, note)))
}

fn variant(v: &Values) -> String {
    format!("path by {}", v.name)
}

/// A material for each quantity, and its variant.
fn materials(glb: &mut Glb, quantities: &[Values]) -> Result<Vec<Index<Material>>> {
    let textures = [glb.texture("scale, along", &scale(false)?), glb.texture("scale, across", &scale(true)?)];
    let names: Vec<String> = quantities.iter().map(variant).collect();
    glb.variants(&names);
    Ok((0..).zip(&names).map(|(k, name)| glb.textured(name, textures[k % 2], (k / 2) as u32)).collect())
}

/// Middle of the pixel that shows a share.
fn pixel(share: f64) -> f32 {
    let k = if share.is_finite() { 1.0 + (share.clamp(0.0, 1.0) * f64::from(PIXELS - 2)).round() } else { 0.0 };
    ((k + 0.5) / f64::from(PIXELS)) as f32
}

/// The scale of colours as a PNG file.
fn scale(upright: bool) -> Result<Vec<u8>> {
    let values = (0..PIXELS - 1).map(|k| colour::of(f64::from(k) / f64::from(PIXELS - 2)));
    png_of(&[colour::NONE].into_iter().chain(values).collect::<Vec<_>>(), upright)
}

/// A row, or a column, of pixels as a PNG file.
pub(super) fn png_of(colours: &[[u8; 3]], upright: bool) -> Result<Vec<u8>> {
    let pixels: Vec<u8> = colours.iter().flatten().copied().collect();
    let long = u32::try_from(colours.len()).unwrap_or(u32::MAX);
    let mut out = Vec::new();
    let (width, height) = if upright { (1, long) } else { (long, 1) };
    let mut encoder = png::Encoder::new(&mut out, width, height);
    encoder.set_color(png::ColorType::Rgb);
    encoder.set_depth(png::BitDepth::Eight);
    let written = encoder.write_header().and_then(|mut w| w.write_image_data(&pixels));
    written
        .map_err(|e| Error::io(Stage::Preview, format!("the scale of colours cannot be encoded: {e}")).caused_by(e))?;
    Ok(out)
}

/// The ways of the ball onto the path and off it: the arc of each lead, and the beginning of the
/// straight line along the tool axis; `None` without locations.
pub(super) fn leads(glb: &mut Glb, plan: &Plan, scene: &Scene) -> Result<Option<Index<Node>>> {
    let last = plan.toolpath.locations.len().saturating_sub(1);
    let ends = [plan.stand(0), plan.stand(last)];
    let material = glb.material("leads", [0.85, 0.1, 0.55], false);
    let mut primitives = Vec::new();
    for (k, (lead, end)) in plan.leads.iter().zip(ends).enumerate() {
        let Some(at) = end else { continue };
        // From the path outwards.
        let mut rows: Vec<_> = lead.stands(at.cone).collect();
        if k == 0 {
            rows.reverse();
        }
        rows.insert(0, at);
        let outer = rows.last().copied().unwrap_or(at);
        rows.push(outer.lifted(SHOWN_RADII * plan.toolpath.radius_mm));
        let placed = rows.iter().map(|s| triple(&(scene.blade.model_from_blade * s.centre).coords));
        let points = placed.collect::<Result<Vec<_>>>()?;
        let attributes = [(Semantic::Positions, glb.positions(&points))];
        primitives.push(Glb::primitive(attributes, None, material, Mode::LineStrip));
    }
    if primitives.is_empty() {
        return Ok(None);
    }
    let arcs: Vec<bool> = plan.leads.iter().map(|l| l.is_arc()).collect();
    let note = json!({ "what": "ball centres onto the path and off it: lead-in, lead-out", "arcs": arcs });
    Ok(Some(mesh_node(glb, "leads", primitives, note)))
}

/// Where the ball touches the part, one strip a turn; `None` without locations.
pub(super) fn contacts(glb: &mut Glb, plan: &Plan, scene: &Scene, detail: &Detail) -> Result<Option<Index<Node>>> {
    let strips = strips(plan, detail.path_points / 2);
    let material = glb.material("cutter contacts", [0.02, 0.02, 0.02], false);
    let mut primitives = Vec::new();
    for rows in &strips {
        let mut points = Vec::with_capacity(rows.len());
        for &i in rows {
            let l = &plan.toolpath.locations[i];
            // A little over the surface, so that it is seen.
            let p = l.contact + l.normal * (0.004 * plan.toolpath.radius_mm);
            points.push(triple(&(scene.blade.model_from_blade * p).coords)?);
        }
        let attributes = [(Semantic::Positions, glb.positions(&points))];
        primitives.push(Glb::primitive(attributes, None, material, Mode::LineStrip));
    }
    if primitives.is_empty() {
        return Ok(None);
    }
    let note = json!({ "what": "cutter contacts on the part, one strip a turn", "lifted_mm": 0.004 * plan.toolpath.radius_mm });
    Ok(Some(mesh_node(glb, "cutter contacts", primitives, note)))
}
