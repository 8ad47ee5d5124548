//! What the contacts of an explicit step do at a moment, for its results.

use super::contact::weight;
use super::scene::Scene;
use fe_contact::explicit::{ContactPair, PairSides};
use fe_contact::facet::Vec3;
use fe_contact::state::{ContactState, NodeValues, SideForce};
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
        let exchanged = weight(&scene.structure, pair);
        let is_first = |part: &ContactPair| part.label() == label((&pair.secondary_name, &pair.main_name));
        let mut parts: Vec<(&ContactPair, ContactState)> =
            sides.pairs.iter().map(|part| (part, part.state())).collect();
        let mut state = parts.iter().fold(ContactState::default(), |all, (part, own)| match is_first(part) {
            true => own.clone(),
            false => all.and_exchanged(own.clone()),
        });
        let is_balanced = parts.len() > 1;
        state.points.clear();
        let mut nodes = Vec::new();
        for (part, own) in &mut parts {
            // A point of a part stands for a part of its surface.
            let share = if is_first(part) { 1.0 - exchanged } else { exchanged };
            if is_balanced {
                for point in &mut own.points {
                    *point = point.pressed_by(force_on(&state, point.node), point.measure.value() / share);
                }
            }
            nodes.extend(part.node_values(own).into_iter().map(|n| NodeValues { measure: n.measure / share, ..n }));
            state.points.append(&mut own.points);
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

/// Normal force [F] on a node of a contact.
fn force_on(state: &ContactState, node: u32) -> f64 {
    let on_side = |side: &SideForce| {
        let place = side.nodes.binary_search_by_key(&node, |n| n.0);
        place.map_or(Vec3::zeros(), |place| Vec3::from(side.nodes[place].1))
    };
    (on_side(&state.secondary) + on_side(&state.main)).norm()
}

/// `SECONDARY on MAIN`.
pub fn label((secondary, main): (&str, &str)) -> String {
    format!("{secondary} on {main}")
}
