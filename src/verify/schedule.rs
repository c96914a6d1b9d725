//! The schedule: θ never turns back and stays inside the channel at every cutter location.

use crate::artifact::report::Check;
use crate::artifact::{Blade, CheckId, Plan};

use super::VerifyOptions;

/// Greatest value and its index; the first one of equals. (0, 0) when all values are below 0.
fn greatest(values: impl Iterator<Item = f64>) -> (f64, usize) {
    values.enumerate().fold((0.0, 0), |best, (i, v)| if v > best.0 { (v, i) } else { best })
}

/// The checks `theta-reversal` and `theta-channel`.
pub(super) fn check(plan: &Plan, blade: &Blade, options: &VerifyOptions) -> Vec<Check> {
    let theta = &plan.schedule.theta;
    let forward = if theta[theta.len() - 1] >= theta[0] { 1.0 } else { -1.0 };
    let back = |i: usize| (-(theta[i + 1] - theta[i]) * forward).to_degrees();
    let limit = options.angle_tolerance_deg;
    let (worst, before) = greatest((0..theta.len() - 1).map(back));
    let count = (0..theta.len() - 1).filter(|&i| back(i) > limit).count();
    let quantity = "greatest step of θ against the direction of travel, degrees";
    let reversal = Check::at_most(CheckId::ThetaReversal, quantity, worst, limit, "deg", format!("{count} reversals"));
    let reversal = reversal.at_location(before + 1, plan, blade);
    let outside = |i: usize| {
        let row = &plan.channel.rows[i];
        (row.theta_min - theta[i]).max(theta[i] - row.theta_max).to_degrees()
    };
    let (worst, row) = greatest((0..theta.len()).map(outside));
    let binds = &plan.channel.rows[row];
    let note =
        if worst > limit { format!("between {:?} and {:?}", binds.binds_min, binds.binds_max) } else { String::new() };
    let quantity = "how far θ lies outside the channel, degrees";
    let channel = Check::at_most(CheckId::ThetaChannel, quantity, worst, limit, "deg", note);
    // An axis that swings turns back.
    let reversal = plan.channel.sweep.is_round().then_some(reversal);
    reversal.into_iter().chain([channel.at_location(row, plan, blade)]).collect()
}
