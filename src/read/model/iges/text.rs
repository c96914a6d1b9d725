//! The text of an IGES file: lines of 80 columns in five sections, and parameters in free format.
//!
//! In: bytes. Out: [`FileSections`], the lines of each section without their sequence columns, and
//! [`values`], the parameters of one record. Lines may be shorter than 80 columns where trailing
//! blanks were cut off, and end in LF, CR LF or nothing.

/// Column of the section letter, from 0.
const LETTER: usize = 72;
/// Columns of a parameter line that hold data.
const DATA: usize = 64;

/// A parameter as it is written.
#[derive(Clone, Debug, PartialEq)]
pub enum Value {
    /// Nothing between two delimiters: the default.
    Empty,
    /// An integer, a real number, or a pointer.
    Number(f64),
    /// A Hollerith text.
    Text(String),
}

/// The lines of a file by section.
#[derive(Debug, Default)]
pub struct FileSections<'a> {
    /// The global section's columns 1–72, joined.
    pub global: Vec<u8>,
    /// Directory lines.
    pub directory: Vec<&'a [u8]>,
    /// Parameter lines, columns 1–64.
    pub parameters: Vec<&'a [u8]>,
}

/// Whether the bytes begin like an IGES file: `S` in column 73 of the first line, a sequence number
/// after it.
pub fn is_iges(bytes: &[u8]) -> bool {
    lines(&bytes[..bytes.len().min(4096)]).next().is_some_and(|l| letter(l) == Some(b'S'))
}

/// Lines by line ends, or by 80 columns where there are no line ends.
fn lines(bytes: &[u8]) -> impl Iterator<Item = &[u8]> {
    let ended = bytes.iter().take(200).any(|b| matches!(b, b'\n' | b'\r'));
    let cut = move |b: &u8| ended && matches!(b, b'\n' | b'\r');
    let width = if ended { usize::MAX } else { 80 };
    bytes.split(cut).filter(|l| !l.is_empty()).flat_map(move |l| l.chunks(width))
}

/// The section letter of a line, if what follows is a sequence number.
fn letter(line: &[u8]) -> Option<u8> {
    let number = line.get(LETTER + 1..)?.trim_ascii();
    let fits = !number.is_empty() && number.len() <= 8 && number.iter().all(u8::is_ascii_digit);
    line.get(LETTER).copied().filter(|_| fits)
}

/// Sorts the lines of a file into sections.
///
/// # Errors
/// A sentence: a line without a section letter, a binary or compressed file, a file without
/// directory or parameters.
pub fn sections(bytes: &[u8]) -> Result<FileSections<'_>, String> {
    let mut out = FileSections::default();
    let mut terminated = false;
    for (k, line) in lines(bytes).enumerate() {
        match letter(line) {
            Some(b'S') => {}
            Some(b'G') => out.global.extend_from_slice(&line[..LETTER]),
            Some(b'D') => out.directory.push(&line[..LETTER]),
            Some(b'P') => out.parameters.push(&line[..DATA]),
            Some(b'T') => {
                terminated = true;
                break;
            }
            Some(b'C') => return Err("is in the compressed form of IGES, which cannot be read".into()),
            Some(b'B') => return Err("is in the binary form of IGES, which cannot be read".into()),
            _ if line.trim_ascii().is_empty() || line == b"\x1a" => {}
            _ => return Err(format!("has no section letter (S, G, D, P or T) in column 73 of line {}", k + 1)),
        }
    }
    if out.directory.is_empty() || out.parameters.is_empty() {
        return Err("has no directory or no parameter section".into());
    }
    if !terminated {
        return Err("ends without its T line: it was cut off".into());
    }
    Ok(out)
}

