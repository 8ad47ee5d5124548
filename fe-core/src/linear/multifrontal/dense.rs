//! The dense part of a front: partial LLᵀ by panels on sequential kernels, panels and tiles cut in a fixed way, so
//! that every number is reached by the same operations in the same order on any number of threads.

use super::trapezoid::{Panel, Trapezoid};
use faer::linalg::matmul::triangular::{self, BlockStructure};
use faer::linalg::{matmul, triangular_solve};
use faer::{Accum, MatMut, MatRef, Par};
use rayon::prelude::*;

/// Columns below which the kernels written out here are quicker than general ones.
const NARROW: usize = 32;
/// Rows of a tile, the piece of work that a thread takes.
const TILE: usize = 384;
/// Fronts of fewer rows are not worth sharing out.
const SHARED_FROM: usize = 512;

/// Eliminates the columns of `front`: `factor` receives L [rows × columns], and `update` [lower triangle of what is
/// left] is diminished by L₂L₂ᵀ. `least[j]` is the pivot at or below which column j counts as held by nothing.
///
/// # Errors
/// The first column whose pivot vanished.
pub(super) fn eliminate(front: Trapezoid, factor: &mut [f64], update: &mut [f64], least: &[f64]) -> Result<(), usize> {
    let left = front.rows - front.columns;
    if front.rows <= NARROW {
        cholesky_narrow(front.rows, front.columns, factor, least)?;
        subtract_narrow(&factor[..], front, update);
        return Ok(());
    }
    let mut panels = front.split(factor);
    for k in 0..panels.len() {
        let (done, later) = panels.split_at_mut(k + 1);
        let (panel, values) = &mut done[k];
        factor_panel(*panel, values, &least[panel.first..]).map_err(|j| panel.first + j)?;
        let (panel, values) = (*panel, &values[..]);
        let mut tiles = Vec::new();
        for (target, numbers) in later {
            tiles.extend(cut(*target, target.first, numbers));
        }
        share(front.rows, tiles, |tile| tile.subtract(&[(panel, values)], 0));
    }
    let sources: Vec<(Panel, &[f64])> = panels.into_iter().map(|(panel, values)| (panel, &*values)).collect();
    let rest = Trapezoid { rows: left, columns: left };
    let tiles = rest.split(update).into_iter().flat_map(|(panel, numbers)| cut(panel, panel.first, numbers)).collect();
    share(front.rows, tiles, |tile| tile.subtract(&sources, front.columns));
    Ok(())
}

/// Does the pieces of work in parallel where the front is large. They touch different numbers.
pub(super) fn share<T: Send>(rows: usize, pieces: Vec<T>, work: impl Fn(T) + Send + Sync) {
    if rows < SHARED_FROM || pieces.len() < 2 {
        pieces.into_iter().for_each(work);
    } else {
        pieces.into_par_iter().with_max_len(1).for_each(work);
    }
}

/// Part of a panel: the rows from `row` on of the columns from `column` on, in the numbering of its trapezoid.
struct Tile<'a> {
    row: usize,
    column: usize,
    values: MatMut<'a, f64>,
}

/// Cuts a panel into tiles from the top, the first one on the diagonal.
fn cut(panel: Panel, first_row: usize, numbers: &mut [f64]) -> Vec<Tile<'_>> {
    let mut rest = MatMut::from_column_major_slice_mut(numbers, panel.height, panel.width);
    let (mut tiles, mut row) = (Vec::new(), first_row);
    while rest.nrows() > 0 {
        let height = if row == first_row { panel.width } else { TILE.min(rest.nrows()) };
        let (values, below) = rest.split_at_row_mut(height);
        tiles.push(Tile { row, column: panel.first, values });
        (rest, row) = (below, row + height);
    }
    tiles
}

impl Tile<'_> {
    /// Subtracts the product of the sources' rows that belong to the tile's rows and columns, which are counted
    /// from row `origin` of the sources' trapezoid.
    fn subtract(mut self, sources: &[(Panel, &[f64])], origin: usize) {
        let (rows, columns) = (self.values.nrows(), self.values.ncols());
        for (panel, values) in sources {
            let source = MatRef::from_column_major_slice(values, panel.height, panel.width);
            let left = source.subrows(origin + self.row - panel.first, rows);
            let right = source.subrows(origin + self.column - panel.first, columns).transpose();
            if self.row == self.column {
                triangular::matmul(
                    self.values.as_mut(),
                    BlockStructure::TriangularLower,
                    Accum::Add,
                    left,
                    BlockStructure::Rectangular,
                    right,
                    BlockStructure::Rectangular,
                    -1.0,
                    Par::Seq,
                );
            } else {
                matmul::matmul(self.values.as_mut(), Accum::Add, left, right, -1.0, Par::Seq);
            }
        }
    }
}

