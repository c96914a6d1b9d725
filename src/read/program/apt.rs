//! APT cutter-location files, as CAM systems write them: blanks anywhere, major words with and
//! without a slash, the tool axis left out where it stays, `MSYS` as a frame, circles.
//!
//! A statement either is acted on, is known to be harmless, or is refused.

use super::arc::RADII_MM;
use super::block::{Arc, Block, Call, Centre, Destination, Feed, Interpolation, Script};
use super::unreadable;
use crate::artifact::program::{LengthOffset, Setting, Turning};
use crate::error::Result;
use crate::geometry::{Point, Rigid, Vector};

/// What a statement that is refused says.
type Read<T> = std::result::Result<T, String>;

/// The tool axis before the file says one.
const UPRIGHT: [f64; 3] = [0.0, 0.0, 1.0];
/// Vectors of a frame are of length 1 and square to one another within this: they are rounded.
const SQUARE: f64 = 1e-4;

/// Statements that move nothing: names, remarks, coolant, coordinates of the listing, colours and
/// tolerances of the CAM system, settings of the listing.
const HARMLESS: [&str; 24] = [
    "PARTNO", "PPRINT", "REMARK", "MACHIN", "COOLNT", "STOP", "OPSTOP", "PAINT", "DISPLY", "INTOL", "OUTTOL", "TOLER",
    "SEQNO", "LEADER", "DELAY", "CLPRNT", "NOPOST", "TPRINT", "TITLE", "SELECT", "SELCTL", "TOOLNO", "PRINT", "SYN",
];
/// Those of them whose line is free text.
const REMARKS: [&str; 3] = ["PARTNO", "PPRINT", "REMARK"];

/// How a number of FEDRAT is meant.
#[derive(Clone, Copy, Default, PartialEq)]
enum FeedUnit {
    /// In the file's unit a minute.
    #[default]
    Own,
    /// So many mm a minute.
    Minute(f64),
    /// So many mm a revolution.
    Turn(f64),
}

/// The unit of the file's lengths.
#[derive(Clone, Copy, Default, PartialEq)]
enum Unit {
    /// The file has not said one: mm.
    #[default]
    Unsaid,
    Millimetres,
    Inches,
}

/// State that stays from statement to statement.
#[derive(Default)]
struct AptReader {
    script: Script,
    feed: Option<(f64, FeedUnit)>,
    rapid: bool,
    unit: Unit,
    /// The tool axis; `None`: a new path has begun and not said it.
    axis: Option<[f64; 3]>,
    /// That of the path before.
    axis_before: Option<[f64; 3]>,
    /// From `MSYS`.
    frame: Rigid,
    /// The circle that the next GOTO ends.
    circle: Option<Arc>,
    /// The place that is known, mm, in the file's coordinates.
    at: Option<[f64; 3]>,
    setting: Setting,
    /// `FINI` has been read.
    closed: bool,
}

/// Reads a file.
///
/// # Errors
/// A statement that is not understood or does not end, with the line.
pub(super) fn read(text: &str) -> Result<Script> {
    let mut reader = AptReader::default();
    let mut statement = String::new();
    let mut open = None;
    for (i, raw) in text.lines().enumerate() {
        let line = i + 1;
        // What CAM systems write in remarks of the form `$$-> CSYS / …` are statements all the
        // same.
        let told = raw.trim_start().strip_prefix("$$").filter(|l| l.starts_with("->") && statement.is_empty());
        let remark = REMARKS.iter().find(|f| statement.is_empty() && raw.trim_start().starts_with(**f));
        // Behind one $ the statement goes on in the next line, behind two it is done.
        let (code, goes_on) = match (remark, told.unwrap_or(raw).split_once('$')) {
            (Some(remark), _) => (*remark, false),
            (None, Some((code, rest))) => (code, !rest.starts_with('$')),
            (None, None) => (told.unwrap_or(raw), false),
        };
        statement.push_str(code.trim());
        if goes_on {
            open = Some((line, raw));
            continue;
        }
        open = None;
        let whole = std::mem::take(&mut statement);
        reader.statement(line, &whole).map_err(|e| unreadable(line, raw, &e))?;
    }
    match open {
        Some((line, raw)) => Err(unreadable(line, raw, "the statement goes on in a line that the file does not have")),
        None => Ok(reader.script),
    }
}

