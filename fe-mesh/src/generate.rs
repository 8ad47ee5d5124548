//! Generated meshes: blocks of bricks, tetrahedra, quadrangles or triangles, and two meshes in one.

mod append;
mod lattice;

use crate::cell::CellKind;
use crate::mesh::{CellBlock, CellId, Face, Mesh};
use lattice::Lattice;

/// A box (or rectangle) cut into cells, along the axes before it is mapped.
///
/// Its mesh has the node and cell set `BLOCK` and, for every side `XMIN`, `XMAX`, `YMIN`, …, a node set and a
/// surface. Labels count from 1.
#[derive(Clone, Debug, PartialEq)]
pub struct Block {
    kind: CellKind,
    divisions: [usize; 3],
    size: [f64; 3],
    origin: [f64; 3],
}

impl Block {
    /// Bricks of 8 nodes.
    pub fn hex8(divisions: [usize; 3]) -> Self {
        Block::of(CellKind::Hex8, divisions)
    }

    /// Tetrahedra of 4 nodes, six a brick, all with an edge on the brick's diagonal (Kuhn's division).
    pub fn tet4(divisions: [usize; 3]) -> Self {
        Block::of(CellKind::Tet4, divisions)
    }

    /// Tetrahedra of 10 nodes, cut as [`Block::tet4`].
    pub fn tet10(divisions: [usize; 3]) -> Self {
        Block::of(CellKind::Tet10, divisions)
    }

    /// Quadrangles of 4 nodes in the plane z = 0.
    pub fn quad4(divisions: [usize; 2]) -> Self {
        Block::of(CellKind::Quad4, [divisions[0], divisions[1], 0])
    }

    /// Triangles of 3 nodes in the plane z = 0, two a rectangle.
    pub fn tri3(divisions: [usize; 2]) -> Self {
        Block::of(CellKind::Tri3, [divisions[0], divisions[1], 0])
    }

    /// The unit cube or square with these divisions; none counts as one.
    fn of(kind: CellKind, divisions: [usize; 3]) -> Self {
        let axes = kind.dimension();
        let divisions = std::array::from_fn(|axis| if axis < axes { divisions[axis].max(1) } else { 0 });
        Block { kind, divisions, size: std::array::from_fn(|axis| (axis < axes) as usize as f64), origin: [0.0; 3] }
    }

    /// Sets the edge lengths [L]; a plane block takes no third one.
    pub fn size(mut self, size: [f64; 3]) -> Self {
        self.size = std::array::from_fn(|axis| if self.divisions[axis] > 0 { size[axis] } else { 0.0 });
        self
    }

    /// Sets the corner with the least coordinates [L].
    pub fn origin(mut self, origin: [f64; 3]) -> Self {
        self.origin = origin;
        self
    }

    /// The mesh.
    pub fn mesh(&self) -> Mesh {
        self.mapped(|x| x)
    }

    /// The mesh with every point of the box moved to `map(point)`, points on edges of cells included. Cells stay
    /// right way round as long as `map` keeps orientation.
    pub fn mapped(&self, map: impl Fn([f64; 3]) -> [f64; 3]) -> Mesh {
        let lattice = Lattice::new(self.divisions, if self.kind == CellKind::Tet10 { 2 } else { 1 });
        let mut mesh = Mesh::default();
        for place in lattice.places() {
            let at = |axis: usize| match lattice.steps(axis) {
                0 => self.origin[axis],
                steps => self.origin[axis] + self.size[axis] * (place[axis] as f64 / steps as f64),
            };
            mesh.points.push(map([at(0), at(1), at(2)]));
        }
        mesh.point_labels = (1..=mesh.points.len() as u64).collect();
        let nodes = lattice.cells(self.kind);
        let labels = (1..=(nodes.len() / self.kind.nodes()) as u64).collect();
        mesh.blocks.push(CellBlock { kind: self.kind, labels, nodes });
        mesh.node_sets.insert("BLOCK".to_string(), (0..mesh.points.len() as u32).collect());
        mesh.cell_sets.insert("BLOCK".to_string(), mesh.cells().collect());
        for axis in 0..self.kind.dimension() {
            for (end, value) in [("MIN", 0), ("MAX", lattice.steps(axis))] {
                let name = format!("{}{end}", ["X", "Y", "Z"][axis]);
                let on_side: Vec<bool> = lattice.places().map(|place| place[axis] == value).collect();
                let nodes = (0..on_side.len() as u32).filter(|&node| on_side[node as usize]).collect();
                mesh.surfaces.insert(name.clone(), faces_within(&mesh, &on_side));
                mesh.node_sets.insert(name, nodes);
            }
        }
        mesh
    }
}

