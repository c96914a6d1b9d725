//! Programs inside what their controls read, and what heads them.

use super::*;
use crate::artifact::program::Programmed;
use crate::artifact::{Axes, CheckId};
use crate::error::Infeasible;
use crate::machine::Axis;
use crate::read::program::{self, Bench, Moved, Zero};

fn checks(p: &Program, plan: &Plan) -> Vec<crate::artifact::report::Check> {
    read_back(p, plan, &sample::blade(), &sample::tool(), &Machine::demo().unwrap()).unwrap()
}

fn failed(p: &Program, plan: &Plan) -> Vec<String> {
    checks(p, plan).into_iter().filter(|c| !c.passed).map(|c| format!("{} {} {}", c.id, c.worst, c.note)).collect()
}

fn moves(p: &Program) -> Vec<Moved> {
    let (tool, machine) = (sample::tool(), Machine::demo().unwrap());
    let bench = Bench { language: p.language, zero: Zero::default(), tool: &tool, machine: &machine };
    program::follow(&program::read(&p.text, p.language).unwrap().blocks, &bench).unwrap()
}

/// Numbers of words that begin with a prefix, comments left out.
fn numbers(text: &str, prefix: &str) -> Vec<String> {
    let code = |l: &str| l.split(['(', ';']).next().unwrap_or("").to_owned();
    let words: Vec<String> =
        text.lines().flat_map(|l| code(l).split(' ').map(String::from).collect::<Vec<_>>()).collect();
    let number = |w: &String| Some(w.strip_prefix(prefix)?.to_owned()).filter(|n| n.parse::<f64>().is_ok());
    words.iter().filter_map(number).collect()
}

/// 24 000 locations of 2 ms each: more lines than five digits number, and F over 9999.999 under
/// inverse time.
#[test]
fn fanuc_keeps_to_five_digits_of_n_and_its_range_of_f() {
    let plan = sample::with_leads(sample::plan(6, 4000));
    for control in [Control::Fanuc, Control::FanucVector] {
        let p = program(control, plan.clone(), false, &options()).unwrap();
        assert!(failed(&p, &plan).is_empty(), "{:?}", failed(&p, &plan));
        let n: Vec<u32> = numbers(&p.text, "N").iter().map(|n| n.parse().unwrap()).collect();
        // The beginning, lead-in, six turns, lead-out, the retract.
        assert_eq!(n, (1..=10).collect::<Vec<_>>(), "{control:?}");
        let f = numbers(&p.text, "F");
        assert!(f.len() > 24_000 && !p.text.contains("G93"));
        for f in &f {
            assert!(f.split_once('.').is_none_or(|(_, d)| d.len() <= 3), "{f}");
        }
        // The time is the plan's, by the way of the tip alone.
        let cut: f64 = moves(&p).iter().filter_map(|m| m.seconds).sum();
        let cycle = p.cycles[0];
        // Down it takes as long as up, but for turning in.
        let fed = cycle.total_s - cycle.unwinding_s - (cycle.approach_s - cycle.retract_s);
        assert!((cut / fed - 1.0).abs() < 0.05, "{cut} {cycle:?}");
    }
}

#[test]
fn numbers_begin_again_behind_the_greatest() {
    let own = Control::Iso
        .post_file()
        .replace("at = \"turns\"", "at = \"blocks\"")
        .replace("greatest = 99999.0", "greatest = 99.0");
    let plan = sample::plan(2, 60);
    let p = written(&Dialect::from_toml(&own, "own").unwrap(), plan.clone(), false, &options()).unwrap();
    let n: Vec<u32> = numbers(&p.text, "N").iter().map(|n| n.parse().unwrap()).collect();
    assert!(n.len() > 120 && n.iter().all(|n| (1..=99).contains(n)));
    assert_eq!((n[98], n[99]), (99, 1));
    assert!(failed(&p, &plan).is_empty());
}

#[test]
fn heidenhain_feeds_have_three_digits_after_the_point() {
    let plan = sample::with_leads(sample::plan(2, 90));
    for control in [Control::Heidenhain, Control::HeidenhainVector] {
        let p = program(control, plan.clone(), false, &options()).unwrap();
        let f = numbers(&p.text, "F");
        assert!(f.len() > 180 && f.iter().all(|f| f.split_once('.').is_none_or(|(_, d)| d.len() == 3)), "{control:?}");
        assert!(failed(&p, &plan).is_empty());
    }
}

