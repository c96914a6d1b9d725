//! TOML read into types by one deserializer.
//!
//! That of the library offers each type its keys in four forms: as a table of the text, of a value
//! in memory, of a date, and of a value with its place. All of them are compiled for each type, and
//! types that are read from TOML have hundreds of keys. Here a type is offered one form: a table of
//! the text. A value in memory is made a text first.

use serde::Serialize;
use serde::de::{
    DeserializeOwned, DeserializeSeed, Deserializer, Error, Expected, IntoDeserializer, MapAccess, SeqAccess,
    Unexpected, Visitor,
};
use toml::Spanned;
use toml::de::{DeFloat, DeInteger, DeString, DeTable, DeValue};

/// What is wrong with a TOML text.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[error("{words}")]
pub struct TomlError {
    /// In one line of plain words: a parser speaks of its own types.
    pub words: String,
    /// The line, from 1, where the fault has one.
    pub line: Option<usize>,
    /// The value is of another type than is wanted.
    pub mismatch: Option<Mismatch>,
}

/// Types that are often taken for one another.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Mismatch {
    /// A list is wanted, not a table.
    TableForList,
    /// A number is wanted, not a text.
    TextForNumber,
}

impl Mismatch {
    /// That of a value that was found; `wanted` is how the library calls what is wanted.
    fn of(found: &Unexpected, wanted: &str) -> Option<Self> {
        match (found, wanted) {
            (Unexpected::Map, "a sequence") => Some(Mismatch::TableForList),
            (Unexpected::Str(_), "f64" | "i32" | "i64" | "u8" | "u16" | "u32" | "u64" | "usize") => {
                Some(Mismatch::TextForNumber)
            }
            _ => None,
        }
    }
}

impl From<String> for TomlError {
    fn from(words: String) -> Self {
        TomlError { words, line: None, mismatch: None }
    }
}

impl From<TomlError> for String {
    fn from(fault: TomlError) -> Self {
        fault.words
    }
}

/// What a TOML text says.
///
/// # Errors
/// The text is no TOML, a key is unknown or missing, a value is of another type.
pub fn from_toml<T: DeserializeOwned>(text: &str) -> Result<T, TomlError> {
    table(text).and_then(T::deserialize).map_err(|fault| TomlError {
        words: super::plain(&fault.message.trim().replace('\n', " ")),
        line: fault.at.map(|at| text.get(..at).unwrap_or(text).matches('\n').count() + 1),
        mismatch: fault.mismatch,
    })
}

/// What a table of TOML values says.
///
/// # Errors
/// Without a line: a key is unknown or missing, a value is of another type.
pub fn from_value<T: DeserializeOwned>(table: &toml::Value) -> Result<T, TomlError> {
    let text = toml::to_string(table).map_err(|e| e.to_string())?;
    from_toml(&text).map_err(|e| TomlError { line: None, ..e })
}

/// What is written in TOML as a table, as values.
///
/// # Errors
/// In words: TOML has no form for it.
pub fn to_value<T: Serialize>(table: &T) -> Result<toml::Value, String> {
    let text = toml::to_string(table).map_err(|e| e.to_string())?;
    toml::from_str(&text).map(toml::Value::Table).map_err(|e| e.to_string())
}

fn table(text: &str) -> Result<Reader<'_>, Fault> {
    match DeTable::parse(text) {
        Ok(table) => {
            let at = table.span().start;
            Ok(Reader { value: DeValue::Table(table.into_inner()), at })
        }
        Err(e) => Err(Fault { at: e.span().map(|s| s.start), ..Fault::custom(e.message()) }),
    }
}

/// What is wrong, as the parser or a type says it, and the byte where.
#[derive(Debug)]
struct Fault {
    message: String,
    at: Option<usize>,
    mismatch: Option<Mismatch>,
}

