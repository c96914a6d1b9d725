//! Synthetic blades, paths round them, and an oracle that shares nothing with the search.

use std::f64::consts::TAU;

use crate::artifact::blade::{Diagnosis, Unit};
use crate::artifact::region::Regions;
use crate::artifact::toolpath::{CutterLocation, Toolpath, Turn};
use crate::artifact::{Blade, Cone, Cones};
use crate::error::EndReason;
use crate::geometry::mesh::Mesh;
use crate::geometry::part::Part;
use crate::geometry::{Point, Rigid, Vector};
use crate::tool::{HolderStage, Tool};

pub fn tool(radius_mm: f64, taper_deg: f64) -> Tool {
    Tool {
        radius_mm,
        corner_radius_mm: None,
        taper_deg,
        shank_radius_mm: if taper_deg > 0.0 { 1.5 * radius_mm } else { radius_mm },
        stickout_mm: 8.0 * radius_mm,
        holder: vec![HolderStage { radius_mm: 3.0 * radius_mm, length_mm: 6.0 * radius_mm }],
    }
}

pub fn blade(mesh: Mesh) -> Blade {
    Blade {
        name: "synthetic".into(),
        unit: Unit::Mm,
        part: Part::from_mesh(mesh),
        model_from_blade: Rigid::identity(),
        regions: Regions::at_heights([-20.0, 60.0], [0.0, 60.0], Some(0.0)),
        wheel: None,
        diagnosis: Diagnosis::default(),
    }
}

/// A prism over a closed profile (counter-clockwise), with flat ends.
pub fn prism(profile: &[[f64; 2]], x: [f64; 2], face: u32, mesh: &mut Mesh) {
    let (n, base) = (profile.len() as u32, mesh.points.len() as u32);
    for h in x {
        mesh.points.extend(profile.iter().map(|p| Point::new(h, p[0], p[1])));
    }
    let mean = profile.iter().fold([0.0, 0.0], |m, p| [m[0] + p[0] / n as f64, m[1] + p[1] / n as f64]);
    let (low, high) = (mesh.points.len() as u32, mesh.points.len() as u32 + 1);
    mesh.points.extend(x.map(|h| Point::new(h, mean[0], mean[1])));
    for i in 0..n {
        let j = (i + 1) % n;
        let (a, b, c, d) = (base + i, base + j, base + n + i, base + n + j);
        mesh.triangles.extend([[a, b, d], [a, d, c], [low, b, a], [high, c, d]]);
        mesh.face_of.extend([face, face, face + 1, face + 1]);
    }
}

/// A closed curve with its outward normal at parameter 0..1.
pub type Outline<'a> = &'a dyn Fn(f64) -> ([f64; 2], [f64; 2]);

pub fn ellipse(a: f64, b: f64) -> impl Fn(f64) -> ([f64; 2], [f64; 2]) {
    move |t| {
        let (s, c) = (TAU * t).sin_cos();
        let n = [b * c, a * s];
        let l = n[0].hypot(n[1]);
        ([a * c, b * s], [n[0] / l, n[1] / l])
    }
}

/// A bent strip with round ends: middle line a circular arc of radius `bend` over `sweep` rad,
/// thickness `2 h`. One side is concave.
pub fn banana(bend: f64, sweep: f64, h: f64) -> impl Fn(f64) -> ([f64; 2], [f64; 2]) {
    let lengths = [(bend + h) * sweep, std::f64::consts::PI * h, (bend - h) * sweep, std::f64::consts::PI * h];
    let whole: f64 = lengths.iter().sum();
    let half = 0.5 * sweep;
    let at = move |r: f64, phi: f64| [r * phi.sin(), bend - r * phi.cos()];
    move |t| {
        let mut s = t.rem_euclid(1.0) * whole;
        // Outer side: convex, its normals point away from the centre of the bend.
        if s < lengths[0] {
            let phi = -half + s / (bend + h);
            return (at(bend + h, phi), [phi.sin(), -phi.cos()]);
        }
        s -= lengths[0];
        if s < lengths[1] {
            let (c, e) = (at(bend, half), half - TAU / 4.0 + s / h);
            return ([c[0] + h * e.cos(), c[1] + h * e.sin()], [e.cos(), e.sin()]);
        }
        s -= lengths[1];
        if s < lengths[2] {
            let phi = half - s / (bend - h);
            return (at(bend - h, phi), [-phi.sin(), phi.cos()]);
        }
        s -= lengths[2];
        let (c, e) = (at(bend, -half), -half + TAU / 4.0 + s / h);
        ([c[0] + h * e.cos(), c[1] + h * e.sin()], [e.cos(), e.sin()])
    }
}

/// The outline as a prism of height 60 on a platform of the given half width.
pub fn on_platform(outline: Outline, sides: usize, half_width: f64) -> Blade {
    let mut mesh = Mesh::default();
    let profile: Vec<[f64; 2]> = (0..sides).map(|i| outline(i as f64 / sides as f64).0).collect();
    prism(&profile, [-1.0, 60.0], 0, &mut mesh);
    let w = half_width;
    prism(&[[-w, -w], [w, -w], [w, w], [-w, w]], [-20.0, 0.0], 2, &mut mesh);
    blade(mesh)
}

