//! STEP files written by hand: a bar and a round, with units, placements, seams, flipped flags and
//! damage.
#![allow(clippy::unwrap_used)]

use std::fmt::Write;
use std::path::Path;

use super::*;
use crate::error::ErrorKind;
use crate::geometry::brep::SurfaceKind;
use crate::observe::Silent;

/// Entities of a file as it is written.
#[derive(Default)]
pub(super) struct Sheet {
    lines: Vec<String>,
}

impl Sheet {
    pub(super) fn add(&mut self, text: impl AsRef<str>) -> usize {
        let id = self.lines.len() + 1;
        self.lines.push(format!("#{id}={};", text.as_ref()));
        id
    }
    pub(super) fn point(&mut self, p: [f64; 3]) -> usize {
        self.add(format!("CARTESIAN_POINT('',({:?},{:?},{:?}))", p[0], p[1], p[2]))
    }
    pub(super) fn direction(&mut self, p: [f64; 3]) -> usize {
        self.add(format!("DIRECTION('',({:?},{:?},{:?}))", p[0], p[1], p[2]))
    }
    pub(super) fn frame(&mut self, origin: [f64; 3], z: [f64; 3], x: [f64; 3]) -> usize {
        let (o, z, x) = (self.point(origin), self.direction(z), self.direction(x));
        self.add(format!("AXIS2_PLACEMENT_3D('',#{o},#{z},#{x})"))
    }
    pub(super) fn vertex(&mut self, p: [f64; 3]) -> usize {
        let p = self.point(p);
        self.add(format!("VERTEX_POINT('',#{p})"))
    }
    pub(super) fn line(&mut self, (a, va): ([f64; 3], usize), (b, vb): ([f64; 3], usize)) -> usize {
        let d = self.direction([b[0] - a[0], b[1] - a[1], b[2] - a[2]]);
        let (v, p) = (self.add(format!("VECTOR('',#{d},1.0)")), self.point(a));
        let line = self.add(format!("LINE('',#{p},#{v})"));
        self.add(format!("EDGE_CURVE('',#{va},#{vb},#{line},.T.)"))
    }
    /// A face from a surface, its sense, and one loop of (edge, forward).
    pub(super) fn face(&mut self, surface: usize, sense: bool, edges: &[(usize, bool)]) -> usize {
        let flag = |b: bool| if b { ".T." } else { ".F." };
        let oriented: Vec<String> = edges
            .iter()
            .map(|&(e, forward)| format!("#{}", self.add(format!("ORIENTED_EDGE('',*,*,#{e},{})", flag(forward)))))
            .collect();
        let ring = self.add(format!("EDGE_LOOP('',({}))", oriented.join(",")));
        let bound = self.add(format!("FACE_OUTER_BOUND('',#{ring},.T.)"));
        self.add(format!("ADVANCED_FACE('',(#{bound}),#{surface},{})", flag(sense)))
    }
    pub(super) fn list(ids: &[usize]) -> String {
        ids.iter().map(|i| format!("#{i}")).collect::<Vec<_>>().join(",")
    }
    /// The file: these entities, a unit, and a product that owns the items.
    pub(super) fn file(mut self, unit: &str, items: &[usize]) -> String {
        let context = self.context(unit);
        self.product("part", context, items);
        self.text()
    }
    pub(super) fn context(&mut self, unit: &str) -> usize {
        let length = match unit {
            "inch" => {
                let mm = self.add("(LENGTH_UNIT()NAMED_UNIT(*)SI_UNIT(.MILLI.,.METRE.))");
                let measure = self.add(format!("LENGTH_MEASURE_WITH_UNIT(LENGTH_MEASURE(25.4),#{mm})"));
                let dim = self.add("DIMENSIONAL_EXPONENTS(1.,0.,0.,0.,0.,0.,0.)");
                self.add(format!("(CONVERSION_BASED_UNIT('INCH',#{measure})LENGTH_UNIT()NAMED_UNIT(#{dim}))"))
            }
            "m" => self.add("(LENGTH_UNIT()NAMED_UNIT(*)SI_UNIT($,.METRE.))"),
            _ => self.add("(LENGTH_UNIT()NAMED_UNIT(*)SI_UNIT(.MILLI.,.METRE.))"),
        };
        let angle = self.add("(NAMED_UNIT(*)PLANE_ANGLE_UNIT()SI_UNIT($,.RADIAN.))");
        let solid = self.add("(NAMED_UNIT(*)SI_UNIT($,.STERADIAN.)SOLID_ANGLE_UNIT())");
        let near = self.add(format!("UNCERTAINTY_MEASURE_WITH_UNIT(LENGTH_MEASURE(1.E-06),#{length},'d','')"));
        self.add(format!(
            "(GEOMETRIC_REPRESENTATION_CONTEXT(3)GLOBAL_UNCERTAINTY_ASSIGNED_CONTEXT((#{near}))\
             GLOBAL_UNIT_ASSIGNED_CONTEXT((#{length},#{angle},#{solid}))REPRESENTATION_CONTEXT('',''))"
        ))
    }
    /// A product whose shape is these items: (definition, representation).
    pub(super) fn product(&mut self, name: &str, context: usize, items: &[usize]) -> (usize, usize) {
        let app = self.add("APPLICATION_CONTEXT('automotive design')");
        let pc = self.add(format!("PRODUCT_CONTEXT('',#{app},'mechanical')"));
        let product = self.add(format!("PRODUCT('{name}','{name}','',(#{pc}))"));
        let formation = self.add(format!("PRODUCT_DEFINITION_FORMATION('','',#{product})"));
        let pdc = self.add(format!("PRODUCT_DEFINITION_CONTEXT('part definition',#{app},'design')"));
        let definition = self.add(format!("PRODUCT_DEFINITION('design','',#{formation},#{pdc})"));
        let shape = self.add(format!("PRODUCT_DEFINITION_SHAPE('','',#{definition})"));
        let rep = self.add(format!("ADVANCED_BREP_SHAPE_REPRESENTATION('',({}),#{context})", Self::list(items)));
        self.add(format!("SHAPE_DEFINITION_REPRESENTATION(#{shape},#{rep})"));
        (definition, rep)
    }
    pub(super) fn text(&self) -> String {
        let mut out = String::from(
            "ISO-10303-21;\nHEADER;\nFILE_DESCRIPTION((''),'2;1');\nFILE_NAME('','',(''),(''),'','','');\n\
             FILE_SCHEMA(('AUTOMOTIVE_DESIGN { 1 0 10303 214 1 1 1 1 }'));\nENDSEC;\nDATA;\n",
        );
        for line in &self.lines {
            writeln!(out, "{line}").unwrap();
        }
        out.push_str("ENDSEC;\nEND-ISO-10303-21;\n");
        out
    }
    pub(super) fn solid(&mut self, faces: &[usize]) -> usize {
        let shell = self.add(format!("CLOSED_SHELL('',({}))", Self::list(faces)));
        self.add(format!("MANIFOLD_SOLID_BREP('body',#{shell})"))
    }

