//! The channel against the number of triangles, and against general collision queries.
//!
//! Part: a twisted blade with an elliptic section on a platform. Path: 100,000 cutter locations on
//! 60 turns of a helix. Tool: ball, taper, shank and two holder stages. Three figures for the
//! channel: all free intervals at every location to 0.01°; the whole channel, with every move
//! between locations proven; each with the index of the part. Peers find the two ends of the
//! interval that we name by steps of 5° and bisection to 0.01°: with parry3d-f64's generic
//! intersection test of the mesh with convex shapes, and with an exact test of frusta against
//! triangles with a good bound over parry3d-f64's tree. They are run on a few locations and scaled.
//!
//! `cargo bench --bench channel -- quick`: fewer triangles and locations; `-- 200000`: that many
//! triangles alone, no peers.
#![allow(missing_docs, clippy::print_stdout, clippy::unwrap_used)]

use std::f64::consts::TAU;
use std::time::Instant;

use bladewright::artifact::blade::{Diagnosis, Unit};
use bladewright::artifact::region::Regions;
use bladewright::artifact::toolpath::{CutterLocation, PathKind, Toolpath, Turn};
use bladewright::artifact::{Blade, Cone, Cones};
use bladewright::channel::{ChannelOptions, FreeInterval, Surroundings, intervals, plan_among};
use bladewright::error::EndReason;
use bladewright::geometry::mesh::Mesh;
use bladewright::geometry::part::Part;
use bladewright::geometry::{Point, Rigid, Vector};
use bladewright::observe::Silent;
use bladewright::tool::{HolderStage, Segment, Tool, axis};
use parry3d_f64::math::{Pose, Rotation, Vector as PVector};
use parry3d_f64::partitioning::TraversalAction;
use parry3d_f64::query::intersection_test;
use parry3d_f64::shape::{ConvexPolyhedron, Shape, TriMesh};

const RADIUS_MM: f64 = 4.0;
const HEIGHT_MM: f64 = 80.0;
const TURNS: usize = 60;
/// Steps of the peers' search over θ, and where their bisection ends, degrees.
const STEP_DEG: f64 = 5.0;
const END_DEG: f64 = 0.01;

/// Point of the blade at height `x` and parameter `t`, in radians.
fn surface(x: f64, t: f64) -> Point {
    let (s, c) = t.sin_cos();
    let (sk, ck) = (0.008 * x).sin_cos();
    let (y, z) = (20.0 * c, 6.0 * s);
    Point::new(x, ck * y - sk * z, sk * y + ck * z)
}

fn normal(x: f64, t: f64) -> Vector {
    let e = 1e-5;
    let (along, round) = (surface(x + e, t) - surface(x - e, t), surface(x, t + e) - surface(x, t - e));
    round.cross(&along).normalize()
}

/// About `count` triangles: half of them on the blade, half on the platform's top.
fn part(count: usize) -> Mesh {
    let mut mesh = Mesh::default();
    let around = ((count as f64 / 4.0 * 1.1).sqrt() as u32).max(8);
    let mut patch = |n: [u32; 2], at: &dyn Fn(f64, f64) -> Point| {
        let base = mesh.points.len() as u32;
        for j in 0..=n[1] {
            for i in 0..=n[0] {
                mesh.points.push(at(f64::from(i) / f64::from(n[0]), f64::from(j) / f64::from(n[1])));
            }
        }
        for j in 0..n[1] {
            for i in 0..n[0] {
                let a = base + j * (n[0] + 1) + i;
                mesh.triangles.extend([[a, a + 1, a + n[0] + 2], [a, a + n[0] + 2, a + n[0] + 1]]);
            }
        }
    };
    patch([around, around], &|u, v| surface(HEIGHT_MM * v, TAU * u));
    patch([around, around], &|u, v| Point::new(0.0, 70.0 * u - 35.0, 50.0 * v - 25.0));
    mesh
}

