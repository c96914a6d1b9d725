//! Axis and regions of made-up blades in any position: the same blade turned gives the same axis,
//! what the geometry leaves open is said to be open, and what is no single blade is refused. What
//! the user says takes the place of what is found.

use std::f64::consts::TAU;
use std::path::Path;
use std::process::{Command, Output};

use bladewright::artifact::blade::Unit;
use bladewright::artifact::region::Area;
use bladewright::job;
use bladewright::make;
use bladewright::make::design::{Accuracy, AirfoilDesign, BladeDesign, Law, OutlinePoint, PlatformDesign};
use bladewright::observe::Silent;
use bladewright::read::model::{self, ModelOptions, Survey};
use nalgebra::{Point3, UnitQuaternion, Vector3};

type Mesh = (Vec<Point3<f64>>, Vec<[usize; 3]>);

/// An airfoil: span along z from `foot`, chord, twist over the span, and how far the tip leans
/// along y, in degrees.
#[derive(Clone, Copy)]
struct Airfoil {
    foot: f64,
    span: f64,
    chord: f64,
    twist_deg: f64,
    lean_deg: f64,
    camber: f64,
}

const PLAIN: Airfoil = Airfoil { foot: 20.0, span: 100.0, chord: 40.0, twist_deg: 0.0, lean_deg: 0.0, camber: 0.08 };

/// Half thickness of a closed four-digit section, 12 % thick, over the chord.
fn thickness(x: f64) -> f64 {
    0.6 * (0.2969 * x.sqrt() - 0.126 * x - 0.3516 * x * x + 0.2843 * x.powi(3) - 0.1036 * x.powi(4))
}

const SIDE: usize = 40;
const HEIGHTS: usize = 50;

impl Airfoil {
    fn point(&self, share: f64, k: usize) -> Point3<f64> {
        // Once round: leading edge, upper side, trailing edge, lower side.
        let (i, upper) = if k <= SIDE { (k, true) } else { (2 * SIDE - k, false) };
        let x = 0.5 * (1.0 - (std::f64::consts::PI * i as f64 / SIDE as f64).cos());
        let t = thickness(x);
        let y = 4.0 * self.camber * x * (1.0 - x) + if upper { t } else { -t };
        let chord = self.chord * (1.0 - 0.2 * share);
        let (s, c) = (self.twist_deg.to_radians() * share).sin_cos();
        let (u, v) = (chord * (x - 0.45), chord * y);
        let z = self.foot + share * self.span;
        Point3::new(c * u - s * v, s * u + c * v + share * self.span * self.lean_deg.to_radians().tan(), z)
    }

    /// Closed at both ends by strips between the sides.
    fn mesh(&self) -> Mesh {
        let round = 2 * SIDE;
        let points = (0..HEIGHTS)
            .flat_map(|h| (0..round).map(move |k| (h, k)))
            .map(|(h, k)| self.point(h as f64 / (HEIGHTS - 1) as f64, k))
            .collect();
        let mut triangles = Vec::new();
        for h in 0..HEIGHTS - 1 {
            for k in 0..round {
                let (a, b) = (h * round + k, h * round + (k + 1) % round);
                triangles.extend([[a, a + round, b], [b, a + round, b + round]]);
            }
        }
        for (base, up) in [(0, false), ((HEIGHTS - 1) * round, true)] {
            for k in 0..SIDE {
                let [a, b] = [base + k, base + k + 1];
                let [c, d] = [base + (round - k) % round, base + round - k - 1];
                for t in [[a, b, d], [a, d, c]] {
                    if t[0] != t[1] && t[1] != t[2] && t[0] != t[2] {
                        triangles.push(if up { [t[0], t[2], t[1]] } else { t });
                    }
                }
            }
        }
        (points, triangles)
    }
}

/// Rotations spread over all directions, the same on every run.
fn rotation(seed: u32) -> UnitQuaternion<f64> {
    let share = |k: u32| f64::from((seed * 7 + k).wrapping_mul(2_654_435_761) >> 8) / f64::from(1u32 << 24);
    UnitQuaternion::from_euler_angles(TAU * share(1), TAU * share(2), TAU * share(3))
}

fn obj((points, triangles): &Mesh) -> String {
    let mut text = String::new();
    for p in points {
        text += &format!("v {} {} {}\n", p.x, p.y, p.z);
    }
    for t in triangles {
        text += &format!("f {} {} {}\n", t[0] + 1, t[1] + 1, t[2] + 1);
    }
    text
}

