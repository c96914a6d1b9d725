#![allow(clippy::unwrap_used)]
use super::*;
use crate::geometry::brep::{Brep, Face, FaceName, SurfaceKind};
use crate::geometry::exact::tests::{block, can};
use crate::geometry::mesh::Mesh;
use crate::geometry::nurbs::NurbsSurface;
use crate::geometry::nurbs::shapes::{cone, loft, sphere, torus};
use crate::observe::Silent;

/// What the search tells places apart by in these tests, mm.
const TOLERANCE_MM: f64 = 1e-5;

fn sheet(surface: NurbsSurface) -> Part {
    let face =
        Face { name: FaceName::Numbered(1), kind: SurfaceKind::BSpline, surface, reversed: false, loops: vec![] };
    Part::from_brep(Brep { faces: vec![face], edges: vec![] }, 0.05, &Silent).unwrap()
}

/// Edges, corners, poles, hollows and flat faces, exact and as triangles.
fn parts() -> Vec<Part> {
    let exact = [
        Part::from_brep(block(Vector::new(9.0, 4.0, 6.0)), 0.05, &Silent).unwrap(),
        Part::from_brep(can(5.0, 3.0), 0.05, &Silent).unwrap(),
        sheet(sphere(4.0)),
        sheet(cone(4.0, 7.0)),
        sheet(torus(9.0, 3.0)),
        sheet(loft()),
    ];
    let meshes: Vec<Part> = exact.iter().map(|p| Part::from_mesh(p.mesh.clone())).collect();
    exact.into_iter().chain(meshes).collect()
}

/// The least of the part's distances from points spread over the disc.
fn brute(part: &Part, disc: &Disc, rings: u32, round: u32) -> f64 {
    let e = any_across(&disc.axis);
    let f = disc.axis.cross(&e);
    let places = (0..=rings).flat_map(|i| (0..round).map(move |k| (i, k)));
    let distance = |(i, k): (u32, u32)| {
        let (s, c) = (std::f64::consts::TAU * f64::from(k) / f64::from(round)).sin_cos();
        let x = disc.centre + (e * c + f * s) * (disc.radius_mm * f64::from(i) / f64::from(rings));
        part.closest(&x, f64::INFINITY).unwrap().distance_mm
    };
    places.map(distance).fold(f64::INFINITY, f64::min)
}

/// The search beside brute force: it finds no less than is there, and no point of the disc sampled
/// is nearer than what it has found by more than it promises.
fn agrees(part: &Part, search: &mut DiscSearch, disc: &Disc, rings: u32, round: u32) -> Result<(), String> {
    let found = search.closest(disc, f64::INFINITY, TOLERANCE_MM).ok_or("nothing found")?;
    let dense = brute(part, disc, rings, round);
    let spacing = disc.radius_mm * (1.0 / f64::from(rings) + std::f64::consts::TAU / f64::from(round));
    let off = (found.at.point - found.on_disc).norm();
    if (off - found.distance_mm).abs() > 1e-9 || disc.distance_mm(&found.on_disc) > 1e-9 {
        return Err(format!("{disc:?}: {off} between the points, {found:?}"));
    }
    if found.distance_mm > dense + TOLERANCE_MM || found.least_mm > found.distance_mm + 1e-12 {
        return Err(format!("{disc:?}: missed {dense}, {found:?}"));
    }
    // Beside edges the faces are known to 1e-4 mm.
    if found.least_mm < found.distance_mm - 3e-4 || dense > found.distance_mm + spacing {
        return Err(format!("{disc:?}: too little known, {dense}, {found:?}"));
    }
    Ok(())
}

/// Uneven numbers, the same in every run.
struct Dice(u64);

impl Dice {
    /// Between −1 and 1.
    fn roll(&mut self) -> f64 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 11) as f64 / (1u64 << 52) as f64 - 1.0
    }
    fn vector(&mut self) -> Vector {
        Vector::from_fn(|_, _| self.roll())
    }
    /// A disc about a part of this size, near it as often as not.
    fn disc(&mut self, part: &Part) -> Option<Disc> {
        let b = crate::geometry::Aabb::around(&part.mesh.points)?;
        let half = (b.max - b.min) * 0.5;
        let near = nalgebra::center(&b.min, &b.max) + half.component_mul(&self.vector()) * 1.4;
        let axis = self.vector().try_normalize(0.1)?;
        Some(Disc { centre: near, axis, radius_mm: 3.0 * self.roll().abs() + 1e-3 })
    }
}

fn random_cases(count: usize, seed: u64, [rings, round]: [u32; 2]) {
    use rayon::prelude::*;
    let parts = parts();
    let of_one = |(k, part): (usize, &Part)| {
        let (mut dice, mut search) = (Dice(seed + k as u64), DiscSearch::new(part));
        let discs = (0..count.div_ceil(parts.len())).filter_map(|_| dice.disc(part)).collect::<Vec<_>>();
        let failures: Vec<String> =
            discs.iter().filter_map(|disc| agrees(part, &mut search, disc, rings, round).err()).collect();
        (discs.len(), failures)
    };
    let all: Vec<(usize, Vec<String>)> = parts.par_iter().enumerate().map(of_one).collect();
    let looked: usize = all.iter().map(|a| a.0).sum();
    let failures: Vec<&String> = all.iter().flat_map(|a| &a.1).collect();
    assert!(looked > 9 * count / 10, "{looked}");
    assert!(failures.is_empty(), "{} of {looked}: {:?}", failures.len(), &failures[..failures.len().min(5)]);
}

