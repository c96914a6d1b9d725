//! A small made-up plan for the unit tests of the writers: a closed cylinder about the blade axis,
//! milled by a helix.
//!
//! Everything has a closed form: the ball centre runs on a cylinder of radius `PART_RADIUS + R`,
//! the tool axis leads the normal by [`LEAD_RAD`], the channel is that ± [`WIDTH_RAD`].
#![allow(clippy::unwrap_used)]

use crate::artifact::axis_motion::AxisMotion;
use crate::artifact::blade::{Blade, Diagnosis, Unit};
use crate::artifact::channel::{Binding, Channel, ChannelRow};
use crate::artifact::plan::Plan;
use crate::artifact::programmed::{CurveRow, Way};
use crate::artifact::region::Regions;
use crate::artifact::report::{Check, CheckReport};
use crate::artifact::schedule::{Schedule, ScheduleKind};
use crate::artifact::section::{AlteredPoint, Section, SectionLoop, Side};
use crate::artifact::toolpath::{CutterLocation, Toolpath, Turn};
use crate::artifact::wheel::{ModelWheel, Wheel};
use crate::artifact::{Axes, AxisRows, CheckId, Cones, ProgrammedCurve, ToolPart};
use crate::error::EndReason;
use crate::geometry::brep::{Brep, Face, SurfaceKind};
use crate::geometry::mesh::Mesh;
use crate::geometry::nurbs::shapes;
use crate::geometry::part::Part;
use crate::geometry::{Point, Rigid, Vector};
use crate::lead::{self, End, LeadOptions};
use crate::machine::Machine;
use crate::numerics::spline::{CubicSpline, SplineEnds};
use crate::observe::Silent;
use crate::tool::{HolderStage, Tool};

/// Radius of the part, mm.
pub const PART_RADIUS: f64 = 20.0;
/// Length of the part, mm.
pub const PART_LENGTH: f64 = 60.0;
/// θ less the angle of the surface normal, rad.
pub const LEAD_RAD: f64 = 0.3;
/// Half width of the channel, rad.
pub const WIDTH_RAD: f64 = 0.8;
/// The head's angle, rad.
pub const B_RAD: f64 = 0.087_266_462_599_716_47;

/// A ball-end tool of radius 5 mm.
pub fn tool() -> Tool {
    Tool {
        radius_mm: 5.0,
        corner_radius_mm: None,
        taper_deg: 3.0,
        shank_radius_mm: 8.0,
        stickout_mm: 70.0,
        holder: vec![
            HolderStage { radius_mm: 20.0, length_mm: 40.0 },
            HolderStage { radius_mm: 30.0, length_mm: 25.0 },
        ],
    }
}

/// A third of a round trough about the blade axis, seen from within; `steps` facets round it.
pub fn trough(radius_mm: f64, steps: u32) -> Mesh {
    let mut mesh = Mesh::default();
    for k in 0..=steps {
        let (s, c) = (2.1 * f64::from(k) / f64::from(steps)).sin_cos();
        mesh.points.extend([-40.0, 40.0].map(|x| Point::new(x, radius_mm * c, radius_mm * s)));
    }
    for k in 0..steps {
        let [a, b] = [2 * k, 2 * k + 2];
        mesh.triangles.extend([[a, b, a + 1], [a + 1, b, b + 1]]);
        mesh.face_of.extend([0, 0]);
    }
    mesh
}