fn survey(text: &str) -> Survey {
    model::survey_bytes(Path::new("part.obj"), text.as_bytes(), &ModelOptions::default(), &Silent).expect("read")
}

fn turned((points, triangles): &Mesh, by: &UnitQuaternion<f64>) -> Mesh {
    (points.iter().map(|p| by * p).collect(), triangles.clone())
}

/// The blade axis found, root to tip, and what is doubted.
fn axis(survey: &Survey) -> (Vector3<f64>, Vec<String>) {
    let found = survey.found.as_ref().unwrap_or_else(|e| panic!("{e}"));
    (found.model_from_blade.rotation * Vector3::x(), found.doubts.iter().map(ToString::to_string).collect())
}

/// The axis of a mesh in three positions: within `within_deg` of z, turned along, root to tip.
fn stays_with(mesh: &Mesh, within_deg: f64, certain: bool) {
    for seed in 0..3 {
        let by = if seed == 0 { UnitQuaternion::identity() } else { rotation(seed) };
        let (found, doubts) = axis(&survey(&obj(&turned(mesh, &by))));
        let off_deg = found.angle(&(by * Vector3::z())).to_degrees();
        assert!(off_deg < within_deg, "turned by {seed}: {off_deg}° off, {doubts:?}");
        assert!(!certain || doubts.is_empty(), "turned by {seed}: {doubts:?}");
    }
}

#[test]
fn a_plain_airfoil_has_its_axis_in_any_position() {
    stays_with(&PLAIN.mesh(), 3.0, true);
    let (found, _) = axis(&survey(&obj(&PLAIN.mesh())));
    assert_eq!(found, Vector3::z(), "an airfoil drawn along a coordinate axis has that axis exactly");
}

#[test]
fn a_twisted_airfoil_has_its_axis_in_any_position() {
    stays_with(&Airfoil { twist_deg: 50.0, ..PLAIN }.mesh(), 6.0, true);
}

#[test]
fn a_leaning_airfoil_has_its_axis_in_any_position() {
    stays_with(&Airfoil { lean_deg: 12.0, twist_deg: 20.0, ..PLAIN }.mesh(), 14.0, true);
}

#[test]
fn an_airfoil_shorter_than_its_chord_has_its_axis_in_any_position() {
    stays_with(&Airfoil { span: 30.0, chord: 55.0, twist_deg: 8.0, ..PLAIN }.mesh(), 6.0, false);
}

#[test]
fn an_airfoil_of_deep_camber_has_its_axis_in_any_position() {
    stays_with(&Airfoil { camber: 0.25, twist_deg: 10.0, ..PLAIN }.mesh(), 6.0, true);
}

/// Two ways to see such a blade: along its middles, and square to its sections.
/// An airfoil from height 0 on a platform of this size along x, y and down.
fn on_a_platform(airfoil: &Airfoil, [wide, deep, thick]: [f64; 3]) -> Mesh {
    let round = 2 * SIDE;
    // From an airfoil's place straight out to the platform's side.
    let out = |p: Point3<f64>, z: f64| {
        let far = (0.5 * wide / p.x.abs().max(1e-9)).min(0.5 * deep / p.y.abs().max(1e-9));
        Point3::new(far * p.x, far * p.y, z)
    };
    let foot = |k: usize| airfoil.point(0.0, k);
    let mut points: Vec<Point3<f64>> = (0..round).map(|k| out(foot(k), -thick)).collect();
    points.extend((0..round).map(|k| out(foot(k), 0.0)));
    for h in 0..HEIGHTS {
        points.extend((0..round).map(|k| airfoil.point(h as f64 / (HEIGHTS - 1) as f64, k)));
    }
    let rings = points.len() / round;
    let ring = |h: usize, k: usize| h * round + k % round;
    let mut triangles: Vec<[usize; 3]> = (1..rings)
        .flat_map(|h| (0..round).map(move |k| (h - 1, h, k)))
        .flat_map(|(a, b, k)| [[ring(a, k + 1), ring(a, k), ring(b, k)], [ring(a, k + 1), ring(b, k), ring(b, k + 1)]])
        .collect();
    // Strips between both sides close bottom and tip.
    for (h, top) in [(0, false), (rings - 1, true)] {
        for k in 0..SIDE {
            let (a, b, c, d) = (ring(h, k), ring(h, k + 1), ring(h, 2 * SIDE - k - 1), ring(h, 2 * SIDE - k));
            for t in [[a, b, c], [a, c, d]].into_iter().filter(|t| t[0] != t[1] && t[1] != t[2] && t[2] != t[0]) {
                triangles.push(if top { [t[0], t[2], t[1]] } else { t });
            }
        }
    }
    (points, triangles)
}