/// A helix of ball centres round the prism over the outline.
pub fn helix(outline: Outline, radius_mm: f64, per_turn: usize, turns: usize, from_x: f64, pitch: f64) -> Toolpath {
    let mut locations: Vec<CutterLocation> = Vec::new();
    let mut starts = Vec::new();
    let (mut s, mut turn_s) = (0.0, 0.0);
    for i in 0..per_turn * turns {
        let (p, n) = outline(i as f64 / per_turn as f64);
        let x = from_x + pitch * i as f64 / per_turn as f64;
        let normal = Vector::new(0.0, n[0], n[1]);
        let contact = Point::new(x, p[0], p[1]);
        let centre = contact + normal * radius_mm;
        let step = locations.last().map_or(0.0, |l| (centre - l.centre).norm());
        s += step;
        turn_s = if i % per_turn == 0 { 0.0 } else { turn_s + step };
        if i % per_turn == 0 {
            starts.push((i, s));
        }
        locations.push(CutterLocation {
            turn: (i / per_turn) as u32,
            turn_s_mm: turn_s,
            s_mm: s,
            centre,
            contact,
            normal,
        });
    }
    let ends = starts.iter().skip(1).map(|t| t.1).chain([s]);
    let turns = starts
        .iter()
        .zip(ends)
        .map(|(&(first, at), end)| Turn { first, count: per_turn, length_mm: end - at })
        .collect();
    Toolpath {
        kind: crate::artifact::toolpath::PathKind::default(),
        stock_mm: 0.0,
        radius_mm,
        disc_radius_mm: 0.0,
        scallop_mm: 0.01,
        chord_mm: 0.01,
        region_x_mm: [from_x, from_x + pitch],
        end_reason: EndReason::Region,
        planned_scallop_mm: 0.01,
        cones: Cones::about_blade(5f64.to_radians()),
        axis_turning: None,
        turns,
        locations,
    }
}

/// Least distance from the mesh to the frusta above the ball, less each one's clearance; negative:
/// too near. The distance from a convex body is convex: two golden section searches, one inside the
/// other, find its least value on a triangle.
pub fn least_margin(mesh: &Mesh, tool: &Tool, clearance: (f64, f64), cone: Cone, centre: &Point, theta: f64) -> f64 {
    let a = cone.tool_axis(theta);
    let mut best = f64::INFINITY;
    for s in tool.segments() {
        let c = if s.part.is_holder() { clearance.1 } else { clearance.0 };
        let margin = |p: Point| {
            let v = p - centre;
            let z = v.dot(&a);
            distance_to_frustum([z, (v - a * z).norm()], [s.z0, s.r0], [s.z1, s.r1]) - c
        };
        for t in 0..mesh.triangles.len() {
            let [p, q, r] = mesh.corners(t);
            let size = (q - p).norm().max((r - p).norm());
            if margin(p) - size > best {
                continue;
            }
            let along = |u: f64| golden(|v| margin(p + (q - p) * (u * (1.0 - v)) + (r - p) * (u * v)));
            best = best.min(golden(along));
        }
    }
    best
}

/// Least value of a convex function over 0..1.
fn golden(f: impl Fn(f64) -> f64) -> f64 {
    let g = 0.5 * (5f64.sqrt() - 1.0);
    let (mut a, mut b) = (0.0, 1.0);
    let (mut x, mut y) = (1.0 - g, g);
    let (mut fx, mut fy) = (f(x), f(y));
    for _ in 0..28 {
        if fx < fy {
            (b, y, fy) = (y, x, fx);
            x = b - g * (b - a);
            fx = f(x);
        } else {
            (a, x, fx) = (x, y, fy);
            y = a + g * (b - a);
            fy = f(y);
        }
    }
    fx.min(fy).min(f(0.0)).min(f(1.0))
}

/// Distance in the (z, r) plane from a point to the trapezium under the side `a`–`b`; 0 inside.
fn distance_to_frustum(p: [f64; 2], a: [f64; 2], b: [f64; 2]) -> f64 {
    let side = a[1] + (b[1] - a[1]) * (p[0] - a[0]) / (b[0] - a[0]);
    if p[0] >= a[0] && p[0] <= b[0] && p[1] <= side {
        return 0.0;
    }
    let to_segment = |a: [f64; 2], b: [f64; 2]| {
        let (d, e) = ([b[0] - a[0], b[1] - a[1]], [p[0] - a[0], p[1] - a[1]]);
        let t = ((d[0] * e[0] + d[1] * e[1]) / (d[0] * d[0] + d[1] * d[1])).clamp(0.0, 1.0);
        (e[0] - t * d[0]).hypot(e[1] - t * d[1])
    };
    to_segment(a, b).min(to_segment([a[0], 0.0], a)).min(to_segment(b, [b[0], 0.0]))
}

/// How deep a point is inside the inflated segments of a tool; negative: outside.
pub fn inside_by(
    segments: &[crate::tool::Segment],
    clearance: (f64, f64),
    cone: Cone,
    centre: &Point,
    theta: f64,
    p: &Point,
) -> f64 {
    let a = cone.tool_axis(theta);
    let v = p - centre;
    let z = v.dot(&a);
    let r = (v - a * z).norm();
    let depth = |s: &crate::tool::Segment| {
        let c = if s.part.is_holder() { clearance.1 } else { clearance.0 };
        c - distance_to_frustum([z, r], [s.z0, s.r0], [s.z1, s.r1])
    };
    segments.iter().map(depth).fold(f64::NEG_INFINITY, f64::max)
}

/// The deepest of many points.
pub fn deepest(
    points: &[Point],
    segments: &[crate::tool::Segment],
    clearance: (f64, f64),
    cone: Cone,
    centre: &Point,
    theta: f64,
) -> f64 {
    points.iter().map(|p| inside_by(segments, clearance, cone, centre, theta, p)).fold(f64::NEG_INFINITY, f64::max)
}
