//! A ball on a rigid flat: Hertz's point contact.
//!
//! R = 10, E = 210000, ν = 0.3, pressed by the force of a contact of radius a = 0.5 (Johnson, Contact Mechanics, 1985,
//! §4.2): a³ = 3PR/4E*, p₀ = 3P/2πa², p = p₀ √(1 − r²/a²). The lower half of the ball as far as r = 0.9 R, loaded by
//! a uniform pressure on its upper plane and held by contact alone; a quarter of it, or turned about the axis.
//! The peak is that of a fit over the inner half: the node on the axis of an axisymmetric mesh converges with the first
//! order alone, because linear functions of r do not follow a deflection that goes with r².

use super::contact_area::{Contact, Pressure, nodes, peak, sums};
use super::grading::Grading;
use crate::problem::{Answer, Curve, Norm, Problem, Scene};
use fe_core::element::{ElementType, Space};
use fe_mesh::generate::Block;
use fe_mesh::{Face, Mesh};
use std::f64::consts::PI;

const YOUNG: f64 = 210e3;
const POISSON: f64 = 0.3;
const RADIUS: f64 = 10.0;
/// Contact radius a [L].
const CONTACT: f64 = 0.5;
/// Where the body ends sideways [L].
const SIDE: f64 = 0.9 * RADIUS;
/// Edges are even as far as this [L], and faces may touch as far as this.
const FINE: f64 = 1.5 * CONTACT;
/// The model's own error [-] in radius and distribution: the next term of the circle's height adds 0.4 (a/R)² to the
/// force at a given radius.
const MODEL: f64 = 1e-3;
/// The same in the peak, which tends to 0.17 % below Hertz's on axisymmetric meshes of stiffer contact, and to 0.1 % at
/// half the contact radius: the half ball is no half space.
const MODEL_PEAK: f64 = 2e-3;
/// Largest difference between the pressures' sum and the load [-]: facets are curved.
const BALANCE: f64 = 1e-6;
const SURFACE: &str = "surface to surface";
const DIRECT: &str = "surface to surface, multipliers";
const NODE: &str = "node to surface";

/// The problem.
pub struct HertzBall;

impl Problem for HertzBall {
    fn name(&self) -> &'static str {
        "hertz_ball"
    }

    fn about(&self) -> &'static str {
        "elastic ball on a rigid flat against Hertz, pressed by a given force"
    }

    fn norms(&self) -> &'static [Norm] {
        &[
            Norm { name: "peak pressure", floor: MODEL_PEAK },
            Norm { name: "contact radius", floor: MODEL },
            Norm { name: "pressure L2", floor: MODEL },
        ]
    }

    fn curves(&self) -> Vec<Curve> {
        [
            (ElementType::CAX4, SURFACE, vec![2, 4, 8, 16, 32, 64]),
            (ElementType::CAX4, DIRECT, vec![2, 4, 8, 16, 32, 64]),
            (ElementType::CAX4, NODE, vec![2, 4, 8, 16, 32, 64]),
            (ElementType::C3D8, SURFACE, vec![2, 4, 8, 12]),
            (ElementType::C3D8, NODE, vec![2, 4, 8, 12]),
            (ElementType::C3D4, SURFACE, vec![2, 4, 8, 12]),
            (ElementType::C3D10, SURFACE, vec![2, 4, 6]),
        ]
        .map(|(element, variant, sizes)| Curve { element, variant, sizes })
        .to_vec()
    }

    /// `n` element edges along the contact radius, growing from 1.5 times that radius on.
    fn scene(&self, curve: &Curve, n: usize) -> Scene {
        let turned = curve.element.space() == Space::Axisymmetric;
        let mut mesh = if turned { section(n) } else { quarter(curve.element, n) };
        let (top, up, contact) = if turned { ("YMAX", 2, Contact::Turned) } else { ("ZMAX", 3, Contact::Round) };
        let load: f64 = nodes(&mesh, &mesh.surfaces[top], contact).iter().map(|node| node.area).sum();
        let pressure = force() * part(turned) / load;
        let bottom = mesh.surfaces[if turned { "YMIN" } else { "ZMIN" }].clone();
        mesh.surfaces = [("TOP".to_string(), mesh.surfaces[top].clone()), ("TOUCH".into(), near(&mesh, bottom))].into();
        let (floor, supports, held) = if turned {
            ("SEGMENTS\nSTART, -1., 0.\nLINE, 10., 0.\n", "XMIN, 1, 1\n", vec!["XMIN"])
        } else {
            let floor = "REVOLUTION\n0., 0., 0., 0., 0., 1.\nSTART, 0., 0.\nLINE, 10., 0.\n";
            (floor, "XMIN, 1, 1\nYMIN, 2, 2\n", vec!["XMIN", "YMIN"])
        };
        let reference = mesh.points.len() + 1;
        let cards = format!(
            "*NODE\n{reference}, 0., -1.\n*MATERIAL, NAME=STEEL\n*ELASTIC\n{YOUNG}, {POISSON}\n\
             *SOLID SECTION, ELSET=BLOCK, MATERIAL=STEEL\n\
             *SURFACE, NAME=FLOOR, TYPE={floor}*RIGID BODY, ANALYTICAL SURFACE=FLOOR, REF NODE={reference}\n\
             *SURFACE INTERACTION, NAME=HARD\n*SURFACE BEHAVIOR, {enforcement}\n\
             *CONTACT PAIR, INTERACTION=HARD, TYPE={kind}\nTOUCH, FLOOR\n\
             *BOUNDARY\n{reference}, 1, 6\n{supports}*STEP\n*STATIC\n1., 1.\n*DSLOAD\nTOP, P, {pressure:.12e}\n\
             *CONTACT PRINT\nCSTR\n*END STEP\n",
            kind = if curve.variant == NODE { "NODE TO SURFACE" } else { "SURFACE TO SURFACE" },
            enforcement = if curve.variant == DIRECT { "DIRECT" } else { "PENALTY" },
        );
        let name = format!(
            "hertz_ball_{}_{}_{n}",
            curve.element.name().to_lowercase(),
            curve.variant.replace([' ', ','], "_")
        );
        let held: usize = held.iter().map(|side| mesh.node_sets[*side].len()).sum();
        let unknowns = (up * mesh.points.len()) - held;
        Scene { name, mesh, elements: vec![("BLOCK", curve.element)], cards, unknowns }
    }

    fn errors(&self, scene: &Scene, answer: &Answer) -> Result<Vec<f64>, String> {
        let mesh = &scene.mesh;
        let turned = scene.elements[0].1.space() == Space::Axisymmetric;
        let meaning = if scene.cards.contains("TYPE=NODE TO SURFACE") { Pressure::Mean } else { Pressure::Field };
        let nodes = nodes(mesh, &mesh.surfaces["TOUCH"], if turned { Contact::Turned } else { Contact::Round });
        let pressures = answer.pressures(mesh)?;
        let largest = 1.5 * force() / (PI * CONTACT * CONTACT);
        let exact = |r: f64| largest * (1.0 - (r / CONTACT).powi(2)).max(0.0).sqrt();
        let found = sums(&nodes, &pressures, meaning, exact);
        let carried = found.force / (force() * part(turned)) - 1.0;
        if carried.abs() > BALANCE {
            return Err(format!("{}: the pressures differ from the load by {carried:.1e} of it", scene.name));
        }
        // The second moment of Hertz's pressure is 2a²/5 of the force.
        let radius = (2.5 * found.moment / found.force).sqrt();
        Ok(vec![peak(&nodes, &pressures, 0.5 * CONTACT) / largest - 1.0, radius / CONTACT - 1.0, found.error])
    }
}

