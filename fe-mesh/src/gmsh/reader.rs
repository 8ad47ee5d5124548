//! From section to section.

use super::binary::Binary;
use super::error::{Fault, GmshError};
use super::header::{self, Header, Version};
use super::source::Source;
use super::tags::NodeIndex;
use super::text::Text;
use super::{ElementBlock, GmshMesh, PhysicalGroup, version_2, version_4};
use crate::cell::CellKind;
use std::collections::{BTreeMap, BTreeSet};

/// What the sections gave so far.
#[derive(Default)]
pub(super) struct Parts {
    pub points: Vec<[f64; 3]>,
    pub tags: Vec<u64>,
    pub index: Option<NodeIndex>,
    pub blocks: Option<Vec<RawBlock>>,
    /// Names by dimension and number of the physical group.
    pub names: BTreeMap<(usize, i32), String>,
    /// Physical groups by dimension and tag of the entity.
    pub entities: Option<BTreeMap<(usize, i32), Vec<i32>>>,
}

/// Elements of one kind on one entity.
pub(super) struct RawBlock {
    pub kind: CellKind,
    pub entity: i32,
    pub physicals: Vec<i32>,
    pub tags: Vec<u64>,
    pub nodes: Vec<u32>,
}

/// A section: its name, where its `$` stands, where its body starts.
struct Section<'a> {
    name: &'a str,
    start: usize,
    body: usize,
}

/// Reads a whole file.
pub(super) fn read(bytes: &[u8]) -> Result<GmshMesh, GmshError> {
    let header = header::read(bytes).map_err(|fault| fault.placed(bytes, None))?;
    let mut parts = Parts::default();
    let mut at = header.end;
    let mut context = ("MeshFormat", 0);
    loop {
        let place = |fault: Fault, context| fault.placed(bytes, header.binary.map(|_| context));
        let Some(section) = next_section(bytes, at).map_err(|fault| place(fault, context))? else {
            let fault = parts.missing(at);
            return fault.map_or_else(|| Ok(parts.finish()), |fault| Err(place(fault, context)));
        };
        context = (section.name, section.start);
        at = read_section(bytes, &section, &header, &mut parts).map_err(|fault| place(fault, context))?;
    }
}

/// The section that starts at `at`; `None` at the end of the file.
fn next_section(bytes: &[u8], at: usize) -> Result<Option<Section<'_>>, Fault> {
    let Some(gap) = bytes[at..].iter().position(|b| !b.is_ascii_whitespace()) else { return Ok(None) };
    let start = at + gap;
    let length = bytes[start..].iter().take(128).position(|&b| b == b'\n' || b == b'\r');
    let line = &bytes[start..start + length.unwrap_or((bytes.len() - start).min(128))];
    let name = line.strip_prefix(b"$").and_then(|name| std::str::from_utf8(name).ok()).map(str::trim_end);
    match name {
        Some(name) if !name.is_empty() && !name.starts_with("End") => {
            Ok(Some(Section { name, start, body: start + line.len() }))
        }
        _ => Err(Fault::new(start, "a section should start here, or the file end").allow("$ and the section's name")),
    }
}

/// Reads one section and returns the offset after its end.
fn read_section(bytes: &[u8], section: &Section, header: &Header, parts: &mut Parts) -> Result<usize, Fault> {
    let known = match (section.name, header.version) {
        ("PhysicalNames" | "Nodes" | "Elements", _) => true,
        ("Entities" | "PartitionedEntities", Version::Four) => true,
        ("MeshFormat", _) => return Err(Fault::new(section.start, "$MeshFormat stands here a second time")),
        _ => false,
    };
    let after = if !known {
        return skip_section(bytes, section);
    } else if section.name == "PhysicalNames" {
        read_names(bytes, section.body, parts)?
    } else if let Some(encoding) = header.binary {
        // The body starts right after the line end.
        let mut source = Binary::new(bytes, (section.body + 1).min(bytes.len()), encoding);
        read_numbers(&mut source, section, header.version, parts)?;
        source.at()
    } else {
        let mut source = Text::new(bytes, section.body);
        read_numbers(&mut source, section, header.version, parts)?;
        source.at()
    };
    end_of_section(bytes, after, section.name)
}

fn read_numbers<S: Source>(
    source: &mut S,
    section: &Section,
    version: Version,
    parts: &mut Parts,
) -> Result<(), Fault> {
    let again = match section.name {
        "Nodes" => parts.index.is_some(),
        "Elements" => parts.blocks.is_some(),
        _ => false,
    };
    if again {
        return Err(Fault::new(section.start, format!("${} stands here a second time", section.name)));
    }
    match (section.name, version) {
        ("Nodes", Version::Four) => version_4::nodes(source, parts),
        ("Nodes", Version::Two) => version_2::nodes(source, parts),
        ("Elements", Version::Four) => version_4::elements(source, parts),
        ("Elements", Version::Two) => version_2::elements(source, parts),
        ("Entities", _) => version_4::entities(source, parts, false),
        _ => version_4::entities(source, parts, true),
    }
}