/// Under inverse time a control that reads F up to 9999.999 wants 6 ms of each line: moves are
/// joined within the chord tolerance, and refused beyond it.
#[test]
fn moves_too_short_for_inverse_time_are_joined_or_refused_never_stretched() {
    let own =
        Control::Iso.post_file().replace("greatest = 999999.999, decimals = 6", "greatest = 9999.999, decimals = 3");
    let dialect = Dialect::from_toml(&own, "own").unwrap();
    let plan = sample::with_leads(sample::plan(2, 3000));
    let p = written(&dialect, plan.clone(), false, &options()).unwrap();
    let f: Vec<f64> = numbers(&p.text, "F").iter().map(|f| f.parse().unwrap()).collect();
    let cuts: Vec<f64> = f.into_iter().filter(|f| ![5000.0, 300.0].contains(f)).collect();
    assert!(cuts.len() > 1000 && cuts.len() < 3100, "{}", cuts.len());
    assert!(cuts.iter().all(|f| *f <= 9999.999));
    assert!(failed(&p, &plan).is_empty(), "{:?}", failed(&p, &plan));
    // With the range of the built-in file nothing need be joined, and what is then over the
    // control's is named with its line.
    let mut wide = program(Control::Iso, plan.clone(), false, &options()).unwrap();
    wide.ranges = p.ranges.clone();
    wide.ranges.get_mut("F").unwrap().decimals = 6;
    let found = failed(&wide, &plan);
    assert!(found.len() == 1 && found[0].contains("program-words") && found[0].contains("line "), "{found:?}");
    assert!(found[0].contains("the control reads, 0.001 to 9999.999"), "{found:?}");
    // Corners that joined lines would cut off.
    let mut tight = plan;
    tight.toolpath.chord_mm = 1e-5;
    let e = written(&dialect, tight, false, &options()).unwrap_err();
    assert!(e.message.contains("up to F 9999.999"), "{}", e.message);
    assert!(matches!(e.infeasible.as_deref(), Some(Infeasible::MoveTooShort { chord_mm: 1e-5, .. })), "{e:?}");
}

/// Lines of the leads take 26 ms, F 2292: a control that reads F up to 2000 gets 30 ms, and the
/// path's first line that much less. The last lines of the lead-out have none behind them that
/// could be shorter: reading back finds that, so such a program is not written.
#[test]
fn polynomials_too_short_for_inverse_time_take_from_the_next_or_are_found() {
    let own = Control::SiemensPoly.post_file().replace("greatest = 999999.999", "greatest = 2000.0");
    let plan = sample::with_leads(sample::with_curve(sample::plan(12, 60), 0.05, 7.3));
    let slow = options().with(|s| s.approach_feed_mm_min = 1500.0);
    let p = written(&Dialect::from_toml(&own, "own").unwrap(), plan.clone(), false, &slow).unwrap();
    let found = failed(&p, &plan);
    assert!(found.iter().any(|f| f.starts_with("program-feed") && f.contains("lead-out")), "{found:?}");
    assert!(found.iter().all(|f| f.starts_with("program-feed") || f.starts_with("program-time")), "{found:?}");
    // Polynomials have brackets, behind which the words of other tests are comments.
    let f: Vec<f64> = p.text.split_whitespace().filter_map(|w| w.strip_prefix('F')?.parse().ok()).collect();
    assert!(f.len() > 100);
    let most = f.iter().copied().filter(|f| ![1500.0, 300.0].contains(f)).fold(0.0, f64::max);
    assert!(most > 1999.0 && most <= 2000.0, "{most}");
}

/// The words of X, Y, Z and A as a control reads them that computes in thousandths.
fn in_thousandths(text: &str) -> String {
    let thousandth =
        |n: &str| n.parse::<f64>().map_or_else(|_| n.to_owned(), |v| format!("{:.3}", (v * 1e3).round() / 1e3));
    let word = |w: &str| {
        let start = match w.as_bytes() {
            [b'X' | b'Y' | b'Z', ..] => 1,
            [b'A', b'=', ..] => w.find('(').map_or(2, |at| at + 1),
            _ => return w.to_owned(),
        };
        let end = w.find(')').unwrap_or(w.len());
        format!("{}{}{}", &w[..start], thousandth(&w[start..end]), &w[end..])
    };
    let line =
        |l: &str| if l.starts_with(';') { l.to_owned() } else { l.split(' ').map(word).collect::<Vec<_>>().join(" ") };
    text.lines().map(|l| line(l) + "\n").collect()
}

