//! Wavefront OBJ, through `tobj`. Groups and objects become the mesh's groups; texture, normals,
//! materials, points and lines are ignored; polygons are cut into triangles from their first
//! corner.
//!
//! `tobj` is given what a mesh is made of only ([`bare`]): it takes a line of three points for a
//! triangle, divides vertices by their weights, and refuses colours or texture coordinates of an
//! unusual number. Where it refuses the rest, a second look names the damaged line ([`damage`]).

use std::fmt::Write;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::path::Path;

use super::soup::Soup;
use crate::error::{Error, Result, Stage};
use crate::observe::Remark;

/// The name that `tobj` gives to what has none.
const UNNAMED: &str = "unnamed_object";

/// Reads an OBJ.
///
/// # Errors
/// `InputOutput`, with the line: a vertex without three numbers, a face with what is no corner or
/// with a vertex that is not there.
pub fn read(path: &Path, bytes: &[u8]) -> Result<Soup> {
    let text = String::from_utf8_lossy(bytes);
    let (bare, weighted) = bare(&text);
    let options =
        tobj::LoadOptions { triangulate: true, ignore_points: true, ignore_lines: true, ..Default::default() };
    // Last resort around a parser that is not ours: whatever it meets in a damaged file, the user
    // gets a sentence.
    let parsed = catch_unwind(AssertUnwindSafe(|| {
        tobj::load_obj_buf(&mut bare.as_bytes(), &options, |_| Ok((Vec::new(), Default::default())))
    }));
    let models = match parsed {
        Ok(Ok((models, _))) => models,
        Ok(Err(e)) => return Err(damage(path, &text, &e.to_string())),
        Err(_) => return Err(damage(path, &text, "the parser gave up on it")),
    };
    let mut soup = Soup { format: "OBJ".into(), ..Soup::default() };
    for model in models.iter().filter(|m| !m.mesh.indices.is_empty()) {
        soup.begin_group(if model.name == UNNAMED { "" } else { &model.name });
        let corner = |i: u32| match model.mesh.positions.get(3 * i as usize..3 * i as usize + 3) {
            Some([x, y, z]) => Some([*x, *y, *z]),
            _ => None,
        };
        for t in model.mesh.indices.chunks_exact(3) {
            match (corner(t[0]), corner(t[1]), corner(t[2])) {
                (Some(a), Some(b), Some(c)) => soup.push([a, b, c]),
                _ => return Err(damage(path, &text, "a face names a vertex that is not there")),
            }
        }
    }
    if weighted > 0 {
        soup.notes.push(Remark::WeightsPassedOver { vertices: weighted });
    }
    Ok(soup)
}

/// The lines that a mesh is made of: vertices with their three coordinates, faces with the numbers
/// of their vertices, names of groups. And how many vertices have a weight: a fourth number that is
/// the last, and not 1. The format has it for rational curves and surfaces, whose control points
/// are not divided by it either; polygons have no use for it. More numbers are colours.
fn bare(text: &str) -> (String, usize) {
    let mut out = String::with_capacity(text.len());
    let mut weighted = 0;
    for line in text.lines() {
        let mut words = line.split_ascii_whitespace();
        // Writing to a String cannot fail.
        let _ = match words.next() {
            Some("v") => {
                let (p, rest): (Vec<&str>, Vec<&str>) = (words.by_ref().take(3).collect(), words.collect());
                // What is no number is left for the parser to refuse.
                let weight = if let [w] = rest[..] { w.parse::<f64>().map_err(|_| w) } else { Ok(1.0) };
                weighted += usize::from(weight.is_ok_and(|w| w != 1.0));
                writeln!(out, "v {} {}", p.join(" "), weight.err().unwrap_or_default())
            }
            Some("f") => {
                let corners: Vec<&str> = words.map(|w| w.split('/').next().unwrap_or(w)).collect();
                if corners.is_empty() { Ok(()) } else { writeln!(out, "f {}", corners.join(" ")) }
            }
            Some("o" | "g") => writeln!(out, "{}", line.trim_start()),
            _ => Ok(()),
        };
    }
    (out, weighted)
}

