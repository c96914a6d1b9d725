//! Buffers, accessors and the binary container (glTF 2.0 specification, "GLB File Format").

use std::collections::BTreeMap;

use gltf_json as json;
use json::accessor::{Accessor, ComponentType, GenericComponentType, Type};
use json::buffer::{Buffer, Target, View};
use json::extensions::mesh::Mapping;
use json::extensions::scene::khr_materials_variants::Variant;
use json::image::{Image, MimeType};
use json::material::{AlphaMode, Material, PbrBaseColorFactor, PbrMetallicRoughness, StrengthFactor};
use json::mesh::{Mesh, Mode, Primitive, Semantic};
use json::scene::{Node, Scene};
use json::texture::{Info, MagFilter, MinFilter, Sampler, Texture, WrappingMode};
use json::validation::{Checked, USize64};
use json::{Animation, Index, Root};
use serde_json::json;

use crate::error::{Error, Result, Stage};

/// A scene being built.
#[derive(Default)]
pub(super) struct Glb {
    root: Root,
    bytes: Vec<u8>,
    /// As [`super::GltfOptions::rounded`].
    rounded: bool,
}

/// Part of the greatest size of a coordinate that points are rounded to; of 1 for normals.
const POINT_STEP: f32 = 1.0 / 32_768.0;
const NORMAL_STEP: f32 = 1.0 / 512.0;

/// Rows with their numbers rounded to steps.
fn to_steps(rows: &[[f32; 3]], step: f32) -> Vec<[f32; 3]> {
    rows.iter().map(|row| row.map(|v| (v / step).round() * step)).collect()
}

impl Glb {
    pub(super) fn new(rounded: bool) -> Self {
        Glb { rounded, ..Glb::default() }
    }

    /// Appends bytes as a view, aligned to 4 bytes.
    fn view(&mut self, bytes: &[u8], target: Option<Target>) -> Index<View> {
        while !self.bytes.len().is_multiple_of(4) {
            self.bytes.push(0);
        }
        let byte_offset = self.bytes.len();
        self.bytes.extend_from_slice(bytes);
        self.root.push(View {
            buffer: Index::new(0),
            byte_length: USize64::from(bytes.len()),
            byte_offset: Some(USize64::from(byte_offset)),
            byte_stride: None,
            name: None,
            target: target.map(Checked::Valid),
            extensions: None,
            extras: None,
        })
    }

    fn accessor(&mut self, view: Index<View>, count: usize, component: ComponentType, type_: Type) -> Index<Accessor> {
        self.root.push(Accessor {
            buffer_view: Some(view),
            byte_offset: None,
            count: USize64::from(count),
            component_type: Checked::Valid(GenericComponentType(component)),
            extensions: None,
            extras: None,
            type_: Checked::Valid(type_),
            min: None,
            max: None,
            name: None,
            normalized: false,
            sparse: None,
        })
    }

    /// Floating-point rows of `N` (1, 3 or 4) numbers. `bounds`: write least and greatest values
    /// (positions, times).
    fn floats<const N: usize>(
        &mut self,
        rows: &[[f32; N]],
        target: Option<Target>,
        type_: Type,
        bounds: bool,
    ) -> Index<Accessor> {
        let bytes: Vec<u8> = rows.iter().flatten().flat_map(|v| v.to_le_bytes()).collect();
        let view = self.view(&bytes, target);
        let index = self.accessor(view, rows.len(), ComponentType::F32, type_);
        if bounds && let Some(a) = self.root.accessors.get_mut(index.value()) {
            let fold = |f: fn(f32, f32) -> f32, start: f32| {
                let mut b = [start; N];
                for row in rows {
                    b.iter_mut().zip(row).for_each(|(b, v)| *b = f(*b, *v));
                }
                Some(json!(b.to_vec()))
            };
            a.min = fold(f32::min, f32::INFINITY);
            a.max = fold(f32::max, f32::NEG_INFINITY);
        }
        index
    }

