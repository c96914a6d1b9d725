//! From the family file to its members: every one with a name, a model or a design, and a typed job
//! of its own.

use std::collections::{BTreeMap, BTreeSet};
use std::path::{Path, PathBuf};

use super::file::{self, Combine, FamilyFile, MOST_MEMBERS, Override};
use super::member::{BladeSource, Member, set};
use super::{design, models, table};
use crate::error::{Error, Result, Stage};
use crate::job::JobFile;
use crate::run::inputs;
use crate::settings::{from_value, to_value};

/// A family: members in the order of the file, names all different.
#[derive(Clone, Debug, PartialEq)]
pub struct Family {
    /// Name of the family file, without its ending.
    pub name: String,
    /// The members.
    pub members: Vec<Member>,
}

fn usage(message: impl Into<String>) -> Error {
    Error::usage(Stage::Batch, message)
}

impl Family {
    /// Reads a family file and works out its members.
    ///
    /// # Errors
    /// `InputOutput` where a file cannot be read; `Usage` in one sentence for everything else that
    /// is wrong: patterns that match nothing, names that come twice, unknown parameters, a file
    /// that leads back to itself, missing columns.
    pub fn load(path: &Path) -> Result<Family> {
        let typed = file::load(path)?;
        let base = path.parent().filter(|p| !p.as_os_str().is_empty()).unwrap_or(Path::new("."));
        if let Some(job) = &typed.job {
            let same = |p: &Path| std::fs::canonicalize(p).ok();
            if same(&base.join(job)).is_some_and(|j| Some(j) == same(path)) {
                return Err(usage(format!("the template job {job} is the family file itself: the path is cyclic"))
                    .advise("name a job file, as for `plan`"));
            }
        }
        let name = path.file_stem().map_or_else(|| "family".into(), |s| s.to_string_lossy().into_owned());
        Ok(Family { name, members: members(&typed, base)? })
    }

    /// The family of a file that was made by a program; relative paths are taken from `base`.
    ///
    /// # Errors
    /// As [`Family::load`].
    pub fn new(name: &str, file: &FamilyFile, base: &Path) -> Result<Family> {
        Ok(Family { name: name.to_owned(), members: members(file, base)? })
    }
}

/// Members before ranges and overrides.
fn members(file: &FamilyFile, base: &Path) -> Result<Vec<Member>> {
    let template = template(file, base)?;
    let mut all = Vec::new();
    for member in bases(file, base, &template)? {
        spread(member, file, &mut all)?;
    }
    if all.len() > MOST_MEMBERS {
        return Err(usage(format!("the family has {} members, at most {MOST_MEMBERS} are possible", all.len())));
    }
    distinct(&all)?;
    for change in &file.overrides {
        overridden(&mut all, change)?;
    }
    for m in &mut all {
        m.job = inputs::absolute(std::mem::take(&mut m.job), base);
        if let BladeSource::Design(d) = &mut m.source {
            if !m.blade.is_empty() {
                d.name = m
                    .blade
                    .chars()
                    .map(|c| if c.is_ascii_alphanumeric() || "-_.".contains(c) { c } else { '_' })
                    .collect();
            }
            d.validate().map_err(|e| e_of(&m.name, e))?;
        }
    }
    Ok(all)
}

fn e_of(name: &str, e: Error) -> Error {
    Error { stage: Stage::Batch, message: format!("member {name}: {}", e.message), ..e }
}

/// The template job: the file, then the keys in the family file.
fn template(file: &FamilyFile, base: &Path) -> Result<JobFile> {
    let mut of_file = JobFile::default();
    if let Some(name) = &file.job {
        let path = base.join(name);
        of_file = inputs::absolute(inputs::job(&path)?, path.parent().unwrap_or(base));
    }
    let Some(keys) = &file.template else { return Ok(of_file) };
    let value = |j: &JobFile| to_value(j).map_err(|e| usage(format!("the template job: {e}")));
    let mut root = value(&of_file)?;
    overlay(&mut root, value(&inputs::absolute(keys.clone(), base))?);
    from_value(&root).map_err(|e| usage(format!("the template job: {e}")))
}

fn overlay(under: &mut toml::Value, over: toml::Value) {
    match (under, over) {
        (toml::Value::Table(a), toml::Value::Table(b)) => {
            for (key, value) in b {
                match a.get_mut(&key) {
                    Some(old) => overlay(old, value),
                    None => {
                        a.insert(key, value);
                    }
                }
            }
        }
        (a, b) => *a = b,
    }
}

/// What ranges multiply: models, rows of the table, the design, or the template's model.
fn bases(file: &FamilyFile, base: &Path, template: &JobFile) -> Result<Vec<Member>> {
    let mut job = template.clone();
    let own = job.model.as_mut().and_then(|m| m.file.take()).map(PathBuf::from);
    let plain = |name: String, source: BladeSource| Member {
        name,
        source,
        blade: String::new(),
        job: job.clone(),
        parameters: BTreeMap::new(),
    };
    if file.models.is_some() && (file.table.is_some() || file.design.is_some()) {
        return Err(usage("models cannot stand together with table or design")
            .advise("name models in a column `model` of the table instead"));
    }
    if let Some(patterns) = &file.models {
        return Ok(models::find(patterns.all(), base)?
            .into_iter()
            .map(|(n, f)| plain(n, BladeSource::Model(f)))
            .collect());
    }
    let design = file.design.as_ref().map(|d| design::load(d, base)).transpose()?;
    let default = design.map(|d| BladeSource::Design(Box::new(d))).or(own.map(BladeSource::Model));
    if let Some(table) = &file.table {
        return table::read(&base.join(table))?.members(default, &job);
    }
    let source = default.ok_or_else(|| {
        usage("the family names no blades").advise("give models, a table, a design, or model.file in the template job")
    })?;
    Ok(vec![plain(String::new(), source)])
}

