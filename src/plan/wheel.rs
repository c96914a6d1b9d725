//! The wheel that a blade belongs to: what of it is in the tool's way.

use std::f64::consts::TAU;

use nalgebra::Unit;

use super::Setup;
use crate::artifact::{Blade, Obstacle, Plan, RotorFrame, Wheel};
use crate::channel::ChannelSettings;
use crate::error::{Error, Infeasible, Result, Stage};
use crate::geometry::mesh::Mesh;
use crate::geometry::part::Part;
use crate::geometry::{Point, Rigid, Vector};
use crate::job::WheelSettings;
use crate::observe::Observer;
use crate::parallel;
use crate::verify::{self, Verdict, Verified, Workspace};

/// A rotor axis nearer to the blade axis than this leaves the blade no radial direction (sine).
const ALONG_BLADE: f64 = 0.2;
/// Facets of the hub round its axis. They go round it: at a radius of 200 mm the hub is thicker by
/// at most 8 µm.
const FACETS: usize = 360;
/// Blades that share their ends, as sectors cut out of a wheel do, overlap by rounding, mm.
const SHARED_MM: f64 = 0.01;

/// The wheel of a job, in the blade frame.
///
/// # Errors
/// Kind `Usage` where the rotor axis is along the blade.
pub(super) fn of(settings: &WheelSettings, blade: &Blade) -> Result<Wheel> {
    settings.validate()?;
    let blade_from_model = blade.model_from_blade.inverse();
    let axis = Unit::new_normalize(blade_from_model * Vector::from(settings.axis));
    if axis.cross(&Vector::x()).norm() < ALONG_BLADE {
        let angle = axis.angle(&Vector::x()).to_degrees();
        let angle = angle.min(180.0 - angle);
        return Err(Error::usage(
            Stage::Job,
            format!("wheel.axis is {angle:.1}° from the blade axis: blades of a wheel stand away from its axis"),
        )
        .advise("give a blade axis that stands off the rotor axis, or the true wheel.axis; `inspect` prints both"));
    }
    Ok(Wheel { axis, origin: blade_from_model * Point::from(settings.origin_mm), blades: settings.blades })
}

impl Setup {
    /// How many blades of the wheel the machine turns to one after another.
    ///
    /// # Errors
    /// Kind `Usage` where there is no wheel, or the machine turns the one blade about itself.
    pub fn blades_in_turn(&self) -> Result<u32> {
        self.turns_wheel().map(|(wheel, _)| wheel.blades)
    }

    /// The wheel, and whether the axis that turns it goes on or back from blade to blade.
    fn turns_wheel(&self) -> Result<(&Wheel, f64)> {
        let refuse = |message: String, advice: &str| Err(Error::usage(Stage::Post, message).advise(advice));
        let Some(wheel) = &self.wheel else {
            return refuse(
                "every blade is asked for, but the job has no wheel".into(),
                "give section wheel in the job",
            );
        };
        if self.job.orientation.kind.goes_round() {
            return refuse(
                "every blade is asked for, but the machine turns the one blade about itself, not the wheel".into(),
                "plan with orientation.kind = \"five-axis\"",
            );
        }
        match self.machine.sense_about(&wheel.axis, &wheel.origin) {
            Some(sense) => Ok((wheel, sense)),
            None => refuse(
                format!("the machine {} does not turn the wheel about its rotor axis", self.machine.name),
                "name a machine whose table turns the workpiece",
            ),
        }
    }

    /// The checked plan on another blade of the wheel, by its number; the blade that was planned
    /// is number 1. Where the model has that blade itself, it is measured:
    /// [`verify::on_other_blade`].
    ///
    /// # Errors
    /// Those of [`Setup::blades_in_turn`]; kind `Infeasible` where an axis with ends of travel does
    /// not turn so far.
    pub fn on_blade(&self, plan: &Verified<Plan>, number: u32) -> Result<Verdict<Plan>> {
        let (wheel, sense) = self.turns_wheel()?;
        let (column, turn) = (self.machine.turning_axis(), wheel.turn_to(number));
        let by_rad = sense * TAU * f64::from(number.saturating_sub(1)) / f64::from(wheel.blades);
        let by_rad = self.within_travel(plan.value(), column, by_rad).map_err(|e| {
            let what = format!("blade {number} of {}: {}", wheel.blades, e.message);
            Error { message: what, ..e }
        })?;
        let own = self.blade.wheel.is_some_and(|w| w.whole);
        let (blade, obstacles) = (&self.blade, &self.obstacles[..]);
        let workspace = Workspace { blade, obstacles, tool: &self.job.tool, machine: &self.machine };
        Ok(verify::on_other_blade(plan, (&turn, column, by_rad), own, &workspace, &self.verify_options()))
    }

