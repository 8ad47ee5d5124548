//! The block as a term: consistency, threads, bad elements.

use super::scene::{Scene, jiggle, noise, straighten};
use crate::element::ElementType::{self, *};
use crate::solid::{Defect, Place, SolidBlock, check};
use crate::term::{Assembly, Motion, Term};
use crate::verify;

/// A quadratic energy: differences have no truncation, round-off is ε/step = 1e-13 of a scale of some tens.
#[test]
fn force_and_stiffness_are_derivatives() {
    for element in ElementType::SOLIDS {
        let mut scene = Scene::grid(element, [2, 2, 1], |x| {
            let y = jiggle(x, 0.1);
            [y[0] + 1.0, y[1] + 0.3 * y[0] * y[0], y[2]]
        });
        straighten(&mut scene);
        let u = scene.field(|x| std::array::from_fn(|i| noise(x, i)));
        let found = verify::term(&scene.block(), &scene.freedoms, &u, 1e-3).unwrap();
        assert!(found.force < 1e-10 && found.stiffness < 1e-10 && found.paths == 0.0, "{element:?} {found:?}");
        let block = scene.block();
        let mut force = vec![0.0; u.len()];
        scene.stiffness().multiply_add(&u, &mut force);
        let energy: f64 = force.iter().zip(&u).map(|(f, u)| 0.5 * f * u).sum();
        assert!((block.energy(&u) - energy).abs() < 1e-13 * energy, "{element:?}");
    }
}

/// ½ Σ V_p σ : ε is the stored energy, enhanced strains included, to round-off: sheared cells, so that all points
/// of a cell stand for the same volume.
#[test]
fn stresses_and_strains_hold_the_energy() {
    for element in [C3D4, C3D10, C3D8, CPE3, CPE4, CPS3, CPS4] {
        let scene = Scene::grid(element, [2, 2, 2], |x| [x[0] + 0.3 * x[1], x[1] - 0.2 * x[0], 1.3 * x[2]]);
        let u = scene.field(|x| std::array::from_fn(|i| noise(x, i)));
        let block = scene.block();
        let fields = block.stresses(&u);
        let work = |(s, e): (&[f64; 6], &[f64; 6])| -> f64 {
            (0..6).map(|i| s[i] * e[i] * if i < 3 { 1.0 } else { 2.0 }).sum()
        };
        let energies = fields.stress.iter().zip(&fields.strain).map(work);
        let energy: f64 = energies
            .enumerate()
            .map(|(p, work)| 0.5 * work * block.volumes()[p / block.points()] / block.points() as f64)
            .sum();
        assert!((energy - block.energy(&u)).abs() < 1e-12 * energy, "{element:?} {energy} {}", block.energy(&u));
    }
}

/// Linear fields at the points arrive at the nodes exactly (round-off of eight terms of size ten).
#[test]
fn nodal_values_extrapolate_linear_fields() {
    for element in [C3D10, C3D8, CPE4, CAX3] {
        let scene = Scene::grid(element, [1, 1, 1], |x| [x[0] + 1.0, x[1], x[2]]);
        let linear = |x: [f64; 3]| 1.0 + 2.0 * x[0] - 3.0 * x[1] + 0.5 * x[2];
        let block = scene.block();
        let kind = element.kind();
        let mut at_points = Vec::new();
        let cell_points = |cell: usize| -> Vec<[f64; 3]> {
            scene.cell(cell).iter().map(|&n| scene.structure.mesh.points[n as usize]).collect()
        };
        for cell in 0..block.cells().len() {
            let x = cell_points(cell);
            for (xi, _) in crate::solid::tables::rule(element).points {
                let mut n = [0.0; 10];
                fe_mesh::shape::values(kind, &xi, &mut n);
                let position = std::array::from_fn(|i| x.iter().zip(&n).map(|(x, n)| x[i] * n).sum());
                at_points.push([linear(position); 6]);
            }
        }
        let nodal = block.nodal(&at_points);
        for cell in 0..block.cells().len() {
            for (a, x) in cell_points(cell).into_iter().enumerate() {
                let found = nodal[cell * kind.nodes() + a][2];
                assert!((found - linear(x)).abs() < 1e-13, "{element:?} {found} {}", linear(x));
            }
        }
    }
}