fn blade(mesh: Mesh) -> Blade {
    let x = [0.0, HEIGHT_MM];
    Blade {
        name: "twisted".into(),
        unit: Unit::Mm,
        part: Part::from_mesh(mesh),
        model_from_blade: Rigid::identity(),
        regions: Regions::at_heights(x, x, Some(0.0)),
        wheel: None,
        diagnosis: Diagnosis::default(),
    }
}

/// The path of a ball or a corner down the blade to a height.
fn helix(count: usize, corner_mm: f64, down_to_mm: f64) -> Toolpath {
    let per_turn = count / TURNS;
    let mut locations: Vec<CutterLocation> = Vec::with_capacity(count);
    let mut turns: Vec<Turn> = Vec::new();
    let (mut s_mm, mut from) = (0.0, 0.0);
    for i in 0..count {
        let (x, t) = (30.0 - (30.0 - down_to_mm) * i as f64 / count as f64, TAU * i as f64 / per_turn as f64);
        let (contact, normal) = (surface(x, t), normal(x, t));
        let centre = contact + normal * corner_mm;
        s_mm += locations.last().map_or(0.0, |l: &CutterLocation| (centre - l.centre).norm());
        if i % per_turn == 0 && i / per_turn < TURNS {
            if let Some(last) = turns.last_mut() {
                last.length_mm = s_mm - from;
            }
            turns.push(Turn { first: i, count: 0, length_mm: 0.0 });
            from = s_mm;
        }
        let turn = (turns.len() - 1) as u32;
        turns.last_mut().unwrap().count += 1;
        locations.push(CutterLocation { turn, turn_s_mm: s_mm - from, s_mm, centre, contact, normal });
    }
    turns.last_mut().unwrap().length_mm = s_mm - from;
    Toolpath {
        kind: PathKind::ConstantHeight,
        stock_mm: 0.0,
        radius_mm: corner_mm,
        disc_radius_mm: 0.0,
        scallop_mm: 0.01,
        chord_mm: 0.001,
        region_x_mm: [30.0, down_to_mm],
        end_reason: EndReason::Region,
        planned_scallop_mm: 0.01,
        cones: Cones::about_blade(5f64.to_radians()),
        axis_turning: None,
        turns,
        locations,
    }
}

/// Cones whose axes are the blade axis and whose references are turned anyhow from place to place,
/// written about an axis that is turned by a hundred-thousandth of a degree, so that no short cut
/// is taken; or that wobble about the blade axis, once in 90 locations.
fn turned(count: usize, wobbling: bool) -> Cones {
    let one = |k: usize| {
        let (lean, at) = (5f64.to_radians(), TAU * (k % 90) as f64 / 90.0);
        let off = if wobbling { 3f64.to_radians() } else { 1e-5f64.to_radians() };
        let axis = Vector::new(
            off.cos(),
            if wobbling { off.sin() * at.cos() } else { off.sin() },
            if wobbling { off.sin() * at.sin() } else { 0.0 },
        );
        let by = (k * 7919 % 360) as f64;
        Cone::new(axis, Vector::new(0.1, by.to_radians().cos(), by.to_radians().sin()), lean).unwrap()
    };
    Cones::along((0..count).map(one).collect())
}

fn tool() -> Tool {
    Tool {
        radius_mm: RADIUS_MM,
        corner_radius_mm: None,
        taper_deg: 3.0,
        shank_radius_mm: 6.0,
        stickout_mm: 45.0,
        holder: vec![
            HolderStage { radius_mm: 12.0, length_mm: 20.0 },
            HolderStage { radius_mm: 18.0, length_mm: 40.0 },
        ],
    }
}

/// A cutter of radius 8 with a corner of 2, no wider above its bottom than at it.
fn cutter() -> Tool {
    Tool { radius_mm: 8.0, corner_radius_mm: Some(2.0), taper_deg: 0.0, shank_radius_mm: 8.0, ..tool() }
}

