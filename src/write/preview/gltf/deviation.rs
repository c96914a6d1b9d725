//! A deviation map as a scene: the part's surface coloured by what is left on it.

use gltf_json as json;
use json::mesh::{Mode, Semantic};
use json::scene::{Node, UnitQuaternion};
use serde_json::json;

use super::glb::Glb;
use super::path::png_of;
use super::{empty_node, extras, mesh_node, triple};
use crate::artifact::deviation::DeviationMap;
use crate::error::Result;
use crate::geometry::Rigid;
use crate::write::draw::colour;

/// Pixels of the scale; one more at its end for places where the ball does not come.
const PIXELS: usize = 255;

/// The colours: red for gouges, then the usual scale from nothing left to `highest_mm` left, grey
/// for no value.
fn pixels(lowest_mm: f64, highest_mm: f64) -> Vec<[u8; 3]> {
    let value = |k: usize| lowest_mm + (highest_mm - lowest_mm) * (k as f64 + 0.5) / PIXELS as f64;
    let red = |depth: f64| [(140.0 + 115.0 * depth.clamp(0.0, 1.0)) as u8, 30, 30];
    let colour = |k: usize| match value(k) {
        v if v < 0.0 => red(v / lowest_mm),
        v => colour::of(v / highest_mm),
    };
    (0..PIXELS).map(colour).chain([colour::NONE]).collect()
}

/// The map in the model frame as the bytes of a `.glb` file; heights from `-highest_mm / 2` (red:
/// gouges) to `highest_mm`, what is beyond has the colour of the end.
///
/// # Errors
/// As [`super::gltf()`].
pub fn deviation(name: &str, map: &DeviationMap, model_from_blade: &Rigid, highest_mm: f64) -> Result<Vec<u8>> {
    let lowest_mm = -0.5 * highest_mm;
    let mut glb = Glb::default();
    let scale = glb.texture("deviation", &png_of(&pixels(lowest_mm, highest_mm), false)?);
    let material = glb.textured("deviation", scale, 0);
    let (mut points, mut normals, mut coordinates) = (Vec::new(), Vec::new(), Vec::new());
    for ((p, n), h) in map.points.iter().zip(&map.normals).zip(&map.heights_mm) {
        points.push(triple(&(model_from_blade * p).coords)?);
        normals.push(triple(&(model_from_blade.rotation * n))?);
        let all = (PIXELS + 1) as f64;
        let at = ((h - lowest_mm) / (highest_mm - lowest_mm) * PIXELS as f64).clamp(0.5, PIXELS as f64 - 0.5) / all;
        coordinates.push([if h.is_nan() { (PIXELS as f64 + 0.5) / all } else { at } as f32, 0.5]);
    }
    let indices: Vec<u32> = map.triangles.iter().flatten().copied().collect();
    let attributes = [
        (Semantic::Positions, glb.positions(&points)),
        (Semantic::Normals, glb.normals(&normals)),
        (Semantic::TexCoords(0), glb.coordinates(&coordinates)),
    ];
    let indices = glb.indices(&indices);
    let shown = Glb::primitive(attributes, Some(indices), material, Mode::Triangles);
    let known = || map.heights_mm.iter().copied().filter(|h| !h.is_nan());
    let note = json!({
        "what": "height of the machined surface over the part, mm",
        "scale_mm": [lowest_mm, highest_mm],
        "red": "gouges",
        "grey": "the ball does not come here",
        "lowest_mm": known().fold(f64::INFINITY, f64::min),
        "highest_mm": known().fold(f64::NEG_INFINITY, f64::max),
        "tolerance_mm": map.tolerance_mm,
        "triangles": map.triangles.len(),
        "triangles_coarser_than_the_tolerance": map.coarse,
        "heights_in_those_within_mm": map.coarse_bound_mm,
        "of_those_on_sharp_edges": map.sharp,
        "area_on_sharp_edges_mm2": map.sharp_area_mm2,
        "distances_on_sharp_edges_within_mm": map.sharp_bound_mm,
    });
    let node = mesh_node(&mut glb, "deviation", vec![shown], note);
    let half = std::f32::consts::FRAC_1_SQRT_2;
    let root = glb.node(Node {
        name: Some(format!("{name} (model frame, mm)")),
        children: Some(vec![node]),
        scale: Some([0.001; 3]),
        rotation: Some(UnitQuaternion([-half, 0.0, 0.0, half])),
        extras: extras(&json!({ "frame": "model frame of the CAD file, mm, below this node" })),
        ..empty_node()
    });
    glb.finish(root, Vec::new())
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used)]
    use super::*;
    use crate::geometry::{Point, Vector};

    #[test]
    fn a_map_becomes_a_textured_scene() {
        let map = DeviationMap {
            points: vec![Point::origin(), Point::new(1.0, 0.0, 0.0), Point::new(0.0, 1.0, 0.0)],
            normals: vec![Vector::z(); 3],
            heights_mm: vec![0.004, -0.002, f64::NAN],
            triangles: vec![[0, 1, 2]],
            tolerance_mm: 0.002,
            coarse: 0,
            coarse_bound_mm: 0.0,
            sharp: 0,
            sharp_area_mm2: 0.0,
            sharp_bound_mm: 0.0,
        };
        let bytes = deviation("x", &map, &Rigid::identity(), 0.01).unwrap();
        let document = ::gltf::Gltf::from_slice(&bytes).unwrap();
        let primitive = document.meshes().next().unwrap().primitives().next().unwrap();
        assert!(primitive.get(&::gltf::Semantic::TexCoords(0)).is_some() && primitive.indices().is_some());
        let scale = pixels(-0.005, 0.01);
        assert_eq!((scale.len(), scale[PIXELS]), (PIXELS + 1, colour::NONE));
        // Just over nothing left the scale begins; below it is red.
        assert!(scale[PIXELS / 3 - 2][0] >= 140 && scale[PIXELS / 3 - 2][1] == 30);
        assert_eq!(scale[PIXELS / 3 + 1][2], colour::of(0.01)[2]);
    }
}
