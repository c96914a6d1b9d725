//! Where the tool is at a feed, as a function of the frame that is looked for.
//!
//! A program is followed through the machine with several zeros. Ball centres are affine in the
//! zero that is looked for, so that few zeros give all of it: `centre = base + map · (T p) + lift`.
//! Over the part `T` is the frame of the program and `p` the programmed point; in positions of the
//! axes `T` is the offset, a translation, and `p` the positions of the linear axes.

use crate::artifact::program::{Language, Programmed};
use crate::error::{Error, Result, Stage};
use crate::geometry::{Point, Rigid, Vector};
use crate::read::program::{Bench, Block, Destination, Moved, Script, Zero, follow_each};

type Matrix3 = nalgebra::Matrix3<f64>;

/// Length of the shifts with which programs are followed, mm: no words are lost in it.
const SHIFT_MM: f64 = 64.0;

/// What is looked for.
#[derive(Clone, Copy, Debug)]
pub(super) struct Lay {
    /// The program's coordinates to the blade frame; the offset of the linear axes as a translation
    /// where the program is in positions of these.
    pub frame: Rigid,
    /// X, Y, Z over the part are tips, not ball centres.
    pub tip: bool,
    /// What the ball's radius is greater by than that of the tool, mm.
    pub grown_mm: f64,
}

/// The tool at the end of a feed move.
#[derive(Clone, Copy, Debug)]
pub(super) struct FeedEnd {
    /// Index of the tool.
    pub tool: usize,
    /// Radius of its ball, mm.
    pub radius_mm: f64,
    base: Point,
    map: Matrix3,
    point: Point,
    axis: Vector,
    /// The tool axis is one of the program, not of the machine: it turns with the frame.
    carried: bool,
    /// The point is one over the part.
    over_part: bool,
    /// Way at a feed up to here, mm.
    way_mm: f64,
}

/// How the tool centre moves with what is looked for.
pub(super) struct Reaction {
    pub centre: Point,
    /// What turns about the origin of the blade frame, before `map`.
    pub arm: Vector,
    pub map: Matrix3,
    /// By the ball's radius, without unit.
    pub by_radius: Vector,
}

impl FeedEnd {
    /// The tool axis, blade frame.
    pub fn axis(&self, lay: &Lay) -> Vector {
        if self.carried { self.map * (lay.frame.rotation * self.axis) } else { self.axis }
    }

    /// Ball centre, blade frame.
    pub fn centre(&self, lay: &Lay) -> Point {
        let at = lay.frame * self.point;
        // Column by column: the product of matrices is a call, and lays have many places.
        let [x, y, z] = [0, 1, 2].map(|k| self.map.fixed_view::<3, 1>(0, k));
        let over = self.base + (x * at.x + y * at.y + z * at.z);
        if self.over_part && lay.tip { over + self.axis(lay) * (self.radius_mm + lay.grown_mm) } else { over }
    }

    pub fn reaction(&self, lay: &Lay) -> Reaction {
        let lifted = self.over_part && lay.tip;
        let by_radius = if lifted { self.axis(lay) } else { Vector::zeros() };
        Reaction { centre: self.centre(lay), arm: self.arm(lay), map: self.map, by_radius }
    }

    /// See [`Reaction::arm`].
    pub fn arm(&self, lay: &Lay) -> Vector {
        let arm = (lay.frame * self.point).coords;
        match self.over_part && lay.tip && self.carried {
            true => arm + lay.frame.rotation * self.axis * (self.radius_mm + lay.grown_mm),
            false => arm,
        }
    }

    /// The place with all lengths of the program so many times as long.
    fn scaled(&self, scale: f64) -> Self {
        FeedEnd { point: self.point * scale, way_mm: self.way_mm * scale, ..*self }
    }
}

/// All places of a program.
#[derive(Clone, Debug)]
pub(super) struct FeedEnds {
    pub all: Vec<FeedEnd>,
    /// A frame that is turned can be found: the program is over the part, and no plane of it is
    /// tied to the machine.
    pub turns: bool,
    /// The frame is an offset of the machine's linear axes.
    pub in_axes: bool,
}

impl FeedEnds {
    /// The places of a program, which has been read with the language of the benches.
    ///
    /// # Errors
    /// `Usage`: as [`follow_each`], and where no feed move is known from its beginning.
    pub fn of(script: &Script, benches: &[Bench]) -> Result<Self> {
        let in_axes = benches.iter().any(|b| b.language.programmed == Programmed::Machine);
        let turns = !in_axes && !script.blocks.iter().any(|b| b.in_plane);
        let all = if in_axes { along_axes(script, benches)? } else { over_part(script, benches, turns)? };
        if all.len() < LEAST {
            let what = format!("the program has {} feed moves that are known from their beginning", all.len());
            return Err(Error::usage(Stage::Verify, what).advise(format!("--fit needs {LEAST} at least")));
        }
        Ok(FeedEnds { all: evened(all), turns, in_axes })
    }

