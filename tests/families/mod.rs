//! A small family, and folders of results compared.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

/// Four made blades of two shapes at two feeds, coarse and small.
pub const FAMILY: &str = r#"
design = "prism"
[template]
tool = { radius_mm = 5 }
region = { start_mm = 7, end_mm = 6 }
path = { scallop_mm = 0.2, chord_mm = 0.02, max_step_mm = 2 }
channel = { tolerance_deg = 0.1 }
verify = { surface_samples = 1000, resolution_mm = 0.02, scallop_ratio = 1000 }
section = { count = 1 }
[ranges]
"design.fillet_radius_mm" = [6, 7]
"feed.feed_mm_min" = [1000, 2000]
"#;

/// Every file but those of the log, by its path.
pub fn tree(root: &Path) -> BTreeMap<PathBuf, Vec<u8>> {
    fn walk(dir: &Path, root: &Path, all: &mut BTreeMap<PathBuf, Vec<u8>>) {
        for entry in std::fs::read_dir(dir).expect("readable") {
            let path = entry.expect("entry").path();
            let relative = path.strip_prefix(root).expect("inside").to_path_buf();
            if relative == Path::new("log") {
                continue;
            }
            if path.is_dir() {
                all.insert(relative, Vec::new());
                walk(&path, root, all);
            } else {
                all.insert(relative, std::fs::read(&path).expect("readable"));
            }
        }
    }
    let mut all = BTreeMap::new();
    walk(root, root, &mut all);
    all
}

/// Both folders hold the same, byte for byte, but for their logs.
#[track_caller]
pub fn same(a: &Path, b: &Path) {
    let (a, b) = (tree(a), tree(b));
    assert_eq!(a.keys().collect::<Vec<_>>(), b.keys().collect::<Vec<_>>());
    for (path, bytes) in &a {
        assert!(b[path] == *bytes, "{} differs", path.display());
    }
}
