//! What the elements say that they took is what moving their nodes cost.

use super::*;
use crate::material::NeoHooke;

/// A motion with every kind of strain and hourglass, large but smooth.
fn motion(element: ElementType) -> impl Fn(Vector3<f64>, f64) -> Vector3<f64> {
    let height = if element.space().dimension() == 2 { 0.0 } else { 1.0 };
    move |x, t| {
        let wave = Vector3::new((2.0 * x.y).sin() + x.x * x.y, (3.0 * x.x).cos() - 1.0, height * (x.x * x.y * x.z));
        let shear = Vector3::new(0.3 * x.x + 0.2 * x.y, 0.1 * x.x - 0.2 * x.y, -0.1 * x.z * height);
        x + (wave * 0.05 + shear) * (1.0 - (2.0 * t).cos())
    }
}

/// Energies against work by the trapezoidal rule: the difference goes at least with the square of the increments.
#[test]
fn energies_are_the_work_done() {
    for element in all() {
        let rubber = Response::NeoHooke(NeoHooke { c10: 40e3, d1: 2e-5 });
        let responses = [
            Response::Elastic(STEEL),
            Response::Plastic { elastic: STEEL, hardening: Hardening { points: vec![(0.0, 3e3), (1.0, 60e3)] } },
            rubber,
        ];
        for response in responses {
            let setup = Setup { response, thickness: 0.7, ..Setup::elastic(element) };
            let errors = [40, 80].map(|steps| {
                let mut scene = setup.block(2, mapping(element));
                scene.follow(steps, 1.0, motion(element));
                let Energies { internal, hourglass, viscous, .. } = scene.solids.energies();
                (internal + hourglass + viscous) / scene.work - 1.0
            });
            // 4, or more where the square's part is small beside the next one.
            let ratio = errors[0] / errors[1];
            let told = || format!("{} {:?}: {errors:?}", element.name(), setup.response);
            assert!(errors[0].abs() < 2e-3 && ratio > 3.4, "{}", told());
        }
    }
}

/// Nothing pushes a body as a whole: forces sum to zero, in rings along the axis.
#[test]
fn forces_balance() {
    for element in all() {
        let mut scene = Setup::elastic(element).block(2, mapping(element));
        scene.follow(10, 1.0, motion(element));
        let size = scene.forces.iter().map(|f| f.abs()).sum::<f64>();
        let is_ring = element.space() == crate::element::Space::Axisymmetric;
        for c in (if is_ring { 1 } else { 0 })..element.space().dimension() {
            let sum = scene.held(c, |_| true);
            assert!(sum.abs() < 1e-13 * size, "{} {c}: {sum} of {size}", element.name());
        }
    }
}

/// The masses are those of the body: rings by what is swept, also where they reach the axis.
#[test]
fn masses_are_those_of_the_body() {
    for element in all() {
        let setup = Setup { thickness: 0.7, ..Setup::elastic(element) };
        let scene = setup.block(3, |x| if element.space().dimension() == 2 { [x[0], x[1], 0.0] } else { x });
        let mut mass = vec![0.0; scene.freedoms.len()];
        scene.solids.add_mass(&mut mass);
        let sum: f64 = scene.freedoms_along(1).map(|f| mass[f]).sum();
        let volume = match element.space() {
            crate::element::Space::Solid => 1.0,
            crate::element::Space::Axisymmetric => std::f64::consts::PI,
            _ => 0.7,
        };
        assert!((sum / (DENSITY * volume) - 1.0).abs() < 1e-13, "{}", element.name());
        assert!(mass.iter().all(|m| *m > 0.0));
    }
}
