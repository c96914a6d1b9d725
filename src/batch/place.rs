//! Where `-o` leads: a folder, or `s3://bucket/prefix`.

use std::path::Path;

use super::members::Family;
use super::store::{Folder, Store};
use crate::error::Result;

/// Opens the place of results for one part of the family.
///
/// # Errors
/// `InputOutput` where it cannot be written or is another process', `Usage` where the program was
/// built without what it needs.
pub(super) fn open(out: &str, family: &Family, part: &str) -> Result<Box<dyn Store>> {
    if out.starts_with("s3://") {
        return objects(out);
    }
    let folder = Path::new(out);
    super::check_apart(folder, family)?;
    Ok(Box::new(Folder::open(folder, part)?))
}

#[cfg(feature = "s3")]
fn objects(out: &str) -> Result<Box<dyn Store>> {
    Ok(Box::new(super::objects::Objects::s3(out)?))
}

#[cfg(not(feature = "s3"))]
fn objects(out: &str) -> Result<Box<dyn Store>> {
    use crate::error::{Error, Stage};
    Err(Error::usage(Stage::Batch, format!("{out}: this program was built without object storage"))
        .advise("build it with `cargo build --release --features s3`, or give a folder"))
}
