//! What acts between nodes, edges and faces: the table of a definition, ready for use.

use super::definition::{Acting, Between, GeneralDefinition};
use super::surface::Surface;
use crate::explicit::behaviour::{Behaviour, Normal};

#[derive(Debug)]
pub(super) struct Table {
    /// Between a set of classes and a class.
    by_set: Vec<Vec<Between>>,
    /// Between two sets.
    by_sets: Vec<Vec<Between>>,
    pub behaviours: Vec<Behaviour>,
    pub scales: Vec<f64>,
    /// Largest clearance [L] at which some law presses.
    pub reach: f64,
    /// True where some law may be as steep as it likes: stiffness of hard contact suits the increments.
    pub may_be_stiff: bool,
}

/// Both: an exclusion holds; where both act, the later behaviour and the later factor.
fn both(a: Between, b: Between) -> Between {
    match (a, b) {
        (Between::Excluded, _) | (_, Between::Excluded) => Between::Excluded,
        (Between::Acting(a), Between::Acting(b)) => {
            Between::Acting(Acting { behaviour: a.behaviour.max(b.behaviour), scale: a.scale.max(b.scale) })
        }
        (Between::Nothing, other) | (other, Between::Nothing) => other,
    }
}

fn acting(between: Between) -> Option<Acting> {
    if let Between::Acting(acting) = between { Some(acting) } else { None }
}

impl Table {
    pub fn new(definition: &GeneralDefinition, surface: &Surface) -> Self {
        let classes = definition.table.len();
        let of_set = |set: &Vec<u16>, class: usize| {
            set.iter().map(|&c| definition.table[usize::from(c)][class]).fold(Between::Nothing, both)
        };
        let sets = &surface.class_sets;
        let by_set: Vec<Vec<_>> = sets.iter().map(|set| (0..classes).map(|c| of_set(set, c)).collect()).collect();
        let of_sets =
            |row: &[Between], set: &[u16]| set.iter().map(|&c| row[usize::from(c)]).fold(Between::Nothing, both);
        let by_sets = by_set.iter().map(|row| sets.iter().map(|set| of_sets(row, set)).collect()).collect();
        let reach = |behaviour: &Behaviour| match &behaviour.normal {
            Normal::Softened(law) => law.reach(),
            Normal::Hard | Normal::ScaleFactor { .. } => 0.0,
        };
        Table {
            by_set,
            by_sets,
            behaviours: definition.behaviours.clone(),
            scales: definition.scales.clone(),
            reach: definition.behaviours.iter().map(reach).fold(0.0, f64::max),
            may_be_stiff: definition.behaviours.iter().any(|behaviour| !matches!(behaviour.normal, Normal::Hard)),
        }
    }

    /// Between a node of a set of classes and a face of a class.
    pub fn of_face(&self, set: u16, class: u16) -> Option<Acting> {
        acting(self.by_set[usize::from(set)][usize::from(class)])
    }

    /// Between edges of two sets of classes.
    pub fn of_edges(&self, first: u16, second: u16) -> Option<Acting> {
        acting(self.by_sets[usize::from(first)][usize::from(second)])
    }
}
