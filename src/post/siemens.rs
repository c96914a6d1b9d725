//! Siemens Sinumerik 840D: tool tip under `TRAORI`, rotary axes as axis positions.

use crate::error::Result;
use crate::geometry::Point;
use crate::tool;

use super::cut::{self, Cut};
use super::text::{Fixed, Lines, header};
use super::{End, RotaryWords, Run};

/// The whole program.
pub(super) fn write(run: &Run) -> Result<String> {
    let mut lines = Lines::new(true);
    header(run, &mut lines, "Siemens 840D");
    setup_notes(run, &mut lines);
    start(run, &mut lines)?;
    approach(run, &mut lines)?;
    cutting(run, &mut lines)?;
    finish(run, &mut lines)?;
    Ok(lines.text)
}

fn setup_notes(run: &Run, lines: &mut Lines) {
    let m = &run.machine.mount;
    let part = &run.blade.model_from_blade;
    let t = part.translation.vector;
    let r = part.rotation.to_rotation_matrix();
    lines.comment("X Y Z    tool TIP of the ball in the blade frame, mm: x along the blade axis from root to tip.");
    lines.comment(&format!(
        "         Tool length of D1: from the gauge line to the TIP, planned as {:.4} mm.",
        run.tool.length_mm() + run.tool.radius_mm
    ));
    lines.comment(&format!(
        "G54      origin of the blade frame at A=0: machine X {:.4} Y {:.4} Z {:.4}, turned about X by {:.4} deg.",
        m.offset_mm[0], m.offset_mm[1], m.offset_mm[2], m.clamping_deg
    ));
    lines.comment(&format!(
        "CAD      point of the CAD model = M (x, y, z) + ({:.6}, {:.6}, {:.6}) with M =",
        t.x, t.y, t.z
    ));
    for row in r.matrix().row_iter() {
        // Adding 0 turns a rounded -0 into 0.
        let [x, y, z] = [row[0], row[1], row[2]].map(|v| (v * 1e9).round() / 1e9 + 0.0);
        lines.comment(&format!("         [{x:.9} {y:.9} {z:.9}]"));
    }
    lines
        .comment("ORIAXES  rotary axes move straight from line to line. B is fixed, so the tool axis stays on a cone;");
    lines.comment("         interpolation of vectors (ORIVECT) would leave the cone and move B.");
    match run.options.rotary {
        RotaryWords::Incremental => {
            lines.comment(
                "A        first position within one turn, then steps A=IC(): the same on modulo and linear axes.",
            );
        }
        RotaryWords::Accumulate => {
            lines.comment("A        absolute over all turns: A must not be a modulo axis (MD30310 ROT_IS_MODULO = 0).");
        }
    }
    lines.comment("F        G93, 1/min: each line takes 1/F minutes.");
}

/// Words of a tip position.
fn tip_words(run: &Run, tip: &Point) -> Result<String> {
    let d = run.options.length_decimals;
    let [x, y, z] = [Fixed::new(tip.x, d)?, Fixed::new(tip.y, d)?, Fixed::new(tip.z, d)?];
    Ok(format!("X{x} Y{y} Z{z}"))
}

/// `A` in degrees as the program counts it: whole turns before the first location are dropped for steps.
fn a_deg(run: &Run, a_rad: f64) -> f64 {
    let a = a_rad.to_degrees();
    match run.options.rotary {
        RotaryWords::Accumulate => a,
        RotaryWords::Incremental => {
            let first = run.plan.motion.position.first().map_or(0.0, |q| q[3].to_degrees());
            a - 360.0 * (first / 360.0).floor()
        }
    }
}

fn safe_z(run: &Run) -> String {
    run.machine.limits()[2].travel.map_or_else(|| "0".into(), |[_, hi]| format!("{hi:.3}"))
}

