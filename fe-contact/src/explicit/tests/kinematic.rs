//! Kinematic contact: plastic impact of single masses, bars on a wall and on each other, softened laws, friction, momentum.

use super::*;
use fe_core::element::ElementType::T3D2;
use fe_core::section::{LineSection, Profile};
use std::f64::consts::PI;

/// Bars of trusses of length 1 along z, E = ρ = A = 1, so c = 1; each given by its nodes; further points belong to none.
pub fn bars(points: Vec<[f64; 3]>, bars: &[Vec<u32>]) -> Structure {
    let mut structure = Structure::default();
    structure.mesh.point_labels = (1..=points.len() as u64).collect();
    structure.mesh.points = points;
    let nodes: Vec<u32> = bars.iter().flat_map(|bar| bar.windows(2)).flatten().copied().collect();
    let labels = (1..=nodes.len() as u64 / 2).collect();
    structure.mesh.blocks.push(CellBlock { nodes, labels, ..CellBlock::new(T3D2.kind()) });
    structure.elements.push(T3D2);
    structure.lines = vec![LineSection {
        element: T3D2,
        cells: structure.mesh.cells().collect(),
        name: "M".into(),
        young: 1.0,
        shear: 0.0,
        density: Some(1.0),
        profile: Profile::bar(1.0),
        first_axis: [0.0; 3],
        damping: Default::default(),
    }];
    structure
}

/// Small against 1, so that bars are linear.
pub const SPEED: f64 = 1e-7;

/// A bar of n trusses about to touch the wall, and its reference node.
fn bar_on_wall(n: u32) -> Scene {
    let mut points: Vec<[f64; 3]> = (0..=n).map(|i| [0.0, 0.0, i.into()]).collect();
    points.push([0.0, 0.0, -1.0]);
    let structure = bars(points, &[(0..=n).collect()]);
    let v: Vec<_> = (0..=n).map(|i| (i, 2, -SPEED)).collect();
    Scene::new(&structure, hard(&[0], floor(n + 1), Enforcement::Kinematic(1.0)), &[n + 1], &v)
}

pub(super) fn hard(nodes: &[u32], main: MainSurface, enforcement: Enforcement) -> Definition {
    let law = Arc::new(Linear { slope: 1.0, clearance: 0.0 });
    let behaviour = free(Normal::Hard);
    Definition { behaviour, enforcement, ..definition(nodes, main, law) }
}

fn energy(scene: &Scene) -> f64 {
    scene.procedure.conserved(&scene.state) + scene.lines.stored()
}

/// Masses 2 and 3 at 10 and −5 go on with 1; what is lost is the pair's.
#[test]
fn b12_plastic_impact() {
    let structure = masses(&[([0.2, 0.0, 0.02], 2.0), ([0.2, 0.0, -1.0], 3.0)]);
    let turns = [(1, 3), (1, 4), (1, 5)];
    let definition = hard(&[0], floor(1), Enforcement::Kinematic(1.0));
    let mut scene = Scene::held(&structure, definition, &turns, &[(0, 2, -10.0), (1, 2, 5.0)]);
    let before = energy(&scene);
    (0..50).for_each(|_| scene.advance(1e-3));
    for node in [0, 1] {
        assert!((scene.state.v[scene.at(node, 2)] + 1.0).abs() < 1e-12, "{:?}", scene.state.v);
    }
    assert!((scene.pair.stored() - 135.0).abs() < 1e-10, "{}", scene.pair.stored());
    assert!((before - energy(&scene) - 135.0).abs() < 1e-10);
}

/// The end node of a bar loses its energy, 1/(2n) of all, at the wall, and nothing else is lost; the balance stays closed.
#[test]
fn b12_loss_of_a_bar() {
    for n in [10, 40, 160] {
        let mut scene = bar_on_wall(n);
        let before = energy(&scene);
        for _ in 0..(2.6 * f64::from(n) / 0.5) as usize {
            scene.advance(0.5);
            let sum = energy(&scene) + scene.pair.stored();
            // Rounding of lengths of 1, over the strain.
            assert!((sum / before - 1.0).abs() < 1e-8, "{n} {sum} {before}");
        }
        assert_eq!(scene.pair.state().points[0].status, ContactStatus::Open);
        // The bar is linear to the strain, 1e-7.
        let (left, expected) = (energy(&scene) / before, 1.0 - 0.5 / f64::from(n));
        assert!((left - expected).abs() < 1e-6, "{n} {left} {expected}");
        assert!((scene.pair.stored() / before - 0.5 / f64::from(n)).abs() < 1e-6);
    }
}

