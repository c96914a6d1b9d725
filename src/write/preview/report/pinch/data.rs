//! What the page's script draws of rows for two tools. Angles in degrees, but in the 3-D view in
//! rad; lengths in mm, times in s.

use std::ops::Range;

use serde_json::{Value, json};

use super::{PinchReport, PinchStretch};
use crate::artifact::paired::{PairPlace, StretchMotion};
use crate::error::Result;
use crate::write::draw::colour;
use crate::write::preview::report::data::{axes_with, motion_of, rounded, stretches};
use crate::write::preview::report::pack::{self, DIGITS, Pack, TIME};
use crate::write::preview::report::payload::Payload;
use crate::write::preview::report::scene::{self, LIMITS, RADIANS};
use crate::write::preview::values::{self, Values};
use crate::write::preview::{PinchKey, gltf};

/// Points of all curves along the rows together, about.
const CURVE_POINTS: usize = 24_000;
/// Points of all curves of an axis together, about: there are twice as many axes as elsewhere.
const AXIS_POINTS: usize = 8_000;

/// The payload of the page.
pub(super) fn payload(input: &PinchReport) -> Result<Payload> {
    let mut pack = Pack::default();
    let places = Places::of(input);
    let data = json!({
        "word": input.words()[0],
        "turns": turns(input, &places, &mut pack),
        "limits": { "angle_deg": input.max_angle_deg, "apart_mm": input.line_distance_mm },
        "axes": axes(input, &places, &mut pack),
        "scene": whole_scene(input, &places, &mut pack),
        "colours": colour::STOPS.map(colour::hex),
        "no_colour": colour::hex(colour::NONE),
        "left_out": values::LEFT_OUT,
    });
    let parts = gltf::pinch_parts(input.blade, input.tools, &scene::options());
    Payload::made(&data, &pack, parts.and_then(|bytes| pack::deflated(&bytes)))
}

/// Where keys and stretches are on the way through all of it, which the page's cursor goes along.
struct Places {
    /// Way from the first place of the rows to each, of the tool that goes farther, mm: what counts
    /// are differences within a stretch.
    along_mm: Vec<f64>,
    /// The way of each key, mm: it rises.
    keys_mm: Vec<f64>,
    /// The way at which each stretch begins, mm.
    from_mm: Vec<f64>,
}

impl Places {
    fn of(input: &PinchReport) -> Self {
        let step = |w: &[PairPlace]| {
            let way = |j: usize| (w[1].contacts[j].centre - w[0].contacts[j].centre).norm();
            way(0).max(way(1))
        };
        let mut along_mm = vec![0.0];
        for w in input.rows.places.windows(2) {
            along_mm.push(along_mm[along_mm.len() - 1] + step(w));
        }
        let mut from_mm = vec![0.0; input.stretches.len()];
        let (mut keys_mm, mut at, mut before) = (Vec::with_capacity(input.keys.len()), 0.0, None::<&PinchKey>);
        for key in input.keys {
            at += before.map_or(0.0, |b| between_keys(b, key, &along_mm));
            let is_first = |s: &PinchStretch| key.place == Some(s.places.start);
            if input.stretches.get(key.stretch).is_some_and(is_first) {
                from_mm[key.stretch] = at;
            }
            keys_mm.push(at);
            before = Some(key);
        }
        Places { along_mm, keys_mm, from_mm }
    }

    /// Way from the beginning of a stretch to a place of it, mm.
    fn within_mm(&self, stretch: &PinchStretch, place: usize) -> f64 {
        let of = |k: usize| self.along_mm.get(k).copied().unwrap_or(f64::NAN);
        of(place) - of(stretch.places.start)
    }

    /// Length of a stretch, mm.
    fn length_mm(&self, stretch: &PinchStretch) -> f64 {
        self.within_mm(stretch, stretch.places.end.saturating_sub(1))
    }
}

/// The way from a key to the next: along the row, else straight; of the tool that goes farther, mm.
fn between_keys(a: &PinchKey, b: &PinchKey, along_mm: &[f64]) -> f64 {
    let on_row = a.place.zip(b.place).filter(|_| a.stretch == b.stretch);
    let way = on_row.and_then(|(j, k)| Some(along_mm.get(k)? - along_mm.get(j)?));
    let straight = |j: usize| (b.stands[j].centre - a.stands[j].centre).norm();
    way.unwrap_or_else(|| straight(0).max(straight(1)))
}

