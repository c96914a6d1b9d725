//! The one way of dependence: a path in code that is against it fails here and is named.
//!
//! numerics ← geometry ← artifact ← {tool, machine} ← read, stages ← write ← plan ← run ← batch ←
//! cli. Stages never import one another; `verify` sees no planner, but the readers of programs;
//! writers see `verify` because only checked plans are written.

use std::collections::HashMap;
use std::path::{Path, PathBuf};

/// What a folder of `src` may import besides itself, `error`, `observe`, `parallel` and `settings`;
/// `None`: anything.
fn allowed(room: &str) -> Option<&'static [&'static str]> {
    const STAGE: &[&str] = &["numerics", "geometry", "artifact", "tool", "machine"];
    const READER: &[&str] = &["numerics", "geometry", "artifact", "tool", "machine", "files"];
    const WRITER: &[&str] = &["numerics", "geometry", "artifact", "tool", "machine", "verify"];
    // All stages, and what they need, but no files.
    const PLANNER: &[&str] = &[
        "numerics", "geometry", "artifact", "tool", "machine", "read", "section", "path", "pair", "orient", "channel",
        "schedule", "smooth", "lead", "feed", "verify", "write", "job",
    ];
    // What a planner needs, and the planner's choice among schedules.
    const RESCHEDULER: &[&str] = &[
        "numerics", "geometry", "artifact", "tool", "machine", "read", "channel", "schedule", "feed", "verify", "plan",
    ];
    const RUNNER: &[&str] = &[
        "numerics", "geometry", "artifact", "tool", "machine", "read", "section", "path", "orient", "channel",
        "schedule", "smooth", "lead", "feed", "verify", "write", "job", "plan", "files",
    ];
    Some(match room {
        "numerics" | "error" | "observe" | "parallel" | "settings" | "files" => &[],
        "geometry" => &["numerics"],
        "artifact" => &["numerics", "geometry"],
        "tool" => &["numerics", "geometry", "artifact"],
        "machine" => &["numerics", "geometry", "artifact", "tool"],
        "section" | "path" | "pair" | "orient" | "channel" | "schedule" | "smooth" | "lead" | "feed" => STAGE,
        "verify" | "register" => &["numerics", "geometry", "artifact", "tool", "machine", "read"],
        "read" => READER,
        "make" => STAGE,
        "write" => WRITER,
        // The job stands above the stages: its defaults are those of their options.
        "job" | "plan" => PLANNER,
        "reschedule" => RESCHEDULER,
        "run" => RUNNER,
        "batch" => {
            &["numerics", "geometry", "artifact", "tool", "machine", "read", "make", "job", "run", "write", "files"]
        }
        // `sample` is a made-up plan for unit tests only.
        "cli" | "lib" | "main" | "sample" => return None,
        _ => panic!("src/{room} has no place in the layering: give it one in tests/layering.rs"),
    })
}

/// Rooms that know files.
const KNOW_FILES: &[&str] = &["files", "read", "run", "batch", "cli"];
/// Methods that ask the file system, on whatever they are called, and functions of `std::path` that
/// do.
const ASK_FILES: [&str; 11] = [
    "absolute",
    "canonicalize",
    "exists",
    "is_dir",
    "is_file",
    "is_symlink",
    "metadata",
    "read_dir",
    "read_link",
    "symlink_metadata",
    "try_exists",
];

