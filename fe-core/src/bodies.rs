//! Bodies: connected elements, and the rigid motions that supports leave them.

use crate::element::{ElementType, Family};
use crate::freedoms::{COMPONENTS, Freedoms};
use crate::structure::Structure;
use nalgebra::{Matrix6, SymmetricEigen, Vector6};
use std::collections::BTreeSet;

/// Elements that share nodes (springs included, contact and dashpots not), or the reference node of a rigid body.
#[derive(Clone, Debug, PartialEq)]
pub struct Body {
    /// Nodes, ascending.
    pub nodes: Vec<u32>,
    /// Mean of the nodes' coordinates [L].
    pub center: [f64; 3],
    /// Largest distance of a node from the centre [L]; 1 for a single node.
    pub size: f64,
}

/// A rigid motion: translation [L], and rotation [rad] about the body's centre.
pub type RigidMotion = [f64; COMPONENTS];

/// Eigenvalues of the supports' stiffness (of order one for a held motion) below this are round-off: a motion
/// that is held by so little is called free.
const HELD: f64 = 1e-10;

impl Body {
    fn new(structure: &Structure, nodes: Vec<u32>) -> Self {
        let points = &structure.mesh.points;
        let mut center = [0.0; 3];
        for &n in &nodes {
            (0..3).for_each(|i| center[i] += points[n as usize][i] / nodes.len() as f64);
        }
        let distance = |n: &u32| (0..3).map(|i| (points[*n as usize][i] - center[i]).powi(2)).sum::<f64>().sqrt();
        let largest = nodes.iter().map(distance).fold(0.0, f64::max);
        Body { nodes, center, size: if largest > 0.0 { largest } else { 1.0 } }
    }

    /// Displacement [L or rad] of a freedom's direction at a node under a rigid motion.
    fn displacement(&self, point: &[f64; 3], component: usize, motion: &RigidMotion) -> f64 {
        let arm: [f64; 3] = std::array::from_fn(|i| point[i] - self.center[i]);
        match component {
            0 => motion[0] + motion[4] * arm[2] - motion[5] * arm[1],
            1 => motion[1] + motion[5] * arm[0] - motion[3] * arm[2],
            2 => motion[2] + motion[3] * arm[1] - motion[4] * arm[0],
            rotation => motion[rotation],
        }
    }

    /// The displacement field of a rigid motion, over all freedoms; zero outside the body.
    pub fn field(&self, structure: &Structure, freedoms: &Freedoms, motion: &RigidMotion) -> Vec<f64> {
        let mut field = vec![0.0; freedoms.len()];
        for &n in &self.nodes {
            for f in freedoms.of_node(n as usize) {
                field[f] = self.displacement(&structure.mesh.points[n as usize], freedoms.component(f), motion);
            }
        }
        field
    }

    /// An orthonormal basis (rotations measured times the body's size) of the rigid motions that leave every
    /// fixed freedom, and every one with a spring to the ground, at rest.
    pub fn free_motions(&self, structure: &Structure, freedoms: &Freedoms, fixed: &[bool]) -> Vec<RigidMotion> {
        let modes = rigid_modes(structure, self.size);
        let grounded = grounded(structure, &self.nodes);
        let (mut held, mut there) = (Matrix6::zeros(), Matrix6::zeros());
        for &n in &self.nodes {
            for f in freedoms.of_node(n as usize) {
                let component = freedoms.component(f);
                // Rotations count by what they move the rim.
                let arm = if component < 3 { 1.0 } else { self.size };
                let mut row = Vector6::zeros();
                for (k, mode) in modes.iter().enumerate() {
                    row[k] = arm * self.displacement(&structure.mesh.points[n as usize], component, mode);
                }
                there += row * row.transpose();
                if fixed[f] || grounded.contains(&(n, component as u8)) {
                    held += row * row.transpose();
                }
            }
        }
        // A motion that moves no freedom (of a straight chain of trusses about itself) is none.
        let eigen = SymmetricEigen::new(there);
        for (value, vector) in eigen.eigenvalues.iter().zip(eigen.eigenvectors.column_iter()) {
            if *value <= HELD {
                held += vector * vector.transpose();
            }
        }
        // Directions that the space does not have count as held.
        (modes.len()..COMPONENTS).for_each(|k| held[(k, k)] = 1.0);
        let eigen = SymmetricEigen::new(held);
        let mut free = Vec::new();
        for (value, vector) in eigen.eigenvalues.iter().zip(eigen.eigenvectors.column_iter()) {
            if *value <= HELD {
                let mut motion = [0.0; COMPONENTS];
                for (k, mode) in modes.iter().enumerate() {
                    (0..COMPONENTS).for_each(|c| motion[c] += vector[k] * mode[c]);
                }
                free.push(motion);
            }
        }
        free
    }
}

/// The freedoms of some nodes, ascending, that a spring holds to the ground.
fn grounded(structure: &Structure, nodes: &[u32]) -> BTreeSet<(u32, u8)> {
    let springs = structure.discrete.iter().filter(|section| section.element == ElementType::SPRING1);
    let held = springs.flat_map(|s| s.cells.iter().map(|&cell| (structure.mesh.cell(cell)[0], s.components[0])));
    held.filter(|(node, _)| nodes.binary_search(node).is_ok()).collect()
}

