//! What contact says of increments before it presses.

use super::*;

const MASS: f64 = 2.0;
const SLOPE: f64 = 1e4;
const MOST: f64 = 1e-3;

/// The stable increment at the start of a mass over a floor, after increments of [`MOST`].
fn increment(height: f64, speed: f64, damping: Option<DampingAmount>) -> f64 {
    let structure = masses(&[([0.0, 0.0, height], MASS), ([0.0, 0.0, -1.0], 0.0)]);
    let law = Arc::new(Linear { slope: SLOPE, clearance: 0.0 });
    let mut definition = definition(&[0], floor(1), law);
    definition.behaviour.damping = damping.map(|amount| ExplicitDamping { amount, tangent_fraction: 0.0 });
    let held: Vec<(u32, usize)> = (0..6).map(|c| (1, c)).collect();
    let scene = Scene::within(&structure, definition, (&held, &[(0, 2, speed)]), MOST);
    scene.procedure.stable().increment()
}

/// A law that is met in the next two increments counts already, twice: 2/√(2k/m). What is farther away, or parts, does not; nor
/// does its damping.
#[test]
fn what_comes_is_foreseen() {
    let within = 2.0 / (2.0 * SLOPE / MASS).sqrt();
    let height = 2.0 * MOST * 3.0;
    assert!((increment(0.99 * height, -3.0, None) / within - 1.0).abs() < 1e-14);
    for damping in [None, Some(DampingAmount::Coefficient(50.0)), Some(DampingAmount::CriticalFraction(0.5))] {
        assert_eq!(increment(1.01 * height, -3.0, damping), f64::INFINITY, "{damping:?}");
        assert_eq!(increment(0.5 * height, 3.0, damping), f64::INFINITY, "{damping:?}");
    }
    // 2/ω (√(1 + ξ²) − ξ) with 2ξω = c/m.
    let (omega, rate) = ((2.0 * SLOPE / MASS).sqrt(), 50.0 / MASS);
    let xi = 0.5 * rate / omega;
    let damped = 2.0 / omega * ((1.0 + xi * xi).sqrt() - xi);
    assert!((increment(0.99 * height, -3.0, Some(DampingAmount::Coefficient(50.0))) / damped - 1.0).abs() < 1e-14);
}