/// The cylinder, closed by fans at both ends; faces: 0 side, 1 root end, 2 tip end.
pub fn blade() -> Blade {
    let n = 48u32;
    let mut mesh = Mesh::default();
    for x in [0.0, PART_LENGTH] {
        for i in 0..n {
            let (s, c) = (f64::from(i) * std::f64::consts::TAU / f64::from(n)).sin_cos();
            mesh.points.push(Point::new(x, PART_RADIUS * c, PART_RADIUS * s));
        }
    }
    mesh.points.push(Point::origin());
    mesh.points.push(Point::new(PART_LENGTH, 0.0, 0.0));
    let mut add = |t: [u32; 3], face| {
        mesh.triangles.push(t);
        mesh.face_of.push(face);
    };
    for i in 0..n {
        let j = (i + 1) % n;
        add([i, j, n + j], 0);
        add([i, n + j, n + i], 0);
        add([2 * n, j, i], 1);
        add([2 * n + 1, n + i, n + j], 2);
    }
    Blade {
        name: "cylinder".into(),
        unit: Unit::Mm,
        part: Part::from_mesh(mesh),
        model_from_blade: Rigid::translation(1.0, 2.0, 3.0)
            * Rigid::rotation(Vector::new(0.0, -std::f64::consts::FRAC_PI_2, 0.0)),
        regions: Regions {
            reasons: vec!["a cylinder".into()],
            ..Regions::at_heights([0.0, PART_LENGTH], [0.0, PART_LENGTH], None)
        },
        wheel: None,
        diagnosis: Diagnosis::default(),
    }
}

/// A plan of `turns` turns with `per_turn` locations each.
pub fn plan(turns: usize, per_turn: usize) -> Plan {
    let (radius, pitch, x0) = (tool().radius_mm, 0.5, 20.0);
    let step = std::f64::consts::TAU / per_turn as f64;
    let slope = pitch / std::f64::consts::TAU;
    let ds = step * (PART_RADIUS + radius).hypot(slope);
    let location = |i: usize| {
        let phi = i as f64 * step;
        let normal = Vector::new(0.0, phi.cos(), phi.sin());
        let contact = Point::new(x0 + slope * phi, 0.0, 0.0) + normal * PART_RADIUS;
        CutterLocation {
            turn: (i / per_turn).min(turns - 1) as u32,
            turn_s_mm: (i - (i / per_turn).min(turns - 1) * per_turn) as f64 * ds,
            s_mm: i as f64 * ds,
            centre: contact + normal * radius,
            contact,
            normal,
        }
    };
    let count = turns * per_turn + 1;
    let locations: Vec<_> = (0..count).map(location).collect();
    let theta: Vec<f64> = (0..count).map(|i| i as f64 * step + LEAD_RAD).collect();
    let toolpath = Toolpath {
        kind: crate::artifact::toolpath::PathKind::default(),
        stock_mm: 0.0,
        radius_mm: radius,
        disc_radius_mm: 0.0,
        scallop_mm: 0.01,
        chord_mm: 0.002,
        region_x_mm: [x0, x0 + pitch * turns as f64],
        end_reason: EndReason::Region,
        planned_scallop_mm: 0.0099,
        cones: Cones::about_blade(B_RAD),
        axis_turning: None,
        turns: (0..turns)
            .map(|t| Turn {
                first: t * per_turn,
                count: if t + 1 == turns { per_turn + 1 } else { per_turn },
                length_mm: ds * per_turn as f64,
            })
            .collect(),
        locations,
    };
    let (channel, schedule) = (channel(&theta), schedule(&theta, ds));
    let motion = motion(&toolpath, &theta);
    Plan { toolpath, channel, schedule, motion, leads: Default::default(), curve: None }
}

/// One turn of [`plan`] that turns back on itself at location `at`, by `by` locations, and goes on
/// over the same ground, while θ grows on. The way back is off the ways there by less than what a
/// program rounds to.
pub fn turned_back(per_turn: usize, at: usize, by: usize) -> Plan {
    let Plan { mut toolpath, leads, curve, .. } = plan(1, per_turn);
    let ds = toolpath.locations[1].s_mm;
    let rows = (0..=at).chain((at - by..at).rev()).chain(at - by + 1..=per_turn);
    let along = |(i, row): (usize, usize)| {
        let s_mm = i as f64 * ds;
        let back = if (at + 1..at + by).contains(&i) { Vector::x() * 4e-6 } else { Vector::zeros() };
        let there = toolpath.locations[row];
        CutterLocation { s_mm, turn_s_mm: s_mm, centre: there.centre + back, contact: there.contact + back, ..there }
    };
    toolpath.locations = rows.enumerate().map(along).collect();
    let count = toolpath.locations.len();
    toolpath.turns[0] = Turn { first: 0, count, length_mm: (count - 1) as f64 * ds };
    let step = std::f64::consts::TAU / per_turn as f64;
    let theta: Vec<f64> = (0..count).map(|i| i as f64 * step + LEAD_RAD).collect();
    let (channel, schedule) = (channel(&theta), schedule(&theta, ds));
    let motion = motion(&toolpath, &theta);
    Plan { toolpath, channel, schedule, motion, leads, curve }
}

