//! PLY, ASCII and binary of either byte order.
//!
//! A reader of ours: the format is small, and what a file promises in its header is held against
//! what is there before memory is taken. Read are `x`, `y`, `z` of the element `vertex`, the lists
//! `vertex_indices` (or `vertex_index`) of the element `face`, polygons cut into fans, and
//! `tristrips`; all other elements and properties are passed over.

use std::path::Path;

use super::soup::Soup;
use crate::error::{Error, Result, Stage};

/// A number's type in the header.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Scalar {
    I8,
    U8,
    I16,
    U16,
    I32,
    U32,
    F32,
    F64,
}

impl Scalar {
    fn named(name: &str) -> Option<Self> {
        Some(match name {
            "char" | "int8" => Scalar::I8,
            "uchar" | "uint8" => Scalar::U8,
            "short" | "int16" => Scalar::I16,
            "ushort" | "uint16" => Scalar::U16,
            "int" | "int32" => Scalar::I32,
            "uint" | "uint32" => Scalar::U32,
            "float" | "float32" => Scalar::F32,
            "double" | "float64" => Scalar::F64,
            _ => return None,
        })
    }

    fn bytes(self) -> usize {
        match self {
            Scalar::I8 | Scalar::U8 => 1,
            Scalar::I16 | Scalar::U16 => 2,
            Scalar::I32 | Scalar::U32 | Scalar::F32 => 4,
            Scalar::F64 => 8,
        }
    }

    /// From bytes with the least significant one first.
    fn value(self, b: [u8; 8]) -> f64 {
        match self {
            Scalar::I8 => f64::from(b[0] as i8),
            Scalar::U8 => f64::from(b[0]),
            Scalar::I16 => f64::from(i16::from_le_bytes([b[0], b[1]])),
            Scalar::U16 => f64::from(u16::from_le_bytes([b[0], b[1]])),
            Scalar::I32 => f64::from(i32::from_le_bytes([b[0], b[1], b[2], b[3]])),
            Scalar::U32 => f64::from(u32::from_le_bytes([b[0], b[1], b[2], b[3]])),
            Scalar::F32 => f64::from(f32::from_le_bytes([b[0], b[1], b[2], b[3]])),
            Scalar::F64 => f64::from_le_bytes(b),
        }
    }
}

struct Property {
    name: String,
    /// Type of the count before the values; `None`: one value.
    list: Option<Scalar>,
    value: Scalar,
}

struct Element {
    name: String,
    count: usize,
    properties: Vec<Property>,
}

#[derive(Clone, Copy, PartialEq, Eq)]
enum Layout {
    Ascii,
    Little,
    Big,
}

/// Reads a PLY.
///
/// # Errors
/// `InputOutput`: a header that is not PLY's, an end before all that the header promises, faces
/// that name vertices that are not there.
pub fn read(path: &Path, bytes: &[u8]) -> Result<Soup> {
    let (layout, elements, body) = header(bytes).map_err(|m| {
        Error::io(Stage::Model, format!("{} cannot be read as PLY: {m}", path.display()))
            .advise("export the mesh again")
    })?;
    let mut numbers = Numbers { layout, rest: body };
    let mut mesh = Faces::default();
    for element in &elements {
        read_element(&mut numbers, element, &mut mesh).map_err(|m| {
            Error::io(Stage::Model, format!("{} is damaged: {m}", path.display()))
                .advise("the file was cut off or changed: export or copy it again")
        })?;
    }
    mesh.soup(layout).map_err(|m| {
        Error::io(Stage::Model, format!("{}: {m}", path.display())).advise("repair or export the mesh again")
    })
}

/// Format, elements, and the bytes after the header.
fn header(bytes: &[u8]) -> std::result::Result<(Layout, Vec<Element>, &[u8]), String> {
    let mut rest = bytes;
    let mut layout = None;
    let mut elements: Vec<Element> = Vec::new();
    for number in 1.. {
        let end = rest.iter().position(|&b| b == b'\n').ok_or("the header has no end_header")?;
        let (line, after) = rest.split_at(end);
        rest = &after[1..];
        let line = String::from_utf8_lossy(line);
        let words: Vec<&str> = line.split_ascii_whitespace().collect();
        let bad = || format!("line {number}: \"{}\"", line.trim().chars().take(60).collect::<String>());
        match words[..] {
            ["ply"] if number == 1 => {}
            _ if number == 1 => return Err("it does not begin with ply".into()),
            [] | ["comment" | "obj_info", ..] => {}
            ["format", "ascii", _] => layout = Some(Layout::Ascii),
            ["format", "binary_little_endian", _] => layout = Some(Layout::Little),
            ["format", "binary_big_endian", _] => layout = Some(Layout::Big),
            ["element", name, count] => {
                let count = count.parse().map_err(|_| bad())?;
                elements.push(Element { name: name.into(), count, properties: Vec::new() });
            }
            ["property", "list", count, value, name] => {
                let (list, value) = (Scalar::named(count).ok_or_else(bad)?, Scalar::named(value).ok_or_else(bad)?);
                let property = Property { name: name.into(), list: Some(list), value };
                elements.last_mut().ok_or_else(bad)?.properties.push(property);
            }
            ["property", value, name] => {
                let property = Property { name: name.into(), list: None, value: Scalar::named(value).ok_or_else(bad)? };
                elements.last_mut().ok_or_else(bad)?.properties.push(property);
            }
            ["end_header"] => break,
            _ => return Err(bad()),
        }
    }
    Ok((layout.ok_or("the header names no format")?, elements, rest))
}

