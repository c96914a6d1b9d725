//! Which balls have room on the airfoil's wall near the platform, and on the fillet.
//!
//! Places are spread over the surface by its area, so that many small facets say no more than one
//! large one. A ball is laid on a place along the normal there: it has room where its centre is no
//! nearer than its radius to the whole part.

use crate::artifact::Blade;
use crate::geometry::slice::{Loop, slice};
use crate::geometry::{Point, Vector};
use crate::parallel;

/// Places on the wall, and on the fillet, about.
const PLACES: usize = 1500;
/// Walls lean less than this from the blade axis (sine) …
const WALL_LEAN: f64 = 0.5;
/// … and a fillet is milled up to this lean (sine of 60°).
const FILLET_LEAN: f64 = 0.87;
/// Facets of a coarse mesh bend by a few hundredths of the radius without being a pocket.
const FACETS: f64 = 0.97;
/// Heights at which the airfoil's outline is taken, to tell its walls from those of what stands
/// beside it.
const HEIGHTS: usize = 9;

/// A place on the surface.
#[derive(Clone, Copy)]
struct SurfacePlace {
    at: Point,
    normal: Vector,
}

/// Places that stand for equal pieces of a surface.
struct Surface {
    places: Vec<SurfacePlace>,
    area_mm2: f64,
}

/// Places on the wall near the platform, then on the fillet.
pub(super) struct WallPlaces {
    of: [Surface; 2],
    /// Heights between which the wall is looked at, mm.
    pub(super) heights_mm: [f64; 2],
    /// The airfoil's chord near the platform, and its height, mm.
    pub(super) chord_mm: (f64, f64),
}

/// Where a ball goes.
pub(super) struct Share {
    /// Share of the places that it goes to; 1 where there is no place.
    pub(super) share: f64,
    /// Surface that the places stand for, mm².
    pub(super) area_mm2: f64,
    /// Where its centre comes nearest to the part, and how near that is, mm; `None` where it goes
    /// everywhere.
    pub(super) tightest: Option<(Point, f64)>,
    /// One flag for each place: whether it goes there.
    pub(super) places: Vec<bool>,
}

impl WallPlaces {
    /// Places between the region's heights, as far as they are known.
    pub(super) fn new(blade: &Blade, start_mm: Option<f64>, end_mm: Option<f64>) -> WallPlaces {
        // Sections across an axis say nothing of a blade whose hub turns.
        if blade.regions.over_hub().is_some() {
            let none = || Surface { places: Vec::new(), area_mm2: 0.0 };
            return WallPlaces { of: [none(), none()], heights_mm: [0.0; 2], chord_mm: (0.0, 0.0) };
        }
        let [a, b] = blade.regions.airfoil_x_mm();
        let top = start_mm.unwrap_or_else(|| near_platform(blade)).clamp(a, b).max(a + 0.02 * (b - a));
        let foot = end_mm.map_or(a, |e| e.clamp(a, top));
        let fillet = blade.regions.fillet_x_mm().filter(|f| end_mm.is_none_or(|e| e < f[1]));
        let wall = [foot.max(fillet.map_or(a, |f| f[1])).min(top), top];
        let chord_at = a + 0.15 * (b - a);
        let outlines: Vec<(f64, [f64; 4])> = (0..HEIGHTS)
            .map(|k| foot + (0.02 + 0.96 * k as f64 / (HEIGHTS - 1) as f64) * (top - foot))
            .filter_map(|x| Some((x, bounds(&outline(blade, x)?))))
            .collect();
        let none = || Surface { places: Vec::new(), area_mm2: 0.0 };
        WallPlaces {
            of: [
                spread(blade, &outlines, wall, WALL_LEAN),
                fillet.map_or_else(none, |f| spread(blade, &outlines, f, FILLET_LEAN)),
            ],
            heights_mm: wall,
            chord_mm: (outline(blade, chord_at).map_or(0.0, |l| extent_mm(&l.points)), chord_at),
        }
    }

    /// There is nothing to lay a ball on.
    pub(super) fn is_empty(&self) -> bool {
        self.of.iter().all(|s| s.places.is_empty())
    }

    /// Where the smallest ball goes, of all places together.
    pub(super) fn sound(&self, blade: &Blade, radius_mm: f64) -> Share {
        let all = vec![true; self.of.iter().map(|s| s.places.len()).sum()];
        let [wall, fillet] = self.shares(blade, radius_mm, [1.0; 2], &all);
        let area_mm2 = wall.area_mm2 + fillet.area_mm2;
        let share = (wall.share * wall.area_mm2 + fillet.share * fillet.area_mm2) / area_mm2.max(f64::MIN_POSITIVE);
        Share {
            share: if area_mm2 > 0.0 { share } else { 1.0 },
            area_mm2,
            tightest: wall.tightest.or(fillet.tightest),
            places: [wall.places, fillet.places].concat(),
        }
    }

    /// Where a ball goes on the wall and on the fillet, of the `sound` places; with `spare`, where
    /// one larger by its inverse does.
    pub(super) fn shares(&self, blade: &Blade, radius_mm: f64, spare: [f64; 2], sound: &[bool]) -> [Share; 2] {
        let n = self.of[0].places.len().min(sound.len());
        let (wall, fillet) = sound.split_at(n);
        // Lower places of the wall are the platform's matter.
        let lowest = self.lowest(radius_mm / spare[0]);
        [
            share(blade, &self.of[0], [radius_mm, spare[0]], wall, lowest),
            share(blade, &self.of[1], [radius_mm, spare[1]], fillet, f64::NEG_INFINITY),
        ]
    }

