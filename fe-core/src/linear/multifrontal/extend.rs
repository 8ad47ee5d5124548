//! Adds what children left to the front of their parent.

use super::symbolic::{Run, Supernode};
use super::trapezoid::{Panel, Trapezoid};

/// Below this mean length of the runs numbers are added one by one.
const SHORT: usize = 8;

/// What a child left, and where it goes.
pub(super) struct Child<'a> {
    runs: &'a [Run],
    shape: Trapezoid,
    values: &'a [f64],
    /// Row in the parent's front of each unknown left; empty where the runs are long.
    rows: Vec<u32>,
}

impl<'a> Child<'a> {
    /// Of the supernode and the lower triangle that it left.
    pub fn new(left: &'a Supernode, values: &'a [f64]) -> Self {
        let (runs, shape) = (left.runs.as_slice(), left.update());
        let short = shape.rows < SHORT * runs.len();
        let rows = if short { runs.iter().flat_map(|run| run.to..run.to + run.length).collect() } else { Vec::new() };
        Child { runs, shape, values, rows }
    }

    /// Adds what falls into a panel of the parent's front.
    pub fn extend_add(&self, panel: Panel, numbers: &mut [f64]) {
        let (first, end) = (panel.first, panel.first + panel.width);
        let from = self.runs.partition_point(|run| (run.to + run.length) as usize <= first);
        for (k, run) in self.runs.iter().enumerate().skip(from) {
            let (to, from) = (run.to as usize, run.from as usize);
            if to >= end {
                break;
            }
            for column in to.max(first)..(to + run.length as usize).min(end) {
                let source = column - to + from;
                let part = self.shape.panel_of(source);
                let range = part.below(source, source);
                let values = &self.values[part.start + range.start..part.start + range.end];
                let target = &mut numbers[panel.below(column, column)];
                if self.rows.is_empty() {
                    add_runs(&self.runs[k..], source, values, target);
                } else {
                    let first = self.rows[source];
                    values.iter().zip(&self.rows[source..]).for_each(|(v, row)| target[(row - first) as usize] += v);
                }
            }
        }
    }
}

/// Adds the rows of a column from its diagonal on; `source` is its place among the unknowns left.
fn add_runs(runs: &[Run], source: usize, values: &[f64], target: &mut [f64]) {
    let column = runs[0].to as usize + source - runs[0].from as usize;
    for run in runs {
        let skip = source.saturating_sub(run.from as usize);
        let (at, length) = (run.from as usize + skip - source, run.length as usize - skip);
        let to = run.to as usize + skip - column;
        target[to..to + length].iter_mut().zip(&values[at..at + length]).for_each(|(t, s)| *t += s);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Long runs and short ones, over panels of the child and of the parent: each number once where the definition
    /// says.
    #[test]
    fn every_number_goes_where_its_row_and_column_go() {
        for pieces in [vec![(3u32, 200u32), (260, 100), (400, 30)], (0..90).map(|k| (2 + 5 * k, 1 + k % 4)).collect()] {
            let mut from = 0;
            let runs: Vec<Run> = pieces
                .iter()
                .map(|&(to, length)| {
                    from += length;
                    Run { from: from - length, to, length }
                })
                .collect();
            let left = Supernode { rows: from as usize, runs: runs.clone(), ..Supernode::default() };
            let shape = left.update();
            let place = |t: Trapezoid, row: usize, column: usize| {
                let panel = t.panel_of(column);
                panel.start + panel.below(row, column).start
            };
            let mut values = vec![0.0; shape.len()];
            for column in 0..shape.rows {
                (column..shape.rows).for_each(|row| values[place(shape, row, column)] = (row * 1000 + column) as f64);
            }
            let front = Trapezoid { rows: 470, columns: 470 };
            let mut numbers = vec![0.5; front.len()];
            let child = Child::new(&left, &values);
            assert_eq!(child.rows.is_empty(), pieces.len() == 3);
            front.split(&mut numbers).into_iter().for_each(|(panel, part)| child.extend_add(panel, part));
            let rows: Vec<usize> = runs.iter().flat_map(|r| (r.to..r.to + r.length).map(|row| row as usize)).collect();
            let mut expected = vec![0.5; front.len()];
            for (c, &column) in rows.iter().enumerate() {
                for (r, &row) in rows.iter().enumerate().skip(c) {
                    expected[place(front, row, column)] += (r * 1000 + c) as f64;
                }
            }
            assert!(numbers == expected);
        }
    }
}
