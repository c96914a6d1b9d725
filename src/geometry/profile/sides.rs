//! Leading and trailing edge along an airfoil, named once for all of it.
//!
//! In: the ends of its sections along the span. Out: the two edges as polylines, and which side is
//! the suction side.
//!
//! An end continues that end of the neighbouring section in whose direction it lies, both seen from
//! the other end: so a blade may twist through any angle, if only by less than [`MOST_TURN`] from
//! section to section. Sections that are nearly round have no ends and are passed over. The blunter
//! edge is the leading one, by the mean over all sections of the logarithm of the radii's ratio; of
//! equal ones (within 2 %) that with the lesser y, then z. The suction side is the one that bulges
//! more over the chord, in sum.

use super::edges::SectionEnds;
use super::outline::distance;
use crate::geometry::Point;

/// An end continues another where the chord turns by less than this (cosine of 60°).
const MOST_TURN: f64 = 0.5;
/// A section with more than this share of the area of the circle on its chord has no ends.
const ROUND: f64 = 0.8;
/// Edges whose radii differ by less than this, in the mean, are equally blunt.
const EQUAL: f64 = 1.0 / 0.98;
/// No section counts for more than this ratio of radii: a corner has none.
const MOST_RATIO: f64 = 10.0;
/// A section's ends are the airfoil's edges where they lie within this share of the chord from
/// those …
const NEAR: f64 = 0.25;
/// … and where its chord is longer than that of the section beside it by no more than this factor,
/// nor shorter.
const LONGER: f64 = 1.25;
/// The ends of a round section lie anywhere on it: it is the airfoil's where they lie within this
/// share of the chord from the edges.
const NEAR_IF_ROUND: f64 = 1.0;

/// Leading and trailing edge of an airfoil along its span.
#[derive(Clone, Debug, PartialEq, serde::Serialize)]
pub struct Sides {
    /// Points of the leading edge by rising height, blade frame, mm.
    pub leading_edge_mm: Vec<Point>,
    /// Points of the trailing edge at the same heights, blade frame, mm.
    pub trailing_edge_mm: Vec<Point>,
    /// Whether the suction side follows the leading edge counter-clockwise seen from the tip; else
    /// the pressure side does.
    pub suction_follows_leading: bool,
}

/// What the two ends of a section are.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Names {
    /// Whether the first of the two ends is the leading edge.
    pub first_leads: bool,
    /// Whether the suction side follows the leading edge counter-clockwise.
    pub suction_follows_leading: bool,
}

impl Names {
    /// Those of a section of which nothing else is known.
    pub fn alone(ends: &SectionEnds) -> Names {
        let first_leads = leads(std::slice::from_ref(ends));
        let [first, second] = if first_leads { ends.bulge_mm2 } else { ends.exchanged().bulge_mm2 };
        Names { first_leads, suction_follows_leading: first >= second }
    }
}

impl Sides {
    /// The edges through the ends of sections at these heights, mm, which rise; `None` where there
    /// is no section.
    pub fn along(sections: &[(f64, SectionEnds)]) -> Option<Sides> {
        let rank = |k: &usize| sections[*k].1.roundness();
        let slenderest = (0..sections.len()).min_by(|a, b| rank(a).total_cmp(&rank(b)))?;
        let mut joined = vec![(sections[slenderest].0, sections[slenderest].1.clone())];
        continued(&mut joined, sections[..slenderest].iter().rev());
        joined.reverse();
        continued(&mut joined, sections[slenderest + 1..].iter());
        let (heights, mut joined): (Vec<f64>, Vec<SectionEnds>) = joined.into_iter().unzip();
        if !leads(&joined) {
            joined.iter_mut().for_each(|ends| *ends = ends.exchanged());
        }
        let bulges = joined.iter().map(|e| (e.bulge_mm2[0] - e.bulge_mm2[1]) / e.chord_mm().powi(2));
        let point = |(x, e): (&f64, &SectionEnds), k: usize| Point::new(*x, e.at_mm[k][0], e.at_mm[k][1]);
        let edge = |k: usize| heights.iter().zip(&joined).map(|at| point(at, k)).collect();
        Some(Sides {
            leading_edge_mm: edge(0),
            trailing_edge_mm: edge(1),
            suction_follows_leading: bulges.sum::<f64>() >= 0.0,
        })
    }

    /// Lowest and highest height at which the edges are known, mm.
    pub fn x_mm(&self) -> [f64; 2] {
        [self.leading_edge_mm.first(), self.leading_edge_mm.last()].map(|p| p.map_or(f64::NAN, |p| p.x))
    }

