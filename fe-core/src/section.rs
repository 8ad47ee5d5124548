//! What elements have beside their nodes: material, cross-section, stiffness.

use crate::element::{ElementType, Family};
use crate::material::Damping;
use fe_mesh::CellId;
use nalgebra::Matrix3;
use std::f64::consts::PI;

/// Solid cells of one element type with one material: a block of like elements.
#[derive(Clone, Debug, PartialEq)]
pub struct Section {
    /// Element type of every cell.
    pub element: ElementType,
    /// The cells, ascending.
    pub cells: Vec<CellId>,
    /// Index into the structure's materials.
    pub material: usize,
    /// Thickness [L] of plane elements; 1 otherwise.
    pub thickness: f64,
    /// Hourglass control of elements with one integration point, where the deck says which.
    pub hourglass: Option<Hourglass>,
}

/// How elements with one integration point resist the motions that do not strain it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Hourglass {
    /// Kind of resistance.
    pub control: HourglassControl,
    /// Factor [-] on the usual resistance, > 0.
    pub scale: f64,
}

/// Kinds of hourglass control: Abaqus Analysis User's Guide, Section controls.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum HourglassControl {
    /// By an assumed strain: exact in bending of elastic bricks.
    Enhanced,
    /// A force against the hourglass displacement.
    Stiffness,
    /// A force against the hourglass velocity.
    Viscous,
}

/// Trusses or beams of one element type with one material and one cross-section.
#[derive(Clone, Debug, PartialEq)]
pub struct LineSection {
    /// Element type of every cell.
    pub element: ElementType,
    /// The cells, ascending.
    pub cells: Vec<CellId>,
    /// What messages call it: the material, or the element set where the section has none.
    pub name: String,
    /// Young's modulus E [F/L²].
    pub young: f64,
    /// Shear modulus G [F/L²].
    pub shear: f64,
    /// Density [M/L³], where given.
    pub density: Option<f64>,
    /// Damping in dynamic steps.
    pub damping: Damping,
    /// Cross-section.
    pub profile: Profile,
    /// Direction of the cross-section's axis 1, of any length; what is along the line is taken out of it.
    pub first_axis: [f64; 3],
}

impl LineSection {
    /// Relative error that rounding may leave in the deflection of beams of a body of this length [L] and so many elements
    /// along it, ε n k L² / E I: k is κ G A of shear-flexible beams, the condition of thin ones (seen on cantilevers of 1
    /// to 64 elements and L / t = 10² to 10⁶ as an upper bound); and E A t(i) t(j), what stretching puts beside bending in
    /// the matrix where the tangent t lies along no axis. Nothing for trusses.
    pub fn rounding(&self, tangents: impl Iterator<Item = [f64; 3]>, length: f64, elements: f64) -> Option<f64> {
        let p = &self.profile;
        let plane = matches!(self.element, ElementType::B21 | ElementType::B23);
        let least = if plane { p.i11 } else { p.i11.min(p.i22) };
        let flexible = matches!(self.element, ElementType::B21 | ElementType::B31);
        let shear = if flexible { p.shear_factor * self.shear * p.area } else { 0.0 };
        let mixed = |[x, y, z]: [f64; 3]| (x * y).abs().max((y * z).abs()).max((z * x).abs());
        let stretching = self.young * p.area * tangents.map(mixed).fold(0.0, f64::max);
        let stiffest = shear.max(stretching) * length * length;
        (self.element.family() == Family::Beam).then(|| f64::EPSILON * elements * stiffest / (self.young * least))
    }
}

/// A cross-section. Axis 2 is the line's direction times axis 1.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Profile {
    /// Area A [L²].
    pub area: f64,
    /// I₁₁ = ∫ x₂² dA [L⁴]: bending about axis 1, with displacement along axis 2.
    pub i11: f64,
    /// I₁₂ = ∫ x₁ x₂ dA [L⁴].
    pub i12: f64,
    /// I₂₂ = ∫ x₁² dA [L⁴].
    pub i22: f64,
    /// Torsion constant J [L⁴].
    pub torsion: f64,
    /// κ [-]: the shear stiffness is κ G A in both directions. Values: Abaqus Analysis User's Guide, Choosing a beam
    /// element, after Cowper, J. Appl. Mech. 33 (1966) 335. Nothing is taken off for slender elements.
    pub shear_factor: f64,
}

