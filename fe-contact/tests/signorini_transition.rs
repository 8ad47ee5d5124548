//! A30: an exact solution of Signorini's problem with the end of contact inside the surface. An elastic body y > 0 on
//! a rigid plane, plane strain, exact displacements on the other three sides.
//!
//! With z = x − x₀ + iy, Ẑ = −⅔ K z^{3/2} and Z = −K z^{1/2} (Westergaard): 2μ u_x = (1−2ν) Re Ẑ − y Im Z,
//! 2μ u_y = 2(1−ν) Im Ẑ − y Re Z, σ_xx = Re Z − y Im Z′, σ_yy = Re Z + y Im Z′, σ_xy = −y Re Z′. On y = 0 the pressure
//! is K √(x − x₀) to the right of x₀ and the gap (1−ν)/μ ⅔ K (x₀ − x)^{3/2} to the left.
#![allow(clippy::unwrap_used, non_snake_case)]

mod common;

use fe_contact::Contact;
use fe_contact::interaction::{Enforcement, Interaction, NormalBehavior, Penalty};
use fe_contact::pair::{Discretization, PairDefinition};
use fe_contact::rigid::{Piece, RigidSurface, Sweep};
use fe_contact::surface::{Main, Secondary};
use fe_core::element::ElementType;
use fe_core::external::ExternalForces;
use fe_core::material::{Elastic, Material};
use fe_core::ramp::Ramp;
use fe_core::solid::SolidBlock;
use fe_core::{Section, Structure};
use fe_mesh::generate::Block;
use fe_mesh::quadrature::Rule;
use fe_mesh::{CellKind, shape};
use nalgebra::Complex;

const ELASTIC: Elastic = Elastic { young: 1000.0, poisson: 0.3 };
const INTENSITY: f64 = 100.0;
const X0: f64 = 0.1 * std::f64::consts::SQRT_2;

/// Displacement, and stress xx, yy, zz, xy.
fn exact(x: f64, y: f64) -> ([f64; 2], [f64; 4]) {
    let z = Complex::new(x - X0, y);
    let root = z.sqrt();
    let (hat, first, second) =
        (root.powi(3) * (-2.0 / 3.0 * INTENSITY), root * -INTENSITY, root.inv() * (-0.5 * INTENSITY));
    let (nu, mu) = (ELASTIC.poisson, ELASTIC.mu());
    let u = [(1.0 - 2.0 * nu) * hat.re - y * first.im, 2.0 * (1.0 - nu) * hat.im - y * first.re];
    let (xx, yy) = (first.re - y * second.im, first.re + y * second.im);
    (u.map(|u| u / (2.0 * mu)), [xx, yy, nu * (xx + yy), -y * second.re])
}

/// Relative errors of one mesh, and iterations.
struct Errors {
    energy: f64,
    displacement: f64,
    pressure: f64,
    iterations: usize,
}

