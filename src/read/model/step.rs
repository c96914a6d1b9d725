//! STEP (ISO 10303-21), through `step-io`: bodies, their placements and the length unit, to one
//! B-rep in mm.
//!
//! Every solid, shell and loose face becomes faces of one [`Brep`], each as often as the assembly
//! places it. Edges keep their identity: two faces that name the same `EDGE_CURVE` share one edge,
//! which is what makes the tessellation watertight. A face that cannot be converted exactly is an
//! error that names it; so are entities that the reader had to drop where faces are missing because
//! of them.

mod edges;
mod patch;

use std::collections::HashMap;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::path::Path;

use nalgebra::{Matrix4, Vector4};
use step_io::model::EntityKey;
use step_io::scene::{Bound, Edge as StepEdge, Face as StepFace, MappedInstance, ProductDef, Scene, Shell};
use step_io::scene::{Solid, SurfaceKind as StepKind, SurfaceModel};
use step_io::{Orientation, Report, StepModel};

use super::faces::FaceModel;
use super::units::UnitSource;
use crate::artifact::blade::Unit;
use crate::error::{Error, Result, Stage};
use crate::geometry::Point;
use crate::geometry::brep::{Brep, Coedge, Edge, Face, FaceName, SurfaceKind};
use crate::geometry::nurbs::{NurbsCurve, NurbsSurface};
use crate::observe::Remark;

/// Places on each edge that the surface of its face has to cover.
const EDGE_PLACES: usize = 32;
/// Assemblies deeper than this are taken for circular.
const DEEPEST: usize = 64;

/// Reads a STEP file.
///
/// # Errors
/// `InputOutput`: not STEP, no faces, faces or edges that cannot be read or converted.
pub fn read(path: &Path, bytes: &[u8], unit: Option<Unit>) -> Result<FaceModel> {
    // Last resort around a parser that is not ours: whatever it meets in a damaged file, the user
    // gets a sentence.
    catch_unwind(AssertUnwindSafe(|| read_guarded(path, bytes, unit))).unwrap_or_else(|_| {
        Err(Error::io(Stage::Model, format!("{} is damaged: the STEP parser gave up on it", path.display())))
    })
}

fn read_guarded(path: &Path, bytes: &[u8], unit: Option<Unit>) -> Result<FaceModel> {
    let name = path.display();
    let (model, report) = step_io::read(bytes).map_err(|e| {
        Error::io(Stage::Model, format!("{name} cannot be read as STEP: {e}"))
            .advise("the file is damaged or was cut off: export it again")
    })?;
    let scene = model.scene();
    let mut notes = Vec::new();
    check_dropped(path, bytes, &scene, &report, &mut notes)?;
    let told = unit.is_some();
    let (unit, mm, unit_reason) = length_unit(&scene, unit);
    let mut build =
        Build { path, model: &model, mm, brep: Brep::default(), edges: HashMap::new(), placement: 0, bodies: 0 };
    let placed = place_all(&scene);
    for body in &placed {
        build.body(body)?;
    }
    if build.brep.faces.is_empty() {
        return Err(Error::io(Stage::Model, format!("{name} holds no solid, shell or face"))
            .advise("export the body of the blade, not a drawing, a sketch or an empty assembly"));
    }
    let family = match model.header().schema.family {
        step_io::ApFamily::Ap203 => "AP203",
        step_io::ApFamily::Ap214 => "AP214",
        step_io::ApFamily::Ap242 => "AP242",
        _ => "of unknown schema",
    };
    notes.extend(scene.warnings().iter().map(|w| Remark::StepReader { words: w.to_string() }));
    let unit_source = match (told, scene.units().length.is_some()) {
        (true, _) => UnitSource::Told,
        (false, true) => UnitSource::Declared,
        (false, false) => UnitSource::Assumed,
    };
    Ok(FaceModel {
        brep: build.brep,
        bodies: build.bodies,
        format: format!("STEP {family}"),
        unit,
        unit_reason,
        unit_source,
        notes,
        stacking: None,
    })
}

