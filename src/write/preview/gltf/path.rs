//! The path with a colouring for each quantity, and the contacts on the part.
//!
//! The path is a ribbon along the part's surface, narrower than the turns are apart: viewers offer
//! variants of triangles only, and lines are a pixel wide in most.
//!
//! Colours are a texture of one row (or column) of pixels; what a place shows is which texture
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
use crate::geometry::{Point, Vector};
use crate::write::draw::colour;
use crate::write::preview::values::{self, Values};

/// So many ball radii of the straight way along the tool axis are drawn.
const SHOWN_RADII: f64 = 2.0;
/// Width of the ribbon as part of the way between turns, and its least and greatest as part of the
/// ball's radius.
const WIDTH: f64 = 0.5;
const WIDTHS: [f64; 2] = [0.01, 0.2];
/// The variant that shows what the others leave unseen.
const ALL_LAYERS: &str = "path by turn, and all layers";
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

/// Half the ribbon's width, mm.
fn half_width(plan: &Plan) -> f64 {
    let heights = plan.toolpath.locations.iter().map(|l| l.centre.x);
    let [lo, hi] = heights.fold([f64::INFINITY, f64::NEG_INFINITY], |[lo, hi], x| [lo.min(x), hi.max(x)]);
    let apart = (hi - lo) / plan.toolpath.turns.len().max(1) as f64;
    let [least, greatest] = WIDTHS.map(|w| w * plan.toolpath.radius_mm);
    0.5 * (WIDTH * apart).max(least).min(greatest)
}

/// The edges of the ribbon at a location: to both sides of the path, along the surface.
fn edges(plan: &Plan, row: usize, half_mm: f64) -> [Point; 2] {
    let all = &plan.toolpath.locations;
    let (l, last) = (&all[row], all.len() - 1);
    let along = all[(row + 1).min(last)].centre - all[row.saturating_sub(1)].centre;
    let across = along.cross(&l.normal).try_normalize(1e-12).unwrap_or_else(Vector::x) * half_mm;
    [l.centre - across, l.centre + across]
}

/// One ribbon a turn, switchable by variants; `None` without locations. All but blade, path, leads
/// and tool is unseen but in the last variant.
pub(super) fn node(glb: &mut Glb, plan: &Plan, scene: &Scene, detail: &Detail) -> Result<Option<Index<Node>>> {
    let strips = strips(plan, detail.path_points);
    if strips.is_empty() {
        return Ok(None);
    }
    let quantities = values::all(plan, scene.machine, scene.checks);
    let materials = materials(glb, &quantities)?;
    let (first, half_mm) = (materials[0].1, half_width(plan));
    let mut primitives = Vec::new();
    for rows in &strips {
        let mut points = Vec::with_capacity(2 * rows.len());
        for &i in rows {
            for edge in edges(plan, i, half_mm) {
                points.push(triple(&(scene.blade.model_from_blade * edge).coords)?);
            }
        }
        let mut attributes = vec![(Semantic::Positions, glb.positions(&points))];
        for (set, pair) in (0u32..).zip(quantities.chunks(2)) {
            let at = |k: usize, i: usize| pair.get(k).map_or(0.5, |v| pixel(v.share(i)));
            let rows: Vec<[f32; 2]> = rows.iter().flat_map(|&i| [[at(0, i), at(1, i)]; 2]).collect();
            attributes.push((Semantic::TexCoords(set), glb.coordinates(&rows)));
        }
        let pieces = (0..u32::try_from(rows.len()).unwrap_or(0)).skip(1).map(|k| 2 * (k - 1));
        let indices: Vec<u32> = pieces.flat_map(|a| [a, a + 1, a + 2, a + 2, a + 1, a + 3]).collect();
        let indices = glb.indices(&indices);
        let mut ribbon = Glb::primitive(attributes, Some(indices), first, Mode::Triangles);
        Glb::by_variant(&mut ribbon, first, &materials);
        primitives.push(ribbon);
    }
    let scales: Vec<_> = quantities
        .iter()
        .map(|v| {
            json!({ "variant": variant(v), "unit": v.unit, "dark": v.shown[0], "bright": v.shown[1], "least_and_greatest": v.range })
        })
        .collect();
    let shown: usize = strips.iter().map(Vec::len).sum();
    let note = json!({
        "what": "ball centres, one ribbon a turn; grey: not measured", "width_mm": 2.0 * half_mm, "turns": plan.toolpath.turns.len(),
        "locations": plan.toolpath.locations.len(), "points_shown": shown, "scales": scales,
    });
    Ok(Some(mesh_node(glb, "path", primitives, note)))
}

fn variant(v: &Values) -> String {
    format!("path by {}", v.name)
}

/// A material for each quantity, and its variant; the last variant has the first material.
fn materials(glb: &mut Glb, quantities: &[Values]) -> Result<Vec<(u32, Index<Material>)>> {
    let textures = [glb.texture("scale, along", &scale(false)?), glb.texture("scale, across", &scale(true)?)];
    let names: Vec<String> = quantities.iter().map(variant).chain([ALL_LAYERS.to_owned()]).collect();
    glb.variants(&names);
    let of = |(k, name): (usize, &String)| glb.textured(name, textures[k % 2], (k / 2) as u32);
    let mut materials: Vec<_> = names[..quantities.len()].iter().enumerate().map(of).collect();
    materials.extend(materials.first().copied());
    Ok((0..).zip(materials).collect())
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
