//! Several finished runs of one part as one program: an operation each, in the order given.
//!
//! A run is an artifact: planned, checked and sealed by itself, with its own tool, path and stock.
//! A program of several operations is nothing but their programs one after another, each from its
//! tool call to the unwound axis; what is new are the moves between, and those are read back and
//! checked (`program-rapids`).

use super::inputs::Loaded;
use super::reuse;
use crate::artifact::report::Check;
use crate::artifact::{Plan, Program};
use crate::error::{Error, Result, Stage};
use crate::plan::leads;
use crate::verify::{self, Verified};
use crate::write::post::{self, Dialect, Operation, PostOptions};

/// A finished run taken up again, its plan checked.
pub struct Done {
    /// Job, blade, machine, and the files that these were read from.
    pub loaded: Loaded,
    /// The plan.
    pub verified: Verified<Plan>,
    /// What messages call it.
    pub name: String,
}

/// Where a program begins that goes on after a break.
#[derive(Clone, Copy, Debug, Default)]
pub struct From {
    /// With this operation, from 1.
    pub operation: Option<usize>,
    /// With this turn of it, from 1.
    pub turn: Option<usize>,
}

/// The program, and what reading it back found: every operation against its plan, and all moves
/// between.
///
/// # Errors
/// `Usage` where runs are not of the same part in the same frame on the same machine, or there is
/// no such operation; those of [`post::join`] and of [`verify::read_back::read_back_each`].
pub fn join(runs: &[Done], dialect: &Dialect, from: From) -> Result<(Program, Vec<Check>)> {
    let first = from.operation.unwrap_or(1);
    let (Some(left), Some(one)) = (first.checked_sub(1).and_then(|k| runs.get(k..)), runs.first()) else {
        return Err(no_such(first, runs.len()));
    };
    if left.is_empty() {
        return Err(no_such(first, runs.len()));
    }
    for other in runs.iter().skip(1) {
        together(one, other)?;
    }
    let turn = |k: usize| if k == 0 { from.turn } else { None };
    let options: Vec<PostOptions> = left
        .iter()
        .enumerate()
        .map(|(k, r)| PostOptions { from_turn: turn(k), ..r.loaded.setup.post_options() })
        .collect();
    // What goes on within a path comes onto it on a lead of its own.
    let begun = match (left.first(), from.turn) {
        (Some(r), Some(turn)) => Some(leads::restart(&r.loaded.setup, &r.verified, turn)?),
        _ => None,
    };
    let operations: Vec<Operation> = left
        .iter()
        .zip(&options)
        .enumerate()
        .map(|(k, (r, options))| Operation {
            plan: begun.as_ref().filter(|_| k == 0).unwrap_or(&r.verified),
            tool: &r.loaded.setup.job.tool,
            options,
        })
        .collect();
    let (blade, machine) = (&one.loaded.setup.blade, &one.loaded.setup.machine);
    let program = post::join(dialect, &operations, first, blade, machine)?;
    let plans = operations.iter().map(|o| post::planned(o.plan.value(), o.options)).collect::<Result<Vec<_>>>()?;
    let made: Vec<_> =
        plans.iter().zip(&operations).map(|(plan, o)| verify::read_back::Operation { plan, tool: o.tool }).collect();
    let checks = verify::read_back::read_back_each(&program, &made, blade, machine)?;
    Ok((program, checks))
}

fn no_such(operation: usize, count: usize) -> Error {
    Error::usage(Stage::Post, format!("there is no operation {operation}, the program has operations 1 to {count}"))
}

/// Runs belong together: the same part, read alike, on the same machine.
fn together(a: &Done, b: &Done) -> Result<()> {
    let differ = |what: &str| {
        let message = format!("{} and {} cannot be one program: {what}", a.name, b.name);
        Err(Error::usage(Stage::Post, message)
            .advise("plan both from the same model, with the same axis and machine file"))
    };
    if !reuse::same_part(&a.loaded, &b.loaded) {
        return differ("they are of different models");
    }
    if a.loaded.setup.blade.model_from_blade != b.loaded.setup.blade.model_from_blade {
        return differ("their blade frames differ");
    }
    if a.loaded.setup.machine != b.loaded.setup.machine {
        return differ("their machines differ");
    }
    Ok(())
}
