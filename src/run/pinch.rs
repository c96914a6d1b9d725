//! Files of rows for two tools: tables, figures, a plot, a 3-D scene, the report.

use std::fmt::Write;
use std::ops::Range;

use super::{Loaded, look};
use crate::artifact::paired::{Held, PairPlace, PinchMotion};
use crate::artifact::region::Area;
use crate::artifact::report::Check;
use crate::artifact::{PairedRows, Stand};
use crate::error::Result;
use crate::geometry::Point;
use crate::observe::Warning;
use crate::plan::Setup;
use crate::plan::pinch::{Pinch, PinchPosted, PinchProgrammed, PublishedFigures};
use crate::verify::PinchFigures;
use crate::write::draw::{HeldAngles, held_svg};
use crate::write::preview::report::pinch::{PinchReport, PinchStretch};
use crate::write::preview::report::{self, File};
use crate::write::preview::{self, PinchKey, PinchScene};

/// Keys of the animation, about.
const MOST_KEYS: usize = 6000;
/// Keys of the report's 3-D view, about.
const REPORT_KEYS: usize = 20_000;
/// Points of a row in the plot along which the table turns, about.
const TURNING_POINTS: usize = 20;
/// A way down, up or across takes so long in the animation, s.
const LINK_S: f64 = 1.0;

/// Rows for two tools in figures: `pinch.json`. Lengths in mm, angles in degrees.
#[derive(Clone, Debug, PartialEq, serde::Serialize)]
pub struct PinchSummary {
    /// Name of the blade.
    pub name: String,
    /// Ball radii of both tools.
    pub radius_mm: [f64; 2],
    /// Rows.
    pub rows: usize,
    /// So many of them, the last, go round the edges.
    pub edge_rows: usize,
    /// Of a double helix, which is one row: turns of the thread of each tool.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub thread_turns: Option<[u32; 2]>,
    /// Heights of the ball centres between which those run, the lower first; left out: there are
    /// none.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub edge_heights_mm: Option<[f64; 2]>,
    /// Share of the airfoil's area between those heights: both tools together machine all of it.
    pub closed: f64,
    /// Those along which the table does not turn.
    pub still_rows: usize,
    /// Stretches that are cut in one motion each.
    pub stretches: usize,
    /// Places of both tools.
    pub places: usize,
    /// Places cut off the ends of rows, since no angle of the table is free for both tools there.
    pub cut_off: usize,
    /// Heights of the first tool's ball centre between which rows run.
    pub heights_mm: [f64; 2],
    /// Length of all rows of each tool.
    pub length_mm: [f64; 2],
    /// Share of the airfoil's area that lies between the rows of opposite places of each tool.
    pub covered: [f64; 2],
    /// Why rows end, in words.
    pub ends: String,
    /// Least width of what is free for both tools.
    pub narrowest_deg: f64,
    /// Where.
    pub narrowest_place: usize,
    /// Least width of what is free for each tool by itself.
    pub narrowest_own_deg: [f64; 2],
    /// What the table turns from stretch to stretch, in all.
    pub turned_deg: f64,
    /// What it turns while both tools cut, to and fro, in all.
    pub turned_cutting_deg: f64,
    /// Where it turns along rows, no angles let both tools' axes turn by less per mm of their
    /// contacts' way at the steepest place, rad/mm: `measured.turning_rad_mm` says what they do.
    pub least_turning_rad_mm: f64,
    /// What the published smoothing of the tool axes comes to, where it was asked for.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub published: Option<PublishedFigures>,
    /// What the checks measured.
    pub measured: PinchFigures,
    /// The checks.
    pub checks: Vec<Check>,
    /// What the program does, where the machine has two heads.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub program: Option<ProgramSummary>,
}

