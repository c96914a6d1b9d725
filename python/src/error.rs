//! Errors as exceptions of the class `BladewrightError`, which the Python half defines.

use std::any::Any;

use bladewright::error::Error;
use pyo3::prelude::*;

/// Exit code of a Rust program that panics.
const PANIC: u8 = 101;

/// An error as an exception: sentence, stage, kind, exit code, advice, data.
pub fn raised(py: Python<'_>, e: &Error) -> PyErr {
    let data = e.infeasible.as_ref().and_then(|d| serde_json::to_string(d).ok());
    let kind = format!("{:?}", e.kind);
    let what = (e.message.as_str(), e.stage.to_string(), kind, e.kind.exit_code(), e.advice.as_deref(), data);
    exception(py, what)
}

/// A panic as an exception: a fault of ours, which must not take the interpreter down.
pub fn fault(py: Python<'_>, panic: &(dyn Any + Send)) -> PyErr {
    let why = panic.downcast_ref::<&str>().map(|s| (*s).to_owned());
    let why = why.or_else(|| panic.downcast_ref::<String>().cloned()).unwrap_or_default();
    let said = format!("a fault of the program: {why}");
    let advice = Some("please report it, with the model");
    exception(py, (&said, "python".into(), "Fault".into(), PANIC, advice, None))
}

type What<'a> = (&'a str, String, String, u8, Option<&'a str>, Option<String>);

fn exception(py: Python<'_>, what: What<'_>) -> PyErr {
    let class = py.import("bladewright._errors").and_then(|m| m.getattr("BladewrightError"));
    match class.and_then(|c| c.call1(what)) {
        Ok(e) => PyErr::from_value(e),
        Err(e) => e,
    }
}
