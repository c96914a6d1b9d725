//! The one way of dependence: an import against it fails here and is named.
//!
//! numerics ← geometry ← artifact ← {tool, machine} ← read, stages ← write, run ← plan ← batch ← cli. Stages never import one
//! another; `verify` sees no planner, but the readers of programs; writers see `verify` because only checked plans are written.

use std::path::{Path, PathBuf};

/// What a folder of `src` may import besides itself, `error` and `observe`; `None`: anything.
fn allowed(room: &str) -> Option<&'static [&'static str]> {
    const STAGE: &[&str] = &["numerics", "geometry", "artifact", "tool", "machine"];
    const READER: &[&str] = &["numerics", "geometry", "artifact", "tool", "machine", "files"];
    const DATA: &[&str] = &["numerics", "geometry", "artifact", "tool", "machine", "verify", "files"];
    Some(match room {
        "numerics" | "error" | "observe" | "files" => &[],
        "geometry" => &["numerics"],
        "artifact" => &["numerics", "geometry"],
        "tool" => &["numerics", "geometry", "artifact", "files"],
        "machine" => &["numerics", "geometry", "artifact", "tool", "files"],
        "section" | "path" | "channel" | "schedule" | "lead" | "feed" => STAGE,
        "verify" => &["numerics", "geometry", "artifact", "tool", "machine", "read"],
        "read" | "make" | "job" => READER,
        "write" | "run" => DATA,
        "batch" => &[
            "numerics", "geometry", "artifact", "tool", "machine", "read", "make", "job", "run", "plan", "write",
            "files",
        ],
        // `sample` is a made-up plan for unit tests only.
        "plan" | "cli" | "lib" | "main" | "sample" => return None,
        _ => panic!("src/{room} has no place in the layering: give it one in tests/layering.rs"),
    })
}

