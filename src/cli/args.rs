//! The command line as typed.

use std::path::PathBuf;

use clap::{Parser, Subcommand};

use super::words;
use crate::artifact::blade::Unit;
use crate::artifact::program::{Control, Programmed};
use crate::artifact::schedule::ScheduleKind;
use crate::artifact::toolpath::CHORD_MM;
use crate::batch::Shard;
use crate::error::Stage;
use crate::verify::VerifySettings;

/// Machine programs for turbine and compressor blades, straight from their CAD.
#[derive(Debug, Parser)]
#[command(
    name = "bladewright",
    version,
    about,
    after_help = "Examples:\n  bladewright inspect blade.step\n  bladewright plan blade.step -o out/blade\n  bladewright plan blade.stl --unit m --set tool.radius_mm=2 -o out/blade\n  bladewright plan job.toml -o out/blade --until path\n  bladewright post out/blade --control linuxcnc\n  bladewright plot out/blade --turn 12 --format png\n\nEvery verb has examples: bladewright plan --help. Colours follow NO_COLOR.\n\nExit codes: 0 good, 1 findings, 2 usage or job file, 3 no feasible plan, 4 input or output, 130 cancelled."
)]
pub struct Args {
    /// Threads to use; default: all cores. The result does not depend on it.
    #[arg(long, global = true, value_name = "N")]
    pub threads: Option<usize>,
    /// No progress, only warnings and results.
    #[arg(long, short, global = true)]
    pub quiet: bool,
    /// One JSON object a line on standard output: progress, warnings, what would be printed, the
    /// end with its exit code.
    #[arg(long, global = true)]
    pub json: bool,
    /// What to do.
    #[command(subcommand)]
    pub verb: Verb,
}

