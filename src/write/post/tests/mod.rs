//! Programs read back word for word and compared with the plan, and kept as snapshots.
#![allow(clippy::unwrap_used)]

mod machines;
mod operations;
mod planted;
mod planted_words;
mod polynomial;
mod ranges;
mod read_back;

use read_back::{Move, read};

use super::*;
use crate::artifact::Cones;
use crate::artifact::program::Control;
use crate::error::{ErrorKind, Infeasible};
use crate::geometry::Vector;
use crate::machine::AxisLimits;
use crate::sample;
use crate::verify::read_back::read_back;

fn options() -> PostOptions {
    PostOptions {
        program_name: "CYL_ROOT".into(),
        part_file: "cylinder.obj".into(),
        part_hash: "0123abcd".into(),
        job: "made up for a test".into(),
        ..PostOptions::default()
    }
}

fn program(control: Control, plan: Plan, forced: bool, options: &PostOptions) -> Result<Program> {
    written(&Dialect::built_in(control).unwrap(), plan, forced, options)
}

fn written(dialect: &Dialect, plan: Plan, forced: bool, options: &PostOptions) -> Result<Program> {
    let plan = Verified::for_tests(plan, sample::report(), forced);
    post(dialect, &plan, &sample::blade(), &sample::tool(), &Machine::demo().unwrap(), options)
}

/// The G93 moves of a program: the cutting.
fn cutting(program: &Program) -> Vec<Move> {
    read(&program.text).unwrap().into_iter().filter(|m| m.inverse_time).collect()
}

fn total_s(moves: &[Move]) -> f64 {
    moves.iter().map(|m| 60.0 / m.feed).sum()
}

#[test]
fn siemens_positions_are_the_plans_tool_tips() {
    let built_in = Control::Siemens.post_file();
    // Own post files for a linear A: absolute words over all turns, and steps.
    let own = |rotary: &str, word: &str| built_in.replace("modulo", rotary).replace("Z{z} {a_name}={a_way}({a})", word);
    let absolute = own("accumulate", "Z{z} {a_name}={a}").replace("{a_way}({a})", "{a}");
    let steps = own("incremental", "Z{z} {a_name}=IC({da})");
    for text in [built_in, &absolute, &steps] {
        let plan = sample::plan(3, 720);
        let p = written(&Dialect::from_toml(text, "test").unwrap(), plan.clone(), false, &options()).unwrap();
        let moves = cutting(&p);
        assert_eq!(moves.len(), 2160);
        for (i, m) in moves.iter().enumerate() {
            let tip = plan.stand(i + 1).unwrap().tip(5.0);
            for (k, want) in [tip.x, tip.y, tip.z].into_iter().enumerate() {
                assert!((m.at[k] - want).abs() <= 0.500_001e-5, "line {}", m.line);
            }
            let a = plan.motion.position[i + 1][3].to_degrees();
            let whole_turns = (m.at[3] - a) / 360.0;
            assert!((whole_turns - whole_turns.round()).abs() * 360.0 <= 1.01e-5, "line {}", m.line);
            assert!((m.at[4] - 5.0).abs() < 1e-9);
            assert!(m.traori);
        }
        // Steps add up: A ends exactly as many turns later as the plan says.
        let turned = moves[2159].at[3] - moves[0].at[3];
        assert!((turned - 2159.0 * 0.5).abs() <= 1.01e-5);
        assert!((total_s(&moves) / plan.motion.time_s - 1.0).abs() < 1e-6);
    }
}

#[test]
fn linuxcnc_positions_are_the_plans_axes() {
    let plan = sample::plan(2, 720);
    let p = program(Control::Linuxcnc, plan.clone(), false, &options()).unwrap();
    let moves = cutting(&p);
    assert_eq!(moves.len(), 1440);
    // A begins in the first turn from 0 on.
    let before = 360.0 * (plan.motion.position[0][3].to_degrees() / 360.0).floor();
    for (m, q) in moves.iter().zip(plan.motion.position.iter().skip(1)) {
        let want = [q[0], q[1], q[2], q[3].to_degrees() - before, q[4].to_degrees()];
        for k in 0..5 {
            assert!((m.at[k] - want[k]).abs() <= 0.500_001e-5, "line {}", m.line);
        }
    }
    assert!((total_s(&moves) / plan.motion.time_s - 1.0).abs() < 1e-6);
    assert!(p.text.lines().all(|l| l.len() < 256 && l.is_ascii()));
}

