//! Faults of known size planted one by one into programs of all dialects; `verify`'s audit, which
//! knows no plan, must find, name and place each, and find nothing in the programs as they are.

use std::f64::consts::{PI, TAU};

use super::*;
use crate::artifact::CheckId;
use crate::artifact::program::Grammar;
use crate::geometry::mesh::Mesh;
use crate::geometry::part::Part;
use crate::observe::Silent;
use crate::read::program::{self, Bench, Moved, Zero};
use crate::verify::audit::{Audit, AuditOptions, LineCheck, audit};

/// Steps of a turn, and turns, of the program that faults are planted in.
const PER_TURN: usize = 360;
const TURNS: usize = 5;
/// The scallop of the sample's pitch of 0.5 mm under its ball of 5 mm is 0.00626 mm.
const SCALLOP_MM: f64 = 0.0064;

/// The sample's cylinder in fine facets, on a platform whose top is x = 0; no triangle is long.
fn part() -> Mesh {
    let n = 720u32;
    let length = sample::PART_LENGTH;
    let mut profile = vec![(-10.0, 120.0)];
    profile.extend([120.0, 95.0, 72.0, 52.0, 34.0].map(|r| (0.0, r)));
    profile.extend((0..=10).map(|k| (length * f64::from(k) / 10.0, sample::PART_RADIUS)));
    let rings = profile.len() as u32;
    let mut mesh = Mesh::default();
    for (x, r) in profile {
        mesh.points.extend((0..n).map(|i| {
            let (s, c) = (f64::from(i) * TAU / f64::from(n)).sin_cos();
            Point::new(x, r * c, r * s)
        }));
    }
    mesh.points.extend([Point::new(-10.0, 0.0, 0.0), Point::new(length, 0.0, 0.0)]);
    for k in 0..n {
        let l = (k + 1) % n;
        for at in (0..rings - 1).map(|ring| ring * n) {
            mesh.triangles.extend([[at + k, at + l, at + n + l], [at + k, at + n + l, at + n + k]]);
        }
        let last = (rings - 1) * n;
        mesh.triangles.extend([[rings * n, l, k], [rings * n + 1, last + k, last + l]]);
    }
    mesh
}

fn blade() -> Blade {
    Blade { part: Part::from_mesh(part()), ..sample::blade() }
}

/// A program of a dialect and what is needed to look at it.
pub(super) struct Shop {
    pub(super) control: Control,
    pub(super) machine: Machine,
    pub(super) tool: Tool,
    pub(super) blade: Blade,
    pub(super) program: Program,
}

impl Shop {
    pub(super) fn new(control: Control, blade: &Blade, plan: &Plan) -> Self {
        let (tool, machine) = (sample::tool(), Machine::demo().unwrap());
        let plan = Verified::for_tests(plan.clone(), sample::report(), false);
        let program = post(&Dialect::built_in(control).unwrap(), &plan, blade, &tool, &machine, &options()).unwrap();
        Shop { control, machine, tool, blade: blade.clone(), program }
    }

