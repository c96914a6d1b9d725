//! Tables of known blades: closed forms, every way to write the same table, damaged ones,
//! mutations.
#![allow(clippy::unwrap_used)]

use std::f64::consts::{PI, TAU};
use std::fmt::Write;

use super::*;
use crate::error::ErrorKind;
use crate::geometry::brep::{Brep, SurfaceKind};
use crate::geometry::mesh::{Mesh, topology};
use crate::geometry::part::Part;
use crate::observe::Silent;
use crate::read::model::ModelOptions;
use crate::read::model::sample::Random;

/// Half axes of the elliptical sections, mm.
const A: f64 = 20.0;
const B: f64 = 4.0;
/// Height, mm, and twist over it, rad.
const H: f64 = 60.0;
const TWIST: f64 = 0.7;
/// Distance of the blade from the axis of cylindrical coordinates, mm.
const OFF: f64 = 100.0;

/// A point of the twisted elliptical cylinder; it stands along +x from `x = OFF`, as blades stand
/// on a wheel that turns about z.
fn ideal(phi: f64, share: f64) -> Point {
    let (y, z) = (B * phi.sin(), A * phi.cos());
    let (s, c) = (TWIST * share).sin_cos();
    Point::new(OFF + H * share, c * y - s * z, s * y + c * z)
}

/// Sections of `n` points round.
fn ideal_sections(n: usize, sections: usize) -> Vec<Vec<Point>> {
    let share = |k: usize| k as f64 / (sections - 1) as f64;
    (0..sections).map(|k| (0..n).map(|i| ideal(TAU * i as f64 / n as f64, share(k))).collect()).collect()
}

fn rows(points: &[Point]) -> String {
    points.iter().fold(String::new(), |mut out, p| {
        writeln!(out, "{:?} {:?} {:?}", p.x, p.y, p.z).unwrap();
        out
    })
}

fn joined(sections: &[Vec<Point>], before: impl Fn(usize) -> String) -> String {
    sections.iter().enumerate().map(|(k, s)| before(k) + &rows(s)).collect()
}

/// Reads files from a folder; the first is the one that is named.
fn read_files(files: &[(&str, String)]) -> Result<FaceModel> {
    let folder = tempfile::tempdir().unwrap();
    for (name, text) in files {
        std::fs::write(folder.path().join(name), text).unwrap();
    }
    let path = folder.path().join(files[0].0);
    let bytes = std::fs::read(&path).unwrap();
    assert_eq!(super::super::format::detect(&path, &bytes).unwrap(), super::super::format::Format::Sections);
    read(&path, &bytes, None)
}

/// The mesh of the first of these files, through the whole way of a model.
fn meshed(files: &[(&str, String)]) -> Result<Mesh> {
    let folder = tempfile::tempdir().unwrap();
    for (name, text) in files {
        std::fs::write(folder.path().join(name), text).unwrap();
    }
    let path = folder.path().join(files[0].0);
    crate::read::model::survey(&path, &ModelOptions::default(), &Silent).map(|s| s.part.mesh)
}

fn part(brep: Brep) -> Part {
    let part = Part::from_brep(brep, 0.02, &Silent).unwrap();
    let t = topology(&part.mesh);
    assert_eq!((t.open_edges, t.inconsistent_edges, t.nonmanifold_edges), (0, 0, 0));
    part
}

/// The shape is the twisted elliptical cylinder, within a tolerance, closed and outward.
fn is_ideal(name: &str, shape: Result<FaceModel>, tolerance: f64) -> FaceModel {
    let shape = shape.unwrap_or_else(|e| panic!("{name}: {e}"));
    let part = part(shape.brep.clone());
    let volume = PI * A * B * H;
    assert!((part.mesh.volume_mm3() / volume - 1.0).abs() < 3e-3, "{name}: {} {volume}", part.mesh.volume_mm3());
    for i in 0..40 {
        let q = ideal(TAU * (f64::from(i) + 0.3) / 40.0, (f64::from(i) * 0.618).fract());
        let d = part.closest(&q, 1.0).map_or(f64::INFINITY, |c| c.distance_mm);
        assert!(d < tolerance, "{name}: {d} at {q}");
    }
    shape
}

