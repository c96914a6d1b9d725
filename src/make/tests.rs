#![allow(clippy::unwrap_used)]
use std::collections::HashMap;
use std::f64::consts::{PI, TAU};
use std::path::PathBuf;

use proptest::prelude::*;

use super::profile::BladeSections;
use super::rolling_ball::IdealAirfoil;
use super::*;
use crate::geometry::Vector;
use crate::geometry::brep::Face;
use crate::geometry::nurbs::NurbsSurface;
use crate::geometry::part::Part;

fn models() -> PathBuf {
    PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("models")
}

fn ideal(d: &BladeDesign) -> IdealAirfoil {
    IdealAirfoil::new(BladeSections::new(d.airfoil.as_ref().unwrap()).unwrap(), d.platform.top_z_mm, d.height_mm)
}

/// A preset with a coarse mesh, for tests that look at its surfaces.
fn coarse(make: fn() -> BladeDesign) -> BladeDesign {
    let mut d = make();
    d.accuracy.deflection_mm = 0.5;
    d
}

fn free_form_presets() -> [BladeDesign; 3] {
    [presets::steam_root, presets::compressor_twist, presets::turbine_camber].map(coarse)
}

fn surfaces<'a>(b: &'a MadeBlade, names: &str) -> Vec<&'a NurbsSurface> {
    let chosen = |f: &&Face| f.name.own().contains("side") && f.name.own().starts_with("fillet") == (names == "fillet");
    b.brep.faces.iter().filter(chosen).map(|f| &f.surface).collect()
}

fn normal(s: &NurbsSurface, u: f64, v: f64) -> Vector {
    s.normal(u, v).unwrap()
}

/// Every edge of the mesh once in each sense, and no vertex twice at one place.
fn assert_watertight(b: &MadeBlade) {
    let mut edges: HashMap<[u32; 2], i32> = HashMap::new();
    for t in &b.mesh.triangles {
        for k in 0..3 {
            *edges.entry([t[k], t[(k + 1) % 3]]).or_default() += 1;
        }
    }
    assert!(edges.iter().all(|(e, n)| *n == 1 && edges.contains_key(&[e[1], e[0]])), "{} is open", b.name);
    let euler = b.mesh.points.len() as i64 - edges.len() as i64 / 2 + b.mesh.triangles.len() as i64;
    assert_eq!(euler, 2, "{} is not a ball", b.name);
    assert!(b.mesh.volume_mm3() > 0.0);
}

#[test]
fn presets_are_closed_and_their_meshes_keep_the_deflection() {
    for (name, make) in presets::ALL {
        let b = build(&make()).unwrap();
        assert_watertight(&b);
        assert!(b.deflection_mm <= make().accuracy.deflection_mm && b.deflection_mm > 0.0, "{name}");
        assert_eq!(b.mesh.corner_uv.len(), b.mesh.triangles.len());
        for (t, uv) in b.mesh.corner_uv.iter().enumerate().step_by(7) {
            let s = &b.brep.faces[b.mesh.face_of[t] as usize].surface;
            for (p, [u, v]) in b.mesh.corners(t).iter().zip(uv) {
                assert!((s.point(*u, *v) - p).norm() < 1e-9, "{name}: a corner is off its face");
            }
        }
    }
}

#[test]
fn edges_lie_on_the_boundaries_of_both_faces_and_loops_close() {
    for (name, make) in presets::ALL {
        let b = build(&coarse(make)).unwrap();
        let mut used = vec![[0, 0]; b.brep.edges.len()];
        for c in b.brep.faces.iter().flat_map(|f| f.loops.iter().flatten()) {
            used[c.edge][usize::from(c.reversed)] += 1;
        }
        assert!(used.iter().all(|u| *u == [1, 1]), "{name}");
        for (e, ends) in b.brep.edges.iter().zip(&b.edge_ends) {
            assert_eq!(e.curve.point(e.t[0]), b.vertices[ends[0]], "{name}");
            assert!((e.curve.point(e.t[1]) - b.vertices[ends[1]]).norm() < 1e-12, "{name}");
        }
        for l in b.brep.faces.iter().flat_map(|f| &f.loops) {
            for (k, c) in l.iter().enumerate() {
                let next = &l[(k + 1) % l.len()];
                let end = b.edge_ends[c.edge][usize::from(!c.reversed)];
                assert_eq!(end, b.edge_ends[next.edge][usize::from(next.reversed)], "{name}");
            }
        }
    }
}

