//! Cuts as polynomials: that they carry the schedule's curve, in no more blocks than straight
//! moves, and that a wrong coefficient is found.

use super::*;
use crate::artifact::CheckId;
use crate::geometry::Vector;
use crate::observe::Silent;
use crate::read::program::{self, Bench, Moved, Zero};
use crate::verify::audit::{AuditOptions, audit};

fn curved(per_piece: f64) -> Plan {
    sample::with_leads(sample::with_curve(sample::plan(2, 60), 0.05, per_piece))
}

fn bench<'a>(p: &Program, tool: &'a Tool, machine: &'a Machine) -> Bench<'a> {
    Bench { language: p.language, zero: Zero::default(), tool, machine }
}

/// The moves under POLY.
fn polynomials(p: &Program, tool: &Tool, machine: &Machine) -> Vec<Moved> {
    let moves = program::follow(&program::read(&p.text, p.language).unwrap().blocks, &bench(p, tool, machine)).unwrap();
    moves.into_iter().filter(|m| m.bend.is_some()).collect()
}

#[test]
fn the_curve_is_carried_without_loss_and_in_no_more_blocks() {
    let (tool, machine) = (sample::tool(), Machine::demo().unwrap());
    // Pieces longer and shorter than the ways between locations.
    for per_piece in [7.3, 0.7] {
        let plan = curved(per_piece);
        let p = program(Control::SiemensPoly, plan.clone(), false, &options()).unwrap();
        for c in read_back(&p, &plan, &sample::blade(), &tool, &machine).unwrap() {
            assert!(c.passed, "{} is {} {} at {}", c.id, c.worst, c.unit, c.note);
        }
        let moves = polynomials(&p, &tool, &machine);
        let lines = |control: Control, word: &str| {
            let text = program(control, plan.clone(), false, &options()).unwrap().text;
            text.lines().filter(|l| l.contains(word)).count()
        };
        assert!(moves.len() == lines(Control::SiemensPoly, ") PO[Y]=("));
        assert!(moves.len() <= lines(Control::Siemens, "=DC("), "{}", moves.len());
        // The curve evaluated here, at the arc length of the place: no code of the check's.
        let pieces = &plan.schedule.pieces;
        let (mut worst, mut even) = ([0.0f64; 2], 0.0f64);
        let rows: Vec<_> = plan.toolpath.locations.windows(2).collect();
        for m in &moves {
            for f in [0.1, 0.35, 0.5, 0.8] {
                let pose = m.pose(f, &tool, &machine);
                let off = |w: &&[crate::artifact::toolpath::CutterLocation]| {
                    let f = crate::geometry::triangle::share_of_segment(&w[0].centre, &w[1].centre, &pose.centre);
                    (pose.centre - (w[0].centre + (w[1].centre - w[0].centre) * f)).norm()
                };
                let Some(w) = rows.iter().copied().min_by(|a, b| off(a).total_cmp(&off(b))) else { continue };
                if off(&w) > 1e-3 {
                    continue; // On a lead.
                }
                let share = crate::geometry::triangle::share_of_segment(&w[0].centre, &w[1].centre, &pose.centre);
                let s = w[0].s_mm + share * (w[1].s_mm - w[0].s_mm);
                let piece = pieces.iter().find(|p| p[3][0] >= s).unwrap();
                // Control points are evenly spaced in S: the curve is its own parameter.
                let (t, q) = ((s - piece[0][0]) / (piece[3][0] - piece[0][0]), piece.map(|p| p[1]));
                let [a, b, c] = [0, 1, 2].map(|k| q[k] + (q[k + 1] - q[k]) * t);
                let [a, b] = [a + (b - a) * t, b + (c - b) * t];
                let axis = plan.toolpath.cone(0).tool_axis(a + (b - a) * t);
                worst[0] = worst[0].max(off(&w));
                worst[1] = worst[1].max(pose.axis.cross(&axis).norm().to_degrees());
                let straight = Moved { bend: None, ..*m }.pose(f, &tool, &machine);
                even = even.max(straight.axis.cross(&axis).norm().to_degrees());
            }
        }
        assert!(worst[0] < 3e-4 && worst[1] < 3e-4, "{per_piece}: {worst:?}");
        // Else there would be nothing to carry.
        assert!(even > 0.003, "{even}");
    }
}

