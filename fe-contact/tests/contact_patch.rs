//! A17: two blocks with meshes that do not match, pressed together by a uniform pressure, surface to surface: the
//! pressure passes unchanged, whatever the elements and the meshes.
#![allow(clippy::unwrap_used, non_snake_case)]

mod common;

use fe_contact::Contact;
use fe_contact::interaction::{Enforcement, Interaction, NormalBehavior, Penalty};
use fe_contact::pair::{Discretization, PairDefinition};
use fe_contact::surface::{Main, Secondary};
use fe_core::element::{ElementType, Space};
use fe_core::external::ExternalForces;
use fe_core::load::{LoadKind, unit_forces};
use fe_core::material::{Elastic, Material};
use fe_core::ramp::Ramp;
use fe_core::solid::SolidBlock;
use fe_core::{Section, Structure};
use fe_mesh::generate::Block;
use fe_mesh::{CellKind, Mesh};

const PRESSURE: f64 = 10.0;
const PENALTY: Enforcement = Enforcement::Penalty(Penalty { stiffness: Some(1e5), clearance: 0.0, scale: 1.0 });

/// A block of one kind; up to the third axis for solids.
fn block(kind: CellKind, n: [usize; 3], origin: f64) -> Mesh {
    let (solid, plane) = ([n[0], n[1], n[2]], [n[0], n[2]]);
    let of = match kind {
        CellKind::Hex8 => Block::hex8(solid),
        CellKind::Tet4 => Block::tet4(solid),
        CellKind::Tet10 => Block::tet10(solid),
        CellKind::Quad4 => Block::quad4(plane),
        _ => Block::tri3(plane),
    };
    if kind.dimension() == 3 {
        of.size([2.0, 2.0, 1.0]).origin([0.0, 0.0, origin]).mesh()
    } else {
        of.size([2.0, 1.0, 1.0]).origin([0.0, origin, 0.0]).mesh()
    }
}

