//! The path against closed forms: round bars of known radius on a platform.
#![allow(clippy::unwrap_used)]

use super::*;
use crate::artifact::blade::{Diagnosis, Unit};
use crate::artifact::region::{Extent, Patch, Region, Regions};
use crate::geometry::mesh::Mesh;
use crate::geometry::part::Part;
use crate::geometry::{Rigid, Vector};
use crate::observe::Silent;

const BAR_RADIUS: f64 = 10.0;
const PLATFORM: f64 = 40.0;

/// A bar `y = R cos φ, z = stretch · R sin φ` from x = 0 to 60 on a disc of radius 40 below it;
/// `bend` moves every section's middle so that the bar leans.
fn bar(n: usize, radius_at: impl Fn(f64) -> f64) -> Blade {
    let heights: Vec<f64> = (0..=30).map(|i| 2.0 * i as f64).collect();
    turned(n, &heights, |x, s, c| [radius_at(x) * c, radius_at(x) * s])
}

/// A body on a disc of radius 40, from its sections at the heights: `y` and `z` from height, sine
/// and cosine.
pub(super) fn turned(n: usize, heights: &[f64], at: impl Fn(f64, f64, f64) -> [f64; 2]) -> Blade {
    let ring = |x: f64, yz: &dyn Fn(f64, f64) -> [f64; 2]| {
        let place = |k: usize| {
            let (s, c) = (k as f64 * std::f64::consts::TAU / n as f64).sin_cos();
            let [y, z] = yz(s, c);
            Point::new(x, y, z)
        };
        (0..n).map(place).collect::<Vec<_>>()
    };
    let disc = |s: f64, c: f64| [PLATFORM * c, PLATFORM * s];
    let mut rings = vec![ring(-8.0, &disc), ring(0.0, &disc)];
    rings.extend(heights.iter().map(|x| ring(*x, &|s, c| at(*x, s, c))));
    lofted(&rings)
}

/// A closed mesh through rings of as many points each, counter-clockwise seen from the tip, capped
/// at both ends.
pub(super) fn lofted(rings: &[Vec<Point>]) -> Blade {
    let n = rings[0].len();
    let mut points = rings.concat();
    let mut triangles = Vec::new();
    for i in 0..rings.len() - 1 {
        for k in 0..n {
            let (a, b) = ((i * n + k) as u32, (i * n + (k + 1) % n) as u32);
            let (c, d) = (a + n as u32, b + n as u32);
            triangles.push([a, b, d]);
            triangles.push([a, d, c]);
        }
    }
    for (row, up) in [(0, false), (rings.len() - 1, true)] {
        let centre = points.len() as u32;
        let sum = rings[row].iter().fold(Vector::zeros(), |s, p| s + p.coords);
        points.push((sum / n as f64).into());
        for k in 0..n {
            let (a, b) = ((row * n + k) as u32, (row * n + (k + 1) % n) as u32);
            triangles.push(if up { [centre, a, b] } else { [centre, b, a] });
        }
    }
    let lowest = points.iter().map(|p| p.x).fold(f64::INFINITY, f64::min);
    let mesh = Mesh { points, triangles, ..Mesh::default() };
    assert!(mesh.volume_mm3() > 0.0);
    Blade {
        name: "bar".into(),
        unit: Unit::Mm,
        part: Part::from_mesh(mesh),
        model_from_blade: Rigid::identity(),
        regions: Regions::at_heights([lowest, 60.0], [0.0, 60.0], Some(0.0)),
        wheel: None,
        diagnosis: Diagnosis::default(),
    }
}

fn options() -> PathOptions {
    PathOptions { extent: Extent::heights(Some(20.0), None), ..PathOptions::new(4.0, 0.01) }
        .with(|s| s.kind = PathKind::ConstantHeight)
}

