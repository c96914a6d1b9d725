//! Rows of two tools: both sides against the part, the table's angles against tools that stand
//! there, planted faults, refusals.

use std::path::Path;
use std::process::{Command, Output};
use std::sync::OnceLock;

use bladewright::artifact::check_id::CheckId;
use bladewright::artifact::paired::Held;
use bladewright::artifact::program::Control;
use bladewright::artifact::report::Check;
use bladewright::artifact::{PairedRows, Stand};
use bladewright::job::JobFile;
use bladewright::observe::Silent;
use bladewright::plan::Setup;
use bladewright::plan::pinch::{LeanPair, Pinch, PinchProgrammed};
use bladewright::run::Loaded;
use bladewright::run::inputs;
use bladewright::verify::{self, PinchAsked, PinchWork};
use bladewright::write::post::pinch::PinchFile;
use bladewright::write::post::{self, Dialect};

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

/// What advice says of a pair of leans at some of the places is what planning with it finds at all.
#[test]
fn leans_that_are_advised_are_those_that_rows_have() {
    let (setup, pinch) = planned();
    let own = setup.job.machine.b_deg;
    let found = setup.pinch_advice(&[-15.0, own, 30.0], &Silent).expect("leans");
    assert!(found.open.len() > 3 && found.places < pinch.rows.places.len(), "{found:?}");
    let share = |pinch: &Pinch| {
        let cut = pinch.rows.places.len() as f64;
        cut / (cut + pinch.cut_off as f64)
    };
    let agrees = |said: &LeanPair, pinch: &Pinch| {
        assert!((said.open_share - share(pinch)).abs() < 0.03, "{said:?} {}", share(pinch));
        assert_eq!((said.rows, said.still_rows), (pinch.rows.rows.len(), pinch.still_rows()), "{said:?}");
        let least_deg = pinch.narrowest().expect("places").0.to_degrees();
        assert!((-1e-6..6.0).contains(&(said.narrowest_deg - least_deg)), "{said:?} {least_deg}");
    };
    let now = found.now.as_ref().expect("open");
    assert!(now.b_deg.iter().all(|b| (b - own).abs() < 1e-9));
    agrees(now, pinch);
    // The best comes first, and is as good as it says.
    let best = &found.open[0];
    assert!(found.open.iter().all(|p| p.open_share <= best.open_share + 0.001));
    let [first, second] = best.b_deg;
    let leans = [format!("machine.b_deg={first}"), format!("pinch.b_2_deg={second}")];
    agrees(best, &plan_for(&leans.each_ref().map(String::as_str)).1);
    // What the file says of the machine is said before leans are looked at.
    let mut job = JobFile::from_model(Path::new(MODEL));
    let file = format!("machine.file=\"{TWO_HEADS}\"");
    KEYS.iter().chain(&[file.as_str(), "pinch.between_deg=90"]).for_each(|key| job.set(key).expect("a key"));
    let setup = Loaded::read(&inputs::draft(job, Path::new("")).expect("a draft"), &Silent).expect("a blade").setup;
    let e = setup.pinch_advice(&[own], &Silent).expect_err("another machine");
    assert!(e.to_string().contains("pinch.between_deg is 90"), "{e}");
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
    let binding = pinch.figures.binding_ridges_mm;
    assert!(binding[0] >= 0.093 && binding[3] < 0.103, "{binding:?}");
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
fn faults(change: impl FnOnce(&mut PairedRows, &mut Vec<Held>, &mut f64)) -> Vec<CheckId> {
    let (setup, pinch) = planned();
    let mut rows = pinch.rows.clone();
    let mut held = pinch.held.clone();
    let mut between_rad = std::f64::consts::PI;
    change(&mut rows, &mut held, &mut between_rad);
    let work = PinchWork { between_rad, rows: &rows, held: &held, ..setup.pinch_work(pinch) };
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
        held.retain(|h| rows.rows.iter().any(|r| r.contains(&h.places.start)));
    });
    assert!(wide.contains(&CheckId::Ridge), "{wide:?}");
    // The table has turned too far, and the head to the wrong side.
    let turned =
        faults(|_, held, _| held.iter_mut().for_each(|h| h.theta_rad.iter_mut().for_each(|theta| *theta += 1.6)));
    assert!(turned.contains(&CheckId::Clearance), "{turned:?}");
    let same_side = faults(|_, _, between| *between = 0.3);
    assert!(same_side.contains(&CheckId::ToolsApart) && same_side.contains(&CheckId::Clearance), "{same_side:?}");
}

/// The controls that have programs of two tools.
pub const CONTROLS: [&str; 4] = ["linuxcnc", "siemens", "iso", "fanuc"];

/// The same rows on a machine with two heads.
pub fn programmed() -> &'static (Setup, Pinch, PinchProgrammed) {
    static PROGRAMMED: OnceLock<(Setup, Pinch, PinchProgrammed)> = OnceLock::new();
    PROGRAMMED.get_or_init(|| {
        let plan = || {
            let machine = format!("machine.file={TWO_HEADS:?}");
            let (setup, pinch) = plan_for(&[&machine, &format!("post.control={CONTROLS:?}")]);
            let programmed = setup.pinch_program(&pinch, &Silent).expect("a program").expect("two heads");
            (setup, pinch, programmed)
        };
        std::thread::scope(|s| s.spawn(plan).join().expect("programmed"))
    })
}

/// The program of a control.
pub fn text_of(control: &str) -> &'static str {
    let posted = programmed().2.programs.iter().find(|p| p.control == control).expect("a control");
    assert_eq!(posted.files.len(), 1);
    &posted.files[0].text
}

/// What is wrong with programs: one, or those of two channels.
fn judged(control: &str, texts: &[String]) -> Vec<Check> {
    let (setup, pinch, programmed) = programmed();
    let dialects = setup.pinch_dialects().expect("dialects");
    let (_, dialect) = dialects.iter().find(|(name, _)| name == control).expect("a control");
    let file = |text: &String| PinchFile { name: String::new(), text: text.clone() };
    let files: Vec<PinchFile> = texts.iter().map(file).collect();
    setup.read_back_pinch(dialect, &files, pinch, &programmed.motion).into_iter().filter(|c| !c.passed).collect()
}

/// What is found wrong with the program of a control after a change of its text.
fn program_faults(control: &str, change: impl FnOnce(&str) -> String) -> Vec<CheckId> {
    judged(control, &[change(text_of(control))]).into_iter().map(|c| c.id).collect()
}

/// The word of a letter in a line: `X1.5`, `X=1.5`, `A=DC(1.5)`.
pub fn token<'a>(line: &'a str, letter: &str) -> Option<&'a str> {
    let is_number = |rest: &str| rest.starts_with(['=', '-']) || rest.starts_with(|c: char| c.is_ascii_digit());
    line.split(' ').find(|w| w.strip_prefix(letter).is_some_and(is_number))
}

/// The number of that word.
pub fn word(line: &str, letter: &str) -> f64 {
    let token = token(line, letter).unwrap_or_else(|| panic!("no {letter} in {line}"));
    token[letter.len()..].trim_matches(|c: char| "=DC()".contains(c)).parse().expect("a number")
}

/// The line with another number in that word.
pub fn moved(line: &str, letter: &str, by: f64) -> String {
    let token = token(line, letter).unwrap_or_else(|| panic!("no {letter} in {line}"));
    let at = token.find(|c: char| c == '-' || c.is_ascii_digit()).expect("a number");
    let end = token.trim_end_matches(')').len();
    let number = format!("{}{:.4}{}", &token[..at], word(line, letter) + by, &token[end..]);
    line.replacen(token, &number, 1)
}