/// Something that tells whether the tool touches the part at an angle.
type Hits<'a> = &'a dyn Fn(&Point, f64) -> bool;

/// The ends of the free interval around `start`, rad.
fn bisected(centre: &Point, start: f64, hits: Hits) -> [f64; 2] {
    [-1.0, 1.0].map(|sense| {
        let step = STEP_DEG.to_radians();
        let mut free = start;
        while !hits(centre, free + sense * step) && (free - start).abs() < TAU / 2.0 {
            free += sense * step;
        }
        let mut taken = free + sense * step;
        while (taken - free).abs() > END_DEG.to_radians() {
            let middle = 0.5 * (free + taken);
            if hits(centre, middle) { taken = middle } else { free = middle }
        }
        free
    })
}

fn pvector(v: &Vector) -> PVector {
    PVector::new(v.x, v.y, v.z)
}

/// A frustum as a convex polyhedron along y about its own middle, and the height of that middle.
fn polyhedron(s: &Segment) -> (ConvexPolyhedron, f64) {
    const SIDES: usize = 48;
    let middle = 0.5 * (s.z0 + s.z1);
    let points: Vec<PVector> = [(s.z0, s.r0), (s.z1, s.r1)]
        .iter()
        .flat_map(|&(z, r)| {
            (0..SIDES).map(move |k| {
                let (sin, cos) = (TAU * k as f64 / SIDES as f64).sin_cos();
                PVector::new(r * cos, z - middle, r * sin)
            })
        })
        .collect();
    (ConvexPolyhedron::from_convex_hull(&points).unwrap(), middle)
}

/// Distance from the frustum; a negative depth inside its shell is enough for a bound.
fn frustum_distance(s: &Segment, z: f64, r: f64) -> f64 {
    let slant = (s.z1 - s.z0).hypot(s.r1 - s.r0);
    let (c, k) = ((s.z1 - s.z0) / slant, (s.r1 - s.r0) / slant);
    let (along, off) = ((z - s.z0) * c + (r - s.r0) * k, (r - s.r0) * c - (z - s.z0) * k);
    let to = |z1: f64, r1: f64| (z - z1).hypot((r - r1).max(0.0));
    if off > 0.0 && (0.0..=slant).contains(&along) {
        off
    } else if z < s.z0 {
        to(s.z0, s.r0)
    } else if z > s.z1 {
        to(s.z1, s.r1)
    } else if off > 0.0 {
        if along < 0.0 { to(s.z0, s.r0) } else { to(s.z1, s.r1) }
    } else {
        off.max(s.z0 - z).max(z - s.z1)
    }
}

/// A triangle meets the frusta: halving with the distance at the middle as a bound.
fn triangle_hits(segments: &[Segment], centre: &Point, a: &Vector, corners: [Point; 3]) -> bool {
    let mut open = vec![corners];
    while let Some([p, q, r]) = open.pop() {
        let m = Point::from((p.coords + q.coords + r.coords) / 3.0);
        let radius = [p, q, r].iter().map(|c| (c - m).norm()).fold(0.0, f64::max);
        let v = m - centre;
        let z = v.dot(a);
        let d = segments.iter().map(|s| frustum_distance(s, z, (v - a * z).norm())).fold(f64::INFINITY, f64::min);
        if d <= 0.0 {
            return true;
        }
        if d <= radius && radius > 1e-4 {
            let (x, y, w) = (nalgebra::center(&p, &q), nalgebra::center(&q, &r), nalgebra::center(&r, &p));
            open.extend([[p, x, w], [x, q, y], [w, y, r], [x, y, w]]);
        }
    }
    false
}

