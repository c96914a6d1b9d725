//! Damaged files: a sentence that says where, never a panic, never more memory than the file's size
//! allows.

use super::shapes::{box_of_144, solid_box};
use super::sheet::Sheet;
use super::*;
use crate::error::ErrorKind;
use crate::read::model::sample::Random;

fn refused(text: &str, words: &[&str]) {
    let e = shape(text).err().unwrap_or_else(|| panic!("accepted, though expected {words:?}"));
    assert_eq!(e.kind, ErrorKind::InputOutput);
    for w in words {
        assert!(e.to_string().contains(w), "\"{w}\" is not in \"{e}\"");
    }
}

fn one(kind: u32, form: i64, text: &str) -> String {
    let mut sheet = Sheet::default();
    sheet.add(kind, form, text);
    sheet.text()
}

#[test]
fn damage_is_named() {
    let mut sheet = Sheet::default();
    box_of_144(&mut sheet, [1.0, 2.0, 3.0]);
    let whole = sheet.text();
    let lines: Vec<&str> = whole.lines().collect();
    refused(&lines[..lines.len() - 1].join("\n"), &["without its T line"]);
    refused(&lines[..3].join("\n"), &["no directory"]);
    let cut: Vec<&str> =
        lines.iter().copied().filter(|l| !l[72..].starts_with("P     1") && !l[72..].starts_with("P     2")).collect();
    refused(&cut.join("\n"), &["at D"]);
    refused(&whole.replacen("D      3", "X      3", 1), &["column 73 of line"]);
    refused(&whole.replacen("     108       1", "     108     abc", 1), &["directory line 1", "abc"]);
    refused(&one(128, 0, "1,1,1,1,0,0,1,0,0,0.,0.,1."), &["128 at D1", "too few"]);
    refused(&one(128, 0, "999999999999,999999999999,1,1,0,0,1,0,0"), &["128 at D1", "announces"]);
    refused(&one(128, 0, "-3,1,1,1,0,0,1,0,0"), &["announces -3"]);
    for (x, w, word) in [
        ("1.E400", "1.", "not a number"),
        ("1.E306", "1.E9", "not finite"),
        ("-1.D200", "1.", "out of all bounds"),
        ("1.", "1.E-300", "out of all bounds"),
        ("1.", "0.", "not positive"),
    ] {
        let text = format!(
            "1,1,1,1,0,0,1,0,0,0.,0.,1.,1.,0.,0.,1.,1.,1.,{w},1.,1.,0.,0.,0.,{x},0.,0.,0.,1.,0.,1.,1.,0.,0.,1.,0.,1."
        );
        refused(&one(128, 0, &text), &["128 at D1", word]);
    }
    refused(&one(144, 0, "99,1,0,3"), &["144 at D1", "points at D99"]);
    let mut sheet = Sheet::default();
    let line = sheet.line([0.; 3], [1., 0., 0.]);
    sheet.trimmed(line, &[(0, line)]);
    refused(&sheet.text(), &["110 at D1", "no surface that can be read"]);
    refused(&one(140, 0, "0.,0.,1.,1.,1"), &["no solid, shell or face"]);
    refused(&one(110, 0, "0.,0.,0.,1.,1.,1."), &["only 1 free curves"]);
    refused(&one(196, 0, "1,-4."), &["stands where an entity 116 belongs"]);
    refused(&one(120, 0, "1,x,0.,1."), &["\"x\" is not a number"]);
}

#[test]
fn what_refers_to_itself_ends() {
    let mut sheet = Sheet::default();
    let sphere_at = sheet.add(116, 0, "0.,0.,0.,0");
    let sphere = sheet.add(196, 0, format!("{sphere_at},4."));
    let t = sheet.transform([1., 0., 0., 0., 0., 1., 0., 0., 0., 0., 1., 0.], 5);
    sheet.place(sphere, t);
    refused(&sheet.text(), &["more than 32 transforms"]);
    let mut sheet = Sheet::default();
    let surface = sheet.plane([[0.; 3], [1., 0., 0.], [0., 1., 0.], [0.; 3]]);
    // A composite of itself, twice: 2^16 visits would be too many.
    let ring = sheet.composite(&[3, 3]);
    sheet.trimmed(surface, &[(0, ring)]);
    refused(&sheet.text(), &["composite curves inside one another"]);
    let mut sheet = Sheet::default();
    sheet.add(308, 0, "0,1Hx,2,3,3");
    sheet.add(408, 0, "1,0.,0.,0.,1.");
    sheet.add(408, 0, "1,0.,0.,0.,1.");
    let e = shape(&sheet.text()).err().unwrap().to_string();
    assert!(e.contains("inside itself") || e.contains("no solid"), "{e}");
}