    /// Vertex positions.
    pub(super) fn positions(&mut self, rows: &[[f32; 3]]) -> Index<Accessor> {
        if self.rounded {
            let most = rows.iter().flatten().fold(0.0f32, |most, v| most.max(v.abs()));
            // A power of two, so that the lower bits of all numbers are 0; not above the bound.
            let step = (most * POINT_STEP).log2().floor().exp2();
            if step > 0.0 && step.is_finite() {
                return self.floats(&to_steps(rows, step), Some(Target::ArrayBuffer), Type::Vec3, true);
            }
        }
        self.floats(rows, Some(Target::ArrayBuffer), Type::Vec3, true)
    }
    /// Unit normals.
    pub(super) fn normals(&mut self, rows: &[[f32; 3]]) -> Index<Accessor> {
        if self.rounded {
            return self.floats(&to_steps(rows, NORMAL_STEP), Some(Target::ArrayBuffer), Type::Vec3, false);
        }
        self.floats(rows, Some(Target::ArrayBuffer), Type::Vec3, false)
    }
    /// Key times of an animation, s.
    pub(super) fn times(&mut self, t: &[f32]) -> Index<Accessor> {
        let rows: Vec<[f32; 1]> = t.iter().map(|t| [*t]).collect();
        self.floats(&rows, None, Type::Scalar, true)
    }
    /// Translations of an animation.
    pub(super) fn translations(&mut self, rows: &[[f32; 3]]) -> Index<Accessor> {
        self.floats(rows, None, Type::Vec3, false)
    }
    /// Rotations of an animation, quaternions `(x, y, z, w)`.
    pub(super) fn rotations(&mut self, rows: &[[f32; 4]]) -> Index<Accessor> {
        self.floats(rows, None, Type::Vec4, false)
    }
    /// Vertex indices.
    pub(super) fn indices(&mut self, indices: &[u32]) -> Index<Accessor> {
        let bytes: Vec<u8> = indices.iter().flat_map(|i| i.to_le_bytes()).collect();
        let view = self.view(&bytes, Some(Target::ElementArrayBuffer));
        self.accessor(view, indices.len(), ComponentType::U32, Type::Scalar)
    }

    /// A material with a linear base colour; `lit` materials look like dull metal, others are drawn
    /// as they are.
    pub(super) fn material(&mut self, name: &str, rgb: [f32; 3], lit: bool) -> Index<Material> {
        self.root.push(Material {
            name: Some(name.into()),
            double_sided: lit,
            pbr_metallic_roughness: PbrMetallicRoughness {
                base_color_factor: PbrBaseColorFactor([rgb[0], rgb[1], rgb[2], 1.0]),
                metallic_factor: StrengthFactor(if lit { 0.3 } else { 0.0 }),
                roughness_factor: StrengthFactor(0.6),
                ..PbrMetallicRoughness::default()
            },
            extensions: (!lit)
                .then_some(json::extensions::material::Material { unlit: Some(json::extensions::material::Unlit {}) }),
            ..Material::default()
        })
    }

    /// A see-through material, drawn as it is.
    pub(super) fn glass(&mut self, name: &str, rgb: [f32; 3], opacity: f32) -> Index<Material> {
        let index = self.material(name, rgb, false);
        if let Some(m) = self.root.materials.get_mut(index.value()) {
            m.alpha_mode = Checked::Valid(AlphaMode::Blend);
            m.double_sided = true;
            m.pbr_metallic_roughness.base_color_factor = PbrBaseColorFactor([rgb[0], rgb[1], rgb[2], opacity]);
        }
        index
    }

    /// Makes a material see-through, lit as it was.
    pub(super) fn see_through(&mut self, material: Index<Material>, opacity: f32) {
        if let Some(m) = self.root.materials.get_mut(material.value()) {
            m.alpha_mode = Checked::Valid(AlphaMode::Blend);
            m.pbr_metallic_roughness.base_color_factor.0[3] = opacity;
        }
    }

