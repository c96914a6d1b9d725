//! Two tools on one blade, opposite each other.
//!
//! **In**: free angles of both tools at the places of rows that both run in lock step
//! ([`crate::artifact::PairedRows`]). **Out**: the angles that are free for both ([`FreeAngles`]),
//! and for each row an angle of the table at which it stands still while both tools cut ([`hold`])
//! or, where it has none, angles that change as slowly as can be ([`TurningRow`]).
//!
//! The workpiece turns for both tools at once. With `a(B, θ)` the axis on a cone about the blade
//! axis, tool 1 stands at `a(B₁, θ)` and tool 2 at `a(B₂, θ + δ)`, where δ is a constant of the
//! machine: half a turn for heads on opposite sides. So what is free for the pair is what is free
//! for tool 1 and, turned back by δ, for tool 2; free sets are intersected before any chain of
//! intervals is chosen, since the widest of each tool alone may miss the other's.
//!
//! How near the tools come to each other is [`Both`]'s; how much of an airfoil has an opposite side
//! at all is [`share`]'s.

mod angles;
mod apart;
mod chain;
mod hold;
mod posture;
mod settings;
mod share;
mod turn;

pub use angles::FreeAngles;
pub use apart::{Apart, Both};
pub use chain::chain;
pub use hold::{HoldOptions, Planned, Turning, hold};
pub use posture::posture;
pub use settings::{PinchEdges, PinchKeys, PinchOrientation, PinchSettings, PinchTopology};
pub use share::{HOLDS_DEG, Share, share};
pub use turn::{NEAR, Turned, TurningRow};

#[cfg(test)]
mod tests {
    use crate::artifact::Cone;
    use crate::geometry::Vector;

    /// Equation 4 of Song, Zhu, Xue, Feng and Lu (Materials 17, 2024, 2977) as printed: the axis of
    /// a head that swings by γ, its projection `b` at the angle η from the machine's z. It turns
    /// `b` about the fixed y.
    fn as_printed(gamma: f64, eta: f64) -> Vector {
        let b = Vector::new(0.0, eta.sin(), eta.cos());
        Vector::new(gamma.sin() * b.z, b.y, gamma.cos() * b.z)
    }

    #[test]
    fn the_published_tool_axis_is_right_in_the_machines_own_frame_only() {
        for gamma_deg in [5.0, 20.0] {
            for eta_deg in [0.0, 15.0, 45.0, 90.0, 130.0] {
                let [gamma, eta] = [gamma_deg, eta_deg].map(f64::to_radians);
                // θ is counted from y, η from z.
                let ours = Cone::about_blade(gamma).tool_axis(std::f64::consts::FRAC_PI_2 - eta);
                let b = Vector::new(0.0, eta.sin(), eta.cos());
                let projected = Vector::new(0.0, ours.y, ours.z);
                assert!((ours.norm() - 1.0).abs() < 1e-14 && projected.cross(&b).norm() < 1e-14);
                assert!((ours.x.asin() - gamma).abs() < 1e-14);
                let printed = as_printed(gamma, eta);
                let (s, c) = gamma.sin_cos();
                let cosine = s * s * eta.cos() + c * (eta.sin().powi(2) + c * eta.cos().powi(2));
                assert!((printed.dot(&ours) - cosine).abs() < 1e-14);
                assert!(eta_deg != 0.0 || (printed - ours).norm() < 1e-14);
            }
        }
        let off_deg = |gamma: f64, eta: f64| {
            let ours = Cone::about_blade(gamma.to_radians()).tool_axis((90.0 - eta).to_radians());
            ours.angle(&as_printed(gamma.to_radians(), eta.to_radians())).to_degrees()
        };
        assert!((off_deg(20.0, 45.0) - 6.24).abs() < 0.01, "{}", off_deg(20.0, 45.0));
        assert!((off_deg(20.0, 90.0) - 20.0).abs() < 1e-6);
    }
}
