//! Memory of updates that are free again.

use std::sync::{Mutex, PoisonError};

/// Arrays that are no longer needed.
#[derive(Default)]
pub(super) struct Pool(Mutex<Vec<Vec<f64>>>);

impl Pool {
    /// At least `length` numbers, and true when they are zero: a free array that fits, or a new one. Smaller arrays make
    /// room for a new one, so that the pool holds little more than is in use at a time.
    pub fn take(&self, length: usize) -> (Vec<f64>, bool) {
        if length == 0 {
            return (Vec::new(), true);
        }
        let mut free = self.0.lock().unwrap_or_else(PoisonError::into_inner);
        let fitting = (0..free.len()).filter(|&k| (length..4 * length + (1 << 16)).contains(&free[k].len()));
        if let Some(k) = fitting.min_by_key(|&k| free[k].len()) {
            return (free.swap_remove(k), false);
        }
        let mut room = 0;
        let smaller =
            |free: &[Vec<f64>]| (0..free.len()).filter(|&k| free[k].len() < length).max_by_key(|&k| free[k].len());
        while let Some(k) = smaller(&free).filter(|_| room < length) {
            room += free.swap_remove(k).len();
        }
        drop(free);
        (vec![0.0; length], true)
    }

    /// Takes an array back.
    pub fn give(&self, numbers: Vec<f64>) {
        if !numbers.is_empty() {
            self.0.lock().unwrap_or_else(PoisonError::into_inner).push(numbers);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_pool_gives_what_fits_best_and_lets_go_of_what_is_too_small() {
        let pool = Pool::default();
        let lengths = |pool: &Pool| pool.0.lock().unwrap().iter().map(|n| n.len()).collect::<Vec<_>>();
        [1000, 3000, 2000].into_iter().for_each(|length| pool.give(vec![0.0; length]));
        let (taken, zero) = pool.take(1500);
        assert_eq!((taken.len(), zero, lengths(&pool)), (2000, false, vec![1000, 3000]));
        let (made, zero) = pool.take(3500);
        assert_eq!((made.len(), zero, lengths(&pool)), (3500, true, Vec::new()));
        assert_eq!(made, vec![0.0; 3500]);
    }
}
