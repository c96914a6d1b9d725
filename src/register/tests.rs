//! Programs made on models of the repository, and moved.
#![allow(clippy::unwrap_used)]

use std::fmt::Write;

use super::places::{Lay, followed, zero};
use super::solve::{Change, Task, UNKNOWNS};
use super::*;
use crate::artifact::program::Grammar;
use crate::error::{ErrorKind, Infeasible};
use crate::geometry::{Point, Rigid, Vector};
use crate::machine::Machine;
use crate::observe::Silent;
use crate::read::model::{self, ModelOptions};

const APT: Language =
    Language { grammar: Grammar::Apt, programmed: Programmed::Tip, shortest_way: false, feed_counts_degrees: false };
const ISO: Language = Language {
    grammar: Grammar::Gcode,
    programmed: Programmed::Machine,
    shortest_way: false,
    feed_counts_degrees: false,
};

fn blade(file: &str) -> Blade {
    let path = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("models").join(file);
    model::load(&path, &ModelOptions::default(), &Silent).unwrap()
}

fn tool(radius_mm: f64) -> Tool {
    Tool {
        radius_mm,
        corner_radius_mm: None,
        taper_deg: 3.0,
        shank_radius_mm: 2.0 * radius_mm,
        stickout_mm: 60.0,
        holder: vec![],
    }
}

/// A ball centre at the part, and the tool axis.
type Contact = (Point, Vector);

/// Balls that touch the part once round it for each turn, from one height to another; the axis
/// leans off the normal.
fn helix(blade: &Blade, radius_mm: f64, heights_mm: [f64; 2], turns: usize, per_turn: usize) -> Vec<Contact> {
    let count = turns * per_turn;
    let at = |k: usize| {
        let share = k as f64 / count as f64;
        let (sin, cos) = (std::f64::consts::TAU * k as f64 / per_turn as f64).sin_cos();
        let x = heights_mm[0] + (heights_mm[1] - heights_mm[0]) * share;
        let mut q = Point::new(x, 60.0 * cos, 60.0 * sin);
        let mut normal = Vector::x();
        // Inwards along a ray until the ball touches, then onto the offset along the normal.
        for step in 0..400 {
            let near = blade.part.closest(&q, f64::INFINITY).unwrap();
            normal = (q - near.point).normalize();
            let off = near.distance_mm - radius_mm;
            q -= if step < 380 { Vector::new(0.0, cos, sin) } else { normal } * off;
        }
        let across = Vector::x().cross(&normal);
        (q, (normal + Vector::x() * 0.35 + across * 0.2).normalize())
    };
    (0..=count).map(at).collect()
}

/// A motion like no other: turned anyhow, and far off.
fn motion(k: usize) -> Rigid {
    let turn = search::turns(97).nth(k % 97).unwrap();
    let s = k as f64;
    Rigid::from_parts(Vector::new(211.0 * s.sin(), 173.0 * (2.0 * s).cos(), -95.0 + 31.0 * s).into(), turn)
}

/// An APT file with three decimals: approach, contacts, retract. `lift`: from ball centres to what
/// is programmed, along the tool axis.
fn apt(contacts: &[Contact], moved: &Rigid, lift: f64, scale: f64) -> String {
    apt_to(contacts, moved, lift, scale, 3)
}

/// With so many decimals.
fn apt_to(contacts: &[Contact], moved: &Rigid, lift: f64, scale: f64, n: usize) -> String {
    let mut text = String::from("PARTNO/X\nMULTAX/ON\nRAPID\n");
    let mut goto = |(c, a): Contact, off: f64| {
        let (p, a) = (moved * (c + a * (lift + off)) * scale, moved * a);
        writeln!(text, "GOTO/{:.n$},{:.n$},{:.n$},{:.8},{:.8},{:.8}", p.x, p.y, p.z, a.x, a.y, a.z).unwrap();
        if off == 40.0 {
            text += "FEDRAT/500,MMPM\n";
        }
    };
    let (first, last) = (contacts[0], contacts[contacts.len() - 1]);
    goto(first, 40.0);
    goto(first, 3.0);
    contacts.iter().for_each(|c| goto(*c, 0.0));
    goto(last, 25.0);
    text + "FINI\n"
}

