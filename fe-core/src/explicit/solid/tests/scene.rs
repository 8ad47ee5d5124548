//! A block of elements of one type, whose nodes a test moves.

use super::*;
use crate::element::Space;
use fe_mesh::Mesh;

pub const STEEL: Elastic = Elastic { young: 210e3, poisson: 0.3 };
pub const DENSITY: f64 = 7.85e-9;

/// What a scene is made of.
#[derive(Clone)]
pub struct Setup {
    pub element: ElementType,
    pub response: Response,
    pub hourglass: Hourglass,
    /// Of planes.
    pub thickness: f64,
    pub damping: Damping,
}

pub struct Scene {
    pub structure: Structure,
    pub freedoms: Freedoms,
    pub solids: Solids,
    /// Work [F L] that moving the nodes took, by the trapezoidal rule.
    pub work: f64,
    pub u: Vec<f64>,
    pub forces: Vec<f64>,
}

impl Setup {
    pub fn elastic(element: ElementType) -> Self {
        let (hourglass, damping) = (Hourglass::Enhanced(1.0), Damping::default());
        Setup { element, response: Response::Elastic(STEEL), hourglass, thickness: 1.0, damping }
    }

    pub fn plastic(element: ElementType, points: Vec<(f64, f64)>) -> Self {
        let response = Response::Plastic { elastic: STEEL, hardening: Hardening { points } };
        Setup { response, ..Setup::elastic(element) }
    }

    /// A unit block of so many elements along each edge, every point sent through `map`.
    pub fn block(&self, n: usize, map: impl Fn([f64; 3]) -> [f64; 3]) -> Scene {
        self.scene(block(self.element, n, map))
    }

    pub fn scene(&self, mesh: Mesh) -> Scene {
        let cells: Vec<CellId> = mesh.cells().collect();
        let element = self.element;
        let thickness =
            if matches!(element.space(), Space::PlaneStrain | Space::PlaneStress) { self.thickness } else { 1.0 };
        let materials = vec![Material { density: Some(DENSITY), ..Material::elastic("M", STEEL) }];
        let section = Section { element, cells: cells.clone(), material: 0, thickness, hourglass: None };
        let structure =
            Structure { mesh, elements: vec![element], materials, sections: vec![section], ..Structure::default() };
        let freedoms = structure.freedoms(&[]);
        let section = SolidSection {
            element,
            cells: &cells,
            response: &self.response,
            density: DENSITY,
            thickness,
            damping: self.damping,
            hourglass: self.hourglass,
            viscosity: [0.0; 2],
        };
        let solids = Solids::new(&structure, &freedoms, &[section]);
        let (u, forces) = (vec![0.0; freedoms.len()], vec![0.0; freedoms.len()]);
        Scene { structure, freedoms, solids, work: 0.0, u, forces }
    }
}

/// A unit block of so many elements of a type along each edge.
pub fn block(element: ElementType, n: usize, map: impl Fn([f64; 3]) -> [f64; 3]) -> Mesh {
    use fe_mesh::CellKind::*;
    let block = match element.kind() {
        Hex8 => Block::hex8([n; 3]),
        Tet4 => Block::tet4([n; 3]),
        Tet10 => Block::tet10([n; 3]),
        Quad4 => Block::quad4([n; 2]),
        _ => Block::tri3([n; 2]),
    };
    let mut mesh = block.mapped(map);
    if element.kind() == Tet10 {
        straighten(&mut mesh);
    }
    mesh
}

/// Puts the nodes on edges into their middle.
fn straighten(mesh: &mut Mesh) {
    let cells: Vec<Vec<u32>> = mesh.cells().map(|cell| mesh.cell(cell).to_vec()).collect();
    for nodes in cells {
        for (i, [a, b]) in [[0, 1], [1, 2], [2, 0], [0, 3], [1, 3], [2, 3]].into_iter().enumerate() {
            let [a, b] = [a, b].map(|end: usize| Vector3::from(mesh.points[nodes[end] as usize]));
            mesh.points[nodes[4 + i] as usize] = ((a + b) * 0.5).into();
        }
    }
}

