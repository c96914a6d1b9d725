//! A program judged by itself: no plan, whoever wrote it.
//!
//! **In**: the text of an NC program, how its words are meant ([`Bench`]: dialect, zero, tool,
//! machine), the [`Blade`]. **Out**: an [`Audit`]: checks, each with the worst place by line of the
//! program, turn and point of the model.
//!
//! The text is read by [`crate::read::program::read`], the machine is moved through it
//! ([`crate::read::program::follow`]), and the motion is cut into [`legs`] short enough that the
//! ball centre goes straight, θ and B evenly. Then
//!
//! | check | measured | bound between samples |
//! | --- | --- | --- |
//! | `contact` | share of the feed legs in which the ball is at the part: none, and the program machines something else | |
//! | `gouge` | depth of the swept ball in the part in feed moves | exact ([`super::gouge`]) |
//! | `rapid` | least distance of the whole tool to the part in rapids | Taylor ([`super::solid`]), exact for the ball |
//! | `clearance`, `holder-clearance` | least distance of taper and shank, and of the holder, in feed moves | Taylor |
//! | `x-travel` … `b-travel` | positions of the axes, rapids and feed moves alike | parabola through three places of a leg |
//! | `scallop`, `scallop-turn` | height left between neighbouring passes ([`scallop`]): all over, and turn by turn | samples |
//! | `x-velocity` … `b-velocity` | what the programmed feeds ask of the axes, leg by leg | mean over a leg |
//! | `end` | whether the program ends, and lines behind its end, which are not machined | |
//! | `tool`, `tool-length`, `spindle`, `smoothing` | in feed moves at the part: other tools than the given one, a length offset that is off, another tool's or changed, the spindle off or turning the wrong way, a tolerance of the control's wider than the greater of gouge and scallop allowed | |
//! | `b-sign`, `a-sense` | only after a gouge, a touch or no contact: whether all would be well with the other sign of B, or of A | |
//!
//! A cutter with a corner is judged by the same checks, with [`super::cutter`] in the place of
//! [`super::gouge`]: it is what the corner leaves that is called the ball's. Its ridges are those
//! of [`super::cutter::ridges`].
//!
//! **Limits**: rapids are taken as straight in whatever the block programs; which forms of programs
//! are read: [`crate::read::program`]; the control's own smoothing is not known but for
//! its tolerance; accelerations are not judged, since the control slows down where it must. Moves
//! before the program has said where every axis stands are not looked at, and counted. θ need not
//! grow and nothing is asked of the order of passes.

mod blame;
mod checks;
#[cfg(test)]
mod cutter_tests;
pub(super) mod legs;
mod line_check;
mod plans;
mod report;
pub(super) mod scallop;
#[cfg(test)]
mod tests;

pub use line_check::{LineCheck, LineRun};
pub use plans::{ProgramPlans, as_plans};
pub use report::Audit;

use std::cell::RefCell;

use legs::{LegKind, Legs};

use super::between::NEAR_MM;
use super::cutter::{self, SweptCutter};
use super::deviation::{self, ToolCut};
use super::gouge::{self, Gouge};
use super::options::CLEARANCE_RESOLUTION_MM;
use super::settings::VerifySettings;
use super::sweep::Sweep;
use crate::artifact::deviation::DeviationMap;
use crate::artifact::report::Check;
use crate::artifact::{Blade, CheckId, PartAmong};
use crate::error::{Error, Result, Stage};
use crate::geometry::allowance::Allowed;
use crate::geometry::near_disc::DiscSearch;
use crate::geometry::part::Part;
use crate::observe::Observer;
use crate::parallel;
use crate::read::program::{self, Bench, Block, Script};
use crate::settings::with_settings;
use crate::tool::Tool;

/// Limits and sampling of [`audit`]. Lengths in mm.
#[derive(Clone, Debug, PartialEq)]
pub struct AuditOptions {
    /// Those that checks of plans have as well, at the job's defaults.
    pub settings: VerifySettings,
    /// Greatest scallop, mm; `None` (the default): measured, not judged.
    pub scallop_mm: Option<f64>,
    /// The 95th percentile of the scallop over one turn may be this many times `scallop_mm`.
    /// Default 1.25.
    pub turn_ratio: f64,
    /// Stock that is to stay on the part, mm. Default 0.
    pub stock_mm: f64,
    /// What the checks of clearance may miss between two samples, mm: by default as in plans.
    pub clearance_resolution_mm: f64,
    /// Clearances at a feed are measured to a thousandth and half a micrometre, on triangles that
    /// are nearer to the exact faces: what two programs keep can be compared. Default false.
    pub clearance_closely: bool,
    /// Tolerance of the deviation map, mm; `None` (the default): no map.
    pub map_mm: Option<f64>,
}