#[test]
fn a_low_blade_on_a_wide_platform_has_its_axis_in_any_position() {
    let low = Airfoil { foot: 0.0, span: 34.0, chord: 30.0, twist_deg: 25.0, camber: 0.03, ..PLAIN };
    for platform in [[46.0, 40.0, 8.0], [40.0, 36.0, 14.0], [60.0, 30.0, 5.0]] {
        stays_with(&on_a_platform(&low, platform), 6.0, false);
    }
}

/// A blade drawn at random: low or high, thin or thick, flat or deep, twisted or straight, on a
/// plain shank or a dovetail.
fn drawn(seed: u32) -> BladeDesign {
    let share = |k: u32| f64::from((seed * 31 + k).wrapping_mul(2_654_435_761) >> 8) / f64::from(1u32 << 24);
    let between = |k: u32, from: f64, to: f64| from + share(k) * (to - from);
    let line = |from: f64, to: f64| Law::Stations(vec![[0.0, from], [1.0, to]]);
    let chord = 30.0;
    let (stagger, twist, turning) = (between(2, -10.0, 40.0), between(3, 0.0, 45.0), between(4, 10.0, 80.0));
    let (thick, thin) = (between(5, 2.4, 5.0), between(6, 0.5, 0.9));
    let deep = between(7, 5.0, 14.0);
    let half = between(8, 13.0, 26.0);
    let root = if share(9) < 0.5 {
        vec![[0.0, half], [deep, half], [deep, 0.6 * half], [2.0 * deep, 0.6 * half]]
    } else {
        vec![
            [0.0, half],
            [deep, half],
            [deep, 0.4 * half],
            [1.5 * deep, 0.4 * half],
            [2.0 * deep, 0.8 * half],
            [2.6 * deep, 0.8 * half],
        ]
    };
    BladeDesign {
        name: format!("drawn_{seed}"),
        height_mm: chord * between(1, 0.45, 2.8),
        fillet_radius_mm: between(10, 0.6, 1.6),
        airfoil: Some(AirfoilDesign {
            chord_mm: line(chord, chord * between(11, 0.6, 1.0)),
            stagger_deg: line(stagger, stagger + twist),
            inlet_deg: line(0.5 * turning, 0.4 * turning),
            outlet_deg: line(0.5 * turning, 0.3 * turning),
            thickness_mm: line(thick, thin * thick),
            thickness_at: Law::Constant(0.42),
            leading_radius_mm: line(0.12 * thick, 0.12 * thin * thick),
            trailing_radius_mm: line(0.08 * thick, 0.08 * thin * thick),
            stack_at: 0.5,
            sweep_mm: Law::Constant(0.0),
            lean_mm: Law::Constant(0.0),
        }),
        prism: None,
        platform: PlatformDesign {
            length_mm: chord * between(12, 1.25, 2.0),
            top_z_mm: 0.0,
            shear_deg: between(13, 0.0, 14.0),
            offset_x_mm: 0.0,
            offset_y_mm: -1.0,
            outline: root
                .into_iter()
                .map(|[depth_mm, half_width_mm]| OutlinePoint { depth_mm, half_width_mm })
                .collect(),
        },
        accuracy: Accuracy { stations: 64, rows: 8, deflection_mm: 0.05 },
    }
}

#[test]
fn blades_of_any_proportions_on_a_root_have_their_axis() {
    let mut found = 0;
    for seed in 0..30 {
        // An airfoil that its platform does not carry, or a fillet without room, is no blade.
        let Ok(blade) = make::build(&drawn(seed)) else { continue };
        let by = rotation(seed + 1);
        let mesh = (blade.mesh.points.clone(), blade.mesh.triangles.iter().map(|t| t.map(|i| i as usize)).collect());
        let survey = survey(&obj(&turned(&mesh, &by)));
        let (axis, doubts) = axis(&survey);
        let off_deg = axis.angle(&(by * Vector3::z())).to_degrees();
        let reasons = survey.found.as_ref().map(|f| &f.heights.reasons);
        assert!(off_deg < 3.0, "design {seed}: {off_deg}° off, {reasons:?}, {doubts:?}");
        found += 1;
    }
    assert!(found >= 15, "only {found} designs are blades");
}

