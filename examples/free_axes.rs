//! How much of the sphere of tool axes is free along a blade, alone and among the other blades of
//! its wheel, beside what a reference plane has of it.
//!
//! `cargo run --release --example free_axes -- MODEL [--radius=3] [--taper=3] [--shank=6]
//! [--holder=20] [--stickout=100] [--blades=36] [--wheel=1,0,0] [--finest=1] [--end=MM]
//! [--places=400] [--svg=FILE]`
//!
//! The wheel turns about the direction `--wheel` of the model through the model's origin. The
//! reference plane at a location (Chen, Xu and Tang, Journal of Computational Design and
//! Engineering 2, 2015) goes along the blade's axis and the surface normal. The picture shows the
//! free axes of one location, halfway along the path.
#![allow(clippy::print_stdout)]

use std::path::Path;
use std::time::Instant;

use bladewright::artifact::region::Extent;
use bladewright::artifact::toolpath::PathKind;
use bladewright::artifact::{Blade, Obstacle, Wheel};
use bladewright::channel::{self, ChannelOptions, Surroundings};
use bladewright::error::Result;
use bladewright::geometry::part::Part;
use bladewright::geometry::{Point, Vector};
use bladewright::observe::Silent;
use bladewright::orient;
use bladewright::path::{self, PathOptions};
use bladewright::read::model::{self, ModelOptions};
use bladewright::tool::{CLEARANCE_MM, HOLDER_CLEARANCE_MM, HolderStage, Tool};
use bladewright::write::draw::sphere_svg;
use bladewright::{Error, Stage};
use nalgebra::Unit;

/// Locations that the table shows.
const ROWS: usize = 12;
/// Locations that are looked at.
const PLACES: f64 = 400.0;

/// The other blades of the wheel, in the blade frame.
fn other_blades(blade: &Blade, wheel: &Wheel) -> Vec<Obstacle> {
    (2..=wheel.blades)
        .map(|k| Obstacle {
            name: format!("blade {k}"),
            part: Part::from_mesh(blade.part.mesh.clone().moved(&wheel.turn_to(k))),
            clearance_mm: CLEARANCE_MM + blade.part.deflection_mm,
            holder_clearance_mm: HOLDER_CLEARANCE_MM + blade.part.deflection_mm,
            cut_by_the_tool: false,
            of_the_wheel: false,
            copies: vec![wheel.turn_to(k)],
        })
        .collect()
}

fn main() -> Result<()> {
    let args: Vec<String> = std::env::args().skip(1).collect();
    let value = |key: &str| args.iter().find_map(|a| a.strip_prefix(key));
    let number = |key: &str| value(key).and_then(|v| v.parse::<f64>().ok());
    let usage = |what: &str| Error::usage(Stage::Channel, what.to_owned());
    let file = args.iter().find(|a| !a.starts_with("--")).ok_or_else(|| usage("a model is wanted"))?;
    let blade = model::load(Path::new(file), &ModelOptions::default(), &Silent)?;
    let radius_mm = number("--radius=").unwrap_or(3.0);
    let tool = Tool {
        radius_mm,
        corner_radius_mm: None,
        taper_deg: number("--taper=").unwrap_or(3.0),
        shank_radius_mm: number("--shank=").unwrap_or(2.0 * radius_mm),
        stickout_mm: number("--stickout=").unwrap_or(100.0),
        holder: vec![HolderStage { radius_mm: number("--holder=").unwrap_or(20.0), length_mm: 50.0 }],
    };
    let count = number("--blades=").map_or(1, |n| n as u32);
    let wheel: Vec<f64> = value("--wheel=").unwrap_or("1,0,0").split(',').filter_map(|x| x.parse().ok()).collect();
    let [x, y, z] = wheel[..] else { return Err(usage("--wheel wants three numbers")) };
    let finest_deg = number("--finest=").unwrap_or(1.0);

    let mut options = PathOptions::new(radius_mm, 0.05).with(|s| s.kind = PathKind::ConstantScallop);
    let [foot, tip] = blade.regions.airfoil_x_mm();
    options.extent = Extent::heights(Some(tip - 0.1 * (tip - foot)), number("--end="));
    let mut path = path::plan(&blade, &options, &Silent)?;
    let places = number("--places=").unwrap_or(PLACES).max(1.0) as usize;
    path.locations = path.locations.iter().step_by(path.locations.len().div_ceil(places)).copied().collect();

    let blade_from_model = blade.model_from_blade.inverse();
    let axis = Unit::new_normalize(blade_from_model * Vector::new(x, y, z));
    let wheel = Wheel { axis, origin: blade_from_model * Point::origin(), blades: count };
    let (alone, others) = (Vec::new(), other_blades(&blade, &wheel));
    let channel_options = ChannelOptions::default();
    let mut found = Vec::new();
    for bodies in [&alone, &others] {
        let surroundings = Surroundings::new(&blade, bodies, radius_mm)?;
        let start = Instant::now();
        let spheres = channel::spheres(&surroundings, &tool, &path, &channel_options, finest_deg, &Silent)?;
        let seconds = start.elapsed().as_secs_f64();
        let triangles = blade.part.mesh.triangles.len() * (bodies.len() + 1);
        println!("{triangles} triangles: {:.0} spheres a second", spheres.len() as f64 / seconds);
        let start = Instant::now();
        let cones = orient::reference_planes(&path, &Vector::x()).ok_or_else(|| usage("no normal names a plane"))?;
        let planes = path.clone().with_cones(cones);
        let arcs = channel::intervals(&surroundings, &tool, &planes, &channel_options, &Silent)?;
        println!("  reference planes: {:.0} a second", arcs.len() as f64 / start.elapsed().as_secs_f64());
        let empty = arcs.iter().zip(&spheres).filter(|(a, s)| a.is_empty() && s.shares()[0] > 0.0).count();
        println!("  {empty} of {} locations have free axes and none in the plane", arcs.len());
        let open = spheres.iter().map(|s| s.shares()[2]).sum::<f64>() / spheres.len() as f64;
        println!("  {:.2} % of the sphere is open in the mean", 100.0 * open);
        found.push((spheres, arcs));
    }
    println!("height mm, normal's angle, free alone, free in the wheel, open, plane alone, plane in the wheel");
    for row in (0..path.locations.len()).step_by(path.locations.len().div_ceil(ROWS)) {
        let l = &path.locations[row];
        let shares = |k: usize| found[k].0[row].shares();
        let width = |k: usize| found[k].1[row].iter().map(|f| f.theta_max - f.theta_min).sum::<f64>().to_degrees();
        println!(
            "{:8.2} {:6.1}° {:5.1} % {:5.1} % {:5.2} % {:6.1}° {:6.1}°",
            l.centre.x,
            l.normal.z.atan2(l.normal.y).to_degrees(),
            100.0 * shares(0)[0],
            100.0 * shares(1)[0],
            100.0 * shares(1)[2],
            width(0),
            width(1),
        );
    }
    if let Some(file) = value("--svg=") {
        let row = path.locations.len() / 2;
        std::fs::write(file, sphere_svg(&found[1].0[row], &path.locations[row].normal, &[], &[]))
            .map_err(|e| usage(&format!("{file}: {e}")))?;
    }
    Ok(())
}
