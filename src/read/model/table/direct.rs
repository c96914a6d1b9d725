//! Tables that say themselves what they are: Tecplot zones, TurboGrid curves, T-Blade3 sections.

use super::columns::{self, Columns, Rows, TableLine};
use super::header::{Angle, Blocks, Header};
use super::suspect;
use crate::observe::Remark;

/// What a text is, by its content.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum TableKind {
    /// `VARIABLES`, `ZONE`, points.
    Tecplot,
    /// Sections of three columns, each below a line that begins with `#`.
    TurboGrid,
    /// Two counts, points of a section and sections; then three columns.
    TBlade3,
    /// Rows of numbers of which nothing says what they are.
    Numbers,
}

impl TableKind {
    /// As people call it.
    pub fn name(self) -> &'static str {
        match self {
            TableKind::Tecplot => "Tecplot zones",
            TableKind::TurboGrid => "TurboGrid curves",
            TableKind::TBlade3 => "T-Blade3",
            TableKind::Numbers => "rows of numbers",
        }
    }
}

/// Blocks of a file with the columns to read them by.
pub struct PointTable {
    /// The blocks.
    pub blocks: Vec<Rows>,
    /// Their columns.
    pub columns: Columns,
    /// What the user should know.
    pub notes: Vec<Remark>,
}

/// Lines that detection looks at.
const LOOK: usize = 400;

/// Tells a table by its first lines; `None`: not a table.
pub fn detect(bytes: &[u8]) -> Option<TableKind> {
    let head = &bytes[..bytes.len().min(1 << 16)];
    if head.contains(&0) {
        return None;
    }
    let text = String::from_utf8_lossy(head);
    let lines: Vec<&str> = text.lines().map(str::trim).filter(|l| !l.is_empty()).take(LOOK).collect();
    if lines.iter().find(|l| !l.starts_with('#')).is_some_and(|l| keyword(l).is_some()) {
        return Some(TableKind::Tecplot);
    }
    if let [counts, first, ..] = lines[..]
        && let (TableLine::Numbers(n), TableLine::Numbers(row)) =
            (columns::line(counts, false), columns::line(first, false))
        && n.len() == 2
        && row.len() == 3
        && n.iter().all(|x| x.fract() == 0.0 && *x >= 1.0)
    {
        return Some(TableKind::TBlade3);
    }
    // A damaged row is still a row: its reader says where it is.
    let width = |l: &str| match columns::line(curve_row(l), false) {
        TableLine::Numbers(row) => row.len(),
        TableLine::Damaged(_) => 2,
        _ => 0,
    };
    let rows = lines.iter().filter(|l| width(l) >= 2).count();
    // The 64 KiB may end within the first section, so one header at the very top is enough.
    if lines.first().is_some_and(|l| l.starts_with('#')) && rows > 3 {
        let headers = text.lines().filter(|l| l.trim_start().starts_with('#')).count();
        let three = lines.iter().filter(|l| width(l) == 3).count();
        let others = lines.iter().filter(|l| !l.starts_with('#')).count();
        if 10 * three >= 9 * others && (headers > 1 || bytes.len() > head.len()) {
            return Some(TableKind::TurboGrid);
        }
    }
    (rows > 3 && 10 * rows >= 6 * lines.len()).then_some(TableKind::Numbers)
}

/// A row of a TurboGrid curve without the marks of leading and trailing edge (`le1`, `te1`) that
/// may stand at its end.
fn curve_row(line: &str) -> &str {
    let mut end = line.trim_end();
    while let Some((before, word)) = end.rsplit_once(char::is_whitespace) {
        let lower = word.to_ascii_lowercase();
        if !(lower.starts_with("le") || lower.starts_with("te")) {
            break;
        }
        end = before.trim_end();
    }
    end
}

