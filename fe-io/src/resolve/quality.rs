//! Checks of the bodies as a whole.

use super::scene::{Analysis, Scene};
use crate::diagnostic::{Diagnostic, Diagnostics};
use fe_core::element::{ElementType, Family, Space};
use fe_core::{member, solid};
use fe_mesh::CellId;

/// Above this Poisson's ratio constant-strain elements are far too stiff.
const NEARLY_INCOMPRESSIBLE: f64 = 0.49;

/// Plane and solid elements do not mix, nor plane and axisymmetric ones; plane nodes have z = 0.
pub fn spaces(scene: &mut Scene<'_>, diagnostics: &mut Diagnostics) {
    let kind = |space: Space| match space {
        Space::Solid => "three-dimensional",
        Space::PlaneStrain | Space::PlaneStress | Space::Plane => "plane",
        Space::Axisymmetric => "axisymmetric",
        Space::Any => "of any space",
    };
    let blocks = &scene.structure.mesh.blocks;
    let placed = |(i, element): &(usize, &ElementType)| !blocks[*i].is_empty() && element.space() != Space::Any;
    let mut used = scene.structure.elements.iter().enumerate().filter(placed);
    if let Some((first, element)) = used.next() {
        let other = used.find(|(_, other)| kind(other.space()) != kind(element.space()));
        if let Some((block, other)) = other {
            let cell = |block: usize| scene.place_of(CellId { block: block as u32, cell: 0 });
            let title = format!(
                "{} elements are {}, {} elements are {}: they do not mix",
                element.name(),
                kind(element.space()),
                other.name(),
                kind(other.space())
            );
            if let (Some(at), Some(before)) = (cell(block), cell(first)) {
                let fault = Diagnostic::error(at, title).label(other.name());
                diagnostics.push(fault.related(before, element.name()));
            }
        }
    }
    if scene.structure.is_plane() {
        let off = scene.structure.mesh.points.iter().position(|point| point[2] != 0.0);
        if let Some(node) = off {
            let title = format!("node {} of a plane model has z ≠ 0", scene.node_name(node as u32));
            diagnostics.push(Diagnostic::warning(scene.node_places[node], title).label("taken as 0"));
        }
        scene.structure.mesh.points.iter_mut().for_each(|point| point[2] = 0.0);
    }
}

/// Freedoms of all nodes; a reference node belongs to no element.
pub fn freedoms(scene: &mut Scene<'_>, diagnostics: &mut Diagnostics) {
    let mut masks = scene.structure.masks();
    if scene.incomplete {
        let all = masks.iter().fold(scene.structure.rigid_mask(), |all, mask| all | mask);
        masks.fill(all);
    }
    for (body, at) in &scene.rigid_bodies {
        let reference = body.reference;
        if masks[reference as usize] != 0 && !scene.incomplete && carries(reference, scene) {
            let title = format!("node {} belongs to elements", scene.node_name(reference));
            let place =
                body.surface.as_ref().and_then(|surface| scene.surfaces.get(surface)).map_or(*at, |(_, at)| *at);
            let fault = Diagnostic::error(place, title);
            diagnostics.push(fault.label("the reference node of a rigid surface stands alone"));
        }
        masks[reference as usize] |= scene.structure.rigid_mask();
    }
    scene.masks = masks;
}

/// True when a node belongs to elements that a rigid body cannot carry at its reference node: in explicit steps it carries
/// masses, springs and dashpots.
fn carries(node: u32, scene: &Scene<'_>) -> bool {
    let light = |family| {
        matches!(family, Family::Mass | Family::RotaryInertia | Family::Spring | Family::Dashpot | Family::Rigid)
    };
    let elements = scene.structure.mesh.blocks.iter().zip(&scene.structure.elements);
    let heavy = |(_, element): &(_, &ElementType)| scene.analysis == Analysis::Static || !light(element.family());
    elements.filter(heavy).any(|(block, _)| block.nodes.contains(&node))
}

