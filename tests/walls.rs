//! The channel is tight: a tool that stands on its walls touches nothing, and one that stands a
//! fifth of a degree outside them touches the face that the channel names with the part of the tool
//! that it names.
//!
//! Clearances are 0 and ends are those of the exact faces, so that a wall is where the tool first
//! touches. Schedules of the kinds `lower-wall` and `upper-wall` run along the channel; what the
//! tool touches is asked of `verify`, which shares no code with the channel, on a mesh much finer
//! than the one that the channel was planned on. Walls that the contact angle or an axis gives
//! touch nothing when they are passed, and are only looked at from inside; so are those that the
//! part gives only on the way to the next place. Minutes of work, and so not among the daily tests:
//! `just walls`. The folder that `BLADEWRIGHT_BLADES` names adds real blades: the tests
//! `real_walls_…`.

use std::f64::consts::TAU;
use std::path::{Path, PathBuf};

use bladewright::artifact::channel::Binding;
use bladewright::artifact::schedule::ScheduleKind;
use bladewright::artifact::{Schedule, Stand};
use bladewright::channel::{self, FreeInterval};
use bladewright::geometry::mesh::Mesh;
use bladewright::geometry::part::Part;
use bladewright::geometry::tessellate::{TessellateOptions, tessellate};
use bladewright::job::{JobFile, resolve};
use bladewright::observe::Silent;
use bladewright::path;
use bladewright::run::Loaded;
use bladewright::schedule::{self, ScheduleOptions};
use bladewright::verify;

/// How far outside the walls, degrees.
const BEYOND_DEG: f64 = 0.2;
/// Places on the path of a blade, about.
const PLACES: usize = 300;
/// What lies off the faces in the mesh that is asked, for each mm of the ball's radius: a tenth of
/// the way of a point at that distance over the angle that the tool is turned by.
const FINE: f64 = 3.5e-4;

/// The part once more, as a mesh alone: the exact faces to within what is asked, or the mesh that
/// it is.
fn finely(part: &Part, off_mm: f64) -> (Part, f64) {
    let Some(brep) = &part.brep else { return (Part::from_mesh(part.mesh.clone()), 0.0) };
    let t = tessellate(brep, &TessellateOptions::with_deflection(off_mm), &Silent)
        .expect("faces that were tessellated before");
    (Part::from_mesh(t.mesh), t.deflection_mm)
}

/// Each face of a mesh as a part of its own.
fn by_face(whole: &Mesh) -> Vec<Option<Part>> {
    let count = (0..whole.triangles.len()).map(|t| whole.face(t) + 1).max().unwrap_or(0);
    let mut meshes = vec![Mesh::default(); count as usize];
    for t in 0..whole.triangles.len() {
        let mesh = &mut meshes[whole.face(t) as usize];
        let first = mesh.points.len() as u32;
        mesh.points.extend(whole.corners(t));
        mesh.triangles.push([first, first + 1, first + 2]);
    }
    meshes.into_iter().map(|m| (!m.triangles.is_empty()).then(|| Part::from_mesh(m))).collect()
}

/// Where one of the schedules was looked at.
#[derive(Default)]
struct Looked {
    places: usize,
    /// Least distance of the tool from the part on the wall, mm.
    least_mm: f64,
    /// Places where the part gives the wall.
    named: usize,
    /// Those of them where the tool touches what is named once it stands outside.
    touched: usize,
    /// The others: which, and by how much it is still away, mm.
    missed: Vec<(usize, f64)>,
}

