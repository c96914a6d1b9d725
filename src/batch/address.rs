//! What a member is computed from, as one hash; and what it is likely to cost.
//!
//! The address is the BLAKE3 hash of the program's version and build, the job as typed (machine and
//! post files by their content), and the model's name and content (that of its data files too), or
//! the generator's design. Where a file lies does not matter. What stands in the address decides
//! every byte of the result, so the same address is never computed twice.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use std::sync::Mutex;

use super::member::{BladeSource, Member};
use crate::error::{Error, Result, Stage};
use crate::files;
use crate::job::JobFile;
use crate::read::model;
use crate::run;

/// Raised when results of the same inputs are kept in another way.
const LAYOUT: &str = "bladewright-family 2";

/// Size and hash of a file; `None`: it cannot be read, which is the member's trouble when its turn
/// comes.
type Content = Option<(u64, String)>;

/// Contents of files, each read once.
#[derive(Default)]
pub(super) struct Contents(Mutex<BTreeMap<PathBuf, Content>>);

impl Contents {
    fn of(&self, path: &Path) -> Content {
        let lock = || self.0.lock().unwrap_or_else(std::sync::PoisonError::into_inner);
        if let Some(known) = lock().get(path) {
            return known.clone();
        }
        let content = files::hash(path, files::LONG).ok();
        lock().insert(path.to_path_buf(), content.clone());
        content
    }
}

/// What is known of a member before it is computed.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Address {
    /// Everything that its result follows from.
    pub key: String,
    /// The part of that which path and channel follow from: members that share it share those
    /// stages.
    pub group: String,
}

fn text(value: &impl serde::Serialize) -> Result<String> {
    toml::to_string(value).map_err(|e| Error::usage(Stage::Batch, format!("a job cannot be written as TOML: {e}")))
}

/// The member's address.
pub(super) fn address(member: &Member, contents: &Contents) -> Result<Address> {
    let mut blade = blake3::Hasher::new();
    let add = |hasher: &mut blake3::Hasher, part: &str| {
        // Lengths part the pieces, so that no two lists of pieces are the same text.
        hasher.update(&(part.len() as u64).to_le_bytes());
        hasher.update(part.as_bytes());
    };
    let told = |content: Content| content.map_or_else(|| "unreadable".to_owned(), |(_, hash)| hash);
    add(&mut blade, LAYOUT);
    add(&mut blade, &run::program());
    add(&mut blade, run::build());
    match &member.source {
        BladeSource::Design(d) => {
            add(&mut blade, "design");
            add(&mut blade, &text(d)?);
        }
        BladeSource::Model(path) => {
            add(&mut blade, "model");
            add(&mut blade, &path.file_name().unwrap_or_default().to_string_lossy());
            add(&mut blade, &told(contents.of(path)));
            for file in model::table::data_files(path) {
                add(&mut blade, &told(contents.of(&file)));
            }
        }
    }
    let mut job = member.job.clone();
    for f in job.files_mut() {
        *f = told(contents.of(Path::new(f)));
    }
    let shared = JobFile {
        machine: job.machine.clone().map(|m| crate::machine::MachineKeys { file: None, ..m }),
        schedule: None,
        feed: None,
        post: None,
        verify: None,
        section: None,
        ..job.clone()
    };
    let (mut key, mut group) = (blade.clone(), blade);
    add(&mut key, &text(&job)?);
    add(&mut group, &text(&shared)?);
    Ok(Address { key: key.finalize().to_hex().to_string(), group: group.finalize().to_hex().to_string() })
}

/// Likely effort of a member: time in an arbitrary unit and peak memory. Both follow from inputs
/// alone, so all shards agree.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Estimate {
    pub cost: f64,
    pub memory_mib: u64,
}

/// Estimates a member. A model's size stands for its faces; a made blade's accuracy, for its own.
/// Turns grow with the root of the inverse scallop and locations with the inverse step, and both
/// with the region.
pub(super) fn estimate(member: &Member, contents: &Contents) -> Estimate {
    let mib = match &member.source {
        BladeSource::Model(path) => contents.of(path).map_or(0.0, |(bytes, _)| bytes as f64 / f64::from(1 << 20)),
        BladeSource::Design(d) => (d.accuracy.stations * d.accuracy.rows) as f64 * 200.0 / f64::from(1 << 20),
    };
    let path = member.job.path.clone().unwrap_or_default();
    let density = (0.01 / path.scallop_mm.unwrap_or(0.01).max(1e-6)).sqrt();
    let radius = member.job.tool.as_ref().and_then(|t| t.radius_mm).unwrap_or(3.0).max(1e-3);
    let locations = density * (3.0 / radius).clamp(0.1, 10.0).powf(1.5);
    Estimate {
        cost: (1.0 + mib) * locations,
        memory_mib: (BASE_MIB + MIB_PER_MIB * mib + MIB_PER_LOCATIONS * locations).ceil() as u64,
    }
}

/// Memory that a member takes in any case, MiB; for each MiB of its model; and for the locations of
/// an ordinary path. Measured on the models of the project and on published blades, rounded up.
const BASE_MIB: f64 = 60.0;
/// See [`BASE_MIB`].
const MIB_PER_MIB: f64 = 60.0;
/// See [`BASE_MIB`].
const MIB_PER_LOCATIONS: f64 = 300.0;
