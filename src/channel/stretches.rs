//! Parts of a path that stand for all of it: whole turns, at full density.
//!
//! Places far apart would not do: the free angles turn by half a circle within a millimetre at an
//! edge of the blade, so intervals of places next to one another would not overlap, and what is
//! carried from place to place would be lost. Neighbouring turns are alike. A schedule that never
//! turns back gains 2π a turn, so two walls cross within about a turn, if at all; each stretch is a
//! turn and a quarter of the next.

use crate::artifact::{Cone, Cones, Toolpath};
use crate::error::EndReason;

use super::samples::Sample;

/// Share of the next turn that belongs to a stretch.
const OVERLAP: f64 = 0.25;

/// A part of the path.
pub(super) struct PathPart {
    /// Its locations as a path of their own; no turns.
    pub path: Toolpath,
    /// Its places; rows count from the part's beginning, angles are those of the whole path.
    pub samples: Vec<Sample>,
    /// The tool starts here.
    pub is_start: bool,
}

impl PathPart {
    /// The same places with another lean of the tool axes, rad.
    pub fn leaning(&self, lean_rad: f64) -> Self {
        let samples = self.samples.iter().map(|s| Sample { cone: Cone { lean_rad, ..s.cone }, ..*s }).collect();
        let path = self.path.clone().with_cones(self.path.cones.leaning(lean_rad));
        PathPart { path, samples, is_start: self.is_start }
    }

    /// The same with fewer locations: none nearer to the one before than `step_mm` unless the
    /// surface turns by more than `turn_rad` from there, and the last.
    pub fn thinned(&self, step_mm: f64, turn_rad: f64) -> Self {
        let mut kept: Vec<&Sample> = Vec::new();
        let (at, last) = (|s: &Sample| &self.path.locations[s.row], self.path.locations.len() - 1);
        for s in self.samples.iter().filter(|s| s.fraction == 0.0) {
            let goes_on = kept.last().is_none_or(|k| {
                let (a, b) = (at(k), at(s));
                (b.centre - a.centre).norm() >= step_mm || a.normal.angle(&b.normal) >= turn_rad || s.row == last
            });
            kept.extend(goes_on.then_some(s));
        }
        let locations = kept.iter().map(|s| *at(s)).collect();
        let cones = match self.path.cones.same() {
            Some(_) => self.path.cones.clone(),
            None => Cones::Each(kept.iter().map(|s| s.cone).collect()),
        };
        let samples = kept.iter().enumerate().map(|(row, s)| Sample { row, ..**s }).collect();
        PathPart { path: Toolpath { locations, cones, ..self.path.clone() }, samples, is_start: self.is_start }
    }
}

/// Stretches with about `places` locations in all, the first and the last turn among them; the
/// whole path in one where it has no more than that. `samples` are those of the path.
pub(super) fn stretches(path: &Toolpath, samples: &[Sample], places: usize) -> Vec<PathPart> {
    let count = path.locations.len();
    let turns = path.turns.len();
    let each = ((1.0 + OVERLAP) * count as f64 / turns.max(1) as f64).max(1.0);
    let wanted = ((places as f64 / each) as usize).max(2);
    if count <= places || wanted >= turns {
        return vec![part(path, samples, 0, count)];
    }
    let chosen = (0..wanted).map(|k| k * (turns - 1) / (wanted - 1));
    let ranges = chosen.filter_map(|t| {
        let turn = path.turns.get(t)?;
        let beyond = (OVERLAP * turn.count as f64) as usize;
        Some((turn.first, turn.first.saturating_add(turn.count).saturating_add(beyond).min(count)))
    });
    ranges.filter(|(from, to)| from < to).map(|(from, to)| part(path, samples, from, to)).collect()
}

/// Locations `from .. to`.
fn part(path: &Toolpath, samples: &[Sample], from: usize, to: usize) -> PathPart {
    let inside = |s: &&Sample| s.row >= from && (s.row + 1 < to || (s.row + 1 == to && s.fraction == 0.0));
    let samples = samples.iter().filter(inside).map(|s| Sample { row: s.row - from, ..*s }).collect();
    let locations = path.locations.get(from..to).unwrap_or_default().to_vec();
    let cones = path.cones.part(from, to);
    let path = Toolpath { locations, cones, turns: Vec::new(), end_reason: EndReason::Region, ..*path };
    PathPart { path, samples, is_start: from == 0 }
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used)]
    use super::super::samples;
    use super::super::tests::world::{ellipse, helix};
    use super::*;

    #[test]
    fn stretches_are_parts_of_the_path_with_its_own_angles() {
        let path = helix(&ellipse(20.0, 8.0), 4.0, 60, 12, 6.0, 0.4);
        let all = samples::along(&path, f64::INFINITY, Default::default());
        let parts = stretches(&path, &all, 240);
        assert_eq!(parts.len(), 3);
        assert_eq!(parts.iter().map(|p| p.path.locations.len()).collect::<Vec<_>>(), [75, 75, 60]);
        assert!(parts[0].is_start && !parts[1].is_start);
        assert_eq!(parts[2].path.locations.last(), path.locations.last());
        for p in &parts {
            let at_locations: Vec<_> = p.samples.iter().filter(|s| s.fraction == 0.0).collect();
            assert_eq!(at_locations.len(), p.path.locations.len());
            for (i, s) in at_locations.iter().enumerate() {
                let l = p.path.locations[i];
                assert_eq!((s.row, s.centre), (i, l.centre));
                let of_all = all.iter().find(|a| a.centre == l.centre).unwrap();
                assert_eq!(s.azimuth, of_all.azimuth);
            }
        }
        // All of it where that is asked for.
        let whole = stretches(&path, &all, 720);
        assert_eq!((whole.len(), whole[0].samples.len()), (1, all.len()));
    }
}