impl AptReader {
    fn statement(&mut self, line: usize, whole: &str) -> Read<()> {
        let upper = whole.to_ascii_uppercase();
        let (major, minor) = upper.split_once('/').unwrap_or((&upper, ""));
        let major = major.split_whitespace().collect::<Vec<_>>().join(" ");
        let minor: Vec<&str> = minor.split(',').map(str::trim).filter(|m| !m.is_empty()).collect();
        if self.script.end.is_some() {
            if self.closed || major != "FINI" {
                self.script.behind.extend((!whole.is_empty()).then_some(line));
            }
            self.closed |= major == "FINI";
            return Ok(());
        }
        let circle = self.circle.is_some();
        match (&major[..], &minor[..]) {
            ("GOTO", words) => self.go(line, words)?,
            (_, _) if circle && !HARMLESS.contains(&&major[..]) && major != "FEDRAT" => {
                return Err("a circle must be followed by the GOTO that ends it".into());
            }
            ("RAPID", []) => self.rapid = true,
            ("LOADTL" | "LOAD", words) => self.load(line, &major, words)?,
            // Where home is, is the machine's: from then on nothing is known.
            ("GOHOME", []) => self.unknown(line),
            ("FROM", words) => self.from(line, words)?,
            ("GODLTA", words) => self.step(line, words)?,
            ("FEDRAT", words) => self.feed = Some(feedrate(words)?),
            ("UNITS", ["MM"]) => self.unit(Unit::Millimetres)?,
            ("UNITS", ["INCHES" | "INCH"]) => self.unit(Unit::Inches)?,
            ("SPINDL", words) => self.spindle(words)?,
            ("TLAXIS", words) => self.axis = Some(vector(words)?),
            ("MULTAX", [] | ["ON"]) => {}
            ("MULTAX", ["OFF"]) if self.axis.is_none_or(|a| a == UPRIGHT) => {}
            ("MULTAX", _) => return Err("MULTAX/OFF while the tool axis is not 0,0,1".into()),
            ("MSYS", words) => self.frame = self.msys(words)?,
            ("CIRCLE", words) => self.circle = Some(self.circle(words)?),
            ("CUTTER", words) => self.cutter(line, words)?,
            ("TLDATA", ["MILL", words @ ..]) => self.cutter(line, words)?,
            ("TOOL PATH", _) => {
                self.axis_before = self.axis.take().or(self.axis_before);
            }
            ("CUTCOM", ["OFF"]) | ("CYCLE", ["OFF"]) | ("" | "END-OF-PATH", []) => {}
            ("END", []) => self.script.ends(line),
            ("FINI", []) => {
                self.script.ends(line);
                self.closed = true;
            }
            ("ARC" | "TLON" | "INDIRV" | "TLLFT" | "TLRGT" | "GOFWD", _) => {
                return Err("arcs are read as CIRCLE/x,y,z,i,j,k,r with the GOTO that ends it".into());
            }
            ("->CSYS" | "-> CSYS", words) => own_frame(words)?,
            (told, _) if told.starts_with("->") => {}
            (plain, _) if HARMLESS.contains(&plain.split(' ').next().unwrap_or("")) => {}
            _ => return Err(format!("\"{major}\" is not known so")),
        }
        Ok(())
    }

    /// Lengths of the file, mm.
    fn unit_mm(&self) -> f64 {
        if self.unit == Unit::Inches { 25.4 } else { 1.0 }
    }

