//! Reading and recognition from files: good ones in all forms, bad ones with their sentences.
#![allow(clippy::unwrap_used)]

use std::path::PathBuf;
use std::sync::Mutex;

use super::sample::{PLATFORM, TIP, ascii_stl, binary_stl, blade, marked, motion, obj};
use super::*;
use crate::error::ErrorKind;
use crate::observe::Silent;

/// Loads these bytes from a file of this name.
fn load_bytes(name: &str, bytes: &[u8], options: &ModelOptions) -> Result<Blade> {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join(name);
    std::fs::write(&path, bytes).unwrap();
    load(&path, options, &Silent)
}

fn plain(name: &str, bytes: &[u8]) -> Result<Blade> {
    load_bytes(name, bytes, &ModelOptions::default())
}

/// Surveys these bytes.
fn look(name: &str, bytes: &[u8]) -> Result<Survey> {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join(name);
    std::fs::write(&path, bytes).unwrap();
    survey(&path, &ModelOptions::default(), &Silent)
}

/// The refusal of a file: always of kind input/output, one sentence that holds these words.
fn refused(name: &str, bytes: &[u8], words: &[&str]) {
    let error = plain(name, bytes).err().unwrap_or_else(|| panic!("{name} was accepted"));
    assert_eq!(error.kind, ErrorKind::InputOutput, "{error}");
    for word in words {
        assert!(error.to_string().contains(word), "\"{word}\" is not in \"{error}\"");
    }
}

#[test]
fn the_same_blade_from_every_mesh_format() {
    let mesh = blade();
    let upper = ascii_stl(&mesh).to_uppercase();
    let files: [(&str, Vec<u8>); 6] = [
        ("a.stl", ascii_stl(&mesh).into_bytes()),
        ("B.STL", upper.into_bytes()),
        ("c.stl", binary_stl(&mesh, "made by a test")),
        ("d.stl", binary_stl(&mesh, "solid made by a test, facet")),
        ("e.obj", obj(&mesh).into_bytes()),
        ("no_extension", ascii_stl(&mesh).into_bytes()),
    ];
    for (name, bytes) in files {
        let b = plain(name, &bytes).unwrap_or_else(|e| panic!("{name}: {e}"));
        assert!(b.diagnosis.closed && b.diagnosis.bodies == 1, "{name}");
        assert_eq!(b.part.mesh.triangles.len(), mesh.triangles.len(), "{name}");
        assert!((b.part.mesh.volume_mm3() / mesh.volume_mm3() - 1.0).abs() < 1e-6, "{name}");
        let x = b.model_from_blade * crate::geometry::Vector::x();
        assert!((x - crate::geometry::Vector::z()).norm() < 1e-12, "{name}: {x}");
        assert!((b.regions.platform_x_mm().unwrap() - PLATFORM).abs() < 0.01, "{name}: {:?}", b.regions);
        assert!((b.regions.airfoil_x_mm()[0] - PLATFORM).abs() < 0.1, "{name}: {:?}", b.regions);
        assert!((b.regions.airfoil_x_mm()[1] - TIP).abs() < 0.01, "{name}: {:?}", b.regions);
        assert!((b.regions.part_x_mm[1] - TIP).abs() < 1e-4 && b.regions.part_x_mm[0].abs() < 1e-4, "{name}");
        // The text names what a person looks for.
        let text = inspect_text(&look(name, &bytes).unwrap());
        for word in ["unit", "closed", "volume", "platform", "+Z of the model"] {
            assert!(text.contains(word), "{word} is not in\n{text}");
        }
    }
}

/// A byte-order mark neither hides the first line nor makes another format of the file.
#[test]
fn marks_before_the_first_line_change_nothing() {
    let mesh = blade();
    let no_head = obj(&mesh).split_once("blade\n").unwrap().1.to_owned();
    let step = std::fs::read(concat!(env!("CARGO_MANIFEST_DIR"), "/models/prism.step")).unwrap();
    for (name, bytes) in [
        ("a.obj", no_head.into_bytes()),
        ("a.stl", ascii_stl(&mesh).into_bytes()),
        ("no_extension", ascii_stl(&mesh).into_bytes()),
        ("a.step", step),
    ] {
        let [with, without] = [marked(&bytes), bytes].map(|b| look(name, &b).unwrap_or_else(|e| panic!("{name}: {e}")));
        assert_eq!(with.part.mesh.points, without.part.mesh.points, "{name}");
        assert_eq!(with.part.mesh.triangles, without.part.mesh.triangles, "{name}");
        assert_eq!(with.diagnosis.notes, without.diagnosis.notes, "{name}");
    }
    // The header of a binary STL may begin with anything.
    let binary = look("a.stl", &binary_stl(&mesh, "\u{feff}solid")).unwrap();
    assert_eq!(binary.part.mesh.triangles.len(), mesh.triangles.len());
    // What PowerShell writes.
    let wide: Vec<u8> = format!("\u{feff}{}", obj(&mesh)).encode_utf16().flat_map(u16::to_le_bytes).collect();
    refused("a.obj", &wide, &["a.obj", "UTF-16", "save it as UTF-8"]);
}