/// What to do.
#[derive(Debug, Subcommand)]
pub enum Verb {
    /// Tell what is in a model: bodies, faces, unit, box, closed or not, blade axis and regions.
    #[command(
        after_help = "Examples:\n  bladewright inspect blade.step\n  bladewright inspect scan.stl --unit mm --glb regions.glb"
    )]
    Inspect(Inspect),
    /// Make a blade from parameters: STEP and OBJ.
    #[command(
        after_help = "Examples:\n  bladewright make turbine_camber -o out/models\n  bladewright make my_blade.toml -o out/models"
    )]
    Make(Make),
    /// Plan a blade-root program from a model or a job file, check it and write everything.
    #[command(
        after_help = "Examples:\n  bladewright plan blade.step -o out/b\n  bladewright plan job.toml -o out/b --set tool.radius_mm=4 --set schedule.kind=optimal\n  bladewright plan blade.step -o out/b --until channel\n  bladewright plan blade.step -o out/b --preview-budget 3MB"
    )]
    Plan(Plan),
    /// All schedules of a job side by side, over a sweep of machine limits: table, JSON, picture.
    #[command(
        after_help = "Examples:\n  bladewright compare blade.step -o out/c\n  bladewright compare job.toml -o out/c --no-jerk"
    )]
    Compare(Compare),
    /// The S–θ channel alone: all free angles at every cutter location, what binds them, and its
    /// width against B.
    Channel(Channel),
    /// What would open the channel, or open it wider: B, stick-out, holder.
    Advise(Advise),
    /// Rows for two tools that hold a blade between them: opposite places on both sides, and an
    /// angle of the table for each row at which both tools are clear.
    #[command(
        after_help = "Examples:\n  bladewright pinch blade.step -o out/pinch\n  bladewright pinch job.toml -o out/pinch --set pinch.heights_mm=[20,80]\n\nWrites pairs.csv, the locations of both tools, pinch.json, pinch.svg, pinch.glb and report.html; for a\nmachine with two heads a program in nine axes, too."
    )]
    Pinch(Pinch),
    /// Plan a family of blades: many models or parameters from one file, resumable, in shards.
    #[command(
        after_help = "Examples:\n  bladewright batch family.toml -o out/family\n  bladewright batch family.toml --list\n  bladewright batch family.toml -o out/family --retry\n  bladewright batch family.toml -o /shared/out --shard 2/8\n  bladewright batch merge family.toml -o /shared/out\n\nA family that was interrupted goes on where it was: the same command again."
    )]
    Batch(Batch),
    /// Check a finished run again from its files, or a program that others wrote.
    #[command(
        after_help = "Examples:\n  bladewright verify out/b && echo good\n  bladewright verify theirs.mpf --part blade.step --tool ball6.toml --machine mill.toml --scallop 0.01\n  bladewright verify both.mpf --part blade.step --tool out/airfoil/job.resolved.toml --tool out/fillet/job.resolved.toml\n  bladewright verify old.nc --part blade.step --tool out/b/job.resolved.toml --origin 0,0,-120 --report findings.json\n  bladewright verify theirs.apt --part blade.step --tool ball6.toml --fit"
    )]
    Verify(Verify),
    /// Schedule the tool axis of a program that others wrote anew, and write it back.
    #[command(
        after_help = "Examples:\n  bladewright reschedule theirs.mpf --part blade.step --tool ball6.toml --machine mill.toml -o out/new\n  bladewright reschedule old.cls --part blade.step --tool out/b/job.resolved.toml --cad --schedule optimal -o out/new\n  bladewright reschedule theirs.apt --part blade.step --tool ball6.toml --for siemens,linuxcnc -o out/new\n\nBall centres stay as they are; only lines that cut change. The folder gets the program under its\nown name, reschedule.json and reschedule.svg."
    )]
    Reschedule(Reschedule),
    /// Write the NC program of a finished run for a control, or of several runs as operations of
    /// one program.
    #[command(
        after_help = "Examples:\n  bladewright post out/b --control heidenhain\n  bladewright post out/b --post-file mine.toml\n  bladewright post out/b --control siemens --from-turn 12\n  bladewright post out/airfoil out/fillet --control siemens -o out/program\n  bladewright post out/wheel --every-blade --control heidenhain -o out/program\n  bladewright post out/airfoil out/fillet --control siemens -o out/program --from-operation 2 --from-turn 3"
    )]
    Post(Post),
    /// Write preview.glb and report.html of a finished run again.
    #[command(after_help = "Examples:\n  bladewright preview out/b\n  bladewright preview out/b --preview-budget 2MB")]
    Preview(Preview),
    /// The report's plots of a finished run as SVG and PNG files, for papers and slides.
    #[command(
        after_help = "Examples:\n  bladewright plot out/b\n  bladewright plot out/b --turn 12 --format png --width 2400 -o slides"
    )]
    Plot(Plot),
    /// Print completions for a shell, to be sourced.
    #[command(
        after_help = "Examples:\n  bladewright completions bash > ~/.local/share/bash-completion/completions/bladewright\n  bladewright completions zsh > ~/.zfunc/_bladewright"
    )]
    Completions(Completions),
    /// Write the man pages: bladewright.1 and one for each verb.
    #[command(after_help = "Examples:\n  bladewright man -o ~/.local/share/man/man1")]
    Man(Man),
}

/// Options that say how a model file is to be read.
#[derive(Debug, Clone, Default, clap::Args)]
pub struct Reading {
    /// Length unit of the file, where it states none or the wrong one.
    #[arg(long, value_parser = words::parser::<Unit>())]
    pub unit: Option<Unit>,
    /// Blade axis from root to tip, in the model's frame.
    #[arg(long, value_name = "X,Y,Z", allow_hyphen_values = true, value_parser = parse_axis)]
    pub axis: Option<Axis>,
    /// The body to plan, by its number as inspect prints it, where the model has several; the tool
    /// keeps clear of all of them.
    #[arg(long, value_name = "N")]
    pub body: Option<u32>,
    /// Where a region lies, mm along the blade axis: airfoil=LO,HI or platform=TOP; may be given
    /// more than once.
    #[arg(long, value_name = "NAME=HEIGHTS", value_parser = parse_region)]
    pub region: Vec<RegionHeights>,
    /// Faces of a region, by number or name: airfoil=3,4 or platform=top; may be given more than
    /// once.
    #[arg(long, value_name = "NAME=FACES", value_parser = parse_faces)]
    pub faces: Vec<Faces>,
}

/// Heights of a region.
#[derive(Debug, Clone, Copy)]
pub enum RegionHeights {
    /// From, to.
    Airfoil([f64; 2]),
    /// Top.
    Platform(f64),
}

