//! Two tools on one blade: rows of opposite places, the table's angles that are free for both, and
//! one at which it stands still for each row, or angles between which it turns as slowly as can be.
//!
//! **In** a [`Setup`]: its tool, and its second where the job has one. **Out** [`Pinch`], judged.
//! **Method** Rows ([`pairs`]); the free angles of each tool at all their places
//! ([`channel::intervals`]), tool 2's turned back by the angle between the heads, and what both
//! have; an angle for each row ([`pair::hold`]), or those along a row that has none; checks that
//! use none of these ([`verify::check_pinch`]).

use std::f64::consts::{PI, TAU};
use std::ops::Range;

use super::Setup;
use crate::artifact::paired::{Held, PairPlace, PinchMotion};
use crate::artifact::report::Check;
use crate::artifact::{Cone, Cones, PairedRows, Sweep};
use crate::channel::{self, ChannelOptions, Surroundings};
use crate::error::{Error, Infeasible, Result, Stage};
use crate::geometry::Point;
use crate::numerics::angle::within_half_turn;
use crate::numerics::runs::longest;
use crate::observe::{Observer, timed};
use crate::pair::{
    self, Both, FreeAngles, HoldOptions, PinchEdges, PinchOrientation, PinchSettings, PinchTopology, Planned, Turning,
};
use crate::path::pairs::{self, PairOptions};
use crate::tool::Tool;
use crate::verify::{self, PinchAsked, PinchFigures, PinchWork};
use crate::write::post::pinch::{PinchFile, PinchProgram};
use crate::write::post::{self, Dialect};

/// Angles between heads that differ by less are the same, rad.
const SAME_RAD: f64 = 1e-6;
/// Where the table turns, balls may leave the straight line between two places by this share of
/// the chord tolerance.
const TURNING_CHORD: f64 = 0.25;

mod advise;
mod motion;
mod published;
mod threads;

pub use advise::{LeanPair, PinchAdvice};
pub use motion::motion;
pub use published::PublishedFigures;

use published::Postures;

/// Rows of two tools with the table's angles.
pub struct Pinch {
    /// The rows.
    pub rows: PairedRows,
    /// Places that were cut off the ends of rows, since no angle of the table is free for both.
    pub cut_off: usize,
    /// Angles of the table that are free for tool 1 and for tool 2 at each place.
    pub own: [Vec<FreeAngles>; 2],
    /// What is free for both.
    pub common: Vec<FreeAngles>,
    /// The stretches with the angles of the table, in order of the rows.
    pub held: Vec<Held>,
    /// Where the table turns along rows, no angles are less steep than so many rad/mm in their
    /// steepest places ([`pair::TurningRow`]); 0 where it turns along none.
    pub least_slope: f64,
    /// The angle of the second head over the first, rad.
    pub between_rad: f64,
    /// The published way, where it was asked for.
    pub published: Option<PublishedFigures>,
    /// What was checked.
    pub checks: Vec<Check>,
    /// What was measured.
    pub figures: PinchFigures,
}

/// The motion and the programs of rows of two tools.
pub struct PinchProgrammed {
    /// The motion.
    pub motion: PinchMotion,
    /// What was checked of it.
    pub checks: Vec<Check>,
    /// The programs, in the order of the job's controls.
    pub programs: Vec<PinchPosted>,
}

impl PinchProgrammed {
    /// All checks, of the motion and of all programs.
    pub fn all_checks(&self) -> impl Iterator<Item = &Check> {
        self.checks.iter().chain(self.programs.iter().flat_map(|p| &p.checks))
    }
}

/// A program of two tools for a control.
pub struct PinchPosted {
    /// The control, as the job names it, or the post file.
    pub control: String,
    /// Its file, or those of both channels.
    pub files: Vec<PinchFile>,
    /// What reading it back found.
    pub checks: Vec<Check>,
}

impl Pinch {
    /// The stretch in which a place is cut last.
    pub fn held_at(&self, place: usize) -> Option<&Held> {
        let n = self.held.partition_point(|h| h.places.end <= place);
        self.held.get(n).filter(|h| h.places.contains(&place))
    }

    /// What is free for tool 1, for tool 2 and for both about the angles of a stretch, at each of
    /// its places: `[from, to]` on the turn of the angle there, rad.
    pub fn free_about(&self, held: &Held) -> [Vec<[f64; 2]>; 3] {
        let around = |(free, theta): (&FreeAngles, &f64)| free.around(*theta);
        [&self.own[0], &self.own[1], &self.common]
            .map(|of| of[held.places.clone()].iter().zip(&held.theta_rad).map(around).collect())
    }