/// The plan with arcs of radius 4 mm and 90 degrees at both ends, at the same feed.
pub fn with_leads(mut plan: Plan) -> Plan {
    let options = LeadOptions { radius_mm: 4.0 };
    let first = |end| lead::candidates(&plan.toolpath, &plan.schedule, end, &options).swap_remove(0);
    let leads = [first(End::In), first(End::Out)];
    let (path, schedule) = lead::extended(&plan.toolpath, &plan.schedule, &leads);
    (plan.motion, plan.leads) = lead::split(&motion(&path, &schedule.theta), leads);
    plan
}

/// The plan with θ on a curve that swings to and fro: cubics in S that are twice differentiable
/// where they meet, of other lengths than the ways between locations. The angles at the locations
/// are the curve's; the axes follow.
pub fn with_curve(mut plan: Plan, swing_rad: f64, per_piece: f64) -> Plan {
    let (s, theta): (Vec<f64>, Vec<f64>) =
        plan.toolpath.locations.iter().map(|l| l.s_mm).zip(plan.schedule.theta.iter().copied()).unzip();
    let (length, slope) = (s[s.len() - 1], (theta[theta.len() - 1] - theta[0]) / s[s.len() - 1]);
    let count = ((s.len() - 1) as f64 / per_piece).ceil() as usize;
    let knots: Vec<f64> = (0..=count).map(|k| length * k as f64 / count as f64).collect();
    let at = |x: f64| theta[0] + slope * x + swing_rad * (23.0 * x / length).sin();
    let values: Vec<f64> = knots.iter().map(|x| at(*x)).collect();
    let spline = CubicSpline::new(&knots, &values, 1, &SplineEnds::Natural).unwrap();
    let piece = |(k, w): (usize, &[f64])| {
        let ([a, b, c, _], h) = (spline.coefficients(k, 0).unwrap(), w[1] - w[0]);
        let theta = [a, a + b * h / 3.0, a + 2.0 * b * h / 3.0 + c * h * h / 3.0, values[k + 1]];
        std::array::from_fn(|i| [w[0] + h * i as f64 / 3.0, theta[i]])
    };
    plan.schedule.pieces = knots.windows(2).enumerate().map(piece).collect();
    plan.schedule.theta = s.iter().map(|x| plan.schedule.curve_at(*x).unwrap()).collect();
    plan.motion = motion(&plan.toolpath, &plan.schedule.theta);
    plan
}

/// The plan on a programmed curve: the helix itself, θ swinging to and fro about its angle with the
/// waves given. Pieces are so many ways between locations long.
pub fn on_curve(mut plan: Plan, swing_rad: f64, waves: f64, per_piece: usize) -> Plan {
    let l = &plan.toolpath.locations;
    let (length, n) = (l[l.len() - 1].s_mm, l.len());
    let (from, to) = (plan.schedule.theta[0], plan.schedule.theta[n - 1]);
    let (slope, wave) = ((to - from) / length, waves / length);
    // The angle of the normal grows evenly with the arc length, as that of θ does on average.
    let rho = PART_RADIUS + plan.toolpath.radius_mm;
    let climb = (l[n - 1].centre.x - l[0].centre.x) / length;
    let row = |k: usize| {
        let (s_mm, phi) = (l[k].s_mm, slope * l[k].s_mm);
        let around = |order: i32| {
            let size = rho * slope.powi(order);
            let (sin, cos) = phi.sin_cos();
            match order {
                1 => [climb, -sin * size, cos * size],
                2 => [0.0, -cos * size, -sin * size],
                _ => [0.0, sin * size, -cos * size],
            }
        };
        let (sin, cos) = (wave * s_mm).sin_cos();
        let theta = [slope + swing_rad * wave * cos, -swing_rad * wave * wave * sin, -swing_rad * wave.powi(3) * cos];
        let way = match (k + 1 == n, k % per_piece) {
            (true, _) => Way::Straight,
            (false, 0) => Way::Piece,
            _ => Way::Within,
        };
        CurveRow { s_mm, centre: [1, 2, 3].map(around), theta, way }
    };
    let rows = (0..n).map(row).collect();
    plan.schedule.theta = l.iter().map(|l| from + slope * l.s_mm + swing_rad * (wave * l.s_mm).sin()).collect();
    plan.motion = motion(&plan.toolpath, &plan.schedule.theta);
    plan.curve = Some(ProgrammedCurve { rows, ..ProgrammedCurve::default() });
    plan
}

