//! Edges and vertices, noise, faces listed twice, wrong sides, deep overlaps, adjustment and first contact.

use super::scene::*;
use crate::adjust::adjust;
use crate::contact::Contact;
use crate::error::PairError;
use crate::facet::Vec3;
use crate::first_contact::{Rest, RigidContact};
use crate::interaction::{Enforcement, Interaction, NormalBehavior, Penalty};
use crate::pair::{Adjust, Discretization, PairDefinition};
use crate::surface::{Main, Secondary};
use fe_core::Term;
use fe_core::element::ElementType::*;

use Discretization::{NodeToSurface, SurfaceToSurface};

/// A cube [0,1]³ of 2 × 2 × 2 cells as main surface (its whole skin), and a free node.
fn cube_and_node(at: [f64; 3]) -> (Scene, PairDefinition) {
    let mut scene = Scene::default();
    scene.block(C3D8, [2, 2, 2], |r| r);
    let node = scene.node(at);
    let mut pair = surfaces(Vec::new(), scene.skin(0), NodeToSurface);
    pair.secondary = Secondary::Nodes(vec![(node, None)]);
    (scene, pair)
}

/// Above the middle of a facet, an inner edge, an inner vertex, an outer edge, an outer vertex, and by noise beside
/// them: one contact with the force along z, also with the facets in reverse order.
#[test]
fn edges_and_vertices_give_one_contact() {
    for place in [[0.25, 0.25], [0.5, 0.25], [0.5, 0.5], [1.0, 0.25], [1.0, 1.0], [0.0, 1.0]] {
        for noise in [0.0, 1e-16, -1e-16, 1e-12, -1e-12] {
            let (scene, mut definition) = cube_and_node([place[0] + noise, place[1] - noise, 1.0 - 0.01]);
            let mut states = Vec::new();
            for _ in 0..2 {
                let freedoms = scene.structure.freedoms(&[27]);
                let pair = Contact::of_pair(&scene.structure, &freedoms, &definition, &linear()).unwrap();
                assert_eq!(pair.points.len(), 1, "{place:?}");
                let state = pair.state(&vec![0.0; freedoms.len()], &vec![0.0; pair.history()]);
                let force = Vec3::from(state.secondary.force);
                let aside = place.iter().all(|x| (0.1..0.9).contains(x));
                // Overlapping an outer edge by 0.01 from above and by nothing from the side, the side is nearest.
                if aside {
                    assert!((force - Vec3::z()).norm() < 1e-10, "{place:?}: {force}");
                }
                states.push(force);
                if let Main::Faces(faces) = &mut definition.main {
                    faces.reverse();
                }
            }
            assert!((states[0] - states[1]).norm() < 1e-12);
        }
    }
    for place in [[1.0, 0.25], [1.0, 1.0], [0.0, 1.0]] {
        for noise in [0.0, 1e-16, -1e-16, 1e-12, -1e-12] {
            let (scene, definition) = cube_and_node([place[0] + noise, place[1] - noise, 1.03]);
            let freedoms = scene.structure.freedoms(&[27]);
            let pair = Contact::of_pair(&scene.structure, &freedoms, &definition, &linear()).unwrap();
            assert_eq!(pair.points.len(), 1);
            assert!((pair.points[0].gap - 0.03).abs() < 1e-11 && (pair.points[0].normal[2] - 1.0).abs() < 1e-11);
        }
    }
}

fn stacked(gap: f64, noise: f64) -> Scene {
    let mut scene = Scene::default();
    let mut next = numbers(3);
    scene.block(C3D8, [3, 2, 3], |r| Vec3::new(r.x, 1.0 + gap + r.y, r.z));
    scene.block(C3D8, [3, 2, 3], |r| r);
    for p in &mut scene.structure.mesh.points {
        p.iter_mut().for_each(|x| *x += noise * next());
    }
    scene
}

/// Whole skins as surfaces, exactly touching, with and without noise: only the interface is in contact, every point
/// touches, the areas are those of the interface.
#[test]
fn touching_skins_meet_at_the_interface_only() {
    for discretization in [SurfaceToSurface, NodeToSurface] {
        for noise in [0.0, 1e-16, 1e-15] {
            let scene = stacked(0.0, noise);
            let pair = scene.pair(&surfaces(scene.skin(0), scene.skin(1), discretization), &linear());
            assert_eq!(pair.points.len(), 16, "{discretization:?} {noise}");
            assert!(pair.points.iter().all(|p| p.gap.abs() < 1e-14 && (p.normal[1] - 1.0).abs() < 1e-12));
            if discretization == SurfaceToSurface {
                let area: f64 = pair.points.iter().map(|p| p.measure.value()).sum();
                assert!((area - 1.0).abs() < 1e-13);
            }
        }
    }
}