    /// About so many places, evenly along the way.
    pub fn sampled(&self, count: usize) -> Vec<FeedEnd> {
        let length = self.all.last().map_or(0.0, |p| p.way_mm);
        if self.all.len() <= count || !(length > 0.0) {
            return self.all.clone();
        }
        let step = length / count as f64;
        let mut next = 0.0;
        let mut out = Vec::with_capacity(count + 1);
        for place in &self.all {
            if place.way_mm >= next {
                out.push(*place);
                next = (place.way_mm / step).floor() * step + step;
            }
        }
        out
    }

    /// The places with all lengths so many times as long: in another unit.
    pub fn scaled(&self, scale: f64) -> Self {
        FeedEnds { all: self.all.iter().map(|p| p.scaled(scale)).collect(), ..self.clone() }
    }
}

/// Lines longer than so many times the median count as that long: way off the part is made in few.
const LONG: f64 = 6.0;

/// The same places, their ways without what long lines have too much.
fn evened(mut places: Vec<FeedEnd>) -> Vec<FeedEnd> {
    let mut steps: Vec<f64> = places.windows(2).map(|w| w[1].way_mm - w[0].way_mm).collect();
    let mut sorted = steps.clone();
    sorted.sort_by(f64::total_cmp);
    let most = LONG * sorted.get(sorted.len() / 2).copied().unwrap_or(0.0);
    steps.insert(0, 0.0);
    let mut way_mm = 0.0;
    for (place, step) in places.iter_mut().zip(steps) {
        way_mm += step.min(most);
        place.way_mm = way_mm;
    }
    places
}

/// Fewest places that a frame is looked for with.
const LEAST: usize = 12;

/// The tool at the end of every feed move that is known, and half way where it bends.
pub(super) struct Followed {
    pub tool: usize,
    pub moved: Moved,
    pub share: f64,
}

/// The feed moves of a program with a zero.
pub(super) fn followed(script: &Script, benches: &[Bench], zero: Zero) -> Result<Vec<Followed>> {
    let benches: Vec<Bench> = benches.iter().map(|b| Bench { zero, ..*b }).collect();
    let moves = match &benches[..] {
        [bench] => vec![crate::read::program::follow(&script.blocks, bench)?],
        _ => follow_each(&script.blocks, &benches)?,
    };
    let mut out = Vec::new();
    for (tool, moves) in moves.into_iter().enumerate() {
        for moved in moves.into_iter().filter(|m| m.known() && m.seconds.is_some() && (m.from != m.to || !m.even())) {
            let shares: &[f64] = if moved.even() { &[1.0] } else { &[0.5, 1.0] };
            out.extend(shares.iter().map(|share| Followed { tool, moved, share: *share }));
        }
    }
    Ok(out)
}

/// The zero of a frame.
pub(super) fn zero(frame: &Rigid, in_axes: bool) -> Zero {
    match in_axes {
        true => Zero { axes_mm: frame.translation.vector.into(), ..Zero::default() },
        false => Zero { blade_from_program: *frame, ..Zero::default() },
    }
}

/// Whether each block's tool axis is one of the program: the last one said was a vector.
fn carried(blocks: &[Block]) -> Vec<bool> {
    let mut carried = false;
    let said = blocks.iter().map(|block| {
        match block.place {
            Destination::Vector { .. } => carried = true,
            Destination::Words { rotary, .. } if rotary.iter().any(Option::is_some) => carried = false,
            Destination::Words { .. } => {}
        }
        carried
    });
    said.collect()
}

/// Places in positions of the axes: their centres without an offset, and with one along each axis.
fn along_axes(script: &Script, benches: &[Bench]) -> Result<Vec<FeedEnd>> {
    let with = |shift: Vector| followed(script, benches, zero(&Rigid::translation(shift.x, shift.y, shift.z), true));
    let base = with(Vector::zeros())?;
    let shifted = [with(Vector::x() * SHIFT_MM)?, with(Vector::y() * SHIFT_MM)?, with(Vector::z() * SHIFT_MM)?];
    let mut way = WayLength::default();
    let place = |(k, f): (usize, &Followed)| {
        let bench = benches.get(f.tool)?;
        let pose = |f: &Followed| f.moved.pose(f.share, bench.tool, bench.machine);
        let here = pose(f);
        let [x, y, z] = [0, 1, 2].map(|i| Some((pose(shifted[i].get(k)?).centre - here.centre) / SHIFT_MM));
        let map = Matrix3::from_columns(&[x?, y?, z?]);
        let at = f.moved.at(f.share);
        let linear = bench.machine.linear();
        let axes = Point::from(linear.map(|i| at[i]));
        Some(FeedEnd {
            tool: f.tool,
            radius_mm: bench.tool.radius_mm,
            // The offset is what is looked for; positions are kept for other units.
            base: here.centre - map * axes.coords,
            map,
            point: axes,
            axis: here.axis,
            carried: false,
            over_part: false,
            way_mm: way.to(&here.centre),
        })
    };
    Ok(base.iter().enumerate().filter_map(place).collect())
}

/// Length of the way through points.
#[derive(Default)]
struct WayLength {
    last: Option<Point>,
    length_mm: f64,
}