/// A cutting line with the coefficient `k` of the polynomial of a word made greater.
fn planted(text: &str, line: usize, word: &str, k: usize, by: f64) -> String {
    let change = |l: &str| {
        let start = l.find(&format!("PO[{word}]=(")).unwrap() + word.len() + 6;
        let end = start + l[start..].find(')').unwrap();
        let mut list: Vec<f64> = l[start..end].split(',').map(|v| v.parse().unwrap()).collect();
        list.resize(list.len().max(k + 1), 0.0);
        list[k] += by;
        let list: Vec<String> = list.iter().map(|v| format!("{v:.8}")).collect();
        format!("{}{}{}", &l[..start], list.join(","), &l[end..])
    };
    let out = text.lines().enumerate().map(|(i, l)| if i + 1 == line { change(l) } else { l.to_owned() });
    out.map(|l| l + "\n").collect()
}

#[test]
fn a_wrong_coefficient_is_found_and_placed() {
    let plan = curved(7.3);
    let (blade, tool, machine) = (sample::blade(), sample::tool(), Machine::demo().unwrap());
    let good = program(Control::SiemensPoly, plan.clone(), false, &options()).unwrap();
    let line = polynomials(&good, &tool, &machine)[70].line;
    for (word, k, by, name) in [
        ("A", 1, 0.008, "program-curve"),
        ("A", 2, -0.008, "program-curve"),
        ("X", 1, 0.006, "program-centre"),
        ("X", 3, 0.004, "program-centre"),
    ] {
        let bad = Program { text: planted(&good.text, line, word, k, by), ..good.clone() };
        let checks = read_back(&bad, &plan, &blade, &tool, &machine).unwrap();
        let found = checks.iter().find(|c| !c.passed && c.id == name.parse().unwrap());
        assert!(found.is_some_and(|c| c.note.contains(&format!("line {line}"))), "{word} {k}: {checks:#?}");
    }
    // A curve that is left out altogether.
    let straight = straightened(&good.text);
    let checks = read_back(&Program { text: straight, ..good.clone() }, &plan, &blade, &tool, &machine).unwrap();
    assert!(checks.iter().any(|c| !c.passed && c.id == CheckId::ProgramCurve));
    // Without a plan: a coefficient that takes the ball 5 µm into the part, halfway, with both ends
    // where they belong.
    let m = polynomials(&good, &tool, &machine)[70];
    let inward = -m.pose(0.5, &tool, &machine).centre.coords;
    let inward = Vector::new(0.0, inward.y, inward.z).normalize() * 0.006 / -0.25;
    let text = planted(&planted(&good.text, line, "Y", 1, inward.y), line, "Z", 1, inward.z);
    let options = AuditOptions::default().with(|s| (s.surface_samples, s.gouge_mm) = (500, 0.004));
    let look = |text: &str| audit(text, &blade, &bench(&good, &tool, &machine), &options, &Silent).unwrap();
    let gouge = |text: &str| look(text).checks.into_iter().find(|c| c.check.id == CheckId::Gouge).unwrap();
    let (before, after) = (gouge(&good.text), gouge(&text));
    assert!(after.line == Some(line) && after.check.worst > before.check.worst + 0.004, "{before:?} {after:?}");
}

/// Every polynomial with its end alone.
fn straightened(text: &str) -> String {
    let bare = |w: &str| match (w.starts_with("PO["), w.find(',')) {
        (true, Some(at)) => format!("{})", &w[..at]),
        _ => w.to_owned(),
    };
    text.lines().map(|l| l.split(' ').map(bare).collect::<Vec<_>>().join(" ") + "\n").collect()
}

#[test]
fn polynomials_are_positions_where_the_axis_counts_on() {
    let own = Control::SiemensPoly.post_file().replace("\"incremental\"", "\"accumulate\"").replace("G91 G93", "G93");
    let own = own.replace("{a_way}({a})", "{a}");
    let dialect = Dialect::from_toml(&own.replace("poly_degree = 5", "poly_degree = 3"), "own").unwrap();
    let plan = curved(7.3);
    let verified = Verified::for_tests(plan.clone(), sample::report(), false);
    let (blade, tool, machine) = (sample::blade(), sample::tool(), Machine::demo().unwrap());
    let p = post(&dialect, &verified, &blade, &tool, &machine, &options()).unwrap();
    assert!(!p.text.lines().any(|l| l.starts_with('N') && l.contains("G91")));
    for c in read_back(&p, &plan, &blade, &tool, &machine).unwrap() {
        assert!(c.passed, "{} is {} {} at {}", c.id, c.worst, c.unit, c.note);
    }
    // At most two coefficients and the end.
    let most = p
        .text
        .lines()
        .filter(|l| l.starts_with('N'))
        .flat_map(|l| l.split("PO[").skip(1))
        .map(|w| w.matches(',').count())
        .max();
    assert_eq!(most, Some(2));
}

