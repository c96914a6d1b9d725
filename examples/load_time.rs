//! What loading a STEP, IGES, STL or OBJ model takes:
//! `cargo run --release --example load_time -- MODEL ROUNDS [m]`, the last for one that is in
//! metres whatever it says.
//!
//! Prints processor seconds a round, whatever the number of threads: `read queries whole`. `read`:
//! to exact faces with their trimming curves, sewn; of a mesh to triangles that share their
//! corners. `queries`: that, mesh, index of the exact faces, one closest point; of a mesh its
//! healing and the tree over it. `whole`: that and all that a plan needs besides (which way faces
//! look, blade axis, regions).
use std::io::Write;
use std::path::Path;

use bladewright::artifact::blade::Unit;
use bladewright::geometry::Point;
use bladewright::geometry::brep::Brep;
use bladewright::geometry::part::Part;
use bladewright::observe::Silent;
use bladewright::read::model::format::{Format, detect};
use bladewright::read::model::heal::HealOptions;
use bladewright::read::model::soup::Soup;
use bladewright::read::model::{self, ModelOptions, iges, obj, sew, step, stl};

/// The loops of the index follow the edges as closely as in loading, mm: with coarse chords its
/// pieces beside edges become many.
const DEFLECTION_MM: f64 = 0.01;
/// Sewing distances, mm, as in loading.
const SEW_MM: [f64; 2] = [0.005, 0.02];

/// A model as its reader gives it.
enum Read {
    Faces(Brep),
    Triangles(Soup),
}

fn read(path: &Path, unit: Option<Unit>) -> Result<Read, String> {
    let bytes = std::fs::read(path).map_err(|e| e.to_string())?;
    let faces = match detect(path, &bytes).map_err(|e| e.to_string())? {
        Format::Iges => iges::read(path, &bytes, unit),
        Format::Step => step::read(path, &bytes, unit),
        Format::StlAscii => return triangles(stl::read_ascii(path, &bytes)),
        Format::StlBinary => return triangles(stl::read_binary(path, &bytes)),
        Format::Obj => return triangles(obj::read(path, &bytes)),
        _ => return Err("neither STEP nor IGES, STL or OBJ".into()),
    };
    let mut brep = faces.map_err(|e| e.to_string())?.brep;
    sew::sew(&mut brep, &SEW_MM);
    Ok(Read::Faces(brep))
}

fn triangles(soup: bladewright::error::Result<Soup>) -> Result<Read, String> {
    Ok(Read::Triangles(soup.map_err(|e| e.to_string())?))
}

/// Faces, or triangles that share their corners, that were read.
fn count(path: &Path, unit: Option<Unit>) -> Result<f64, String> {
    Ok(match read(path, unit)? {
        Read::Faces(brep) => brep.faces.len() as f64,
        Read::Triangles(soup) => soup.welded(1.0).0.triangles.len() as f64,
    })
}

fn queries(path: &Path, unit: Option<Unit>) -> Result<f64, String> {
    let part = match read(path, unit)? {
        Read::Faces(brep) => Part::from_brep(brep, DEFLECTION_MM, &Silent).map_err(|e| e.to_string())?,
        Read::Triangles(soup) => {
            Part::from_mesh(soup.heal(path, 1.0, &HealOptions::default()).map_err(|e| e.to_string())?.mesh)
        }
    };
    Ok(part.closest(&Point::new(1.0, 2.0, 3.0), f64::INFINITY).map_or(0.0, |c| c.distance_mm))
}

fn whole(path: &Path, unit: Option<Unit>) -> Result<f64, String> {
    let blade =
        model::load(path, &ModelOptions { unit, ..ModelOptions::default() }, &Silent).map_err(|e| e.to_string())?;
    Ok(blade.part.closest(&Point::new(1.0, 2.0, 3.0), f64::INFINITY).map_or(0.0, |c| c.distance_mm))
}

/// Processor time of this process so far, s: user and system time, in hundredths.
fn spent() -> f64 {
    let stat = std::fs::read_to_string("/proc/self/stat").unwrap_or_default();
    let fields: Vec<&str> = stat.rsplit(')').next().unwrap_or_default().split_whitespace().collect();
    let ticks = |k: usize| fields.get(k).and_then(|f| f.parse::<f64>().ok()).unwrap_or(0.0);
    0.01 * (ticks(11) + ticks(12))
}

fn timed(rounds: u32, work: impl Fn() -> Result<f64, String>) -> Result<f64, String> {
    let from = spent();
    for _ in 0..rounds {
        work()?;
    }
    Ok((spent() - from) / f64::from(rounds))
}

fn run() -> Result<String, String> {
    let mut args = std::env::args().skip(1);
    let path = args.next().ok_or("which model? give its path")?;
    let rounds = args.next().and_then(|r| r.parse().ok()).unwrap_or(10);
    let unit = args.next().filter(|u| u == "m").map(|_| Unit::M);
    let path = Path::new(&path);
    let faces = timed(rounds, || count(path, unit))?;
    let ready = timed(rounds, || queries(path, unit))?;
    let all = timed(rounds, || whole(path, unit)).map_or_else(|_| "-".to_owned(), |s| format!("{s:.4}"));
    Ok(format!("{faces:.4} {ready:.4} {all}\n"))
}

fn main() -> std::process::ExitCode {
    match run() {
        Ok(line) => {
            let _ = std::io::stdout().write_all(line.as_bytes());
            std::process::ExitCode::SUCCESS
        }
        Err(e) => {
            let _ = writeln!(std::io::stderr(), "{e}");
            std::process::ExitCode::FAILURE
        }
    }
}