impl Profile {
    /// Of a truss.
    pub const fn bar(area: f64) -> Self {
        Profile { area, i11: 0.0, i12: 0.0, i22: 0.0, torsion: 0.0, shear_factor: 0.0 }
    }

    /// A rectangle, a [L] along axis 1, b along axis 2; κ = 0.85. Torsion by Saint-Venant's series (Timoshenko, Goodier,
    /// Theory of Elasticity, 3rd ed., art. 109), c ≤ d the sides:
    /// J = d c³ [1/3 − 64/π⁵ c/d Σ tanh(n π d / 2c) / n⁵], n odd.
    pub fn rectangle(a: f64, b: f64) -> Self {
        let (c, d) = (a.min(b), a.max(b));
        // Terms after n = 999 are below 1e-15 of the first.
        let sum: f64 =
            (0..500).rev().map(|k| f64::from(2 * k + 1)).map(|n| (0.5 * n * PI * d / c).tanh() / n.powi(5)).sum();
        let torsion = d * c.powi(3) * (1.0 / 3.0 - 64.0 / PI.powi(5) * c / d * sum);
        Profile {
            area: a * b,
            i11: a * b.powi(3) / 12.0,
            i12: 0.0,
            i22: b * a.powi(3) / 12.0,
            torsion,
            shear_factor: 0.85,
        }
    }

    /// A circle of radius r [L]; κ = 0.89.
    pub fn circle(r: f64) -> Self {
        Profile { shear_factor: 0.89, ..Self::pipe(r, r) }
    }

    /// A pipe of outer radius r and wall thickness t [L], t ≤ r; κ = 0.53.
    pub fn pipe(r: f64, t: f64) -> Self {
        let inner = r - t;
        let (area, i) = (PI * (r - inner) * (r + inner), 0.25 * PI * (r.powi(4) - inner.powi(4)));
        Profile { area, i11: i, i12: 0.0, i22: i, torsion: 2.0 * i, shear_factor: 0.53 }
    }
}

/// Springs, dashpots or masses of one element type and one magnitude.
#[derive(Clone, Debug, PartialEq)]
pub struct Discrete {
    /// Element type of every cell.
    pub element: ElementType,
    /// The cells, ascending.
    pub cells: Vec<CellId>,
    /// Stiffness [F/L], of rotations [F L]; viscosity [F T/L]; mass [M].
    pub magnitude: f64,
    /// Freedom, from 0, of each of the nodes; those of masses and of elements along their line are not looked at.
    pub components: [u8; 2],
}

/// Rotary inertia of nodes, one tensor for all.
#[derive(Clone, Debug, PartialEq)]
pub struct RotaryInertia {
    /// The cells, ascending.
    pub cells: Vec<CellId>,
    /// I₁₁ = ∫ (x₂² + x₃²) dm, I₂₂, I₃₃ [M L²], in global axes at the start; in the plane I₃₃ alone.
    pub moments: [f64; 3],
    /// Entries I₁₂, I₁₃, I₂₃ of the tensor [M L²], I₁₂ = −∫ x₁ x₂ dm.
    pub products: [f64; 3],
}

impl RotaryInertia {
    /// The tensor.
    pub fn tensor(&self) -> Matrix3<f64> {
        let ([i11, i22, i33], [i12, i13, i23]) = (self.moments, self.products);
        Matrix3::new(i11, i12, i13, i12, i22, i23, i13, i23, i33)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// J of a square is 0.1406 a⁴, of a flat strip a t³/3 (1 − 0.63 t/a), both to the digits the book gives.
    #[test]
    fn torsion_of_rectangles() {
        assert!((Profile::rectangle(2.0, 2.0).torsion / 16.0 - 0.1406).abs() < 5e-5);
        let (a, t) = (100.0, 1.0);
        assert!((Profile::rectangle(a, t).torsion / (a / 3.0 * (1.0 - 0.63 * t / a)) - 1.0).abs() < 1e-4);
        assert_eq!(Profile::rectangle(3.0, 5.0).torsion, Profile::rectangle(5.0, 3.0).torsion);
    }

    #[test]
    fn a_pipe_of_full_wall_is_a_circle() {
        let circle = Profile::circle(2.0);
        assert!((circle.i11 - PI * 16.0 / 4.0).abs() < 1e-13 && (circle.area - 4.0 * PI).abs() < 1e-13);
        assert!((circle.torsion - 8.0 * PI).abs() < 1e-13);
    }
}
