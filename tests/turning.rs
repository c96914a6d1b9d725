//! Turn-milling: an offset that stays, a blade that turns evenly, and what each tooth cuts, as
//! programs have them when they are read by somebody else.

use bladewright::artifact::axis_travel::offset_mm;
use bladewright::artifact::check_id::CheckId;
use bladewright::artifact::program::Control;
use bladewright::artifact::schedule::ScheduleKind;
use bladewright::error::{Error, ErrorKind, Infeasible, Result};
use bladewright::machine::Machine;
use bladewright::observe::Silent;
use bladewright::plan::{self, Setup};
use bladewright::tool::scallop;
use bladewright::verify::{Verdict, Verified};
use bladewright::write::post::Dialect;
use bladewright::{artifact::Plan, job};

use super::of_prism;

/// A coarse helix of a few turns.
const JOB: &str = "
[model]
file = 'prism.step'

[path]
scallop_mm = 0.05

[region]
start_mm = 40
end_mm = 35

[tool]
radius_mm = 3
taper_deg = 3
shank_radius_mm = 5
stickout_mm = 70
holder = [{ radius_mm = 15, length_mm = 40 }]
";

fn machine(name: &str) -> Machine {
    of_prism::machine(name, |text| text)
}

/// The mill-turn centre with its file changed.
fn mill_turn(from: &[&str], to: &[&str]) -> Machine {
    let changed = |text: String| from.iter().zip(to).fold(text, |text, (a, b)| text.replace(a, b));
    of_prism::machine("mill_turn_cb.toml", changed)
}

fn setup(changes: &[&str], machine: Machine) -> Result<Setup> {
    of_prism::setup(JOB, changes, machine)
}

fn planned(changes: &[&str], machine: Machine) -> (Setup, Verified<Plan>) {
    let setup = setup(changes, machine).unwrap_or_else(|e| panic!("{changes:?}: {e}"));
    match plan::plan(&setup, &Silent).unwrap_or_else(|e| panic!("{changes:?}: {e}")) {
        Verdict::Passed(verified) => (setup, verified),
        Verdict::Failed(rejected) => {
            let failed: Vec<_> = rejected.report().checks.iter().filter(|c| !c.passed).collect();
            panic!("{changes:?}: {failed:#?}")
        }
    }
}

/// An error of the job, of the plan, or of the planning.
fn refused(changes: &[&str], machine: Machine) -> Error {
    let ended = setup(changes, machine).and_then(|s| plan::plan(&s, &Silent));
    ended.err().unwrap_or_else(|| panic!("{changes:?} was not refused"))
}

/// The words of a letter on all lines of straight feed moves between two comments, in order.
fn words(text: &str, letter: char, from: &str, to: &str) -> Vec<f64> {
    let lines = text.lines().skip_while(|l| !l.starts_with(from)).take_while(|l| !l.starts_with(to));
    let cutting = lines.filter(|l| l.starts_with("G1 "));
    let word = |l: &str| l.split(' ').find_map(|w| w.strip_prefix(letter)?.parse().ok());
    cutting.filter_map(word).collect()
}

fn program(setup: &Setup, verified: &Verified<Plan>, control: Control) -> String {
    let dialect = Dialect::built_in(control).expect("a dialect");
    let (program, checks) = setup.program(&dialect, verified).expect("a program");
    let failed: Vec<_> = checks.iter().filter(|c| !c.passed).collect();
    assert!(failed.is_empty(), "{control}: {failed:?}");
    program.text
}

