//! Several finished runs of one part as one program: an operation each, in the order given.
//!
//! A run is an artifact: planned, checked and sealed by itself, with its own tool, path and stock.
//! A program of several operations is nothing but their programs one after another, each from its
//! tool call to the unwound axis; what is new are the moves between, and those are read back and
//! checked (`program-rapids`). A run on every blade of its wheel is as many operations.

use std::borrow::Cow;

use super::inputs::Loaded;
use super::reuse;
use crate::artifact::report::Check;
use crate::artifact::{Plan, Program};
use crate::error::{Error, Result, Stage};
use crate::plan::leads;
use crate::verify::{self, Verdict, Verified};
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

/// What a program of several operations consists of.
#[derive(Clone, Copy, Debug, Default)]
pub struct Extent {
    /// Where it begins.
    pub from: From,
    /// Each run on every blade of its wheel, one blade after another.
    pub every_blade: bool,
}

/// A run on a blade of its wheel.
struct Step<'a> {
    run: &'a Done,
    /// From 1, which is the blade that was planned.
    blade: u32,
    /// How many there are; 0: nobody asked.
    blades: u32,
}

/// All operations, in order.
fn steps(runs: &[Done], every_blade: bool) -> Result<Vec<Step<'_>>> {
    let mut out = Vec::new();
    for run in runs {
        let blades = if every_blade { run.loaded.setup.blades_in_turn()? } else { 0 };
        out.extend((1..=blades.max(1)).map(|blade| Step { run, blade, blades }));
    }
    Ok(out)
}

/// The program, and what reading it back found: every operation against its plan, and all moves
/// between. Where another blade of the wheel is not what the plan was made for, the findings of
/// that blade and no program.
///
/// # Errors
/// `Usage` where runs are not of the same part in the same frame on the same machine, or there is
/// no such operation; those of [`crate::plan::Setup::on_blade`], [`post::join`] and of
/// [`verify::read_back::read_back_each`].
pub fn join(runs: &[Done], dialect: &Dialect, extent: Extent) -> Result<(Option<Program>, Vec<Check>)> {
    let (from, steps) = (extent.from, steps(runs, extent.every_blade)?);
    let first = from.operation.unwrap_or(1);
    let left = first.checked_sub(1).and_then(|k| steps.get(k..)).filter(|left| !left.is_empty());
    let (Some(left), Some(one)) = (left, runs.first()) else { return Err(no_such(first, steps.len())) };
    for other in runs.iter().skip(1) {
        together(one, other)?;
    }
    let mut options = Vec::with_capacity(left.len());
    let mut verified = Vec::with_capacity(left.len());
    for (k, step) in left.iter().enumerate() {
        let setup = &step.run.loaded.setup;
        let from_turn = from.turn.filter(|_| k == 0);
        let blade = (step.blades > 0).then_some([step.blade, step.blades]);
        options.push(PostOptions { from_turn, blade, ..setup.post_options() });
        // What goes on within a path comes onto it on a lead of its own.
        let begun = from_turn.map(|turn| leads::restart(setup, &step.run.verified, turn)).transpose()?;
        let own = begun.map_or(Cow::Borrowed(&step.run.verified), Cow::Owned);
        if step.blade == 1 {
            verified.push(own);
            continue;
        }
        match setup.on_blade(&own, step.blade)? {
            Verdict::Passed(plan) => verified.push(Cow::Owned(plan)),
            Verdict::Failed(found) => {
                let bad = found.report().checks.iter().filter(|c| !c.passed);
                let told = |c: &Check| Check { note: format!("blade {}; {}", step.blade, c.note), ..c.clone() };
                return Ok((None, bad.map(told).collect()));
            }
        }
    }
    let tool = |k: usize| &left[k].run.loaded.setup.job.tool;
    let operations: Vec<Operation> =
        (0..left.len()).map(|k| Operation { plan: &verified[k], tool: tool(k), options: &options[k] }).collect();
    let (part, machine) = (one.loaded.setup.part_among(), &one.loaded.setup.machine);
    let program = post::join(dialect, &operations, first, part, machine)?;
    let plans = operations.iter().map(|o| post::planned(o.plan.value(), o.options)).collect::<Result<Vec<_>>>()?;
    let made: Vec<_> =
        plans.iter().zip(&operations).map(|(plan, o)| verify::read_back::Operation { plan, tool: o.tool }).collect();
    let checks = verify::read_back::read_back_each(&program, &made, part, machine)?;
    Ok((Some(program), checks))
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
