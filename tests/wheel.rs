//! A blade among the others of its wheel: five axes find the way, programs carry it, and what
//! cannot be is refused with its place.

use bladewright::artifact::channel::Binding;
use bladewright::artifact::check_id::CheckId;
use bladewright::artifact::program::Control;
use bladewright::artifact::report::Check;
use bladewright::artifact::sphere::{CellState, SphereCell};
use bladewright::artifact::{Cone, Cones, Obstacle, PartAmong, Plan, Program, Sweep, Toolpath};
use bladewright::channel;
use bladewright::error::{Error, ErrorKind, Infeasible, Result};
use bladewright::geometry::mesh::Mesh;
use bladewright::geometry::part::Part;
use bladewright::geometry::{Point, Rigid, Vector};
use bladewright::machine::Machine;
use bladewright::observe::Silent;
use bladewright::plan::{self, Setup};
use bladewright::verify::{Verdict, Verified, read_back};
use bladewright::write::post::{self, Dialect, Operation};

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

[verify]
surface_samples = 20000
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

/// A program of some blades of the wheel, each against its own plan, with what reading it back
/// finds.
fn on_blades(setup: &Setup, plans: &[Verified<Plan>], control: Control) -> (Program, Vec<Check>) {
    let (part, tool) = (setup.part_among(), &setup.job.tool);
    let options = setup.post_options();
    let operations: Vec<_> = plans.iter().map(|plan| Operation { plan, tool, options: &options }).collect();
    let dialect = Dialect::built_in(control).expect("a dialect");
    let program = post::join(&dialect, &operations, 1, part, &setup.machine).expect("a program");
    let made: Vec<_> = plans.iter().map(|p| read_back::Operation { plan: p.value(), tool }).collect();
    let checks = read_back::read_back_each(&program, &made, part, &setup.machine).expect("checks");
    (program, checks)
}

/// The wheel's axis goes on from blade to blade, and each blade comes back as planned: in axis
/// positions, over the part, and as vectors. The program of one blade does not come back as the
/// plan of another.
#[test]
fn every_blade_of_a_wheel_comes_back_as_planned() {
    for name in ["demo_table_head.toml", "trunnion_ac.toml"] {
        let setup = setup(&["machine.b_deg=0", "region.end_mm=39"], machine(name)).expect("a setup");
        assert_eq!((setup.obstacles.len(), setup.blades_in_turn().expect("a wheel")), (1, 30));
        let Ok(Verdict::Passed(first)) = plan::plan(&setup, &Silent) else { panic!("{name}: no plan") };
        assert_eq!(first.value().channel.sweep, Sweep::Swing);
        assert!(matches!(first.value().toolpath.cones, Cones::Each(_)), "{name}");
        let on = |number: u32| match setup.on_blade(&first, number) {
            Ok(Verdict::Passed(plan)) => plan,
            other => panic!("{name}: blade {number}: {:?}", other.map(|v| v.report().checks.clone())),
        };
        let plans = [first.clone(), on(2), on(16), on(30)];
        for plan in &plans[1..] {
            assert_eq!(plan.report(), first.report());
            assert_eq!(plan.value().motion.t_s, first.value().motion.t_s);
        }
        for control in
            [Control::Linuxcnc, Control::Siemens, Control::SiemensVector, Control::Heidenhain, Control::Fanuc]
        {
            let (program, checks) = on_blades(&setup, &plans, control);
            let failed: Vec<_> = checks.iter().filter(|c| !c.passed).collect();
            assert!(failed.is_empty(), "{name} {control}: {failed:?}");
            assert!(program.text.lines().count() > 100);
            assert_eq!(program.text.matches("Operation 4 of 4").count(), 1);
            let (program, checks) =
                setup.program(&Dialect::built_in(control).expect("a dialect"), &first).expect("a program");
            let failed: Vec<_> = checks.iter().filter(|c| !c.passed).collect();
            assert!(failed.is_empty(), "{name} {control}: {failed:?}");
            let (part, tool) = (setup.part_among(), &setup.job.tool);
            let other = read_back::read_back(&program, plans[1].value(), part, tool, &setup.machine).expect("checks");
            let failed: Vec<_> = other.iter().filter(|c| !c.passed).map(|c| c.id.clone()).collect();
            assert!(failed.contains(&CheckId::ProgramMissing), "{name} {control}: {failed:?}");
        }
        let column = setup.machine.turning_axis();
        let turned =
            first.value().axes().zip(plans[1].value().axes()).map(|(a, b)| (b[column] - a[column]).to_degrees());
        assert!(turned.into_iter().all(|deg| (deg.abs() - 12.0).abs() < 1e-9));
    }
}

