//! Ends of intervals on exact faces, against dense points of the faces themselves.

use nalgebra::{Isometry3, Translation3, UnitQuaternion};

use super::super::arcs::Witness;
use super::super::{
    ChannelOptions, Free, FreeInterval, NARROW_RAD, Surroundings, intervals, layers, narrow, samples_of, widened,
};
use super::world::{blade, inside_by, tool};
use crate::artifact::Cones;
use crate::artifact::channel::Binding;
use crate::artifact::toolpath::{CutterLocation, PathKind, Toolpath, Turn};
use crate::error::EndReason;
use crate::geometry::brep::{Brep, Face, SurfaceKind};
use crate::geometry::mesh::Mesh;
use crate::geometry::nurbs::NurbsSurface;
use crate::geometry::nurbs::shapes::{loft, torus};
use crate::geometry::part::Part;
use crate::geometry::{Point, Vector};
use crate::observe::Silent;

/// Balls that touch the part from both sides, where they touch nothing else.
fn touching(
    part: &Part,
    surface: &NurbsSurface,
    pose: &Isometry3<f64>,
    radius_mm: f64,
) -> Vec<(CutterLocation, [f64; 2])> {
    let mut out = Vec::new();
    for k in 0..16u32 {
        let uv = [0.1 + 0.8 * (f64::from(k) * 0.618_034).fract(), 0.1 + 0.8 * (f64::from(k) * 0.754_877).fract()];
        let at = surface.derivatives(uv[0], uv[1]);
        let side = if k % 2 == 0 { 1.0 } else { -1.0 };
        let (contact, normal) = (pose * at.p, pose * (at.normal().unwrap() * side));
        let centre = contact + normal * radius_mm;
        let free = part.closest(&centre, f64::INFINITY).unwrap().distance_mm > radius_mm - 1e-9;
        let l = CutterLocation { turn: 0, turn_s_mm: 0.0, s_mm: 0.0, centre, contact, normal };
        out.extend(free.then_some((l, uv)));
    }
    out
}

fn path_of(locations: Vec<CutterLocation>, radius_mm: f64) -> Toolpath {
    let turns = vec![Turn { first: 0, count: locations.len(), length_mm: 1.0 }];
    Toolpath {
        kind: PathKind::default(),
        stock_mm: 0.0,
        radius_mm,
        disc_radius_mm: 0.0,
        scallop_mm: 0.01,
        chord_mm: 0.01,
        region_x_mm: [0.0, 1.0],
        end_reason: EndReason::Region,
        planned_scallop_mm: 0.01,
        cones: Cones::about_blade(5f64.to_radians()),
        axis_turning: None,
        turns,
        locations,
    }
}

/// Depth of the deepest point of a surface inside a tool: a grid, rings round the contact, and
/// rings round the deepest of these.
fn depth(surface: &NurbsSurface, contact: [f64; 2], inside: impl Fn(&Point) -> f64) -> f64 {
    let mut best = (f64::NEG_INFINITY, contact);
    let look = |uv: [f64; 2], best: &mut (f64, [f64; 2])| {
        if uv.iter().all(|x| (0.0..=1.0).contains(x)) {
            let d = inside(&surface.point(uv[0], uv[1]));
            if d > best.0 {
                *best = (d, uv);
            }
        }
    };
    let n = 40;
    for i in 0..=n {
        (0..=n).for_each(|j| look([i, j].map(|k| f64::from(k) / f64::from(n)), &mut best));
    }
    for ring in 0..30 {
        for k in 0..48 {
            let (s, c) = (std::f64::consts::TAU * f64::from(k) / 48.0).sin_cos();
            let r = 0.3 * 0.7f64.powi(ring);
            look([contact[0] + r * c, contact[1] + r * s], &mut best);
        }
    }
    for ring in 0..45 {
        for k in 0..24 {
            let (s, c) = (std::f64::consts::TAU * f64::from(k) / 24.0).sin_cos();
            let (r, at) = (0.02 * 0.8f64.powi(ring), best.1);
            look([at[0] + r * c, at[1] + r * s], &mut best);
            // Along the sheet's borders.
            look([at[0] + r * c, at[1]], &mut best);
            look([at[0], at[1] + r * c], &mut best);
        }
    }
    best.0
}