#[test]
fn turned_blades_are_found_turned() {
    let mesh = blade();
    // Upside down: the sense follows the root, not the coordinate.
    let down = mesh.clone().moved(&motion([std::f64::consts::PI, 0.0, 0.0], [3.0, 5.0, 7.0]));
    let b = plain("down.stl", ascii_stl(&down).as_bytes()).unwrap();
    assert!((b.model_from_blade * crate::geometry::Vector::x() + crate::geometry::Vector::z()).norm() < 1e-12);
    assert!((b.regions.airfoil_x_mm()[1] - (TIP - 7.0)).abs() < 0.01, "{:?}", b.regions);
    // Turned anyhow: the direction turns along, the regions keep their lengths.
    for turn in [[0.5, 0.8, -0.3], [1.1, -0.4, 0.7], [-0.9, 0.6, 1.4]] {
        let m = motion(turn, [10.0, -4.0, 2.0]);
        let b = plain("turned.stl", ascii_stl(&mesh.clone().moved(&m)).as_bytes()).unwrap();
        let (x, z) = (b.model_from_blade * crate::geometry::Vector::x(), m * crate::geometry::Vector::z());
        assert!(x.angle(&z).to_degrees() < 2.0, "{turn:?}: {:.3}°", x.angle(&z).to_degrees());
        let airfoil = b.regions.airfoil_x_mm()[1] - b.regions.airfoil_x_mm()[0];
        assert!((airfoil - (TIP - PLATFORM)).abs() < 3.0, "{turn:?}: {:?}", b.regions);
        assert!(b.regions.platform_x_mm().is_some(), "{turn:?}");
    }
}

#[test]
fn a_given_axis_is_taken_exactly() {
    let options = ModelOptions { axis: Some([0.02, 0.0, 2.0]), ..ModelOptions::default() };
    let b = load_bytes("a.stl", ascii_stl(&blade()).as_bytes(), &options).unwrap();
    let x = b.model_from_blade * crate::geometry::Vector::x();
    assert!((x - crate::geometry::Vector::new(0.01, 0.0, 1.0).normalize()).norm() < 1e-12);
    for axis in [[0.0; 3], [f64::NAN, 0.0, 1.0]] {
        let options = ModelOptions { axis: Some(axis), ..ModelOptions::default() };
        let error = load_bytes("a.stl", ascii_stl(&blade()).as_bytes(), &options).err().unwrap();
        assert_eq!(error.kind, ErrorKind::Usage, "{error}");
    }
}

#[test]
fn regions_that_are_given_are_taken() {
    let mut mesh = blade();
    // Two groups: all up to the platform's top, and the airfoil with its tip.
    let top = |c: &[u32; 3]| c.iter().all(|v| mesh.points[*v as usize].z >= PLATFORM - 1e-9);
    let (mut low, mut high) = (String::from("g root\n"), String::from("g the_airfoil\n"));
    for c in &mesh.triangles {
        let line = format!("f {} {} {}\n", c[0] + 1, c[1] + 1, c[2] + 1);
        if top(c) { high += &line } else { low += &line }
    }
    let vertices: String = mesh.points.iter().map(|p| format!("v {} {} {}\n", p.x, p.y, p.z)).collect();
    let bytes = (vertices + &low + &high).into_bytes();
    mesh.points.clear();
    let with = |change: &dyn Fn(&mut ModelOptions)| {
        let mut o = ModelOptions::default();
        change(&mut o);
        load_bytes("groups.obj", &bytes, &o)
    };
    let r = with(&|o| o.airfoil_mm = Some([50.0, 100.0])).unwrap().regions;
    assert_eq!(r.airfoil_x_mm(), [50.0, 100.0]);
    let r = with(&|o| o.platform_mm = Some(41.5)).unwrap().regions;
    assert_eq!((r.platform_x_mm(), r.airfoil_x_mm()[0]), (Some(41.5), 41.5));
    for faces in [vec!["the_airfoil".to_owned()], vec!["2".into()], vec!["THE_AIRFOIL".into()]] {
        let r = with(&|o| o.airfoil_faces = faces.clone()).unwrap().regions;
        assert!((r.airfoil_x_mm()[0] - PLATFORM).abs() < 0.5 && (r.airfoil_x_mm()[1] - TIP).abs() < 0.5, "{r:?}");
    }
    // The root as airfoil: its sections are one loop up to the platform.
    let r = with(&|o| o.airfoil_faces = vec!["1".into()]).unwrap().regions;
    assert!(r.airfoil_x_mm()[1] < PLATFORM + 0.5, "{r:?}");
    for change in [
        (&|o: &mut ModelOptions| o.airfoil_faces = vec!["7".into()]) as &dyn Fn(&mut ModelOptions),
        &|o| o.platform_faces = vec!["no such".into()],
        &|o| o.airfoil_mm = Some([50.0, 500.0]),
        &|o| o.platform_mm = Some(-3.0),
    ] {
        assert_eq!(with(change).err().unwrap().kind, ErrorKind::Usage);
    }
}

