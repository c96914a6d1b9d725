//! The records of an IGES file: global section, directory, and the parameters of an entity with
//! readable errors.

use std::path::Path;

use nalgebra::Matrix4;

use super::text::{FileSections, Value, sections, values};
use crate::error::{Error, Result, Stage};

/// Chains of transforms longer than this are taken for circular.
const DEEPEST: usize = 32;

/// What the global section says that matters here.
#[derive(Clone, Debug, PartialEq)]
pub struct Global {
    parameter_delimiter: u8,
    record_delimiter: u8,
    /// Model space over real space.
    pub scale: f64,
    /// Unit flag, 1 to 11.
    pub unit_flag: i64,
    /// Unit name.
    pub unit_name: String,
    /// Version flag: 11 for IGES 5.3.
    pub version: i64,
}

/// One entity of the directory.
#[derive(Clone, Debug)]
pub struct Entity {
    /// Type number.
    pub kind: u32,
    /// Form number.
    pub form: i64,
    /// Sequence number of its first directory line: its name in messages and pointers.
    pub line: usize,
    /// Index of the first parameter line.
    first: usize,
    /// Number of parameter lines; 0: as many as it takes.
    count: usize,
    /// Directory line of its transform, 0 for none.
    transform: i64,
    /// Not to be shown.
    pub blanked: bool,
    /// Physically part of another entity.
    pub subordinate: bool,
}

/// A file.
pub struct File<'a> {
    path: &'a Path,
    /// The global section.
    pub global: Global,
    /// The directory, in its order.
    pub entities: Vec<Entity>,
    parameters: Vec<&'a [u8]>,
    bytes: usize,
}

impl<'a> File<'a> {
    /// Reads sections, global section and directory.
    ///
    /// # Errors
    /// `InputOutput`: a file that is no IGES, is cut off, or has a directory that cannot be read.
    pub fn new(path: &'a Path, bytes: &'a [u8]) -> Result<Self> {
        let broken = |what: String| {
            Error::io(Stage::Model, format!("{} {what}", path.display()))
                .advise("the file is damaged or no IGES: export it again as ASCII IGES 5.3")
        };
        let FileSections { global, directory, parameters } = sections(bytes).map_err(broken)?;
        let global = read_global(&global).map_err(|m| broken(format!("has a damaged global section: {m}")))?;
        if directory.len() % 2 == 1 {
            return Err(broken("has an odd number of directory lines".into()));
        }
        let entities = directory
            .chunks_exact(2)
            .enumerate()
            .map(|(k, pair)| {
                let line = 2 * k + 1;
                entry(pair[0], pair[1], line).map_err(|m| broken(format!("has a damaged directory line {line}: {m}")))
            })
            .collect::<Result<_>>()?;
        Ok(File { path, global, entities, parameters, bytes: bytes.len() })
    }

    /// Control points that a model of this file's size can need: a file that names one large curve
    /// or surface again and again must not fill the memory.
    pub fn most_poles(&self) -> usize {
        200_000 + 4 * self.bytes
    }

    /// The entity that a directory line names.
    pub fn entity(&self, line: usize) -> Option<&Entity> {
        (line % 2 == 1).then(|| self.entities.get(line / 2)).flatten()
    }

    /// An error about an entity.
    pub fn error(&self, e: &Entity, what: impl std::fmt::Display) -> Error {
        Error::io(Stage::Model, format!("{}: entity {} at D{} {what}", self.path.display(), e.kind, e.line))
            .advise("repair the model in CAD and export it again as ASCII IGES 5.3")
    }

