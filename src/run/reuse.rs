//! Stages taken over from earlier runs.
//!
//! A stage's result follows from its inputs alone, to the last bit, on any number of threads. So
//! where the inputs of a stage and of all before it are those of an earlier run by the same build
//! of the program, its result is taken from that run's `plan.json` instead of being computed. JSON
//! keeps every bit of a number. Checks are taken over where their seal fits
//! ([`crate::verify::seal`]).
//!
//! | taken over | where these are the same |
//! | --- | --- |
//! | path | bytes and reading of the model, region, `[path]` but `compare`, ball radius; and the region's end was given, else the channel may have moved it |
//! | path and channel | those, the whole tool, `[channel]` but `sweep_b`, the machine, B, fixtures and stock, `[wheel]`, `[orientation]` |
//! | schedule | those, `[schedule]`; for `time` the machine and the feed too |
//! | feed, leads | those, the machine, the feed; `verify.gouge_mm` and `resolution_mm` too for the leads |
//! | checks | those, `[verify]`; the places that the report and the preview show are measured again |
//! | all of these, sections, preview and plots | everything but `[post]`: see [`super::repost`] |

use std::collections::BTreeMap;

use super::inputs::Loaded;
use super::manifest::Input;
use crate::artifact::schedule::ScheduleKind;
use crate::artifact::{CheckReport, Plan};
use crate::channel::ChannelSettings;
use crate::error::Stage;
use crate::job::{Job, ModelSettings};
use crate::machine::MachineSettings;
use crate::observe::{Observer, Warning};
use crate::path::PathSettings;
use crate::plan::planning::KnownStages;
use crate::verify::VerifySettings;
use crate::verify::seal::Subject;

/// Names the part that the checks were about, and the program: what its exact shape follows from.
fn part(loaded: &Loaded) -> String {
    let (job, files) = (&loaded.setup.job, Files::of(&loaded.setup.job, &loaded.inputs));
    let model = ModelSettings { file: Default::default(), ..job.model.clone() };
    let (read, among) = (files.model.join(" "), files.obstacles.join(" "));
    let by = (super::program(), super::build());
    format!("{} {} {read} {model:?} {among} {:?} {:?}", by.0, by.1, job.fixture, job.stock)
}

/// What the checks of a plan are about.
pub(super) fn subject(loaded: &Loaded) -> Subject<'_> {
    let setup = &loaded.setup;
    let (tool, machine, options) = (&setup.job.tool, &setup.machine, setup.verify_options());
    Subject { part: part(loaded), tool, machine, options }
}

/// Reads a file of an earlier run by its name; `None` where there is none.
pub type ReadFile<'a> = Box<dyn Fn(&str) -> Option<Vec<u8>> + Send + Sync + 'a>;

/// Status of a run that passed all its checks.
pub(super) const GOOD: &str = "good";
/// Status of a run that came to its end but failed a check.
pub(super) const FINDINGS: &str = "findings";

/// What of a manifest matters here.
#[derive(serde::Deserialize)]
struct Before {
    program: String,
    build: String,
    inputs: Vec<Input>,
    job: Job,
    warnings: Vec<Warning>,
    #[serde(default)]
    seal: Option<String>,
    outputs: BTreeMap<String, String>,
    status: String,
}

/// A finished run made before. Its manifest is read at once, its plan when it is needed.
pub struct Earlier<'a> {
    before: Before,
    read: ReadFile<'a>,
}

impl<'a> Earlier<'a> {
    /// Opens a run; `None` where it has no manifest that this program understands.
    pub fn open(read: ReadFile<'a>) -> Option<Self> {
        let before: Before = serde_json::from_slice(&read("manifest.json")?).ok()?;
        let same = before.program == super::program() && before.build == super::build();
        same.then_some(Earlier { before, read })
    }

