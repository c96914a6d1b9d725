//! Which reader a file needs: by its content first, by its extension where the content leaves it
//! open.

use std::path::Path;

use super::iges;
use super::table;
use crate::error::{Error, Result, Stage};

/// A model format that can be read.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Format {
    /// ISO 10303-21.
    Step,
    /// IGES, the form with fixed lines.
    Iges,
    /// Wavefront OBJ.
    Obj,
    /// STL, ASCII.
    StlAscii,
    /// STL, binary.
    StlBinary,
    /// PLY, ASCII or binary.
    Ply,
    /// glTF 2.0, as text or as GLB.
    Gltf,
    /// A table of sections, or the header of one.
    Sections,
}

/// Formats as messages list them.
const KNOWN: &str = "STEP (.step, .stp), IGES (.igs, .iges), OBJ (.obj), STL (.stl), PLY (.ply), glTF (.glb, .gltf) and tables of sections can be read";

/// The mark that some editors and spreadsheets put before UTF-8.
const MARK: &[u8] = b"\xef\xbb\xbf";

/// The bytes behind a byte-order mark, which belongs to no format of models; those of a binary STL,
/// whose header may hold anything, as they are.
pub fn without_mark(bytes: &[u8]) -> &[u8] {
    bytes.strip_prefix(MARK).filter(|_| binary_stl_length(bytes) != Some(bytes.len())).unwrap_or(bytes)
}

/// Decides the format of a file from its bytes and name.
///
/// # Errors
/// `InputOutput`: an empty file, a file whose content contradicts its extension, text in UTF-16, an
/// unknown format.
pub fn detect(path: &Path, bytes: &[u8]) -> Result<Format> {
    let name = path.display();
    let bytes = without_mark(bytes);
    if bytes.iter().all(u8::is_ascii_whitespace) {
        let what = if bytes.is_empty() { "is empty" } else { "holds only white space" };
        return Err(Error::io(Stage::Model, format!("{name} {what}")).advise("export the model again"));
    }
    let wide = bytes.starts_with(b"\xff\xfe") || bytes.starts_with(b"\xfe\xff");
    if wide && binary_stl_length(bytes) != Some(bytes.len()) {
        return Err(Error::io(Stage::Model, format!("{name} is text in UTF-16, which is not read")).advise(
            "save it as UTF-8 or ASCII: editors offer that as an encoding, PowerShell as Out-File -Encoding ascii",
        ));
    }
    let extension = path.extension().map(|e| e.to_string_lossy().to_lowercase()).unwrap_or_default();
    if starts_with_word(bytes, b"ISO-10303-21") {
        return Ok(Format::Step);
    }
    if bytes.starts_with(b"glTF") || (extension == "gltf" && starts_with_word(bytes, b"{")) {
        return Ok(Format::Gltf);
    }
    if bytes.starts_with(b"ply\n") || bytes.starts_with(b"ply\r\n") {
        return Ok(Format::Ply);
    }
    if iges::text::is_iges(bytes) {
        return Ok(Format::Iges);
    }
    match extension.as_str() {
        "ply" | "glb" | "gltf" => {
            Err(Error::io(Stage::Model, format!("{name} does not begin as a .{extension} file does"))
                .advise("the file is damaged or of another format: export it again"))
        }
        "step" | "stp" | "p21" => {
            Err(Error::io(Stage::Model, format!("{name} is not a STEP file: it does not begin with ISO-10303-21"))
                .advise("export the model again as STEP AP203, AP214 or AP242"))
        }
        "stl" => Ok(stl_kind(bytes)),
        "obj" => Ok(Format::Obj),
        "igs" | "iges" => Err(Error::io(
            Stage::Model,
            format!("{name} is not an IGES file: its first line has no S and number from column 73"),
        )
        .advise("export the model again as ASCII IGES 5.3")),
        "x_t" | "x_b" | "sldprt" | "brep" | "3mf" => {
            Err(Error::io(Stage::Model, format!("{name}: models in .{extension} cannot be read"))
                .advise(format!("{KNOWN}; export as STEP")))
        }
        "toml" => Ok(Format::Sections),
        _ if bytes.starts_with(b"+++") || table::direct::detect(bytes).is_some() => Ok(Format::Sections),
        _ if stl_kind(bytes) == Format::StlAscii || binary_stl_length(bytes) == Some(bytes.len()) => {
            Ok(stl_kind(bytes))
        }
        _ => {
            Err(Error::io(Stage::Model, format!("{name}: neither its name nor its content shows its format"))
                .advise(KNOWN))
        }
    }
}

/// Whether the text begins with this word, any case, after white space.
fn starts_with_word(bytes: &[u8], word: &[u8]) -> bool {
    let bytes = bytes.trim_ascii_start();
    bytes.len() >= word.len() && bytes[..word.len()].eq_ignore_ascii_case(word)
}

/// The length that the triangle count of a binary STL's header asks for.
pub fn binary_stl_length(bytes: &[u8]) -> Option<usize> {
    let count = bytes.get(80..84)?;
    let n = u32::from_le_bytes([count[0], count[1], count[2], count[3]]);
    usize::try_from(u64::from(n) * 50 + 84).ok()
}

/// Many binary files begin with "solid" too, so the length decides first; ASCII needs a `facet`
/// near the start.
fn stl_kind(bytes: &[u8]) -> Format {
    if binary_stl_length(bytes) == Some(bytes.len()) {
        return Format::StlBinary;
    }
    let head = bytes[..bytes.len().min(1024)].to_ascii_lowercase();
    let has = |word: &[u8]| head.windows(word.len()).any(|w| w == word);
    if starts_with_word(bytes, b"solid") && (has(b"facet") || has(b"endsolid")) && !head.contains(&0) {
        Format::StlAscii
    } else {
        Format::StlBinary
    }
}
