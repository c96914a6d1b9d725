//! One blade of a wheel: the direction off the rotor axis along which sections look most like an
//! airfoil.
//!
//! In: the mesh of a whole wheel, and the wheel that it is. Out: the run along one of its blades,
//! from the hub outwards. All blades of a kind are alike, so directions over one repeat are tried;
//! where long and short blades alternate, the one with most surface wins. The part is cut on the
//! blade's own side of the rotor axis only, since the blade opposite is as good.

use std::f64::consts::TAU;

use nalgebra::{Unit, UnitQuaternion};

use super::given::{self, Given};
use super::run::{self, Run};
use super::search::FoundAxis;
use super::wheel::Wheel;
use super::{HARDLY, words};
use crate::error::{Error, Infeasible, Result, Stage};
use crate::geometry::Vector;
use crate::geometry::mesh::{Mesh, part_of};
use crate::parallel;

/// Directions that are tried for each blade of a repeat.
const DIRECTIONS: usize = 16;
/// Rounds in which the best run proposes better directions.
const ROUNDS: usize = 3;
/// A coordinate axis across the rotor axis is taken where it is this near to the best direction,
/// degrees, and scores this share of it: wheels are drawn with a blade along one.
const DATUM_DEG: f64 = 15.0;
/// See [`DATUM_DEG`].
const DATUM: f64 = 0.65;
/// The part is looked at from this share of the radius on from which blades are apart: sections of
/// the hub are larger than those of a blade.
const INSIDE: f64 = 0.85;
/// An airfoil covers at least this share of the way from there outwards …
const COVERED: f64 = 0.3;
/// … and ends no farther than this share of it from the outside.
const TIP: f64 = 0.15;
/// A blade leans from the radius through its middle by less than this, degrees.
const ASIDE_DEG: f64 = 50.0;
/// Directions nearer to the rotor axis than this are not across it (cosine).
const ALONG_ROTOR: f64 = 0.8;

/// The part where a blade along `direction` is: on its side of the rotor axis, outside most of the
/// hub; all of it for a direction that is not across the axis.
fn own_side(mesh: &Mesh, wheel: &Wheel, direction: &Vector) -> Mesh {
    let d = direction.normalize();
    let from = match d.dot(&wheel.axis).abs() > ALONG_ROTOR {
        true => f64::NEG_INFINITY,
        false => d.dot(&wheel.through.coords) + INSIDE * wheel.apart_from_mm,
    };
    let is_beyond = |t: &u32| mesh.corners(*t as usize).iter().all(|p| d.dot(&p.coords) > from);
    let beyond: Vec<u32> = (0..mesh.triangles.len() as u32).filter(is_beyond).collect();
    part_of(mesh, &beyond)
}

/// The run along the blade in a direction that the user gave. `faces`: as for [`run::along`].
///
/// # Errors
/// `Usage`: an axis of no length. `InputOutput`: no sections along it.
pub fn given(mesh: &Mesh, wheel: &Wheel, axis: [f64; 3], faces: Option<&[bool]>) -> Result<Given> {
    let direction = given::direction(axis)?;
    let run = run::along(&own_side(mesh, wheel, &direction), &direction, faces);
    if run.links.is_empty() {
        let message = format!(
            "the part is {}, but sections across {}, the axis that was given, are no closed loops that continue",
            wheel.in_words(),
            words(&direction)
        );
        return Err(Error::io(Stage::Model, message).advise("leave --axis out: one blade is found without"));
    }
    Ok(Given { run, reason: format!("axis: {}, as given", words(&direction)), against: None })
}

