//! Scenes read back with the `gltf` crate.
#![allow(clippy::unwrap_used)]

use super::*;
use crate::geometry::{Point, Vector};
use crate::sample;
use nalgebra::{Quaternion, UnitQuaternion};

fn read(bytes: &[u8]) -> (gltf::Document, Vec<u8>) {
    let glb = gltf::Gltf::from_slice(bytes).unwrap();
    (glb.document, glb.blob.unwrap())
}

fn point(v: [f32; 3]) -> Point {
    Point::from(v.map(f64::from))
}

#[test]
fn the_scene_holds_blade_path_and_tool_under_a_root_in_metres() {
    let plan = sample::plan(3, 60);
    let (doc, blob) = read(&super::gltf(Some(&plan), &sample::blade(), &sample::tool(), &Default::default()).unwrap());
    let root = doc.default_scene().unwrap().nodes().next().unwrap();
    let names: Vec<String> = root.children().map(|n| n.name().unwrap().to_string()).collect();
    assert_eq!(names, ["blade", "path", "channel", "tool"]);
    let (_, rotation, scale) = root.transform().decomposed();
    assert_eq!(scale, [0.001; 3]);
    let q = UnitQuaternion::from_quaternion(Quaternion::from(rotation.map(f64::from)));
    assert!((q * Vector::z() - Vector::y()).norm() < 1e-6, "the model's z is up");
    let path = root.children().nth(1).unwrap().mesh().unwrap();
    assert_eq!(path.primitives().count(), 3);
    for (t, p) in path.primitives().enumerate() {
        assert_eq!(p.mode(), gltf::mesh::Mode::LineStrip);
        let points: Vec<_> = p.reader(|_| Some(&blob)).read_positions().unwrap().map(point).collect();
        assert_eq!(points.len(), 61);
        for (i, at) in points.iter().enumerate() {
            let want = sample::blade().model_from_blade * plan.toolpath.locations[60 * t + i].centre;
            assert!((at - want).norm() < 1e-4);
        }
    }
}

#[test]
fn the_tool_follows_the_plan() {
    let (plan, blade) = (sample::plan(3, 60), sample::blade());
    let options = GltfOptions { max_play_s: 5.0, max_keys: 100, ..GltfOptions::default() };
    let (doc, blob) = read(&super::gltf(Some(&plan), &blade, &sample::tool(), &options).unwrap());
    let animation = doc.animations().next().unwrap();
    let (mut times, mut centres, mut axes) = (Vec::new(), Vec::new(), Vec::new());
    for channel in animation.channels() {
        let reader = channel.reader(|_| Some(&blob));
        times = reader.read_inputs().unwrap().collect();
        match reader.read_outputs().unwrap() {
            gltf::animation::util::ReadOutputs::Translations(t) => centres = t.map(point).collect(),
            gltf::animation::util::ReadOutputs::Rotations(r) => {
                axes = r
                    .into_f32()
                    .map(|q| UnitQuaternion::from_quaternion(Quaternion::from(q.map(f64::from))) * Vector::z())
                    .collect();
            }
            _ => panic!("another kind of output"),
        }
    }
    assert_eq!(times.len(), 100);
    assert!((times[99] - 5.0).abs() < 1e-5 && times.windows(2).all(|w| w[0] < w[1]));
    for (k, i) in (0..100).map(|k| (k, k * 180 / 99)) {
        let want = blade.model_from_blade * plan.toolpath.locations[i].centre;
        let axis = blade.model_from_blade * tool_axis(&plan, i);
        assert!((centres[k] - want).norm() < 1e-4 && (axes[k] - axis).norm() < 1e-6, "key {k}");
    }
}

fn tool_axis(plan: &Plan, i: usize) -> Vector {
    crate::tool::axis(plan.channel.b_rad, plan.schedule.theta[i])
}

#[test]
fn the_tools_mesh_lies_on_its_profile_and_faces_outward() {
    let tool = sample::tool();
    let (doc, blob) =
        read(&super::gltf(Some(&sample::plan(1, 12)), &sample::blade(), &tool, &Default::default()).unwrap());
    let mesh = doc.meshes().find(|m| m.name() == Some("tool")).unwrap();
    let mut height = 0.0f64;
    for p in mesh.primitives() {
        let reader = p.reader(|_| Some(&blob));
        let at: Vec<_> = reader.read_positions().unwrap().map(point).collect();
        let normals: Vec<_> = reader.read_normals().unwrap().map(|n| point(n).coords).collect();
        let indices: Vec<usize> = reader.read_indices().unwrap().into_u32().map(|i| i as usize).collect();
        for t in indices.chunks(3) {
            let flat = (at[t[1]] - at[t[0]]).cross(&(at[t[2]] - at[t[0]]));
            assert!(flat.norm() > 1e-9, "a triangle without area");
            let mean: Vector = t.iter().map(|&i| normals[i]).sum();
            assert!(flat.dot(&mean) > 0.0, "{:?} faces inward", p.material().name());
        }
        if p.material().name() == Some("ball") {
            assert!(at.iter().all(|p| (p.coords.norm() - tool.radius_mm).abs() < 1e-5));
        }
        height = at.iter().fold(height, |h, p| h.max(p.z));
    }
    assert!((height - tool.length_mm()).abs() < 1e-4);
}

#[test]
fn odd_inputs_give_a_scene_or_an_error_and_no_panic() {
    let (blade, tool) = (sample::blade(), sample::tool());
    let options = GltfOptions::default();
    assert!(read(&super::gltf(None, &blade, &tool, &options).unwrap()).0.animations().next().is_none());
    let mut empty = sample::plan(1, 12);
    empty.toolpath.locations.clear();
    assert!(super::gltf(Some(&empty), &blade, &tool, &options).is_ok());
    let mut wild = sample::plan(1, 12);
    wild.toolpath.turns[0].first = usize::MAX;
    assert!(super::gltf(Some(&wild), &blade, &tool, &options).is_ok());
    let mut bad = sample::plan(1, 12);
    bad.toolpath.locations[3].centre.x = f64::NAN;
    assert!(super::gltf(Some(&bad), &blade, &tool, &options).is_err());
    let tight = GltfOptions { max_triangles: 0, max_path_points: 0, max_keys: 0, ..options };
    assert!(super::gltf(Some(&sample::plan(2, 30)), &blade, &tool, &tight).is_ok());
}

#[test]
fn the_same_input_gives_the_same_bytes() {
    let make =
        || super::gltf(Some(&sample::plan(2, 30)), &sample::blade(), &sample::tool(), &Default::default()).unwrap();
    assert_eq!(make(), make());
}
