//! Numbers in the files of a plan: base64 of doubles, lowest byte first.
//!
//! They are about half as long as decimal digits, are read several times as fast, and are the same
//! to the last bit. In Python: `numpy.frombuffer(base64.b64decode(text), "<f8")`.

use base64::Engine;
use base64::engine::general_purpose::STANDARD;
use serde::de::Error as _;
use serde::{Deserialize, Deserializer, Serialize, Serializer};

/// The text of values.
pub(super) fn text(values: &[f64]) -> String {
    let bytes: Vec<u8> = values.iter().flat_map(|v| v.to_le_bytes()).collect();
    STANDARD.encode(bytes)
}

/// The values of a text.
///
/// # Errors
/// Says what is wrong with it: no base64, no whole number of doubles, one that is not finite.
pub(super) fn values(text: &str) -> Result<Vec<f64>, String> {
    let bytes = STANDARD.decode(text).map_err(|e| format!("numbers are no base64: {e}"))?;
    let (doubles, rest) = bytes.as_chunks::<8>();
    if !rest.is_empty() {
        return Err(format!("numbers take {} bytes, which are no whole doubles", bytes.len()));
    }
    let values: Vec<f64> = doubles.iter().map(|b| f64::from_le_bytes(*b)).collect();
    match values.iter().position(|v| !v.is_finite()) {
        Some(k) => Err(format!("number {k} is {}", values[k])),
        None => Ok(values),
    }
}

/// A list of numbers, for `#[serde(with = "packed")]`.
pub(super) fn serialize<S: Serializer>(values: &[f64], to: S) -> Result<S::Ok, S::Error> {
    to.serialize_str(&text(values))
}

/// A list of numbers, for `#[serde(with = "packed")]`.
pub(super) fn deserialize<'a, D: Deserializer<'a>>(from: D) -> Result<Vec<f64>, D::Error> {
    values(&String::deserialize(from)?).map_err(D::Error::custom)
}

/// A table in a file: the names of its columns, and its values row by row.
#[derive(Serialize, Deserialize)]
pub(super) struct Table {
    columns: Vec<String>,
    f64le: String,
}

impl Table {
    /// Of rows.
    pub fn of<const N: usize>(columns: [&str; N], rows: impl Iterator<Item = [f64; N]>) -> Self {
        let values: Vec<f64> = rows.flatten().collect();
        Table { columns: columns.map(String::from).to_vec(), f64le: text(&values) }
    }

    /// Its rows.
    ///
    /// # Errors
    /// Says what is wrong: other columns, values that are no whole rows, those of [`values`].
    pub fn rows<const N: usize>(&self, columns: [&str; N]) -> Result<Vec<[f64; N]>, String> {
        if self.columns != columns {
            return Err(format!("the columns are {}, they must be {}", self.columns.join(" "), columns.join(" ")));
        }
        let values = values(&self.f64le)?;
        let (rows, rest) = values.as_chunks::<N>();
        if rest.is_empty() { Ok(rows.to_vec()) } else { Err(format!("{} values are no whole rows", values.len())) }
    }
}

/// A number that counts from 0.
///
/// # Errors
/// Says so where it is none.
pub(super) fn index(value: f64) -> Result<u32, String> {
    let index = value as u32;
    if f64::from(index) == value { Ok(index) } else { Err(format!("{value} is no number of a row")) }
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used)]
    use super::*;

    #[test]
    fn numbers_come_back_to_the_last_bit() {
        let numbers = [0.1, -0.0, f64::MIN_POSITIVE, 1e300, std::f64::consts::PI];
        let back = values(&text(&numbers)).unwrap();
        assert!(numbers.iter().zip(&back).all(|(a, b)| a.to_bits() == b.to_bits()) && back.len() == 5);
        assert_eq!(text(&[1.0]), "AAAAAAAA8D8=");
    }

    #[test]
    fn what_is_no_list_of_numbers_is_refused() {
        for (bad, says) in [("a,b", "no base64"), ("AAAA", "3 bytes"), (&text(&[f64::NAN]), "number 0 is NaN")] {
            assert!(values(bad).unwrap_err().contains(says), "{bad}");
        }
        let table = Table::of(["a", "b"], [[1.0, 2.0], [3.0, 4.0]].into_iter());
        assert_eq!(table.rows(["a", "b"]).unwrap(), [[1.0, 2.0], [3.0, 4.0]]);
        assert!(table.rows(["b", "a"]).unwrap_err().contains("the columns are a b, they must be b a"));
        let short = Table { f64le: text(&[1.0]), ..table };
        assert!(short.rows(["a", "b"]).unwrap_err().contains("no whole rows"));
        assert!(index(2.0) == Ok(2) && index(0.5).is_err() && index(-1.0).is_err());
    }
}