/// Force [F] on the whole ball.
fn force() -> f64 {
    4.0 / 3.0 * YOUNG / (1.0 - POISSON * POISSON) * CONTACT.powi(3) / RADIUS
}

/// The part of the ball that the mesh stands for: all around, or a quarter.
fn part(turned: bool) -> f64 {
    if turned { 1.0 } else { 0.25 }
}

/// Edges along the surface and into the depth, each longer than the one before by a quarter where elements are linear,
/// by a half where they are quadratic.
fn gradings(element: ElementType, n: usize) -> [Grading; 2] {
    let growth = if element == ElementType::C3D10 { 1.5 } else { 1.25 };
    [SIDE, RADIUS].map(|length| Grading::new(CONTACT / n as f64, FINE, length, growth))
}

/// Height [L] of a point above the floor: at `depth` below the upper plane's height, as columns of the ball's own
/// height take it.
fn height(r: f64, depth: f64) -> f64 {
    let bottom = RADIUS - (RADIUS * RADIUS - r * r).max(0.0).sqrt();
    bottom + depth * (1.0 - bottom / RADIUS)
}

/// Half a section: x is the radius, y the height.
fn section(n: usize) -> Mesh {
    let [along, down] = gradings(ElementType::CAX4, n);
    Block::quad4([along.cells(), down.cells()]).mapped(|[s, t, _]| {
        let r = along.at(s);
        [r, height(r, down.at(t)), 0.0]
    })
}

/// A quarter: the square of the graded block goes to the quarter disc by x = u √(1 − v²/2), y = v √(1 − u²/2) in
/// parts of its radius, in the middle nearly the identity.
fn quarter(element: ElementType, n: usize) -> Mesh {
    let [along, down] = gradings(element, n);
    let divisions = [along.cells(), along.cells(), down.cells()];
    let block = match element {
        ElementType::C3D8 => Block::hex8(divisions),
        ElementType::C3D4 => Block::tet4(divisions),
        _ => Block::tet10(divisions),
    };
    block.mapped(|[s, t, d]| {
        let [u, v] = [s, t].map(|part| along.at(part) / SIDE);
        let [x, y] = [SIDE * u * (1.0 - 0.5 * v * v).sqrt(), SIDE * v * (1.0 - 0.5 * u * u).sqrt()];
        [x, y, height(x.hypot(y), down.at(d))]
    })
}

/// The faces that may touch.
fn near(mesh: &Mesh, mut faces: Vec<Face>) -> Vec<Face> {
    let inside = |n: u32| mesh.points[n as usize][0] < 1.01 * FINE && mesh.points[n as usize][1] < 1.01 * FINE;
    faces.retain(|&face| mesh.face(face).1.iter().all(|&n| inside(n)));
    faces
}