fn parse_region(text: &str) -> Result<RegionHeights, String> {
    let numbers = |t: &str| -> Vec<f64> {
        t.split(',').filter_map(|x| x.trim().parse().ok()).filter(|v: &f64| v.is_finite()).collect()
    };
    let found = text.split_once('=').and_then(|(name, value)| match (name.trim(), &numbers(value)[..]) {
        ("airfoil", [lo, hi]) if lo < hi => Some(RegionHeights::Airfoil([*lo, *hi])),
        ("platform", [x]) => Some(RegionHeights::Platform(*x)),
        _ => None,
    });
    found.ok_or_else(|| "give airfoil=LO,HI or platform=TOP, mm along the blade axis, as in airfoil=12,80".into())
}

/// Faces of a region.
#[derive(Debug, Clone)]
pub enum Faces {
    /// Of the airfoil.
    Airfoil(Vec<String>),
    /// Of the platform's top.
    Platform(Vec<String>),
}

fn parse_faces(text: &str) -> Result<Faces, String> {
    let list =
        |t: &str| -> Vec<String> { t.split(',').map(|x| x.trim().to_owned()).filter(|x| !x.is_empty()).collect() };
    let found = text.split_once('=').and_then(|(name, value)| match (name.trim(), list(value)) {
        (_, l) if l.is_empty() => None,
        ("airfoil", l) => Some(Faces::Airfoil(l)),
        ("platform", l) => Some(Faces::Platform(l)),
        _ => None,
    });
    found.ok_or_else(|| "give airfoil=FACES or platform=FACES, numbers or names as inspect prints them".into())
}

/// Three numbers.
#[derive(Debug, Clone, Copy)]
pub struct Axis(pub [f64; 3]);

/// Three numbers with commas between.
fn three(text: &str) -> Option<[f64; 3]> {
    let numbers: Vec<f64> = text.split(',').map(|t| t.trim().parse().ok()).collect::<Option<_>>()?;
    numbers.try_into().ok().filter(|n: &[f64; 3]| n.iter().all(|v| v.is_finite()))
}

fn parse_axis(text: &str) -> Result<Axis, String> {
    let named = match text.to_lowercase().as_str() {
        "x" | "+x" => Some([1.0, 0.0, 0.0]),
        "y" | "+y" => Some([0.0, 1.0, 0.0]),
        "z" | "+z" => Some([0.0, 0.0, 1.0]),
        "-x" => Some([-1.0, 0.0, 0.0]),
        "-y" => Some([0.0, -1.0, 0.0]),
        "-z" => Some([0.0, 0.0, -1.0]),
        _ => None,
    };
    if let Some(axis) = named {
        return Ok(Axis(axis));
    }
    match three(text) {
        Some([x, y, z]) if x.hypot(y).hypot(z) > 0.0 => Ok(Axis([x, y, z])),
        _ => Err("give three numbers, not all 0, as in 0,0,1, or one of x, y, z, -x, -y, -z".into()),
    }
}

/// `inspect`.
#[derive(Debug, clap::Args)]
pub struct Inspect {
    /// The model: STEP, IGES, OBJ, STL, PLY, glTF or a table of sections.
    pub model: PathBuf,
    /// How to read it.
    #[command(flatten)]
    pub reading: Reading,
    /// Close holes of a mesh up to this extent, mm.
    #[arg(long, value_name = "MM", value_parser = parse_positive)]
    pub close_holes: Option<f64>,
    /// Vertices of a mesh this near to one another are the same, mm.
    #[arg(long, value_name = "MM", value_parser = parse_positive)]
    pub weld: Option<f64>,
    /// Write the part with its regions coloured: airfoil, fillet, platform, root, tip.
    #[arg(long, value_name = "FILE")]
    pub glb: Option<PathBuf>,
    /// Also how much of the airfoil has an opposite side, where two tools can hold it between them.
    #[arg(long)]
    pub pairs: bool,
}

fn parse_positive(text: &str) -> Result<f64, String> {
    text.parse().ok().filter(|v: &f64| *v > 0.0 && v.is_finite()).ok_or_else(|| "give a number greater than 0".into())
}

/// `make`.
#[derive(Debug, clap::Args)]
pub struct Make {
    /// A preset's name, or a design file (TOML).
    pub design: String,
    /// Folder to write NAME.step, NAME.obj and NAME.toml to.
    #[arg(short, long, value_name = "DIR")]
    pub out: PathBuf,
}