/// What is drawn along each stretch.
fn turns(input: &PinchReport, places: &Places, pack: &mut Pack) -> Value {
    let most = (CURVE_POINTS / input.stretches.len().max(1)).clamp(72, 400);
    let mut at_mm = 0.0;
    let mut out = Vec::with_capacity(input.stretches.len());
    for (stretch, from_mm) in input.stretches.iter().zip(&places.from_mm) {
        let mut turn = turn(input, places, stretch, &stretches(&stretch.places, most), pack);
        turn["from"] = rounded(*from_mm, 3);
        turn["at"] = rounded(at_mm, 3);
        at_mm += places.length_mm(stretch);
        out.push(turn);
    }
    Value::Array(out)
}

fn turn(
    input: &PinchReport,
    places: &Places,
    stretch: &PinchStretch,
    pieces: &[Range<usize>],
    pack: &mut Pack,
) -> Value {
    let first = stretch.places.start;
    // The tightest wall of a piece.
    let mut walls = |free: &[[f64; 2]]| {
        let wall = |p: &Range<usize>, end: usize, tighter: fn(f64, f64) -> f64| {
            let of = p.clone().filter_map(|k| free.get(k - first)).map(|w| w[end]);
            of.fold(f64::NAN, tighter).to_degrees()
        };
        json!([
            pack.list(DIGITS, pieces.iter().map(|p| wall(p, 0, f64::max))),
            pack.list(DIGITS, pieces.iter().map(|p| wall(p, 1, f64::min))),
        ])
    };
    let [one, two, both] = [0, 1, 2].map(|k| walls(&stretch.free_rad[k]));
    // Nothing is held round the edges.
    let held = input.rows.places_held();
    let greatest = |p: &Range<usize>, of: fn(&PairPlace) -> f64| {
        let own = p.clone().filter(|k| *k < held).filter_map(|k| input.rows.places.get(k));
        own.map(of).fold(f64::NAN, f64::max)
    };
    json!({
        "row": stretch.row + 1,
        "length": rounded(places.length_mm(stretch), 3),
        "held": table(stretch, pieces, pack),
        "s": pack.list(DIGITS, pieces.iter().map(|p| places.within_mm(stretch, p.start))),
        "free": [one, two, both],
        "angle": pack.list(DIGITS, pieces.iter().map(|p| greatest(p, |place| place.angle_rad.to_degrees()))),
        "apart": pack.scaled(pieces.iter().map(|p| greatest(p, |place| place.apart_mm))),
    })
}

/// The angle at which the table stands, degrees: a number, or where it turns one for each piece.
fn table(stretch: &PinchStretch, pieces: &[Range<usize>], pack: &mut Pack) -> Value {
    let theta = &stretch.theta_rad;
    let at = |k: usize| theta.get(k - stretch.places.start).map_or(f64::NAN, |theta| theta.to_degrees());
    match theta.windows(2).all(|w| w[0] == w[1]) {
        true => rounded(at(stretch.places.start), 3),
        false => pack.list(DIGITS, pieces.iter().map(|p| at(p.start))),
    }
}

/// All axes over the time that both tools cut; nothing without motion.
fn axes(input: &PinchReport, places: &Places, pack: &mut Pack) -> Value {
    let Some(motion) = input.motion else { return Value::Null };
    let most = (AXIS_POINTS / motion.stretches.len().max(1)).clamp(40, 400);
    let (mut turns, mut from_s) = (Vec::new(), 0.0);
    for own in &motion.stretches {
        let pieces = stretches(&(0..own.motion.t_s.len()), most);
        let Some(stretch) = input.stretches.get(own.stretch) else { continue };
        let from_mm = places.from_mm.get(own.stretch).copied().unwrap_or(0.0);
        let s = pack.list(DIGITS, pieces.iter().map(|p| from_mm + way_of_row(own, stretch, places, p.start)));
        let mut plan = motion_of(&own.motion, input.machine, None, &pieces, pack);
        plan["from"] = rounded(from_s, 4);
        from_s += own.motion.time_s;
        turns.push(json!({ "s": s, "plan": plan, "baseline": null }));
    }
    axes_with(input.machine, None, turns)
}

/// The way within its stretch of a row of its motion, mm. A stretch of two places moves by three
/// rows.
fn way_of_row(own: &StretchMotion, stretch: &PinchStretch, places: &Places, row: usize) -> f64 {
    let rows = own.motion.t_s.len();
    if rows == stretch.places.len() {
        return places.within_mm(stretch, stretch.places.start + row);
    }
    places.length_mm(stretch) * row as f64 / rows.saturating_sub(1).max(1) as f64
}

/// The 3-D view's data: the way of both tools, with how the first stands on the machine.
fn whole_scene(input: &PinchReport, places: &Places, pack: &mut Pack) -> Value {
    let path = path(input, places, pack);
    let mut scene = scene::around(input.blade, input.tools[0], input.machine, path);
    let second = input.tools[1];
    scene["second"] = json!({ "radius": second.radius_mm, "length": second.length_mm() });
    scene
}

