//! Reader of tool libraries: JSON of Fusion, and the tool table of LinuxCNC.
//!
//! **In** the text of a library and what an entry is called. **Out** a [`Listed`] tool. **Method**
//! A ball-end cutter is read as the product has it: ball, cone, shank, and stages of a holder. What
//! stands above the shoulder (a thicker shank, segments of a shaft) is read as stages too, so that
//! the room for a holder is kept from it. A cone of shaft or holder becomes cylinders that are
//! nowhere thinner than it. **Fails** with kind `Usage`, naming library and entry: no library,
//! another kind of cutter, an entry that is missing or named twice.
//!
//! A LinuxCNC table knows diameters alone, in the unit of its machine; the rest of such a tool is
//! chosen as for any job (LinuxCNC, "Tool Compensation", table format). Fusion lists the segments
//! of shaft and holder from the cutter towards the spindle; `LB` is the length below the holder.

use serde::Deserialize;

use crate::artifact::blade::Unit;
use crate::error::{Error, Result, Stage};
use crate::tool::HolderStage;

/// Cylinders that take the place of a cone grow by at most this in radius, mm.
const STEP_MM: f64 = 0.5;
/// Most cylinders for one cone.
const MOST_STEPS: f64 = 64.0;
/// A ball's radius and half its diameter are the same within this, mm.
const ROUNDING_MM: f64 = 1e-3;
/// Names that a message lists at most.
const SHOWN: usize = 12;

/// A tool of a library, mm and degrees.
#[derive(Clone, Debug, PartialEq)]
pub struct Listed {
    /// Number in the magazine; `None`: the library gives none.
    pub number: Option<u32>,
    /// What the library calls it.
    pub name: String,
    /// Ball radius.
    pub radius_mm: f64,
    /// What lies behind the ball; `None`: the library does not say.
    pub body: Option<ToolBody>,
}

/// What lies behind the ball, as in [`crate::tool::Tool`].
#[derive(Clone, Debug, PartialEq)]
pub struct ToolBody {
    /// Half angle of the cone behind the ball, degrees.
    pub taper_deg: f64,
    /// Radius of the shank, mm.
    pub shank_radius_mm: f64,
    /// From the ball centre to the first stage, mm.
    pub stickout_mm: f64,
    /// Stages towards the spindle.
    pub stages: Vec<HolderStage>,
}

/// An entry as the library has it: a ball-end cutter, or why it is none.
struct Entry {
    number: Option<u32>,
    name: String,
    tool: std::result::Result<Listed, String>,
}

/// The tool that a library calls by a number or a name; with `None` its only ball-end cutter.
/// `unit`: of a table that states none; default mm. `origin` names the library in messages.
///
/// # Errors
/// See the module's page.
pub fn tool(text: &str, entry: Option<&str>, unit: Option<Unit>, origin: &str) -> Result<Listed> {
    let bad = |what: String| Error::usage(Stage::Job, format!("tool library {origin}: {what}"));
    let text = text.trim_start_matches('\u{feff}');
    let entries = if text.trim_start().starts_with('{') { fusion(text) } else { table(text, unit) }.map_err(bad)?;
    let balls = || entries.iter().filter(|e| e.tool.is_ok());
    let Some(wanted) = entry.map(str::trim) else {
        let mut all = balls().filter_map(|e| e.tool.as_ref().ok());
        return match (all.next(), all.next()) {
            (Some(only), None) => Ok(only.clone()),
            (None, _) => Err(bad("it has no ball-end cutter".into())),
            _ => Err(bad("it has several ball-end cutters".into())
                .advise(format!("name one with tool.entry: {}", shown(balls())))),
        };
    };
    let by_number = entries.iter().filter(|e| e.number.is_some_and(|n| Ok(n) == wanted.parse()));
    let by_name = entries.iter().filter(|e| e.name.eq_ignore_ascii_case(wanted));
    let found: Vec<&Entry> = by_number.chain(by_name).collect();
    match found[..] {
        [one] => one.tool.clone().map_err(|why| bad(format!("entry {wanted}: {why}"))),
        [] => {
            Err(bad(format!("there is no entry {wanted}")).advise(format!("its ball-end cutters: {}", shown(balls()))))
        }
        _ => Err(bad(format!("{} entries are called {wanted}", found.len()))
            .advise("give the one that is meant a number or a name of its own in the library")),
    }
}

