//! What a cutter with a corner leaves standing between its passes, measured on the swept cutter.
//!
//! As [`audit::scallop`] does with balls, at samples `p` of the surface between passes: the least
//! height `t ≥ 0` at which the normal `p + t n` meets the cutter anywhere on its way. No place of
//! the cutter is farther along the line than it is away, so steps as long as the distance lead to
//! the first place that is met. The distance from a leg is that from the disc at the nearest of its
//! times, less the corner radius; with the axis turning that is sought by golden section, so that
//! heights are samples, not bounds.
//!
//! The cutter's centre does not show beside which passes a place lies: the disc reaches far over
//! it. So contacts do, the places where the part is nearest to the disc at the ends of each leg.
//!
//! What no cutter could reach counts too: on hollow ground as left standing.
//!
//! [`audit::scallop`]: super::super::audit::scallop

use parry3d_f64::bounding_volume::Aabb as ParryAabb;
use parry3d_f64::math::Vector as ParryVector;
use parry3d_f64::partitioning::{Bvh, BvhBuildStrategy, TraversalAction};

use super::super::between::{Height, Heights, LEAST_REACH_MM, NEAR_MM, REACH_STEPOVERS, between, sorted};
use crate::artifact::Stand;
use crate::geometry::allowance::Allowed;
use crate::geometry::near_disc::DiscSearch;
use crate::geometry::{Point, Vector};
use crate::parallel;
use crate::tool::Tool;
use crate::verify::samples::{self, Sample};
use crate::verify::sweep::Sweep;

/// Moves per unit of parallel work; fixed, so that the result does not depend on the number of
/// threads.
const CHUNK: usize = 128;
/// Contacts are resolved to this, mm.
const CONTACT_MM: f64 = 1e-4;
/// Least sine between axis and normal that stepovers are guessed with: flatter, passes lie as far
/// apart as the cutter is wide.
const FLATTEST: f64 = 0.02;
/// A height is met where the cutter is nearer than this, mm.
const MET_MM: f64 = 1e-6;
const MOST_STEPS: usize = 60;
/// Steps of the golden section; each leaves 0.618 of the leg.
const GOLDEN_STEPS: usize = 24;
const GOLDEN: f64 = 0.618_033_988_749_894_9;
/// Within a bend the way from side to side is less than so many times their distance.
const WITHIN: f64 = 4.0;
/// Heights are looked for up to so many times the scallop, and up to this, mm.
const HIGHEST_TIMES: f64 = 20.0;
const HIGHEST_MM: f64 = 0.5;

/// A leg of the cutter.
struct SweptLeg {
    from: Stand,
    to: Stand,
    /// No point of the disc goes farther on it than this, mm.
    way_mm: f64,
}

/// The cutter's way along the part, with a tree over its legs.
struct SweptDisc<'a> {
    tool: &'a Tool,
    legs: Vec<SweptLeg>,
    tree: Bvh,
}

impl<'a> SweptDisc<'a> {
    fn new(tool: &'a Tool, stands: &[Stand], counts: impl Fn(usize) -> bool) -> Self {
        let (disc_mm, corner) = (tool.disc_radius_mm(), tool.corner_mm());
        let leg = |i: usize| {
            let (from, to) = (stands[i], stands[i + 1]);
            let turn = (to.theta - from.theta).abs() + (to.cone.lean_rad - from.cone.lean_rad).abs();
            SweptLeg { from, to, way_mm: (to.centre - from.centre).norm() + disc_mm * turn }
        };
        let legs: Vec<SweptLeg> = (0..stands.len().saturating_sub(1)).filter(|i| counts(*i)).map(leg).collect();
        let boxes = legs.iter().enumerate().map(|(k, leg)| {
            // Of a disc with its corner, and what lies between its two places.
            let around = |s: &Stand| {
                let a = s.axis();
                let half = a.map(|x| disc_mm * (1.0 - x * x).max(0.0).sqrt() + corner);
                (s.centre - half, s.centre + half)
            };
            let ((a, b), (c, d)) = (around(&leg.from), around(&leg.to));
            let bulge = Vector::repeat(0.5 * (leg.way_mm - (leg.to.centre - leg.from.centre).norm()));
            let (lo, hi) = (a.inf(&c) - bulge, b.sup(&d) + bulge);
            (k, ParryAabb::new(ParryVector::new(lo.x, lo.y, lo.z), ParryVector::new(hi.x, hi.y, hi.z)))
        });
        let tree = Bvh::from_iter(BvhBuildStrategy::Binned, boxes);
        SweptDisc { tool, legs, tree }
    }

