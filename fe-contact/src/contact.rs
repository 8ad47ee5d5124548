//! Contact as a term: points that share a law, however they were found.

use crate::carry::Ground;
use crate::conditions::{Activity, Overrides};
use crate::enforce::{Multipliers, Separation};
use crate::facet::Vec3;
use crate::friction::Coulomb;
use crate::interaction::NormalBehavior;
use crate::interference::Allowance;
use crate::law::NormalLaw;
use crate::point::ContactPoint;
use crate::sides::Prepared;
use crate::slip::Tangential;
use crate::summary::Summary;
use crate::term::Blocks;
use crate::viscous::Viscous;
use fe_mesh::CellId;
use std::collections::BTreeMap;
use std::ops::Range;
use std::sync::{Arc, Mutex};

/// Points of one pair, or of gap or tube-to-tube elements of one kind, linearised at the reference geometry (small
/// displacements, infinitesimal sliding), and the law that they share.
#[derive(Debug)]
pub struct Contact {
    pub(crate) name: String,
    pub(crate) surfaces: (String, String),
    /// The points, by ascending secondary node.
    pub points: Vec<ContactPoint>,
    /// The element of each point; empty for a pair.
    pub cells: Vec<CellId>,
    /// Freedoms of each point's nodes.
    pub(crate) places: Vec<Vec<Range<usize>>>,
    /// Where the points stand in the matrices of a step.
    pub(crate) blocks: Mutex<Option<Arc<Blocks>>>,
    pub(crate) law: Arc<dyn NormalLaw>,
    /// The law itself, where one in series is asked.
    pub(crate) bare: Option<Arc<dyn NormalLaw>>,
    /// The points that no free freedom of the present step moves; empty where they are asked as all others.
    pub(crate) stuck: Vec<bool>,
    /// For each point the directions along the surface in which symmetry leaves nothing to slip; empty where there are none.
    pub(crate) mirrored: Vec<[bool; 2]>,
    /// Multipliers on top of the law.
    pub(crate) multipliers: Option<Multipliers>,
    /// What acts along the surface.
    pub(crate) tangential: Option<Tangential>,
    /// When points may pull.
    pub(crate) separation: Separation,
    /// Length [L] of the facets, or what stands for it; 0 where nothing does.
    pub(crate) length: f64,
    /// Gaps [L] this near to the law's kink touch.
    pub(crate) touch: f64,
    pub(crate) summary: Summary,
    pub(crate) notes: Vec<String>,
    pub(crate) sides: Prepared,
    /// Places of the nodes of both sides.
    pub(crate) positions: BTreeMap<u32, Vec3>,
    /// Components of the freedoms of nodes where they are not the first ones, in order.
    pub(crate) components: BTreeMap<u32, Vec<usize>>,
    /// The main side is an analytical rigid surface.
    pub(crate) rigid_main: bool,
    /// Whether the present step has it act.
    pub(crate) activity: Activity,
    /// Overclosure that the present step lets be.
    pub(crate) allowance: Option<Allowance>,
    /// What the law was made of, and what the present step overrides of it.
    pub(crate) origin: (NormalBehavior, Ground, Overrides),
    /// What resists the motion of its surfaces.
    pub(crate) viscous: Viscous,
}

impl Contact {
    /// `SECONDARY on MAIN`, or the set of the contact elements.
    pub fn name(&self) -> &str {
        &self.name
    }

    /// Names of the secondary and the main surface; twice the set of the contact elements.
    pub fn surfaces(&self) -> (&str, &str) {
        (&self.surfaces.0, &self.surfaces.1)
    }

    /// What the pair turned out to be.
    pub fn summary(&self) -> Summary {
        self.summary
    }

    /// Remarks on the surfaces and on the discretization, a line each.
    pub fn notes(&self) -> &[String] {
        &self.notes
    }

    /// The law of all points.
    pub fn law(&self) -> &dyn NormalLaw {
        &*self.law
    }

    /// Nodes of the secondary side, ascending, with or without a constraint.
    pub fn secondary_nodes(&self) -> &[u32] {
        &self.sides.secondary_nodes
    }

    /// Nodes of the main side, ascending; the reference node of a rigid one.
    pub fn main_nodes(&self) -> &[u32] {
        &self.sides.main_nodes
    }

    /// True when the main side is an analytical rigid surface: nothing was searched.
    pub fn has_rigid_main(&self) -> bool {
        self.rigid_main
    }

    /// The law of friction, or the one that the present step leads to; `None`: the surfaces slide freely.
    pub fn friction(&self) -> Option<&Coulomb> {
        self.tangential.as_ref().map(|t| &t.law)
    }

    /// The law of friction at the start of a step that changes it.
    pub fn friction_before(&self) -> Option<&Coulomb> {
        self.tangential.as_ref()?.change.as_ref().map(|change| &change.from)
    }

    /// True where there is friction at some time of the present step.
    pub fn rubs(&self) -> bool {
        [self.friction(), self.friction_before()].into_iter().flatten().any(|law| !law.is_none())
    }

    /// True for a tied pair: its points neither part nor slide.
    pub fn is_tied(&self) -> bool {
        self.separation == Separation::Tied
    }

    /// True where multipliers hold sticking points: they do not move at all.
    pub fn sticks_exactly(&self) -> bool {
        self.tangential.as_ref().is_some_and(|t| t.multipliers.is_some())
    }

    /// Forces [F] that it puts on the freedoms at a displacement; a freedom may be there more than once.
    pub fn force(&self, u: &[f64], history: &[f64]) -> Vec<(usize, f64)> {
        let of_point = |i: usize| {
            let (here, p) = (self.at(i, u), &self.points[i]);
            let answer = self.answer(i, here.gap, (history, history));
            let (shear, _) = self.shear_and_slip(i, history);
            let slide = self.slide_from(i, u).filter(|_| shear != [0.0; 2]);
            let mut forces = Vec::new();
            let mut add = |row: &[f64], force: f64| {
                let freedoms = self.places[i].iter().cloned().flatten();
                forces.extend(row.iter().zip(freedoms).map(|(d, f)| (f, force * p.measure.value() * d)));
            };
            add(&here.row, answer.response.pressure + self.damped(i, history));
            slide.iter().flat_map(|slide| slide.rows.iter().zip(shear)).for_each(|(row, shear)| add(row, -shear));
            forces
        };
        (0..self.points.len()).flat_map(of_point).filter(|(_, force)| *force != 0.0).collect()
    }
}
