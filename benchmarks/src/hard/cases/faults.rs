//! D29: faces that are counted more than once. D30: things that are there twice. D31: things that are empty.

use crate::hard::Scene;
use crate::hard::deck::{self, Order};
use crate::hard::finding::{Finding, from_value};
use crate::hard::patch::{self, PRESSURE, Patch, YOUNG};
use crate::hard::run::Run;
use fe_core::element::ElementType;
use fe_mesh::generate::Block;
use fe_mesh::gmsh;

const BOUND: f64 = 1e-10;

/// Scenes of D29.
pub fn faces() -> Vec<Scene> {
    // Elements 1 to 8 are the lower block, 9 to 16 the upper one, rows of four from below.
    vec![
        faces_scene("a face twice in the secondary surface", ("UP_YMIN", "9, S1\n9, S1\n"), &["UP_YMIN", "twice"]),
        faces_scene("a face twice in the main surface", ("LOW_YMAX", "6, S3\n"), &["LOW_YMAX", "twice"]),
        faces_scene("a face by its element and by a set", ("UP_YMIN", "ROW, S1\n"), &["UP_YMIN", "twice"]),
        faces_scene(
            "interior faces, secondary",
            ("UP_YMIN", "9, S2\n10, S4\n13, S1\n9, S3\n"),
            &["UP_YMIN", "between"],
        ),
        faces_scene("interior faces, main", ("LOW_YMAX", "6, S1\n2, S3\n"), &["LOW_YMAX", "between"]),
        faces_scene("the main surface is both sides of a plate", ("LOW_YMAX", "LOW_BLOCK\n"), &[]),
        two_names("a second surface of two of the faces, same main", "9, S1\n10, S1\n"),
        two_names("a second surface of all of the faces, same main", "9, S1\n10, S1\n11, S1\n12, S1\n"),
        Scene::new("a plate in one pair with both sides", |place| {
            let run = place.run("plate", &plate());
            Finding::converged(&run).measured(&run, |solved| vec![(from_value(PRESSURE, &solved.pressures()), BOUND)])
        }),
    ]
}

/// The pressed patch 4/4 with more faces in one of its surfaces: the same answer, and a warning.
fn faces_scene(name: &str, (surface, more): (&'static str, &'static str), words: &'static [&'static str]) -> Scene {
    Scene::new(name, move |place| {
        let deck = plain_patch().replace(
            &format!("*SURFACE, NAME={surface}\n"),
            &format!("*ELSET, ELSET=ROW\n9, 10\n*SURFACE, NAME={surface}\n{more}"),
        );
        let run = place.run("patch", &deck);
        let found = if words.is_empty() { Finding::converged(&run) } else { Finding::warned(&run, words) };
        unchanged(found, &run)
    })
}

/// The pressed patch with a second pair of the same faces: each presses once, and a warning.
fn two_names(name: &str, faces: &'static str) -> Scene {
    Scene::new(name, move |place| {
        let deck = plain_patch()
            .replace("*SURFACE INTERACTION", &format!("*SURFACE, NAME=AGAIN\n{faces}*SURFACE INTERACTION"));
        let deck = deck.replace("UP_YMIN, LOW_YMAX\n", "UP_YMIN, LOW_YMAX\nAGAIN, LOW_YMAX\n");
        let run = place.run("patch", &deck);
        unchanged(Finding::warned(&run, &["warning: ", "AGAIN", "UP_YMIN"]), &run)
    })
}

fn plain_patch() -> String {
    let patch = Patch::plane(4, 4);
    patch.pressed(&patch.mesh(), Order::AsMade)
}

/// Pressures, displacements and the sum of the contact forces (20) are those of the plain patch.
fn unchanged(found: Finding, run: &Run) -> Finding {
    found.measured(run, |solved| {
        let sum: f64 = solved.pairs.iter().map(|pair| pair.secondary.force[1]).sum();
        let mut errors = Patch::plane(4, 4).errors_pressed(solved).map(|e| (e, BOUND)).to_vec();
        errors.push((from_value(2.0 * PRESSURE, &[sum]), BOUND));
        errors
    })
}

