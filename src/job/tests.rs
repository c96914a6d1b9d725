#![allow(clippy::unwrap_used)]
use super::*;
use crate::error::ErrorKind;
use std::path::Path;

fn usage(text: &str) -> String {
    let e = parse(text, "blade.toml").unwrap_err();
    assert_eq!(e.kind, ErrorKind::Usage);
    e.message
}

#[test]
fn messages_name_line_key_and_what_is_allowed() {
    let m = usage("[model]\nfile = \"a.stl\"\n\n[path]\nscalop_mm = 0.01\n");
    assert!(m.contains("blade.toml, line 5") && m.contains("scalop_mm") && m.contains("scallop_mm"), "{m}");
    let m = usage("[tool]\nradius_mm = \"eight\"\n");
    assert!(
        m.contains("line 2") && m.contains("radius_mm") && m.contains("a number is wanted, not the text \"eight\""),
        "{m}"
    );
    let m = usage("[[tool.holder]]\nradius_mm = 8\nlenght_mm = 3\n");
    assert!(m.contains("line 3") && m.contains("lenght_mm") && m.contains("length_mm"), "{m}");
    let m = usage("[model]\naxis = \"w\"\n");
    assert!(m.contains("line 2") && m.contains("\"-x\""), "{m}");
    let m = usage("[nonsense]\n");
    assert!(m.contains("line 1") && m.contains("nonsense") && m.contains("region"), "{m}");
    let m = usage("[path\n");
    assert!(m.contains("line 1"), "{m}");
}

#[test]
fn a_text_in_place_of_a_number_is_told_as_that() {
    let mut file = JobFile::default();
    for (assignment, told) in [
        ("tool.radius_mm=2,5", "`2,5` is not a number: write 2.5, with a point"),
        ("tool.radius_mm=2mm", "`2mm` is not a number: write 2, the unit is the key's"),
        ("machine.b_deg=5°", "`5°` is not a number: write 5, the unit is the key's"),
        ("tool.radius_mm=.5", "`.5` is not a number: write 0.5, with a digit before the point"),
        ("machine.b_deg=-.5", "`-.5` is not a number: write -0.5, with a digit before the point"),
        ("tool.radius_mm=wide", "`wide` is not a number"),
    ] {
        let e = file.set(assignment).unwrap_err();
        assert!(e.message.ends_with(told) && e.message.contains(assignment), "{}", e.message);
    }
    // What is wrong otherwise has other words.
    assert!(!file.set("schedule.kind=2mm").unwrap_err().message.contains("is not a number"));
}

#[test]
fn set_changes_one_key_and_leaves_the_job_alone_on_errors() {
    let mut job = JobFile::from_model(Path::new("blade.step"));
    job.set("path.scallop_mm=0.02").unwrap();
    job.set("model.axis = -z").unwrap();
    job.set("tool.radius_mm=8").unwrap();
    job.set("tool.holder=[{radius_mm=20, length_mm=50}]").unwrap();
    job.set("tool.holder.0.length_mm=60.5").unwrap();
    job.set("post.control=[\"linuxcnc\"]").unwrap();
    assert_eq!(job.path.as_ref().unwrap().scallop_mm, Some(0.02));
    assert_eq!(job.model.as_ref().unwrap().axis, Some(AxisChoice::Direction([0.0, 0.0, -1.0])));
    assert_eq!(job.tool.as_ref().unwrap().radius_mm, Some(8.0));
    assert_eq!(job.tool.as_ref().unwrap().holder.as_ref().unwrap()[0].length_mm, 60.5);
    let before = job.clone();
    for bad in [
        "path.scalop_mm=1",
        "path.scallop_mm=big",
        "path.scallop_mm",
        "scallop_mm=1",
        "tool.holder.3.radius_mm=1",
        "path.scallop_mm.x=1",
        ".=1",
        "path.kind=spiral",
        "=",
        "path.scallop_mm=",
    ] {
        let e = job.set(bad).unwrap_err();
        assert_eq!(e.kind, ErrorKind::Usage);
        assert!(e.message.contains(bad), "{e}");
        assert_eq!(job, before);
    }
    for (bad, hint) in [
        ("tool.radius_mm=2,5", "write 2.5, with a point"),
        ("tool.radius_mm=2mm", "write 2, the unit is the key's"),
        ("fixture.file=v.stl", "fixture.0.file"),
    ] {
        let e = job.set(bad).unwrap_err();
        assert!(e.message.contains(hint), "{e}");
        assert_eq!(job, before);
    }
    let mut fixed = before.clone();
    fixed.set("fixture.0.file=v.stl").unwrap();
    assert_eq!(fixed.fixture.unwrap()[0].file.as_deref(), Some("v.stl"));
    let e = job.set("path.scalop_mm=1").unwrap_err();
    assert!(e.message.contains("scallop_mm"), "{e}");
}