#[test]
fn round_bar_has_the_flat_stepover_and_ends_where_the_ball_meets_the_platform() {
    let blade = bar(1500, |_| BAR_RADIUS);
    let path = plan(&blade, &options(), &Silent).unwrap();
    // Across the turns the wall is straight: the flat stepover is exact.
    let d = flat_stepover_mm(4.0, 0.01);
    // The last turns close in on the platform and are shorter.
    for turn in path.turns.iter().filter(|t| path.locations[t.first].centre.x > 6.0) {
        let fall = path.locations[turn.first].centre.x - path.locations[turn.first + turn.count].centre.x;
        assert!(fall <= d && fall > 0.95 * d, "pitch {fall}, flat stepover {d}");
    }
    assert!(path.planned_scallop_mm <= 0.01 && path.planned_scallop_mm > 0.0085, "{}", path.planned_scallop_mm);
    assert!((path.region_x_mm[0] - 20.0).abs() < 1e-12);
    assert!((path.region_x_mm[1] - 4.0).abs() < 0.03 * d + 1e-3, "ends at {}", path.region_x_mm[1]);
    for l in &path.locations {
        let rho = l.centre.y.hypot(l.centre.z);
        // 1500 facets stay within 22 nm of the circle.
        assert!((rho - 14.0).abs() < 3e-5, "ball centre at {rho}");
        assert!((l.normal.x).abs() < 1e-6);
        assert!(((l.centre - l.contact).norm() - 4.0).abs() < 2e-6);
    }
    let turn = std::f64::consts::TAU * 14.0;
    assert!((path.turns[2].length_mm - turn.hypot(d)).abs() < 1e-2, "{}", path.turns[2].length_mm);
}

#[test]
fn cone_leans_and_its_pitch_shrinks_with_the_cosine() {
    let slope = 15f64.to_radians();
    let blade = bar(1500, |x| 20.0 - x * slope.tan());
    let path = plan(&blade, &options(), &Silent).unwrap();
    let d = flat_stepover_mm(4.0, 0.01) * slope.cos();
    let turn = &path.turns[2];
    let fall = path.locations[turn.first].centre.x - path.locations[turn.first + turn.count].centre.x;
    assert!(fall <= 1.002 * d && fall > 0.95 * d, "pitch {fall}, closed form {d}");
    assert!(path.locations.iter().filter(|l| l.centre.x > 5.0).all(|l| (l.normal.x - slope.sin()).abs() < 1e-4));
}

#[test]
fn locations_run_round_without_gaps() {
    let blade = bar(300, |_| BAR_RADIUS);
    let path = plan(&blade, &options(), &Silent).unwrap();
    let mut last = 0.0;
    for w in path.locations.windows(2) {
        let step = (w[1].centre - w[0].centre).norm();
        assert!(step > 0.0 && step <= 1.0 + 1e-9 && (w[1].s_mm - w[0].s_mm - step).abs() < 1e-9);
        assert!(ring::wrap(w[1].normal.z.atan2(w[1].normal.y) - w[0].normal.z.atan2(w[0].normal.y)) > 0.0);
        last = w[1].s_mm;
    }
    let lengths: f64 = path.turns.iter().map(|t| t.length_mm).sum();
    assert!((lengths - last).abs() < 1e-9 * last);
    assert_eq!(path.turns.iter().map(|t| t.count).sum::<usize>(), path.locations.len());
}

#[test]
fn same_path_on_one_and_two_threads() {
    let blade = bar(200, |_| BAR_RADIUS);
    let run = |threads| {
        rayon::ThreadPoolBuilder::new()
            .num_threads(threads)
            .build()
            .unwrap()
            .install(|| plan(&blade, &options(), &Silent).unwrap())
    };
    assert_eq!(run(1), run(2));
}

#[test]
fn bad_options_are_named() {
    let blade = bar(60, |_| BAR_RADIUS);
    for (o, word) in [
        (options().with(|s| s.scallop_mm = 0.0), "path.scallop_mm"),
        (options().with(|s| s.scallop_mm = f64::NAN), "path.scallop_mm"),
        (PathOptions { radius_mm: -1.0, ..options() }, "tool.radius_mm"),
        (options().with(|s| s.chord_mm = 0.0), "path.chord_mm"),
        (PathOptions { extent: Extent::heights(Some(500.0), None), ..options() }, "region.start_mm"),
        (PathOptions { extent: Extent::heights(Some(5.0), Some(9.0)), ..options() }, "region.end_mm"),
        (options().with(|s| s.scallop_mm = 3.0), "path.scallop_mm"),
        (PathOptions { radius_mm: 200.0, ..options() }.with(|s| s.scallop_mm = 0.01), "smaller than the tool"),
    ] {
        let e = plan(&blade, &o, &Silent).unwrap_err();
        assert!(e.message.contains(word), "{e}");
    }
}

