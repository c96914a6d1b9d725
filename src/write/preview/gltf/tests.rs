//! Scenes read back with the `gltf` crate.
#![allow(clippy::unwrap_used)]

use super::*;
use crate::artifact::{Cone, Cones, Wheel};
use crate::geometry::{Point, Rigid, Vector};
use crate::sample;
use nalgebra::{Quaternion, Unit, UnitQuaternion};

/// The scene of a plan, and of what else a run has.
fn scene(plan: Option<&Plan>, options: &GltfOptions) -> Result<Vec<u8>> {
    scene_on(&Machine::demo().unwrap(), plan, options)
}

fn scene_on(machine: &Machine, plan: Option<&Plan>, options: &GltfOptions) -> Result<Vec<u8>> {
    scene_among(&[], machine, plan, options)
}

fn scene_among(
    obstacles: &[Obstacle],
    machine: &Machine,
    plan: Option<&Plan>,
    options: &GltfOptions,
) -> Result<Vec<u8>> {
    let (blade, tool) = (sample::blade(), sample::tool());
    let (sections, mut checks) = (sample::sections(), sample::report());
    checks.uncut_cell_mm2 = 0.5;
    checks.uncut =
        vec![crate::artifact::report::UncutPlace { point: Point::origin(), normal: Vector::x(), left_mm: 0.1 }];
    let figures = json!({ "turns": 3 });
    gltf(&Scene {
        blade: &blade,
        obstacles,
        tool: &tool,
        machine,
        plan,
        sections: &sections,
        checks: Some(&checks),
        figures: Some(&figures),
        options,
    })
}

fn read(bytes: &[u8]) -> (::gltf::Document, Vec<u8>) {
    let glb = ::gltf::Gltf::from_slice(bytes).unwrap();
    (glb.document, glb.blob.unwrap())
}

fn point(v: [f32; 3]) -> Point {
    Point::from(v.map(f64::from))
}

fn rotation(q: [f32; 4]) -> UnitQuaternion<f64> {
    UnitQuaternion::from_quaternion(Quaternion::from(q.map(f64::from)))
}

fn names<'a>(nodes: impl Iterator<Item = ::gltf::Node<'a>>) -> Vec<String> {
    nodes.map(|n| n.name().unwrap().to_string()).collect()
}

#[test]
fn the_scene_holds_what_the_run_did_under_a_root_in_metres() {
    let plan = sample::plan(3, 60);
    let (doc, blob) = read(&scene(Some(&plan), &GltfOptions::default()).unwrap());
    let root = doc.default_scene().unwrap().nodes().next().unwrap();
    assert_eq!(names(root.children()), ["workpiece", "tool"]);
    let parts =
        ["blade", "uncut", "altered points", "path", "leads", "cutter contacts", "channel", "base vectors", "table"];
    assert_eq!(names(root.children().next().unwrap().children()), parts);
    let tool = root.children().nth(1).unwrap();
    assert_eq!(names(tool.children()), ["ball", "taper", "shank", "holder 1", "holder 2", "head"]);
    let (_, q, scale) = root.transform().decomposed();
    assert_eq!(scale, [0.001; 3]);
    assert!((rotation(q) * Vector::z() - Vector::y()).norm() < 1e-6, "the model's z is up");
    let extras: serde_json::Value = serde_json::from_str(root.extras().as_ref().unwrap().get()).unwrap();
    assert_eq!(extras["figures"]["turns"], 3);
    let path = doc.meshes().find(|m| m.name() == Some("path")).unwrap();
    assert_eq!(path.primitives().count(), 3);
    for (t, p) in path.primitives().enumerate() {
        assert_eq!(p.mode(), ::gltf::mesh::Mode::Triangles);
        let points: Vec<_> = p.reader(|_| Some(&blob)).read_positions().unwrap().map(point).collect();
        assert_eq!(points.len(), 122);
        for (i, edges) in points.chunks(2).enumerate() {
            let l = &plan.toolpath.locations[60 * t + i];
            let want = sample::blade().model_from_blade * l.centre;
            assert!((nalgebra::center(&edges[0], &edges[1]) - want).norm() < 1e-4);
            // Along the surface, and as wide everywhere.
            let across = edges[1] - edges[0];
            let up = sample::blade().model_from_blade * l.normal;
            assert!((across.norm() / (points[1] - points[0]).norm() - 1.0).abs() < 1e-3);
            assert!(across.normalize().dot(&up).abs() < 1e-3);
        }
        // Two triangles between neighbours.
        let corners: Vec<_> = p.reader(|_| Some(&blob)).read_indices().unwrap().into_u32().collect();
        assert!(
            corners.len() == 360
                && corners.chunks(6).enumerate().all(|(k, c)| c[0] == 2 * k as u32 && c[5] == c[0] + 3)
        );
    }
}

