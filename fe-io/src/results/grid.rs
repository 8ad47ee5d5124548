//! The mesh that results live on, as VTKHDF keeps it.

use super::container::{Attribute, Container, Numbers, Owner};
use super::error::ResultsError;
use fe_mesh::cell::CellKind;
use fe_mesh::mesh::Instance;

/// Cells of one kind.
#[derive(Clone, Copy, Debug)]
pub struct GridBlock<'a> {
    /// Kind of every cell here.
    pub kind: CellKind,
    /// The labels the user knows the cells by, `[cells]`.
    pub labels: &'a [u64],
    /// Point indices, `[cells × kind.nodes()]`.
    pub nodes: &'a [u32],
}

/// Points and cells. The same through the whole job.
#[derive(Clone, Copy, Debug)]
pub struct Grid<'a> {
    /// Coordinates [L], `[points]`.
    pub points: &'a [[f64; 3]],
    /// The labels the user knows the points by, `[points]`.
    pub node_labels: &'a [u64],
    /// Blocks of like cells; may be empty.
    pub blocks: &'a [GridBlock<'a>],
    /// Body (section) of each cell, blocks in order, `[cells]`.
    pub body: &'a [u32],
    /// Copies of parts, in which labels are unique; none in most jobs.
    pub instances: &'a [Instance],
}

/// Arrays that stand beside the fields and never change: name, at points or cells, meaning.
const LABELS: [(&str, &str, &str); 3] = [
    ("NodeLabel", "PointData", "label of the node"),
    ("ElementLabel", "CellData", "label of the element"),
    ("Body", "CellData", "section that the element belongs to, from 0"),
];

/// Where the numbers of the instances stand, in a job of parts.
const INSTANCE: [(&str, &str); 2] = [("Instance", "PointData"), ("Instance", "CellData")];

/// Nodes that VTK's cell of this kind has: it knows no pyramid of 14 nodes.
fn vtk_nodes(kind: CellKind) -> usize {
    if kind == CellKind::Pyramid14 { 13 } else { kind.nodes() }
}

impl Grid<'_> {
    /// Number of cells.
    pub fn cells(&self) -> usize {
        self.blocks.iter().map(|b| b.labels.len()).sum()
    }

    /// Arrays that stand beside the fields and never change: name, and group.
    pub(crate) fn constant_arrays(&self) -> impl Iterator<Item = (&'static str, &'static str)> + use<> {
        let instances = if self.instances.is_empty() { &[][..] } else { &INSTANCE[..] };
        LABELS.into_iter().map(|(name, group, _)| (name, group)).chain(instances.iter().copied())
    }

    pub(crate) fn check(&self) -> Result<(), ResultsError> {
        ResultsError::length("labels of the points", self.points.len(), self.node_labels.len())?;
        ResultsError::length("bodies of the cells", self.cells(), self.body.len())?;
        for block in self.blocks {
            let nodes = block.kind.nodes();
            ResultsError::length(
                format!("nodes of {:?} cells", block.kind),
                block.labels.len() * nodes,
                block.nodes.len(),
            )?;
            if let Some(at) = block.nodes.iter().position(|&n| n as usize >= self.points.len()) {
                let (label, point) = (block.labels[at / nodes], block.nodes[at]);
                return Err(ResultsError::Point { label, point, points: self.points.len() });
            }
        }
        Ok(())
    }

    /// Writes the geometry and the label arrays below `/VTKHDF`, whose data groups exist.
    pub(crate) fn write(&self, file: &impl Container) -> Result<(), ResultsError> {
        let (mut connectivity, mut offsets, mut types, mut labels) = (Vec::new(), vec![0i64], Vec::new(), Vec::new());
        for block in self.blocks {
            for (cell, &label) in block.nodes.chunks_exact(block.kind.nodes()).zip(block.labels) {
                connectivity.extend(cell[..vtk_nodes(block.kind)].iter().map(|&n| n as i64));
                offsets.push(connectivity.len() as i64);
                types.push(block.kind.vtk());
                labels.push(label as i64);
            }
        }
        for (name, count) in [
            ("NumberOfPoints", self.points.len()),
            ("NumberOfCells", types.len()),
            ("NumberOfConnectivityIds", connectivity.len()),
        ] {
            file.array(&format!("VTKHDF/{name}"), 1, Numbers::Integer(&[count as i64]))?;
        }
        file.array("VTKHDF/Points", 3, Numbers::Real(self.points.as_flattened()))?;
        file.array("VTKHDF/Connectivity", 1, Numbers::Integer(&connectivity))?;
        file.array("VTKHDF/Offsets", 1, Numbers::Integer(&offsets))?;
        file.array("VTKHDF/Types", 1, Numbers::Byte(&types))?;
        let nodes: Vec<i64> = self.node_labels.iter().map(|&l| l as i64).collect();
        let bodies: Vec<i64> = self.body.iter().map(|&b| b as i64).collect();
        for ((name, group, meaning), values) in LABELS.into_iter().zip([nodes, labels, bodies]) {
            let path = format!("VTKHDF/{group}/{name}");
            file.array(&path, 1, Numbers::Integer(&values))?;
            file.attribute(Owner::Array(&path), "meaning", Attribute::Text(meaning))?;
        }
        if self.instances.is_empty() { Ok(()) } else { self.write_instances(file) }
    }

    /// Which instance each point and each cell belongs to: labels are unique in it.
    fn write_instances(&self, file: &impl Container) -> Result<(), ResultsError> {
        let before = |block: u32| self.blocks[..block as usize].iter().map(|b| b.labels.len()).sum::<usize>();
        let (mut points, mut cells) = (vec![0i64; self.points.len()], vec![0i64; self.cells()]);
        for (number, instance) in (1..).zip(self.instances) {
            let range = |r: &std::ops::Range<u32>, from: usize| from + r.start as usize..from + r.end as usize;
            points[range(&instance.points, 0)].fill(number);
            for (block, own) in &instance.cells {
                cells[range(own, before(*block))].fill(number);
            }
        }
        let names: Vec<&str> = self.instances.iter().map(|instance| instance.name.as_str()).collect();
        let meaning = format!("instance that the label belongs to, from 1: {}; 0: none", names.join(", "));
        for ((name, group), values) in INSTANCE.into_iter().zip([points, cells]) {
            let path = format!("VTKHDF/{group}/{name}");
            file.array(&path, 1, Numbers::Integer(&values))?;
            file.attribute(Owner::Array(&path), "meaning", Attribute::Text(&meaning))?;
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_grid_that_does_not_fit_is_refused() {
        let points = [[0.0; 3]; 4];
        let block = GridBlock { kind: CellKind::Tet4, labels: &[7], nodes: &[0, 1, 2, 4] };
        let grid = Grid { points: &points, node_labels: &[1, 2, 3, 4], blocks: &[block], body: &[0], instances: &[] };
        assert!(matches!(grid.check(), Err(ResultsError::Point { label: 7, point: 4, points: 4 })));
        let short = GridBlock { nodes: &[0, 1, 2], ..block };
        assert!(matches!(Grid { blocks: &[short], ..grid }.check(), Err(ResultsError::Length { expected: 4, .. })));
        assert!(matches!(Grid { body: &[], ..grid }.check(), Err(ResultsError::Length { expected: 1, found: 0, .. })));
        assert!(matches!(Grid { node_labels: &[1], ..grid }.check(), Err(ResultsError::Length { .. })));
        let good = GridBlock { nodes: &[0, 1, 2, 3], ..block };
        assert!(Grid { blocks: &[good], ..grid }.check().is_ok());
    }
}
