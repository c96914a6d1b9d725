//! Standard output that may be full or closed: what cannot be written is an error at the end, not a panic on the way.

use std::fmt::Arguments;
use std::io::{ErrorKind, Write};
use std::sync::Mutex;

use crate::error::{Error, Result, Stage};

/// The first error of a write.
static FAILED: Mutex<Option<std::io::Error>> = Mutex::new(None);

/// Writes to standard output.
pub fn write(text: Arguments<'_>) {
    let mut out = std::io::stdout().lock();
    if let Err(e) = out.write_fmt(text).and_then(|()| out.flush())
        && let Ok(mut failed) = FAILED.lock()
    {
        failed.get_or_insert(e);
    }
}

/// What went wrong, if anything. A reader that has seen enough (`| head`) is no error.
///
/// # Errors
/// `InputOutput`: standard output could not be written.
pub fn end() -> Result<()> {
    match FAILED.lock().ok().and_then(|mut f| f.take()) {
        Some(e) if e.kind() != ErrorKind::BrokenPipe => {
            Err(Error::io(Stage::Output, format!("standard output cannot be written: {e}")).caused_by(e))
        }
        _ => Ok(()),
    }
}

/// As `print!`, without its panic.
macro_rules! say {
    ($($arg:tt)*) => { $crate::cli::out::write(format_args!($($arg)*)) };
}

/// As `println!`, without its panic.
macro_rules! sayln {
    () => { $crate::cli::out::write(format_args!("\n")) };
    ($($arg:tt)*) => { $crate::cli::out::write(format_args!("{}\n", format_args!($($arg)*))) };
}

pub(super) use {say, sayln};
