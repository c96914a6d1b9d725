//! A short, seeded form of the fuzzing of `examples/fuzz_readers.rs`: damaged models in every format give a survey or an error,
//! never a panic, and memory stays within bounds.

#[path = "../fuzz/mutate.rs"]
mod mutate;

use std::path::Path;

use base64::Engine as _;
use base64::engine::general_purpose::STANDARD;
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

/// The same as glTF with its buffer in a data URI, and as GLB, where the buffer follows the text.
fn gltf(binary: bool) -> Vec<u8> {
    let buffer: Vec<u8> = corners().iter().flatten().flatten().flat_map(|x| (*x as f32 * 1e-3).to_le_bytes()).collect();
    let uri = if binary {
        String::new()
    } else {
        format!(",\"uri\":\"data:application/octet-stream;base64,{}\"", STANDARD.encode(&buffer))
    };
    let n = 3 * corners().len();
    let mut text = format!(
        "{{\"asset\":{{\"version\":\"2.0\"}},\n\"scene\":0,\n\"scenes\":[{{\"nodes\":[0]}}],\n\"nodes\":[{{\"mesh\":0,\"translation\":[0.01,0,0]}}],\n\
         \"meshes\":[{{\"primitives\":[{{\"attributes\":{{\"POSITION\":0}},\"mode\":4}}]}}],\n\
         \"accessors\":[{{\"bufferView\":0,\"componentType\":5126,\"count\":{n},\"type\":\"VEC3\",\"min\":[-0.02,-0.01,0],\"max\":[0.02,0.01,0.06]}}],\n\
         \"bufferViews\":[{{\"buffer\":0,\"byteOffset\":0,\"byteLength\":{0}}}],\n\"buffers\":[{{\"byteLength\":{0}{uri}}}]}}\n",
        buffer.len()
    );
    if !binary {
        return text.into_bytes();
    }
    while text.len() % 4 != 0 {
        text.push(' ');
    }
    let total = 12 + 8 + text.len() + 8 + buffer.len();
    let word = |n: usize| (n as u32).to_le_bytes();
    let head = [*b"glTF", word(2), word(total), word(text.len()), *b"JSON"].concat();
    [head, text.into_bytes(), word(buffer.len()).to_vec(), b"BIN\0".to_vec(), buffer].concat()
}

/// A table of sections with a header: a blade of seven sections, leaning, cylindrical coordinates as compressors are published in.
fn table() -> Vec<u8> {
    let mut text = String::from(
        "+++\n[sections]\nunit = \"cm\"\ncolumns = [\"skip\", \"z\", \"r\", \"theta1\", \"theta2\"]\n+++\n Blade Geometry\n",
    );
    for section in 0..7 {
        let r = 17.0 + f64::from(section);
        text += &format!("\n SURFACE NUMBER {}\n    J      Z           R         THETA 1     THETA 2\n", section + 1);
        for j in 0..25 {
            let x = 0.5 * (1.0 - (std::f64::consts::PI * f64::from(j) / 24.0).cos());
            let (camber, half) = (0.9 * x * (1.0 - x) + 1.6 * x, 0.25 * (x * (1.0 - x)).max(0.0).sqrt());
            text += &format!(
                "{:5} {:11.7} {r:11.7} {:11.7} {:11.7}\n",
                j + 1,
                3.0 * x,
                (camber + half) / r,
                (camber - half) / r
            );
        }
    }
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
    let seeds = [
        ("a.stl", ascii_stl()),
        ("b.stl", binary_stl()),
        ("c.obj", obj()),
        ("d.ply", ply()),
        ("e.gltf", gltf(false)),
        ("f.glb", gltf(true)),
    ];
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

#[test]
fn damaged_tables_never_panic_and_end() {
    let good = survives("r.dat", &table(), RUNS);
    assert!(good > 0 && good < RUNS, "{good} of {RUNS} were read");
}