#[test]
fn airfoil_fillet_and_platform_meet_smoothly() {
    for design in free_form_presets() {
        let b = build(&design).unwrap();
        let mut worst = [0.0_f64; 2];
        for (wall, fillet) in surfaces(&b, "airfoil").into_iter().zip(surfaces(&b, "fillet")) {
            let [[a, z], _] = wall.domain();
            for i in 0..=1000 {
                let u = a + (z - a) * i as f64 / 1000.0;
                assert_eq!(wall.point(u, 0.0), fillet.point(u, 1.0));
                let angle = |n: Vector, m: Vector| n.cross(&m).norm().atan2(n.dot(&m)).to_degrees();
                worst[0] = worst[0].max(angle(normal(wall, u, 0.0), normal(fillet, u, 1.0)));
                worst[1] = worst[1].max(angle(normal(fillet, u, 0.0), Vector::z()));
            }
        }
        eprintln!("{}: joints {:.5}° and {:.5}°", design.name, worst[0], worst[1]);
        assert!(worst[0] < 0.1 && worst[1] < 0.1, "{}: {worst:?}", design.name);
    }
}

#[test]
fn fillet_is_the_rolling_balls_surface_between_stations() {
    for design in free_form_presets() {
        let (b, ideal, r) = (build(&design).unwrap(), ideal(&design), design.fillet_radius_mm);
        let mut worst = 0.0_f64;
        let n = design.accuracy.stations;
        for (k, s) in surfaces(&b, "fillet").into_iter().enumerate() {
            for i in 0..n / 2 {
                let phi = TAU * ((k * n / 2 + i) as f64 + 0.5) / n as f64;
                for v in [0.0, 0.2, 0.5, 0.8, 1.0] {
                    worst = worst.max((distance_to_spine(&ideal, r, phi, &s.point(phi, v)) - r).abs());
                }
            }
        }
        eprintln!("{}: fillet {worst:.2e} mm off", design.name);
        assert!(worst < 1e-3, "{}: {worst}", design.name);
    }
}

/// Least distance to the centres of the rolling ball near φ, by Newton on differences.
fn distance_to_spine(ideal: &IdealAirfoil, r: f64, phi: f64, p: &Point) -> f64 {
    let f = |t: f64| (p - ideal.contact(t, r).unwrap().centre).norm_squared();
    let (mut t, h) = (phi, 1e-3);
    for _ in 0..5 {
        let [a, b, c] = [f(t - h), f(t), f(t + h)];
        let bend = c - 2.0 * b + a;
        if bend > 0.0 {
            t -= (0.5 * h * (c - a) / bend).clamp(-0.02, 0.02);
        }
    }
    f(t).sqrt()
}

#[test]
fn airfoil_is_the_law_between_stations_and_rows() {
    for design in free_form_presets() {
        let (b, ideal) = (build(&design).unwrap(), ideal(&design));
        let mut worst = 0.0_f64;
        for s in surfaces(&b, "airfoil") {
            let [[a, z], _] = s.domain();
            for i in 0..200 {
                for j in 0..40 {
                    let (u, v) = (a + (z - a) * (i as f64 + 0.37) / 200.0, (j as f64 + 0.5) / 40.0);
                    let p = s.point(u, v);
                    let d = (p - ideal.point(u, p.z)).dot(&ideal.normal(u, p.z)).abs();
                    worst = worst.max(d);
                }
            }
        }
        eprintln!("{}: airfoil {worst:.2e} mm off", design.name);
        assert!(worst < 1e-3, "{}: {worst}", design.name);
    }
}

#[test]
fn prism_has_its_closed_forms() {
    let b = build(&presets::prism()).unwrap();
    let (radius, half, r, height) = (10.0, 20.0, 6.0, 80.0);
    // Distance from the stadium's axis, for points on the prism above the platform.
    let reach = |p: &Point| (p.x.abs() - half).max(0.0).hypot(p.y);
    for f in b.brep.faces.iter().filter(|f| f.name.own().ends_with("side") || f.name.own().ends_with("end")) {
        let [[a, z], _] = f.surface.domain();
        for i in 0..=20 {
            for j in 0..=20 {
                let p = f.surface.point(a + (z - a) * i as f64 / 20.0, j as f64 / 20.0);
                if f.name.own().starts_with("fillet") {
                    let to_spine = (reach(&p) - radius - r).hypot(p.z - r);
                    assert!((to_spine - r).abs() < 1e-12, "{}", f.name);
                } else if !f.name.own().starts_with("platform") && !f.name.own().starts_with("root") {
                    assert!((reach(&p) - radius).abs() < 1e-12, "{}", f.name);
                }
            }
        }
    }
    // Pappus: the fillet's section is a square corner less a quarter circle; its centroid is 0.2234
    // r from both legs.
    let corner = r * r * (1.0 - PI / 4.0);
    let centroid = r * (10.0 - 3.0 * PI) / (12.0 - 3.0 * PI);
    let stadium = PI * radius * radius + 4.0 * half * radius;
    let fillet = corner * (4.0 * half + TAU * (radius + centroid));
    let block = 90.0 * (50.0 * 20.0 + 24.0 * 30.0);
    let exact = stadium * height + fillet + block;
    assert!((b.mesh.volume_mm3() / exact - 1.0).abs() < 1e-4, "{} {exact}", b.mesh.volume_mm3());
    let part = Part::from_mesh(b.mesh);
    assert!(part.inside(&Point::new(29.0, 0.0, 70.0)) && !part.inside(&Point::new(31.0, 0.0, 70.0)));
}

