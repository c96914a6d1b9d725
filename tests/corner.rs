//! Bull-nose cutters from a model to a program: what is planned passes all checks, is as much
//! shorter as its strips are wider, and what is wrong with it is found.

use std::path::Path;

use bladewright::artifact::check_id::CheckId;
use bladewright::artifact::program::Control;
use bladewright::artifact::report::CheckReport;
use bladewright::error::ErrorKind;
use bladewright::job::JobFile;
use bladewright::observe::Silent;
use bladewright::plan::{self, Setup};
use bladewright::run::inputs::{self, Loaded};
use bladewright::verify::Verdict;
use bladewright::write::post::Dialect;

const PRISM: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/models/prism.step");
const CAMBER: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/models/turbine_camber.step");
const REGION: [&str; 6] = [
    "path.scallop_mm=0.05",
    "region.start_mm=27",
    "region.end_mm=19",
    "machine.b_deg=0",
    "schedule.kind=\"optimal\"",
    "verify.surface_samples=10000",
];
const BULL: [&str; 2] = ["tool.radius_mm=8", "tool.corner_radius_mm=2"];

fn setup(model: &str, keys: &[&str]) -> Setup {
    let mut job = JobFile::from_model(Path::new(model));
    keys.iter().for_each(|key| job.set(key).expect("a key"));
    let draft = inputs::draft(job, Path::new("")).expect("a draft");
    Loaded::read(&draft, &Silent).expect("a model").setup
}

fn prism(more: &[&str]) -> Setup {
    setup(PRISM, &[&REGION, more].concat())
}

fn failed(report: &CheckReport) -> Vec<CheckId> {
    report.checks.iter().filter(|c| !c.passed).map(|c| c.id.clone()).collect()
}

#[test]
fn a_bull_nose_is_planned_checked_and_posted() {
    let setup = prism(&BULL);
    let Verdict::Passed(plan) = plan::plan(&setup, &Silent).expect("a plan") else { panic!("it passes") };
    let report = plan.report();
    assert!(report.gouge_mm < 0.003 && report.scallop_samples > 500, "{} {}", report.gouge_mm, report.scallop_samples);
    // Somewhere it leans as much as passes are laid for, and nowhere more.
    assert!(report.scallop_p99_mm < 1.03 * 0.05 && report.scallop_p99_mm > 0.5 * 0.05, "{}", report.scallop_p99_mm);
    assert!(report.scallop_max_mm < 1.03 * 0.05, "{}", report.scallop_max_mm);
    let path = &plan.value().toolpath;
    assert!((path.planned_scallop_mm / 0.05 - 1.0).abs() < 0.02, "{}", path.planned_scallop_mm);
    for control in [Control::Siemens, Control::Iso, Control::Heidenhain, Control::Linuxcnc] {
        let dialect = Dialect::built_in(control).expect("a dialect");
        let (_, checks) = setup.program(&dialect, &plan).expect("a program");
        let bad: Vec<_> = checks.iter().filter(|c| !c.passed).collect();
        assert!(bad.is_empty() && !checks.is_empty(), "{control}: {bad:?}");
    }
    // A ball as large, on the same region with the same scallop.
    let ball = prism(&["tool.radius_mm=8", "tool.taper_deg=0"]);
    let Verdict::Passed(ball) = plan::plan(&ball, &Silent).expect("a plan") else { panic!("it passes") };
    let length = |p: &bladewright::artifact::Toolpath| p.locations.last().map_or(0.0, |l| l.s_mm);
    let ratio = length(path) / length(&ball.value().toolpath);
    assert!(ratio < 0.67, "{ratio}");
}