    /// The ends of what is free for both at all of some places about an angle, rad.
    pub fn free_all_along(&self, places: Range<usize>, theta_rad: f64) -> [f64; 2] {
        let all = self.common[places].iter().fold(FreeAngles::all(), |free, here| free.and(here));
        all.around(theta_rad)
    }

    /// Number of rows along which the table does not turn.
    pub fn still_rows(&self) -> usize {
        still_rows(&self.held)
    }

    /// Least width of what is free for both at a place, rad, and the place.
    pub fn narrowest(&self) -> Option<(f64, usize)> {
        narrowest(&self.common)
    }
}

/// Number of rows that are one stretch with the table still.
fn still_rows(held: &[Held]) -> usize {
    held.chunk_by(|a, b| a.row == b.row).filter(|row| row.len() == 1 && row[0].is_still()).count()
}

fn narrowest(common: &[FreeAngles]) -> Option<(f64, usize)> {
    let widths = common.iter().map(FreeAngles::widest).enumerate();
    widths.min_by(|a, b| a.1.total_cmp(&b.1)).map(|(k, w)| (w, k))
}

impl Setup {
    /// What the job asks of two tools.
    pub fn pinch_settings(&self) -> PinchSettings {
        self.job.pinch.clone().unwrap_or_default()
    }

    /// The cones of both tools' axes.
    pub fn pinch_cones(&self) -> [Cone; 2] {
        let first = self.job.machine.b_deg;
        let second = self.pinch_settings().b_2_deg.unwrap_or(first);
        [first, second].map(|deg| Cone::about_blade(deg.to_radians()))
    }

    /// Plans rows for two tools and judges them.
    ///
    /// # Errors
    /// Those of [`pairs::plan`] and [`channel::intervals`]; kind `Infeasible` where at a place no
    /// angle of the table is free for both tools.
    pub fn pinch(&self, observer: &dyn Observer) -> Result<Pinch> {
        let cones = self.pinch_cones();
        let between_rad = self.between_heads(&self.pinch_settings(), cones)?;
        let shared = match self.pinch_settings().topology {
            PinchTopology::OpposedRows => self.opposed_rows((cones, between_rad), observer)?,
            PinchTopology::DoubleHelix => self.double_helix((cones, between_rad), observer)?,
        };
        let Shared { rows, cut_off, own, common, planned, postures } = shared;
        let (checks, figures) = (Vec::new(), PinchFigures::default());
        let mut turning: Vec<usize> = planned.least_slopes.iter().map(|(n, _)| planned.held[*n].row).collect();
        turning.dedup();
        let rows_without = rows.rows.len() - turning.len();
        let least_slope = planned.least_slopes.iter().map(|(_, slope)| *slope).fold(0.0, f64::max);
        let mut pinch = Pinch {
            rows,
            cut_off,
            own,
            common,
            held: planned.held,
            least_slope,
            between_rad,
            published: None,
            checks,
            figures,
        };
        pinch.published = postures.map(|p| self.published(&pinch, p, rows_without));
        let options = self.verify_options();
        let work = self.pinch_work(&pinch);
        let (checks, figures) = timed(observer, Stage::Verify, || Ok(verify::check_pinch(&work, &options)))?;
        (pinch.checks, pinch.figures) = (checks, figures);
        Ok(pinch)
    }

    /// Rows of opposite places, and how the table stands along them.
    fn opposed_rows(&self, at: ([Cone; 2], f64), observer: &dyn Observer) -> Result<Shared> {
        let rows = self.paired_rows(observer)?;
        let around = timed(observer, Stage::Channel, || self.around_both())?;
        let own = self.free_of_both(&around, &rows, at.0, observer)?;
        let asked = self.pinch_settings().orientation;
        timed(observer, Stage::Schedule, || self.shared(&rows, own, at, asked, observer))
    }

    /// What is free for each tool at all places of rows, by its own angle.
    fn free_of_both(
        &self,
        around: &AroundBoth,
        rows: &PairedRows,
        cones: [Cone; 2],
        observer: &dyn Observer,
    ) -> Result<[Vec<FreeAngles>; 2]> {
        timed(observer, Stage::Channel, || {
            let free = |tool: usize| self.free_angles(around.of(tool), rows, (tool, cones[tool]), observer);
            Ok([free(0)?, free(1)?])
        })
    }

