//! Members by rows of a CSV file.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

use super::member::{self, BladeSource, Member};
use crate::error::{Error, Result, Stage};
use crate::files;
use crate::job::{self, JobFile};
use crate::read::model::format::without_mark;

/// A table as read.
pub(super) struct MemberTable {
    path: PathBuf,
    header: Vec<String>,
    /// Line and cells of each row.
    rows: Vec<(u64, Vec<String>)>,
}

/// Most bytes of a table of members.
const MAX_BYTES: u64 = 256 << 20;

fn usage(message: String) -> Error {
    Error::usage(Stage::Batch, message)
}

/// Reads a table: a header, then rows; `#` starts a comment line.
pub(super) fn read(path: &Path) -> Result<MemberTable> {
    let shown = path.display();
    let bytes = files::read(path, MAX_BYTES)
        .map_err(|e| Error::io(Stage::Batch, format!("the table {shown} cannot be read: {e}")).caused_by(e))?;
    // Spreadsheets put a mark before UTF-8.
    let bytes = without_mark(&bytes);
    let mut reader = csv::ReaderBuilder::new()
        .has_headers(false)
        .flexible(true)
        .comment(Some(b'#'))
        .trim(csv::Trim::All)
        .from_reader(bytes);
    let mut lines = Vec::new();
    for record in reader.records() {
        let record = record.map_err(|e| usage(format!("the table {shown} is not CSV in UTF-8: {e}")))?;
        let line = record.position().map_or(0, csv::Position::line);
        lines.push((line, record.iter().map(str::to_owned).collect::<Vec<String>>()));
    }
    let mut lines = lines.into_iter();
    let (_, header) = lines.next().ok_or_else(|| usage(format!("the table {shown} is empty")))?;
    let rows: Vec<_> = lines.collect();
    for (k, column) in header.iter().enumerate() {
        if column.is_empty() || header[..k].contains(column) {
            let what = if column.is_empty() { "has no name".into() } else { format!("`{column}` comes twice") };
            return Err(usage(format!("the table {shown}: column {} {what}", k + 1)));
        }
    }
    if !header.iter().any(|c| c == "name") {
        return Err(
            usage(format!("the table {shown} has no column `name`")).advise("its columns must be parted by commas")
        );
    }
    for (line, cells) in &rows {
        if cells.len() != header.len() {
            let (n, m) = (cells.len(), header.len());
            return Err(usage(format!("the table {shown}, line {line}: {n} cells, but the header has {m} columns")));
        }
    }
    if rows.is_empty() {
        return Err(usage(format!("the table {shown} has no rows")));
    }
    Ok(MemberTable { path: path.to_path_buf(), header, rows })
}

impl MemberTable {
    /// A member for every row; `default` is its blade where no column `model` names one.
    pub(super) fn members(&self, default: Option<BladeSource>, job: &JobFile) -> Result<Vec<Member>> {
        let shown = self.path.display();
        let folder = self.path.parent().unwrap_or(Path::new("."));
        let folder = std::path::absolute(folder).unwrap_or_else(|_| folder.to_path_buf());
        if default.is_none() && !self.header.iter().any(|c| c == "model") {
            return Err(usage(format!("the table {shown} has no column `model`, and the family names no design"))
                .advise("add the column, or give design or model.file in the template job"));
        }
        let mut all = Vec::new();
        for (line, cells) in &self.rows {
            let at = |what: String| usage(format!("the table {shown}, line {line}: {what}"));
            let cell = |name: &str| self.header.iter().position(|c| c == name).and_then(|k| cells.get(k));
            let name = cell("name").filter(|n| !n.is_empty()).ok_or_else(|| at("the name is missing".into()))?;
            let source = match cell("model").filter(|m| !m.is_empty()) {
                Some(model) => BladeSource::Model(folder.join(model)),
                None => default.clone().ok_or_else(|| at("the model is missing".into()))?,
            };
            let mut member = Member {
                name: name.clone(),
                source,
                blade: name.clone(),
                job: job.clone(),
                parameters: BTreeMap::new(),
            };
            for (key, text) in self.header.iter().zip(cells) {
                if !["name", "model"].contains(&key.as_str()) && !text.is_empty() {
                    member::set(&mut member, key, &job::read_value(text)).map_err(|e| at(e.message))?;
                }
            }
            all.push(member);
        }
        Ok(all)
    }
}
