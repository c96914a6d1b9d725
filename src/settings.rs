//! How a room declares its section of the job file: each key once, with its default and its range.
//!
//! [`section!`] makes two types of one declaration. The *keys* are the section as typed: all
//! optional, described in the schema, left out again when written. The *settings* are the section
//! as the room reads it, complete. A key's first paragraph is what the schema says ([`schema`]);
//! the paragraph after it gives the reason of the default.
//!
//! A default that depends on blade or tool is declared with the value that holds where nothing is
//! known of them; [`crate::job`] puts its own in place of it.

use std::ops::RangeInclusive;
use std::path::PathBuf;

use schemars::Schema;
use schemars::transform::{RecursiveTransform, Transform};
use serde_json::Value;

mod reader;

pub use reader::{Mismatch, TomlError, from_toml, from_value, to_value};

use crate::error::{Error, Result, Stage};

/// Declares a section of the job file, see the module's page.
///
/// `"name" Settings, Keys, s { key: Type = default, range; … }`: a range is optional and may read
/// other values of `s`. `Typed as Type` where a value is typed in another form than it is read.
/// Attributes behind a key's text are those of its setting.
macro_rules! section {
    (
        $(#[doc = $about:literal])+
        $(#[derive($derive:ident)])?
        $table:literal $settings:ident, $keys:ident, $s:ident {
            $(
                $(#[doc = $said:literal])+
                $(#[serde($($serde:tt)*)])?
                $key:ident: $type:ty $(as $read:ty)? = $default:expr $(, $range:expr)?;
            )*
        }
    ) => {
        $(#[doc = $about])+
        #[derive(Clone, Debug, PartialEq, serde::Serialize, serde::Deserialize $(, $derive)?)]
        #[serde(deny_unknown_fields, default)]
        pub struct $settings {
            $(
                $(#[doc = $said])+
                $(#[serde($($serde)*)])?
                pub $key: $crate::settings::read_as!($type $(, $read)?),
            )*
        }

        impl Default for $settings {
            fn default() -> Self {
                $settings { $($key: $default,)* }
            }
        }

        impl $settings {
            /// These, where a section or a key of it was left out; else as typed.
            #[must_use]
            pub fn with_typed(self, keys: Option<$keys>) -> Self {
                let Some(keys) = keys else { return self };
                $settings { $($key: keys.$key.map_or(self.$key, $crate::settings::Typed::read),)* }
            }

            /// Checks every value; `stage` is who asks.
            ///
            /// # Errors
            /// Kind `Usage`, naming the key, its value and its limits.
            pub fn check(&self, stage: $crate::error::Stage) -> $crate::error::Result<()> {
                let $s = self;
                $($($crate::settings::check(stage, concat!($table, ".", stringify!($key)), &$s.$key, &$range)?;)?)*
                Ok(())
            }
        }

        $(#[doc = $about])+
        #[derive(Clone, Debug, Default, PartialEq, serde::Serialize, serde::Deserialize, schemars::JsonSchema)]
        #[serde(deny_unknown_fields)]
        pub struct $keys {
            $(
                $(#[doc = $said])+
                #[serde(skip_serializing_if = "Option::is_none")]
                pub $key: Option<$type>,
            )*
        }
    };
}
pub(crate) use section;

/// JSON schema of a type. A description is the first paragraph of its comment, on one line.
pub(crate) fn schema<T: schemars::JsonSchema>() -> Schema {
    let mut schema = schemars::schema_for!(T);
    let mut first_paragraphs = RecursiveTransform(|schema: &mut Schema| {
        if let Some(Value::String(text)) = schema.get_mut("description") {
            *text = text.split("\n\n").next().unwrap_or_default().replace('\n', " ");
        }
    });
    first_paragraphs.transform(&mut schema);
    schema
}

/// Lets options be written with some of their settings changed.
macro_rules! with_settings {
    ($options:ty, $settings:ty) => {
        impl $options {
            /// The same, with what `change` does to the settings.
            #[must_use]
            pub fn with(mut self, change: impl FnOnce(&mut $settings)) -> Self {
                change(&mut self.settings);
                self
            }
        }
    };
}
pub(crate) use with_settings;

/// The form in which a value is read.
macro_rules! read_as {
    ($type:ty) => {
        $type
    };
    ($type:ty, $read:ty) => {
        $read
    };
}
pub(crate) use read_as;

/// A value as typed, to be read in another form.
pub(crate) trait Typed<T> {
    fn read(self) -> T;
}
impl<T> Typed<T> for T {
    fn read(self) -> T {
        self
    }
}
impl<T> Typed<Option<T>> for T {
    fn read(self) -> Option<T> {
        Some(self)
    }
}
impl Typed<PathBuf> for String {
    fn read(self) -> PathBuf {
        self.into()
    }
}
impl Typed<Option<PathBuf>> for String {
    fn read(self) -> Option<PathBuf> {
        Some(self.into())
    }
}
impl Typed<Vec<PathBuf>> for Vec<String> {
    fn read(self) -> Vec<PathBuf> {
        self.into_iter().map(Into::into).collect()
    }
}

/// A value that has limits; `None` where it is left out.
pub(crate) trait Number {
    fn number(&self) -> Option<f64>;
}
impl Number for f64 {
    fn number(&self) -> Option<f64> {
        Some(*self)
    }
}
impl Number for u32 {
    fn number(&self) -> Option<f64> {
        Some(f64::from(*self))
    }
}
impl Number for Option<f64> {
    fn number(&self) -> Option<f64> {
        *self
    }
}

/// Stands for "greater than 0" in ranges, mm or degrees: nothing smaller can be meant.
pub(crate) const TINY: f64 = 1e-9;

/// A value outside its range, as an error.
pub(crate) fn check(stage: Stage, key: &str, value: &dyn Number, range: &RangeInclusive<f64>) -> Result<()> {
    let (Some(v), lo, hi) = (value.number().filter(|v| !range.contains(v)), *range.start(), *range.end()) else {
        return Ok(());
    };
    let lo = if lo == TINY { "greater than 0".to_string() } else { format!("at least {lo}") };
    Err(Error::usage(stage, format!("{key} is {v}, it must be {lo} and at most {hi}")))
}

/// `invalid type: string "2", expected f64` as `a number is wanted, not the text "2"`; any other
/// message as it is.
fn plain(message: &str) -> String {
    if let Some(key) = message.strip_prefix("missing field ") {
        return format!("{key} is missing");
    }
    let Some((found, wanted)) = message.strip_prefix("invalid ").and_then(|m| m.split_once(", expected ")) else {
        return message.to_owned();
    };
    let (kind, found) = found.split_once(' ').unwrap_or((found, ""));
    let found = match (kind, found) {
        ("length", n) => format!("a list of {n}"),
        (_, "sequence") => "a list".to_owned(),
        (_, "map") => "a table".to_owned(),
        (_, x) => x.strip_prefix("string ").map_or_else(|| bare(x), |text| format!("the text {text}")),
    };
    let wanted = match wanted {
        "f64" => "a number".to_owned(),
        "u8" | "u16" | "u32" | "u64" | "usize" => "a whole number from 0".to_owned(),
        "i64" => "a whole number".to_owned(),
        "a boolean" => "true or false".to_owned(),
        "a string" => "a text".to_owned(),
        "path string" => "the name of a file".to_owned(),
        "a sequence" => "a list".to_owned(),
        "a map" => "a table".to_owned(),
        w if w.starts_with("struct ") => "a table".to_owned(),
        w => w.strip_prefix("an array of length ").map_or_else(|| w.to_owned(), |n| format!("a list of {n}")),
    };
    format!("{wanted} is wanted, not {found}")
}

/// ``integer `5` `` as `5`.
fn bare(found: &str) -> String {
    found.split('`').nth(1).unwrap_or(found).to_owned()
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used)]
    use super::from_toml;

    #[test]
    fn types_of_the_parser_are_told_in_words() {
        #[derive(Debug, serde::Deserialize)]
        #[serde(deny_unknown_fields)]
        #[allow(dead_code)]
        struct Inner {
            number: f64,
        }
        #[derive(Debug, serde::Deserialize)]
        #[serde(deny_unknown_fields, default)]
        #[allow(dead_code)]
        struct All {
            number: f64,
            count: u32,
            list: Vec<f64>,
            three: [f64; 3],
            yes: bool,
            name: String,
            inner: Option<Inner>,
        }
        impl Default for All {
            fn default() -> Self {
                let (name, inner) = (String::new(), None);
                All { number: 0.0, count: 0, list: Vec::new(), three: [0.0; 3], yes: false, name, inner }
            }
        }
        for (text, says) in [
            ("number = \"2,5\"", "a number is wanted, not the text \"2,5\""),
            ("number = [1]", "a number is wanted, not a list"),
            ("number = true", "a number is wanted, not true"),
            ("count = -1", "a whole number from 0 is wanted, not -1"),
            ("count = 1.5", "a whole number from 0 is wanted, not 1.5"),
            ("list = { a = 1 }", "a list is wanted, not a table"),
            ("three = [1, 2]", "a list of 3 is wanted, not a list of 2"),
            ("yes = 1", "true or false is wanted, not 1"),
            ("name = 3", "a text is wanted, not 3"),
            ("inner = 3", "a table is wanted, not 3"),
            ("inner = {}", "`number` is missing"),
            (
                "nomber = 3",
                "unknown field `nomber`, expected one of `number`, `count`, `list`, `three`, `yes`, `name`, `inner`",
            ),
        ] {
            assert_eq!(from_toml::<All>(text).unwrap_err().words, says, "{text}");
        }
    }
}