    /// A ball on the wall lower than this touches the platform first; where a fillet lies between,
    /// it need not.
    fn lowest(&self, radius_mm: f64) -> f64 {
        let [lo, hi] = self.heights_mm;
        if self.of[1].places.is_empty() { lo + radius_mm.min(0.6 * (hi - lo)) } else { lo }
    }
}

/// The lowest 30 % of the airfoil, at least 10 and at most 40 mm where it is as high.
fn near_platform(blade: &Blade) -> f64 {
    let [a, b] = blade.regions.airfoil_x_mm();
    a + (0.35 * (b - a)).clamp(10.0, 40.0).min(0.9 * (b - a))
}

/// Lays the ball on every sound place above `lowest`.
fn share(blade: &Blade, on: &Surface, [radius_mm, spare]: [f64; 2], sound: &[bool], lowest: f64) -> Share {
    let Surface { places, area_mm2 } = on;
    let r = radius_mm / spare;
    let counts: Vec<bool> = places.iter().zip(sound).map(|(p, sound)| *sound && p.at.x >= lowest).collect();
    // How near the centre comes; infinite where it is clear.
    let near = |(p, counts): (&SurfacePlace, &bool)| {
        let centre = p.at + p.normal * r;
        let close = counts.then(|| blade.part.closest_on_mesh(&centre, r)).flatten();
        close.map(|c| c.distance_mm).filter(|d| *d <= FACETS * r).unwrap_or(f64::INFINITY)
    };
    let near: Vec<f64> = parallel::map(places.iter().zip(&counts), near);
    let tried = counts.iter().filter(|c| **c).count();
    let blocked = near.iter().filter(|d| d.is_finite()).count();
    let tightest = (0..near.len()).min_by(|a, b| near[*a].total_cmp(&near[*b])).filter(|k| near[*k].is_finite());
    Share {
        share: 1.0 - blocked as f64 / tried.max(1) as f64,
        area_mm2: area_mm2 * tried as f64 / places.len().max(1) as f64,
        tightest: tightest.map(|k| (places[k].at, near[k])),
        places: near.iter().map(|d| !d.is_finite()).collect(),
    }
}

/// Middles of triangles of the airfoil's walls between two heights, one for each equal piece of
/// their area.
fn spread(blade: &Blade, outlines: &[(f64, [f64; 4])], [lo, hi]: [f64; 2], most_lean: f64) -> Surface {
    let mesh = &blade.part.mesh;
    let wide = |b: &[f64; 4]| (b[2] - b[0]).max(b[3] - b[1]);
    let on_airfoil = |p: &Point| {
        let nearest = outlines.iter().min_by(|a, b| (a.0 - p.x).abs().total_cmp(&(b.0 - p.x).abs()));
        // A fillet is wider than the wall that it ends in.
        nearest.is_none_or(|(_, b)| {
            let m = 0.1 * wide(b) + (hi - lo).min(0.1 * wide(b));
            p.y > b[0] - m && p.y < b[2] + m && p.z > b[1] - m && p.z < b[3] + m
        })
    };
    let all: Vec<(SurfacePlace, f64)> = (0..mesh.triangles.len())
        .filter_map(|t| {
            let [p, q, r] = mesh.corners(t);
            let at = p + ((q - p) + (r - p)) / 3.0;
            let normal = mesh.normal(t);
            let counts = lo <= at.x && at.x <= hi && normal.x.abs() < most_lean && on_airfoil(&at);
            counts.then(|| (SurfacePlace { at, normal }, mesh.triangle_area_mm2(t)))
        })
        .collect();
    let total: f64 = all.iter().map(|(_, area)| area).sum();
    let piece = total / PLACES as f64;
    let (mut sum, mut next, mut out) = (0.0, 0.5 * piece, Vec::new());
    for (place, area) in &all {
        sum += area;
        while sum > next && out.len() < PLACES {
            out.push(*place);
            next += piece;
        }
    }
    Surface { places: out, area_mm2: total }
}

/// The outline of the airfoil at a height: of the loops whose box holds the blade axis the widest,
/// since hollow blades have more than one; where none does, the nearest.
fn outline(blade: &Blade, x_mm: f64) -> Option<Loop> {
    let away = |l: &Loop| {
        let b = bounds(l);
        let beside = |lo: f64, hi: f64| lo.max(-hi).max(0.0);
        beside(b[0], b[2]).hypot(beside(b[1], b[3]))
    };
    let loops = slice(&blade.part.mesh, &blade.part.bvh, x_mm).into_iter().filter(|l| l.points.len() > 2);
    let by = |l: Loop| (away(&l), -extent_mm(&l.points), l);
    loops.map(by).min_by(|a, b| a.0.total_cmp(&b.0).then(a.1.total_cmp(&b.1))).map(|(.., l)| l)
}

/// Least y, least z, greatest y, greatest z.
fn bounds(l: &Loop) -> [f64; 4] {
    let start = [f64::INFINITY, f64::INFINITY, f64::NEG_INFINITY, f64::NEG_INFINITY];
    l.points.iter().fold(start, |b, p| [b[0].min(p[0]), b[1].min(p[1]), b[2].max(p[0]), b[3].max(p[1])])
}

/// Greatest distance between two points, mm: extents over 90 directions are within 0.02 % of it and
/// cost linear time.
fn extent_mm(points: &[[f64; 2]]) -> f64 {
    let extent = |k: usize| {
        let (s, c) = (k as f64 * std::f64::consts::PI / 90.0).sin_cos();
        let along = points.iter().map(|p| c * p[0] + s * p[1]);
        let (lo, hi) = along.fold((f64::INFINITY, f64::NEG_INFINITY), |(lo, hi), v| (lo.min(v), hi.max(v)));
        if hi >= lo { hi - lo } else { 0.0 }
    };
    (0..90).map(extent).fold(0.0, f64::max)
}
