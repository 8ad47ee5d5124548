//! Integration points of the element types, and the shape functions there.

use crate::element::ElementType::{self, *};
use fe_mesh::quadrature::Rule;
use fe_mesh::shape;

/// Largest number of volumetric modes of an element.
pub(super) const VOLUMETRIC: usize = 4;

/// The integration points of an element type: 2 a direction on squares and cubes, 4 in the quadratic
/// tetrahedron, 3 in the axisymmetric triangle (one alone would let it turn freely), else 1.
pub(super) fn rule(element: ElementType) -> Rule {
    match element {
        C3D10 | CAX3 => Rule::of(element.kind(), 2),
        C3D8 | CPE4 | CPS4 | CAX4 => Rule::of(element.kind(), 3),
        C3D4 | CPE3 | CPS3 => Rule::of(element.kind(), 1),
    }
}

/// Shape functions of `N` nodes at `P` integration points.
pub(super) struct Tables<const N: usize, const P: usize> {
    /// Points ξ.
    pub points: [[f64; 3]; P],
    /// Weights on the reference cell.
    pub weights: [f64; P],
    /// Values N_a.
    pub values: [[f64; N]; P],
    /// Derivatives ∂N_a/∂ξ_i.
    pub gradients: [[[f64; 3]; N]; P],
    /// Derivatives at the centroid.
    pub central: [[f64; 3]; N],
    /// ξη, ηζ, ζξ, ξηζ: the volumetric modes of the cube; a square uses the first.
    pub volumetric: [[f64; VOLUMETRIC]; P],
}

impl<const N: usize, const P: usize> Tables<N, P> {
    /// Of an element type with `N` nodes and `P` points.
    pub fn new(element: ElementType) -> Self {
        let (kind, rule) = (element.kind(), rule(element));
        let mut tables = Tables {
            points: [[0.0; 3]; P],
            weights: [0.0; P],
            values: [[0.0; N]; P],
            gradients: [[[0.0; 3]; N]; P],
            central: [[0.0; 3]; N],
            volumetric: [[0.0; VOLUMETRIC]; P],
        };
        shape::gradients(kind, &shape::centroid(kind), &mut tables.central);
        for (p, &(xi, weight)) in rule.points.iter().enumerate() {
            tables.points[p] = xi;
            tables.weights[p] = weight;
            shape::values(kind, &xi, &mut tables.values[p]);
            shape::gradients(kind, &xi, &mut tables.gradients[p]);
            tables.volumetric[p] = [xi[0] * xi[1], xi[1] * xi[2], xi[2] * xi[0], xi[0] * xi[1] * xi[2]];
        }
        tables
    }
}
