//! Turns as a published method for turn-milling lays them beside ours, on one blade: ridges,
//! length, and how far passes have gone astray after so many of them (`docs/turning.md`).
//!
//! `cargo run --release --example first_order -- MODEL [--radius=4] [--scallop=0.01] [--start=MM]
//! [--end=MM]`
//!
//! Three kinds of path over the same region, all laid from the same curve at its end: ours
//! (`constant-scallop`), a helix of first-order neighbours (`first-order`), and closed rings of
//! them (`first-order-rings`). Ridges are those of the checks, between the inner turns. From places
//! along the last turn but one the example walks from pass to pass, each time to the nearest place
//! of the next: the way so far over that on our path is what passes are too far apart, or too near.
#![allow(clippy::print_stdout)]

use std::path::Path;

use bladewright::artifact::Blade;
use bladewright::artifact::region::Extent;
use bladewright::artifact::report::LimitFigures;
use bladewright::artifact::toolpath::{CutterLocation, PathKind, Toolpath};
use bladewright::error::Result;
use bladewright::observe::{Observer, Warning};
use bladewright::path::{self, PathOptions};
use bladewright::read::model::{self, ModelOptions};
use bladewright::verify::{self, RidgeAt, VerifyOptions};
use bladewright::{Error, Stage};
use nalgebra::distance;

/// Passes after which the table says where they are.
const PASSES: [usize; 3] = [10, 30, 100];
/// Samples of the surface for the limit of the length.
const SAMPLES: usize = 40_000;
/// Places that are walked from.
const WALKS: usize = 400;
/// Turns on both sides of a pass whose ridges count as those of the pass.
const BESIDE: usize = 1;

/// Warnings on the terminal.
struct Terminal;

impl Observer for Terminal {
    fn warn(&self, warning: Warning) {
        eprintln!("{}: {}", warning.stage, warning.doubt);
    }
}

/// The path of one kind with what was measured on it.
struct Measured {
    path: Toolpath,
    limit: LimitFigures,
    ridges: Vec<RidgeAt>,
    /// For each walk, the way up to each pass, mm.
    walks: Vec<Vec<f64>>,
}

fn measure(blade: &Blade, options: &PathOptions) -> Result<Measured> {
    let path = path::plan(blade, options, &Terminal)?;
    let scallop_mm = options.settings.scallop_mm;
    let limit = verify::limit(blade, &path, scallop_mm, SAMPLES)?;
    let judged = VerifyOptions { scallop_mm, ..VerifyOptions::default() };
    let ridges = verify::ridges(&path, &blade.part, &judged, path.locations.len());
    let walks = walks(&path);
    Ok(Measured { path, limit, ridges, walks })
}

/// The nearest place of the locations `rows` to another, and how far off it is, mm.
fn nearest(locations: &[CutterLocation], rows: std::ops::Range<usize>, from: &CutterLocation) -> Option<(usize, f64)> {
    let away = |k: usize| distance(&locations[k].centre, &from.centre);
    let row = rows.min_by(|a, b| away(*a).total_cmp(&away(*b)))?;
    // Between the locations: over a chord to either side, the foot on it.
    let on = |a: usize, b: usize| {
        let (p, d) = (locations[a].centre, locations[b].centre - locations[a].centre);
        let f = ((from.centre - p).dot(&d) / d.norm_squared().max(1e-300)).clamp(0.0, 1.0);
        distance(&(p + d * f), &from.centre)
    };
    let chords = [row.checked_sub(1).map(|k| on(k, row)), (row + 1 < locations.len()).then(|| on(row, row + 1))];
    Some((row, chords.into_iter().flatten().fold(away(row), f64::min)))
}

/// Walks from the last turn but one up the path, from pass to pass.
fn walks(path: &Toolpath) -> Vec<Vec<f64>> {
    let Some(first) = path.turns.len().checked_sub(2).and_then(|k| path.turns.get(k)) else { return Vec::new() };
    let locations = &path.locations;
    let row_at = |s_mm: f64| locations.partition_point(|l| l.s_mm < s_mm);
    let walk = |start: usize| {
        let (mut row, mut way_mm, mut ways) = (start, 0.0, vec![0.0]);
        loop {
            let l = &locations[row];
            // Half a turn to one and a half turns further up, where there is as much.
            let turn_mm = path.turns[l.turn as usize].length_mm;
            if l.s_mm < 1.5 * turn_mm {
                return ways;
            }
            let rows = row_at(l.s_mm - 1.5 * turn_mm)..row_at(l.s_mm - 0.5 * turn_mm);
            let Some((next, away_mm)) = nearest(locations, rows, l) else { return ways };
            (row, way_mm) = (next, way_mm + away_mm);
            ways.push(way_mm);
        }
    };
    (0..WALKS).map(|k| walk(first.first + k * first.count / WALKS)).collect()
}

