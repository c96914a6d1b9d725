//! Chains of axes: forward kinematics as a product of motions, inverse kinematics in closed form.
//!
//! A chain lists the axes from the workpiece to the tool. Every axis is a motion `E(q)` of all that
//! follows it in the list, against all that comes before: a shift by `q` along a direction, or the
//! right-hand turn by `q` about a line. Directions and lines are those of the machine while all
//! axes read 0. So the tool, seen from the workpiece, is at (product of exponentials; Brockett
//! 1984, Murray, Li and Sastry 1994, chapter 3)
//!
//! ```text
//! T(q) = E₁(q₁) E₂(q₂) … Eₙ(qₙ),     ball centre  c = M⁻¹ T (g − L a₀),     tool axis  a = M⁻¹ T
//! a₀
//! ```
//!
//! with the gauge point `g` and the tool axis `a₀` while all axes read 0, the length `L` from ball
//! centre to gauge point, and the place `M` of the blade. This is the sense of ISO 841 for every
//! axis: positive is the tool going round, or along, the workpiece, whichever of the two really
//! moves.
//!
//! ## Rotary axes
//! With directions `u` and `v` of the first and the second rotary axis (from the workpiece), and
//! `a` the tool axis wanted, `u·a = u·Rᵥ(q₂) a₀`, that is
//!
//! ```text
//! k₀ + ρ cos(q₂ − φ) = u·a,   k₀ = (u·v)(v·a₀),   ρ cos φ = u·a₀ − k₀,   ρ sin φ = u·(v × a₀)
//! q₂ = φ ± arccos((u·a − k₀)/ρ),   q₁: the angle about u from Rᵥ(q₂) a₀ to a
//! ```
//!
//! The sign is one of two branches. A plan keeps one branch. The tool axis runs round a cone about
//! the blade axis, so `u·a` has a least and a greatest value, and so has `q₂`. The branch whose
//! `q₂` keeps within travel is taken; of two, the one that turns less far from 0.
//!
//! Where the first rotary axis is along the blade axis, `q₂` stands still and `q₁` turns as `θ`
//! does: four axes move. Otherwise five move at once. `q₁` then follows `θ` over many turns where
//! the cone goes round `u`, and swings to and fro where it does not. In both cases `q₁` is within
//! half a turn of a line. The line goes through the place where the cone is symmetric to the plane
//! of `u` and the blade axis. So `q₁` is a function of `θ` alone.
//!
//! ## Linear axes
//! What they shift adds up: with the rotary axes known, their positions solve three linear
//! equations, wherever in the chain they are.

use std::f64::consts::{FRAC_PI_2, TAU};

use nalgebra::{Matrix3, Unit, UnitQuaternion};

use super::axis::Axis;
use crate::artifact::Axes;
use crate::error::{Error, Infeasible, Result, Stage};
use crate::geometry::{Point, Rigid, Vector};
use crate::numerics::angle::within_half_turn;
use crate::tool;

mod series;

/// Directions nearer to one another than this are parallel, rad.
const PARALLEL_RAD: f64 = 1e-9;
/// The tool axis must keep this far from the first rotary axis, rad: at 0 that axis would have to
/// turn at once.
const SINGULAR_RAD: f64 = 1e-3;
/// Rounding of a cosine at the end of what an axis can reach.
const ROUNDING: f64 = 1e-9;
/// The same for a tool axis that was read from a program: its words are rounded. What is reached is
/// a position; it is the axis there that counts.
const WORDS: f64 = 1e-4;

/// Angles are counted from half a turn before this one on, rad: not from where blades are clamped,
/// at which rounding would decide the turn.
const CUT_RAD: f64 = 0.1;

/// A rotary axis of a chain.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Turn {
    direction: Unit<Vector>,
    point: Point,
    travel: Option<[f64; 2]>,
}

impl Turn {
    fn of(axis: &Axis) -> Self {
        Turn { direction: axis.direction, point: axis.point, travel: axis.limits.travel }
    }
    fn rotation(&self, q: f64) -> UnitQuaternion<f64> {
        UnitQuaternion::from_axis_angle(&self.direction, q)
    }
    fn motion(&self, rotation: UnitQuaternion<f64>) -> Rigid {
        Rigid::from_parts((self.point - rotation * self.point).into(), rotation)
    }
}

