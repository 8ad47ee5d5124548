//! Which facets may meet: a grid of boxes.

use crate::facet::{Facet, Vec3};

/// A box with edges along the axes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Bounds {
    /// Least coordinates.
    pub low: Vec3,
    /// Greatest coordinates.
    pub high: Vec3,
}

impl Bounds {
    /// The smallest box around points, grown by `margin` on every side.
    pub fn around(points: &[Vec3], margin: f64) -> Self {
        let Bounds { low, high } = Bounds::around_all(points.iter().copied());
        Bounds { low: low.add_scalar(-margin), high: high.add_scalar(margin) }
    }

    /// The smallest box around points.
    pub fn around_all(points: impl Iterator<Item = Vec3>) -> Self {
        let none = Bounds { low: Vec3::repeat(f64::INFINITY), high: Vec3::repeat(f64::NEG_INFINITY) };
        points.fold(none, |all, p| Bounds { low: all.low.inf(&p), high: all.high.sup(&p) })
    }

    /// The smallest box around both.
    pub fn union(&self, other: &Bounds) -> Self {
        Bounds { low: self.low.inf(&other.low), high: self.high.sup(&other.high) }
    }

    /// True when they share a point.
    pub fn meets(&self, other: &Bounds) -> bool {
        (0..3).all(|i| self.low[i] <= other.high[i] && other.low[i] <= self.high[i])
    }

    /// Length of the diagonal [L].
    pub fn diagonal(&self) -> f64 {
        if self.low.x > self.high.x { 0.0 } else { (self.high - self.low).norm() }
    }

    fn moved(&self, by: &Vec3) -> Self {
        Bounds { low: self.low + by, high: self.high + by }
    }
}

/// Boxes of facets sorted into the cells of a uniform grid, about one facet a cell.
#[derive(Debug)]
pub struct Grid {
    boxes: Vec<Bounds>,
    all: Bounds,
    edge: f64,
    cells: [usize; 3],
    start: Vec<u32>,
    items: Vec<u32>,
}

impl Grid {
    /// Of the boxes of facets, each grown by `margin` of its facet's size.
    pub fn of_facets(facets: &[Facet], margin: f64) -> Self {
        Grid::new(facets.iter().map(|f| Bounds::around(f.points(), margin * f.size())).collect())
    }

    /// Of boxes.
    pub fn new(boxes: Vec<Bounds>) -> Self {
        let none = Bounds { low: Vec3::zeros(), high: Vec3::zeros() };
        let all = boxes.iter().copied().reduce(|a, b| a.union(&b)).unwrap_or(none);
        let extent = all.high - all.low;
        let mean = boxes.iter().map(|b| (b.high - b.low).max()).sum::<f64>() / boxes.len().max(1) as f64;
        // No more than four cells a box, however the boxes are spread.
        let mut edge = mean.max(extent.max() * 1e-6).max(f64::MIN_POSITIVE);
        let count = |edge: f64| [0, 1, 2].map(|i| (extent[i] / edge) as usize + 1);
        while count(edge).iter().product::<usize>() > 4 * boxes.len() + 64 {
            edge *= 1.3;
        }
        let cells = count(edge);
        let mut grid = Grid { boxes, all, edge, cells, start: Vec::new(), items: Vec::new() };
        grid.fill();
        grid
    }

    fn fill(&mut self) {
        let mut start = vec![0u32; self.cells.iter().product::<usize>() + 1];
        for b in &self.boxes {
            self.cells_of(b, |c| start[c + 1] += 1);
        }
        for c in 1..start.len() {
            start[c] += start[c - 1];
        }
        let mut next = start.clone();
        let mut items = vec![0; start[start.len() - 1] as usize];
        for (i, b) in self.boxes.iter().enumerate() {
            self.cells_of(b, |c| {
                items[next[c] as usize] = i as u32;
                next[c] += 1;
            });
        }
        (self.start, self.items) = (start, items);
    }

    /// Column, row and layer of the cell that is nearest to a point.
    fn place(&self, p: &Vec3) -> [usize; 3] {
        [0, 1, 2].map(|i| (((p[i] - self.all.low[i]) / self.edge).max(0.0) as usize).min(self.cells[i] - 1))
    }

    fn cell(&self, [x, y, z]: [usize; 3]) -> usize {
        (z * self.cells[1] + y) * self.cells[0] + x
    }

    fn cells_of(&self, b: &Bounds, mut visit: impl FnMut(usize)) {
        let (low, high) = (self.place(&b.low), self.place(&b.high));
        for z in low[2]..=high[2] {
            for y in low[1]..=high[1] {
                for x in low[0]..=high[0] {
                    visit(self.cell([x, y, z]));
                }
            }
        }
    }

    /// Number of boxes.
    pub fn len(&self) -> usize {
        self.boxes.len()
    }

    /// True when there is no box.
    pub fn is_empty(&self) -> bool {
        self.boxes.is_empty()
    }

    /// The box around all of them.
    pub fn bounds(&self) -> Bounds {
        self.all
    }