impl Scene {
    /// Takes every node in one increment to where `place` says.
    pub fn go(&mut self, dt: f64, place: impl Fn(Vector3<f64>) -> Vector3<f64>) -> Advance {
        let mut v = vec![0.0; self.u.len()];
        let before = self.forces.clone();
        for (node, x) in self.structure.mesh.points.iter().enumerate() {
            let moved = place(Vector3::from(*x)) - Vector3::from(*x);
            for (c, f) in self.freedoms.of_node(node).enumerate() {
                (v[f], self.u[f]) = ((moved[c] - self.u[f]) / dt, moved[c]);
            }
        }
        self.forces.fill(0.0);
        let at = Moving { u: &self.u, v: &v, step_time: 0.0, total_time: 0.0, dt, stable: f64::INFINITY };
        let advance = self.solids.advance(&at, &mut self.forces).unwrap();
        self.work -= (0..v.len()).map(|f| 0.5 * (before[f] + self.forces[f]) * v[f] * dt).sum::<f64>();
        assert!(advance.stable > 0.0);
        advance
    }

    /// Takes every node from where it is at one time to where it is at the next, over and over, from time 0 to 1.
    pub fn follow(&mut self, steps: usize, dt: f64, place: impl Fn(Vector3<f64>, f64) -> Vector3<f64>) {
        for step in 1..=steps {
            self.go(dt, |x| place(x, step as f64 / steps as f64));
        }
    }

    /// What it says of increments from rest.
    pub fn stable(&mut self) -> f64 {
        let zero = vec![0.0; self.u.len()];
        let at = Moving { u: &zero, v: &zero, step_time: 0.0, total_time: 0.0, dt: 0.0, stable: f64::INFINITY };
        self.solids.advance(&at, &mut vec![0.0; self.u.len()]).unwrap().increment()
    }

    /// State of the first element.
    pub fn state(&self) -> PointState {
        self.solids.states().next().unwrap()
    }

    /// Sum of the forces that hold the nodes where `is_there` says so.
    pub fn held(&self, component: usize, is_there: impl Fn([f64; 3]) -> bool) -> f64 {
        let nodes = self.structure.mesh.points.iter().enumerate().filter(|(_, x)| is_there(**x));
        nodes.map(|(n, _)| -self.forces[self.freedoms.index(n, component).unwrap()]).sum()
    }
}

impl Scene {
    /// Freedoms of all nodes in a direction.
    pub fn freedoms_along(&self, component: usize) -> impl Iterator<Item = usize> + '_ {
        (0..self.freedoms.nodes()).filter_map(move |node| self.freedoms.index(node, component))
    }
}

/// The stable increment of small motions about a state: 2/ω of the largest eigenvalue of the stiffness, by differences of the
/// forces.
pub fn exact(scene: impl Fn() -> Scene, place: impl Fn(Vector3<f64>) -> Vector3<f64>) -> f64 {
    let first = scene();
    let n = first.u.len();
    let mut mass = vec![0.0; n];
    first.solids.add_mass(&mut mass);
    let mut stiffness = nalgebra::DMatrix::zeros(n, n);
    let step = 1e-5;
    for f in 0..n {
        let (node, c) = (first.freedoms.node(f), first.freedoms.component(f));
        let moved = Vector3::from(first.structure.mesh.points[node]);
        let [plus, minus] = [1.0, -1.0].map(|sign| {
            let mut scene = scene();
            scene.go(1.0, |x| {
                let mut to = place(x);
                to[c] += if x == moved { sign * step } else { 0.0 };
                to
            });
            scene.forces
        });
        for g in 0..n {
            stiffness[(g, f)] = (minus[g] - plus[g]) / (2.0 * step) / (mass[f] * mass[g]).sqrt();
        }
    }
    let symmetric = (&stiffness + stiffness.transpose()) * 0.5;
    2.0 / symmetric.symmetric_eigenvalues().max().sqrt()
}
