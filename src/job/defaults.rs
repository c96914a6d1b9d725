//! From the job as typed to the resolved job, and the defaults that depend on the blade.

use std::path::{Path, PathBuf};

use super::resolved::{
    ChannelJob, FeedJob, FixtureJob, Job, MOST_LEAN_DEG, MachineJob, ModelJob, PathJob, PostJob, RegionJob,
    ScheduleJob, SectionJob, TINY, VerifyJob, check_ranges,
};
use super::tool::{self, Chosen};
use super::typed::{FixtureKeys, JobFile, RegionReference};
use crate::artifact::Blade;
use crate::artifact::program::Control;
use crate::artifact::schedule::ScheduleKind;
use crate::artifact::toolpath::PathKind;
use crate::channel::{CONTACT_ANGLE_DEG, ChannelOptions, TOLERANCE_DEG};
use crate::error::{Error, Result, Stage};
use crate::path::PathOptions;
use crate::read::model::ModelOptions;
use crate::schedule::ScheduleOptions;
use crate::verify::VerifyOptions;
use crate::write::post::PostOptions;

/// A job that is settled as far as it can be without the blade: enough to read the model.
#[derive(Clone, Debug, PartialEq)]
pub struct Draft {
    typed: JobFile,
    model: ModelJob,
    machine_file: Option<PathBuf>,
    post_files: Vec<PathBuf>,
    model_saved_as: Option<PathBuf>,
    base_dir: PathBuf,
}

/// Settles what does not depend on the blade. Relative paths are taken from `base_dir`: the folder
/// of the job file, or the working folder.
///
/// # Errors
/// `Usage` when the model is missing or a value that the reading of the model needs lies outside
/// its limits.
pub fn resolve(typed: JobFile, base_dir: &Path) -> Result<Draft> {
    let keys = typed.model.clone().unwrap_or_default();
    let Some(file) = keys.file.filter(|f| !f.is_empty()) else {
        return Err(Error::usage(Stage::Job, "model.file is missing: which blade is to be machined?")
            .advise("name a STEP, IGES, OBJ, STL, PLY or glTF file, or a table of sections"));
    };
    let absolute = |file: &str| std::path::absolute(base_dir.join(file)).unwrap_or_else(|_| base_dir.join(file));
    let model = ModelJob {
        file: absolute(&file),
        unit: keys.unit,
        axis: keys.axis.unwrap_or_default(),
        deflection_mm: keys.deflection_mm.unwrap_or(ModelOptions::default().deflection_mm),
        weld_mm: keys.weld_mm,
        close_holes_mm: keys.close_holes_mm,
        body: keys.body,
        airfoil_mm: keys.airfoil_mm,
        platform_mm: keys.platform_mm,
        airfoil_faces: keys.airfoil_faces.unwrap_or_default(),
        platform_faces: keys.platform_faces.unwrap_or_default(),
    };
    check_ranges(&[
        ("model.deflection_mm", model.deflection_mm, TINY, 10.0),
        ("model.weld_mm", model.weld_mm.unwrap_or(TINY), TINY, 10.0),
        ("model.close_holes_mm", model.close_holes_mm.unwrap_or(TINY), TINY, 1e6),
    ])?;
    early_checks(&typed)?;
    let machine_file = typed.machine.as_ref().and_then(|m| m.file.as_deref()).map(absolute);
    let post_files = typed.post.iter().flat_map(|p| p.files.iter().flatten()).map(|f| absolute(f)).collect();
    let base_dir = base_dir.to_path_buf();
    Ok(Draft { typed, model, machine_file, post_files, model_saved_as: None, base_dir })
}

/// Finer scallops than this ask for chords below what positions of a program can say.
const LEAST_SCALLOP_MM: f64 = 2.5e-4;

