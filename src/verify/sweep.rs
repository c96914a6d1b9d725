//! The swept ball: straight moves between the ball centres of a path, with a tree over them.

use parry3d_f64::bounding_volume::Aabb as ParryAabb;
use parry3d_f64::math::Vector as ParryVector;
use parry3d_f64::partitioning::{Bvh, BvhBuildStrategy, BvhNode, TraversalAction};

use crate::artifact::along::Along;
use crate::artifact::region::{Area, Patch};
use crate::artifact::{Blade, Toolpath, Wheel};
use crate::geometry::part::Part;
use crate::geometry::triangle::share_of_segment;
use crate::geometry::{Point, Vector};

/// Moves of the ball's centre. Between two locations the control moves the centre on a straight
/// line, so the swept volume of move `i` is exactly a capsule (a spherocylinder) of the ball's
/// radius.
pub(super) struct Sweep {
    /// Ends of the moves: centre `i` to centre `i + 1`.
    pub centres: Vec<Point>,
    /// Contact points of the ends.
    pub contacts: Vec<Point>,
    /// Turn of the move: that of its first location.
    pub turns: Vec<u32>,
    /// Ball radius, mm.
    pub radius_mm: f64,
    /// Moves that count, by their first row; the others only lead from one to the next.
    wanted: Option<Vec<bool>>,
    /// The move of each leaf of the tree, whose leaves are numbered without gaps.
    leaves: Vec<u32>,
    tree: Bvh,
    /// The wheel over whose hub the path goes, and from where to where the centres go along its
    /// axis, mm; `None`: the path goes round a blade.
    hub: Option<(Wheel, [f64; 2])>,
    /// What is high on the blade, where that is over a hub that turns.
    over: Option<Along>,
    /// The platform beside the blade.
    platform: Option<Patch>,
}

/// A place so low over a hub that turns, mm, with a normal that leans so little off that of the
/// hub, rad, is on it. In a fillet only the foot is.
const ON_HUB_MM: f64 = 0.05;
const ON_HUB_RAD: f64 = 0.1;

/// A contact that moves this many times as far as its ball centre has jumped: a ball that fits so
/// closely into a concave place (within a tenth of its radius) is hardly ever met.
const MOST_STRETCH: f64 = 10.0;

/// The place on the path nearest to a point.
#[derive(Clone, Copy, Debug)]
pub(super) struct Nearest {
    /// Move.
    pub segment: usize,
    /// Part of the move, 0 to 1.
    pub t: f64,
    /// The centre there.
    pub centre: Point,
    /// Distance to it, mm.
    pub distance_mm: f64,
}

fn box_distance2(node: &BvhNode, q: &Point) -> f64 {
    let (lo, hi) = (node.mins(), node.maxs());
    let gap = |l: f64, h: f64, x: f64| (l - x).max(x - h).max(0.0);
    gap(lo.x, hi.x, q.x).powi(2) + gap(lo.y, hi.y, q.y).powi(2) + gap(lo.z, hi.z, q.z).powi(2)
}

impl Sweep {
    /// Over a path with at least two locations.
    pub fn new(path: &Toolpath) -> Self {
        let centres: Vec<Point> = path.locations.iter().map(|l| l.centre).collect();
        let contacts = path.locations.iter().map(|l| l.contact).collect();
        let turns = path.locations.iter().map(|l| l.turn).collect();
        Self::of(centres, contacts, turns, path.radius_mm, None)
    }

    /// The same without its links: what is measured of the surface is what turns leave.
    pub fn cutting(path: &Toolpath) -> Self {
        let whole = Self::new(path);
        if !path.has_links() {
            return whole;
        }
        let wanted = (0..whole.centres.len()).map(|row| whole.touches(row)).collect();
        Self::of(whole.centres, whole.contacts, whole.turns, path.radius_mm, Some(wanted))
    }