pub fn is_cut(line: &str) -> bool {
    line.split(' ').any(|w| w == "G1")
}

/// The text with another line in place of the `n`th that is of a kind.
pub fn with_line(text: &str, n: usize, of: impl Fn(&str) -> bool, change: impl FnOnce(&str) -> String) -> String {
    let line = text.lines().enumerate().filter(|(_, l)| of(l)).nth(n).expect("a line").0;
    let mut lines: Vec<String> = text.lines().map(str::to_owned).collect();
    lines[line] = change(&lines[line]);
    lines.join("\n") + "\n"
}

#[test]
fn a_program_has_nine_letters_and_one_clock() {
    let (setup, pinch, programmed) = programmed();
    let failed: Vec<&Check> = pinch.checks.iter().chain(programmed.all_checks()).filter(|c| !c.passed).collect();
    assert!(failed.is_empty(), "{failed:?}");
    let (mut cuts, mut table, mut rows, mut seconds) = (0, None, 0, 0.0);
    let mut last: Option<&str> = None;
    for line in text_of("linuxcnc").lines() {
        if line.starts_with("; Row") {
            (table, last, rows) = (None, None, rows + 1);
        }
        if !is_cut(line) {
            continue;
        }
        for letter in "XYZABUVWCF".chars() {
            word(line, &letter.to_string());
        }
        // The table and both leans stand still from the way down to the way up.
        let still = [word(line, "A"), word(line, "B"), word(line, "C")];
        assert!(table.is_none_or(|t| t == still), "{line}");
        table = Some(still);
        if let Some(before) = last {
            let dt = 60.0 / word(line, "F");
            for letter in ["X", "Y", "Z", "U", "V", "W"] {
                let speed = (word(line, letter) - word(before, letter)).abs() / dt;
                assert!(speed < 500.1, "{letter} goes {speed} mm/s in {line}");
            }
            seconds += dt;
        }
        last = Some(line);
        cuts += 1;
    }
    // The way down ends at the first place; where it slows and a way up come besides the places of
    // each stretch.
    let places: usize = pinch.held.iter().map(|h| h.places.len()).sum();
    assert_eq!((cuts, rows), (places + 2 * pinch.held.len(), pinch.held.len()));
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

/// The same places stand in the programs of all controls, each in its own words.
#[test]
fn all_controls_have_the_same_places() {
    let cuts = |control: &str| -> Vec<&str> { text_of(control).lines().filter(|l| is_cut(l)).collect() };
    let reference = cuts("linuxcnc");
    for control in CONTROLS {
        let own = cuts(control);
        assert_eq!(own.len(), reference.len(), "{control}");
        for (a, b) in own.iter().zip(&reference) {
            for letter in ["X", "Y", "Z", "U", "V", "W"] {
                assert!((word(a, letter) - word(b, letter)).abs() < 6e-5, "{control}: {a}, {b}");
            }
            // Inverse time is the same; per minute it is over the way of all linear axes.
            assert!(control == "fanuc" || (word(a, "F") / word(b, "F") - 1.0).abs() < 1e-4, "{control}: {a}, {b}");
        }
    }
    let siemens = text_of("siemens");
    for word in ["TRAFOOF", "G500", "FGROUP(X,Y,Z,U,V,W)", "S1=6000 M1=3", "S2=6000 M2=3", " A=DC(", " D0", "G93"] {
        assert!(siemens.contains(word), "{word}");
    }
    assert!(!siemens.contains("TRAORI") && text_of("iso").starts_with("%\nO0001\n"));
    assert!(!text_of("fanuc").contains("G93") && !text_of("fanuc").contains("G43"), "no tool-centre-point control");
}

#[test]
fn faults_planted_in_a_program_are_found() {
    for control in CONTROLS {
        faults_in_a_program_of(control);
    }
}

/// A cut amid a row, and a rapid from row to row.
const CUT: usize = 40;

fn faults_in_a_program_of(control: &str) {
    let faults = |change: &dyn Fn(&str) -> String| program_faults(control, change);
    let third = |change: &dyn Fn(&str) -> String| faults(&|t| with_line(t, CUT, is_cut, change));
    assert_eq!(faults(&str::to_owned), [], "{control}");
    let exchanged = |text: &str, a: &str, b: &str| {
        let word = |w: &str| match [a, b].iter().position(|l| token(w, l).is_some()) {
            Some(0) => w.replacen(a, b, 1),
            Some(_) => w.replacen(b, a, 1),
            None => w.to_owned(),
        };
        let line = |l: &str| match l.starts_with([';', '(']) {
            true => l.to_owned(),
            false => l.split(' ').map(word).collect::<Vec<_>>().join(" "),
        };
        text.lines().map(line).collect::<Vec<_>>().join("\n")
    };
    for (a, b) in [("X", "U"), ("Y", "V")] {
        assert!(faults(&|t| exchanged(t, a, b)).contains(&CheckId::ProgramMissing), "{control} {a}");
    }
    // The second head leans to the other side.
    let other_lean = faults(&|t| {
        let line = |l: &str| if token(l, "C").is_some() { moved(l, "C", -2.0 * word(l, "C")) } else { l.to_owned() };
        t.lines().map(line).collect::<Vec<_>>().join("\n")
    });
    assert!(other_lean.contains(&CheckId::ProgramMissing), "{control}: {other_lean:?}");
    // 0.01 mm off, and two thousandths of a degree. Per minute another way is another time, too.
    let mut off = third(&|l| moved(l, "V", 0.01));
    off.retain(|id| control != "fanuc" || *id != CheckId::ProgramTime);
    assert_eq!(off, [CheckId::ProgramCentre], "{control}");
    let turned = third(&|l| match token(l, "B") {
        Some(_) => moved(l, "B", 0.002),
        None => l.replacen("G1 ", if control == "siemens" { "G1 B=5.002 " } else { "G1 B5.002 " }, 1),
    });
    assert!(turned.contains(&CheckId::ProgramDirection), "{control}: {turned:?}");
    assert_eq!(third(&|l| l.replacen("G1 ", "G1 X0 X1 ", 1)), [CheckId::ProgramReadable], "{control}");
    // A line too few, one too many, one too slow.
    assert!(third(&|_| String::new()).contains(&CheckId::ProgramMissing), "{control}");
    assert!(third(&|l| format!("{l}\n{}", moved(l, "X", 3.0))).contains(&CheckId::ProgramMissing), "{control}");
    assert_eq!(third(&|l| moved(l, "F", -0.9 * word(l, "F"))), [CheckId::ProgramTime], "{control}");
    assert_eq!(third(&|l| moved(l, "F", -word(l, "F"))), [CheckId::ProgramReadable], "{control}");
    // A rapid through the blade, a word that no such program has, travel.
    let is_rapid = |l: &str| l.split(' ').any(|w| w == "G0") && token(l, "X").is_some();
    let low = faults(&|t| with_line(t, 4, is_rapid, |l| moved(l, "W", 60.0)));
    assert!(low.contains(&CheckId::ProgramRapids), "{control}: {low:?}");
    for stray in ["G41 D1", "G43.4 H1", "TRAORI", "G91", "G20", "X1.2.3", "(open", "G2 X1", "G4 X1", "G4"] {
        let found = third(&|l| format!("{stray}\n{l}"));
        assert_eq!(found, [CheckId::ProgramReadable], "{control}: {stray}");
    }
    let far = third(&|l| format!("{}\n{l}", moved(l, "Z", 900.0)));
    assert!(far.contains(&CheckId::ProgramTravel), "{control}: {far:?}");
    // What is set before it cuts, and the end.
    let offset = if control == "siemens" { "G500" } else { "G54" };
    assert_eq!(faults(&|t| t.replacen(&format!("{offset}\n"), "\n", 1)), [CheckId::ProgramFrame], "{control}");
    assert_eq!(faults(&|t| t.replacen(" G90", "", 1)), [CheckId::ProgramFrame], "{control}");
    let slow = faults(&|t| {
        t.replacen("6000 $1", "600 $1", 1).replacen("S2=6000", "S2=600", 1).replacen("6000 P2", "600 P2", 1)
    });
    assert_eq!(slow, [CheckId::ProgramSpindle], "{control}");
    let stands = faults(&|t| t.replacen("M3 $1\n", "\n", 1).replacen(" M2=3", "", 1).replacen(" P2 M3", " P2", 1));
    assert!(stands.contains(&CheckId::ProgramSpindle) || stands == [CheckId::ProgramReadable], "{control}: {stands:?}");
    if ["linuxcnc", "siemens"].contains(&control) {
        let loose = faults(&|t| t.replacen("G64 P0.001", "G64 P0.1", 1).replacen("CTOL=0.001", "CTOL=0.1", 1));
        assert_eq!(loose, [CheckId::ProgramSmoothing], "{control}");
    }
    let open = faults(&|t| t.replacen("\nM2\n", "\n", 1).replacen("M30\n", "\n", 1));
    assert_eq!(open, [CheckId::ProgramEnd], "{control}");
}

/// The programs of both channels.
pub fn channels() -> [String; 2] {
    let (setup, _, programmed) = programmed();
    let siemens = Dialect::built_in(Control::Siemens).expect("a dialect");
    let files = setup.pinch_files(&siemens, &programmed.motion, 2).expect("programs");
    assert_eq!([&files[0].name, &files[1].name], ["pinch_ch1.mpf", "pinch_ch2.mpf"]);
    [files[0].text.clone(), files[1].text.clone()]
}

fn is_mark(line: &str) -> bool {
    line.contains("WAITM(")
}

#[test]
fn two_channels_meet_at_the_same_marks() {
    let (setup, pinch, programmed) = programmed();
    let texts = channels();
    let found = judged("siemens", &texts);
    assert!(found.is_empty(), "{found:?}");
    let marks = |text: &str| -> Vec<String> {
        let of = |l: &str| Some(l.split_once("WAITM(")?.1.split_once(')')?.0.to_owned());
        text.lines().filter_map(of).collect()
    };
    let count = 1 + 2 * pinch.held.len();
    let wanted: Vec<String> = (0..count).map(|k| format!("{},1,2", k % 99 + 1)).collect();
    assert_eq!(marks(&texts[0]), wanted);
    assert_eq!(marks(&texts[1]), wanted);
    // Each channel has its own axes, the table is the first's; F of both is the same, line by line.
    let cuts = texts.each_ref().map(|t| t.lines().filter(|l| is_cut(l)).collect::<Vec<_>>());
    assert_eq!(cuts[0].len(), cuts[1].len());
    for (a, b) in cuts[0].iter().zip(&cuts[1]) {
        assert_eq!(word(a, "F"), word(b, "F"));
        assert!(["U", "V", "W", "C"].iter().all(|l| token(a, l).is_none()), "{a}");
        assert!(["X", "Y", "Z", "A", "B"].iter().all(|l| token(b, l).is_none()), "{b}");
    }
    // Where the table moves in a row there is no such program, but one in one channel.
    let mut motion = programmed.motion.clone();
    motion.stretches[3].motion.position[5][setup.machine.turning_axis()] += 0.002;
    let siemens = Dialect::built_in(Control::Siemens).expect("a dialect");
    let refused = setup.pinch_files(&siemens, &motion, 2).expect_err("the table moves");
    assert!(refused.message.contains("A moves by 0.1146 deg in row 4 while both tools cut"), "{}", refused.message);
    assert_eq!(refused.kind.exit_code(), 3);
    assert!(setup.pinch_files(&siemens, &motion, 1).is_ok());
    // Where one tool stands its channel waits: a line that goes nowhere would be passed at once.
    let mut motion = programmed.motion.clone();
    let columns = setup.machine.heads()[1].linear();
    let row = &mut motion.stretches[3].motion.position;
    columns.into_iter().for_each(|k| row[6][k] = row[5][k]);
    let files = setup.pinch_files(&siemens, &motion, 2).expect("programs");
    let waits = |text: &str| text.lines().filter(|l| l.contains("G4 F0.0")).count();
    assert_eq!([waits(&files[0].text), waits(&files[1].text)], [0, 1]);
    let found = judged("siemens", &[files[0].text.clone(), files[1].text.clone()]);
    let ids: Vec<&CheckId> = found.iter().map(|c| &c.id).collect();
    assert!(!ids.contains(&&CheckId::ProgramChannels) && ids.contains(&&CheckId::ProgramMissing), "{found:?}");
    let gone = files[1].text.lines().filter(|l| !l.contains("G4 F0.0")).collect::<Vec<_>>().join("\n");
    let passed = files[1].text.replace("G4 F0.0", "G1 V=0 F9 ; ");
    for other in [gone, passed] {
        let found = judged("siemens", &[files[0].text.clone(), other]);
        assert!(found.iter().any(|c| c.id == CheckId::ProgramChannels), "{found:?}");
    }
}

/// What is said of both channels after a change of their programs.
fn channel_faults(change: impl FnOnce(&mut [String; 2])) -> Vec<String> {
    let mut texts = channels();
    change(&mut texts);
    judged("siemens", &texts).iter().map(|c| format!("{}: {}; {}", c.id, c.quantity, c.note)).collect()
}

#[test]
fn faults_planted_in_two_channels_are_named() {
    let mark =
        |text: &mut String, n: usize, change: &dyn Fn(&str) -> String| *text = with_line(text, n, is_mark, change);
    let named = |found: Vec<String>, says: &str| {
        assert!(found.iter().any(|f| f.starts_with("program-channels: ") && f.contains(says)), "{says}: {found:?}");
    };
    // Mark 8 is the one over the fourth row.
    let gone = |_: &str| String::new();
    named(channel_faults(|t| mark(&mut t[1], 7, &gone)), "mark 8 in line");
    named(channel_faults(|t| mark(&mut t[1], 7, &gone)), "which meets mark 9 in line");
    named(channel_faults(|t| t.iter_mut().for_each(|t| mark(t, 7, &gone))), "mark 9 in line");
    named(channel_faults(|t| t.iter_mut().for_each(|t| mark(t, 7, &gone))), "missing or too many");
    let last = |t: &mut String| mark(t, 58, &gone);
    named(channel_faults(|t| t.iter_mut().for_each(last)), "58 in channel 1, 58 in channel 2, wanted 59");
    named(channel_faults(|t| last(&mut t[0])), "where channel 1 has no more");
    let renumbered =
        |to: u32| move |l: &str| l.replacen(",1,2)", ")", 1).replacen("WAITM(8)", &format!("WAITM({to},1,2)"), 1);
    named(channel_faults(|t| mark(&mut t[0], 7, &renumbered(7))), "mark 7 in line");
    named(channel_faults(|t| mark(&mut t[0], 7, &|l| format!("{l}\n{l}"))), "where 9 comes next");
    let swapped = |t: &mut String| {
        mark(t, 7, &|l| l.replace("WAITM(8", "WAITM(9"));
        mark(t, 8, &|l| l.replace("WAITM(9", "WAITM(8"));
    };
    named(channel_faults(|t| swapped(&mut t[0])), "wait marks out of their order");
    named(channel_faults(|t| swapped(&mut t[0])), "one channel waits for ever");
    named(channel_faults(|t| t.iter_mut().for_each(swapped)), "where 8 comes next");
    named(channel_faults(|t| mark(&mut t[1], 7, &|l| l.replace(",1,2)", ",2)"))), "does not wait for channels 1 and 2");
    // The table, in the program of its own channel and in the other's.
    let cut = |text: &mut String, n: usize, change: &dyn Fn(&str) -> String| *text = with_line(text, n, is_cut, change);
    named(channel_faults(|t| cut(&mut t[0], CUT, &|l| l.replace("G1 ", "G1 A=DC(11.5) "))), "A in line");
    named(channel_faults(|t| cut(&mut t[1], CUT, &|l| l.replace("G1 ", "G1 A=DC(11.5) "))), "A in line");
    named(channel_faults(|t| t.swap(0, 1)), "the other channel's");
    // Lines that one lacks, a rapid amid a row, a channel that is slower.
    named(channel_faults(|t| cut(&mut t[1], CUT, &gone)), "lines of channel 1 and");
    named(channel_faults(|t| cut(&mut t[1], CUT, &|l| format!("G0 W-300\nG1\n{l}"))), "a rapid in line");
    let slow = |l: &str| if is_cut(l) { moved(l, "F", -0.1 * word(l, "F")) } else { l.to_owned() };
    named(
        channel_faults(|t| t[1] = t[1].lines().map(slow).collect::<Vec<_>>().join("\n")),
        "time between the channels",
    );
    // One waits beside the place that it is to go down from.
    let over = |l: &str| l.contains("G0 U=") && token(l, "W").is_some();
    named(
        channel_faults(|t| t[1] = with_line(&t[1], 4, over, |l| moved(l, "V", 3.0))),
        "distance of both tools at wait marks",
    );
    // A program in one channel does not wait.
    let waits = program_faults("siemens", |t| t.replacen("N120 ", "N120 WAITM(1,1,2) ", 1));
    assert_eq!(waits, [CheckId::ProgramReadable]);
}

/// Whichever of the two lags: no place of one tool is near any of the other between two marks.
#[test]
fn tools_stay_apart_however_far_one_lags() {
    let (setup, pinch, programmed) = programmed();
    let texts = channels();
    let apart = |asked_mm: f64| {
        let work = PinchWork { tools_apart_mm: asked_mm, ..setup.pinch_work(pinch) };
        let asked = PinchAsked {
            cutting_s: programmed.motion.cutting_s,
            spindle_rpm: [6000.0; 2],
            tolerance_mm: 0.001,
            skew_s: None,
        };
        let texts = [texts[0].as_str(), texts[1].as_str()];
        let checks = verify::check_pinch_program(&texts, &work, &setup.machine, &asked, &setup.verify_options());
        checks.into_iter().find(|c| c.id == CheckId::ToolsApart).expect("the check")
    };
    // Between the balls alone, over all pairs of places of a row.
    let mut least_mm = f64::INFINITY;
    for Held { places, .. } in &pinch.held {
        let row = &pinch.rows.places[places.clone()];
        let gap = |a: usize, b: usize| (row[a].contacts[0].centre - row[b].contacts[1].centre).norm() - 4.0;
        let pairs = (0..row.len()).flat_map(|a| (0..row.len()).map(move |b| (a, b)));
        least_mm = pairs.map(|(a, b)| gap(a, b)).fold(least_mm, f64::min);
    }
    assert!(least_mm > 0.5 && least_mm <= pinch.figures.tools_apart_mm + 1e-9, "{least_mm}");
    let near = apart(0.98 * least_mm);
    assert!(near.passed && near.worst >= 0.98 * least_mm && near.worst <= least_mm + 1e-9, "{near:?} {least_mm}");
    assert!(!apart(1.02 * least_mm).passed);
}

#[test]
fn the_second_tool_has_a_ball_of_its_own() {
    let machine = format!("machine.file={TWO_HEADS:?}");
    let keys = ["tool_2.radius_mm=3", "pinch.spindle_2_rpm=4500", "post.control=[\"siemens\"]"];
    let (setup, pinch) = std::thread::scope(|s| {
        let plan = || plan_for(&[&machine, keys[0], keys[1], keys[2]]);
        s.spawn(plan).join().expect("planned")
    });
    let tools = setup.pinch_tools();
    let radius_mm = tools.map(|t| t.radius_mm);
    assert_eq!((radius_mm, pinch.rows.radius_mm), ([2.0, 3.0], [2.0, 3.0]));
    let lengths_mm = tools.map(|t| t.length_mm());
    assert!(lengths_mm[1] - lengths_mm[0] > 1.0, "{lengths_mm:?}");
    for place in &pinch.rows.places {
        for (c, radius_mm) in place.contacts.iter().zip(radius_mm) {
            let near = setup.blade.part.closest(&c.centre, 10.0).expect("near the part");
            assert!((near.distance_mm - radius_mm).abs() < 1e-5 && (near.point - c.contact).norm() < 1e-4);
        }
    }
    let programmed = setup.pinch_program(&pinch, &Silent).expect("a program").expect("two heads");
    let failed: Vec<&Check> = pinch.checks.iter().chain(programmed.all_checks()).filter(|c| !c.passed).collect();
    assert!(failed.is_empty(), "{failed:?}");
    // The machine puts each ball in its place by the length of its own tool.
    for s in &programmed.motion.stretches {
        for (row, k) in s.motion.position.iter().zip(s.places.clone()) {
            for j in 0..2 {
                let pose = setup.machine.forward_of(j, row, lengths_mm[j]).expect("a head");
                assert!((pose.centre - pinch.rows.places[k].contacts[j].centre).norm() < 1e-6);
            }
        }
    }
    let text = &programmed.programs[0].files[0].text;
    for says in ["Tool 1 ball end, R 2.0000 mm", "Tool 2 ball end, R 3.0000 mm", "S1=6000 M1=3", "S2=4500 M2=3"] {
        assert!(text.contains(says), "{says}");
    }
    for (length_mm, radius_mm) in lengths_mm.iter().zip(radius_mm) {
        assert!(text.contains(&format!("stand out {:.4} mm", length_mm + radius_mm)));
    }
    let siemens = Dialect::built_in(Control::Siemens).expect("a dialect");
    let files = setup.pinch_files(&siemens, &programmed.motion, 2).expect("programs");
    assert!(files[0].text.contains("S6000 M3") && files[1].text.contains("S4500 M3"));
    let found = setup.read_back_pinch(&siemens, &files, &pinch, &programmed.motion);
    assert!(found.iter().all(|c| c.passed), "{found:?}");
    // Tools in the wrong spindles: the larger ball gouges, and the smaller leaves ridges.
    let wrong = PinchWork { tools: [tools[1], tools[0]], ..setup.pinch_work(&pinch) };
    let (checks, _) = verify::check_pinch(&wrong, &setup.verify_options());
    let gouge = checks.iter().find(|c| c.id == CheckId::Gouge && !c.passed).expect("a gouge");
    assert!(gouge.quantity.starts_with("tool 1") && gouge.worst > 0.9, "{gouge:?}");
    // A second tool like the first: its ball is elsewhere by what the lengths differ.
    let alike = PinchWork { tools: [tools[0]; 2], ..setup.pinch_work(&pinch) };
    let cutting_s = programmed.motion.cutting_s;
    let asked = PinchAsked { cutting_s, spindle_rpm: [6000.0, 4500.0], tolerance_mm: 0.001, skew_s: None };
    let checks = verify::check_pinch_program(&[text.as_str()], &alike, &setup.machine, &asked, &setup.verify_options());
    assert!(checks.iter().any(|c| c.id == CheckId::ProgramMissing && !c.passed), "{checks:?}");
    let same = PinchAsked { spindle_rpm: [6000.0; 2], ..asked };
    let work = setup.pinch_work(&pinch);
    let checks = verify::check_pinch_program(&[text.as_str()], &work, &setup.machine, &same, &setup.verify_options());
    let failed: Vec<&CheckId> = checks.iter().filter(|c| !c.passed).map(|c| &c.id).collect();
    assert_eq!(failed, [&CheckId::ProgramSpindle]);
}

#[test]
fn the_second_tool_takes_angles_by_its_own_shape() {
    let (_, usual) = planned();
    let (_, pinch) = std::thread::scope(|s| {
        s.spawn(|| plan_for(&["tool_2.stickout_mm=25", "tool_2.shank_radius_mm=3"])).join().expect("planned")
    });
    assert_eq!(pinch.rows, usual.rows);
    assert_eq!(pinch.own[0], usual.own[0]);
    let widths = pinch.own[1].iter().zip(&usual.own[1]).map(|(a, b)| (a.widest(), b.widest()));
    let lost: Vec<f64> = widths.map(|(a, b)| (b - a).to_degrees()).collect();
    let [least, most] = [f64::min, f64::max].map(|of| lost.iter().copied().reduce(of).expect("places"));
    assert!(least > -0.05 && most > 5.0, "its holder is nearer, and nothing else: {least} to {most}");
    assert!(pinch.checks.iter().all(|c| c.passed), "{:?}", pinch.checks);
}

/// The job that a run leaves has both tools complete, and is the same run again.
#[test]
fn a_job_of_two_tools_runs_again_as_it_is() {
    let folder = tempfile::tempdir().expect("a folder");
    let (first, again) = (folder.path().join("first"), folder.path().join("again"));
    let library = format!("tool_2.library={:?}", concat!(env!("CARGO_MANIFEST_DIR"), "/models/tools/library.json"));
    let mut arguments = vec![MODEL, "--set", &library, "--set", "tool_2.entry=12", "--set", "tool.stickout_mm=40"];
    let machine = format!("machine.file={TWO_HEADS:?}");
    arguments.extend(["--set", &machine, "--set", "path.scallop_mm=0.3", "--set", "tool.radius_mm=2.5"]);
    let ran = command(&arguments, &first);
    assert!(ran.status.success(), "{ran:?}");
    let job = first.join("job.resolved.toml");
    let text = std::fs::read_to_string(&job).expect("the job");
    let job_of = |text: &str| -> toml::Table { toml::from_str(text).expect("TOML") };
    let second = job_of(&text)["tool_2"].as_table().expect("tool 2").clone();
    assert!(!second.contains_key("library") && second["radius_mm"].as_float().is_some_and(|r| r != 2.5), "{second:?}");
    assert!(second["holder"].as_array().is_some_and(|h| !h.is_empty()) && second.contains_key("stickout_mm"));
    let ran = command(&[job.to_str().expect("a path")], &again);
    assert!(ran.status.success(), "{ran:?}");
    for name in ["job.resolved.toml", "pairs.csv", "pinch.mpf", "pinch.ngc", "pinch_axes.csv"] {
        let [a, b] = [&first, &again].map(|folder| std::fs::read(folder.join(name)).expect(name));
        assert!(a == b, "{name}");
    }
}

#[test]
fn post_files_say_what_is_wrong_with_their_lines_for_two_tools() {
    let machine = &programmed().0.machine;
    let siemens = Control::Siemens.post_file();
    for (from, to, says) in [
        ("file = \"pinch.mpf\"", "file = \"../pinch.mpf\"", "pinch.file must be a file name"),
        ("file = \"pinch.mpf\"", "file = \"pinch.json\"", "the ending of a file of another kind"),
        ("file = \"pinch_ch{channel}.mpf\"", "file = \"pinch_ch1.mpf\"", "pinch_channels.file must have {channel}"),
        ("last_mark = 99", "last_mark = 1", "last_mark must be 2 to 9999"),
        ("axis = \"{name}={at}\"", "axis = \"{name}\"", "axis must be one word"),
        ("\"G1 {moving} F{f}\", \"G94\"]", "\"G1 {moved} F{f}\"]", "there is no value {moved}"),
        ("\"WAITM({mark},1,2) ; both tools are up\",", "", "start has {mark} 0 times"),
        ("down = [\"G1 {moving} F{f}\"]", "down = []", "down, cut and up must have at least one line"),
    ] {
        assert!(siemens.contains(from), "{from}");
        let refused = Dialect::from_toml(&siemens.replacen(from, to, 1), "own.toml").expect_err(from);
        assert!(refused.message.contains(says) && refused.message.starts_with("own.toml"), "{}", refused.message);
    }
    let section = siemens.split_once("[pinch]").expect("the section").1;
    let section = section.split_once("[pinch_channels]").expect("the section behind it").0;
    let klartext = format!("{}\n[pinch]{section}", Control::Heidenhain.post_file());
    let refused = Dialect::from_toml(&klartext, "own.toml").expect_err("Klartext");
    assert!(refused.message.contains("need grammar = \"gcode\""), "{}", refused.message);
    let few = Control::Iso.post_file().replace("[pinch]\n", "[pinch]\nletters = \"XYZABUVW\"\n");
    let few = Dialect::from_toml(&few, "own.toml").expect("a post file");
    let refused = post::pinch::pinch_text(&few, machine, 1).expect_err("eight letters");
    assert!(refused.message.contains("has no letter for axis C of the machine pinch_9x"), "{}", refused.message);
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
        assert!((row[26] - held.theta_at(k).to_degrees()).abs() < 1e-9 && row[30] <= row[26] && row[26] <= row[31]);
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
    // The report is named among the files, and shows the figures of the file.
    assert!(String::from_utf8_lossy(&ran.stdout).lines().any(|line| line.ends_with("report.html")), "{ran:?}");
    let checks = figures["checks"].as_array().map_or(0, Vec::len);
    let shown = crate::cli::figures_are_those_of(&out, &["pinch"]);
    assert!(shown > 30 + 2 * checks, "{shown} figures");
    let page = std::fs::read_to_string(out.join("report.html")).expect("a page");
    assert!(page.len() < 4_000_000 && page.contains(&format!("All {checks} checks passed")));
}

/// The report of a run stays.
#[test]
fn a_folder_with_a_run_is_refused() {
    let folder = tempfile::tempdir().expect("a folder");
    let manifest = r#"{ "schema_version": 1, "program": "", "build": "", "inputs": [], "job": {}, "stages": [],
        "warnings": [], "outputs": {}, "status": "good" }"#;
    std::fs::write(folder.path().join("manifest.json"), manifest).expect("written");
    std::fs::write(folder.path().join("report.html"), "of the run").expect("written");
    let ran = command(&[MODEL], folder.path());
    assert_eq!(ran.status.code(), Some(2), "{ran:?}");
    assert!(String::from_utf8_lossy(&ran.stderr).contains("holds a run, whose report.html would be replaced"));
    assert_eq!(std::fs::read_to_string(folder.path().join("report.html")).expect("there"), "of the run");
}

