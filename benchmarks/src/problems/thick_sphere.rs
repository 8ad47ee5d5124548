//! A thick-walled sphere under pressure inside: radii 30 and 50, E = 70000, ν = 0.3, p = 100. Lamé's solution, see
//! [`Vessel`]; an octant in space, a quarter of the section around the axis.

use super::octant::octant;
use crate::exact::thick::Vessel;
use crate::norm::{Quadrature, errors};
use crate::problem::{Answer, Curve, Norm, Problem, Scene};
use fe_core::element::{ElementType, Space};
use fe_core::material::Elastic;
use fe_mesh::Mesh;
use fe_mesh::generate::Block;
use std::f64::consts::FRAC_PI_2;

const VESSEL: Vessel =
    Vessel { inner: 30.0, outer: 50.0, pressure: 100.0, elastic: Elastic { young: 70e3, poisson: 0.3 } };

/// The problem.
pub struct ThickSphere;

impl Problem for ThickSphere {
    fn name(&self) -> &'static str {
        "thick_sphere"
    }

    fn about(&self) -> &'static str {
        "hollow sphere under pressure inside, against Lamé"
    }

    fn norms(&self) -> &'static [Norm] {
        &[
            Norm { name: "energy", floor: 0.0 },
            Norm { name: "displacement L2", floor: 0.0 },
            Norm { name: "displacement inside", floor: 0.0 },
        ]
    }

    fn curves(&self) -> Vec<Curve> {
        [
            (ElementType::C3D4, vec![2, 4, 8, 16]),
            (ElementType::C3D8, vec![2, 4, 8, 16]),
            (ElementType::C3D10, vec![1, 2, 4, 8]),
            (ElementType::CAX3, vec![2, 4, 8, 16, 32, 64]),
            (ElementType::CAX4, vec![2, 4, 8, 16, 32, 64]),
        ]
        .map(|(element, sizes)| Curve { element, variant: "", sizes })
        .to_vec()
    }

    /// `n` elements through the wall, nearly as long around it.
    fn scene(&self, curve: &Curve, n: usize) -> Scene {
        let element = curve.element;
        let around = element.space() == Space::Axisymmetric;
        let mesh = if around {
            section(element, n)
        } else {
            octant(element, [n, (3 * n).div_ceil(2)], [VESSEL.inner, VESSEL.outer])
        };
        let (inside, supports): (_, &[(&str, usize)]) = if around {
            ("XMIN", &[("YMAX", 1), ("YMIN", 2)])
        } else {
            ("ZMIN", &[("XSYM", 1), ("YSYM", 2), ("ZSYM", 3)])
        };
        let held: String = supports.iter().map(|(set, axis)| format!("{set}, {axis}, {axis}\n")).collect();
        let Elastic { young, poisson } = VESSEL.elastic;
        let cards = format!(
            "*MATERIAL, NAME=M\n*ELASTIC\n{young}, {poisson}\n*SOLID SECTION, ELSET=BLOCK, MATERIAL=M\n\
             *BOUNDARY\n{held}*STEP\n*STATIC\n1., 1.\n*DSLOAD\n{inside}, P, {}\n*NODE PRINT, NSET=BLOCK\nU\n*END STEP\n",
            VESSEL.pressure
        );
        let fixed: usize = supports.iter().map(|(set, _)| mesh.node_sets[*set].len()).sum();
        let unknowns = if around { 2 } else { 3 } * mesh.points.len() - fixed;
        let name = format!("thick_sphere_{}_{n}", element.name().to_lowercase());
        Scene { name, mesh, elements: vec![("BLOCK", element)], cards, unknowns }
    }

    fn errors(&self, scene: &Scene, answer: &Answer) -> Result<Vec<f64>, String> {
        let mesh = &scene.mesh;
        let u = answer.displacements(mesh, "BLOCK")?;
        let exact = |at: [f64; 3]| VESSEL.sphere_at(at);
        let structure = scene.structure(VESSEL.elastic);
        let found = errors(&structure, &u, &exact, &Quadrature::default()).map_err(|error| error.to_string())?;
        // The mean over the nodes on the inner surface.
        let radius = |point: usize| mesh.points[point].iter().map(|x| x * x).sum::<f64>().sqrt();
        let inside: Vec<usize> = (0..u.len()).filter(|&point| radius(point) < VESSEL.inner * (1.0 + 1e-9)).collect();
        let outward = |&point: &usize| (0..3).map(|axis| u[point][axis] * mesh.points[point][axis]).sum::<f64>();
        let mean = inside.iter().map(outward).sum::<f64>() / (inside.len() as f64 * VESSEL.inner);
        Ok(vec![found.energy, found.displacement, mean / VESSEL.sphere(VESSEL.inner).displacement - 1.0])
    }
}

/// A quarter of the section: x is the radius, y the axis.
fn section(element: ElementType, n: usize) -> Mesh {
    let divisions = [n, 3 * n];
    let block = if element == ElementType::CAX3 { Block::tri3(divisions) } else { Block::quad4(divisions) };
    block.mapped(|[through, angle, _]| {
        let r = VESSEL.inner + through * (VESSEL.outer - VESSEL.inner);
        // The end of the quarter lies on the axis itself.
        let (sin, cos) = if angle == 1.0 { (1.0, 0.0) } else { (FRAC_PI_2 * angle).sin_cos() };
        [r * cos, r * sin, 0.0]
    })
}
