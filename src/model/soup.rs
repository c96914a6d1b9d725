//! Loose triangles as mesh files give them, and their healing to one closed mesh.
//!
//! Healing: vertices that coincide become one (exactly; within [`WELD`] of the size only where that closes the mesh),
//! degenerate triangles go, neighbours are wound alike, the whole is wound outward (positive volume). What was changed
//! is noted. A mesh that stays open is refused: distance and clearance to it would be meaningless.

use std::collections::HashMap;
use std::path::Path;

use crate::artifact::blade::Unit;
use crate::error::{Error, Result, Stage};
use crate::geometry::Point;
use crate::geometry::mesh::{Mesh, topology, weld};

use super::wind::align;

/// Vertices closer than this share of the part's diagonal may be welded: ten times the rounding of single precision.
const WELD: f64 = 1e-6;

/// Triangles with corners of their own, in groups.
#[derive(Default)]
pub struct Soup {
    /// Corners, file units.
    pub triangles: Vec<[[f64; 3]; 3]>,
    /// Group of each triangle.
    pub group_of: Vec<u32>,
    /// Names of the groups.
    pub groups: Vec<String>,
    /// Format, for the diagnosis.
    pub format: String,
    /// Unit that the format prescribes; `None`: a format that names none.
    pub unit: Option<Unit>,
    /// What the reader has to say.
    pub notes: Vec<String>,
}

/// A healed mesh.
pub struct Healed {
    /// Closed, wound outward, mm.
    pub mesh: Mesh,
    /// Connected pieces.
    pub bodies: usize,
    /// What was changed.
    pub notes: Vec<String>,
}

impl Soup {
    /// The following triangles belong to a new group.
    pub fn begin_group(&mut self, name: &str) {
        self.groups.push(name.to_owned());
    }
    /// Adds a triangle to the current group.
    pub fn push(&mut self, triangle: [[f64; 3]; 3]) {
        if self.groups.is_empty() {
            self.groups.push(String::new());
        }
        self.triangles.push(triangle);
        self.group_of.push(self.groups.len() as u32 - 1);
    }

    /// The closed mesh in mm that these triangles make.
    ///
    /// # Errors
    /// `InputOutput`: no triangles, coordinates that are not numbers, an open mesh, a mesh without volume.
    pub fn heal(self, path: &Path, mm_per_unit: f64) -> Result<Healed> {
        let name = path.display();
        if self.triangles.is_empty() {
            return Err(Error::io(Stage::Model, format!("{name} holds no triangle")).advise("export the model again"));
        }
        if let Some(t) = self.triangles.iter().position(|t| t.iter().flatten().any(|x| !x.is_finite())) {
            return Err(Error::io(Stage::Model, format!("{name}: triangle {t} has a coordinate that is not a number"))
                .advise("repair or export the mesh again"));
        }
        let mut notes = self.notes.clone();
        let mut mesh = self.welded(mm_per_unit);
        let dropped = self.triangles.len() - mesh.triangles.len();
        let mut found = topology(&mesh);
        if found.open_edges > 0 {
            let tolerance = WELD * mesh.aabb().map_or(0.0, |b| b.diagonal_mm());
            let closer = weld(&mesh, tolerance);
            let again = topology(&closer);
            if again.open_edges == 0 {
                let merged = mesh.points.len() - closer.points.len();
                notes.push(format!("{merged} vertices closer than {tolerance:.2e} mm to another were merged"));
                (mesh, found) = (closer, again);
            }
        }
        if dropped > 0 {
            notes.push(format!("{dropped} degenerate triangles were dropped"));
        }
        super::refuse_open(path, &found)?;
        if found.inconsistent_edges > 0 {
            let turned = align(&mut mesh);
            notes.push(format!("{turned} triangles were wound against their neighbours and were turned"));
        } else if mesh.volume_mm3() < 0.0 {
            mesh.triangles.iter_mut().for_each(|t| t.swap(1, 2));
            notes.push("all triangles were wound inward and were turned".into());
        }
        if found.nonmanifold_edges > 0 {
            notes.push(format!("{} edges belong to more than two triangles", found.nonmanifold_edges));
        }
        let size = mesh.aabb().map_or(0.0, |b| b.diagonal_mm());
        if mesh.volume_mm3() <= 1e-9 * size.powi(3) {
            return Err(Error::io(Stage::Model, format!("{name} encloses no volume: it is a sheet, not a body"))
                .advise("export the solid, not a surface or a profile"));
        }
        Ok(Healed { mesh, bodies: found.components, notes })
    }

    /// Exactly coinciding corners become one vertex; triangles that lose a corner or have no area are left out.
    fn welded(&self, mm_per_unit: f64) -> Mesh {
        let mut mesh = Mesh::default();
        let mut index: HashMap<[u64; 3], u32> = HashMap::with_capacity(self.triangles.len());
        for (t, corners) in self.triangles.iter().enumerate() {
            let ids = corners.map(|c| {
                // + 0.0 makes -0.0 and 0.0 the same bits.
                let c = c.map(|x| x * mm_per_unit + 0.0);
                *index.entry(c.map(f64::to_bits)).or_insert_with(|| {
                    mesh.points.push(Point::new(c[0], c[1], c[2]));
                    mesh.points.len() as u32 - 1
                })
            });
            if ids[0] != ids[1] && ids[1] != ids[2] && ids[2] != ids[0] {
                mesh.triangles.push(ids);
                mesh.face_of.push(self.group_of[t]);
            }
        }
        mesh
    }
}
