//! C01: constant strain on MacNeal and Harder's meshes (Finite Elements in Analysis and Design 1 (1985) 3).

use crate::bodies::{block, components, distorted, sides, straighten};
use crate::deck::{material, prescribed, run, step};
use fe_core::element::ElementType::{self, *};
use fe_core::element::Space;
use fe_mesh::{CellBlock, CellKind, Mesh};

/// The plate 0.24 × 0.12 of five quadrilaterals, or of ten triangles, moved by `offset` along x.
fn plate(kind: CellKind, offset: f64) -> Mesh {
    let corners = [[0.0, 0.0], [0.24, 0.0], [0.24, 0.12], [0.0, 0.12]];
    let inner = [[0.04, 0.02], [0.18, 0.03], [0.16, 0.08], [0.08, 0.08]];
    let cells = [[0, 1, 5, 4], [1, 2, 6, 5], [2, 3, 7, 6], [3, 0, 4, 7], [4, 5, 6, 7]];
    let points = corners.iter().chain(&inner).map(|&[x, y]| [x + offset, y, 0.0]).collect();
    let nodes = match kind {
        CellKind::Tri3 => cells.iter().flat_map(|&[a, b, c, d]| [a, b, c, a, c, d]).collect(),
        _ => cells.concat(),
    };
    assembled(kind, points, nodes, 4)
}

/// The unit cube of seven bricks.
fn cube() -> Mesh {
    let outer = [[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0], [0, 0, 1], [1, 0, 1], [1, 1, 1], [0, 1, 1]];
    let inner = [
        [0.249, 0.342, 0.192],
        [0.826, 0.288, 0.288],
        [0.850, 0.649, 0.263],
        [0.273, 0.750, 0.230],
        [0.320, 0.186, 0.643],
        [0.677, 0.305, 0.683],
        [0.788, 0.693, 0.644],
        [0.165, 0.745, 0.702],
    ];
    let points = outer.iter().map(|p| p.map(f64::from)).chain(inner).collect();
    let cells = [
        [8, 9, 10, 11, 12, 13, 14, 15],
        [0, 1, 2, 3, 8, 9, 10, 11],
        [12, 13, 14, 15, 4, 5, 6, 7],
        [0, 1, 9, 8, 4, 5, 13, 12],
        [1, 2, 10, 9, 5, 6, 14, 13],
        [2, 3, 11, 10, 6, 7, 15, 14],
        [3, 0, 8, 11, 7, 4, 12, 15],
    ];
    assembled(CellKind::Hex8, points, cells.concat(), 8)
}

/// One block of cells; the first `outer` points are the node set XMIN.
fn assembled(kind: CellKind, points: Vec<[f64; 3]>, nodes: Vec<u32>, outer: u32) -> Mesh {
    let labels = (1..=(nodes.len() / kind.nodes()) as u64).collect();
    let mut mesh = Mesh { point_labels: (1..=points.len() as u64).collect(), points, ..Mesh::default() };
    mesh.blocks.push(CellBlock { kind, labels, nodes });
    mesh.cell_sets.insert("BLOCK".into(), mesh.cells().collect());
    mesh.node_sets.insert("XMIN".into(), (0..outer).collect());
    mesh
}

/// Displacement of constant strain.
fn field(space: Space, [x, y, z]: [f64; 3]) -> [f64; 3] {
    match space {
        Space::Solid | Space::Any => [2.0 * x + y + z, x + 2.0 * y + z, x + y + 2.0 * z].map(|u| 0.5e-3 * u),
        Space::Axisymmetric => [1e-3 * x, 2e-3 * y, 0.0],
        _ => [1e-3 * (x + 0.5 * y), 1e-3 * (y + 0.5 * x), 0.0],
    }
}

/// Its stress at E = 1e6, ν = 1/4: λ = μ = 4e5. In plane strain ε = 1e-3 twice; around the axis 1e-3, 2e-3 and 1e-3.
fn stress(space: Space) -> [f64; 6] {
    match space {
        Space::Solid | Space::Any => [2000.0, 2000.0, 2000.0, 400.0, 400.0, 400.0],
        Space::PlaneStress | Space::Plane => [4000.0 / 3.0, 4000.0 / 3.0, 0.0, 400.0, 0.0, 0.0],
        Space::PlaneStrain => [1600.0, 1600.0, 800.0, 400.0, 0.0, 0.0],
        Space::Axisymmetric => [2400.0, 3200.0, 2400.0, 0.0, 0.0, 0.0],
    }
}

/// Displacements of the inner nodes and stresses at all points to 1e-10, the class's bound.
fn patch(element: ElementType, mesh: Mesh) {
    let space = element.space();
    let held = prescribed(&mesh, &sides(&mesh), components(element), |x| field(space, x));
    let points = mesh.points.clone();
    let solution = run("patch", element, mesh, &(material(1e6, 0.25) + &step(&held)));
    let largest = points.iter().flat_map(|&x| field(space, x)).fold(0.0, |m: f64, u| m.max(u.abs()));
    for (u, &x) in solution.u.iter().zip(&points) {
        let exact = field(space, x);
        assert!((0..3).all(|i| (u[i] - exact[i]).abs() < 1e-10 * largest), "{element:?}: {u:?} {exact:?}");
    }
    let exact = stress(space);
    let size = exact.iter().fold(0.0, |m: f64, s| m.max(s.abs()));
    for found in solution.terms.solids[0].stresses(&solution.report.last.u).stress {
        assert!((0..6).all(|i| (found[i] - exact[i]).abs() < 1e-10 * size), "{element:?}: {found:?} {exact:?}");
    }
}

/// Every element there is; tetrahedra on a cube whose inner nodes are moved by up to a third of an edge.
/// Waits: NLGEOM, CPE6, CPE8, C3D20 and the reduced elements.
#[test]
fn C01_patch() {
    for element in ElementType::SOLIDS {
        let mesh = match element {
            C3D8 => cube(),
            C3D4 | C3D10 => {
                let mut mesh = block(element, [3; 3]).mapped(|x| distorted(x, 3, 0.33));
                straighten(&mut mesh);
                mesh
            }
            _ => plate(element.kind(), if element.space() == Space::Axisymmetric { 0.1 } else { 0.0 }),
        };
        patch(element, mesh);
    }
}
