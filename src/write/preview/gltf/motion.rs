//! Two animations of the same run: the part fixed, and as on the machine.
//!
//! * *part fixed*: the tool moves in the model frame, the workpiece rests;
//! * *as on the machine*: the table turns the workpiece, the head keeps its direction and its axes
//!   carry the ball centre. The machine's Z is the model's z (up in a viewer), its X the model's x;
//!   the table's axis passes through where the middle of the part rests, so that nothing jumps out
//!   of sight.

use gltf_json as json;
use json::animation::{Animation, Channel, Interpolation, Property, Sampler, Target};
use json::scene::Node;
use json::validation::Checked;
use json::{Index, accessor::Accessor};
use nalgebra::{Matrix3, Rotation3, UnitQuaternion};
use serde_json::json;

use super::glb::Glb;
use super::{Detail, Scene, extras, single, triple};
use crate::artifact::plan::Row;
use crate::artifact::{Plan, Stand};
use crate::error::Result;
use crate::geometry::{Point, Rigid, Vector};

/// θ between two keys, at most, rad: a viewer turns the table the short way.
const MOST_TURNED_RAD: f64 = std::f64::consts::PI / 12.0;
/// Halvings of the range in which the least distance for a number of keys is sought.
const HALVINGS: usize = 24;

/// The rows that an animation stops at: at most `count`, those from which the others are least far
/// off; more where the table would turn too far between two.
fn keys(rows: &[Row], length_mm: f64, count: usize) -> Vec<usize> {
    let times: Vec<f64> = rows.iter().map(|r| r.t_s).collect();
    let all: Vec<usize> = (0..rows.len()).filter(|&i| i == 0 || times[i] > times[i - 1]).collect();
    if all.len() <= count {
        return all;
    }
    let places: Vec<[f64; 6]> = rows
        .iter()
        .map(|r| {
            let (c, e) = (r.stand.centre, r.stand.centre + r.stand.axis() * length_mm);
            [c.x, c.y, c.z, e.x, e.y, e.z]
        })
        .collect();
    let theta: Vec<f64> = rows.iter().map(|r| r.stand.theta).collect();
    let within = |off_mm: f64| within(&times, &places, &theta, off_mm);
    let spread = |k: usize| {
        let (low, high) = places.iter().fold((f64::MAX, f64::MIN), |s, p| (s.0.min(p[k]), s.1.max(p[k])));
        high - low
    };
    let (mut low, mut high) = (0.0, (0..6).map(spread).fold(0.0, f64::max));
    for _ in 0..HALVINGS {
        let mid = 0.5 * (low + high);
        *(if within(mid).len() <= count { &mut high } else { &mut low }) = mid;
    }
    within(high)
}

/// How far the tool is at most, against the part, from where rows have it, where both go evenly in
/// time from key to key: by the ball's centre and the end of the tool, mm. `table`: where the part
/// is in a row.
fn greatest_off(rows: &[Row], keys: &[usize], length_mm: f64, table: impl Fn(usize) -> Rigid) -> f64 {
    let end = Point::from(Vector::z() * length_mm);
    let in_part = |k: usize| Rigid::from_parts(rows[k].stand.centre.coords.into(), attitude(&rows[k].stand));
    let off = |pair: &[usize]| {
        let [a, b] = [pair[0], pair[1]];
        let tables = [table(a), table(b)];
        let tools = [tables[0] * in_part(a), tables[1] * in_part(b)];
        let one = |k: usize| {
            let share = (rows[k].t_s - rows[a].t_s) / (rows[b].t_s - rows[a].t_s);
            // Neither where one turns by half a turn from key to key: nobody can say which way.
            let between = |ends: &[Rigid; 2]| ends[0].try_lerp_slerp(&ends[1], share, 1e-9);
            let Some((part, tool)) = between(&tables).zip(between(&tools)) else { return 0.0 };
            let (own, shown) = (in_part(k), part.inverse() * tool);
            let centre = (own.translation.vector - shown.translation.vector).norm();
            centre.max((own * end - shown * end).norm())
        };
        (a + 1..b).map(one).fold(0.0, f64::max)
    };
    keys.windows(2).map(off).fold(0.0, f64::max)
}

