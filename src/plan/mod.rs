//! The stages in a straight line: a job in, the files of a run out.

use std::path::{Path, PathBuf};

use crate::artifact::blade::Blade;
use crate::artifact::program::Control;
use crate::artifact::region::{Boundary, Extent};
use crate::artifact::report::Check;
use crate::artifact::toolpath::Start;
use crate::artifact::{AxisMotion, CheckReport, Obstacle, Plan, Program, Schedule};
use crate::channel::ChannelOptions;
use crate::error::{Error, Result, Stage};
use crate::feed::{self, FeedOptions};
use crate::job::{Chosen, Draft, Job, ModelJob};
use crate::machine::Machine;
use crate::observe::{Observer, Recorder, Warning};
use crate::path::PathOptions;
use crate::read::model::openings::{self, Reach};
use crate::read::model::{self, ModelOptions};
use crate::run::RunFolder;
use crate::run::manifest::{self, Clock, Input, Manifest, SCHEMA_VERSION, StageRecord};
use crate::run::summary::{self, ProgramFigures, ScheduleFigures, Summary};
use crate::schedule::ScheduleOptions;
use crate::section::{self, SectionOptions};
use crate::verify::{self, Asked, Verdict, Verified, VerifyOptions};
use crate::write::post::{self, Dialect, PostOptions};
use reuse::Earlier;

pub mod again;
mod around;
mod checking;
pub mod compare;
mod doubts;
mod leads;
mod look;
pub mod operations;
mod paths;
mod planning;
mod programs;
mod repost;
pub mod reuse;
mod schedules;
mod sketch;

pub use look::{plots, preview_again};
use planning::Reached;
pub use programs::programs_again;

/// How far to go and what to do with a plan that fails its checks.
#[derive(Clone, Copy, Debug, Default)]
pub struct Course {
    /// Stop after this stage.
    pub until: Option<Stage>,
    /// Write programs even if the checks fail; their headers say so.
    pub force: bool,
    /// Leave times and memory out of `manifest.json`, so that the same job leaves the same bytes.
    pub timeless: bool,
    /// Most bytes of preview.glb; `None`: as [`GltfOptions`] has it.
    ///
    /// [`GltfOptions`]: crate::write::preview::GltfOptions
    pub preview_bytes: Option<usize>,
}

impl Course {
    fn ends_at(self, stage: Stage) -> bool {
        self.until == Some(stage)
    }
}

/// What a run came to.
pub struct Outcome {
    /// Files written, in order.
    pub files: Vec<PathBuf>,
    /// The tool of the job, and why it is this one.
    pub tool: Chosen,
    /// Figures, where the run went far enough.
    pub summary: Option<Summary>,
    /// What the checks found, where the run went far enough.
    pub report: Option<CheckReport>,
    /// The plan, where the run went far enough.
    pub plan: Option<Plan>,
    /// Time and memory of each stage that was worked on.
    pub stages: Vec<StageRecord>,
    /// Stages whose results were taken over from earlier runs.
    pub taken: Vec<Stage>,
}

/// A blade with everything that stands still during a run.
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
    /// Fixtures and stock.
    pub obstacles: Vec<Obstacle>,
    /// Input files with their hashes: the model first.
    pub inputs: Vec<Input>,
}

impl Setup {
    /// Reads model and machine and completes the job.
    ///
    /// # Errors
    /// Those of reading and of the job.
    pub fn load(draft: &Draft, observer: &dyn Observer) -> Result<Setup> {
        let m = draft.model();
        // Read once: what is planned is what the manifest names.
        let bytes = model::file_bytes(&m.file)?;
        let mut inputs = vec![manifest::input_of(&m.file, &bytes)];
        // A header of a section table has its points in files of their own.
        for file in crate::read::model::table::data_files(&m.file) {
            inputs.push(manifest::input(&file, Stage::Model, "files of the table")?);
        }
        let options = model_options(m);
        let blade = model::load_bytes(&m.file, &bytes, &options, observer)?;
        let machine = match draft.machine_file() {
            Some(file) => {
                inputs.push(manifest::input(file, Stage::Machine, "machine.file")?);
                Machine::load(file)?
            }
            None => Machine::demo()?,
        };
        let mut post_files = Vec::new();
        for file in draft.post_files() {
            inputs.push(manifest::input(file, Stage::Post, "post.files")?);
            post_files.push(Dialect::load(file)?);
        }
        let mut setup = Setup::of(draft, blade, machine, observer)?;
        if let Some(model) = inputs.first_mut() {
            model.path = setup.job.model.file.display().to_string();
        }
        setup.obstacles = around::obstacles(&setup.job, &setup.blade, &mut inputs, observer)?;
        (setup.post_files, setup.inputs) = (post_files, inputs);
        setup.check_program_names()?;
        Ok(setup)
    }