    pub(super) fn bench(&self) -> Bench<'_> {
        let language = self.program.language;
        Bench { language, zero: Zero::default(), tool: &self.tool, machine: &self.machine }
    }

    pub(super) fn moves(&self, text: &str) -> Vec<Moved> {
        program::follow(&program::read(text, self.program.language).unwrap().blocks, &self.bench()).unwrap()
    }

    /// The move that ends at a turn and a share of it, counted from the first location.
    fn cut(&self, turns: f64) -> Moved {
        let moves = self.moves(&self.program.text);
        let feeds: Vec<&Moved> = moves.iter().filter(|m| m.seconds.is_some()).collect();
        // Approach and plunge before, two moves away behind; a location may take several lines.
        let cuts = &feeds[2..feeds.len() - 2];
        *cuts[(cuts.len() as f64 * turns / TURNS as f64) as usize]
    }

    fn audit(&self, text: &str) -> Audit {
        let options = AuditOptions { scallop_mm: Some(SCALLOP_MM), ..AuditOptions::default() }
            .with(|s| (s.surface_samples, s.gouge_mm) = (8000, 0.004));
        audit(text, &self.blade, &self.bench(), &options, &Silent).unwrap()
    }

    /// What fails in a text.
    fn failing(&self, text: &str) -> Vec<LineCheck> {
        self.audit(text).checks.into_iter().filter(|c| !c.check.passed).collect()
    }

    /// The text with the lines of a statement that ends in `line` (from 1) changed; blocks are
    /// numbered anew where that matters.
    fn changed(&self, line: usize, change: impl FnOnce(&str) -> Vec<String>) -> String {
        let mut lines: Vec<String> = self.program.text.lines().map(String::from).collect();
        let mut first = line - 1;
        while self.program.language.grammar == Grammar::Apt && !lines[first].starts_with("GOTO") {
            first -= 1;
        }
        let statement = lines[first..line].iter().map(|l| l.trim_end_matches('$')).collect::<String>();
        lines.splice(first..line, change(&statement));
        self.numbered(lines)
    }

    pub(super) fn numbered(&self, lines: Vec<String>) -> String {
        let number = |(i, l): (usize, String)| match (self.program.language.grammar, l.split_once(' ')) {
            (Grammar::Heidenhain, Some((_, rest))) => format!("{i} {rest}\n"),
            (Grammar::Apt, _) if l.starts_with("GOTO") && l.len() > 72 => folded(&l),
            _ => format!("{l}\n"),
        };
        lines.into_iter().enumerate().map(number).collect()
    }

    fn find<'a>(&self, found: &'a [LineCheck], name: &str) -> &'a LineCheck {
        let names: Vec<String> = found.iter().map(|c| c.check.id.to_string()).collect();
        found
            .iter()
            .find(|c| c.check.id == name.parse().unwrap())
            .unwrap_or_else(|| panic!("{:?}: {name} not in {names:?}", self.control))
    }

    fn only(&self, found: &[LineCheck], names: &[&str]) {
        let got: Vec<String> = found.iter().map(|c| c.check.id.to_string()).collect();
        assert!(got.iter().all(|n| names.contains(&n.as_str())), "{:?}: {got:?}", self.control);
    }
}

/// An APT statement in lines of 72 columns.
fn folded(statement: &str) -> String {
    let mut out = String::new();
    let mut line = String::new();
    for piece in statement.split_inclusive(',') {
        if line.len() + piece.len() > 70 {
            out += &format!("{line}$\n");
            line.clear();
        }
        line += piece;
    }
    out + &line + "\n"
}

/// A block with the words of X, Y, Z taken through `change`.
fn with_point(block: &str, change: &dyn Fn(usize, f64) -> f64) -> String {
    if let Some(numbers) = block.strip_prefix("GOTO/") {
        let value = |(i, n): (usize, &str)| match i {
            0..3 => format!("{:.6}", change(i, n.trim().parse().unwrap())),
            _ => n.to_owned(),
        };
        return format!("GOTO/{}", numbers.split(',').enumerate().map(value).collect::<Vec<_>>().join(","));
    }
    let word = |w: &str| match "XYZ".find(&w[..1]) {
        Some(i) if w.len() > 1 => format!("{}{:+.5}", &w[..1], change(i, w[1..].parse().unwrap())),
        _ => w.to_owned(),
    };
    block.split(' ').map(word).collect::<Vec<_>>().join(" ")
}

fn sample_plan(per_turn: usize) -> Plan {
    sample::plan(TURNS, per_turn)
}

/// A dialect of each grammar and each kind of coordinates with the sample's program.
fn shops(blade: &Blade, plan: &Plan) -> Vec<Shop> {
    use Control::*;
    [Siemens, HeidenhainVector, Fanuc, Linuxcnc, Apt].map(|c| Shop::new(c, blade, plan)).into()
}