    /// Legs that the ray from `p` along `n` may meet within `far_mm`.
    fn near(&self, p: &Point, n: &Vector, far_mm: f64) -> Vec<&SweptLeg> {
        let mut out = Vec::new();
        let q = p + n * far_mm;
        let (lo, hi) = (p.inf(&q), p.sup(&q));
        self.tree.traverse(|node| {
            let (a, b) = (node.mins(), node.maxs());
            let apart = a.x > hi.x || a.y > hi.y || a.z > hi.z || b.x < lo.x || b.y < lo.y || b.z < lo.z;
            if apart {
                return TraversalAction::Prune;
            }
            out.extend(node.leaf_data().and_then(|k| self.legs.get(k as usize)));
            TraversalAction::Continue
        });
        out
    }

    /// Distance of a point from the cutter at a share of a leg, less the corner, mm.
    fn at(&self, leg: &SweptLeg, share: f64, q: &Point) -> f64 {
        let stand = leg.from.towards(&leg.to, share);
        self.tool.disc(stand.centre, stand.axis()).distance_mm(q) - self.tool.corner_mm()
    }

    /// Distance of a point from legs, mm; negative: how deep it comes to lie in the cutter.
    fn distance_mm(&self, legs: &[&SweptLeg], q: &Point) -> f64 {
        let mut best = f64::INFINITY;
        for leg in legs {
            let middle = self.at(leg, 0.5, q);
            if middle - 0.5 * leg.way_mm >= best {
                continue;
            }
            best = best.min(middle);
            let (mut a, mut b) = (0.0, 1.0);
            let (mut c, mut d) = (1.0 - GOLDEN, GOLDEN);
            let (mut fc, mut fd) = (self.at(leg, c, q), self.at(leg, d, q));
            for _ in 0..GOLDEN_STEPS {
                if fc < fd {
                    (b, d, fd) = (d, c, fc);
                    c = b - GOLDEN * (b - a);
                    fc = self.at(leg, c, q);
                } else {
                    (a, c, fc) = (c, d, fd);
                    d = a + GOLDEN * (b - a);
                    fd = self.at(leg, d, q);
                }
            }
            best = best.min(fc).min(fd);
        }
        best
    }

    /// Height over `p` at which `p + t n` meets the cutter, no higher than `far_mm`; where `p` lies
    /// in it, how deep, negative.
    fn height_mm(&self, p: &Point, n: &Vector, far_mm: f64) -> Option<f64> {
        let legs = self.near(p, n, far_mm);
        let mut t = 0.0;
        for _ in 0..MOST_STEPS {
            let left = self.distance_mm(&legs, &(p + n * t));
            if left <= MET_MM {
                return Some(if t == 0.0 { left } else { t });
            }
            t += left;
            if !(t <= far_mm) {
                return None;
            }
        }
        // So near that steps hardly lead on.
        Some(t)
    }
}

/// Passes of a cutter with a corner along a part.
pub(in crate::verify) struct Passes<'a> {
    /// The part, with the stock that is to stay on it.
    pub part: &'a Allowed<'a>,
    /// The cutter.
    pub tool: &'a Tool,
    /// Where it stands, move after move.
    pub stands: &'a [Stand],
    /// Turns of the stands.
    pub turns: &'a [u32],
    /// The passes are the turns of a helix.
    pub is_helix: bool,
    /// The scallop that reaches are measured by, mm.
    pub widest_mm: f64,
    /// Samples of the surface.
    pub samples: usize,
}