#[test]
fn faces_listed_twice_and_inner_faces_count_as_they_should() {
    let scene = stacked(-0.01, 0.0);
    let (secondary, main) = (scene.faces(0, |r| r[1] == 0.0), scene.faces(1, |r| r[1] == 1.0));
    let once = scene.pair(&surfaces(secondary.clone(), main.clone(), SurfaceToSurface), &linear());
    let twice = |f: &[fe_mesh::Face]| [f, f].concat();
    let pair = scene.pair(&surfaces(twice(&secondary), twice(&main), SurfaceToSurface), &linear());
    assert_eq!(pair.points, once.points);
    assert_eq!(pair.notes().iter().filter(|n| n.contains("count once")).count(), 2);
    let inner = [main, scene.faces(1, |r| r[1] == 0.5)].concat();
    let pair = scene.pair(&surfaces(secondary, inner, SurfaceToSurface), &linear());
    assert_eq!(pair.points, once.points);
    assert!(pair.notes().iter().any(|n| n.contains("18 faces lie inside")), "{:?}", pair.notes());
}

/// Of two plates one behind the other the nearer counts, once, and this is said.
#[test]
fn the_nearest_of_two_layers_counts() {
    let mut scene = stacked(0.1, 0.0);
    scene.block(C3D4, [2, 1, 2], |r| Vec3::new(1.5 * r.x - 0.2, 1.02 + 0.03 * r.y, 1.5 * r.z - 0.2));
    let main = [scene.faces(1, |r| r[1] == 1.0), scene.faces(2, |r| r[1] == 1.0)].concat();
    let pair = scene.pair(&surfaces(scene.faces(0, |r| r[1] == 0.0), main, SurfaceToSurface), &linear());
    let area: f64 = pair.points.iter().map(|p| p.measure.value()).sum();
    assert!((area - 1.0).abs() < 1e-12 && pair.points.iter().all(|p| (p.gap - 0.05).abs() < 1e-13));
    assert!(pair.notes().iter().any(|n| n.contains("several layers")));
}

/// Whole skins of a wide block set 1e-3 deep into a narrow one: the sides that look at each other through the bodies
/// are no overlap.
#[test]
fn sides_seen_through_a_body_are_no_overlap() {
    for (low, width) in [(-0.5, 2.0), (0.0, 2.0), (-1.0, 2.0), (0.1, 0.5)] {
        let mut scene = Scene::default();
        scene.block(C3D8, [4, 2, 4], |r| Vec3::new(low + width * r.x, 0.999 + r.y, low + width * r.z));
        scene.block(C3D8, [3, 2, 3], |r| r);
        let pair = scene.pair(&surfaces(scene.skin(0), scene.skin(1), SurfaceToSurface), &linear());
        let width = (low + width).min(1.0) - f64::max(low, 0.0);
        let area: f64 = pair.points.iter().filter(|p| (p.gap + 1e-3).abs() < 1e-12).map(|p| p.measure.value()).sum();
        assert!((area - width * width).abs() < 1e-12, "{low} {area}");
    }
}

/// Overlaps up to half a facet (1/6 here) are taken as they are; deeper ones are refused, naming the node.
#[test]
fn overlaps_are_believed_up_to_half_a_facet() {
    for discretization in [SurfaceToSurface, NodeToSurface] {
        for overlap in [1e-14, 1e-9, 1e-3, 1.0 / 6.0] {
            let scene = stacked(-overlap, 0.0);
            let pair = scene.pair(&surfaces(scene.skin(0), scene.skin(1), discretization), &linear());
            assert!(pair.points.iter().filter(|p| p.normal[1] > 0.99).all(|p| (p.gap + overlap).abs() < 1e-14));
            // What is more than round-off is told, and warned of above a tenth of a facet.
            let told = pair.notes().iter().find(|note| note.contains("begin inside"));
            assert_eq!(told.is_some(), overlap > 1e-6, "{overlap}");
            assert_eq!(told.is_some_and(|note| note.starts_with("warning: ")), overlap > 0.1, "{told:?}");
        }
        let mut scene = stacked(-0.1, 0.0);
        let deep = scene.structure.mesh.points.iter().position(|p| *p == [1.0, 0.9, 1.0]).unwrap() as u32;
        let faces = (scene.faces(0, |r| r[1] == 0.0), scene.faces(1, |r| r[1] == 1.0));
        for (i, p) in scene.structure.mesh.points.iter_mut().enumerate().take(48) {
            p[1] -= if i as u32 == deep { 0.8 } else { 0.4 };
        }
        let definition = surfaces(faces.0, faces.1, discretization);
        let fault = Contact::of_pair(&scene.structure, &scene.freedoms(), &definition, &linear()).unwrap_err();
        let PairError::TooDeep { ref node, depth, limit, .. } = fault else { panic!("{fault}") };
        assert!(
            *node == scene.structure.mesh.point_name(deep) && depth > 0.5 && (limit - 1.0 / 6.0).abs() < 0.02,
            "{fault}"
        );
    }
}

