//! Nodes at the same place that nothing joins: cracks, wanted or by accident.

use super::scene::Scene;
use crate::diagnostic::{Diagnostic, Diagnostics};
use crate::model::Place;
use fe_contact::surface::{Main, Secondary};
use fe_contact::tube::TubeDefinition;
use fe_mesh::check::coincident_points;
use fe_mesh::{CellKind, Mesh};
use std::collections::{BTreeMap, BTreeSet, HashSet};

/// Nodes this near, of the model's size, are at the same place [-].
const SAME_PLACE: f64 = 1e-10;

/// Counts the pairs of coincident nodes of elements that neither face each other in a contact pair nor lie in each other as
/// tubes.
pub fn tell(
    scene: &Scene<'_>,
    pairs: Vec<(&Secondary, &Main)>,
    tubes: &[(TubeDefinition, Place)],
    diagnostics: &mut Diagnostics,
) {
    let mut found = coincident(scene);
    for (tube, _) in tubes {
        if found.is_empty() {
            return;
        }
        let (inner, outer) = (inner_tubes(&scene.structure.mesh, tube), BTreeSet::from_iter(&tube.line.nodes));
        let within = |a: u32, b: u32| inner.contains(&a) && outer.contains(&b);
        found.retain(|&(a, b)| !within(a, b) && !within(b, a));
    }
    for pair in pairs {
        if found.is_empty() {
            return;
        }
        let sides = sides(&scene.structure.mesh, pair);
        let faces = |a: u32, b: u32| sides[a as usize] & SECONDARY != 0 && sides[b as usize] & MAIN != 0;
        found.retain(|&(a, b)| !faces(a, b) && !faces(b, a));
    }
    if let Some(&(a, b)) = found.first() {
        let [first, second] = [a, b].map(|n| scene.node_name(n));
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
    let mut found = coincident_points(&mesh.points, SAME_PLACE);
    found.retain(|&(a, b)| used[a as usize] && used[b as usize]);
    // Springs, gaps and the like join nodes at one place.
    if !found.is_empty() {
        let short = mesh.blocks.iter().filter(|block| block.kind == CellKind::Line2);
        let joined: HashSet<(u32, u32)> =
            short.flat_map(|block| block.nodes.chunks_exact(2)).map(|n| (n[0].min(n[1]), n[0].max(n[1]))).collect();
        found.retain(|pair| !joined.contains(pair));
    }
    found
}

/// Nodes of the tubes inside: of the elements, and of all lines that go on from there.
fn inner_tubes(mesh: &Mesh, tube: &TubeDefinition) -> BTreeSet<u32> {
    let mut lines: BTreeMap<u32, Vec<&[u32]>> = BTreeMap::new();
    for block in mesh.blocks.iter().filter(|block| block.kind.dimension() == 1) {
        for line in block.nodes.chunks_exact(block.kind.nodes()) {
            line.iter().for_each(|&node| lines.entry(node).or_default().push(line));
        }
    }
    let mut inner = BTreeSet::new();
    let mut next: Vec<u32> = tube.cells.iter().flat_map(|&cell| mesh.cell(cell)).copied().collect();
    while let Some(node) = next.pop() {
        if inner.insert(node) {
            next.extend(lines.get(&node).into_iter().flatten().copied().flatten());
        }
    }
    inner
}

const SECONDARY: u8 = 1;
const MAIN: u8 = 2;

/// On which sides of a pair each node is, `[points]`.
fn sides(mesh: &Mesh, (secondary, main): (&Secondary, &Main)) -> Vec<u8> {
    let mut sides = vec![0; mesh.points.len()];
    if let Main::Faces(faces) = main {
        faces.iter().flat_map(|&face| mesh.face(face).1).for_each(|node| sides[node as usize] |= MAIN);
    }
    secondary.nodes(mesh).into_iter().for_each(|node| sides[node as usize] |= SECONDARY);
    sides
}
