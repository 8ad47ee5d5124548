//! C01: constant strain on distorted meshes.

use super::scene::{Scene, jiggle, straighten};
use crate::element::{ElementType, Space};

type Field = fn([f64; 3]) -> [f64; 3];

/// Boundary held in a field of constant strain; inner nodes and all stresses must follow to 1e-12 of the largest:
/// round-off 1e-16 times a condition of at most some thousands.
fn patch(element: ElementType, distortion: f64) {
    let counts = if element.space() == Space::Solid { [3, 3, 3] } else { [4, 4, 0] };
    let offset = if element.space() == Space::Axisymmetric { 0.5 } else { 0.0 };
    let mut scene = Scene::grid(element, counts, |x| {
        let y = jiggle(x, distortion / counts[0] as f64);
        [y[0] + offset, y[1], y[2]]
    })
    .with_material(1e6, 0.25);
    straighten(&mut scene);
    let (exact, stress): (Field, [f64; 6]) = match element.space() {
        Space::Solid | Space::Any => (
            |[x, y, z]| [2.0 * x + y + z, x + 2.0 * y + z, x + y + 2.0 * z].map(|v| 5e-4 * v),
            [2000.0, 2000.0, 2000.0, 400.0, 400.0, 400.0],
        ),
        Space::PlaneStress | Space::Plane => (
            |[x, y, _]| [1e-3 * (x + y / 2.0), 1e-3 * (y + x / 2.0), 0.0],
            [4000.0 / 3.0, 4000.0 / 3.0, 0.0, 400.0, 0.0, 0.0],
        ),
        Space::PlaneStrain => {
            (|[x, y, _]| [1e-3 * (x + y / 2.0), 1e-3 * (y + x / 2.0), 0.0], [1600.0, 1600.0, 800.0, 400.0, 0.0, 0.0])
        }
        // u_r = c r, u_z = d z with c = 1e-3, d = 2e-3: λ = 4e5, 2μ = 8e5, trace 4e-3
        Space::Axisymmetric => (|[r, z, _]| [1e-3 * r, 2e-3 * z, 0.0], [2400.0, 3200.0, 2400.0, 0.0, 0.0, 0.0]),
    };
    let edge = |x: f64, low: f64| (x - low).abs() < 1e-9 || (x - low - 1.0).abs() < 1e-9;
    let held = |x: [f64; 3], component: usize| {
        let on = edge(x[0], offset) || edge(x[1], 0.0) || (element.space() == Space::Solid && edge(x[2], 0.0));
        on.then(|| exact(x)[component])
    };
    let u = scene.solve(&vec![0.0; scene.freedoms.len()], held);
    for (u, e) in u.iter().zip(scene.field(exact)) {
        assert!((u - e).abs() < 1e-12 * 2e-3, "{element:?}: {u} {e}");
    }
    let fields = scene.block().stresses(&u);
    for s in fields.stress.iter().flat_map(|s| s.iter().zip(&stress)) {
        assert!((s.0 - s.1).abs() < 1e-12 * 3200.0, "{element:?}: {} {}", s.0, s.1);
    }
}

#[test]
#[allow(non_snake_case)]
fn C01_patch() {
    for element in ElementType::SOLIDS {
        for distortion in [0.0, 0.2, 0.35] {
            patch(element, distortion);
        }
    }
}

/// A plane element with an interior angle of nearly 180° and a hexahedron with a collapsed edge still pass.
#[test]
#[allow(non_snake_case)]
fn C01_patch_on_extreme_shapes() {
    let kite = vec![[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.51, 0.51, 0.0], [0.0, 1.0, 0.0]];
    let wedge = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0], [1.1, 0.0, 0.9], [0.1, 1.2, 1.0]];
    let scenes = [
        Scene::new(ElementType::CPS4, kite.clone(), vec![0, 1, 2, 3]),
        Scene::new(ElementType::CPE4, kite, vec![0, 1, 2, 3]),
        Scene::new(ElementType::C3D8, wedge.to_vec(), vec![0, 1, 2, 2, 3, 4, 5, 5]),
    ];
    for scene in scenes {
        let u = scene.field(|[x, y, z]| [x + y, y - z, z + 0.5 * x]);
        let fields = scene.block().stresses(&u);
        let strain = if scene.element().space() == Space::Solid {
            [1.0, 1.0, 1.0, 0.5, -0.5, 0.25]
        } else {
            [1.0, 1.0, fields.strain[0][2], 0.5, 0.0, 0.0]
        };
        for found in &fields.strain {
            (0..6).for_each(|i| assert!((found[i] - strain[i]).abs() < 1e-12, "{:?} {found:?}", scene.element()));
        }
    }
}
