//! Paths on surfaces of revolution, whose scallop and limit have closed forms, and what must not
//! depend on how a part lies.

use std::f64::consts::{FRAC_1_SQRT_2, TAU};

use bladewright::artifact::blade::{Blade, Diagnosis, Unit};
use bladewright::artifact::region::{Extent, Regions};
use bladewright::artifact::report::{LimitFigures, LimitSource};
use bladewright::artifact::toolpath::{Direction, PathKind, Toolpath};
use bladewright::geometry::brep::{Brep, Face, SurfaceKind};
use bladewright::geometry::nurbs::NurbsSurface;
use bladewright::geometry::part::Part;
use bladewright::geometry::{Point, Rigid, Vector};
use bladewright::observe::Silent;
use bladewright::path::{self, PathOptions};
use bladewright::tool::scallop;
use bladewright::verify;
use nalgebra::{Matrix4, Vector4};

const RADIUS: f64 = 3.0;
const SCALLOP: f64 = 0.01;
/// Samples of the surface: enough for a tenth of a per cent of area.
const SAMPLES: usize = 80_000;

/// The profile `(x, r, weight)` turned about x, degree and knots given; normals outwards.
fn revolved(profile: &[(f64, f64, f64)], degree: usize, knots: Vec<f64>) -> NurbsSurface {
    let w = FRAC_1_SQRT_2;
    let corner = [(1.0, 0.0), (1.0, 1.0), (0.0, 1.0), (-1.0, 1.0), (-1.0, 0.0), (-1.0, -1.0), (0.0, -1.0), (1.0, -1.0)];
    let circle = (0..9).map(|k| (corner[k % 8], if k % 2 == 1 { w } else { 1.0 }));
    let points = circle
        .flat_map(|((y, z), wc)| {
            profile.iter().map(move |(x, r, wp)| {
                let w = wc * wp;
                Vector4::new(w * x, w * r * y, w * r * z, w)
            })
        })
        .collect();
    let turn = vec![0.0, 0.0, 0.0, 0.25, 0.25, 0.5, 0.5, 0.75, 0.75, 1.0, 1.0, 1.0];
    NurbsSurface { degree_u: 2, degree_v: degree, knots_u: turn, knots_v: knots, n_u: 9, n_v: profile.len(), points }
}

/// A straight profile from `(x0, r0)` to `(x1, r1)`.
fn straight(x0: f64, r0: f64, x1: f64, r1: f64) -> NurbsSurface {
    revolved(&[(x0, r0, 1.0), (x1, r1, 1.0)], 1, vec![0.0, 0.0, 1.0, 1.0])
}

/// A circular profile about `(0, middle)` of radius `bend` (negative: its far side is the part's, a
/// waist), over `±half` radians.
fn arched(middle: f64, bend: f64, half: f64) -> NurbsSurface {
    let (s, c) = half.sin_cos();
    let (b, w) = (bend, half.cos());
    let profile = [(-b.abs() * s, middle + b * c, 1.0), (0.0, middle + b / c, w), (b.abs() * s, middle + b * c, 1.0)];
    revolved(&profile, 2, vec![0.0, 0.0, 0.0, 1.0, 1.0, 1.0])
}

/// A blade of one open face.
fn blade(surface: NurbsSurface, airfoil: [f64; 2]) -> Blade {
    let face = Face { name: "wall".into(), kind: SurfaceKind::Revolution, surface, reversed: false, loops: vec![] };
    let part = Part::from_brep(Brep { faces: vec![face], edges: vec![] }, 0.01, &Silent).expect("a face can be meshed");
    Blade {
        name: "form".into(),
        unit: Unit::Mm,
        part,
        model_from_blade: Rigid::identity(),
        regions: Regions::at_heights(airfoil, airfoil, None),
        wheel: None,
        diagnosis: Diagnosis::default(),
    }
}

/// Chords so short that they do not lower the ridges: on these round forms each sags by up to the
/// tolerance all along.
fn options(kind: PathKind, region: [f64; 2]) -> PathOptions {
    PathOptions { extent: Extent::heights(Some(region[0]), Some(region[1])), ..PathOptions::new(RADIUS, SCALLOP) }
        .with(|s| (s.kind, s.chord_mm) = (kind, 3e-5))
}