    /// Faces of a bar of size 10 × 4 × 60 from the origin; `sense` says for each whether its plane
    /// faces outward.
    pub(super) fn bar(&mut self, sense: [bool; 6]) -> Vec<usize> {
        let size = [10.0, 4.0, 60.0];
        let corners: Vec<([f64; 3], usize)> = (0..8)
            .map(|k| {
                let p = [0, 1, 2].map(|d| if k >> d & 1 == 1 { size[d] } else { 0.0 });
                (p, self.vertex(p))
            })
            .collect();
        let mut edges = std::collections::BTreeMap::new();
        for k in 0..8usize {
            for d in 0..3 {
                if k >> d & 1 == 0 {
                    let to = k | 1 << d;
                    edges.insert((k, to), self.line(corners[k], corners[to]));
                }
            }
        }
        // Corners counter-clockwise seen from outside, and the outward normal.
        let sides: [([usize; 4], [f64; 3]); 6] = [
            ([0, 2, 3, 1], [0., 0., -1.]),
            ([4, 5, 7, 6], [0., 0., 1.]),
            ([0, 1, 5, 4], [0., -1., 0.]),
            ([2, 6, 7, 3], [0., 1., 0.]),
            ([0, 4, 6, 2], [-1., 0., 0.]),
            ([1, 3, 7, 5], [1., 0., 0.]),
        ];
        sides
            .iter()
            .zip(sense)
            .map(|((ring, n), outward)| {
                let z = if outward { *n } else { n.map(|x| -x) };
                let x = if n[0] == 0.0 { [1., 0., 0.] } else { [0., 1., 0.] };
                let frame = self.frame(corners[ring[0]].0, z, x);
                let plane = self.add(format!("PLANE('',#{frame})"));
                let walk: Vec<(usize, bool)> = (0..4)
                    .map(|k| {
                        let (a, b) = (ring[k], ring[(k + 1) % 4]);
                        (edges[&(a.min(b), a.max(b))], a < b)
                    })
                    .collect();
                self.face(plane, outward, &walk)
            })
            .collect()
    }

