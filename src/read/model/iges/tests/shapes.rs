//! Every kind of entity against volume and area in closed form.

use std::f64::consts::{PI, TAU};

use super::sheet::{Sheet, box_sides, list};
use super::*;

/// Faces of a box, three on planes and three on NURBS (one looks inward), each with lines of its
/// own; half of the loops are walked clockwise.
pub fn box_of_144(sheet: &mut Sheet, size: [f64; 3]) -> Vec<usize> {
    let mut faces = Vec::new();
    for (k, corners) in box_sides(size).into_iter().enumerate() {
        let mut inward = corners;
        inward.reverse();
        let surface = match k {
            0 | 2 | 4 => sheet.plane(corners),
            1 => sheet.bilinear(inward),
            _ => sheet.bilinear(corners),
        };
        let mut ring = corners;
        if k > 2 {
            ring.reverse();
        }
        let outline = sheet.polygon(&ring);
        faces.push(sheet.trimmed(surface, &[(0, outline)]));
    }
    faces
}

#[test]
fn a_box_of_trimmed_faces() {
    let mut sheet = Sheet::default();
    box_of_144(&mut sheet, [10.0, 4.0, 60.0]);
    let s = solid(&sheet.text(), 0.01);
    s.measures(2400.0, 2.0 * (40.0 + 240.0 + 600.0), 1e-12);
    assert_eq!((s.brep.faces.len(), s.brep.edges.len(), s.sewn.joined, s.sewn.open), (6, 12, 12, 0));
    assert!(s.brep.faces[0].name.to_string().contains("(D"), "{}", s.brep.faces[0].name);
}

/// Properties (406) and definitions that nothing places (308) are no shape, wherever they stand and
/// whoever names them: the file reads the same, with the numbers of the directory lines that it has
/// then.
#[test]
fn properties_and_unused_definitions_are_passed_over() {
    let size = [10.0, 4.0, 60.0];
    let mut plain = Sheet::default();
    box_of_144(&mut plain, size);
    let plain = solid(&plain.text(), 0.01);
    for before in [false, true] {
        let mut sheet = Sheet::default();
        let extra = |sheet: &mut Sheet| {
            let name = sheet.add(406, 15, "1,8HFace; 1,");
            let level = sheet.add(406, 1, "2,7,9");
            // Form 5001 on is anybody's: what stands in it is not looked at.
            sheet.add(406, 5001, "3,1.5,4Hb;c,,99999");
            let empty = sheet.add(308, 0, "0,5Hempty,0");
            let line = sheet.line([0.0; 3], [500.0, 0.0, 0.0]);
            sheet.add(308, 0, format!("1,4Huses,2,{line},{empty}"));
            [name, level]
        };
        let mut named = if before { extra(&mut sheet) } else { [0; 2] };
        let faces = box_of_144(&mut sheet, size);
        if !before {
            named = extra(&mut sheet);
        }
        // Behind the parameters of any entity: the number of its notes and their pointers, then of
        // its properties.
        for face in &faces {
            sheet.append(*face, format!(",0,2,{},{}", named[0], named[1]));
        }
        let surfaces: Vec<usize> =
            (0..sheet.len()).map(|k| 2 * k + 1).filter(|e| matches!(sheet.kind(*e), 108 | 128 | 110)).collect();
        surfaces.iter().for_each(|e| sheet.append(*e, format!(",0,1,{}", named[0])));
        let with = solid(&sheet.text(), 0.01);
        assert_eq!(with.mesh.points, plain.mesh.points);
        assert_eq!(with.mesh.triangles, plain.mesh.triangles);
        assert_eq!(with.brep.faces.len(), 6);
    }
    // The same on a solid, its shell, faces and edges.
    let mut sheet = Sheet::default();
    let body = solid_box(&mut sheet, size, false);
    let plain = solid(&sheet.text(), 0.01);
    let name = sheet.add(406, 15, "1,4HBody");
    let all: Vec<usize> = (0..=body / 2).map(|k| 2 * k + 1).collect();
    all.iter().for_each(|e| sheet.append(*e, format!(",0,1,{name}")));
    assert_eq!(solid(&sheet.text(), 0.01).mesh.points, plain.mesh.points);
}