/// A closed form: the part, where its path runs, and the signed curvature across it (positive:
/// convex).
struct Form {
    name: &'static str,
    blade: Blade,
    region: [f64; 2],
    bend: f64,
    /// Radius of the part at a height, and length along the profile per height.
    radius: fn(f64) -> f64,
    slope: fn(f64) -> f64,
    /// Kinds whose turns are the constant-scallop ones on this form.
    constant: &'static [PathKind],
}

const SLOPE: f64 = 0.25;

fn forms() -> Vec<Form> {
    let both: &[PathKind] = &[PathKind::ConstantHeight, PathKind::IsoParametric, PathKind::ConstantScallop];
    let free: &[PathKind] = &[PathKind::ConstantScallop];
    vec![
        Form {
            name: "cylinder",
            blade: blade(straight(-20.0, 10.0, 24.0, 10.0), [-20.0, 24.0]),
            region: [14.0, -4.0],
            bend: 0.0,
            radius: |_| 10.0,
            slope: |_| 1.0,
            constant: both,
        },
        Form {
            name: "cone",
            blade: blade(straight(-20.0, 16.0 + 20.0 * SLOPE, 24.0, 16.0 - 24.0 * SLOPE), [-20.0, 24.0]),
            region: [14.0, -4.0],
            bend: 0.0,
            radius: |x| 16.0 - SLOPE * x,
            slope: |_| (1.0 + SLOPE * SLOPE).sqrt(),
            constant: both,
        },
        Form {
            name: "sphere zone",
            blade: blade(arched(0.0, 15.0, 1.2), [-13.0, 13.0]),
            region: [8.0, -3.0],
            bend: 1.0 / 15.0,
            radius: |x| (225.0 - x * x).sqrt(),
            slope: |x| 15.0 / (225.0 - x * x).sqrt(),
            constant: free,
        },
        Form {
            name: "torus zone, a waist",
            blade: blade(arched(30.0, -20.0, 0.9), [-15.0, 15.0]),
            region: [8.0, -3.0],
            bend: -1.0 / 20.0,
            radius: |x| 30.0 - (400.0 - x * x).sqrt(),
            slope: |x| 20.0 / (400.0 - x * x).sqrt(),
            constant: free,
        },
        Form {
            name: "torus zone, a belly",
            blade: blade(arched(-8.0, 20.0, 0.9), [-15.0, 15.0]),
            region: [8.0, -3.0],
            bend: 1.0 / 20.0,
            radius: |x| (400.0 - x * x).sqrt() - 8.0,
            slope: |x| 20.0 / (400.0 - x * x).sqrt(),
            constant: free,
        },
    ]
}

/// Distance of two contacts that leave `h` on a circle of this curvature: the two-ball formula as
/// it is usually written, solved by halving.
fn textbook_width(h: f64, bend: f64) -> f64 {
    if bend == 0.0 {
        return 2.0 * (2.0 * RADIUS * h - h * h).sqrt();
    }
    let r = 1.0 / bend.abs();
    let rho = if bend > 0.0 { r + RADIUS } else { r - RADIUS };
    let left = |alpha: f64| {
        let root = (RADIUS * RADIUS - (rho * alpha.sin()).powi(2)).sqrt();
        if bend > 0.0 { rho * alpha.cos() - root - r } else { r - rho * alpha.cos() - root }
    };
    let (mut lo, mut hi) = (0.0, 0.9 * (RADIUS / rho).min(1.0).asin());
    for _ in 0..80 {
        let mid = 0.5 * (lo + hi);
        if left(mid) < h { lo = mid } else { hi = mid }
    }
    2.0 * r * lo
}

/// Area of the strip of the inner turns: on each meridian from midway between the first two turns
/// to midway between the last two.
fn strip_area(form: &Form, path: &Toolpath) -> f64 {
    let base = |turn: usize| path.turns.get(turn).map_or(path.locations.len() - 1, |t| t.first);
    let at = |turn: usize| path.locations[base(turn)].contact.x;
    let n = path.turns.len();
    let steps = 4000;
    let mut area = 0.0;
    for k in 0..40 {
        let u = (f64::from(k) + 0.5) / 40.0;
        let midway = |turn: usize| {
            let on = |turn: usize| at(turn) + u * (at(turn + 1) - at(turn));
            0.5 * (on(turn - 1) + on(turn))
        };
        let (from, to) = (midway(1), midway(n - 1));
        for i in 0..steps {
            let x = from + (to - from) * (f64::from(i) + 0.5) / f64::from(steps);
            area += TAU / 40.0 * (form.radius)(x) * (form.slope)(x) * (from - to) / f64::from(steps);
        }
    }
    area
}