/// Reads a table of a kind that says itself what it is.
///
/// # Errors
/// A sentence with file and line.
pub fn read(kind: TableKind, text: &str, file: &str, header: &Header) -> Result<PointTable, String> {
    let xyz = || Columns::new(&["x", "y", "z"].map(String::from), Angle::Rad, false);
    match kind {
        TableKind::Tecplot => tecplot(text, file, header),
        TableKind::TurboGrid => {
            let text: Vec<&str> = text.lines().map(curve_row).collect();
            let header = Header { blocks: Blocks::TextLine, ..header.clone() };
            Ok(PointTable {
                blocks: columns::blocks(&text.join("\n"), file, &header, 3)?,
                columns: xyz()?,
                notes: Vec::new(),
            })
        }
        TableKind::TBlade3 => {
            let first = text.lines().position(|l| !l.trim().is_empty()).unwrap_or(0);
            let TableLine::Numbers(counts) = columns::line(text.lines().nth(first).unwrap_or(""), false) else {
                return Err(format!("{file}: the counts of points and sections are missing"));
            };
            let (points, sections) = match counts[..] {
                [p, s] if p >= 1.0 && s >= 1.0 => (p as usize, s as usize),
                _ => return Err(format!("{file}: the counts of points and sections are missing")),
            };
            let header = Header { skip_lines: first + 1, points_per_block: Some(points), ..header.clone() };
            let blocks = columns::blocks(text, file, &header, 3)?;
            if blocks.len() != sections {
                return Err(format!(
                    "{file} promises {sections} sections of {points} points, {} are there",
                    blocks.len()
                ));
            }
            Ok(PointTable { blocks, columns: xyz()?, notes: Vec::new() })
        }
        TableKind::Numbers => Err(match columns::count_blocks(text) {
            (_, Some([(l, n), (k, m)])) => {
                format!(
                    "it holds rows of different length ({n} numbers in line {l}, {m} in line {k}), and nothing says what they mean"
                )
            }
            (0 | 1, _) if suspect::unordered(&columns::points(text)) => {
                "its points are in no order, from each to the next they go to and fro: sections are written once round, one after the other".to_owned()
            }
            (0 | 1, _) => {
                "it is a single profile: one block of points, and nothing says where along the span it lies".to_owned()
            }
            (n, _) => format!("it holds {n} blocks of numbers, and nothing says what its columns mean"),
        }),
    }
}

/// The keyword with which a line of Tecplot's begins.
fn keyword(line: &str) -> Option<&'static str> {
    let lower = line.to_ascii_lowercase();
    ["title", "variables", "zone"].into_iter().find(|k| {
        lower
            .strip_prefix(k)
            .is_some_and(|rest| rest.is_empty() || rest.starts_with(|c: char| c == '=' || c.is_whitespace()))
    })
}

/// One zone as it stands.
#[derive(Debug, Default)]
struct Zone {
    place: String,
    keys: Vec<(String, String)>,
    values: Vec<f64>,
    first_row: usize,
    ended: bool,
}

impl Zone {
    fn key(&self, names: &[&str]) -> Option<&str> {
        self.keys.iter().find(|(k, _)| names.contains(&k.as_str())).map(|(_, v)| v.as_str())
    }

    fn title(&self) -> &str {
        self.key(&["t"]).unwrap_or("")
    }

    fn count(&self, name: &str) -> Result<Option<usize>, String> {
        let Some(text) = self.key(&[name]) else { return Ok(None) };
        text.parse().map(Some).map_err(|_| format!("{}: {name} = {text} is not a count", self.place))
    }