/// What a job is made of.
#[derive(Debug, clap::Args)]
pub struct Job {
    /// The model (every option has a default), or a job file (TOML).
    pub input: PathBuf,
    /// Folder for the results.
    #[arg(short, long, value_name = "OUT")]
    pub out: PathBuf,
    /// How to read the model.
    #[command(flatten)]
    pub reading: Reading,
    /// Change a key of the job, as in --set tool.radius_mm=4; may be given more than once.
    #[arg(long = "set", value_name = "KEY=VALUE", allow_hyphen_values = true)]
    pub set: Vec<String>,
}

/// `plan`.
#[derive(Debug, clap::Args)]
pub struct Plan {
    /// What is to be planned.
    #[command(flatten)]
    pub job: Job,
    /// Stop after this stage: section, path, channel, schedule, or verify (all but the programs).
    #[arg(long, value_name = "STAGE", value_parser = parse_stage)]
    pub until: Option<Stage>,
    /// Write programs even if the checks failed; their headers say so.
    #[arg(long)]
    pub force: bool,
    /// Most bytes of preview.glb, as in 10MB; default 10MB. Triangles, points and keys are thinned
    /// to keep it.
    #[arg(long, value_name = "SIZE", value_parser = parse_bytes)]
    pub preview_budget: Option<Bytes>,
}

/// `compare`.
#[derive(Debug, clap::Args)]
pub struct Compare {
    /// What is to be planned.
    #[command(flatten)]
    pub job: Job,
    /// Limit velocity and acceleration only: quicker to compute.
    #[arg(long)]
    pub no_jerk: bool,
}

/// `channel`.
#[derive(Debug, clap::Args)]
pub struct Channel {
    /// What is to be looked at.
    #[command(flatten)]
    pub job: Job,
    /// Width at the narrowest place against B: from, to and step in degrees; without a value
    /// -20,45,2.5.
    #[arg(
        long,
        value_name = "FROM,TO,STEP",
        num_args = 0..=1,
        require_equals = true,
        default_missing_value = "-20,45,2.5",
        allow_hyphen_values = true,
        value_parser = parse_sweep
    )]
    pub sweep_b: Option<SweepRange>,
    /// Tool axes that are free all over the sphere, at a location by its number from 0; without a
    /// value where the channel is narrowest.
    #[arg(
        long,
        value_name = "LOCATION",
        num_args = 0..=1,
        require_equals = true,
        default_missing_value = "narrowest",
        value_parser = parse_location
    )]
    pub sphere: Option<SphereAt>,
}

/// A location; `None`: where the channel is narrowest.
#[derive(Debug, Clone, Copy)]
pub struct SphereAt(pub Option<usize>);

fn parse_location(text: &str) -> Result<SphereAt, String> {
    match text {
        "narrowest" => Ok(SphereAt(None)),
        _ => text.parse().map(|k| SphereAt(Some(k))).map_err(|_| "give the number of a location, as in 120".into()),
    }
}

/// From, to, step.
#[derive(Debug, Clone, Copy)]
pub struct SweepRange(pub [f64; 3]);

fn parse_sweep(text: &str) -> Result<SweepRange, String> {
    match three(text) {
        Some([from, to, step]) if from < to && step > 0.0 && (to - from) / step <= 1000.0 => {
            Ok(SweepRange([from, to, step]))
        }
        _ => Err("give FROM,TO,STEP in degrees, at most 1000 steps, as in -20,45,2.5".into()),
    }
}

/// `pinch`.
#[derive(Debug, clap::Args)]
pub struct Pinch {
    /// What is to be looked at.
    #[command(flatten)]
    pub job: Job,
}

/// `advise`.
#[derive(Debug, clap::Args)]
pub struct Advise {
    /// The model, or a job file (TOML).
    pub input: PathBuf,
    /// Folder for advice.json; without it, it is only printed.
    #[arg(short, long, value_name = "OUT")]
    pub out: Option<PathBuf>,
    /// For two tools on one blade: which leans of both open the rows, B and `pinch.b_2_deg`.
    #[arg(long)]
    pub pinch: bool,
    /// How to read the model.
    #[command(flatten)]
    pub reading: Reading,
    /// Change a key of the job; may be given more than once.
    #[arg(long = "set", value_name = "KEY=VALUE", allow_hyphen_values = true)]
    pub set: Vec<String>,
}

