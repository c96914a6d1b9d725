//! One section as a closed chain of points: joining of sides, edges, direction and order along the
//! span.

use nalgebra::Matrix3;

use crate::geometry::{Point, Vector};
use crate::read::model::faces::Stacking;

/// Two ends of sides closer than this share of the steps beside them are one point.
const JOIN: f64 = 0.01;
/// Points closer than this share of the perimeter are the same.
const SAME: f64 = 1e-8;
/// A turn less than this is no sharp edge, rad.
const SHARP: f64 = 0.6;
/// A sharp edge turns more than its neighbours by this factor.
const ALONE: f64 = 3.0;
/// A section is flat where its points leave the plane by less than this share of its length.
const FLAT: f64 = 1e-3;
/// Fewest points of a section.
const FEWEST: usize = 8;

/// A section.
#[derive(Clone, Debug)]
pub struct TableOutline {
    /// File and line, for messages.
    pub place: String,
    /// All points as the table has them, mm.
    pub table: Vec<Point>,
    /// Once round, each point once, mm.
    pub points: Vec<Point>,
    /// First points of the two sides, if the table gave sides: the first is index 0.
    pub ends: Option<[usize; 2]>,
    /// Whether there is a gap before each of these points, the blunt edge.
    gaps: [bool; 2],
}

impl TableOutline {
    /// From points once round, closed by repetition of the first point or not.
    ///
    /// # Errors
    /// A sentence: too few points.
    pub fn from_loop(place: &str, table: Vec<Point>) -> Result<Self, String> {
        let mut points = without_repeats(&table);
        close(&mut points);
        TableOutline { place: place.to_owned(), table, points, ends: None, gaps: [false; 2] }.checked()
    }

    /// From two sides, each from one edge to the other in either sense. Where their ends meet they
    /// are joined; where they do not, the gap is a blunt edge.
    ///
    /// # Errors
    /// A sentence: too few points.
    pub fn from_sides(place: &str, a: Vec<Point>, b: Vec<Point>) -> Result<Self, String> {
        let table = [&a[..], &b[..]].concat();
        let (a, mut b) = (without_repeats(&a), without_repeats(&b));
        let [(Some(a0), Some(a1)), (Some(b0), Some(b1))] = [(a.first(), a.last()), (b.first(), b.last())] else {
            return Err(format!("{place}: a side has no points"));
        };
        // On from the end of one to the start of the other.
        if (a1 - b0).norm() + (b1 - a0).norm() > (a1 - b1).norm() + (b0 - a0).norm() {
            b.reverse();
        }
        let sides = a.len();
        let mut points = a;
        let gap = !join(&mut points, &b);
        let ends = [0, if gap { sides } else { sides - 1 }];
        let gaps = [!close(&mut points), gap];
        TableOutline { place: place.to_owned(), table, points, ends: Some(ends), gaps }.checked()
    }

    fn checked(self) -> Result<Self, String> {
        if self.points.len() < FEWEST {
            return Err(format!(
                "{}: a section has {} points, at least {FEWEST} are needed",
                self.place,
                self.points.len()
            ));
        }
        Ok(self)
    }

    /// Length round.
    pub fn perimeter(&self) -> f64 {
        steps(&self.points).iter().sum()
    }

    /// Middle of the chain, weighted by length.
    pub fn centroid(&self) -> Point {
        let n = self.points.len();
        let (mut sum, mut length) = (Vector::zeros(), 0.0);
        for (i, step) in steps(&self.points).iter().enumerate() {
            sum += (self.points[i].coords + self.points[(i + 1) % n].coords) * (0.5 * step);
            length += step;
        }
        Point::from(sum / length.max(f64::MIN_POSITIVE))
    }

    /// Area vector: the normal about which the chain turns, as long as the enclosed area.
    pub fn area(&self) -> Vector {
        let (n, c) = (self.points.len(), self.centroid());
        (0..n).map(|i| (self.points[i] - c).cross(&(self.points[(i + 1) % n] - c))).sum::<Vector>() * 0.5
    }

    /// Turns the direction; index 0 stays, or becomes the first point of the other side.
    pub fn reverse(&mut self) {
        let n = self.points.len();
        self.points[1..].reverse();
        if let Some([e0, e1]) = self.ends {
            let turned = |e: usize, gap: bool| (n - e + usize::from(gap)) % n;
            let ends = [turned(e0, self.gaps[0]), turned(e1, self.gaps[1])];
            self.ends = Some(ends);
            self.rotate(ends[0]);
        }
    }

