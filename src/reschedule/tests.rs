//! Programs round a cylinder whose tool swings to and fro.
#![allow(clippy::unwrap_used)]

use std::f64::consts::TAU;
use std::fmt::Write;

use super::*;
use crate::artifact::program::{Grammar, Language, Programmed};
use crate::artifact::schedule::ScheduleKind;
use crate::artifact::toolpath::{CutterLocation, Turn};
use crate::artifact::{Cones, Stand};
use crate::error::ErrorKind;
use crate::geometry::{Point, Vector};
use crate::machine::Machine;
use crate::observe::Silent;
use crate::read::program::Zero;
use crate::sample;

/// Feed of the programs, mm/min.
const FEED: f64 = 2500.0;
/// Lean of the tool, as the sample's.
const B: f64 = sample::B_RAD;

/// Ball centre and θ at a share of the path.
type Course = fn(f64) -> (Point, f64);

fn on_cylinder(x: f64, azimuth: f64) -> Point {
    let r = sample::PART_RADIUS + sample::tool().radius_mm;
    Point::new(x, r * azimuth.cos(), r * azimuth.sin())
}

/// Three turns down a cylinder, the lead swings nine times a turn.
fn helix(f: f64) -> (Point, f64) {
    let azimuth = 3.0 * TAU * f;
    (on_cylinder(40.0 - 6.0 * f, azimuth), azimuth + 0.3 + 0.15 * (9.0 * azimuth).sin())
}

fn clockwise(f: f64) -> (Point, f64) {
    let (c, theta) = helix(f);
    (Point::new(c.x, c.y, -c.z), -theta)
}

/// Four passes to and fro over a third of the way round.
fn zigzag(f: f64) -> (Point, f64) {
    let pass = (4.0 * f).min(3.999_999).floor();
    let share = 4.0 * f - pass;
    let there = if (pass as u32).is_multiple_of(2) { share } else { 1.0 - share };
    let azimuth = TAU / 3.0 * there;
    (on_cylinder(40.0 - pass - 0.2 * share, azimuth), azimuth + 0.3 + 0.1 * (20.0 * azimuth).sin())
}

fn language(grammar: Grammar, programmed: Programmed) -> Language {
    Language { grammar, programmed, shortest_way: false, feed_counts_degrees: false }
}

