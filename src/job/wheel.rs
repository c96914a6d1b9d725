//! `[wheel]` beside the wheel that the model shows.

use super::defaults::Draft;
use super::sections::{WheelKeys, WheelSettings};
use crate::artifact::Blade;
use crate::artifact::along::Along;
use crate::artifact::meridian::Meridian;
use crate::artifact::region::{Area, Boundary, Patch, Region, Regions};
use crate::artifact::wheel::ModelWheel;
use crate::error::{Error, Infeasible, Result, Stage};
use crate::geometry::{Point, Vector};

/// A facet is of the blade where its normal has this part round the rotor axis (sine).
const FACES_ROUND: f64 = 0.1;
/// An axis that was given is the model's where it is nearer than this, degrees …
const ALIKE_DEG: f64 = 0.1;
/// … and this, mm.
const ALIKE_MM: f64 = 0.1;

/// The wheel of the job: a model of a whole wheel needs no section. Of one sector the section says
/// that its wheel is meant, unless its hub `turns`: there the blade has no height but over the hub.
/// What a section leaves out is the model's.
///
/// # Errors
/// `Usage`: a hub for a model that has its own. `Infeasible`: another wheel than the model's.
pub(super) fn settled(
    keys: Option<WheelKeys>,
    found: Option<&ModelWheel>,
    turns: bool,
) -> Result<Option<WheelSettings>> {
    let (keys, found) = match (keys, found) {
        (None, Some(found)) if found.whole || turns => (WheelKeys::default(), found),
        (None, _) => return Ok(None),
        (keys, None) => return Ok(Some(WheelSettings::default().with_typed(keys))),
        (Some(keys), Some(found)) => (keys, found),
    };
    let given = |contour: &Option<Vec<[f64; 2]>>| contour.as_ref().is_some_and(|c| !c.is_empty());
    for (key, contour) in [("hub_mm", &keys.hub_mm), ("tip_mm", &keys.tip_mm)] {
        if found.whole && given(contour) {
            let message = format!("wheel.{key} is given, but the model is a whole wheel: it has its hub");
            return Err(Error::usage(Stage::Job, message).advise(format!("leave wheel.{key} out")));
        }
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

impl Draft {
    /// The blade with its heights over the hub, where section wheel has the contours of hub and
    /// tips; else as it is. The contour of the hub counts as far as it lies across from that of the
    /// tips.
    ///
    /// # Errors
    /// `Usage`: values out of their limits, contours between which lines cross.
    pub fn over_hub(&self, blade: Blade) -> Result<Blade> {
        let Some(settings) = settled(self.typed_wheel(), blade.wheel.as_ref(), blade.regions.over_hub().is_some())?
        else {
            return Ok(blade);
        };
        if settings.tip_mm.is_empty() {
            return Ok(blade);
        }
        settings.validate()?;
        let blade_from_model = blade.model_from_blade.inverse();
        let axis = (blade_from_model * Vector::from(settings.axis)).normalize();
        let origin = blade_from_model * Point::from(settings.origin_mm);
        let hub = between(&settings.hub_mm, &settings.tip_mm);
        let meridian = Meridian::new(axis, origin, &hub, &settings.tip_mm).ok_or_else(|| {
            let message =
                "wheel.hub_mm and wheel.tip_mm are no contours of one blade: lines from the one to the other cross";
            Error::usage(Stage::Job, message).advise(
                "give both in the same order along the rotor axis, that of the tips from edge to edge of the blade",
            )
        })?;
        let (mesh, is_exact) = (&blade.part.mesh, blade.part.brep.is_some());
        let faces_round = |t: usize| {
            let [a, b, c] = mesh.corners(t);
            let (middle, normal) = (Point::from((a.coords + b.coords + c.coords) / 3.0), mesh.normal(t));
            let round = axis.cross(&meridian.out(&middle));
            normal.dot(&round).abs() > FACES_ROUND || meridian.is_edge(&middle, &normal)
        };
        let airfoil: Vec<u32> = (0..mesh.triangles.len() as u32).filter(|t| faces_round(*t as usize)).collect();
        let patch = Patch::most_of(mesh, airfoil, is_exact);
        let [foot, tip] = [0.0, meridian.tip_mm()].map(|x| Some(Boundary::Height(x)));
        let along = Along::over_hub(meridian);
        let airfoil = Region { patch, along, ..Region::between(Area::Airfoil, tip, foot) };
        let reasons = vec!["heights: from wheel.hub_mm, 0, to wheel.tip_mm, as given".to_owned()];
        let regions = Regions { part_x_mm: [0.0, meridian.tip_mm()], list: vec![airfoil], reasons };
        Ok(Blade { regions, ..blade })
    }
}

/// The part of a contour between the places nearest to the ends of another one.
fn between(contour: &[[f64; 2]], ends: &[[f64; 2]]) -> Vec<[f64; 2]> {
    let at = |k: usize, share: f64| -> [f64; 2] {
        std::array::from_fn(|i| contour[k][i] + (contour[k + 1][i] - contour[k][i]) * share)
    };
    let nearest = |q: &[f64; 2]| {
        let places = (0..contour.len().saturating_sub(1)).map(|k| {
            let [a, b] = [contour[k], contour[k + 1]];
            let (u, v) = ([b[0] - a[0], b[1] - a[1]], [q[0] - a[0], q[1] - a[1]]);
            let share = ((u[0] * v[0] + u[1] * v[1]) / (u[0] * u[0] + u[1] * u[1])).clamp(0.0, 1.0);
            let p = at(k, share);
            ((p[0] - q[0]).hypot(p[1] - q[1]), k, share)
        });
        places.min_by(|a, b| a.0.total_cmp(&b.0)).map_or((0, 0.0), |(_, k, share)| (k, share))
    };
    let (Some(first), Some(last)) = (ends.first(), ends.last()) else { return Vec::new() };
    let (from, to) = (nearest(first), nearest(last));
    if contour.len() < 2 || from.0 > to.0 {
        return Vec::new();
    }
    let amid = contour[from.0 + 1..=to.0].iter().copied();
    std::iter::once(at(from.0, from.1)).chain(amid).chain([at(to.0, to.1)]).collect()
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used)]
    use super::*;

    const FOUND: ModelWheel =
        ModelWheel { axis: Vector::new(0.0, 1.0, 0.0), through: Point::new(3.0, 9.0, -2.0), blades: 6, whole: true };

    #[test]
    fn what_the_section_leaves_out_is_the_models() {
        let whole = settled(None, Some(&FOUND), false).unwrap().unwrap();
        assert_eq!((whole.blades, whole.axis, whole.origin_mm), (6, [0.0, 1.0, 0.0], [3.0, 9.0, -2.0]));
        let sector = ModelWheel { whole: false, ..FOUND };
        assert_eq!(settled(None, Some(&sector), false).unwrap(), None);
        assert_eq!(settled(None, Some(&sector), true).unwrap(), Some(whole.clone()));
        assert_eq!(settled(Some(WheelKeys::default()), Some(&sector), false).unwrap(), Some(whole.clone()));
        let along =
            WheelKeys { axis: Some([0.0, -2.0, 0.0]), origin_mm: Some([3.0, 50.0, -2.05]), ..WheelKeys::default() };
        let along = settled(Some(along), Some(&FOUND), false).unwrap().unwrap();
        assert_eq!((along.axis, along.origin_mm, along.blades), ([0.0, -2.0, 0.0], [3.0, 50.0, -2.05], 6));
        let lone = WheelKeys { blades: Some(7), axis: Some([1.0, 0.0, 0.0]), ..WheelKeys::default() };
        assert_eq!(settled(Some(lone), None, false).unwrap().unwrap().blades, 7);
    }

    #[test]
    fn a_contour_counts_between_the_ends_of_the_other() {
        let hub = [[0.0, 10.0], [10.0, 10.0], [20.0, 14.0], [30.0, 30.0]];
        assert_eq!(between(&hub, &[[4.0, 15.0], [9.0, 11.0]]), [[4.0, 10.0], [9.0, 10.0]]);
        let over = between(&hub, &[[-5.0, 20.0], [12.0, 22.0], [29.0, 40.0]]);
        assert_eq!(over, hub);
        assert!(between(&hub, &[]).is_empty() && between(&hub[..1], &hub).is_empty());
        assert!(between(&hub, &[[29.0, 40.0], [-5.0, 20.0]]).is_empty(), "the other way round");
    }

    #[test]
    fn another_wheel_than_the_models_is_refused() {
        let refused = |keys: WheelKeys| settled(Some(keys), Some(&FOUND), false).unwrap_err().message;
        let none = WheelKeys::default;
        assert!(refused(WheelKeys { blades: Some(12), ..none() }).contains("repeats every 60.000°, 6 times"));
        assert!(refused(WheelKeys { axis: Some([0.0, 1.0, 0.01]), ..none() }).contains("0.57° and 0.000 mm off"));
        assert!(refused(WheelKeys { origin_mm: Some([3.0, 0.0, 0.0]), ..none() }).contains("2.000 mm off"));
        let hub = WheelKeys { hub_mm: Some(vec![[0.0, 1.0], [2.0, 1.0]]), ..none() };
        assert!(refused(hub).contains("it has its hub"));
    }
}