/// The run along one blade. `faces`: as for [`run::along`].
///
/// # Errors
/// `Infeasible`: no direction across the rotor axis along which sections look like an airfoil.
pub fn search(mesh: &Mesh, wheel: &Wheel, faces: Option<&[bool]>) -> Result<FoundAxis> {
    let along = |d: &Vector| run::along(&own_side(mesh, wheel, d), d, faces);
    let outwards = |r: &Run| {
        let arm = r.middle - wheel.through;
        let arm = arm - wheel.axis * wheel.axis.dot(&arm);
        let across = r.direction - wheel.axis * wheel.axis.dot(&r.direction);
        !r.links.is_empty() && arm.dot(&across) > ASIDE_DEG.to_radians().cos() * arm.norm() * across.norm()
    };
    let better = |a: &Run, b: &Run| a.score.total_cmp(&b.score);
    let best =
        |runs: Vec<Run>| runs.into_iter().filter(outwards).reduce(|a, b| if better(&a, &b).is_lt() { b } else { a });
    let datum = datum(wheel);
    let n = DIRECTIONS * wheel.blades.div_ceil(wheel.fold);
    let turned = |k: usize| about(wheel, TAU * k as f64 / (n * wheel.fold) as f64) * datum;
    let runs: Vec<Run> = parallel::map(0..n, |k| along(&turned(k)));
    let Some(mut top) = best(runs) else { return Err(none(wheel, None)) };
    for _ in 0..ROUNDS {
        let proposed = [top.least_normal, top.stack].map(|d| along(&d));
        let Some(next) = best(proposed.into()).filter(|next| better(&top, next).is_lt()) else { break };
        top = next;
    }
    let mut why = "off the rotor axis, along which sections of one blade look most like an airfoil";
    let at_datum = along(&datum);
    // All blades of a kind are alike.
    let near = |k: usize| {
        (about(wheel, TAU * k as f64 / wheel.fold as f64) * top.direction).angle(&datum) < DATUM_DEG.to_radians()
    };
    if (0..wheel.fold).any(near) && outwards(&at_datum) && at_datum.score >= DATUM * top.score {
        (top, why) = (at_datum, "off the rotor axis, along which a blade stands");
    }
    let [low, high] = top.part_mm;
    let beyond = top.links.last().map_or(1.0, |tip| (high - tip.height_mm) / (high - low));
    if top.likeness < HARDLY || top.covered() < COVERED || beyond > TIP {
        return Err(none(wheel, Some(&top)));
    }
    let sense = "root towards the rotor axis".to_owned();
    let reason = format!("axis: {}, {why}; {sense}", words(&top.direction));
    Ok(FoundAxis { run: top, reason, sense: Some(sense), doubt: None })
}

/// A turn about the rotor axis.
fn about(wheel: &Wheel, angle_rad: f64) -> UnitQuaternion<f64> {
    UnitQuaternion::from_axis_angle(&Unit::new_normalize(wheel.axis), angle_rad)
}

/// The direction that is tried first: the coordinate axis farthest from the rotor axis, made square
/// to it; of equals the last.
pub(super) fn datum(wheel: &Wheel) -> Vector {
    let far = |k: &usize| wheel.axis[*k].abs();
    let k = (0..3).rev().min_by(|i, j| far(i).total_cmp(&far(j))).unwrap_or(2);
    let e = Vector::ith(k, 1.0);
    (e - wheel.axis * wheel.axis.dot(&e)).normalize()
}