    /// Faces of a round of radius 3 and height 60 whose seam lies at `angle`, circles running with
    /// or against the edge.
    pub(super) fn round(&mut self, angle: f64, same_sense: bool) -> Vec<usize> {
        let (c, s) = (3.0 * angle.cos(), 3.0 * angle.sin());
        let ends = [0.0, 60.0].map(|z| ([c, s, z], self.vertex([c, s, z])));
        let circles = [0.0, 60.0].map(|z| {
            // Against: the circle's own axis points down, so that the edge still runs
            // counter-clockwise seen from above.
            let axis = if same_sense { 1.0 } else { -1.0 };
            let frame = self.frame([0., 0., z], [0., 0., axis], [1., 0., 0.]);
            self.add(format!("CIRCLE('',#{frame},3.0)"))
        });
        let flag = if same_sense { ".T." } else { ".F." };
        let rings: Vec<usize> = (0..2)
            .map(|k| {
                let v = ends[k].1;
                self.add(format!("EDGE_CURVE('',#{v},#{v},#{},{flag})", circles[k]))
            })
            .collect();
        let seam = self.line(ends[0], ends[1]);
        let frame = self.frame([0., 0., 0.], [0., 0., 1.], [1., 0., 0.]);
        let cylinder = self.add(format!("CYLINDRICAL_SURFACE('',#{frame},3.0)"));
        let (down, up) =
            (self.frame([0.; 3], [0., 0., -1.], [1., 0., 0.]), self.frame([0., 0., 60.], [0., 0., 1.], [1., 0., 0.]));
        let planes = [down, up].map(|f| self.add(format!("PLANE('',#{f})")));
        vec![
            self.face(cylinder, true, &[(rings[0], true), (seam, true), (rings[1], false), (seam, false)]),
            self.face(planes[0], true, &[(rings[0], false)]),
            self.face(planes[1], true, &[(rings[1], true)]),
        ]
    }
}

fn bar_file(unit: &str) -> String {
    let mut sheet = Sheet::default();
    let faces = sheet.bar([true, false, true, false, true, false]);
    let solid = sheet.solid(&faces);
    sheet.file(unit, &[solid])
}

fn shape(text: &str) -> Result<faces::FaceModel> {
    step::read(Path::new("test.step"), text.as_bytes(), None)
}

fn load_text(text: &str, unit: Option<Unit>) -> Result<Blade> {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("test.step");
    std::fs::write(&path, text).unwrap();
    load(&path, &ModelOptions { unit, axis: Some([0.0, 0.0, 1.0]), ..ModelOptions::default() }, &Silent)
}

fn refused(text: &str, words: &[&str]) {
    let error = load_text(text, None).err().unwrap_or_else(|| panic!("accepted, though expected {words:?}"));
    assert_eq!(error.kind, ErrorKind::InputOutput, "{error}");
    for word in words {
        assert!(error.to_string().contains(word), "\"{word}\" is not in \"{error}\"");
    }
}

#[test]
fn a_bar_shares_its_edges() {
    let s = shape(&bar_file("mm")).unwrap();
    assert_eq!((s.brep.faces.len(), s.brep.edges.len(), s.bodies), (6, 12, 1));
    assert_eq!(s.format, "STEP AP214");
    for (i, f) in s.brep.faces.iter().enumerate() {
        assert_eq!(f.kind, SurfaceKind::Plane);
        // Whichever way the plane faced in the file, the part's normal is outward.
        let [[u0, u1], [v0, v1]] = f.surface.domain();
        let (u, v) = (0.5 * (u0 + u1), 0.5 * (v0 + v1));
        let n = f.surface.normal(u, v).unwrap() * if f.reversed { -1.0 } else { 1.0 };
        let out = f.surface.point(u, v) - crate::geometry::Point::new(5.0, 2.0, 30.0);
        assert!(n.dot(&out) > 0.0, "face {i}");
        // Loops run on continuously.
        for k in 0..4 {
            let (c, d) = (f.loops[0][k], f.loops[0][(k + 1) % 4]);
            let (e, g) = (&s.brep.edges[c.edge], &s.brep.edges[d.edge]);
            let (end, start) =
                (e.curve.point(e.t[usize::from(!c.reversed)]), g.curve.point(g.t[usize::from(d.reversed)]));
            assert!((end - start).norm() < 1e-9);
        }
    }
}

