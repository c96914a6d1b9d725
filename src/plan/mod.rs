//! The stages in order, in memory: a job, a blade and a machine in; a checked plan and programs as
//! text out.
//!
//! **In** [`Setup`]: all that stands still during a plan. **Out** [`Plan`] with its [`Verdict`],
//! and
//! [`Setup::program`]: the text of a program. **Method** The stages follow one another; where the
//! channel closes or the schedule comes too near between locations, path, channel and schedule are
//! planned again ([`stages()`]). **Guarantees** No file is read or written; folders, times and
//! manifests are those of [`crate::run`]. The observer gets the begin and end of each stage.
//! **Fails** with the error of the stage, and with kind `Cancelled` when the observer asks to stop.
//!
//! [`stages()`]: planning::stages

use std::path::Path;

use crate::artifact::blade::Blade;
use crate::artifact::region::{Boundary, Extent};
use crate::artifact::report::Check;
use crate::artifact::schedule::ScheduleKind;
use crate::artifact::toolpath::{PathKind, Start};
use crate::artifact::{AxisMotion, AxisTravel, Cone, Obstacle, PartAmong, Plan, Program, Schedule, Sweep, Wheel};
use crate::channel::{ChannelOptions, ChannelSettings};
use crate::error::{Error, Result, Stage};
use crate::feed::FeedOptions;
use crate::job::{Chosen, Draft, Job};
use crate::machine::Machine;
use crate::observe::{Observer, Warning};
use crate::path::PathOptions;
use crate::read::model::openings::{self, ToolReach};
use crate::read::model::recognise::named;
use crate::schedule::ScheduleOptions;
use crate::section::SectionOptions;
use crate::smooth::{Aim, SmoothOptions};
use crate::tool::Chip;
use crate::tool::inclination::Inclined;
use crate::verify::{self, Asked, Verdict, Verified, VerifyOptions, Workspace};
use crate::write::post::{self, Dialect, PostOptions};

mod around;
pub(crate) mod discs;
mod doubts;
mod even;
mod free_axes;
pub(crate) mod leads;
mod links;
mod orientation;
pub(crate) mod paths;
pub mod pinch;
pub(crate) mod planning;
pub(crate) mod schedules;
pub(crate) mod sketch;
pub(crate) mod smoothing;
mod wheel;

use planning::{KnownStages, Reached};

/// A machine without Y can bring the tool everywhere only where that would stand still.
fn keeps_offset(job: &Job, machine: &Machine) -> Result<()> {
    let Some(missing) = machine.missing() else { return Ok(()) };
    let travels = machine.travels(job.machine.b_deg.to_radians(), job.tool.length_mm());
    let is_missing = |t: &AxisTravel| t.column.is_some_and(|k| machine.axes()[k].is_missing);
    let stands = travels.iter().any(|t| is_missing(t) && t.as_offsets().is_some());
    if job.orientation.kind.goes_round() && stands {
        return Ok(());
    }
    let message = format!(
        "the machine {} has no {}, and would need it: only where the blade turns about its own axis, square to that of {}, and the tool \
         keeps one lean does {} stand still",
        machine.name, missing.name, missing.name, missing.name
    );
    Err(Error::usage(Stage::Machine, message).advise("take a machine with X, Y and Z, or leave out orientation.kind"))
}

/// A blade with everything that stands still during a plan.
pub struct Setup {
    /// The job, complete.
    pub job: Job,
    /// Its tool, and why it is this one.
    pub tool: Chosen,
    /// The blade.
    pub blade: Blade,
    /// The machine.
    pub machine: Machine,
    /// Where turns are to begin, blade frame, mm; `None`: where the path stage thinks best.
    pub start_near: Option<[f64; 3]>,
    /// One flag for each face at which the helix ends; empty where the job names none.
    pub end_faces: Vec<bool>,
    /// Own post files of the job.
    pub post_files: Vec<Dialect>,
    /// Other blades of the wheel and its hub, fixtures and stock.
    pub obstacles: Vec<Obstacle>,
    /// The wheel, where the job has one.
    pub wheel: Option<Wheel>,
    /// BLAKE3 hash of the model's file, which programs name; empty where the model came from no
    /// file.
    pub part_hash: String,
}

