//! Two-node elements that act along their line or along fixed freedoms: trusses, springs, dashpots; beams; and
//! masses and rotary inertias of nodes.

mod element;

use super::beam::Beams;
use super::mass_scaling::raised;
use super::rotation::Rotary;
use super::{Advance, ExplicitTerm, Halt, Moving};
use crate::element::{ElementType, Family};
use crate::freedoms::Freedoms;
use crate::structure::Structure;
use element::{Answer, Answered, Element, Reach};
use fe_mesh::CellId;

/// All trusses, beams, springs, dashpots, masses and rotary inertias of a scene.
#[derive(Clone, Debug)]
pub struct Lines {
    elements: Vec<Element>,
    beams: Beams,
    /// Point masses on freedoms.
    masses: Vec<(usize, f64)>,
    /// Tensors of inertia of nodes in space.
    rotary: Vec<Rotary>,
    /// Linear bulk viscosity [-] of trusses and beams.
    viscosity: f64,
    /// Largest sums of stiffness and of viscosity over mass of a node [1/T², 1/T].
    rates: [f64; 2],
    stored: f64,
    dissipated: f64,
}

impl Lines {
    /// Those of a structure; `viscosity` is the linear bulk viscosity [-].
    pub fn new(structure: &Structure, freedoms: &Freedoms, viscosity: f64) -> Self {
        let mut lines = Lines {
            elements: Vec::new(),
            beams: Beams::new(structure, freedoms),
            masses: Vec::new(),
            rotary: Vec::new(),
            viscosity,
            rates: [0.0; 2],
            stored: 0.0,
            dissipated: 0.0,
        };
        lines.add_trusses(structure, freedoms);
        lines.add_discrete(structure, freedoms);
        lines.add_rotary(structure, freedoms);
        lines
    }

    fn add_trusses(&mut self, structure: &Structure, freedoms: &Freedoms) {
        for section in structure.lines.iter().filter(|s| s.element.family() == Family::Truss) {
            let (area, density) = (section.profile.area, section.density.unwrap_or(0.0));
            for &cell in &section.cells {
                let bare = Element::along((structure, freedoms), cell, Answer::Truss(section.young * area));
                let mass = 0.5 * density * area * bare.length;
                self.elements.push(Element { mass, damping: section.damping, ..bare });
            }
        }
    }

    /// Springs, dashpots and masses.
    fn add_discrete(&mut self, structure: &Structure, freedoms: &Freedoms) {
        use ElementType::*;
        for section in &structure.discrete {
            let answer = match section.element.family() {
                Family::Spring => Answer::Spring(section.magnitude),
                _ => Answer::Dashpot(section.magnitude),
            };
            for &cell in &section.cells {
                let nodes = structure.mesh.cell(cell);
                let freedom = |i: usize| freedoms.index(nodes[i] as usize, section.components[i].into());
                let second = match section.element {
                    MASS => {
                        let places = freedoms.of_node(nodes[0] as usize).take(structure.dimension());
                        self.masses.extend(places.map(|f| (f, section.magnitude)));
                        continue;
                    }
                    SPRING1 | DASHPOT1 => None,
                    SPRING2 | DASHPOT2 => freedom(1),
                    _ => {
                        self.elements.push(Element::along((structure, freedoms), cell, answer));
                        continue;
                    }
                };
                let fixed = |first| Element::new(cell, answer, (Reach::Fixed { first, second }, 1.0));
                self.elements.extend(freedom(0).map(fixed));
            }
        }
    }

    fn add_rotary(&mut self, structure: &Structure, freedoms: &Freedoms) {
        for section in &structure.rotary {
            for &cell in &section.cells {
                let node = structure.mesh.cell(cell)[0] as usize;
                match freedoms.index(node, 3) {
                    Some(first) => self.rotary.push((first, section.tensor())),
                    None => self.masses.extend(freedoms.index(node, 5).map(|f| (f, section.moments[2]))),
                }
            }
        }
    }

    /// From now on with another linear bulk viscosity [-].
    pub fn damp(&mut self, viscosity: f64) {
        self.viscosity = viscosity;
    }

    /// From now on with so many times its mass in each truss and beam.
    pub fn scale(&mut self, factor: &dyn Fn(CellId) -> f64) {
        let heavy = self.elements.iter_mut().filter(|element| element.mass > 0.0);
        heavy.for_each(|element| element.factor = factor(element.cell));
        self.beams.scale(factor);
    }