/// The rigid motions of the space, rotations scaled so that the rim of a body of `size` moves by one.
fn rigid_modes(structure: &Structure, size: f64) -> Vec<RigidMotion> {
    let rigid = structure.rigid_mask();
    let unit = |c: usize| {
        let mut motion = [0.0; COMPONENTS];
        motion[c] = if c < 3 { 1.0 } else { 1.0 / size };
        motion
    };
    (0..COMPONENTS).filter(|c| rigid >> c & 1 == 1).map(unit).collect()
}

/// The bodies of a structure in the order of their first node; each reference node is one by itself unless
/// elements use it too.
pub fn bodies(structure: &Structure, references: &[u32]) -> Vec<Body> {
    let mut leader: Vec<u32> = (0..structure.mesh.points.len() as u32).collect();
    fn find(leader: &mut [u32], mut n: u32) -> u32 {
        while leader[n as usize] != n {
            leader[n as usize] = leader[leader[n as usize] as usize];
            n = leader[n as usize];
        }
        n
    }
    let mut used = vec![false; leader.len()];
    references.iter().chain(&structure.slide_nodes).for_each(|&n| used[n as usize] = true);
    for (block, element) in structure.mesh.blocks.iter().zip(&structure.elements) {
        // Contact and dashpots hold nothing together.
        let family = element.family();
        let joins = matches!(family, Family::Solid | Family::Truss | Family::Beam | Family::Spring);
        for nodes in block.nodes.chunks_exact(if joins { block.kind.nodes() } else { 1 }) {
            let mut first = find(&mut leader, nodes[0]);
            for &n in nodes {
                used[n as usize] = true;
                let other = find(&mut leader, n);
                let (low, high) = (first.min(other), first.max(other));
                leader[high as usize] = low;
                first = low;
            }
        }
    }
    let mut groups: Vec<Vec<u32>> = Vec::new();
    let mut group_of = vec![usize::MAX; leader.len()];
    for n in 0..leader.len() as u32 {
        if used[n as usize] {
            let lead = find(&mut leader, n) as usize;
            if group_of[lead] == usize::MAX {
                group_of[lead] = groups.len();
                groups.push(Vec::new());
            }
            groups[group_of[lead]].push(n);
        }
    }
    groups.into_iter().map(|nodes| Body::new(structure, nodes)).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::element::ElementType;
    use crate::structure::Section;
    use fe_mesh::{CellBlock, CellId, CellKind, Mesh};

    /// Two unit squares side by side that share no node, and a reference node.
    fn two_squares() -> Structure {
        let mut points = Vec::new();
        for x in [0.0, 3.0] {
            points.extend([[x, 0.0, 0.0], [x + 1.0, 0.0, 0.0], [x + 1.0, 1.0, 0.0], [x, 1.0, 0.0]]);
        }
        points.push([0.0, -1.0, 0.0]);
        let block = CellBlock { kind: CellKind::Quad4, labels: vec![1, 2], nodes: (0..8).collect() };
        let mesh = Mesh { point_labels: (1..=9).collect(), points, blocks: vec![block], ..Mesh::default() };
        let cells = (0..2).map(|cell| CellId { block: 0, cell }).collect();
        let section = Section { element: ElementType::CPE4, cells, material: 0, thickness: 1.0, hourglass: None };
        Structure {
            mesh,
            elements: vec![ElementType::CPE4],
            materials: vec![],
            sections: vec![section],
            ..Structure::default()
        }
    }

    #[test]
    fn bodies_are_what_shares_nodes() {
        let found = bodies(&two_squares(), &[8]);
        assert_eq!(found.iter().map(|b| b.nodes.len()).collect::<Vec<_>>(), [4, 4, 1]);
        assert_eq!(found[1].center, [3.5, 0.5, 0.0]);
    }

    #[test]
    fn supports_take_motions_away() {
        let structure = two_squares();
        let freedoms = structure.freedoms(&[8]);
        let body = &bodies(&structure, &[8])[0];
        let mut fixed = vec![false; freedoms.len()];
        assert_eq!(body.free_motions(&structure, &freedoms, &fixed).len(), 3);
        fixed[freedoms.index(0, 0).unwrap()] = true;
        fixed[freedoms.index(3, 0).unwrap()] = true;
        let free = body.free_motions(&structure, &freedoms, &fixed);
        assert_eq!(free.len(), 1);
        // What is left is the vertical translation.
        assert!((free[0][1].abs() - 1.0).abs() < 1e-12 && free[0][0].abs() < 1e-12 && free[0][5].abs() < 1e-12);
        fixed[freedoms.index(1, 1).unwrap()] = true;
        assert!(body.free_motions(&structure, &freedoms, &fixed).is_empty());
        let field = body.field(&structure, &freedoms, &[0.0, 0.0, 0.0, 0.0, 0.0, 1.0]);
        assert_eq!(field[..4], [0.5, -0.5, 0.5, 0.5]);
        assert!(field[8..].iter().all(|&v| v == 0.0));
    }
}