#[test]
fn what_cannot_be_held_leaves_nothing_behind() {
    let folder = tempfile::tempdir().expect("a folder");
    let mesh = concat!(env!("CARGO_MANIFEST_DIR"), "/models/turbine_camber.obj");
    let job = concat!(env!("CARGO_MANIFEST_DIR"), "/examples/jobs/wheel.toml");
    let machine = format!("machine.file={TWO_HEADS:?}");
    let with = |keys: &[&'static str]| {
        let mut all = vec![MODEL, "--set", &machine];
        keys.iter().for_each(|key| all.extend(["--set", *key]));
        all
    };
    for (arguments, code, says) in [
        (vec![mesh], 3, "the part is a mesh"),
        (vec![MODEL, "--set", "pinch.heights_mm=[30, 20]"], 2, "the airfoil lies between"),
        (vec![MODEL, "--set", "pinch.max_angle_deg=0"], 2, "pinch.max_angle_deg is 0"),
        (vec![MODEL, "--set", "pinch.tools_apart_mm=9"], 3, "no place of the suction side has an opposite one"),
        (vec![MODEL, "--set", "pinch.between_deg=20", "--set", "path.scallop_mm=0.3"], 3, "free for both tools"),
        (vec![MODEL, "--set", "pinch.b_2_deg=89"], 2, "pinch.b_2_deg is 89"),
        (vec![job], 2, "each keeps one lean"),
        (with(&["post.control=[\"heidenhain\"]"]), 2, "Heidenhain TNC has no programs of two tools"),
        (with(&["pinch.channels=2"]), 2, "LinuxCNC has programs of two tools in one channel only"),
        (with(&["pinch.channels=3"]), 2, "pinch.channels is 3"),
        (with(&["tool_2.radius_mm=0"]), 2, "tool_2.radius_mm is 0"),
        (with(&["tool_2.radius_mm=3", "tool_2.shank_radius_mm=1"]), 2, "tool_2.shank_radius_mm is 1"),
        (with(&["tool_2.radius_mm=3", "tool_2.corner_radius_mm=1"]), 2, "tool_2.corner_radius_mm"),
        (with(&["tool_2.radius_mm=0.005"]), 2, "tool_2.radius_mm is 0.005, it must be at least"),
        (with(&["tool_2.entry=3"]), 2, "tool_2.entry is given, but no library"),
        (with(&["pinch.spindle_2_rpm=0"]), 2, "pinch.spindle_2_rpm is 0"),
    ] {
        let out = folder.path().join("out");
        let ran = command(&arguments, &out);
        let text = String::from_utf8_lossy(&ran.stderr);
        assert_eq!(ran.status.code(), Some(code), "{arguments:?}: {text}");
        assert!(text.contains(says), "{arguments:?}: {text}");
        assert!(!out.exists(), "{arguments:?}");
    }
}

