//! Rows of numbers to points: columns by their names, blocks by what parts them.
//!
//! Cylindrical coordinates turn about the axis whose coordinate stands beside them: with `z`,
//! `x = r cos θ` and `y = r sin θ`; with `x` or `y` the three letters move on in turn.

use super::header::{Angle, Blocks, Header};
use crate::geometry::Point;

/// Points of one block in the file's unit. Tables that give both sides in one row have two lists.
#[derive(Clone, Debug, Default)]
pub struct PointBlock {
    /// File and first line, for messages.
    pub place: String,
    /// Points of the block; with columns for each side, of side 1.
    pub points: Vec<Point>,
    /// Points of side 2; empty where a row holds one point.
    pub other: Vec<Point>,
}

/// What a column is; a coordinate may be of both sides (`None`) or of one.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Role {
    X,
    Y,
    Z,
    R,
    Theta,
    RTheta,
}

/// The columns of a row, and the way from them to a point.
#[derive(Clone, Debug)]
pub struct Columns {
    roles: Vec<Option<(Role, Option<usize>)>>,
    sides: usize,
    angle: Angle,
    missing: Option<Role>,
    axis: Option<Role>,
}

impl Columns {
    /// From the names in the header.
    ///
    /// # Errors
    /// A sentence: a name that is not known, coordinates that do not make a point.
    pub fn new(names: &[String], angle: Angle, has_heights: bool) -> Result<Self, String> {
        let roles = names.iter().map(|n| role(n)).collect::<Result<Vec<_>, _>>()?;
        let sides = if roles.iter().flatten().any(|(_, side)| side.is_some()) { 2 } else { 1 };
        let mut columns = Columns { roles, sides, angle, missing: None, axis: None };
        for side in 0..sides {
            columns.complete(side, has_heights)?;
        }
        Ok(columns)
    }

    /// Finds the axis and the coordinate that heights stand for; refuses what is too little or too
    /// much.
    fn complete(&mut self, side: usize, has_heights: bool) -> Result<(), String> {
        let of_side: Vec<Role> =
            self.roles.iter().flatten().filter(|(_, s)| s.is_none_or(|s| s == side)).map(|(r, _)| *r).collect();
        let count = |r: Role| of_side.iter().filter(|x| **x == r).count();
        let all = [Role::X, Role::Y, Role::Z, Role::R, Role::Theta, Role::RTheta];
        if let Some(twice) = all.into_iter().find(|r| count(*r) > 1) {
            return Err(format!("columns name {} twice", name(twice)));
        }
        let straight: Vec<Role> = all[..3].iter().copied().filter(|r| count(*r) == 1).collect();
        let turning = count(Role::Theta) + count(Role::RTheta);
        let wanted = "they must be x, y, z, or one of these with r and theta or r*theta";
        if turning == 1 && straight.len() == 1 {
            self.axis = Some(straight[0]);
            self.missing = (count(Role::R) == 0).then_some(Role::R);
        } else if turning == 0 && count(Role::R) == 0 && straight.len() >= 2 {
            self.missing = all[..3].iter().copied().find(|r| count(*r) == 0);
        } else {
            return Err(format!("the columns do not make a point: {wanted}"));
        }
        match (self.missing, has_heights) {
            (Some(r), false) => Err(format!(
                "the columns lack {}: give it in heights, one for each section, or draw a single profile out with extrude",
                name(r)
            )),
            (None, true) => Err("heights is given, but the columns lack no coordinate".into()),
            _ => Ok(()),
        }
    }

    /// Columns in a row.
    pub fn count(&self) -> usize {
        self.roles.len()
    }

    /// Sides that a row gives, 1 or 2.
    pub fn sides(&self) -> usize {
        self.sides
    }

    /// The point of a row on one side, file units; `height` stands for the coordinate that is
    /// missing.
    pub fn point(&self, row: &[f64], side: usize, height: f64) -> Point {
        let get = |r: Role| {
            let at = self.roles.iter().position(|c| c.is_some_and(|(x, s)| x == r && s.is_none_or(|s| s == side)));
            if self.missing == Some(r) { Some(height) } else { at.and_then(|k| row.get(k).copied()) }
        };
        let number = |r: Role| get(r).unwrap_or(0.0);
        let Some(axis) = self.axis else { return Point::new(number(Role::X), number(Role::Y), number(Role::Z)) };
        let (a, r) = (number(axis), number(Role::R));
        let scale = if self.angle == Angle::Deg { std::f64::consts::PI / 180.0 } else { 1.0 };
        let theta = get(Role::Theta).map(|t| t * scale).unwrap_or_else(|| number(Role::RTheta) / r);
        let (across, up) = (r * theta.cos(), r * theta.sin());
        match axis {
            Role::X => Point::new(a, across, up),
            Role::Y => Point::new(up, a, across),
            _ => Point::new(across, up, a),
        }
    }
}