#[test]
fn post_files_that_mix_up_polynomials_are_refused() {
    let polynomials = [
        ("poly_degree = 5", "poly_degree = 6", "poly_degree is 6"),
        ("poly_degree = 5", "", "need poly_degree"),
        ("PO[X]=({px})", "X={x}", "must have {px}"),
        ("G91 G93 POLY", "G93 POLY", "must say G91"),
        ("rotary = \"incremental\"", "rotary = \"modulo\"", "poly_degree needs rotary"),
    ];
    let curves = [
        ("curve_knot = [\"K{knot}\"]", "", "text.curve_knot must be one line"),
        ("curve_knot = [\"K{knot}\"]", "curve_knot = [\"K\"]", "text.curve_knot must have {knot}"),
        ("K{knot} X{x} Y{y} Z{z} {a_name}{a} {b_name}{b_moving}\"]", "K{knot} X{x} Y{y} Z{z}\"]", "must have {a}"),
        (" F{f}\"]\ncurve_point", "\"]\ncurve_point", "curve_begin must have {f}"),
        ("feed = \"per-minute-of-all\"", "feed = \"inverse-time\"", "curves need"),
        ("rotary = \"accumulate\"", "rotary = \"modulo\"", "curves need"),
        ("longest_line = 120", "longest_line = 120\nmodal = [\"x\"]", "curves need"),
    ];
    let all = [(Control::SiemensPoly, &polynomials[..]), (Control::FanucNurbs, &curves)];
    for (control, (from, to, says)) in all.iter().flat_map(|(control, cases)| cases.iter().map(move |c| (control, c))) {
        let good = control.post_file();
        let text = good.replacen(from, to, 1);
        assert_ne!(text, good, "{from}");
        let e = Dialect::from_toml(&text, "p.toml").unwrap_err();
        assert!(e.kind == ErrorKind::Usage && e.message.contains(says), "{from}: {}", e.message);
    }
}

/// A plan on a programmed curve goes as one spline: fewer blocks than ways between locations, ball
/// and tool axis on the curve, and derivatives that meet at the joints.
#[test]
fn a_programmed_curve_is_carried_piece_by_piece() {
    let (blade, tool, machine) = (sample::blade(), sample::tool(), Machine::demo().unwrap());
    let plan = sample::with_leads(sample::on_curve(sample::plan(2, 180), 0.05, 23.0, 3));
    let good = program(Control::SiemensPoly, plan.clone(), false, &options()).unwrap();
    let checks = read_back(&good, &plan, &blade, &tool, &machine).unwrap();
    for c in &checks {
        assert!(c.passed, "{} is {} {} at {}", c.id, c.worst, c.unit, c.note);
    }
    assert!(checks.iter().any(|c| c.id == CheckId::ProgramJoints && c.note.contains("joints")));
    let moves = polynomials(&good, &tool, &machine);
    let leads: usize = plan.leads.iter().map(|l| l.centres.len()).sum();
    assert!(moves.len() < 360 / 2 + leads, "{} {leads}", moves.len());
    // A fifth coefficient moves the ball by less than any other check sees, and breaks the joint.
    let line = moves[leads / 2 + 40].line;
    let bad = Program { text: planted(&good.text, line, "Y", 4, 2e-5), ..good.clone() };
    let checks = read_back(&bad, &plan, &blade, &tool, &machine).unwrap();
    let failed: Vec<_> = checks.iter().filter(|c| !c.passed).map(|c| c.id.clone()).collect();
    assert_eq!(failed, [CheckId::ProgramJoints]);
    // From a turn on, and in lesser degrees, too.
    let from = PostOptions { from_turn: Some(2), ..options() };
    let half = program(Control::SiemensPoly, plan.clone(), false, &from).unwrap();
    let rest = planned(&plan, &from).unwrap().into_owned();
    assert!(polynomials(&half, &tool, &machine).len() < moves.len());
    for c in read_back(&half, &rest, &blade, &tool, &machine).unwrap() {
        assert!(c.passed, "{} is {} {} at {}", c.id, c.worst, c.unit, c.note);
    }
    let cubic = Control::SiemensPoly.post_file().replace("poly_degree = 5", "poly_degree = 3");
    let cubic = written(&Dialect::from_toml(&cubic, "own").unwrap(), plan.clone(), false, &options()).unwrap();
    for c in read_back(&cubic, &plan, &blade, &tool, &machine).unwrap() {
        assert!(c.passed || c.id == CheckId::ProgramJoints, "{} is {} {} at {}", c.id, c.worst, c.unit, c.note);
    }
}