/// Rows round both edges close the airfoil; what is wrong with them is found.
#[test]
fn rows_round_the_edges_close_the_airfoil() {
    let (setup, pinch) = plan_for(&["pinch.edges=\"both\""]);
    let failed: Vec<&Check> = pinch.checks.iter().filter(|c| !c.passed).collect();
    assert!(failed.is_empty(), "{failed:?}");
    let rows = &pinch.rows;
    assert!(rows.edge_rows > 2 && rows.held_rows() > 20, "{} {}", rows.edge_rows, rows.held_rows());
    let border = pinch.figures.border_ridges_mm;
    assert!(border[1] > 0.0 && border[3] < 0.103, "{border:?}");
    // The normals of both tools turn together, from one side to the other.
    let normals = |row: usize| rows.places[rows.rows[row].start].contacts.map(|c| c.normal);
    let (first, last) = (normals(rows.held_rows()), normals(rows.rows.len() - 1));
    for j in 0..2 {
        assert!(first[j].dot(&last[j]) < -0.3, "tool {}: {} {}", j + 1, first[j], last[j]);
    }
    let faults = |rows: PairedRows| -> Vec<String> {
        let work = PinchWork { rows: &rows, ..setup.pinch_work(&pinch) };
        let (checks, _) = verify::check_pinch(&work, &setup.verify_options());
        checks.into_iter().filter(|c| !c.passed).map(|c| format!("{} {}", c.id, c.quantity)).collect()
    };
    assert!(faults(rows.clone()).is_empty());
    // Tool 1 goes round its edge in the row after, so beside the first of them a row is missing.
    let mut late = rows.clone();
    let n = rows.rows.len();
    let shift = |late: &mut PairedRows, tool: usize, from: usize| {
        for row in from..n - 1 {
            let next = rows.places[rows.rows[row + 1].clone()].to_vec();
            let places = late.rows[row].clone();
            for (i, k) in places.enumerate() {
                late.places[k].contacts[tool] = next[(i * next.len()) / rows.rows[row].len()].contacts[tool];
            }
        }
    };
    shift(&mut late, 0, rows.held_rows());
    let found = faults(late);
    assert!(found.iter().any(|f| f.starts_with("ridge tool 1")), "{found:?}");
}