fn figures(form: &Form, kind: PathKind) -> (Toolpath, LimitFigures) {
    let path = path::plan(&form.blade, &options(kind, form.region), &Silent).expect(form.name);
    let figures = verify::limit(&form.blade, &path, SCALLOP, SAMPLES).expect(form.name);
    (path, figures)
}

#[test]
fn limit_is_that_of_the_closed_form() {
    for form in forms() {
        let (path, f) = figures(&form, PathKind::ConstantHeight);
        let width = textbook_width(SCALLOP, form.bend);
        assert_eq!(f.source, LimitSource::Curvature);
        // The curvature across the path is the same everywhere on these forms.
        let closed = f.area_mm2 / width;
        assert!((f.limit_length_mm / closed - 1.0).abs() < 1e-3, "{}: {} {closed}", form.name, f.limit_length_mm);
        let area = strip_area(&form, &path);
        assert!((f.area_mm2 / area - 1.0).abs() < 5e-3, "{}: area {} {area}", form.name, f.area_mm2);
        // The ridges say the same of the length as the curvature does.
        assert!((f.ratio_by_ridges / f.ratio - 1.0).abs() < 5e-3, "{}: {} {}", form.name, f.ratio_by_ridges, f.ratio);
    }
}

#[test]
fn turns_of_constant_scallop_are_constant_and_as_short_as_the_closed_form() {
    for form in forms() {
        for kind in form.constant {
            let (path, f) = figures(&form, *kind);
            let name = format!("{}, {kind:?}", form.name);
            assert!(f.ridge_p95_mm - f.ridge_p05_mm < 0.005 * f.ridge_p50_mm, "{name}: {f:?}");
            if *kind == PathKind::ConstantScallop {
                assert!((f.ridge_p50_mm / SCALLOP - 1.0).abs() < 0.005, "{name}: {f:?}");
                // The last turns close onto the end, where there is room for a part of a turn: half
                // of one on average.
                let closing = 0.6 / (path.turns.len() - 2) as f64;
                assert!(f.ratio > 0.99 && f.ratio < 1.002 + closing, "{name}: {f:?}");
                continue;
            }
            // Judged by the scallop that it leaves: how near to the limit it aims is another
            // matter.
            let width = textbook_width(f.ridge_p50_mm, form.bend);
            let least = f.area_mm2 / width;
            assert!((f.path_length_mm / least - 1.0).abs() < 0.01, "{name}: {} {least}", f.path_length_mm);
        }
    }
}

/// A wall that is round nowhere: an elliptic cone, leaning, moved as told.
fn leaning(to: Matrix4<f64>) -> Blade {
    let mut lean = Matrix4::identity();
    (lean[(1, 0)], lean[(2, 0)], lean[(2, 2)]) = (0.15, -0.1, 0.45);
    let mut surface = straight(-4.0, 14.0, 24.0, 11.0);
    for p in &mut surface.points {
        *p = to * (lean * *p);
    }
    blade(surface, [-4.0, 24.0])
}

fn leaning_figures(kind: PathKind, to: Matrix4<f64>, flip: bool, start_near: Option<[f64; 3]>) -> LimitFigures {
    let mut blade = leaning(to);
    if flip {
        let mut brep = blade.part.brep.take().expect("has faces");
        brep.faces[0].reversed = true;
        blade.part = Part::from_brep(brep, 0.01, &Silent).expect("a face can be meshed");
    }
    let path = path::plan(&blade, &PathOptions { start_near, ..options(kind, [14.0, 8.0]) }, &Silent).expect("a path");
    verify::limit(&blade, &path, SCALLOP, SAMPLES).expect("figures")
}

