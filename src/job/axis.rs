//! The `model.axis` key: where the blade axis lies in the model's frame.

use std::fmt;

use serde::{Deserialize, Deserializer, Serialize, Serializer, de};

/// Where the blade axis (root to tip) points in the model frame.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub enum AxisChoice {
    /// Found from the part.
    #[default]
    Auto,
    /// Given: a coordinate axis or any direction (unit length).
    Direction([f64; 3]),
}

const NAMED: [(&str, [f64; 3]); 6] = [
    ("x", [1.0, 0.0, 0.0]),
    ("-x", [-1.0, 0.0, 0.0]),
    ("y", [0.0, 1.0, 0.0]),
    ("-y", [0.0, -1.0, 0.0]),
    ("z", [0.0, 0.0, 1.0]),
    ("-z", [0.0, 0.0, -1.0]),
];
const EXPECTED: &str = "\"auto\", \"x\", \"-x\", \"y\", \"-y\", \"z\", \"-z\" or a direction of three numbers";

impl AxisChoice {
    /// The direction, if it was given.
    pub fn direction(self) -> Option<[f64; 3]> {
        match self {
            AxisChoice::Auto => None,
            AxisChoice::Direction(d) => Some(d),
        }
    }
    fn of_vector(v: [f64; 3]) -> Option<Self> {
        let norm = v.iter().map(|x| x * x).sum::<f64>().sqrt();
        let unit = (norm - 1.0).abs() < 1e-12;
        (norm.is_finite() && norm > 1e-9).then(|| AxisChoice::Direction(if unit { v } else { v.map(|x| x / norm) }))
    }
}

impl Serialize for AxisChoice {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        match self {
            AxisChoice::Auto => serializer.serialize_str("auto"),
            AxisChoice::Direction(d) => match NAMED.iter().find(|(_, v)| v == d) {
                Some((name, _)) => serializer.serialize_str(name),
                None => d.serialize(serializer),
            },
        }
    }
}

struct AxisVisitor;
impl<'de> de::Visitor<'de> for AxisVisitor {
    type Value = AxisChoice;
    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(EXPECTED)
    }
    fn visit_str<E: de::Error>(self, text: &str) -> Result<AxisChoice, E> {
        if text == "auto" {
            return Ok(AxisChoice::Auto);
        }
        let bare = text.strip_prefix('+').unwrap_or(text);
        let named = NAMED.iter().find(|(name, _)| *name == bare);
        named.map(|(_, v)| AxisChoice::Direction(*v)).ok_or_else(|| E::invalid_value(de::Unexpected::Str(text), &self))
    }
    fn visit_seq<A: de::SeqAccess<'de>>(self, mut seq: A) -> Result<AxisChoice, A::Error> {
        let mut v = [0.0; 3];
        for (i, x) in v.iter_mut().enumerate() {
            *x = seq.next_element()?.ok_or_else(|| de::Error::invalid_length(i, &self))?;
        }
        if seq.next_element::<f64>()?.is_some() {
            return Err(de::Error::invalid_length(4, &self));
        }
        AxisChoice::of_vector(v).ok_or_else(|| de::Error::custom("a direction of length 0 or without end is no axis"))
    }
}

impl<'de> Deserialize<'de> for AxisChoice {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        deserializer.deserialize_any(AxisVisitor)
    }
}

impl schemars::JsonSchema for AxisChoice {
    fn schema_name() -> std::borrow::Cow<'static, str> {
        "AxisChoice".into()
    }
    fn json_schema(_: &mut schemars::SchemaGenerator) -> schemars::Schema {
        schemars::json_schema!({
            "description": "Where the blade axis (root to tip) points in the model frame.",
            "anyOf": [
                { "type": "string", "enum": ["auto", "x", "+x", "-x", "y", "+y", "-y", "z", "+z", "-z"] },
                { "type": "array", "items": { "type": "number" }, "minItems": 3, "maxItems": 3 }
            ]
        })
    }
}