#[test]
fn a_blade_that_leans_by_half_a_right_angle_is_told_to_be_uncertain() {
    let mesh = Airfoil { lean_deg: 45.0, span: 60.0, ..PLAIN }.mesh();
    let (found, doubts) = axis(&survey(&obj(&mesh)));
    let middles = Vector3::new(0.0, 1.0, 1.0).normalize();
    let off = found.angle(&middles).min(found.angle(&Vector3::z())).to_degrees();
    assert!(off < 12.0, "{found}");
    assert!(doubts.iter().any(|d| d.contains("not certain")), "{doubts:?}");
}

/// Pressure and suction side alone, with gaps along both edges and no ends: sections are joined
/// over the gaps.
#[test]
fn two_sheets_that_do_not_meet_are_one_airfoil() {
    let (points, triangles) = Airfoil { twist_deg: 15.0, ..PLAIN }.mesh();
    let round = 2 * SIDE;
    // The sides without their outermost strips, and without both ends.
    let sides = 2 * round * (HEIGHTS - 1);
    let keep = |t: &[usize; 3]| {
        let ks = t.map(|v| v % round);
        let inner = |k: usize| (2..=SIDE - 2).contains(&k) || (SIDE + 2..=round - 2).contains(&k);
        ks.iter().all(|k| inner(*k)) && (ks.iter().all(|k| *k < SIDE) || ks.iter().all(|k| *k > SIDE))
    };
    let open: Vec<[usize; 3]> = triangles[..sides].iter().copied().filter(keep).collect();
    let found = survey(&obj(&(points, open)));
    assert!(found.diagnosis.pieces == 2 && !found.diagnosis.closed);
    let off_deg = axis(&found).0.angle(&Vector3::z()).to_degrees();
    assert!(off_deg < 8.0, "{off_deg}");
}

/// Five blades on a hub.
fn wheel() -> Mesh {
    let (mut points, mut triangles): Mesh = (Vec::new(), Vec::new());
    let mut add = |mesh: Mesh| {
        let base = points.len();
        points.extend(mesh.0);
        triangles.extend(mesh.1.iter().map(|t| t.map(|v| v + base)));
    };
    for k in 0..5 {
        let by = UnitQuaternion::from_axis_angle(&Vector3::x_axis(), TAU * f64::from(k) / 5.0);
        add(turned(&Airfoil { foot: 38.0, span: 60.0, twist_deg: 30.0, ..PLAIN }.mesh(), &by));
    }
    let n = 90;
    let ring = |x: f64| (0..n).map(move |k| (x, TAU * f64::from(k) / f64::from(n)));
    let hub: Vec<Point3<f64>> =
        ring(-25.0).chain(ring(25.0)).map(|(x, a)| Point3::new(x, 40.0 * a.cos(), 40.0 * a.sin())).collect();
    let n = n as usize;
    let mut faces: Vec<[usize; 3]> =
        (0..n).flat_map(|k| [[k, (k + 1) % n, n + k], [(k + 1) % n, n + (k + 1) % n, n + k]]).collect();
    for k in 1..n - 1 {
        faces.extend([[0, k + 1, k], [n, n + k, n + k + 1]]);
    }
    add((hub, faces));
    (points, triangles)
}

#[test]
fn of_a_wheel_one_blade_is_taken() {
    for seed in [0, 5] {
        let by = if seed == 0 { UnitQuaternion::identity() } else { rotation(seed) };
        let found = survey(&obj(&turned(&wheel(), &by)));
        let bladed = found.wheel.as_ref().expect("a wheel").in_words();
        assert!(bladed.starts_with("a wheel of 5 blades about"), "{bladed}");
        assert!(seed != 0 || bladed.contains("about +X of the model through (0.00, "), "{bladed}");
        let (along, doubts) = axis(&found);
        let standing =
            |k: u8| UnitQuaternion::from_axis_angle(&Vector3::x_axis(), TAU * f64::from(k) / 5.0) * Vector3::z();
        let off_deg = (0..5).map(|k| along.angle(&(by * standing(k))).to_degrees()).fold(f64::INFINITY, f64::min);
        assert!(off_deg < 8.0, "{off_deg}: {doubts:?}");
        assert!(seed != 0 || along == Vector3::z(), "{along}");
        let notes: String = found.diagnosis.notes.iter().map(ToString::to_string).collect();
        assert!(notes.contains("the path goes round one blade"), "{notes}");
    }
}

