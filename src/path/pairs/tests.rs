//! Rows on a plate: all is known in closed form.
#![allow(clippy::unwrap_used)]

use super::*;
use crate::artifact::blade::{Diagnosis, Unit};
use crate::artifact::region::{Area, Boundary, Patch, Region, Regions};
use crate::error::ErrorKind;
use crate::geometry::exact::tests::block;
use crate::geometry::part::Part;
use crate::geometry::profile::Sides;
use crate::geometry::{Point, Rigid, Vector};
use crate::observe::Silent;

const SIZE: [f64; 3] = [60.0, 40.0, 5.0];
const H: f64 = 0.02;

/// A plate with x along it, its edges at y = 0 and 40, its sides at z = 0 and 5.
fn plate() -> Blade {
    let part = Part::from_brep(block(Vector::from(SIZE)), 0.05, &Silent).unwrap();
    let face = |z: f64| part.closest(&Point::new(30.0, 20.0, z), 100.0).unwrap().face;
    let mut faces = vec![face(-1.0), face(9.0)];
    faces.sort_unstable();
    let edge = |y: f64| vec![Point::new(0.0, y, 2.5), Point::new(60.0, y, 2.5)];
    let sides = Sides { leading_edge_mm: edge(0.0), trailing_edge_mm: edge(40.0), suction_follows_leading: true };
    let [top, foot] = [60.0, 0.0].map(|x| Some(Boundary::Height(x)));
    let airfoil =
        Region { patch: Patch::Faces(faces), sides: Some(sides), ..Region::between(Area::Airfoil, top, foot) };
    Blade {
        name: "plate".into(),
        unit: Unit::Mm,
        part,
        model_from_blade: Rigid::identity(),
        regions: Regions { part_x_mm: [0.0, 60.0], list: vec![airfoil], reasons: vec![] },
        wheel: None,
        diagnosis: Diagnosis::default(),
    }
}

fn options(radius_mm: [f64; 2]) -> PairOptions {
    PairOptions {
        settings: PathSettings { scallop_mm: H, ..PathSettings::default() },
        radius_mm,
        heights_mm: Some([10.0, 50.0]),
        max_angle_rad: 0.7,
        apart_mm: 0.1,
        edges: false,
    }
}

#[test]
fn rows_of_a_plate_are_straight_and_a_flat_stepover_apart() {
    for radii in [[4.0, 4.0], [4.0, 9.0], [6.0, 3.0]] {
        let rows = plan(&plate(), &options(radii), &Silent).unwrap();
        // The smaller ball leaves the higher ridge.
        let step = flat_stepover_mm(f64::min(radii[0], radii[1]), 0.99 * H);
        // Nearer to an edge than half the thickness the ball inside touches that.
        let wide = SIZE[1] - SIZE[2];
        assert!((rows.rows.len() as f64 - wide / step).abs() <= 2.0, "{} rows, {step} mm apart", rows.rows.len());
        for row in &rows.rows {
            let places = &rows.places[row.clone()];
            let y = places[0].contacts[0].contact.y;
            for p in places {
                let [a, b] = p.contacts.map(|c| c.contact);
                assert!((a - b - Vector::z() * (a.z - b.z)).norm() < 1e-6, "{a} {b}");
                assert!((a.y - y).abs() < 1e-5 && ((a.z - b.z).abs() - SIZE[2]).abs() < 1e-6);
                assert!((p.held_radius_mm - 0.5 * SIZE[2]).abs() < 1e-6 && p.angle_rad < 1e-9 && p.apart_mm < 1e-9);
            }
            let (from, to) = (places[0].contacts[0].centre.x, places[places.len() - 1].contacts[0].centre.x);
            assert!((from - 50.0).abs() < 1e-9 && (to - 10.0).abs() < 1e-9, "from the top down");
            // Steps are those of the settings.
            let longest = places.windows(2).map(|w| (w[1].contacts[0].centre - w[0].contacts[0].centre).norm());
            assert!(longest.fold(0.0, f64::max) <= options(radii).settings.max_step_mm + 1e-9);
        }
        let mut apart = rows.rows.windows(2).map(|w| {
            (rows.places[w[1].start].contacts[0].contact.y - rows.places[w[0].start].contacts[0].contact.y).abs()
        });
        assert!(apart.all(|d| (d / step - 1.0).abs() < 0.003), "{step}");
        let binds = usize::from(radii[1] < radii[0]);
        assert!((rows.planned_scallop_mm[binds] / (0.99 * H) - 1.0).abs() < 0.004, "{:?}", rows.planned_scallop_mm);
        let ends = [RowEnd::Elsewhere, RowEnd::Angle];
        assert!(rows.ends.iter().all(|(end, _)| ends.contains(end)), "{:?}", rows.ends);
        let paths = [0, 1].map(|k| rows.toolpath(k, crate::artifact::Cones::about_blade(0.1)));
        for (k, path) in paths.iter().enumerate() {
            assert_eq!((path.turns.len(), path.locations.len()), (rows.rows.len(), rows.places.len()));
            let length: f64 = path.turns.iter().map(|t| t.length_mm).sum();
            assert!((length - rows.length_mm(k)).abs() < 1e-6 && (length - 40.0 * rows.rows.len() as f64).abs() < 1e-6);
        }
    }
}

