//! A32, A33: bodies of one material pressed together, then pulled along each other by a force less than μP: a cylinder and a
//! ball on a flat (Cattaneo, 1938; Mindlin, 1949; Johnson, Contact Mechanics, 1985, §7.2).
//!
//! They stick within c = a (1 − Q/μP)^½, of the ball ^⅓; the shear is μp₀ [√(1 − r²/a²) − (c/a) √(1 − r²/c²)], the second
//! root within c alone. The theory is that of half spaces, a/R → 0: at R = 50a flanks that tilt by up to a/R leave an error
//! of 0.02 p in the shear on any mesh, 0.06 of its limit. So both bodies are blocks, the upper one with a parabola below of a
//! radius SCALE times as large, E as many times: P, p₀ and Q remain.

use crate::bodies::block;
use crate::deck::{Solution, exact_step, forces, material_of, run_sets};
use benchmarks::problems::contact_area::{Contact, Node, nodes};
use benchmarks::problems::grading::Grading;
use fe_contact::point::ContactStatus;
use fe_contact::state::PointState;
use fe_core::element::ElementType::{self, C3D8, CPE4};
use fe_core::element::Space;
use fe_mesh::Mesh;
use std::f64::consts::PI;
use std::fmt::{Display, Formatter};

const SCALE: f64 = 100.0;
const YOUNG: f64 = 210e3 * SCALE;
const POISSON: f64 = 0.3;
const COEFFICIENT: f64 = 0.3;
/// What a residual of 1e-12 of P at each of some thousand nodes leaves open of Q = 0.25 μP [-].
const CARRIED: f64 = 1e-9;

/// Round body and flat.
#[derive(Clone, Copy)]
struct Bodies {
    element: ElementType,
    /// Radius [L].
    radius: f64,
    /// Contact's half width or radius [L] under the force.
    contact: f64,
    /// P [F], per length of the cylinder.
    force: f64,
    /// Depth of each body and half its width [L].
    size: f64,
    /// Each edge over the one before, away from the contact.
    growth: f64,
}

const CYLINDER: Bodies =
    Bodies { element: CPE4, radius: 50.0 * SCALE, contact: 1.0, force: 1812.45730015, size: 50.0, growth: 1.3 };

/// Half of it, y > 0.
const BALL: Bodies =
    Bodies { element: C3D8, radius: 10.0 * SCALE, contact: 0.5, force: 1923.07692308, size: 4.0, growth: 1.6 };

/// What acts along the contact.
const COULOMB: &str = "*FRICTION, LAGRANGE\n0.3\n";
const ROUGH: &str = "*FRICTION, ROUGH\n";

/// A place of the unit interval on both sides of 0.
fn on_both_sides(grading: &Grading, part: f64) -> f64 {
    (grading.at((2.0 * part - 1.0).abs())).copysign(part - 0.5)
}

