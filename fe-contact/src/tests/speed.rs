//! How long it takes to find the points of a pair, for the record.

use super::scene::{Scene, linear, surfaces};
use crate::facet::Vec3;
use crate::pair::Discretization::*;
use fe_core::element::ElementType::C3D8;

/// Microseconds of processor time a secondary facet, on one thread; the meshes do not match.
#[test]
#[ignore = "run in release"]
fn microseconds_a_facet() {
    let pool = rayon::ThreadPoolBuilder::new().num_threads(1).build().unwrap();
    let mut scene = Scene::default();
    let upper = scene.block(C3D8, [100, 1, 100], |r| Vec3::new(r.x, r.y + 1.0, r.z));
    let lower = scene.block(C3D8, [90, 1, 90], |r| r);
    let (secondary, main) = (scene.faces(upper, |r| r[1] == 0.0), scene.faces(lower, |r| r[1] == 1.0));
    for discretization in [SurfaceToSurface, NodeToSurface] {
        let definition = surfaces(secondary.clone(), main.clone(), discretization);
        let mut least = f64::MAX;
        for _ in 0..5 {
            let seconds = pool.install(|| {
                let start = processor_seconds();
                std::hint::black_box(scene.pair(&definition, &linear()));
                processor_seconds() - start
            });
            least = least.min(seconds);
        }
        let each = least / secondary.len() as f64 * 1e6;
        std::io::Write::write_fmt(&mut std::io::stderr(), format_args!("{discretization:?}: {each:.1} µs a facet\n"))
            .unwrap();
    }
}

/// Processor time of this thread [s], as Linux counts it.
fn processor_seconds() -> f64 {
    let text = std::fs::read_to_string("/proc/thread-self/schedstat").unwrap();
    text.split_whitespace().next().unwrap().parse::<f64>().unwrap() * 1e-9
}
