//! PLY and glTF: the same blade from every layout, damaged files with their sentences, mutations of
//! good files.
#![allow(clippy::unwrap_used)]

use std::fmt::Write;
use std::path::Path;

use super::sample::{Random, blade, marked};
use super::*;
use crate::error::ErrorKind;
use crate::geometry::mesh::Mesh;
use crate::observe::Silent;

fn ply(mesh: &Mesh, layout: &str) -> Vec<u8> {
    let mut out = format!("ply\nformat {layout} 1.0\ncomment a test\nelement vertex {}\n", mesh.points.len());
    out.push_str("property float red\nproperty double x\nproperty double y\nproperty double z\n");
    let n = mesh.triangles.len();
    writeln!(out, "element face {n}\nproperty list uchar int vertex_indices\nend_header").unwrap();
    if layout == "ascii" {
        mesh.points.iter().for_each(|p| writeln!(out, "1 {} {} {}", p.x, p.y, p.z).unwrap());
        mesh.triangles.iter().for_each(|t| writeln!(out, "3 {} {} {}", t[0], t[1], t[2]).unwrap());
        return out.into_bytes();
    }
    let little = layout == "binary_little_endian";
    let mut out = out.into_bytes();
    let mut put = |mut b: Vec<u8>| {
        if !little {
            b.reverse();
        }
        out.extend(b);
    };
    for p in &mesh.points {
        put(1.0f32.to_le_bytes().to_vec());
        [p.x, p.y, p.z].into_iter().for_each(|x| put(x.to_le_bytes().to_vec()));
    }
    for t in &mesh.triangles {
        put(vec![3]);
        t.iter().for_each(|i| put((*i as i32).to_le_bytes().to_vec()));
    }
    out
}

/// How a glTF names its triangles.
#[derive(Clone, Copy, PartialEq)]
enum Kind {
    Indexed(u32),
    Unindexed,
    Strips,
    Fans,
}

