use super::*;
use fe_core::Section;
use fe_core::element::{ElementType, Space};
use fe_core::material::{Elastic, Material};
use fe_mesh::Mesh;
use fe_mesh::generate::Block;

fn structure(element: ElementType, mut mesh: Mesh) -> Structure {
    let cells = mesh.cell_sets["BLOCK"].clone();
    mesh.points.push([9.0; 3]);
    let section = Section { element, cells, material: 0, thickness: 1.0, hourglass: None };
    let elastic = Elastic { young: 1000.0, poisson: 0.25 };
    let materials = vec![Material::elastic("M", elastic)];
    Structure { mesh, elements: vec![element], materials, sections: vec![section], ..Structure::default() }
}

/// Distorted, so that the Jacobian varies inside the cells.
fn mesh(element: ElementType) -> Mesh {
    let block = match element.kind() {
        CellKind::Tri3 => Block::tri3([3, 3]),
        CellKind::Quad4 => Block::quad4([3, 3]),
        CellKind::Tet4 => Block::tet4([2; 3]),
        CellKind::Tet10 => Block::tet10([2; 3]),
        _ => Block::hex8([2; 3]),
    };
    block.mapped(|[x, y, z]| [x + 0.2 * x * y, y + 0.1 * x * y, z + 0.1 * z * x])
}

/// A field of constant strain, with the stress of its element's space.
fn uniform(space: Space, [x, y, z]: [f64; 3]) -> Exact {
    // λ = μ = 400 at E = 1000, ν = 1/4.
    let (a, b) = (1e-3, 2e-3);
    let (strain, displacement) = match space {
        Space::Solid | Space::Any => ([a, b, 0.0, 0.0], [a * x, b * y, 0.0 * z]),
        Space::PlaneStress | Space::Plane => ([a, b, -(a + b) / 3.0, 0.0], [a * x, b * y, 0.0]),
        Space::PlaneStrain => ([a, b, 0.0, 0.0], [a * x, b * y, 0.0]),
        Space::Axisymmetric => ([a, b, a, 0.0], [a * x, b * y, 0.0]),
    };
    let trace = 400.0 * (strain[0] + strain[1] + strain[2]);
    let normal = [0, 1, 2].map(|i| trace + 800.0 * strain[i]);
    Exact { displacement, stress: [normal[0], normal[1], normal[2], 0.0, 0.0, 0.0] }
}

/// Linear fields are exact in every element, to round-off; enlarged by a part of themselves they are wrong by it, in
/// all norms, on distorted cells; and so whether cells are split or not.
#[test]
fn linear_fields_and_a_known_part() {
    for element in ElementType::SOLIDS {
        let structure = structure(element, mesh(element));
        let exact = |x: [f64; 3]| uniform(element.space(), x);
        let distance = |x: [f64; 3]| (x[0] - 1.0).hypot(x[1]);
        for quadrature in [Quadrature::default(), Quadrature { points: 2, singular: Some(&distance), splits: 3 }] {
            let mut u: Vec<_> = structure.mesh.points.iter().map(|&x| exact(x).displacement).collect();
            let none = errors(&structure, &u, &exact, &quadrature).unwrap();
            assert!(none.energy < 1e-13 && none.displacement < 1e-13, "{element:?} {none:?}");
            u.iter_mut().flatten().for_each(|u| *u *= 1.01);
            let part = errors(&structure, &u, &exact, &quadrature).unwrap();
            for error in [part.energy, part.displacement, part.deviator] {
                assert!((error - 0.01).abs() < 1e-12, "{element:?} {part:?}");
            }
        }
    }
}

/// Around an axis the weights hold the radius: on a ring 0 < r < 2 with u_h = r, exact r within r < 1 and r/2 beyond,
/// ∫₁² (r/2)² r dr = 15/16 over ∫₀¹ r³ dr + 15/16.
#[test]
fn weights_are_those_of_the_space() {
    let element = ElementType::CAX4;
    let structure = structure(element, Block::quad4([2, 1]).size([2.0, 1.0, 0.0]).mesh());
    let u: Vec<_> = structure.mesh.points.iter().map(|&[x, ..]| [x, 0.0, 0.0]).collect();
    let exact = |[x, ..]: [f64; 3]| Exact {
        displacement: [if x > 1.0 { 0.5 * x } else { x }, 0.0, 0.0],
        ..uniform(Space::Axisymmetric, [x, 0.0, 0.0])
    };
    let found = errors(&structure, &u, &exact, &Quadrature::default()).unwrap().displacement;
    assert!((found - (15.0f64 / 19.0).sqrt()).abs() < 1e-14, "{found}");
}

/// 1/r over the unit square, from its corner: 2 asinh 1. Eight points alone leave more than 1e-4 of it. With 24 splits
/// one cell of edge 2⁻²⁴ is left, a share of 6e-8 of the integral, wrong by less than a tenth of itself.
#[test]
fn splits_find_a_singular_integral() {
    let structure = structure(ElementType::CPE4, Block::quad4([1, 1]).mesh());
    let u = vec![[0.0, 1.0, 0.0]; structure.mesh.points.len()];
    let distance = |[x, y, _]: [f64; 3]| x.hypot(y);
    let exact = |x: [f64; 3]| Exact { displacement: [distance(x).powf(-0.5), 1.0, 0.0], ..Exact::default() };
    let integral = 2.0 * 1f64.asinh();
    let off = |quadrature: &Quadrature| {
        let part = errors(&structure, &u, &exact, quadrature).unwrap().displacement.powi(2);
        (part * (1.0 + integral) / integral - 1.0).abs()
    };
    let plain = off(&Quadrature::default());
    let split = off(&Quadrature { points: 8, singular: Some(&distance), splits: 24 });
    assert!(split < 6e-9 && plain > 1e-4, "{plain:e} {split:e}");
}

/// The areas of a side add up to it, halves at its ends; around an axis they are those of the rings.
#[test]
fn areas_add_up() {
    let plane = Block::quad4([4, 2]).mesh();
    let areas = nodal_areas(&plane, &plane.surfaces["YMIN"], false);
    let values: Vec<f64> = areas.values().copied().collect();
    values.iter().zip([0.125, 0.25, 0.25, 0.25, 0.125]).for_each(|(a, b)| assert!((a - b).abs() < 1e-15));
    let ring: f64 = nodal_areas(&plane, &plane.surfaces["YMIN"], true).values().sum();
    assert!((ring - std::f64::consts::PI).abs() < 1e-14);
    for block in [Block::hex8([2, 3, 1]), Block::tet4([2, 3, 1]), Block::tet10([2, 3, 1])] {
        let mesh = block.size([2.0, 3.0, 1.0]).mesh();
        let sum: f64 = nodal_areas(&mesh, &mesh.surfaces["ZMAX"], false).values().sum();
        assert!((sum - 6.0).abs() < 1e-13);
    }
    let node = |found, exact, area| NodalPressure { found, exact, area };
    assert_eq!(nodal_pressure([node(1.0, 2.0, 4.0), node(3.0, 0.0, 1.0)]), (13.0f64 / 16.0).sqrt());
}
