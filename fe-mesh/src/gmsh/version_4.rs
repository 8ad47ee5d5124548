//! Sections of format 4.1.

use super::error::Fault;
use super::kind;
use super::reader::{Parts, RawBlock, first_repeated};
use super::source::{Source, count, read_count};
use super::tags::NodeIndex;
use std::collections::BTreeMap;

/// `$Entities`, or `$PartitionedEntities`, whose tags the blocks then refer to: only the physical groups are kept.
pub(super) fn entities<S: Source>(source: &mut S, parts: &mut Parts, partitioned: bool) -> Result<(), Fault> {
    source.begin();
    if partitioned {
        source.size()?;
        source.end()?;
        source.begin();
        for _ in 0..read_count(source, 2, "ghost entities")? {
            source.begin();
            source.skip_ints(2)?;
        }
        source.begin();
    }
    let mut counts = [0; 4];
    for count in &mut counts {
        *count = read_count(source, 5, "entities")?;
    }
    source.end()?;
    let mut physicals_of = BTreeMap::new();
    for (dimension, count) in counts.into_iter().enumerate() {
        for _ in 0..count {
            source.begin();
            let (tag, physicals) = entity(source, dimension, partitioned)?;
            source.end()?;
            physicals_of.insert((dimension, tag), physicals);
        }
    }
    parts.entities = Some(physicals_of);
    Ok(())
}

/// One entity: its tag and its physical groups (a negative one means the group, reversed).
fn entity<S: Source>(source: &mut S, dimension: usize, partitioned: bool) -> Result<(i32, Vec<i32>), Fault> {
    let tag = source.int()?;
    if partitioned {
        source.skip_ints(2)?;
        let partitions = read_count(source, 1, "partitions")?;
        source.skip_ints(partitions)?;
    }
    source.skip_floats(if dimension == 0 { 3 } else { 6 })?;
    let mut physicals = Vec::new();
    for _ in 0..read_count(source, 1, "physical groups")? {
        physicals.push(source.int()?.saturating_abs());
    }
    if dimension > 0 {
        let bounding = read_count(source, 1, "bounding entities")?;
        source.skip_ints(bounding)?;
    }
    Ok((tag, physicals))
}

/// `$Nodes`: blocks of tags, then of coordinates.
pub(super) fn nodes<S: Source>(source: &mut S, parts: &mut Parts) -> Result<(), Fault> {
    source.begin();
    let blocks = source.size()?;
    let total = read_count(source, 4, "nodes")?;
    source.skip_sizes(2)?;
    source.end()?;
    parts.points.reserve_exact(total);
    parts.tags.reserve_exact(total);
    let mut starts = Vec::new();
    for _ in 0..blocks {
        source.begin();
        let (dimension, _entity, parametric) = (source.int()?, source.int()?, source.int()?);
        let announced = source.size()?;
        let many = count(source, announced, 4, "nodes of a block")?;
        source.end()?;
        source.begin();
        let first = parts.tags.len();
        starts.push((first, source.at()));
        for _ in 0..many {
            source.begin();
            parts.tags.push(source.size()?);
        }
        let parameters = if parametric == 1 { dimension.clamp(0, 3) as usize } else { 0 };
        for i in first..first + many {
            source.begin();
            parts.points.push(point(source, parts.tags[i])?);
            source.skip_floats(parameters)?;
            source.end()?;
        }
    }
    if parts.tags.len() != total {
        let what = format!("$Nodes announced {total} nodes, its blocks hold {}", parts.tags.len());
        return Err(Fault::new(source.at(), what));
    }
    parts.index = Some(index(source, &parts.tags, &starts)?);
    Ok(())
}

/// Coordinates of a node, each finite.
pub(super) fn point<S: Source>(source: &mut S, tag: u64) -> Result<[f64; 3], Fault> {
    let at = source.at();
    let mut point = [0.0; 3];
    for x in &mut point {
        *x = source.float().map_err(|fault| fault.within(format_args!("node {tag}")))?;
    }
    if point.iter().all(|x| x.is_finite()) {
        return Ok(point);
    }
    Err(Fault::new(at, format!("node {tag} has a coordinate that is not finite: {point:?}"))
        .allow("numbers that a double holds"))
}

/// The index of the nodes; `starts`: first node and offset of each block of tags.
fn index<S: Source>(source: &mut S, tags: &[u64], starts: &[(usize, usize)]) -> Result<NodeIndex, Fault> {
    if tags.len() >= u32::MAX as usize {
        return Err(Fault::new(source.at(), "more than 2³² nodes"));
    }
    NodeIndex::new(tags).map_err(|again| {
        let (first, offset) = starts[starts.partition_point(|&(first, _)| first <= again) - 1];
        source.go_to(offset);
        source.skip_records(again - first, S::size_bytes(source));
        Fault::new(source.at(), format!("node {} is given a second time", tags[again])).allow("each node once")
    })
}