    /// Adds to `found` whose boxes meet a box; some maybe twice.
    fn collect(&self, query: &Bounds, found: &mut Vec<u32>) {
        if !self.boxes.is_empty() && query.meets(&self.all) {
            self.cells_of(query, |c| {
                let items = &self.items[self.start[c] as usize..self.start[c + 1] as usize];
                found.extend(items.iter().filter(|&&i| self.boxes[i as usize].meets(query)));
            });
        }
    }

    /// Whose boxes hold a point, ascending: those of one cell.
    pub fn holding(&self, point: Vec3) -> impl Iterator<Item = u32> + '_ {
        let own = Bounds { low: point, high: point };
        let range = match self.boxes.is_empty() || !own.meets(&self.all) {
            true => 0..0,
            false => {
                let cell = self.cell(self.place(&point));
                self.start[cell] as usize..self.start[cell + 1] as usize
            }
        };
        self.items[range].iter().copied().filter(move |&i| self.boxes[i as usize].meets(&own))
    }

    /// Whose boxes meet a box, ascending.
    pub fn meeting(&self, query: &Bounds) -> Vec<u32> {
        let mut found = Vec::new();
        self.collect(query, &mut found);
        found.sort_unstable();
        found.dedup();
        found
    }

    /// Whose boxes meet a box moved along a unit direction from `from` to `to` [L], ascending.
    pub fn swept(&self, query: &Bounds, direction: &Vec3, from: f64, to: f64) -> Vec<u32> {
        let (mut s, end) = (from.max(self.reach(query, direction, true)), to.min(self.reach(query, direction, false)));
        let stride = (2.0 * self.edge).max(query.diagonal());
        let mut found = Vec::new();
        while s <= end {
            let next = s + stride;
            let at = |s: f64| query.moved(&(direction * s));
            self.collect(&at(s).union(&at(next.min(end))), &mut found);
            s = next;
        }
        found.sort_unstable();
        found.dedup();
        found
    }

    /// Where a moved box first (or last) meets the box around all.
    fn reach(&self, query: &Bounds, direction: &Vec3, first: bool) -> f64 {
        let mut limit = if first { f64::NEG_INFINITY } else { f64::INFINITY };
        for i in 0..3 {
            let d = direction[i];
            if d.abs() > 1e-9 {
                let ends = [(self.all.low[i] - query.high[i]) / d, (self.all.high[i] - query.low[i]) / d];
                let (a, b) = (ends[0].min(ends[1]), ends[0].max(ends[1]));
                limit = if first { limit.max(a) } else { limit.min(b) };
            }
        }
        limit
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A fixed sequence of numbers in 0..1 (multiplicative congruence).
    fn numbers() -> impl FnMut() -> f64 {
        let mut seed = 12345u64;
        move || {
            seed = seed.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
            (seed >> 11) as f64 / (1u64 << 53) as f64
        }
    }

    fn cube(centre: Vec3, half: f64) -> Bounds {
        Bounds { low: centre.add_scalar(-half), high: centre.add_scalar(half) }
    }

    #[test]
    fn the_grid_finds_what_comparing_all_finds() {
        let mut next = numbers();
        let boxes: Vec<_> =
            (0..500).map(|_| cube(Vec3::new(next() * 4.0, next(), next() * 0.01), 0.02 + 0.2 * next())).collect();
        let grid = Grid::new(boxes.clone());
        for _ in 0..200 {
            let query = cube(Vec3::new(next() * 4.0, next(), next() - 0.5), 0.3 * next());
            let expected: Vec<u32> = (0..500).filter(|&i| boxes[i as usize].meets(&query)).collect();
            assert_eq!(grid.meeting(&query), expected);
            let holding: Vec<u32> = grid.holding(query.low).collect();
            let expected: Vec<u32> =
                (0..500).filter(|&i| boxes[i as usize].meets(&Bounds { low: query.low, high: query.low })).collect();
            assert_eq!(holding, expected);
        }
    }

    /// Every box that the moving box passes is found: sampled at steps below the least box.
    #[test]
    fn a_swept_box_finds_what_it_passes() {
        let mut next = numbers();
        let boxes: Vec<_> = (0..300).map(|_| cube(Vec3::new(next(), next(), next()), 0.01 + 0.02 * next())).collect();
        let grid = Grid::new(boxes.clone());
        for _ in 0..40 {
            let query = cube(Vec3::new(next(), next(), next()), 0.01);
            let direction = Vec3::new(next() - 0.5, next() - 0.5, next() - 0.5).normalize();
            let found = grid.swept(&query, &direction, -2.0, 2.0);
            for s in (-2000..=2000).map(|k| f64::from(k) * 1e-3) {
                for (i, b) in boxes.iter().enumerate().filter(|(_, b)| b.meets(&query.moved(&(direction * s)))) {
                    assert!(found.contains(&(i as u32)), "{b:?}");
                }
            }
            assert!(found.len() < 150);
        }
    }
}
