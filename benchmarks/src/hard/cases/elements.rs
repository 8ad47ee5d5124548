//! D27: elements at the edge of their shape, and beyond. D33: meshes of very different fineness.

use crate::hard::Scene;
use crate::hard::deck::Order;
use crate::hard::finding::Finding;
use crate::hard::patch::Patch;
use fe_core::element::ElementType;
use fe_mesh::Mesh;

/// Bound of exact answers; it grows by the condition number in excess of 1e4, over 1e4.
const BOUND: f64 = 1e-10;

/// Scenes of D27.
pub fn bad() -> Vec<Scene> {
    let aspect = |mesh: &mut Mesh| mesh.points.iter_mut().for_each(|p| p[0] *= 1e3);
    let mut scenes = vec![
        // Sides of 500 by 0.5: stiffnesses of one element differ by the square of the ratio, 1e6.
        exact("patch 3/4 CPE4, aspect 1e3", ElementType::CPE4, 1e6, aspect),
        exact("patch 3/4 C3D8, aspect 1e3", ElementType::C3D8, 1e6, aspect),
        // The Jacobian at the flat corner is tan(0.5°) of that of the square: strains there grow by its inverse.
        exact("patch 3/4 CPE4, an angle of 179°", ElementType::CPE4, 1e6, flat_angle),
        exact("patch 3/4 C3D10, a mid-node at the quarter", ElementType::C3D10, 1e4, quarter_point),
    ];
    let refused = |name: &str, element: &'static str, nodes: &'static str, place: &'static str| {
        let deck = single(element, nodes);
        Scene::new(name, move |at| Finding::refused(&at.run("element", &deck), &["element 7", element, place, "j = "]))
    };
    scenes.push(refused(
        "a concave quadrilateral",
        "CPE4",
        "1, 0., 0.\n2, 1., 0.\n3, 0.25, 0.25\n4, 0., 1.\n*ELEMENT, TYPE=CPE4, ELSET=E\n7, 1, 2, 3, 4\n",
        "corner 3",
    ));
    scenes.push(refused(
        "an inverted brick",
        "C3D8",
        "1, 0., 0., 1.\n2, 1., 0., 1.\n3, 1., 1., 1.\n4, 0., 1., 1.\n5, 0., 0., 0.\n6, 1., 0., 0.\n7, 1., 1., 0.\n\
         8, 0., 1., 0.\n*ELEMENT, TYPE=C3D8, ELSET=E\n7, 1, 2, 3, 4, 5, 6, 7, 8\n",
        "corner 1",
    ));
    scenes.push(refused(
        "a tetrahedron without volume",
        "C3D4",
        "1, 0., 0., 0.\n2, 1., 0., 0.\n3, 0., 1., 0.\n4, 1., 1., 0.\n*ELEMENT, TYPE=C3D4, ELSET=E\n7, 1, 2, 3, 4\n",
        "corner 1",
    ));
    scenes.push(Scene::waits(
        "patch 3/4 C3D10, a mid-node of the face at the quarter",
        "exact overlaps of faces whose mid-nodes lie aside; 3e-6 now",
    ));
    scenes.push(Scene::waits("inversion in a step: cutback, then the element", "NLGEOM"));
    scenes
}

/// A pressed patch with a change to its mesh: still exact, to a bound that goes with the condition number.
fn exact(name: &str, element: ElementType, condition: f64, change: fn(&mut Mesh)) -> Scene {
    Scene::new(name, move |place| {
        let patch = Patch { element, ..Patch::plane(3, 4) };
        let mut mesh = patch.mesh();
        change(&mut mesh);
        let run = place.run("patch", &patch.pressed(&mesh, Order::AsMade));
        Finding::converged(&run)
            .measured(&run, |solved| patch.errors_pressed(solved).map(|e| (e, BOUND * condition / 1e4)).to_vec())
    })
}

/// Moves the inner node of the upper block's lowest left square near to its diagonal.
fn flat_angle(mesh: &mut Mesh) {
    let height = 0.5 * 0.5f64.hypot(0.5) * 0.5f64.to_radians().tan();
    let (inner, to) = ([0.5, 1.5], 0.25 + height / 2.0f64.sqrt());
    if let Some(point) = mesh.points.iter_mut().find(|p| p[0] == inner[0] && p[1] == inner[1]) {
        (point[0], point[1]) = (to, 1.0 + to);
    }
}

/// Moves the first mid-side node inside of the lower block to a quarter of its edge.
fn quarter_point(mesh: &mut Mesh) {
    let inside = |p: [f64; 3]| p[..2].iter().all(|x| *x > 0.1 && *x < 1.9) && p[2] > 0.1 && p[2] < 0.9;
    let edges = [[0, 1], [1, 2], [2, 0], [0, 3], [1, 3], [2, 3]];
    for cell in mesh.cell_sets["LOW_BLOCK"].clone() {
        let nodes = mesh.cell(cell).to_vec();
        for (middle, [a, b]) in edges.iter().enumerate() {
            let [a, b, m] = [nodes[*a], nodes[*b], nodes[4 + middle]].map(|n| n as usize);
            if inside(mesh.points[m]) {
                mesh.points[m] = std::array::from_fn(|c| 0.75 * mesh.points[a][c] + 0.25 * mesh.points[b][c]);
                return;
            }
        }
    }
}

/// A deck of one element.
fn single(element: &str, nodes: &str) -> String {
    let last = if element == "CPE4" { "1, 1, 2" } else { "1, 1, 3" };
    format!(
        "*NODE\n{nodes}*MATERIAL, NAME=M\n*ELASTIC\n1000., 0.3\n*SOLID SECTION, ELSET=E, MATERIAL=M\n\
         *BOUNDARY\n{last}\n*STEP\n*STATIC\n1., 1.\n*END STEP\n"
    )
}

/// Scenes of D33.
pub fn contrast() -> Vec<Scene> {
    let scene = |element: ElementType, lower: usize, upper: usize| {
        Scene::new(format!("patch {lower}/{upper} {}", element.name()), move |place| {
            let patch = Patch { element, ..Patch::plane(lower, upper) };
            let run = place.run("patch", &patch.pressed(&patch.mesh(), Order::AsMade));
            // Elements half a unit high and 2/n wide: their stiffnesses differ by the square of the ratio.
            let slenderness = (lower.max(upper) as f64 / 4.0).powi(2);
            let bound = 1e-9 * (slenderness / 1e4).max(1.0);
            let found = Finding::converged(&run)
                .measured(&run, |solved| patch.errors_pressed(solved).map(|e| (e, bound)).to_vec());
            match &run.ended {
                Ok(report) => {
                    let faces = |n: usize| if element == ElementType::C3D8 { n * n } else { n };
                    let facets = (faces(lower) + faces(upper)) as f64;
                    found.say(format!("search {:.2} µs a facet", 1e6 * report.certificate.seconds.search / facets))
                }
                Err(_) => found,
            }
        })
    };
    let plane = ElementType::CPE4;
    vec![
        scene(plane, 1, 100),
        scene(plane, 100, 1),
        scene(plane, 97, 89),
        scene(ElementType::C3D8, 1, 10),
        scene(ElementType::C3D8, 13, 11).slow(),
        scene(plane, 970, 890).slow(),
        scene(plane, 9700, 8900).slow(),
    ]
}