#[test]
fn rotated_and_mirrored_parts_and_other_starts_have_the_same_figures() {
    let (s, c) = 1.1f64.sin_cos();
    let mut turned = Matrix4::identity();
    (turned[(1, 1)], turned[(1, 2)], turned[(2, 1)], turned[(2, 2)]) = (c, -s, s, c);
    let mut mirror = Matrix4::identity();
    mirror[(2, 2)] = -1.0;
    for kind in [PathKind::ConstantHeight, PathKind::ConstantScallop] {
        let straight = leaning_figures(kind, Matrix4::identity(), false, None);
        for (name, f) in [
            ("turned", leaning_figures(kind, turned, false, None)),
            ("mirrored", leaning_figures(kind, mirror, true, None)),
            ("started in front", leaning_figures(kind, Matrix4::identity(), false, Some([14.0, 2.0, 20.0]))),
            ("started behind", leaning_figures(kind, Matrix4::identity(), false, Some([14.0, 20.0, -2.0]))),
        ] {
            for (what, a, b) in [
                ("ratio", straight.ratio, f.ratio),
                ("area", straight.area_mm2, f.area_mm2),
                ("ridges", straight.ridge_p50_mm, f.ridge_p50_mm),
            ] {
                // Turns begin elsewhere, so one more or less may fit.
                assert!((a / b - 1.0).abs() < 0.03, "{kind:?}, {name}, {what}: {a} {b}");
            }
            assert!(
                (straight.ridge_p95_mm / f.ridge_p95_mm - 1.0).abs() < 0.005,
                "{kind:?}, {name}: {straight:?} {f:?}"
            );
        }
    }
}

/// Greatest distance of a straight move from the surface of ball centres, mm.
fn departure(form: &Form, a: &Point, b: &Point) -> f64 {
    let inside = (1..8).map(|k| a + (b - a) * (f64::from(k) / 8.0));
    inside
        .filter_map(|q| form.blade.part.closest(&q, 2.0 * RADIUS))
        .map(|c| (c.distance_mm - RADIUS).abs())
        .fold(0.0, f64::max)
}

/// Greatest distance of the straight moves from the surface of ball centres, and the error of the
/// whole length, mm.
fn errors(form: &Form, chord_mm: f64, exact_mm: f64) -> (f64, f64) {
    let o = options(PathKind::ConstantHeight, [14.0, 6.0]).with(|s| (s.chord_mm, s.max_step_mm) = (chord_mm, 20.0));
    let path = path::plan(&form.blade, &o, &Silent).expect(form.name);
    let worst = path.locations.windows(2).map(|w| departure(form, &w[0].centre, &w[1].centre)).fold(0.0, f64::max);
    let length = path.locations.last().map_or(0.0, |l| l.s_mm);
    (worst, (length / path.turns.len() as f64 - exact_mm).abs())
}

#[test]
fn halving_the_chord_tolerance_halves_the_errors_or_better() {
    let form = forms().remove(0);
    // A turn on the cylinder of ball centres; its fall is 2e-5 of it.
    let fall = 0.95 * textbook_width(SCALLOP, 0.0);
    let exact = (TAU * 13.0).hypot(fall);
    let chords = [0.016, 0.008, 0.004, 0.002, 0.001];
    let found: Vec<_> = chords.iter().map(|c| errors(&form, *c, exact)).collect();
    for ((worst, _), chord) in found.iter().zip(chords) {
        assert!(*worst <= chord + 1e-6, "{worst} at a chord tolerance of {chord}");
    }
    // Moves are halved, so an error falls by four or not at all: over four halvings by sixteen,
    // less one step.
    let (first, last) = (found[0], found[4]);
    assert!(last.0 <= first.0 / 8.0 && last.1 <= first.1 / 8.0 + 2e-3, "{found:?}");
}

#[test]
fn halving_the_chord_tolerance_brings_turns_of_constant_scallop_nearer() {
    for form in forms().into_iter().skip(2) {
        let chords = [0.004, 0.002, 0.001, 0.0005];
        let found = chords.map(|chord_mm| {
            let o = options(PathKind::ConstantScallop, form.region)
                .with(|s| (s.chord_mm, s.max_step_mm) = (chord_mm, 20.0));
            let path = path::plan(&form.blade, &o, &Silent).expect(form.name);
            let figures = verify::limit(&form.blade, &path, SCALLOP, SAMPLES).expect(form.name);
            let worst =
                path.locations.windows(2).map(|w| departure(&form, &w[0].centre, &w[1].centre)).fold(0.0, f64::max);
            assert!(worst <= chord_mm + 1e-6, "{}: {worst} at a chord tolerance of {chord_mm}", form.name);
            let ridges = [figures.ridge_p05_mm, figures.ridge_p50_mm, figures.ridge_p95_mm];
            [worst, ridges.map(|r| (r - SCALLOP).abs()).into_iter().fold(0.0, f64::max)]
        });
        // Three halvings; ridges are laid to within a two-thousandth.
        for (k, floor) in [0.0, 1e-3 * SCALLOP].into_iter().enumerate() {
            assert!(found[3][k] <= found[0][k] / 8.0 * 1.2 + floor, "{}, error {k}: {found:?}", form.name);
        }
    }
}

