//! Real blades from the folder that `BLADEWRIGHT_BLADES` names. They are not part of the repository
//! (their licences do not allow it); where the variable is not set, each test fails and says so.
//! Slow: `cargo nextest run --release --run-ignored only corpus`.

#[cfg(unix)]
use std::os::unix::fs::symlink;
#[cfg(windows)]
use std::os::windows::fs::symlink_dir as symlink;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};

use bladewright::artifact::Toolpath;
use bladewright::artifact::blade::{Blade, Unit};
use bladewright::artifact::toolpath::CutterLocation;
use bladewright::geometry::Point;
use bladewright::observe::Silent;
use bladewright::read::model::{self, ModelOptions};
use bladewright::verify;

fn blades() -> PathBuf {
    std::env::var_os("BLADEWRIGHT_BLADES")
        .map(PathBuf::from)
        .expect("BLADEWRIGHT_BLADES names the folder of real blades")
}

/// Runs `plan` into the folder `out` of a temporary one.
fn plan(model: &Path, options: &[&str]) -> (tempfile::TempDir, Output) {
    let out = tempfile::tempdir().expect("temporary folder");
    let run = Command::new(env!("CARGO_BIN_EXE_bladewright"))
        .args(["--quiet", "plan"])
        .arg(model)
        .arg("-o")
        .arg(out.path().join("out"))
        .args(options)
        .output()
        .expect("the command starts");
    (out, run)
}

/// Each setting behind its `--set`.
fn set<'a>(settings: &[&'a str]) -> Vec<&'a str> {
    settings.iter().flat_map(|v| ["--set", v]).collect()
}

/// The short form of the suite, which CI asks for.
fn is_short() -> bool {
    std::env::var_os("BLADEWRIGHT_SHORT").is_some()
}

/// Plans a blade of the corpus, checks included; the exit code must be 0. In the short form of the
/// suite ridges are three times as high.
fn plans(file: &str, scallop_mm: f64, options: &[&str]) {
    let asked = format!("path.scallop_mm={}", if is_short() { 3.0 * scallop_mm } else { scallop_mm });
    ends(file, &[options, &["--set", &asked]].concat(), 0, "");
}

/// A plan ends with this exit code and says this.
fn ends(file: &str, options: &[&str], code: i32, says: &str) {
    let folder = blades();
    let (_, run) = plan(&folder.join(file), options);
    let text = format!("{}{}", String::from_utf8_lossy(&run.stdout), String::from_utf8_lossy(&run.stderr));
    assert_eq!(run.status.code(), Some(code), "{file}\n{text}");
    assert!(text.contains(says), "{file}\n{text}");
}

/// Wheels and sectors tell how many blades they have, and about what.
#[test]
#[ignore = "real blades, see the file's head"]
fn corpus_wheels_and_sectors() {
    for (file, unit, says) in [
        ("turbocharger_turbine_sector.stl", None, "one sector of a wheel of 12 blades about +X"),
        ("tblade3_case7288/case7288_rotor_hubwedge.step", None, "one sector of a wheel of 16 blades about +X"),
        ("openfoam_propeller.obj", Some(Unit::M), "a wheel of 4 blades about +Y"),
        ("centrifugal_impeller.stl", None, "a wheel of 12 blades (alike every 60.0°) about +Y"),
        ("turbine_blade_firtree.igs", None, "none"),
        ("tblade3_case7288/case7288_rotor_blade.step", None, "none"),
    ] {
        let options = ModelOptions { unit, ..ModelOptions::default() };
        let survey = model::survey(&blades().join(file), &options, &Silent).expect("a model");
        let found = survey.wheel.as_ref().map_or_else(|| "none".into(), |b| b.in_words());
        assert!(found.starts_with(says), "{file}: {found}");
        let off_mm = survey.wheel.as_ref().map_or(0.0, |b| b.wheel().off_mm);
        assert!(off_mm < 0.02, "{file}: off by {off_mm} mm");
    }
}

#[test]
#[ignore = "real blades, see the file's head"]
fn corpus_rotor_on_a_hub_wedge() {
    plans("tblade3_case7288/case7288_rotor_hubwedge.step", 0.01, &["--set", "region.end_mm=73"]);
}

