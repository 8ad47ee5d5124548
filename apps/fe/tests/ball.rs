//! B05: a steel ball hits a rigid flat; beside Hertz's quasi-static impact (Johnson, Contact Mechanics, 1985, 11.4).
#![allow(clippy::unwrap_used)]

mod common;

use common::job::Job;

const RADIUS: f64 = 10.0;
const SPEED: f64 = 1000.0;
/// Of Hertz: approach [L], largest force [F], time [T], largest contact radius [L].
const APPROACH: f64 = 0.017795109143;
const FORCE: f64 = 2309.76407922;
const TIME: f64 = 5.23759031431e-5;
const CONTACT: f64 = 0.421842495999;

/// What came of an impact.
#[derive(Debug)]
struct Impact {
    /// Way of the centre of mass, largest force, time from the first touch to the last, over those of Hertz.
    approach: f64,
    force: f64,
    time: f64,
    /// Velocity afterwards over that before.
    restitution: f64,
}

/// Where lines of a mesh are along a length: a little more than the contact radius in steps of `step`, then each a fifth longer
/// than the last, fitted to the length.
fn places(length: f64, mut step: f64, even: usize) -> Vec<f64> {
    let mut places = vec![0.0];
    while places[places.len() - 1] < length {
        if places.len() > even {
            step *= 1.2;
        }
        places.push(places[places.len() - 1] + step);
    }
    let (first, last) = (places[even], places[places.len() - 1]);
    let fitted = |x: f64| if x <= first { x } else { first + (x - first) * (length - first) / (last - first) };
    places.into_iter().map(fitted).collect()
}

/// A grid of [−1, 1]³ or less becomes a ball above z = 0, its lower pole in the middle of the lower face.
struct Grid {
    across: Vec<f64>,
    up: Vec<f64>,
}

impl Grid {
    /// With so many elements along the contact radius.
    fn new(elements: usize) -> Self {
        let step = CONTACT / RADIUS / elements as f64;
        // The map shrinks what lies across at the pole by √2.
        Grid { across: places(1.0, step * 2f64.sqrt(), elements + 1), up: places(2.0, step, elements + 1) }
    }

    /// Layers are fine beneath the pole alone: where two faces meet, at the corners, all are alike.
    fn point(&self, [i, j, k]: [usize; 3]) -> [f64; 3] {
        let [x, y] = [i, j].map(|i| self.across[i]);
        let corner = x.max(y);
        let z = (1.0 - corner) * self.up[k] + corner * 2.0 * k as f64 / (self.up.len() - 1) as f64 - 1.0;
        let [a, b, c] = [x * x, y * y, z * z];
        let round = |x: f64, a: f64, b: f64| RADIUS * x * (1.0 - 0.5 * (a + b) + a * b / 3.0).sqrt();
        [round(x, b, c), round(y, c, a), round(z, a, b) + RADIUS]
    }

    /// True for elements in whose column the flat may be touched.
    fn is_near(&self, [i, j]: [usize; 2]) -> bool {
        self.across[i.max(j) + 1] < 0.12
    }
}

/// A section through the axis.
fn ring(elements: usize) -> String {
    let grid = Grid::new(elements);
    let [n, m] = [&grid.across, &grid.up].map(|places| places.len() - 1);
    let label = |i: usize, k: usize| 1 + i + k * (n + 1);
    let (mut nodes, mut cells, mut pole, mut axis) = (String::new(), String::new(), String::new(), String::new());
    for k in 0..=m {
        for i in 0..=n {
            let [r, _, z] = grid.point([i, 0, k]);
            nodes += &format!("{}, {r:?}, {z:?}\n", label(i, k));
        }
        axis += &format!("{}\n", label(0, k));
    }
    for cell in 0..n * m {
        let (i, k) = (cell % n, cell / n);
        let corners = [(i, k), (i + 1, k), (i + 1, k + 1), (i, k + 1)].map(|(i, k)| label(i, k).to_string());
        cells += &format!("{}, {}\n", cell + 1, corners.join(", "));
        if k == 0 && grid.is_near([i, 0]) {
            pole += &format!("{}, S1\n", cell + 1);
        }
    }
    format!(
        "*NODE, NSET=ALL\n{nodes}*ELEMENT, TYPE=CAX4R, ELSET=BALL\n{cells}*NSET, NSET=AXIS\n{axis}*NODE, NSET=FLAT\n1000000, 0., -1.\n\
         *SURFACE, NAME=POLE\n{pole}*SURFACE, NAME=PLANE, TYPE=SEGMENTS\nSTART, -1., 0.\nLINE, 20., 0.\n*BOUNDARY\nFLAT, 2\nAXIS, 1\n\
         *INITIAL CONDITIONS, TYPE=VELOCITY\nALL, 2, -{SPEED}\n"
    )
}

