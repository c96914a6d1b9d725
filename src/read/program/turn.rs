//! The tool axis turned in the plane of its ends, as rotary axes that go evenly from piece to
//! piece.

use crate::artifact::Axes;
use crate::geometry::Vector;
use crate::machine::Machine;
use crate::numerics::angle::within_half_turn;

/// Greatest angle of the tool axis within a piece from the great circle, rad.
const OFF_RAD: f64 = 1e-6;
/// The ends of a line are the same axis within this, rad.
const SAME_RAD: f64 = 1e-9;
/// Axes that are this near to opposite do not give their plane, rad.
const OPPOSITE_RAD: f64 = 1e-6;
/// Most pieces of a line.
const MOST: usize = 1 << 14;

/// The ends of the pieces of a straight line from one row to another; none where the tool axis
/// stands. `vector`: the rotary axes of the end follow those of the way, else they are given.
///
/// # Errors
/// What is wrong, in words: no plane, an axis out of reach, or rotary axes that lead there another
/// way.
pub(super) fn great_circle(machine: &Machine, from: &Axes, to: &Axes, vector: bool) -> Result<Vec<Axes>, String> {
    let [a, b] = [from, to].map(|at| machine.axis_at(at));
    let angle = a.angle(&b);
    if !(angle > SAME_RAD) {
        return Ok(Vec::new());
    }
    if angle > std::f64::consts::PI - OPPOSITE_RAD {
        return Err("the tool axis turns by half a turn: its plane is not determined".into());
    }
    let along = |share: f64| {
        let [wa, wb] = [((1.0 - share) * angle).sin(), (share * angle).sin()];
        (a * wa + b * wb) / angle.sin()
    };
    let mut count = 1;
    loop {
        let (ends, off) = chain(machine, [from, to], count, vector, along)?;
        if off <= OFF_RAD {
            let astray = |k: usize| ends.last().map_or(0.0, |e| (e[k] - to[k]).abs());
            if !vector && machine.rotary().any(|k| astray(k) > 0.001) {
                return Err("the rotary axes lead to the tool axis another way than in the plane of its ends".into());
            }
            return Ok(ends);
        }
        // What is off falls with the square of the length of a piece.
        let finer = (count as f64 * (1.1 * off / OFF_RAD).sqrt()).ceil().min(1e9) as usize;
        if finer > MOST {
            return Err("the tool axis turns too close to the rotary axis to be followed".into());
        }
        count = finer.max(count + 1);
    }
}

/// So many pieces, and how far the tool axis within them is off the great circle.
fn chain(
    machine: &Machine,
    [from, to]: [&Axes; 2],
    count: usize,
    vector: bool,
    along: impl Fn(f64) -> Vector,
) -> Result<(Vec<Axes>, f64), String> {
    let share = |k: f64| k / count as f64;
    let (mut ends, mut off, mut before) = (Vec::new(), 0.0f64, *from);
    for k in 1..=count {
        let axis = along(share(k as f64));
        let given = k == count && !vector;
        let turned = if given { Some(*to) } else { machine.rotary_of_axis(&axis, &before) };
        let turned = turned.ok_or("the tool axis passes the direction of the rotary axis on its way")?;
        let mut end = from.toward(to, share(k as f64));
        for i in machine.rotary() {
            // Of the turn that the way comes through.
            end[i] = before[i] + within_half_turn(turned[i] - before[i]);
        }
        for part in [0.25, 0.5, 0.75] {
            let (mid, want) = (machine.axis_at(&before.toward(&end, part)), along(share(k as f64 - 1.0 + part)));
            off = off.max(mid.angle(&want));
        }
        before = end;
        ends.push(end);
    }
    Ok((ends, off))
}