/// Rows such that all between two of them are within `off` of the straight way in time from one to
/// the other, in every coordinate: each way is drawn out while one slope of every coordinate passes
/// all rows so far at that distance (Bristol 1990, "Swinging door trending"). Rows without time
/// between them count once.
fn within(times: &[f64], places: &[[f64; 6]], theta: &[f64], off: f64) -> Vec<usize> {
    const OPEN: [[f64; 2]; 6] = [[f64::NEG_INFINITY, f64::INFINITY]; 6];
    let mut out: Vec<usize> = Vec::new();
    let (mut from, mut last, mut doors) = (0, 0, OPEN);
    for (i, at) in places.iter().enumerate() {
        let Some(&anchor) = out.last() else {
            out.push(i);
            (from, last) = (i, i);
            continue;
        };
        if times[i] <= times[last] {
            continue;
        }
        let slopes =
            |from: usize| std::array::from_fn::<_, 6, _>(|k| (at[k] - places[from][k]) / (times[i] - times[from]));
        let fits = slopes(from).iter().zip(&doors).all(|(s, d)| (d[0]..=d[1]).contains(s));
        if last > anchor && !(fits && (theta[i] - theta[from]).abs() <= MOST_TURNED_RAD) {
            out.push(last);
            (from, doors) = (last, OPEN);
        }
        let reach = off / (times[i] - times[from]);
        for (door, slope) in doors.iter_mut().zip(slopes(from)) {
            *door = [door[0].max(slope - reach), door[1].min(slope + reach)];
        }
        last = i;
    }
    if out.last().is_some_and(|k| *k < last) {
        out.push(last);
    }
    out
}

/// Places of a node over time, translations and rotations `(x, y, z, w)`.
#[derive(Default)]
pub(super) struct Track {
    at: Vec<[f32; 3]>,
    turned: Vec<[f32; 4]>,
    last: Option<nalgebra::Quaternion<f64>>,
}

impl Track {
    pub(super) fn push(&mut self, place: &Rigid) -> Result<()> {
        let mut q = *place.rotation.quaternion();
        // Both signs are the same rotation; the one near the key before is interpolated the short
        // way.
        if self.last.is_some_and(|l| l.dot(&q) < 0.0) {
            q = -q;
        }
        self.last = Some(q);
        self.at.push(triple(&place.translation.vector)?);
        self.turned.push([single(q.i)?, single(q.j)?, single(q.k)?, single(q.w)?]);
        Ok(())
    }

    /// The first place.
    pub(super) fn first(&self) -> Option<([f32; 3], [f32; 4])> {
        Some((*self.at.first()?, *self.turned.first()?))
    }
}

/// The tool's +Z to its axis: leaning, then turning about the axis of its cone by θ, without any
/// jump.
pub(super) fn attitude(stand: &Stand) -> UnitQuaternion<f64> {
    let turn = UnitQuaternion::from_axis_angle(&Vector::x_axis(), stand.theta) * lean(stand.cone.lean_rad);
    if stand.cone.is_about_blade() {
        return turn;
    }
    let (c, e) = (stand.cone.axis, stand.cone.reference);
    let frame = Rotation3::from_matrix_unchecked(Matrix3::from_columns(&[c, e, c.cross(&e)]));
    UnitQuaternion::from_rotation_matrix(&frame) * turn
}

/// The angle of the tool axis about the blade axis, which the table of a machine turns the part by,
/// rad.
fn about_the_blade(stand: &Stand) -> f64 {
    let a = stand.axis();
    if stand.cone.is_about_blade() { stand.theta } else { a.z.atan2(a.y) }
}

/// The tool's +Z to the tool axis at θ = 0, in the frame of a cone.
pub(super) fn lean(b_rad: f64) -> UnitQuaternion<f64> {
    let (sb, cb) = b_rad.sin_cos();
    UnitQuaternion::rotation_between(&Vector::z(), &Vector::new(sb, cb, 0.0)).unwrap_or_default()
}

