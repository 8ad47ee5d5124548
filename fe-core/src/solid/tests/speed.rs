//! How fast the element stiffness is, for the record.

use super::scene::Scene;
use crate::element::ElementType::*;
use crate::lanes::LANES;
use crate::solid::kernel::{Batches, Kernel};
use crate::solid::with_kernel;
use crate::term::{Assembly, Motion, Term};

/// Million elements a second of processor time on one thread: kernel alone on chunks in the cache, and with the scatter.
#[test]
#[ignore = "run in release"]
fn elements_per_second() {
    let pool = rayon::ThreadPoolBuilder::new().num_threads(1).build().unwrap();
    for (element, cells) in [(C3D8, 40), (C3D4, 30), (C3D10, 16), (CAX4, 250), (CPE4, 250)] {
        let scene = Scene::grid(element, [cells; 3], |x| [x[0] + 1.0, x[1], x[2]]);
        let block = scene.block();
        let count = block.cells().len();
        let u = vec![0.0; scene.freedoms.len()];
        let mut matrix = scene.zero_stiffness(&block);
        let at = Motion { u: &u, du: &u, step_time: 1.0, total_time: 1.0, dt: 1.0 };
        let (mut kernel_seconds, mut seconds) = (f64::MAX, f64::MAX);
        for _ in 0..7 {
            let mut residual = u.clone();
            let stiffness = Some(&mut matrix);
            let mut out = Assembly { residual: &mut residual, stiffness, energy: 0.0, status_changes: 0 };
            pool.install(|| {
                let start = processor_seconds();
                block.evaluate(at, &[], &mut [], &mut out).unwrap();
                let between = processor_seconds();
                with_kernel!(block, kernel => chunks(&block, &kernel, &u));
                seconds = seconds.min(between - start);
                kernel_seconds = kernel_seconds.min(processor_seconds() - between);
            });
        }
        let rate = |s: f64| count as f64 / s * 1e-6;
        let (kernel, all) = (rate(kernel_seconds), rate(seconds));
        std::io::Write::write_fmt(
            &mut std::io::stderr(),
            format_args!("{element:?}: kernel {kernel:.2}, with scatter {all:.2} million elements a second\n"),
        )
        .unwrap();
    }
}

/// Processor time of this thread [s], as Linux counts it: other work on the machine hardly matters.
fn processor_seconds() -> f64 {
    let text = std::fs::read_to_string("/proc/thread-self/schedstat").unwrap();
    text.split_whitespace().next().unwrap().parse::<f64>().unwrap() * 1e-9
}

fn chunks<K: Kernel>(block: &crate::solid::SolidBlock, kernel: &K, u: &[f64]) {
    let mut out = vec![0.0; 16 * LANES * K::STIFFNESS];
    for first in (0..block.cells().len()).step_by(16 * LANES) {
        let last = block.cells().len().min(first + 16 * LANES);
        let place = &mut out[..(last - first) * K::STIFFNESS];
        block.with_batches(first..last, u, |batches: Batches| kernel.stiffness(batches, place));
    }
    std::hint::black_box(&out);
}