    /// Takes the second end for the first.
    fn swap_ends(&mut self) {
        if let Some([_, e1]) = self.ends {
            self.rotate(e1);
            self.ends = self.ends.map(|[a, b]| [b, a]);
            self.gaps.reverse();
        }
    }

    /// Makes index `start` the first.
    pub fn rotate(&mut self, start: usize) {
        let n = self.points.len();
        self.points.rotate_left(start);
        self.ends = self.ends.map(|e| e.map(|i| (i + n - start) % n));
    }

    /// The two points farthest from one another.
    pub fn farthest(&self) -> [usize; 2] {
        let mut best = ([0, 0], -1.0);
        for (i, p) in self.points.iter().enumerate() {
            for (j, q) in self.points.iter().enumerate().skip(i + 1) {
                let d = (p - q).norm_squared();
                if d > best.1 {
                    best = ([i, j], d);
                }
            }
        }
        best.0
    }

    /// Indices of sharp edges: one or two points in a row where the chain turns by more than
    /// [`SHARP`] and far more than beside them. Three in a row are a round edge with few points.
    pub fn corners(&self) -> Vec<usize> {
        let n = self.points.len();
        let at = |i: usize| self.points[i % n];
        let turn: Vec<f64> = (0..n).map(|i| (at(i) - at(i + n - 1)).angle(&(at(i + 1) - at(i)))).collect();
        let length = steps(&self.points);
        let curvature = |i: usize| turn[i % n] / (0.5 * (length[i % n] + length[(i + n - 1) % n]));
        let sharp: Vec<bool> = turn.iter().map(|t| *t > SHARP).collect();
        let mut out = Vec::new();
        for i in 0..n {
            if !sharp[i] || sharp[(i + n - 1) % n] {
                continue;
            }
            let run = (0..n).take_while(|k| sharp[(i + k) % n]).count();
            if run > 2 {
                continue;
            }
            let beside = [i + n - 1, i + run];
            let stands_out = |k: usize| {
                beside
                    .iter()
                    .all(|&b| turn[(i + k) % n] > ALONE * turn[b % n] && curvature(i + k) > ALONE * curvature(b))
            };
            out.extend((0..run).filter(|&k| stands_out(k)).map(|k| (i + k) % n));
        }
        out.sort_unstable();
        out
    }
}

/// The middle of two ends that are one point, judged by the steps beside them.
fn met(before: &Point, last: &Point, first: &Point, second: &Point) -> Option<Point> {
    let step = (last - before).norm().min((second - first).norm());
    ((first - last).norm() <= JOIN * step).then(|| nalgebra::center(first, last))
}

/// Adds `b` to `a`; where the end of `a` is at the start of `b`, the two become their middle.
/// Whether they did.
fn join(a: &mut Vec<Point>, b: &[Point]) -> bool {
    let middle = match (&a[..], b) {
        ([.., before, last], [first, second, ..]) => met(before, last, first, second),
        _ => None,
    };
    if let Some(middle) = middle {
        a.pop();
        a.push(middle);
    }
    a.extend(&b[usize::from(middle.is_some())..]);
    middle.is_some()
}

/// Where the last point is at the first, the two become their middle. Whether they did.
fn close(points: &mut Vec<Point>) -> bool {
    let middle = match points[..] {
        [first, second, .., before, last] => met(&before, &last, &first, &second),
        _ => None,
    };
    if let Some(middle) = middle {
        points.pop();
        points[0] = middle;
    }
    middle.is_some()
}

