//! Free rigid bodies: how they are pushed, and how their nodes follow.

use super::super::carriers::Carriers;
use super::*;
use fe_core::element::ElementType::{R3D4, ROTARYI};
use fe_core::structure::RotaryInertia;
use nalgebra::{Matrix3, Rotation3, Vector3};

/// A point of mass 1.5 above a square plate of rigid facets, whose middle has mass and rotary inertia; all free.
struct Impact {
    freedoms: Freedoms,
    structure: Structure,
    lines: Lines,
    pair: ContactPair,
    state: State,
    procedure: CentralDifference,
}

const POINT: f64 = 1.5;
const PLATE: f64 = 4.0;
const SPEED: f64 = 10.0;

fn tensor() -> RotaryInertia {
    let cells = vec![CellId { block: 1, cell: 0 }];
    RotaryInertia { cells, moments: [0.5, 0.7, 1.1], products: [0.1, -0.05, 0.08] }
}

/// Where the point stands above the middle [L].
const ARM: [f64; 2] = [0.3, -0.45];

impl Impact {
    fn new(law: Option<Arc<dyn NormalLaw>>, analytical: bool) -> Self {
        let mut points: Vec<([f64; 3], f64)> =
            [[-1.0, -1.0], [1.0, -1.0], [1.0, 1.0], [-1.0, 1.0]].map(|[x, y]| ([x, y, 0.0], 0.0)).to_vec();
        points.push(([ARM[0], ARM[1], 1e-3], POINT));
        points.push(([0.0; 3], PLATE));
        let mut structure = masses(&points);
        for (element, nodes) in [(ROTARYI, vec![5]), (R3D4, vec![0, 1, 2, 3])] {
            structure.mesh.blocks.push(CellBlock { nodes, labels: vec![1], ..CellBlock::new(element.kind()) });
            structure.elements.push(element);
        }
        structure.rotary = vec![tensor()];
        let main = if analytical { floor(5) } else { MainSurface::Faces(vec![vec![0, 1, 2, 3]]) };
        let definition = match law {
            Some(law) => definition(&[4], main, law),
            None => super::kinematic::hard(&[4], main, Enforcement::Kinematic(1.0)),
        };
        let freedoms = structure.freedoms(&[5]);
        // Nodes that follow have no freedoms of their own.
        let mut state = State::rest(&freedoms);
        state.v[freedoms.index(4, 2).unwrap()] = -SPEED;
        let mut lines = Lines::new(&structure, &freedoms, 0.0);
        let follower = RigidFollower { reference: 5, nodes: vec![0, 1, 2, 3] };
        let mut pair = ContactPair::new(&structure, &freedoms, definition, &[follower]);
        let terms: &mut [&mut dyn ExplicitTerm] = &mut [&mut lines, &mut pair];
        let procedure = CentralDifference::new(terms, Vec::new(), (1e9, f64::INFINITY), &mut state).unwrap();
        Impact { freedoms, structure, lines, pair, state, procedure }
    }

    fn of(&self, v: &[f64], node: usize, first: usize) -> Vec3 {
        Vec3::from_fn(|c, _| v[self.freedoms.index(node, first + c).unwrap()])
    }

    fn turned(&self) -> Matrix3<f64> {
        let rotation = Rotation3::new(self.of(&self.state.u, 5, 3));
        rotation.matrix() * tensor().tensor() * rotation.matrix().transpose()
    }

    /// Momentum and moment of momentum about the origin.
    fn momenta(&self) -> [Vec3; 2] {
        let v = self.procedure.velocity(&self.state);
        let each = |node: usize, mass: f64| {
            let x = Vec3::from(self.structure.mesh.points[node]) + self.of(&self.state.u, node, 0);
            let p = self.of(&v, node, 0) * mass;
            [p, x.cross(&p)]
        };
        let [[p, h], [more, turning]] = [each(4, POINT), each(5, PLATE)];
        [p + more, h + turning + self.turned() * self.of(&v, 5, 3)]
    }

    fn run(&mut self, dt: f64, steps: usize) {
        for _ in 0..steps {
            self.procedure.advance(&mut [&mut self.lines, &mut self.pair], &mut self.state, dt).unwrap();
        }
    }

    /// What an impulse that gives back the part e of the approach leaves: 1/μ = 1/m + 1/M + a·J⁻¹a, a = r × n; velocities of
    /// the point and the plate across it, angular velocity of the plate.
    fn exact(e: f64) -> (f64, f64, Vec3) {
        let arm = Vector3::new(ARM[0], ARM[1], 0.0).cross(&Vec3::z());
        let gain = tensor().tensor().try_inverse().unwrap() * arm;
        let mu = 1.0 / (1.0 / POINT + 1.0 / PLATE + arm.dot(&gain));
        let impulse = (1.0 + e) * mu * SPEED;
        (impulse / POINT - SPEED, -impulse / PLATE, -gain * impulse)
    }
}

