//! The tool axes that a cutter location allows: a family with one angle θ.

use nalgebra::{Matrix3, Rotation3, UnitQuaternion};

use crate::geometry::Vector;

/// A cone of tool axes: `a(θ) = sin B c + cos B (cos θ e + sin θ c × e)`, unit vectors from tip to
/// spindle.
///
/// The root of a blade has the same cone everywhere: `c` is the blade axis, `B` the lean of the
/// head. The axes of a reference plane (Chen, Xu and Tang 2015) are the cone with `c` the plane's
/// normal and `B = 0`.
#[derive(Clone, Copy, Debug, PartialEq, serde::Serialize, serde::Deserialize)]
pub struct Cone {
    /// Axis `c` of the cone, unit, blade frame. θ turns about it by the right-hand rule.
    pub axis: Vector,
    /// Direction `e` of θ = 0, unit, square to the axis, blade frame.
    pub reference: Vector,
    /// Lean `B` of the tool axis over the plane square to `c`, towards `c`, rad.
    pub lean_rad: f64,
}

impl Cone {
    /// The cone about the blade axis: `a(θ) = (sin B, cos B cos θ, cos B sin θ)`.
    pub fn about_blade(lean_rad: f64) -> Self {
        Cone { axis: Vector::x(), reference: Vector::y(), lean_rad }
    }

    /// The cone about an axis, with the reference made square to it; `None` where one is no
    /// direction or both are parallel.
    pub fn new(axis: Vector, reference: Vector, lean_rad: f64) -> Option<Self> {
        let axis = axis.try_normalize(1e-12)?;
        let reference = (reference - axis * axis.dot(&reference)).try_normalize(1e-9)?;
        lean_rad.is_finite().then_some(Cone { axis, reference, lean_rad })
    }

    /// It stands about the blade axis as [`Cone::about_blade`] has it, whatever its lean.
    pub fn is_about_blade(&self) -> bool {
        self.axis == Vector::x() && self.reference == Vector::y()
    }

    /// The tool axis at θ.
    pub fn tool_axis(&self, theta_rad: f64) -> Vector {
        let (sb, cb) = self.lean_rad.sin_cos();
        let (st, ct) = theta_rad.sin_cos();
        if self.is_about_blade() {
            return Vector::new(sb, cb * ct, cb * st);
        }
        self.axis * sb + (self.reference * ct + self.axis.cross(&self.reference) * st) * cb
    }

    /// The same family where the part is turned with all its tool axes.
    #[must_use]
    pub fn turned(&self, turn: &UnitQuaternion<f64>) -> Self {
        Cone { axis: turn * self.axis, reference: turn * self.reference, ..*self }
    }

    /// A vector of the blade frame by its components along `c`, `e` and `c × e`.
    pub fn seen(&self, v: &Vector) -> Vector {
        if self.is_about_blade() {
            return *v;
        }
        Vector::new(self.axis.dot(v), self.reference.dot(v), self.axis.cross(&self.reference).dot(v))
    }

    /// The vector of the blade frame with these components along `c`, `e` and `c × e`.
    pub fn unseen(&self, v: &Vector) -> Vector {
        if self.is_about_blade() {
            return *v;
        }
        self.axis * v.x + self.reference * v.y + self.axis.cross(&self.reference) * v.z
    }

    /// The angle θ of a vector about the axis, within half a turn, rad; `None` where less than
    /// `least` of it is square to the axis.
    pub fn theta_of(&self, v: &Vector, least: f64) -> Option<f64> {
        let v = self.seen(v);
        (v.y.hypot(v.z) >= least).then(|| v.z.atan2(v.y))
    }

    /// The rotation vector, rad, blade frame, that carries `c` and `e` onto those of the other
    /// cone.
    pub fn rotation_to(&self, other: &Cone) -> Vector {
        if self.axis == other.axis && self.reference == other.reference {
            return Vector::zeros();
        }
        let to = Rotation3::from_matrix_unchecked(other.frame() * self.frame().transpose());
        UnitQuaternion::from_rotation_matrix(&to).scaled_axis()
    }

