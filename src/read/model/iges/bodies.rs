//! Which entities are bodies, and where they are placed.

use std::collections::BTreeSet;

use nalgebra::{Matrix4, Vector3};

use super::build::Build;
use super::file::{Entity, File, Params};
use super::{solids, trims};
use crate::error::Result;
use crate::observe::Remark;

/// Instances inside one another deeper than this are taken for circular.
const DEEPEST: usize = 16;
/// More placed bodies than this are taken for damage.
const MOST_INSTANCES: usize = 100_000;

/// Builds every body of the file, placed by `root`. Returns what the user should know.
///
/// # Errors
/// Anything that a body needs and that is damaged or cannot be read.
pub fn build_all(build: &mut Build, root: &Matrix4<f64>) -> Result<Vec<Remark>> {
    Bodies { build, instances: 0 }.all(root)
}

/// The bodies of a file on their way into a B-rep.
struct Bodies<'b, 'f> {
    build: &'b mut Build<'f>,
    /// Placed so far.
    instances: usize,
}

/// Directory lines of a list of entities, each with a flag.
fn flagged(p: &mut Params) -> Result<Vec<usize>> {
    (0..p.count(2)?).map(|_| p.target().map(|t| t.line).and_then(|l| p.int().map(|_| l))).collect()
}

/// Whether an entity can be a face by itself.
fn is_surface(kind: u32) -> bool {
    matches!(kind, 114 | 118 | 120 | 122 | 128 | 196 | 198)
}

impl<'f> Bodies<'_, 'f> {
    fn all(&mut self, root: &Matrix4<f64>) -> Result<Vec<Remark>> {
        let mut notes = Vec::new();
        let used = self.used_by_others()?;
        let independent = |e: &&Entity| !used.contains(&e.line);
        let bodies = |e: &&Entity| matches!(e.kind, 186 | 514 | 510 | 144 | 143 | 408 | 430);
        let surfaces = |e: &&Entity| is_surface(e.kind) || (e.kind == 108 && e.form != 0);
        let all: Vec<&Entity> =
            self.build.file.entities.iter().filter(|e| bodies(e) || surfaces(e)).filter(independent).collect();
        let shown: Vec<&Entity> = all.iter().copied().filter(|e| !e.blanked).collect();
        let taken = if shown.is_empty() { &all } else { &shown };
        if taken.len() < all.len() {
            notes.push(Remark::HiddenPassedOver { count: all.len() - taken.len() });
        }
        for e in taken {
            self.instance(e, root, 0)?;
        }
        let faces = |e: &&&Entity| !matches!(e.kind, 186 | 514 | 408 | 430);
        self.build.bodies += usize::from(taken.iter().any(|e| faces(&e)));
        Ok(notes)
    }

    /// Directory lines of entities that are parts of others, and so no bodies of their own.
    fn used_by_others(&self) -> Result<BTreeSet<usize>> {
        let mut used = BTreeSet::new();
        for e in &self.build.file.entities {
            let mut p = match e.kind {
                143 | 144 | 186 | 308 | 408 | 430 | 510 | 514 => self.build.file.params(e)?,
                _ => continue,
            };
            match e.kind {
                308 => used.extend(self.members(e)?.iter().map(|m| m.line)),
                514 => used.extend(flagged(&mut p)?),
                186 => {
                    used.insert(p.target()?.line);
                    p.skip(1);
                    used.extend(flagged(&mut p)?);
                }
                143 => {
                    p.skip(1);
                    used.insert(p.target()?.line);
                }
                _ => {
                    used.insert(p.target()?.line);
                }
            }
        }
        Ok(used)
    }

    /// Members of a subfigure definition 308.
    fn members(&self, e: &Entity) -> Result<Vec<&'f Entity>> {
        let file: &'f File<'f> = self.build.file;
        let e = file.entity(e.line).ok_or_else(|| file.error(e, "is missing"))?;
        let mut p = file.params(e)?;
        p.skip(2);
        (0..p.count(1)?).map(|_| p.target()).collect()
    }

    fn instance(&mut self, e: &Entity, to: &Matrix4<f64>, depth: usize) -> Result<()> {
        self.instances += 1;
        if depth > DEEPEST || self.instances > MOST_INSTANCES {
            return Err(self.build.file.error(e, "is one of too many instances, or one inside itself"));
        }
        self.build.begin_body();
        let before = self.build.brep.faces.len();
        match e.kind {
            186 => solids::add_solid(self.build, e, to)?,
            514 => solids::add_shell(self.build, e, to, false)?,
            510 => solids::add_face(self.build, e, to, false)?,
            430 => {
                let to = to * self.build.file.transform(e)?;
                let solid = self.build.file.params(e)?.target()?;
                return self.instance(solid, &to, depth + 1);
            }
            408 => return self.subfigure(e, to, depth),
            _ => trims::add_face(self.build, e, to)?,
        }
        self.build.bodies += usize::from(matches!(e.kind, 186 | 514) && self.build.brep.faces.len() > before);
        Ok(())
    }

    /// 408: a definition 308 at a place, scaled.
    fn subfigure(&mut self, e: &Entity, to: &Matrix4<f64>, depth: usize) -> Result<()> {
        let mut p = self.build.file.params(e)?;
        let definition = p.target()?;
        let at = Vector3::from(p.triple()?);
        let scale = p.optional()?.filter(|s| *s != 0.0).unwrap_or(1.0);
        if definition.kind != 308 {
            return Err(self.build.file.error(definition, "stands where a subfigure (308) belongs"));
        }
        let to = to
            * self.build.file.transform(e)?
            * Matrix4::new_translation(&at)
            * Matrix4::new_scaling(scale)
            * self.build.file.transform(definition)?;
        for m in self.members(definition)? {
            if matches!(m.kind, 186 | 514 | 510 | 144 | 143 | 408 | 430) || is_surface(m.kind) {
                self.instance(m, &to, depth + 1)?;
            }
        }
        Ok(())
    }
}