/// Cholesky factor of a panel's diagonal block, then of the rows below.
fn factor_panel(panel: Panel, values: &mut [f64], least: &[f64]) -> Result<(), usize> {
    let matrix = MatMut::from_column_major_slice_mut(values, panel.height, panel.width);
    let (mut diagonal, below) = matrix.split_at_row_mut(panel.width);
    cholesky(diagonal.as_mut(), least)?;
    let (mut pieces, mut rest) = (Vec::new(), below);
    while rest.nrows() > 0 {
        let height = TILE.min(rest.nrows());
        let (piece, below) = rest.split_at_row_mut(height);
        pieces.push(piece);
        rest = below;
    }
    let diagonal = diagonal.as_ref();
    share(panel.height, pieces, |piece: MatMut<'_, f64>| {
        triangular_solve::solve_lower_triangular_in_place(diagonal, piece.transpose_mut(), Par::Seq);
    });
    Ok(())
}

/// Cholesky factor in place of the lower triangle, `NARROW` columns at a time.
fn cholesky(mut matrix: MatMut<'_, f64>, least: &[f64]) -> Result<(), usize> {
    let n = matrix.nrows();
    let mut scratch = [0.0; NARROW * NARROW];
    for first in (0..n).step_by(NARROW) {
        let width = NARROW.min(n - first);
        let (_, _, _, corner) = matrix.as_mut().split_at_mut(first, first);
        let (mut diagonal, _, mut below, rest) = corner.split_at_mut(width, width);
        let copy = &mut scratch[..width * width];
        for j in 0..width {
            (j..width).for_each(|i| copy[j * width + i] = diagonal[(i, j)]);
        }
        cholesky_narrow(width, width, copy, &least[first..]).map_err(|j| first + j)?;
        for j in 0..width {
            (j..width).for_each(|i| diagonal[(i, j)] = copy[j * width + i]);
        }
        triangular_solve::solve_lower_triangular_in_place(diagonal.as_ref(), below.as_mut().transpose_mut(), Par::Seq);
        triangular::matmul(
            rest,
            BlockStructure::TriangularLower,
            Accum::Add,
            below.as_ref(),
            BlockStructure::Rectangular,
            below.as_ref().transpose(),
            BlockStructure::Rectangular,
            -1.0,
            Par::Seq,
        );
    }
    Ok(())
}

/// The first `columns` columns of a Cholesky factor, in place, column-major `[rows × columns]`.
fn cholesky_narrow(rows: usize, columns: usize, values: &mut [f64], least: &[f64]) -> Result<(), usize> {
    pulp::Arch::new().dispatch(|| {
        for j in 0..columns {
            let (done, rest) = values.split_at_mut((j + 1) * rows);
            let column = &mut done[j * rows + j..];
            let held = column[0] > least[j]; // false when it is not a number
            if !held {
                return Err(j);
            }
            let root = column[0].sqrt();
            column[0] = root;
            column[1..].iter_mut().for_each(|v| *v /= root);
            for (k, target) in rest.chunks_exact_mut(rows).take(columns - j - 1).enumerate() {
                subtract_multiple(&mut target[j + 1 + k..], &column[1 + k..], column[1 + k]);
            }
        }
        Ok(())
    })
}

/// Diminishes the update of a narrow front by L₂L₂ᵀ.
fn subtract_narrow(factor: &[f64], front: Trapezoid, update: &mut [f64]) {
    let left = front.rows - front.columns;
    pulp::Arch::new().dispatch(|| {
        for column in factor.chunks_exact(front.rows).take(front.columns) {
            let column = &column[front.columns..];
            for (k, target) in update.chunks_exact_mut(left.max(1)).take(left).enumerate() {
                subtract_multiple(&mut target[k..], &column[k..], column[k]);
            }
        }
    });
}

#[inline(always)]
fn subtract_multiple(target: &mut [f64], source: &[f64], factor: f64) {
    target.iter_mut().zip(source).for_each(|(t, s)| *t -= s * factor);
}
