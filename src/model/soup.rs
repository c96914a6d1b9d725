//! Loose triangles as mesh files give them, and their healing to one mesh ([`super::heal`]).

use std::collections::HashMap;
use std::path::Path;

use super::heal::{HealOptions, Healed, heal};
use crate::artifact::blade::Unit;
use crate::error::{Error, Result, Stage};
use crate::geometry::Point;
use crate::geometry::mesh::Mesh;

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
    /// Unit that the format prescribes; `None`: the file names none.
    pub unit: Option<Unit>,
    /// What the reader has to say.
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
    /// Longest side of the box around all corners, file units; `None` without triangles.
    pub fn size(&self) -> Option<f64> {
        let mut corners = self.triangles.iter().flatten();
        let first = *corners.next()?;
        let (lo, hi) = corners.fold((first, first), |(lo, hi), c| {
            ([0, 1, 2].map(|k| lo[k].min(c[k])), [0, 1, 2].map(|k| hi[k].max(c[k])))
        });
        Some([0, 1, 2].map(|k| hi[k] - lo[k]).into_iter().fold(0.0, f64::max))
    }

    /// The mesh in mm that these triangles make.
    ///
    /// # Errors
    /// `InputOutput`: no triangles, coordinates that are not numbers.
    pub fn heal(self, path: &Path, mm_per_unit: f64, options: &HealOptions) -> Result<Healed> {
        let name = path.display();
        if self.triangles.is_empty() {
            return Err(Error::io(Stage::Model, format!("{name} holds no triangle")).advise("export the model again"));
        }
        if let Some(t) = self.triangles.iter().position(|t| t.iter().flatten().any(|x| !x.is_finite())) {
            return Err(Error::io(Stage::Model, format!("{name}: triangle {t} has a coordinate that is not a number"))
                .advise("repair or export the mesh again"));
        }
        let (mesh, dropped) = self.welded(mm_per_unit);
        let mut healed = heal(mesh, options);
        if dropped > 0 {
            healed.notes.insert(0, format!("{dropped} degenerate triangles were dropped"));
        }
        healed.notes.splice(0..0, self.notes);
        if healed.mesh.triangles.is_empty() {
            return Err(Error::io(
                Stage::Model,
                format!("{name}: no triangle is left, all are degenerate or cancel out"),
            )
            .advise("export the solid again, with finer triangles"));
        }
        Ok(healed)
    }

    /// Exactly coinciding corners become one vertex; triangles that lose a corner are left out and counted.
    fn welded(&self, mm_per_unit: f64) -> (Mesh, usize) {
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
        let dropped = self.triangles.len() - mesh.triangles.len();
        (mesh, dropped)
    }
}