    /// Completes the job for a blade and a machine that are in memory already; no file is read. Obstacles, own post files and inputs are left empty,
    /// for the caller to set.
    ///
    /// # Errors
    /// Those of the job.
    pub fn of(draft: &Draft, blade: Blade, machine: Machine, observer: &dyn Observer) -> Result<Setup> {
        let (job, tool) = draft.settle(&blade).map_err(|e| doubts::blamed_on_axis(e, &blade))?;
        for message in &tool.warnings {
            observer.warn(Warning { stage: Stage::Job, message: message.clone() });
        }
        machine.check_lean(job.machine.b_deg.to_radians())?;
        if let Some(message) = doubts::out_of_reach(job.feed.feed_mm_min, &machine) {
            observer.warn(Warning { stage: Stage::Feed, message });
        }
        for message in openings::check(&blade, &reach(&job, &blade))? {
            observer.warn(Warning { stage: Stage::Model, message });
        }
        let start_near = match job.path.start {
            Start::Concave => None,
            Start::TrailingEdge => paths::trailing_edge(&blade, job.region.start_mm, observer)?,
        };
        let end_faces = model::recognise::named::faces_of(&job.region.end_faces, &blade.part)?;
        let (post_files, obstacles, inputs) = (Vec::new(), Vec::new(), Vec::new());
        Ok(Setup { job, tool, blade, machine, start_near, end_faces, post_files, obstacles, inputs })
    }

    fn section_options(&self) -> SectionOptions {
        SectionOptions { count: self.job.section.count as usize, ..SectionOptions::default() }
    }

    /// Options of the path as the job has them.
    pub fn path_options(&self) -> PathOptions {
        let (p, r) = (&self.job.path, &self.job.region);
        let faces = self.end_faces.contains(&true).then(|| Boundary::Faces(self.end_faces.clone()));
        let ends = r.end_mm.map(Boundary::Height).into_iter().chain(faces);
        PathOptions {
            kind: p.kind,
            radius_mm: self.job.tool.radius_mm,
            direction: p.direction,
            start_near: self.start_near,
            stock_mm: p.stock_mm,
            scallop_mm: p.scallop_mm,
            chord_mm: p.chord_mm,
            max_step_mm: p.max_step_mm,
            extent: Extent { ends: ends.collect(), ..Extent::heights(Some(r.start_mm), None) },
            max_lean_rad: p.max_lean_deg.to_radians(),
            lean_rad: self.job.machine.b_deg.to_radians(),
        }
    }

    /// Options of the channel as the job and the machine have them.
    pub fn channel_options(&self) -> ChannelOptions {
        let c = &self.job.channel;
        ChannelOptions {
            clearance_mm: c.clearance_mm,
            holder_clearance_mm: c.holder_clearance_mm,
            contact_angle_min_rad: c.contact_angle_min_deg.to_radians(),
            contact_angle_max_rad: c.contact_angle_max_deg.to_radians(),
            tolerance_rad: c.tolerance_deg.to_radians(),
            prove_moves: c.prove_moves,
            exact_ends: c.exact_ends,
            theta_limits_rad: self.machine.theta_limits(self.job.machine.b_deg.to_radians()),
            ..ChannelOptions::default()
        }
    }

    fn schedule_options(&self) -> ScheduleOptions {
        let s = &self.job.schedule;
        let pace = Some(schedules::pace(&self.machine, self.job.feed.feed_mm_min));
        ScheduleOptions {
            margin_deg: s.margin_deg,
            lead_deg: s.lead_deg,
            beyond_wall_deg: s.beyond_wall_deg,
            measure: s.measure,
            base_angle: s.base_angle,
            scope: s.scope,
            pace,
            ..ScheduleOptions::default()
        }
    }