/// The same as spline lines of degree 3: places, slopes and curvatures meet, and a factor that is
/// off is found at a joint or refused.
#[test]
fn spline_lines_carry_the_curve_and_two_derivatives() {
    let (blade, tool, machine) = (sample::blade(), sample::tool(), Machine::demo().unwrap());
    let plan = sample::with_leads(sample::on_curve(sample::plan(2, 180), 0.05, 23.0, 3));
    let good = program(Control::HeidenhainSpl, plan.clone(), false, &options()).unwrap();
    let read = |p: &Program| read_back(p, &plan, &blade, &tool, &machine);
    for c in read(&good).unwrap() {
        assert!(c.passed, "{} is {} {} at {}", c.id, c.worst, c.unit, c.note);
        if c.id == CheckId::ProgramJoints {
            assert!(c.worst < 0.5 && c.note.contains("joints"), "{} {}", c.worst, c.note);
        }
    }
    let moves = polynomials(&good, &tool, &machine);
    // A word is within a tenth of a micrometre, so lines begin as near to where others end.
    let apart = |w: &[Moved]| machine.linear().map(|k| (w[1].from[k] - w[0].to[k]).abs());
    assert!(moves.windows(2).flat_map(apart).all(|d| d <= 1.01e-4));
    let line = moves[moves.len() / 2].line;
    let with = |word: &str, by: f64| {
        let changed = |(i, l): (usize, &str)| {
            let one = |w: &str| match w.strip_prefix(word).filter(|_| i + 1 == line) {
                Some(v) => format!("{word}{:+.8E}", v.parse::<f64>().unwrap() + by),
                None => w.to_owned(),
            };
            l.split(' ').map(one).collect::<Vec<_>>().join(" ")
        };
        let text = good.text.lines().enumerate().map(changed).collect::<Vec<_>>().join("\n");
        assert_ne!(text, good.text.trim_end(), "{word}");
        Program { text, ..good.clone() }
    };
    let failed: Vec<_> = read(&with("K2Y", 4e-4)).unwrap().into_iter().filter(|c| !c.passed).map(|c| c.id).collect();
    assert_eq!(failed, [CheckId::ProgramJoints]);
    let refused = read(&with("K1Z", 2e-3)).unwrap_err();
    assert!(refused.message.contains("spline begins 0.00"), "{}", refused.message);
    let unfinished = Program { text: good.text.replacen(" K1X", " Q1X", 1), ..good.clone() };
    assert!(read(&unfinished).is_err());
}

