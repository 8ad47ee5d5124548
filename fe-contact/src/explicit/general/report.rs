//! What is told of general contact.

use super::GeneralContact;
use super::touch::{Look, Touch};
use crate::explicit::pair::PointState;
use crate::point::ContactStatus;
use std::mem::size_of_val;

/// How much general contact there is.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct GeneralCount {
    /// Faces that may touch.
    pub faces: usize,
    /// Their nodes.
    pub nodes: usize,
    /// Their feature edges.
    pub edges: usize,
    /// Pairs of a node and a face, and of edges, near each other.
    pub near: usize,
    /// Those that touch.
    pub closed: usize,
    /// Searches so far.
    pub searches: usize,
    /// Bytes of all of it.
    pub bytes: usize,
    /// Least and largest stiffness [F/L] of hard contact of a node; `None` before the first increment, or where all is held.
    pub penalty: Option<[f64; 2]>,
}

impl GeneralContact {
    /// What messages call it.
    pub fn label(&self) -> &str {
        &self.name
    }

    /// What acts, behaviour after behaviour.
    pub fn in_words(&self) -> String {
        let all = self.ground.table.behaviours.iter().map(|behaviour| behaviour.in_words("hard"));
        all.collect::<Vec<_>>().join("; ")
    }

    /// How much there is at present.
    pub fn count(&self) -> GeneralCount {
        let ground = &self.ground;
        let near = |run: &super::Nodes| run.candidates();
        let moving = ground.penalties.iter().copied().filter(|penalty| penalty.is_finite());
        let penalty = moving.fold(None, |all: Option<[f64; 2]>, p| {
            let [least, most] = all.unwrap_or([p, p]);
            Some([least.min(p), most.max(p)])
        });
        GeneralCount {
            faces: ground.surface.faces.len(),
            nodes: ground.surface.nodes.len(),
            edges: ground.surface.edges.len(),
            near: self.nodes.iter().map(near).sum::<usize>()
                + self.edges.iter().map(|run| run.candidates()).sum::<usize>(),
            closed: self.touches().filter(|touch| touch.is_closed()).count(),
            searches: self.searches,
            bytes: self.bytes(),
            penalty,
        }
    }

    fn bytes(&self) -> usize {
        let ground = &self.ground;
        let lists = size_of_val(&ground.surface.faces[..])
            + size_of_val(&ground.surface.nodes[..])
            + size_of_val(&ground.surface.edges[..])
            + size_of_val(&ground.penalties[..]);
        let runs = self.nodes.iter().map(|run| run.bytes()).sum::<usize>()
            + self.edges.iter().map(|r| r.bytes()).sum::<usize>();
        lists + runs + ground.carriers.bytes()
    }

    /// Energy [F L] that friction has turned into heat.
    pub fn rubbed(&self) -> f64 {
        self.rubbed
    }

    /// State of all nodes that touch faces, once for each surface that they touch, and of those near some; edges that cross have
    /// none of their own.
    pub fn states(&self) -> impl Iterator<Item = PointState> + '_ {
        let carriers = &self.ground.carriers;
        let touching = move |touch: &Touch| {
            let p = touch.point;
            PointState {
                node: carriers.nodes[touch.first as usize],
                opening: p.gap.is_finite().then_some(p.gap),
                pressure: p.pressure,
                shear: p.shear,
                slip: p.slip,
                status: p.status,
                measure: p.measure,
            }
        };
        self.nodes.iter().flat_map(move |run| {
            let scene = self.ground.scene(0.0, Look::Again);
            let open = |(node, gap)| PointState {
                node: carriers.nodes[node as usize],
                opening: Some(gap),
                pressure: 0.0,
                shear: [0.0; 2],
                slip: run.slip(node),
                status: ContactStatus::Open,
                measure: self.ground.surface.nodes[node as usize].area,
            };
            let gaps: Vec<PointState> = run.gaps(&scene).map(open).collect();
            run.touches.iter().map(touching).chain(gaps).collect::<Vec<_>>()
        })
    }
}