/// A program of `n` places, with a way to and from it.
fn program(course: Course, n: usize, language: Language) -> String {
    let (tool, machine) = (sample::tool(), Machine::demo().unwrap());
    let mut out = match language.grammar {
        Grammar::Gcode => "T1 M6\nG90 G94 S6000 M3\n".to_owned(),
        Grammar::Heidenhain => "0 BEGIN PGM A MM\n1 TOOL CALL 1 Z S6000\n2 M3\n3 M128\n".to_owned(),
        Grammar::Apt => "PARTNO/A\nSPINDL/6000,CLW\nRAPID\n".to_owned(),
    };
    if language.grammar == Grammar::Gcode && language.programmed == Programmed::Tip {
        out.push_str("TRAORI\n");
    }
    let mut line = |k: usize, lift: f64, how: &str| {
        let (centre, theta) = course(k as f64 / (n - 1) as f64);
        let stand = Stand::about_blade(centre, theta, B).lifted(lift);
        let axes = machine.place(&stand, None, tool.length_mm());
        let p = match language.programmed {
            Programmed::Tip => stand.tip(tool.radius_mm),
            Programmed::Centre => stand.centre,
            Programmed::Machine => Point::from(machine.linear().map(|i| axes[i])),
        };
        let [a, b] = [0, 1].map(|i| axes[machine.rotary().nth(i).unwrap()].to_degrees());
        let v = stand.axis();
        let _ = match (language.grammar, how) {
            (Grammar::Gcode, "rapid") => writeln!(out, "G0 X{:.4} Y{:.4} Z{:.4} A{a:.4} B{b:.4}", p.x, p.y, p.z),
            (Grammar::Gcode, "first") => writeln!(out, "G1 X{:.4} Y{:.4} Z{:.4} A{a:.4} F{FEED}", p.x, p.y, p.z),
            (Grammar::Gcode, _) => writeln!(out, "X{:.4} Y{:.4} Z{:.4} A{a:.4}", p.x, p.y, p.z),
            (Grammar::Heidenhain, "rapid") => {
                writeln!(out, "0 L X{:+.4} Y{:+.4} Z{:+.4} A{a:+.4} B{b:+.4} FMAX", p.x, p.y, p.z)
            }
            (Grammar::Heidenhain, _) => writeln!(out, "0 L X{:+.4} Y{:+.4} Z{:+.4} A{a:+.4} F{FEED}", p.x, p.y, p.z),
            (Grammar::Apt, _) => {
                if how == "first" {
                    let _ = writeln!(out, "FEDRAT/{FEED:.1},MMPM");
                }
                // Over two lines, as files of 72 columns have it.
                writeln!(out, "GOTO/{:.5},{:.5},{:.5},{:.9},{:.9},$\n{:.9}", p.x, p.y, p.z, v.x, v.y, v.z)
            }
        };
    };
    line(0, 30.0, "rapid");
    line(0, 0.0, "first");
    (1..n).for_each(|k| line(k, 0.0, ""));
    line(n - 1, 30.0, "");
    match language.grammar {
        Grammar::Gcode => out.push_str("M30\n"),
        Grammar::Heidenhain => out.push_str("0 M30\n0 END PGM A MM\n"),
        Grammar::Apt => out.push_str("FINI\n"),
    }
    if language.grammar == Grammar::Heidenhain {
        let code = |l: &str| l.split_once(' ').map_or(String::new(), |(_, c)| c.to_owned());
        out = out.lines().enumerate().map(|(k, l)| format!("{k} {}\n", code(l))).collect();
    }
    out
}

fn options(kind: ScheduleKind) -> RescheduleOptions {
    let audit = AuditOptions::default().with(|s| s.surface_samples = 2000);
    // The sample's facets lie up to 0.043 mm within the cylinder.
    let (stock_mm, contact_mm) = (Some(0.0), 0.06);
    let mut options = RescheduleOptions { stock_mm, contact_mm, audit, ..RescheduleOptions::default() };
    options.schedule.kind = kind;
    options
}

fn run(text: &str, language: Language, options: &RescheduleOptions) -> Result<Rescheduled> {
    let (tool, machine) = (sample::tool(), Machine::demo().unwrap());
    let bench = Bench { language, zero: Zero::default(), tool: &tool, machine: &machine };
    reschedule(text, &sample::blade(), &bench, options, &Silent)
}

/// Line numbers whose text is not the old one, where both have as many lines.
fn changed(old: &str, new: &str) -> Vec<usize> {
    let pairs = old.lines().zip(new.lines()).enumerate();
    pairs.filter(|(_, (a, b))| a != b).map(|(k, _)| k + 1).collect()
}

/// Tool axes at the ends of the feed moves.
fn axes_of(text: &str, language: Language) -> Vec<(Point, Vector)> {
    let (tool, machine) = (sample::tool(), Machine::demo().unwrap());
    let bench = Bench { language, zero: Zero::default(), tool: &tool, machine: &machine };
    let moves = program::follow(&program::read(text, language).unwrap().blocks, &bench).unwrap();
    let cuts = moves.iter().filter(|m| m.seconds.is_some());
    cuts.map(|m| m.pose(1.0, &tool, &machine)).map(|p| (p.centre, p.axis)).collect()
}

