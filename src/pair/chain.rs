//! One chain of arcs that are free all along, unrolled over as many turns as it takes.

use std::f64::consts::{PI, TAU};

use super::FreeAngles;

/// An arc in a chain, unrolled.
#[derive(Clone, Copy)]
struct Link {
    arc: [f64; 2],
    /// The narrowest overlap up to here, rad.
    narrowest: f64,
    before: usize,
}

/// From each place to the next arcs that overlap, unrolled, rad: of all such chains one whose
/// narrowest overlap is widest.
///
/// # Errors
/// The first place to which no chain leads.
pub fn chain(common: &[FreeAngles]) -> Result<Vec<[f64; 2]>, usize> {
    let mut layers: Vec<Vec<Link>> = Vec::with_capacity(common.len());
    for (place, free) in common.iter().enumerate() {
        let arcs = free.joined();
        let layer: Vec<Link> = match layers.last() {
            None => arcs.iter().map(|arc| Link { arc: cut(*arc, 0.0), narrowest: f64::INFINITY, before: 0 }).collect(),
            Some(last) => arcs.iter().filter_map(|arc| joined(last, *arc)).collect(),
        };
        if layer.is_empty() {
            return Err(place);
        }
        layers.push(layer);
    }
    let widest = |layer: &Vec<Link>| {
        (0..layer.len()).max_by(|a, b| layer[*a].narrowest.total_cmp(&layer[*b].narrowest)).unwrap_or(0)
    };
    let mut at = layers.last().map_or(0, widest);
    let mut out = Vec::with_capacity(layers.len());
    for layer in layers.iter().rev() {
        out.push(layer[at].arc);
        at = layer[at].before;
    }
    out.reverse();
    Ok(out)
}

/// The link of an arc behind the best of those before it.
fn joined(last: &[Link], arc: [f64; 2]) -> Option<Link> {
    let behind = |(before, link): (usize, &Link)| {
        let middle = 0.5 * (link.arc[0] + link.arc[1]);
        let arc = cut(arc, middle);
        // On the turn whose middle is nearest.
        let by = ((middle - 0.5 * (arc[0] + arc[1])) / TAU).round() * TAU;
        let arc = arc.map(|end| end + by);
        let overlap = arc[1].min(link.arc[1]) - arc[0].max(link.arc[0]);
        (overlap >= 0.0).then_some(Link { arc, narrowest: overlap.min(link.narrowest), before })
    };
    last.iter().enumerate().filter_map(behind).max_by(|a, b| a.narrowest.total_cmp(&b.narrowest))
}

/// Where all angles are free, half a turn to either side of one.
fn cut(arc: [f64; 2], about: f64) -> [f64; 2] {
    if arc[0].is_finite() { arc } else { [about - PI, about + PI] }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_chain_goes_on_over_the_turns_and_past_arcs_that_end() {
        let turning = |k: u32| 0.2 * f64::from(k);
        let common: Vec<FreeAngles> = (0..100)
            .map(|k| {
                // Beside it a wider arc that ends.
                let beside = [turning(k) + 2.0, turning(k) + 5.0];
                let own = [turning(k), turning(k) + 1.0];
                FreeAngles::of(if k < 50 { vec![own, beside] } else { vec![own] })
            })
            .collect();
        let found = chain(&common).expect("a chain");
        let off = found[0][0];
        assert!(off.rem_euclid(TAU) < 1e-9 || off.rem_euclid(TAU) > TAU - 1e-9);
        for (k, [from, to]) in (0..).zip(&found) {
            assert!((from - off - turning(k)).abs() < 1e-9 && (to - from - 1.0).abs() < 1e-9, "{k} {from} {to}");
        }
    }

    #[test]
    fn arcs_that_do_not_meet_are_no_chain() {
        let apart = [FreeAngles::of([[0.0, 1.0]]), FreeAngles::of([[0.9, 2.0]]), FreeAngles::of([[3.0, 4.0]])];
        assert_eq!(chain(&apart), Err(2));
        assert_eq!(chain(&[FreeAngles::all(), FreeAngles::default()]), Err(1));
        let free = chain(&[FreeAngles::all(), FreeAngles::of([[6.0, 6.5]])]).expect("a chain");
        assert!(free[0][0] <= free[1][0] && free[1][1] - free[1][0] < 0.51, "{free:?}");
        assert_eq!(chain(&[]), Ok(Vec::new()));
    }
}