struct Patch {
    structure: Structure,
    /// The axis that is pressed.
    axis: usize,
    sides: [&'static str; 2],
}

/// Lower and upper block; their meshes differ.
fn patch(elements: [ElementType; 2], lower: [usize; 3], upper: [usize; 3]) -> Patch {
    let [below, above] = elements;
    let mut mesh = block(below.kind(), lower, 0.0).prefixed("LOW_");
    mesh.append(&block(above.kind(), upper, 1.0).prefixed("UP_"));
    let types = mesh.blocks.iter().map(|b| if b.kind == below.kind() { below } else { above }).collect();
    let section = |element, set: &str| Section {
        element,
        cells: mesh.cell_sets[set].clone(),
        material: 0,
        thickness: if element.space() == Space::Axisymmetric || element.space() == Space::Solid { 1.0 } else { 2.5 },
        hourglass: None,
    };
    let sections = vec![section(below, "LOW_BLOCK"), section(above, "UP_BLOCK")];
    let elastic = Elastic { young: 1000.0, poisson: 0.3 };
    let materials = vec![Material::elastic("M", elastic)];
    let solid = below.space() == Space::Solid;
    let (axis, sides) = if solid { (2, ["ZMIN", "ZMAX"]) } else { (1, ["YMIN", "YMAX"]) };
    Patch { structure: Structure { mesh, elements: types, materials, sections, ..Structure::default() }, axis, sides }
}

/// Largest deviation of any stress component at any integration point, and of any contact pressure, over the pressure;
/// with multipliers of any gap, too, over the size.
fn deviation(patch: &Patch, enforcement: Enforcement) -> f64 {
    let Patch { structure, axis, sides: [low, high] } = patch;
    let mesh = &structure.mesh;
    let freedoms = structure.freedoms(&[]);
    let solids: Vec<SolidBlock> =
        structure.sections.iter().map(|s| SolidBlock::new(structure, s, &freedoms).unwrap()).collect();
    let definition = PairDefinition {
        secondary_name: "UP".into(),
        main_name: "LOW".into(),
        secondary: Secondary::Faces(mesh.surfaces[&format!("UP_{low}")].clone()),
        main: Main::Faces(mesh.surfaces[&format!("LOW_{high}")].clone()),
        interaction: 0,
        discretization: Discretization::SurfaceToSurface,
        small_sliding: true,
        bond: Default::default(),
        adjust: None,
        clearance: None,
    };
    let interaction = Interaction {
        name: "I".into(),
        normal: NormalBehavior::Hard(enforcement),
        no_separation: false,
        friction: None,
        damping: None,
        explicit_damping: None,
        scale_factor: None,
        stabilized_along: false,
        measure: None,
    };
    let pair = Contact::of_pair(structure, &freedoms, &definition, &interaction).unwrap();
    let mut prescribed = Vec::new();
    let mut hold = |node: u32, component: usize| {
        prescribed.extend(freedoms.index(node as usize, component).map(|f| (f, Ramp::constant(0.0))));
    };
    let bottom = &mesh.node_sets[&format!("LOW_{low}")];
    bottom.iter().for_each(|&n| hold(n, *axis));
    let axisymmetric = structure.elements[0].space() == Space::Axisymmetric;
    for body in ["LOW_", "UP_"] {
        // One corner held across, and in space another one against turning; a ring holds itself.
        let floor = &mesh.node_sets[&format!("{body}{low}")];
        let on = |set: &str, n: &u32| mesh.node_sets[&format!("{body}{set}")].binary_search(n).is_ok();
        if *axis == 2 {
            let corner = |x: &str| *floor.iter().find(|n| on(x, n) && on("YMIN", n)).unwrap();
            hold(corner("XMIN"), 0);
            hold(corner("XMIN"), 1);
            hold(corner("XMAX"), 1);
        } else if !axisymmetric {
            hold(*floor.iter().find(|n| on("XMIN", n)).unwrap(), 0);
        }
    }
    let load = LoadKind::Pressure { faces: mesh.surfaces[&format!("UP_{high}")].clone() };
    let unit = unit_forces(&load, structure, &freedoms).unwrap();
    let external = ExternalForces { parts: vec![(unit, Ramp { from: 0.0, to: PRESSURE, amplitude: None })] };
    let (end, _) = common::solve(&freedoms, &solids, &pair, external, prescribed);
    let mut worst: f64 = 0.0;
    for solid in &solids {
        for stress in solid.stresses(&end.u).stress {
            for (c, s) in stress.iter().enumerate() {
                // Plane strain holds the thickness: σzz = ν σyy.
                let held = c == 2 && structure.elements[0].space() == Space::PlaneStrain;
                let exact = if c == *axis {
                    -PRESSURE
                } else if held {
                    -0.3 * PRESSURE
                } else {
                    0.0
                };
                worst = worst.max((s - exact).abs() / PRESSURE);
            }
        }
    }
    let points = pair.state(&end.u, &end.history[end.history.len() - 1]).points;
    assert!(!points.is_empty());
    points.iter().for_each(|p| worst = worst.max((p.pressure - PRESSURE).abs() / PRESSURE));
    if enforcement == Enforcement::Direct {
        // Blocks of height 1: overclosures over the size.
        points.iter().for_each(|p| worst = worst.max(p.opening.abs()));
    }
    worst
}

/// Every element on itself, ratios 3/4, 4/4 and 5/4 (A17's table), both ways round: 1e-10 (class X).
#[test]
fn A17_contact_patch() {
    for element in ElementType::SOLIDS {
        for (below, above) in [(3, 4), (4, 4), (5, 4), (4, 3)] {
            let (lower, upper) = ([below, below, 2], [above, above, 2]);
            let worst = deviation(&patch([element, element], lower, upper), PENALTY);
            assert!(worst < 1e-10, "{} {below}/{above}: {worst:.1e}", element.name());
        }
    }
}

/// By multipliers, too: they are the constant pressure, and no overclosure is left.
#[test]
fn A17_contact_patch_direct() {
    for element in ElementType::SOLIDS {
        for (below, above) in [(3, 4), (5, 4)] {
            let (lower, upper) = ([below, below, 2], [above, above, 2]);
            let worst = deviation(&patch([element, element], lower, upper), Enforcement::Direct);
            assert!(worst < 1e-10, "{} {below}/{above}: {worst:.1e}", element.name());
        }
    }
}

/// Unlike elements on each other.
#[test]
fn A17_contact_patch_of_unlike_elements() {
    use ElementType::*;
    for pair in [[C3D8, C3D10], [C3D10, C3D8], [C3D4, C3D8], [C3D10, C3D4], [CPE3, CPE4], [CAX4, CAX3], [CPS4, CPS3]] {
        let worst = deviation(&patch(pair, [3, 4, 2], [4, 5, 1]), PENALTY);
        assert!(worst < 1e-10, "{} on {}: {worst:.1e}", pair[1].name(), pair[0].name());
    }
}

/// D33: one element against a hundred along the interface, and 97 against 89: 1e-9.
#[test]
fn D33_mesh_contrast() {
    use ElementType::*;
    for (element, lower, upper) in [
        (CPE4, [1, 1, 1], [100, 1, 1]),
        (CPE4, [100, 1, 1], [1, 1, 1]),
        (CPE3, [97, 1, 1], [89, 1, 1]),
        (C3D8, [1, 1, 1], [100, 1, 1]),
        (C3D10, [25, 1, 1], [1, 1, 1]),
    ] {
        let worst = deviation(&patch([element, element], lower, upper), PENALTY);
        assert!(worst < 1e-9, "{} {lower:?} {upper:?}: {worst:.1e}", element.name());
    }
}