/// Columns of a head's axes in the rows of the machine.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Columns {
    linear: [usize; 3],
    /// From the workpiece.
    first: usize,
    /// None: a head of four axes.
    second: Option<usize>,
}

/// Where the tool is, in the blade frame.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Pose {
    /// Ball centre, mm.
    pub centre: Point,
    /// Tool axis, unit, from tip to spindle.
    pub axis: Vector,
}

impl Pose {
    /// The tool tip of a ball of that radius, mm.
    pub fn tip(&self, radius_mm: f64) -> Point {
        self.centre - self.axis * radius_mm
    }
}

/// A tool of the machine and the axes between the workpiece and it, ready to be computed with.
#[derive(Clone, Debug, PartialEq)]
pub struct Head {
    columns: Columns,
    first: Turn,
    second: Option<Turn>,
    /// X, Y, Z: direction, and how many rotary axes come before.
    linear: [(Vector, usize); 3],
    gauge: Point,
    tool: Vector,
    /// Blade frame to the workpiece's side of the chain, and back.
    mount: Rigid,
    blade: Rigid,
    /// The first rotary axis in the blade frame.
    first_in_blade: Vector,
    /// `k₀`, `ρ`, `φ` of the module's page; `None` for four axes, or a second axis that is along
    /// the first or along the tool.
    tilt: Option<[f64; 3]>,
}

/// How the rotary axes stand along a cone of tool axes.
#[derive(Clone, Copy, Debug)]
struct Posture {
    /// Sign of the branch.
    sign: f64,
    /// Whole turns added to the second rotary axis, rad.
    shift: f64,
    /// How far the second rotary axis leaves its travel, rad.
    excess: f64,
}

/// What the first rotary axis carries while the second stands still, in machine coordinates with
/// the first at 0.
#[derive(Clone, Copy, Debug)]
struct Carried {
    /// The ball centre with X, Y, Z at 0.
    ball: Point,
    /// The tool axis.
    tool: Vector,
    /// Directions of X, Y, Z.
    linear: [Vector; 3],
}

/// A head that keeps one lean while the first rotary axis, along the blade axis, turns: all that
/// does not change with the ball centre and `θ`.
#[derive(Clone, Copy, Debug)]
pub(super) struct Held {
    lean_rad: f64,
    /// Positions of the rotary axes at `θ = 0`.
    rotary: [f64; 2],
    /// How the first turns with `θ`: 1 or -1.
    sense: f64,
    carried: Carried,
}

impl Held {
    /// Whether this is the head at that lean, rad.
    pub(super) fn is_at(&self, lean_rad: f64) -> bool {
        self.lean_rad == lean_rad
    }
}

impl Head {
    /// A head on some axes of a machine, `links` being their columns from the workpiece to the
    /// tool. `spindle`: gauge point and tool axis while all axes read 0. `mount`: blade frame to
    /// machine coordinates then. `None` where the links are not three linear axes and one or two
    /// rotary ones.
    pub(super) fn new(axes: &[Axis], links: &[usize], spindle: (Point, Unit<Vector>), mount: Rigid) -> Option<Self> {
        let is_rotary = |k: &usize| axes.get(*k).is_some_and(Axis::is_rotary);
        let rotary: Vec<usize> = links.iter().copied().filter(is_rotary).collect();
        let (first, second) = match rotary[..] {
            [first] => (first, None),
            [first, second] => (first, Some(second)),
            _ => return None,
        };
        let mut columns = Columns { linear: [usize::MAX; 3], first, second };
        let mut linear = [(Vector::zeros(), 0); 3];
        for (at, k) in links.iter().enumerate() {
            let axis = axes.get(*k)?;
            if let Some(own) = axis.letter.linear() {
                columns.linear[own] = *k;
                linear[own] = (axis.direction.into_inner(), links[..at].iter().filter(|k| is_rotary(k)).count());
            }
        }
        let (gauge, tool) = (spindle.0, spindle.1.into_inner());
        let blade = mount.inverse();
        let mut head = Head {
            columns,
            first: Turn::of(&axes[first]),
            second: second.map(|k| Turn::of(&axes[k])),
            linear,
            gauge,
            tool,
            mount,
            blade,
            first_in_blade: Vector::zeros(),
            tilt: None,
        };
        head.prepare();
        (!columns.linear.contains(&usize::MAX)).then_some(head)
    }