/// The programs of two tools in figures.
#[derive(Clone, Debug, PartialEq, serde::Serialize)]
pub struct ProgramSummary {
    /// Time that both tools cut, s.
    pub cutting_s: f64,
    /// Time of the ways down, up and from row to row, about, s.
    pub ways_s: f64,
    /// Time that each tool would take for its side alone, s.
    pub alone_s: [f64; 2],
    /// Both of these, one after the other, s.
    pub one_after_the_other_s: f64,
    /// What both tools take of that.
    pub share_of_one_after_the_other: f64,
    /// Time at full feed all along the longer rows, s; of a double helix all along the longer way
    /// of both tools.
    pub full_feed_s: f64,
    /// The checks of the motion.
    pub checks: Vec<Check>,
    /// The programs.
    pub programs: Vec<PostedSummary>,
}

/// The program for a control in figures.
#[derive(Clone, Debug, PartialEq, serde::Serialize)]
pub struct PostedSummary {
    /// The control, or the post file.
    pub control: String,
    /// Its files: two for two channels.
    pub files: Vec<String>,
    /// Lines of all files.
    pub lines: usize,
    /// What reading them back found.
    pub checks: Vec<Check>,
}

/// The figures.
pub fn figures(setup: &Setup, pinch: &Pinch, programmed: Option<&PinchProgrammed>) -> PinchSummary {
    let (narrowest, narrowest_place) = pinch.narrowest().unwrap_or_default();
    let own = |k: usize| pinch.own[k].iter().map(|f| f.widest()).fold(f64::INFINITY, f64::min);
    let turned = 0.0 + pinch.held.windows(2).map(|w| (w[1].ends_rad()[0] - w[0].ends_rad()[1]).abs()).sum::<f64>();
    let area = airfoil_mm2(setup, [f64::NEG_INFINITY, f64::INFINITY]);
    PinchSummary {
        name: setup.blade.name.clone(),
        radius_mm: pinch.rows.radius_mm,
        rows: pinch.rows.rows.len(),
        edge_rows: pinch.rows.edge_rows,
        thread_turns: pinch.rows.turns.as_ref().map(|turns| turns.each_ref().map(|t| t.last().map_or(0, |n| n + 1))),
        edge_heights_mm: pinch.rows.edge_heights_mm,
        closed: pinch.rows.edge_heights_mm.map_or(0.0, |h| airfoil_mm2(setup, h) / area.max(f64::MIN_POSITIVE)),
        still_rows: pinch.still_rows(),
        stretches: pinch.held.len(),
        places: pinch.rows.places.len(),
        cut_off: pinch.cut_off,
        heights_mm: pinch.rows.heights_mm,
        length_mm: [0, 1].map(|k| pinch.rows.length_mm(k)),
        covered: [0, 1].map(|k| between_rows_mm2(&pinch.rows, k) / area.max(f64::MIN_POSITIVE)),
        ends: pinch.rows.ends_in_words(),
        narrowest_deg: narrowest.to_degrees(),
        narrowest_place,
        narrowest_own_deg: [own(0).to_degrees(), own(1).to_degrees()],
        turned_deg: turned.to_degrees(),
        turned_cutting_deg: pinch.held.iter().map(Held::turned_rad).sum::<f64>().to_degrees(),
        least_turning_rad_mm: pinch.least_slope,
        published: pinch.published.clone(),
        measured: pinch.figures.clone(),
        checks: pinch.checks.clone(),
        program: programmed.map(|p| program(setup, pinch, p)),
    }
}

fn program(setup: &Setup, pinch: &Pinch, programmed: &PinchProgrammed) -> ProgramSummary {
    let (motion, all_s) = (&programmed.motion, programmed.motion.alone_s.iter().sum::<f64>());
    let rows = &pinch.rows;
    let longest_mm = match rows.is_double_helix() {
        true => (0..rows.places.len()).map(|k| rows.longest_way_mm(k)).sum(),
        false => [0, 1].map(|k| rows.length_mm(k)).into_iter().fold(0.0, f64::max),
    };
    ProgramSummary {
        cutting_s: motion.cutting_s,
        ways_s: motion.ways_s,
        alone_s: motion.alone_s,
        one_after_the_other_s: all_s,
        share_of_one_after_the_other: motion.cutting_s / all_s.max(f64::MIN_POSITIVE),
        full_feed_s: 60.0 * longest_mm / setup.job.feed.feed_mm_min,
        checks: programmed.checks.clone(),
        programs: programmed.programs.iter().map(posted).collect(),
    }
}