/// A stretch from a place to the next is one line, as each move is.
#[test]
fn a_stretch_of_two_places_is_read_back() {
    let machine = format!("machine.file={TWO_HEADS:?}");
    let (setup, mut pinch) = plan_for(&[&machine, &format!("post.control={CONTROLS:?}")]);
    let last = pinch.held.pop().expect("a stretch");
    let (from, end) = (last.places.start, last.places.end);
    for places in [from..end - 1, end - 2..end] {
        pinch.held.push(Held::still(last.row, places, last.ends_rad()[0], last.margin_rad));
    }
    let programmed = setup.pinch_program(&pinch, &Silent).expect("a program").expect("two heads");
    let failed: Vec<&Check> = programmed.all_checks().filter(|c| !c.passed).collect();
    assert!(failed.is_empty(), "{failed:?}");
    assert_eq!(programmed.motion.stretches.last().map(|s| s.places.len()), Some(2));
}

/// Plans with a short tool, for which some rows have no one angle; on a thread of its own.
fn plan_short(orientation: &str) -> (Setup, Pinch) {
    let machine = format!("machine.file={TWO_HEADS:?}");
    let orientation = format!("pinch.orientation=\"{orientation}\"");
    let controls = "post.control=[\"linuxcnc\", \"siemens\", \"iso\"]";
    let plan = || plan_for(&[&machine, "tool.stickout_mm=8", controls, &orientation]);
    std::thread::scope(|s| s.spawn(plan).join().expect("planned"))
}