/// The neighbours are the part turned by multiples of 360°/N about the rotor axis, each once; the
/// hub is there, and a fixture is not.
#[test]
fn neighbours_are_the_part_turned_by_the_wheel() {
    let (machine, plan, blade) = (Machine::demo().unwrap(), sample::plan(1, 12), sample::blade());
    let blades = 7;
    let wheel =
        Wheel { axis: Unit::new_normalize(Vector::new(0.1, 1.0, -0.2)), origin: Point::new(-90.0, 3.0, 1.0), blades };
    let copies: Vec<_> = (2..=blades).map(|k| wheel.turn_to(k)).collect();
    let body = |name: &str, copies: &[Rigid], of_the_wheel| Obstacle {
        name: name.into(),
        part: blade.part.clone(),
        clearance_mm: 0.1,
        holder_clearance_mm: 0.1,
        cut_by_the_tool: false,
        of_the_wheel,
        copies: copies.to_vec(),
    };
    let around = [body("the other blades", &copies, true), body("hub", &[], true), body("a vice", &[], false)];
    let options = GltfOptions::default();
    let (doc, blob) = read(&scene_among(&around, &machine, Some(&plan), &options).unwrap());
    let node = doc.nodes().find(|n| n.name() == Some("neighbours")).unwrap();
    let found: Vec<String> = names(node.children());
    let wanted = (2..=blades).map(|k| format!("blade {k}")).chain(["hub".into()]);
    assert_eq!(found, wanted.collect::<Vec<_>>());
    let to_model = blade.model_from_blade;
    let part: Vec<Point> = blade.part.mesh.points.clone();
    for (k, child) in node.children().enumerate() {
        let turn = copies.get(k).copied().unwrap_or_default();
        let want: Vec<Point> = part.iter().map(|p| to_model * (turn * p)).collect();
        let (t, q, scale) = child.transform().decomposed();
        assert_eq!(scale, [1.0; 3]);
        let place = Rigid::from_parts(point(t).coords.into(), rotation(q));
        let mesh = child.mesh().unwrap();
        let at: Vec<Point> = mesh
            .primitives()
            .flat_map(|p| {
                p.reader(|_| Some(&blob)).read_positions().unwrap().map(|v| place * point(v)).collect::<Vec<_>>()
            })
            .collect();
        let near = |all: &[Point], p: &Point| all.iter().any(|q| (q - p).norm() < 1e-3);
        assert!(at.iter().all(|p| near(&want, p)) && want.iter().all(|p| near(&at, p)), "{:?}", child.name());
        for p in mesh.primitives() {
            let pale = p.material().pbr_metallic_roughness().base_color_factor()[3];
            assert!(pale < 1.0 && p.material().name() == Some("neighbours") && p.mappings().next().is_none());
        }
    }
    // Copies share their triangles: the file is hardly larger.
    let alone = scene_among(&around[2..], &machine, Some(&plan), &options).unwrap();
    assert!(!names(read(&alone).0.nodes()).contains(&"neighbours".into()));
    let whole = scene_among(&around[..1], &machine, Some(&plan), &options).unwrap();
    assert!(whole.len() < alone.len() + 20_000, "{} {}", whole.len(), alone.len());
    // A budget of nothing leaves no panic.
    scene_among(&around, &machine, None, &GltfOptions { budget_bytes: 0, ..options }).unwrap();
}

#[test]
fn rounded_coordinates_keep_their_bound() {
    let plan = sample::plan(3, 60);
    let options = |rounded| GltfOptions { path_and_motion: false, rounded, ..GltfOptions::default() };
    let [exact, rounded] = [false, true].map(|r| read(&scene(Some(&plan), &options(r)).unwrap()));
    let mut moved = 0;
    for (a, b) in exact.0.meshes().zip(rounded.0.meshes()) {
        for (p, q) in a.primitives().zip(b.primitives()) {
            let (p, q) = (p.reader(|_| Some(&exact.1)), q.reader(|_| Some(&rounded.1)));
            let points: Vec<_> = p.read_positions().unwrap().zip(q.read_positions().unwrap()).collect();
            let most = points.iter().flat_map(|(a, _)| a).fold(0.0f32, |m, v| m.max(v.abs()));
            for (a, b) in points.iter().flat_map(|(a, b)| a.iter().zip(b)) {
                assert!((a - b).abs() <= most / 65_536.0, "{a} {b}");
                moved += usize::from(a != b);
            }
            let normals = p.read_normals().into_iter().flatten().zip(q.read_normals().into_iter().flatten());
            for (a, b) in normals.flat_map(|(a, b)| (0..3).map(move |k| (a[k], b[k]))) {
                assert!((a - b).abs() <= 1.0 / 1024.0, "{a} {b}");
            }
        }
    }
    assert!(moved > 100, "{moved}");
}

