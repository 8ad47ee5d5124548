//! The round bodies and flats of Cattaneo's contacts (A32, A33).
//!
//! The theory is that of half spaces, a/R → 0: at R = 50a flanks that tilt by up to a/R leave an error of 0.02 p in the shear
//! on any mesh, 0.06 of its limit. So both bodies are blocks, the upper one with a parabola below of a radius SCALE times as
//! large, E as many times: P, p₀ and Q remain.

use crate::bodies::block;
use crate::deck::{Solution, exact_step, forces, material_of, run_sets};
use benchmarks::problems::contact_area::{Contact, Node, nodes};
use benchmarks::problems::grading::Grading;
use fe_core::element::ElementType::{self, C3D8, CPE4};
use fe_core::element::Space;
use fe_mesh::Mesh;
use std::f64::consts::PI;

const SCALE: f64 = 100.0;
pub const YOUNG: f64 = 210e3 * SCALE;
pub const POISSON: f64 = 0.3;
pub const COEFFICIENT: f64 = 0.3;

/// Round body and flat.
#[derive(Clone, Copy)]
pub struct Bodies {
    element: ElementType,
    /// Radius [L].
    pub radius: f64,
    /// Contact's half width or radius [L] under the force.
    pub contact: f64,
    /// P [F], per length of the cylinder.
    pub force: f64,
    /// Depth of each body and half its width [L].
    size: f64,
    /// Each edge over the one before, away from the contact.
    growth: f64,
    /// How nodes and surfaces meet.
    pub kind: &'static str,
}

pub const CYLINDER: Bodies = Bodies {
    element: CPE4,
    radius: 50.0 * SCALE,
    contact: 1.0,
    force: 1812.45730015,
    size: 50.0,
    growth: 1.3,
    kind: "SURFACE TO SURFACE",
};

/// Half of it, y > 0.
pub const BALL: Bodies = Bodies {
    element: C3D8,
    radius: 10.0 * SCALE,
    contact: 0.5,
    force: 1923.07692308,
    size: 4.0,
    growth: 1.6,
    kind: "NODE TO SURFACE",
};

/// What acts along the contact.
pub const COULOMB: &str = "*FRICTION, LAGRANGE\n0.3\n";
pub const ROUGH: &str = "*FRICTION, ROUGH\n";

/// A place of the unit interval on both sides of 0.
fn on_both_sides(grading: &Grading, part: f64) -> f64 {
    (grading.at((2.0 * part - 1.0).abs())).copysign(part - 0.5)
}

impl Bodies {
    pub fn is_solid(&self) -> bool {
        self.element.space() == Space::Solid
    }

    /// Edges h as far as 1.2 a along the contact and 0.5 a into the depth; node on node.
    fn mesh(&self, h: f64) -> Mesh {
        let along = Grading::new(h, 1.2 * self.contact, self.size, self.growth);
        let deep = Grading::new(h, 0.5 * self.contact, self.size, self.growth);
        let (wide, high) = (along.cells(), deep.cells());
        let body = |prefix: &str, upper: bool| {
            let divisions = if self.is_solid() { [2 * wide, wide, high] } else { [2 * wide, high, 1] };
            let mut mesh = block(self.element, divisions).mapped(|[s, t, r]| {
                let (y, part) = if self.is_solid() { (along.at(t), r) } else { (0.0, t) };
                let x = on_both_sides(&along, s);
                let bottom = 0.5 * (x * x + y * y) / self.radius;
                let depth = deep.at(if upper { part } else { 1.0 - part });
                let up = if upper { bottom + depth * (1.0 - bottom / self.size) } else { -depth };
                if self.is_solid() { [x, y, up] } else { [x, up, 0.0] }
            });
            let mut touch = mesh.surfaces[self.side(!upper)].clone();
            let near = |n: u32| mesh.points[n as usize][0].abs().max(mesh.points[n as usize][1]) < 1.21 * self.contact;
            touch.retain(|&face| mesh.face(face).1.into_iter().all(near));
            mesh.surfaces.insert("TOUCH".into(), touch);
            mesh.prefixed(prefix)
        };
        let mut mesh = body("UP_", true);
        mesh.append(&body("LOW_", false));
        mesh
    }

