//! Travel and swing against the machine's limits.

use super::Machine;
use crate::artifact::AxisMotion;

/// The worst position of one axis outside its travel.
#[derive(Clone, Debug, PartialEq, serde::Serialize)]
pub struct TravelFinding {
    /// `X`, `Y`, `Z`, `A`, `B` or `C`.
    pub axis: String,
    /// Cutter location where it is worst.
    pub row: usize,
    /// Position there, mm or rad.
    pub position: f64,
    /// The limit that it passes, mm or rad.
    pub limit: f64,
    /// By how much, mm or rad.
    pub excess: f64,
}

impl std::fmt::Display for TravelFinding {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let linear = ["X", "Y", "Z"].contains(&self.axis.as_str());
        let (scale, unit) = if linear { (1.0, "mm") } else { (1f64.to_degrees(), "deg") };
        let [p, l, e] = [self.position, self.limit, self.excess].map(|v| v * scale);
        write!(
            f,
            "{} is at {p:.3} {unit} at location {}, {e:.3} {unit} past its limit {l:.3} {unit}",
            self.axis, self.row
        )
    }
}

impl Machine {
    /// Axes that leave their travel, each with its worst location; empty where all is well. A position that is not a
    /// number counts as outside.
    pub fn check_travel(&self, motion: &AxisMotion) -> Vec<TravelFinding> {
        let mut out = Vec::new();
        let names = self.axis_names();
        for (i, limits) in self.limits().iter().enumerate() {
            let Some([lo, hi]) = limits.travel else { continue };
            let mut worst: Option<TravelFinding> = None;
            for (row, q) in motion.position.iter().enumerate() {
                let v = q[i];
                if (lo..=hi).contains(&v) {
                    continue;
                }
                let (limit, excess) = if v < lo { (lo, lo - v) } else { (hi, v - hi) };
                if worst.as_ref().is_none_or(|w| excess > w.excess) {
                    worst = Some(TravelFinding { axis: names[i].into(), row, position: v, limit, excess });
                }
            }
            out.extend(worst);
        }
        out
    }

    /// Whether a part whose farthest point from the table's axis is `radius_mm` away turns freely.
    pub fn swings(&self, radius_mm: f64) -> bool {
        2.0 * radius_mm <= self.swing_diameter_mm
    }
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used)]
    use super::*;

    #[test]
    fn the_worst_location_of_each_axis_is_named() {
        let m = Machine::demo().unwrap();
        let mut q = vec![[100.0, 0.0, 200.0, 1e4, 0.1]; 5];
        q[1][1] = 331.0;
        q[2][1] = -340.0;
        q[3][4] = 1.6;
        let z = vec![[0.0; 5]; 5];
        let motion = AxisMotion {
            t_s: vec![0.0; 5],
            position: q,
            velocity: z.clone(),
            acceleration: z.clone(),
            jerk: z,
            feed: vec![0.0; 5],
            time_s: 0.0,
        };
        let found = m.check_travel(&motion);
        assert_eq!(found.len(), 2);
        assert_eq!((found[0].axis.as_str(), found[0].row, found[0].excess), ("Y", 2, 10.0));
        assert_eq!((found[1].axis.as_str(), found[1].row), ("B", 3));
        assert!(found[0].to_string().contains("Y is at -340.000 mm at location 2, 10.000 mm past"));
        assert!(m.swings(325.0) && !m.swings(325.1));
    }
}