#[test]
fn missing_model_and_impossible_values_are_refused_before_the_model_is_read() {
    let here = Path::new("/base");
    let kind = |text: &str| resolve(parse(text, "t").unwrap(), here).unwrap_err();
    assert!(kind("").message.contains("model.file"));
    for (text, key) in [
        ("[tool]\nradius_mm = 0", "tool.radius_mm"),
        ("[tool]\nradius_mm = nan", "tool.radius_mm"),
        ("[tool]\nradius_mm = 4\ncorner_radius_mm = 5", "it must not be greater than tool.radius_mm, 4"),
        ("[tool]\nradius_mm = 4\ncorner_radius_mm = 0", "at least 0.05: flat end mills have a small corner too"),
        ("[tool]\nradius_mm = 4\ncorner_radius_mm = nan", "tool.corner_radius_mm is NaN"),
        ("[tool]\ncorner_radius_mm = 1", "without tool.radius_mm"),
        ("[path]\nscallop_mm = 0", "path.scallop_mm"),
        ("[path]\nscallop_mm = -0.01", "path.scallop_mm"),
        ("[path]\nscallop_mm = 0.000001", "path.scallop_mm"),
        ("[path]\nchord_mm = inf", "path.chord_mm"),
        ("[tool]\nlibrary = \"t.json\"", "tool.library"),
    ] {
        let e = kind(&format!("model.file = \"a.stl\"\n{text}"));
        assert_eq!(e.kind, ErrorKind::Usage);
        assert!(e.message.contains(key), "{e}");
    }
    let draft = resolve(parse("model.file = \"a.stl\"", "t").unwrap(), here).unwrap();
    assert_eq!(draft.model().file, Path::new("/base/a.stl"));
    assert_eq!(draft.model().axis, AxisChoice::Auto);
}

#[test]
fn schema_in_git_is_the_schema_of_the_program() {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("models/job.schema.json");
    let now = format!("{}\n", serde_json::to_string_pretty(&schema()).unwrap());
    if std::env::var_os("BLADEWRIGHT_REGENERATE").is_some() {
        std::fs::write(&path, &now).unwrap();
    }
    let saved = std::fs::read_to_string(&path).unwrap_or_default();
    assert!(
        saved == now,
        "models/job.schema.json differs: run the tests once with BLADEWRIGHT_REGENERATE=1 and look at the change"
    );
}

#[test]
fn example_jobs_name_models_that_exist() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("examples/jobs");
    let files: Vec<_> = std::fs::read_dir(&folder).unwrap().map(|e| e.unwrap().path()).collect();
    assert!(files.len() >= 3);
    for file in files {
        let draft = resolve(parse(&std::fs::read_to_string(&file).unwrap(), "example").unwrap(), &folder).unwrap();
        assert!(draft.model().file.is_file(), "{} names {}", file.display(), draft.model().file.display());
    }
}

mod with_blade {
    use super::*;
    use crate::artifact::Blade;
    use crate::artifact::blade::{Diagnosis, Unit};
    use crate::artifact::region::Regions;
    use crate::geometry::mesh::Mesh;
    use crate::geometry::part::Part;
    use crate::geometry::{Point, Rigid};
    use crate::observe::Doubt;

