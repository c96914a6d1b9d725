//! Mutated model files and NC programs against every reader, on stable Rust:
//! `cargo run --release --example fuzz_readers -- LENGTH [FORMATS] [FOLDER]`.
//!
//! Seeds: the models of the repository, small ones in every format, and all files of FOLDER;
//! published tables of points under a header that says what their columns mean; short programs of
//! every family of controls, which are read and moved through the demo machine. FORMATS are some of
//! [`FORMATS`] with commas between, `models`, `programs` or `all`. LENGTH is for each format:
//! seconds (`600`) or executions (`1000000x`). A panic, more than [`SLOW_S`] for one file, or more
//! than [`MOST_MB`] of memory ends the run; the file that did it is left in `out/fuzz`. The same
//! seconds do not give the same files: the seed of each run is printed.

#![allow(clippy::print_stdout)]

#[path = "../fuzz/mutate.rs"]
mod mutate;
#[path = "../fuzz/nc.rs"]
mod nc;
#[path = "../fuzz/seeds.rs"]
mod seeds;

use std::path::{Path, PathBuf};
use std::sync::Mutex;
use std::sync::atomic::{AtomicU64, Ordering};
use std::time::{Duration, Instant};

use base64::Engine as _;
use bladewright::observe::Silent;
use bladewright::read::model::format::{Format, detect};
use bladewright::read::model::table::direct::{self, TableKind};
use bladewright::read::model::{self, ModelOptions};
use mutate::{Random, count_own_panics, mutated, own_panics};

/// Longest processor time for one file, s.
const SLOW_S: u64 = 30;
/// Most memory, MB.
const MOST_MB: u64 = 2048;
/// Larger seeds are left out: a mutation of one is read too seldom.
const LARGEST: usize = 1_500_000;

/// Formats by their readers: five of them are the kinds of section tables (columns under a header,
/// a header that names its file), the last five programs.
const FORMATS: [&str; 18] = [
    "step",
    "igs",
    "obj",
    "stl-ascii",
    "stl-binary",
    "ply",
    "glb",
    "gltf",
    "columns",
    "header",
    "curve",
    "tecplot",
    "blade3d",
    nc::NAMES[0],
    nc::NAMES[1],
    nc::NAMES[2],
    nc::NAMES[3],
    nc::NAMES[4],
];
/// What the columns of published tables mean, by their names; files that share a name's beginning
/// are one table.
const HEADERS: [(&str, &str); 3] = [
    ("rotor37geometry", "unit = \"cm\"\ncolumns = [\"skip\", \"z\", \"r\", \"theta1\", \"theta2\"]\n"),
    ("HECCcoordinates", "unit = \"inch\"\ncolumns = [\"x\", \"r*theta\", \"r\"]\n"),
    ("LS89_profile", "unit = \"m\"\ncolumns = [\"skip\", \"z\", \"x\", \"y\"]\nextrude = 0.1\n"),
];

/// How many files have been begun; even: none is at work.
static BEGUN: AtomicU64 = AtomicU64::new(0);
/// The file at work.
static CURRENT: Mutex<(String, Vec<u8>)> = Mutex::new((String::new(), Vec::new()));

/// How long each format is run.
#[derive(Clone, Copy)]
enum Length {
    Seconds(u64),
    Executions(u64),
}

impl Length {
    fn parse(text: &str) -> Option<Self> {
        match text.strip_suffix('x') {
            Some(count) => count.parse().ok().map(Length::Executions),
            None => text.parse().ok().map(Length::Seconds),
        }
    }

    fn over(self, begun: Instant, runs: u64) -> bool {
        match self {
            Length::Seconds(s) => begun.elapsed() >= Duration::from_secs(s),
            Length::Executions(count) => runs >= count,
        }
    }
}

fn main() {
    let mut args = std::env::args().skip(1);
    let length = args.next();
    let Some(length) = length.map_or(Some(Length::Seconds(60)), |l| Length::parse(&l)) else {
        return eprintln!("give seconds, as 600, or executions, as 1000000x");
    };
    let only = args.next().unwrap_or_else(|| "all".into());
    let programs = |format: &str| nc::NAMES.contains(&format);
    let wanted = |format: &str| {
        only.split(',').any(|o| {
            o == format || o == "all" || o == "programs" && programs(format) || o == "models" && !programs(format)
        })
    };
    // Data of headers lie in a folder of their own.
    let Ok(data) = tempfile::tempdir() else { return eprintln!("no temporary folder") };
    let Ok(shop) = nc::Shop::new() else { return eprintln!("no machine") };
    let mut seeds = seeds(Path::new("models"), data.path());
    if let Some(folder) = args.next() {
        let found = files(Path::new(&folder));
        seeds.extend(HEADERS.iter().flat_map(|(name, header)| headed(&found, name, header, data.path())));
        seeds.extend(found);
    }
    seeds.retain(|(_, bytes)| bytes.len() <= LARGEST);
    std::thread::spawn(watch);
    count_own_panics();
    let mut total = 0;
    for format in FORMATS.into_iter().filter(|f| wanted(f)) {
        let mine: Vec<(String, Vec<u8>)> = if programs(format) {
            nc::seeds().into_iter().filter(|(name, _)| name.ends_with(format)).collect()
        } else {
            seeds.iter().filter(|(name, bytes)| kind(name, bytes) == format).cloned().collect()
        };
        if !mine.is_empty() {
            total += run(format, &mine, length, &shop);
        }
    }
    println!("{total} executions, no panic");
}

