//! What the contacts of an explicit step do at a moment, for its results.

use super::contact::weight;
use super::scene::Scene;
use fe_contact::explicit::PairSides;
use fe_contact::state::{ContactState, NodeValues};
use fe_io::Model;
use fe_io::model::ActivePair;

/// A contact at a moment.
pub struct ActingContact<'a> {
    /// Names of its secondary and main surface.
    pub surfaces: (&'a str, &'a str),
    /// Both parts of it, where either side presses on the other.
    pub state: ContactState,
    /// Results at the nodes that press.
    pub nodes: Vec<NodeValues>,
}

/// The contacts that act in the present step.
pub fn contacts<'a>(model: &'a Model, scene: &'a Scene) -> Vec<ActingContact<'a>> {
    let of = |(active, sides): &'a (ActivePair, PairSides)| {
        let pair = &model.explicit_pairs[active.pair].0;
        let (mut state, mut nodes) = (ContactState::default(), Vec::new());
        let exchanged = weight(&scene.structure, pair);
        for part in &sides.pairs {
            let own = part.state();
            let is_first = part.label() == label((&pair.secondary_name, &pair.main_name));
            let share = if is_first { 1.0 - exchanged } else { exchanged };
            // A point of a part stands for a part of its surface.
            nodes.extend(part.node_values(&own).into_iter().map(|n| NodeValues { measure: n.measure / share, ..n }));
            state = if is_first { own } else { state.and_exchanged(own) };
        }
        ActingContact { surfaces: (&pair.secondary_name, &pair.main_name), state, nodes }
    };
    let general = scene.general().map(|general| {
        let state = general.state();
        let nodes = general.node_values(&state);
        ActingContact { surfaces: (general.label(), general.label()), state, nodes }
    });
    scene.pairs.iter().map(of).chain(general).collect()
}

/// `SECONDARY on MAIN`.
pub fn label((secondary, main): (&str, &str)) -> String {
    format!("{secondary} on {main}")
}