fn role(word: &str) -> Result<Option<(Role, Option<usize>)>, String> {
    let lower = word.trim().to_lowercase().replace(' ', "");
    if matches!(lower.as_str(), "skip" | "-" | "") {
        return Ok(None);
    }
    let (stem, side) = match lower.strip_suffix(['1', '2']) {
        Some(stem) => (stem, Some(usize::from(lower.ends_with('2')))),
        None => (lower.as_str(), None),
    };
    let role = match stem {
        "x" => Role::X,
        "y" => Role::Y,
        "z" => Role::Z,
        "r" => Role::R,
        "theta" | "θ" => Role::Theta,
        "r*theta" | "rtheta" | "rθ" => Role::RTheta,
        "thickness" | "thick" | "t" | "camber" => {
            return Err(format!(
                "the column \"{word}\" is that of a camber line with its thickness, which is not read: a section is needed as the points of its two \
                 sides, as in columns = [\"x\", \"r*theta1\", \"r*theta2\", \"r\"]"
            ));
        }
        _ => {
            return Err(format!(
                "the column \"{word}\" is not known: x, y, z, r, theta, r*theta, each with 1 or 2 for a side, and skip"
            ));
        }
    };
    Ok(Some((role, side)))
}

fn name(role: Role) -> &'static str {
    match role {
        Role::X => "x",
        Role::Y => "y",
        Role::Z => "z",
        Role::R => "r",
        Role::Theta => "theta",
        Role::RTheta => "r*theta",
    }
}

/// A line of a table.
#[derive(Debug, PartialEq)]
pub enum TableLine {
    /// Nothing.
    Blank,
    /// Not beginning with a number.
    Text,
    /// Numbers.
    Numbers(Vec<f64>),
    /// Beginning with a number, but holding this word.
    Damaged(String),
}

/// What a line holds. Numbers are parted by white space, commas and semicolons.
pub fn line(text: &str, decimal_comma: bool) -> TableLine {
    let text = text.trim();
    if text.is_empty() {
        return TableLine::Blank;
    }
    let text = text.trim_end_matches([',', ';']);
    let separator = if decimal_comma || text.contains(';') { ';' } else { ',' };
    let mut numbers = Vec::new();
    for cell in text.split(separator) {
        if cell.trim().is_empty() {
            return if numbers.is_empty() { TableLine::Text } else { TableLine::Damaged("an empty cell".into()) };
        }
        for word in cell.split_whitespace() {
            match number(word, decimal_comma) {
                Some(x) => numbers.push(x),
                None if numbers.is_empty() => return TableLine::Text,
                None => return TableLine::Damaged(format!("\"{}\"", word.chars().take(30).collect::<String>())),
            }
        }
    }
    if numbers.is_empty() { TableLine::Text } else { TableLine::Numbers(numbers) }
}

/// A number, also with Fortran's `D` for the exponent.
fn number(word: &str, decimal_comma: bool) -> Option<f64> {
    if !word.starts_with(|c: char| c.is_ascii_digit() || matches!(c, '+' | '-' | '.' | ',')) {
        return None;
    }
    let plain = word.replace(['d', 'D'], "e");
    let plain = if decimal_comma { plain.replace(',', ".") } else { plain };
    plain.parse().ok().filter(|x: &f64| x.is_finite())
}

/// Rows of one block with its place.
pub type Rows = (String, Vec<Vec<f64>>);

/// The blocks of a file.
///
/// # Errors
/// A sentence with the line.
pub fn blocks(text: &str, file: &str, header: &Header, columns: usize) -> Result<Vec<Rows>, String> {
    let mut out: Vec<Rows> = Vec::new();
    let mut open = false;
    for (k, raw) in text.lines().enumerate().skip(header.skip_lines) {
        let place = || format!("{file}, line {}", k + 1);
        let ends =
            |by: Blocks| header.points_per_block.is_none() && (header.blocks == by || header.blocks == Blocks::Any);
        let row = match line(raw, header.decimal_comma) {
            TableLine::Blank => {
                open &= !ends(Blocks::BlankLine);
                continue;
            }
            TableLine::Text => {
                open &= !ends(Blocks::TextLine);
                continue;
            }
            TableLine::Damaged(word) => return Err(format!("{}: {word} is not a number", place())),
            TableLine::Numbers(row) => row,
        };
        if row.len() < columns && row.iter().all(|x| x.fract() == 0.0 && *x >= 0.0) {
            // A count of points before them.
            open &= !ends(Blocks::TextLine);
            continue;
        }
        if row.len() != columns {
            return Err(format!(
                "{}: {} numbers where the columns are {columns} (name a column \"skip\" to pass it over)",
                place(),
                row.len()
            ));
        }
        let full = |rows: &Rows| header.points_per_block.is_some_and(|n| rows.1.len() >= n);
        if !open || out.last().is_none_or(full) {
            out.push((place(), Vec::new()));
            open = true;
        }
        if let Some(block) = out.last_mut() {
            block.1.push(row);
        }
    }
    match (header.points_per_block, out.last()) {
        (Some(n), Some((place, rows))) if rows.len() != n => {
            Err(format!("the last block, from {place}, has {} rows where points_per_block is {n}", rows.len()))
        }
        _ => Ok(out),
    }
}

