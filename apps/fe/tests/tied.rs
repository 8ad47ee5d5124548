//! A17 with tied surfaces, through the program: two blocks [0, 2] × [0, 1] and [0, 2] × [1, 2], E = 1000, ν = 0.3.
#![allow(clippy::unwrap_used)]

mod common;

use common::Scratch;
use common::job::Job;
use fe_core::element::ElementType;
use fe_mesh::generate::Block;
use fe_mesh::gmsh;

/// Two blocks of so many elements across and two in height each, the upper one begins at `height`.
fn mesh(element: ElementType, across: [usize; 2], height: f64) -> fe_mesh::Mesh {
    let block = |n: usize, height: f64, name: &str| {
        let block = match element {
            ElementType::C3D8 => Block::hex8([n, n, 2]).size([2.0, 2.0, 1.0]).origin([0.0, 0.0, height]),
            _ => Block::quad4([n, 2]).size([2.0, 1.0, 0.0]).origin([0.0, height, 0.0]),
        };
        block.mesh().prefixed(name)
    };
    let mut mesh = block(across[0], 0.0, "LOW_");
    mesh.append(&block(across[1], height, "UP_"));
    mesh
}

/// The model with the interaction I, which is soft and without friction, and the pair across an axis.
fn model(element: ElementType, axis: &str, pair: &str) -> String {
    let name = element.name();
    format!(
        "*MESH, INPUT=blocks.msh\nLOW_BLOCK, {name}\nUP_BLOCK, {name}\n*MATERIAL, NAME=M\n*ELASTIC\n1000., 0.3\n\
         *SOLID SECTION, ELSET=LOW_BLOCK, MATERIAL=M\n*SOLID SECTION, ELSET=UP_BLOCK, MATERIAL=M\n\
         *SURFACE INTERACTION, NAME=I\n*SURFACE BEHAVIOR, PRESSURE-OVERCLOSURE=LINEAR\n10.\n\
         *CONTACT PAIR, INTERACTION=I, {pair}\nUP_{axis}MIN, LOW_{axis}MAX\n"
    )
}

fn run(name: &str, mesh: &fe_mesh::Mesh, deck: &str) -> Job {
    let scratch = Scratch::new(name);
    std::fs::write(scratch.path("blocks.msh"), gmsh::write(mesh, gmsh::Encoding::Binary)).unwrap();
    Job::run_in(scratch, deck)
}

const TIED: &str = "TYPE=SURFACE TO SURFACE, TIED, ADJUST=0.01";
const SCENES: [(ElementType, [usize; 2]); 4] = [
    (ElementType::CPE4, [3, 4]),
    (ElementType::CPE4, [4, 4]),
    (ElementType::C3D8, [3, 4]),
    (ElementType::C3D8, [4, 4]),
];

/// Pulled by 10, whatever the interaction says: p = −10, the top at 2·10 (1 − ν²)/E in plane strain and 2·10/E in space. A
/// discrete problem with a closed answer: 1e-9 of it, what multipliers leave at a residual of 1e-12.
#[test]
fn a17_tied_blocks_pull() {
    for (element, across) in SCENES {
        let solid = element == ElementType::C3D8;
        let (axis, component) = if solid { ("Z", 3) } else { ("Y", 2) };
        let sides = if solid { "LOW_YMIN, 2\nUP_YMIN, 2\n" } else { "" };
        let deck = format!(
            "{}*BOUNDARY\nLOW_{axis}MIN, {component}\nLOW_XMIN, 1\nUP_XMIN, 1\n{sides}*STEP\n*STATIC\n1., 1.\n\
             *CONTROLS, PARAMETERS=FIELD\n1e-12\n*DSLOAD\nUP_{axis}MAX, P, -10.\n*END STEP\n",
            model(element, axis, TIED)
        );
        // The gap of 0.005 is taken out without strain.
        let results = run("tied_pull", &mesh(element, across, 1.005), &deck).results();
        let last = results.times().len() - 1;
        let (u, pressures) = (results.point_field("U", 3, last), results.point_field("CPRESS", 1, last));
        let top = results.point_at(if solid { [2.0, 2.0, 2.005] } else { [2.0, 2.005, 0.0] });
        // One layer of elements is higher by what ADJUST moved its nodes.
        let strain = if solid { 0.01 } else { 0.0091 };
        let found = u[3 * top + component - 1];
        assert!((found - 2.005 * strain).abs() < 1e-9 * strain, "{element:?} {across:?}: {found}");
        let acting: Vec<f64> = pressures.into_iter().filter(|p| !p.is_nan()).collect();
        assert!(acting.len() > across[1] && acting.iter().all(|p| (p + 10.0).abs() < 1e-8), "{acting:?}");
    }
}