/// The place of each key; where both tools are lifted, the first one of the stretch or the last
/// one, over which they are.
fn stands_over(input: &PinchReport) -> Vec<usize> {
    let mut before: Option<&PinchKey> = None;
    let place = |key| {
        let last = before.replace(key).filter(|b| b.stretch == key.stretch).and_then(|b| b.place);
        let first = || input.stretches.get(key.stretch).map(|s| s.places.start);
        key.place.or(last).or_else(first).unwrap_or_default()
    };
    input.keys.iter().map(place).collect()
}

fn path(input: &PinchReport, places: &Places, pack: &mut Pack) -> Value {
    let (keys, stands_over) = (input.keys, stands_over(input));
    let quantities: Vec<Value> =
        quantities(input, &stands_over).iter().map(|v| scene::quantity(v, v.of.iter().copied(), pack)).collect();
    let mut centre =
        |tool: usize| [0, 1, 2].map(|c| pack.list(DIGITS, keys.iter().map(|key| key.stands[tool].centre[c])));
    let [[x, y, z], [x_2, y_2, z_2]] = [centre(0), centre(1)];
    let stretch = |key: &PinchKey| input.stretches.get(key.stretch);
    let wall = |n: usize, end: usize| {
        let own = stretch(&keys[n])?;
        Some(own.free_rad[2].get(stands_over[n].checked_sub(own.places.start)?)?[end])
    };
    let mut of = |digits: i32, f: &dyn Fn(usize) -> f64| pack.list(digits, (0..keys.len()).map(f));
    let cuts = |n: usize| {
        let next = keys.get(n + 1).filter(|next| next.stretch == keys[n].stretch);
        f64::from(u8::from(keys[n].place.is_some() && next.is_some_and(|next| next.place.is_some())))
    };
    let within = |n: usize| stretch(&keys[n]).map_or(f64::NAN, |s| places.within_mm(s, stands_over[n]));
    json!({
        "x": x, "y": y, "z": z,
        "t": of(TIME, &|n| keys[n].t_s),
        "theta": of(RADIANS, &|n| keys[n].stands[0].theta),
        "s": of(DIGITS, &|n| places.keys_mm[n]),
        "turn_s": of(DIGITS, &within),
        "min": of(LIMITS, &|n| wall(n, 0).unwrap_or(f64::NAN)),
        "max": of(LIMITS, &|n| wall(n, 1).unwrap_or(f64::NAN)),
        "row": of(0, &|n| stands_over[n] as f64),
        "cuts": of(0, &cuts),
        "of": keys.len(), "b": input.leans_rad[0], "turns": input.stretches.len(),
        "second": { "x": x_2, "y": y_2, "z": z_2, "b": input.leans_rad[1], "over": input.between_rad },
        "quantities": quantities,
    })
}

/// What the rows can be coloured by: a value for each key, by the place that it stands over.
fn quantities(input: &PinchReport, stands_over: &[usize]) -> Vec<Values> {
    let at = |f: &dyn Fn(&PinchKey, usize) -> Option<f64>| -> Vec<f64> {
        input.keys.iter().zip(stands_over).map(|(key, k)| f(key, *k).unwrap_or(f64::NAN)).collect()
    };
    let held = input.rows.places_held();
    let place = |k: usize| input.rows.places.get(k).filter(|_| k < held);
    let width = |key: &PinchKey, k: usize| {
        let own = input.stretches.get(key.stretch)?;
        let [from, to] = own.free_rad[2].get(k.checked_sub(own.places.start)?)?;
        Some((to - from).to_degrees())
    };
    let [word, ..] = input.words();
    let number = input.keys.iter().map(|key| key.stretch as f64 + 1.0).collect();
    let mut out = vec![
        Values::new("turn", word, "", number),
        Values::new("angle", "angle β of the normals", "°", at(&|_, k| Some(place(k)?.angle_rad.to_degrees()))),
        Values::new(
            "thickness",
            "thickness between the contacts",
            "mm",
            at(&|_, k| Some(2.0 * place(k)?.held_radius_mm)),
        ),
        Values::new("width", "table's turn that is free for both", "°", at(&width)),
    ];
    if let Some(motion) = input.motion {
        let feed = |key: &PinchKey, k: usize| {
            let own = motion.stretches.get(key.stretch)?;
            let rows = own.motion.feed.len();
            // A stretch of two places moves by three rows.
            let row = if rows == own.places.len() { k.checked_sub(own.places.start)? } else { rows / 2 };
            Some(60.0 * own.motion.feed.get(row)?)
        };
        out.push(Values::new("feed", "feed of the tool that goes farther", "mm/min", at(&feed)));
    }
    out
}