/// The program has one Y at all lines of the cutting, leads included.
#[test]
fn an_offset_that_stays_is_one_y_in_the_program() {
    let off = ["machine.b_deg=5", "schedule.kind=\"eccentric\"", "schedule.offset_mm=-1.5"];
    let (setup, verified) = planned(&off, machine("mill_turn_cb.toml"));
    let made = verified.value();
    for (l, theta) in made.toolpath.locations.iter().zip(&made.schedule.theta) {
        assert!((offset_mm(&l.centre, *theta) + 1.5).abs() < 1e-9);
    }
    let check = verified.report().checks.iter().find(|c| c.id == CheckId::TurnOffset).expect("the check");
    assert!(check.worst < 1e-6 && check.note.contains("-1.5"), "{check:?}");
    assert!(made.leads.iter().all(|lead| lead.is_arc()));
    let y = words(&program(&setup, &verified, Control::Iso), 'Y', "(Cutting", "(Retract");
    let [least, most] = [y.iter().copied().fold(f64::INFINITY, f64::min), y.iter().copied().fold(f64::MIN, f64::max)];
    // The last digit of a word.
    assert!(y.len() > 500 && most - least < 1.5e-5, "{least} to {most}");
}

/// A lathe without Y: no program names it, all are read back, and what needs it is refused.
#[test]
fn a_lathe_without_y_is_programmed_without_it() {
    let lathe = || machine("mill_turn_no_y.toml");
    let (setup, verified) = planned(&["machine.b_deg=5"], lathe());
    let made = verified.value();
    assert_eq!((made.schedule.kind, setup.job.post.control.clone()), (ScheduleKind::Eccentric, vec![Control::Iso]));
    assert!(made.leads.iter().all(|lead| lead.is_arc()));
    for control in [Control::Iso, Control::Linuxcnc, Control::LinuxcncFeed, Control::SiemensAxes, Control::FanucAxes] {
        let text = program(&setup, &verified, control);
        let code = text.lines().filter(|l| !l.starts_with(['(', ';', '%']));
        let mut lines = 0;
        for line in code {
            assert!(!line.split(' ').any(|w| w.starts_with('Y')), "{control}: {line}");
            lines += usize::from(line.contains("G1 ") && line.contains(" X") && line.contains(" C"));
        }
        assert!(lines > 500, "{control}: {lines}");
    }
    // The tool set off the spindle's axis keeps that offset.
    let set_off = |text: String| text.replace("gauge_mm = [0.0, 0.0, 0.0]", "gauge_mm = [0.0, 1.25, 0.0]");
    let (_, verified) = planned(&["machine.b_deg=5"], of_prism::machine("mill_turn_no_y.toml", set_off));
    let made = verified.value();
    for (l, theta) in made.toolpath.locations.iter().zip(&made.schedule.theta) {
        assert!((offset_mm(&l.centre, *theta).abs() - 1.25).abs() < 2e-6);
    }
    let timed = refused(&["schedule.kind=\"time\""], lathe());
    assert!(timed.kind == ErrorKind::Usage && timed.message.contains("has no Y"), "{timed}");
    let across = |text: String| text.replace("along = [0.0, 0.0, 1.0]", "along = [0.0, 1.0, 0.0]");
    let swung = refused(&[], of_prism::machine("mill_turn_no_y.toml", across));
    assert!(swung.kind == ErrorKind::Usage && swung.message.contains("has no Y, and would need it"), "{swung}");
    let dialect = Dialect::built_in(Control::Siemens).expect("a dialect");
    let over_the_part = setup.program(&dialect, &verified).expect_err("refused");
    assert!(over_the_part.message.contains("moves X, Y and Z together"), "{over_the_part}");
}

