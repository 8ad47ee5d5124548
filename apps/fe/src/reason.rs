//! Why an increment was not accepted, in the words of the deck, and what usually helps.

use crate::terms::Terms;
use fe_core::reject::Reject;

/// A reason with the labels that the user knows.
pub fn explain(reject: &Reject, terms: &Terms) -> String {
    match reject {
        Reject::Singular { node, component } => {
            let label = terms.structure.mesh.point_name(*node as u32);
            let body = terms.bodies.iter().find(|b| b.nodes.binary_search(&(*node as u32)).is_ok());
            let body = body.map_or(String::new(), |b| format!(" ({})", terms.body_name(b)));
            format!("nothing holds freedom {} of node {label}{body}: the stiffness is singular there", component + 1)
        }
        Reject::NotFinite { place, node: Some(node) } => {
            let label = terms.structure.mesh.point_name(*node as u32);
            format!("a number that is not finite came up in {place} at node {label}")
        }
        Reject::NotEnforced { passes, node, overclosure } => {
            let label = terms.structure.mesh.point_name(*node as u32);
            format!("after {passes} augmentations of the multipliers node {label} still overlaps by {overclosure:.3e}")
        }
        other => other.to_string(),
    }
}

/// What usually helps.
pub fn help(reject: &Reject) -> String {
    match reject {
        Reject::Singular { .. } => "hold the body by *BOUNDARY, or let contact hold it before it is loaded by force",
        Reject::StatusChanges { .. } => "a smaller first increment, or a softer penalty on *SURFACE BEHAVIOR, PENALTY",
        Reject::NoConvergence { .. } | Reject::Diverging { .. } => "a smaller first increment on *STATIC",
        Reject::NotEnforced { .. } => {
            "see whether *BOUNDARY holds that node within the other body; or use *SURFACE BEHAVIOR, PENALTY"
        }
        Reject::NotFinite { .. } => "look for extreme numbers in materials, loads and coordinates",
    }
    .into()
}
