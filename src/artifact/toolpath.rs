//! Cutter locations of one continuous helix.
use super::{Cone, Cones};
use crate::error::{Along, EndReason};
use crate::geometry::{Point, Vector};

/// Greatest scallop between turns where nobody asks for another, mm.
pub const SCALLOP_MM: f64 = 0.01;
/// Greatest distance of a straight move from the exact path where nobody asks for another, mm: a
/// tenth of the usual scallop.
pub const CHORD_MM: f64 = 0.001;

/// How the turns of the helix lie.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, serde::Serialize, serde::Deserialize, schemars::JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum PathKind {
    /// Every turn falls by the same height all the way round, as much as the scallop allows at its
    /// worst place (planar turns).
    ConstantHeight,
    /// Equal parts, at each place round the blade, of the way along the surface from the start of
    /// the region to its end.
    IsoParametric,
    /// Every turn is the constant-scallop neighbour of the turn before it at every point.
    #[default]
    ConstantScallop,
    /// For comparison: a helix as a published method for turn-milling lays it, each turn at
    /// first-order widths from the turn before. Ridges are not measured, and higher than asked for.
    FirstOrder,
    /// The same, and each turn is a closed ring.
    FirstOrderRings,
    /// No helix: rows over the hub of a wheel, along the passage between the blade and the next
    /// one, to and fro.
    HubRows,
    /// Taken from a program; no job asks for it.
    #[serde(skip_deserializing)]
    #[schemars(skip)]
    Given,
}

impl PathKind {
    /// Those that go round a blade and that anyone would mill. Turns of first-order neighbours
    /// leave more than is asked for.
    pub const ROUND: [PathKind; 3] = [PathKind::ConstantHeight, PathKind::IsoParametric, PathKind::ConstantScallop];

    /// Whether turns are laid from one another, from the end of the region up.
    pub fn is_of_neighbours(self) -> bool {
        match self {
            PathKind::ConstantScallop | PathKind::FirstOrder | PathKind::FirstOrderRings => true,
            PathKind::ConstantHeight | PathKind::IsoParametric | PathKind::HubRows | PathKind::Given => false,
        }
    }

    /// Its name on the command line and in files.
    pub fn name(self) -> String {
        super::word(&self)
    }
}

/// On which side of the cutter the material is, with a spindle that turns clockwise seen from above
/// (M3). The helix runs counter-clockwise seen from the tip in either case, so this is also its
/// hand.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, serde::Serialize, serde::Deserialize, schemars::JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum Direction {
    /// Climb milling: from the start of the region down towards the platform; a left-handed helix.
    #[default]
    Climb,
    /// Conventional (up-cut) milling: from the end of the region up; a right-handed helix.
    Conventional,
}

/// Where turns begin.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, serde::Serialize, serde::Deserialize, schemars::JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum Start {
    /// Where the path enters its greatest concave stretch.
    #[default]
    Concave,
    /// At the altered point nearest to the trailing edge.
    TrailingEdge,
}

/// One cutter location.
#[derive(Clone, Copy, Debug, PartialEq, serde::Serialize, serde::Deserialize)]
pub struct CutterLocation {
    /// Number of the turn, from 0.
    pub turn: u32,
    /// Arc length from the turn's base point along the path of ball centres, mm.
    pub turn_s_mm: f64,
    /// Arc length from the start of the path, mm.
    pub s_mm: f64,
    /// Ball centre, mm.
    pub centre: Point,
    /// Contact point on the part, or on the stock that is left on it, mm. On a link, where the ball
    /// touches nothing, it is the centre.
    pub contact: Point,
    /// Outward unit normal at the contact: from contact to centre. On a link a direction within the
    /// range of contact angles of the tool axis.
    pub normal: Vector,
}

impl CutterLocation {
    /// The ball touches the part there; else it is on a link, on its way through the air.
    pub fn touches(&self) -> bool {
        self.contact != self.centre
    }
}

/// A way through the air, off the blade at a location and back onto it at the same place.
#[derive(Clone, Debug, PartialEq)]
pub struct Link {
    /// The location.
    pub row: usize,
    /// Ball centres on the way, mm, with the normals that stand for the tool axis there.
    pub places: Vec<(Point, Vector)>,
}

/// A turn: locations `first .. first + count`; its last location is the next turn's base point less
/// one step.
#[derive(Clone, Copy, Debug, PartialEq, serde::Serialize, serde::Deserialize)]
pub struct Turn {
    /// Index of the base point's location.
    pub first: usize,
    /// Number of locations.
    pub count: usize,
    /// Arc length from this base point to the next, mm (for the last turn: to the end of the path).
    pub length_mm: f64,
}

