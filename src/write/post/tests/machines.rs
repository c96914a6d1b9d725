//! Machines whose axes are others than the demo machine's.

use super::*;
use crate::artifact::program::Programmed;
use crate::artifact::{AxisRows, CheckId};
use crate::geometry::Vector;
use crate::machine::{Carries, DEMO_TOML, MachineFile, PositiveA, PositiveB};
use crate::read::program;

/// Both rotary axes turn the other way, and the spindle's axis passes the pivot by.
fn other() -> Machine {
    let mut m = MachineFile::from_toml(DEMO_TOML, "demo").unwrap();
    let (head, table) = (m.head.as_mut().unwrap(), m.table.as_mut().unwrap());
    head.positive_b_leans = PositiveB::MinusX;
    head.spindle_offset_mm = 12.5;
    table.positive_a_turns = PositiveA::Workpiece;
    m.build("demo").unwrap()
}

/// The sample's plan with the axes of a machine.
fn plan(machine: &Machine) -> Plan {
    let mut plan = sample::with_leads(sample::plan(2, 60));
    let gauge = sample::tool().length_mm();
    let rows: AxisRows = plan.rows().map(|r| machine.place(&r.stand, None, gauge)).collect();
    let [first, last] = [plan.leads[0].centres.len(), rows.len() - plan.leads[1].centres.len()];
    plan.leads[0].motion.position = rows.part(0..first);
    plan.motion.position = rows.part(first..last);
    plan.leads[1].motion.position = rows.part(last..rows.len());
    plan
}

/// The small part of the sample stands about anywhere on most machines: there, rapids are judged
/// with real parts.
const RAPIDS: &[CheckId] = &[CheckId::ProgramRapids];

/// The program of a plan in a dialect, which reads back clean but for checks that say nothing here.
fn read_back_clean(control: Control, plan: &Plan, machine: &Machine, besides: &[CheckId]) -> Program {
    let (blade, tool) = (sample::blade(), sample::tool());
    let verified = Verified::for_tests(plan.clone(), sample::report(), false);
    let dialect = Dialect::built_in(control).unwrap();
    let program = post(&dialect, &verified, &blade, &tool, machine, &options()).unwrap();
    let checks = read_back(&program, plan, &blade, &tool, machine).unwrap();
    let bad: Vec<_> = checks.iter().filter(|c| !c.passed && !besides.contains(&c.id)).collect();
    assert!(bad.is_empty(), "{} {control:?}: {bad:#?}", machine.name);
    program
}

/// The ball of a program touches the part at a location, and the tool axis is the plan's.
fn touches_as_planned(p: &Program, plan: &Plan, machine: &Machine) {
    let tool = sample::tool();
    let bench = program::Bench { language: p.language, zero: program::Zero::default(), tool: &tool, machine };
    let moves = program::follow(&program::read(&p.text, p.language).unwrap().blocks, &bench).unwrap();
    let near = |c: &Point| (c - plan.toolpath.locations[30].centre).norm() < 1e-3;
    let pose = moves.iter().map(|m| m.pose(1.0, &tool, machine)).find(|q| near(&q.centre)).unwrap();
    assert!((pose.axis - plan.stand(30).unwrap().axis()).norm() < 1e-5, "{:?}", p.language);
}

#[test]
fn every_dialect_reads_back_on_a_machine_that_turns_the_other_way() {
    let machine = other();
    let plan = plan(&machine);
    for control in Control::ALL {
        let p = read_back_clean(control, &plan, &machine, &[]);
        if control != Control::Apt {
            assert!(p.text.contains("B-5.0") || p.text.contains("B=-5.0"), "{control:?}");
        }
        // The tool leans the same way over the part.
        touches_as_planned(&p, &plan, &machine);
        // With the machine file of the demo machine the same text is another motion.
        let wrong = read_back(&p, &plan, &sample::blade(), &sample::tool(), &Machine::demo().unwrap()).unwrap();
        let vectors = [Control::SiemensVector, Control::HeidenhainVector, Control::FanucVector, Control::Apt];
        assert!(vectors.contains(&control) || wrong.iter().any(|c| !c.passed), "{control:?}");
    }
}

#[test]
fn lines_that_cut_end_where_the_plan_is_at_their_times() {
    let (machine, tool) = (Machine::demo().unwrap(), sample::tool());
    let plan = plan(&machine);
    let rows: Vec<_> = plan.rows().collect();
    for control in Control::ALL {
        let p = read_back_clean(control, &plan, &machine, &[]);
        let bench =
            program::Bench { language: p.language, zero: program::Zero::default(), tool: &tool, machine: &machine };
        let moves = program::follow(&program::read(&p.text, p.language).unwrap().blocks, &bench).unwrap();
        assert!(p.cut_lines.is_sorted_by(|a, b| a.line < b.line && a.until_s < b.until_s), "{control:?}");
        let mut compared = 0;
        for cut in &p.cut_lines {
            let end = moves.iter().rfind(|m| m.line == cut.line).map(|m| m.pose(1.0, &tool, &machine));
            let end = end.unwrap_or_else(|| panic!("{control:?}: line {} does not move", cut.line));
            // Polynomials may end between two rows.
            let Some(row) = rows.iter().find(|r| (r.t_s - cut.until_s).abs() < 1e-9) else { continue };
            let off = (end.centre - row.stand.centre).norm();
            assert!(off < 2e-3, "{control:?}: line {} is {off} mm off", cut.line);
            compared += 1;
        }
        assert!(compared > 20, "{control:?}: {compared} of {}", p.cut_lines.len());
        let last = p.cut_lines.last().unwrap();
        assert!((last.until_s - rows[rows.len() - 1].t_s).abs() < 1e-9, "{control:?}");
    }
}

