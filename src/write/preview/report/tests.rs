//! The page's data against the plan, and its text against odd inputs.
#![allow(clippy::unwrap_used)]

use serde_json::Value;

use super::*;
use crate::artifact::channel::{Binding, Narrowest};
use crate::artifact::program::{Asked, CutLine, Grammar, Language, Programmed, Setting};
use crate::artifact::sphere::{self, CellState, FreeSphere, SphereCell};
use crate::artifact::{Cone, Cones, Sweep, ToolPart};
use crate::error::Stage;
use crate::observe::Doubt;
use crate::sample;

fn program() -> Program {
    let language = Language {
        grammar: Grammar::Gcode,
        programmed: Programmed::Tip,
        shortest_way: false,
        feed_counts_degrees: false,
    };
    let asked = Asked { tool_number: 7, spindle_rpm: 8000.0, setting: Setting::default(), frame: None };
    Program {
        control: "any".into(),
        file_name: "program.ngc".into(),
        language,
        ranges: Default::default(),
        cycles: Vec::new(),
        text: "( <b> )\nG1 X1.5\n".into(),
        cut_lines: vec![CutLine { line: 2, until_s: 1.0 }],
        asked: vec![asked],
    }
}

/// Calls `run` with a full input.
fn with_input<T>(plan: Option<&Plan>, run: impl FnOnce(ReportInput) -> T) -> T {
    let (blade, tool, machine) = (sample::blade(), sample::tool(), Machine::demo().unwrap());
    let (sections, report) = (sample::sections(), sample::report());
    let warnings = [Warning { stage: Stage::Model, doubt: Doubt::Words("an <odd> face".into()) }];
    let provenance = [("File".to_string(), "cylinder.obj".to_string())];
    let summary = serde_json::json!({
        "turns": 3, "path_length_mm": 471.23889803846896, "machining_time_s": 50.0, "end_reason": "<here>",
        "limits_assumed": ["X", "A"],
        "programs": [{ "file": "program.ngc", "cycle": {
            "approach_s": 2.5, "lead_in_s": 0.25, "cutting_s": 50.0, "lead_out_s": 0.25, "retract_s": 3.0,
            "unwinding_s": 94.0, "total_s": 150.0,
        } }],
        "schedules": [
            { "kind": "piecewise", "machining_time_s": 50.0, "axes": [{ "velocity": 10.0 }] },
            { "kind": "fixed", "machining_time_s": 100.0, "axes": [{ "velocity": 20.0 }] },
        ],
    });
    let verify = serde_json::to_value(&report).unwrap();
    let mut other = sample::plan(3, 600);
    for (i, (row, theta)) in other.motion.velocity.iter_mut().zip(&mut other.schedule.theta).enumerate() {
        row[3] *= 2.0;
        *theta += 0.2 * (i as f64 * 0.05).sin();
    }
    let width = |b_deg: f64, w| Width {
        b_deg,
        narrowest_deg: w,
        monotone_deg: w,
        turn: 1,
        turn_s_mm: 2.0,
        binds: Narrowest::NotLookedAt,
    };
    let widths = [width(0.0, None), width(5.0, Some(33.25)), width(10.0, Some(30.0))];
    let program = program();
    let fixed = OtherSchedule { name: "fixed lead", schedule: &other.schedule, motion: Some(&other.motion) };
    run(ReportInput {
        title: "Cylinder </script><b> & co",
        blade: &blade,
        tool: &tool,
        machine: &machine,
        plan,
        baseline: plan.map(|_| fixed),
        others: &[fixed],
        summary: File { name: "summary", json: &summary },
        verify: File { name: "verify", json: &verify },
        compare: None,
        widths: &widths,
        obstacles: &[],
        free_axes: None,
        sections: &sections,
        checks: Some(&report),
        forced: false,
        program: Some(&program),
        warnings: &warnings,
        job_toml: "[tool]\nradius_mm = 5.0 # <R>\n",
        provenance: &provenance,
    })
}

/// The JSON inside a page.
fn data(page: &str) -> Value {
    let from = page.split("type=\"application/json\">").nth(1).unwrap();
    serde_json::from_str(from.split("</script>").next().unwrap()).unwrap()
}

/// The list of the page that a reference means.
fn numbers(page: &str, v: &Value) -> Vec<f64> {
    let from = page.split("id=\"numbers\" type=\"text/plain\">").nth(1).unwrap();
    let mut all = pack::unpacked(from.split("</script>").next().unwrap());
    all.swap_remove(v.as_u64().unwrap() as usize)
}