fn posted(p: &PinchPosted) -> PostedSummary {
    PostedSummary {
        control: p.control.clone(),
        files: p.files.iter().map(|f| f.name.clone()).collect(),
        lines: p.files.iter().map(|f| f.text.lines().count()).sum(),
        checks: p.checks.clone(),
    }
}

/// `pinch_axes.csv`: all axes at the places of all stretches; the time begins anew in each. Linear
/// axes in mm, rotary axes in degrees, and their derivatives per second.
pub fn axes(setup: &Setup, motion: &PinchMotion) -> String {
    let axes = setup.machine.axes();
    let mut out = String::from("row,stretch,t_s");
    for prefix in ["", "v", "a", "j"] {
        for axis in axes {
            let _ = write!(out, ",{prefix}{}", axis.name);
        }
    }
    out.push('\n');
    for s in &motion.stretches {
        let m = &s.motion;
        for (k, t_s) in m.t_s.iter().enumerate() {
            let _ = write!(out, "{},{},{t_s}", s.row, s.stretch);
            for table in [&m.position, &m.velocity, &m.acceleration, &m.jerk] {
                for (c, axis) in axes.iter().enumerate() {
                    let _ = write!(out, ",{}", axis.shown(table[k][c]));
                }
            }
            out.push('\n');
        }
    }
    out
}

/// Area of the airfoil between two heights, mm²: of each triangle that share of its area which its
/// height lies between them.
fn airfoil_mm2(setup: &Setup, [low, high]: [f64; 2]) -> f64 {
    let mesh = &setup.blade.part.mesh;
    let Some(airfoil) = setup.blade.regions.first(Area::Airfoil) else { return 0.0 };
    let own = (0..mesh.triangles.len()).filter(|t| airfoil.patch.has(mesh, *t as u32));
    let between = |t: usize| {
        let x = mesh.corners(t).map(|p| p.x);
        let (from, to) = (x.into_iter().fold(f64::INFINITY, f64::min), x.into_iter().fold(f64::NEG_INFINITY, f64::max));
        let inside = to.min(high) - from.max(low);
        if to > from { (inside / (to - from)).clamp(0.0, 1.0) } else { f64::from(u8::from(inside >= 0.0)) }
    };
    own.map(|t| mesh.triangle_area_mm2(t) * between(t)).sum()
}

/// Area of the part between the contacts of neighbouring rows of opposite places, mm²: to each
/// place of a row the triangle over its step with the nearest place of the next one there.
fn between_rows_mm2(rows: &PairedRows, tool: usize) -> f64 {
    let held = &rows.rows[..rows.held_rows()];
    let contacts = |row: &Range<usize>| -> Vec<Point> {
        rows.places[row.clone()].iter().map(|p| p.contacts[tool].contact).collect()
    };
    let all: Vec<Vec<Point>> = held.iter().map(contacts).filter(|row| row.len() > 1).collect();
    let heights = |row: &[Point]| [row[row.len() - 1].x, row[0].x];
    let mut sum = 0.0;
    for (n, row) in all.iter().enumerate() {
        // A row may be in pieces: beside each of its heights lies the first one that is there too.
        let mut open = vec![heights(row)];
        for beside in &all[n + 1..] {
            let [low, high] = heights(beside);
            let mut left = Vec::new();
            for [bottom, top] in open {
                let shared = [bottom.max(low), top.min(high)];
                if shared[0] >= shared[1] {
                    left.push([bottom, top]);
                    continue;
                }
                sum += strip_mm2([row, beside], shared);
                left.extend([[bottom, shared[0]], [shared[1], top]].into_iter().filter(|[a, b]| a < b));
            }
            open = left;
            if open.is_empty() {
                break;
            }
        }
    }
    sum
}

