//! Points that may not open again, and what sticks on springs along the surface.

use super::*;
use crate::law::tabular::Tabular;

/// A ball that may not leave again swings about the surface like on a spring that pulls, too: with the slope of LINEAR, with
/// the first one of a table, with that of hard contact.
#[test]
fn no_separation_pulls() {
    let (m, v, k, dt) = (1.0, 1.0, 4.0, 1e-3);
    let table = Tabular::new(&[[0.0, 0.0], [4.0, 1.0], [400.0, 2.0]]).unwrap();
    let normals = [
        Normal::Softened(Arc::new(Linear { slope: k, clearance: 0.0 })),
        Normal::Softened(Arc::new(table)),
        Normal::Hard,
    ];
    for normal in normals {
        let structure = masses(&[([0.0, 0.0, 0.1], m), ([0.0, 0.0, -1.0], 0.0)]);
        let mut definition = definition(&[0], floor(1), Arc::new(Linear { slope: 1.0, clearance: 0.0 }));
        // Hard contact has 0.1 m/Δt² of the largest increment.
        let most = (0.1 * m / k).sqrt();
        definition.behaviour = Behaviour { separation: Separation::Never, ..free(normal) };
        let held: Vec<(u32, usize)> = (0..6).map(|c| (1, c)).collect();
        let mut scene = Scene::within(&structure, definition, (&held, &[(0, 2, -v)]), most);
        let (z, omega) = (scene.at(0, 2), (k / m).sqrt());
        for step in 1..=20_000 {
            scene.advance(dt);
            let time = f64::from(step) * dt - 0.1 / v;
            if time > 0.0 {
                let exact = -0.1 - v / omega * (omega * time).sin();
                // Touching is found within an increment; what is missed of the force then is below ω²vΔt²/2, and the period
                // is off by (ωΔt)²/24.
                let bound = v * dt * (omega * dt) * (1.0 + omega * time);
                assert!((scene.state.u[z] - exact).abs() < bound, "{} {exact} {time}", scene.state.u[z]);
            }
        }
        assert_eq!(scene.pair.state().points[0].status, ContactStatus::Closed);
    }
}

/// What was never closed may be open: nothing pulls.
#[test]
fn no_separation_begins_with_touching() {
    let structure = masses(&[([0.0, 0.0, 1e-3], 1.0), ([0.0, 0.0, -1.0], 0.0)]);
    let mut definition = definition(&[0], floor(1), Arc::new(Linear { slope: 4.0, clearance: 0.0 }));
    definition.behaviour.separation = Separation::Never;
    let mut scene = Scene::new(&structure, definition, &[1], &[(0, 2, 1.0)]);
    (0..100).for_each(|_| scene.advance(1e-3));
    assert_eq!(scene.state.v[scene.at(0, 2)], 1.0);
}

/// The springs of hard contact are 0.1 m/Δt² of the step that begins, but for increments that are nearly the same; where the
/// secondary node has no mass, m is that of what it meets.
#[test]
fn penalties_follow_the_increments() {
    let structure = masses(&[([0.0, 0.0, 0.1], 2.0), ([0.0, 0.0, -1.0], 0.0)]);
    let law = Arc::new(Linear { slope: 1.0, clearance: 0.0 });
    let hard = Definition { behaviour: free(Normal::Hard), ..definition(&[0], floor(1), law.clone()) };
    let held: Vec<(u32, usize)> = (0..6).map(|c| (1, c)).collect();
    let mut scene = Scene::within(&structure, hard, (&held, &[]), 1.0);
    let hold = |f: usize| Support { freedom: f, kind: Prescribed::Displacement, course: Ramp::constant(0.0) };
    for (most, made_for) in [(1.0f64, 1.0f64), (1.05, 1.0), (2.0, 2.0), (0.5, 0.5)] {
        let supports = held.iter().map(|&(n, c)| hold(scene.at(n, c))).collect();
        let terms: &mut [&mut dyn ExplicitTerm] = &mut [&mut scene.lines, &mut scene.pair];
        CentralDifference::new(terms, supports, (1e9, most), &mut scene.state).unwrap();
        let penalty = scene.pair.points[0].penalty;
        assert!((penalty - 0.1 * 2.0 / made_for.powi(2)).abs() < 1e-15, "{most} {penalty}");
    }
    let corners = [([0.0, 0.0, 0.0], 3.0), ([1.0, 0.0, 0.0], 3.0), ([0.0, 1.0, 0.0], 3.0), ([0.2, 0.2, 0.1], 0.0)];
    let faces = MainSurface::Faces(vec![vec![0, 1, 2]]);
    let hard = Definition { behaviour: free(Normal::Hard), ..definition(&[3], faces, law) };
    let held: Vec<(u32, usize)> = (0..6).map(|c| (3, c)).collect();
    let scene = Scene::within(&masses(&corners), hard, (&held, &[]), 1.0);
    assert!((scene.pair.points[0].penalty - 0.3).abs() < 1e-15);
}

/// A block that sticks on springs of a given slope and is pushed swings about F/K, and damping along the surface stills it:
/// 1 − x K/F falls by exp(−ξωt).
#[test]
fn a_sticking_block_swings_and_comes_to_rest() {
    let (m, weight, push, slope, dt) = (2.0, 30.0, 3.0, 800.0, 1e-4);
    for fraction in [0.0, 0.5] {
        let structure = masses(&[([0.0, 0.0, -3e-4], m), ([0.0, 0.0, -1.0], 0.0)]);
        let mut definition = definition(&[0], floor(1), Arc::new(Linear { slope: 1e5, clearance: 0.0 }));
        let limit = Some((Coefficient::Constant(0.5), None));
        definition.behaviour.friction = Some(Coulomb { limit, spring: Spring::Stiffness(1e6) });
        definition.behaviour.shear_slope = Some(slope);
        let amount = DampingAmount::CriticalFraction(0.1);
        definition.behaviour.damping = Some(ExplicitDamping { amount, tangent_fraction: fraction });
        let mut scene = Scene::new(&structure, definition, &[1], &[]);
        let (x, z) = (scene.at(0, 0), scene.at(0, 2));
        let (omega, xi) = ((slope / m).sqrt(), 0.1 * fraction);
        let swing = omega * (1.0f64 - xi * xi).sqrt();
        for step in 0..20_000 {
            let time = f64::from(step) * dt;
            let fall = (-xi * omega * time).exp();
            let exact =
                push / slope * (1.0 - fall * ((swing * time).cos() + xi * omega / swing * (swing * time).sin()));
            // Central differences: (ωΔt)²/24 of the period. Damping is that of half an increment before, which counts like a
            // mass of −ξωΔt and lets the phase run ahead by half of that.
            let phase = omega * time * omega * dt;
            let bound = push / slope * (omega * dt * (0.01 + phase) + xi * omega * dt + xi * phase * fall);
            assert!((scene.state.u[x] - exact).abs() <= bound, "{step} {} {exact}", scene.state.u[x]);
            scene.state.force[z] -= weight;
            scene.state.force[x] += push;
            scene.advance(dt);
        }
        assert!(scene.pair.rubbed().abs() < 1e-14, "{}", scene.pair.rubbed());
    }
}