fn start(run: &Run, lines: &mut Lines) -> Result<()> {
    let (o, end) = (run.options, &run.ends[0]);
    lines.block("G17 G40 G90 G94 G710");
    lines.block("TRAFOOF");
    lines.block(&format!("SUPA G0 Z={} D0 ; safe height: end of travel in Z", safe_z(run)));
    lines.block(&format!("T{} M6", o.tool_number));
    lines.block(&format!("S{:.0} M3", o.spindle_rpm));
    let a = Fixed::new(a_deg(run, run.axes_at(end, 0.0)[3]), o.angle_decimals)?;
    let b = Fixed::new(run.b_rad().to_degrees(), o.angle_decimals)?;
    lines.block(&format!("G0 A={a} B={b}"));
    // Over the part in machine axes: a first move of X and Y under TRAORI would follow the turned part, not the bed.
    let over = run.axes_at(end, end.safe_mm);
    lines.block(&format!(
        "SUPA G0 X={} Y={} D0 ; over the safe position, by the machine file",
        Fixed::new(over[0], 3)?,
        Fixed::new(over[1], 3)?
    ));
    lines.block("D1");
    lines.block("TRAORI");
    lines.block("G54");
    lines.block("ORIWKS ORIAXES");
    let tolerance = o.smoothing_mm.unwrap_or(run.plan.toolpath.chord_mm);
    lines.block(&format!(
        "CYCLE832({},11,{}) ; finishing: tolerance in mm, tolerance of the tool axis in degrees",
        Fixed::new(tolerance, 5)?,
        Fixed::new(o.smoothing_axis_deg, 4)?
    ));
    lines.block("SOFT FFWON");
    Ok(())
}

fn approach(run: &Run, lines: &mut Lines) -> Result<()> {
    let (o, end) = (run.options, &run.ends[0]);
    let safe = run.tip_at(end, end.safe_mm);
    lines.comment("Down to the safe position, then along the tool axis");
    lines.block(&format!("G0 {}", tip_words(run, &safe)?));
    lines.block(&format!(
        "G94 G1 {} F{:.0} M8",
        tip_words(run, &run.tip_at(end, run.feed_height(end)))?,
        o.approach_feed_mm_min
    ));
    lines.block(&format!("G1 {} F{:.0}", tip_words(run, &run.tip_at(end, 0.0))?, o.plunge_feed_mm_min));
    Ok(())
}

fn cutting(run: &Run, lines: &mut Lines) -> Result<()> {
    let plan = run.plan;
    let (b, radius) = (run.b_rad(), run.tool.radius_mm);
    let rows =
        plan.toolpath.locations.iter().zip(&plan.schedule.theta).zip(&plan.motion.position).map(|((l, &theta), q)| {
            let tip = tool::tip(&l.centre, &tool::axis(b, theta), radius);
            [tip.x, tip.y, tip.z, a_deg(run, q[3])]
        });
    let (d, e) = (run.options.length_decimals, run.options.angle_decimals);
    lines.comment("Cutting");
    lines.block("G93");
    for cut in cut::cuts(rows, &plan.motion.t_s, [d, d, d, e])? {
        lines.block(&line(run.options.rotary, &cut));
    }
    lines.block("G94");
    Ok(())
}

fn line(rotary: RotaryWords, cut: &Cut<4>) -> String {
    let [x, y, z, a] = cut.words;
    match rotary {
        RotaryWords::Accumulate => format!("G1 X{x} Y{y} Z{z} A={a} F{}", cut.feed),
        RotaryWords::Incremental => format!("G1 X{x} Y{y} Z{z} A=IC({}) F{}", a.since(cut.before[3]), cut.feed),
    }
}

fn finish(run: &Run, lines: &mut Lines) -> Result<()> {
    let (o, end): (_, &End) = (run.options, &run.ends[1]);
    lines.comment("Retract along the tool axis");
    lines.block(&format!(
        "G94 G1 {} F{:.0}",
        tip_words(run, &run.tip_at(end, run.feed_height(end)))?,
        o.plunge_feed_mm_min
    ));
    lines.block(&format!("G1 {} F{:.0} M9", tip_words(run, &run.tip_at(end, end.safe_mm))?, o.approach_feed_mm_min));
    lines.block("CYCLE832(0,0,1)");
    lines.block("TRAFOOF");
    lines.block(&format!("SUPA G0 Z={} D0", safe_z(run)));
    if run.ends.iter().all(|e| e.clear) {
        let a = Fixed::new(a_deg(run, run.axes_at(&run.ends[0], 0.0)[3]), o.angle_decimals)?;
        lines.comment(
            "Unwind of A: back to its first position. Less than a turn on a modulo axis, all turns on a linear one.",
        );
        lines.block(&format!("G0 A={a}"));
    }
    lines.block("M5");
    lines.block("M30");
    Ok(())
}
