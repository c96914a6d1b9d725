//! The header of a section table: what its columns mean, as TOML beside the data or at its top.
//!
//! ```toml
//! [sections]
//! files = "section*.csv"             # beside this file; several, in the order of the numbers in their names
//! unit = "inch"                      # mm, cm, m, inch; or unit_mm = 152.0, for tables in shares of a radius
//! columns = ["x", "r*theta", "r"]    # x y z | r theta z | x r*theta r | y1 y2: one for each side | skip
//! ```

use std::path::{Path, PathBuf};

use crate::artifact::blade::Unit;
use crate::error::{Error, Result, Stage};
use crate::files;
use crate::settings::from_toml;

/// What a job or design file never has at its top.
#[derive(Debug, serde::Deserialize)]
#[serde(deny_unknown_fields)]
struct HeaderFile {
    sections: Header,
}

/// The header `[sections]`.
#[derive(Clone, Debug, Default, serde::Deserialize)]
#[serde(deny_unknown_fields, default)]
pub struct Header {
    /// Files with the points, beside the header; `*` and `?` in names; natural order within each
    /// pattern.
    pub files: Names,
    /// Unit of lengths.
    pub unit: Option<Unit>,
    /// Millimetres in one unit of the file, for tables in shares of a radius or chord.
    pub unit_mm: Option<f64>,
    /// Meaning of the columns; none: a format that says it itself (Tecplot, TurboGrid, T-Blade3).
    pub columns: Vec<String>,
    /// Unit of angles.
    pub angle: Angle,
    /// Whether a block is a closed loop or one side; none: found from the points.
    pub order: Option<Order>,
    /// What parts the blocks of a file.
    pub blocks: Blocks,
    /// Rows of each block, where nothing else parts them.
    pub points_per_block: Option<usize>,
    /// Lines to pass over at the top of each file.
    pub skip_lines: usize,
    /// `1,5` is one number; columns are then parted by white space or semicolons.
    pub decimal_comma: bool,
    /// Titles of the Tecplot zones to take; none: all.
    pub zones: Vec<String>,
    /// The coordinate that the columns lack, one for each section, in the file's unit.
    pub heights: Vec<f64>,
    /// Length to which a single flat profile is drawn out, in the file's unit.
    pub extrude: Option<f64>,
    /// Greatest distance of a point from the surface, mm.
    pub tolerance_mm: Option<f64>,
}

/// One name or several.
#[derive(Clone, Debug, serde::Deserialize)]
#[serde(untagged, expecting = "a text is wanted, or a list of texts")]
pub enum Names {
    /// One.
    One(String),
    /// Several.
    Several(Vec<String>),
}

impl Default for Names {
    fn default() -> Self {
        Names::Several(Vec::new())
    }
}

/// Unit of angles.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, serde::Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Angle {
    /// Radians.
    #[default]
    Rad,
    /// Degrees.
    Deg,
}

/// What one block of points is.
#[derive(Clone, Copy, Debug, PartialEq, Eq, serde::Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Order {
    /// Once round the section.
    Loop,
    /// One side, edge to edge; two blocks are a section.
    Sides,
}

/// What parts the blocks of a file.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, serde::Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Blocks {
    /// Blank lines and lines that are no numbers.
    #[default]
    Any,
    /// Blank lines.
    BlankLine,
    /// Lines that are no numbers, or counts (whole numbers, fewer than columns).
    TextLine,
    /// Nothing: each file is one block.
    File,
}

/// Whether a TOML text is the header of a section table, rather than a job file.
pub fn is_header(text: &str) -> bool {
    toml::from_str::<toml::Table>(text).is_ok_and(|t| t.contains_key("sections"))
}

