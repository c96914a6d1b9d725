#![allow(clippy::unwrap_used)]

use std::path::Path;

use super::columns::{TableCell, columns};
use super::*;

fn write(dir: &Path, name: &str, text: &str) {
    let path = dir.join(name);
    std::fs::create_dir_all(path.parent().unwrap()).unwrap();
    std::fs::write(path, text).unwrap();
}

fn family(dir: &Path, text: &str) -> Result<Family> {
    write(dir, "family.toml", text);
    Family::load(&dir.join("family.toml"))
}

fn names(f: &Family) -> Vec<&str> {
    f.members.iter().map(|m| m.name.as_str()).collect()
}

/// The family is refused in one sentence that has all the words, with the exit code.
fn refused(dir: &Path, text: &str, code: u8, words: &[&str]) {
    let e = family(dir, text).unwrap_err();
    assert_eq!(e.kind.exit_code(), code, "{e}");
    assert!(!e.message.contains('\n'), "{e}");
    for w in words {
        assert!(e.message.contains(w), "`{w}` is not in: {e}");
    }
}

#[test]
fn files_of_a_template_lie_beside_the_family() {
    let dir = tempfile::tempdir().unwrap();
    write(dir.path(), "a/blade.stl", "solid");
    let text = "models = \"a/*.stl\"\n[template]\ntool = { library = \"t.json\" }\nstock = { file = \"s.stl\" }\n\
                [[template.fixture]]\nfile = \"f.stl\"";
    let job = family(dir.path(), text).unwrap().members[0].job.clone();
    let files = [job.tool.unwrap().library, job.stock.unwrap().file, job.fixture.unwrap()[0].file.clone()];
    for (file, name) in files.into_iter().zip(["t.json", "s.stl", "f.stl"]) {
        assert_eq!(Path::new(&file.unwrap()), dir.path().join(name));
    }
}

#[test]
fn bad_input_is_told_in_one_sentence() {
    let dir = tempfile::tempdir().unwrap();
    let d = dir.path();
    for (name, text) in [
        ("a/blade.stl", "solid"),
        ("b/blade.obj", "v"),
        ("no_name.csv", "model,tool.radius_mm\na/blade.stl,3\n"),
        ("no_model.csv", "name,tool.radius_mm\nx,3\n"),
        ("short.csv", "name,model,tool.radius_mm\nx,a/blade.stl\n"),
        ("twice.csv", "name,model\nx,a/blade.stl\nX,a/blade.stl\n"),
        ("columns.csv", "name,model,model\nx,a/blade.stl,y\n"),
        ("unknown.csv", "name,model,tool.radus_mm\nx,a/blade.stl,3\n"),
        ("empty.csv", ""),
        ("header.csv", "name,model\n"),
    ] {
        write(d, name, text);
    }
    refused(d, "models = \"*.step\"", 2, &["no file matches", "*.step"]);
    refused(d, "models = \"**/blade.*\"", 2, &["blade", "comes twice"]);
    refused(d, "models = \"a/*.stl\"\n[ranges]\n\"tool.radus_mm\" = [1]", 2, &["tool.radus_mm", "unknown"]);
    refused(d, "models = \"a/*.stl\"\n[ranges]\nradius = [1]", 2, &["`radius`", "unknown"]);
    refused(d, "models = \"a/*.stl\"\nthreads = 2", 2, &["family.toml, line 2", "threads"]);
    refused(d, "models = \"a/*.stl\"\n[template.tool]\nradius = 2", 2, &["radius"]);
    refused(d, "models = \"a/*.stl\"\njob = \"family.toml\"", 2, &["family.toml", "cyclic"]);
    refused(d, "models = \"a/*.stl\"\ndesign = \"prism\"", 2, &["models", "design"]);
    refused(d, "models = \"a/*.stl\"\n[ranges]\n\"vary.twist_deg\" = [1]", 2, &["vary.twist_deg", "not a design"]);
    refused(d, "design = \"prism\"", 2, &["nothing that varies"]);
    refused(d, "design = \"steam\"\n[ranges]\n\"tool.radius_mm\" = [1]", 4, &["steam", "neither"]);
    refused(d, "[template.tool]\nradius_mm = 2", 2, &["no blades"]);
    refused(d, "table = \"none.csv\"", 4, &["none.csv"]);
    refused(d, "table = \"no_name.csv\"", 2, &["no_name.csv", "no column `name`"]);
    refused(d, "table = \"no_model.csv\"", 2, &["no_model.csv", "no column `model`"]);
    refused(d, "table = \"short.csv\"", 2, &["short.csv", "line 2", "2 cells"]);
    refused(d, "table = \"twice.csv\"", 2, &["name X comes twice"]);
    refused(d, "table = \"columns.csv\"", 2, &["`model` comes twice"]);
    refused(d, "table = \"unknown.csv\"", 2, &["line 2", "tool.radus_mm"]);
    refused(d, "table = \"empty.csv\"", 2, &["empty.csv", "empty"]);
    refused(d, "table = \"header.csv\"", 2, &["no rows"]);
    let two =
        "combine = \"list\"\ndesign = \"prism\"\n[ranges]\n\"tool.radius_mm\" = [1, 2]\n\"feed.feed_mm_min\" = [1]";
    refused(d, two, 2, &["as many", "tool.radius_mm has 2", "feed.feed_mm_min has 1"]);
    let bad = "design = \"prism\"\n[ranges]\n\"tool.radius_mm\" = { from = 1, to = 2, step = 3 }";
    refused(d, bad, 2, &["step"]);
    refused(d, "design = \"prism\"\n[ranges]\n\"tool.radius_mm\" = []", 2, &["empty"]);
    let huge = "design = \"prism\"\n[ranges]\n\"tool.radius_mm\" = { from = 1, to = 2, count = 99999 }\n\"feed.feed_mm_min\" = [1, 2]";
    refused(d, huge, 2, &["100000"]);
    let change = "models = \"a/*.stl\"\n[[override]]\nmembers = \"c*\"\nset = { \"tool.radius_mm\" = 1 }";
    refused(d, change, 2, &["override", "c*"]);
    let e = Family::load(&d.join("none.toml")).unwrap_err();
    assert_eq!(e.kind, ErrorKind::InputOutput);
}

