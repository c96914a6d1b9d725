//! `inspect`: what is in a model file.

use super::args::{Faces, Inspect, Reading, RegionHeights};
use super::out::{self, say, sayln};
use super::progress::Terminal;
use crate::error::Result;
use crate::read::model::{self, ModelOptions};
use crate::run;
use crate::write::preview;
use serde_json::json;

/// Runs the verb; the exit code.
pub fn run(args: &Inspect, quiet: bool) -> Result<u8> {
    let terminal = Terminal::new(quiet);
    let survey = model::survey(&args.model, &options(args), &terminal);
    terminal.finish();
    let survey = survey?;
    say!("{}", model::inspect_text(&survey));
    if out::is_json()
        && let Some(regions) = survey.regions()
    {
        let list: Vec<_> = regions.list.iter().map(model::region_json).collect();
        out::event(&json!({ "event": "regions", "regions": list }));
    }
    if let Some(file) = &args.glb {
        let scene = preview::regions(&survey.name, &survey.part.mesh, &survey.areas())?;
        run::write_file(file, &scene)?;
        sayln!("{:<10} {}", "written", file.display());
    }
    Ok(0)
}

fn options(args: &Inspect) -> ModelOptions {
    ModelOptions { weld_mm: args.weld, close_holes_mm: args.close_holes, ..reading(&args.reading) }
}

/// How a model is to be read, as typed.
pub(super) fn reading(r: &Reading) -> ModelOptions {
    let mut o = ModelOptions { unit: r.unit, axis: r.axis.map(|a| a.0), body: r.body, ..ModelOptions::default() };
    for region in &r.region {
        match region {
            RegionHeights::Airfoil(heights) => o.airfoil_mm = Some(*heights),
            RegionHeights::Platform(x) => o.platform_mm = Some(*x),
        }
    }
    for faces in &r.faces {
        match faces {
            Faces::Airfoil(names) => o.airfoil_faces.extend(names.iter().cloned()),
            Faces::Platform(names) => o.platform_faces.extend(names.iter().cloned()),
        }
    }
    o
}