    /// Sections of the zone: the lines along I.
    fn blocks(&self, variables: usize) -> Result<Vec<Rows>, String> {
        let kind = self.key(&["f", "datapacking", "zonetype"]).unwrap_or("").to_ascii_lowercase();
        if kind.starts_with("fe") || self.key(&["et"]).is_some() {
            return Err(format!("{}: a zone of finite elements is not a table of sections", self.place));
        }
        let wide = if variables > 0 { variables } else { self.first_row.max(1) };
        let total = self.values.len() / wide;
        let (i, j, k) =
            (self.count("i")?.unwrap_or(total), self.count("j")?.unwrap_or(1), self.count("k")?.unwrap_or(1));
        let promised = i.checked_mul(j).and_then(|n| n.checked_mul(k)).and_then(|n| n.checked_mul(wide));
        if promised != Some(self.values.len()) {
            return Err(format!(
                "{}: the zone promises {i} × {j} × {k} points of {wide} numbers, {} numbers are there",
                self.place,
                self.values.len()
            ));
        }
        if k > 1 {
            return Err(format!("{}: a zone with K = {k} is a volume, not a table of sections", self.place));
        }
        let by_variable = kind == "block";
        let value = |p: usize, v: usize| self.values[if by_variable { v * i * j + p } else { p * wide + v }];
        let section = |s: usize| (s * i..(s + 1) * i).map(|p| (0..wide).map(|v| value(p, v)).collect()).collect();
        Ok((0..j).map(|s| (self.place.clone(), section(s))).collect())
    }
}

fn tecplot(text: &str, file: &str, header: &Header) -> Result<PointTable, String> {
    let (variables, zones) = zones(text, file, header.skip_lines)?;
    let chosen = choose(zones, file, header)?;
    let mut blocks = Vec::new();
    for zone in &chosen {
        blocks.extend(zone.blocks(variables.len())?);
    }
    let width = blocks.first().and_then(|b| b.1.first()).map_or(0, Vec::len);
    let named = |name: &str| {
        let first = |v: &String| v.split([' ', '[', '(', ',']).next().unwrap_or("").to_ascii_lowercase();
        variables.iter().position(|v| first(v) == name)
    };
    let names = match (named("x"), named("y"), named("z")) {
        _ if !header.columns.is_empty() => header.columns.clone(),
        (Some(x), Some(y), Some(z)) => (0..width)
            .map(|k| {
                if k == x {
                    "x"
                } else if k == y {
                    "y"
                } else if k == z {
                    "z"
                } else {
                    "skip"
                }
                .to_owned()
            })
            .collect(),
        _ if width >= 3 => (0..width).map(|k| ["x", "y", "z"].get(k).copied().unwrap_or("skip").to_owned()).collect(),
        _ => return Err(format!("{file}: the zones have {width} variables, three are needed")),
    };
    if names.len() != width {
        return Err(format!("{file}: {} columns are named, the zones have {width} variables", names.len()));
    }
    let columns = Columns::new(&names, header.angle, !header.heights.is_empty())?;
    Ok(PointTable { blocks, columns, notes: Vec::new() })
}

/// The zones that are asked for; several zones that are surfaces of their own are not one blade.
fn choose(zones: Vec<Zone>, file: &str, header: &Header) -> Result<Vec<Zone>, String> {
    let plain = |t: &str| t.split_whitespace().collect::<Vec<_>>().join(" ").to_lowercase();
    let titles = || zones.iter().map(|z| format!("\"{}\"", plain(z.title()))).collect::<Vec<_>>().join(", ");
    for name in &header.zones {
        if !zones.iter().any(|z| plain(z.title()) == plain(name)) {
            return Err(format!("{file} has no zone \"{name}\"; it has {}", titles()));
        }
    }
    let wanted = |z: &Zone| header.zones.is_empty() || header.zones.iter().any(|n| plain(n) == plain(z.title()));
    let surface = |z: &Zone| z.key(&["j"]).is_some_and(|j| j != "1");
    if zones.iter().filter(|z| wanted(z)).count() > 1 && zones.iter().any(|z| wanted(z) && surface(z)) {
        return Err(format!(
            "{file} has several zones that are surfaces, {}: name that of the blade in a header, as zones = [\"…\"]",
            titles()
        ));
    }
    Ok(zones.into_iter().filter(wanted).collect())
}

