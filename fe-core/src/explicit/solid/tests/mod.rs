//! Elements of explicit steps against what they must do exactly.

use super::*;
use crate::explicit::Moving;
use crate::material::{Elastic, Hardening, Material};
use crate::section::Section;
use ElementType::*;
use fe_mesh::generate::Block;
use nalgebra::{Matrix3, Rotation3, Vector3};
use scene::*;

mod energies;
mod plane;
mod rubber;
mod scene;
mod speed;
mod together;

/// A unit block with its inner nodes moved; away from the axis.
fn distorted(x: [f64; 3]) -> [f64; 3] {
    let inside = x[..2].iter().all(|v| *v > 1e-9 && *v < 1.0 - 1e-9);
    let by = if inside { 0.1 } else { 0.0 };
    [x[0] + by * (7.0 * x[1]).sin() + 0.5, x[1] - by * (5.0 * x[2] + 1.0).cos(), x[2] + by * (9.0 * x[0] * x[2]).sin()]
}

/// That of the plane stays there.
fn flat(x: [f64; 3]) -> [f64; 3] {
    let [x, y, _] = distorted([x[0], x[1], 0.0]);
    [x, y, 0.0]
}

fn mapping(element: ElementType) -> fn([f64; 3]) -> [f64; 3] {
    if element.space().dimension() == 2 { flat } else { distorted }
}

fn all() -> impl Iterator<Item = ElementType> {
    ElementType::ALL.into_iter().filter(|element| has(*element))
}

fn norm(stress: [f64; 6]) -> f64 {
    stress.iter().map(|s| s * s).sum::<f64>().sqrt()
}

fn full(s: [f64; 6]) -> Matrix3<f64> {
    Matrix3::new(s[0], s[3], s[5], s[3], s[1], s[4], s[5], s[4], s[2])
}

/// A stretched body is turned by 400° in 50 increments: the stress turns with it, rounding after so many increments aside. What
/// lies in a plane turns there; rings do not turn.
#[test]
fn stress_turns_with_the_body() {
    let stretch = Matrix3::new(1.001, 0.0004, 0.0, 0.0, 0.9995, 0.0, 0.0, 0.0003, 1.0007);
    for element in all().filter(|element| element.space() != crate::element::Space::Axisymmetric) {
        let is_flat = element.space().dimension() == 2;
        let axis = if is_flat { Vector3::z() } else { Vector3::new(1.0, 2.0, -2.0) / 3.0 };
        let turn = |t: f64| Rotation3::from_axis_angle(&nalgebra::Unit::new_unchecked(axis), 400f64.to_radians() * t);
        let scene = || Setup::elastic(element).block(3, mapping(element));
        let (mut still, mut turned) = (scene(), scene());
        still.go(1.0, |x| stretch * x);
        turned.go(1.0, |x| stretch * x);
        turned.follow(50, 1.0, |x, t| turn(t) * (stretch * x));
        let r = turn(1.0).into_inner();
        for (before, after) in still.solids.states().zip(turned.solids.states()) {
            let difference = (r * full(before.stress) * r.transpose() - full(after.stress)).norm();
            assert!(difference < 1e-11 * STEEL.young * 1e-2, "{}: {difference}", element.name());
        }
    }
}

/// Uniform straining of any mesh: the same stress everywhere, and no force on inner nodes. Rings widen as they thicken.
#[test]
fn patch() {
    for element in all() {
        let stretch = match element.space() {
            crate::element::Space::Axisymmetric => Matrix3::new(1e-3, 0.0, 0.0, 0.0, -5e-4, 0.0, 0.0, 0.0, 0.0),
            _ => Matrix3::new(1e-3, 4e-4, 0.0, 0.0, -5e-4, 2e-4, 3e-4, 0.0, 7e-4),
        };
        let mut scene = Setup::elastic(element).block(3, mapping(element));
        scene.go(1.0, |x| x + stretch * x);
        let first = scene.state().stress;
        for state in scene.solids.states() {
            let difference: [f64; 6] = std::array::from_fn(|i| state.stress[i] - first[i]);
            // Rounding of places over displacements of 1e-3, and that over the elements' size.
            assert!(norm(difference) < 1e-11 * norm(first), "{}: {difference:?}", element.name());
        }
        let size = scene.forces.iter().fold(0.0f64, |m, f| m.max(f.abs()));
        let (low, high) = ([0.5, 0.0, 0.0], [1.5, 1.0, 1.0]);
        let mut inner = 0;
        for (node, x) in scene.structure.mesh.points.iter().enumerate() {
            if (0..element.space().dimension()).all(|c| x[c] > low[c] + 0.05 && x[c] < high[c] - 0.05) {
                let force = scene.freedoms.of_node(node).map(|f| scene.forces[f].abs()).fold(0.0, f64::max);
                assert!(force < 1e-11 * size, "{} {node}: {force} of {size}", element.name());
                inner += 1;
            }
        }
        assert!(inner >= 4);
    }
}