#[test]
fn the_swing_goes_and_the_balls_stay() {
    for (grammar, programmed) in [
        (Grammar::Gcode, Programmed::Tip),
        (Grammar::Gcode, Programmed::Machine),
        (Grammar::Heidenhain, Programmed::Centre),
        (Grammar::Apt, Programmed::Tip),
    ] {
        let language = language(grammar, programmed);
        for course in [helix as Course, clockwise] {
            let text = program(course, 721, language);
            let made = run(&text, language, &options(ScheduleKind::Optimal)).unwrap();
            let who = format!("{grammar:?} {programmed:?}");
            assert_eq!(made.stretches.len(), 1, "{who}");
            let stretch = &made.stretches[0];
            let [before, after] = stretch.reversals.unwrap();
            assert!(before > 20 && after == 0, "{who}: {before}, {after}");
            let [before, after] = stretch.time_s.unwrap();
            assert!(after < 0.8 * before, "{who}: {before} s, {after} s");
            assert!(made.centre_off_mm <= made.centre_limit_mm && made.centre_limit_mm < 1e-4, "{who}");
            // The feed asks for more than the rotary axis can, by less than before.
            let failed = |a: &Audit| -> Vec<(String, f64)> {
                let all = a.checks.iter().map(|c| &c.check).filter(|c| !c.passed);
                all.map(|c| (c.id.to_string(), c.worst)).collect()
            };
            let (was, is) = (failed(&made.before), failed(&made.after));
            assert!(was.len() == 1 && was[0].0 == "a-velocity", "{who}: {was:?}");
            assert!(is.is_empty() || is.len() == 1 && is[0].0 == was[0].0 && is[0].1 < was[0].1, "{who}: {is:?}");
            let clearance = |a: &Audit| a.checks.iter().find(|c| c.check.id == CheckId::Clearance).unwrap().check.worst;
            // Never nearer.
            let [was, is] = [&made.before, &made.after].map(clearance);
            assert!(is >= was.min(AMPLE_MM), "{who}: {was} {is} {:?}", stretch.clearance_mm);
            if made.lines_added == 0 {
                let [first, last] = stretch.new_lines.unwrap();
                // One line more says the feed that the program goes on with.
                let all = changed(&text, &made.text);
                assert!(all.iter().all(|l| (first - 1..=last + 1).contains(l)), "{who}");
            }
            // What the tool does outside is what it did.
            let (old, new) = (axes_of(&text, language), axes_of(&made.text, language));
            let same = |a: &(Point, Vector), b: &(Point, Vector)| (a.0 - b.0).norm() < 1e-3 && a.1.angle(&b.1) < 1e-6;
            assert!(same(&old[0], &new[0]) && same(old.last().unwrap(), new.last().unwrap()), "{who}");
            // A second time there is nothing to gain.
            let again = run(&made.text, language, &options(ScheduleKind::Optimal));
            assert!(again.is_err() || again.unwrap().time_s()[1] > 0.97 * after, "{who}");
        }
    }
}

#[test]
fn the_speed_of_the_ball_stays() {
    let language = language(Grammar::Gcode, Programmed::Tip);
    let text = program(helix, 721, language);
    let made = run(&text, language, &options(ScheduleKind::Optimal)).unwrap();
    let (tool, machine) = (sample::tool(), Machine::demo().unwrap());
    let bench = Bench { language, zero: Zero::default(), tool: &tool, machine: &machine };
    let speeds = |text: &str| -> Vec<f64> {
        let moves = program::follow(&program::read(text, language).unwrap().blocks, &bench).unwrap();
        let way = |m: &Moved| (m.pose(1.0, &tool, &machine).centre - m.pose(0.0, &tool, &machine).centre).norm();
        moves.iter().filter_map(|m| Some(way(m) / m.seconds?)).collect()
    };
    let (old, new) = (speeds(&text), speeds(&made.text));
    assert_eq!((old.len(), new.len(), made.lines_added), (722, 722, 0));
    let worst = old.iter().zip(&new).skip(1).map(|(a, b)| (b / a - 1.0).abs()).fold(0.0, f64::max);
    assert!(worst < 0.006, "{worst}");
    // A new feed is that of the ball centre.
    let asked = RescheduleOptions { feed_mm_min: Some(3000.0), ..options(ScheduleKind::Optimal) };
    let made = run(&text, language, &asked).unwrap();
    let slow = speeds(&made.text);
    assert!(slow[2..720].iter().all(|v| (v / 50.0 - 1.0).abs() < 0.006), "{:?}", &slow[..8]);
    assert!((slow[721] / old[721] - 1.0).abs() < 0.006);
}

