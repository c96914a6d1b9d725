//! How low a cutter with a vertical axis comes over triangles: for comparison with other programs.
//!
//! Input, by lines: `cutter R r` (radius and corner radius, mm), `triangle x y z x y z x y z`, then
//! `at x y`. Output, for each `at`: the height of the tip where the cutter touches, or `none`.
//!
//! ```text
//! cargo run --release --example drop_cutter < cutters.txt
//! ```

use std::io::{BufRead, Write};

use bladewright::geometry::mesh::Mesh;
use bladewright::geometry::near_disc::DiscSearch;
use bladewright::geometry::part::Part;
use bladewright::geometry::{Point, Vector};
use bladewright::tool::Tool;

/// Cutters come down from so far over the highest triangle, mm.
const ABOVE_MM: f64 = 1.0;

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let mut mesh = Mesh::default();
    let (mut cutter, mut places) = (None, Vec::new());
    for line in std::io::stdin().lock().lines() {
        let line = line?;
        let mut words = line.split_whitespace();
        let what = words.next().unwrap_or_default().to_owned();
        let numbers = words.map(str::parse::<f64>).collect::<Result<Vec<f64>, _>>()?;
        match (what.as_str(), &numbers[..]) {
            ("cutter", [radius, corner]) => cutter = Some((*radius, *corner)),
            ("triangle", [..]) if numbers.len() == 9 => {
                let first = mesh.points.len() as u32;
                mesh.points.extend(numbers.chunks(3).map(|p| Point::new(p[0], p[1], p[2])));
                mesh.triangles.push([first, first + 1, first + 2]);
                mesh.face_of.push(0);
            }
            ("at", [x, y]) => places.push((*x, *y)),
            _ => return Err(format!("not understood: {line}").into()),
        }
    }
    let (radius_mm, corner) = cutter.ok_or("no cutter")?;
    let tool = Tool {
        radius_mm,
        corner_radius_mm: Some(corner).filter(|r| *r < radius_mm),
        taper_deg: 0.0,
        shank_radius_mm: radius_mm,
        stickout_mm: 10.0 * radius_mm,
        holder: Vec::new(),
    };
    tool.validate()?;
    let top = mesh.points.iter().map(|p| p.z).fold(f64::NEG_INFINITY, f64::max);
    let part = Part::from_mesh(mesh);
    let mut search = DiscSearch::new(&part);
    let mut out = std::io::stdout().lock();
    for (x, y) in places {
        let from = Point::new(x, y, top + tool.corner_mm() + ABOVE_MM);
        match tool.touch_mm(&mut search, (&from, &Vector::z()), &Vector::z(), 0.0, f64::INFINITY) {
            Some(way) => writeln!(out, "{:.9}", from.z - way - tool.corner_mm())?,
            None => writeln!(out, "none")?,
        }
    }
    Ok(())
}
