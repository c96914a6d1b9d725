//! Wavefront OBJ. Groups and objects become the mesh's groups; texture, normals, materials, points and lines are ignored; polygons
//! are cut into triangles from their first corner.
//!
//! Our own reader of this small format: it says in which line a file is damaged, and never gives up on one in another way.

use std::path::Path;

use super::soup::Soup;
use crate::error::{Error, Result, Stage};

/// Reads an OBJ.
///
/// # Errors
/// `InputOutput`, with the line: a vertex without three numbers, a face with what is no corner or with a vertex that is not there.
pub fn read(path: &Path, bytes: &[u8]) -> Result<Soup> {
    let text = String::from_utf8_lossy(bytes);
    let mut soup = Soup { format: "OBJ".into(), ..Soup::default() };
    let mut vertices: Vec<[f64; 3]> = Vec::new();
    let mut weighted = 0usize;
    // Vertices may come after the faces that name them: triangles are numbers at first, with their lines.
    let mut triangles: Vec<([u32; 3], u32)> = Vec::new();
    let mut corners: Vec<u32> = Vec::new();
    // A group begins with its first face: names without faces are no groups.
    let mut name = Some("");
    for (number, line) in text.lines().enumerate() {
        let mut words = line.split_ascii_whitespace();
        match words.next() {
            Some("v") => {
                let (p, weight) = vertex(words).ok_or_else(|| bad_line(path, number, line))?;
                vertices.push(p);
                weighted += usize::from(weight != 1.0);
            }
            Some("f") => {
                corners.clear();
                for word in words {
                    corners.push(corner(word, vertices.len()).ok_or_else(|| bad_line(path, number, line))?);
                }
                if let [first, rest @ ..] = corners.as_slice() {
                    for pair in rest.windows(2) {
                        if let Some(name) = name.take() {
                            soup.begin_group(name);
                        }
                        triangles.push(([*first, pair[0], pair[1]], number as u32));
                        soup.group_of.push(soup.groups.len() as u32 - 1);
                    }
                }
            }
            Some(keyword @ ("o" | "g")) => name = Some(line.trim_start()[keyword.len()..].trim()),
            _ => {}
        }
    }
    soup.triangles.reserve(triangles.len());
    for (ids, number) in triangles {
        let [a, b, c] = ids.map(|i| vertices.get(i as usize).copied());
        match (a, b, c) {
            (Some(a), Some(b), Some(c)) => soup.triangles.push([a, b, c]),
            _ => {
                let most = ids.iter().max().map_or(0, |i| u64::from(*i) + 1);
                return Err(Error::io(
                    Stage::Model,
                    format!(
                        "{}, line {}: the face names vertex {most}, but there are {}",
                        path.display(),
                        number + 1,
                        vertices.len()
                    ),
                )
                .advise("the file was cut off or damaged: export the mesh again"));
            }
        }
    }
    if weighted > 0 {
        soup.notes
            .push(format!("weights of {weighted} vertices were passed over: they are for curves, not for a mesh"));
    }
    Ok(soup)
}

/// Three coordinates, and the fourth number if it is the last: a weight. The format has it for rational curves and surfaces, whose control points
/// are not divided by it either; polygons have no use for it. More numbers are colours.
fn vertex<'a>(mut words: impl Iterator<Item = &'a str>) -> Option<([f64; 3], f64)> {
    let mut next = || words.next()?.parse::<f64>().ok();
    let p = [next()?, next()?, next()?];
    match (words.next(), words.next()) {
        (Some(w), None) => Some((p, w.parse().ok()?)),
        _ => Some((p, 1.0)),
    }
}

/// The vertex that a corner (`7`, `7/1`, `7//3`, `7/1/3`; negative: counted back from the last one) names, from 0.
fn corner(word: &str, vertices: usize) -> Option<u32> {
    let number: i64 = word.split('/').next()?.parse().ok()?;
    let from_0 = if number < 0 { number.checked_add(vertices as i64)? } else { number - 1 };
    u32::try_from(from_0).ok()
}