/// Refuses a file of which faces were lost; notes what else was skipped.
fn check_dropped(path: &Path, bytes: &[u8], scene: &Scene, report: &Report, notes: &mut Vec<Remark>) -> Result<()> {
    let Some((id, reason)) = report.dropped.first() else { return Ok(()) };
    let count = report.dropped.len();
    let in_file = count_entities(bytes, &[b"ADVANCED_FACE", b"FACE_SURFACE"]);
    let read = scene.all_faces().count();
    if read < in_file {
        return Err(Error::io(
            Stage::Model,
            format!(
                "{}: {} of {in_file} faces cannot be read; the first bad entity is #{id} ({reason})",
                path.display(),
                in_file - read
            ),
        )
        .advise("repair the body in CAD or export it with another schema"));
    }
    notes.push(Remark::EntitiesSkipped { count, first: *id, reason: reason.to_string() });
    Ok(())
}

/// Number of simple entities of these types (`#7 = NAME(`) in the text.
fn count_entities(bytes: &[u8], names: &[&[u8]]) -> usize {
    let mut count = 0;
    for (i, _) in bytes.iter().enumerate().filter(|(_, b)| **b == b'=') {
        let rest = bytes[i + 1..].trim_ascii_start();
        let hit = |n: &&&[u8]| rest.starts_with(n) && rest[n.len()..].trim_ascii_start().starts_with(b"(");
        count += usize::from(names.iter().find(hit).is_some());
    }
    count
}

/// The unit of coordinates: (unit, mm per unit, reason).
fn length_unit(scene: &Scene, told: Option<Unit>) -> (Unit, f64, String) {
    let declared = scene.units().length;
    if let Some(unit) = told {
        let file = declared.map_or_else(|| "nothing".to_owned(), |u| u.name);
        return (unit, unit.mm(), format!("{}, as told (the file says {file})", super::units::name(unit)));
    }
    let Some(declared) = declared else {
        return (Unit::Mm, 1.0, "mm, since the file names no length unit".to_owned());
    };
    let mm = declared.to_si * 1000.0;
    let known = [Unit::Mm, Unit::Cm, Unit::M, Unit::Inch].into_iter().find(|u| (u.mm() / mm - 1.0).abs() < 1e-9);
    match known {
        Some(unit) => (unit, unit.mm(), format!("{}, as the file says", super::units::name(unit))),
        None => (Unit::Mm, mm, format!("mm, converted from the file's {} ({mm} mm)", declared.name)),
    }
}

/// A body where the assembly puts it.
struct PlacedBody<'m> {
    body: StepBody<'m>,
    /// Placement in file units.
    to: Matrix4<f64>,
}

enum StepBody<'m> {
    Solid(Solid<'m>),
    Surfaces(SurfaceModel<'m>),
    Loose(Vec<StepFace<'m>>),
}

impl PlacedBody<'_> {
    fn key(&self) -> Option<EntityKey> {
        match &self.body {
            StepBody::Solid(s) => Some(s.key()),
            StepBody::Surfaces(s) => Some(s.key()),
            StepBody::Loose(_) => None,
        }
    }
}

/// All bodies with their placements: those of the product structure, mapped items, and whatever
/// belongs to neither.
fn place_all<'m>(scene: &'m Scene<'m>) -> Vec<PlacedBody<'m>> {
    let (mut products, mut mapped) = (Vec::new(), Vec::new());
    let mut assembled = false;
    for root in scene.root_definitions() {
        assembled |= root.occurrences().next().is_some();
        place_product(&root, Matrix4::identity(), 0, &mut products);
    }
    let children: Vec<EntityKey> =
        scene.all_mapped_instances().flat_map(|i| i.mapped_children().map(|c| c.key()).collect::<Vec<_>>()).collect();
    for item in scene.all_mapped_instances().filter(|i| !children.contains(&i.key())) {
        place_mapped(&item, Matrix4::identity(), 0, &mut mapped);
    }
    // Some writers place a component both ways: the second way then only adds what the first does
    // not reach. Without an assembly a component's own definition is its template, so mapped items
    // come first.
    let (mut out, others) = if assembled { (products, mapped) } else { (mapped, products) };
    let bare = scene
        .all_solids()
        .map(StepBody::Solid)
        .chain(scene.all_surface_models().map(StepBody::Surfaces))
        .map(|body| PlacedBody { body, to: Matrix4::identity() });
    for group in [others, bare.collect()] {
        let reached: Vec<Option<EntityKey>> = out.iter().map(PlacedBody::key).collect();
        out.extend(group.into_iter().filter(|p| !reached.contains(&p.key())));
    }
    let owned = |f: &StepFace| {
        f.solid().is_some() || f.shell().is_some_and(|s| s.surface_model().is_some() || s.solid().is_some())
    };
    let loose: Vec<StepFace> = scene.all_faces().filter(|f| !owned(f)).collect();
    if !loose.is_empty() {
        out.push(PlacedBody { body: StepBody::Loose(loose), to: Matrix4::identity() });
    }
    out
}

fn matrix(transform: Option<step_io::scene::Transform>) -> Matrix4<f64> {
    transform.and_then(|t| t.matrix()).map_or_else(Matrix4::identity, |m| Matrix4::from_fn(|i, j| m[i][j]))
}

fn place_product<'m>(def: &ProductDef<'m>, to: Matrix4<f64>, depth: usize, out: &mut Vec<PlacedBody<'m>>) {
    if depth > DEEPEST {
        return;
    }
    out.extend(def.solids().map(|s| PlacedBody { body: StepBody::Solid(s), to }));
    out.extend(def.surface_models().map(|s| PlacedBody { body: StepBody::Surfaces(s), to }));
    for part in def.occurrences() {
        if let Some(child) = part.definition() {
            place_product(&child, to * matrix(part.transform()), depth + 1, out);
        }
    }
}