/// The member with every choice of the ranges.
fn spread(member: Member, file: &FamilyFile, all: &mut Vec<Member>) -> Result<()> {
    let ranges: Vec<(&String, &Vec<toml::Value>)> = file.ranges.iter().map(|(k, r)| (k, &r.0)).collect();
    if ranges.is_empty() {
        if member.name.is_empty() {
            return Err(usage("the family has a single blade and nothing that varies").advise("give ranges"));
        }
        all.push(member);
        return Ok(());
    }
    let lengths: Vec<usize> = ranges.iter().map(|(_, v)| v.len()).collect();
    let count = match file.combine {
        Combine::Grid => lengths.iter().try_fold(1usize, |n, l| n.checked_mul(*l)),
        Combine::List if lengths.iter().all(|l| *l == lengths[0]) => lengths.first().copied(),
        Combine::List => {
            let told: Vec<String> = ranges.iter().map(|(k, v)| format!("{k} has {}", v.len())).collect();
            return Err(usage(format!("with combine = \"list\" all ranges need as many values: {}", told.join(", "))));
        }
    };
    let count = count.filter(|n| *n <= MOST_MEMBERS).ok_or_else(|| {
        usage(format!("the ranges make more than {MOST_MEMBERS} members")).advise("take fewer values")
    })?;
    let labels = labels(&ranges);
    for k in 0..count {
        let mut next = member.clone();
        let (mut rest, mut parts, mut blade) = (k, Vec::new(), Vec::new());
        // The last range turns fastest.
        let mut picks = vec![k; ranges.len()];
        if file.combine == Combine::Grid {
            for (pick, length) in picks.iter_mut().zip(&lengths).rev() {
                (*pick, rest) = (rest % length, rest / length);
            }
        }
        for (((key, values), label), pick) in ranges.iter().zip(&labels).zip(picks) {
            let Some(value) = values.get(pick) else { continue };
            set(&mut next, key, value)?;
            let part = format!("{label}-{}", value_name(value, pick));
            if key.starts_with("design.") || key.starts_with("vary.") {
                blade.push(part.clone());
            }
            parts.push(part);
        }
        if !next.name.is_empty() {
            parts.insert(0, next.name.clone());
            blade.insert(0, next.name.clone());
        }
        (next.name, next.blade) = (parts.join("_"), blade.join("_"));
        all.push(next);
    }
    Ok(())
}

/// Short names of the ranges: the last part of the key, or all of it where two end alike.
fn labels(ranges: &[(&String, &Vec<toml::Value>)]) -> Vec<String> {
    let last = |key: &str| key.rsplit('.').next().unwrap_or(key).to_owned();
    let alike = |key: &str| ranges.iter().filter(|(k, _)| last(k) == last(key)).count() > 1;
    ranges.iter().map(|(k, _)| if alike(k) { (*k).clone() } else { last(k) }).collect()
}

/// A value as part of a name; what cannot be one is called by its number in the list.
fn value_name(value: &toml::Value, pick: usize) -> String {
    let text = match value {
        toml::Value::Integer(i) => i.to_string(),
        toml::Value::Float(x) => x.to_string(),
        toml::Value::Boolean(b) => b.to_string(),
        toml::Value::String(s) => s.clone(),
        _ => String::new(),
    };
    let fits =
        !text.is_empty() && text.len() <= 24 && text.chars().all(|c| c.is_ascii_alphanumeric() || "-.".contains(c));
    if fits { text } else { format!("n{}", pick + 1) }
}

/// Names become folders: refused where two are the same (in whatever case), or cannot be a folder's
/// name.
fn distinct(all: &[Member]) -> Result<()> {
    let mut seen = BTreeSet::new();
    for m in all {
        let plain = m.name.chars().all(|c| c.is_alphanumeric() || "-_.+=, ".contains(c));
        if !plain || m.name.starts_with(['.', ' ', '-']) || m.name.ends_with(' ') || m.name.len() > 160 {
            return Err(usage(format!("the name `{}` cannot be the name of a folder everywhere", m.name))
                .advise("use letters, digits, `-`, `_`, `.`, at most 160"));
        }
        if !seen.insert(m.name.to_lowercase()) {
            return Err(usage(format!("the name {} comes twice in the family", m.name))
                .advise("rename a file or a row of the table"));
        }
    }
    Ok(())
}

fn overridden(all: &mut [Member], change: &Override) -> Result<()> {
    for text in change.members.all() {
        let pattern =
            glob::Pattern::new(text).map_err(|e| usage(format!("override: `{text}` is no pattern of names: {e}")))?;
        let mut hit = false;
        for m in all.iter_mut().filter(|m| pattern.matches(&m.name)) {
            hit = true;
            for (key, value) in &change.set {
                set(m, key, value)?;
            }
        }
        if !hit {
            return Err(usage(format!("override: no member is called {text}")));
        }
    }
    Ok(())
}