    /// An angle of the rotary axis that is as good as another, whole turns off, with which the plan
    /// is within the axis' travel.
    fn within_travel(&self, plan: &Plan, column: usize, by_rad: f64) -> Result<f64> {
        let axis = &self.machine.axes()[column];
        let Some([lo, hi]) = axis.limits.travel else { return Ok(by_rad) };
        let positions = plan.axes().map(|row| row[column]);
        let [a, b] = positions.fold([f64::INFINITY, f64::NEG_INFINITY], |[a, b], q| [a.min(q), b.max(q)]);
        let whole = ((0.5 * (lo + hi) - 0.5 * (a + b) - by_rad) / TAU).round();
        let nearest = by_rad + TAU * whole;
        if a + nearest >= lo && b + nearest <= hi {
            return Ok(nearest);
        }
        let [from, to, least, most] = [a + nearest, b + nearest, lo, hi].map(f64::to_degrees);
        let message = format!(
            "axis {} would run from {from:.3}° to {to:.3}°, its travel is {least:.3}° to {most:.3}°",
            axis.name
        );
        let what =
            Infeasible::TurnBeyondTravel { axis: axis.name.clone(), range_deg: [from, to], travel_deg: [least, most] };
        Err(Error::infeasible(Stage::Post, message, what)
            .advise("take a machine whose table turns without end, or set travel of that axis as it is"))
    }
}

/// The blade with the next one of its wheel as one part: between them lies the hub that rows go
/// over.
///
/// # Errors
/// Those of [`Part::with_copy`].
pub(super) fn with_next(wheel: &Wheel, blade: Blade, observer: &dyn Observer) -> Result<Blade> {
    let part = blade.part.with_copy(&wheel.turn_to(2), observer)?;
    Ok(Blade { part, ..blade })
}

/// The other blades and the hub, which keep the room of the channel from the tool; `next_too`: the
/// next blade belongs to the part.
///
/// # Errors
/// Kind `Infeasible` where neighbouring blades overlap.
pub(super) fn bodies(
    wheel: &Wheel,
    settings: &WheelSettings,
    blade: &Blade,
    channel: &ChannelSettings,
    next_too: bool,
) -> Result<Vec<Obstacle>> {
    apart(wheel, blade)?;
    let body = |name: String, mesh: Mesh, deflection_mm: f64| {
        let mut part = Part::from_mesh(mesh);
        part.deflection_mm = deflection_mm;
        let [clearance_mm, holder_clearance_mm] = [channel.clearance_mm, channel.holder_clearance_mm];
        let (cut_by_the_tool, of_the_wheel, copies) = (false, true, Vec::new());
        Obstacle { name, part, clearance_mm, holder_clearance_mm, cut_by_the_tool, of_the_wheel, copies }
    };
    let (off_mm, first) = (blade.part.deflection_mm, if next_too { 3 } else { 2 });
    let copies: Vec<Rigid> = (first..=wheel.blades).map(|k| wheel.turn_to(k)).collect();
    let others = parallel::map(&copies, |turn| blade.part.mesh.clone().moved(turn));
    // One body: how near the tool comes to the nearest of them is one question, and the far ones
    // then cost nothing.
    let others = Obstacle { copies, ..body("the other blades".into(), together(&others), off_mm) };
    let mut out = vec![others];
    // An axis along the blade was refused when the wheel was read.
    if let Some(frame) = RotorFrame::new(wheel).filter(|_| !settings.hub_mm.is_empty()) {
        out.push(body("hub".into(), hub(&frame, &settings.hub_mm), 0.0));
    }
    Ok(out)
}

/// Several meshes as one, without faces: its groups are the meshes.
fn together(meshes: &[Mesh]) -> Mesh {
    let mut out = Mesh::default();
    for (group, mesh) in (0..).zip(meshes) {
        let first = out.points.len() as u32;
        out.points.extend_from_slice(&mesh.points);
        out.triangles.extend(mesh.triangles.iter().map(|t| t.map(|k| first + k)));
        out.face_of.extend(std::iter::repeat_n(group, mesh.triangles.len()));
    }
    out
}

