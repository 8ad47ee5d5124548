//! General contact: any exterior face may touch any other one, of its own body too, by penalty or a softened law.
//!
//! A grid of boxes finds what comes near; it is made anew only when the nodes have moved against each other by a margin, and
//! in between what is far from a node sleeps until it may have come near. Nodes and edges are cut into runs of fixed
//! length, which threads share; forces are summed run by run, so that the bits do not depend on the number of threads.

mod definition;
mod edges;
mod features;
mod nodes;
mod overclosure;
mod report;
mod surface;
mod table;
mod touch;

pub use definition::{Acting, Between, GeneralDefinition, GeneralFace, Sides};
pub use overclosure::{Adjusted, adjust};
pub use report::GeneralCount;

use super::carriers::{Carriers, RigidFollower};
use super::penalty::{AHEAD, PENALTY, is_stale};
use crate::facet::Vec3;
use crate::search::{Bounds, Grid};
use edges::{Closed, Edges};
use fe_core::explicit::{Advance, ExplicitTerm, Halt, Moving};
use fe_core::{Freedoms, Structure};
use features::Edge;
use nodes::Nodes;
use rayon::prelude::*;
use surface::{FaceData, Surface};
use table::Table;
use touch::{Look, Scene, Touch};

/// Nodes or edges of a run.
const RUN: usize = 256;

/// Increments, about, for which a search is to hold.
const HOLDS: f64 = 100.0;

/// Least and largest margin of a search over the mean size of the faces [-].
const MARGINS: [f64; 2] = [0.1, 0.5];

/// What does not change while candidates are looked at.
#[derive(Debug)]
struct Ground {
    carriers: Carriers,
    surface: Surface,
    table: Table,
    /// Stiffness [F/L] of hard contact of each node, once the increment is known; infinite where nothing moves it.
    penalties: Vec<f64>,
    /// How far any two places have moved against each other, at most [L].
    travelled: f64,
    /// Of that in the last increment.
    way: f64,
    /// For how long [T] what comes is foreseen, and how far things may move against each other by then [L].
    soon: [f64; 2],
}

impl Ground {
    fn scene(&self, dt: f64, look: Look) -> Scene<'_> {
        let Ground { carriers, surface, table, penalties, travelled, way, soon } = self;
        let [soon, ahead] = *soon;
        let reach = table.reach + ahead;
        let watched = reach + 2.0 * way;
        Scene { surface, carriers, table, penalties, dt, travelled: *travelled, soon, reach, watched, look }
    }
}

/// General contact at work.
#[derive(Debug)]
pub struct GeneralContact {
    name: String,
    ground: Ground,
    nodes: Vec<Nodes>,
    edges: Vec<Edges>,
    /// The increment [T] that springs were made for.
    made_for: Option<f64>,
    /// How far things may move against each other [L] while the last search holds, and where nodes were then.
    holds: f64,
    searched: Vec<Vec3>,
    searches: usize,
    work: f64,
    rubbed: f64,
}

impl GeneralContact {
    /// With all surfaces where they are at the start; `rigid` are the bodies whose nodes may be in the faces.
    pub fn new(
        structure: &Structure,
        freedoms: &Freedoms,
        definition: &GeneralDefinition,
        rigid: &[RigidFollower],
    ) -> Self {
        let nodes: Vec<u32> = definition.faces.iter().flat_map(|face| &face.nodes).copied().collect();
        let carriers = Carriers::new(structure, freedoms, nodes, rigid, &[]);
        let surface = Surface::new(definition, &carriers);
        let table = Table::new(definition, &surface);
        let runs =
            |count: usize| (0..count).step_by(RUN).map(move |first| first as u32..(first + RUN).min(count) as u32);
        GeneralContact {
            name: definition.name.clone(),
            nodes: runs(surface.nodes.len()).map(Nodes::new).collect(),
            edges: runs(surface.edges.len()).map(Edges::new).collect(),
            ground: Ground {
                carriers,
                surface,
                table,
                penalties: Vec::new(),
                travelled: 0.0,
                way: 0.0,
                soon: [0.0; 2],
            },
            made_for: None,
            holds: 0.0,
            searched: Vec::new(),
            searches: 0,
            work: 0.0,
            rubbed: 0.0,
        }
    }

    /// Stiffness of hard contact of each node, for an increment [T] of the elements.
    fn stiffen(&mut self, increment: f64) {
        let of = |&inverse: &f64| {
            if inverse > 0.0 { PENALTY / (inverse * increment * increment) } else { f64::INFINITY }
        };
        self.ground.penalties = self.ground.carriers.inverse_mass.iter().map(of).collect();
        self.made_for = Some(increment);
    }