impl Setup {
    /// Completes the job for a blade and a machine. Fixtures and stock, own post files and the
    /// model's hash are left out, for the caller to add.
    ///
    /// # Errors
    /// Those of the job.
    pub fn of(draft: &Draft, blade: Blade, machine: Machine, observer: &dyn Observer) -> Result<Setup> {
        let blade = draft.over_hub(blade)?;
        let (job, tool) = draft.on_machine(&machine)?.settle(&blade).map_err(|e| doubts::blamed_on_axis(e, &blade))?;
        for doubt in &tool.warnings {
            observer.warn(Warning { stage: Stage::Job, doubt: doubt.clone() });
        }
        let wheel = job.wheel.as_ref().map(|w| wheel::of(w, &blade)).transpose()?;
        let machine = match &wheel {
            Some(wheel) if !job.orientation.kind.goes_round() => machine.with_rotor(&wheel.axis, &wheel.origin),
            _ => machine,
        };
        keeps_offset(&job, &machine)?;
        if job.orientation.kind.goes_round() {
            machine.check_lean(job.machine.b_deg.to_radians())?;
        }
        if let Some(doubt) = doubts::out_of_reach(job.feed.feed_mm_min, &machine) {
            observer.warn(Warning { stage: Stage::Feed, doubt });
        }
        for doubt in openings::check(&blade, &reach(&job, &blade))? {
            observer.warn(Warning { stage: Stage::Model, doubt });
        }
        let start_near = match job.path.start {
            Start::Concave => None,
            Start::TrailingEdge => paths::trailing_edge(&blade, job.region.start_mm, observer)?,
        };
        let end_faces = named::faces_of(&job.region.end_faces, &blade.part)?;
        let (blade, obstacles) = match (&wheel, &job.wheel) {
            // A model of the whole wheel has them.
            (Some(wheel), Some(settings)) if !blade.wheel.is_some_and(|w| w.whole) => {
                let next_too = job.path.kind == PathKind::HubRows;
                let bodies = wheel::bodies(wheel, settings, &blade, &job.channel, next_too)?;
                let blade = if next_too { wheel::with_next(wheel, blade, observer)? } else { blade };
                (blade, bodies)
            }
            _ => (blade, Vec::new()),
        };
        let (post_files, part_hash) = (Vec::new(), String::new());
        Ok(Setup { job, tool, blade, machine, start_near, end_faces, post_files, obstacles, wheel, part_hash })
    }

    /// Options of the sections as the job has them.
    pub fn section_options(&self) -> SectionOptions {
        SectionOptions { settings: self.job.section, ..SectionOptions::default() }
    }

    /// Options of the path as the job has them.
    pub fn path_options(&self) -> PathOptions {
        let r = &self.job.region;
        let hub_is_aside = self.job.wheel.as_ref().is_some_and(|w| !w.hub_mm.is_empty());
        let faces = self.end_faces.contains(&true).then(|| Boundary::Faces(self.end_faces.clone()));
        let ends = r.end_mm.map(Boundary::Height).into_iter().chain(faces);
        PathOptions {
            settings: self.job.path.clone(),
            radius_mm: self.job.tool.corner_mm(),
            inclined: self.inclined(),
            start_near: self.start_near,
            extent: Extent { ends: ends.collect(), ..Extent::heights(Some(r.start_mm), None) },
            hub_of: self.hub_of(),
            hub_clearance_mm: hub_is_aside.then_some(self.job.channel.clearance_mm),
            lean_rad: self.job.machine.b_deg.to_radians(),
        }
    }

    /// The wheel over whose hub the path is to go.
    fn hub_of(&self) -> Option<Wheel> {
        self.wheel.filter(|_| self.job.path.kind == PathKind::HubRows)
    }

    /// How a cutter with a corner leans; `None`: a ball.
    fn inclined(&self) -> Option<Inclined> {
        let job = &self.job;
        let contact_deg = [job.channel.contact_angle_min_deg, job.channel.contact_angle_max_deg];
        Inclined::new(&job.tool, contact_deg, Cone::about_blade(job.machine.b_deg.to_radians()))
    }

