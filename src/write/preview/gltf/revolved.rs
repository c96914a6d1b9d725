//! Surfaces of revolution about Z, by the rings of their profile.

use std::f64::consts::TAU;

use gltf_json::mesh::{Mode, Primitive, Semantic};

use super::glb::Glb;
use super::single;
use crate::error::Result;

/// Facets around.
const AROUND: u32 = 48;

/// A ring of the profile: height, radius, and the profile's outward normal (along radius, along
/// height).
pub(super) type ProfileRing = [f64; 4];

/// Bands between consecutive rings; two rings at one place start a new band with its own normals.
pub(super) fn revolved(glb: &mut Glb, name: &str, rgb: [f32; 3], rings: &[ProfileRing]) -> Result<Primitive> {
    let (mut points, mut normals, mut indices) = (Vec::new(), Vec::new(), Vec::new());
    for [z, r, nr, nz] in rings {
        for k in 0..=AROUND {
            let (s, c) = (TAU * f64::from(k) / f64::from(AROUND)).sin_cos();
            points.push([single(r * c)?, single(r * s)?, single(*z)?]);
            normals.push([single(nr * c)?, single(nr * s)?, single(*nz)?]);
        }
    }
    for (i, w) in (0u32..).zip(rings.windows(2)) {
        // No band between two rings at one place.
        if (w[0][0] - w[1][0]).abs().max((w[0][1] - w[1][1]).abs()) < 1e-12 {
            continue;
        }
        for k in 0..AROUND {
            let (a, b) = (i * (AROUND + 1) + k, (i + 1) * (AROUND + 1) + k);
            // Where a ring is a point on the axis, one of the two triangles has no area.
            if w[0][1] > 1e-12 {
                indices.extend([a, a + 1, b + 1]);
            }
            if w[1][1] > 1e-12 {
                indices.extend([a, b + 1, b]);
            }
        }
    }
    let attributes = [(Semantic::Positions, glb.positions(&points)), (Semantic::Normals, glb.normals(&normals))];
    let (indices, material) = (glb.indices(&indices), glb.material(name, rgb, true));
    Ok(Glb::primitive(attributes, Some(indices), material, Mode::Triangles))
}
