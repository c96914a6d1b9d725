//! From the job as typed to the resolved job, and the defaults that depend on the blade.

use std::borrow::Cow;
use std::path::{Path, PathBuf};

use super::resolved::Job;
use super::sections::{
    FixtureKeys, FixtureSettings, ModelSettings, RegionKeys, RegionReference, RegionSettings, ToolKeys, WheelKeys,
};
use super::tool::{self, Chosen};
use super::typed::JobFile;
use super::wheel;
use crate::artifact::Blade;
use crate::artifact::program::Control;
use crate::artifact::schedule::ScheduleKind;
use crate::artifact::toolpath::{CHORD_MM, PathKind};
use crate::channel::ChannelSettings;
use crate::error::{Error, Result, Stage};
use crate::feed::FeedSettings;
use crate::machine::{Machine, MachineSettings};
use crate::orient::{OrientationKeys, OrientationKind, OrientationSettings};
use crate::pair::PinchSettings;
use crate::path::{self, PathKeys, PathSettings};
use crate::schedule::ScheduleSettings;
use crate::section::SectionSettings;
use crate::settings::{Number, TINY, check};
use crate::tool::CutSettings;
use crate::verify::VerifySettings;
use crate::write::post::PostSettings;

/// A job that is settled as far as it can be without the blade: enough to read the model.
#[derive(Clone, Debug, PartialEq)]
pub struct Draft {
    typed: JobFile,
    model: ModelSettings,
    machine_file: Option<PathBuf>,
    post_files: Vec<PathBuf>,
    model_saved_as: Option<PathBuf>,
    base_dir: PathBuf,
}

/// Settles what does not depend on the blade. Relative paths are taken from `base_dir`, the folder
/// of the job file; where that is relative too, so they stay: [`crate::run::inputs::draft`] makes
/// them absolute before.
///
/// # Errors
/// `Usage` when the model is missing or a value that the reading of the model needs lies outside
/// its limits.
pub fn resolve(typed: JobFile, base_dir: &Path) -> Result<Draft> {
    let model = ModelSettings::default().with_typed(typed.model.clone());
    if model.file.as_os_str().is_empty() {
        return Err(Error::usage(Stage::Job, "model.file is missing: which blade is to be machined?")
            .advise("name a STEP, IGES, OBJ, STL, PLY or glTF file, or a table of sections"));
    }
    let model = ModelSettings { file: base_dir.join(&model.file), ..model };
    model.check(Stage::Job)?;
    early_checks(&typed)?;
    let machine_file = typed.machine.as_ref().and_then(|m| m.file.as_ref()).map(|f| base_dir.join(f));
    let post_files = typed.post.iter().flat_map(|p| p.files.iter().flatten()).map(|f| base_dir.join(f)).collect();
    let base_dir = base_dir.to_path_buf();
    Ok(Draft { typed, model, machine_file, post_files, model_saved_as: None, base_dir })
}

/// Finer scallops than this ask for chords below what positions of a program can say.
const LEAST_SCALLOP_MM: f64 = 2.5e-4;

/// Values that are wrong on any blade are refused before the model is read.
fn early_checks(typed: &JobFile) -> Result<()> {
    let (tool, path) = (typed.tool.clone().unwrap_or_default(), typed.path.clone().unwrap_or_default());
    let spindle = typed.post.as_ref().and_then(|p| p.spindle_rpm);
    if typed.cut.is_some() && spindle.is_none() {
        return Err(Error::usage(Stage::Job, "the job has a section cut, but post.spindle_rpm is missing")
            .advise("name the spindle speed that the teeth turn at"));
    }
    let second = typed.tool_2.clone().unwrap_or_default();
    let of_file = |t: &ToolKeys| t.library.is_some() || t.entry.is_some() || t.unit.is_some();
    if of_file(&tool) || of_file(&second) {
        return Err(Error::usage(Stage::Job, "tool.library, entry and unit name a tool in a file, which was not read")
            .advise("in the library, read it with run::inputs::draft"));
    }
    let number = |key: &str, value: &dyn Number, range| check(Stage::Job, key, value, &range);
    number("tool.radius_mm", &tool.radius_mm, TINY..=1000.0)?;
    super::tool::check_corner(&tool)?;
    number("tool.shank_radius_mm", &tool.shank_radius_mm, TINY..=1000.0)?;
    number("tool.stickout_mm", &tool.stickout_mm, TINY..=10_000.0)?;
    number("tool_2.radius_mm", &second.radius_mm, TINY..=1000.0)?;
    super::tool::balls_only(&second).map_err(super::tool::of_second)?;
    number("tool_2.shank_radius_mm", &second.shank_radius_mm, TINY..=1000.0)?;
    number("tool_2.stickout_mm", &second.stickout_mm, TINY..=10_000.0)?;
    // Twice: a number that is no height at all has a message of its own.
    number("path.scallop_mm", &path.scallop_mm, path::SCALLOPS_MM)?;
    number("path.scallop_mm", &path.scallop_mm, LEAST_SCALLOP_MM..=*path::SCALLOPS_MM.end())?;
    number("path.chord_mm", &path.chord_mm, path::CHORDS_MM)
}

