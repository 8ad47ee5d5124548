//! How a definition becomes a pair: surfaces checked, points found, the law resolved.

use crate::adjust;
use crate::carry::{Carried, Ground, NoStiffness};
use crate::closest::EXTENSION;
use crate::conditions::{Activity, Overrides};
use crate::contact::Contact;
use crate::enforce::{Separation, TOUCH};
use crate::error::PairError;
use crate::facet::{Facet, Vec3};
use crate::friction::Friction;
use crate::interaction::{Enforcement, Interaction, NormalBehavior};
use crate::line;
use crate::node_to_surface::{self, Node};
use crate::overlap::Sides;
use crate::pair::{Bond, Discretization, PairDefinition};
use crate::point::{ContactPoint, Measure};
use crate::search::{Bounds, Grid};
use crate::sides::{Prepared, characteristic_length, label};
use crate::stiffness;
use crate::summary::{MeasureKind, Origin, Summary};
use crate::surface::{Main, Secondary};
use crate::surface_to_surface::{self, Constraints, RigidSide};
use crate::tangents::Space;
use crate::viscous::Viscous;
use fe_core::{Freedoms, Structure};
use fe_mesh::CellId;
use std::collections::{BTreeMap, BTreeSet};
use std::sync::Mutex;

impl Contact {
    /// Finds the points of a pair's definition.
    pub fn of_pair(
        structure: &Structure,
        freedoms: &Freedoms,
        definition: &PairDefinition,
        interaction: &Interaction,
    ) -> Result<Self, PairError> {
        check_numbers(interaction)?;
        let tied = (definition.bond == Bond::Tied).then(|| tied(interaction));
        let interaction = tied.as_ref().unwrap_or(interaction);
        let mut sides = Prepared::new(structure, definition, interaction)?;
        let discretization = settle(definition, &mut sides)?;
        let deepest = deepest(definition, &sides, interaction);
        let (mut constraints, searched) = constrain(structure, definition, &sides, (discretization, deepest));
        if let Some((depth, node)) = constraints.too_deep {
            let (secondary, main) = (definition.secondary_name.clone(), definition.main_name.clone());
            let node = label(structure, node);
            return Err(PairError::TooDeep { node, depth, limit: deepest, secondary, main });
        }
        for share in &mut constraints.shares {
            if let Some(clearance) = definition.clearance.as_ref().and_then(|c| c.of(share.node)) {
                share.stand(clearance.value, clearance.normal.map(Vec3::from));
            }
        }
        if tied.is_some() {
            tie((structure, definition), &mut sides, &mut constraints);
        }
        remark(definition, &constraints, (discretization, &mut sides.notes));
        sides.notes.extend(begins_inside(structure, definition, &constraints, deepest));
        let reference = match &definition.main {
            Main::Rigid { reference, .. } => Some(*reference),
            Main::Faces(_) => None,
        };
        let line = match &definition.secondary {
            Secondary::Lines(cells) => line::nodes(structure, cells),
            Secondary::Faces(_) | Secondary::Nodes(_) => BTreeMap::new(),
        };
        let measure = measures((definition, &line), &sides, interaction, discretization);
        let across = if structure.is_plane() { Space::Plane } else { Space::Solid };
        let space = |node: u32| line.get(&node).map_or(across, |n| Space::Led(n.direction));
        let points: Vec<ContactPoint> = constraints
            .shares
            .into_iter()
            .map(|s| {
                let measure = measure(s.node, s.weight);
                let slides = interaction.acts_along().then(|| space(s.node));
                s.into_point(measure, freedoms, reference, slides)
            })
            .collect();
        let found = Found {
            name: format!("{} on {}", definition.secondary_name, definition.main_name),
            surfaces: (definition.secondary_name.clone(), definition.main_name.clone()),
            points,
            reference,
            cells: Vec::new(),
            origin: Origin::Pair(discretization),
            searched,
        };
        let ground = ground((structure, freedoms), &sides, definition, &found.points);
        let mut pair =
            Contact::of_points((structure, freedoms), (found, sides), interaction, ground).map_err(|NoStiffness| {
                let (secondary, main) = (definition.secondary_name.clone(), definition.main_name.clone());
                PairError::NoStiffness { secondary, main }
            })?;
        if tied.is_some() {
            pair.separation = Separation::Tied;
        }
        Ok(pair)
    }