    fn feed_options(&self) -> FeedOptions {
        let (feed, gauge) = (self.job.feed.feed_mm_min, self.job.tool.length_mm());
        FeedOptions { chord_mm: self.job.path.chord_mm, ..FeedOptions::new(feed, gauge) }
    }

    /// Limits of the checks, as the job has them.
    pub fn verify_options(&self) -> VerifyOptions {
        let (v, c) = (&self.job.verify, &self.job.channel);
        VerifyOptions {
            gouge_mm: v.gouge_mm,
            scallop_mm: self.job.path.scallop_mm,
            scallop_ratio: v.scallop_ratio,
            clearance_mm: c.clearance_mm,
            holder_clearance_mm: c.holder_clearance_mm,
            resolution_mm: v.resolution_mm,
            surface_samples: v.surface_samples as usize,
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
            radius_mm: job.tool.radius_mm,
            stock_mm: p.stock_mm,
            chord_mm: p.chord_mm,
            start_mm: job.region.start_mm,
            end_mm: job.region.end_mm,
            max_lean_rad: p.max_lean_deg.to_radians(),
            b_rad,
            contact_rad: [c.contact_angle_min_deg, c.contact_angle_max_deg].map(f64::to_radians),
            theta_limits_rad: self.machine.theta_limits(b_rad),
            tolerance_rad: c.tolerance_deg.to_radians(),
            schedule: job.schedule.kind,
            feed_mm_min: job.feed.feed_mm_min,
            lead_radius_mm: job.feed.lead_radius_mm,
        }
    }

    /// What programs say in their headers.
    pub fn post_options(&self) -> PostOptions {
        let p = &self.job.post;
        let file = self.job.model.file.file_name().map(|f| f.to_string_lossy().into_owned()).unwrap_or_default();
        PostOptions {
            program_name: program_name(&self.blade.name),
            part_file: file,
            part_hash: self.inputs.first().map(|model| model.blake3.clone()).unwrap_or_default(),
            job: "job.resolved.toml".into(),
            tool_number: p.tool_number,
            spindle_rpm: p.spindle_rpm,
            approach_feed_mm_min: p.approach_feed_mm_min,
            plunge_feed_mm_min: p.plunge_feed_mm_min,
            feed_height_mm: p.feed_height_mm,
            safe_clearance_mm: p.safe_clearance_mm,
            smoothing_mm: p.smoothing_mm,
            look_ahead: p.look_ahead,
            ..PostOptions::default()
        }
    }

    /// The dialects that programs are to be written in, with the names of their controls or files.
    fn dialects(&self) -> Result<Vec<(String, Dialect)>> {
        let built_in = self.job.post.control.iter().map(|c| Ok((c.to_string(), Dialect::built_in(*c)?)));
        let own = self.job.post.files.iter().map(|f| post_name(f)).zip(self.post_files.iter().cloned()).map(Ok);
        built_in.chain(own).collect()
    }

    /// No two programs have the same file.
    fn check_program_names(&self) -> Result<()> {
        let dialects = self.dialects()?;
        for (k, (name, dialect)) in dialects.iter().enumerate() {
            let file = dialect.file_name();
            if let Some((other, _)) = dialects[..k].iter().find(|(_, d)| d.file_name() == file) {
                return Err(Error::usage(Stage::Post, format!("{other} and {name} would both write {file}"))
                    .advise("give the post file another name in `file`, or leave one of the two out"));
            }
        }
        Ok(())
    }

    /// A checked plan as a program, and what reading the program back found.
    ///
    /// # Errors
    /// Those of [`post::post`] and of [`verify::read_back::read_back`].
    pub fn program(&self, dialect: &Dialect, verified: &Verified<Plan>) -> Result<(Program, Vec<Check>)> {
        let (blade, tool, machine) = (&self.blade, &self.job.tool, &self.machine);
        let program = post::post(dialect, verified, blade, tool, machine, &self.post_options())?;
        let checks = verify::read_back::read_back(&program, verified.value(), blade, tool, machine)?;
        Ok((program, checks))
    }
}