#[test]
fn the_mirror_image_has_the_mirrored_rows() {
    let (blade, options) = (plate(), options([4.0, 4.0]));
    let rows = plan(&blade, &options, &Silent).unwrap();
    let mirrored = Blade { part: blade.part.mirrored(&Silent).unwrap(), regions: blade.regions.mirrored(), ..blade };
    let image = plan(&mirrored, &options, &Silent).unwrap();
    assert_eq!(rows.rows.len(), image.rows.len());
    // The suction side is run round the other way: the last row is the first.
    let of = |rows: &PairedRows, row: usize| rows.places[rows.rows[row].start].contacts[0].contact;
    for row in 0..rows.rows.len() {
        let (a, b) = (of(&rows, row), of(&image, rows.rows.len() - 1 - row));
        assert!((a.y - b.y).abs() < 0.01 && (a.z + b.z).abs() < 1e-6, "{a} {b}");
    }
}

#[test]
fn stock_lifts_both_balls() {
    let mut options = options([4.0, 4.0]);
    options.settings.stock_mm = 0.5;
    let rows = plan(&plate(), &options, &Silent).unwrap();
    for p in &rows.places {
        let [a, b] = p.contacts.map(|c| c.centre);
        assert!(((a - b).norm() - (SIZE[2] + 2.0 * 4.5)).abs() < 1e-5, "{a} {b}");
        assert!((p.held_radius_mm - 0.5 * SIZE[2]).abs() < 1e-6);
    }
}

#[test]
fn what_cannot_be_held_is_refused_with_the_reason() {
    let says = |blade: &Blade, options: &PairOptions| {
        let e = plan(blade, options, &Silent).unwrap_err();
        (e.kind, e.message)
    };
    let usual = options([4.0, 4.0]);
    let (kind, message) = says(&plate(), &PairOptions { heights_mm: Some([10.0, 90.0]), ..usual.clone() });
    assert!(kind == ErrorKind::Usage && message.contains("between heights 10.0 and 90.0 mm"), "{message}");
    let (kind, message) = says(&plate(), &PairOptions { radius_mm: [4.0, f64::NAN], ..usual.clone() });
    assert!(kind == ErrorKind::Usage && message.contains("ball radius of tool 2 is NaN"), "{message}");
    let mesh = Blade { part: Part::from_mesh(plate().part.mesh.clone()), ..plate() };
    let (kind, message) = says(&mesh, &usual);
    assert!(kind == ErrorKind::Infeasible && message.contains("the part is a mesh"), "{message}");
    let mut blunt = plate();
    blunt.regions.list[0].sides = None;
    let (_, message) = says(&blunt, &usual);
    assert!(message.contains("it has no two sides"), "{message}");
    // A plate thinner than what the tools are to keep from each other.
    let (_, message) = says(&plate(), &PairOptions { apart_mm: 5.0, ..usual.clone() });
    assert!(message.contains("no place of the suction side has an opposite one"), "{message}");
}
