//! All that the command prints: what cannot be written is an error at the end, not a panic on the
//! way, and what comes out of files cannot steer the terminal.

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

/// Whether standard output holds one JSON object a line.
pub fn is_json() -> bool {
    JSON.load(Ordering::Relaxed)
}

/// Writes an object as a JSON line; says whether standard output holds such lines.
pub fn event(value: &serde_json::Value) -> bool {
    let on = is_json();
    if on {
        plain(&escaped_json(&value.to_string()));
        plain("\n");
    }
    on
}

/// Writes one line to standard output, whatever line ends are in the text.
pub fn line(text: Arguments<'_>) {
    write(format_args!("{}\n", visible(&text.to_string())));
}

/// Writes one line to standard error.
pub fn told(text: &str) {
    // Where not even this can be written, the exit code still says so.
    let _ = writeln!(std::io::stderr(), "{}", visible(text));
}

/// Writes to standard output; where it holds JSON lines, each line as an object of its own.
pub fn write(text: Arguments<'_>) {
    let text = escaped(&text.to_string(), |c| c == '\n');
    if !is_json() {
        return plain(&text);
    }
    let Ok(mut line) = LINE.lock() else { return };
    line.push_str(&text);
    while let Some(end) = line.find('\n') {
        let said: String = line.drain(..=end).collect();
        event(&serde_json::json!({ "event": "output", "text": said.trim_end_matches('\n') }));
    }
}

/// Names and quotes of files may hold what a terminal takes for an order: it is shown as `\u{1b}`
/// instead. Line ends too.
pub fn visible(text: &str) -> String {
    escaped(text, |_| false)
}

fn escaped(text: &str, but_for: impl Fn(char) -> bool) -> String {
    let mut out = String::with_capacity(text.len());
    for c in text.chars() {
        match steers(c) && !but_for(c) {
            true => out.extend(c.escape_unicode()),
            false => out.push(c),
        }
    }
    out
}

/// JSON text in which the characters that JSON itself lets through are escaped as it escapes the
/// others.
fn escaped_json(text: &str) -> String {
    let mut out = String::with_capacity(text.len());
    for c in text.chars() {
        match steers(c) {
            true => out += &format!("\\u{:04x}", u32::from(c)),
            false => out.push(c),
        }
    }
    out
}

/// Control characters but the tabulator, line separators, and marks that turn the direction of
/// writing round.
fn steers(c: char) -> bool {
    const MARKS: [char; 12] = [
        '\u{61c}', '\u{200e}', '\u{200f}', '\u{202a}', '\u{202b}', '\u{202c}', '\u{202d}', '\u{202e}', '\u{2066}',
        '\u{2067}', '\u{2068}', '\u{2069}',
    ];
    (c.is_control() && c != '\t') || MARKS.contains(&c) || ['\u{2028}', '\u{2029}'].contains(&c)
}

fn plain(text: &str) {
    let mut out = std::io::stdout().lock();
    if let Err(e) = out.write_all(text.as_bytes()).and_then(|()| out.flush())
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

/// A measured value; "no end" where it has no greatest value.
pub fn amount(x: f64) -> String {
    if x >= f64::MAX { "no end".into() } else { format!("{x:.6}") }
}

/// As `print!`, without its panic.
macro_rules! say {
    ($($arg:tt)*) => { $crate::cli::out::write(format_args!($($arg)*)) };
}

/// As `println!`, without its panic.
macro_rules! sayln {
    () => { $crate::cli::out::write(format_args!("\n")) };
    ($($arg:tt)*) => { $crate::cli::out::line(format_args!($($arg)*)) };
}

pub(super) use {say, sayln};

#[cfg(test)]
mod tests {
    use super::{escaped_json, limit, visible};

    #[test]
    fn nothing_steers_the_terminal() {
        let hostile = "x\u{1b}]0;OWNED\u{7}\r\n\u{9b}2J\u{7f}\u{202e}a\u{2066}b\u{2028}";
        let shown = visible(hostile);
        assert_eq!(shown, "x\\u{1b}]0;OWNED\\u{7}\\u{d}\\u{a}\\u{9b}2J\\u{7f}\\u{202e}a\\u{2066}b\\u{2028}");
        assert_eq!(visible("S–θ 3° µm²\tüß 鋼"), "S–θ 3° µm²\tüß 鋼");
        let json = escaped_json(&serde_json::json!({ hostile: [hostile] }).to_string());
        assert!(!json.chars().any(super::steers), "{json}");
        assert_eq!(
            serde_json::from_str::<serde_json::Value>(&json).ok(),
            Some(serde_json::json!({ hostile: [hostile] }))
        );
    }

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
