//! Wavefront OBJ, through `tobj`. Groups and objects become the mesh's groups; texture, normals, materials, points and
//! lines are ignored; polygons are cut into triangles.

use std::panic::{AssertUnwindSafe, catch_unwind};
use std::path::Path;

use super::soup::Soup;
use crate::error::{Error, Result, Stage};

/// Reads an OBJ.
///
/// # Errors
/// `InputOutput`: text that is not OBJ, face indices without vertex.
pub fn read(path: &Path, bytes: &[u8]) -> Result<Soup> {
    let name = path.display();
    let options =
        tobj::LoadOptions { triangulate: true, ignore_points: true, ignore_lines: true, ..Default::default() };
    // Last resort around a parser that is not ours: whatever it meets in a damaged file, the user gets a sentence.
    let parsed = catch_unwind(AssertUnwindSafe(|| {
        tobj::load_obj_buf(&mut &bytes[..], &options, |_| Ok((Vec::new(), Default::default())))
    }))
    .map_err(|_| Error::io(Stage::Model, format!("{name} is damaged: the OBJ parser gave up on it")))?;
    let (models, _) = parsed.map_err(|e| {
        Error::io(Stage::Model, format!("{name} cannot be read as OBJ: {e}")).advise("export the mesh again")
    })?;
    let mut soup = Soup { format: "OBJ".into(), ..Soup::default() };
    for model in &models {
        soup.begin_group(&model.name);
        let corner = |i: u32| {
            let at = 3 * i as usize;
            model.mesh.positions.get(at..at + 3).map(|p| [p[0], p[1], p[2]])
        };
        for t in model.mesh.indices.chunks_exact(3) {
            match (corner(t[0]), corner(t[1]), corner(t[2])) {
                (Some(a), Some(b), Some(c)) => soup.push([a, b, c]),
                _ => {
                    return Err(Error::io(
                        Stage::Model,
                        format!("{name}: a face of group {} names a vertex that is not there", model.name),
                    ));
                }
            }
        }
    }
    Ok(soup)
}
