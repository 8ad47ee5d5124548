//! Format 2.2 repeats an element in each of its physical groups: here it becomes one again.

use super::reader::RawBlock;
use std::collections::BTreeMap;

/// Merges what is the same element of one entity in several physical groups; tells whether there was any.
pub(super) fn merge(blocks: Vec<RawBlock>, points: usize) -> (Vec<RawBlock>, bool) {
    let mut families: Vec<Vec<RawBlock>> = Vec::new();
    let mut places = BTreeMap::new();
    for block in blocks {
        let place = *places.entry((block.kind, block.entity)).or_insert(families.len());
        if place == families.len() {
            families.push(Vec::new());
        }
        families[place].push(block);
    }
    let mut merged = false;
    let mut heads = Vec::new();
    let mut all = Vec::new();
    for mut family in families {
        if family.len() > 1 {
            heads.resize(points, NONE);
            let before: usize = family.iter().map(|block| block.tags.len()).sum();
            family = merge_family(family, &mut heads);
            merged |= family.iter().map(|block| block.tags.len()).sum::<usize>() < before;
        }
        all.append(&mut family);
    }
    (all, merged)
}

const NONE: u32 = u32::MAX;

/// Merges blocks of the same kind and entity, each of one physical group. `heads`: all `NONE`, one a point; it is
/// so again afterwards.
fn merge_family(family: Vec<RawBlock>, heads: &mut [u32]) -> Vec<RawBlock> {
    let (kind, entity) = (family[0].kind, family[0].entity);
    let n = kind.nodes();
    let (mut tags, mut nodes): (Vec<u64>, Vec<u32>) = (Vec::new(), Vec::new());
    // Of each element that was kept: the next one with the same first node, and its set of groups.
    let (mut next, mut set): (Vec<u32>, Vec<usize>) = (Vec::new(), Vec::new());
    let mut sets: Vec<Vec<i32>> = vec![Vec::new()];
    let mut joined: BTreeMap<(usize, i32), usize> = BTreeMap::new();
    for block in &family {
        let physical = block.physicals.first().copied();
        let with = |old: usize, sets: &mut Vec<Vec<i32>>, joined: &mut BTreeMap<(usize, i32), usize>| match physical {
            None => old,
            Some(physical) => *joined.entry((old, physical)).or_insert_with(|| {
                sets.push([sets[old].as_slice(), &[physical]].concat());
                sets.len() - 1
            }),
        };
        let before = tags.len() as u32;
        for (element, &tag) in block.nodes.chunks_exact(n).zip(&block.tags) {
            let head = &mut heads[element[0] as usize];
            let mut at = *head;
            // The same element of the same group is a second element, not a second group.
            while at != NONE && (at >= before || nodes[at as usize * n..][..n] != *element) {
                at = next[at as usize];
            }
            if at == NONE {
                next.push(*head);
                *head = tags.len() as u32;
                tags.push(tag);
                nodes.extend_from_slice(element);
                set.push(with(0, &mut sets, &mut joined));
            } else {
                set[at as usize] = with(set[at as usize], &mut sets, &mut joined);
                tags[at as usize] = tags[at as usize].min(tag);
            }
        }
    }
    for element in nodes.chunks_exact(n) {
        heads[element[0] as usize] = NONE;
    }
    let kept = RawBlock { kind, entity, physicals: Vec::new(), tags, nodes };
    by_groups(kept, &set, &sets)
}

/// Sorts elements into blocks by their set of groups.
fn by_groups(elements: RawBlock, set: &[usize], sets: &[Vec<i32>]) -> Vec<RawBlock> {
    let (kind, entity, n) = (elements.kind, elements.entity, elements.kind.nodes());
    let mut merged: Vec<RawBlock> = Vec::new();
    let mut places = BTreeMap::new();
    for (i, &set) in set.iter().enumerate() {
        let place = *places.entry(set).or_insert_with(|| {
            let physicals = sets[set].clone();
            merged.push(RawBlock { kind, entity, physicals, tags: Vec::new(), nodes: Vec::new() });
            merged.len() - 1
        });
        merged[place].tags.push(elements.tags[i]);
        merged[place].nodes.extend_from_slice(&elements.nodes[i * n..][..n]);
    }
    merged
}

/// Where gmsh numbered every copy of an element by itself, the merged elements are numbered through instead, which is
/// how format 4.1 numbers them; other numbers stay.
pub(super) fn renumber(mut blocks: Vec<RawBlock>, tags: &[u64]) -> Vec<RawBlock> {
    let first = tags.first().copied().unwrap_or(1);
    if !tags.iter().enumerate().all(|(i, &tag)| tag.wrapping_sub(first) == i as u64) {
        return blocks;
    }
    let mut kept = vec![false; tags.len()];
    for &tag in blocks.iter().flat_map(|block| &block.tags) {
        kept[(tag - first) as usize] = true;
    }
    let mut label = first;
    let labels: Vec<u64> = kept
        .iter()
        .map(|&kept| {
            let this = label;
            label += kept as u64;
            this
        })
        .collect();
    for tag in blocks.iter_mut().flat_map(|block| &mut block.tags) {
        *tag = labels[(*tag - first) as usize];
    }
    blocks
}
