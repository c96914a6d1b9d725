//! The parts of a tool.

use std::fmt;

/// A part of the tool. In files it is its name: `cutter`, `taper`, `shank`, `holder 1`.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, serde::Serialize, serde::Deserialize)]
#[serde(into = "String", try_from = "String")]
pub enum ToolPart {
    /// The bottom of a cutter that is no ball, with its corner.
    Cutter,
    /// The cone behind the ball.
    Taper,
    /// The cylinder between the cone and the holder.
    Shank,
    /// A stage of the holder; the first, next to the cutter, is 1.
    Holder(u32),
}

impl ToolPart {
    /// A stage of the holder: it keeps a clearance of its own.
    pub fn is_holder(self) -> bool {
        matches!(self, ToolPart::Holder(_))
    }
}

impl fmt::Display for ToolPart {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            ToolPart::Cutter => f.write_str("cutter"),
            ToolPart::Taper => f.write_str("taper"),
            ToolPart::Shank => f.write_str("shank"),
            ToolPart::Holder(stage) => write!(f, "holder {stage}"),
        }
    }
}

impl From<ToolPart> for String {
    fn from(part: ToolPart) -> String {
        part.to_string()
    }
}

impl TryFrom<String> for ToolPart {
    type Error = String;

    fn try_from(name: String) -> Result<Self, String> {
        match name.as_str() {
            "cutter" => Ok(ToolPart::Cutter),
            "taper" => Ok(ToolPart::Taper),
            "shank" => Ok(ToolPart::Shank),
            _ => {
                let stage = name.strip_prefix("holder ").and_then(|n| n.parse().ok()).filter(|n| *n > 0);
                stage.map(ToolPart::Holder).ok_or_else(|| format!("`{name}` is no part of a tool"))
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_come_back() {
        for part in [ToolPart::Cutter, ToolPart::Taper, ToolPart::Shank, ToolPart::Holder(1), ToolPart::Holder(12)] {
            assert_eq!(ToolPart::try_from(part.to_string()), Ok(part));
        }
        for name in ["", "holder", "holder 0", "holder -1", "ball"] {
            assert!(ToolPart::try_from(name.to_owned()).is_err(), "{name}");
        }
    }
}