    /// The cone at a share of the way to another: its frame turns evenly by the shortest rotation,
    /// its lean changes evenly.
    pub fn between(&self, other: &Cone, share: f64) -> Cone {
        let lean_rad = self.lean_rad + (other.lean_rad - self.lean_rad) * share;
        let turn = UnitQuaternion::from_scaled_axis(self.rotation_to(other) * share);
        if turn == UnitQuaternion::identity() {
            return Cone { lean_rad, ..*self };
        }
        Cone { axis: turn * self.axis, reference: turn * self.reference, lean_rad }
    }

    /// The same axes with the reference carried along from another cone: by the least rotation that
    /// brings the other's axis onto this one's. Where both axes point against one another this one
    /// is written about its other direction.
    fn carried_from(&self, last: &Cone) -> Cone {
        let (axis, lean_rad) =
            if self.axis.dot(&last.axis) < 0.0 { (-self.axis, -self.lean_rad) } else { (self.axis, self.lean_rad) };
        if axis == last.axis {
            return Cone { axis, reference: last.reference, lean_rad };
        }
        let carried = UnitQuaternion::rotation_between(&last.axis, &axis).unwrap_or_default() * last.reference;
        Cone::new(axis, carried, lean_rad).unwrap_or(Cone { axis, reference: self.reference, lean_rad })
    }

    fn frame(&self) -> Matrix3<f64> {
        Matrix3::from_columns(&[self.axis, self.reference, self.axis.cross(&self.reference)])
    }
}

/// The cones along a path.
#[derive(Clone, Debug, PartialEq, serde::Serialize, serde::Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Cones {
    /// The same at all locations.
    Same(Cone),
    /// One for each location: [`Cones::along`].
    Each(Vec<Cone>),
}

impl Cones {
    /// The same cone about the blade axis everywhere.
    pub fn about_blade(lean_rad: f64) -> Self {
        Cones::Same(Cone::about_blade(lean_rad))
    }

    /// One cone for each location. The first keeps its reference; all others get theirs by carrying
    /// it along (rotation-minimising frames), so that θ means the same from location to location,
    /// whatever references they came with.
    pub fn along(cones: Vec<Cone>) -> Self {
        let mut out: Vec<Cone> = Vec::with_capacity(cones.len());
        for cone in cones {
            let carried = out.last().map_or(cone, |last| cone.carried_from(last));
            out.push(carried);
        }
        match out.first() {
            Some(first) if out.iter().all(|c| c == first) => Cones::Same(*first),
            _ => Cones::Each(out),
        }
    }

    /// The cone of a location; beyond the last, that of the last.
    pub fn at(&self, row: usize) -> Cone {
        match self {
            Cones::Same(cone) => *cone,
            Cones::Each(all) => all.get(row).or(all.last()).copied().unwrap_or(Cone::about_blade(0.0)),
        }
    }

    /// The cone at a share of the way from a location to the next.
    pub fn between(&self, row: usize, share: f64) -> Cone {
        match self {
            Cones::Same(cone) => *cone,
            Cones::Each(_) => self.at(row).between(&self.at(row + 1), share),
        }
    }

    /// The one cone of all locations, where there is one.
    pub fn same(&self) -> Option<Cone> {
        match self {
            Cones::Same(cone) => Some(*cone),
            Cones::Each(_) => None,
        }
    }

    /// The same cones with another lean, rad.
    #[must_use]
    pub fn leaning(&self, lean_rad: f64) -> Self {
        self.each_as(|c: &Cone| Cone { lean_rad, ..*c })
    }

    /// The cones where the part is turned with all its tool axes.
    #[must_use]
    pub fn turned(&self, turn: &UnitQuaternion<f64>) -> Self {
        self.each_as(|c| c.turned(turn))
    }

    fn each_as(&self, with: impl Fn(&Cone) -> Cone) -> Self {
        match self {
            Cones::Same(cone) => Cones::Same(with(cone)),
            Cones::Each(all) => Cones::Each(all.iter().map(with).collect()),
        }
    }

    /// Those of the locations from `from` up to `to`.
    #[must_use]
    pub fn part(&self, from: usize, to: usize) -> Self {
        match self {
            Cones::Same(cone) => Cones::Same(*cone),
            Cones::Each(all) => Cones::Each(all.get(from..to.min(all.len())).unwrap_or_default().to_vec()),
        }
    }