    fn push(&mut self, block: Block) {
        let tool_calls = self.script.calls.len();
        self.script.blocks.push(Block { tool_calls, setting: self.setting, frame: self.frame, ..block });
    }

    /// From here on it is not known where the tool is.
    fn unknown(&mut self, line: usize) {
        let unknown = Destination::Words { point: [Some(f64::NAN); 3], rotary: [None; 3] };
        self.push(Block { machine: true, ..Block::straight(line, unknown, Feed::Rapid) });
        self.at = None;
    }

    /// `LOADTL/1,ADJUST,1`, `LOAD/TOOL,1`.
    fn load(&mut self, line: usize, major: &str, words: &[&str]) -> Read<()> {
        let (tool, mut rest) = match (major, words) {
            ("LOAD", ["TOOL", tool, rest @ ..]) | ("LOADTL", [tool, rest @ ..]) => (number(tool)?.to_string(), rest),
            _ => return Err(format!("{major} is read with the number of a tool")),
        };
        while let [word, behind @ ..] = rest {
            rest = match (*word, behind) {
                // Registers of the offset, of the length, and lengths that are given.
                ("ADJUST" | "OSETNO" | "LENGTH" | "SETOOL" | "ZOFF" | "CUTCOM", [value, behind @ ..]) => {
                    number(value)?;
                    behind
                }
                (plain, behind) if plain == "AUTO" || plain == "MANUAL" || number(plain).is_ok() => behind,
                _ => return Err(format!("\"{word}\" is not known in {major}")),
            };
        }
        self.setting.length = if tool == "0" { LengthOffset::Off } else { LengthOffset::Unsaid };
        self.setting.turning = Turning::Off;
        self.script.calls.push(Call { line, tool: Some(tool) });
        Ok(())
    }

    fn unit(&mut self, unit: Unit) -> Read<()> {
        let said = unit == Unit::Inches || self.unit == Unit::Inches;
        let begun =
            !(self.script.blocks.is_empty() && self.script.cutters.is_empty()) || self.frame != Rigid::identity();
        let own = matches!(self.feed, Some((_, FeedUnit::Own)));
        if unit != self.unit && said && (begun || own) {
            return Err("the unit changes within the program".into());
        }
        self.unit = unit;
        Ok(())
    }

    /// `SPINDL/6000,CLW`, `SPINDL/RPM,6000`, `SPINDL/ON`, `SPINDL/OFF`.
    fn spindle(&mut self, words: &[&str]) -> Read<()> {
        let mut turning = Turning::Right;
        for word in words {
            match *word {
                "OFF" => turning = Turning::Off,
                "CCLW" => turning = Turning::Left,
                "CLW" | "ON" | "RPM" => {}
                _ => self.setting.rpm = Some(number(word)?),
            }
        }
        self.setting.turning = turning;
        Ok(())
    }

    /// `CUTTER/d,r` and `CUTTER/d,r,e,f,a,b,h`: a ball has its corner on the axis.
    fn cutter(&mut self, line: usize, words: &[&str]) -> Read<()> {
        let v = words.iter().take(7).map(|w| Ok(number(w)? * self.unit_mm())).collect::<Read<Vec<f64>>>()?;
        let (d, r) = match v[..] {
            [d] => (d, 0.0),
            // The diameter is that of the cone where it is tapered.
            [_, r, 0.0, _, _, _, _] if r > 0.0 => (2.0 * r, r),
            [d, r, ..] => (d, r),
            [] => return Err("a cutter without a diameter".into()),
        };
        self.script.cutters.push((line, [d, r]));
        Ok(())
    }

    /// `FROM/x,y,z,i,j,k`: where the tool is, without a move.
    fn from(&mut self, line: usize, words: &[&str]) -> Read<()> {
        if !self.script.blocks.is_empty() {
            self.unknown(line);
        }
        let place = self.place(words)?;
        self.push(Block::straight(line, place, Feed::Rapid));
        Ok(())
    }