fn tblade3(sections: &[Vec<Point>]) -> String {
    let closed: Vec<Vec<Point>> = sections.iter().map(|s| [&s[..], &s[..1]].concat()).collect();
    format!("  {}   {}\n", closed[0].len(), closed.len()) + &joined(&closed, |_| String::new())
}

#[test]
fn a_twisted_elliptical_cylinder() {
    let shape = is_ideal("plain", read_files(&[("blade3d.dat", tblade3(&ideal_sections(96, 9)))]), 2e-4);
    assert_eq!(shape.brep.faces.len(), 4);
    assert_eq!(shape.brep.faces.iter().filter(|f| f.kind == SurfaceKind::Plane).count(), 2, "both ends are flat");
    assert!(shape.notes[0].to_string().contains("within 0.000000 mm"), "{:?}", shape.notes);
    // The test by leaving out tells the truth: with twice the points the real error is below what
    // it says.
    let said = |what: &str, n: usize, m: usize| -> f64 {
        let shape = read_files(&[("blade3d.dat", tblade3(&ideal_sections(n, m)))]).unwrap();
        let note = shape.notes.iter().find(|n| n.to_string().contains(what)).unwrap();
        let Remark::LeftOutTest { greatest_mm, .. } = note else { panic!("{note}") };
        *greatest_mm
    };
    assert!(said("second point", 24, 9) > 20.0 * said("second point", 96, 9).max(1e-4));
    assert!(said("second section", 48, 6) > 5.0 * said("second section", 48, 12).max(1e-4));
}

