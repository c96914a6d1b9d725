//! Reading the text of a job file, and changing single keys (`--set`).

use std::path::Path;

use super::sections::ModelKeys;
use super::typed::JobFile;
use crate::error::{Error, Result, Stage};
use crate::settings::{Mismatch, TomlError, from_toml, from_value, to_value};

/// Parses the text of a job file; `name` is used in messages.
///
/// # Errors
/// `Usage` with name, line and what is allowed.
pub fn parse(text: &str, name: &str) -> Result<JobFile> {
    from_toml(text).map_err(|e| {
        let place = e.line.map(|l| format!("{name}, line {l}")).unwrap_or_else(|| name.to_string());
        let shown = e.line.and_then(|l| text.lines().nth(l - 1)).map(str::trim).filter(|l| !l.is_empty());
        let shown = shown.map(|l| format!(" at `{l}`")).unwrap_or_default();
        Error::usage(Stage::Job, format!("{place}{shown}: {}", e.words))
            .advise("models/job.schema.json lists every key; job.resolved.toml of any run is a complete example")
    })
}

impl JobFile {
    /// A job for one model, defaults for the rest.
    pub fn from_model(path: &Path) -> Self {
        let model = ModelKeys { file: Some(path.to_string_lossy().into_owned()), ..Default::default() };
        JobFile { model: Some(model), ..Default::default() }
    }

    /// Sets one key, as `path.scallop_mm=0.02`. The value is TOML; what is not TOML is taken as a
    /// text, so that names need no quotes. Entries of a list are named by number:
    /// `tool.holder.0.radius_mm=20`.
    ///
    /// # Errors
    /// `Usage` naming the key and what is allowed; the job is then unchanged.
    pub fn set(&mut self, assignment: &str) -> Result<()> {
        let bad = |m: String| Error::usage(Stage::Job, format!("--set {assignment}: {m}"));
        let (key, value) =
            assignment.split_once('=').ok_or_else(|| bad("a key and a value are needed, as key=value".into()))?;
        let keys: Vec<&str> = key.trim().split('.').map(str::trim).collect();
        if keys.len() < 2 || keys.iter().any(|k| k.is_empty()) {
            return Err(bad("the key is a section and a name, as path.scallop_mm".into()));
        }
        let (text, value) = (value.trim(), read_value(value.trim()));
        let hint = |mismatch: Option<Mismatch>| match (mismatch?, &value) {
            (_, toml::Value::Table(_)) => None,
            (Mismatch::TableForList, _) => list_hint(&keys, text),
            (Mismatch::TextForNumber, _) => Some(number_hint(text)),
        };
        self.set_value(&keys, value.clone()).map_err(|fault| bad(hint(fault.mismatch).unwrap_or(fault.words)))
    }

    /// Sets one key, given as the list of its parts, to a TOML value.
    ///
    /// # Errors
    /// What is wrong, without the key; the job is then unchanged.
    pub fn set_value(&mut self, keys: &[&str], value: toml::Value) -> std::result::Result<(), TomlError> {
        let mut root = to_value(self)?;
        insert(&mut root, keys, value)?;
        *self = from_value(&root)?;
        Ok(())
    }
}

/// What to type where an entry of a list is set without its number.
fn list_hint(keys: &[&str], text: &str) -> Option<String> {
    let (last, list) = keys.split_last()?;
    let list = list.join(".");
    Some(format!("{list} is a list: name its first entry by 0, as in --set {list}.0.{last}={text}"))
}

/// What is wrong with a text where a number is wanted.
fn number_hint(text: &str) -> String {
    let point = text.replacen(',', ".", 1);
    let bare = text.trim_end_matches(|c: char| c.is_alphabetic() || "°%²³/ ".contains(c));
    let digit_before_point = bare.replacen('.', "0.", 1);
    let lacks_digit = bare.trim_start_matches(['-', '+']).starts_with('.') && bare.parse::<f64>().is_ok();
    let hint = if lacks_digit && bare == text {
        format!(": write {digit_before_point}, with a digit before the point")
    } else if text.contains(',') && point.parse::<f64>().is_ok() {
        format!(": write {point}, with a point")
    } else if !bare.is_empty() && bare.parse::<f64>().is_ok() {
        format!(": write {bare}, the unit is the key's")
    } else {
        String::new()
    };
    format!("`{text}` is not a number{hint}")
}

/// The text as a TOML value, or as a plain text where it is none.
pub fn read_value(text: &str) -> toml::Value {
    let table = toml::from_str::<toml::Table>(&format!("v = {text}"));
    match table.ok().and_then(|mut t| if t.len() == 1 { t.remove("v") } else { None }) {
        Some(value) => value,
        None => toml::Value::String(text.to_string()),
    }
}

/// Puts `value` at the path `keys`, making tables on the way; entries of a list are named by
/// number.
///
/// # Errors
/// In words: which part of the path cannot be followed.
pub fn insert(at: &mut toml::Value, keys: &[&str], value: toml::Value) -> std::result::Result<(), String> {
    let Some((first, rest)) = keys.split_first() else {
        *at = value;
        return Ok(());
    };
    match at {
        toml::Value::Table(table) => {
            let empty = toml::Value::Table(Default::default());
            // A list that is not there yet begins with the entry that is named.
            let empty = if rest.first() == Some(&"0") { toml::Value::Array(vec![empty]) } else { empty };
            let entry = table.entry(first.to_string()).or_insert(empty);
            insert(entry, rest, value)
        }
        toml::Value::Array(list) => {
            let n = list.len();
            let entry = first.parse::<usize>().ok().and_then(|i| list.get_mut(i));
            insert(entry.ok_or_else(|| format!("the list has {n} entries, `{first}` is none of them"))?, rest, value)
        }
        _ => Err(format!("`{first}` cannot be set, what is above it is a single value")),
    }
}