/// At an end no point of the faces is too near; a little farther out one is, though the mesh is off
/// by fifty times what that leaves: with and without clearance, in any position.
#[test]
fn ends_are_those_of_the_faces() {
    let none = ChannelOptions::default().with(|s| (s.clearance_mm, s.holder_clearance_mm) = (0.0, 0.0));
    let o = none.with(|s| s.exact_ends = true);
    let with_room = o.clone().with(|s| (s.clearance_mm, s.holder_clearance_mm) = (0.2, 0.5));
    let (mut ends, mut far) = (0, 0);
    for (k, surface) in [loft(), torus(30.0, 9.0)].iter().enumerate() {
        for (turn, o) in [(0.0, &o), (2.1, &with_room)] {
            let turned = UnitQuaternion::from_euler_angles(turn, 1.4 + 0.1 * turn, 0.3);
            let pose = Isometry3::from_parts(Translation3::new(5.0, 3.0 * turn, -4.0), turned);
            let face = Face {
                name: "f".into(),
                kind: SurfaceKind::BSpline,
                surface: surface.clone(),
                reversed: false,
                loops: vec![],
            };
            let part = Part::from_brep(Brep { faces: vec![face.clone()], edges: vec![] }, 0.05, &Silent).unwrap();
            let mut blade = blade(Mesh::default());
            blade.part = part.moved(&pose);
            assert!(blade.part.deflection_mm > 0.01);
            let t = tool(3.0, 4.0);
            let (locations, uvs): (Vec<_>, Vec<_>) =
                touching(&blade.part, &face.surface, &pose, 3.0).into_iter().unzip();
            let path = path_of(locations, 3.0);
            let around = Surroundings::new(&blade, &[], 3.0).unwrap();
            let around = if k == 0 { around } else { around.finer(10.0) };
            let all = intervals(&around, &t, &path, o, &Silent).unwrap();
            for ((l, uv), free) in path.locations.iter().zip(&uvs).zip(&all) {
                let (room, segments) = ((o.settings.clearance_mm, o.settings.holder_clearance_mm), t.segments());
                let depth = |theta: f64| {
                    let inside = |p: &Point| inside_by(&segments, room, path.cone(0), &l.centre, theta, &(pose * p));
                    depth(surface, *uv, inside)
                };
                for f in free {
                    for (at, by, sense) in [(f.theta_min, &f.binds_min, -1.0), (f.theta_max, &f.binds_max, 1.0)] {
                        assert!(depth(at) < 1e-7, "surface {k}, {l:?}: {at} is {} too near", depth(at));
                        if matches!(by, Binding::Part { .. }) {
                            ends += 1;
                            far += usize::from(depth(at + sense * 1.2 * o.settings.tolerance_deg.to_radians()) < 0.0);
                        }
                    }
                }
            }
        }
    }
    assert!(ends > 25, "{ends}");
    assert_eq!(far, 0, "of {ends} ends are timid");
}

/// Surface that the file has otherwise is kept clear of too; what it stands off the part takes the
/// place of the mesh's deflection, not of the faces.
#[test]
fn ends_keep_clear_of_faces_as_published() {
    let o =
        ChannelOptions::default().with(|s| (s.clearance_mm, s.holder_clearance_mm, s.exact_ends) = (0.2, 0.5, true));
    let (surface, shift) = (loft(), Vector::new(0.0, 0.003, 0.001));
    let face =
        Face { name: "f".into(), kind: SurfaceKind::BSpline, surface: surface.clone(), reversed: false, loops: vec![] };
    let own = Part::from_brep(Brep { faces: vec![face], edges: vec![] }, 0.05, &Silent).unwrap();
    let published = own.clone().moved(&Isometry3::from_parts(shift.into(), UnitQuaternion::identity()));
    let turned = UnitQuaternion::from_euler_angles(2.1, 1.6, 0.3);
    let pose = Isometry3::from_parts(Translation3::new(5.0, 6.0, -4.0), turned);
    let (locations, uvs): (Vec<_>, Vec<_>) =
        touching(&own.clone().moved(&pose), &surface, &pose, 3.0).into_iter().unzip();
    let mut blade = blade(Mesh::default());
    blade.part = own.with_published(published, vec![Some(0)]).moved(&pose);
    let off_mm = blade.part.off_own_mm();
    assert!((0.002..=shift.norm()).contains(&off_mm) && blade.part.deflection_mm > 4.0 * off_mm);
    let (t, path) = (tool(3.0, 4.0), path_of(locations, 3.0));
    let around = Surroundings::new(&blade, &[], 3.0).unwrap().finer(3.0);
    let all = intervals(&around, &t, &path, &o, &Silent).unwrap();
    let coarse = Surroundings::new(&blade, &[], 3.0).unwrap();
    let by_mesh = intervals(&coarse, &t, &path, &o.clone().with(|s| s.exact_ends = false), &Silent).unwrap();
    let width = |all: &[Vec<FreeInterval>]| all.iter().flatten().map(|f| f.theta_max - f.theta_min).sum::<f64>();
    assert!(width(&all) > width(&by_mesh) + 1e-3, "{} {}", width(&all), width(&by_mesh));
    let mut ends = 0;
    for ((l, uv), free) in path.locations.iter().zip(&uvs).zip(&all) {
        let (room, segments) = ((o.settings.clearance_mm, o.settings.holder_clearance_mm), t.segments());
        for at in free.iter().flat_map(|f| [f.theta_min, f.theta_max]) {
            ends += 1;
            let inside = |p: &Point| inside_by(&segments, room, path.cone(0), &l.centre, at, &(pose * (p + shift)));
            let depth = depth(&surface, *uv, inside);
            assert!(depth < 1e-5, "{l:?}: {at} is {depth} too near");
        }
    }
    assert!(ends > 10, "{ends}");
}

