//! Impacts with closed solutions: a bar that falls on a wall, a ball as a mass on Hertz's law.

use super::kinematic::{SPEED, bars, hard};
use super::*;
use crate::law::NormalResponse;

/// A bar of n trusses that has fallen for 150 onto the wall, in contact over 2L/c = 2 n, so that n = 50 is the bar of Doyen,
/// Ern and Piperno (2011): with times over 150, pressures times 300, and speeds times 10.
struct Fall {
    scene: Scene,
    nodes: u32,
    gravity: f64,
    /// Time and pressure over that of the impact, 1.
    pressures: Vec<(f64, f64)>,
    /// Energy of the start, that of its height above the wall left out.
    energy: f64,
}

impl Fall {
    fn run(n: u32, definition: Definition, dt: f64) -> Fall {
        let gravity = SPEED / (3.0 * f64::from(n));
        let height = 0.5 * SPEED * SPEED / gravity;
        let mut points: Vec<[f64; 3]> = (0..=n).map(|i| [0.0, 0.0, height + f64::from(i)]).collect();
        points.push([0.0, 0.0, -1.0]);
        // The force of a kinematic increment is that at its start.
        let late = if definition.enforcement == Enforcement::Kinematic(1.0) { dt } else { 0.0 };
        let scene = Scene::new(&bars(points, &[(0..=n).collect()]), definition, &[n + 1], &[]);
        let energy = 0.5 * f64::from(n) * SPEED * SPEED;
        let mut fall = Fall { scene, nodes: n, gravity, pressures: Vec::new(), energy };
        let reference = fall.scene.at(n + 1, 2);
        for step in 1..=(9.0 * f64::from(n) / dt).round() as u32 {
            fall.weigh_down();
            fall.scene.advance(dt);
            fall.pressures.push((f64::from(step) * dt - late, -fall.scene.state.force[reference] / SPEED));
        }
        fall.weigh_down();
        fall
    }

    fn mass(&self, node: u32) -> f64 {
        if node == 0 || node == self.nodes { 0.5 } else { 1.0 }
    }

    fn weigh_down(&mut self) {
        for node in 0..=self.nodes {
            let f = self.scene.at(node, 2);
            self.scene.state.force[f] -= self.mass(node) * self.gravity;
        }
    }

    /// Mean velocity over that of the impact.
    fn speed(&self) -> f64 {
        let all = (0..=self.nodes).map(|node| self.mass(node) * self.scene.state.v[self.scene.at(node, 2)]);
        all.sum::<f64>() / f64::from(self.nodes) / SPEED
    }

    /// Change of the energy over that of the impact.
    fn gained(&self) -> f64 {
        let scene = &self.scene;
        let high: f64 = (0..=self.nodes).map(|n| self.mass(n) * self.gravity * scene.state.u[scene.at(n, 2)]).sum();
        (scene.procedure.conserved(&scene.state) + scene.lines.stored() + high) / self.energy
    }

    /// Impulse over the exact one, 8/3 n.
    fn impulse(&self, dt: f64) -> f64 {
        self.pressures.iter().map(|p| p.1 * dt).sum::<f64>() / (8.0 / 3.0 * f64::from(self.nodes))
    }

    /// Root of the mean square of the error of the pressure in (1.05, 1.6), over the mean pressure; variation over that of the
    /// exact one, which rises to 1, on to 5/3, and falls.
    fn error(&self) -> (f64, f64) {
        let unit = 3.0 * f64::from(self.nodes);
        let window: Vec<_> = self.pressures.iter().filter(|p| p.0 > 1.05 * unit && p.0 < 1.6 * unit).collect();
        let exact = |time: f64| time / unit;
        let squares: f64 = window.iter().map(|p| (p.1 - exact(p.0)).powi(2)).sum();
        let mean: f64 = window.iter().map(|p| exact(p.0)).sum::<f64>() / window.len() as f64;
        let variation: f64 = self.pressures.windows(2).map(|two| (two[1].1 - two[0].1).abs()).sum();
        ((squares / window.len() as f64).sqrt() / mean, 0.3 * variation)
    }
}

/// The end node on a spring of EA/h = 1.
fn penalty(n: u32) -> Definition {
    definition(&[0], floor(n + 1), Arc::new(Linear { slope: 1.0, clearance: 0.0 }))
}

fn kinematic(n: u32) -> Definition {
    hard(&[0], floor(n + 1), Enforcement::Kinematic(1.0))
}