fn fitted(text: &str, language: Language, blade: &Blade, radius_mm: f64, options: &FitOptions) -> Result<Fit> {
    let (tool, machine) = (tool(radius_mm), Machine::demo().unwrap());
    let bench = Bench { language, zero: Zero::default(), tool: &tool, machine: &machine };
    fit(text, &[bench], blade, options, &Silent)
}

/// A frame takes what was moved back: so far at most, mm, and 0.001°.
fn is_back_within(fit: &Fit, moved: &Rigid, contacts: &[Contact], mm: f64) {
    let whole = fit.zero.blade_from_program * moved;
    let off = contacts.iter().map(|c| (whole * c.0 - c.0).norm()).fold(0.0, f64::max);
    assert!(off < mm, "{off} mm off: {fit:?}");
    assert!(whole.rotation.angle().to_degrees() < 0.001, "{fit:?}");
}

/// A frame takes what was moved back: 2 µm and 0.001° at most.
fn is_back(fit: &Fit, moved: &Rigid, contacts: &[Contact]) {
    is_back_within(fit, moved, contacts, 0.002);
    let whole = fit.zero.blade_from_program * moved;
    let off = contacts.iter().map(|c| (whole * c.0 - c.0).norm()).fold(0.0, f64::max);
    assert!(fit.touching_share > 0.99 && fit.rms_um < 1.0, "{fit:?}");
    assert!(fit.uncertainty_um < 2.0 && fit.uncertainty_deg < 0.003, "{fit:?}");
    // Turns move no contact farther than the part's size.
    assert!(1000.0 * off <= 2.0 * fit.bound_um, "{off} mm off: {fit:?}");
}

/// Two thirds of the feed ends only part a chord between locations, and are all in the part: they
/// do not move the frame.
#[test]
fn ends_that_part_a_chord_do_not_move_the_frame() {
    let blade = blade("turbine_camber.step");
    let contacts = helix(&blade, 2.0, [24.0, 11.0], 5, 240);
    let parted = |w: &[Contact]| {
        let at =
            |share: f64| (w[0].0 + (w[1].0 - w[0].0) * share, (w[0].1 * (1.0 - share) + w[1].1 * share).normalize());
        [at(0.0), at(1.0 / 3.0), at(2.0 / 3.0)]
    };
    let lines: Vec<Contact> = contacts.windows(2).flat_map(parted).collect();
    let moved = motion(17);
    let text = apt_to(&lines, &moved, 0.0, 1.0, 5);
    let centres = Language { programmed: Programmed::Centre, ..APT };
    let fit = fitted(&text, centres, &blade, 2.0, &FitOptions::default()).unwrap();
    is_back_within(&fit, &moved, &contacts, 0.0003);
    // The chords are in the residuals, and in what is promised.
    assert!(fit.rms_um > 1.0 && fit.bound_um > 10.0, "{fit:?}");
}

/// The airfoil of the camber model, above its fillet.
fn airfoil() -> (Blade, Vec<Contact>) {
    let blade = blade("turbine_camber.step");
    let contacts = helix(&blade, 2.0, [24.0, 11.0], 6, 90);
    (blade, contacts)
}

#[test]
fn frames_are_found_whatever_the_motion() {
    let (blade, contacts) = airfoil();
    for k in [3, 40, 71] {
        let moved = motion(k);
        let fit = fitted(&apt(&contacts, &moved, -2.0, 1.0), APT, &blade, 2.0, &FitOptions::default()).unwrap();
        is_back(&fit, &moved, &contacts);
        assert_eq!((fit.programmed, fit.either, fit.radius_mm), (Programmed::Tip, false, 2.0));
        assert!(fit.runner_up_ratio.is_none_or(|r| r > 5.0), "{fit:?}");
    }
}

