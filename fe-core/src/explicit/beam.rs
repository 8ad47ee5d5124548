//! Shear-flexible beams with large displacements and rotations: B21 and B31.
//!
//! A node turns its cross-section by R. In the middle of an element stands R_m = R₁ exp(½ ψ), ψ = log(R₁ᵀ R₂); the strains are
//! Γ = R_mᵀ (x₂ − x₁)/L − t and ψ/L in the axes of the section: those of static steps (`member::beam`), with one integration
//! point, and none of any rigid motion (Simo, Comput. Methods Appl. Mech. Engng 49 (1985) 55; Crisfield, Jelenić, Proc. R. Soc.
//! Lond. A 455 (1999) 1125). Forces and moments are the derivatives of the energy ½ L (Γ·N + ψ/L·M).

use super::mass_scaling::raised;
use super::{Advance, Moving};
use crate::element::ElementType;
use crate::freedoms::Freedoms;
use crate::material::Damping;
use crate::member::beam;
use crate::structure::{LineSection, Structure};
use fe_mesh::CellId;
use nalgebra::{Matrix3, Rotation3, UnitQuaternion, Vector3};

type Vec3 = Vector3<f64>;

/// Moduli of a section.
#[derive(Clone, Debug, PartialEq)]
struct Moduli {
    /// Diagonal of N = C Γ [F]: E A, κ G A, κ G A.
    forces: Vec3,
    /// M = D ψ/L [F L²].
    moments: Matrix3<f64>,
    damping: Damping,
}

impl Moduli {
    fn new(section: &LineSection) -> Self {
        // Of the strains ε₀, κ₁, κ₂, φ, γ₁, γ₂.
        let d = beam::moduli(section);
        let of = |i: usize, k: usize| d[6 * i + k];
        let moments = Matrix3::from_fn(|i, k| of([3, 1, 2][i], [3, 1, 2][k]));
        Moduli { forces: Vec3::new(of(0, 0), of(4, 4), of(5, 5)), moments, damping: section.damping }
    }
}

#[derive(Clone, Debug, PartialEq)]
struct Element {
    cell: CellId,
    /// Index into the moduli.
    moduli: usize,
    /// Freedoms of both nodes.
    ends: [[Option<usize>; 6]; 2],
    /// From the first node to the second at the start [L].
    line: Vec3,
    /// Axes t, 1, 2 at the start.
    axes: UnitQuaternion<f64>,
    length: f64,
    /// Half of its mass [M], and the moment of inertia of each node [M L²].
    mass: f64,
    inertia: f64,
    /// Factor on both.
    factor: f64,
    /// Stable increment [T] by itself, without the factor.
    stable: f64,
    /// Highest frequency [1/T] of the straight element.
    omega: f64,
    /// Strains Γ and ψ/L at the end of the last increment, and forces and moments of viscosity then.
    strains: [Vec3; 2],
    viscous: [Vec3; 2],
}

/// All beams of a scene.
#[derive(Clone, Debug, Default)]
pub(super) struct Beams {
    moduli: Vec<Moduli>,
    elements: Vec<Element>,
    /// Energy [F L] that they hold, and that viscosity has dissipated.
    pub energies: [f64; 2],
}

/// True for the beams of explicit steps.
pub fn has(element: ElementType) -> bool {
    matches!(element, ElementType::B21 | ElementType::B31)
}

/// Moment of inertia [M L²] of each node of an element, about all axes, and its highest frequency [1/T]: that of stretching, 2c/L,
/// or √2 times that of shearing with held rotations where that is higher. The moment of inertia is the least by which neither bending,
/// twisting nor shearing is faster: ω² = 2 E I/(L j), 2 G J/(L j) and 4 κ G/(ρ L²) + κ G A L/(2 j) with half of the mass
/// at each node; it is at least that of the section, ρ I L/2. What it adds is of the order of the error of the elements, m L².
fn rotary(moduli: &Moduli, mass: f64, length: f64) -> (f64, f64) {
    let [stretch, shear] = [moduli.forces[0], moduli.forces[1]].map(|k| 2.0 * k / (mass * length));
    let square = stretch.max(2.0 * shear);
    let bending = 2.0 * moduli.moments.symmetric_eigenvalues().max() / (length * square);
    let shearing = 0.5 * moduli.forces[1] * length / (square - shear);
    (bending.max(shearing), square.sqrt())
}