#[test]
fn circle_and_sharp_corner_are_prisms_too() {
    let mut d = presets::prism();
    d.prism = Some(PrismDesign { length_mm: 20.0, width_mm: 20.0, stagger_deg: 30.0 });
    let b = build(&d).unwrap();
    assert_watertight(&b);
    assert_eq!(b.brep.faces.iter().filter(|f| f.name.own().ends_with("end")).count(), 4);
    d.fillet_radius_mm = 0.0;
    d.accuracy.deflection_mm = 0.001;
    let b = build(&d).unwrap();
    assert_watertight(&b);
    let exact = PI * 100.0 * 80.0 + 90.0 * (50.0 * 20.0 + 24.0 * 30.0);
    assert!((b.mesh.volume_mm3() / exact - 1.0).abs() < 1e-4);
}

#[test]
fn a_mirrored_law_makes_the_mirrored_blade() {
    let mut d = presets::compressor_twist();
    d.accuracy = Accuracy { stations: 64, rows: 12, deflection_mm: 0.05 };
    d.platform.shear_deg = 0.0;
    d.platform.length_mm = 80.0;
    d.platform.outline.iter_mut().for_each(|o| o.half_width_mm += 30.0);
    let mut mirrored = d.clone();
    let negate = |l: &Law| match l {
        Law::Constant(c) => Law::Constant(-c),
        Law::Stations(s) => Law::Stations(s.iter().map(|[f, v]| [*f, -v]).collect()),
    };
    let a = mirrored.airfoil.as_mut().unwrap();
    (a.stagger_deg, a.inlet_deg, a.outlet_deg) = (negate(&a.stagger_deg), negate(&a.inlet_deg), negate(&a.outlet_deg));
    mirrored.platform.offset_y_mm *= -1.0;
    let (one, two) = (build(&d).unwrap(), build(&mirrored).unwrap());
    assert!((one.mesh.volume_mm3() / two.mesh.volume_mm3() - 1.0).abs() < 1e-4);
    // Round the section the mirrored blade is walked the other way: φ becomes 2π − φ.
    let (a, b) = (surfaces(&one, "airfoil"), surfaces(&two, "airfoil"));
    for i in 0..50 {
        let (u, v) = (PI * i as f64 / 50.0, i as f64 / 50.0);
        let (p, q) = (a[0].point(u, v), b[1].point(TAU - u, v));
        assert!((Point::new(q.x, -q.y, q.z) - p).norm() < 1e-9);
    }
}

#[test]
fn what_has_no_solid_is_refused() {
    let refused = |change: &dyn Fn(&mut BladeDesign), base: BladeDesign, says: &str| {
        let mut d = base;
        change(&mut d);
        let Err(e) = build(&d) else { panic!("{says}: was built") };
        assert!(e.message.contains(says) && e.advice.is_some(), "{e}");
    };
    refused(&|d| d.platform.outline[0].half_width_mm = 22.0, presets::steam_root(), "over the rim");
    refused(&|d| d.fillet_radius_mm = 16.0, presets::turbine_camber(), "hollow");
    refused(&|d| d.fillet_radius_mm = 0.0, presets::steam_root(), "fillet_radius_mm");
    refused(&|d| d.accuracy.stations = 15, presets::prism(), "stations");
    refused(&|d| d.prism = None, presets::prism(), "exactly one");
    refused(&|d| d.platform.outline.truncate(1), presets::prism(), "outline");
}

