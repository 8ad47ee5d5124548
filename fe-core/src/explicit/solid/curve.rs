//! Cells along a space-filling curve: neighbours in space stand together in memory.

use fe_mesh::{CellId, Mesh};

/// Steps of the curve along each axis, as a power of two.
const BITS: u32 = 20;

/// The cells by the Morton number of their centres.
pub(super) fn sorted(mesh: &Mesh, cells: &[CellId]) -> Vec<CellId> {
    let center = |&cell: &CellId| {
        let nodes = mesh.cell(cell);
        let sum = |c: usize| nodes.iter().map(|&n| mesh.points[n as usize][c]).sum::<f64>();
        [0, 1, 2].map(|c| sum(c) / nodes.len() as f64)
    };
    let centers: Vec<[f64; 3]> = cells.iter().map(center).collect();
    let bound = |c: usize, pick: fn(f64, f64) -> f64| centers.iter().map(|x| x[c]).reduce(pick).unwrap_or(0.0);
    let (low, high) = ([0, 1, 2].map(|c| bound(c, f64::min)), [0, 1, 2].map(|c| bound(c, f64::max)));
    let size = (0..3).map(|c| high[c] - low[c]).fold(f64::MIN_POSITIVE, f64::max);
    let number = |x: &[f64; 3]| {
        let step = |c: usize| ((x[c] - low[c]) / size * f64::from((1u32 << BITS) - 1)) as u64;
        (0..BITS).fold(0u64, |all, bit| (0..3).fold(all, |all, c| all | (step(c) >> bit & 1) << (3 * bit + c as u32)))
    };
    let mut order: Vec<(u64, CellId)> = centers.iter().map(number).zip(cells.iter().copied()).collect();
    order.sort_unstable();
    order.into_iter().map(|(_, cell)| cell).collect()
}