/// Where a finer index decides, ends lie where it has them, named by triangles of the part; all
/// other places stay as they are.
#[test]
fn a_finer_index_decides_where_hardly_anything_is_free() {
    let turned = UnitQuaternion::from_euler_angles(0.7, 1.5, 0.3);
    let pose = Isometry3::from_parts(Translation3::new(5.0, 3.0, -4.0), turned);
    let surface = torus(30.0, 9.0);
    let face =
        Face { name: "f".into(), kind: SurfaceKind::BSpline, surface: surface.clone(), reversed: false, loops: vec![] };
    let part = Part::from_brep(Brep { faces: vec![face], edges: vec![] }, 0.05, &Silent).unwrap();
    let mut blade = blade(Mesh::default());
    blade.part = part.moved(&pose);
    let t = tool(3.0, 4.0);
    let path = path_of(touching(&blade.part, &surface, &pose, 3.0).into_iter().map(|(l, _)| l).collect(), 3.0);
    let usual = Surroundings::new(&blade, &[], 3.0).unwrap();
    let finer = Surroundings::new(&blade, &[], 3.0).unwrap().finer(3.0);
    let widest = |layer: &[Free]| layer.iter().map(|f| f.hi - f.lo).fold(0.0, f64::max);
    let (mut opened, mut widened_at, mut stayed) = (0, 0, 0);
    for k in 0..40 {
        let clearance = 0.1 * f64::from(k);
        let o = ChannelOptions::default().with(|s| (s.clearance_mm, s.holder_clearance_mm) = (clearance, clearance));
        let samples = samples_of(&t, &path, &o);
        let [coarse, fine] = [&usual, &finer].map(|around| around.scene(&t, &o));
        let [before, by_finer] = [&coarse, &fine].map(|scene| layers(scene, &samples, &Silent).unwrap());
        let mut after = before.clone();
        widened(&mut after, &coarse, &fine, (&narrow(&before), &samples), &Silent).unwrap();
        for ((before, by_finer), after) in before.iter().zip(&by_finer).zip(&after) {
            if widest(before) >= NARROW_RAD || widest(by_finer) <= widest(before) {
                stayed += 1;
                assert_eq!(before, after);
                continue;
            }
            widened_at += 1;
            opened += usize::from(before.is_empty());
            let ends = |layer: &[Free]| layer.iter().flat_map(|f| [f.lo, f.hi]).collect::<Vec<_>>();
            // Each index is searched from another place, to the tolerance.
            let off = ends(after).iter().zip(ends(by_finer)).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
            assert!(after.len() == by_finer.len() && off <= o.settings.tolerance_deg.to_radians(), "{off}");
            for f in after {
                let Witness::Tool { body: 0, leaf, .. } = f.lo_by else { continue };
                assert!((coarse.bodies[0].tree.triangle(leaf) as usize) < blade.part.mesh.triangles.len());
            }
        }
    }
    assert!(opened > 3 && widened_at > 10 && stayed > 100, "{opened} {widened_at} {stayed}");
}