#[test]
fn units_scale_and_absurd_sizes_are_named() {
    let mut small = blade();
    small.points.iter_mut().for_each(|p| p.coords *= 0.001);
    let bytes = ascii_stl(&small).into_bytes();
    refused("metres.stl", &bytes, &["--unit m", "too small"]);
    let options = ModelOptions { unit: Some(Unit::M), ..ModelOptions::default() };
    let b = load_bytes("metres.stl", &bytes, &options).unwrap();
    assert!((b.part.mesh.volume_mm3() / blade().volume_mm3() - 1.0).abs() < 1e-9);
    assert_eq!(b.unit, Unit::M);
    // As slender as a wind turbine's blade and of such a length in metres: nothing is planned
    // before the unit is given.
    let mut slim = blade();
    slim.points.iter_mut().for_each(|p| (p.x, p.y) = (0.1 * p.x, 0.1 * p.y));
    let bytes = ascii_stl(&slim).into_bytes();
    refused("slim.stl", &bytes, &["unit is not certain", "--unit m, else --unit mm"]);
    let told = ModelOptions { unit: Some(Unit::Mm), ..ModelOptions::default() };
    load_bytes("slim.stl", &bytes, &told).unwrap();
    let bytes = ascii_stl(&small).into_bytes();
    // Looked at without a given unit: the unit is guessed, with the reason, and the plan is said to
    // be impossible.
    let text = inspect_text(&look("metres.stl", &bytes).unwrap());
    for words in
        ["m, guessed: in mm the part would be 0.1200 mm across", "not possible as it is", "the unit is a guess"]
    {
        assert!(text.contains(words), "{words} is not in\n{text}");
    }
    let mut tiny = blade();
    tiny.points.iter_mut().for_each(|p| p.coords *= 0.02);
    let b = plain("tiny.stl", ascii_stl(&tiny).as_bytes()).unwrap();
    assert!(
        b.diagnosis.notes.iter().any(|n| n.to_string().contains("too small for a blade")),
        "{:?}",
        b.diagnosis.notes
    );
}

#[test]
fn damaged_meshes_are_healed_or_refused() {
    let mesh = blade();
    // Wound inward.
    let mut inward = mesh.clone();
    inward.triangles.iter_mut().for_each(|t| t.swap(0, 1));
    let b = plain("inward.obj", obj(&inward).as_bytes()).unwrap();
    assert!(b.part.mesh.volume_mm3() > 0.0 && b.diagnosis.notes.iter().any(|n| n.to_string().contains("inward")));
    // Some triangles the wrong way round.
    let mut mixed = mesh.clone();
    mixed.triangles.iter_mut().step_by(5).for_each(|t| t.swap(0, 1));
    let b = plain("mixed.obj", obj(&mixed).as_bytes()).unwrap();
    assert!((b.part.mesh.volume_mm3() / mesh.volume_mm3() - 1.0).abs() < 1e-12);
    // A degenerate triangle is dropped.
    let mut flat = mesh.clone();
    flat.triangles.push([3, 3, 4]);
    let b = plain("flat.obj", obj(&flat).as_bytes()).unwrap();
    assert!(b.diagnosis.notes.iter().any(|n| n.to_string().starts_with("1 degenerate")), "{:?}", b.diagnosis.notes);
    // A hole.
    let mut open = mesh.clone();
    open.triangles.remove(700);
    let b = plain("open.obj", obj(&open).as_bytes()).unwrap();
    assert_eq!((b.diagnosis.closed, b.diagnosis.open_edges, b.diagnosis.openings.len()), (false, 3, 1));
    let text = inspect_text(&look("open.obj", obj(&open).as_bytes()).unwrap());
    for words in ["no: 3 open edges in 1 opening", "3 edges, ", "none, since the part is open", "+Z of the model"] {
        assert!(text.contains(words), "{words} is not in\n{text}");
    }
    // Vertices that differ by rounding.
    let mut jitter = mesh.clone();
    jitter.points = (0..jitter.triangles.len()).flat_map(|t| mesh.corners(t)).collect();
    jitter.points.iter_mut().step_by(7).for_each(|p| p.x += 2e-6);
    jitter.triangles = (0..jitter.triangles.len() as u32).map(|t| [3 * t, 3 * t + 1, 3 * t + 2]).collect();
    let b = plain("jitter.obj", obj(&jitter).as_bytes()).unwrap();
    assert_eq!(b.part.mesh.points.len(), mesh.points.len());
}

