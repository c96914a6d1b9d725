//! The aim *fewest*: breaks as far apart as the tube lets them be.
//!
//! A single polynomial reaches so far ([`super::longest`]); a spline, whose pieces also have to
//! meet, has about [`FIRST`] pieces for each. The search begins with these, and looks for the curve
//! that misses the tube least ([`crate::numerics::elastic`]):
//!
//! 1. Spans that have no room are halved, until all have.
//! 2. Breaks are taken out, many at a time but no two beside one another, first those where the
//!    fifth derivative jumps least. Beside spans that then have no room breaks come back. From the
//!    second round on a break that came back is not tried again.
//!
//! Which breaks are fewest is no convex problem: what is found is few, and the bound of
//! [`super::longest`] says how few there might be at best.

use super::form::Form;
use super::longest::{self, Gate};
use super::room::TubeRoom;
use super::start;
use super::stretch::SmoothStretch;
use super::tube::{self, Cells, Tube, frame_at};
use crate::geometry::Vector;
use crate::numerics::elastic::{self, Nearest};
use crate::numerics::quintic::{Breaks, apply, weighed};

/// Pieces of the first curve for each polynomial without joints.
const FIRST: usize = 4;
/// Share of the room that the search takes.
const TAKEN: f64 = 0.95;
/// A span has no room where it misses its limits by more than this, over half their width: less
/// than the search leaves.
const NO_ROOM: f64 = 0.04;
/// Evenness of the fit that the search begins with, against distances over the room.
pub(super) const EVEN: f64 = 1.0;
/// Looks at the part for one set of breaks: where spans are halved, and where breaks are taken out.
const LOOKS: [usize; 2] = [2, 1];
/// Rounds in which spans are halved.
const FINER: usize = 8;
/// Breaks that are taken out at a time are so many apart at least in the first round, in which one
/// of so many is tried, …
const FIRST_ROUND: [usize; 2] = [3, 3];
/// … and in the others, so that places without room are told apart.
const OTHERS: [usize; 2] = [6, 10];
/// Rounds at most, and where the search begins with the breaks of another curve.
const ROUNDS: [usize; 2] = [9, 4];
/// Tries of a round.
const TRIES: usize = 3;
/// Of the breaks that are taken out those come back that are no more spans than this from one that
/// has no room.
const BESIDE: usize = 3;