    /// Over moves from centre to centre, at least two of them; `wanted`: those that count, all
    /// where it is left out.
    pub fn of(
        centres: Vec<Point>,
        contacts: Vec<Point>,
        turns: Vec<u32>,
        radius_mm: f64,
        wanted: Option<Vec<bool>>,
    ) -> Self {
        let counts = |i: &usize| wanted.as_ref().is_none_or(|w| w.get(*i) == Some(&true));
        let leaves: Vec<u32> = (0..centres.len().saturating_sub(1)).filter(counts).map(|i| i as u32).collect();
        let boxes = leaves.iter().enumerate().map(|(leaf, i)| {
            let (a, b) = (centres[*i as usize], centres[*i as usize + 1]);
            let (lo, hi) = (a.inf(&b), a.sup(&b));
            (leaf, ParryAabb::new(ParryVector::new(lo.x, lo.y, lo.z), ParryVector::new(hi.x, hi.y, hi.z)))
        });
        let tree = Bvh::from_iter(BvhBuildStrategy::Binned, boxes);
        Sweep { centres, contacts, turns, radius_mm, wanted, leaves, tree, hub: None, over: None, platform: None }
    }

    /// The same over the hub of a wheel, where there is one: what else the ball comes near to is
    /// not to be machined.
    pub fn over_hub(self, hub_of: Option<Wheel>) -> Self {
        let along = |wheel: &Wheel| {
            let heights = self.centres.iter().map(|c| (c - wheel.origin).dot(&wheel.axis));
            heights.fold([f64::INFINITY, f64::NEG_INFINITY], |[lo, hi], z| [lo.min(z), hi.max(z)])
        };
        let hub = hub_of.map(|wheel| (wheel, along(&wheel)));
        Sweep { hub, ..self }
    }

    /// The same round a blade. Where that stands on a hub that turns, the hub beside it is not to
    /// be machined, nor is a platform.
    pub fn round(self, blade: &Blade) -> Self {
        let own = blade.regions.list.first().map(|region| region.along);
        let platform = blade.regions.first(Area::Platform).filter(|_| self.hub.is_none());
        let platform = platform.map(|region| region.patch.clone());
        Sweep { over: own.filter(|along| along.round().is_some()), platform, ..self }
    }

    /// Whether a triangle of the part is of the platform beside the blade, and not of a fillet that
    /// goes over into it.
    pub fn is_beside(&self, part: &Part, triangle: usize) -> bool {
        self.platform.as_ref().is_some_and(|patch| {
            let is_flat = || part.mesh.normal(triangle).angle(&Vector::x()) < ON_HUB_RAD;
            patch.has(&part.mesh, triangle as u32) && (part.brep.is_some() || is_flat())
        })
    }

    /// Whether a place with this normal is of the surface that the path is to machine; of a hub,
    /// whether it is within the rows, which begin and end at places along the rotor axis.
    pub fn is_for(&self, point: &Point, normal: &Vector, by_facets: bool) -> bool {
        let on_hub =
            |along: &Along| along.height_mm(point) < ON_HUB_MM && normal.angle(along.frame(point).up()) < ON_HUB_RAD;
        if self.over.as_ref().is_some_and(on_hub) {
            return false;
        }
        self.hub.is_none_or(|(wheel, [from_mm, to_mm])| {
            let along_mm = (point + normal * self.radius_mm - wheel.origin).dot(&wheel.axis);
            (from_mm..=to_mm).contains(&along_mm) && wheel.is_hub(point, normal, by_facets)
        })
    }

    /// Whether the ball touches at both ends of the move that begins with a row: links are ways
    /// through the air.
    pub fn touches(&self, row: usize) -> bool {
        let at = |k: usize| self.contacts.get(k).zip(self.centres.get(k)).is_none_or(|(p, c)| p != c);
        at(row) && at(row + 1)
    }

    /// Whether move `i` counts.
    pub fn counts(&self, i: usize) -> bool {
        self.wanted.as_ref().is_none_or(|w| w.get(i) == Some(&true))
    }