impl Draft {
    /// Section wheel as typed.
    pub(super) fn typed_wheel(&self) -> Option<WheelKeys> {
        self.typed.wheel.clone()
    }
    /// How to read the model.
    pub fn model(&self) -> &ModelSettings {
        &self.model
    }
    /// The machine file; `None`: the built-in demo machine.
    pub fn machine_file(&self) -> Option<&Path> {
        self.machine_file.as_deref()
    }
    /// Own post files.
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

    /// What the machine leaves open: where it has no Y, the tool keeps its offset from the blade
    /// axis and programs name positions of axes.
    ///
    /// # Errors
    /// `Usage` where the job asks for another schedule then.
    pub fn on_machine(&self, machine: &Machine) -> Result<Cow<'_, Draft>> {
        let Some(missing) = machine.missing() else { return Ok(Cow::Borrowed(self)) };
        let mut draft = self.clone();
        let schedule = draft.typed.schedule.get_or_insert_default();
        if let Some(kind) = schedule.kind.filter(|kind| *kind != ScheduleKind::Eccentric) {
            let kind = format!("{kind:?}").to_lowercase();
            let message = format!(
                "schedule.kind is {kind}, but the machine {} has no {}: the tool keeps its offset from the blade axis",
                machine.name, missing.name
            );
            return Err(Error::usage(Stage::Job, message).advise("leave schedule.kind out, or take eccentric"));
        }
        schedule.kind = Some(ScheduleKind::Eccentric);
        draft.typed.post.get_or_insert_default().control.get_or_insert_with(|| vec![Control::Iso]);
        Ok(Cow::Owned(draft))
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
        let typed = typed_region(&t.region.unwrap_or_default(), blade)?;
        let keys = t.tool.unwrap_or_default();
        let mut chosen = tool::complete(&keys, blade, typed.start_mm, typed.end_mm)?;
        let radius_mm = chosen.tool.radius_mm;
        let second =
            t.tool_2.map(|second| tool::second(&second, (&chosen.tool, &keys), blade, [typed.start_mm, typed.end_mm]));
        let second = second.transpose()?;
        chosen.warnings.extend(second.iter().flat_map(|s| s.warnings.iter().cloned()));
        let start_mm = typed.start_mm.unwrap_or_else(|| default_start(blade, radius_mm));
        let region = RegionSettings { start_mm, end_mm: typed.end_mm, end_faces: typed.end_faces };
        let path = path_settings(t.path, blade, &region, chosen.tool.corner_mm());
        let schedule = ScheduleSettings::default().with_typed(t.schedule);
        // Along a wall nothing else keeps the tool from the part between two locations.
        let channel = ChannelSettings { prove_moves: schedule.kind.is_wall(), ..ChannelSettings::default() };
        let channel = if chosen.tool.is_ball() { channel } else { leaning(channel) };
        let channel = channel.with_typed(t.channel);
        let (feed, verify) = (FeedSettings::default(), VerifySettings::default());
        // A fit is one of a curve.
        let smooth = t.feed.as_ref().is_some_and(|f| f.fit_mm.is_some());
        let feed = FeedSettings { lead_radius_mm: radius_mm.max(feed.lead_radius_mm), smooth, ..feed };
        let verify = VerifySettings { gouge_mm: (3.0 * path.chord_mm).max(verify.gouge_mm), ..verify };
        let body = |section, keys| self.fixture(section, keys, &channel);
        let job = Job {
            model: ModelSettings {
                file: self.model_saved_as.clone().unwrap_or_else(|| self.model.file.clone()),
                unit: Some(blade.unit),
                ..self.model.clone()
            },
            region,
            machine: MachineSettings {
                file: self.machine_file.clone(),
                ..MachineSettings::default().with_typed(t.machine)
            },
            feed: feed.with_typed(t.feed),
            post: PostSettings { files: self.post_files.clone(), ..PostSettings::default().with_typed(t.post) },
            verify: verify.with_typed(t.verify),
            section: SectionSettings::default().with_typed(t.section),
            tool: chosen.tool.clone(),
            tool_2: second.map(|s| s.tool),
            fixture: t.fixture.into_iter().flatten().map(|f| body("fixture", f)).collect::<Result<_>>()?,
            stock: t.stock.map(|f| body("stock", f)).transpose()?,
            wheel: wheel::settled(t.wheel, blade.wheel.as_ref(), blade.regions.over_hub().is_some())?,
            orientation: orientation(t.orientation, blade)?,
            cut: t.cut.map(|c| CutSettings::default().with_typed(Some(c))),
            pinch: t.pinch.map(|p| PinchSettings::default().with_typed(Some(p))),
            path,
            channel,
            schedule,
        };
        job.validate()?;
        Ok((job, chosen))
    }

    /// A fixture or the stock; it keeps the room of the channel.
    fn fixture(&self, section: &str, keys: FixtureKeys, channel: &ChannelSettings) -> Result<FixtureSettings> {
        let room = FixtureSettings {
            clearance_mm: channel.clearance_mm,
            holder_clearance_mm: keys.clearance_mm.unwrap_or(channel.holder_clearance_mm),
            ..FixtureSettings::default()
        };
        let body = room.with_typed(Some(keys));
        if body.file.as_os_str().is_empty() {
            return Err(Error::usage(Stage::Job, format!("{section}.file is missing: which body is in the way?")));
        }
        Ok(FixtureSettings { file: self.base_dir.join(&body.file), ..body })
    }
}

