//! Beams in explicit steps: no strain of rigid motion, forces that have an energy, frequencies, what a free beam keeps.

use super::*;
use crate::element::ElementType::{B21, B31};
use crate::explicit::ExplicitTerm;
use crate::explicit::central_difference::{CentralDifference, State, Support};
use crate::explicit::line::Lines;
use crate::load::Prescribed;
use crate::ramp::Ramp;
use crate::structure::Profile;
use fe_mesh::CellBlock;

const YOUNG: f64 = 200.0;
const SHEAR: f64 = 80.0;
const DENSITY: f64 = 2.0;

/// A line of beams from the origin in a direction.
struct Line {
    freedoms: Freedoms,
    structure: Structure,
    lines: Lines,
    state: State,
}

fn line(element: ElementType, count: usize, to: [f64; 3], profile: Profile) -> Line {
    let mut structure = Structure::default();
    let part = |i: usize| to.map(|x| x * i as f64 / count as f64);
    structure.mesh.points = (0..=count).map(part).collect();
    structure.mesh.point_labels = (1..=count as u64 + 1).collect();
    let nodes = (0..count as u32).flat_map(|i| [i, i + 1]).collect();
    let labels = (1..=count as u64).collect();
    structure.mesh.blocks.push(CellBlock { nodes, labels, ..CellBlock::new(element.kind()) });
    structure.elements.push(element);
    structure.lines = vec![LineSection {
        element,
        cells: structure.mesh.cells().collect(),
        name: "M".into(),
        young: YOUNG,
        shear: SHEAR,
        density: Some(DENSITY),
        damping: Damping::default(),
        profile,
        first_axis: [0.0, 0.0, -1.0],
    }];
    let freedoms = structure.freedoms(&[]);
    let state = State::rest(&freedoms);
    Line { lines: Lines::new(&structure, &freedoms, 0.0), freedoms, structure, state }
}

/// A section without symmetry.
fn skew() -> Profile {
    Profile { i12: 0.005, ..Profile::rectangle(0.8, 0.5) }
}

impl Line {
    fn forces(&self, u: &[f64]) -> (Vec<f64>, f64) {
        let mut lines = self.lines.clone();
        let mut forces = vec![0.0; u.len()];
        let v = vec![0.0; u.len()];
        let at = Moving { u, v: &v, step_time: 0.0, total_time: 0.0, dt: 0.0, stable: f64::INFINITY };
        lines.advance(&at, &mut forces).unwrap();
        (forces, lines.energies()[0])
    }

    fn of(&self, v: &[f64], node: usize, first: usize) -> Vec3 {
        Vec3::from_fn(|c, _| self.freedoms.index(node, first + c).map_or(0.0, |f| v[f]))
    }

    fn put(&self, v: &mut [f64], node: usize, first: usize, value: Vec3) {
        (0..3).for_each(|c| self.freedoms.index(node, first + c).into_iter().for_each(|f| v[f] = value[c]));
    }

    fn begin(&mut self, held: &[(usize, usize)]) -> CentralDifference {
        let hold = |freedom| Support { freedom, kind: Prescribed::Displacement, course: Ramp::constant(0.0) };
        let supports = held.iter().filter_map(|&(n, c)| self.freedoms.index(n, c)).map(hold).collect();
        CentralDifference::new(&mut [&mut self.lines], supports, (1e9, f64::INFINITY), &mut self.state).unwrap()
    }
}

/// A displacement without order, of this size.
fn shaken(line: &Line, size: f64) -> Vec<f64> {
    (0..line.freedoms.len()).map(|f| size * ((f * f + 3 * f) as f64).sin()).collect()
}

/// Turned and moved as a whole, however far: no force.
#[test]
fn rigid_motion_leaves_no_force() {
    for turn in [Vec3::new(0.4, -2.0, 1.1), Vec3::new(0.0, 0.0, 9.0)] {
        let line = line(B31, 3, [1.0, 2.0, -0.5], skew());
        let rotation = Rotation3::new(turn);
        let mut u = vec![0.0; line.freedoms.len()];
        for (node, x) in line.structure.mesh.points.iter().enumerate() {
            let x = Vec3::from(*x);
            line.put(&mut u, node, 0, rotation * x - x + Vec3::new(30.0, -20.0, 10.0));
            line.put(&mut u, node, 3, turn);
        }
        let (forces, energy) = line.forces(&u);
        // Rounding of places of size 40 with E A / L.
        let largest = forces.iter().fold(0.0f64, |m, f| m.max(f.abs()));
        assert!(largest < 1e3 * 40.0 * f64::EPSILON * YOUNG && energy < 1e-20, "{largest} {energy}");
    }
}