#[test]
#[ignore = "real blades, see the file's head"]
fn corpus_scanned_turbine_blade() {
    plans("turbine_blade_scan.stl", 0.01, &["--unit", "m", "--set", "tool.radius_mm=2", "--set", "region.end_mm=12"]);
}

#[test]
#[ignore = "real blades, see the file's head"]
fn corpus_turbocharger_sector() {
    // The blade stands radially, and the back plate of the hub sector is in the way of the tool at
    // once.
    let mut options = set(&["tool.radius_mm=1", "tool.taper_deg=2", "region.start_mm=36", "region.end_mm=31"]);
    options.extend(["--axis", "0,0,1"]);
    ends("turbocharger_turbine_sector.stl", &options, 3, "the channel closes at turn 1");
}

/// Along the heights over its hub, which turns, its blade is milled from the tips down to the hub.
/// The disc is cut out between the blades.
#[test]
#[ignore = "real blades, see the file's head"]
fn corpus_turbocharger_sector_over_its_hub() {
    let mut options = set(&["tool.radius_mm=0.75", "tool.taper_deg=3", "tool.shank_radius_mm=3"]);
    let machine = concat!("machine.file=", env!("CARGO_MANIFEST_DIR"), "/models/machines/trunnion_ac.toml");
    options.extend(set(&["tool.stickout_mm=60", machine]));
    if is_short() {
        options.extend(set(&["region.end_mm=16"]));
    }
    plans("turbocharger_turbine_sector.stl", 0.02, &options);
}

#[test]
#[ignore = "real blades, see the file's head"]
fn corpus_turns_round_the_turbocharger_sector_by_small_balls() {
    // Coarse facets, sharp edges and a narrow fillet lie across every turn: none may fold over the
    // one before, nor lie on it.
    let folder = blades();
    let model = folder.join("turbocharger_turbine_sector.stl");
    let corner = "in the corner the ball meets a wall that leans over more than 60°";
    // Settings, why the path ends, more turns than, the least twentieth of the ridges over the
    // scallop: over sharp edges larger balls cut down the ridges of other moves, which count as low
    // ones then.
    let regions: [(&[&str], &str, usize, f64); 5] = [
        (&["tool.radius_mm=0.3", "region.start_mm=26.3", "region.end_mm=21"], "the end of the region", 30, 0.96),
        (&["tool.radius_mm=0.25", "region.start_mm=25", "region.end_mm=20.5"], "the end of the region", 30, 0.97),
        (&["tool.radius_mm=0.3"], "the wall leans over more than 60°", 30, 0.92),
        (&["tool.radius_mm=0.75"], corner, 24, 0.82),
        (&["tool.radius_mm=1.5"], corner, 14, 0.45),
    ];
    // The short form leaves out the two regions with the most turns.
    let regions = &regions[if is_short() { 2 } else { 0 }..];
    let up = ModelOptions { axis: Some([0.0, 0.0, 1.0]), ..ModelOptions::default() };
    let blade = model::load(&model, &up, &Silent).expect("the sector");
    for &(region, end, count, least) in regions {
        let mut options = set(&["path.kind=constant-scallop", "path.scallop_mm=0.01"]);
        options.extend(set(region));
        options.extend(["--axis", "0,0,1", "--until", "path"]);
        let path = toolpath(&model, &options);
        assert!(path.end_reason.to_string().starts_with(end), "{region:?}: {}", path.end_reason);
        let length = |short: f64, long: f64, mm: f64| (short.min(mm), long.max(mm));
        let (shortest, longest) = path.turns.iter().fold((f64::INFINITY, 0.0), |(a, b), t| length(a, b, t.length_mm));
        assert!(path.turns.len() > count && longest < 1.2 * shortest, "{region:?}: {shortest} to {longest} mm");
        let turns: Vec<_> = path.turns.iter().map(|t| &path.locations[t.first..t.first + t.count]).collect();
        // Less than a fifth of the flat stepover, √(8 R h), from the next turn.
        let near_mm = 0.2 * (8.0 * path.radius_mm * 0.01).sqrt();
        let is_near = |p: &Point, next: &[CutterLocation]| next.iter().any(|l| (l.centre - p).norm() < near_mm);
        let inner = &turns[1..turns.len() - 1];
        let near: usize = inner.windows(2).map(|w| w[0].iter().filter(|l| is_near(&l.centre, w[1])).count()).sum();
        let all: usize = inner.iter().map(|t| t.len()).sum();
        assert!(near * 50 < all, "{region:?}: {near} of {all} places lie on the next turn");
        let ridges = verify::limit(&blade, &path, 0.01, 2000).expect("ridges");
        let [low, high, highest] = [ridges.ridge_p05_mm, ridges.ridge_p95_mm, ridges.ridge_p99_mm].map(|h| h / 0.01);
        eprintln!("{region:?}: ridges of {low:.4}, {high:.4}, {highest:.4} times the scallop");
        assert!(low > least && high < 1.02 && highest < 1.05, "{region:?}: ridges of {low} to {high}, {highest}");
    }
}