/// The rooms that may name a crate, a part of the standard library or a method; `None`: every room.
fn users(outside: &str) -> Option<&'static [&'static str]> {
    Some(match outside {
        asks if ASK_FILES.contains(&asks) => KNOW_FILES,
        // Where and how the program was called.
        "env" | "process" | "net" => &["run", "batch", "cli", "main"],
        "clap" | "clap_complete" | "clap_mangen" | "indicatif" | "signal_hook" => &["cli"],
        "fs" | "tempfile" => KNOW_FILES,
        // Loops go through `parallel`; the others make pools of threads.
        "rayon" => &["parallel", "geometry", "batch", "cli"],
        "parquet" | "csv" | "glob" => &["batch", "make"],
        "object_store" | "tokio" | "reqwest" | "rustls" => &["batch"],
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

/// A word or a sign of code, with its line.
type Token = (usize, String);

/// The words and signs of code. Comments are left out, and so are texts in quotes unless they are
/// paths: attributes name functions in quotes.
fn tokens(text: &str) -> Vec<Token> {
    let c: Vec<char> = text.chars().collect();
    let at = |k: usize| c.get(k).copied().unwrap_or(' ');
    let is_word = |k: usize| at(k).is_alphanumeric() || at(k) == '_';
    let (mut out, mut k, mut line): (Vec<Token>, usize, usize) = (Vec::new(), 0, 1);
    while k < c.len() {
        let start = k;
        let hashes = |from: usize| (from..).take_while(|h| at(*h) == '#').count();
        let raw = usize::from(at(k) == 'b') + usize::from(at(k + usize::from(at(k) == 'b')) == 'r');
        if at(k) == '/' && at(k + 1) == '/' {
            k += (k..c.len()).take_while(|e| at(*e) != '\n').count();
        } else if at(k) == '/' && at(k + 1) == '*' {
            let mut depth = 0;
            loop {
                match (at(k), at(k + 1)) {
                    ('/', '*') => (depth, k) = (depth + 1, k + 2),
                    ('*', '/') => (depth, k) = (depth - 1, k + 2),
                    _ => k += 1,
                }
                if depth == 0 || k >= c.len() {
                    break;
                }
            }
        } else if at(k) == '"' || (raw > 0 && at(k + raw + hashes(k + raw)) == '"') {
            let is_raw = raw > 0 && at(k + raw - 1) == 'r';
            let fence = if is_raw { hashes(k + raw) } else { 0 };
            let first = k + raw + fence + 1;
            let mut end = first;
            while end < c.len() && !(at(end) == '"' && hashes(end + 1) >= fence) {
                end += if at(end) == '\\' && !is_raw { 2 } else { 1 };
            }
            let quoted: String = c[first.min(c.len())..end.min(c.len())].iter().collect();
            if quoted.contains("::") && quoted.chars().all(|q| q.is_alphanumeric() || q == '_' || q == ':') {
                out.extend(tokens(&quoted).into_iter().map(|(_, word)| (line, word)));
            }
            k = end + 1 + fence;
        } else if at(k) == '\'' {
            // A character, or a lifetime.
            k += match (at(k + 1), at(k + 2)) {
                ('\\', _) => 3 + (k + 3..c.len()).take_while(|e| at(*e) != '\'').count() + 1,
                (_, '\'') => 3,
                _ => 1,
            };
        } else if is_word(k) {
            k += (k..).take_while(|e| is_word(*e)).count();
            let word: String = c[start..k].iter().collect();
            if word == "r" && at(k) == '#' {
                k += 1;
            } else {
                out.push((line, word));
            }
        } else if at(k) == ':' && at(k + 1) == ':' {
            out.push((line, "::".into()));
            k += 2;
        } else {
            if !at(k).is_whitespace() {
                out.push((line, at(k).to_string()));
            }
            k += 1;
        }
        line += c[start..k.min(c.len())].iter().filter(|e| **e == '\n').count();
    }
    out
}

/// A path in code: its names, and the name that an import gives it.
struct Named {
    line: usize,
    /// It begins with `::`, so with a crate.
    of_crates: bool,
    /// It is the name of a method that is called.
    is_method: bool,
    names: Vec<String>,
    alias: Option<String>,
    /// The modules within the file that it stands in.
    inner: Vec<String>,
    in_tests: bool,
}

/// All paths of a file: those of imports, one for each name in braces; those of more than one name;
/// names of attributes; and names of methods that are called.
fn paths(tokens: &[Token]) -> Vec<Named> {
    let word = |k: usize| tokens.get(k).map_or("", |t| &t.1);
    let is_name = |k: usize| word(k).starts_with(|c: char| c.is_alphabetic() || c == '_');
    let (mut out, mut k, mut depth, mut in_use) = (Vec::new(), 0, 0, false);
    // Name, depth of braces, and whether it is one of tests.
    let mut inner: Vec<(String, usize, bool)> = Vec::new();
    while k < tokens.len() {
        let before = |n: usize| k.checked_sub(n).map_or("", word);
        match word(k) {
            "mod" if is_name(k + 1) && word(k + 2) == "{" => {
                let attribute = (1..=7).rev().map(before).collect::<Vec<_>>().join(" ");
                inner.push((word(k + 1).to_owned(), depth, attribute.ends_with("# [ cfg ( test ) ]")));
                (depth, k) = (depth + 1, k + 3);
                continue;
            }
            "use" => in_use = true,
            "crate" if before(1) == "extern" => in_use = true,
            ";" => in_use = false,
            "{" if !in_use => depth += 1,
            "}" if !in_use => {
                depth = depth.saturating_sub(1);
                inner.retain(|m| m.1 < depth);
            }
            _ => {}
        }
        let of_crates = word(k) == "::" && !is_name_or_end(before(1));
        let first = if of_crates { k + 1 } else { k };
        let begins_list = in_use && word(first) == "{" && (of_crates || before(1) == "use");
        let begins = begins_list || (is_name(first) && (of_crates || !["::", "."].contains(&before(1))));
        let is_method = before(1) == "." && is_name(k) && word(k + 1) == "(";
        if is_method {
            let (line, in_tests) = (tokens[k].0, inner.iter().any(|m| m.2));
            let names = vec![word(k).to_owned()];
            out.push(Named { line, of_crates: false, is_method, names, alias: None, inner: Vec::new(), in_tests });
        }
        if !begins || word(k) == "use" || (word(k) == "crate" && before(1) == "extern") {
            k += 1;
            continue;
        }
        let mut found = Vec::new();
        k = tree(tokens, first, &[], in_use, &mut found);
        let is_attribute = before_is(tokens, first, &["#", "["]);
        for (names, alias) in found.into_iter().filter(|f| in_use || is_attribute || f.0.len() > 1) {
            let (line, in_tests) = (tokens[first].0, inner.iter().any(|m| m.2));
            let inner = inner.iter().map(|m| m.0.clone()).collect();
            out.push(Named { line, of_crates, is_method: false, names, alias, inner, in_tests });
        }
    }
    out
}

/// A `::` behind this goes on with a path, and begins none.
fn is_name_or_end(word: &str) -> bool {
    word == ">" || (word != "use" && word.ends_with(|c: char| c.is_alphanumeric() || c == '_'))
}

fn before_is(tokens: &[Token], at: usize, words: &[&str]) -> bool {
    at >= words.len() && tokens[at - words.len()..at].iter().map(|t| t.1.as_str()).eq(words.iter().copied())
}

/// Adds the paths of an import's tree, or the one path that begins here; where reading goes on.
fn tree(
    tokens: &[Token],
    mut k: usize,
    prefix: &[String],
    in_use: bool,
    out: &mut Vec<(Vec<String>, Option<String>)>,
) -> usize {
    let word = |k: usize| tokens.get(k).map_or("", |t| &t.1);
    let is_name = |k: usize| word(k).starts_with(|c: char| c.is_alphabetic() || c == '_');
    let mut names = prefix.to_vec();
    loop {
        if word(k) == "{" {
            k += 1;
            while k < tokens.len() && word(k) != "}" {
                let next = tree(tokens, k, &names, in_use, out);
                // A comma, or what is no path.
                k = if next == k || word(next) == "," { next + 1 } else { next };
            }
            return k + 1;
        }
        if !is_name(k) && word(k) != "*" {
            break;
        }
        names.push(word(k).to_owned());
        k += 1;
        let goes_on = word(k) == "::" && (is_name(k + 1) || (in_use && ["{", "*"].contains(&word(k + 1))));
        if !goes_on {
            break;
        }
        k += 1;
    }
    let alias = (in_use && word(k) == "as").then(|| word(k + 1).to_owned());
    k += if alias.is_some() { 2 } else { 0 };
    if names.len() > prefix.len() {
        out.push((names, alias));
    }
    k
}

/// What a path leads to: a place in `src`, or a crate.
#[derive(Clone, Debug, PartialEq)]
enum Place {
    Ours(Vec<String>),
    Outside(Vec<String>),
}

/// Follows a path from its module, by what the file has imported before.
fn place(path: &Named, module: &[String], known: &HashMap<String, Place>) -> Place {
    let mut names = path.names.clone();
    if names.len() > 1 && names.last().is_some_and(|n| n == "self") {
        names.pop();
    }
    let first = names[0].clone();
    let mut here = [module, &path.inner].concat();
    match first.as_str() {
        "crate" | "bladewright" => Place::Ours(names.split_off(1)),
        "self" | "super" => {
            let steps = names.iter().take_while(|n| *n == "self" || *n == "super").count();
            let up = names.iter().take(steps).filter(|n| *n == "super").count();
            here.truncate(here.len().saturating_sub(up));
            Place::Ours([here, names.split_off(steps)].concat())
        }
        _ if path.of_crates || path.is_method => Place::Outside(names),
        _ => match known.get(&first) {
            Some(Place::Ours(to)) => Place::Ours([to.clone(), names.split_off(1)].concat()),
            Some(Place::Outside(to)) => Place::Outside([to.clone(), names.split_off(1)].concat()),
            None => Place::Outside(names),
        },
    }
}

/// Line and name of everything that a file of a module names and must not. What a file has for its
/// own unit tests may name any crate.
fn against(module: &[&str], is_test: bool, text: &str) -> Vec<(usize, String)> {
    // `sample` exists in unit tests only: the compiler keeps it out of the product.
    const EVERYWHERE: [&str; 8] = ["error", "observe", "parallel", "settings", "Error", "ErrorKind", "Stage", "sample"];
    let room = module[0];
    let inside: Vec<String> = module.iter().filter(|m| !["lib", "main"].contains(m)).map(|m| (*m).to_owned()).collect();
    let (tokens, mut known, mut found) = (tokens(text), HashMap::new(), Vec::new());
    let declares = |name: &str| {
        let mut pairs = tokens.windows(3);
        pairs.any(|w| w[0].1 == "mod" && w[1].1 == name && [";", "{"].contains(&w[2].1.as_str()))
    };
    for path in paths(&tokens) {
        let place = place(&path, &inside, &known);
        let named = path.alias.clone().or_else(|| path.names.iter().rfind(|n| *n != "self").cloned());
        // A path of one name that is no import, and a name that is imported as itself, lead nowhere
        // new.
        known.extend(
            named
                .filter(|n| path.names.len() > 1 || path.alias.is_some() || n != &path.names[0])
                .map(|n| (n, place.clone())),
        );
        match place {
            Place::Ours(to) => {
                let Some((name, allowed)) = to.first().zip(allowed(room)) else { continue };
                let name = name.as_str();
                if name != room && !EVERYWHERE.contains(&name) && !allowed.contains(&name) {
                    found.push((path.line, name.to_owned()));
                }
            }
            Place::Outside(to) => {
                let of_std = ["std", "core", "alloc"].contains(&to[0].as_str());
                let last = to.last().map_or("", String::as_str);
                let asks = of_std && to[1..].iter().any(|n| n == "path") && ASK_FILES.contains(&last);
                let name = match of_std {
                    _ if asks => last,
                    true => to.get(1).map_or("", String::as_str),
                    false => &to[0],
                };
                // A crate's name is not that of a method, nor the other way round.
                let is_bound = path.is_method == ASK_FILES.contains(&name) || asks;
                let declared = !path.of_crates && !path.is_method && declares(name);
                let is_free = !is_bound || declared || users(name).is_none_or(|rooms| rooms.contains(&room));
                if !(is_free || is_test || path.in_tests) {
                    found.push((path.line, name.to_owned()));
                }
            }
        }
    }
    found
}

/// The module of a file of `src`.
fn module_of(relative: &Path) -> Vec<String> {
    let mut names: Vec<String> = relative.with_extension("").iter().map(|n| n.to_string_lossy().into_owned()).collect();
    names.pop_if(|last| last == "mod");
    names
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
        let module = module_of(relative);
        let module: Vec<&str> = module.iter().map(String::as_str).collect();
        let text = std::fs::read_to_string(&file).expect("source is readable");
        let is_test = module.iter().any(|name| name.ends_with("tests"));
        for (line, name) in against(&module, is_test, &text) {
            // Tests of the posts read every program back.
            if !(is_test && module[0] == "write" && name == "read") {
                wrong.push(format!("src/{}:{line}: `{}` must not name `{name}`", relative.display(), module[0]));
            }
        }
    }
    assert!(wrong.is_empty(), "names against the layering:\n{}", wrong.join("\n"));
}

/// What is found in a text that stands in a file of this module.
fn found(module: &str, text: &str) -> String {
    let module: Vec<&str> = module.split("::").collect();
    let mut all: Vec<String> =
        against(&module, false, text).into_iter().map(|(line, name)| format!("{line} {name}")).collect();
    all.dedup();
    all.join(", ")
}

/// A planner in the checks, in each form that the language has for naming it.
#[test]
fn an_import_that_is_planted_is_found() {
    for text in [
        "use crate::path::ring;",
        "pub(crate) use crate::path;",
        "use crate::path::{self, ring};",
        "use crate::path as p;",
        "use crate::{artifact::{Plan, report::{Check, CheckReport}}, path::ring};",
        "use {crate::path, crate::artifact::Plan};",
        "use crate::{self as house, artifact::Plan}; fn f() { house::path::plan(); }",
        "use crate as house; use house::path::ring as r;",
        "use super::path::ring;",
        "use self::super::path;",
        "mod inner { use super::super::path; }",
        "mod inner { mod more { fn f() { super::super::super::path::f() } } }",
        "use ::bladewright::path;",
        "fn f() { let x = crate::path::plan(); }",
        "fn f(x: &<crate::path::Node as Clone>::T) {}",
        "fn f() { Vec::<crate::path::Node>::new(); }",
        "#[derive(crate::path::Derived)] struct A;",
        "#[serde(default = \"crate::path::default\")] struct A;",
        "macro_rules! m { () => { $crate::path::f() }; }",
        "fn f() { assert!(x == crate::path::LEAST); }",
        "/* /* a */ comment */ use /* here */ crate :: path;",
    ] {
        assert_eq!(found("verify", text), "1 path", "{text}");
        assert_eq!(found("path", text), "", "{text}");
    }
    assert_eq!(found("verify::check", "use super::super::path;\nuse super::seal;"), "1 path");
    assert_eq!(found("verify", "use crate::{\n    artifact,\n};\n\nuse crate::*;"), "5 *");
    let innocent = "// use crate::path;\nuse crate::{artifact::Plan, error::{Error, Result}};\nconst A: &str = \"see crate::path\"; const B: char = '\"'; fn f<'a>(path: &'a P) { path.x(); self::f(); }";
    assert_eq!(found("verify", innocent), "");
}

/// Who plans knows no folder of a run, and no stage knows another.
#[test]
fn each_rule_fails_on_its_fault() {
    let faults = [
        ("plan", "use crate::run::RunFolder;", "run"),
        ("plan", "use crate::files;", "files"),
        ("plan", "use crate::batch;", "batch"),
        ("run", "use crate::cli;", "cli"),
        ("batch", "use crate::cli::args;", "cli"),
        ("numerics", "use crate::geometry::Point;", "geometry"),
        ("geometry", "use crate::artifact::Plan;", "artifact"),
        ("artifact", "use crate::tool::Tool;", "tool"),
        ("tool", "use crate::machine::Machine;", "machine"),
        ("tool", "use crate::files;", "files"),
        ("machine", "use crate::files::read;", "files"),
        ("read", "use crate::verify;", "verify"),
        ("write", "use crate::plan::Setup;", "plan"),
        ("write", "use crate::files;", "files"),
        ("job", "use crate::files;", "files"),
        ("make", "use crate::read;", "read"),
        ("error", "use crate::observe::Observer as O; use crate::tool;", "tool"),
    ];
    let stages = ["section", "path", "channel", "schedule", "lead", "feed"];
    for (room, text, name) in faults {
        assert_eq!(found(room, text), format!("1 {name}"), "{room}: {text}");
    }
    for (room, other) in stages.iter().flat_map(|a| stages.iter().filter(move |b| a != *b).map(move |b| (a, b))) {
        assert_eq!(found(room, &format!("use super::{other}::plan;")), format!("1 {other}"));
    }
}

/// A crate in a room that has no business with it, in each form that the language has for naming
/// it.
#[test]
fn a_crate_that_is_planted_is_found() {
    for text in [
        "use clap::Parser;",
        "use clap;",
        "pub use ::clap::Parser as P;",
        "use {clap::Parser, serde::Serialize};",
        "extern crate clap;",
        "extern crate clap as c;",
        "#[derive(clap::ValueEnum)] enum A {}",
        "#[clap(long)] struct A;",
        "fn f() { ::clap::value_parser!(u32); }",
    ] {
        assert_eq!(found("artifact", text), "1 clap", "{text}");
        assert_eq!(found("cli", text), "", "{text}");
    }
    for text in [
        "fn f() { let text = std::fs::read_to_string(path)?; }",
        "use std::{fs, io};",
        "use std::{fmt, fs::{self, File}};",
        "use std as s; fn f() { s::fs::read(p); }",
        "use ::std::fs::File as F;",
    ] {
        assert!(found("verify", text).starts_with("1 fs"), "{text}");
        assert_eq!(found("run", text), "", "{text}");
    }
    for krate in ["reqwest", "rustls", "object_store", "tokio"] {
        assert_eq!(found("make", &format!("use {krate}::Client;")), format!("1 {krate}"));
        assert_eq!(found("batch", &format!("use {krate}::Client;")), "");
    }
    assert_eq!(found("channel", "use crate::read;\n// clap::Parser\nfn f() { super::gltf::y(); }"), "1 read, 3 gltf");
    assert_eq!(found("section", "mod csv;\nfn f() { csv::y(); self::csv::z(); }"), "");
    assert_eq!(found("geometry", "fn f() {}\n#[cfg(test)]\nmod tests {\n    use std::fs::read;\n}"), "");
    assert_eq!(found("geometry", "#[cfg(test)]\nmod tests;\nuse std::fs::read;"), "3 fs");
}

/// A room that asks for files or for its surroundings without naming `std::fs`.
#[test]
fn a_look_at_files_that_is_planted_is_found() {
    for (text, name) in [
        ("fn f(p: &Path) -> bool { p.exists() }", "exists"),
        ("fn f(p: &Path) -> bool { p.try_exists().is_ok() }", "try_exists"),
        ("fn f(p: &Path) -> bool { p.join(name).is_file() }", "is_file"),
        ("fn f(p: &Path) -> bool { p . /* not a folder */ is_dir ( ) }", "is_dir"),
        ("fn f(p: &Path) -> bool { p.is_symlink() }", "is_symlink"),
        ("fn f(p: &Path) -> u64 { p.metadata()?.len() }", "metadata"),
        ("fn f(p: &Path) -> u64 { p.symlink_metadata()?.len() }", "symlink_metadata"),
        ("fn f(p: &Path) { for e in p.read_dir()? {} }", "read_dir"),
        ("fn f(p: &Path) { p.read_link()?; }", "read_link"),
        ("fn f(p: &Path) { Path::new(\".\").canonicalize()?; }", "canonicalize"),
        ("fn f(p: &Path) { std::path::absolute(p)?; }", "absolute"),
        ("use std::path::absolute;", "absolute"),
        ("use std::path::{PathBuf, absolute as whole};", "absolute"),
        ("use std::path; fn f() { path::absolute(p)?; }", "absolute"),
        ("fn f(all: &[PathBuf]) { all.iter().filter(std::path::Path::exists); }", "exists"),
        ("use std::path::Path; fn f() { all.filter(|p| Path::is_file(p)); }", "is_file"),
        ("fn f() { std::env::current_dir()?; }", "env"),
        ("fn f() { std::env::var(\"HOME\")?; }", "env"),
        ("use std::env; fn f() { env::args(); }", "env"),
        ("fn f() { std::process::Command::new(\"ls\"); }", "process"),
    ] {
        assert_eq!(found("job", text), format!("1 {name}"), "{text}");
        assert_eq!(found("run", text), "", "{text}");
    }
    let innocent = "use std::path::Path; struct A { exists: bool } fn exists() {} fn f(a: &A, p: &Path) -> bool { a.exists && exists() && p.file_name().is_some() && env!(\"A\").is_empty() && x.path().csv() }";
    assert_eq!(found("job", innocent), "");
    assert_eq!(found("job", "#[cfg(test)]\nmod tests {\n    fn f() { p.is_file(); std::env::var(x); }\n}"), "");
}