/// The line through the middles of the sections (least squares), first to last, and the mean of
/// their normals. `None` where they have no line or no normal.
pub fn stacking(outlines: &[TableOutline]) -> Option<Stacking> {
    let middles: Vec<Vector> = outlines.iter().map(|o| o.centroid().coords).collect();
    let mean = middles.iter().sum::<Vector>() / middles.len().max(1) as f64;
    let spread = middles.iter().map(|m| (m - mean) * (m - mean).transpose()).sum::<Matrix3<f64>>();
    let eigen = spread.symmetric_eigen();
    let mut line: Vector = eigen.eigenvectors.column(eigen.eigenvalues.imax()).into_owned();
    let (first, last) = (outlines.first()?, outlines.last()?);
    if (last.centroid() - first.centroid()).dot(&line) < 0.0 {
        line = -line;
    }
    let normals: Vec<Vector> = outlines.iter().filter_map(|o| o.area().try_normalize(0.0)).collect();
    let mut normal = normals.iter().sum::<Vector>().try_normalize(0.0)?;
    let flat = |o: &TableOutline| {
        let heights = o.points.iter().map(|p| p.coords.dot(&normal));
        let (lo, hi) = heights.fold((f64::INFINITY, f64::NEG_INFINITY), |(a, b), h| (a.min(h), b.max(h)));
        hi - lo < FLAT * o.perimeter()
    };
    let parallel = outlines.iter().all(flat);
    if normal.dot(&line) < 0.0 {
        normal = -normal;
    }
    let growth = last.area().norm() / first.area().norm().max(f64::MIN_POSITIVE);
    let found = Stacking { line, normal, parallel, growth };
    (line.iter().chain(normal.iter()).all(|x| x.is_finite()) && eigen.eigenvalues.max() > 0.0).then_some(found)
}

/// Lengths from each point to the next, round.
pub fn steps(points: &[Point]) -> Vec<f64> {
    (0..points.len()).map(|i| (points[(i + 1) % points.len()] - points[i]).norm()).collect()
}

fn without_repeats(points: &[Point]) -> Vec<Point> {
    let total: f64 = points.windows(2).map(|w| (w[1] - w[0]).norm()).sum();
    let mut out: Vec<Point> = Vec::with_capacity(points.len());
    for p in points {
        if out.last().is_none_or(|q| (p - q).norm() > SAME * total) {
            out.push(*p);
        }
    }
    out
}

/// Gives all sections one direction (counter-clockwise seen against the span) and, where the table
/// gave sides, one start.
///
/// # Errors
/// A sentence: sections that coincide or go to and fro along the span.
pub fn align(outlines: &mut [TableOutline]) -> Result<(), String> {
    let centres: Vec<Point> = outlines.iter().map(TableOutline::centroid).collect();
    let size = outlines.iter().map(TableOutline::perimeter).fold(0.0, f64::max);
    for k in 1..outlines.len() {
        let step = centres[k] - centres[k - 1];
        if step.norm() < 1e-6 * size && same_place(&outlines[k], &outlines[k - 1], size) {
            return Err(format!(
                "the sections at {} and at {} lie in one place",
                outlines[k - 1].place,
                outlines[k].place
            ));
        }
        if k > 1 {
            let before = centres[k - 1] - centres[k - 2];
            if step.dot(&before) < -0.2 * step.norm() * before.norm() {
                return Err(format!(
                    "the section at {} lies back along the span: sections must be in order from one end to the other",
                    outlines[k].place
                ));
            }
        }
    }
    for k in 0..outlines.len() {
        let area = outlines[k].area();
        let along = if k == 0 { centres[1.min(outlines.len() - 1)] - centres[0] } else { outlines[k - 1].area() };
        if area.dot(&along) < 0.0 {
            outlines[k].reverse();
        }
        if let Some([_, e1]) = outlines[k].ends
            && k > 0
            && let Some([p0, p1]) = outlines[k - 1].ends
        {
            let before = outlines[k - 1].points[p0] - outlines[k - 1].points[p1];
            let here = outlines[k].points[0] - outlines[k].points[e1];
            if before.dot(&here) < 0.0 {
                outlines[k].swap_ends();
            }
        }
    }
    Ok(())
}

fn same_place(a: &TableOutline, b: &TableOutline, size: f64) -> bool {
    let corner = |o: &TableOutline| crate::geometry::Aabb::around(&o.points);
    match (corner(a), corner(b)) {
        (Some(a), Some(b)) => (a.min - b.min).norm() + (a.max - b.max).norm() < 1e-6 * size,
        _ => false,
    }
}

#[cfg(test)]
pub(super) mod tests {
    #![allow(clippy::unwrap_used)]
    use super::*;
    use std::f64::consts::{PI, TAU};

    /// Points round an ellipse of 20 by 4 mm, each once.
    pub(in crate::read::model::table) fn ellipse(n: usize) -> Vec<Point> {
        (0..n).map(|k| TAU * k as f64 / n as f64).map(|a| Point::new(10.0 * a.cos(), 2.0 * a.sin(), 0.0)).collect()
    }