/// The part's place on the machine in a row of the plan, whose axes stand `at`: by those where each
/// location has a cone of its own; else as [`crate::machine::Machine::shown_part`] shows it.
fn part_on_machine(plan: &Plan, scene: &Scene, stand: &Stand, at: Option<&[f64]>) -> Rigid {
    match at.filter(|_| plan.toolpath.cones.same().is_none()) {
        Some(at) => scene.machine.part_at(at),
        None => scene.machine.shown_part(about_the_blade(stand)),
    }
}

/// The machine frame's place in the scene, which is the model frame.
fn scene_from_machine(plan: &Plan, scene: &Scene) -> Rigid {
    let mid = scene.blade.part.mesh.aabb().map_or(Point::origin(), |b| b.min + (b.max - b.min) * 0.5);
    if plan.toolpath.cones.same().is_none()
        && let Some(Row { stand, .. }) = plan.rows().next()
    {
        let at_first = part_on_machine(plan, scene, &stand, plan.axes().next()) * mid;
        return Rigid::from_parts((scene.blade.model_from_blade * mid - at_first).into(), UnitQuaternion::identity());
    }
    let (at_zero, [axis_y, axis_z], _) = scene.machine.shown_table();
    let mut axis = at_zero * mid;
    (axis.y, axis.z) = (axis_y, axis_z);
    Rigid::from_parts((scene.blade.model_from_blade * mid - axis).into(), UnitQuaternion::identity())
}

/// Both animations; none where there are not two keys. `workpiece` and `tool` are the nodes that
/// move.
pub(super) fn animations(
    glb: &mut Glb,
    plan: &Plan,
    scene: &Scene,
    (workpiece, tool): (Index<Node>, Index<Node>),
    detail: &Detail,
) -> Result<Vec<Animation>> {
    let rows: Vec<Row> = plan.rows().collect();
    let length_mm = scene.tool.length_mm();
    let keys = keys(&rows, length_mm, detail.keys);
    let speed = scene.play_speed(plan);
    let model = &scene.blade.model_from_blade;
    let (to_scene, part_from_model) = (scene_from_machine(plan, scene), model.inverse());
    let mut times: Vec<f32> = Vec::new();
    let [mut fixed, mut carried, mut turned] = [Track::default(), Track::default(), Track::default()];
    let axes: Vec<&[f64]> = plan.axes().collect();
    let table_at = |row: usize| to_scene * part_on_machine(plan, scene, &rows[row].stand, axes.get(row).copied());
    for row in &keys {
        let Row { stand, t_s, .. } = &rows[*row];
        let time = single(t_s / speed)?;
        if times.last().is_some_and(|t| time <= *t) {
            continue;
        }
        times.push(time);
        let in_part = Rigid::from_parts(stand.centre.coords.into(), attitude(stand));
        let table = table_at(*row);
        fixed.push(&(model * in_part))?;
        carried.push(&(table * in_part))?;
        turned.push(&(table * part_from_model))?;
    }
    if times.len() < 2 {
        return Ok(Vec::new());
    }
    let input = glb.times(&times);
    let note = |what: &str, off_mm: f64| {
        json!({
            "what": what, "machining_time_s": plan.motion.time_s, "played_times_faster": speed,
            "keys": times.len(), "off_the_plan_mm_at_most": off_mm,
        })
    };
    let off_mm =
        [greatest_off(&rows, &keys, length_mm, |_| Rigid::identity()), greatest_off(&rows, &keys, length_mm, table_at)];
    let ends = [times[0], times[times.len() - 1]];
    let (mut rest, ends) = (Track::default(), glb.times(&ends));
    rest.push(&Rigid::identity())?;
    rest.push(&Rigid::identity())?;
    let name = |what: &str| format!("{what}, {speed:.1} x real time");
    Ok(vec![
        animation(
            glb,
            &[(tool, input, fixed), (workpiece, ends, rest)],
            name("part fixed"),
            &note("the tool moves, the part rests", off_mm[0]),
        ),
        animation(
            glb,
            &[(tool, input, carried), (workpiece, input, turned)],
            name("as on the machine"),
            &note("the table turns the part, the head keeps its direction", off_mm[1]),
        ),
    ])
}

