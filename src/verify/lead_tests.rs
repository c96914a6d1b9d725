#![allow(clippy::unwrap_used)]
use super::*;
use crate::artifact::CheckId;
use crate::geometry::mesh::Mesh;
use crate::machine::AxisLimits;
use crate::sample;

/// The sample's blade with a thin triangle more.
fn with_needle(corners: [Point; 3]) -> Blade {
    let mut blade = sample::blade();
    let mut mesh: Mesh = blade.part.mesh.clone();
    let n = mesh.points.len() as u32;
    mesh.points.extend(corners);
    mesh.triangles.push([n, n + 1, n + 2]);
    mesh.face_of.push(9);
    blade.part = Part::from_mesh(mesh);
    blade
}

fn plan() -> Plan {
    sample::with_leads(sample::plan(1, 360))
}

fn failing(plan: &Plan, blade: &Blade) -> Vec<Check> {
    let (tool, machine) = (sample::tool(), Machine::demo().unwrap());
    let options = VerifyOptions::default().with(|s| s.gouge_mm = 0.004);
    let (stock_mm, obstacles) = (0.0, &[][..]);
    let room = Room { blade, stock_mm, obstacles, tool: &tool, machine: &machine, options: &options };
    check(plan, &room).into_iter().filter(|c| !c.passed).collect()
}

fn only(found: &[Check], id: CheckId) -> Check {
    assert!(found.len() == 1 && found[0].id == id, "{found:#?}");
    found[0].clone()
}

#[test]
fn clean_leads_have_no_finding() {
    assert!(failing(&plan(), &sample::blade()).is_empty(), "{:#?}", failing(&plan(), &sample::blade()));
    let straight = sample::plan(1, 360);
    assert!(failing(&straight, &sample::blade()).is_empty());
}

#[test]
fn what_is_planted_in_a_lead_is_found_and_named() {
    let clean = plan();
    let at = clean.leads[1].centres.len() / 2;
    // A needle whose end reaches 0.02 mm into the ball in the middle of the lead-out, from the side
    // that the tool leans away from.
    let c = clean.leads[1].centres[at];
    let (x, side) = (Vector::x(), Vector::y() * 0.01);
    let end = c - x * (5.0 - 0.02);
    let found = failing(&clean, &with_needle([end, end - x * 0.3 + side, end - x * 0.3 - side]));
    // So near to the ball it is also nearer to the taper than the clearance that is asked for,
    // which it does not touch.
    assert!(
        found.iter().all(|c| c.id == CheckId::LeadGouge || c.id == CheckId::LeadClearance && c.worst > 0.0),
        "{found:#?}"
    );
    let g = only(&found.into_iter().filter(|c| c.id == CheckId::LeadGouge).collect::<Vec<_>>(), CheckId::LeadGouge);
    assert!((0.015..0.03).contains(&g.worst) && g.note == "lead-out", "{g:?}");
    // One that reaches 0.1 mm into the second holder stage on the straight line only.
    let outer = clean.leads[0].stands(clean.toolpath.cone(0)).next().unwrap();
    let (c, axis) = (outer.centre, outer.axis());
    let out = axis.cross(&Vector::x()).normalize();
    let reach = c + axis * 140.0 + out * 29.9;
    let blade = with_needle([reach, reach + out * 9.0 + Vector::x() * 0.05, reach + out * 9.0 - Vector::x() * 0.05]);
    let h = only(&failing(&clean, &blade), CheckId::LeadHolderClearance);
    assert!((h.worst + 0.1).abs() < 0.02 && h.note.contains("lead-in: holder 2"), "{h:?}");
    let mut moved = clean.clone();
    moved.leads[0].motion.position[3][1] += 0.001;
    let a = only(&failing(&moved, &sample::blade()), CheckId::LeadAxes);
    assert!((a.worst - 0.001).abs() < 1e-9);
    let mut fast = clean.clone();
    let shift = fast.leads[1].motion.t_s[0];
    fast.leads[1].motion.t_s.iter_mut().for_each(|t| *t = shift + (*t - shift) * 0.01);
    assert!(only(&failing(&fast, &sample::blade()), CheckId::LeadLimits).note.contains("axis "));
}

#[test]
fn an_arc_without_room_is_refused_with_what_is_in_the_way() {
    let plan = plan();
    let (tool, machine) = (sample::tool(), Machine::demo().unwrap());
    let options = VerifyOptions::default().with(|s| s.gouge_mm = 0.004);
    let foot = plan.stand(0).unwrap();
    let said = |blade: &Blade, machine: &Machine, obstacles: &[Obstacle]| {
        let stock_mm = 0.0;
        let room = Room { blade, stock_mm, obstacles, tool: &tool, machine, options: &options };
        obstructed(&plan.leads[0], foot, true, &room)
    };
    assert_eq!(said(&sample::blade(), &machine, &[]), None);
    // A wall across the arc, beside the path.
    let c = plan.leads[0].centres[10];
    let wall = [c, c + Vector::new(1.0, 0.0, 0.0), c + Vector::new(0.0, 0.0, -1.0)];
    let cut = said(&with_needle(wall), &machine, &[]).unwrap();
    assert!(matches!(cut, InTheWay::Cut { depth_mm, .. } if depth_mm > 0.004), "{cut}");
    let stand = plan.leads[0].stands(foot.cone).nth(10).unwrap();
    let q = machine.place(&stand, None, tool.length_mm());
    let z = machine.axes()[2].limits;
    let short = machine.clone().with_limits(2, AxisLimits { travel: z.travel.map(|[lo, _]| [lo, q[2]]), ..z });
    assert_eq!(said(&sample::blade(), &short, &[]), Some(InTheWay::Travel { axis: "Z".into() }));
    let axis = stand.axis();
    let beside = c + axis * 30.0 + axis.cross(&Vector::x()).normalize() * 7.0;
    let clamp = Obstacle {
        name: "the clamp".into(),
        part: with_needle([beside, beside + Vector::x(), beside + axis]).part,
        clearance_mm: 0.1,
        holder_clearance_mm: 1.0,
        cut_by_the_tool: false,
        of_the_wheel: false,
        copies: Vec::new(),
    };
    let why = said(&sample::blade(), &machine, &[clamp]).unwrap();
    assert!(matches!(&why, InTheWay::Near { body, .. } if body.contains("the clamp")), "{why}");
}

