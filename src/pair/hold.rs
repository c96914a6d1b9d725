//! An angle of the table for each row, at which it stands still while both tools cut.

use std::f64::consts::{PI, TAU};
use std::ops::Range;

use super::FreeAngles;
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

/// A stretch of a row that is cut at one angle of the table.
#[derive(Clone, Debug, PartialEq)]
pub struct Held {
    /// Row, from 0.
    pub row: usize,
    /// Places of the stretch.
    pub places: Range<usize>,
    /// The angle, rad; the next stretch's is on the turn that is nearest to it.
    pub theta_rad: f64,
    /// Room to the ends of what is free at all of the stretch, rad.
    pub margin_rad: f64,
    /// Angles that are free at all of the stretch.
    pub free: FreeAngles,
}

/// Angles at which the table stands still, for each row one or, where no angle is free all along
/// it, as few as can be, one for each stretch; a stretch begins at the last place of the one
/// before. Among them those between which the table turns least in all. `common`: what is free for
/// both tools at each place; `clear`: whether the tools keep clear of each other at all places of a
/// stretch, at an angle.
///
/// # Errors
/// A place at which no angle is free and clear, or none that is so to the next place too.
pub fn hold(
    rows: &[Range<usize>],
    common: &[FreeAngles],
    options: HoldOptions,
    clear: impl Fn(&Range<usize>, f64) -> bool + Sync,
) -> Result<Vec<Held>, usize> {
    let stretches = parallel::try_map(rows.iter().enumerate(), |(row, places)| {
        let mut out = Vec::new();
        for (part, free) in stretches(places, common)? {
            split(part, &free, common, options, &clear, &mut out)?;
        }
        Ok::<_, usize>(out.into_iter().map(|s| (row, s)).collect::<Vec<_>>())
    })?
    .concat();
    Ok(chosen(stretches))
}