    /// A lens-shaped column along x: chord `c`, two circular arcs of radius `r`, height 100 mm.
    fn lens(c: f64, r: f64) -> Blade {
        let half = (c / 2.0 / r).asin();
        let arc = |k: i32, n: i32, up: f64| {
            let a = -half + 2.0 * half * f64::from(k) / f64::from(n);
            (r * a.sin() * up, up * (r * a.cos() - r * half.cos()))
        };
        let n = 60;
        let ring: Vec<(f64, f64)> = (0..n).map(|k| arc(k, n, -1.0)).chain((0..n).map(|k| arc(k, n, 1.0))).collect();
        let ring: Vec<_> = ring.into_iter().rev().collect();
        let m = ring.len() as u32;
        let layers = 40u32;
        let mut mesh = Mesh::default();
        for l in 0..=layers {
            mesh.points.extend(ring.iter().map(|(y, z)| Point::new(100.0 * f64::from(l) / f64::from(layers), *y, *z)));
        }
        for l in 0..layers {
            for k in 0..m {
                let (a, b) = (l * m + k, l * m + (k + 1) % m);
                mesh.triangles.push([a, b, b + m]);
                mesh.triangles.push([a, b + m, a + m]);
            }
        }
        Blade {
            name: "lens".into(),
            unit: Unit::Mm,
            part: Part::from_mesh(mesh),
            model_from_blade: Rigid::identity(),
            regions: Regions::at_heights([0.0, 100.0], [0.0, 100.0], None),
            wheel: None,
            diagnosis: Diagnosis::default(),
        }
    }
    fn complete(text: &str, blade: &Blade) -> crate::error::Result<Job> {
        resolve(parse(&format!("model.file = \"a.stl\"\n{text}"), "t").unwrap(), Path::new("/b"))
            .unwrap()
            .complete(blade)
    }

    #[test]
    fn the_resolved_job_runs_again_as_it_is() {
        let blade = lens(60.0, 80.0);
        let typed =
            "model.axis = [1, 2, 2]\n[region]\nstart_mm = 30\nend_mm = 7.3\n[tool]\nradius_mm = 2.7\nholder = []";
        for text in ["", typed] {
            let job = complete(text, &blade).unwrap();
            let again = parse(&job.to_toml().unwrap(), "resolved").unwrap();
            let back = resolve(again, Path::new("/elsewhere")).unwrap().complete(&blade).unwrap();
            assert_eq!(job, back);
            assert_eq!(job.to_toml().unwrap(), back.to_toml().unwrap());
        }
    }

    #[test]
    fn default_radius_follows_chord_and_scale() {
        let a = complete("", &lens(60.0, 80.0)).unwrap();
        assert_eq!(a.tool.radius_mm, 4.0); // 7 % of 60 mm is 4.2 mm
        let b = complete("", &lens(20.0, 27.0)).unwrap();
        assert_eq!(b.tool.radius_mm, 1.0); // 7 % of 20 mm is 1.4 mm
        assert!(a.tool.stickout_mm > 30.0 && a.region.start_mm == 30.0);
    }

    fn settle(text: &str, blade: &Blade) -> (Job, Chosen) {
        let typed = parse(&format!("model.file = \"a.stl\"\n{text}"), "t").unwrap();
        resolve(typed, Path::new("/b")).unwrap().settle(blade).unwrap()
    }

    /// The default tool is one of the catalogue's, whatever the part asks for, and the run
    /// names what it leaves.
    #[test]
    fn a_default_tool_can_be_bought_and_says_what_it_leaves() {
        let (job, chosen) = settle("", &lens(60.0, 80.0));
        assert!(chosen.warnings.is_empty(), "{:?}", chosen.warnings);
        assert!(chosen.why.contains("7 % of the chord") && chosen.in_words().contains("ball R 4 mm"), "{chosen:?}");
        let tool = job.tool;
        assert_eq!((tool.shank_radius_mm, tool.holder[0].radius_mm, tool.holder[1].radius_mm), (6.0, 14.0, 16.0));
        // An airfoil for a ball that nobody sells.
        let (job, chosen) = settle("", &lens(2.0, 2.7));
        assert_eq!((job.tool.radius_mm, job.tool.shank_radius_mm, job.tool.holder[0].radius_mm), (0.5, 3.0, 12.0));
        assert!(
            chosen.warnings[0].to_string().contains("0.14 mm, 7 % of its chord of 2.000 mm at height 15.0 mm"),
            "{chosen:?}"
        );
        // A small airfoil far inside a wide part: no slender needle, but the smallest ball that is
        // sold long enough.
        let mut wide = lens(20.0, 27.0);
        let n = wide.part.mesh.points.len() as u32;
        let mut mesh = wide.part.mesh.clone();
        mesh.points.extend([[0.0, 90.0, 0.0], [0.0, 89.0, 0.0], [0.0, 90.0, 1.0]].map(Point::from));
        mesh.triangles.push([n, n + 1, n + 2]);
        wide.part = Part::from_mesh(mesh);
        let (job, chosen) = settle("", &wide);
        assert!(job.tool.radius_mm == 2.0 && job.tool.stickout_mm <= 20.0 * job.tool.shank_radius_mm, "{:?}", job.tool);
        assert!(chosen.warnings[0].to_string().contains("2 mm is the smallest that is sold long enough"), "{chosen:?}");
        // Wider than anything that is sold.
        for p in &mut wide.part.mesh.points {
            p.y *= 10.0;
        }
        let (job, chosen) = settle("", &wide);
        assert!(
            job.tool.stickout_mm <= 320.0
                && chosen.warnings.iter().any(|w| w.to_string().contains("at most, which is taken"))
        );
        let (job, _) = settle("tool.stickout_mm = 700", &wide);
        assert_eq!(job.tool.stickout_mm, 700.0, "what was asked for stays");
    }