fn channel(theta: &[f64]) -> Channel {
    let row = |t: &f64| {
        // A ripple of the walls, so that the channel and its monotone hull differ.
        let ripple = 0.3 * (7.0 * t).sin();
        ChannelRow {
            theta_min: t - WIDTH_RAD + ripple,
            theta_max: t + WIDTH_RAD + ripple,
            hull_min: t - WIDTH_RAD + 0.3,
            hull_max: t + WIDTH_RAD - 0.3,
            tangent_min: t - 1.2,
            tangent_max: t + 1.2,
            binds_min: Binding::Part { tool: ToolPart::Taper, face: 0, triangle: 3 },
            binds_max: Binding::ContactAngle,
        }
    };
    Channel {
        tolerance_rad: 1e-5,
        rows: theta.iter().map(row).collect(),
        narrowest_row: theta.len() / 3,
        chains: 1,
        proven_at: Vec::new(),
        sweep: Default::default(),
    }
}

fn schedule(theta: &[f64], ds: f64) -> Schedule {
    let last = theta.len() - 1;
    Schedule {
        kind: ScheduleKind::Piecewise,
        theta: theta.to_vec(),
        pieces: Vec::new(),
        key_points: vec![[0.0, theta[0]], [last as f64 * ds, theta[last]]],
        reversals: 0,
        peak_rate: (theta[1] - theta[0]) / ds,
        peak_acceleration: 0.0,
        quality: crate::artifact::schedule::Quality::default(),
        rates: Vec::new(),
        spread: 1.0,
    }
}

/// Axis positions on the demo machine at a feed of 20 mm/s.
fn motion(path: &Toolpath, theta: &[f64]) -> AxisMotion {
    let (feed, machine, gauge) = (20.0, Machine::demo().unwrap(), tool().length_mm());
    let position: AxisRows =
        path.locations.iter().zip(theta).map(|(l, t)| machine.inverse(&l.centre, *t, B_RAD, gauge)).collect();
    let start = path.locations[0].s_mm;
    let t_s: Vec<f64> = path.locations.iter().map(|l| (l.s_mm - start) / feed).collect();
    let velocity = differences(&position, &t_s);
    let acceleration = differences(&velocity, &t_s);
    let jerk = differences(&acceleration, &t_s);
    let time_s = *t_s.last().unwrap();
    AxisMotion { feed: vec![feed; t_s.len()], position, velocity, acceleration, jerk, time_s, t_s }
}

fn differences(rows: &AxisRows, t: &[f64]) -> AxisRows {
    (0..rows.len())
        .map(|i| {
            let (lo, hi) = (i.saturating_sub(1), (i + 1).min(rows.len() - 1));
            Axes::from_fn(rows.axes(), |k| (rows[hi][k] - rows[lo][k]) / (t[hi] - t[lo]))
        })
        .collect()
}