/// The helix. Locations run so that the angle about the blade axis increases (counter-clockwise
/// seen from the tip).
#[derive(Clone, Debug, PartialEq, serde::Serialize, serde::Deserialize)]
pub struct Toolpath {
    /// How the turns lie.
    pub kind: PathKind,
    /// Radius of the ball, or of the corner of a cutter that is none, mm.
    pub radius_mm: f64,
    /// Radius of the disc that the corner rolls over, mm: locations have its centre for that of a
    /// ball. Arc lengths are those of the corner's centre, which touches where a ball of its radius
    /// would.
    #[serde(default, skip_serializing_if = "is_none")]
    pub disc_radius_mm: f64,
    /// Stock left on the part for a later pass, mm; contacts lie on its surface.
    pub stock_mm: f64,
    /// Scallop asked for, mm.
    pub scallop_mm: f64,
    /// Chord tolerance between locations, mm.
    pub chord_mm: f64,
    /// Region machined, along the blade axis, mm: heights of the first and last ball centres.
    pub region_x_mm: [f64; 2],
    /// Why the path ends where it ends.
    pub end_reason: EndReason,
    /// Scallop that the planner foresees between neighbouring turns, mm: the greatest on exact
    /// faces, the 99th percentile on a mesh, and of a cutter with a corner.
    pub planned_scallop_mm: f64,
    /// The tool axes that each location allows.
    pub cones: Cones,
    /// Of cones that a search in five axes chose: how evenly they turn.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub axis_turning: Option<AxisTurning>,
    /// Turns in order.
    pub turns: Vec<Turn>,
    /// Locations in order.
    #[serde(with = "locations")]
    pub locations: Vec<CutterLocation>,
}

/// How evenly the tool axis of a plan in five axes turns: `∫ θ''² ds` of the two curves that its
/// angles follow, rad²/mm³, each with a number that no curve between the same walls falls below.
///
/// Walls of the one angle are those with the other held, moved inwards by what the search keeps
/// from them (`docs/decisions/five-axes-are-cones-found-in-layers.md`).
#[derive(Clone, Copy, Debug, PartialEq, serde::Serialize, serde::Deserialize)]
pub struct AxisTurning {
    /// Longitude about the rotor axis, with the latitudes of the search: value and bound.
    pub longitude: [f64; 2],
    /// Latitude, with these longitudes: value and bound.
    pub latitude: [f64; 2],
}

impl AxisTurning {
    /// Longitude's and latitude's value over its bound; `None` where the bound is 0.
    pub fn over_bounds(&self) -> [Option<f64>; 2] {
        [self.longitude, self.latitude].map(|[value, bound]| (bound > 0.0).then(|| value / bound))
    }
}

/// A place of a path that a program gives.
#[derive(Clone, Copy, Debug)]
pub struct GivenPlace {
    /// Ball centre, blade frame, mm.
    pub centre: Point,
    /// Outward unit normal of the part under the ball; where that is nowhere near, the tool axis.
    pub normal: Vector,
    /// How far the way has turned about the blade axis since the first place, rad.
    pub turned_rad: f64,
}

impl Toolpath {
    /// The path of a ball through given places, of which turns are counted as the way goes on about
    /// the blade axis: ball radius, stock and chord tolerance in mm.
    pub fn given(places: &[GivenPlace], [radius_mm, stock_mm, chord_mm]: [f64; 3], cones: Cones) -> Self {
        let (mut s_mm, mut turn_s_mm) = (0.0, 0.0);
        let (mut turns, mut locations): (Vec<Turn>, Vec<CutterLocation>) = (Vec::new(), Vec::new());
        for (k, GivenPlace { centre, normal, turned_rad }) in places.iter().enumerate() {
            if let Some(before) = locations.last() {
                let way = (centre - before.centre).norm();
                (s_mm, turn_s_mm) = (s_mm + way, turn_s_mm + way);
            }
            let turn = (turned_rad.max(0.0) / std::f64::consts::TAU) as u32;
            if locations.last().is_none_or(|l| l.turn < turn) {
                turns.push(Turn { first: k, count: 0, length_mm: 0.0 });
                turn_s_mm = 0.0;
            }
            let turn = turn.max(locations.last().map_or(0, |l| l.turn));
            if let Some(open) = turns.last_mut() {
                (open.count, open.length_mm) = (open.count + 1, turn_s_mm);
            }
            let (contact, normal) = (centre - normal * radius_mm, *normal);
            locations.push(CutterLocation { turn, turn_s_mm, s_mm, centre: *centre, contact, normal });
        }
        let heights = locations.iter().map(|l| l.centre.x);
        let region_x_mm = heights.fold([f64::INFINITY, f64::NEG_INFINITY], |[a, b], x| [a.min(x), b.max(x)]);
        Toolpath {
            kind: PathKind::Given,
            radius_mm,
            disc_radius_mm: 0.0,
            stock_mm,
            scallop_mm: 0.0,
            chord_mm,
            region_x_mm,
            end_reason: EndReason::Region,
            planned_scallop_mm: 0.0,
            cones,
            axis_turning: None,
            turns,
            locations,
        }
    }
}