#[test]
fn nothing_is_missed() {
    random_cases(600, 7, [3, 40]);
}

/// As above, for long.
#[test]
#[ignore = "takes minutes"]
fn nothing_is_missed_in_100_000_cases() {
    random_cases(100_000, 11, [3, 40]);
}

#[test]
fn a_disc_of_no_radius_is_a_ball() {
    for part in &parts() {
        let (mut search, mut dice) = (DiscSearch::new(part), Dice(3));
        for _ in 0..40 {
            let q = Point::from(dice.vector() * 9.0);
            let disc = Disc { centre: q, axis: Vector::z(), radius_mm: 0.0 };
            let (found, ball) = (search.closest(&disc, 20.0, 1e-3), part.closest(&q, 20.0));
            assert_eq!(
                found.map(|f| (f.at.point, f.distance_mm, f.least_mm, f.on_disc)),
                ball.map(|b| (b.point, b.distance_mm, b.distance_mm, q))
            );
            // Nor does anything jump on the way there.
            let small = Disc { radius_mm: 1e-9, axis: Vector::new(0.6, 0.0, 0.8), ..disc };
            let d = |n: Option<NearDisc>| n.map_or(f64::NAN, |n| n.distance_mm);
            let (a, b) = (d(search.closest(&small, 50.0, 1e-6)), part.closest(&q, 50.0).unwrap().distance_mm);
            assert!((a - b).abs() < 2e-9, "{a} {b}");
        }
    }
}

#[test]
fn caps_and_discs_that_are_none() {
    let part = Part::from_brep(block(Vector::new(9.0, 4.0, 6.0)), 0.05, &Silent).unwrap();
    let mut search = DiscSearch::new(&part);
    let over = Disc { centre: Point::new(4.0, 2.0, 9.0), axis: Vector::new(0.6, 0.0, 0.8), radius_mm: 2.0 };
    // The rim hangs 2 · 0.6 below the middle.
    let found = search.closest(&over, f64::INFINITY, 1e-5).unwrap();
    assert!((found.distance_mm - 1.8).abs() < 1e-9 && found.distance_mm - found.least_mm <= 1e-5, "{found:?}");
    assert!((found.at.normal - Vector::z()).norm() < 1e-9 && part.face_name(found.at.face).contains("face"));
    assert!(search.closest(&over, 1.801, 1e-5).is_some() && search.closest(&over, 1.799, 1e-5).is_none());
    for bad in [f64::NAN, f64::INFINITY, -1.0] {
        assert!(search.closest(&Disc { radius_mm: bad, ..over }, 9.0, 1e-5).is_none(), "{bad}");
        assert!(search.closest(&Disc { axis: over.axis * bad, radius_mm: bad, ..over }, 9.0, 1e-5).is_none());
    }
    assert!(search.closest(&over, f64::NAN, 1e-5).is_none());
    let empty = Part::from_mesh(Mesh::default());
    assert!(DiscSearch::new(&empty).closest(&over, f64::INFINITY, 1e-5).is_none());
}

/// Surface that only the file of the part has is nearest where it is.
#[test]
fn what_was_published_otherwise_counts() {
    let part = Part::from_brep(block(Vector::new(9.0, 4.0, 6.0)), 0.05, &Silent).unwrap();
    let corners = [[3.0, 1.0, 6.2], [5.0, 1.0, 6.2], [4.0, 3.0, 6.2]].map(Point::from).to_vec();
    let rib = Mesh { points: corners, triangles: vec![[0, 1, 2]], face_of: vec![0], ..Mesh::default() };
    let part = part.with_published(Part::from_mesh(rib), vec![None]);
    let over = Disc { centre: Point::new(4.0, 2.0, 9.0), axis: Vector::z(), radius_mm: 1.0 };
    let found = DiscSearch::new(&part).closest(&over, 10.0, 1e-5).unwrap();
    assert!((found.distance_mm - 2.8).abs() < 1e-9, "{found:?}");
}

#[test]
fn over_a_sphere_in_closed_form() {
    let part = sheet(sphere(4.0));
    let (mut search, mut dice, mut looked) = (DiscSearch::new(&part), Dice(5), 0);
    while looked < 200 {
        let centre = Point::from(dice.vector() * 9.0);
        let Some(axis) = dice.vector().try_normalize(0.1) else { continue };
        let disc = Disc { centre, axis, radius_mm: 5.0 * dice.roll().abs() + 0.1 };
        let expected = disc.distance_mm(&Point::origin()) - 4.0;
        if expected <= 0.0 {
            continue;
        }
        looked += 1;
        let found = search.closest(&disc, f64::INFINITY, 1e-5).unwrap();
        assert!((found.distance_mm - expected).abs() < 1e-9, "{} {expected}", found.distance_mm);
    }
}