/// A thin plate between the two blocks, its whole skin against both of them in one pair.
fn plate() -> String {
    let patch = Patch { overlap: -0.01, ..Patch::plane(3, 4) };
    let mut mesh = patch.mesh();
    mesh.append(&Block::quad4([5, 1]).size([2.0, 0.01, 0.0]).origin([0.0, 1.0, 0.0]).mesh().prefixed("PLATE_"));
    let sets = ["LOW_BLOCK", "UP_BLOCK", "PLATE_BLOCK"];
    format!(
        "{}{}*SURFACE, NAME=SKIN\nPLATE_BLOCK\n*SURFACE, NAME=WALLS\nLOW_BLOCK\nUP_BLOCK\n\
         *SURFACE INTERACTION, NAME=I\n*SURFACE BEHAVIOR, PENALTY\n\
         *CONTACT PAIR, INTERACTION=I, TYPE=SURFACE TO SURFACE\nSKIN, WALLS\n\
         *BOUNDARY\nLOW_YMIN, 2\nLOW_XMIN, 1\nUP_XMIN, 1\nPLATE_XMIN, 1\n{}",
        deck::cards(&mesh, &sets.map(|set| (set, ElementType::CPE4)), Order::AsMade),
        deck::elastic(&sets, YOUNG, 0.3),
        patch::step(patch::EXACT, &format!("*DSLOAD\nUP_YMAX, P, {PRESSURE}\n")),
    )
}

/// Two unit squares on each other with separate nodes 3, 4 and 5, 6 between them, and no pair.
const CRACK: &str = "\
*NODE
1, 0., 0.
2, 1., 0.
3, 1., 1.
4, 0., 1.
5, 0., 1.
6, 1., 1.
7, 1., 2.
8, 0., 2.
*ELEMENT, TYPE=CPE4, ELSET=E
1, 1, 2, 3, 4
2, 5, 6, 7, 8
*MATERIAL, NAME=M
*ELASTIC
1000., 0.3
*SOLID SECTION, ELSET=E, MATERIAL=M
*BOUNDARY
1, 1, 2
2, 2
7, 1, 2
8, 2
*STEP
*STATIC
1., 1.
*CLOAD
3, 1, 1.
*END STEP
";

/// Scenes of D30.
pub fn duplicates() -> Vec<Scene> {
    vec![
        Scene::new("a crack by accident: nodes at the same place", |place| {
            let found = Finding::warned(&place.run("crack", CRACK), &["2 ", "same place", "3", "6"]);
            match place.check("check", CRACK) {
                Ok(plan) => found.holds(
                    plan.contains("2 pairs of nodes lie at the same place"),
                    format!("`fe check` does not count the cracks: {plan}"),
                ),
                Err(why) => found.holds(false, why),
            }
        }),
        Scene::new("nodes at the same place in a contact pair: no crack", |place| {
            let run = place.run("patch", &plain_patch());
            Finding::converged(&run).holds(!run.told(&["same place"]), "a contact pair is no crack")
        }),
        Scene::new("an element twice", |place| {
            let deck = plain_patch().replace("1, 1, 2, 7, 6\n", "1, 1, 2, 7, 6\n101, 1, 2, 7, 6\n");
            Finding::warned(&place.run("twice", &deck), &["warning: ", "elements 1 and 101", "same nodes"])
        }),
        Scene::new("unused nodes", |place| {
            let deck = plain_patch().replace("*NODE\n", "*NODE\n901, 5., 5.\n902, 0., 0.5\n903, 2., 1.\n");
            let run = place.run("unused", &deck);
            unchanged(Finding::converged(&run), &run)
        }),
        Scene::new("two nodes with one label", |place| {
            let deck = CRACK.replace("6, 1., 1.\n", "6, 1., 1.\n5, 0., 1.5\n");
            Finding::refused(&place.run("label", &deck), &["node 5 is there twice", "label.inp:8:", "label.inp:6:"])
        }),
        Scene::new("two elements with one label", |place| {
            let deck = CRACK.replace("2, 5, 6, 7, 8\n", "2, 5, 6, 7, 8\n1, 5, 6, 7, 8\n");
            let words = ["element 1 is there twice", "label.inp:11:", "label.inp:13:"];
            Finding::refused(&place.run("label", &deck), &words)
        }),
    ]
}

