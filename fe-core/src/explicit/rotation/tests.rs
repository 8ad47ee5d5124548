//! Bodies that turn, against closed solutions and what must stay.

use super::*;
use crate::element::ElementType::{MASS, ROTARYI};
use crate::explicit::central_difference::{CentralDifference, Support};
use crate::explicit::line::Lines;
use crate::freedoms::Freedoms;
use crate::load::Prescribed;
use crate::ramp::Ramp;
use crate::structure::{Discrete, RotaryInertia, Structure};
use fe_mesh::{CellBlock, CellId};

struct Body {
    freedoms: Freedoms,
    lines: Lines,
    state: State,
    procedure: CentralDifference,
}

/// A node of mass 1 with a tensor, that turns at first with ω; supports are of rotations 0..3.
fn body(moments: [f64; 3], products: [f64; 3], omega: [f64; 3], supports: &[(usize, Prescribed, Ramp)]) -> Body {
    begin(moments, products, omega, supports).unwrap()
}

fn begin(
    moments: [f64; 3],
    products: [f64; 3],
    omega: [f64; 3],
    supports: &[(usize, Prescribed, Ramp)],
) -> Result<Body, Halt> {
    let mut structure = Structure::default();
    structure.mesh.points = vec![[0.0; 3]];
    structure.mesh.point_labels = vec![1];
    for element in [MASS, ROTARYI] {
        let block = CellBlock { nodes: vec![0], labels: vec![1], ..CellBlock::new(element.kind()) };
        structure.mesh.blocks.push(block);
        structure.elements.push(element);
    }
    let cells = |block| vec![CellId { block, cell: 0 }];
    structure.discrete = vec![Discrete { element: MASS, cells: cells(0), magnitude: 1.0, components: [0; 2] }];
    structure.rotary = vec![RotaryInertia { cells: cells(1), moments, products }];
    let freedoms = structure.freedoms(&[]);
    let mut state = State::rest(&freedoms);
    state.v[3..6].copy_from_slice(&omega);
    let mut lines = Lines::new(&structure, &freedoms, 0.0);
    let supports =
        supports.iter().map(|&(c, kind, ref course)| Support { freedom: 3 + c, kind, course: course.clone() });
    let procedure = CentralDifference::new(&mut [&mut lines], supports.collect(), (1.0, f64::INFINITY), &mut state)?;
    Ok(Body { freedoms, lines, state, procedure })
}

impl Body {
    /// An increment under a moment that acts at its beginning.
    fn advance(&mut self, dt: f64, moment: [f64; 3]) {
        self.state.force[3..6].copy_from_slice(&moment);
        self.procedure.advance(&mut [&mut self.lines], &mut self.state, dt).unwrap();
        self.state.force[3..6].copy_from_slice(&moment);
    }

    fn rotation(&self) -> Rotation3<f64> {
        Rotation3::new(three(&self.state.u, 3))
    }

    /// ω and H at the end of the last increment, of a tensor.
    fn motion(&self, inertia: Matrix3<f64>) -> [Vec3; 2] {
        let omega = three(&self.procedure.velocity(&self.state), 3);
        let rotation = self.rotation();
        [omega, rotation * (inertia * (rotation.inverse() * omega))]
    }
}

/// I = (2, 2, 1), ω = (0.1, 0, 3): in its own axes ω turns about the third at (I₁ − I₃)/I₁ ω₃. Second order in the increment.
#[test]
fn b16_free_top() {
    let exact = Vec3::new(-0.0475536928, 0.087969576, 3.0);
    let inertia = Matrix3::from_diagonal(&Vec3::new(2.0, 2.0, 1.0));
    let errors = [700, 1400, 2800].map(|steps| {
        let mut top = body([2.0, 2.0, 1.0], [0.0; 3], [0.1, 0.0, 3.0], &[]);
        (0..steps).for_each(|_| top.advance(7.0 / f64::from(steps), [0.0; 3]));
        let [omega, momentum] = top.motion(inertia);
        assert!((momentum - Vec3::new(0.2, 0.0, 3.0)).norm() < 1e-11, "{momentum}");
        assert!((momentum.norm() - 3.006659276).abs() < 1e-9);
        assert!((0.5 * omega.dot(&momentum) - 4.51).abs() < 1e-11);
        ((top.rotation().inverse() * omega) - exact).norm()
    });
    // The angle (I₁ − I₃)/I₁ ω₃ t = 10.5 rad is off by (ωΔt)²/24 of it at most, times 0.1.
    assert!(errors[0] < 0.1 * 10.5 * 0.03f64.powi(2) / 24.0, "{errors:?}");
    // The reference has ten digits.
    assert!((errors[0] / errors[1] - 4.0).abs() < 0.02 && (errors[1] / errors[2] - 4.0).abs() < 0.02, "{errors:?}");
    assert_eq!(body([1.0; 3], [0.0; 3], [0.0; 3], &[]).freedoms.rotations().collect::<Vec<_>>(), [3]);
}