    /// The last stage up to which this run may stand for that of `loaded`; `None`: not at all.
    fn reaches(&self, loaded: &Loaded) -> Option<Stage> {
        let (a, b) = (&self.before.job, &loaded.setup.job);
        let (mine, yours) = (Files::of(a, &self.before.inputs), Files::of(b, &loaded.inputs));
        let path = mine.model == yours.model
            && same_model(&a.model, &b.model)
            && a.region == b.region
            && same_path(&a.path, &b.path)
            && a.tool.radius_mm == b.tool.radius_mm;
        if !path {
            return None;
        }
        let among = mine.obstacles == yours.obstacles && a.fixture == b.fixture && a.stock == b.stock;
        let among = among && a.wheel == b.wheel && a.orientation == b.orientation;
        // The machine limits the rotary axis.
        let among = among && mine.machine == yours.machine;
        if !(among
            && same_travel(a, b)
            && a.tool == b.tool
            && same_channel(&a.channel, &b.channel)
            && same_chip(a, b)
            && a.machine.b_deg == b.machine.b_deg)
        {
            return b.region.end_mm.is_some().then_some(Stage::Path);
        }
        let machine = mine.machine == yours.machine && a.feed == b.feed;
        let machine = machine && same_chip(a, b);
        let timed = matches!(b.schedule.kind, ScheduleKind::Time | ScheduleKind::Even);
        if a.schedule != b.schedule || (timed && !machine) {
            return Some(Stage::Channel);
        }
        // Room for the leads, and for a smooth curve, is judged by these limits of the checks.
        let room = |v: &VerifySettings| [v.gouge_mm, v.resolution_mm];
        Some(if machine && room(&a.verify) == room(&b.verify) { Stage::Feed } else { Stage::Schedule })
    }

    /// This run came to its end and stands for that of `loaded` in all but its programs. Where
    /// files lie does not matter; what they hold does.
    pub(super) fn differs_by_post_alone(&self, loaded: &Loaded) -> bool {
        let (a, b) = (&self.before.job, &loaded.setup.job);
        let (mine, yours) = (Files::of(a, &self.before.inputs), Files::of(b, &loaded.inputs));
        let bare = |job: &Job| Job {
            model: bare_model(&job.model),
            machine: MachineSettings { file: None, ..job.machine.clone() },
            post: b.post.clone(),
            ..job.clone()
        };
        [GOOD, FINDINGS].contains(&self.before.status.as_str())
            && same_chip(a, b)
            && mine == yours
            && bare(a) == bare(b)
    }

    /// A file of that run as it left it; `None` where it has been changed since.
    pub(super) fn file(&self, name: &str) -> Option<Vec<u8>> {
        let content = (self.read)(name)?;
        let hash = blake3::hash(&content).to_hex();
        self.before.outputs.get(name).is_some_and(|h| **h == *hash.as_str()).then_some(content)
    }

    /// What its stages warned of.
    pub(super) fn warnings(&self) -> &[Warning] {
        &self.before.warnings
    }

    fn plan(&self) -> Option<Plan> {
        serde_json::from_slice(&self.file("plan.json")?).ok()
    }

    /// The checks of that run on its plan: without those of its files and its programs.
    pub(super) fn checks(&self) -> Option<Checks> {
        let mut report: CheckReport = serde_json::from_slice(&self.file("verify.json")?).ok()?;
        report.checks.retain(|c| !c.id.is_of_program() && !c.id.is_of_files());
        Some(Checks { report, seal: self.before.seal.clone()? })
    }
}

/// An offset that stays is not limited by the channel.
fn same_travel(a: &Job, b: &Job) -> bool {
    let stays = |job: &Job| job.schedule.kind == ScheduleKind::Eccentric;
    stays(a) == stays(b)
}

/// The teeth may cut the same: spindle speed is of the programs alone where nobody asks for a chip.
fn same_chip(a: &Job, b: &Job) -> bool {
    a.cut == b.cut && (a.cut.is_none() || a.post.spindle_rpm == b.post.spindle_rpm)
}

/// Hashes of a run's input files.
#[derive(PartialEq)]
struct Files<'a> {
    model: Vec<&'a str>,
    machine: Option<&'a str>,
    /// Fixtures and stock.
    obstacles: Vec<&'a str>,
}