fn bad_line(path: &Path, number: usize, line: &str) -> Error {
    let line: String = line.trim().chars().take(60).collect();
    Error::io(Stage::Model, format!("{}, line {}: \"{line}\" does not belong in an OBJ", path.display(), number + 1))
        .advise("the file is damaged: export the mesh again")
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used)]
    use super::*;

    fn soup(text: &str) -> Result<Soup> {
        read(Path::new("a.obj"), text.as_bytes())
    }

    const SQUARE: &str = "v 0 0 0\nv 1 0 0 0.5 0.5 0.5\r\nv 1 1 0 2\n  v\t0 1 0 1 0 0\n";

    #[test]
    fn corners_in_every_form_are_the_same_triangles() {
        let [a, b, c, d] = [[0., 0., 0.], [1., 0., 0.], [1., 1., 0.], [0., 1., 0.]];
        let faces = ["f 1 2 3 4", "f 1/1 2/2 3/3 4/4", "f 1//1 2//1 3//1 4//1", "f -4/1/1 -3/1/1 -2/1/1 -1/1/1"];
        for face in faces {
            // A vertex after the face does not change what it counts back from.
            let soup =
                soup(&format!("# a square\nvt 0 0\nvn 0 0 1\n{SQUARE}{face}\nv 9 9 9\nl 1 2\np 1\nf 1 2\n")).unwrap();
            assert_eq!(soup.triangles, [[a, b, c], [a, c, d]], "{face}");
        }
        let early = soup(&format!("f 1 2 3\n{SQUARE}")).unwrap();
        assert_eq!(early.triangles, [[a, b, c]]);
    }

    /// Weights do not move vertices, not even one of 0; only those that would have are told.
    #[test]
    fn weights_are_passed_over() {
        let plain = soup("v 1 2 3\nv 4 5 6\nv 7 8 0\nf 1 2 3\n").unwrap();
        let ones = soup("v 1 2 3 1\nv 4 5 6 1.0\nv 7 8 0 1 0 0\nf 1 2 3\n").unwrap();
        let others = soup("v 1 2 3 0\nv 4 5 6 -2.5\nv 7 8 0 1\nf 1 2 3\n").unwrap();
        assert!(plain.triangles == ones.triangles && plain.triangles == others.triangles);
        assert!(plain.notes.is_empty() && ones.notes.is_empty());
        assert!(others.notes.len() == 1 && others.notes[0].contains("2 vertices"), "{:?}", others.notes);
    }

    #[test]
    fn groups_are_names_with_faces() {
        let of = |text: &str| {
            let s = soup(&format!("{SQUARE}{text}")).unwrap();
            (s.groups, s.group_of)
        };
        assert_eq!(of("f 1 2 3 4\n"), (vec![String::new()], vec![0, 0]));
        let named = of("o part\ng Tip end \nf 1 2 3\nusemtl x\nf 1 3 4\ng empty\ng hub\nf 1 2 4\ng last\n");
        assert_eq!(named, (vec!["Tip end".into(), "hub".into()], vec![0, 0, 1]));
    }

    #[test]
    fn damage_is_told_with_its_line() {
        for (text, words) in [
            ("v 0 0\n", ["line 1", "v 0 0"]),
            ("v 0 0 x\n", ["line 1", "does not belong"]),
            ("v 0 0 0 x\n", ["line 1", "does not belong"]),
            ("\nf 1 two 3\n", ["line 2", "f 1 two 3"]),
            ("f 0 1 2\n", ["line 1", "does not belong"]),
            ("v 0 0 0\nf -2 1 1\n", ["line 2", "does not belong"]),
            ("v 0 0 0\nv 1 0 0\n\nf 1 2 9\n", ["line 4", "names vertex 9, but there are 2"]),
            ("f 1 2 99999999999\n", ["line 1", "does not belong"]),
        ] {
            let e = soup(text).err().unwrap().to_string();
            assert!(words.iter().all(|w| e.contains(w)), "{text:?}: {e}");
        }
    }
}
