//! Turns that are first-order neighbours of one another, for comparison: those of a published
//! method for turn-milling blades (Shi, Qiao and Rao).
//!
//! Contacts lie on a face `S(u, v)` with the first fundamental form `E, F, G`. From a contact whose
//! turn goes on along `(u', v')` the neighbour lies `(Δu, Δv)` further on, square to the turn and
//! the width `W` away, both to first order:
//! ```text
//! E Δu u' + F (Δu v' + Δv u') + G Δv v' = 0,   E Δu² + 2F Δu Δv + G Δv² = W²
//! Δu = ∓W (F u' + G v') / n,   Δv = ±W (E u' + F v') / n
//! n = √(EG − F²) √(E u'² + 2F u'v' + G v'²)
//! ```
//! Printed, the second term of the condition is `F (Δu u' + Δv v')` and both increments have one
//! sign: such a step is not square to the turn. With the radius `r` of the part across the turn and
//! the ball's radius `R`, the printed widths for the scallop `h` are
//! ```text
//! plane 2√(2Rh − h²),   convex 2√(2hR) √(r/(r + R)),   hollow 2√(2hR) √(r/(r − R))
//! ```
//! Nothing is measured: a width that is of first order is too large by what is of second order in
//! the scallop, a turn askew to the principal directions needs another one
//! ([`crate::tool::scallop`]), and equal steps of parameters are not equal ways along the face.
//!
//! The publication knows one smooth face. Here a step over the end of a face's parameters goes on
//! straight. A contact on an edge, where no face is square to the ball's normal, has no curvature:
//! the ball goes on as over a plane. Stretches that run backwards or into one another are left out
//! as on turns of constant scallop, and places at the end of the region wait there.

use super::folds::without_cusps;
use super::neighbour::{Heading, Next};
use super::node::Node;
use super::overrun::Overrun;
use super::{By, Front};
use crate::geometry::nurbs::{NurbsSurface, Principal, SurfaceDerivatives};
use crate::geometry::{Point, Vector};
use crate::parallel;
use crate::path::curve;
use crate::path::level::{LevelSet, Touch};

/// A normal of the ball farther than this from that of the face, cosine, is that of an edge: 1°.
const ON_FACE: f64 = 0.999_85;
/// Flatter than this, curvature times radius of the ball, a face is a plane.
const FLAT: f64 = 1e-9;
/// The ball comes off the guess by no more than this share of its radius, and of the width.
const REACH: f64 = 0.25;
/// Halvings towards a bound: the width times 10⁻⁸.
const HALVINGS: usize = 27;
/// A way between two neighbours of a ring that goes forwards by less than this share of itself, and
/// of the ring's own, goes backwards.
const FORWARD: f64 = 0.1;

/// Width of a strip as printed, mm, for a part with the curvature `curvature_per_mm` across the
/// turn, positive where convex; `None` where the ball does not fit.
fn printed_width_mm(radius_mm: f64, scallop_mm: f64, curvature_per_mm: f64) -> Option<f64> {
    let (r, h, bend) = (radius_mm, scallop_mm, curvature_per_mm * radius_mm);
    if bend.abs() < FLAT {
        return Some(2.0 * (2.0 * r * h - h * h).sqrt());
    }
    let width = 2.0 * (2.0 * h * r / (1.0 + bend)).sqrt();
    (1.0 + bend > 0.0 && width.is_finite()).then_some(width)
}

/// The first fundamental form of a face at a place: `E`, `F` and `G`.
#[derive(Clone, Copy, Debug)]
struct FirstForm([f64; 3]);

impl FirstForm {
    fn of(du: &Vector, dv: &Vector) -> Self {
        FirstForm([du.norm_squared(), du.dot(dv), dv.norm_squared()])
    }

