//! Sections brought to one parametrisation: a grid of points whose columns run along the span.
//!
//! Where all sections have as many points and share the round in like proportions, points of one
//! number belong together and the grid is the table itself. Otherwise each section becomes a spline
//! of its own, cut at its edges, and is sampled at shares of the length between them.

use super::outline::{TableOutline, steps};
use crate::geometry::Point;
use crate::geometry::nurbs::fit::{ControlRows, FitError, PeriodicRows, interpolate_rows};

/// Neighbouring steps of points that belong together grow or shrink from one section to the other
/// by no more than this.
const LIKE: f64 = 3.0;
/// A sharp edge this near to an end of the section, as a share of the perimeter, is of that end.
const NEAR: f64 = 0.08;
/// Fewest steps between the two ends of a section that is sampled.
const FEWEST_STEPS: usize = 12;

/// Where faces meet: a sharp edge, or the end of a section whose edge is round.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Anchor {
    /// Column.
    pub index: usize,
    /// The surface has an edge here.
    pub sharp: bool,
    /// Which end of the section, 0 or 1.
    pub end: usize,
}

/// Points of all sections, and what is where.
#[derive(Clone, Debug)]
pub struct Grid {
    /// Sections along the span, each once round.
    pub rows: Vec<Vec<Point>>,
    /// In order round; the first is at index 0, those of one end follow one another.
    pub anchors: Vec<Anchor>,
}

impl Grid {
    /// Columns.
    pub fn around(&self) -> usize {
        self.rows.first().map_or(0, Vec::len)
    }

    /// Columns of piece `k`, from its anchor to the next, both included; indices run on beyond the
    /// last column.
    pub fn piece(&self, k: usize) -> std::ops::RangeInclusive<usize> {
        let from = self.anchors[k].index;
        let to = self.anchors.get(k + 1).map_or(self.around(), |a| a.index);
        from..=to
    }

    /// Parameters round: mean shares of chord length; one more than columns.
    pub fn params_around(&self) -> Vec<f64> {
        let n = self.around();
        let mut share = vec![0.0; n];
        for row in &self.rows {
            let step = steps(row);
            let total: f64 = step.iter().sum();
            share.iter_mut().zip(&step).for_each(|(s, h)| *s += h / total);
        }
        cumulative(&share)
    }

    /// Parameters along the span: mean chord length; as many as sections.
    pub fn params_along(&self) -> Vec<f64> {
        let step: Vec<f64> =
            (self.rows.windows(2)).map(|w| w[0].iter().zip(&w[1]).map(|(p, q)| (q - p).norm()).sum::<f64>()).collect();
        cumulative(&step)
    }

    /// Only every second column between the anchors.
    pub fn thinned_around(&self) -> Grid {
        let mut keep = Vec::new();
        let mut anchors = Vec::new();
        for (k, a) in self.anchors.iter().enumerate() {
            anchors.push(Anchor { index: keep.len(), ..*a });
            let piece = self.piece(k);
            keep.extend((*piece.start()..*piece.end()).step_by(2));
        }
        Grid { rows: self.rows.iter().map(|r| keep.iter().map(|&j| r[j]).collect()).collect(), anchors }
    }

    /// Only every second section, and the last.
    pub fn thinned_along(&self) -> Grid {
        let last = self.rows.len().saturating_sub(1);
        let rows =
            self.rows.iter().enumerate().filter(|(i, _)| i % 2 == 0 || *i == last).map(|(_, r)| r.clone()).collect();
        Grid { rows, anchors: self.anchors.clone() }
    }
}

fn cumulative(steps: &[f64]) -> Vec<f64> {
    let total: f64 = steps.iter().sum();
    let mut sum = 0.0;
    let mut out = vec![0.0];
    for s in steps {
        sum += s;
        out.push(sum / total);
    }
    if let Some(last) = out.last_mut() {
        *last = 1.0;
    }
    out
}

/// The table itself as a grid, if points of one number belong together.
pub fn by_number(outlines: &[TableOutline]) -> Option<Grid> {
    let first = outlines.first()?;
    let n = first.points.len();
    if outlines.iter().any(|o| o.points.len() != n || o.ends != first.ends) || !alike(outlines) {
        return None;
    }
    // An edge is where most sections have one.
    let mut votes = vec![0; n];
    outlines.iter().flat_map(TableOutline::corners).for_each(|i| votes[i] += 1);
    let sharp: Vec<usize> = (0..n).filter(|&i| 2 * votes[i] > outlines.len()).collect();
    let ends = first.ends.unwrap_or_else(|| farthest_in_all(outlines));
    let share: Vec<f64> = {
        let grid = Grid { rows: outlines.iter().map(|o| o.points.clone()).collect(), anchors: Vec::new() };
        grid.params_around()
    };
    let (start, anchors) = anchors(&share, &sharp, ends)?;
    let rows = outlines
        .iter()
        .map(|o| {
            let mut row = o.points.clone();
            row.rotate_left(start);
            row
        })
        .collect();
    Some(Grid { rows, anchors })
}

