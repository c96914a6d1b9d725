//! `[path]` of the job file.

use std::ops::RangeInclusive;

use crate::artifact::toolpath::{CHORD_MM, Direction, PathKind, SCALLOP_MM, Start};
use crate::settings::{TINY, section};

/// Chord tolerances that can be asked for, mm.
pub const CHORDS_MM: RangeInclusive<f64> = 1e-5..=1.0;
/// Scallops that can be asked for, mm.
pub const SCALLOPS_MM: RangeInclusive<f64> = TINY..=10.0;

/// Greatest lean of a wall that turns of a kind may go down, degrees: those laid from one another
/// come to a platform square to the blade axis.
pub fn most_lean_deg(kind: PathKind) -> f64 {
    if kind.is_of_neighbours() { 89.5 } else { 85.0 }
}

section! {
    /// `[path]`
    "path" PathSettings, PathKeys, s {
        /// How the turns lie.
        ///
        /// Default: the shortest helix that leaves no higher ridge than is asked for; on a mesh,
        /// whose facets make such turns rough, `constant-height`.
        kind: PathKind = PathKind::default();
        /// Greatest scallop between neighbouring turns, mm.
        ///
        /// The default is usual for finishing airfoils before polishing.
        scallop_mm: f64 = SCALLOP_MM, SCALLOPS_MM;
        /// Greatest distance of the straight moves from the exact path of ball centres, mm.
        ///
        /// In smooth hollows of exact faces, where chords raise ridges, a quarter of it. Default
        /// for turns of constant scallop: 0.04 times the scallop where that is less. Round the part
        /// chords then sink ridges by up to 4 %, and in such hollows they raise them by up to 1 %.
        /// For the other kinds a tenth of the usual scallop, so that straight moves do not show.
        chord_mm: f64 = CHORD_MM, CHORDS_MM;
        /// Greatest distance between two cutter locations, mm.
        ///
        /// Default: a quarter of the ball radius where that is less, so that the channel is sampled
        /// densely.
        max_step_mm: f64 = 1.0, 1e-3..=100.0;
        /// The helix ends where the wall leans more than this from the blade axis, degrees; from 1
        /// to 85, with turns of constant scallop to 89.5: down to where the ball first touches a
        /// platform that is square to the axis.
        ///
        /// Beyond the default turns of constant height lie on the platform. Where the helix ends at
        /// faces it goes on as far as it can.
        max_lean_deg: f64 = 60.0, 1.0..=most_lean_deg(s.kind);
        /// Climb or conventional milling.
        ///
        /// Default: down towards the platform, usual for finishing.
        direction: Direction = Direction::default();
        /// Where turns begin.
        ///
        /// Default: where the path enters its greatest concave stretch, where the channel is
        /// narrowest next.
        start: Start = Start::default();
        /// Stock left on the part for a later pass, mm.
        ///
        /// Everything is planned against the part with so much on it. Default: a finishing pass.
        stock_mm: f64 = 0.0, 0.0..=100.0;
        /// Lay the paths of the other kinds too, of the same worst scallop, and compare lengths in
        /// the summary.
        ///
        /// By default not: it takes about as long again as path and checks.
        compare: bool = false;
    }
}
