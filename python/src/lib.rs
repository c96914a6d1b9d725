//! The native half of the Python package `bladewright`: what `bladewright/__init__.py` calls.
//!
//! Arrays leave as bytes of native numbers and structures as JSON. The Python half makes NumPy
//! arrays and dictionaries of them, so nothing here depends on a version of NumPy.

mod call;
mod error;
mod planned;
mod settings;

use std::path::PathBuf;

use bladewright::job::Draft;
use bladewright::read::model::{self, ModelOptions};
use bladewright::run::{self, Course, RunFolder, again, inputs};
use pyo3::prelude::*;
use pyo3::types::PyDict;

use planned::Planned;

/// Plans a model or a job file, into a folder where one is given.
#[pyfunction]
#[pyo3(signature = (model, settings, out, force, progress, threads))]
fn plan(
    py: Python<'_>,
    model: PathBuf,
    settings: Option<&Bound<'_, PyDict>>,
    out: Option<PathBuf>,
    force: bool,
    progress: Option<&Bound<'_, PyAny>>,
    threads: Option<usize>,
) -> PyResult<Planned> {
    let (mut job, base) = inputs::typed(&model).map_err(|e| error::raised(py, &e))?;
    if let Some(settings) = settings {
        settings::apply(&mut job, settings)?;
    }
    let outcome = call::run(py, threads, progress, |observer| {
        let draft: Draft = inputs::draft(job, base)?;
        match &out {
            Some(out) => run::run(&draft, out, Course { force, ..Course::default() }, observer),
            None => run::in_memory(&draft, force, observer),
        }
    })?;
    Ok(Planned::new(outcome))
}

/// Checks a finished run again and writes its `verify.json`; the same as JSON.
#[pyfunction]
#[pyo3(signature = (run, progress, threads))]
fn verify(
    py: Python<'_>,
    run: PathBuf,
    progress: Option<&Bound<'_, PyAny>>,
    threads: Option<usize>,
) -> PyResult<String> {
    call::run(py, threads, progress, |observer| {
        let checked = again::read(&run, observer)?.check(observer)?;
        let mut folder = RunFolder::begin(&run)?;
        let report = checked.report(&folder)?;
        folder.add_json("verify.json", &report)?;
        folder.finish()?;
        run::json(&report)
    })
}

/// What is in a model: as JSON, and in words.
#[pyfunction]
#[pyo3(signature = (model, progress, threads))]
fn inspect(
    py: Python<'_>,
    model: PathBuf,
    progress: Option<&Bound<'_, PyAny>>,
    threads: Option<usize>,
) -> PyResult<(String, String)> {
    call::run(py, threads, progress, |observer| {
        let survey = model::survey(&model, &ModelOptions::default(), observer)?;
        Ok((run::json(&model::inspect_json(&survey))?, model::inspect_text(&survey)))
    })
}

/// Name and version of the library.
#[pyfunction]
fn program() -> String {
    run::program()
}

#[pymodule]
fn _native(module: &Bound<'_, PyModule>) -> PyResult<()> {
    module.add_class::<Planned>()?;
    module.add_function(wrap_pyfunction!(plan, module)?)?;
    module.add_function(wrap_pyfunction!(verify, module)?)?;
    module.add_function(wrap_pyfunction!(inspect, module)?)?;
    module.add_function(wrap_pyfunction!(program, module)?)
}