#[test]
fn a_box_with_a_hole_through_it() {
    let mut sheet = Sheet::default();
    let sides = box_sides([10.0, 8.0, 6.0]);
    for (k, corners) in sides.into_iter().enumerate() {
        let (surface, outline) = (sheet.bilinear(corners), sheet.polygon(&corners));
        let mut loops = vec![(0, outline)];
        if k < 2 {
            let z = corners[0][2];
            let hole = sheet.polygon(&[[3.0, 2.0, z], [7.0, 2.0, z], [7.0, 5.0, z], [3.0, 5.0, z]]);
            loops.push((0, hole));
        }
        sheet.trimmed(surface, &loops);
    }
    let ring = [[3.0, 2.0], [7.0, 2.0], [7.0, 5.0], [3.0, 5.0]];
    for k in 0..4 {
        let [a, b] = [ring[k], ring[(k + 1) % 4]];
        // Ruled surfaces without trimming make the hole's walls.
        let (low, high) =
            (sheet.line([a[0], a[1], 0.], [b[0], b[1], 0.]), sheet.line([a[0], a[1], 6.], [b[0], b[1], 6.]));
        sheet.add(118, 1, format!("{low},{high},0,0"));
    }
    let hole = 4.0 * 3.0;
    solid(&sheet.text(), 0.01).measures((80.0 - hole) * 6.0, 2.0 * (80.0 - hole) + 36.0 * 6.0 + 14.0 * 6.0, 1e-12);
}

/// Flat round ends for a body of revolution about z, trimmed by circles that begin at an angle.
fn ends(sheet: &mut Sheet, radii: [f64; 2], z: [f64; 2], from: f64) {
    for k in 0..2 {
        let s = 3.0 * radii[k];
        let plane = sheet.plane([[-s, -s, z[k]], [s, -s, z[k]], [s, s, z[k]], [-s, s, z[k]]]);
        let circle = sheet.circle(radii[k], z[k], from);
        sheet.trimmed(plane, &[(0, circle)]);
    }
}

#[test]
fn cylinders_whose_seams_and_circles_begin_anywhere() {
    let (r, h) = (3.0, 20.0);
    let expected = (PI * r * r * h, TAU * r * h + TAU * r * r);
    for (start, from, to) in [(0.0, 0.0, TAU), (0.7, 0.3, 0.3 + TAU), (-2.0, 1.0, 1.0 + TAU)] {
        let mut sheet = Sheet::default();
        ends(&mut sheet, [r, r], [0.0, h], start);
        let (axis, g) = (sheet.line([0.; 3], [0., 0., 1.]), sheet.line([r, 0., 0.], [r, 0., h]));
        sheet.add(120, 0, format!("{axis},{g},{from:?},{to:?}"));
        let s = solid(&sheet.text(), 0.001);
        s.measures(expected.0, expected.1, 8e-4);
        assert_eq!(s.sewn.open, 0);
    }
    // The same as two halves of tabulated cylinders, and with a rational NURBS circle at one end.
    let mut sheet = Sheet::default();
    ends(&mut sheet, [r, r], [0.0, h], 0.0);
    for (a, b) in [(r, -r), (-r, r)] {
        let arc = sheet.add(100, 0, list(&[0.0, 0.0, 0.0, a, 0.0, b, 0.0]));
        sheet.add(122, 0, format!("{arc},{}", list(&[a, 0.0, h])));
    }
    let s = solid(&sheet.text(), 0.001);
    s.measures(expected.0, expected.1, 8e-4);
    assert!(s.sewn.cut >= 2, "the full circles are cut where the halves end: {:?}", s.sewn);
}

