//! The airfoil along a direction: the chain of section loops, one per height, that looks most like
//! an airfoil for longest.

use nalgebra::{Matrix3, UnitQuaternion};

use super::shape::LoopShape;
use super::stitch::stitched;
use crate::geometry::mesh::Mesh;
use crate::geometry::slice::{Loop, slice_triangles};
use crate::geometry::{Point, Rigid, Vector};

/// Heights at which a direction is tried.
pub const HEIGHTS: usize = 72;
/// Neighbouring sections of one airfoil differ by less than this share.
pub const LOOSENESS: f64 = 0.2;
/// Likeness that any steady loop has: keeps plain prisms recognisable when nothing better is there.
const FLOOR: f64 = 0.01;

/// A chain that reaches an end of the part within this share of the part's length ends freely, as a
/// blade does at its tip, and scores up to double; one that stays farther away gains less, and
/// nothing beyond [`INSIDE`].
const FREE_END: f64 = 0.03;
/// See [`FREE_END`].
const INSIDE: f64 = 0.15;

/// The normals give the airfoil's direction where their mean square along it is less by this than
/// along the one tried.
const CLEAR: f64 = 0.04;
/// Measures of two airfoils of a part differ by less than this ratio.
const ALIKE: f64 = 0.75;
/// A section larger than the airfoil's last one by this factor is another body's.
const LARGER: f64 = 1.25;
/// A gap in the airfoil of up to this share of the part is a snubber or shroud on one blade.
const SNUBBER: f64 = 0.12;

/// Share of a loop's length that must lie on the faces that the user named.
pub const ON_FACES: f64 = 0.9;

/// One section of the chain.
pub struct Link {
    /// Height along the direction, mm.
    pub height_mm: f64,
    /// Measures of its loop.
    pub shape: LoopShape,
}

/// The best chain along a direction.
pub struct Run {
    /// Unit direction, frame of the mesh.
    pub direction: Vector,
    /// Heights of the whole part along it, mm.
    pub part_mm: [f64; 2],
    /// Sections from low to high; empty where nothing continues.
    pub links: Vec<Link>,
    /// `share` times `free`, less for normals along the direction, for areas that sway, and for
    /// sections whose middles or normals say that the airfoil runs another way.
    pub score: f64,
    /// Airfoil-like surface that the chain sweeps over the whole surface.
    pub share: f64,
    /// How much the sections' area goes up and down again, over its mean.
    pub sway: f64,
    /// 1 to 2: how near the chain comes to an end of the part.
    pub free: f64,
    /// Mean likeness of the chain's sections.
    pub likeness: f64,
    /// Mean square of the normals' component along the direction on the chain.
    pub along: f64,
    /// Direction least present in the normals of the chain, same hemisphere as `direction`.
    pub least_normal: Vector,
    /// Line through the middles of the sections, same hemisphere as `direction`.
    pub stack: Vector,
    /// Middle of the chain, frame of the mesh.
    pub middle: Point,
    /// Whether beyond its low and its high end there are sections larger than the chain's last one:
    /// a platform, hub or shroud.
    pub body: [bool; 2],
    /// Another chain along the direction that looks like this one, apart from it.
    pub twin: bool,
}

impl Run {
    /// Share of the part's length that the chain covers.
    pub fn covered(&self) -> f64 {
        let length = (self.part_mm[1] - self.part_mm[0]).max(f64::MIN_POSITIVE);
        self.links.first().zip(self.links.last()).map_or(0.0, |(a, b)| (b.height_mm - a.height_mm) / length)
    }
}

/// A rotation whose x axis is the direction; the third axis is chosen deterministically.
pub fn frame_along(direction: &Vector) -> Rigid {
    let (x, y, z) = axes_of(direction);
    let rotation = nalgebra::Rotation3::from_matrix_unchecked(Matrix3::from_columns(&[x, y, z]));
    Rigid::from_parts(nalgebra::Translation3::identity(), UnitQuaternion::from_rotation_matrix(&rotation))
}

/// Right-handed axes: x along the direction, y along the model axis least aligned with it (the
/// first of equals).
fn axes_of(direction: &Vector) -> (Vector, Vector, Vector) {
    let x = direction.normalize();
    let mut least = 0;
    for k in 1..3 {
        // Equal within rounding counts as equal, so that a quarter turn of the model keeps the
        // choice stable.
        if x[k].abs() < x[least].abs() - 1e-9 {
            least = k;
        }
    }
    let mut e = Vector::zeros();
    e[least] = 1.0;
    let y = (e - x * x.dot(&e)).normalize();
    (x, y, x.cross(&y))
}