/// All sides held at u = (0.01 h, 0, 0.02 h) of the height h, so that the nodes of the edges of both surfaces are held twice:
/// the others follow, with shear and tension passed on. D04 of tied nodes that a support holds, too.
#[test]
fn a17_tied_blocks_shear_between_supports() {
    for (element, across) in SCENES {
        let solid = element == ElementType::C3D8;
        let (axis, component) = if solid { ("Z", 3) } else { ("Y", 2) };
        let mut mesh = mesh(element, across, 1.0);
        let exact = |h: f64| [0.01 * h, 0.0, 0.02 * h];
        let mut held = String::new();
        for (i, point) in mesh.points.clone().iter().enumerate() {
            let h = point[component - 1];
            let outer = h == 0.0 || h == 2.0 || (0..component - 1).any(|c| point[c] == 0.0 || point[c] == 2.0);
            if outer {
                let [x, y, rise] = exact(h);
                mesh.node_sets.insert(format!("N{i}"), vec![i as u32]);
                held += &format!("N{i}, 1, 1, {x:e}\nN{i}, {component}, {component}, {rise:e}\n");
                held += &if solid { format!("N{i}, 2, 2, {y:e}\n") } else { String::new() };
            }
        }
        let deck = format!(
            "{}*STEP\n*STATIC\n1., 1.\n*CONTROLS, PARAMETERS=FIELD\n1e-12\n*BOUNDARY\n{held}*END STEP\n",
            model(element, axis, TIED)
        );
        let results = run("tied_shear", &mesh, &deck).results();
        let last = results.times().len() - 1;
        // Constraints beside supports may be off by 1e-6 of a facet's length of 0.5. Five of them stand for the five nodes
        // between those of 3/4; the inverse of their means of hat functions has a norm of 120, of 147 in space.
        let openings = results.point_field("COPEN", 1, last);
        assert!(openings.iter().all(|gap| gap.is_nan() || gap.abs() <= 5e-7), "{element:?} {across:?}: {openings:?}");
        let u = results.point_field("U", 3, last);
        for (u, point) in u.chunks_exact(3).zip(&mesh.points) {
            let [x, y, rise] = exact(point[component - 1]);
            let expected = if solid { [x, y, rise] } else { [x, rise, 0.0] };
            assert!((0..3).all(|c| (u[c] - expected[c]).abs() < 8e-5), "{element:?} {across:?}: {u:?} {expected:?}");
        }
    }
}

/// Nodes that ADJUST leaves where they are do not lie on the main surface: they are free, and the program says so.
#[test]
fn nodes_that_do_not_land_are_free() {
    let mut mesh = mesh(ElementType::CPE4, [4, 4], 1.005);
    let left = (0..mesh.points.len() as u32).filter(|&n| mesh.points[n as usize][0] <= 1.0).collect();
    mesh.node_sets.insert("LEFT".into(), left);
    let deck = format!(
        "{}*BOUNDARY\nLOW_YMIN, 1, 2\nUP_XMIN, 1\n*STEP\n*STATIC\n1., 1.\n*DSLOAD\nUP_YMAX, P, -10.\n*END STEP\n",
        model(ElementType::CPE4, "Y", "TYPE=SURFACE TO SURFACE, TIED, ADJUST=LEFT")
    );
    let job = run("tied_free", &mesh, &deck);
    let words = "2 of 5 nodes of UP_YMIN do not lie on LOW_YMAX and are free";
    assert!(job.told.contains(words), "{}", job.told);
    let results = job.results();
    let pressures = results.point_field("CPRESS", 1, results.times().len() - 1);
    assert_eq!(pressures.iter().filter(|p| p.abs() > 0.0).count(), 3, "{pressures:?}");
}