#[test]
fn what_is_wrong_with_a_plan_of_a_bull_nose_is_found() {
    let setup = prism(&BULL);
    let Verdict::Passed(good) = plan::plan(&setup, &Silent).expect("a plan") else { panic!("it passes") };
    let spoilt = |change: &dyn Fn(&mut bladewright::artifact::Plan)| {
        let mut plan = good.value().clone();
        change(&mut plan);
        match setup.verdict(plan, &Silent).expect("a verdict") {
            Verdict::Passed(_) => Vec::new(),
            Verdict::Failed(found) => failed(found.report()),
        }
    };
    assert!(spoilt(&|_| ()).is_empty());
    let middle = good.value().toolpath.locations.len() / 2;
    let deeper = spoilt(&|plan| {
        let l = &mut plan.toolpath.locations[middle];
        l.centre -= l.normal * 0.01;
    });
    assert!(deeper.contains(&CheckId::Gouge) && deeper.contains(&CheckId::PlanContacts), "{deeper:?}");
    // A disc that leans less by two degrees about its own centre.
    let turned = spoilt(&|plan| plan.schedule.theta[middle] -= 2f64.to_radians());
    assert!(turned.contains(&CheckId::PlanContacts) && turned.contains(&CheckId::AxesDirection), "{turned:?}");
    let wider = spoilt(&|plan| plan.channel.rows[middle].theta_max += 3f64.to_radians());
    assert!(wider.contains(&CheckId::PlanChannel), "{wider:?}");
    // Every second turn left out: what stays between the others is seen.
    let coarse = prism(&[&BULL[..], &["path.scallop_mm=0.2"]].concat());
    let Verdict::Passed(far) = plan::plan(&coarse, &Silent).expect("a plan") else { panic!("it passes") };
    let Verdict::Failed(found) = setup.verdict(far.value().clone(), &Silent).expect("a verdict") else {
        panic!("ridges of 0.2 mm pass for 0.05")
    };
    assert!(failed(found.report()).contains(&CheckId::Scallop), "{:?}", failed(found.report()));
    // Another cutter in the spindle.
    let mut other = prism(&["tool.radius_mm=9", "tool.corner_radius_mm=2"]);
    other.job.tool.stickout_mm = setup.job.tool.stickout_mm;
    let Verdict::Failed(found) = other.verdict(good.value().clone(), &Silent).expect("a verdict") else {
        panic!("a wider cutter passes")
    };
    assert!(failed(found.report()).contains(&CheckId::PlanContacts), "{:?}", failed(found.report()));
}

#[test]
fn a_hollow_side_is_refused_with_the_inclination_that_would_do() {
    let keys = ["path.scallop_mm=0.05", "tool.radius_mm=6", "tool.corner_radius_mm=1", "machine.b_deg=0"];
    let range = ["channel.contact_angle_min_deg=1", "channel.contact_angle_max_deg=5"];
    let region = ["region.start_mm=30", "region.end_mm=24"];
    let setup = setup(CAMBER, &[&keys[..], &range, &region].concat());
    let e = plan::plan(&setup, &Silent).expect_err("no plan");
    assert!(e.kind == ErrorKind::Infeasible && e.message.contains("no angle of the tool axis is free"), "{e}");
    assert!(e.message.contains("it would be clear there"), "{e}");
}

#[test]
fn what_is_for_balls_only_is_refused_before_anything_is_planned() {
    for (key, what) in [
        ("feed.smooth=true", "feed.smooth"),
        ("schedule.kind=\"lower-wall\"", "channel.prove_moves"),
        ("channel.exact_ends=true", "channel.exact_ends"),
        ("path.compare=true", "path.compare"),
        ("channel.contact_angle_max_deg=100", "at most 90°"),
    ] {
        let mut job = JobFile::from_model(Path::new(PRISM));
        REGION.iter().chain(&BULL).chain([&key]).for_each(|key| job.set(key).expect("a key"));
        let draft = inputs::draft(job, Path::new("")).expect("a draft");
        let e = Loaded::read(&draft, &Silent).err().expect("it is refused");
        assert!(e.kind == ErrorKind::Usage && e.message.contains(what), "{key}: {e}");
    }
}

/// Head and wall lean apart, so the cutter leans aside too. Round the edges what it leaves depends
/// on the bend of its way. The path goes up, as the mirror image of one that goes down.
#[test]
fn a_cutter_that_leans_aside_leaves_no_more_than_is_asked_for() {
    let setup = prism(&[&BULL[..], &["machine.b_deg=4", "path.direction=\"conventional\""]].concat());
    let Verdict::Passed(plan) = plan::plan(&setup, &Silent).expect("a plan") else { panic!("it passes") };
    let report = plan.report();
    assert!(report.scallop_p99_mm > 0.6 * 0.05, "{}", report.scallop_p99_mm);
    assert!(report.scallop_max_mm < 1.03 * 0.05, "{}", report.scallop_max_mm);
}
