//! Loose triangles as mesh files give them, and their healing to one mesh ([`super::heal`]).

use std::path::Path;

use super::heal::{HealOptions, Healed, heal};
use crate::artifact::blade::Unit;
use crate::error::{Error, Result, Stage};
use crate::geometry::Point;
use crate::geometry::mesh::Mesh;
use crate::geometry::nurbs::curve::FARTHEST_MM;
use crate::observe::Remark;

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
    pub notes: Vec<Remark>,
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
        let far = |t: &[[f64; 3]; 3]| t.iter().flatten().any(|x| !((x * mm_per_unit).abs() <= FARTHEST_MM));
        if let Some((t, corners)) = self.triangles.iter().enumerate().find(|(_, t)| far(t)) {
            let at = corners.iter().flatten().fold(0.0f64, |a, x| a.max(x.abs()));
            return Err(Error::io(
                Stage::Model,
                format!("{name}: triangle {t} is out of all bounds, {at:.3e} of the file's units from the origin"),
            )
            .advise("repair or export the mesh again"));
        }
        let (mesh, dropped) = self.welded(mm_per_unit);
        let mut healed = heal(mesh, options);
        if dropped > 0 {
            healed.notes.insert(0, Remark::DegenerateDropped { triangles: dropped });
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

    /// The mesh in mm in which exactly coinciding corners are one vertex, and how many triangles
    /// lost a corner by that and were left out.
    pub fn welded(&self, mm_per_unit: f64) -> (Mesh, usize) {
        let count = self.triangles.len();
        let mut mesh = Mesh::default();
        mesh.triangles.reserve(count);
        mesh.face_of.reserve(count);
        let mut index = Index::for_points(3 * count);
        for (corners, group) in self.triangles.iter().zip(&self.group_of) {
            let ids = corners.map(|c| index.of(c.map(|x| x * mm_per_unit), &mut mesh.points));
            if ids[0] != ids[1] && ids[1] != ids[2] && ids[2] != ids[0] {
                mesh.triangles.push(ids);
                mesh.face_of.push(*group);
            }
        }
        let dropped = count - mesh.triangles.len();
        (mesh, dropped)
    }
}

/// Numbers of points by their coordinates: a table with open addresses, half of them free at least.
/// Welding is most of what reading a binary STL takes, and a general map takes twice as long for
/// it.
struct Index {
    slots: Vec<u32>,
}

/// A free slot.
const FREE: u32 = u32::MAX;

impl Index {
    /// For so many points at most.
    fn for_points(most: usize) -> Self {
        Index { slots: vec![FREE; (2 * most).next_power_of_two()] }
    }

    /// Number of the point with these coordinates, which is added where there is none.
    fn of(&mut self, c: [f64; 3], points: &mut Vec<Point>) -> u32 {
        // + 0.0 makes -0.0 and 0.0 the same bits.
        let bits = c.map(|x| (x + 0.0).to_bits());
        let mut slot = mixed(bits) as usize;
        loop {
            slot &= self.slots.len() - 1;
            match points.get(self.slots[slot] as usize) {
                Some(p) if [p.x, p.y, p.z].map(f64::to_bits) == bits => return self.slots[slot],
                Some(_) => slot += 1,
                None => break,
            }
        }
        self.slots[slot] = points.len() as u32;
        points.push(Point::from(bits.map(f64::from_bits)));
        self.slots[slot]
    }
}

/// The low bits of the result depend on all bits: the steps of SplitMix64 (Steele, Lea, Flood
/// 2014).
fn mixed(bits: [u64; 3]) -> u64 {
    bits.into_iter().fold(0, |hash, word| {
        let mut z = (hash ^ word).wrapping_add(0x9e37_79b9_7f4a_7c15);
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ (z >> 31)
    })
}
