//! A28, derivatives against differences, limits.

use super::*;

fn coulomb(friction: f64, largest: Option<f64>, spring: Spring) -> Coulomb {
    Coulomb { limit: Some((Coefficient::Constant(friction), largest)), spring }
}

/// Shear along a path of slips at a pressure of 100, and the work lost.
fn follow(law: &Coulomb, path: &[f64]) -> (Vec<f64>, f64) {
    let (mut elastic, mut lost) = ([0.0; 2], 0.0);
    let shears = path.windows(2).map(|ends| {
        let slip = [0.0, ends[1] - ends[0]];
        let answer = law.respond(Sliding { pressure: 100.0, elastic, slip, dt: 1.0 });
        lost += answer.shear[1] * (slip[1] - answer.elastic[1] + elastic[1]);
        elastic = answer.elastic;
        assert_eq!(answer.shear[0], 0.0);
        answer.shear[1]
    });
    (shears.collect(), lost)
}

const PATH: [f64; 6] = [0.0, 0.005, 0.02, 0.015, 0.0, -0.02];

/// Sums of a few numbers of the size of 1e-2, times slopes up to 3e3.
fn assert_near(found: &[f64], expected: &[f64]) {
    assert!(found.iter().zip(expected).all(|(f, e)| (f - e).abs() < 1e-12), "{found:?} {expected:?}");
}

#[test]
fn a28_coulomb_point() {
    let (shears, lost) = follow(&coulomb(0.3, None, Spring::Slip(0.01)), &PATH);
    assert_near(&shears, &[15.0, 30.0, 15.0, -30.0, -30.0]);
    assert_near(&[lost], &[0.9]);
    let (shears, lost) = follow(&coulomb(0.3, Some(20.0), Spring::Slip(0.01)), &PATH);
    assert_near(&shears, &[10.0, 20.0, 10.0, -20.0, -20.0]);
    assert_near(&[lost], &[0.6]);
}

/// On ever stiffer springs, as multipliers make them: ±30 wherever it slips, which begins at once; rough points never do.
#[test]
fn a28_exact_stick_and_rough() {
    let (shears, lost) = follow(&coulomb(0.3, None, Spring::Stiffness(1e15)), &PATH);
    assert_near(&shears, &[30.0, 30.0, -30.0, -30.0, -30.0]);
    // All of the way but elastic slips of 3e-14, forth and back.
    assert!((lost - 30.0 * 0.06).abs() < 30.0 * 4.0 * 3e-14, "{lost}");
    let rough = Coulomb { limit: None, spring: Spring::Stiffness(1e4) };
    let answer = rough.respond(Sliding { pressure: 1e-9, elastic: [3.0, 0.0], slip: [0.0, 4.0], dt: 1.0 });
    assert!(!answer.slips && answer.shear == [3e4, 4e4]);
}

/// Derivatives are central differences: truncation h² over the size of the arguments, round-off 1e-16/h; h = 1e-6.
#[test]
fn derivatives_are_slopes() {
    let rows = [(0.5, 0.0, 1.0), (0.3, 4.0, 1.0), (0.4, 0.0, 9.0), (0.1, 4.0, 9.0)];
    let coefficients = [
        Coefficient::Constant(0.3),
        Coefficient::table(&rows).unwrap(),
        Coefficient::Decay { rest: 0.4, kinetic: 0.2, decay: 0.5 },
    ];
    let mut next = crate::tests::scene::numbers(3);
    let (mut slipping, mut sticking) = (0, 0);
    for (k, spring) in [Spring::Slip(0.7), Spring::Stiffness(2.0)].into_iter().cycle().take(300).enumerate() {
        let largest = (k % 5 == 0).then_some(0.9);
        let law = Coulomb { limit: Some((coefficients[k % 3].clone(), largest)), spring };
        let pressure = 4.0 + 2.0 * next();
        let at = Sliding { pressure, elastic: [next() * 0.4, next() * 0.4], slip: [next(), next()], dt: 0.5 };
        let answer = law.respond(at);
        *(if answer.slips { &mut slipping } else { &mut sticking }) += 1;
        let step = 1e-6;
        let difference = |low: Sliding, high: Sliding| {
            let (low, high) = (law.respond(low), law.respond(high));
            (low.slips == high.slips).then(|| [0, 1].map(|i| (high.shear[i] - low.shear[i]) / (2.0 * step)))
        };
        let pressed = |d: f64| Sliding { pressure: pressure + d, ..at };
        let slid = |j: usize, d: f64| {
            let mut slip = at.slip;
            slip[j] += d;
            Sliding { slip, ..at }
        };
        let compare = |found: Option<[f64; 2]>, expected: [f64; 2]| {
            let Some(found) = found else { return };
            assert!((0..2).all(|i| (found[i] - expected[i]).abs() < 1e-8), "{law:?} {at:?} {found:?} {expected:?}");
        };
        compare(difference(pressed(-step), pressed(step)), answer.by_pressure);
        for j in 0..2 {
            let expected = [0, 1].map(|i| answer.stiffness[i][j] + answer.rest[i][j]);
            compare(difference(slid(j, -step), slid(j, step)), expected);
        }
    }
    assert!(slipping > 50 && sticking > 50, "{slipping} {sticking}");
}

/// No shear and no number that is not finite where nothing presses; a touching point sticks at rest.
#[test]
fn nothing_holds_without_pressure() {
    for spring in [Spring::Slip(0.01), Spring::Stiffness(1e4)] {
        for pressure in [0.0, -3.0] {
            for slip in [[0.0; 2], [0.3, -0.1]] {
                let answer = coulomb(0.3, None, spring).respond(Sliding { pressure, elastic: [0.0; 2], slip, dt: 0.0 });
                assert!(answer.shear == [0.0; 2] && answer.elastic.iter().all(|e| e.is_finite()), "{answer:?}");
                assert!(answer.stiffness.concat().iter().chain(&answer.by_pressure).all(|v| v.is_finite()));
                assert!(slip != [0.0; 2] || !answer.slips);
            }
        }
    }
}
