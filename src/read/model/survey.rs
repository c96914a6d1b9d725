//! Everything that can be said of a model file, whether or not a plan can be made from it.
//!
//! In: loose triangles or exact faces from a reader. Out: a [`Survey`]: the part in the model
//! frame, the diagnosis, and either the blade that was recognised or why there is none. A part that
//! is open, that has edges with more than two triangles, that is badly wound or in several pieces
//! is surveyed like any other. What a plan needs beyond that is asked by [`Survey::into_blade`].

use std::path::Path;

use super::bodies::{self, Body};
use super::faces::{FaceModel, Stacking};
use super::folds::{self, Folds};
use super::heal::HealOptions;
use super::orient;
use super::published::{Prepared, Published};
use super::recognise::areas::areas;
use super::recognise::pieces::pieces;
use super::recognise::sector;
use super::recognise::wheel::{self, Wheel};
use super::recognise::{self, Known, Recognised};
use super::rescue;
use super::soup::Soup;
use super::units::{self, Guess, UnitSource};
use super::{ModelOptions, SEW_MM, edge_box, kinds, stem};
use crate::artifact::blade::{Blade, Diagnosis, Opening, Unit};
use crate::artifact::region::{Area, Regions};
use crate::artifact::wheel::ModelWheel;
use crate::error::{Error, ErrorKind, Infeasible, Result, Stage};
use crate::geometry::boundary::{self, openings};
use crate::geometry::brep::{Brep, FaceName};
use crate::geometry::mesh::{Mesh, topology};
use crate::geometry::part::Part;
use crate::geometry::tessellate::edges::closed_gaps;
use crate::observe::{Doubt, Observer, Remark, Warning};

/// A closed part with less volume than this share of its size's cube is a sheet folded on itself.
const NO_VOLUME: f64 = 1e-9;

/// Faces are meshed no finer than this share of the part's diagonal: the triangles of a blade of a
/// hundred metres would fill the memory.
const FINEST: f64 = 2e-6;

/// Gaps between edges of a loop that are wider than this are noted, mm.
const GAP_MM: f64 = 0.02;

/// What is in a model file.
pub struct Survey {
    /// The file's stem.
    pub name: String,
    /// Unit of the file.
    pub unit: Unit,
    /// The part in the model frame, mm.
    pub part: Part,
    /// What was found in the file.
    pub diagnosis: Diagnosis,
    /// Axis and regions, or why they were not found.
    pub found: Result<Recognised>,
    /// Deflection that the mesh of exact faces was made with, mm.
    pub deflection_mm: f64,
    /// Names of faces or groups, in the order of their numbers from 1.
    pub face_names: Vec<FaceName>,
    /// Why no plan may be made although a blade may have been found: a unit that was guessed, a
    /// part without volume.
    pub obstacle: Option<Error>,
    /// Bodies of the part, by their numbers from 1; empty where it is one piece.
    pub bodies: Vec<Body>,
    /// The wheel that the model is, or is a sector of.
    pub wheel: Option<Bladed>,
    /// Surface that the part has otherwise than its file, in the model frame.
    pub published: Option<Changed>,
}

/// What of a wheel a model has.
#[derive(Clone, Debug, PartialEq)]
pub enum Bladed {
    /// All of it.
    Whole(Wheel),
    /// One sector.
    Sector(Wheel),
}

impl Bladed {
    /// The wheel.
    pub fn wheel(&self) -> &Wheel {
        let (Bladed::Whole(wheel) | Bladed::Sector(wheel)) = self;
        wheel
    }

    /// The wheel, where the model has all of it.
    fn whole(&self) -> Option<&Wheel> {
        if let Bladed::Whole(wheel) = self { Some(wheel) } else { None }
    }

    /// In words.
    pub fn in_words(&self) -> String {
        match self {
            Bladed::Whole(wheel) => wheel.in_words(),
            Bladed::Sector(wheel) => format!("one sector of {}", wheel.in_words()),
        }
    }

    fn of_blade(&self) -> ModelWheel {
        let wheel = self.wheel();
        let blades = u32::try_from(wheel.fold).unwrap_or(u32::MAX);
        ModelWheel { axis: wheel.axis, through: wheel.through, blades, whole: self.whole().is_some() }
    }
}

