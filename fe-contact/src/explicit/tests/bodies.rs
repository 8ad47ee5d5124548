//! Bodies in motion under contact.

use super::*;
use crate::explicit::general::{Acting, Between, GeneralContact, GeneralDefinition, GeneralFace, Sides};
use crate::facet::Facet;
use fe_core::element::ElementType::C3D8R;
use fe_core::explicit::solid::{Hourglass, SolidSection, Solids};
use fe_core::material::{Damping, Elastic, Response};
use fe_mesh::generate::Block;
use fe_mesh::{Face, Mesh, exterior};

/// Bodies of C3D8R, one block of cells, with the first point of each; rigid facets may be the last thing.
pub struct Bodies {
    pub structure: Structure,
    pub first: Vec<u32>,
    pub rigid: Vec<RigidFollower>,
    sheets: Vec<Vec<u32>>,
}

impl Bodies {
    pub fn new(meshes: &[Mesh]) -> Self {
        let (mut mesh, mut first) = (Mesh::default(), Vec::new());
        for body in meshes {
            first.push(mesh.points.len() as u32);
            mesh.append(body);
        }
        let structure = Structure { mesh, elements: vec![C3D8R], ..Structure::default() };
        Bodies { structure, first, rigid: Vec::new(), sheets: Vec::new() }
    }

    /// With a facet of these corners that a reference node holds.
    pub fn on_facet(self, corners: [[f64; 3]; 4]) -> Self {
        self.on_sheet(&corners, &[&[0, 1, 2, 3]])
    }

    /// With facets between such points that a reference node holds.
    pub fn on_sheet(mut self, points: &[[f64; 3]], facets: &[&[u32]]) -> Self {
        let mesh = &mut self.structure.mesh;
        let first = mesh.points.len() as u32;
        mesh.points.extend(points);
        let reference = mesh.points.len() as u32;
        mesh.points.push([0.0, 0.0, -9.0]);
        mesh.point_labels = (1..=mesh.points.len() as u64).collect();
        self.sheets.extend(facets.iter().map(|nodes| nodes.iter().map(|node| first + node).collect::<Vec<u32>>()));
        self.rigid.push(RigidFollower { reference, nodes: (first..reference).collect() });
        self
    }

    pub fn body_of(&self, node: u32) -> usize {
        self.first.partition_point(|first| *first <= node) - 1
    }

    /// All outer faces, of a class of its own for each body, and the rigid facets.
    pub fn faces(&self) -> Vec<GeneralFace> {
        let mesh = &self.structure.mesh;
        let of = |face: Face| {
            let facet = Facet::new(&self.structure, face, None, &Vec3::zeros());
            let nodes = facet.nodes().to_vec();
            GeneralFace { class: self.body_of(nodes[0]) as u16, nodes, sides: Sides::Outer }
        };
        let mut faces: Vec<GeneralFace> = exterior(mesh).into_iter().map(of).collect();
        let class = self.first.len() as u16;
        let facet = |nodes: &Vec<u32>| GeneralFace { nodes: nodes.clone(), sides: Sides::Both, class };
        faces.extend(self.sheets.iter().map(facet));
        faces
    }

    /// Everything may touch everything, but for pairs of classes left out.
    pub fn definition(&self, behaviour: Behaviour, without: &[[usize; 2]]) -> GeneralDefinition {
        let classes = self.first.len() + 1;
        let acts = |one: usize, other: usize| {
            let out = without.contains(&[one, other]) || without.contains(&[other, one]);
            if out { Between::Excluded } else { Between::Acting(Acting { behaviour: 0, scale: 0 }) }
        };
        GeneralDefinition {
            name: "general contact".into(),
            faces: self.faces(),
            table: (0..classes).map(|one| (0..classes).map(|other| acts(one, other)).collect()).collect(),
            behaviours: vec![behaviour],
            scales: vec![1.0],
        }
    }
}

/// Contact with bodies in motion.
pub struct Motion<C> {
    pub freedoms: Freedoms,
    pub solids: Solids,
    pub contacts: Vec<C>,
    pub state: State,
    pub procedure: CentralDifference,
}

pub const DENSITY: f64 = 1.0;