#[test]
fn the_same_blade_from_every_form_of_table() {
    let s = ideal_sections(64, 7);
    let n = s.len();
    let header = |keys: &str| format!("[sections]\nfiles = \"data.txt\"\n{keys}\n");
    let data = |text: String, keys: &str| vec![("t.toml", header(keys)), ("data.txt", text)];
    let map = |f: &dyn Fn(&Point) -> [f64; 3]| -> Vec<Vec<Point>> {
        s.iter().map(|row| row.iter().map(|p| Point::from(f(p))).collect()).collect()
    };
    let halves = |flip: &dyn Fn(usize) -> bool| -> Vec<Vec<Point>> {
        let side = |row: &[Point], k: usize, at: usize| -> Vec<Point> {
            let mut side: Vec<Point> = (0..=32).map(|i| row[(32 * at + i) % 64]).collect();
            if flip(2 * k + at) {
                side.reverse();
            }
            side
        };
        s.iter().enumerate().flat_map(|(k, row)| [side(row, k, 0), side(row, k, 1)]).collect()
    };
    let blank = |_: usize| "\n".to_owned();
    let text = |k: usize| format!("Section {k} from the hub\n J X Y Z\n");
    let cylinder = map(&|p| [p.z, p.x.hypot(p.y), p.y.atan2(p.x).to_degrees()]);
    let arc = map(&|p| [p.z, p.x.hypot(p.y) * p.y.atan2(p.x), p.x.hypot(p.y)]);
    let xyz = "columns = [\"x\", \"y\", \"z\"]";
    let numbered: Vec<(String, String)> =
        (0..n).map(|k| (format!("s{}.csv", k + 5), rows(&s[k]).replace(' ', ","))).collect();
    let mut by_file = vec![("t.toml", format!("[sections]\nfiles = [\"s*.csv\"]\n{xyz}\n"))];
    by_file.extend(numbered.iter().map(|(name, t)| (name.as_str(), format!("x,y,z\n{t}"))));
    let cases: Vec<(&str, Vec<(&str, String)>)> = vec![
        ("TurboGrid", vec![("profile.curve", joined(&s, |k| format!("## Profile {} at {k}%\n", k + 1)))]),
        (
            "Tecplot loops",
            vec![("a.dat", joined(&s, |k| format!("{}zone i=64\n", if k == 0 { "VARIABLES= X Y Z\n" } else { "" })))],
        ),
        (
            "Tecplot sides",
            vec![(
                "a.dat",
                joined(&halves(&|k| k % 3 == 1), |k| {
                    format!("{}ZONE I=33, F=POINT\n", if k == 0 { "variables=x,y,z\n" } else { "" })
                }),
            )],
        ),
        (
            "Tecplot surface",
            vec![("a.dat", format!("variables=x,y,z\nzone i=64, j={n}\n{}", joined(&s, |_| String::new())))],
        ),
        ("blank lines", data(joined(&s, blank), xyz)),
        ("text lines", data(joined(&s, text), xyz)),
        ("counts", data(joined(&s, |_| "64\n".into()), xyz)),
        ("no marks", data(joined(&s, |_| String::new()), &format!("{xyz}\npoints_per_block = 64"))),
        ("sides", data(joined(&halves(&|k| k % 2 == 0), blank), xyz)),
        ("one file a section", by_file),
        ("header at the top", vec![("a.txt", format!("+++\n[sections]\n{xyz}\n+++\n{}", joined(&s, blank)))]),
        ("degrees", data(joined(&cylinder, blank), "columns = [\"z\", \"r\", \"theta\"]\nangle = \"deg\"")),
        ("arc length", data(joined(&arc, blank), "columns = [\"z\", \"r*theta\", \"r\"]")),
        (
            "inch",
            data(joined(&map(&|p| [p.x / 25.4, p.y / 25.4, p.z / 25.4]), blank), &format!("{xyz}\nunit = \"inch\"")),
        ),
        (
            "shares",
            data(joined(&map(&|p| [p.x / 160.0, p.y / 160.0, p.z / 160.0]), blank), &format!("{xyz}\nunit_mm = 160.0")),
        ),
        ("skipped", data(format!("1 2 3\n{}", joined(&s, blank)), &format!("{xyz}\nskip_lines = 1"))),
        ("comma", data(joined(&s, blank).replace(' ', ";").replace('.', ","), &format!("{xyz}\ndecimal_comma = true"))),
        (
            "heights",
            data(
                joined(&map(&|p| [7.0, p.y, p.z]), blank),
                &format!(
                    "columns = [\"skip\", \"y\", \"z\"]\nheights = {:?}",
                    (0..n).map(|k| OFF + H * k as f64 / (n - 1) as f64).collect::<Vec<_>>()
                ),
            ),
        ),
    ];
    for (name, files) in cases {
        let shape = is_ideal(name, read_files(&files), 2e-3);
        assert!(shape.notes[0].to_string().contains("joined by number"), "{name}: {:?}", shape.notes);
        // A mark before each file, data and header, makes no other blade of them.
        let marked: Vec<(&str, String)> = files.iter().map(|(name, text)| (*name, format!("\u{feff}{text}"))).collect();
        let [with, without] = [&marked, &files].map(|files| meshed(files).unwrap_or_else(|e| panic!("{name}: {e}")));
        assert_eq!(with.points, without.points, "{name}");
    }
}

/// Both sides in one row, as `z, r, theta1, theta2`.
#[test]
fn sides_in_columns() {
    let side = |k: usize, s: f64| -> Vec<Point> {
        (0..=40)
            .map(|i| PI * f64::from(i) / 40.0)
            .map(|a| Point::new(A * a.cos(), s * B * a.sin(), 10.0 * k as f64))
            .collect()
    };
    let mut text = String::new();
    for k in 0..5 {
        writeln!(text, "SURFACE {k}").unwrap();
        for (p, q) in side(k, 1.0).iter().zip(side(k, -1.0)) {
            writeln!(text, "{:?} {:?} {:?} {:?}", p.x, p.z, p.y, q.y).unwrap();
        }
    }
    let header = "[sections]\nfiles = \"data.txt\"\ncolumns = [\"x\", \"z\", \"y1\", \"y2\"]\n".to_owned();
    let shape = read_files(&[("t.toml", header), ("data.txt", text)]).unwrap();
    let volume = part(shape.brep).mesh.volume_mm3();
    assert!((volume / (PI * A * B * 40.0) - 1.0).abs() < 3e-3, "{volume}");
}

