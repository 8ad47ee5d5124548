//! How fast a million nodes are read; for a quiet machine: `cargo test --release --test gmsh_speed -- --ignored`.
#![allow(clippy::unwrap_used)]

use fe_mesh::generate::Block;
use fe_mesh::gmsh::{Encoding, Kept, parse, write};
use std::time::Instant;

/// Seconds that this thread has computed, where Linux tells, so that other work on the machine counts less; else those
/// since `start`.
fn computed(start: Instant) -> f64 {
    let told = std::fs::read_to_string("/proc/thread-self/schedstat").ok();
    let nanoseconds: Option<f64> = told.and_then(|line| line.split_whitespace().next()?.parse().ok());
    nanoseconds.map_or_else(|| start.elapsed().as_secs_f64(), |ns| 1e-9 * ns)
}

/// Least seconds of five readings.
fn seconds(mut work: impl FnMut()) -> f64 {
    let start = Instant::now();
    let once = |_| {
        let before = computed(start);
        work();
        computed(start) - before
    };
    (0..5).map(once).fold(f64::INFINITY, f64::min)
}

/// 101³ nodes and 100³ bricks with coordinates of 16 digits: 300 MB/s of text and 1 GB/s of binary at least.
#[test]
#[ignore = "a measurement: run in release on a quiet machine"]
fn a_million_nodes() {
    let mesh = Block::hex8([100; 3]).mapped(|[x, y, z]| [x / 3.0 + 0.1 * y, y / 7.0 - 0.01 * z * z, z / 1.1 + x * y]);
    for (encoding, least) in [(Encoding::Text, 300.0), (Encoding::Binary, 1000.0)] {
        let file = write(&mesh, encoding);
        let megabytes = file.len() as f64 / 1e6;
        let reading = seconds(|| assert_eq!(parse(&file).unwrap().points.len(), 101 * 101 * 101));
        let whole =
            seconds(|| assert_eq!(parse(&file).unwrap().into_mesh(Kept::HighestDimension).0.cell_count(), 1_000_000));
        let rate = megabytes / reading;
        let told = format!("{encoding:?}: {megabytes:.1} MB in {reading:.3} s, {rate:.0} MB/s; as mesh {whole:.3} s");
        assert!(rate >= least, "{told}");
    }
}