/// Surface as a file has it, where sewing or healing changed it.
pub enum Changed {
    /// Exact faces.
    Faces(Published),
    /// Triangles.
    Triangles(Mesh),
}

impl Survey {
    /// What each triangle of the part belongs to; all [`Area::Other`] where no blade was found.
    pub fn areas(&self) -> Vec<Area> {
        match &self.found {
            Ok(found) => areas(&found.mesh, found, self.part.brep.is_some()),
            Err(_) => vec![Area::Other; self.part.mesh.triangles.len()],
        }
    }

    /// The regions of the part, where a blade was found.
    pub fn regions(&self) -> Option<Regions> {
        let found = self.found.as_ref().ok()?;
        Some(pieces(&self.part.clone().moved(&found.model_from_blade.inverse()), found))
    }

    /// The blade, for planning.
    ///
    /// # Errors
    /// `InputOutput`: a unit that had to be guessed, a part without volume, no blade recognised.
    pub fn into_blade(mut self, observer: &dyn Observer) -> Result<Blade> {
        if let Some(e) = self.obstacle {
            return Err(e);
        }
        let mut found = self.found?;
        let blade_from_model = found.model_from_blade.inverse();
        let part = match self.part.brep {
            // Exact faces and mesh are made again in the blade frame, so that neither carries the
            // rounding of the other's motion.
            Some(brep) => Part::from_brep(brep.moved(&blade_from_model), self.deflection_mm, observer)?,
            None => Part::from_mesh(std::mem::take(&mut found.mesh)),
        };
        let part = match self.published {
            None => part,
            Some(Changed::Triangles(mesh)) => {
                let of = mesh.face_of.iter().max().map_or(0, |f| f + 1);
                let triangles = Part::from_mesh(mesh.moved(&blade_from_model));
                part.with_published(triangles, (0..of).map(Some).collect())
            }
            Some(Changed::Faces(faces)) => {
                let Prepared { part: published, of, without } =
                    faces.part(&blade_from_model, self.deflection_mm, observer)?;
                if !without.is_empty() {
                    let remark = Remark::NotAsTrimmed { faces: without, moved_mm: faces.moved_mm };
                    self.diagnosis.notes.push(remark.clone());
                    observer.warn(Warning { stage: Stage::Model, doubt: Doubt::Model(remark) });
                }
                match published {
                    Some(published) => part.with_published(published, of),
                    None => part,
                }
            }
        };
        let regions = pieces(&part, &found);
        Ok(Blade {
            name: self.name,
            unit: self.unit,
            part,
            model_from_blade: found.model_from_blade,
            regions,
            wheel: self.wheel.as_ref().map(Bladed::of_blade),
            diagnosis: self.diagnosis,
        })
    }
}