    /// The same head where directions, places or limits of the machine's axes are others.
    pub(super) fn with_axes(&self, axes: &[Axis]) -> Self {
        let mut head = self.clone();
        head.first = Turn::of(&axes[self.columns.first]);
        head.second = self.columns.second.map(|k| Turn::of(&axes[k]));
        for (own, k) in head.linear.iter_mut().zip(self.columns.linear) {
            own.0 = axes[k].direction.into_inner();
        }
        head.prepare();
        head
    }

    /// The same head with the blade clamped otherwise: blade frame to machine coordinates while all
    /// axes read 0.
    pub(super) fn with_mount(&self, mount: Rigid) -> Self {
        let mut head = self.clone();
        (head.mount, head.blade) = (mount, mount.inverse());
        head.prepare();
        head
    }

    /// What follows from directions alone.
    fn prepare(&mut self) {
        let u = self.first.direction;
        self.first_in_blade = self.blade.rotation * u.into_inner();
        self.tilt = self.second.and_then(|s| {
            let k0 = u.dot(&s.direction) * s.direction.dot(&self.tool);
            let [c, s] = [u.dot(&self.tool) - k0, u.dot(&s.direction.cross(&self.tool))];
            let rho = c.hypot(s);
            (rho > PARALLEL_RAD).then(|| [k0, rho, s.atan2(c)])
        });
    }

    /// Columns of X, Y and Z.
    pub fn linear(&self) -> [usize; 3] {
        self.columns.linear
    }

    /// Columns of the rotary axes, that nearest to the workpiece first.
    pub fn rotary(&self) -> impl Iterator<Item = usize> + Clone + use<> {
        [Some(self.columns.first), self.columns.second].into_iter().flatten()
    }

    /// Column of the rotary axis nearest to the workpiece.
    pub fn turning_axis(&self) -> usize {
        self.columns.first
    }

    /// Blade frame to machine coordinates while all axes read 0.
    pub(super) fn mount(&self) -> &Rigid {
        &self.mount
    }

    /// The tool axis in machine coordinates while all axes read 0.
    pub(super) fn tool(&self) -> &Vector {
        &self.tool
    }

    /// How far a point lies behind the gauge line along the tool while all axes read 0, mm.
    pub(super) fn along_tool_mm(&self, p: &Point) -> f64 {
        (p - self.gauge).dot(&self.tool)
    }

    /// Puts positions of the rotary axes into a row.
    fn put(&self, [q1, q2]: [f64; 2], at: &mut Axes) {
        at[self.columns.first] = q1;
        if let Some(k) = self.columns.second {
            at[k] = q2;
        }
    }

    /// Positions of the rotary axes in a row.
    fn rotary_in(&self, at: &[f64]) -> [f64; 2] {
        [at[self.columns.first], self.columns.second.map_or(0.0, |k| at[k])]
    }

    /// A point on the rotary axis nearest to the part, the one nearest to the part's origin, and
    /// its direction, frame of the part.
    pub(super) fn first_axis_in_part(&self) -> (Point, Vector) {
        let (point, along) = (self.blade * self.first.point, self.first_in_blade);
        (point - along * point.coords.dot(&along), along)
    }

    /// Distance of a point of the part from the rotary axis nearest to it, mm.
    pub(super) fn off_axis_mm(&self, p: &Point) -> f64 {
        (self.mount * p - self.first.point).cross(&self.first.direction).norm()
    }

    /// All that follows the first rotary axis, the second at `q2`. `gauge_length_mm`: from the ball
    /// centre to the spindle's gauge line.
    fn carried(&self, q2: f64, gauge_length_mm: f64) -> Carried {
        let (ball, tool) = (self.gauge - self.tool * gauge_length_mm, self.tool);
        let linear = self.linear.map(|(direction, _)| direction);
        let Some(second) = self.second else { return Carried { ball, tool, linear } };
        let turn = second.rotation(q2);
        let turned = |(direction, before): (Vector, usize)| if before == 2 { turn * direction } else { direction };
        Carried { ball: second.motion(turn) * ball, tool: turn * tool, linear: self.linear.map(turned) }
    }