/// Area between two rows that run down, between two heights, mm²: triangle by triangle, the lower
/// end moved on.
fn strip_mm2([a, b]: [&[Point]; 2], [bottom, top]: [f64; 2]) -> f64 {
    let start = |from: &[Point]| from.partition_point(|p| p.x > top).saturating_sub(1);
    let (mut i, mut j, mut sum) = (start(a), start(b), 0.0);
    while let (Some(p), Some(q)) = (a.get(i), b.get(j)) {
        if p.x.min(q.x) < bottom {
            break;
        }
        let (next_a, next_b) = (a.get(i + 1), b.get(j + 1));
        let first = match (next_a, next_b) {
            (Some(x), Some(y)) => x.x >= y.x,
            (Some(_), None) => true,
            (None, Some(_)) => false,
            (None, None) => break,
        };
        let Some(third) = (if first { next_a } else { next_b }) else { break };
        sum += 0.5 * (q - p).cross(&(third - p)).norm();
        if first { i += 1 } else { j += 1 }
    }
    sum
}

/// `pairs.csv`, and the locations of each tool in the columns of `cutter_locations.csv`.
pub fn tables(setup: &Setup, pinch: &Pinch) -> Vec<(&'static str, String)> {
    vec![
        ("pairs.csv", pairs(setup, pinch)),
        ("cutter_locations_1.csv", locations(setup, pinch, 0)),
        ("cutter_locations_2.csv", locations(setup, pinch, 1)),
    ]
}

/// Both contacts of each place: model frame, mm, degrees.
fn pairs(setup: &Setup, pinch: &Pinch) -> String {
    let mut out =
        String::from("# bladewright rows of two tools; model frame, mm; angles in degrees about the blade axis\n");
    out.push_str("row,place");
    for tool in 1..=2 {
        let _ = write!(out, ",c{tool}x,c{tool}y,c{tool}z,p{tool}x,p{tool}y,p{tool}z,n{tool}x,n{tool}y,n{tool}z");
    }
    out.push_str(",mx,my,mz,radius,angle_deg,line_distance_mm,table_deg,free_1_deg,free_2_deg,common_deg,common_min_deg,common_max_deg\n");
    let to_model = &setup.blade.model_from_blade;
    for (k, place) in pinch.rows.places.iter().enumerate() {
        let Some(held) = pinch.held_at(k) else { continue };
        let _ = write!(out, "{},{k}", held.row);
        for c in &place.contacts {
            for v in [(to_model * c.centre).coords, (to_model * c.contact).coords, to_model * c.normal] {
                let _ = write!(out, ",{},{},{}", v.x, v.y, v.z);
            }
        }
        let m = to_model * place.held_centre;
        let [from, to] = pinch.common[k].around(held.theta_at(k));
        let _ = writeln!(
            out,
            ",{},{},{},{},{},{},{},{},{},{},{},{}",
            m.x,
            m.y,
            m.z,
            place.held_radius_mm,
            place.angle_rad.to_degrees(),
            place.apart_mm,
            held.theta_at(k).to_degrees(),
            pinch.own[0][k].widest().to_degrees(),
            pinch.own[1][k].widest().to_degrees(),
            pinch.common[k].widest().to_degrees(),
            from.to_degrees(),
            to.to_degrees()
        );
    }
    out
}

/// The locations of a tool as `cutter_locations.csv` has them, a turn for each row.
fn locations(setup: &Setup, pinch: &Pinch, tool: usize) -> String {
    let cone = setup.pinch_cones()[tool];
    let over = if tool == 0 { 0.0 } else { pinch.between_rad };
    let path = pinch.rows.toolpath(tool, crate::artifact::Cones::Same(cone));
    let mut out = format!(
        "# bladewright cutter locations of tool {}; model frame, mm; angles in degrees about the blade axis\n",
        tool + 1
    );
    out.push_str("# each turn is a row; the ways from row to row are not part of it\n");
    out.push_str("turn,S,s,cx,cy,cz,px,py,pz,nx,ny,nz,ix,iy,iz,theta_deg,theta_min_deg,theta_max_deg,feed_mm_min\n");
    let to_model = &setup.blade.model_from_blade;
    for (k, l) in path.locations.iter().enumerate() {
        let Some(held) = pinch.held_at(k) else { continue };
        let theta = held.theta_at(k) + over;
        let [from, to] = pinch.common[k].around(held.theta_at(k)).map(|v| v + over);
        let _ = write!(out, "{},{},{}", l.turn, l.turn_s_mm, l.s_mm);
        let axis = to_model * cone.tool_axis(theta);
        for v in [(to_model * l.centre).coords, (to_model * l.contact).coords, to_model * l.normal, axis] {
            let _ = write!(out, ",{},{},{}", v.x, v.y, v.z);
        }
        let _ = writeln!(
            out,
            ",{},{},{},{}",
            theta.to_degrees(),
            from.to_degrees(),
            to.to_degrees(),
            setup.job.feed.feed_mm_min
        );
    }
    out
}

