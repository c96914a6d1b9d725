//! The published smoothing of both tools' axes, to compare with: what it starts from, and what it
//! comes to.

use std::ops::Range;

use super::Pinch;
use crate::artifact::paired::Held;
use crate::artifact::{Cone, PairedRows};
use crate::geometry::Point;
use crate::numerics::angle::nearest_turn;
use crate::pair;
use crate::plan::Setup;
use crate::verify::{self, PinchWork};

/// Normals nearer to the blade axis than this have no azimuth (sine of the angle).
const ALONG_AXIS: f64 = 1e-6;

/// What the published smoothing of both tools' axes comes to. Steepest turning: what the axis of
/// tool 1 and of tool 2 turns by per mm of its contact's way at most, rad/mm.
#[derive(Clone, Debug, PartialEq, serde::Serialize)]
pub struct PublishedFigures {
    /// Steepest turning at the fixed angle to tool 1's normal.
    pub fixed_rad_mm: [f64; 2],
    /// Places at which that angle is not free for both tools.
    pub fixed_outside: usize,
    /// Steepest turning of the posture curves.
    pub posture_rad_mm: [f64; 2],
    /// Places at which their angles are not free for both tools.
    pub posture_outside: usize,
    /// Rows along which local smoothing finds no angles: they are cut with the table still.
    pub rows_without: usize,
}

/// Angles of the published smoothing at all places, rad.
pub(super) struct Postures {
    /// At a fixed angle to tool 1's normal.
    pub(super) fixed_rad: Vec<f64>,
    /// Of the posture curves through these.
    pub(super) curve_rad: Vec<f64>,
}

impl Setup {
    /// The angles at a fixed angle to tool 1's normal, and those of the posture curves through
    /// them.
    pub(super) fn postures(&self, rows: &PairedRows, cone: Cone) -> Postures {
        let lead_rad = self.job.schedule.lead_deg.to_radians();
        let mut out = Postures { fixed_rad: Vec::new(), curve_rad: Vec::new() };
        for row in &rows.rows {
            let (mut last, mut s_mm) = (0.0, 0.0);
            let (mut fixed, mut ways): (Vec<f64>, Vec<f64>) = Default::default();
            let contacts = rows.places[row.clone()].iter().map(|p| p.contacts[0]);
            let mut before: Option<Point> = None;
            for c in contacts {
                last = cone.theta_of(&c.normal, ALONG_AXIS).map_or(last, |at| nearest_turn(at + lead_rad, last));
                s_mm += before.replace(c.contact).map_or(0.0, |b| (c.contact - b).norm());
                fixed.push(last);
                ways.push(s_mm);
            }
            out.curve_rad.extend(pair::posture(&fixed, &ways, cone));
            out.fixed_rad.extend(fixed);
        }
        out
    }

    /// What the published smoothing comes to.
    pub(super) fn published(&self, pinch: &Pinch, postures: Postures, rows_without: usize) -> PublishedFigures {
        let along = |theta: &[f64]| -> Vec<Held> {
            let one = |(row, places): (usize, &Range<usize>)| {
                let theta_rad = theta[places.clone()].to_vec();
                Held { row, places: places.clone(), theta_rad, margin_rad: f64::NAN }
            };
            pinch.rows.rows.iter().enumerate().map(one).collect()
        };
        let turning = |theta: &[f64]| {
            let held = along(theta);
            verify::turning_rad_mm(&PinchWork { held: &held, ..self.pinch_work(pinch) })
        };
        let outside =
            |theta: &[f64]| theta.iter().zip(&pinch.common).filter(|(theta, free)| !free.has(**theta)).count();
        let Postures { fixed_rad, curve_rad } = postures;
        PublishedFigures {
            fixed_rad_mm: turning(&fixed_rad),
            fixed_outside: outside(&fixed_rad),
            posture_rad_mm: turning(&curve_rad),
            posture_outside: outside(&curve_rad),
            rows_without,
        }
    }
}