    /// Shifts of X, Y, Z seen from the workpiece, in columns, the first rotary axis turned.
    fn shifts(&self, first: &UnitQuaternion<f64>, carried: &Carried) -> Matrix3<f64> {
        let column = |k: usize| if self.linear[k].1 == 0 { carried.linear[k] } else { first * carried.linear[k] };
        Matrix3::from_columns(&[column(0), column(1), column(2)])
    }

    /// Whether X, Y, Z reach all places with the rotary axes at 0.
    pub(super) fn spans_space(&self) -> bool {
        self.shifts(&self.first.rotation(0.0), &self.carried(0.0, 0.0)).determinant().abs() > 1e-3
    }

    /// The pose of the tool in the blade frame at positions of the machine's axes (mm, rad).
    /// `gauge_length_mm`: from the ball centre to the spindle's gauge line.
    pub fn forward(&self, row: &[f64], gauge_length_mm: f64) -> Pose {
        let [q1, q2] = self.rotary_in(row);
        let (first, carried) = (self.first.rotation(q1), self.carried(q2, gauge_length_mm));
        let shift = Vector::from(self.columns.linear.map(|k| row[k]));
        let centre = self.first.motion(first) * carried.ball + self.shifts(&first, &carried) * shift;
        Pose { centre: self.blade * centre, axis: self.blade * (first * carried.tool) }
    }

    /// From the frame fixed to the workpiece, the rotary axes turned as in a row, to the blade
    /// frame.
    pub(super) fn blade_from_turned(&self, row: &[f64]) -> Rigid {
        let [q1, q2] = self.rotary_in(row);
        let first = self.first.motion(self.first.rotation(q1));
        self.blade * self.second.map_or(first, |s| first * s.motion(s.rotation(q2))) * self.mount
    }

    /// The tool axis where the rotary axes stand, blade frame.
    pub(super) fn axis(&self, row: &[f64]) -> Vector {
        self.axis_of(self.rotary_in(row))
    }

    fn axis_of(&self, [q1, q2]: [f64; 2]) -> Vector {
        self.blade * (self.first.rotation(q1) * self.carried(q2, 0.0).tool)
    }

    /// Moves X, Y, Z in a row so that the ball comes there; not numbers where their directions do
    /// not reach it.
    pub(super) fn place_linear(&self, centre: &Point, gauge_length_mm: f64, row: &mut Axes) {
        let [q1, q2] = self.rotary_in(row);
        self.place_carried(centre, q1, &self.carried(q2, gauge_length_mm), row);
    }

    fn place_carried(&self, centre: &Point, q1: f64, carried: &Carried, row: &mut Axes) {
        let first = self.first.rotation(q1);
        let from = self.first.motion(first) * carried.ball;
        let solved = self.shifts(&first, carried).try_inverse().map(|inverse| inverse * (self.mount * centre - from));
        for (k, own) in self.columns.linear.into_iter().enumerate() {
            row[own] = solved.map_or(f64::NAN, |s| s[k]);
        }
    }

    /// The head with a lean kept; `None` where other axes than the first move as well, or the lean
    /// is out of reach.
    pub(super) fn held(&self, lean_rad: f64, gauge_length_mm: f64) -> Option<Held> {
        let sense = self.along_blade()?;
        let rotary = self.on_branch(&self.posture(lean_rad)?, lean_rad, 0.0)?;
        Some(Held { lean_rad, rotary, sense, carried: self.carried(rotary[1], gauge_length_mm) })
    }

    /// As [`Head::place`] at the lean that is held.
    pub(super) fn place_held(&self, centre: &Point, theta_rad: f64, held: &Held, row: &mut Axes) {
        let q1 = held.rotary[0] + held.sense * theta_rad;
        self.put([q1, held.rotary[1]], row);
        self.place_carried(centre, q1, &held.carried, row);
    }

    /// Moves the head's axes in a row so that the tool stands at a ball centre of the blade frame
    /// with an angle `θ` and a lean; not numbers where it does not reach that. Other heads' own
    /// axes stay.
    pub fn place(&self, centre: &Point, theta_rad: f64, lean_rad: f64, gauge_length_mm: f64, row: &mut Axes) {
        self.place_rotary(theta_rad, lean_rad, row);
        self.place_linear(centre, gauge_length_mm, row);
    }

