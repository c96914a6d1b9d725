//! Rows of two tools: both sides against the part, the table's angles against tools that stand
//! there, planted faults, refusals.

use std::path::Path;
use std::process::{Command, Output};
use std::sync::OnceLock;

use bladewright::artifact::check_id::CheckId;
use bladewright::artifact::report::Check;
use bladewright::artifact::{PairedRows, Stand};
use bladewright::job::JobFile;
use bladewright::observe::Silent;
use bladewright::plan::Setup;
use bladewright::plan::pinch::{Pinch, PinchProgrammed};
use bladewright::run::Loaded;
use bladewright::run::inputs;
use bladewright::verify::{self, PinchWork};

const MODEL: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/models/turbine_camber.step");
const TWO_HEADS: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/models/machines/pinch_9x.toml");
const KEYS: [&str; 3] = ["tool.radius_mm=2", "path.scallop_mm=0.1", "pinch.heights_mm=[6, 34]"];

fn plan_for(more: &[&str]) -> (Setup, Pinch) {
    let mut job = JobFile::from_model(Path::new(MODEL));
    KEYS.iter().chain(more).for_each(|key| job.set(key).expect("a key"));
    let draft = inputs::draft(job, Path::new("")).expect("a draft");
    let setup = Loaded::read(&draft, &Silent).expect("a blade").setup;
    let pinch = setup.pinch(&Silent).expect("rows");
    (setup, pinch)
}

fn planned() -> &'static (Setup, Pinch) {
    static PLANNED: OnceLock<(Setup, Pinch)> = OnceLock::new();
    PLANNED.get_or_init(|| {
        // On a thread of its own, since a thread of the pool that waits for the lock may take it up
        // again.
        std::thread::scope(|s| s.spawn(|| plan_for(&[])).join().expect("planned"))
    })
}

#[test]
fn contacts_face_each_other_and_the_table_stands_still() {
    let (setup, pinch) = planned();
    let failed: Vec<&Check> = pinch.checks.iter().filter(|c| !c.passed).collect();
    assert!(failed.is_empty(), "{failed:?}");
    let (rows, part) = (&pinch.rows, &setup.blade.part);
    assert!(rows.rows.len() > 20 && pinch.still_rows() == rows.rows.len(), "{} rows", rows.rows.len());
    for place in &rows.places {
        let [a, b] = place.contacts;
        for c in [a, b] {
            let near = part.closest(&c.centre, 10.0).expect("near the part");
            assert!((near.distance_mm - 2.0).abs() < 1e-5 && (near.point - c.contact).norm() < 1e-4);
        }
        // Both normals lead to the middle of the ball between them.
        for c in [a, b] {
            let foot = c.contact - c.normal * place.held_radius_mm;
            assert!((foot - place.held_centre).norm() < 1e-5, "{place:?}");
        }
        let lacks = std::f64::consts::PI - a.normal.angle(&b.normal);
        assert!(lacks <= 40f64.to_radians() + 1e-9 && (lacks - place.angle_rad).abs() < 1e-6);
    }
    // The binding side of each row is as high as asked for; no row is over it.
    let [one, two] = pinch.figures.ridges_mm;
    assert!((0.093..0.103).contains(&one[1].max(two[1])), "{one:?} {two:?}");
    assert!(one[3].max(two[3]) < 0.103, "{one:?} {two:?}");
}

/// What is said to be free is clear of the part, and what is said not to be is not.
#[test]
fn free_angles_are_those_at_which_tools_stand_clear() {
    let (setup, pinch) = planned();
    let (tool, channel) = (&setup.job.tool, &setup.job.channel);
    let [cutter, holder] = tool.cutter_and_holder();
    let part = &setup.blade.part;
    let cones = setup.pinch_cones();
    let (mut free, mut taken) = (0, 0);
    for k in (0..pinch.rows.places.len()).step_by(pinch.rows.places.len() / 24) {
        for (j, cone) in cones.iter().enumerate() {
            let c = &pinch.rows.places[k].contacts[j];
            for n in 0..60 {
                let table = f64::from(n).to_radians() * 6.0;
                let theta = table + if j == 0 { 0.0 } else { std::f64::consts::PI };
                let stand = Stand { centre: c.centre, cone: *cone, theta };
                let margin = pinch.own[j][k].margin(table);
                // At the ends it is a matter of the tolerance.
                if margin.abs() < 0.01 {
                    continue;
                }
                let apart = |segments: &[_], room: f64| {
                    verify::standing(part, segments, &stand, 0.001).map_or(f64::INFINITY, |s| s.distance_mm) - room
                };
                let least = apart(&cutter, channel.clearance_mm).min(apart(&holder, channel.holder_clearance_mm));
                if margin > 0.0 {
                    assert!(least > -0.002, "place {k}, tool {}, {table}: {least}", j + 1);
                    free += 1;
                } else {
                    // Besides, the contact angle is at most 90 degrees.
                    let under = cone.tool_axis(theta).dot(&c.normal) < 0.01;
                    assert!(
                        under || least < 3.0 * part.deflection_mm + 0.01,
                        "place {k}, tool {}, {table}: {least}",
                        j + 1
                    );
                    taken += 1;
                }
            }
        }
        let both = pinch.own[0][k].and(&pinch.own[1][k]);
        assert_eq!(both, pinch.common[k]);
    }
    assert!(free > 300 && taken > 300, "{free} {taken}");
}