/// What wrote a program, in the manifest: an own post file by its name, wherever it lies.
pub fn post_name(file: &Path) -> String {
    file.file_name().unwrap_or_default().to_string_lossy().into_owned()
}

/// Name and version of this program.
pub fn program() -> String {
    format!("bladewright {}", env!("CARGO_PKG_VERSION"))
}

/// The build: a hash of the sources, the built-in data and the versions of all dependencies. Two programs with the same one compute the same;
/// what the system's own mathematics library gives for the last digit of a sine is not in it.
pub fn build() -> &'static str {
    env!("BLADEWRIGHT_BUILD")
}

/// How the job reads its model.
fn model_options(m: &ModelJob) -> ModelOptions {
    ModelOptions {
        unit: m.unit,
        axis: m.axis.direction(),
        deflection_mm: m.deflection_mm,
        weld_mm: m.weld_mm,
        close_holes_mm: m.close_holes_mm,
        body: m.body,
        airfoil_mm: m.airfoil_mm,
        platform_mm: m.platform_mm,
        airfoil_faces: m.airfoil_faces.clone(),
        platform_faces: m.platform_faces.clone(),
    }
}

/// Heights that the tool can take: ball centres run from the region's start to its end or, where that is left out, at most one
/// ball radius below the airfoil.
fn reach(job: &Job, blade: &Blade) -> Reach {
    let r = &job.region;
    let end_mm = r.end_mm.unwrap_or(blade.regions.airfoil_x_mm()[0] - job.tool.radius_mm);
    let clearance_mm = job.channel.clearance_mm.max(job.channel.holder_clearance_mm);
    Reach::new(&job.tool, [r.start_mm, end_mm], job.machine.b_deg.to_radians(), clearance_mm)
}

