//! The elastic slip of sticking points where it is given as a part of the facets' length.

use super::{Friction, Stick};
use crate::facet::{Facet, Vec3};
use crate::line;
use crate::pair::PairDefinition;
use crate::sides::characteristic_length;
use crate::surface::{Main, Secondary};
use fe_core::Structure;
use fe_mesh::Face;

/// The length that slip tolerances are parts of.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Reference {
    length: f64,
    /// What it is.
    of: &'static str,
    usual: bool,
}

impl Reference {
    /// The mean length of all secondary facets of all pairs, or of all secondary lines where there are none, or of all main
    /// facets, or 1.
    pub fn of(structure: &Structure, pairs: &[PairDefinition]) -> Self {
        let secondary = pairs.iter().filter_map(|pair| match &pair.secondary {
            Secondary::Faces(faces) => Some(faces.as_slice()),
            Secondary::Nodes(_) | Secondary::Lines(_) => None,
        });
        let main = pairs.iter().filter_map(|pair| match &pair.main {
            Main::Faces(faces) => Some(faces.as_slice()),
            Main::Rigid { .. } => None,
        });
        if let Some(length) = mean_length(structure, secondary) {
            return Reference { length, of: "the mean length of all secondary facets", usual: true };
        }
        let lines = pairs.iter().filter_map(|pair| match &pair.secondary {
            Secondary::Lines(cells) => Some(cells),
            Secondary::Faces(_) | Secondary::Nodes(_) => None,
        });
        if let Some(length) = line::mean_length(structure, lines.flatten()) {
            return Reference { length, of: "the mean length of all secondary lines", usual: true };
        }
        let of = "the mean length of all main facets, as no secondary surface has any";
        let of_main = mean_length(structure, main).map(|length| Reference { length, of, usual: false });
        of_main.unwrap_or(Reference { length: 1.0, of: "a length of 1, as no surface has facets", usual: false })
    }

    /// Makes the slip tolerance of a friction, if it has one, into an elastic slip [L], and says so of `whose` it is.
    pub fn settle(&self, friction: &mut Friction, whose: &str) -> Option<String> {
        let Friction::Coulomb { stick, .. } = friction else { return None };
        let Stick::Tolerance(part) = *stick else { return None };
        let (slip, of) = (part * self.length, self.of);
        *stick = Stick::ElasticSlip(slip);
        let warning = if self.usual { "" } else { "warning: " };
        Some(format!("{warning}{whose}: sticking points give way by up to {slip:.6e} L, {part} of {of}"))
    }
}

fn mean_length<'a>(structure: &Structure, surfaces: impl Iterator<Item = &'a [Face]>) -> Option<f64> {
    let facets: Vec<Facet> =
        surfaces.flatten().map(|&face| Facet::new(structure, face, Some(1.0), &Vec3::zeros())).collect();
    characteristic_length(&facets).filter(|length| *length > 0.0)
}