/// Squares (or halves of them) of edge h = 1/n.
fn solve(element: ElementType, n: usize, discretization: Discretization, direct: bool) -> Errors {
    let of = if element.kind() == CellKind::Quad4 { Block::quad4([2 * n, n]) } else { Block::tri3([2 * n, n]) };
    let mut mesh = of.size([2.0, 1.0, 1.0]).origin([-1.0, 0.0, 0.0]).mesh();
    let reference = mesh.points.len() as u32;
    mesh.points.push([0.0, -1.0, 0.0]);
    mesh.point_labels.push(u64::from(reference) + 1);
    let section =
        Section { element, cells: mesh.cell_sets["BLOCK"].clone(), material: 0, thickness: 1.0, hourglass: None };
    let materials = vec![Material::elastic("M", ELASTIC)];
    let structure =
        Structure { mesh, elements: vec![element], materials, sections: vec![section], ..Structure::default() };
    let freedoms = structure.freedoms(&[reference]);
    let solids = [SolidBlock::new(&structure, &structure.sections[0], &freedoms).unwrap()];
    let pieces = vec![Piece::Line { to: [2.0, 0.0] }];
    let plane = RigidSurface { name: "PLANE".into(), sweep: Sweep::Segments, start: [-2.0, 0.0], pieces };
    let definition = PairDefinition {
        secondary_name: "FLOOR".into(),
        main_name: "PLANE".into(),
        secondary: Secondary::Faces(structure.mesh.surfaces["YMIN"].clone()),
        main: Main::Rigid { surface: plane, reference },
        interaction: 0,
        discretization,
        small_sliding: true,
        bond: Default::default(),
        adjust: None,
        clearance: None,
    };
    // With K ∝ 1/h² the penalty's own error stays below that of the elements.
    let modulus = ELASTIC.lambda() + 2.0 * ELASTIC.mu();
    let stiffness = Some(80.0 * modulus * (n * n) as f64);
    let penalty = Enforcement::Penalty(Penalty { stiffness, clearance: 0.0, scale: 1.0 });
    let enforcement = if direct { Enforcement::Direct } else { penalty };
    let interaction = Interaction {
        name: "I".into(),
        normal: NormalBehavior::Hard(enforcement),
        no_separation: false,
        friction: None,
        damping: None,
        explicit_damping: None,
        scale_factor: None,
        stabilized_along: false,
        measure: None,
    };
    let pair = Contact::of_pair(&structure, &freedoms, &definition, &interaction).unwrap();
    let mut prescribed: Vec<_> = freedoms.of_node(reference as usize).map(|f| (f, Ramp::constant(0.0))).collect();
    for set in ["XMIN", "XMAX", "YMAX"] {
        for &node in &structure.mesh.node_sets[set] {
            let [x, y, _] = structure.mesh.points[node as usize];
            let u = exact(x, y).0;
            let to =
                |c: usize| (freedoms.index(node as usize, c).unwrap(), Ramp { from: 0.0, to: u[c], amplitude: None });
            prescribed.extend([to(0), to(1)]);
        }
    }
    let (end, convergence) = common::solve(&freedoms, &solids, &pair, ExternalForces::default(), prescribed);
    let [energy, displacement] =
        volume_errors(&structure, &solids[0], |node, c| freedoms.index(node as usize, c).map_or(0.0, |f| end.u[f]));
    let mut sums = [0.0; 2];
    for point in pair.state(&end.u, &end.history[end.history.len() - 1]).points {
        let x = structure.mesh.points[point.node as usize][0];
        if x.abs() < 0.9 {
            let pressure = INTENSITY * (x - X0).max(0.0).sqrt();
            sums[0] += (point.pressure - pressure).powi(2);
            sums[1] += pressure * pressure;
        }
    }
    let iterations = convergence.status_iterations + convergence.equilibrium_iterations;
    Errors { energy, displacement, pressure: (sums[0] / sums[1]).sqrt(), iterations }
}

/// Relative errors in the energy norm, ∫ ((1+ν) σ:σ − ν tr²σ) of the difference, and in L2 of the displacement.
fn volume_errors(structure: &Structure, solid: &SolidBlock, u: impl Fn(u32, usize) -> f64) -> [f64; 2] {
    let kind = structure.elements[0].kind();
    let stress = solid.nodal(&solid.stresses(&all(structure, &u)).stress);
    let energy = |[xx, yy, zz, xy]: [f64; 4]| {
        let nu = ELASTIC.poisson;
        (1.0 + nu) * (xx * xx + yy * yy + zz * zz + 2.0 * xy * xy) - nu * (xx + yy + zz).powi(2)
    };
    let mut sums = [[0.0; 2]; 2];
    for (cell, nodes) in solid.nodes().chunks_exact(kind.nodes()).enumerate() {
        // All cells have the same area; 8 points a direction resolve √r at the transition.
        for (xi, weight) in &Rule::of(kind, 15).points {
            let mut values = [0.0; 4];
            shape::values(kind, xi, &mut values);
            let mean = |of: &dyn Fn(usize) -> f64| (0..nodes.len()).map(|a| values[a] * of(a)).sum::<f64>();
            let place = |i: usize| mean(&|a| structure.mesh.points[nodes[a] as usize][i]);
            let (displacement, exact_stress) = exact(place(0), place(1));
            let found = [0, 1, 2, 3].map(|c| mean(&|a| stress[cell * nodes.len() + a][c]));
            let difference = std::array::from_fn(|c| found[c] - exact_stress[c]);
            sums[0][0] += weight * energy(difference);
            sums[0][1] += weight * energy(exact_stress);
            for (c, exact) in displacement.iter().enumerate() {
                sums[1][0] += weight * (mean(&|a| u(nodes[a], c)) - exact).powi(2);
                sums[1][1] += weight * exact.powi(2);
            }
        }
    }
    sums.map(|[error, size]| (error / size).sqrt())
}

