//! Programs of two tools judged by themselves, as if others had written them: clean ones, planted
//! faults, the command.

use std::process::Command;

use bladewright::artifact::check_id::{AxisCheck, CheckId};
use bladewright::machine::Machine;
use bladewright::observe::Silent;
use bladewright::verify::audit::AuditOptions;
use bladewright::verify::{self, PinchAudit, PinchBench};

use super::pinch::{CONTROLS, channels, is_cut, moved, programmed, text_of, token, with_line, word};

fn audited(texts: &[&str]) -> Result<PinchAudit, String> {
    let (setup, _, _) = programmed();
    let bench = PinchBench {
        blade: &setup.blade,
        tools: setup.pinch_tools(),
        machine: &setup.machine,
        tools_apart_mm: 0.1,
        line_distance_mm: 0.2,
    };
    let options = AuditOptions { scallop_mm: Some(0.1), ..AuditOptions::default() }.with(|s| s.surface_samples = 2000);
    verify::audit_pinch(texts, &bench, &options, &Silent).map_err(|e| e.message)
}

fn faults(texts: &[&str]) -> Vec<CheckId> {
    let audit = audited(texts).expect("readable");
    audit.checks.into_iter().filter(|c| !c.passed).map(|c| c.id).collect()
}

/// One test for all that is clean, since each process plans its rows anew.
#[test]
fn clean_programs_have_no_finding() {
    words_of_others_are_read();
    let (_, pinch, _) = programmed();
    for control in CONTROLS {
        // All of one, the first rows of the others.
        let is_whole = control == "linuxcnc";
        let text = if is_whole { text_of(control).to_owned() } else { few(text_of(control)) };
        let audit = audited(&[&text]).expect("readable");
        assert!(audit.passed(), "{control}: {:?}", audit.checks.iter().filter(|c| !c.passed).collect::<Vec<_>>());
        assert!(audit.opposite > 0.999 && audit.line_distance_mm[1] < 0.01, "{audit:?}");
        // The same as the rows' own check has it, which knows the rows.
        let least_mm = pinch.figures.tools_apart_mm;
        let off_mm = (audit.tools_apart_mm - least_mm).abs();
        assert!(off_mm < 1e-3 || !is_whole, "{} {least_mm}", audit.tools_apart_mm);
        let off_deg = (audit.angle_deg[2] - pinch.figures.angle_deg[2]).abs();
        assert!(off_deg < 0.5 || !is_whole, "{audit:?} {:?}", pinch.figures);
        assert!(audit.lean_deg.iter().flatten().all(|b| (b - 5.0).abs() < 1e-3), "{:?}", audit.lean_deg);
        let [one, two, both] = audit.touching;
        assert!(both > 0.05 && both <= one && both <= two, "{:?}", audit.touching);
        assert!(verify::is_for_two_tools(text_of(control), &programmed().0.machine));
        assert!(!verify::is_for_two_tools(text_of(control), &Machine::demo().expect("a machine")));
    }
    let two = channels().map(|text| few(&text));
    let audit = audited(&[&two[0], &two[1]]).expect("readable");
    assert!(
        audit.passed() && audit.channels == 2,
        "{:?}",
        audit.checks.iter().filter(|c| !c.passed).collect::<Vec<_>>()
    );
    let one = audited(&[&few(text_of("siemens"))]).expect("readable");
    assert!((audit.feed_s / one.feed_s - 1.0).abs() < 1e-3, "{} {}", audit.feed_s, one.feed_s);
}

/// The first rows of a program alone, and its end.
fn few(text: &str) -> String {
    let lines: Vec<&str> = text.lines().collect();
    let is_row = |l: &str| l.contains("ow 9, stretch");
    let row = lines.iter().position(|l| is_row(l)).expect("nine rows");
    let end = lines.iter().rposition(|l| is_cut(l)).expect("cuts") + 1;
    let kept: Vec<&str> = lines[..row].iter().chain(&lines[end..]).copied().collect();
    kept.join("\n") + "\n"
}

#[test]
fn planted_faults_are_found() {
    in_one_channel();
    in_two_channels();
}

