//! The nodes of surfaces, and what moves them: their own freedoms, or a rigid body.

use crate::facet::Vec3;
use fe_core::{Freedoms, Structure};
use nalgebra::Rotation3;

/// A rigid body as its followers see it: a reference node with three translations and three rotations (in the plane two and
/// one). Its rotation freedoms hold the rotation vector.
#[derive(Clone, Debug, PartialEq)]
pub struct RigidFollower {
    /// Reference node.
    pub reference: u32,
    /// The nodes that follow it, ascending.
    pub nodes: Vec<u32>,
}

/// A rigid body in motion.
#[derive(Clone, Debug)]
pub(super) struct Body {
    reference: u32,
    /// The reference node at the start [L].
    start: Vec3,
    freedoms: [Option<usize>; 6],
    /// The reference node now [L], its velocity, the rotation and the angular velocity.
    pub place: Vec3,
    velocity: Vec3,
    pub rotation: Rotation3<f64>,
    spin: Vec3,
    /// Force [F] and moment about the reference node [F L] of the increment.
    force: Vec3,
    moment: Vec3,
}

impl Body {
    pub fn new(structure: &Structure, freedoms: &Freedoms, reference: u32) -> Self {
        let node = reference as usize;
        let start = Vec3::from(structure.mesh.points[node]);
        Body {
            reference,
            start,
            freedoms: std::array::from_fn(|c| freedoms.index(node, c)),
            place: start,
            velocity: Vec3::zeros(),
            rotation: Rotation3::identity(),
            spin: Vec3::zeros(),
            force: Vec3::zeros(),
            moment: Vec3::zeros(),
        }
    }

    fn update(&mut self, u: &[f64], v: &[f64]) {
        let of = |v: &[f64], first: usize| Vec3::from_fn(|c, _| self.freedoms[first + c].map_or(0.0, |f| v[f]));
        let (shift, turn) = (of(u, 0), of(u, 3));
        (self.velocity, self.spin) = (of(v, 0), of(v, 3));
        (self.place, self.rotation) = (self.start + shift, Rotation3::new(turn));
        (self.force, self.moment) = (Vec3::zeros(), Vec3::zeros());
    }

    /// Where a point of it is now that was at `x` at the start, in the coordinates of the start.
    pub fn seen(&self, x: &Vec3) -> Vec3 {
        self.start + self.rotation.inverse() * (x - self.place)
    }

    /// Velocity of a point of it.
    pub fn velocity_at(&self, x: &Vec3) -> Vec3 {
        self.velocity + self.spin.cross(&(x - self.place))
    }

    /// Adds a force at a point.
    pub fn push(&mut self, force: &Vec3, at: &Vec3) {
        self.force += force;
        self.moment += (at - self.place).cross(force);
    }

    /// How far a point of it moves along a direction as its freedoms move: freedoms with their coefficients.
    pub fn row(&self, direction: &Vec3, at: &Vec3, out: &mut Vec<(usize, f64)>) {
        let arm = (at - self.place).cross(direction);
        let coefficients = direction.iter().chain(arm.iter()).copied();
        out.extend(self.freedoms.iter().zip(coefficients).filter_map(|(f, d)| f.map(|f| (f, d))));
    }

    fn scatter(&self, forces: &mut [f64]) {
        for c in 0..3 {
            for (freedom, value) in [(self.freedoms[c], self.force[c]), (self.freedoms[c + 3], self.moment[c])] {
                if let Some(freedom) = freedom {
                    forces[freedom] += value;
                }
            }
        }
    }

    /// Mass that stands behind a push; 0 where the body is held, or has none: as far as contact is concerned, it is there
    /// without end.
    fn mass(&self, mass: &[f64]) -> f64 {
        self.freedoms[0].map_or(0.0, |f| mass[f])
    }
}

#[derive(Clone, Copy, Debug)]
enum Carrier {
    /// The first of its own translations, and how many there are.
    Free(usize, usize),
    /// A rigid body.
    Rigid(usize),
}

/// The nodes of both sides of a pair.
#[derive(Clone, Debug)]
pub(super) struct Carriers {
    /// Nodes, ascending.
    pub nodes: Vec<u32>,
    start: Vec<Vec3>,
    carriers: Vec<Carrier>,
    pub bodies: Vec<Body>,
    /// Where they are [L].
    pub x: Vec<Vec3>,
    /// Velocities [L/T] in the middle of the increment.
    pub v: Vec<Vec3>,
    /// Forces [F] of the increment.
    pub force: Vec<Vec3>,
    /// Masses [M]; 0 of rigid bodies without one.
    pub mass: Vec<f64>,
    /// Row sums of stiffness [F/L] and of viscosity [F T/L] of the increment.
    sums: Vec<[f64; 2]>,
}