/// The numbers after the header, one after another.
struct Numbers<'a> {
    layout: Layout,
    rest: &'a [u8],
}

impl Numbers<'_> {
    fn next(&mut self, kind: Scalar) -> Option<f64> {
        if self.layout == Layout::Ascii {
            let start = self.rest.iter().position(|b| !b.is_ascii_whitespace())?;
            let word = &self.rest[start..];
            let end = word.iter().position(u8::is_ascii_whitespace).unwrap_or(word.len());
            self.rest = &word[end..];
            return std::str::from_utf8(&word[..end]).ok()?.parse().ok();
        }
        let n = kind.bytes();
        if self.rest.len() < n {
            return None;
        }
        let (taken, rest) = self.rest.split_at(n);
        self.rest = rest;
        let mut b = [0; 8];
        b[..n].copy_from_slice(taken);
        if self.layout == Layout::Big {
            b[..n].reverse();
        }
        Some(kind.value(b))
    }

    /// A count or index: a whole number from 0 on.
    fn whole(&mut self, kind: Scalar) -> Option<usize> {
        let x = self.next(kind)?;
        (x >= 0.0 && x <= f64::from(u32::MAX) && x.fract() == 0.0).then_some(x as usize)
    }
}

/// What the file holds.
#[derive(Default)]
struct Faces {
    points: Vec<[f64; 3]>,
    triangles: Vec<[usize; 3]>,
    has_vertices: bool,
}

fn read_element(numbers: &mut Numbers, element: &Element, mesh: &mut Faces) -> std::result::Result<(), String> {
    let coordinate = |name: &str| match name {
        "x" => Some(0),
        "y" => Some(1),
        "z" => Some(2),
        _ => None,
    };
    let is_vertex = element.name == "vertex";
    if is_vertex && (0..3).any(|k| !element.properties.iter().any(|p| coordinate(&p.name) == Some(k))) {
        return Err("the element vertex lacks x, y or z".into());
    }
    mesh.has_vertices |= is_vertex;
    if element.properties.is_empty() {
        return Ok(());
    }
    let mut list = Vec::new();
    for i in 0..element.count {
        let early = || format!("{} {} of {} is not there or not a number", element.name, i + 1, element.count);
        let mut point = [0.0; 3];
        for p in &element.properties {
            let Some(count) = p.list else {
                let x = numbers.next(p.value).ok_or_else(early)?;
                if let Some(k) = coordinate(&p.name) {
                    point[k] = x;
                }
                continue;
            };
            let n = numbers.whole(count).ok_or_else(early)?;
            list.clear();
            for _ in 0..n {
                list.push(numbers.next(p.value).ok_or_else(early)?);
            }
            match (element.name.as_str(), p.name.as_str()) {
                ("face", "vertex_indices" | "vertex_index") => mesh.polygon(&list).ok_or_else(early)?,
                ("tristrips", "vertex_indices" | "vertex_index") => mesh.strips(&list).ok_or_else(early)?,
                _ => {}
            }
        }
        if is_vertex {
            mesh.points.push(point);
        }
    }
    Ok(())
}

/// An index of a vertex as a whole number.
fn index(x: f64) -> Option<usize> {
    (x >= 0.0 && x <= f64::from(u32::MAX) && x.fract() == 0.0).then_some(x as usize)
}

impl Faces {
    /// A polygon as a fan about its first corner.
    fn polygon(&mut self, corners: &[f64]) -> Option<()> {
        let Some((first, others)) = corners.split_first() else { return Some(()) };
        for pair in others.windows(2) {
            self.triangles.push([index(*first)?, index(pair[0])?, index(pair[1])?]);
        }
        Some(())
    }

    /// Strips of triangles, parted by −1; every second triangle is wound the other way.
    fn strips(&mut self, corners: &[f64]) -> Option<()> {
        for strip in corners.split(|&c| c == -1.0) {
            for (k, t) in strip.windows(3).enumerate() {
                let (a, b, c) = (index(t[0])?, index(t[1])?, index(t[2])?);
                self.triangles.push(if k % 2 == 0 { [a, b, c] } else { [b, a, c] });
            }
        }
        Some(())
    }

    fn soup(&self, layout: Layout) -> std::result::Result<Soup, String> {
        let kind = match layout {
            Layout::Ascii => "ASCII",
            Layout::Little => "binary, little endian",
            Layout::Big => "binary, big endian",
        };
        let mut soup = Soup { format: format!("PLY, {kind}"), ..Soup::default() };
        if !self.has_vertices {
            return Err("the header names no element vertex".into());
        }
        if self.triangles.is_empty() {
            return Err("it holds points but no face: a cloud of points is not a body".into());
        }
        for (i, t) in self.triangles.iter().enumerate() {
            let corner = |k: usize| {
                let missing =
                    || format!("triangle {} names vertex {k}, of {} that are there", i + 1, self.points.len());
                self.points.get(k).copied().ok_or_else(missing)
            };
            soup.push([corner(t[0])?, corner(t[1])?, corner(t[2])?]);
        }
        Ok(soup)
    }
}
