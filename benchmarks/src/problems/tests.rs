use super::*;
use crate::problem::{Answer, MeshFile};
use fe_core::element::ElementType;

/// Errors of a problem's scenes at the refinements `sizes`, each run by the program itself; by norm.
fn errors(problem: &dyn Problem, element: ElementType, variant: &str, sizes: [usize; 2]) -> Vec<[f64; 2]> {
    let curve = problem.curves().into_iter().find(|curve| curve.element == element && curve.variant == variant);
    let folder = std::env::temp_dir().join(format!("benchmarks_{}_{}", problem.name(), std::process::id()));
    let [coarse, fine] = sizes.map(|n| {
        let scene = problem.scene(curve.as_ref().unwrap(), n);
        let deck = scene.write(&folder, MeshFile::Gmsh).unwrap();
        let arguments = ["fe", "run", deck.to_str().unwrap(), "--quiet", "--threads", "1"];
        fe::main_with(fe::standard(), arguments.map(Into::into));
        problem.errors(&scene, &Answer::read(&deck.with_extension("dat")).unwrap()).unwrap()
    });
    std::fs::remove_dir_all(&folder).unwrap();
    coarse.into_iter().zip(fine).map(|(coarse, fine)| [coarse.abs(), fine.abs()]).collect()
}

/// Asserts that an error falls at least with this rate when the mesh is halved.
fn assert_rate(name: &str, [coarse, fine]: [f64; 2], least: f64) {
    let rate = (coarse / fine).log2();
    assert!(rate > least, "{name}: {coarse:.3e} {fine:.3e}, rate {rate:.3}");
}

/// Theory: energy falls with h^p, displacement with h^(p+1); less a tenth. On meshes as coarse as these tetrahedra of
/// either kind show one of the two only.
#[test]
fn the_sphere_converges_as_its_elements_do() {
    use ElementType::{C3D4, C3D8, C3D10, CAX3, CAX4};
    let plane = [(CAX3, [16, 32], [0.9, 1.9]), (CAX4, [8, 16], [0.9, 1.9])];
    let solid = [(C3D4, [4, 8], [0.9, 0.0]), (C3D8, [4, 8], [0.9, 1.9]), (C3D10, [2, 4], [0.0, 2.9])];
    for (element, sizes, rates) in plane.into_iter().chain(solid) {
        let found = errors(&thick_sphere::ThickSphere, element, "", sizes);
        found.into_iter().zip(rates).for_each(|(norm, rate)| assert_rate(element.name(), norm, rate));
    }
}

/// Bounds of the exact window with n edges along half the contact width, of squares with contact at nodes: energy
/// 0.5/n, displacement 0.09/n², pressure 0.45/n; twice that for pressures that are averaged, and again for triangles
/// (with contact at nodes their displacement error is 0.167/n²). Rates 1, 2 and 1, less a tenth, a quarter for the
/// pressure. The penalty grows with 1/h², so that it spoils neither; multipliers do not at all.
#[test]
fn the_roller_keeps_the_bounds_of_first_order() {
    let (stiff, direct) = ("surface to surface, K/h²", "surface to surface, multipliers");
    for (element, variant, factor) in
        [(ElementType::CPE4, stiff, 2.0), (ElementType::CPE4, direct, 2.0), (ElementType::CPE3, stiff, 4.0)]
    {
        let found = errors(&hertz_line::HertzLine, element, variant, [16, 32]);
        let (rates, bounds) = ([0.9, 1.9, 0.75], [0.5 / 32.0, 0.09 / 1024.0, 0.45 / 32.0]);
        for ((errors, rate), bound) in found.into_iter().zip(rates).zip(bounds) {
            assert!(errors[1] < factor * bound, "{element:?}: {:.3e} > {factor} · {bound:.3e}", errors[1]);
            assert_rate(element.name(), errors, rate);
        }
    }
}

/// Bounds around an axis with n edges along the contact radius: pressure 0.7/n, twice that where it is averaged or given
/// by a penalty; radius within half an edge. The pressure's rate is 1, less a quarter.
#[test]
fn the_ball_keeps_the_bounds_of_first_order() {
    for variant in ["surface to surface", "node to surface"] {
        let found = errors(&hertz_ball::HertzBall, ElementType::CAX4, variant, [8, 16]);
        assert!(found[2][1] < 2.0 * 0.7 / 16.0 && found[1][1] < 0.5 / 16.0, "{variant} {found:?}");
        assert_rate(variant, found[2], 0.75);
    }
}
