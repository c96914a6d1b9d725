//! `[wheel]` beside the wheel that the model shows.

use super::sections::{WheelKeys, WheelSettings};
use crate::artifact::wheel::ModelWheel;
use crate::error::{Error, Infeasible, Result, Stage};
use crate::geometry::{Point, Vector};

/// An axis that was given is the model's where it is nearer than this, degrees …
const ALIKE_DEG: f64 = 0.1;
/// … and this, mm.
const ALIKE_MM: f64 = 0.1;

/// The wheel of the job: a model of a whole wheel needs no section; of one sector the section says
/// that its wheel is meant; what a section leaves out is the model's.
///
/// # Errors
/// `Usage`: a hub for a model that has its own. `Infeasible`: another wheel than the model's.
pub(super) fn settled(keys: Option<WheelKeys>, found: Option<&ModelWheel>) -> Result<Option<WheelSettings>> {
    let (keys, found) = match (keys, found) {
        (None, Some(found)) if found.whole => (WheelKeys::default(), found),
        (None, _) => return Ok(None),
        (keys, None) => return Ok(Some(WheelSettings::default().with_typed(keys))),
        (Some(keys), Some(found)) => (keys, found),
    };
    if found.whole && keys.hub_mm.as_ref().is_some_and(|h| !h.is_empty()) {
        let message = "wheel.hub_mm is given, but the model is a whole wheel: it has its hub";
        return Err(Error::usage(Stage::Job, message).advise("leave wheel.hub_mm out"));
    }
    let of_model = WheelSettings {
        blades: found.blades,
        axis: found.axis.into(),
        origin_mm: found.through.into(),
        ..WheelSettings::default()
    };
    let asked = of_model.with_typed(Some(keys));
    asked.validate()?;
    let other = |message: String| {
        let what = Infeasible::NotThatWheel { asked: asked.blades, found: found.blades };
        Err(Error::infeasible(Stage::Model, message, what)
            .advise("leave out what of section wheel the model shows; `inspect` prints it"))
    };
    let kind = if found.whole { "repeats" } else { "is a sector of a wheel that repeats" };
    if asked.blades != found.blades {
        return other(format!(
            "wheel.blades is {}, but the model {kind} every {:.3}°, {} times in a turn",
            asked.blades,
            360.0 / f64::from(found.blades),
            found.blades
        ));
    }
    let axis = Vector::from(asked.axis).normalize();
    let angle_deg = axis.cross(&found.axis).norm().asin().to_degrees();
    let apart_mm = (Point::from(asked.origin_mm) - found.through).cross(&found.axis).norm();
    if angle_deg > ALIKE_DEG || apart_mm > ALIKE_MM {
        return other(format!(
            "wheel.axis and wheel.origin_mm are {angle_deg:.2}° and {apart_mm:.3} mm off the axis about which the model {kind}"
        ));
    }
    Ok(Some(asked))
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used)]
    use super::*;

    const FOUND: ModelWheel =
        ModelWheel { axis: Vector::new(0.0, 1.0, 0.0), through: Point::new(3.0, 9.0, -2.0), blades: 6, whole: true };

    #[test]
    fn what_the_section_leaves_out_is_the_models() {
        let whole = settled(None, Some(&FOUND)).unwrap().unwrap();
        assert_eq!((whole.blades, whole.axis, whole.origin_mm), (6, [0.0, 1.0, 0.0], [3.0, 9.0, -2.0]));
        let sector = ModelWheel { whole: false, ..FOUND };
        assert_eq!(settled(None, Some(&sector)).unwrap(), None);
        assert_eq!(settled(Some(WheelKeys::default()), Some(&sector)).unwrap(), Some(whole.clone()));
        let along =
            WheelKeys { axis: Some([0.0, -2.0, 0.0]), origin_mm: Some([3.0, 50.0, -2.05]), ..WheelKeys::default() };
        let along = settled(Some(along), Some(&FOUND)).unwrap().unwrap();
        assert_eq!((along.axis, along.origin_mm, along.blades), ([0.0, -2.0, 0.0], [3.0, 50.0, -2.05], 6));
        let lone = WheelKeys { blades: Some(7), axis: Some([1.0, 0.0, 0.0]), ..WheelKeys::default() };
        assert_eq!(settled(Some(lone), None).unwrap().unwrap().blades, 7);
    }

    #[test]
    fn another_wheel_than_the_models_is_refused() {
        let refused = |keys: WheelKeys| settled(Some(keys), Some(&FOUND)).unwrap_err().message;
        let none = WheelKeys::default;
        assert!(refused(WheelKeys { blades: Some(12), ..none() }).contains("repeats every 60.000°, 6 times"));
        assert!(refused(WheelKeys { axis: Some([0.0, 1.0, 0.01]), ..none() }).contains("0.57° and 0.000 mm off"));
        assert!(refused(WheelKeys { origin_mm: Some([3.0, 0.0, 0.0]), ..none() }).contains("2.000 mm off"));
        let hub = WheelKeys { hub_mm: Some(vec![[0.0, 1.0], [2.0, 1.0]]), ..none() };
        assert!(refused(hub).contains("it has its hub"));
    }
}