#[test]
fn no_axis_is_asked_for_more_than_it_can_or_was_asked_for() {
    let language = language(Grammar::Gcode, Programmed::Tip);
    let text = program(helix, 721, language).replace("F2500", "F40000");
    let made = run(&text, language, &options(ScheduleKind::Optimal)).unwrap();
    assert_eq!(made.lines_added, 0);
    let (tool, machine) = (sample::tool(), Machine::demo().unwrap());
    let bench = Bench { language, zero: Zero::default(), tool: &tool, machine: &machine };
    // Of every line: the velocity that its F asks of each axis.
    let asked = |text: &str| -> Vec<Vec<f64>> {
        let moves = program::follow(&program::read(text, language).unwrap().blocks, &bench).unwrap();
        let of = |m: &Moved| {
            let ([from, to], seconds) = ([0.0, 1.0].map(|f| m.axes(f, &tool, &machine)), m.seconds?);
            Some((0..machine.axes().len()).map(|k| (to[k] - from[k]).abs() / seconds).collect())
        };
        moves.iter().filter_map(of).collect()
    };
    let (old, new) = (asked(&text), asked(&made.text));
    assert_eq!(old.len(), new.len());
    let mut limited = 0;
    for (line, (old, new)) in old.iter().zip(&new).enumerate() {
        for ((axis, old), new) in machine.axes().iter().zip(old).zip(new) {
            let most = axis.limits.velocity.max(*old);
            // F is rounded within 0.5 %, positions to a tenth of a micrometre.
            assert!(*new <= 1.01 * most, "line {line}, {}: {new}, was {old}", axis.name);
            limited += usize::from(*old <= axis.limits.velocity && *new > 0.99 * axis.limits.velocity);
        }
    }
    assert!(limited > 10, "{limited}");
}

#[test]
fn passes_to_and_fro_are_stretches_of_their_own() {
    let language = language(Grammar::Apt, Programmed::Tip);
    let text = program(zigzag, 801, language);
    let made = run(&text, language, &options(ScheduleKind::Optimal)).unwrap();
    assert_eq!(made.stretches.len(), 4);
    for stretch in &made.stretches {
        assert_eq!(stretch.reversals.map(|r| r[1]), Some(0), "{stretch:?}");
    }
}

