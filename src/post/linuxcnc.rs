//! LinuxCNC with trivial kinematics: positions of the machine's axes.

use crate::error::Result;

use super::Run;
use super::cut;
use super::text::{Fixed, Lines, header};

/// The whole program.
pub(super) fn write(run: &Run) -> Result<String> {
    let mut lines = Lines::new(false);
    header(run, &mut lines, "LinuxCNC");
    setup_notes(run, &mut lines);
    start(run, &mut lines)?;
    cutting(run, &mut lines)?;
    finish(run, &mut lines)?;
    Ok(lines.text)
}

fn setup_notes(run: &Run, lines: &mut Lines) {
    lines.comment(
        "X Y Z    positions of the machine's axes, mm, for trivial kinematics XYZAB: the tool's length, the head's",
    );
    lines.comment("         pivot and the place of the part are in them. No length offset (G49); G54 must be zero.");
    lines.comment(&format!(
        "         The tool must stand out {:.4} mm from the gauge line to its TIP; any other length cuts elsewhere.",
        run.tool.length_mm() + run.tool.radius_mm
    ));
    lines.comment("A        degrees, growing over all turns: A must not be WRAPPED_ROTARY.");
    lines.comment("F        G93, 1/min: each line takes 1/F minutes.");
    lines.comment(
        "G64      LinuxCNC blends corners of straight lines only: with a rotary word on every line it slows down",
    );
    lines.comment(
        "         at every location unless its planner can keep the speed; expect a longer time than planned.",
    );
}

/// Words of an axis position (mm, rad).
fn words(run: &Run, q: &[f64; 5]) -> Result<[Fixed; 5]> {
    let (d, e) = (run.options.length_decimals, run.options.angle_decimals);
    cut::rounded(&degrees(q), &[d, d, d, e, e])
}

fn degrees(q: &[f64; 5]) -> [f64; 5] {
    [q[0], q[1], q[2], q[3].to_degrees(), q[4].to_degrees()]
}

fn xyz(run: &Run, q: &[f64; 5]) -> Result<String> {
    let [x, y, z, ..] = words(run, q)?;
    Ok(format!("X{x} Y{y} Z{z}"))
}

fn top(run: &Run) -> Result<Fixed> {
    let here = run.axes_at(&run.ends[0], run.ends[0].safe_mm)[2];
    Fixed::new(run.machine.limits()[2].travel.map_or(here, |[_, hi]| hi), run.options.length_decimals)
}

fn start(run: &Run, lines: &mut Lines) -> Result<()> {
    let (o, end) = (run.options, &run.ends[0]);
    let safe = run.axes_at(end, end.safe_mm);
    let [x, y, _, a, b] = words(run, &safe)?;
    lines.block("G17 G21 G40 G49 G80 G90 G94");
    lines.block("G54");
    lines.block(&format!("G64 P{}", Fixed::new(o.smoothing_mm.unwrap_or(run.plan.toolpath.chord_mm), 5)?));
    lines.block(&format!("G53 G0 Z{}", top(run)?));
    lines.block(&format!("T{} M6", o.tool_number));
    lines.block("G49");
    lines.block(&format!("S{:.0} M3", o.spindle_rpm));
    lines.comment("Approach along the tool axis");
    lines.block(&format!("G0 A{a} B{b}"));
    lines.block(&format!("G0 X{x} Y{y}"));
    lines.block(&format!("G0 {}", xyz(run, &safe)?));
    lines.block("M8");
    let height = run.axes_at(end, run.feed_height(end));
    lines.block(&format!("G1 {} F{:.0}", xyz(run, &height)?, o.approach_feed_mm_min));
    lines.block(&format!("G1 {} F{:.0}", xyz(run, &run.axes_at(end, 0.0))?, o.plunge_feed_mm_min));
    Ok(())
}

fn cutting(run: &Run, lines: &mut Lines) -> Result<()> {
    let (d, e) = (run.options.length_decimals, run.options.angle_decimals);
    let rows = run.plan.motion.position.iter().map(degrees);
    lines.comment("Cutting");
    lines.block("G93");
    for cut in cut::cuts(rows, &run.plan.motion.t_s, [d, d, d, e, e])? {
        let [x, y, z, a, b] = cut.words;
        lines.block(&format!("G1 X{x} Y{y} Z{z} A{a} B{b} F{}", cut.feed));
    }
    lines.block("G94");
    Ok(())
}

fn finish(run: &Run, lines: &mut Lines) -> Result<()> {
    let (o, end) = (run.options, &run.ends[1]);
    lines.comment("Retract along the tool axis");
    let height = run.axes_at(end, run.feed_height(end));
    lines.block(&format!("G1 {} F{:.0}", xyz(run, &height)?, o.plunge_feed_mm_min));
    lines.block(&format!("G1 {} F{:.0}", xyz(run, &run.axes_at(end, end.safe_mm))?, o.approach_feed_mm_min));
    lines.block("M9");
    lines.block(&format!("G53 G0 Z{}", top(run)?));
    if run.ends.iter().all(|e| e.clear) {
        lines.comment("Unwind of A: back to its first position, over all turns.");
        lines.block(&format!("G0 A{}", words(run, &run.axes_at(&run.ends[0], 0.0))?[3]));
    }
    lines.block("M5");
    lines.block("M2");
    Ok(())
}
