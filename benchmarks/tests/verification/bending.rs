//! C02, C04: elements in bending.

use crate::bodies::{block, components};
use crate::deck::{Solution, forces, material, prescribed, run, step};
use benchmarks::norm::nodal_areas;
use fe_core::element::ElementType::{self, *};
use fe_core::element::Space;
use fe_mesh::Mesh;
use std::collections::BTreeMap;

const LENGTH: f64 = 6.0;
const DEPTH: f64 = 0.2;
const WIDTH: f64 = 0.1;
const YOUNG: f64 = 1e7;
const POISSON: f64 = 0.3;

/// Shapes of MacNeal and Harder's six elements: their sides lean by 45°, all alike or in turn.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Shape {
    Rectangles,
    Parallelograms,
    Trapezoids,
}

/// The beam along x, its depth along y.
fn straight(element: ElementType, shape: Shape) -> Mesh {
    let lean = |station: f64| match shape {
        Shape::Rectangles => 0.0,
        _ if !(0.5..=5.5).contains(&station) => 0.0,
        Shape::Parallelograms => 1.0,
        // Between stations, where middle nodes are, the lean changes over.
        Shape::Trapezoids => (std::f64::consts::PI * (station - 0.5)).sin(),
    };
    let mut mesh = block(element, [6, 1, 1])
        .mapped(|[s, t, r]| [LENGTH * s + lean(6.0 * s) * DEPTH * (t - 0.5), DEPTH * (t - 0.5), WIDTH * (r - 0.5)]);
    crate::bodies::straighten(&mut mesh);
    mesh
}

/// Shares of the end's nodes in a uniform traction.
fn shares(mesh: &Mesh) -> BTreeMap<u32, f64> {
    let mut areas = nodal_areas(mesh, &mesh.surfaces["XMAX"], false);
    let total: f64 = areas.values().sum();
    areas.values_mut().for_each(|area| *area /= total);
    areas
}

/// Clamped at x = 0, these forces at the end; the work they do, for a unit load the displacement at the load.
fn work(element: ElementType, mesh: Mesh, cards: &str, load: &BTreeMap<u32, [f64; 3]>) -> f64 {
    let held = prescribed(&mesh, &mesh.node_sets["XMIN"], components(element), |_| [0.0; 3]);
    let loads = forces(&mesh, load.iter().map(|(&node, &force)| (node, force)));
    let Solution { u, .. } = run("beam", element, mesh, &format!("{cards}{}", step(&(held + &loads))));
    load.iter().map(|(&node, force)| (0..3).map(|i| force[i] * u[node as usize][i]).sum::<f64>()).sum()
}

/// A unit load along a component, and for solids a unit torque by forces around x.
fn load(mesh: &Mesh, component: Option<usize>) -> BTreeMap<u32, [f64; 3]> {
    let shares = shares(mesh);
    let Some(component) = component else {
        let arm = |node: &u32| mesh.points[*node as usize];
        let polar: f64 = shares.iter().map(|(n, w)| w * (arm(n)[1].powi(2) + arm(n)[2].powi(2))).sum();
        return shares.iter().map(|(&n, w)| (n, [0.0, -w * arm(&n)[2] / polar, w * arm(&n)[1] / polar])).collect();
    };
    let mut unit = [0.0; 3];
    unit[component] = 1.0;
    shares.iter().map(|(&n, &w)| (n, unit.map(|u| w * u))).collect()
}

/// Answers of beam theory: extension, in the plane, out of the plane (with shear), twist of Saint-Venant.
const THEORY: [(&str, Option<usize>, f64); 4] = [
    ("extension", Some(0), 3e-5),
    ("in plane", Some(1), 0.1080936),
    ("out of plane", Some(2), 0.4320936),
    ("twist", None, 0.03407896),
];

/// Parts of the theory's answers.
fn parts(element: ElementType, shape: Shape) -> Vec<f64> {
    let solid = element.space() == Space::Solid;
    let section = if solid { String::new() } else { format!("{WIDTH:?}\n") };
    let cards = material(YOUNG, POISSON) + &section;
    let cases = &THEORY[..if solid { 4 } else { 2 }];
    let part = |(_, component, exact): &(&str, Option<usize>, f64)| {
        let mesh = straight(element, shape);
        let load = load(&mesh, *component);
        work(element, mesh, &cards, &load) / exact
    };
    cases.iter().map(part).collect()
}

/// Asked: 0.97 of the beam of linear elements that do not lock, on rectangles; 0.85 of quadratic ones on other shapes,
/// and tetrahedra, six a brick, are such. No answer may exceed 1.01, as beam theory lets the end contract freely; in
/// plane strain all is stiffer by 1 − ν². With sides that lean, four and eight nodes lose most of the bending: printed,
/// not asked for. Nor are the locking elements, nor twist, for which one brick is few. Waits: the quadratic bricks and
/// quadrilaterals.
#[test]
fn C02_straight_beam() {
    for shape in [Shape::Rectangles, Shape::Parallelograms, Shape::Trapezoids] {
        for element in [CPS3, CPS4, CPE3, CPE4, C3D4, C3D8, C3D10] {
            let parts = parts(element, shape);
            let table: Vec<String> = parts.iter().zip(THEORY).map(|(p, (name, ..))| format!("{name} {p:.4}")).collect();
            eprintln!("C02 {:<6}{shape:?}: {}", element.name(), table.join(", "));
            let stiffer = if element.space() == Space::PlaneStrain { 1.0 - POISSON * POISSON } else { 1.0 };
            let asked = match (element, shape) {
                (C3D8 | CPS4 | CPE4, Shape::Rectangles) => 0.97,
                (C3D10, _) => 0.85,
                _ => 0.0,
            };
            for (part, (name, ..)) in parts.iter().zip(&THEORY[..3]) {
                let part = part / stiffer;
                assert!(part >= asked && part < 1.01, "{element:?} {shape:?} {name}: {part}");
            }
        }
    }
}

/// v at (48, 52) of Cook's panel.
fn cook(element: ElementType, n: usize) -> f64 {
    let mesh = block(element, [n, n, 1]).mapped(|[s, t, _]| [48.0 * s, 44.0 * s + t * (44.0 - 28.0 * s), 0.0]);
    let middle = mesh.points.iter().position(|p| (p[0] - 48.0).abs() + (p[1] - 52.0).abs() < 1e-9).unwrap();
    let held = prescribed(&mesh, &mesh.node_sets["XMIN"], &[0, 1], |_| [0.0; 3]);
    let loads = forces(&mesh, load(&mesh, Some(1)));
    let cards = material(1.0, 1.0 / 3.0) + &step(&(held + &loads));
    run("cook", element, mesh, &cards).u[middle][1]
}

/// 23.968 ± 0.002, of a study with three elements of high order: quadrilaterals 32 × 32 within 0.5 %; triangles lock in
/// bending and come from below. Waits: quadratic elements, 16 × 16 within 0.2 %.
#[test]
fn C04_cook() {
    let quadrilaterals = [4, 8, 16, 32].map(|n| cook(CPS4, n));
    let triangles = [8, 16, 32].map(|n| cook(CPS3, n));
    eprintln!("C04 CPS4 {quadrilaterals:.4?}, CPS3 {triangles:.4?}");
    assert!((quadrilaterals[3] / 23.968 - 1.0).abs() < 5e-3, "{quadrilaterals:?}");
    assert!(triangles.is_sorted() && triangles[2] < 23.97, "{triangles:?}");
}