/// Names of the variables, and the zones.
fn zones(text: &str, file: &str, skip: usize) -> Result<(Vec<String>, Vec<Zone>), String> {
    let mut variables = Vec::new();
    let mut zones: Vec<Zone> = Vec::new();
    let mut naming = false;
    for (k, line) in text.lines().enumerate().skip(skip) {
        let place = || format!("{file}, line {}", k + 1);
        let line = line.trim();
        if line.is_empty() || line.starts_with('#') {
            continue;
        }
        match keyword(line) {
            Some("variables") => {
                naming = true;
                variables.extend(words(line.split_once('=').map_or("", |(_, rest)| rest)));
                continue;
            }
            Some("zone") => {
                naming = false;
                zones.push(Zone { place: place(), keys: pairs(&line["zone".len()..]), ..Zone::default() });
                continue;
            }
            Some(_) => continue,
            None => {}
        }
        match columns::line(line, false) {
            TableLine::Numbers(row) => {
                naming = false;
                if zones.last().is_none_or(|z| z.ended) {
                    zones.push(Zone { place: place(), ..Zone::default() });
                }
                if let Some(zone) = zones.last_mut() {
                    zone.first_row = if zone.values.is_empty() { row.len() } else { zone.first_row };
                    zone.values.extend(row);
                }
            }
            TableLine::Damaged(word) => return Err(format!("{}: {word} is not a number", place())),
            _ if naming => variables.extend(words(line)),
            _ => match zones.last_mut() {
                Some(zone) if zone.values.is_empty() => zone.keys.extend(pairs(line)),
                Some(zone) => zone.ended = true,
                None => {}
            },
        }
    }
    if zones.is_empty() {
        return Err(format!("{file} holds no zone with points"));
    }
    Ok((variables, zones))
}

/// Names in a list: quoted ones may hold spaces.
fn words(text: &str) -> Vec<String> {
    let mut out = Vec::new();
    let mut rest = text.trim_start_matches(|c: char| c.is_whitespace() || c == ',');
    while !rest.is_empty() {
        let (word, after) = match rest.strip_prefix('"') {
            Some(quoted) => quoted.split_once('"').unwrap_or((quoted, "")),
            None => rest.split_once(|c: char| c.is_whitespace() || c == ',').unwrap_or((rest, "")),
        };
        out.push(word.trim().to_owned());
        rest = after.trim_start_matches(|c: char| c.is_whitespace() || c == ',');
    }
    out
}

