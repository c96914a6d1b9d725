//! Models by patterns.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

use crate::error::{Error, Result, Stage};

/// What the system says of links that lead in a circle (ELOOP).
const TOO_MANY_LINKS: i32 = if cfg!(target_os = "linux") { 40 } else { 62 };

fn usage(message: String) -> Error {
    Error::usage(Stage::Batch, message)
}

/// Name and absolute path of every model, by path. A file is called by its name without the ending.
///
/// # Errors
/// `Usage`: a pattern that is none or matches no file, links that lead in a circle.
pub(super) fn find(patterns: &[String], base: &Path) -> Result<Vec<(String, PathBuf)>> {
    let base = std::path::absolute(base).unwrap_or_else(|_| base.to_path_buf());
    // By its true place: one file that is met twice, by two patterns, is one member.
    let mut found: BTreeMap<PathBuf, PathBuf> = BTreeMap::new();
    for text in patterns {
        let mut hits = 0;
        for path in matches(text, &base)? {
            let (true_path, is_file) = resolve(&path)?;
            if !is_file {
                continue;
            }
            hits += 1;
            if let Some(other) = found.get(&true_path).filter(|p| **p != path) {
                if [other, &path].iter().any(|p| leads_back(p)) {
                    return Err(usage(format!(
                        "models: {} is {} again: a linked folder leads back, the path is cyclic",
                        path.display(),
                        other.display()
                    )));
                }
                continue;
            }
            found.insert(true_path, path);
        }
        if hits == 0 {
            return Err(
                usage(format!("models: no file matches {text}")).advise("patterns start at the family file's folder")
            );
        }
    }
    let mut all: Vec<PathBuf> = found.into_values().collect();
    all.sort();
    Ok(all.into_iter().map(|p| (name_of(&p), p)).collect())
}

/// A folder on the way is a link to one of the folders above it.
fn leads_back(path: &Path) -> bool {
    path.ancestors().skip(1).any(|folder| {
        folder.is_symlink()
            && std::fs::canonicalize(folder).is_ok_and(|to| {
                folder.parent().and_then(|p| std::fs::canonicalize(p).ok()).is_some_and(|p| p.starts_with(to))
            })
    })
}

fn matches(text: &str, base: &Path) -> Result<Vec<PathBuf>> {
    let pattern = if Path::new(text).is_absolute() {
        text.to_owned()
    } else {
        format!("{}/{text}", glob::Pattern::escape(&base.to_string_lossy()))
    };
    let paths = glob::glob(&pattern).map_err(|e| usage(format!("models: `{text}` is no pattern of files: {e}")))?;
    paths
        .map(|p| {
            p.map_err(|e| {
                Error::io(Stage::Batch, format!("models: {} cannot be read: {}", e.path().display(), e.error()))
            })
        })
        .collect()
}

/// True place of a file, and whether it is one.
fn resolve(path: &Path) -> Result<(PathBuf, bool)> {
    let found = std::fs::canonicalize(path).and_then(|p| std::fs::metadata(&p).map(|m| (p, m.is_file())));
    found.map_err(|e| {
        let kind = if e.raw_os_error() == Some(TOO_MANY_LINKS) { ": the path is cyclic" } else { "" };
        usage(format!("models: {} leads nowhere{kind} ({e})", path.display())).caused_by(e)
    })
}

/// The file's name without its ending, with what no folder may be called replaced.
pub(super) fn name_of(path: &Path) -> String {
    let stem = path.file_stem().map(|s| s.to_string_lossy().into_owned()).unwrap_or_default();
    let clean: String =
        stem.chars().map(|c| if c.is_alphanumeric() || "-_.+=,".contains(c) { c } else { '_' }).collect();
    if clean.starts_with(['.', '-']) { format!("_{clean}") } else { clean }
}
