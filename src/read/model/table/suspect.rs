//! Points that are hardly meant: in no order, or one displaced.

use super::columns::PointBlock;
use super::outline::TableOutline;
use crate::geometry::Point;
use crate::observe::{Remark, standing_out};

/// Points whose chain is longer than this many times their size, and each step longer than this
/// share of it, are in no order.
const UNORDERED: (f64, f64) = (8.0, 0.1);
/// A point stands out where the chain turns by this much at it and turns back beside it, rad.
const STANDS_OUT: f64 = 0.35;
/// By this much it is no shape any more, rad.
const SPIKE: f64 = 1.2;

/// A point of a section that stands out of the chain.
#[derive(Clone, Debug, PartialEq)]
pub struct StandingOut {
    /// Its number in the block, from 1.
    pub number: usize,
    /// Where it is, mm.
    pub at: Point,
    /// How far it is off the middle of its neighbours, mm.
    pub off_mm: f64,
    /// So far that the chain turns back at it: no blade has that shape.
    pub spike: bool,
}

impl TableOutline {
    /// The point that stands out the most; `None` where none does. At an edge the chain turns and
    /// goes on in a new direction; at a point that was displaced it turns away before, back at it,
    /// and away again behind, to where it was going.
    pub fn standing_out(&self) -> Option<StandingOut> {
        let n = self.points.len();
        let normal = self.area().try_normalize(0.0)?;
        let at = |i: usize| self.points[i % n];
        let turn = |i: usize| {
            let (a, b) = (at(i) - at(i + n - 1), at(i + 1) - at(i));
            a.angle(&b).copysign(a.cross(&b).dot(&normal))
        };
        let turns: Vec<f64> = (0..n).map(turn).collect();
        let displaced = |i: &usize| {
            let [before, here, after] = [n - 1, n, n + 1].map(|k| turns[(i + k) % n]);
            let back = |t: f64| t * here < 0.0 && t.abs() > 0.25 * here.abs();
            here.abs() > STANDS_OUT && back(before) && back(after) && (before + here + after).abs() < 0.5 * here.abs()
        };
        let found = (0..n).filter(displaced).max_by(|a, b| turns[*a].abs().total_cmp(&turns[*b].abs()))?;
        let p = self.points[found];
        let number = self.table.iter().position(|q| *q == p).unwrap_or(found) + 1;
        let off_mm = (p - nalgebra::center(&at(found + n - 1), &at(found + 1))).norm();
        Some(StandingOut { number, at: p, off_mm, spike: turns[found].abs() > SPIKE })
    }
}

/// Looks at the points of a block, whatever their height: all are numbers, and in order.
///
/// # Errors
/// What is wrong.
pub fn sound(b: &PointBlock) -> Result<(), String> {
    if b.points.iter().chain(&b.other).any(|p| p.coords.iter().any(|x| !x.is_finite())) {
        return Err(format!(
            "the block from {} has a point that is no number (r*theta with r = 0, or a number too large)",
            b.place
        ));
    }
    if unordered(&b.points) || unordered(&b.other) {
        return Err(format!(
            "the {} points from {} are in no order, from each to the next it goes to and fro: a section is written once round, or one side after the other",
            b.points.len(),
            b.place
        ));
    }
    Ok(())
}

/// Looks for displaced points in all sections: one that is hardly right is noted.
///
/// # Errors
/// The first with which a section has no shape of a blade.
pub fn displaced(sections: &[TableOutline], notes: &mut Vec<Remark>) -> Result<(), String> {
    for (place, found) in sections.iter().filter_map(|o| Some((&o.place, o.standing_out()?))) {
        let StandingOut { number, at, off_mm, spike } = found;
        if spike {
            return Err(format!("{}: correct it or leave it out", standing_out(place, number, &at.into(), off_mm)));
        }
        notes.push(Remark::PointStandsOut { section: place.clone(), number, at_mm: at.into(), off_mm });
    }
    Ok(())
}

/// Whether points are in no order: the chain through them goes to and fro.
pub fn unordered(points: &[Point]) -> bool {
    let size = crate::geometry::Aabb::around(points).map_or(0.0, |b| b.diagonal_mm());
    let length: f64 = points.windows(2).map(|w| (w[1] - w[0]).norm()).sum();
    length > UNORDERED.0 * size && length > UNORDERED.1 * size * points.len() as f64
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used)]
    use super::super::outline::tests::ellipse;
    use super::*;
    use std::f64::consts::TAU;

    #[test]
    fn a_displaced_point_stands_out_and_an_edge_does_not() {
        let good = ellipse(60);
        assert_eq!(TableOutline::from_loop("t", good.clone()).unwrap().standing_out(), None);
        for (out, spike) in [(0.4, false), (3.0, true), (-1.5, true)] {
            let mut bad = good.clone();
            bad[13].y += out;
            let found = TableOutline::from_loop("t", bad.clone()).unwrap().standing_out().unwrap();
            assert_eq!((found.number, found.at, found.spike), (14, bad[13], spike), "{out}");
            assert!((found.off_mm - out.abs()).abs() < 0.05, "{}", found.off_mm);
        }
        // Blunt and sharp edges, a hollow side.
        let side =
            |y: f64| -> Vec<Point> { (0..=10).map(|k| Point::new(f64::from(k), y * f64::from(k), 0.0)).collect() };
        assert_eq!(TableOutline::from_sides("t", side(0.05), side(-0.05)).unwrap().standing_out(), None);
        let hollow: Vec<Point> = (0..40)
            .map(|k| (f64::from(k) / 40.0) * TAU)
            .map(|a| Point::new(5.0 * a.cos(), a.sin() * (0.5 * a).sin() - 0.3 * (2.0 * a).cos(), 0.0))
            .collect();
        assert_eq!(TableOutline::from_loop("t", hollow).unwrap().standing_out(), None);
    }

    #[test]
    fn points_in_no_order_are_known() {
        let good = ellipse(60);
        assert!(!unordered(&good) && !unordered(&ellipse(9)));
        // 23 has no divisor in common with 60: the same points, each once.
        let mixed: Vec<Point> = (0..60).map(|k| good[23 * k % 60]).collect();
        assert!(unordered(&mixed));
        // Several sections in one block are long, but their steps are short.
        let many: Vec<Point> =
            (0..20).flat_map(|s| good.iter().map(move |p| Point::new(p.x, p.y, 3.0 * f64::from(s)))).collect();
        assert!(!unordered(&many));
    }
}