#[test]
fn both_programs_come_and_go_along_the_tool_axis_from_outside_the_turning_part() {
    let plan = sample::plan(2, 90);
    let (machine, tool) = (Machine::demo().unwrap(), sample::tool());
    for control in [Control::Siemens, Control::Linuxcnc] {
        let p = program(control, plan.clone(), false, &options()).unwrap();
        let moves = read(&p.text).unwrap();
        let first = moves.iter().position(|m| m.inverse_time).unwrap();
        let last = moves.iter().rposition(|m| m.inverse_time).unwrap();
        let centre = |m: &Move| {
            let q = [m.at[0], m.at[1], m.at[2], m.at[3].to_radians(), m.at[4].to_radians()];
            if control == Control::Linuxcnc {
                return machine.forward(&q, tool.length_mm()).centre;
            }
            let axis = machine.axis_at(&q);
            Point::new(q[0], q[1], q[2]) + axis * tool.radius_mm
        };
        for (touch, away, row) in [(first - 1, first - 3, 0), (last, last + 2, 180)] {
            let axis = plan.stand(row).unwrap().axis();
            let (from, to) = (centre(&moves[touch]), centre(&moves[away]));
            assert!((from - plan.toolpath.locations[row].centre).norm() < 1e-4, "{control:?} row {row}");
            let way = to - from;
            assert!(way.cross(&axis).norm() < 1e-4 && way.dot(&axis) > 0.0);
            // The plane under the ball has the whole sphere around the part on its other side.
            let (c, radius) = sphere_on_axis(&(&sample::blade()).into(), &machine);
            assert!((to - c).dot(&axis) - tool.radius_mm > radius + 19.99);
        }
        assert!(p.text.contains("Unwind of A"));
    }
}

/// The program comes along the tool axis to the outer end of the arc, is on the path's tangent
/// where it meets the first location, and leaves likewise.
#[test]
fn programs_run_onto_the_path_and_off_it_along_its_tangent() {
    let plan = sample::with_leads(sample::plan(2, 90));
    let (machine, tool) = (Machine::demo().unwrap(), sample::tool());
    let p = program(Control::Linuxcnc, plan.clone(), false, &options()).unwrap();
    assert!(p.text.contains("Lead-in  arc of radius 4.000 mm, 90.0 deg"));
    let cut = cutting(&p);
    let centre = |m: &Move| {
        let [x, y, z, a, b] = m.at;
        machine.forward(&[x, y, z, a.to_radians(), b.to_radians()], tool.length_mm()).centre
    };
    let centres: Vec<Point> = cut.iter().map(centre).collect();
    let near = |row: usize| {
        let c = plan.toolpath.locations[row].centre;
        centres.iter().position(|q| (q - c).norm() < 1e-4).unwrap()
    };
    for (at, row, far) in [(near(0), 0, 0), (near(180), 180, centres.len() - 1)] {
        let l = plan.toolpath.locations[row];
        let tangent = Vector::new(0.5 / std::f64::consts::TAU, -25.0 * l.normal.z, 25.0 * l.normal.y).normalize();
        let (before, after) = (centres[at] - centres[at - 1], centres[at + 1] - centres[at]);
        assert!(before.angle(&tangent) < 0.04 && after.angle(&tangent) < 0.04, "{before} {after}");
        // A quarter of the arc's radius off the part, along its normal, and no place of it nearer
        // to the axis than the path.
        let off = centres[far].y.hypot(centres[far].z) - 25.0;
        assert!((3.8..5.0).contains(&off), "{off}");
        assert!(centres.iter().all(|c| c.y.hypot(c.z) > 25.0 - 0.02));
    }
    let (lead_in, turn, lead_out) = ("; Lead-in\n", "; Turn 1 of 2", "; Lead-out\n");
    let at = |what: &str| p.text.find(what).unwrap();
    assert!(at(lead_in) < at(turn) && at(turn) < at(lead_out));
    assert!((total_s(&cut) / plan.rows().last().unwrap().t_s - 1.0).abs() < 1e-6);
    // What is planted in a lead is found like what is planted in the path.
    let lines: Vec<&str> = p.text.lines().collect();
    let line = lines.iter().position(|l| *l == "; Lead-in").unwrap() + 4;
    let gone = line..line + 3;
    let text =
        |_: &str| lines.iter().enumerate().filter(|(i, _)| !gone.contains(i)).map(|(_, l)| format!("{l}\n")).collect();
    assert!(failing(Control::Linuxcnc, &plan, &text).iter().any(|n| n == "program-chord"));
}

