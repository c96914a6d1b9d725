//! glTF 2.0 and GLB, through the crate `gltf`: triangles, strips and fans, indexed or not, of every
//! node of the scene, placed by the nodes' transforms. Lengths are metres, as the format says.
//! Buffers may be in the GLB, in data URIs, or in files beside the model.
//!
//! Limits: skins, morphing and animation are not applied; compressed meshes (extensions that a file
//! requires) are refused.

use std::panic::{AssertUnwindSafe, catch_unwind};
use std::path::Path;

use gltf::accessor::{DataType, Dimensions, Item};
use gltf::mesh::Mode;
use gltf::{Accessor, Document, Gltf, Node, Semantic, buffer};
use nalgebra::Matrix4;

use super::soup::Soup;
use crate::artifact::blade::Unit;
use crate::error::{Error, Result, Stage};
use crate::files;
use crate::geometry::Point;
use crate::observe::Remark;

/// Nodes deeper than this are taken for circular.
const DEEPEST: usize = 64;
/// Files that place more triangles than this are refused: the memory of a desktop ends soon after.
const MOST_TRIANGLES: usize = 20_000_000;
/// Greatest size of a buffer in a file of its own, bytes.
const MOST_BYTES: u64 = 2 << 30;

type Said<T> = std::result::Result<T, String>;

/// Reads a glTF or GLB.
///
/// # Errors
/// `InputOutput`: not glTF, buffers that are missing or too short, accessors that do not fit,
/// required extensions that are not known.
pub fn read(path: &Path, bytes: &[u8]) -> Result<Soup> {
    let name = path.display();
    // Last resort around a parser that is not ours: whatever it meets in a damaged file, the user
    // gets a sentence.
    let read = catch_unwind(AssertUnwindSafe(|| read_guarded(path, bytes)))
        .unwrap_or_else(|_| Err("the glTF parser gave up on it".into()));
    read.map_err(|m| {
        Error::io(Stage::Model, format!("{name} cannot be read as glTF: {m}"))
            .advise("export the mesh again, as .glb with triangles and without compression")
    })
}

fn read_guarded(path: &Path, bytes: &[u8]) -> Said<Soup> {
    // The validation of the crate looks attributes up before it knows that they are there.
    let unchecked = Gltf::from_slice_without_validation(bytes).map_err(|e| e.to_string())?;
    let root = unchecked.document.as_json();
    for (k, mesh) in root.meshes.iter().enumerate() {
        let missing = |i: usize| i >= root.accessors.len();
        if mesh.primitives.iter().flat_map(|p| p.attributes.values()).any(|a| missing(a.value())) {
            return Err(format!("mesh {k} names an accessor that is not there"));
        }
    }
    let Gltf { document, blob } = Gltf::from_slice(bytes).map_err(|e| e.to_string())?;
    let buffers = document.buffers().map(|b| buffer_bytes(path, &b, blob.as_deref())).collect::<Said<Vec<_>>>()?;
    let format = if bytes.starts_with(b"glTF") { "GLB" } else { "glTF" };
    let soup = Soup { format: format!("{format} 2.0"), unit: Some(Unit::M), ..Soup::default() };
    let seen = vec![false; document.nodes().len()];
    let mut scene = GltfScene { buffers, soup, seen, other: 0, posed: false };
    for node in roots(&document) {
        scene.node(&node, &Matrix4::identity(), 0)?;
    }
    let mut soup = scene.soup;
    if scene.other > 0 {
        soup.notes.push(Remark::PrimitivesPassedOver { count: scene.other });
    }
    if scene.posed {
        soup.notes.push(Remark::TakenAtRest);
    }
    Ok(soup)
}

/// The nodes of the default scene, of the first one, or those that are nobody's children.
fn roots(document: &Document) -> Vec<Node<'_>> {
    if let Some(scene) = document.default_scene().or_else(|| document.scenes().next()) {
        return scene.nodes().collect();
    }
    let mut child = vec![false; document.nodes().len()];
    for c in document.nodes().flat_map(|n| n.children().collect::<Vec<_>>()) {
        if let Some(flag) = child.get_mut(c.index()) {
            *flag = true;
        }
    }
    document.nodes().filter(|n| !child.get(n.index()).copied().unwrap_or(true)).collect()
}

fn buffer_bytes(path: &Path, buffer: &gltf::Buffer, blob: Option<&[u8]>) -> Said<Vec<u8>> {
    let k = buffer.index();
    let bytes = match buffer.source() {
        buffer::Source::Bin => {
            blob.ok_or_else(|| format!("buffer {k} is to be in the GLB, but is not there"))?.to_vec()
        }
        buffer::Source::Uri(uri) => match uri.strip_prefix("data:") {
            Some(data) => {
                let (_, text) =
                    data.split_once(";base64,").ok_or_else(|| format!("buffer {k}: data that is not base64"))?;
                base64(text).ok_or_else(|| format!("buffer {k}: damaged base64"))?
            }
            None => beside(path, uri)?,
        },
    };
    if bytes.len() < buffer.length() {
        return Err(format!("buffer {k} has {} bytes of the {} that are promised", bytes.len(), buffer.length()));
    }
    Ok(bytes)
}