/// The entries in a message.
fn shown<'a>(entries: impl Iterator<Item = &'a Entry>) -> String {
    let mut names: Vec<String> = entries
        .map(|e| match e.number {
            Some(n) if e.name.is_empty() => n.to_string(),
            Some(n) => format!("{n} ({})", e.name),
            None => e.name.clone(),
        })
        .collect();
    let more = names.len().saturating_sub(SHOWN);
    names.truncate(SHOWN);
    match (names.is_empty(), more) {
        (true, _) => "none".into(),
        (_, 0) => names.join(", "),
        _ => format!("{} and {more} more", names.join(", ")),
    }
}

/// A LinuxCNC table: one tool a line, words of a letter and a number, a comment behind `;`.
fn table(text: &str, unit: Option<Unit>) -> std::result::Result<Vec<Entry>, String> {
    let to_mm = unit.map_or(1.0, Unit::mm);
    let mut out = Vec::new();
    for (k, line) in text.lines().enumerate() {
        let (words, comment) = line.split_once(';').unwrap_or((line, ""));
        if words.trim().is_empty() {
            continue;
        }
        let (mut number, mut diameter) = (None, None);
        for word in words.split_whitespace() {
            let value = word.get(1..).and_then(|v| v.parse::<f64>().ok()).filter(|v| v.is_finite());
            let (Some(letter), Some(value)) = (word.chars().next(), value) else {
                return Err(format!("line {}: `{word}` is no word of a LinuxCNC tool table", k + 1));
            };
            match letter.to_ascii_uppercase() {
                'T' if value >= 0.0 && value.fract() == 0.0 && value <= f64::from(u32::MAX) => {
                    number = Some(value as u32);
                }
                'T' => return Err(format!("line {}: {word} is no tool number", k + 1)),
                'D' => diameter = Some(value * to_mm),
                'P' | 'X' | 'Y' | 'Z' | 'A' | 'B' | 'C' | 'U' | 'V' | 'W' | 'I' | 'J' | 'Q' => {}
                _ => return Err(format!("line {}: `{word}` is no word of a LinuxCNC tool table", k + 1)),
            }
        }
        let Some(number) = number else {
            return Err(format!("line {}: a tool has a number, T", k + 1));
        };
        let name = comment.trim().to_owned();
        let tool = match diameter {
            Some(d) if d > 0.0 => {
                Ok(Listed { number: Some(number), name: name.clone(), radius_mm: 0.5 * d, body: None })
            }
            _ => Err(format!("line {} gives it no diameter, D", k + 1)),
        };
        out.push(Entry { number: Some(number), name, tool });
    }
    if out.is_empty() { Err("it has no tool".into()) } else { Ok(out) }
}

/// What is read of a Fusion library.
#[derive(Deserialize)]
struct Library {
    data: Vec<FusionTool>,
}

#[derive(Deserialize)]
struct FusionTool {
    #[serde(default)]
    description: String,
    #[serde(default, rename = "type")]
    kind: String,
    #[serde(default)]
    unit: String,
    #[serde(default)]
    geometry: Geometry,
    #[serde(rename = "post-process")]
    post: Option<Post>,
    shaft: Option<Segments>,
    holder: Option<Segments>,
}

