//! Several operations in one program.

use super::*;
use crate::verify::read_back::{self, read_back_each};

/// Two operations on the sample's cylinder, with tools of different lengths.
struct Two {
    plans: [Verified<Plan>; 2],
    tools: [Tool; 2],
    options: [PostOptions; 2],
}

impl Two {
    fn new() -> Self {
        let long = Tool { stickout_mm: 95.0, ..sample::tool() };
        let plans = [sample::with_leads(sample::plan(2, 60)), sample::plan(3, 60)];
        Two {
            plans: plans.map(|p| Verified::for_tests(p, sample::report(), false)),
            tools: [sample::tool(), long],
            options: [1, 2].map(|tool_number| options().with(|s| s.tool_number = tool_number)),
        }
    }

    fn operations(&self) -> Vec<Operation<'_>> {
        let one = |k: usize| Operation { plan: &self.plans[k], tool: &self.tools[k], options: &self.options[k] };
        vec![one(0), one(1)]
    }

    fn program(&self, control: Control) -> Program {
        let (dialect, machine) = (Dialect::built_in(control).unwrap(), Machine::demo().unwrap());
        join(&dialect, &self.operations(), 1, &sample::blade(), &machine).unwrap()
    }

    /// Names of the checks that fail, and the operation that each belongs to.
    fn failing(&self, program: &Program) -> Vec<String> {
        let made: Vec<_> =
            (0..2).map(|k| read_back::Operation { plan: self.plans[k].value(), tool: &self.tools[k] }).collect();
        let checks = read_back_each(program, &made, &sample::blade(), &Machine::demo().unwrap()).unwrap();
        assert!(checks.len() >= 12 - 2, "{checks:?}");
        let bad = checks.iter().filter(|c| !c.passed);
        bad.map(|c| format!("{} {} {}", c.id, c.note.split(';').next().unwrap_or(""), c.worst)).collect()
    }
}

#[test]
fn every_dialect_joins_operations_that_read_back_as_their_plans() {
    let two = Two::new();
    for control in Control::ALL {
        let p = two.program(control);
        let found = two.failing(&p);
        assert!(found.is_empty(), "{control:?}: {found:?}");
        for (what, count) in [("Operation 1 of 2", 1), ("Operation 2 of 2", 1), ("Tool     T1", 1), ("Tool     T2", 1)]
        {
            assert_eq!(p.text.matches(what).count(), count, "{control:?} {what}");
        }
        assert_eq!(p.text.matches("Turn 1 of 2").count() + p.text.matches("Turn 1 of 3").count(), 2, "{control:?}");
        let ends = ["M30", "M2\n", "FINI"].iter().map(|e| p.text.matches(e).count()).sum::<usize>();
        assert_eq!(ends, 1, "{control:?}");
        let longest = Dialect::built_in(control).unwrap().file.longest_line;
        assert!(p.text.is_ascii() && p.text.lines().all(|l| l.len() <= longest), "{control:?}");
    }
}

#[test]
fn each_operation_is_the_program_that_it_is_by_itself() {
    let two = Two::new();
    let (dialect, machine, blade) =
        (Dialect::built_in(Control::Linuxcnc).unwrap(), Machine::demo().unwrap(), sample::blade());
    let both = two.program(Control::Linuxcnc).text;
    for k in 0..2 {
        let alone = post(&dialect, &two.plans[k], &blade, &two.tools[k], &machine, &two.options[k]).unwrap().text;
        // But for its size at the head.
        let body = alone.split_once(" bytes\n").unwrap().1.split("M5").next().unwrap();
        assert!(both.contains(body), "operation {k}");
    }
    // What is left after a break.
    let left = join(&dialect, &two.operations()[1..], 2, &blade, &machine).unwrap();
    assert_eq!(left.file_name, "from_operation_2.program.ngc");
    let alone = post(&dialect, &two.plans[1], &blade, &two.tools[1], &machine, &two.options[1]).unwrap().text;
    assert_eq!(left.text, alone);
    let from = PostOptions { from_turn: Some(2), ..two.options[1].clone() };
    let last = [Operation { options: &from, ..two.operations()[1] }];
    let left = join(&dialect, &last, 2, &blade, &machine).unwrap();
    assert_eq!(left.file_name, "from_operation_2.from_turn_2.program.ngc");
    assert!(left.text.contains("GOES ON with turn 2"));
}

#[test]
fn what_goes_wrong_between_two_operations_is_found() {
    let two = Two::new();
    for control in [Control::Siemens, Control::Heidenhain, Control::Fanuc, Control::Linuxcnc] {
        let p = two.program(control);
        // Down through the part on the way to the tool change.
        let call = p.text.find(if control == Control::Heidenhain { "TOOL CALL 2" } else { "T2 M6" }).unwrap();
        let at = p.text[..call].rfind("630.").unwrap();
        let text = format!("{}100.{}", &p.text[..at], &p.text[at + 4..]);
        let found = two.failing(&Program { text, ..p.clone() });
        assert!(found.iter().any(|f| f.contains("program-rapids operation 1")), "{control:?}: {found:?}");
        assert!(found.iter().all(|f| f.contains("program-rapids")), "{control:?}: {found:?}");
    }
    // The tools swapped in the magazine: machine axes place another ball centre.
    let p = two.program(Control::Linuxcnc);
    let swapped = Two { tools: [two.tools[1].clone(), two.tools[0].clone()], ..Two::new() };
    assert!(swapped.failing(&p).iter().any(|f| f.contains("program-missing") && f.contains("operation 2")));
    // A tool call that is missing.
    let text = p.text.replacen("T2 M6", "", 1);
    let made: Vec<_> =
        (0..2).map(|k| read_back::Operation { plan: two.plans[k].value(), tool: &two.tools[k] }).collect();
    let e = read_back_each(&Program { text, ..p }, &made, &sample::blade(), &Machine::demo().unwrap()).unwrap_err();
    assert!(e.message.contains("calls a tool 1 times, 2 tools"), "{}", e.message);
}

#[test]
fn operations_that_cannot_be_one_program_are_errors() {
    let mut two = Two::new();
    two.options[1].settings.tool_number = 1;
    let (dialect, machine, blade) =
        (Dialect::built_in(Control::Iso).unwrap(), Machine::demo().unwrap(), sample::blade());
    let e = join(&dialect, &two.operations(), 1, &blade, &machine).unwrap_err();
    assert!(e.kind == ErrorKind::Usage && e.message.contains("both call T1"), "{}", e.message);
    two.tools[1] = two.tools[0].clone();
    assert!(join(&dialect, &two.operations(), 1, &blade, &machine).is_ok());
    assert_eq!(join(&dialect, &[], 1, &blade, &machine).unwrap_err().kind, ErrorKind::Usage);
}