/// A node that moves, its key times, its places.
pub(super) type MovedNode = (Index<Node>, Index<Accessor>, Track);

pub(super) fn animation(glb: &mut Glb, tracks: &[MovedNode], name: String, note: &serde_json::Value) -> Animation {
    let (mut channels, mut samplers) = (Vec::new(), Vec::new());
    for (node, input, track) in tracks {
        for (path, output) in
            [(Property::Translation, glb.translations(&track.at)), (Property::Rotation, glb.rotations(&track.turned))]
        {
            channels.push(Channel {
                sampler: Index::new(u32::try_from(samplers.len()).unwrap_or(0)),
                target: Target { extensions: None, extras: None, node: *node, path: Checked::Valid(path) },
                extensions: None,
                extras: None,
            });
            samplers.push(Sampler {
                extensions: None,
                extras: None,
                input: *input,
                interpolation: Checked::Valid(Interpolation::Linear),
                output,
            });
        }
    }
    Animation { extensions: None, extras: extras(note), channels, name: Some(name), samplers }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::sample;

    #[test]
    fn keys_are_few_where_the_tool_goes_evenly_and_say_how_far_off_they_are() {
        // Rows that crowd in one place, as about an edge: keys by number would crowd there too.
        let mut rows: Vec<Row> = sample::with_leads(sample::plan(3, 600)).rows().collect();
        let crowd: Vec<Row> = (1..400)
            .map(|k| {
                let share = f64::from(k) / 400.0;
                let mut row = rows[700];
                row.stand = rows[700].stand.towards(&rows[701].stand, share);
                row.t_s += (rows[701].t_s - row.t_s) * share;
                row
            })
            .collect();
        rows.splice(701..701, crowd);
        let length_mm = sample::tool().length_mm();
        let chosen = keys(&rows, length_mm, 300);
        assert!(chosen.len() <= 300 && chosen.len() > 250, "{}", chosen.len());
        assert_eq!((chosen[0], chosen[chosen.len() - 1]), (0, rows.len() - 1));
        let evenly: Vec<usize> = (0..300).map(|k| k * (rows.len() - 1) / 299).collect();
        let [off, other] = [&chosen, &evenly].map(|k| greatest_off(&rows, k, length_mm, |_| Rigid::identity()));
        assert!(off > 0.0 && off < 0.8 * other, "{off} {other}");
        // A part that turns the other way under a tool that hardly moves: off by arcs and chords.
        let turned = |k: usize| Rigid::rotation(Vector::x() * -rows[k].stand.theta);
        let on_table = greatest_off(&rows, &chosen, length_mm, turned);
        assert!(on_table > 0.0 && on_table < 2.0 * off, "{on_table} {off}");
        // All rows where they fit.
        let all = keys(&rows, length_mm, rows.len());
        assert!(all.len() >= rows.len() - 2, "{}", all.len());
        assert_eq!(greatest_off(&rows, &all, length_mm, turned), 0.0);
        // Half a turn from one key to the next is no panic.
        let half = |k: usize| Rigid::rotation(Vector::x() * if k == 0 { 0.0 } else { std::f64::consts::PI });
        assert!(greatest_off(&rows, &[0, rows.len() - 1], length_mm, half) >= 0.0);
    }

    #[test]
    fn the_table_turns_the_short_way_between_keys() {
        let rows: Vec<Row> = sample::plan(4, 90).rows().collect();
        let keys = keys(&rows, 100.0, 2);
        let most = keys.windows(2).map(|w| rows[w[1]].stand.theta - rows[w[0]].stand.theta).fold(0.0, f64::max);
        assert!(most <= MOST_TURNED_RAD + 1e-9 && keys.len() > 90, "{most} {}", keys.len());
    }
}
