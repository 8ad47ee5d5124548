//! A contact pair as a model holds it.

use crate::surface::{Main, Secondary};

/// How the constraint is spread over the secondary surface.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Discretization {
    /// Each secondary node against its projection on the main surface.
    NodeToSurface,
    /// The gap averaged over the secondary surface around each of its nodes.
    SurfaceToSurface,
}

/// `ADJUST=` of a pair: secondary nodes are moved onto the main surface without strain before the first step.
#[derive(Clone, Debug, PartialEq)]
pub enum Adjust {
    /// Nodes that overlap, or are open by no more than this [L].
    Within(f64),
    /// The nodes of a set, whatever their distance, and those that overlap.
    Nodes(Vec<u32>),
}

/// `*CLEARANCE`: gaps of the start that take the place of those between the surfaces; no node moves.
#[derive(Clone, Debug, PartialEq)]
pub enum Clearance {
    /// The same [L] everywhere.
    Everywhere(f64),
    /// Of secondary nodes, ascending; others keep theirs.
    Nodes(Vec<NodeClearance>),
}

/// The clearance of one node.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct NodeClearance {
    /// Secondary node.
    pub node: u32,
    /// Gap [L] at the start, negative where the surfaces overlap.
    pub value: f64,
    /// Unit normal of the main side; `None`: that of the surface.
    pub normal: Option<[f64; 3]>,
}

impl Clearance {
    /// That of a node.
    pub fn of(&self, node: u32) -> Option<NodeClearance> {
        match self {
            Clearance::Everywhere(value) => Some(NodeClearance { node, value: *value, normal: None }),
            Clearance::Nodes(list) => list.binary_search_by_key(&node, |c| c.node).ok().map(|i| list[i]),
        }
    }
}

/// Whether the surfaces of a pair may part.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Bond {
    /// They touch or part, as the interaction says.
    #[default]
    Contact,
    /// `TIED`: nodes that lie on the main surface once `ADJUST` has moved them neither part nor slide, whatever the
    /// interaction says; others are free.
    Tied,
}

/// A contact pair as a model holds it.
#[derive(Clone, Debug)]
pub struct PairDefinition {
    /// Name of the secondary surface.
    pub secondary_name: String,
    /// Name of the main surface.
    pub main_name: String,
    /// Secondary side.
    pub secondary: Secondary,
    /// Main side.
    pub main: Main,
    /// Index of the interaction.
    pub interaction: usize,
    /// Discretization.
    pub discretization: Discretization,
    /// True where the deck says that the surfaces hardly slide.
    pub small_sliding: bool,
    /// Whether the surfaces may part.
    pub bond: Bond,
    /// Strain-free adjustment.
    pub adjust: Option<Adjust>,
    /// Gaps of the start.
    pub clearance: Option<Clearance>,
}

/// How the contact of an explicit pair is enforced.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum MechanicalConstraint {
    /// By corrections of the accelerations that leave no overclosure, or that of a softened law.
    #[default]
    Kinematic,
    /// By forces that grow with the overclosure.
    Penalty,
}

/// How far the surfaces of an explicit pair slide.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Sliding {
    /// Any distance.
    #[default]
    Finite,
    /// Little: each node keeps its place on the main surface.
    Small,
}

/// A contact pair of explicit steps as a model holds it. Where only one of its surfaces can be the secondary one (nodes,
/// lines, what presses on something rigid) that is the first.
#[derive(Clone, Debug, PartialEq)]
pub struct ExplicitPair {
    /// Name of the first surface.
    pub secondary_name: String,
    /// Name of the second surface.
    pub main_name: String,
    /// First surface; nodes have no area here: the law gives a force.
    pub secondary: Secondary,
    /// Second surface; its faces may be facets of a rigid body.
    pub main: Main,
    /// `CPSET=`, capitals.
    pub set: Option<String>,
    /// How it is enforced.
    pub constraint: MechanicalConstraint,
    /// How far it slides.
    pub sliding: Sliding,
    /// `WEIGHT=` [-], 0 to 1: 1 makes the first surface the main one, 0 the secondary one, between them both are both, and
    /// their answers are averaged. `None`: ½ for faces of two deformable bodies, 0 else.
    pub weight: Option<f64>,
}

/// A surface of general contact.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Region {
    /// All faces of solids that no other element shares, and the facets of rigid bodies.
    AllExterior,
    /// A surface of faces, by its name in the mesh.
    Surface(String),
}

/// General contact of explicit steps: every included pair of surfaces that is not excluded, by penalty. Where several
/// assignments name the same faces, the last one holds.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct GeneralContact {
    /// What may touch; a surface beside itself may touch itself.
    pub inclusions: Vec<[Region; 2]>,
    /// What of it does not touch.
    pub exclusions: Vec<[Region; 2]>,
    /// Indices of interactions; elsewhere contact is hard and slides freely.
    pub interactions: Vec<([Region; 2], usize)>,
    /// Factors [-] on the default penalty stiffness; elsewhere 1.
    pub scale_penalty: Vec<([Region; 2], f64)>,
}
