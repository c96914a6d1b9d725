//! `[channel]` of the job file.

use crate::settings::section;
use crate::tool::{CLEARANCE_MM, HOLDER_CLEARANCE_MM};

section! {
    /// `[channel]`
    "channel" ChannelSettings, ChannelKeys, s {
        /// Room that taper and shank keep from the part, mm.
        ///
        /// The cone leaves the ball tangentially: much more than the default would forbid contact
        /// near the ball's equator.
        clearance_mm: f64 = CLEARANCE_MM, 0.0..=100.0;
        /// Room that the holder keeps from the part, mm.
        ///
        /// Holders are less well known than cutters.
        holder_clearance_mm: f64 = HOLDER_CLEARANCE_MM, 0.0..=100.0;
        /// Least angle between tool axis and surface normal, degrees.
        ///
        /// Near the tip of the ball the cutting speed vanishes; a pivot B of a few degrees keeps
        /// walls parallel to the blade axis away from the tip already. A limit above 0 cuts the
        /// channel in two wherever the normal comes near the axis. A cutter with a corner leans by
        /// 3° at least where nothing else is asked for, so that the back of its bottom is clear.
        contact_angle_min_deg: f64 = 0.0, 0.0..=90.0;
        /// Greatest angle between tool axis and surface normal, degrees.
        ///
        /// Over 90° the ball would cut with its upper half. Passes of a cutter with a corner are
        /// laid for this angle; by default it is 12° then.
        contact_angle_max_deg: f64 = 90.0, s.contact_angle_min_deg..=180.0;
        /// Least and greatest offset of the tool from the blade axis, mm: the Y of the ball centre
        /// where the blade axis is X and the tool comes from +Z.
        ///
        /// Default: what the machine's travel leaves. For a lathe with little travel of Y.
        #[serde(skip_serializing_if = "Option::is_none")]
        offset_mm: [f64; 2] as Option<[f64; 2]> = None;
        /// Tolerance of the channel's ends, degrees.
        ///
        /// Always on the safe side. The default is well below what a rotary table repeats.
        tolerance_deg: f64 = 0.01, 1e-4..=5.0;
        /// Prove the walls for the moves between locations too, and move them inwards where they do
        /// not hold; slow. Default: only for schedules along a wall.
        ///
        /// Such a schedule may jump from one location to the next. Otherwise walls are taken as
        /// straight between locations, and the clearance check covers the motion that is used: a
        /// proof takes milliseconds a move.
        prove_moves: bool = false;
        /// Ends of the channel from exact faces, to the tolerance; otherwise the deflection of
        /// their mesh is kept as room.
        ///
        /// Nothing changes where the part is a mesh. By default not: a channel takes several times
        /// as long (8 s of processor time for 39,000 locations of `steam_root`, instead of 1; 24 s,
        /// instead of 2, with a fir-tree root). Keeping the deflection is safe and timid: the
        /// narrowest place of these two is 0.9 and 3.2 degrees narrower. A channel that is closed
        /// for that is looked at by the exact faces in any case. With `prove_moves` what the index
        /// of the part lies off it is kept as room instead, some ten-thousandths of the ball's
        /// radius where it is the finer one.
        exact_ends: bool = false;
        /// Show the channel's width at other angles B in the report; takes some seconds.
        ///
        /// It changes no plan; `channel --sweep-b` writes it as a table too.
        sweep_b: bool = false;
    }
}
