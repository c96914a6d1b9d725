//! What an audit says: checks by line of the program.

use serde::Serialize;

use super::AuditScene;
use super::legs::LegKind;
use super::line_check::{LineCheck, LineLimit, LineRun};
use crate::artifact::deviation::DeviationMap;
use crate::artifact::report::Check;
use crate::geometry::Point;
use crate::verify::between::Heights;
use crate::verify::setting::Finding;

/// Most spans reported for one check.
const MOST_SPANS: usize = 20;

/// What an audit found.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Audit {
    /// Lines of the program.
    pub lines: usize,
    /// Feed moves.
    pub feed_moves: usize,
    /// Rapids.
    pub rapids: usize,
    /// Moves that begin or end where the program has not said yet that an axis stands: not looked
    /// at.
    pub unknown_moves: usize,
    /// Turns about the blade axis.
    pub turns: u32,
    /// Way of the ball centre at a feed, mm.
    pub feed_mm: f64,
    /// Time at a feed, as programmed, s.
    pub feed_s: f64,
    /// Least and greatest B at a feed, degrees.
    pub b_deg: [f64; 2],
    /// Samples of the surface between passes.
    pub scallop_samples: usize,
    /// Height left between passes, mm: greatest, 99th percentile, median.
    pub scallop_max_mm: f64,
    /// 99th percentile, mm.
    pub scallop_p99_mm: f64,
    /// Median, mm.
    pub scallop_p50_mm: f64,
    /// The checks.
    pub checks: Vec<LineCheck>,
    /// The deviation map, where it was asked for.
    #[serde(skip)]
    pub map: Option<DeviationMap>,
}

impl Audit {
    /// All checks passed.
    pub fn passed(&self) -> bool {
        self.checks.iter().all(|c| c.check.passed)
    }
}

/// A worst value and where.
#[derive(Clone, Copy)]
pub(super) struct WorstMove {
    pub value: f64,
    /// Index of the move.
    pub moved: Option<usize>,
    pub turn: Option<u32>,
    /// Point of the part or of the tool's way, blade frame.
    pub point: Option<Point>,
}

impl AuditScene<'_> {
    /// A worst value on a leg.
    pub(super) fn on_leg(&self, value: f64, leg: usize, point: Option<Point>) -> WorstMove {
        let moved = self.legs.legs.get(leg).map(|l| l.moved);
        WorstMove { value, moved, turn: self.turns.get(leg).copied(), point }
    }

    /// A check, placed.
    pub(super) fn judged(&self, limit: LineLimit, worst: &WorstMove, note: String) -> LineCheck {
        let point = worst.point.map(|p| self.blade.model_from_blade * p);
        let line = worst.moved.and_then(|m| self.moves.get(m)).map(|m| m.line);
        let block = self.line(line);
        let value = if worst.value.is_finite() { worst.value } else { f64::MAX };
        LineCheck {
            check: Check {
                id: limit.id,
                quantity: limit.quantity,
                worst: value,
                limit: limit.limit,
                unit: limit.unit.into(),
                passed: limit.passed,
                row: None,
                turn: worst.turn,
                point_mm: point.map(|p| [p.x, p.y, p.z]),
                note,
            },
            line,
            block,
            spans: Vec::new(),
            span_count: 0,
        }
    }

    /// What a program sets beside its motion, as a check placed in its text.
    pub(super) fn set(&self, found: Finding) -> LineCheck {
        let limit = LineLimit {
            id: found.id,
            quantity: found.quantity.into(),
            limit: found.limit,
            unit: found.unit,
            passed: found.worst <= found.limit,
        };
        let mut check =
            self.judged(limit, &WorstMove { value: found.worst, moved: None, turn: None, point: None }, found.note);
        check.line = found.line;
        check.block = self.line(found.line);
        check
    }

    /// The text of a line.
    fn line(&self, line: Option<usize>) -> Option<String> {
        line.and_then(|n| self.text.lines().nth(n.checked_sub(1)?)).map(|l| l.trim().to_owned())
    }

    /// Tells the spans of the legs that break a limit, and of the leg of the worst value, which may
    /// break it between its places.
    pub(super) fn tell_spans(&self, check: &mut LineCheck, legs: &[usize], worst: usize) {
        let moved = |leg: &usize| self.legs.legs.get(*leg).map(|l| l.moved);
        (check.spans, check.span_count) = self.spans(legs.iter().chain([&worst]).filter_map(moved).collect());
    }

    /// Moves that break a limit, as spans of such that follow one another, in order; at most
    /// [`MOST_SPANS`], and how many there are.
    pub(super) fn spans(&self, mut moves: Vec<usize>) -> (Vec<LineRun>, usize) {
        moves.sort_unstable();
        let mut all: Vec<(LineRun, usize)> = Vec::new();
        for moved in moves {
            let Some(line) = self.moves.get(moved).map(|m| m.line) else { continue };
            match all.last_mut() {
                Some((span, last)) if moved <= *last + 1 => (span.last_line, *last) = (line, moved),
                _ => all.push((LineRun { first_line: line, last_line: line }, moved)),
            }
        }
        let count = all.len();
        (all.into_iter().map(|(s, _)| s).take(MOST_SPANS).collect(), count)
    }
}

/// The audit with its figures.
pub(super) fn report(scene: &AuditScene, checks: Vec<LineCheck>, heights: &Heights) -> Audit {
    let legs = scene.legs;
    let cut = |i: &usize| legs.legs.get(*i).is_some_and(|l| l.kind == LegKind::Cut);
    let feeds = || (0..legs.legs.len()).filter(cut);
    let leans = feeds().flat_map(|i| [i, i + 1].map(|k| legs.stands[k].cone.lean_rad)).map(f64::to_degrees);
    let b = leans.fold([f64::INFINITY, f64::NEG_INFINITY], |[lo, hi], b| [lo.min(b), hi.max(b)]);
    Audit {
        lines: scene.text.lines().count(),
        feed_moves: scene.moves.iter().filter(|m| m.seconds.is_some()).count(),
        rapids: scene.moves.iter().filter(|m| m.seconds.is_none()).count(),
        unknown_moves: legs.unknown,
        turns: feeds().filter_map(|i| scene.turns.get(i)).max().map_or(0, |t| t + 1),
        feed_mm: feeds().map(|i| (legs.stands[i + 1].centre - legs.stands[i].centre).norm()).sum(),
        feed_s: scene.moves.iter().filter_map(|m| m.seconds.filter(|s| s.is_finite())).sum(),
        b_deg: b,
        scallop_samples: heights.sorted.len(),
        scallop_max_mm: heights.percentile(1.0),
        scallop_p99_mm: heights.percentile(0.99),
        scallop_p50_mm: heights.percentile(0.5),
        checks,
        map: None,
    }
}
