//! Parts, their instances, and the assembly.

use fe_contact::surface::Main;
use fe_core::load::LoadKind;
use fe_io::{Deck, Library, Model, resolve};
use fe_mesh::{CellId, Face};

fn model(text: &str) -> Model {
    let answer = Deck::from_text("test.inp", text).and_then(|deck| resolve(&deck, &Library::default()));
    answer.unwrap_or_else(|faults| panic!("{faults}"))
}

const PARTS: &str = include_str!("good/parts.inp");

/// Three cubes of eight nodes, the node of the floor, the loose one; in the order of the deck's instances.
#[test]
fn each_instance_has_the_nodes_and_elements_of_its_part() {
    let mesh = &model(PARTS).structure.mesh;
    let names: Vec<(&str, _)> = mesh.instances.iter().map(|i| (i.name.as_str(), i.points.clone())).collect();
    assert_eq!(names, [("ONE", 0..8), ("TWO", 8..16), ("THREE", 16..24), ("FL", 24..25)]);
    assert_eq!((mesh.points.len(), mesh.cell_count()), (26, 4));
    assert_eq!(mesh.point_labels[8..16], [1, 2, 3, 4, 5, 6, 7, 8]);
    let cells: Vec<String> = mesh.cells().map(|cell| mesh.cell_name(cell)).collect();
    assert_eq!(cells, ["ONE.1", "TWO.1", "THREE.1", "1"]);
    assert_eq!([0, 15, 24, 25].map(|node| mesh.point_name(node)), ["ONE.1", "TWO.8", "FL.1", "1"]);
}

/// Up by 1, then a quarter turn about the vertical axis of the cube: (0, 0, 0) comes to lie at (1, 0, 1), exactly.
#[test]
fn an_instance_is_moved_then_turned() {
    let model = model(PARTS);
    let mesh = &model.structure.mesh;
    assert_eq!(mesh.points[8..12], [[1.0, 0.0, 1.0], [1.0, 1.0, 1.0], [0.0, 1.0, 1.0], [0.0, 0.0, 1.0]]);
    assert_eq!(mesh.points[16], [10.0, 0.0, 0.0]);
    // The floor, too: its plane z = 0 lies at z = −2.
    let Main::Rigid { surface, reference } = &model.pairs[1].0.main else { panic!("{:?}", model.pairs[1]) };
    assert!(matches!(surface.sweep, fe_contact::rigid::Sweep::Cylinder { origin: [0.0, 0.0, -2.0], .. }));
    assert_eq!((*reference, &model.references()), (24, &vec![24]));
}

/// Sets of a part belong to its instances, sets of the assembly add up over instances.
#[test]
fn sets_are_those_of_their_instance() {
    let model = model(PARTS);
    let (mesh, sets) = (&model.structure.mesh, &model.structure.mesh.node_sets);
    assert_eq!((&sets["ONE.ODD"], &sets["TWO.ODD"]), (&vec![0, 2, 4, 6], &vec![8, 10, 12, 14]));
    assert_eq!(sets["ONES"], [0, 8, 10, 12, 14]);
    assert_eq!(sets["BYNAME"], [1, 6, 14, 25]);
    assert!(!sets.contains_key("NB") && !sets.contains_key("TWO.CORNER"));
    let cell = |cell: u32| CellId { block: 0, cell };
    assert_eq!(mesh.cell_sets["BOTH"], [cell(0), cell(1)]);
    // The bridge stands in the assembly, on nodes of two instances.
    assert_eq!(mesh.cell(cell(3)), [1, 16, 19, 2, 5, 20, 23, 6]);
    let step = &model.steps[0];
    assert_eq!(step.nodal_loads.items[0].kind, LoadKind::Nodal { nodes: vec![8, 10, 12, 14], component: 2 });
    assert_eq!(step.nodal_loads.items[1].kind, LoadKind::Nodal { nodes: vec![20], component: 0 });
    assert_eq!(step.output.tables[0].set, "TWO.NB");
    assert_eq!(model.supports.len(), 8 * 3 + 6);
    assert_eq!(model.structure.sections.len(), 4);
}

/// All six faces are free; without the top five are left; the tops of two cubes, and of these the one of TWO.
#[test]
fn surfaces_combine() {
    let mesh = &model(PARTS).structure.mesh;
    let top = |cell: u32| Face { cell: CellId { block: 0, cell }, face: 1 };
    let sides: Vec<u8> = mesh.surfaces["TWO.SIDES"].iter().map(|face| face.face).collect();
    assert_eq!(sides, [0, 2, 3, 4, 5]);
    assert_eq!(mesh.surfaces["TOPS"], [top(0), top(1)]);
    assert_eq!(mesh.surfaces["UPPER"], [top(1)]);
    assert_eq!(mesh.surfaces["FEET"].len(), 2);
}

/// The same cubes written out: bodies, supports and loads are those of the deck with parts.
#[test]
fn a_part_used_once_means_what_its_cards_mean_outside() {
    let plain = include_str!("good/plain.inp");
    let section = "*SOLID SECTION, ELSET=CUBE, MATERIAL=SOFT RUBBER\n";
    let end = format!(
        "{section}*END PART\n*ASSEMBLY, NAME=A\n*INSTANCE, NAME=X, PART=P\n*END INSTANCE\n*END ASSEMBLY\n*MATERIAL"
    );
    let parts = plain.replace(section, "").replace("*NODE, NSET=ALL", "*PART, NAME=P\n*NODE, NSET=ALL");
    let parts = parts.replace("*MATERIAL", &end).replace("\nLOW, 1", "\nX.LOW, 1");
    let parts = parts.replace("\n7, 3", "\nX.7, 3").replace("NSET=TOP, TOTALS", "NSET=X.TOP, TOTALS");
    let (flat, parts) = (model(plain), model(&parts));
    assert_eq!(parts.structure.mesh.points, flat.structure.mesh.points);
    assert_eq!(parts.structure.mesh.blocks, flat.structure.mesh.blocks);
    assert_eq!((&parts.structure.sections, &parts.supports), (&flat.structure.sections, &flat.supports));
    assert_eq!(parts.steps[0].nodal_loads, flat.steps[0].nodal_loads);
    assert!(flat.structure.mesh.instances.is_empty());
}

/// A mesh file is read for each instance of its part.
#[test]
fn a_mesh_file_in_a_part() {
    let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/../apps/fe/tests/decks");
    let flat = std::fs::read_to_string(format!("{folder}/mesh_gmsh_blocks.inp")).expect("it is part of the project");
    let start = flat.find("*MESH, INPUT").expect("the deck reads a mesh");
    let end = start + 1 + flat[start + 1..].find("\n*").expect("other cards follow") + 1;
    let card = flat[start..end].replace("INPUT=", &format!("INPUT={folder}/"));
    let parts = format!(
        "*PART, NAME=P\n{card}*END PART\n*ASSEMBLY, NAME=A\n*INSTANCE, NAME=X, PART=P\n*END INSTANCE\n\
         *INSTANCE, NAME=Y, PART=P\n100., 0., 0.\n*END INSTANCE\n*END ASSEMBLY\n"
    );
    let deck = Deck::from_text("test.inp", &parts).expect("the cards are sound");
    let faults = resolve(&deck, &Library::default()).expect_err("there is no section and no step").to_string();
    // Both copies were read: their elements lack a section.
    assert!(faults.contains("have no `*SOLID SECTION`, the first is X."), "{faults}");
    assert!(!faults.contains("twice"), "{faults}");
}