/// The faces of cells all of whose nodes are chosen.
fn faces_within(mesh: &Mesh, chosen: &[bool]) -> Vec<Face> {
    let faces_of = |id: CellId| {
        let cell = mesh.cell(id);
        let faces = mesh.kind(id).faces().iter().enumerate();
        faces.filter_map(move |(face, (_, local))| {
            local.iter().all(|&i| chosen[cell[i] as usize]).then_some(Face { cell: id, face: face as u8 })
        })
    };
    mesh.cells().flat_map(faces_of).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn blocks() -> [Block; 5] {
        [
            Block::hex8([2, 3, 4]),
            Block::tet4([2, 3, 4]),
            Block::tet10([2, 3, 4]),
            Block::quad4([2, 3]),
            Block::tri3([2, 3]),
        ]
        .map(|block| block.size([2.0, 1.0, 0.5]).origin([-1.0, 5.0, 0.25]))
    }

    /// Area of a flat face seen from its side: half the sum of cross products over its corners, an outward vector.
    fn area_vector(mesh: &Mesh, face: Face) -> [f64; 3] {
        let (kind, nodes) = mesh.face(face);
        let corners = match kind {
            CellKind::Line2 | CellKind::Line3 => {
                let [a, b] = [0, 1].map(|i| mesh.points[nodes[i] as usize]);
                return [b[1] - a[1], a[0] - b[0], 0.0];
            }
            CellKind::Tri3 | CellKind::Tri6 => 3,
            _ => 4,
        };
        let mut sum = [0.0; 3];
        for i in 0..corners {
            let (a, b) = (mesh.points[nodes[i] as usize], mesh.points[nodes[(i + 1) % corners] as usize]);
            for (k, sum) in sum.iter_mut().enumerate() {
                let (p, q) = ((k + 1) % 3, (k + 2) % 3);
                *sum += 0.5 * (a[p] * b[q] - a[q] * b[p]);
            }
        }
        sum
    }

    /// Outward area of all faces of a cell times position is its volume (divergence theorem): positive for each cell,
    /// in sum the box; a cell's faces close. Sides have the box's areas, outward. Rounding only: 1e-13.
    #[test]
    fn cells_fill_the_box_and_sides_bound_it() {
        for block in blocks() {
            let mesh = block.mesh();
            let plane = block.kind.dimension() == 2;
            let mut total = 0.0;
            for id in mesh.cells() {
                let mut volume = 0.0;
                let mut closed = [0.0; 3];
                for face in 0..mesh.kind(id).faces().len() {
                    let face = Face { cell: id, face: face as u8 };
                    let area = area_vector(&mesh, face);
                    let on_it = mesh.points[mesh.face(face).1[0] as usize];
                    volume += (0..3).map(|k| area[k] * on_it[k]).sum::<f64>() / block.kind.dimension() as f64;
                    (0..3).for_each(|k| closed[k] += area[k]);
                }
                assert!(volume > 0.0, "{:?}", block.kind);
                assert!(closed.iter().all(|c| c.abs() < 1e-13));
                total += volume;
            }
            assert!((total - if plane { 2.0 } else { 1.0 }).abs() < 1e-13, "{total}");
            let sizes = if plane { [1.0, 2.0, 0.0] } else { [0.5, 1.0, 2.0] };
            for (axis, letter) in ["X", "Y", "Z"].iter().enumerate().take(block.kind.dimension()) {
                for (end, sign) in [("MIN", -1.0), ("MAX", 1.0)] {
                    let side = &mesh.surfaces[&format!("{letter}{end}")];
                    let area: f64 = side.iter().map(|&face| area_vector(&mesh, face)[axis]).sum();
                    assert!((area - sign * sizes[axis]).abs() < 1e-13, "{:?} {letter}{end} {area}", block.kind);
                    let mut nodes: Vec<u32> = side.iter().flat_map(|&face| mesh.face(face).1).collect();
                    nodes.sort_unstable();
                    nodes.dedup();
                    assert_eq!(nodes, mesh.node_sets[&format!("{letter}{end}")]);
                }
            }
        }
    }

    /// Every inner face is shared by exactly two cells: the division into tetrahedra fits from brick to brick. So
    /// there are (all faces + outer faces) / 2 different ones.
    #[test]
    fn neighbours_fit() {
        for block in blocks() {
            let mesh = block.mesh();
            let outer: usize = mesh.surfaces.values().map(Vec::len).sum();
            let mut faces: Vec<Vec<u32>> = Vec::new();
            for id in mesh.cells() {
                for face in 0..mesh.kind(id).faces().len() {
                    let mut nodes = mesh.face(Face { cell: id, face: face as u8 }).1;
                    nodes.sort_unstable();
                    faces.push(nodes);
                }
            }
            let all = faces.len();
            faces.sort_unstable();
            faces.dedup();
            assert_eq!(2 * faces.len(), all + outer, "{:?}", block.kind);
        }
    }

    /// Middle nodes of straight tetrahedra lie half-way between their edge's ends (all coordinates are exact in binary),
    /// and go where the map takes them.
    #[test]
    fn middle_nodes() {
        let mesh = Block::tet10([1, 2, 1]).mesh();
        let bent = Block::tet10([1, 2, 1]).mapped(|[x, y, z]| [x, y, z + x * x]);
        let edges = [[0, 1], [1, 2], [2, 0], [0, 3], [1, 3], [2, 3]];
        for id in mesh.cells() {
            let cell = mesh.cell(id);
            for (middle, [a, b]) in edges.iter().enumerate() {
                let [a, b, m] = [cell[*a], cell[*b], cell[4 + middle]].map(|i| mesh.points[i as usize]);
                assert_eq!(m, std::array::from_fn(|k| 0.5 * (a[k] + b[k])));
                let [x, y, z] = m;
                assert_eq!(bent.points[cell[4 + middle] as usize], [x, y, z + x * x]);
            }
        }
    }
}
