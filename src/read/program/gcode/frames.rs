//! Frames that a program sets itself: shifts and turns of Siemens (`TRANS`, `ROT`, and `ATRANS`,
//! `AROT` on top of them), its swivelled plane (`CYCLE800`), the local shift `G52`, the turn `G68`
//! and the tilted plane `G68.2` of Fanuc.

use super::words::CodeWord;
use super::{LineWords, Modal};
use crate::geometry::{Rigid, Vector};

/// A line that sets a frame, with the words that it takes.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Setting {
    /// `TRANS`, `ATRANS` where it is added.
    Shift { added: bool },
    /// `ROT`, `AROT` where it is added.
    Turn { added: bool },
    /// `G52`.
    Local,
    /// `G68`.
    TurnAbout,
    /// `G68.2`.
    Plane,
}

/// The frames that are set.
#[derive(Clone, Copy, Default)]
pub(super) struct Frames {
    /// `G52`.
    local: [f64; 3],
    /// `CYCLE800`, `G68.2`.
    plane: Option<Rigid>,
    /// `TRANS`, `ROT`; `G68`.
    own: Rigid,
}

/// What `CYCLE800` does beside setting its plane.
pub(super) struct Swivel {
    /// The linear axes are retracted to where the machine says, or follow the tool tip.
    pub goes_away: bool,
    /// The rotary axes turn the tool square to the plane.
    pub turns: bool,
}

impl Frames {
    /// Coordinates of a line to those of the work offset.
    pub fn all(&self) -> Rigid {
        let [x, y, z] = self.local;
        Rigid::translation(x, y, z) * self.plane.unwrap_or_default() * self.own
    }

    /// Whether a plane is tilted.
    pub fn has_plane(&self) -> bool {
        self.plane.is_some()
    }

    /// `G69`.
    pub fn straight(&mut self) {
        (self.plane, self.own) = (None, Rigid::identity());
    }
}

/// The turn about an axis, degrees.
fn about(axis: Vector, degrees: f64) -> Rigid {
    Rigid::rotation(axis * degrees.to_radians())
}

/// Sets a frame by the words of its line.
///
/// # Errors
/// Words that it does not take.
pub(super) fn set(setting: Setting, said: &LineWords, modal: &mut Modal) -> Result<(), String> {
    let others = [&said.rotary, &said.abc3].into_iter().flatten().any(Option::is_some);
    let ijk = said.ijk.iter().any(Option::is_some);
    let takes_angle = matches!(setting, Setting::Turn { .. } | Setting::TurnAbout);
    if others || said.feed.is_some() || said.p.is_some() || said.q.is_some() {
        return Err("a frame of the program with words that are not read with it".into());
    }
    if said.ways[0].iter().any(Option::is_some) || ijk != (setting == Setting::Plane) && ijk {
        return Err("a frame of the program with words that are not read with it".into());
    }
    if said.radius.is_some() && setting != Setting::TurnAbout || said.in_plane_deg.is_some() && !takes_angle {
        return Err("an angle with a frame that does not turn".into());
    }
    let shift: Vector = said.point.map(|v| v.unwrap_or(0.0)).into();
    let frames = &mut modal.frames;
    match setting {
        Setting::Shift { added } => {
            let before = if added { frames.own } else { Rigid::identity() };
            frames.own = before * Rigid::translation(shift.x, shift.y, shift.z);
        }
        Setting::Turn { added } => {
            let before = if added { frames.own } else { Rigid::identity() };
            // Words of X, Y, Z are angles here.
            let scale = if modal.inch { 25.4 } else { 1.0 };
            let turns: Vec<(usize, f64)> = (0..3).filter_map(|i| said.point[i].map(|v| (i, v / scale))).collect();
            let turn = match (&turns[..], said.in_plane_deg) {
                ([], None) => Rigid::identity(),
                ([], Some(angle)) => about(modal.plane.normal(), angle),
                ([(i, angle)], None) => about(Vector::ith(*i, 1.0), *angle),
                _ => {
                    return Err(
                        "several turns in one ROT go in an order that machine data say; write one a line".into()
                    );
                }
            };
            frames.own = before * turn;
        }
        Setting::Local => {
            if frames.plane.is_some() || frames.own != Rigid::identity() {
                return Err("G52 while the frame is turned is not read".into());
            }
            for (to, word) in frames.local.iter_mut().zip(said.point) {
                *to = word.unwrap_or(*to);
            }
        }
        Setting::TurnAbout => {
            let angle = said.radius.ok_or("G68 without its angle R")?;
            let angle = if modal.inch { angle / 25.4 } else { angle };
            let normal = modal.plane.normal();
            let missing = (0..3).any(|i| normal[i] == 0.0 && said.point[i].is_none());
            if missing || modal.steps || frames.plane.is_some() || frames.own != Rigid::identity() {
                return Err("G68 is read once, under G90, with both coordinates of its centre and R".into());
            }
            let centre = shift - normal * normal.dot(&shift);
            let turned = about(normal, angle);
            frames.own = Rigid::from_parts((centre - turned.rotation * centre).into(), turned.rotation);
        }
        Setting::Plane => {
            if frames.plane.is_some() || frames.own != Rigid::identity() || modal.steps {
                return Err("G68.2 is read once, under G90, before any other turn; G69 takes it back".into());
            }
            let [i, j, k] = said.ijk.map(|v| v.unwrap_or(0.0));
            let turned = about(Vector::z(), i) * about(Vector::x(), j) * about(Vector::z(), k);
            frames.plane = Some(Rigid::translation(shift.x, shift.y, shift.z) * turned);
        }
    }
    Ok(())
}

