//! What the smooth curve gains: jerk of the axes at constant feed and machining time, beside the
//! path as it is and beside one whose touches were merely evened.
//!
//! `cargo run --release --example smooth [-- model ...]`; without models those of the folder
//! `models`. Jobs are the defaults. Jerks of the path and of the evened one are those of the
//! natural cubic spline of the axes through the locations, which the feed is planned on, away from
//! its ends.
#![allow(clippy::print_stdout)]

use std::path::{Path, PathBuf};
use std::time::Instant;

use bladewright::artifact::toolpath::CutterLocation;
use bladewright::artifact::{Curve, Plan, Toolpath, motion};
use bladewright::error::Result;
use bladewright::feed::{self, FeedOptions};
use bladewright::geometry::allowance::Allowed;
use bladewright::machine::Machine;
use bladewright::observe::Silent;
use bladewright::plan::{self, Setup};
use bladewright::read::model::{self, ModelOptions};
use bladewright::smooth::{self, Objective, SmoothOptions};
use bladewright::verify::Verdict;
use bladewright::{Error, Stage, job};

/// Feed at which jerks are printed, mm/min.
const FEED: f64 = 2000.0;
/// Locations at either end that are left out: there the natural spline is not that of the path.
const ENDS: usize = 10;

/// A blade planned by the defaults.
fn planned(file: &Path) -> Result<(Setup, Plan)> {
    let blade = model::load(file, &ModelOptions::default(), &Silent)?;
    let text = format!("[model]\nfile = '{}'\n", file.display());
    let draft = job::resolve(job::parse(&text, "the job")?, Path::new(""))?;
    let setup = Setup::of(&draft, blade, Machine::demo()?, &Silent)?;
    let planned = match plan::plan(&setup, &Silent)? {
        Verdict::Passed(verified) => verified.value().clone(),
        Verdict::Failed(_) => return Err(Error::usage(Stage::Verify, "the plan fails its checks")),
    };
    Ok((setup, planned))
}

/// Greatest jerk of each axis along a spline through the locations, at constant feed.
fn jerk_of_spline(setup: &Setup, path: &Toolpath, theta: &[f64]) -> Vec<f64> {
    let rows = setup.machine.along(path.stands(theta), setup.job.tool.length_mm());
    let s: Vec<f64> = path.locations.iter().map(|l| l.s_mm).collect();
    let Ok(spline) = motion::smooth(&s, &rows) else { return Vec::new() };
    let third = |i: usize, k: usize| spline.coefficients(i, k).map_or(0.0, |c| (6.0 * c[3]).abs());
    let most = |k: usize| (ENDS..s.len().saturating_sub(ENDS + 1)).map(|i| third(i, k)).fold(0.0, f64::max);
    (0..spline.functions()).map(|k| most(k) * (FEED / 60.0).powi(3)).collect()
}

/// The same along the curve: linear axes by differences of their positions on each piece, the
/// turning one by θ itself.
fn jerk_of_curve(setup: &Setup, curve: &Curve, lean_rad: f64) -> Vec<f64> {
    const STEPS: usize = 8;
    let machine = &setup.machine;
    let mut out = vec![0.0_f64; machine.axes().len()];
    for stretch in &curve.stretches {
        for i in 0..stretch.pieces() {
            let [a, b] = stretch.breaks.span(i);
            let h = (b - a) / STEPS as f64;
            let places: Vec<_> = (0..=STEPS).map(|k| stretch.at(a + h * k as f64)).collect();
            let rows: Vec<_> = places
                .iter()
                .map(|p| machine.inverse(&p.point(), p.theta[0], lean_rad, setup.job.tool.length_mm()))
                .collect();
            for k in machine.linear() {
                for r in rows.windows(5) {
                    let third = (r[4][k] - 2.0 * r[3][k] + 2.0 * r[1][k] - r[0][k]) / (2.0 * h * h * h);
                    out[k] = out[k].max(third.abs());
                }
            }
            let turning = machine.turning_axis();
            out[turning] = places.iter().map(|p| p.theta[3].abs()).fold(out[turning], f64::max);
        }
    }
    out.into_iter().map(|v| v * (FEED / 60.0).powi(3)).collect()
}