/// Whether a disc is none: the cutter is a ball.
pub(crate) fn is_none(disc_radius_mm: &f64) -> bool {
    *disc_radius_mm == 0.0
}

/// Locations in files: a table of numbers.
mod locations {
    use serde::de::Error as _;
    use serde::{Deserialize, Deserializer, Serialize, Serializer};

    use super::{CutterLocation, Point, Vector};
    use crate::artifact::packed::{self, Table};

    const COLUMNS: [&str; 12] = [
        "turn",
        "turn_s_mm",
        "s_mm",
        "centre_x",
        "centre_y",
        "centre_z",
        "contact_x",
        "contact_y",
        "contact_z",
        "normal_x",
        "normal_y",
        "normal_z",
    ];

    pub(super) fn serialize<S: Serializer>(locations: &[CutterLocation], to: S) -> Result<S::Ok, S::Error> {
        let row = |l: &CutterLocation| {
            let (c, k, n) = (l.centre, l.contact, l.normal);
            [f64::from(l.turn), l.turn_s_mm, l.s_mm, c.x, c.y, c.z, k.x, k.y, k.z, n.x, n.y, n.z]
        };
        Table::of(COLUMNS, locations.iter().map(row)).serialize(to)
    }

    pub(super) fn deserialize<'a, D: Deserializer<'a>>(from: D) -> Result<Vec<CutterLocation>, D::Error> {
        let rows = Table::deserialize(from)?.rows(COLUMNS).map_err(D::Error::custom)?;
        let location = |[turn, turn_s_mm, s_mm, cx, cy, cz, kx, ky, kz, nx, ny, nz]: [f64; 12]| {
            Ok(CutterLocation {
                turn: packed::index(turn)?,
                turn_s_mm,
                s_mm,
                centre: Point::new(cx, cy, cz),
                contact: Point::new(kx, ky, kz),
                normal: Vector::new(nx, ny, nz),
            })
        };
        rows.into_iter().map(location).collect::<Result<_, String>>().map_err(D::Error::custom)
    }
}

impl Toolpath {
    /// The tool axes that a location allows.
    pub fn cone(&self, row: usize) -> Cone {
        self.cones.at(row)
    }

    /// Some of its locations, in rising order, with their cones and their turns; what was measured
    /// of the whole path stays as it is.
    #[must_use]
    pub fn at(&self, rows: &[usize]) -> Self {
        let locations = rows.iter().filter_map(|k| self.locations.get(*k).copied()).collect();
        let turn = |t: &Turn| {
            let first = rows.partition_point(|k| *k < t.first);
            Turn { first, count: rows.partition_point(|k| *k < t.first + t.count) - first, ..*t }
        };
        let (turns, cones) = (self.turns.iter().map(turn).collect(), self.cones.chosen(rows));
        Toolpath { turns, locations, cones, ..self.clone() }
    }

    /// A location as a place for errors; beyond the last, that.
    pub fn along(&self, row: usize) -> Along {
        let l = self.locations.get(row).or(self.locations.last());
        let (turn, turn_s_mm, height_mm) = l.map_or((0, 0.0, 0.0), |l| (l.turn, l.turn_s_mm, l.centre.x));
        Along { location: row, turn, turn_s_mm, height_mm }
    }

    /// The path with links, which come in the order of their locations. After each the location
    /// that it leaves from comes once more. Second: for each row of the new path the row of this
    /// one that it is, or that its link leaves from. Cones are left as they are.
    #[must_use]
    pub fn with_links(&self, links: &[Link]) -> (Self, Vec<usize>) {
        let (mut locations, mut origin): (Vec<CutterLocation>, Vec<usize>) = (Vec::new(), Vec::new());
        let mut ahead = links.iter().peekable();
        for (row, l) in self.locations.iter().enumerate() {
            locations.push(*l);
            while let Some(link) = ahead.next_if(|link| link.row == row) {
                let on_link = |(centre, normal): &(Point, Vector)| CutterLocation {
                    centre: *centre,
                    contact: *centre,
                    normal: *normal,
                    ..*l
                };
                locations.extend(link.places.iter().map(on_link));
                locations.push(*l);
            }
            origin.resize(locations.len(), row);
        }
        (self.of_rows(locations), origin)
    }