/// A name that every control accepts: capitals, digits and underscores, beginning with a letter.
fn program_name(name: &str) -> String {
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

/// Plans, checks and writes everything.
///
/// # Errors
/// The first stage's that fails; nothing is written then.
pub fn run(draft: &Draft, out: &Path, course: Course, observer: &dyn Observer) -> Result<Outcome> {
    run_on(draft, out, course, &[], observer)
}

/// As [`run`]; stages whose inputs are those of an earlier run are taken over from it. The files are the same, but for the times in
/// `manifest.json`.
///
/// # Errors
/// As [`run`].
pub fn run_on(
    draft: &Draft,
    out: &Path,
    course: Course,
    earlier: &[Earlier],
    observer: &dyn Observer,
) -> Result<Outcome> {
    let recorder = Recorder::new(observer);
    let programs = Control::ALL.iter().map(|c| Ok(Dialect::built_in(*c)?.file_name().to_owned()));
    let mut folder = RunFolder::begin_run(out, programs.collect::<Result<_>>()?)?;
    let mut clock = Clock::default();
    let setup = clock.time(Stage::Model, || Setup::load(draft, &recorder))?;
    folder.add_job(&setup.job.to_toml()?)?;
    let mut run = checking::Run { setup: &setup, course, folder: &mut folder, clock: &mut clock, observer: &recorder };
    let made = match repost::again(&mut run, earlier)? {
        Some(made) => made,
        None => make(&mut run, earlier)?,
    };
    let status = match (&made.report, course.until) {
        (Some(r), None) if !r.passed() => reuse::FINDINGS.to_owned(),
        (_, until) => until.map_or_else(|| reuse::GOOD.to_owned(), |s| format!("until {s}")),
    };
    let job = serde_json::to_value(&setup.job)
        .map_err(|e| Error::io(Stage::Output, format!("the job cannot be written as JSON: {e}")).caused_by(e))?;
    folder.add_json(
        manifest::FILE,
        &Manifest {
            schema_version: SCHEMA_VERSION,
            program: program(),
            build: build().to_owned(),
            inputs: setup.inputs.clone(),
            job,
            stages: if course.timeless { Vec::new() } else { clock.records.clone() },
            warnings: recorder.warnings(),
            seal: made.seal,
            outputs: folder.hashes().clone(),
            programs: folder.programs().clone(),
            status,
        },
    )?;
    let Made { summary, report, plan, taken, .. } = made;
    Ok(Outcome { files: folder.finish()?, tool: setup.tool, summary, report, plan, stages: clock.records, taken })
}

/// What the stages after the model came to.
#[derive(Default)]
struct Made {
    summary: Option<Summary>,
    report: Option<CheckReport>,
    plan: Option<Plan>,
    seal: Option<String>,
    taken: Vec<Stage>,
}

/// Plans and checks in memory: no file is written. What the setup holds is all that is read.
///
/// # Errors
/// The first stage's that fails; kind `Cancelled` where the observer asks to stop.
pub fn plan(setup: &Setup, observer: &dyn Observer) -> Result<Verdict<Plan>> {
    let mut clock = Clock::default();
    match planning::plan(setup, None, reuse::Taken::default(), &mut clock, observer)? {
        Reached::Motion(planned) => checking::verdict(setup, planned.0, observer),
        _ => Err(Error::usage(Stage::Feed, "planning ended before the motion")),
    }
}

/// All stages after the model, as far as the course goes.
fn make(run: &mut checking::Run, earlier: &[Earlier]) -> Result<Made> {
    let (setup, observer) = (run.setup, run.observer);
    let sections =
        run.clock.time(Stage::Section, || section::plan(&setup.blade, &setup.section_options(), observer))?;
    run.folder.add_json("sections.json", &sections)?;
    let mut made = Made::default();
    if run.course.ends_at(Stage::Section) {
        return Ok(made);
    }
    let mut known = reuse::take(setup, earlier, observer);
    made.taken = std::mem::take(&mut known.stages);
    let before = known.checks.take();
    let reached = planning::plan(setup, run.course.until, known, run.clock, observer)?;
    reached.write(run.folder)?;
    if let Reached::Motion(planned) = reached {
        let (plan, baseline) = *planned;
        let checked = run.check_and_write(&sections, plan, &baseline, before)?;
        made.taken.extend(checked.recalled.then_some(Stage::Verify));
        (made.summary, made.report, made.plan) = (checked.summary, Some(checked.report), Some(checked.plan));
        made.seal = Some(checked.seal);
    }
    Ok(made)
}

/// The plan as evidence: passed, or failed and forced.
pub fn accept(verdict: Verdict<Plan>, force: bool) -> Option<Verified<Plan>> {
    match verdict {
        Verdict::Passed(v) => Some(v),
        Verdict::Failed(r) if force => Some(r.write_anyway()),
        Verdict::Failed(_) => None,
    }
}

/// What writing all programs came to.
#[derive(Default)]
struct Posted {
    /// Of their reading back.
    checks: Vec<Check>,
    /// Those that were written.
    figures: Vec<ProgramFigures>,
}

/// Writes all programs. One that does not come back as the plan is not written.
fn post_all(setup: &Setup, verified: &Verified<Plan>, folder: &mut RunFolder) -> Result<Posted> {
    let mut posted = Posted::default();
    for (name, dialect) in setup.dialects()? {
        let (program, checks) = setup.program(&dialect, verified)?;
        if checks.iter().all(|c| c.passed) {
            posted.figures.push(summary::program_figures(&program));
            folder.add_program(&program.file_name, program.text, &name)?;
        }
        posted.checks.extend(checks);
    }
    Ok(posted)
}

/// Figures of the schedule in use and of the fixed-lead baseline.
fn compare(setup: &Setup, plan: &Plan, baseline: &Baseline) -> Result<Vec<ScheduleFigures>> {
    let a = setup.machine.turning_axis();
    let constant = |s: &Schedule| {
        let peaks = feed::peaks(&plan.toolpath, s, &setup.machine, &setup.feed_options())?;
        Result::Ok([peaks.velocity[a], peaks.acceleration[a]])
    };
    let axes = setup.machine.axes();
    Ok(vec![
        summary::schedule_figures(plan, &plan.schedule, &plan.motion, constant(&plan.schedule)?, axes),
        summary::schedule_figures(plan, &baseline.schedule, &baseline.motion, constant(&baseline.schedule)?, axes),
    ])
}
