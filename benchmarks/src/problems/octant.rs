//! An octant of a hollow sphere, mapped by three blocks that meet on the diagonal.

use fe_core::element::ElementType;
use fe_mesh::Mesh;
use fe_mesh::generate::Block;
use std::collections::BTreeMap;
use std::f64::consts::FRAC_PI_4;

/// `n` cells through the wall between two radii [L], `around` cells along an eighth of a circle; bricks, or each brick
/// as six tetrahedra; points in the middle of edges lie on the spheres too. The surfaces are `ZMIN` inside and `ZMAX`
/// outside, the node sets `XSYM`, `YSYM`, `ZSYM` hold the planes of symmetry, `BLOCK` is all.
///
/// Each block is a square of a cube's face seen from the centre at even angles: (1, tan πs/4, tan πt/4), its
/// coordinates in turn for the others. Neighbours share their places and the diagonals of their faces.
pub fn octant(element: ElementType, [n, around]: [usize; 2], [inner, outer]: [f64; 2]) -> Mesh {
    let divisions = [around, around, n];
    let block = match element {
        ElementType::C3D8 => Block::hex8(divisions),
        ElementType::C3D4 => Block::tet4(divisions),
        _ => Block::tet10(divisions),
    };
    let part = |turn: usize| {
        let mut mesh = block.mapped(|[s, t, through]| {
            let way = [1.0, (FRAC_PI_4 * s).tan(), (FRAC_PI_4 * t).tan()];
            let scale = (inner + through * (outer - inner)) / way.iter().map(|x| x * x).sum::<f64>().sqrt();
            std::array::from_fn(|axis| scale * way[(axis + 3 - turn) % 3])
        });
        mesh.node_sets.clear();
        mesh
    };
    let mut mesh = part(0);
    (1..3).for_each(|turn| mesh.append(&part(turn)));
    let mut mesh = welded(mesh, 1e-6 * (outer - inner) / n as f64);
    let all: Vec<u32> = (0..mesh.points.len() as u32).collect();
    for (axis, name) in ["XSYM", "YSYM", "ZSYM"].into_iter().enumerate() {
        let on_it = |&node: &u32| mesh.points[node as usize][axis].abs() < 1e-9 * inner;
        let nodes = all.iter().copied().filter(on_it).collect();
        mesh.node_sets.insert(name.into(), nodes);
    }
    mesh.node_sets.insert("BLOCK".into(), all);
    mesh
}

/// The mesh with points that are no further apart than round-off, far below `size` [L], made one; without node sets.
fn welded(mut mesh: Mesh, size: f64) -> Mesh {
    let mut known = BTreeMap::<[i64; 3], u32>::new();
    let mut kept = Vec::new();
    let place = |point: &[f64; 3]| -> u32 {
        // Points a rounding apart may fall on either side of a half: both ways are looked up.
        let next = kept.len() as u32;
        let down = point.map(|x| (x / size + 0.25).floor() as i64);
        let up = point.map(|x| (x / size - 0.25).ceil() as i64);
        let keys = (0..8).map(|way| [0, 1, 2].map(|axis| if way >> axis & 1 == 0 { down[axis] } else { up[axis] }));
        let found = keys.clone().find_map(|key| known.get(&key).copied());
        if found.is_none() {
            kept.push(*point);
            keys.for_each(|key| {
                known.insert(key, next);
            });
        }
        found.unwrap_or(next)
    };
    let new: Vec<u32> = mesh.points.iter().map(place).collect();
    mesh.blocks.iter_mut().flat_map(|block| &mut block.nodes).for_each(|node| *node = new[*node as usize]);
    mesh.point_labels = (1..=kept.len() as u64).collect();
    mesh.points = kept;
    mesh
}

#[cfg(test)]
mod tests {
    use super::*;
    use fe_mesh::Face;

    /// Blocks of 4 × 4 × 2 bricks: three times 5 × 5 points on a sphere, less the three common edges of 5 points counted
    /// twice, less the common corner counted three times. All faces but those of the boundary belong to two cells.
    #[test]
    fn blocks_share_points_and_faces() {
        for element in [ElementType::C3D8, ElementType::C3D4, ElementType::C3D10] {
            let mesh = octant(element, [2, 4], [30.0, 50.0]);
            let steps = if element == ElementType::C3D10 { 8 } else { 4 };
            let on_a_sphere = 3 * (steps + 1) * (steps + 1) - 3 * (steps + 1) + 1;
            assert_eq!(mesh.points.len(), on_a_sphere * (steps / 2 + 1), "{element:?}");
            assert_eq!(mesh.node_sets["XSYM"].len(), (2 * steps + 1) * (steps / 2 + 1));
            let mut count = BTreeMap::<Vec<u32>, usize>::new();
            for cell in mesh.cells() {
                for face in 0..mesh.kind(cell).faces().len() {
                    let mut nodes = mesh.face(Face { cell, face: face as u8 }).1;
                    nodes.sort_unstable();
                    *count.entry(nodes).or_default() += 1;
                }
            }
            assert!(count.values().all(|&cells| cells <= 2));
            let outer = count.values().filter(|&&cells| cells == 1).count();
            let facets = if element == ElementType::C3D8 { 1 } else { 2 };
            // 3 · 16 squares on each sphere, 8 · 2 on each plane of symmetry.
            assert_eq!(outer, facets * (2 * 3 * 16 + 3 * 8 * 2), "{element:?}");
            assert_eq!(mesh.surfaces["ZMIN"].len(), facets * 48);
            let radius = |node: &u32| mesh.points[*node as usize].iter().map(|x| x * x).sum::<f64>().sqrt();
            let inside = mesh.surfaces["ZMIN"].iter().flat_map(|&face| mesh.face(face).1);
            inside.for_each(|node| assert!((radius(&node) - 30.0).abs() < 1e-12));
        }
    }
}
