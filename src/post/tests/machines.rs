//! Machines whose axes are others than the demo machine's.

use super::*;
use crate::machine::{PositiveA, PositiveB};
use crate::verify::program;

/// Both rotary axes turn the other way, and the spindle's axis passes the pivot by.
fn other() -> Machine {
    let mut m = Machine::demo().unwrap();
    m.head.positive_b_leans = PositiveB::MinusX;
    m.head.spindle_offset_mm = 12.5;
    m.table.positive_a_turns = PositiveA::Workpiece;
    m
}

/// The sample's plan with the axes of a machine.
fn plan(machine: &Machine) -> Plan {
    let mut plan = sample::with_leads(sample::plan(2, 60));
    let gauge = sample::tool().length_mm();
    let rows: Vec<_> = plan.rows().map(|r| machine.inverse(&r.centre, r.theta, sample::B_RAD, gauge)).collect();
    let [first, last] = [plan.leads[0].centres.len(), rows.len() - plan.leads[1].centres.len()];
    plan.leads[0].motion.position = rows[..first].to_vec();
    plan.motion.position = rows[first..last].to_vec();
    plan.leads[1].motion.position = rows[last..].to_vec();
    plan
}

#[test]
fn every_dialect_reads_back_on_a_machine_that_turns_the_other_way() {
    let machine = other();
    let plan = plan(&machine);
    let (blade, tool) = (sample::blade(), sample::tool());
    for control in Control::ALL {
        let dialect = Dialect::built_in(control).unwrap();
        let verified = Verified::for_tests(plan.clone(), sample::report(), false);
        let p = post(&dialect, &verified, &blade, &tool, &machine, &options()).unwrap();
        let checks = read_back(&p, &plan, &blade, &tool, &machine).unwrap();
        let bad: Vec<_> = checks.iter().filter(|c| !c.passed).collect();
        assert!(bad.is_empty(), "{control:?}: {bad:#?}");
        if control != Control::Apt {
            assert!(p.text.contains("B-5.0") || p.text.contains("B=-5.0"), "{control:?}");
        }
        // The tool leans the same way over the part: the ball touches it, and the tool axis is the plan's.
        let bench =
            program::Bench { language: p.language, zero: program::Zero::default(), tool: &tool, machine: &machine };
        let moves = program::follow(&program::read(&p.text, p.language).unwrap(), &bench).unwrap();
        let near = |c: &Point| (c - plan.toolpath.locations[30].centre).norm() < 1e-3;
        let pose = moves.iter().map(|m| m.pose(1.0, &tool, &machine)).find(|q| near(&q.centre)).unwrap();
        assert!((pose.axis - tool::axis(sample::B_RAD, plan.schedule.theta[30])).norm() < 1e-5, "{control:?}");
        // With the machine file of the demo machine the same text is another motion.
        let wrong = read_back(&p, &plan, &blade, &tool, &Machine::demo().unwrap()).unwrap();
        let vectors = [Control::SiemensVector, Control::HeidenhainVector, Control::FanucVector, Control::Apt];
        assert!(vectors.contains(&control) || wrong.iter().any(|c| !c.passed), "{control:?}");
    }
}