    /// Turns the rotary axes in a row to an angle `θ` and a lean.
    pub(super) fn place_rotary(&self, theta_rad: f64, lean_rad: f64, row: &mut Axes) {
        self.put(self.rotary_of(theta_rad, lean_rad), row);
    }

    /// Positions of the second axis of both branches for a tool axis with that cosine to the first;
    /// `None`: out of reach by more than `slack`.
    fn second_of(&self, cosine: f64, slack: f64) -> Option<[f64; 2]> {
        let Some([k0, rho, phi]) = self.tilt else {
            let fixed = self.second.is_none() && (self.first.direction.dot(&self.tool) - cosine).abs() < slack;
            return fixed.then_some([0.0; 2]);
        };
        let share = (cosine - k0) / rho;
        let angle = (share.abs() <= 1.0 + slack).then(|| share.clamp(-1.0, 1.0).acos())?;
        Some([phi + angle, phi - angle])
    }

    /// Least and greatest cosine between the first rotary axis and the tool axes of a cone.
    fn cosines(&self, lean_rad: f64) -> [f64; 2] {
        let w = self.first_in_blade;
        let across = w.y.hypot(w.z);
        let (along, apart) = (w.x * lean_rad.sin(), across * lean_rad.cos());
        // Parallel: one value, to the bit.
        if across < PARALLEL_RAD { [along; 2] } else { [along - apart, along + apart] }
    }

    /// Whether the first rotary axis is along the blade axis, and its sense then: 1 along x, -1
    /// against it.
    pub(super) fn along_blade(&self) -> Option<f64> {
        let w = self.first_in_blade;
        (w.y.hypot(w.z) < PARALLEL_RAD).then(|| w.x.signum())
    }

    /// The branch for a cone; `None`: a part of the cone is out of reach.
    fn posture(&self, lean_rad: f64) -> Option<Posture> {
        let [least, greatest] = self.cosines(lean_rad);
        let low = self.second_of(least, ROUNDING)?;
        let high = if greatest == least { low } else { self.second_of(greatest, ROUNDING)? };
        let one = |k: usize| {
            let (a, b) = (low[k].min(high[k]), low[k].max(high[k]));
            let (shift, excess) = placed([a, b], self.second.and_then(|s| s.travel));
            let farthest = (a + shift).abs().max((b + shift).abs());
            (Posture { sign: if k == 0 { 1.0 } else { -1.0 }, shift, excess }, farthest, a + b + 2.0 * shift)
        };
        let [p, n] = [one(0), one(1)];
        // Of equals the one on the positive side.
        let order = (p.0.excess - n.0.excess, p.1 - n.1, n.2 - p.2);
        let first_of = [order.0, order.1, order.2].into_iter().find(|d| d.abs() > ROUNDING).unwrap_or(0.0);
        Some(if first_of <= 0.0 { p.0 } else { n.0 })
    }

    /// Position of the first axis, within half a turn, that brings the tool axis over the
    /// workpiece's `a` with the second at `q2`.
    fn first_of(&self, a: &Vector, q2: f64) -> f64 {
        let u = self.first.direction;
        let v = self.second.map_or(self.tool, |s| s.rotation(q2) * self.tool);
        u.dot(&v.cross(a)).atan2(v.dot(a) - u.dot(&v) * u.dot(a))
    }

    /// Rotary positions of one branch for a lean and an angle `θ`, the first within half a turn.
    fn on_branch(&self, posture: &Posture, lean_rad: f64, theta: f64) -> Option<[f64; 2]> {
        let a = self.mount * tool::axis(lean_rad, theta);
        let both = self.second_of(self.first.direction.dot(&a), ROUNDING)?;
        let q2 = both[usize::from(posture.sign < 0.0)];
        Some([self.first_of(&a, q2), q2 + posture.shift])
    }