/// A stretch of a row with the angles that it may be cut at, each with its margin, rad.
#[derive(Clone)]
struct RowStretch {
    places: Range<usize>,
    free: FreeAngles,
    candidates: Vec<[f64; 2]>,
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
    clear: &impl Fn(&Range<usize>, f64) -> bool,
    out: &mut Vec<RowStretch>,
) -> Result<(), usize> {
    let enough = options.margin_rad.min(0.5 * free.widest());
    let grid = (0..(TAU / STEP_RAD).round() as usize).map(|k| k as f64 * STEP_RAD);
    let candidates: Vec<[f64; 2]> = grid
        .chain(free.middles())
        .map(|theta| [theta, free.margin(theta)])
        .filter(|[theta, margin]| *margin >= enough * (1.0 - 1e-9) && *margin >= 0.0 && clear(&places, *theta))
        .collect();
    if !candidates.is_empty() {
        out.push(RowStretch { places, free: free.clone(), candidates });
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
fn chosen(stretches: Vec<(usize, RowStretch)>) -> Vec<Held> {
    let way = |a: f64, b: f64| {
        let d = (b - a).rem_euclid(TAU);
        d.min(TAU - d)
    };
    let cost_of = |[_, margin]: [f64; 2]| -FOR_MARGIN * margin.min(TAU) / TAU;
    // Least cost up to each candidate, and from which one before it.
    let mut layers: Vec<Vec<(f64, usize)>> = Vec::with_capacity(stretches.len());
    for (n, (_, stretch)) in stretches.iter().enumerate() {
        let layer = stretch.candidates.iter().map(|here| {
            let own = cost_of(*here);
            let Some(before) = n.checked_sub(1) else { return (own, 0) };
            let from = |k: usize| layers[before][k].0 + way(stretches[before].1.candidates[k][0], here[0]);
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
    let mut theta_rad = 0.0;
    let held = |(n, (row, stretch)): (usize, (usize, RowStretch))| {
        let [theta, margin_rad] = stretch.candidates[picked[n]];
        theta_rad = if n == 0 { theta } else { crate::numerics::angle::nearest_turn(theta, theta_rad) };
        Held { row, places: stretch.places, theta_rad, margin_rad, free: stretch.free }
    };
    stretches.into_iter().enumerate().map(held).collect()
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used)]
    use super::*;

    fn deg(arcs: &[[f64; 2]]) -> FreeAngles {
        FreeAngles::of(arcs.iter().map(|a| a.map(f64::to_radians)))
    }

    fn held(rows: &[Range<usize>], common: &[FreeAngles]) -> Vec<Held> {
        hold(rows, common, HoldOptions { margin_rad: 0.0 }, |_, _| true).unwrap()
    }

    #[test]
    fn a_table_that_can_stand_still_for_all_rows_does() {
        let common: Vec<FreeAngles> =
            (0..60).map(|k| deg(&[[f64::from(k), 90.0 + f64::from(k)], [200.0, 210.0]])).collect();
        // The first arc narrows to 59 to 90 degrees.
        let found = held(&[0..20, 20..40, 40..60], &common);
        assert_eq!(found.len(), 3);
        assert!(found.windows(2).all(|w| w[0].theta_rad == w[1].theta_rad), "{found:?}");
        for h in &found {
            assert!(h.places.clone().all(|k| common[k].margin(h.theta_rad) >= h.margin_rad - 1e-12));
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
        let turned: f64 = found.windows(2).map(|w| (w[1].theta_rad - w[0].theta_rad).abs()).sum();
        assert!((turned.to_degrees() - 68.0).abs() < 1e-9, "{}", turned.to_degrees());
    }

    #[test]
    fn the_way_over_0_is_the_short_one() {
        let arcs = [[350.0, 352.0], [8.0, 10.0], [20.0, 22.0]].map(|arc| deg(&[arc]));
        let found = held(&[0..1, 1..2, 2..3], &arcs);
        let turned = (found[2].theta_rad - found[0].theta_rad).to_degrees();
        assert!((28.0 - 1e-9..=32.0).contains(&turned), "{turned}");
    }

    #[test]
    fn where_the_tools_are_in_each_others_way_another_angle_is_taken_or_the_row_is_parted() {
        let common = vec![deg(&[[10.0, 50.0]]); 8];
        let options = HoldOptions { margin_rad: 0.0 };
        // Clear from 40 degrees on.
        let found = hold(std::slice::from_ref(&(0..8)), &common, options, |_, theta| theta > 0.69).unwrap();
        assert!(found.len() == 1 && found[0].theta_rad > 0.69, "{found:?}");
        // Before place 4 less than 20 degrees is asked for, behind it more than 30.
        let clear = |places: &Range<usize>, theta: f64| {
            places.clone().all(|k| match k.cmp(&4) {
                std::cmp::Ordering::Less => theta < 0.34,
                std::cmp::Ordering::Equal => true,
                std::cmp::Ordering::Greater => theta > 0.53,
            })
        };
        let found = hold(std::slice::from_ref(&(0..8)), &common, options, clear).unwrap();
        assert_eq!(found.iter().map(|h| h.places.clone()).collect::<Vec<_>>(), [0..5, 4..8]);
        assert_eq!(hold(std::slice::from_ref(&(0..8)), &common, options, |p, _| !p.contains(&6)), Err(5));
    }

    #[test]
    fn a_place_without_an_angle_is_named() {
        let common = [deg(&[[10.0, 50.0]]), FreeAngles::default(), deg(&[[10.0, 50.0]])];
        assert_eq!(hold(std::slice::from_ref(&(0..3)), &common, HoldOptions { margin_rad: 0.0 }, |_, _| true), Err(1));
    }

    #[test]
    fn margins_are_kept_where_there_is_room_for_them() {
        let common = vec![deg(&[[10.0, 50.0]]), deg(&[[48.0, 80.0]])];
        let options = HoldOptions { margin_rad: 5f64.to_radians() };
        let found = hold(&[0..1, 1..2], &common, options, |_, _| true).unwrap();
        assert!(found.iter().all(|h| h.margin_rad >= options.margin_rad * (1.0 - 1e-9)), "{found:?}");
        assert!((found[1].theta_rad - found[0].theta_rad).to_degrees() < 8.0 + 1e-9, "45 to 53 degrees");
    }
}