/// Plans the walls of a blade's channel and stands on them, and outside them.
fn walls_are_where_the_tool_touches(model: &Path, settings: &[&str]) {
    let mut job = JobFile::from_model(model);
    let zero = ["channel.clearance_mm=0", "channel.holder_clearance_mm=0", "channel.exact_ends=true"];
    for setting in ["path.scallop_mm=0.1"].iter().chain(&zero).chain(settings) {
        job.set(setting).expect("a setting");
    }
    let draft = resolve(job, Path::new(".")).expect("a job");
    let Loaded { setup, .. } = Loaded::read(&draft, &Silent).unwrap_or_else(|e| panic!("{}: {e}", model.display()));
    let toolpath = path::plan(&setup.blade, &setup.path_options(), &Silent).expect("a path");
    let around = setup.surroundings().expect("an index");
    let options = setup.channel_options();
    let tool = &setup.job.tool;
    let channel = channel::plan_among(&around, tool, &toolpath, &options, &Silent)
        .unwrap_or_else(|e| panic!("{}: {e}", model.display()));
    let own = channel::intervals(&around, tool, &toolpath, &options, &Silent).expect("free intervals");
    let (fine, off_mm) = finely(&setup.blade.part, FINE * tool.radius_mm);
    let faces = by_face(&fine.mesh);
    let resolution_mm = 0.1 * FINE * tool.radius_mm;
    // Faces that lie off their common edges are joined there by the mesh, whatever is asked: no
    // more can be told than by how much.
    let untold_mm = if off_mm > 2.0 * FINE * tool.radius_mm { off_mm } else { 0.0 };
    let segments = tool.segments();
    for kind in [ScheduleKind::LowerWall, ScheduleKind::UpperWall] {
        let along = |beyond_wall_deg: f64| -> Schedule {
            let options = ScheduleOptions::default().with(|s| s.beyond_wall_deg = beyond_wall_deg);
            schedule::plan(kind, &toolpath, &channel, &options, &Silent).expect("a schedule along a wall")
        };
        let (on, outside) = (along(0.0), along(BEYOND_DEG));
        let mut looked = Looked { least_mm: f64::INFINITY, ..Looked::default() };
        for row in (0..toolpath.locations.len()).step_by(toolpath.locations.len().div_ceil(PLACES)) {
            let (centre, cone) = (toolpath.locations[row].centre, toolpath.cone(row));
            looked.places += 1;
            let stands = |part: &Part, segments: &[_], theta: f64| {
                verify::standing(part, segments, &Stand { centre, cone, theta }, resolution_mm)
                    .map_or(f64::INFINITY, |s| s.distance_mm)
            };
            looked.least_mm = looked.least_mm.min(stands(&fine, &segments, on.theta[row]));
            let wall = &channel.rows[row];
            let holds_the_channel = |f: &&FreeInterval| {
                let turn = 0.5 * (wall.theta_min + wall.theta_max - f.theta_min - f.theta_max);
                (turn - (turn / TAU).round() * TAU).abs() < 0.5 * (f.theta_max - f.theta_min)
            };
            let here = own[row].iter().find(holds_the_channel).expect("a free interval round the channel");
            let by = match kind {
                ScheduleKind::LowerWall => [&wall.binds_min, &here.binds_min],
                _ => [&wall.binds_max, &here.binds_max],
            };
            let [Binding::Part { tool, face, .. }, Binding::Part { .. }] = by else { continue };
            looked.named += 1;
            let named: Vec<_> = segments.iter().filter(|s| s.part == *tool).cloned().collect();
            let away = faces[*face as usize].as_ref().map_or(f64::INFINITY, |f| stands(f, &named, outside.theta[row]));
            if away < untold_mm {
                looked.touched += 1;
            } else {
                looked.missed.push((row, away));
            }
        }
        eprintln!(
            "{} {kind:?}: {} places, nearest {:.5} mm (mesh within {off_mm:.5}); {} walls given by the part, {} touched outside, not: {:?}",
            setup.blade.name, looked.places, looked.least_mm, looked.named, looked.touched, looked.missed
        );
        assert!(looked.least_mm >= -off_mm - resolution_mm, "on the wall: {} mm", looked.least_mm);
        assert!(4 * looked.named > looked.places, "the part gives only {} of {} walls", looked.named, looked.places);
        assert!(looked.missed.is_empty(), "not touched: {:?}", looked.missed);
    }
}

fn of_the_project(file: &str) {
    walls_are_where_the_tool_touches(&Path::new(env!("CARGO_MANIFEST_DIR")).join("models").join(file), &[]);
}

fn of_the_corpus(file: &str, settings: &[&str]) {
    let folder = std::env::var_os("BLADEWRIGHT_BLADES").map(PathBuf::from);
    let folder = folder.expect("BLADEWRIGHT_BLADES names the folder of real blades");
    walls_are_where_the_tool_touches(&folder.join(file), settings);
}

#[test]
#[ignore = "minutes, see the file's head"]
fn walls_of_steam_root() {
    of_the_project("steam_root.step");
}

#[test]
#[ignore = "minutes, see the file's head"]
fn walls_of_compressor_twist() {
    of_the_project("compressor_twist.step");
}

#[test]
#[ignore = "minutes, see the file's head"]
fn walls_of_turbine_camber() {
    of_the_project("turbine_camber.step");
}

#[test]
#[ignore = "minutes, see the file's head"]
fn walls_of_prism() {
    of_the_project("prism.step");
}

#[test]
#[ignore = "minutes, see the file's head"]
fn real_walls_of_case7288() {
    of_the_corpus("tblade3_case7288/case7288_rotor_hubwedge.step", &["region.end_mm=73"]);
    of_the_corpus("tblade3_case7288/case7288_rotor_blade.step", &[]);
}

#[test]
#[ignore = "minutes, see the file's head"]
fn real_walls_of_rotor37_and_fan() {
    of_the_corpus("rotor37/rotor37_DERIVED_loft_mm.step", &["tool.radius_mm=3"]);
    of_the_corpus("fan_sections/fan_DERIVED_loft.step", &[]);
}

#[test]
#[ignore = "minutes, see the file's head"]
fn real_walls_of_a_family() {
    for stage in ["stage1", "stage2", "stage4"] {
        of_the_corpus(&format!("turbodesigner_family/{stage}_rotor.step"), &["region.end_mm=1.5"]);
    }
}

#[test]
#[ignore = "minutes, see the file's head"]
fn real_walls_of_p4119() {
    of_the_corpus("dtmb_p4119/p4119_DERIVED_loft_mm.step", &[]);
}

#[test]
#[ignore = "minutes, see the file's head"]
fn real_walls_of_a_fir_tree_blade() {
    let region = ["tool.radius_mm=1.4", "region.start_mm=40", "region.end_mm=21"];
    of_the_corpus("turbine_blade_firtree.igs", &region);
}

#[test]
#[ignore = "minutes, see the file's head"]
fn real_walls_of_what_is_measured_in_metres() {
    of_the_corpus("vki_blade_metres_open_shell.step", &["model.unit=m"]);
    of_the_corpus("turbine_blade_scan.stl", &["model.unit=m"]);
}
