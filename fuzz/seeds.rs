//! Small models in every format, to be damaged: a block with a slender prism on it as mesh and as
//! faces, a twisted blade as tables of sections. Used by `examples/fuzz_readers.rs` and by the
//! short form in the test suite.

use base64::Engine as _;
use base64::engine::general_purpose::STANDARD;

/// All seeds, named so that each is read as what it is. The header among them names `table.dat`,
/// whose text is [`table`]'s.
pub fn all() -> Vec<(&'static str, Vec<u8>)> {
    vec![
        ("ascii.stl", ascii_stl()),
        ("binary.stl", binary_stl()),
        ("a.obj", obj()),
        ("ascii.ply", ply()),
        ("binary.ply", binary_ply()),
        ("a.gltf", gltf(false)),
        ("a.glb", gltf(true)),
        ("a.igs", iges()),
        ("a.step", step()),
        ("columns.dat", [b"+++\n", HEADER.as_bytes(), b"+++\n", &table()].concat()),
        ("header.toml", header("table.dat")),
        ("a.curve", curves()),
        ("tecplot.dat", tecplot()),
        ("blade3d.dat", blade3d()),
    ]
}

/// Corners of both boxes: the low one wide, the high one slender.
const BOXES: [([f64; 2], [f64; 2]); 2] = [([20.0, 10.0], [0.0, 10.0]), ([12.0, 1.5], [10.0, 60.0])];
/// Sides of a box, counter-clockwise seen from outside; the bits of a corner's number choose among
/// its ends.
const SIDES: [[usize; 4]; 6] = [[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]];

/// Corners of all sides of both boxes.
fn sides() -> Vec<[[f64; 3]; 4]> {
    let side = |(half, z): ([f64; 2], [f64; 2]), q: [usize; 4]| {
        let s = |bit: usize| if bit == 0 { -1.0 } else { 1.0 };
        q.map(|i| [half[0] * s(i & 1), half[1] * s(i >> 1 & 1), z[i >> 2]])
    };
    BOXES.iter().flat_map(|b| SIDES.map(|q| side(*b, q))).collect()
}

/// A blade of few triangles.
fn corners() -> Vec<[[f64; 3]; 3]> {
    sides().into_iter().flat_map(|[a, b, c, d]| [[a, b, c], [a, c, d]]).collect()
}

fn ascii_stl() -> Vec<u8> {
    let mut text = String::from("solid a\n");
    for t in corners() {
        text += "facet normal 0 0 0\nouter loop\n";
        t.iter().for_each(|p| text += &format!("vertex {} {} {}\n", p[0], p[1], p[2]));
        text += "endloop\nendfacet\n";
    }
    (text + "endsolid a\n").into_bytes()
}

fn binary_stl() -> Vec<u8> {
    let mut out = vec![b' '; 80];
    out.extend((corners().len() as u32).to_le_bytes());
    for t in corners() {
        out.extend([0u8; 12]);
        t.iter().flatten().for_each(|x| out.extend((*x as f32).to_le_bytes()));
        out.extend([0u8; 2]);
    }
    out
}

fn ply_head(format: &str) -> String {
    let n = corners().len();
    format!(
        "ply\nformat {format} 1.0\nelement vertex {}\nproperty float x\nproperty float y\nproperty float z\nelement face {n}\nproperty list uchar int vertex_indices\nend_header\n",
        3 * n
    )
}

fn ply() -> Vec<u8> {
    let mut text = ply_head("ascii");
    corners().iter().flatten().for_each(|p| text += &format!("{} {} {}\n", p[0], p[1], p[2]));
    (0..corners().len()).for_each(|t| text += &format!("3 {} {} {}\n", 3 * t, 3 * t + 1, 3 * t + 2));
    text.into_bytes()
}

fn binary_ply() -> Vec<u8> {
    let mut out = ply_head("binary_little_endian").into_bytes();
    corners().iter().flatten().flatten().for_each(|x| out.extend((*x as f32).to_le_bytes()));
    for t in 0..corners().len() as i32 {
        out.push(3);
        (3 * t..3 * t + 3).for_each(|i| out.extend(i.to_le_bytes()));
    }
    out
}

