//! One face of an element as contact sees it: positions, normals, and what the surface counts for.

use fe_core::Structure;
use fe_core::element::Space;
use fe_mesh::quadrature::Rule;
use fe_mesh::{CellKind, Face, shape};
use nalgebra::{Matrix3, Vector3};

/// A point or direction in space.
pub type Vec3 = Vector3<f64>;

/// Most nodes a facet has.
pub const MOST: usize = 8;

/// What an area element of the facet counts for.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Depth {
    /// Itself.
    Solid,
    /// Its length times a thickness [L].
    Plane(f64),
    /// Its length times 2πr, r = x.
    Axisymmetric,
}

/// A face with the coordinates of its nodes. An edge of a plane model is a strip of unit depth: its second
/// coordinate is z, its outward normal t × e_z.
#[derive(Clone, Debug)]
pub struct Facet {
    /// The face.
    pub face: Face,
    /// Shape.
    pub kind: CellKind,
    /// What its area counts for.
    pub depth: Depth,
    nodes: [u32; MOST],
    points: [Vec3; MOST],
    /// Unit normal at the centre, out of the body.
    pub normal: Vec3,
    /// Area [L²] in the flat, of the polygon of its corners; length [L] of an edge.
    pub area: f64,
    /// True when positions are affine in the local coordinates.
    pub affine: bool,
}

/// A polygon of a facet: a triangle or quadrilateral between points with these local coordinates.
#[derive(Clone, Copy, Debug)]
pub struct Patch {
    corners: [[f64; 2]; 4],
    count: usize,
}

impl Patch {
    /// Local coordinates of its corners.
    pub fn corners(&self) -> &[[f64; 2]] {
        &self.corners[..self.count]
    }
}

const fn triangle(a: [f64; 2], b: [f64; 2], c: [f64; 2]) -> Patch {
    Patch { corners: [a, b, c, c], count: 3 }
}

const WHOLE: [Patch; 1] = [triangle([0.0, 0.0], [1.0, 0.0], [0.0, 1.0])];
const SQUARE: [Patch; 1] = [Patch { corners: [[-1.0, -1.0], [1.0, -1.0], [1.0, 1.0], [-1.0, 1.0]], count: 4 }];
const STRIP: [Patch; 1] = [Patch { corners: [[-1.0, -0.5], [1.0, -0.5], [1.0, 0.5], [-1.0, 0.5]], count: 4 }];
const HALF_STRIPS: [Patch; 2] = [
    Patch { corners: [[-1.0, -0.5], [0.0, -0.5], [0.0, 0.5], [-1.0, 0.5]], count: 4 },
    Patch { corners: [[0.0, -0.5], [1.0, -0.5], [1.0, 0.5], [0.0, 0.5]], count: 4 },
];
const QUARTERS: [Patch; 4] = [
    triangle([0.0, 0.0], [0.5, 0.0], [0.0, 0.5]),
    triangle([0.5, 0.0], [1.0, 0.0], [0.5, 0.5]),
    triangle([0.0, 0.5], [0.5, 0.5], [0.0, 1.0]),
    triangle([0.5, 0.5], [0.0, 0.5], [0.5, 0.0]),
];