/// How far a cutter location is from the path of another plan, mm.
struct Apart {
    contact: Point,
    /// Along the normal at its contact.
    normal: f64,
    whole: f64,
}

/// The path of a plan, whole or not.
fn toolpath(model: &Path, options: &[&str]) -> Toolpath {
    let (out, run) = plan(model, options);
    assert_eq!(run.status.code(), Some(0), "{}: {}", model.display(), String::from_utf8_lossy(&run.stderr));
    let text = |file: &str| std::fs::read_to_string(out.path().join("out").join(file));
    let text = text("toolpath.json").or_else(|_| text("plan.json")).expect("toolpath.json or plan.json");
    let mut file: serde_json::Value = serde_json::from_str(&text).expect("JSON");
    let path = file.get_mut("toolpath").map(serde_json::Value::take);
    serde_json::from_value(path.unwrap_or(file)).expect("a toolpath")
}

/// The cutter locations of a plan in model frame; whole, checks included, unless the options or the
/// short form of the suite end it before.
fn located(model: &Path, options: &[&str]) -> Vec<CutterLocation> {
    let to_model = read(model, None).model_from_blade;
    let moved = |l: CutterLocation| CutterLocation {
        centre: to_model * l.centre,
        contact: to_model * l.contact,
        normal: to_model * l.normal,
        ..l
    };
    // Locations do not depend on the schedule: the quickest will do.
    let is_path_enough = is_short() && !options.contains(&"--until");
    let until: &[&str] = if is_path_enough { &["--until", "path"] } else { &[] };
    let options = [&set(&["schedule.kind=piecewise"])[..], until, options].concat();
    toolpath(model, &options).locations.into_iter().map(moved).collect()
}

/// Every 23rd location of a path from another path.
fn apart(from: &[CutterLocation], path: &[CutterLocation]) -> Vec<Apart> {
    let off = |p: &Point| {
        let to = |w: &[CutterLocation]| {
            let (d, r) = (w[1].centre - w[0].centre, p - w[0].centre);
            r - (d.dot(&r) / d.norm_squared().max(f64::MIN_POSITIVE)).clamp(0.0, 1.0) * d
        };
        let all = from.windows(2).map(to);
        all.min_by(|v, w| v.norm_squared().total_cmp(&w.norm_squared())).expect("a path of two places")
    };
    let one = |l: &CutterLocation| {
        let v = off(&l.centre);
        Apart { contact: l.contact, normal: v.dot(&l.normal).abs(), whole: v.norm() }
    };
    path.iter().step_by(23).map(one).collect()
}

/// Prints the greatest, and others at shares of the sorted values; gives the greatest back.
fn told(what: &str, x: impl Iterator<Item = f64>) -> f64 {
    let mut x: Vec<f64> = x.collect();
    x.sort_by(f64::total_cmp);
    let share = |s: f64| x[((x.len() - 1) as f64 * s) as usize];
    eprintln!(
        "{what}: {} places, median {:.4}, 90 % {:.4}, 99 % {:.4}, greatest {:.4} mm",
        x.len(),
        share(0.5),
        share(0.9),
        share(0.99),
        share(1.0)
    );
    share(1.0)
}

/// The same part as STEP solid and as loose faces of IGES: the same path, however differently it is
/// sampled.
#[test]
#[ignore = "real blades, see the file's head"]
fn corpus_step_and_iges_give_the_same_locations() {
    let folder = blades();
    let [a, b] = ["step", "iges"].map(|kind| {
        located(&folder.join(format!("tblade3_case7288/case7288_rotor_hubwedge.{kind}")), &set(&["region.end_mm=73"]))
    });
    let worst = told("STEP and IGES", apart(&a, &b).iter().map(|f| f.whole));
    assert!(worst < 0.001, "{worst} mm apart");
}