/// The displacement as a vector over the freedoms of the solid's nodes, which come first.
fn all(structure: &Structure, u: &impl Fn(u32, usize) -> f64) -> Vec<f64> {
    (0..structure.mesh.points.len() as u32).flat_map(|n| [u(n, 0), u(n, 1)]).chain([0.0]).collect()
}

/// Slope of ln(error) over ln(h) by least squares.
fn slope(errors: &[(f64, f64)]) -> f64 {
    let points: Vec<(f64, f64)> = errors.iter().map(|(h, e)| (h.ln(), e.ln())).collect();
    let count = points.len() as f64;
    let (mx, my) = points.iter().fold((0.0, 0.0), |m, p| (m.0 + p.0 / count, m.1 + p.1 / count));
    points.iter().map(|p| (p.0 - mx) * (p.1 - my)).sum::<f64>() / points.iter().map(|p| (p.0 - mx).powi(2)).sum::<f64>()
}

/// Theory: u is in H^{5/2−ε}, so the energy error falls as h and that of the displacement as h². The bounds are those
/// of a study with nodal contact on squares of h = 1/8 … 1/128: energy 0.45 h, nodal pressure 0.5 h, at most 15
/// iterations; twice that on triangles, and twice in the pressure where it is a mean over the surface. The end of
/// contact moves through its element, so that errors scatter from mesh to mesh: the slope is fitted to seven.
fn transition(element: ElementType, discretization: Discretization, direct: bool) {
    let triangles = if element == ElementType::CPE3 { 2.0 } else { 1.0 };
    let means = if discretization == Discretization::SurfaceToSurface { 2.0 } else { 1.0 };
    let (mut energy, mut displacement) = (Vec::new(), Vec::new());
    for n in [8, 11, 16, 23, 32, 45, 64] {
        let h = 1.0 / n as f64;
        let e = solve(element, n, discretization, direct);
        assert!(e.energy <= 0.45 * h * triangles, "1/{n}: energy {:.5}", e.energy);
        assert!(e.pressure <= 0.5 * h * triangles * means, "1/{n}: pressure {:.5}", e.pressure);
        assert!(e.iterations <= 15, "1/{n}: {} iterations", e.iterations);
        energy.push((h, e.energy));
        displacement.push((h, e.displacement));
    }
    let slopes = (slope(&energy), slope(&displacement));
    assert!((slopes.0 - 1.0).abs() < 0.05 && (slopes.1 - 2.0).abs() < 0.1, "{slopes:?}");
}

#[test]
fn A30_signorini_transition() {
    transition(ElementType::CPE4, Discretization::SurfaceToSurface, false);
}

/// By multipliers the bounds are the same: what is left is the elements' own error.
#[test]
fn A30_signorini_transition_direct() {
    transition(ElementType::CPE4, Discretization::SurfaceToSurface, true);
    transition(ElementType::CPE4, Discretization::NodeToSurface, true);
}

#[test]
fn A30_signorini_transition_nodal() {
    transition(ElementType::CPE4, Discretization::NodeToSurface, false);
}

#[test]
fn A30_signorini_transition_on_triangles() {
    transition(ElementType::CPE3, Discretization::SurfaceToSurface, false);
    transition(ElementType::CPE3, Discretization::NodeToSurface, false);
}