impl Beams {
    pub fn new(structure: &Structure, freedoms: &Freedoms) -> Self {
        let mut beams = Beams::default();
        for section in structure.lines.iter().filter(|section| has(section.element)) {
            let moduli = Moduli::new(section);
            for &cell in &section.cells {
                let nodes = structure.mesh.cell(cell);
                let x = [0, 1].map(|i| structure.mesh.points[nodes[i] as usize]);
                let Ok((axes, length)) = beam::axes(x, section.first_axis) else { continue };
                let mass = 0.5 * section.density.unwrap_or(0.0) * section.profile.area * length;
                let (inertia, omega) = rotary(&moduli, mass, length);
                let axes = Matrix3::from_columns(&axes.map(Vec3::from));
                beams.elements.push(Element {
                    cell,
                    moduli: beams.moduli.len(),
                    ends: [0, 1].map(|i| std::array::from_fn(|c| freedoms.index(nodes[i] as usize, c))),
                    line: Vec3::from(x[1]) - Vec3::from(x[0]),
                    axes: UnitQuaternion::from_rotation_matrix(&Rotation3::from_matrix_unchecked(axes)),
                    length,
                    mass,
                    inertia,
                    factor: 1.0,
                    stable: f64::INFINITY,
                    omega,
                    strains: [Vec3::zeros(); 2],
                    viscous: [Vec3::zeros(); 2],
                });
            }
            beams.moduli.push(moduli);
        }
        beams
    }

    pub fn is_empty(&self) -> bool {
        self.elements.is_empty()
    }

    pub fn add_mass(&self, mass: &mut [f64]) {
        self.elements.iter().for_each(|element| element.add(mass, element.factor));
    }

    pub fn add_mass_damping(&self, damping: &mut [f64]) {
        self.elements.iter().for_each(|element| element.add(damping, self.moduli[element.moduli].damping.alpha));
    }

    pub fn scale(&mut self, factor: &dyn Fn(CellId) -> f64) {
        self.elements.iter_mut().for_each(|element| element.factor = factor(element.cell));
    }

    pub fn increments(&self) -> impl Iterator<Item = (CellId, f64)> + '_ {
        self.elements.iter().map(|element| (element.cell, element.stable))
    }

    /// Moves on to the end of an increment; `viscosity` is the linear bulk viscosity [-].
    pub fn advance(&mut self, at: &Moving, viscosity: f64, forces: &mut [f64]) -> Advance {
        let mut advance = Advance::default();
        for element in &mut self.elements {
            let moduli = &self.moduli[element.moduli];
            let [stored, dissipated] = element.advance((moduli, viscosity), at, forces);
            let stable = raised(element.stable, element.factor, viscosity);
            if stable < advance.stable {
                (advance.stable, advance.element) = (stable, Some(element.cell));
            }
            self.energies[0] += stored;
            self.energies[1] += dissipated;
        }
        advance
    }
}

/// An element as it is bent: the middle of it.
struct Bent {
    /// R_m.
    axes: Matrix3<f64>,
    /// Γ + t, and ψ.
    stretch: Vec3,
    bend: Vec3,
}

impl Element {
    /// Adds masses and moments of inertia times a factor to the freedoms.
    fn add(&self, mass: &mut [f64], factor: f64) {
        for end in &self.ends {
            for (c, freedom) in end.iter().enumerate() {
                let own = if c < 3 { self.mass } else { self.inertia };
                freedom.iter().for_each(|&f| mass[f] += factor * own);
            }
        }
    }