impl WayLength {
    fn to(&mut self, point: &Point) -> f64 {
        self.length_mm += self.last.map_or(0.0, |last| (point - last).norm());
        self.last = Some(*point);
        self.length_mm
    }
}

/// Frames in which programs over the part are followed until one has all tool axes in reach: none
/// turned, then turned by quarters and askew.
fn tried() -> Vec<Rigid> {
    let turn = |[x, y, z]: [f64; 3]| Rigid::rotation(Vector::new(x, y, z));
    let quarter = std::f64::consts::FRAC_PI_2;
    let mut out = vec![Rigid::identity()];
    for axis in [[0.0, quarter, 0.0], [0.0, 0.0, quarter], [quarter, 0.0, 0.0], [0.0, 2.0 * quarter, 0.0]] {
        out.push(turn(axis));
    }
    out.extend((1..8).map(|k| turn([0.7, -0.4, 1.1].map(|v| v * f64::from(k) * 0.37))));
    out
}

/// Places over the part. The programmed points come back from the frame that they were followed in;
/// where the control fixes its frame to the table, what it has fixed is taken from shifts and
/// half turns.
fn over_part(script: &Script, benches: &[Bench], turns: bool) -> Result<Vec<FeedEnd>> {
    let mut failed = None;
    for first in tried().into_iter().take(if turns { usize::MAX } else { 1 }) {
        match places_in(script, benches, &first) {
            Ok(places) => return Ok(places),
            Err(e) => failed = failed.or(Some(e)),
        }
    }
    Err(failed.unwrap_or_else(|| Error::usage(Stage::Verify, "the program cannot be followed")))
}

/// The program followed in a frame, and what the control has fixed to the table.
struct Probes {
    base: Vec<Followed>,
    /// Followed in the frame shifted along x, y and z, turned half about z and half about x; none
    /// where nothing is fixed.
    others: Vec<Vec<Followed>>,
}

impl Probes {
    fn of(script: &Script, benches: &[Bench], first: &Rigid) -> Result<Self> {
        let with = |before: Rigid| followed(script, benches, zero(&(before * first), false));
        let base = with(Rigid::identity())?;
        let mut others = Vec::new();
        if script.blocks.iter().any(|b| b.fixed_by.is_some()) {
            for shift in [Vector::x(), Vector::y(), Vector::z()].map(|v| v * SHIFT_MM) {
                others.push(with(Rigid::translation(shift.x, shift.y, shift.z))?);
            }
            for axis in [Vector::z(), Vector::x()] {
                others.push(with(Rigid::rotation(axis * std::f64::consts::PI))?);
            }
        }
        Ok(Probes { base, others })
    }

    /// `base` and `map` of a place, and its point in the frame; `None` where the program was
    /// followed otherwise in other frames.
    fn affine(&self, k: usize, point: impl Fn(&Followed) -> Point) -> Option<(Point, Matrix3, Point)> {
        let here = point(self.base.get(k)?);
        if self.others.is_empty() {
            return Some((Point::origin(), Matrix3::identity(), here));
        }
        let there: Vec<Point> = self.others.iter().filter_map(|o| o.get(k).map(&point)).collect();
        let [x, y, z, about_z, about_x] = there[..] else { return None };
        let map = Matrix3::from_columns(&[x, y, z].map(|p| (p - here) / SHIFT_MM));
        // Half a turn about z sends x and y to their opposites, one about x y and z.
        let [by_z, by_x] = [about_z, about_x].map(|p| 0.5 * (map.transpose() * (here - p)));
        let over = Point::new(by_z.x, by_z.y, by_x.z);
        Some((here - map * over.coords, map, over))
    }
}

fn places_in(script: &Script, benches: &[Bench], first: &Rigid) -> Result<Vec<FeedEnd>> {
    let probes = Probes::of(script, benches, first)?;
    let (carried, back) = (carried(&script.blocks), first.inverse());
    let mut way = WayLength::default();
    let place = |(k, f): (usize, &Followed)| {
        let bench = benches.get(f.tool)?;
        if f.moved.words == Programmed::Machine {
            return None;
        }
        let linear = bench.machine.linear();
        let point = |f: &Followed| {
            let at = f.moved.at(f.share);
            Point::from(linear.map(|i| at[i]))
        };
        let (base, map, over) = probes.affine(k, point)?;
        let axis = bench.machine.axis_at(&f.moved.at(f.share));
        let carried = carried.get(f.moved.block).copied().unwrap_or(false);
        Some(FeedEnd {
            tool: f.tool,
            radius_mm: bench.tool.radius_mm,
            base,
            map,
            point: back * over,
            axis: if carried { back.rotation * (map.transpose() * axis) } else { axis },
            carried,
            over_part: true,
            way_mm: way.to(&point(f)),
        })
    };
    Ok(probes.base.iter().enumerate().filter_map(place).collect())
}

/// Whether a program leaves it open if its points are tips or ball centres.
pub(super) fn other(language: Language) -> Option<Language> {
    let programmed = match language.programmed {
        Programmed::Tip => Programmed::Centre,
        Programmed::Centre => Programmed::Tip,
        Programmed::Machine => return None,
    };
    Some(Language { programmed, ..language })
}
