//! A window of the elastic half plane y > 0 under Hertz's pressure p₀ √(1 − x²/a²), plane strain, a = 1: a rigid
//! parabola of radius R pressed on it. Exact inside any window whose outer sides take the field's displacements.
//!
//! Westergaard functions of z = x + iy with s = √(z−1) √(z+1): Z = −i p₀ (z − s),
//! Ẑ = ∫Z dz = −i p₀ [z²/2 − zs/2 + ½ ln(z + s)] − p₀π/4 (real on x = 0, so that u_x = 0 there);
//! 2μ u_x = (1−2ν) Re Ẑ − y Im Z, 2μ u_y = 2(1−ν) Im Ẑ − y Re Z,
//! σ_xx = Re Z − y Im Z′, σ_yy = Re Z + y Im Z′, σ_xy = −y Re Z′, Z′ = −i p₀ (1 − z/s).
//! Sources: Westergaard, J. Appl. Mech. 6 (1939) A49; Johnson, Contact Mechanics, 1985, §4.2 for the pressure.

use super::Exact;
use fe_core::material::Elastic;
use nalgebra::Complex;

/// The half plane under the pressure.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Window {
    /// Material.
    pub elastic: Elastic,
    /// Largest pressure p₀ [F/L²].
    pub peak: f64,
}

impl Window {
    /// Under a rigid parabola −x²/2R: p₀ = E* a/2R, E* = E/(1 − ν²), a = 1.
    pub fn under_parabola(elastic: Elastic, radius: f64) -> Self {
        Window { elastic, peak: 0.5 * elastic.young / ((1.0 - elastic.poisson.powi(2)) * radius) }
    }

    /// Pressure on y = 0 [F/L²].
    pub fn pressure(&self, x: f64) -> f64 {
        self.peak * (1.0 - x * x).max(0.0).sqrt()
    }

    /// Force per length on the side x > 0: π p₀ a/4.
    pub fn half_force(&self) -> f64 {
        0.25 * std::f64::consts::PI * self.peak
    }

    /// Displacement and stress at a place; z is ignored. Of the point (1, 0) itself the stress is that of the limit.
    pub fn at(&self, [x, y, _]: [f64; 3]) -> Exact {
        let (nu, mu) = (self.elastic.poisson, self.elastic.mu());
        let z = Complex::new(x, y);
        let s = (z - 1.0).sqrt() * (z + 1.0).sqrt();
        let factor = Complex::new(0.0, -self.peak);
        let first = factor * (z - s);
        let integral = factor * ((z * z - z * s) * 0.5 + (z + s).ln() * 0.5) - self.half_force();
        // y Z′ vanishes with y.
        let second = if y == 0.0 { Complex::new(0.0, 0.0) } else { factor * (-(z / s) + 1.0) };
        let u = [(1.0 - 2.0 * nu) * integral.re - y * first.im, 2.0 * (1.0 - nu) * integral.im - y * first.re];
        let (xx, yy) = (first.re - y * second.im, first.re + y * second.im);
        Exact {
            displacement: [u[0] / (2.0 * mu), u[1] / (2.0 * mu), 0.0],
            stress: [xx, yy, nu * (xx + yy), -y * second.re, 0.0, 0.0],
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const STEEL: Elastic = Elastic { young: 1000.0, poisson: 0.3 };

    /// Ten digits of the same formulas worked with extended precision elsewhere, at R = 1000.
    #[test]
    fn check_points() {
        let window = Window::under_parabola(STEEL, 1000.0);
        assert!((window.peak / 0.5494505494505495 - 1.0).abs() < 1e-15);
        assert!((window.half_force() / 0.4315374524 - 1.0).abs() < 1e-9);
        for (at, u) in [
            ([2.0, 2.0, 0.0], [6.270047803e-5, -9.328989376e-4]),
            ([2.0, 0.0, 0.0], [-2.243994753e-4, -9.264281409e-4]),
            ([1.0, 1.0, 0.0], [4.926180735e-5, -5.792719172e-4]),
        ] {
            let found = window.at(at).displacement;
            (0..2).for_each(|i| assert!((found[i] / u[i] - 1.0).abs() < 1e-9, "{at:?} {found:?}"));
        }
        assert!((window.at([1.0, 1.0, 0.0]).stress[1] / -0.1931744968 - 1.0).abs() < 1e-9);
    }

    /// On the surface: within the contact the parabola and the pressure, outside no pressure and a gap; u_x = 0 on
    /// the axis of symmetry.
    #[test]
    fn conditions_of_contact() {
        let window = Window::under_parabola(STEEL, 1000.0);
        let raised = |x: f64| window.at([x, 0.0, 0.0]).displacement[1] + x * x / 2000.0;
        let at_rest = raised(0.0);
        for x in [0.1, 0.5, 0.9, 0.999] {
            assert!((raised(x) - at_rest).abs() < 1e-17, "{x}");
            assert!((window.at([x, 0.0, 0.0]).stress[1] + window.pressure(x)).abs() < 1e-15);
        }
        for x in [1.01, 1.5, 2.0] {
            assert!(raised(x) - at_rest > 0.0 && window.at([x, 0.0, 0.0]).stress[1].abs() < 1e-15);
        }
        assert!([0.0, 0.5, 2.0].iter().all(|&y| window.at([0.0, y, 0.0]).displacement[0].abs() < 1e-18));
        assert!(window.at([1.0, 0.0, 0.0]).stress.iter().all(|s| s.is_finite()));
    }
}
