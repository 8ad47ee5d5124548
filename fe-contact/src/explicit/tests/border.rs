//! Where a main surface ends.

use super::*;

/// A node behind a square face, past its border by so much.
fn past(aside: f64) -> Scene {
    let corners = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [1.0, 1.0, 0.0], [0.0, 1.0, 0.0]];
    let points: Vec<_> = corners.into_iter().chain([[1.0 + aside, 0.5, -DEPTH]]).map(|x| (x, 1.0)).collect();
    let law = Arc::new(Linear { slope: 1e4, clearance: 0.0 });
    Scene::new(&masses(&points), definition(&[4], MainSurface::Faces(vec![vec![0, 1, 2, 3]]), law), &[], &[])
}

const DEPTH: f64 = 1e-3;

/// Near the border a node is as deep as it is behind the face, and is pressed out as there; what left the surface along it is
/// outside, however little it is behind.
#[test]
fn nodes_leave_a_surface_past_its_border() {
    for aside in [0.0, 1e-12, 1e-6, 1e-2] {
        let scene = past(aside);
        let gap = scene.pair.points[0].gap;
        assert!((gap + DEPTH).abs() < 1e-15, "{aside}: {gap}");
        let force = [0, 1, 2].map(|c| scene.state.force[scene.at(4, c)]);
        assert!(force[0] == 0.0 && force[1] == 0.0 && (force[2] - 1e4 * DEPTH).abs() < 1e-10, "{aside}: {force:?}");
    }
    for aside in [0.2, 0.4] {
        let scene = past(aside);
        assert!(scene.pair.points[0].gap > 0.0, "{aside}");
        assert!(scene.state.force.iter().all(|force| *force == 0.0), "{aside}");
    }
}
