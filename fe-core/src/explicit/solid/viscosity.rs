//! What resists the speed of strains: bulk viscosity and the material's own damping.

use super::batch::Common;
use super::motion::{Motion, Symmetric};
use crate::lanes::Lanes;

/// Viscous stress over an increment.
pub(super) struct Viscosity {
    /// The stress.
    pub stress: Symmetric,
    /// Work per volume [F/L²] that it takes.
    pub work: Lanes,
    /// 2ξω [1/T].
    pub damping: Lanes,
    /// The stable increment [T] that is left of 2/ω: 2/ω (√(1 + ξ²) − ξ).
    pub stable: Lanes,
}

impl Viscosity {
    /// Of bulk viscosity, a pressure against the rate of volume, ξ = b₁ + b₂² · closing rate · 2/ω; and of the β of the material,
    /// β C : ε̇ with the elasticity C of small strains, ξ = ½ β ω.
    #[inline(always)]
    pub fn new(
        common: &Common,
        dt: f64,
        (volume, mass): (Lanes, Lanes),
        (motion, square): (&Motion, Lanes),
        is_plane_stress: bool,
    ) -> Self {
        let (answer, e) = (&common.answer, &motion.strain);
        let free = Lanes::splat(2.0) / square.sqrt();
        let speed = (volume / mass * (answer.lambda + 2.0 * answer.mu)).sqrt();
        let [linear, quadratic] = common.viscosity;
        let opened = motion.opened();
        let (rate, density) = if dt > 0.0 { (opened * (1.0 / dt), mass / volume) } else { (Lanes::ZERO, Lanes::ZERO) };
        let length = speed * free;
        let closing = (-rate).max(Lanes::ZERO);
        let mut fraction = Lanes::splat(linear) + closing * free * (quadratic * quadratic);
        let pressure = density * speed * length * fraction * rate;
        let mut stress = [pressure, pressure, pressure, Lanes::ZERO, Lanes::ZERO, Lanes::ZERO];
        if common.beta > 0.0 {
            fraction += Lanes::splat(common.beta) / free;
            let by = if dt > 0.0 { common.beta / dt } else { 0.0 };
            let lambda = if is_plane_stress { answer.plane_lambda() } else { answer.lambda };
            let opened = if is_plane_stress { e[0] + e[1] } else { opened };
            for i in 0..3 {
                stress[i] += (opened * lambda + e[i] * (2.0 * answer.mu)) * by;
                stress[i + 3] += e[i + 3] * (2.0 * answer.mu * by);
            }
        }
        if is_plane_stress {
            stress[2] = Lanes::ZERO;
        }
        let mut work = stress[0] * e[0] + stress[1] * e[1] + stress[2] * e[2];
        if common.beta > 0.0 {
            work += (stress[3] * e[3] + stress[4] * e[4] + stress[5] * e[5]) * 2.0;
        }
        let stable = free * ((fraction * fraction + Lanes::splat(1.0)).sqrt() - fraction);
        Viscosity { stress, work, damping: fraction * free * square, stable }
    }
}