    /// Counts how far things move against each other in an increment, and foresees how far they will in the next ones: at most by
    /// the diagonal of the box of all velocities.
    fn travel(&mut self, at: &Moving) {
        let speed = Bounds::around(&self.ground.carriers.v, 0.0).diagonal();
        // Bodies that turn go a little farther than their velocity says.
        self.ground.way = 1.01 * speed * at.dt;
        self.ground.travelled += self.ground.way;
        if self.ground.table.may_be_stiff {
            let soon = AHEAD * at.stable;
            self.ground.soon = [soon, speed * soon];
        }
    }

    /// Finds what comes near, where the last search holds no more.
    fn search(&mut self, dt: f64) -> Look {
        let carriers = &self.ground.carriers;
        let moved = carriers.x.iter().zip(&self.searched).map(|(x, searched)| x - searched);
        if self.searches > 0 && Bounds::around_all(moved).diagonal() < self.holds {
            return Look::Again;
        }
        let look = if self.searches == 0 { Look::First } else { Look::Anew };
        self.searches += 1;
        let Surface { faces, edges, size, .. } = &self.ground.surface;
        let [least, most] = MARGINS.map(|part| part * size);
        let margin = if dt > 0.0 { (HOLDS * self.ground.way).clamp(least, most) } else { most };
        self.holds = margin;
        self.searched.clone_from(&carriers.x);
        let deepest = self.touches().filter(|touch| touch.is_closed()).map(|t| -t.point.gap).fold(0.0, f64::max);
        let reach = margin + self.ground.table.reach.max(deepest);
        let x = &self.ground.carriers.x;
        let of_face = |face: &FaceData| Bounds::around(&face.corners.map(|i| x[i as usize]), reach);
        let of_edge = |edge: &Edge| Bounds::around(&edge.nodes.map(|i| x[i as usize]), reach);
        let near_faces = Grid::new(faces.iter().map(of_face).collect());
        let near_edges = Grid::new(edges.iter().map(of_edge).collect());
        let face_normals = self.ground.surface.face_normals(x);
        let normals = [&face_normals[..], &self.ground.surface.node_normals(x, &face_normals)];
        let scene = self.ground.scene(dt, look);
        self.nodes.par_iter_mut().for_each(|run| run.search(&scene, &near_faces, normals));
        self.edges.par_iter_mut().for_each(|run| run.search(&scene, &near_edges));
        look
    }

    /// All touches, those of nodes first.
    fn touches(&self) -> impl Iterator<Item = &Touch> {
        let of_nodes = self.nodes.iter().flat_map(|run| &run.touches);
        of_nodes.chain(self.edges.iter().flat_map(|run| &run.touches))
    }

    /// Looks at all candidates at the end of an increment.
    fn meet(&mut self, dt: f64, look: Look) {
        let edges = self.edges.iter().flat_map(|run| &run.touches).filter(|touch| touch.is_closed());
        let crossing = edges.map(|touch| ([touch.first, touch.second], touch.point.gap.abs())).collect();
        let scene = self.ground.scene(dt, look);
        self.nodes.par_iter_mut().for_each(|run| run.advance(&scene));
        let of_nodes = self.nodes.iter().flat_map(|run| &run.touches).filter(|touch| touch.is_closed());
        let component = |touch: &Touch| (touch.first, self.ground.surface.faces[touch.second as usize].component);
        let closed = Closed { crossing, nodes: of_nodes.map(component).collect() };
        self.edges.par_iter_mut().for_each(|run| run.advance(&scene, &closed));
    }

    /// Sums what all touches do, in their order.
    fn sum(&mut self) {
        let carriers = &mut self.ground.carriers;
        let of_nodes = self.nodes.iter().flat_map(|run| &run.touches);
        for touch in of_nodes.chain(self.edges.iter().flat_map(|run| &run.touches)) {
            self.work += touch.work;
            self.rubbed += touch.rubbed;
            if touch.rates != [0.0; 2] {
                carriers.stiffen(&touch.row, touch.rates);
            }
            if touch.is_closed() {
                touch.row.iter().for_each(|&(node, d)| carriers.force[node as usize] += touch.point.force * d);
            }
        }
    }
}

impl ExplicitTerm for GeneralContact {
    fn name(&self) -> &str {
        &self.name
    }

    fn weigh(&mut self, mass: &[f64]) {
        if self.ground.carriers.weigh(mass) {
            self.made_for = None;
        }
    }

    fn advance(&mut self, at: &Moving, forces: &mut [f64]) -> Result<Advance, Halt> {
        if is_stale(self.made_for, at) {
            self.stiffen(at.stable);
        }
        self.ground.carriers.update(at.u, at.v);
        self.travel(at);
        let look = self.search(at.dt);
        self.meet(at.dt, look);
        self.sum();
        self.ground.carriers.scatter(forces);
        let [rate, damping] = self.ground.carriers.rates();
        Ok(Advance { rate, damping, ..Advance::default() })
    }

    fn stored(&self) -> f64 {
        self.work
    }
}
