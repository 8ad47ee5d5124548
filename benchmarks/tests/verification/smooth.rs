//! R01, R02: u = ∇φ with φ harmonic, exact displacements on the whole boundary of the unit square or cube.

use crate::bodies::{block, components, distorted, sides, straighten};
use crate::deck::{material, prescribed, run, step};
use crate::rates::{Errors, last_three, line};
use benchmarks::exact::harmonic;
use benchmarks::norm::{self, Quadrature, VolumeErrors};
use fe_core::element::ElementType::{self, *};
use fe_core::material::Elastic;

/// Cells a side of the grid whose inner points are moved.
fn coarsest(element: ElementType) -> usize {
    match element {
        C3D10 => 2,
        C3D4 | C3D8 => 3,
        _ => 4,
    }
}

/// Errors with `cells` a side, inner nodes moved by up to `distortion` of the coarsest mesh's cells.
fn solve(element: ElementType, cells: usize, distortion: f64, poisson: f64) -> VolumeErrors {
    let elastic = Elastic { young: 1000.0, poisson };
    let exact = |x: [f64; 3]| harmonic::field(element.space(), elastic.mu(), x);
    let mut mesh = block(element, [cells; 3]).mapped(|x| distorted(x, coarsest(element), distortion));
    straighten(&mut mesh);
    let held = prescribed(&mesh, &sides(&mesh), components(element), |x| exact(x).displacement);
    let cards = material(elastic.young, poisson) + &step(&held);
    let name = format!("smooth_{}_{cells}_{distortion}_{poisson}", element.name());
    let solution = run(&name, element, mesh, &cards);
    norm::errors(&solution.terms.structure, &solution.u, &exact, &Quadrature::default()).unwrap()
}

/// Energy and displacement over the meshes of `n` cells a side.
fn study(element: ElementType, meshes: &[usize], distortion: f64, poisson: f64) -> [Errors; 3] {
    let all: Vec<(f64, VolumeErrors)> =
        meshes.iter().map(|&n| (1.0 / n as f64, solve(element, n, distortion, poisson))).collect();
    let of = |part: fn(&VolumeErrors) -> f64| all.iter().map(|(h, e)| (*h, part(e))).collect();
    [of(|e| e.energy), of(|e| e.displacement), of(|e| e.deviator)]
}

fn smooth(element: ElementType, meshes: &[usize]) {
    let order = if element == C3D10 { 2.0 } else { 1.0 };
    for distortion in [0.0, 0.2] {
        let [energy, displacement, _] = study(element, meshes, distortion, 0.3);
        let name = format!("{} {distortion}", element.name());
        eprintln!("R01 {name:<10} energy {} | displacement {}", line(&energy), line(&displacement));
        assert!(last_three(&energy) > order - 0.1, "{name}: energy {}", line(&energy));
        assert!(last_three(&displacement) > order + 0.9, "{name}: displacement {}", line(&displacement));
    }
}

/// Four meshes, h halved; energy at order p, displacement at order p + 1, less 0.1; regular and distorted.
/// Waits: CPE6, CPE8, C3D20 and the reduced elements.
#[test]
fn R01_smooth() {
    for element in [CPE3, CPE4, CPS3, CPS4, CAX4] {
        smooth(element, &[4, 8, 16, 32]);
    }
    smooth(CAX3, &[8, 16, 32, 64]);
}

#[test]
#[ignore = "a minute, in release"]
fn R01_smooth_in_space() {
    smooth(C3D4, &[3, 6, 12, 24]);
    smooth(C3D8, &[3, 6, 12, 24]);
    smooth(C3D10, &[2, 4, 8, 16]);
}

/// The exact field is the same for every ν: on the last three meshes the displacement error grows by at most 2 against
/// ν = 0.3 in the elements that do not lock, and the deviatoric stress keeps its rate 1. The grid of the pattern itself
/// is too coarse to tell, as about as many volumes are asked of its few free nodes as they have freedoms: there the error
/// grows by 2.4 (CPE4, 4 × 4 cells, 18 freedoms) and 2.03 (C3D8, 27 cells, 24 freedoms), and by 1.05 once they are halved.
fn near_incompressible(element: ElementType, meshes: &[usize]) {
    for distortion in [0.0, 0.2] {
        let [_, usual, _] = study(element, meshes, distortion, 0.3);
        for poisson in [0.4999, 0.49999] {
            let [_, displacement, deviator] = study(element, meshes, distortion, poisson);
            let name = format!("{} {distortion} {poisson}", element.name());
            eprintln!("R02 {name:<18} displacement {} | deviator {}", line(&displacement), line(&deviator));
            for ((_, error), (_, least)) in displacement.iter().zip(&usual).skip(meshes.len() - 3) {
                assert!(*error < 2.0 * least, "{name}: {} against {}", line(&displacement), line(&usual));
            }
            assert!(last_three(&deviator) > 0.9, "{name}: {}", line(&deviator));
        }
    }
}

/// Elements with enhanced strains. Waits: the hybrid and reduced elements.
#[test]
fn R02_near_incompressible() {
    near_incompressible(CPE4, &[8, 16, 32, 64]);
    near_incompressible(CAX4, &[8, 16, 32, 64]);
}

#[test]
#[ignore = "a minute, in release"]
fn R02_near_incompressible_in_space() {
    near_incompressible(C3D8, &[3, 6, 12, 24]);
}
