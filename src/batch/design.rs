//! Parameters of the generator: keys of a design, and variations that are given in one number.

use std::path::Path;

use crate::error::{Error, Result, Stage};
use crate::files;
use crate::job;
use crate::make::{BladeDesign, Law, presets};
use crate::settings::{from_value, to_value};

/// Variations of a design, beside its own keys.
pub(super) const VARIATIONS: [(&str, &str); 3] = [
    ("twist_deg", "added to the stagger, in proportion to the height: 0 at the platform, this much at the tip"),
    ("chord_factor", "times the chord at all heights"),
    ("thickness_factor", "times the thickness and the edges' radii at all heights"),
];

/// Reads a preset or a design file.
pub(super) fn load(given: &str, base: &Path) -> Result<BladeDesign> {
    if let Some(design) = presets::by_name(given) {
        return Ok(design);
    }
    let path = base.join(given);
    let text = files::read_text(&path, files::SHORT).map_err(|e| {
        let names = presets::ALL.map(|(n, _)| n).join(", ");
        Error::io(Stage::Batch, format!("{given} is neither a preset nor a design file that can be read: {e}"))
            .advise(format!("presets: {names}"))
            .caused_by(e)
    })?;
    BladeDesign::from_toml(&text)
}

/// Sets one parameter of the design; `key` without its first part. What is wrong, in words.
pub(super) fn set(
    design: &mut BladeDesign,
    section: &str,
    key: &[&str],
    value: &toml::Value,
) -> std::result::Result<(), String> {
    if section == "vary" {
        return vary(design, key, value);
    }
    let mut root = to_value(design)?;
    job::insert(&mut root, key, value.clone())?;
    *design = from_value(&root)?;
    Ok(())
}

fn vary(design: &mut BladeDesign, key: &[&str], value: &toml::Value) -> std::result::Result<(), String> {
    let number = value.as_float().or_else(|| value.as_integer().map(|i| i as f64)).filter(|v| v.is_finite());
    let number = number.ok_or("the value is not a number")?;
    let a = design.airfoil.as_mut().ok_or("the design has no airfoil to vary")?;
    match key {
        ["twist_deg"] => a.stagger_deg = twisted(&a.stagger_deg, number),
        ["chord_factor"] => a.chord_mm = scaled(&a.chord_mm, number),
        ["thickness_factor"] => {
            a.thickness_mm = scaled(&a.thickness_mm, number);
            a.leading_radius_mm = scaled(&a.leading_radius_mm, number);
            a.trailing_radius_mm = scaled(&a.trailing_radius_mm, number);
        }
        _ => {
            let known = VARIATIONS.map(|(name, _)| format!("vary.{name}")).join(", ");
            return Err(format!("there is no such variation; there are {known}"));
        }
    }
    Ok(())
}

fn scaled(law: &Law, factor: f64) -> Law {
    match law {
        Law::Constant(v) => Law::Constant(v * factor),
        Law::Stations(list) => Law::Stations(list.iter().map(|[h, v]| [*h, v * factor]).collect()),
    }
}

fn twisted(law: &Law, tip: f64) -> Law {
    match law {
        Law::Constant(v) => Law::Stations(vec![[0.0, *v], [1.0, v + tip]]),
        Law::Stations(list) => Law::Stations(list.iter().map(|[h, v]| [*h, v + h * tip]).collect()),
    }
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used)]
    use super::*;

    #[test]
    fn variations_change_their_laws_and_nothing_else() {
        let before = presets::compressor_twist();
        let mut d = before.clone();
        set(&mut d, "vary", &["twist_deg"], &toml::Value::Integer(10)).unwrap();
        let stagger = d.airfoil.as_ref().unwrap().stagger_deg.clone();
        assert_eq!(stagger, Law::Stations(vec![[0.0, 14.0], [0.5, 45.0], [1.0, 68.0]]));
        set(&mut d, "vary", &["twist_deg"], &toml::Value::Float(-10.0)).unwrap();
        assert_eq!(d, before);
        set(&mut d, "vary", &["chord_factor"], &toml::Value::Float(2.0)).unwrap();
        assert_eq!(d.airfoil.as_ref().unwrap().chord_mm, Law::Stations(vec![[0.0, 90.0], [1.0, 84.0]]));
        set(&mut d, "design", &["airfoil", "chord_mm"], &toml::Value::Float(45.0)).unwrap();
        assert_eq!(d.airfoil.as_ref().unwrap().chord_mm, Law::Constant(45.0));
        set(&mut d, "design", &["airfoil", "stagger_deg", "2", "1"], &toml::Value::Float(50.0)).unwrap();
        assert_eq!(d.airfoil.as_ref().unwrap().stagger_deg, Law::Stations(vec![[0.0, 14.0], [0.5, 40.0], [1.0, 50.0]]));
    }

    #[test]
    fn what_cannot_be_set_is_told() {
        let mut d = presets::prism();
        let e = set(&mut d, "vary", &["twist_deg"], &toml::Value::Integer(1)).unwrap_err();
        assert!(e.contains("no airfoil"), "{e}");
        let e = set(&mut d, "design", &["fillet_radus_mm"], &toml::Value::Integer(1)).unwrap_err();
        assert!(e.contains("fillet_radus_mm"), "{e}");
        let mut d = presets::steam_root();
        let e = set(&mut d, "vary", &["twist"], &toml::Value::Integer(1)).unwrap_err();
        assert!(e.contains("vary.twist_deg"), "{e}");
    }
}