/// Stretch along one axis: the strain is logarithmic, to the square of the increments over 12.
#[test]
fn strain_is_logarithmic() {
    for element in [C3D8R, CPE4R] {
        let errors = [10, 20].map(|steps| {
            let mut scene = Setup::elastic(element).block(1, |x| x);
            scene.follow(steps, 1.0, |x, t| Vector3::new(x.x * (1.0 + 0.5 * t), x.y, x.z));
            scene.state().stress[0] / ((STEEL.lambda() + 2.0 * STEEL.mu()) * 1.5f64.ln()) - 1.0
        });
        // Σ (ε − ε³/12 + …) of the midpoint rule against ln: (0.5/10)²/12 times the mean of 1/x² (2/3), over ln 1.5 / 0.5.
        assert!(errors[0].abs() < 2e-4 && (errors[0] / errors[1] - 4.0).abs() < 0.05, "{errors:?}");
    }
}

/// One element at the largest stable increment that it names: Δt c_d/h of a free cube and square with ν = 0.3.
#[test]
fn b06_stable_increment_of_a_free_cube_and_square() {
    let speed = ((STEEL.lambda() + 2.0 * STEEL.mu()) / DENSITY).sqrt();
    for (element, exact) in [(C3D8R, 0.733799385705), (CPE4R, 0.836660026534)] {
        let mut setup = Setup::elastic(element);
        setup.thickness = 0.3;
        let stable = setup.block(1, |x| x.map(|v| 2.0 * v)).stable() * speed / 2.0;
        assert!((stable - exact).abs() < 1e-11, "{}: {stable}", element.name());
    }
    // Of elements with several points a bound, within a twentieth.
    for (element, exact) in [(C3D8, 0.733799385705), (CPE4, 0.836660026534)] {
        let stable = Setup::elastic(element).block(1, |x| x.map(|v| 2.0 * v)).stable() * speed / 2.0;
        assert!(stable < exact && stable > 0.93 * exact, "{}: {stable}", element.name());
    }
}

/// Motions that keep the volume of an element as a whole meet no bulk modulus.
#[test]
fn volumetric_locking() {
    for element in [C3D8, CPE4] {
        let energies = [0.3, 0.49999].map(|poisson| {
            let elastic = Elastic { young: 2.0 * STEEL.mu() * (1.0 + poisson), poisson };
            let mut scene = Setup { response: Response::Elastic(elastic), ..Setup::elastic(element) }.block(1, |x| x);
            scene.go(1.0, |x| {
                let product = (2.0 * x.x - 1.0) * (2.0 * x.y - 1.0);
                x + Vector3::new(product, product, 0.0) * 1e-6
            });
            scene.solids.energies().internal
        });
        // Only the square of the motion, 1e-12, changes the volume: K/μ = 5e4 times its square.
        assert!((energies[1] / energies[0] - 1.0).abs() < 1e-6, "{}: {energies:?}", element.name());
    }
}

/// Tension beyond yield with two straight pieces of hardening and unloading between: uniaxial strain, whose deviator is all
/// that flows. q grows by 2μ ε until it is σ_y, then by 2μ ε h/(3μ + h).
#[test]
fn flow_follows_the_table() {
    for element in [C3D8R, C3D4, CPE4R, CPE3] {
        let mut scene = Setup::plastic(element, vec![(0.0, 300.0), (0.002, 340.0), (0.01, 360.0)]).block(1, |x| x);
        let mu = STEEL.mu();
        scene.follow(2000, 1.0, |x, t| Vector3::new(x.x * (0.006 * t).exp(), x.y, x.z));
        let state = scene.state();
        let [xx, yy, ..] = state.stress;
        let q = xx - yy;
        // 2μ (ε − 3/2 p) = σ_y(p) with ε = 0.006: the strain of each increment is that of the midpoint rule, 1e-11 off.
        let yielded = |p: f64| if p < 0.002 { 300.0 + 20e3 * p } else { 340.0 + 2.5e3 * (p - 0.002) };
        assert!((q - yielded(state.plastic)).abs() < 1e-9 * q, "{q} {}", state.plastic);
        assert!((2.0 * mu * (0.006 - 1.5 * state.plastic) - q).abs() < 1e-6 * q);
        assert!(state.plastic > 0.002);
    }
}

/// The hourglass shapes meet a resistance, rigid motions and constant strains none.
#[test]
fn hourglass_motion_is_resisted_alone() {
    for element in [C3D8R, CPE4R, CPS4R, CAX4R] {
        for hourglass in [Hourglass::Enhanced(1.0), Hourglass::Stiffness(0.05), Hourglass::Viscous(0.1)] {
            let mut twisted = Setup { hourglass, ..Setup::elastic(element) }.block(1, |x| [x[0] + 9.5, x[1], x[2]]);
            twisted.follow(1, 1e-7, |x, _| {
                let s = [2.0 * (x.x - 9.5) - 1.0, 2.0 * x.y - 1.0, 2.0 * x.z - 1.0];
                let shape = if element == C3D8R {
                    [s[1] * s[2], s[0] * s[1] * s[2], s[0] * s[1]]
                } else {
                    [0.0, s[0] * s[1], 0.0]
                };
                x + Vector3::from(shape) * 1e-4
            });
            let work = twisted.solids.energies();
            // Of the gradients' change by the motion itself, a part 1e-4 of the motion strains the element; in rings, whose mean
            // is by the radius, h/6r of it besides: its square, times the stiffness of strains over that of bending, about 10.
            let bound = if element == CAX4R { 10.0 * (1.0f64 / 6.0 / 10.0).powi(2) } else { 1e-7 };
            let least = twisted.forces.iter().any(|f| f.abs() > 1e-3);
            assert!(least && work.internal.abs() < bound * work.hourglass, "{}: {work:?}", element.name());
        }
    }
}
