//! Axis positions of poses, for comparing kinematics with other programs.
//!
//! Reads lines `x y z theta b` (ball centre in the blade frame in mm, angles in degrees) from
//! standard input and prints the positions of all axes, X, Y, Z and the rotary ones, that nearest
//! to the workpiece first, of the demo machine or the one given, mm and degrees:
//! `cargo run --release --example axis_positions GAUGE_LENGTH_MM [MACHINE.toml] < poses`.
#![allow(clippy::print_stdout)]

use std::io::BufRead;
use std::path::Path;

use bladewright::geometry::Point;
use bladewright::machine::Machine;
use bladewright::run::inputs;

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let mut args = std::env::args().skip(1);
    let gauge_mm: f64 = args.next().ok_or("the length from ball centre to gauge line is missing")?.parse()?;
    let machine = args.next().map_or_else(Machine::demo, |file| inputs::machine(Path::new(&file)))?;
    for line in std::io::stdin().lock().lines() {
        let line = line?;
        let v = line.split_whitespace().map(str::parse).collect::<Result<Vec<f64>, _>>()?;
        let [x, y, z, theta, b] = v[..] else { return Err(format!("five numbers are needed: {line}").into()) };
        let q = machine.inverse(&Point::new(x, y, z), theta.to_radians(), b.to_radians(), gauge_mm);
        let words =
            machine.axes().iter().zip(q.iter()).map(|(axis, v)| format!("{:.12}", axis.shown(*v))).collect::<Vec<_>>();
        println!("{}", words.join(" "));
    }
    Ok(())
}
