//! Constant scallop on meshes of round bodies, straight along their axis where a closed form is
//! compared with. Curved profiles are compared with their closed forms on exact faces, in
//! `tests/closed_forms.rs`: facets a micrometre off would show in a scallop of ten.
#![allow(clippy::unwrap_used)]

use super::bounds::Bounds;
use super::front::{Across, By, Front};
use super::level::{LevelSet, Touch};
use super::tests::{lofted, turned};
use super::*;
use crate::artifact::region::{Boundary, Extent, Patch};
use crate::artifact::toolpath::CutterLocation;
use crate::error::EndReason;
use crate::geometry::Vector;
use crate::geometry::allowance::Allowed;
use crate::geometry::mesh::Mesh;
use crate::geometry::part::Part;
use crate::geometry::triangle::closest_on_segment;
use crate::observe::Silent;
use crate::tool::stepover::flat_stepover_mm;

const R: f64 = 4.0;
const H: f64 = 0.01;

fn options(start: f64, end: Option<f64>) -> PathOptions {
    PathOptions { extent: Extent::heights(Some(start), end), ..PathOptions::new(R, H) }
        .with(|s| s.kind = PathKind::ConstantScallop)
}

/// Heights from 0 to `top` in steps of `step`.
fn rows(top: f64, step: f64) -> Vec<f64> {
    (0..=(top / step).round() as usize).map(|i| i as f64 * step).collect()
}

/// Locations of each turn.
fn by_turn(path: &Toolpath) -> Vec<&[CutterLocation]> {
    path.turns.iter().map(|t| &path.locations[t.first..t.first + t.count]).collect()
}

/// Locations of the last time round the blade axis.
fn last_round(path: &Toolpath) -> impl Iterator<Item = &CutterLocation> {
    let mut round = 0.0;
    let mut last: Option<&CutterLocation> = None;
    path.locations.iter().rev().take_while(move |l| {
        let across = |l: &CutterLocation| Vector::new(0.0, l.centre.y, l.centre.z);
        round += last.map_or(0.0, |b| across(b).angle(&across(l)));
        last = Some(l);
        round < std::f64::consts::TAU
    })
}

/// Distances of the locations of a turn to the polyline of the next.
fn distances(turn: &[CutterLocation], next: &[CutterLocation]) -> Vec<f64> {
    let to = |q: &Point| {
        next.windows(2)
            .map(|w| (q - closest_on_segment(&w[0].centre, &w[1].centre, q)).norm())
            .fold(f64::INFINITY, f64::min)
    };
    let inner = 5..turn.len() - 5;
    turn[inner].iter().map(|l| to(&l.centre)).collect()
}

/// Distance of two ball centres over a part of radius `r` across the passes (positive convex) that
/// leaves [`H`], by bisection of the two-ball formula.
fn closed_form(r: f64) -> f64 {
    let rho = r + R;
    let height = |d: f64| {
        let alpha = (d / (2.0 * rho.abs())).asin();
        let root = (R * R - (rho * alpha.sin()).powi(2)).sqrt();
        (rho.abs() * alpha.cos() - root.copysign(r) - r.abs()).abs()
    };
    let (mut low, mut high) = (0.0, 2.0 * rho.abs().min(R) * 0.7);
    for _ in 0..60 {
        let middle = 0.5 * (low + high);
        if height(middle) < H { low = middle } else { high = middle }
    }
    low
}

/// Every distance between inner turns with heights in `within` is the closed form's for radius `r`
/// within 0.25 %, which is 0.5 % of the scallop.
fn assert_constant(path: &Toolpath, r: f64, within: [f64; 2]) {
    let want = closed_form(r);
    let turns = by_turn(path);
    let mut seen = 0;
    for k in 1..turns.len() - 3 {
        let heights = turns[k].iter().chain(turns[k + 1]).map(|l| l.centre.x);
        if !heights.clone().all(|x| (within[0]..within[1]).contains(&x)) {
            continue;
        }
        for d in distances(turns[k], turns[k + 1]) {
            assert!((d / want - 1.0).abs() < 0.0025, "turn {k}: {d}, closed form {want}");
            seen += 1;
        }
    }
    assert!(seen > 500, "{seen} places");
}

