//! `inspect`: what is in a model file.

use super::args::{Faces, Inspect, Reading, RegionHeights};
use super::out::{self, say, sayln};
use super::progress::Terminal;
use crate::error::{Error, Result};
use crate::pair;
use crate::read::model::{self, ModelOptions, Survey};
use crate::run;
use crate::write::preview;
use serde_json::json;

/// Runs the verb; the exit code.
pub fn run(args: &Inspect, quiet: bool) -> Result<u8> {
    let terminal = Terminal::new(quiet);
    let survey = model::survey(&args.model, &options(args), &terminal);
    terminal.finish();
    let survey = &survey?;
    say!("{}", model::inspect_text(survey));
    if out::is_json()
        && let Some(regions) = survey.regions()
    {
        let list: Vec<_> = regions.list.iter().map(model::region_json).collect();
        out::event(&json!({ "event": "regions", "regions": list }));
    }
    if args.pairs {
        pairs(survey, &terminal)?;
    }
    if let Some(file) = &args.glb {
        let scene = preview::regions(&survey.name, &survey.part.mesh, &survey.areas())?;
        run::write_file(file, &scene)?;
        sayln!("{:<10} {}", "written", file.display());
    }
    Ok(0)
}

/// How much of the airfoil has an opposite side.
fn pairs(survey: &Survey, terminal: &Terminal) -> Result<()> {
    let chord_mm = survey.found.as_ref().map_err(Error::without_cause)?.chord_mm();
    let share = pair::share(&survey.part, &survey.areas(), chord_mm, terminal);
    terminal.finish();
    let share = share?;
    let percent = |v: f64| format!("{:.1} %", 100.0 * v);
    let [least, median, most] = share.thickness_mm;
    let lines = [
        format!(
            "{} of the airfoil has an opposite side, with normals within {}° of opposite ({} places)",
            percent(share.holds),
            pair::HOLDS_DEG,
            share.places
        ),
        format!(
            "thickness there {least:.3} to {most:.3} mm, half of it under {median:.3} mm: {} of the sections' width",
            percent(share.thickness_over_chord)
        ),
        format!(
            "normals there lack {:.2}° of being opposite (99 %: {:.2}°), and pass each other within {:.4} mm (99 %)",
            share.angle_deg[0], share.angle_deg[1], share.apart_p99_mm
        ),
        format!(
            "the rest: {} wedges, as towards edges; {} faces other regions; {} faces nothing, as edges do",
            percent(share.wedge),
            percent(share.elsewhere),
            percent(share.none)
        ),
    ];
    for (k, line) in lines.iter().enumerate() {
        sayln!("{:<10} {line}", if k == 0 { "pairs" } else { "" });
    }
    if out::is_json() {
        out::event(&json!({ "event": "pairs", "pairs": share }));
    }
    Ok(())
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
