//! The ideal airfoil and the ball that rolls in its corner with the platform.
//!
//! The ideal airfoil is `F(φ, z)`: the section at height `z` ([`super::profile`]). A ball of radius
//! `r` touches the plane `z = z0` and the airfoil where its centre `C = F + r n` is `r` above the
//! plane: `F_z − z0 + r n_z = r`, one equation for the height of contact at each φ. The centres
//! make the spine, the contacts the two edges of the fillet, and every cross-section of the fillet
//! is an arc of radius `r` about `C` from `C − r e_z` to `C − r n`.

use super::profile::BladeSections;
use crate::error::{DesignFault, Error, Infeasible, Result, Stage};
use crate::geometry::{Point, Vector};

/// The airfoil as the laws give it, without interpolation.
#[derive(Clone, Debug)]
pub struct IdealAirfoil {
    sections: BladeSections,
    /// z of the platform's top, mm.
    pub z0: f64,
    /// From there to the tip, mm.
    pub height: f64,
}

/// Where the ball touches at one φ.
#[derive(Clone, Copy, Debug)]
pub struct Contact {
    /// Its centre.
    pub centre: Point,
    /// On the airfoil.
    pub airfoil: Point,
    /// On the platform.
    pub platform: Point,
    /// The airfoil's outward normal at the contact.
    pub normal: Vector,
}

impl IdealAirfoil {
    /// The airfoil over a platform at `z0`.
    pub fn new(sections: BladeSections, z0: f64, height: f64) -> Self {
        IdealAirfoil { sections, z0, height }
    }

    /// `F(φ, z)`.
    pub fn point(&self, phi: f64, z: f64) -> Point {
        let [x, y] = self.sections.at((z - self.z0) / self.height).point(phi);
        Point::new(x, y, z)
    }

    /// Outward normal, from central differences of fourth order (error below 1e-9 for sections of
    /// usual size).
    pub fn normal(&self, phi: f64, z: f64) -> Vector {
        let difference =
            |f: &dyn Fn(f64) -> Point, h: f64| ((f(h) - f(-h)) * 8.0 - (f(2.0 * h) - f(-2.0 * h))) / (12.0 * h);
        let section = self.sections.at((z - self.z0) / self.height);
        let round = |h: f64| {
            let [x, y] = section.point(phi + h);
            Point::new(x, y, z)
        };
        let du = difference(&round, 2e-3);
        let dz = difference(&|h| self.point(phi, z + h), 2e-3 * self.height);
        du.cross(&dz).try_normalize(0.0).unwrap_or_else(Vector::zeros)
    }

    /// The ball of radius `r` in the corner at φ.
    pub fn contact(&self, phi: f64, r: f64) -> Result<Contact> {
        // z − z0 = r (1 − n_z(z)): n_z changes slowly with z, so this contracts.
        let mut z = self.z0 + r;
        for _ in 0..60 {
            let normal = self.normal(phi, z);
            let next = self.z0 + r * (1.0 - normal.z);
            let step = (next - z).abs();
            z = next;
            if step < 1e-12 * (1.0 + r) && z > self.z0 && z < self.z0 + self.height {
                let airfoil = self.point(phi, z);
                let normal = self.normal(phi, z);
                let mut centre = airfoil + normal * r;
                centre.z = self.z0 + r;
                let platform = Point::new(centre.x, centre.y, self.z0);
                return Ok(Contact { centre, airfoil, platform, normal });
            }
        }
        Err(Error::infeasible(
            Stage::Make,
            format!(
                "no ball of radius {r} mm fits between platform and airfoil at {:.0}° round the section",
                phi.to_degrees()
            ),
            Infeasible::Design { fault: DesignFault::FilletDoesNotFit { radius_mm: r, round_deg: phi.to_degrees() } },
        )
        .advise("make fillet_radius_mm smaller or lean the airfoil less"))
    }

    /// The contacts at all φ, checked: the spine runs with the airfoil everywhere (the ball fits
    /// into the concave side) and the ball touches no other place.
    pub fn contacts(&self, phi: &[f64], r: f64) -> Result<Vec<Contact>> {
        let contacts: Vec<Contact> = phi.iter().map(|&p| self.contact(p, r)).collect::<Result<_>>()?;
        let n = contacts.len();
        for i in 0..n {
            let (a, b) = (&contacts[i], &contacts[(i + 1) % n]);
            let turns_back = (b.centre - a.centre).dot(&(b.airfoil - a.airfoil)) <= 0.0;
            let section = self.sections.at((a.airfoil.z - self.z0) / self.height);
            // The contact itself is this far from the spine, seen from the tip.
            let contact = r * (1.0 - a.normal.z * a.normal.z).sqrt();
            let pokes = phi.iter().any(|&p| {
                let [x, y] = section.point(p);
                (a.centre.x - x).hypot(a.centre.y - y) < 0.97 * contact
            });
            if turns_back || pokes {
                let message = format!(
                    "the fillet of radius {r} mm is wider than the hollow of the airfoil at {:.0}° round the section",
                    phi[i].to_degrees()
                );
                let fault = DesignFault::FilletWiderThanHollow { radius_mm: r, round_deg: phi[i].to_degrees() };
                return Err(Error::infeasible(Stage::Make, message, Infeasible::Design { fault })
                    .advise("make fillet_radius_mm smaller"));
            }
        }
        Ok(contacts)
    }
}
