//! Pairs of explicit steps: impacts with closed solutions, conservation, friction.

use super::*;
use crate::facet::Vec3;
use crate::friction::{Coefficient, Coulomb, Spring};
use crate::law::NormalLaw;
use crate::law::exponential::Exponential;
use crate::law::linear::Linear;
use crate::point::ContactStatus;
use crate::rigid::{Piece, RigidSurface, Sweep};
use crate::summary::MeasureKind;
use crate::viscous::{DampingAmount, ExplicitDamping};
use fe_core::Freedoms;
use fe_core::element::ElementType::MASS;
use fe_core::explicit::ExplicitTerm;
use fe_core::explicit::central_difference::{CentralDifference, State, Support};
use fe_core::explicit::line::Lines;
use fe_core::load::Prescribed;
use fe_core::ramp::Ramp;
use fe_core::structure::{Discrete, Structure};
use fe_mesh::{CellBlock, CellId};
use std::sync::Arc;

mod balanced;
mod bodies;
mod bonded;
mod border;
mod foresight;
mod general;
mod impacts;
mod kinematic;
mod rigid;
mod sliding;
mod soundness;

/// Points with a mass each; further points without one.
fn masses(points: &[([f64; 3], f64)]) -> Structure {
    let mut structure = Structure::default();
    structure.mesh.points = points.iter().map(|p| p.0).collect();
    structure.mesh.point_labels = (1..=points.len() as u64).collect();
    let with: Vec<u32> = (0..points.len() as u32).filter(|&i| points[i as usize].1 > 0.0).collect();
    let labels = (1..=with.len() as u64).collect();
    structure.mesh.blocks.push(CellBlock { nodes: with.clone(), labels, ..CellBlock::new(MASS.kind()) });
    structure.elements.push(MASS);
    structure.discrete = with
        .iter()
        .enumerate()
        .map(|(cell, &node)| Discrete {
            element: MASS,
            cells: vec![CellId { block: 0, cell: cell as u32 }],
            magnitude: points[node as usize].1,
            components: [0, 0],
        })
        .collect();
    structure
}

fn floor(reference: u32) -> MainSurface {
    let surface = RigidSurface {
        name: "R".into(),
        sweep: Sweep::Cylinder { origin: [0.0; 3], x: [1.0, 0.0, 0.0], y: [0.0, 0.0, 1.0] },
        start: [-10.0, 0.0],
        pieces: vec![Piece::Line { to: [10.0, 0.0] }],
    };
    MainSurface::Rigid { surface, reference }
}

/// Surfaces that part and slide freely.
fn free(normal: Normal) -> Behaviour {
    Behaviour { normal, separation: Separation::Allowed, friction: None, shear_slope: None, damping: None }
}

fn definition(nodes: &[u32], main: MainSurface, law: Arc<dyn NormalLaw>) -> Definition {
    Definition {
        name: "S on M".into(),
        secondary: Secondary { nodes: nodes.iter().map(|&n| (n, 1.0)).collect(), kind: MeasureKind::Force },
        main,
        behaviour: free(Normal::Softened(law)),
        enforcement: Enforcement::Penalty(1.0),
    }
}

/// A node, a component and its velocity.
type Velocity = (u32, usize, f64);

struct Scene {
    freedoms: Freedoms,
    lines: Lines,
    pair: ContactPair,
    state: State,
    procedure: CentralDifference,
}

impl Scene {
    fn new(structure: &Structure, definition: Definition, held: &[u32], v: &[Velocity]) -> Self {
        let held: Vec<(u32, usize)> = held.iter().flat_map(|&n| (0..6).map(move |c| (n, c))).collect();
        Scene::held(structure, definition, &held, v)
    }

    /// Nodes with held components are reference nodes.
    fn held(structure: &Structure, definition: Definition, held: &[(u32, usize)], v: &[Velocity]) -> Self {
        Scene::within(structure, definition, (held, v), f64::INFINITY)
    }