#[derive(Default, Deserialize)]
struct Geometry {
    /// Diameter.
    #[serde(rename = "DC")]
    diameter: Option<f64>,
    /// Corner radius; of a ball-end cutter half the diameter, or left out.
    #[serde(rename = "RE")]
    corner: Option<f64>,
    /// Half angle of the cone, degrees.
    #[serde(rename = "TA")]
    taper: Option<f64>,
    /// Diameter of the shank.
    #[serde(rename = "SFDM")]
    shank: Option<f64>,
    /// From the tip to the holder.
    #[serde(rename = "LB")]
    below_holder: Option<f64>,
    /// From the tip to where the cutter is thicker than its edges.
    #[serde(rename = "shoulder-length")]
    shoulder: Option<f64>,
    #[serde(rename = "shoulder-diameter")]
    shoulder_diameter: Option<f64>,
}

#[derive(Deserialize)]
struct Post {
    number: Option<u32>,
}

#[derive(Deserialize)]
struct Segments {
    #[serde(default)]
    segments: Vec<Segment>,
    /// The holder's own unit; of a shaft that of its tool.
    unit: Option<String>,
}

#[derive(Deserialize)]
struct Segment {
    height: f64,
    #[serde(rename = "lower-diameter")]
    lower: f64,
    #[serde(rename = "upper-diameter")]
    upper: f64,
}

fn fusion(text: &str) -> std::result::Result<Vec<Entry>, String> {
    let library: Library =
        serde_json::from_str(text).map_err(|e| format!("it is not the JSON of a Fusion tool library: {e}"))?;
    let cutters = library.data.iter().filter(|t| t.kind != "holder");
    let out: Vec<Entry> = cutters.map(|t| Entry { number: t.number(), name: t.name(), tool: t.listed() }).collect();
    if out.is_empty() { Err("it has no tool".into()) } else { Ok(out) }
}

fn unit_mm(name: &str) -> std::result::Result<f64, String> {
    match name {
        "millimeters" => Ok(1.0),
        "inches" => Ok(25.4),
        _ => Err(format!("its unit is `{name}`, not millimeters or inches")),
    }
}

impl FusionTool {
    fn number(&self) -> Option<u32> {
        self.post.as_ref().and_then(|p| p.number)
    }

    fn name(&self) -> String {
        self.description.trim().to_owned()
    }

    fn listed(&self) -> std::result::Result<Listed, String> {
        let g = &self.geometry;
        if self.kind != "ball end mill" && self.kind != "tapered mill" {
            return Err(format!("it is a {}, only ball-end cutters are read", self.kind));
        }
        let mm = unit_mm(&self.unit)?;
        let length = |value: Option<f64>, key: &str| match value {
            Some(v) if v > 0.0 && v.is_finite() => Ok(v * mm),
            Some(v) => Err(format!("geometry.{key} is {v}, it must be greater than 0")),
            None => Err(format!("geometry.{key} is missing")),
        };
        let radius_mm = 0.5 * length(g.diameter, "DC")?;
        let corner_mm = g.corner.map_or(radius_mm, |c| c * mm);
        if !((corner_mm - radius_mm).abs() <= ROUNDING_MM) {
            return Err(format!("its corner radius is {corner_mm} mm, a ball of its diameter has {radius_mm} mm"));
        }
        let taper_deg = g.taper.unwrap_or(0.0);
        let below_mm = length(g.below_holder, "LB")?;
        let shank_mm = 0.5 * g.shank.map_or(Ok(2.0 * radius_mm), |s| length(Some(s), "SFDM"))?;
        let mut stages = self.shaft.as_ref().map_or(Ok(Vec::new()), |s| cylinders(&s.segments, mm))?;
        let shaft_mm: f64 = stages.iter().map(|s| s.length_mm).sum();
        let mut neck_mm = shank_mm;
        let mut end_mm = below_mm - shaft_mm;
        if taper_deg == 0.0 && stages.is_empty() {
            // The neck ends at the shoulder, the thicker shank goes on from there.
            neck_mm =
                0.5 * g.shoulder_diameter.map_or(Ok(2.0 * radius_mm), |d| length(Some(d), "shoulder-diameter"))?;
            let shoulder_mm = g.shoulder.map_or(Ok(below_mm), |s| length(Some(s), "shoulder-length"))?.min(below_mm);
            if shank_mm > neck_mm && shoulder_mm < below_mm {
                stages.push(HolderStage { radius_mm: shank_mm, length_mm: below_mm - shoulder_mm });
                end_mm = shoulder_mm;
            }
        } else if taper_deg == 0.0 {
            neck_mm = radius_mm;
        }
        if let Some(holder) = &self.holder {
            stages.extend(cylinders(&holder.segments, holder.unit.as_deref().map_or(Ok(mm), unit_mm)?)?);
        }
        let body = ToolBody { taper_deg, shank_radius_mm: neck_mm, stickout_mm: end_mm - radius_mm, stages };
        Ok(Listed { number: self.number(), name: self.name(), radius_mm, body: Some(body) })
    }
}