/// Both tools over time, with about so many keys at most: the first and the last place of each
/// stretch are among them, and both tools over them. Ways from row to row are those of the
/// machine's two heads, else straight up and down again, and take a second each.
fn keys(setup: &Setup, pinch: &Pinch, motion: Option<&PinchMotion>, most: usize) -> Vec<PinchKey> {
    let cones = setup.pinch_cones();
    let usual_mm = setup.pinch_tools().map(|t| 4.0 * t.radius_mm);
    let every = pinch.rows.places.len().div_ceil(most).max(1);
    let (mut keys, mut t_s) = (Vec::new(), 0.0);
    for (stretch, held) in pinch.held.iter().enumerate() {
        let own = motion.and_then(|m| m.stretches.get(stretch));
        let stand = |k: usize, lifts_mm: [f64; 2]| {
            [0, 1].map(|j| {
                let theta = held.theta_at(k) + if j == 0 { 0.0 } else { pinch.between_rad };
                let centre = pinch.rows.places[k].contacts[j].centre;
                Stand { centre, cone: cones[j], theta }.lifted(lifts_mm[j])
            })
        };
        let lifts_mm = own.map_or([usual_mm; 2], |m| m.lifts_mm);
        let last = held.places.end - 1;
        keys.push(PinchKey { t_s, stretch, place: None, stands: stand(held.places.start, lifts_mm[0]) });
        t_s += LINK_S;
        let begin_s = t_s;
        for (i, k) in held.places.clone().enumerate().filter(|(i, k)| i % every == 0 || *k == last) {
            // By the machine's motion, else by the feed along the first tool's row.
            t_s = match own.and_then(|m| Some(m.motion.t_s.get(m.row_at(i))? - m.motion.t_s.first()?)) {
                Some(s) => begin_s + s,
                None => begin_s + way_mm(&pinch.rows.places[held.places.start..=k]) * 60.0 / setup.job.feed.feed_mm_min,
            };
            keys.push(PinchKey { t_s, stretch, place: Some(k), stands: stand(k, [0.0; 2]) });
        }
        t_s += LINK_S;
        keys.push(PinchKey { t_s, stretch, place: None, stands: stand(last, lifts_mm[1]) });
        t_s += LINK_S;
    }
    keys
}

/// The part, the rows and both tools in motion as the bytes of a `.glb` file.
///
/// # Errors
/// Those of the scene.
pub fn scene(setup: &Setup, pinch: &Pinch, motion: Option<&PinchMotion>) -> Result<Vec<u8>> {
    let rows = [0, 1].map(|j| {
        let over = |p: &PairPlace| p.contacts[j].contact + p.contacts[j].normal * (0.004 * pinch.rows.radius_mm[j]);
        pinch.rows.rows.iter().map(|row| pinch.rows.places[row.clone()].iter().map(over).collect()).collect()
    });
    let mesh = &setup.blade.part.mesh;
    let airfoil = setup.blade.regions.first(Area::Airfoil);
    let area = |t: u32| match airfoil.is_some_and(|r| r.patch.has(mesh, t)) {
        true => Area::Airfoil,
        false => Area::Other,
    };
    let areas: Vec<Area> = (0..mesh.triangles.len() as u32).map(area).collect();
    preview::pinch(&PinchScene {
        name: &setup.blade.name,
        mesh,
        areas: &areas,
        model_from_blade: &setup.blade.model_from_blade,
        tools: setup.pinch_tools(),
        rows,
        keys: &keys(setup, pinch, motion, MOST_KEYS),
    })
}

