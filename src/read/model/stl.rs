//! STL, binary and ASCII.
//!
//! Our own reader of this small format: ASCII numbers keep double precision, keywords may be in any
//! case, several solids become groups, and a file that ends early is an error that says where.

use std::path::Path;

use super::format::binary_stl_length;
use super::soup::Soup;
use crate::error::{Error, Result, Stage};
use crate::observe::Remark;

/// Reads a binary STL.
///
/// # Errors
/// `InputOutput`: shorter than its triangle count asks for, or without triangles.
pub fn read_binary(path: &Path, bytes: &[u8]) -> Result<Soup> {
    let name = path.display();
    let advice = "the file was cut off: export or copy it again";
    let Some(length) = binary_stl_length(bytes) else {
        return Err(Error::io(
            Stage::Model,
            format!("{name} is not an STL file: {} bytes, where a binary STL has at least 84", bytes.len()),
        )
        .advise(advice));
    };
    if bytes.len() < length {
        let (have, want) = ((bytes.len() - 84) / 50, (length - 84) / 50);
        return Err(Error::io(
            Stage::Model,
            format!("{name} ends early: its header promises {want} triangles, {have} are there"),
        )
        .advise(advice));
    }
    let mut soup = Soup::default();
    for record in bytes[84..length].chunks_exact(50) {
        let number = |i: usize| {
            let at = 12 + 4 * i;
            f64::from(f32::from_le_bytes([record[at], record[at + 1], record[at + 2], record[at + 3]]))
        };
        let corner = |k: usize| [number(3 * k), number(3 * k + 1), number(3 * k + 2)];
        soup.push([corner(0), corner(1), corner(2)]);
    }
    if bytes.len() > length {
        soup.notes.push(Remark::BytesIgnored { bytes: bytes.len() - length });
    }
    soup.format = "STL, binary".into();
    Ok(soup)
}

/// Reads an ASCII STL.
///
/// # Errors
/// `InputOutput`: a line that does not fit the format (with its number), or an end before
/// `endsolid`.
pub fn read_ascii(path: &Path, bytes: &[u8]) -> Result<Soup> {
    let name = path.display();
    let text = String::from_utf8_lossy(bytes);
    let mut soup = Soup { format: "STL, ASCII".into(), ..Soup::default() };
    let mut corners: Vec<[f64; 3]> = Vec::with_capacity(3);
    let mut open_solid = false;
    for (number, line) in text.lines().enumerate() {
        let mut words = line.split_ascii_whitespace();
        let Some(keyword) = words.next() else { continue };
        match keyword.to_ascii_lowercase().as_str() {
            "solid" => {
                open_solid = true;
                soup.begin_group(&words.collect::<Vec<_>>().join(" "));
            }
            "facet" | "outer" | "endloop" => {}
            "vertex" => corners.push(vertex(words).ok_or_else(|| bad_line(path, number, line))?),
            "endfacet" => {
                let triangle: [[f64; 3]; 3] =
                    corners.as_slice().try_into().map_err(|_| bad_line(path, number, line))?;
                soup.push(triangle);
                corners.clear();
            }
            "endsolid" => open_solid = false,
            _ => return Err(bad_line(path, number, line)),
        }
    }
    if open_solid || !corners.is_empty() {
        return Err(Error::io(
            Stage::Model,
            format!("{name} ends early, after {} triangles: there is no endsolid", soup.triangles.len()),
        )
        .advise("the file was cut off: export or copy it again"));
    }
    Ok(soup)
}

fn vertex<'a>(mut words: impl Iterator<Item = &'a str>) -> Option<[f64; 3]> {
    let mut next = || words.next()?.parse::<f64>().ok();
    Some([next()?, next()?, next()?])
}

fn bad_line(path: &Path, number: usize, line: &str) -> Error {
    let line: String = line.trim().chars().take(60).collect();
    Error::io(
        Stage::Model,
        format!("{}, line {}: \"{line}\" does not belong in an ASCII STL", path.display(), number + 1),
    )
    .advise("the file is damaged: export it again")
}