#[test]
fn clean_programs_of_all_dialects_have_no_finding() {
    let (blade, plan) = (blade(), sample::with_leads(sample_plan(PER_TURN)));
    for s in &Control::ALL.map(|c| Shop::new(c, &blade, &plan)) {
        let found = s.audit(&s.program.text);
        let bad: Vec<_> = found.checks.iter().filter(|c| !c.check.passed).collect();
        assert!(bad.is_empty(), "{:?}: {bad:#?}", s.control);
        assert!(found.turns >= TURNS as u32 && found.scallop_samples > 300, "{:?}: {found:?}", s.control);
        // Chords of path and facets sag by up to a micrometre.
        let closed = 5.0 - (25.0 - 0.25f64 * 0.25).sqrt();
        let p99 = found.scallop_p99_mm;
        assert!((0.8..1.1).contains(&(p99 / closed)), "{:?}: {p99} {closed}", s.control);
        let (guess, language) = (program::guess(&s.program.text).unwrap().language, s.program.language);
        assert_eq!((guess.grammar, guess.programmed), (language.grammar, language.programmed), "{:?}", s.control);
    }
}

#[test]
fn a_gouge_of_five_micrometres_is_found() {
    for s in shops(&blade(), &sample_plan(PER_TURN)) {
        let cut = s.cut(2.4);
        let pose = cut.pose(1.0, &s.tool, &s.machine);
        let out = Vector::new(0.0, pose.centre.y, pose.centre.z).normalize();
        let machine = s.program.language.programmed == crate::artifact::program::Programmed::Machine;
        let inward = out * -0.005;
        let d = if machine {
            s.machine.shown_part(s.machine.theta_and_lean(&cut.to, 0.0)[0]).rotation * inward
        } else {
            inward
        };
        let text = s.changed(cut.line, |b| vec![with_point(b, &|i, v| v + d[i])]);
        let found = s.failing(&text);
        s.only(&found, &["gouge"]);
        let g = s.find(&found, "gouge");
        assert!((g.check.worst - 0.005).abs() < 0.0008, "{:?}: {g:?}", s.control);
        assert!(
            g.line.unwrap().abs_diff(cut.line) <= 3 && g.check.turn == Some(2),
            "{:?}: {g:?} {}",
            s.control,
            cut.line
        );
        assert!(g.block.as_ref().is_some_and(|b| !b.is_empty()) && g.span_count == 1, "{:?}: {g:?}", s.control);
        let at = sample::blade().model_from_blade.inverse() * Point::from(g.check.point_mm.unwrap());
        assert!((at - (pose.centre + out * -5.0)).norm() < 0.3, "{:?}: {at}", s.control);
    }
}

#[test]
fn a_holder_touch_of_twenty_micrometres_between_two_locations_is_found() {
    // Long steps, so that the holder is clear at their ends.
    let plan = sample_plan(180);
    for mut s in shops(&blade(), &plan) {
        // In the last turn: later ones would come nearer.
        let cut = s.cut(4.4);
        let pose = cut.pose(0.5, &s.tool, &s.machine);
        let out = (Vector::x() - pose.axis * pose.axis.x).normalize();
        let across = pose.axis.cross(&out);
        let tip = pose.centre + pose.axis * 130.0 + out * (30.0 - 0.02);
        let mut mesh = part();
        let n = mesh.points.len() as u32;
        mesh.points.extend([tip, tip + out * 5.0 + across * 0.1, tip + out * 5.0 - across * 0.1]);
        mesh.triangles.push([n, n + 1, n + 2]);
        s.blade.part = Part::from_mesh(mesh);
        let found = s.failing(&s.program.text);
        s.only(&found, &["holder-clearance"]);
        let h = s.find(&found, "holder-clearance");
        assert!((h.check.worst + 0.0225).abs() < 0.004, "{:?}: {h:?}", s.control);
        assert!(h.line.unwrap().abs_diff(cut.line) <= 2 && h.check.note.contains("holder 2"), "{:?}: {h:?}", s.control);
        let at = sample::blade().model_from_blade.inverse() * Point::from(h.check.point_mm.unwrap());
        assert!((at - tip).norm() < 0.01);
        if s.program.language.programmed == crate::artifact::program::Programmed::Centre {
            // At both ends of the move the holder is clear: looking at ends alone would miss it.
            for f in [0.0, 1.0] {
                let p = cut.pose(f, &s.tool, &s.machine);
                let v = tip - p.centre;
                assert!((v - p.axis * v.dot(&p.axis)).norm() > 30.01);
            }
        }
    }
}