#[test]
fn leads_are_drawn_from_the_path_outwards() {
    let plan = sample::with_leads(sample::plan(2, 60));
    let (doc, blob) = read(&scene(Some(&plan), &GltfOptions::default()).unwrap());
    let leads = doc.meshes().find(|m| m.name() == Some("leads")).unwrap();
    assert_eq!(leads.primitives().count(), 2);
    let ends = [plan.toolpath.locations[0].centre, plan.toolpath.locations[120].centre];
    for ((p, lead), end) in leads.primitives().zip(&plan.leads).zip(ends) {
        let points: Vec<_> = p.reader(|_| Some(&blob)).read_positions().unwrap().map(point).collect();
        assert_eq!(points.len(), lead.centres.len() + 2);
        assert!((points[0] - sample::blade().model_from_blade * end).norm() < 1e-4);
        let (outer, up) = (points[points.len() - 2], points[points.len() - 1]);
        assert!(((up - outer).norm() - 2.0 * plan.toolpath.radius_mm).abs() < 1e-3);
        // An arc of 4 mm leaves the path by so much at least.
        assert!((outer - points[0]).norm() > 2.0);
    }
}

#[test]
fn every_variant_reads_its_own_values() {
    let mut plan = sample::plan(3, 60);
    for (i, f) in plan.motion.feed.iter_mut().enumerate() {
        *f = 10.0 + i as f64;
    }
    let (doc, blob) = read(&scene(Some(&plan), &GltfOptions::default()).unwrap());
    let variants: Vec<_> = doc.variants().unwrap().map(|v| v.name().to_string()).collect();
    assert_eq!(variants.len(), 6);
    let path = doc.meshes().find(|m| m.name() == Some("path")).unwrap();
    let strip = path.primitives().nth(1).unwrap();
    let mappings: Vec<_> = strip.mappings().collect();
    assert_eq!(mappings.len(), 6);
    assert_eq!(mappings[5].material().index(), mappings[0].material().index());
    for mesh in doc.meshes() {
        let layer = UNSEEN.contains(&mesh.name().unwrap());
        for p in mesh.primitives() {
            let alpha = |m: ::gltf::Material| m.pbr_metallic_roughness().base_color_factor()[3];
            assert_eq!(alpha(p.material()) == 0.0, layer, "{:?}", mesh.name());
            let blends = p.material().alpha_mode() == ::gltf::material::AlphaMode::Blend;
            assert!(!layer || blends, "{:?}", mesh.name());
            let all: Vec<_> = p.mappings().map(|m| (m.variants().to_vec(), alpha(m.material()) > 0.0)).collect();
            assert!(!layer || all == [(vec![5], true)], "{:?} {all:?}", mesh.name());
        }
    }
    // What variant k shows at vertex i: the pixel of its texture.
    let shown = |k: usize, i: usize| {
        let material = mappings[k].material();
        assert_eq!(material.name(), Some(&*variants[k]));
        let info = material.pbr_metallic_roughness().base_color_texture().unwrap();
        let uv: Vec<[f32; 2]> =
            strip.reader(|_| Some(&blob)).read_tex_coords(info.tex_coord()).unwrap().into_f32().collect();
        let along = if info.texture().name() == Some("scale, along") { 0 } else { 1 };
        // Both edges of the ribbon have the colour.
        assert_eq!(uv[2 * i], uv[2 * i + 1]);
        (uv[2 * i][along] * 256.0 - 0.5).round()
    };
    // Turn 1 of 0..2 is half way; nothing measured is pixel 0; feed grows along the path.
    assert_eq!(shown(0, 10), 128.0);
    assert_eq!(shown(1, 10), 0.0);
    assert!(shown(3, 50) > shown(3, 10) && shown(3, 10) > 80.0);
}

