//! Files that users name, read with bounds: a pipe or a device would be waited for or read for
//! ever, and a file without end would fill the memory.

use std::fs::{File, Metadata};
use std::io::{Error, ErrorKind, Read, Result, Take};
use std::path::Path;

/// Most bytes of a text that is written by hand: a job, a machine, a tool, a post file.
pub const SHORT: u64 = 1 << 20;
/// Most bytes of a model, a program or a table of results.
pub const LONG: u64 = 4 << 30;

/// All bytes of a regular file, links followed, of at most `limit` bytes.
///
/// # Errors
/// Those of the system; kind `InvalidInput`: it is a folder, a pipe or a device; kind
/// `FileTooLarge`: it is longer than the limit, or became longer while it was read. Each is one
/// clause that goes on after "cannot be read: ".
pub fn read(path: &Path, limit: u64) -> Result<Vec<u8>> {
    let mut file = open(path, limit)?;
    let mut bytes = Vec::with_capacity(usize::try_from(file.get_ref().metadata()?.len()).unwrap_or(0));
    file.read_to_end(&mut bytes)?;
    if bytes.len() as u64 > limit {
        return Err(too_long(limit));
    }
    Ok(bytes)
}

/// Length and BLAKE3 hash of a file, read as [`read`] does but not kept.
///
/// # Errors
/// Those of [`read`].
pub fn hash(path: &Path, limit: u64) -> Result<(u64, String)> {
    let mut hasher = blake3::Hasher::new();
    let bytes = std::io::copy(&mut open(path, limit)?, &mut hasher)?;
    if bytes > limit {
        return Err(too_long(limit));
    }
    Ok((bytes, hasher.finalize().to_hex().to_string()))
}

/// As [`read`], as a text.
///
/// # Errors
/// Those of [`read`]; kind `InvalidData`: it is not UTF-8.
pub fn read_text(path: &Path, limit: u64) -> Result<String> {
    String::from_utf8(read(path, limit)?).map_err(|e| {
        let at = e.utf8_error().valid_up_to();
        Error::new(ErrorKind::InvalidData, format!("it is not a text in UTF-8, see byte {}", at + 1))
    })
}

/// Whether a name leads to a file in the folder it is taken from, or below it.
pub fn stays_below(name: &Path) -> bool {
    use std::path::Component::{CurDir, Normal};
    name.components().all(|c| matches!(c, Normal(_) | CurDir))
}

/// A regular file up to one byte more than the limit: that byte shows that it is too long.
fn open(path: &Path, limit: u64) -> Result<Take<File>> {
    // Asked before it is opened: opening a pipe waits for a writer.
    regular(&std::fs::metadata(path)?)?;
    let file = File::open(path)?;
    let meta = file.metadata()?;
    regular(&meta)?;
    if meta.len() > limit {
        return Err(too_long(limit));
    }
    Ok(file.take(limit + 1))
}

fn regular(meta: &Metadata) -> Result<()> {
    if meta.is_file() {
        return Ok(());
    }
    let what = if meta.is_dir() { "a folder" } else { "a pipe or a device" };
    Err(Error::new(ErrorKind::InvalidInput, format!("it is {what}, not a file")))
}

fn too_long(limit: u64) -> Error {
    let most = match limit {
        0..0x400 => format!("{limit} bytes"),
        0x400..0x10_0000 => format!("{} KiB", limit >> 10),
        0x10_0000..0x4000_0000 => format!("{} MiB", limit >> 20),
        _ => format!("{} GiB", limit >> 30),
    };
    Error::new(ErrorKind::FileTooLarge, format!("it is longer than {most}, the most that is read of such a file"))
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used)]
    use super::*;

    #[test]
    fn a_file_up_to_its_limit() {
        let dir = tempfile::tempdir().unwrap();
        let file = dir.path().join("a");
        std::fs::write(&file, "12345").unwrap();
        assert_eq!(read_text(&file, 5).unwrap(), "12345");
        let e = read(&file, 4).unwrap_err();
        assert_eq!((e.kind(), e.to_string().contains("longer than")), (ErrorKind::FileTooLarge, true));
        assert!(read(dir.path(), 4).unwrap_err().to_string().contains("a folder, not a file"));
        std::fs::write(&file, b"ab\xff").unwrap();
        assert!(read_text(&file, 5).unwrap_err().to_string().contains("see byte 3"));
        assert_eq!(read(&dir.path().join("none"), 5).unwrap_err().kind(), ErrorKind::NotFound);
    }

    #[test]
    #[cfg(target_os = "linux")]
    fn a_device_is_not_read() {
        let dir = tempfile::tempdir().unwrap();
        let link = dir.path().join("link");
        std::os::unix::fs::symlink("/dev/zero", &link).unwrap();
        assert!(read(&link, LONG).unwrap_err().to_string().contains("a pipe or a device"));
    }

    #[test]
    #[cfg(target_os = "linux")]
    fn a_file_that_says_it_is_empty_is_read_to_its_limit_at_most() {
        // Files of /proc have no length before they are read, like files that grow.
        let path = Path::new("/proc/self/status");
        assert!(read(path, SHORT).unwrap().len() > 100);
        assert_eq!(read(path, 100).unwrap_err().kind(), ErrorKind::FileTooLarge);
    }

    #[test]
    fn names_below_a_folder() {
        for name in ["a.csv", "./a.csv", "sub/a.csv"] {
            assert!(stays_below(Path::new(name)), "{name}");
        }
        for name in ["/etc/passwd", "../a.csv", "sub/../../a.csv"] {
            assert!(!stays_below(Path::new(name)), "{name}");
        }
    }
}