/// Heights of a mesh along a direction, mm.
pub fn extent_mm(mesh: &Mesh, direction: &Vector) -> [f64; 2] {
    let along = mesh.points.iter().map(|p| direction.normalize().dot(&p.coords));
    along.fold([f64::INFINITY, f64::NEG_INFINITY], |[lo, hi], h| [lo.min(h), hi.max(h)])
}

/// Cuts the mesh at [`HEIGHTS`] heights along the direction and finds the best chain. `faces`: the
/// faces (one flag each) that loops must lie on to count; `None`: any.
pub fn along(mesh: &Mesh, direction: &Vector, faces: Option<&[bool]>) -> Run {
    let frame = frame_along(direction);
    // Without what sections do not ask for: a part is cut along dozens of directions.
    let bare = Mesh { points: mesh.points.clone(), triangles: mesh.triangles.clone(), ..Mesh::default() };
    let face_of = if faces.is_some() { mesh.face_of.clone() } else { Vec::new() };
    let turned = Mesh { face_of, ..bare }.moved(&frame.inverse());
    let part_mm = turned.aabb().map_or([0.0, 0.0], |b| [b.min.x, b.max.x]);
    let step = (part_mm[1] - part_mm[0]) / HEIGHTS as f64;
    let sections = sections(&turned, part_mm, step, faces);
    let chain = best_chain(&sections, step, &[]);
    let mut run = summarise(mesh, direction, part_mm, step, &sections, &chain);
    run.twin = twin(&sections, step, &chain);
    run
}

/// Whether a second chain looks like the first, beside it or farther along than a snubber is thick:
/// another airfoil.
fn twin(sections: &SectionsByHeight, step: f64, chain: &[(usize, usize)]) -> bool {
    let other = best_chain(sections, step, chain);
    let (Some(a), Some(b)) = (span(chain), span(&other)) else { return false };
    let apart = if a[0] > b[0] { a[0].saturating_sub(b[1]) } else { b[0].saturating_sub(a[1]) };
    let beside = a[0].max(b[0]) <= a[1].min(b[1]);
    let long = other.len() as f64 >= ALIKE * chain.len() as f64;
    let mean = |chain: &[(usize, usize)], of: fn(&LoopShape) -> f64| {
        chain.iter().map(|&(i, j)| of(&sections[i].1[j].1)).sum::<f64>() / chain.len() as f64
    };
    let alike = |of: fn(&LoopShape) -> f64| {
        let (p, q) = (mean(chain, of), mean(&other, of));
        p.min(q) > ALIKE * p.max(q)
    };
    (beside || apart as f64 > SNUBBER * HEIGHTS as f64)
        && long
        && alike(|s| s.area_mm2)
        && alike(|s| s.perimeter_mm)
        && alike(|s| s.likeness)
}

/// First and last section of a chain.
fn span(chain: &[(usize, usize)]) -> Option<[usize; 2]> {
    Some([chain.first()?.0, chain.last()?.0])
}

type SectionsByHeight = Vec<(f64, Vec<(Loop, LoopShape)>)>;

fn sections(turned: &Mesh, part_mm: [f64; 2], step: f64, faces: Option<&[bool]>) -> SectionsByHeight {
    let mut buckets: Vec<Vec<u32>> = vec![Vec::new(); HEIGHTS];
    for (t, corners) in turned.triangles.iter().enumerate() {
        let xs = corners.map(|i| turned.points[i as usize].x);
        let lo = xs[0].min(xs[1]).min(xs[2]);
        let hi = xs[0].max(xs[1]).max(xs[2]);
        // The planes from the lowest to the highest corner, and a little more, so that rounding
        // loses none: most triangles lie between two.
        let place = |x: f64| (x - part_mm[0]) / step - 0.5;
        let from = (place(lo) - 1e-6).ceil().max(0.0);
        let to = (place(hi) + 1e-6).floor();
        if !(from <= to) {
            continue;
        }
        let (from, to) = (from as usize, to as usize);
        for bucket in buckets.iter_mut().take(to + 1).skip(from) {
            bucket.push(t as u32);
        }
    }
    buckets
        .iter()
        .enumerate()
        .map(|(i, triangles)| {
            let height = part_mm[0] + (i as f64 + 0.5) * step;
            let mut loops = stitched(slice_triangles(turned, triangles, height));
            if let Some(faces) = faces {
                loops.retain(|l| lies_on(turned, l, faces));
            }
            (height, loops.into_iter().filter_map(|l| LoopShape::new(&l).map(|s| (l, s))).collect())
        })
        .collect()
}