#[test]
fn frustums_ruled_by_length_and_by_parameter() {
    let (a, b, h) = (5.0, 2.0, 7.0);
    let slant = f64::hypot(h, a - b);
    for form in [0, 1] {
        for against in [0, 1] {
            let mut sheet = Sheet::default();
            ends(&mut sheet, [a, b], [0.0, h], 0.4);
            let low = sheet.circle(a, 0.0, 0.0);
            // Walked the other way round where the rails run against one another.
            let high = sheet.circle(b, h, 0.0);
            if against == 1 {
                let turned = sheet.transform([1., 0., 0., 0., 0., -1., 0., 0., 0., 0., -1., 2.0 * h], 0);
                sheet.place(high, turned);
            }
            sheet.add(118, form, format!("{low},{high},{against},0"));
            let s = solid(&sheet.text(), 0.001);
            s.measures(PI * h / 3.0 * (a * a + a * b + b * b), PI * (a + b) * slant + PI * (a * a + b * b), 8e-4);
        }
    }
}

#[test]
fn spheres_and_tori() {
    let mut sheet = Sheet::default();
    let at = sheet.add(116, 0, "1.,2.,3.,0");
    sheet.add(196, 0, format!("{at},4."));
    solid(&sheet.text(), 0.002).measures(4.0 / 3.0 * PI * 64.0, 4.0 * PI * 16.0, 1.2e-3);
    let mut sheet = Sheet::default();
    let (at, dir) = (sheet.add(116, 0, "1.,2.,3.,0"), sheet.add(123, 0, "1.,1.,2."));
    sheet.add(198, 0, format!("{at},{dir},10.,3."));
    solid(&sheet.text(), 0.002).measures(2.0 * PI * PI * 10.0 * 9.0, 4.0 * PI * PI * 30.0, 1.2e-3);
}

/// A sphere as a half circle turned round, trimmed by its seam, up and down again: folded like a
/// sliver, yet the whole of it.
#[test]
fn a_sphere_within_its_seam() {
    let r = 20.0;
    let mut sheet = Sheet::default();
    let half = |sheet: &mut Sheet| sheet.add(100, 0, list(&[0.0, 0.0, 0.0, 0.0, -r, 0.0, r]));
    let (axis, generatrix) = (sheet.line([0.; 3], [0., 1., 0.]), half(&mut sheet));
    let ball = sheet.add(120, 0, format!("{axis},{generatrix},0.,{TAU:?}"));
    let (up, down) = (half(&mut sheet), half(&mut sheet));
    let turned = sheet.transform([1., 0., 0., 0., 0., -1., 0., 0., 0., 0., -1., 0.], 0);
    sheet.place(down, turned);
    let seam = sheet.composite(&[up, down]);
    sheet.trimmed(ball, &[(0, seam)]);
    let s = solid(&sheet.text(), 0.002);
    s.measures(4.0 / 3.0 * PI * r.powi(3), 4.0 * PI * r * r, 4e-4);
    assert_eq!((s.sewn.open, s.sewn.slivers.len()), (0, 0));
}

#[test]
fn cylinders_and_cones_without_ends() {
    // Between circles, which both run counter-clockwise.
    for (kind, text, radii) in [(192, "3.", [3.0, 3.0]), (194, "3.,30.", [3.0, 3.0 + 6.0 * 30f64.to_radians().tan()])] {
        let mut sheet = Sheet::default();
        let z = [0.0, 6.0];
        ends(&mut sheet, radii, z, 0.0);
        let (at, dir) = (sheet.add(116, 0, "0.,0.,0.,0"), sheet.add(123, 0, "0.,0.,1."));
        let wall = sheet.add(kind, 0, format!("{at},{dir},{text}"));
        let rings = [0, 1].map(|k| (0, sheet.circle(radii[k], z[k], 0.0)));
        sheet.trimmed(wall, &rings);
        let [a, b] = radii;
        let slant = f64::hypot(6.0, b - a);
        solid(&sheet.text(), 0.001).measures(
            PI * 2.0 * (a * a + a * b + b * b),
            PI * (a + b) * slant + PI * (a * a + b * b),
            8e-4,
        );
    }
}

