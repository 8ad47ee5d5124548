//! Writes meshes in format 4.1.

use super::kind::to_gmsh;
use super::out::Out;
use crate::cell::CellKind;
use crate::mesh::Mesh;
use std::collections::BTreeMap;

/// How a file is written.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Encoding {
    /// Text; numbers in the shortest form that reads back the same.
    Text,
    /// Binary, little-endian.
    Binary,
}

/// The mesh in gmsh's format 4.1: cell sets, surfaces and node sets as physical groups of their names. A node set that
/// holds just the nodes of the cell set or surface of the same name is left to it: the reader makes it again.
pub fn write(mesh: &Mesh, encoding: Encoding) -> Vec<u8> {
    let plan = Plan::of(mesh);
    let mut out = Out::new(encoding == Encoding::Binary);
    out.line("$MeshFormat");
    out.line(if out.is_binary() { "4.1 1 8" } else { "4.1 0 8" });
    if out.is_binary() {
        out.int(1);
        out.end();
    }
    out.line("$EndMeshFormat\n$PhysicalNames");
    out.line(&plan.groups.len().to_string());
    for (tag, (dimension, name)) in plan.groups.iter().enumerate() {
        out.line(&format!("{dimension} {} \"{name}\"", tag + 1));
    }
    out.line("$EndPhysicalNames\n$Entities");
    write_entities(&mut out, mesh, &plan);
    out.line("$EndEntities\n$Nodes");
    write_nodes(&mut out, mesh, &plan);
    out.line("$EndNodes\n$Elements");
    write_elements(&mut out, &plan);
    out.line("$EndElements");
    out.into_bytes()
}

/// Elements on one entity: all in the same groups.
struct Entity {
    dimension: usize,
    tag: i32,
    /// Numbers of its groups.
    groups: Vec<i32>,
    /// Elements by kind: labels, point indices.
    elements: BTreeMap<CellKind, (Vec<u64>, Vec<u32>)>,
}

/// What is written.
struct Plan<'a> {
    /// Dimension and name of each group; numbered from 1.
    groups: Vec<(usize, &'a str)>,
    /// Entities, ascending by dimension.
    entities: Vec<Entity>,
    /// Labels of the points.
    labels: &'a [u64],
}

/// One element of a group: kind, label, points.
type Element = (CellKind, u64, Vec<u32>);

impl<'a> Plan<'a> {
    fn of(mesh: &'a Mesh) -> Self {
        let mut plan = Plan { groups: Vec::new(), entities: Vec::new(), labels: &mesh.point_labels };
        let mut next = 1 + mesh.blocks.iter().flat_map(|block| &block.labels).max().copied().unwrap_or(0);
        let mut number = || {
            next += 1;
            next - 1
        };
        let loose = mesh.node_sets.iter().filter(|(name, nodes)| !is_made_again(mesh, name, nodes));
        let points: Vec<(&str, Vec<Element>)> = loose
            .map(|(name, nodes)| {
                (name.as_str(), nodes.iter().map(|&n| (CellKind::Point1, n as u64, vec![n])).collect())
            })
            .collect();
        let faces: Vec<(&str, Vec<Element>)> = mesh
            .surfaces
            .iter()
            .map(|(name, faces)| {
                (
                    name.as_str(),
                    faces
                        .iter()
                        .enumerate()
                        .map(|(i, &face)| {
                            let (kind, nodes) = mesh.face(face);
                            (kind, i as u64, nodes)
                        })
                        .collect(),
                )
            })
            .collect();
        plan.add_lower(points, &mut number);
        plan.add_lower(faces, &mut number);
        plan.add_cells(mesh);
        plan.entities.sort_by_key(|entity| (entity.dimension, entity.tag));
        plan
    }