/// The airfoil as STEP and as the table of its sections. The STEP interpolates control points of a
/// spline that was fitted to each section by itself, so its lines along the span slip from section
/// to section, and between them it sways. How far is measured without our reading of the table: the
/// table's points are moved onto the STEP's faces, where they are columns that do not slip, and
/// lofted again; what lies between those sections and the STEP is the STEP's own. That, and how far
/// the table's points are from the STEP, is the difference of the published forms; elsewhere the
/// cutter locations must agree.
#[test]
#[ignore = "real blades, see the file's head"]
fn corpus_case7288_table_and_step_give_the_same_locations() {
    let folder = blades();
    let folder = folder.join("tblade3_case7288");
    let (table, step) = (folder.join("blade3d.Case7-28-8.dat"), folder.join("case7288_rotor_blade.step"));
    let faces = read(&step, None);
    let to_faces = faces.model_from_blade.inverse();
    let on_faces = |p: Point| faces.part.closest(&(to_faces * p), f64::INFINITY).expect("a closest point");
    let mut moved = String::new();
    let mut published = Vec::new();
    for line in std::fs::read_to_string(&table).expect("the table").lines() {
        let row: Vec<f64> = line.split_whitespace().filter_map(|w| w.parse().ok()).collect();
        match row[..] {
            [x, y, z] => {
                let near = on_faces(Point::new(x, y, z));
                let p = faces.model_from_blade * near.point;
                moved += &format!("{:?} {:?} {:?}\n", p.x, p.y, p.z);
                published.push((Point::new(x, y, z), near.distance_mm));
            }
            _ => moved += &format!("{line}\n"),
        }
    }
    told("the table's points from the STEP", published.iter().map(|p| p.1));
    let folder = tempfile::tempdir().expect("temporary folder");
    let path = folder.path().join("again.dat");
    std::fs::write(&path, moved).expect("the table is written");
    // A share of its vertices is enough: they lie on the faces, however coarse the facets.
    let coarse = ModelOptions { deflection_mm: 0.015, ..ModelOptions::default() };
    let again = model::load(&path, &coarse, &Silent).expect("the table is read");
    let sway = sides_apart(&again, &faces, |p| p);
    told("the STEP between its own sections", sway.iter().map(|p| p.1));
    // By how much the published forms may differ about a place: at the sections (those on either
    // side are within 3 mm) and, besides, between them.
    let differ = |c: &Point| {
        let near = |known: &[(Point, f64)], radius: f64| {
            let nearest =
                known.iter().min_by(|a, b| (a.0 - c).norm().total_cmp(&(b.0 - c).norm())).map_or(f64::MAX, |p| p.1);
            known.iter().filter(|p| (p.0 - c).norm() < radius).map(|p| p.1).fold(nearest, f64::max)
        };
        near(&published, 3.0) + near(&sway, 1.0)
    };

    let region = set(&["region.start_mm=130", "region.end_mm=80"]);
    // Whole plans of tables are tried below.
    let (a, b) = (located(&step, &region), located(&table, &[&region[..], &["--until", "path"]].concat()));
    let found = apart(&a, &b);
    told("cutter locations, along the normal", found.iter().map(|f| f.normal));
    // Along the surface the paths differ in their pitch, which follows the curvature.
    told("cutter locations, from the path", found.iter().map(|f| f.whole));
    let alike: Vec<&Apart> = found.iter().filter(|f| differ(&f.contact) < 0.004).collect();
    eprintln!("the published forms agree within 0.004 mm about {} of {} locations", alike.len(), found.len());
    assert!(5 * alike.len() > found.len());
    let worst = told("cutter locations there, along the normal", alike.iter().map(|f| f.normal));
    assert!(worst < 0.005, "{worst} mm apart");
    // Elsewhere the locations differ by no more than the forms.
    let over = told("over what the forms differ by", found.iter().map(|f| f.normal - differ(&f.contact)));
    assert!(over < 0.005, "{over} mm more than the forms");
}

