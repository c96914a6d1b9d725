//! Sets of angles on the circle as sorted, disjoint arcs, with what each end comes from.

use std::f64::consts::PI;

/// What an end of an arc comes from.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Witness {
    /// A part of the tool against a triangle of a body.
    Tool {
        /// Index of the profile's segment.
        segment: u16,
        /// The body.
        body: u16,
        /// Leaf of the tree over the body's triangles.
        leaf: u32,
    },
    /// The bottom of a cutter with a corner, against a triangle of a body: 0 is the part.
    Cutter {
        /// The body.
        body: u16,
        /// Triangle of its mesh.
        triangle: u32,
    },
    /// The permitted range of contact angle.
    Contact,
    /// A limit of the rotary axis.
    Axis,
    /// Travel of a linear axis: its index in the options.
    Travel(u8),
    /// The cut of the circle, not a limit.
    Cut,
}

/// An arc `lo..=hi` within -π..π.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Arc {
    pub lo: f64,
    pub hi: f64,
    pub lo_by: Witness,
    pub hi_by: Witness,
}

/// Union of arcs; arcs nearer than `gap` to one another are one.
#[derive(Clone, Debug)]
pub(super) struct ArcSet {
    arcs: Vec<Arc>,
    gap: f64,
}

impl ArcSet {
    pub fn new(gap: f64) -> Self {
        ArcSet { arcs: Vec::with_capacity(8), gap }
    }

    /// Takes all arcs out; from now on arcs nearer than `gap` are one.
    pub fn reset(&mut self, gap: f64) {
        self.arcs.clear();
        self.gap = gap;
    }

    /// The arcs, rising.
    pub fn arcs(&self) -> &[Arc] {
        &self.arcs
    }

    /// Adds an arc.
    pub fn insert(&mut self, mut new: Arc) {
        if new.lo > new.hi {
            return;
        }
        let first = self.arcs.partition_point(|a| a.hi + self.gap < new.lo);
        let mut end = first;
        while let Some(a) = self.arcs.get(end).filter(|a| a.lo <= new.hi + self.gap) {
            if a.lo <= new.lo {
                (new.lo, new.lo_by) = (a.lo, a.lo_by);
            }
            if a.hi >= new.hi {
                (new.hi, new.hi_by) = (a.hi, a.hi_by);
            }
            end += 1;
        }
        if end == first + 1 {
            if let Some(a) = self.arcs.get_mut(first) {
                *a = new;
            }
        } else {
            self.arcs.splice(first..end, [new]);
        }
    }

    /// The arc `lo..=hi` lies in the set widened by half the gap. The circle's cut at ±π needs no
    /// margin.
    pub fn covers(&self, lo: f64, hi: f64) -> bool {
        let half = 0.5 * self.gap;
        self.arcs.iter().any(|a| lo >= a.lo - half && hi <= a.hi + half)
    }

    /// Length of what the arc `lo..=hi` has in common with the set.
    pub fn overlap(&self, lo: f64, hi: f64) -> f64 {
        self.arcs.iter().map(|a| (hi.min(a.hi) - lo.max(a.lo)).max(0.0)).sum()
    }

    /// Hands the parts of the arc `lo..=hi` that the set, widened by half the gap, does not cover
    /// to `visit`, one by one as (from, to); stops and returns false as soon as `visit` does.
    pub fn all_uncovered(&self, lo: f64, hi: f64, mut visit: impl FnMut(f64, f64) -> bool) -> bool {
        let half = 0.5 * self.gap;
        let mut at = lo;
        for a in &self.arcs {
            if a.hi + half <= at {
                continue;
            }
            let end = (a.lo - half).min(hi);
            if end > at && !visit(at, end) {
                return false;
            }
            at = a.hi + half;
            if at >= hi {
                return true;
            }
        }
        at >= hi || visit(at, hi)
    }