#[test]
fn bad_files_are_refused_with_a_sentence() {
    let mesh = blade();
    let ascii = ascii_stl(&mesh);
    let binary = binary_stl(&mesh, "test");
    refused("empty.stl", b"", &["is empty"]);
    refused("blank.obj", b" \n\n", &["white space"]);
    refused("text.step", b"this is no model\n", &["not a STEP file", "ISO-10303-21"]);
    refused("short.stl", &binary[..binary.len() / 2], &["ends early", "promises"]);
    refused("tiny.stl", &binary[..40], &["not an STL file"]);
    refused("cut.stl", &ascii.as_bytes()[..ascii.len() / 2], &[]);
    refused("cut_clean.stl", ascii.split("endsolid").next().unwrap().as_bytes(), &["ends early"]);
    refused("garbage.stl", ascii.replacen("vertex", "vortex", 1).as_bytes(), &["line 4"]);
    refused(
        "number.stl",
        ascii.replacen("vertex 20", "vertex two", 1).replacen("vertex ", "vertex x", 1).as_bytes(),
        &["does not belong"],
    );
    refused("none.stl", b"solid nothing\nendsolid nothing\n", &["no triangle"]);
    refused("none.obj", b"v 0 0 0\nv 1 0 0\n", &["no triangle"]);
    refused("words.obj", b"what is this\n", &[]);
    refused("index.obj", b"v 0 0 0\nv 1 0 0\nf 1 2 9\n", &[]);
    refused("nan.obj", obj(&mesh).replacen("v 2", "v nan ", 1).as_bytes(), &[]);
    refused("flat.obj", b"v 0 0 0\nv 9 0 0\nv 0 9 0\nf 1 2 3\nf 1 3 2\n", &["no volume"]);
    refused("part.sldprt", b"binary", &["cannot be read", "STEP"]);
    refused("part.xyz", b"1 2 3\n", &["neither its name nor its content"]);
    // What is no blade can still be looked at.
    let text = inspect_text(&look("flat.obj", b"v 0 0 0\nv 9 0 0\nv 0 9 0\nf 1 2 3\nf 1 3 2\n").unwrap());
    assert!(text.contains("no volume") && text.contains("no blade:"), "{text}");
    let error = load(&PathBuf::from("/nowhere/blade.step"), &ModelOptions::default(), &Silent).err().unwrap();
    assert_eq!(error.kind, ErrorKind::InputOutput);
    assert!(error.to_string().contains("/nowhere/blade.step"));
    let options = ModelOptions { deflection_mm: 0.0, ..ModelOptions::default() };
    assert_eq!(load_bytes("a.stl", ascii.as_bytes(), &options).err().unwrap().kind, ErrorKind::Usage);
}

proptest::proptest! {
    #![proptest_config(proptest::prelude::ProptestConfig::with_cases(64))]
    /// Any bytes under any name: a blade or an error, never a panic.
    #[test]
    fn any_bytes_give_a_result(
        bytes in proptest::collection::vec(proptest::num::u8::ANY, 0..400),
        start in proptest::sample::select(vec!["", "solid a\nfacet\n", "ISO-10303-21;\nHEADER;\n", "v 0 0 0\nf 1 1 1\n"]),
        name in proptest::sample::select(vec!["a.stl", "a.obj", "a.step", "a"]),
    ) {
        let all = [start.as_bytes(), &bytes].concat();
        if let Err(e) = plain(name, &all) {
            proptest::prop_assert_eq!(e.kind, ErrorKind::InputOutput);
        }
    }
}

/// What a run would show: notes reach the observer.
#[test]
fn notes_are_told_as_warnings() {
    #[derive(Default)]
    struct Ear(Mutex<Vec<String>>);
    impl Observer for Ear {
        fn warn(&self, warning: Warning) {
            self.0.lock().unwrap().push(warning.doubt.to_string());
        }
    }
    let mut mesh = blade();
    mesh.triangles.iter_mut().for_each(|t| t.swap(0, 1));
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("inward.obj");
    std::fs::write(&path, obj(&mesh)).unwrap();
    let ear = Ear::default();
    load(&path, &ModelOptions::default(), &ear).unwrap();
    assert!(ear.0.lock().unwrap().iter().any(|m| m.contains("inward")));
}