#[test]
fn conventional_milling_is_the_same_helix_upwards() {
    let blade = leaning(Matrix4::identity());
    let run = |direction| {
        let o = options(PathKind::ConstantHeight, [14.0, 9.0]).with(|s| s.direction = direction);
        let path = path::plan(&blade, &o, &Silent).expect("a path");
        let figures = verify::limit(&blade, &path, SCALLOP, SAMPLES).expect("figures");
        (path, figures)
    };
    let ((down, a), (up, b)) = (run(Direction::Climb), run(Direction::Conventional));
    assert_eq!(up.region_x_mm, [down.region_x_mm[1], down.region_x_mm[0]]);
    assert_eq!(up.turns.len(), down.turns.len());
    assert!((a.ratio / b.ratio - 1.0).abs() < 0.03 && (a.ridge_p50_mm / b.ridge_p50_mm - 1.0).abs() < 0.03);
    for (path, sign) in [(&down, -1.0), (&up, 1.0)] {
        let mut s = 0.0;
        for w in path.locations.windows(2) {
            let (from, to) = (w[0].centre, w[1].centre);
            assert!(sign * (to.x - from.x) > -1e-9, "{from} to {to}");
            // Counter-clockwise seen from the tip in either case.
            assert!(w[0].normal.y * w[1].normal.z - w[0].normal.z * w[1].normal.y > 0.0, "{from} to {to}");
            s += (to - from).norm();
            assert!((w[1].s_mm - s).abs() < 1e-6);
        }
        for l in &path.locations {
            let c = blade.part.closest(&l.centre, 10.0).expect("near");
            assert!((c.distance_mm - RADIUS).abs() < 2e-6 && (c.point - l.contact).norm() < 1e-3);
        }
        assert_eq!(path.turns.iter().map(|t| t.count).sum::<usize>(), path.locations.len());
    }
}

#[test]
fn stock_stays_on_the_part() {
    let form = forms().remove(0);
    let o = options(PathKind::ConstantHeight, [14.0, 4.0]).with(|s| s.stock_mm = 0.4);
    let path = path::plan(&form.blade, &o, &Silent).expect("a path");
    for l in &path.locations {
        assert!(
            (l.centre.y.hypot(l.centre.z) - 13.4).abs() < 1e-5 && (l.contact.y.hypot(l.contact.z) - 10.4).abs() < 1e-5
        );
    }
    let f = verify::limit(&form.blade, &path, SCALLOP, SAMPLES).expect("figures");
    // The scallop is that over the stock, and the turns are as far apart as on a part that is
    // thicker by it.
    assert!(f.ridge_p50_mm < SCALLOP && f.ridge_p50_mm > 0.9 * SCALLOP, "{f:?}");
    let closed = f.area_mm2 / textbook_width(SCALLOP, 0.0);
    assert!((f.limit_length_mm / closed - 1.0).abs() < 1e-3);
    let thicker = Form { radius: |_| 10.4, ..form };
    assert!((f.area_mm2 / strip_area(&thicker, &path) - 1.0).abs() < 5e-3, "{}", f.area_mm2);
}

#[test]
fn iso_parametric_turns_share_the_way_evenly() {
    let waist = forms().remove(3);
    let path = path::plan(&waist.blade, &options(PathKind::IsoParametric, waist.region), &Silent).expect("a path");
    assert!(path.planned_scallop_mm <= SCALLOP, "{}", path.planned_scallop_mm);
    // On a surface of revolution the way is that along the profile of ball centres, about (0, 30)
    // with radius 17.
    let angle = |p: &Point| p.x.atan2(30.0 - p.y.hypot(p.z));
    let n = path.turns.len();
    let starts: Vec<f64> = path.turns.iter().map(|t| angle(&path.locations[t.first].centre)).collect();
    let share = (starts[0] - angle(&path.locations[path.locations.len() - 1].centre)) / n as f64;
    for w in starts.windows(2) {
        assert!((w[0] - w[1] - share).abs() < 1e-3 * share, "{} {share}", w[0] - w[1]);
    }
}

#[test]
fn normals_of_the_forms_look_outwards() {
    for form in forms() {
        let q = Point::new(1.0, 60.0, 0.0);
        let c = form.blade.part.closest(&q, f64::INFINITY).expect("near");
        assert!(c.normal.dot(&Vector::y()) > 0.5, "{}", form.name);
    }
}

