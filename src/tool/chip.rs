//! `[cut]` of the job file: what each tooth of a cutter cuts, as limits of the contact's speed and
//! of its angle, and the marks that teeth leave along the feed.
//!
//! With `z` teeth at `n` turns of the spindle a second and the contact going over the part at `v`,
//! the feed per tooth is `fz = v / (n z)`. A ball of radius `r` at the depth `a` is engaged up to
//! `sin η = √(2 a r − a²) / r`, where the chip is thickest: `h = fz sin η`. Its contact at the
//! angle `α` from the tool axis cuts at `v_c = 2π n r sin α`. One tooth after the other leaves
//! marks of the height `fz² / 8 · (1/r + κ)` along the feed, `κ` the part's curvature there
//! (hollow: negative): the ridge of balls `fz` apart, to first order. What the tool goes on by
//! while a tooth is in the cut makes it up to `2 fz z / (2π r sin α)` of itself higher or lower.
//!
//! A corner of radius `r` that a disc of radius `R − r` carries cuts at `v_c = 2π n (R − r + r sin
//! α)`. Chip and marks are those of a ball of radius `r` where the cutter leans straight forwards,
//! and less where it leans aside too: the disc makes it flatter.

use std::f64::consts::TAU;

use super::Tool;
use crate::error::{Error, Result, Stage};
use crate::settings::{TINY, section};

section! {
    /// `[cut]`
    #[derive(Copy)]
    "cut" CutSettings, CutKeys, s {
        /// Teeth of the cutter. There is no default.
        teeth: u32 = 0, 1.0..=100.0;
        /// Least and greatest feed per tooth, mm.
        ///
        /// It is the speed of the contact over the part by teeth and spindle speed.
        #[serde(skip_serializing_if = "Option::is_none")]
        fz_mm: [f64; 2] as Option<[f64; 2]> = None;
        /// Least and greatest thickness of the chip at `depth_mm`, mm.
        #[serde(skip_serializing_if = "Option::is_none")]
        chip_mm: [f64; 2] as Option<[f64; 2]> = None;
        /// Depth of cut, mm: the stock before this operation. `chip_mm` needs it.
        #[serde(skip_serializing_if = "Option::is_none")]
        depth_mm: f64 as Option<f64> = None, TINY..=100.0;
        /// Least cutting speed at the contact, m/min: the tip of a ball does not cut.
        #[serde(skip_serializing_if = "Option::is_none")]
        speed_min_m_min: f64 as Option<f64> = None, 0.0..=1e5;
    }
}

/// What the teeth may cut, as limits of the contact.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Chip {
    /// Radius of the corner, a ball's own, mm.
    pub corner_mm: f64,
    /// Radius of the disc that the corner rolls over, mm; 0 for a ball.
    pub disc_mm: f64,
    /// Turns of the spindle a second.
    pub turns_per_s: f64,
    /// Sine of the angle from the contact up to which the corner is engaged; `None`: the job says
    /// no depth.
    pub sine_of_engagement: Option<f64>,
    /// Teeth a second: spindle speed by number of teeth.
    pub teeth_per_s: f64,
    /// Least and greatest speed of the contact over the part, mm/s; 0 and without end where none is
    /// asked for.
    pub contact_mm_s: [f64; 2],
    /// Least angle between tool axis and normal, rad.
    pub least_angle_rad: f64,
}

