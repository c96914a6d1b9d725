//! What the words other than axes do. Every word that a program may have is in one of these lists;
//! all others are refused.

use super::frames::{Setting, swivel};
use super::subprograms::Jump;
use super::words::CodeWord;
use super::{Bare, Centre, LineWords, Modal, ModalMotion, Plane};
use crate::artifact::program::Turning;

/// A word other than of an axis.
pub(super) fn take(word: &CodeWord, modal: &mut Modal, said: &mut LineWords) -> Result<(), String> {
    match word.address {
        "M" => miscellaneous(word, said)?,
        "POLY" => modal.motion = Some(ModalMotion::Polynomial),
        "PL" => said.interval = Some(word.number()?),
        "I" | "J" | "K" => component(word, &mut said.ijk, "IJK")?,
        "R" | "CR" => said.radius = Some(if modal.inch { 25.4 * word.number()? } else { word.number()? }),
        "RPL" => said.in_plane_deg = Some(word.number()?),
        "TURN" => said.turns = Some(word.count()?),
        "L" => said.repeats = Some(word.count()?),
        "A3" | "B3" | "C3" => component(word, &mut said.abc3, "ABC")?,
        "F" => said.feed = Some(word.number()?),
        "S" => said.rpm = Some(word.number()?),
        "T" => said.tool = Some(tool(word)?),
        "D" => said.edge = Some(word.count()?),
        "H" => modal.number = Some(word.count()?),
        "P" => said.p = Some(word.number()?),
        "Q" => said.q = Some(word.number()?),
        "O" if modal.begun => return Err(format!("a second program begins with {}", word.raw)),
        "TRANS" => said.frame = Some(Setting::Shift { added: false }),
        "ATRANS" => said.frame = Some(Setting::Shift { added: true }),
        "ROT" => said.frame = Some(Setting::Turn { added: false }),
        "AROT" => said.frame = Some(Setting::Turn { added: true }),
        "SCALE" | "ASCALE" | "MIRROR" | "AMIRROR" | "ROTS" | "AROTS" | "CROTS" => {
            return Err(format!("{}: scales, mirrors and turns in space are not read", word.raw));
        }
        name if name.starts_with("CYCLE800(") => {
            said.bare = Some(Bare::Call);
            said.swivel = swivel(word, modal)?;
        }
        "N" | "O" => {
            word.number()?;
        }
        "TRAORI" | "TRAORI(1)" => modal.centre = Centre::Transformation,
        "TRAFOOF" => modal.centre = Centre::Off,
        "SUPA" => (said.machine, said.with_length) = (true, true),
        "UPATH" => modal.with_path = true,
        "SPATH" => modal.with_path = false,
        "ORIAXES" => (modal.setting.axes_evenly, modal.great_circle) = (true, false),
        "ORIVECT" | "ORIPLANE" => (modal.setting.axes_evenly, modal.great_circle) = (false, true),
        "ORIWKS" => modal.machine_vectors = false,
        "ORIMKS" => modal.machine_vectors = true,
        "RET" => said.jump = Some(Jump::Done { ends_main: true }),
        name if harmless(name) => {}
        name if name.starts_with("CYCLE832(") => {
            said.bare = Some(Bare::Call);
            modal.setting.tolerance_mm = high_speed_setting(word, modal)?;
        }
        name if ["CYCLE", "HOLES", "POCKET", "SLOT", "LONGHOLE", "MCALL"].iter().any(|c| name.starts_with(c)) => {
            return Err(format!("{}: cycles that move are not read", word.raw));
        }
        _ => return Err(format!("the word {} is not known", word.raw)),
    }
    Ok(())
}

/// Names that change neither where the tool goes nor with which tool, in which frame or unit: jerk,
/// feed forward, compressors within the tolerance that is set, look-ahead, collision detection,
/// messages, and settings at their defaults.
fn harmless(name: &str) -> bool {
    let plain = [
        "SOFT",
        "BRISK",
        "FFWON",
        "FFWOF",
        "COMPCAD",
        "COMPCURV",
        "COMPSURF",
        "COMPON",
        "COMPOF",
        "STOPRE",
        "CDOF",
        "CDOF2",
        "FNORM",
        "DYNNORM",
        "DYNPOS",
        "DYNROUGH",
        "DYNSEMIFIN",
        "DYNFINISH",
        "FGROUP()",
        "FGROUP(X,Y,Z)",
        "POLYPATH()",
        "POLYPATH(\"AXES\",\"VECT\")",
    ];
    plain.contains(&name) || ["MSG(", "WORKPIECE(", "GROUP_BEGIN(", "GROUP_END("].iter().any(|n| name.starts_with(n))
}

fn component(word: &CodeWord, vector: &mut [Option<f64>; 3], letters: &str) -> Result<(), String> {
    let at = letters.find(&word.address[..1]).unwrap_or(0);
    match vector.get_mut(at) {
        Some(slot) => *slot = Some(word.number()?),
        None => return Err(format!("the word {} is not known", word.raw)),
    }
    Ok(())
}

/// A tool by number or by name.
fn tool(word: &CodeWord) -> Result<String, String> {
    let name = word.value.trim_matches('"');
    if name.len() + 2 == word.value.len() && !name.is_empty() {
        return Ok(name.to_owned());
    }
    Ok(word.count()?.to_string())
}