/// Values that are wrong on any blade are refused before the model is read.
fn early_checks(typed: &JobFile) -> Result<()> {
    let tool = typed.tool.clone().unwrap_or_default();
    let path = typed.path.clone().unwrap_or_default();
    check_ranges(&[
        ("tool.radius_mm", tool.radius_mm.unwrap_or(1.0), TINY, 1000.0),
        ("tool.shank_radius_mm", tool.shank_radius_mm.unwrap_or(1.0), TINY, 1000.0),
        ("tool.stickout_mm", tool.stickout_mm.unwrap_or(1.0), TINY, 10_000.0),
        // Twice: a number that is no height at all has a message of its own.
        ("path.scallop_mm", path.scallop_mm.unwrap_or(0.01), TINY, 10.0),
        ("path.scallop_mm", path.scallop_mm.unwrap_or(0.01), LEAST_SCALLOP_MM, 10.0),
        ("path.chord_mm", path.chord_mm.unwrap_or(0.001), 1e-5, 1.0),
    ])
}

impl Draft {
    /// How to read the model.
    pub fn model(&self) -> &ModelJob {
        &self.model
    }
    /// The machine file, absolute; `None`: the built-in demo machine.
    pub fn machine_file(&self) -> Option<&Path> {
        self.machine_file.as_deref()
    }
    /// Own post files, absolute.
    pub fn post_files(&self) -> &[PathBuf] {
        &self.post_files
    }

    /// The saved job names its model by this path instead, relative to the run's folder: for a
    /// model that is kept in there.
    #[must_use]
    pub fn model_saved_as(mut self, path: &Path) -> Self {
        self.model_saved_as = Some(path.to_path_buf());
        self
    }

    /// Settles the rest from the blade.
    ///
    /// # Errors
    /// As [`Draft::settle`].
    pub fn complete(&self, blade: &Blade) -> Result<Job> {
        self.settle(blade).map(|(job, _)| job)
    }