impl Facet {
    /// A face of a structure, its coordinates taken from `origin`; `thickness` [L] replaces that of the section in
    /// plane models.
    pub fn new(structure: &Structure, face: Face, thickness: Option<f64>, origin: &Vec3) -> Self {
        let (kind, list) = structure.mesh.face(face);
        let depth = match structure.elements[face.cell.block as usize].space() {
            Space::Solid | Space::Any => Depth::Solid,
            Space::Axisymmetric => Depth::Axisymmetric,
            Space::PlaneStrain | Space::PlaneStress | Space::Plane => {
                Depth::Plane(thickness.or_else(|| structure.section_of(face.cell).map(|s| s.thickness)).unwrap_or(1.0))
            }
        };
        let (mut nodes, mut points) = ([0; MOST], [Vec3::zeros(); MOST]);
        for (i, &n) in list.iter().enumerate() {
            nodes[i] = n;
            points[i] = Vec3::from(structure.mesh.points[n as usize]) - origin;
        }
        let mut facet = Facet { face, kind, depth, nodes, points, normal: Vec3::zeros(), area: 0.0, affine: true };
        let scale = (points[0] - points[1]).norm();
        facet.affine = facet.is_affine(1e-13 * scale);
        let p = |i: usize| points[i];
        let vector = match facet.corners() {
            2 => (p(1) - p(0)).cross(&Vec3::z()),
            3 => (p(1) - p(0)).cross(&(p(2) - p(0))) * 0.5,
            _ => (p(2) - p(0)).cross(&(p(3) - p(1))) * 0.5,
        };
        facet.area = vector.norm();
        facet.normal = vector.try_normalize(0.0).unwrap_or_else(Vec3::zeros);
        facet
    }

    fn is_affine(&self, tolerance: f64) -> bool {
        use CellKind::*;
        let p = &self.points;
        let middle = |m: usize, a: usize, b: usize| ((p[a] + p[b]) * 0.5 - p[m]).norm() <= tolerance;
        match self.kind {
            Line2 | Tri3 => true,
            Line3 => middle(2, 0, 1),
            Tri6 => middle(3, 0, 1) && middle(4, 1, 2) && middle(5, 2, 0),
            Quad4 => (p[0] - p[1] + p[2] - p[3]).norm() <= tolerance,
            _ => false,
        }
    }

    /// True for an edge of a plane or axisymmetric model.
    pub fn is_edge(&self) -> bool {
        self.kind.dimension() == 1
    }

    /// Nodes, corners first.
    pub fn nodes(&self) -> &[u32] {
        &self.nodes[..self.kind.nodes()]
    }

    /// Coordinates of the nodes.
    pub fn points(&self) -> &[Vec3] {
        &self.points[..self.kind.nodes()]
    }

    /// Number of corners: the nodes that carry constraints.
    pub fn corners(&self) -> usize {
        self.corner_kind().nodes()
    }

    fn corner_kind(&self) -> CellKind {
        use CellKind::*;
        match self.kind {
            Line2 | Line3 => Line2,
            Tri3 | Tri6 => Tri3,
            _ => Quad4,
        }
    }

    /// True when every node is a corner.
    pub fn is_linear(&self) -> bool {
        self.corners() == self.kind.nodes()
    }

    /// Shape functions, `[nodes]`; zero beyond.
    pub fn values(&self, xi: [f64; 2]) -> [f64; MOST] {
        let mut out = [0.0; MOST];
        shape::values(self.kind, &[xi[0], xi[1], 0.0], &mut out);
        out
    }

    /// Hat functions of the corners, `[corners]`: positive, linear along the edges, adding up to one.
    pub fn hats(&self, xi: [f64; 2]) -> [f64; MOST] {
        let mut out = [0.0; MOST];
        shape::values(self.corner_kind(), &[xi[0], xi[1], 0.0], &mut out);
        out
    }

    /// Position at local coordinates.
    pub fn position(&self, xi: [f64; 2]) -> Vec3 {
        let x = self.points().iter().zip(self.values(xi)).map(|(p, n)| p * n).sum::<Vec3>();
        if self.is_edge() { x + Vec3::z() * xi[1] } else { x }
    }

    /// Tangents ∂x/∂ξ, ∂x/∂η.
    pub fn tangents(&self, xi: [f64; 2]) -> [Vec3; 2] {
        let mut gradients = [[0.0; 3]; MOST];
        shape::gradients(self.kind, &[xi[0], xi[1], 0.0], &mut gradients);
        let mut t = [Vec3::zeros(); 2];
        for (p, g) in self.points().iter().zip(gradients) {
            t[0] += p * g[0];
            t[1] += p * g[1];
        }
        if self.is_edge() {
            t[1] = Vec3::z();
        }
        t
    }

