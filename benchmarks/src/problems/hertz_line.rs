//! A rigid cylinder on the half plane: Hertz's line contact, exact in a window of it.
//!
//! [0,2]² in plane strain, E = 1000, ν = 0.3, the half contact width a = 1; u_x = 0 on x = 0, the exact displacements
//! (see [`Window`]) on x = 2 and y = 2. The deck's obstacle is a circle of R = 100000 instead of the parabola: its
//! normals tilt by a/R = 1e-5, and its height in double precision is good to 1e-6 of a²/2R.

use super::contact_area::{Contact, Pressure, nodes, sums};
use crate::exact::window::Window;
use crate::norm::{Quadrature, errors};
use crate::problem::{Answer, Curve, Norm, Problem, Scene};
use fe_core::element::{ElementType, Space};
use fe_core::material::Elastic;
use fe_mesh::Mesh;
use fe_mesh::generate::Block;
use std::fmt::Write;

const ELASTIC: Elastic = Elastic { young: 1000.0, poisson: 0.3 };
const RADIUS: f64 = 1e5;
/// Edge of the window [L].
const SIZE: f64 = 2.0;
/// The model's own error [-].
const MODEL: f64 = 1e-5;
const SURFACE: &str = "surface to surface";
const STIFF: &str = "surface to surface, K/h²";
const DIRECT: &str = "surface to surface, multipliers";
const NODE: &str = "node to surface";

/// The problem.
pub struct HertzLine;

impl Problem for HertzLine {
    fn name(&self) -> &'static str {
        "hertz_line"
    }

    fn about(&self) -> &'static str {
        "rigid cylinder on the half plane against Hertz, in an exact window"
    }

    fn norms(&self) -> &'static [Norm] {
        &[
            Norm { name: "energy", floor: MODEL },
            Norm { name: "displacement L2", floor: MODEL },
            Norm { name: "pressure L2", floor: MODEL },
            Norm { name: "resultant", floor: MODEL },
        ]
    }

    fn curves(&self) -> Vec<Curve> {
        let plane = vec![4, 8, 16, 32, 64];
        [
            (ElementType::CPE4, SURFACE, plane.clone()),
            (ElementType::CPE4, STIFF, plane.clone()),
            (ElementType::CPE4, DIRECT, plane.clone()),
            (ElementType::CPE4, NODE, plane.clone()),
            (ElementType::CPE3, SURFACE, plane.clone()),
            (ElementType::CPE3, STIFF, plane),
            (ElementType::C3D8, SURFACE, vec![4, 8, 16, 32]),
        ]
        .map(|(element, variant, sizes)| Curve { element, variant, sizes })
        .to_vec()
    }

    /// `n` element edges along half the contact width, its end at a node; one layer of them in space.
    fn scene(&self, curve: &Curve, n: usize) -> Scene {
        let element = curve.element;
        let solid = element.space() == Space::Solid;
        let (divisions, thickness) = ([2 * n, 2 * n], 1.0 / n as f64);
        let block = match element {
            ElementType::CPE3 => Block::tri3(divisions),
            ElementType::CPE4 => Block::quad4(divisions),
            _ => Block::hex8([2 * n, 2 * n, 1]),
        };
        let mut mesh = block.size([SIZE, SIZE, thickness]).mesh();
        mesh.surfaces = [("TOUCH".to_string(), mesh.surfaces["YMIN"].clone())].into();
        let reference = mesh.points.len() + 1;
        let (frame, sides) = if solid {
            ("CYLINDER\n0., 0., 0., 1., 0., 0.\n0., 0., -1.\n", "BLOCK, 3, 3\n")
        } else {
            ("SEGMENTS\n", "")
        };
        let (end, height) = (1.5 * SIZE, (RADIUS * RADIUS - 2.25 * SIZE * SIZE).sqrt() - RADIUS);
        let (prescribed, count) = window_cards(&mesh);
        let cards = format!(
            "*NODE\n{reference}, 0., -1.\n*MATERIAL, NAME=M\n*ELASTIC\n{young}, {poisson}\n\
             *SOLID SECTION, ELSET=BLOCK, MATERIAL=M\n*SURFACE, NAME=ROLLER, TYPE={frame}\
             START, -{end}, {height:.17e}\nCIRCL, {end}, {height:.17e}, 0., -{RADIUS}\n\
             *RIGID BODY, ANALYTICAL SURFACE=ROLLER, REF NODE={reference}\n\
             *SURFACE INTERACTION, NAME=HARD\n*SURFACE BEHAVIOR, {behavior}\n\
             *CONTACT PAIR, INTERACTION=HARD, TYPE={kind}\nTOUCH, ROLLER\n\
             *BOUNDARY\n{reference}, 1, 6\nXMIN, 1, 1\n{sides}*STEP\n*STATIC\n1., 1.\n*BOUNDARY\n{prescribed}\
             *NODE PRINT, NSET=BLOCK\nU\n*CONTACT PRINT\nCSTR\n*END STEP\n",
            young = ELASTIC.young,
            poisson = ELASTIC.poisson,
            kind = if curve.variant == NODE { "NODE TO SURFACE" } else { "SURFACE TO SURFACE" },
            behavior = match curve.variant {
                STIFF => format!("PENALTY\n{}", stiffness(n)),
                DIRECT => "DIRECT".into(),
                _ => "PENALTY".into(),
            },
        );
        let variant = match curve.variant {
            SURFACE => "surface",
            STIFF => "stiff",
            DIRECT => "direct",
            _ => "node",
        };
        let name = format!("hertz_line_{}_{variant}_{n}", element.name().to_lowercase());
        let free = 2 * mesh.points.len() - count - mesh.node_sets["XMIN"].len();
        Scene { name, mesh, elements: vec![("BLOCK", element)], cards, unknowns: free }
    }

    fn errors(&self, scene: &Scene, answer: &Answer) -> Result<Vec<f64>, String> {
        let (mesh, window) = (&scene.mesh, window());
        let u = answer.displacements(mesh, "BLOCK")?;
        let exact = |at: [f64; 3]| window.at(at);
        let edge = |[x, y, _]: [f64; 3]| (x - 1.0).hypot(y);
        let quadrature = Quadrature { points: 8, singular: Some(&edge), splits: 6 };
        let structure = scene.structure(ELASTIC);
        let volume = errors(&structure, &u, &exact, &quadrature).map_err(|error| error.to_string())?;
        let meaning = if scene.cards.contains("TYPE=NODE TO SURFACE") { Pressure::Mean } else { Pressure::Field };
        let nodes = nodes(mesh, &mesh.surfaces["TOUCH"], Contact::Line);
        let found = sums(&nodes, &answer.pressures(mesh)?, meaning, |x| window.pressure(x));
        let thickness = mesh.points.iter().map(|p| p[2]).fold(0.0, f64::max);
        let force = found.force / if thickness > 0.0 { thickness } else { 1.0 };
        Ok(vec![volume.energy, volume.displacement, found.error, force / window.half_force() - 1.0])
    }
}

