//! The one way of dependence: an import against it fails here and is named.
//!
//! numerics ← geometry ← artifact ← {tool, machine} ← stages ← output, pipeline ← cli. Stages never import one
//! another; `verify` sees no planner; posts and previews see `verify` because only checked plans are written.

use std::path::{Path, PathBuf};

/// What a folder of `src` may import besides itself, `error` and `observe`; `None`: anything.
fn allowed(room: &str) -> Option<&'static [&'static str]> {
    const STAGE: &[&str] = &["numerics", "geometry", "artifact", "tool", "machine"];
    const WRITER: &[&str] = &["numerics", "geometry", "artifact", "tool", "machine", "verify"];
    Some(match room {
        "numerics" | "error" | "observe" => &[],
        "geometry" => &["numerics"],
        "artifact" => &["numerics", "geometry"],
        "tool" => &["numerics", "geometry", "artifact"],
        "machine" => &["numerics", "geometry", "artifact", "tool"],
        "model" | "make" | "section" | "path" | "channel" | "schedule" | "lead" | "feed" | "verify" | "job" => STAGE,
        "post" | "preview" | "output" => WRITER,
        "batch" => {
            &["numerics", "geometry", "artifact", "tool", "machine", "model", "make", "job", "output", "pipeline"]
        }
        // `sample` is a made-up plan for unit tests only.
        "pipeline" | "cli" | "lib" | "main" | "sample" => return None,
        _ => panic!("src/{room} has no place in the layering: give it one in tests/layering.rs"),
    })
}

fn sources(dir: &Path, out: &mut Vec<PathBuf>) {
    for entry in std::fs::read_dir(dir).expect("src is readable") {
        let path = entry.expect("entry is readable").path();
        if path.is_dir() {
            sources(&path, out);
        } else if path.extension().is_some_and(|e| e == "rs") {
            out.push(path);
        }
    }
}

/// First path segment after each `crate::` in code, comments left out.
fn imports(text: &str) -> Vec<(usize, String)> {
    let mut found = Vec::new();
    for (n, line) in text.lines().enumerate() {
        let code = line.split("//").next().unwrap_or("");
        for part in code.split("crate::").skip(1) {
            let name: String = part.chars().take_while(|c| c.is_alphanumeric() || *c == '_').collect();
            found.push((n + 1, name));
        }
    }
    found
}

#[test]
fn imports_go_one_way() {
    let src = Path::new(env!("CARGO_MANIFEST_DIR")).join("src");
    let mut files = Vec::new();
    sources(&src, &mut files);
    assert!(files.len() > 20, "the sources were not found");
    let mut wrong = Vec::new();
    for file in files {
        let relative = file.strip_prefix(&src).expect("inside src");
        let first = relative.components().next().expect("has a name").as_os_str().to_string_lossy().into_owned();
        let room = first.trim_end_matches(".rs").to_owned();
        let Some(allowed) = allowed(&room) else { continue };
        let text = std::fs::read_to_string(&file).expect("source is readable");
        for (line, name) in imports(&text) {
            // `sample` exists in unit tests only: the compiler keeps it out of the product.
            let everywhere = ["error", "observe", "Error", "ErrorKind", "Stage", "sample"];
            let free = name.is_empty() || name == room || everywhere.contains(&name.as_str());
            if !free && !allowed.contains(&name.as_str()) {
                wrong.push(format!("src/{}:{line}: `{room}` must not import `{name}`", relative.display()));
            }
        }
    }
    assert!(wrong.is_empty(), "imports against the layering:\n{}", wrong.join("\n"));
}

#[test]
fn the_scanner_sees_an_import() {
    assert_eq!(imports("use crate::path::x; // crate::not"), vec![(1, "path".to_owned())]);
}