fn parse_stage(text: &str) -> Result<Stage, String> {
    let stages = [
        ("section", Stage::Section),
        ("path", Stage::Path),
        ("channel", Stage::Channel),
        ("schedule", Stage::Schedule),
        ("verify", Stage::Verify),
    ];
    stages
        .iter()
        .find(|(name, _)| *name == text)
        .map(|(_, stage)| *stage)
        .ok_or_else(|| format!("there is no stage {text}; stages: {}", stages.map(|(name, _)| name).join(", ")))
}

/// A size in bytes.
#[derive(Debug, Clone, Copy)]
pub struct Bytes(pub usize);

fn parse_bytes(text: &str) -> Result<Bytes, String> {
    let text = text.trim();
    let digits = text.find(|c: char| !(c.is_ascii_digit() || c == '.')).unwrap_or(text.len());
    let (number, unit) = text.split_at(digits);
    let factor = match unit.trim().to_ascii_lowercase().as_str() {
        "" | "b" => 1.0,
        "kb" | "k" => 1e3,
        "mb" | "m" => 1e6,
        "gb" | "g" => 1e9,
        _ => f64::NAN,
    };
    let bytes = number.parse::<f64>().unwrap_or(f64::NAN) * factor;
    if (1e4..=4e9).contains(&bytes) {
        Ok(Bytes(bytes as usize))
    } else {
        Err("give a size from 10KB to 4GB, as in 10MB".into())
    }
}

/// A kind of picture.
#[derive(Debug, Clone, Copy, PartialEq, Eq, clap::ValueEnum)]
pub enum Format {
    /// Lines and text, at any size.
    Svg,
    /// Pixels.
    Png,
}

/// `plot`.
#[derive(Debug, clap::Args)]
pub struct Plot {
    /// The folder of a finished run.
    pub run: PathBuf,
    /// Turn to plot, from 1; default: the middle one.
    #[arg(long, value_name = "N")]
    pub turn: Option<usize>,
    /// Kinds of files.
    #[arg(long, value_enum, value_delimiter = ',', default_value = "svg,png")]
    pub format: Vec<Format>,
    /// Width of the PNG files, pixels.
    #[arg(long, value_name = "PX", default_value_t = 1720, value_parser = clap::value_parser!(u32).range(100..=20_000))]
    pub width: u32,
    /// Folder for the pictures; default: plots in the run's folder.
    #[arg(short, long, value_name = "DIR")]
    pub out: Option<PathBuf>,
}

/// `completions`.
#[derive(Debug, clap::Args)]
pub struct Completions {
    /// For which shell.
    #[arg(value_enum)]
    pub shell: clap_complete::Shell,
}

/// `man`.
#[derive(Debug, clap::Args)]
pub struct Man {
    /// Folder for the pages.
    #[arg(short, long, value_name = "DIR")]
    pub out: PathBuf,
}

/// `preview`.
#[derive(Debug, clap::Args)]
pub struct Preview {
    /// The folder of a finished run.
    pub out: PathBuf,
    /// Most bytes of preview.glb, as in 10MB; default 10MB. Triangles, points and keys are thinned
    /// to keep it.
    #[arg(long, value_name = "SIZE", value_parser = parse_bytes)]
    pub preview_budget: Option<Bytes>,
}

/// `batch`.
#[derive(Debug, clap::Args)]
#[command(args_conflicts_with_subcommands = true, subcommand_negates_reqs = true)]
pub struct Batch {
    /// Tables of a family that was planned in shards.
    #[command(subcommand)]
    pub verb: Option<BatchVerb>,
    /// The family file (TOML).
    #[arg(required = true)]
    pub family: Option<PathBuf>,
    /// Folder for the results, or s3://BUCKET/PREFIX; what it has already is kept.
    #[arg(short, long, value_name = "OUT", required_unless_present = "list")]
    pub out: Option<String>,
    /// Plan part I of N only (from 1); parts are equal by estimated cost.
    #[arg(long, value_name = "I/N")]
    pub shard: Option<Shard>,
    /// Plan members again that failed, and no others.
    #[arg(long)]
    pub retry: bool,
    /// Memory to share out among members, MiB; default: 80 % of what is available.
    #[arg(long, value_name = "MIB", value_parser = clap::value_parser!(u64).range(1..))]
    pub memory: Option<u64>,
    /// Print the members with what they are likely to cost, and do nothing.
    #[arg(long)]
    pub list: bool,
}