impl Carriers {
    pub fn new(
        structure: &Structure,
        freedoms: &Freedoms,
        mut nodes: Vec<u32>,
        rigid: &[RigidFollower],
        references: &[u32],
    ) -> Self {
        nodes.sort_unstable();
        nodes.dedup();
        let mut bodies: Vec<Body> = references.iter().map(|&r| Body::new(structure, freedoms, r)).collect();
        let mut carriers = Vec::with_capacity(nodes.len());
        for &node in &nodes {
            let body = rigid.iter().find(|body| body.nodes.binary_search(&node).is_ok());
            carriers.push(match body {
                Some(body) => {
                    Carrier::Rigid(bodies.iter().position(|b| b.reference == body.reference).unwrap_or_else(|| {
                        bodies.push(Body::new(structure, freedoms, body.reference));
                        bodies.len() - 1
                    }))
                }
                None => {
                    let place = freedoms.of_node(node as usize);
                    Carrier::Free(place.start, place.len().min(structure.dimension()))
                }
            });
        }
        let start: Vec<Vec3> = nodes.iter().map(|&n| Vec3::from(structure.mesh.points[n as usize])).collect();
        let count = nodes.len();
        let zero = || vec![Vec3::zeros(); count];
        Carriers {
            x: start.clone(),
            start,
            nodes,
            carriers,
            bodies,
            v: zero(),
            force: zero(),
            mass: vec![0.0; count],
            sums: vec![[0.0; 2]; count],
        }
    }

    /// Where a node stands in the lists.
    pub fn index(&self, node: u32) -> usize {
        self.nodes.binary_search(&node).expect("a node of the surfaces")
    }

    /// Bytes of the lists.
    pub fn bytes(&self) -> usize {
        let each = size_of::<u32>() + size_of::<Carrier>() + 4 * size_of::<Vec3>() + size_of::<[f64; 3]>();
        self.nodes.len() * each
    }

    /// The rigid body that moves a node, by its place in `bodies`.
    pub fn body_of(&self, node: u32) -> Option<u32> {
        match self.carriers[node as usize] {
            Carrier::Free(..) => None,
            Carrier::Rigid(body) => Some(body as u32),
        }
    }

    pub fn weigh(&mut self, mass: &[f64]) {
        for (own, carrier) in self.mass.iter_mut().zip(&self.carriers) {
            *own = match *carrier {
                Carrier::Free(first, _) => mass[first],
                Carrier::Rigid(body) => self.bodies[body].mass(mass),
            };
        }
    }

    pub fn update(&mut self, u: &[f64], v: &[f64]) {
        self.bodies.iter_mut().for_each(|body| body.update(u, v));
        for i in 0..self.nodes.len() {
            match self.carriers[i] {
                Carrier::Free(first, directions) => {
                    for c in 0..directions {
                        self.x[i][c] = self.start[i][c] + u[first + c];
                        self.v[i][c] = v[first + c];
                    }
                }
                Carrier::Rigid(body) => {
                    let body = &self.bodies[body];
                    self.x[i] = body.place + body.rotation * (self.start[i] - body.start);
                    self.v[i] = body.velocity_at(&self.x[i]);
                }
            }
        }
        self.force.fill(Vec3::zeros());
        self.sums.fill([0.0; 2]);
    }

    /// How far a node moves along a direction as freedoms move.
    pub fn row(&self, node: u32, direction: &Vec3, out: &mut Vec<(usize, f64)>) {
        match self.carriers[node as usize] {
            Carrier::Free(first, directions) => out.extend((0..directions).map(|c| (first + c, direction[c]))),
            Carrier::Rigid(body) => self.bodies[body].row(direction, &self.x[node as usize], out),
        }
    }

    /// Mass [M] that nodes have against each other whose distance moves by so much with each: 1/m = Σ d²/m_i; nodes without a
    /// mass count as held.
    pub fn mass_of(&self, row: &[(u32, f64)]) -> f64 {
        let each = |&(node, d): &(u32, f64)| (d, self.mass[node as usize]);
        let inverse: f64 = row.iter().map(each).filter(|(d, m)| *d != 0.0 && *m > 0.0).map(|(d, m)| d * d / m).sum();
        if inverse > 0.0 { 1.0 / inverse } else { 0.0 }
    }

    /// A stiffness and a viscosity of a distance that moves by so much with each node: adds |d_i| Σ |d_j| times them to the rows.
    pub fn stiffen(&mut self, row: &[(u32, f64)], values: [f64; 2]) {
        let moves = |entry: &&(u32, f64)| self.mass[entry.0 as usize] > 0.0;
        let all: f64 = row.iter().filter(moves).map(|entry| entry.1.abs()).sum();
        for &(i, d) in row {
            (0..2).for_each(|k| self.sums[i as usize][k] += d.abs() * all * values[k]);
        }
    }

    /// Largest row sums over mass [1/T², 1/T].
    pub fn rates(&self) -> [f64; 2] {
        let mut rates = [0.0f64; 2];
        for (sums, mass) in self.sums.iter().zip(&self.mass).filter(|(_, mass)| **mass > 0.0) {
            (0..2).for_each(|k| rates[k] = rates[k].max(sums[k] / mass));
        }
        rates
    }

    pub fn scatter(&mut self, forces: &mut [f64]) {
        for i in 0..self.nodes.len() {
            let force = self.force[i];
            match self.carriers[i] {
                Carrier::Free(first, directions) => (0..directions).for_each(|c| forces[first + c] += force[c]),
                Carrier::Rigid(body) => {
                    let x = self.x[i];
                    self.bodies[body].push(&force, &x);
                }
            }
        }
        self.bodies.iter().for_each(|body| body.scatter(forces));
    }
}