    /// As [`Self::all_uncovered`], but hands over only those ends of the parts at which the set or
    /// the circle's cut begins: an interval that reaches into a part from outside the arc's own
    /// ends holds one of them.
    pub fn all_borders(&self, lo: f64, hi: f64, mut visit: impl FnMut(f64) -> bool) -> bool {
        let border = |at: f64, own: f64| at != own || at.abs() >= PI;
        self.all_uncovered(lo, hi, |from, to| (!border(from, lo) || visit(from)) && (!border(to, hi) || visit(to)))
    }

    /// What the set, widened by half the gap, leaves of the circle: intervals within -π..3π, each
    /// at least `least` long, centred in -π..=π. Where the set is empty, the whole circle cut at
    /// ±π.
    pub fn free(&self, least: f64) -> Vec<Arc> {
        let half = 0.5 * self.gap;
        let (Some(first), Some(last)) = (self.arcs.first(), self.arcs.last()) else {
            return vec![Arc { lo: -PI, hi: PI, lo_by: Witness::Cut, hi_by: Witness::Cut }];
        };
        let mut out = Vec::new();
        let between = |a: &Arc, b: &Arc, turn: f64| Arc {
            lo: a.hi + half,
            hi: b.lo - half + turn,
            lo_by: a.hi_by,
            hi_by: b.lo_by,
        };
        for pair in self.arcs.windows(2) {
            if let [a, b] = pair {
                out.push(between(a, b, 0.0));
            }
        }
        // Over the cut: from the last arc on to the first one.
        let mut over = between(last, first, 2.0 * PI);
        if over.lo + over.hi > 2.0 * PI {
            over.lo -= 2.0 * PI;
            over.hi -= 2.0 * PI;
            out.insert(0, over);
        } else {
            out.push(over);
        }
        out.retain(|a| a.hi - a.lo >= least);
        out
    }
}

/// Arcs of θ within -π..=π on which `off + m cos(θ − psi)` lies in `range`; `m >= 0`, `psi` within
/// -π..=π.
/// `by` says what the range's lower and upper end come from.
pub(super) fn push_arcs(off: f64, m: f64, psi: f64, range: (f64, f64), by: (Witness, Witness), out: &mut Vec<Arc>) {
    let (below, above) = (range.0 <= off - m, range.1 >= off + m);
    if range.1 < off - m || range.0 > off + m {
        return;
    }
    if below && above {
        out.push(Arc { lo: -PI, hi: PI, lo_by: Witness::Cut, hi_by: Witness::Cut });
        return;
    }
    // Outer half width from the lower end of the range, inner from the upper end.
    let outer = if below { PI } else { ((range.0 - off) / m).clamp(-1.0, 1.0).acos() };
    let inner = if above { 0.0 } else { ((range.1 - off) / m).clamp(-1.0, 1.0).acos() };
    if above {
        push_wrapped(psi - outer, psi + outer, by.0, by.0, out);
    } else if below {
        push_wrapped(psi + inner, psi - inner + 2.0 * PI, by.1, by.1, out);
    } else {
        push_wrapped(psi + inner, psi + outer, by.1, by.0, out);
        push_wrapped(psi - outer, psi - inner, by.0, by.1, out);
    }
}

/// The arc `lo..=hi` (no longer than 2π) moved into -π..=π, cut in two where it crosses ±π.
pub(super) fn push_wrapped(lo: f64, hi: f64, lo_by: Witness, hi_by: Witness, out: &mut Vec<Arc>) {
    let turn = 2.0 * PI;
    let shift = if lo >= PI {
        -turn
    } else if lo < -PI {
        turn
    } else {
        0.0
    };
    let (lo, hi) = (lo + shift, hi + shift);
    if hi <= PI {
        out.push(Arc { lo, hi, lo_by, hi_by });
    } else {
        out.push(Arc { lo, hi: PI, lo_by, hi_by: Witness::Cut });
        out.push(Arc { lo: -PI, hi: hi - turn, lo_by: Witness::Cut, hi_by });
    }
}
