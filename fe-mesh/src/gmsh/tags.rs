//! From node tags to point indices.

use std::collections::HashMap;
use std::hash::{BuildHasherDefault, Hasher};

/// The place of every node by its tag.
pub(super) enum NodeIndex {
    /// Tags run through: the place is the distance from the first.
    Consecutive { first: u64, count: u64 },
    /// One entry a tag from `first` on; `u32::MAX` where no node has it.
    Dense { first: u64, places: Vec<u32> },
    /// Far between.
    Sparse(HashMap<u64, u32, BuildHasherDefault<TagHasher>>),
}

const NONE: u32 = u32::MAX;

impl NodeIndex {
    /// Indexes the tags, or gives the place of the first tag that was there before.
    pub fn new(tags: &[u64]) -> Result<Self, usize> {
        let first = tags.first().copied().unwrap_or(1);
        if tags.iter().enumerate().all(|(i, &tag)| tag.wrapping_sub(first) == i as u64) {
            return Ok(NodeIndex::Consecutive { first, count: tags.len() as u64 });
        }
        let (low, high) = tags.iter().fold((u64::MAX, 0), |(low, high), &tag| (low.min(tag), high.max(tag)));
        if high - low < 4 * tags.len() as u64 {
            let mut places = vec![NONE; (high - low + 1) as usize];
            for (i, &tag) in tags.iter().enumerate() {
                let place = &mut places[(tag - low) as usize];
                if *place != NONE {
                    return Err(i);
                }
                *place = i as u32;
            }
            return Ok(NodeIndex::Dense { first: low, places });
        }
        let mut places = HashMap::with_capacity_and_hasher(tags.len(), BuildHasherDefault::default());
        for (i, &tag) in tags.iter().enumerate() {
            if places.insert(tag, i as u32).is_some() {
                return Err(i);
            }
        }
        Ok(NodeIndex::Sparse(places))
    }

    /// Index of the point with this tag.
    #[inline]
    pub fn find(&self, tag: u64) -> Option<u32> {
        match self {
            NodeIndex::Consecutive { first, count } => {
                let place = tag.wrapping_sub(*first);
                (place < *count).then_some(place as u32)
            }
            NodeIndex::Dense { first, places } => {
                places.get(usize::try_from(tag.wrapping_sub(*first)).ok()?).copied().filter(|&place| place != NONE)
            }
            NodeIndex::Sparse(places) => places.get(&tag).copied(),
        }
    }
}

/// Hashes a tag by one multiplication; tags are no adversary's.
#[derive(Default)]
pub(super) struct TagHasher(u64);

impl Hasher for TagHasher {
    fn finish(&self) -> u64 {
        self.0
    }

    fn write(&mut self, bytes: &[u8]) {
        for &byte in bytes {
            self.write_u64(byte as u64);
        }
    }

    fn write_u64(&mut self, value: u64) {
        let mixed = (self.0 ^ value).wrapping_mul(0x9E37_79B9_7F4A_7C15);
        self.0 = mixed ^ (mixed >> 32);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// All three ways find each node and nothing else, and tell a repeated tag.
    #[test]
    fn finds_what_is_there() {
        for tags in [vec![5, 6, 7, 8], vec![9, 4, 7, 12], vec![1, 1 << 40, 77, u64::MAX]] {
            let index = NodeIndex::new(&tags).unwrap();
            for (i, &tag) in tags.iter().enumerate() {
                assert_eq!(index.find(tag), Some(i as u32));
            }
            for missing in [0, 3, 10, 13, 1 << 41] {
                assert_eq!(index.find(missing), None);
            }
            let twice = [tags.as_slice(), &[tags[2]]].concat();
            assert_eq!(NodeIndex::new(&twice).err(), Some(4));
        }
        assert_eq!(NodeIndex::new(&[]).unwrap().find(1), None);
    }
}