/// Surveys exact faces.
///
/// # Errors
/// Faces that cannot be meshed; cancellation.
pub fn from_faces(
    path: &Path,
    mut shape: FaceModel,
    options: &ModelOptions,
    observer: &dyn Observer,
) -> Result<Survey> {
    // Before sewing and meshing: in a wrong unit their tolerances would be wrong too.
    let source = shape.unit_source;
    let guess = units::judge(path, edge_box(&shape.brep), shape.unit, source);
    if let Guess::Other { unit, .. } = &guess {
        scale(&mut shape.brep, unit.mm() / shape.unit.mm());
    }
    let mut diagnosis = Diagnosis {
        format: shape.format,
        unit_reason: shape.unit_reason,
        bodies: shape.bodies,
        faces: kinds(&shape.brep),
        notes: shape.notes,
        ..Diagnosis::default()
    };
    let doubt = if let Guess::Odd(note) = &guess { Some(note.clone()) } else { None };
    let (unit, mut obstacle) = guess.take(shape.unit, &mut diagnosis);
    observer.check(Stage::Model)?;
    let Folds { count, longest_mm, at } = folds::leave_out(&mut shape.brep);
    if count > 0 {
        diagnosis.notes.push(Remark::FoldsLeftOut { count, longest_mm, at_mm: at.into() });
    }
    let deflection_mm = finest(&shape.brep, options.deflection_mm, &mut diagnosis.notes);
    let (mut part, rescued) = rescue::part(shape.brep, deflection_mm, &SEW_MM, observer)?;
    diagnosis.notes.extend(rescued.sewn.notes());
    diagnosis.notes.extend(rescued.notes);
    // In a wrong unit the tolerances of sewing and meshing are wrong, and that may be all that is
    // the matter.
    obstacle = obstacle.or(rescued.obstacle.map(|e| match doubt {
        Some(doubt) => e.advise(format!("{doubt}; if it is right, check the face and write the model again")),
        None => e,
    }));
    let options = &ModelOptions { deflection_mm: rescued.deflection_mm, ..options.clone() };
    observer.progress(Stage::Model, 1, 3);
    let mut published = rescued.published;
    if let Some(mut brep) = part.brep.take() {
        diagnosis.notes.extend(gaps(&brep));
        diagnosis.notes.extend(orient::orient(&mut brep, &mut part.mesh));
        if let Some(faces) = &mut published {
            faces.orient(&brep);
            diagnosis.notes.push(faces.note());
        }
        part.brep = Some(brep);
    }
    let face_names = part.brep.iter().flat_map(|b| &b.faces).map(|f| f.name.clone()).collect();
    let read = ReadPart { unit, source, part, face_names, diagnosis, obstacle, stacking: shape.stacking };
    let mut survey = read.survey(path, options, observer)?;
    survey.published = published.map(Changed::Faces);
    if options.close_holes_mm.is_some() && !survey.diagnosis.openings.is_empty() {
        survey.diagnosis.notes.push(Remark::ExactOpeningsStay);
    }
    Ok(survey)
}

/// The gaps between edges of loops that were closed, where any is wide.
fn gaps(brep: &Brep) -> Option<Remark> {
    let gaps = closed_gaps(brep, GAP_MM);
    let (widest_mm, at) = gaps.iter().copied().max_by(|a, b| a.0.total_cmp(&b.0))?;
    Some(Remark::GapsClosed { count: gaps.len(), widest_mm, at_mm: at.into() })
}

/// The deflection that was asked for, or the finest for a part of this size, which is noted.
fn finest(brep: &Brep, asked_mm: f64, notes: &mut Vec<Remark>) -> f64 {
    let least_mm = FINEST * edge_box(brep).map_or(0.0, |b| b.diagonal_mm());
    if asked_mm < least_mm {
        notes.push(Remark::MeshedCoarser { least_mm, share: FINEST, asked_mm });
    }
    asked_mm.max(least_mm)
}

/// Scales exact faces about the origin.
fn scale(brep: &mut Brep, factor: f64) {
    let poles = brep.faces.iter_mut().flat_map(|f| f.surface.points.iter_mut());
    for p in poles.chain(brep.edges.iter_mut().flat_map(|e| e.curve.points.iter_mut())) {
        p.x *= factor;
        p.y *= factor;
        p.z *= factor;
    }
}

/// Surveys loose triangles.
///
/// # Errors
/// No triangles, or coordinates that are not numbers.
pub fn from_soup(path: &Path, soup: Soup, options: &ModelOptions, observer: &dyn Observer) -> Result<Survey> {
    let size = soup.size();
    let (unit, unit_reason) = match (options.unit, soup.unit) {
        (Some(unit), _) => (unit, format!("{}, as told", units::name(unit))),
        (None, Some(unit)) => (unit, format!("{}, as the format says", units::name(unit))),
        (None, None) => (Unit::Mm, units::unnamed(size)),
    };
    let mut diagnosis = Diagnosis { format: soup.format.clone(), unit_reason, ..Diagnosis::default() };
    diagnosis.faces = vec![("groups".into(), soup.groups.len())];
    let source = match (options.unit, soup.unit) {
        (Some(_), _) => UnitSource::Told,
        (None, Some(_)) => UnitSource::Declared,
        (None, None) => UnitSource::Assumed,
    };
    let guess = units::judge_size(path, size.map(|s| s * unit.mm()), unit, source);
    let (unit, obstacle) = guess.take(unit, &mut diagnosis);
    let heal = HealOptions { weld_mm: options.weld_mm, close_holes_mm: options.close_holes_mm };
    let face_names = soup.groups.iter().map(|name| name.as_str().into()).collect();
    let healed = soup.heal(path, unit.mm(), &heal)?;
    observer.check(Stage::Model)?;
    observer.progress(Stage::Model, 1, 3);
    diagnosis.notes.extend(healed.notes);
    diagnosis.bodies = topology(&healed.mesh).components;
    let part = Part::from_mesh(healed.mesh);
    let read = ReadPart { unit, source, part, face_names, diagnosis, obstacle, stacking: None };
    let mut survey = read.survey(path, options, observer)?;
    survey.published = healed.published.map(Changed::Triangles);
    Ok(survey)
}