/// Measures the passes among the moves of a sweep that count.
pub(in crate::verify) fn heights(scene: &Passes, passes: &Sweep) -> Heights {
    let (tool, stands) = (scene.tool, scene.stands);
    let (widest, touched) = (scene.widest_mm, touched(scene, passes));
    let contacts = touched.iter().zip(stands).map(|(c, s)| c.map_or(s.centre, |c| c.0)).collect::<Vec<_>>();
    let counts = |i: usize| passes.counts(i) && touched[i].is_some() && touched[i + 1].is_some();
    let wanted: Vec<bool> = (0..stands.len().saturating_sub(1)).map(counts).collect();
    let mut sines: Vec<f64> = touched.iter().flatten().map(|c| c.1).collect();
    sines.sort_by(f64::total_cmp);
    let Some(sine) = sines.get(sines.len() / 2).map(|s| s.max(FLATTEST)) else { return sorted(Vec::new()) };
    // As wide as a ball of the radius across the feed would leave them.
    let radius = tool.disc_radius_mm() / sine + tool.corner_mm();
    let reach = (REACH_STEPOVERS * (8.0 * radius * widest).sqrt()).clamp(LEAST_REACH_MM, 4.0 * tool.radius_mm);
    let far = (HIGHEST_TIMES * widest).max(HIGHEST_MM);
    let swept = SweptDisc::new(tool, stands, |i| wanted.get(i) == Some(&true));
    let way = Sweep::of(contacts.clone(), contacts, scene.turns.to_vec(), 0.0, Some(wanted));
    // Beside the ends of passes the cutter comes down or goes up, and beyond is nothing to be cut.
    let ways = [true, false].map(|forwards| ways(&way, forwards));
    let far_in = reach + (2.0 * radius * NEAR_MM).sqrt();
    let from = |k: usize, end: usize, at: &Point| ways[k][end] + (at - way.centres[end]).norm();
    let inside = |(leg, at): (usize, &Point)| from(0, leg, at).min(from(1, leg + 1, at)) >= far_in;
    let beside = |[a, b]: [(usize, &Point); 2]| {
        // Within a bend of a turn a place is not between turns.
        let round_mm = (from(0, a.0, a.1) - from(0, b.0, b.1)).abs();
        inside(a) && inside(b) && !(scene.is_helix && round_mm < WITHIN * (a.1 - b.1).norm())
    };
    let height = |s: &Sample| {
        let (leg, gap_mm) = between(&way, &s.point, reach, beside)?;
        let height_mm = swept.height_mm(&s.point, &s.normal, far)?;
        Some(Height { height_mm, point: s.point, leg, gap_mm })
    };
    let all = samples::near_path(scene.part, &way, reach, scene.samples);
    sorted(parallel::filter_map(&all.points, height))
}

/// Way of the contacts at each place from where its pass begins, or to where it ends, mm.
fn ways(sweep: &Sweep, forwards: bool) -> Vec<f64> {
    let n = sweep.centres.len();
    let mut out = vec![0.0; n];
    for k in 1..n {
        let (before, at) = if forwards { (k - 1, k) } else { (n - k, n - k - 1) };
        let step = (sweep.centres[at] - sweep.centres[before]).norm();
        out[at] = if sweep.counts(before.min(at)) { out[before] + step } else { 0.0 };
    }
    out
}

/// At each stand of a pass where the part is nearest to the disc, with its stock, and the sine
/// between axis and normal there.
fn touched(scene: &Passes, passes: &Sweep) -> Vec<Option<(Point, f64)>> {
    let (tool, part, stands) = (scene.tool, scene.part, scene.stands);
    let near = tool.corner_mm() + part.stock_mm + HIGHEST_MM.max(2.0 * scene.widest_mm);
    let chunk = |k: usize| {
        let mut search = DiscSearch::new(part);
        let one = |i: usize| {
            if !(passes.counts(i) || i > 0 && passes.counts(i - 1)) {
                return None;
            }
            let (stand, axis) = (&stands[i], stands[i].axis());
            let found = search.closest(&tool.disc(stand.centre, axis), near, CONTACT_MM)?;
            let normal = (found.on_disc - found.at.point).try_normalize(1e-9).unwrap_or(found.at.normal);
            Some((found.at.point + normal * part.stock_mm, axis.cross(&normal).norm()))
        };
        (k * CHUNK..((k + 1) * CHUNK).min(stands.len())).map(one).collect::<Vec<_>>()
    };
    parallel::flat_map(0..stands.len().div_ceil(CHUNK), chunk)
}
