//! Sections of format 2.2.

use super::error::Fault;
use super::merge::{merge, renumber};
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