/// Parses a header; `name` is for messages.
///
/// # Errors
/// `InputOutput`: not TOML, unknown keys, values that make no sense.
pub fn parse(text: &str, name: &str) -> Result<Header> {
    let bad = |m: String| {
        Error::io(Stage::Model, format!("{name}: {m}")).advise("the README shows headers of section tables")
    };
    let file: HeaderFile = from_toml(text).map_err(|e| {
        let place = e.line.map(|l| format!("line {l}: ")).unwrap_or_default();
        bad(format!("{place}{}", e.words))
    })?;
    let h = file.sections;
    let positive = |key: &str, x: Option<f64>| match x {
        Some(x) if !(x > 0.0 && x.is_finite()) => Err(bad(format!("{key} = {x} is not greater than 0"))),
        _ => Ok(()),
    };
    positive("unit_mm", h.unit_mm)?;
    positive("extrude", h.extrude)?;
    positive("tolerance_mm", h.tolerance_mm)?;
    if h.unit.is_some() && h.unit_mm.is_some() {
        return Err(bad("unit and unit_mm are two answers to one question: give one".into()));
    }
    if h.points_per_block == Some(0) {
        return Err(bad("points_per_block = 0".into()));
    }
    if h.heights.iter().any(|x| !x.is_finite()) {
        return Err(bad("heights has a value that is not a number".into()));
    }
    if h.extrude.is_some() && !h.heights.is_empty() {
        return Err(bad("extrude draws out one profile, heights places several: give one of them".into()));
    }
    Ok(h)
}

/// A data file with its header at the top, between two lines `+++`: header text, and the data.
pub fn front_matter(text: &str) -> Option<(&str, &str)> {
    let rest = text.strip_prefix("+++")?;
    let (first, rest) = rest.split_once('\n')?;
    let end = rest.find("\n+++")?;
    let data = rest[end + 4..].split_once('\n').map_or("", |(_, d)| d);
    first.trim().is_empty().then(|| (&rest[..end + 1], data))
}

/// The data files that a header names, in order.
///
/// # Errors
/// `InputOutput`: none named, none found.
pub fn files(header: &Path, names: &Names) -> Result<Vec<PathBuf>> {
    let folder = header.parent().unwrap_or(Path::new("."));
    let patterns: &[String] = match names {
        Names::One(name) => std::slice::from_ref(name),
        Names::Several(names) => names,
    };
    if patterns.is_empty() {
        return Err(Error::io(Stage::Model, format!("{} names no files", header.display()))
            .advise("add files = \"NAME\", or a list; names may hold * and ?"));
    }
    let mut all = Vec::new();
    for pattern in patterns {
        all.extend(matching(folder, pattern).map_err(|m| {
            Error::io(Stage::Model, format!("{}: {m}", header.display()))
                .advise("names are taken from the header's folder")
        })?);
    }
    Ok(all)
}

fn matching(folder: &Path, pattern: &str) -> std::result::Result<Vec<PathBuf>, String> {
    if !files::stays_below(Path::new(pattern)) {
        return Err(format!("the file {pattern} is not in the header's folder"));
    }
    let path = folder.join(pattern);
    if !pattern.contains(['*', '?']) {
        return if path.exists() { Ok(vec![path]) } else { Err(format!("the file {} is not there", path.display())) };
    }
    let (dir, name) = (path.parent().unwrap_or(folder), path.file_name().map(|n| n.to_string_lossy().into_owned()));
    let name = name.unwrap_or_default();
    let listing = std::fs::read_dir(dir).map_err(|e| format!("{} cannot be listed: {e}", dir.display()))?;
    let mut found: Vec<String> = listing
        .filter_map(|entry| entry.ok()?.file_name().into_string().ok())
        .filter(|n| glob(&name.chars().collect::<Vec<_>>(), &n.chars().collect::<Vec<_>>()))
        .collect();
    if found.is_empty() {
        return Err(format!("no file in {} is called {name}", dir.display()));
    }
    found.sort_by_key(|n| natural(n));
    Ok(found.into_iter().map(|n| dir.join(n)).collect())
}

/// Whether a name fits a pattern: `*` any text, `?` any character. One pass with a return to the
/// last star.
fn glob(pattern: &[char], name: &[char]) -> bool {
    let (mut p, mut n, mut star) = (0, 0, None);
    while n < name.len() {
        match pattern.get(p) {
            Some('*') => {
                star = Some((p, n));
                p += 1;
            }
            Some(c) if *c == '?' || *c == name[n] => {
                p += 1;
                n += 1;
            }
            _ => {
                let Some((at, from)) = star else { return false };
                star = Some((at, from + 1));
                (p, n) = (at + 1, from + 1);
            }
        }
    }
    pattern[p..].iter().all(|c| *c == '*')
}

