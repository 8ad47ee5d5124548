//! A35: a bar on a bed with Coulomb friction, through the program. EA = 1e5, L = 200, friction t = 2 per length, pulled
//! by F = 250 at one end; the other end and all directions along the flat are held by friction alone.
//!
//! The bar slips as far as friction takes up the force, F/t = 125, and its end moves by F²/(2tEA) = 0.15625. With friction
//! at nodes, elements of length h and half a share at the end, element j carries F − th(j − ½) as far as that is positive:
//! the first m = ⌈F/(th) − ½⌉ of them lengthen, the end moves by (h/EA)(mF − t h m²/2).
#![allow(clippy::unwrap_used)]

mod common;

use common::Scratch;
use fe_io::results::read::{Table, tables};
use std::fmt::Write;

const FORCE: f64 = 250.0;
const PULL: [f64; 2] = [0.6, 0.8];

/// How the bar lies and slides.
#[derive(Clone, Copy, Debug)]
enum Bar {
    /// T2D2 along x, its lower side.
    Plane,
    /// T3D2 across the axes of its flat, as a line.
    Space,
    /// The same with every other element the other way round.
    SpaceTurned,
}

impl Bar {
    fn in_space(self) -> bool {
        matches!(self, Bar::Space | Bar::SpaceTurned)
    }

    /// The unit vector from the far end to the pulled one.
    fn along(self) -> [f64; 2] {
        if self.in_space() { PULL } else { [1.0, 0.0] }
    }

    /// The bar in elements of length h, pressed by 2/μ per length, then pulled.
    fn deck(self, h: f64, friction: &str) -> String {
        let (n, [x, y]) = ((200.0 / h) as usize, self.along());
        let share = |i: usize| if i == 0 || i == n { 0.5 * h } else { h };
        let (mut nodes, mut elements, mut press) = (String::new(), String::new(), String::new());
        let down = if self.in_space() { 3 } else { 2 };
        for i in 0..=n {
            let s = i as f64 * h;
            let _ = writeln!(nodes, "{}, {:?}, {:?}, 0.", i + 1, s * x, if self.in_space() { s * y } else { 0.0 });
            let _ = writeln!(press, "{}, {down}, {:?}", i + 1, -20.0 * share(i));
        }
        for i in 1..=n {
            let turned = matches!(self, Bar::SpaceTurned) && i % 2 == 0;
            let [a, b] = if turned { [i + 1, i] } else { [i, i + 1] };
            let _ = writeln!(elements, "{i}, {a}, {b}");
        }
        let (kind, side, flat, pull) = match self {
            Bar::Plane => (
                "T2D2",
                "BAR, SNEG",
                "*SURFACE, NAME=FLAT, TYPE=SEGMENTS\nSTART, -500., 0.\nLINE, 500., 0.\n",
                format!("{}, 1, {FORCE}\n", n + 1),
            ),
            Bar::Space | Bar::SpaceTurned => (
                "T3D2",
                "BAR,",
                "*SURFACE, NAME=FLAT, TYPE=CYLINDER\n0., 0., 0., 1., 0., 0.\n0., 1., 0.\nSTART, -500., 0.\nLINE, 500., 0.\n",
                format!("{}, 1, {:?}\n{}, 2, {:?}\n", n + 1, FORCE * x, n + 1, FORCE * y),
            ),
        };
        format!(
            "*NODE, NSET=BAR\n{nodes}*NODE\n9999, 0., 0., -5.\n*ELEMENT, TYPE={kind}, ELSET=BAR\n{elements}\
             *MATERIAL, NAME=M\n*ELASTIC\n1e5, 0.\n*SOLID SECTION, ELSET=BAR, MATERIAL=M\n1.,\n*SURFACE, NAME=LINE\n{side}\n\
             {flat}*RIGID BODY, ANALYTICAL SURFACE=FLAT, REF NODE=9999\n*SURFACE INTERACTION, NAME=I\n\
             *SURFACE BEHAVIOR, DIRECT\n*FRICTION{friction}\n0.1\n\
             *CONTACT PAIR, INTERACTION=I, TYPE=NODE TO SURFACE, SMALL SLIDING\nLINE, FLAT\n*BOUNDARY\n9999, 1, 6\n\
             *STEP\n*STATIC\n1., 1.\n*CONTROLS, PARAMETERS=FIELD\n1e-12\n*CLOAD\n{press}*END STEP\n\
             *STEP\n*STATIC\n1., 1.\n*CLOAD\n{pull}*NODE PRINT, NSET=BAR\nU\n*CONTACT PRINT\nCSTRESS, CDISP\n*END STEP\n"
        )
    }