#[test]
fn both_motions_carry_the_tool_to_the_same_place_of_the_part() {
    let (plan, blade) = (sample::plan(3, 60), sample::blade());
    let options = GltfOptions { max_play_s: 5.0, ..GltfOptions::default() };
    let (doc, blob) = read(&scene(Some(&plan), &options).unwrap());
    let animations: Vec<_> = doc.animations().collect();
    assert_eq!(animations.len(), 2);
    let track = |a: &::gltf::Animation, node: &str| {
        let (mut at, mut turned, mut times) = (Vec::new(), Vec::new(), Vec::new());
        for channel in a.channels().filter(|c| c.target().node().name() == Some(node)) {
            let reader = channel.reader(|_| Some(&blob));
            times = reader.read_inputs().unwrap().collect();
            match reader.read_outputs().unwrap() {
                ::gltf::animation::util::ReadOutputs::Translations(t) => at = t.map(point).collect(),
                ::gltf::animation::util::ReadOutputs::Rotations(r) => turned = r.into_f32().map(rotation).collect(),
                _ => panic!("another kind of output"),
            }
        }
        (times, at, turned)
    };
    let (times, at, turned) = track(&animations[0], "tool");
    assert_eq!(times.len(), 181);
    assert!((times[180] - 5.0).abs() < 1e-5 && times.windows(2).all(|w| w[0] < w[1]));
    let (_, on_machine, head) = track(&animations[1], "tool");
    let (_, carried, table) = track(&animations[1], "workpiece");
    for k in 0..181 {
        let want = blade.model_from_blade * plan.toolpath.locations[k].centre;
        let axis = blade.model_from_blade * plan.stand(k).unwrap().axis();
        assert!((at[k] - want).norm() < 1e-4 && (turned[k] * Vector::z() - axis).norm() < 1e-6, "key {k}");
        // On the machine the head never turns, and part and tool meet at the same place of the
        // part.
        assert!((head[k] * Vector::z() - head[0] * Vector::z()).norm() < 1e-6);
        let in_part = table[k].inverse() * (on_machine[k] - carried[k].coords);
        assert!((in_part - want).norm() < 1e-3, "key {k}: {in_part} {want}");
        assert!((table[k].inverse() * (head[k] * Vector::z()) - axis).norm() < 1e-5);
    }
    let spindle = head[0] * Vector::z();
    assert!((spindle - Vector::new(sample::B_RAD.sin(), 0.0, sample::B_RAD.cos())).norm() < 1e-6);
}

#[test]
fn tool_and_machine_face_outward_and_the_ball_is_round() {
    let (doc, blob) = read(&scene(Some(&sample::plan(1, 12)), &GltfOptions::default()).unwrap());
    let tool = sample::tool();
    let mut height = 0.0f64;
    for mesh in doc.meshes() {
        let name = mesh.name().unwrap();
        let of_tool = ["ball", "taper", "shank", "holder 1", "holder 2"].contains(&name);
        if !of_tool && !["table", "spindle", "pivot of B", "altered points"].contains(&name) {
            continue;
        }
        for p in mesh.primitives() {
            let reader = p.reader(|_| Some(&blob));
            let at: Vec<_> = reader.read_positions().unwrap().map(point).collect();
            let normals: Vec<_> = reader.read_normals().unwrap().map(|n| point(n).coords).collect();
            let indices: Vec<usize> = reader.read_indices().unwrap().into_u32().map(|i| i as usize).collect();
            for t in indices.chunks(3) {
                let flat = (at[t[1]] - at[t[0]]).cross(&(at[t[2]] - at[t[0]]));
                assert!(flat.norm() > 1e-9, "a triangle without area in {name}");
                let mean: Vector = t.iter().map(|&i| normals[i]).sum();
                assert!(flat.dot(&mean) > 0.0, "{name} faces inward");
            }
            if name == "ball" {
                assert!(at.iter().all(|p| (p.coords.norm() - tool.radius_mm).abs() < 1e-5));
            }
            if of_tool {
                height = at.iter().fold(height, |h, p| h.max(p.z));
            }
        }
    }
    assert!((height - tool.length_mm()).abs() < 1e-4);
}

#[test]
fn fans_open_as_far_as_the_channel() {
    let plan = sample::plan(3, 60);
    let (doc, blob) = read(&scene(Some(&plan), &GltfOptions::default()).unwrap());
    let mesh = doc.meshes().find(|m| m.name() == Some("channel")).unwrap();
    let first = mesh.primitives().next().unwrap();
    let at: Vec<_> = first.reader(|_| Some(&blob)).read_positions().unwrap().map(point).collect();
    let row = plan.channel.narrowest_row;
    let axis = |theta| sample::blade().model_from_blade * plan.toolpath.cone(row).tool_axis(theta);
    let (lo, hi) = (plan.channel.rows[row].theta_min, plan.channel.rows[row].theta_max);
    assert!(((at[1] - at[0]).normalize() - axis(lo)).norm() < 1e-5);
    assert!(((at[25] - at[0]).normalize() - axis(hi)).norm() < 1e-5);
}

