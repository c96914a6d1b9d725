//! The page's data and figures against rows made by hand.
#![allow(clippy::unwrap_used)]

use serde_json::{Value, json};

use super::*;
use crate::artifact::paired::{BallContact, PairPlace, StretchMotion};
use crate::artifact::{Axes, AxisMotion, AxisRows, Cone, Stand};
use crate::geometry::{Point, Vector};
use crate::sample;
use crate::write::preview::report::pack;

/// Places of a row.
const PLACES: usize = 5;
/// The second head over the first.
const BETWEEN_RAD: f64 = std::f64::consts::PI;

/// Two rows down the blade, 2 mm a step: tool 1 at +y, tool 2 at -y, which goes half as far.
fn rows() -> PairedRows {
    let place = |k: usize| {
        let (row, n) = ((k / PLACES) as f64, (k % PLACES) as f64);
        let contact = |side: f64, step: f64| BallContact {
            centre: Point::new(20.0 - step * n, 8.0 * side, row),
            contact: Point::new(20.0 - step * n, 5.0 * side, row),
            normal: Vector::y() * side,
            face: 0,
        };
        PairPlace {
            contacts: [contact(1.0, 2.0), contact(-1.0, 1.0)],
            held_centre: Point::new(20.0, 0.0, row),
            held_radius_mm: 5.0,
            angle_rad: 0.01 * k as f64,
            apart_mm: 1e-4 * k as f64,
        }
    };
    PairedRows {
        edge_rows: 0,
        turns: None,
        edge_heights_mm: None,
        radius_mm: [3.0, 3.0],
        stock_mm: 0.0,
        scallop_mm: 0.01,
        chord_mm: 0.001,
        heights_mm: [12.0, 20.0],
        planned_scallop_mm: [0.01, 0.01],
        rows: vec![0..PLACES, PLACES..2 * PLACES],
        places: (0..2 * PLACES).map(place).collect(),
        ends: Vec::new(),
    }
}

fn stretches() -> Vec<PinchStretch> {
    let one = |row: usize| {
        let held_rad = 0.1 * row as f64;
        let walls = |width: f64| vec![[held_rad - width, held_rad + width]; PLACES];
        let mut free_rad = [walls(1.0), walls(0.75), walls(0.75)];
        // One place is narrow.
        free_rad[2][3] = [held_rad - 0.25, held_rad + 0.5];
        PinchStretch { row, places: row * PLACES..(row + 1) * PLACES, theta_rad: vec![held_rad; PLACES], free_rad }
    };
    vec![one(0), one(1)]
}

/// All places of both stretches and both tools over their ends, 10 mm up, a second a step.
fn keys(rows: &PairedRows, stretches: &[PinchStretch]) -> Vec<PinchKey> {
    let mut keys = Vec::new();
    let mut key = |stretch: usize, k: usize, lift_mm: f64| {
        let stand = |j: usize| {
            let theta = stretches[stretch].theta_rad[0] + BETWEEN_RAD * j as f64;
            let centre = rows.places[k].contacts[j].centre;
            Stand { centre, cone: Cone::about_blade(0.1), theta }.lifted(lift_mm)
        };
        let place = (lift_mm == 0.0).then_some(k);
        let t_s = keys.len() as f64;
        keys.push(PinchKey { t_s, stretch, place, stands: [stand(0), stand(1)] });
    };
    for (n, s) in stretches.iter().enumerate() {
        key(n, s.places.start, 10.0);
        s.places.clone().for_each(|k| key(n, k, 0.0));
        key(n, s.places.end - 1, 10.0);
    }
    keys
}

/// Nine axes that all go from 0 to 4 in 4 s, each by its number faster.
fn motion() -> PinchMotion {
    let one = |stretch: usize| {
        let table = |of: &dyn Fn(usize, usize) -> f64| {
            let mut rows = AxisRows::with_capacity(9, PLACES);
            (0..PLACES).for_each(|k| rows.push(&Axes::from_fn(9, |c| of(k, c))));
            rows
        };
        let position = table(&|k, c| (k * (c + 1)) as f64);
        let rate = table(&|_, c| (c + 1) as f64);
        let motion = AxisMotion {
            t_s: (0..PLACES).map(|k| k as f64).collect(),
            position,
            velocity: rate.clone(),
            acceleration: rate.clone(),
            jerk: rate,
            feed: vec![2.0; PLACES],
            time_s: 4.0,
        };
        let over = [Axes::from_fn(9, |_| 0.0), Axes::from_fn(9, |_| 0.0)];
        let places = stretch * PLACES..(stretch + 1) * PLACES;
        StretchMotion {
            stretch,
            row: stretch,
            places,
            motion,
            over,
            near: over[0],
            lifts_mm: [[10.0; 2]; 2],
            near_mm: [5.0; 2],
        }
    };
    PinchMotion { stretches: vec![one(0), one(1)], cutting_s: 8.0, ways_s: 3.0, alone_s: [8.0, 4.0], turning_mm: 10.0 }
}