    /// Parameters of the tangent vector `way`, given the derivatives that the form is of.
    fn parameters(&self, [du, dv]: [&Vector; 2], way: &Vector) -> Option<[f64; 2]> {
        let [e, f, g] = self.0;
        let (a, b) = (way.dot(du), way.dot(dv));
        let det = e * g - f * f;
        (det > 0.0).then(|| [(g * a - f * b) / det, (e * b - f * a) / det])
    }

    /// Increments of the parameters to the neighbour at the width `width_mm` of a place whose turn
    /// goes on along `way`, to the left of it seen against `S_u × S_v`. `None` where the form is
    /// degenerate or the way nothing.
    fn increments(&self, [u, v]: [f64; 2], width_mm: f64) -> Option<[f64; 2]> {
        let [e, f, g] = self.0;
        let root = (e * g - f * f).sqrt() * (e * u * u + 2.0 * f * u * v + g * v * v).sqrt();
        let share = width_mm / root;
        let to = [-share * (f * u + g * v), share * (e * u + f * v)];
        (root > 0.0 && to.iter().all(|d| d.is_finite())).then_some(to)
    }
}

/// A face under a contact: itself, the parameters, its derivatives and curvatures there.
type Under<'a> = (&'a NurbsSurface, [f64; 2], SurfaceDerivatives, Principal);

/// The face that a ball touches; `None` on an edge, where no face is square to the ball's normal.
fn face_under<'a>(level: &'a LevelSet, touch: &Touch) -> Option<Under<'a>> {
    let at = level.part.closest(&touch.centre, 1.5 * level.radius_mm)?;
    let surface = &level.part.brep.as_ref()?.faces.get(at.face as usize)?.surface;
    let d = surface.derivatives(at.uv[0], at.uv[1]);
    let bend = level.part.curvature_at(&at)?;
    (d.normal()?.dot(&touch.normal).abs() > ON_FACE).then_some((surface, at.uv, d, bend))
}

/// A step of parameters.
struct OnFace<'a> {
    surface: &'a NurbsSurface,
    from: [f64; 2],
    by: [f64; 2],
    /// The part's outward normal over that of the parameters: 1 or −1.
    outwards: f64,
}

/// Where the neighbours of a place lie.
struct Aside<'a> {
    from: Touch,
    /// The step straight on, mm.
    straight: Vector,
    /// The step on the face; `None` on an edge.
    on_face: Option<OnFace<'a>>,
}

impl<'a> Aside<'a> {
    /// To the right of the way, seen from the tip of the normal. `None` where the ball does not
    /// fit.
    fn of(level: &'a LevelSet, from: &Heading, scallop_mm: f64) -> Option<Self> {
        let (touch, radius_mm) = (from.touch, level.radius_mm);
        let found = face_under(level, &touch);
        let Some((surface, uv, d, bend)) = found else {
            let side = from.along.cross(&touch.normal).try_normalize(1e-9)?;
            let straight = side * printed_width_mm(radius_mm, scallop_mm, 0.0)?;
            return Some(Aside { from: touch, straight, on_face: None });
        };
        let way = way_of_contact(&bend, radius_mm, &from.along)?;
        let form = FirstForm::of(&d.du, &d.dv);
        let unit = form.increments(form.parameters([&d.du, &d.dv], &way)?, 1.0)?;
        let side = d.du * unit[0] + d.dv * unit[1];
        // Left of the way seen against S_u × S_v may be either side of the part's own normal.
        let sign = side.dot(&way.cross(&touch.normal)).signum();
        let across: f64 = (0..2).map(|k| -bend.curvature[k] * side.dot(&bend.direction[k]).powi(2)).sum();
        let width_mm = sign * printed_width_mm(radius_mm, scallop_mm, across)?;
        let outwards = d.normal()?.dot(&touch.normal).signum();
        let on_face = Some(OnFace { surface, from: uv, by: unit.map(|step| step * width_mm), outwards });
        Some(Aside { from: touch, straight: side * width_mm, on_face })
    }

