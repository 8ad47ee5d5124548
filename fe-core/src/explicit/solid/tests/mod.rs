//! Elements of explicit steps against what they must do exactly.

use super::*;
use crate::explicit::Moving;
use crate::material::{Elastic, Hardening, Material};
use crate::section::Section;
use fe_mesh::Mesh;
use fe_mesh::generate::Block;
use nalgebra::{Matrix3, Rotation3, Vector3};

const STEEL: Elastic = Elastic { young: 210e3, poisson: 0.3 };
const DENSITY: f64 = 7.85e-9;

struct Scene {
    structure: Structure,
    freedoms: Freedoms,
    solids: Solids,
}

impl Scene {
    fn new(mesh: Mesh, element: ElementType, hourglass: Hourglass, hardening: Option<Hardening>) -> Self {
        let cells: Vec<CellId> = mesh.cells().collect();
        let materials = vec![Material { density: Some(DENSITY), ..Material::elastic("M", STEEL) }];
        let section = Section { element, cells: cells.clone(), material: 0, thickness: 1.0, hourglass: None };
        let structure =
            Structure { mesh, elements: vec![element], materials, sections: vec![section], ..Structure::default() };
        let freedoms = structure.freedoms(&[]);
        let flow = Flow { lambda: STEEL.lambda(), mu: STEEL.mu(), hardening };
        let section = SolidSection { element, cells: &cells, flow, density: DENSITY, hourglass, viscosity: [0.0; 2] };
        let solids = Solids::new(&structure, &freedoms, &[section]);
        Scene { structure, freedoms, solids }
    }

    fn bricks(divisions: [usize; 3], map: impl Fn([f64; 3]) -> [f64; 3]) -> Self {
        Self::new(Block::hex8(divisions).mapped(map), ElementType::C3D8R, Hourglass::Enhanced(1.0), None)
    }

    /// Takes every node from where it is at one time to where it is at the next, over and over; the forces at the end.
    fn follow(&mut self, steps: usize, dt: f64, place: impl Fn(Vector3<f64>, f64) -> Vector3<f64>) -> Vec<f64> {
        let n = self.freedoms.len();
        let (mut u, mut forces, mut advance) = (vec![0.0; n], vec![0.0; n], Advance::default());
        let mut x0 = vec![Vector3::zeros(); self.structure.mesh.points.len()];
        x0.iter_mut().zip(&self.structure.mesh.points).for_each(|(x, p)| *x = Vector3::from(*p));
        for step in 0..steps {
            let mut v = vec![0.0; n];
            for (node, x) in x0.iter().enumerate() {
                let moved = place(*x, (step + 1) as f64 / steps as f64) - x;
                for (c, f) in self.freedoms.of_node(node).enumerate() {
                    v[f] = (moved[c] - u[f]) / dt;
                    u[f] = moved[c];
                }
            }
            forces.fill(0.0);
            let at = Moving { u: &u, v: &v, step_time: 0.0, total_time: 0.0, dt, stable: f64::INFINITY };
            advance = self.solids.advance(&at, &mut forces).unwrap();
        }
        assert!(advance.stable > 0.0);
        forces
    }
}

/// A cube with its inner nodes moved.
fn distorted(x: [f64; 3]) -> [f64; 3] {
    let inside = x.iter().all(|v| *v > 1e-9 && *v < 1.0 - 1e-9);
    let by = if inside { 0.12 } else { 0.0 };
    [x[0] + by * (7.0 * x[1]).sin(), x[1] - by * (5.0 * x[2]).cos(), x[2] + by * (9.0 * x[0]).sin()]
}

fn norm(stress: [f64; 6]) -> f64 {
    stress.iter().map(|s| s * s).sum::<f64>().sqrt()
}