#[test]
fn a_short_travel_shortens_the_retract_and_says_so() {
    let demo = Machine::demo().unwrap();
    let z = demo.axes()[2].limits;
    let machine = demo.with_limits(2, AxisLimits { travel: z.travel.map(|[lo, _]| [lo, 180.0]), ..z });
    let plan = Verified::for_tests(sample::plan(1, 30), sample::report(), false);
    let text = |m| {
        post(&Dialect::built_in(Control::Linuxcnc).unwrap(), &plan, &sample::blade(), &sample::tool(), m, &options())
            .unwrap()
            .text
    };
    let short = text(&machine);
    assert!(short.contains("the travel of the machine ends") && !short.contains("Unwind"));
    assert!(read(&short).unwrap().iter().all(|m| m.at[2] <= 180.0 + 1e-9));
}

#[test]
fn a_forced_program_says_that_it_is_not_verified() {
    for control in [Control::Siemens, Control::Linuxcnc] {
        let p = program(control, sample::plan(1, 12), true, &options()).unwrap();
        assert!(p.text.contains("NOT VERIFIED"));
        let q = program(control, sample::plan(1, 12), false, &options()).unwrap();
        assert!(!q.text.contains("NOT VERIFIED") && q.text.contains("ok     gouge"));
    }
}

#[test]
fn what_cannot_be_posted_is_an_error() {
    let fail = |change: &dyn Fn(&mut Plan)| {
        let mut plan = sample::plan(1, 12);
        change(&mut plan);
        program(Control::Siemens, plan, false, &options()).unwrap_err()
    };
    assert!(fail(&|p| p.toolpath.locations.clear()).message.contains("at least 2"));
    assert!(fail(&|p| p.motion.position[3][1] = f64::NAN).message.contains("location 3"));
    assert!(fail(&|p| p.toolpath.locations[4].centre.x = f64::INFINITY).message.contains("location 4"));
    assert!(fail(&|p| p.motion.t_s[5] = 0.0).message.contains("time goes back"));
    assert!(fail(&|p| p.motion.t_s.truncate(12)).message.contains("12 times"));
    assert!(fail(&|p| p.toolpath.cones = Cones::about_blade(f64::NAN)).message.contains("angle B"));
    let e = fail(&|p| p.toolpath.locations[0].normal *= -1.0);
    assert!(matches!(e.infeasible.as_deref(), Some(Infeasible::CannotLeave { at, .. }) if at.location == 0), "{e:?}");
    let bad = options().with(|s| s.spindle_rpm = 0.0);
    assert_eq!(program(Control::Siemens, sample::plan(1, 12), false, &bad).unwrap_err().kind, ErrorKind::Usage);
}

#[test]
fn names_from_outside_cannot_leave_their_comment() {
    let odd = PostOptions { part_file: "blade\nG0 X0 \u{fc}\r.step".into(), ..options() };
    let p = program(Control::Linuxcnc, sample::plan(1, 12), false, &odd).unwrap();
    assert!(p.text.is_ascii() && !p.text.contains('\r'));
    assert!(p.text.contains("blade?G0 X0 ??.step"));
}