    /// Points, however they were found, with what carries them.
    pub(crate) fn of_points(
        (structure, freedoms): (&Structure, &Freedoms),
        (found, mut sides): (Found, Prepared),
        interaction: &Interaction,
        ground: Ground,
    ) -> Result<Self, NoStiffness> {
        let carried = Carried::new(&interaction.normal, ground, Overrides::default())?;
        let tangential = interaction.friction.as_ref().map(|friction| carried.friction(friction, ground));
        let Carried { law, bare, penalty, multipliers } = carried;
        let Found { name, surfaces, mut points, cells, reference, origin, searched } = found;
        if !interaction.acts_along() {
            points.iter_mut().for_each(|p| p.slide = None);
        }
        let place = |&n: &u32| freedoms.of_node(n as usize);
        let both = sides.secondary_nodes.iter().chain(&sides.main_nodes);
        let components = |n: &u32| place(n).map(|f| freedoms.component(f)).collect::<Vec<_>>();
        let unusual = |(_, components): &(u32, Vec<usize>)| components.iter().enumerate().any(|(k, c)| k != *c);
        Ok(Contact {
            name,
            surfaces,
            places: points.iter().map(|p| p.nodes.iter().map(place).collect()).collect(),
            blocks: Mutex::default(),
            multipliers,
            tangential,
            separation: if interaction.no_separation { Separation::OnceClosed } else { Separation::Free },
            law,
            bare,
            stuck: Vec::new(),
            mirrored: Vec::new(),
            length: ground.length,
            touch: TOUCH * model_size(structure),
            summary: Summary {
                origin,
                penalty,
                beneath: ground.beneath,
                searched,
                points: points.len(),
                measure: points.first().map_or(MeasureKind::Pressure, |p| MeasureKind::of(p.measure)),
            },
            notes: std::mem::take(&mut sides.notes),
            components: both.clone().map(|n| (*n, components(n))).filter(unusual).collect(),
            positions: both.map(|&n| (n, Vec3::from(structure.mesh.points[n as usize]))).collect(),
            rigid_main: reference.is_some(),
            points,
            cells,
            sides,
            activity: Activity::Acting,
            allowance: None,
            origin: (interaction.normal.clone(), ground, Overrides::default()),
            viscous: Viscous { given: interaction.damping, ..Viscous::default() },
        })
    }
}

/// Points and where they come from.
pub(crate) struct Found {
    /// What messages call the contact.
    pub name: String,
    /// Names of the secondary and the main side.
    pub surfaces: (String, String),
    /// By ascending secondary node.
    pub points: Vec<ContactPoint>,
    /// Reference node of a rigid main side.
    pub reference: Option<u32>,
    /// The element of each point; empty for a pair.
    pub cells: Vec<CellId>,
    /// What they come from.
    pub origin: Origin,
    /// Facets that a search sorted.
    pub searched: Option<usize>,
}

/// Diagonal [L] of the box around all points.
fn model_size(structure: &Structure) -> f64 {
    let boxes = structure.mesh.points.iter().map(|&p| Bounds::around(&[p.into()], 0.0));
    boxes.reduce(|a, b| a.union(&b)).map_or(0.0, |all| all.diagonal())
}

/// Mean length [L] of the secondary facets, or of the main ones; 0 without any.
fn facet_length(sides: &Prepared) -> f64 {
    characteristic_length(&sides.secondary).or_else(|| characteristic_length(&sides.main)).unwrap_or(0.0)
}

fn check_numbers(interaction: &Interaction) -> Result<(), PairError> {
    let mut numbers = vec![("the thickness or area on its data line", interaction.measure)];
    if let NormalBehavior::Hard(enforcement) = &interaction.normal
        && let Some(penalty) = enforcement.penalty()
    {
        numbers.push(("the penalty stiffness", penalty.stiffness));
        numbers.push(("the scale factor of the penalty stiffness", Some(penalty.scale)));
    }
    for (what, value) in numbers {
        if let Some(value) = value
            && !(value > 0.0 && value.is_finite())
        {
            return Err(PairError::NotPositive { interaction: interaction.name.clone(), what, value });
        }
    }
    Ok(())
}

/// What a tied pair makes of its interaction: hard by multipliers, rough, no separation.
fn tied(interaction: &Interaction) -> Interaction {
    Interaction {
        normal: NormalBehavior::Hard(Enforcement::Direct),
        no_separation: true,
        friction: Some(Friction::Rough),
        ..interaction.clone()
    }
}

/// A node lies on the main surface where it is this near to it, of the model's size [-]: what rounding leaves of an
/// adjustment to a curved facet.
const ON_SURFACE: f64 = 1e-9;