    /// The places of the moves that are nearest to `q`, where that is within `reach_mm`: move and
    /// place.
    pub fn all_near(&self, q: &Point, reach_mm: f64) -> Vec<(usize, Point)> {
        let mut found = Vec::new();
        self.tree.traverse(|node| {
            if box_distance2(node, q) > reach_mm * reach_mm {
                return TraversalAction::Prune;
            }
            if let Some(i) = node.leaf_data().map(|leaf| self.leaves[leaf as usize]) {
                let (a, b) = (self.centres[i as usize], self.centres[i as usize + 1]);
                let near = a + (b - a) * share_of_segment(&a, &b, q);
                if (near - q).norm_squared() <= reach_mm * reach_mm {
                    found.push((i as usize, near));
                }
            }
            TraversalAction::Continue
        });
        found
    }

    /// Nearest place of the path within `cap_mm` of `q`, among the moves that `allowed` lets
    /// through.
    pub fn nearest(&self, q: &Point, cap_mm: f64, allowed: impl Fn(usize) -> bool) -> Option<Nearest> {
        let found = self.tree.find_best(
            cap_mm * cap_mm,
            |node, _| box_distance2(node, q),
            |leaf, _| {
                let i = self.leaves[leaf as usize] as usize;
                let t = share_of_segment(&self.centres[i], &self.centres[i + 1], q);
                let centre = self.at(i, t);
                allowed(i).then(|| ((q - centre).norm_squared(), (t, centre)))
            },
        );
        found.map(|(leaf, (d2, (t, centre)))| {
            let segment = self.leaves[leaf as usize] as usize;
            Nearest { segment, t, centre, distance_mm: d2.sqrt() }
        })
    }

    /// Length of the contacts' way over the part in move `i`, mm. Where the ball runs along an
    /// inner corner, its contact jumps between the two walls while the centre hardly moves: there
    /// the way of the centre counts.
    pub fn contact_way_mm(&self, i: usize) -> f64 {
        let centre = (self.centres[i + 1] - self.centres[i]).norm();
        let contact = (self.contacts[i + 1] - self.contacts[i]).norm();
        if contact > MOST_STRETCH * centre { centre } else { contact }
    }

    /// The centre at part `t` of move `segment`.
    pub fn at(&self, segment: usize, t: f64) -> Point {
        let (a, b) = (self.centres[segment], self.centres[segment + 1]);
        a + (b - a) * t
    }

    /// Height of the swept ball over `p`: the least `t` at which the line `p + t n` enters a ball
    /// of the sweep, among the moves that come within `reach_mm` of `p + R n`; `None` where none of
    /// those is met. Positive: material is left standing that high over `p`. Negative where `p`
    /// itself lies in a ball, by how deep it lies there: along the line a ball that rolls round a
    /// sharp edge, or behind a thin wall, would seem to have cut much deeper than it has.
    pub fn entry(&self, p: &Point, n: &Vector, reach_mm: f64) -> Option<f64> {
        let q = p + n * self.radius_mm;
        let reach2 = reach_mm * reach_mm;
        // A ball is entered no lower over `p` than `p` is off it, and lies no deeper over `p` than
        // `p` is in it: balls farther from `p` are higher.
        let least = |node: &BvhNode, _| match box_distance2(node, &q) <= reach2 {
            true => box_distance2(node, p).sqrt() - (1.0 + ROUNDING) * self.radius_mm,
            false => f64::INFINITY,
        };
        let entry = |leaf: u32, _| {
            let i = self.leaves[leaf as usize] as usize;
            let (a, b) = (&self.centres[i], &self.centres[i + 1]);
            let near = a + (b - a) * share_of_segment(a, b, &q);
            if (near - q).norm_squared() > reach2 {
                return None;
            }
            let t = capsule_entry(a, b, self.radius_mm, p, n)?;
            if t < 0.0 { self.depth(a, b, p).map(|d| (-d, ())) } else { Some((t, ())) }
        };
        self.tree.find_best(f64::INFINITY, least, entry).map(|(_, (t, ()))| t)
    }

