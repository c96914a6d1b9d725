//! Leading and trailing edge and the two sides keep their names along the whole airfoil: on our own
//! twisted blade, and on the real blades of the folder that `BLADEWRIGHT_BLADES` names (see
//! `corpus.rs`).

use std::path::{Path, PathBuf};

use bladewright::artifact::blade::{Blade, Unit};
use bladewright::artifact::section::{Section, Side};
use bladewright::observe::Silent;
use bladewright::read::model::{self, ModelOptions};
use bladewright::section::{self, SectionOptions};

/// Blades none of whose sections closes: there is nothing to name.
const OPEN: [&str; 1] = ["kaplan_blade_DERIVED_from_brep.step"];

/// Blades with a long round root, which are planned where their axis is given: z of the model.
const ROUND_ROOT: [&str; 2] = ["iea15mw/IEA-15-240-RWT_blade.stl", "iea15mw/IEA_15MW_CFD.stp"];

/// Heights at which a blade is cut; chords turn by few degrees from one to the next.
const HEIGHTS: u32 = 120;

fn load(file: &Path, unit: Option<Unit>) -> Blade {
    let axis = ROUND_ROOT.iter().any(|name| file.ends_with(name)).then_some([0.0, 0.0, 1.0]);
    model::load(file, &ModelOptions { unit, axis, ..ModelOptions::default() }, &Silent).expect("a blade")
}

fn sections(blade: &Blade, options: SectionOptions) -> Vec<Section> {
    section::plan(blade, &options, &Silent).expect("sections")
}

/// Leading and trailing edge of a section's first loop, and the side between them.
fn names(section: &Section) -> ([[f64; 2]; 2], Side) {
    let l = &section.loops[0];
    let at = |s_mm: f64| l.points_mm[l.s_mm.partition_point(|s| *s < s_mm).min(l.points_mm.len() - 1)];
    ([at(l.leading_edge_s_mm), at(l.trailing_edge_s_mm)], l.side_after_leading_edge)
}

/// Heights below which an edge of the next section lies where the other edge was, or the side is
/// another.
fn jumps(sections: &[Section]) -> Vec<f64> {
    let away = |a: [f64; 2], b: [f64; 2]| (a[0] - b[0]).hypot(a[1] - b[1]);
    let jumps = sections.windows(2).filter(|w| {
        let (([a, b], side), ([c, d], next)) = (names(&w[0]), names(&w[1]));
        away(a, d) + away(b, c) < away(a, c) + away(b, d) || side != next
    });
    jumps.map(|w| w[1].x_mm).collect()
}

fn all_along(blade: &Blade) -> Vec<Section> {
    sections(blade, SectionOptions::default().with(|s| s.count = HEIGHTS))
}

#[test]
fn edges_keep_their_names_and_one_height_alone_has_the_same() {
    // Its edges are nearly alike about the middle of its height, where each section alone finds
    // another the blunter.
    let blade = load(&Path::new(env!("CARGO_MANIFEST_DIR")).join("models/compressor_twist.step"), None);
    let all = all_along(&blade);
    assert_eq!((all.len(), jumps(&all)), (HEIGHTS as usize, vec![]));
    for whole in all.iter().step_by(7) {
        let heights_mm = vec![whole.x_mm];
        assert_eq!(sections(&blade, SectionOptions { heights_mm, ..SectionOptions::default() })[0], *whole);
    }
}

#[test]
fn the_mirror_image_has_its_sides_mirrored() {
    let blade = load(&Path::new(env!("CARGO_MANIFEST_DIR")).join("models/compressor_twist.step"), None);
    let regions = blade.regions.mirrored();
    let mirrored = Blade { part: blade.part.mirrored(&Silent).expect("an image"), regions, ..blade.clone() };
    for (one, other) in all_along(&blade).iter().zip(all_along(&mirrored)).step_by(9) {
        let ((ends, side), (image, turned)) = (names(one), names(&other));
        for (a, b) in ends.iter().zip(image) {
            assert!((a[0] - b[0]).hypot(a[1] + b[1]) < 0.2, "{a:?} {b:?} at {}", one.x_mm);
        }
        assert_ne!(side, turned);
    }
}