#[test]
fn cylinder_has_the_flat_stepover_and_closes_onto_its_end() {
    let blade = turned(1500, &rows(60.0, 2.0), |_, s, c| [10.0 * c, 10.0 * s]);
    let path = plan(&blade, &options(20.0, Some(8.0)), &Silent).unwrap();
    let d = flat_stepover_mm(R, H);
    let turns = by_turn(&path);
    // The first turn is the lowest one that is nowhere under the start.
    assert!(turns[0].iter().all(|l| (20.0 - 1e-3 * d..20.0 + 2.0 * d).contains(&l.centre.x)));
    assert!(turns[1].iter().any(|l| l.centre.x < 20.0));
    assert!(last_round(&path).all(|l| (l.centre.x - 8.0).abs() < 1e-3 * d));
    // Whole turns from the end until the start is passed, and one along the end.
    assert!((turns.len() as f64 - (12.0 / d).ceil() - 2.0).abs() <= 1.0, "{} turns", turns.len());
    assert_constant(&path, 1e7, [8.0 + d, 21.0]);
    assert!((path.planned_scallop_mm / H - 1.0).abs() < 0.005, "{}", path.planned_scallop_mm);
    let length: f64 = path.turns[2..turns.len() - 2].iter().map(|t| t.length_mm).sum();
    let around = (std::f64::consts::TAU * 14.0).hypot(d) * (turns.len() - 4) as f64;
    assert!((length / around - 1.0).abs() < 0.01, "{length}, closed form {around}");
}

#[test]
fn cone_has_the_flat_stepover_along_its_wall() {
    let slope = 15f64.to_radians().tan();
    let blade = turned(1500, &rows(60.0, 2.0), |x, s, c| [(20.0 - x * slope) * c, (20.0 - x * slope) * s]);
    let path = plan(&blade, &options(20.0, Some(10.0)), &Silent).unwrap();
    assert_constant(&path, 1e7, [10.5, 21.0]);
}

/// A round bar whose foot is a fillet of radius `fillet`.
fn filleted(n: usize, fillet: f64) -> Blade {
    let mut heights: Vec<f64> =
        (0..=200).map(|i| fillet * (1.0 - (std::f64::consts::FRAC_PI_2 * f64::from(200 - i) / 200.0).sin())).collect();
    heights.extend([fillet + 2.0, fillet + 8.0, fillet + 20.0, 40.0]);
    let radius = move |x: f64| {
        let under = (fillet - x).max(0.0);
        10.0 + fillet - (fillet * fillet - under * under).max(0.0).sqrt()
    };
    turned(n, &heights, move |x, s, c| [radius(x) * c, radius(x) * s])
}

#[test]
fn wall_into_fillet_keeps_the_scallop() {
    let blade = filleted(200, 6.0);
    let path = plan(&blade, &options(14.0, None), &Silent).unwrap();
    assert!(path.end_reason.to_string().contains("leans"), "{}", path.end_reason);
    assert!(path.planned_scallop_mm < 1.02 * H, "{}", path.planned_scallop_mm);
    let end = path.locations.last().unwrap();
    assert!((end.normal.x.asin().to_degrees() - 60.0).abs() < 1.0, "{}", end.normal.x);
}

#[test]
fn sharp_corner_is_closed_onto() {
    let blade = turned(1000, &rows(60.0, 2.0), |_, s, c| [10.0 * c, 10.0 * s]);
    let path = plan(&blade, &options(10.0, None), &Silent).unwrap();
    assert!(path.end_reason.to_string().contains("corner"), "{}", path.end_reason);
    assert!(last_round(&path).all(|l| (l.centre.x - R).abs() < 1e-4));
    assert!(path.locations.iter().all(|l| l.centre.x > R - 1e-5));
    assert!(path.planned_scallop_mm < 1.005 * H, "{}", path.planned_scallop_mm);
}