/// `KEY = value` pairs; keys in small letters, values without quotes.
fn pairs(text: &str) -> Vec<(String, String)> {
    let mut out = Vec::new();
    let mut rest = text;
    while let Some((before, after)) = rest.split_once('=') {
        let key = before.trim_end().rsplit(|c: char| c.is_whitespace() || c == ',').next().unwrap_or("");
        let value = after.trim_start();
        let (value, next) = match value.strip_prefix('"') {
            Some(quoted) => quoted.split_once('"').unwrap_or((quoted, "")),
            None => value.split_at(value.find(|c: char| c.is_whitespace() || c == ',').unwrap_or(value.len())),
        };
        out.push((key.to_ascii_lowercase(), value.to_owned()));
        rest = next;
    }
    out
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used)]
    use super::*;

    #[test]
    fn kinds_are_told_by_content() {
        let rows = "1 2 3\n".repeat(9);
        let kind = |t: String| detect(t.as_bytes());
        assert_eq!(kind(format!("# made by\nVariables= X  Y  Z \nzone i= 9\n{rows}")), Some(TableKind::Tecplot));
        assert_eq!(kind(format!("# Profile 1 at 0.00%\n{rows}# Profile 2\n{rows}")), Some(TableKind::TurboGrid));
        assert_eq!(kind(format!("## Profile 1\n{rows}1 2 3 le1\n## Profile 2\n{rows}")), Some(TableKind::TurboGrid));
        assert_eq!(kind(format!("  9   1\n{rows}")), Some(TableKind::TBlade3));
        assert_eq!(kind(rows.clone()), Some(TableKind::Numbers));
        assert_eq!(kind(format!("X,Y,Z\n{rows}")), Some(TableKind::Numbers));
        assert_eq!(kind("a text\nof words\n".into()), None);
        assert_eq!(detect(b"1 2 3\n1 2 3\n1 2 3\n1 2 3\n1 2 3\n\0"), None);
        assert_eq!(kind("zoned out\n".into()), None);
    }

    #[test]
    fn tecplot_in_its_forms() {
        let read = |t: &str, zones: &[&str]| {
            let header = Header { zones: zones.iter().map(|z| (*z).to_owned()).collect(), ..Header::default() };
            read(TableKind::Tecplot, t, "t", &header)
        };
        // Points, a title over two lines, a variable before the coordinates.
        let t = read(
            "VARIABLES = \"p\" \"X [m]\"\n\"Y [m]\" \"Z [m]\"\nZONE T=\"a b\"\nI=2, F=POINT\n9 1 2 3\n9 4 5 6\n",
            &[],
        )
        .unwrap();
        let p = t.columns.point(&t.blocks[0].1[1], 0, 0.0);
        assert_eq!((t.blocks.len(), p.x, p.y, p.z), (1, 4.0, 5.0, 6.0));
        // One variable after another.
        let t = read("zone i=2 datapacking=block\n1 4\n2 5\n3 6\n", &[]);
        assert!(t.is_err(), "without names of variables the rows give their number");
        let t = read("variables=x,y,z\nzone i=2 datapacking=block\n1 4\n2 5\n3 6\n", &[]).unwrap();
        assert_eq!(t.blocks[0].1, [[1.0, 2.0, 3.0], [4.0, 5.0, 6.0]]);
        // A surface: its lines along I are the sections.
        let grid = "variables=x,y,z\nzone t=\"The  Blade\" i=2 j=2\n1 2 3\n4 5 6\n7 8 9\n0 1 2\n";
        assert_eq!(read(grid, &[]).unwrap().blocks.len(), 2);
        let two = format!("{grid}zone t=\"hub\" i=1 j=2\n1 2 3\n4 5 6\n");
        assert!(read(&two, &[]).err().unwrap().contains("\"hub\""));
        assert_eq!(read(&two, &["the blade"]).unwrap().blocks.len(), 2);
        assert!(read(&two, &["shroud"]).err().unwrap().contains("no zone \"shroud\""));
        for (bad, words) in [
            ("variables=x,y,z\nzone i=3\n1 2 3\n4 5 6\n", "promises 3"),
            ("variables=x,y,z\nzone i=99999999999999999 j=99999999999999999\n1 2 3\n", "promises"),
            ("variables=x,y,z\nzone i=1 k=2\n1 2 3\n4 5 6\n", "volume"),
            ("variables=x,y,z\nzone n=1, e=1, et=triangle\n1 2 3\n", "finite elements"),
            ("variables=x,y,z\nzone i=two\n1 2 3\n", "not a count"),
            ("variables=x,y\nzone i=1\n1 2\n", "three are needed"),
            ("variables=x,y,z\nzone i=1\n1 2 3e\n", "line 3"),
            ("variables=x,y,z\n", "no zone"),
        ] {
            let e = read(bad, &[]).err().unwrap();
            assert!(e.contains(words), "{words} is not in {e}");
        }
    }

    #[test]
    fn counts_of_tblade3_are_held_against_the_rows() {
        let good = "3 2\n0 0 0\n1 0 0\n0 1 0\n0 0 5\n1 0 5\n0 1 5\n";
        assert_eq!(read(TableKind::TBlade3, good, "t", &Header::default()).unwrap().blocks.len(), 2);
        for bad in [good.replacen("3 2", "3 3", 1), good.replacen("3 2", "4 2", 1)] {
            assert!(read(TableKind::TBlade3, &bad, "t", &Header::default()).is_err());
        }
    }
}
