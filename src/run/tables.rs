//! The tables of a run as CSV: cutter locations and axis motion.

use std::fmt::Write;

use crate::artifact::deviation::DeviationMap;
use crate::artifact::{Blade, Plan};
use crate::error::{Error, Result, Stage};
use crate::geometry::{Point, Vector};
use crate::machine::Axis;

/// `cutter_locations.csv`: model frame, mm, degrees; numbers in the shortest form that reads back
/// exactly.
pub fn cutter_locations(blade: &Blade, plan: &Plan) -> String {
    let mut out = String::with_capacity(260 * plan.toolpath.locations.len() + 400);
    out.push_str("# bladewright cutter locations; model frame, mm; angles in degrees about the blade axis\n");
    if plan.toolpath.disc_radius_mm > 0.0 {
        let disc_mm = plan.toolpath.disc_radius_mm;
        let _ = writeln!(
            out,
            "# c: centre of a disc of radius {disc_mm} mm square to the tool axis i, over which a corner of radius {} mm rolls; \
             lengths S and s are those of the way of the corner's centre",
            plan.toolpath.radius_mm
        );
    }
    if plan.toolpath.stock_mm > 0.0 {
        let _ = writeln!(out, "# contacts p lie on {} mm of stock that stay on the part", plan.toolpath.stock_mm);
    }
    for (name, lead) in ["lead-in", "lead-out"].into_iter().zip(&plan.leads) {
        let _ = match lead.is_arc() {
            true => writeln!(
                out,
                "# {name}: arc of radius {} mm, {:.1} deg, {} rows of axes.csv that are none here",
                lead.radius_mm,
                lead.angle_rad.to_degrees(),
                lead.centres.len()
            ),
            false => writeln!(out, "# {name}: straight along the tool axis{}", lead.why()),
        };
    }
    out.push_str("turn,S,s,cx,cy,cz,px,py,pz,nx,ny,nz,ix,iy,iz,theta_deg,theta_min_deg,theta_max_deg,feed_mm_min\n");
    let to_model = &blade.model_from_blade;
    for (k, l) in plan.toolpath.locations.iter().enumerate() {
        let (c, p) = (to_model * l.centre, to_model * l.contact);
        let (n, i) = (to_model * l.normal, to_model * plan.toolpath.cone(k).tool_axis(plan.schedule.theta[k]));
        let row = &plan.channel.rows[k];
        let _ = write!(out, "{},{},{}", l.turn, l.turn_s_mm, l.s_mm);
        for v in [c.coords, p.coords, n, i] {
            let _ = write!(out, ",{},{},{}", v.x, v.y, v.z);
        }
        let _ = writeln!(
            out,
            ",{},{},{},{}",
            plan.schedule.theta[k].to_degrees(),
            row.theta_min.to_degrees(),
            row.theta_max.to_degrees(),
            plan.motion.feed[k] * 60.0
        );
    }
    out
}

/// A deviation map's corners: model frame, mm; the height is empty where the ball does not come.
pub fn deviation(blade: &Blade, map: &DeviationMap) -> String {
    let mut out =
        String::from("# bladewright deviation map; model frame, mm; height of the machined surface along the normal\n");
    out.push_str("x,y,z,nx,ny,nz,height\n");
    let to_model = &blade.model_from_blade;
    for ((p, n), h) in map.points.iter().zip(&map.normals).zip(&map.heights_mm) {
        let (p, n) = (to_model * p, to_model * n);
        let _ = write!(out, "{},{},{},{},{},{},", p.x, p.y, p.z, n.x, n.y, n.z);
        let _ = if h.is_nan() { writeln!(out) } else { writeln!(out, "{h}") };
    }
    out
}

/// `axes.csv`: time in seconds; linear axes in mm, rotary axes in degrees, and their derivatives
/// per second. The leads' rows stand before and behind those of the cutter locations.
pub fn axes(plan: &Plan, axes: &[Axis]) -> String {
    let [before, after] = &plan.leads;
    let mut out = String::with_capacity(400 * plan.motion.t_s.len() + 200);
    out.push_str("t_s");
    for prefix in ["", "v", "a", "j"] {
        for axis in axes {
            let _ = write!(out, ",{prefix}{}", axis.name);
        }
    }
    out.push('\n');
    for m in [&before.motion, &plan.motion, &after.motion] {
        for (k, t_s) in m.t_s.iter().enumerate() {
            let _ = write!(out, "{t_s}");
            for row in [&m.position, &m.velocity, &m.acceleration, &m.jerk].into_iter().filter_map(|rows| rows.get(k)) {
                for (axis, value) in axes.iter().zip(row.iter()) {
                    let _ = write!(out, ",{}", axis.shown(*value));
                }
            }
            out.push('\n');
        }
    }
    out
}

