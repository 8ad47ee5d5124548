//! The nodes of surfaces, and what moves them: their own freedoms, or a rigid body.

use crate::facet::Vec3;
use fe_core::{Freedoms, Structure};
use nalgebra::Rotation3;

/// How many times the stiffness of contact counts in ω² [-]. A spring that is met or left inside an increment takes or gives
/// up to (ωΔt)²/8 m v²; where nodes do so from increment to increment at the limit itself, 4, that grows without end. (Two bars
/// of cubes that hit each other on springs 10 and 100 times as stiff as the cubes: 11 and 24 % of the energy within half of the
/// contact at ω²Δt² = 4, 0.1 % after all of it at 2.)
const SWITCHING: f64 = 2.0;

/// A rigid body as its followers see it: a reference node with three translations and three rotations (in the plane two and
/// one). Its rotation freedoms hold the rotation vector.
#[derive(Clone, Debug, PartialEq)]
pub struct RigidFollower {
    /// Reference node.
    pub reference: u32,
    /// The nodes that follow it, ascending.
    pub nodes: Vec<u32>,
}

impl RigidFollower {
    /// Displacement [L] and velocity [L/T] of one of its nodes at those of all freedoms.
    pub fn carried(&self, node: u32, (structure, freedoms): (&Structure, &Freedoms), at: [&[f64]; 2]) -> [[f64; 3]; 2] {
        let mut body = Body::new(structure, freedoms, self.reference);
        body.update(at[0], at[1]);
        let start = Vec3::from(structure.mesh.points[node as usize]);
        let now = body.place_of(&start);
        [(now - start).into(), body.velocity_at(&now).into()]
    }
}