/// Thin blades, with edges that every turn goes round: no turn lies on the next, and none is left
/// out.
#[test]
#[ignore = "real blades, see the file's head"]
fn corpus_thin_blades_are_cut_once() {
    let folder = blades();
    // Where turns fold over one another near the end, a schedule fits only what lies above: half of
    // the area.
    let fan = "fan_sections/fan_DERIVED_loft.step";
    // The end of the fan's turns runs round a corner of it, a fifth of the way round the blade:
    // with few turns between they grow fast. With 0.06 the seam comes to the end before the rest
    // does. From the propeller's own end, down to where the ball rolls over the corners of its
    // root, no turns can be laid up with the two coarser scallops: they are from a little higher.
    let propeller = "dtmb_p4119/p4119_DERIVED_loft_mm.step";
    // One plan of each goes on to its checks, which tell whether the schedule fits all of the
    // turns; the feed takes most of its time.
    let plans = [
        (propeller, 0.01, 8500.0, false),
        (propeller, 0.03, 9500.0, true),
        (propeller, 0.1, 8500.0, false),
        (fan, 0.01, 350.0, true),
        (fan, 0.05, 340.0, false),
        (fan, 0.06, 340.0, false),
    ];
    for (file, scallop_mm, least_mm2, is_whole) in plans {
        // The short form lays the coarse turns, one whole plan among them.
        if is_short() && scallop_mm < 0.03 {
            continue;
        }
        let model = folder.join(file);
        let asked = format!("path.scallop_mm={scallop_mm}");
        let mut options = set(&[&asked]);
        if !is_whole {
            options.extend(["--until", "path"]);
        }
        let path = toolpath(&model, &options);
        let found = verify::limit(&read(&model, None), &path, scallop_mm, 20_000).expect("the limit");
        assert!(found.ratio < 1.03, "{file}: {}", found.ratio);
        assert!(found.area_mm2 > least_mm2, "{file}: {}", found.area_mm2);
        let [low, high] = [found.ridge_p05_mm, found.ridge_p99_mm].map(|ridge_mm| ridge_mm / scallop_mm);
        assert!(low > 0.95 && high < 1.05, "{file}: ridges of {low} to {high} times {scallop_mm} mm");
    }
}

/// Loose, mixed-up IGES faces with slivers: above the fillet with a large ball, the fillet with one
/// that fits into it.
#[test]
#[ignore = "real blades, see the file's head"]
fn corpus_fir_tree_blade_above_its_fillet() {
    let options = set(&["tool.radius_mm=6", "region.start_mm=50", "region.end_mm=27"]);
    plans("turbine_blade_firtree.igs", 0.03, &options);
}

#[test]
#[ignore = "real blades, see the file's head"]
fn corpus_fir_tree_blade_in_its_fillet() {
    let options = set(&["tool.radius_mm=1.4", "region.start_mm=26", "region.end_mm=20.5"]);
    plans("turbine_blade_firtree.igs", 0.03, &options);
}

/// Every file of the corpus ends with an exit code of the list, never with a panic.
#[test]
#[ignore = "real blades, see the file's head"]
fn corpus_inspect_never_panics() {
    let folder = blades();
    let mut open = vec![folder];
    while let Some(dir) = open.pop() {
        for entry in std::fs::read_dir(dir).expect("readable") {
            let path = entry.expect("entry").path();
            if path.is_dir() {
                open.push(path);
                continue;
            }
            let run = Command::new(env!("CARGO_BIN_EXE_bladewright"))
                .args(["--quiet", "inspect"])
                .arg(&path)
                .output()
                .expect("the command starts");
            let text = String::from_utf8_lossy(&run.stderr);
            assert!(matches!(run.status.code(), Some(0..=4)), "{}\n{text}", path.display());
            assert!(!text.contains("panicked"), "{}\n{text}", path.display());
        }
    }
}

/// Headers of the tables of the corpus, `FOLDER` standing for its path.
const ROTOR37: &str = r#"[sections]
files = "FOLDER/rotor37/rotor37geometry.dat"
unit = "cm"
columns = ["skip", "z", "r", "theta1", "theta2"]
"#;
const HECC: &str = r#"[sections]
files = "FOLDER/hecc_impeller_main/*section*.csv"
unit = "inch"
columns = ["x", "r*theta", "r"]
"#;
const P4119: &str = r#"[sections]
files = "FOLDER/dtmb_p4119/PANELGRID.DAT"
unit_mm = 152.0
zones = ["blade 1"]
"#;