/// The parameters of one record, up to the record delimiter or the end of the text.
///
/// # Errors
/// A sentence: what is neither number nor text, a text that is cut off.
pub fn values(text: &[u8], delimiter: u8, record: u8) -> Result<Vec<Value>, String> {
    let mut out = Vec::new();
    let mut rest = text;
    loop {
        rest = rest.trim_ascii_start();
        let value;
        (value, rest) = match hollerith(rest)? {
            Some((text, after)) => (Value::Text(text), after),
            None => {
                let end = rest.iter().position(|b| *b == delimiter || *b == record).unwrap_or(rest.len());
                (number(&rest[..end])?, &rest[end..])
            }
        };
        rest = rest.trim_ascii_start();
        match rest.split_first() {
            Some((b, after)) if *b == delimiter => {
                out.push(value);
                rest = after;
            }
            Some((b, _)) if *b == record => {
                out.push(value);
                return Ok(out);
            }
            Some(_) => return Err(format!("\"{}\" stands where a delimiter should", shown(rest))),
            None => {
                if value != Value::Empty {
                    out.push(value);
                }
                return Ok(out);
            }
        }
    }
}

/// A text `nH…` and what follows it.
fn hollerith(rest: &[u8]) -> Result<Option<(String, &[u8])>, String> {
    let digits = rest.iter().take_while(|b| b.is_ascii_digit()).count();
    if digits == 0 || !matches!(rest.get(digits), Some(b'H' | b'h')) {
        return Ok(None);
    }
    let count = std::str::from_utf8(&rest[..digits]).ok().and_then(|d| d.parse::<usize>().ok());
    let text = &rest[digits + 1..];
    match count {
        Some(n) if n <= text.len() => Ok(Some((String::from_utf8_lossy(&text[..n]).into_owned(), &text[n..]))),
        _ => Err(format!("the text \"{}\" is cut off", shown(rest))),
    }
}

/// A number as FORTRAN writes it (`1.5D-3`), or nothing.
fn number(token: &[u8]) -> Result<Value, String> {
    let token = token.trim_ascii();
    if token.is_empty() {
        return Ok(Value::Empty);
    }
    let plain: String =
        token.iter().map(|b| if matches!(b, b'D' | b'd') { 'E' } else { char::from(*b) }).collect::<String>();
    // Rust also reads words such as "inf" as numbers.
    let numeric = plain.bytes().all(|b| b.is_ascii_digit() || matches!(b, b'+' | b'-' | b'.' | b'E' | b'e'));
    match plain.parse::<f64>() {
        Ok(x) if numeric && x.is_finite() => Ok(Value::Number(x)),
        _ => Err(format!("\"{}\" is not a number", shown(token))),
    }
}

/// The first few characters, for messages.
fn shown(text: &[u8]) -> String {
    String::from_utf8_lossy(&text[..text.len().min(24)]).chars().filter(|c| !c.is_control()).collect()
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used)]
    use super::*;

    #[test]
    fn free_format_is_read() {
        let v = values(b"110, 1.5D-3,,-2., 5Ha,b;c ,+1E2 ; rest", b',', b';').unwrap();
        let expected = [
            Value::Number(110.0),
            Value::Number(0.0015),
            Value::Empty,
            Value::Number(-2.0),
            Value::Text("a,b;c".into()),
            Value::Number(100.0),
        ];
        assert_eq!(v, expected);
        assert_eq!(values(b"1/2//3!", b'/', b'!').unwrap().len(), 4);
        assert_eq!(values(b"1,2,", b',', b';').unwrap().len(), 2);
    }

    #[test]
    fn what_is_not_free_format_is_named() {
        for (text, says) in [
            (&b"1,nan;"[..], "\"nan\" is not a number"),
            (b"1,inf;", "not a number"),
            (b"1,1e999;", "not a number"),
            (b"99999999999999999999Hx;", "cut off"),
            (b"5Hab;", "cut off"),
            (b"2Habc,1;", "where a delimiter should"),
        ] {
            let m = values(text, b',', b';').err().unwrap_or_default();
            assert!(m.contains(says), "{m:?}");
        }
    }
}