    /// The ball at a share of the step.
    fn at(&self, level: &LevelSet, share: f64) -> Option<Touch> {
        let stays = || {
            let OnFace { surface, from, by, outwards } = self.on_face.as_ref()?;
            let [u, v] = [0, 1].map(|k| from[k] + share * by[k]);
            let [[u0, u1], [v0, v1]] = surface.domain();
            let is_within = (u0..=u1).contains(&u) && (v0..=v1).contains(&v);
            let normal = is_within.then(|| surface.normal(u, v)).flatten()?;
            Some(surface.point(u, v) + normal * (level.radius_mm * outwards))
        };
        let guess = stays().unwrap_or_else(|| self.from.centre + self.straight * share);
        level.touch(&guess, REACH * level.radius_mm + self.straight.norm())
    }
}

/// Unit direction in which the contact goes where the ball's centre goes along `along`. `None`
/// where the ball does not fit.
fn way_of_contact(bend: &Principal, radius_mm: f64, along: &Vector) -> Option<Vector> {
    let shrunk = |k: usize| {
        let fits = 1.0 - bend.curvature[k] * radius_mm;
        (fits > FLAT).then(|| bend.direction[k] * (along.dot(&bend.direction[k]) / fits))
    };
    (shrunk(0)? + shrunk(1)?).try_normalize(1e-12)
}

