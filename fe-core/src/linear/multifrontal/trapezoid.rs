//! Lower trapezoids stored in panels of columns: half the memory of a square, and each panel a slice of its own.

/// Columns of a panel: wide enough for the dense kernels, narrow enough that the zeros above cost little.
pub(super) const PANEL: usize = 128;

/// The first `columns` columns of a lower triangle of `rows` rows. Panel by panel; each panel is column-major and
/// reaches from the row of its first column down.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Trapezoid {
    pub rows: usize,
    pub columns: usize,
}

/// One panel of a trapezoid.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Panel {
    /// Its first column, and first row.
    pub first: usize,
    /// Number of columns.
    pub width: usize,
    /// Number of rows.
    pub height: usize,
    /// Where its numbers start.
    pub start: usize,
}

impl Panel {
    /// Numbers stored, `height × width`.
    pub fn len(self) -> usize {
        self.width * self.height
    }

    /// The part of column `column` from row `row` on, given the panel's numbers.
    #[inline]
    pub fn below(self, row: usize, column: usize) -> std::ops::Range<usize> {
        let start = (column - self.first) * self.height;
        start + row - self.first..start + self.height
    }
}

impl Trapezoid {
    /// Numbers stored.
    pub fn len(self) -> usize {
        self.panels().next_back().map_or(0, |p| p.start + p.len())
    }

    /// The panel of a column.
    #[inline]
    pub fn panel_of(self, column: usize) -> Panel {
        let before = column / PANEL;
        let first = before * PANEL;
        Panel {
            first,
            width: PANEL.min(self.columns - first),
            height: self.rows - first,
            start: first * self.rows - PANEL * PANEL * (before * before.saturating_sub(1) / 2),
        }
    }

    /// All panels from the left.
    pub fn panels(self) -> impl DoubleEndedIterator<Item = Panel> {
        (0..self.columns.div_ceil(PANEL)).map(move |k| self.panel_of(k * PANEL))
    }

    /// All panels with their numbers.
    pub fn split(self, mut values: &mut [f64]) -> Vec<(Panel, &mut [f64])> {
        let mut parts = Vec::with_capacity(self.columns.div_ceil(PANEL));
        for panel in self.panels() {
            let (part, rest) = std::mem::take(&mut values).split_at_mut(panel.len());
            parts.push((panel, part));
            values = rest;
        }
        parts
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn panels_stand_one_behind_the_other() {
        for (rows, columns) in [(0, 0), (5, 0), (5, 5), (128, 128), (300, 129), (700, 700), (1000, 384)] {
            let t = Trapezoid { rows, columns };
            let mut end = 0;
            for p in t.panels() {
                assert_eq!((p.start, p.height, t.panel_of(p.first + p.width - 1)), (end, rows - p.first, p));
                end += p.len();
            }
            assert_eq!(t.len(), end);
            assert_eq!(t.split(&mut vec![0.0; end]).iter().map(|p| p.1.len()).sum::<usize>(), end);
        }
    }
}
