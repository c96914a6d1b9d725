//! Travel and swing against the machine's limits.

use std::f64::consts::{FRAC_PI_2, PI};

use super::{Axis, Machine};
use crate::artifact::axis_travel::Affine;
use crate::artifact::{AxisMotion, AxisTravel, PartAmong};
use crate::error::{Error, Infeasible, Result, Stage};
use crate::geometry::Point;
use crate::geometry::part::Part;

/// Distance between points by which affine functions are found, mm.
const UNIT_MM: f64 = 100.0;

/// The worst position of one axis outside its travel.
#[derive(Clone, Debug, PartialEq)]
pub struct TravelFinding {
    /// The axis.
    pub axis: Axis,
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
        let (scale, unit) = (self.axis.scale(), self.axis.unit());
        let [p, l, e] = [self.position, self.limit, self.excess].map(|v| v * scale);
        write!(
            f,
            "{} is at {p:.3} {unit} at location {}, {e:.3} {unit} past its limit {l:.3} {unit}",
            self.axis.name, self.row
        )
    }
}

impl Machine {
    /// Axes that leave their travel, each with its worst location; empty where all is well. A
    /// position that is not a number counts as outside.
    pub fn check_travel(&self, motion: &AxisMotion) -> Vec<TravelFinding> {
        let mut out = Vec::new();
        for (i, axis) in self.axes().iter().enumerate() {
            let Some([lo, hi]) = axis.limits.travel else { continue };
            let mut worst: Option<TravelFinding> = None;
            for (row, q) in motion.position.iter().enumerate() {
                let v = q[i];
                if (lo..=hi).contains(&v) {
                    continue;
                }
                let (limit, excess) = if v < lo { (lo, lo - v) } else { (hi, v - hi) };
                if worst.as_ref().is_none_or(|w| excess > w.excess) {
                    worst = Some(TravelFinding { axis: axis.clone(), row, position: v, limit, excess });
                }
            }
            out.extend(worst);
        }
        out
    }

    /// The linear axes' travel as limits of θ at one lean, for a gauge length, mm; empty where more
    /// than one rotary axis moves while the tool goes round the blade.
    pub fn travels(&self, lean_rad: f64, gauge_length_mm: f64) -> Vec<AxisTravel> {
        if !self.turns_the_blade() {
            return Vec::new();
        }
        let corners = [
            Point::origin(),
            Point::new(UNIT_MM, 0.0, 0.0),
            Point::new(0.0, UNIT_MM, 0.0),
            Point::new(0.0, 0.0, UNIT_MM),
        ];
        let one = |k: usize| -> Option<AxisTravel> {
            let axis = &self.axes()[k];
            let limits_mm = axis.limits.travel?;
            let at = |corner: &Point, theta: f64| self.inverse(corner, theta, lean_rad, gauge_length_mm)[k];
            let waves = corners.map(|c| {
                let (ahead, beside, back) = (at(&c, 0.0), at(&c, FRAC_PI_2), at(&c, PI));
                let mean = 0.5 * (ahead + back);
                [mean, 0.5 * (ahead - back), beside - mean]
            });
            let [mean, cos, sin] = [0, 1, 2].map(|w| -> Affine {
                let [origin, x, y, z] = waves.map(|v| v[w]);
                [origin, (x - origin) / UNIT_MM, (y - origin) / UNIT_MM, (z - origin) / UNIT_MM]
            });
            let finite = [mean, cos, sin].as_flattened().iter().all(|v| v.is_finite());
            finite.then(|| AxisTravel {
                name: format!("axis {}", axis.name),
                column: Some(k),
                limits_mm,
                mean,
                cos,
                sin,
            })
        };
        self.linear().into_iter().filter_map(one).collect()
    }

    /// The distance from the blade axis within which everything is that the table turns, mm: the
    /// greatest of a point of the part or of what stands about it from the table's axis, and that
    /// of the blade axis. `None` on a machine on which the blade stands still.
    pub fn turns_within_mm(&self, part: &PartAmong) -> Option<f64> {
        let off = |p: &Point| self.off_table_axis_mm(p);
        let farthest = |b: &Part| b.mesh.points.iter().filter_map(off).fold(0.0, f64::max) + b.deflection_mm;
        off(&Point::origin()).map(|own| part.bodies().map(farthest).fold(0.0, f64::max) + own)
    }

    /// Time of a rapid from one position to another, all axes at once: that of the slowest, s.
    pub fn rapid_s(&self, from: &[f64], to: &[f64]) -> f64 {
        let ways = from.iter().zip(to).map(|(a, b)| (b - a).abs());
        self.axes().iter().zip(ways).map(|(axis, way)| axis.limits.rest_to_rest_s(way)).fold(0.0, f64::max)
    }