/// A report of two passed checks.
pub fn report() -> CheckReport {
    let check = |id: CheckId, worst, limit: f64| Check {
        quantity: format!("worst {id}"),
        id,
        worst,
        limit,
        unit: "mm".into(),
        passed: worst <= limit,
        row: Some(7),
        turn: Some(0),
        point_mm: Some([1.0, 2.0, 3.0]),
        note: "made up".into(),
    };
    CheckReport {
        checks: vec![check(CheckId::Gouge, 0.0005, 0.003), check(CheckId::Scallop, 0.0101, 0.0105)],
        scallop_max_mm: 0.0101,
        scallop_p99_mm: 0.0100,
        scallop_p95_mm: 0.0099,
        scallop_p50_mm: 0.0095,
        scallop_p05_mm: 0.0090,
        scallop_samples: 1000,
        uncut_samples: 0,
        uncut_area_mm2: 0.0,
        uncut_height_mm: 0.0,
        uncut: Vec::new(),
        uncut_cell_mm2: 0.0,
        scallop: Vec::new(),
        ridges: Vec::new(),
        ridge_max_mm: 0.0101,
        ridge_p99_mm: 0.0100,
        ridge_p50_mm: 0.0098,
        ridge_p05_mm: 0.0095,
        limit: crate::artifact::report::LimitFigures {
            area_mm2: 600.0,
            path_length_mm: 1040.0,
            limit_length_mm: 1000.0,
            ratio: 1.04,
            source: crate::artifact::report::LimitSource::Curvature,
            ratio_by_ridges: 1.04,
            ridge_p05_mm: 0.0096,
            ridge_p50_mm: 0.0098,
            ridge_p95_mm: 0.0099,
            ridge_p99_mm: 0.0100,
            ridge_max_mm: 0.0101,
        },
        gouge_mm: 0.0005,
        clearance_mm: 2.0,
        turning: None,
    }
}

/// Elliptic sections, 40 × 16 mm, with made-up altered points.
pub fn sections() -> Vec<Section> {
    let n = 90;
    let one = |x_mm: f64| {
        let points_mm: Vec<[f64; 2]> = (0..n)
            .map(|i| {
                let (s, c) = (f64::from(i) * std::f64::consts::TAU / f64::from(n)).sin_cos();
                [20.0 * c, (7.0 + 0.05 * x_mm) * s]
            })
            .collect();
        let mut s_mm = vec![0.0];
        for w in points_mm.windows(2) {
            s_mm.push(s_mm.last().unwrap() + (w[1][0] - w[0][0]).hypot(w[1][1] - w[0][1]));
        }
        let length_mm = s_mm.last().unwrap() + 0.6;
        SectionLoop {
            curvature_per_mm: vec![0.05; points_mm.len()],
            length_mm,
            area_mm2: 502.0,
            altered_points: vec![AlteredPoint { s_mm: s_mm[12], point_mm: points_mm[12], into_concave: true }],
            leading_edge_s_mm: 0.0,
            trailing_edge_s_mm: 0.5 * length_mm,
            side_after_leading_edge: Side::Suction,
            chord_mm: 40.0,
            thickness_mm: 16.0,
            fit_error_mm: 0.001,
            off_part_mm: 0.0,
            points_mm,
            s_mm,
        }
    };
    [20.0, 30.0, 40.0].map(|x_mm| Section { x_mm, loops: vec![one(x_mm)] }).into()
}

/// Radius of the hub of [`plates`], mm.
pub const HUB_RADIUS: f64 = 40.0;
/// From where to where that hub goes along z, the rotor axis, mm.
pub const HUB_Z: [f64; 2] = [-30.0, 30.0];
/// From where to where its blades go, mm.
pub const PLATES_Z: [f64; 2] = [-15.0, 15.0];