#[test]
fn stretches_show_the_tightest_walls_and_the_greatest_rates() {
    let mut plan = sample::plan(3, 600);
    // One location in the middle of a stretch that pinches the channel and jolts the table.
    plan.channel.rows[901].theta_min = plan.schedule.theta[901] - 0.01;
    plan.channel.rows[901].theta_max = plan.schedule.theta[901] + 0.01;
    plan.motion.acceleration[901][3] = -7.0;
    let page = with_input(Some(&plan), |i| html(&i)).unwrap();
    let (d, list) = (data(&page), |v: &Value| numbers(&page, v));
    let turn = &d["turns"][1];
    let (s, min, max) = (list(&turn["s"]), list(&turn["min"]), list(&turn["max"]));
    assert_eq!(s.len(), 400);
    let theta = list(&turn["theta"]);
    let gaps = |wall: &[f64]| wall.iter().zip(&theta).map(|(w, t)| (w - t).abs()).fold(f64::INFINITY, f64::min);
    assert!((gaps(&min) - 0.573).abs() < 0.006 && (gaps(&max) - 0.573).abs() < 0.006);
    // Elsewhere the walls are where they are, not pulled in by the slope of θ within a stretch.
    assert!(min.iter().zip(&theta).all(|(w, t)| t - w < (sample::WIDTH_RAD + 0.3).to_degrees() + 0.01));
    assert!(min.iter().zip(&theta).any(|(w, t)| t - w > (sample::WIDTH_RAD + 0.3).to_degrees() - 0.1));
    let acceleration = list(&d["axes"]["turns"][1]["plan"]["axes"][3][2]);
    assert!(acceleration.iter().any(|v| (v + 7f64.to_degrees()).abs() <= 7f64.to_degrees() / 8_000.0));
    assert_eq!(d["baseline"], "fixed lead");
    let of = |who: &str| list(&d["axes"]["turns"][1][who]["axes"][3][1]);
    assert!((of("baseline")[50] / of("plan")[50] - 2.0).abs() < 0.01);
    // The path of the 3-D view is that of the plan.
    let path = &d["scene"]["path"];
    let (x, row) = (list(&path["x"]), list(&path["row"]));
    assert_eq!((x.len(), row.len()), (1801, 1801));
    let furthest =
        (0..x.len()).map(|k| (x[k] - plan.toolpath.locations[row[k] as usize].centre.x).abs()).fold(0.0, f64::max);
    assert!(furthest <= 0.000_500_1, "{furthest}");
}

#[test]
fn the_page_is_whole_and_needs_no_network() {
    let plan = sample::plan(3, 600);
    let page = with_input(Some(&plan), |i| html(&i)).unwrap();
    for part in [
        "All 2 checks passed",
        "worst gouge",
        "0.0105",
        "fixed lead",
        "cylinder.obj",
        "&lt;R&gt;",
        "an &lt;odd&gt; face",
        "33.25° at B = 5°",
        "Separate channels round the path: 1",
        "limits of X, A are assumed",
        "<span data-figure=\"summary/programs/0/cycle/unwinding_s\">94</span>",
    ] {
        assert!(page.contains(part), "{part}");
    }
    // The script itself is tried in a browser; all else names nothing outside.
    let own = page.replace(VIEWER, "");
    assert!(own.len() + VIEWER.len() == page.len());
    assert!(!own.contains("http://") && !own.contains("https://") && !own.contains("src="));
    assert!(page.contains("Cylinder &lt;/script&gt;&lt;b&gt; &amp; co"));
    // The table's velocity peak of A: twice in the baseline, so half of it here.
    assert!(page.contains("−50.0 %"));
    assert_eq!(own.matches("<script").count(), 5);
    assert_eq!(page.matches("</script").count(), 5);
    assert!(!VIEWER.contains("<!--"));
    let d = data(&page);
    assert_eq!(d["turns"].as_array().unwrap().len(), 3);
    assert_eq!(numbers(&page, &d["sections"][0]["loops"][0]["y"]).len(), 90);
    assert!(page.contains("<span data-figure=\"summary/path_length_mm\">471.2</span>"));
    assert!(page.contains("<span data-figure=\"verify/checks/1/worst\">0.0101</span>"));
    assert!(page.contains("&lt;here&gt;"));
    let scene = page.split("id=\"scene-glb\" type=\"text/plain\">").nth(1).unwrap();
    assert!(pack::inflated(scene.split("</script>").next().unwrap()).starts_with(b"glTF"));
    for part in ["T7", "8000 1/min", "<td class=\"n\">unlimited</td>", "Print this sheet", "\"file\":\"program.ngc\""] {
        assert!(page.contains(part), "{part}");
    }
}

#[test]
fn failed_checks_head_the_page() {
    let plan = sample::plan(1, 12);
    let mut report = sample::report();
    report.checks[0].passed = false;
    let page = with_input(Some(&plan), |i| html(&ReportInput { checks: Some(&report), forced: true, ..i })).unwrap();
    assert!(page.contains("1 of 2 checks failed: gouge") && page.contains("Do not run them on a part"));
    let none = with_input(Some(&plan), |i| html(&ReportInput { checks: None, ..i })).unwrap();
    assert!(none.contains("Not checked"));
}

