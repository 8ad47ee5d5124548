//! Integration points of the element types, and the shape functions there.

use crate::element::ElementType::{self, *};
use fe_mesh::quadrature::Rule;
use fe_mesh::shape;

/// Number of the functions ξη, ηζ, ζξ, ξηζ; a square uses the first.
pub(super) const PRODUCTS: usize = 4;

/// ξη, ηζ, ζξ, ξηζ: the hourglass shapes, and the volumetric modes.
fn products([x, y, z]: [f64; 3]) -> [f64; PRODUCTS] {
    [x * y, y * z, z * x, x * y * z]
}

/// Their derivatives.
fn product_gradients([x, y, z]: [f64; 3]) -> [[f64; 3]; PRODUCTS] {
    [[y, x, 0.0], [0.0, z, y], [z, 0.0, x], [y * z, z * x, x * y]]
}

/// The integration points of an element type: 2 a direction on squares and cubes, 4 in the quadratic
/// tetrahedron, 3 in the axisymmetric triangle (one alone would let it turn freely), else 1.
pub(super) fn rule(element: ElementType) -> Rule {
    match element {
        C3D10 | CAX3 => Rule::of(element.kind(), 2),
        C3D8 | CPE4 | CPS4 | CAX4 => Rule::of(element.kind(), 3),
        _ => Rule::of(element.kind(), 1),
    }
}

/// Shape functions of `N` nodes at `P` integration points.
#[derive(Debug)]
pub(crate) struct Tables<const N: usize, const P: usize> {
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
    /// ξη, ηζ, ζξ, ξηζ at the points.
    pub products: [[f64; PRODUCTS]; P],
    /// Their derivatives there.
    pub product_gradients: [[[f64; 3]; PRODUCTS]; P],
    /// ξη, ηζ, ζξ, ξηζ at the nodes.
    pub hourglass: [[f64; PRODUCTS]; N],
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
            products: [[0.0; PRODUCTS]; P],
            product_gradients: [[[0.0; 3]; PRODUCTS]; P],
            hourglass: std::array::from_fn(|a| products(shape::nodes(kind)[a])),
        };
        shape::gradients(kind, &shape::centroid(kind), &mut tables.central);
        for (p, &(xi, weight)) in rule.points.iter().enumerate() {
            tables.points[p] = xi;
            tables.weights[p] = weight;
            shape::values(kind, &xi, &mut tables.values[p]);
            shape::gradients(kind, &xi, &mut tables.gradients[p]);
            tables.products[p] = products(xi);
            tables.product_gradients[p] = product_gradients(xi);
        }
        tables
    }
}
