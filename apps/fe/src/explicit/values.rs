//! Values of an explicit job at a moment: fields, tables, histories.

use super::contact_states::{ActingContact, contacts};
use super::scene::Scene;
use crate::contact_fields::{self, Shown};
use crate::fields::mises;
use crate::printed;
use fe_contact::explicit::RigidFollower;
use fe_core::explicit::central_difference::{CentralDifference, State};
use fe_core::explicit::solid::PointState;
use fe_io::Model;
use fe_io::model::{HistoryOfSet, Quantity, Table};
use fe_io::results::table::{ElementRow, Tables};
use fe_io::results::{FieldInfo, ResultsError};
use std::cell::OnceCell;
use std::collections::BTreeMap;

/// A moment of a job.
#[derive(Clone, Copy)]
pub struct Moment<'a> {
    /// The job.
    pub model: &'a Model,
    /// What acts.
    pub scene: &'a Scene,
    /// The state of the motion.
    pub state: &'a State,
    /// The procedure that led to it.
    pub procedure: &'a CentralDifference,
    /// Prescribed freedoms.
    pub fixed: &'a [bool],
}

/// What its results are made of; each is made when something asks for it.
pub struct Values<'a> {
    at: Moment<'a>,
    velocity: OnceCell<Vec<f64>>,
    /// Nodes that follow rigid bodies, with the place of theirs in the scene.
    following: OnceCell<BTreeMap<u32, usize>>,
    states: OnceCell<Vec<PointState>>,
    contacts: OnceCell<Vec<ActingContact<'a>>>,
}

impl<'a> Values<'a> {
    /// At a moment.
    pub fn at(at: Moment<'a>) -> Self {
        let (velocity, following) = (OnceCell::new(), OnceCell::new());
        Values { at, velocity, following, states: OnceCell::new(), contacts: OnceCell::new() }
    }

    /// States of the solids, cells ascending.
    fn states(&self) -> &[PointState] {
        self.states.get_or_init(|| {
            let solids = self.at.scene.solids.iter();
            let mut states: Vec<PointState> = solids.flat_map(|solids| solids.states()).collect();
            states.sort_unstable_by_key(|state| state.cell);
            states
        })
    }

    /// The contacts that act.
    pub fn contacts(&self) -> &[ActingContact<'a>] {
        self.contacts.get_or_init(|| contacts(self.at.model, self.at.scene))
    }

    /// The numbers of a field, `[rows × width]`, NaN where it is not defined.
    pub fn field(&self, field: &FieldInfo) -> Vec<f64> {
        let points = self.at.scene.structure.mesh.points.len();
        match field.name {
            name @ ("U" | "V" | "RF") => (0..points as u32).flat_map(|node| self.vector(node, name)).collect(),
            "S" | "MISES" | "PEEQ" => self.cells(field),
            name => {
                let shown: Vec<Shown> = self.contacts().iter().map(|c| (&c.state, c.nodes.as_slice())).collect();
                contact_fields::values(field, points, &shown)
                    .unwrap_or_else(|| unreachable!("explicit jobs have no {name}"))
            }
        }
    }

    /// Velocities at the end of the increment.
    fn velocity(&self) -> &[f64] {
        self.velocity.get_or_init(|| self.at.procedure.velocity(self.at.state))
    }

    /// The rigid body that a node follows.
    fn followed(&self, node: u32) -> Option<&RigidFollower> {
        let bodies = &self.at.scene.followers;
        let of = |(body, follower): (usize, &RigidFollower)| {
            let others = follower.nodes.iter().filter(|&&node| node != follower.reference);
            others.map(|&node| (node, body)).collect::<Vec<_>>()
        };
        let following = self.following.get_or_init(|| bodies.iter().enumerate().flat_map(of).collect());
        following.get(&node).map(|&body| &bodies[body])
    }

    /// U, V or RF of a node; what follows a rigid body has no forces of its own.
    fn vector(&self, node: u32, name: &str) -> [f64; 3] {
        let Moment { scene, state, fixed, .. } = self.at;
        if let Some(body) = self.followed(node).filter(|_| name != "RF") {
            let [u, v] = body.carried(node, (&scene.structure, &scene.freedoms), [&state.u, self.velocity()]);
            return if name == "U" { u } else { v };
        }
        let of = |f: usize| match name {
            "U" => state.u[f],
            "V" => self.velocity()[f],
            _ if fixed[f] => -state.force[f],
            _ => 0.0,
        };
        std::array::from_fn(|c| scene.freedoms.index(node as usize, c).map_or(0.0, of))
    }