fn place_mapped<'m>(item: &MappedInstance<'m>, to: Matrix4<f64>, depth: usize, out: &mut Vec<PlacedBody<'m>>) {
    // A mapped item without a frame in space is a view of a drawing.
    let Some(transform) = item.transform().filter(|_| depth <= DEEPEST) else { return };
    let to = to * matrix(Some(transform));
    out.extend(item.solids().map(|s| PlacedBody { body: StepBody::Solid(s), to }));
    out.extend(item.surface_models().map(|s| PlacedBody { body: StepBody::Surfaces(s), to }));
    for child in item.mapped_children() {
        place_mapped(&child, to, depth + 1, out);
    }
}

/// The B-rep as it grows.
struct Build<'a> {
    path: &'a Path,
    model: &'a StepModel,
    mm: f64,
    brep: Brep,
    /// Edge of the B-rep by placed body and `EDGE_CURVE`; none for those without length.
    edges: HashMap<(usize, EntityKey), Option<usize>>,
    placement: usize,
    bodies: usize,
}

impl Build<'_> {
    fn body(&mut self, placed: &PlacedBody) -> Result<()> {
        let before = self.brep.faces.len();
        match &placed.body {
            StepBody::Solid(s) => {
                for (shell, orientation) in s.outer().into_iter().chain(s.voids()) {
                    self.shell(&shell, orientation, &placed.to)?;
                }
            }
            StepBody::Surfaces(s) => {
                for (shell, orientation) in s.shells() {
                    self.shell(&shell, orientation, &placed.to)?;
                }
            }
            StepBody::Loose(faces) => {
                for face in faces {
                    self.face(face, false, &placed.to)?;
                }
            }
        }
        self.placement += 1;
        self.bodies += usize::from(self.brep.faces.len() > before);
        Ok(())
    }

    fn shell(&mut self, shell: &Shell, orientation: Orientation, to: &Matrix4<f64>) -> Result<()> {
        for face in shell.faces() {
            self.face(&face, orientation == Orientation::Reversed, to)?;
        }
        Ok(())
    }

    fn face(&mut self, face: &StepFace, shell_reversed: bool, to: &Matrix4<f64>) -> Result<()> {
        let number = self.brep.faces.len() + 1;
        let name = match face.name().trim() {
            "" | "NONE" => FaceName::Numbered(number),
            given => FaceName::Given(number, given.to_owned()),
        };
        let said = name.to_string();
        let kind = kind_of(&face.surface().kind());
        let patch = face.to_nurbs().map(|p| surface(&p, self.mm, to));
        if let Some(patch) = &patch {
            patch.validate().map_err(|e| self.bad(&said, &e))?;
        }
        let mut loops = Vec::new();
        for bound in face.bounds() {
            let one = self.bound(&bound, &said, to)?;
            if !one.is_empty() {
                loops.push(one);
            }
        }
        let on =
            |c: &Coedge| (0..=EDGE_PLACES).map(|k| self.brep.edges[c.edge].at(k as f64 / EDGE_PLACES as f64)).collect();
        let points: Vec<Point> = loops.iter().flatten().flat_map::<Vec<Point>, _>(on).collect();
        let plane = || match face.surface().kind() {
            StepKind::Plane(p) => patch::of_plane(self.model, p, &points, self.mm, to),
            _ => None,
        };
        let surface = patch.or_else(plane).ok_or_else(|| {
            Error::io(
                Stage::Model,
                format!("{}: {name} lies on a surface that cannot be written as NURBS ({kind:?})", self.path.display()),
            )
            .advise("repair the face in CAD, or export it as B-spline")
        })?;
        let surface = patch::covering(surface, kind, &points);
        let reversed = (face.orientation() == Orientation::Reversed) != shell_reversed;
        self.brep.faces.push(Face { name, kind, surface, reversed, loops });
        Ok(())
    }

    fn bad(&self, what: &str, error: &Error) -> Error {
        Error::io(Stage::Model, format!("{}: {what} is damaged: {}", self.path.display(), error.message))
            .advise("repair the body in CAD")
    }

    /// The loop's coedges; none for a vertex loop (a pole needs no trimming).
    fn bound(&mut self, bound: &Bound, face: &str, to: &Matrix4<f64>) -> Result<Vec<Coedge>> {
        let mut out = Vec::new();
        for (edge, orientation) in bound.oriented_edges() {
            let index = self.edge(&edge, face, to)?;
            out.extend(index.map(|edge| Coedge { edge, reversed: orientation == Orientation::Reversed }));
        }
        if bound.orientation() == Orientation::Reversed {
            out.reverse();
            out.iter_mut().for_each(|c| c.reversed = !c.reversed);
        }
        Ok(out)
    }

    /// Number of an edge in the B-rep; `None`: it has no length.
    fn edge(&mut self, edge: &StepEdge, face: &str, to: &Matrix4<f64>) -> Result<Option<usize>> {
        let key = (self.placement, edge.key());
        if let Some(&index) = self.edges.get(&key) {
            return Ok(index);
        }
        let found = edges::course(edge, self.mm, to).map_err(|why| {
            Error::io(Stage::Model, format!("{}: an edge of {face} {why}", self.path.display()))
                .advise("repair the body in CAD, or export it with another schema")
        })?;
        let index = found.map(|curve| {
            let t = curve.domain();
            self.brep.edges.push(Edge { curve, t });
            self.brep.edges.len() - 1
        });
        self.edges.insert(key, index);
        Ok(index)
    }
}