/// A program of others that moves Y there is refused with its line.
#[test]
fn a_program_that_names_what_a_lathe_has_not_is_refused() {
    let (setup, verified) = planned(&["machine.b_deg=5"], machine("mill_turn_no_y.toml"));
    let text = program(&setup, &verified, Control::Iso);
    let models = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("models");
    let dir = tempfile::tempdir().expect("a folder");
    let lathe = std::fs::read_to_string(models.join("machines/mill_turn_no_y.toml")).expect("a machine");
    let verify = |text: &str, lathe: &str| {
        std::fs::write(dir.path().join("their.nc"), text).expect("written");
        std::fs::write(dir.path().join("lathe.toml"), lathe).expect("written");
        std::fs::write(dir.path().join("tool.toml"), toml::to_string(&setup.job.tool).expect("a tool"))
            .expect("written");
        let mut command = std::process::Command::new(env!("CARGO_BIN_EXE_bladewright"));
        command.args(["--quiet", "verify", "their.nc", "--tool", "tool.toml", "--part"]).arg(models.join("prism.step"));
        command.args(["--machine", "lathe.toml"]).current_dir(dir.path());
        let out = command.output().expect("the command starts");
        (out.status.code(), String::from_utf8_lossy(&out.stderr).into_owned())
    };
    let moved = text.replacen("\nG1 X", "\nG1 Y0.5 X", 1);
    let line = 1 + text.lines().position(|l| l.starts_with("G1 X")).expect("a move");
    let (code, said) = verify(&moved, &lathe);
    assert!(
        code != Some(0) && said.contains("Y goes to 0.5000 mm, and the machine has no such axis"),
        "{code:?} {said}"
    );
    assert!(said.contains(&format!("line {line}")), "{said}");
    let (code, said) = verify(&text.replacen("\nG1 X", "\nG1 Y0 X", 1), &lathe);
    assert!(code == Some(0), "{code:?} {said}");
    // A shift of the zero would be a radius to one control and a diameter to another.
    let diameters = lathe.replacen("max_mm = 650.0", "max_mm = 650.0\nwords = \"diameter\"", 1);
    let (code, said) = verify(&text.replacen("\nG1 X", "\nG52 X1\nG1 X", 1), &diameters);
    assert!(code != Some(0) && said.contains("words of X are diameters on this machine"), "{code:?} {said}");
}

/// A lathe whose X counts diameters: each word of X is twice the position, to the rounding of
/// words, and is read so; the program says it. Programs retract by X there, not along the blade.
#[test]
fn a_lathe_may_count_diameters() {
    let diameters = |text: String| text.replacen("max_mm = 650.0", "max_mm = 650.0\nwords = \"diameter\"", 1);
    let lathe = of_prism::machine("mill_turn_no_y.toml", diameters);
    let (setup, verified) = planned(&["machine.b_deg=5"], lathe);
    let text = program(&setup, &verified, Control::Iso);
    assert!(text.contains("DIAMETER words of X are twice its position"), "{text}");
    let (radii, _) = planned(&["machine.b_deg=5"], machine("mill_turn_no_y.toml"));
    let by_radius = program(&radii, &verified, Control::Iso);
    assert!(text.contains("\nG53 G0 X1300.00000\n") && by_radius.contains("\nG53 G0 X650.00000\n"));
    assert!(!by_radius.contains("DIAMETER"));
    let [twice, once] = [&text, &by_radius].map(|t| words(t, 'X', "(Cutting", "(Retract"));
    assert!(once.len() > 500 && twice.len() == once.len());
    assert!(twice.iter().zip(&once).all(|(d, r)| (d - 2.0 * r).abs() < 1.6e-5));
    let fanuc = Dialect::built_in(Control::Fanuc).expect("a dialect");
    let over_the_part = setup.program(&fanuc, &verified).expect_err("refused");
    assert!(over_the_part.message.contains("counts diameters in X"), "{over_the_part}");
}

/// The planted fault: a Y that has moved on the machine is found.
#[test]
fn an_offset_that_moves_is_found() {
    let changes = ["machine.b_deg=5", "schedule.kind=\"eccentric\"", "schedule.offset_mm=1"];
    let (setup, verified) = planned(&changes, machine("mill_turn_cb.toml"));
    let mut plan = verified.value().clone();
    let y = setup.machine.linear()[1];
    plan.motion.position[200][y] += 0.002;
    let Ok(Verdict::Failed(rejected)) = setup.verdict(plan, &Silent) else { panic!("it passes") };
    let found = rejected.report().checks.iter().find(|c| c.id == CheckId::TurnOffset).expect("the check");
    assert!(!found.passed && (found.worst - 0.002).abs() < 1e-4, "{found:?}");
}

