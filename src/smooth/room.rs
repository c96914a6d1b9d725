//! How far a curve may be from a location.

use super::SmoothOptions;
use crate::artifact::Toolpath;
use crate::geometry::Vector;
use crate::tool::scallop;

/// Locations of the next turn that are looked at ahead of the nearest so far: they need not come
/// nearer one by one.
const AHEAD: usize = 4;

/// Room at a location, mm.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct TubeRoom {
    /// Into the part.
    pub inwards_mm: f64,
    /// Off the part.
    pub outwards_mm: f64,
    /// Along the part, across the path.
    pub across_mm: f64,
    /// Along the path.
    pub along_mm: f64,
}

impl TubeRoom {
    pub const UNLIMITED: TubeRoom = TubeRoom {
        inwards_mm: f64::INFINITY,
        outwards_mm: f64::INFINITY,
        across_mm: f64::INFINITY,
        along_mm: f64::INFINITY,
    };

    /// A share of it.
    pub fn times(&self, share: f64) -> TubeRoom {
        TubeRoom {
            inwards_mm: share * self.inwards_mm,
            outwards_mm: share * self.outwards_mm,
            across_mm: share * self.across_mm,
            along_mm: share * self.along_mm,
        }
    }

    /// The lesser of both.
    pub fn and(self, other: &TubeRoom) -> TubeRoom {
        TubeRoom {
            inwards_mm: self.inwards_mm.min(other.inwards_mm),
            outwards_mm: self.outwards_mm.min(other.outwards_mm),
            across_mm: self.across_mm.min(other.across_mm),
            along_mm: self.along_mm.min(other.along_mm),
        }
    }
}

/// The room at every location; a share `kept` of what the options allow into and off the part, for
/// what the tube does not see.
pub(super) fn of(path: &Toolpath, options: &SmoothOptions, kept: f64) -> Vec<TubeRoom> {
    let flat_mm = scallop::width_mm(path.radius_mm, path.scallop_mm, 0.0).unwrap_or(0.1 * path.radius_mm);
    let mut stepover_mm = vec![flat_mm; path.locations.len()];
    for pair in path.turns.windows(2) {
        let [this, next] = [pair[0].first, pair[1].first];
        let end = (next + pair[1].count).min(path.locations.len());
        let mut j = next;
        for k in this..next.min(path.locations.len()) {
            let apart = |j: usize| across(path, k, j);
            let ahead = (j..(j + AHEAD).min(end)).min_by(|a, b| along(path, k, *a).total_cmp(&along(path, k, *b)));
            j = ahead.unwrap_or(j);
            if j < end {
                let d = apart(j);
                // Each turn has two neighbours; the nearer one counts.
                stepover_mm[k] = stepover_mm[k].min(d);
                stepover_mm[j] = stepover_mm[j].min(d);
            }
        }
    }
    let room = |d: f64| TubeRoom {
        inwards_mm: kept * options.inwards_mm,
        outwards_mm: kept * options.outwards_mm,
        // Where turns run into one another there is no ridge to keep.
        across_mm: options.across * d.max(0.1 * flat_mm),
        along_mm: options.along_mm,
    };
    stepover_mm.into_iter().map(room).collect()
}

fn tangent(path: &Toolpath, k: usize) -> Vector {
    let (a, b) = (k.saturating_sub(1), (k + 1).min(path.locations.len() - 1));
    (path.locations[b].centre - path.locations[a].centre).try_normalize(1e-12).unwrap_or(Vector::x())
}

/// How far location `j` is ahead of location `k` or behind it, mm.
fn along(path: &Toolpath, k: usize, j: usize) -> f64 {
    (path.locations[j].centre - path.locations[k].centre).dot(&tangent(path, k)).abs()
}

/// How far location `j` is beside the path at location `k`, mm.
fn across(path: &Toolpath, k: usize, j: usize) -> f64 {
    let (way, t) = (path.locations[j].centre - path.locations[k].centre, tangent(path, k));
    (way - t * way.dot(&t)).norm()
}
