//! `[schedule]` of the job file.

use crate::artifact::schedule::{BaseAngle, MARGIN_DEG, Measure, ScheduleKind, Scope};
use crate::settings::section;

section! {
    /// `[schedule]`
    #[derive(Copy)]
    "schedule" ScheduleSettings, ScheduleKeys, s {
        /// How θ(S) is made.
        ///
        /// Default: the fastest of all kinds that never turns back and stays in the channel.
        kind: ScheduleKind = ScheduleKind::Time;
        /// Where kind `piecewise` stands at the start of each turn.
        ///
        /// The published method says `forward-limit`.
        base_angle: BaseAngle = BaseAngle::default();
        /// What kind `optimal` makes least.
        ///
        /// Default: the rotary axis' greatest acceleration at constant feed.
        measure: Measure = Measure::default();
        /// Over how much of the path at once.
        scope: Scope = Scope::default();
        /// Room that the schedule keeps from the channel's walls where there is room, degrees.
        ///
        /// Between cutter locations the walls are known by linear interpolation only; this covers
        /// it. Servo lag and set-up errors of a table stay far below the default. Where the channel
        /// is narrower than four margins, a quarter of its width is kept instead, with a warning.
        margin_deg: f64 = MARGIN_DEG, 0.0..=45.0;
        /// Lead of kind `fixed`: angle of the tool axis ahead of the surface normal, degrees.
        ///
        /// The default is in the middle of what CAM systems offer for ball-end finishing: it keeps
        /// the tip off the surface.
        lead_deg: f64 = 15.0, -85.0..=85.0;
        /// Offset of the tool from the blade axis that kind `eccentric` keeps, mm: the Y of the
        /// ball centre where the blade axis is X and the tool comes from +Z.
        ///
        /// Default: the offset with most room in the channel.
        #[serde(skip_serializing_if = "Option::is_none")]
        offset_mm: f64 as Option<f64> = None, -1e4..=1e4;
        /// How far outside the channel the kinds `lower-wall` and `upper-wall` run, degrees; for
        /// trying the channel.
        #[serde(skip_serializing_if = "is_zero")]
        beyond_wall_deg: f64 = 0.0, 0.0..=45.0;
    }
}

fn is_zero(value: &f64) -> bool {
    *value == 0.0
}