/// A key that sorts `s2` before `s10`: digits as numbers, padded.
fn natural(name: &str) -> String {
    let mut key = String::new();
    let mut digits = String::new();
    for c in name.chars().chain([' ']) {
        if c.is_ascii_digit() {
            digits.push(c);
            continue;
        }
        if !digits.is_empty() {
            key.push_str(&format!("{:0>20}", digits.trim_start_matches('0')));
            digits.clear();
        }
        key.push(c);
    }
    key
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used)]
    use super::*;

    #[test]
    fn names_with_stars_in_natural_order() {
        let folder = tempfile::tempdir().unwrap();
        for name in ["s10.csv", "s2.csv", "s1.csv", "hub.csv", "s1.txt"] {
            std::fs::write(folder.path().join(name), "").unwrap();
        }
        let header = folder.path().join("a.toml");
        let names = |p: &[&str]| -> Vec<String> {
            let names = Names::Several(p.iter().map(|s| (*s).to_owned()).collect());
            let found = files(&header, &names).unwrap();
            found.iter().map(|f| f.file_name().unwrap().to_string_lossy().into_owned()).collect()
        };
        assert_eq!(names(&["s*.csv"]), ["s1.csv", "s2.csv", "s10.csv"]);
        assert_eq!(names(&["s?.csv", "hub.csv"]), ["s1.csv", "s2.csv", "hub.csv"]);
        for (missing, words) in [("t*.csv", "no file in"), ("t.csv", "is not there")] {
            let e = files(&header, &Names::One(missing.into())).unwrap_err().to_string();
            assert!(e.contains(words), "{e}");
        }
        assert!(files(&header, &Names::default()).unwrap_err().to_string().contains("names no files"));
    }

    #[test]
    fn globs() {
        let fits = |p: &str, n: &str| glob(&p.chars().collect::<Vec<_>>(), &n.chars().collect::<Vec<_>>());
        assert!(fits("*", "") && fits("a*b*c", "axxbxbc") && fits("a?c", "abc") && fits("**", "x"));
        assert!(!fits("a*b*c", "axxbxb") && !fits("?", "") && !fits("a", "ab"));
    }

    #[test]
    fn headers_and_job_files_are_told_apart() {
        assert!(is_header("[sections]\nunit = \"cm\"\n"));
        assert!(!is_header("[model]\nfile = \"a.step\"\n") && !is_header("no toml"));
    }

    #[test]
    fn bad_headers_are_named() {
        for (text, words) in [
            ("[sections]\nunits = \"mm\"\n", "line 2"),
            ("[sections]\nunit = \"furlong\"\n", "line 2"),
            ("[sections]\nunit_mm = 0\n", "unit_mm"),
            ("[sections]\nunit_mm = 2\nunit = \"mm\"\n", "two answers"),
            ("[sections]\nextrude = -1.0\n", "extrude"),
            ("[sections]\nextrude = 1.0\nheights = [1.0]\n", "give one of them"),
            ("[sections]\npoints_per_block = 0\n", "points_per_block"),
            ("[sections]\nheights = [nan]\n", "not a number"),
            ("[sections", "line 1"),
        ] {
            let e = parse(text, "a.toml").unwrap_err().to_string();
            assert!(e.contains(words) && e.contains("a.toml"), "{words} is not in {e}");
        }
    }

    #[test]
    fn a_header_at_the_top_of_the_data() {
        let (header, data) = front_matter("+++\n[sections]\nunit = \"m\"\n+++\n1 2 3\n").unwrap();
        assert_eq!((header, data), ("[sections]\nunit = \"m\"\n", "1 2 3\n"));
        assert!(front_matter("1 2 3\n").is_none() && front_matter("+++\n[sections]\n").is_none());
    }
}