#[test]
fn trimming_in_the_parameter_plane_alone() {
    let (r, h) = (3.0, 20.0);
    let mut sheet = Sheet::default();
    // Ends: a circle of radius 0.25 about the middle of the parameter square of a plane of side 4
    // r.
    for z in [0.0, h] {
        let s = 2.0 * r;
        let plane = sheet.bilinear([[-s, -s, z], [s, -s, z], [s, s, z], [-s, s, z]]);
        let circle = sheet.add(100, 0, "0.,0.5,0.5,0.75,0.5,0.75,0.5");
        sheet.trimmed(plane, &[(circle, 0)]);
    }
    // The wall: a rectangle in (generatrix, angle), of which the seam and both circles are
    // parameter lines.
    let (axis, g) = (sheet.line([0.; 3], [0., 0., 1.]), sheet.line([r, 0., -h], [r, 0., 2.0 * h]));
    let wall = sheet.add(120, 0, format!("{axis},{g},0.,{TAU:?}"));
    let (lo, hi) = (1.0 / 3.0, 2.0 / 3.0);
    let outline = sheet.polygon(&[[lo, 0., 0.], [hi, 0., 0.], [hi, TAU, 0.], [lo, TAU, 0.]]);
    sheet.trimmed(wall, &[(outline, 0)]);
    let s = solid(&sheet.text(), 0.001);
    s.measures(PI * r * r * h, TAU * r * h + TAU * r * r, 8e-4);
    // The fitted circles keep their bound.
    for e in &s.brep.edges {
        for k in 0..=200 {
            let p = e.curve.point(e.t[0] + (e.t[1] - e.t[0]) * f64::from(k) / 200.0);
            assert!((p.x.hypot(p.y) - r).abs() < fit::FIT_MM, "{p}");
        }
    }
}

#[test]
fn angles_of_the_file_are_not_our_parameters() {
    // A third of a cylinder's wall: the angles at which it is trimmed must be met although our
    // parameter runs otherwise.
    let mut sheet = Sheet::default();
    let (axis, g) = (sheet.line([0.; 3], [0., 0., 1.]), sheet.line([3.0, 0., 0.], [3.0, 0., 9.0]));
    let wall = sheet.add(120, 0, format!("{axis},{g},0.,{TAU:?}"));
    let (a, b) = (0.35, 0.35 + TAU / 3.0);
    let outline = sheet.polygon(&[[0., a, 0.], [1., a, 0.], [1., b, 0.], [0., b, 0.]]);
    sheet.trimmed(wall, &[(outline, 0)]);
    let brep = shape(&sheet.text()).unwrap().brep;
    let mesh = tessellate(&brep, &TessellateOptions::with_deflection(0.001), &Silent).unwrap().mesh;
    assert!((mesh.area_mm2() / (TAU * 9.0) - 1.0).abs() < 8e-4);
    let angles = brep.edges.iter().flat_map(|e| e.t.map(|t| e.curve.point(t))).map(|p| p.y.atan2(p.x));
    assert!(angles.into_iter().all(|x| (x - a).abs() < 1e-12 || (x - b).abs() < 1e-12));
}

#[test]
fn bounded_surfaces_143() {
    let mut sheet = Sheet::default();
    for (k, corners) in box_sides([3.0, 4.0, 5.0]).into_iter().enumerate() {
        let surface = sheet.bilinear(corners);
        let lines: Vec<usize> = (0..4).map(|k| sheet.line(corners[k], corners[(k + 1) % 4])).collect();
        // Curves one by one, the last one walked backwards on every second face.
        let text = if k % 2 == 0 {
            format!("0,1,{surface},4{}", lines.iter().map(|l| format!(",{l},1,0")).collect::<String>())
        } else {
            let back = sheet.line(corners[0], corners[3]);
            format!("0,1,{surface},4,{},1,0,{},1,0,{},1,0,{back},2,0", lines[0], lines[1], lines[2])
        };
        let boundary = sheet.add(141, 0, text);
        sheet.add(143, 0, format!("0,{surface},1,{boundary}"));
    }
    solid(&sheet.text(), 0.01).measures(60.0, 94.0, 1e-12);
}

