//! Two-node elements that act along their line or along fixed freedoms: trusses, springs, dashpots; beams; and
//! masses and rotary inertias of nodes.

use super::beam::Beams;
use super::mass_scaling::raised;
use super::rotation::Rotary;
use super::{Advance, ExplicitTerm, Halt, Moving};
use crate::element::{ElementType, Family};
use crate::freedoms::Freedoms;
use crate::material::Damping;
use crate::structure::Structure;
use fe_mesh::CellId;

/// How an element answers its length.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Answer {
    /// E A₀ [F] of a truss: N = E A₀ ln λ/λ, as the volume stays (Abaqus Theory Manual, Truss elements).
    Truss(f64),
    /// k [F/L].
    Spring(f64),
    /// c [F T/L].
    Dashpot(f64),
}

/// Where an element acts.
#[derive(Clone, Debug, PartialEq)]
enum Reach {
    /// Between two nodes, along their line: first freedoms, how many each has, and the line at the start [L].
    Line { ends: [usize; 2], directions: usize, line: [f64; 3] },
    /// On the difference of freedoms; the second may be missing.
    Fixed { first: usize, second: Option<usize> },
}

#[derive(Clone, Debug, PartialEq)]
struct Element {
    cell: CellId,
    answer: Answer,
    reach: Reach,
    /// Length at the start [L]; 1 where it acts on fixed freedoms.
    length: f64,
    /// Half of its mass [M], and the factor on it.
    mass: f64,
    factor: f64,
    /// Stable increment [T] by itself, without the factor.
    stable: f64,
    /// Damping of its material.
    damping: Damping,
    /// Length or elongation [L] at the end of the last increment.
    now: f64,
    /// Force [F] of dashpot, bulk viscosity or damping by stiffness then.
    viscous: f64,
}

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
        let mesh = &structure.mesh;
        let dimension = structure.dimension();
        let (mut elements, mut masses) = (Vec::new(), Vec::new());
        let line = |cell: CellId| {
            let nodes = mesh.cell(cell);
            let [a, b] = [0, 1].map(|i| mesh.points[nodes[i] as usize]);
            let ends = [0, 1].map(|i| freedoms.of_node(nodes[i] as usize).start);
            let line: [f64; 3] = std::array::from_fn(|c| b[c] - a[c]);
            (Reach::Line { ends, directions: dimension, line }, norm(line))
        };
        for section in structure.lines.iter().filter(|s| s.element.family() == Family::Truss) {
            let (area, density) = (section.profile.area, section.density.unwrap_or(0.0));
            for &cell in &section.cells {
                let (reach, length) = line(cell);
                let (answer, mass) = (Answer::Truss(section.young * area), 0.5 * density * area * length);
                let damping = section.damping;
                elements.push(Element {
                    cell,
                    answer,
                    reach,
                    length,
                    mass,
                    factor: 1.0,
                    stable: f64::INFINITY,
                    damping,
                    now: length,
                    viscous: 0.0,
                });
            }
        }
        for section in &structure.discrete {
            use ElementType::*;
            for &cell in &section.cells {
                let nodes = mesh.cell(cell);
                let freedom = |i: usize| freedoms.index(nodes[i] as usize, section.components[i].into());
                let (reach, length) = match section.element {
                    MASS => {
                        let places = freedoms.of_node(nodes[0] as usize).take(dimension);
                        masses.extend(places.map(|f| (f, section.magnitude)));
                        continue;
                    }
                    SPRING1 | DASHPOT1 => (freedom(0).map(|first| Reach::Fixed { first, second: None }), 1.0),
                    SPRING2 | DASHPOT2 => (freedom(0).map(|first| Reach::Fixed { first, second: freedom(1) }), 1.0),
                    _ => {
                        let (reach, length) = line(cell);
                        (Some(reach), length)
                    }
                };
                let Some(reach) = reach else { continue };
                let answer = match section.element.family() {
                    Family::Spring => Answer::Spring(section.magnitude),
                    _ => Answer::Dashpot(section.magnitude),
                };
                let now = if matches!(reach, Reach::Line { .. }) { length } else { 0.0 };
                let damping = Damping::default();
                elements.push(Element {
                    cell,
                    answer,
                    reach,
                    length,
                    mass: 0.0,
                    factor: 1.0,
                    stable: f64::INFINITY,
                    damping,
                    now,
                    viscous: 0.0,
                });
            }
        }
        let mut rotary = Vec::new();
        for section in &structure.rotary {
            for &cell in &section.cells {
                let node = mesh.cell(cell)[0] as usize;
                match freedoms.index(node, 3) {
                    Some(first) => rotary.push((first, section.tensor())),
                    None => masses.extend(freedoms.index(node, 5).map(|f| (f, section.moments[2]))),
                }
            }
        }
        let beams = Beams::new(structure, freedoms);
        Lines { elements, beams, masses, rotary, viscosity, rates: [0.0; 2], stored: 0.0, dissipated: 0.0 }
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

impl Element {
    /// Freedoms it acts on.
    fn freedoms(&self) -> impl Iterator<Item = usize> + '_ {
        let (ranges, second) = match &self.reach {
            Reach::Line { ends, directions, .. } => (ends.map(|end| end..end + directions), None),
            Reach::Fixed { first, second } => ([*first..first + 1, 0..0], *second),
        };
        ranges.into_iter().flatten().chain(second)
    }

    /// Length or elongation [L] at a displacement.
    fn length(&self, u: &[f64]) -> ([f64; 3], f64) {
        match &self.reach {
            Reach::Line { ends: [a, b], directions, line } => {
                let mut now = *line;
                (0..*directions).for_each(|c| now[c] += u[b + c] - u[a + c]);
                (now, norm(now))
            }
            Reach::Fixed { first, second } => ([0.0; 3], u[*first] - second.map_or(0.0, |second| u[second])),
        }
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
            let l0 = element.length;
            let (elastic, stored, viscous) = match element.answer {
                Answer::Truss(ea) => {
                    let of = |l: f64| (l / l0).ln();
                    let free = now * (2.0 * element.mass / (ea * l0)).sqrt();
                    let beta = element.damping.beta;
                    // Of critical: bulk viscosity, and ½ β ω.
                    let xi = self.viscosity + beta / free;
                    element.stable = free * ((1.0 + xi * xi).sqrt() - xi);
                    let stable = raised(element.stable, element.factor, self.viscosity);
                    if stable < advance.stable {
                        (advance.stable, advance.element) = (stable, Some(element.cell));
                    }
                    // Bulk viscosity b ρ c A l̇, and β E A l̇/l.
                    let coefficient =
                        self.viscosity * (2.0 * element.mass * ea / l0).sqrt() + beta * ea * l0 / (now * now);
                    let energy = 0.5 * ea * l0 * (of(now).powi(2) - of(before).powi(2));
                    (ea * l0 / now * of(now), energy, coefficient * rate)
                }
                Answer::Spring(k) => {
                    let rest = if matches!(element.reach, Reach::Line { .. }) { l0 } else { 0.0 };
                    (k * (now - rest), 0.5 * k * (now - before) * (now + before - 2.0 * rest), 0.0)
                }
                Answer::Dashpot(c) => (0.0, 0.0, c * rate),
            };
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

impl Element {
    /// True where its ends meet, and it has no direction.
    fn answer_is_lost(&self, now: f64) -> bool {
        matches!(self.reach, Reach::Line { .. }) && (now <= 0.0 || now.is_nan())
    }
}

fn norm(v: [f64; 3]) -> f64 {
    v.iter().map(|x| x * x).sum::<f64>().sqrt()
}
