//! Friction of whole pairs: the tangent with what is not symmetric, balance, bits.

use super::scene::*;
use super::work::{deformable, on_sphere};
use crate::contact::Contact;
use crate::enforce::{OPEN, SLIPPING};
use crate::facet::Vec3;
use crate::friction::{Coefficient, Friction, Stick};
use crate::interaction::Interaction;
use crate::pair::Discretization;
use fe_core::{Assembly, BlockMatrix, Couplings, Freedoms, Motion, Pattern, Term};
use std::sync::Arc;

fn with(stick: Stick, coefficient: Coefficient) -> Interaction {
    Interaction { friction: Some(Friction::Coulomb { coefficient, largest: None, stick }), ..linear() }
}

/// All ways to stick, and a coefficient that falls with slip rate and pressure.
fn interactions() -> Vec<Interaction> {
    let rows = [(0.5, 0.0, 0.0), (0.3, 1.0, 0.0), (0.4, 0.0, 9.0), (0.1, 1.0, 9.0)];
    vec![
        with(Stick::ElasticSlip(0.01), Coefficient::Constant(0.4)),
        with(Stick::ElasticSlip(0.01), Coefficient::table(&rows).unwrap()),
        with(Stick::Lagrange, Coefficient::Constant(0.4)),
        Interaction { friction: Some(Friction::Rough), ..linear() },
    ]
}

fn scenes(interaction: &Interaction) -> [(Scene, Freedoms, Contact); 3] {
    let on = |way| on_sphere(way, interaction);
    [deformable(interaction), on(Discretization::SurfaceToSurface), on(Discretization::NodeToSurface)]
}

/// Residual, stiffness and the history after an increment `du` that ends at `u`.
fn evaluate(
    (freedoms, pair): (&Freedoms, &Contact),
    (u, du): (&[f64], &[f64]),
    old: &[f64],
) -> (Vec<f64>, BlockMatrix, Vec<f64>) {
    let mut couplings = Couplings::new(freedoms.nodes());
    pair.couplings(&mut couplings);
    let mut stiffness = BlockMatrix::zero(Arc::new(Pattern::new(freedoms, &couplings)));
    let mut residual = vec![0.0; freedoms.len()];
    let mut new = old.to_vec();
    let mut out = Assembly { residual: &mut residual, stiffness: Some(&mut stiffness), energy: 0.0, status_changes: 0 };
    let at = Motion { u, du, step_time: 1.0, total_time: 1.0, dt: 0.5 };
    pair.evaluate(at, old, &mut new, &mut out).unwrap();
    (residual, stiffness, new)
}

/// A random increment from a random state in which points stick, slip and are open.
fn random(freedoms: &Freedoms, pair: &Contact, seed: u64) -> (Vec<f64>, Vec<f64>, Vec<f64>) {
    let mut next = numbers(seed);
    let first: Vec<f64> = (0..freedoms.len()).map(|_| 0.1 * next()).collect();
    let zero = vec![0.0; pair.history()];
    let old = evaluate((freedoms, pair), (&first, &first), &zero).2;
    let du: Vec<f64> = (0..freedoms.len()).map(|_| 0.06 * next()).collect();
    (first.iter().zip(&du).map(|(a, b)| a + b).collect(), du, old)
}