#[test]
fn repeating_one_curve_does_not_fill_the_memory() {
    // Composites that name one another four-fold, ten levels deep: a million lines.
    let mut sheet = Sheet::default();
    let surface = sheet.plane([[0.; 3], [1., 0., 0.], [0., 1., 0.], [0.; 3]]);
    let mut c = sheet.line([0.; 3], [1., 0., 0.]);
    for _ in 0..12 {
        c = sheet.composite(&[c; 4]);
    }
    sheet.trimmed(surface, &[(0, c)]);
    refused(&sheet.text(), &["more often than a model of this size can need"]);
}

fn mutated(text: &str, random: &mut Random) -> Vec<u8> {
    let mut bytes = text.as_bytes().to_vec();
    for _ in 0..=random.below(4) {
        let at = random.below(bytes.len());
        match random.below(7) {
            0 => bytes[at] = random.below(256) as u8,
            1 => bytes[at] = b"0123456789.,;-+EDH"[random.below(18)],
            2 => bytes.truncate(at + 1),
            3 => {
                bytes.remove(at);
            }
            // A whole line gone, or written over another.
            4 => {
                let at = at / 81 * 81;
                bytes.drain(at..(at + 81).min(bytes.len()));
            }
            5 => {
                let (a, b) = (at / 81 * 81, random.below(text.len()) / 81 * 81);
                let line = text.as_bytes()[b..(b + 64).min(text.len())].to_vec();
                let end = (a + line.len()).min(bytes.len());
                bytes[a..end].copy_from_slice(&line[..end - a]);
            }
            // Another digit in the parameters: files stay whole, numbers and pointers change.
            _ => {
                for k in at..(at + 400).min(bytes.len()) {
                    if bytes[k].is_ascii_digit() && k % 81 < 64 {
                        bytes[k] = b'0' + random.below(10) as u8;
                        break;
                    }
                }
            }
        }
        if bytes.is_empty() {
            break;
        }
    }
    bytes
}

fn bases() -> Vec<String> {
    let mut loose = Sheet::default();
    box_of_144(&mut loose, [10.0, 4.0, 60.0]);
    let mut whole = Sheet::default();
    solid_box(&mut whole, [10.0, 4.0, 60.0], true);
    let mut round = Sheet::default();
    let (axis, g) = (round.line([0.; 3], [0., 0., 1.]), round.line([3.0, 0., 0.], [3.0, 0., 9.0]));
    let wall = round.add(120, 0, format!("{axis},{g},0.,6.283"));
    let outline = round.polygon(&[[0., 0.1, 0.], [1., 0.1, 0.], [1., 3.0, 0.], [0., 3.0, 0.]]);
    let t = round.transform([1., 0., 0., 0., 0., 1., 0., 0., 0., 0., 1., 0.], 0);
    let face = round.trimmed(wall, &[(outline, 0)]);
    round.place(face, t);
    let rails = (round.circle(2.0, 0.0, 0.3), round.add(104, 1, "4.,0.,9.,0.,0.,-36.,1.5,3.,0.,3.,0."));
    round.add(118, 0, format!("{},{},0,0", rails.0, rails.1));
    [loose, whole, round].map(|s| s.text()).to_vec()
}

#[test]
fn mutations_give_a_part_or_a_sentence() {
    let mut random = Random(0x9e37_79b9_7f4a_7c15);
    let (mut good, mut bad) = (0, 0);
    for text in bases() {
        assert!(shape(&text).is_ok());
        for _ in 0..250 {
            let bytes = mutated(&text, &mut random);
            match read(Path::new("t.igs"), &bytes, None) {
                Ok(s) => {
                    good += 1;
                    let poles: usize = s.brep.faces.iter().map(|f| f.surface.points.len()).sum::<usize>()
                        + s.brep.edges.iter().map(|e| e.curve.points.len()).sum::<usize>();
                    assert!(poles <= 200_000 + 4 * bytes.len());
                }
                Err(e) => {
                    bad += 1;
                    assert_eq!(e.kind, ErrorKind::InputOutput);
                    assert!(e.message.len() > 20, "{e}");
                }
            }
        }
    }
    assert!(good > 50 && bad > 50, "{good} read, {bad} refused: the mutations are too harsh or too gentle");
}

#[test]
fn mutations_go_the_whole_way_without_panic() {
    let mut random = Random(0x1234_5678_9abc_def1);
    for text in bases() {
        for _ in 0..12 {
            let bytes = mutated(&text, &mut random);
            if let Ok(mut s) = read(Path::new("t.igs"), &bytes, None) {
                sew::sew(&mut s.brep, &[0.005, 0.02]);
                if let Ok(t) = tessellate(&s.brep, &TessellateOptions::with_deflection(0.1), &Silent) {
                    let mut mesh = t.mesh;
                    orient::orient(&mut s.brep, &mut mesh);
                }
            }
        }
    }
}
