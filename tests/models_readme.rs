//! `models/README.md` and the models agree: its two tables are read, and every figure in them that
//! a part itself shows is compared with what is found in the STEP file and in the OBJ file.

use std::path::{Path, PathBuf};

use bladewright::artifact::blade::Unit;
use bladewright::observe::Silent;
use bladewright::read::model::{self, ModelOptions, Survey};

fn models() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("models")
}

/// The row of a model in the table whose head has this column, as (column, cell).
fn row(column: &str, name: &str) -> Vec<(String, String)> {
    let text = std::fs::read_to_string(models().join("README.md")).expect("models/README.md");
    let cells =
        |line: &str| -> Vec<String> { line.trim_matches('|').split('|').map(|c| c.trim().to_owned()).collect() };
    let lines: Vec<&str> = text.lines().collect();
    let head = lines.iter().position(|l| l.starts_with("| file") && l.contains(column)).expect("the table");
    let found = lines[head..].iter().take_while(|l| l.starts_with('|')).find(|l| l.contains(&format!("`{name}`")));
    cells(lines[head]).into_iter().zip(cells(found.expect("the model's row"))).collect()
}

fn cell(row: &[(String, String)], column: &str) -> String {
    row.iter().find(|c| c.0.starts_with(column)).unwrap_or_else(|| panic!("no column {column}")).1.clone()
}

/// Numbers as the tables write them: a true minus, groups of three digits.
fn number(text: &str) -> f64 {
    let plain: String = text.replace('−', "-").chars().filter(|c| !c.is_whitespace()).collect();
    plain.parse().unwrap_or_else(|_| panic!("{text} is no number"))
}

/// `±a` or `a…b`.
fn range(text: &str) -> [f64; 2] {
    match (text.trim().strip_prefix('±'), text.split_once('…')) {
        (Some(half), _) => [-number(half), number(half)],
        (None, Some((a, b))) => [number(a), number(b)],
        _ => panic!("{text} is no range"),
    }
}

fn check(survey: &Survey, name: &str, exact: bool) {
    let (first, second) = (row("platform top z", name), row("volume", name));
    assert!(survey.unit == Unit::Mm && survey.diagnosis.closed, "{name}: unit and closedness");
    let found = survey.found.as_ref().unwrap_or_else(|e| panic!("{name}: {e}"));
    assert!(found.doubts.is_empty(), "{name}: {:?}", found.doubts);
    let axis = found.model_from_blade.rotation * nalgebra::Vector3::x();
    assert!(axis == nalgebra::Vector3::z(), "{name} stands along +z, found {axis}");
    let near = |what: &str, a: f64, b: f64, within: f64| {
        assert!((a - b).abs() <= within, "{name}: {what} is {a}, the README says {b}");
    };
    let b = survey.part.mesh.aabb().expect("not empty");
    let ranges: Vec<[f64; 2]> = cell(&second, "box").split(", ").map(range).collect();
    for (k, r) in ranges.iter().enumerate() {
        // A tenth is what the table gives; facets stay within the deflection.
        near(&format!("box {k}"), b.min[k], r[0], 0.06);
        near(&format!("box {k}"), b.max[k], r[1], 0.06);
    }
    let volume = number(&cell(&second, "volume"));
    near("volume", survey.part.measure().volume_mm3, volume, if exact { 5e-5 } else { 2e-4 } * volume);
    let top = number(&cell(&first, "platform top z"));
    let r = &found.heights;
    near("platform", r.platform_x_mm.expect("a platform"), top, 0.02);
    near("tip", r.airfoil_x_mm[1], top + number(&cell(&first, "airfoil height")), 0.02);
    let fillet = number(cell(&first, "fillet").trim_start_matches("R "));
    let [foot, end] = r.fillet_x_mm.expect("a fillet");
    near("fillet's foot", foot, top, 0.02);
    near("fillet's height", end - foot, fillet, 0.12 * fillet);
}

fn agrees(name: &str) {
    for kind in ["step", "obj"] {
        let survey = model::survey(&models().join(format!("{name}.{kind}")), &ModelOptions::default(), &Silent);
        check(&survey.expect("read"), name, kind == "step");
    }
}

#[test]
fn steam_root_agrees_with_the_readme() {
    agrees("steam_root");
}

#[test]
fn compressor_twist_agrees_with_the_readme() {
    agrees("compressor_twist");
}

#[test]
fn turbine_camber_agrees_with_the_readme() {
    agrees("turbine_camber");
}

#[test]
fn prism_agrees_with_the_readme() {
    agrees("prism");
}

/// Every model there is has its rows, so that none goes unchecked.
#[test]
fn every_model_is_in_the_readme() {
    for entry in std::fs::read_dir(models()).expect("readable") {
        let path = entry.expect("entry").path();
        if path.extension().is_some_and(|e| e == "step" || e == "obj") {
            let name = path.file_stem().expect("a name").to_string_lossy().into_owned();
            assert!(!row("platform top z", &name).is_empty() && !row("volume", &name).is_empty());
        }
    }
}
