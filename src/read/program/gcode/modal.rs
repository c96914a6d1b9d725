//! What stays from line to line, and the move that it makes of the words of a line.

use super::frames::Frames;
use super::nurbs::CurvePiece;
use super::{LineWords, axes};
use crate::artifact::program::{LengthOffset, Setting};
use crate::geometry::Vector;
use crate::read::program::block::{Arc, Block, Centre as ArcCentre, Destination, Feed, Interpolation, RotaryWay};

/// How a line goes.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum ModalMotion {
    Rapid,
    Straight,
    Polynomial,
    /// `G06.2`.
    Curve,
    /// `G2` and `G3`.
    Arc {
        clockwise: bool,
    },
}

/// The plane of arcs.
#[derive(Clone, Copy, Default, PartialEq, Eq)]
pub(super) enum Plane {
    /// `G17`.
    #[default]
    Xy,
    /// `G18`.
    Zx,
    /// `G19`.
    Yz,
}

impl Plane {
    /// The axis that arcs go round, those of `G3` counter-clockwise.
    pub fn normal(self) -> Vector {
        match self {
            Plane::Xy => Vector::z(),
            Plane::Zx => Vector::y(),
            Plane::Yz => Vector::x(),
        }
    }
}

/// Tool-centre-point control.
#[derive(Clone, Copy, Default, PartialEq, Eq)]
pub(super) enum Centre {
    #[default]
    Off,
    /// `G43.4`.
    Axes,
    /// `G43.5`.
    Vectors,
    /// `TRAORI`.
    Transformation,
}

/// State that stays from line to line.
#[derive(Default)]
pub(super) struct Modal {
    /// The text has words that only Siemens knows: `D` is the length of the tool then.
    pub siemens: bool,
    /// Something has been said: no program may begin any more.
    pub begun: bool,
    pub motion: Option<ModalMotion>,
    pub plane: Plane,
    /// `G90.1`: centres of arcs are places.
    pub centres: bool,
    pub frames: Frames,
    /// `ORIVECT`.
    pub great_circle: bool,
    pub inverse: bool,
    pub steps: bool,
    pub inch: bool,
    pub inch_feed: bool,
    pub centre: Centre,
    /// The line that switched on `G43.4` or `G43.5`.
    pub fixed_by: Option<usize>,
    /// `G43`.
    pub length: bool,
    /// `H`.
    pub number: Option<u32>,
    /// `D`.
    pub edge: Option<u32>,
    /// `ORIMKS`.
    pub machine_vectors: bool,
    /// `UPATH`.
    pub with_path: bool,
    pub feed: Option<f64>,
    pub setting: Setting,
    pub frame: Option<u32>,
    /// X, Y or Z have been moved in the program's coordinates.
    pub placed: bool,
    /// The tool that the next change brings.
    pub selected: Option<String>,
}

impl Modal {
    /// The move that a line asks for, if any.
    pub fn block(
        &mut self,
        line: usize,
        motion: Option<ModalMotion>,
        said: LineWords,
    ) -> std::result::Result<Option<Block>, String> {
        if let Some(f) = said.feed {
            self.feed = Some(if self.inch_feed && !self.inverse { 25.4 * f } else { f });
        }
        if !said.moves() {
            return Ok(None);
        }
        let motion = motion.ok_or("a move before G0 or G1")?;
        let feed = self.feed(motion, said.feed)?;
        let place = self.place(motion, &said)?;
        let course = match motion {
            ModalMotion::Polynomial => Interpolation::Bent(axes::bend(&said, self.with_path)?),
            ModalMotion::Curve => return Err("a move within a curve".into()),
            ModalMotion::Arc { clockwise } => Interpolation::Arc(self.arc(clockwise, &said)?),
            ModalMotion::Rapid | ModalMotion::Straight if said.radius.is_some() || said.turns.is_some() => {
                return Err("words of an arc without G2 or G3".into());
            }
            ModalMotion::Rapid | ModalMotion::Straight => Interpolation::Straight,
        };
        let usual = if self.steps { RotaryWay::By } else { RotaryWay::To };
        let [point_ways, ways] = said.ways.map(|of| of.map(|way| way.unwrap_or(usual)));
        let steps = point_ways.map(|way| way == RotaryWay::By);
        if said.machine && matches!(course, Interpolation::Arc(_)) {
            return Err("an arc in positions of the axes is not read".into());
        }
        if said.machine && said.point.iter().zip(steps).any(|(word, step)| word.is_some() && step) {
            return Err("steps in positions of the axes are not read".into());
        }
        self.placed |= !said.machine && said.point.iter().any(Option::is_some);
        let block = Block { steps, ways, course, machine: said.machine, ..self.as_set(line, place, feed)? };
        Ok(Some(Block { tool_length: block.tool_length && (!said.machine || said.with_length), ..block }))
    }