/// A stretched body is turned by 400° in 50 increments: the stress turns with it, rounding after so many increments aside.
#[test]
fn stress_turns_with_the_body() {
    let axis = Vector3::new(1.0, 2.0, -2.0) / 3.0;
    let stretch = Matrix3::new(1.001, 0.0004, 0.0, 0.0, 0.9995, 0.0, 0.0, 0.0003, 1.0007);
    let mut still = Scene::bricks([3, 3, 3], distorted);
    still.follow(1, 1.0, |x, _| stretch * x);
    let mut turned = Scene::bricks([3, 3, 3], distorted);
    turned.follow(1, 1.0, |x, _| stretch * x);
    // The increments go on from the stretched place.
    let angle = 400f64.to_radians();
    let turn = |t: f64| Rotation3::from_axis_angle(&nalgebra::Unit::new_unchecked(axis), angle * t);
    let (n, steps) = (turned.freedoms.len(), 50);
    let (mut u, mut forces) = (vec![0.0; n], vec![0.0; n]);
    let points: Vec<Vector3<f64>> = turned.structure.mesh.points.iter().map(|p| Vector3::from(*p)).collect();
    for step in 0..=steps {
        let mut v = vec![0.0; n];
        for (node, x) in points.iter().enumerate() {
            let moved = turn(step as f64 / steps as f64) * (stretch * x) - x;
            for (c, f) in turned.freedoms.of_node(node).enumerate() {
                v[f] = if step == 0 { 0.0 } else { moved[c] - u[f] };
                u[f] = moved[c];
            }
        }
        forces.fill(0.0);
        let at = Moving { u: &u, v: &v, step_time: 0.0, total_time: 0.0, dt: 1.0, stable: f64::INFINITY };
        turned.solids.advance(&at, &mut forces).unwrap();
    }
    let r = turn(1.0).into_inner();
    for (before, after) in still.solids.states().zip(turned.solids.states()) {
        let full = |s: [f64; 6]| Matrix3::new(s[0], s[3], s[5], s[3], s[1], s[4], s[5], s[4], s[2]);
        let difference = (r * full(before.stress) * r.transpose() - full(after.stress)).norm();
        assert!(difference < 1e-11 * STEEL.young * 1e-2, "{difference}");
    }
}

/// Uniform straining of any mesh: the same stress everywhere, and no force on inner nodes.
#[test]
fn patch() {
    let tets = || Block::tet4([3, 3, 3]).mapped(distorted);
    let scenes =
        [Scene::bricks([3, 3, 3], distorted), Scene::new(tets(), ElementType::C3D4, Hourglass::Enhanced(1.0), None)];
    let stretch = Matrix3::new(1e-3, 4e-4, 0.0, 0.0, -5e-4, 2e-4, 3e-4, 0.0, 7e-4);
    for mut scene in scenes {
        let forces = scene.follow(1, 1.0, |x, t| x + stretch * x * t);
        let first = scene.solids.states().next().unwrap().stress;
        for state in scene.solids.states() {
            let difference: [f64; 6] = std::array::from_fn(|i| state.stress[i] - first[i]);
            assert!(norm(difference) < 1e-12 * norm(first), "{difference:?}");
        }
        let size = forces.iter().fold(0.0f64, |m, f| m.max(f.abs()));
        for (node, x) in scene.structure.mesh.points.iter().enumerate() {
            if x.iter().all(|v| *v > 0.05 && *v < 0.95) {
                let force = scene.freedoms.of_node(node).map(|f| forces[f].abs()).fold(0.0, f64::max);
                assert!(force < 1e-12 * size, "{node}: {force} of {size}");
            }
        }
    }
}

/// Stretch along one axis: the strain is logarithmic, to the square of the increments over 12.
#[test]
fn strain_is_logarithmic() {
    let errors = [10, 20].map(|steps| {
        let mut scene = Scene::bricks([1, 1, 1], |x| x);
        scene.follow(steps, 1.0, |x, t| Vector3::new(x.x * (1.0 + 0.5 * t), x.y, x.z));
        let state = scene.solids.states().next().unwrap();
        state.stress[0] / ((STEEL.lambda() + 2.0 * STEEL.mu()) * 1.5f64.ln()) - 1.0
    });
    // Σ (ε − ε³/12 + …) of the midpoint rule against ln: (0.5/10)²/12 times the mean of 1/x² (2/3), over ln 1.5 / 0.5.
    assert!(errors[0].abs() < 2e-4 && (errors[0] / errors[1] - 4.0).abs() < 0.05, "{errors:?}");
}