#[test]
fn a_bar_loads_in_any_unit() {
    for (unit, told, mm) in
        [("mm", None, 1.0_f64), ("inch", None, 25.4), ("m", Some(Unit::Cm), 10.0), ("mm", Some(Unit::M), 1000.0)]
    {
        let b = load_text(&bar_file(unit), told);
        if mm * 60.0 > 5000.0 {
            // 60 m: read, with a warning.
            assert!(b.unwrap().diagnosis.notes.iter().any(|n| n.to_string().contains("too large")));
            continue;
        }
        let b = b.unwrap();
        assert!((b.part.mesh.volume_mm3() / (2400.0 * mm.powi(3)) - 1.0).abs() < 1e-9, "{unit}");
        assert!(b.diagnosis.closed && b.part.brep.is_some());
        assert_eq!(b.diagnosis.faces, vec![("plane".to_owned(), 6)]);
        assert!((b.regions.airfoil_x_mm()[1] - 60.0 * mm).abs() < 1e-6, "{:?}", b.regions);
    }
}

#[test]
fn a_round_with_its_seam_anywhere() {
    for (angle, sense) in [(0.0, true), (1.0, true), (4.0, false), (0.0, false)] {
        let mut sheet = Sheet::default();
        let faces = sheet.round(angle, sense);
        let solid = sheet.solid(&faces);
        let b = load_text(&sheet.file("mm", &[solid]), None).unwrap();
        let volume = std::f64::consts::PI * 9.0 * 60.0;
        assert!(b.diagnosis.closed, "{angle} {sense}");
        assert!(
            (b.part.mesh.volume_mm3() / volume - 1.0).abs() < 0.01,
            "{angle} {sense}: {}",
            b.part.mesh.volume_mm3()
        );
    }
}

#[test]
fn assemblies_place_their_parts() {
    let mut sheet = Sheet::default();
    let faces = sheet.bar([true; 6]);
    let solid = sheet.solid(&faces);
    let context = sheet.context("mm");
    let (part, part_rep) = sheet.product("bar", context, &[solid]);
    // Turned by a quarter about z and shifted.
    let from = sheet.frame([0.; 3], [0., 0., 1.], [1., 0., 0.]);
    let to = sheet.frame([100., 0., 7.], [0., 0., 1.], [0., 1., 0.]);
    let (whole, whole_rep) = sheet.product("assembly", context, &[to]);
    let usage = sheet.add(format!("NEXT_ASSEMBLY_USAGE_OCCURRENCE('1','','',#{whole},#{part},$)"));
    let usage_shape = sheet.add(format!("PRODUCT_DEFINITION_SHAPE('','',#{usage})"));
    let transform = sheet.add(format!("ITEM_DEFINED_TRANSFORMATION('','',#{from},#{to})"));
    let relation = sheet.add(format!(
        "(REPRESENTATION_RELATIONSHIP('','',#{part_rep},#{whole_rep})\
         REPRESENTATION_RELATIONSHIP_WITH_TRANSFORMATION(#{transform})SHAPE_REPRESENTATION_RELATIONSHIP())"
    ));
    sheet.add(format!("CONTEXT_DEPENDENT_SHAPE_REPRESENTATION(#{relation},#{usage_shape})"));
    let s = shape(&sheet.text()).unwrap();
    assert_eq!((s.bodies, s.brep.faces.len()), (1, 6));
    let corners: Vec<crate::geometry::Point> =
        s.brep.edges.iter().flat_map(|e| e.t.map(|t| e.curve.point(t))).collect();
    let b = crate::geometry::Aabb::around(&corners).unwrap();
    // (x, y, z) -> (100 - y, x, z + 7)
    assert!((b.min - crate::geometry::Point::new(96.0, 0.0, 7.0)).norm() < 1e-9, "{b:?}");
    assert!((b.max - crate::geometry::Point::new(100.0, 10.0, 67.0)).norm() < 1e-9, "{b:?}");
}