#[test]
fn a_swapped_sign_of_b_is_found_and_named() {
    for s in shops(&blade(), &sample_plan(PER_TURN)) {
        let text = s.program.text.clone();
        let swapped = match s.control {
            Control::Apt => {
                let all = text.replace("$\n", "");
                let flip = |l: &str| match l.strip_prefix("GOTO/") {
                    Some(n) => {
                        let mut v: Vec<String> = n.split(',').map(String::from).collect();
                        v[3] = format!("-{}", v[3]);
                        folded(&format!("GOTO/{}", v.join(",")))
                    }
                    None => format!("{l}\n"),
                };
                all.lines().map(flip).collect()
            }
            _ => [
                (" B5.", " B-5."),
                ("B=5.", "B=-5."),
                (" B+5.", " B-5."),
                ("A3=0", "A3=-0"),
                ("TX+0", "TX-0"),
                (" I0", " I-0"),
            ]
            .iter()
            .fold(text, |t, (from, to)| t.replace(from, to)),
        };
        let found = s.failing(&swapped);
        let b = s.find(&found, "b-sign");
        assert!(b.line.is_some(), "{b:?}");
        assert!(
            found
                .iter()
                .any(|c| ["contact", "gouge", "clearance", "holder-clearance"]
                    .contains(&c.check.id.to_string().as_str()))
        );
        assert!(!found.iter().any(|c| c.check.id == CheckId::ASense), "{:?}", s.control);
    }
}

#[test]
fn a_missing_turn_is_found_and_named() {
    for s in shops(&blade(), &sample_plan(PER_TURN)) {
        let (from, to) = (s.cut(2.0), s.cut(3.0));
        let lines: Vec<String> = s.program.text.lines().map(String::from).collect();
        // Statements of APT end in these lines. Where A counts on, one line would make the whole
        // missing turn: the lines behind it are a turn back.
        let counts_on = s.program.language.programmed == crate::artifact::program::Programmed::Machine;
        let back = |i: usize, l: &String| -> String {
            let word = |w: &str| match w.strip_prefix('A').and_then(|v| v.parse::<f64>().ok()) {
                Some(v) if counts_on && i >= to.line => format!("A{:.5}", v - 360.0),
                _ => w.to_owned(),
            };
            l.split(' ').map(word).collect::<Vec<_>>().join(" ")
        };
        let lines: Vec<String> = lines.iter().enumerate().map(|(i, l)| back(i, l)).collect();
        let kept = lines.iter().enumerate().filter(|(i, _)| !(from.line..to.line).contains(i));
        let text = if s.program.language.grammar == Grammar::Apt {
            kept.map(|(_, l)| format!("{l}\n")).collect()
        } else {
            s.numbered(kept.map(|(_, l)| l.clone()).collect())
        };
        let found = s.failing(&text);
        let turn = s.find(&found, "scallop-turn");
        assert!(turn.check.note.contains("a turn or a pass is missing"), "{:?}: {turn:?}", s.control);
        assert!((1..=2).contains(&turn.check.turn.unwrap()), "{:?}: {turn:?}", s.control);
        assert!(turn.check.worst > 2.5 * SCALLOP_MM, "{:?}: {turn:?}", s.control);
    }
}

#[test]
fn a_scallop_twice_too_high_is_found() {
    let mut plan = sample_plan(PER_TURN);
    // One turn wider by sqrt(2).
    for (i, l) in plan.toolpath.locations.iter_mut().enumerate() {
        let over = (i as f64 / PER_TURN as f64 - 2.0).clamp(0.0, 1.0) * 0.5 * (2f64.sqrt() - 1.0);
        l.centre.x += over;
        l.contact.x += over;
    }
    for s in shops(&blade(), &plan) {
        let found = s.failing(&s.program.text);
        s.only(&found, &["scallop", "scallop-turn"]);
        let turn = s.find(&found, "scallop-turn");
        assert!((1.3..2.1).contains(&(turn.check.worst / 0.00626)), "{:?}: {turn:?}", s.control);
        assert!((2..=3).contains(&turn.check.turn.unwrap()), "{:?}: {turn:?}", s.control);
        assert!(!turn.check.note.contains("missing"), "{:?}: {turn:?}", s.control);
    }
}