/// What the checks have of the other blades is the part turned by multiples of 360°/N, and pictures
/// are told so.
#[test]
fn the_other_blades_are_the_part_turned() {
    let setup = setup(&[], machine("demo_table_head.toml")).expect("a setup");
    let (others, part, wheel) = (&setup.obstacles[0], &setup.blade.part.mesh, setup.wheel.expect("a wheel"));
    assert_eq!(others.copies.len(), 29);
    let points = others.part.mesh.points.chunks(part.points.len());
    for ((k, turn), group) in (2..).zip(&others.copies).zip(points) {
        let off = |(q, p): (&Point, &Point)| (q - turn * p).norm().max((q - wheel.turn_to(k) * p).norm());
        assert!(group.iter().zip(&part.points).map(off).fold(0.0, f64::max) < 1e-9, "blade {k}");
    }
}

/// Maps of free tool axes among the other blades agree with the channel's closed arcs on a circle
/// through each cell, and hold the axis of the plan; what the machine does not reach is none.
#[test]
fn maps_of_free_axes_are_those_of_the_exact_check() {
    let changes = ["machine.b_deg=0", "region.end_mm=39"];
    let setup = setup(&changes, machine("demo_table_head.toml")).expect("a setup");
    let Ok(Verdict::Passed(plan)) = plan::plan(&setup, &Silent) else { panic!("no plan") };
    let plan = plan.value();
    let along = setup.free_axes(plan, &Silent).expect("maps");
    assert!((16..=32).contains(&along.maps.len()) && along.nearest.len() == plan.toolpath.locations.len());
    let (around, options) = (setup.surroundings().expect("bodies"), setup.channel_options());
    let (mut free, mut taken) = (0, 0);
    for (k, (row, sphere)) in along.maps.iter().enumerate() {
        assert!((sphere.shares().iter().sum::<f64>() - 1.0).abs() < 1e-9);
        let axis = plan.stand(*row).expect("a location").axis();
        let at = sphere.cell_at(&axis).expect("a cell").state;
        assert!(!matches!(at, CellState::Taken(_)), "the plan's axis at location {row} is taken");
        // Some cells of some maps: the circles take longer than the maps.
        let cells: Vec<_> = sphere.cells.iter().step_by(if k % 4 == 0 { 53 } else { usize::MAX }).collect();
        let middle = |c: &SphereCell| (c.corners[0] + c.corners[1] + c.corners[2]).normalize();
        // The circle square to a direction beside the axis, which stands at θ = 0.
        let cone = |c: &&SphereCell| Cone::new(middle(c).cross(&Vector::new(0.3, -0.5, 0.8)), middle(c), 0.0);
        let cones: Vec<Cone> = cells.iter().map(|c| cone(c).expect("a circle")).collect();
        let same = plan.toolpath.at(&vec![*row; cells.len()]);
        let circles = Toolpath { cones: Cones::Each(cones), ..same };
        let arcs = channel::intervals(&around, &setup.job.tool, &circles, &options, &Silent).expect("arcs");
        for (cell, arcs) in cells.iter().zip(arcs) {
            let turns = [-1.0, 0.0, 1.0].map(|k| k * std::f64::consts::TAU);
            let within =
                |by: f64| turns.iter().any(|t| arcs.iter().any(|f| (f.theta_min - by..=f.theta_max + by).contains(t)));
            match cell.state {
                CellState::Free => {
                    free += 1;
                    assert!(within(1e-3), "location {row}: free at {:?}", middle(cell));
                }
                CellState::Taken(k) => match &sphere.bindings[k as usize] {
                    Binding::Travel { .. } | Binding::AxisLimit => {
                        let near = &plan.motion.position[*row];
                        let reached = setup.machine.rotary_of_axis(&middle(cell), near);
                        let travel = |k: usize| setup.machine.axes()[k].limits.travel.unwrap_or([f64::MIN, f64::MAX]);
                        let out = |at: &[f64]| (0..5).any(|k| at[k] < travel(k)[0] || at[k] > travel(k)[1]);
                        let length_mm = setup.job.tool.length_mm();
                        let centre = &plan.toolpath.locations[*row].centre;
                        let at = reached.map(|at| setup.machine.linear_at(centre, &at, length_mm));
                        assert!(at.is_none_or(|at| out(&at)), "location {row}: {:?} is reached", middle(cell));
                    }
                    _ => {
                        taken += 1;
                        assert!(!within(-1e-3), "location {row}: taken at {:?}", middle(cell));
                    }
                },
                CellState::Open => {}
            }
        }
    }
    assert!(free > 100 && taken > 100, "{free} {taken}");
    let round = self::setup(&["orientation.kind=\"cone\""], machine("demo_table_head.toml")).expect("a setup");
    let mut one = plan.clone();
    one.toolpath.cones = Cones::about_blade(0.0);
    assert!(round.free_axes(&one, &Silent).expect("no maps").maps.is_empty());
}

