//! A31: an elastic layer of thickness 1 on a rigid flat, pressed by a force P = 1 on its top: it lifts off beyond
//! b = 0.856993923272, whatever E, ν and P, and p(0) = 0.960332960479 P (an integral equation of Keer, Dundurs and
//! Tsai's kind, J. Appl. Mech. 39 (1972) 1115, solved to twelve digits).

use crate::bodies::block;
use crate::deck::{Solution, exact_step, material, pair, profile, run};
use benchmarks::problems::grading::Grading;
use fe_core::element::ElementType::CPE4;

const HALF_WIDTH: f64 = 0.856993923272;
const PRESSURE: f64 = 0.960332960479;

/// Half of the layer, 6 long, `n` elements through it and squares as far as x = 1.5.
fn solve(n: usize, force: f64, kind: &str) -> Solution {
    let along = Grading::new(1.0 / n as f64, 1.5, 6.0, 1.25);
    let mesh = block(CPE4, [along.cells(), n, 1]).mapped(|[s, t, _]| [along.at(s), t, 0.0]);
    let top = mesh.points.iter().position(|p| p[0] == 0.0 && p[1] == 1.0).unwrap();
    let (label, reference) = (mesh.point_labels[top], mesh.points.len() + 1);
    let cards = format!(
        "{}{}{}*BOUNDARY\nXMIN, 1, 1\n{reference}, 1, 6\n{}",
        material(1000.0, 0.3),
        profile("FLAT", reference, "START, -1., 0.\nLINE, 7., 0.\n"),
        pair("YMIN", "FLAT", kind),
        exact_step(&format!("*CLOAD\n{label}, 2, {:e}\n", -0.5 * force)),
    );
    run("receding", CPE4, mesh, &cards)
}

/// Place and pressure over P of each node below, from the middle outward.
fn pressures(solution: &Solution, force: f64) -> Vec<(f64, f64)> {
    let state = &solution.terms.states(&solution.report.last)[0];
    let points = &solution.terms.structure.mesh.points;
    let mut all: Vec<(f64, f64)> =
        state.points.iter().map(|p| (points[p.node as usize][0], p.pressure / force)).collect();
    all.sort_by(|a, b| a.0.total_cmp(&b.0));
    all
}

/// Errors of p(0) and b, half an element beyond the last node that is pressed.
fn errors(n: usize, kind: &str) -> [f64; 2] {
    let found = pressures(&solve(n, 1.0, kind), 1.0);
    let last = found.iter().filter(|(_, p)| *p > 0.0).map(|(x, _)| *x).fold(0.0, f64::max);
    [found[0].1 / PRESSURE - 1.0, last + 0.5 / n as f64 - HALF_WIDTH]
}

/// Linear elements: p(0) falls as h², 1.2 h² of contact at nodes and 0.4 h² of means over the surface on four meshes
/// (20 % are added); the last node that is pressed is within an element of b. Waits: quadratic elements, p(0) to 0.5 %
/// at h = 1/16.
#[test]
fn A31_receding_layer() {
    for kind in ["NODE TO SURFACE", "SURFACE TO SURFACE"] {
        let found = [8, 16, 32, 64].map(|n| (n, errors(n, kind)));
        let line: Vec<String> = found.iter().map(|(n, [p, b])| format!("{n}: {p:+.2e} {b:+.2e}")).collect();
        eprintln!("A31 {kind:<19}p(0) relative, b: {}", line.join(", "));
        for (n, [p, b]) in found {
            let h = 1.0 / n as f64;
            assert!(p.abs() < 1.5 * h * h && b.abs() < h, "{kind} {}", line.join(", "));
        }
    }
}

/// In one increment from all closed: whatever the force is, the layer lifts off at the same place, with the same
/// pressures over the force, as far as the residual tells: 1e-8 of the force on a node that stands for 1/16, and three
/// times that in the pressures, as hats overlap; and as far as gaps are known, 4ε of the model's size of 13, which a default
/// penalty 10 M/h, M = 1346, turns into pressures.
#[test]
fn A31_receding_layer_under_any_force() {
    let usual = pressures(&solve(16, 1.0, "SURFACE TO SURFACE"), 1.0);
    let open = |found: &[(f64, f64)]| found.iter().filter(|(_, p)| *p == 0.0).count();
    for force in [1e-6, 1e-3, 1e3] {
        let solution = solve(16, force, "SURFACE TO SURFACE");
        let found = pressures(&solution, force);
        assert!(open(&found) > 0 && open(&found) == open(&usual), "{force}");
        for ((_, p), (x, q)) in found.iter().zip(&usual) {
            let rounding = 4.0 * f64::EPSILON * 13.0 * 10.0 * 1346.0 * 16.0 / force;
            assert!((p - q).abs() < 4.8e-7 + rounding, "{force} at {x}: {p} {q}");
        }
    }
}