fn frustum_hits(blade: &Blade, segments: &[Segment], b_rad: f64, centre: &Point, theta: f64) -> bool {
    let a = axis(b_rad, theta);
    let mut hit = false;
    blade.part.bvh.tree.traverse(|node| {
        if hit {
            return TraversalAction::EarlyExit;
        }
        let (lo, hi) = (node.mins(), node.maxs());
        let middle = Point::new(0.5 * (lo.x + hi.x), 0.5 * (lo.y + hi.y), 0.5 * (lo.z + hi.z));
        let half = 0.5 * (hi - lo).length();
        let v = middle - centre;
        let z = v.dot(&a);
        let r = (v - a * z).norm();
        if segments.iter().all(|s| frustum_distance(s, z, r) > half) {
            return TraversalAction::Prune;
        }
        if let Some(t) = node.leaf_data() {
            hit = triangle_hits(segments, centre, &a, blade.part.mesh.corners(t as usize));
        }
        TraversalAction::Continue
    });
    hit
}

/// Runs a peer at some locations; seconds of work for each, and how far its ends are from ours at
/// most, degrees.
fn peer(path: &Toolpath, ours: &[Vec<FreeInterval>], count: usize, hits: Hits) -> (f64, f64) {
    let mut off: f64 = 0.0;
    let start = worked_s();
    for k in 0..count {
        let i = (k * 7919 + 13) % path.locations.len();
        let widest = ours[i].iter().max_by(|a, b| (a.theta_max - a.theta_min).total_cmp(&(b.theta_max - b.theta_min)));
        let Some(f) = widest else { continue };
        let [lo, hi] = bisected(&path.locations[i].centre, 0.5 * (f.theta_min + f.theta_max), hits);
        off = off.max((lo - f.theta_min).abs()).max((hi - f.theta_max).abs());
    }
    ((worked_s() - start) / count as f64, off.to_degrees())
}

/// Seconds that all threads have worked so far, where the system tells (Linux): on a busy machine
/// they say more than the clock.
fn worked_s() -> f64 {
    let stat = std::fs::read_to_string("/proc/self/stat").unwrap_or_default();
    // User and system time are the 14th and 15th field, in hundredths; the second may hold blanks
    // and ends with a bracket.
    let fields: Vec<f64> =
        stat.rsplit(')').next().unwrap_or("").split_whitespace().map(|f| f.parse().unwrap_or(0.0)).collect();
    fields.iter().skip(11).take(2).sum::<f64>() / 100.0
}