/// A point hits a free plate off its middle, elastically: all that momentum, moment of momentum and energy leave open is one
/// impulse. The plate turns meanwhile, by an angle of |ω| π/√(k/μ) at most.
#[test]
fn an_eccentric_impact_on_a_free_body() {
    for analytical in [false, true] {
        let slope = 1e9;
        let mut scene = Impact::new(Some(Arc::new(Linear { slope, clearance: 0.0 })), analytical);
        let before = scene.momenta();
        // 1e-4 to close the gap, 1e-4 in contact.
        scene.run(2e-7, 1500);
        let after = scene.momenta();
        let (point, plate, omega) = Impact::exact(1.0);
        let angle = omega.norm() * std::f64::consts::PI / slope.sqrt();
        let v = scene.procedure.velocity(&scene.state);
        assert!((scene.of(&v, 4, 0) - Vec3::z() * point).norm() < SPEED * 2.0 * angle, "{}", scene.of(&v, 4, 0));
        assert!((scene.of(&v, 5, 0) - Vec3::z() * plate).norm() < SPEED * 2.0 * angle);
        assert!((scene.of(&v, 5, 3) - omega).norm() < omega.norm() * 2.0 * angle, "{} {omega}", scene.of(&v, 5, 3));
        for (before, after) in before.iter().zip(after) {
            // Rounding of 1500 increments with forces of 1e5 times the momentum per time.
            assert!((before - after).norm() < 1e-10 * before.norm(), "{before} {after}");
        }
        let energy = scene.procedure.kinetic(&scene.state) / (0.5 * POINT * SPEED * SPEED);
        // (ωΔt)²/4 of the contact's oscillation, k (1/m + 1/M + …) Δt² = 1e-4 at most.
        assert!((energy - 1.0).abs() < 1e-4, "{energy}");
    }
}

/// Kinematic contact ends the approach: the same impulse with e = 0, within the turn of an increment.
#[test]
fn a_kinematic_impact_on_a_free_body() {
    for analytical in [false, true] {
        let mut scene = Impact::new(None, analytical);
        let before = scene.momenta();
        let dt = 1e-6;
        scene.run(dt, 110);
        let (point, plate, omega) = Impact::exact(0.0);
        let v = scene.procedure.velocity(&scene.state);
        // The gap is open by a part of an increment at first: it closes with it.
        let bound = omega.norm() * dt * 20.0;
        assert!((scene.of(&v, 4, 0)[2] - point).abs() < SPEED * bound, "{} {point}", scene.of(&v, 4, 0));
        assert!((scene.of(&v, 5, 0)[2] - plate).abs() < SPEED * bound);
        assert!((scene.of(&v, 5, 3) - omega).norm() < omega.norm() * bound, "{} {omega}", scene.of(&v, 5, 3));
        for (before, after) in before.iter().zip(scene.momenta()) {
            assert!((before - after).norm() < 1e-5 * before.norm(), "{before} {after}");
        }
    }
}

/// The increment that a light body allows under a stiff contact: 2/√(k/μ), the bound of the program is at most that.
#[test]
fn light_bodies_shorten_the_increment() {
    let slope = 1e6;
    let mut scene = Impact::new(Some(Arc::new(Linear { slope, clearance: 2e-3 })), true);
    let arm = Vector3::new(ARM[0], ARM[1], 0.0).cross(&Vec3::z());
    let gain = tensor().tensor().try_inverse().unwrap() * arm;
    let exact = 2.0 / (slope * (1.0 / POINT + 1.0 / PLATE + arm.dot(&gain))).sqrt();
    scene.run(1e-6, 1);
    let stable = scene.procedure.stable().increment();
    assert!(stable <= exact && stable > 0.5 * exact, "{stable} {exact}");
}

/// Nodes a thousand times as far as the body is large stay on their circles, turn after turn.
#[test]
fn followers_move_on_circles() {
    let scene = Impact::new(None, false);
    let mut structure = scene.structure.clone();
    structure.mesh.points[0] = [3000.0, 400.0, 0.0];
    let follower = RigidFollower { reference: 5, nodes: vec![0, 1, 2, 3] };
    let mut carriers = Carriers::new(&structure, &scene.freedoms, vec![0, 1, 4], &[follower], &[]);
    let mut state = State::rest(&scene.freedoms);
    let spin = Vec3::new(0.0, 0.0, 2.5);
    let first = scene.freedoms.index(5, 3).unwrap();
    state.v[first..first + 3].copy_from_slice(spin.as_slice());
    let mut lines = Lines::new(&structure, &scene.freedoms, 0.0);
    let hold = |c| Support { freedom: first + c, kind: Prescribed::Displacement, course: Ramp::constant(0.0) };
    let terms: &mut [&mut dyn ExplicitTerm] = &mut [&mut lines];
    let mut procedure = CentralDifference::new(terms, vec![hold(0), hold(1)], (1e9, 1.0), &mut state).unwrap();
    for step in 1..=2000 {
        procedure.advance(&mut [&mut lines], &mut state, 0.01).unwrap();
        carriers.update(&state.u, &state.v);
        let (sin, cos) = (0.025 * f64::from(step)).sin_cos();
        let exact = Vec3::new(3000.0 * cos - 400.0 * sin, 400.0 * cos + 3000.0 * sin, 0.0);
        // Rounding of the angle, up to 50 rad.
        assert!((carriers.x[0] - exact).norm() < 3026.0 * 50.0 * 16.0 * f64::EPSILON, "{step}: {}", carriers.x[0]);
        assert!((carriers.v[0] - spin.cross(&carriers.x[0])).norm() < 1e-9);
    }
    assert!((state.u[first + 2] - 50.0).abs() < 1e-11);
}
