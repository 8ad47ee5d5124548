//! What resists the speed of strains: bulk viscosity and the material's own damping.

use super::batch::Common;
use super::motion::{Motion, Symmetric};
use crate::lanes::Lanes;

/// Viscous stress over an increment.
pub(super) struct Viscosity {
    /// The stress.
    pub stress: Symmetric,
    /// Of it the pressure of bulk viscosity, to be kept for the next increment.
    pub pressure: Lanes,
    /// Work per volume [F/L²] that it takes: what central differences lose to a force is half of it before and half of it now, times
    /// the way; of the damping of materials what it is now.
    pub work: Lanes,
    /// 2ξω [1/T].
    pub damping: Lanes,
    /// The stable increment [T] that is left of 2/ω: 2/ω (√(1 + ξ²) − ξ).
    pub stable: Lanes,
}

impl Viscosity {
    /// Of bulk viscosity, a pressure against the rate of volume with b = b₁ + b₂² · closing rate · 2/ω of what is critical of a wave;
    /// a mode that changes the volume in all directions has more of it, ξ = b (λ + 2μ) ω_v²/ω², ω_v² what λ is multiplied with in
    /// ω² (`volumetric`; for a cube ξ = 3b (λ + 2μ)/(3λ + 2μ)); and of the β of the material,
    /// β C : ε̇ with the elasticity C of small strains, ξ = ½ β ω. `before` is the pressure of the increment before. With the speed c
    /// of a wave and ρc² = λ + 2μ the pressure b ρ c · 2c/ω · rate has neither mass nor volume in it.
    #[inline(always)]
    pub fn new(
        common: &Common,
        (dt, before): (f64, Lanes),
        (motion, [square, volumetric]): (&Motion, [Lanes; 2]),
        is_plane_stress: bool,
    ) -> Self {
        let (answer, e) = (&common.answer, &motion.strain);
        let free = Lanes::splat(2.0) / square.sqrt();
        let [linear, quadratic] = common.viscosity;
        let opened = motion.opened();
        let rate = if dt > 0.0 { opened * (1.0 / dt) } else { Lanes::ZERO };
        let closing = (-rate).max(Lanes::ZERO);
        let mut fraction = Lanes::splat(linear) + closing * free * (quadratic * quadratic);
        let of_wave = answer.lambda + 2.0 * answer.mu;
        let pressure = free * fraction * rate * of_wave;
        // Where the thickness is free it closes as the plane opens, by λ/(λ + 2μ).
        let modulus = if is_plane_stress { 2.0 * answer.mu } else { of_wave };
        fraction = fraction * volumetric * free * free * (0.25 * modulus);
        let mut stress = [Lanes::ZERO; 6];
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
        // The thickness of a plane is free.
        let pressed = if is_plane_stress { 2 } else { 3 };
        stress[pressed..3].fill(Lanes::ZERO);
        let mut work = Lanes::ZERO;
        if common.beta > 0.0 {
            work += stress[0] * e[0] + stress[1] * e[1] + stress[2] * e[2];
            work += (stress[3] * e[3] + stress[4] * e[4] + stress[5] * e[5]) * 2.0;
        }
        for i in 0..pressed {
            work += (before + pressure) * e[i] * 0.5;
            stress[i] += pressure;
        }
        let stable = free * ((fraction * fraction + Lanes::splat(1.0)).sqrt() - fraction);
        Viscosity { stress, pressure, work, damping: fraction * free * square, stable }
    }
}
