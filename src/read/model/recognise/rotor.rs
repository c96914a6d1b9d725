//! What a model that was drawn in its rotor's frame says of the blade axis.
//!
//! Designers of blades work in the frame of the machine: its shaft is a coordinate axis through the
//! origin. Two marks of it are looked for. Hub, casing and the ends of airfoils are surfaces of
//! revolution, so all their normals meet the shaft ([`shaft`]). And a blade stands off the shaft
//! along a radius, usually a coordinate axis, which is then the only one along which the part does
//! not reach back to the origin ([`radius`]). Parts drawn about themselves have neither mark.

use crate::geometry::mesh::Mesh;

/// A normal meets an axis where their distance is less than this share of the radius.
const MEETS: f64 = 0.005;
/// Surfaces square to the shaft are left out (cosine): planes of any part are surfaces of
/// revolution about any normal.
const SQUARE: f64 = 0.99;
/// A shaft's surfaces of revolution have at least this share of the part's surface …
const SHARE: f64 = 0.02;
/// … and this many times that of either other axis.
const TIMES: f64 = 5.0;
/// A part stands clear of the origin along an axis where its gap is more than this share of its
/// extent.
const CLEAR: f64 = 0.1;

/// The coordinate axis, 0 to 2, about which hub, casing or ends are surfaces of revolution; `None`
/// where none or several are.
pub fn shaft(mesh: &Mesh) -> Option<usize> {
    let mut share = [0.0f64; 3];
    for t in 0..mesh.triangles.len() {
        let [a, b, c] = mesh.corners(t);
        let p = (a.coords + b.coords + c.coords) / 3.0;
        let n = mesh.normal(t);
        let area = mesh.triangle_area_mm2(t);
        for (k, share) in share.iter_mut().enumerate() {
            let (i, j) = ((k + 1) % 3, (k + 2) % 3);
            let radius = p[i].hypot(p[j]);
            // The normal's component round the axis.
            if n[k].abs() < SQUARE && (p[i] * n[j] - p[j] * n[i]).abs() < MEETS * radius {
                *share += area;
            }
        }
    }
    let total = mesh.area_mm2();
    (0..3).find(|&k| share[k] > SHARE * total && (0..3).all(|other| other == k || share[k] > TIMES * share[other]))
}

/// The coordinate axis, 0 to 2, along which alone the part stands clear of the origin; `None` where
/// it does along none or several.
pub fn radius(mesh: &Mesh) -> Option<usize> {
    let b = mesh.aabb()?;
    let clear = |k: &usize| b.min[*k].max(-b.max[*k]) > CLEAR * (b.max[*k] - b.min[*k]);
    let mut all = (0..3).filter(clear);
    all.next().filter(|_| all.next().is_none())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::Point;
    use crate::read::model::sample;

    /// A piece of a casing round x: radius 50 to 70, a third of a right angle to either side of z.
    fn casing() -> Mesh {
        let (rows, columns) = (12u32, 40u32);
        let mut mesh = Mesh::default();
        for k in 0..=rows {
            let s = f64::from(k) / f64::from(rows);
            let (x, r) = (30.0 * s - 15.0, 50.0 + 20.0 * s * s);
            mesh.points.extend((0..=columns).map(|j| {
                let a = (f64::from(j) / f64::from(columns) - 0.5) * std::f64::consts::PI / 3.0;
                Point::new(x, r * a.sin(), r * a.cos())
            }));
        }
        for k in 0..rows {
            for j in 0..columns {
                let a = k * (columns + 1) + j;
                let b = a + columns + 1;
                mesh.triangles.extend([[a, a + 1, b + 1], [a, b + 1, b]]);
            }
        }
        mesh
    }

    #[test]
    fn a_casing_has_its_shaft_and_a_radius() {
        assert_eq!((shaft(&casing()), radius(&casing())), (Some(0), Some(2)));
        // Beside its shaft it is round about nothing; and then it stands clear of the origin along
        // two axes.
        let mut aside = casing();
        aside.points.iter_mut().for_each(|p| p.y += 60.0);
        assert_eq!((shaft(&aside), radius(&aside)), (None, None));
    }

    #[test]
    fn a_blade_drawn_about_itself_has_neither() {
        assert_eq!((shaft(&sample::blade()), radius(&sample::blade())), (None, None));
    }
}