    /// With increments of at most `most`.
    fn within(
        structure: &Structure,
        definition: Definition,
        (held, v): (&[(u32, usize)], &[Velocity]),
        most: f64,
    ) -> Self {
        let mut references: Vec<u32> = held.iter().map(|h| h.0).collect();
        references.dedup();
        let freedoms = structure.freedoms(&references);
        let mut state = State::rest(&freedoms);
        v.iter().for_each(|&(n, c, value)| state.v[freedoms.index(n as usize, c).unwrap()] = value);
        let mut lines = Lines::new(structure, &freedoms, 0.0);
        let mut pair = ContactPair::new(structure, &freedoms, definition, &[]);
        let hold = |freedom| Support { freedom, kind: Prescribed::Displacement, course: Ramp::constant(0.0) };
        let supports = held.iter().filter_map(|&(n, c)| freedoms.index(n as usize, c)).map(hold).collect();
        let terms: &mut [&mut dyn ExplicitTerm] = &mut [&mut lines, &mut pair];
        let procedure = CentralDifference::new(terms, supports, (1e9, most), &mut state).unwrap();
        Scene { freedoms, lines, pair, state, procedure }
    }

    fn advance(&mut self, dt: f64) {
        self.procedure.advance(&mut [&mut self.lines, &mut self.pair], &mut self.state, dt).unwrap();
    }

    fn at(&self, node: u32, component: usize) -> usize {
        self.freedoms.index(node as usize, component).unwrap()
    }
}

/// A mass on a law: LINEAR takes π√(m/K) and reaches v√(Km); EXPONENTIAL from the clearance c₀ on, by numbers.
#[test]
fn b04_mass_on_law() {
    let (m, v) = (1e-3, 2000.0);
    let laws: [(Arc<dyn NormalLaw>, f64, [f64; 3]); 2] = [
        (Arc::new(Linear { slope: 1e5, clearance: 0.0 }), 0.0, [20000.0, 0.2, 3.14159265359e-4]),
        (Arc::new(Exponential::new(0.05, 200.0)), 0.05, [52029.0132087, 0.179454769398, 2.80929122486e-4]),
    ];
    for (law, clearance, [force, depth, time]) in laws {
        let structure = masses(&[([0.3, 0.0, clearance], m), ([0.0, 0.0, -1.0], 0.0)]);
        let mut scene = Scene::new(&structure, definition(&[0], floor(1), law), &[1], &[(0, 2, -v)]);
        let (z, steps) = (scene.at(0, 2), 4000);
        let dt = time / steps as f64;
        let (mut most, mut deepest) = (0.0f64, 0.0f64);
        for _ in 0..steps + 20 {
            scene.advance(dt);
            most = most.max(scene.state.force[z]);
            deepest = deepest.max(-(scene.state.u[z] + clearance));
        }
        // Central differences: (ωΔt)²/24 with ωΔt = π/4000, and at the turn as much again between two increments.
        let bound = (std::f64::consts::PI / steps as f64).powi(2);
        assert!((most / force - 1.0).abs() < bound && (deepest / depth - 1.0).abs() < bound, "{most} {deepest}");
        // A switch inside an increment costs up to (ωΔt)²/4 of the energy; EXPONENTIAL starts without slope.
        assert!((scene.state.v[z] / v - 1.0).abs() < bound, "{}", scene.state.v[z]);
    }
}

/// A point hits a free triangle off its middle: momentum and moment of momentum stay, action is reaction, and the energy
/// comes back.
#[test]
fn free_bodies_keep_their_momentum() {
    let corners = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.1], [0.2, 1.1, 0.0]];
    let mut points: Vec<([f64; 3], f64)> = corners.iter().zip([2.0, 3.0, 4.0]).map(|(x, m)| (*x, m)).collect();
    points.push(([0.35, 0.3, 0.2], 1.5));
    let structure = masses(&points);
    let law = Arc::new(Linear { slope: 1e4, clearance: 0.0 });
    let definition = definition(&[3], MainSurface::Faces(vec![vec![0, 1, 2]]), law);
    let mut scene = Scene::new(&structure, definition, &[], &[(3, 2, -10.0), (3, 0, 1.0)]);
    let moments = |scene: &Scene| {
        let (mut p, mut h, mut e) = (Vec3::zeros(), Vec3::zeros(), 0.0);
        for (n, (x, m)) in points.iter().enumerate() {
            let at = |v: &[f64]| Vec3::from_fn(|c, _| v[scene.at(n as u32, c)]);
            let (x, v) = (Vec3::from(*x) + at(&scene.state.u), at(&scene.state.v));
            p += v * *m;
            h += x.cross(&v) * *m;
            e += 0.5 * m * v.norm_squared();
        }
        (p, h, e)
    };
    let before = moments(&scene);
    (0..2000).for_each(|_| scene.advance(1e-4));
    let after = moments(&scene);
    assert!(scene.state.v[scene.at(3, 2)] > 0.0);
    assert!((before.0 - after.0).norm() < 1e-12 * before.0.norm());
    // The force acts along the normal at the foot: no moment is made. Lever arms change by v Δt within an increment.
    assert!((before.1 - after.1).norm() < 1e-10 * before.1.norm(), "{} {}", before.1, after.1);
    // (ωΔt)²/4 with ω² = k (1/m + Σ N²/m).
    assert!((after.2 / before.2 - 1.0).abs() < 1e-4, "{}", after.2 / before.2);
}