/// 47 turns on a control that computes in 0.001 mm and degrees (`INT_INCR_PER_MM`,
/// `INT_INCR_PER_DEG` = 1000): absolute words are off by one rounding at most, wherever they are;
/// steps of 0.51429 degrees would drift by 0.00029 each.
#[test]
fn siemens_words_never_add_up_to_a_drift() {
    let plan = sample::plan(47, 700);
    let worst = |p: &Program| {
        let a: Vec<f64> = moves(p).iter().filter(|m| m.seconds.is_some()).map(|m| m.to[3].to_degrees()).collect();
        // Behind approach and plunge, before the way up.
        let cuts = &a[2..a.len() - 2];
        let want = plan.motion.position.iter().skip(1).map(|q| q[3].to_degrees());
        let off = |(a, want): (&f64, f64)| ((a - want) / 360.0 - ((a - want) / 360.0).round()).abs() * 360.0;
        assert_eq!(cuts.len(), 47 * 700);
        cuts.iter().zip(want).map(off).fold(0.0, f64::max)
    };
    let rounded = |p: Program| Program { text: in_thousandths(&p.text), ..p };
    let p = rounded(program(Control::Siemens, plan.clone(), false, &options()).unwrap());
    assert!(worst(&p) <= 0.000_506, "{}", worst(&p));
    // X Y Z of the tip are rounded as well: 0.0005 mm each, and the ball centre by no more than
    // that and the axis together.
    let centre = checks(&p, &plan).into_iter().find(|c| c.id == CheckId::ProgramCentre).unwrap();
    assert!(centre.worst < 0.0005 * 3f64.sqrt() + 5.0 * 0.000_506f64.to_radians() + 1e-5, "{centre:?}");
    let steps = Control::Siemens
        .post_file()
        .replace("modulo", "incremental")
        .replace("Z{z} {a_name}={a_way}({a})", "Z{z} {a_name}=IC({da})");
    let p = rounded(written(&Dialect::from_toml(&steps, "own").unwrap(), plan.clone(), false, &options()).unwrap());
    assert!(worst(&p) > 5.0, "{}", worst(&p));
}

/// Polynomials have steps: each turn begins with its place in absolute words.
#[test]
fn siemens_polynomials_are_set_anew_where_a_turn_begins() {
    let plan = sample::with_leads(sample::with_curve(sample::plan(5, 60), 0.05, 7.3));
    let p = program(Control::SiemensPoly, plan.clone(), false, &options()).unwrap();
    assert!(failed(&p, &plan).is_empty(), "{:?}", failed(&p, &plan));
    let lines: Vec<&str> = p.text.lines().collect();
    let begins: Vec<usize> = (0..lines.len()).filter(|i| lines[*i].starts_with("; Turn ")).collect();
    assert_eq!(begins.len(), 5);
    let all = moves(&p);
    for i in begins {
        assert!(lines[i + 1].contains("G90 G94 G1 X") && lines[i + 1].contains("A=DC("), "{}", lines[i + 1]);
        // There already, as exactly as the words are.
        let m = all.iter().find(|m| m.line == i + 2).unwrap();
        assert!((0..5).all(|k| (m.to[k] - m.from[k]).abs() < 1e-9), "{m:?}");
        assert!(lines[i + 2].contains("G91 G93 POLY"));
    }
}