    /// Rotary positions for a lean and an angle `θ` over all turns; not numbers where the lean is
    /// out of reach.
    fn rotary_of(&self, theta: f64, lean_rad: f64) -> [f64; 2] {
        let Some(posture) = self.posture(lean_rad) else { return [f64::NAN; 2] };
        let one = |theta: f64| self.on_branch(&posture, lean_rad, theta);
        if let Some(sense) = self.along_blade() {
            return one(0.0).map_or([f64::NAN; 2], |[q1, q2]| [q1 + sense * theta, q2]);
        }
        let w = self.first_in_blade;
        let middle = w.z.atan2(w.y);
        let (Some([centre, _]), Some([q1, q2])) = (one(middle), one(theta)) else { return [f64::NAN; 2] };
        let (apart, half) = (w.x.clamp(-1.0, 1.0).acos(), FRAC_PI_2 - lean_rad);
        // How often the axis turns while θ turns once.
        let winds = f64::from(i8::from(apart < half) - i8::from(std::f64::consts::PI - apart < half));
        let swing = if winds == 0.0 { FRAC_PI_2 } else { 0.0 };
        let (shift, _) = placed([centre - swing, centre + swing], self.first.travel);
        let near = centre + shift + winds * (theta - middle);
        [near + within_half_turn(q1 - near), q2]
    }

    /// The row `near`, but the rotary axes along a tool axis of the blade frame: of both branches
    /// and all turns those nearest, within travel where they can be.
    pub(super) fn rotary_of_axis(&self, axis: &Vector, near: &[f64]) -> Option<Axes> {
        let mut row = Axes::from(near);
        self.put(self.along(axis, self.rotary_in(near))?, &mut row);
        Some(row)
    }

    /// The row `near`, but the rotary axes as they reach a tool axis in the other way than there.
    pub(super) fn other_posture(&self, axis: &Vector, near: &[f64]) -> Option<Axes> {
        let (a, at) = (self.mount * axis.try_normalize(f64::MIN_POSITIVE)?, self.rotary_in(near));
        let both = self.second_of(self.first.direction.dot(&a), WORDS)?;
        let off = |q2: &f64| within_half_turn(q2 - at[1]).abs();
        let q2 = both.into_iter().max_by(|a, b| off(a).total_cmp(&off(b)))?;
        let mut row = Axes::from(near);
        let [q1, q2] = [self.first_of(&a, q2) - at[0], q2 - at[1]].map(within_half_turn);
        self.put([at[0] + q1, at[1] + q2], &mut row);
        Some(row)
    }

    fn along(&self, axis: &Vector, near: [f64; 2]) -> Option<[f64; 2]> {
        let a = self.mount * axis.try_normalize(f64::MIN_POSITIVE)?;
        let cosine = self.first.direction.dot(&a);
        if !(1.0 - cosine.abs() > 1e-12 && near.iter().all(|v| v.is_finite())) {
            return None;
        }
        let reached = self.second_of(cosine, WORDS)?.map(|q2| {
            let q1 = self.first_of(&a, q2);
            let nearest = [near[0] + within_half_turn(q1 - near[0]), near[1] + within_half_turn(q2 - near[1])];
            let outside = |turn: Option<Turn>, q: f64| {
                let [lo, hi] = turn.and_then(|t| t.travel).unwrap_or([f64::NEG_INFINITY, f64::INFINITY]);
                (lo - q).max(q - hi).max(0.0)
            };
            // An axis with ends of travel may have to come from the other side.
            let turned = |k: usize, turn: Option<Turn>| {
                let tries = [0.0, TAU, -TAU].map(|t| nearest[k] + t);
                tries.into_iter().min_by(|a, b| outside(turn, *a).total_cmp(&outside(turn, *b))).unwrap_or(nearest[k])
            };
            let q = [turned(0, Some(self.first)), turned(1, self.second)];
            let out = outside(Some(self.first), q[0]) + outside(self.second, q[1]);
            (out, (q[0] - near[0]).abs() + (q[1] - near[1]).abs(), q)
        });
        let [p, n] = reached;
        let better = if (p.0 - n.0).abs() > ROUNDING { p.0 < n.0 } else { p.1 <= n.1 };
        Some(if better { p.2 } else { n.2 })
    }

    /// `θ` and lean of the tool axis where the rotary axes stand; `θ` over all turns where the
    /// first axis is along the blade, else nearest to `near`.
    pub(super) fn theta_and_lean(&self, row: &[f64], near: f64) -> [f64; 2] {
        let rotary = self.rotary_in(row);
        if let Some(sense) = self.along_blade() {
            let a = self.axis_of([0.0, rotary[1]]);
            let theta = CUT_RAD + within_half_turn(a.z.atan2(a.y) - CUT_RAD);
            return [theta + sense * rotary[0], a.x.atan2(a.y.hypot(a.z))];
        }
        let a = self.axis_of(rotary);
        let theta = a.z.atan2(a.y);
        [near + within_half_turn(theta - near), a.x.atan2(a.y.hypot(a.z))]
    }