/// The blade and the next one do not overlap.
fn apart(wheel: &Wheel, blade: &Blade) -> Result<()> {
    let back = wheel.turn_to(2).inverse();
    let mesh = &blade.part.mesh;
    // Points of the next blade, seen from this one as if it were in the other's place.
    let depth = |p: &Point| {
        let q = back * p;
        let near = blade.part.closest_on_mesh(&q, f64::INFINITY)?;
        let own = blade.part.inside(&q).then_some(near.distance_mm).filter(|d| *d > SHARED_MM)?;
        Some((own, *p))
    };
    let bounds = mesh.aabb();
    let may_be = |p: &&Point| {
        let q = back * *p;
        bounds.as_ref().is_some_and(|b| (0..3).all(|k| b.min[k] <= q[k] && q[k] <= b.max[k]))
    };
    let deepest = parallel::filter_map(mesh.points.iter().filter(may_be), depth);
    let deepest = deepest.into_iter().max_by(|a, b| a.0.total_cmp(&b.0));
    let Some((depth_mm, at)) = deepest else { return Ok(()) };
    let at: [f64; 3] = (blade.model_from_blade * at).into();
    let [x, y, z] = at;
    let message = format!(
        "neighbouring blades overlap: at ({x:.3}, {y:.3}, {z:.3}) mm of the model the blade is {depth_mm:.3} mm inside \
         the next one of {}",
        wheel.blades
    );
    let since = Infeasible::BladesOverlap { blades: wheel.blades, depth_mm, at_mm: at };
    Err(Error::infeasible(Stage::Model, message, since)
        .advise("give the true wheel.blades, wheel.axis and wheel.origin_mm of the model's frame"))
}