/// `CYCLE800(FR, TC, ST, MODE, X0, Y0, Z0, A, B, C, X1, Y1, Z1, DIR, …)`: a plane by turns about
/// axes, one after the other; without words it is taken back.
///
/// # Errors
/// Words that are not read.
pub(super) fn swivel(word: &CodeWord, modal: &mut Modal) -> Result<Option<Swivel>, String> {
    let list = word.address.strip_prefix("CYCLE800(").and_then(|l| l.strip_suffix(')')).unwrap_or("?");
    if modal.frames.own != Rigid::identity() {
        return Err("CYCLE800 after TRANS or ROT is not read".into());
    }
    if list.is_empty() {
        modal.frames.plane = None;
        return Ok(None);
    }
    let list: Vec<&str> = list.split(',').collect();
    let number = |k: usize| match list.get(k) {
        None | Some(&"") => Ok(0.0),
        Some(text) => word.number_of(text),
    };
    let count = |k: usize| -> Result<u32, String> {
        let n = number(k)?;
        let whole = n.fract() == 0.0 && (0.0..1e9).contains(&n);
        whole.then_some(n as u32).ok_or_else(|| format!("{} is not read so", word.raw))
    };
    let name = list.get(1).map_or("", |n| n.trim_matches('"'));
    let (retract, state, mode) = (count(0)?, count(2)?, count(3)?);
    if name == "0" || state % 10 != 0 || mode >> 6 != 0 || list.len() > 18 {
        return Err("CYCLE800 is read as a new plane, swivelled axis by axis".into());
    }
    let scale = if modal.inch { 25.4 } else { 1.0 };
    let shift = |from: usize| -> Result<Rigid, String> {
        Ok(Rigid::translation(scale * number(from)?, scale * number(from + 1)?, scale * number(from + 2)?))
    };
    let mut turned = Rigid::identity();
    for k in 0..3 {
        let axis = match mode >> (2 * k) & 3 {
            1 => Vector::x(),
            2 => Vector::y(),
            3 => Vector::z(),
            _ if number(7 + k)? == 0.0 => continue,
            _ => return Err("CYCLE800 turns about an axis that its mode does not say".into()),
        };
        turned *= about(axis, number(7 + k)?);
    }
    modal.frames.plane = Some(shift(4)? * turned * shift(10)?);
    Ok(Some(Swivel { goes_away: retract != 0 || state / 10 % 10 != 0, turns: number(13)? != 0.0 }))
}