/// The demo machine with room for the wheel and ends of travel of the axis that carries it.
fn with_travel_of_a([least, most]: [i32; 2]) -> Machine {
    of_prism::machine("demo_table_head.toml", |text| {
        let text = text.replace("swing_diameter_mm = ", "swing_diameter_mm = 1").replace("330.0", "500.0");
        let (before, after) = text.split_once("[axes.a]").expect("axis A");
        format!("{before}[axes.a]\nmin_deg = {least}\nmax_deg = {most}{after}")
    })
}

/// A cube about a point.
fn block(at: &Point, half_mm: f64) -> Mesh {
    let sign = |k: usize, bit: usize| if k >> bit & 1 == 1 { half_mm } else { -half_mm };
    boxed((0..8).map(|k| at + Vector::new(sign(k, 0), sign(k, 1), sign(k, 2))).collect())
}

/// The box with these corners, whose numbers say in binary on which side each is.
fn boxed(points: Vec<Point>) -> Mesh {
    let quads = [[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]];
    let triangles = quads.iter().flat_map(|[a, b, c, d]| [[*a, *b, *c], [*a, *c, *d]]).collect();
    Mesh { points, triangles, ..Mesh::default() }
}

/// The wheel turns within the travel of its axis; what stands about the part is in the way of
/// rapids too, and safe positions are beyond it.
#[test]
fn the_wheel_turns_within_travel_and_clear_of_bodies() {
    let changes = ["machine.b_deg=0", "region.end_mm=39"];
    let setup = |machine: Machine| setup(&changes, machine).expect("a setup");
    let [mut wide, narrow] = [[-400, 400], [-100, 100]].map(|travel_deg| setup(with_travel_of_a(travel_deg)));
    let setup = setup(machine("demo_table_head.toml"));
    let Ok(Verdict::Passed(plan)) = plan::plan(&setup, &Silent) else { panic!("no plan") };
    // An axis with ends of travel takes whole turns off; where none helps, the blade is named.
    let reaches = |setup: &Setup, number: u32| {
        let turned = setup.on_blade(&plan, number);
        turned.map(|v| v.value().axes().map(|q| q[setup.machine.turning_axis()].to_degrees().abs()).fold(0.0, f64::max))
    };
    assert!(reaches(&wide, 30).expect("blade 30") < 400.0);
    let e = reaches(&narrow, 16).expect_err("blade 16");
    assert!(e.kind == ErrorKind::Infeasible && e.message.starts_with("blade 16 of 30: axis A would run from"), "{e}");
    assert!(matches!(e.infeasible.as_deref(), Some(Infeasible::TurnBeyondTravel { .. })));

    let rapids = |program: &Program, part: PartAmong| {
        let (tool, machine) = (&setup.job.tool, &setup.machine);
        let checks = read_back::read_back(program, plan.value(), part, tool, machine).expect("checks");
        checks.into_iter().find(|c| c.id == CheckId::ProgramRapids).expect("rapids")
    };
    let dialect = Dialect::built_in(Control::Linuxcnc).expect("a dialect");
    let posted = |part: PartAmong| {
        post::post(&dialect, &plan, part, &setup.job.tool, &setup.machine, &setup.post_options()).expect("a program")
    };
    let (alone, among) = (PartAmong::from(&setup.blade), setup.part_among());
    assert!(rapids(&posted(alone), alone).passed && rapids(&posted(among), among).passed);
    // A block over the first location, which the tool comes down through.
    let over = plan.value().rows().next().expect("a row").stand.lifted(200.0).centre;
    let mesh = block(&over, 80.0);
    let (clearance_mm, holder_clearance_mm) = (0.1, 0.1);
    let clamp = Obstacle {
        name: "a clamp".into(),
        part: Part::from_mesh(mesh),
        clearance_mm,
        holder_clearance_mm,
        cut_by_the_tool: false,
        of_the_wheel: false,
        copies: Vec::new(),
    };
    let about = PartAmong { obstacles: std::slice::from_ref(&clamp), ..alone };
    // Fixtures turn with the wheel: seen from another blade they stand elsewhere.
    let blade_2 = setup.wheel.expect("a wheel").turn_to(2);
    let mut beside = |from: &Rigid| {
        let at = from * plan.value().toolpath.locations[0].centre;
        let pin = Obstacle { part: Part::from_mesh(block(&at, 1.0)), ..clamp.clone() };
        wide.obstacles.push(pin);
        let judged = wide.on_blade(&plan, 2).expect("a verdict");
        wide.obstacles.pop();
        judged.report().checks.iter().any(|c| !c.passed && c.id == CheckId::ObstacleGouge)
    };
    assert!(beside(&blade_2) && !beside(&blade_2.inverse()));
    let blind = rapids(&posted(alone), about);
    assert!(!blind.passed && blind.note.contains("a clamp: "), "{blind:?}");
    // The tool comes to a safe position beyond it where that is known.
    let lines = |text: &str| {
        text.lines().filter(|l| l.starts_with("G0 X") && l.contains('Z')).map(str::to_owned).collect::<Vec<_>>()
    };
    assert_ne!(lines(&posted(alone).text), lines(&posted(about).text));
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

/// A plate stands square to the rotor axis over the middle of the blade, and on one side hangs down
/// beside it: the tool leans to the one side of it or to the other. It leaves the blade under the
/// plate and comes back on its other side.
#[test]
fn where_no_axis_leads_on_the_tool_leaves_the_blade_and_comes_back() {
    let links = |on: bool| {
        let key = format!("orientation.links={on}");
        let changes = [key.as_str(), "region.start_mm=40", "region.end_mm=39"];
        let wide = |text: String| {
            let text = text.replace("swing_diameter_mm = ", "swing_diameter_mm = 1");
            text.replace("400.0", "900.0").replace("min_mm = 100.0", "min_mm = -500.0").replace("750.0", "900.0")
        };
        let mut setup = setup(&changes, of_prism::machine("trunnion_ac.toml", wide)).expect("a setup");
        let axial = setup.wheel.expect("a wheel").axis.into_inner();
        let beside = Vector::x().cross(&axial);
        let box_of = |[from, to]: [f64; 2], height: [f64; 2]| {
            let corner = |k: usize| {
                let pick = |bit: usize, [a, b]: [f64; 2]| if k >> bit & 1 == 0 { a } else { b };
                let way = Vector::x() * pick(2, height) + beside * pick(1, [from, to]) + axial * pick(0, [-0.5, 0.5]);
                Point::from(way)
            };
            boxed((0..8).map(corner).collect())
        };
        let plate = |name: &str, mesh: Mesh| Obstacle {
            name: name.into(),
            part: Part::from_mesh(mesh),
            clearance_mm: 0.1,
            holder_clearance_mm: 0.1,
            cut_by_the_tool: false,
            of_the_wheel: false,
            copies: Vec::new(),
        };
        setup.obstacles.push(plate("plate", box_of([-80.0, 80.0], [64.0, 100.0])));
        setup.obstacles.push(plate("flap", box_of([12.0, 80.0], [46.0, 64.0])));
        setup
    };
    let with = links(true);
    let (path, told) = match plan::plan(&with, &Silent) {
        Ok(Verdict::Passed(plan)) => (plan.value().toolpath.clone(), plan.report().clone()),
        Ok(Verdict::Failed(found)) => {
            panic!("{:?}", found.report().checks.iter().filter(|c| !c.passed).collect::<Vec<_>>())
        }
        Err(e) => panic!("{e}"),
    };
    let in_air = |w: &[bool; 2]| w[0] && !w[1];
    let touches: Vec<bool> = path.locations.iter().map(|l| l.touches()).collect();
    let links_of = touches.windows(2).filter(|w| in_air(&[w[0], w[1]])).count();
    assert!(links_of >= 2, "{links_of} links on {} turns", path.turns.len());
    // What is reported of the surface is what the turns leave.
    assert!(told.scallop_max_mm < 0.21, "{}", told.scallop_max_mm);
    // The turns are those of the path without links, to the last place.
    let bare = path.without_links();
    assert!(bare.locations.iter().all(|l| l.touches()) && bare.locations.len() + links_of < path.locations.len());
    let plain = with.path(&Silent).expect("a path");
    assert_eq!(bare.turns, plain.turns);
    assert_eq!(bare.locations, plain.locations);
    let e = plan::plan(&links(false), &Silent).map(|_| ()).expect_err("no plan without links");
    assert_eq!(e.kind, ErrorKind::Infeasible, "{e}");
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
        ("wheel.tip_mm=[[0, 40], [1, 50]]", "wheel.hub_mm is wanted beside it"),
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
    let round = setup(&["orientation.kind=\"cone\""], machine("demo_table_head.toml")).expect("a setup");
    let e = round.blades_in_turn().expect_err("the blade turns about itself");
    assert!(e.kind == ErrorKind::Usage && e.message.contains("turns the one blade about itself"), "{e}");
}

/// The prism so many times about the rotor axis of [`JOB`], as one model; the second one larger
/// across by a share.
fn whole_wheel(blades: u32, larger: f64) -> String {
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
        let across = if k == 1 { 1.0 + larger } else { 1.0 };
        for [x, y, z] in &vertices {
            let (y, z) = (across * y, z + 300.0);
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
    let twelve = whole_wheel(12, 0.0);
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

/// Blades that the model has itself are measured: one that is larger is cut, of one that is smaller
/// the ball stays off.
#[test]
fn a_blade_that_differs_is_found() {
    for (larger, bad) in [(0.0, None), (2e-3, Some(CheckId::Gouge)), (-2e-3, Some(CheckId::OtherBlade))] {
        let model = whole_wheel(5, larger);
        let changes = ["region.end_mm=39"];
        let machine = machine("demo_table_head.toml");
        let setup = of_prism::setup_of(("wheel.obj", model.as_bytes()), &without_wheel(), &changes, machine);
        let setup = setup.expect("a setup");
        let verdict = plan::plan(&setup, &Silent).expect("a plan");
        let first = plan::accept(verdict, true).expect("evidence");
        let of_first: Vec<CheckId> = first.report().checks.iter().filter(|c| !c.passed).map(|c| c.id.clone()).collect();
        let failing = |number: u32| -> Vec<CheckId> {
            let judged = setup.on_blade(&first, number).expect("a verdict");
            let failed = judged.report().checks.iter().filter(|c| !c.passed).map(|c| c.id.clone());
            failed.filter(|id| !of_first.contains(id)).collect()
        };
        // The model's frame names another blade first where one differs: all but one are alike.
        let odd: Vec<_> = (2..=5).map(failing).filter(|f| !f.is_empty()).collect();
        match &bad {
            None => assert!(odd.is_empty(), "{odd:?}"),
            Some(id) => assert!(odd.len() == 1 && odd[0].contains(id), "{larger}: {odd:?}"),
        }
    }
}