fn failed(pinch: &Pinch, programmed: &PinchProgrammed) -> Vec<CheckId> {
    let all = pinch.checks.iter().chain(programmed.all_checks());
    all.filter(|c| !c.passed).map(|c| c.id.clone()).collect()
}

/// Along rows without one free angle the table turns while both tools cut, hardly faster than it
/// must; the rest of the rows are as ever.
#[test]
fn rows_without_one_angle_turn_as_slowly_as_can_be() {
    let (mut setup, mut pinch) = plan_short("smooth");
    let turning: Vec<&Held> = pinch.held.iter().filter(|h| !h.is_still()).collect();
    assert!(!turning.is_empty() && turning.len() < pinch.held.len() / 2, "{}", turning.len());
    assert_eq!(pinch.still_rows() + turning.len(), pinch.rows.rows.len());
    let mut steepest = 0f64;
    for h in turning {
        assert_eq!(h.places, pinch.rows.rows[h.row], "one stretch");
        for (k, theta) in h.places.clone().zip(&h.theta_rad) {
            assert!(pinch.common[k].margin(*theta) >= h.margin_rad - 1e-9 && h.margin_rad >= 0.0);
        }
        // By the contacts themselves, for either tool.
        for k in h.places.start..h.places.end - 1 {
            for j in 0..2 {
                let axis = |k: usize| setup.pinch_cones()[j].tool_axis(h.theta_at(k));
                let [a, b] = [k, k + 1].map(|k| pinch.rows.places[k].contacts[j].contact);
                steepest = steepest.max((axis(k + 1) - axis(k)).norm() / (b - a).norm());
            }
        }
    }
    assert!(pinch.least_slope > 1e-4 && steepest <= 1.02 * pinch.least_slope, "{steepest} {}", pinch.least_slope);
    let measured = pinch.figures.turning_rad_mm.into_iter().fold(0.0, f64::max);
    assert!((measured - steepest).abs() < 1e-9, "{measured} {steepest}");
    let programmed = setup.pinch_program(&pinch, &Silent).expect("a program").expect("two heads");
    assert!(failed(&pinch, &programmed).is_empty(), "{:?}", failed(&pinch, &programmed));
    // The table of the machine does turn while both cut.
    let a = setup.machine.turning_axis();
    let way = |s: &bladewright::artifact::paired::StretchMotion| {
        let rows: Vec<f64> = s.motion.position.iter().map(|r| r[a]).collect();
        rows.windows(2).map(|w| (w[1] - w[0]).abs()).sum::<f64>()
    };
    let turned: f64 = pinch.held.iter().map(Held::turned_rad).sum();
    let by_axis: f64 = programmed.motion.stretches.iter().map(way).sum();
    assert!(turned > 0.01 && (by_axis - turned).abs() < 1e-6, "{by_axis} {turned}");
    // One line in which the table lags is found.
    let (name, dialect) = setup.pinch_dialects().expect("dialects").remove(0);
    assert_eq!(name, "linuxcnc");
    let text = &programmed.programs[0].files[0].text;
    let turns = |l: &str| is_cut(l) && token(l, "A").is_some();
    let late = with_line(text, 3, turns, |l| moved(l, "A", 0.1));
    let files = [PinchFile { name: "late.ngc".into(), text: late }];
    let found = setup.read_back_pinch(&dialect, &files, &pinch, &programmed.motion);
    let found: Vec<CheckId> = found.into_iter().filter(|c| !c.passed).map(|c| c.id).collect();
    assert!(found.contains(&CheckId::ProgramDirection), "{found:?}");
    in_two_channels(&mut setup, &pinch, &programmed);
    // A turn of 6 degrees from a place to the next leads the balls off the straight way.
    let still = pinch.held.iter_mut().find(|h| h.is_still()).expect("a still row");
    let middle = still.theta_rad.len() / 2;
    still.theta_rad[middle..].iter_mut().for_each(|theta| *theta += 0.1);
    let programmed = setup.pinch_program(&pinch, &Silent).expect("a program").expect("two heads");
    assert!(failed(&pinch, &programmed).contains(&CheckId::ProgramChord), "{:?}", failed(&pinch, &programmed));
}