/// A buffer in a file in the model's folder or below it.
fn beside(path: &Path, uri: &str) -> Said<Vec<u8>> {
    let name = percent_decoded(uri).ok_or_else(|| format!("the name of a buffer, \"{uri}\", is damaged"))?;
    let relative = Path::new(&name);
    if !files::stays_below(relative) {
        return Err(format!("the buffer \"{uri}\" is not in the model's folder"));
    }
    let file = path.parent().unwrap_or(Path::new(".")).join(relative);
    files::read(&file, MOST_BYTES).map_err(|e| format!("the buffer {} cannot be read: {e}", file.display()))
}

fn percent_decoded(uri: &str) -> Option<String> {
    let mut out = Vec::new();
    let mut rest = uri.as_bytes();
    while let Some((&b, after)) = rest.split_first() {
        if b == b'%' {
            let hex = std::str::from_utf8(after.get(..2)?).ok()?;
            out.push(u8::from_str_radix(hex, 16).ok()?);
            rest = &after[2..];
        } else {
            out.push(b);
            rest = after;
        }
    }
    String::from_utf8(out).ok()
}

/// RFC 4648, padded or not; white space is passed over.
fn base64(text: &str) -> Option<Vec<u8>> {
    let mut out = Vec::with_capacity(text.len() / 4 * 3);
    let (mut bits, mut have) = (0u32, 0);
    for b in text.bytes().filter(|b| !b.is_ascii_whitespace()) {
        let six = match b {
            b'A'..=b'Z' => b - b'A',
            b'a'..=b'z' => b - b'a' + 26,
            b'0'..=b'9' => b - b'0' + 52,
            b'+' => 62,
            b'/' => 63,
            b'=' => break,
            _ => return None,
        };
        bits = (bits << 6 | u32::from(six)) & 0x00ff_ffff;
        have += 6;
        if have >= 8 {
            have -= 8;
            out.push((bits >> have & 0xff) as u8);
        }
    }
    Some(out)
}

struct GltfScene {
    buffers: Vec<Vec<u8>>,
    soup: Soup,
    /// Nodes that were visited: each may have one parent.
    seen: Vec<bool>,
    other: usize,
    posed: bool,
}

impl GltfScene {
    fn node(&mut self, node: &Node, above: &Matrix4<f64>, depth: usize) -> Said<()> {
        let again = self.seen.get_mut(node.index()).is_none_or(|seen| std::mem::replace(seen, true));
        if again || depth > DEEPEST {
            return Err(format!("node {} is placed twice or inside itself", node.index()));
        }
        let own = node.transform().matrix();
        let to = above * Matrix4::from_fn(|r, c| f64::from(own[c][r]));
        if let Some(mesh) = node.mesh() {
            self.soup.begin_group(node.name().or(mesh.name()).unwrap_or(""));
            self.posed |= node.skin().is_some();
            for primitive in mesh.primitives() {
                self.posed |= primitive.morph_targets().next().is_some();
                self.primitive(&primitive, &to)?;
            }
        }
        for child in node.children() {
            self.node(&child, &to, depth + 1)?;
        }
        Ok(())
    }

    fn primitive(&mut self, primitive: &gltf::Primitive, to: &Matrix4<f64>) -> Said<()> {
        if !matches!(primitive.mode(), Mode::Triangles | Mode::TriangleStrip | Mode::TriangleFan) {
            self.other += 1;
            return Ok(());
        }
        let positions = primitive.get(&Semantic::Positions).ok_or("a primitive has no positions")?;
        if (positions.data_type(), positions.dimensions()) != (DataType::F32, Dimensions::Vec3) {
            return Err(format!("accessor {}: positions are not three floats", positions.index()));
        }
        let points: Vec<[f32; 3]> = self.elements(&positions)?;
        let points: Vec<[f64; 3]> =
            points.into_iter().map(|p| to.transform_point(&Point::from(p.map(f64::from))).coords.into()).collect();
        let corners: Vec<usize> = match primitive.indices() {
            Some(a) => self.indices(&a)?,
            None => (0..points.len()).collect(),
        };
        // A mirroring transform turns the winding.
        let mirrored = to.fixed_view::<3, 3>(0, 0).determinant() < 0.0;
        for t in triangles(primitive.mode(), &corners) {
            let corner = |k: usize| {
                points.get(k).copied().ok_or_else(|| format!("an index names vertex {k} of {}", points.len()))
            };
            let [a, b, c] = [corner(t[0])?, corner(t[1])?, corner(t[2])?];
            self.soup.push(if mirrored { [b, a, c] } else { [a, b, c] });
        }
        if self.soup.triangles.len() > MOST_TRIANGLES {
            return Err(format!("it places more than {MOST_TRIANGLES} triangles"));
        }
        Ok(())
    }