/// Steps in like proportions, and no other start that fits far better.
fn alike(outlines: &[TableOutline]) -> bool {
    let shares: Vec<Vec<f64>> = outlines
        .iter()
        .map(|o| {
            let s = steps(&o.points);
            let total: f64 = s.iter().sum();
            s.into_iter().map(|h| h / total).collect()
        })
        .collect();
    let n = outlines[0].points.len();
    let mean: Vec<f64> = (0..n).map(|j| shares.iter().map(|s| s[j]).sum::<f64>() / shares.len() as f64).collect();
    let jump = |s: &[f64], j: usize| {
        let ratio = (s[(j + 1) % n] / mean[(j + 1) % n]) / (s[j] / mean[j]);
        ratio.max(1.0 / ratio)
    };
    if shares.iter().any(|s| (0..n).any(|j| jump(s, j) > LIKE)) {
        return false;
    }
    outlines.windows(2).all(|w| {
        let centred = |o: &TableOutline| {
            let c = o.centroid();
            o.points.iter().map(|p| p - c).collect::<Vec<_>>()
        };
        let (a, b) = (centred(&w[0]), centred(&w[1]));
        let cost = |shift: usize| (0..n).map(|j| (a[j] - b[(j + shift) % n]).norm_squared()).sum::<f64>();
        let here = cost(0);
        // A blade may twist by so much that a neighbour fits a little better; another start fits
        // far better.
        (1..n).all(|shift| cost(shift) > 0.5 * here || here == 0.0)
    })
}

/// The two columns that are farthest apart in all sections together.
fn farthest_in_all(outlines: &[TableOutline]) -> [usize; 2] {
    let n = outlines[0].points.len();
    let mut best = ([0, n / 2], -1.0);
    for i in 0..n {
        for j in i + 1..n {
            let d: f64 = outlines.iter().map(|o| (o.points[i] - o.points[j]).norm()).sum();
            if d > best.1 {
                best = ([i, j], d);
            }
        }
    }
    best.0
}

/// Anchors from sharp edges and ends, rotated so that those of end 0 come first, and the index that
/// becomes 0. `None` if edges of the two ends alternate round the section.
fn anchors(params: &[f64], sharp: &[usize], ends: [usize; 2]) -> Option<(usize, Vec<Anchor>)> {
    let n = params.len() - 1;
    let apart = |i: usize, j: usize| {
        let d = (params[i] - params[j]).abs();
        d.min(1.0 - d)
    };
    let mut all: Vec<Anchor> = sharp
        .iter()
        .map(|&index| Anchor { index, sharp: true, end: usize::from(apart(index, ends[1]) < apart(index, ends[0])) })
        .collect();
    for (end, &index) in ends.iter().enumerate() {
        if !sharp.iter().any(|&s| apart(s, index) < NEAR) {
            all.push(Anchor { index, sharp: false, end });
        }
    }
    all.sort_by_key(|a| a.index);
    let count = all.len();
    let first = (0..count).find(|&k| all[k].end == 0 && all[(k + count - 1) % count].end == 1)?;
    all.rotate_left(first);
    let changes = all.windows(2).filter(|w| w[0].end != w[1].end).count();
    let start = all[0].index;
    all.iter_mut().for_each(|a| a.index = (a.index + n - start) % n);
    (changes == 1).then_some((start, all))
}

/// A section as a spline, cut at its anchors.
struct SectionSpline {
    pieces: Vec<ControlRows>,
    anchors: Vec<Anchor>,
    /// Parameters of the section's points in each piece, as shares.
    shares: Vec<Vec<f64>>,
}

/// Sections sampled at shares of the length between edges; each step of the densest section is
/// divided into `parts`. Unless `sharp`, all edges are taken as round.
///
/// # Errors
/// A sentence: sections with different edges.
pub fn by_shape(outlines: &[TableOutline], parts: usize, sharp: bool) -> Result<Grid, String> {
    let mut outlines = outlines.to_vec();
    let mut before = None;
    let mut shapes = Vec::with_capacity(outlines.len());
    for o in &mut outlines {
        let mut ends = o.ends.unwrap_or_else(|| o.farthest());
        let chord = |o: &TableOutline, e: [usize; 2]| o.points[e[0]] - o.points[e[1]];
        if before.is_some_and(|b| chord(o, ends).dot(&b) < 0.0) {
            ends.reverse();
        }
        before = Some(chord(o, ends));
        shapes.push(shape(o, ends, sharp)?);
    }
    let kinds = |s: &SectionSpline| s.anchors.iter().map(|a| (a.sharp, a.end)).collect::<Vec<_>>();
    if let Some(k) = shapes.iter().position(|s| kinds(s) != kinds(&shapes[0])) {
        let count = |s: &SectionSpline| s.anchors.iter().filter(|a| a.sharp).count();
        return Err(format!(
            "the section at {} has {} sharp edges, that at {} has {}",
            outlines[k].place,
            count(&shapes[k]),
            outlines[0].place,
            count(&shapes[0])
        ));
    }
    let pieces = shapes[0].pieces.len();
    let mut rows = vec![Vec::new(); shapes.len()];
    let mut anchors = Vec::new();
    for k in 0..pieces {
        anchors.push(Anchor { index: rows[0].len(), ..shapes[0].anchors[k] });
        let densest = shapes.iter().map(|s| &s.shares[k]).max_by_key(|s| s.len()).cloned().unwrap_or_default();
        let across = shapes[0].anchors[k].end == shapes[0].anchors[(k + 1) % pieces].end;
        let shares = divided(&densest, parts, if across { 1 } else { FEWEST_STEPS });
        for (row, shape) in rows.iter_mut().zip(&shapes) {
            let curve = shape.pieces[k].curve(0).ok_or("a section has no curve")?;
            let [t0, t1] = curve.domain();
            row.extend(shares[..shares.len() - 1].iter().map(|s| curve.point(t0 + s * (t1 - t0))));
        }
    }
    Ok(Grid { rows, anchors })
}

