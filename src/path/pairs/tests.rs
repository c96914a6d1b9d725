//! Rows on a plate: all is known in closed form.
#![allow(clippy::unwrap_used)]

use super::*;
use crate::artifact::blade::{Diagnosis, Unit};
use crate::artifact::region::{Area, Boundary, Extent, Patch, Region, Regions};
use crate::error::ErrorKind;
use crate::geometry::exact::tests::block;
use crate::geometry::part::Part;
use crate::geometry::profile::Sides;
use crate::geometry::{Point, Rigid, Vector};
use crate::observe::Silent;
use crate::path::PathOptions;

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

/// Both tools go round the edges of a plate: over its flat ends, and round its corners without a
/// row, since nothing is left there.
#[test]
fn rows_go_round_both_edges() {
    for radii in [[4.0, 4.0], [4.0, 6.0]] {
        let asked = PairOptions { edges: true, ..options(radii) };
        let (blade, rows) = (plate(), plan(&plate(), &asked, &Silent).unwrap());
        let without = plan(&blade, &options(radii), &Silent).unwrap();
        assert_eq!(rows.held_rows(), without.rows.len());
        assert_eq!(rows.places[..rows.places_held()], without.places);
        assert_eq!(
            (without.edge_rows, without.edge_heights_mm, without.places_held()),
            (0, None, without.places.len())
        );
        let [low, high] = rows.edge_heights_mm.unwrap();
        assert!((10.0..12.0).contains(&low) && (48.0..=50.0).contains(&high), "{low} {high}");
        // From the outermost row to the corner, over the end, and to the row of the other side: the
        // rows are as many as stepovers of the smaller ball over the longer strip, less one.
        let last = without.rows.len() - 1;
        let border = |row: usize| {
            let y = without.places[without.rows[row].start].contacts[0].contact.y;
            y.min(SIZE[1] - y)
        };
        let strip_mm = SIZE[2] + 2.0 * border(0).max(border(last));
        let gaps = strip_mm / flat_stepover_mm(4.0, 0.99 * H);
        let count = rows.edge_rows as f64 + 1.0;
        assert!(count >= gaps.floor() && count <= gaps + 2.0, "{count} gaps, {gaps} stepovers");
        let mut azimuths: Vec<[f64; 2]> = Vec::new();
        for row in &rows.rows[rows.held_rows()..] {
            let places = &rows.places[row.clone()];
            let (from, to) = (places[0].contacts[0].centre.x, places[places.len() - 1].contacts[0].centre.x);
            assert!((from - high).abs() < 1e-9 && (to - low).abs() < 1e-9, "from the top down");
            for p in places {
                for (c, r) in p.contacts.iter().zip(radii) {
                    let near = blade.part.closest(&c.centre, 20.0).unwrap();
                    assert!((near.distance_mm - r).abs() < 1e-5 && (near.point - c.contact).norm() < 1e-5);
                    assert!((c.centre - c.contact - c.normal * r).norm() < 1e-5);
                }
                let [a, b] = p.contacts;
                assert!((a.centre.x - b.centre.x).abs() < 1e-6, "both tools are at one height");
                // One round y = 0, the other round y = 40.
                assert!((a.contact.y < 20.0) == (b.contact.y > 20.0));
            }
            azimuths.push([0, 1].map(|j| places[0].contacts[j].normal.z));
        }
        // Each tool goes from its own side to the other's.
        let [first, end] = [azimuths[0], azimuths[azimuths.len() - 1]];
        let own = without.places[0].contacts.map(|c| c.normal.z.signum());
        for j in 0..2 {
            assert!(first[j] * own[j] > 0.9 && end[j] * own[j] < -0.9, "{first:?} {end:?} {own:?}");
            let falls = azimuths.windows(2).all(|w| (w[1][j] - w[0][j]) * own[j] < 1e-6);
            assert!(falls, "tool {}: {azimuths:?}", j + 1);
        }
        // No two of them are farther apart than the scallop allows, where both are on a flat face.
        for w in rows.rows[rows.held_rows()..].windows(2) {
            for (j, r) in radii.iter().enumerate() {
                let [a, b] = [0, 1].map(|k| rows.places[w[k].start].contacts[j]);
                let flat = a.normal.dot(&b.normal) > 1.0 - 1e-9;
                assert!(!flat || (b.contact - a.contact).norm() <= flat_stepover_mm(*r, H), "{a:?} {b:?}");
            }
        }
        let only = rows.only(&[rows.rows[3].clone(), rows.rows[rows.held_rows()].clone()]);
        assert_eq!((only.rows.len(), only.edge_rows, only.held_rows()), (2, 1, 1));
        assert_eq!(only.places_held(), only.rows[0].len());
    }
}