    /// Whether a part of these points (blade frame, mm) turns freely.
    ///
    /// # Errors
    /// Kind `Infeasible`: a point is farther from the table's axis than half of
    /// `swing_diameter_mm`.
    pub fn check_swing(&self, part: &[Point]) -> Result<()> {
        let radius_mm = part.iter().filter_map(|p| self.off_table_axis_mm(p)).fold(0.0, f64::max);
        if 2.0 * radius_mm <= self.swing_diameter_mm {
            return Ok(());
        }
        Err(Error::infeasible(
            Stage::Machine,
            format!(
                "the part does not turn freely on the machine {}: it reaches {radius_mm:.1} mm from the table's axis, and \
                 swing_diameter_mm = {} leaves {}",
                self.name,
                self.swing_diameter_mm,
                0.5 * self.swing_diameter_mm
            ),
            Infeasible::Swing { reach_mm: radius_mm, swing_diameter_mm: self.swing_diameter_mm },
        )
        .advise("name a machine that takes it with --set machine.file=…, or the unit with --unit if the part is not that large; --until channel plans without the machine's room"))
    }
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used)]
    use super::*;
    use crate::artifact::AxisRows;
    use crate::machine::{DEMO_TOML, MachineFile};

    #[test]
    fn rapids_take_a_trapezoid_or_a_triangle() {
        let machine = Machine::demo().unwrap();
        let turning = machine.turning_axis();
        let time = |deg: f64| {
            let mut to = vec![0.0; machine.axes().len()];
            to[turning] = deg.to_radians();
            machine.rapid_s(&vec![0.0; to.len()], &to)
        };
        // 180 degrees a second after 0.3 s: 27 degrees on the way there, and as many to a halt.
        assert!((time(54.0) - 0.6).abs() < 1e-12);
        assert!((time(54.0 + 180.0) - 1.6).abs() < 1e-12);
        assert!((time(-6.0) - 0.2).abs() < 1e-12);
        assert_eq!(time(0.0), 0.0);
    }

    #[test]
    fn the_worst_location_of_each_axis_is_named() {
        let m = Machine::demo().unwrap();
        let mut q: AxisRows = [[100.0, 0.0, 200.0, 1e4, 0.1]; 5].into_iter().collect();
        q[1][1] = 331.0;
        q[2][1] = -340.0;
        q[3][4] = 1.6;
        let z: AxisRows = [[0.0; 5]; 5].into_iter().collect();
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
        assert_eq!((found[0].axis.name.as_str(), found[0].row, found[0].excess), ("Y", 2, 10.0));
        assert_eq!((found[1].axis.name.as_str(), found[1].row), ("B", 3));
        assert!(found[0].to_string().contains("Y is at -340.000 mm at location 2, 10.000 mm past"));
    }

    #[test]
    fn travel_as_a_limit_of_the_angle_is_that_of_the_kinematics() {
        use crate::artifact::axis_travel::offset_mm;
        let folder = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("models/machines");
        let mut chains = 0;
        for entry in std::fs::read_dir(folder).unwrap() {
            let text = std::fs::read_to_string(entry.unwrap().path()).unwrap();
            let m = Machine::from_toml(&text, "machine").unwrap();
            let lean = if m.leans(0.2) { 0.2 } else { 0.0 };
            let travels = m.travels(lean, 130.0);
            assert_eq!(travels.is_empty(), !m.turns_the_blade(), "{}", m.name);
            for (travel, k) in travels.iter().zip(m.linear()) {
                for i in 0..50 {
                    let f = f64::from(i);
                    let c = Point::new(30.0 * f, 40.0 * (0.3 * f).sin(), 25.0 * (0.7 * f).cos());
                    let q = m.inverse(&c, 0.9 * f, lean, 130.0)[k];
                    assert!((travel.at(&c, 0.9 * f) - q).abs() < 1e-9, "{} {}", m.name, travel.name);
                }
                chains += 1;
            }
        }
        assert!(chains >= 9);
        // The offset is the Y of the demo machine.
        let m = Machine::demo().unwrap();
        let c = Point::new(5.0, 12.0, -7.0);
        for theta in [-2.0, 0.1, 1.4, 9.0] {
            let y = m.inverse(&c, theta, 0.1, 130.0)[1];
            assert!((y - offset_mm(&c, theta)).abs() < 1e-9);
        }
    }

    #[test]
    fn a_part_turns_freely_within_the_swing_of_the_table() {
        let m = Machine::demo().unwrap();
        assert!(m.check_swing(&[Point::new(5000.0, 300.0, 100.0)]).is_ok());
        let e = m.check_swing(&[Point::origin(), Point::new(0.0, 300.0, -200.0)]).unwrap_err();
        assert_eq!(e.kind, crate::error::ErrorKind::Infeasible);
        assert!(e.message.contains("reaches 360.6 mm") && e.message.contains("650"), "{}", e.message);
        // Mounted off the axis, and clamped turned, a part needs more room.
        let mut off = MachineFile::from_toml(DEMO_TOML, "demo").unwrap();
        off.mount.offset_mm = [0.0, 20.0, 0.0];
        off.mount.clamping_deg = 90.0;
        let off = off.build("demo").unwrap();
        assert!((off.off_table_axis_mm(&Point::new(3.0, 0.0, 300.0)).unwrap() - 280.0).abs() < 1e-9);
        let file = |name: &str| {
            let path = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("models/machines").join(name);
            Machine::from_toml(&std::fs::read_to_string(path).unwrap(), name).unwrap()
        };
        // A chain: about the axis nearest to the workpiece; two heads let the blade stand still.
        let p = Point::new(10.0, 900.0, 0.0);
        assert!(file("trunnion_ac.toml").check_swing(&[p]).is_err());
        let heads = file("fork_head_ca.toml");
        assert!(heads.off_table_axis_mm(&p).is_none() && heads.check_swing(&[p * 10.0]).is_ok());
    }
}
