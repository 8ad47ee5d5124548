//! A cylinder on a block of the same steel, pressed together: Hertz's line contact between two elastic bodies.
//!
//! Half of both, R = 200, plane strain, each cut off at 160 from the contact, where the upper one is moved down. The
//! answer (Johnson, Contact Mechanics, 1985, §4.2) takes the force P per length that the program finds:
//! a² = 4PR/πE*, p₀ = 2P/πa, p = p₀ √(1 − x²/a²). It is that of half spaces: the circle is no parabola by (a/R)² = 3e-5
//! of the pressure, and the cut changes the curvature by about (π/4)(a/160)² = 3e-5.

use super::contact_area::{Contact, Pressure, nodes, sums};
use super::grading::Grading;
use crate::problem::{Answer, Curve, Norm, Problem, Scene};
use fe_core::element::ElementType;
use fe_mesh::Mesh;
use fe_mesh::generate::Block;
use std::f64::consts::PI;

const YOUNG: f64 = 210e3;
const POISSON: f64 = 0.3;
const RADIUS: f64 = 200.0;
/// Where the bodies end [L].
const SIZE: f64 = 160.0;
/// Way of the upper end down [L]: half the contact width is about 1.
const WAY: f64 = 0.0136;
/// The model's own error [-].
const MODEL: f64 = 6e-5;
const ONE_LAYER: &str = "multipliers, one layer";
const FOUR_LAYERS: &str = "multipliers, four layers";

/// The problem.
pub struct Cylinder;

impl Problem for Cylinder {
    fn name(&self) -> &'static str {
        "cylinder"
    }

    fn about(&self) -> &'static str {
        "elastic cylinder on an elastic block (Hertz line, two bodies, node to surface), error at the force found"
    }

    fn norms(&self) -> &'static [Norm] {
        &[
            Norm { name: "peak pressure", floor: MODEL },
            Norm { name: "half width", floor: MODEL },
            Norm { name: "pressure L2", floor: MODEL },
        ]
    }

    fn curves(&self) -> Vec<Curve> {
        vec![Curve { element: ElementType::C3D8, variant: ONE_LAYER, sizes: vec![4, 8, 16, 32] }]
    }

    fn compared(&self) -> Vec<(Curve, usize)> {
        [(ONE_LAYER, 14), (ONE_LAYER, 20), (FOUR_LAYERS, 4), (FOUR_LAYERS, 8)]
            .map(|(variant, n)| (Curve { element: ElementType::C3D8, variant, sizes: Vec::new() }, n))
            .to_vec()
    }

    /// `n` elements along half the contact width on both bodies, node on node: otherwise the pressure that node to
    /// surface passes on waves from node to node.
    fn scene(&self, curve: &Curve, n: usize) -> Scene {
        let layers = if curve.variant == FOUR_LAYERS { 4 } else { 1 };
        let cylinder = body(1.0 / n as f64, layers, |x, y| {
            let sagitta = RADIUS - (RADIUS * RADIUS - x * x).sqrt();
            sagitta + y * (1.0 - sagitta / SIZE)
        });
        let block = body(1.0 / n as f64, layers, |_, y| y - SIZE);
        let mut mesh = with_supports(cylinder, "CYLINDER_");
        mesh.append(&with_supports(block, "BLOCK_"));
        let cards = format!(
            "*MATERIAL, NAME=STEEL\n*ELASTIC\n{YOUNG}, {POISSON}\n\
             *SOLID SECTION, ELSET=CYLINDER_BLOCK, MATERIAL=STEEL\n*SOLID SECTION, ELSET=BLOCK_BLOCK, MATERIAL=STEEL\n\
             *SURFACE INTERACTION, NAME=HARD\n*SURFACE BEHAVIOR, PRESSURE-OVERCLOSURE=HARD\n\
             *CONTACT PAIR, INTERACTION=HARD, TYPE=NODE TO SURFACE\nCYLINDER_TOUCH, BLOCK_TOUCH\n\
             *BOUNDARY\nSYMMETRY, 1, 1\nSIDES, 3, 3\nBLOCK_YMIN, 2, 2\n*STEP\n*STATIC\n1., 1.\n\
             *BOUNDARY\nCYLINDER_YMAX, 2, 2, -{WAY}\n\
             *NODE PRINT, NSET=CYLINDER_YMAX, TOTALS=ONLY\nRF\n*NODE FILE\nU\n*CONTACT PRINT\nCSTR\n*END STEP\n"
        );
        let held = mesh.node_sets["SYMMETRY"].len() + mesh.node_sets["SIDES"].len();
        let unknowns =
            3 * mesh.points.len() - held - mesh.node_sets["BLOCK_YMIN"].len() - mesh.node_sets["CYLINDER_YMAX"].len();
        let name = format!("cylinder_{layers}_{n}");
        let elements = vec![("CYLINDER_BLOCK", curve.element), ("BLOCK_BLOCK", curve.element)];
        Scene { name, mesh, elements, cards, unknowns }
    }

    fn errors(&self, scene: &Scene, answer: &Answer) -> Result<Vec<f64>, String> {
        let mesh = &scene.mesh;
        let thickness = mesh.points.iter().map(|p| p[2]).fold(0.0, f64::max);
        let force = 2.0 * answer.total_force("CYLINDER_YMAX")?[1].abs() / thickness;
        let modulus = 0.5 * YOUNG / (1.0 - POISSON * POISSON);
        let half_width = (4.0 * force * RADIUS / (PI * modulus)).sqrt();
        let peak = 2.0 * force / (PI * half_width);
        let pressures = answer.pressures(mesh)?;
        let nodes = nodes(mesh, &mesh.surfaces["CYLINDER_TOUCH"], Contact::Line);
        let exact = |x: f64| peak * (1.0 - (x / half_width).powi(2)).max(0.0).sqrt();
        let found = sums(&nodes, &pressures, Pressure::Mean, exact);
        let middle = nodes.iter().filter(|node| node.distance == 0.0).map(|node| pressures[node.point]);
        let largest = middle.clone().sum::<f64>() / middle.count() as f64;
        // The second moment of Hertz's pressure is a²/4 of the force.
        let width = 2.0 * (found.moment / found.force).sqrt();
        Ok(vec![largest / peak - 1.0, width / half_width - 1.0, found.error])
    }
}