with_settings!(AuditOptions, VerifySettings);

impl Default for AuditOptions {
    fn default() -> Self {
        AuditOptions {
            settings: VerifySettings::default(),
            scallop_mm: None,
            turn_ratio: 1.25,
            stock_mm: 0.0,
            clearance_resolution_mm: CLEARANCE_RESOLUTION_MM,
            clearance_closely: false,
            map_mm: None,
        }
    }
}

/// Checks after whose failure signs are tried.
const AWRY: [CheckId; 4] = [CheckId::Contact, CheckId::Gouge, CheckId::Clearance, CheckId::HolderClearance];

/// Everything the checks look at.
struct AuditScene<'a> {
    blade: &'a Blade,
    part: Allowed<'a>,
    bench: &'a Bench<'a>,
    options: &'a AuditOptions,
    text: &'a str,
    moves: &'a [program::Moved],
    legs: &'a Legs,
    turns: Vec<u32>,
}

/// Moves, and what they were read from.
#[derive(Clone, Copy)]
struct MovesSource<'a> {
    text: &'a str,
    script: &'a Script,
    /// The moves' blocks.
    blocks: &'a [Block],
    moves: &'a [program::Moved],
    /// The last moves of the program are among them.
    last: bool,
}

/// Judges a program.
///
/// # Errors
/// `Usage`: the tool is none, a line is not understood (with its number), a move turns too far to
/// be followed, or no feed move is known from its beginning; `Cancelled`.
pub fn audit(
    text: &str,
    blade: &Blade,
    bench: &Bench,
    options: &AuditOptions,
    observer: &dyn Observer,
) -> Result<Audit> {
    can_judge(bench.tool, options)?;
    let script = program::read(text, bench.language)?;
    let moves = program::follow(&script.blocks, bench)?;
    audit_read((text, &script, &moves), blade, bench, options, observer)
}

/// As [`audit`], of a program that has been read already: its text, its script and its moves.
///
/// # Errors
/// As [`audit`].
pub fn audit_read(
    (text, script, moves): (&str, &Script, &[program::Moved]),
    blade: &Blade,
    bench: &Bench,
    options: &AuditOptions,
    observer: &dyn Observer,
) -> Result<Audit> {
    can_judge(bench.tool, options)?;
    let source = MovesSource { text, script, blocks: &script.blocks, moves, last: true };
    let (audit, cut) = audit_moves(&source, blade, bench, options, observer)?;
    Ok(Audit { map: map(blade, options, &[cut]), ..audit })
}

/// Whether what is asked for can be judged with a tool.
///
/// # Errors
/// `Usage`: the tool is none; with a cutter that is no ball a map, or gouges as deep as its corner.
fn can_judge(tool: &Tool, options: &AuditOptions) -> Result<()> {
    tool.validate()?;
    if tool.is_ball() {
        return Ok(());
    }
    if options.map_mm.is_some() {
        tool.ball_only("deviation maps are made")?;
    }
    let corner = tool.corner_mm();
    let gouge_mm = options.settings.gouge_mm;
    if !(gouge_mm < corner) {
        let what = format!("gouges of {gouge_mm} mm are allowed, the corner of the cutter is {corner} mm");
        return Err(Error::usage(Stage::Verify, what).advise("allow less than the corner radius"));
    }
    Ok(())
}

/// What all cuts together leave.
fn map(blade: &Blade, options: &AuditOptions, cuts: &[ToolCut]) -> Option<DeviationMap> {
    let part = Allowed::new(&blade.part, options.stock_mm);
    options.map_mm.map(|tolerance| deviation::measure(&part, cuts, tolerance))
}