/// A wheel of exact faces: a round hub with plates along the rotor axis for blades, each twice as
/// thick as `half_mm`.
pub fn plates(blades: u32, half_mm: f64) -> (Blade, Wheel) {
    let length = HUB_Z[1] - HUB_Z[0];
    let mut faces = vec![
        shapes::cylinder(HUB_RADIUS, length),
        shapes::disc(HUB_RADIUS, 0.0, false),
        shapes::disc(HUB_RADIUS, length, true),
    ];
    let [z0, z1] = PLATES_Z.map(|z| z - HUB_Z[0]);
    let (r0, r1) = (HUB_RADIUS - 5.0, HUB_RADIUS + 20.0);
    for k in 0..blades {
        let (s, c) = (std::f64::consts::TAU * f64::from(k) / f64::from(blades)).sin_cos();
        let at = |r: f64, t: f64, z: f64| [r * c - t * s, r * s + t * c, z];
        let t = half_mm;
        faces.extend([
            shapes::patch([at(r0, t, z0), at(r0, t, z1), at(r1, t, z1), at(r1, t, z0)]),
            shapes::patch([at(r0, -t, z0), at(r1, -t, z0), at(r1, -t, z1), at(r0, -t, z1)]),
            shapes::patch([at(r0, -t, z0), at(r0, t, z0), at(r1, t, z0), at(r1, -t, z0)]),
            shapes::patch([at(r0, -t, z1), at(r1, -t, z1), at(r1, t, z1), at(r0, t, z1)]),
            shapes::patch([at(r1, -t, z0), at(r1, t, z0), at(r1, t, z1), at(r1, -t, z1)]),
            shapes::patch([at(r0, -t, z0), at(r0, -t, z1), at(r0, t, z1), at(r0, t, z0)]),
        ]);
    }
    let named = |surface| Face { name: "".into(), kind: SurfaceKind::BSpline, surface, reversed: false, loops: vec![] };
    let brep = Brep { faces: faces.into_iter().map(named).collect(), edges: vec![] };
    let brep = brep.moved(&Rigid::translation(0.0, 0.0, HUB_Z[0]));
    let model = ModelWheel { axis: Vector::z(), through: Point::origin(), blades, whole: true };
    let blade = Blade {
        name: "plates".into(),
        part: Part::from_brep(brep, 0.02, &Silent).unwrap(),
        model_from_blade: Rigid::identity(),
        regions: Regions::at_heights([r0, r1], [HUB_RADIUS, r1], Some(HUB_RADIUS)),
        wheel: Some(model),
        ..blade()
    };
    (blade, Wheel { axis: Vector::z_axis(), origin: Point::origin(), blades })
}

/// Blades of the [`impeller`].
pub const IMPELLER_BLADES: u32 = 9;

/// Places along it.
const IMPELLER_ALONG: usize = 56;

/// Contours of hub (0) and tips (1) of the [`impeller`] at a share of their length: along the rotor
/// axis z, radius; mm. Quarters of ellipses, from along the axis to across it.
pub fn impeller_contour(which: usize, t: f64) -> [f64; 2] {
    let (s, c) = (std::f64::consts::FRAC_PI_2 * t).sin_cos();
    let [along, across] = [[40.0, 46.0], [34.0, 30.0]][which];
    [40.0 - along * s, 60.0 - across * c]
}

/// An impeller in facets, rotor axis z: a round hub, and blades of the same thickness all the way
/// that wind round it by an angle. They reach a little into the hub, and are bodies of their own.
pub fn impeller() -> Mesh {
    let mut mesh = impeller_hub();
    for blade in 0..IMPELLER_BLADES {
        add_impeller_blade(&mut mesh, std::f64::consts::TAU * f64::from(blade) / f64::from(IMPELLER_BLADES));
    }
    mesh
}

/// The hub of [`impeller`].
pub fn impeller_hub() -> Mesh {
    const ROUND: u32 = 240;
    let mut mesh = Mesh::default();
    let profile: Vec<[f64; 2]> = [[-8.0, 1e-3], [-8.0, 60.0]]
        .into_iter()
        .chain((0..=IMPELLER_ALONG).rev().map(|k| impeller_contour(0, k as f64 / IMPELLER_ALONG as f64)))
        .chain([[46.0, 14.0], [46.0, 1e-3]])
        .collect();
    let ring = |[z, r]: &[f64; 2]| {
        let at = |k: u32| (std::f64::consts::TAU * f64::from(k) / f64::from(ROUND)).sin_cos();
        (0..ROUND).map(at).map(|(s, c)| Point::new(r * c, r * s, *z)).collect()
    };
    add_tube(&mut mesh, &profile.iter().map(ring).collect::<Vec<_>>());
    mesh
}