#[test]
fn step_reads_back_without_loss() {
    for make in [presets::turbine_camber, presets::prism] {
        let b = build(&coarse(make)).unwrap();
        let text = step_text(&b).unwrap();
        assert_eq!(text, step_text(&build(&coarse(make)).unwrap()).unwrap(), "same design, same file");
        let (model, report) = step_io::read(text.as_bytes()).unwrap();
        assert!(report.dropped.is_empty());
        let scene = model.scene();
        assert_eq!(scene.units().length.unwrap().to_si, 1e-3);
        let solids: Vec<_> = scene.all_solids().collect();
        assert_eq!(solids.len(), 1);
        let faces: Vec<_> = solids[0].faces().collect();
        assert_eq!(faces.len(), b.brep.faces.len());
        for (read, made) in faces.iter().zip(&b.brep.faces) {
            assert_eq!(read.surface().to_nurbs().unwrap(), write::surface(&made.surface), "{}", made.name);
            let bounds: Vec<_> = read.bounds().collect();
            assert_eq!(bounds.len(), made.loops.len());
            for (bound, l) in bounds.iter().zip(&made.loops) {
                for ((edge, _), c) in bound.oriented_edges().zip(l) {
                    assert_eq!(edge.curve().to_nurbs().unwrap(), write::curve(&b.brep.edges[c.edge].curve));
                }
            }
        }
    }
}

/// Numbers of a text, and the text between them.
fn split_numbers(text: &str) -> (Vec<f64>, String) {
    let number = |c: char| c.is_ascii_digit() || "+-.eE".contains(c);
    let (mut numbers, mut rest) = (Vec::new(), String::new());
    for token in text.split_inclusive(|c| !number(c)) {
        let (head, tail) = token.split_at(token.trim_end_matches(|c| !number(c)).len());
        match head.parse::<f64>() {
            Ok(x) => numbers.push(x),
            Err(_) => rest.push_str(head),
        }
        rest.push_str(tail);
    }
    (numbers, rest)
}

/// The committed files are what the design files make. Numbers are compared to 1e-7 mm, since sine
/// and cosine of another system may differ in the last digit; all else to the letter.
fn regenerates(name: &str) {
    let read = |ext: &str| std::fs::read_to_string(models().join(format!("{name}.{ext}"))).unwrap();
    let design = BladeDesign::from_toml(&read("toml")).unwrap();
    assert_eq!(design, presets::by_name(name).unwrap(), "preset and design file differ");
    let blade = build(&design).unwrap();
    for (made, committed) in [(step_text(&blade).unwrap(), read("step")), (obj_text(&blade), read("obj"))] {
        if made == committed {
            continue;
        }
        let ((a, made), (b, committed)) = (split_numbers(&made), split_numbers(&committed));
        assert!(made == committed && a.len() == b.len(), "{name}: regenerate models/{name}.*");
        let worst = a.iter().zip(&b).map(|(x, y)| (x - y).abs()).fold(0.0, f64::max);
        assert!(worst < 2e-7, "{name}: regenerate models/{name}.* ({worst} off)");
    }
}

#[test]
fn models_steam_root_regenerates() {
    regenerates("steam_root");
}

#[test]
fn models_compressor_twist_regenerates() {
    regenerates("compressor_twist");
}

#[test]
fn models_turbine_camber_regenerates() {
    regenerates("turbine_camber");
}

#[test]
fn models_prism_regenerates() {
    regenerates("prism");
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(12))]
    #[test]
    fn any_design_gives_a_closed_blade_or_an_error(
        chord in 20.0..90.0f64, twist in -60.0..60.0f64, turn in 0.0..50.0f64, thick in 0.05..0.25f64, at in 0.3..0.6f64,
        blunt in 0.5..3.0f64, fillet in 0.5..12.0f64, shear in -30.0..30.0f64, lean in -20.0..20.0f64,
    ) {
        let mut d = presets::steam_root();
        let ellipse = 0.5 * thick * thick * chord;
        let a = d.airfoil.as_mut().unwrap();
        a.chord_mm = Law::Constant(chord);
        a.stagger_deg = Law::Stations(vec![[0.0, 10.0], [1.0, 10.0 + twist]]);
        (a.inlet_deg, a.outlet_deg) = (Law::Constant(turn), Law::Constant(0.8 * turn));
        (a.thickness_mm, a.thickness_at) = (Law::Constant(thick * chord), Law::Constant(at));
        (a.leading_radius_mm, a.trailing_radius_mm) = (Law::Constant(blunt * ellipse), Law::Constant(0.7 * ellipse));
        a.lean_mm = Law::Stations(vec![[0.0, 0.0], [1.0, lean]]);
        d.fillet_radius_mm = fillet;
        d.platform.shear_deg = shear;
        d.accuracy = Accuracy { stations: 32, rows: 8, deflection_mm: 0.2 };
        match build(&d) {
            Ok(b) => assert_watertight(&b),
            Err(e) => prop_assert!(!e.message.is_empty()),
        }
    }
}