#[test]
fn a_leaning_platform_that_is_named_ends_the_path_where_the_ball_comes_to_it() {
    // A round bar on a cone that leans by 40° from square: less than what ends a path by itself.
    let (sin, cos) = 40f64.to_radians().sin_cos();
    let n = 1500;
    let ring = |x: f64, r: f64| {
        let at = |i: usize| (std::f64::consts::TAU * i as f64 / n as f64).sin_cos();
        (0..n).map(at).map(|(s, c)| Point::new(x, r * c, r * s)).collect::<Vec<_>>()
    };
    let foot = -20.0 * sin / cos;
    let mut rings = vec![ring(foot - 5.0, 30.0), ring(foot, 30.0), ring(0.0, 10.0)];
    rings.extend((1..=30).map(|k| ring(2.0 * f64::from(k), 10.0)));
    let mut blade = lofted(&rings);
    let mut mesh = blade.part.mesh.clone();
    mesh.face_of = (0..mesh.triangles.len()).map(|t| u32::from(mesh.corners(t).iter().all(|p| p.x < 1e-9))).collect();
    blade.part = Part::from_mesh(mesh);
    let extent = Extent { ends: vec![Boundary::Faces(vec![false, true])], ..Extent::heights(Some(14.0), None) };
    let ended = PathOptions { extent, ..options(14.0, None) }.with(|s| s.max_lean_deg = 86.0);
    let path = plan(&blade, &ended, &Silent).unwrap();
    assert!(path.end_reason.to_string().contains("comes to face 2"), "{}", path.end_reason);
    // The ball touches wall and cone at once.
    let corner = R * (1.0 - sin) / cos;
    for l in last_round(&path) {
        assert!((l.centre.x - corner).abs() < 1e-3, "{} instead of {corner}", l.centre);
    }
    for l in path.locations.iter().filter(|l| l.centre.x > corner + 1e-3) {
        assert!((l.contact.y.hypot(l.contact.z) - 10.0).abs() < 1e-3, "{} at {}", l.contact, l.centre);
    }
    assert!(path.planned_scallop_mm < 1.005 * H, "{}", path.planned_scallop_mm);
    let error = plan(&blade, &ended.with(|s| (s.kind, s.max_lean_deg) = (PathKind::ConstantHeight, 60.0)), &Silent)
        .unwrap_err();
    assert!(error.message.contains("region.end_faces"), "{}", error.message);
}

#[test]
fn a_leaning_shroud_that_is_named_begins_the_path_where_the_ball_comes_to_it() {
    // A round bar from a platform to the cone of a shroud that slants along y.
    let n = 600;
    let ring = |x: f64, r: f64, slant: f64| {
        let at = |i: usize| (std::f64::consts::TAU * i as f64 / n as f64).sin_cos();
        (0..n).map(at).map(|(s, c)| Point::new(x + slant * c, r * c, r * s)).collect::<Vec<_>>()
    };
    let mut rings = vec![ring(-8.0, 30.0, 0.0), ring(0.0, 30.0, 0.0), ring(0.0, 10.0, 0.0)];
    rings.extend((1..=40).map(|k| ring(f64::from(k), 10.0, f64::from(k) / 20.0)));
    rings.extend([ring(55.0, 30.0, 6.0), ring(60.0, 30.0, 0.0)]);
    let mut blade = lofted(&rings);
    let mut mesh = blade.part.mesh.clone();
    let is_shroud = |p: &Point| p.y.hypot(p.z) > 10.1 && p.x > 20.0;
    let face = |t: usize| u32::from(mesh.corners(t).iter().any(is_shroud));
    mesh.face_of = (0..mesh.triangles.len()).map(face).collect();
    let of_shroud: Vec<[u32; 3]> =
        (0..mesh.triangles.len()).filter(|t| mesh.face_of[*t] == 1).map(|t| mesh.triangles[t]).collect();
    let shroud = Part::from_mesh(Mesh { triangles: of_shroud, ..mesh.clone() });
    blade.part = Part::from_mesh(mesh);
    blade.regions.list[0].patch = Patch::Faces(vec![0]);
    let extent = Extent { start: Some(Boundary::Faces(vec![false, true])), ..Extent::heights(None, Some(10.0)) };
    let begun = PathOptions { extent, ..options(14.0, None) }.with(|s| s.max_lean_deg = 86.0);
    let path = plan(&blade, &begun, &Silent).unwrap();
    assert_eq!(path.end_reason, EndReason::Region);
    let turns = by_turn(&path);
    let off_mm = |l: &CutterLocation| shroud.closest(&l.centre, 3.0 * R).map_or(f64::INFINITY, |c| c.distance_mm - R);
    let first = turns[0].iter().map(off_mm).fold(0.0, f64::max);
    assert!(first < 0.01, "the first turn is {first} mm off the shroud");
    let heights = || turns[0].iter().map(|l| l.centre.x);
    let slant = heights().fold(0.0, f64::max) - heights().fold(f64::INFINITY, f64::min);
    assert!(slant > 3.0, "{slant}");
    assert!(path.locations.iter().all(|l| off_mm(l) > -1e-3));
    assert!(path.planned_scallop_mm < 1.02 * H, "{}", path.planned_scallop_mm);
    let error = plan(&blade, &begun.with(|s| (s.kind, s.max_lean_deg) = (PathKind::ConstantHeight, 60.0)), &Silent)
        .unwrap_err();
    assert!(error.message.contains("begins at faces"), "{}", error.message);
}