/// `$Elements`: blocks of elements of one kind on one entity.
pub(super) fn elements<S: Source>(source: &mut S, parts: &mut Parts) -> Result<(), Fault> {
    source.begin();
    let blocks = source.size()?;
    let total = read_count(source, 2, "elements")?;
    source.skip_sizes(2)?;
    source.end()?;
    let mut read = Vec::new();
    let mut starts = Vec::new();
    for _ in 0..blocks {
        source.begin();
        let block = element_block(source, parts, &mut starts)?;
        if !block.tags.is_empty() {
            read.push(block);
        } else {
            starts.pop();
        }
    }
    let many: usize = read.iter().map(|block: &RawBlock| block.tags.len()).sum();
    if many != total {
        let what = format!("$Elements announced {total} elements, its blocks hold {many}");
        return Err(Fault::new(source.at(), what));
    }
    let sequences: Vec<&[u64]> = read.iter().map(|block| block.tags.as_slice()).collect();
    if let Some((block, i)) = first_repeated(&sequences) {
        source.go_to(starts[block]);
        source.skip_records(i, (1 + read[block].kind.nodes()) * S::size_bytes(source));
        let what = format!("element {} is given a second time", read[block].tags[i]);
        return Err(Fault::new(source.at(), what).allow("each element once"));
    }
    parts.blocks = Some(read);
    Ok(())
}

/// One block of elements; adds the offset of its first element to `starts`.
fn element_block<S: Source>(source: &mut S, parts: &Parts, starts: &mut Vec<usize>) -> Result<RawBlock, Fault> {
    let at = source.at();
    let (dimension, entity, number) = (source.int()?, source.int()?, source.int()?);
    let announced = source.size()?;
    let (kind, order) = known_kind(number, at)?;
    if dimension != kind.dimension() as i32 {
        let what = format!("elements of type {number} ({kind:?}) stand in a block of dimension {dimension}");
        return Err(Fault::new(at, what).allow(format!("dimension {}", kind.dimension())));
    }
    let physicals = match &parts.entities {
        None => Vec::new(),
        Some(entities) => match entities.get(&(kind.dimension(), entity)) {
            Some(physicals) => physicals.clone(),
            None => {
                let what = format!("elements on the entity {entity} of dimension {dimension}, which is not listed");
                return Err(Fault::new(at, what).allow("entities of $Entities (or of $PartitionedEntities)"));
            }
        },
    };
    let many = count(source, announced, 1 + kind.nodes(), "elements of a block")?;
    source.end()?;
    let mut tags = Vec::with_capacity(many);
    let mut nodes = Vec::with_capacity(many * kind.nodes());
    source.begin();
    starts.push(source.at());
    let index = known_nodes(parts, source.at())?;
    let mut record = [0; 1 + MOST_NODES];
    let record = &mut record[..=kind.nodes()];
    for _ in 0..many {
        source.begin();
        let at = source.at();
        element_record(source, record)?;
        let (tag, element) = (record[0], &record[1..]);
        append_points(index, element, order, &mut nodes).map_err(|i| {
            let at = if S::BINARY { at + (1 + i) * source.size_bytes() } else { at };
            missing_node(at, tag, element[i])
        })?;
        tags.push(tag);
    }
    Ok(RawBlock { kind, entity, physicals, tags, nodes })
}

/// Reads tag and nodes of an element.
fn element_record<S: Source>(source: &mut S, record: &mut [u64]) -> Result<(), Fault> {
    if source.sizes(record) {
        return Ok(());
    }
    record[0] = source.size()?;
    let (tag, many) = (record[0], record.len() - 1);
    for (i, node) in record[1..].iter_mut().enumerate() {
        let within = |fault: Fault| fault.within(format_args!("element {tag}, node {} of {many}", i + 1));
        *node = source.size().map_err(within)?;
    }
    source.end().map_err(|fault| fault.within(format_args!("element {tag} ({many} nodes)")))
}

/// The kind of element with gmsh's number.
pub(super) fn known_kind(number: i32, at: usize) -> Result<(crate::CellKind, &'static [u8]), Fault> {
    kind::from_gmsh(number).ok_or_else(|| {
        let described = kind::describe_unsupported(number);
        Fault::new(at, format!("element type {number} ({described}) is not read")).allow(kind::SUPPORTED)
    })
}

/// Appends the points with these tags, in the decks' order, or gives the place of the first tag that no node has.
pub(super) fn append_points(index: &NodeIndex, tags: &[u64], order: &[u8], nodes: &mut Vec<u32>) -> Result<(), usize> {
    let before = nodes.len();
    for (i, &tag) in tags.iter().enumerate() {
        nodes.push(index.find(tag).ok_or(i)?);
    }
    if !order.is_empty() {
        let mut found = [0; MOST_NODES];
        found[..tags.len()].copy_from_slice(&nodes[before..]);
        for (node, &from) in nodes[before..].iter_mut().zip(order) {
            *node = found[from as usize];
        }
    }
    Ok(())
}

/// Nodes of the largest element.
pub(super) const MOST_NODES: usize = 27;

/// The index of the nodes, which elements need.
pub(super) fn known_nodes(parts: &Parts, at: usize) -> Result<&NodeIndex, Fault> {
    parts.index.as_ref().ok_or_else(|| Fault::new(at, "$Elements stands before $Nodes").allow("nodes first"))
}

/// An element with a node that is not there.
pub(super) fn missing_node(at: usize, element: u64, node: u64) -> Fault {
    Fault::new(at, format!("element {element} has node {node}, which $Nodes does not hold"))
        .allow("tags of nodes of the file")
}