#[test]
#[cfg(unix)]
fn cyclic_paths_are_told() {
    let dir = tempfile::tempdir().unwrap();
    let d = dir.path();
    write(d, "a/blade.stl", "solid");
    std::os::unix::fs::symlink(d.join("loop.stl"), d.join("loop.stl")).unwrap();
    refused(d, "models = \"*.stl\"", 2, &["loop.stl", "cyclic"]);
    std::os::unix::fs::symlink(d.join("a"), d.join("a/back")).unwrap();
    refused(d, "models = \"a/*/*.stl\"\njob = \"family.toml\"", 2, &["cyclic"]);
    refused(d, "models = [\"a/*.stl\", \"a/back/*.stl\"]", 2, &["blade.stl", "cyclic"]);
    let f = family(d, "models = \"a/*.stl\"").unwrap();
    let e = run(&f, &d.join("a").display().to_string(), &BatchOptions::default(), &Silent).unwrap_err();
    assert!(e.kind == ErrorKind::Usage && e.message.contains("feed on itself"), "{e}");
}

#[test]
fn members_of_a_grid_a_list_a_table_and_patterns() {
    let dir = tempfile::tempdir().unwrap();
    let d = dir.path();
    write(d, "job.toml", "[model]\nfile = \"x.step\"\n[tool]\nradius_mm = 3\n[post]\nfiles = [\"mine.toml\"]\n");
    let grid = "design = \"compressor_twist\"\n[ranges]\n\"vary.twist_deg\" = [-5, 5]\n\
                \"tool.radius_mm\" = { from = 2, to = 2.2, count = 3 }";
    let f = family(d, grid).unwrap();
    assert_eq!(names(&f)[..3], ["radius_mm-2_twist_deg--5", "radius_mm-2_twist_deg-5", "radius_mm-2.1_twist_deg--5"]);
    assert_eq!(f.members.len(), 6);
    let BladeSource::Design(made) = &f.members[1].source else { panic!("made") };
    assert_eq!(made.name, "twist_deg-5", "blades are called by what makes them differ");
    let list = "combine = \"list\"\njob = \"job.toml\"\n[ranges]\n\"tool.radius_mm\" = [1, 2]\n\"path.scallop_mm\" = [0.1, 0.2]\n\
                [[override]]\nmembers = \"*radius_mm-2\"\nset = { \"feed.feed_mm_min\" = 99 }";
    let f = family(d, list).unwrap();
    assert_eq!(names(&f), ["scallop_mm-0.1_radius_mm-1", "scallop_mm-0.2_radius_mm-2"]);
    let jobs: Vec<_> = f.members.iter().map(|m| &m.job).collect();
    assert_eq!(jobs[0].feed, None);
    assert_eq!(jobs[1].feed.as_ref().unwrap().feed_mm_min, Some(99.0));
    assert_eq!(f.members[0].source, BladeSource::Model(std::path::absolute(d.join("x.step")).unwrap()));
    let post = jobs[0].post.as_ref().unwrap().files.as_ref().unwrap();
    assert_eq!(post[..], [d.join("mine.toml").display().to_string()], "paths are those of the template's folder");
    write(
        d,
        "t/t.csv",
        "# comment\nname, model, tool.radius_mm, schedule.kind\none, a.stl, 4,\ntwo, b.stl, , optimal\n",
    );
    let f = family(d, "table = \"t/t.csv\"\njob = \"job.toml\"\n[template.path]\nscallop_mm = 0.5").unwrap();
    assert_eq!(names(&f), ["one", "two"]);
    assert_eq!(f.members[0].source, BladeSource::Model(d.join("t/a.stl")));
    let radius = |k: usize| f.members[k].job.tool.as_ref().unwrap().radius_mm.unwrap();
    assert_eq!([radius(0), radius(1)], [4.0, 3.0]);
    assert_eq!(f.members[1].job.path.as_ref().unwrap().scallop_mm, Some(0.5));
    assert_eq!(f.members[1].parameters.keys().collect::<Vec<_>>(), ["schedule.kind"]);
    write(d, "m/b blade.stl", "");
    write(d, "m/a.stl", "");
    let f = family(d, "models = [\"m/*.stl\", \"m/a.*\"]\n[ranges]\n\"tool.radius_mm\" = [1]").unwrap();
    assert_eq!(names(&f), ["a_radius_mm-1", "b_blade_radius_mm-1"]);
}

