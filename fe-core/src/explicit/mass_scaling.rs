//! Elements with more mass than their density gives them, so that increments may be longer. Their viscosity stays what it was.
//!
//! With a mass of f m an element has the frequency ω/√f and the damping ξ/√f of critical:
//! Δt(f) = 2√f/ω (√(1 + ξ²/f) − ξ/√f) = Δt(1) (√(f + ξ²) − ξ)/(√(1 + ξ²) − ξ).

/// Stable increment [T] of an element with f times its mass, from the one that it has by itself; ξ is the linear bulk viscosity
/// [-]. Other damping makes it longer where f > 1.
pub fn raised(stable: f64, f: f64, xi: f64) -> f64 {
    stable * ((f + xi * xi).sqrt() - xi) / ((1.0 + xi * xi).sqrt() - xi)
}

/// Factor [-] on the mass of an element with which its stable increment is another one.
pub fn factor(stable: f64, wanted: f64, xi: f64) -> f64 {
    (wanted / stable * ((1.0 + xi * xi).sqrt() - xi) + xi).powi(2) - xi * xi
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn one_is_the_inverse_of_the_other() {
        for (f, xi) in [(1.0, 0.06), (7.0, 0.0), (0.3, 0.2), (40.0, 0.06)] {
            assert!((factor(2.0, raised(2.0, f, xi), xi) / f - 1.0).abs() < 1e-14);
        }
        assert_eq!(raised(2.0, 4.0, 0.0), 4.0);
    }
}
