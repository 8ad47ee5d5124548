//! How fast elements are.

use super::*;

/// Updates a second of blocks with every element in motion; for release builds: `--ignored --nocapture`.
#[test]
#[ignore = "measures speed"]
#[allow(clippy::print_stdout)]
fn updates_per_second() {
    for (element, n) in [(C3D8R, 40), (C3D4, 40), (CPE4R, 250), (CAX4R, 250), (C3D8, 40), (C3D10, 15)] {
        let mut scene = Setup::elastic(element).block(n, |x| x);
        let elements = scene.solids.count();
        let freedoms = scene.freedoms.len();
        let u = vec![0.0; freedoms];
        let v: Vec<f64> = (0..freedoms).map(|f| ((f * 7919) % 1000) as f64 * 1e-3).collect();
        let mut forces = vec![0.0; freedoms];
        let at = Moving { u: &u, v: &v, step_time: 0.0, total_time: 0.0, dt: 1e-9, stable: f64::INFINITY };
        let start = std::time::Instant::now();
        let increments = 100;
        for _ in 0..increments {
            forces.fill(0.0);
            scene.solids.advance(&at, &mut forces).unwrap();
        }
        let rate = (elements * increments) as f64 / start.elapsed().as_secs_f64();
        let (name, threads) = (element.name(), rayon::current_num_threads());
        println!("{name}: {:.2} million updates a second on {threads} threads", 1e-6 * rate);
    }
}