fn in_one_channel() {
    let text = &few(text_of("linuxcnc"));
    let each = |change: &dyn Fn(&str) -> String| -> String {
        text.lines().map(|l| if is_cut(l) { change(l) } else { l.to_owned() }).collect::<Vec<_>>().join("\n")
    };
    let found = |text: &str| faults(&[text]);
    // Tool 2 0.05 mm deeper, or beside where tool 1 is opposite.
    let [deep, off] = [0.05, 1.0].map(|by| found(&each(&|l| moved(l, "W", by))));
    assert!(deep.contains(&CheckId::Gouge) || off.contains(&CheckId::Gouge), "{deep:?} {off:?}");
    let late = found(&each(&|l| moved(l, "U", 0.6)));
    assert!(late.contains(&CheckId::Opposition), "{late:?}");
    // The second head leans to the other side: its shank lies elsewhere, its ball too.
    let leaning: Vec<String> = text
        .lines()
        .map(|l| if token(l, "C").is_some() { moved(l, "C", -2.0 * word(l, "C")) } else { l.to_owned() })
        .collect();
    let leaning = found(&leaning.join("\n"));
    assert!(leaning.contains(&CheckId::Contact) || leaning.contains(&CheckId::Gouge), "{leaning:?}");
    // The table has turned by a quarter.
    let turned: Vec<String> =
        text.lines().map(|l| if token(l, "A").is_some() { moved(l, "A", 90.0) } else { l.to_owned() }).collect();
    let turned = found(&turned.join("\n"));
    assert!(turned.contains(&CheckId::Clearance) && turned.contains(&CheckId::Gouge), "{turned:?}");
    // Every second row left out is more than the scallop asked for.
    let (mut row, mut kept) = (0, Vec::new());
    for line in text.lines() {
        row += usize::from(line.to_lowercase().contains("row "));
        if row % 2 == 0 || line.contains("M2") || line.contains("M5") {
            kept.push(line);
        }
    }
    let wide = found(&kept.join("\n"));
    assert!(wide.contains(&CheckId::Scallop), "{wide:?}");
    // A rapid in the place of a move at a feed.
    let rapid = found(&with_line(text, 40, is_cut, |l| l.replacen("G1", "G0", 1)));
    assert!(rapid.contains(&CheckId::ProgramRapids), "{rapid:?}");
    // A line that is too fast for an axis.
    let fast = found(&with_line(text, 40, is_cut, |l| moved(l, "F", 1e6)));
    let is_velocity = |id: &CheckId| matches!(id, CheckId::Axis { what: AxisCheck::Velocity, .. });
    assert!(fast.iter().any(is_velocity), "{fast:?}");
    assert_eq!(found(&text.replacen("M3 $1\n", "\n", 1)), [CheckId::ProgramSpindle]);
    assert_eq!(found(&text.replacen("M2\n", "\n", 1)), [CheckId::ProgramEnd]);
    assert_eq!(found(&text.replacen(" G90", "", 1)), [CheckId::ProgramFrame]);
    let far = found(&with_line(text, 40, is_cut, |l| format!("{}\n{l}", moved(l, "Z", 900.0))));
    assert!(far.contains(&CheckId::ProgramTravel), "{far:?}");
    let unreadable = audited(&[&with_line(text, 40, is_cut, |_| "G2 X1".into())]).expect_err("an arc");
    assert!(unreadable.contains("the word G2") && unreadable.starts_with("line "), "{unreadable}");
    let nowhere = audited(&[&with_line(text, 40, is_cut, |_| "G1 X-1e308 F9".into())]).expect_err("no place");
    assert!(nowhere.contains("X at -1e308, which is no position of it"), "{nowhere}");
    assert!(audited(&["G90\nM2\n"]).expect_err("nothing").contains("no line of the program moves at a feed"));
}

/// F under G94 counts until another, and words that move no axis change nothing.
fn words_of_others_are_read() {
    let text = &few(text_of("fanuc"));
    let mut last = String::new();
    let modal: Vec<String> = text
        .lines()
        .map(|l| match token(l, "F").filter(|_| is_cut(l)) {
            Some(f) if f == last => l.replacen(&format!(" {f}"), "", 1),
            Some(f) => {
                last = f.to_owned();
                l.to_owned()
            }
            None => l.to_owned(),
        })
        .collect();
    let modal = modal.join("\n");
    assert!(modal.len() < text.len());
    let (whole, short) = (audited(&[text]).expect("readable"), audited(&[&modal]).expect("readable"));
    assert!((short.feed_s / whole.feed_s - 1.0).abs() < 1e-9 && short.passed());
    let more = text.replacen("\nG0", "\nT1 M6\nM1\nG0", 1);
    assert_eq!(audited(&[&more]).expect("readable").feed_lines, whole.feed_lines);
}