/// Δt = h/c: every node is where the exact wave has it, to the way of one increment; the wall holds ρcv A for 2L/c.
#[test]
fn b01_bar_on_wall() {
    let n = 50;
    let mut scene = bar_on_wall(n);
    let (reference, mut impulse) = (scene.at(n + 1, 2), 0.0);
    for step in 1..=(2.6 * f64::from(n)) as u32 {
        scene.advance(1.0);
        let time = f64::from(step);
        for i in 0..=n {
            // Stops at X/c, leaves at (2L − X)/c.
            let (stops, leaves) = (f64::from(i), f64::from(2 * n - i));
            let exact = SPEED * ((time - leaves).max(0.0) - time.min(stops));
            let u = scene.state.u[scene.at(i, 2)];
            // And the change of the stiffness, 1e-7, over so many increments.
            assert!((u - exact).abs() < SPEED * (1.0 + 1e-3), "{step} {i} {u} {exact}");
        }
        // At the start of the increment the force stands for a half.
        let mean = if step == 1 { 0.5 } else { 1.0 };
        let force = -scene.state.force[reference];
        impulse += force * mean;
        if step > 1 && step < 2 * n {
            assert!((force / SPEED - 1.0).abs() < 1e-4, "{step} {force}");
        }
    }
    // 2 m v; the nodes' velocities are those of the wave within one increment.
    let expected = 2.0 * f64::from(n) * SPEED;
    assert!((impulse / expected - 1.0).abs() < 1.0 / f64::from(n), "{impulse} {expected}");
}

/// The striker stops and the struck bar leaves with its velocity, to 1/n; momentum stays.
#[test]
fn b02_two_bars() {
    let n = 40u32;
    for enforcement in [Enforcement::Kinematic(1.0), Enforcement::Penalty(1.0)] {
        let up = (0..=n).map(|i| [0.0, 0.0, i.into()]);
        let down = (0..=n).map(|i| [0.0, 0.0, -f64::from(i)]);
        let structure = bars(up.chain(down).collect(), &[(0..=n).collect(), (n + 1..=2 * n + 1).collect()]);
        let v: Vec<_> = (0..=n).map(|i| (i, 2, -SPEED)).collect();
        // The surface moves with the end of the struck bar.
        let turns = [(n + 1, 3), (n + 1, 4), (n + 1, 5)];
        let mut scene = Scene::held(&structure, hard(&[0], floor(n + 1), enforcement), &turns, &v);
        let before = energy(&scene);
        (0..(2.6 * f64::from(n) / 0.5) as usize).for_each(|_| scene.advance(0.5));
        let mean = |scene: &Scene, first: u32| {
            let of = |i: u32| scene.state.v[scene.at(first + i, 2)] * if i == 0 || i == n { 0.5 } else { 1.0 };
            (0..=n).map(of).sum::<f64>() / f64::from(n) / -SPEED
        };
        let (striker, struck) = (mean(&scene, 0), mean(&scene, n + 1));
        assert!((striker + struck - 1.0).abs() < 1e-12, "{striker} {struck}");
        assert!(striker.abs() < 1.0 / f64::from(n), "{enforcement:?} {striker}");
        assert!(((energy(&scene) + scene.pair.stored()) / before - 1.0).abs() < 1e-8, "{enforcement:?}");
    }
}

/// B04 by impulses: p at the corrected gap is backward Euler, whose amplitude falls by √(1 + (ωΔt)²) an increment.
#[test]
fn b04_mass_on_law() {
    let (m, v, k, steps) = (1e-3, 2000.0, 1e5, 4000);
    let structure = masses(&[([0.3, 0.0, 0.0], m), ([0.0, 0.0, -1.0], 0.0)]);
    let law = Arc::new(Linear { slope: k, clearance: 0.0 });
    let definition = Definition { enforcement: Enforcement::Kinematic(1.0), ..definition(&[0], floor(1), law) };
    let mut scene = Scene::new(&structure, definition, &[1], &[(0, 2, -v)]);
    let (z, reference, angle) = (scene.at(0, 2), scene.at(1, 2), PI / steps as f64);
    let dt = angle * (m / k).sqrt();
    let before = energy(&scene);
    let mut most = 0.0f64;
    for _ in 0..steps + 20 {
        scene.advance(dt);
        most = most.max(-scene.state.force[reference]);
        assert!(((energy(&scene) + scene.pair.stored()) / before - 1.0).abs() < 1e-9);
    }
    // The start, half an increment late, and the end, found within one: (ωΔt)² each; the turn comes after half of them.
    let bound = 4.0 * angle * angle;
    let fall = |increments: f64| (1.0 + angle * angle).powf(-0.5 * increments);
    assert!((scene.state.v[z] / v / fall(steps as f64) - 1.0).abs() < bound, "{}", scene.state.v[z]);
    // The first increment is of mean Δt/2.
    assert!((most / (v * (k * m).sqrt()) / fall(0.5 * steps as f64) - 1.0).abs() < 0.6 * angle, "{most}");
}