impl<'a> Files<'a> {
    /// Inputs stand in this order: the model with its data files, the machine if it is a file, own
    /// post files, fixtures, stock.
    fn of(job: &Job, inputs: &'a [Input]) -> Self {
        let hashes: Vec<&str> = inputs.iter().map(|i| i.blake3.as_str()).collect();
        let around = job.fixture.len() + usize::from(job.stock.is_some());
        let others = job.post.files.len() + usize::from(job.machine.file.is_some()) + around;
        let models = inputs.len().saturating_sub(others);
        let machine = job.machine.file.as_ref().and_then(|_| hashes.get(models).copied());
        let obstacles = hashes.iter().skip(inputs.len().saturating_sub(around)).copied().collect();
        Files { model: hashes.into_iter().take(models).collect(), machine, obstacles }
    }
}

/// Two runs read the same files.
pub(super) fn same_part(a: &Loaded, b: &Loaded) -> bool {
    let hashes =
        |l: &Loaded| Files::of(&l.setup.job, &l.inputs).model.iter().map(|h| h.to_string()).collect::<Vec<_>>();
    hashes(a) == hashes(b)
}

fn bare_model(m: &ModelSettings) -> ModelSettings {
    ModelSettings { file: m.file.file_name().map(Into::into).unwrap_or_default(), ..m.clone() }
}

/// The same way of reading, wherever the file lies. Its name matters: it can be the blade's.
fn same_model(a: &ModelSettings, b: &ModelSettings) -> bool {
    bare_model(a) == bare_model(b)
}

fn same_path(a: &PathSettings, b: &PathSettings) -> bool {
    let bare = |p: &PathSettings| PathSettings { compare: false, ..p.clone() };
    bare(a) == bare(b)
}

fn same_channel(a: &ChannelSettings, b: &ChannelSettings) -> bool {
    let bare = |c: &ChannelSettings| ChannelSettings { sweep_b: false, ..c.clone() };
    bare(a) == bare(b)
}

/// Checks of an earlier run, as they were written.
pub(super) struct Checks {
    pub report: CheckReport,
    pub seal: String,
}

/// What was taken over.
#[derive(Default)]
pub(super) struct Taken {
    pub results: KnownStages,
    /// To be recalled, if their seal fits.
    pub checks: Option<Checks>,
    pub stages: Vec<Stage>,
}

const STAGES: [Stage; 4] = [Stage::Path, Stage::Channel, Stage::Schedule, Stage::Feed];

/// Takes over as many stages as the best of the earlier runs gives; their warnings are given again.
pub(super) fn take(loaded: &Loaded, earlier: &[Earlier], observer: &dyn Observer) -> Taken {
    let rank = |s: Stage| STAGES.iter().position(|t| *t == s);
    let mut found: Vec<(usize, &Earlier)> =
        earlier.iter().filter_map(|e| Some((rank(e.reaches(loaded)?)?, e))).collect();
    found.sort_by_key(|(r, _)| std::cmp::Reverse(*r));
    let Some((rank, run, plan)) = found.iter().find_map(|(r, e)| Some((*r, e, e.plan()?))) else {
        return Taken::default();
    };
    // The path that a smooth curve was made from is not kept.
    if plan.curve.is_some() && rank < 3 {
        return Taken::default();
    }
    // Walls that were moved in for a schedule are those of no other.
    let own = rank == 1 && !plan.channel.proven_at.is_empty();
    if own && loaded.setup.job.region.end_mm.is_none() {
        return Taken::default();
    }
    let rank = if own { 0 } else { rank };
    let stages: Vec<Stage> = STAGES[..=rank].to_vec();
    let smoothed = plan.curve.is_some();
    let again = |w: &&Warning| stages.contains(&w.stage) || smoothed && w.stage == Stage::Smooth;
    for w in run.before.warnings.iter().filter(again) {
        observer.warn(w.clone());
    }
    let results = KnownStages {
        toolpath: Some(plan.toolpath),
        channel: (rank >= 1).then_some(plan.channel),
        schedule: (rank >= 2).then_some(plan.schedule),
        motion: (rank >= 3).then_some((plan.motion, plan.leads)),
        curve: plan.curve,
    };
    Taken { results, checks: if rank >= 3 { run.checks() } else { None }, stages }
}