    /// Outward normal times the area per local area, t₁ × t₂.
    pub fn area_vector(&self, xi: [f64; 2]) -> Vec3 {
        let [a, b] = self.tangents(xi);
        a.cross(&b)
    }

    /// The polygons that stand for it when it is cut: itself, or where it is curved, its parts.
    pub fn patches(&self) -> &'static [Patch] {
        use CellKind::*;
        match self.kind {
            Line2 => &STRIP,
            Line3 if self.affine => &STRIP,
            Line3 => &HALF_STRIPS,
            Tri3 => &WHOLE,
            Tri6 if self.affine => &WHOLE,
            Tri6 => &QUARTERS,
            _ => &SQUARE,
        }
    }

    /// Factor from the area of the facet (strips: unit depth) to what it counts for: 1, thickness or 2πr.
    pub fn factor(&self, x: &Vec3) -> f64 {
        match self.depth {
            Depth::Solid => 1.0,
            Depth::Plane(thickness) => thickness,
            Depth::Axisymmetric => std::f64::consts::TAU * x.x,
        }
    }

    /// Characteristic length [L]: √area, or the length of an edge.
    pub fn size(&self) -> f64 {
        if self.is_edge() { self.area } else { self.area.sqrt() }
    }

    /// Degree of the shape functions' products with polynomials on it.
    pub fn degree(&self) -> usize {
        match self.kind {
            CellKind::Line2 | CellKind::Tri3 => 1,
            _ => 2,
        }
    }

    /// Local coordinates ξ and distance g with x(ξ) + g·direction = point, by Newton's method from `start`.
    pub fn project(&self, point: &Vec3, direction: &Vec3, start: [f64; 2]) -> Option<([f64; 2], f64)> {
        let mut xi = start;
        let mut g = (point - self.position(xi)).dot(direction);
        let tolerance = 1e-15 * (self.size() + point.norm());
        let mut last = f64::INFINITY;
        for _ in 0..20 {
            let r = point - self.position(xi) - direction * g;
            let size = r.norm();
            if size <= tolerance || (size < 1e4 * tolerance && size >= 0.5 * last) {
                return Some((xi, g));
            }
            last = size;
            let [a, b] = self.tangents(xi);
            let step = Matrix3::from_columns(&[a, b, *direction]).lu().solve(&r)?;
            xi = [xi[0] + step.x, xi[1] + step.y];
            g += step.z;
            if !(self.is_edge() || xi[0].abs() < 10.0 && xi[1].abs() < 10.0) {
                return None;
            }
        }
        None
    }

    /// How far local coordinates lie outside of the facet, of its size [-]; ≤ 0 inside.
    pub fn outside(&self, xi: [f64; 2]) -> f64 {
        match self.corner_kind() {
            CellKind::Line2 => (xi[0].abs() - 1.0) * 0.5,
            CellKind::Tri3 => (-xi[0]).max(-xi[1]).max(xi[0] + xi[1] - 1.0),
            _ => (xi[0].abs().max(xi[1].abs()) - 1.0) * 0.5,
        }
    }

    /// Local coordinates of the centre.
    pub fn centre(&self) -> [f64; 2] {
        let c = shape::centroid(self.kind);
        [c[0], c[1]]
    }
}

/// Quadrature over whole facets, the rules made once: exact to `factor` times the degree of the shape functions,
/// and one more.
#[derive(Debug)]
pub struct Rules(Vec<(CellKind, Rule)>);

impl Rules {
    /// The rules of all kinds of facet.
    pub fn new(factor: usize) -> Self {
        use CellKind::*;
        let degree = |kind| factor * if matches!(kind, Line2 | Tri3) { 1 } else { 2 } + 1;
        Rules([Line2, Line3, Tri3, Tri6, Quad4].map(|kind| (kind, Rule::of(kind, degree(kind)))).to_vec())
    }

    /// Points and weights for a facet.
    pub fn of(&self, facet: &Facet) -> &[([f64; 3], f64)] {
        self.0.iter().find(|r| r.0 == facet.kind).map_or(&[], |r| &r.1.points)
    }
}
