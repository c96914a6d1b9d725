//! Signs that are swapped: after gouges or touches all over, or no contact at all, the same program with the other sign of B, and with the other sense of A.

use super::legs::Legs;
use super::report::{Limit, LineCheck, Worst};
use super::{Scene, checks};
use crate::error::Result;
use crate::machine::{Machine, PositiveA};
use crate::read::program::{Bench, Moved};

/// A sign that is wrong is so all over: with a smaller share of bad legs it is not to blame.
const WIDESPREAD: f64 = 0.05;

/// A check for each sign whose swapping leaves neither gouge nor touch: it fails, since that is what is wrong.
///
/// # Errors
/// As [`Legs::new`].
pub(super) fn signs(scene: &Scene) -> Result<Vec<LineCheck>> {
    let mut out = Vec::new();
    let contact = checks::contact(scene, &scene.passes()).check.passed;
    if contact && checks::share_bad(scene) < WIDESPREAD {
        return Ok(out);
    }
    let [.., first, second] = scene.bench.machine.axis_names();
    let leans = scene.moves.iter().any(|m| m.from[4] != 0.0 || m.to[4] != 0.0);
    if leans && well(scene, &other_b(scene.moves), scene.bench.machine)? {
        let quantity = format!(
            "with the other sign of {second} there is contact, and neither gouge nor touch: {second} has the wrong sign in the program, or in the machine file"
        );
        out.push(blamed(scene, "b-sign", &quantity, |m| m.to[4] != 0.0));
    }
    if well(scene, scene.moves, &other_a(scene.bench.machine))? {
        let says = if scene.bench.machine.chain.is_empty() { "table.positive_a_turns" } else { "its direction" };
        let quantity = format!(
            "with the other sense of {first} there is contact, and neither gouge nor touch: {first} turns the other way than {says} of the machine file says"
        );
        out.push(blamed(scene, "a-sense", &quantity, |m| m.to[3] != 0.0));
    }
    Ok(out)
}

/// Every B negative.
fn other_b(moves: &[Moved]) -> Vec<Moved> {
    let turned = |m: &Moved| {
        let mut m = *m;
        (m.from[4], m.to[4]) = (-m.from[4], -m.to[4]);
        m.bend.iter_mut().for_each(|bend| bend[4] = bend[4].map(|a| -a));
        m
    };
    moves.iter().map(turned).collect()
}

/// The first rotary axis counted the other way.
fn other_a(machine: &Machine) -> Machine {
    let mut other = machine.clone();
    if let Some(table) = &mut other.table {
        table.positive_a_turns = match table.positive_a_turns {
            PositiveA::Tool => PositiveA::Workpiece,
            PositiveA::Workpiece => PositiveA::Tool,
        };
    }
    if let [Some(first), _] = other.rotary_axes()
        && let (false, Some(axis)) = (other.chain.is_empty(), other.axes.rotary_mut(first))
    {
        let [x, y, z] = axis.direction.unwrap_or_else(|| first.unit());
        axis.direction = Some([-x, -y, -z]);
    }
    other
}

/// Neither gouge nor touch.
fn well(scene: &Scene, moves: &[Moved], machine: &Machine) -> Result<bool> {
    let bench = Bench { machine, ..*scene.bench };
    let legs = Legs::new(moves, &bench)?;
    let turns = vec![0; legs.stands.len()];
    let other = Scene {
        blade: scene.blade,
        part: scene.part,
        bench: &bench,
        options: scene.options,
        text: scene.text,
        moves,
        legs: &legs,
        turns,
    };
    Ok(checks::clean(&other))
}

fn blamed(scene: &Scene, name: &str, quantity: &str, says: impl Fn(&Moved) -> bool) -> LineCheck {
    let limit = Limit { name: name.into(), quantity: quantity.into(), limit: 0.0, unit: "sign", passed: false };
    let moved = scene.moves.iter().position(says);
    scene.judged(limit, &Worst { value: 1.0, moved, turn: None, point: None }, "the first line that says it".into())
}
