//! A20a, A20b, A21a, A22: Hertz's contacts of whole bodies, good to what the half space is a model of.

use crate::bodies::block;
use crate::deck::{Solution, exact_step, material, material_of, pair, profile, run, run_sets};
use benchmarks::problem::{Answer, MeshFile};
use benchmarks::problems::contact_area::{Contact, Node, Pressure, Sums, nodes, peak, sums};
use benchmarks::problems::grading::Grading;
use benchmarks::problems::{Problem, hertz_ball};
use fe_core::element::ElementType::{C3D8, CAX4, CPE4};
use fe_mesh::Mesh;
use std::f64::consts::PI;

const MEANS: &str = "SURFACE TO SURFACE";

/// Nodes of a secondary surface and the pressure by point of the mesh.
fn pressures(solution: &Solution, surface: &str, contact: Contact) -> (Vec<Node>, Vec<f64>) {
    let mesh = &solution.terms.structure.mesh;
    let mut pressures = vec![0.0; mesh.points.len()];
    let state = &solution.terms.states(&solution.report.last)[0];
    state.points.iter().for_each(|point| pressures[point.node as usize] = point.pressure);
    (nodes(mesh, &mesh.surfaces[surface], contact), pressures)
}

/// Hertz's half width and largest pressure under a force per length.
#[derive(Clone, Copy)]
struct Line {
    half_width: f64,
    peak: f64,
}

impl Line {
    fn under(force: f64, radius: f64, modulus: f64) -> Self {
        let half_width = (4.0 * force * radius / (PI * modulus)).sqrt();
        Line { half_width, peak: 2.0 * force / (PI * half_width) }
    }

    fn at(&self, x: f64) -> f64 {
        self.peak * (1.0 - (x / self.half_width).powi(2)).max(0.0).sqrt()
    }

    /// Errors of the peak, the half width (of the second moment, a²/4 of the force), and the pressure in L2.
    fn errors(&self, (nodes, pressures): &(Vec<Node>, Vec<f64>)) -> ([f64; 3], Sums) {
        let found = sums(nodes, pressures, Pressure::Field, |x| self.at(x));
        let width = 2.0 * (found.moment / found.force).sqrt();
        let top = peak(nodes, pressures, 0.5 * self.half_width);
        ([top / self.peak - 1.0, width / self.half_width - 1.0, found.error], found)
    }
}

/// The lower half of a round body of radius `radius` as far as `side`, half of it: columns from the circle up to its
/// middle, edges `h` as far as `fine` along it, growing from there and upward.
fn round(h: f64, fine: f64, [side, radius]: [f64; 2]) -> Mesh {
    let (along, up) = (Grading::new(h, fine, side, 1.25), Grading::new(h, fine, radius, 1.25));
    block(CPE4, [along.cells(), up.cells(), 1]).mapped(|[s, t, _]| {
        let (x, above) = (along.at(s), up.at(t));
        let bottom = radius - (radius * radius - x * x).sqrt();
        [x, bottom + above * (1.0 - bottom / radius), 0.0]
    })
}