/// One brick at the largest stable increment that it names: Δt c_d/h of a free cube with ν = 0.3.
#[test]
fn b06_stable_increment_of_a_free_cube() {
    let speed = ((STEEL.lambda() + 2.0 * STEEL.mu()) / DENSITY).sqrt();
    let mut scene = Scene::bricks([1, 1, 1], |x| x.map(|v| 2.0 * v));
    let n = scene.freedoms.len();
    let (zero, mut forces) = (vec![0.0; n], vec![0.0; n]);
    let at = Moving { u: &zero, v: &zero, step_time: 0.0, total_time: 0.0, dt: 0.0, stable: f64::INFINITY };
    let stable = scene.solids.advance(&at, &mut forces).unwrap().stable;
    assert!((stable * speed / 2.0 - 0.733799385705).abs() < 1e-11, "{}", stable * speed / 2.0);
}

/// Tension beyond yield with two straight pieces of hardening and unloading between: uniaxial strain, whose deviator is all
/// that flows. q grows by 2μ ε until it is σ_y, then by 2μ ε h/(3μ + h).
#[test]
fn flow_follows_the_table() {
    let rows = Hardening { points: vec![(0.0, 300.0), (0.002, 340.0), (0.01, 360.0)] };
    let mesh = Block::hex8([1, 1, 1]).mesh();
    let mut scene = Scene::new(mesh, ElementType::C3D8R, Hourglass::Enhanced(1.0), Some(rows));
    let mu = STEEL.mu();
    scene.follow(2000, 1.0, |x, t| Vector3::new(x.x * (0.006 * t).exp(), x.y, x.z));
    let state = scene.solids.states().next().unwrap();
    let [xx, yy, ..] = state.stress;
    let q = xx - yy;
    // 2μ (ε − 3/2 p) = σ_y(p) with ε = 0.006: the strain of each increment is that of the midpoint rule, 1e-11 off.
    let yielded = |p: f64| if p < 0.002 { 300.0 + 20e3 * p } else { 340.0 + 2.5e3 * (p - 0.002) };
    assert!((q - yielded(state.plastic)).abs() < 1e-9 * q, "{q} {}", state.plastic);
    assert!((2.0 * mu * (0.006 - 1.5 * state.plastic) - q).abs() < 1e-6 * q);
    assert!(state.plastic > 0.002);
}

/// The hourglass shapes meet a resistance, rigid motions and constant strains none.
#[test]
fn hourglass_motion_is_resisted_alone() {
    for hourglass in [Hourglass::Enhanced(1.0), Hourglass::Stiffness(0.05), Hourglass::Viscous(0.1)] {
        let scene = || Scene::new(Block::hex8([1, 1, 1]).mesh(), ElementType::C3D8R, hourglass, None);
        let mut twisted = scene();
        let forces = twisted.follow(1, 1e-7, |x, _| {
            let s = x.map(|v| 2.0 * v - 1.0);
            x + Vector3::new(s.y * s.z, s.x * s.y * s.z, s.x * s.y) * 1e-4
        });
        let work = twisted.solids.energies();
        // Of the gradients' change by the motion itself, a part 1e-4 of the motion strains the element.
        assert!(forces.iter().any(|f| f.abs() > 1e-3) && work.internal < 1e-7 * work.hourglass, "{work:?}");
    }
}

/// Updates a second of blocks with every element in motion; for release builds: `--ignored --nocapture`.
#[test]
#[ignore = "measures speed"]
#[allow(clippy::print_stdout)]
fn updates_per_second() {
    let n = 40;
    let scenes = [
        ("C3D8R", Scene::bricks([n, n, n], |x| x), n * n * n),
        (
            "C3D4",
            Scene::new(Block::tet4([n, n, n]).mesh(), ElementType::C3D4, Hourglass::Enhanced(1.0), None),
            6 * n * n * n,
        ),
    ];
    for (name, mut scene, elements) in scenes {
        let freedoms = scene.freedoms.len();
        let u = vec![0.0; freedoms];
        let v: Vec<f64> = (0..freedoms).map(|f| ((f * 7919) % 1000) as f64 * 1e-3).collect();
        let mut forces = vec![0.0; freedoms];
        let at = Moving { u: &u, v: &v, step_time: 0.0, total_time: 0.0, dt: 1e-9, stable: f64::INFINITY };
        let start = std::time::Instant::now();
        let increments = 100;
        for _ in 0..increments {
            forces.fill(0.0);
            scene.solids.advance(&at, &mut forces).unwrap();
        }
        let rate = (elements * increments) as f64 / start.elapsed().as_secs_f64();
        println!("{name}: {:.2} million updates a second on {} threads", 1e-6 * rate, rayon::current_num_threads());
    }
}