/// One format; the number of executions.
fn run(format: &str, seeds: &[(String, Vec<u8>)], length: Length, shop: &nc::Shop) -> u64 {
    let seed = std::time::UNIX_EPOCH.elapsed().map_or(0x5eed, |d| d.as_nanos() as u64);
    let (mut random, mut runs, mut read) = (Random(seed), 0u64, 0u64);
    let (mut slowest, begun) = ((Duration::ZERO, String::new()), Instant::now());
    let program = nc::NAMES.contains(&format);
    let shares: Vec<f64> = seeds.iter().map(|(_, bytes)| 1.0 / bytes.len().max(1) as f64).collect();
    while !length.over(begun, runs) {
        let (name, bytes) = &seeds[chosen(&shares, &mut random)];
        let bytes = if program { nc::damaged(name, bytes, &mut random) } else { mutated(bytes, &mut random) };
        if let Ok(mut current) = CURRENT.lock() {
            *current = (name.clone(), bytes.clone());
        }
        BEGUN.fetch_add(1, Ordering::SeqCst);
        let since = Instant::now();
        let look = || {
            if program {
                return shop.moved(name, &bytes).is_ok();
            }
            let options = ModelOptions { deflection_mm: 0.5, ..ModelOptions::default() };
            model::survey_bytes(Path::new(name), &bytes, &options, &Silent).is_ok()
        };
        let found = std::panic::catch_unwind(std::panic::AssertUnwindSafe(look));
        BEGUN.fetch_add(1, Ordering::SeqCst);
        match found {
            Ok(good) => read += u64::from(good),
            Err(_) => stop("panicked"),
        }
        if own_panics() > 0 {
            stop("panicked");
        }
        if since.elapsed() > slowest.0 {
            slowest = (since.elapsed(), name.rsplit('/').next().unwrap_or(name).to_owned());
        }
        runs += 1;
    }
    let per_s = runs as f64 / begun.elapsed().as_secs_f64();
    println!(
        "{format}: {runs} executions, {per_s:.0} a second, from {} seeds, {read} of them read, the slowest {:.3} s ({}), seed {seed:#x}, peak {} MB",
        seeds.len(),
        slowest.0.as_secs_f64(),
        slowest.1,
        peak_mb()
    );
    runs
}

/// A seed by its share of all: the shorter the more often, so that no long one takes most of the
/// time.
fn chosen(shares: &[f64], random: &mut Random) -> usize {
    const STEPS: usize = 1 << 32;
    let mut left = shares.iter().sum::<f64>() * random.below(STEPS) as f64 / STEPS as f64;
    for (k, share) in shares.iter().enumerate() {
        left -= share;
        if left < 0.0 {
            return k;
        }
    }
    shares.len().saturating_sub(1)
}

/// Keeps the file at work and ends.
fn stop(why: &str) -> ! {
    if let Ok(current) = CURRENT.lock() {
        let folder = PathBuf::from("out/fuzz");
        let _ = std::fs::create_dir_all(&folder);
        let name = Path::new(&current.0).file_name().map(|n| n.to_string_lossy().into_owned()).unwrap_or_default();
        let file = folder.join(format!("{why}_{name}"));
        let _ = std::fs::write(&file, &current.1);
        eprintln!("{why}: {}", file.display());
    }
    std::process::exit(1)
}

/// Ends the run where one file takes too long or too much.
fn watch() {
    let (mut at_work, mut since_ms) = (0, 0);
    loop {
        std::thread::sleep(Duration::from_millis(50));
        let begun = BEGUN.load(Ordering::SeqCst);
        if begun != at_work {
            (at_work, since_ms) = (begun, busy_ms());
        } else if begun % 2 == 1 && busy_ms() > since_ms + 1000 * SLOW_S {
            stop("slow");
        }
        if peak_mb() > MOST_MB {
            stop("memory");
        }
    }
}

