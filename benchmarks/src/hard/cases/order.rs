//! D35: threads, and the order in which things stand in the deck.

use crate::hard::Scene;
use crate::hard::ball::{self, Ball};
use crate::hard::deck::Order;
use crate::hard::finding::{Finding, difference};
use crate::hard::run::{Place, Run, Solved};

/// Bound of D35 on shuffled decks.
const SHUFFLED: f64 = 1e-10;

/// Scenes of D35.
pub fn scenes() -> Vec<Scene> {
    let shuffled = |name: &str, ball: fn() -> Ball| Scene::new(name, move |place| shuffled(place, &ball())).slow();
    vec![
        Scene::new("ball, 1, 2 and 8 threads, bit for bit", threads).slow(),
        shuffled("ball, nodes and elements backwards", || Ball { order: Order::Backwards, ..two_pairs() }),
        shuffled("ball, nodes and elements shuffled", || Ball { order: Order::Strided(99_991), ..two_pairs() }),
        shuffled("ball, pairs in the other order", || Ball { pairs: vec!["RIGHT", "LEFT"], ..two_pairs() }),
    ]
}

/// The lower part of the skin as two surfaces, each a pair with the flat.
fn two_pairs() -> Ball {
    Ball { pairs: vec!["LEFT", "RIGHT"], ..Ball::default() }
}

fn deck(ball: &Ball) -> String {
    let mut mesh = ball::mesh();
    ball::lower_skin(&mut mesh, -5.0);
    let side = |face: &&fe_mesh::Face| mesh.face(**face).1.iter().all(|&n| mesh.points[n as usize][0] <= 0.0);
    let (left, right): (Vec<_>, Vec<_>) = mesh.surfaces["SKIN"].iter().partition(side);
    mesh.surfaces.insert("LEFT".into(), left);
    mesh.surfaces.insert("RIGHT".into(), right);
    ball.deck(&mesh)
}

fn threads(place: &Place) -> Finding {
    let deck = deck(&two_pairs());
    let runs = [1, 2, 8].map(|n| place.run_with_threads(&format!("threads_{n}"), &deck, n));
    let bits = |run: &Run| run.u().iter().map(|u| u.to_bits()).collect::<Vec<u64>>();
    let mut found = Finding::converged(&runs[0]);
    for run in &runs[1..] {
        let same = bits(run) == bits(&runs[0]) && run.iterations == runs[0].iterations;
        let same = same && run.certificates == runs[0].certificates;
        found = found.and(Finding::converged(run)).holds(same, "other bits with another number of threads");
    }
    found
}

/// The same ball from another deck: displacements and contact forces by label, iterations.
fn shuffled(place: &Place, ball: &Ball) -> Finding {
    let (reference, run) = (place.run("reference", &deck(&two_pairs())), place.run("shuffled", &deck(ball)));
    let found = Finding::converged(&run).and(Finding::converged(&reference)).holds(
        run.iterations == reference.iterations,
        format!("{} iterations instead of {}", run.iterations, reference.iterations),
    );
    let Some(expected) = reference.solved() else { return found };
    let numbers = |solved: &Solved| {
        let u: Vec<f64> = solved.displacements().into_iter().flatten().collect();
        (u, solved.contact_forces().into_iter().flat_map(|(_, force)| force).collect::<Vec<f64>>())
    };
    let (u, forces) = numbers(&expected);
    found.measured(&run, |solved| {
        let (v, now) = numbers(solved);
        vec![(difference(&u, &v), SHUFFLED), (difference(&forces, &now), SHUFFLED)]
    })
}