    /// Way of the pulled end along and across the bar, and what the contact prints of the nodes.
    fn solve(self, h: f64, friction: &str) -> ([f64; 2], Vec<Table>) {
        let scratch = Scratch::new(&format!("bar_{self:?}_{h}_{}", friction.replace([' ', ',', '=', '.'], "")));
        scratch.write("bar.inp", &self.deck(h, friction));
        let run = scratch.fe(&["run", "bar.inp", "--quiet"]);
        assert_eq!(run.status, 0, "{self:?} {h}: {}", run.error);
        let tables = tables(&scratch.read("bar.dat")).unwrap();
        let u = &tables.iter().rfind(|t| t.title.starts_with("displacements")).unwrap().rows.last().unwrap().values;
        let ([x, y], [a, b]) = (self.along(), [u[0], if self.in_space() { u[1] } else { 0.0 }]);
        ([a * x + b * y, b * x - a * y], tables)
    }
}

/// The end's way with friction at nodes.
fn exact(h: f64) -> f64 {
    let share = 2.0 * h;
    let m = (FORCE / share - 0.5).ceil();
    h / 1e5 * (m * FORCE - 0.5 * share * m * m)
}

/// Exact sticking: the nodal formula to the printed digits. The shear is a force per length along the bar, against the
/// motion on the bar, t where it slips, all of it carries the force; in space it is along the line whatever its direction.
#[test]
fn a35_bar_on_coulomb_bed() {
    assert!((exact(5.0) - 0.15625).abs() < 1e-15 && (exact(8.0) - 0.15616).abs() < 1e-15);
    for bar in [Bar::Plane, Bar::Space, Bar::SpaceTurned] {
        for h in [5.0, 8.0] {
            let ([along, across], tables) = bar.solve(h, ", LAGRANGE");
            assert!((along / exact(h) - 1.0).abs() < 1e-9 && across.abs() < 1e-12, "{bar:?} {h}: {along} {across}");
            let stress = &tables.iter().rfind(|t| t.title.starts_with("contact stress")).unwrap().rows;
            // In the plane t₁ = e_z × n goes against x; a line goes from its first node to the second.
            let sense = |label: u64| match bar {
                Bar::Plane => -1.0,
                Bar::SpaceTurned if label > 1 && label % 2 == 1 => -1.0,
                _ => 1.0,
            };
            let slipping = (FORCE / (2.0 * h) - 0.5).ceil() as usize;
            let mut carried = 0.0;
            for (i, row) in stress.iter().rev().enumerate() {
                let [pressure, shear, other] = row.values[..] else { panic!("{row:?}") };
                let shear = shear * sense(row.labels[0]);
                carried += shear * if i == 0 || i + 1 == stress.len() { 0.5 * h } else { h };
                assert!((pressure / 20.0 - 1.0).abs() < 1e-9 && other.abs() < 1e-9, "{bar:?} {h}: {row:?}");
                let limit = if i < slipping { (shear - 2.0).abs() < 1e-9 } else { shear < 2.0 };
                assert!(limit, "{bar:?} {h}: {row:?}");
            }
            assert!((carried / FORCE - 1.0).abs() < 1e-9, "{bar:?} {h}: {carried}");
        }
    }
}

/// An elastic slip γ lets the end go further, by γ/2 on a bed without nodes: u = γ exp(−x √(t/γEA)) past the slip zone, at
/// whose edge it leaves the force F₁ = √(tγEA), and within it F² − F₁² = 2tEA(u − γ). Nodes change the way within the slip
/// zone by no more than th²/8EA, with elastic slip or without, and F₁²/2tEA = γ/2 by as much, the chain's decay having
/// F₁² = tγEA(1 + th²/4γEA). By default γ is a two hundredth of an element.
#[test]
fn a35_elastic_slip_adds_at_most_itself() {
    for bar in [Bar::Plane, Bar::Space] {
        for h in [5.0, 8.0] {
            for (friction, slip) in [(", ELASTIC SLIP=0.0001", 1e-4), (", ELASTIC SLIP=0.01", 0.01), ("", 0.005 * h)] {
                let ([along, _], _) = bar.solve(h, friction);
                let (more, nodes) = (along - exact(h), 3.0 * 2.0 * h * h / 8e5);
                let bounded = more > 0.0 && more <= slip && (more - 0.5 * slip).abs() <= nodes;
                assert!(bounded, "{bar:?} {h}{friction}: {more:e} of {slip}");
            }
        }
    }
}