/// Processor time of the process, ms: a busy machine does not make a file slow.
fn busy_ms() -> u64 {
    let stat = std::fs::read_to_string("/proc/self/stat").unwrap_or_default();
    // After the name in brackets; user and system time are the 14th and 15th field, in hundredths
    // of a second.
    let fields: Vec<&str> = stat.rsplit(')').next().unwrap_or_default().split_whitespace().collect();
    let ticks = |k: usize| fields.get(k).and_then(|f| f.parse::<u64>().ok()).unwrap_or(0);
    10 * (ticks(11) + ticks(12))
}

fn peak_mb() -> u64 {
    let status = std::fs::read_to_string("/proc/self/status").unwrap_or_default();
    let line = status.lines().find(|l| l.starts_with("VmHWM:")).unwrap_or_default().to_owned();
    line.split_whitespace().nth(1).and_then(|kb| kb.parse::<u64>().ok()).unwrap_or(0) / 1024
}

/// The reader that a file asks for, one of [`FORMATS`]; others are left out.
fn kind(name: &str, bytes: &[u8]) -> &'static str {
    match detect(Path::new(name), bytes) {
        Ok(Format::Step) => "step",
        Ok(Format::Iges) => "igs",
        Ok(Format::Obj) => "obj",
        Ok(Format::StlAscii) => "stl-ascii",
        Ok(Format::StlBinary) => "stl-binary",
        Ok(Format::Ply) => "ply",
        Ok(Format::Gltf) if bytes.starts_with(b"glTF") => "glb",
        Ok(Format::Gltf) => "gltf",
        Ok(Format::Sections) if name.ends_with(".toml") => "header",
        Ok(Format::Sections) => match direct::detect(bytes) {
            Some(TableKind::TurboGrid) => "curve",
            Some(TableKind::Tecplot) => "tecplot",
            Some(TableKind::TBlade3) => "blade3d",
            _ => "columns",
        },
        Err(_) => "",
    }
}

/// The files whose names begin so as one table, under a header and named by one.
fn headed(files: &[(String, Vec<u8>)], name: &str, header: &str, data: &Path) -> Vec<(String, Vec<u8>)> {
    let mine = files.iter().filter(|(file, _)| file.rsplit('/').next().is_some_and(|f| f.starts_with(name)));
    let table = mine.map(|(_, bytes)| bytes.as_slice()).collect::<Vec<_>>().join(&b"\n\n"[..]);
    let file = data.join(format!("{name}.dat"));
    if table.is_empty() || std::fs::write(&file, &table).is_err() {
        return Vec::new();
    }
    let text = format!("[sections]\nfiles = {file:?}\n{header}");
    let above = format!("+++\n[sections]\n{header}+++\n");
    vec![
        (format!("{name}.dat"), [above.as_bytes(), &table].concat()),
        (data.join(format!("{name}.toml")).to_string_lossy().into_owned(), text.into_bytes()),
    ]
}

fn files(folder: &Path) -> Vec<(String, Vec<u8>)> {
    let (mut open, mut out) = (vec![folder.to_path_buf()], Vec::new());
    while let Some(dir) = open.pop() {
        for path in std::fs::read_dir(dir).into_iter().flatten().flatten().map(|e| e.path()) {
            if path.is_dir() {
                open.push(path);
            } else if let Ok(bytes) = std::fs::read(&path) {
                out.push((path.to_string_lossy().into_owned(), bytes));
            }
        }
    }
    out.sort();
    out
}

/// The models of the repository, small ones in every format, and a scene as we write it.
fn seeds(folder: &Path, data: &Path) -> Vec<(String, Vec<u8>)> {
    let mut out = files(folder);
    out.retain(|(name, _)| [".step", ".obj"].iter().any(|e| name.ends_with(e)));
    if std::fs::write(data.join("table.dat"), seeds::table()).is_ok() {
        // All beside the data that the header among them names.
        let beside = |name: &str| data.join(name).to_string_lossy().into_owned();
        out.extend(seeds::all().into_iter().map(|(name, bytes)| (beside(name), bytes)));
    }
    let prism = model::survey(&folder.join("prism.obj"), &ModelOptions::default(), &Silent);
    let scene = prism.ok().and_then(|s| bladewright::write::preview::regions("prism", &s.part.mesh, &s.areas()).ok());
    if let Some(glb) = scene {
        out.extend(text_form(&glb).map(|gltf| ("prism.gltf".to_owned(), gltf)));
        out.push(("prism.glb".into(), glb));
    }
    out
}

/// A GLB as glTF, its buffer in a data URI, line by line.
fn text_form(glb: &[u8]) -> Option<Vec<u8>> {
    let gltf = gltf::Gltf::from_slice(glb).ok()?;
    let mut document = serde_json::to_value(gltf.document.into_json()).ok()?;
    let data = base64::engine::general_purpose::STANDARD.encode(gltf.blob?);
    document["buffers"][0]["uri"] = format!("data:application/octet-stream;base64,{data}").into();
    serde_json::to_vec_pretty(&document).ok()
}