fn kind_of(kind: &StepKind) -> SurfaceKind {
    match kind {
        StepKind::Plane(_) => SurfaceKind::Plane,
        StepKind::Cylindrical(_) => SurfaceKind::Cylinder,
        StepKind::Conical(_) => SurfaceKind::Cone,
        StepKind::Spherical(_) => SurfaceKind::Sphere,
        StepKind::Toroidal(_) | StepKind::DegenerateToroidal(_) => SurfaceKind::Torus,
        StepKind::LinearExtrusion(_) => SurfaceKind::Extrusion,
        StepKind::Revolution(_) => SurfaceKind::Revolution,
        StepKind::BSpline(_)
        | StepKind::BSplineWithKnots(_)
        | StepKind::QuasiUniform(_)
        | StepKind::Uniform(_)
        | StepKind::Bezier(_)
        // A rational B-spline is a complex instance in the file.
        | StepKind::Other(_) => SurfaceKind::BSpline,
        _ => SurfaceKind::Other,
    }
}

/// A control point in the file's frame and unit to a homogeneous one in mm where the assembly puts
/// it.
fn pole(p: &[f64; 3], weight: f64, mm: f64, to: &Matrix4<f64>) -> Vector4<f64> {
    let q = to * Vector4::new(p[0], p[1], p[2], 1.0);
    Vector4::new(q.x * mm * weight, q.y * mm * weight, q.z * mm * weight, weight)
}

fn curve(c: &step_io::scene::NurbsCurve, mm: f64, to: &Matrix4<f64>) -> NurbsCurve {
    let points = c.control_points.iter().zip(&c.weights).map(|(p, &w)| pole(p, w, mm, to)).collect();
    NurbsCurve { degree: c.degree, knots: c.knots.clone(), points }
}

fn surface(s: &step_io::scene::NurbsSurface, mm: f64, to: &Matrix4<f64>) -> NurbsSurface {
    let (n_u, n_v) = (s.control_points.len(), s.control_points.first().map_or(0, Vec::len));
    let points = s
        .control_points
        .iter()
        .zip(&s.weights)
        .flat_map(|(row, weights)| row.iter().zip(weights).map(|(p, &w)| pole(p, w, mm, to)))
        .collect();
    NurbsSurface {
        degree_u: s.degree_u,
        degree_v: s.degree_v,
        knots_u: s.knots_u.clone(),
        knots_v: s.knots_v.clone(),
        n_u,
        n_v,
        points,
    }
}