    /// `GODLTA/dx,dy,dz`: steps.
    fn step(&mut self, line: usize, words: &[&str]) -> Read<()> {
        let [dx, dy, dz] = vector(words).map_err(|_| "GODLTA is read with dx, dy, dz")?;
        let unit_mm = self.unit_mm();
        let at = self.at.ok_or("GODLTA from a place that the file has not said")?;
        let to: [f64; 3] = std::array::from_fn(|i| at[i] + [dx, dy, dz][i] * unit_mm);
        let axis = self.axis_of_path()?;
        self.moves(line, to, axis)
    }

    /// `GOTO/x,y,z` and `GOTO/x,y,z,i,j,k`.
    fn go(&mut self, line: usize, words: &[&str]) -> Read<()> {
        let place = self.place(words)?;
        let Destination::Vector { point: [Some(x), Some(y), Some(z)], axis } = place else { return Ok(()) };
        self.moves(line, [x, y, z], axis)
    }

    /// Place and tool axis of a statement.
    fn place(&mut self, words: &[&str]) -> Read<Destination> {
        let v = words.iter().map(|n| number(n)).collect::<Read<Vec<f64>>>()?;
        let (x, y, z) = match v[..] {
            [x, y, z] => (x, y, z),
            [x, y, z, i, j, k] => {
                self.axis = Some([i, j, k]);
                (x, y, z)
            }
            _ => return Err("a place needs x, y, z or x, y, z, i, j, k".into()),
        };
        let point = [x, y, z].map(|c| c * self.unit_mm());
        self.at = Some(point);
        Ok(Destination::Vector { point: point.map(Some), axis: self.axis_of_path()? })
    }

    /// The tool axis, where a statement leaves it out.
    fn axis_of_path(&mut self) -> Read<[f64; 3]> {
        if self.axis.is_none() && self.axis_before.is_some_and(|a| a != UPRIGHT) {
            return Err("a new TOOL PATH has not said its tool axis, and that of the one before was not 0,0,1".into());
        }
        Ok(*self.axis.get_or_insert(UPRIGHT))
    }

    fn moves(&mut self, line: usize, to: [f64; 3], axis: [f64; 3]) -> Read<()> {
        let feed = match (std::mem::take(&mut self.rapid), self.feed) {
            (true, _) => Feed::Rapid,
            (false, Some((value, unit))) => Feed::PerMinute(match unit {
                FeedUnit::Own => value * self.unit_mm(),
                FeedUnit::Minute(mm) => value * mm,
                FeedUnit::Turn(mm) => match self.setting.rpm {
                    Some(rpm) if rpm > 0.0 => value * mm * rpm,
                    _ => return Err("a feed for each revolution before the spindle has a speed".into()),
                },
            }),
            (false, None) => return Err("GOTO before any FEDRAT".into()),
        };
        if self.unit == Unit::Unsaid
            && matches!(self.feed, Some((_, FeedUnit::Minute(mm) | FeedUnit::Turn(mm))) if mm != 1.0)
        {
            return Err("FEDRAT is in inches and the file does not say in what its lengths are; put UNITS/INCHES or UNITS/MM at its beginning".into());
        }
        let course = match self.circle.take() {
            Some(_) if feed == Feed::Rapid => return Err("a circle in a rapid".into()),
            Some(arc) => Interpolation::Arc(arc),
            None => Interpolation::Straight,
        };
        self.at = Some(to);
        let place = Destination::Vector { point: to.map(Some), axis };
        self.push(Block { course, ..Block::straight(line, place, feed) });
        Ok(())
    }