    fn cells(&self, field: &FieldInfo) -> Vec<f64> {
        let (mesh, width) = (&self.at.scene.structure.mesh, field.width());
        let first = mesh.first_cells();
        let mut out = vec![f64::NAN; width * mesh.cell_count()];
        for state in self.states() {
            let place = width * (first[state.cell.block as usize] + state.cell.cell as usize);
            out[place..place + width].copy_from_slice(&of_element(state, field.name));
        }
        out
    }

    /// A field at the nodes of a set: all of the first node, then of the next.
    pub fn at_nodes(&self, of: &HistoryOfSet) -> Vec<f64> {
        let nodes = self.at.scene.structure.mesh.node_sets.get(&of.set).map_or(&[][..], Vec::as_slice);
        nodes.iter().flat_map(|&node| chosen(&self.vector(node, of.field), of.component)).collect()
    }

    /// A field at the elements of a set, NaN where an element has none.
    pub fn at_elements(&self, of: &HistoryOfSet) -> Vec<f64> {
        let cells = self.at.scene.structure.mesh.cell_sets.get(&of.set).map_or(&[][..], Vec::as_slice);
        let mut out = Vec::new();
        for cell in cells {
            match self.states().binary_search_by_key(cell, |state| state.cell) {
                Ok(at) => out.extend(chosen(&of_element(&self.states()[at], of.field), of.component)),
                Err(_) => out.extend(vec![f64::NAN; components(of).len()]),
            }
        }
        out
    }

    /// Prints a table.
    pub fn print(&self, table: &Table, tables: &mut Tables) -> Result<(), ResultsError> {
        let (mesh, time) = (&self.at.scene.structure.mesh, self.at.state.total_time);
        let nodes = mesh.node_sets.get(&table.set).map_or(&[][..], Vec::as_slice);
        let labels: Vec<u64> = nodes.iter().map(|&n| mesh.point_labels[n as usize]).collect();
        let vectors = |name: &str| nodes.iter().map(|&n| self.vector(n, name)).collect::<Vec<_>>();
        match &table.quantity {
            Quantity::Displacement => tables.displacements(&table.set, time, &labels, &vectors("U")),
            Quantity::Velocity => tables.velocities(&table.set, time, &labels, &vectors("V")),
            Quantity::Reaction => tables.reactions(&table.set, time, &labels, &vectors("RF"), table.totals),
            Quantity::Stress => {
                let cells = mesh.cell_sets.get(&table.set).map_or(&[][..], Vec::as_slice);
                let of_set = self.states().iter().filter(|state| cells.binary_search(&state.cell).is_ok());
                let row = |state: &PointState| ElementRow {
                    element: mesh.cell_label(state.cell),
                    point: 1,
                    values: state.stress,
                };
                tables.stresses(&table.set, time, &of_set.map(row).collect::<Vec<_>>())
            }
            // Explicit steps have none: the reader refuses them.
            Quantity::Strain => Ok(()),
            contact => {
                let contacts: Vec<_> = self.contacts().iter().map(|c| (c.surfaces, &c.state)).collect();
                printed::contact(tables, contact, (mesh, time), &contacts)
            }
        }
    }
}

/// S, MISES or PEEQ of an element.
fn of_element(state: &PointState, name: &str) -> Vec<f64> {
    match name {
        "S" => state.stress.to_vec(),
        "MISES" => vec![mises(&state.stress)],
        _ => vec![state.plastic],
    }
}

fn chosen(values: &[f64], component: Option<usize>) -> Vec<f64> {
    component.map_or_else(|| values.to_vec(), |c| vec![values[c]])
}

/// Names of the components that a history holds of each node or element: `U1`.
pub fn components(of: &HistoryOfSet) -> Vec<String> {
    let all: &[&str] = match of.field {
        "U" | "V" | "RF" => &["1", "2", "3"],
        "S" => &["11", "22", "33", "12", "23", "13"],
        _ => &[""],
    };
    let chosen = of.component.map_or(all, |c| &all[c..=c]);
    chosen.iter().map(|component| format!("{}{component}", of.field)).collect()
}