/// Mass, weight and friction of a block on the floor.
const BLOCK: (f64, f64, f64) = (2.0, 30.0, 0.25);

/// The block, node 0 on a floor with reference node 1, after so many increments of length dt with a push along x.
fn pushed(push: f64, (dt, steps): (f64, usize), shear_slope: Option<f64>) -> Scene {
    let (m, weight, mu) = BLOCK;
    let structure = masses(&[([0.0; 3], m), ([0.0, 0.0, -1.0], 0.0)]);
    let mut definition = hard(&[0], floor(1), Enforcement::Kinematic(1.0));
    let limit = Some((Coefficient::Constant(mu), None));
    definition.behaviour.friction = Some(Coulomb { limit, spring: Spring::Stiffness(1.0) });
    definition.behaviour.shear_slope = shear_slope;
    let mut scene = Scene::new(&structure, definition, &[1], &[]);
    let (x, z) = (scene.at(0, 0), scene.at(0, 2));
    for _ in 0..steps {
        scene.state.force[x] += push;
        scene.state.force[z] -= weight;
        scene.advance(dt);
    }
    scene
}

/// A block under its weight is held at once, without a spring, below μ N, and slides with the rest above.
#[test]
fn friction_holds_or_slides() {
    let ((m, weight, mu), dt, steps) = (BLOCK, 1e-3, 1000);
    for push in [3.0, 12.0] {
        let scene = pushed(push, (dt, steps), None);
        let (x, z) = (scene.at(0, 0), scene.at(0, 2));
        let limit = mu * weight;
        let rest = (push - limit).max(0.0) / m;
        // u(n) = a Δt² n²/2 with a first half step.
        let way = 0.5 * rest * (dt * steps as f64).powi(2);
        assert!((scene.state.u[x] - way).abs() < 1e-10 * (1.0 + way), "{} {way}", scene.state.u[x]);
        assert!(scene.state.u[z].abs() < 1e-12);
        assert!((scene.pair.rubbed() - if rest > 0.0 { limit * way } else { 0.0 }).abs() < 1e-9 * (1.0 + way));
        assert!((scene.state.force[scene.at(1, 2)] + weight).abs() < 1e-9);
        assert!((scene.state.force[scene.at(1, 0)] - push.min(limit)).abs() < 1e-9);
    }
}

/// Points hit a free triangle off its middle: they are on it together, momentum and moment of momentum stay.
#[test]
fn free_bodies_keep_their_momentum() {
    let corners = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.1], [0.2, 1.1, 0.0]];
    let mut points: Vec<([f64; 3], f64)> = corners.iter().zip([2.0, 3.0, 4.0]).map(|(x, m)| (*x, m)).collect();
    points.extend([([0.35, 0.3, 0.06], 1.5), ([0.5, 0.4, 0.07], 20.0)]);
    let structure = masses(&points);
    let definition = hard(&[3, 4], MainSurface::Faces(vec![vec![0, 1, 2]]), Enforcement::Kinematic(1.0));
    let mut scene = Scene::new(&structure, definition, &[], &[(3, 2, -10.0), (3, 0, 1.0), (4, 2, -12.0)]);
    let moments = |scene: &Scene| {
        let (mut p, mut h) = (Vec3::zeros(), Vec3::zeros());
        for (n, (x, m)) in points.iter().enumerate() {
            let at = |v: &[f64]| Vec3::from_fn(|c, _| v[scene.at(n as u32, c)]);
            p += at(&scene.state.v) * *m;
            h += (Vec3::from(*x) + at(&scene.state.u)).cross(&at(&scene.state.v)) * *m;
        }
        (p, h)
    };
    let (before, energy_before) = (moments(&scene), energy(&scene));
    let mut closed = 0;
    for _ in 0..200 {
        scene.advance(1e-4);
        let gaps: Vec<f64> = scene.pair.state().points.iter().map(|p| p.opening).collect();
        closed += scene.pair.state().points.iter().filter(|p| p.status == ContactStatus::Closed).count();
        assert!(gaps.iter().all(|gap| *gap > -1e-12), "{gaps:?}");
    }
    assert!(closed > 2);
    let after = moments(&scene);
    assert!((before.0 - after.0).norm() < 1e-12 * before.0.norm());
    // Impulses act at the end of an increment, where points have slid on by 1 Δt.
    assert!((before.1 - after.1).norm() < 1e-4 * before.0.norm(), "{} {}", before.1, after.1);
    assert!(scene.pair.stored() > 0.0);
    assert!(((energy(&scene) + scene.pair.stored()) / energy_before - 1.0).abs() < 1e-12);
}