#[test]
fn all_dialects_begin_in_the_same_revolution() {
    let plan = sample::with_leads(sample::plan(2, 60));
    let begins = plan.axes().next().unwrap()[3].to_degrees().rem_euclid(360.0);
    for control in Control::ALL {
        let p = program(control, plan.clone(), false, &options()).unwrap();
        // Where the blade is as the tool first moves at a feed, and the first word of A.
        let first = moves(&p).iter().find(|m| m.seconds.is_some()).unwrap().from[3].to_degrees();
        assert!((first.rem_euclid(360.0) - begins).abs() < 1e-3, "{control:?} {first} {begins}");
        if control != Control::Apt {
            let words = ["A=DC(", "A+", "A"].iter().find_map(|before| {
                let word = |w: &str| w.strip_prefix(before)?.trim_end_matches(')').parse::<f64>().ok();
                p.text.lines().filter(|l| !l.starts_with([';', '('])).find_map(|l| l.split(' ').find_map(word))
            });
            // Where the table turns in, it comes from 0.
            let said = if matches!(control, Control::Fanuc | Control::FanucVector) { 0.0 } else { begins };
            assert!(words.is_some_and(|a| (a - said).abs() < 1e-3), "{control:?} {words:?} {begins}");
            assert!(said > 0.0 || (first - begins).abs() < 1e-3, "{control:?} {first} {begins}");
        }
    }
}

#[test]
fn high_speed_words_are_there_unless_the_job_does_without() {
    let plan = sample::plan(1, 60);
    let without = options().with(|s| s.look_ahead = false);
    for (control, on, off) in [
        (Control::Fanuc, "G5.1 Q1", "G5.1 Q0"),
        (Control::FanucVector, "G5.1 Q1", "G5.1 Q0"),
        (Control::Siemens, "CYCLE832(0.00", "CYCLE832(0,0,1)"),
        (Control::SiemensVector, "CYCLE832(0.00", "CYCLE832(0,0,1)"),
        (Control::SiemensPoly, "CYCLE832(0.00", "CYCLE832(0,0,1)"),
        (Control::Heidenhain, "CYCL DEF 32.1 T0.00", "CYCL DEF 32.1\n"),
        (Control::HeidenhainVector, "CYCL DEF 32.1 T0.00", "CYCL DEF 32.1\n"),
        (Control::Linuxcnc, "G64 P0.00", ""),
    ] {
        let p = program(control, plan.clone(), false, &options()).unwrap().text;
        assert!(p.contains(on) && p.contains(off), "{control:?}");
        let q = program(control, plan.clone(), false, &without).unwrap();
        assert!(!q.text.contains(on) && (off.is_empty() || !q.text.contains(off)), "{control:?}");
        assert!(failed(&q, &plan).is_empty(), "{control:?}");
        // F is that of one line: no compressor of the control may join lines.
        assert!(!matches!(control, Control::Siemens) || q.text.contains(" COMPOF"));
    }
}

/// Time of the slowest axis, under velocity and acceleration.
fn from_rest_to_rest(from: &Axes, to: &Axes, machine: &Machine) -> f64 {
    let time = |(i, axis): (usize, &Axis)| {
        let (way, v, a) = ((to[i] - from[i]).abs(), axis.limits.velocity, axis.limits.acceleration);
        if way < v * v / a { 2.0 * (way / a).sqrt() } else { way / v + v / a }
    };
    machine.axes().iter().enumerate().map(time).fold(0.0, f64::max)
}