    /// Options of the channel as the job and the machine have them.
    pub fn channel_options(&self) -> ChannelOptions {
        let contact_angle_min_deg = self.least_contact_deg();
        let settings = ChannelSettings { contact_angle_min_deg, ..self.job.channel.clone() };
        let theta_limits_rad = self.theta_limits();
        let (travel, sweep) = (self.travel(), self.sweep());
        ChannelOptions { settings, theta_limits_rad, travel, sweep, ..ChannelOptions::default() }
    }

    /// How θ goes along the path.
    fn sweep(&self) -> Sweep {
        match (self.job.orientation.kind.goes_round(), self.job.tool.is_ball()) {
            // A narrow window of contact angle turns back where the normal does; a blade that turns
            // evenly never does.
            (true, false) if self.job.schedule.kind != ScheduleKind::Even => Sweep::Follow,
            (true, _) => Sweep::Round,
            (false, _) => Sweep::Swing,
        }
    }

    /// Travel of linear axes as limits of θ, where the tool goes round with one lean: the range of
    /// offsets that the job asks for, and the machine's. An offset that stays is chosen within the
    /// range of the axis that then stands still, which may be one place.
    fn travel(&self) -> Vec<AxisTravel> {
        let stays = self.job.schedule.kind == ScheduleKind::Eccentric;
        let asked = self.job.channel.offset_mm.map(|range| AxisTravel::of_offset("Y (channel.offset_mm)", range));
        let all = asked.into_iter().chain(self.machine_travel());
        all.filter(|t| self.job.orientation.kind.goes_round() && !(stays && t.as_offsets().is_some())).collect()
    }

    /// Paths and channels of a part that does not turn freely on the machine are planned without
    /// the machine's room.
    fn machine_travel(&self) -> Vec<AxisTravel> {
        if self.machine.check_swing(&self.blade.part.mesh.points).is_err() {
            return Vec::new();
        }
        self.machine.travels(self.job.machine.b_deg.to_radians(), self.job.tool.length_mm())
    }

    /// Offsets of the tool from the blade axis that job and machine allow, mm.
    fn offset_range_mm(&self) -> Option<[f64; 2]> {
        let machine = self.machine_travel().iter().find_map(AxisTravel::as_offsets);
        // What is left for rounding to an axis that the machine has not is no room for the plan.
        let machine = machine.map(|[a, b]| if self.machine.missing().is_some() { [0.5 * (a + b); 2] } else { [a, b] });
        let both = self.job.channel.offset_mm.into_iter().chain(machine);
        both.reduce(|a, b| [a[0].max(b[0]), a[1].min(b[1])])
    }

    /// What the teeth may cut; the job has been checked.
    fn chip(&self) -> Option<Chip> {
        self.job.chip().ok().flatten()
    }

    /// The least contact angle by the channel and by the cutting speed, degrees.
    fn least_contact_deg(&self) -> f64 {
        let own = self.job.channel.contact_angle_min_deg;
        self.chip().map_or(own, |chip| own.max(chip.least_angle_rad.to_degrees()))
    }

    /// θ at the ends of travel of the axis that turns the blade, rad.
    fn theta_limits(&self) -> Option<[f64; 2]> {
        let lean_rad = self.job.machine.b_deg.to_radians();
        self.machine.theta_limits(lean_rad).filter(|_| self.job.orientation.kind.goes_round())
    }

    /// Options of the schedule as the job and the machine have them.
    pub fn schedule_options(&self) -> ScheduleOptions {
        let pace = Some(schedules::pace(&self.machine, self.job.feed.feed_mm_min));
        let offset_range_mm = self.offset_range_mm();
        let disc_radius_mm = self.job.tool.disc_radius_mm();
        let usual = ScheduleOptions::default();
        ScheduleOptions { settings: self.job.schedule, pace, offset_range_mm, disc_radius_mm, ..usual }
    }

