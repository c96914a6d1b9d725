//! A program of others, written whole for other controls.
//!
//! Its feed moves are plans with the program's own checks as evidence ([`audit::as_plans`]); each
//! run of feed moves becomes an operation of the new program, with the approach and the retract
//! that all programs have. The new program is read back as every program is, against these plans.

use serde::Serialize;

use crate::artifact::program::Program;
use crate::artifact::report::Check;
use crate::artifact::{Blade, Plan};
use crate::error::{Error, ErrorKind, Missed, Result, Stage};
use crate::observe::Observer;
use crate::read::program::Bench;
use crate::verify::audit::{self, AuditOptions, ProgramPlans};
use crate::verify::read_back::{self, read_back_each};
use crate::verify::{Verdict, Verified};
use crate::write::post::{self, Dialect, Operation, PostOptions};

/// A program that was written anew.
#[derive(Clone, Debug, Serialize)]
pub struct WrittenAnew {
    /// The program.
    #[serde(skip)]
    pub program: Program,
    /// Its file.
    pub file: String,
    /// The control, in words.
    pub control: String,
    /// Lines.
    pub lines: usize,
    /// Time with all ways to the part and back, without tool changes, s.
    pub time_s: f64,
    /// Its operations: runs of feed moves.
    pub operations: usize,
    /// Runs of feed moves that come nowhere to the part, left out.
    pub left_out: usize,
    /// Names of the checks that the program it was made from fails, or its ways to the part: the
    /// header says so.
    pub failed: Vec<String>,
    /// What reading it back found; all passed.
    pub checks: Vec<Check>,
}

/// Before the name of a dialect's file: the program beside it may have the same.
const BEFORE: &str = "anew.";