    /// Of the moves within `reach_mm` of `p + R n` into whose ball the line `p + t n` enters no
    /// higher than `highest_mm` how far the centre of that which is farthest off the line is off
    /// it; of balls that lie apart from `p` by more than that and `way_mm` nothing is said.
    pub fn farthest_off(&self, p: &Point, n: &Vector, reach_mm: f64, [highest_mm, way_mm]: [f64; 2]) -> Option<f64> {
        let q = p + n * self.radius_mm;
        let (reach2, apart) = (reach_mm * reach_mm, self.radius_mm + highest_mm.max(0.0) + way_mm);
        let mut farthest: Option<f64> = None;
        self.tree.traverse(|node| {
            if box_distance2(node, &q) > reach2 || box_distance2(node, p) > apart * apart {
                return TraversalAction::Prune;
            }
            if let Some(i) = node.leaf_data().map(|leaf| self.leaves[leaf as usize] as usize) {
                let (a, b) = (&self.centres[i], &self.centres[i + 1]);
                let near = a + (b - a) * share_of_segment(a, b, &q);
                if (near - q).norm_squared() <= reach2
                    && let Some(t) = capsule_entry(a, b, self.radius_mm, p, n).filter(|t| *t <= highest_mm)
                {
                    let v = a + (b - a) * share_of_segment(a, b, &(p + n * t)) - p;
                    let off = (v - n * v.dot(n)).norm();
                    farthest = Some(farthest.map_or(off, |o| o.max(off)));
                }
            }
            TraversalAction::Continue
        });
        farthest
    }

    /// How deep the point comes to lie in the ball moving from `a` to `b`; `None`: not at all.
    fn depth(&self, a: &Point, b: &Point, p: &Point) -> Option<f64> {
        let near = a + (b - a) * share_of_segment(a, b, p);
        let depth = self.radius_mm - (near - p).norm();
        (depth >= -ROUNDING * self.radius_mm).then_some(depth.max(0.0))
    }
}

/// How much farther than the radius a point may be and still count as in the ball, as a share of
/// the radius: rounding only.
const ROUNDING: f64 = 1e-9;

/// Where the line `p + t n` (unit `n`) enters the ball about `c`.
fn ball_entry(c: &Point, radius: f64, p: &Point, n: &Vector) -> Option<f64> {
    let v = c - p;
    let along = v.dot(n);
    let rest = radius * radius - (v.norm_squared() - along * along);
    (rest >= 0.0).then(|| along - rest.sqrt())
}

/// Where the line `p + t n` (unit `n`) enters the capsule about the segment `a b`: the least of the
/// entries into its two end balls and, where the line enters it between them, into its cylinder.
pub(super) fn capsule_entry(a: &Point, b: &Point, radius: f64, p: &Point, n: &Vector) -> Option<f64> {
    let ends = lesser(ball_entry(a, radius, p, n), ball_entry(b, radius, p, n));
    let (axis, length) = (b - a, (b - a).norm());
    if length == 0.0 {
        return ends;
    }
    let e = axis / length;
    let w = p - a;
    // |(w + t n) − ((w + t n)·e) e|² = R²: α t² + 2 β t + γ = 0.
    let (we, ne) = (w.dot(&e), n.dot(&e));
    let (alpha, beta) = (1.0 - ne * ne, w.dot(n) - we * ne);
    let gamma = w.norm_squared() - we * we - radius * radius;
    let disc = beta * beta - alpha * gamma;
    if alpha <= 1e-14 || disc < 0.0 {
        return ends;
    }
    let t = (-beta - disc.sqrt()) / alpha;
    lesser(ends, (0.0..=length).contains(&(we + t * ne)).then_some(t))
}