/// Lengths on each face of the sections along the direction that meet a flagged face, mm.
pub fn on_faces(mesh: &Mesh, direction: &Vector, flagged: &[bool]) -> Vec<f64> {
    let turned = mesh.clone().moved(&frame_along(direction).inverse());
    let part_mm = turned.aabb().map_or([0.0, 0.0], |b| [b.min.x, b.max.x]);
    let step = (part_mm[1] - part_mm[0]) / HEIGHTS as f64;
    let mut all = vec![0.0; flagged.len()];
    for (l, _) in sections(&turned, part_mm, step, None).iter().flat_map(|(_, loops)| loops) {
        let mut own = vec![0.0; flagged.len()];
        for (k, &t) in l.triangles.iter().enumerate() {
            let (p, q) = (l.points[k], l.points[(k + 1) % l.points.len()]);
            if let Some(length) = own.get_mut(turned.face(t as usize) as usize) {
                *length += (q[0] - p[0]).hypot(q[1] - p[1]);
            }
        }
        if own.iter().zip(flagged).any(|(length, flagged)| *flagged && *length > 0.0) {
            all.iter_mut().zip(own).for_each(|(sum, length)| *sum += length);
        }
    }
    all
}

/// Whether nearly all of a loop's length lies on these faces.
fn lies_on(mesh: &Mesh, l: &Loop, faces: &[bool]) -> bool {
    let (mut on, mut all) = (0.0, 0.0);
    for (k, &t) in l.triangles.iter().enumerate() {
        let (p, q) = (l.points[k], l.points[(k + 1) % l.points.len()]);
        let d = (q[0] - p[0]).hypot(q[1] - p[1]);
        all += d;
        if faces.get(mesh.face(t as usize) as usize) == Some(&true) {
            on += d;
        }
    }
    on >= ON_FACES * all
}

/// Longest path: `best[i][j]` is the airfoil-like surface of the best chain that ends with loop j
/// of section i. Loops in `without` do not count.
fn best_chain(sections: &SectionsByHeight, step: f64, without: &[(usize, usize)]) -> Vec<(usize, usize)> {
    let mut best: Vec<Vec<(f64, Option<usize>)>> = Vec::with_capacity(sections.len());
    let mut end: Option<(usize, usize, f64)> = None;
    for (i, (_, loops)) in sections.iter().enumerate() {
        let mut row = Vec::with_capacity(loops.len());
        for (j, (_, shape)) in loops.iter().enumerate() {
            if without.contains(&(i, j)) {
                row.push((0.0, None));
                continue;
            }
            let own = (FLOOR + (1.0 - FLOOR) * shape.likeness) * shape.perimeter_mm * step;
            let mut from = (0.0, None);
            if i > 0 {
                for (k, (_, before)) in sections[i - 1].1.iter().enumerate() {
                    let reached = best[i - 1][k].0;
                    if reached > from.0 && shape.continues(before, LOOSENESS) {
                        from = (reached, Some(k));
                    }
                }
            }
            let total = own + from.0;
            row.push((total, from.1));
            if end.is_none_or(|(_, _, t)| total > t) {
                end = Some((i, j, total));
            }
        }
        best.push(row);
    }
    let mut chain = Vec::new();
    if let Some((mut i, mut j, _)) = end {
        chain.push((i, j));
        while let Some(k) = best[i][j].1 {
            i -= 1;
            j = k;
            chain.push((i, j));
        }
    }
    chain.reverse();
    chain
}