fn read(path: &Path, unit: Option<Unit>) -> Blade {
    let options = ModelOptions { unit, ..ModelOptions::default() };
    model::load(path, &options, &Silent).unwrap_or_else(|e| panic!("{}: {e}", path.display()))
}

/// Places on the sides of a lofted table (vertices of its tessellation, which lie on the faces) in
/// its model frame, with their distances, mm, from the exact faces of another model of the blade;
/// where that ends sooner, at a flat or ruled cap, nothing is compared. `turn` brings the table's
/// model frame into the other's.
fn sides_apart(table: &Blade, other: &Blade, turn: impl Fn(Point) -> Point) -> Vec<(Point, f64)> {
    let faces = &table.part.brep.as_ref().expect("lofted faces").faces;
    let others = &other.part.brep.as_ref().expect("exact faces").faces;
    let mesh = &table.part.mesh;
    let mut on_side = vec![false; mesh.points.len()];
    for (t, face) in mesh.triangles.iter().zip(&mesh.face_of) {
        let side = !faces[*face as usize].name.own().contains("cap");
        t.iter().for_each(|v| on_side[*v as usize] |= side);
    }
    let to_other = other.model_from_blade.inverse();
    let one = |p: &Point| {
        let p = table.model_from_blade * p;
        let near = other.part.closest(&(to_other * turn(p)), f64::INFINITY)?;
        let surface = &others[near.face as usize].surface;
        (surface.degree_u > 1 && surface.degree_v > 1).then_some((p, near.distance_mm))
    };
    let sides = mesh.points.iter().zip(on_side).filter(|(_, s)| *s);
    sides.filter_map(|(p, _)| one(p)).collect()
}

/// The table read and lofted, against a loft or CAD model of the same blade that others made:
/// greatest and mean distance, mm.
fn agrees(table: &Path, unit: Option<Unit>, step: &str, turn: impl Fn(Point) -> Point, limits: [f64; 2]) {
    let folder = blades();
    let places = sides_apart(&read(table, unit), &read(&folder.join(step), None), turn);
    let mut d: Vec<f64> = places.into_iter().map(|p| p.1).collect();
    d.sort_by(f64::total_cmp);
    let (greatest, mean) = (d[d.len() - 1], d.iter().sum::<f64>() / d.len() as f64);
    let share = |s: f64| d[((d.len() - 1) as f64 * s) as usize];
    eprintln!(
        "{}: {} places, mean {mean:.4}, median {:.4}, 90 % {:.4}, 99 % {:.4}, greatest {greatest:.4} mm",
        table.display(),
        d.len(),
        share(0.5),
        share(0.9),
        share(0.99)
    );
    assert!(greatest <= limits[0] && mean <= limits[1], "{}: greatest {greatest}, mean {mean} mm", table.display());
}

/// A header in a folder of its own.
fn header(text: &str) -> (tempfile::TempDir, PathBuf) {
    let dir = tempfile::tempdir().expect("temporary folder");
    let path = dir.path().join("table.toml");
    // Tables lie in the folder of their header or below it.
    symlink(blades(), dir.path().join("blades")).expect("a link");
    std::fs::write(&path, text.replace("FOLDER", "blades")).expect("header written");
    (dir, path)
}

/// Cylindrical coordinates turn about x in the lofts that were derived from these tables, the other
/// way round.
fn about_x(p: Point) -> Point {
    Point::new(p.z, p.y, p.x)
}

#[test]
#[ignore = "real blades, see the file's head"]
fn corpus_table_rotor37() {
    let (_dir, path) = header(ROTOR37);
    agrees(&path, None, "rotor37/rotor37_DERIVED_loft_mm.step", about_x, [0.4, 0.03]);
}

#[test]
#[ignore = "real blades, see the file's head"]
fn corpus_table_rotor37_curve() {
    let folder = blades();
    let path = folder.join("rotor37/profile_R37.dat");
    // Another publication of the blade, hot against cold: tenths of a millimetre apart.
    agrees(&path, Some(Unit::Cm), "rotor37/rotor37_DERIVED_loft_mm.step", |p| p, [0.8, 0.2]);
}