/// A rigid body in motion.
#[derive(Clone, Debug)]
pub(super) struct Body {
    pub reference: u32,
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
    /// 1/m [1/M], and 1 over the least moment of inertia [1/(M L²)]; 0 where there is none.
    inverse: [f64; 2],
    /// Sums of stiffness and of viscosity over mass of the increment [1/T², 1/T].
    rates: [f64; 2],
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
            inverse: [0.0; 2],
            rates: [0.0; 2],
        }
    }

    fn update(&mut self, u: &[f64], v: &[f64]) {
        let of = |v: &[f64], first: usize| Vec3::from_fn(|c, _| self.freedoms[first + c].map_or(0.0, |f| v[f]));
        let (shift, turn) = (of(u, 0), of(u, 3));
        (self.velocity, self.spin) = (of(v, 0), of(v, 3));
        (self.place, self.rotation) = (self.start + shift, Rotation3::new(turn));
        (self.force, self.moment, self.rates) = (Vec3::zeros(), Vec3::zeros(), [0.0; 2]);
    }

    /// Where a point of it is now that was at `x` at the start, in the coordinates of the start.
    pub fn seen(&self, x: &Vec3) -> Vec3 {
        self.start + self.rotation.inverse() * (x - self.place)
    }

    /// Where a point of it is now [L] that was at `x` at the start.
    pub fn place_of(&self, x: &Vec3) -> Vec3 {
        self.place + self.rotation * (x - self.start)
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

    /// Takes its masses from those of all freedoms.
    fn weigh(&mut self, mass: &[f64]) {
        let least = |freedoms: &[Option<usize>]| {
            let own = freedoms.iter().flatten().map(|&f| mass[f]).filter(|m| *m > 0.0);
            own.reduce(f64::min).map_or(0.0, f64::recip)
        };
        self.inverse = [least(&self.freedoms[..3]), least(&self.freedoms[3..])];
    }

    /// Most that a push at a point moves it there [1/M], 1/m + r²/J with the least moment of inertia; 0 where it has no mass: as
    /// far as contact is concerned, it is there without end.
    pub fn inverse_mass_at(&self, x: &Vec3) -> f64 {
        self.inverse[0] + self.inverse[1] * (x - self.place).norm_squared()
    }

    /// A part of a stiffness [F/L] and of a viscosity [F T/L] at a point.
    pub fn stiffen(&mut self, x: &Vec3, values: [f64; 2]) {
        let inverse = self.inverse_mass_at(x);
        (0..2).for_each(|k| self.rates[k] += inverse * values[k]);
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
    /// 1 over the masses [1/M] that the nodes have for a push, at the start; 0 of rigid bodies without one.
    pub inverse_mass: Vec<f64>,
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
            inverse_mass: vec![0.0; count],
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

    /// Takes the masses from those of all freedoms; true where one has changed.
    pub fn weigh(&mut self, mass: &[f64]) -> bool {
        self.bodies.iter_mut().for_each(|body| body.weigh(mass));
        let mut has_changed = false;
        for i in 0..self.nodes.len() {
            let inverse = match self.carriers[i] {
                Carrier::Free(first, _) if mass[first] > 0.0 => 1.0 / mass[first],
                Carrier::Free(..) => 0.0,
                // The arm stays as the body turns.
                Carrier::Rigid(body) => {
                    let body = &self.bodies[body];
                    body.inverse[0] + body.inverse[1] * (self.start[i] - body.start).norm_squared()
                }
            };
            has_changed |= inverse != self.inverse_mass[i];
            self.inverse_mass[i] = inverse;
        }
        has_changed
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
                    self.x[i] = body.place_of(&self.start[i]);
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
        let inverse: f64 = row.iter().map(|&(node, d)| d * d * self.inverse_mass[node as usize]).sum();
        if inverse > 0.0 { 1.0 / inverse } else { 0.0 }
    }

    /// The same of a node and the first body, whose surface it meets.
    pub fn mass_on_surface(&self, node: u32) -> f64 {
        let inverse = self.inverse_mass[node as usize] + self.bodies[0].inverse_mass_at(&self.x[node as usize]);
        if inverse > 0.0 { 1.0 / inverse } else { 0.0 }
    }

    /// A stiffness and a viscosity of a distance that moves by so much with each node: adds |d_i| Σ |d_j| times them to the rows.
    pub fn stiffen(&mut self, row: &[(u32, f64)], values: [f64; 2]) {
        let moves = |entry: &&(u32, f64)| self.inverse_mass[entry.0 as usize] > 0.0;
        let all: f64 = row.iter().filter(moves).map(|entry| entry.1.abs()).sum();
        for &(i, d) in row {
            let values = values.map(|value| d.abs() * all * value);
            match self.carriers[i as usize] {
                Carrier::Free(..) => (0..2).for_each(|k| self.sums[i as usize][k] += values[k]),
                Carrier::Rigid(body) => self.bodies[body].stiffen(&self.x[i as usize], values),
            }
        }
    }

    /// The same of a node and the first body, whose surface it meets.
    pub fn stiffen_on_surface(&mut self, node: u32, values: [f64; 2]) {
        let (x, own) = (self.x[node as usize], self.inverse_mass[node as usize] > 0.0);
        let body = &mut self.bodies[0];
        let both = own && body.inverse_mass_at(&x) > 0.0;
        let values = if both { values.map(|value| 2.0 * value) } else { values };
        body.stiffen(&x, values);
        self.stiffen(&[(node, 1.0)], values);
    }

    /// Largest row sums over mass [1/T², 1/T], those of the stiffness [`SWITCHING`] times.
    pub fn rates(&self) -> [f64; 2] {
        let nodes = self.sums.iter().zip(&self.inverse_mass).map(|(sums, inverse)| sums.map(|sum| sum * inverse));
        let all = nodes.chain(self.bodies.iter().map(|body| body.rates));
        let [stiffness, damping] = all.fold([0.0; 2], |most: [f64; 2], r| [most[0].max(r[0]), most[1].max(r[1])]);
        [SWITCHING * stiffness, damping]
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