    #[test]
    fn loops_closed_or_not_are_the_same() {
        let open = ellipse(40);
        let closed = [&open[..], &open[..1]].concat();
        let repeated = [&open[..3], &open[2..]].concat();
        for table in [open.clone(), closed, repeated] {
            assert_eq!(TableOutline::from_loop("t", table).unwrap().points, open);
        }
        assert!(TableOutline::from_loop("t", ellipse(7)).is_err());
        assert!(TableOutline::from_loop("t", vec![Point::origin(); 20]).is_err());
    }

    #[test]
    fn sides_in_every_direction_give_one_chain() {
        let upper: Vec<Point> =
            (0..=20).map(|k| PI * k as f64 / 20.0).map(|a| Point::new(a.cos(), a.sin(), 0.0)).collect();
        let lower: Vec<Point> = upper.iter().map(|p| Point::new(p.x, -p.y, 0.0)).collect();
        for (flip_a, flip_b) in [(false, false), (true, false), (false, true), (true, true)] {
            let (mut a, mut b) = (upper.clone(), lower.clone());
            if flip_a {
                a.reverse();
            }
            if flip_b {
                b.reverse();
            }
            let o = TableOutline::from_sides("t", a.clone(), b).unwrap();
            assert_eq!((o.points.len(), o.ends), (40, Some([0, 20])));
            assert!((o.points[20] - a[20]).norm() < 1e-15 && (o.points[0] - a[0]).norm() < 1e-15);
            assert!((o.perimeter() / TAU - 1.0).abs() < 0.01, "{}", o.perimeter());
        }
    }

    #[test]
    fn a_gap_between_sides_is_an_edge() {
        let side =
            |y: f64| -> Vec<Point> { (0..=10).map(|k| Point::new(f64::from(k), y * f64::from(k), 0.0)).collect() };
        let o = TableOutline::from_sides("t", side(0.05), side(-0.05)).unwrap();
        assert_eq!(o.points.len(), 21);
        assert_eq!(o.ends, Some([0, 11]));
        assert_eq!(o.corners(), [0, 10, 11]);
    }

    #[test]
    fn corners_are_sharp_edges_only() {
        assert!(TableOutline::from_loop("t", ellipse(60)).unwrap().corners().is_empty());
        // A round end with three points only.
        let mut few: Vec<Point> = (0..=12).map(|k| Point::new(f64::from(k), 0.0, 0.0)).collect();
        few.extend([Point::new(12.7, 0.5, 0.0), Point::new(12.0, 1.0, 0.0)]);
        few.extend((0..12).rev().map(|k| Point::new(f64::from(k), 1.0, 0.0)));
        let o = TableOutline::from_loop("t", few).unwrap();
        let n = o.points.len();
        assert_eq!(o.corners(), [0, n - 1], "the cut end has two edges, the round one none");
        // One sharp edge.
        let drop: Vec<Point> = (0..40)
            .map(|k| (f64::from(k) / 40.0) * TAU)
            .map(|a| Point::new(5.0 * a.cos(), a.sin() * (0.5 * a).sin(), 0.0))
            .collect();
        assert_eq!(TableOutline::from_loop("t", drop).unwrap().corners(), [0]);
    }

    #[test]
    fn alignment_turns_and_starts_alike() {
        let side = |up: f64, z: f64| -> Vec<Point> {
            (0..=20).map(|k| PI * f64::from(k) / 20.0).map(|a| Point::new(5.0 * a.cos(), up * a.sin(), z)).collect()
        };
        let mut all = Vec::new();
        for k in 0..4 {
            let (mut a, mut b) = (side(1.0, f64::from(k)), side(-1.0, f64::from(k)));
            if k & 1 == 1 {
                a.reverse();
            }
            if k & 2 == 2 {
                std::mem::swap(&mut a, &mut b);
            }
            all.push(TableOutline::from_sides("t", a, b).unwrap());
        }
        align(&mut all).unwrap();
        for o in &all[1..] {
            for (p, q) in o.points.iter().zip(&all[0].points) {
                assert!((p.xy() - q.xy()).norm() < 1e-12);
            }
            assert!(o.area().z > 0.0);
        }
        let mut back = vec![all[0].clone(), all[2].clone(), all[1].clone()];
        assert!(align(&mut back).unwrap_err().contains("in order"));
        let mut twice = vec![all[0].clone(), all[0].clone()];
        assert!(align(&mut twice).unwrap_err().contains("one place"));
    }
}