impl Fault {
    /// The innermost place that is known holds.
    fn or_at(mut self, at: usize) -> Self {
        self.at.get_or_insert(at);
        self
    }
}

impl std::fmt::Display for Fault {
    fn fmt(&self, f: &mut std::fmt::Formatter) -> std::fmt::Result {
        f.write_str(&self.message)
    }
}

impl std::error::Error for Fault {}

impl Error for Fault {
    fn custom<M: std::fmt::Display>(message: M) -> Self {
        Fault { message: message.to_string(), at: None, mismatch: None }
    }

    fn invalid_type(found: Unexpected, wanted: &dyn Expected) -> Self {
        let wanted = wanted.to_string();
        let message = format!("invalid type: {found}, expected {wanted}");
        Fault { mismatch: Mismatch::of(&found, &wanted), ..Self::custom(message) }
    }
}

/// A value and the byte where it stands.
struct Reader<'de> {
    value: DeValue<'de>,
    at: usize,
}

impl<'de> Reader<'de> {
    fn new(value: Spanned<DeValue<'de>>) -> Self {
        let at = value.span().start;
        Reader { value: value.into_inner(), at }
    }
}

impl<'de> Deserializer<'de> for Reader<'de> {
    type Error = Fault;

    fn deserialize_any<V: Visitor<'de>>(self, visitor: V) -> Result<V::Value, Fault> {
        let read = match self.value {
            DeValue::String(text) => visitor.visit_str(&text),
            DeValue::Integer(n) => whole(&n).and_then(|n| match n {
                Whole::Signed(n) => visitor.visit_i64(n),
                Whole::Unsigned(n) => visitor.visit_u64(n),
            }),
            DeValue::Float(x) => number(&x).and_then(|x| visitor.visit_f64(x)),
            DeValue::Boolean(yes) => visitor.visit_bool(yes),
            // No key is a date.
            DeValue::Datetime(_) => Err(Fault::invalid_type(Unexpected::Other("a date"), &visitor)),
            DeValue::Array(list) => visitor.visit_seq(Items(list.into_iter())),
            DeValue::Table(table) => visitor.visit_map(Entries { rest: table.into_iter(), value: None }),
        };
        read.map_err(|fault| fault.or_at(self.at))
    }

    fn deserialize_option<V: Visitor<'de>>(self, visitor: V) -> Result<V::Value, Fault> {
        visitor.visit_some(self)
    }

    fn deserialize_newtype_struct<V: Visitor<'de>>(self, _: &'static str, visitor: V) -> Result<V::Value, Fault> {
        visitor.visit_newtype_struct(self)
    }

    // Only of words: no key is an enum that holds something.
    fn deserialize_enum<V: Visitor<'de>>(
        self,
        _: &'static str,
        _: &'static [&'static str],
        visitor: V,
    ) -> Result<V::Value, Fault> {
        let read = word(self.value).and_then(|word| visitor.visit_enum(word.into_deserializer()));
        read.map_err(|fault| fault.or_at(self.at))
    }

    serde::forward_to_deserialize_any! {
        bool u8 u16 u32 u64 u128 i8 i16 i32 i64 i128 f32 f64 char str string seq bytes byte_buf map
        unit struct ignored_any unit_struct tuple_struct tuple identifier
    }
}

/// A whole number, signed where it can be.
enum Whole {
    Signed(i64),
    Unsigned(u64),
}

fn whole(n: &DeInteger) -> Result<Whole, Fault> {
    let signed = i64::from_str_radix(n.as_str(), n.radix()).map(Whole::Signed);
    let unsigned = || u64::from_str_radix(n.as_str(), n.radix()).map(Whole::Unsigned);
    signed.or_else(|_| unsigned()).map_err(|_| Fault::custom("integer number overflowed"))
}

/// Infinite only where the text says so.
fn number(x: &DeFloat) -> Result<f64, Fault> {
    let read = x
        .as_str()
        .parse()
        .ok()
        .filter(|read: &f64| read.is_finite() || !x.as_str().contains(|c: char| c.is_ascii_digit()));
    read.ok_or_else(|| Fault::custom("floating-point number overflowed"))
}