/// Leaves of the constraints those of nodes that lie on the main surface, and says how many do not. What gap is left, of
/// facets that are chords, is free of stress.
fn tie((structure, definition): (&Structure, &PairDefinition), sides: &mut Prepared, constraints: &mut Constraints) {
    let near = ON_SURFACE * model_size(structure);
    let feet = adjust::feet(structure, definition, sides);
    let on = |foot: &(f64, Vec3)| foot.0.abs() <= near;
    let landed: BTreeSet<u32> =
        feet.iter().filter(|(_, foot)| foot.as_ref().is_some_and(on)).map(|(node, _)| node.node).collect();
    constraints.shares.retain(|share| landed.contains(&share.node));
    constraints.shares.iter_mut().for_each(|share| share.stand(0.0, None));
    // Mid-side nodes follow their corners.
    let middle: BTreeSet<u32> = sides.secondary.iter().flat_map(|f| &f.nodes()[f.corners()..]).copied().collect();
    let free: Vec<u32> =
        sides.secondary_nodes.iter().copied().filter(|n| !landed.contains(n) && !middle.contains(n)).collect();
    if let Some(&first) = free.first() {
        let (secondary, main) = (&definition.secondary_name, &definition.main_name);
        sides.notes.push(format!(
            "warning: {} of {} nodes of {secondary} do not lie on {main} and are free, the first is {}; a larger ADJUST ties \
             them",
            free.len(),
            sides.secondary_nodes.len() - middle.len(),
            label(structure, first)
        ));
    }
}

/// The discretization that the surfaces allow.
fn settle(definition: &PairDefinition, sides: &mut Prepared) -> Result<Discretization, PairError> {
    use Discretization::*;
    let mut discretization = definition.discretization;
    let without_faces = match definition.secondary {
        Secondary::Faces(_) => None,
        Secondary::Nodes(_) => Some("a set of nodes"),
        Secondary::Lines(_) => Some("a line"),
    };
    if let (SurfaceToSurface, Some(what)) = (discretization, without_faces) {
        discretization = NodeToSurface;
        sides.notes.push(format!(
            "surface {} is {what}: node to surface is used instead of surface to surface",
            definition.secondary_name
        ));
    }
    if discretization == NodeToSurface {
        let named = [(&sides.secondary, &definition.secondary_name), (&sides.main, &definition.main_name)];
        for (facets, name) in named {
            if !facets.iter().all(Facet::is_linear) {
                return Err(PairError::MidSideNodes { surface: name.clone() });
            }
        }
    }
    Ok(discretization)
}

/// Largest overclosure [L] believed: half the secondary facets' length; of a set of nodes half the main facets', or
/// half of √area; without any length, whatever there is.
fn deepest(definition: &PairDefinition, sides: &Prepared, interaction: &Interaction) -> f64 {
    let of_nodes = || {
        let Secondary::Nodes(list) = &definition.secondary else { return None };
        list.iter().filter_map(|n| n.1.or(interaction.measure)).reduce(f64::max).map(f64::sqrt)
    };
    let length =
        characteristic_length(&sides.secondary).or_else(|| characteristic_length(&sides.main)).or_else(of_nodes);
    length.map_or(f64::INFINITY, |l| 0.5 * l)
}

/// The constraints, and the facets that a search sorted for them.
fn constrain(
    structure: &Structure,
    definition: &PairDefinition,
    sides: &Prepared,
    (discretization, deepest): (Discretization, f64),
) -> (Constraints, Option<usize>) {
    let nodes = || secondary_points(structure, sides);
    if let Main::Rigid { surface, reference } = &definition.main {
        let position = Vec3::from(structure.mesh.points[*reference as usize]) - sides.origin;
        let surface = surface.seen_from(&sides.origin);
        let main = RigidSide { surface: &surface, reference: *reference, position };
        let constraints = match discretization {
            Discretization::SurfaceToSurface => surface_to_surface::rigid(&sides.secondary, main, deepest),
            Discretization::NodeToSurface => node_to_surface::rigid(&nodes(), main, deepest),
        };
        return (constraints, None);
    }
    let secondary_grid = Grid::of_facets(&sides.secondary, 1e-6);
    // Normals of curved neighbours may lead a little past a facet.
    let main_grid = Grid::of_facets(&sides.main, EXTENSION);
    let both = Sides::new((&sides.secondary, &secondary_grid), (&sides.main, &main_grid), deepest);
    let constraints = match discretization {
        Discretization::SurfaceToSurface => surface_to_surface::deformable(&both),
        Discretization::NodeToSurface => node_to_surface::deformable(&nodes(), &both),
    };
    (constraints, Some(secondary_grid.len() + main_grid.len()))
}