impl SmoothStretch<'_> {
    /// Breaks with few pieces on which there is a curve in the tube, or where none were found the
    /// best so far. `None` where numbers are not finite. `like`: breaks to begin with.
    pub fn few_breaks(&self, like: Option<&Breaks>) -> Option<Breaks> {
        let mut breaks = like.cloned().or_else(|| self.first_few())?;
        let mut found = self.nearest(&breaks, LOOKS[0])?;
        for _ in 0..FINER {
            let lacks = lacking(&found.missed);
            if !lacks.contains(&true) {
                break;
            }
            // Where numbers are too coarse for that, the curve is sought as it is.
            let Some(finer) = start::halved(&breaks, |i| lacks[i]) else { return Some(breaks) };
            breaks = finer;
            found = self.nearest(&breaks, LOOKS[0])?;
        }
        if found.missed.iter().any(|m| *m > NO_ROOM) {
            return Some(breaks);
        }
        let mut refused: Vec<f64> = Vec::new();
        for round in 0..ROUNDS[usize::from(like.is_some())] {
            let most = if round == 0 { FIRST_ROUND } else { OTHERS };
            let out = self.cheapest((&breaks, &found.x), &refused, most);
            if out.is_empty() {
                break;
            }
            let mut back = Vec::new();
            if let Some((fewer, x)) = self.without(&breaks, out, &mut back) {
                (breaks, found.x) = (fewer, x);
            }
            // Of many at a time it is not known which leave no room.
            if round > 0 {
                refused.append(&mut back);
                refused.sort_by(f64::total_cmp);
            }
        }
        Some(breaks)
    }

    /// The least number of pieces of any spline of degree 5 in the same parameter that goes as near
    /// to the locations: within the room of the options, or as far off as this curve where that is
    /// farther.
    pub fn least_pieces(&self, breaks: &Breaks, x: &[[f64; 3]]) -> usize {
        let options = self.options;
        let gate = |k: usize| {
            let (l, r) = (&self.locations[k], &self.room[k]);
            let i = breaks.span_of(l.s_mm);
            let off = Vector::from(weighed(&x[i..], &breaks.weights(i, l.s_mm))) - l.centre.coords;
            let frame = frame_at(self.locations, k);
            let room = [[options.inwards_mm, options.outwards_mm], [r.across_mm; 2], [r.along_mm; 2]];
            let ends = std::array::from_fn(|d| {
                let own = frame[d].dot(&off);
                [own.min(-room[d][0]), own.max(room[d][1])]
            });
            Gate::at(self.locations, k, ends)
        };
        let gates: Vec<Gate> = (0..self.locations.len()).map(gate).collect();
        longest::groups(&gates).len()
    }

    fn first_few(&self) -> Option<Breaks> {
        let gate = |(k, r): (usize, &TubeRoom)| {
            let ends = [[-r.inwards_mm, r.outwards_mm], [-r.across_mm, r.across_mm], [-r.along_mm, r.along_mm]];
            Gate::at(self.locations, k, ends)
        };
        let gates: Vec<Gate> = self.room.iter().enumerate().map(gate).collect();
        let groups = longest::groups(&gates);
        let s = |k: usize| self.locations[k].s_mm;
        let last = self.locations.len() - 1;
        let mut out = Vec::new();
        for (g, from) in groups.iter().enumerate() {
            let to = groups.get(g + 1).copied().unwrap_or(last);
            if *from < to {
                out.extend((0..FIRST).map(|j| s(*from) + (s(to) - s(*from)) * j as f64 / FIRST as f64));
            }
        }
        out.push(s(last));
        Breaks::new(out)
    }

    /// The curve that misses the tube least.
    fn nearest(&self, breaks: &Breaks, looks: usize) -> Option<Nearest<3>> {
        let room: Vec<TubeRoom> = self.room.iter().map(|r| r.times(TAKEN)).collect();
        let cells = Cells::of_moves(breaks, self.locations);
        let mut x = start::fit(self.locations, breaks, self.allowed(), EVEN)?;
        let mut missed = Vec::new();
        let nothing = |_: usize| Form { hessian: Box::new([[0.0; 18]; 18]), gradient: [0.0; 18], value: 0.0 };
        for _ in 0..looks {
            let seen = tube::look(self.part, self.radius_mm, (breaks, &cells), &x)?;
            let tube = Tube { locations: self.locations, breaks, cells: &cells, x: &x, seen: &seen, room: &room };
            let found = elastic::nearest(&tube.spans(&nothing).0)?;
            x = x.iter().zip(&found.x).map(|(a, b)| std::array::from_fn(|d| a[d] + b[d])).collect();
            missed = found.missed;
        }
        Some(Nearest { x, missed })
    }

    /// Inner breaks that may be taken out together: those where the fifth derivative jumps least.
    fn cheapest(
        &self,
        (breaks, x): (&Breaks, &[[f64; 3]]),
        refused: &[f64],
        [apart, one_of]: [usize; 2],
    ) -> Vec<usize> {
        let all = breaks.all();
        let fifth = |i: usize| {
            let o = apply(&breaks.ordinates(i, breaks.span(i)), &x[i..]).map(Vector::from);
            let h = all[i + 1] - all[i];
            (o[5] - o[0] + (o[1] - o[4]) * 5.0 + (o[3] - o[2]) * 10.0) / h.powi(5)
        };
        let fifths: Vec<Vector> = (0..breaks.spans()).map(fifth).collect();
        let cost = |j: usize| {
            let reach = (0.5 * (all[j + 1] - all[j - 1])).powi(5);
            let k = self.locations.partition_point(|l| l.s_mm < all[j]).min(self.locations.len() - 1);
            let (frame, r) = (frame_at(self.locations, k), &self.room[k]);
            let widths = [r.inwards_mm + r.outwards_mm, 2.0 * r.across_mm, 2.0 * r.along_mm];
            let jump = (fifths[j] - fifths[j - 1]) * reach;
            frame.iter().zip(widths).map(|(d, w)| d.dot(&jump).abs() / w).fold(0.0, f64::max)
        };
        let mut open: Vec<(f64, usize)> = (1..breaks.spans())
            .filter(|j| refused.binary_search_by(|s| s.total_cmp(&all[*j])).is_err())
            .map(|j| (cost(j), j))
            .collect();
        open.sort_by(|a, b| a.0.total_cmp(&b.0).then(a.1.cmp(&b.1)));
        let mut taken = vec![false; all.len()];
        let mut out = Vec::new();
        let most = open.len().div_ceil(one_of);
        for (_, j) in open {
            if out.len() < most && !taken[j.saturating_sub(apart - 1)..(j + apart).min(all.len())].contains(&true) {
                taken[j] = true;
                out.push(j);
            }
        }
        out
    }

    /// The breaks without some, or without fewer of them where that leaves no room, and the curve;
    /// those that came back are noted. `None` where no room is left after all tries.
    fn without(&self, breaks: &Breaks, mut out: Vec<usize>, refused: &mut Vec<f64>) -> Option<(Breaks, Vec<[f64; 3]>)> {
        let all = breaks.all();
        for _ in 0..TRIES {
            if out.is_empty() {
                break;
            }
            let mut is_out = vec![false; all.len()];
            out.iter().for_each(|j| is_out[*j] = true);
            let fewer = Breaks::new(all.iter().zip(&is_out).filter(|(_, o)| !**o).map(|(s, _)| *s).collect())?;
            let found = self.nearest(&fewer, LOOKS[1])?;
            let lacks: Vec<bool> = found.missed.iter().map(|m| *m > NO_ROOM).collect();
            if !lacks.contains(&true) {
                return Some((fewer, found.x));
            }
            let is_beside = |j: &usize| {
                let i = fewer.span_of(all[*j]);
                lacks[i.saturating_sub(BESIDE)..(i + BESIDE + 1).min(lacks.len())].contains(&true)
            };
            let (back, rest): (Vec<usize>, Vec<usize>) = out.iter().partition(|j| is_beside(j));
            if back.is_empty() {
                break;
            }
            refused.extend(back.iter().map(|j| all[*j]));
            out = rest;
        }
        refused.extend(out.iter().map(|j| all[*j]));
        None
    }
}

/// Spans that have no room, and miss no less than half as much as those about them: what is missed
/// in one place others share.
fn lacking(missed: &[f64]) -> Vec<bool> {
    let is = |i: usize| {
        let near = &missed[i.saturating_sub(2)..(i + 3).min(missed.len())];
        missed[i] > NO_ROOM && near.iter().all(|m| 0.5 * m <= missed[i])
    };
    (0..missed.len()).map(is).collect()
}