#[test]
fn a_budget_is_kept_while_there_is_something_to_leave_out() {
    let plan = sample::plan(20, 600);
    let whole = scene(Some(&plan), &GltfOptions::default()).unwrap().len();
    for budget_bytes in [whole / 2, whole / 4] {
        let bytes = scene(Some(&plan), &GltfOptions { budget_bytes, ..GltfOptions::default() }).unwrap();
        assert!(bytes.len() <= budget_bytes, "{} over {budget_bytes}", bytes.len());
        assert_eq!(read(&bytes).0.animations().count(), 2);
    }
}

#[test]
fn odd_inputs_give_a_scene_or_an_error_and_no_panic() {
    let options = GltfOptions::default();
    assert!(read(&scene(None, &options).unwrap()).0.animations().next().is_none());
    let mut empty = sample::plan(1, 12);
    empty.toolpath.locations.clear();
    assert!(scene(Some(&empty), &options).is_ok());
    let mut wild = sample::plan(1, 12);
    wild.toolpath.turns[0].first = usize::MAX;
    wild.channel.narrowest_row = usize::MAX;
    assert!(scene(Some(&wild), &options).is_ok());
    let mut bad = sample::plan(1, 12);
    bad.toolpath.locations[3].centre.x = f64::NAN;
    assert!(scene(Some(&bad), &options).is_err());
    let tight = GltfOptions { budget_bytes: 0, ..options };
    assert!(scene(Some(&sample::plan(2, 30)), &tight).is_ok());
}

#[test]
fn the_same_input_gives_the_same_bytes() {
    let make = || scene(Some(&sample::plan(2, 30)), &GltfOptions::default()).unwrap();
    assert_eq!(make(), make());
}

/// The axis that leans the tool is called as the machine calls it, and the lean is a range where it
/// differs along the path.
#[test]
fn the_head_has_the_name_of_its_axis_and_the_lean_its_range() {
    let file = |text: &str| Machine::from_toml(text, "test").unwrap();
    let fork = file(include_str!("../../../../models/machines/fork_head_ca.toml"));
    let four = file(include_str!("../../../../models/machines/four_axis_a.toml"));
    let one = sample::plan(1, 12);
    let lean_deg = one.toolpath.cone(0).lean_rad.to_degrees();
    let mut many = one.clone();
    let last = (many.toolpath.locations.len() - 1) as f64;
    let cone = |k: usize| Cone::about_blade(0.3 * k as f64 / last);
    many.toolpath.cones = Cones::along((0..many.toolpath.locations.len()).map(cone).collect());
    let range = [0.0, 0.3f64.to_degrees()];
    for (machine, plan, key, pivot, lean) in [
        (Machine::demo().unwrap(), &one, "head_angle_b_deg", Some("pivot of B"), json!(lean_deg)),
        (fork, &one, "head_angle_a_deg", Some("pivot of A"), json!(lean_deg)),
        (four, &one, "lean_deg", None, json!(lean_deg)),
        (Machine::demo().unwrap(), &many, "head_angle_b_deg", Some("pivot of B"), json!(range)),
    ] {
        let (doc, _) = read(&scene_on(&machine, Some(plan), &GltfOptions::default()).unwrap());
        let names: Vec<&str> = doc.nodes().filter_map(|n| n.name()).filter(|n| n.starts_with("pivot")).collect();
        assert_eq!(names, Vec::from_iter(pivot));
        let root = doc.nodes().find(|n| n.name().is_some_and(|n| n.ends_with("(model frame, mm)"))).unwrap();
        let said: serde_json::Value = serde_json::from_str(root.extras().as_ref().unwrap().get()).unwrap();
        let close =
            |a: &serde_json::Value, b: &serde_json::Value| (a.as_f64().unwrap() - b.as_f64().unwrap()).abs() < 1e-9;
        match (&said[key], &lean) {
            (serde_json::Value::Array(found), serde_json::Value::Array(want)) => {
                assert_eq!(found.len(), want.len(), "{said}");
                assert!(found.iter().zip(want).all(|(a, b)| close(a, b)), "{said}");
            }
            (found, want) => assert_eq!(found, want),
        }
    }
}