/// One sector of [`impeller`]: the blade at 0 with its share of the hub, whose sides wind as the
/// blade does.
pub fn impeller_sector() -> Mesh {
    const ROUND: usize = 26;
    let mut mesh = Mesh::default();
    let n = IMPELLER_ALONG;
    // Along the hub, and a line beside the rotor axis under it.
    let outer = |k: usize| match k {
        0 => (0.0, [46.0, 14.0]),
        k if k == n + 2 => (1.0, [-8.0, 60.0]),
        k => ((k - 1) as f64 / n as f64, impeller_contour(0, (k - 1) as f64 / n as f64)),
    };
    let line = |j: usize| -> Vec<Point> {
        let share = j as f64 / ROUND as f64 - 0.5;
        let place = |k: usize, inner: bool| {
            let (winds, [z, r]) = outer(k);
            let angle = winds + share * std::f64::consts::TAU / f64::from(IMPELLER_BLADES);
            let r = if inner { 1e-3 } else { r };
            Point::new(r * angle.cos(), r * angle.sin(), z)
        };
        (0..n + 3).map(|k| place(k, false)).chain((0..n + 3).rev().map(|k| place(k, true))).collect()
    };
    let lines: Vec<Vec<Point>> = (0..=ROUND).map(line).collect();
    add_tube(&mut mesh, &lines);
    // Its two sides.
    let (count, last) = (2 * (n as u32 + 3), ROUND as u32 * 2 * (n as u32 + 3));
    for k in 0..n as u32 + 2 {
        let [a, b, c, d] = [k, k + 1, count - 2 - k, count - 1 - k];
        mesh.triangles.extend([[a, c, b], [a, d, c]]);
        mesh.triangles.extend([[a, b, c], [a, c, d]].map(|t| t.map(|p| last + p)));
    }
    add_impeller_blade(&mut mesh, 0.0);
    mesh
}

/// Adds facets between rings of as many points.
pub fn add_tube(mesh: &mut Mesh, rings: &[Vec<Point>]) {
    let (first, n) = (mesh.points.len() as u32, rings[0].len() as u32);
    mesh.points.extend(rings.iter().flatten());
    for r in 0..rings.len() as u32 - 1 {
        for k in 0..n {
            let [a, b] = [k, (k + 1) % n].map(|k| first + r * n + k);
            mesh.triangles.extend([[a, b, b + n], [a, b + n, a + n]]);
        }
    }
}

/// Adds a blade of [`impeller`] that begins at an angle.
pub fn add_impeller_blade(mesh: &mut Mesh, turn: f64) {
    let place = |t: f64, share: f64, side: f64| {
        let [foot, head] = [0, 1].map(|which| impeller_contour(which, t));
        let [z, r] = [0, 1].map(|k| foot[k] + (head[k] - foot[k]) * share);
        // Blunt at both ends.
        let thin = (1.0 - (2.0 * t - 1.0).abs().powi(6)).max(0.0).sqrt();
        let angle = turn + t + side * thin / r;
        Point::new(r * angle.cos(), r * angle.sin(), z)
    };
    let at = |k: usize| k as f64 / IMPELLER_ALONG as f64;
    let section = |share: f64| -> Vec<Point> {
        let there = (0..IMPELLER_ALONG).map(|k| place(at(k), share, -1.0));
        there.chain((0..IMPELLER_ALONG).rev().map(|k| place(at(k + 1), share, 1.0))).collect()
    };
    let shares = [-0.03, 0.0, 0.125, 0.25, 0.375, 0.5, 0.625, 0.75, 0.875, 1.0];
    let mut rings: Vec<Vec<Point>> = shares.map(section).to_vec();
    // Closed along the middle of its thickness.
    for (to, share) in [(0, shares[0]), (rings.len() + 1, 1.0)] {
        let flat = (0..2 * IMPELLER_ALONG).map(|k| if k <= IMPELLER_ALONG { k } else { 2 * IMPELLER_ALONG - k });
        let middle = flat.map(|k| place(at(k), share, 0.0));
        rings.insert(to, middle.collect());
    }
    add_tube(mesh, &rings);
}