/// Two blades of different size in one file: each can be chosen, the whole part stays, and a body
/// that is not there is an error that lists them.
#[test]
fn a_body_of_an_assembly_is_chosen_by_its_number() {
    let (mut points, mut triangles) = PLAIN.mesh();
    let small = Airfoil { span: 60.0, chord: 20.0, ..PLAIN }.mesh();
    let base = points.len();
    points.extend(small.0.iter().map(|p| Point3::new(p.z, p.x + 200.0, p.y)));
    triangles.extend(small.1.iter().map(|t| t.map(|v| v + base)));
    let text = obj(&(points, triangles));
    let read = |body| {
        let options = ModelOptions { body, ..ModelOptions::default() };
        model::survey_bytes(Path::new("part.obj"), text.as_bytes(), &options, &Silent)
    };
    for (body, along) in [(1, Vector3::z()), (2, Vector3::x())] {
        let survey = read(Some(body)).expect("read");
        assert_eq!((axis(&survey).0, survey.bodies.len()), (along, 2));
        let found = survey.found.as_ref().expect("found");
        assert_eq!(found.mesh.triangles.len(), survey.part.mesh.triangles.len(), "the whole part stays");
        let own = found.heights.part_x_mm;
        assert!((own[1] - own[0] - if body == 1 { 100.0 } else { 60.0 }).abs() < 0.5, "{own:?}");
    }
    let whole = read(None).expect("read");
    let told = match &whole.found {
        Ok(_) => whole.diagnosis.notes.iter().map(|n| format!("{n}\n")).collect(),
        Err(e) => e.to_string(),
    };
    assert!(told.contains("--body") && told.contains("2 bodies"), "{told}");
    let text = model::inspect_text(&whole);
    assert!(text.contains("assembly") && text.contains("1: ") && text.contains("an airfoil along"), "{text}");
    for wrong in [0, 3] {
        let e = read(Some(wrong)).err().expect("refused");
        assert!(e.to_string().contains(&format!("there is no body {wrong}; the model has 2: 1 (")), "{e}");
    }
}

/// An axis that contradicts what is found is told with both; one that is merely near it is not.
#[test]
fn an_axis_that_contradicts_the_part_is_told() {
    let told = |axis: &str| report("turbine_camber.obj", &["--unit", "mm", axis]);
    let text = told("--axis=-z");
    assert!(
        text.contains("was given as -Z of the model; without --axis +Z of the model is found, the opposite"),
        "{text}"
    );
    let text = told("--axis=x");
    assert!(text.contains("was given as +X of the model; without --axis +Z of the model is found, 90° away"), "{text}");
    for axis in ["--axis=z", "--axis=0.1,0,1"] {
        assert!(!told(axis).contains("without --axis"), "{axis}");
    }
    // Planned along it all the same, the refusal names the axis as its cause.
    let dir = tempfile::tempdir().expect("temporary folder");
    let out = Command::new(env!("CARGO_BIN_EXE_bladewright"))
        .args(["--quiet", "plan", "--unit", "mm", "--axis", "x", "--until", "path", "-o", "out"])
        .arg(model("turbine_camber.obj"))
        .current_dir(dir.path())
        .output()
        .expect("the command starts");
    let error = String::from_utf8_lossy(&out.stderr).into_owned();
    assert_eq!(out.status.code(), Some(3), "{error}");
    let refusal = error.split("error: ").nth(1).unwrap_or_default();
    assert!(refusal.contains("without --axis +Z of the model is found"), "{error}");
    assert!(refusal.contains("the axis is the likely cause"), "{error}");
}

/// Where only one side of the airfoil is named, the message names the other, and following it finds
/// the airfoil.
#[test]
fn a_side_that_was_not_named_is_named() {
    for options in [&["--axis", "z", "--faces", "airfoil=2"][..], &["--faces", "airfoil=2"]] {
        let text = report("compressor_twist.obj", &[&["--unit", "mm"], options].concat());
        for words in ["no airfoil was found on face 2", "the rest lies on", "--faces airfoil=1,2"] {
            assert!(text.contains(words), "{options:?}: `{words}` is not in\n{text}");
        }
    }
    let text = report("compressor_twist.obj", &["--unit", "mm", "--axis", "z", "--faces", "airfoil=1,2"]);
    assert!(text.contains("airfoil: x ="), "{text}");
}