    /// A straight move to a place under what is set.
    fn as_set(&self, line: usize, place: Destination, feed: Feed) -> std::result::Result<Block, String> {
        let (centre_point, length) = (self.centre != Centre::Off, self.offset()?);
        // Under tool-centre-point control the length is in the transformation.
        let added = matches!(length, LengthOffset::Number(_) | LengthOffset::Edge(_)) && !centre_point;
        Ok(Block {
            great_circle: self.great_circle,
            frame: self.frames.all(),
            in_plane: self.frames.has_plane() && !centre_point,
            tool_length: added,
            centre_point,
            fixed_by: self.fixed_by,
            setting: Setting { length, ..self.setting },
            ..Block::straight(line, place, feed)
        })
    }

    /// A curve begins: what is set lets it, and its F counts.
    pub fn curve(&mut self, said: &LineWords) -> std::result::Result<(), String> {
        if self.inverse || self.steps || self.inch || said.machine {
            return Err("G06.2 is read under G90, G94 and in mm".into());
        }
        self.feed = said.feed.or(self.feed);
        self.placed |= said.point.iter().any(Option::is_some);
        Ok(())
    }

    /// A piece of a curve.
    pub fn piece(&self, piece: CurvePiece) -> std::result::Result<Block, String> {
        let feed = self.feed(ModalMotion::Curve, None)?;
        let block = self.as_set(piece.line, piece.place, feed)?;
        Ok(Block { course: Interpolation::Bent(piece.bend), ..block })
    }

    /// The arc of a line.
    fn arc(&self, clockwise: bool, said: &LineWords) -> std::result::Result<Arc, String> {
        let normal = self.plane.normal();
        let scale = if self.inch { 25.4 } else { 1.0 };
        let said_centre: [Option<f64>; 3] = said.ijk.map(|v| v.map(|v| scale * v));
        let across = (0..3).any(|i| normal[i] != 0.0 && said_centre[i].is_some());
        let centre = match (said_centre.iter().any(Option::is_some), said.radius) {
            (false, Some(r)) => ArcCentre::Radius(r),
            (true, None) if across => return Err("the centre of an arc across its plane".into()),
            (true, None) if self.centres => {
                if (0..3).any(|i| normal[i] == 0.0 && said_centre[i].is_none()) {
                    return Err("under G90.1 an arc needs both coordinates of its centre".into());
                }
                ArcCentre::At(said_centre.map(|v| v.unwrap_or(0.0)))
            }
            (true, None) => ArcCentre::FromStart(said_centre.map(|v| v.unwrap_or(0.0))),
            (true, Some(_)) => return Err("an arc with centre and radius".into()),
            (false, None) => return Err("an arc without I, J, K or radius".into()),
        };
        let by_p = said.p.map(|p| p - 1.0).filter(|p| p.fract() == 0.0 && (0.0..1e6).contains(p));
        let turns = match (said.p, by_p, said.turns) {
            (None, _, turns) => turns.unwrap_or(0),
            (Some(_), Some(p), None) => p as u32,
            _ => return Err("the turns of an arc are no whole number".into()),
        };
        let axis = if clockwise { -normal } else { normal };
        Ok(Arc { centre, axis: axis.into(), turns })
    }