/// A solid box, its edges shared; `flip`: every face is on a surface that looks inward.
pub fn solid_box(sheet: &mut Sheet, size: [f64; 3], flip: bool) -> usize {
    let sides = box_sides(size);
    let corner = |k: usize| [0, 1, 2].map(|d| if k >> d & 1 == 1 { size[d] } else { 0.0 });
    let points: Vec<f64> = (0..8).flat_map(corner).collect();
    let vertices = sheet.add(502, 1, format!("8,{}", list(&points)));
    let mut numbers = std::collections::BTreeMap::new();
    let mut text = String::new();
    for k in 0..8usize {
        for d in (0..3).filter(|d| k >> d & 1 == 0) {
            let to = k | 1 << d;
            let line = sheet.line(corner(k), corner(to));
            numbers.insert((k, to), numbers.len() + 1);
            text += &format!(",{line},{vertices},{},{vertices},{}", k + 1, to + 1);
        }
    }
    let edges = sheet.add(504, 1, format!("12{text}"));
    let mut faces = String::new();
    for (ring, corners) in
        [[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5usize]].iter().zip(sides)
    {
        let mut text = String::new();
        for k in 0..4 {
            let (a, b) = (ring[k], ring[(k + 1) % 4]);
            text += &format!(",0,{edges},{},{},0", numbers[&(a.min(b), a.max(b))], i32::from(a < b));
        }
        let outline = sheet.add(508, 1, format!("4{text}"));
        let mut c = corners;
        if flip {
            c.reverse();
        }
        let surface = sheet.bilinear(c);
        let face = sheet.add(510, 1, format!("{surface},1,1,{outline}"));
        faces += &format!(",{face},{}", i32::from(!flip));
    }
    let shell = sheet.add(514, 1, format!("6{faces}"));
    sheet.add(186, 0, format!("{shell},1,0"))
}

#[test]
fn solids_share_their_edges_and_keep_their_sense() {
    for flip in [false, true] {
        let mut sheet = Sheet::default();
        solid_box(&mut sheet, [3.0, 4.0, 5.0], flip);
        let mut s = shape(&sheet.text()).unwrap();
        assert_eq!((s.bodies, s.brep.faces.len(), s.brep.edges.len()), (1, 6, 12));
        let sewn = sew::sew(&mut s.brep, &[1e-3]);
        assert_eq!(sewn, Sewn::default(), "nothing is left to sew");
        let mesh = tessellate(&s.brep, &TessellateOptions::with_deflection(0.01), &Silent).unwrap().mesh;
        // As the file says, without orienting.
        assert!((mesh.volume_mm3() - 60.0).abs() < 1e-9, "{}", mesh.volume_mm3());
    }
}