#[test]
fn concave_entry_is_found_on_a_kidney() {
    use super::level::Touch;
    use super::ring::Ring;
    use crate::geometry::Vector;
    // Azimuth rises, falls by 0.5 rad around the dent, rises again: the entry is the touch before
    // the fall.
    let azimuths = [0.0, 1.0, 2.0, 2.5, 2.8, 2.6, 2.3, 2.6, 3.5, 4.5, 5.5];
    let touches = azimuths
        .iter()
        .enumerate()
        .map(|(i, a): (usize, &f64)| Touch {
            face: 0,
            centre: Point::new(0.0, i as f64, 0.0),
            contact: Point::origin(),
            normal: Vector::new(0.0, a.cos(), a.sin()),
        })
        .collect();
    let ring = Ring::new(Along::BLADE, touches);
    let entries = ring.concave_entries(0.035);
    assert_eq!(entries.len(), 1);
    assert_eq!(entries[0].0, 4);
    assert!((entries[0].1 - 0.5).abs() < 1e-9);
}

#[test]
fn a_path_goes_round_the_contour_of_its_region_and_not_the_nearest_to_the_axis() {
    let one = bar(300, |_| BAR_RADIUS);
    let mut mesh = one.part.mesh.clone();
    let (points, triangles) = (mesh.points.len() as u32, mesh.triangles.len() as u32);
    let aside = Vector::new(0.0, 200.0, 0.0);
    mesh.points.extend(one.part.mesh.points.iter().map(|p| p + aside));
    mesh.triangles.extend(one.part.mesh.triangles.iter().map(|t| t.map(|v| v + points)));
    let mut two = Blade { part: Part::from_mesh(mesh), ..one.clone() };
    let mut airfoil = two.regions.list[0].clone();
    airfoil.patch = Patch::Facets((0..triangles).collect());
    two.regions.list[0] = airfoil.clone();
    two.regions.list.push(Region { patch: Patch::Facets((triangles..2 * triangles).collect()), ..airfoil });
    let round = |region: usize| {
        let extent = Extent { region, ..Extent::heights(Some(20.0), Some(18.0)) };
        plan(&two, &PathOptions { extent, ..options() }, &Silent)
    };
    let (first, second) = (round(0).unwrap(), round(2).unwrap());
    assert_eq!(first.locations.len(), second.locations.len());
    for (a, b) in first.locations.iter().zip(&second.locations) {
        assert!((a.centre + aside - b.centre).norm() < 1e-5, "{} {}", a.centre, b.centre);
    }
    let error = round(3).unwrap_err();
    assert!(error.message.contains("region 3, but the blade has 3"), "{}", error.message);
    let extent = Extent { start: Some(Boundary::Rim(0.0)), ..Extent::default() };
    let error = plan(&two, &PathOptions { extent, ..options() }, &Silent).unwrap_err();
    assert!(error.message.contains("a path begins at a height or at faces"), "{}", error.message);
}

/// A bar and its path, turned together: nothing of a path counts on where the region's axis lies in
/// the blade frame.
#[test]
fn a_region_along_another_axis_has_the_same_path_turned() {
    let blade = turned(300, &(0..=30).map(|i| 2.0 * f64::from(i)).collect::<Vec<_>>(), |x, s, c| {
        [(10.0 + 0.1 * x) * c + 0.05 * x, 6.0 * s * (1.0 + 0.2 * c)]
    });
    let along = Along::of(Vector::new(-0.36, 0.48, 0.8));
    let turn = |p: &Point| Point::from(along.frame(p).vector(p.x, [p.y, p.z]));
    let mut mesh = blade.part.mesh.clone();
    mesh.points.iter_mut().for_each(|p| *p = turn(p));
    let mut other = Blade { part: Part::from_mesh(mesh), ..blade.clone() };
    other.regions.list.iter_mut().for_each(|r| r.along = along);
    for kind in [PathKind::ConstantHeight, PathKind::IsoParametric, PathKind::ConstantScallop] {
        for extent in [Extent::heights(Some(20.0), None), Extent::heights(Some(20.0), Some(12.0))] {
            let o = PathOptions { extent, ..options() }.with(|s| s.kind = kind);
            let [one, two] = [&blade, &other].map(|b| plan(b, &o, &Silent).unwrap());
            let [a, b] = [&one, &two].map(|p| p.locations.last().unwrap());
            assert!((a.s_mm / b.s_mm - 1.0).abs() < 1e-3, "{kind:?}: {} mm, {} mm", a.s_mm, b.s_mm);
            assert!((turn(&a.centre) - b.centre).norm() < 0.05, "{kind:?}: {} {}", turn(&a.centre), b.centre);
            assert!((0..2).all(|k| (one.region_x_mm[k] - two.region_x_mm[k]).abs() < 0.01), "{kind:?}");
            assert!((one.planned_scallop_mm / two.planned_scallop_mm - 1.0).abs() < 0.02, "{kind:?}");
        }
    }
}