/// The path with its locations on the curve, three to a piece, and θ there.
fn on_curve(part: &Allowed, plan: &Plan, curve: &Curve) -> (Toolpath, Vec<f64>) {
    let mut out = plan.toolpath.clone();
    let mut theta = Vec::new();
    let old = &plan.toolpath.locations;
    let pieces = curve.stretches.iter().flat_map(|c| c.breaks.all().windows(2));
    let mut s: Vec<f64> = pieces.flat_map(|w| [0.0, 1.0, 2.0].map(|k| w[0] + (w[1] - w[0]) * k / 3.0)).collect();
    s.extend(curve.stretches.iter().map(|c| c.s_mm()[1]));
    s.extend(old.iter().map(|l| l.s_mm).filter(|s| curve.stretch_at(*s).is_none()));
    s.sort_by(f64::total_cmp);
    out.locations.clear();
    let mut way = 0.0;
    for s in s {
        let k = old.partition_point(|l| l.s_mm <= s).clamp(1, old.len()) - 1;
        let (centre, angle) = match curve.stretch_at(s) {
            Some(stretch) => (stretch.at(s).point(), stretch.at(s).theta[0]),
            None => (old[k].centre, plan.schedule.theta[k]),
        };
        let step = out.locations.last().map_or(1.0, |l: &CutterLocation| (centre - l.centre).norm());
        let Some(foot) = part.closest(&centre, f64::INFINITY).filter(|_| step > 1e-9) else { continue };
        way += if out.locations.is_empty() { 0.0 } else { step };
        let normal = (centre - foot.point).normalize();
        out.locations.push(CutterLocation { s_mm: way, centre, contact: foot.point, normal, ..old[k] });
        theta.push(angle);
    }
    (out, theta)
}

fn measure(file: &Path) -> Result<()> {
    let (setup, plan) = planned(file)?;
    let part = Allowed::new(&setup.blade.part, plan.toolpath.stock_mm);
    let usual = SmoothOptions { bound_of_any: true, ..SmoothOptions::default() };
    let is_mesh = setup.blade.part.brep.is_none();
    let options = if is_mesh { usual.on_mesh(plan.toolpath.scallop_mm) } else { usual };
    let start = Instant::now();
    let (path, theta) = (&plan.toolpath, &plan.schedule.theta);
    let curve =
        smooth::plan(&setup.blade.part, path, &plan.channel, &plan.schedule, &Objective::Part, &options, &Silent)?;
    let (seconds, n) = (start.elapsed().as_secs_f64(), path.locations.len());
    let left = curve.left.iter().fold(0.0, |sum, l| sum + l.s_mm[1] - l.s_mm[0]);
    println!("{}: {n} locations, {} pieces, {left:.1} mm left, {seconds:.1} s", file.display(), curve.pieces());
    for stretch in curve.stretches.iter().take(3) {
        let (p, [from, to]) = (stretch.proof, stretch.s_mm());
        let any = p.bound_of_any.map_or(f64::NAN, |b| p.square / b);
        let (own, theta) = (p.square / p.bound, p.theta_square / p.theta_bound);
        println!("  {from:.1} to {to:.1} mm: over the bound {own:.4}, of any curve {any:.4}, of θ {theta:.4}");
    }
    let lean_rad = path.cone(0).lean_rad;
    let even = smooth::evened(&setup.blade.part, path)?;
    let jerks = [
        ("as it is", jerk_of_spline(&setup, path, theta)),
        ("evened", jerk_of_spline(&setup, &even, theta)),
        ("smooth", jerk_of_curve(&setup, &curve, lean_rad)),
    ];
    for (name, jerks) in jerks {
        let shown: Vec<_> = jerks.iter().map(|j| format!("{j:10.3e}")).collect();
        println!("  jerk at {FEED} mm/min, mm/s³ or rad/s³, {name:8} {}", shown.join(" "));
    }
    let (new_path, new_theta) = on_curve(&part, &plan, &curve);
    for feed_mm_min in [1000.0, 2000.0, 6000.0] {
        let options = FeedOptions::new(feed_mm_min, setup.job.tool.length_mm());
        let time = |path: &Toolpath, theta: &[f64]| {
            let schedule = bladewright::artifact::Schedule { theta: theta.to_vec(), ..plan.schedule.clone() };
            feed::plan(path, &schedule, &setup.machine, &options, &Silent).map(|m| m.time_s)
        };
        println!("  {feed_mm_min} mm/min: {:.2} s, smooth {:.2} s", time(path, theta)?, time(&new_path, &new_theta)?);
    }
    Ok(())
}

fn main() -> Result<()> {
    let given: Vec<PathBuf> = std::env::args().skip(1).map(PathBuf::from).collect();
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("models");
    let usual = ["turbine_camber", "steam_root", "compressor_twist"].map(|m| folder.join(m).with_extension("step"));
    let models = if given.is_empty() { usual.to_vec() } else { given };
    models.iter().try_for_each(|file| measure(file))
}