fn word(value: DeValue<'_>) -> Result<DeString<'_>, Fault> {
    let found = match &value {
        DeValue::String(_) => Unexpected::Other("text"),
        DeValue::Integer(n) => Unexpected::Other(n.as_str()),
        DeValue::Float(x) => Unexpected::Other(x.as_str()),
        DeValue::Boolean(yes) => Unexpected::Bool(*yes),
        DeValue::Datetime(_) => Unexpected::Other("a date"),
        DeValue::Array(_) => Unexpected::Seq,
        DeValue::Table(_) => Unexpected::Map,
    };
    let wrong = Fault::invalid_type(found, &"a string");
    if let DeValue::String(text) = value { Ok(text) } else { Err(wrong) }
}

/// The values of a list.
struct Items<'de>(std::vec::IntoIter<Spanned<DeValue<'de>>>);

impl<'de> SeqAccess<'de> for Items<'de> {
    type Error = Fault;

    fn next_element_seed<S: DeserializeSeed<'de>>(&mut self, seed: S) -> Result<Option<S::Value>, Fault> {
        self.0.next().map(|value| seed.deserialize(Reader::new(value))).transpose()
    }

    fn size_hint(&self) -> Option<usize> {
        Some(self.0.len())
    }
}

/// The keys of a table with their values.
struct Entries<'de> {
    rest: toml::map::IntoIter<Spanned<DeString<'de>>, Spanned<DeValue<'de>>>,
    value: Option<Spanned<DeValue<'de>>>,
}

