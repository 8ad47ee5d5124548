//! Decks with their nodes and elements in them, in any order.

use crate::cards::Digits;
pub use crate::cards::Order;
use fe_core::element::ElementType;
use fe_mesh::Mesh;

/// A mesh as cards whose numbers are read as the same bits.
pub fn cards(mesh: &Mesh, elements: &[(&str, ElementType)], order: Order) -> String {
    crate::cards::mesh(mesh, elements, order, Digits::All)
}

/// An elastic material of all these element sets.
pub fn elastic(sets: &[&str], young: f64, poisson: f64) -> String {
    material("ELASTIC", sets, young, poisson)
}

/// The same with a name.
pub fn material(name: &str, sets: &[&str], young: f64, poisson: f64) -> String {
    let sections: String = sets.iter().map(|set| format!("*SOLID SECTION, ELSET={set}, MATERIAL={name}\n")).collect();
    format!("*MATERIAL, NAME={name}\n*ELASTIC\n{young:e}, {poisson:e}\n{sections}")
}

/// Prescribed displacements of a node, as data lines of `*BOUNDARY`, with a value for each direction.
pub fn prescribed(label: u64, u: &[f64]) -> String {
    u.iter().zip(1..).map(|(u, c)| format!("{label}, {c}, {c}, {u:e}\n")).collect()
}
