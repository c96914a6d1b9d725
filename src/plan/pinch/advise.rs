//! The leans of both tools, looked at together.

use super::{Setup, narrowest, still_rows};
use crate::artifact::{Cone, PairedRows};
use crate::error::{Error, ErrorKind, Result, Stage};
use crate::observe::{Observer, timed};
use crate::pair::{FreeAngles, PinchOrientation, PinchTopology};
use crate::parallel;

/// Places of the rows that leans are looked at for, about.
const PLACES: usize = 1500;
/// Shares of the places that differ by less count as equal.
const SAME_SHARE: f64 = 0.001;

/// What two leans let both tools do.
#[derive(Clone, Debug, PartialEq, serde::Serialize)]
pub struct LeanPair {
    /// Those of tool 1 and tool 2, degrees.
    pub b_deg: [f64; 2],
    /// Share of the places of the rows that are cut: at the others no angle of the table is free
    /// for both, or rows end there.
    pub open_share: f64,
    /// Rows, and those of them along which the table need not turn.
    pub rows: usize,
    /// See `rows`.
    pub still_rows: usize,
    /// Width of what is free for both at the narrowest place that is cut, degrees.
    pub narrowest_deg: f64,
    /// Height of tool 1's ball centre there, mm.
    pub narrowest_at_mm: f64,
}

/// Leans of both tools.
#[derive(Clone, Debug, PartialEq, serde::Serialize)]
pub struct PinchAdvice {
    /// Places that were looked at.
    pub places: usize,
    /// Leans that were looked at for either tool, degrees.
    pub angles_deg: Vec<f64>,
    /// With the leans of the job; `None`: no row is open.
    pub now: Option<LeanPair>,
    /// All that open a row, the best first: most places, then fewest rows along which the table
    /// turns, then the widest narrowest place.
    pub open: Vec<LeanPair>,
}

impl Setup {
    /// Looks at pairs of leans at some places of the rows.
    ///
    /// # Errors
    /// Those of [`Setup::pinch`], but for a pair that opens nothing; `Cancelled`.
    pub fn pinch_advice(&self, angles_deg: &[f64], observer: &dyn Observer) -> Result<PinchAdvice> {
        if self.pinch_settings().topology == PinchTopology::DoubleHelix {
            let message = "leans are advised for rows of opposite places, and pinch.topology is double-helix";
            return Err(Error::usage(Stage::Job, message).advise("leave out pinch.topology"));
        }
        // The job's own leans must be some that the machine has.
        self.between_heads(&self.pinch_settings(), self.pinch_cones())?;
        let all = self.paired_rows(observer)?;
        let rows = all.thinned(all.places.len().div_ceil(PLACES));
        let around = timed(observer, Stage::Channel, || self.around_both())?;
        let own_deg = self.pinch_cones().map(|c| c.lean_rad.to_degrees());
        let free = |tool: usize, deg: f64| {
            self.free_angles(around.of(tool), &rows, (tool, Cone::about_blade(deg.to_radians())), observer)
        };
        let each = |tool: usize| -> Result<Vec<(f64, Vec<FreeAngles>)>> {
            let all = angles_deg.iter().copied().enumerate();
            all.map(|(k, deg)| {
                observer.check(Stage::Channel)?;
                observer.progress(Stage::Channel, tool * angles_deg.len() + k, 2 * angles_deg.len());
                Ok((deg, free(tool, deg)?))
            })
            .collect()
        };
        let (first, second) = timed(observer, Stage::Channel, || Ok((each(0)?, each(1)?)))?;
        let now = timed(observer, Stage::Channel, || {
            self.lean_pair(&rows, own_deg, [&free(0, own_deg[0])?, &free(1, own_deg[1])?], observer)
        })?;
        let pairs: Vec<_> = first.iter().flat_map(|a| second.iter().map(move |b| (a, b))).collect();
        let looked = timed(observer, Stage::Schedule, || {
            parallel::try_map(&pairs, |(a, b)| {
                observer.check(Stage::Schedule)?;
                self.lean_pair(&rows, [a.0, b.0], [&a.1, &b.1], observer)
            })
        })?;
        let mut open: Vec<LeanPair> = looked.into_iter().flatten().collect();
        let in_shares = |p: &LeanPair| (p.open_share / SAME_SHARE).round();
        let turning = |p: &LeanPair| p.rows - p.still_rows;
        open.sort_by(|a, b| {
            let by_turns = turning(a).cmp(&turning(b));
            let by_width = b.narrowest_deg.total_cmp(&a.narrowest_deg);
            in_shares(b).total_cmp(&in_shares(a)).then(by_turns).then(by_width)
        });
        Ok(PinchAdvice { places: rows.places.len(), angles_deg: angles_deg.to_vec(), now, open })
    }

    /// What a pair of leans lets both tools do; `None` where it opens no row.
    fn lean_pair(
        &self,
        rows: &PairedRows,
        b_deg: [f64; 2],
        free: [&[FreeAngles]; 2],
        observer: &dyn Observer,
    ) -> Result<Option<LeanPair>> {
        let cones = b_deg.map(|deg| Cone::about_blade(deg.to_radians()));
        let shared = self.between_heads(&self.pinch_settings(), cones).and_then(|between_rad| {
            self.shared(rows, free.map(<[_]>::to_vec), (cones, between_rad), PinchOrientation::Hold, observer)
        });
        let shared = match shared {
            Err(e) if e.kind == ErrorKind::Infeasible => return Ok(None),
            // A lean that a head does not reach.
            Err(e) if e.stage == Stage::Machine => return Ok(None),
            shared => shared?,
        };
        let (least_rad, at) = narrowest(&shared.common).unwrap_or((0.0, 0));
        Ok(Some(LeanPair {
            b_deg,
            open_share: shared.rows.places.len() as f64 / rows.places.len().max(1) as f64,
            rows: shared.rows.rows.len(),
            still_rows: still_rows(&shared.planned.held),
            narrowest_deg: least_rad.to_degrees(),
            narrowest_at_mm: shared.rows.places.get(at).map_or(f64::NAN, |p| p.contacts[0].centre.x),
        }))
    }
}