/// In two channels the table may turn where the job says how far these may be apart, and a tool
/// that is then beside its place is found as deep as it is.
fn in_two_channels(setup: &mut Setup, pinch: &Pinch, programmed: &PinchProgrammed) {
    let siemens = Dialect::built_in(Control::Siemens).expect("a dialect");
    let motion = &programmed.motion;
    let refused = setup.pinch_files(&siemens, motion, 2).expect_err("no skew is known");
    assert!(refused.message.contains("while both tools cut"), "{}", refused.message);
    let mut checks = |skew_ms: f64| {
        let asked = setup.job.pinch.get_or_insert_default();
        (asked.skew_ms, asked.channels) = (Some(skew_ms), 2);
        let files = setup.pinch_files(&siemens, motion, 2).expect("programs");
        assert!(files[1].text.contains(&format!("at most {skew_ms} ms apart")), "{}", &files[1].text[..900]);
        setup.read_back_pinch(&siemens, &files, pinch, motion)
    };
    let of = |checks: &[Check], id: CheckId| -> Check {
        let mine = |c: &&Check| c.id == id && c.quantity.contains("ms apart");
        checks.iter().find(mine).expect("the check").clone()
    };
    let near = checks(0.1);
    assert!(near.iter().all(|c| c.passed), "{:?}", near.iter().filter(|c| !c.passed).collect::<Vec<_>>());
    let skew_s = 0.4;
    let far = of(&checks(1e3 * skew_s), CheckId::Gouge);
    // By the motion itself: the second head as it stands, the table as it does before and after.
    let (a, tool) = (setup.machine.turning_axis(), setup.pinch_tools()[1]);
    let mut deepest = 0f64;
    for s in &motion.stretches {
        let (t, rows) = (&s.motion.t_s, &s.motion.position);
        for k in 0..t.len() {
            for by in [-skew_s, skew_s] {
                let n = t.partition_point(|at| *at < t[k] + by).min(t.len() - 1);
                let mut at: Vec<f64> = rows[k].to_vec();
                at[a] = rows[n][a];
                let pose = setup.machine.forward_of(1, &at, tool.length_mm()).expect("a pose");
                let near = setup.blade.part.closest(&pose.centre, f64::INFINITY).expect("a part");
                deepest = deepest.max(tool.radius_mm - near.distance_mm);
            }
        }
    }
    assert!(deepest > 0.01 && !far.passed, "{deepest} {far:?}");
    assert!((far.worst / deepest - 1.0).abs() < 0.1, "{deepest} {far:?}");
    setup.job.pinch.get_or_insert_default().channels = 1;
}

/// What takes less time is taken row by row, and the published way is there to compare with.
#[test]
fn orientations_are_compared() {
    let cutting_s = |orientation: &str| {
        let (setup, pinch) = plan_short(orientation);
        let programmed = setup.pinch_program(&pinch, &Silent).expect("a program").expect("two heads");
        assert!(failed(&pinch, &programmed).is_empty(), "{orientation}: {:?}", failed(&pinch, &programmed));
        (pinch, programmed.motion.cutting_s)
    };
    let [hold, smooth, time, paper] = ["hold", "smooth", "time", "paper"].map(cutting_s);
    let stretches = |of: &(Pinch, f64)| of.0.held.len();
    assert!(stretches(&hold) > stretches(&smooth) && hold.0.held.iter().all(Held::is_still));
    // The way up, over and down again takes longer than the turn.
    assert_eq!(time.0.held, smooth.0.held);
    assert!(smooth.1 < hold.1 + 0.2, "{} {}", smooth.1, hold.1);
    let published = paper.0.published.as_ref().expect("figures");
    assert!(hold.0.published.is_none());
    let most = |of: [f64; 2]| of.into_iter().fold(0.0, f64::max);
    let [fixed, curve, last, ours] = [
        published.fixed_rad_mm,
        published.posture_rad_mm,
        paper.0.figures.turning_rad_mm,
        smooth.0.figures.turning_rad_mm,
    ]
    .map(most);
    assert!(
        curve < fixed && ours < 0.5 * last && paper.0.still_rows() < hold.0.still_rows(),
        "{fixed} {curve} {last} {ours}"
    );
    assert!(published.posture_outside > 0, "{published:?}");
    assert!(paper.1 > 1.01 * smooth.1, "{} {}", paper.1, smooth.1);
}

