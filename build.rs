//! Names the build: a hash of everything in this package that a result follows from. It differs
//! between two builds of one version that would compute different things. Any machine that builds
//! the same sources gets the same name.
//!
//! In it: `src`, the viewer's bundle, the built-in machine, posts and tools, and `Cargo.lock`, which
//! pins the dependencies.

use std::path::{Path, PathBuf};

/// What the build is made of, relative to the package.
const PARTS: [&str; 6] = ["src", "viewer/dist", "models/machines", "models/posts", "models/tools", "Cargo.lock"];

fn main() -> std::io::Result<()> {
    let mut files = Vec::new();
    for part in PARTS {
        println!("cargo:rerun-if-changed={part}");
        collect(Path::new(part), &mut files)?;
    }
    println!("cargo:rerun-if-changed=build.rs");
    files.sort();
    let mut hash = Fnv::default();
    for file in &files {
        // The same on systems that part folders or end lines otherwise.
        let name: Vec<_> = file.iter().map(|part| part.to_string_lossy()).collect();
        let text: Vec<u8> = std::fs::read(file)?.into_iter().filter(|b| *b != b'\r').collect();
        for piece in [name.join("/").as_bytes(), &text] {
            hash.add(&(piece.len() as u64).to_le_bytes());
            hash.add(piece);
        }
    }
    println!("cargo:rustc-env=BLADEWRIGHT_BUILD={:032x}", hash.0);
    Ok(())
}

/// All files below a path; none where there is nothing, as where a package comes without its lock
/// file.
fn collect(path: &Path, files: &mut Vec<PathBuf>) -> std::io::Result<()> {
    if path.is_file() {
        files.push(path.to_path_buf());
    } else if path.is_dir() {
        for entry in std::fs::read_dir(path)? {
            collect(&entry?.path(), files)?;
        }
    }
    Ok(())
}

/// FNV-1a with 128 bits: changes of sources are told apart by it, no forger is kept out.
struct Fnv(u128);

impl Default for Fnv {
    fn default() -> Self {
        Fnv(0x6c62_272e_07bb_0142_62b8_2175_6295_c58d)
    }
}

impl Fnv {
    fn add(&mut self, bytes: &[u8]) {
        for b in bytes {
            self.0 = (self.0 ^ u128::from(*b)).wrapping_mul(0x0000_0000_0100_0000_0000_0000_0000_013b);
        }
    }
}
