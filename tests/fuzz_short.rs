//! A short, seeded form of the fuzzing of `examples/fuzz_readers.rs`: damaged models in every format give a survey or an error,
//! never a panic, and memory stays within bounds.

#[path = "../fuzz/mutate.rs"]
mod mutate;

use std::path::Path;

use bladewright::model::{self, ModelOptions};
use bladewright::observe::Silent;
use mutate::{Random, mutated};

/// Mutations of each seed.
const RUNS: usize = 60;
/// Most memory of the whole test, MB.
const MOST_MB: u64 = 1500;

/// A blade of few triangles: a block with a slender prism on it.
fn corners() -> Vec<[[f64; 3]; 3]> {
    let mut out = Vec::new();
    for (half, z) in [([20.0, 10.0], [0.0, 10.0]), ([12.0, 1.5], [10.0, 60.0])] {
        let p = |i: usize| {
            let s = |bit: usize| if bit == 0 { -1.0 } else { 1.0 };
            [half[0] * s(i & 1), half[1] * s(i >> 1 & 1), z[i >> 2]]
        };
        for q in [[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]] {
            out.push([p(q[0]), p(q[1]), p(q[2])]);
            out.push([p(q[0]), p(q[2]), p(q[3])]);
        }
    }
    out
}

fn ascii_stl() -> Vec<u8> {
    let mut text = String::from("solid a\n");
    for t in corners() {
        text += "facet normal 0 0 0\nouter loop\n";
        t.iter().for_each(|p| text += &format!("vertex {} {} {}\n", p[0], p[1], p[2]));
        text += "endloop\nendfacet\n";
    }
    (text + "endsolid a\n").into_bytes()
}

fn binary_stl() -> Vec<u8> {
    let mut out = vec![b' '; 80];
    out.extend((corners().len() as u32).to_le_bytes());
    for t in corners() {
        out.extend([0u8; 12]);
        t.iter().flatten().for_each(|x| out.extend((*x as f32).to_le_bytes()));
        out.extend([0u8; 2]);
    }
    out
}

fn ply() -> Vec<u8> {
    let n = corners().len();
    let mut text = format!(
        "ply\nformat ascii 1.0\nelement vertex {}\nproperty float x\nproperty float y\nproperty float z\nelement face {n}\nproperty list uchar int vertex_indices\nend_header\n",
        3 * n
    );
    corners().iter().flatten().for_each(|p| text += &format!("{} {} {}\n", p[0], p[1], p[2]));
    (0..n).for_each(|t| text += &format!("3 {} {} {}\n", 3 * t, 3 * t + 1, 3 * t + 2));
    text.into_bytes()
}

fn obj() -> Vec<u8> {
    let mut text = String::from("g a\n");
    corners().iter().flatten().for_each(|p| text += &format!("v {} {} {}\n", p[0], p[1], p[2]));
    (0..corners().len()).for_each(|t| text += &format!("f {} {} {}\n", 3 * t + 1, 3 * t + 2, 3 * t + 3));
    text.into_bytes()
}

/// Mutations of one seed; how many of them could still be read.
fn survives(name: &str, bytes: &[u8], runs: usize) -> usize {
    let options = ModelOptions { deflection_mm: 0.5, ..ModelOptions::default() };
    let look = |bytes: &[u8]| model::survey_bytes(Path::new(name), bytes, &options, &Silent).is_ok();
    assert!(look(bytes), "{name}: the seed itself is not read");
    let mut random = Random(0xb1ade);
    let good = (0..runs).filter(|_| look(&mutated(bytes, &mut random))).count();
    let peak = peak_mb();
    assert!(peak < MOST_MB, "{name}: {peak} MB");
    good
}

fn peak_mb() -> u64 {
    let status = std::fs::read_to_string("/proc/self/status").unwrap_or_default();
    let line = status.lines().find(|l| l.starts_with("VmHWM:")).unwrap_or_default().to_owned();
    line.split_whitespace().nth(1).and_then(|kb| kb.parse::<u64>().ok()).unwrap_or(0) / 1024
}

#[test]
fn damaged_meshes_never_panic() {
    let seeds: [(&str, Vec<u8>); 4] =
        [("a.stl", ascii_stl()), ("b.stl", binary_stl()), ("c.obj", obj()), ("d.ply", ply())];
    for (name, bytes) in seeds {
        let good = survives(name, &bytes, RUNS);
        // Damage that no reader notices and damage that it refuses both occur: the mutations are neither too weak nor too strong.
        assert!(good > 0 && good < RUNS, "{name}: {good} of {RUNS} were read");
    }
}

#[test]
fn damaged_step_never_panics() {
    let file = Path::new(env!("CARGO_MANIFEST_DIR")).join("models/prism.step");
    let bytes = std::fs::read(file).expect("readable");
    let good = survives("prism.step", &bytes, RUNS);
    assert!(good < RUNS, "{good} of {RUNS} were read");
}