    /// Those of some locations.
    #[must_use]
    pub fn chosen(&self, rows: &[usize]) -> Self {
        match self {
            Cones::Same(cone) => Cones::Same(*cone),
            Cones::Each(_) => Cones::Each(rows.iter().map(|k| self.at(*k)).collect()),
        }
    }

    /// With so many locations more before the first and behind the last, each with the cone of that
    /// end.
    #[must_use]
    pub fn extended(&self, [before, behind]: [usize; 2]) -> Self {
        match self {
            Cones::Same(cone) => Cones::Same(*cone),
            Cones::Each(all) => {
                let ends = [all.first(), all.last()].map(|c| c.copied().into_iter());
                let [first, last] = ends;
                let (first, last) = (first.cycle().take(before), last.cycle().take(behind));
                Cones::Each(first.chain(all.iter().copied()).chain(last).collect())
            }
        }
    }

    /// Every number is finite and there are as many as locations, or one for all.
    pub fn fit(&self, locations: usize) -> bool {
        let finite =
            |c: &Cone| c.axis.iter().chain(c.reference.iter()).all(|v| v.is_finite()) && c.lean_rad.is_finite();
        match self {
            Cones::Same(cone) => finite(cone),
            Cones::Each(all) => all.len() == locations && all.iter().all(finite),
        }
    }
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used)]
    use super::*;
    use proptest::prelude::*;

    fn cone() -> impl Strategy<Value = Cone> {
        let unit = || prop::array::uniform3(-1.0..1.0f64).prop_map(Vector::from);
        (unit(), unit(), -1.0..1.0f64)
            .prop_filter_map("no frame", |(c, e, lean)| (c.norm() > 0.1).then(|| Cone::new(c, e, lean)).flatten())
    }

    /// A general frame that happens to be the blade's gives the same axes to the last bit as the
    /// short cut.
    #[test]
    fn about_the_blade_the_general_formula_is_the_same() {
        for k in 0..50 {
            let (lean, theta) = (0.03 * f64::from(k) - 0.7, 0.7 * f64::from(k) - 9.0);
            let cone = Cone::about_blade(lean);
            let (sb, cb) = lean.sin_cos();
            let (st, ct) = theta.sin_cos();
            let long = cone.axis * sb + (cone.reference * ct + cone.axis.cross(&cone.reference) * st) * cb;
            assert_eq!(cone.tool_axis(theta), long);
        }
    }

    proptest! {
        #[test]
        fn a_cone_between_two_ends_at_them(a in cone(), b in cone(), theta in -4.0..4.0f64) {
            for (share, end) in [(0.0, a), (1.0, b)] {
                let at = a.between(&b, share);
                prop_assert!((at.tool_axis(theta) - end.tool_axis(theta)).norm() < 1e-9);
            }
            let v = Vector::new(0.3, -2.0, 1.1);
            prop_assert!((a.unseen(&a.seen(&v)) - v).norm() < 1e-12);
            prop_assert!((a.seen(&a.tool_axis(theta)).x - a.lean_rad.sin()).abs() < 1e-12);
            let found = a.theta_of(&a.tool_axis(theta), 1e-6).unwrap();
            prop_assert!((found - theta).sin().abs() < 1e-9);
        }

        /// Whatever references they come with, carried along they are the same.
        #[test]
        fn references_do_not_matter(cones in prop::collection::vec(cone(), 2..6), turns in prop::collection::vec(-7.0..7.0f64, 6)) {
            let turned = cones.iter().zip(&turns).enumerate().map(|(k, (c, t))| {
                let by = UnitQuaternion::from_scaled_axis(c.axis * if k == 0 { 0.0 } else { *t });
                let flip = if k > 0 && *t > 3.0 { -1.0 } else { 1.0 };
                Cone { axis: c.axis * flip, reference: by * c.reference, lean_rad: c.lean_rad * flip }
            });
            let (plain, turned) = (Cones::along(cones.clone()), Cones::along(turned.collect()));
            for k in 0..cones.len() {
                let (a, b) = (plain.at(k), turned.at(k));
                prop_assert!((a.tool_axis(1.0) - b.tool_axis(1.0)).norm() < 1e-9);
            }
        }
    }
}