/// What else `batch` does.
#[derive(Debug, Subcommand)]
pub enum BatchVerb {
    /// Write family.csv, family.parquet and family.html from what the shards left.
    Merge {
        /// The family file (TOML).
        family: PathBuf,
        /// Where the shards wrote to.
        #[arg(short, long, value_name = "OUT")]
        out: String,
    },
}

/// Options that say how a program that others wrote is to be read.
#[derive(Debug, Clone, Default, clap::Args)]
pub struct Manner {
    /// The control that the program is for; default: found from its words.
    #[arg(long, value_parser = words::parser::<Control>(), requires = "part")]
    pub control: Option<Control>,
    /// A post file (TOML) that says how the program is written.
    #[arg(long, value_name = "FILE", requires = "part", conflicts_with = "control")]
    pub post_file: Option<PathBuf>,
    /// What X Y Z are: the tool tip, the ball centre, or positions of the machine's axes; default:
    /// as the control has it, and the tip where the tool is no ball.
    #[arg(long, value_parser = words::parser::<Programmed>(), requires = "part")]
    pub programmed: Option<Programmed>,
    /// Zero of the program, mm: in the blade frame under tool-centre-point control, else what is
    /// added to X Y Z of the axes.
    #[arg(long, value_name = "X,Y,Z", allow_hyphen_values = true, value_parser = parse_point, requires = "part")]
    pub origin: Option<Axis>,
    /// The program's coordinates are those of the CAD model, not of the blade frame (x along the
    /// blade axis).
    #[arg(long, requires = "part", conflicts_with = "origin")]
    pub cad: bool,
    /// Find where the program lies over the part, from where its balls touch it: frame (or work
    /// offset), and whether X Y Z are tips or ball centres where nothing says it. Exit
    /// code 3 where no frame fits, or more than one.
    #[arg(long, requires = "part", conflicts_with_all = ["origin", "cad"])]
    pub fit: bool,
}

/// `reschedule`.
#[derive(Debug, clap::Args)]
pub struct Reschedule {
    /// The program.
    pub program: PathBuf,
    /// The part that it is for: a model.
    #[arg(long, value_name = "MODEL")]
    pub part: PathBuf,
    /// The tool (TOML): radius_mm, taper_deg, shank_radius_mm, stickout_mm, holder;
    /// job.resolved.toml of a run will do.
    #[arg(long, value_name = "FILE")]
    pub tool: PathBuf,
    /// The machine (TOML); default: the built-in demo machine.
    #[arg(long, value_name = "FILE")]
    pub machine: Option<PathBuf>,
    /// How to read the model.
    #[command(flatten)]
    pub reading: Reading,
    /// How to read the program.
    #[command(flatten)]
    pub manner: Manner,
    /// Stock that the program leaves on the part, mm; default: what most of its lines leave.
    #[arg(long, value_name = "MM", value_parser = parse_positive)]
    pub stock: Option<f64>,
    /// How θ is scheduled; default: the fastest of all kinds.
    #[arg(long, value_parser = words::parser::<ScheduleKind>())]
    pub schedule: Option<ScheduleKind>,
    /// Room that taper and shank keep from the part, mm; default: as for plans.
    #[arg(long, value_name = "MM", value_parser = parse_positive)]
    pub clearance: Option<f64>,
    /// Room that the holder keeps from the part, mm; default: as for plans.
    #[arg(long, value_name = "MM", value_parser = parse_positive)]
    pub holder_clearance: Option<f64>,
    /// New feed of the ball centre, mm/min; default: each line keeps its own.
    #[arg(long, value_name = "MM_MIN", value_parser = parse_positive)]
    pub feed: Option<f64>,
    /// Deepest gouge that the audits allow, mm.
    #[arg(long, value_name = "MM", value_parser = parse_positive, default_value_t = VerifySettings::default().gouge_mm)]
    pub gouge: f64,
    /// Write the new program whole for these controls besides, with approach and retract of our
    /// own: siemens,linuxcnc.
    #[arg(long = "for", value_name = "CONTROLS", value_delimiter = ',', value_parser = words::parser::<Control>())]
    pub controls: Vec<Control>,
    /// The same with an own post file (TOML); may be given more than once.
    #[arg(long, value_name = "FILE")]
    pub post_file: Vec<PathBuf>,
    /// Folder for the new program, the report and the plot.
    #[arg(short, long, value_name = "DIR")]
    pub out: PathBuf,
}