#[test]
fn what_cannot_be_paired_is_named() {
    let scene = stacked(0.0, 0.0);
    let build = |scene: &Scene, d: &PairDefinition, i: &Interaction| {
        Contact::of_pair(&scene.structure, &scene.freedoms(), d, i)
    };
    let (top, side) = (scene.faces(1, |r| r[1] == 1.0), scene.faces(1, |r| r[0] == 0.0));
    let shared = build(&scene, &surfaces(top.clone(), side, SurfaceToSurface), &linear()).unwrap_err();
    assert!(matches!(shared, PairError::SharedNode { .. }));
    let empty = build(&scene, &surfaces(Vec::new(), top, SurfaceToSurface), &linear()).unwrap_err();
    assert_eq!(empty, PairError::Empty { surface: "S".into() });
    let mut quadratic = Scene::default();
    quadratic.block(C3D10, [1, 1, 1], |r| r + Vec3::y());
    quadratic.block(C3D8, [1, 1, 1], |r| r);
    let pair = surfaces(quadratic.faces(0, |r| r[1] == 0.0), quadratic.faces(1, |r| r[1] == 1.0), NodeToSurface);
    let fault = build(&quadratic, &pair, &linear()).unwrap_err();
    assert!(fault.to_string().contains("use TYPE=SURFACE TO SURFACE"), "{fault}");
}

fn hard(stiffness: Option<f64>) -> Interaction {
    let normal = NormalBehavior::Hard(Enforcement::Penalty(Penalty { stiffness, clearance: 0.02, scale: 2.0 }));
    Interaction { normal, ..linear() }
}

/// k_e = min M/l over the sides: M = E (1−ν)/((1+ν)(1−2ν)) = 1000 · 0.7/0.52, l = 1/2; the default is ten times it.
#[test]
fn the_default_penalty_comes_from_the_elements_beneath() {
    let scene = stacked(0.0, 0.0);
    let definition = surfaces(scene.faces(0, |r| r[1] == 0.0), scene.faces(1, |r| r[1] == 1.0), SurfaceToSurface);
    let summary = scene.pair(&definition, &hard(None)).summary();
    let beneath = 1000.0 * 0.7 / 0.52 / 0.5;
    assert!((summary.beneath.unwrap() / beneath - 1.0).abs() < 1e-12);
    let penalty = summary.penalty.unwrap();
    assert!((penalty.stiffness / (20.0 * beneath) - 1.0).abs() < 1e-12 && penalty.by_default);
    let given = scene.pair(&definition, &hard(Some(5.0))).summary().penalty.unwrap();
    assert!(given.stiffness == 10.0 && !given.by_default);
}

#[test]
fn adjusted_nodes_lie_on_the_main_surface() {
    let scene = stacked(0.03, 0.0);
    let top = scene.faces(1, |r| r[1] == 1.0);
    let mut definition = surfaces(scene.faces(0, |r| r[1] == 0.0), top, SurfaceToSurface);
    let moves = |d: &PairDefinition| adjust(&scene.structure, std::slice::from_ref(d), &[linear()]).unwrap();
    assert_eq!(moves(&definition), []);
    definition.adjust = Some(Adjust::Within(0.02));
    assert_eq!(moves(&definition), []);
    definition.adjust = Some(Adjust::Within(0.04));
    let all = moves(&definition);
    assert_eq!(all.len(), 16);
    assert!(all.iter().all(|m| (m.to[1] - 1.0).abs() < 1e-15 && (m.gap - 0.03).abs() < 1e-15));
    definition.adjust = Some(Adjust::Nodes(vec![all[3].node]));
    assert_eq!(moves(&definition), [all[3]]);
}

/// A block above another by 0.3: down by 0.3 less the clearance until they meet, never when it goes up or sideways.
#[test]
fn a_body_is_moved_until_it_is_met() {
    let scene = stacked(0.3, 0.0);
    let definition = surfaces(scene.faces(0, |r| r[1] == 0.0), scene.faces(1, |r| r[1] == 1.0), SurfaceToSurface);
    let (freedoms, nodes) = (scene.freedoms(), 48);
    let motion = |c: usize, by: f64| -> Vec<f64> {
        let moves = |f: &usize| freedoms.component(*f) == c && freedoms.node(*f) < nodes;
        (0..freedoms.len()).map(|f| if moves(&f) { by } else { 0.0 }).collect()
    };
    let rest = vec![0.0; freedoms.len()];
    for (interaction, expected) in [(linear(), 0.3), (hard(None), 0.28)] {
        let pairs = [scene.pair(&definition, &interaction)];
        let both = |u: &[f64]| RigidContact::new(&pairs, u, [motion(0, 1.0), motion(1, 1.0)].into_iter());
        let down = |u: &[f64]| match both(u).settle(&[0.0, -3.0]) {
            Rest::At(moved) => -moved[1],
            Rest::Nowhere(_) => f64::NAN,
        };
        assert!((down(&rest) - expected).abs() < 1e-14);
        assert!((down(&motion(1, -0.2)) - (expected - 0.2)).abs() < 1e-14);
        assert!(matches!(both(&rest).settle(&[0.0, 1.0]), Rest::Nowhere(_)));
        assert_eq!(both(&rest).unheld().len(), 1);
    }
}