/// The same as curves of control points and knots: all pieces of a curve are one B-spline, and a
/// control point, a knot or a feed that is off is found or refused.
#[test]
fn curves_of_control_points_carry_the_curve_and_two_derivatives() {
    let (blade, tool, machine) = (sample::blade(), sample::tool(), Machine::demo().unwrap());
    let plan = sample::with_leads(sample::on_curve(sample::plan(2, 180), 0.05, 23.0, 3));
    let good = program(Control::FanucNurbs, plan.clone(), false, &options()).unwrap();
    let read = |p: &Program| read_back(p, &plan, &blade, &tool, &machine);
    for c in read(&good).unwrap() {
        assert!(c.passed, "{} is {} {} at {}", c.id, c.worst, c.unit, c.note);
        if c.id == CheckId::ProgramJoints {
            assert!(c.worst < 0.5 && c.note.contains("joints"), "{} {}", c.worst, c.note);
        }
    }
    let begins: Vec<usize> =
        (1..).zip(good.text.lines()).filter(|(_, l)| l.contains("G06.2 P4 K")).map(|(i, _)| i).collect();
    let points = good.text.lines().filter(|l| l.contains('K') && l.contains(" Z")).count();
    let moves = polynomials(&good, &tool, &machine);
    assert_eq!(moves.len(), points - 3 * begins.len());
    assert!(begins.len() >= 2 && moves.len() > 3 * begins.len(), "{} {}", begins.len(), moves.len());
    // Every piece has its line and its time, in order.
    let lines: Vec<usize> = good.cut_lines.iter().map(|c| c.line).collect();
    assert!(moves.iter().all(|m| lines.contains(&m.line)));
    assert!(good.cut_lines.windows(2).all(|w| w[0].line < w[1].line && w[0].until_s <= w[1].until_s));
    // Within a curve two derivatives by its parameter meet to what floating-point numbers hold. A
    // piece goes from the knot of its line to that of the next.
    let [_, y, _] = machine.linear();
    let knot = |line: usize| -> f64 {
        let text = good.text.lines().nth(line - 1).unwrap();
        text.split(' ').find_map(|w| w.strip_prefix('K')).unwrap().parse().unwrap()
    };
    let at = |m: &Moved, p: f64| {
        let ([a2, a3, ..], h) = (m.bend.unwrap()[y], knot(m.line + 1) - knot(m.line));
        let even = m.to[y] - m.from[y] - a2 - a3;
        [(even + 2.0 * a2 * p + 3.0 * a3 * p * p) / h, (2.0 * a2 + 6.0 * a3 * p) / (h * h)]
    };
    let within: Vec<&[Moved]> = moves.windows(2).filter(|w| w[1].line == w[0].line + 1).collect();
    assert!(within.len() > 10);
    for w in within {
        let ([slope, bend], [slope_after, bend_after]) = (at(&w[0], 1.0), at(&w[1], 0.0));
        assert!((slope - slope_after).abs() < 1e-10 && (bend - bend_after).abs() < 1e-12, "line {}", w[1].line);
    }
    // The longest curve.
    let first = begins.windows(2).max_by_key(|w| w[1] - w[0]).unwrap()[0];
    let with = |line: usize, word: &str, to: &dyn Fn(f64) -> f64| {
        let changed = |(i, l): (usize, &str)| {
            let one = |w: &str| match w.strip_prefix(word).filter(|_| i + 1 == line) {
                Some(v) => format!("{word}{:.4}", to(v.parse::<f64>().unwrap())),
                None => w.to_owned(),
            };
            l.split(' ').map(one).collect::<Vec<_>>().join(" ")
        };
        let text = good.text.lines().enumerate().map(changed).collect::<Vec<_>>().join("\n");
        assert_ne!(text, good.text.trim_end(), "{word}");
        Program { text, ..good.clone() }
    };
    let failed =
        |p: &Program| -> Vec<CheckId> { read(p).unwrap().into_iter().filter(|c| !c.passed).map(|c| c.id).collect() };
    // A control point within the curve moves it; one beside its end turns it there.
    assert!(failed(&with(first + 4, "Y", &|y| y + 0.02)).contains(&CheckId::ProgramCentre));
    assert!(failed(&with(first + 1, "Y", &|y| y + 0.02)).contains(&CheckId::ProgramJoints));
    assert!(failed(&with(first, "F", &|f| 0.5 * f)).contains(&CheckId::ProgramTime));
    for (planted, says) in [
        (with(first, "Y", &|y| y + 0.004), "begins 0.004"),
        (with(first + 3, "K", &|_| 0.5), "equal knots"),
        (with(first + 5, "K", &|_| 0.0), "smaller"),
        (with(first, "P", &|_| 7.0), "rank P7"),
        (Program { text: good.text.replacen("\nK0.0000 ", "\nK0.0000 R2.0 ", 1), ..good.clone() }, "weights"),
        (Program { text: good.text.replacen("\nK0.0000 ", "\n", 1), ..good.clone() }, "without its knot"),
    ] {
        let refused = read(&planted).unwrap_err();
        assert!(refused.message.contains(says), "{says}: {}", refused.message);
    }
}

/// The curve on a path with a stretch of it left straight: splines begin and end where the lines
/// beside them do.
#[test]
fn curves_begin_and_end_at_straight_stretches() {
    use crate::artifact::programmed::Way;
    let (blade, tool, machine) = (sample::blade(), sample::tool(), Machine::demo().unwrap());
    // Short ways; and long pieces, which a spline of as few as do leaves by some hundredths of a
    // micrometre.
    for (rows, per_piece, swing) in [(3000, 3, 0.01), (180, 12, 0.2)] {
        let mut plan = sample::on_curve(sample::plan(1, rows), swing, 3.0, per_piece);
        let curve = plan.curve.as_mut().unwrap();
        for k in [rows / 2, rows / 2 + 1] {
            curve.rows[k].way = Way::Straight;
        }
        curve.rows[rows / 2 + 2].way = Way::Piece;
        let plan = sample::with_leads(plan);
        for control in [Control::SiemensPoly, Control::HeidenhainSpl, Control::FanucNurbs] {
            let p = program(control, plan.clone(), false, &options()).unwrap();
            for c in read_back(&p, &plan, &blade, &tool, &machine).unwrap() {
                assert!(c.passed, "{control}, {rows}: {} is {} {} at {}", c.id, c.worst, c.unit, c.note);
                // A spline that begins beside its line bends that line by 0.16 of what is allowed.
                assert!(c.id != CheckId::ProgramJoints || c.worst < 0.1, "{control}, {rows}: {}", c.worst);
            }
        }
    }
}