    /// The ball leaves the part somewhere on the way.
    pub fn has_links(&self) -> bool {
        !self.locations.iter().all(CutterLocation::touches)
    }

    /// The path without its links.
    #[must_use]
    pub fn without_links(&self) -> Self {
        if !self.has_links() {
            return self.clone();
        }
        let mut locations: Vec<CutterLocation> = Vec::with_capacity(self.locations.len());
        let mut comes_back = false;
        for l in &self.locations {
            let again = comes_back && locations.last().is_some_and(|last| last.centre == l.centre);
            if l.touches() && !again {
                locations.push(*l);
            }
            comes_back = !l.touches();
        }
        self.of_rows(locations)
    }

    /// The path with other locations of the same turns: arc lengths are measured anew.
    fn of_rows(&self, mut locations: Vec<CutterLocation>) -> Self {
        let mut turns: Vec<Turn> = Vec::with_capacity(self.turns.len());
        let (mut s_mm, mut base_mm) = (0.0, 0.0);
        for row in 0..locations.len() {
            if let Some(before) = row.checked_sub(1) {
                s_mm += (locations[row].centre - locations[before].centre).norm();
            }
            let turn = locations[row].turn;
            if row == 0 || locations[row - 1].turn != turn {
                if let Some(last) = turns.last_mut() {
                    last.length_mm = s_mm - base_mm;
                }
                base_mm = s_mm;
                turns.push(Turn { first: row, count: 0, length_mm: 0.0 });
            }
            if let Some(last) = turns.last_mut() {
                (last.count, last.length_mm) = (last.count + 1, s_mm - base_mm);
            }
            (locations[row].s_mm, locations[row].turn_s_mm) = (s_mm, s_mm - base_mm);
        }
        Toolpath { turns, locations, ..self.clone() }
    }

    /// The path of the corner's centres: of balls as large as the corner, with the same contacts.
    #[must_use]
    pub fn of_corner(&self) -> Self {
        let mut out = Toolpath { disc_radius_mm: 0.0, ..self.clone() };
        if self.disc_radius_mm > 0.0 {
            out.locations.iter_mut().for_each(|l| l.centre = l.contact + l.normal * self.radius_mm);
        }
        out
    }

    /// The same path with other tool axes.
    #[must_use]
    pub fn with_cones(self, cones: Cones) -> Self {
        Toolpath { cones, axis_turning: None, ..self }
    }
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used)]
    use super::*;
    use crate::sample;

    /// Links lengthen the turns that they are on, and nothing else; without them the path is what
    /// it was, to the last digit.
    #[test]
    fn a_path_with_links_is_itself_without_them() {
        let before = sample::plan(3, 12).toolpath;
        // Arc lengths as sums of moves.
        let path = before.of_rows(before.locations.clone());
        let link = |row: usize, places: &[f64]| {
            let over = path.locations[row].centre;
            let at = |up: &f64| (over + Vector::x() * *up, Vector::x());
            Link { row, places: places.iter().map(at).collect() }
        };
        let (linked, origin) = path.with_links(&[link(4, &[1.0, 2.0, 1.0]), link(14, &[5.0])]);
        let air: Vec<usize> = (0..linked.locations.len()).filter(|k| !linked.locations[*k].touches()).collect();
        assert_eq!(air, [5, 6, 7, 19]);
        assert_eq!(origin.len(), linked.locations.len());
        assert_eq!([origin[4], origin[6], origin[8], origin[9], origin[19], origin[20]], [4, 4, 4, 5, 14, 14]);
        let longer: Vec<f64> = linked.turns.iter().zip(&path.turns).map(|(a, b)| a.length_mm - b.length_mm).collect();
        assert!(longer.iter().zip([4.0, 10.0, 0.0]).all(|(is, want)| (is - want).abs() < 1e-9), "{longer:?}");
        let counts: Vec<usize> = linked.turns.iter().map(|t| t.count).collect();
        assert_eq!(counts, [path.turns[0].count + 4, path.turns[1].count + 2, path.turns[2].count]);
        let (last, own) = (linked.locations.last().unwrap(), path.locations.last().unwrap());
        assert!((last.s_mm - own.s_mm - 14.0).abs() < 1e-9);
        let [back, bare] = [linked.without_links(), path.without_links()];
        assert_eq!((&back.locations, &back.turns), (&path.locations, &path.turns));
        assert_eq!(bare.locations, path.locations);
    }
}
