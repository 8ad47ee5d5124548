//! Loads in an explicit step: those that keep their direction, and pressures that follow their faces.

use super::{Advance, ExplicitTerm, Halt, Moving};
use crate::external::ExternalForces;
use crate::load::PressedFace;
use crate::ramp::Ramp;

/// External forces with the work that they do.
#[derive(Clone, Debug)]
pub struct Loads {
    external: ExternalForces,
    pressures: Vec<Pressure>,
    period: f64,
    /// Magnitudes at the end of the last increment.
    before: Vec<f64>,
    work: f64,
}

/// A pressure [F/L²] on faces where they are.
#[derive(Clone, Debug)]
struct Pressure {
    faces: Vec<PressedFace>,
    ramp: Ramp,
    /// Forces [F] at the end of the last increment, face after face.
    before: Vec<f64>,
}

impl Loads {
    /// Over a step of so long a period [T].
    pub fn new(external: ExternalForces, period: f64) -> Self {
        Loads { before: vec![0.0; external.parts.len()], external, pressures: Vec::new(), period, work: 0.0 }
    }

    /// With the energy [F L] that those of the steps before took from the motion.
    pub fn after(mut self, stored: f64) -> Self {
        self.work = -stored;
        self
    }

    /// With a pressure on faces.
    pub fn press(mut self, faces: Vec<PressedFace>, ramp: Ramp) -> Self {
        let before = vec![0.0; faces.iter().map(|face| face.freedoms().count()).sum()];
        self.pressures.push(Pressure { faces, ramp, before });
        self
    }

    /// Faces that pressures act on.
    pub fn pressed(&self) -> usize {
        self.pressures.iter().map(|pressure| pressure.faces.len()).sum()
    }
}

impl Pressure {
    /// Adds its forces; the work [F L] it has done in the increment.
    fn act(&mut self, at: &Moving, magnitude: f64, forces: &mut [f64]) -> f64 {
        let mut moved = 0.0;
        let mut before = self.before.iter_mut();
        for face in &self.faces {
            face.forces(at.u, |f, value| {
                let force = magnitude * value;
                forces[f] += force;
                before.by_ref().take(1).for_each(|before| {
                    moved += 0.5 * (*before + force) * at.v[f];
                    *before = force;
                });
            });
        }
        moved * at.dt
    }
}

impl ExplicitTerm for Loads {
    fn name(&self) -> &str {
        "loads"
    }

    fn advance(&mut self, at: &Moving, forces: &mut [f64]) -> Result<Advance, Halt> {
        for ((unit, ramp), before) in self.external.parts.iter().zip(&mut self.before) {
            let magnitude = ramp.at(at.step_time, at.total_time, self.period);
            let mut moved = 0.0;
            for &(f, value) in unit {
                forces[f] += magnitude * value;
                moved += value * at.v[f];
            }
            self.work += 0.5 * (*before + magnitude) * moved * at.dt;
            *before = magnitude;
        }
        for pressure in &mut self.pressures {
            let magnitude = pressure.ramp.at(at.step_time, at.total_time, self.period);
            self.work += pressure.act(at, magnitude, forces);
        }
        Ok(Advance::default())
    }

    fn stored(&self) -> f64 {
        -self.work
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::element::ElementType::C3D8R;
    use crate::structure::{Section, Structure};
    use fe_mesh::{CellBlock, CellId, Face};

    /// A cube of side 1 with a pressure of 3 on all faces, turned by 90° and twice as large, then 2.2 times: forces are those of the
    /// faces as they are, and the work by the trapezoidal rule is that of the three faces which go out by 0.2.
    #[test]
    fn a_pressure_follows_its_faces() {
        let mut structure = Structure::default();
        let corners = [[0., 0.], [1., 0.], [1., 1.], [0., 1.]];
        let points = [0.0, 1.0].iter().flat_map(|z| corners.map(|[x, y]| [x, y, *z])).collect();
        (structure.mesh.points, structure.mesh.point_labels) = (points, (1..=8).collect());
        let block = CellBlock { nodes: (0..8).collect(), labels: vec![1], ..CellBlock::new(C3D8R.kind()) };
        (structure.mesh.blocks, structure.elements) = (vec![block], vec![C3D8R]);
        let cell = CellId { block: 0, cell: 0 };
        structure.sections =
            vec![Section { element: C3D8R, cells: vec![cell], material: 0, thickness: 1.0, hourglass: None }];
        let freedoms = structure.freedoms(&[]);
        let faces = (0..6).map(|face| PressedFace::new(Face { cell, face }, &structure, &freedoms).unwrap()).collect();
        let mut loads = Loads::new(ExternalForces::default(), 1.0).press(faces, Ramp::constant(3.0));
        let place = |scale: f64| -> Vec<f64> {
            let moved = |x: &[f64; 3]| [-scale * x[1] - x[0], scale * x[0] - x[1], scale * x[2] - x[2]];
            structure.mesh.points.iter().flat_map(moved).collect()
        };
        let (from, to) = (place(2.0), place(2.2));
        let v: Vec<f64> = from.iter().zip(&to).map(|(from, to)| (to - from) / 0.5).collect();
        let mut act = |u: &[f64], dt: f64| {
            let mut forces = vec![0.0; 24];
            let at = Moving { u, v: &v, step_time: dt, total_time: dt, dt, stable: 1.0 };
            loads.advance(&at, &mut forces).unwrap();
            (forces, loads.stored())
        };
        let (forces, none) = act(&from, 0.0);
        // Node 1 at the origin: a quarter of each of its three faces; outside is −x, −y, −z there, and +x after the turn of −y.
        let quarter = 3.0 * 4.0 / 4.0;
        assert!(none == 0.0 && forces[..3].iter().zip([-1.0, 1.0, 1.0]).all(|(f, s)| (f - s * quarter).abs() < 1e-13));
        let (_, stored) = act(&to, 0.5);
        let work = -3.0 * 0.5 * (4.0 + 2.2 * 2.2) * 0.2 * 3.0;
        assert!((stored + work).abs() < 1e-12, "{stored} {work}");
    }
}