/// The tool axes as typed; five axes where the hub turns, which no cone about one axis reaches
/// over.
///
/// # Errors
/// `Usage` where such a cone is asked for there.
fn orientation(keys: Option<OrientationKeys>, blade: &Blade) -> Result<OrientationSettings> {
    let turns = blade.regions.over_hub().is_some();
    let kind = if turns { OrientationKind::FiveAxis } else { OrientationKind::default() };
    let settings = OrientationSettings { kind, ..OrientationSettings::default() }.with_typed(keys);
    if turns && settings.kind.goes_round() {
        let message = "orientation.kind is cone, but the blade's hub turns from along the rotor axis to across it";
        return Err(Error::usage(Stage::Job, message).advise("leave orientation.kind out, which is five-axis then"));
    }
    Ok(settings)
}

/// Chords over exact faces of an impeller's blade keep to the path within this, mm: a tenth less
/// than the micrometre that is wanted, since they are looked at in places.
const EXACT_CHORD_MM: f64 = 0.0009;

/// How far a cutter with a corner leans from the surface normal, degrees: so little leaves wide
/// strips, and so much keeps the back of its bottom clear of walls that are hardly hollow.
const LEANS_DEG: [f64; 2] = [3.0, 12.0];

fn leaning(channel: ChannelSettings) -> ChannelSettings {
    let [contact_angle_min_deg, contact_angle_max_deg] = LEANS_DEG;
    ChannelSettings { contact_angle_min_deg, contact_angle_max_deg, ..channel }
}

/// The path as typed, the rest as blade, region and ball ask for.
fn path_settings(keys: Option<PathKeys>, blade: &Blade, region: &RegionSettings, radius_mm: f64) -> PathSettings {
    let usual = PathSettings::default();
    // Blades over a hub that turns lean far where they leave it.
    let free = region.end_faces.is_empty() && blade.regions.over_hub().is_none();
    let typed_chord_mm = keys.as_ref().and_then(|k| k.chord_mm);
    let kind = keys.as_ref().and_then(|k| k.kind).unwrap_or_else(|| default_kind(blade, region));
    let path = PathSettings {
        kind,
        max_step_mm: (0.25 * radius_mm).min(usual.max_step_mm),
        max_lean_deg: if free { usual.max_lean_deg } else { path::most_lean_deg(kind) },
        ..usual
    };
    let path = path.with_typed(keys);
    let usual_mm = default_chord_mm(path.kind, path.scallop_mm);
    // In five axes the exact part is kept to a micrometre.
    let is_exact = blade.part.brep.is_some() && blade.regions.over_hub().is_some();
    let chord_mm = typed_chord_mm.unwrap_or(if is_exact { usual_mm.min(EXACT_CHORD_MM) } else { usual_mm });
    PathSettings { chord_mm, ..path }
}

/// The region as far as it was typed, in the blade frame.
struct TypedRegion {
    start_mm: Option<f64>,
    end_mm: Option<f64>,
    end_faces: Vec<String>,
}

/// The region as typed, its heights in the blade frame.
fn typed_region(keys: &RegionKeys, blade: &Blade) -> Result<TypedRegion> {
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
    // Nothing but this path mills such a blade.
    if blade.regions.over_hub().is_some() {
        return b;
    }
    a + (0.3 * (b - a)).max(3.0 * radius_mm).min(40.0).min(0.9 * (b - a))
}

/// Turns of constant scallop, but planar ones on a mesh: those that are laid from one another take
/// up what its facets do to each, and on a scan the shorter path takes longer. Over a hub that
/// turns the blade is higher at its one end, where turns of constant scallop would wait for the
/// others. Only turns of constant scallop run along the edge of a face.
fn default_kind(blade: &Blade, region: &RegionSettings) -> PathKind {
    let is_straight = blade.part.brep.is_some() && blade.regions.over_hub().is_none();
    let free = is_straight || !region.end_faces.is_empty();
    if free { PathKind::ConstantScallop } else { PathKind::ConstantHeight }
}

/// A chord lets the ridge beside it sink by up to half its own height over the curve (on a round
/// wall), and so does the next turn's chord. With turns of constant scallop both together are kept
/// within 4 % of the scallop. On a hollow wall the ridge would rise, and chords have a quarter of
/// the tolerance.
fn default_chord_mm(kind: PathKind, scallop_mm: f64) -> f64 {
    if kind.is_of_neighbours() { (0.04 * scallop_mm).min(CHORD_MM) } else { CHORD_MM }
}
