//! A34: a block that slides until it stops, and friction that decays with the slip rate.

use super::*;

/// Blocks on a long floor, by kinematic contact and by penalty, already pressed into it by their weight.
fn blocks(mu: Coefficient, v: f64, dt: f64) -> Vec<Scene> {
    let surface = RigidSurface {
        name: "R".into(),
        sweep: Sweep::Cylinder { origin: [0.0; 3], x: [1.0, 0.0, 0.0], y: [0.0, 0.0, 1.0] },
        start: [-1e3, 0.0],
        pieces: vec![Piece::Line { to: [1e3, 0.0] }],
    };
    let block = |enforcement| {
        let depth = if enforcement == Enforcement::Kinematic(1.0) { 0.0 } else { GRAVITY * dt * dt / 0.1 };
        let structure = masses(&[([0.0, 0.0, -depth], MASS_OF_BLOCK), ([0.0, 0.0, -1.0], 0.0)]);
        let main = MainSurface::Rigid { surface: surface.clone(), reference: 1 };
        let mut definition = super::kinematic::hard(&[0], main, enforcement);
        definition.behaviour.friction =
            Some(Coulomb { limit: Some((mu.clone(), None)), spring: Spring::Stiffness(1.0) });
        definition.behaviour.damping = Some(ExplicitDamping::default());
        let held: Vec<(u32, usize)> = (0..6).map(|c| (1, c)).collect();
        Scene::within(&structure, definition, (&held, &[(0, 0, v)]), dt)
    };
    [Enforcement::Kinematic(1.0), Enforcement::Penalty(1.0)].map(block).into()
}

const GRAVITY: f64 = 9810.0;
const MASS_OF_BLOCK: f64 = 2.0;

/// (b): it stops after v/μg, v²/2μg far, within an increment, and stays.
#[test]
fn a34_sliding_block() {
    let (v, dt) = (1000.0, 1e-4);
    let (way, time) = (203.873598369, 0.407747196738);
    for mut scene in blocks(Coefficient::Constant(0.25), v, dt) {
        let name = format!("{:?}", scene.pair.definition.enforcement);
        let (x, z) = (scene.at(0, 0), scene.at(0, 2));
        let mut stopped = None;
        let mut farthest = 0.0f64;
        for step in 0..20_000 {
            scene.state.force[z] -= MASS_OF_BLOCK * GRAVITY;
            scene.advance(dt);
            farthest = farthest.max(scene.state.u[x]);
            let slips = scene.pair.state().points[0].status == ContactStatus::Slipping;
            if !slips && stopped.is_none() && step > 10 {
                stopped = Some(f64::from(step) * dt);
            }
            if let (Some(_), true) = (stopped, slips) {
                panic!("{name} slips again");
            }
        }
        assert!((stopped.unwrap() - time).abs() <= 2.0 * dt, "{name} {stopped:?}");
        // The velocity of half an increment; springs that stick are stretched by μ m g/k = μ g Δt²/0.1, and swing about that.
        assert!((scene.state.u[x] - way).abs() < 0.5 * v * dt, "{name} {}", scene.state.u[x]);
        assert!(farthest - scene.state.u[x] <= 2.0 * 0.25 * GRAVITY * dt * dt / 0.1, "{name} {farthest}");
        assert!(scene.state.v[x].abs() < 1e-9 * v, "{name} {}", scene.state.v[x]);
        let heat = scene.pair.rubbed() / (0.5 * MASS_OF_BLOCK * v * v);
        assert!((heat - 1.0).abs() < 2.0 * 0.25 * GRAVITY * dt / v, "{name} {heat}");
    }
}

/// (c): μ = 0.2 + 0.2/e at 100.
#[test]
fn a34_decaying_friction() {
    let (v, dt, steps) = (100.0, 1e-6, 40);
    let coefficient = Coefficient::Decay { rest: 0.4, kinetic: 0.2, decay: 0.01 };
    for mut scene in blocks(coefficient, v, dt) {
        let z = scene.at(0, 2);
        for _ in 0..steps {
            scene.state.force[z] -= MASS_OF_BLOCK * GRAVITY;
            scene.advance(dt);
        }
        let state = scene.pair.state().points[0];
        let ratio = state.shear[0].hypot(state.shear[1]) / state.pressure;
        // It has slowed by μ g t: μ rises by d (μ − μ_k) of that.
        let bound = 0.01 * 0.0736 * 0.28 * GRAVITY * dt * f64::from(steps);
        assert!(ratio - 0.273575888234 > -1e-12 && ratio - 0.273575888234 < bound, "{ratio}");
    }
}