/// A blade with root, platform and fillet: the same axis to a tenth of a degree, and the same
/// heights, in any position.
#[test]
fn a_blade_with_a_platform_is_found_alike_in_any_position() {
    let text = std::fs::read_to_string(model("turbine_camber.obj")).expect("model");
    for seed in 1..3 {
        let by = rotation(seed);
        let moved: String = text
            .lines()
            .map(|line| {
                let numbers: Vec<f64> = line.split(' ').skip(1).filter_map(|t| t.parse().ok()).collect();
                match (line.strip_prefix("v "), &numbers[..]) {
                    (Some(_), [x, y, z]) => {
                        let p = by * Point3::new(*x, *y, *z);
                        format!("v {} {} {}\n", p.x, p.y, p.z)
                    }
                    _ => format!("{line}\n"),
                }
            })
            .collect();
        let survey = survey(&moved);
        let (found, doubts) = axis(&survey);
        assert!(found.angle(&(by * Vector3::z())).to_degrees() < 0.1 && doubts.is_empty(), "{found} {doubts:?}");
        let heights = &survey.found.as_ref().expect("found").heights;
        assert!(heights.platform_x_mm.is_some_and(|x| x.abs() < 0.02), "{:?}", heights.platform_x_mm);
        assert!(heights.fillet_x_mm.is_some_and(|f| (f[1] - 2.5).abs() < 0.3), "{:?}", heights.fillet_x_mm);
        assert!((heights.airfoil_x_mm[1] - 40.0).abs() < 0.02, "{:?}", heights.airfoil_x_mm);
    }
}

fn model(name: &str) -> std::path::PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("models").join(name)
}

fn inspect(name: &str, options: &[&str]) -> Output {
    Command::new(env!("CARGO_BIN_EXE_bladewright"))
        .args(["--quiet", "inspect"])
        .arg(model(name))
        .args(options)
        .output()
        .expect("the command starts")
}

/// The report of a run that must succeed.
fn report(name: &str, options: &[&str]) -> String {
    let out = inspect(name, options);
    assert_eq!(out.status.code(), Some(0), "{options:?}\n{}", String::from_utf8_lossy(&out.stderr));
    String::from_utf8_lossy(&out.stdout).into_owned()
}

#[test]
fn what_the_user_says_takes_the_place_of_what_was_found() {
    let says = |options: &[&str], words: &[&str]| {
        let text = report("prism.obj", options);
        for word in words {
            assert!(text.contains(word), "{options:?}: `{word}` is not in\n{text}");
        }
    };
    says(&["--axis", "0,0,-2"], &["as given", "x = (0.000000, 0.000000, -1.000000)"]);
    says(&["--axis", "0.1,0,1"], &["x = (0.099504, 0.000000, 0.995037)"]);
    says(&["--unit", "inch"], &["unit       inch, as told", "2286.000 × 1270.000 × 3302.000 mm"]);
    says(&["--region", "airfoil=10,70"], &["airfoil: x = 10 to 70 mm, as given"]);
    says(&["--region", "platform=1.5"], &["platform: top at x = 1.500 mm, as given"]);
    let by_name = report("prism.obj", &["--faces", "platform=Platform_Top"]);
    assert!(by_name.contains("platform: top at x = 0.000 mm, as given"), "{by_name}");
    assert_eq!(by_name, report("prism.obj", &["--faces", "platform=10"]), "by name and by number");
    // The end of the prism: sections that lie on these faces alone.
    let faces = "airfoil=lower_side,2,upper_side,leading_end";
    says(&["--faces", faces], &["x = (0.000000, 0.000000, 1.000000)", "airfoil: x = "]);
}

#[test]
fn what_the_user_says_wrongly_is_an_error_that_names_it() {
    for (options, word) in [
        (["--faces", "airfoil=wing"], "no face is called wing; the part has 19 faces or groups"),
        (["--faces", "platform=20"], "no face is called 20"),
        (["--region", "airfoil=10,700"], "the part spans -50.000 to 80.000 mm along the blade axis"),
        (["--region", "platform=-51"], "platform height -51 mm"),
        (["--region", "fillet=1"], "airfoil=LO,HI or platform=TOP"),
        (["--axis", "0,0,0"], "not all 0"),
        (["--unit", "furlong"], "furlong"),
    ] {
        let out = inspect("prism.obj", &options);
        let text = format!("{}{}", String::from_utf8_lossy(&out.stdout), String::from_utf8_lossy(&out.stderr));
        // Regions that make no sense are told with the report; what cannot be parsed ends the
        // command.
        assert!(text.contains(word), "{options:?}: `{word}` is not in\n{text}");
    }
}