/// What is the matter with a file that the parser refused, with the first line that is damaged; in
/// the parser's words where no line is.
fn damage(path: &Path, text: &str, said: &str) -> Error {
    let vertices = text.lines().filter(|l| l.split_ascii_whitespace().next() == Some("v")).count();
    let mut before = 0;
    for (number, line) in text.lines().enumerate() {
        let mut words = line.split_ascii_whitespace();
        match words.next() {
            Some("v") if vertex(words.clone()).is_none() => return bad_line(path, number, line),
            Some("v") => before += 1,
            Some("f") => {
                let corners: Option<Vec<u32>> = words.map(|w| corner(w, before)).collect();
                let Some(corners) = corners else { return bad_line(path, number, line) };
                let most = corners.iter().max().map_or(0, |i| *i as usize + 1);
                if most > vertices {
                    return Error::io(
                        Stage::Model,
                        format!(
                            "{}, line {}: the face names vertex {most}, but there are {vertices}",
                            path.display(),
                            number + 1
                        ),
                    )
                    .advise("the file was cut off or damaged: export the mesh again");
                }
            }
            _ => {}
        }
    }
    Error::io(Stage::Model, format!("{} cannot be read as OBJ: {said}", path.display())).advise("export the mesh again")
}

/// Whether these are three coordinates; a fourth number that is the last is a weight.
fn vertex<'a>(words: impl Iterator<Item = &'a str>) -> Option<()> {
    let words: Vec<&str> = words.collect();
    let numbers = if words.len() == 4 { 4 } else { 3 };
    let p = words.get(..numbers)?;
    p.iter().all(|w| w.parse::<f64>().is_ok()).then_some(())
}

/// The vertex that a corner (`7`, `7/1`, `7//3`, `7/1/3`; negative: counted back from the last one)
/// names, from 0.
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

    /// Weights do not move vertices, not even one of 0; only those that would have are reported.
    #[test]
    fn weights_are_passed_over() {
        let plain = soup("v 1 2 3\nv 4 5 6\nv 7 8 0\nf 1 2 3\n").unwrap();
        let ones = soup("v 1 2 3 1\nv 4 5 6 1.0\nv 7 8 0 1 0 0\nf 1 2 3\n").unwrap();
        let others = soup("v 1 2 3 0\nv 4 5 6 -2.5\nv 7 8 0 1\nf 1 2 3\n").unwrap();
        assert!(plain.triangles == ones.triangles && plain.triangles == others.triangles);
        assert!(plain.notes.is_empty() && ones.notes.is_empty());
        assert!(others.notes.len() == 1 && others.notes[0].to_string().contains("2 vertices"), "{:?}", others.notes);
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

    /// What `tobj` would make something else of: a line of three points, colours of some vertices
    /// only, texture of one coordinate, materials between faces.
    #[test]
    fn what_a_mesh_has_no_use_for_changes_nothing() {
        let plain = soup(&format!("{SQUARE}g hub\nf 1 2 3 4\n")).unwrap();
        let text = format!(
            "mtllib a.mtl\nusemtl\nvt 0.5\nvn 1\nvp 1 2\n{SQUARE}l 1 2 3\np 1 2 3\nf\nl 1/1 2/1 3/1 4/1\n g hub\nusemtl x\nf 1/1/1 2/9/9 3 4//7\ns off\n\
             curv 0 1 1 2\nf 1 2\nf 3\n"
        );
        let with = soup(&text).unwrap();
        assert_eq!((with.triangles, with.groups), (plain.triangles, plain.groups));
        let many = soup(&format!("{SQUARE}v 2 2 0\nf 1 2 3 5 4\nf -5 -4 -3\n")).unwrap();
        let [a, b, c, e, d] = [[0., 0., 0.], [1., 0., 0.], [1., 1., 0.], [2., 2., 0.], [0., 1., 0.]];
        assert_eq!(many.triangles, [[a, b, c], [a, c, e], [a, e, d], [a, b, c]], "a fan from the first corner");
        assert!(soup("").unwrap().triangles.is_empty() && soup("\u{0}\u{1}garbage\n").unwrap().triangles.is_empty());
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
            ("v 0 0 0\ng a\nf 1 1 2\ng b\nv 1 0 0\n", ["cannot be read as OBJ", "a.obj"]),
        ] {
            let e = soup(text).err().unwrap().to_string();
            assert!(words.iter().all(|w| e.contains(w)), "{text:?}: {e}");
        }
    }
}