/// The body of revolution of a hub's contour, closed towards the rotor axis; blade frame.
fn hub(frame: &RotorFrame, contour: &[[f64; 2]]) -> Mesh {
    let outside = 1.0 / (std::f64::consts::PI / FACETS as f64).cos();
    let mut points = Vec::with_capacity(contour.len() * FACETS + 2);
    for [x, radius] in contour {
        for k in 0..FACETS {
            points.push(frame.point(*x, TAU * k as f64 / FACETS as f64, radius * outside));
        }
    }
    let ends = [contour.first(), contour.last()].map(|p| p.map_or(0.0, |p| p[0]));
    points.extend(ends.map(|x| frame.point(x, 0.0, 0.0)));
    let [first, last] = [contour.len() * FACETS, contour.len() * FACETS + 1].map(|k| k as u32);
    let at = |ring: usize, k: usize| (ring * FACETS + k % FACETS) as u32;
    let mut triangles = Vec::with_capacity(2 * contour.len() * FACETS);
    for k in 0..FACETS {
        triangles.push([first, at(0, k + 1), at(0, k)]);
        for ring in 1..contour.len() {
            let [a, b, c, d] = [at(ring - 1, k), at(ring - 1, k + 1), at(ring, k + 1), at(ring, k)];
            triangles.push([a, b, c]);
            triangles.push([a, c, d]);
        }
        triangles.push([last, at(contour.len() - 1, k), at(contour.len() - 1, k + 1)]);
    }
    Mesh { points, triangles, ..Mesh::default() }
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used)]
    use std::path::Path;

    use super::*;
    use crate::artifact::CheckId;
    use crate::job;
    use crate::machine::Machine;
    use crate::observe::Silent;
    use crate::sample;

    #[test]
    fn a_hub_is_a_closed_body_round_its_contour() {
        let wheel = Wheel { axis: Vector::z_axis(), origin: Point::new(1.0, 2.0, 3.0), blades: 5 };
        let mesh = hub(&RotorFrame::new(&wheel).unwrap(), &[[-10.0, 40.0], [0.0, 50.0], [20.0, 30.0]]);
        assert!(crate::geometry::mesh::topology(&mesh).closed());
        // Two frusta; the facets go round them.
        let frustum = |h: f64, a: f64, b: f64| std::f64::consts::PI * h * (a * a + a * b + b * b) / 3.0;
        let exact = frustum(10.0, 40.0, 50.0) + frustum(20.0, 50.0, 30.0);
        let volume = mesh.volume_mm3();
        assert!(volume > exact && volume < exact * (1.0 + 1e-4), "{volume} {exact}");
        let least = |x: f64, r: f64| {
            let on = |k: usize| {
                let (s, c) = (0.01 + 0.02 * k as f64).sin_cos();
                Point::new(1.0 + r * c, 2.0 + r * s, 3.0 + x)
            };
            let part = Part::from_mesh(mesh.clone());
            (0..300).all(|k| part.inside(&on(k)) || part.closest_on_mesh(&on(k), 1.0).unwrap().distance_mm < 1e-9)
        };
        assert!(least(5.0, 45.0) && least(-5.0, 45.0));
    }

    /// The sample impeller as it is read.
    fn impeller() -> Blade {
        let mesh = sample::impeller();
        let mut text = String::new();
        for p in &mesh.points {
            text += &format!("v {} {} {}\n", p.x, p.y, p.z);
        }
        for [a, b, c] in &mesh.triangles {
            text += &format!("f {} {} {}\n", a + 1, b + 1, c + 1);
        }
        let model = crate::read::model::ModelOptions::default();
        crate::read::model::load_bytes(Path::new("impeller.obj"), text.as_bytes(), &model, &Silent).unwrap()
    }

    /// A ball that has room within the blade goes round it all the same, wherever its turns begin.
    #[test]
    fn small_balls_go_round_the_blade_of_an_impeller_outside() {
        let blade = impeller();
        let usual = crate::path::PathOptions::new(0.6, 0.2);
        for k in 0..12 {
            let start_mm = 5.0 + 0.55 * f64::from(k);
            let extent = crate::plan::Extent::heights(Some(start_mm), Some(start_mm - 1.0));
            let options = crate::path::PathOptions { extent, ..usual.clone() }
                .with(|s| s.kind = crate::plan::PathKind::ConstantHeight);
            let path = crate::path::plan(&blade, &options, &Silent).unwrap();
            let inside = path.locations.iter().filter(|l| blade.part.inside(&l.centre)).count();
            assert_eq!(inside, 0, "from height {start_mm}: {inside} of {}", path.locations.len());
        }
    }

    /// A blade whose hub turns from along the rotor axis to across it: the turns lie at heights
    /// over that hub, and every check passes.
    #[test]
    fn the_blade_of_an_impeller_is_planned_over_its_hub() {
        let job = "
            [model]
            file = 'impeller.obj'
            [machine]
            file = 'trunnion_ac.toml'
            [region]
            start_mm = 8
            end_mm = 5
            [path]
            scallop_mm = 0.2
            [tool]
            radius_mm = 2
            taper_deg = 3
            shank_radius_mm = 4
            stickout_mm = 80
            holder = [{ radius_mm = 15, length_mm = 60 }]
            [verify]
            surface_samples = 20000
        ";
        let blade = impeller();
        let along = blade.regions.list[0].along.for_ball(2.0).unwrap();
        let machine = include_str!("../../models/machines/trunnion_ac.toml");
        let draft = job::resolve(job::parse(job, "job").unwrap(), Path::new("")).unwrap();
        let setup = Setup::of(&draft, blade, Machine::from_toml(machine, "trunnion").unwrap(), &Silent).unwrap();
        assert_eq!(setup.job.orientation.kind, crate::orient::OrientationKind::FiveAxis);
        let plan = match crate::plan::plan(&setup, &Silent).unwrap() {
            Verdict::Passed(plan) => plan.value().clone(),
            Verdict::Failed(found) => {
                let failed = found.report().checks.iter().filter(|c| !c.passed);
                panic!("{:?}", failed.collect::<Vec<_>>())
            }
        };
        // Both sides of the one blade, from its one end to the other.
        let path = &plan.toolpath;
        let heights = path.locations.iter().map(|l| along.height_mm(&l.centre));
        assert!(heights.clone().all(|h| (4.9..8.1).contains(&h)), "{:?}", heights.collect::<Vec<_>>());
        let ends = path.locations.iter().map(|l| along.round().unwrap().along(&l.contact));
        let [from, to] = ends.fold([1.0f64, 0.0f64], |[a, b], t| [a.min(t), b.max(t)]);
        assert!(from < 0.02 && to > 0.98, "{from} {to}");
        let round = |l: &crate::artifact::toolpath::CutterLocation| along.frame(&l.centre).across(&l.normal)[0];
        assert!(path.locations.iter().any(|l| round(l) > 0.5) && path.locations.iter().any(|l| round(l) < -0.5));
        // The end that the job does not ask for is found.
        let mut short = plan;
        let last = short.toolpath.turns.len() - 2;
        short.toolpath.turns.truncate(last);
        let verdict = setup.verdict(short, &Silent).unwrap();
        let Verdict::Failed(found) = verdict else { panic!("a shorter path passes") };
        assert!(found.report().checks.iter().any(|c| c.id == CheckId::JobRegion && !c.passed));
    }

    /// What such a blade does not let a job ask for is refused.
    #[test]
    fn a_cone_over_a_hub_that_turns_is_refused() {
        let mesh = sample::impeller();
        let (plates, _) = sample::plates(12, 2.0);
        let hub = |k: usize| sample::impeller_contour(0, k as f64 / 40.0);
        let tip = |k: usize| sample::impeller_contour(1, k as f64 / 40.0);
        let contours = [(0..=40).map(hub).collect::<Vec<_>>(), (0..=40).map(tip).collect()];
        let meridian =
            crate::artifact::meridian::Meridian::new(Vector::z(), Point::origin(), &contours[0], &contours[1]).unwrap();
        let mut blade = Blade { part: Part::from_mesh(mesh), ..plates };
        blade.regions.list[0].along = crate::artifact::along::Along::over_hub(meridian);
        let settle = |text: &str| {
            let job = format!("[model]\nfile = 'impeller.obj'\n{text}");
            job::resolve(job::parse(&job, "job").unwrap(), Path::new("")).unwrap().settle(&blade).map(|_| ())
        };
        let e = settle("[tool]\nradius_mm = 2\n[orientation]\nkind = 'cone'").unwrap_err();
        assert!(e.message.contains("orientation.kind is cone"), "{e}");
        let e = settle("").unwrap_err();
        assert!(e.message.contains("tool.radius_mm is missing"), "{e}");
        settle("[tool]\nradius_mm = 2").unwrap();
    }

    /// Five axes mill the hub between two plates: every check passes, and one of them tells when
    /// the rows next to a plate are missing.
    #[test]
    fn rows_over_a_hub_pass_all_checks_and_missing_ones_are_found() {
        let job = "
            [model]
            file = 'plates.step'
            [wheel]
            [orientation]
            kind = 'five-axis'
            [path]
            kind = 'hub-rows'
            scallop_mm = 0.2
            [tool]
            radius_mm = 3
            taper_deg = 3
            shank_radius_mm = 5
            stickout_mm = 130
            holder = [{ radius_mm = 15, length_mm = 40 }]
            [verify]
            surface_samples = 20000
        ";
        let draft = job::resolve(job::parse(job, "job").unwrap(), Path::new("")).unwrap();
        let (blade, _) = sample::plates(12, 2.0);
        let setup = Setup::of(&draft, blade, Machine::demo().unwrap(), &Silent).unwrap();
        let plan = match crate::plan::plan(&setup, &Silent).unwrap() {
            Verdict::Passed(plan) => plan.value().clone(),
            Verdict::Failed(found) => {
                let failed = found.report().checks.iter().filter(|c| !c.passed);
                panic!("{:?}", failed.collect::<Vec<_>>())
            }
        };
        assert!(matches!(plan.toolpath.cones, crate::artifact::Cones::Each(_)));
        let turning = plan.toolpath.axis_turning.unwrap();
        let is_proven = |over: Option<f64>| over.is_some_and(|over| (1.0 - 1e-9..1.01).contains(&over));
        assert!(turning.over_bounds().into_iter().all(is_proven), "{turning:?}");
        let hub = |plan: &Plan| {
            let verdict = setup.verdict(plan.clone(), &Silent).unwrap();
            let checks = match &verdict {
                Verdict::Passed(v) => v.report().checks.clone(),
                Verdict::Failed(f) => f.report().checks.clone(),
            };
            checks.into_iter().find(|c| c.id == CheckId::JobRegion).unwrap()
        };
        assert!(hub(&plan).passed, "{:?}", hub(&plan));
        let mut short = plan;
        let last = short.toolpath.turns.len() - 4;
        short.toolpath.turns.truncate(last);
        let found = hub(&short);
        assert!(!found.passed && found.turn.is_some(), "{found:?}");
    }
}
