//! `ADJUST`: secondary nodes are moved onto the main surface without strain, before any pair is built.

use crate::build::secondary_points;
use crate::closest::{Closest, EXTENSION, Found};
use crate::error::PairError;
use crate::facet::Vec3;
use crate::interaction::Interaction;
use crate::node_to_surface::Node;
use crate::pair::{Adjust, PairDefinition};
use crate::search::Grid;
use crate::sides::{Prepared, characteristic_length};
use crate::surface::Main;
use fe_core::Structure;

/// A node that was moved.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Moved {
    /// Index of the pair.
    pub pair: usize,
    /// Node.
    pub node: u32,
    /// Where it goes [L].
    pub to: [f64; 3],
    /// Gap [L] that it closes, negative where it overlapped.
    pub gap: f64,
}

/// The moves of all pairs with `ADJUST`, pair by pair, nodes ascending; later pairs see the moves of earlier ones.
/// `interactions` are those that the definitions name.
pub fn adjust(
    structure: &Structure,
    definitions: &[PairDefinition],
    interactions: &[Interaction],
) -> Result<Vec<Moved>, PairError> {
    let mut all = Vec::new();
    let mut moved: Option<Structure> = None;
    for (pair, definition) in definitions.iter().enumerate() {
        let Some(adjust) = &definition.adjust else { continue };
        let structure = moved.get_or_insert_with(|| structure.clone());
        let moves = of_pair(structure, (pair, definition), &interactions[definition.interaction], adjust)?;
        moves.iter().for_each(|m| structure.mesh.points[m.node as usize] = m.to);
        all.extend(moves);
    }
    Ok(all)
}

fn of_pair(
    structure: &Structure,
    (pair, definition): (usize, &PairDefinition),
    interaction: &Interaction,
    adjust: &Adjust,
) -> Result<Vec<Moved>, PairError> {
    let sides = Prepared::new(structure, definition, interaction)?;
    let chosen = |node: u32, gap: f64| match adjust {
        Adjust::Within(distance) => gap <= *distance,
        Adjust::Nodes(set) => gap < 0.0 || set.contains(&node),
    };
    let mut moves = Vec::new();
    for (n, foot) in feet(structure, definition, &sides) {
        if let Some((gap, normal)) = foot
            && gap != 0.0
            && chosen(n.node, gap)
        {
            moves.push(Moved { pair, node: n.node, to: (n.x + sides.origin - normal * gap).into(), gap });
        }
    }
    Ok(moves)
}

/// The secondary nodes, each with its gap [L] to the main surface and the normal there, where it has one.
pub(crate) fn feet(
    structure: &Structure,
    definition: &PairDefinition,
    sides: &Prepared,
) -> Vec<(Node, Option<(f64, Vec3)>)> {
    // A rigid main side has no facets among which to search.
    let grid = (!sides.main.is_empty()).then(|| Grid::of_facets(&sides.main, EXTENSION));
    let closest = grid.as_ref().map(|grid| Closest::new(&sides.main, grid));
    let length = characteristic_length(&sides.secondary).or_else(|| characteristic_length(&sides.main));
    let deepest = length.map_or(f64::INFINITY, |l| 0.5 * l);
    let of_node = |n: Node| {
        let foot = match &definition.main {
            Main::Faces(_) => match closest.as_ref().map(|c| c.foot(&n.x, n.outward.as_ref(), deepest)) {
                Some(Found::Foot(foot)) => Some((foot.gap, foot.normal)),
                _ => None,
            },
            Main::Rigid { surface, .. } => {
                let at = surface.distance((n.x + sides.origin).into()).map(|d| (d.gap, Vec3::from(d.normal)));
                at.filter(|(gap, normal)| *gap >= -deepest && n.outward.is_none_or(|o| o.dot(normal) < 0.0))
            }
        };
        (n, foot)
    };
    secondary_points(structure, sides).into_iter().map(of_node).collect()
}