    /// Rows for both tools, before anything is known of their shafts.
    fn paired_rows(&self, observer: &dyn Observer) -> Result<PairedRows> {
        self.shares_the_table("rows for two tools are planned")?;
        let (job, asked, tools) = (&self.job, self.pinch_settings(), self.pinch_tools());
        let options = PairOptions {
            settings: job.path.clone(),
            radius_mm: tools.map(|t| t.radius_mm),
            heights_mm: asked.heights_mm,
            max_angle_rad: asked.max_angle_deg.to_radians(),
            apart_mm: asked.tools_apart_mm,
            edges: asked.edges == PinchEdges::Both,
        };
        timed(observer, Stage::Path, || pairs::plan(&self.blade, &options, observer))
    }

    /// Whether both tools are balls that keep one lean each.
    fn shares_the_table(&self, what: &str) -> Result<()> {
        self.pinch_tools().into_iter().try_for_each(|t| t.ball_only(what))?;
        if self.job.orientation.kind.goes_round() {
            return Ok(());
        }
        Err(Error::usage(Stage::Job, "two tools share the turning of the blade: each keeps one lean")
            .advise("leave out orientation.kind"))
    }

    /// What is in the way of both tools. One index serves balls of one radius.
    fn around_both(&self) -> Result<AroundBoth<'_>> {
        let [first, second] = self.pinch_tools().map(|t| t.radius_mm);
        let other = if first == second { None } else { Some(self.surroundings_of(second)?) };
        Ok(AroundBoth { first: self.surroundings()?, other })
    }

    /// What both tools can do along rows: `own` is what is free for each by its own angle, the
    /// second head standing `between_rad` on from the first.
    fn shared(
        &self,
        rows: &PairedRows,
        [first, second]: [Vec<FreeAngles>; 2],
        (cones, between_rad): ([Cone; 2], f64),
        orientation: PinchOrientation,
        observer: &dyn Observer,
    ) -> Result<Shared> {
        let own = [first, second.iter().map(|f| f.turned(-between_rad)).collect()];
        let common: Vec<FreeAngles> = own[0].iter().zip(&own[1]).map(|(a, b)| a.and(b)).collect();
        let both = Both::new(self.pinch_tools(), cones, between_rad);
        // What is free for both ends rows too, as near a platform.
        let open = |row: &Range<usize>| {
            let run = longest(&common[row.clone()].iter().map(|c| !c.is_empty()).collect::<Vec<_>>());
            row.start + run.start..row.start + run.end
        };
        let kept: Vec<_> = rows.rows.iter().map(open).filter(|row| row.len() > 1).collect();
        if kept.is_empty() {
            let first = common.iter().position(FreeAngles::is_empty).unwrap_or(0);
            return Err(if rows.places.is_empty() { no_rows(rows) } else { closed(rows, &own, &both, first) });
        }
        let all = rows.places.len();
        let chosen =
            |of: &[FreeAngles]| kept.iter().flat_map(|row| of[row.clone()].iter().cloned()).collect::<Vec<_>>();
        let (own, common, rows) = ([chosen(&own[0]), chosen(&own[1])], chosen(&common), rows.only(&kept));
        let cut_off = all - rows.places.len();
        let clear =
            |places: &Range<usize>, theta_rad: &dyn Fn(usize) -> f64| self.clear_along(&rows, &both, places, theta_rad);
        let hold = HoldOptions { margin_rad: self.job.schedule.margin_deg.to_radians() };
        // Nothing is asked of moves along which the table never turns.
        let moves: Vec<[f64; 2]> = match orientation {
            PinchOrientation::Hold => Vec::new(),
            _ => rows.places.windows(2).map(|w| self.turning_over(w, cones)).collect(),
        };
        let [way_mm, most_rad] = [0, 1].map(|k| moves.iter().map(|m| m[k]).collect::<Vec<f64>>());
        let postures = (orientation == PinchOrientation::Paper).then(|| self.postures(&rows, cones[0]));
        let posture_rad = postures.as_ref().map(|p| &p.curve_rad[..]);
        let plan = |may: Option<&(dyn Fn(usize) -> bool + Sync)>| {
            let turning = may.map(|may| Turning { way_mm: &way_mm, most_rad: &most_rad, may, posture_rad });
            let mut planned =
                pair::hold(&rows.rows, &common, hold, turning, clear).map_err(|k| closed(&rows, &own, &both, k))?;
            planned.held = within_turns(planned.held, self.theta_limits());
            Ok(planned)
        };
        let planned = match orientation {
            PinchOrientation::Hold => plan(None)?,
            PinchOrientation::Smooth | PinchOrientation::Paper => plan(Some(&|_| true))?,
            PinchOrientation::Time => {
                let quicker =
                    motion::quicker_turning(self, &rows, between_rad, [plan(None), plan(Some(&|_| true))], observer)?;
                plan(Some(&|row| quicker.contains(&row)))?
            }
        };
        Ok(Shared { rows, cut_off, own, common, planned, postures })
    }

    /// Whether both tools keep clear of each other at all places of a stretch, at the angles of the
    /// table there.
    fn clear_along(
        &self,
        rows: &PairedRows,
        both: &Both,
        places: &Range<usize>,
        theta_rad: &dyn Fn(usize) -> f64,
    ) -> bool {
        let apart_mm = self.pinch_settings().tools_apart_mm;
        let mut moves = places.clone().zip(places.start + 1..places.end);
        moves.all(|(a, b)| {
            let (ends, thetas) = ([a, b].map(|k| &rows.places[k]), [a, b].map(theta_rad));
            both.apart(ends, thetas).least_mm >= apart_mm
        })
    }

    /// Over which way a turn of the table is spread between two places, mm, and what it may turn
    /// there at most, rad.
    ///
    /// The way is the shorter of both contacts', over the cosine of the lean: then the slope of the
    /// angle is the greater of what both tool axes turn by per mm of contact. Axes of the machine
    /// go straight from place to place, and balls among them a little beside the line: with ρ the
    /// distance of a ball centre from the table's axis and `d` its way, by `(3 ρ φ² + 2 φ d) / 8`
    /// at most where the table turns by φ.
    fn turning_over(&self, places: &[PairPlace], cones: [Cone; 2]) -> [f64; 2] {
        let [a, b] = [0, places.len() - 1].map(|k| &places[k].contacts);
        let way = |j: usize| (b[j].contact - a[j].contact).norm() / cones[j].lean_rad.cos();
        let chord_mm = TURNING_CHORD * self.job.path.chord_mm;
        let most = |j: usize| {
            let (way, rho) = (
                (b[j].centre - a[j].centre).norm(),
                self.off_table_axis_mm(&a[j].centre).max(self.off_table_axis_mm(&b[j].centre)),
            );
            ((way * way + 24.0 * rho * chord_mm).sqrt() - way) / (3.0 * rho).max(f64::MIN_POSITIVE)
        };
        [way(0).min(way(1)), most(0).min(most(1))]
    }

    /// Distance of a point from the axis about which the table turns, mm; from the blade axis where
    /// there is no table.
    fn off_table_axis_mm(&self, p: &Point) -> f64 {
        self.machine.off_table_axis_mm(p).unwrap_or_else(|| p.y.hypot(p.z))
    }

    /// Both tools.
    pub fn pinch_tools(&self) -> [&Tool; 2] {
        [&self.job.tool, self.job.tool_2.as_ref().unwrap_or(&self.job.tool)]
    }

    /// Speeds of both spindles, 1/min.
    pub fn pinch_spindles_rpm(&self) -> [f64; 2] {
        let first = self.job.post.spindle_rpm;
        [first, self.pinch_settings().spindle_2_rpm.unwrap_or(first)]
    }

    /// The controls that get programs of two tools; none on a machine with one head.
    ///
    /// # Errors
    /// Kind `Usage` where a control has no such programs, or none in which the table may turn while
    /// both tools cut, or two would have the same file.
    pub fn pinch_dialects(&self) -> Result<Vec<(String, Dialect)>> {
        if !self.machine.has_two_heads() {
            return Ok(Vec::new());
        }
        let (dialects, channels) = (self.dialects()?, self.pinch_settings().channels);
        let mut files: Vec<(&str, &str)> = Vec::with_capacity(dialects.len());
        for (name, dialect) in &dialects {
            let file = &post::pinch::pinch_text(dialect, &self.machine, channels)?.file;
            if self.table_may_turn() {
                post::pinch::table_may_turn(dialect, channels, self.pinch_settings().skew_ms)?;
            }
            if let Some((other, _)) = files.iter().find(|(_, f)| f == file) {
                return Err(Error::usage(Stage::Post, format!("{other} and {name} would both write {file}"))
                    .advise("give the section pinch of the post file another `file`, or leave one of the two out"));
            }
            files.push((name, file));
        }
        Ok(dialects)
    }

    /// Whether the table may turn while both tools cut.
    fn table_may_turn(&self) -> bool {
        let asked = self.pinch_settings();
        asked.topology == PinchTopology::DoubleHelix || asked.orientation != PinchOrientation::Hold
    }

    /// The motion of a machine with two heads and its programs, judged: `None` where it has one.
    ///
    /// # Errors
    /// Those of [`Setup::pinch_dialects`], [`motion()`] and [`post::pinch::pinch_programs`].
    pub fn pinch_program(&self, pinch: &Pinch, observer: &dyn Observer) -> Result<Option<PinchProgrammed>> {
        let (dialects, channels) = (self.pinch_dialects()?, self.pinch_settings().channels);
        let Some(motion) = timed(observer, Stage::Feed, || motion(self, pinch, observer))? else { return Ok(None) };
        let checks = verify::check_pinch_motion(&motion, &self.machine);
        let posted = dialects.into_iter().map(|(control, dialect)| {
            let files = self.pinch_files(&dialect, &motion, channels)?;
            let checks = self.read_back_pinch(&dialect, &files, pinch, &motion);
            Ok(PinchPosted { control, files, checks })
        });
        let programs = posted.collect::<Result<_>>()?;
        Ok(Some(PinchProgrammed { motion, checks, programs }))
    }

    /// The programs of a motion in a dialect, for so many channels.
    ///
    /// # Errors
    /// Those of [`post::pinch::pinch_programs`].
    pub fn pinch_files(&self, dialect: &Dialect, motion: &PinchMotion, channels: u32) -> Result<Vec<PinchFile>> {
        let options = self.post_options();
        post::pinch::pinch_programs(
            dialect,
            &PinchProgram {
                name: &options.program_name,
                part_file: &options.part_file,
                part_hash: &options.part_hash,
                machine: &self.machine,
                motion,
                settings: &options.settings,
                tools: self.pinch_tools(),
                spindle_rpm: self.pinch_spindles_rpm(),
                channels,
                skew_ms: self.pinch_settings().skew_ms,
            },
        )
    }

    /// What reading the programs of a control back finds.
    pub fn read_back_pinch(
        &self,
        dialect: &Dialect,
        files: &[PinchFile],
        pinch: &Pinch,
        motion: &PinchMotion,
    ) -> Vec<Check> {
        let texts: Vec<&str> = files.iter().map(|f| f.text.as_str()).collect();
        let work = self.pinch_work(pinch);
        let asked = PinchAsked {
            cutting_s: motion.cutting_s,
            spindle_rpm: self.pinch_spindles_rpm(),
            tolerance_mm: post::pinch::tolerance_mm(dialect, &self.job.post),
            skew_s: self.pinch_settings().skew_ms.map(|ms| 1e-3 * ms),
        };
        verify::check_pinch_program(&texts, &work, &self.machine, &asked, &self.verify_options())
    }

    /// What the checks look at.
    pub fn pinch_work<'a>(&'a self, pinch: &'a Pinch) -> PinchWork<'a> {
        let asked = self.pinch_settings();
        PinchWork {
            blade: &self.blade,
            obstacles: &self.obstacles,
            tools: self.pinch_tools(),
            cones: self.pinch_cones(),
            between_rad: pinch.between_rad,
            rows: &pinch.rows,
            held: &pinch.held,
            tools_apart_mm: asked.tools_apart_mm,
            line_distance_mm: asked.line_distance_mm,
            max_angle_rad: asked.max_angle_deg.to_radians(),
        }
    }

    /// The angle of the second head over the first: the machine's where it has two.
    fn between_heads(&self, asked: &PinchSettings, cones: [Cone; 2]) -> Result<f64> {
        let own = self.machine.between_heads(cones.map(|c| c.lean_rad))?;
        let Some(typed) = asked.between_deg.map(f64::to_radians) else { return Ok(own.unwrap_or(PI)) };
        match own.filter(|own| within_half_turn(typed - own).abs() > SAME_RAD) {
            None => Ok(typed),
            Some(own) => {
                let message = format!(
                    "pinch.between_deg is {}, but the second head of {} stands {:.3}° on from the first",
                    typed.to_degrees(),
                    self.machine.name,
                    own.to_degrees()
                );
                Err(Error::usage(Stage::Machine, message).advise("leave pinch.between_deg out"))
            }
        }
    }

    /// What is free for a tool at all places of rows, by its own angle.
    fn free_angles(
        &self,
        around: &Surroundings,
        rows: &PairedRows,
        (side, cone): (usize, Cone),
        observer: &dyn Observer,
    ) -> Result<Vec<FreeAngles>> {
        let path = rows.toolpath(side, Cones::Same(cone));
        let usual = self.channel_options();
        // The second head's angle is not the table's.
        let theta_limits_rad = usual.theta_limits_rad.filter(|_| side == 0);
        let options = ChannelOptions { sweep: Sweep::Swing, travel: Vec::new(), theta_limits_rad, ..usual };
        let found = channel::intervals(around, self.pinch_tools()[side], &path, &options, observer)?;
        Ok(found.iter().map(|free| FreeAngles::of(free.iter().map(|f| [f.theta_min, f.theta_max]))).collect())
    }
}