#[test]
fn every_dialect_reads_back_as_the_plan() {
    // Turns of 12 degrees a line with a small chord tolerance: machine axes need blocks between
    // locations.
    let (blade, tool, machine) = (sample::blade(), sample::tool(), Machine::demo().unwrap());
    let bare = sample::plan(3, 30);
    let plans = [sample::with_leads(bare.clone()), bare];
    for (plan, control) in plans.iter().flat_map(|p| Control::ALL.map(|c| (p, c))) {
        let p = program(control, plan.clone(), false, &options()).unwrap();
        for c in read_back(&p, plan, &blade, &tool, &machine).unwrap() {
            assert!(c.passed, "{control:?}: {} is {} {} at {}", c.id, c.worst, c.unit, c.note);
        }
        let longest = Dialect::built_in(control).unwrap().file.longest_line;
        assert!(p.text.is_ascii() && p.text.lines().all(|l| l.len() <= longest), "{control:?}");
        let blocks = |l: &str| {
            l.starts_with("G1 ")
                || l.contains(" G1 ")
                || l.contains(" L")
                || l.contains(" SPL ")
                || l.starts_with("GOTO")
                || l.contains(" PO[X]")
        };
        let lines = p.text.lines().filter(|l| blocks(l)).count();
        assert!(lines >= 90, "{control:?} {lines}");
    }
}

/// Names of the checks that fail after a change of the text.
fn failing(control: Control, plan: &Plan, change: &dyn Fn(&str) -> String) -> Vec<String> {
    let mut p = program(control, plan.clone(), false, &options()).unwrap();
    p.text = change(&p.text);
    let checks = read_back(&p, plan, &sample::blade(), &sample::tool(), &Machine::demo().unwrap()).unwrap();
    checks.into_iter().filter(|c| !c.passed).map(|c| c.id.to_string()).collect()
}

/// Where the path turns back on itself each line is compared with the pass that it cuts, not with
/// the one that comes by there later.
#[test]
fn a_path_that_turns_back_comes_back_as_planned() {
    for (at, by) in [(100, 2), (100, 3), (200, 5)] {
        let plan = sample::turned_back(720, at, by);
        for control in [Control::Siemens, Control::Heidenhain, Control::Fanuc, Control::Linuxcnc, Control::Apt] {
            let found = failing(control, &plan, &|t| t.into());
            assert!(found.is_empty(), "{control:?}, {by} back at {at}: {found:?}");
        }
        // Without the way back and forth, the program misses locations.
        for control in [Control::Siemens, Control::Linuxcnc] {
            let cut = |l: &&str| l.contains(" Y") && l.contains(" A") || l.starts_with("GOTO");
            let p = program(control, plan.clone(), false, &options()).unwrap();
            let lines: Vec<&str> = p.text.lines().collect();
            let cuts: Vec<usize> = (0..lines.len()).filter(|k| cut(&lines[*k])).collect();
            let without = |_: &str| {
                let left = |k: &usize| !cuts[at + 1..at + 2 * by + 1].contains(k);
                (0..lines.len()).filter(left).map(|k| lines[k]).collect::<Vec<_>>().join("\n") + "\n"
            };
            assert!(!failing(control, &plan, &without).is_empty(), "{control:?}, {by} back at {at}");
        }
    }
}

