//! The command line: typed arguments in [`args`], one function per verb, exit codes from
//! [`crate::error::ErrorKind`].
#![allow(clippy::print_stdout, clippy::print_stderr)]

mod again;
mod args;
mod audit;
mod batch;
mod channel;
mod compare;
mod fit;
mod help;
mod inspect;
mod make;
mod out;
mod pinch;
mod pinch_audit;
mod plan;
mod progress;
mod reschedule;
mod signals;
mod theirs;
mod words;

use std::process::ExitCode;

use clap::Parser;

use crate::error::{Error, Result, Stage};
use args::{Args, Verb};

/// Runs the command given by the process' arguments.
pub fn run() -> ExitCode {
    let args = match Args::try_parse() {
        Ok(args) => args,
        Err(e) => {
            // Help and version are good ends; everything else is usage.
            let code = u8::from(e.use_stderr()) * 2;
            // What was typed is quoted in it, perhaps by a script from the names of files.
            match std::env::args_os().any(|a| a.to_string_lossy().chars().any(char::is_control)) {
                true => e.render().to_string().lines().for_each(out::told),
                false => e.print().unwrap_or_default(),
            }
            return ExitCode::from(code);
        }
    };
    out::json_lines(args.json);
    let quiet = args.quiet;
    let ended = match threads(args.threads) {
        Err(e) => Err(e),
        Ok(pool) => pool.install(|| dispatch(args.verb, quiet)),
    };
    let code = ended.unwrap_or_else(|e| {
        report(&e);
        e.kind.exit_code()
    });
    out::event(&serde_json::json!({ "event": "end", "exit_code": code }));
    match out::end() {
        Ok(()) => ExitCode::from(code),
        Err(e) => {
            report(&e);
            ExitCode::from(e.kind.exit_code())
        }
    }
}

fn dispatch(verb: Verb, quiet: bool) -> Result<u8> {
    match verb {
        Verb::Inspect(a) => inspect::run(&a, quiet),
        Verb::Make(a) => make::run(&a, quiet),
        Verb::Plan(a) => plan::run(&a, quiet),
        Verb::Compare(a) => compare::run(&a, quiet),
        Verb::Batch(a) => batch::run(&a, quiet),
        Verb::Channel(a) => channel::run(&a, quiet),
        Verb::Advise(a) => channel::advise(&a, quiet),
        Verb::Pinch(a) => pinch::run(&a, quiet),
        Verb::Verify(a) => audit::run(&a, quiet),
        Verb::Reschedule(a) => reschedule::run(&a, quiet),
        Verb::Post(a) => again::post(&a, quiet),
        Verb::Preview(a) => again::preview(&a, quiet),
        Verb::Plot(a) => again::plot(&a, quiet),
        Verb::Completions(a) => help::completions(&a),
        Verb::Man(a) => help::man(&a),
    }
}

fn threads(count: Option<usize>) -> Result<rayon::ThreadPool> {
    if count == Some(0) {
        return Err(Error::usage(Stage::Job, "--threads is 0, it must be at least 1"));
    }
    rayon::ThreadPoolBuilder::new()
        .num_threads(count.unwrap_or(0))
        .build()
        .map_err(|e| Error::usage(Stage::Job, format!("the threads asked for cannot be started: {e}")))
}

/// One line for the error, one for what to do.
fn report(e: &Error) {
    let told = serde_json::json!({
        "event": "error", "stage": e.stage, "kind": format!("{:?}", e.kind), "message": e.message, "advice": e.advice,
        "infeasible": e.infeasible,
    });
    if out::event(&told) {
        return;
    }
    out::told(&format!("error: {}: {}", e.stage, e.message));
    if let Some(advice) = &e.advice {
        out::told(&format!("       {advice}"));
    }
}
