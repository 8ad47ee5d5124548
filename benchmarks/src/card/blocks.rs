//! Two blocks pushed together, 3 × 3 on 4 × 4 bricks, surface to surface.

use super::Push;
use crate::hard::deck::Order;
use crate::hard::patch::{EXACT, Patch, YOUNG};
use crate::hard::run::Solved;
use fe_core::element::ElementType;

pub(super) struct Blocks;

/// Area of the interface [L²].
const AREA: f64 = 4.0;

impl Push for Blocks {
    fn name(&self) -> &'static str {
        "blocks"
    }

    fn about(&self) -> &'static str {
        "two blocks with meshes that do not match, pushed together, surface to surface"
    }

    fn deck(&self, card: &str) -> String {
        let patch = Patch {
            element: ElementType::C3D8,
            behavior: card.into(),
            poisson: 0.3,
            residual: EXACT,
            ..Patch::plane(3, 4)
        };
        patch.moved(&patch.mesh(), Order::AsMade, -Self::DEPTH)
    }

    const DEPTH: f64 = 0.02;

    /// Two columns of height 1, free to widen.
    fn spring(&self) -> f64 {
        YOUNG * AREA / 2.0
    }

    fn measure(&self) -> f64 {
        AREA
    }

    fn force(&self, solved: &Solved) -> f64 {
        solved.pairs[0].secondary.force[2]
    }
}