#[test]
fn a_table_that_may_turn_is_refused_where_nothing_could_keep_time() {
    let refused = |keys: &[&str]| {
        let mut job = JobFile::from_model(Path::new(MODEL));
        let file = format!("machine.file=\"{TWO_HEADS}\"");
        let all = [&KEYS[..], &[file.as_str()], keys].concat();
        all.iter().for_each(|key| job.set(key).expect("a key"));
        let setup = Loaded::read(&inputs::draft(job, Path::new("")).expect("a draft"), &Silent).expect("a blade").setup;
        let e = setup.pinch_dialects().expect_err("refused");
        assert_eq!(e.kind.exit_code(), 2);
        e.message
    };
    let smooth = "pinch.orientation=\"smooth\"";
    let two = refused(&[smooth, "pinch.channels=2", "post.control=[\"siemens\"]"]);
    assert!(
        two.contains("pinch.channels is 2: channels keep time by wait marks only, so the table must stand"),
        "{two}"
    );
    let minute = refused(&[smooth, "post.control=[\"fanuc\"]"]);
    assert!(minute.contains("takes F per minute, which counts degrees of the table as well as mm"), "{minute}");
}

/// Jobs of a double helix, short: a blade whose helix has few turns.
fn threads(more: &[&str]) -> JobFile {
    let mut job = JobFile::from_model(Path::new(MODEL));
    let keys = ["tool.radius_mm=2", "path.scallop_mm=0.1", "region.end_mm=6", "pinch.topology=\"double-helix\""];
    keys.iter().chain(more).for_each(|key| job.set(key).expect("a key"));
    job.set(&format!("machine.file={TWO_HEADS:?}")).expect("a key");
    job
}

fn setup_of(job: JobFile) -> Setup {
    Loaded::read(&inputs::draft(job, Path::new("")).expect("a draft"), &Silent).expect("a blade").setup
}

/// Two threads leave the ridges of one helix in about half as many turns, the table turns one way
/// all along, and the checks find what is wrong with them.
#[test]
fn two_threads_go_round_in_half_the_turns() {
    let setup = setup_of(threads(&[]));
    let pinch = setup.pinch(&Silent).expect("threads");
    let programmed = setup.pinch_program(&pinch, &Silent).expect("a program").expect("two heads");
    assert_eq!(failed(&pinch, &programmed), []);
    let helix = setup.path(&Silent).expect("a helix");
    let turns = pinch.rows.turns.as_ref().expect("threads");
    // Each thread takes half a turn more than half of the helix, and both together run all of it.
    let whole = helix.turns.len() as f64;
    for of in turns {
        let own = f64::from(of.last().copied().expect("places")) + 1.0;
        assert!((own - 0.5 * (whole + 1.0)).abs() < 1.01, "{own} {whole}");
    }
    let of_helix: f64 = helix.turns.iter().map(|t| t.length_mm).sum();
    for tool in 0..2 {
        let length = pinch.rows.length_mm(tool);
        assert!((length / of_helix - 0.5 * (whole + 1.0) / whole).abs() < 0.05, "{length} {of_helix}");
    }
    let h = pinch.rows.scallop_mm;
    for ridges in pinch.figures.ridges_mm {
        assert!(ridges[1] > 0.93 * h && ridges[3] < 1.05 * h && ridges[4] < 1.5 * h, "{ridges:?}");
    }
    let [held] = &pinch.held[..] else { panic!("{} stretches", pinch.held.len()) };
    assert!(held.theta_rad.windows(2).all(|w| w[1] >= w[0]) && held.turned_rad() > 8.0);
    // Nothing is held, and it is said how far that is from being so.
    assert!(pinch.checks.iter().all(|c| c.id != CheckId::Opposition) && pinch.figures.angle_deg[2] > 0.0);

    let faults = |change: &dyn Fn(&mut PairedRows, &mut Vec<Held>)| -> Vec<CheckId> {
        let (mut rows, mut held) = (pinch.rows.clone(), pinch.held.clone());
        change(&mut rows, &mut held);
        let work = PinchWork { rows: &rows, held: &held, ..setup.pinch_work(&pinch) };
        let (checks, _) = verify::check_pinch(&work, &setup.verify_options());
        checks.into_iter().filter(|c| !c.passed).map(|c| c.id).collect()
    };
    assert_eq!(faults(&|_, _| {}), []);
    let deep =
        faults(&|rows, _| rows.places.iter_mut().for_each(|p| p.contacts[1].centre -= p.contacts[1].normal * 0.05));
    assert!(deep.contains(&CheckId::Gouge), "{deep:?}");
    // Thread 2 stands clear of the part: what it should cut is left.
    let away =
        faults(&|rows, _| rows.places.iter_mut().for_each(|p| p.contacts[1].centre += p.contacts[1].normal * 30.0));
    assert!(away.contains(&CheckId::Ridge), "{away:?}");
    let turned =
        faults(&|_, held| held.iter_mut().for_each(|h| h.theta_rad.iter_mut().for_each(|theta| *theta += 1.6)));
    assert!(turned.contains(&CheckId::Clearance), "{turned:?}");
    let short = faults(&|_, held| held.iter_mut().for_each(|h| h.places.end -= 40));
    assert!(short.contains(&CheckId::PairRows), "{short:?}");

    // A line of its program that is left out.
    let (_, dialect) = &setup.pinch_dialects().expect("dialects")[0];
    let posted = &programmed.programs[0].files;
    let cut = posted[0].text.lines().filter(|l| is_cut(l)).count();
    let missing = with_line(&posted[0].text, cut / 2, is_cut, |_| String::new());
    let missing = vec![PinchFile { name: posted[0].name.clone(), text: missing }];
    let found = setup.read_back_pinch(dialect, &missing, &pinch, &programmed.motion);
    assert!(found.iter().any(|c| !c.passed), "a line is missing");
}

#[test]
fn keys_for_rows_have_no_say_in_a_double_helix() {
    for (key, words) in [
        ("tool_2.radius_mm=3", "balls of one radius"),
        ("pinch.edges=\"both\"", "pinch.edges is for rows"),
        ("pinch.heights_mm=[6, 30]", "pinch.heights_mm is for rows"),
        ("pinch.orientation=\"smooth\"", "pinch.orientation is for rows"),
        ("schedule.kind=\"fixed\"", "schedule.kind is fixed"),
        ("path.kind=\"constant-height\";region.end_mm=11.6", "a double helix needs 3 at least"),
    ] {
        let keys: Vec<&str> = key.split(';').collect();
        let e = setup_of(threads(&keys)).pinch(&Silent).map(|_| ()).expect_err(key);
        assert!(e.to_string().contains(words), "{key}: {e}");
    }
    let mesh = concat!(env!("CARGO_MANIFEST_DIR"), "/models/turbine_camber.obj");
    let job = JobFile { model: JobFile::from_model(Path::new(mesh)).model, ..threads(&[]) };
    let e = setup_of(job).pinch(&Silent).map(|_| ()).expect_err("a mesh");
    assert!(e.to_string().contains("the part is a mesh"), "{e}");
    let e = setup_of(threads(&[])).pinch_advice(&[5.0], &Silent).expect_err("rows");
    assert!(e.to_string().contains("advised for rows"), "{e}");
    // Two channels would have to keep time.
    let setup = setup_of(threads(&["pinch.channels=2", "post.control=[\"siemens\"]"]));
    let e = setup.pinch_dialects().map(|_| ()).expect_err("no skew is stated");
    assert!(e.to_string().contains("pinch.skew_ms"), "{e}");
}
