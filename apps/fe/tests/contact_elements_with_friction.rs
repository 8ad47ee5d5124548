//! A06 (d): contact elements with friction, through the program.
#![allow(clippy::unwrap_used)]

mod common;

use common::job::Job;

/// What holds node 1 against a force of 200, and along which direction it may slide.
#[derive(Clone, Copy, Debug)]
enum Element {
    /// Flat, in the plane y = 0.
    Uni,
    /// Round, beside each other: flat without large displacements.
    Sphere,
    /// Round and concentric at the start; slides along its axis.
    Cylinder,
    /// Within a tube along x; slides along it.
    Tube,
}

impl Element {
    /// Component along which it slides, and the column of its shear in the printed tables.
    fn along(self) -> (usize, usize) {
        if matches!(self, Element::Cylinder) { (3, 4) } else { (1, 3) }
    }

    /// A spring of 1000 holds node 1 where it slides, `load` drives it there, 200 press it; a spring across takes 0.2.
    fn deck(self, friction: &str, load: f64) -> String {
        let (slides, _) = self.along();
        let (place, element, press, rest) = match self {
            Element::Uni => (0.0, "TYPE=GAPUNI, ELSET=G\n9, 2, 1\n*GAP, ELSET=G\n0., 0., 4., 0.\n", -200.0, "3"),
            Element::Sphere => (2.0, "TYPE=GAPSPHER, ELSET=G\n9, 2, 1\n*GAP, ELSET=G\n-2.\n", -200.0, "3"),
            Element::Cylinder => (0.0, "TYPE=GAPCYL, ELSET=G\n9, 2, 1\n*GAP, ELSET=G\n0.2, 0., 0., 1.\n", 200.2, "1"),
            Element::Tube => (
                -0.1,
                "TYPE=ITT31, ELSET=G\n9, 1\n*SLIDE LINE, ELSET=G, TYPE=LINEAR\n2, 3\n*INTERFACE, ELSET=G\n0.1\n",
                -200.0,
                "3",
            ),
        };
        let across = match self {
            Element::Cylinder => "*ELEMENT, TYPE=SPRING1, ELSET=Y\n8, 1\n*SPRING, ELSET=Y\n2\n1.\n",
            _ => "",
        };
        let others = match self {
            Element::Tube => "2, -2., 0., 0.\n3, 2., 0., 0.\n",
            _ => "2, 0., 0., 0.\n",
        };
        let held = if matches!(self, Element::Tube) { "3, 1, 3\n" } else { "" };
        format!(
            "*NODE\n1, 0., {place:?}, 0.\n{others}*ELEMENT, TYPE=SPRING1, ELSET=S\n7, 1\n*SPRING, ELSET=S\n{slides}\n1000.\n\
             {across}*ELEMENT, {element}{friction}*BOUNDARY\n2, 1, 3\n{held}1, {rest}\n*STEP\n*STATIC\n\
             *CONTROLS, PARAMETERS=FIELD\n1e-12\n*CLOAD\n1, 2, {press}\n1, {slides}, {load}\n*EL PRINT, ELSET=G\nS, E\n\
             *END STEP\n"
        )
    }
}

/// N, T and slip as they are printed at the end, with ten digits.
fn solve(name: &str, element: Element, deck: &str) -> [f64; 3] {
    let (job, (_, column)) = (Job::run(name, deck), element.along());
    [("stresses", 0), ("stresses", column), ("strains", column)].map(|(title, c)| job.last(title, "G", c + 1))
}

/// N = 200, μ = 0.3, spring 1000: a load of 50 sticks, one of 70 slips by (70 − 60)/1000. Rough points stick in both.
#[test]
fn a06_contact_elements_with_friction() {
    for element in [Element::Uni, Element::Sphere, Element::Cylinder, Element::Tube] {
        let cases = [
            ("*FRICTION, LAGRANGE\n0.3\n", 50.0, [200.0, 50.0, 0.0]),
            ("*FRICTION, LAGRANGE\n0.3\n", 70.0, [200.0, 60.0, 0.01]),
            ("*FRICTION, LAGRANGE\n0.3\n", -70.0, [200.0, -60.0, -0.01]),
            ("*FRICTION, ROUGH\n", 70.0, [200.0, 70.0, 0.0]),
        ];
        for (friction, load, expected) in cases {
            let found = solve("element_friction", element, &element.deck(friction, load));
            // Rounding of ten printed digits.
            let near = found.iter().zip(expected).all(|(f, e)| (f - e).abs() < 1e-9 * f64::max(1.0, e.abs()));
            assert!(near, "{element:?} {friction} {load}: {found:?}, not {expected:?}");
        }
    }
}

/// Without a size of anything the usual elastic slip is 0.005 of a length of 1: T = 60 g/0.005 balances 50 − 1000 g.
#[test]
fn contact_elements_have_the_usual_elastic_slip() {
    let element = Element::Uni;

    let found = solve("element_tolerance", element, &element.deck("*FRICTION\n0.3\n", 50.0));
    let slip = 50.0 / 13000.0;
    assert!((found[2] - slip).abs() < 1e-9 && (found[1] - 12000.0 * slip).abs() < 1e-7, "{found:?}");
}