/// Solids, trusses and beams with the same nodes are told; springs and the like share them as they need.
pub fn twins(scene: &Scene<'_>, diagnostics: &mut Diagnostics) {
    let mesh = &scene.structure.mesh;
    let sorted = |cell: CellId| {
        let mut nodes = mesh.cell(cell).to_vec();
        nodes.sort_unstable();
        nodes
    };
    // The sum and the least node tell most elements apart; only those alike are compared.
    let key = |cell: CellId| {
        let nodes = mesh.cell(cell);
        let sum: u64 = nodes.iter().map(|&n| (u64::from(n) + 1).wrapping_mul(0x9E37_79B9_7F4A_7C15) >> 20).sum();
        (nodes.iter().min().copied().unwrap_or(0), sum)
    };
    let body = |cell: &CellId| matches!(scene.element_of(*cell).family(), Family::Solid | Family::Truss | Family::Beam);
    let mut keys: Vec<((u32, u64), CellId)> = mesh.cells().filter(body).map(|cell| (key(cell), cell)).collect();
    keys.sort_unstable();
    for pair in keys.windows(2).filter(|pair| pair[0].0 == pair[1].0) {
        let (first, second) = (pair[0].1, pair[1].1);
        if sorted(first) == sorted(second)
            && let Some(at) = scene.place_of(second)
        {
            let [a, b] = [first, second].map(|cell| scene.cell_name(cell));
            let warning = Diagnostic::warning(at, format!("elements {a} and {b} have the same nodes"));
            let other = scene.place_of(first).filter(|other| *other != at);
            diagnostics.push(match other {
                Some(other) => warning.related(other, "the other one").label("both carry load"),
                None => warning.label("both carry load"),
            });
        }
    }
}

/// Lines and springs that have no stiffness.
pub fn members(scene: &Scene<'_>, diagnostics: &mut Diagnostics) {
    let structure = &scene.structure;
    let lines = structure.lines.iter().map(|section| member::check(structure, section));
    let springs = structure.discrete.iter().filter(|section| section.element == ElementType::SPRINGA);
    let springs = springs.map(|section| member::check_springs(structure, section));
    for bad in lines.chain(springs).filter_map(Result::err) {
        let fault = scene.place_of(bad.cell).map(|at| Diagnostic::error(at, bad.to_string()));
        fault.into_iter().for_each(|fault| diagnostics.push(fault));
    }
}

/// Elements that cannot be integrated, and materials that do not suit their elements.
pub fn elements(scene: &Scene<'_>, diagnostics: &mut Diagnostics) {
    for section in &scene.structure.sections {
        match solid::check(&scene.structure.mesh, section) {
            Err(bad) => {
                let fault = scene.place_of(bad.cell).map(|at| Diagnostic::error(at, bad.to_string()));
                fault.into_iter().for_each(|fault| diagnostics.push(fault));
            }
            Ok(folded) => folded.iter().for_each(|corner| {
                if let Some(at) = scene.place_of(corner.cell) {
                    let warning = Diagnostic::warning(at, corner.to_string());
                    diagnostics.push(warning.label("sound at its integration points, so it is computed as it is"));
                }
            }),
        }
        let material = &scene.structure.materials[section.material];
        let constant_strain = matches!(section.element, ElementType::C3D4 | ElementType::CPE3 | ElementType::CAX3);
        if constant_strain
            && material.response.elastic().poisson > NEARLY_INCOMPRESSIBLE
            && let Some(at) = section.cells.first().and_then(|&cell| scene.place_of(cell))
        {
            let title = format!(
                "{} elements are far too stiff at a Poisson's ratio of {}",
                section.element.name(),
                material.response.elastic().poisson
            );
            let warning = Diagnostic::warning(at, title);
            diagnostics.push(warning.help("above 0.49 take C3D8, C3D10, CPE4 or CAX4"));
        }
    }
}