    /// The parameters of an entity, behind its type number.
    ///
    /// # Errors
    /// Parameters that are missing or cannot be read, or belong to another type.
    pub fn params<'f>(&'f self, e: &'f Entity) -> Result<Params<'f>> {
        let from = self.parameters.get(e.first..).filter(|l| !l.is_empty());
        let lines =
            from.ok_or_else(|| self.error(e, format!("points at the missing parameter line {}", e.first + 1)))?;
        let count = if e.count == 0 { lines.len() } else { e.count };
        let mut text = Vec::new();
        for line in lines.iter().take(count) {
            text.extend_from_slice(line);
            // Without a count the record ends with its delimiter; texts that contain one are rare
            // enough.
            if e.count == 0 && line.contains(&self.global.record_delimiter) {
                break;
            }
        }
        let found = values(&text, self.global.parameter_delimiter, self.global.record_delimiter)
            .map_err(|m| self.error(e, format!("has damaged parameters: {m}")))?;
        if found.first() != Some(&Value::Number(f64::from(e.kind))) {
            return Err(self.error(e, format!("has parameters of another type on line P{}", e.first + 1)));
        }
        Ok(Params { file: self, entity: e, values: found, next: 1 })
    }

    /// What an entity's own transform does, with the transforms of the transform; file units.
    ///
    /// # Errors
    /// A transform that is missing, is no transform, or refers to itself.
    pub fn transform(&self, e: &Entity) -> Result<Matrix4<f64>> {
        let mut out = Matrix4::identity();
        let mut at = e;
        for _ in 0..DEEPEST {
            if at.transform == 0 {
                return Ok(out);
            }
            let next = usize::try_from(at.transform).ok().and_then(|l| self.entity(l)).filter(|t| t.kind == 124);
            let next =
                next.ok_or_else(|| self.error(at, format!("names D{} as its transform, which is none", at.transform)))?;
            let mut p = self.params(next)?;
            let mut m = Matrix4::identity();
            for row in 0..3 {
                for column in 0..4 {
                    m[(row, column)] = p.real()?;
                }
            }
            out = m * out;
            at = next;
        }
        Err(self.error(e, format!("has more than {DEEPEST} transforms on one another")))
    }
}

/// The parameters of an entity, read one after the other.
pub struct Params<'f> {
    file: &'f File<'f>,
    entity: &'f Entity,
    values: Vec<Value>,
    next: usize,
}

impl Params<'_> {
    /// How many are left.
    pub fn left(&self) -> usize {
        self.values.len().saturating_sub(self.next)
    }

    /// An error about this entity.
    pub fn error(&self, what: impl std::fmt::Display) -> Error {
        self.file.error(self.entity, what)
    }

    /// Passes over parameters.
    pub fn skip(&mut self, n: usize) {
        self.next = self.next.saturating_add(n);
    }

    /// The next number, if one is written.
    ///
    /// # Errors
    /// A text in its place.
    pub fn optional(&mut self) -> Result<Option<f64>> {
        self.next += 1;
        match self.values.get(self.next - 1) {
            None | Some(Value::Empty) => Ok(None),
            Some(Value::Number(x)) => Ok(Some(*x)),
            Some(Value::Text(_)) => Err(self.error(format!("has a text as parameter {}", self.next - 1))),
        }
    }

    /// The next number; 0 where none is written.
    ///
    /// # Errors
    /// The record ends before it, or has a text in its place.
    pub fn real(&mut self) -> Result<f64> {
        if self.left() == 0 {
            return Err(self.error(format!("has {} parameters, which is too few", self.values.len().saturating_sub(1))));
        }
        Ok(self.optional()?.unwrap_or(0.0))
    }

    /// The next three numbers.
    ///
    /// # Errors
    /// See [`Self::real`].
    pub fn triple(&mut self) -> Result<[f64; 3]> {
        Ok([self.real()?, self.real()?, self.real()?])
    }

    /// The next integer.
    ///
    /// # Errors
    /// See [`Self::real`]; a number with a fraction.
    pub fn int(&mut self) -> Result<i64> {
        let x = self.real()?;
        if x.fract() != 0.0 || x.abs() > 1e15 {
            return Err(self.error(format!("has {x} as parameter {}, where an integer belongs", self.next - 1)));
        }
        Ok(x as i64)
    }

    /// The next integer as a number of things that take at least `each` parameters apiece.
    ///
    /// # Errors
    /// See [`Self::int`]; a negative count; one that the record has no room for.
    pub fn count(&mut self, each: usize) -> Result<usize> {
        let n = self.int()?;
        let room = self.left();
        usize::try_from(n)
            .ok()
            .filter(|n| n.checked_mul(each).is_some_and(|need| need <= room))
            .ok_or_else(|| self.error(format!("announces {n} items, but has only {room} parameters left")))
    }
}

