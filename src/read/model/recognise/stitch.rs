//! Sections of parts that are open: chains whose ends lie near each other become loops.
//!
//! Two sheets that face each other, pressure and suction side, are cut in two chains with a gap at
//! each edge; a tear is a gap in one. The nearest two ends are joined first, whichever way their
//! chains run, as long as the gap is small beside them.

use crate::geometry::slice::Loop;

/// Greatest gap, as a share of the length of the chains that meet there.
const GAP: f64 = 0.15;
/// More chains than this in one section are no blade's.
const MOST: usize = 24;

/// Loops with open chains joined where their ends are near; chains that stay open are left out.
/// Every loop is closed; those joined run counter-clockwise.
pub fn stitched(loops: Vec<Loop>) -> Vec<Loop> {
    let (mut out, mut open): (Vec<Loop>, Vec<Loop>) = loops.into_iter().partition(|l| l.closed);
    open.retain(|l| l.points.len() >= 2);
    if open.len() > MOST {
        return out;
    }
    while let Some((i, j, turn)) = nearest(&open) {
        if i == j {
            out.push(closed(open.swap_remove(i)));
            continue;
        }
        let mut second = open.swap_remove(i.max(j));
        let mut first = std::mem::replace(&mut open[i.min(j)], empty());
        if turn[0] {
            reverse(&mut first);
        }
        if turn[1] {
            reverse(&mut second);
        }
        // The segment over the gap counts to the triangle before it.
        first.triangles.extend(first.triangles.last().copied());
        first.triangles.append(&mut second.triangles);
        first.points.append(&mut second.points);
        open[i.min(j)] = first;
    }
    out
}

fn empty() -> Loop {
    Loop { points: Vec::new(), triangles: Vec::new(), closed: false }
}

/// Two chains to join, and which of them to turn round first.
type Joint = (usize, usize, [bool; 2]);

/// The two chains with the smallest gap that may be closed, lower number first, and which of them
/// to turn round so that the first ends where the second begins.
fn nearest(open: &[Loop]) -> Option<Joint> {
    let mut best: Option<(f64, Joint)> = None;
    let mut offer = |gap: f64, length: f64, what| {
        if gap <= GAP * length && best.is_none_or(|(g, _)| gap < g) {
            best = Some((gap, what));
        }
    };
    let apart = |a: [f64; 2], b: [f64; 2]| (a[0] - b[0]).hypot(a[1] - b[1]);
    let ends: Vec<[[f64; 2]; 2]> = open.iter().filter_map(|l| Some([*l.points.first()?, *l.points.last()?])).collect();
    let lengths: Vec<f64> = open.iter().map(Loop::length_mm).collect();
    for i in 0..ends.len() {
        offer(apart(ends[i][0], ends[i][1]), lengths[i], (i, i, [false; 2]));
        for j in i + 1..ends.len() {
            for turn in [[false, false], [true, false], [false, true], [true, true]] {
                let (from, to) = (ends[i][usize::from(!turn[0])], ends[j][usize::from(turn[1])]);
                offer(apart(from, to), lengths[i].min(lengths[j]), (i, j, turn));
            }
        }
    }
    best.map(|(_, what)| what)
}

/// The chain run the other way.
fn reverse(l: &mut Loop) {
    l.points.reverse();
    l.triangles.reverse();
}

/// The chain with its ends joined, counter-clockwise.
fn closed(mut l: Loop) -> Loop {
    if l.area_mm2() < 0.0 {
        reverse(&mut l);
    }
    l.triangles.extend(l.triangles.last().copied());
    l.closed = true;
    l
}

#[cfg(test)]
mod tests {
    use super::*;

    fn chain(points: &[[f64; 2]]) -> Loop {
        Loop { points: points.to_vec(), triangles: (1..points.len() as u32).collect(), closed: false }
    }

    #[test]
    fn two_sides_that_do_not_meet_become_one_loop_whichever_way_they_run() {
        let lower = [[0.0, 0.0], [5.0, -1.0], [10.0, 0.0]];
        let upper = [[0.0, 0.2], [5.0, 1.5], [10.0, 0.2]];
        for (turn_lower, turn_upper) in [(false, false), (false, true), (true, false), (true, true)] {
            let (mut a, mut b) = (chain(&lower), chain(&upper));
            if turn_lower {
                reverse(&mut a);
            }
            if turn_upper {
                reverse(&mut b);
            }
            let loops = stitched(vec![a, b]);
            assert_eq!(loops.len(), 1);
            assert!(loops[0].closed && loops[0].points.len() == 6 && loops[0].triangles.len() == 6);
            // Below the lower chord 5, between the chords 2, above the upper chord 6.5.
            assert!((loops[0].area_mm2() - 13.5).abs() < 1e-12, "{}", loops[0].area_mm2());
        }
    }

    #[test]
    fn a_torn_loop_is_closed_and_an_open_side_is_not() {
        let torn = chain(&[[0.0, 0.5], [0.0, 10.0], [10.0, 10.0], [10.0, 0.0], [0.5, 0.0]]);
        let loops = stitched(vec![torn]);
        assert!(loops.len() == 1 && loops[0].closed && loops[0].area_mm2() > 99.0);
        assert!(stitched(vec![chain(&[[0.0, 0.0], [5.0, 1.0], [10.0, 0.0]])]).is_empty());
    }
}