    /// Axes that are where the machine says.
    pub fn unknown(&self, line: usize, point: [bool; 3], rotary: [bool; 3]) -> Block {
        let words = |of: [bool; 3]| of.map(|said| said.then_some(f64::NAN));
        let place = Destination::Words { point: words(point), rotary: words(rotary) };
        Block {
            machine: true,
            centre_point: false,
            fixed_by: self.fixed_by,
            setting: self.setting,
            ..Block::straight(line, place, Feed::Rapid)
        }
    }

    /// `G28`, `G30`: the axes that are named, or all, at their reference positions.
    pub fn gone(&self, line: usize, said: &LineWords) -> Block {
        let named = [said.point, said.rotary].map(|of| of.map(|word| word.is_some()));
        let all = !named.as_flattened().contains(&true);
        self.unknown(line, named[0].map(|n| n || all), named[1].map(|n| n || all))
    }

    /// The rotary axes turn the tool square to the plane.
    pub fn square(&self, line: usize) -> Block {
        let place = Destination::Vector { point: [None; 3], axis: [0.0, 0.0, 1.0] };
        Block {
            centre_point: false,
            in_plane: true,
            frame: self.frames.all(),
            fixed_by: self.fixed_by,
            setting: self.setting,
            ..Block::straight(line, place, Feed::Rapid)
        }
    }

    fn feed(&self, motion: ModalMotion, said: Option<f64>) -> std::result::Result<Feed, String> {
        let feed = match (motion, self.inverse, said, self.feed) {
            (ModalMotion::Rapid, ..) => Feed::Rapid,
            (_, true, Some(f), _) => Feed::PerMove(f),
            (_, true, None, _) => return Err("under G93 every line needs its own F".into()),
            (_, false, _, Some(f)) => Feed::PerMinute(f),
            (_, false, _, None) => return Err("a feed move before any F".into()),
        };
        match feed {
            Feed::PerMove(f) | Feed::PerMinute(f) if f <= 0.0 => Err("F must be greater than 0".into()),
            _ => Ok(feed),
        }
    }

    fn place(&self, motion: ModalMotion, said: &LineWords) -> std::result::Result<Destination, String> {
        let [ijk, abc3] = [said.ijk, said.abc3].map(|v| v.iter().any(Option::is_some));
        if (!ijk || matches!(motion, ModalMotion::Arc { .. })) && !abc3 {
            return Ok(Destination::Words { point: said.point, rotary: said.rotary });
        }
        if motion == ModalMotion::Polynomial {
            return Err("vectors under POLY are not read".into());
        }
        if matches!(motion, ModalMotion::Arc { .. }) {
            return Err("vectors along an arc are not read".into());
        }
        if ijk && (abc3 || self.centre != Centre::Vectors) {
            return Err("I, J and K are read as the tool axis under G43.5 only".into());
        }
        if abc3 && self.centre != Centre::Transformation {
            return Err("A3, B3 and C3 are read under TRAORI only".into());
        }
        if abc3 && self.machine_vectors {
            return Err("a tool axis in the machine's frame (ORIMKS) is not read".into());
        }
        if said.rotary.iter().any(Option::is_some) {
            return Err("a vector and words of rotary axes in one line".into());
        }
        // A component that is left out is 0.
        let axis = if ijk { said.ijk } else { said.abc3 }.map(|v| v.unwrap_or(0.0));
        Ok(Destination::Vector { point: said.point, axis })
    }

    /// Where the length of the tool comes from.
    fn offset(&self) -> std::result::Result<LengthOffset, String> {
        let by_number = self.length || matches!(self.centre, Centre::Axes | Centre::Vectors);
        Ok(match (by_number, self.number, self.edge) {
            (true, Some(0), _) => LengthOffset::Off,
            (true, Some(n), _) => LengthOffset::Number(n),
            (true, None, _) => return Err("a length offset (G43) without its H".into()),
            (false, _, Some(0)) if self.siemens => LengthOffset::Off,
            (false, _, Some(n)) if self.siemens => LengthOffset::Edge(n),
            (false, ..) => LengthOffset::Unsaid,
        })
    }
}