impl<'f> Params<'f> {
    /// The next pointer, which must not be 0.
    ///
    /// # Errors
    /// See [`Self::int`]; a pointer to nothing.
    pub fn target(&mut self) -> Result<&'f Entity> {
        let n = self.int()?;
        let file = self.file;
        let found = usize::try_from(n).ok().and_then(|l| file.entity(l));
        found.ok_or_else(|| self.error(format!("points at D{n}, which does not exist")))
    }

    /// The next pointer; `None` for 0.
    ///
    /// # Errors
    /// A number that names no entity.
    pub fn maybe_target(&mut self) -> Result<Option<&'f Entity>> {
        match self.optional()? {
            None | Some(0.0) => Ok(None),
            Some(_) => {
                self.next -= 1;
                self.target().map(Some)
            }
        }
    }
}

/// A field of a directory line.
fn field(line: &[u8], k: usize) -> std::result::Result<i64, String> {
    let text = String::from_utf8_lossy(line.get(8 * k..8 * k + 8).unwrap_or_default()).trim().to_owned();
    if text.is_empty() {
        return Ok(0);
    }
    text.parse().map_err(|_| format!("field {} is \"{text}\", not a number", k + 1))
}

fn entry(one: &[u8], two: &[u8], line: usize) -> std::result::Result<Entity, String> {
    let kind = u32::try_from(field(one, 0)?).map_err(|_| "a negative type number".to_owned())?;
    let status: Vec<u8> =
        one.get(64..72).unwrap_or_default().iter().map(|b| if *b == b' ' { b'0' } else { *b }).collect();
    let pair = |k: usize| status.get(2 * k..2 * k + 2).unwrap_or(b"00");
    // Lines are counted from 1; what points before the first is caught when the parameters are
    // read.
    let first = usize::try_from(field(one, 1)? - 1).unwrap_or(usize::MAX);
    Ok(Entity {
        kind,
        form: field(two, 4)?,
        line,
        first,
        count: usize::try_from(field(two, 3)?).unwrap_or(0),
        // Only the transform itself matters of a negative pointer to a list of views.
        transform: field(one, 6)?.max(0),
        blanked: pair(0) == b"01",
        subordinate: matches!(pair(1), b"01" | b"03"),
    })
}

/// The delimiters come first and are written in themselves: `1H,,1H;,` or, for the usual ones,
/// `,,`.
fn read_global(text: &[u8]) -> std::result::Result<Global, String> {
    let (parameter, after) = delimiter(text, b',', b',')?;
    let after = after.strip_prefix(&[parameter]).unwrap_or(after);
    let (record, after) = delimiter(after, b';', parameter)?;
    let after = after.strip_prefix(&[parameter]).unwrap_or(after);
    if parameter == record {
        return Err("parameters and records have the same delimiter".into());
    }
    let v = values(after, parameter, record)?;
    // `v` begins with the third parameter of the section.
    let number = |k: usize| match v.get(k - 3) {
        Some(Value::Number(x)) => Some(*x),
        _ => None,
    };
    let unit_name = match v.get(15 - 3) {
        Some(Value::Text(t)) => t.trim().to_owned(),
        _ => String::new(),
    };
    let scale = number(13).unwrap_or(1.0);
    Ok(Global {
        parameter_delimiter: parameter,
        record_delimiter: record,
        scale: if scale == 0.0 { 1.0 } else { scale },
        unit_flag: number(14).map_or(1, |x| x as i64),
        unit_name,
        version: number(23).map_or(0, |x| x as i64),
    })
}

fn delimiter(text: &[u8], usual: u8, separator: u8) -> std::result::Result<(u8, &[u8]), String> {
    let text = text.trim_ascii_start();
    match text {
        [b'1', b'H' | b'h', d, rest @ ..] if d.is_ascii_graphic() && !d.is_ascii_alphanumeric() => Ok((*d, rest)),
        [b, ..] if *b == usual || *b == separator => Ok((usual, text)),
        _ => Err("it does not begin with its delimiters".into()),
    }
}