    /// As [`Draft::complete`], with what is to be said of the tool.
    ///
    /// # Errors
    /// `Usage` naming the key when a value lies outside its limits; `Infeasible` when no tool fits
    /// by itself.
    pub fn settle(&self, blade: &Blade) -> Result<(Job, Chosen)> {
        let t = self.typed.clone();
        let (path, channel) = (t.path.unwrap_or_default(), t.channel.unwrap_or_default());
        let (schedule, verify) = (t.schedule.unwrap_or_default(), t.verify.unwrap_or_default());
        let post = t.post.unwrap_or_default();
        let feed = t.feed.unwrap_or_default();
        let typed_region = typed_region(&t.region.unwrap_or_default(), blade)?;
        let chosen = tool::complete(&t.tool.unwrap_or_default(), blade, typed_region.start_mm, typed_region.end_mm)?;
        let (tool, radius) = (chosen.tool.clone(), chosen.tool.radius_mm);
        let start_mm = typed_region.start_mm.unwrap_or_else(|| default_start(blade, radius));
        let region = RegionJob { start_mm, end_mm: typed_region.end_mm, end_faces: typed_region.end_faces };
        let max_lean_deg = if region.end_faces.is_empty() { 60.0 } else { MOST_LEAN_DEG };
        let (kind, scallop_mm) =
            (path.kind.unwrap_or_else(|| default_kind(blade, &region)), path.scallop_mm.unwrap_or(0.01));
        let chord_mm = path.chord_mm.unwrap_or_else(|| default_chord_mm(kind, scallop_mm));
        let (of_path, of_channel) = (PathOptions::new(radius, scallop_mm), ChannelOptions::default());
        let (of_schedule, of_checks, of_post) =
            (ScheduleOptions::default(), VerifyOptions::default(), PostOptions::default());
        let room = [
            channel.clearance_mm.unwrap_or(of_channel.clearance_mm),
            channel.holder_clearance_mm.unwrap_or(of_channel.holder_clearance_mm),
        ];
        let fixtures = t.fixture.unwrap_or_default();
        let fixture = fixtures.iter().map(|f| self.fixture("fixture", f, room)).collect::<Result<_>>()?;
        let stock = t.stock.map(|f| self.fixture("stock", &f, room)).transpose()?;
        let job = Job {
            model: ModelJob {
                file: self.model_saved_as.clone().unwrap_or_else(|| self.model.file.clone()),
                unit: Some(blade.unit),
                ..self.model.clone()
            },
            region,
            path: PathJob {
                kind,
                scallop_mm,
                chord_mm,
                max_step_mm: path.max_step_mm.unwrap_or(of_path.max_step_mm),
                max_lean_deg: path.max_lean_deg.unwrap_or(max_lean_deg),
                direction: path.direction.unwrap_or_default(),
                start: path.start.unwrap_or_default(),
                stock_mm: path.stock_mm.unwrap_or(of_path.stock_mm),
                compare: path.compare.unwrap_or(false),
            },
            channel: ChannelJob {
                clearance_mm: room[0],
                holder_clearance_mm: room[1],
                contact_angle_min_deg: channel.contact_angle_min_deg.unwrap_or(CONTACT_ANGLE_DEG[0]),
                contact_angle_max_deg: channel.contact_angle_max_deg.unwrap_or(CONTACT_ANGLE_DEG[1]),
                tolerance_deg: channel.tolerance_deg.unwrap_or(TOLERANCE_DEG),
                prove_moves: channel.prove_moves.unwrap_or(schedule.kind.is_some_and(ScheduleKind::is_wall)),
                exact_ends: channel.exact_ends.unwrap_or(of_channel.exact_ends),
                sweep_b: channel.sweep_b.unwrap_or(false),
            },
            machine: MachineJob {
                file: self.machine_file.clone(),
                b_deg: t.machine.and_then(|m| m.b_deg).unwrap_or(5.0),
            },
            schedule: ScheduleJob {
                kind: schedule.kind.unwrap_or(ScheduleKind::Piecewise),
                base_angle: schedule.base_angle.unwrap_or_default(),
                measure: schedule.measure.unwrap_or_default(),
                scope: schedule.scope.unwrap_or_default(),
                margin_deg: schedule.margin_deg.unwrap_or(of_schedule.margin_deg),
                lead_deg: schedule.lead_deg.unwrap_or(of_schedule.lead_deg),
                beyond_wall_deg: schedule.beyond_wall_deg.unwrap_or(of_schedule.beyond_wall_deg),
            },
            feed: FeedJob {
                feed_mm_min: feed.feed_mm_min.unwrap_or(2000.0),
                lead_radius_mm: feed.lead_radius_mm.unwrap_or(radius.max(2.0)),
            },
            post: PostJob {
                control: post.control.unwrap_or_else(|| vec![Control::Siemens, Control::Linuxcnc]),
                files: self.post_files.clone(),
                tool_number: post.tool_number.unwrap_or(of_post.tool_number),
                spindle_rpm: post.spindle_rpm.unwrap_or(of_post.spindle_rpm),
                approach_feed_mm_min: post.approach_feed_mm_min.unwrap_or(of_post.approach_feed_mm_min),
                plunge_feed_mm_min: post.plunge_feed_mm_min.unwrap_or(of_post.plunge_feed_mm_min),
                feed_height_mm: post.feed_height_mm.unwrap_or(of_post.feed_height_mm),
                safe_clearance_mm: post.safe_clearance_mm.unwrap_or(of_post.safe_clearance_mm),
                smoothing_mm: post.smoothing_mm,
                look_ahead: post.look_ahead.unwrap_or(of_post.look_ahead),
            },
            verify: VerifyJob {
                gouge_mm: verify.gouge_mm.unwrap_or((3.0 * chord_mm).max(of_checks.gouge_mm)),
                scallop_ratio: verify.scallop_ratio.unwrap_or(of_checks.scallop_ratio),
                resolution_mm: verify.resolution_mm.unwrap_or(of_checks.resolution_mm),
                surface_samples: verify.surface_samples.unwrap_or(of_checks.surface_samples as u32),
            },
            section: SectionJob { count: t.section.and_then(|s| s.count).unwrap_or(12) },
            tool,
            fixture,
            stock,
        };
        job.validate()?;
        Ok((job, chosen))
    }