/// Why there is no blade to go round.
fn none(wheel: &Wheel, best: Option<&Run>) -> Error {
    let found = best.map_or_else(String::new, |r| {
        format!(" (at best over {:.0} % of the way outwards, likeness {:.2})", 100.0 * r.covered(), r.likeness)
    });
    let message = format!(
        "the part is {}, but in no direction across its axis are sections of a blade one airfoil for long{found}",
        wheel.in_words()
    );
    Error::infeasible(Stage::Model, message, Infeasible::NotABlade).advise(
        "blades that run from along the axis to across it, as those of impellers do, have no such direction; where one has, give it with \
         --axis",
    )
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used)]
    use super::*;
    use crate::geometry::{Point, Rigid};
    use crate::read::model::recognise::wheel::wheel;

    /// A disk with so many blades about a line: prisms of an oval, so thick beside its chord, drawn
    /// together outwards.
    fn bladed(blades: u32, thick: f64, place: &Rigid) -> Mesh {
        let mut mesh = Mesh::default();
        let rings = 24u32;
        let mut ring = |at: &dyn Fn(f64) -> Point| {
            let first = mesh.points.len() as u32;
            mesh.points.extend((0..rings).map(|k| place * at(TAU * f64::from(k) / f64::from(rings))));
            first
        };
        let mut tubes = Vec::new();
        for k in 0..blades {
            let turn = UnitQuaternion::from_axis_angle(&Vector::x_axis(), TAU * f64::from(k) / f64::from(blades));
            let (s, c) = 0.7f64.sin_cos();
            let oval = |height: f64, chord: f64, a: f64| {
                let (u, v) = (chord * a.cos(), thick * chord * a.sin());
                turn * Point::new(c * u - s * v, s * u + c * v, height)
            };
            tubes.push(
                [28.0, 45.0, 70.0]
                    .map(|h| ring(&|a| oval(h, if thick > 0.5 { 4.0 } else { 12.0 - 0.05 * h }, a)))
                    .to_vec(),
            );
        }
        let disk = |x: f64, r: f64| move |a: f64| Point::new(x, r * a.cos(), r * a.sin());
        tubes.push([[-18.0, 1e-3], [-18.0, 30.0], [18.0, 30.0], [18.0, 1e-3]].map(|[x, r]| ring(&disk(x, r))).to_vec());
        for tube in tubes {
            for pair in tube.windows(2) {
                for k in 0..rings {
                    let l = (k + 1) % rings;
                    mesh.triangles
                        .extend([[pair[0] + k, pair[0] + l, pair[1] + l], [pair[0] + k, pair[1] + l, pair[1] + k]]);
                }
            }
            for end in [tube[0], tube[tube.len() - 1]] {
                mesh.triangles.extend((1..rings - 1).map(|k| [end, end + k, end + k + 1]));
            }
        }
        mesh
    }

    #[test]
    fn one_blade_of_a_wheel_is_found_off_its_axis() {
        let aside = Rigid::new(Vector::new(100.0, -30.0, 7.0), Vector::new(0.4, 1.1, -0.3));
        for (blades, place) in [(6, Rigid::identity()), (9, Rigid::identity()), (9, aside)] {
            let mesh = bladed(blades, 0.15, &place);
            let found = wheel(&mesh).expect("a wheel");
            assert_eq!((found.blades, found.fold), (blades as usize, blades as usize));
            let axis = place * Vector::x();
            assert!(found.axis.cross(&axis).norm() < 1e-3, "{found:?}");
            assert!((found.through - place * Point::origin()).cross(&axis).norm() < 0.02, "{found:?}");
            let one = search(&mesh, &found, None).unwrap();
            // Along one of the blades, which stand square to the axis.
            let pitch = TAU / f64::from(blades);
            let off = (0..blades).map(|k| {
                place * (UnitQuaternion::from_axis_angle(&Vector::x_axis(), pitch * f64::from(k)) * Vector::z())
            });
            let off = off.map(|d| d.angle(&one.run.direction).to_degrees()).fold(f64::INFINITY, f64::min);
            assert!(off < 3.0, "{off} degrees off, {}", one.reason);
            assert!(one.run.links[0].height_mm < one.run.links[one.run.links.len() - 1].height_mm);
            assert!(one.run.part_mm[0] > 0.0 || place != Rigid::identity());
            // The blade that is asked for, not the one opposite.
            let up = given(&mesh, &found, (place * Vector::z()).into(), None).unwrap().run;
            assert!((place.inverse() * up.middle).z > 40.0 && up.covered() > 0.5, "{}", up.middle);
        }
    }

    #[test]
    fn a_wheel_without_an_airfoil_says_so() {
        // Round pins.
        let mesh = bladed(6, 1.0, &Rigid::identity());
        let found = wheel(&mesh).expect("a wheel");
        let e = search(&mesh, &found, None).map(|_| ()).unwrap_err();
        assert!(e.message.contains("a wheel of 6 blades") && e.message.contains("in no direction"), "{e}");
    }
}
