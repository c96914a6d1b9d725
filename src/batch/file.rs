//! The family file as typed: unknown keys refused, one template job, members by models, by a table,
//! by a design, by ranges.

use std::collections::BTreeMap;
use std::path::Path;

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::error::{Error, Result, Stage};
use crate::job::JobFile;
use crate::run::inputs;
use crate::settings::{from_toml, from_value};

/// The family file. Exactly one of `models`, `table` and `design` says what the members are, or
/// none, where the template names the model; `ranges` multiply them. A parameter is a key of the
/// job (`tool.radius_mm`), of the generator's design (`design.fillet_radius_mm`, entries of lists
/// by number) or a variation of the design (`vary.twist_deg`).
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct FamilyFile {
    /// Template: a job file, relative to the family file.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub job: Option<String>,
    /// Keys of the template job, over those of `job`.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub template: Option<JobFile>,
    /// Models by patterns (`*`, `?`, `[…]`, `**`), relative to the family file; a member is called
    /// as its file.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub models: Option<Patterns>,
    /// Members by rows of a CSV file: a column `name`, perhaps a column `model` (relative to the
    /// table), and parameters; an empty cell leaves its parameter as it is.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub table: Option<String>,
    /// The generator's design: a preset's name or a design file, relative to the family file. With
    /// `table`, all rows vary it.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub design: Option<String>,
    /// Values of parameters that every member takes in turn.
    #[serde(default, skip_serializing_if = "BTreeMap::is_empty")]
    pub ranges: BTreeMap<String, Range>,
    /// How ranges go together.
    #[serde(default)]
    pub combine: Combine,
    /// Changes to single members, in order.
    #[serde(default, rename = "override", skip_serializing_if = "Vec::is_empty")]
    pub overrides: Vec<Override>,
}

/// One pattern or several.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(untagged, expecting = "a text is wanted, or a list of texts")]
pub enum Patterns {
    /// One.
    One(String),
    /// Several.
    Many(Vec<String>),
}

impl Patterns {
    /// All of them.
    pub fn all(&self) -> &[String] {
        match self {
            Patterns::One(p) => std::slice::from_ref(p),
            Patterns::Many(list) => list,
        }
    }
}

/// How ranges go together.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum Combine {
    /// Every value with every other.
    #[default]
    Grid,
    /// First values together, second values together …: all ranges have as many.
    List,
}

/// Values of one parameter: a list, or `{ from = 1.0, to = 2.0, count = 5 }`, evenly from one end
/// to the other, both taken.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(try_from = "toml::Value", into = "toml::Value")]
#[schemars(with = "RangeSchema")]
pub struct Range(pub Vec<toml::Value>);

/// A range as it may be typed.
#[derive(JsonSchema)]
#[serde(untagged)]
#[allow(dead_code)]
enum RangeSchema {
    /// The values.
    Values(Vec<serde_json::Value>),
    /// Evenly spaced.
    Even(Even),
}

/// Evenly spaced numbers.
#[derive(Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
struct Even {
    /// First.
    from: f64,
    /// Last.
    to: f64,
    /// How many, at least 2.
    count: u32,
}

/// A family larger than this is a slip of the pen.
pub(super) const MOST_MEMBERS: usize = 100_000;

impl TryFrom<toml::Value> for Range {
    type Error = String;

    fn try_from(value: toml::Value) -> std::result::Result<Self, String> {
        match value {
            toml::Value::Array(list) if list.is_empty() => Err("the list is empty".into()),
            toml::Value::Array(list) => Ok(Range(list)),
            toml::Value::Table(_) => {
                let even: Even = from_value(&value)?;
                let (n, finite) = (even.count, even.from.is_finite() && even.to.is_finite());
                if !finite || !(2..=MOST_MEMBERS as u32).contains(&n) {
                    return Err(format!("a range needs finite ends and a count from 2 to {MOST_MEMBERS}"));
                }
                let at = |k: u32| {
                    // Rounded to 12 digits: 0.1 + 2 × 0.1 is to be called 0.3.
                    let x = even.from + (even.to - even.from) * f64::from(k) / f64::from(n - 1);
                    let text = format!("{x:.11e}");
                    toml::Value::Float(text.parse().unwrap_or(x))
                };
                Ok(Range((0..n).map(at).collect()))
            }
            _ => Err("a range is a list of values, or { from, to, count }".into()),
        }
    }
}

impl From<Range> for toml::Value {
    fn from(range: Range) -> Self {
        toml::Value::Array(range.0)
    }
}

/// Changes to single members.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Override {
    /// Names of members, with `*` and `?`.
    pub members: Patterns,
    /// Parameters and their values.
    #[schemars(with = "BTreeMap<String, serde_json::Value>")]
    pub set: BTreeMap<String, toml::Value>,
}

/// JSON schema of the family file.
pub fn schema() -> schemars::Schema {
    crate::settings::schema::<FamilyFile>()
}

/// Reads a family file.
///
/// # Errors
/// `InputOutput` where it cannot be read; `Usage` with file, line and key where it is no family
/// file.
pub fn load(path: &Path) -> Result<FamilyFile> {
    let short = "a family file is a short TOML text; name models and tables in it";
    parse(&inputs::text_of(path, Stage::Batch, "family file", short)?, &path.display().to_string())
}

/// Parses the text of a family file; `name` is used in messages.
///
/// # Errors
/// `Usage` with name, line and key.
pub fn parse(text: &str, name: &str) -> Result<FamilyFile> {
    from_toml(text).map_err(|e| {
        let place = e.line.map_or_else(|| name.to_owned(), |l| format!("{name}, line {l}"));
        let shown = e.line.and_then(|l| text.lines().nth(l - 1)).map(str::trim).filter(|l| !l.is_empty());
        let shown = shown.map(|l| format!(" at `{l}`")).unwrap_or_default();
        Error::usage(Stage::Batch, format!("{place}{shown}: {}", e.words))
            .advise("models/family.schema.json lists every key")
    })
}
