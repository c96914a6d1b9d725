//! Mutated model files against every reader, on stable Rust: `cargo run --release --example fuzz_readers -- SECONDS [FORMAT] [FOLDER]`.
//!
//! Seeds: the models of the repository, meshes made of them in every mesh format, and all files of FOLDER. Each format is run for
//! SECONDS. A panic, more than [`SLOW_S`] for one file, or more than [`MOST_MB`] of memory ends the run; the file that did it is
//! left in `out/fuzz`. The same seconds do not give the same files: the seed of each run is printed.

#![allow(clippy::print_stdout)]

#[path = "../fuzz/mutate.rs"]
mod mutate;

use std::path::{Path, PathBuf};
use std::sync::Mutex;
use std::sync::atomic::{AtomicU64, Ordering};
use std::time::{Duration, Instant};

use base64::Engine as _;
use bladewright::geometry::mesh::Mesh;
use bladewright::model::{self, ModelOptions};
use bladewright::observe::Silent;
use mutate::{Random, mutated};

/// Longest processor time for one file, s.
const SLOW_S: u64 = 30;
/// Most memory, MB.
const MOST_MB: u64 = 2048;
/// Larger seeds are left out: a mutation of one is read too seldom.
const LARGEST: usize = 1_500_000;

/// Processor time at which the file at work was begun, ms; 0: none.
static BEGUN_MS: AtomicU64 = AtomicU64::new(0);
/// The file at work.
static CURRENT: Mutex<(String, Vec<u8>)> = Mutex::new((String::new(), Vec::new()));

fn main() {
    let mut args = std::env::args().skip(1);
    let seconds: u64 = args.next().and_then(|s| s.parse().ok()).unwrap_or(60);
    let only = args.next().filter(|f| f != "all");
    let mut seeds = seeds(Path::new("models"));
    if let Some(folder) = args.next() {
        seeds.extend(files(Path::new(&folder)));
    }
    seeds.retain(|(_, bytes)| bytes.len() <= LARGEST);
    std::thread::spawn(watch);
    for format in ["step", "igs", "obj", "stl", "ply", "glb", "gltf", "dat", "toml", "curve"] {
        let mine: Vec<&(String, Vec<u8>)> = seeds.iter().filter(|(name, _)| kind(name) == format).collect();
        if mine.is_empty() || only.as_ref().is_some_and(|o| o != format) {
            continue;
        }
        let seed = std::time::UNIX_EPOCH.elapsed().map_or(0x5eed, |d| d.as_nanos() as u64);
        let (mut random, mut runs, mut read, mut slowest_ms) = (Random(seed), 0u64, 0u64, 0u64);
        let until = Instant::now() + Duration::from_secs(seconds);
        while Instant::now() < until {
            let (name, bytes) = mine[random.below(mine.len())];
            let bytes = mutated(bytes, &mut random);
            if let Ok(mut current) = CURRENT.lock() {
                *current = (name.clone(), bytes.clone());
            }
            let begun_ms = busy_ms();
            BEGUN_MS.store(begun_ms + 1, Ordering::SeqCst);
            let options = ModelOptions { deflection_mm: 0.5, ..ModelOptions::default() };
            let found =
                std::panic::catch_unwind(|| model::survey_bytes(Path::new(name), &bytes, &options, &Silent).is_ok());
            BEGUN_MS.store(0, Ordering::SeqCst);
            match found {
                Ok(good) => read += u64::from(good),
                Err(_) => stop("panicked"),
            }
            slowest_ms = slowest_ms.max(busy_ms() - begun_ms);
            runs += 1;
        }
        println!(
            "{format}: {runs} files from {} seeds, {read} of them read, the slowest {:.2} s, seed {seed:#x}, peak {} MB",
            mine.len(),
            slowest_ms as f64 * 1e-3,
            peak_mb()
        );
    }
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
    loop {
        std::thread::sleep(Duration::from_millis(50));
        let begun = BEGUN_MS.load(Ordering::SeqCst);
        if begun > 0 && busy_ms() > begun + 1000 * SLOW_S {
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
    // After the name in brackets; user and system time are the 14th and 15th field, in hundredths of a second.
    let fields: Vec<&str> = stat.rsplit(')').next().unwrap_or_default().split_whitespace().collect();
    let ticks = |k: usize| fields.get(k).and_then(|f| f.parse::<u64>().ok()).unwrap_or(0);
    10 * (ticks(11) + ticks(12))
}

fn peak_mb() -> u64 {
    let status = std::fs::read_to_string("/proc/self/status").unwrap_or_default();
    let line = status.lines().find(|l| l.starts_with("VmHWM:")).unwrap_or_default().to_owned();
    line.split_whitespace().nth(1).and_then(|kb| kb.parse::<u64>().ok()).unwrap_or(0) / 1024
}

/// The reader that a name asks for.
fn kind(name: &str) -> String {
    let e = Path::new(name).extension().map(|e| e.to_string_lossy().to_lowercase()).unwrap_or_default();
    match e.as_str() {
        "stp" => "step".into(),
        "iges" => "igs".into(),
        _ => e,
    }
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

/// The models of the repository, and one of them in every mesh format.
fn seeds(folder: &Path) -> Vec<(String, Vec<u8>)> {
    let mut out = files(folder);
    out.retain(|(name, _)| ["step", "igs", "obj"].contains(&kind(name).as_str()));
    let prism = model::survey(&folder.join("prism.obj"), &ModelOptions::default(), &Silent);
    if let Ok(survey) = prism {
        out.extend(mesh_formats(&survey.part.mesh));
    }
    out
}

fn mesh_formats(mesh: &Mesh) -> Vec<(String, Vec<u8>)> {
    let (mut ascii, mut binary) = (String::from("solid a\n"), vec![b' '; 80]);
    binary.extend((mesh.triangles.len() as u32).to_le_bytes());
    let mut ply = format!(
        "ply\nformat ascii 1.0\nelement vertex {}\nproperty float x\nproperty float y\nproperty float z\nelement face {}\nproperty list uchar int vertex_indices\nend_header\n",
        mesh.points.len(),
        mesh.triangles.len()
    );
    for p in &mesh.points {
        ply += &format!("{} {} {}\n", p.x, p.y, p.z);
    }
    for (t, c) in mesh.triangles.iter().enumerate() {
        ply += &format!("3 {} {} {}\n", c[0], c[1], c[2]);
        ascii += "facet normal 0 0 0\nouter loop\n";
        binary.extend([0u8; 12]);
        for p in mesh.corners(t) {
            ascii += &format!("vertex {} {} {}\n", p.x, p.y, p.z);
            [p.x, p.y, p.z].iter().for_each(|x| binary.extend((*x as f32).to_le_bytes()));
        }
        ascii += "endloop\nendfacet\n";
        binary.extend([0u8; 2]);
    }
    ascii += "endsolid a\n";
    let mut out = vec![
        ("ascii.stl".to_owned(), ascii.into_bytes()),
        ("binary.stl".into(), binary),
        ("ascii.ply".into(), ply.into_bytes()),
    ];
    let areas = vec![bladewright::artifact::blade::Area::Other; mesh.triangles.len()];
    if let Ok(glb) = bladewright::preview::regions("prism", mesh, &areas) {
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