/// Points that do not belong together by number: other counts, other starts, other directions.
#[test]
fn sections_with_points_of_their_own() {
    let mut s: Vec<Vec<Point>> = (0..7)
        .map(|k| {
            let n = 70 + 6 * k;
            (0..n).map(|i| ideal(TAU * i as f64 / n as f64, k as f64 / 6.0)).collect()
        })
        .collect();
    let shape = is_ideal("counts", read_files(&[("a.curve", joined(&s, |k| format!("# {k}\n")))]), 2e-3);
    assert!(shape.notes[0].to_string().contains("splines of their own"), "{:?}", shape.notes);
    s = ideal_sections(80, 7);
    for (k, row) in s.iter_mut().enumerate() {
        row.rotate_left(11 * k);
        if k % 2 == 1 {
            row.reverse();
        }
    }
    let shape = is_ideal("starts", read_files(&[("a.curve", joined(&s, |k| format!("# {k}\n")))]), 2e-3);
    assert!(shape.notes[0].to_string().contains("splines of their own"), "{:?}", shape.notes);
}

/// A profile with a blunt trailing edge: `x = 30 t²`, `y = 3 t (1 − t²/1.5)`, cut at `x = 30` where
/// it is 2 wide; it encloses 72. `bend` lifts the points of the sections out of their planes, which
/// leaves the volume as it is.
fn blunt(edge_points: usize, bend: f64) -> String {
    let section = |k: usize| -> Vec<Point> {
        let round =
            (0..=60).map(|i| -1.0 + f64::from(i) / 30.0).map(|t: f64| (30.0 * t * t, 3.0 * t * (1.0 - t * t / 1.5)));
        let edge = (1..=edge_points).map(|i| (30.0, 1.0 - 2.0 * i as f64 / (edge_points + 1) as f64));
        round.chain(edge).map(|(x, y)| Point::new(x, y, 8.0 * k as f64 + bend * (0.02 * x * x + y * y))).collect()
    };
    let sections: Vec<Vec<Point>> = (0..6).map(section).collect();
    joined(&sections, |k| format!("# {k}\n"))
}

#[test]
fn blunt_edges_are_edges() {
    for (points, bend, faces) in [(0, 0.0, 5), (7, 0.0, 5), (0, 0.3, 5), (7, 0.3, 7)] {
        let name = format!("{points} points on the edge, bend {bend}");
        let shape = read_files(&[("a.curve", blunt(points, bend))]).unwrap_or_else(|e| panic!("{name}: {e}"));
        assert!(shape.notes[0].to_string().contains("2 sharp edges"), "{name}: {:?}", shape.notes);
        assert_eq!(shape.brep.faces.len(), faces, "{name}");
        let part = part(shape.brep);
        let volume = part.mesh.volume_mm3();
        assert!((volume / (72.0 * 40.0) - 1.0).abs() < 3e-3, "{name}: {volume}");
        // The corners are kept, the edge between them is straight.
        for (x, y) in [(30.0, 1.0), (30.0, -1.0), (30.0, 0.3)] {
            let q = Point::new(x, y, 20.0 + bend * (0.02 * x * x + y * y));
            let d = part.closest(&q, 1.0).map_or(f64::INFINITY, |c| c.distance_mm);
            assert!(d < 1e-3, "{name}: {d} at {q}");
        }
    }
}

