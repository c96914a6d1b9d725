//! Tables of blade sections to a lofted NURBS solid.
//!
//! In: points of sections, in files that say themselves what they hold (Tecplot zones, TurboGrid
//! curves, T-Blade3) or with a header in TOML ([`header`]). Out: two sides, blunt edges where the
//! points have sharp corners, and two caps, closed.
//!
//! The way: rows → blocks ([`columns`], [`direct`]) → closed chains, aligned ([`outline`]) → one
//! grid ([`grid`]) → surfaces through the grid ([`loft`]) → solid ([`solid`]).
//!
//! Guarantees: the greatest distance of a point of the table from the surface is measured and
//! noted; above the tolerance the table is refused. What lies between the points is the spline's:
//! how much that matters is measured by leaving every second point, and every second section, out.
//! Limits: one blade; sections in order from one end to the other; between 8 and [`MOST_POINTS`]
//! points a section.

pub mod columns;
pub mod direct;
pub mod grid;
pub mod header;
pub mod loft;
pub mod outline;
pub mod solid;
pub mod suspect;

#[cfg(test)]
mod tests;

use std::path::Path;

use super::faces::FaceModel;
use super::units::{self, UnitSource};
use crate::artifact::blade::Unit;
use crate::error::{Error, Result, Stage};
use crate::files;
use crate::geometry::{Point, Vector};
use crate::observe::Remark;

use columns::{Columns, PointBlock, Rows};
use direct::TableKind;
use header::{Header, Order};
use outline::TableOutline;

/// Greatest distance of a point from the surface, mm, if the header says nothing: a tenth of a
/// usual form tolerance.
pub const TOLERANCE_MM: f64 = 0.01;
/// Most points of a section.
pub const MOST_POINTS: usize = 5000;
/// Most points of a table: the search for points that belong together grows with these times those
/// of a section.
const MOST_TOTAL: usize = 200_000;
/// Most sections.
const MOST_SECTIONS: usize = 1000;
/// Greatest size of a data file, bytes.
const MOST_BYTES: u64 = 256 << 20;
/// A block whose ends are farther apart than this share of its size is a side, not a loop.
const OPEN: f64 = 0.2;
/// How the message about a section without size ends.
const POINT: &str = "is a single point";
/// An end section smaller than this share of the largest is a point or a line.
const COLLAPSED: f64 = 1e-3;

type Said<T> = std::result::Result<T, String>;

/// Reads a table: a header in TOML (beside the data or at its top), or a file that says itself what
/// it holds.
///
/// # Errors
/// `InputOutput` with file and line: what cannot be read, what is no blade, a surface too far from
/// the points.
pub fn read(path: &Path, bytes: &[u8], unit: Option<Unit>) -> Result<FaceModel> {
    let name = path.display().to_string();
    let text = String::from_utf8_lossy(bytes);
    let is_toml = path.extension().is_some_and(|e| e.eq_ignore_ascii_case("toml"));
    let (header, sources) = if is_toml {
        let header = header::parse(&text, &name)?;
        let files = header::files(path, &header.files)?;
        let sources = files.iter().map(|f| source(f)).collect::<Result<Vec<_>>>()?;
        (header, sources)
    } else if let Some((head, data)) = header::front_matter(&text) {
        // Lines are counted from the top of the file.
        let above = text.lines().count().saturating_sub(data.lines().count());
        let header = header::parse(head, &name)?;
        (header, vec![(short(path), format!("{}{data}", "\n".repeat(above)))])
    } else {
        (Header::default(), vec![(short(path), text.into_owned())])
    };
    let refuse = |m: String| Error::io(Stage::Model, format!("{name}: {m}")).advise(ADVICE);
    let raw = gather(&header, &sources).map_err(refuse)?;
    let mm = unit.map(Unit::mm).or(header.unit_mm).unwrap_or_else(|| header.unit.unwrap_or(Unit::Mm).mm());
    let mut notes = raw.notes;
    let outlines = outlines(&header, raw.blocks, &raw.columns, mm, &mut notes).map_err(refuse)?;
    shape(&name, &header, outlines, notes, (raw.format, unit_taken(&header, unit)))
}

/// Whether a TOML file is the header of a section table, rather than a job file.
pub fn is_header_file(path: &Path) -> bool {
    text_of(path, files::SHORT).is_ok_and(|text| header::is_header(&text))
}