/// The JSON and the buffer of a glTF: the mesh in metres, under a node that is turned, shifted and
/// scaled with a child that undoes it but for a quarter turn about z.
fn gltf_parts(mesh: &Mesh, kind: Kind, uri: Option<&str>) -> (String, Vec<u8>) {
    let metres = |p: &Point| [p.x, p.y, p.z].map(|x| (x * 0.001 * 0.5) as f32);
    let mut bin = Vec::new();
    let corners: Vec<Point> = match kind {
        Kind::Indexed(_) => mesh.points.clone(),
        _ => (0..mesh.triangles.len()).flat_map(|t| mesh.corners(t)).collect(),
    };
    corners.iter().flat_map(metres).for_each(|x| bin.extend(x.to_le_bytes()));
    let positions = bin.len();
    let (mut indices, mut count) = (String::new(), 0);
    if let Kind::Indexed(width) = kind {
        for i in mesh.triangles.iter().flatten() {
            bin.extend(&i.to_le_bytes()[..width as usize]);
        }
        count = 3 * mesh.triangles.len();
        indices = r#","indices":1"#.into();
    }
    // One strip or fan of three vertices each.
    let primitives: Vec<String> = match kind {
        Kind::Strips | Kind::Fans => (0..mesh.triangles.len())
            .map(|t| {
                let mode = if kind == Kind::Strips { 5 } else { 6 };
                format!(r#"{{"attributes":{{"POSITION":{}}},"mode":{mode}}}"#, t + 1)
            })
            .collect(),
        _ => vec![format!(r#"{{"attributes":{{"POSITION":0}}{indices}}}"#)],
    };
    let bounds = r#""type":"VEC3","min":[-1,-1,-1],"max":[1,1,1]"#;
    let mut accessors = vec![format!(r#"{{"bufferView":0,"componentType":5126,"count":{},{bounds}}}"#, corners.len())];
    match kind {
        Kind::Indexed(width) => {
            let component = if width == 2 { 5123 } else { 5125 };
            accessors
                .push(format!(r#"{{"bufferView":1,"componentType":{component},"count":{count},"type":"SCALAR"}}"#));
        }
        Kind::Strips | Kind::Fans => accessors.extend((0..mesh.triangles.len()).map(|t| {
            let offset = 36 * t;
            format!(r#"{{"bufferView":0,"byteOffset":{offset},"componentType":5126,"count":3,{bounds}}}"#)
        })),
        Kind::Unindexed => {}
    }
    let mut views = vec![format!(r#"{{"buffer":0,"byteLength":{positions}}}"#)];
    if let Kind::Indexed(_) = kind {
        let rest = bin.len() - positions;
        views.push(format!(r#"{{"buffer":0,"byteOffset":{positions},"byteLength":{rest}}}"#));
    }
    let uri = uri.map(|u| format!(r#","uri":"{u}""#)).unwrap_or_default();
    let json = format!(
        concat!(
            r#"{{"asset":{{"version":"2.0"}},"scene":0,"scenes":[{{"nodes":[0]}}],"#,
            r#""nodes":[{{"children":[1],"scale":[2,2,2],"translation":[0.01,0.02,0.03]}},"#,
            r#"{{"mesh":0,"rotation":[0,0,0.7071067811865476,0.7071067811865476],"translation":[-0.005,-0.01,-0.015]}}],"#,
            r#""meshes":[{{"primitives":[{}]}}],"accessors":[{}],"bufferViews":[{}],"buffers":[{{"byteLength":{}{}}}]}}"#
        ),
        primitives.join(","),
        accessors.join(","),
        views.join(","),
        bin.len(),
        uri
    );
    (json, bin)
}

fn glb(mesh: &Mesh, kind: Kind) -> Vec<u8> {
    let (json, mut bin) = gltf_parts(mesh, kind, None);
    let mut json = json.into_bytes();
    json.resize(json.len().next_multiple_of(4), b' ');
    bin.resize(bin.len().next_multiple_of(4), 0);
    let mut out = b"glTF".to_vec();
    out.extend(2u32.to_le_bytes());
    out.extend((28 + json.len() as u32 + bin.len() as u32).to_le_bytes());
    for (bytes, kind) in [(json, b"JSON"), (bin, b"BIN\0")] {
        out.extend((bytes.len() as u32).to_le_bytes());
        out.extend(kind);
        out.extend(bytes);
    }
    out
}

fn base64(bytes: &[u8]) -> String {
    const DIGITS: &[u8; 64] = b"ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    let mut out = String::new();
    for c in bytes.chunks(3) {
        let n = c.iter().fold(0u32, |n, b| n << 8 | u32::from(*b)) << (8 * (3 - c.len()));
        (0..=c.len()).for_each(|k| out.push(DIGITS[(n >> (18 - 6 * k) & 63) as usize] as char));
        (c.len()..3).for_each(|_| out.push('='));
    }
    out
}

fn plain(name: &str, bytes: &[u8]) -> Result<Blade> {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join(name);
    std::fs::write(&path, bytes).unwrap();
    load(&path, &ModelOptions::default(), &Silent)
}

fn same_blade(name: &str, found: Result<Blade>, tolerance: f64) -> Blade {
    let mesh = blade();
    let b = found.unwrap_or_else(|e| panic!("{name}: {e}"));
    assert_eq!(b.part.mesh.triangles.len(), mesh.triangles.len(), "{name}");
    assert!((b.part.mesh.volume_mm3() / mesh.volume_mm3() - 1.0).abs() < tolerance, "{name}");
    b
}

#[test]
fn ply_in_three_layouts() {
    for layout in ["ascii", "binary_little_endian", "binary_big_endian"] {
        let b = same_blade(layout, plain("a.ply", &ply(&blade(), layout)), 1e-12);
        assert!(b.diagnosis.format.starts_with("PLY") && b.unit == Unit::Mm, "{:?}", b.diagnosis);
    }
    // By its content, whatever it is called.
    same_blade("part", plain("part", &ply(&blade(), "binary_big_endian")), 1e-12);
    for layout in ["ascii", "binary_little_endian"] {
        same_blade("marked", plain("a.ply", &marked(&ply(&blade(), layout))), 1e-12);
    }
}

#[test]
fn ply_polygons_and_strips() {
    let head = |element: &str| {
        format!(
            "ply\r\nformat ascii 1.0\r\nelement vertex 8\r\nproperty float x\r\nproperty float y\r\nproperty float z\r\n\
             {element}\r\nend_header\r\n0 0 0\n9 0 0\n9 9 0\n0 9 0\n0 0 9\n9 0 9\n9 9 9\n0 9 9\n"
        )
    };
    let cube = head("element face 6\nproperty list uchar uint vertex_index")
        + "4 0 3 2 1\n4 4 5 6 7\n4 0 1 5 4\n4 1 2 6 5\n4 2 3 7 6\n4 3 0 4 7\n";
    let soup = ply::read(Path::new("cube.ply"), cube.as_bytes()).unwrap();
    assert_eq!(soup.triangles.len(), 12);
    assert!(
        (soup.heal(Path::new("cube.ply"), 1.0, &super::heal::HealOptions::default()).unwrap().mesh.volume_mm3()
            - 729.0)
            .abs()
            < 1e-9
    );
    // The sides as one strip, the lids as two.
    let strips = head("element tristrips 1\nproperty list int int vertex_indices")
        + "20 4 0 5 1 6 2 7 3 4 0 -1 1 0 2 3 -1 4 5 7 6\n";
    let soup = ply::read(Path::new("strips.ply"), strips.as_bytes()).unwrap();
    assert_eq!(soup.triangles.len(), 12);
    let healed = soup.heal(Path::new("strips.ply"), 1.0, &super::heal::HealOptions::default()).unwrap();
    assert!((healed.mesh.volume_mm3() - 729.0).abs() < 1e-9 && healed.notes.is_empty(), "{:?}", healed.notes);
}

#[test]
fn gltf_in_every_layout() {
    for (name, kind) in [
        ("u16", Kind::Indexed(2)),
        ("u32", Kind::Indexed(4)),
        ("list", Kind::Unindexed),
        ("strips", Kind::Strips),
        ("fans", Kind::Fans),
    ] {
        let b = same_blade(name, plain("a.glb", &glb(&blade(), kind)), 1e-5);
        assert!(b.unit == Unit::M && b.diagnosis.unit_reason.contains("as the format says"), "{:?}", b.diagnosis);
        // Turned by 90° about z, which the frame of the model shows on any point off the axis.
        let model = b.part.mesh.clone().moved(&b.model_from_blade);
        let expected = blade().points[5];
        let turned = Point::new(-expected.y, expected.x, expected.z);
        let nearest = model.points.iter().map(|p| (p - turned).norm()).fold(f64::INFINITY, f64::min);
        assert!(nearest < 1e-4, "{name}: {nearest}");
    }
}

#[test]
fn gltf_with_its_buffer_elsewhere() {
    let (json, bin) = gltf_parts(
        &blade(),
        Kind::Indexed(4),
        Some(&format!("data:application/octet-stream;base64,{}", {
            let (_, bin) = gltf_parts(&blade(), Kind::Indexed(4), None);
            base64(&bin)
        })),
    );
    same_blade("data", plain("a.gltf", json.as_bytes()), 1e-5);
    same_blade("marked", plain("a.gltf", &marked(json.as_bytes())), 1e-5);
    let folder = tempfile::tempdir().unwrap();
    std::fs::write(folder.path().join("the mesh.bin"), &bin).unwrap();
    let path = folder.path().join("a.gltf");
    let (json, _) = gltf_parts(&blade(), Kind::Indexed(4), Some("the%20mesh.bin"));
    std::fs::write(&path, json).unwrap();
    same_blade("beside", load(&path, &ModelOptions::default(), &Silent), 1e-5);
    for (uri, word) in [("../secret.bin", "not in the model's folder"), ("none.bin", "cannot be read")] {
        let (json, _) = gltf_parts(&blade(), Kind::Indexed(4), Some(uri));
        std::fs::write(&path, json).unwrap();
        let e = load(&path, &ModelOptions::default(), &Silent).err().unwrap();
        assert!(e.kind == ErrorKind::InputOutput && e.to_string().contains(word), "{e}");
    }
}

/// A mirroring node turns the winding; the reader turns it back.
#[test]
fn a_mirrored_node_stays_wound_outward() {
    let (json, bin) = gltf_parts(&blade(), Kind::Indexed(4), Some("m.bin"));
    let folder = tempfile::tempdir().unwrap();
    std::fs::write(folder.path().join("m.bin"), &bin).unwrap();
    let path = folder.path().join("a.gltf");
    let json = json.replace(r#""scale":[2,2,2]"#, r#""scale":[-2,2,2]"#);
    let soup = gltf::read(&path, json.as_bytes()).unwrap();
    let healed = soup.heal(&path, 1000.0, &super::heal::HealOptions::default()).unwrap();
    assert!(healed.notes.is_empty(), "{:?}", healed.notes);
    assert!((healed.mesh.volume_mm3() / blade().volume_mm3() - 1.0).abs() < 1e-5);
}

fn refused(name: &str, bytes: &[u8], words: &[&str]) {
    let error = plain(name, bytes).err().unwrap_or_else(|| panic!("{name} was read"));
    assert_eq!(error.kind, ErrorKind::InputOutput, "{error}");
    for word in words {
        assert!(error.to_string().contains(word), "\"{word}\" is not in \"{error}\"");
    }
}

#[test]
fn damaged_files_are_refused_with_a_sentence() {
    let mesh = blade();
    let ascii = String::from_utf8(ply(&mesh, "ascii")).unwrap();
    let binary = ply(&mesh, "binary_little_endian");
    refused("head.ply", &ascii.as_bytes()[..60], &["end_header"]);
    refused("cut.ply", &binary[..binary.len() - 9], &["damaged: face", "is not there"]);
    refused("word.ply", ascii.replacen("property double x", "property double", 1).as_bytes(), &["line 6"]);
    refused("no_x.ply", ascii.replacen("double x", "double q", 1).as_bytes(), &["lacks x, y or z"]);
    refused("cloud.ply", ascii.replacen("vertex_indices", "neighbours", 1).as_bytes(), &["no face"]);
    refused("number.ply", ascii.replacen("\n1 ", "\none ", 1).as_bytes(), &["vertex 1 of", "not a number"]);
    refused("index.ply", ascii.replacen("\n3 0 ", "\n3 99999 ", 1).as_bytes(), &["names vertex 99999"]);
    refused("many.ply", ascii.replacen("element face ", "element face 99999", 1).as_bytes(), &["is not there"]);
    refused("other.ply", b"solid a\n", &["does not begin as"]);

    let good = glb(&mesh, Kind::Indexed(4));
    refused("cut.glb", &good[..good.len() / 2], &["glTF"]);
    refused("other.glb", b"solid a\n", &["does not begin as"]);
    let (json, bin) = gltf_parts(&mesh, Kind::Indexed(4), Some("DATA"));
    let with = |json: &str| json.replace("DATA", &format!("data:;base64,{}", base64(&bin))).into_bytes();
    refused("short.gltf", &with(&json.replacen(r#""count":"#, r#""count":9"#, 1)), &["beyond its buffer"]);
    refused(
        "missing.gltf",
        &with(&json.replace(r#""POSITION":0"#, r#""POSITION":7"#)),
        &["accessor that is not there"],
    );
    refused("twice.gltf", &with(&json.replace(r#""nodes":[0]"#, r#""nodes":[0,1]"#)), &["placed twice"]);
    refused("itself.gltf", &with(&json.replace(r#""children":[1]"#, r#""children":[0]"#)), &["placed twice"]);
    refused(
        "packed.gltf",
        &with(&json.replace(r#""scene":0"#, r#""extensionsRequired":["KHR_draco_mesh_compression"],"scene":0"#)),
        &["cannot be read as glTF", "without compression"],
    );
    refused("lines.gltf", &with(&json.replace(r#""indices":1"#, r#""indices":1,"mode":1"#)), &["no triangle"]);
    // Zeros that no buffer holds: the promise alone must not take memory.
    let sparse = r#""sparse":{"count":1,"indices":{"bufferView":1,"componentType":5125},"values":{"bufferView":0}}"#;
    let promise = format!(r#""componentType":5126,{sparse},"count":99999999"#);
    let zeros = json.replacen(r#""bufferView":0,"componentType":5126,"count":"#, &promise, 1);
    refused("zeros.gltf", &with(&zeros), &["elements"]);
}

/// A copy with a few places overwritten, taken out, doubled or cut off.
fn mutated(good: &[u8], random: &mut Random) -> Vec<u8> {
    let mut bytes = good.to_vec();
    for _ in 0..=random.below(4) {
        // Headers are short beside the numbers: every second change is made near the start.
        let reach = if random.below(2) == 0 { bytes.len().min(600) } else { bytes.len() };
        let at = random.below(reach);
        match random.below(6) {
            0 => bytes.truncate(at),
            1 => drop(bytes.drain(at..(at + 1 + random.below(8)).min(bytes.len()))),
            2 => {
                let piece = bytes[at..(at + 16).min(bytes.len())].to_vec();
                bytes.splice(at..at, piece);
            }
            3 if at < bytes.len() => bytes[at] = b'9',
            4 if at < bytes.len() => bytes[at] = random.below(256) as u8,
            _ if at < bytes.len() => bytes[at] ^= 1 << random.below(8),
            _ => {}
        }
    }
    bytes
}

#[test]
fn mutations_give_a_mesh_or_an_error() {
    mutate(1500);
}

/// The same for longer.
#[test]
#[ignore = "a minute"]
fn many_mutations_give_a_mesh_or_an_error() {
    mutate(200_000);
}

fn mutate(rounds: usize) {
    // A small blade, so that many mutations fit in a short test.
    let mut mesh = blade();
    mesh.triangles.truncate(60);
    mesh.points.truncate(100);
    mesh.triangles.retain(|t| t.iter().all(|&i| i < 100));
    let mut random = Random(0x9e37_79b9_7f4a_7c15);
    let plys = ["ascii", "binary_little_endian", "binary_big_endian"].map(|l| ply(&mesh, l));
    let glbs = [Kind::Indexed(2), Kind::Unindexed, Kind::Strips].map(|k| glb(&mesh, k));
    let (mut read, mut told) = (0, 0);
    for round in 0..rounds {
        for (good, is_ply) in [(&plys[round % 3], true), (&glbs[round % 3], false)] {
            let bytes = mutated(good, &mut random);
            let path = Path::new("mutated");
            let soup = if is_ply { ply::read(path, &bytes) } else { gltf::read(path, &bytes) };
            match soup {
                Ok(soup) => {
                    // No more than the bytes can hold.
                    assert!(soup.triangles.len() <= bytes.len(), "{} of {}", soup.triangles.len(), bytes.len());
                    let _ = soup.heal(path, 1.0, &super::heal::HealOptions::default());
                    read += 1;
                }
                Err(e) => {
                    assert_eq!(e.kind, ErrorKind::InputOutput);
                    told += 1;
                }
            }
        }
    }
    assert!(
        15 * read > rounds && 15 * told > rounds,
        "{read} read, {told} refused: the mutations are too weak or too strong"
    );
}
