//! The sides of a pair, checked and made ready: facets, nodes, remarks.

use crate::error::PairError;
use crate::facet::{Facet, Vec3};
use crate::interaction::Interaction;
use crate::pair::PairDefinition;
use crate::search::Bounds;
use crate::surface::{Main, Secondary};
use fe_core::Structure;
use fe_mesh::{CellKind, Face};
use std::collections::{BTreeMap, BTreeSet};

/// Both sides.
#[derive(Debug, Default)]
pub struct Prepared {
    /// Where coordinates of facets, nodes and rigid surfaces are taken from: gaps are small beside the sides, not
    /// beside their distance from the model's origin.
    pub origin: Vec3,
    /// Facets of an element-based secondary side.
    pub secondary: Vec<Facet>,
    /// Facets of a deformable main side.
    pub main: Vec<Facet>,
    /// Nodes of the secondary side, ascending.
    pub secondary_nodes: Vec<u32>,
    /// Nodes of the main side, ascending; the reference node of a rigid one.
    pub main_nodes: Vec<u32>,
    /// Remarks.
    pub notes: Vec<String>,
}

impl Prepared {
    /// From a definition.
    pub fn new(structure: &Structure, pair: &PairDefinition, interaction: &Interaction) -> Result<Self, PairError> {
        let mut sides = Prepared { origin: origin(structure, pair), ..Prepared::default() };
        let origin = sides.origin;
        let (secondary, main) = (pair.secondary_name.as_str(), pair.main_name.as_str());
        let notes = &mut sides.notes;
        match &pair.secondary {
            Secondary::Faces(faces) => {
                sides.secondary = facets((structure, &origin), faces, interaction.measure, (secondary, notes));
                sides.secondary_nodes = nodes(&sides.secondary);
            }
            Secondary::Nodes(list) => {
                let set: BTreeSet<u32> = list.iter().map(|n| n.0).collect();
                if set.len() < list.len() {
                    notes.push(format!(
                        "surface {secondary}: {} nodes are listed more than once and count once",
                        list.len() - set.len()
                    ));
                }
                sides.secondary_nodes = set.into_iter().collect();
            }
            Secondary::Lines(_) => sides.secondary_nodes = pair.secondary.nodes(&structure.mesh),
        }
        match &pair.main {
            Main::Faces(faces) => {
                sides.main = facets((structure, &origin), faces, interaction.measure, (main, notes));
                sides.main_nodes = nodes(&sides.main);
            }
            Main::Rigid { surface, reference } => {
                surface.check().map_err(|fault| PairError::Rigid { surface: main.into(), fault })?;
                sides.main_nodes = vec![*reference];
            }
        }
        sides.check(structure, pair)?;
        Ok(sides)
    }

    fn check(&self, structure: &Structure, pair: &PairDefinition) -> Result<(), PairError> {
        let (secondary, main) = (pair.secondary_name.clone(), pair.main_name.clone());
        if self.secondary_nodes.is_empty() {
            return Err(PairError::Empty { surface: secondary });
        }
        if self.main_nodes.is_empty() {
            return Err(PairError::Empty { surface: main });
        }
        if let Some(&node) = self.secondary_nodes.iter().find(|n| self.main_nodes.binary_search(n).is_ok()) {
            let node = label(structure, node);
            return Err(PairError::SharedNode { node, secondary, main });
        }
        let plane = self.secondary.first().map_or(structure.is_plane(), Facet::is_edge);
        let fits = |f: &Facet| f.is_edge() == plane;
        let rigid_fits = match &pair.main {
            Main::Rigid { surface, .. } => surface.is_plane() == plane,
            Main::Faces(_) => true,
        };
        if !rigid_fits || !self.secondary.iter().chain(&self.main).all(fits) {
            return Err(PairError::MixedDimensions { secondary, main });
        }
        Ok(())
    }
}

/// Sides further than this many times their size from the model's origin get an origin of their own [-].
const FAR: f64 = 8.0;