/// The data files that a header names; none for other files and where they cannot be found, which
/// [`read`] says.
pub fn data_files(path: &Path) -> Vec<std::path::PathBuf> {
    if !is_header_file(path) {
        return Vec::new();
    }
    let text = text_of(path, files::SHORT).unwrap_or_default();
    header::parse(&text, "").and_then(|h| header::files(path, &h.files)).unwrap_or_default()
}

/// What to do with a table that cannot be read.
const ADVICE: &str = "a blade needs two sections or more, in order along the span; say what the columns mean in a header: a \
    NAME.toml beside the data with [sections], files, unit, columns (see the README); extrude = LENGTH there draws a single \
    flat profile out";

fn unit_taken(header: &Header, told: Option<Unit>) -> (Unit, String, UnitSource) {
    match (told, header.unit, header.unit_mm) {
        (Some(u), _, _) => (u, format!("{}, as told", units::name(u)), UnitSource::Told),
        (None, Some(u), _) => (u, format!("{}, as the header says", units::name(u)), UnitSource::Declared),
        (None, None, Some(mm)) => {
            let reason = format!("mm, converted: one unit of the table is {mm} mm, as the header says");
            (Unit::Mm, reason, UnitSource::Declared)
        }
        (None, None, None) => (Unit::Mm, "mm, since the table names no unit".to_owned(), UnitSource::Assumed),
    }
}

fn short(path: &Path) -> String {
    path.file_name().map_or_else(|| path.display().to_string(), |n| n.to_string_lossy().into_owned())
}

/// The text of a file without a byte-order mark.
fn text_of(path: &Path, limit: u64) -> std::io::Result<String> {
    let text = String::from_utf8_lossy(&files::read(path, limit)?).into_owned();
    Ok(text.strip_prefix('\u{feff}').map(str::to_owned).unwrap_or(text))
}

/// Name and text of a data file.
fn source(path: &Path) -> Result<(String, String)> {
    let text = text_of(path, MOST_BYTES)
        .map_err(|e| Error::io(Stage::Model, format!("{} cannot be read: {e}", path.display())).caused_by(e))?;
    Ok((short(path), text))
}

/// Blocks of all files.
struct Raw {
    blocks: Vec<Rows>,
    columns: Columns,
    format: String,
    notes: Vec<Remark>,
}

fn gather(header: &Header, sources: &[(String, String)]) -> Said<Raw> {
    let mut blocks: Vec<Rows> = Vec::new();
    let mut found: Option<(Columns, String)> = None;
    let mut notes = Vec::new();
    for (name, text) in sources {
        let kind = direct::detect(text.trim_start().as_bytes());
        let tecplot = kind == Some(TableKind::Tecplot);
        let (more, columns, format) = if header.columns.is_empty() || tecplot {
            let kind = kind.ok_or_else(|| format!("{name} holds no rows of numbers"))?;
            let table = direct::read(kind, text, name, header)?;
            notes.extend(table.notes);
            (table.blocks, table.columns, format!("sections, {}", kind.name()))
        } else {
            let has_heights = !header.heights.is_empty();
            let columns = match Columns::new(&header.columns, header.angle, has_heights) {
                Err(_) if header.extrude.is_some() => Columns::new(&header.columns, header.angle, true)?,
                other => other?,
            };
            let blocks = columns::blocks(text, name, header, columns.count())?;
            (blocks, columns, "sections, columns".to_owned())
        };
        blocks.extend(more);
        found.get_or_insert((columns, format));
    }
    let (columns, format) = found.ok_or("the header names no files")?;
    if blocks.is_empty() {
        return Err("there are no rows of numbers".into());
    }
    let total: usize = blocks.iter().map(|b| b.1.len()).sum();
    if total > MOST_TOTAL {
        return Err(format!("there are {total} points; up to {MOST_TOTAL} are read"));
    }
    if let Some(b) = blocks.iter().find(|b| b.1.len() > MOST_POINTS) {
        return Err(format!("the block from {} has {} points; up to {MOST_POINTS} are read", b.0, b.1.len()));
    }
    Ok(Raw { blocks, columns, format, notes })
}

