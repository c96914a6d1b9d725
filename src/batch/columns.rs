//! Records as columns: one cell for each member.

use std::collections::BTreeMap;

use serde_json::Value;

use super::record::Record;

/// One value.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum TableCell {
    Empty,
    Integer(i64),
    Number(f64),
    Truth(bool),
    Text(String),
}

/// One column; all cells but the empty ones are of one kind.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Column {
    pub name: String,
    pub cells: Vec<TableCell>,
}

/// Columns of a family: what each member is, how it ended, its parameters, all figures of its
/// summary.
pub(super) fn columns(records: &[Record]) -> Vec<Column> {
    let text = |s: &str| if s.is_empty() { TableCell::Empty } else { TableCell::Text(s.to_owned()) };
    let some = |s: &Option<String>| s.as_deref().map_or(TableCell::Empty, text);
    let fixed = |name: &str, cell: &dyn Fn(&Record) -> TableCell| Column {
        name: name.to_owned(),
        cells: records.iter().map(cell).collect(),
    };
    let mut all = vec![
        fixed("name", &|r| text(&r.name)),
        fixed("status", &|r| text(r.status.word())),
        fixed("exit_code", &|r| TableCell::Integer(i64::from(r.exit_code))),
        fixed("stage", &|r| r.stage.map_or(TableCell::Empty, |s| text(&s.to_string()))),
        fixed("reason", &|r| some(&r.reason)),
        fixed("advice", &|r| some(&r.advice)),
        fixed("model", &|r| text(&r.model)),
        fixed("warnings", &|r| TableCell::Integer(i64::try_from(r.warnings).unwrap_or(i64::MAX))),
        fixed("key", &|r| text(&r.key)),
    ];
    let parameters = records.iter().map(|r| r.parameters.iter().map(|(k, v)| (k.clone(), cell(v))).collect());
    all.extend(gather(records.len(), parameters));
    let figures = records.iter().map(|r| {
        let mut flat = BTreeMap::new();
        if let Some(summary) = &r.summary {
            flatten("", summary, &mut flat);
        }
        flat
    });
    all.extend(gather(records.len(), figures));
    all
}

/// Maps of cells by name as columns, by name.
fn gather(rows: usize, maps: impl Iterator<Item = BTreeMap<String, TableCell>>) -> Vec<Column> {
    let mut found: BTreeMap<String, Vec<TableCell>> = BTreeMap::new();
    for (row, map) in maps.enumerate() {
        for (name, value) in map {
            let cells = found.entry(name).or_insert_with(|| vec![TableCell::Empty; rows]);
            if let Some(place) = cells.get_mut(row) {
                *place = value;
            }
        }
    }
    found.into_iter().map(|(name, cells)| Column { name, cells: of_one_kind(cells) }).collect()
}

fn cell(value: &Value) -> TableCell {
    match value {
        Value::Null => TableCell::Empty,
        Value::Bool(b) => TableCell::Truth(*b),
        Value::Number(n) => {
            n.as_i64().map_or_else(|| n.as_f64().map_or(TableCell::Empty, TableCell::Number), TableCell::Integer)
        }
        Value::String(s) => TableCell::Text(s.clone()),
        other => TableCell::Text(other.to_string()),
    }
}

/// Names of nested values are joined by dots. Entries of a list are called by their `axis`, a
/// schedule that was not used by its `kind`, the others by their number.
fn flatten(path: &str, value: &Value, flat: &mut BTreeMap<String, TableCell>) {
    let below = |part: &str| if path.is_empty() { part.to_owned() } else { format!("{path}.{part}") };
    match value {
        // The member's own name stands in front, and what calls an entry need not stand in it
        // again.
        Value::Object(map) => {
            let told = |key: &str| key == "axis" || (key == "name" && path.is_empty());
            map.iter().filter(|(key, _)| !told(key)).for_each(|(key, v)| flatten(&below(key), v, flat));
        }
        Value::Array(list) => {
            for (k, v) in list.iter().enumerate() {
                let word = |key: &str| v.get(key).and_then(Value::as_str);
                let own = match (path, k) {
                    ("schedules", 0) => Some("used"),
                    ("schedules" | "other_paths", _) => word("kind"),
                    _ => word("axis"),
                };
                flatten(&below(own.unwrap_or(&k.to_string())), v, flat);
            }
        }
        _ => {
            flat.insert(path.to_owned(), cell(value));
        }
    }
}

/// Integers beside fractions become numbers, anything beside texts becomes text.
fn of_one_kind(cells: Vec<TableCell>) -> Vec<TableCell> {
    let has = |f: fn(&TableCell) -> bool| cells.iter().any(f);
    let (texts, truths) = (has(|c| matches!(c, TableCell::Text(_))), has(|c| matches!(c, TableCell::Truth(_))));
    let numbers = has(|c| matches!(c, TableCell::Integer(_) | TableCell::Number(_)));
    let fractions = has(|c| matches!(c, TableCell::Number(_)));
    let mixed = texts || (truths && numbers);
    let turn = |c: TableCell| match c {
        TableCell::Empty | TableCell::Text(_) => c,
        c if mixed => TableCell::Text(c.to_string()),
        TableCell::Integer(i) if fractions => TableCell::Number(i as f64),
        c => c,
    };
    cells.into_iter().map(turn).collect()
}

impl std::fmt::Display for TableCell {
    /// As in the CSV table: numbers with as many digits as bring them back.
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            TableCell::Empty => Ok(()),
            TableCell::Integer(i) => write!(f, "{i}"),
            TableCell::Number(x) => write!(f, "{x}"),
            TableCell::Truth(b) => write!(f, "{b}"),
            TableCell::Text(s) => f.write_str(s),
        }
    }
}