fn figures() -> Value {
    let check = |passed: bool| {
        json!({ "name": "gouge", "quantity": "tool 1: <depth>", "worst": 0.00125, "limit": 0.003, "unit": "mm",
                "passed": passed, "row": 7, "turn": 1, "point_mm": null, "note": "" })
    };
    json!({
        "rows": 2, "still_rows": 2, "stretches": 2, "places": 10, "cut_off": 3, "heights_mm": [12.0, 20.0],
        "length_mm": [16.0, 8.0], "covered": [0.5, 0.25], "ends": "<edge>", "narrowest_deg": 42.97,
        "narrowest_place": 3, "narrowest_own_deg": [114.6, 85.94], "turned_deg": 5.73,
        "measured": { "ridges_mm": [[0.001, 0.002, 0.003, 0.004, 0.005], [0.006, 0.007, 0.008, 0.009, 0.011]],
            "binding_ridges_mm": [0.006, 0.007, 0.008, 0.009, 0.011],
            "line_distance_mm": [0.0001, 0.0002, 0.0009], "angle_deg": [2.5, 5.0, 5.157], "tools_apart_mm": 3.25 },
        "checks": [check(true), check(true)],
        "program": { "cutting_s": 8.0, "alone_s": [8.0, 4.0], "one_after_the_other_s": 12.0,
            "share_of_one_after_the_other": 0.6667, "full_feed_s": 7.5, "checks": [check(true)],
            "programs": [{ "control": "any", "files": ["a.mpf", "b.mpf"], "lines": 321, "checks": [check(false)] }] },
    })
}

/// Calls `run` with a full input; `has_two` heads has motion.
fn with_input<T>(has_two: bool, figures: &Value, run: impl FnOnce(PinchReport) -> T) -> T {
    let text = include_str!("../../../../../models/machines/pinch_9x.toml");
    let (blade, tool, machine) = (sample::blade(), sample::tool(), Machine::from_toml(text, "two heads").unwrap());
    let (rows, stretches, motion) = (rows(), stretches(), motion());
    run(PinchReport {
        title: "Two </script> tools",
        blade: &blade,
        tools: [&tool, &tool],
        leans_rad: [0.1, 0.2],
        between_rad: BETWEEN_RAD,
        spindle_rpm: [8000.0, 9000.0],
        machine: &machine,
        obstacles: &[],
        rows: &rows,
        stretches: &stretches,
        motion: has_two.then_some(&motion),
        keys: &keys(&rows, &stretches),
        max_angle_deg: 40.0,
        line_distance_mm: 0.2,
        figures: File { name: "pinch", json: figures },
        warnings: &[],
        job_toml: "[pinch]\n",
        provenance: &[("Model".to_owned(), "cylinder.obj".to_owned())],
    })
}

/// The text of an element of the page.
fn element<'a>(page: &'a str, start: &str) -> &'a str {
    page.split(start).nth(1).unwrap().split("</script>").next().unwrap()
}

fn data(page: &str) -> (Value, Vec<Vec<f64>>) {
    let json = serde_json::from_str(element(page, "id=\"data\" type=\"application/json\">")).unwrap();
    (json, pack::unpacked(element(page, "id=\"numbers\" type=\"text/plain\">")))
}

