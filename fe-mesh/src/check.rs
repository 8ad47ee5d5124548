//! What is odd about a mesh but stops no one: points on points, cells twice, points without a cell.

use crate::mesh::{CellId, Mesh};
use std::fmt;

/// One thing that was found, with the labels of all that it is about.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Finding {
    /// Points that lie on others: `[first, second]` of each pair. Bodies that meet without a common mesh have them, a
    /// body that should be one piece should not.
    CoincidentPoints(Vec<[u64; 2]>),
    /// Cells with the same points as another one, whatever their order: `[first, second]` of each pair.
    DuplicateCells(Vec<[u64; 2]>),
    /// Points that no cell has.
    UnusedPoints(Vec<u64>),
}

impl fmt::Display for Finding {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        match self {
            Finding::CoincidentPoints(pairs) => {
                write!(f, "{} pairs of nodes lie on each other ({})", pairs.len(), first_pairs(pairs))
            }
            Finding::DuplicateCells(pairs) => {
                write!(f, "{} elements have the nodes of another one ({})", pairs.len(), first_pairs(pairs))
            }
            Finding::UnusedPoints(labels) => {
                let shown: Vec<String> = labels.iter().take(5).map(u64::to_string).collect();
                let more = if labels.len() > 5 { ", …" } else { "" };
                write!(f, "{} nodes belong to no element ({}{more})", labels.len(), shown.join(", "))
            }
        }
    }
}

/// The first pairs, to be shown.
fn first_pairs(pairs: &[[u64; 2]]) -> String {
    let shown: Vec<String> = pairs.iter().take(3).map(|[a, b]| format!("{a} and {b}")).collect();
    let more = if pairs.len() > 3 { ", …" } else { "" };
    format!("{}{more}", shown.join(", "))
}

/// All findings. Points are coincident when closer than `tolerance` times the diagonal of the mesh's box; 1e-9 is
/// far above rounding and far below any cell.
pub fn check(mesh: &Mesh, tolerance: f64) -> Vec<Finding> {
    let mut findings = Vec::new();
    let coincident = coincident_points(&mesh.points, tolerance);
    if !coincident.is_empty() {
        let labels = |(a, b): (u32, u32)| [mesh.point_labels[a as usize], mesh.point_labels[b as usize]];
        findings.push(Finding::CoincidentPoints(coincident.into_iter().map(labels).collect()));
    }
    let duplicates = duplicate_cells(mesh);
    if !duplicates.is_empty() {
        let labels = |(a, b): (CellId, CellId)| [mesh.cell_label(a), mesh.cell_label(b)];
        findings.push(Finding::DuplicateCells(duplicates.into_iter().map(labels).collect()));
    }
    let unused = unused_points(mesh);
    if !unused.is_empty() {
        let labels = unused.into_iter().map(|point| mesh.point_labels[point as usize]);
        findings.push(Finding::UnusedPoints(labels.collect()));
    }
    findings
}

/// Pairs of points (lower index first, ascending) closer than `tolerance` times the diagonal of their box.
pub fn coincident_points(points: &[[f64; 3]], tolerance: f64) -> Vec<(u32, u32)> {
    let low = points.iter().fold([f64::INFINITY; 3], |low, x| std::array::from_fn(|k| low[k].min(x[k])));
    let high = points.iter().fold([f64::NEG_INFINITY; 3], |high, x| std::array::from_fn(|k| high[k].max(x[k])));
    let near = tolerance * distance_squared(&low, &high).sqrt();
    // Along a direction that no plane of a structured mesh is normal to, near points are near and few others are.
    let direction = [0.480_384_461_415, 0.620_173_672_946, 0.620_173_672_946 * std::f64::consts::FRAC_1_SQRT_2];
    let mut sorted: Vec<(f64, u32)> = points
        .iter()
        .enumerate()
        .map(|(i, x)| ((0..3).map(|k| direction[k] * (x[k] - low[k])).sum(), i as u32))
        .collect();
    sorted.sort_unstable_by(|a, b| a.0.total_cmp(&b.0).then(a.1.cmp(&b.1)));
    // The direction is shorter than 1, and the sums above are rounded.
    let window = near + 8.0 * f64::EPSILON * distance_squared(&low, &high).sqrt();
    let mut pairs = Vec::new();
    for (i, &(along, a)) in sorted.iter().enumerate() {
        for &(_, b) in sorted[i + 1..].iter().take_while(|(other, _)| other - along <= window) {
            if distance_squared(&points[a as usize], &points[b as usize]) <= near * near {
                pairs.push((a.min(b), a.max(b)));
            }
        }
    }
    pairs.sort_unstable();
    pairs
}

