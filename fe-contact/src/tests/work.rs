//! A pair is a term: force is the slope of energy, stiffness the slope of force; rigid motions of the whole do not
//! move a gap; the threads change no bit.

use super::scene::*;
use crate::contact::Contact;
use crate::facet::Vec3;
use crate::interaction::Interaction;
use crate::pair::Discretization;
use crate::point::ContactStatus;
use crate::rigid::{Piece, RigidSurface, Sweep};
use crate::surface::Main;
use fe_core::element::ElementType::*;
use fe_core::{Assembly, BlockMatrix, Couplings, Freedoms, Motion, Pattern, Term};
use std::sync::Arc;

/// Curved faces of both kinds, partly overlapping.
fn curved() -> Scene {
    let mut scene = Scene::default();
    let bend = |x: Vec3| Vec3::new(x.x, x.y - 0.05 * (x.x - 1.0) * (x.x - 1.0), x.z + 0.02 * x.x * x.y);
    scene.block(C3D10, [3, 1, 2], move |r| turned(bend(Vec3::new(2.0 * r.x, 0.98 + r.y, 1.7 * r.z))));
    scene.block(C3D8, [2, 1, 3], move |r| turned(bend(Vec3::new(0.2 + 1.9 * r.x, r.y, 2.0 * r.z))));
    scene
}

pub fn deformable(interaction: &Interaction) -> (Scene, Freedoms, Contact) {
    let scene = curved();
    let pair =
        surfaces(scene.faces(0, |r| r[1] == 0.0), scene.faces(1, |r| r[1] == 1.0), Discretization::SurfaceToSurface);
    let (freedoms, pair) = (scene.freedoms(), scene.pair(&pair, interaction));
    (scene, freedoms, pair)
}

/// Against a rigid sphere whose reference node is off its centre.
pub fn on_sphere(discretization: Discretization, interaction: &Interaction) -> (Scene, Freedoms, Contact) {
    let mut scene = Scene::default();
    let element = if discretization == Discretization::SurfaceToSurface { C3D10 } else { C3D8 };
    scene.block(element, [3, 1, 3], |r| Vec3::new(r.x - 0.5, r.y - 0.02, r.z - 0.5));
    let reference = scene.node([0.3, -1.0, 0.2]);
    let surface = RigidSurface {
        name: "R".into(),
        sweep: Sweep::Revolution { origin: [0.0, -3.0, 0.0], axis: [0.0, 1.0, 0.0] },
        start: [0.0, 3.0],
        pieces: vec![Piece::Arc { to: [3.0, 0.0], center: [0.0, 0.0] }],
    };
    let mut pair = surfaces(scene.faces(0, |r| r[1] == 0.0), Vec::new(), discretization);
    pair.main = Main::Rigid { surface, reference };
    let freedoms = scene.structure.freedoms(&[reference]);
    let pair = Contact::of_pair(&scene.structure, &freedoms, &pair, interaction).unwrap();
    (scene, freedoms, pair)
}

struct Answer {
    residual: Vec<f64>,
    energy: f64,
    stiffness: BlockMatrix,
    changes: usize,
}

fn evaluate(pair: &Contact, freedoms: &Freedoms, u: &[f64], history: &mut [f64]) -> Answer {
    let mut couplings = Couplings::new(freedoms.nodes());
    pair.couplings(&mut couplings);
    let mut stiffness = BlockMatrix::zero(Arc::new(Pattern::new(freedoms, &couplings)));
    let mut residual = vec![0.0; freedoms.len()];
    let mut out = Assembly { residual: &mut residual, stiffness: Some(&mut stiffness), energy: 0.0, status_changes: 0 };
    let at = Motion { u, du: u, step_time: 1.0, total_time: 1.0, dt: 1.0 };
    pair.evaluate(at, &[], history, &mut out).unwrap();
    let (energy, changes) = (out.energy, out.status_changes);
    Answer { residual, energy, stiffness, changes }
}

