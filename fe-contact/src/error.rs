//! Why a pair cannot be built.

use crate::rigid::RigidFault;

/// A pair that cannot be built; nodes are told by their labels.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum PairError {
    /// A side without faces or nodes.
    #[error("surface {surface} has no faces and no nodes")]
    Empty {
        /// Name.
        surface: String,
    },
    /// Both sides use the same node.
    #[error("surfaces {secondary} and {main} share node {node}; a pair needs two separate sets of nodes")]
    SharedNode {
        /// Label of the node.
        node: String,
        /// Name of the secondary surface.
        secondary: String,
        /// Name of the main surface.
        main: String,
    },
    /// A plane surface with one in space.
    #[error(
        "surface {main} does not belong to the space of surface {secondary}: plane models take edges and TYPE=SEGMENTS, \
         models in space take faces, TYPE=CYLINDER and TYPE=REVOLUTION"
    )]
    MixedDimensions {
        /// Name of the secondary surface.
        secondary: String,
        /// Name of the main surface.
        main: String,
    },
    /// Faces with mid-side nodes in node to surface.
    #[error(
        "surface {surface} has faces with mid-side nodes, on which node to surface is not defined; use TYPE=SURFACE TO SURFACE"
    )]
    MidSideNodes {
        /// Name.
        surface: String,
    },
    /// A node lies too deep in the main side for the side to be certain.
    #[error(
        "node {node} of surface {secondary} lies {depth:.6e} deep in surface {main}, more than {limit:.6e} (half a \
         facet): move the body out, use ADJUST, or check on which side the surfaces face"
    )]
    TooDeep {
        /// Label of the node.
        node: String,
        /// Overclosure [L].
        depth: f64,
        /// What is allowed [L].
        limit: f64,
        /// Name of the secondary surface.
        secondary: String,
        /// Name of the main surface.
        main: String,
    },
    /// A rigid surface that cannot be used.
    #[error("rigid surface {surface}: {fault}")]
    Rigid {
        /// Name.
        surface: String,
        /// Why.
        fault: RigidFault,
    },
    /// The default penalty needs an elastic side.
    #[error(
        "neither {secondary} nor {main} lies on elements from which a penalty stiffness could be taken; give it on the data line"
    )]
    NoStiffness {
        /// Name of the secondary surface.
        secondary: String,
        /// Name of the main surface.
        main: String,
    },
    /// A number of the interaction out of range.
    #[error("interaction {interaction}: {what} is {value}; it must be greater than 0")]
    NotPositive {
        /// Name.
        interaction: String,
        /// Which number.
        what: &'static str,
        /// Its value.
        value: f64,
    },
}