/// Times and angles of the program alone: in every turn between the first and the last the blade
/// turns at one speed, to a thousandth.
#[test]
fn a_blade_that_turns_evenly_does_so_in_the_program() {
    let changes = ["schedule.kind=\"even\"", "feed.feed_mm_min=1500"];
    let (setup, verified) = planned(&changes, machine("mill_turn_cb.toml"));
    let made = verified.value();
    assert!(made.schedule.rates.len() == made.toolpath.turns.len() && made.schedule.reversals == 0);
    program(&setup, &verified, Control::LinuxcncFeed);
    program(&setup, &verified, Control::Siemens);
    let text = program(&setup, &verified, Control::Linuxcnc);
    let (c, f) = (words(&text, 'C', "; Cutting", "; Retract"), words(&text, 'F', "; Cutting", "; Retract"));
    assert_eq!(c.len(), f.len());
    let rates = &made.schedule.rates[1..made.schedule.rates.len() - 1];
    let [least, most] =
        [rates.iter().copied().fold(f64::INFINITY, f64::min), rates.iter().copied().fold(0.0, f64::max)];
    let mut judged = 0;
    for i in 1..c.len() {
        // Within a turn of its ends nothing is promised.
        if (c[i] - c[0]).abs() < 432.0 || (c[c.len() - 1] - c[i]).abs() < 432.0 {
            continue;
        }
        // Inverse time: a line takes 1/F minutes.
        let rate = (c[i] - c[i - 1]).to_radians().abs() * f[i] / 60.0;
        assert!((least * 0.998..=most * 1.002).contains(&rate), "line {i}: {rate} is none of {rates:?}");
        judged += 1;
    }
    assert!(judged > 500 && most < 1.01 * least, "{judged} lines, {rates:?}");
    let check = verified.report().checks.iter().find(|c| c.id == CheckId::TurnRate).expect("the check");
    assert!(check.worst <= 1e-3 && !check.note.contains("no turn"), "{check:?}");
}

/// The planted fault: a turn in which the blade hurries is found.
#[test]
fn a_turn_that_hurries_is_found() {
    let (setup, verified) = planned(&["schedule.kind=\"even\"", "feed.feed_mm_min=1500"], machine("mill_turn_cb.toml"));
    let (mut plan, mut jerked) = (verified.value().clone(), verified.value().clone());
    // A schedule that says that it varies has no reason to without a least feed per tooth.
    plan.schedule.spread = 2.0;
    let turn = plan.toolpath.turns[2];
    let row = turn.first + turn.count / 2;
    let late = 0.01 * (plan.motion.t_s[row + 1] - plan.motion.t_s[row]);
    plan.motion.t_s.iter_mut().skip(row + 1).for_each(|t| *t += late);
    plan.leads[1].motion.t_s.iter_mut().for_each(|t| *t += late);
    let Ok(Verdict::Failed(rejected)) = setup.verdict(plan, &Silent) else { panic!("it passes") };
    let found = rejected.report().checks.iter().find(|c| c.id == CheckId::TurnRate).expect("the check");
    assert!(!found.passed && (0.005..0.02).contains(&found.worst) && found.row == Some(row), "{found:?}");
    // A single jerk that no axis has, where those of a few steps may be off.
    jerked.motion.jerk[row][setup.machine.turning_axis()] = f64::NAN;
    let Ok(Verdict::Failed(rejected)) = setup.verdict(jerked, &Silent) else { panic!("it passes") };
    let found = rejected.report().checks.iter().find(|c| c.id == CheckId::PlanMotion).expect("the check");
    assert!(!found.passed && found.note.contains("over its limit"), "{found:?}");
}