/// Sections in mm, in the order of the table.
fn outlines(
    header: &Header,
    blocks: Vec<Rows>,
    columns: &Columns,
    mm: f64,
    notes: &mut Vec<Remark>,
) -> Said<Vec<TableOutline>> {
    let two = columns.sides() == 2;
    let points = |rows: &Rows, side: usize, height: f64| -> Vec<Point> {
        rows.1.iter().map(|r| Point::from(columns.point(r, side, height).coords * mm)).collect()
    };
    // Height 1 where there are heights, since a radius must not be 0.
    let flat: Vec<PointBlock> = blocks
        .iter()
        .map(|b| PointBlock {
            place: b.0.clone(),
            points: points(b, 0, 1.0),
            other: if two { points(b, 1, 1.0) } else { Vec::new() },
        })
        .collect();
    flat.iter().try_for_each(suspect::sound)?;
    let (blocks, flat) = if two { (blocks, flat) } else { split(blocks, flat) };
    let paired = !two && order(header, &flat)? == Order::Sides;
    let per_section = if paired { 2 } else { 1 };
    let sections = blocks.len() / per_section;
    if paired && blocks.len() % 2 == 1 {
        return Err(format!("{} blocks are sides, two a section, but their number is odd", blocks.len()));
    }
    if !header.heights.is_empty() && header.heights.len() != sections {
        return Err(format!("heights has {} values for {sections} sections", header.heights.len()));
    }
    if sections > MOST_SECTIONS {
        return Err(format!("{sections} sections; up to {MOST_SECTIONS} are read"));
    }
    let largest = flat.iter().map(|b| extent(&b.points)).fold(0.0, f64::max);
    let mut out = Vec::with_capacity(sections);
    for s in 0..sections {
        let height = header.heights.get(s).copied().unwrap_or(0.0);
        let block = &blocks[s * per_section];
        let first = points(block, 0, height);
        if first.iter().any(|p| p.coords.iter().any(|x| !x.is_finite())) {
            return Err(format!("the height of the section at {} makes no points", block.0));
        }
        let degenerate = extent(&first) <= 1e-6 * largest;
        let outline = match (two, paired) {
            _ if degenerate => Err(format!("the section at {} {POINT}", block.0)),
            (true, _) => TableOutline::from_sides(&block.0, first, points(block, 1, height)),
            (_, true) => TableOutline::from_sides(&block.0, first, points(&blocks[s * 2 + 1], 0, height)),
            _ => TableOutline::from_loop(&block.0, first),
        };
        out.push(outline);
    }
    let out = without_collapsed(out, notes)?;
    suspect::displaced(&out, notes)?;
    let mut out = extruded(header, out, mm)?;
    if out.len() < 2 {
        return Err("this is a single profile: one section makes no blade".into());
    }
    outline::align(&mut out)?;
    Ok(out)
}

/// Blocks that run along one side and then, with one jump of more than half their size, along the
/// other: two blocks each.
fn split(blocks: Vec<Rows>, flat: Vec<PointBlock>) -> (Vec<Rows>, Vec<PointBlock>) {
    let jump = |b: &PointBlock| {
        let far = 0.5 * extent(&b.points);
        let mut jumps = (1..b.points.len()).filter(|&k| (b.points[k] - b.points[k - 1]).norm() > far);
        let first = jumps.next();
        first.filter(|&k| jumps.next().is_none() && k > 2 && k + 2 < b.points.len())
    };
    let jumps: Option<Vec<usize>> = flat.iter().map(jump).collect();
    let Some(jumps) = jumps else { return (blocks, flat) };
    let mut out = (Vec::new(), Vec::new());
    for ((mut rows, mut block), k) in blocks.into_iter().zip(flat).zip(jumps) {
        let second = (rows.0.clone(), rows.1.split_off(k));
        let other = PointBlock { place: block.place.clone(), points: block.points.split_off(k), other: Vec::new() };
        out.0.extend([rows, second]);
        out.1.extend([block, other]);
    }
    out
}

fn extent(points: &[Point]) -> f64 {
    crate::geometry::Aabb::around(points).map_or(0.0, |b| b.diagonal_mm())
}

/// Loops or sides: as the header says, else by whether the ends of each block meet.
fn order(header: &Header, blocks: &[PointBlock]) -> Said<Order> {
    if let Some(order) = header.order {
        return Ok(order);
    }
    let is_open = |b: &PointBlock| match b.points[..] {
        [first, .., last] => (first - last).norm() > OPEN * extent(&b.points),
        _ => false,
    };
    let open = blocks.iter().filter(|b| is_open(b)).count();
    if open == 0 {
        return Ok(Order::Loop);
    }
    if open == blocks.len() && open % 2 == 0 {
        return Ok(Order::Sides);
    }
    let odd = blocks.iter().find(|b| is_open(b) != (2 * open > blocks.len())).unwrap_or(&blocks[0]);
    Err(format!(
        "{open} of {} blocks do not come back to their start, so they are neither loops nor pairs of sides (see {}); say \
         order = \"loop\" or \"sides\" in a header",
        blocks.len(),
        odd.place
    ))
}