    /// Leading and trailing edge at a height, (y, z), mm; beyond those where they are known, at the
    /// nearest of these.
    pub fn at(&self, x_mm: f64) -> [[f64; 2]; 2] {
        let last = self.leading_edge_mm.len().saturating_sub(1);
        let above = self.leading_edge_mm.partition_point(|p| p.x < x_mm).min(last);
        let below = above.saturating_sub(1);
        let (lo, hi) = (self.leading_edge_mm[below].x, self.leading_edge_mm[above].x);
        let share = if hi > lo { ((x_mm - lo) / (hi - lo)).clamp(0.0, 1.0) } else { 0.0 };
        [&self.leading_edge_mm, &self.trailing_edge_mm].map(|edge| {
            let p = edge[below] + (edge[above] - edge[below]) * share;
            [p.y, p.z]
        })
    }

    /// What the ends of the sections of one height are, one name for each; `None` for those that
    /// are not the airfoil's.
    pub fn names(&self, x_mm: f64, loops: &[SectionEnds]) -> Vec<Option<Names>> {
        let away: Vec<f64> = loops.iter().map(|ends| self.away(x_mm, ends)).collect();
        let nearest = (0..loops.len()).min_by(|a, b| away[*a].total_cmp(&away[*b]));
        let [lo, hi] = self.x_mm();
        // A round section, as of a round root, has no ends of its own: it takes those beside it.
        let most = |k: usize| if loops[k].roundness() < ROUND { NEAR } else { NEAR_IF_ROUND };
        let own = nearest.filter(|k| (lo..=hi).contains(&x_mm) || away[*k] < most(*k));
        let [leading, trailing] = self.at(x_mm);
        let chord = [leading[0] - trailing[0], leading[1] - trailing[1]];
        let name = |k: usize| {
            let first_leads = cosine(loops[k].chord(), chord) >= 0.0;
            (own == Some(k)).then_some(Names { first_leads, suction_follows_leading: self.suction_follows_leading })
        };
        (0..loops.len()).map(name).collect()
    }

    /// Whether the ends that were found on a section of the airfoil are not its edges: its outline
    /// is folded there, or torn.
    pub fn are_elsewhere(&self, x_mm: f64, ends: &SectionEnds) -> bool {
        self.away(x_mm, ends) > NEAR
    }

    /// How far the ends of a section are from the edges, over the chord.
    fn away(&self, x_mm: f64, ends: &SectionEnds) -> f64 {
        let [leading, trailing] = self.at(x_mm);
        let off = |k: usize, p: [f64; 2]| distance(ends.at_mm[k], p);
        let off_mm = f64::min(off(0, leading).max(off(1, trailing)), off(1, leading).max(off(0, trailing)));
        off_mm / distance(leading, trailing).max(f64::MIN_POSITIVE)
    }

    /// Those of the mirror image across z = 0.
    #[must_use]
    pub fn mirrored(&self) -> Sides {
        let image = |edge: &[Point]| edge.iter().map(|p| Point::new(p.x, p.y, -p.z)).collect();
        Sides {
            leading_edge_mm: image(&self.leading_edge_mm),
            trailing_edge_mm: image(&self.trailing_edge_mm),
            suction_follows_leading: !self.suction_follows_leading,
        }
    }
}

/// Appends sections to those that are joined, the ends of each in the order of the last one's, as
/// far as it can be told.
fn continued<'a>(joined: &mut Vec<(f64, SectionEnds)>, sections: impl Iterator<Item = &'a (f64, SectionEnds)>) {
    for (x_mm, ends) in sections.filter(|(_, ends)| ends.roundness() < ROUND) {
        let Some((_, last)) = joined.last() else { return };
        let turn = cosine(last.chord(), ends.chord());
        let longer = ends.chord_mm() / last.chord_mm();
        if turn.abs() > MOST_TURN && (1.0 / LONGER..=LONGER).contains(&longer) {
            joined.push((*x_mm, if turn < 0.0 { ends.exchanged() } else { ends.clone() }));
        }
    }
}

/// Whether the first ends of all sections together are the leading edge.
fn leads(sections: &[SectionEnds]) -> bool {
    let most = MOST_RATIO.ln();
    let blunter = |e: &SectionEnds| (e.radius_mm[0] / e.radius_mm[1]).ln().clamp(-most, most);
    let mean = sections.iter().map(blunter).sum::<f64>() / sections.len() as f64;
    if mean.abs() > EQUAL.ln() {
        return mean > 0.0;
    }
    let sum = |end: usize, k: usize| sections.iter().map(|e| e.at_mm[end][k]).sum::<f64>();
    [sum(0, 0), sum(0, 1)] <= [sum(1, 0), sum(1, 1)]
}

