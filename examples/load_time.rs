//! What loading a STEP or IGES model takes: `cargo run --release --example load_time -- MODEL ROUNDS`.
//!
//! Prints processor seconds a round, whatever the number of threads: `read queries whole`. `read`: to exact faces with their trimming
//! curves, sewn. `queries`: that, mesh, index of the exact faces, one closest point. `whole`: that and all that a plan needs besides (which
//! way faces look, blade axis, regions).
use std::io::Write;
use std::path::Path;

use bladewright::geometry::Point;
use bladewright::geometry::brep::Brep;
use bladewright::geometry::part::Part;
use bladewright::model::format::{Format, detect};
use bladewright::model::{self, ModelOptions, iges, sew, step};
use bladewright::observe::Silent;

/// The loops of the index follow the edges as closely as in loading, mm: with coarse chords its pieces beside edges become many.
const DEFLECTION_MM: f64 = 0.01;
/// Sewing distances, mm, as in loading.
const SEW_MM: [f64; 2] = [0.005, 0.02];

fn read(path: &Path) -> Result<Brep, String> {
    let bytes = std::fs::read(path).map_err(|e| e.to_string())?;
    let shape = match detect(path, &bytes).map_err(|e| e.to_string())? {
        Format::Iges => iges::read(path, &bytes, None),
        Format::Step => step::read(path, &bytes, None),
        _ => return Err("neither STEP nor IGES".into()),
    };
    let mut brep = shape.map_err(|e| e.to_string())?.brep;
    sew::sew(&mut brep, &SEW_MM);
    Ok(brep)
}

fn queries(path: &Path) -> Result<f64, String> {
    let part = Part::from_brep(read(path)?, DEFLECTION_MM, &Silent).map_err(|e| e.to_string())?;
    Ok(part.closest(&Point::new(1.0, 2.0, 3.0), f64::INFINITY).map_or(0.0, |c| c.distance_mm))
}

fn whole(path: &Path) -> Result<f64, String> {
    let blade = model::load(path, &ModelOptions::default(), &Silent).map_err(|e| e.to_string())?;
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
    let path = Path::new(&path);
    let faces = timed(rounds, || read(path).map(|b| b.faces.len() as f64))?;
    let ready = timed(rounds, || queries(path))?;
    let all = timed(rounds, || whole(path)).map_or_else(|_| "-".to_owned(), |s| format!("{s:.4}"));
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
