//! A deck and its mesh through the program, and what it leaves.

use benchmarks::problem::{MeshFile, Scene};
use fe::Report;
use fe::observer::Silent;
use fe::terms::Terms;
use fe_core::element::ElementType;
use fe_io::{Deck, resolve};
use fe_mesh::Mesh;
use std::fmt::Write;
use std::path::Path;
use std::sync::atomic::{AtomicUsize, Ordering};

/// What a run leaves, with the terms that it was made of.
pub struct Solution {
    /// Structure, solids and pairs, as the program built them.
    pub terms: Terms,
    /// Displacement of each point [L].
    pub u: Vec<[f64; 3]>,
    /// Certificate and last state.
    pub report: Report,
}

static RUNS: AtomicUsize = AtomicUsize::new(0);

/// Runs a mesh of one element type with these cards in a folder of its own.
pub fn run(name: &str, element: ElementType, mesh: Mesh, cards: &str) -> Solution {
    run_sets(name, vec![("BLOCK", element)], mesh, cards)
}

/// The same with an element type for each of these cell sets.
pub fn run_sets(name: &str, elements: Vec<(&'static str, ElementType)>, mesh: Mesh, cards: &str) -> Solution {
    let number = RUNS.fetch_add(1, Ordering::Relaxed);
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("verification").join(format!("{name}_{number}"));
    let scene = Scene { name: "job".into(), mesh, elements, cards: cards.into(), unknowns: 0 };
    let deck = scene.write(&folder, MeshFile::Gmsh).unwrap();
    let library = fe::standard();
    let report = fe::run(&deck, &library, &mut Silent).unwrap_or_else(|failure| panic!("{name}: {failure}"));
    let model = resolve(&Deck::read(&deck).unwrap(), &library).unwrap();
    let terms = Terms::new(&model).unwrap();
    std::fs::remove_dir_all(&folder).unwrap();
    let u = (0..terms.freedoms.nodes()).map(|node| displacement(&terms, &report.last.u, node)).collect();
    Solution { terms, u, report }
}

fn displacement(terms: &Terms, u: &[f64], node: usize) -> [f64; 3] {
    let freedoms = &terms.freedoms;
    [0, 1, 2].map(|component| freedoms.index(node, component).map_or(0.0, |freedom| u[freedom]))
}

/// Material and section of the set BLOCK.
pub fn material(young: f64, poisson: f64) -> String {
    material_of("BLOCK", young, poisson)
}

/// Material and section of a set, both of its name.
pub fn material_of(set: &str, young: f64, poisson: f64) -> String {
    format!("*MATERIAL, NAME={set}\n*ELASTIC\n{young:?}, {poisson:?}\n*SOLID SECTION, ELSET={set}, MATERIAL={set}\n")
}

/// A step in one increment.
pub fn step(cards: &str) -> String {
    format!("*STEP\n*STATIC\n1., 1.\n{cards}*END STEP\n")
}

/// The same down to a residual of round-off, for answers that are exact.
pub fn exact_step(cards: &str) -> String {
    step(&format!("*CONTROLS, PARAMETERS=FIELD\n1e-12\n{cards}"))
}

/// A pair of surfaces under hard contact by multipliers.
pub fn pair(secondary: &str, main: &str, kind: &str) -> String {
    format!(
        "*SURFACE INTERACTION, NAME=HARD\n*SURFACE BEHAVIOR, DIRECT\n\
         *CONTACT PAIR, INTERACTION=HARD, TYPE={kind}, SMALL SLIDING\n{secondary}, {main}\n"
    )
}

/// A rigid profile of plane and axisymmetric scenes: its lines, and the reference node's label.
pub fn profile(name: &str, reference: usize, lines: &str) -> String {
    format!(
        "*NODE\n{reference}, 0., -1.\n*SURFACE, NAME={name}, TYPE=SEGMENTS\n{lines}\
         *RIGID BODY, ANALYTICAL SURFACE={name}, REF NODE={reference}\n"
    )
}

/// `*BOUNDARY` of these nodes and components, from 0, with the displacements of a field.
pub fn prescribed(mesh: &Mesh, nodes: &[u32], components: &[usize], field: impl Fn([f64; 3]) -> [f64; 3]) -> String {
    let mut cards = String::from("*BOUNDARY\n");
    for &node in nodes {
        let (label, u) = (mesh.point_labels[node as usize], field(mesh.points[node as usize]));
        for &c in components {
            let _ = writeln!(cards, "{label}, {0}, {0}, {1:?}", c + 1, u[c]);
        }
    }
    cards
}

/// `*CLOAD` of a force [F] on each node.
pub fn forces(mesh: &Mesh, forces: impl IntoIterator<Item = (u32, [f64; 3])>) -> String {
    let mut cards = String::from("*CLOAD\n");
    for (node, force) in forces {
        for (c, value) in force.into_iter().enumerate().filter(|(_, value)| *value != 0.0) {
            let _ = writeln!(cards, "{}, {}, {value:?}", mesh.point_labels[node as usize], c + 1);
        }
    }
    cards
}