/// Cosine of the angle between two directions.
fn cosine(a: [f64; 2], b: [f64; 2]) -> f64 {
    (a[0] * b[0] + a[1] * b[1]) / (a[0].hypot(a[1]) * b[0].hypot(b[1])).max(f64::MIN_POSITIVE)
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used)]
    use std::f64::consts::PI;

    use super::*;

    const HEIGHTS: usize = 33;

    /// Ends of a thin section at a share of the span: its chord is turned by `turn` rad, its first
    /// end leans on `radius` mm. Every other section gives its ends in the other order.
    fn ends(k: usize, turn: f64, radius: [f64; 2]) -> SectionEnds {
        let (s, c) = turn.sin_cos();
        let middle = [3.0 * s, 0.5 * k as f64];
        let at = |half: f64| [middle[0] + half * c, middle[1] + half * s];
        let own = SectionEnds {
            s_mm: [0.0, 42.0],
            at_mm: [at(20.0), at(-20.0)],
            radius_mm: radius,
            bulge_mm2: [150.0, -20.0],
        };
        if k.is_multiple_of(2) { own } else { own.exchanged() }
    }

    /// A blade that twists by more than half a turn and whose first end is the blunter only in the
    /// lower part of its height.
    fn twisted(blunter_up_to: f64) -> Vec<(f64, SectionEnds)> {
        let section = |k: usize| {
            let share = k as f64 / (HEIGHTS - 1) as f64;
            let radius = 0.6 + 0.4 * (blunter_up_to - share);
            (100.0 * share, ends(k, 1.2 * PI * share, [radius, 0.6]))
        };
        (0..HEIGHTS).map(section).collect()
    }

    #[test]
    fn a_round_section_beyond_the_edges_takes_their_names_and_a_slender_one_does_not() {
        let sides = Sides::along(&twisted(0.8)).unwrap();
        let last = sides.names(100.0, &[ends(HEIGHTS - 1, 1.2 * PI, [1.0, 0.6])])[0].unwrap();
        for turn in [0.0, 0.5 * PI, PI, 1.5 * PI] {
            let slender = ends(HEIGHTS - 1, 1.2 * PI + turn, [1.0, 0.6]);
            let round = SectionEnds { bulge_mm2: [200.0 * PI; 2], ..slender.clone() };
            let along = turn == 0.0 || turn == PI;
            assert_eq!(sides.names(104.0, &[slender])[0].is_some(), along, "{turn}");
            let named = sides.names(104.0, &[round])[0].unwrap();
            assert_eq!(named.suction_follows_leading, last.suction_follows_leading);
            assert!(!along || named.first_leads == (last.first_leads == (turn == 0.0)), "{turn}");
        }
    }

    #[test]
    fn edges_are_followed_round_the_twist_and_named_by_all_sections() {
        for (blunter_up_to, first_leads) in [(0.8, true), (0.2, false)] {
            let sections = twisted(blunter_up_to);
            let sides = Sides::along(&sections).unwrap();
            assert_eq!(sides.leading_edge_mm.len(), HEIGHTS);
            assert_eq!(sides.suction_follows_leading, first_leads);
            for (k, (x_mm, own)) in sections.iter().enumerate() {
                let known = if k.is_multiple_of(2) { own.at_mm } else { own.exchanged().at_mm };
                let [leading, trailing] = sides.at(*x_mm);
                let expected = if first_leads { known } else { [known[1], known[0]] };
                assert!(distance(leading, expected[0]) < 1e-9 && distance(trailing, expected[1]) < 1e-9, "at {x_mm}");
                // The section asked for alone, beside a loop that is not the airfoil's.
                let mut other = own.clone();
                other.at_mm.iter_mut().for_each(|p| p[0] += 200.0);
                let names = sides.names(*x_mm, &[other, own.clone()]);
                let is_first = if k.is_multiple_of(2) { first_leads } else { !first_leads };
                let own = Names { first_leads: is_first, suction_follows_leading: first_leads };
                assert_eq!(names, [None, Some(own)]);
            }
        }
    }

    #[test]
    fn beyond_the_heights_only_ends_near_the_edges_are_named() {
        let sides = Sides::along(&twisted(0.8)).unwrap();
        assert_eq!(sides.x_mm(), [0.0, 100.0]);
        let last = ends(HEIGHTS - 1, 1.2 * PI, [0.5, 0.6]);
        assert!(sides.names(101.0, std::slice::from_ref(&last))[0].is_some_and(|n| n.first_leads));
        let wider = ends(HEIGHTS - 1, 1.2 * PI + 1.0, [0.5, 0.6]);
        assert_eq!(sides.names(101.0, &[wider]), [None]);
    }

    #[test]
    fn round_sections_say_nothing() {
        let mut sections = twisted(0.8);
        for (_, e) in &mut sections[..9] {
            (e.bulge_mm2, e.radius_mm) = ([600.0, 600.0], [1.0, 100.0]);
        }
        let sides = Sides::along(&sections).unwrap();
        assert_eq!((sides.leading_edge_mm.len(), sides.x_mm()[0]), (HEIGHTS - 9, sections[9].0));
        assert!(Sides::along(&[]).is_none());
    }

    #[test]
    fn equally_blunt_edges_are_named_by_their_place() {
        let alike: Vec<(f64, SectionEnds)> = (0..4).map(|k| (k as f64, ends(k, 0.1, [0.6, 0.6]))).collect();
        let sides = Sides::along(&alike).unwrap();
        assert!(sides.leading_edge_mm.iter().zip(&sides.trailing_edge_mm).all(|(a, b)| a.y < b.y));
        assert_eq!(sides.mirrored().mirrored(), sides);
    }
}