    /// Name of the side above or below.
    fn side(&self, above: bool) -> &'static str {
        match (self.is_solid(), above) {
            (false, false) => "YMIN",
            (false, true) => "YMAX",
            (true, false) => "ZMIN",
            (true, true) => "ZMAX",
        }
    }

    /// How far the upper body's top goes down, nearly: two layers of that depth under a line or a point force.
    fn way(&self) -> f64 {
        let (nu, depth) = (POISSON, self.size);
        if self.is_solid() {
            let layer = self.force * (1.0 + nu) * (3.0 - 2.0 * nu) / (2.0 * PI * YOUNG * depth);
            self.contact * self.contact / self.radius - 2.0 * layer
        } else {
            let layer = (2.0 * depth / self.contact).ln() - 0.5 * nu / (1.0 - nu);
            4.0 * self.force * (1.0 - nu * nu) / (PI * YOUNG) * layer
        }
    }

    /// Nodes of the upper body's top.
    fn top(&self, mesh: &Mesh) -> Vec<Node> {
        let contact = if self.is_solid() { Contact::Round } else { Contact::Line };
        nodes(mesh, &mesh.surfaces[&format!("UP_{}", self.side(true))], contact)
    }

    /// Pressed by moving the upper body's top down, then pulled along by this part of μP at its top, which stays level.
    pub fn pulled(&self, h: f64, part: f64, friction: &str) -> Solution {
        let mesh = self.mesh(h);
        let top = self.top(&mesh);
        let whole: f64 = top.iter().map(|node| node.area).sum();
        let middle = top.iter().find(|node| node.distance == 0.0).unwrap().point + 1;
        let (above, below, up) = (self.side(true), self.side(false), if self.is_solid() { 3 } else { 2 });
        let symmetry = if self.is_solid() { "UP_YMIN, 2, 2\nLOW_YMIN, 2, 2\n" } else { "" };
        let held = format!("LOW_{below}, 1, {up}\nUP_{above}, {up}, {up}, {:e}\n{symmetry}", -self.way());
        let force = self.pull(part) / whole;
        let loads = forces(&mesh, top.iter().map(|node| (node.point as u32, [force * node.area, 0.0, 0.0])));
        let kind = self.kind;
        let cards = format!(
            "{}{}*SURFACE INTERACTION, NAME=RUB\n*SURFACE BEHAVIOR, DIRECT\n{friction}\
             *CONTACT PAIR, INTERACTION=RUB, TYPE={kind}, SMALL SLIDING\nUP_TOUCH, LOW_TOUCH\n{}{}",
            material_of("UP_BLOCK", YOUNG, POISSON),
            material_of("LOW_BLOCK", YOUNG, POISSON),
            exact_step(&format!("*BOUNDARY\n{held}{middle}, 1, 1\n")),
            exact_step(&format!("*BOUNDARY, OP=NEW\n{held}{loads}")),
        );
        run_sets("cattaneo", vec![("UP_BLOCK", self.element), ("LOW_BLOCK", self.element)], mesh, &cards)
    }

    /// Q on what the mesh holds of the bodies [F], at the theory's P.
    pub fn pull(&self, part: f64) -> f64 {
        part * COEFFICIENT * self.force * self.share()
    }

    /// What the supports press the upper body down by [F] over the force that its contact passes on, less 1.
    pub fn pressed(&self, solution: &Solution) -> f64 {
        let (axis, terms) = (if self.is_solid() { 2 } else { 1 }, &solution.terms);
        let reaction =
            |node: &Node| terms.freedoms.index(node.point, axis).map_or(0.0, |f| solution.report.last.residual[f]);
        let held: f64 = self.top(&terms.structure.mesh).iter().map(reaction).sum();
        let state = &terms.states(&solution.report.last)[0];
        let shear = state.secondary_shear.as_ref().unwrap();
        -held / (state.secondary.force[axis] + shear.force[axis]) - 1.0
    }

    /// The part of the bodies that the mesh holds.
    pub fn share(&self) -> f64 {
        if self.is_solid() { 0.5 } else { 1.0 }
    }

    /// Mean way [L] of the upper body's top along the pull.
    pub fn shift(&self, solution: &Solution) -> f64 {
        let top = self.top(&solution.terms.structure.mesh);
        let whole: f64 = top.iter().map(|node| node.area).sum();
        top.iter().map(|node| node.area * solution.u[node.point][0]).sum::<f64>() / whole
    }
}