fn distance_squared(a: &[f64; 3], b: &[f64; 3]) -> f64 {
    (0..3).map(|k| (a[k] - b[k]) * (a[k] - b[k])).sum()
}

/// Pairs of cells with the same points, the first of them and each other one, ascending.
pub fn duplicate_cells(mesh: &Mesh) -> Vec<(CellId, CellId)> {
    // Cells by the least of their points: those with the same points stand together.
    let mut sorted: Vec<(u32, CellId)> =
        mesh.cells().filter_map(|id| mesh.cell(id).iter().min().map(|&point| (point, id))).collect();
    sorted.sort_unstable();
    let mut pairs = Vec::new();
    for cells in sorted.chunk_by(|a, b| a.0 == b.0).filter(|cells| cells.len() > 1) {
        let mut keys: Vec<(Vec<u32>, CellId)> = cells
            .iter()
            .map(|&(_, id)| {
                let mut points = mesh.cell(id).to_vec();
                points.sort_unstable();
                (points, id)
            })
            .collect();
        keys.sort_unstable();
        for same in keys.chunk_by(|a, b| a.0 == b.0) {
            pairs.extend(same[1..].iter().map(|other| (same[0].1, other.1)));
        }
    }
    pairs.sort_unstable();
    pairs
}

/// Points that no cell has, ascending.
pub fn unused_points(mesh: &Mesh) -> Vec<u32> {
    let mut used = vec![false; mesh.points.len()];
    for &point in mesh.blocks.iter().flat_map(|block| &block.nodes) {
        used[point as usize] = true;
    }
    (0..used.len() as u32).filter(|&point| !used[point as usize]).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::generate::Block;

    /// A sound mesh has no finding.
    #[test]
    fn nothing_to_say() {
        for mesh in [Block::tet10([2, 2, 2]).mesh(), Block::quad4([5, 3]).mesh()] {
            assert_eq!(check(&mesh, 1e-9), []);
        }
        assert_eq!(check(&Mesh::default(), 1e-9), []);
    }

    /// Two blocks side by side share no node, but nine places; one step apart by more than the tolerance, none.
    #[test]
    fn coincident_nodes() {
        let lower = Block::hex8([2, 2, 1]).mesh();
        for (gap, pairs) in [(0.0, 9), (1e-10, 9), (1e-8, 0)] {
            let mut both = lower.clone();
            both.append(&Block::hex8([2, 2, 1]).origin([0.0, 0.0, 1.0 + gap]).mesh());
            let findings = check(&both, 1e-9);
            if pairs == 0 {
                assert_eq!(findings, []);
                continue;
            }
            let [Finding::CoincidentPoints(found)] = &findings[..] else { panic!("{findings:?}") };
            let top = (10..=18).map(|label| [label, label + 9]);
            assert_eq!(*found, top.collect::<Vec<_>>(), "gap {gap}");
            assert_eq!(
                findings[0].to_string(),
                "9 pairs of nodes lie on each other (10 and 19, 11 and 20, 12 and 21, …)"
            );
        }
    }

    /// Cells twice are found whatever their node order; a node of no cell is named.
    #[test]
    fn cells_twice_and_nodes_alone() {
        let mut mesh = Block::tri3([2, 2]).mesh();
        let [a, b, c] = [3, 4, 5].map(|i| mesh.blocks[0].nodes[i]);
        mesh.blocks[0].nodes.extend([c, a, b]);
        mesh.blocks[0].labels.push(77);
        mesh.points.push([5.0, 0.0, 0.0]);
        mesh.point_labels.push(900);
        assert_eq!(check(&mesh, 1e-9), [Finding::DuplicateCells(vec![[2, 77]]), Finding::UnusedPoints(vec![900])]);
    }
}
