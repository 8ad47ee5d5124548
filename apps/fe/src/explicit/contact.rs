//! Contact pairs of a model as explicit steps take them.

use super::scene::Scene;
use crate::job::JobFailure;
use crate::number::scientific;
use fe_contact::explicit::{
    Behaviour, ContactPair, Definition, Enforcement, MainSurface, Normal, PairSides, RigidFollower, Secondary,
    Separation, Unsettled,
};
use fe_contact::facet::{Facet, Rules, Vec3};
use fe_contact::friction::{Coulomb, Friction, Spring, Stick};
use fe_contact::interaction::{Interaction, NormalBehavior};
use fe_contact::pair::{ExplicitPair, MechanicalConstraint};
use fe_contact::summary::MeasureKind;
use fe_contact::surface::{self, Main};
use fe_contact::viscous::DampingAmount;
use fe_core::element::Family;
use fe_core::structure::Structure;
use fe_io::Model;
use fe_io::model::{ActivePair, Place, RigidBody, Step};
use fe_mesh::Face;
use std::collections::BTreeMap;

/// The bodies whose facets may be main surfaces.
pub fn followers(structure: &Structure, bodies: &[RigidBody]) -> Vec<RigidFollower> {
    let follower = |body: &RigidBody| {
        let mut nodes: Vec<u32> = body.cells.iter().flat_map(|&cell| structure.mesh.cell(cell)).copied().collect();
        nodes.sort_unstable();
        nodes.dedup();
        RigidFollower { reference: body.reference, nodes }
    };
    bodies.iter().map(follower).collect()
}

/// Refuses what a step asks for that is not there yet.
pub fn refuse_the_rest(model: &Model, step: &Step) -> Result<(), JobFailure> {
    let refuse = |place: &Place, what: &str, help: &str| {
        let Place { file, line } = place;
        Err(JobFailure::Deck(format!(
            "error: {what} not there yet in explicit steps\n --> {file}:{line}\nhelp: {help}"
        )))
    };
    if let Some(general) = &step.general_contact {
        if model.structure.is_plane() {
            return refuse(&step.place, "general contact (*CONTACT) of plane models is", "use *CONTACT PAIR");
        }
        let interactions = general.interactions.iter().map(|(_, interaction)| &model.interactions[*interaction]);
        if let Some(interaction) = interactions.into_iter().find(|interaction| interaction.no_separation) {
            let what = format!("NO SEPARATION of interaction {} in general contact is", interaction.name);
            return refuse(&step.place, &what, "leave it out");
        }
    }
    for active in &step.explicit_pairs {
        let (pair, place) = &model.explicit_pairs[active.pair];
        let interaction = active.interaction.map(|i| &model.interactions[i]);
        if pair.constraint == MechanicalConstraint::Kinematic {
            if let Some(body) = rigid_on_rigid(model, pair) {
                let node = model.structure.mesh.point_name(body);
                let what = format!(
                    "kinematic contact of two rigid bodies (node {node} is of one, and so is the main side) is"
                );
                return refuse(place, &what, "say MECHANICAL CONSTRAINT=PENALTY");
            }
            let is_hard = interaction.is_none_or(|i| matches!(i.normal, NormalBehavior::Hard(_)));
            let damping = interaction.and_then(|i| i.explicit_damping).filter(|damping| !is_without(damping.amount));
            if is_hard && damping.is_some() {
                let help = "leave *CONTACT DAMPING out, or use MECHANICAL CONSTRAINT=PENALTY or a softened law";
                return refuse(
                    place,
                    "damping of hard kinematic contact, which takes the energy of what hits, is",
                    help,
                );
            }
        }
    }
    Ok(())
}