#[test]
fn an_address_follows_from_contents_alone() {
    let dir = tempfile::tempdir().unwrap();
    let d = dir.path();
    let text = "models = \"DIR/*.stl\"\n[template]\ntool = { library = \"t.json\" }\nfixture = [{ file = \"f.stl\" }]\n\
         [template.machine]\nfile = \"machine.toml\"\n[template.feed]\nfeed_mm_min = 100";
    for (folder, model) in [("a", "one"), ("b", "one"), ("c", "two")] {
        write(d, &format!("{folder}/blade.stl"), model);
    }
    write(d, "machine.toml", "first");
    let of = |text: &str| {
        let f = family(d, text).unwrap();
        address::address(&f.members[0], &Contents::default()).unwrap()
    };
    let at = |folder: &str| of(&text.replace("DIR", folder));
    let first = at("a");
    assert_eq!(first, at("b"), "where a file lies does not matter");
    assert_ne!(first.key, at("c").key);
    let faster = of(&text.replace("DIR", "a").replace("100", "200"));
    assert!(first.key != faster.key && first.group == faster.group, "the feed alone leaves path and channel");
    write(d, "machine.toml", "second");
    let second = at("a");
    assert!(first.key != second.key && first.group == second.group);
    for file in ["t.json", "f.stl"] {
        let before = at("a");
        write(d, file, "another");
        let after = at("a");
        assert!(before.key != after.key && before.group != after.group, "{file} decides on path and channel");
    }
}

#[test]
fn schema_in_git_is_the_schema_of_the_program() {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("models/family.schema.json");
    let now = format!("{}\n", serde_json::to_string_pretty(&schema()).unwrap());
    if std::env::var_os("BLADEWRIGHT_REGENERATE").is_some() {
        std::fs::write(&path, &now).unwrap();
    }
    let saved = std::fs::read_to_string(&path).unwrap_or_default();
    assert!(saved == now, "models/family.schema.json differs: run the tests once with BLADEWRIGHT_REGENERATE=1");
}

fn record(name: &str, summary: serde_json::Value) -> Record {
    let mut r = Record::missing(name, "m.step", &BTreeMap::new());
    (r.status, r.summary) = (Status::Good, Some(summary));
    r
}

#[test]
fn a_part_has_one_process_and_its_successor_waits_for_it_to_go() {
    let dir = tempfile::tempdir().unwrap();
    let d = dir.path();
    let first = store::Folder::open(d, "shard-1-of-2").unwrap();
    assert!(store::Folder::open(d, "shard-2-of-2").is_ok(), "another part");
    let e = store::Folder::open(d, "shard-1-of-2").err().expect("taken");
    assert_eq!(e.kind.exit_code(), 4, "a moment's trouble, no outcome of the family: {e}");
    let dying = std::thread::spawn(move || {
        std::thread::sleep(std::time::Duration::from_millis(300));
        drop(first);
    });
    assert!(store::Folder::open(d, "shard-1-of-2").is_ok());
    dying.join().unwrap();
}