/// The rooms that may name a crate, or a part of the standard library; `None`: every room.
fn users(outside: &str) -> Option<&'static [&'static str]> {
    Some(match outside {
        "clap" | "clap_complete" | "clap_mangen" | "indicatif" | "signal_hook" => &["cli"],
        "fs" | "tempfile" => &["files", "make", "read", "run", "batch", "cli"],
        "parquet" | "csv" | "glob" | "object_store" | "tokio" => &["batch", "make"],
        "step_io" => &["read", "make"],
        "tobj" => &["read"],
        "truck_modeling" => &["make"],
        "spade" => &["geometry", "make"],
        "gltf" => &["read", "write"],
        "gltf_json" | "resvg" | "png" | "dejavu" => &["write"],
        _ => return None,
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

/// First path segment after each `crate::` in code, comments left out; all of them where it is a list in braces, over any number of lines.
fn imports(text: &str) -> Vec<(usize, String)> {
    let code: Vec<&str> = text.lines().map(|line| line.split("//").next().unwrap_or("")).collect();
    let code = code.join("\n");
    let mut found = Vec::new();
    for (at, _) in code.match_indices("crate::") {
        let line = code[..at].matches('\n').count() + 1;
        let rest = &code[at + "crate::".len()..];
        match rest.trim_start().strip_prefix('{') {
            Some(list) => found.extend(heads(list).into_iter().map(|name| (line, name))),
            None => found.push((line, head(rest))),
        }
    }
    found
}

fn head(path: &str) -> String {
    path.trim_start().chars().take_while(|c| c.is_alphanumeric() || *c == '_').collect()
}

/// First segments of the paths of a list, up to the brace that ends it.
fn heads(list: &str) -> Vec<String> {
    let (mut depth, mut start, mut found) = (0, 0, Vec::new());
    for (k, c) in list.char_indices() {
        match c {
            '{' => depth += 1,
            ',' | '}' if depth == 0 => {
                found.push(head(&list[start..k]));
                start = k + 1;
                if c == '}' {
                    break;
                }
            }
            '}' => depth -= 1,
            _ => {}
        }
    }
    found
}

/// Line and name of every path in code that begins with a crate, or with a module of the standard library, that the room may not use. What a file
/// has for its own unit tests does not count.
fn strangers(room: &str, text: &str) -> Vec<(usize, String)> {
    let product = text.split("#[cfg(test)]\nmod ").next().unwrap_or(text);
    let code: Vec<&str> = product.lines().map(|line| line.split("//").next().unwrap_or("")).collect();
    let code = code.join("\n");
    let mut found = Vec::new();
    for (at, _) in code.match_indices("::") {
        let before = &code[..at];
        let start = before.rfind(|c: char| !c.is_alphanumeric() && c != '_').map_or(0, |k| k + 1);
        let name = &before[start..];
        // `crate::read::model::gltf::` and `super::gltf::` are ours.
        let outer = before[..start].strip_suffix("::").map(|o| {
            let from = o.rfind(|c: char| !c.is_alphanumeric() && c != '_').map_or(0, |k| k + 1);
            &o[from..]
        });
        let is_outside = outer.is_none_or(|o| o.is_empty() || o == "std");
        if is_outside && users(name).is_some_and(|rooms| !rooms.contains(&room)) {
            found.push((before.matches('\n').count() + 1, name.to_owned()));
        }
    }
    found
}

/// Line and name of every import of a room's file that is against the layering.
fn against(room: &str, text: &str) -> Vec<(usize, String)> {
    // `sample` exists in unit tests only: the compiler keeps it out of the product.
    const EVERYWHERE: [&str; 6] = ["error", "observe", "Error", "ErrorKind", "Stage", "sample"];
    let Some(allowed) = allowed(room) else { return Vec::new() };
    let is_free = |name: &str| name.is_empty() || name == room || EVERYWHERE.contains(&name) || allowed.contains(&name);
    imports(text).into_iter().filter(|(_, name)| !is_free(name)).collect()
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
        let text = std::fs::read_to_string(&file).expect("source is readable");
        let is_test = relative.components().any(|c| {
            let name = c.as_os_str().to_string_lossy();
            name == "tests" || name.ends_with("tests.rs")
        });
        let strangers = if is_test { Vec::new() } else { strangers(&room, &text) };
        // Tests of the posts read every program back.
        let against =
            against(&room, &text).into_iter().filter(|(_, name)| !(is_test && room == "write" && name == "read"));
        for (line, name) in against.chain(strangers) {
            wrong.push(format!("src/{}:{line}: `{room}` must not import `{name}`", relative.display()));
        }
    }
    assert!(wrong.is_empty(), "imports against the layering:\n{}", wrong.join("\n"));
}

#[test]
fn the_scanner_sees_an_import() {
    let seen = |text: &str| imports(text).into_iter().map(|(n, name)| format!("{n} {name}")).collect::<Vec<_>>();
    assert_eq!(seen("use crate::path::x; // crate::not"), ["1 path"]);
    assert_eq!(seen("use crate::{path::x, feed, schedule::{a::{b, c}, d}};"), ["1 path", "1 feed", "1 schedule"]);
    let lines = "fn f() {}\npub(crate) use crate::{\n    geometry::Point, // the point\n    channel::Options as O,\n};\nuse std::fs;";
    assert_eq!(seen(lines).join(" "), "2 geometry 2 channel 2 ");
}

/// An import of a planner in the checks, in each form that the language has for it, is against the layering.
#[test]
fn an_import_that_is_planted_is_found() {
    for text in ["use crate::path::ring;", "use crate::{artifact::Plan, path::ring};", "use crate::{\n    path,\n};"] {
        assert!(against("verify", text).iter().any(|(_, name)| name == "path"), "{text}");
    }
    assert!(against("verify", "use crate::{artifact::Plan, error::{Error, Result}};").is_empty());
}

/// A crate in a room that has no business with it is found, in each form that the language has for naming it.
#[test]
fn a_crate_that_is_planted_is_found() {
    let found = |room: &str, text: &str| strangers(room, text).into_iter().map(|f| f.1).collect::<Vec<_>>().join(" ");
    for text in ["use clap::Parser;", "#[derive(clap::ValueEnum)]\nenum A {}", "fn f() { ::clap::value_parser!(u32); }"]
    {
        assert_eq!(found("artifact", text), "clap", "{text}");
        assert_eq!(found("cli", text), "", "{text}");
    }
    assert_eq!(found("verify", "let text = std::fs::read_to_string(path)?;"), "fs");
    assert_eq!(found("verify", "use std::fs;\nfn f() { fs::read(path); }"), "fs");
    assert_eq!(found("channel", "use crate::read::model::gltf::x; // clap::Parser\nsuper::gltf::y();"), "");
    assert_eq!(found("geometry", "fn f() {}\n#[cfg(test)]\nmod tests {\n    use std::fs::read;\n}"), "");
}