#[test]
fn the_plots_show_the_rows_the_walls_and_the_axes() {
    let page = with_input(true, &figures(), |i| html(&i)).unwrap();
    let (d, lists) = data(&page);
    let list = |v: &Value| lists[v.as_u64().unwrap() as usize].clone();
    let turns = d["turns"].as_array().unwrap();
    assert_eq!((d["word"].as_str(), turns.len()), (Some("row"), 2));
    // The tool that goes farther counts; what lies between the rows does so in the path only.
    let second = &turns[1];
    assert_eq!(list(&second["s"]), [0.0, 2.0, 4.0, 6.0, 8.0]);
    assert_eq!((second["length"].as_f64(), second["at"].as_f64()), (Some(8.0), Some(8.0)));
    let degrees = |v: f64| (v.to_degrees() * 1e3).round() / 1e3;
    assert_eq!(second["held"].as_f64(), Some(degrees(0.1)));
    let wall = |k: usize, end: usize| list(&second["free"][k][end]);
    assert_eq!((wall(0, 0)[0], wall(1, 1)[2]), (degrees(-0.9), degrees(0.85)));
    assert_eq!((wall(2, 0)[3], wall(2, 1)[3]), (degrees(-0.15), degrees(0.6)));
    assert_eq!(list(&second["angle"])[4], degrees(0.09));
    assert!((list(&second["apart"])[4] - 9e-4).abs() < 1e-6);
    // All nine axes, the time of the second stretch after that of the first.
    let axes = &d["axes"];
    assert_eq!(axes["names"].as_array().unwrap().len(), 9);
    assert_eq!(axes["turns"][1]["plan"]["from"].as_f64(), Some(4.0));
    assert_eq!(list(&axes["turns"][1]["plan"]["axes"][1][0]), [0.0, 2.0, 4.0, 6.0, 8.0]);
    // Both tools in motion: lifted, five places, lifted, twice.
    let path = &d["scene"]["path"];
    assert_eq!(list(&path["row"]), [0.0, 0.0, 1.0, 2.0, 3.0, 4.0, 4.0, 5.0, 5.0, 6.0, 7.0, 8.0, 9.0, 9.0]);
    assert_eq!(list(&path["cuts"]), [0.0, 1.0, 1.0, 1.0, 1.0, 0.0, 0.0, 0.0, 1.0, 1.0, 1.0, 1.0, 0.0, 0.0]);
    let s = list(&path["s"]);
    assert!(s.windows(2).all(|w| w[1] > w[0]) && (s[1], s[5]) == (10.0, 18.0), "{s:?}");
    assert_eq!(second["from"].as_f64(), Some(s[8]));
    assert_eq!((list(&path["x"])[3], list(&path["second"]["x"])[3]), (16.0, 18.0));
    assert_eq!(list(&axes["turns"][1]["s"])[2], s[10]);
    let glb = element(&page, "id=\"scene-glb\" type=\"text/plain\">");
    let glb = pack::inflated(glb);
    let has = |name: &str| String::from_utf8_lossy(&glb).contains(name);
    assert!(glb.starts_with(b"glTF") && has("\"tool 1\"") && has("\"tool 2\"") && has("\"holder 1\""));
}

/// Every figure that a cell names is shown as the file has it.
#[test]
fn the_tables_show_the_figures_of_the_file() {
    let figures = figures();
    let page = with_input(true, &figures, |i| html(&i)).unwrap();
    let cells: Vec<(&str, &str)> = page
        .split("data-figure=\"pinch")
        .skip(1)
        .filter_map(|rest| rest.split_once("</span>")?.0.split_once("\">"))
        .collect();
    assert!(cells.len() > 45, "{}", cells.len());
    for (pointer, shown) in &cells {
        let value = figures.pointer(pointer).and_then(Value::as_f64).unwrap();
        assert!((shown.parse::<f64>().unwrap() - value).abs() <= 5e-4 * value.abs(), "{pointer}: {shown} for {value}");
    }
    for part in [
        "1 of 4 checks failed: gouge",
        "Two &lt;/script&gt; tools",
        "tool 1: &lt;depth&gt;",
        "a.mpf, b.mpf",
        "✗ not written",
        "data-row=\"7\">place 7<",
        "row 2; ",
        "8000 1/min",
        "9000 1/min",
        "tool 2 leans 11.46°",
        "stands 180° on",
        "66.67",
    ] {
        assert!(page.contains(part), "{part}");
    }
    assert_eq!(page.matches("</script").count(), 5);
    assert!(!page.contains("{turn"));
}

#[test]
fn without_two_heads_and_without_rows_there_is_a_page() {
    let mut figures = figures();
    figures.as_object_mut().unwrap().remove("program");
    let page = with_input(false, &figures, |i| html(&i)).unwrap();
    assert!(page.contains("All 2 checks passed") && !page.contains("id=\"axes\"") && !page.contains("#programs"));
    assert!(data(&page).0["axes"].is_null());
    let none = PairedRows { rows: Vec::new(), places: Vec::new(), ..rows() };
    let odd = [PinchStretch { row: 3, places: 5..9, theta_rad: vec![f64::NAN; 4], free_rad: Default::default() }];
    let page = with_input(true, &Value::Null, |i| {
        let bare = PinchReport { rows: &none, stretches: &[], keys: &[], motion: None, ..i };
        assert!(html(&bare).unwrap().contains("Not checked"));
        html(&PinchReport { stretches: &odd, ..i })
    });
    assert!(page.unwrap().contains("</html>"));
}