/// A pin below the tip of the ball on its way onto the path, where no other part of the tool
/// comes: no lead is laid through it, and the checks find it in one that is.
#[test]
fn the_ball_of_a_lead_keeps_clear_of_other_bodies() {
    let plan = plan();
    let (tool, machine, blade) = (sample::tool(), Machine::demo().unwrap(), sample::blade());
    let options = VerifyOptions::default().with(|s| s.gouge_mm = 0.004);
    let stand = plan.leads[0].stands(plan.toolpath.cone(0)).nth(2).unwrap();
    let tip = stand.centre - stand.axis() * (tool.radius_mm - 0.3);
    let corners = [Vector::zeros(), Vector::x(), Vector::y(), Vector::z()].map(|v| tip - stand.axis() * 0.1 + v * 0.05);
    let triangles = vec![[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3]];
    let pin = Obstacle {
        name: "the pin".into(),
        part: Part::from_mesh(Mesh { points: corners.to_vec(), triangles, ..Mesh::default() }),
        clearance_mm: 0.0,
        holder_clearance_mm: 0.0,
        cut_by_the_tool: false,
        of_the_wheel: false,
        copies: Vec::new(),
    };
    let failing = |obstacles: &[Obstacle]| {
        let room = Room { blade: &blade, stock_mm: 0.0, obstacles, tool: &tool, machine: &machine, options: &options };
        let why = obstructed(&plan.leads[0], plan.stand(0).unwrap(), true, &room);
        (why, check(&plan, &room).into_iter().filter(|c| !c.passed).collect::<Vec<_>>())
    };
    let (why, found) = failing(std::slice::from_ref(&pin));
    assert!(matches!(&why, Some(InTheWay::Cut { body, .. }) if body == "the pin"), "{why:?}");
    let deepest = found.iter().find(|c| c.quantity.starts_with("depth of the ball")).unwrap();
    assert!(deepest.id == CheckId::LeadObstacle && deepest.worst > 0.2, "{deepest:?}");
    assert_eq!(deepest.note, "lead-in: nearest is the pin");
    // The cutter may go through stock.
    assert_eq!(failing(&[Obstacle { cut_by_the_tool: true, ..pin }]), (None, Vec::new()));
}

#[test]
fn what_is_left_of_a_plan_keeps_its_evidence_and_a_new_lead_is_checked() {
    use crate::verify::{Verdict, Verified, restart};
    let whole = sample::with_leads(sample::plan(3, 360));
    let mut report = sample::report();
    report.checks.retain(|c| c.passed);
    let kept = report.checks[0].id.clone();
    report.checks.push(Check::at_most(CheckId::LeadGouge, "of the whole", 9.0, 10.0, "mm", String::new()));
    let verified = Verified::for_tests(whole.clone(), report, false);
    let (tool, machine, blade) = (sample::tool(), Machine::demo().unwrap(), sample::blade());
    let options = VerifyOptions::default().with(|s| s.gouge_mm = 0.004);
    let room = Room { blade: &blade, stock_mm: 0.0, obstacles: &[], tool: &tool, machine: &machine, options: &options };
    let left = sample::with_leads(whole.from_turn(1).unwrap());
    assert!(left.leads[0].is_arc());
    let found = restart(&verified, left.clone(), &room).unwrap();
    let named = |id: CheckId| found.report().checks.iter().filter(|c| c.id == id).collect::<Vec<_>>();
    assert_eq!(named(kept).len(), 1);
    assert!(
        named(CheckId::LeadGouge).len() == 1
            && named(CheckId::LeadGouge)[0].worst < 0.004
            && named(CheckId::LeadGouge)[0].row == Some(0)
    );
    assert!(named(CheckId::AxesCentre).len() == 1 && named(CheckId::AxesCentre)[0].passed);
    // A lead that goes through the part is found.
    let mut deep = left.clone();
    let inwards = deep.toolpath.locations[0].normal * 1.0;
    deep.leads[0].centres.iter_mut().for_each(|c| *c -= inwards);
    let Verdict::Failed(bad) = restart(&verified, deep, &room).unwrap() else { panic!("no finding") };
    assert!(bad.report().checks.iter().any(|c| c.id == CheckId::LeadGouge && !c.passed && c.worst > 0.5));
    // Evidence is for the plan that was checked, to the bit.
    let mut moved = left.clone();
    moved.toolpath.locations[7].centre.x += 1e-12;
    let mut turned = left;
    turned.schedule.theta[7] += 1e-12;
    for other in [moved, turned] {
        let e = restart(&verified, other, &room).unwrap_err();
        assert!(e.message.contains("not the end of the plan"), "{}", e.message);
    }
}
