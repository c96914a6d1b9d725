//! An angle of the table for each row, at which it stands still while both tools cut.

use std::f64::consts::{PI, TAU};
use std::ops::Range;

use super::{FreeAngles, Turned, TurningRow};
use crate::artifact::paired::Held;
use crate::numerics::angle::nearest_turn;
use crate::parallel;

/// Angles that are looked at lie so far apart, rad.
const STEP_RAD: f64 = PI / 180.0;
/// A whole turn of margin weighs as much as this of turning between rows: it decides only among
/// angles that are as near.
const FOR_MARGIN: f64 = 0.02;

/// How tables are held still.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct HoldOptions {
    /// Room to the ends of what is free, rad; where that is narrower, its middle is taken.
    pub margin_rad: f64,
}

/// How the table may turn along rows without one free angle, while both tools cut.
#[derive(Clone, Copy)]
pub struct Turning<'a> {
    /// The way from each place to the next, mm; the table turns as slowly as can be over it.
    pub way_mm: &'a [f64],
    /// What it may turn from each place to the next at most, rad.
    pub most_rad: &'a [f64],
    /// Whether it may along a row, from 0.
    pub may: &'a (dyn Fn(usize) -> bool + Sync),
    /// The angles of posture curves at all places, rad: it then turns by them, wherever it may,
    /// whether or not it could stand still.
    pub posture_rad: Option<&'a [f64]>,
}

/// How the table stands along rows.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Planned {
    /// All stretches, in order.
    pub held: Vec<Held>,
    /// Stretches along which the table was planned to turn: their numbers, and what no angles fall
    /// below in their steepest slope, rad/mm.
    pub least_slopes: Vec<(usize, f64)>,
}

/// Angles at which the table stands still, for each row one or, where no angle is free all along
/// it, as few as can be, one for each stretch; a stretch begins at the last place of the one
/// before. With `turning` such rows are stretches along which the table turns instead. Among them
/// those between which the table turns least in all. `common`: what is free for both tools at each
/// place; `clear`: whether the tools keep clear of each other at all places of a stretch, at the
/// angles that it has at places.
///
/// # Errors
/// A place at which no angle is free and clear, or none that is so to the next place too.
pub fn hold(
    rows: &[Range<usize>],
    common: &[FreeAngles],
    options: HoldOptions,
    turning: Option<Turning>,
    clear: impl Fn(&Range<usize>, &dyn Fn(usize) -> f64) -> bool + Sync,
) -> Result<Planned, usize> {
    let still = |places: &Range<usize>| {
        let mut out = Vec::new();
        for (part, free) in stretches(places, common)? {
            split(part, &free, common, options, &clear, &mut out)?;
        }
        Ok::<_, usize>(out)
    };
    let stretches = parallel::try_map(rows.iter().enumerate(), |(row, places)| {
        let found = still(places);
        let has_to = found.as_ref().map_or(true, |parts| parts.len() > 1);
        let turned = turning.filter(|t| (t.may)(row) && (has_to || t.posture_rad.is_some()));
        let turned = turned.and_then(|t| turns(places, common, options, t, &clear));
        let parts = turned.map_or(found, Ok)?;
        Ok::<_, usize>(parts.into_iter().map(|part| (row, part)).collect::<Vec<_>>())
    })?
    .concat();
    Ok(chosen(stretches))
}

/// A stretch of a row.
#[derive(Clone)]
struct RowStretch {
    places: Range<usize>,
    along: Along,
}

/// How the table may stand along a stretch.
#[derive(Clone)]
enum Along {
    /// Still, at one of these angles, each with its margin, rad.
    Still(Vec<[f64; 2]>),
    /// At these angles, turning, with their margin, rad, and the least steepest slope, rad/mm.
    Turning { theta_rad: Vec<f64>, margin_rad: f64, least_slope: f64 },
}

