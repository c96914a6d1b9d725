//! The closest point of a model to each point of a list, in the model's own frame.
//!
//! `cargo run --release --example closest_points -- blade.step < points.txt`: one point a line,
//! `x y z` in mm; answers with a line each: `distance x y z nx ny nz face u v inside`, the foot,
//! the outward normal and whether the point is inside.
use std::io::{BufRead, Write};
use std::path::PathBuf;

use bladewright::geometry::Point;
use bladewright::observe::Silent;
use bladewright::read::model::{self, ModelOptions};

fn run() -> Result<(), String> {
    let path = std::env::args().nth(1).ok_or("which model? give its path")?;
    let blade = model::load(&PathBuf::from(path), &ModelOptions::default(), &Silent).map_err(|e| e.to_string())?;
    let blade_from_model = blade.model_from_blade.inverse();
    let mut out = std::io::BufWriter::new(std::io::stdout().lock());
    for line in std::io::stdin().lock().lines() {
        let line = line.map_err(|e| e.to_string())?;
        let numbers: Vec<f64> = line.split_whitespace().filter_map(|w| w.parse().ok()).collect();
        let [x, y, z] = numbers[..] else { return Err(format!("not a point: {line}")) };
        let q = blade_from_model * Point::new(x, y, z);
        let Some(c) = blade.part.closest(&q, f64::INFINITY) else { return Err(format!("nothing near {line}")) };
        let (p, n) = (blade.model_from_blade * c.point, blade.model_from_blade * c.normal);
        let inside = u8::from(blade.part.inside(&q));
        let [u, v] = c.uv;
        let d = c.distance_mm;
        writeln!(out, "{d} {} {} {} {} {} {} {} {u} {v} {inside}", p.x, p.y, p.z, n.x, n.y, n.z, c.face)
            .map_err(|e| e.to_string())?;
    }
    out.flush().map_err(|e| e.to_string())
}

fn main() -> std::process::ExitCode {
    match run() {
        Ok(()) => std::process::ExitCode::SUCCESS,
        Err(e) => {
            let _ = writeln!(std::io::stderr(), "{e}");
            std::process::ExitCode::FAILURE
        }
    }
}