impl Front<'_> {
    /// Whether turns are first-order neighbours of one another.
    pub fn is_first_order(&self) -> bool {
        self.by != By::Ridges
    }

    /// The first-order neighbour of a place for a scallop, or the last place within bounds on the
    /// way to it; `round` is the turn round the place. `None` where the ball cannot go there.
    pub fn first_order(&self, from: &Heading, round: &[Touch], scallop_mm: f64) -> Option<Next> {
        let (level, bounds) = (self.across.level, &self.across.bounds);
        let aside = Aside::of(level, from, scallop_mm)?;
        let way_to = |t: &Touch| (t.centre - from.touch.centre).norm();
        let full = aside.at(level, 1.0)?;
        if bounds.hold(&full) {
            let next = Next { touch: full, way_mm: way_to(&full), stop: None };
            if face_under(level, &full).is_some() {
                return Some(next);
            }
            let side = (full.centre - from.touch.centre).cross(&from.touch.normal).try_normalize(1e-9);
            let along = side.map_or(from.along, |a| -a);
            return Some(self.across.short_of_an_edge(&Heading { along, ..*from }, round, next));
        }
        let (mut inside, mut beyond) = (from.touch, full);
        let (mut low, mut high) = (0.0, 1.0);
        for _ in 0..HALVINGS {
            let middle = 0.5 * (low + high);
            let touch = aside.at(level, middle)?;
            if bounds.hold(&touch) { (low, inside) = (middle, touch) } else { (high, beyond) = (middle, touch) }
        }
        Some(Next { touch: inside, way_mm: way_to(&inside), stop: Some(bounds.why(&inside, &beyond)) })
    }

    /// The closed ring after a closed ring. `Err`: where the ball cannot go on.
    pub fn next_ring(&self, ring: &[Node]) -> Result<Vec<Node>, Point> {
        let n = ring.len() - 1;
        let touches: Vec<Touch> = ring.iter().map(|node| node.touch).collect();
        let along = curve::tangents(Some(&touches[n - 1].centre), &touches, Some(&touches[1].centre));
        let next = parallel::map(0..n, |i| self.neighbour_of(&ring[i], &touches, along[i], 1.0));
        // The ring once more before and after itself: what is near its seam is near both ends.
        let chain = Overrun::of(&ring[..n], ring, ring[1..].iter().copied());
        let is_open = |i: usize, node: &Node| {
            let way = node.touch.centre - ring[i].touch.centre;
            node.stop.is_some() || !self.overruns(&chain, i, node, &way.cross(&along[i]))
        };
        let found = next.iter().enumerate().filter_map(|(i, node)| node.map(|node| (i, node)));
        let mut kept: Vec<(usize, Node)> = Vec::with_capacity(n);
        let goes_on = |a: &(usize, Node), b: &(usize, Node)| {
            let (step, onward) = (b.1.touch.centre - a.1.touch.centre, along[a.0] + along[b.0]);
            step.dot(&onward) > FORWARD * step.norm() * onward.norm()
        };
        for node in found.filter(|(i, node)| is_open(*i, node)) {
            if kept.last().is_none_or(|last| goes_on(last, &node)) {
                kept.push(node);
            } else {
                kept.pop();
            }
        }
        while kept.len() > 3 && !goes_on(&kept[kept.len() - 1], &kept[0]) {
            kept.pop();
        }
        match self.lost(ring, &next, &kept, n - 1) {
            Some(at) => Err(at),
            None if kept.len() < 3 => Err(touches[0].centre),
            None => {
                let ring: Vec<Node> = kept.iter().chain(kept.first()).map(|k| k.1).collect();
                let ring = Overrun::of(&[], &ring, std::iter::empty()).without_loops();
                Ok(self.spaced(without_cusps(ring)))
            }
        }
    }
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used)]
    use super::*;
    use proptest::prelude::*;

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(500))]
        /// Of the step's inner product with the way, by the form, over the product of the lengths.
        #[test]
        fn the_step_is_square_to_the_turn_and_as_printed_it_is_not(
            scale in [0.1..20.0f64, 0.1..20.0f64], askew in -0.95..0.95f64, angle in 0.0..std::f64::consts::TAU,
            width in 0.01..5.0f64,
        ) {
            let [a, b] = scale;
            let (e, f, g) = (a * a, askew * a * b, b * b);
            let (u, v) = (angle.cos() / a, angle.sin() / b);
            let cosine = |[x, y]: [f64; 2]| {
                let along = (e * u * u + 2.0 * f * u * v + g * v * v).sqrt();
                let across = (e * x * x + 2.0 * f * x * y + g * y * y).sqrt();
                (e * x * u + f * (x * v + y * u) + g * y * v) / (along * across)
            };
            let [x, y] = FirstForm([e, f, g]).increments([u, v], width).unwrap();
            prop_assert!(cosine([x, y]).abs() < 1e-12, "{}", cosine([x, y]));
            let length = (e * x * x + 2.0 * f * x * y + g * y * y).sqrt();
            prop_assert!((length / width - 1.0).abs() < 1e-12, "{length}");
            // Both of one sign. With p = F u + G v and q = E u + F v the step is along (p, q), and
            // its product with the turn is 2 p q: square only where one of them is nothing.
            let printed = cosine([-x, y]);
            let [p, q] = [f * u + g * v, e * u + f * v];
            let along = (e * u * u + 2.0 * f * u * v + g * v * v).sqrt();
            let across = (e * p * p + 2.0 * f * p * q + g * q * q).sqrt();
            prop_assert!((printed.abs() - 2.0 * (p * q).abs() / (along * across)).abs() < 1e-9, "{printed} {p} {q}");
        }
    }

    #[test]
    fn widths_are_those_of_the_published_table() {
        assert!((printed_width_mm(4.0, 0.01, 0.0).unwrap() - 2.0 * (0.08f64 - 1e-4).sqrt()).abs() < 1e-15);
        let root = 2.0 * 0.08f64.sqrt();
        assert!((printed_width_mm(4.0, 0.01, 1.0 / 20.0).unwrap() - root * (20.0f64 / 24.0).sqrt()).abs() < 1e-15);
        assert!((printed_width_mm(4.0, 0.01, -1.0 / 20.0).unwrap() - root * (20.0f64 / 16.0).sqrt()).abs() < 1e-15);
        assert!(printed_width_mm(4.0, 0.01, -0.25).is_none());
    }

    #[test]
    fn a_degenerate_form_has_no_step() {
        assert!(FirstForm([1.0, 1.0, 1.0]).increments([1.0, 0.0], 1.0).is_none());
        assert!(FirstForm([1.0, 0.0, 1.0]).increments([0.0, 0.0], 1.0).is_none());
    }
}
