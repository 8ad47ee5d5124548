//! Why an increment was not accepted.

/// A typed reason to cut an increment back, or to give the step up.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum Reject {
    /// The stiffness has no definite answer in one direction: nothing holds it.
    #[error("nothing holds freedom {component} of node {node}: the stiffness is singular there", component = .component + 1)]
    Singular {
        /// Node index (messages translate it to the label).
        node: usize,
        /// Freedom of the node, from 0.
        component: usize,
    },
    /// Multipliers did not bring the overclosures down.
    #[error("after {passes} augmentations node {node} still overlaps by {overclosure:.3e}")]
    NotEnforced {
        /// Augmentations done.
        passes: usize,
        /// Node index of the largest overclosure.
        node: usize,
        /// Largest overclosure [L].
        overclosure: f64,
    },
    /// Newton did not converge within the iterations that the controls allow.
    #[error("no convergence in {iterations} iterations: residual {residual:.3e} of the largest force")]
    NoConvergence {
        /// Iterations done.
        iterations: usize,
        /// Largest residual over the largest force [-].
        residual: f64,
    },
    /// The residual grew in two iterations after another.
    #[error("the residual grows: {residual:.3e} of the largest force after {iterations} iterations")]
    Diverging {
        /// Iterations done.
        iterations: usize,
        /// Largest residual over the largest force [-].
        residual: f64,
    },
    /// Contact statuses did not settle.
    #[error("{changes} contact points still change between open and closed after {iterations} iterations")]
    StatusChanges {
        /// Iterations with a change of status.
        iterations: usize,
        /// Points that changed in the last one.
        changes: usize,
    },
    /// A number that is not finite came up.
    #[error("a number that is not finite came up in {place}{}", .node.map_or(String::new(), |n| format!(" at node {n}")))]
    NotFinite {
        /// The term or the vector.
        place: String,
        /// Node index, where there is one (messages translate it to the label).
        node: Option<usize>,
    },
}