/// Edges with a radius of a few micrometres, and ends that are not flat: the tolerances of a large
/// part would take both sides of an edge for one.
#[test]
fn a_small_thin_blade_is_closed() {
    for (half_thickness, power) in [(0.05, 1.0), (0.1, 1.5)] {
        let at = |phi: f64, share: f64| {
            let (s, c) = phi.sin_cos();
            let (y, z) = (half_thickness * s.signum() * s.abs().powf(power) + 0.22 * s * s, 2.2 * c);
            let (s, c) = (TWIST * share).sin_cos();
            Point::new(17.0 + 7.0 * share - 0.03 * (y * y + z * z), c * y - s * z, s * y + c * z) * 0.6
        };
        let section = |k: usize| (0..300).map(|i| at(TAU * f64::from(i) / 300.0, k as f64 / 5.0)).collect();
        let sections: Vec<Vec<Point>> = (0..6).map(section).collect();
        let mesh = meshed(&[("a.curve", joined(&sections, |k| format!("# {k}\n")))]).unwrap();
        let t = topology(&mesh);
        assert!(t.closed(), "{half_thickness}: {} open edges", t.open_edges);
    }
}

/// Three corners at one end and a bent end section: the fan of a cap.
#[test]
fn an_edge_with_three_corners() {
    let section = |k: usize| -> Vec<Point> {
        let round =
            (0..=60).map(|i| -1.0 + f64::from(i) / 30.0).map(|t: f64| (30.0 * t * t, 3.0 * t * (1.0 - t * t / 1.5)));
        let tip = [(30.7, 0.5), (31.4, 0.0), (30.7, -0.5)];
        round.chain(tip).map(|(x, y)| Point::new(x, y, 8.0 * k as f64 + 0.01 * x * x)).collect()
    };
    let sections: Vec<Vec<Point>> = (0..6).map(section).collect();
    let shape = read_files(&[("a.curve", joined(&sections, |k| format!("# {k}\n")))]).unwrap();
    let volume = part(shape.brep).mesh.volume_mm3();
    assert!((volume / ((72.0 + 1.4) * 40.0) - 1.0).abs() < 4e-3, "{volume}");
}

#[test]
fn one_profile_is_refused_or_drawn_out() {
    // Along one side, then along the other.
    let n = 41;
    let side =
        |s: f64| (0..n).map(move |i| PI * f64::from(i) / f64::from(n - 1)).map(move |a| [A * a.cos(), s * B * a.sin()]);
    let text: String =
        side(1.0).chain(side(-1.0)).enumerate().map(|(k, p)| format!("{k} {:?} {:?}\n", p[0], p[1])).collect();
    let e = read_files(&[("profile.txt", text.clone())]).err().unwrap();
    assert_eq!(e.kind, ErrorKind::InputOutput);
    for word in ["single profile", "two sections or more", "extrude"] {
        assert!(e.to_string().contains(word), "{word} is not in {e}");
    }
    let header =
        |keys: &str| format!("[sections]\nfiles = \"profile.txt\"\ncolumns = [\"skip\", \"x\", \"y\"]\n{keys}\n");
    let with = |keys: &str| read_files(&[("t.toml", header(keys)), ("profile.txt", text.clone())]);
    let shape = with("extrude = 25.0").unwrap();
    let volume = part(shape.brep).mesh.volume_mm3();
    assert!((volume / (PI * A * B * 25.0) - 1.0).abs() < 3e-3, "{volume}");
    for (keys, words) in [
        ("", "the columns lack z"),
        ("heights = [5.0]", "one section makes no blade"),
        ("heights = [5.0, 6.0]", "2 values for 1 sections"),
    ] {
        let e = with(keys).err().unwrap().to_string();
        assert!(e.contains(words), "{words} is not in {e}");
    }
}