#[test]
#[ignore = "real blades, see the file's head"]
fn corpus_table_hecc() {
    let (_dir, path) = header(HECC);
    agrees(
        &path,
        None,
        "hecc_impeller_main/hecc_main_DERIVED_loft_mm.step",
        |p| Point::new(p.x, p.z, p.y),
        [0.3, 0.02],
    );
}

#[test]
#[ignore = "real blades, see the file's head"]
fn corpus_table_fan() {
    let folder = blades();
    agrees(
        &folder.join("fan_sections/ori-sections.dat"),
        None,
        "fan_sections/fan_DERIVED_loft.step",
        |p| p,
        [0.25, 0.02],
    );
}

#[test]
#[ignore = "real blades, see the file's head"]
fn corpus_table_p4119() {
    let (_dir, path) = header(P4119);
    agrees(&path, None, "dtmb_p4119/p4119_DERIVED_loft_mm.step", |p| p, [0.06, 0.004]);
}

#[test]
#[ignore = "real blades, see the file's head"]
fn corpus_table_case7288() {
    let folder = blades();
    let table = folder.join("tblade3_case7288/blade3d.Case7-28-8.dat");
    // How far the published forms themselves are apart: the table's points from the published
    // faces.
    let step = read(&folder.join("tblade3_case7288/case7288_rotor_blade.step"), None);
    let text = std::fs::read_to_string(&table).expect("the table");
    let row =
        |l: &str| <[f64; 3]>::try_from(l.split_whitespace().filter_map(|w| w.parse().ok()).collect::<Vec<f64>>()).ok();
    let to_step = step.model_from_blade.inverse();
    let apart = text.lines().filter_map(row).map(|p| {
        step.part.closest(&(to_step * Point::from(p)), f64::INFINITY).map_or(f64::INFINITY, |c| c.distance_mm)
    });
    let apart: Vec<f64> = apart.collect();
    let greatest = apart.iter().copied().fold(0.0, f64::max);
    eprintln!(
        "{} points, mean {:.4}, greatest {greatest:.4} mm from the published STEP",
        apart.len(),
        apart.iter().sum::<f64>() / apart.len() as f64
    );
    agrees(&table, None, "tblade3_case7288/case7288_rotor_blade.step", |p| p, [0.1, 0.005]);
}

/// Tables are planned like any model; they have no platform, so the region is given.
#[test]
#[ignore = "real blades, see the file's head"]
fn corpus_plan_of_tables() {
    let (_dir, path) = header(ROTOR37);
    let options = set(&["region.start_mm=215", "region.end_mm=205", "tool.radius_mm=3"]);
    plans(&path.to_string_lossy(), 0.03, &options);
    let case = "tblade3_case7288/blade3d.Case7-28-8.dat";
    plans(case, 0.03, &set(&["region.start_mm=100", "region.end_mm=80", "schedule.kind=piecewise"]));
}

/// A profile in a plane is no blade, and the message says what to do.
#[test]
#[ignore = "real blades, see the file's head"]
fn corpus_table_of_one_profile() {
    let folder = blades();
    let e = model::load(&folder.join("LS89_profile_2d.txt"), &ModelOptions::default(), &Silent).err().expect("refused");
    assert!(["single profile", "two sections or more", "extrude"].iter().all(|w| e.to_string().contains(w)), "{e}");
    let text = "[sections]\nfiles = \"FOLDER/LS89_profile_2d.txt\"\nunit = \"m\"\n\
                columns = [\"skip\", \"z\", \"x\", \"y\"]\nextrude = 0.1\n";
    let (_dir, path) = header(text);
    assert!(read(&path, None).diagnosis.closed);
}

