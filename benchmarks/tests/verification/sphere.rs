//! C07 and R04: the thick sphere 30/50, E = 70000, ν = 0.3, pressure 100 inside; as an octant, or its section around the
//! axis.

use crate::bodies::block;
use crate::deck::{Solution, material, run, step};
use crate::rates::{Errors, last_three, line};
use benchmarks::exact::thick::Vessel;
use benchmarks::fit;
use benchmarks::norm::{self, Quadrature, VolumeErrors};
use fe_core::element::ElementType::{self, *};
use fe_core::element::Space;
use fe_core::material::Elastic;
use fe_mesh::Mesh;
use std::collections::BTreeMap;
use std::f64::consts::{FRAC_PI_2, FRAC_PI_4};

const VESSEL: Vessel =
    Vessel { inner: 30.0, outer: 50.0, pressure: 100.0, elastic: Elastic { young: 70e3, poisson: 0.3 } };

/// Between the radii, at equal ratios.
fn radius(s: f64) -> f64 {
    VESSEL.inner * (VESSEL.outer / VESSEL.inner).powf(s)
}

/// Three blocks, each around one axis as far as the middle of the octant, with `n` cells through the wall and half as many
/// along half a quarter circle. The sets X0, Y0 and Z0 are the planes of symmetry, INSIDE the surface under pressure.
fn octant(element: ElementType, n: usize) -> Mesh {
    let mut octant = Mesh::default();
    for axis in 0..3 {
        let mut patch = block(element, [n / 2, n / 2, n]).mapped(|[s, t, q]| {
            // The direction e_axis + tan(sπ/4) e_next + tan(tπ/4) e_last.
            let mut direction = [1.0, (FRAC_PI_4 * s).tan(), (FRAC_PI_4 * t).tan()];
            direction.rotate_right(axis);
            let length = direction.iter().map(|d| d * d).sum::<f64>().sqrt();
            direction.map(|d| d * radius(q) / length)
        });
        let inside = patch.surfaces["ZMIN"].clone();
        (patch.surfaces, patch.node_sets) = ([("INSIDE".into(), inside)].into(), BTreeMap::new());
        octant.append(&patch);
    }
    weld(&mut octant);
    for (set, i) in [("X0", 0), ("Y0", 1), ("Z0", 2)] {
        let on = |node: &u32| octant.points[*node as usize][i].abs() < 1e-9;
        let nodes = (0..octant.points.len() as u32).filter(on).collect();
        octant.node_sets.insert(set.into(), nodes);
    }
    let inside = |p: &[f64; 3]| p.iter().map(|x| x * x).sum::<f64>().sqrt() < VESSEL.inner + 1e-9;
    let nodes = (0..octant.points.len() as u32).filter(|&node| inside(&octant.points[node as usize])).collect();
    octant.node_sets.insert("INNER".into(), nodes);
    octant
}

/// Points of the same place become one.
fn weld(mesh: &mut Mesh) {
    let mut kept: BTreeMap<[i64; 3], u32> = BTreeMap::new();
    let mut points = Vec::new();
    let mut merged = Vec::with_capacity(mesh.points.len());
    for point in &mesh.points {
        let place = point.map(|x| (x * 1e7).round() as i64);
        merged.push(*kept.entry(place).or_insert_with(|| {
            points.push(*point);
            points.len() as u32 - 1
        }));
    }
    mesh.blocks.iter_mut().flat_map(|block| &mut block.nodes).for_each(|node| *node = merged[*node as usize]);
    mesh.point_labels = (1..=points.len() as u64).collect();
    mesh.points = points;
}

/// A quarter of the section, `n` cells through the wall and 2 n along the quarter circle.
fn section(element: ElementType, n: usize) -> Mesh {
    let mut mesh = block(element, [n, 2 * n, 0]).mapped(|[s, t, _]| {
        // Exactly on the axis at its end.
        let (sin, cos) = if t == 1.0 { (1.0, 0.0) } else { (FRAC_PI_2 * t).sin_cos() };
        [radius(s) * cos, radius(s) * sin, 0.0]
    });
    mesh.surfaces = [("INSIDE".to_string(), mesh.surfaces["XMIN"].clone())].into();
    let [inner, equator, axis] = ["XMIN", "YMIN", "YMAX"].map(|set| mesh.node_sets[set].clone());
    mesh.node_sets = [("INNER", inner), ("Y0", equator), ("X0", axis)].map(|(n, s)| (n.to_string(), s)).into();
    mesh
}

/// Relative errors of u(r₁) and the hoop stress there, means over the nodes, and over the volume; and of the energy.
struct Found {
    displacement: f64,
    hoop: f64,
    energy: f64,
    volume: VolumeErrors,
}