/// Feed per tooth and cutting speed are limits of the plan, and checked from its contacts and
/// times.
#[test]
fn a_tooth_cuts_no_more_than_it_may() {
    let changes = ["post.spindle_rpm=3000", "cut.teeth=2", "cut.fz_mm=[0.0, 0.12]", "cut.speed_min_m_min=20"];
    let (setup, verified) = planned(&changes, machine("mill_turn_cb.toml"));
    let check = verified.report().checks.iter().find(|c| c.id == CheckId::ToothFeed).expect("the check");
    // 3000 1/min by 2 teeth by 0.12 mm are 720 mm/min, less than the feed of 2000.
    assert!(check.passed && (0.11..=0.1201).contains(&check.worst), "{check:?}");
    let made = verified.value();
    let least = (20.0 * 1000.0 / 60.0 / (std::f64::consts::TAU * 3.0 * 50.0)).asin();
    for (row, l) in made.toolpath.locations.iter().enumerate() {
        let axis = made.toolpath.cone(row).tool_axis(made.schedule.theta[row]);
        assert!(axis.angle(&l.normal) >= least - 1e-6, "{row}");
    }
    // A spindle of half that speed, or half the teeth: twice the feed per tooth, which is found.
    let slower = setup.job.clone();
    let mut setup = setup;
    setup.job = job::Job { post: slower.post.clone(), ..slower };
    setup.job.post.spindle_rpm = 1500.0;
    let Ok(Verdict::Failed(rejected)) = setup.verdict(verified.value().clone(), &Silent) else { panic!("it passes") };
    let found = rejected.report().checks.iter().find(|c| c.id == CheckId::ToothFeed).expect("the check");
    assert!(!found.passed && (found.worst / check.worst - 2.0).abs() < 1e-6, "{found:?}");
}

/// A range of offsets is kept by all of the motion; one that leaves no schedule is refused.
#[test]
fn a_range_of_offsets_is_kept() {
    let (_, free) = planned(&["schedule.kind=\"optimal\""], machine("mill_turn_cb.toml"));
    let offsets = |plan: &Plan| -> Vec<f64> {
        let of = plan.toolpath.locations.iter().zip(&plan.schedule.theta);
        of.map(|(l, theta)| offset_mm(&l.centre, *theta)).collect()
    };
    assert!(offsets(free.value()).iter().any(|e| e.abs() > 2.0), "the range would be no limit");
    let (_, kept) =
        planned(&["schedule.kind=\"optimal\"", "channel.offset_mm=[-2.0, 2.0]"], machine("mill_turn_cb.toml"));
    assert!(offsets(kept.value()).iter().all(|e| e.abs() <= 2.0));
    // The travel of a machine's own Y is a limit of the channel too.
    let narrow = mill_turn(&["min_mm = -40.0", "max_mm = 40.0"], &["min_mm = -2.0", "max_mm = 2.0"]);
    let (_, kept) = planned(&["schedule.kind=\"optimal\""], narrow);
    assert!(offsets(kept.value()).iter().all(|e| e.abs() <= 2.0 + 1e-9));
}

/// A part that is too large for the machine has the channel of any machine.
#[test]
fn a_part_that_does_not_turn_there_is_planned_without_the_machines_room() {
    let small = mill_turn(&["swing_diameter_mm = 500.0"], &["swing_diameter_mm = 20.0"]);
    assert!(setup(&[], small).expect("a setup").channel_options().travel.is_empty());
    assert_eq!(setup(&[], machine("mill_turn_cb.toml")).expect("a setup").channel_options().travel.len(), 3);
}

#[test]
fn what_cannot_be_is_refused() {
    let mill = || machine("mill_turn_cb.toml");
    let far = refused(&["schedule.kind=\"eccentric\"", "schedule.offset_mm=30"], mill());
    assert_eq!(far.kind, ErrorKind::Infeasible);
    assert!(far.message.contains("schedule.offset_mm is 30 mm, but the ball centre comes as near"), "{far}");
    assert!(matches!(far.infeasible.as_deref(), Some(Infeasible::OffsetOutside { .. })));
    let side = refused(&["channel.offset_mm=[60.0, 61.0]"], mill());
    assert!(side.kind == ErrorKind::Infeasible && side.message.contains("Y (channel.offset_mm)"), "{side}");
    let said = |changes: &[&str]| {
        let e = refused(changes, mill());
        assert_eq!(e.kind, ErrorKind::Usage, "{e}");
        e.message
    };
    assert!(said(&["cut.teeth=2"]).contains("post.spindle_rpm is missing"));
    assert!(said(&["post.spindle_rpm=3000", "cut.fz_mm=[0.1, 0.2]"]).contains("cut.teeth is missing"));
    assert!(said(&["post.spindle_rpm=3000", "cut.teeth=2", "cut.fz_mm=[0.2, 0.1]"]).contains("must rise"));
    assert!(said(&["channel.offset_mm=[2.0, 1.0]"]).contains("channel.offset_mm"));
    let slow = ["post.spindle_rpm=500", "cut.teeth=2", "cut.speed_min_m_min=100"];
    assert!(said(&slow).contains("cuts at 9.4 m/min at most"), "{}", said(&slow));
}

