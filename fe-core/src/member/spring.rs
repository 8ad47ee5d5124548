//! Springs: one strain, the displacement [L] or rotation between their ends.

use super::{Defect, along};
use crate::element::ElementType::{SPRING1, SPRING2};
use crate::structure::Discrete;
use fe_mesh::{CellId, Mesh};

/// Rates of the stretch with the freedoms of each node. SPRING1: u of the node; SPRING2: u of the first less that of the
/// second; SPRINGA: n·(u₂ − u₁), n the direction of the line as it lies at the start.
/// Source: Abaqus Analysis User's Guide, Springs.
pub(super) fn rates(mesh: &Mesh, section: &Discrete, cell: CellId) -> Result<Vec<[f64; 6]>, Defect> {
    let unit = |component: u8, value: f64| {
        let mut rates = [0.0; 6];
        rates[usize::from(component)] = value;
        rates
    };
    let [first, second] = section.components;
    match section.element {
        SPRING1 => Ok(vec![unit(first, 1.0)]),
        SPRING2 => Ok(vec![unit(first, 1.0), unit(second, -1.0)]),
        _ => {
            let [a, b] = [0, 1].map(|i| &mesh.points[mesh.cell(cell)[i] as usize]);
            let ([x, y, z], _) = along(a, b)?;
            Ok(vec![[-x, -y, -z, 0.0, 0.0, 0.0], [x, y, z, 0.0, 0.0, 0.0]])
        }
    }
}