#[test]
fn an_upright_sharp_edge_that_turns_go_over_aslant_ends_nothing() {
    // A square bar that leans over a corner: two of its edges lie across the turns' way.
    let blade = turned(400, &rows(60.0, 1.0), |x, s, c| {
        let r = 10.0 / c.abs().max(s.abs());
        [r * c + 0.5 * x, r * s + 0.5 * x]
    });
    let path = plan(&blade, &options(40.0, None), &Silent).unwrap();
    // It goes on to the platform that the bar stands on.
    assert!(path.end_reason.to_string().contains("corner"), "{}", path.end_reason);
    assert!(path.planned_scallop_mm < 1.05 * H, "{}", path.planned_scallop_mm);
}

#[test]
fn contacts_of_the_first_ring_are_level_though_a_thin_blade_leans() {
    // An oval with edges of 0.04 mm radius that leans over flat: ball centres of one height touch
    // its sides 2 mm apart.
    let blade = turned(400, &rows(60.0, 1.0), |x, s, c| [20.0 * c, 0.9 * s + 0.3 * x]);
    let o = options(30.0, None);
    let level = LevelSet {
        part: Allowed::new(&blade.part, 0.0),
        along: Along::BLADE,
        radius_mm: R,
        inclined: None,
        rim: None,
        lowest_mm: f64::NEG_INFINITY,
    };
    let how = rings::tracing(&o);
    let ring = rings::first_ring(&blade, &level, &o, 30.0, &how).unwrap().touches;
    let bounds =
        Bounds { along: Along::BLADE, x_mm: [0.0, 60.0], max_sin_lean: 1.0, ends: &[], rim: None, disc_fits: false };
    let across = Across { level: &level, bounds, min_step_mm: how.min_step_mm };
    let flat_mm = flat_stepover_mm(R, H);
    let front = Front {
        across,
        scallop_mm: H,
        flat_mm,
        step_mm: 1.0,
        round_edges_mm: 1.0,
        round_mm: 100.0,
        back: 1.0,
        evens_ways: false,
        is_path: false,
        by: By::Ridges,
    };
    let extent = |touches: &[Touch]| {
        let x = touches.iter().map(|t| t.contact.x);
        x.clone().fold(f64::NEG_INFINITY, f64::max) - x.fold(f64::INFINITY, f64::min)
    };
    assert!(extent(&ring) > 2.0, "{}", extent(&ring));
    let moved = front.at_one_contact_height(&ring).unwrap();
    assert_eq!(moved.len(), ring.len());
    assert!(extent(&moved) < 0.01 * flat_mm, "{}", extent(&moved));
    assert!(moved.iter().all(|t| ((t.centre - t.contact).norm() - R).abs() < 1e-5));
}

#[test]
fn where_a_side_alone_comes_to_the_end_it_is_drawn_along_the_turn_that_is_there() {
    // A round bar that stands on a fillet of 12 mm and a block on one side, and goes on down on the
    // other.
    let block = |c: f64| {
        let u = ((c + 0.2) / 0.8).clamp(0.0, 1.0);
        u * u * (3.0 - 2.0 * u)
    };
    let fillet = |x: f64| 12.0 - (144.0 - (12.0 - x.clamp(0.0, 12.0)).powi(2)).max(0.0).sqrt();
    let heights: Vec<f64> =
        rows(36.0, 0.5).iter().map(|x| x - 24.0).chain(rows(40.0, 4.0).iter().map(|x| x + 16.0)).collect();
    let blade = turned(400, &heights, |x, s, c| {
        let r = 10.0 + block(c) * fillet(x);
        [r * c, r * s]
    });
    let path = plan(&blade, &options(20.0, None), &Silent).unwrap();
    let turns = by_turn(&path);
    let d = flat_stepover_mm(R, H);
    let end = turns[turns.len() - 1];
    assert!(end.iter().any(|l| l.normal.x > 0.8), "the end runs over the block");
    // In the fillet centres lie as near to one another as 0.7 of what they do on the flat; where
    // turns waited, they would lie on each other.
    let all: Vec<f64> = (1..turns.len() - 2).flat_map(|k| distances(turns[k], turns[k + 1])).collect();
    let near = all.iter().filter(|a| **a < 0.5 * d).count();
    assert!(near * 50 < all.len(), "{near} of {} places nearer to the next turn than half of {d}", all.len());
    assert!(path.planned_scallop_mm < 1.05 * H, "{}", path.planned_scallop_mm);
}