/// A node of a rigid body on the first surface, where the second one is rigid, too.
fn rigid_on_rigid(model: &Model, pair: &ExplicitPair) -> Option<u32> {
    let structure = &model.structure;
    let is_rigid = match &pair.main {
        Main::Faces(faces) => faces.iter().any(|face| family(structure, face) == Family::Rigid),
        Main::Rigid { .. } => true,
    };
    let bodies = followers(structure, &model.rigid_bodies);
    let follows = |node: u32| bodies.iter().any(|b| b.reference == node || b.nodes.binary_search(&node).is_ok());
    let own = secondary(structure, &pair.secondary).nodes;
    own.into_iter().map(|node| node.0).find(|&node| is_rigid && follows(node))
}

fn family(structure: &Structure, face: &Face) -> Family {
    structure.elements[face.cell.block as usize].family()
}

/// What is to be said of the pairs at the end of a step.
pub fn unsettled(scene: &mut Scene) -> Vec<String> {
    let mut notes = Vec::new();
    for pair in scene.pairs.iter_mut().flat_map(|(_, sides)| &mut sides.pairs) {
        let Unsettled { increments, change } = pair.take_unsettled();
        if increments > 0 {
            let change = scientific(change, 2);
            let name = pair.label();
            notes.push(format!(
                "warning: contact {name}: in {increments} increments the impulses of its nodes were not found to the last digit; \
                 gaps are off by up to {change}"
            ));
        }
    }
    notes
}

/// The pairs that act in a step; where both sides may be either, both are, each for its part.
pub fn sides(scene: &Scene, model: &Model, active: &ActivePair) -> PairSides {
    let pair = &model.explicit_pairs[active.pair].0;
    let interaction = active.interaction.map(|i| &model.interactions[i]);
    let first_is_main = weight(&scene.structure, pair);
    let mut out = Vec::new();
    if first_is_main < 1.0 {
        let main = match &pair.main {
            Main::Faces(faces) => faces_of(scene, faces),
            Main::Rigid { surface, reference } => {
                MainSurface::Rigid { surface: surface.clone(), reference: *reference }
            }
        };
        let names = [&pair.secondary_name, &pair.main_name];
        out.push((names, secondary(&scene.structure, &pair.secondary), main, 1.0 - first_is_main));
    }
    if let (surface::Secondary::Faces(first), Main::Faces(second)) = (&pair.secondary, &pair.main)
        && first_is_main > 0.0
    {
        let nodes = secondary(&scene.structure, &surface::Secondary::Faces(second.clone()));
        out.push(([&pair.main_name, &pair.secondary_name], nodes, faces_of(scene, first), first_is_main));
    }
    let build = |([own, other], mut nodes, main, part): ([&String; 2], Secondary, MainSurface, f64)| {
        nodes.nodes.iter_mut().for_each(|node| node.1 *= part);
        let name = format!("{own} on {other}");
        let enforcement = match pair.constraint {
            MechanicalConstraint::Penalty => Enforcement::Penalty(part * active.scale_penalty),
            MechanicalConstraint::Kinematic => Enforcement::Kinematic(part),
        };
        let mut behaviour = behaviour(interaction);
        if pair.constraint == MechanicalConstraint::Kinematic && matches!(behaviour.normal, Normal::Hard) {
            behaviour.damping = None;
        }
        let definition = Definition { name, secondary: nodes, main, behaviour, enforcement };
        ContactPair::new(&scene.structure, &scene.freedoms, definition, &scene.followers)
    };
    PairSides { pairs: out.into_iter().map(build).collect() }
}