    /// `θ` between the ends of travel of the first rotary axis, where it turns the blade.
    pub(super) fn theta_limits(&self, lean_rad: f64) -> Option<[f64; 2]> {
        let (sense, [lo, hi]) = (self.along_blade()?, self.first.travel?);
        let [zero, _] = self.rotary_of(0.0, lean_rad);
        let [a, b] = [lo, hi].map(|q| sense * (q - zero));
        zero.is_finite().then(|| [a.min(b), a.max(b)])
    }

    /// Whether a lean of the tool can be kept all round the blade.
    pub(super) fn check_lean(&self, lean_rad: f64, axes: &[Axis]) -> Result<()> {
        let name = |column: usize| axes[column].name.as_str();
        let (first, second) = (name(self.columns.first), self.columns.second.map_or("", name));
        let deg = lean_rad.to_degrees();
        let no = |what: String, advice: &str, since: Infeasible| {
            Err(Error::infeasible(Stage::Machine, what, since).advise(advice.to_owned()))
        };
        let unreached = |fixed_deg: Option<f64>| Infeasible::LeanOutOfReach { lean_deg: deg, fixed_deg };
        let Some(posture) = self.posture(lean_rad) else {
            return match (self.second, self.along_blade()) {
                (None, Some(sense)) => {
                    let fixed = (sense * self.first.direction.dot(&self.tool)).clamp(-1.0, 1.0).asin().to_degrees();
                    no(
                        format!(
                            "the machine has no axis that leans the tool: it always leans by {fixed:.6} deg, machine.b_deg is {deg}"
                        ),
                        "set machine.b_deg to that",
                        unreached(Some(fixed)),
                    )
                }
                (None, None) => no(
                    format!("axis {first} is not along the blade axis, and there is no other rotary axis"),
                    "mount the blade along it (mount.along)",
                    unreached(None),
                ),
                _ => no(
                    format!(
                        "the rotary axes {first} and {second} do not reach the tool axis all round the blade at a lean of {deg} deg"
                    ),
                    "mount the blade along the first rotary axis (mount.along), or change machine.b_deg",
                    unreached(None),
                ),
            };
        };
        let off = self.cosines(lean_rad).map(|c| 1.0 - c.abs()).into_iter().fold(1.0, f64::min);
        if off < 1.0 - SINGULAR_RAD.cos() {
            let what = format!(
                "at a lean of {deg} deg the tool axis comes along axis {first}, which would have to turn by any angle at once (singular)"
            );
            let since = Infeasible::Singular { lean_deg: deg, axis: first.to_owned() };
            return no(what, "change machine.b_deg, or mount the blade otherwise (mount.along)", since);
        }
        if posture.excess > ROUNDING {
            let what = format!(
                "at a lean of {deg} deg axis {second} would leave its travel by {:.3} deg on either branch",
                posture.excess.to_degrees()
            );
            let (axis, excess_deg) = (second.to_owned(), posture.excess.to_degrees());
            let since = Infeasible::BeyondTravel { lean_deg: deg, axis, excess_deg };
            return no(what, "change machine.b_deg, or mount the blade otherwise (mount.along)", since);
        }
        Ok(())
    }
}

/// The whole turns that bring a range into a travel, or nearest to 0 without one, and how far it
/// stays outside.
fn placed([a, b]: [f64; 2], travel: Option<[f64; 2]>) -> (f64, f64) {
    let base = -TAU * (0.5 * (a + b) / TAU).round();
    let Some([lo, hi]) = travel else { return (base, 0.0) };
    let outside = |shift: f64| (lo - a - shift).max(b + shift - hi).max(0.0);
    let turns = [0.0, 1.0, -1.0, 2.0, -2.0].map(|k| base + k * TAU);
    let best = turns.into_iter().min_by(|s, t| outside(*s).total_cmp(&outside(*t))).unwrap_or(base);
    (best, outside(best))
}