impl<'de> MapAccess<'de> for Entries<'de> {
    type Error = Fault;

    fn next_key_seed<S: DeserializeSeed<'de>>(&mut self, seed: S) -> Result<Option<S::Value>, Fault> {
        let Some((key, value)) = self.rest.next() else { return Ok(None) };
        self.value = Some(value);
        let at = key.span().start;
        seed.deserialize(key.into_inner().into_deserializer()).map(Some).map_err(|fault: Fault| fault.or_at(at))
    }

    fn next_value_seed<S: DeserializeSeed<'de>>(&mut self, seed: S) -> Result<S::Value, Fault> {
        let value = self.value.take().ok_or_else(|| Fault::custom("a value is asked for before its key"))?;
        let at = value.span().start;
        seed.deserialize(Reader::new(value)).map_err(|fault| fault.or_at(at))
    }

    fn size_hint(&self) -> Option<usize> {
        Some(self.rest.len())
    }
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used)]
    use std::collections::BTreeMap;

    use serde::Deserialize;

    use super::*;

    #[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
    #[serde(rename_all = "kebab-case")]
    enum Kind {
        LeastTime,
        Even,
    }

    #[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
    #[serde(untagged, expecting = "a number or a list is wanted")]
    enum Law {
        Same(f64),
        Along(Vec<[f64; 2]>),
    }

    #[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
    #[serde(deny_unknown_fields)]
    struct Link {
        length: Length,
        #[serde(skip_serializing_if = "Option::is_none")]
        name: Option<String>,
    }

    #[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
    struct Length(f64);

    #[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
    #[serde(deny_unknown_fields, default)]
    struct All {
        whole: u64,
        signed: i32,
        small: u8,
        number: Option<f64>,
        yes: bool,
        kind: Option<Kind>,
        law: Option<Law>,
        three: [f64; 3],
        pair: (String, f64),
        set: BTreeMap<String, toml::Value>,
        kinds: BTreeMap<String, Kind>,
        links: Vec<Link>,
        link: Option<Link>,
    }

    /// Texts that are read, and texts that are not: as the library reads them, with its words and
    /// lines.
    #[test]
    fn all_is_read_as_the_library_reads_it() {
        let texts = [
            "",
            "whole = 18_446_744_073_709_551_615\nsigned = -0x10\nsmall = 0b11\nnumber = 3\nyes = true",
            "number = -inf\nkind = \"least-time\"\nlaw = 1.5e3\nthree = [1, 2.5, 3]\npair = [\"a\", 1]",
            "law = [[0, 1], [1.0, 2.0]]\nset.a.b = [1, { c = \"d\" }]\nset.x = 1.5\nset.'y z' = true",
            "[kinds]\na = \"even\"\nb = \"least-time\"\n[[links]]\nlength = 1\n[[links]]\nname = \"n\\u00e9\"\nlength = 2.0",
            "link = { length = 1, name = \"\"\"\nx\ny\"\"\" }",
            // No TOML.
            "whole = 1\nwhole = 2",
            "whole 1",
            "\nyes = tru",
            "name = \"a",
            // Keys and values that are not wanted.
            "\n\nnone = 1",
            "whole = 1\n\nlink = { length = 1, nane = 2 }",
            "[[links]]\nlength = 1\n[[links]]\nname = \"a\"",
            "whole = -1",
            "small = 256",
            "signed = 3_000_000_000",
            "number = 1e400",
            "number = 99999999999999999999999999999999999999999",
            "number = \"2\"",
            "yes = 1",
            "kind = \"evn\"",
            "\n[kinds]\na = \"even\"\nb = \"odd\"",
            "law = \"x\"",
            "law = [[0, 1], [1.0]]",
            "three = [\n1,\n2,\n]",
            "three = [\n1,\n\"2\",\n3]",
            "pair = [\"a\"]",
            "pair = { a = 1 }",
            "set = 1",
            "links = { length = 1 }",
            "link = [1, \"a\"]",
            "link = [1, 2]",
            "link = 1",
        ];
        for text in texts {
            match (from_toml::<All>(text), toml::from_str::<All>(text)) {
                (Ok(own), Ok(want)) => assert_eq!(own, want, "{text}"),
                (Err(own), Err(want)) => {
                    let line = |at: usize| text[..at].matches('\n').count() + 1;
                    assert_eq!(own.line, want.span().map(|s| line(s.start)), "{text}");
                    assert_eq!(own.words, super::super::plain(&want.message().replace('\n', " ")), "{text}");
                }
                (own, want) => panic!("{text}: {own:?}, not {want:?}"),
            }
        }
    }

    #[test]
    fn words_of_what_no_key_is() {
        for (text, says) in [
            ("kind = 3", "a text is wanted, not 3"),
            ("kind = [1]", "a text is wanted, not a list"),
            ("kind = { even = 1 }", "a text is wanted, not a table"),
            ("number = 1979-05-27", "a number is wanted, not a date"),
        ] {
            assert_eq!(from_toml::<All>(text).unwrap_err().words, says, "{text}");
        }
    }

    #[test]
    fn values_and_back() {
        let mut all =
            from_toml::<All>("number = 0.1\nkinds.a = \"even\"\nset.b = [1.0, 2]\nlinks = [{ length = 1 }]").unwrap();
        all.set.insert("c".into(), toml::Value::Float(1e300));
        let mut value = to_value(&all).unwrap();
        assert_eq!(from_value::<All>(&value).unwrap(), all);
        value["number"] = toml::Value::Boolean(true);
        assert_eq!(from_value::<All>(&value).unwrap_err().words, "a number is wanted, not true");
        value["number"] = toml::Value::String("2".into());
        let fault = from_value::<All>(&value).unwrap_err();
        assert_eq!((fault.line, fault.mismatch), (None, Some(Mismatch::TextForNumber)));
        value["number"] = toml::Value::Integer(2);
        value["links"] = value["links"][0].clone();
        assert_eq!(from_value::<All>(&value).unwrap_err().mismatch, Some(Mismatch::TableForList));
    }
}