    fn bent(&self, u: &[f64]) -> Bent {
        let of = |end: usize, first: usize| Vec3::from_fn(|c, _| self.ends[end][first + c].map_or(0.0, |f| u[f]));
        let [first, second] = [0, 1].map(|end| UnitQuaternion::new(of(end, 3)) * self.axes);
        let bend = (first.inverse() * second).scaled_axis();
        let axes = *(first * UnitQuaternion::new(0.5 * bend)).to_rotation_matrix().matrix();
        let line = self.line + of(1, 0) - of(0, 0);
        Bent { stretch: axes.tr_mul(&line) / self.length, axes, bend }
    }

    /// Energies [F L] stored and dissipated.
    fn advance(&mut self, (moduli, xi): (&Moduli, f64), at: &Moving, forces: &mut [f64]) -> [f64; 2] {
        let bent = self.bent(at.u);
        let strains = [bent.stretch - Vec3::x(), bent.bend / self.length];
        let elastic = |of: [Vec3; 2]| [moduli.forces.component_mul(&of[0]), moduli.moments * of[1]];
        let energy = |of: [Vec3; 2]| 0.5 * self.length * (of[0].dot(&elastic(of)[0]) + of[1].dot(&elastic(of)[1]));
        let stored = energy(strains) - energy(self.strains);
        let more = [0, 1].map(|i| strains[i] - self.strains[i]);
        let mut viscous = [Vec3::zeros(); 2];
        if at.dt > 0.0 {
            let rates = more.map(|more| more / at.dt);
            viscous = elastic(rates).map(|force| force * moduli.damping.beta);
            // Bulk viscosity b ρ c A l̇.
            viscous[0].x += xi * (2.0 * self.mass * moduli.forces[0] * self.length).sqrt() * rates[0].x;
        }
        let way = |i: usize| (self.viscous[i] + viscous[i]).dot(&more[i]);
        let dissipated = 0.5 * self.length * (way(0) + way(1));
        let [force, moment] = elastic(strains);
        self.push(&bent, [force + viscous[0], moment + viscous[1]], forces);
        (self.strains, self.viscous) = (strains, viscous);
        // Forces turn with the element: what that adds is to the moduli as the strains are to 1.
        let omega = self.omega * (1.0 + strains[0].norm() + bent.bend.norm_squared()).sqrt();
        let xi = xi + 0.5 * moduli.damping.beta * omega;
        self.stable = 2.0 / omega * ((1.0 + xi * xi).sqrt() - xi);
        [stored, dissipated]
    }

    /// Adds what N and M, in the axes of the middle, do to the nodes.
    ///
    /// With Ψ = ½ ψ and a spin of the nodes a₁, a₂ in these axes, the middle spins with ½ (a₁ + a₂) − A δΨ,
    /// A = (1 − cos Ψ)/Ψ² Ψ×, and δΨ = ½ S⁻¹ (a₂ − a₁): S is 1 along Ψ and sin Ψ/Ψ across.
    fn push(&self, bent: &Bent, [force, moment]: [Vec3; 2], forces: &mut [f64]) {
        let half = 0.5 * bent.bend;
        let angle = half.norm();
        let (part, across) = if angle < 1e-4 {
            let square = angle * angle;
            (0.5 - square / 24.0, 1.0 + square / 6.0)
        } else {
            ((1.0 - angle.cos()) / (angle * angle), angle / angle.sin())
        };
        let turning = bent.stretch.cross(&force) * self.length;
        let both = moment - half.cross(&turning) * (0.5 * part);
        let along = if angle > 0.0 { half * (half.dot(&both) / (angle * angle)) } else { Vec3::zeros() };
        let couple = along + (both - along) * across;
        let pull = bent.axes * force;
        for (end, sign) in [(0, 1.0), (1, -1.0)] {
            let turn = bent.axes * (couple * sign + turning * 0.5);
            for c in 0..3 {
                for (freedom, value) in [(self.ends[end][c], sign * pull[c]), (self.ends[end][c + 3], turn[c])] {
                    freedom.iter().for_each(|&f| forces[f] += value);
                }
            }
        }
    }
}

#[cfg(test)]
mod tests;