/// `CYCLE832(tolerance, kind, tolerance of the tool axis)`: the tolerance; `None` where it is taken
/// back.
fn high_speed_setting(word: &CodeWord, modal: &Modal) -> Result<Option<f64>, String> {
    let list = word.address.strip_prefix("CYCLE832(").and_then(|l| l.strip_suffix(')')).unwrap_or("?");
    let first = list.split(',').next().unwrap_or("");
    let tolerance = if first.is_empty() { 0.0 } else { word.number_of(first)? };
    Ok((tolerance > 0.0).then_some(if modal.inch { 25.4 * tolerance } else { tolerance }))
}

/// Preparatory functions.
pub(super) fn preparatory(word: &CodeWord, modal: &mut Modal, said: &mut LineWords) -> Result<(), String> {
    let value = word.value.trim_start_matches('0');
    match value {
        "" if word.value.is_empty() => return Err(format!("{} has no number", word.raw)),
        "" => modal.motion = Some(ModalMotion::Rapid),
        "1" => modal.motion = Some(ModalMotion::Straight),
        "2" => modal.motion = Some(ModalMotion::Arc { clockwise: true }),
        "3" => modal.motion = Some(ModalMotion::Arc { clockwise: false }),
        "6.2" => (modal.motion, said.begins_curve) = (Some(ModalMotion::Curve), true),
        "4" => said.bare = Some(Bare::Dwell),
        "17" => modal.plane = Plane::Xy,
        "18" => modal.plane = Plane::Zx,
        "19" => modal.plane = Plane::Yz,
        "20" | "70" | "700" => {
            modal.inch = true;
            // G70 of Siemens is for positions only.
            modal.inch_feed = value != "70" || !modal.siemens;
        }
        "21" | "71" | "710" => (modal.inch, modal.inch_feed) = (false, false),
        "43" => modal.length = true,
        "43.4" => modal.centre = Centre::Axes,
        "43.5" => modal.centre = Centre::Vectors,
        "49" => (modal.centre, modal.length) = (Centre::Off, false),
        "28" | "30" => said.home = true,
        "52" => said.frame = Some(Setting::Local),
        "68" => said.frame = Some(Setting::TurnAbout),
        "68.2" => said.frame = Some(Setting::Plane),
        "53.1" => said.bare = Some(Bare::Square),
        "69" => modal.frames.straight(),
        "90.1" => modal.centres = true,
        "91.1" => modal.centres = false,
        "10" | "92" | "92.1" | "51" | "51.1" | "16" | "7" | "7.1" | "12.1" | "68.3" | "68.4" => {
            return Err(format!("{}: it changes what coordinates mean, and is not read", word.raw));
        }
        "41" | "42" => return Err(format!("{}: compensation of the cutter's radius is not read", word.raw)),
        "73" | "74" | "76" | "81" | "82" | "83" | "84" | "85" | "86" | "87" | "88" | "89" => {
            return Err(format!("{}: cycles that move are not read", word.raw));
        }
        "53" => said.machine = true,
        "54" | "55" | "56" | "57" | "58" | "59" | "500" => frame(word, value, modal)?,
        "90" => modal.steps = false,
        "91" => modal.steps = true,
        "93" | "94" => {
            // The feed of one kind means nothing in the other.
            let inverse = value == "93";
            if inverse != modal.inverse {
                modal.feed = None;
            }
            modal.inverse = inverse;
        }
        // How near to the path corners are rounded.
        "64" => said.blends = true,
        // Looking ahead: on and off.
        "5" => said.bare = Some(Bare::Precision),
        "5.1" => said.bare = Some(Bare::Contour),
        "8" => said.bare = Some(Bare::Ahead),
        // Scaling off; with words it would be another function.
        "50" => said.bare = Some(Bare::Unscaled),
        // No radius, no polar coordinates, no cycle, ends of cycles, revolutions as they are.
        "40" | "15" | "80" | "98" | "99" | "97" => {}
        // Stops at corners, and smoothing by the tolerances of the machine.
        "9" | "60" | "61" | "61.1" | "601" | "602" | "603" | "642" | "643" | "644" | "645" => {}
        _ => return Err(format!("{} is not known", word.raw)),
    }
    Ok(())
}

/// A work offset: the first is the one that zero and part are given for.
fn frame(word: &CodeWord, value: &str, modal: &mut Modal) -> Result<(), String> {
    let number = value.parse().ok();
    if modal.placed && modal.frame != number {
        let before = modal.frame.map_or_else(|| "without one".into(), |f| format!("under G{f}"));
        return Err(format!("{}: the work offset changes after moves {before}, and one zero is given", word.raw));
    }
    modal.frame = number;
    Ok(())
}

/// Miscellaneous functions.
fn miscellaneous(word: &CodeWord, said: &mut LineWords) -> Result<(), String> {
    match word.count()? {
        2 | 30 => said.ends = true,
        17 => said.jump = Some(Jump::Done { ends_main: true }),
        98 => said.calls = true,
        99 => said.jump = Some(Jump::Done { ends_main: false }),
        3 | 13 => said.turning = Some(Turning::Right),
        4 | 14 => said.turning = Some(Turning::Left),
        5 | 19 => said.turning = Some(Turning::Off),
        6 => said.change = true,
        // Stops, coolant, clamps, gears, overrides.
        0 | 1 | 7 | 8 | 9 | 10 | 11 | 40..=45 | 48 | 49 => {}
        97 | 198 => return Err(format!("{}: subprograms in other files are not read", word.raw)),
        _ => return Err(format!("{} is not known", word.raw)),
    }
    Ok(())
}