/// Shares with each step divided; a piece of one step stays one unless `fewest` asks for more.
fn divided(shares: &[f64], parts: usize, fewest: usize) -> Vec<f64> {
    let steps = shares.len().saturating_sub(1).max(1);
    let parts = if steps == 1 && fewest == 1 { 1 } else { parts.max(fewest.div_ceil(steps)) };
    let mut out = vec![0.0];
    for w in shares.windows(2) {
        out.extend((1..=parts).map(|p| w[0] + (w[1] - w[0]) * p as f64 / parts as f64));
    }
    out
}

fn shape(o: &TableOutline, ends: [usize; 2], sharp: bool) -> Result<SectionSpline, String> {
    let grid = Grid { rows: vec![o.points.clone()], anchors: Vec::new() };
    let corners = if sharp { o.corners() } else { Vec::new() };
    let (start, anchors) = anchors(&grid.params_around(), &corners, ends)
        .ok_or_else(|| format!("{}: the edges of the section are in no order that makes a blade", o.place))?;
    let mut row = o.points.clone();
    row.rotate_left(start);
    let grid = Grid { rows: vec![row], anchors: anchors.clone() };
    let params = grid.params_around();
    let pieces =
        pieces(&grid, &params).map_err(|e| format!("{}: no spline passes through the section: {e}", o.place))?;
    let shares = (0..anchors.len())
        .map(|k| {
            let piece = grid.piece(k);
            let (t0, t1) = (params[*piece.start()], params[*piece.end()]);
            piece.map(|j| (params[j] - t0) / (t1 - t0)).collect()
        })
        .collect();
    Ok(SectionSpline { pieces, anchors, shares })
}

/// Control rows of the pieces between anchors; sections are the columns. Without sharp edges the
/// spline is C² all round, with them it ends at each.
///
/// # Errors
/// See [`FitError`].
pub fn pieces(grid: &Grid, params: &[f64]) -> Result<Vec<ControlRows>, FitError> {
    let (n, columns) = (grid.around(), grid.rows.len());
    let at = |j: usize| grid.rows.iter().map(move |r| r[j % n].to_homogeneous());
    let mut out = if grid.anchors.iter().all(|a| !a.sharp) {
        let points: Vec<_> = (0..n).flat_map(at).collect();
        let cuts: Vec<usize> = grid.anchors.iter().map(|a| a.index).collect();
        PeriodicRows::interpolate(&points, columns, params)?.pieces(&cuts)?
    } else {
        let param = |j: usize| params[j % n] + (j / n) as f64;
        let sharp: Vec<usize> = (0..grid.anchors.len()).filter(|&k| grid.anchors[k].sharp).collect();
        let count = grid.anchors.len();
        let mut out = vec![None; count];
        for (i, &from) in sharp.iter().enumerate() {
            // To the next sharp edge, cut at the round ends between.
            let to = sharp.get(i + 1).copied().unwrap_or(sharp[0] + count);
            let index = |k: usize| grid.anchors[k % count].index + n * (k / count);
            let span: Vec<usize> = (index(from)..=index(to)).collect();
            let points: Vec<_> = span.iter().flat_map(|&j| at(j)).collect();
            let t: Vec<f64> = span.iter().map(|&j| param(j)).collect();
            let mut rest = interpolate_rows(&points, columns, &t, 3.min(span.len() - 1))?;
            for k in from + 1..to {
                let (a, b) = rest.split(param(index(k)))?;
                out[(k - 1) % count] = Some(a);
                rest = b;
            }
            out[(to - 1) % count] = Some(rest);
        }
        out.into_iter().flatten().collect()
    };
    // Constants are interpolated to rounding only.
    out.iter_mut().flat_map(|p| &mut p.points).for_each(|p| p.w = 1.0);
    Ok(out)
}
