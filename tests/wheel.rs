//! A blade among the others of its wheel: five axes find the way, programs carry it, and what
//! cannot be is refused with its place.

use bladewright::artifact::check_id::CheckId;
use bladewright::artifact::program::Control;
use bladewright::artifact::{Cones, Sweep};
use bladewright::error::{Error, ErrorKind, Infeasible, Result};
use bladewright::machine::Machine;
use bladewright::observe::Silent;
use bladewright::plan::{self, Setup};
use bladewright::verify::Verdict;
use bladewright::write::post::Dialect;

use super::of_prism;

/// A coarse helix round a prism whose neighbours stand some ball radii away.
const JOB: &str = "
[model]
file = 'prism.step'

[wheel]
blades = 30
axis = [1, 0, 0]
origin_mm = [0, 0, -300]

[orientation]
kind = 'five-axis'

[path]
scallop_mm = 0.2

[region]
start_mm = 40
end_mm = 32

[tool]
radius_mm = 3
taper_deg = 3
shank_radius_mm = 5
stickout_mm = 70
holder = [{ radius_mm = 15, length_mm = 40 }]
";

fn setup(changes: &[&str], machine: Machine) -> Result<Setup> {
    of_prism::setup(JOB, changes, machine)
}

/// [`JOB`] without its section wheel.
fn without_wheel() -> String {
    let ((before, _), (_, after)) = JOB.split_once("[wheel]").zip(JOB.split_once("[orientation]")).expect("sections");
    format!("{before}[orientation]{after}")
}

fn refused(changes: &[&str]) -> Error {
    match setup(changes, Machine::demo().expect("the demo machine")) {
        Err(e) => e,
        Ok(_) => panic!("{changes:?} was not refused"),
    }
}

/// A machine of the repository with room and travel for a wheel of 760 mm.
fn machine(name: &str) -> Machine {
    let wider = |text: String| text.replace("swing_diameter_mm = ", "swing_diameter_mm = 1").replace("330.0", "500.0");
    of_prism::machine(name, wider)
}

/// Planned, checked, written for two controls and read back, on a table with a head and on two
/// tables.
#[test]
fn a_blade_of_a_wheel_is_planned_and_posted() {
    for name in ["demo_table_head.toml", "trunnion_ac.toml"] {
        let setup = setup(&["machine.b_deg=0"], machine(name)).expect("a setup");
        assert_eq!(setup.obstacles.len(), 1);
        let verdict = plan::plan(&setup, &Silent).unwrap_or_else(|e| panic!("{name}: {e}"));
        let Verdict::Passed(verified) = verdict else { panic!("{name}: the plan fails its checks") };
        let made = verified.value();
        assert_eq!(made.channel.sweep, Sweep::Swing);
        assert!(matches!(made.toolpath.cones, Cones::Each(_)), "{name}");
        for control in [Control::Siemens, Control::Linuxcnc] {
            let (program, checks) =
                setup.program(&Dialect::built_in(control).expect("a dialect"), &verified).expect("a program");
            assert!(program.text.lines().count() > 100);
            let failed: Vec<_> = checks.iter().filter(|c| !c.passed).collect();
            assert!(failed.is_empty(), "{name} {control}: {failed:?}");
        }
    }
}

/// The plan of a wheel with few blades runs into the neighbours of one with many, and fails.
#[test]
fn a_plan_that_knows_no_neighbours_fails_among_them() {
    let wheel =
        |blades: &str| setup(&[blades, "schedule.kind=\"optimal\""], machine("demo_table_head.toml")).expect("a setup");
    let (few, among) = (wheel("wheel.blades=4"), wheel("wheel.blades=30"));
    let Ok(Verdict::Passed(free)) = plan::plan(&few, &Silent) else { panic!("with few blades there is a plan") };
    let Ok(Verdict::Failed(rejected)) = among.verdict(free.value().clone(), &Silent) else {
        panic!("among the others it passes")
    };
    let failed: Vec<CheckId> = rejected.report().checks.iter().filter(|c| !c.passed).map(|c| c.id.clone()).collect();
    assert!(failed.iter().any(|id| [CheckId::ObstacleClearance, CheckId::ObstacleGouge].contains(id)), "{failed:?}");
}

