//! Long lists of numbers as one block of 32-bit floating-point numbers in base 64: a third of the
//! size of JSON and read at once.

use base64::Engine;
use base64::engine::general_purpose::STANDARD;
use serde_json::{Value, json};

/// A block being filled.
#[derive(Default)]
pub(super) struct Pack {
    bytes: Vec<u8>,
}

impl Pack {
    /// Adds a list; in the page's JSON it is `{"at": first number, "n": how many}`. Missing values
    /// are not a number.
    pub(super) fn list(&mut self, values: impl IntoIterator<Item = f64>) -> Value {
        let at = self.bytes.len() / 4;
        for v in values {
            self.bytes.extend_from_slice(&(v as f32).to_le_bytes());
        }
        json!({ "at": at, "n": self.bytes.len() / 4 - at })
    }

    /// The block.
    pub(super) fn base64(&self) -> String {
        STANDARD.encode(&self.bytes)
    }
}

/// Any bytes.
pub(super) fn base64(bytes: &[u8]) -> String {
    STANDARD.encode(bytes)
}

#[cfg(test)]
pub(super) fn unpacked(text: &str) -> Vec<f32> {
    let bytes = STANDARD.decode(text).unwrap_or_default();
    bytes.chunks_exact(4).map(|c| f32::from_le_bytes([c[0], c[1], c[2], c[3]])).collect()
}