/// The value that the share `share` of the values is under.
fn percentile(values: &mut [f64], share: f64) -> f64 {
    values.sort_by(f64::total_cmp);
    values.get((share * values.len().saturating_sub(1) as f64).round() as usize).copied().unwrap_or(f64::NAN)
}

/// Ridges beside a pass, counted from the end: median and 99th percentile over the scallop.
fn ridges_at(found: &Measured, pass: usize, scallop_mm: f64) -> Option<[f64; 2]> {
    let turn = found.path.turns.len().checked_sub(2 + pass)?;
    let near = |r: &&RidgeAt| (found.path.locations[r.rows[0]].turn as usize).abs_diff(turn) <= BESIDE;
    let mut heights: Vec<f64> = found.ridges.iter().filter(near).map(|r| r.height_mm / scallop_mm).collect();
    (turn > BESIDE).then(|| [0.5, 0.99].map(|share| percentile(&mut heights, share)))
}

/// How far walks have gone ahead of ours after so many passes, in passes of ours: mean, and the
/// 5th and 95th percentile; and the mean way over ours.
fn ahead(found: &Measured, ours: &Measured, pass: usize) -> Option<[f64; 4]> {
    let both = |(a, b): (&Vec<f64>, &Vec<f64>)| Some([*a.get(pass)?, *b.get(pass)?]);
    let ways: Vec<[f64; 2]> = found.walks.iter().zip(&ours.walks).filter_map(both).collect();
    let mut passes: Vec<f64> = ways.iter().map(|[a, b]| (a / b - 1.0) * pass as f64).collect();
    let mean = |values: &[f64]| values.iter().sum::<f64>() / values.len() as f64;
    let ratio = ways.iter().map(|w| w[0]).sum::<f64>() / ways.iter().map(|w| w[1]).sum::<f64>();
    // Near the top not every walk has come so far.
    let is_whole = 2 * ways.len() > WALKS;
    is_whole.then(|| [mean(&passes), percentile(&mut passes, 0.05), percentile(&mut passes, 0.95), ratio])
}

fn main() -> Result<()> {
    let args: Vec<String> = std::env::args().skip(1).collect();
    let number = |key: &str| args.iter().find_map(|a| a.strip_prefix(key)).and_then(|v| v.parse::<f64>().ok());
    let file = args.iter().find(|a| !a.starts_with("--"));
    let file = file.ok_or_else(|| Error::usage(Stage::Path, "which model? give its path"))?;
    let blade = model::load(Path::new(file), &ModelOptions::default(), &Terminal)?;
    let (radius_mm, scallop_mm) = (number("--radius=").unwrap_or(4.0), number("--scallop=").unwrap_or(0.01));
    let mut options = PathOptions::new(radius_mm, scallop_mm).with(|s| s.chord_mm = s.chord_mm.min(0.04 * scallop_mm));
    options.extent = Extent::heights(number("--start="), number("--end="));

    println!(
        "{} R {radius_mm}, scallop {scallop_mm} mm; ridges over the scallop, length of the contacts' way",
        blade.name
    );
    println!("| kind | turns | length, m | over its limit | p05 | p50 | p99 | greatest | p99/p50 |");
    println!("| --- | --- | --- | --- | --- | --- | --- | --- | --- |");
    let mut found = Vec::new();
    for kind in [PathKind::ConstantScallop, PathKind::FirstOrder, PathKind::FirstOrderRings] {
        let measured = match measure(&blade, &options.clone().with(|s| s.kind = kind)) {
            Ok(measured) => measured,
            Err(e) => {
                println!("| {} | {e} |", kind.name());
                continue;
            }
        };
        let l = &measured.limit;
        let [p05, p50, p99, most] =
            [l.ridge_p05_mm, l.ridge_p50_mm, l.ridge_p99_mm, l.ridge_max_mm].map(|h| h / scallop_mm);
        println!(
            "| {} | {} | {:.3} | {:.3} | {p05:.3} | {p50:.3} | {p99:.3} | {most:.3} | {:.3} |",
            kind.name(),
            measured.path.turns.len(),
            1e-3 * l.path_length_mm,
            l.ratio,
            p99 / p50
        );
        found.push((kind, measured));
    }
    println!(
        "\nAfter so many passes from the end: ridges there; passes ahead of ours (5th, 95th percentile); way over ours"
    );
    println!("| kind | passes | p50 | p99 | ahead | way |");
    println!("| --- | --- | --- | --- | --- | --- |");
    for (kind, measured) in &found {
        for pass in PASSES {
            let Some([p50, p99]) = ridges_at(measured, pass, scallop_mm) else { continue };
            let gone = found.first().and_then(|(_, ours)| ahead(measured, ours, pass));
            let gone = gone.map_or_else(
                || " | ".to_owned(),
                |[mean, p05, p95, ratio]| format!("{mean:+.3} ({p05:+.3}, {p95:+.3}) | {ratio:.4}"),
            );
            println!("| {} | {pass} | {p50:.3} | {p99:.3} | {gone} |", kind.name());
        }
    }
    Ok(())
}