#[test]
fn reading_back_finds_what_is_planted() {
    let plan = sample::plan(2, 60);
    let has = |found: &[String], name: &str| assert!(found.iter().any(|f| f == name), "{name} not in {found:?}");
    for control in [Control::Siemens, Control::Heidenhain, Control::Fanuc, Control::Linuxcnc, Control::Apt] {
        let p = program(control, plan.clone(), false, &options()).unwrap();
        assert!(failing(control, &plan, &|t| t.into()).is_empty());
        let lines: Vec<&str> = p.text.lines().collect();
        let cut = |l: &&str| l.contains(" Y") && l.contains(" A") || l.starts_with("GOTO");
        let nth = lines.iter().enumerate().filter(|(_, l)| cut(l)).nth(40).unwrap().0;
        // A digit of a coordinate.
        let word = if control == Control::Apt { "GOTO/" } else { "X" };
        let moved = |t: &str| {
            let mut out: Vec<String> = t.lines().map(String::from).collect();
            let at = out[nth].rfind(word).unwrap() + word.len();
            let end = at + out[nth][at..].find([' ', ',']).unwrap();
            let value: f64 = out[nth][at..end].parse().unwrap();
            out[nth].replace_range(
                at..end,
                &format!("{:+.5}", value + 0.01).replace(if control == Control::Heidenhain { "~" } else { "+" }, ""),
            );
            out.join("\n")
        };
        has(&failing(control, &plan, &moved), "program-centre");
        if control == Control::Apt {
            continue; // Its statements go over several lines.
        }
        // A missing turn.
        let short = |t: &str| {
            let all: Vec<&str> = t.lines().collect();
            let cuts: Vec<usize> = (0..all.len()).filter(|i| cut(&all[*i])).collect();
            let gone = &cuts[cuts.len() / 4..3 * cuts.len() / 4];
            let kept: Vec<String> = (0..all.len()).filter(|i| !gone.contains(i)).map(|i| all[i].to_string()).collect();
            // Klartext counts its blocks.
            let renumber = |(i, l): (usize, String)| match (control, l.split_once(' ')) {
                (Control::Heidenhain, Some((_, rest))) => format!("{i} {rest}"),
                _ => l,
            };
            kept.into_iter().enumerate().map(renumber).collect::<Vec<_>>().join("\n")
        };
        has(&failing(control, &plan, &short), "program-time");
        assert!(failing(control, &plan, &short).len() >= 2);
    }
    // A swapped sign of B: the program never comes to where the path begins or ends.
    has(&failing(Control::Linuxcnc, &plan, &|t| t.replace(" B5.", " B-5.")), "program-missing");
    has(&failing(Control::Fanuc, &plan, &|t| t.replace("B5.0000", "B-5.0000")), "program-missing");
    has(&failing(Control::SiemensVector, &plan, &|t| t.replace("A3=0", "A3=-0")), "program-missing");
}

#[test]
fn an_own_post_file_needs_no_recompiling() {
    let own = Control::Iso
        .post_file()
        .replace("name = \"ISO, machine axes\"", "name = \"My mill\"")
        .replace("program.iso.nc", "mine.tap")
        .replace("[numbers]", "[numbers]\ntrim = true")
        .replace("comment = [", "modal = [\"b\", \"y\"]\ncomment = [");
    let dialect = Dialect::from_toml(&own, "own").unwrap();
    let plan = sample::plan(1, 40);
    let verified = Verified::for_tests(plan.clone(), sample::report(), false);
    let (blade, tool, machine) = (sample::blade(), sample::tool(), Machine::demo().unwrap());
    let p = post(&dialect, &verified, &blade, &tool, &machine, &options()).unwrap();
    assert_eq!((p.file_name.as_str(), p.control.as_str()), ("mine.tap", "My mill"));
    assert_eq!(p.text.matches(" B5.").count(), 1, "a modal word is written once");
    assert!(read_back(&p, &plan, &blade, &tool, &machine).unwrap().iter().all(|c| c.passed));
}