/// The report as the text of a self-contained `.html` file. `loaded`: what was planned, with the
/// files that it was read from; `figures`: those of `pinch.json`.
///
/// # Errors
/// Those of the job's text and of the page.
pub fn report(
    loaded: &Loaded,
    pinch: &Pinch,
    motion: Option<&PinchMotion>,
    figures: &PinchSummary,
    warnings: &[Warning],
) -> Result<String> {
    let setup = &loaded.setup;
    let asked = setup.pinch_settings();
    report::pinch::html(&PinchReport {
        title: &setup.blade.name,
        blade: &setup.blade,
        tools: setup.pinch_tools(),
        leans_rad: setup.pinch_cones().map(|c| c.lean_rad),
        between_rad: pinch.between_rad,
        spindle_rpm: setup.pinch_spindles_rpm(),
        machine: &setup.machine,
        obstacles: &setup.obstacles,
        rows: &pinch.rows,
        stretches: &stretches(pinch),
        motion,
        keys: &keys(setup, pinch, motion, REPORT_KEYS),
        max_angle_deg: asked.max_angle_deg,
        line_distance_mm: asked.line_distance_mm,
        figures: File { name: "pinch", json: &look::json_of(figures)? },
        warnings,
        job_toml: &setup.job.to_toml()?,
        provenance: &look::provenance(setup, &loaded.inputs),
    })
}

/// All stretches with what is free about the angles at which the table stands.
fn stretches(pinch: &Pinch) -> Vec<PinchStretch> {
    let all = pinch.held.iter().map(|held| PinchStretch {
        row: held.row,
        places: held.places.clone(),
        theta_rad: held.theta_rad.clone(),
        free_rad: pinch.free_about(held),
    });
    all.collect()
}

/// Length of the first tool's way over places, mm.
fn way_mm(places: &[PairPlace]) -> f64 {
    places.windows(2).map(|w| (w[1].contacts[0].centre - w[0].contacts[0].centre).norm()).sum()
}

/// What of the table's turn is free along the rows, and where it stands: SVG.
pub fn plot(setup: &Setup, pinch: &Pinch) -> String {
    let of = |h: &Held| {
        let at = |share: f64, places: Range<usize>| {
            let theta = h.theta_at(places.start);
            let common_deg = pinch.free_all_along(places, theta).map(f64::to_degrees);
            HeldAngles { row: h.row as f64 + share, held_deg: theta.to_degrees(), common_deg }
        };
        if h.is_still() {
            return vec![at(0.0, h.places.clone())];
        }
        // Of a double helix turn by turn.
        if let Some([turns, _]) = &pinch.rows.turns {
            let many = TURNING_POINTS * turns.last().map_or(1, |last| *last as usize + 1);
            let every = h.places.len().div_ceil(many);
            let within = |k: usize| {
                let first = turns.partition_point(|t| *t < turns[k]);
                let end = turns.partition_point(|t| *t <= turns[k]);
                f64::from(turns[k]) + (k - first) as f64 / (end - first) as f64
            };
            return h.places.clone().step_by(every).map(|k| at(within(k), k..k + 1)).collect();
        }
        // Where it turns, place by place, over most of the room that the row has.
        let every = h.places.len().div_ceil(TURNING_POINTS);
        let share = |k: usize| 0.8 * ((k - h.places.start) as f64 / h.places.len() as f64 - 0.5);
        h.places.clone().step_by(every).map(|k| at(share(k), k..k + 1)).collect()
    };
    let rows: Vec<HeldAngles> = pinch.held.iter().flat_map(of).collect();
    let of = if pinch.rows.is_double_helix() { "turn of tool 1" } else { "row" };
    held_svg(&setup.blade.name, of, &rows)
}