/// FENET's roller (R = 50, steel) on a block of aluminium 200 × 200 clamped below, 35 kN/mm: pressure and peak within
/// 3 %, what the half space is good to at p₀/E = 5 %, and what the mesh adds, 2 · 0.45 h/a as in the exact window; the
/// block's top goes down by 1.2807 within 1 % (the same block under Hertz's own pressure, small displacements).
#[test]
fn A20a_roller_on_block() {
    let (force, modulus) = (35e3, 1.0 / (0.91 / 210e3 + 0.91 / 70e3));
    let hertz = Line::under(force, 50.0, modulus);
    assert!((hertz.half_width / 6.2146278669 - 1.0).abs() < 1e-10 && (hertz.peak / 3585.3622309 - 1.0).abs() < 1e-10);
    for n in [8.0, 16.0] {
        let (h, fine) = (hertz.half_width / n, 1.5 * hertz.half_width);
        let mut mesh = round(h, fine, [45.0, 50.0]).prefixed("ROLLER_");
        let [along, down] = [100.0, 200.0].map(|length| Grading::new(h, fine, length, 1.25));
        let block = block(CPE4, [along.cells(), down.cells(), 1]);
        mesh.append(&block.mapped(|[s, t, _]| [along.at(s), -down.at(1.0 - t), 0.0]).prefixed("BLOCK_"));
        let top = mesh.points.iter().rposition(|p| p[0] == 0.0 && p[1] == 0.0).unwrap();
        let cards = format!(
            "{}{}{}*BOUNDARY\nROLLER_XMIN, 1\nBLOCK_XMIN, 1\nBLOCK_YMIN, 1, 2\n{}",
            material_of("ROLLER_BLOCK", 210e3, 0.3),
            material_of("BLOCK_BLOCK", 70e3, 0.3),
            pair("ROLLER_YMIN", "BLOCK_YMAX", MEANS),
            exact_step(&format!("*DSLOAD\nROLLER_YMAX, P, {:e}\n", 0.5 * force / 45.0)),
        );
        let solution = run_sets("roller", vec![("ROLLER_BLOCK", CPE4), ("BLOCK_BLOCK", CPE4)], mesh, &cards);
        let ([top_pressure, width, error], _) = hertz.errors(&pressures(&solution, "ROLLER_YMIN", Contact::Line));
        let carried = solution.terms.states(&solution.report.last)[0].secondary.force[1] / (0.5 * force) - 1.0;
        let depth = solution.u[top][1] / -1.2807 - 1.0;
        eprintln!(
            "A20a n={n}: p0 {top_pressure:+.4}, a {width:+.4}, pressure {error:.4}, top {depth:+.4}, force {carried:.1e}"
        );
        assert!(carried.abs() < 1e-10 && top_pressure.abs() < 0.03 && depth.abs() < 0.01);
        assert!(error < 0.03 + 0.9 / n);
    }
}

/// A cylinder (R = 50, steel) between rigid flats that come as near as a contact of half width 1 makes them (Johnson,
/// 1985, §5.6): force and pressure within 0.1 %, (a/R)² = 4e-4 and the corners cut off at 0.98 R being most of it, and
/// what the mesh adds, twice that of the exact window.
#[test]
fn A20b_cylinder_between_flats() {
    let modulus = 210e3 / 0.91;
    let approach = |line: Line, force: f64| 2.0 * force / (PI * modulus) * ((200.0 / line.half_width).ln() - 0.5);
    let hertz = Line::under(3624.9146003, 50.0, modulus);
    let way = approach(hertz, 3624.9146003);
    assert!((way / 0.0479831736655 - 1.0).abs() < 1e-9 && (hertz.peak / 2307.6923077 - 1.0).abs() < 1e-9);
    for n in [4.0, 8.0, 16.0] {
        let mesh = round(1.0 / n, 2.0, [49.0, 50.0]);
        let reference = mesh.points.len() + 1;
        let cards = format!(
            "{}{}{}*BOUNDARY\nXMIN, 1\nYMAX, 2\n{reference}, 1, 1\n{reference}, 6, 6\n{}",
            material(210e3, 0.3),
            profile("FLAT", reference, "START, -50., 0.\nLINE, 50., 0.\n"),
            pair("YMIN", "FLAT", MEANS),
            exact_step(&format!("*BOUNDARY\n{reference}, 2, 2, {way:e}\n")),
        );
        let solution = run("cylinder_between", CPE4, mesh, &cards);
        let force = 2.0 * solution.terms.states(&solution.report.last)[0].secondary.force[1];
        let ([top, width, error], _) =
            Line::under(force, 50.0, modulus).errors(&pressures(&solution, "YMIN", Contact::Line));
        let near = approach(Line::under(force, 50.0, modulus), force) / way - 1.0;
        eprintln!(
            "A20b n={n}: approach {near:+.2e}, p0 {top:+.2e}, a {width:+.2e}, pressure {error:.4}, force {:+.2e}",
            force / 3624.9146003 - 1.0
        );
        assert!(near.abs() < 1e-3 + 0.2 / (n * n) && error < 1e-3 + 0.9 / n);
        assert!(top.abs() < 1e-3 + 0.2 / (n * n) && width.abs() < 0.5 / n);
    }
}