    /// A texture of one row or column of pixels, as they are, from a PNG file.
    pub(super) fn texture(&mut self, name: &str, png: &[u8]) -> Index<Texture> {
        let view = self.view(png, None);
        let source = self.root.push(Image {
            buffer_view: Some(view),
            mime_type: Some(MimeType("image/png".into())),
            name: Some(name.into()),
            uri: None,
            extensions: None,
            extras: None,
        });
        let sampler = self.root.push(Sampler {
            mag_filter: Some(Checked::Valid(MagFilter::Nearest)),
            min_filter: Some(Checked::Valid(MinFilter::Nearest)),
            wrap_s: Checked::Valid(WrappingMode::ClampToEdge),
            wrap_t: Checked::Valid(WrappingMode::ClampToEdge),
            ..Sampler::default()
        });
        self.root.push(Texture {
            name: Some(name.into()),
            sampler: Some(sampler),
            source,
            extensions: None,
            extras: None,
        })
    }

    /// A material that takes its colour from a texture at the coordinates of a set, drawn as it is.
    pub(super) fn textured(&mut self, name: &str, texture: Index<Texture>, set: u32) -> Index<Material> {
        let index = self.material(name, [1.0; 3], false);
        if let Some(m) = self.root.materials.get_mut(index.value()) {
            m.double_sided = true;
            m.pbr_metallic_roughness.base_color_texture =
                Some(Info { index: texture, tex_coord: set, extensions: None, extras: None });
        }
        index
    }

    /// Texture coordinates, 0 to 1, to a 65 535th.
    pub(super) fn coordinates(&mut self, rows: &[[f32; 2]]) -> Index<Accessor> {
        let whole = |v: &f32| (v.clamp(0.0, 1.0) * 65_535.0).round() as u16;
        let bytes: Vec<u8> = rows.iter().flatten().flat_map(|v| whole(v).to_le_bytes()).collect();
        let view = self.view(&bytes, Some(Target::ArrayBuffer));
        let index = self.accessor(view, rows.len(), ComponentType::U16, Type::Vec2);
        if let Some(a) = self.root.accessors.get_mut(index.value()) {
            a.normalized = true;
        }
        index
    }

    /// Names of the variants that primitives may map their material to.
    pub(super) fn variants(&mut self, names: &[String]) {
        let variants = names.iter().map(|name| Variant { name: name.clone() }).collect();
        let list = json::extensions::root::KhrMaterialsVariants { variants };
        self.root.extensions.get_or_insert_default().khr_materials_variants = Some(list);
        self.root.extensions_used.push("KHR_materials_variants".into());
    }

    /// The materials of a primitive by variant: what it shows where none of them is chosen, and
    /// where viewers know no variants, is `material`.
    pub(super) fn by_variant(primitive: &mut Primitive, material: Index<Material>, by: &[(u32, Index<Material>)]) {
        let mapping = |(variant, material): &(u32, Index<Material>)| Mapping {
            material: u32::try_from(material.value()).unwrap_or(0),
            variants: vec![*variant],
        };
        let found = json::extensions::mesh::KhrMaterialsVariants { mappings: by.iter().map(mapping).collect() };
        primitive.extensions = Some(json::extensions::mesh::Primitive { khr_materials_variants: Some(found) });
        primitive.material = Some(material);
    }

    /// Meshes of these names are seen only where the last variant is chosen; without variants
    /// always.
    pub(super) fn only_in_last_variant(&mut self, names: &[&str]) {
        let variants = self.root.extensions.as_ref().and_then(|e| e.khr_materials_variants.as_ref());
        let last = variants.and_then(|v| u32::try_from(v.variants.len()).ok()?.checked_sub(1));
        let Some(variant) = last else { return };
        let unseen = self.material("unseen", [1.0; 3], false);
        if let Some(m) = self.root.materials.get_mut(unseen.value()) {
            // Not a mask: viewers draw lines with a mask as if there were none.
            m.alpha_mode = Checked::Valid(AlphaMode::Blend);
            m.pbr_metallic_roughness.base_color_factor = PbrBaseColorFactor([1.0, 1.0, 1.0, 0.0]);
        }
        let chosen = self.root.meshes.iter_mut().filter(|m| m.name.as_deref().is_some_and(|n| names.contains(&n)));
        for primitive in chosen.flat_map(|m| &mut m.primitives) {
            if let Some(seen) = primitive.material {
                Self::by_variant(primitive, unseen, &[(variant, seen)]);
            }
        }
    }