/// A block of edge `h` at the contact, its points at the height `height(x, y)`; one side of it is `TOUCH`, as far as
/// x = 2.
fn body(h: f64, layers: usize, height: impl Fn(f64, f64) -> f64) -> Mesh {
    let grading = Grading::new(h, 2.0, SIZE, 1.25);
    let cells = grading.cells();
    let below = height(0.0, 0.0) < 0.0;
    let mut mesh = Block::hex8([cells, cells, layers]).mapped(|[s, t, r]| {
        let (x, depth) = (grading.at(s), grading.at(if below { 1.0 - t } else { t }));
        [x, height(x, if below { SIZE - depth } else { depth }), r * h * layers as f64]
    });
    let mut touch = mesh.surfaces[if below { "YMAX" } else { "YMIN" }].clone();
    touch.retain(|&face| mesh.face(face).1.iter().all(|&n| mesh.points[n as usize][0] < 2.0 + 1e-9));
    mesh.surfaces = [("TOUCH".to_string(), touch)].into();
    mesh
}

/// The mesh with a prefix before its names, and without one the sets that the supports of both bodies hold.
fn with_supports(mesh: Mesh, prefix: &str) -> Mesh {
    let mut mesh = mesh.prefixed(prefix);
    let sets = |sides: &[&str]| -> Vec<u32> {
        let mut nodes: Vec<u32> =
            sides.iter().flat_map(|side| mesh.node_sets[&format!("{prefix}{side}")].clone()).collect();
        nodes.sort_unstable();
        nodes
    };
    let (symmetry, sides) = (sets(&["XMIN"]), sets(&["ZMIN", "ZMAX"]));
    mesh.node_sets.insert("SYMMETRY".into(), symmetry);
    mesh.node_sets.insert("SIDES".into(), sides);
    mesh
}