#[test]
fn tables_hold_every_figure_and_come_back() {
    use parquet::file::reader::{FileReader, SerializedFileReader};
    use parquet::record::RowAccessor;
    let axes = |v: f64| serde_json::json!([{ "axis": "X", "velocity": v }]);
    let a = serde_json::json!({ "turns": 3, "time": 1.5, "passed": true, "region": [1.0, 2.0],
        "schedules": [{ "kind": "piecewise", "axes": axes(7.0) }, { "kind": "fixed", "axes": axes(9.0) }] });
    let mut failed = Record::missing("c,\"d\"", "n.step", &BTreeMap::new());
    (failed.status, failed.reason) = (Status::Failed, Some("why, \"really\"".into()));
    let mut varied = record("b", serde_json::json!({ "turns": 4, "time": 2 }));
    varied.parameters.insert("tool.radius_mm".into(), serde_json::json!(2.5));
    let all = columns(&[record("a", a), varied, failed]);
    let find = |name: &str| &all.iter().find(|c| c.name == name).unwrap_or_else(|| panic!("{name}")).cells;
    assert_eq!(find("turns")[..], [TableCell::Integer(3), TableCell::Integer(4), TableCell::Empty]);
    assert_eq!(find("time")[..], [TableCell::Number(1.5), TableCell::Number(2.0), TableCell::Empty]);
    assert_eq!(find("schedules.used.axes.X.velocity")[0], TableCell::Number(7.0));
    assert_eq!(find("schedules.fixed.axes.X.velocity")[0], TableCell::Number(9.0));
    assert_eq!(find("region.1")[0], TableCell::Number(2.0));
    assert_eq!(find("tool.radius_mm")[1], TableCell::Number(2.5));

    let text = String::from_utf8(tables::csv(&all).unwrap()).unwrap();
    let mut reader = csv::Reader::from_reader(text.as_bytes());
    let headers = reader.headers().unwrap().clone();
    let rows: Vec<_> = reader.records().map(|r| r.unwrap()).collect();
    let cell = |row: usize, name: &str| &rows[row][headers.iter().position(|h| h == name).unwrap()];
    assert_eq!((cell(2, "name"), cell(2, "reason")), ("c,\"d\"", "why, \"really\""));
    assert_eq!((cell(0, "passed"), cell(2, "time")), ("true", ""));

    let bytes = tables::parquet(&all).unwrap();
    assert_eq!(bytes, tables::parquet(&all).unwrap());
    let dir = tempfile::tempdir().unwrap();
    std::fs::write(dir.path().join("family.parquet"), bytes).unwrap();
    let file = SerializedFileReader::new(std::fs::File::open(dir.path().join("family.parquet")).unwrap()).unwrap();
    let rows: Vec<_> = file.get_row_iter(None).unwrap().map(|r| r.unwrap()).collect();
    let at = |name: &str| all.iter().position(|c| c.name == name).unwrap();
    assert_eq!(rows.len(), 3);
    assert_eq!(rows[0].get_long(at("turns")).unwrap(), 3);
    assert_eq!(rows[1].get_double(at("time")).unwrap(), 2.0);
    assert!(rows[2].get_double(at("time")).is_err(), "empty");
    assert!(rows[0].get_bool(at("passed")).unwrap());
    assert_eq!(rows[2].get_string(at("reason")).unwrap(), "why, \"really\"");
}

#[test]
fn a_page_cannot_be_broken_by_names() {
    let mut r = record("x</script><b>", serde_json::json!({ "turns": 1 }));
    r.reason = Some("<!-- </script>".into());
    r.files.insert("report.html".into(), String::new());
    let page = page::html("a<b", &[r.clone()], &columns(&[r])).unwrap();
    assert_eq!(page.matches("</script>").count(), 2, "only its own");
    assert!(page.contains("members/x%3C%2Fscript%3E%3Cb%3E/report.html") && page.contains("<title>a&lt;b"));
}

#[test]
fn example_families_are_families() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("examples/families");
    let twist = Family::load(&folder.join("twist.toml")).unwrap();
    assert_eq!(twist.members.len(), 12);
    let wide = |m: &&Member| m.job.channel.as_ref().is_some_and(|c| c.clearance_mm == Some(0.2));
    assert_eq!(twist.members.iter().filter(wide).count(), 4);
    let stages = Family::load(&folder.join("stages.toml")).unwrap();
    assert_eq!(names(&stages), ["turbine", "turbine_coarse", "compressor", "steam"]);
    assert!(stages.members.iter().all(|m| matches!(&m.source, BladeSource::Model(p) if p.is_file())));
}
