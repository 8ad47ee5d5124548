//! What resists the motion of surfaces, over whole pairs.

use super::scene::*;
use super::work::{deformable, on_sphere};
use crate::conditions::Conditions;
use crate::contact::Contact;
use crate::facet::Vec3;
use crate::interaction::Interaction;
use crate::pair::Discretization;
use crate::viscous::{Coefficient, Damping, Stabilization};
use fe_core::{Assembly, Freedoms, Motion, Term};

const DAMPING: Damping = Damping { coefficient: 100.0, clearance: 1.0, constant_part: 0.5, tangent_fraction: 0.7 };
const STABILIZATION: Stabilization =
    Stabilization { coefficient: Coefficient::Given(100.0), tangent_fraction: 0.7, end: 1.0, range: None };

/// All pairs with all that resists, in a step that has begun.
fn resisted() -> Vec<(Scene, Freedoms, Contact)> {
    let interaction = Interaction { damping: Some(DAMPING), stabilized_along: true, ..linear() };
    let on = |way| on_sphere(way, &interaction);
    let mut scenes =
        vec![deformable(&interaction), on(Discretization::SurfaceToSurface), on(Discretization::NodeToSurface)];
    for (_, freedoms, pair) in &mut scenes {
        let conditions = Conditions { stabilization: Some(STABILIZATION), ..Conditions::default() };
        let mut history = vec![0.0; pair.history()];
        pair.enter(&conditions, (0.0, 1.0), &vec![0.0; freedoms.len()], &mut history);
        assert!(pair.holds_along());
    }
    scenes
}

/// Residual of an increment `du` from rest, without what the law does.
fn resistance((_, freedoms, pair): &(Scene, Freedoms, Contact), du: &[f64]) -> Vec<f64> {
    let force = |dt: f64| {
        let (old, mut residual) = (vec![0.0; pair.history()], vec![0.0; freedoms.len()]);
        let mut out = Assembly { residual: &mut residual, stiffness: None, energy: 0.0, status_changes: 0 };
        let at = Motion { u: du, du, step_time: 0.5, total_time: 0.5, dt };
        pair.evaluate(at, &old, &mut old.clone(), &mut out).unwrap();
        residual
    };
    // Without time nothing resists.
    force(0.5).iter().zip(force(0.0)).map(|(all, law)| all - law).collect()
}

/// A rotation about a point and a translation of everything; the reference node turns with it.
fn rigid((scene, freedoms, _): &(Scene, Freedoms, Contact), shift: Vec3, turn: Vec3) -> Vec<f64> {
    let center = Vec3::new(0.3, -1.0, 0.2);
    let of = |f: usize| {
        let x = Vec3::from(scene.structure.mesh.points[freedoms.node(f)]);
        match freedoms.component(f) {
            c @ 0..3 => (shift + turn.cross(&(x - center)))[c],
            c => turn[c - 3],
        }
    };
    (0..freedoms.len()).map(of).collect()
}

/// What moves both sides together, the rotation of a rigid one included, meets no resistance: round-off against the forces
/// that a motion of the same size of one side alone meets. Between deformable sides a rotation slides them by the gap
/// between them.
#[test]
fn a_common_motion_meets_no_resistance() {
    let (shift, turn) = (Vec3::new(1e-3, 2e-3, -1e-3), Vec3::new(2e-3, -1e-3, 3e-3));
    for scene in &resisted() {
        let mut next = numbers(3);
        let du: Vec<f64> = (0..scene.1.len()).map(|_| 1e-3 * next()).collect();
        let size = resistance(scene, &du).iter().fold(0.0f64, |m, r| m.max(r.abs()));
        let turn = if scene.2.has_rigid_main() { turn } else { Vec3::zeros() };
        let common = resistance(scene, &rigid(scene, shift, turn)).iter().fold(0.0f64, |m, r| m.max(r.abs()));
        assert!(size > 1e-3 && common < 1e-12 * size, "{common} of {size}");
    }
}