#[test]
fn bad_tables_are_refused_with_a_sentence() {
    let s = ideal_sections(40, 4);
    let good = joined(&s, |k| format!("# {k}\n"));
    let refused = |name: &str, text: String, words: &[&str]| {
        let e = read_files(&[(name, text)]).err().unwrap_or_else(|| panic!("{words:?}: was read"));
        assert_eq!(e.kind, ErrorKind::InputOutput, "{e}");
        assert!(words.iter().all(|w| e.to_string().contains(w)), "{words:?} are not in {e}");
    };
    let line = good.lines().nth(5).unwrap().to_owned();
    refused("a.curve", good.replacen(&line, "1 2 x3", 1), &["line 6", "\"x3\"", "not a number"]);
    refused("a.curve", good.replacen(&line, "1.5 2.5", 1), &["line 6", "2 numbers"]);
    refused(
        "a.curve",
        joined(&[s[0].clone(), s[2].clone(), s[1].clone()], |k| format!("# {k}\n")),
        &["back along the span"],
    );
    refused("a.curve", joined(&[s[0].clone(), s[0].clone()], |k| format!("# {k}\n")), &["in one place"]);
    let few: Vec<Vec<Point>> = ideal_sections(7, 2).iter().map(|s| [&s[..], &s[..1]].concat()).collect();
    refused("a.curve", joined(&few, |k| format!("# {k}\n")), &["7 points, at least 8"]);
    refused(
        "a.curve",
        joined(&[s[0][..20].to_vec(), s[1].clone()], |k| format!("# {k}\n")),
        &["1 of 2 blocks do not come back"],
    );
    refused("a.dat", tblade3(&s).replacen("   4\n", "   5\n", 1), &["promises"]);
    let header = |keys: &str| format!("+++\n[sections]\n{keys}\n+++\n{good}");
    refused("a.txt", header("columns = [\"x\", \"y\"]"), &["the columns lack z"]);
    refused(
        "a.txt",
        header("columns = [\"x\", \"y\", \"z\", \"skip\"]"),
        // The first row of a section may be a count of points; the second may not.
        &["line 7", "3 numbers where the columns are 4"],
    );
    refused("a.txt", header("columns = [\"x\", \"y\", \"z\"]\nextrude = 3.0"), &["here are 4 sections"]);
    refused(
        "a.txt",
        "+++\n[sections]\ncolumns = [\"x\", \"y\", \"z\"]\norder = \"sides\"\n+++\n".to_owned()
            + &joined(&s[..3], |k| format!("# {k}\n")),
        &["number is odd"],
    );
    refused(
        "a.txt",
        "+++\n[sections]\ncolumns = [\"x\", \"r*theta\", \"r\"]\n+++\n".to_owned() + &"1 2 0\n".repeat(9),
        &["no number"],
    );
    refused("t.toml", "[sections]\nfiles = \"none.dat\"\n".into(), &["is not there"]);
    refused("t.toml", "[model]\nfile = \"a.step\"\n".into(), &["t.toml"]);
    // Ends of sides that nearly meet are joined in their middle: farther from the points than this
    // tolerance.
    let halves = |gap: f64| -> String {
        let side = |k: usize, at: usize| -> Vec<Point> {
            (0..=32)
                .map(|i| {
                    ideal(PI * (at as f64 + f64::from(i) / 32.0), k as f64 / 4.0) + Vector::y() * (gap * at as f64)
                })
                .collect()
        };
        (0..5).flat_map(|k| [rows(&side(k, 0)) + "\n", rows(&side(k, 1)) + "\n"]).collect()
    };
    let keys = "+++\n[sections]\ncolumns = [\"x\", \"y\", \"z\"]\ntolerance_mm = 0.0005\n+++\n";
    refused(
        "a.txt",
        format!("{keys}{}", halves(0.003)),
        &["the surface misses point", "the tolerance is 0.0005 mm", "tolerance_mm"],
    );
    assert!(read_files(&[("a.txt", format!("{}{}", keys.replace("0.0005", "0.01"), halves(0.003)))]).is_ok());
}