#[test]
fn the_schedule_is_that_of_the_stages() {
    let language = language(Grammar::Apt, Programmed::Tip);
    let text = program(helix, 361, language);
    let made = run(&text, language, &options(ScheduleKind::Optimal)).unwrap();
    let theta = &made.stretches[0].theta;
    // The same places, channel and schedule, put together here.
    let (tool, machine, blade) = (sample::tool(), Machine::demo().unwrap(), sample::blade());
    let bench = Bench { language, zero: Zero::default(), tool: &tool, machine: &machine };
    let read = Program::read(&text, &bench).unwrap();
    let places = stretches::places(&read, &blade.part);
    let places: Vec<&LineEnd> = places.iter().filter(|p| p.seconds.is_some()).take(361).collect();
    let mut path = sample::plan(1, 8).toolpath;
    path.cones = Cones::about_blade(places[0].stand.cone.lean_rad);
    (path.locations, path.turns) = (Vec::new(), Vec::new());
    let (mut s_mm, mut base_mm, mut turned) = (0.0, 0.0, 0.0f64);
    for (k, p) in places.iter().enumerate() {
        let c = p.stand.centre;
        if k > 0 {
            let before = places[k - 1].stand.centre;
            s_mm += (c - before).norm();
            turned += (c.z * before.y - c.y * before.z).atan2(c.y * before.y + c.z * before.z);
        }
        let turn = (turned / TAU) as u32;
        if path.turns.len() <= turn as usize {
            base_mm = s_mm;
            path.turns.push(Turn { first: k, count: 0, length_mm: 0.0 });
        }
        let open = path.turns.last_mut().unwrap();
        (open.count, open.length_mm) = (open.count + 1, s_mm - base_mm);
        let foot = p.at.as_ref().unwrap().point;
        let normal = (c - foot).normalize();
        let contact = c - normal * tool.radius_mm;
        path.locations.push(CutterLocation { turn, turn_s_mm: s_mm - base_mm, s_mm, centre: c, contact, normal });
    }
    let [clearance_mm, holder_clearance_mm] = made.stretches[0].clearance_mm.unwrap();
    let clear = ChannelSettings { clearance_mm, holder_clearance_mm, ..ChannelSettings::default() };
    let options = crate::channel::ChannelOptions {
        settings: clear,
        theta_limits_rad: machine.theta_limits(B),
        ..Default::default()
    };
    let channel = crate::channel::plan(&blade, &tool, &path, &options, &Silent).unwrap();
    let ends = [theta[0].after_deg, theta.last().unwrap().after_deg].map(f64::to_radians);
    let settings = ScheduleSettings { kind: ScheduleKind::Optimal, ..ScheduleSettings::default() };
    let asked = crate::schedule::ScheduleOptions { settings, ends_rad: Some(ends), ..Default::default() };
    let afresh = crate::schedule::plan(ScheduleKind::Optimal, &path, &channel, &asked, &Silent).unwrap();
    let worst = afresh.theta.iter().zip(theta).map(|(a, b)| (a.to_degrees() - b.after_deg).abs()).fold(0.0, f64::max);
    assert!(worst < 1e-9, "{worst}");
}

#[test]
fn lines_that_cannot_be_written_anew_stay() {
    let language = language(Grammar::Gcode, Programmed::Tip);
    let text = program(helix, 721, language);
    let lines: Vec<&str> = text.lines().collect();
    let reasons = |text: &str| {
        let e = run(text, language, &options(ScheduleKind::Optimal)).unwrap_err();
        match e.infeasible.as_deref() {
            Some(Infeasible::NoStretchGains { reasons, .. }) => reasons.clone(),
            _ => panic!("{e:?}"),
        }
    };
    // Steps, in a line of the stretch.
    let numbers = |line: &str| -> Vec<f64> { line.split(' ').filter_map(|w| w.get(1..)?.parse().ok()).collect() };
    let (from, to) = (numbers(lines[360]), numbers(lines[361]));
    let step = |k: usize| to[k] - from[k];
    let in_steps = format!("X=IC({:.4}) Y=IC({:.4}) Z=IC({:.4}) A{:.4}", step(0), step(1), step(2), to[3]);
    let mut with_steps = lines.clone();
    with_steps[361] = &in_steps;
    let why = reasons(&format!("{}\n", with_steps.join("\n")));
    assert!(why.len() == 1 && why[0].starts_with("line 362: "), "{why:?}");
    // In a subprogram that is run twice every line would be two.
    let (head, cut) = (lines[..4].join("\n"), lines[4..725].join("\n"));
    let why = reasons(&format!("{head}\nM98 P7\n{}\nM98 P7\nM30\nO7\n{cut}\nM99\n", lines[3]));
    assert!(why.len() == 2 && why.iter().all(|w| w.ends_with("it is run more than once")), "{why:?}");
    // An arc parts two stretches, which are written anew.
    let (a, b) = (numbers(lines[360]), numbers(lines[361]));
    let radius = 1000.0;
    let arc = format!("G17 G2 X{:.4} Y{:.4} Z{:.4} A{:.4} CR={radius}\nG1", b[0], b[1], b[2], b[3]);
    assert!((a[0] - b[0]).hypot(a[1] - b[1]) > 0.0);
    let mut with_arc = lines.clone();
    with_arc[361] = &arc;
    let made = run(&format!("{}\n", with_arc.join("\n")), language, &options(ScheduleKind::Optimal)).unwrap();
    assert_eq!(made.stretches.len(), 2);
    assert!(made.stretches[0].lines[1] < 362 && made.stretches[1].lines[0] > 362, "{:?}", made.stretches);
    assert!(made.text.contains(&arc));
}