    /// Options of the smooth curve as the job has them: at most a third of the limit of gouges, or
    /// as many polynomials as `feed.fit_mm` needs.
    pub fn smooth_options(&self) -> SmoothOptions {
        let usual = SmoothOptions::default();
        let usual = match self.blade.part.brep {
            Some(_) => usual,
            None => usual.on_mesh(self.job.path.scallop_mm),
        };
        let margin_rad = self.job.schedule.margin_deg.to_radians();
        match self.job.feed.fit_mm {
            Some(fit_mm) => {
                SmoothOptions { inwards_mm: fit_mm, outwards_mm: fit_mm, margin_rad, aim: Aim::Fewest, ..usual }
            }
            None => {
                let inwards_mm = usual.inwards_mm.min(self.job.verify.gouge_mm / 3.0).max(1e-6);
                SmoothOptions { inwards_mm, margin_rad, ..usual }
            }
        }
    }

    /// Options of the feed as the job has them.
    pub fn feed_options(&self) -> FeedOptions {
        let usual = FeedOptions::new(self.job.feed.feed_mm_min, self.job.tool.length_mm());
        let contact_mm_s = self.chip().map(|chip| chip.contact_mm_s[1]).filter(|most| most.is_finite());
        FeedOptions { settings: self.job.feed, chord_mm: self.job.path.chord_mm, contact_mm_s, ..usual }
    }

    /// Limits of the checks, as the job has them.
    pub fn verify_options(&self) -> VerifyOptions {
        let c = &self.job.channel;
        VerifyOptions {
            settings: self.job.verify,
            scallop_mm: self.job.path.scallop_mm,
            clearance_mm: c.clearance_mm,
            holder_clearance_mm: c.holder_clearance_mm,
            asked: Some(self.asked()),
            ..VerifyOptions::default()
        }
    }

    /// What a plan is to hold of the job.
    fn asked(&self) -> Asked {
        let (job, b_rad) = (&self.job, self.job.machine.b_deg.to_radians());
        let (p, c) = (&job.path, &job.channel);
        Asked {
            kind: p.kind,
            direction: p.direction,
            radius_mm: job.tool.corner_mm(),
            stock_mm: p.stock_mm,
            chord_mm: p.chord_mm,
            start_mm: job.region.start_mm,
            end_mm: job.region.end_mm,
            max_lean_rad: p.max_lean_deg.to_radians(),
            b_rad: self.job.orientation.kind.goes_round().then_some(b_rad),
            contact_rad: [self.least_contact_deg(), c.contact_angle_max_deg].map(f64::to_radians),
            theta_limits_rad: self.theta_limits(),
            tolerance_rad: c.tolerance_deg.to_radians(),
            schedule: job.schedule.kind,
            feed_mm_min: job.feed.feed_mm_min,
            lead_radius_mm: job.feed.lead_radius_mm,
            offset_mm: c.offset_mm,
            chip: self.chip(),
            hub_of: self.hub_of(),
        }
    }

    /// What programs say in their headers.
    pub fn post_options(&self) -> PostOptions {
        let file = self.job.model.file.file_name().map(|f| f.to_string_lossy().into_owned()).unwrap_or_default();
        PostOptions {
            settings: self.job.post.clone(),
            program_name: program_name(&self.blade.name),
            part_file: file,
            part_hash: self.part_hash.clone(),
            job: "job.resolved.toml".into(),
            ..PostOptions::default()
        }
    }

    /// The dialects that programs are to be written in, with the names of their controls or files.
    ///
    /// # Errors
    /// Those of the built-in dialects; they pass.
    pub fn dialects(&self) -> Result<Vec<(String, Dialect)>> {
        let built_in = self.job.post.control.iter().map(|c| Ok((c.to_string(), Dialect::built_in(*c)?)));
        let own = self.job.post.files.iter().map(|f| post_name(f)).zip(self.post_files.iter().cloned()).map(Ok);
        built_in.chain(own).collect()
    }

    /// No two programs have the same file.
    ///
    /// # Errors
    /// Kind `Usage`, naming both controls or post files.
    pub fn check_program_names(&self) -> Result<()> {
        different_files(&self.dialects()?)
    }