#[test]
fn sharp_edge_is_run_along() {
    // A round bar that ends in a sharp edge, hardly askew.
    let foot = |c: f64| 6.0 + 0.002 * 10.0 * c;
    let n = 600;
    let ring = |height: &dyn Fn(f64) -> f64| {
        let at = |i: usize| (std::f64::consts::TAU * i as f64 / n as f64).sin_cos();
        (0..n).map(at).map(|(s, c)| Point::new(height(c), 10.0 * c, 10.0 * s)).collect::<Vec<_>>()
    };
    let rings: Vec<Vec<Point>> =
        (0..=54).map(|k| ring(&|c| foot(c) + (60.0 - foot(c)) * f64::from(k) / 54.0)).collect();
    let blade = lofted(&rings);
    let path = plan(&blade, &options(20.0, None), &Silent).unwrap();
    assert!(path.end_reason.to_string().contains("edge"), "{}", path.end_reason);
    for l in last_round(&path) {
        let on_edge = foot(l.contact.y / l.contact.y.hypot(l.contact.z));
        assert!((l.contact.x - on_edge).abs() < 0.01, "contact {} at the edge {on_edge}", l.contact);
        // The ball has not begun to roll.
        assert!(l.normal.x.abs() < 0.01, "{}", l.normal);
    }
    // No turn but the last two comes near another: nothing is cut twice.
    let turns = by_turn(&path);
    for k in 1..turns.len() - 2 {
        assert!(distances(turns[k], turns[k + 1]).iter().all(|d| (d / closed_form(1e7) - 1.0).abs() < 0.05));
    }
    assert!(path.planned_scallop_mm < 1.01 * H, "{}", path.planned_scallop_mm);
}

#[test]
fn leaning_oval_is_the_same_turned_and_mirrored() {
    // An egg whose middle moves with the height, mirrored in z and turned about x.
    let section = |mirror: f64, turn: f64| {
        move |x: f64, s: f64, c: f64| {
            let (y, z) = (14.0 * c + 0.15 * x, mirror * (7.0 * s * (1.0 + 0.2 * c) + 0.05 * x));
            let (st, ct) = turn.sin_cos();
            [ct * y - st * z, st * y + ct * z]
        }
    };
    let laid = |mirror: f64, turn: f64| {
        let build = section(mirror, turn);
        // A mirrored outline is run through the other way, so that it still winds
        // counter-clockwise.
        let blade = turned(900, &rows(60.0, 2.0), |x, s, c| build(x, mirror * s, c));
        plan(&blade, &options(20.0, Some(10.0)), &Silent).unwrap()
    };
    let (plain, turned, mirrored) = (laid(1.0, 0.0), laid(1.0, 0.7), laid(-1.0, 0.0));
    for other in [&turned, &mirrored] {
        let length = |p: &Toolpath| p.locations.last().unwrap().s_mm;
        assert!((length(&plain) / length(other) - 1.0).abs() < 0.01, "{} {}", length(&plain), length(other));
        assert!((plain.planned_scallop_mm - other.planned_scallop_mm).abs() < 0.01 * H);
        assert!(plain.turns.len().abs_diff(other.turns.len()) <= 1);
    }
    assert!((plain.planned_scallop_mm / H - 1.0).abs() < 0.01, "{}", plain.planned_scallop_mm);
}

#[test]
fn same_turns_on_one_and_two_threads() {
    let blade = filleted(120, 6.0);
    let run = |threads| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
        pool.install(|| plan(&blade, &options(9.0, None), &Silent).unwrap())
    };
    assert_eq!(run(1), run(2));
}