#[test]
fn whether_points_are_tips_or_centres_is_found() {
    let (blade, contacts) = airfoil();
    let moved = motion(12);
    let either = FitOptions { either: true, ..FitOptions::default() };
    for (lift, programmed) in [(0.0, Programmed::Centre), (-2.0, Programmed::Tip)] {
        let fit = fitted(&apt(&contacts, &moved, lift, 1.0), APT, &blade, 2.0, &either).unwrap();
        is_back(&fit, &moved, &contacts);
        assert_eq!((fit.programmed, fit.either), (programmed, true));
    }
    // As tips, which the language says, ball centres fit nowhere.
    let e = fitted(&apt(&contacts, &moved, 0.0, 1.0), APT, &blade, 2.0, &FitOptions::default()).unwrap_err();
    assert_eq!(e.kind, ErrorKind::Infeasible);
}

#[test]
fn stock_and_another_ball_are_accounted_for() {
    let (blade, contacts) = airfoil();
    let (moved, text) = (motion(5), apt(&contacts, &motion(5), 0.0, 1.0));
    let centres = Language { programmed: Programmed::Centre, ..APT };
    let stock = FitOptions { stock_mm: 0.5, ..FitOptions::default() };
    let fit = fitted(&text, centres, &blade, 1.5, &stock).unwrap();
    is_back(&fit, &moved, &contacts);
    // Without the stock the ball is the wrong one, and the right one is named.
    let e = fitted(&text, centres, &blade, 1.5, &FitOptions::default()).unwrap_err();
    let Some(Infeasible::NoFrame { radius_mm: Some(radius_mm), scale: None, .. }) = e.infeasible.as_deref() else {
        panic!("{e}: {:?}", e.infeasible)
    };
    assert!((radius_mm - 2.0).abs() < 0.001, "{radius_mm}");
    assert!(e.to_string().contains("a ball of radius 2.000"), "{e}");
    // A thinner blade and a greater ball are nearly the same as another place along the blade.
    let free = FitOptions { free_radius: true, ..FitOptions::default() };
    let e = fitted(&text, centres, &blade, 1.5, &free).unwrap_err();
    let Some(Infeasible::FrameNotDetermined { directions, .. }) = e.infeasible.as_deref() else { panic!("{e}") };
    assert_eq!(directions, &["along x of the blade"]);
    let free = FitOptions { condition: 1e5, ..free };
    let fit = fitted(&text, centres, &blade, 1.5, &free).unwrap();
    assert!((fit.radius_mm - 2.0).abs() < 0.001, "{fit:?}");
}

#[test]
fn inches_are_told() {
    let (blade, contacts) = airfoil();
    let text = apt(&contacts, &motion(8), -2.0, 1.0);
    // The same digits, a unit that is 25.4 times as long: four decimals more keep them.
    let inch = |line: &str| match line.strip_prefix("GOTO/") {
        Some(words) => {
            let mut v: Vec<f64> = words.split(',').map(|w| w.parse().unwrap()).collect();
            v[..3].iter_mut().for_each(|x| *x /= 25.4);
            format!("GOTO/{}\n", v.iter().map(|x| format!("{x:.8}")).collect::<Vec<_>>().join(","))
        }
        None => format!("{line}\n"),
    };
    let text: String = text.lines().map(inch).collect();
    let e = fitted(&text, APT, &blade, 2.0, &FitOptions::default()).unwrap_err();
    assert!(matches!(e.infeasible.as_deref(), Some(Infeasible::NoFrame { scale: Some(25.4), .. })), "{e}");
    assert!(e.to_string().contains("they look like inches"), "{e}");
}