/// A bull-nose cutter cuts a blade that turns evenly, and each of its teeth no more than it may.
#[test]
fn a_bull_nose_cuts_a_blade_that_turns_evenly() {
    let bull = ["tool.radius_mm=8", "tool.corner_radius_mm=2", "tool.shank_radius_mm=8", "tool.taper_deg=0"];
    let even = ["machine.b_deg=0", "schedule.kind=\"even\"", "region.start_mm=30", "region.end_mm=22"];
    let cut = ["post.spindle_rpm=6000", "cut.teeth=2", "cut.fz_mm=[0.0, 0.08]"];
    let changes: Vec<&str> = [&bull[..], &even, &cut].concat();
    let (setup, verified) = planned(&changes, machine("mill_turn_cb.toml"));
    let made = verified.value();
    assert!(made.toolpath.disc_radius_mm == 6.0 && made.schedule.kind == ScheduleKind::Even);
    assert!(made.schedule.reversals == 0 && made.schedule.rates.len() == made.toolpath.turns.len());
    let checks = &verified.report().checks;
    let of = |id: CheckId| checks.iter().find(|c| c.id == id).expect("the check");
    assert!(of(CheckId::TurnRate).worst <= 1e-3 && !of(CheckId::TurnRate).note.contains("no turn"));
    assert!((0.07..=0.0801).contains(&of(CheckId::ToothFeed).worst), "{:?}", of(CheckId::ToothFeed));
    program(&setup, &verified, Control::Siemens);
    // Leaning forwards all round, its axis is nowhere at one offset from the blade's.
    let stays = ["machine.b_deg=0", "schedule.kind=\"eccentric\"", "region.start_mm=30", "region.end_mm=22"];
    let e = refused(&[&bull[..], &stays].concat(), machine("mill_turn_cb.toml"));
    assert!(matches!(e.infeasible.as_deref(), Some(Infeasible::NoOffset { .. })), "{e}");
    let within = ["machine.b_deg=0", "channel.offset_mm=[-1.0, 1.0]", "region.start_mm=30", "region.end_mm=22"];
    let e = refused(&[&bull[..], &within].concat(), machine("mill_turn_cb.toml"));
    assert!(e.kind == ErrorKind::Infeasible && e.message.contains("Y (channel.offset_mm)"), "{e}");
}

/// Widths of passes beside the first-order ones of a published table for turn-milling (Shi, Qiao
/// and Rao): those are too wide, by what is of second order in the scallop.
#[test]
fn published_widths_are_too_wide_by_the_second_order() {
    let published = |r: f64, h: f64, part: f64| 2.0 * (2.0 * h * r).sqrt() * (part / (part + r)).abs().sqrt();
    let cases = [
        (6.0, 0.01, 20.0, 0.0007),
        (6.0, 0.01, -20.0, 0.0002),
        (6.0, 0.1, 20.0, 0.0066),
        (6.0, 0.1, -20.0, 0.0015),
        (2.0, 0.05, 3.0, 0.014),
        (2.0, 0.05, 1.0, 0.028),
    ];
    for (r, h, part, over) in cases {
        let own = scallop::width_mm(r, h, 1.0 / part).expect("the ball fits");
        let found = published(r, h, part) / own - 1.0;
        assert!((found - over).abs() < 0.05 * over + 6e-5, "R {r}, h {h}, part {part}: {found} beside {over}");
    }
}