/// Leaves out sections at the ends that have shrunk to a point or a line (a tip of no chord).
fn without_collapsed(sections: Vec<Said<TableOutline>>, notes: &mut Vec<Remark>) -> Said<Vec<TableOutline>> {
    let largest = sections.iter().flatten().map(|o| o.area().norm()).fold(0.0, f64::max);
    let collapsed = |o: &Said<TableOutline>| match o {
        Ok(o) => o.area().norm() < COLLAPSED * COLLAPSED * largest,
        Err(m) => m.ends_with(POINT),
    };
    let from = sections.iter().take_while(|o| collapsed(o)).count();
    let to = sections.len() - sections.iter().rev().take_while(|o| collapsed(o)).count();
    if from >= to {
        return sections.into_iter().collect();
    }
    for o in sections.iter().take(from).chain(sections.iter().skip(to)) {
        let reason = o.as_ref().map_or_else(String::clone, |o| format!("the section at {} encloses no area", o.place));
        notes.push(Remark::SectionLeftOut { reason });
    }
    sections.into_iter().take(to).skip(from).collect()
}

/// A single profile with a second one, moved along its normal.
fn extruded(header: &Header, mut outlines: Vec<TableOutline>, mm: f64) -> Said<Vec<TableOutline>> {
    let (Some(length), [only]) = (header.extrude, &outlines[..]) else {
        return match header.extrude {
            Some(_) => Err(format!("extrude draws out one profile, here are {} sections", outlines.len())),
            None => Ok(outlines),
        };
    };
    let area = only.area();
    let mut normal = area.try_normalize(0.0).ok_or("the profile encloses no area")?;
    if normal[normal.iamax()] < 0.0 {
        normal = -normal;
    }
    let shift: Vector = normal * (length * mm);
    let mut second = only.clone();
    second.points.iter_mut().chain(&mut second.table).for_each(|p| *p += shift);
    outlines.push(second);
    Ok(outlines)
}

/// The solid with its notes.
fn shape(
    name: &str,
    header: &Header,
    outlines: Vec<TableOutline>,
    mut notes: Vec<Remark>,
    (format, (unit, unit_reason, unit_source)): (String, (Unit, String, UnitSource)),
) -> Result<FaceModel> {
    let tolerance = header.tolerance_mm.unwrap_or(TOLERANCE_MM);
    let bad = |m: String| {
        Error::io(Stage::Model, format!("{name}: {m}"))
            .advise("check the order of the points and of the sections, and the unit; see the README on section tables")
    };
    let fitted = loft::fit(&outlines, tolerance).map_err(bad)?;
    let e = fitted.error;
    let at = |i: usize, j: usize| {
        outlines.get(i).map_or(String::new(), |o| format!("point {} of the section at {}", j + 1, o.place))
    };
    if !(e.greatest_mm <= tolerance) {
        return Err(Error::io(
            Stage::Model,
            format!(
                "{name}: the surface misses {} by {:.4} mm, the tolerance is {tolerance} mm",
                at(e.at.0, e.at.1),
                e.greatest_mm
            ),
        )
        .advise("look for a wrong point there, give more points where the section bends most, or raise tolerance_mm in the header"));
    }
    let grid = &fitted.loft.grid;
    notes.push(Remark::Lofted {
        sections: grid.rows.len(),
        by_number: fitted.by_number,
        around: grid.around(),
        sharp_edges: grid.anchors.iter().filter(|a| a.sharp).count(),
        greatest_mm: e.greatest_mm,
    });
    notes.extend(fitted.note.clone());
    let tests = [("point", fitted.loft.without_points()), ("section", fitted.loft.without_sections())];
    for (what, error) in tests.into_iter().filter_map(|(w, e)| Some((w, e?))) {
        let (of, greatest_mm, rms_mm) = (what.into(), error.greatest_mm, error.rms_mm);
        notes.push(Remark::LeftOutTest { of, greatest_mm, rms_mm });
    }
    let brep = solid::close(&fitted.loft).map_err(bad)?;
    for face in &brep.faces {
        face.surface.validate().map_err(|e| bad(e.message))?;
    }
    let stacking = outline::stacking(&outlines);
    Ok(FaceModel { brep, bodies: 1, format, unit, unit_reason, unit_source, notes, stacking })
}
