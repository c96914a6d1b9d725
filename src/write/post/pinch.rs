//! Programs of two tools for LinuxCNC: nine letters, positions of the machine's axes, inverse time.
//!
//! LinuxCNC knows the letters X Y Z A B C U V W and moves them all in one clock. So a row of both
//! tools is an ordinary program for trivial kinematics of nine joints.

use std::fmt::Write;

use super::PostSettings;
use crate::artifact::Axes;
use crate::artifact::paired::PinchMotion;
use crate::machine::Machine;

/// Name of the file.
pub const FILE: &str = "pinch.ngc";

/// Decimals of positions, mm and degrees.
const DECIMALS: usize = 5;

/// What a program of two tools is made from.
pub struct PinchProgram<'a> {
    /// Name of the blade.
    pub name: &'a str,
    /// File of the part.
    pub part_file: &'a str,
    /// Hash of that file; empty: none.
    pub part_hash: &'a str,
    /// The machine, with two heads.
    pub machine: &'a Machine,
    /// What it does.
    pub motion: &'a PinchMotion,
    /// Numbers, speeds and feeds.
    pub settings: &'a PostSettings,
    /// From the gauge line to the tip of both tools, mm.
    pub to_tip_mm: f64,
}

/// The text of the program.
pub fn pinch_program(p: &PinchProgram) -> String {
    let axes = p.machine.axes();
    let word = |k: usize, at: f64| format!("{}{}", axes[k].name, number(axes[k].shown(at) * axes[k].word_per_mm()));
    let words = |columns: &[usize], row: &[f64]| -> String {
        columns.iter().map(|k| word(*k, row[*k])).collect::<Vec<_>>().join(" ")
    };
    let all: Vec<usize> = (0..axes.len()).collect();
    let linear: Vec<usize> = all.iter().copied().filter(|k| !axes[*k].is_rotary()).collect();
    let rotary: Vec<usize> = all.iter().copied().filter(|k| axes[*k].is_rotary()).collect();
    let ups: Vec<(usize, f64)> = (0..2).filter_map(|head| p.machine.retract_axis_of(head)).collect();
    let safe = |(k, sense): (usize, f64)| {
        axes[k].limits.travel.map(|[least, most]| if sense < 0.0 { least } else { most }).unwrap_or(0.0)
    };
    let up = |row: &[f64]| {
        let mut row = Axes::from(row);
        ups.iter().for_each(|u| row[u.0] = safe(*u));
        row
    };
    let up_columns: Vec<usize> = ups.iter().map(|u| u.0).collect();
    let sides: Vec<usize> = linear.iter().copied().filter(|k| !up_columns.contains(k)).collect();
    let letters: String = axes.iter().map(|a| a.name.as_str()).collect::<Vec<_>>().join(" ");
    let mut out = String::new();
    let mut line = |text: &str| {
        out.push_str(text);
        out.push('\n');
    };
    line(&format!(
        "; {} by bladewright {} for LinuxCNC: two tools on one blade",
        clean(p.name),
        env!("CARGO_PKG_VERSION")
    ));
    if !p.part_file.is_empty() {
        line(&format!(
            "; Part {}{}",
            clean(p.part_file),
            if p.part_hash.is_empty() { String::new() } else { format!(", BLAKE3 {}", p.part_hash) }
        ));
    }
    line(&format!(
        "; Machine {}: positions of its axes {letters}, mm and degrees, for trivial kinematics of these letters.",
        clean(&p.machine.name)
    ));
    line(&format!(
        "; Both tools must stand out {:.4} mm from the gauge line to their TIPS; any other length cuts elsewhere.",
        p.to_tip_mm
    ));
    line(
        "; Tool lengths, pivots and the place of the part are in the positions: no length offset (G49), G54 must be zero.",
    );
    line(
        "; Spindle $0 holds tool 1, spindle $1 tool 2, loaded before the start. With M3 on both one side climbs, the other cuts conventionally.",
    );
    line(&format!(
        "; {} rows in {} stretches; {} stands still while both cut.",
        rows(p.motion),
        p.motion.stretches.len(),
        axes[p.machine.turning_axis()].name
    ));
    line(&format!("; Cutting {:.1} s, without the ways from row to row.", p.motion.cutting_s));
    line(
        "; Relies on [KINS] trivkins with these letters, [TRAJ] SPINDLES = 2, and limits of the rotary axes that reach over all turns.",
    );
    line("G17 G21 G40 G49 G80 G90 G94");
    line("G54");
    line(&format!("G64 P{}", p.settings.smoothing_mm.unwrap_or(0.001)));
    let Some(first) = p.motion.stretches.first() else { return out };
    line(&format!("G53 G0 {}", words(&up_columns, &up(&first.over[0]))));
    line(&format!("S{} $0", number(p.settings.spindle_rpm)));
    line(&format!("S{} $1", number(p.settings.spindle_rpm)));
    line("M3 $0");
    line("M3 $1");
    line(&format!("G0 {}", words(&rotary, &first.over[0])));
    line(&format!("G0 {}", words(&sides, &first.over[0])));
    line("M8");
    for stretch in &p.motion.stretches {
        line(&format!("; Row {}, stretch {}", stretch.row + 1, stretch.stretch + 1));
        line(&format!("G0 {}", words(&all, &stretch.over[0])));
        let motion = &stretch.motion;
        let Some(last) = motion.position.len().checked_sub(1) else { continue };
        line("G93");
        let lift_s = |k: usize, feed: f64| 60.0 * stretch.lifts_mm[k][0].max(stretch.lifts_mm[k][1]) / feed;
        line(&format!("G1 {} F{}", words(&all, &motion.position[0]), rate(lift_s(0, p.settings.plunge_feed_mm_min))));
        for k in 1..=last {
            let seconds = motion.t_s[k] - motion.t_s[k - 1];
            line(&format!("G1 {} F{}", words(&all, &motion.position[k]), rate(seconds)));
        }
        line(&format!("G1 {} F{}", words(&all, &stretch.over[1]), rate(lift_s(1, p.settings.approach_feed_mm_min))));
        line("G94");
    }
    line("M9");
    if let Some(last) = p.motion.stretches.last() {
        line(&format!("G53 G0 {}", words(&up_columns, &up(&last.over[1]))));
    }
    line("M5 $0");
    line("M5 $1");
    line("M2");
    out
}

/// Rows of a motion.
fn rows(motion: &PinchMotion) -> usize {
    let mut rows: Vec<usize> = motion.stretches.iter().map(|s| s.row).collect();
    rows.dedup();
    rows.len()
}

/// A number without needless zeros.
fn number(value: f64) -> String {
    let mut text = String::new();
    let _ = write!(text, "{value:.DECIMALS$}");
    if text.contains('.') {
        text.truncate(text.trim_end_matches('0').trim_end_matches('.').len());
    }
    if text == "-0" { "0".into() } else { text }
}

/// Minutes of a line, inverted, with seven digits.
fn rate(seconds: f64) -> String {
    let per_minute = 60.0 / seconds.max(1e-6);
    let digits = (6.0 - per_minute.log10().floor()).clamp(0.0, 9.0) as usize;
    format!("{per_minute:.digits$}")
}

/// A name without what would end a comment or a line.
fn clean(text: &str) -> String {
    text.chars().map(|c| if c.is_control() || "();".contains(c) { ' ' } else { c }).collect()
}