/// Symmetric part and couplings together are the differences of the residual: central, of smooth functions whose third
/// derivatives are those of g/|g| at slips of 1e-2, step²/slip² = 1e-8 for steps of 1e-6; round-off 1e-16/1e-6 of the
/// forces, which are as large as a hundredth of the stiffness.
#[test]
fn the_tangent_is_the_slope_of_the_force() {
    for interaction in interactions() {
        for (_, freedoms, pair) in scenes(&interaction) {
            let both = (&freedoms, &pair);
            let (u, du, old) = random(&freedoms, &pair, 5);
            let (_, stiffness, new) = evaluate(both, (&u, &du), &old);
            let statuses = &new[..pair.points.len()];
            assert!(statuses.contains(&OPEN) && statuses.iter().any(|s| *s != OPEN), "{statuses:?}");
            let slips = statuses.contains(&SLIPPING);
            assert_eq!(slips, !pair.friction().unwrap().is_symmetric());
            let largest = stiffness.values.iter().fold(0.0f64, |m, v| m.max(v.abs()));
            let at = Motion { u: &u, du: &du, step_time: 1.0, total_time: 1.0, dt: 0.5 };
            let lacking = pair.lacking(at, (&old, &new));
            let mut compared = 0;
            for f in 0..freedoms.len() {
                let (mut unit, mut column) = (vec![0.0; u.len()], vec![0.0; u.len()]);
                unit[f] = 1.0;
                stiffness.multiply_add(&unit, &mut column);
                lacking.iter().for_each(|lacks| lacks(&unit, &mut column));
                let step = 1e-6;
                let moved = |by: f64| {
                    let shift = |v: &[f64]| v.iter().zip(&unit).map(|(v, e)| v + by * e).collect::<Vec<f64>>();
                    evaluate(both, (&shift(&u), &shift(&du)), &old)
                };
                let (low, high) = (moved(-step), moved(step));
                if low.2[..pair.points.len()] != high.2[..pair.points.len()] {
                    continue;
                }
                compared += 1;
                for (column, (low, high)) in column.iter().zip(low.0.iter().zip(&high.0)) {
                    let slope = (high - low) / (2.0 * step);
                    assert!((slope - column).abs() < 1e-7 * largest, "{f}: {slope} {column}");
                }
            }
            assert!(compared > freedoms.len() / 2 && lacking.is_some() == slips);
        }
    }
}

/// Forces of friction cancel between the sides; so do their moments where the sides touch, for a force along the surface
/// at either side of a gap g leaves a moment of g times itself. A rigid surface is taken where the other side is.
#[test]
fn action_is_reaction() {
    for interaction in interactions() {
        for (_, freedoms, pair) in scenes(&interaction) {
            let (u, du, old) = random(&freedoms, &pair, 5);
            let (_, _, new) = evaluate((&freedoms, &pair), (&u, &du), &old);
            let state = pair.state(&u, &new);
            let (secondary, main) = (state.secondary_shear.as_ref().unwrap(), state.main_shear.as_ref().unwrap());
            let sum = |a: [f64; 3], b: [f64; 3]| (Vec3::from(a) + Vec3::from(b)).norm();
            let size = Vec3::from(secondary.force).norm();
            assert!(size > 1e-3 && sum(secondary.force, main.force) < 1e-13 * size.max(1.0), "{secondary:?} {main:?}");
            let gap = pair.points.iter().fold(0.0f64, |m, p| m.max(p.gap.abs()));
            let each: f64 = state.points.iter().map(|p| p.measure.value() * p.shear[0].hypot(p.shear[1])).sum();
            let bound = if pair.has_rigid_main() { 1e-12 * size.max(1.0) } else { gap * each };
            assert!(sum(secondary.moment, main.moment) <= bound, "{:?} {:?} {bound}", secondary.moment, main.moment);
            assert_eq!(pair.dissipated(&old, &new) > 0.0, !pair.friction().unwrap().is_symmetric());
        }
    }
}

/// What opens forgets; slip counts while it is closed.
#[test]
fn a_point_that_opens_forgets() {
    let interaction = &interactions()[0];
    let [(_, freedoms, pair), ..] = scenes(interaction);
    let (u, du, old) = random(&freedoms, &pair, 2);
    let (_, _, new) = evaluate((&freedoms, &pair), (&u, &du), &old);
    let slid = |history: &[f64]| (0..pair.points.len()).map(|i| pair.shear_and_slip(i, history)).collect::<Vec<_>>();
    let apart: Vec<f64> = (0..freedoms.len()).map(|f| if freedoms.node(f) < 40 { 0.0 } else { 9.0 }).collect();
    let lifted: Vec<f64> = (0..pair.points.len()).map(|i| pair.opening(i, &apart)).collect();
    let far: Vec<f64> = if lifted.iter().all(|g| *g > 0.0) { apart } else { apart.iter().map(|a| -a).collect() };
    let (_, _, open) = evaluate((&freedoms, &pair), (&far, &far), &new);
    for (i, (now, before)) in slid(&open).iter().zip(slid(&new)).enumerate() {
        if pair.opening(i, &far) > 0.0 {
            assert_eq!(*now, ([0.0; 2], before.1));
        }
    }
    assert!(slid(&new).iter().any(|s| s.1 != [0.0; 2]));
}
