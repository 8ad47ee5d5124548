//! Hyperelasticity against closed solutions: the motion alone says the stress, so one increment is as good as many.

use super::*;
use crate::element::Space;
use crate::material::NeoHooke;

fn rubber(element: ElementType, c10: f64, d1: f64) -> Scene {
    let setup = Setup { response: Response::NeoHooke(NeoHooke { c10, d1 }), thickness: 1.5, ..Setup::elastic(element) };
    setup.block(1, |x| if element.space().dimension() == 2 { [x[0], x[1], 0.0] } else { x })
}

/// Stretched along y, the lateral faces free: nominal stress and lateral stretch.
#[test]
fn c09_uniaxial_tension() {
    for (stretch, nominal, lateral) in
        [(0.5, -3.449973598, 1.393106189), (1.5, 1.027330482, 0.8266621578), (2.0, 1.677833349, 0.7256401946)]
    {
        for element in all().filter(|element| element.space() != Space::PlaneStrain) {
            let mut scene = rubber(element, 0.5, 0.1);
            scene.follow(7, 1.0, |x, t| {
                let to = |end: f64| 1.0 + (end - 1.0) * t;
                Vector3::new(x.x * to(lateral), x.y * to(stretch), x.z * to(lateral))
            });
            let stress = scene.state().stress;
            let got = stress[1] * lateral * lateral;
            // The figures have ten digits; the pressure magnifies those of the lateral stretch by K λ² = 20.
            let name = element.name();
            assert!(
                (got - nominal).abs() < 1e-7 && stress[0].abs() < 1e-7 && stress[2].abs() < 1e-7,
                "{name} {stress:?}"
            );
            if element.space() == Space::PlaneStress {
                // The force is that of the thickness now: nominal stress on the section at the start.
                let force = scene.held(1, |x| x[1] > 0.5);
                assert!((force / (1.5 * nominal) - 1.0).abs() < 1e-7, "{name} {force}");
            }
        }
    }
}

/// Held at the sides and pressed: P = ∂/∂λ [C₁₀ (λ^(−2/3) (λ² + 2) − 3) + (λ − 1)²/D₁].
#[test]
fn confined_compression() {
    let (c10, d1) = (80.0, 0.01);
    for element in all().filter(|element| !matches!(element.space(), Space::PlaneStress)) {
        for stretch in [0.7f64, 1.4] {
            let mut scene = rubber(element, c10, d1);
            scene.follow(3, 1.0, |x, t| Vector3::new(x.x, x.y * (1.0 + (stretch - 1.0) * t), x.z));
            let p = c10 * 4.0 / 3.0 * (stretch.cbrt() - stretch.powf(-5.0 / 3.0)) + 2.0 * (stretch - 1.0) / d1;
            let area = match element.space() {
                Space::Axisymmetric => std::f64::consts::PI,
                Space::PlaneStrain => 1.5,
                _ => 1.0,
            };
            let force = scene.held(1, |x| x[1] > 0.5 - 0.5 / 2.0 && (x[1] - 0.5).abs() > 1e-9 || x[1] > 0.9);
            assert!((force / (p * area) - 1.0).abs() < 1e-12, "{} {stretch}: {force} {p}", element.name());
        }
    }
}

/// Simple shear: τ = 2 C₁₀ γ and σ₁₁ − σ₂₂ = 2 C₁₀ γ².
#[test]
fn c09_simple_shear() {
    for element in all().filter(|element| !matches!(element.space(), Space::PlaneStress | Space::Axisymmetric)) {
        for shear in [0.5, 1.0] {
            let mut scene = rubber(element, 0.5, 0.1);
            scene.follow(4, 1.0, |x, t| Vector3::new(x.x + shear * t * x.y, x.y, x.z));
            let s = scene.state().stress;
            assert!((s[3] - shear).abs() < 1e-13 && (s[0] - s[1] - shear * shear).abs() < 1e-13, "{s:?}");
        }
    }
}

/// The stable increment stays below what small motions about the stretched state have: the largest eigenvalue of the element's
/// stiffness, by differences of its forces.
#[test]
fn stable_increment_of_a_stretched_element() {
    for element in all().filter(|element| element.space() != Space::Axisymmetric) {
        for stretch in
            [[1.0, 1.0, 1.0], [0.4, 1.0, 1.0], [3.0, 0.7, 0.6], [1.8, 1.8, 1.8], [2.5, 2.5, 0.4], [0.5, 0.5, 0.5]]
        {
            let place = |x: Vector3<f64>| x.component_mul(&Vector3::from(stretch));
            let stable = rubber(element, 0.5, 0.1).go(1.0, place).stable;
            let exact = exact(|| rubber(element, 0.5, 0.1), place);
            // Hourglass springs have the moduli of small strains, which may be the larger ones.
            assert!(stable <= exact * (1.0 + 1e-6), "{} {stretch:?}: {stable} {exact}", element.name());
        }
    }
}
