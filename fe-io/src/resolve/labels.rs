//! Labels to indices.

use std::collections::{HashMap, HashSet};

/// Labels of nodes or elements. Dense ones cost four bytes each.
#[derive(Debug, Default)]
pub struct Labels {
    /// Index + 1; 0: none.
    dense: Vec<u32>,
    sparse: HashMap<u64, u32>,
    /// Labels whose line is faulty: they are there, but stand for nothing.
    faulty: HashSet<u64>,
    count: usize,
}

impl Labels {
    /// Adds a label; `Err` with the index that already has it.
    pub fn insert(&mut self, label: u64, index: u32) -> Result<(), u32> {
        if let Some(there) = self.get(label) {
            return Err(there);
        }
        self.count += 1;
        if label < 2 * self.count as u64 + 65_536 {
            let at = label as usize;
            if at >= self.dense.len() {
                self.dense.resize((at + 1).max(2 * self.dense.len().min(at)), 0);
            }
            self.dense[at] = index + 1;
        } else {
            self.sparse.insert(label, index);
        }
        Ok(())
    }

    /// The index of a label.
    pub fn get(&self, label: u64) -> Option<u32> {
        match usize::try_from(label).ok().and_then(|at| self.dense.get(at)) {
            Some(&index) if index > 0 => Some(index - 1),
            _ if self.sparse.is_empty() => None,
            _ => self.sparse.get(&label).copied(),
        }
    }

    /// Number of labels.
    pub fn count(&self) -> usize {
        self.count
    }

    /// All labels in ascending order.
    pub fn ascending(&self) -> Vec<u64> {
        let dense = (0u64..).zip(&self.dense).filter(|(_, index)| **index > 0).map(|(label, _)| label);
        let mut all: Vec<u64> = dense.chain(self.sparse.keys().copied()).collect();
        all.sort_unstable();
        all
    }

    /// This label's line is faulty, which was told.
    pub fn spoil(&mut self, label: u64) {
        self.faulty.insert(label);
    }

    /// True when the label's line is faulty.
    pub fn is_faulty(&self, label: u64) -> bool {
        self.faulty.contains(&label)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn dense_and_sparse_labels_are_found() {
        let mut labels = Labels::default();
        let all = [7, 1, 0, 65_535, 1 << 40, 200_000, 8, 999_999_999_999];
        for (index, label) in all.into_iter().enumerate() {
            assert_eq!(labels.insert(label, index as u32), Ok(()));
        }
        for (index, label) in all.into_iter().enumerate() {
            assert_eq!(labels.get(label), Some(index as u32));
            assert_eq!(labels.insert(label, 99), Err(index as u32));
        }
        assert_eq!(labels.count(), all.len());
        assert_eq!(labels.ascending(), [0, 1, 7, 8, 65_535, 200_000, 999_999_999_999, 1 << 40]);
        assert_eq!([2, 65_534, 1 << 41].map(|l| labels.get(l)), [None; 3]);
    }
}