/// The power of the forces is the change of energy, at large rotations: −dW/dt along any velocity, by central quotients.
#[test]
fn forces_are_those_of_the_energy() {
    let line = line(B31, 2, [1.0, 0.3, 0.2], skew());
    let u = shaken(&line, 0.7);
    let (forces, energy) = line.forces(&u);
    let total: Vec3 = (0..3).map(|node| line.of(&forces, node, 0)).sum();
    let about = |node: usize| {
        let x = Vec3::from(line.structure.mesh.points[node]) + line.of(&u, node, 0);
        x.cross(&line.of(&forces, node, 0)) + line.of(&forces, node, 3)
    };
    let moment: Vec3 = (0..3).map(about).sum();
    assert!(energy > 1.0 && total.norm() < 1e-11 * energy && moment.norm() < 1e-11 * energy, "{total} {moment}");
    let step = 1e-6;
    for node in 0..3 {
        for c in 0..6 {
            let moved = |by: f64| {
                let mut u = u.clone();
                let unit = Vec3::from_fn(|i, _| if i == c % 3 { by } else { 0.0 });
                if c < 3 {
                    let moved = line.of(&u, node, 0) + unit;
                    line.put(&mut u, node, 0, moved);
                } else {
                    let turned = Rotation3::new(unit) * Rotation3::new(line.of(&u, node, 3));
                    line.put(&mut u, node, 3, turned.scaled_axis());
                }
                line.forces(&u).1
            };
            let slope = (moved(step) - moved(-step)) / (2.0 * step);
            let force = forces[line.freedoms.index(node, c).unwrap()];
            // Rounding ε W/h and the third derivative h².
            assert!((slope + force).abs() < 1e-8 * energy, "{node} {c}: {slope} {force}");
        }
    }
}

/// A strip of beams rolled up to a circle by end moments of 2π E I/l: one-point elements hold it at E I ψ/L exactly.
#[test]
fn a_roll_up_is_exact() {
    let (count, length) = (8, 10.0);
    let profile = Profile::rectangle(0.5, 0.5);
    let line = line(B21, count, [length, 0.0, 0.0], profile);
    let mut u = vec![0.0; line.freedoms.len()];
    let (h, angle) = (length / count as f64, std::f64::consts::TAU / count as f64);
    let mut place = Vec3::zeros();
    for node in 0..=count {
        line.put(&mut u, node, 0, place - Vec3::new(h * node as f64, 0.0, 0.0));
        line.put(&mut u, node, 3, Vec3::z() * (angle * node as f64));
        let middle = angle * (node as f64 + 0.5);
        place += Vec3::new(middle.cos(), middle.sin(), 0.0) * h;
    }
    assert!(place.norm() < length, "it closes");
    let (forces, energy) = line.forces(&u);
    let moment = YOUNG * profile.i11 * std::f64::consts::TAU / length;
    let end = line.freedoms.index(count, 5).unwrap();
    assert!((forces[end] + moment).abs() < 1e-11 * moment, "{} {moment}", forces[end]);
    assert!((energy / (0.5 * moment * std::f64::consts::TAU) - 1.0).abs() < 1e-12);
    let rest = (0..forces.len()).filter(|&f| f != end && f != 2).map(|f| forces[f].abs()).fold(0.0, f64::max);
    assert!(rest < 1e-11 * moment, "{rest}");
}

/// Along their line beams are trusses: at the stable increment a standing wave of N elements swings exactly.
#[test]
fn waves_along_the_line_are_exact_at_the_stable_increment() {
    let wave = 8;
    let mut line = line(B31, wave, [wave as f64, 0.0, 0.0], skew());
    // The strain along a straight line is linear in the displacement, however large.
    let (k, amplitude) = (std::f64::consts::TAU / wave as f64, 1e-3);
    for node in 0..=wave {
        let v = Vec3::x() * (amplitude * (k * node as f64).cos());
        let f = line.freedoms.index(node, 0).unwrap();
        line.state.v[f] = v.x;
    }
    let mut procedure = line.begin(&[]);
    let dt = procedure.stable().increment();
    assert!((dt - (DENSITY / YOUNG).sqrt()).abs() < 1e-15, "{dt}");
    (0..19).for_each(|_| procedure.advance(&mut [&mut line.lines], &mut line.state, dt).unwrap());
    let exact = amplitude * dt * (19.0 * k).sin() / k.sin();
    assert!((line.state.u[0] - exact).abs() < 1e-11 * amplitude, "{} {exact}", line.state.u[0]);
}

