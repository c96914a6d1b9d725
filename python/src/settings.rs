//! Keys of a job file from a Python dictionary.

use bladewright::error::{Error, Stage};
use bladewright::job::JobFile;
use pyo3::prelude::*;
use pyo3::types::{PyBool, PyDict, PyFloat, PyInt, PyString};

use super::error::raised;

/// Sets keys such as `tool.radius_mm`; a dictionary in a dictionary names the keys below a section.
pub fn apply(job: &mut JobFile, settings: &Bound<'_, PyDict>) -> PyResult<()> {
    below(job, &[], settings)
}

fn below(job: &mut JobFile, above: &[String], settings: &Bound<'_, PyDict>) -> PyResult<()> {
    let py = settings.py();
    for (key, value) in settings {
        let key: String = key.extract()?;
        let parts = above.iter().cloned().chain(key.split('.').map(|k| k.trim().to_owned()));
        let parts: Vec<String> = parts.collect();
        if let Ok(inner) = value.cast::<PyDict>() {
            below(job, &parts, inner)?;
            continue;
        }
        let name = parts.join(".");
        let bad = |why: String| raised(py, &Error::usage(Stage::Job, format!("{name}: {why}")));
        if parts.len() < 2 || parts.iter().any(String::is_empty) {
            return Err(bad("the key is a section and a name, as path.scallop_mm".into()));
        }
        let value = toml_of(&value)?.ok_or_else(|| {
            let kind = value.get_type().name().map_or_else(|_| "this".to_owned(), |n| n.to_string());
            bad(format!("{kind} is no value of a job file: numbers, texts, lists and dictionaries are"))
        })?;
        let keys: Vec<&str> = parts.iter().map(String::as_str).collect();
        job.set_value(&keys, value).map_err(|fault| bad(fault.words))?;
    }
    Ok(())
}

/// A value as TOML; `None` where TOML has no such value.
fn toml_of(value: &Bound<'_, PyAny>) -> PyResult<Option<toml::Value>> {
    // A truth value is an integer to Python, so it comes first.
    if let Ok(b) = value.cast::<PyBool>() {
        return Ok(Some(toml::Value::Boolean(b.is_true())));
    }
    if value.is_instance_of::<PyInt>() {
        return Ok(Some(toml::Value::Integer(value.extract()?)));
    }
    if value.is_instance_of::<PyFloat>() {
        return Ok(Some(toml::Value::Float(value.extract()?)));
    }
    if value.is_instance_of::<PyString>() {
        return Ok(Some(toml::Value::String(value.extract()?)));
    }
    if let Ok(dict) = value.cast::<PyDict>() {
        let mut table = toml::Table::new();
        for (key, value) in dict {
            let Some(value) = toml_of(&value)? else { return Ok(None) };
            table.insert(key.extract()?, value);
        }
        return Ok(Some(toml::Value::Table(table)));
    }
    if value.hasattr("__fspath__")? {
        return Ok(Some(toml::Value::String(value.call_method0("__fspath__")?.extract()?)));
    }
    // NumPy's arrays and numbers give Python's own.
    if value.hasattr("tolist")? {
        return toml_of(&value.call_method0("tolist")?);
    }
    let Ok(items) = value.try_iter() else { return Ok(None) };
    let mut list = Vec::new();
    for item in items {
        let Some(item) = toml_of(&item?)? else { return Ok(None) };
        list.push(item);
    }
    Ok(Some(toml::Value::Array(list)))
}