#[test]
fn empty_and_odd_data_make_a_page_without_panic() {
    let page = with_input(None, |i| {
        html(&ReportInput { sections: &[], checks: None, warnings: &[], job_toml: "", provenance: &[], ..i })
    });
    assert!(data(&page.unwrap())["turns"].is_null());
    let mut plan = sample::plan(2, 30);
    plan.motion.velocity = plan.motion.velocity.part(0..3);
    plan.channel.rows.truncate(40);
    plan.schedule.theta[5] = f64::NAN;
    plan.motion.position = crate::artifact::AxisRows::default();
    plan.toolpath.turns[1].first = usize::MAX;
    plan.channel.narrowest_row = usize::MAX;
    assert!(with_input(Some(&plan), |i| html(&i)).unwrap().contains("</html>"));
    plan.toolpath.locations.clear();
    assert!(with_input(Some(&plan), |i| html(&i)).unwrap().contains("</html>"));
}

/// A plan of which every location has a cone of its own.
fn in_five_axes(turns: usize, per_turn: usize) -> Plan {
    let mut plan = sample::plan(turns, per_turn);
    let last = plan.toolpath.locations.len() as f64 - 1.0;
    let leaning = |k: usize| Cone::about_blade(sample::B_RAD + 0.3 * k as f64 / last);
    plan.toolpath.cones = Cones::along((0..plan.toolpath.locations.len()).map(leaning).collect());
    plan.channel.sweep = Sweep::Swing;
    plan
}

#[test]
fn maps_of_free_axes_stand_where_they_were_made() {
    let plan = in_five_axes(2, 90);
    let cells = sphere::octants().map(|corners| SphereCell { corners, state: CellState::Taken(0) });
    let part = Binding::Part { tool: ToolPart::Shank, face: 0, triangle: 3 };
    let taken = FreeSphere { cells: cells.to_vec(), bindings: vec![part] };
    let nearest: Vec<usize> = (0..plan.toolpath.locations.len()).map(|k| usize::from(k > 90)).collect();
    let along = FreeAlong { maps: vec![(30, taken.clone()), (150, taken)], nearest };
    let page = with_input(Some(&plan), |i| html(&ReportInput { free_axes: Some(&along), ..i })).unwrap();
    assert!(page.contains("<section id=\"free-axes\">") && page.contains("href=\"#free-axes\""));
    let (d, list) = (data(&page), |v: &Value| numbers(&page, v));
    let maps = &d["free_axes"]["maps"];
    assert_eq!((maps[0]["turn"].as_u64(), maps[1]["turn"].as_u64()), (Some(1), Some(2)));
    assert!((maps[1]["s"].as_f64().unwrap() - plan.toolpath.locations[150].s_mm).abs() < 1e-3);
    assert_eq!(list(&maps[0]["cells"]), [3.0; 8]);
    assert_eq!(d["free_axes"]["names"], serde_json::json!([["blade", "shank against the part"]]));
    let nearest = list(&d["free_axes"]["nearest"]);
    assert!(nearest.len() == 181 && nearest[90] == 0.0 && nearest[91] == 1.0);
    // Axes of a plan that swings are shown where they are; those that go round from a turn's start.
    assert!(d["axes"]["turning"].is_null() && d["axes"]["rotary"] == serde_json::json!([3, 4]));
    let position = |page: &str, turn: usize| {
        let of = &data(page)["axes"]["turns"][turn]["plan"];
        (numbers(page, &of["axes"][3][0])[0], of["zero"].as_f64().unwrap())
    };
    let at = |row: usize| plan.motion.position[row][3].to_degrees();
    assert!((position(&page, 1).0 - at(90)).abs() < 1e-3 && position(&page, 1).1 == 0.0);
    let round = sample::plan(2, 90);
    let page = with_input(Some(&round), |i| html(&i)).unwrap();
    assert!(position(&page, 1).0 == 0.0 && (position(&page, 1).1 - at(90)).abs() < 1e-3);
    // One cone for all: the channel says all of it.
    assert!(!page.replace(VIEWER, "").contains("free-axes") && data(&page)["free_axes"].is_null());
}

#[test]
fn numbers_are_short() {
    for (v, want) in
        [(0.0, "0"), (0.0105, "0.0105"), (12.345_67, "12.35"), (1234.6, "1235"), (-0.5, "-0.5"), (f64::NAN, "–")]
    {
        assert_eq!(number(v), want);
    }
    assert_eq!(number(1e-9), "1.00e-9");
}