/// B10: damping that never pulls, at the corrected end of the increment.
#[test]
fn b10_damped_contact_without_tension() {
    for (zeta, expected) in [(0.05, 0.858758101775), (0.2, 0.571740027585)] {
        let structure = masses(&[([0.0; 3], 1.0), ([0.0, 0.0, -1.0], 0.0)]);
        let law = Arc::new(Linear { slope: 1.0, clearance: 0.0 });
        let mut definition = Definition { enforcement: Enforcement::Kinematic(1.0), ..definition(&[0], floor(1), law) };
        let amount = DampingAmount::CriticalFraction(zeta);
        definition.behaviour.damping = Some(ExplicitDamping { amount, tangent_fraction: 1.0 });
        let mut scene = Scene::new(&structure, definition, &[1], &[(0, 2, -1.0)]);
        let (z, dt) = (scene.at(0, 2), 1e-4);
        let before = energy(&scene);
        (0..50_000).for_each(|_| scene.advance(dt));
        // Backward Euler takes ½ωΔt of critical besides, over half a period; and the dashpot starts within an increment.
        let bound = (0.5 * PI + 4.0 * zeta) * dt;
        assert!((scene.state.v[z] - expected).abs() < bound, "{} {expected}", scene.state.v[z]);
        assert!(((energy(&scene) + scene.pair.stored()) / before - 1.0).abs() < 1e-9);
    }
}

/// A ball that may not leave is held at the surface against a pull, by its force; on a law it swings, and comes to rest where
/// the law pulls as much.
#[test]
fn no_separation_holds() {
    let (m, v, pull, slope) = (2.0, 1.0, 5.0, 400.0);
    let law: Arc<dyn NormalLaw> = Arc::new(Linear { slope, clearance: 0.0 });
    for (normal, rest) in [(Normal::Hard, 0.0), (Normal::Softened(law), pull / slope)] {
        let structure = masses(&[([0.0, 0.0, 0.05], m), ([0.0, 0.0, -1.0], 0.0)]);
        let mut definition = hard(&[0], floor(1), Enforcement::Kinematic(1.0));
        definition.behaviour = Behaviour { separation: Separation::Never, ..free(normal) };
        let mut scene = Scene::new(&structure, definition, &[1], &[(0, 2, -v)]);
        let (z, reference) = (scene.at(0, 2), scene.at(1, 2));
        for step in 0..4000 {
            if step > 100 {
                scene.state.force[z] += pull;
            }
            scene.advance(1e-2);
        }
        // Backward Euler stills the swing by √(1 + (ωΔt)²) an increment, (1 + 0.02)^−2000.
        assert!((scene.state.u[z] + 0.05 - rest).abs() < 1e-12, "{}", scene.state.u[z]);
        assert!((scene.state.force[reference] - pull).abs() < 1e-10);
        let state = scene.pair.state().points[0];
        assert!((state.pressure + pull).abs() < 1e-10 && state.status == ContactStatus::Closed);
    }
}

/// The block on springs of a given slope comes to rest at F/K, slipping where that is more than μ N.
#[test]
fn friction_on_springs() {
    let ((_, weight, mu), slope) = (BLOCK, 800.0);
    for (push, steps) in [(3.0, 2000), (12.0, 200)] {
        let scene = pushed(push, (1e-2, steps), Some(slope));
        let (way, limit) = (scene.state.u[scene.at(0, 0)], mu * weight);
        let shear = scene.state.force[scene.at(1, 0)];
        if push < limit {
            assert!((way - push / slope).abs() < 1e-12 && (shear - push).abs() < 1e-10);
            assert!(scene.pair.rubbed().abs() < 1e-12);
        } else {
            assert!((shear - limit).abs() < 1e-10);
            let heat = limit * (way - limit / slope);
            // The increment in which it begins to slip.
            assert!((scene.pair.rubbed() / heat - 1.0).abs() < 1e-5, "{} {heat}", scene.pair.rubbed());
        }
    }
}