/// Central differences of a quadratic (no gap passes its kink within the step) are exact: what remains is round-off
/// of energies up to 1 over the step, 1e-15/1e-5, against forces above 1e-2.
fn check_slopes((_, freedoms, pair): (Scene, Freedoms, Contact)) {
    let mut next = numbers(7);
    let u: Vec<f64> = (0..freedoms.len()).map(|_| 0.1 * next()).collect();
    let step = 1e-5;
    let open = (0..pair.points.len()).filter(|&i| pair.opening(i, &u) > 0.0).count();
    assert!((1..pair.points.len()).contains(&open), "both states are there");
    assert!((0..pair.points.len()).all(|i| pair.opening(i, &u).abs() > 2.0 * step));
    let found = fe_core::verify::term(&pair, &freedoms, &u, step).unwrap();
    assert!(found.force < 1e-8 && found.stiffness < 1e-8 && found.paths == 0.0, "{found:?}");
}

#[test]
fn force_and_stiffness_are_slopes() {
    check_slopes(deformable(&linear()));
    check_slopes(on_sphere(Discretization::SurfaceToSurface, &linear()));
    check_slopes(on_sphere(Discretization::NodeToSurface, &linear()));
}

/// u = a + θ × x of everything, the reference node turning too, changes no gap: action and reaction meet on one line.
#[test]
fn a_rigid_motion_of_all_changes_no_gap() {
    let cases = [
        deformable(&linear()),
        on_sphere(Discretization::SurfaceToSurface, &linear()),
        on_sphere(Discretization::NodeToSurface, &linear()),
    ];
    for (scene, freedoms, pair) in cases {
        let (shift, turn) = (Vec3::new(0.3, -0.7, 0.2), Vec3::new(0.5, 0.4, -0.9));
        let u: Vec<f64> = (0..freedoms.len())
            .map(|f| match freedoms.component(f) {
                c @ 0..3 => (shift + turn.cross(&Vec3::from(scene.structure.mesh.points[freedoms.node(f)])))[c],
                c => turn[c - 3],
            })
            .collect();
        for i in 0..pair.points.len() {
            assert!(pair.rate(i, &u, &u).abs() < 1e-13);
        }
        let state = pair.state(&vec![0.0; freedoms.len()], &vec![0.0; pair.history()]);
        let balance = |a: [f64; 3], b: [f64; 3]| (Vec3::from(a) + Vec3::from(b)).norm();
        assert!(Vec3::from(state.secondary.force).norm() > 1e-3);
        assert!(balance(state.secondary.force, state.main.force) < 1e-13);
        assert!(balance(state.secondary.moment, state.main.moment) < 1e-12);
    }
}

/// A point that just touches has the stiffness of the closed side and no force; changes of status are counted once.
#[test]
fn touching_is_closed_and_changes_are_counted() {
    let mut scene = Scene::default();
    scene.block(CPE4, [3, 1, 0], |r| Vec3::new(r.x, 1.0 + r.y, 0.0));
    scene.block(CPE4, [2, 1, 0], |r| Vec3::new(r.x, r.y, 0.0));
    let pair =
        surfaces(scene.faces(0, |r| r[1] == 0.0), scene.faces(1, |r| r[1] == 1.0), Discretization::SurfaceToSurface);
    let (pair, freedoms) = (scene.pair(&pair, &linear()), scene.freedoms());
    let u = vec![0.0; freedoms.len()];
    let mut history = vec![0.0; pair.history()];
    let first = evaluate(&pair, &freedoms, &u, &mut history);
    assert_eq!(first.changes, 4);
    assert!(first.residual.iter().all(|r| r.abs() < 1e-12) && first.stiffness.largest_diagonal() > 1.0);
    assert_eq!(evaluate(&pair, &freedoms, &u, &mut history).changes, 0);
    assert!(pair.state(&u, &vec![0.0; pair.history()]).points.iter().all(|p| p.status == ContactStatus::Closed));
    let mut lifted = u.clone();
    pair.secondary_nodes().iter().for_each(|&n| lifted[freedoms.index(n as usize, 1).unwrap()] = 1e-9);
    let open = evaluate(&pair, &freedoms, &lifted, &mut history);
    assert_eq!((open.changes, open.energy, open.stiffness.largest_diagonal()), (4, 0.0, 0.0));
}

#[test]
fn any_number_of_threads_gives_the_same_bits() {
    let on = |threads| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
        pool.install(|| deformable(&linear()).2.points)
    };
    let one = on(1);
    assert!(one == on(2) && one == on(8));
}