/// A header is told from a job file, and its data files are known, so that a run can keep their
/// hashes.
#[test]
fn headers_name_their_files() {
    let folder = tempfile::tempdir().unwrap();
    let file = |name: &str, text: &str| {
        let path = folder.path().join(name);
        std::fs::write(&path, text).unwrap();
        path
    };
    let data = [file("s1.dat", ""), file("s2.dat", "")];
    let table = file("t.toml", "[sections]\nfiles = \"s*.dat\"\n");
    let job = file("job.toml", "[model]\nfile = \"t.toml\"\n");
    assert!(is_header_file(&table) && !is_header_file(&job) && !is_header_file(&data[0]));
    let marked = file("m.toml", "\u{feff}[sections]\nfiles = \"s*.dat\"\n");
    assert!(is_header_file(&marked) && data_files(&marked) == data);
    assert_eq!(data_files(&table), data);
    assert!(data_files(&job).is_empty() && data_files(&data[0]).is_empty());
}

/// A tip without chord is left out.
#[test]
fn a_collapsed_end_is_left_out() {
    let mut s = ideal_sections(40, 5);
    s.push(vec![Point::new(OFF + H + 1.0, 0.0, 0.0); 40]);
    let text = format!("variables=x,y,z\nzone i=40, j=6\n{}", joined(&s, |_| String::new()));
    let shape = is_ideal("collapsed", read_files(&[("a.dat", text)]), 0.02);
    assert!(shape.notes.iter().any(|n| n.to_string().contains("left out at the end")), "{:?}", shape.notes);
}

#[test]
fn mutations_give_a_solid_or_an_error() {
    mutate(600);
}

/// The same for longer.
#[test]
#[ignore = "a minute"]
fn many_mutations_give_a_solid_or_an_error() {
    mutate(60_000);
}

fn mutate(rounds: usize) {
    let s = ideal_sections(16, 3);
    let header = "+++\n[sections]\ncolumns = [\"x\", \"y\", \"z\"]\nblocks = \"any\"\nunit = \"mm\"\n+++\n";
    let files = [
        ("a.txt", format!("{header}{}", joined(&s, |_| "\n".into()))),
        ("a.dat", tblade3(&s)),
        ("a.curve", joined(&s, |k| format!("# {k}\n"))),
        ("b.dat", joined(&s, |k| format!("{}zone i=16 t=\"{k}\"\n", if k == 0 { "VARIABLES= X Y Z\n" } else { "" }))),
        ("c.dat", format!("variables=x,y,z\nzone i=16, j=3\n{}", joined(&s, |_| String::new()))),
    ];
    let mut random = Random(0x2545_f491_4f6c_dd1d);
    let (mut read_well, mut told) = (0, 0);
    for round in 0..rounds {
        let (name, good) = &files[round % files.len()];
        let mut bytes = good.clone().into_bytes();
        for _ in 0..=random.below(2) {
            let reach = if random.below(2) == 0 { bytes.len().min(160) } else { bytes.len() };
            let at = random.below(reach);
            match random.below(7) {
                0 => bytes.truncate(at),
                1 => drop(bytes.drain(at..(at + 1 + random.below(60)).min(bytes.len()))),
                2 => {
                    let piece = bytes[at..(at + 60).min(bytes.len())].to_vec();
                    bytes.splice(at..at, piece);
                }
                3 => drop(bytes.splice(at..at, *b"99999999")),
                4 => drop(bytes.splice(at..at, *b"e30 \n")),
                5 if at < bytes.len() => bytes[at] = b" .-\n9\"="[random.below(7)],
                _ if at < bytes.len() => bytes[at] ^= 1 << random.below(7),
                _ => {}
            }
        }
        match read(Path::new(name), &bytes, None) {
            Ok(shape) => {
                assert!(shape.brep.faces.iter().all(|f| f.surface.validate().is_ok()));
                read_well += 1;
            }
            Err(e) => {
                assert_eq!(e.kind, ErrorKind::InputOutput, "{e}");
                told += 1;
            }
        }
    }
    assert!(
        20 * read_well > rounds && 12 * told > rounds,
        "{read_well} read, {told} refused: the mutations are too weak or too strong"
    );
}