#[test]
fn time_goes_where_the_header_and_the_figures_say() {
    let plan = sample::with_leads(sample::plan(20, 60));
    let (tool, machine) = (sample::tool(), Machine::demo().unwrap());
    for control in Control::ALL {
        let p = program(control, plan.clone(), false, &options()).unwrap();
        let c = p.cycles[0];
        let parts = [c.approach_s, c.lead_in_s, c.cutting_s, c.lead_out_s, c.retract_s, c.unwinding_s];
        assert!((parts.iter().sum::<f64>() - c.total_s).abs() < 1e-9 && parts[..5].iter().all(|s| *s > 0.0));
        assert!((c.cutting_s - plan.motion.time_s).abs() < 1e-9);
        assert!(p.text.contains(&format!("Cycle    {:.1} s: approach {:.1}", c.total_s, c.approach_s)), "{control:?}");
        // Against the text: what is moved at a feed, and the unwinding as its own last rapid.
        let all = moves(&p);
        let fed: f64 = all.iter().filter_map(|m| m.seconds).sum();
        let (down, up) =
            (all.iter().find(|m| m.seconds.is_some()).unwrap(), all.iter().rfind(|m| m.seconds.is_some()).unwrap());
        let z = machine.axes()[2].limits;
        let rapid = |at: f64| (z.travel.unwrap()[1] - at) / z.velocity + z.velocity / z.acceleration;
        let turned_in = all.iter().take_while(|m| m.seconds.is_none()).filter(|m| m.words == Programmed::Tip);
        let down_s = match control {
            // From rest to rest: to where tool-centre-point control comes on, step by step, down to
            // the safe position.
            Control::Fanuc | Control::FanucVector => {
                let mut places: Vec<Axes> = turned_in.map(|m| m.axes(1.0, &tool, &machine)).collect();
                assert!(places.len() > 10);
                places.insert(0, places[0]);
                places[0][2] = z.travel.unwrap()[1];
                places.windows(2).map(|w| from_rest_to_rest(&w[0], &w[1], &machine)).sum()
            }
            _ => rapid(down.axes(0.0, &tool, &machine)[2]),
        };
        let rapids = down_s + rapid(up.axes(1.0, &tool, &machine)[2]);
        assert!((fed + rapids - parts[..5].iter().sum::<f64>()).abs() < 0.02, "{control:?} {fed} {rapids} {c:?}");
        let last = all.iter().rfind(|m| m.seconds.is_none()).unwrap();
        let turned = (last.axes(1.0, &tool, &machine)[3] - last.from[3]).abs();
        let limits = machine.axes()[3].limits;
        let want = turned / limits.velocity + limits.velocity / limits.acceleration;
        match control {
            // All turns, at 180 degrees a second, the spindle at rest; on a control that rolls over
            // the vector's would be less.
            Control::Linuxcnc
            | Control::LinuxcncFeed
            | Control::Iso
            | Control::Fanuc
            | Control::FanucAxes
            | Control::FanucNurbs
            | Control::FanucVector
            | Control::HeidenhainSpl => {
                assert!(turned > 19.0 * std::f64::consts::TAU, "{control:?} {turned}");
                assert!((c.unwinding_s - want).abs() < 1e-3, "{control:?} {c:?} {want}");
            }
            Control::Apt => assert_eq!(c.unwinding_s, 0.0),
            _ => assert!(c.unwinding_s < 1.4 && turned <= std::f64::consts::PI, "{control:?} {c:?} {turned}"),
        }
        if control != Control::Apt {
            let at = |what: &str| p.text.find(what).unwrap_or_else(|| panic!("{control:?}: {what}"));
            let unwinds = p.text.find("Unwind of").unwrap_or_else(|| at("back to its first position"));
            assert!(at("M5\n") < unwinds && p.text.matches("M5\n").count() == 1, "{control:?}");
        }
    }
}

#[test]
fn headers_say_what_the_program_relies_on_and_how_large_it_is() {
    let plan = sample::plan(2, 60);
    for control in Control::ALL {
        let text = program(control, plan.clone(), false, &options()).unwrap().text;
        let head: String = text.lines().take(60).map(|l| format!("{l}\n")).collect();
        assert!(head.contains("LIMITS   of X Y Z A B are ASSUMED"), "{control:?}");
        let size = text.lines().find(|l| l.contains(" bytes")).unwrap();
        let told: Vec<usize> = size.split_whitespace().filter_map(|w| w.parse().ok()).collect();
        let told = &told[told.len() - 2..];
        assert_eq!(told, [text.lines().count(), text.len()], "{control:?} {size}");
        let names = match control {
            Control::Siemens | Control::SiemensVector | Control::SiemensPoly | Control::SiemensAxes => {
                "MD10210 INT_INCR_PER_DEG"
            }
            Control::Fanuc | Control::FanucVector => "19696#5 WKP=0",
            Control::Heidenhain | Control::HeidenhainSpl | Control::HeidenhainVector => {
                "CAUTION  L of tool T1 is to the ball CENTRE: 135.0000 mm"
            }
            Control::Linuxcnc | Control::LinuxcncFeed | Control::Iso | Control::FanucAxes | Control::FanucNurbs => {
                "G54 must be zero"
            }
            Control::Apt => "LOADTL",
        };
        assert!(head.contains(names), "{control:?}");
    }
    let measured = crate::machine::DEMO_TOML.replace("\"assumed\"", "\"measured\"");
    let machine = Machine::from_toml(&measured, "test").unwrap();
    let plan = Verified::for_tests(plan, sample::report(), false);
    let dialect = Dialect::built_in(Control::Linuxcnc).unwrap();
    let text = post(&dialect, &plan, &sample::blade(), &sample::tool(), &machine, &options()).unwrap().text;
    assert!(!text.contains("ASSUMED"));
}
