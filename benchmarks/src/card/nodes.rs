//! A unit cube pushed onto a rigid flat by the nodes of its lower face, a node-based surface without area: the law's number
//! is a force.

use super::Push;
use crate::hard::deck::{self, Order};
use crate::hard::patch::{EXACT, YOUNG};
use crate::hard::run::Solved;
use fe_core::element::ElementType;
use fe_mesh::generate::Block;

pub(super) struct Nodes;

/// Nodes of the lower face.
const COUNT: f64 = 4.0;

impl Push for Nodes {
    fn name(&self) -> &'static str {
        "nodes"
    }

    fn about(&self) -> &'static str {
        "a cube pushed onto a rigid flat by a node-based surface without area: the law's number is a force"
    }

    fn deck(&self, card: &str) -> String {
        let mesh = Block::hex8([1, 1, 1]).mesh();
        let depth = Self::DEPTH;
        format!(
            "{}{}*NODE\n99, 0., 0., 0.\n*SURFACE, NAME=FLAT, TYPE=CYLINDER\n0., 0., 0., 1., 0., 0.\n0., 1., 0.\n\
             START, -5., 0.\nLINE, 5., 0.\n*RIGID BODY, ANALYTICAL SURFACE=FLAT, REF NODE=99\n\
             *SURFACE, NAME=POINTS, TYPE=NODE\nZMIN,\n*SURFACE INTERACTION, NAME=I\n{card}\
             *CONTACT PAIR, INTERACTION=I\nPOINTS, FLAT\n*BOUNDARY\n99, 1, 6\nXMIN, 1\nYMIN, 2\n\
             *STEP\n*STATIC\n1., 1.\n*CONTROLS, PARAMETERS=FIELD\n{EXACT:e}\n*BOUNDARY\nZMAX, 3, 3, -{depth}\n*END STEP\n",
            deck::cards(&mesh, &[("BLOCK", ElementType::C3D8)], Order::AsMade),
            deck::elastic(&["BLOCK"], YOUNG, 0.3),
        )
    }

    const DEPTH: f64 = 0.01;

    fn spring(&self) -> f64 {
        YOUNG
    }

    fn measure(&self) -> f64 {
        COUNT
    }

    fn force(&self, solved: &Solved) -> f64 {
        solved.pairs[0].secondary.force[2]
    }
}