fn obj() -> Vec<u8> {
    let mut text = String::from("g a\n");
    corners().iter().flatten().for_each(|p| text += &format!("v {} {} {}\n", p[0], p[1], p[2]));
    (0..corners().len()).for_each(|t| text += &format!("f {} {} {}\n", 3 * t + 1, 3 * t + 2, 3 * t + 3));
    text.into_bytes()
}

/// glTF with its buffer in a data URI, or GLB, where the buffer follows the text.
fn gltf(binary: bool) -> Vec<u8> {
    let buffer: Vec<u8> = corners().iter().flatten().flatten().flat_map(|x| (*x as f32 * 1e-3).to_le_bytes()).collect();
    let uri = if binary {
        String::new()
    } else {
        format!(",\"uri\":\"data:application/octet-stream;base64,{}\"", STANDARD.encode(&buffer))
    };
    let n = 3 * corners().len();
    let mut text = format!(
        "{{\"asset\":{{\"version\":\"2.0\"}},\n\"scene\":0,\n\"scenes\":[{{\"nodes\":[0]}}],\n\"nodes\":[{{\"mesh\":0,\"translation\":[0.01,0,0]}}],\n\
         \"meshes\":[{{\"primitives\":[{{\"attributes\":{{\"POSITION\":0}},\"mode\":4}}]}}],\n\
         \"accessors\":[{{\"bufferView\":0,\"componentType\":5126,\"count\":{n},\"type\":\"VEC3\",\"min\":[-0.02,-0.01,0],\"max\":[0.02,0.01,0.06]}}],\n\
         \"bufferViews\":[{{\"buffer\":0,\"byteOffset\":0,\"byteLength\":{0}}}],\n\"buffers\":[{{\"byteLength\":{0}{uri}}}]}}\n",
        buffer.len()
    );
    if !binary {
        return text.into_bytes();
    }
    while text.len() % 4 != 0 {
        text.push(' ');
    }
    let total = 12 + 8 + text.len() + 8 + buffer.len();
    let word = |n: usize| (n as u32).to_le_bytes();
    let head = [*b"glTF", word(2), word(total), word(text.len()), *b"JSON"].concat();
    [head, text.into_bytes(), word(buffer.len()).to_vec(), b"BIN\0".to_vec(), buffer].concat()
}