impl<C: ExplicitTerm> Motion<C> {
    /// Bodies, each point with the velocity that it has.
    pub fn new(bodies: &Bodies, make: impl Fn(&Freedoms) -> Vec<C>, velocity: impl Fn(u32, Vec3) -> Vec3) -> Self {
        let structure = &bodies.structure;
        let references: Vec<u32> = bodies.rigid.iter().map(|body| body.reference).collect();
        let freedoms = structure.freedoms(&references);
        let cells: Vec<CellId> = structure.mesh.cells().filter(|cell| cell.block == 0).collect();
        let section = SolidSection {
            element: C3D8R,
            cells: &cells,
            response: &Response::Elastic(Elastic { young: 1000.0, poisson: 0.25 }),
            density: DENSITY,
            thickness: 1.0,
            damping: Damping::default(),
            hourglass: Hourglass::Enhanced(1.0),
            viscosity: [0.06, 1.2],
        };
        let mut solids = Solids::new(structure, &freedoms, &[section]);
        let mut state = State::rest(&freedoms);
        let held = references.iter().flat_map(|&node| freedoms.of_node(node as usize));
        let hold = |freedom| Support { freedom, kind: Prescribed::Displacement, course: Ramp::constant(0.0) };
        let supports: Vec<Support> = held.map(hold).collect();
        for (node, x) in structure.mesh.points.iter().enumerate() {
            let v = velocity(node as u32, Vec3::from(*x));
            let own = freedoms.of_node(node).take(3).filter(|_| !references.contains(&(node as u32)));
            own.enumerate().for_each(|(c, freedom)| state.v[freedom] = v[c]);
        }
        let mut contacts = make(&freedoms);
        let procedure = {
            let mut terms: Vec<&mut dyn ExplicitTerm> = vec![&mut solids];
            terms.extend(contacts.iter_mut().map(|contact| contact as &mut dyn ExplicitTerm));
            CentralDifference::new(&mut terms, supports, (1e9, f64::INFINITY), &mut state).unwrap()
        };
        Motion { freedoms, solids, contacts, state, procedure }
    }

    pub fn advance(&mut self, dt: f64) {
        let mut terms: Vec<&mut dyn ExplicitTerm> = vec![&mut self.solids];
        terms.extend(self.contacts.iter_mut().map(|contact| contact as &mut dyn ExplicitTerm));
        self.procedure.advance(&mut terms, &mut self.state, dt).unwrap();
    }

    pub fn x(&self, bodies: &Bodies, node: u32) -> Vec3 {
        let place = self.freedoms.of_node(node as usize);
        let u = |c: usize| if c < place.len() { self.state.u[place.start + c] } else { 0.0 };
        Vec3::from(bodies.structure.mesh.points[node as usize]) + Vec3::new(u(0), u(1), u(2))
    }

    /// Momentum of a body, from the velocities at the end of the increment and equal shares of its elements.
    pub fn momentum(&self, bodies: &Bodies, body: usize) -> Vec3 {
        let mut mass = vec![0.0; self.state.u.len()];
        self.solids.add_mass(&mut mass);
        let v = self.procedure.velocity(&self.state);
        let nodes = (0..bodies.structure.mesh.points.len() as u32).filter(|&n| bodies.body_of(n) == body);
        nodes
            .map(|node| {
                let place = self.freedoms.of_node(node as usize);
                Vec3::from_fn(|c, _| if c < place.len() { mass[place.start + c] * v[place.start + c] } else { 0.0 })
            })
            .sum()
    }

    pub fn energy(&self) -> f64 {
        let contacts: f64 = self.contacts.iter().map(|contact| contact.stored()).sum();
        self.procedure.conserved(&self.state) + self.solids.stored() + contacts
    }
}

pub fn cube(divisions: usize, origin: [f64; 3]) -> Mesh {
    Block::hex8([divisions; 3]).origin(origin).mesh()
}

pub fn general<'b>(
    bodies: &'b Bodies,
    definition: GeneralDefinition,
) -> impl Fn(&Freedoms) -> Vec<GeneralContact> + 'b {
    move |freedoms| vec![GeneralContact::new(&bodies.structure, freedoms, &definition, &bodies.rigid)]
}
