//! Paths of cutters with a corner: from the corner's centres, which touch wherever θ stands, to the
//! disc's, which go with it.
//!
//! Path, channel and schedule are along the corner's centres, and so are arc lengths: the feed is
//! about that of the contact over the part. All that follows, motion, checks and programs, has
//! the discs' centres.

use std::borrow::Cow;

use crate::artifact::Toolpath;
use crate::tool::Tool;

/// A path with the centres of discs, at the angles θ of a schedule; that of a ball, or one that has
/// them, as it is.
pub(crate) fn placed<'p>(path: &'p Toolpath, tool: &Tool, theta: &[f64]) -> Cow<'p, Toolpath> {
    if tool.is_ball() || path.disc_radius_mm > 0.0 {
        return Cow::Borrowed(path);
    }
    let mut out = Toolpath { disc_radius_mm: tool.disc_radius_mm(), ..path.clone() };
    for (row, theta) in theta.iter().enumerate().take(path.locations.len()) {
        let l = &mut out.locations[row];
        let axis = path.cone(row).tool_axis(*theta);
        // Over a right angle from the normal it would touch with its back: no channel goes there,
        // and what is only compared with stands at a right angle.
        let along = axis - l.normal * axis.dot(&l.normal).min(0.0);
        l.centre = tool.centre_at(&l.contact, &l.normal, &along.normalize(), None).unwrap_or(l.centre);
    }
    Cow::Owned(out)
}