/// A quarter.
fn quarter(elements: usize) -> String {
    let grid = Grid::new(elements);
    let [n, m] = [&grid.across, &grid.up].map(|places| places.len() - 1);
    let label = |i: usize, j: usize, k: usize| 1 + i + (n + 1) * (j + (n + 1) * k);
    let (mut nodes, mut cells, mut pole) = (String::new(), String::new(), String::new());
    let mut planes = [String::new(), String::new()];
    for node in 0..(n + 1) * (n + 1) * (m + 1) {
        let [i, j, k] = [node % (n + 1), node / (n + 1) % (n + 1), node / ((n + 1) * (n + 1))];
        let [x, y, z] = grid.point([i, j, k]);
        nodes += &format!("{}, {x:?}, {y:?}, {z:?}\n", node + 1);
        for (plane, _) in planes.iter_mut().zip([i, j]).filter(|(_, at)| *at == 0) {
            *plane += &format!("{}\n", node + 1);
        }
    }
    for cell in 0..n * n * m {
        let [i, j, k] = [cell % n, cell / n % n, cell / (n * n)];
        let face = |k| [(i, j), (i + 1, j), (i + 1, j + 1), (i, j + 1)].map(|(i, j)| label(i, j, k).to_string());
        cells += &format!("{}, {}, {}\n", cell + 1, face(k).join(", "), face(k + 1).join(", "));
        if k == 0 && grid.is_near([i, j]) {
            pole += &format!("{}, S1\n", cell + 1);
        }
    }
    let [first, second] = planes;
    format!(
        "*NODE, NSET=ALL\n{nodes}*ELEMENT, TYPE=C3D8R, ELSET=BALL\n{cells}*NSET, NSET=XSYM\n{first}*NSET, NSET=YSYM\n{second}\
         *NODE, NSET=FLAT\n1000000, 0., 0., -1.\n*SURFACE, NAME=POLE\n{pole}*SURFACE, NAME=PLANE, TYPE=CYLINDER\n0., 0., 0., 1., 0., 0.\n\
         0., 1., 0.\nSTART, -20., 0.\nLINE, 20., 0.\n*BOUNDARY\nFLAT, 1, 6\nXSYM, 1\nYSYM, 2\n\
         *INITIAL CONDITIONS, TYPE=VELOCITY\nALL, 3, -{SPEED}\n"
    )
}

/// A mesh that is one of so many parts of the ball, through the program in a folder of this name; the force is that on the flat,
/// along an axis (from 0).
fn hit(name: &str, mesh: &str, contact: &str, (parts, axis): (f64, usize)) -> Impact {
    let deck = format!(
        "{mesh}*MATERIAL, NAME=STEEL\n*ELASTIC\n210e3, 0.3\n*DENSITY\n7.85e-9\n*SOLID SECTION, ELSET=BALL, MATERIAL=STEEL\n\
         *RIGID BODY, ANALYTICAL SURFACE=PLANE, REF NODE=1000000\n*STEP\n*DYNAMIC, EXPLICIT\n, 6e-5\n*BULK VISCOSITY\n0., 0.\n\
         {contact}*OUTPUT, FIELD, NUMBER INTERVAL=1\n*OUTPUT, HISTORY, FREQUENCY=1\n*NODE OUTPUT, NSET=FLAT\nRF\n*ENERGY OUTPUT\n\
         ALLKE\n*END STEP\n"
    );
    let results = Job::run(name, &deck).results();
    let energy = results.real("Signorini/History/Energies")[3];
    let mass = 2.0 * energy / (SPEED * SPEED);
    // Time, step and increment come first.
    let forces: Vec<(f64, f64)> =
        results.real("Signorini/History/RF of FLAT").chunks_exact(6).map(|row| (row[0], row[3 + axis])).collect();
    let (mut z, mut v, mut deepest) = (0.0, -SPEED, 0.0f64);
    for two in forces.windows(2) {
        let [(from, before), (to, after)] = [two[0], two[1]];
        let next = v + 0.5 * (before + after) * (to - from) / mass;
        z += 0.5 * (v + next) * (to - from);
        (v, deepest) = (next, deepest.max(-z));
    }
    let touches = || forces.iter().filter(|row| row.1 > 0.0).map(|row| row.0);
    Impact {
        approach: deepest / APPROACH,
        force: parts * forces.iter().map(|row| row.1).fold(0.0, f64::max) / FORCE,
        time: (touches().next_back().unwrap() - touches().next().unwrap()) / TIME,
        restitution: v / SPEED,
    }
}

const KINEMATIC: &str = "*CONTACT PAIR\nPOLE, PLANE\n";

/// Hertz's half space is good to 2 %: meshes go to an approach and a time that are 1.3 % and 1.6 % less, and a force that is 1.9 %
/// more. What a mesh adds falls with the square of its size h: of the force 1.2 %, 0.2 % with 3, 6 elements along the contact
/// radius a, against 12 of them. Of the energy at most 1 % stays as vibration.
fn judge(elements: usize, impact: &Impact) {
    let bound = 0.02 + 0.15 / (elements * elements) as f64;
    let Impact { approach, force, time, restitution } = *impact;
    assert!([approach, force, time].iter().all(|x| (x - 1.0).abs() < bound), "{elements}: {impact:?}");
    assert!(restitution > 0.99f64.sqrt() && restitution < 1.0 + 1e-3, "{elements}: {impact:?}");
}

#[test]
fn b05_ball_of_rings() {
    for elements in [3, 6] {
        judge(elements, &hit("ball_of_rings", &ring(elements), KINEMATIC, (1.0, 1)));
    }
}

/// By springs that give way by a hundredth of the usual.
#[test]
fn b05_ball_by_penalty() {
    let contact = "*CONTACT PAIR, MECHANICAL CONSTRAINT=PENALTY, CPSET=STIFF\nPOLE, PLANE\n\
                   *CONTACT CONTROLS, CPSET=STIFF, SCALE PENALTY=100.\n";
    judge(3, &hit("ball_by_penalty", &ring(3), contact, (1.0, 1)));
}

#[test]
#[ignore = "two minutes, in release"]
fn b05_ball() {
    for elements in [3, 6] {
        judge(elements, &hit("ball", &quarter(elements), KINEMATIC, (4.0, 2)));
    }
}