/// Numbers that are the same but for rounding on the way through another program, relative to 1 or
/// to their size.
const SAME: f64 = 1e-9;

/// A table that is not the one it should be.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Difference {
    /// Cells that differ, a header or a row that is missing or too many among them.
    pub count: usize,
    /// The first: its line, its column, and both values.
    pub first: String,
}

/// Compares the text of a table with the one that its plan gives: header, number of rows, every
/// cell. Lines that begin with `#` are passed over.
pub fn difference(is: &str, want: &str) -> Difference {
    let mut out = Difference::default();
    let mut add = |says: String| {
        if out.count == 0 {
            out.first = says;
        }
        out.count += 1;
    };
    let rows = |text| str::lines(text).enumerate().filter(|(_, l): &(usize, &str)| !l.starts_with('#'));
    let (mut read, mut made) = (rows(is), rows(want));
    let (header, wanted) = (read.next().map_or("", |(_, l)| l.trim_end()), made.next().map_or("", |(_, l)| l));
    if header != wanted {
        add(format!("the header is `{}`, it must be `{wanted}`", start_of(header)));
        return out;
    }
    let columns: Vec<&str> = wanted.split(',').collect();
    loop {
        match (read.next(), made.next()) {
            (None, None) => return out,
            (None, Some((_, row))) => add(format!("a row is missing: `{}`", start_of(row))),
            (Some((n, row)), None) => add(format!("line {}: a row too many: `{}`", n + 1, start_of(row))),
            (Some((n, row)), Some((_, by_plan))) => {
                let (is, want) = (row.trim_end().split(','), by_plan.split(','));
                if is.clone().count() != columns.len() {
                    add(format!("line {}: {} cells, the header has {}", n + 1, is.count(), columns.len()));
                    continue;
                }
                for ((is, want), column) in is.zip(want).zip(&columns) {
                    if !is_same(is, want) {
                        add(format!("line {}, column {column}: {}, by plan.json {want}", n + 1, start_of(is)));
                    }
                }
            }
        }
    }
}

fn is_same(is: &str, want: &str) -> bool {
    let numbers = is.trim().parse::<f64>().ok().zip(want.parse::<f64>().ok());
    is == want || numbers.is_some_and(|(a, b)| (a - b).abs() <= SAME * b.abs().max(1.0))
}

/// The beginning of a text from a file, fit to be shown.
fn start_of(text: &str) -> String {
    text.chars().take(120).map(|c| if c.is_control() { '?' } else { c }).collect()
}

/// Puts the cutter locations and angles of a `cutter_locations.csv` into a plan of as many rows.
///
/// # Errors
/// Kind `InputOutput`, with the line, where a row is missing, has another number of columns or is
/// not a number.
pub fn read_cutter_locations(text: &str, blade: &Blade, plan: &mut Plan) -> Result<()> {
    let bad = |line: usize, what: String| {
        Err(Error::io(Stage::Output, format!("cutter_locations.csv, line {line}: {what}"))
            .advise("plan again to write it anew"))
    };
    let to_blade = blade.model_from_blade.inverse();
    let mut row = 0;
    let mut columns = 0;
    for (n, line) in text.lines().enumerate().filter(|(_, l)| !l.starts_with('#')) {
        if columns == 0 {
            columns = line.split(',').count();
            if columns != 19 {
                return bad(n + 1, format!("the header has {columns} columns, 19 are needed"));
            }
            continue;
        }
        let values: Vec<f64> = line.split(',').filter_map(|v| v.trim().parse().ok()).collect();
        let Ok(v) = <[f64; 19]>::try_from(values) else {
            return bad(n + 1, "19 numbers are needed".into());
        };
        let Some(l) = plan.toolpath.locations.get_mut(row) else {
            return bad(n + 1, format!("the plan has only {row} cutter locations"));
        };
        l.centre = to_blade * Point::new(v[3], v[4], v[5]);
        l.contact = to_blade * Point::new(v[6], v[7], v[8]);
        l.normal = to_blade * Vector::new(v[9], v[10], v[11]);
        (l.turn, l.turn_s_mm, l.s_mm) = (v[0] as u32, v[1], v[2]);
        plan.schedule.theta[row] = v[15].to_radians();
        row += 1;
    }
    if row != plan.toolpath.locations.len() {
        return bad(
            text.lines().count(),
            format!("{row} rows, the plan has {} cutter locations", plan.toolpath.locations.len()),
        );
    }
    Ok(())
}
