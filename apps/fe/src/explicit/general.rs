//! General contact of a model as explicit steps take it: its faces in classes, and what acts between two of them.

use super::contact::behaviour;
use super::scene::Scene;
use fe_contact::explicit::{
    Acting, Adjusted, Behaviour, Between, GeneralContact, GeneralDefinition, GeneralFace, Normal, RigidFollower, Sides,
    adjust,
};
use fe_contact::facet::{Facet, Vec3};
use fe_contact::pair::{self, Region};
use fe_contact::surface::{Main, Secondary};
use fe_core::Freedoms;
use fe_core::element::Family;
use fe_core::structure::Structure;
use fe_io::Model;
use fe_io::model::Step;
use fe_mesh::{Face, Mesh, exterior};
use std::collections::{BTreeMap, BTreeSet, HashMap};
use std::sync::Arc;

/// What it is called.
pub const NAME: &str = "general contact";

/// The general contact of a step; `None` where it has none, or nothing may touch.
pub fn general(scene: &Scene, model: &Model, step: &Step) -> Option<GeneralContact> {
    let definition = definition(&scene.structure, model, step)?;
    Some(GeneralContact::new(&scene.structure, &scene.freedoms, &definition, &scene.followers))
}

/// Moves nodes out of the overclosures that general contact of the first step begins with.
pub fn adjusted(
    structure: &mut Arc<Structure>,
    freedoms: &Freedoms,
    model: &Model,
    followers: &[RigidFollower],
) -> Option<Adjusted> {
    let definition = definition(structure, model, model.steps.first()?)?;
    let mut moved = Structure::clone(structure);
    let adjusted = adjust(&mut moved, freedoms, &definition, followers)?;
    *structure = Arc::new(moved);
    Some(adjusted)
}

fn definition(structure: &Structure, model: &Model, step: &Step) -> Option<GeneralDefinition> {
    let contact = step.general_contact.as_ref()?;
    let faces = Faces::new(structure, contact, &pairs(model, step));
    let classes = faces.classes.len();
    let table: Vec<Vec<Between>> =
        (0..classes).map(|one| (0..classes).map(|other| faces.between(contact, one, other)).collect()).collect();
    let may_touch = |class: u16| table[usize::from(class)].iter().any(|between| matches!(between, Between::Acting(_)));
    let of = |(face, class): (&Face, &u16)| {
        let facet = Facet::new(structure, *face, None, &Vec3::zeros());
        let sides = if is_rigid(structure, face) { Sides::Both } else { Sides::Outer };
        GeneralFace { nodes: facet.nodes()[..facet.corners()].to_vec(), sides, class: *class }
    };
    let faces: Vec<GeneralFace> = faces.class_of.iter().filter(|(_, class)| may_touch(**class)).map(of).collect();
    if faces.is_empty() {
        return None;
    }
    let smallest = smallest(structure, &faces);
    let assigned = contact.interactions.iter().map(|(_, interaction)| {
        let interaction = &model.interactions[*interaction];
        let usual = behaviour(Some(interaction));
        match interaction.scale_factor {
            Some(scaling) => Behaviour { normal: Normal::ScaleFactor { scaling, smallest }, ..usual },
            None => usual,
        }
    });
    Some(GeneralDefinition {
        name: NAME.into(),
        faces,
        table,
        behaviours: [behaviour(None)].into_iter().chain(assigned).collect(),
        scales: [1.0].into_iter().chain(contact.scale_penalty.iter().map(|(_, factor)| *factor)).collect(),
    })
}

/// The shortest edge [L] of the faces of solids.
fn smallest(structure: &Structure, faces: &[GeneralFace]) -> f64 {
    let points = &structure.mesh.points;
    let edges = |face: &GeneralFace| {
        let count = face.nodes.len();
        let at = |i: usize| Vec3::from(points[face.nodes[i % count] as usize]);
        (0..count).map(|i| (at(i + 1) - at(i)).norm()).fold(f64::INFINITY, f64::min)
    };
    faces.iter().filter(|face| face.sides == Sides::Outer).map(edges).fold(f64::INFINITY, f64::min)
}

fn is_rigid(structure: &Structure, face: &Face) -> bool {
    structure.elements[face.cell.block as usize].family() == Family::Rigid
}

/// Both sides of a contact pair, which general contact leaves to it.
type Sidewise<'m> = [Side<'m>; 2];

enum Side<'m> {
    Faces(&'m [Face]),
    Nodes(BTreeSet<u32>),
}

/// The contact pairs of a step whose main side has faces.
fn pairs<'m>(model: &'m Model, step: &Step) -> Vec<Sidewise<'m>> {
    let of = |active: &fe_io::model::ActivePair| {
        let pair = &model.explicit_pairs[active.pair].0;
        let Main::Faces(main) = &pair.main else { return None };
        let secondary = match &pair.secondary {
            Secondary::Faces(faces) => Side::Faces(faces),
            Secondary::Nodes(nodes) => Side::Nodes(nodes.iter().map(|node| node.0).collect()),
            Secondary::Lines(_) => return None,
        };
        Some([secondary, Side::Faces(main)])
    };
    step.explicit_pairs.iter().filter_map(of).collect()
}