    /// Stable increments [T] that trusses and beams have by themselves, without their factors, as of the last increment.
    pub fn increments(&self) -> impl Iterator<Item = (CellId, f64)> + '_ {
        let heavy = self.elements.iter().filter(|element| element.mass > 0.0);
        heavy.map(|element| (element.cell, element.stable)).chain(self.beams.increments())
    }

    /// Energy [F L] that springs, trusses and beams hold, and that dashpots and bulk viscosity have dissipated.
    pub fn energies(&self) -> [f64; 2] {
        let [stored, dissipated] = self.beams.energies;
        [self.stored + stored, self.dissipated + dissipated]
    }

    /// Adds the damping α m [M/T] of materials to the freedoms.
    pub fn add_mass_damping(&self, damping: &mut [f64]) {
        for element in &self.elements {
            element.freedoms().for_each(|f| damping[f] += element.damping.alpha * element.mass);
        }
        self.beams.add_mass_damping(damping);
    }

    /// True where there are none.
    pub fn is_empty(&self) -> bool {
        self.elements.is_empty() && self.beams.is_empty() && self.masses.is_empty() && self.rotary.is_empty()
    }
}

impl ExplicitTerm for Lines {
    fn name(&self) -> &str {
        "trusses, beams, springs and masses"
    }

    fn add_mass(&self, mass: &mut [f64]) {
        for element in self.elements.iter().filter(|element| element.mass > 0.0) {
            element.freedoms().for_each(|f| mass[f] += element.factor * element.mass);
        }
        self.beams.add_mass(mass);
        self.masses.iter().for_each(|&(f, m)| mass[f] += m);
    }

    fn rotary(&self) -> &[Rotary] {
        &self.rotary
    }

    fn weigh(&mut self, mass: &[f64]) {
        let mut sums = [vec![0.0; mass.len()], vec![0.0; mass.len()]];
        for element in &self.elements {
            // A row of k [1 −1; −1 1] has the sum 2k, one to ground k.
            let rows = if matches!(element.reach, Reach::Fixed { second: None, .. }) { 1.0 } else { 2.0 };
            let (which, value) = match element.answer {
                Answer::Truss(_) => continue,
                Answer::Spring(k) => (0, k),
                Answer::Dashpot(c) => (1, c),
            };
            element.freedoms().for_each(|f| sums[which][f] += rows * value.abs());
        }
        let largest = |sums: &[f64]| {
            let rates = sums.iter().zip(mass).filter(|(s, m)| **s > 0.0 && **m > 0.0).map(|(s, m)| s / m);
            rates.fold(0.0, f64::max)
        };
        self.rates = sums.each_ref().map(|sums| largest(sums));
    }

    fn advance(&mut self, at: &Moving, forces: &mut [f64]) -> Result<Advance, Halt> {
        let mut advance = Advance { rate: self.rates[0], damping: self.rates[1], ..Advance::default() };
        for element in &mut self.elements {
            let (line, now) = element.length(at.u);
            let before = element.now;
            if element.answer_is_lost(now) {
                return Err(Halt::Inverted { cell: element.cell });
            }
            let rate = if at.dt > 0.0 { (now - before) / at.dt } else { 0.0 };
            let Answered { elastic, stored, viscous } = element.answer(now, rate, self.viscosity);
            let stable = raised(element.stable, element.factor, self.viscosity);
            if stable < advance.stable {
                (advance.stable, advance.element) = (stable, Some(element.cell));
            }
            let force = elastic + viscous;
            self.stored += stored;
            // What central differences lose to a force is half of it before and half of it now, times the way.
            self.dissipated += 0.5 * (element.viscous + viscous) * (now - before);
            element.viscous = viscous;
            element.now = now;
            match &element.reach {
                Reach::Line { ends: [a, b], directions, .. } => {
                    for c in 0..*directions {
                        let part = force * line[c] / now;
                        forces[a + c] += part;
                        forces[b + c] -= part;
                    }
                }
                Reach::Fixed { first, second } => {
                    forces[*first] -= force;
                    second.iter().for_each(|&second| forces[second] += force);
                }
            }
        }
        Ok(advance.and(self.beams.advance(at, self.viscosity, forces)))
    }

    fn stored(&self) -> f64 {
        self.energies().into_iter().sum()
    }
}