/// Cylinders that are nowhere thinner than the segments.
fn cylinders(segments: &[Segment], mm: f64) -> std::result::Result<Vec<HolderStage>, String> {
    let mut out: Vec<HolderStage> = Vec::new();
    for s in segments {
        let [height, lower, upper] = [s.height * mm, 0.5 * s.lower * mm, 0.5 * s.upper * mm];
        if !(height >= 0.0 && height.is_finite() && lower.min(upper) >= 0.0 && lower.max(upper).is_finite()) {
            return Err("a segment of its shaft or holder has a size below 0".into());
        }
        // A shoulder without height says nothing that its neighbours do not.
        if height <= 0.0 || lower.max(upper) <= 0.0 {
            continue;
        }
        let steps = ((upper - lower).abs() / STEP_MM).ceil().clamp(1.0, MOST_STEPS);
        for k in 0..steps as u32 {
            let at = |k: f64| lower + (upper - lower) * k / steps;
            let radius_mm = at(f64::from(k)).max(at(f64::from(k) + 1.0));
            out.push(HolderStage { radius_mm, length_mm: height / steps });
        }
    }
    Ok(out)
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used)]
    use super::*;

    const TABLE: &str = "T1 P1 D6.0 Z+42.5 ; ball 6\n\nT2 P3 D-0.5 ;odd\nt12 D0.25 Z0.1 I20 J30 Q2\n; only a comment\n";

    const FUSION: &str = r#"{ "data": [
        { "type": "ball end mill", "unit": "millimeters", "description": "Ball 6 long", "post-process": { "number": 7 },
          "geometry": { "DC": 6, "RE": 3, "SFDM": 8, "LB": 60, "LCF": 10, "shoulder-length": 25, "TA": 0 },
          "holder": { "unit": "inches", "segments": [
              { "height": 1, "lower-diameter": 1, "upper-diameter": 1 },
              { "height": 0, "lower-diameter": 1, "upper-diameter": 2 },
              { "height": 2, "lower-diameter": 2, "upper-diameter": 2 } ] } },
        { "type": "tapered mill", "unit": "inches", "description": "Tapered 1/8", "post-process": { "number": 8 },
          "shaft": null, "holder": null,
          "geometry": { "DC": 0.125, "RE": 0.0625, "SFDM": 0.5, "LB": 2.5, "TA": 4 } },
        { "type": "flat end mill", "unit": "millimeters", "description": "Flat 10", "post-process": { "number": 9 }, "geometry": { "DC": 10 } },
        { "type": "ball end mill", "unit": "millimeters", "description": "twice", "geometry": { "DC": 4, "LB": 30 },
          "shaft": { "segments": [ { "height": 10, "lower-diameter": 4, "upper-diameter": 8 } ] } },
        { "type": "ball end mill", "unit": "furlongs", "description": "Twice", "geometry": { "DC": 4 } },
        { "type": "holder", "unit": "millimeters", "description": "bare holder", "segments": [] }
    ], "version": 36 }"#;

    fn says(text: &str, entry: Option<&str>) -> String {
        let e = tool(text, entry, None, "t").unwrap_err();
        format!("{}; {}", e.message, e.advice.unwrap_or_default())
    }

    #[test]
    fn a_table_gives_diameters_in_its_unit() {
        let t = tool(TABLE, Some("1"), None, "t").unwrap();
        assert_eq!((t.radius_mm, t.name.as_str(), t.body), (3.0, "ball 6", None));
        let inch = tool(TABLE, Some("12"), Some(Unit::Inch), "t").unwrap();
        assert!((inch.radius_mm - 3.175).abs() < 1e-12);
        assert_eq!(tool(TABLE, Some("BALL 6"), None, "t").unwrap().number, Some(1));
        assert!(says(TABLE, Some("2")).contains("line 3 gives it no diameter"));
        assert!(says(TABLE, Some("5")).contains("there is no entry 5; its ball-end cutters: 1 (ball 6), 12"));
        assert!(says(TABLE, None).contains("several ball-end cutters; name one with tool.entry: 1 (ball 6), 12"));
        assert!(says("T1 P1 D6\nT2 6.0", Some("1")).contains("line 2: `6.0` is no word"));
        assert!(says("T1.5 D6", None).contains("line 1: T1.5 is no tool number"));
        assert!(says("D6 Z3", None).contains("line 1: a tool has a number"));
        assert!(says("  ; nothing\n", None).contains("it has no tool"));
        assert!(says("T€ D1", None).contains("no word"));
        assert_eq!(tool("\u{feff}T1 D6", None, None, "t").unwrap().radius_mm, 3.0);
    }

    #[test]
    fn fusion_gives_neck_shank_and_holder() {
        let t = tool(FUSION, Some("7"), None, "t").unwrap();
        let body = t.body.unwrap();
        assert_eq!((t.radius_mm, body.taper_deg, body.shank_radius_mm, body.stickout_mm), (3.0, 0.0, 3.0, 22.0));
        let stage = |radius_mm, length_mm| HolderStage { radius_mm, length_mm };
        assert_eq!(body.stages, [stage(4.0, 35.0), stage(12.7, 25.4), stage(25.4, 50.8)]);
        let tapered = tool(FUSION, Some("tapered 1/8"), None, "t").unwrap().body.unwrap();
        assert_eq!((tapered.taper_deg, tapered.shank_radius_mm), (4.0, 6.35));
        assert!((tapered.stickout_mm - (63.5 - 1.5875)).abs() < 1e-12 && tapered.stages.is_empty());
    }

    #[test]
    fn cones_become_cylinders_that_are_nowhere_thinner() {
        let listed = serde_json::from_str::<Library>(FUSION).unwrap().data[3].listed().unwrap();
        let body = listed.body.unwrap();
        assert_eq!((body.stickout_mm, body.stages.len()), (18.0, 4));
        let mut z = 0.0;
        for s in &body.stages {
            z += s.length_mm;
            assert!((2.0 + 0.2 * z - s.radius_mm).abs() < 1e-12, "{s:?}");
        }
        assert!((z - 10.0).abs() < 1e-12);
    }

    #[test]
    fn what_is_no_ball_or_not_one_entry_is_said() {
        assert!(says(FUSION, Some("9")).contains("entry 9: it is a flat end mill, only ball-end cutters are read"));
        assert!(says(FUSION, Some("twice")).contains("2 entries are called twice"));
        assert!(says(FUSION, Some("bare holder")).contains("there is no entry bare holder"));
        assert!(says(&FUSION.replace("furlongs", "millimeters"), None).contains("several"));
        assert!(says(&FUSION.replace("\"RE\": 3", "\"RE\": 1"), Some("7")).contains("corner radius is 1 mm"));
        assert!(says(&FUSION.replace("\"LB\": 60", "\"LB\": -60"), Some("7")).contains("geometry.LB is -60"));
        assert!(says(r#"{"data": []}"#, None).contains("it has no tool"));
        assert!(says(r#"{"tools": []}"#, None).contains("not the JSON of a Fusion tool library"));
    }
}