/// Two tools hold blades between them: the table stands still, the binding side is as high as asked
/// for, and it takes half the time of one tool.
/// `pinch.json` of rows by two balls of a radius for a scallop, mm, with all checks passed.
fn pinched(file: &str, [radius_mm, scallop_mm]: [f64; 2], edges: &str) -> serde_json::Value {
    let dir = tempfile::tempdir().expect("a folder");
    let machine = concat!(env!("CARGO_MANIFEST_DIR"), "/models/machines/pinch_9x.toml");
    let keys = [
        format!("machine.file={machine:?}"),
        format!("tool.radius_mm={radius_mm}"),
        format!("path.scallop_mm={scallop_mm}"),
        format!("pinch.edges={edges:?}"),
    ];
    let mut command = Command::new(env!("CARGO_BIN_EXE_bladewright"));
    command.args(["--quiet", "pinch"]).arg(blades().join(file)).arg("-o").arg(dir.path());
    keys.iter().for_each(|key| {
        command.args(["--set", key]);
    });
    let out = command.output().expect("it runs");
    assert!(out.status.success(), "{file}: {}", String::from_utf8_lossy(&out.stdout));
    let text = std::fs::read(dir.path().join("pinch.json")).expect("figures");
    serde_json::from_slice(&text).expect("JSON")
}

/// Rows round both edges join those of opposite places without a ridge over the scallop.
#[test]
#[ignore = "real blades, see the file's head"]
fn corpus_two_tools_go_round_edges() {
    let coarser = if is_short() { 3.0 } else { 1.0 };
    for (file, radius_mm, scallop_mm, least_share) in [
        ("turbine_blade_firtree.igs", 6.0, 0.05, 0.9),
        ("tblade3_case7288/case7288_rotor_hubwedge.step", 4.0, 0.05, 0.6),
        ("rotor37/rotor37_DERIVED_loft_mm.step", 4.0, 0.05, 0.6),
    ] {
        let scallop_mm = coarser * scallop_mm;
        let f = pinched(file, [radius_mm, scallop_mm], "both");
        let number = |at: &str| f.pointer(at).and_then(serde_json::Value::as_f64).expect("a number");
        assert!(number("/edge_rows") >= 2.0 && number("/closed") >= least_share, "{file}: {}", f["closed"]);
        let border = number("/measured/border_ridges_mm/3") / scallop_mm;
        assert!(border > 0.0 && border <= 1.03, "{file}: {border}");
        assert!(number("/measured/line_distance_mm/1") <= 0.05, "{file}");
        let alone = number("/program/alone_s/0") + number("/program/alone_s/1");
        assert!(number("/program/cutting_s") <= 0.56 * alone, "{file}");
    }
}

#[test]
#[ignore = "real blades, see the file's head"]
fn corpus_two_tools_hold_blades() {
    let coarser = if is_short() { 3.0 } else { 1.0 };
    for (file, radius_mm, scallop_mm, least_share) in [
        ("turbine_blade_firtree.igs", 6.0, 0.05, 0.75),
        ("rotor37/rotor37_DERIVED_loft_mm.step", 4.0, 0.05, 0.65),
        ("tblade3_case7288/case7288_rotor_hubwedge.step", 4.0, 0.05, 0.6),
        // At an end of a row the second ball would rest on the hub.
        ("tblade3_case7288/case7288_rotor_hubwedge.step", 4.0, 0.01, 0.6),
        ("fan_sections/fan_DERIVED_loft.step", 1.0, 0.05, 0.45),
    ] {
        let scallop_mm = coarser * scallop_mm;
        let f = pinched(file, [radius_mm, scallop_mm], "none");
        let number = |at: &str| f.pointer(at).and_then(serde_json::Value::as_f64).expect("a number");
        assert_eq!(f["still_rows"], f["rows"], "{file}");
        let share = number("/covered/0") + number("/covered/1");
        assert!(share >= least_share, "{file}: {share}");
        assert!(number("/measured/line_distance_mm/1") <= 0.05, "{file}");
        let greatest = |k: usize| (0..2).map(|j| number(&format!("/measured/ridges_mm/{j}/{k}"))).fold(0.0, f64::max);
        assert!((0.93..1.03).contains(&(greatest(2) / scallop_mm)) && greatest(4) < 1.5 * scallop_mm, "{file}");
        let binding = |k: usize| number(&format!("/measured/binding_ridges_mm/{k}")) / scallop_mm;
        assert!(binding(0) >= 0.93 && binding(3) <= 1.03, "{file}: {} {}", binding(0), binding(3));
        let alone = number("/program/alone_s/0") + number("/program/alone_s/1");
        assert!(number("/program/cutting_s") <= 0.56 * alone, "{file}");
    }
}