/// Both boxes as B-spline faces with loops of lines and splines, each face by itself in one open
/// shell.
fn step() -> Vec<u8> {
    let mut out = String::from(
        "ISO-10303-21;\nHEADER;\nFILE_DESCRIPTION((''),'2;1');\nFILE_NAME('a.step','',(''),(''),'','','');\n\
         FILE_SCHEMA(('AUTOMOTIVE_DESIGN'));\nENDSEC;\nDATA;\n\
         #1=(LENGTH_UNIT()NAMED_UNIT(*)SI_UNIT(.MILLI.,.METRE.));\n\
         #2=(NAMED_UNIT(*)PLANE_ANGLE_UNIT()SI_UNIT($,.RADIAN.));\n\
         #3=(NAMED_UNIT(*)SI_UNIT($,.STERADIAN.)SOLID_ANGLE_UNIT());\n\
         #4=(GEOMETRIC_REPRESENTATION_CONTEXT(3)GLOBAL_UNIT_ASSIGNED_CONTEXT((#1,#2,#3))REPRESENTATION_CONTEXT('',''));\n",
    );
    let mut last = 4;
    let mut add = |text: String| {
        last += 1;
        out += &format!("#{last}={text};\n");
        last
    };
    let mut faces = Vec::new();
    for corners in sides() {
        let points = corners.map(|p| add(format!("CARTESIAN_POINT('',({:?},{:?},{:?}))", p[0], p[1], p[2])));
        let vertices = points.map(|p| add(format!("VERTEX_POINT('',#{p})")));
        let [a, b, c, d] = points;
        let surface = add(format!(
            "B_SPLINE_SURFACE_WITH_KNOTS('',1,1,((#{a},#{d}),(#{b},#{c})),.UNSPECIFIED.,.F.,.F.,.F.,(2,2),(2,2),(0.,1.),(0.,1.),.UNSPECIFIED.)"
        ));
        let edges: Vec<String> = (0..4)
            .map(|k| {
                let (from, to, next) = (points[k], points[(k + 1) % 4], (k + 1) % 4);
                let curve = if k % 2 == 0 {
                    add(format!(
                        "B_SPLINE_CURVE_WITH_KNOTS('',1,(#{from},#{to}),.UNSPECIFIED.,.F.,.F.,(2,2),(0.,1.),.UNSPECIFIED.)"
                    ))
                } else {
                    let way: [f64; 3] = std::array::from_fn(|i| corners[next][i] - corners[k][i]);
                    let direction = add(format!("DIRECTION('',({:?},{:?},{:?}))", way[0], way[1], way[2]));
                    let vector = add(format!("VECTOR('',#{direction},1.)"));
                    add(format!("LINE('',#{from},#{vector})"))
                };
                let edge = add(format!("EDGE_CURVE('',#{},#{},#{curve},.T.)", vertices[k], vertices[next]));
                format!("#{}", add(format!("ORIENTED_EDGE('',*,*,#{edge},.T.)")))
            })
            .collect();
        let around = add(format!("EDGE_LOOP('',({}))", edges.join(",")));
        let bound = add(format!("FACE_OUTER_BOUND('',#{around},.T.)"));
        faces.push(format!("#{}", add(format!("ADVANCED_FACE('',(#{bound}),#{surface},.T.)"))));
    }
    let shell = add(format!("OPEN_SHELL('',({}))", faces.join(",")));
    let model = add(format!("SHELL_BASED_SURFACE_MODEL('',(#{shell}))"));
    add(format!("MANIFOLD_SURFACE_SHAPE_REPRESENTATION('',(#{model}),#4)"));
    out += "ENDSEC;\nEND-ISO-10303-21;\n";
    out.into_bytes()
}

/// Both boxes as trimmed NURBS faces (144, 142, 128) with loops of lines (102, 110), each face by
/// itself.
fn iges() -> Vec<u8> {
    let list = |p: &[[f64; 3]]| p.concat().iter().map(|x| format!("{x:?}")).collect::<Vec<_>>().join(",");
    let mut entities: Vec<(u32, String)> = Vec::new();
    let mut add = |kind: u32, text: String| {
        entities.push((kind, format!("{kind},{text};")));
        2 * entities.len() - 1
    };
    for [a, b, c, d] in sides() {
        let knots = "0.,0.,1.,1.,0.,0.,1.,1.,1.,1.,1.,1.";
        let surface = add(128, format!("1,1,1,1,0,0,1,0,0,{knots},{},0.,1.,0.,1.", list(&[a, b, d, c])));
        let lines = [[a, b], [b, c], [c, d], [d, a]].map(|ends| add(110, list(&ends)));
        let around = add(102, format!("4,{},{},{},{}", lines[0], lines[1], lines[2], lines[3]));
        let boundary = add(142, format!("1,{surface},0,{around},2"));
        add(144, format!("{surface},1,0,{boundary}"));
    }
    let mut out = String::new();
    let mut line = |body: &str, section: char, n: usize| out += &format!("{body:<72}{section}{n:>7}\n");
    line("a blade of two boxes", 'S', 1);
    line("1H,,1H;,1Ha,5Ha.igs,1Ha,1H1,32,38,6,308,15,1Ha,1.0,2,2HMM,1,0.01,", 'G', 1);
    line("15H20200101.000000,1.E-6,100.,2Hme,2Hus,11,0,15H20200101.000000;", 'G', 2);
    let rows = |text: &str| -> Vec<String> {
        let mut rows = vec![String::new()];
        for part in text.split_inclusive(',') {
            if rows[rows.len() - 1].len() + part.len() > 64 {
                rows.push(String::new());
            }
            let last = rows.len() - 1;
            rows[last] += part;
        }
        rows
    };
    let mut parameters: Vec<String> = Vec::new();
    for (k, (kind, text)) in entities.iter().enumerate() {
        let (first, d, rows) = (parameters.len() + 1, 2 * k + 1, rows(text));
        let status = if *kind == 144 { "00000000" } else { "00010000" };
        line(&format!("{kind:>8}{first:>8}{:>8}{:>8}{:>8}{:>8}{:>8}{:>8}{status}", 0, 0, 0, 0, 0, 0), 'D', d);
        line(&format!("{kind:>8}{:>8}{:>8}{:>8}{:>8}", 0, 0, rows.len(), 0), 'D', d + 1);
        parameters.extend(rows.into_iter().map(|r| format!("{r:<64}{d:>8}")));
    }
    parameters.iter().enumerate().for_each(|(k, r)| line(r, 'P', k + 1));
    line(&format!("S{:>7}G{:>7}D{:>7}P{:>7}", 1, 2, 2 * entities.len(), parameters.len()), 'T', 1);
    out.into_bytes()
}