/// The prism's areas, by its closed forms: airfoil above the fillet, quarter-round fillet, platform
/// outside it, tip.
#[test]
fn colours_of_the_regions_are_on_the_right_triangles() {
    let dir = tempfile::tempdir().expect("temporary folder");
    let file = dir.path().join("regions.glb");
    report("prism.obj", &["--glb", &file.to_string_lossy()]);
    let bytes = std::fs::read(&file).expect("written");
    let glb = gltf::Gltf::from_slice(&bytes).expect("a glTF file");
    let blob = glb.blob.clone().expect("a binary chunk");
    let mut seen = Vec::new();
    for primitive in glb.meshes().flat_map(|m| m.primitives().collect::<Vec<_>>()) {
        let name = primitive.material().name().expect("named").to_owned();
        let colour = primitive.material().pbr_metallic_roughness().base_color_factor();
        let reader = primitive.reader(|_| Some(&blob));
        let points: Vec<[f32; 3]> = reader.read_positions().expect("positions").collect();
        for p in &points {
            // In metres, y up or z up: heights and distances from the axis are told by the closed
            // forms below alone.
            assert!(p.iter().all(|x| x.is_finite()));
        }
        seen.push((name, colour.map(|c| (c * 1000.0).round() as i32), points));
    }
    let names: Vec<&str> = seen.iter().map(|s| s.0.as_str()).collect();
    assert_eq!(names, ["airfoil", "fillet", "platform", "root", "tip"]);
    for (k, a) in seen.iter().enumerate() {
        assert!(seen[k + 1..].iter().all(|b| a.1 != b.1), "two areas have one colour");
    }
    let survey = model::survey(&model("prism.obj"), &ModelOptions::default(), &Silent).expect("read");
    let (areas, mesh) = (survey.areas(), &survey.part.mesh);
    for (t, area) in areas.iter().enumerate() {
        let c = mesh.corners(t);
        let p = (c[0].coords + c[1].coords + c[2].coords) / 3.0;
        let q = (p.x.abs() - 20.0).max(0.0).hypot(p.y);
        let want = match () {
            () if p.z > 79.999 => Area::Tip,
            () if p.z > 6.2 => Area::Airfoil,
            () if p.z > 0.2 && p.z < 5.5 => Area::Fillet,
            () if p.z > -0.001 && p.z < 0.001 && q > 16.5 => Area::Platform,
            () if p.z < -0.1 => Area::Root,
            () => continue,
        };
        assert_eq!(*area, want, "triangle {t} at {p}");
    }
}

/// A blade as its corners: `at(share of the span, place once round)` gives points; both ends are
/// closed.
fn lofted(at: impl Fn(f64, [f64; 2]) -> Point3<f64>) -> Mesh {
    let section = Airfoil { foot: 0.0, span: 1.0, chord: 1.0, lean_deg: 0.0, twist_deg: 0.0, ..PLAIN };
    let (mut points, triangles) = section.mesh();
    for p in &mut points {
        // The plain section without its taper, which is a fifth over the span.
        let own = 1.0 - 0.2 * p.z;
        *p = at(p.z, [p.x / own, p.y / own]);
    }
    (points, triangles)
}

/// Unit vector from the middle of the first section to that of the last, by area of the ends'
/// triangles.
fn end_to_end((points, triangles): &Mesh) -> Vector3<f64> {
    let (walls, each) = (4 * SIDE * (HEIGHTS - 1), (triangles.len() - 4 * SIDE * (HEIGHTS - 1)) / 2);
    let middle = |ts: &[[usize; 3]]| {
        let (mut sum, mut area) = (Vector3::zeros(), 0.0);
        for [a, b, c] in ts.iter().map(|t| t.map(|v| points[v].coords)) {
            let w = (b - a).cross(&(c - a)).norm();
            sum += w * (a + b + c) / 3.0;
            area += w;
        }
        sum / area
    };
    (middle(&triangles[walls + each..]) - middle(&triangles[walls..walls + each])).normalize()
}

/// In three positions: along the line from end to end, either sense, and said to be uncertain for
/// this reason.
fn runs_from_end_to_end(mesh: &Mesh, because: &str) {
    for seed in 0..3 {
        let by = if seed == 0 { UnitQuaternion::identity() } else { rotation(seed) };
        let (found, doubts) = axis(&survey(&obj(&turned(mesh, &by))));
        let off_deg = found.angle(&(by * end_to_end(mesh))).to_degrees();
        assert!(off_deg.min(180.0 - off_deg) < 0.1, "turned by {seed}: {off_deg}° off, {doubts:?}");
        assert!(doubts.iter().any(|d| d.contains("not certain") && d.contains(because)), "{doubts:?}");
    }
}