    /// A plan judged by all checks.
    ///
    /// # Errors
    /// Those of [`verify::check_among`].
    pub fn verdict(&self, plan: Plan, observer: &dyn Observer) -> Result<Verdict<Plan>> {
        let (blade, obstacles) = (&self.blade, &self.obstacles[..]);
        let workspace = Workspace { blade, obstacles, tool: &self.job.tool, machine: &self.machine };
        verify::check_among(plan, &workspace, &self.verify_options(), observer)
    }

    /// The part with what stands about it.
    pub fn part_among(&self) -> PartAmong<'_> {
        PartAmong { blade: &self.blade, obstacles: &self.obstacles }
    }

    /// A checked plan as a program, and what reading the program back found.
    ///
    /// # Errors
    /// Those of [`post::post`] and of [`verify::read_back::read_back`].
    pub fn program(&self, dialect: &Dialect, verified: &Verified<Plan>) -> Result<(Program, Vec<Check>)> {
        let (part, tool, machine) = (self.part_among(), &self.job.tool, &self.machine);
        let program = post::post(dialect, verified, part, tool, machine, &self.post_options())?;
        let checks = verify::read_back::read_back(&program, verified.value(), part, tool, machine)?;
        Ok((program, checks))
    }
}

/// No two of the dialects, with the names of their controls or files, write the same file.
///
/// # Errors
/// Kind `Usage`, naming both.
pub fn different_files(dialects: &[(String, Dialect)]) -> Result<()> {
    for (k, (name, dialect)) in dialects.iter().enumerate() {
        let file = dialect.file_name();
        if let Some((other, _)) = dialects[..k].iter().find(|(_, d)| d.file_name() == file) {
            return Err(Error::usage(Stage::Post, format!("{other} and {name} would both write {file}"))
                .advise("give the post file another name in `file`, or leave one of the two out"));
        }
    }
    Ok(())
}

/// What wrote a program, in the manifest: an own post file by its name, wherever it lies.
pub fn post_name(file: &Path) -> String {
    file.file_name().unwrap_or_default().to_string_lossy().into_owned()
}

/// Heights that the tool can take: ball centres run from the region's start to its end or, where
/// that is left out, at most one ball radius below the airfoil.
fn reach(job: &Job, blade: &Blade) -> ToolReach {
    let r = &job.region;
    let end_mm = r.end_mm.unwrap_or(blade.regions.airfoil_x_mm()[0] - job.tool.radius_mm);
    let clearance_mm = job.channel.clearance_mm.max(job.channel.holder_clearance_mm);
    ToolReach::new(&job.tool, [r.start_mm, end_mm], job.machine.b_deg.to_radians(), clearance_mm)
}

/// A name that every control accepts: capitals, digits and underscores, beginning with a letter.
pub fn program_name(name: &str) -> String {
    let clean: String =
        name.chars().map(|c| if c.is_ascii_alphanumeric() { c.to_ascii_uppercase() } else { '_' }).take(24).collect();
    if clean.starts_with(|c: char| c.is_ascii_alphabetic()) { clean } else { format!("B_{clean}") }
}

/// A baseline beside the schedule in use.
#[derive(Clone, Debug)]
pub struct Baseline {
    /// The schedule.
    pub schedule: Schedule,
    /// Its axis motion under the same limits.
    pub motion: AxisMotion,
}

/// Plans and checks.
///
/// # Errors
/// The first stage's that fails; kind `Cancelled` where the observer asks to stop.
pub fn plan(setup: &Setup, observer: &dyn Observer) -> Result<Verdict<Plan>> {
    match planning::stages(setup, None, KnownStages::default(), observer)? {
        Reached::Motion(planned) => setup.verdict(planned.0, observer),
        _ => Err(Error::usage(Stage::Feed, "planning ended before the motion")),
    }
}

/// The plan as evidence: passed, or failed and forced.
pub fn accept(verdict: Verdict<Plan>, force: bool) -> Option<Verified<Plan>> {
    match verdict {
        Verdict::Passed(v) => Some(v),
        Verdict::Failed(r) if force => Some(r.write_anyway()),
        Verdict::Failed(_) => None,
    }
}