/// A cantilever's first frequency 1.87510407² √(E I/ρ A)/l²: second order in the elements, and the increment that the program
/// gives is stable although the section is deep, thin, or long for its elements.
#[test]
fn a_cantilever_swings() {
    let (length, depth) = (20.0f64, 0.4);
    let profile = Profile::rectangle(depth, depth);
    let exact = 1.8751040687f64.powi(2) * (YOUNG * profile.i11 / (DENSITY * profile.area)).sqrt() / length.powi(2);
    let errors = [8, 16, 32].map(|count| {
        let mut line = line(B21, count, [length, 0.0, 0.0], profile);
        for node in 1..=count {
            // Near to the first mode: 1 − cos, times a little.
            let angle = std::f64::consts::FRAC_PI_2 * node as f64 / count as f64;
            let f = line.freedoms.index(node, 1).unwrap();
            line.state.v[f] = 1e-6 * (1.0 - angle.cos());
            let slope = line.freedoms.index(node, 5).unwrap();
            line.state.v[slope] = 1e-6 * std::f64::consts::FRAC_PI_2 / length * angle.sin();
        }
        let mut procedure = line.begin(&[(0, 0), (0, 1), (0, 5)]);
        let dt = procedure.stable().increment() * 0.98;
        // The tip's motion weighed with a window over ten periods: the phase of its Fourier component gives the frequency.
        let tip = line.freedoms.index(count, 1).unwrap();
        let steps = (10.0 * std::f64::consts::TAU / exact / dt) as usize;
        let mut sums = [[0.0f64; 2]; 2];
        for step in 0..2 * steps {
            procedure.advance(&mut [&mut line.lines], &mut line.state, dt).unwrap();
            let part = (step % steps) as f64 / steps as f64;
            let window = (std::f64::consts::PI * part).sin().powi(2) * line.state.u[tip];
            let (sin, cos) = (exact * dt * step as f64).sin_cos();
            sums[step / steps][0] += window * cos;
            sums[step / steps][1] += window * sin;
        }
        let [first, second] = sums.map(|[cos, sin]| sin.atan2(cos));
        let tau = std::f64::consts::TAU;
        // u = sin ωt: the phase against the exact frequency falls as ω is higher.
        let shift = (second - first + 0.5 * tau).rem_euclid(tau) - 0.5 * tau;
        -shift / (exact * dt * steps as f64)
    });
    let rate = (errors[0] - errors[1]) / (errors[1] - errors[2]);
    assert!((rate - 4.0).abs() < 0.1, "{errors:?}");
    // What is left is shear and the section's rotary inertia: ½ β² (r/l)² (1 + E/κG) and less, β² = 3.5, E/κG = 2.9.
    let limit = (4.0 * errors[2] - errors[1]) / 3.0;
    let square = profile.i11 / profile.area / (length * length);
    assert!(limit < 0.0 && limit > -7.0 * square, "{limit} {errors:?}");
}

/// A bent free beam that tumbles: momentum and moment of momentum stay but for rounding; the energy within what the increment
/// leaves of the fastest oscillation.
#[test]
fn a_free_beam_keeps_what_it_has() {
    let mut line = line(B31, 4, [2.0, 1.0, 0.5], skew());
    let spin = Vec3::new(0.5, -1.0, 2.0);
    for (node, x) in line.structure.mesh.points.clone().iter().enumerate() {
        let mut v = line.state.v.clone();
        line.put(&mut v, node, 0, spin.cross(&Vec3::from(*x)) + Vec3::new(0.3, 0.2, -0.1 * node as f64));
        line.put(&mut v, node, 3, spin);
        line.state.v = v;
    }
    let mut mass = vec![0.0; line.freedoms.len()];
    line.lines.add_mass(&mut mass);
    let mut procedure = line.begin(&[]);
    let momenta = |line: &Line, procedure: &CentralDifference| {
        let v = procedure.velocity(&line.state);
        let each = |node: usize| {
            let x = Vec3::from(line.structure.mesh.points[node]) + line.of(&line.state.u, node, 0);
            let p = line.of(&v, node, 0).component_mul(&line.of(&mass, node, 0));
            [p, x.cross(&p) + line.of(&v, node, 3).component_mul(&line.of(&mass, node, 3))]
        };
        (0..5).map(each).fold([Vec3::zeros(); 2], |sum, each| [sum[0] + each[0], sum[1] + each[1]])
    };
    let before = momenta(&line, &procedure);
    let energy =
        |line: &Line, procedure: &CentralDifference| procedure.conserved(&line.state) + line.lines.energies()[0];
    let start = energy(&line, &procedure);
    let dt = 0.3 * procedure.stable().increment();
    let mut worst = [0.0f64; 2];
    for step in 0..20_000 {
        procedure.advance(&mut [&mut line.lines], &mut line.state, dt).unwrap();
        let off = (energy(&line, &procedure) / start - 1.0).abs();
        worst[step / 10_000] = worst[step / 10_000].max(off);
    }
    for (before, after) in before.iter().zip(momenta(&line, &procedure)) {
        assert!((before - after).norm() < 20_000.0 * 8.0 * f64::EPSILON * before.norm(), "{before} {after}");
    }
    // (ωΔt)²/4 = 0.09 of the part of the energy that is in strains, which tumbling makes a few percent.
    assert!(worst[0] < 0.01 && worst[1] < 1.5 * worst[0], "{worst:?}");
}