/// Writes a program that cuts with a ball in dialects, see the module's page. Of `options` the
/// tool's number and the spindle's speed are taken where the program does not say them.
///
/// # Errors
/// As [`audit::as_plans`] and [`post::join`]; kind `Findings` where a new program, read back, does
/// not do what the old one does.
pub fn programs(
    (text, bench): (&str, &Bench),
    blade: &Blade,
    audit: &AuditOptions,
    dialects: &[Dialect],
    options: &PostOptions,
    observer: &dyn Observer,
) -> Result<Vec<WrittenAnew>> {
    if dialects.is_empty() {
        return Ok(Vec::new());
    }
    let ProgramPlans { plans, setting, tool, left_out, .. } = audit::as_plans(text, blade, bench, audit, observer)?;
    let mut options = options.clone();
    options.settings.tool_number = tool.and_then(|t| t.parse().ok()).unwrap_or(options.settings.tool_number);
    options.settings.spindle_rpm = setting.rpm.filter(|rpm| *rpm > 0.0).unwrap_or(options.settings.spindle_rpm);
    let mut failed: Vec<String> = Vec::new();
    for Missed { check, .. } in plans.iter().flat_map(|p| p.report().missed()) {
        if !failed.contains(&check) {
            failed.push(check);
        }
    }
    let verified: Vec<Verified<Plan>> = plans
        .into_iter()
        .map(|verdict| match verdict {
            Verdict::Passed(plan) => plan,
            Verdict::Failed(found) => found.write_anyway(),
        })
        .collect();
    let operations: Vec<Operation> =
        verified.iter().map(|plan| Operation { plan, tool: bench.tool, options: &options }).collect();
    let read: Vec<read_back::Operation> =
        verified.iter().map(|v| read_back::Operation { plan: v.value(), tool: bench.tool }).collect();
    let one = |dialect: &Dialect| {
        observer.check(Stage::Post)?;
        let mut program = post::join(dialect, &operations, 1, blade, bench.machine)?;
        let checks = read_back_each(&program, &read, blade, bench.machine)?;
        if let Some(bad) = checks.iter().find(|c| !c.passed) {
            let message = format!(
                "{}: read back, the program fails the check {}: {:.6} {}, limit {}; {}",
                program.control, bad.id, bad.worst, bad.unit, bad.limit, bad.note
            );
            return Err(Error::new(Stage::Post, ErrorKind::Findings, message)
                .advise("write it for another control, or as positions of axes (iso, linuxcnc)"));
        }
        program.file_name = format!("{BEFORE}{}", program.file_name);
        Ok(WrittenAnew {
            file: program.file_name.clone(),
            control: program.control.clone(),
            lines: program.text.lines().count(),
            time_s: program.cycles.iter().map(|c| c.total_s).sum(),
            operations: operations.len(),
            left_out,
            failed: failed.clone(),
            checks,
            program,
        })
    };
    dialects.iter().map(one).collect()
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used)]
    use super::*;
    use crate::artifact::program::{Control, Grammar, Language, Programmed};
    use crate::machine::Machine;
    use crate::observe::Silent;
    use crate::read::program::Zero;
    use crate::sample;

    const ISO: Language = Language {
        grammar: Grammar::Gcode,
        programmed: Programmed::Machine,
        shortest_way: false,
        feed_counts_degrees: false,
    };

    /// Over a cylinder of radius 20 along x and back, B = 0, the gauge line 140 mm over its top;
    /// on the way back the part turns under the ball. Then a move through the air.
    const THEIRS: &str = "T3 M6\nG90 G94 G0 A0 B0 S4500 M3\nG0 X1410 Y0 Z300\nG1 Z160 F500\nG1 X1450\nG1 Z170\n\
                          G0 Z300\nG0 A30\nG1 Z160 F600\nG1 X1410\nG1 A75 F900\nG0 Z300\nG1 X1400 F900\nG0 X1450\nM30\n";

    fn written(text: &str, controls: &[Control]) -> Result<Vec<WrittenAnew>> {
        let (tool, machine) = (sample::tool(), Machine::demo().unwrap());
        let bench = Bench { language: ISO, zero: Zero::default(), tool: &tool, machine: &machine };
        let audit = AuditOptions::default().with(|s| s.surface_samples = 2000);
        let dialects: Vec<Dialect> = controls.iter().map(|c| Dialect::built_in(*c).unwrap()).collect();
        programs((text, &bench), &sample::blade(), &audit, &dialects, &PostOptions::default(), &Silent)
    }

    #[test]
    fn every_control_gets_the_feed_moves_of_the_program() {
        let (tool, machine, blade) = (sample::tool(), Machine::demo().unwrap(), sample::blade());
        let all = written(THEIRS, &Control::ALL).unwrap();
        assert_eq!(all.len(), Control::ALL.len());
        for one in &all {
            assert_eq!((one.operations, one.left_out, one.failed.len()), (2, 1, 0), "{one:?}");
            let (asked, name) = (&one.program.asked, &one.file);
            assert!(asked.len() == 2 && asked.iter().all(|a| (a.tool_number, a.spindle_rpm) == (3, 4500.0)), "{name}");
            // Read and judged as a program of others it leaves what the old one left.
            let bench = Bench { language: one.program.language, zero: Zero::default(), tool: &tool, machine: &machine };
            let audit = AuditOptions::default().with(|s| s.surface_samples = 2000);
            for found in audit::audit_each(&one.program.text, &blade, &[bench; 2], &audit, &Silent).unwrap() {
                assert!(found.passed(), "{name}: {found:?}");
            }
            // 140 + 40 + 10 mm at F500, 140 + 40 mm at F600, 45° at F900, and the new ways.
            let cut: f64 = one.program.cycles.iter().map(|c| c.cutting_s).sum();
            let theirs = 60.0 * (190.0 / 500.0 + 180.0 / 600.0 + 45.0 / 900.0);
            assert!((cut / theirs - 1.0).abs() < 1e-3, "{name}: {cut} s, {theirs} s");
        }
    }

    #[test]
    fn lines_take_the_time_that_axes_need() {
        // 45° in no time at all: A turns by 180 degrees a second at most.
        let fast = written(&THEIRS.replace("A75 F900", "A75 F900000"), &[Control::Iso]).unwrap();
        assert!(fast[0].failed.is_empty(), "{fast:?}");
        let cut: f64 = fast[0].program.cycles.iter().map(|c| c.cutting_s).sum();
        let least = 60.0 * (190.0 / 500.0 + 180.0 / 600.0) + 0.25;
        assert!((cut / least - 1.0).abs() < 1e-3, "{cut} s, {least} s");
    }

    #[test]
    fn a_part_that_turns_under_the_ball_is_followed_between_lines() {
        let (tool, machine, blade) = (sample::tool(), Machine::demo().unwrap(), sample::blade());
        let bench = Bench { language: ISO, zero: Zero::default(), tool: &tool, machine: &machine };
        let made = audit::as_plans(THEIRS, &blade, &bench, &AuditOptions::default(), &Silent).unwrap();
        assert_eq!((made.plans.len(), made.left_out, made.tool.as_deref()), (2, 1, Some("3")));
        let second = made.plans[1].value();
        let turned: Vec<_> = second.stands().into_iter().filter(|s| (s.centre.x - 10.0).abs() < 1e-9).collect();
        // 45° of 23 mm in one straight line would cut 1.7 mm deep.
        assert!(turned.len() > 20, "{}", turned.len());
        let radius = sample::PART_RADIUS + tool.radius_mm;
        for w in turned.windows(2) {
            let middle = nalgebra::center(&w[0].centre, &w[1].centre);
            assert!((radius - middle.y.hypot(middle.z)).abs() < 0.001, "{middle}");
        }
    }

    #[test]
    fn what_the_program_fails_stands_in_the_header_and_nothing_to_write_is_an_error() {
        let deep = written(&THEIRS.replace("G1 Z160 F600", "G1 Z159.9 F600"), &[Control::Linuxcnc]).unwrap();
        assert_eq!(deep[0].failed, ["gouge", "rapid", "lead-gouge"]);
        assert!(deep[0].program.text.contains("NOT VERIFIED"), "{}", deep[0].program.text);
        let away = written(&THEIRS.replace("Z160", "Z260"), &[Control::Linuxcnc]).unwrap_err();
        assert!(away.message.contains("nowhere to the part"), "{away}");
        assert!(written(THEIRS, &[]).unwrap().is_empty());
    }
}
