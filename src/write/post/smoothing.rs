//! How far the control may leave the programmed path for the sake of speed.
//!
//! What a control smooths away it may take off the part. Where the post file says in which steps
//! the control computes (`resolution_mm`), the tolerance is therefore what the checks leave of the
//! gouge limit,
//!
//! ```text
//! room = limit − gouge found − ½ chord tolerance
//! ```
//!
//! in whole steps: less than a step cannot be kept, so it is one at least, and the header says
//! where that is more than there is room for. Half of the chord tolerance is what lines may be off
//! the path already. Where the tool tip is programmed, a tool axis that is off by δ takes the ball
//! centre along by `R δ`: what the tolerance leaves of the room bounds that too.

use super::OperationRun;
use super::dialect::PostFile;
use crate::artifact::CheckId;
use crate::artifact::program::Programmed;

/// Step in which a control computes angles, degrees: with its default of 1000 increments a degree.
const STEP_DEG: f64 = 0.001;

/// Tolerances for the control.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Smoothing {
    /// Of positions, mm.
    pub(super) mm: f64,
    /// Of the tool axis, degrees.
    pub(super) axis_deg: f64,
    /// By how much the part may be cut deeper than the gouge limit, mm.
    pub(super) beyond_mm: f64,
}

/// Tolerances of an operation in a dialect.
pub(super) fn of(run: &OperationRun, file: &PostFile) -> Smoothing {
    let (asked_mm, chord_mm) = (run.options.settings.smoothing_mm, run.plan.toolpath.chord_mm);
    let asked = Smoothing { mm: 0.0, axis_deg: run.options.smoothing_axis_deg, beyond_mm: 0.0 };
    let (Some(step), None) = (file.resolution_mm, asked_mm) else {
        return Smoothing { mm: asked_mm.unwrap_or(chord_mm) * file.tolerance_factor, ..asked };
    };
    let gouges = run.report.checks.iter().filter(|c| [CheckId::Gouge, CheckId::GougeSurface].contains(&c.id));
    let left = gouges.map(|c| c.limit - c.worst.max(0.0)).fold(f64::INFINITY, f64::min);
    let room = if left.is_finite() { left - 0.5 * chord_mm } else { 0.0 };
    // A millionth more, so that a room of two steps is not one for its last digit.
    let mm = ((room / step + 1e-6).floor() * step).max(step);
    let axis_deg = match file.programmed {
        Programmed::Tip => {
            let turn = ((room - mm) / run.tool.radius_mm).to_degrees();
            ((turn / STEP_DEG).floor() * STEP_DEG).clamp(STEP_DEG, asked.axis_deg.max(STEP_DEG))
        }
        Programmed::Centre | Programmed::Machine => asked.axis_deg,
    };
    Smoothing { mm, axis_deg, beyond_mm: (mm - room).max(0.0) }
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used)]
    use super::*;
    use crate::artifact::program::Control;
    use crate::machine::Machine;
    use crate::sample;
    use crate::write::post::{Dialect, PostOptions, ends};

    #[test]
    fn the_tolerance_is_what_the_gouge_limit_leaves_and_never_below_a_step() {
        let (blade, tool, machine) = (sample::blade(), sample::tool(), Machine::demo().unwrap());
        let (mut plan, options) = (sample::plan(1, 60), PostOptions::default());
        plan.toolpath.chord_mm = 0.0004;
        let siemens = Dialect::built_in(Control::Siemens).unwrap().file;
        let with = |worst: f64, options: &PostOptions, file: &PostFile| {
            let mut report = sample::report();
            report.checks[0].worst = worst;
            let ends = ends(&plan, &(&blade).into(), &tool, &machine, options).unwrap();
            let (plan, report) = (&plan, &report);
            let (blade, tool, machine) = (&blade, &tool, &machine);
            of(&OperationRun { number: 1, plan, report, forced: false, blade, tool, machine, options, ends }, file)
        };
        // Limit 0.003, chord 0.0004: 0.003 - 0.00087 - 0.0002 leaves one step of a micrometre, and
        // 0.93 µm for the tool axis.
        let s = with(0.00087, &options, &siemens);
        assert!((s.mm - 0.001).abs() < 1e-12 && s.beyond_mm == 0.0, "{s:?}");
        let off_mm = s.axis_deg.to_radians() * tool.radius_mm;
        assert!(s.axis_deg >= STEP_DEG && s.mm + off_mm + 0.0002 + 0.00087 <= 0.003, "{s:?}");
        assert!((with(0.0008, &options, &siemens).mm - 0.002).abs() < 1e-12);
        // No room: a step all the same, and the header says so.
        let s = with(0.0029, &options, &siemens);
        assert!((s.mm - 0.001).abs() < 1e-12 && (s.beyond_mm - 0.0011).abs() < 1e-9, "{s:?}");
        // What is asked for, and controls that have another rule.
        let asked = PostOptions::default().with(|s| s.smoothing_mm = Some(0.005));
        assert_eq!(with(0.0029, &asked, &siemens), Smoothing { mm: 0.005, axis_deg: 0.05, beyond_mm: 0.0 });
        let tnc = Dialect::built_in(Control::Heidenhain).unwrap().file;
        assert!((with(0.0008, &options, &tnc).mm - 0.0006).abs() < 1e-12);
    }
}