/// The least coordinates of both sides where they are far away, else 0; radii stay what they are.
fn origin(structure: &Structure, pair: &PairDefinition) -> Vec3 {
    let of_faces = |faces: &[Face]| faces.iter().flat_map(|&face| structure.mesh.face(face).1).collect::<Vec<u32>>();
    let mut nodes = pair.secondary.nodes(&structure.mesh);
    if let Main::Faces(faces) = &pair.main {
        nodes.extend(of_faces(faces));
    }
    let points: Vec<Vec3> = nodes.iter().map(|&n| structure.mesh.points[n as usize].into()).collect();
    let Bounds { low, high } = Bounds::around(&points, 0.0);
    let size = (high - low).norm();
    let axisymmetric = structure.is_axisymmetric();
    Vec3::from_fn(|c, _| {
        let far = low[c] > FAR * size || high[c] < -FAR * size;
        if far && !(axisymmetric && c == 0) { low[c] } else { 0.0 }
    })
}

/// Mean characteristic length [L] of facets: √(mean area), or the mean length of edges.
pub fn characteristic_length(facets: &[Facet]) -> Option<f64> {
    let mean = facets.iter().map(|f| f.area).sum::<f64>() / facets.len().max(1) as f64;
    let edges = facets.first()?.is_edge();
    Some(if edges { mean } else { mean.sqrt() })
}

/// What the user knows a node by; its index where the mesh has no labels.
pub fn label(structure: &Structure, node: u32) -> String {
    let labelled = structure.mesh.point_labels.len() > node as usize;
    if labelled { structure.mesh.point_name(node) } else { node.to_string() }
}

/// Nodes of facets, ascending.
pub fn nodes(facets: &[Facet]) -> Vec<u32> {
    facets.iter().flat_map(|f| f.nodes().iter().copied()).collect::<BTreeSet<u32>>().into_iter().collect()
}

/// The facets of a list of faces, each once, ascending: the same face twice, the same face of two cells (an interior
/// one, dropped on both sides) and faces without area are left out and remarked.
fn facets(
    (structure, origin): (&Structure, &Vec3),
    faces: &[Face],
    thickness: Option<f64>,
    (name, notes): (&str, &mut Vec<String>),
) -> Vec<Facet> {
    let once: BTreeSet<Face> = faces.iter().copied().collect();
    if once.len() < faces.len() {
        notes.push(format!(
            "surface {name}: {} faces are listed more than once and count once",
            faces.len() - once.len()
        ));
    }
    let mut by_nodes: BTreeMap<Vec<u32>, Vec<Facet>> = BTreeMap::new();
    for &face in &once {
        let facet = Facet::new(structure, face, thickness, origin);
        let mut nodes = facet.nodes().to_vec();
        nodes.sort_unstable();
        by_nodes.entry(nodes).or_default().push(facet);
    }
    let (mut kept, mut interior, mut flat) = (Vec::with_capacity(once.len()), 0, 0);
    for group in by_nodes.into_values() {
        // Two cells on the same nodes with the same normal are a doubled cell, not an interior face.
        let first = &group[0];
        if group.iter().any(|f| f.normal.dot(&first.normal) < 0.0) {
            interior += group.len();
            continue;
        }
        let facet = group.into_iter().next().expect("a group has a facet");
        if facet.area > 0.0 && known(facet.kind) {
            kept.push(facet);
        } else {
            flat += 1;
        }
    }
    if interior > 0 {
        notes.push(format!(
            "surface {name}: {interior} faces lie inside of the body, between two elements, and are left out"
        ));
    }
    if flat > 0 {
        notes.push(format!("surface {name}: {flat} faces have no area and are left out"));
    }
    kept.sort_by_key(|f| f.face);
    kept
}

fn known(kind: CellKind) -> bool {
    use CellKind::*;
    matches!(kind, Line2 | Line3 | Tri3 | Tri6 | Quad4)
}