/// A part as it was read, before the blade is looked for on it.
struct ReadPart {
    unit: Unit,
    source: UnitSource,
    part: Part,
    face_names: Vec<FaceName>,
    diagnosis: Diagnosis,
    obstacle: Option<Error>,
    stacking: Option<Stacking>,
}

impl ReadPart {
    /// Diagnoses the mesh and looks for the blade.
    fn survey(self, path: &Path, options: &ModelOptions, observer: &dyn Observer) -> Result<Survey> {
        let ReadPart { unit, source, part, face_names, mut diagnosis, mut obstacle, stacking } = self;
        diagnose(&part.mesh, &mut diagnosis);
        let size = part.mesh.aabb().map_or(0.0, |b| b.diagonal_mm());
        if diagnosis.closed && part.mesh.volume_mm3() <= NO_VOLUME * size.powi(3) {
            let e =
                Error::io(Stage::Model, format!("{} encloses no volume: it is a sheet, not a body", path.display()))
                    .advise("export the solid, not a surface or a profile");
            obstacle.get_or_insert(e);
        }
        // As many openings as pieces, or more: each piece is a sheet.
        let sheets = diagnosis.pieces > 1 && diagnosis.openings.len() >= diagnosis.pieces;
        let bodies = if diagnosis.pieces > 1 { bodies::bodies(&part.mesh) } else { Vec::new() };
        let own = chosen(&bodies, options.body)?;
        let looked_at = own.map_or(&part.mesh, |b| &b.mesh);
        let bladed = wheel::wheel(looked_at).map(Bladed::Whole);
        let bladed = bladed.or_else(|| sector::sector(looked_at).map(Bladed::Sector));
        let wheel = bladed.as_ref().and_then(Bladed::whole);
        let sector_of = if let Some(Bladed::Sector(w)) = &bladed { Some(w) } else { None };
        let known = Known { stacking: stacking.as_ref(), wheel, sector_of };
        let found = recognised(looked_at, &known, &face_names, options, sheets && own.is_none());
        let found = on_whole(found, own, &part.mesh, &bodies);
        if let (Ok(_), Some(w)) = (&found, wheel) {
            diagnosis.notes.push(Remark::Wheel { wheel: w.in_words() });
        }
        if let (Ok(found), None, [_, _, ..]) = (&found, own, &bodies[..]) {
            diagnosis.notes.extend(assembly(found, part.brep.is_some(), &bodies));
        }
        observer.progress(Stage::Model, 2, 3);
        if let Ok(found) = &found {
            diagnosis.notes.extend(found.against.iter().chain(&found.doubts).cloned());
            diagnosis.axis_against = found.against.clone();
            let [lo, hi] = found.heights.part_x_mm;
            let slender = || units::slender(hi - lo, found.chord_mm(), unit, source);
            if let Some(doubt) = found.round.is_none().then(slender).flatten() {
                obstacle.get_or_insert_with(|| Error::io(Stage::Model, format!("{}: {doubt}", path.display())));
                diagnosis.notes.push(doubt);
            }
            // After the unit: a part in the wrong one looks like nothing.
            if let Some(message) = found.unlike.clone().filter(|_| !options.names_airfoil()) {
                let e = Error::infeasible(Stage::Model, message, Infeasible::NotABlade);
                obstacle.get_or_insert_with(|| {
                    e.advise(
                        "if it is one, say where: its axis from root to tip (--axis) or its faces (--faces airfoil=…)",
                    )
                });
            }
        }
        Ok(Survey {
            name: stem(path),
            unit,
            part,
            diagnosis,
            found,
            deflection_mm: options.deflection_mm,
            face_names,
            obstacle,
            wheel: bladed,
            published: None,
            bodies,
        })
    }
}