/// Judges a program of several operations, with a tool for each tool call in their order: an audit
/// of each. The moves from one operation to the next belong to the first, up to the tool call. What
/// one leaves between its passes is judged by itself; the map, of what all of them together leave,
/// is the last one's.
///
/// # Errors
/// As [`audit`] of each, and where the program does not call as many tools.
pub fn audit_each(
    text: &str,
    blade: &Blade,
    benches: &[Bench],
    options: &AuditOptions,
    observer: &dyn Observer,
) -> Result<Vec<Audit>> {
    for bench in benches {
        can_judge(bench.tool, options)?;
    }
    let Some(first) = benches.first() else {
        return Err(Error::usage(Stage::Verify, "a program needs a tool to be judged"));
    };
    let script = program::read(text, first.language)?;
    let moves = program::follow_each(&script.blocks, benches)?;
    let (mut audits, mut cuts) = (Vec::new(), Vec::new());
    let end = script.blocks.len();
    for (bench, moves) in benches.iter().zip(&moves) {
        let last = moves.last().is_some_and(|m| m.block + 1 == end);
        let source = MovesSource { text, script: &script, blocks: script.blocks_of(moves), moves, last };
        let (audit, cut) = audit_moves(&source, blade, bench, options, observer)?;
        audits.push(audit);
        cuts.push(cut);
    }
    if let Some(last) = audits.last_mut() {
        last.map = map(blade, options, &cuts);
    }
    Ok(audits)
}

fn audit_moves(
    source: &MovesSource,
    blade: &Blade,
    bench: &Bench,
    options: &AuditOptions,
    observer: &dyn Observer,
) -> Result<(Audit, ToolCut)> {
    let step = |done: usize| {
        observer.progress(Stage::Verify, done, 5);
        observer.check(Stage::Verify)
    };
    step(0)?;
    let (text, moves) = (source.text, source.moves);
    let legs = Legs::new(moves, bench)?;
    if !legs.legs.iter().any(|l| l.kind == LegKind::Cut) {
        return Err(Error::usage(Stage::Verify, "the program has no feed move that is known from its beginning")
            .advise("its first moves must say X, Y and Z"));
    }
    let part = Allowed::new(&blade.part, options.stock_mm);
    let search = RefCell::new(DiscSearch::new(&part));
    let reach = bench.tool.corner_mm() + part.stock_mm + NEAR_MM;
    let turns = legs.turns(|s| match bench.tool.is_ball() {
        true => part.closest(&s.centre, bench.tool.radius_mm + NEAR_MM).is_some(),
        false => {
            let disc = bench.tool.disc(s.centre, s.axis());
            search.borrow_mut().closest(&disc, reach, 0.1 * NEAR_MM).is_some()
        }
    });
    let scene = AuditScene { blade, part, bench, options, text, moves, legs: &legs, turns };
    let cutting = scene.sweep(LegKind::Cut);
    let passes = scene.passes();
    let mut checks = vec![checks::contact(&scene, &passes), checks::gouge(&scene)];
    step(1)?;
    checks.extend(checks::clearances(&scene));
    step(2)?;
    checks.extend(checks::rapid(&scene));
    checks.extend(checks::travel(&scene));
    checks.extend(checks::velocity(&scene));
    checks.extend(checks::settings(&scene, source, &passes));
    step(3)?;
    let heights = scallop::heights(&scene, &passes);
    checks.extend(scallop::checks(&scene, &heights));
    step(4)?;
    if checks.iter().any(|c| !c.check.passed && AWRY.contains(&c.check.id)) {
        checks.extend(blame::signs(&scene)?);
    }
    step(5)?;
    let widest = scallop::widest_mm(&scene);
    Ok((report::report(&scene, checks, &heights), ToolCut::new(cutting, widest)))
}

/// The check `program-rapids`: the whole tool in the rapids of some moves, to the part and to what
/// stands about it; `None` where none is known from its beginning.
///
/// # Errors
/// As [`audit`] where a move turns too far to be followed.
pub fn rapids(text: &str, moves: &[program::Moved], part: &PartAmong, bench: &Bench) -> Result<Option<Check>> {
    let moves: Vec<program::Moved> = moves.iter().filter(|m| m.seconds.is_none()).copied().collect();
    let (blade, legs) = (part.blade, Legs::new(&moves, bench)?);
    let options = &AuditOptions::default();
    let to = |body: &Part, name: &str| {
        let (part, turns) = (Allowed::new(body, 0.0), vec![0; legs.stands.len()]);
        let found = checks::rapid(&AuditScene { blade, part, bench, options, text, moves: &moves, legs: &legs, turns });
        found.map(|f| {
            let line = f.line.map_or_else(String::new, |l| format!("line {l}; "));
            Check { id: CheckId::ProgramRapids, note: format!("{line}{name}{}", f.check.note), ..f.check }
        })
    };
    let about = part.obstacles.iter().map(|o| to(&o.part, &format!("{}: ", o.name)));
    let all = std::iter::once(to(&blade.part, "")).chain(about).flatten();
    Ok(all.reduce(|least, c| if c.worst < least.worst { c } else { least }))
}