/// The ball on a flat of the benchmark, its radius within half an element, pressures within twice the bounds around an
/// axis; the model is good to 0.1 %, its peak to 0.2 % (a half ball is no half space).
#[test]
fn A21a_ball_on_a_flat() {
    let problem = hertz_ball::HertzBall;
    let curves = problem.curves();
    for curve in curves.iter().filter(|curve| curve.element == CAX4) {
        let folder = std::path::Path::new(env!("CARGO_TARGET_TMPDIR")).join("verification").join("ball");
        let scene = problem.scene(curve, 8);
        let deck = scene.write(&folder, MeshFile::Gmsh).unwrap();
        fe::run(&deck, &fe::standard(), &mut fe::observer::Silent).unwrap();
        let found = problem.errors(&scene, &Answer::read(&deck.with_extension("dat")).unwrap()).unwrap();
        eprintln!("A21a {:<40} peak {:+.2e}, a {:+.2e}, pressure {:.4}", curve.name(), found[0], found[1], found[2]);
        assert!(found[0].abs() < 2e-3 + 1.4 / 64.0 && found[1].abs() < 0.5 / 8.0 && found[2] < 1e-3 + 1.4 / 8.0);
    }
}

/// Two equal cylinders across each other, R = 10: as a ball of that radius on a flat, within 0.2 %. A quarter of both,
/// ten times the contact radius wide and deep, facets an eighth of it.
#[test]
#[ignore = "a minute, in release"]
fn A22_crossed_cylinders() {
    let (force, radius, n) = (2000.0, 0.50657970191, 8.0);
    let (h, fine, size) = (radius / n, 1.5 * radius, 10.0 * radius);
    let grading = Grading::new(h, fine, size, 1.35);
    let cells = grading.cells();
    let round = |x: f64| 10.0 - (100.0 - x * x).sqrt();
    let part = |upper: bool| {
        let mut mesh = block(C3D8, [cells; 3]).mapped(|[s, t, r]| {
            let (x, y, away) = (grading.at(s), grading.at(t), grading.at(if upper { r } else { 1.0 - r }));
            let bottom = round(if upper { x } else { y });
            let height = bottom + away * (1.0 - bottom / size);
            [x, y, if upper { height } else { -height }]
        });
        let mut touch = mesh.surfaces[if upper { "ZMIN" } else { "ZMAX" }].clone();
        let near = |n: u32| mesh.points[n as usize][..2].iter().all(|x| *x < 1.01 * fine);
        touch.retain(|&face| mesh.face(face).1.into_iter().all(near));
        mesh.surfaces.insert("TOUCH".into(), touch);
        mesh.prefixed(if upper { "UP_" } else { "LOW_" })
    };
    let mut mesh = part(false);
    mesh.append(&part(true));
    let held = "LOW_ZMIN, 3\nLOW_XMIN, 1\nLOW_YMIN, 2\nUP_XMIN, 1\nUP_YMIN, 2\n";
    let cards = format!(
        "{}{}{}*BOUNDARY\n{held}{}",
        material_of("LOW_BLOCK", 210e3, 0.3),
        material_of("UP_BLOCK", 210e3, 0.3),
        pair("UP_TOUCH", "LOW_TOUCH", MEANS),
        exact_step(&format!("*DSLOAD\nUP_ZMAX, P, {:e}\n", 0.25 * force / (size * size))),
    );
    let solution = run_sets("crossed", vec![("LOW_BLOCK", C3D8), ("UP_BLOCK", C3D8)], mesh, &cards);
    let carried = solution.terms.states(&solution.report.last)[0].secondary.force[2] / (0.25 * force) - 1.0;
    let (nodes, pressures) = pressures(&solution, "UP_TOUCH", Contact::Round);
    let largest = 1.5 * force / (PI * radius * radius);
    assert!((largest / 3721.13832134 - 1.0).abs() < 1e-9);
    let exact = |r: f64| largest * (1.0 - (r / radius).powi(2)).max(0.0).sqrt();
    let found = sums(&nodes, &pressures, Pressure::Field, exact);
    // The second moment of Hertz's pressure is 2a²/5 of the force.
    let width = (2.5 * found.moment / found.force).sqrt() / radius - 1.0;
    let top = peak(&nodes, &pressures, 0.5 * radius) / largest - 1.0;
    eprintln!("A22 p0 {top:+.4}, a {width:+.4}, pressure {:.4}, force {carried:.1e}", found.error);
    assert!(carried.abs() < 1e-10 && top.abs() < 0.03 && width.abs() < 0.5 / n);
}