fn in_two_channels() {
    let two = channels().map(|text| few(&text));
    let found = |change: &dyn Fn(&mut [String; 2])| {
        let mut texts = two.clone();
        change(&mut texts);
        faults(&[&texts[0], &texts[1]])
    };
    assert_eq!(found(&|_| {}), []);
    let is_mark = |l: &str| l.contains("WAITM(");
    // One channel waits for ever; a mark of one alone.
    let missing = found(&|t| t[1] = with_line(&t[1], 3, is_mark, |_| String::new()));
    assert!(missing.contains(&CheckId::ProgramChannels), "{missing:?}");
    let alone = found(&|t| t[0] = with_line(&t[0], 3, is_mark, |l| l.replacen(",1,2)", ",1)", 1)));
    assert!(alone.contains(&CheckId::ProgramChannels), "{alone:?}");
    // The table turns amid a row, and channel 2 names it.
    let table = found(&|t| t[0] = with_line(&t[0], 40, is_cut, |l| l.replacen("G1", "G1 A=DC(3)", 1)));
    assert!(table.contains(&CheckId::ProgramChannels), "{table:?}");
    let stranger = found(&|t| t[1] = with_line(&t[1], 40, is_cut, |l| l.replacen("G1", "G1 A=DC(3)", 1)));
    assert!(stranger.contains(&CheckId::ProgramChannels), "{stranger:?}");
    // Channel 2 is slower by a tenth all along a row: it lags.
    let slow = found(&|t| {
        t[1] = t[1]
            .lines()
            .map(|l| if is_cut(l) { moved(l, "F", -0.1 * word(l, "F")) } else { l.to_owned() })
            .collect::<Vec<_>>()
            .join("\n");
    });
    assert!(slow.contains(&CheckId::ProgramChannels), "{slow:?}");
    // Tool 2 takes the places of one line in two: the same way in the same time is the same.
    let parted = found(&|t| {
        t[1] = with_line(&t[1], 40, is_cut, |l| {
            let half = moved(l, "F", word(l, "F"));
            format!("{half}\n{half}")
        });
    });
    assert!(parted.contains(&CheckId::ProgramChannels) || parted.is_empty(), "{parted:?}");
}

#[test]
fn the_command_judges_programs_of_two_tools() {
    let folder = tempfile::tempdir().expect("a folder");
    let (setup, _, _) = programmed();
    let write = |name: &str, text: &str| {
        let path = folder.path().join(name);
        std::fs::write(&path, text).expect("written");
        path
    };
    let job = write("job.toml", &setup.job.to_toml().expect("a job"));
    let model = concat!(env!("CARGO_MANIFEST_DIR"), "/models/turbine_camber.step");
    let machine = concat!(env!("CARGO_MANIFEST_DIR"), "/models/machines/pinch_9x.toml");
    let run = |programs: &[&std::path::Path], more: &[&str]| {
        let mut command = Command::new(env!("CARGO_BIN_EXE_bladewright"));
        command.args(["--quiet", "verify"]).args(programs).args(["--part", model, "--machine", machine]);
        let out = command.arg("--tool").arg(&job).args(more).output().expect("runs");
        let text = |bytes: &[u8]| String::from_utf8_lossy(bytes).into_owned();
        (out.status.code(), text(&out.stdout), text(&out.stderr))
    };
    let text = few(text_of("linuxcnc"));
    let one = write("pinch.ngc", &text);
    let report = folder.path().join("found.json");
    let (code, said, wrong) = run(&[&one], &["--report", report.to_str().expect("a name"), "--scallop", "0.1"]);
    assert_eq!(code, Some(0), "{said}{wrong}");
    assert!(
        said.contains("program    of two tools in one channel")
            && said.contains("face each other, 100.0 % of their places"),
        "{said}"
    );
    let json: serde_json::Value =
        serde_json::from_str(&std::fs::read_to_string(&report).expect("a report")).expect("json");
    assert!(json["checks"].as_array().is_some_and(|c| c.len() > 15) && json["channels"] == 1);
    let [first, second] = channels().map(|text| few(&text));
    let two = [write("1.mpf", &first), write("2.mpf", &second)];
    let (code, said, wrong) = run(&[&two[0], &two[1]], &[]);
    assert_eq!(code, Some(0), "{said}{wrong}");
    assert!(said.contains("in two channels"), "{said}");
    // One of two alone waits for the other; deeper by 0.1 mm is a finding.
    let (code, _, wrong) = run(&[&two[0]], &[]);
    assert!(code == Some(2) && wrong.contains("it waits for another channel"), "{wrong}");
    assert!(wrong.contains("of two channels, give both programs"), "{wrong}");
    // A line that cannot be read is named by the reader of such programs.
    let arc = with_line(&few(text_of("siemens")), 40, is_cut, |_| "G2 X1".into());
    let (code, _, wrong) = run(&[&write("arc.mpf", &arc)], &[]);
    assert!(code == Some(2) && wrong.contains("the word G2 in `G2 X1`"), "{wrong}");
    let deep: Vec<String> = text.lines().map(|l| if is_cut(l) { moved(l, "Z", -0.1) } else { l.to_owned() }).collect();
    let (code, said, _) = run(&[&write("deep.ngc", &deep.join("\n"))], &[]);
    assert!(code == Some(1) && said.contains("finding: gouge: tool 1"), "{said}");
    let (code, _, wrong) = run(&[&one], &["--fit"]);
    assert!(code == Some(2) && wrong.contains("--map and --fit are for programs of one tool"), "{wrong}");
}
