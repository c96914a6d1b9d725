//! Which tool axes are free at a place, all over the sphere.

use std::f64::consts::PI;

use super::channel::Binding;
use crate::geometry::Vector;

/// What is known of a cell.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum CellState {
    /// The tool is clear with every axis of it.
    Free,
    /// The tool is too near with every axis of it; by which of [`FreeSphere::bindings`].
    Taken(u32),
    /// It is of the least size, and neither is shown.
    Open,
}

/// A spherical triangle of tool axes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SphereCell {
    /// Unit vectors, blade frame, counter-clockwise seen from outside.
    pub corners: [Vector; 3],
    /// What is known of it.
    pub state: CellState,
}

impl SphereCell {
    /// Its solid angle, sr (A. Van Oosterom and J. Strackee, The solid angle of a plane triangle,
    /// IEEE Transactions on Biomedical Engineering 30, 1983).
    pub fn area_sr(&self) -> f64 {
        let [a, b, c] = &self.corners;
        2.0 * a.dot(&b.cross(c)).atan2(1.0 + a.dot(b) + b.dot(c) + c.dot(a))
    }

    /// Whether an axis lies in it; on its border within rounding.
    pub fn holds(&self, axis: &Vector) -> bool {
        let [a, b, c] = &self.corners;
        [(a, b), (b, c), (c, a)].iter().all(|(p, q)| p.cross(q).dot(axis) >= -1e-12)
    }
}

/// The eight octants, each with its corners counter-clockwise seen from outside: what all cells are
/// quartered from.
pub fn octants() -> [[Vector; 3]; 8] {
    let mut out = [[Vector::zeros(); 3]; 8];
    for (k, corners) in out.iter_mut().enumerate() {
        let sign = |bit: usize| if k >> bit & 1 == 0 { 1.0 } else { -1.0 };
        let [x, y, z] = [Vector::x() * sign(0), Vector::y() * sign(1), Vector::z() * sign(2)];
        *corners = if sign(0) * sign(1) * sign(2) > 0.0 { [x, y, z] } else { [x, z, y] };
    }
    out
}

/// The four triangles that a spherical triangle is cut into along the middles of its sides: one at
/// each corner, then that in the middle.
pub fn quarters([a, b, c]: &[Vector; 3]) -> [[Vector; 3]; 4] {
    let [ab, bc, ca] = [a + b, b + c, c + a].map(|m| m.normalize());
    [[*a, ab, ca], [ab, *b, bc], [ca, bc, *c], [ab, bc, ca]]
}

/// The free tool axes at a place.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct FreeSphere {
    /// They cover the sphere: quarters of quarters of the [`octants`], in that order.
    pub cells: Vec<SphereCell>,
    /// What takes cells.
    pub bindings: Vec<Binding>,
}

impl FreeSphere {
    /// Shares of the sphere that are free, taken and open.
    pub fn shares(&self) -> [f64; 3] {
        let mut shares = [0.0; 3];
        for c in &self.cells {
            let k = match c.state {
                CellState::Free => 0,
                CellState::Taken(_) => 1,
                CellState::Open => 2,
            };
            shares[k] += c.area_sr() / (4.0 * PI);
        }
        shares
    }

    /// The cell in which an axis lies; `None` for what is no direction.
    pub fn cell_at(&self, axis: &Vector) -> Option<&SphereCell> {
        let axis = axis.try_normalize(1e-12)?;
        self.cells.iter().find(|c| c.holds(&axis))
    }
}

/// The free tool axes at some locations of a path.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct FreeAlong {
    /// Rows of the path, and what is free there.
    pub maps: Vec<(usize, FreeSphere)>,
    /// For each location of the path which of the maps is that of the location nearest to it, by
    /// place and surface normal.
    pub nearest: Vec<usize>,
}