#[test]
fn curves_satisfy_their_equations() {
    let check = |kind: u32, form: i64, text: &str, off: &dyn Fn(f64, f64, f64) -> f64, ends: [[f64; 3]; 2]| {
        let mut sheet = Sheet::default();
        sheet.add(kind, form, text);
        let text = sheet.text();
        let f = file::File::new(Path::new("t.igs"), text.as_bytes()).unwrap();
        let c = curves::curve(&f, &f.entities[0], &Matrix4::identity()).unwrap();
        let [a, b] = c.nurbs.domain();
        for k in 0..=100 {
            let p = c.nurbs.point(a + (b - a) * f64::from(k) / 100.0);
            assert!(off(p.x, p.y, p.z).abs() < 1e-9, "{kind} {form}: {p}");
        }
        for (t, e) in [a, b].into_iter().zip(ends) {
            assert!((c.nurbs.point(t).coords - nalgebra::Vector3::from(e)).norm() < 1e-9, "{kind} {form}");
        }
    };
    let z = |z: f64| z - 1.5;
    // Ellipse x²/9 + y²/4 = 1 from (3, 0) to (0, −2): three quarters.
    let ellipse = |x: f64, y: f64, w: f64| x * x / 9.0 + y * y / 4.0 - 1.0 + z(w);
    check(104, 1, "4.,0.,9.,0.,0.,-36.,1.5,3.,0.,0.,-2.", &ellipse, [[3., 0., 1.5], [0., -2., 1.5]]);
    // Hyperbola x² − y² = 1 and parabola y = x².
    let s = 2f64.sqrt();
    let text = format!("1.,0.,-1.,0.,0.,-1.,1.5,{s:?},-1.,{s:?},1.");
    check(104, 2, &text, &|x, y, w| x * x - y * y - 1.0 + z(w), [[s, -1., 1.5], [s, 1., 1.5]]);
    check(104, 3, "1.,0.,0.,0.,-1.,0.,1.5,-1.,1.,2.,4.", &|x, y, w| y - x * x + z(w), [[-1., 1., 1.5], [2., 4., 1.5]]);
    // Splines: y = x³ − 2x over two stretches, in plane.
    let first = "0.,1.,0.,0., 0.,-2.,0.,1., 1.5,0.,0.,0.";
    let second = "1.,1.,0.,0., -1.,1.,3.,1., 1.5,0.,0.,0.";
    let text = format!("3,2,2,2,0.,1.,3.,{first},{second},0.,0.,0.,0.,0.,0.,0.,0.,0.,0.,0.,0.");
    check(112, 0, &text, &|x, y, w| y - x * x * x + 2.0 * x + z(w), [[0., 0., 1.5], [3., 21., 1.5]]);
    // Part of a NURBS: y = x² as a quadratic, from 0.25 to 0.75.
    let text = "2,2,0,0,1,0,0.,0.,0.,1.,1.,1.,1.,1.,1.,0.,0.,1.5,0.5,0.,1.5,1.,1.,1.5,0.25,0.75,0.,0.,1.";
    check(126, 0, text, &|x, y, w| y - x * x + z(w), [[0.25, 0.0625, 1.5], [0.75, 0.5625, 1.5]]);
    check(106, 11, "1,3,1.5,0.,0.,1.,1.,2.,2.", &|x, y, w| y - x + z(w), [[0., 0., 1.5], [2., 2., 1.5]]);
}

#[test]
fn polynomial_surfaces_114() {
    // x = s, y = t, z = s² t − t³ over [0, 2] × [0, 1] in two patches along u.
    let mut text = String::from("3,1,2,1,0.,1.,2.,0.,1.");
    for i in 0..2 {
        let a = f64::from(i);
        let mut x = [0.0; 16];
        (x[0], x[1]) = (a, 1.0);
        let mut y = [0.0; 16];
        y[4] = 1.0;
        let mut z = [0.0; 16];
        // (a + s)² t − t³
        (z[4], z[5], z[6], z[12]) = (a * a, 2.0 * a, 1.0, -1.0);
        for c in [x, y, z] {
            text += &format!(",{}", list(&c));
        }
        // The patch that means nothing, at the end of each row.
        text += &format!(",{}", list(&[7.0; 48]));
    }
    text += &format!(",{}", list(&[7.0; 96]));
    let mut sheet = Sheet::default();
    sheet.add(114, 0, text);
    let s = shape(&sheet.text()).unwrap().brep.faces.remove(0).surface;
    assert_eq!(s.domain(), [[0.0, 2.0], [0.0, 1.0]]);
    for i in 0..=20 {
        for j in 0..=10 {
            let (u, v) = (0.1 * f64::from(i), 0.1 * f64::from(j));
            let p = s.point(u, v);
            assert!((p.coords - nalgebra::Vector3::new(u, v, u * u * v - v * v * v)).norm() < 1e-12);
        }
    }
}