    /// A fixture or the stock; `room` is what the channel keeps from the part.
    fn fixture(&self, section: &str, keys: &FixtureKeys, room: [f64; 2]) -> Result<FixtureJob> {
        let Some(file) = keys.file.as_ref().filter(|f| !f.is_empty()) else {
            return Err(Error::usage(Stage::Job, format!("{section}.file is missing: which body is in the way?")));
        };
        let file = self.base_dir.join(file);
        Ok(FixtureJob {
            file: std::path::absolute(&file).unwrap_or(file),
            unit: keys.unit,
            clearance_mm: keys.clearance_mm.unwrap_or(room[0]),
            holder_clearance_mm: keys.holder_clearance_mm.or(keys.clearance_mm).unwrap_or(room[1]),
        })
    }
}

/// The region as far as it was typed, in the blade frame.
struct TypedRegion {
    start_mm: Option<f64>,
    end_mm: Option<f64>,
    end_faces: Vec<String>,
}

/// The region as typed, its heights in the blade frame.
fn typed_region(keys: &super::typed::RegionKeys, blade: &Blade) -> Result<TypedRegion> {
    let zero = match keys.reference.unwrap_or_default() {
        RegionReference::Blade => 0.0,
        RegionReference::Platform => blade.regions.platform_x_mm().ok_or_else(|| {
            Error::usage(Stage::Job, "region.reference is platform, but no platform was found on the part")
                .advise("give heights in the blade frame: region.reference = \"blade\"")
        })?,
    };
    let typed = |key: &str, x: Option<f64>| match x {
        None => Ok(None),
        Some(x) => {
            let (x, [lo, hi]) = (x + zero, blade.regions.part_x_mm);
            if (lo..=hi).contains(&x) { Ok(Some(x)) } else { Err(outside(key, x, lo, hi)) }
        }
    };
    let start_mm = typed("region.start_mm", keys.start_mm)?;
    let end_mm = typed("region.end_mm", keys.end_mm)?;
    Ok(TypedRegion { start_mm, end_mm, end_faces: keys.end_faces.clone().unwrap_or_default() })
}

fn outside(key: &str, x: f64, lo: f64, hi: f64) -> Error {
    let span = format!("which spans {lo:.3} to {hi:.3} mm along the blade axis");
    Error::usage(Stage::Job, format!("{key} is at {x} mm in the blade frame, outside the part, {span}"))
        .advise("choose heights inside the part; `inspect` prints where the airfoil and the platform are")
}

fn default_start(blade: &Blade, radius_mm: f64) -> f64 {
    let [a, b] = blade.regions.airfoil_x_mm();
    a + (0.3 * (b - a)).max(3.0 * radius_mm).min(40.0).min(0.9 * (b - a))
}

/// Turns of constant scallop, but planar ones on a mesh: those that are laid from one another take
/// up what its facets do to each, and on a scan the shorter path takes longer. Only turns of
/// constant scallop run along the edge of a face.
fn default_kind(blade: &Blade, region: &RegionJob) -> PathKind {
    let free = blade.part.brep.is_some() || !region.end_faces.is_empty();
    if free { PathKind::ConstantScallop } else { PathKind::ConstantHeight }
}

/// A chord lets the ridge beside it sink by up to half its own height over the curve (on a round
/// wall), and so does the next turn's chord. With turns of constant scallop both together are kept
/// within 4 % of the scallop. On a hollow wall the ridge would rise, and chords have a quarter of
/// the tolerance.
fn default_chord_mm(kind: PathKind, scallop_mm: f64) -> f64 {
    match kind {
        PathKind::ConstantScallop => (0.04 * scallop_mm).min(0.001),
        PathKind::ConstantHeight | PathKind::IsoParametric => 0.001,
    }
}