/// A fan blade: its sections lie on cylinders round z through the origin and slide round them from
/// root to tip, so that the way from end to end is far from a radius, to which the ends are square.
#[test]
fn a_swept_fan_blade_runs_from_end_to_end_and_is_said_to_lean() {
    let mesh = lofted(|share, [x, y]| {
        let r = 40.0 + 30.0 * share;
        // Round the shaft by chord and sweep, along it by thickness and stagger.
        let round = (30.0 * x + 40.0 * share) / r;
        Point3::new(r * round.cos(), r * round.sin(), 30.0 * y + 8.0 * share + 12.0 * x)
    });
    runs_from_end_to_end(&mesh, "the blade leans");
}

/// A blade of a centrifugal impeller: from hub to shroud is outwards where the air comes in and
/// along the shaft where it leaves.
#[test]
fn a_blade_that_turns_from_axial_to_radial_runs_from_hub_to_shroud() {
    let mesh = lofted(|share, [x, y]| {
        let along = x + 0.45;
        let (s, c) = (1.4 * along).sin_cos();
        let (hub, height) = ([80.0 * s, 30.0 + 90.0 * (1.0 - c)], share * (32.0 - 20.0 * along));
        let (z, r) = (hub[0] - height * s, hub[1] + height * c);
        // Wrapped against the rotation, and thinner towards the shroud.
        let round = -0.9 * along + (60.0 - 25.0 * share) * y / r;
        Point3::new(r * round.cos(), r * round.sin(), z)
    });
    runs_from_end_to_end(&mesh, "reach neither of its ends");
}

/// A Kaplan blade: two sheets that do not meet, wider than long, between two spheres about the
/// origin, with twist. Directions aslant look like an airfoil nearly as much, but it stands off its
/// shaft along one coordinate axis alone.
#[test]
fn a_wide_blade_between_spheres_stands_off_its_shaft() {
    let (points, triangles) = lofted(|share, [x, y]| {
        let (s, c) = (0.5 + 0.5 * share).sin_cos();
        let (u, v) = ((1.5 - 0.2 * share) * x + 0.25 * share, 0.5 * y * (1.0 - 0.5 * share));
        let d = Vector3::new(1.0, c * u - s * v, s * u + c * v).normalize();
        Point3::from((160.0 + 340.0 * share) * d)
    });
    let round = 2 * SIDE;
    let inner = |t: &[usize; 3]| {
        let ks = t.map(|v| v % round);
        ks.iter().all(|k| (1..SIDE).contains(k)) || ks.iter().all(|k| (SIDE + 1..round).contains(k))
    };
    let sides = 2 * round * (HEIGHTS - 1);
    let open: Vec<[usize; 3]> = triangles[..sides].iter().copied().filter(inner).collect();
    let (found, doubts) = axis(&survey(&obj(&(points, open))));
    assert!(found == Vector3::x() && doubts.is_empty(), "{found} {doubts:?}");
}

/// The ball is smaller than the fillet; one that is too large is told, with what it leaves and what
/// would fit.
#[test]
fn the_fillet_has_its_say_in_the_ball() {
    let file = Path::new(env!("CARGO_MANIFEST_DIR")).join("models/compressor_twist.obj");
    let options = ModelOptions { unit: Some(Unit::Mm), ..Default::default() };
    let blade = model::load(&file, &options, &Silent).expect("a blade");
    let settle = |text: &str| {
        let typed = job::parse(&format!("model.file = \"a.stl\"\n{text}"), "t").expect("a job");
        job::resolve(typed, Path::new("/b")).expect("a job").settle(&blade).expect("a tool")
    };
    let (job, chosen) = settle("");
    assert!(job.tool.radius_mm == 2.5 && chosen.warnings.is_empty(), "{chosen:?}");
    let (_, chosen) = settle("tool.radius_mm = 20");
    let told = chosen.warnings.iter().map(ToString::to_string).collect::<Vec<_>>().join("\n");
    for words in [
        "the ball of 20 mm is too large for this blade",
        "% of the fillet",
        "a ball of 2.5 mm would",
        "second operation",
    ] {
        assert!(told.contains(words), "{words} is not in {told}");
    }
    // Where the region ends above the fillet, it is no matter.
    let top = blade.regions.fillet_x_mm().expect("a fillet")[1];
    let (job, _) = settle(&format!("region.end_mm = {}\nregion.start_mm = {}", top + 0.5, top + 12.0));
    assert!(job.tool.radius_mm > 2.5, "{:?}", job.tool);
}
