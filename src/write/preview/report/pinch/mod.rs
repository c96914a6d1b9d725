//! The page of rows for two tools: the same head, view, tables and script as the page of a run.
//!
//! **Every figure shown is one of `pinch.json`**, as cells say (`data-figure`). What the sheet of
//! setup and tools says of tools, machine and zero point is what the job gives.
//!
//! Plots are thinned as those of a run: a piece of a row shows the walls where they come nearest to
//! the angle that is held, and the greatest angle and distance of the normals. Ways from row to row
//! are shown in the 3-D view, and are no part of the plots.

use std::ops::Range;

use super::{File, filled, shell, tables};
use crate::artifact::obstacle::Obstacle;
use crate::artifact::paired::PinchMotion;
use crate::artifact::report::Check;
use crate::artifact::{Blade, PairedRows};
use crate::error::Result;
use crate::machine::Machine;
use crate::observe::Warning;
use crate::tool::Tool;
use crate::write::preview::PinchKey;

mod data;
mod figures;
#[cfg(test)]
mod tests;

/// A stretch of a row, with what is free there. Angles of the table in rad; a wall is `[from, to]`
/// about the angle at which the table stands, on its turn.
#[derive(Clone, Debug, PartialEq)]
pub struct PinchStretch {
    /// Row, from 0.
    pub row: usize,
    /// Its places in the rows.
    pub places: Range<usize>,
    /// The angle at which the table stands at each place.
    pub theta_rad: Vec<f64>,
    /// At each place what is free for tool 1, for tool 2 (turned back by the angle between the
    /// heads), and for both.
    pub free_rad: [Vec<[f64; 2]>; 3],
}

/// What the page is made from. Lists may be empty.
#[derive(Clone, Copy)]
pub struct PinchReport<'a> {
    /// Title of the page, e.g. the job's name.
    pub title: &'a str,
    /// The blade.
    pub blade: &'a Blade,
    /// Both tools.
    pub tools: [&'a Tool; 2],
    /// Leans of both tools towards the tip, rad.
    pub leans_rad: [f64; 2],
    /// The angle of the second head over the first about the blade axis, rad.
    pub between_rad: f64,
    /// Speeds of both spindles, 1/min.
    pub spindle_rpm: [f64; 2],
    /// The machine.
    pub machine: &'a Machine,
    /// Fixtures and stock.
    pub obstacles: &'a [Obstacle],
    /// The rows.
    pub rows: &'a PairedRows,
    /// The stretches, in order.
    pub stretches: &'a [PinchStretch],
    /// Motion of all axes, on a machine with two heads.
    pub motion: Option<&'a PinchMotion>,
    /// Where both tools stand over time: first and last place of each stretch among them.
    pub keys: &'a [PinchKey],
    /// The greatest that the normals may lack of being opposite, degrees.
    pub max_angle_deg: f64,
    /// The greatest distance of the normal lines, mm.
    pub line_distance_mm: f64,
    /// `pinch.json`.
    pub figures: File<'a>,
    /// Warnings of all stages.
    pub warnings: &'a [Warning],
    /// The resolved job as TOML.
    pub job_toml: &'a str,
    /// Where it came from: label and value (file, hash, version, date …).
    pub provenance: &'a [(String, String)],
}

impl PinchReport<'_> {
    /// What a stretch and several of them are called, and so at the beginning of a label: rows
    /// where each row is one.
    fn words(&self) -> [&'static str; 4] {
        if self.stretches.len() == self.rows.rows.len() {
            ["row", "rows", "Row", "Rows"]
        } else {
            ["stretch", "stretches", "Stretch", "Stretches"]
        }
    }

    /// The checks of a list in the figures; none where there is no such list.
    fn checks(&self, pointer: &str) -> Vec<Check> {
        let list = self.figures.json.pointer(pointer).cloned();
        list.and_then(|list| serde_json::from_value(list).ok()).unwrap_or_default()
    }
}

/// The page.
///
/// # Errors
/// `InputOutput` where the data cannot be encoded; numbers that are not finite are shown as
/// missing.
pub fn html(input: &PinchReport) -> Result<String> {
    let lists = figures::check_lists(input);
    let between = super::number(input.between_rad.to_degrees());
    let [turn, turns, one, many] = input.words();
    let words = [
        ("turn", turn),
        ("turns", turns),
        ("Turn", one),
        ("Turns", many),
        ("tools", "both tools"),
        ("first", "tool 1"),
        ("between", &between),
    ];
    let mut nav = vec![
        ("view", "3-D view"),
        ("figures", "Figures"),
        ("sheet", "Setup"),
        ("checks", "Checks"),
        ("channel", "Table angle"),
        ("opposition", "Opposition"),
    ];
    let mut sections = vec![
        filled(include_str!("../view.html"), &words),
        figures::cards(input),
        figures::sheet(input),
        figures::checks(input, &lists),
        filled(include_str!("plots.html"), &words),
    ];
    if input.motion.is_some() {
        nav.extend([("axes", "Axes"), ("compare", "Compared"), ("programs", "Programs")]);
        sections.push(filled(include_str!("../axes.html"), &words));
        sections.push(figures::compared(input));
        sections.push(figures::programs(input, &lists));
    }
    nav.push(("job", "Job"));
    sections.push(tables::warnings(input.warnings));
    sections.push(tables::provenance(input.blade, input.job_toml, input.provenance));
    let head = tables::Head {
        title: input.title,
        blade: &input.blade.name,
        machine: &input.machine.name,
        checks: lists.iter().flat_map(|l| &l.checks).collect(),
        forced: false,
        nav: &nav,
    };
    let payload = data::payload(input)?;
    Ok(shell(&head, &sections, &payload, &super::program::element(None)?))
}