/// What is found wrong with rows after a change.
fn faults(change: impl FnOnce(&mut PairedRows, &mut Vec<(std::ops::Range<usize>, f64)>, &mut f64)) -> Vec<CheckId> {
    let (setup, pinch) = planned();
    let mut rows = pinch.rows.clone();
    let mut held = pinch.stretches();
    let mut between_rad = std::f64::consts::PI;
    change(&mut rows, &mut held, &mut between_rad);
    let work = PinchWork { between_rad, rows: &rows, ..setup.pinch_work(pinch, &held) };
    let (checks, _) = verify::check_pinch(&work, &setup.verify_options());
    checks.into_iter().filter(|c| !c.passed).map(|c| c.id).collect()
}

#[test]
fn planted_faults_are_found_and_nothing_else_is() {
    assert_eq!(faults(|_, _, _| {}), []);
    // Tool 2 runs ten places behind.
    let late = faults(|rows, _, _| {
        for row in rows.rows.clone() {
            let second: Vec<_> = rows.places[row.clone()].iter().map(|p| p.contacts[1]).collect();
            for (n, k) in row.enumerate() {
                rows.places[k].contacts[1] = second[n.saturating_sub(10)];
            }
        }
    });
    assert_eq!(late, [CheckId::Opposition]);
    // The second head stands 0.05 mm nearer than it should.
    let near = faults(|rows, _, _| {
        rows.places.iter_mut().for_each(|p| p.contacts[1].centre -= p.contacts[1].normal * 0.05);
    });
    assert!(near.contains(&CheckId::Gouge), "{near:?}");
    // A row is left out.
    let missing = faults(|_, held, _| {
        held.remove(held.len() / 2);
    });
    assert!(missing.contains(&CheckId::PairRows), "{missing:?}");
    // Every other row is left out of the rows themselves.
    let wide = faults(|rows, held, _| {
        rows.rows = rows.rows.iter().step_by(2).cloned().collect();
        held.retain(|(places, _)| rows.rows.iter().any(|r| r.contains(&places.start)));
    });
    assert!(wide.contains(&CheckId::Ridge), "{wide:?}");
    // The table has turned too far, and the head to the wrong side.
    let turned = faults(|_, held, _| held.iter_mut().for_each(|(_, theta)| *theta += 1.6));
    assert!(turned.contains(&CheckId::Clearance), "{turned:?}");
    let same_side = faults(|_, _, between| *between = 0.3);
    assert!(same_side.contains(&CheckId::ToolsApart) && same_side.contains(&CheckId::Clearance), "{same_side:?}");
}

/// The same rows on a machine with two heads.
fn programmed() -> &'static (Setup, Pinch, PinchProgrammed) {
    static PROGRAMMED: OnceLock<(Setup, Pinch, PinchProgrammed)> = OnceLock::new();
    PROGRAMMED.get_or_init(|| {
        let plan = || {
            let (setup, pinch) = plan_for(&[&format!("machine.file={:?}", TWO_HEADS)]);
            let programmed = setup.pinch_program(&pinch, &Silent).expect("a program").expect("two heads");
            (setup, pinch, programmed)
        };
        std::thread::scope(|s| s.spawn(plan).join().expect("programmed"))
    })
}

/// What is found wrong with the program after a change of its text.
fn program_faults(change: impl FnOnce(&str) -> String) -> Vec<CheckId> {
    let (setup, pinch, programmed) = programmed();
    let held = pinch.stretches();
    let work = setup.pinch_work(pinch, &held);
    let text = change(&programmed.text);
    let checks =
        verify::check_pinch_program(&text, &work, &setup.machine, programmed.motion.cutting_s, &setup.verify_options());
    checks.into_iter().filter(|c| !c.passed).map(|c| c.id).collect()
}

/// The number of a word of a line.
fn word(line: &str, letter: char) -> f64 {
    let word = line.split(' ').find(|w| w.starts_with(letter)).expect("the word");
    word[1..].parse().expect("a number")
}