fn lesser(a: Option<f64>, b: Option<f64>) -> Option<f64> {
    match (a, b) {
        (Some(a), Some(b)) => Some(a.min(b)),
        _ => a.or(b),
    }
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used)]
    use super::*;
    use crate::artifact::meridian::Meridian;
    use crate::artifact::region::Region;
    use proptest::prelude::*;

    fn vector() -> impl Strategy<Value = Vector> {
        [-3.0..3.0f64, -3.0..3.0f64, -3.0..3.0f64].prop_map(Vector::from)
    }

    /// The hub beside a blade is not the blade's surface, a fillet on it is, and of a blade whose
    /// heights are straight all is.
    #[test]
    fn the_hub_that_turns_is_not_the_blades() {
        let contour = |side: usize| -> Vec<[f64; 2]> {
            (0..=40).map(|k| crate::sample::impeller_contour(side, f64::from(k) / 40.0)).collect()
        };
        let meridian = Meridian::new(Vector::z(), Point::origin(), &contour(0), &contour(1)).unwrap();
        let (straight, _) = crate::sample::plates(12, 2.0);
        let mut over = straight.clone();
        over.regions.list[0].along = Along::over_hub(meridian);
        let path = crate::sample::plan(1, 12).toolpath;
        let sweep = |blade: &Blade| Sweep::cutting(&path).round(blade);
        for share in [0.1, 0.5, 0.9] {
            let [on, above] = [0.0, 0.5].map(|h| meridian.point(share, h, &Vector::x(), 0.3));
            let [up, aside] = [Along::over_hub(meridian).frame(&on)].map(|f| [*f.up(), f.vector(0.0, [1.0, 0.0])])[0];
            let leaning = (up + aside * 0.3).normalize();
            assert!(!sweep(&over).is_for(&on, &up, false), "{share}");
            assert!(sweep(&over).is_for(&on, &leaning, false) && sweep(&over).is_for(&above, &up, false), "{share}");
            assert!(sweep(&over).is_for(&above, &aside, false) && sweep(&straight).is_for(&on, &up, false));
        }
    }

    /// The platform is not the blade's surface; what of it leans may be a fillet where facets alone
    /// tell. Rows over a hub have no platform beside them.
    #[test]
    fn the_platform_is_not_the_blades() {
        let mut blade = crate::sample::blade();
        let mesh = &blade.part.mesh;
        let faces = |wanted: &[u32]| -> Vec<u32> {
            (0..mesh.triangles.len() as u32).filter(|t| wanted.contains(&mesh.face(*t as usize))).collect()
        };
        let (side, top) = (faces(&[0]), faces(&[2]));
        let patch = Patch::Facets(faces(&[0, 2]));
        let path = crate::sample::plan(1, 12).toolpath;
        let bare = Sweep::new(&path).round(&blade);
        let platform = Region { patch, ..Region::between(Area::Platform, None, None) };
        blade.regions.list.retain(|r| r.area != Area::Platform);
        blade.regions.list.push(platform);
        let sweep = Sweep::new(&path).round(&blade);
        assert!(
            top.iter().all(|t| sweep.is_beside(&blade.part, *t as usize) && !bare.is_beside(&blade.part, *t as usize))
        );
        assert!(side.iter().all(|t| !sweep.is_beside(&blade.part, *t as usize)));
        let (_, wheel) = crate::sample::plates(12, 2.0);
        let rows = Sweep::new(&path).over_hub(Some(wheel)).round(&blade);
        assert!(top.iter().all(|t| !rows.is_beside(&blade.part, *t as usize)));
    }

    /// A wall 0.3 mm thick, milled on one side by a ball of radius 0.5: on the other side nothing
    /// is cut, however far one looks; on the milled side, 0.02 mm too deep.
    #[test]
    fn a_ball_behind_a_thin_wall_has_not_cut_in_front() {
        let mut path = crate::sample::plan(1, 12).toolpath;
        path.radius_mm = 0.5;
        for (i, l) in path.locations.iter_mut().enumerate() {
            l.centre = Point::new(i as f64, 0.0, -0.3 - 0.48);
        }
        let sweep = Sweep::new(&path);
        for x in [3.0, 4.3, 5.5] {
            assert_eq!(sweep.entry(&Point::new(x, 0.1, 0.0), &Vector::z(), 1.5), None);
            let depth = sweep.entry(&Point::new(x, 0.0, -0.3), &-Vector::z(), 1.5).unwrap();
            assert!((depth + 0.02).abs() < 1e-12, "{depth}");
            // An acute edge that the ball rolls round: the line along the face's normal runs far
            // through the ball, which has cut next to nothing.
            let (touch, edge) = (Vector::new(0.0, 0.6, 0.8), Vector::new(0.0, 0.8, 0.6));
            let at = Point::new(x, 0.0, -0.78) + touch * (0.5 - 1e-6);
            let depth = sweep.entry(&at, &edge, 1.5).unwrap();
            assert!((depth + 1e-6).abs() < 1e-12, "{depth}");
        }
    }

    proptest! {
        #[test]
        fn heights_over_a_place_are_those_of_all_moves(
            centres in prop::collection::vec(vector(), 2..40), p in vector(), n in vector(), reach in 0.1..4.0f64,
        ) {
            prop_assume!(n.norm() > 0.1);
            let (n, p) = (n.normalize(), Point::from(p * 0.8));
            let centres: Vec<Point> = centres.into_iter().map(Point::from).collect();
            let radius = 1.2;
            let sweep = Sweep::of(centres.clone(), centres.clone(), vec![0; centres.len()], radius, None);
            let q = p + n * radius;
            let met: Vec<(f64, f64, Option<f64>)> = centres.windows(2).filter_map(|w| {
                let (a, b) = (w[0], w[1]);
                let near = a + (b - a) * share_of_segment(&a, &b, &q);
                let t = capsule_entry(&a, &b, radius, &p, &n).filter(|_| (near - q).norm() <= reach)?;
                let v = a + (b - a) * share_of_segment(&a, &b, &(p + n * t)) - p;
                let height = if t < 0.0 { sweep.depth(&a, &b, &p).map(|d| -d) } else { Some(t) };
                Some((t, (v - n * v.dot(&n)).norm(), height))
            }).collect();
            prop_assert_eq!(sweep.entry(&p, &n, reach), met.iter().filter_map(|m| m.2).reduce(f64::min));
            let highest = 0.7;
            let farthest = met.iter().filter(|m| m.0 <= highest).map(|m| m.1).reduce(f64::max);
            prop_assert_eq!(sweep.farthest_off(&p, &n, reach, [highest, 100.0]), farthest);
            // Of balls that are left out, none is as near as that.
            if let Some(off) = sweep.farthest_off(&p, &n, reach, [highest, 0.1]) {
                prop_assert!(farthest.is_some_and(|f| off <= f));
            }
        }
        #[test]
        fn capsule_entry_is_the_least_entry_of_its_balls(a in vector(), b in vector(), p in vector(), n in vector()) {
            prop_assume!(n.norm() > 0.1);
            let n = n.normalize();
            let (a, b, p) = (Point::from(a), Point::from(b), Point::from(p) * 2.0);
            let balls = (0..=4000).filter_map(|k| ball_entry(&(a + (b - a) * (f64::from(k) / 4000.0)), 1.5, &p, &n));
            let dense = balls.min_by(f64::total_cmp);
            match (capsule_entry(&a, &b, 1.5, &p, &n), dense) {
                (Some(x), Some(y)) => prop_assert!(x <= y + 1e-9 && y - x < 0.1, "{x} {y}"),
                (None, Some(y)) => prop_assert!(false, "missed {y}"),
                _ => {}
            }
        }
    }
}