/// Over 1e5 increments of a twentieth of a radian the energy of a top with three moments, near its unstable axis, swings
/// within (ωΔt)²/4 of itself and does not drift; its momentum stays but for rounding.
#[test]
fn a_free_body_keeps_energy_and_momentum() {
    let (moments, dt) = ([1.0, 2.0, 2.5], 0.05);
    let start = Vec3::new(0.01, 1.0, 0.02);
    let inertia = Matrix3::from_diagonal(&Vec3::from(moments));
    let mut top = body(moments, [0.0; 3], start.into(), &[]);
    let (before, half) = (inertia * start, 50_000);
    let mut bounds = [[f64::INFINITY, f64::NEG_INFINITY]; 2];
    for step in 0..2 * half {
        top.advance(dt, [0.0; 3]);
        let energy = top.procedure.conserved(&top.state) / (0.5 * start.dot(&before));
        let [low, high] = &mut bounds[step / half];
        (*low, *high) = (low.min(energy), high.max(energy));
    }
    let [first, second] = bounds;
    assert!(first[1] - first[0] < 0.25 * dt * dt, "{bounds:?}");
    // The bounds are met anew by every tumble, of which there are hundreds: they agree to what sampling leaves of them.
    assert!((first[0] - second[0]).abs() < 1e-6 && (first[1] - second[1]).abs() < 1e-6, "{bounds:?}");
    let [_, momentum] = top.motion(inertia);
    // Rounding of 1e5 increments, all to one side.
    assert!((momentum - before).norm() < 1e5 * 4.0 * f64::EPSILON * before.norm(), "{}", momentum - before);
}

/// A moment about a principal axis: ω = M t/I, and the angle M t²/2I; a ball turns so about any axis.
#[test]
fn a_moment_turns_a_body() {
    let moment = [0.3, -0.4, 1.2];
    let (dt, steps) = (0.01, 1000);
    let mut ball = body([2.0; 3], [0.0; 3], [0.0; 3], &[]);
    (0..steps).for_each(|_| ball.advance(dt, moment));
    let time = dt * f64::from(steps);
    let [omega, _] = ball.motion(Matrix3::from_diagonal_element(2.0));
    assert!((omega - Vec3::from(moment) * (time / 2.0)).norm() < 1e-11, "{omega}");
    // Central differences are exact where the acceleration is constant: 1.3 · 100/4 = 32.5 rad, five turns.
    let angle = three(&ball.state.u, 3);
    assert!((angle - Vec3::from(moment) * (time * time / 4.0)).norm() < 1e-10, "{angle}");
}

/// About a fixed axis the moment of inertia about it counts alone, and the bearings do no work.
#[test]
fn held_axes_turn_about_the_third() {
    let hold = |c| (c, Prescribed::Displacement, Ramp::constant(0.0));
    let mut wheel = body([2.0, 3.0, 4.0], [0.3, -0.5, 0.7], [0.0, 0.0, 1.0], &[hold(0), hold(1)]);
    let (dt, steps) = (0.01, 500);
    (0..steps).for_each(|_| wheel.advance(dt, [0.0, 0.0, 0.8]));
    let time = dt * f64::from(steps);
    assert!((wheel.procedure.velocity(&wheel.state)[5] - (1.0 + 0.2 * time)).abs() < 1e-12);
    assert!((wheel.state.u[5] - (time + 0.1 * time * time)).abs() < 1e-11 && wheel.state.u[3] == 0.0);
    assert_eq!(wheel.state.work, 0.0);
    // Thin bodies have one moment alone; free, it is refused.
    let thin = |supports: &[_]| begin([0.0, 0.0, 4.0], [0.0; 3], [0.0; 3], supports).err();
    assert_eq!(thin(&[hold(0), hold(1)]), None);
    assert_eq!(thin(&[]), Some(Halt::Massless { freedom: 3 }));
}

/// A motor turns a body with products of inertia about an axis that is free to tilt: its work is the body's energy, O(Δt²).
#[test]
fn a_motor_gives_what_the_body_has() {
    let motor = (2, Prescribed::Velocity, Ramp::constant(2.0));
    let (moments, products) = ([2.0, 3.0, 4.0], [0.3, -0.5, 0.7]);
    let errors = [0.01, 0.005].map(|dt| {
        let mut body = body(moments, products, [0.1, 0.0, 2.0], std::slice::from_ref(&motor));
        let before = body.procedure.conserved(&body.state);
        let mut worst = 0.0f64;
        for _ in 0..(8.0 / dt) as usize {
            body.advance(dt, [0.0; 3]);
            worst = worst.max((body.procedure.conserved(&body.state) - before - body.state.work).abs());
        }
        assert!(body.state.work.abs() > 0.1, "{}", body.state.work);
        worst
    });
    assert!((errors[0] / errors[1] - 4.0).abs() < 0.3, "{errors:?}");
}

/// A prescribed angle goes on over turns, as a rotation vector.
#[test]
fn prescribed_turns_are_counted() {
    let course = Ramp { from: 0.0, to: -20.0, ..Ramp::constant(0.0) };
    let hold = |c| (c, Prescribed::Displacement, Ramp::constant(0.0));
    let mut wheel = body([1.0; 3], [0.0; 3], [0.0; 3], &[hold(0), (1, Prescribed::Displacement, course), hold(2)]);
    (0..200).for_each(|_| wheel.advance(0.005, [0.0; 3]));
    let angle = three(&wheel.state.u, 3);
    assert!((angle - Vec3::new(0.0, -20.0, 0.0)).norm() < 1e-12, "{angle}");
}