fn window() -> Window {
    Window::under_parabola(ELASTIC, RADIUS)
}

/// The data line of a penalty of 80 M/h² [F/L³] (a = 1 is the length that is left), M = E (1 − ν)/((1 + ν)(1 − 2ν)) the
/// constrained modulus: what the contact gives way then falls with the square of the edge, as the error of the
/// displacement does.
fn stiffness(n: usize) -> String {
    let Elastic { young, poisson } = ELASTIC;
    let modulus = young * (1.0 - poisson) / ((1.0 + poisson) * (1.0 - 2.0 * poisson));
    format!("{:.12e}", 80.0 * modulus * (n * n) as f64)
}

/// Data lines of `*BOUNDARY` with the exact displacements on x = 2 and y = 2, and how many free ones they hold; the
/// corner on x = 0 keeps its support.
fn window_cards(mesh: &Mesh) -> (String, usize) {
    let (window, mut text, mut count) = (window(), String::new(), 0);
    for (&at, label) in mesh.points.iter().zip(&mesh.point_labels) {
        if at[0] < SIZE && at[1] < SIZE {
            continue;
        }
        let [x, y, _] = window.at(at).displacement;
        for (axis, u) in [(1, x), (2, y)] {
            if axis == 1 && at[0] == 0.0 {
                continue;
            }
            // Writing to a string does not fail.
            let _ = writeln!(text, "{label}, {axis}, {axis}, {u:.16e}");
            count += 1;
        }
    }
    (text, count)
}