/// The check `program-travel`: every axis over all moves of a program, rapids, approach and retract
/// among them.
///
/// # Errors
/// As [`audit`] where a move turns too far to be followed.
pub fn travel(text: &str, moves: &[program::Moved], blade: &Blade, bench: &Bench) -> Result<Option<Check>> {
    let legs = Legs::new(moves, bench)?;
    let part = Allowed::new(&blade.part, 0.0);
    let (options, turns) = (&AuditOptions::default(), vec![0; legs.stands.len()]);
    let scene = AuditScene { blade, part, bench, options, text, moves, legs: &legs, turns };
    // What fails first, then by how much.
    let rank = |c: &LineCheck| (!c.check.passed, c.check.worst);
    let worst = checks::travel(&scene).into_iter().reduce(|a, b| if rank(&b) > rank(&a) { b } else { a });
    Ok(worst.map(|f| {
        let line = f.line.map_or_else(String::new, |l| format!("line {l}; "));
        let note = if f.check.passed { String::new() } else { format!("{line}{}", f.check.note) };
        let quantity =
            if f.check.passed { "how far an axis leaves its travel".into() } else { f.check.quantity.clone() };
        Check { id: CheckId::ProgramTravel, quantity, note, ..f.check }
    }))
}

impl AuditScene<'_> {
    /// The ball swept over the moves of a kind.
    fn sweep(&self, kind: LegKind) -> Sweep {
        self.sweep_of(self.legs.of(kind))
    }

    /// The deepest gouge of moves, measured to `resolution_mm`; distances to the part are reported
    /// up to `reach_mm` at least.
    fn deepest(&self, wanted: Vec<bool>, resolution_mm: f64, reach_mm: f64) -> Gouge {
        if self.bench.tool.is_ball() {
            return gouge::measure_within(&self.part, &self.sweep_of(wanted), resolution_mm, reach_mm);
        }
        cutter::measure_within(&self.part, &self.swept(&wanted), resolution_mm, reach_mm)
    }

    /// The moves among these that cut deeper than `limit_mm` at an end or in the middle.
    fn deeper_than(&self, wanted: Vec<bool>, limit_mm: f64) -> Vec<usize> {
        if self.bench.tool.is_ball() {
            return gouge::deeper_than(&self.part, &self.sweep_of(wanted), limit_mm);
        }
        cutter::deeper_than(&self.part, &self.swept(&wanted), limit_mm)
    }

    fn swept<'a>(&'a self, wanted: &'a [bool]) -> SweptCutter<'a> {
        SweptCutter { stands: &self.legs.stands, wanted, tool: self.bench.tool }
    }

    /// What the end of the tool is called.
    fn end_name(&self) -> &'static str {
        if self.bench.tool.is_ball() { "ball" } else { "cutter" }
    }

    /// The ball swept over the feed moves along the part: without approach and retract, which are
    /// no passes.
    fn passes(&self) -> Sweep {
        let near = NEAR_MM.max(2.0 * scallop::widest_mm(self));
        let touching: Vec<bool> = if self.bench.tool.is_ball() {
            let reach = self.bench.tool.radius_mm + near;
            parallel::map(&self.legs.stands, |s| self.part.closest(&s.centre, reach).is_some())
        } else {
            cutter::touching(&self.part, &self.legs.stands, self.bench.tool, near)
        };
        let wanted = self.legs.of(LegKind::Cut).into_iter().zip(touching.windows(2));
        self.sweep_of(wanted.map(|(cut, ends)| cut && ends[0] && ends[1]).collect())
    }

    fn sweep_of(&self, wanted: Vec<bool>) -> Sweep {
        let centres: Vec<crate::geometry::Point> = self.legs.stands.iter().map(|s| s.centre).collect();
        Sweep::of(centres.clone(), centres, self.turns.clone(), self.bench.tool.radius_mm, Some(wanted))
    }
}
