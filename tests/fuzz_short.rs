//! A short, seeded form of the fuzzing of `examples/fuzz_readers.rs`: damaged models in every
//! format give a survey or an error, damaged programs of every grammar moves or an error, never a
//! panic, and memory stays within bounds.

#[path = "../fuzz/mutate.rs"]
mod mutate;
#[path = "../fuzz/nc.rs"]
mod nc;
#[path = "../fuzz/seeds.rs"]
mod seeds;

use std::path::Path;

use bladewright::observe::Silent;
use bladewright::read::model::{self, ModelOptions};
use mutate::{Random, count_own_panics, mutated, own_panics};

/// Mutations of each seed.
const RUNS: usize = 60;
/// Most memory of the whole test, MB.
const MOST_MB: u64 = 1500;

/// Mutations of one seed: none panics, some can still be read and some not, so the damage is
/// neither too weak nor too strong.
fn survives(path: &Path, bytes: &[u8]) {
    let name = path.display();
    let options = ModelOptions { deflection_mm: 0.5, ..ModelOptions::default() };
    let look = |bytes: &[u8]| model::survey_bytes(path, bytes, &options, &Silent);
    let whole = look(bytes).unwrap_or_else(|e| panic!("{name}: the seed itself is not read: {e}"));
    assert!(whole.diagnosis.closed, "{name}: the seed is not closed");
    let mut random = Random(0xb1ade);
    count_own_panics();
    let good = (0..RUNS).filter(|_| look(&mutated(bytes, &mut random)).is_ok()).count();
    assert_eq!(own_panics(), 0, "{name}: our own code panicked");
    assert!(good > 0 && good < RUNS, "{name}: {good} of {RUNS} were read");
    let peak = peak_mb();
    assert!(peak < MOST_MB, "{name}: {peak} MB");
}

fn peak_mb() -> u64 {
    let status = std::fs::read_to_string("/proc/self/status").unwrap_or_default();
    let line = status.lines().find(|l| l.starts_with("VmHWM:")).unwrap_or_default().to_owned();
    line.split_whitespace().nth(1).and_then(|kb| kb.parse::<u64>().ok()).unwrap_or(0) / 1024
}

/// All seeds with one of these extensions; the header among them beside its data.
fn each(extensions: &[&str]) {
    let folder = tempfile::tempdir().expect("temporary folder");
    std::fs::write(folder.path().join("table.dat"), seeds::table()).expect("written");
    let mine = |name: &str| extensions.iter().any(|e| name.ends_with(e));
    let seeds: Vec<_> = seeds::all().into_iter().filter(|(name, _)| mine(name)).collect();
    assert!(extensions.iter().all(|e| seeds.iter().any(|(name, _)| name.ends_with(e))), "a format has no seed");
    seeds.iter().for_each(|(name, bytes)| survives(&folder.path().join(name), bytes));
}

#[test]
fn damaged_meshes_never_panic() {
    each(&["ascii.stl", "binary.stl", ".obj", "ascii.ply", "binary.ply", ".gltf", ".glb"]);
}

#[test]
fn damaged_faces_never_panic() {
    each(&[".igs", ".step"]);
    let file = Path::new(env!("CARGO_MANIFEST_DIR")).join("models/prism.step");
    survives(&file, &std::fs::read(&file).expect("readable"));
}

#[test]
fn damaged_tables_never_panic_and_end() {
    each(&["columns.dat", ".toml", ".curve", "tecplot.dat", "blade3d.dat"]);
}

/// Mutations of each program.
const PROGRAMS: usize = 2000;

#[test]
fn damaged_programs_never_panic() {
    let shop = nc::Shop::new().expect("the built-in machine");
    let seeds = nc::seeds();
    assert!(nc::NAMES.iter().all(|n| seeds.iter().any(|(name, _)| name.ends_with(n))), "a grammar has no seed");
    for (name, bytes) in &seeds {
        let lines = bytes.iter().filter(|b| **b == b'\n').count();
        assert!((10..60).contains(&lines), "{name}: {lines} lines");
        let moves = shop.moved(name, bytes).unwrap_or_else(|e| panic!("{name}: the seed itself is not read: {e}"));
        assert!(moves.len() > 3, "{name}");
        let mut random = Random(0xb1ade);
        let good = (0..PROGRAMS).filter(|_| shop.moved(name, &nc::damaged(name, bytes, &mut random)).is_ok()).count();
        assert!(good > PROGRAMS / 50 && good < PROGRAMS, "{name}: {good} of {PROGRAMS} were read");
    }
}