/// Header of [`table`].
const HEADER: &str = "[sections]\nunit = \"cm\"\ncolumns = [\"skip\", \"z\", \"r\", \"theta1\", \"theta2\"]\n";

/// A header that names its file.
fn header(file: &str) -> Vec<u8> {
    HEADER.replacen('\n', &format!("\nfiles = \"{file}\"\n"), 1).into_bytes()
}

/// Sections of a leaning blade, cm: distance from the shaft, and along the shaft with the arc on
/// either side.
fn sections() -> Vec<(f64, Vec<[f64; 3]>)> {
    let one = |section: u32| {
        let row = |j: u32| {
            let x = 0.5 * (1.0 - (std::f64::consts::PI * f64::from(j) / 24.0).cos());
            let (camber, half) = (0.9 * x * (1.0 - x) + 1.6 * x, 0.25 * (x * (1.0 - x)).max(0.0).sqrt());
            [3.0 * x, camber + half, camber - half]
        };
        (17.0 + f64::from(section), (0..25).map(row).collect())
    };
    (0..7).map(one).collect()
}

/// The same, Cartesian, mm, once round each section.
fn loops() -> Vec<Vec<[f64; 3]>> {
    let turn = |(r, rows): (f64, Vec<[f64; 3]>)| {
        let there = rows.iter().map(|p| [10.0 * p[0], 10.0 * p[1], 10.0 * r]);
        let back = rows.iter().rev().skip(1).map(|p| [10.0 * p[0], 10.0 * p[2], 10.0 * r]);
        there.chain(back).collect()
    };
    sections().into_iter().map(turn).collect()
}

/// Cylindrical coordinates in columns as compressors are published in, both sides in a row.
pub fn table() -> Vec<u8> {
    let mut text = String::from(" Blade Geometry\n");
    for (k, (r, rows)) in sections().into_iter().enumerate() {
        text += &format!("\n SURFACE NUMBER {}\n    J      Z           R         THETA 1     THETA 2\n", k + 1);
        for (j, [z, a, b]) in rows.into_iter().enumerate() {
            text += &format!("{:5} {z:11.7} {r:11.7} {:11.7} {:11.7}\n", j + 1, a / r, b / r);
        }
    }
    text.into_bytes()
}

fn rows(points: &[[f64; 3]]) -> String {
    points.iter().map(|p| format!("{:.6} {:.6} {:.6}\n", p[0], p[1], p[2])).collect()
}

fn curves() -> Vec<u8> {
    let one =
        |(k, points): (usize, &Vec<[f64; 3]>)| format!("# Profile {} at {} %\n{}", k + 1, 100 * k / 6, rows(points));
    loops().iter().enumerate().map(one).collect::<String>().into_bytes()
}

fn tecplot() -> Vec<u8> {
    let zone = |points: &Vec<[f64; 3]>| format!("zone T=\"section\" i= {} F=POINT\n{}", points.len(), rows(points));
    let zones: String = loops().iter().map(zone).collect();
    format!("TITLE=\"a\"\nVariables= X  Y  Z\n{zones}").into_bytes()
}

fn blade3d() -> Vec<u8> {
    let loops = loops();
    let points: String = loops.iter().map(|p| rows(p)).collect();
    format!("{:10} {:10}\n{points}", loops[0].len(), loops.len()).into_bytes()
}