/// What both tools can do along rows.
struct Shared {
    rows: PairedRows,
    cut_off: usize,
    own: [Vec<FreeAngles>; 2],
    common: Vec<FreeAngles>,
    planned: Planned,
    /// Where they were asked for.
    postures: Option<Postures>,
}

/// What is in the way of both tools.
struct AroundBoth<'a> {
    first: Surroundings<'a>,
    /// Where the second ball is another.
    other: Option<Surroundings<'a>>,
}

impl<'a> AroundBoth<'a> {
    fn of(&self, tool: usize) -> &Surroundings<'a> {
        self.other.as_ref().filter(|_| tool == 1).unwrap_or(&self.first)
    }
}

/// The same angles on turns within the limits of the table, rad, where it has some.
fn within_turns(held: Vec<Held>, limits_rad: Option<[f64; 2]>) -> Vec<Held> {
    let Some([least, _]) = limits_rad else { return held };
    let turned = |h: Held| {
        let [first, _] = h.ends_rad();
        let by = least + (first - least).rem_euclid(TAU) - first;
        Held { theta_rad: h.theta_rad.iter().map(|theta| theta + by).collect(), ..h }
    };
    held.into_iter().map(turned).collect()
}

/// No row has two places.
fn no_rows(rows: &PairedRows) -> Error {
    let message = format!("no row for two tools has two places: {}", rows.ends_in_words());
    Error::infeasible(Stage::Path, message, Infeasible::NoPairs).advise("one tool can machine the blade")
}

