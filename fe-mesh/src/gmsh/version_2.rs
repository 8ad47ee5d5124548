//! Sections of format 2.2.

use super::error::Fault;
use super::reader::{Parts, RawBlock, first_repeated};
use super::source::{Source, count};
use super::tags::NodeIndex;
use super::version_4::{MOST_NODES, append_points, known_kind, known_nodes, missing_node, point};
use crate::cell::CellKind;
use std::collections::BTreeMap;

/// The count that opens a section: a line of text in binary files too.
fn opening_count<S: Source>(source: &mut S, values: usize, what: &str) -> Result<usize, Fault> {
    source.begin();
    let announced = source.count_line()?;
    let many = count(source, announced, values, what)?;
    source.end()?;
    Ok(many)
}

/// A tag: an int that is not negative.
fn tag<S: Source>(source: &mut S) -> Result<u64, Fault> {
    let at = source.at();
    u64::try_from(source.int()?).map_err(|_| Fault::new(at, "a tag is negative").allow("tags from 1 on"))
}

/// `$Nodes`: tag and coordinates of each.
pub(super) fn nodes<S: Source>(source: &mut S, parts: &mut Parts) -> Result<(), Fault> {
    let many = opening_count(source, 4, "nodes")?;
    parts.points.reserve_exact(many);
    parts.tags.reserve_exact(many);
    source.begin();
    let start = source.at();
    for _ in 0..many {
        source.begin();
        let tag = tag(source)?;
        parts.tags.push(tag);
        parts.points.push(point(source, tag)?);
        source.end()?;
    }
    let index = NodeIndex::new(&parts.tags).map_err(|again| {
        source.go_to(start);
        source.skip_records(again, 28);
        Fault::new(source.at(), format!("node {} is given a second time", parts.tags[again])).allow("each node once")
    })?;
    parts.index = Some(index);
    Ok(())
}

/// Elements as they are sorted into blocks; gmsh repeats an element in each of its physical groups.
#[derive(Default)]
struct Sorted {
    /// Tags in the file's order.
    tags: Vec<u64>,
    /// By kind, entity and physical group, in order of appearance.
    blocks: Vec<RawBlock>,
    /// Place of each block.
    places: BTreeMap<(CellKind, i32, i32), usize>,
    /// Key and place of the last element's block.
    last: Option<((CellKind, i32, i32), usize)>,
}

impl Sorted {
    /// The block of these elements.
    fn block(&mut self, key: (CellKind, i32, i32)) -> &mut RawBlock {
        let place = match self.last {
            Some((last, place)) if last == key => place,
            _ => *self.places.entry(key).or_insert_with(|| {
                let (kind, entity, physical) = key;
                let physicals = if physical == 0 { Vec::new() } else { vec![physical] };
                self.blocks.push(RawBlock { kind, entity, physicals, tags: Vec::new(), nodes: Vec::new() });
                self.blocks.len() - 1
            }),
        };
        self.last = Some((key, place));
        &mut self.blocks[place]
    }
}

/// `$Elements`. Text: a line each with its type; binary: runs of one type under a header.
pub(super) fn elements<S: Source>(source: &mut S, parts: &mut Parts) -> Result<(), Fault> {
    let total = opening_count(source, 3, "elements")?;
    source.begin();
    let start = source.at();
    let mut sorted = Sorted::default();
    sorted.tags.reserve_exact(total);
    while sorted.tags.len() < total {
        source.begin();
        if S::BINARY {
            run(source, total, parts, &mut sorted)?;
        } else {
            let id = tag(source)?;
            let at = source.at();
            let (number, tags) = (source.int()?, source.int()?);
            let (kind, order) = known_kind(number, at)?;
            element(source, (id, kind, order, tags), parts, &mut sorted)?;
        }
    }
    if let Some((_, again)) = first_repeated(&[&sorted.tags]) {
        source.go_to(start);
        source.skip_records(again, 0);
        let what = format!("element {} is given a second time", sorted.tags[again]);
        return Err(Fault::new(source.at(), what).allow("each element once"));
    }
    let (blocks, merged) = merge(sorted.blocks, parts.points.len());
    parts.blocks = Some(if merged { renumber(blocks, &sorted.tags) } else { blocks });
    Ok(())
}

/// A run of elements of one type in binary.
fn run<S: Source>(source: &mut S, total: usize, parts: &Parts, sorted: &mut Sorted) -> Result<(), Fault> {
    let at = source.at();
    let (number, many, tags) = (source.int()?, source.int()?, source.int()?);
    let (kind, order) = known_kind(number, at)?;
    let left = total - sorted.tags.len();
    if many < 1 || many as usize > left {
        let what = format!("a run of {many} elements stands where {left} are left to read");
        return Err(Fault::new(at, what));
    }
    for _ in 0..many {
        let id = tag(source)?;
        element(source, (id, kind, order, tags), parts, sorted)?;
    }
    Ok(())
}

/// The rest of an element (tag, kind, node order, number of its tags): tags and nodes.
fn element<S: Source>(
    source: &mut S,
    (id, kind, order, tags): (u64, CellKind, &[u8], i32),
    parts: &Parts,
    sorted: &mut Sorted,
) -> Result<(), Fault> {
    let (mut physical, mut entity) = (0, 0);
    for i in 0..tags {
        let value = source.int().map_err(|fault| fault.within(format_args!("element {id}, tag {}", i + 1)))?;
        match i {
            0 => physical = value.saturating_abs(),
            1 => entity = value,
            _ => {}
        }
    }
    let many = kind.nodes();
    let mut nodes = [0; MOST_NODES];
    let nodes = &mut nodes[..many];
    let at = source.at();
    for (i, node) in nodes.iter_mut().enumerate() {
        let within = |fault: Fault| fault.within(format_args!("element {id}, node {} of {many}", i + 1));
        *node = tag(source).map_err(within)?;
    }
    source.end().map_err(|fault| fault.within(format_args!("element {id} ({many} nodes)")))?;
    let block = sorted.block((kind, entity, physical));
    append_points(known_nodes(parts, at)?, nodes, order, &mut block.nodes)
        .map_err(|i| missing_node(if S::BINARY { at + 4 * i } else { at }, id, nodes[i]))?;
    block.tags.push(id);
    sorted.tags.push(id);
    Ok(())
}

/// Merges what is the same element of one entity in several physical groups; tells whether there was any.
fn merge(blocks: Vec<RawBlock>, points: usize) -> (Vec<RawBlock>, bool) {
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
    let mut merged: Vec<RawBlock> = Vec::new();
    let mut places = BTreeMap::new();
    for (i, &set) in set.iter().enumerate() {
        let place = *places.entry(set).or_insert_with(|| {
            let physicals = sets[set].clone();
            merged.push(RawBlock { kind, entity, physicals, tags: Vec::new(), nodes: Vec::new() });
            merged.len() - 1
        });
        merged[place].tags.push(tags[i]);
        merged[place].nodes.extend_from_slice(&nodes[i * n..][..n]);
    }
    merged
}

/// Where gmsh numbered every copy of an element by itself, the merged elements are numbered through instead, which is
/// how format 4.1 numbers them; other numbers stay.
fn renumber(mut blocks: Vec<RawBlock>, tags: &[u64]) -> Vec<RawBlock> {
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