    /// Adds groups whose elements are not numbered yet: one element for each set of nodes, whatever groups it is in.
    fn add_lower(&mut self, groups: Vec<(&'a str, Vec<Element>)>, number: &mut impl FnMut() -> u64) {
        let mut groups_of: BTreeMap<(CellKind, Vec<u32>), Vec<i32>> = BTreeMap::new();
        for (name, elements) in groups {
            let Some(first) = elements.first() else { continue };
            self.groups.push((first.0.dimension(), name));
            let tag = self.groups.len() as i32;
            for (kind, _, nodes) in elements {
                groups_of.entry((kind, nodes)).or_default().push(tag);
            }
        }
        for ((kind, nodes), groups) in groups_of {
            self.entity(kind.dimension(), groups).push(kind, number(), &nodes);
        }
    }

    /// Adds the cells with their sets.
    fn add_cells(&mut self, mesh: &'a Mesh) {
        let mut groups_of: Vec<Vec<Vec<i32>>> = mesh.blocks.iter().map(|block| vec![Vec::new(); block.len()]).collect();
        for (name, cells) in &mesh.cell_sets {
            let Some(first) = cells.first() else { continue };
            self.groups.push((mesh.kind(*first).dimension(), name));
            for id in cells {
                groups_of[id.block as usize][id.cell as usize].push(self.groups.len() as i32);
            }
        }
        for (block, groups) in mesh.blocks.iter().zip(groups_of) {
            for (i, groups) in groups.into_iter().enumerate() {
                self.entity(block.kind.dimension(), groups).push(block.kind, block.labels[i], block.cell(i));
            }
        }
    }

    /// The entity of this dimension in these groups.
    fn entity(&mut self, dimension: usize, groups: Vec<i32>) -> &mut Entity {
        // Neighbours mostly share it: look from the end.
        let same = |entity: &Entity| entity.dimension == dimension && entity.groups == groups;
        let place = self.entities.iter().rposition(same).unwrap_or_else(|| {
            let tag = 1 + self.entities.iter().filter(|entity| entity.dimension == dimension).count() as i32;
            self.entities.push(Entity { dimension, tag, groups, elements: BTreeMap::new() });
            self.entities.len() - 1
        });
        &mut self.entities[place]
    }
}

impl Entity {
    fn push(&mut self, kind: CellKind, label: u64, nodes: &[u32]) {
        let (labels, all) = self.elements.entry(kind).or_default();
        labels.push(label);
        all.extend_from_slice(nodes);
    }
}

/// Whether reading the cell set or surface of this name gives the node set again.
fn is_made_again(mesh: &Mesh, name: &str, nodes: &[u32]) -> bool {
    let cells = mesh.cell_sets.get(name).into_iter().flatten().flat_map(|&id| mesh.cell(id).to_vec());
    let faces = mesh.surfaces.get(name).into_iter().flatten().flat_map(|&face| mesh.face(face).1);
    let mut made: Vec<u32> = cells.chain(faces).collect();
    made.sort_unstable();
    made.dedup();
    !made.is_empty() && made == nodes
}

fn write_entities(out: &mut Out, mesh: &Mesh, plan: &Plan) {
    for dimension in 0..4 {
        out.size(plan.entities.iter().filter(|entity| entity.dimension == dimension).count() as u64);
    }
    out.end_of_text_line();
    for entity in &plan.entities {
        out.int(entity.tag);
        let nodes = || entity.elements.values().flat_map(|(_, nodes)| nodes).map(|&node| mesh.points[node as usize]);
        let low = nodes().fold([f64::INFINITY; 3], |low, x| std::array::from_fn(|i| low[i].min(x[i])));
        let high = nodes().fold([f64::NEG_INFINITY; 3], |high, x| std::array::from_fn(|i| high[i].max(x[i])));
        low.iter().for_each(|&x| out.float(x));
        if entity.dimension > 0 {
            high.iter().for_each(|&x| out.float(x));
        }
        out.size(entity.groups.len() as u64);
        entity.groups.iter().for_each(|&group| out.int(group));
        if entity.dimension > 0 {
            out.size(0);
        }
        out.end_of_text_line();
    }
    out.end_of_binary();
}

fn write_nodes(out: &mut Out, mesh: &Mesh, plan: &Plan) {
    let blocks = usize::from(!plan.labels.is_empty());
    let least = plan.labels.iter().min().copied().unwrap_or(0);
    let most = plan.labels.iter().max().copied().unwrap_or(0);
    for value in [blocks as u64, plan.labels.len() as u64, least, most] {
        out.size(value);
    }
    out.end_of_text_line();
    if blocks == 1 {
        // All nodes stand on the last entity, one of the highest dimension.
        let (dimension, tag) = plan.entities.last().map_or((0, 1), |entity| (entity.dimension as i32, entity.tag));
        for value in [dimension, tag, 0] {
            out.int(value);
        }
        out.size(plan.labels.len() as u64);
        out.end_of_text_line();
        for &label in plan.labels {
            out.size(label);
            out.end_of_text_line();
        }
        for point in &mesh.points {
            point.iter().for_each(|&x| out.float(x));
            out.end_of_text_line();
        }
    }
    out.end_of_binary();
}

fn write_elements(out: &mut Out, plan: &Plan) {
    let blocks = || plan.entities.iter().flat_map(|entity| entity.elements.iter().map(move |block| (entity, block)));
    let labels = || blocks().flat_map(|(_, (_, (labels, _)))| labels.iter().copied());
    let (least, most) = (labels().min().unwrap_or(0), labels().max().unwrap_or(0));
    for value in [blocks().count() as u64, labels().count() as u64, least, most] {
        out.size(value);
    }
    out.end_of_text_line();
    for (entity, (&kind, (labels, nodes))) in blocks() {
        let (number, order) = to_gmsh(kind);
        for value in [entity.dimension as i32, entity.tag, number] {
            out.int(value);
        }
        out.size(labels.len() as u64);
        out.end_of_text_line();
        let mut gmsh_nodes = vec![0; kind.nodes()];
        for (label, element) in labels.iter().zip(nodes.chunks_exact(kind.nodes())) {
            gmsh_nodes.copy_from_slice(element);
            for (deck, &gmsh) in order.iter().enumerate() {
                gmsh_nodes[gmsh as usize] = element[deck];
            }
            out.size(*label);
            gmsh_nodes.iter().for_each(|&node| out.size(plan.labels[node as usize]));
            out.end_of_text_line();
        }
    }
    out.end_of_binary();
}
