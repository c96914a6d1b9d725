//! Units, scales, transforms, instances, and the whole way to a blade.

use super::shapes::{box_of_144, solid_box};
use super::sheet::Sheet;
use super::*;
use crate::error::ErrorKind;
use crate::geometry::{Aabb, Point};
use crate::read::model::sample::marked;
use crate::read::model::{ModelOptions, load};

fn corners(s: &FaceModel) -> Aabb {
    let all: Vec<Point> = s.brep.edges.iter().flat_map(|e| e.t.map(|t| e.curve.point(t))).collect();
    Aabb::around(&all).unwrap()
}

#[test]
fn units_and_scale_of_the_global_section() {
    let mut sheet = Sheet::default();
    box_of_144(&mut sheet, [1.0, 2.0, 3.0]);
    for (unit, scale, mm) in [
        ("1,2HIN", 1.0, 25.4),
        ("2,2HMM", 1.0, 1.0),
        ("3,4HINCH", 1.0, 25.4),
        ("3,2Hcm", 1.0, 10.0),
        ("4,2HFT", 1.0, 304.8),
        ("6,1HM", 1.0, 1000.0),
        ("8,3HMIL", 1.0, 0.0254),
        ("9,2HUM", 1.0, 0.001),
        ("10,2HCM", 1.0, 10.0),
        ("2,", 1.0, 1.0),
        // Drawn at half its size.
        ("2,2HMM", 0.5, 2.0),
    ] {
        let b = corners(&shape(&sheet.text_in(unit, scale)).unwrap());
        assert!((b.max - b.min - nalgebra::Vector3::new(1.0, 2.0, 3.0) * mm).norm() < 1e-9 * mm, "{unit}: {b:?}");
    }
    let told = read(Path::new("t.igs"), sheet.text_in("1,2HIN", 1.0).as_bytes(), Some(Unit::Cm)).unwrap();
    assert!((corners(&told).max.z - 30.0).abs() < 1e-9 && told.unit_reason.contains("the file says inch"));
    for (unit, says) in [("3,7Hfurlong", "furlong"), ("77,2HMM", "77")] {
        let e = shape(&sheet.text_in(unit, 1.0)).err().unwrap();
        assert!(e.kind == ErrorKind::InputOutput && e.to_string().contains(says), "{e}");
    }
}

#[test]
fn transforms_add_up() {
    let quarter = [0., -1., 0., 100., 1., 0., 0., 0., 0., 0., 1., 7.];
    let shift = [1., 0., 0., 0., 0., 1., 0., 50., 0., 0., 1., 0.];
    let mut sheet = Sheet::default();
    let faces = box_of_144(&mut sheet, [10.0, 4.0, 60.0]);
    let outer = sheet.transform(shift, 0);
    let inner = sheet.transform(quarter, outer);
    faces.iter().for_each(|f| sheet.place(*f, inner));
    // (x, y, z) -> (100 − y, x + 50, z + 7)
    let b = corners(&shape(&sheet.text()).unwrap());
    assert!((b.min - Point::new(96.0, 50.0, 7.0)).norm() < 1e-9, "{b:?}");
    assert!((b.max - Point::new(100.0, 60.0, 67.0)).norm() < 1e-9, "{b:?}");
    solid(&sheet.text(), 0.01).measures(2400.0, 1760.0, 1e-12);
}

#[test]
fn instances_of_subfigures_and_mirrored_solids() {
    let mut sheet = Sheet::default();
    let body = solid_box(&mut sheet, [1.0, 2.0, 3.0], false);
    let definition = sheet.add(308, 0, format!("0,3Hbox,1,{body}"));
    sheet.add(408, 0, format!("{definition},10.,0.,0.,2."));
    let mirrored = sheet.add(408, 0, format!("{definition},-10.,0.,0.,1."));
    let mirror = sheet.transform([1., 0., 0., 0., 0., 1., 0., 0., 0., 0., -1., 0.], 0);
    sheet.place(mirrored, mirror);
    let s = shape(&sheet.text()).unwrap();
    assert_eq!((s.bodies, s.brep.faces.len(), s.brep.edges.len()), (2, 12, 24));
    let b = corners(&s);
    assert!((b.min - Point::new(-10.0, 0.0, -3.0)).norm() < 1e-9 && (b.max - Point::new(12.0, 4.0, 6.0)).norm() < 1e-9);
    let mesh = tessellate(&s.brep, &TessellateOptions::with_deflection(0.01), &Silent).unwrap().mesh;
    assert!((mesh.volume_mm3() - (48.0 + 6.0)).abs() < 1e-9, "{}", mesh.volume_mm3());
}

#[test]
fn a_box_becomes_a_blade_without_its_extension() {
    let mut sheet = Sheet::default();
    box_of_144(&mut sheet, [10.0, 4.0, 60.0]);
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("part.dat");
    // Without blanks at line ends there would be no column 73; line ends of either kind are fine.
    let text = sheet.text().replace('\n', "\r\n");
    let read = |text: &[u8]| {
        std::fs::write(&path, text).unwrap();
        load(&path, &ModelOptions { axis: Some([0.0, 0.0, 1.0]), ..ModelOptions::default() }, &Silent).unwrap()
    };
    let b = read(text.as_bytes());
    assert!((b.part.mesh.volume_mm3() - 2400.0).abs() < 1e-6 && b.diagnosis.closed);
    assert_eq!(read(&marked(text.as_bytes())).part.mesh.points, b.part.mesh.points);
    assert_eq!(b.diagnosis.format, "IGES 5.3");
    let says = |words: &str| b.diagnosis.notes.iter().any(|n| n.to_string().contains(words));
    assert!(says("12 edges that faces did not share") && says("faces were oriented"), "{:?}", b.diagnosis.notes);
}
