//! The law's number times the measure is the force: LINEAR k = 100 at an overclosure of 0.01 everywhere gives the
//! number 1, so that the total force is the measure.

use super::scene::*;
use crate::facet::Vec3;
use crate::interaction::Interaction;
use crate::pair::{Discretization, PairDefinition};
use crate::point::Measure;
use crate::summary::{MeasureKind, Origin};
use crate::surface::Secondary;
use fe_core::Term;
use fe_core::element::ElementType::{self, *};

const BOTH: [Discretization; 2] = [Discretization::NodeToSurface, Discretization::SurfaceToSurface];

/// A unit-rule scene: a block above another, the same mesh in both, overlapping by 0.01.
fn scene(element: ElementType, n: [usize; 3], size: [f64; 3]) -> Scene {
    let mut scene = Scene::default();
    let at = move |r: Vec3, y: f64| Vec3::new(1.0 + size[0] * r.x, r.y + y, size[2] * r.z);
    scene.block(element, n, move |r| at(r, 0.99));
    scene.block(element, n, move |r| at(r, 0.0));
    scene
}

fn definition(scene: &Scene, discretization: Discretization) -> PairDefinition {
    surfaces(scene.faces(0, |r| r[1] == 0.0), scene.faces(1, |r| r[1] == 1.0), discretization)
}

fn total(scene: &Scene, definition: &PairDefinition, interaction: &Interaction) -> f64 {
    let pair = scene.pair(definition, interaction);
    let state = pair.state(&vec![0.0; scene.freedoms().len()], &vec![0.0; pair.history()]);
    assert!(state.points.iter().all(|p| (p.pressure - 1.0).abs() < 1e-12));
    assert!((state.secondary.force[1] + state.main.force[1]).abs() < 1e-12);
    state.secondary.force[1]
}

#[test]
fn a_surface_of_elements_counts_its_area() {
    let space = scene(C3D8, [2, 1, 3], [2.0, 1.0, 2.0]);
    let axisymmetric = scene(CAX4, [3, 1, 0], [1.0, 1.0, 0.0]);
    let mut plane = scene(CPE4, [3, 1, 0], [2.0, 1.0, 0.0]);
    plane.structure.sections.iter_mut().for_each(|s| s.thickness = 3.0);
    for discretization in BOTH {
        for (scene, expected) in [(&space, 4.0), (&plane, 6.0), (&axisymmetric, 9.42477796076938)] {
            let force = total(scene, &definition(scene, discretization), &linear());
            // Sums of fewer than a hundred numbers.
            assert!((force - expected).abs() < 1e-13 * expected, "{discretization:?}: {force} for {expected}");
        }
    }
}

/// The data line of the interaction replaces the thickness of the section.
#[test]
fn the_data_line_gives_the_thickness() {
    let scene = scene(CPE4, [3, 1, 0], [2.0, 1.0, 0.0]);
    let interaction = Interaction { measure: Some(0.5), ..linear() };
    for discretization in BOTH {
        assert!((total(&scene, &definition(&scene, discretization), &interaction) - 1.0).abs() < 1e-13);
    }
}

#[test]
fn nodes_count_their_area_or_one_each() {
    let scene = scene(CPE4, [6, 1, 0], [2.0, 1.0, 0.0]);
    let faces = definition(&scene, Discretization::NodeToSurface);
    let nodes: Vec<u32> = scene.pair(&faces, &linear()).secondary_nodes().to_vec();
    assert_eq!(nodes.len(), 7);
    let of = |area: Option<f64>| {
        let secondary = Secondary::Nodes(nodes.iter().map(|&n| (n, area)).collect());
        PairDefinition { secondary, ..faces.clone() }
    };
    let on_line = Interaction { measure: Some(0.5), ..linear() };
    for (definition, interaction, expected, kind) in [
        (of(None), linear(), 7.0, MeasureKind::Force),
        (of(Some(0.5)), linear(), 3.5, MeasureKind::Pressure),
        (of(None), on_line.clone(), 3.5, MeasureKind::Pressure),
        (of(Some(0.25)), on_line, 1.75, MeasureKind::Pressure),
    ] {
        assert!((total(&scene, &definition, &interaction) - expected).abs() < 1e-13);
        assert_eq!(scene.pair(&definition, &interaction).summary().measure, kind);
    }
    let reverted = PairDefinition { discretization: Discretization::SurfaceToSurface, ..of(None) };
    let pair = scene.pair(&reverted, &linear());
    assert_eq!(pair.summary().origin, Origin::Pair(Discretization::NodeToSurface));
    assert!(pair.notes().iter().any(|n| n.contains("instead of surface to surface")));
    assert!(pair.points.iter().all(|p| p.measure == Measure::Point));
}
