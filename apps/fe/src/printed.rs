//! The printed tables of a step: values for the `.dat` file.

use crate::fields::Source;
use fe_contact::point::ContactStatus;
use fe_contact::state::{ContactState, PointState};
use fe_contact::summary::Origin;
use fe_core::element::Family;
use fe_io::model::{ForcePart, Quantity, Table};
use fe_io::results::ResultsError;
use fe_io::results::table::{ContactRow, ElementRow, PairForce, Tables};
use fe_mesh::{CellId, Mesh};
use std::path::Path;

/// The `.dat` file of a job; it exists once something is printed.
pub struct Printed {
    tables: Tables,
}

/// A table needs stresses or strains.
pub fn needs_recovery(table: &Table) -> bool {
    matches!(table.quantity, Quantity::Stress | Quantity::Strain)
}

impl Printed {
    /// Creates the file.
    pub fn create(path: &Path) -> Result<Self, ResultsError> {
        Ok(Printed { tables: Tables::create(path)? })
    }

    /// Prints the tables of an increment.
    pub fn tables(&mut self, source: &Source, tables: &[&Table]) -> Result<(), ResultsError> {
        for table in tables {
            self.table(source, table)?;
        }
        self.tables.flush()
    }

    fn table(&mut self, source: &Source, table: &Table) -> Result<(), ResultsError> {
        let time = source.at.total_time;
        let at = source.at;
        match &table.quantity {
            Quantity::Displacement => {
                let (labels, values) = nodal(source, &table.set, |f| at.u[f]);
                self.tables.displacements(&table.set, time, &labels, &values)
            }
            // Static steps have none: the reader refuses them.
            Quantity::Velocity => Ok(()),
            Quantity::Reaction => {
                let reaction = |f: usize| if source.fixed[f] { at.residual[f] } else { 0.0 };
                let (labels, values) = nodal(source, &table.set, reaction);
                self.tables.reactions(&table.set, time, &labels, &values, table.totals)
            }
            Quantity::Stress => self.tables.stresses(&table.set, time, &elements(source, table)),
            Quantity::Strain => self.tables.strains(&table.set, time, &elements(source, table)),
            Quantity::ContactStress | Quantity::ContactDisplacement | Quantity::ContactForce { .. } => {
                let contacts = source.terms.contacts.iter().zip(source.states);
                let contacts: Vec<_> = contacts.map(|(contact, state)| (contact.surfaces(), state)).collect();
                contact(&mut self.tables, &table.quantity, (&source.terms.structure.mesh, time), &contacts)
            }
        }
    }
}

/// Prints what contacts do, each with the names of its surfaces: the values of all that are closed, or resultants.
pub fn contact(
    tables: &mut Tables,
    quantity: &Quantity,
    (mesh, time): (&Mesh, f64),
    contacts: &[((&str, &str), &ContactState)],
) -> Result<(), ResultsError> {
    let states = || contacts.iter().map(|contact| contact.1);
    match quantity {
        Quantity::ContactStress => tables.contact_stresses(time, &closed(mesh, states(), |p| (p.pressure, p.shear))),
        Quantity::ContactDisplacement => {
            tables.contact_displacements(time, &closed(mesh, states(), |p| (p.opening, p.slip)))
        }
        Quantity::ContactForce { pair, part } => {
            let wanted = |(secondary, main): (&str, &str)| {
                pair.as_ref().is_none_or(|names| [secondary, main] == [names[0].as_str(), names[1].as_str()])
            };
            for (surfaces, state) in contacts.iter().filter(|contact| wanted(contact.0)) {
                tables.contact_force(surfaces.0, surfaces.1, time, &pair_force(state, *part))?;
            }
            Ok(())
        }
        _ => Ok(()),
    }
}

/// Labels and translations of a vector over the freedoms, for the nodes of a set.
fn nodal(source: &Source, set: &str, value: impl Fn(usize) -> f64) -> (Vec<u64>, Vec<[f64; 3]>) {
    let (mesh, freedoms) = (&source.terms.structure.mesh, &source.terms.freedoms);
    let nodes = mesh.node_sets.get(set).map_or(&[][..], Vec::as_slice);
    let vector = |&n: &u32| -> [f64; 3] { std::array::from_fn(|c| freedoms.index(n as usize, c).map_or(0.0, &value)) };
    (nodes.iter().map(|&n| mesh.point_labels[n as usize]).collect(), nodes.iter().map(vector).collect())
}