/// A block pressed on a floor and pushed: it sticks below μ N and slides with the rest above; the heat is μ N times the way.
#[test]
fn friction_holds_or_slides() {
    let (m, weight, mu) = (2.0, 30.0, 0.25);
    for push in [3.0, 12.0] {
        let structure = masses(&[([0.0, 0.0, -3e-4], m), ([0.0, 0.0, -1.0], 0.0)]);
        // At rest on the law, K h = N.
        let law = Arc::new(Linear { slope: 1e5, clearance: 0.0 });
        let limit = Some((Coefficient::Constant(mu), None));
        let friction = Some(Coulomb { limit, spring: Spring::Stiffness(1e6) });
        let mut definition = definition(&[0], floor(1), law);
        definition.behaviour.friction = friction;
        let mut scene = Scene::new(&structure, definition, &[1], &[]);
        let (x, z) = (scene.at(0, 0), scene.at(0, 2));
        let dt = 1e-5;
        for _ in 0..20_000 {
            scene.state.force[z] -= weight;
            scene.state.force[x] += push;
            scene.advance(dt);
        }
        let time: f64 = 20_000.0 * dt;
        if push < mu * weight {
            // It swings about push/k_t by as much, without damping: 2 push is still less than μ N.
            assert!(scene.state.u[x].abs() < 2.1 * push / 1e6 && scene.pair.rubbed() < 1e-12, "{}", scene.state.u[x]);
        } else {
            // First on the spring, x = F/k (1 − cos ωt), until that has μ N; then at a constant rate.
            let (omega, limit) = ((1e6f64 / m).sqrt(), mu * weight);
            let angle = (1.0 - limit / push).acos();
            let (left, speed) = (time - angle / omega, push / 1e6 * omega * angle.sin());
            let way = limit / 1e6 + speed * left + 0.5 * (push - limit) / m * left * left;
            // The change of regime falls within an increment: a force of μ N over Δt.
            let bound = limit / m * dt * left;
            assert!((scene.state.u[x] - way).abs() < bound, "{} {way}", scene.state.u[x]);
            let heat = limit * (scene.state.u[x] - limit / 1e6);
            assert!((scene.pair.rubbed() - heat).abs() < limit * bound, "{} {heat}", scene.pair.rubbed());
        }
    }
}

/// B10: a mass on spring and dashpot that never pulls: released at zero force.
#[test]
fn b10_damped_contact_without_tension() {
    for (zeta, expected) in [(0.05, 0.858758101775), (0.2, 0.571740027585)] {
        let (m, k, v) = (1.0, 1.0, 1.0);
        let structure = masses(&[([0.0; 3], m), ([0.0, 0.0, -1.0], 0.0)]);
        let law = Arc::new(Linear { slope: k, clearance: 0.0 });
        let damping = Some(ExplicitDamping { amount: DampingAmount::CriticalFraction(zeta), tangent_fraction: 1.0 });
        let mut definition = definition(&[0], floor(1), law);
        definition.behaviour.damping = damping;
        let mut scene = Scene::new(&structure, definition, &[1], &[(0, 2, -v)]);
        let (z, dt) = (scene.at(0, 2), 1e-4);
        (0..50_000).for_each(|_| scene.advance(dt));
        // The damping force is that of half an increment before: ζ ωΔt; and touching is found within an increment, in which
        // the dashpot starts with 2ζ k v/ω at once.
        assert!((scene.state.v[z] - expected).abs() < 4.0 * zeta * dt + 1e-6, "{} {expected}", scene.state.v[z]);
    }
}
