//! The slider: a column of stiffness k = 1000 and area 1, its far end held, a rigid stop beyond its near end. As a
//! brick, a plane or an axisymmetric element; ν = 0, so that the column is a spring.

/// Stiffness of the column [F/L]: E A / L.
pub const K: f64 = 1000.0;
/// Distance of the stop [L].
pub const DISTANCE: f64 = 0.1;

/// How the column is meshed.
#[derive(Clone, Copy, Debug, PartialEq)]
#[allow(missing_docs)]
pub enum Body {
    Brick,
    Plane,
    Ring,
}

impl Body {
    /// Component of the axis along which it slides, from 1.
    pub fn axis(self) -> usize {
        if self == Body::Brick { 3 } else { 2 }
    }

    /// Nodes, element, material and sets: HELD and the near nodes NEAR; the surface SEC; the node 99 in REF.
    pub fn deck(self) -> String {
        let (nodes, element, held, near) = match self {
            Body::Brick => (
                "1, 0., 0., 0.\n2, 1., 0., 0.\n3, 1., 1., 0.\n4, 0., 1., 0.\n5, 0., 0., 1.\n6, 1., 0., 1.\n\
                 7, 1., 1., 1.\n8, 0., 1., 1.\n99, 0., 0., -5.\n",
                "*ELEMENT, TYPE=C3D8, ELSET=E\n1, 1, 2, 3, 4, 5, 6, 7, 8\n",
                "5, 6, 7, 8",
                "1, 2, 3, 4",
            ),
            Body::Plane => (
                "1, 0., 0.\n2, 1., 0.\n3, 1., 1.\n4, 0., 1.\n99, 0., -5.\n",
                "*ELEMENT, TYPE=CPE4, ELSET=E\n1, 1, 2, 3, 4\n",
                "3, 4",
                "1, 2",
            ),
            // Radius 1/√π: area 1.
            Body::Ring => (
                "1, 0., 0.\n2, 0.5641895835477563, 0.\n3, 0.5641895835477563, 1.\n4, 0., 1.\n99, 0., -5.\n",
                "*ELEMENT, TYPE=CAX4, ELSET=E\n1, 1, 2, 3, 4\n",
                "3, 4",
                "1, 2",
            ),
        };
        format!(
            "*NODE\n{nodes}{element}*NSET, NSET=HELD\n{held}\n*NSET, NSET=NEAR\n{near}\n*NSET, NSET=REF\n99\n\
             *MATERIAL, NAME=M\n*ELASTIC\n{K}, 0.\n*SOLID SECTION, ELSET=E, MATERIAL=M\n*SURFACE, NAME=SEC\nE, S1\n"
        )
    }

    /// The rigid stop FLOOR below the column, with its reference node; `revolved` for a disc in three dimensions.
    pub fn stop(self, revolved: bool) -> String {
        let d = DISTANCE;
        let shape = match (self, revolved) {
            (Body::Brick, true) => {
                format!("TYPE=REVOLUTION\n0.5, 0.5, -{d}, 0.5, 0.5, 1.\nSTART, 0., 0.\nLINE, 3., 0.\n")
            }
            // Local x is the global one, local y = x × (c − a) the global z.
            (Body::Brick, false) => {
                format!("TYPE=CYLINDER\n0., 0., -{d}, 1., 0., -{d}\n0., 1., -{d}\nSTART, -1., 0.\nLINE, 2., 0.\n")
            }
            _ => format!("TYPE=SEGMENTS\nSTART, -1., -{d}\nLINE, 2., -{d}\n"),
        };
        format!("*SURFACE, NAME=FLOOR, {shape}*RIGID BODY, ANALYTICAL SURFACE=FLOOR, REF NODE=99\n")
    }
}

/// Hard contact by a penalty of so much [F/L³].
pub fn penalty(stiffness: f64) -> String {
    format!("*SURFACE INTERACTION, NAME=I\n*SURFACE BEHAVIOR, PENALTY\n{stiffness}\n")
}

/// The pair of SEC and FLOOR.
pub fn pair(kind: &str) -> String {
    format!("*CONTACT PAIR, INTERACTION=I, TYPE={kind}\nSEC, FLOOR\n")
}