/// Angles with which a stretch may begin and end, and their margin, rad.
#[derive(Clone, Copy)]
struct Candidate {
    ends: [f64; 2],
    margin: f64,
}

impl RowStretch {
    fn candidates(&self) -> usize {
        match &self.along {
            Along::Still(all) => all.len(),
            Along::Turning { .. } => 1,
        }
    }

    fn candidate(&self, k: usize) -> Candidate {
        match &self.along {
            Along::Still(all) => Candidate { ends: [all[k][0]; 2], margin: all[k][1] },
            Along::Turning { theta_rad, margin_rad, .. } => {
                Candidate { ends: [theta_rad[0], theta_rad[theta_rad.len() - 1]], margin: *margin_rad }
            }
        }
    }
}

/// A row along which the table turns; `None` where it cannot, or the tools are in each other's way.
fn turns(
    places: &Range<usize>,
    common: &[FreeAngles],
    options: HoldOptions,
    turning: Turning,
    clear: &impl Fn(&Range<usize>, &dyn Fn(usize) -> f64) -> bool,
) -> Option<Vec<RowStretch>> {
    let moves = places.start..places.end.saturating_sub(1);
    let row = TurningRow {
        common: &common[places.clone()],
        way_mm: &turning.way_mm[moves.clone()],
        most_rad: &turning.most_rad[moves],
        margin_rad: options.margin_rad,
    };
    let all = match turning.posture_rad {
        None => row.turned().ok()?,
        Some(posture) => {
            let theta_rad = row.local(&posture[places.clone()])?;
            vec![Turned { places: 0..places.len(), theta_rad, least_slope: row.least_slope() }]
        }
    };
    let one = |turned: Turned| {
        let own = places.start + turned.places.start..places.start + turned.places.end;
        let Turned { theta_rad, least_slope, places: _ } = turned;
        let is_clear = theta_rad.len() == own.len() && clear(&own, &|k| theta_rad[k - own.start]);
        let margins = own.clone().zip(&theta_rad).map(|(k, theta)| common[k].margin(*theta));
        let margin_rad = margins.fold(f64::INFINITY, f64::min);
        let along = Along::Turning { theta_rad, margin_rad, least_slope };
        is_clear.then_some(RowStretch { places: own, along })
    };
    all.into_iter().map(one).collect()
}

/// A row in as few stretches with a common free angle as can be: each goes as far as it can, and
/// the next begins at its last place.
fn stretches(places: &Range<usize>, common: &[FreeAngles]) -> Result<Vec<(Range<usize>, FreeAngles)>, usize> {
    let mut out = Vec::new();
    let (mut from, mut free) = (places.start, FreeAngles::all());
    for k in places.clone() {
        let more = free.and(&common[k]);
        if !more.is_empty() {
            free = more;
            continue;
        }
        // The table turns at the place before, whose angles are all free still where it is the
        // first.
        let next = match k.checked_sub(1).filter(|last| *last > from) {
            Some(last) => common[last].and(&common[k]),
            None => FreeAngles::default(),
        };
        if next.is_empty() {
            return Err(k);
        }
        out.push((from..k, std::mem::replace(&mut free, next)));
        from = k - 1;
    }
    out.push((from..places.end, free));
    Ok(out)
}

/// Adds a stretch with its candidates; in halves where none of them is clear.
fn split(
    places: Range<usize>,
    free: &FreeAngles,
    common: &[FreeAngles],
    options: HoldOptions,
    clear: &impl Fn(&Range<usize>, &dyn Fn(usize) -> f64) -> bool,
    out: &mut Vec<RowStretch>,
) -> Result<(), usize> {
    let enough = options.margin_rad.min(0.5 * free.widest());
    let grid = (0..(TAU / STEP_RAD).round() as usize).map(|k| k as f64 * STEP_RAD);
    let candidates: Vec<[f64; 2]> = grid
        .chain(free.middles())
        .map(|theta| [theta, free.margin(theta)])
        .filter(|[theta, margin]| *margin >= enough * (1.0 - 1e-9) && *margin >= 0.0 && clear(&places, &|_| *theta))
        .collect();
    if !candidates.is_empty() {
        out.push(RowStretch { places, along: Along::Still(candidates) });
        return Ok(());
    }
    if places.len() < 3 {
        return Err(places.start);
    }
    let middle = places.start + places.len() / 2;
    for half in [places.start..middle + 1, middle..places.end] {
        let free = common[half.clone()].iter().fold(FreeAngles::all(), |free, here| free.and(here));
        split(half, &free, common, options, clear, out)?;
    }
    Ok(())
}