/// The same bits for 1, 2, 3 and 8 threads, over several rounds of chunks.
#[test]
fn same_bits_for_any_number_of_threads() {
    for (element, counts) in [(C3D8, [14, 14, 12]), (CAX4, [50, 50, 0]), (C3D4, [8, 8, 8])] {
        let scene = Scene::grid(element, counts, |x| {
            let y = jiggle(x, 0.004);
            [y[0] + 1.0, y[1], y[2]]
        });
        let u = scene.field(|x| std::array::from_fn(|i| noise(x, i)));
        let run = |threads: usize| {
            let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
            pool.install(|| {
                let block = scene.block();
                let mut matrix = scene.zero_stiffness(&block);
                let mut residual = vec![0.0; u.len()];
                let at = Motion { u: &u, du: &u, step_time: 1.0, total_time: 1.0, dt: 1.0 };
                let stiffness = Some(&mut matrix);
                let mut out = Assembly { residual: &mut residual, stiffness, energy: 0.0, status_changes: 0 };
                block.evaluate(at, &[], &mut [], &mut out).unwrap();
                let energy = out.energy;
                (matrix.values, residual, energy, block.stresses(&u))
            })
        };
        let one = run(1);
        [2, 3, 8].into_iter().for_each(|threads| assert!(run(threads) == one, "{element:?} {threads}"));
    }
}

fn defect(element: ElementType, points: &[[f64; 3]]) -> (String, Defect) {
    let nodes = (0..points.len() as u32).collect();
    let scene = Scene::new(element, points.to_vec(), nodes);
    match SolidBlock::new(&scene.structure, &scene.structure.sections[0], &scene.freedoms) {
        Err(bad) => (bad.label, bad.defect),
        Ok(_) => panic!("{element:?} passed"),
    }
}

#[test]
fn bad_elements_are_named() {
    let square = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [1.0, 1.0, 0.0], [0.0, 1.0, 0.0]];
    let reversed = [square[0], square[3], square[2], square[1]];
    let (label, inverted) = defect(CPE4, &reversed);
    assert!(label == "1" && matches!(inverted, Defect::Inverted { jacobian: -0.25, .. }));
    let concave = [square[0], square[1], [0.3, 0.3, 0.0], square[3]];
    assert!(matches!(defect(CPS4, &concave).1, Defect::Folded { place: Place::Corner(2), .. }));
    let flat = square.map(|x| [x[0], 0.0, 0.0]);
    assert!(matches!(defect(CPE4, &flat).1, Defect::NoVolume { .. }));
    let across = square.map(|x| [x[0] - 0.5, x[1], 0.0]);
    let beyond = Defect::BeyondAxis { place: Place::Corner(0), radius: -0.5 };
    assert_eq!(defect(CAX4, &across).1, beyond);
    let coplanar = [square[0], square[1], square[2], square[3]];
    assert!(matches!(defect(C3D4, &coplanar).1, Defect::NoVolume { .. }));
    let missing = [square[0], square[1], square[2], [f64::NAN, 0.0, 1.0]];
    assert!(matches!(defect(C3D4, &missing).1, Defect::NoVolume { .. }));
}

/// A cube whose corner 7 is pushed to (a, a, a): j there is (3 a − 2)/8, the triple product of its half edges.
#[test]
fn a_brick_folded_at_a_corner_is_told() {
    let cube = |a: f64| {
        let mut points: Vec<[f64; 3]> =
            [0.0, 1.0].iter().flat_map(|&z| [[0.0, 0.0, z], [1.0, 0.0, z], [1.0, 1.0, z], [0.0, 1.0, z]]).collect();
        points[6] = [a; 3];
        let scene = Scene::new(C3D8, points, (0..8).collect());
        check(&scene.structure.mesh, &scene.structure.sections[0])
    };
    let folded = cube(0.6).unwrap();
    assert_eq!((folded.len(), folded[0].corner, folded[0].label.as_str(), folded[0].node.as_str()), (1, 6, "1", "7"));
    assert!((folded[0].jacobian + 0.025).abs() < 1e-15 * 8.0, "{}", folded[0]);
    assert_eq!(cube(0.7), Ok(Vec::new()));
    // Far enough in, an integration point folds too.
    assert!(matches!(cube(0.2).unwrap_err().defect, Defect::Folded { place: Place::Point(_), .. }));
}