#[test]
fn a_border_is_smooth_and_nowhere_beyond_what_it_is_drawn_under() {
    let x_mm: Vec<f64> = (0..120).map(|k| -0.5 * f64::from(k)).collect();
    let steps = |k: usize| if k < 30 { 8.0 } else { 8.0 + (k / 10) as f64 - if k > 80 { 6.0 } else { 0.0 } };
    let values: Vec<f64> = (0..120usize).map(steps).collect();
    let bend = 0.2;
    let found = super::edges::smooth_under(&values, &x_mm, bend);
    for k in 0..120usize {
        let beside = values[k.saturating_sub(1)..(k + 2).min(120)].iter().copied().fold(f64::INFINITY, f64::min);
        assert!(found[k] <= beside + 1e-12, "{k}");
    }
    let bends = found.windows(3).map(|w| ((w[0] - 2.0 * w[1] + w[2]) / 0.25).abs());
    // To the grid's step.
    assert!(bends.fold(0.0, f64::max) <= 1.3 * bend, "{found:?}");
    // Where nothing jumps it is what it is drawn under.
    assert!((found[5] - 8.0).abs() < 1e-12);
    let even = super::edges::smooth_under(&[3.0; 120], &x_mm, bend);
    assert!(even.iter().all(|v| *v == 3.0));
}

/// Heights at which a way passes the middle of the plate's upper side, highest first.
fn passes(places: &[[Point; 2]]) -> Vec<f64> {
    let passes = |w: &[[Point; 2]]| {
        let ([a, from], [b, to]) = (w[0], w[1]);
        let over = from.z > 4.9 && to.z > 4.9 && (from.y - 20.0) * (to.y - 20.0) <= 0.0 && from.y != to.y;
        over.then(|| a.x + (b.x - a.x) * (20.0 - from.y) / (to.y - from.y))
    };
    let mut all: Vec<f64> = places.windows(2).filter_map(passes).collect();
    all.sort_by(|a, b| b.total_cmp(a));
    all.dedup_by(|a, b| (*a - *b).abs() < 1e-6);
    all
}

/// Round a plate turns of a helix are evenly apart, and so are those of both threads together; each
/// thread has half a turn more than half of the helix.
#[test]
fn threads_of_a_plate_lie_midway_between_each_other() {
    let blade = plate();
    let radius_mm = 4.0;
    let options = PathOptions { extent: Extent::heights(Some(50.0), Some(20.0)), ..PathOptions::new(radius_mm, 0.05) };
    let helix = crate::path::plan(&blade, &options, &Silent).unwrap();
    let of_helix = passes(&helix.locations.iter().map(|l| [l.centre, l.contact]).collect::<Vec<_>>());
    let step = (of_helix[2] - of_helix[of_helix.len() - 3]) / (of_helix.len() - 5) as f64;
    let mut threads = Threads::of(&blade, &options, &helix).unwrap();
    for by_normal in [0.0, 0.2, 0.5] {
        threads.keep_step(by_normal);
        let laid = threads.lay(&Silent).unwrap();
        let parts: Vec<usize> = (0..laid.rows.places.len() - 1).map(|k| 1 + k % 3).collect();
        let finer = threads.parted(&laid, &parts).unwrap();
        assert_eq!(finer.rows.places.len(), 1 + parts.iter().sum::<usize>());
        for rows in [&laid.rows, &finer.rows] {
            for contact in rows.places.iter().flat_map(|p| p.contacts) {
                let near = blade.part.closest(&contact.centre, 10.0).unwrap();
                assert!((near.distance_mm - radius_mm).abs() < 1e-9, "{}", near.distance_mm);
            }
            for (w, j) in rows.places.windows(2).flat_map(|w| [(w, 0), (w, 1)]) {
                let middle = nalgebra::center(&w[0].contacts[j].centre, &w[1].contacts[j].centre);
                let near = blade.part.closest(&middle, 10.0).unwrap();
                assert!(radius_mm - near.distance_mm < 1.01 * options.settings.chord_mm, "{}", near.distance_mm);
            }
            let way = |j: usize| rows.places.iter().map(|p| [p.contacts[j].centre, p.contacts[j].contact]).collect();
            let both: [Vec<[Point; 2]>; 2] = [way(0), way(1)];
            let mut all = [passes(&both[0]), passes(&both[1])].concat();
            all.sort_by(|a, b| b.total_cmp(a));
            // From the first turn of the helix to its last, nowhere farther apart, and evenly amid.
            assert!(
                (all[0] - of_helix[0]).abs() < 1e-3 && (all[all.len() - 1] - of_helix[of_helix.len() - 1]).abs() < 1e-3
            );
            let apart: Vec<f64> = all.windows(2).map(|w| w[0] - w[1]).collect();
            assert!(apart.iter().all(|d| *d < 1.01 * step), "{apart:?} {step}");
            let amid = &apart[2..apart.len() - 2];
            assert!(amid.iter().all(|d| (d / step - 1.0).abs() < 0.01), "{amid:?} {step}");
            // Both go round in step: where one is at one edge the other is at the other.
            let turns = rows.turns.as_ref().unwrap();
            let most = turns.each_ref().map(|t| t[t.len() - 1] + 1);
            assert!(most.iter().all(|n| n.abs_diff(helix.turns.len() as u32 / 2) <= 2), "{most:?}");
            for place in &rows.places {
                let [one, two] = place.contacts.map(|c| c.contact.y);
                assert!((one + two - 40.0).abs() < 2.0, "{one} {two}");
            }
        }
    }
}
