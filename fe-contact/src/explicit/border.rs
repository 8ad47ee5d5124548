//! Where a surface ends: edges that a single face has.

use std::collections::HashMap;

/// The borders of each face, a bit for each edge that no other face has: bit k for that from corner k to the next one, of an edge
/// of a plane model for its end k. Faces are given by their corners, of which so many count.
pub(super) fn borders<'a>(faces: impl Iterator<Item = (&'a [u32; 4], u8)> + Clone) -> Vec<u8> {
    let edges = |(corners, count): (&'a [u32; 4], u8)| {
        let count = usize::from(count);
        let next = move |k: usize| if count > 2 { (k + 1) % count } else { k };
        (0..count).map(move |k| (k, (corners[k].min(corners[next(k)]), corners[k].max(corners[next(k)]))))
    };
    let mut uses: HashMap<(u32, u32), u32> = HashMap::new();
    faces.clone().flat_map(edges).for_each(|(_, edge)| *uses.entry(edge).or_default() += 1);
    faces.map(|face| edges(face).filter(|(_, edge)| uses[edge] == 1).map(|(k, _)| 1 << k).sum()).collect()
}

/// True where a point with such shares of a face's corners lies on one of its borders.
pub(super) fn is_on_border(borders: u8, count: u8, weights: &[f64; 4]) -> bool {
    let count = usize::from(count);
    let ends = if count > 2 { 2 } else { 1 };
    let is_on = |k: usize| (0..count).all(|i| weights[i] == 0.0 || (i + count - k) % count < ends);
    (0..count).any(|k| borders >> k & 1 == 1 && is_on(k))
}