fn main() {
    let quick = std::env::args().any(|a| a == "quick");
    let count = if quick { 12_000 } else { 100_000 };
    let alone: Vec<usize> = std::env::args().filter_map(|a| a.parse().ok()).collect();
    let sizes: &[usize] = if !alone.is_empty() {
        &alone
    } else if quick {
        &[10_000, 50_000]
    } else {
        &[10_000, 100_000, 200_000, 1_000_000]
    };
    let options = ChannelOptions::default()
        .with(|s| (s.clearance_mm, s.holder_clearance_mm, s.contact_angle_max_deg) = (0.0, 0.0, 180.0));
    let (tool, path) = (tool(), helix(count, RADIUS_MM, 8.0));
    // A cutter with a corner looks at fewer places: each takes many times as long.
    let corners = (cutter(), helix(count / 10, 2.0, 12.0));
    let leaning = options.clone().with(|s| (s.contact_angle_min_deg, s.contact_angle_max_deg) = (3.0, 20.0));
    println!("{count} locations, {} threads", rayon::current_num_threads());
    for &size in sizes {
        let blade = blade(part(size));
        let (start, worked) = (Instant::now(), worked_s());
        let around = Surroundings::new(&blade, &[], tool.radius_mm).unwrap();
        let (index, index_worked) = (start.elapsed().as_secs_f64(), worked_s() - worked);
        let start = Instant::now();
        let worked = worked_s();
        let ours = intervals(&around, &tool, &path, &options, &Silent).unwrap();
        let (all, worked) = (start.elapsed().as_secs_f64(), worked_s() - worked);
        let all_worked = worked;
        let start = Instant::now();
        let whole = plan_among(&around, &tool, &path, &options, &Silent);
        let proven = start.elapsed().as_secs_f64();
        let per = |s: f64| 1e6 * s / count as f64;
        println!(
            "{:>8} triangles: index {index:.2} s, {index_worked:.2} s of all threads; intervals {all:.2} s = {:.1} µs a location, \
             {worked:.2} s of all threads; with the chain and what `plan` does {proven:.2} s = {:.1} µs",
            blade.part.mesh.triangles.len(),
            per(all),
            per(proven)
        );
        for (what, cones) in [("turned in space", turned(count, false)), ("wobbling by 3°", turned(count, true))] {
            let path = path.clone().with_cones(cones);
            let worked = worked_s();
            let _ = intervals(&around, &tool, &path, &options, &Silent).unwrap();
            let other = worked_s() - worked;
            println!("         cones {what}: {other:.2} s of all threads, {:.2} times as much", other / all_worked);
        }
        let (of, places) = (&corners.0, corners.1.locations.len());
        let around_cutter = Surroundings::new(&blade, &[], of.radius_mm).unwrap();
        let worked = worked_s();
        let theirs = intervals(&around_cutter, of, &corners.1, &leaning, &Silent).unwrap();
        let each = (worked_s() - worked) / places as f64;
        println!(
            "         R 8 with a corner of 2: {:.0} µs of work a location = {:.0} locations a second and core; \
             {} of {places} have room",
            1e6 * each,
            1.0 / each,
            theirs.iter().filter(|layer| !layer.is_empty()).count()
        );
        match &whole {
            Ok(c) => {
                let given = |f: &dyn Fn(usize) -> f64| {
                    let mut all: Vec<f64> = (0..ours.len()).filter(|&i| ours[i].len() == 1).map(f).collect();
                    all.sort_by(f64::total_cmp);
                    (all[all.len() / 2].to_degrees(), all.last().unwrap().to_degrees())
                };
                let (median, most) = given(&|i| {
                    (c.rows[i].theta_min - ours[i][0].theta_min).max(ours[i][0].theta_max - c.rows[i].theta_max)
                });
                println!(
                    "         walls of the motion inside the intervals by {median:.4}° (median), {most:.4}° (most)"
                );
            }
            Err(e) => println!("         {e}"),
        }
        if alone.is_empty() && size == sizes[sizes.len() - 1].min(200_000) {
            let (segments, b) = (tool.segments(), path.cone(0).lean_rad);
            let bound = |c: &Point, t: f64| frustum_hits(&blade, &segments, b, c, t);
            let (each, off) = peer(&path, &ours, if quick { 10 } else { 40 }, &bound);
            let times = each * count as f64 / worked;
            println!(
                "         exact frustum test: {each:.4} s of work a location, {times:.0} times as much; ends at most {off:.4}° apart"
            );
            let m = &blade.part.mesh;
            let mesh =
                TriMesh::new(m.points.iter().map(|p| pvector(&p.coords)).collect(), m.triangles.clone()).unwrap();
            let shapes: Vec<(ConvexPolyhedron, f64)> = segments.iter().map(polyhedron).collect();
            let generic = |c: &Point, t: f64| {
                let a = axis(b, t);
                shapes.iter().any(|(shape, z)| {
                    let rotation = Rotation::from_rotation_arc(PVector::new(0.0, 1.0, 0.0), pvector(&a));
                    let pose = Pose::from_parts(pvector(&(c.coords + a * *z)), rotation);
                    intersection_test(&Pose::IDENTITY, &mesh, &pose, shape as &dyn Shape).unwrap().intersecting
                })
            };
            let (each, off) = peer(&path, &ours, if quick { 2 } else { 6 }, &generic);
            let times = each * count as f64 / worked;
            println!(
                "         parry3d-f64's test: {each:.4} s of work a location, {times:.0} times as much; ends at most {off:.4}° apart"
            );
        }
    }
}