/// The faces that a step names, in classes of those that the same surfaces have.
struct Faces {
    class_of: BTreeMap<Face, u16>,
    /// The surfaces of each class, ascending.
    classes: Vec<Vec<usize>>,
    /// The numbers of the surfaces.
    known: Vec<Region>,
    /// Those of both sides of contact pairs.
    pairs: Vec<[usize; 2]>,
}

impl Faces {
    fn new(structure: &Structure, contact: &pair::GeneralContact, pairs: &[Sidewise]) -> Self {
        let mesh = &structure.mesh;
        let outside = outside(structure);
        let mut known: Vec<Region> = Vec::new();
        let assigned = contact.interactions.iter().flat_map(|(regions, _)| regions);
        let scaled = contact.scale_penalty.iter().flat_map(|(regions, _)| regions);
        for region in contact.inclusions.iter().chain(&contact.exclusions).flatten().chain(assigned).chain(scaled) {
            if !known.contains(region) {
                known.push(region.clone());
            }
        }
        let mut of_face: BTreeMap<Face, Vec<usize>> = BTreeMap::new();
        let mut put = |face: Face, surface: usize| of_face.entry(front(mesh, face)).or_default().push(surface);
        for (surface, region) in known.iter().enumerate() {
            match region {
                Region::AllExterior => outside.iter().for_each(|&face| put(face, surface)),
                Region::Surface(name) => mesh.surfaces[name].iter().for_each(|&face| put(face, surface)),
            }
        }
        let mut sides = Vec::new();
        for (pair, both) in pairs.iter().enumerate() {
            let numbers = [0, 1].map(|i| known.len() + 2 * pair + i);
            for (side, surface) in both.iter().zip(numbers) {
                match side {
                    Side::Faces(faces) => faces.iter().for_each(|&face| put(face, surface)),
                    Side::Nodes(nodes) => {
                        let has = |face: &&Face| mesh.face(**face).1.iter().any(|node| nodes.contains(node));
                        outside.iter().filter(has).for_each(|&face| put(face, surface));
                    }
                }
            }
            sides.push(numbers);
        }
        let (mut classes, mut numbers): (Vec<Vec<usize>>, HashMap<Vec<usize>, u16>) = Default::default();
        let mut number = |mut surfaces: Vec<usize>| {
            surfaces.sort_unstable();
            surfaces.dedup();
            *numbers.entry(surfaces).or_insert_with_key(|surfaces| {
                classes.push(surfaces.clone());
                classes.len() as u16 - 1
            })
        };
        let class_of = of_face.into_iter().map(|(face, surfaces)| (face, number(surfaces))).collect();
        Faces { class_of, classes, known, pairs: sides }
    }

    /// True where one class is in one surface and the other in the other one.
    fn has(&self, [one, other]: [usize; 2], [first, second]: [usize; 2]) -> bool {
        let of = |class: usize, surface: usize| self.classes[class].binary_search(&surface).is_ok();
        (of(one, first) && of(other, second)) || (of(one, second) && of(other, first))
    }

    /// What acts between two classes; the last line that names them holds.
    fn between(&self, contact: &pair::GeneralContact, one: usize, other: usize) -> Between {
        let number = |region: &Region| self.known.iter().position(|known| known == region).expect("it was counted");
        let names = |regions: &[Region; 2]| self.has([one, other], regions.each_ref().map(number));
        let left_out =
            contact.exclusions.iter().any(names) || self.pairs.iter().any(|&pair| self.has([one, other], pair));
        if left_out {
            return Between::Excluded;
        }
        if !contact.inclusions.iter().any(names) {
            return Between::Nothing;
        }
        let last = |found: &mut dyn DoubleEndedIterator<Item = (usize, &[Region; 2])>| {
            found.rev().find(|(_, regions)| names(regions)).map_or(0, |(place, _)| place as u16 + 1)
        };
        Between::Acting(Acting {
            behaviour: last(&mut contact.interactions.iter().map(|(regions, _)| regions).enumerate()),
            scale: last(&mut contact.scale_penalty.iter().map(|(regions, _)| regions).enumerate()),
        })
    }
}

/// A facet of a rigid body by its front: both sides are one face here.
fn front(mesh: &Mesh, face: Face) -> Face {
    let kind = mesh.kind(face.cell);
    if kind.dimension() == 2 { Face { face: kind.faces().len() as u8, ..face } } else { face }
}

/// The free faces of solids, and the facets of rigid bodies.
fn outside(structure: &Structure) -> Vec<Face> {
    let mesh = &structure.mesh;
    let mut faces = exterior(mesh);
    let facets = mesh.cells().filter(|cell| {
        structure.elements[cell.block as usize].family() == Family::Rigid && mesh.kind(*cell).dimension() == 2
    });
    faces.extend(facets.map(|cell| front(mesh, Face { cell, face: 0 })));
    faces
}
