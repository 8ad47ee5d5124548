//! What bodies of these studies have in common.

use fe_contact::explicit::{Behaviour, Normal, Separation};
use fe_contact::facet::{Facet, Vec3};
use fe_contact::viscous::ExplicitDamping;
use fe_core::Freedoms;
use fe_core::explicit::solid::{Hourglass, SolidSection, Solids};
use fe_core::material::{Damping, Response};
use fe_core::structure::Structure;
use fe_mesh::{CellId, exterior};

/// All cells of a structure whose elements are alike, of one material with its density [M/L³], with both parts of bulk
/// viscosity [-].
pub fn solids(
    structure: &Structure,
    freedoms: &Freedoms,
    (response, density): (&Response, f64),
    viscosity: [f64; 2],
) -> Solids {
    let cells: Vec<CellId> = structure.mesh.cells().collect();
    let section = SolidSection {
        element: structure.elements[0],
        cells: &cells,
        response,
        density,
        thickness: 1.0,
        damping: Damping::default(),
        hourglass: Hourglass::Enhanced(1.0),
        viscosity,
    };
    Solids::new(structure, freedoms, &[section])
}

/// Nodes of each outer face, seen from outside.
pub fn outer_faces(structure: &Structure) -> Vec<Vec<u32>> {
    let nodes = |face| Facet::new(structure, face, None, &Vec3::zeros()).nodes().to_vec();
    exterior(&structure.mesh).into_iter().map(nodes).collect()
}

/// Hard contact without friction.
pub fn hard(damping: Option<ExplicitDamping>) -> Behaviour {
    Behaviour { normal: Normal::Hard, separation: Separation::Allowed, friction: None, shear_slope: None, damping }
}