/// `verify`.
#[derive(Debug, clap::Args)]
pub struct Verify {
    /// The folder of a finished run, or a program together with --part and --tool.
    pub what: PathBuf,
    /// The program of the second channel, where two tools cut in two channels.
    #[arg(requires = "part")]
    pub second: Option<PathBuf>,
    /// The part that the program is for: a model.
    #[arg(long, value_name = "MODEL", requires = "tool")]
    pub part: Option<PathBuf>,
    /// The tool (TOML): radius_mm, taper_deg, shank_radius_mm, stickout_mm, holder, and
    /// corner_radius_mm where it is no ball; job.resolved.toml of a run will do. Given more than
    /// once: the tools that the program calls (M6, TOOL CALL, LOADTL), in that order; where two
    /// tools cut at the same time, those of both heads.
    #[arg(long, value_name = "FILE", requires = "part")]
    pub tool: Vec<PathBuf>,
    /// The machine (TOML); default: the built-in demo machine. With two heads, the program may be
    /// one of two tools.
    #[arg(long, value_name = "FILE", requires = "part")]
    pub machine: Option<PathBuf>,
    /// How to read the model.
    #[command(flatten)]
    pub reading: Reading,
    /// How to read the program.
    #[command(flatten)]
    pub manner: Manner,
    /// Greatest scallop, mm; without it the scallop is measured, not judged.
    #[arg(long, value_name = "MM", value_parser = parse_positive, requires = "part")]
    pub scallop: Option<f64>,
    /// Deepest gouge, mm.
    #[arg(long, value_name = "MM", value_parser = parse_positive, default_value_t = VerifySettings::default().gouge_mm, requires = "part")]
    pub gouge: f64,
    /// Stock that is to stay on the part, mm.
    #[arg(long, value_name = "MM", value_parser = parse_positive, requires = "part")]
    pub stock: Option<f64>,
    /// Write all findings as JSON.
    #[arg(long, value_name = "FILE", requires = "part")]
    pub report: Option<PathBuf>,
    /// Write the deviation map, what is left over the part: FILE.glb in colours, FILE.csv as a
    /// table.
    #[arg(long, value_name = "FILE", value_parser = parse_map)]
    pub map: Option<PathBuf>,
    /// Tolerance of the map, mm.
    #[arg(long, value_name = "MM", value_parser = parse_positive, default_value_t = CHORD_MM, requires = "map")]
    pub map_tolerance: f64,
}

fn parse_map(text: &str) -> Result<PathBuf, String> {
    let path = PathBuf::from(text);
    let known = path.extension().is_some_and(|e| e == "glb" || e == "csv");
    known.then_some(path).ok_or_else(|| "give a file that ends in .glb or .csv".into())
}

fn parse_point(text: &str) -> Result<Axis, String> {
    match three(text) {
        Some(point) => Ok(Axis(point)),
        None => Err("give three numbers, as in 0,0,-120".into()),
    }
}

/// `post`.
#[derive(Debug, clap::Args)]
pub struct Post {
    /// The folder of a finished run; several of the same part on the same machine are the
    /// operations of one program, in this order.
    #[arg(required = true, value_name = "RUN")]
    pub runs: Vec<PathBuf>,
    /// Folder for the program; default: that of the run, where there is one.
    #[arg(long, short, value_name = "FOLDER")]
    pub out: Option<PathBuf>,
    /// The control to write for.
    #[arg(long, value_parser = words::parser::<Control>(), required_unless_present = "post_file")]
    pub control: Option<Control>,
    /// An own post file (TOML) to write with; models/posts has the built-in ones to begin with.
    #[arg(long, value_name = "FILE", conflicts_with = "control")]
    pub post_file: Option<PathBuf>,
    /// Begin with this turn, from 1, to go on after a break: approach and retract as for the whole.
    /// Programs mark where turns begin.
    #[arg(long, value_name = "N")]
    pub from_turn: Option<usize>,
    /// Begin with this operation, from 1, to go on after a break; `--from-turn` counts its turns.
    #[arg(long, value_name = "K")]
    pub from_operation: Option<usize>,
    /// Machine every blade of the wheel, one after another: the rotary axis that carries the wheel
    /// goes on from blade to blade. Each blade is an operation, and `--from-operation` counts them.
    #[arg(long, requires = "out")]
    pub every_blade: bool,
    /// Write the program even if the checks fail; its header says so.
    #[arg(long)]
    pub force: bool,
}
