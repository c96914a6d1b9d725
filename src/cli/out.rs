//! Standard output that may be full or closed: what cannot be written is an error at the end, not a panic on the way.

use std::fmt::Arguments;
use std::io::{ErrorKind, Write};
use std::sync::Mutex;
use std::sync::atomic::{AtomicBool, Ordering};

use crate::error::{Error, Result, Stage};

/// The first error of a write.
static FAILED: Mutex<Option<std::io::Error>> = Mutex::new(None);

/// Standard output holds JSON lines.
static JSON: AtomicBool = AtomicBool::new(false);
/// What was said since the last line's end, where standard output holds JSON lines.
static LINE: Mutex<String> = Mutex::new(String::new());

/// From here on standard output holds one JSON object a line, or not.
pub fn json_lines(on: bool) {
    JSON.store(on, Ordering::Relaxed);
}

/// Writes an object as a JSON line; says whether standard output holds such lines.
pub fn event(value: &serde_json::Value) -> bool {
    let on = JSON.load(Ordering::Relaxed);
    if on {
        plain(format_args!("{value}\n"));
    }
    on
}

/// Writes to standard output; where it holds JSON lines, each line as an object of its own.
pub fn write(text: Arguments<'_>) {
    if !JSON.load(Ordering::Relaxed) {
        return plain(text);
    }
    let Ok(mut line) = LINE.lock() else { return };
    line.push_str(&text.to_string());
    while let Some(end) = line.find('\n') {
        let said: String = line.drain(..=end).collect();
        event(&serde_json::json!({ "event": "output", "text": said.trim_end_matches('\n') }));
    }
}

fn plain(text: Arguments<'_>) {
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

/// A limit in nine significant digits at most: `0.00126`, not `0.0012599999999999998`.
pub fn limit(x: f64) -> String {
    format!("{x:.8e}").parse::<f64>().map_or_else(|_| x.to_string(), |rounded| rounded.to_string())
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

#[cfg(test)]
mod tests {
    use super::limit;

    #[test]
    fn limits_print_without_the_rounding_of_their_sums() {
        for (x, text) in [
            (0.0012599999999999998, "0.00126"),
            (0.1 + 0.2, "0.3"),
            (0.0, "0"),
            (-2.5, "-2.5"),
            (0.017453292519943295, "0.0174532925"),
            (360.0, "360"),
        ] {
            assert_eq!(limit(x), text);
        }
    }
}