#[test]
fn bad_post_files_are_usage_errors_that_name_the_key() {
    let good = Control::Siemens.post_file();
    for (from, to, names) in [
        ("length_decimals = 5", "length_decimals = 9", "numbers.length_decimals is 9"),
        ("{a_way}", "{a_wy}", "no value {a_wy}"),
        ("longest_line = 200", "longest_line = 3", "longest_line"),
        ("file = \"program.mpf\"", "file = \"../x\"", "file name"),
        ("rotary = \"modulo\"", "rotary = \"sideways\"", "sideways"),
        ("F = { least = 0.001", "F = { least = 0.0", "ranges.F: least must be greater than 0"),
        ("N = { least = 0.0", "N = { least = 1e9", "ranges.N"),
        ("first = 10", "first = 100000000", "numbering.first is 100000000"),
        ("resolution_mm = 0.001", "resolution_mm = 0.0", "resolution_mm"),
        ("    \"{look_ahead}\",\n", "", "no line {look_ahead}"),
        ("name = ", "nam = ", "nam"),
    ] {
        let text = good.replacen(from, to, 1);
        assert_ne!(text, good, "{from}");
        let e = Dialect::from_toml(&text, "p.toml").unwrap_err();
        assert!(
            e.kind == ErrorKind::Usage && e.message.contains(names) && e.message.contains("p.toml"),
            "{}",
            e.message
        );
    }
}

#[test]
fn programs_are_as_kept_in_snapshots() {
    // A few long moves, with a tolerance that leaves them whole.
    let mut plan = sample::plan(1, 12);
    plan.toolpath.chord_mm = 100.0;
    plan = sample::with_leads(plan);
    let whole = options().with(|s| s.smoothing_mm = Some(0.002));
    for control in Control::ALL {
        let plan = match control {
            // A curve to be carried, its pieces longer than the moves.
            Control::SiemensPoly => sample::with_leads(sample::with_curve(plan.clone(), 0.02, 2.5)),
            Control::FanucNurbs => sample::with_leads(sample::on_curve(sample::plan(1, 90), 0.05, 23.0, 3)),
            _ => plan.clone(),
        };
        let p = program(control, plan, false, &whole).unwrap();
        let file = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/snapshots").join(&p.file_name);
        if std::env::var_os("BLADEWRIGHT_BLESS").is_some() {
            std::fs::write(&file, &p.text).unwrap();
        }
        let kept = std::fs::read_to_string(&file).unwrap();
        let first = kept.lines().zip(p.text.lines()).find(|(a, b)| a != b);
        assert!(kept == p.text, "{control:?} differs from {}, first at {first:?}", file.display());
    }
}

#[test]
fn a_program_from_a_turn_on_is_the_rest_of_the_whole() {
    let plan = sample::plan(4, 60);
    let (blade, tool, machine) = (sample::blade(), sample::tool(), Machine::demo().unwrap());
    for control in Control::ALL {
        let whole = program(control, plan.clone(), false, &options()).unwrap();
        assert_eq!(whole.text.matches("Turn ").count(), 4, "{control:?}");
        let from = PostOptions { from_turn: Some(3), ..options() };
        let rest = program(control, plan.clone(), false, &from).unwrap();
        assert_eq!(rest.file_name, format!("from_turn_3.{}", whole.file_name));
        assert!(rest.text.contains("GOES ON with turn 3") && rest.text.contains("Turn 4 of 4"), "{control:?}");
        assert!(!rest.text.contains("Turn 2 of 4"));
        let left = planned(&plan, &from).unwrap();
        for c in read_back(&rest, &left, &blade, &tool, &machine).unwrap() {
            assert!(c.passed, "{control:?}: {} is {} {} at {}", c.id, c.worst, c.unit, c.note);
        }
        // Its cutting is that of the whole, to the digit; whole turns of A before it are dropped.
        if control == Control::Linuxcnc {
            let cuts = |text: &str| -> Vec<String> {
                let behind = text.split("Turn 3 of 4").nth(1).unwrap().split("Unwind").next().unwrap();
                let fixed = |l: &str| l.split(' ').filter(|w| !w.starts_with('A')).collect::<Vec<_>>().join(" ");
                behind.lines().map(fixed).collect()
            };
            assert_eq!(cuts(&whole.text), cuts(&rest.text));
            assert!(rest.text.contains("G0 A287.18873") && whole.text.contains("G0 A287.18873"));
        }
    }
    for none in [0, 5] {
        let e = program(Control::Iso, plan.clone(), false, &PostOptions { from_turn: Some(none), ..options() });
        assert!(e.unwrap_err().message.contains("turns 1 to 4"));
    }
}