    /// A slit is reported with its place and has no say; nor has damage of a mesh.
    #[test]
    fn slits_and_damage_have_no_say_in_the_tool() {
        // Two columns a fifth of a millimetre apart.
        let mut blade = lens(60.0, 80.0);
        let up = blade.part.mesh.points.iter().map(|p| p.z).fold(0.0, f64::max);
        let n = blade.part.mesh.points.len() as u32;
        let mut mesh = blade.part.mesh.clone();
        mesh.points.extend(blade.part.mesh.points.iter().map(|p| Point::new(p.x, p.y, p.z + 2.0 * up + 0.2)));
        mesh.triangles.extend(blade.part.mesh.triangles.iter().map(|t| t.map(|k| k + n)));
        blade.part = Part::from_mesh(mesh);
        blade.model_from_blade = Rigid::translation(1000.0, 0.0, 0.0);
        let told = settle("", &blade).1.warnings.iter().map(Doubt::to_string).collect::<Vec<_>>().join("\n");
        for words in ["not even a ball of 0.5 mm has room", "tightest at (10"] {
            assert!(told.contains(words), "{words} is not in {told}");
        }
        assert!(complete("tool.radius_mm = 0.25", &blade).is_ok());
        // Many tiny triangles lie on the wall upside down: a quarter of all triangles, and next to
        // no area.
        let whole = lens(60.0, 80.0);
        let mut damaged = whole.clone();
        let mut mesh = whole.part.mesh.clone();
        for k in 0..3000 {
            let base = mesh.points.len() as u32;
            let at = Point::new(10.0 + 0.005 * f64::from(k), 5.0, 5.69);
            mesh.points.extend([at, Point::new(at.x + 0.001, at.y, at.z), Point::new(at.x, at.y - 0.001, at.z)]);
            mesh.triangles.push([base, base + 1, base + 2]);
        }
        damaged.part = Part::from_mesh(mesh);
        assert_eq!(settle("", &damaged).0.tool, settle("", &whole).0.tool);
    }

    /// Along a wall nothing but the walls of the moves keeps the tool from the part between two
    /// locations.
    #[test]
    fn schedules_along_a_wall_have_their_moves_proven() {
        let blade = lens(60.0, 80.0);
        for (text, proven) in [
            ("", false),
            ("schedule.kind = \"optimal\"", false),
            ("schedule.kind = \"lower-wall\"", true),
            ("schedule.kind = \"upper-wall\"", true),
            ("schedule.kind = \"upper-wall\"\nchannel.prove_moves = false", false),
        ] {
            assert_eq!(complete(text, &blade).unwrap().channel.prove_moves, proven, "{text}");
        }
    }

    #[test]
    fn values_outside_the_part_or_their_limits_are_named() {
        let blade = lens(60.0, 80.0);
        for (text, key) in [
            ("[region]\nstart_mm = 300", "region.start_mm"),
            ("[region]\nstart_mm = 10\nend_mm = 20", "region.end_mm"),
            ("[region]\nreference = \"platform\"", "region.reference"),
            ("[tool]\ntaper_deg = 50", "tool.taper_deg"),
            ("[tool]\nholder = [{radius_mm = -1, length_mm = 4}]", "holder"),
            ("[channel]\ncontact_angle_min_deg = 80\ncontact_angle_max_deg = 70", "contact_angle_max_deg"),
            ("[machine]\nb_deg = 88", "machine.b_deg"),
            ("[feed]\nfeed_mm_min = 0", "feed.feed_mm_min"),
            ("[post]\ncontrol = []", "post.control"),
            ("[section]\ncount = 0", "section.count"),
            ("[schedule]\nmargin_deg = nan", "schedule.margin_deg"),
        ] {
            let e = complete(text, &blade).unwrap_err();
            assert_eq!(e.kind, ErrorKind::Usage, "{e}");
            assert!(e.message.contains(key), "{e}");
        }
    }
}