    fn indices(&self, a: &Accessor) -> Said<Vec<usize>> {
        if a.dimensions() != Dimensions::Scalar {
            return Err(format!("accessor {}: indices are not single numbers", a.index()));
        }
        Ok(match a.data_type() {
            DataType::U8 => self.elements::<u8>(a)?.into_iter().map(usize::from).collect(),
            DataType::U16 => self.elements::<u16>(a)?.into_iter().map(usize::from).collect(),
            DataType::U32 => self.elements::<u32>(a)?.into_iter().map(|i| i as usize).collect(),
            _ => return Err(format!("accessor {}: indices are not unsigned whole numbers", a.index())),
        })
    }

    /// All elements of an accessor, sparse ones replaced; lengths are held against the buffers
    /// before memory is taken.
    fn elements<T: Item + Clone>(&self, a: &Accessor) -> Said<Vec<T>> {
        let mut all = match a.view() {
            Some(view) => self.run(&view, a.offset(), a.count(), a.size(), a.index())?,
            // Zeros that take no room in the file, so the file's size does not bound them.
            None if a.count() <= MOST_TRIANGLES => vec![T::zero(); a.count()],
            None => return Err(format!("accessor {} has {} elements", a.index(), a.count())),
        };
        let Some(sparse) = a.sparse() else { return Ok(all) };
        let (i, v) = (sparse.indices(), sparse.values());
        let at = |size: usize| (i.view(), i.offset(), sparse.count(), size);
        let indices: Vec<usize> = match i.index_type() {
            gltf::accessor::sparse::IndexType::U8 => {
                let (view, offset, n, size) = at(1);
                self.run::<u8>(&view, offset, n, size, a.index())?.into_iter().map(usize::from).collect()
            }
            gltf::accessor::sparse::IndexType::U16 => {
                let (view, offset, n, size) = at(2);
                self.run::<u16>(&view, offset, n, size, a.index())?.into_iter().map(usize::from).collect()
            }
            gltf::accessor::sparse::IndexType::U32 => {
                let (view, offset, n, size) = at(4);
                self.run::<u32>(&view, offset, n, size, a.index())?.into_iter().map(|k| k as usize).collect()
            }
        };
        let values: Vec<T> = self.run(&v.view(), v.offset(), sparse.count(), a.size(), a.index())?;
        for (k, value) in indices.into_iter().zip(values) {
            *all.get_mut(k)
                .ok_or_else(|| format!("accessor {}: a sparse index is {k} of {}", a.index(), a.count()))? = value;
        }
        Ok(all)
    }

    /// `count` elements of `size` bytes in a view.
    fn run<T: Item>(
        &self,
        view: &buffer::View,
        offset: usize,
        count: usize,
        size: usize,
        accessor: usize,
    ) -> Said<Vec<T>> {
        let short = || format!("accessor {accessor} reaches beyond its buffer");
        let buffer = self.buffers.get(view.buffer().index()).ok_or_else(short)?;
        let end = view.offset().checked_add(view.length()).ok_or_else(short)?;
        let bytes = buffer.get(view.offset()..end).and_then(|b| b.get(offset..)).ok_or_else(short)?;
        let stride = view.stride().unwrap_or(size);
        if stride < size {
            return Err(format!("accessor {accessor}: elements of {size} bytes are {stride} apart"));
        }
        let last = count.checked_sub(1).and_then(|n| n.checked_mul(stride)).and_then(|n| n.checked_add(size));
        match last {
            Some(needed) if needed <= bytes.len() => {}
            None if count == 0 => return Ok(Vec::new()),
            _ => return Err(short()),
        }
        Ok((0..count).map(|k| T::from_slice(&bytes[k * stride..k * stride + size])).collect())
    }
}

/// Corners of the triangles that a list, strip or fan of vertices means.
fn triangles(mode: Mode, corners: &[usize]) -> Vec<[usize; 3]> {
    match mode {
        Mode::TriangleStrip => (corners.windows(3).enumerate())
            .map(|(k, t)| if k % 2 == 0 { [t[0], t[1], t[2]] } else { [t[1], t[0], t[2]] })
            .collect(),
        Mode::TriangleFan => corners[1.min(corners.len())..].windows(2).map(|t| [corners[0], t[0], t[1]]).collect(),
        _ => corners.chunks_exact(3).map(|t| [t[0], t[1], t[2]]).collect(),
    }
}