fn summarise(
    mesh: &Mesh,
    direction: &Vector,
    part_mm: [f64; 2],
    step: f64,
    sections: &SectionsByHeight,
    chain: &[(usize, usize)],
) -> Run {
    let mut covariance = Matrix3::zeros();
    let (mut length, mut swept, mut likeness) = (0.0, 0.0, 0.0);
    let inner = chain.len() / 8..chain.len() - chain.len() / 8;
    for (position, &(i, j)) in chain.iter().enumerate() {
        let (l, shape) = &sections[i].1[j];
        swept += (FLOOR + (1.0 - FLOOR) * shape.likeness) * shape.perimeter_mm * step;
        likeness += shape.likeness / chain.len() as f64;
        if !inner.contains(&position) {
            continue;
        }
        for (k, p) in l.points.iter().enumerate() {
            let q = l.points[(k + 1) % l.points.len()];
            let d = (q[0] - p[0]).hypot(q[1] - p[1]);
            let n = mesh.normal(l.triangles[k] as usize);
            covariance += d * n * n.transpose();
            length += d;
        }
    }
    if length > 0.0 {
        covariance /= length;
    }
    let along = (direction.transpose() * covariance * direction).x;
    let eigen = covariance.symmetric_eigen();
    let least = eigen.eigenvalues.imin();
    let excess = along - eigen.eigenvalues[least];
    let mut least_normal: Vector = eigen.eigenvectors.column(least).into_owned();
    if least_normal.dot(direction) < 0.0 {
        least_normal = -least_normal;
    }
    // From root to tip the area of an airfoil grows or shrinks steadily; cut aslant it rises and
    // falls.
    let areas: Vec<f64> = chain.iter().map(|&(i, j)| sections[i].1[j].1.area_mm2).collect();
    let mean = areas.iter().sum::<f64>() / areas.len().max(1) as f64;
    let change = areas.first().zip(areas.last()).map_or(0.0, |(a, b)| (a - b).abs());
    let sway = (areas.windows(2).map(|w| (w[1] - w[0]).abs()).sum::<f64>() - change) / mean.max(f64::MIN_POSITIVE);
    let height = |c: Option<&(usize, usize)>| c.map_or(f64::NAN, |&(i, _)| sections[i].0);
    let gap = (height(chain.first()) - part_mm[0]).min(part_mm[1] - height(chain.last())) / (part_mm[1] - part_mm[0]);
    let free = 1.0 + ((INSIDE - gap) / (INSIDE - FREE_END)).clamp(0.0, 1.0);
    let share = swept / mesh.area_mm2().max(f64::MIN_POSITIVE);
    let links: Vec<Link> =
        chain.iter().map(|&(i, j)| Link { height_mm: sections[i].0, shape: sections[i].1[j].1 }).collect();
    let (middle, stack) = stacking(direction, &links);
    let body = bodies(sections, chain);
    // What the chain itself says of the airfoil's direction: its middles, and its normals where
    // they say much.
    let aside = (excess / CLEAR).clamp(0.0, 1.0) * (1.0 - least_normal.dot(direction).powi(2));
    let agrees = stack.dot(direction).powi(2) * (1.0 - aside);
    let steady = (1.0 - 4.0 * along).max(0.0) / (1.0 + sway).sqrt();
    let score = if chain.is_empty() { 0.0 } else { free * share * steady * agrees };
    Run {
        direction: *direction,
        part_mm,
        links,
        score,
        share,
        sway,
        free,
        likeness,
        along,
        least_normal,
        stack,
        middle,
        body,
        twin: false,
    }
}

/// Whether larger sections lie beyond the chain's low and high end.
fn bodies(sections: &SectionsByHeight, chain: &[(usize, usize)]) -> [bool; 2] {
    let larger = |beyond: &[(f64, Vec<(Loop, LoopShape)>)], end: Option<&(usize, usize)>| {
        let own = end.map_or(f64::INFINITY, |&(i, j)| sections[i].1[j].1.area_mm2);
        beyond.iter().flat_map(|s| &s.1).any(|l| l.1.area_mm2 > LARGER * own)
    };
    let low = chain.first().map_or(0, |c| c.0);
    let high = chain.last().map_or(sections.len(), |c| c.0 + 1);
    [larger(&sections[..low], chain.first()), larger(&sections[high..], chain.last())]
}

/// Middle of the sections and unit vector of the line through their middles (least squares over the
/// height).
fn stacking(direction: &Vector, links: &[Link]) -> (Point, Vector) {
    let n = links.len().max(1) as f64;
    let at = |l: &Link| Vector::new(l.height_mm, l.shape.centroid[0], l.shape.centroid[1]);
    let mean = links.iter().map(at).sum::<Vector>() / n;
    let slope: Vector = links.iter().map(|l| at(l) - mean).map(|d| d.x * d).sum();
    let frame = frame_along(direction);
    (frame * Point::from(mean), frame * slope.try_normalize(0.0).unwrap_or_else(Vector::x))
}
