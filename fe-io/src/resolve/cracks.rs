//! Nodes at the same place that nothing joins: cracks, wanted or by accident.

use super::scene::Scene;
use crate::diagnostic::{Diagnostic, Diagnostics};
use crate::model::Place;
use fe_contact::pair::PairDefinition;
use fe_contact::surface::{Main, Secondary};
use fe_mesh::{Face, Mesh};

/// Nodes this near, of the model's size, are at the same place [-].
const SAME_PLACE: f64 = 1e-10;

/// A direction along which nodes of regular meshes have different coordinates.
const DIRECTION: [f64; 3] = [0.540_302_305_868, 0.633_214_986_307, 0.554_030_230_586];

/// Counts the pairs of coincident nodes of elements that do not face each other in a contact pair.
pub fn tell(scene: &Scene<'_>, pairs: &[(PairDefinition, Place)], diagnostics: &mut Diagnostics) {
    let mut found = coincident(scene);
    for (pair, _) in pairs {
        if found.is_empty() {
            return;
        }
        let sides = sides(&scene.structure.mesh, pair);
        let faces = |a: u32, b: u32| sides[a as usize] & SECONDARY != 0 && sides[b as usize] & MAIN != 0;
        found.retain(|&(a, b)| !faces(a, b) && !faces(b, a));
    }
    if let Some(&(a, b)) = found.first() {
        let [first, second] = [a, b].map(|n| scene.node_label(n));
        let title = match found.len() {
            1 => "1 pair of nodes lies at the same place without a contact pair between them".to_owned(),
            n => format!("{n} pairs of nodes lie at the same place without a contact pair between them"),
        };
        let warning = Diagnostic::warning(scene.node_places[b as usize], title);
        diagnostics.push(warning.label(format!("first: nodes {first} and {second}")));
    }
}

/// Pairs of nodes at the same place, each in ascending order, all ascending; nodes of no element do not count.
fn coincident(scene: &Scene<'_>) -> Vec<(u32, u32)> {
    let mesh = &scene.structure.mesh;
    let mut used = vec![false; mesh.points.len()];
    mesh.blocks.iter().flat_map(|block| &block.nodes).for_each(|&n| used[n as usize] = true);
    let along = |p: &[f64; 3]| p.iter().zip(DIRECTION).map(|(x, d)| x * d).sum::<f64>();
    let nodes = (0..mesh.points.len() as u32).filter(|&n| used[n as usize]);
    let mut sorted: Vec<(f64, u32)> = nodes.map(|n| (along(&mesh.points[n as usize]), n)).collect();
    sorted.sort_unstable_by(|a, b| a.0.total_cmp(&b.0).then(a.1.cmp(&b.1)));
    let near = SAME_PLACE * size(&mesh.points);
    let mut found = Vec::new();
    for (i, &(s, a)) in sorted.iter().enumerate() {
        // The direction is of unit length: nodes that near differ no more along it.
        for &(_, b) in sorted[i + 1..].iter().take_while(|(other, _)| other - s <= near) {
            let [p, q] = [a, b].map(|n| mesh.points[n as usize]);
            if (0..3).map(|c| (p[c] - q[c]).powi(2)).sum::<f64>().sqrt() <= near {
                found.push((a.min(b), a.max(b)));
            }
        }
    }
    found.sort_unstable();
    found
}

/// Largest extent of the points along an axis [L].
fn size(points: &[[f64; 3]]) -> f64 {
    let extent = |c: usize| {
        let (low, high) =
            points.iter().fold((f64::INFINITY, f64::NEG_INFINITY), |(l, h), p| (l.min(p[c]), h.max(p[c])));
        high - low
    };
    (0..3).map(extent).fold(0.0, f64::max)
}

const SECONDARY: u8 = 1;
const MAIN: u8 = 2;

/// On which sides of a pair each node is, `[points]`.
fn sides(mesh: &Mesh, pair: &PairDefinition) -> Vec<u8> {
    let mut sides = vec![0; mesh.points.len()];
    let mut mark = |faces: &[Face], side: u8| {
        faces.iter().flat_map(|&face| mesh.face(face).1).for_each(|node| sides[node as usize] |= side);
    };
    if let Secondary::Faces(faces) = &pair.secondary {
        mark(faces, SECONDARY);
    }
    if let Main::Faces(faces) = &pair.main {
        mark(faces, MAIN);
    }
    if let Secondary::Nodes(nodes) = &pair.secondary {
        nodes.iter().for_each(|(node, _)| sides[*node as usize] |= SECONDARY);
    }
    sides
}