/// B03: the impulse to 1 %, the times to 2 h/c, and with it the speed at which it leaves; the energy stays, but for 1/(2n) that
/// kinematic contact takes.
#[test]
fn b03_bouncing_bar() {
    let (n, dt) = (50, 0.5);
    let unit = 3.0 * f64::from(n);
    for (definition, lost, late) in [(penalty(n), 0.0, 2.0), (kinematic(n), 0.5 / f64::from(n), 0.0)] {
        let name = format!("{:?}", definition.enforcement);
        let fall = Fall::run(n, definition, dt);
        assert!((fall.impulse(dt) - 1.0).abs() < 0.01, "{name} {}", fall.impulse(dt));
        // At half of the pressure: an end node on a spring rings after the wave has passed.
        let closed: Vec<f64> = fall.pressures.iter().filter(|p| p.1 > 0.5).map(|p| p.0).collect();
        let (first, last) = (closed[0], closed[closed.len() - 1]);
        // A spring of EA/h is like one element more, which the wave passes twice.
        let leaves = unit + 2.0 * f64::from(n) + late;
        assert!((first - unit).abs() <= 2.0 && (last - leaves).abs() <= 2.0, "{name} {first} {last}");
        // It leaves at 1 after 5/3 of the unit, and is slowed from there on to 3.
        let expected = 1.0 - (3.0 - 5.0 / 3.0);
        // To the hundredth of the impulse, 8/3 of n, and the increment of the wall's force.
        assert!((fall.speed() - expected).abs() < 0.01 * 8.0 / 3.0 + dt / unit, "{name} {}", fall.speed());
        // A switch within an increment costs up to ½ ω² q (vΔt − q) ≤ ω²(vΔt)²/8, ω² = 2: of n v²/2, 1/(8 n) at Δt = ½.
        assert!((fall.gained() + lost).abs() < 2.0 * 0.125 / f64::from(n), "{name} {}", fall.gained());
    }
}

/// B09 for central differences, whose rows are a penalty of EA/h and kinematic contact (those of implicit steps wait for them):
/// impulse, error and variation of the pressure, energy; each to a twentieth, or half a unit of its last digit.
#[test]
fn b09_contact_oscillation() {
    let (n, dt) = (50, 0.5);
    let rows = [(penalty(n), [0.0099, 0.085, 7.2, 0.0004]), (kinematic(n), [0.00007, 0.0014, 1.36, -0.01])];
    for (definition, expected) in rows {
        let name = format!("{:?}", definition.enforcement);
        let fall = Fall::run(n, definition, dt);
        let (error, variation) = fall.error();
        let found = [fall.impulse(dt) - 1.0, error, variation, fall.gained()];
        let near = |(f, e): (&f64, &f64)| (f - e).abs() <= (0.05 * e.abs()).max(0.00005);
        assert!(found.iter().zip(&expected).all(near), "{name} {found:?}");
    }
}

/// F = C h^{3/2}.
#[derive(Debug)]
struct Hertz(f64);

impl NormalLaw for Hertz {
    fn respond(&self, gap: f64) -> NormalResponse {
        let (h, c) = ((-gap).max(0.0), self.0);
        NormalResponse { energy: 0.4 * c * h.powf(2.5), pressure: c * h.powf(1.5), stiffness: 1.5 * c * h.sqrt() }
    }
}

/// B05, the ball as a mass point: approach, force and contact time of Hertz's quasi-static impact, with the square of the
/// increment.
#[test]
fn b05_ball_as_a_mass_point() {
    let (radius, density, v): (f64, f64, f64) = (10.0, 7.85e-9, 1000.0);
    let modulus = 210e3 / (1.0 - 0.09);
    let mass = 4.0 / 3.0 * std::f64::consts::PI * radius.powi(3) * density;
    let exact = [0.017795109143, 2309.76407922, 5.23759031431e-5];
    let mut errors = Vec::new();
    for steps in [500, 2000] {
        let structure = masses(&[([0.0; 3], mass), ([0.0, 0.0, -1.0], 0.0)]);
        let law = Arc::new(Hertz(4.0 / 3.0 * modulus * radius.sqrt()));
        let mut scene = Scene::new(&structure, definition(&[0], floor(1), law), &[1], &[(0, 2, -v)]);
        let (z, dt) = (scene.at(0, 2), exact[2] / f64::from(steps));
        let (mut deepest, mut most, mut time) = (0.0f64, 0.0f64, 0.0);
        while scene.state.u[z] <= 0.0 {
            scene.advance(dt);
            deepest = deepest.max(-scene.state.u[z]);
            most = most.max(scene.state.force[z]);
            time += dt;
        }
        time -= scene.state.u[z] / scene.state.v[z];
        let found = [deepest, most, time];
        errors.push(std::array::from_fn::<f64, 3, _>(|i| (found[i] / exact[i] - 1.0).abs()));
        // The turn lies within half an increment: ½ (π Δt/2T)²; the rest is (ωΔt)²/24 and less.
        let bound = 4.0 / f64::from(steps).powi(2);
        assert!(errors.last().unwrap().iter().all(|error| *error < bound), "{steps} {errors:?}");
        assert!((scene.state.v[z] / v - 1.0).abs() < bound, "{}", scene.state.v[z]);
    }
}
