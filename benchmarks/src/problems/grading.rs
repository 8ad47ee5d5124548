//! Places along an axis, fine where a contact is and coarser away from it.

/// Ascending places [L] from 0, and what lies between them by straight lines.
#[derive(Clone, Debug, PartialEq)]
pub struct Grading {
    places: Vec<f64>,
}

impl Grading {
    /// Cells of edge `h` up to `fine`, then each `growth` times the one before, up to `length`; the grown ones are
    /// stretched together to end there.
    pub fn new(h: f64, fine: f64, length: f64, growth: f64) -> Self {
        let count = (fine / h).round().max(1.0) as usize;
        let mut places: Vec<f64> = (0..=count).map(|i| fine * i as f64 / count as f64).collect();
        let (mut end, mut step) = (fine, fine / count as f64);
        while end < length {
            step *= growth;
            end += step;
            places.push(end);
        }
        let stretch = (length - fine) / (end - fine);
        places[count + 1..].iter_mut().for_each(|place| *place = fine + stretch * (*place - fine));
        Grading { places }
    }

    /// Number of cells.
    pub fn cells(&self) -> usize {
        self.places.len() - 1
    }

    /// The place [L] at `part` of the cells, from 0 to 1.
    pub fn at(&self, part: f64) -> f64 {
        let index = (part * self.cells() as f64).clamp(0.0, self.cells() as f64);
        let cell = (index.floor() as usize).min(self.cells() - 1);
        let inside = index - cell as f64;
        self.places[cell] + inside * (self.places[cell + 1] - self.places[cell])
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn cells_are_even_where_fine_and_end_where_asked() {
        let grading = Grading::new(0.25, 1.0, 10.0, 1.5);
        assert_eq!((grading.at(0.0), grading.at(1.0)), (0.0, 10.0));
        let part = |cell: f64| cell / grading.cells() as f64;
        assert_eq!([1.0, 2.5, 4.0].map(|cell| grading.at(part(cell))), [0.25, 0.625, 1.0]);
        let size = |cell: f64| grading.at(part(cell + 1.0)) - grading.at(part(cell));
        assert!((size(5.0) / size(4.0) - 1.5).abs() < 1e-12);
    }
}