    /// `MSYS/x,y,z,` X axis, Y axis: the frame that all coordinates are in.
    fn msys(&mut self, words: &[&str]) -> Read<Rigid> {
        let v = words.iter().map(|n| number(n)).collect::<Read<Vec<f64>>>()?;
        let &[x, y, z, a, b, c, d, e, f] = &v[..] else {
            return Err("MSYS needs its origin, its X axis and its Y axis".into());
        };
        let origin = [x, y, z].map(|c| c * self.unit_mm());
        let [x, y] = [Vector::new(a, b, c), Vector::new(d, e, f)];
        let off = [x.norm() - 1.0, y.norm() - 1.0, x.dot(&y)];
        if !off.iter().all(|v| v.abs() <= SQUARE) {
            return Err("the axes of MSYS are not of length 1 and square to one another".into());
        }
        let x = x.normalize();
        let z = x.cross(&y).normalize();
        let turned = nalgebra::Rotation3::from_matrix_unchecked(nalgebra::Matrix3::from_columns(&[x, z.cross(&x), z]));
        let frame = Rigid::from_parts(origin.into(), nalgebra::UnitQuaternion::from_rotation_matrix(&turned));
        // The tool stays where it is.
        self.at = self.at.map(|at| (frame.inverse() * self.frame * Point::from(at)).into());
        Ok(frame)
    }

    /// `CIRCLE/x,y,z,i,j,k,r` and what gives its tolerances: counter-clockwise about i, j, k.
    fn circle(&self, words: &[&str]) -> Read<Arc> {
        let v = words.iter().map(|n| number(n)).collect::<Read<Vec<f64>>>()?;
        let &[x, y, z, i, j, k, r, ..] = &v[..] else {
            return Err("CIRCLE needs its centre, its axis and its radius".into());
        };
        let ([centre, axis], r) = ([[x, y, z].map(|c| c * self.unit_mm()), [i, j, k]], r * self.unit_mm());
        if let (Some(at), Some(axis)) = (self.at, Vector::from(axis).try_normalize(0.0)) {
            let away = axis.cross(&(Vector::from(at) - Vector::from(centre))).norm();
            if (away - r).abs() > RADII_MM {
                return Err(format!("the circle has a radius of {r:.4} mm and begins {away:.4} mm from its axis"));
            }
        }
        Ok(Arc { centre: Centre::At(centre), axis, turns: 0 })
    }
}

/// `FEDRAT/200,MMPM`, `FEDRAT/IPM,8`, `FEDRAT/0.1,MMPR`.
fn feedrate(words: &[&str]) -> Read<(f64, FeedUnit)> {
    let (mut feed, mut unit) = (None, FeedUnit::Own);
    for word in words {
        match *word {
            "MMPM" => unit = FeedUnit::Minute(1.0),
            "IPM" => unit = FeedUnit::Minute(25.4),
            "MMPR" => unit = FeedUnit::Turn(1.0),
            "IPR" => unit = FeedUnit::Turn(25.4),
            "PERMIN" => {}
            _ if feed.is_none() => feed = Some(number(word)?),
            _ => return Err(format!("\"{word}\" is not known in FEDRAT")),
        }
    }
    let feed = feed.filter(|f| *f > 0.0).ok_or("FEDRAT needs a number greater than 0")?;
    Ok((feed, unit))
}

/// `CSYS` of a remark: the coordinates may be in no other frame than that of the part.
fn own_frame(words: &[&str]) -> Read<()> {
    let v = words.iter().map(|n| number(n)).collect::<Read<Vec<f64>>>()?;
    let unit = [1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0];
    (v == unit).then_some(()).ok_or_else(|| "a frame that is told in a remark; only MSYS is read as a frame".into())
}

/// Three numbers.
fn vector(words: &[&str]) -> Read<[f64; 3]> {
    let v = words.iter().map(|n| number(n)).collect::<Read<Vec<f64>>>()?;
    v.try_into().map_err(|_| "three numbers are wanted".into())
}

fn number(text: &str) -> Read<f64> {
    let value = text.parse::<f64>().ok().filter(|v| v.is_finite());
    value.ok_or_else(|| format!("\"{text}\" is not a number"))
}