#[test]
fn a_vector_is_said_whole_or_not_at_all() {
    let language = language(Grammar::Apt, Programmed::Tip);
    // Every other line of the middle leaves out the tool axis, which is then the one before.
    fn still(f: f64) -> (Point, f64) {
        let (c, theta) = helix(f);
        (c, helix((f * 360.0 / 4.0).floor() * 4.0 / 360.0).1.min(theta + 1.0))
    }
    let text = program(still, 361, language);
    let (mut last, mut lines) = (String::new(), Vec::new());
    let all: Vec<&str> = text.lines().collect();
    for line in &all {
        let goto = lines.last().filter(|l: &&String| l.starts_with("GOTO") && l.ends_with('$')).cloned();
        let Some(goto) = goto else {
            lines.push((*line).to_owned());
            continue;
        };
        let numbers: Vec<&str> = goto.trim_start_matches("GOTO/").trim_end_matches(",$").split(',').collect();
        let vector = format!("{},{},{line}", numbers[3], numbers[4]);
        lines.pop();
        let axis = if vector == last { String::new() } else { format!(",{vector}") };
        lines.push(format!("GOTO/{}{axis}", numbers[..3].join(",")));
        last = vector;
    }
    let text = lines.join("\n") + "\n";
    assert!(text.lines().any(|l| l.matches(',').count() == 2), "a line leaves its axis out");
    let made = run(&text, language, &options(ScheduleKind::Optimal)).unwrap();
    let gotos = made.text.lines().filter(|l| l.starts_with("GOTO"));
    assert!(gotos.clone().all(|l| matches!(l.matches(',').count(), 2 | 5)), "{}", made.text);
    assert!(gotos.filter(|l| l.matches(',').count() == 5).count() > 300);
}

#[test]
fn bad_input_is_one_sentence() {
    let language = language(Grammar::Gcode, Programmed::Tip);
    let text = program(helix, 181, language);
    let fails = |text: &str, options: &RescheduleOptions| run(text, language, options).unwrap_err();
    let optimal = options(ScheduleKind::Optimal);
    // Beside the part.
    let e = fails(&text.replace("X3", "X23").replace("X4", "X24"), &optimal);
    assert!(e.kind == ErrorKind::Usage && e.message.contains("the part"), "{}", e.message);
    let e = fails(&text, &RescheduleOptions { feed_mm_min: Some(f64::NAN), ..optimal.clone() });
    assert!(e.message.contains("feed"), "{}", e.message);
    let e = fails(&text, &RescheduleOptions { stock_mm: Some(f64::INFINITY), ..optimal.clone() });
    assert!(e.message.contains("stock"), "{}", e.message);
    let e = fails(&text, &RescheduleOptions { contact_mm: 0.0, ..optimal.clone() });
    assert!(e.message.contains("contact"), "{}", e.message);
    let e = fails(&text, &RescheduleOptions { chord_mm: -1.0, ..optimal.clone() });
    assert!(e.message.contains("chord"), "{}", e.message);
    // No ball, another ball, another tool.
    let apt = |more: &str| {
        let language = self::language(Grammar::Apt, Programmed::Tip);
        run(&program(helix, 181, language).replace("RAPID\n", &format!("{more}\nRAPID\n")), language, &optimal)
            .unwrap_err()
    };
    for (line, says) in [
        ("CUTTER/32,6", "line 3 of the program: a cutter of 32 mm with a corner radius of 6 mm is no ball"),
        ("CUTTER/12,6", "its ball has R 6 mm, the tool has R 5 mm"),
        ("LOADTL/1\nLOADTL/2", "it calls tool 2 after tool 1"),
    ] {
        let e = apt(line);
        assert!(e.kind == ErrorKind::Usage && e.message.contains(says), "{}", e.message);
    }
    // Nothing swings: nothing is gained.
    fn even(f: f64) -> (Point, f64) {
        let (c, _) = helix(f);
        (c, 3.0 * TAU * f + 0.3)
    }
    let e = fails(&program(even, 361, language), &optimal);
    assert!(e.kind == ErrorKind::Infeasible, "{e:?}");
    assert!(matches!(e.infeasible.as_deref(), Some(Infeasible::NoStretchGains { stretches: 1, .. })), "{e:?}");
}