#[test]
fn a_travel_limit_exceeded_by_a_hundredth_is_found() {
    for mut s in shops(&blade(), &sample_plan(PER_TURN)) {
        let moves = s.moves(&s.program.text);
        let (tool, machine) = (s.tool.clone(), s.machine.clone());
        // Where a table turns in, Y goes to and fro within steps, farther than at their ends.
        let (axis, check) = if s.control == Control::Fanuc { (0, "x-travel") } else { (1, "y-travel") };
        let reached = |m: &Moved| m.axes(1.0, &tool, &machine)[axis];
        let cuts: Vec<&Moved> = moves.iter().filter(|m| m.seconds.is_some()).collect();
        let top = cuts.iter().max_by(|a, b| reached(a).total_cmp(&reached(b))).unwrap();
        let most = moves.iter().map(reached).filter(|v| v.is_finite()).fold(f64::MIN, f64::max);
        let limits = machine.axes()[axis].limits;
        let [least, limit] = limits.travel.unwrap();
        assert!(most < limit);
        let line = top.line;
        s.machine = machine.clone().with_limits(axis, AxisLimits { travel: Some([least, most - 0.01]), ..limits });
        let found = s.failing(&s.program.text);
        s.only(&found, &[check]);
        let travel = s.find(&found, check);
        assert!((travel.check.worst - 0.01).abs() < 0.0005, "{:?}: {travel:?}", s.control);
        let worst = travel.line.unwrap();
        assert!(
            reached(moves.iter().find(|m| m.line == worst).unwrap()) > most - 0.001,
            "{:?}: {worst} {line}",
            s.control
        );
    }
}

#[test]
fn a_rapid_through_the_part_is_found() {
    for s in shops(&blade(), &sample_plan(PER_TURN)) {
        let cut = s.cut(2.4);
        let axes = s.program.language.programmed == crate::artifact::program::Programmed::Machine;
        // To the other side and back, or down into the part and back.
        let there = |i: usize, v: f64| {
            if axes {
                if i == 2 { v - 25.0 } else { v }
            } else if i > 0 {
                -v
            } else {
                v
            }
        };
        let text = s.changed(cut.line, |block| {
            let rapid = |b: &str| -> Vec<String> {
                match s.program.language.grammar {
                    Grammar::Apt => vec!["RAPID".into(), b.into()],
                    Grammar::Heidenhain => {
                        let words = b.split(' ').filter(|w| "LXYZ".contains(&w[..1])).map(|w| w.replace("LN", "L"));
                        vec![format!("0 {} FMAX", words.collect::<Vec<_>>().join(" "))]
                    }
                    Grammar::Gcode => {
                        let words = b.split(' ').filter(|w| "XYZ".contains(&w[..1]));
                        vec![format!("G0 {}", words.collect::<Vec<_>>().join(" "))]
                    }
                }
            };
            [vec![block.to_owned()], rapid(&with_point(block, &there)), rapid(block)].concat()
        });
        let found = s.failing(&text);
        let r = s.find(&found, "rapid");
        assert!(r.check.worst < -4.0, "{:?}: {r:?}", s.control);
        // APT's statements go over several lines.
        assert!((1..=6).contains(&(r.line.unwrap() - cut.line)), "{:?}: {r:?} {}", s.control, cut.line);
        s.only(&found, &["rapid"]);
    }
}

#[test]
fn what_is_planted_is_what_a_clean_part_has_not() {
    // The part is closed and its volume that of its cylinders: else nothing above would mean
    // anything.
    let volume = part().volume_mm3();
    let expected = PI * (120.0 * 120.0 * 10.0 + 20.0 * 20.0 * 60.0);
    assert!((volume / expected - 1.0).abs() < 2e-4, "{volume} {expected}");
}