fn solve(element: ElementType, n: usize) -> Found {
    let solid = element.space() == Space::Solid;
    let mesh = if solid { octant(element, n) } else { section(element, n) };
    let inner = mesh.node_sets["INNER"].clone();
    let supports = if solid { "X0, 1, 1\nY0, 2, 2\nZ0, 3, 3\n" } else { "X0, 1, 1\nY0, 2, 2\n" };
    let cards = format!("{}*BOUNDARY\n{supports}{}", material(70e3, 0.3), step("*DSLOAD\nINSIDE, P, 100.\n"));
    let solution = run("sphere", element, mesh, &cards);
    let exact = |x| if solid { VESSEL.sphere_at(x) } else { VESSEL.sphere_around(x) };
    let (structure, u) = (&solution.terms.structure, &solution.u);
    let outward = |&node: &u32| {
        let (x, u) = (structure.mesh.points[node as usize], u[node as usize]);
        (0..3).map(|i| u[i] * x[i]).sum::<f64>() / x.iter().map(|x| x * x).sum::<f64>().sqrt()
    };
    let mean = inner.iter().map(outward).sum::<f64>() / inner.len() as f64;
    let at_inside = VESSEL.sphere(VESSEL.inner);
    // An eighth of the full energy; half around the axis.
    let energy = solution.report.last.energy.solids * if solid { 8.0 } else { 2.0 };
    Found {
        displacement: mean / at_inside.displacement - 1.0,
        hoop: hoop(&solution, &inner) / at_inside.hoop - 1.0,
        energy: energy / 22763.72391 - 1.0,
        volume: norm::errors(structure, u, &exact, &Quadrature::default()).unwrap(),
    }
}

/// Mean hoop stress over the cells' nodes at the inside: half of the trace less the stress along the radius.
fn hoop(solution: &Solution, inner: &[u32]) -> f64 {
    let block = &solution.terms.solids[0];
    let stress = block.nodal(&block.stresses(&solution.report.last.u).stress);
    let (mut sum, mut count) = (0.0, 0);
    for (node, [xx, yy, zz, xy, yz, xz]) in block.nodes().iter().zip(stress) {
        if inner.binary_search(node).is_ok() {
            let [x, y, z] = solution.terms.structure.mesh.points[*node as usize];
            let along = xx * x * x + yy * y * y + zz * z * z + 2.0 * (xy * x * y + yz * y * z + xz * x * z);
            sum += 0.5 * (xx + yy + zz - along / (x * x + y * y + z * z));
            count += 1;
        }
    }
    sum / f64::from(count)
}

/// Energy at order p and the displacement at p + 1, less 0.1. Returns the errors of the hoop stress at the inside.
fn rates(element: ElementType, meshes: &[usize]) -> Errors {
    let order = if element == C3D10 { 2.0 } else { 1.0 };
    let all: Vec<(f64, Found)> = meshes.iter().map(|&n| (1.0 / n as f64, solve(element, n))).collect();
    let of = |part: &dyn Fn(&Found) -> f64| -> Errors { all.iter().map(|(h, f)| (*h, part(f).abs())).collect() };
    let (energy, displacement) = (of(&|f| f.volume.energy), of(&|f| f.volume.displacement));
    let hoop = of(&|f| f.hoop);
    let name = element.name();
    eprintln!("R04 {name:<6} energy {} | displacement {}", line(&energy), line(&displacement));
    eprintln!("C07 {name:<6} hoop {}", line(&hoop));
    eprintln!("C07 {name:<6} u(r1) {} | energy {}", line(&of(&|f| f.displacement)), line(&of(&|f| f.energy)));
    assert!(last_three(&energy) > order - 0.1, "{name}: energy {}", line(&energy));
    assert!(last_three(&displacement) > order + 0.9, "{name}: displacement {}", line(&displacement));
    hoop
}

/// The hoop stress falls at order 1 as well; its error is 0.45 h − O(h²) of the exact one on quadrilaterals, which comes
/// to that order late.
#[test]
fn R04_sphere_around_the_axis() {
    for element in [CAX4, CAX3] {
        let hoop = rates(element, &[4, 8, 16, 32, 64]);
        assert!(last_three(&hoop) > 0.9, "{element:?}: hoop {}", line(&hoop));
    }
}

/// The octant. The hoop stress comes to its order from below on meshes as fine as these, so the last two are asked for
/// it, less 0.2: bricks 0.82 where the section around the axis reaches 0.96 at last, quadratic tetrahedra 1.86.
fn octants(element: ElementType, meshes: &[usize]) {
    let hoop = rates(element, meshes);
    let order = if element == C3D10 { 2.0 } else { 1.0 };
    assert!(fit::slope(&hoop[hoop.len() - 2..]) > order - 0.2, "{element:?}: hoop {}", line(&hoop));
}

#[test]
#[ignore = "a minute, in release"]
fn R04_sphere() {
    octants(C3D8, &[4, 8, 16, 32]);
    octants(C3D10, &[2, 4, 8, 16]);
}

#[test]
#[ignore = "a minute, in release"]
fn R04_sphere_of_linear_tetrahedra() {
    octants(C3D4, &[4, 8, 16, 32]);
}