/// The secondary nodes with normals and areas, where there are facets.
pub(crate) fn secondary_points(structure: &Structure, sides: &Prepared) -> Vec<Node> {
    if sides.secondary.is_empty() {
        let place = |node: u32| Vec3::from(structure.mesh.points[node as usize]) - sides.origin;
        let node = |&node: &u32| Node { node, x: place(node), outward: None, area: 1.0 };
        return sides.secondary_nodes.iter().map(node).collect();
    }
    node_to_surface::nodes_of(&sides.secondary)
}

fn remark(
    definition: &PairDefinition,
    constraints: &Constraints,
    (discretization, notes): (Discretization, &mut Vec<String>),
) {
    let (secondary, main) = (&definition.secondary_name, &definition.main_name);
    if constraints.shares.is_empty() {
        notes.push(format!("no part of surface {secondary} faces surface {main}: the pair has no effect"));
    }
    if constraints.hidden > 0 {
        notes.push(format!(
            "surface {main} lies in several layers before surface {secondary}: the nearest counts ({} facets are hidden)",
            constraints.hidden
        ));
    }
    if discretization == Discretization::NodeToSurface && matches!(definition.main, Main::Faces(_)) {
        notes.push(format!(
            "{secondary} on {main}, node to surface: a constant pressure is not passed on exactly where the meshes do not \
             match; TYPE=SURFACE TO SURFACE does"
        ));
    }
}

/// Overlaps at the start below this share of what is believed are round-off or the flatness of facets [-].
const NO_OVERLAP: f64 = 1e-6;
/// Overlaps above this share of what is believed, a tenth of a facet, are warned of [-].
const LARGE_OVERLAP: f64 = 0.2;

/// What presses from the start on, with the node that lies deepest.
fn begins_inside(
    structure: &Structure,
    definition: &PairDefinition,
    constraints: &Constraints,
    deepest: f64,
) -> Option<String> {
    let least = if deepest.is_finite() { NO_OVERLAP * deepest } else { TOUCH * model_size(structure) };
    let depths = constraints.shares.iter().map(|s| (-s.gap / s.weight, s.node)).filter(|(depth, _)| *depth > least);
    let count = depths.clone().count();
    let (depth, node) = depths.reduce(|a, b| if b.0 > a.0 { b } else { a })?;
    let kind = if depth > LARGE_OVERLAP * deepest { "warning: " } else { "" };
    let (secondary, main) = (&definition.secondary_name, &definition.main_name);
    let label = label(structure, node);
    Some(format!(
        "{kind}{count} nodes of {secondary} begin inside of {main}: the overlap, {depth:.6e} at most (node {label}), is \
         pressed out in the first increment; *CONTACT INTERFERENCE lets it be at first, ADJUST removes it without strain"
    ))
}

/// How much surface each node stands for, of a secondary line with its nodes; the second argument is the area of the overlap.
fn measures(
    (definition, line): (&PairDefinition, &BTreeMap<u32, line::Node>),
    sides: &Prepared,
    interaction: &Interaction,
    discretization: Discretization,
) -> impl Fn(u32, f64) -> Measure + use<> {
    let areas: BTreeMap<u32, Measure> = match (&definition.secondary, discretization) {
        (Secondary::Faces(_), Discretization::SurfaceToSurface) => BTreeMap::new(),
        (Secondary::Faces(_), Discretization::NodeToSurface) => {
            node_to_surface::nodes_of(&sides.secondary).iter().map(|n| (n.node, Measure::Area(n.area))).collect()
        }
        (Secondary::Nodes(list), _) => {
            let area = |a: Option<f64>| a.or(interaction.measure).map_or(Measure::Point, Measure::Area);
            list.iter().rev().map(|&(n, a)| (n, area(a))).collect()
        }
        (Secondary::Lines(_), _) => line.iter().map(|(&n, node)| (n, Measure::Length(node.length))).collect(),
    };
    move |node, overlap| areas.get(&node).copied().unwrap_or(Measure::Area(overlap))
}

/// What the elements beneath and the facets say of a pair.
fn ground(
    bodies: (&Structure, &Freedoms),
    sides: &Prepared,
    definition: &PairDefinition,
    points: &[ContactPoint],
) -> Ground {
    let beneath = match definition.secondary {
        Secondary::Faces(_) => {
            let each = [&sides.secondary, &sides.main].map(|facets| stiffness::beneath(bodies.0, facets));
            // Between sides of trusses and beams in the plane there are none.
            each.into_iter().flatten().reduce(f64::min).or_else(|| stiffness::at_points(bodies, points))
        }
        Secondary::Nodes(_) | Secondary::Lines(_) => stiffness::at_points(bodies, points),
    };
    Ground {
        beneath,
        length: facet_length(sides),
        slides_far: definition.discretization == Discretization::SurfaceToSurface && !definition.small_sliding,
    }
}