/// The candidates between which the table turns least, the widest margin among equals.
fn chosen(stretches: Vec<(usize, RowStretch)>) -> Planned {
    let way = |a: f64, b: f64| {
        let d = (b - a).rem_euclid(TAU);
        d.min(TAU - d)
    };
    let cost_of = |here: Candidate| -FOR_MARGIN * here.margin.min(TAU) / TAU;
    // Least cost up to each candidate, and from which one before it.
    let mut layers: Vec<Vec<(f64, usize)>> = Vec::with_capacity(stretches.len());
    for (n, (_, stretch)) in stretches.iter().enumerate() {
        let layer = (0..stretch.candidates()).map(|k| {
            let here = stretch.candidate(k);
            let own = cost_of(here);
            let Some(before) = n.checked_sub(1) else { return (own, 0) };
            let from = |k: usize| layers[before][k].0 + way(stretches[before].1.candidate(k).ends[1], here.ends[0]);
            let best = (0..layers[before].len()).min_by(|a, b| from(*a).total_cmp(&from(*b))).unwrap_or(0);
            (from(best) + own, best)
        });
        let layer = layer.collect();
        layers.push(layer);
    }
    let last = layers.last().and_then(|l| (0..l.len()).min_by(|a, b| l[*a].0.total_cmp(&l[*b].0)));
    let mut at = last.unwrap_or(0);
    let mut picked = vec![0; stretches.len()];
    for n in (0..stretches.len()).rev() {
        picked[n] = at;
        at = layers[n][at].1;
    }
    let mut out = Planned::default();
    for (n, (row, stretch)) in stretches.into_iter().enumerate() {
        let Candidate { ends: [first, _], margin: margin_rad } = stretch.candidate(picked[n]);
        let before = out.held.last().map(|h| h.ends_rad()[1]);
        let start = before.map_or(first, |before| nearest_turn(first, before));
        let theta_rad = match stretch.along {
            Along::Still(_) => vec![start; stretch.places.len()],
            Along::Turning { theta_rad, least_slope, .. } => {
                out.least_slopes.push((n, least_slope));
                theta_rad.into_iter().map(|theta| theta - first + start).collect()
            }
        };
        out.held.push(Held { row, places: stretch.places, theta_rad, margin_rad });
    }
    out
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used)]
    use super::*;

    fn deg(arcs: &[[f64; 2]]) -> FreeAngles {
        FreeAngles::of(arcs.iter().map(|a| a.map(f64::to_radians)))
    }

    fn theta(held: &Held) -> f64 {
        held.ends_rad()[0]
    }

    fn held(rows: &[Range<usize>], common: &[FreeAngles]) -> Vec<Held> {
        hold(rows, common, HoldOptions { margin_rad: 0.0 }, None, |_, _| true).unwrap().held
    }

    #[test]
    fn a_table_that_can_stand_still_for_all_rows_does() {
        let common: Vec<FreeAngles> =
            (0..60).map(|k| deg(&[[f64::from(k), 90.0 + f64::from(k)], [200.0, 210.0]])).collect();
        // The first arc narrows to 59 to 90 degrees.
        let found = held(&[0..20, 20..40, 40..60], &common);
        assert_eq!(found.len(), 3);
        assert!(found.windows(2).all(|w| w[0].ends_rad() == w[1].ends_rad()), "{found:?}");
        for h in &found {
            assert!(h.places.clone().all(|k| common[k].margin(h.theta_at(k)) >= h.margin_rad - 1e-12));
        }
    }

    #[test]
    fn a_row_without_one_angle_is_cut_in_as_few_stretches_as_can_be() {
        // A window of 50 degrees that goes on by 2 from place to place: 26 places share an angle.
        let common: Vec<FreeAngles> =
            (0..60).map(|k| deg(&[[2.0 * f64::from(k), 50.0 + 2.0 * f64::from(k)]])).collect();
        let found = held(std::slice::from_ref(&(0..60)), &common);
        assert_eq!(found.iter().map(|h| h.places.clone()).collect::<Vec<_>>(), [0..26, 25..51, 50..60]);
        // Nothing turns farther than it must: from 50 over 100 to 118 degrees.
        let turned: f64 = found.windows(2).map(|w| (theta(&w[1]) - theta(&w[0])).abs()).sum();
        assert!((turned.to_degrees() - 68.0).abs() < 1e-9, "{}", turned.to_degrees());
    }

    #[test]
    fn the_way_over_0_is_the_short_one() {
        let arcs = [[350.0, 352.0], [8.0, 10.0], [20.0, 22.0]].map(|arc| deg(&[arc]));
        let found = held(&[0..1, 1..2, 2..3], &arcs);
        let turned = (theta(&found[2]) - theta(&found[0])).to_degrees();
        assert!((28.0 - 1e-9..=32.0).contains(&turned), "{turned}");
    }

    #[test]
    fn where_the_tools_are_in_each_others_way_another_angle_is_taken_or_the_row_is_parted() {
        let common = vec![deg(&[[10.0, 50.0]]); 8];
        let options = HoldOptions { margin_rad: 0.0 };
        // Clear from 40 degrees on.
        let found =
            hold(std::slice::from_ref(&(0..8)), &common, options, None, |_, theta| theta(0) > 0.69).unwrap().held;
        assert!(found.len() == 1 && theta(&found[0]) > 0.69, "{found:?}");
        // Before place 4 less than 20 degrees is asked for, behind it more than 30.
        let clear = |places: &Range<usize>, at: &dyn Fn(usize) -> f64| {
            let theta = at(places.start);
            places.clone().all(|k| match k.cmp(&4) {
                std::cmp::Ordering::Less => theta < 0.34,
                std::cmp::Ordering::Equal => true,
                std::cmp::Ordering::Greater => theta > 0.53,
            })
        };
        let found = hold(std::slice::from_ref(&(0..8)), &common, options, None, clear).unwrap().held;
        assert_eq!(found.iter().map(|h| h.places.clone()).collect::<Vec<_>>(), [0..5, 4..8]);
        assert_eq!(hold(std::slice::from_ref(&(0..8)), &common, options, None, |p, _| !p.contains(&6)), Err(5));
    }

    #[test]
    fn a_place_without_an_angle_is_named() {
        let common = [deg(&[[10.0, 50.0]]), FreeAngles::default(), deg(&[[10.0, 50.0]])];
        assert_eq!(
            hold(std::slice::from_ref(&(0..3)), &common, HoldOptions { margin_rad: 0.0 }, None, |_, _| true),
            Err(1)
        );
    }

    #[test]
    fn margins_are_kept_where_there_is_room_for_them() {
        let common = vec![deg(&[[10.0, 50.0]]), deg(&[[48.0, 80.0]])];
        let options = HoldOptions { margin_rad: 5f64.to_radians() };
        let found = hold(&[0..1, 1..2], &common, options, None, |_, _| true).unwrap().held;
        assert!(found.iter().all(|h| h.margin_rad >= options.margin_rad * (1.0 - 1e-9)), "{found:?}");
        assert!((theta(&found[1]) - theta(&found[0])).to_degrees() < 8.0 + 1e-9, "45 to 53 degrees");
    }
}