/// What an interaction says; without one contact is hard and slides freely.
pub fn behaviour(interaction: Option<&Interaction>) -> Behaviour {
    let normal = match interaction.map(|i| &i.normal) {
        Some(NormalBehavior::Softened(law)) => Normal::Softened(law.clone()),
        Some(NormalBehavior::Hard(_)) | None => Normal::Hard,
    };
    let never = interaction.is_some_and(|i| i.no_separation);
    let spring = Spring::Stiffness(if let Normal::Softened(law) = &normal { law.typical_stiffness() } else { 1.0 });
    let mut shear_slope = None;
    let friction = interaction.and_then(|i| i.friction.as_ref()).map(|friction| match friction {
        Friction::Coulomb { coefficient, largest, stick } => {
            if let Stick::Slope(slope) = stick {
                shear_slope = Some(*slope);
            }
            Coulomb { limit: Some((coefficient.clone(), *largest)), spring }
        }
        Friction::Rough => Coulomb { limit: None, spring },
    });
    Behaviour {
        normal,
        separation: if never { Separation::Never } else { Separation::Allowed },
        friction,
        shear_slope,
        damping: Some(interaction.and_then(|i| i.explicit_damping).unwrap_or_default()),
    }
}

fn is_without(damping: DampingAmount) -> bool {
    let (DampingAmount::Coefficient(amount) | DampingAmount::CriticalFraction(amount)) = damping;
    amount == 0.0
}

/// What the law's number is at the points of a pair.
pub fn kind(secondary: &surface::Secondary) -> MeasureKind {
    match secondary {
        surface::Secondary::Faces(_) => MeasureKind::Pressure,
        surface::Secondary::Lines(_) => MeasureKind::ForcePerLength,
        surface::Secondary::Nodes(_) => MeasureKind::Force,
    }
}

/// WEIGHT=, or what is usual: half and half for the faces of two deformable bodies. Where one side alone can be secondary (nodes
/// and lines have no faces, an analytical surface has no nodes, and kinematic contact does not move what is rigid) it is the
/// first one.
pub fn weight(structure: &Structure, pair: &ExplicitPair) -> f64 {
    let (surface::Secondary::Faces(first), Main::Faces(second)) = (&pair.secondary, &pair.main) else { return 0.0 };
    let deformable = |faces: &[Face]| faces.iter().all(|face| family(structure, face) == Family::Solid);
    match (deformable(first) && deformable(second), pair.constraint) {
        (true, _) => pair.weight.unwrap_or(0.5),
        (false, MechanicalConstraint::Penalty) => pair.weight.unwrap_or(0.0),
        (false, MechanicalConstraint::Kinematic) => 0.0,
    }
}

fn faces_of(scene: &Scene, faces: &[Face]) -> MainSurface {
    let corners = |&face: &Face| {
        let facet = Facet::new(&scene.structure, face, None, &Vec3::zeros());
        facet.nodes()[..facet.corners()].to_vec()
    };
    MainSurface::Faces(faces.iter().map(corners).collect())
}

/// Nodes with the area of the faces around them that the corners' hat functions give them; the length of lines; or 1.
fn secondary(structure: &Structure, side: &surface::Secondary) -> Secondary {
    let mesh = &structure.mesh;
    let mut measures: BTreeMap<u32, f64> = BTreeMap::new();
    match side {
        surface::Secondary::Faces(faces) => {
            let rules = Rules::new(3);
            for &face in faces {
                let facet = Facet::new(structure, face, None, &Vec3::zeros());
                for &([xi, eta, _], w) in rules.of(&facet) {
                    let xi = [xi, eta];
                    let area = facet.area_vector(xi).norm() * w * facet.factor(&facet.position(xi));
                    let corners = facet.nodes()[..facet.corners()].iter().zip(facet.hats(xi));
                    corners.for_each(|(&n, hat)| *measures.entry(n).or_default() += area * hat);
                }
            }
        }
        surface::Secondary::Lines(cells) => {
            for &cell in cells {
                let nodes = mesh.cell(cell);
                let [a, b] = [0, 1].map(|i| Vec3::from(mesh.points[nodes[i] as usize]));
                nodes[..2].iter().for_each(|&n| *measures.entry(n).or_default() += 0.5 * (b - a).norm());
            }
        }
        surface::Secondary::Nodes(list) => measures.extend(list.iter().map(|node| (node.0, 1.0))),
    }
    Secondary { nodes: measures.into_iter().collect(), kind: kind(side) }
}