    /// A primitive of a mesh.
    pub(super) fn primitive(
        attributes: impl IntoIterator<Item = (Semantic, Index<Accessor>)>,
        indices: Option<Index<Accessor>>,
        material: Index<Material>,
        mode: Mode,
    ) -> Primitive {
        let attributes: BTreeMap<_, _> = attributes.into_iter().map(|(s, a)| (Checked::Valid(s), a)).collect();
        Primitive {
            attributes,
            extensions: None,
            extras: None,
            indices,
            material: Some(material),
            mode: Checked::Valid(mode),
            targets: None,
        }
    }

    /// A mesh.
    pub(super) fn mesh(&mut self, name: &str, primitives: Vec<Primitive>) -> Index<Mesh> {
        self.root.push(Mesh { extensions: None, extras: None, name: Some(name.into()), primitives, weights: None })
    }

    /// A node.
    pub(super) fn node(&mut self, node: Node) -> Index<Node> {
        self.root.push(node)
    }

    /// Puts a node where it is at rest.
    pub(super) fn place(&mut self, node: Index<Node>, at: [f32; 3], turned: [f32; 4]) {
        if let Some(node) = self.root.nodes.get_mut(node.value()) {
            node.translation = Some(at);
            node.rotation = Some(json::scene::UnitQuaternion(turned));
        }
    }

    /// The file.
    pub(super) fn finish(mut self, root_node: Index<Node>, animations: Vec<Animation>) -> Result<Vec<u8>> {
        pad(&mut self.bytes, 0);
        if !self.bytes.is_empty() {
            self.root.buffers.push(Buffer {
                byte_length: USize64::from(self.bytes.len()),
                name: None,
                uri: None,
                extensions: None,
                extras: None,
            });
        }
        let scene = self.root.push(Scene {
            extensions: None,
            extras: None,
            name: Some("bladewright preview".into()),
            nodes: vec![root_node],
        });
        self.root.scene = Some(scene);
        self.root.animations = animations;
        self.root.asset.generator = Some(concat!("bladewright ", env!("CARGO_PKG_VERSION")).into());
        if self.root.materials.iter().any(|m| m.extensions.is_some()) {
            self.root.extensions_used.push("KHR_materials_unlit".into());
        }
        let mut text = self
            .root
            .to_vec()
            .map_err(|e| Error::io(Stage::Preview, format!("the scene cannot be encoded: {e}")).caused_by(e))?;
        pad(&mut text, b' ');
        container(&text, &self.bytes)
    }
}

fn pad(bytes: &mut Vec<u8>, with: u8) {
    while !bytes.len().is_multiple_of(4) {
        bytes.push(with);
    }
}

/// Header, JSON chunk, binary chunk.
fn container(text: &[u8], binary: &[u8]) -> Result<Vec<u8>> {
    let length = |n: usize| {
        u32::try_from(n).map_err(|e| Error::io(Stage::Preview, "the scene is larger than 4 GiB").caused_by(e))
    };
    let chunks = if binary.is_empty() { 8 } else { 16 };
    let mut out = Vec::with_capacity(12 + chunks + text.len() + binary.len());
    out.extend_from_slice(b"glTF");
    out.extend_from_slice(&2u32.to_le_bytes());
    out.extend_from_slice(&length(12 + chunks + text.len() + binary.len())?.to_le_bytes());
    out.extend_from_slice(&length(text.len())?.to_le_bytes());
    out.extend_from_slice(b"JSON");
    out.extend_from_slice(text);
    if !binary.is_empty() {
        out.extend_from_slice(&length(binary.len())?.to_le_bytes());
        out.extend_from_slice(b"BIN\0");
        out.extend_from_slice(binary);
    }
    Ok(out)
}