/// No angle is free for both at a place.
fn closed(rows: &PairedRows, own: &[Vec<FreeAngles>; 2], both: &Both, place: usize) -> Error {
    let row = rows.rows.partition_point(|r| r.end <= place);
    let height_mm = rows.places[place].contacts[0].centre.x;
    let degrees = |free: &FreeAngles| free.arcs().iter().map(|a| a.map(f64::to_degrees)).collect::<Vec<_>>();
    let free_deg = [degrees(&own[0][place]), degrees(&own[1][place])];
    let said = |arcs: &[[f64; 2]]| match arcs {
        [] => "no angle".to_owned(),
        _ => arcs.iter().map(|[a, b]| format!("{a:.1}° to {b:.1}°")).collect::<Vec<_>>().join(", "),
    };
    // How far apart the tools can be there at angles that are free for both.
    let here = [&rows.places[place]; 2];
    let common = own[0][place].and(&own[1][place]);
    let angles = (0..360).map(|k| f64::from(k).to_radians()).filter(|theta| common.has(*theta));
    let apart_mm = angles.map(|theta| both.apart(here, [theta; 2]).least_mm).fold(f64::NEG_INFINITY, f64::max);
    let tools = if apart_mm.is_finite() {
        format!("; at what is free for both the tools are at most {apart_mm:.3} mm apart")
    } else {
        String::new()
    };
    let (of, other) = match rows.is_double_helix() {
        true => ("on the double helix".to_owned(), "region.end_mm above this height"),
        false => (format!("in row {}", row + 1), "other pinch.heights_mm"),
    };
    let message = format!(
        "no angle of the table is free for both tools {of} at height {height_mm:.3} mm, or from there to the place beside it: tool 1 is \
         clear at {}, tool 2 at {}{tools}",
        said(&free_deg[0]),
        said(&free_deg[1])
    );
    Error::infeasible(Stage::Channel, message, Infeasible::NoCommonAngle { row, height_mm, free_deg })
        .advise(format!("try other leans (machine.b_deg, pinch.b_2_deg), a longer or slimmer tool, or {other}"))
}