impl Bodies {
    fn is_solid(&self) -> bool {
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

    /// Pressed by moving the upper body's top down, then pulled along by this part of μP at its top, which stays level. The
    /// ball's points act node to surface: surface to surface has a multiplier across the plane of symmetry for each node on
    /// it, where nothing moves that way but its neighbours.
    fn pulled(&self, h: f64, part: f64, friction: &str) -> Solution {
        let mesh = self.mesh(h);
        let top = self.top(&mesh);
        let whole: f64 = top.iter().map(|node| node.area).sum();
        let middle = top.iter().find(|node| node.distance == 0.0).unwrap().point + 1;
        let (above, below, up) = (self.side(true), self.side(false), if self.is_solid() { 3 } else { 2 });
        let symmetry = if self.is_solid() { "UP_YMIN, 2, 2\nLOW_YMIN, 2, 2\n" } else { "" };
        let held = format!("LOW_{below}, 1, {up}\nUP_{above}, {up}, {up}, {:e}\n{symmetry}", -self.way());
        let force = self.pull(part) / whole;
        let loads = forces(&mesh, top.iter().map(|node| (node.point as u32, [force * node.area, 0.0, 0.0])));
        let kind = if self.is_solid() { "NODE TO SURFACE" } else { "SURFACE TO SURFACE" };
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
    fn pull(&self, part: f64) -> f64 {
        part * COEFFICIENT * self.force * self.share()
    }

    /// The part of the bodies that the mesh holds.
    fn share(&self) -> f64 {
        if self.is_solid() { 0.5 } else { 1.0 }
    }

    /// Mean way [L] of the upper body's top along the pull.
    fn shift(&self, solution: &Solution) -> f64 {
        let top = self.top(&solution.terms.structure.mesh);
        let whole: f64 = top.iter().map(|node| node.area).sum();
        top.iter().map(|node| node.area * solution.u[node.point][0]).sum::<f64>() / whole
    }

    /// The theory at the force that presses them, found in a solution, and this pull of the whole bodies [F].
    fn theory(&self, solution: &Solution, pull: f64) -> Theory {
        let state = &solution.terms.states(&solution.report.last)[0];
        let modulus = 0.5 * YOUNG / (1.0 - POISSON * POISSON);
        let force = state.secondary.force[if self.is_solid() { 2 } else { 1 }] / self.share();
        let rest = 1.0 - pull / (COEFFICIENT * force);
        if self.is_solid() {
            let contact = (0.75 * force * self.radius / modulus).cbrt();
            let peak = 1.5 * force / (PI * contact * contact);
            Theory { force, contact, limit: COEFFICIENT * peak, stick: contact * rest.cbrt(), rest }
        } else {
            let contact = (4.0 * force * self.radius / (PI * modulus)).sqrt();
            let peak = 2.0 * force / (PI * contact);
            Theory { force, contact, limit: COEFFICIENT * peak, stick: contact * rest.sqrt(), rest }
        }
    }
}

/// Cattaneo's and Mindlin's contact.
struct Theory {
    /// P [F].
    force: f64,
    /// a [L].
    contact: f64,
    /// μp₀ [F/L²].
    limit: f64,
    /// c [L].
    stick: f64,
    /// 1 − Q/μP.
    rest: f64,
}

impl Theory {
    fn shear(&self, r: f64) -> f64 {
        self.limit * (self.root(r, self.contact) - self.stick / self.contact * self.root(r, self.stick))
    }

    /// √(1 − r²/end²) within the end.
    fn root(&self, r: f64, end: f64) -> f64 {
        (1.0 - (r / end).powi(2)).max(0.0).sqrt()
    }

    /// What slip adds to the shift of balls [L]: (3μP/16aG*) [1 − (1 − Q/μP)^⅔] − Q/8aG*, 1/G* = 2(2 − ν)/G.
    fn slip(&self) -> f64 {
        let compliance = 4.0 * (2.0 - POISSON) * (1.0 + POISSON) / YOUNG;
        let scale = COEFFICIENT * self.force * compliance / (8.0 * self.contact);
        scale * (1.5 * (1.0 - self.rest.powf(2.0 / 3.0)) - (1.0 - self.rest))
    }
}

/// What was found.
struct Found {
    /// Pull that the contact carries over the one that was applied, less 1.
    carried: f64,
    /// Farthest sticking point in parts of a.
    sticking: f64,
    /// Nearest slipping point in parts of a.
    slipping: f64,
    /// Error of the shear over μp, both in L2 (sums over the nodes).
    error: f64,
}

impl Display for Found {
    fn fmt(&self, f: &mut Formatter<'_>) -> std::fmt::Result {
        let Found { carried, sticking, slipping, error } = self;
        write!(f, "carried {carried:+.0e}, sticks to {sticking:.4}, slips from {slipping:.4}, shear {error:.4}")
    }
}

fn found(bodies: &Bodies, solution: &Solution, part: f64) -> (Found, Theory) {
    let theory = bodies.theory(solution, bodies.pull(part) / bodies.share());
    let state = &solution.terms.states(&solution.report.last)[0];
    let place = |p: &PointState| {
        let [x, y, _] = solution.terms.structure.mesh.points[p.node as usize];
        if bodies.is_solid() { x.hypot(y) } else { x.abs() }
    };
    // On the main side; in the plane t₁ = e_z × n goes against x.
    let shear = |p: &PointState| if bodies.is_solid() { p.shear[0] } else { -p.shear[0] };
    let sum = |of: &dyn Fn(&PointState) -> f64| -> f64 {
        state.points.iter().map(|p| of(p).powi(2) * p.measure.value()).sum::<f64>().sqrt()
    };
    let error =
        sum(&|p| shear(p) - theory.shear(place(p))) / sum(&|p| theory.limit * theory.root(place(p), theory.contact));
    let places = |status| state.points.iter().filter(move |p| p.status == status).map(place);
    let pulled = -state.secondary.force[0] - state.secondary_shear.as_ref().unwrap().force[0];
    let found = Found {
        carried: pulled / bodies.pull(part) - 1.0,
        sticking: places(ContactStatus::Closed).fold(0.0, f64::max) / theory.contact,
        slipping: places(ContactStatus::Slipping).fold(f64::INFINITY, f64::min) / theory.contact,
        error,
    };
    (found, theory)
}

/// Pulls of a quarter, a half, three quarters of μP on meshes of n edges along a, each with one step to itself. The contact
/// carries what was applied; what sticks ends within an edge of c. The shear is the difference of two of Hertz's pressures,
/// of which edges h leave 0.75 h/a (A21w): 0.75 √(1 + c/a) h/a ≤ 1.06 h/a of μp in L2, with what the finite bodies and the
/// moving edges add 1.2 h/a. (Of the shear itself, the smaller the pull, it is more: a ring of slip narrower than an edge is
/// not seen at all.)
fn cylinders(meshes: &[f64]) {
    for &n in meshes {
        for part in [0.25, 0.5, 0.75] {
            let solution = CYLINDER.pulled(1.0 / n, part, COULOMB);
            let (found, theory) = found(&CYLINDER, &solution, part);
            let (stick, h) = (theory.stick / theory.contact, 1.0 / (n * theory.contact));
            eprintln!(
                "A33 {part} n={n}: c/a {stick:.4}, {found}, {:.2} h/a, {} iterations",
                found.error / h,
                solution.report.certificate.iterations
            );
            assert!((theory.force / CYLINDER.force - 1.0).abs() < 0.1, "{part} {n}: {}", theory.force);
            assert!(found.carried.abs() < CARRIED, "{part} {n}: {:e}", found.carried);
            assert!(found.sticking < stick + h && found.slipping > stick - h, "{part} {n}");
            assert!(found.error < 1.2 * h, "{part} {n}: {} of {}", found.error, 1.2 * h);
        }
    }
}

#[test]
fn A33_cattaneo_cylinder() {
    cylinders(&[8.0, 16.0]);
}

#[test]
#[ignore = "a minute, in release"]
fn A33_cattaneo_cylinder_on_fine_meshes() {
    cylinders(&[32.0, 64.0]);
}

/// A pull of this part of μP on n edges along a: P within what the finite bodies change, Q as applied, what sticks ends
/// within an edge of c, the shear as the cylinder's. What slip adds to the shift is what Coulomb's friction adds to that of
/// rough bodies, whose finite size is out of it then; of the theory's, less 1.
fn ball(n: f64, part: f64) -> f64 {
    let h = BALL.contact / n;
    let solution = BALL.pulled(h, part, COULOMB);
    let (found, theory) = found(&BALL, &solution, part);
    let added = (BALL.shift(&solution) - BALL.shift(&BALL.pulled(h, part, ROUGH))) / theory.slip() - 1.0;
    let (stick, h) = (theory.stick / theory.contact, h / theory.contact);
    eprintln!(
        "A32 {part} n={n}: c/a {stick:.4}, {found}, {:.2} h/a, slip adds {added:+.3}, {} iterations",
        found.error / h,
        solution.report.certificate.iterations
    );
    assert!((theory.force / BALL.force - 1.0).abs() < 0.1, "{part} {n}: {}", theory.force);
    assert!(found.carried.abs() < CARRIED, "{part} {n}: {:e}", found.carried);
    assert!(found.sticking < stick + h && found.slipping > stick - h, "{part} {n}");
    assert!(found.error < 1.2 * h, "{part} {n}: {} of {}", found.error, 1.2 * h);
    added
}

/// What slip adds falls with h: h/a of it, where the ring of slip is wider than an edge.
#[test]
fn A32_cattaneo_mindlin_sphere() {
    let added = ball(5.0, 0.75);
    assert!(added.abs() < 1.0 / 5.0, "{added}");
}

/// Ten edges along a: a tenth of what slip adds at half of μP and above, and h/a of it from five edges to ten. It is as
/// (1 − c/a)², so that c, known to a part of an edge, leaves a multiple of h/(a − c), 0.15 of that on these meshes: at a
/// quarter of μP, where the ring is as narrow as an edge, more than a tenth (14 % here, 15 % on fourteen edges).
#[test]
#[ignore = "half a minute, in release"]
fn A32_cattaneo_mindlin_sphere_on_finer_meshes() {
    for (n, part) in [(7.0, 0.5), (10.0, 0.5), (10.0, 0.75)] {
        let added = ball(n, part);
        assert!(added.abs() < 1.0 / n, "{n} {part}: {added}");
    }
    let narrow = ball(10.0, 0.25);
    assert!(narrow.abs() < 0.2, "{narrow}");
}