#[test]
fn a_program_has_nine_letters_and_one_clock() {
    let (setup, pinch, programmed) = programmed();
    let failed: Vec<&Check> = pinch.checks.iter().chain(&programmed.checks).filter(|c| !c.passed).collect();
    assert!(failed.is_empty(), "{failed:?}");
    let (mut cuts, mut table, mut rows, mut seconds) = (0, None, 0, 0.0);
    let mut last: Option<&str> = None;
    for line in programmed.text.lines() {
        if line.starts_with("; Row") {
            (table, last, rows) = (None, None, rows + 1);
        }
        if !line.starts_with("G1 ") {
            continue;
        }
        for letter in "XYZABUVWCF".chars() {
            word(line, letter);
        }
        // The table and both leans stand still from the way down to the way up.
        let still = [word(line, 'A'), word(line, 'B'), word(line, 'C')];
        assert!(table.is_none_or(|t| t == still), "{line}");
        table = Some(still);
        if let Some(before) = last {
            let dt = 60.0 / word(line, 'F');
            for letter in "XYZUVW".chars() {
                let speed = (word(line, letter) - word(before, letter)).abs() / dt;
                assert!(speed < 500.1, "{letter} goes {speed} mm/s in {line}");
            }
            seconds += dt;
        }
        last = Some(line);
        cuts += 1;
    }
    // The way down ends at the first place; a way up comes besides the places of each stretch.
    let places: usize = pinch.held.iter().map(|h| h.places.len()).sum();
    assert_eq!((cuts, rows), (places + pinch.held.len(), pinch.held.len()));
    assert!(seconds > programmed.motion.cutting_s);
    // Neither tool goes faster than the feed: the longer side takes that long at least.
    let longest = pinch.rows.length_mm(0).max(pinch.rows.length_mm(1));
    assert!(programmed.motion.cutting_s > 60.0 * longest / setup.job.feed.feed_mm_min);
    let alone: f64 = programmed.motion.alone_s.iter().sum();
    assert!(programmed.motion.cutting_s < 0.56 * alone, "{} s, {alone} s alone", programmed.motion.cutting_s);
    for row in programmed.motion.stretches.iter().flat_map(|s| s.motion.jerk.iter()) {
        for (axis, jerk) in setup.machine.axes().iter().zip(row) {
            assert!(jerk.abs() <= axis.limits.jerk * (1.0 + 1e-6), "{}", axis.name);
        }
    }
}

#[test]
fn faults_planted_in_a_program_are_found() {
    assert_eq!(program_faults(str::to_owned), []);
    let exchanged = |text: &str, a: char, b: char| {
        let word = |w: &str| match w.chars().next() {
            Some(c) if c == a => w.replacen(a, &b.to_string(), 1),
            Some(c) if c == b => w.replacen(b, &a.to_string(), 1),
            _ => w.to_owned(),
        };
        let line = |l: &str| match l.starts_with(';') {
            true => l.to_owned(),
            false => l.split(' ').map(word).collect::<Vec<_>>().join(" "),
        };
        text.lines().map(line).collect::<Vec<_>>().join("\n")
    };
    assert!(program_faults(|t| exchanged(t, 'X', 'U')).contains(&CheckId::ProgramMissing));
    assert!(program_faults(|t| exchanged(t, 'Y', 'V')).contains(&CheckId::ProgramMissing));
    // The second head leans to the other side.
    let other_lean = program_faults(|t| t.replace(" C5", " C-5"));
    assert!(other_lean.contains(&CheckId::ProgramMissing), "{other_lean:?}");
    // 0.01 mm off, and two thousandths of a degree.
    let third = |t: &str, change: &dyn Fn(&str) -> String| {
        let at = t.match_indices("\nG1 ").nth(40).expect("a line").0 + 1;
        let end = at + t[at..].find('\n').expect("its end");
        [&t[..at], &change(&t[at..end]), &t[end..]].concat()
    };
    let moved = |line: &str, letter: char, by: f64| {
        let w = line.split(' ').find(|w| w.starts_with(letter)).expect("the word");
        line.replacen(w, &format!("{letter}{:.5}", word(line, letter) + by), 1)
    };
    assert_eq!(program_faults(|t| third(t, &|l| moved(l, 'V', 0.01))), [CheckId::ProgramCentre]);
    let turned = program_faults(|t| third(t, &|l| moved(l, 'B', 0.002)));
    assert!(turned.contains(&CheckId::ProgramDirection), "{turned:?}");
    // A line too few, one too many, one too slow.
    assert!(program_faults(|t| third(t, &|_| String::new())).contains(&CheckId::ProgramMissing));
    assert!(
        program_faults(|t| third(t, &|l| format!("{l}\n{}", moved(l, 'X', 3.0)))).contains(&CheckId::ProgramMissing)
    );
    assert_eq!(program_faults(|t| third(t, &|l| moved(l, 'F', -0.9 * word(l, 'F')))), [CheckId::ProgramTime]);
    // A rapid through the blade, a word that no such program has, travel.
    let low = program_faults(|t| {
        let at = t.match_indices("\nG0 X").nth(4).expect("a rapid").0 + 1;
        let end = at + t[at..].find('\n').expect("its end");
        [&t[..at], &moved(&t[at..end], 'W', 60.0), &t[end..]].concat()
    });
    assert!(low.contains(&CheckId::ProgramRapids), "{low:?}");
    assert_eq!(program_faults(|t| t.replacen("G64", "G41 D1 G64", 1)), [CheckId::ProgramReadable]);
    let far = program_faults(|t| third(t, &|l| format!("{}\n{l}", moved(l, 'Z', 900.0))));
    assert!(far.contains(&CheckId::ProgramTravel), "{far:?}");
}