const TRUNNION: &str = include_str!("../../../../models/machines/trunnion_ac.toml");
const FORK: &str = include_str!("../../../../models/machines/fork_head_ca.toml");
const NUTATING: &str = include_str!("../../../../models/machines/nutating_head_cb.toml");
const FOUR: &str = include_str!("../../../../models/machines/four_axis_a.toml");

/// Chains of all kinds with the letters of their rotary axes; the last has both rotary axes moving.
fn chains() -> Vec<(Machine, [&'static str; 2])> {
    let (s, c) = sample::B_RAD.sin_cos();
    // A fixed spindle that leans by what the plan asks for.
    let four = FOUR.replace("[mount]", &format!("[spindle]\ndirection = [{s}, 0.0, {c}]\n[mount]"));
    let askew = TRUNNION.replace("along = [0.0, 0.0, 1.0]", "along = [0.2, 0.1, 1.0]");
    let all =
        [(TRUNNION, ["C", "A"]), (FORK, ["C", "A"]), (NUTATING, ["C", "B"]), (&four, ["A", ""]), (&askew, ["C", "A"])];
    all.into_iter().map(|(text, letters)| (Machine::from_toml(text, "test").unwrap(), letters)).collect()
}

#[test]
fn every_dialect_reads_back_on_every_chain() {
    for (k, (machine, [first, second])) in chains().into_iter().enumerate() {
        let plan = plan(&machine);
        for control in Control::ALL {
            let p = read_back_clean(control, &plan, &machine, RAPIDS);
            let cuts = |l: &&str| (l.contains(" X") || l.contains(" PO[X]")) && l.contains(" F");
            let cutting: Vec<&str> = p.text.lines().filter(cuts).collect();
            let line = cutting.iter().rev().nth(4).copied().unwrap_or("");
            let has = |letter: &str| {
                let says = |w: &str| w.trim_start_matches("PO[").starts_with(letter) && !w[1..].starts_with('3');
                !letter.is_empty() && line.split(' ').any(says)
            };
            match control {
                Control::SiemensVector | Control::HeidenhainVector | Control::FanucVector | Control::Apt => {}
                Control::Linuxcnc | Control::LinuxcncFeed | Control::Iso => {
                    assert!(has(first) && has(second) != second.is_empty(), "{control:?} {line}")
                }
                // Under tool-centre-point control what stands still is named once.
                _ => assert!(has(first) && has(second) == (k == 4), "{control:?} {line}"),
            }
            if !second.is_empty() && control != Control::Apt {
                let start = [
                    format!(" {second}="),
                    format!(" {second}-"),
                    format!(" {second}+"),
                    format!(" {second}1"),
                    format!(" {second}8"),
                    // At the table's zero; from there on by vectors.
                    format!(" {second}0.0000"),
                ];
                assert!(start.iter().any(|s| p.text.contains(s)), "{control:?}");
            }
            touches_as_planned(&p, &plan, &machine);
        }
    }
}

#[test]
fn a_word_of_an_axis_that_the_machine_has_not_is_named() {
    let (tool, machine) = (sample::tool(), Machine::demo().unwrap());
    let language = Dialect::built_in(Control::Iso).unwrap().language();
    let bench = program::Bench { language, zero: program::Zero::default(), tool: &tool, machine: &machine };
    let blocks = program::read("G1 X1 Y0 Z0 C5 F1\n", language).unwrap().blocks;
    assert!(program::follow(&blocks, &bench).unwrap_err().message.contains("no axis C"));
}

/// Manuals fix X, Y, Z to the table as it stands when tool-centre-point control comes on: it stands
/// at 0 then, and turns in by steps that leave no doubt.
#[test]
fn fanuc_turns_in_under_tool_centre_point_control() {
    let chains = chains().into_iter().map(|(machine, _)| machine);
    for (k, machine) in [Machine::demo().unwrap(), other()].into_iter().chain(chains).enumerate() {
        let plan = plan(&machine);
        let (blade, tool) = (sample::blade(), sample::tool());
        for control in [Control::Fanuc, Control::FanucVector] {
            let verified = Verified::for_tests(plan.clone(), sample::report(), false);
            let p = post(&Dialect::built_in(control).unwrap(), &verified, &blade, &tool, &machine, &options()).unwrap();
            let script = program::read(&p.text, p.language).unwrap();
            let bench =
                program::Bench { language: p.language, zero: program::Zero::default(), tool: &tool, machine: &machine };
            let moves = program::follow(&script.blocks, &bench).unwrap();
            let on = moves.iter().position(|m| m.words == Programmed::Tip).unwrap();
            let cuts = moves.iter().position(|m| m.seconds.is_some()).unwrap();
            let axes = machine.axes();
            let of_table = |k: &usize| axes[*k].is_rotary() && axes[*k].carries == Carries::Workpiece;
            let at_zero = |k: usize| moves[on].to[k].abs() < 1e-6;
            assert!((0..axes.len()).filter(of_table).all(at_zero), "{k} {control:?}");
            let end = |m: &program::Moved| m.axes(1.0, &tool, &machine);
            let first = end(&moves[on]);
            let room_mm = 0.5 * options().settings.safe_clearance_mm;
            for m in &moves[on + 1..cuts - 1] {
                let (from, to) = (m.axes(0.0, &tool, &machine), end(m));
                assert!(
                    machine.rotary().all(|i| (to[i] - from[i]).abs() <= std::f64::consts::FRAC_PI_2 + 1e-6),
                    "{k} {control:?}"
                );
                for f in 0..=8 {
                    let at = m.axes(f64::from(f) / 8.0, &tool, &machine);
                    let off = Vector::new(at[0] - first[0], at[1] - first[1], at[2] - first[2]).norm();
                    assert!(off <= room_mm + 0.01, "{k} {control:?}: {off}");
                }
            }
            // The last rapid comes to the safe position, as all dialects do.
            let start = plan.rows().next().unwrap();
            let reached = moves[cuts - 1].pose(1.0, &tool, &machine);
            let axis = start.stand.axis();
            assert!((reached.axis - axis).norm() < 1e-5, "{k} {control:?}");
            assert!((reached.centre - start.stand.centre).cross(&axis).norm() < 1e-3, "{k} {control:?}");
            // The same moves where the table has turned before are others, and the read-back says
            // so.
            let lines: Vec<&str> = p.text.lines().collect();
            let g43 = lines.iter().position(|l| l.starts_with("G43.")).unwrap();
            let turned =
                lines[..g43].iter().chain(&["G0 A90"]).chain(&lines[g43..]).map(|l| format!("{l}\n")).collect();
            if k < 2 {
                let bad = read_back(&Program { text: turned, ..p.clone() }, &plan, &blade, &tool, &machine).unwrap();
                assert!(bad.iter().any(|c| !c.passed && c.id == CheckId::ProgramMissing), "{k} {control:?}");
            }
        }
    }
}

/// Each location has a cone of its own, whose axis and lean change along the path: the axes,
/// programs and their read-back take it from there.
#[test]
fn cones_that_change_along_the_path_are_carried_through() {
    use crate::artifact::{Cone, Cones};
    let wobbling = |k: usize| {
        let at = std::f64::consts::TAU * k as f64 / 45.0;
        Cone::new(Vector::new(1.0, 0.06 * at.cos(), 0.06 * at.sin()), Vector::y(), sample::B_RAD + 0.02 * at.sin())
            .unwrap()
    };
    let (blade, tool) = (sample::blade(), sample::tool());
    for (k, text) in [TRUNNION, FORK].into_iter().enumerate() {
        let machine = Machine::from_toml(text, "test").unwrap();
        let mut plan = sample::plan(2, 180);
        let cones = Cones::along((0..plan.toolpath.locations.len()).map(wobbling).collect());
        plan.toolpath = plan.toolpath.with_cones(cones);
        plan.motion.position = machine.along(plan.rows().map(|r| r.stand), tool.length_mm());
        // The axes move on without a jump, and place ball and axis as the plan has them.
        for (row, q) in plan.motion.position.iter().enumerate() {
            let (pose, stand) = (machine.forward(q, tool.length_mm()), plan.stand(row).unwrap());
            assert!(
                (pose.centre - stand.centre).norm() < 1e-6 && (pose.axis - stand.axis()).norm() < 1e-9,
                "{k} {row}"
            );
            let step = plan
                .motion
                .position
                .get(row + 1)
                .map_or(0.0, |next| (next[3] - q[3]).abs().max((next[4] - q[4]).abs()));
            assert!(step < 0.3, "{k} {row}: {step}");
        }
        for control in Control::ALL {
            let p = read_back_clean(control, &plan, &machine, RAPIDS);
            // The same text is not the program of the plan with one cone.
            let mut other = plan.clone();
            other.toolpath = other.toolpath.with_cones(Cones::about_blade(sample::B_RAD));
            let wrong = read_back(&p, &other, &blade, &tool, &machine).unwrap();
            assert!(wrong.iter().any(|c| !c.passed && c.id == CheckId::ProgramDirection), "{k} {control:?}");
        }
    }
}