impl Chip {
    /// Of a tool at a spindle speed.
    ///
    /// # Errors
    /// `Usage` naming key, value and limits.
    pub fn of(cut: &CutSettings, tool: &Tool, spindle_rpm: f64) -> Result<Chip> {
        let (corner_mm, disc_mm) = (tool.corner_mm(), tool.disc_radius_mm());
        let bad = |m: String| Err(Error::usage(Stage::Job, m));
        if cut.teeth == 0 {
            return bad("cut.teeth is missing: how many teeth has the cutter?".into());
        }
        cut.check(Stage::Job)?;
        for (key, range) in [("cut.fz_mm", cut.fz_mm), ("cut.chip_mm", cut.chip_mm)] {
            if let Some([least, most]) = range.filter(|[a, b]| !(0.0 <= *a && a < b && b.is_finite())) {
                return bad(format!("{key} is [{least}, {most}], it must rise from 0 or more"));
            }
        }
        let turns_per_s = spindle_rpm / 60.0;
        let teeth_per_s = turns_per_s * f64::from(cut.teeth);
        let sine_of_engagement = cut.depth_mm.map(|depth| sine_of_engagement(depth, corner_mm));
        if cut.chip_mm.is_some() && sine_of_engagement.is_none() {
            return bad("cut.chip_mm needs cut.depth_mm: how deep is the cut?".into());
        }
        let of_chip = cut.chip_mm.zip(sine_of_engagement).map(|(chip, sine)| chip.map(|h| h / sine));
        let both = [cut.fz_mm, of_chip].into_iter().flatten();
        let fz = both.fold([0.0, f64::INFINITY], |a, b| [a[0].max(b[0]), a[1].min(b[1])]);
        if fz[0] >= fz[1] {
            return bad(format!(
                "cut.fz_mm and cut.chip_mm contradict one another: a feed per tooth of at least {:.4} mm and at most {:.4} mm",
                fz[0], fz[1]
            ));
        }
        let mut chip = Chip {
            corner_mm,
            disc_mm,
            turns_per_s,
            sine_of_engagement,
            teeth_per_s,
            contact_mm_s: fz.map(|fz| fz * teeth_per_s),
            least_angle_rad: 0.0,
        };
        if let Some(asked) = cut.speed_min_m_min {
            let greatest = chip.cutting_speed_m_min(1.0);
            if asked >= greatest {
                return bad(format!(
                    "cut.speed_min_m_min is {asked}, but a cutter of radius {} mm at {spindle_rpm} 1/min cuts at {greatest:.1} m/min at most",
                    corner_mm + disc_mm
                ));
            }
            let out_mm = (corner_mm + disc_mm) * asked / greatest;
            chip.least_angle_rad = ((out_mm - disc_mm) / corner_mm).max(0.0).asin();
        }
        Ok(chip)
    }

    /// Feed per tooth, mm, where the contact goes over the part at `contact_mm_s`.
    pub fn feed_per_tooth_mm(&self, contact_mm_s: f64) -> f64 {
        contact_mm_s / self.teeth_per_s
    }

    /// Cutting speed of the contact at an angle from the tool axis with this sine, m/min.
    pub fn cutting_speed_m_min(&self, sine: f64) -> f64 {
        TAU * self.turns_per_s * (self.disc_mm + self.corner_mm * sine) * 60.0 / 1000.0
    }

    /// Height of the marks of single teeth, mm, where the centre of ball or corner goes `ratio`
    /// times as fast as the contact: `1 + r κ`.
    pub fn mark_mm(&self, contact_mm_s: f64, ratio: f64) -> f64 {
        self.feed_per_tooth_mm(contact_mm_s).powi(2) / 8.0 * ratio / self.corner_mm
    }
}