#[test]
fn another_part_is_refused() {
    let (_, contacts) = airfoil();
    let other = blade("prism.step");
    let e = fitted(&apt(&contacts, &motion(2), -2.0, 1.0), APT, &other, 2.0, &FitOptions::default()).unwrap_err();
    let Some(Infeasible::NoFrame { touching_share, scale: None, radius_mm: None, .. }) = e.infeasible.as_deref() else {
        panic!("{e}: {:?}", e.infeasible)
    };
    assert!(*touching_share < 0.95 && e.kind == ErrorKind::Infeasible, "{e}");
}

/// On walls that are drawn along x nothing says how high a program is; where it reaches into the
/// fillet, half a turn remains.
#[test]
fn what_is_not_determined_is_named() {
    let blade = blade("prism.step");
    let walls = helix(&blade, 4.0, [30.0, 22.0], 4, 80);
    let e = fitted(&apt(&walls, &motion(31), -4.0, 1.0), APT, &blade, 4.0, &FitOptions::default()).unwrap_err();
    let Some(Infeasible::FrameNotDetermined { directions, .. }) = e.infeasible.as_deref() else {
        panic!("{e}: {:?}", e.infeasible)
    };
    assert_eq!(directions, &["along x of the blade"], "{e}");
    let fillet = helix(&blade, 4.0, [9.0, 4.4], 5, 80);
    let e = fitted(&apt(&fillet, &motion(31), -4.0, 1.0), APT, &blade, 4.0, &FitOptions::default()).unwrap_err();
    let Some(Infeasible::FrameAmbiguous { turned_deg, .. }) = e.infeasible.as_deref() else {
        panic!("{e}: {:?}", e.infeasible)
    };
    assert!((turned_deg - 180.0).abs() < 0.01 && e.to_string().contains("about x of the blade"), "{e}");
}

/// Half a turn about x would do for the balls on the prism, but the shaft then is in the part.
#[test]
fn the_shaft_tells_sides() {
    let blade = blade("prism.step");
    // Over the tip's face all round, and half way down one side only.
    let contacts = helix(&blade, 4.0, [30.0, 22.0], 1, 40);
    let lay = Lay { frame: Rigid::identity(), tip: false, grown_mm: 0.0 };
    let text = apt(&contacts, &Rigid::identity(), 0.0, 1.0);
    let (tool, machine) = (tool(4.0), Machine::demo().unwrap());
    let language = Language { programmed: Programmed::Centre, ..APT };
    let bench = Bench { language, zero: Zero::default(), tool: &tool, machine: &machine };
    let places = FeedEnds::of(&program::read(&text, language).unwrap(), &[bench]).unwrap();
    let search = Search {
        part: &blade.part,
        places: &places,
        stock_mm: 0.0,
        words: vec![false],
        free_radius: false,
        observer: &Silent,
    };
    assert_eq!(judge::passing_share(&search, &[&tool], &places.all, &lay), 0.0);
    // The centres of one side where those of the other were: axes point into the part.
    let text = apt(&contacts.iter().map(|(c, a)| (*c, -a)).collect::<Vec<_>>(), &Rigid::identity(), 0.0, 1.0);
    let places = FeedEnds::of(&program::read(&text, language).unwrap(), &[bench]).unwrap();
    let search = Search { places: &places, ..search };
    assert!(judge::passing_share(&search, &[&tool], &places.all, &lay) > 0.9);
}