/// Arc lengths of the contacts of each turn along the profile, mm, by rising turn from the end on,
/// across from where turns begin; `arc` has it of a contact. The last turn, which lies on the end,
/// is left out.
fn passes(path: &Toolpath, arc: impl Fn(&Point) -> f64) -> Vec<f64> {
    let across = |p: &Point| p.z.atan2(-p.y).abs();
    let inner = path.turns.iter().rev().skip(1);
    inner
        .filter_map(|t| {
            let turn = &path.locations[t.first..t.first + t.count];
            let at = turn.iter().min_by(|a, b| across(&a.contact).total_cmp(&across(&b.contact)))?;
            Some(arc(&at.contact))
        })
        .collect()
}

/// First-order widths are too large by what is of second order in the scallop, and that adds up
/// from pass to pass; on a face whose parameters go as fast at both ends of the way nothing else
/// does. Turns of constant scallop are each measured against the last one and stay.
#[test]
fn first_order_neighbours_drift_by_the_excess_of_their_widths() {
    const BODY: f64 = 60.0;
    const H: f64 = 0.018;
    let sphere = blade(arched(0.0, BODY, 0.7), [-38.0, 38.0]);
    let planned = |kind: PathKind| {
        let o = options(kind, [36.0, -32.0]).with(|s| s.scallop_mm = H);
        passes(&path::plan(&sphere, &o, &Silent).expect("a path"), |p| BODY * (p.x / BODY).asin())
    };
    let exact = scallop::width_mm(RADIUS, H, 1.0 / BODY).expect("the ball fits");
    let printed = 2.0 * (2.0 * H * RADIUS * BODY / (BODY + RADIUS)).sqrt();
    let drift = |at: &[f64], passes: usize| (at[passes] - at[0]) / exact - passes as f64;
    for kind in [PathKind::FirstOrder, PathKind::FirstOrderRings] {
        let at = planned(kind);
        assert!(at.len() > 101, "{kind:?}: {} passes", at.len());
        let expected = 100.0 * (printed / exact - 1.0);
        let found = drift(&at, 100);
        assert!(expected > 0.1 && (found / expected - 1.0).abs() < 0.05, "{kind:?}: {found} beside {expected}");
    }
    let ours = drift(&planned(PathKind::ConstantScallop), 100);
    // Ways within 5·10⁻⁴ of the one that leaves the scallop are right.
    assert!(ours.abs() < 100.0 * 5e-4, "{ours}");
}

/// Round a cylinder the strip is a plane's, whose printed width is exact, and nothing drifts.
#[test]
fn first_order_neighbours_stay_round_a_cylinder() {
    let bar = blade(straight(-40.0, 10.0, 24.0, 10.0), [-40.0, 24.0]);
    let exact = scallop::width_mm(RADIUS, SCALLOP, 0.0).expect("the ball fits");
    let path = path::plan(&bar, &options(PathKind::FirstOrderRings, [20.0, -36.0]), &Silent).expect("a path");
    let at = passes(&path, |p| p.x);
    assert!(at.len() > 101, "{} passes", at.len());
    assert!(((at[100] - at[0]) / exact - 100.0).abs() < 1e-4, "{}", (at[100] - at[0]) / exact);
    // Every ring is closed, and the way across to the next is on the surface of ball centres too.
    let off = path.locations.iter().map(|l| (l.centre.y.hypot(l.centre.z) - 10.0 - RADIUS).abs()).fold(0.0, f64::max);
    assert!(off < 1e-5, "{off}");
    for t in &path.turns[1..path.turns.len() - 1] {
        let turn = &path.locations[t.first..t.first + t.count];
        let again = turn[1..].iter().filter(|l| (l.centre - turn[0].centre).norm() < 1e-6).count();
        assert_eq!(again, 1);
    }
}

#[test]
fn first_order_neighbours_are_refused_where_they_are_not_known() {
    let exact = blade(straight(-20.0, 10.0, 24.0, 10.0), [-20.0, 24.0]);
    let o = options(PathKind::FirstOrder, [14.0, 4.0]);
    let stock = path::plan(&exact, &o.clone().with(|s| s.stock_mm = 0.2), &Silent).expect_err("stock");
    assert!(stock.message.contains("path.stock_mm"), "{stock}");
    let mesh = Blade { part: Part::from_mesh(exact.part.mesh.clone()), ..exact };
    let refused = path::plan(&mesh, &o, &Silent).expect_err("a mesh");
    assert!(refused.message.contains("the part is a mesh"), "{refused}");
}
