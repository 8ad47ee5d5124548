//! A window of the elastic half space z > 0 under Hertz's pressure p₀ √(1 − r²/a²) on a circle, a = 1: a rigid
//! paraboloid of radius R pressed on it. Exact inside any window whose outer sides take the field's displacements.
//!
//! Boussinesq's potential of the pressure, with s² = λ the positive root of r²/(1+λ) + z²/λ = 1 and θ = arccot s:
//! ψ = (πp₀/2)(2θ − r² I₂ − z² I₃), I₂ = θ − s/(1+s²), z I₃ = 2z/s − 2zθ, ∂ψ/∂r = −πp₀ r I₂, ∂ψ/∂z = −πp₀ z I₃,
//! χ_r = −∫_z^∞ ∂ψ/∂r dz = πp₀ [2(1 − (z/s)³)/(3r) − r z I₂], as z = s √(1 − r²/(1+s²)) and dI₂/ds = −2/(1+s²)²;
//! u_r = −[(1−2ν)χ_r + z ∂ψ/∂r]/(4πμ), u_z = [2(1−ν)ψ − z ∂ψ/∂z]/(4πμ).
//! Sources: Johnson, Contact Mechanics, 1985, §3.2 for displacements from potentials, §3.4 for the surface.

use fe_core::material::Elastic;
use std::f64::consts::{FRAC_PI_2, PI};

/// The half space under the pressure.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PointWindow {
    /// Material.
    pub elastic: Elastic,
    /// Largest pressure p₀ [F/L²].
    pub peak: f64,
    /// How far the paraboloid's top stands above the surface far away, a²/R [L].
    pub approach: f64,
}

impl PointWindow {
    /// Under a rigid paraboloid −r²/2R: p₀ = 2aE*/πR, E* = E/(1 − ν²), a = 1.
    pub fn under_paraboloid(elastic: Elastic, radius: f64) -> Self {
        let modulus = elastic.young / (1.0 - elastic.poisson.powi(2));
        PointWindow { elastic, peak: 2.0 * modulus / (PI * radius), approach: 1.0 / radius }
    }

    /// Pressure on z = 0 [F/L²].
    pub fn pressure(&self, r: f64) -> f64 {
        self.peak * (1.0 - r * r).max(0.0).sqrt()
    }

    /// Force [F] on the whole circle: ⅔ p₀ πa².
    pub fn force(&self) -> f64 {
        2.0 / 3.0 * PI * self.peak
    }

    /// Radial displacement and that along z [L], against the surface far away.
    pub fn at(&self, r: f64, z: f64) -> [f64; 2] {
        let (nu, scale) = (self.elastic.poisson, 0.25 * self.peak / self.elastic.mu());
        let q = r * r + z * z - 1.0;
        let root = (q * q + 4.0 * z * z).sqrt();
        // Without cancellation on either side of q = 0.
        let square = if q > 0.0 { 0.5 * (q + root) } else { 2.0 * z * z / (root - q).max(f64::MIN_POSITIVE) };
        let s = square.sqrt();
        let slope = if s > 0.0 { z / s } else { (1.0 - r * r).max(0.0).sqrt() };
        let theta = FRAC_PI_2 - s.atan();
        let second = theta - s / (1.0 + square);
        let third = 2.0 * slope - 2.0 * z * theta;
        let psi = 0.5 * (2.0 * theta - r * r * second - z * third);
        // 1 − (z/s)³ by (z/s)² = 1 − r²/(1 + s²), so that nothing cancels near the axis.
        let rest = -(1.5 * (-(r * r / (1.0 + square)).min(1.0)).ln_1p()).exp_m1();
        let chi = if r > 0.0 { 2.0 * rest / (3.0 * r) - r * z * second } else { 0.0 };
        [-scale * ((1.0 - 2.0 * nu) * chi - z * r * second), scale * (2.0 * (1.0 - nu) * psi + z * third)]
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const WINDOW: Elastic = Elastic { young: 1000.0, poisson: 0.3 };

    /// Ten digits of the same field, its χ_r by numerical integration, at R = 1000.
    #[test]
    fn check_points() {
        let window = PointWindow::under_paraboloid(WINDOW, 1000.0);
        assert!((window.peak / 0.6995821674 - 1.0).abs() < 1e-9 && (window.force() / 1.465201465 - 1.0).abs() < 1e-9);
        for ([r, z], u) in [
            ([2.0, 2.0], [3.352719468e-5, 2.034352792e-4]),
            ([2.0, 0.0], [-6.063045451e-5, 2.179955621e-4]),
            ([1.0, 2.0], [3.392279839e-5, 2.865190127e-4]),
        ] {
            let found = window.at(r, z);
            (0..2).for_each(|i| assert!((found[i] / u[i] - 1.0).abs() < 2e-9, "{r} {z} {found:?}"));
        }
    }

    /// On the surface: the paraboloid within the contact, a gap outside; nothing goes sideways on the axis.
    #[test]
    fn conditions_of_contact() {
        let window = PointWindow::under_paraboloid(WINDOW, 1000.0);
        let gap = |r: f64| window.at(r, 0.0)[1] - (window.approach - 0.5 * r * r / 1000.0);
        assert!([0.0, 0.3, 0.9, 0.999].iter().all(|&r| gap(r).abs() < 1e-17));
        assert!([1.01, 1.5, 2.0].iter().all(|&r| gap(r) > 0.0));
        assert!([0.0, 0.5, 2.0].iter().all(|&z| window.at(0.0, z)[0] == 0.0 && window.at(0.0, z)[1].is_finite()));
        // The displacement of a node next to the axis is that on it but for the first order.
        assert!((window.at(1e-9, 0.5)[1] / window.at(0.0, 0.5)[1] - 1.0).abs() < 1e-12);
    }
}