#[test]
fn work_offsets_are_found() {
    let (blade, contacts) = airfoil();
    let (tool, machine) = (tool(2.0), Machine::demo().unwrap());
    let offset = Vector::new(412.3, -77.125, 58.004);
    let program = |swing_rad: f64| {
        let mut text = String::from("G90 G94 S6000 M3\nG0 A0 B20 F500\n");
        for (k, (centre, axis)) in contacts.iter().enumerate() {
            let theta = axis.z.atan2(axis.y) + swing_rad * (k as f64 * 0.07).sin();
            let at = machine.inverse(centre, theta, 20f64.to_radians(), tool.length_mm());
            let [x, y, z] = machine.linear().map(|i| at[i]);
            let a = at[machine.turning_axis()].to_degrees();
            let g = if k == 0 { "G0" } else { "G1" };
            let [x, y, z] = [x - offset.x, y - offset.y, z - offset.z];
            writeln!(text, "{g} X{x:.3} Y{y:.3} Z{z:.3} A{a:.4}").unwrap();
        }
        text + "M30\n"
    };
    // With a lead that does not change the table keeps the wall turned the same way to the tool.
    let e = fitted(&program(0.0), ISO, &blade, 2.0, &FitOptions::default()).unwrap_err();
    let Some(Infeasible::FrameNotDetermined { directions, .. }) = e.infeasible.as_deref() else { panic!("{e}") };
    assert_eq!(directions.len(), 1, "{e}");
    let fit = fitted(&program(0.4), ISO, &blade, 2.0, &FitOptions::default()).unwrap();
    let off = (Vector::from(fit.zero.axes_mm) - offset).norm();
    assert!(off < 0.002, "{off}: {fit:?}");
    assert_eq!(fit.programmed, Programmed::Machine);
    assert_eq!(fit.zero.blade_from_program, Rigid::identity());
}

/// What places say of the ball centre in any frame is what following the program with it says.
#[test]
fn places_are_where_the_machine_goes() {
    let tip =
        |grammar| Language { grammar, programmed: Programmed::Tip, shortest_way: false, feed_counts_degrees: false };
    let vectors = "T1 M6 S6000 M3\nG0 A20\nG43.5 H1\nG0 X50 Y1 Z2 I0 J0.2 K1\nG94 G1 F500 X10 Y20 Z3 I0.1 J0.3 K1\n";
    let turned = "T1 M6 S6000 M3\nG0 A35 B10\nG43.4 H1 X50 Y1 Z2\nG94 G1 F500 X10 Y20 Z3 A60\nX12 Y-9 A90 B20\n";
    let lines = "RAPID\nGOTO/1,2,3,0,0,1\nFEDRAT/500,MMPM\nGOTO/4,5,6,0,0.6,0.8\nGOTO/9,5,6,0.6,0.0,0.8\n";
    let axes = "G90 G94 G0 A0 B0\nG43 H1 X1 Y2 Z3\nG68 X3 Y4 R30\nG1 X4 Y5 Z6 A30 F500\nG69 G1 X9 Y-5 B12\n";
    for (text, language) in [
        (vectors, tip(Grammar::Gcode)),
        (turned, tip(Grammar::Gcode)),
        (lines, tip(Grammar::Apt)),
        (axes, ISO),
        ("TRAORI\nG0 X1 Y2 Z3 A10 B5\nG94 G1 X4 Y5 Z6 A30 F500\nTRANS X3\nX9 Y-5 B12\n", tip(Grammar::Gcode)),
    ] {
        let (tool, machine) = (tool(2.0), Machine::demo().unwrap());
        let bench = Bench { language, zero: Zero::default(), tool: &tool, machine: &machine };
        let script = program::read(text, language).unwrap();
        // A dozen lines at least: the last ones again.
        let mut blocks = script.blocks.clone();
        for k in 0..12 {
            let mut again = blocks[script.blocks.len() - 1 - (k + 1) % 2];
            again.feed = program::Feed::PerMinute(500.0);
            blocks.push(again);
        }
        let script = Script { blocks, ..script };
        let places = FeedEnds::of(&script, &[bench]).unwrap();
        for k in [4, 9, 30] {
            let mut frame = motion(k);
            if places.in_axes {
                frame.rotation = nalgebra::UnitQuaternion::identity();
            }
            let Ok(there) = followed(&script, &[bench], zero(&frame, places.in_axes)) else { continue };
            assert_eq!(there.len(), places.all.len());
            for (place, f) in places.all.iter().zip(&there) {
                let pose = f.moved.pose(f.share, &tool, &machine);
                let lay = Lay { frame, tip: true, grown_mm: 0.0 };
                assert!((place.centre(&lay) - pose.centre).norm() < 1e-9, "{text}: {k}");
                assert!((place.axis(&lay) - pose.axis).norm() < 1e-9, "{text}: {k}");
            }
        }
    }
}

