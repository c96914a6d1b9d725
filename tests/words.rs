//! Prose keeps in step with the sources: paths that the documents name exist, and comments are
//! narrow enough to be read side by side.

use std::path::{Path, PathBuf};

/// Folders of a user's run that the documents speak of; they are no part of the sources.
const OF_A_RUN: [&str; 4] = ["log", "members", "out", "work"];
/// Folders whose comments keep to [`COMMENT_COLUMNS`].
const NARROW: &[&str] = &["src", "tests", "benches", "examples", "fuzz", "python"];
/// Most columns of a line that is a comment.
const COMMENT_COLUMNS: usize = 100;

fn root() -> &'static Path {
    Path::new(env!("CARGO_MANIFEST_DIR"))
}

fn files(dir: &Path, ending: &str, out: &mut Vec<PathBuf>) {
    if dir.is_file() {
        out.push(dir.to_owned());
        return;
    }
    for entry in std::fs::read_dir(dir).expect("the folder is readable") {
        let path = entry.expect("the entry is readable").path();
        let is_built = path.file_name().is_some_and(|n| n == "target");
        if path.is_dir() && !is_built || path.extension().is_some_and(|e| e == ending) {
            files(&path, ending, out);
        }
    }
}

/// Line and text of every word in backquotes that reads like a path; blocks of code are left out.
fn paths_named(text: &str) -> Vec<(usize, &str)> {
    let (mut found, mut is_code) = (Vec::new(), false);
    for (k, line) in text.lines().enumerate() {
        if line.trim_start().starts_with("```") {
            is_code = !is_code;
        } else if !is_code {
            let quoted = line.split('`').skip(1).step_by(2);
            found.extend(quoted.filter(|word| is_path(word)).map(|word| (k + 1, word)));
        }
    }
    found
}

fn is_path(word: &str) -> bool {
    let is_plain = word.chars().all(|c| c.is_ascii_alphanumeric() || "_-./".contains(c));
    let Some((first, rest)) = word.split_once('/') else { return false };
    let of_a_run = OF_A_RUN.contains(&first);
    let ending = rest.rsplit_once('.').map_or("", |(_, e)| e);
    let names_source = rest.is_empty() || rest.ends_with('/') || ["rs", "toml", "md", "json", "js"].contains(&ending);
    is_plain && !first.is_empty() && !of_a_run && (names_source || exists(first))
}

/// Whether a path exists in the project, or in `src/`, where rooms are named without it.
fn exists(path: &str) -> bool {
    root().join(path).exists() || root().join("src").join(path).exists()
}

/// Numbers of the lines that are comments and too wide. A table's row, a link, and code that an
/// example shows cannot be broken.
fn wide_comments(text: &str) -> Vec<usize> {
    let (mut found, mut is_code) = (Vec::new(), false);
    for (k, line) in text.lines().enumerate() {
        let Some(words) = line.trim_start().strip_prefix("//") else {
            is_code = false;
            continue;
        };
        let words = words.trim_start_matches(['/', '!']).trim_start();
        let is_fence = words.starts_with("```");
        is_code ^= is_fence;
        let is_whole = is_code || is_fence || words.starts_with('|') || words.contains("://") || !words.contains(' ');
        if !is_whole && line.chars().count() > COMMENT_COLUMNS {
            found.push(k + 1);
        }
    }
    found
}

#[test]
fn documents_name_paths_that_exist() {
    let mut documents = vec![root().join("ARCHITECTURE.md"), root().join("README.md")];
    files(&root().join("docs"), "md", &mut documents);
    let (mut seen, mut wrong) = (0, Vec::new());
    for document in documents {
        let text = std::fs::read_to_string(&document).expect("the document is readable");
        let named = paths_named(&text);
        seen += named.len();
        let missing = named.into_iter().filter(|(_, path)| !exists(path));
        wrong.extend(missing.map(|(line, path)| format!("{}:{line}: {path}", document.display())));
    }
    assert!(seen > 100, "only {seen} paths were found");
    assert!(wrong.is_empty(), "paths that do not exist:\n{}", wrong.join("\n"));
}

#[test]
fn a_path_that_is_gone_is_found() {
    let text = "See `old/room.rs`, `src/lib.rs`, `a / b`, `out/run.json`.\n```\n`old/code.rs`\n```\n`du/ds` `old/`\n";
    let missing: Vec<_> = paths_named(text).into_iter().filter(|(_, path)| !exists(path)).collect();
    assert_eq!(missing, [(1, "old/room.rs"), (5, "old/")]);
}

#[test]
fn comments_keep_their_columns() {
    let mut sources = Vec::new();
    NARROW.iter().for_each(|place| files(&root().join(place), "rs", &mut sources));
    let mut wrong = Vec::new();
    for source in sources {
        let text = std::fs::read_to_string(&source).expect("the source is readable");
        wrong.extend(wide_comments(&text).into_iter().map(|line| format!("{}:{line}", source.display())));
    }
    assert!(wrong.is_empty(), "comments of more than {COMMENT_COLUMNS} columns:\n{}", wrong.join("\n"));
}

#[test]
fn a_wide_comment_is_found() {
    let long = "word ".repeat(30);
    let text =
        format!("// {long}\n/// | {long} |\n/// ```\n/// {long}\n/// ```\n    //! {long}\nlet x = \"// {long}\";\n");
    assert_eq!(wide_comments(&text), [1, 6]);
}
