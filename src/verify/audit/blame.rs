//! Signs that are swapped: after gouges or touches all over, or no contact at all, the same program
//! with the other sign of B, and with the other sense of A.

use super::legs::Legs;
use super::line_check::{LineCheck, LineLimit};
use super::report::WorstMove;
use super::{AuditScene, checks};
use crate::artifact::CheckId;
use crate::error::Result;
use crate::machine::Machine;
use crate::read::program::{Bench, Moved};

/// A sign that is wrong is so all over: with a smaller share of bad legs it is not to blame.
const WIDESPREAD: f64 = 0.05;

/// A check for each sign whose swapping leaves neither gouge nor touch: it fails, since that is
/// what is wrong.
///
/// # Errors
/// As [`Legs::new`].
pub(super) fn signs(scene: &AuditScene) -> Result<Vec<LineCheck>> {
    let mut out = Vec::new();
    let contact = checks::contact(scene, &scene.passes()).check.passed;
    if contact && checks::share_bad(scene) < WIDESPREAD {
        return Ok(out);
    }
    let machine = scene.bench.machine;
    let (turning, axes) = (machine.turning_axis(), machine.axes());
    for leaning in machine.rotary().skip(1) {
        let leans = scene.moves.iter().any(|m| m.from[leaning] != 0.0 || m.to[leaning] != 0.0);
        if leans && well(scene, &other_sign(scene.moves, leaning), machine)? {
            let name = &axes[leaning].name;
            let quantity = format!(
                "with the other sign of {name} there is contact, and neither gouge nor touch: {name} has the wrong sign in the program, or in the machine file"
            );
            out.push(blamed(scene, CheckId::BSign, &quantity, |m| m.to[leaning] != 0.0));
        }
    }
    if well(scene, scene.moves, &machine.clone().with_axis_reversed(turning))? {
        let first = &axes[turning].name;
        let says = axes[turning].sense_key;
        let quantity = format!(
            "with the other sense of {first} there is contact, and neither gouge nor touch: {first} turns the other way than {says} of the machine file says"
        );
        out.push(blamed(scene, CheckId::ASense, &quantity, |m| m.to[turning] != 0.0));
    }
    Ok(out)
}

/// Every position of an axis with the other sign.
fn other_sign(moves: &[Moved], axis: usize) -> Vec<Moved> {
    let turned = |m: &Moved| {
        let mut m = *m;
        (m.from[axis], m.to[axis]) = (-m.from[axis], -m.to[axis]);
        m.bend.iter_mut().for_each(|bend| bend[axis] = bend[axis].map(|a| -a));
        m
    };
    moves.iter().map(turned).collect()
}

/// Neither gouge nor touch.
fn well(scene: &AuditScene, moves: &[Moved], machine: &Machine) -> Result<bool> {
    let bench = Bench { machine, ..*scene.bench };
    let legs = Legs::new(moves, &bench)?;
    let turns = vec![0; legs.stands.len()];
    let other = AuditScene {
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

fn blamed(scene: &AuditScene, id: CheckId, quantity: &str, says: impl Fn(&Moved) -> bool) -> LineCheck {
    let limit = LineLimit { id, quantity: quantity.into(), limit: 0.0, unit: "sign", passed: false };
    let moved = scene.moves.iter().position(says);
    scene.judged(limit, &WorstMove { value: 1.0, moved, turn: None, point: None }, "the first line that says it".into())
}