/// Number of blocks of rows, whatever their columns are, and where there are some the first two
/// rows of different length: line and count.
pub fn count_blocks(text: &str) -> (usize, Option<[(usize, usize); 2]>) {
    let width = |l: &str| match line(l, false) {
        TableLine::Numbers(row) if row.len() > 1 => row.len(),
        _ => 0,
    };
    let widths: Vec<usize> = text.lines().map(width).collect();
    let most = widths.iter().copied().max().unwrap_or(0);
    // Counts of points, in rows shorter than those of the points, part blocks.
    let is_count =
        |l: &str| matches!(line(l, false), TableLine::Numbers(r) if r.iter().all(|x| x.fract() == 0.0 && *x > 0.0));
    let counts = text.lines().zip(&widths).map(|(l, w)| *w < most && is_count(l)).collect::<Vec<_>>();
    let widths: Vec<usize> = widths.into_iter().zip(counts).map(|(w, count)| if count { 0 } else { w }).collect();
    let starts = widths.iter().enumerate().filter(|(k, w)| **w > 0 && (*k == 0 || widths[k - 1] == 0)).count();
    let mut rows = widths.iter().enumerate().filter(|(_, w)| **w > 0).map(|(k, w)| (k + 1, *w));
    let uneven = rows.next().and_then(|first| rows.find(|r| r.1 != first.1).map(|other| [first, other]));
    (starts, uneven)
}