/// Sine of the angle from its contact up to which a ball is engaged at a depth.
fn sine_of_engagement(depth_mm: f64, radius_mm: f64) -> f64 {
    let depth = depth_mm.min(radius_mm);
    (2.0 * depth * radius_mm - depth * depth).sqrt() / radius_mm
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used)]
    use super::*;
    use crate::sample;

    fn ball(radius_mm: f64) -> Tool {
        Tool { radius_mm, ..sample::tool() }
    }

    fn cut() -> CutSettings {
        CutSettings { teeth: 2, ..CutSettings::default() }
    }

    #[test]
    fn limits_are_those_of_teeth_depth_and_speed() {
        // R 6, depth 0.2, fz 0.1: a chip of 0.0256 mm.
        assert!((0.1 * sine_of_engagement(0.2, 6.0) - 0.025_603_8).abs() < 1e-6);
        let c = Chip::of(&CutSettings { fz_mm: Some([0.02, 0.1]), ..cut() }, &ball(6.0), 3000.0).unwrap();
        assert!((c.contact_mm_s[0] - 2.0).abs() < 1e-9 && (c.contact_mm_s[1] - 10.0).abs() < 1e-9);
        let chip = CutSettings { chip_mm: Some([0.0, 0.01]), depth_mm: Some(0.2), ..cut() };
        let c = Chip::of(&chip, &ball(6.0), 3000.0).unwrap();
        assert!((c.contact_mm_s[1] - 100.0 * 0.01 / sine_of_engagement(0.2, 6.0)).abs() < 1e-9);
        let slow = CutSettings { speed_min_m_min: Some(30.0), ..cut() };
        let c = Chip::of(&slow, &ball(6.0), 3000.0).unwrap();
        assert!((c.least_angle_rad.sin() - 30.0 / (TAU * 6.0 * 3.0)).abs() < 1e-12);
        assert!(c.contact_mm_s[1] == f64::INFINITY && c.contact_mm_s[0] == 0.0);
    }

    #[test]
    fn a_corner_cuts_farther_out_than_its_ball() {
        let bull = Tool { radius_mm: 8.0, corner_radius_mm: Some(2.0), ..sample::tool() };
        let chip = CutSettings { chip_mm: Some([0.0, 0.01]), depth_mm: Some(0.2), ..cut() };
        let c = Chip::of(&chip, &bull, 3000.0).unwrap();
        assert!((c.contact_mm_s[1] - 100.0 * 0.01 / sine_of_engagement(0.2, 2.0)).abs() < 1e-9);
        // Where it touches with its greatest radius it cuts like any cutter of that, where its axis
        // is along the normal like one of the disc's.
        assert!((c.cutting_speed_m_min(1.0) - TAU * 50.0 * 8.0 * 0.06).abs() < 1e-9);
        assert!((c.cutting_speed_m_min(0.0) - TAU * 50.0 * 6.0 * 0.06).abs() < 1e-9);
        let at_least = |speed_min_m_min: f64| {
            let slow = CutSettings { speed_min_m_min: Some(speed_min_m_min), ..cut() };
            Chip::of(&slow, &bull, 3000.0).unwrap()
        };
        assert_eq!(at_least(100.0).least_angle_rad, 0.0);
        let c = at_least(130.0);
        assert!((c.cutting_speed_m_min(c.least_angle_rad.sin()) - 130.0).abs() < 1e-9);
    }

    #[test]
    fn what_cannot_be_is_told() {
        let said = |c: CutSettings| Chip::of(&c, &ball(6.0), 3000.0).unwrap_err().message;
        assert!(said(CutSettings::default()).contains("cut.teeth is missing"));
        assert!(said(CutSettings { chip_mm: Some([0.0, 0.1]), ..cut() }).contains("needs cut.depth_mm"));
        assert!(said(CutSettings { fz_mm: Some([0.2, 0.1]), ..cut() }).contains("must rise"));
        assert!(said(CutSettings { fz_mm: Some([f64::NAN, 0.1]), ..cut() }).contains("must rise"));
        let both = CutSettings { fz_mm: Some([0.2, 0.3]), chip_mm: Some([0.0, 0.01]), depth_mm: Some(0.2), ..cut() };
        assert!(said(both).contains("contradict"));
        assert!(said(CutSettings { speed_min_m_min: Some(500.0), ..cut() }).contains("at most"));
    }

    /// Height that the teeth of a ball leave on a round part of radius `part_mm` along the feed,
    /// each where its edge comes by: the tool axis leans by `angle` from the normal across the
    /// feed.
    fn left_by_teeth(radius_mm: f64, teeth: u32, fz_mm: f64, part_mm: f64, angle: f64) -> f64 {
        let (step, per_tooth) = (TAU / f64::from(teeth), fz_mm / part_mm);
        // The edge's point in the plane of the feed at an angle of the spindle: its azimuth about
        // the part's centre and its height over the part, from where the tool is then.
        let at = |tooth: i32, turned: f64| {
            let up = (angle.tan() / turned.cos()).atan();
            let (around, along) = (radius_mm * up.sin(), -radius_mm * up.cos());
            let x = around * turned.sin();
            let y = part_mm + radius_mm + along * angle.cos() - around * turned.cos() * angle.sin();
            (per_tooth * (f64::from(tooth) + turned / step) + x.atan2(y), x.hypot(y) - part_mm)
        };
        let left_at = |azimuth: f64| {
            let of = |tooth: i32| {
                let (mut low, mut high) = (-1.0, 1.0);
                for _ in 0..60 {
                    let middle = 0.5 * (low + high);
                    if at(tooth, middle).0 < azimuth { low = middle } else { high = middle }
                }
                at(tooth, low).1
            };
            (-2..=3).map(of).fold(f64::INFINITY, f64::min)
        };
        (0..=200).map(|k| left_at(per_tooth * f64::from(k) / 200.0)).fold(0.0, f64::max)
    }

    #[test]
    fn marks_are_those_of_turning_teeth() {
        let cases =
            [(6.0, 2, 0.1, 1e4, 0.9), (6.0, 2, 0.1, 40.0, 0.9), (4.0, 2, 0.08, 15.0, 1.2), (8.0, 4, 0.08, 25.0, 1.1)];
        for (radius, teeth, fz, part, angle) in cases {
            let chip = Chip::of(&CutSettings { teeth, ..CutSettings::default() }, &ball(radius), 600.0).unwrap();
            let formula = chip.mark_mm(fz * chip.teeth_per_s, 1.0 + radius / part);
            let found = left_by_teeth(radius, teeth, fz, part, angle);
            assert!((found / formula - 1.0).abs() < 0.02, "R {radius}, z {teeth}: {found} beside {formula}");
        }
    }
}