/// Skips a section that carries no mesh.
fn skip_section(bytes: &[u8], section: &Section) -> Result<usize, Fault> {
    let end = format!("\n$End{}", section.name);
    let mut at = section.body;
    // `$` is rare in data: look for it first.
    while let Some(next) = bytes[at..].iter().position(|&b| b == b'$') {
        at += next;
        if bytes[at - 1..].starts_with(end.as_bytes()) {
            return Ok(at - 1 + end.len());
        }
        at += 1;
    }
    Err(Fault::new(section.start, format!("${0} has no $End{0}", section.name))
        .allow("a complete file: was it cut off?"))
}

/// Checks that `$End…` stands here and returns the offset after it.
fn end_of_section(bytes: &[u8], at: usize, name: &str) -> Result<usize, Fault> {
    let gap = bytes[at..].iter().position(|b| !b.is_ascii_whitespace());
    let start = gap.map_or(bytes.len(), |gap| at + gap);
    let end = format!("$End{name}");
    if bytes[start..].starts_with(end.as_bytes()) {
        return Ok(start + end.len());
    }
    let what = if gap.is_none() { "the file ends" } else { "something else stands" };
    Err(Fault::new(start, format!("{what} where {end} should")).allow("as many records as announced"))
}

/// `$PhysicalNames`, text in every file: count, then `dimension tag "name"`, a line each.
fn read_names(bytes: &[u8], body: usize, parts: &mut Parts) -> Result<usize, Fault> {
    let mut source = Text::new(bytes, body);
    source.begin();
    let count = super::source::read_count(&mut source, 3, "physical names")?;
    source.end()?;
    for _ in 0..count {
        source.begin();
        let line = source.at();
        let (dimension, tag) = (source.int()?, source.int()?);
        let rest = &bytes[source.at()..];
        let rest = &rest[..rest.iter().position(|&b| b == b'\n').unwrap_or(rest.len())];
        let quotes = rest.iter().position(|&b| b == b'"').zip(rest.iter().rposition(|&b| b == b'"'));
        let Some((open, close)) = quotes.filter(|(open, close)| open < close) else {
            return Err(Fault::new(line, "a physical name is not in quotes").allow("dimension tag \"name\""));
        };
        let dimension = usize::try_from(dimension).ok().filter(|&d| d <= 3);
        let Some(dimension) = dimension else {
            return Err(Fault::new(line, "a physical group has no dimension from 0 to 3"));
        };
        let name = String::from_utf8_lossy(&rest[open + 1..close]).into_owned();
        if !name.trim().is_empty() {
            parts.names.insert((dimension, tag), name);
        }
        source = Text::new(bytes, source.at() + rest.len());
    }
    Ok(source.at())
}

impl Parts {
    /// What a mesh needs and this file lacks.
    fn missing(&self, end: usize) -> Option<Fault> {
        let section = match (&self.index, &self.blocks) {
            (None, _) => "$Nodes",
            (_, None) => "$Elements",
            _ => return None,
        };
        Some(Fault::new(end, format!("the file has no {section}")).allow("a mesh: generate it before saving"))
    }

    /// Gives each block its groups.
    fn finish(self) -> GmshMesh {
        let raw = self.blocks.unwrap_or_default();
        let used = raw.iter().flat_map(|block| block.physicals.iter().map(|&tag| (block.kind.dimension(), tag)));
        let keys: BTreeSet<(usize, i32)> = self.names.keys().copied().chain(used).collect();
        let keys: Vec<(usize, i32)> = keys.into_iter().collect();
        let index_of = |key: (usize, i32)| keys.binary_search(&key).expect("every used group was collected") as u32;
        let blocks = raw
            .into_iter()
            .map(|block| {
                let dimension = block.kind.dimension();
                let mut groups: Vec<u32> = block.physicals.iter().map(|&tag| index_of((dimension, tag))).collect();
                groups.sort_unstable();
                groups.dedup();
                ElementBlock { kind: block.kind, entity: block.entity, groups, tags: block.tags, nodes: block.nodes }
            })
            .collect();
        let groups = keys
            .iter()
            .map(|&(dimension, tag)| PhysicalGroup { dimension, tag, name: self.names.get(&(dimension, tag)).cloned() })
            .collect();
        GmshMesh { points: self.points, tags: self.tags, blocks, groups }
    }
}

/// The first tag that was there before, in the order of the sequences: its sequence and its place there.
pub(super) fn first_repeated(sequences: &[&[u64]]) -> Option<(usize, usize)> {
    let rising = sequences.iter().all(|tags| tags.is_sorted_by(|a, b| a < b));
    if rising {
        let mut spans: Vec<(u64, u64)> = sequences.iter().filter_map(|t| Some((*t.first()?, *t.last()?))).collect();
        spans.sort_unstable();
        if spans.windows(2).all(|pair| pair[0].1 < pair[1].0) {
            return None;
        }
    }
    let places =
        sequences.iter().enumerate().flat_map(|(s, tags)| tags.iter().enumerate().map(move |(i, &t)| (t, s, i)));
    let mut sorted: Vec<(u64, usize, usize)> = places.collect();
    sorted.sort_unstable();
    sorted.windows(2).filter(|pair| pair[0].0 == pair[1].0).map(|pair| (pair[1].1, pair[1].2)).min()
}