#[test]
#[ignore = "real blades, see corpus.rs"]
fn corpus_edges_keep_their_names() {
    let folder = std::env::var_os("BLADEWRIGHT_BLADES").map(PathBuf::from);
    let folder = folder.expect("BLADEWRIGHT_BLADES names the folder of real blades");
    let (as_is, metres, millimetres) = (None, Some(Unit::M), Some(Unit::Mm));
    let blades = [
        ("turbine_blade_firtree.igs", as_is),
        ("tblade3_case7288/case7288_rotor_hubwedge.step", as_is),
        ("tblade3_case7288/case7288_rotor_hubwedge.iges", as_is),
        ("tblade3_case7288/case7288_rotor_blade.step", as_is),
        ("tblade3_case7288/blade3d.Case7-28-8.dat", as_is),
        ("turbine_blade_scan.stl", metres),
        ("turbocharger_turbine_sector.stl", as_is),
        ("rotor37/rotor37_DERIVED_loft_mm.step", as_is),
        ("rotor37/profile_R37.dat", as_is),
        ("hecc_impeller_main/hecc_main_DERIVED_loft_mm.step", as_is),
        ("fan_sections/fan_DERIVED_loft.step", as_is),
        ("fan_sections/ori-sections.dat", as_is),
        ("dtmb_p4119/p4119_DERIVED_loft_mm.step", as_is),
        ("turbodesigner_family/stage1_rotor.step", as_is),
        ("turbodesigner_family/stage2_rotor.step", as_is),
        ("turbodesigner_family/stage4_rotor.step", as_is),
        ("kaplan_blade_DERIVED_from_brep.step", as_is),
        ("je1_propeller_blade_ascii.stl", metres),
        ("pyturbo_blade.stl", metres),
        ("vki_blade_metres_open_shell.step", metres),
        ("airfoil_22dx_single_surface.igs", as_is),
        ("openfoam_propeller.obj", metres),
        (ROUND_ROOT[0], millimetres),
        (ROUND_ROOT[1], millimetres),
    ];
    let (mut wrong, mut drawn) = (Vec::new(), Vec::new());
    for (file, unit) in blades {
        let blade = load(&folder.join(file), unit);
        let planned = section::plan(&blade, &SectionOptions::default().with(|s| s.count = HEIGHTS), &Silent);
        assert_eq!(planned.is_err(), OPEN.contains(&file), "{file}: {:?}", planned.err().map(|e| e.message));
        let Ok(all) = planned else { continue };
        let found = jumps(&all);
        drawn.push(picture(file, &all, drawn.len()));
        eprintln!("{file}: {} sections, {} jumps", all.len(), found.len());
        if !found.is_empty() {
            wrong.push(format!("{file}: at {found:.2?} mm"));
        }
    }
    if let Some(sheet) = std::env::var_os("BLADEWRIGHT_EDGES_SHEET").map(PathBuf::from) {
        let sheet = Path::new(env!("CARGO_MANIFEST_DIR")).join(sheet);
        std::fs::create_dir_all(sheet.parent().expect("a folder")).expect("the folder");
        let height = drawn.len().div_ceil(COLUMNS) as f64 * CELL;
        let width = COLUMNS as f64 * CELL;
        let head = format!("<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 {width} {height}'>");
        let style = "<rect width='100%' height='100%' fill='white'/><g font-family='sans-serif' font-size='11'>";
        std::fs::write(sheet, format!("{head}{style}{}</g></svg>\n", drawn.concat())).expect("the sheet");
    }
    assert!(wrong.is_empty(), "names jump: {wrong:#?}");
}

/// Cells of the sheet of pictures in a row, and their size in pixels.
const COLUMNS: usize = 6;
const CELL: f64 = 240.0;

/// Every sixth section of a blade with its leading edge in red and its trailing edge in blue, in
/// the cell of this number.
fn picture(file: &str, sections: &[Section], cell: usize) -> String {
    let drawn: Vec<&Section> = sections.iter().step_by(6).collect();
    let points = || drawn.iter().flat_map(|s| &s.loops[0].points_mm);
    let span = |k: usize| {
        points().fold([f64::INFINITY, f64::NEG_INFINITY], |[lo, hi], p| [f64::min(lo, p[k]), f64::max(hi, p[k])])
    };
    let ([y_lo, y_hi], [z_lo, z_hi]) = (span(0), span(1));
    let scale = (CELL - 30.0) / (y_hi - y_lo).max(z_hi - z_lo);
    let corner = [(cell % COLUMNS) as f64 * CELL + 10.0, (cell / COLUMNS) as f64 * CELL + 20.0];
    let at = |p: [f64; 2]| [corner[0] + (p[0] - y_lo) * scale, corner[1] + (z_hi - p[1]) * scale];
    let mut out = format!("<text x='{}' y='{}'>{file}</text>", corner[0], corner[1] - 6.0);
    for s in &drawn {
        let line: Vec<String> =
            s.loops[0].points_mm.iter().map(|p| at(*p)).map(|[x, y]| format!("{x:.1},{y:.1}")).collect();
        out += &format!("<polygon points='{}' fill='none' stroke='#999' stroke-width='.6'/>", line.join(" "));
    }
    for s in &drawn {
        for (edge, colour) in names(s).0.into_iter().zip(["#d00", "#06c"]) {
            let [x, y] = at(edge);
            out += &format!("<circle cx='{x:.1}' cy='{y:.1}' r='2.2' fill='{colour}'/>");
        }
    }
    out
}