#[test]
fn what_cannot_be_is_refused_with_its_place() {
    let overlap = refused(&["wheel.blades=200"]);
    assert_eq!(overlap.kind, ErrorKind::Infeasible);
    assert!(overlap.message.contains("neighbouring blades overlap: at ("), "{overlap}");
    let since = overlap.infeasible.as_deref();
    assert!(matches!(since, Some(Infeasible::BladesOverlap { blades: 200, .. })), "{since:?}");
    let along = refused(&["wheel.axis=[0, 0, 1]"]);
    assert!(along.message.contains("wheel.axis is 0.0° from the blade axis"), "{along}");
    for (change, says) in [
        ("wheel.axis=[0, 0, 0]", "wheel.axis is missing or no direction"),
        ("wheel.blades=1", "wheel.blades is 1"),
        ("wheel.hub_mm=[[0, 40]]", "two places or more"),
        ("wheel.hub_mm=[[0, 40], [1, -3]]", "a radius of at least 0"),
        ("feed.smooth=true", "feed.smooth is for one cone"),
        ("channel.sweep_b=true", "channel.sweep_b is for one cone"),
        ("orientation.grid_deg=0.1", "orientation.grid_deg"),
    ] {
        let e = refused(&[change]);
        assert!(e.kind == ErrorKind::Usage && e.message.contains(says), "{change}: {e}");
    }
    let e = of_prism::setup(&without_wheel(), &[], machine("demo_table_head.toml")).err().expect("no wheel");
    assert!(e.message.contains("the job has no section wheel"), "{e}");
}

/// The prism so many times about the rotor axis of [`JOB`], as one model.
fn whole_wheel(blades: u32) -> String {
    use std::fmt::Write;
    let one = include_str!("../models/prism.obj");
    let vertices: Vec<[f64; 3]> = one
        .lines()
        .filter_map(|l| l.strip_prefix("v "))
        .map(|l| {
            let mut numbers = l.split(' ').map(|n| n.parse().expect("a number"));
            std::array::from_fn(|_| numbers.next().expect("three numbers"))
        })
        .collect();
    let mut text = String::new();
    for k in 0..blades {
        let (s, c) = (std::f64::consts::TAU * f64::from(k) / f64::from(blades)).sin_cos();
        for [x, y, z] in &vertices {
            let (y, z) = (*y, z + 300.0);
            writeln!(text, "v {x} {} {}", c * y - s * z, s * y + c * z - 300.0).expect("text");
        }
        for line in one.lines().filter_map(|l| l.strip_prefix("f ")) {
            let first = k as usize * vertices.len();
            let face: Vec<String> =
                line.split(' ').map(|n| (first + n.parse::<usize>().expect("a number")).to_string()).collect();
            writeln!(text, "f {}", face.join(" ")).expect("text");
        }
    }
    text
}

/// A model of the whole wheel needs no section; its path is that of the blade by itself.
#[test]
fn a_model_of_a_whole_wheel_is_planned_as_it_is() {
    let machine = || machine("demo_table_head.toml");
    let twelve = whole_wheel(12);
    let whole =
        of_prism::setup_of(("wheel.obj", twelve.as_bytes()), &without_wheel(), &[], machine()).expect("a setup");
    let alone =
        of_prism::setup_of(("prism.obj", include_bytes!("../models/prism.obj")), JOB, &["wheel.blades=12"], machine())
            .expect("a setup");
    let wheel = whole.wheel.expect("a wheel");
    assert!(wheel.blades == 12 && whole.obstacles.is_empty() && alone.obstacles.len() == 1);
    assert!((wheel.origin - alone.wheel.expect("a wheel").origin).norm() < 0.01, "{wheel:?}");
    let [ours, theirs] = [&whole, &alone].map(|s| {
        let to_model = s.blade.model_from_blade;
        let path = s.path(&Silent).expect("a path");
        path.locations.iter().map(|l| to_model * l.centre).collect::<Vec<_>>()
    });
    assert_eq!(ours.len(), theirs.len());
    let apart = ours.iter().zip(&theirs).map(|(a, b)| (a - b).norm()).fold(0.0, f64::max);
    assert!(apart < 1e-3, "{apart} mm apart");

    let other = of_prism::setup_of(("wheel.obj", twelve.as_bytes()), JOB, &["wheel.blades=10"], machine());
    let other = other.map(|_| ()).expect_err("ten blades");
    assert!(other.message.contains("but the model repeats every 30.000°, 12 times in a turn"), "{other}");
    assert!(matches!(other.infeasible.as_deref(), Some(Infeasible::NotThatWheel { asked: 10, found: 12 })));
}