fn command(arguments: &[&str], out: &Path) -> Output {
    let mut command = Command::new(env!("CARGO_BIN_EXE_bladewright"));
    command.args(["--quiet", "pinch"]).args(arguments).arg("-o").arg(out);
    command.output().expect("it runs")
}

#[test]
fn the_commands_tables_are_the_plans() {
    let folder = tempfile::tempdir().expect("a folder");
    let out = folder.path().join("out");
    let mut arguments = vec![MODEL];
    KEYS.iter().for_each(|key| arguments.extend(["--set", key]));
    let ran = command(&arguments, &out);
    assert!(ran.status.success(), "{ran:?}");
    let (_, pinch) = planned();
    let rows = |name: &str| -> Vec<Vec<f64>> {
        let text = std::fs::read_to_string(out.join(name)).expect("a table");
        let lines = text.lines().filter(|l| !l.starts_with('#')).skip(1);
        lines.map(|l| l.split(',').map(|v| v.parse().expect("a number")).collect()).collect()
    };
    let pairs = rows("pairs.csv");
    assert_eq!(pairs.len(), pinch.rows.places.len());
    for (k, row) in pairs.iter().enumerate() {
        let held = pinch.held_at(k).expect("held");
        assert_eq!((row[0], row[1]), (held.row as f64, k as f64));
        assert!((row[26] - held.theta_rad.to_degrees()).abs() < 1e-9 && row[30] <= row[26] && row[26] <= row[31]);
    }
    for tool in 1..=2 {
        let table = rows(&format!("cutter_locations_{tool}.csv"));
        assert_eq!(table.len(), pairs.len());
        // Ball centres are the same, and θ of tool 2 is half a turn on.
        for (a, b) in table.iter().zip(&pairs) {
            assert_eq!(a[3..6], b[2 + 9 * (tool - 1)..5 + 9 * (tool - 1)]);
            assert!((a[15] - b[26] - 180.0 * (tool as f64 - 1.0)).abs() < 1e-9);
        }
    }
    let figures: serde_json::Value =
        serde_json::from_slice(&std::fs::read(out.join("pinch.json")).expect("figures")).expect("JSON");
    assert_eq!(figures["still_rows"], figures["rows"]);
    let [one, two] = [0, 1].map(|k| figures["covered"][k].as_f64().expect("a share"));
    assert!(one > 0.25 && one < 0.5 && two > 0.2 && two < 0.5, "{one} {two}");
    assert!(std::fs::read_to_string(out.join("pinch.svg")).expect("a plot").contains("where it stands"));
}

#[test]
fn what_cannot_be_held_leaves_nothing_behind() {
    let folder = tempfile::tempdir().expect("a folder");
    let mesh = concat!(env!("CARGO_MANIFEST_DIR"), "/models/turbine_camber.obj");
    let job = concat!(env!("CARGO_MANIFEST_DIR"), "/examples/jobs/wheel.toml");
    for (arguments, code, says) in [
        (vec![mesh], 3, "the part is a mesh"),
        (vec![MODEL, "--set", "pinch.heights_mm=[30, 20]"], 2, "the airfoil lies between"),
        (vec![MODEL, "--set", "pinch.max_angle_deg=0"], 2, "pinch.max_angle_deg is 0"),
        (vec![MODEL, "--set", "pinch.tools_apart_mm=9"], 3, "no place of the suction side has an opposite one"),
        (vec![MODEL, "--set", "pinch.between_deg=20", "--set", "path.scallop_mm=0.3"], 3, "free for both tools"),
        (vec![MODEL, "--set", "pinch.b_2_deg=89"], 2, "pinch.b_2_deg is 89"),
        (vec![job], 2, "each keeps one lean"),
    ] {
        let out = folder.path().join("out");
        let ran = command(&arguments, &out);
        let text = String::from_utf8_lossy(&ran.stderr);
        assert_eq!(ran.status.code(), Some(code), "{arguments:?}: {text}");
        assert!(text.contains(says), "{arguments:?}: {text}");
        assert!(!out.exists(), "{arguments:?}");
    }
}