/// The body that the user chose.
///
/// # Errors
/// `Usage`: there is no such body.
fn chosen(bodies: &[Body], number: Option<u32>) -> Result<Option<&Body>> {
    let Some(number) = number.filter(|n| *n != 1 || bodies.len() > 1) else { return Ok(None) };
    let body = (number as usize).checked_sub(1).and_then(|k| bodies.get(k));
    body.map(Some).ok_or_else(|| {
        Error::usage(
            Stage::Model,
            match bodies.len() {
                0 | 1 => format!("there is no body {number}; the model is one body"),
                n => format!("there is no body {number}; the model has {n}: {}", bodies::list(bodies)),
            },
        )
        .advise("give --body (model.body) one of these numbers, or leave it out")
    })
}

/// What was recognised on a body, with the mesh of the whole part; an error with the bodies to
/// choose from.
fn on_whole(found: Result<Recognised>, own: Option<&Body>, mesh: &Mesh, bodies: &[Body]) -> Result<Recognised> {
    match found {
        Ok(mut found) => {
            if let Some(own) = own {
                found.mesh = mesh.clone().moved(&found.model_from_blade.inverse());
                if let Some(round) = &mut found.round {
                    round.triangles = round.triangles.iter().map(|t| own.triangles[*t as usize]).collect();
                    round.triangles.sort_unstable();
                }
            }
            Ok(found)
        }
        Err(mut e) if own.is_none() && bodies.len() > 1 && e.kind != ErrorKind::Usage => {
            e.advice = Some(format!(
                "the model has {} bodies, choose the blade's with --body: {}",
                bodies.len(),
                bodies::list(bodies)
            ));
            Err(e)
        }
        Err(e) => Err(e),
    }
}

/// What is said of a model of several bodies: on which the airfoil was found.
fn assembly(found: &Recognised, is_exact: bool, bodies: &[Body]) -> Option<Remark> {
    let areas = areas(&found.mesh, found, is_exact);
    let airfoil_mm2 = |b: &Body| -> f64 {
        let own = b.triangles.iter().map(|t| *t as usize).filter(|t| areas.get(*t) == Some(&Area::Airfoil));
        own.map(|t| found.mesh.triangle_area_mm2(t)).sum()
    };
    let (number, body) = bodies.iter().enumerate().max_by(|a, b| airfoil_mm2(a.1).total_cmp(&airfoil_mm2(b.1)))?;
    Some(Remark::Assembly { bodies: bodies.len(), number: number + 1, body: body.in_words() })
}

/// Looks for the blade on the part, or on its body that the user chose. Sections of an open part
/// are open where they meet an opening, so all rings are closed for the search; but not those of
/// sheets that face each other, whose sections are joined where their ends are near.
fn recognised(
    mesh: &Mesh,
    known: &Known,
    face_names: &[FaceName],
    options: &ModelOptions,
    sheets: bool,
) -> Result<Recognised> {
    let mut whole = mesh.clone();
    whole.corner_uv.clear();
    if sheets || boundary::close(&mut whole, f64::INFINITY, face_names.len() as u32) == 0 {
        return recognise::recognise(mesh, face_names, options, known);
    }
    let mut found = recognise::recognise(&whole, face_names, options, known)?;
    found.mesh = mesh.clone().moved(&found.model_from_blade.inverse());
    Ok(found)
}

/// Openings, edges and pieces of the mesh, model frame.
fn diagnose(mesh: &Mesh, d: &mut Diagnosis) {
    let t = topology(mesh);
    d.closed = t.open_edges == 0;
    d.pieces = t.components;
    d.open_edges = t.open_edges;
    d.nonmanifold_edges = t.nonmanifold_edges;
    d.first_nonmanifold_edge = t.first_nonmanifold_edge.map(Into::into);
    d.inconsistent_edges = t.inconsistent_edges;
    d.openings = openings(mesh)
        .iter()
        .map(|o| Opening {
            edges: o.edges(),
            length_mm: o.length_mm(mesh),
            width_mm: o.width_mm(mesh),
            at_mm: o.vertices.first().map_or([0.0; 3], |v| mesh.points[*v as usize].into()),
        })
        .collect();
    d.openings.sort_by(|a, b| b.length_mm.total_cmp(&a.length_mm));
}
