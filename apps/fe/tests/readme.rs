//! What the README shows is what the repository holds.
#![allow(clippy::unwrap_used)]

mod common;

use common::Scratch;
use common::results::Results;
use std::path::{Path, PathBuf};

fn repository() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../..")
}

/// The deck in the README is the first example's, and short enough for a screen.
#[test]
fn the_deck_is_that_of_the_first_example() {
    let readme = std::fs::read_to_string(repository().join("README.md")).unwrap();
    let deck = std::fs::read_to_string(repository().join("apps/fe/examples/hertz_sphere/hertz_sphere.inp")).unwrap();
    assert!(readme.contains(&format!("```text\n{deck}```")), "the README shows another deck");
    assert!(deck.lines().count() <= 25);
}

/// The first example against Hertz (Johnson, Contact Mechanics, 1985, §4.2): force to 1e-6 of the load; peak pressure
/// and radius within 3 %, the mesh's own accuracy at eight edges along the radius (measured: 0.2 and 0.5 %).
#[test]
#[ignore = "65,000 unknowns: run in release"]
fn hertz_sphere() {
    let scratch = Scratch::new("hertz_sphere");
    for name in ["hertz_sphere.inp", "hertz_sphere.msh"] {
        std::fs::copy(repository().join("apps/fe/examples/hertz_sphere").join(name), scratch.path(name)).unwrap();
    }
    let run = scratch.fe(&["run", "hertz_sphere.inp", "--quiet"]);
    assert_eq!(run.status, 0, "{}", run.error);
    let results = Results::open(&scratch.path("hertz_sphere.vtkhdf"));
    let last = results.times().len() - 1;
    let points = results.real("VTKHDF/Points");
    let pressure = results.point_field("CPRESS", 1, last);
    // Load on the quarter: what the reactions of the lower face carry.
    let load: f64 = results.point_field("RF", 3, last).chunks_exact(3).map(|r| r[2]).sum();
    let forces = results.point_field("CNORMF", 3, last);
    let ball = pressure.iter().zip(forces.chunks_exact(3)).filter(|(p, _)| !p.is_nan());
    let force: f64 = ball.map(|(_, f)| f[2]).sum();
    assert!((force / load - 1.0).abs() < 1e-6, "{force} {load}");
    let (radius, modulus) = (10.0, 210e3 / (2.0 * (1.0 - 0.3f64.powi(2))));
    let a = (3.0 * 4.0 * load * radius / (4.0 * modulus)).cbrt();
    let peak = 2.0 * a * modulus / (std::f64::consts::PI * radius);
    let pressed: Vec<(f64, f64)> = pressure
        .iter()
        .zip(points.chunks_exact(3))
        .filter(|(p, _)| **p > 0.0)
        .map(|(p, x)| (x[0] * x[0] + x[1] * x[1], p * p))
        .collect();
    let highest = pressed.iter().fold(0.0f64, |m, v| m.max(v.1)).sqrt();
    assert!((highest / peak - 1.0).abs() < 0.03, "{highest} {peak}");
    // p² = p₀² (1 − r²/a²): the zero of the line through the outer third.
    let outer: Vec<_> = pressed.iter().filter(|v| v.0 > (2.0 / 3.0 * a).powi(2)).collect();
    let n = outer.len() as f64;
    let mean = |f: fn(&(f64, f64)) -> f64| outer.iter().map(|v| f(v)).sum::<f64>() / n;
    let (x, y) = (mean(|v| v.0), mean(|v| v.1));
    let slope = (mean(|v| v.0 * v.1) - x * y) / (mean(|v| v.0 * v.0) - x * x);
    let found = (x - y / slope).sqrt();
    assert!((found / a - 1.0).abs() < 0.03, "{found} {a}");
}