/// Scenes of D31.
pub fn empty() -> Vec<Scene> {
    let refused = |name: &str, (from, to): (&'static str, &'static str), words: &'static [&'static str]| {
        Scene::new(name, move |place| {
            let deck = plain_patch().replace(from, to);
            Finding::refused(&place.run("empty", &deck), words)
        })
    };
    let load = "*DSLOAD\nUP_YMAX, P, 10\n";
    vec![
        refused(
            "a load on an empty set",
            ("*STEP\n*STATIC\n1., 1.\n", "*NSET, NSET=UP_YMAXI\n*STEP\n*STATIC\n1., 1.\n*CLOAD\nUP_YMAXI, 2, -1.\n"),
            &["`UP_YMAXI` is empty", "`UP_YMAX`"],
        ),
        refused("a load on a missing surface", (load, "*DSLOAD\nUP_YMXA, P, 10.\n"), &["`UP_YMXA`", "`UP_YMAX`"]),
        refused(
            "a support on an empty set",
            ("*BOUNDARY\n", "*NSET, NSET=LOW_YMINS\n*BOUNDARY\nLOW_YMINS, 1\n"),
            &["`LOW_YMINS` is empty", "`LOW_YMIN`"],
        ),
        refused(
            "a pair with a missing surface",
            ("UP_YMIN, LOW_YMAX", "UP_YMIN, LOWYMAX"),
            &["`LOWYMAX`", "`LOW_YMAX`"],
        ),
        refused(
            "a pair with a surface without faces",
            ("*SURFACE INTERACTION", "*SURFACE, NAME=LOWER\n*SURFACE INTERACTION"),
            &["surface `LOWER` has no faces"],
        ),
        refused(
            "a surface on an empty element set",
            ("*SURFACE INTERACTION", "*ELSET, ELSET=UP_BLOK\n*SURFACE, NAME=S\nUP_BLOK, S1\n*SURFACE INTERACTION"),
            &["element set `UP_BLOK` is empty", "`UP_BLOCK`"],
        ),
        refused(
            "a section of an empty set",
            ("*SOLID SECTION, ELSET=UP_BLOCK", "*ELSET, ELSET=UP_BLOCKS\n*SOLID SECTION, ELSET=UP_BLOCKS"),
            &["element set `UP_BLOCKS` is empty", "`UP_BLOCK`"],
        ),
        refused(
            "a surface of nodes on an empty set",
            (
                "*SURFACE INTERACTION",
                "*NSET, NSET=UP_BLOCS\n*SURFACE, NAME=S, TYPE=NODE\nUP_BLOCS\n*SURFACE INTERACTION",
            ),
            &["node set `UP_BLOCS` is empty", "`UP_BLOCK`"],
        ),
        refused(
            "a surface of nodes without nodes",
            ("*SURFACE INTERACTION", "*SURFACE, NAME=BARE, TYPE=NODE\n*SURFACE INTERACTION"),
            &["surface `BARE` has no nodes"],
        ),
        Scene::new("a physical group that the mesh lacks", |place| {
            let mesh = Block::hex8([1, 1, 1]).mesh();
            let written = place.write("cube.msh", &gmsh::write(&mesh, gmsh::Encoding::Text));
            let deck = "*MESH, INPUT=cube.msh\nBLOCKS, C3D8\n*MATERIAL, NAME=M\n*ELASTIC\n1., 0.\n\
                        *SOLID SECTION, ELSET=BLOCKS, MATERIAL=M\n*STEP\n*STATIC\n*END STEP\n";
            Finding::refused(&place.run("group", deck), &["physical group `BLOCKS`", "`BLOCK`"])
                .holds(written.is_ok(), "the mesh could not be written")
        }),
        Scene::new("a physical group without elements", |place| {
            let mut mesh = Block::hex8([1, 1, 1]).mesh();
            mesh.cell_sets.insert("HOLLOW".into(), Vec::new());
            let written = place.write("cube.msh", &gmsh::write(&mesh, gmsh::Encoding::Text));
            let deck = "*MESH, INPUT=cube.msh\nHOLLOW, C3D8\n*MATERIAL, NAME=M\n*ELASTIC\n1., 0.\n\
                        *SOLID SECTION, ELSET=HOLLOW, MATERIAL=M\n*STEP\n*STATIC\n*END STEP\n";
            Finding::refused(&place.run("group", deck), &["HOLLOW"])
                .holds(written.is_ok(), "the mesh could not be written")
        }),
    ]
}
