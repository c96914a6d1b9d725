//! How many cutter locations a second the channel takes, against brute force over θ.
//!
//! Brute force: at 36 angles, every triangle's corners and centre against every part of the tool (which is neither exact
//! nor sure). The channel's ends are exact to 0.01°.
#![allow(missing_docs, clippy::print_stdout)]

use std::f64::consts::TAU;
use std::time::Instant;

use bladewright::artifact::blade::{Blade, Diagnosis, Regions, Unit};
use bladewright::artifact::toolpath::{CutterLocation, Toolpath, Turn};
use bladewright::channel::{ChannelOptions, plan};
use bladewright::geometry::mesh::Mesh;
use bladewright::geometry::part::Part;
use bladewright::geometry::{Point, Rigid, Vector};
use bladewright::observe::Silent;
use bladewright::tool::{HolderStage, Tool, axis};

const RADIUS_MM: f64 = 4.0;

/// An elliptic cylinder of `around` times `up` quads, closed by fans.
fn cylinder(around: u32, up: u32) -> Mesh {
    let mut mesh = Mesh::default();
    for j in 0..=up {
        for i in 0..around {
            let (s, c) = (TAU * f64::from(i) / f64::from(around)).sin_cos();
            mesh.points.push(Point::new(60.0 * f64::from(j) / f64::from(up), 20.0 * c, 8.0 * s));
        }
    }
    for j in 0..up {
        for i in 0..around {
            let (a, b) = (j * around + i, j * around + (i + 1) % around);
            mesh.triangles.extend([[a, b, b + around], [a, b + around, a + around]]);
        }
    }
    let (low, high) = (mesh.points.len() as u32, mesh.points.len() as u32 + 1);
    mesh.points.extend([Point::new(0.0, 0.0, 0.0), Point::new(60.0, 0.0, 0.0)]);
    for i in 0..around {
        let (a, b, top) = (i, (i + 1) % around, up * around);
        mesh.triangles.extend([[low, b, a], [high, top + a, top + b]]);
    }
    mesh
}

fn helix(count: usize) -> Toolpath {
    let locations: Vec<CutterLocation> = (0..count)
        .map(|i| {
            let (s, c) = (TAU * i as f64 / count as f64).sin_cos();
            let normal = Vector::new(0.0, 8.0 * c, 20.0 * s).normalize();
            let contact = Point::new(25.0 + i as f64 / count as f64, 20.0 * c, 8.0 * s);
            let s_mm = 90.0 * i as f64 / count as f64;
            CutterLocation { turn: 0, turn_s_mm: s_mm, s_mm, centre: contact + normal * RADIUS_MM, contact, normal }
        })
        .collect();
    Toolpath {
        kind: bladewright::artifact::toolpath::PathKind::default(),
        stock_mm: 0.0,
        radius_mm: RADIUS_MM,
        scallop_mm: 0.01,
        chord_mm: 0.01,
        region_x_mm: [25.0, 26.0],
        end_reason: "the end of the region".into(),
        planned_scallop_mm: 0.01,
        turns: vec![Turn { first: 0, count, length_mm: 90.0 }],
        locations,
    }
}

/// Free angles among 36, for each of the locations.
fn brute_force(mesh: &Mesh, tool: &Tool, b_rad: f64, locations: &[CutterLocation]) -> usize {
    let segments = tool.segments();
    let mut free = 0;
    for l in locations {
        for k in 0..36 {
            let a = axis(b_rad, TAU * f64::from(k) / 36.0);
            let hits = |p: &Point| {
                let v = p - l.centre;
                let z = v.dot(&a);
                let r = (v - a * z).norm();
                segments
                    .iter()
                    .any(|s| z >= s.z0 && z <= s.z1 && r <= s.r0 + (s.r1 - s.r0) * (z - s.z0) / (s.z1 - s.z0))
            };
            let hit = (0..mesh.triangles.len()).any(|t| {
                let [p, q, r] = mesh.corners(t);
                let middle = Point::from((p.coords + q.coords + r.coords) / 3.0);
                [p, q, r, middle].iter().any(hits)
            });
            free += usize::from(!hit);
        }
    }
    free
}

fn main() {
    let tool = Tool {
        radius_mm: RADIUS_MM,
        taper_deg: 3.0,
        shank_radius_mm: 6.0,
        stickout_mm: 40.0,
        holder: vec![HolderStage { radius_mm: 15.0, length_mm: 40.0 }],
    };
    let options = ChannelOptions::default();
    for (around, up) in [(160, 30), (500, 100)] {
        let mesh = cylinder(around, up);
        let path = helix(2000);
        let start = Instant::now();
        let free = brute_force(&mesh, &tool, options.b_rad, &path.locations[..4]);
        let brute = start.elapsed().as_secs_f64() / 4.0;
        let x = [0.0, 60.0];
        let blade = Blade {
            name: "cylinder".into(),
            unit: Unit::Mm,
            part: Part::from_mesh(mesh),
            model_from_blade: Rigid::identity(),
            regions: Regions {
                part_x_mm: x,
                airfoil_x_mm: x,
                platform_x_mm: None,
                fillet_x_mm: None,
                reasons: Vec::new(),
            },
            diagnosis: Diagnosis::default(),
        };
        let start = Instant::now();
        match plan(&blade, &tool, &path, &options, &Silent) {
            Ok(channel) => {
                let each = start.elapsed().as_secs_f64() / channel.rows.len() as f64;
                println!(
                    "{} triangles: {:.0} locations/s with {} threads; brute force ({free} of 144 angles free) takes {:.0} times as long",
                    blade.part.mesh.triangles.len(),
                    1.0 / each,
                    rayon::current_num_threads(),
                    brute / each
                );
            }
            Err(e) => println!("{e}"),
        }
    }
}