/// Slopes of residuals against differences.
#[test]
fn slopes_are_those_of_the_distance() {
    let blade = blade("prism.step");
    let contacts = helix(&blade, 4.0, [30.0, 9.0], 2, 12);
    let (tool, machine) = (tool(4.0), Machine::demo().unwrap());
    let bench = Bench { language: APT, zero: Zero::default(), tool: &tool, machine: &machine };
    let script = program::read(&apt(&contacts, &motion(3), -4.0, 1.0), APT).unwrap();
    let places = FeedEnds::of(&script, &[bench]).unwrap();
    let field = field::Exact(&blade.part);
    let task = Task {
        field: &field,
        places: &places.all,
        stock_mm: 0.1,
        free: [true; UNKNOWNS],
        size_mm: 50.0,
        huber_mm: 1.0,
        most_mm: f64::INFINITY,
    };
    let lay = Lay { frame: motion(3).inverse(), tip: true, grown_mm: 0.2 };
    let here = task.residuals(&lay);
    for k in 0..UNKNOWNS {
        let h = 1e-4;
        let change = Change::from_fn(|i, _| if i == k { h } else { 0.0 });
        let [up, down] = [change, -change].map(|c| task.residuals(&task.changed(&lay, &c)));
        for ((r, up), down) in here.iter().zip(up).zip(down) {
            let slope = (up.unwrap().off_mm - down.unwrap().off_mm) / (2.0 * h);
            assert!((slope - r.unwrap().slope[k]).abs() < 1e-5, "{k}: {slope} {}", r.unwrap().slope[k]);
        }
    }
}

#[test]
fn turns_and_sums() {
    let all: Vec<_> = search::quarters().collect();
    assert_eq!(all.len(), 24);
    let apart = |i: usize, j: usize| all[i].angle_to(&all[j]);
    assert!((0..24).all(|i| (0..i).all(|j| apart(i, j) > 1.5)));
    // Every turn is near to one of those that are spread.
    let spread: Vec<_> = search::turns(720).collect();
    for other in search::turns(501) {
        let near = spread.iter().map(|t| t.angle_to(&other)).fold(f64::MAX, f64::min);
        assert!(near.to_degrees() < 35.0, "{near}");
    }
    // Approach and retract are outside the first and the last contact; the rest counts.
    let touch = judge::summed(&[9.0, 0.0, 0.003, 0.5, 0.004, 7.0, f64::INFINITY], 0.02);
    assert_eq!((touch.places, touch.share), (4, 0.75));
    assert!((touch.rms_um - (25.0f64 / 3.0).sqrt()).abs() < 1e-9 && touch.p95_um == 500.0, "{touch:?}");
    assert_eq!(judge::summed(&[1.0, 2.0], 0.02).share, 0.0);
    // One contact of ten places is no stretch.
    let one = [9.0, 9.0, 9.0, 0.0, 9.0, 9.0, 9.0, 9.0, 9.0, 9.0];
    assert_eq!(judge::summed(&one, 0.02).share, 0.2);
}

#[test]
fn what_is_no_program_is_said() {
    let blade = blade("prism.step");
    for (text, names) in [("RAPID\nGOTO/1,2,3\nFEDRAT/5,MMPM\nGOTO/2,3,4\n", "1 feed moves"), ("GOTO/1,2\n", "line 1")]
    {
        let e = fitted(text, APT, &blade, 4.0, &FitOptions::default()).unwrap_err();
        assert!(e.kind == ErrorKind::Usage && e.message.contains(names), "{e}");
    }
    let e = fit("", &[], &blade, &FitOptions::default(), &Silent).unwrap_err();
    assert!(e.message.contains("needs a tool"), "{e}");
}
