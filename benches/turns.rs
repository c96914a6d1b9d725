//! Turns of constant scallop and at constant height, side by side in one run.
//!
//! `cargo bench --bench turns [-- model.step ... --radius=3 --scallop=0.01 --axis=0,0,1 --unit-m
//! --end=12]`; without models the project's. For each path are printed: turns, locations, length,
//! turn of the path within the surface over its length (roughness), seconds, and the ridges and
//! the length that [`verify::limit`] measures on the part, over scallop and limit.
use std::io::Write;
use std::path::{Path, PathBuf};
use std::time::Instant;

use bladewright::artifact::blade::{Blade, Unit};
use bladewright::artifact::region::Extent;
use bladewright::artifact::toolpath::{PathKind, Toolpath};
use bladewright::error::Result;
use bladewright::observe::Silent;
use bladewright::path::{self, PathOptions};
use bladewright::read::model::{self, ModelOptions};
use bladewright::verify;

/// Models of the project, with a usual ball, mm.
const MODELS: [(&str, f64); 3] =
    [("turbine_camber.step", 3.0), ("compressor_twist.step", 2.0), ("steam_root.step", 4.0)];
/// Chord tolerance over the scallop, at most.
const CHORD: f64 = 0.04;
/// Places at which ridges are measured.
const SAMPLES: usize = 4000;

/// Turn of the path within the surface, rad/mm.
fn roughness(path: &Toolpath) -> f64 {
    let turn = |w: &[bladewright::artifact::toolpath::CutterLocation]| {
        let (a, b) = (w[1].centre - w[0].centre, w[2].centre - w[1].centre);
        a.cross(&b).dot(&w[1].normal).atan2(a.dot(&b)).abs()
    };
    let length_mm = path.locations.last().map_or(0.0, |l| l.s_mm);
    path.locations.windows(3).map(turn).sum::<f64>() / length_mm.max(1e-9)
}

fn row(name: &str, blade: &Blade, path: &Result<Toolpath>, seconds: f64) -> String {
    let path = match path {
        Ok(path) => path,
        Err(e) => return format!("  {name}: {}\n", e.message),
    };
    let h = path.scallop_mm;
    let length_mm = path.locations.last().map_or(0.0, |l| l.s_mm);
    let mut out = format!(
        "  {name}: {} turns, {} locations, {length_mm:.0} mm, {:.3} rad/mm, {seconds:.2} s",
        path.turns.len(),
        path.locations.len(),
        roughness(path),
    );
    match verify::limit(blade, path, h, SAMPLES) {
        Ok(l) => {
            let [p05, p95, p99, max] = [l.ridge_p05_mm, l.ridge_p95_mm, l.ridge_p99_mm, l.ridge_max_mm].map(|r| r / h);
            out += &format!("; ridges p05 {p05:.3}, p95 {p95:.3}, p99 {p99:.3}, max {max:.3}; length {:.4}\n", l.ratio);
        }
        Err(e) => out += &format!("; {}\n", e.message),
    }
    out
}

fn main() {
    let args: Vec<String> = std::env::args().skip(1).collect();
    let value = |key: &str| args.iter().find_map(|a| a.strip_prefix(key));
    let number = |key: &str| value(key).and_then(|v| v.parse::<f64>().ok());
    let axis = value("--axis=").map(|v| v.split(',').filter_map(|x| x.parse().ok()).collect::<Vec<f64>>());
    let unit = args.iter().any(|a| a == "--unit-m").then_some(Unit::M);
    let how = ModelOptions { axis: axis.and_then(|a| <[f64; 3]>::try_from(a).ok()), unit, ..ModelOptions::default() };
    let named: Vec<&String> = args.iter().filter(|a| !a.starts_with("--")).collect();
    let models: Vec<(PathBuf, f64)> = if named.is_empty() {
        MODELS.iter().map(|(m, r)| (Path::new(env!("CARGO_MANIFEST_DIR")).join("models").join(m), *r)).collect()
    } else {
        named.iter().map(|m| (PathBuf::from(m), 3.0)).collect()
    };
    for (file, usual_mm) in models {
        let radius_mm = number("--radius=").unwrap_or(usual_mm);
        let mut out = format!("{}, ball {radius_mm} mm\n", file.display());
        match model::load(&file, &how, &Silent) {
            Ok(blade) => {
                let scallops = number("--scallop=").map_or_else(|| vec![0.01, 0.02, 0.05], |h| vec![h]);
                for scallop_mm in scallops {
                    out += &format!(" scallop {scallop_mm} mm\n");
                    for (name, kind) in [("scallop", PathKind::ConstantScallop), ("height", PathKind::ConstantHeight)] {
                        let mut options = PathOptions::new(radius_mm, scallop_mm).with(|s| {
                            s.kind = kind;
                            // As jobs have it: coarser chords leave lower ridges in the table.
                            s.chord_mm = s.chord_mm.min(CHORD * scallop_mm);
                        });
                        options.extent = Extent::heights(number("--start="), number("--end="));
                        let start = Instant::now();
                        let path = path::plan(&blade, &options, &Silent);
                        out += &row(name, &blade, &path, start.elapsed().as_secs_f64());
                    }
                }
            }
            Err(e) => out += &format!("  {}\n", e.message),
        }
        let _ = std::io::stdout().write_all(out.as_bytes());
    }
}