/// The last three numbers of each row as points, whatever they mean: to see whether they are in
/// order.
pub fn points(text: &str) -> Vec<Point> {
    let point = |l: &str| match line(l, false) {
        TableLine::Numbers(row) if row.len() > 1 => {
            let at = |k: usize| row.get(row.len().saturating_sub(3) + k).copied().unwrap_or(0.0);
            Some(Point::new(at(0), at(1), at(2)))
        }
        _ => None,
    };
    text.lines().filter_map(point).collect()
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used)]
    use super::*;

    fn columns(names: &[&str], angle: Angle, heights: bool) -> Result<Columns, String> {
        Columns::new(&names.iter().map(|n| (*n).to_owned()).collect::<Vec<_>>(), angle, heights)
    }

    #[test]
    fn rows_of_different_length_are_told_with_their_lines() {
        assert_eq!(count_blocks("1 2 3\n4 5 6\n\ntext\n7 8 9\n"), (2, None));
        assert_eq!(count_blocks("# head\n1 2 3.5\n\n4\n5 6.5\n7 8 9 10\n"), (2, Some([(2, 3), (5, 2)])));
        assert_eq!(count_blocks("none"), (0, None));
        // Counts before the points of each section are no rows of other length.
        assert_eq!(count_blocks("3 2\n0.5 1.5 2.5 9\n1.5 1 2 9\n3 1\n2.5 1 2 9\n"), (2, None));
    }

    #[test]
    fn points_from_every_kind_of_column() {
        let near = |a: Point, b: [f64; 3]| assert!((a - Point::from(b)).norm() < 1e-12, "{a} {b:?}");
        let c = columns(&["skip", "z", "x", "y"], Angle::Rad, false).unwrap();
        near(c.point(&[7.0, 3.0, 1.0, 2.0], 0, 0.0), [1.0, 2.0, 3.0]);
        let c = columns(&["r", "theta", "z"], Angle::Deg, false).unwrap();
        near(c.point(&[2.0, 90.0, 5.0], 0, 0.0), [0.0, 2.0, 5.0]);
        let c = columns(&["x", "r*theta", "r"], Angle::Rad, false).unwrap();
        near(c.point(&[5.0, std::f64::consts::PI, 2.0], 0, 0.0), [5.0, 0.0, 2.0]);
        let c = columns(&["y", "theta", "r"], Angle::Rad, false).unwrap();
        near(c.point(&[5.0, 0.0, 2.0], 0, 0.0), [0.0, 5.0, 2.0]);
        // Both sides in a row.
        let c = columns(&["z", "r", "theta1", "theta2"], Angle::Deg, false).unwrap();
        assert_eq!(c.sides(), 2);
        near(c.point(&[1.0, 2.0, 0.0, 90.0], 0, 0.0), [2.0, 0.0, 1.0]);
        near(c.point(&[1.0, 2.0, 0.0, 90.0], 1, 0.0), [0.0, 2.0, 1.0]);
        // Heights stand for what is missing.
        let c = columns(&["x", "y1", "y2"], Angle::Rad, true).unwrap();
        near(c.point(&[1.0, 2.0, 3.0], 1, 9.0), [1.0, 3.0, 9.0]);
        let c = columns(&["x", "theta"], Angle::Deg, true).unwrap();
        near(c.point(&[1.0, 90.0], 0, 4.0), [1.0, 0.0, 4.0]);
    }

    #[test]
    fn columns_that_make_no_point_are_named() {
        for (names, heights, words) in [
            (&["x", "y", "q"][..], false, "\"q\" is not known"),
            (&["x", "r*theta", "thickness", "r"], false, "a camber line with its thickness, which is not read"),
            (&["x", "y"], false, "lack z"),
            (&["x", "y", "z"], true, "lack no coordinate"),
            (&["x", "y", "y"], false, "y twice"),
            (&["x", "r"], false, "do not make a point"),
            (&["x", "y", "theta"], false, "do not make a point"),
            (&["x", "y1", "z"], false, "lack y"),
        ] {
            let e = columns(names, Angle::Rad, heights).unwrap_err();
            assert!(e.contains(words), "{words} is not in {e}");
        }
    }

    #[test]
    fn lines() {
        assert_eq!(line("  1 2.5e1 -3D-1", false), TableLine::Numbers(vec![1.0, 25.0, -0.3]));
        assert_eq!(line("1,2 ,3,", false), TableLine::Numbers(vec![1.0, 2.0, 3.0]));
        assert_eq!(line("1;2;3", false), TableLine::Numbers(vec![1.0, 2.0, 3.0]));
        assert_eq!(line("1,5; 2 ; 3,25", true), TableLine::Numbers(vec![1.5, 2.0, 3.25]));
        assert_eq!(line("1,5 2,5", true), TableLine::Numbers(vec![1.5, 2.5]));
        assert_eq!(line("x,y,z", false), TableLine::Text);
        assert_eq!(line("# 1 2 3", false), TableLine::Text);
        assert_eq!(line("nan 1 2", false), TableLine::Text);
        assert_eq!(line(" \t", false), TableLine::Blank);
        assert!(matches!(line("1 2 three", false), TableLine::Damaged(w) if w.contains("three")));
        assert!(matches!(line("1,,3", false), TableLine::Damaged(_)));
        assert!(matches!(line("1 nan 3", false), TableLine::Damaged(_)));
    }

    #[test]
    fn blocks_by_what_parts_them() {
        let text = "title\n2 9\n0 0 1\n1 0 1\n\n0 0 2\n1 0 2\nsection 3\n0 0 3\n1 0 3\n";
        let lengths = |h: &Header| {
            let found = blocks(text, "t", h, 3).unwrap();
            found.iter().map(|b| b.1.len()).collect::<Vec<_>>()
        };
        let with = |b: Blocks| Header { blocks: b, ..Header::default() };
        assert_eq!(lengths(&Header::default()), [2, 2, 2]);
        assert_eq!(lengths(&with(Blocks::BlankLine)), [2, 4]);
        assert_eq!(lengths(&with(Blocks::TextLine)), [4, 2]);
        assert_eq!(lengths(&with(Blocks::File)), [6]);
        assert_eq!(lengths(&Header { points_per_block: Some(3), ..Header::default() }), [3, 3]);
        assert_eq!(lengths(&Header { skip_lines: 4, ..Header::default() }), [2, 2]);
        let e = blocks(text, "t", &Header { points_per_block: Some(4), ..Header::default() }, 3).unwrap_err();
        assert!(e.contains("has 2 rows"), "{e}");
        for (bad, words) in
            [("0 0 1\n1 0\n", "line 2"), ("0 0.5\n", "2 numbers"), ("0 0 1 7\n", "4 numbers"), ("0 0 x\n", "\"x\"")]
        {
            if bad == "0 0 1\n1 0\n" {
                // Whole numbers, fewer than columns, are a count.
                assert_eq!(blocks(bad, "t", &Header::default(), 3).unwrap().len(), 1);
                continue;
            }
            let e = blocks(bad, "t", &Header::default(), 3).unwrap_err();
            assert!(e.contains(words), "{e}");
        }
    }
}
