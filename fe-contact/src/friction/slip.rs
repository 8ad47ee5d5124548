//! The elastic slip of sticking points where it is given as a part of the facets' length.

use super::{Friction, Stick};
use crate::facet::{Facet, Vec3};
use crate::interaction::Interaction;
use crate::pair::PairDefinition;
use crate::sides::characteristic_length;
use crate::surface::{Main, Secondary};
use fe_core::Structure;
use fe_mesh::Face;

/// The interactions with every slip tolerance made into an elastic slip [L]: times the mean length of all secondary facets of
/// all pairs, or of all main ones where there are none, or 1. What is to be said of that, a line each.
pub fn settle(
    structure: &Structure,
    pairs: &[PairDefinition],
    interactions: &[Interaction],
) -> (Vec<Interaction>, Vec<String>) {
    let mut settled = interactions.to_vec();
    let mut notes = Vec::new();
    let by_length = |interaction: &Interaction| {
        matches!(&interaction.friction, Some(Friction::Coulomb { stick: Stick::Tolerance(_), .. }))
    };
    if !interactions.iter().any(by_length) {
        return (settled, notes);
    }
    let secondary = pairs.iter().filter_map(|pair| match &pair.secondary {
        Secondary::Faces(faces) => Some(faces.as_slice()),
        Secondary::Nodes(_) | Secondary::Lines(_) => None,
    });
    let main = pairs.iter().filter_map(|pair| match &pair.main {
        Main::Faces(faces) => Some(faces.as_slice()),
        Main::Rigid { .. } => None,
    });
    let of_secondary = mean_length(structure, secondary).map(|l| ("", l, "the mean length of all secondary facets"));
    let of_main = || {
        let words = "the mean length of all main facets, as no secondary surface has any";
        mean_length(structure, main).map(|length| ("warning: ", length, words))
    };
    let (warning, length, of) =
        of_secondary.or_else(of_main).unwrap_or(("warning: ", 1.0, "a length of 1, as no surface has facets"));
    for interaction in &mut settled {
        if let Some(Friction::Coulomb { stick, .. }) = &mut interaction.friction
            && let Stick::Tolerance(part) = *stick
        {
            let (slip, name) = (part * length, &interaction.name);
            notes.push(format!(
                "{warning}interaction {name}: sticking points give way by up to {slip:.6e} L, {part} of {of}"
            ));
            *stick = Stick::ElasticSlip(slip);
        }
    }
    (settled, notes)
}

fn mean_length<'a>(structure: &Structure, surfaces: impl Iterator<Item = &'a [Face]>) -> Option<f64> {
    let facets: Vec<Facet> =
        surfaces.flatten().map(|&face| Facet::new(structure, face, Some(1.0), &Vec3::zeros())).collect();
    characteristic_length(&facets).filter(|length| *length > 0.0)
}