#[test]
fn damaged_programs_never_panic() {
    // Marsaglia 2003: xorshift.
    let mut state = 0x2545_f491_4f6c_dd1du64;
    let mut random = move |most: usize| {
        state ^= state << 13;
        state ^= state >> 7;
        state ^= state << 17;
        (state >> 11) as usize % most.max(1)
    };
    let words = [
        "G91", "G93", "G2 X1 I1", "X=IC(1)", "F0", "F1e9", "A=DC(3)", "M30", "G0", "TRAFOOF", "R1=5", "X=R1", "(",
        "G20", "X1e300",
    ];
    let klartext =
        ["0 LBL 1", "0 CALL LBL 1 REP 2", "0 M129", "0 L IX+1", "0 FMAX", "0 CC X+0 Y+0", "0 L X+1,5", "0 STOP M30"];
    let apt = [
        "UNITS/INCHES",
        "RAPID",
        "GODLTA/1",
        "CUTTER/10,5",
        "GOTO/1,2",
        "FEDRAT/0",
        "GOTO/1,2,3$",
        "FINI",
        "MSYS/1,2,3,1,0,0,0,1,0",
    ];
    let mut done = 0;
    for (grammar, programmed, more) in [
        (Grammar::Gcode, Programmed::Tip, &words[..]),
        (Grammar::Gcode, Programmed::Machine, &words[..]),
        (Grammar::Heidenhain, Programmed::Centre, &klartext[..]),
        (Grammar::Apt, Programmed::Tip, &apt[..]),
    ] {
        let language = language(grammar, programmed);
        let good: Vec<String> = program(helix, 61, language).lines().map(str::to_owned).collect();
        for _ in 0..DAMAGED {
            let mut lines = good.clone();
            for _ in 0..1 + random(3) {
                let at = random(lines.len());
                match random(6) {
                    0 => drop(lines.remove(at)),
                    1 => lines.insert(at, lines[at].clone()),
                    2 => lines.insert(at, more[random(more.len())].to_owned()),
                    3 => lines.truncate(at.max(4)),
                    4 => lines[at] = format!("{} {}", lines[at], more[random(more.len())]),
                    _ => lines[at] = lines[at].replacen(char::from(b'0' + random(10) as u8), "7", 2),
                }
            }
            if grammar == Grammar::Heidenhain {
                let code = |l: &String| l.split_once(' ').map_or(String::new(), |(_, c)| c.to_owned());
                lines = lines.iter().enumerate().map(|(k, l)| format!("{k} {}", code(l))).collect();
            }
            let text = lines.join("\n");
            match run(&text, language, &options(ScheduleKind::Optimal)) {
                Ok(made) => {
                    done += 1;
                    assert!(made.centre_off_mm <= made.centre_limit_mm);
                }
                // What writes is never at fault.
                Err(e) => assert!(e.stage != Stage::Post, "{grammar:?} {programmed:?}: {}\n{text}", e.message),
            }
        }
    }
    assert!(done > DAMAGED / 2, "{done} were scheduled anew");
}

/// Damaged programs of each kind.
const DAMAGED: usize = 24;