#[test]
fn faces_without_shared_edges_are_sewn() {
    let mut sheet = Sheet::default();
    // Each face from a bar of its own: no two share an edge.
    let faces: Vec<usize> = (0..6).map(|k| sheet.bar([true; 6])[k]).collect();
    let shell = sheet.add(format!("OPEN_SHELL('',({}))", Sheet::list(&faces)));
    let model = sheet.add(format!("SHELL_BASED_SURFACE_MODEL('',(#{shell}))"));
    let mut s = shape(&sheet.file("mm", &[model])).unwrap();
    assert!(s.brep.faces.len() >= 6);
    // The other faces of the bars are loose; what counts is that every coinciding pair of single
    // edges is joined.
    s.brep.faces.truncate(6);
    let sewn = sew::sew(&mut s.brep, &[1e-3]);
    assert_eq!((sewn.joined, sewn.open, s.brep.edges.len()), (12, 0, 12));
}

#[test]
fn bad_step_files_are_refused_with_a_sentence() {
    let good = bar_file("mm");
    refused("ISO-10303-21;\n", &["cannot be read as STEP"]);
    refused(&good[..good.len() / 2], &["STEP"]);
    // A header and units, but no body.
    let mut sheet = Sheet::default();
    let context = sheet.context("mm");
    let frame = sheet.frame([0.; 3], [0., 0., 1.], [1., 0., 0.]);
    sheet.product("nothing", context, &[frame]);
    refused(&sheet.text(), &["no solid, shell or face"]);
    // One face lost because its plane refers to nothing.
    let damaged = good.replacen("PLANE('',#", "PLANE('',#9999", 1);
    refused(&damaged, &["1 of 6 faces", "cannot be read"]);
    // Five faces of six: open.
    let mut sheet = Sheet::default();
    let mut faces = sheet.bar([true; 6]);
    let lid = faces.pop().unwrap();
    sheet.lines[lid - 1] = format!("#{lid}=CARTESIAN_POINT('',(0.,0.,0.));");
    let shell = sheet.add(format!("OPEN_SHELL('',({}))", Sheet::list(&faces)));
    let model = sheet.add(format!("SHELL_BASED_SURFACE_MODEL('',(#{shell}))"));
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("open.step");
    std::fs::write(&path, sheet.file("mm", &[model])).unwrap();
    let text = inspect_text(&survey(&path, &ModelOptions::default(), &Silent).unwrap());
    assert!(text.contains("in 1 opening") && text.contains("none, since the part is open"), "{text}");
    // Coordinates out of all bounds.
    refused(&good.replace("60.0", "1.0E400"), &["test.step", "line", "out of range"]);
    refused(&good.replace("60.0", "1.0E300"), &["test.step", "face"]);
}

/// Every control point of a surface that is read is a number that one can reckon with: sums of
/// squares of others overflow, and what is not a number is neither inside nor outside.
#[test]
fn control_points_out_of_all_bounds_are_refused() {
    let file = concat!(env!("CARGO_MANIFEST_DIR"), "/models/compressor_twist.step");
    let text = std::fs::read_to_string(file).unwrap();
    // A control point of the first side.
    let line = text.lines().find(|l| l.starts_with("#300 = CARTESIAN_POINT")).unwrap();
    for (x, words) in [
        ("1.E306", ["face 1", "control point 218"]),
        ("-1.E200", ["face 1", "control point 218"]),
        ("1.E60", ["face 1", "out of all bounds"]),
        ("1.E999", ["cannot be read", "out of range"]),
    ] {
        let bad = text.replacen(line, &format!("#300 = CARTESIAN_POINT('',({x},0.,0.));"), 1);
        let e = load_text(&bad, Some(Unit::M)).err().unwrap().to_string();
        assert!(words.iter().all(|w| e.contains(w)), "{x}: {e}");
    }
}

/// A blade of many metres: its mesh would fill the memory.
#[test]
fn faces_are_meshed_no_finer_than_their_size_asks() {
    let file = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("models/prism.step");
    let coarse =
        |survey: &Survey| survey.diagnosis.notes.iter().any(|n| n.to_string().starts_with("faces are meshed within"));
    let large = survey(
        &file,
        &ModelOptions { unit: Some(crate::artifact::blade::Unit::M), ..ModelOptions::default() },
        &Silent,
    )
    .unwrap();
    assert!(coarse(&large) && large.deflection_mm > 0.05, "{:?}", large.diagnosis.notes);
    let small = survey(&file, &ModelOptions::default(), &Silent).unwrap();
    assert!(!coarse(&small) && small.deflection_mm == 0.01);
}