/// Stress or strain at the integration points of the solids and trusses of a set; those of trusses, along the line, in the
/// first column.
fn elements(source: &Source, table: &Table) -> Vec<ElementRow> {
    let mesh = &source.terms.structure.mesh;
    let cells = mesh.cell_sets.get(&table.set).map_or(&[][..], Vec::as_slice);
    let mut rows = contact_elements(source, table, cells);
    let Some(recovered) = source.recovered else { return rows };
    for (block, fields) in source.terms.solids.iter().zip(&recovered.blocks) {
        let values = if table.quantity == Quantity::Stress { &fields.stress } else { &fields.strain };
        let n = block.points();
        for (i, cell) in block.cells().iter().enumerate().filter(|(_, cell)| cells.binary_search(cell).is_ok()) {
            let element = mesh.cell_label(*cell);
            let points = values[i * n..(i + 1) * n].iter().zip(1..);
            rows.extend(points.map(|(values, point)| ElementRow { element, point, values: *values }));
        }
    }
    for (members, states) in
        source.terms.members.iter().zip(&recovered.trusses).filter(|(_, states)| !states.is_empty())
    {
        let n = members.points();
        for (i, cell) in members.cells().iter().enumerate().filter(|(_, cell)| cells.binary_search(cell).is_ok()) {
            let element = mesh.cell_label(*cell);
            for (state, point) in states[i * n..(i + 1) * n].iter().zip(1..) {
                let value = if table.quantity == Quantity::Stress { state.stress } else { state.strain };
                rows.push(ElementRow { element, point, values: [value, 0.0, 0.0, 0.0, 0.0, 0.0] });
            }
        }
    }
    rows
}

/// What the contact elements of a set do: the normal force over the area, or the gap (of tubes the overclosure), as 11; shear
/// or slip as 12 and 13.
fn contact_elements(source: &Source, table: &Table, cells: &[CellId]) -> Vec<ElementRow> {
    let mesh = &source.terms.structure.mesh;
    let mut rows = Vec::new();
    for (contact, state) in source.terms.contacts.iter().zip(source.states) {
        let of_set = contact.cells.iter().zip(&state.points).filter(|(cell, _)| cells.binary_search(cell).is_ok());
        let tubes = matches!(contact.summary().origin, Origin::Elements(element) if element.family() == Family::Tube);
        rows.extend(of_set.map(|(cell, point)| {
            let strain = if tubes { -point.opening } else { point.opening };
            let stress = table.quantity == Quantity::Stress;
            let (normal, [one, other]) = if stress { (point.pressure, point.shear) } else { (strain, point.slip) };
            ElementRow { element: mesh.cell_label(*cell), point: 1, values: [normal, 0.0, 0.0, one, 0.0, other] }
        }));
    }
    rows
}

/// What acts across and along the constraints that are closed, or damped while they are open, pair by pair.
fn closed<'a>(
    mesh: &Mesh,
    states: impl Iterator<Item = &'a ContactState>,
    value: impl Fn(&PointState) -> (f64, [f64; 2]),
) -> Vec<ContactRow> {
    let acts = |p: &&PointState| p.status != ContactStatus::Open || p.pressure != 0.0;
    let row = |p: &PointState| {
        let (across, [one, other]) = value(p);
        ContactRow { node: mesh.point_labels[p.node as usize], values: [across, one, other] }
    };
    states.flat_map(|state| &state.points).filter(acts).map(row).collect()
}

/// The resultant of a pair on its secondary side; without friction the normal part is all of it.
fn pair_force(state: &ContactState, part: ForcePart) -> PairForce {
    let (force, moment) = match (part, &state.secondary_shear) {
        (ForcePart::Total, _) => state.total(),
        (ForcePart::Normal, _) => (state.secondary.force, state.secondary.moment),
        (ForcePart::Shear, Some(shear)) => (shear.force, shear.moment),
        (ForcePart::Shear, None) => return PairForce::default(),
    };
    let (center, normal) = (state.center, state.normal);
    let normal_force: f64 = (0..3).map(|c| force[c] * normal[c]).sum();
    let along = (0..3).map(|c| (force[c] - normal_force * normal[c]).powi(2)).sum::<f64>().sqrt();
    let shear_force = if part == ForcePart::Normal || state.secondary_shear.is_none() { 0.0 } else { along };
    PairForce { force, moment, center, normal, area: state.closed_area, normal_force, shear_force }
}
