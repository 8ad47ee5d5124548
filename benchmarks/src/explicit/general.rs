//! How general contact grows with its facets: a cloud of cubes that fly about and hit each other, twice as many from row to row.

use super::bodies::{hard, outer_faces, solids};
use crate::fit;
use crate::machine::Origin;
use fe_contact::explicit::{Acting, Between, GeneralContact, GeneralCount, GeneralDefinition, GeneralFace, Sides};
use fe_contact::viscous::ExplicitDamping;
use fe_core::Freedoms;
use fe_core::element::ElementType::C3D8R;
use fe_core::explicit::Halt;
use fe_core::explicit::central_difference::{CentralDifference, State};
use fe_core::material::{Elastic, Response};
use fe_core::structure::Structure;
use fe_mesh::Mesh;
use fe_mesh::generate::Block;
use std::error::Error;
use std::io::Write;
use std::time::Instant;

/// Elements along an edge of a cube: 150 facets, 125 elements.
const EDGE: usize = 5;
/// Cubes of a cluster, 2 along each edge, and of the first row.
const CLUSTER: usize = 8;
const FIRST: usize = CLUSTER;
/// How often the first row is doubled.
const DOUBLED: usize = 6;
/// Speed of the cubes over that of sound [-], in all directions.
const SPEED: f64 = 0.02;

const STEEL: Response = Response::Elastic(Elastic { young: 1.0, poisson: 0.3 });

/// What is measured.
#[derive(Clone, Copy, Debug)]
struct Row {
    facets: usize,
    elements: usize,
    /// Seconds an increment, of contact in it, and of searching in that.
    seconds: [f64; 3],
    count: GeneralCount,
}

/// Prints seconds and shares of all rows, and the exponents of growth.
pub fn study(threads: usize, out: &mut dyn Write) -> Result<(), Box<dyn Error>> {
    let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build()?;
    writeln!(out, "general contact: cubes of {EDGE} × {EDGE} × {EDGE} C3D8R that hit each other, 300 increments")?;
    writeln!(out, "{}; {threads} thread(s)\n", Origin::here())?;
    let titles = ["facets", "elements", "closed", "searches", "ms/inc", "contact", "search", "ns/facet"];
    titles.iter().try_for_each(|title| write!(out, "{title:>10}"))?;
    writeln!(out)?;
    let mut rows = Vec::new();
    for doubled in 0..=DOUBLED {
        let row = pool.install(|| measured(FIRST << doubled))?;
        let [all, contact, search] = row.seconds;
        writeln!(
            out,
            "{:>10}{:>10}{:>10}{:>10}{:>10.3}{:>8.1} %{:>8.1} %{:>10.1}",
            row.facets,
            row.elements,
            row.count.closed,
            row.count.searches,
            1e3 * all,
            100.0 * contact / all,
            100.0 * search / all,
            1e9 * contact / row.facets as f64
        )?;
        rows.push(row);
    }
    let exponent = |i: usize| fit::slope(&rows.iter().map(|r| (r.facets as f64, r.seconds[i])).collect::<Vec<_>>());
    writeln!(
        out,
        "\nexponents over facets: increment {:.2}, contact {:.2}, search {:.2}",
        exponent(0),
        exponent(1),
        exponent(2)
    )?;
    Ok(())
}

/// A fixed sequence of numbers in −1..1.
fn numbers() -> impl FnMut() -> f64 {
    let mut seed = 2024u64;
    move || {
        seed = seed.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
        (seed >> 11) as f64 / (1u64 << 52) as f64 - 1.0
    }
}

/// So many unit cubes: clusters of eight with gaps of a tenth, a little out of place, all clusters alike and 1.5 apart, so that
/// twice as many have twice as much to do.
fn cloud(count: usize) -> Structure {
    let side = (1..).find(|side: &usize| side.pow(3) * CLUSTER >= count).unwrap_or(1);
    let mut next = numbers();
    let mut mesh = Mesh::default();
    for body in 0..count {
        let (cluster, own) = (body / CLUSTER, body % CLUSTER);
        if own == 0 {
            next = numbers();
        }
        let around = [cluster % side, cluster / side % side, cluster / side / side];
        let origin: [f64; 3] =
            std::array::from_fn(|c| 3.6 * around[c] as f64 + 1.1 * (own >> c & 1) as f64 + 0.03 * next());
        mesh.append(&Block::hex8([EDGE; 3]).origin(origin).mesh());
    }
    Structure { mesh, elements: vec![C3D8R], ..Structure::default() }
}

fn contact(structure: &Structure, freedoms: &Freedoms) -> GeneralContact {
    let face = |nodes| GeneralFace { nodes, sides: Sides::Outer, class: 0 };
    let definition = GeneralDefinition {
        name: "general contact".into(),
        faces: outer_faces(structure).into_iter().map(face).collect(),
        table: vec![vec![Between::Acting(Acting { behaviour: 0, scale: 0 })]],
        behaviours: vec![hard(Some(ExplicitDamping::default()))],
        scales: vec![1.0],
    };
    GeneralContact::new(structure, freedoms, &definition, &[])
}

/// The mean of 300 increments after a hundred.
fn measured(bodies: usize) -> Result<Row, Halt> {
    let structure = cloud(bodies);
    let freedoms = structure.freedoms(&[]);
    let mut solids = solids(&structure, &freedoms, (&STEEL, 1.0), [0.06, 1.2]);
    let mut general = contact(&structure, &freedoms);
    let mut state = State::rest(&freedoms);
    let mut next = numbers();
    let each = structure.mesh.points.len() / bodies;
    for body in 0..bodies {
        if body % CLUSTER == 0 {
            next = numbers();
        }
        let velocity = [0; 3].map(|_| SPEED * next());
        for node in body * each..(body + 1) * each {
            freedoms.of_node(node).zip(velocity).for_each(|(freedom, v)| state.v[freedom] = v);
        }
    }
    let mut procedure =
        CentralDifference::new(&mut [&mut solids, &mut general], Vec::new(), (1e9, f64::INFINITY), &mut state)?;
    let (mut all, mut within, mut searching, mut other) = (0.0, 0.0, [0.0; 2], [0.0; 2]);
    for increment in 0..400 {
        let dt = 0.9 * procedure.stable().increment();
        let (before, searches) = (procedure.seconds()[1], general.searches());
        let start = Instant::now();
        procedure.advance(&mut [&mut solids, &mut general], &mut state, dt)?;
        if increment < 100 {
            continue;
        }
        all += start.elapsed().as_secs_f64();
        let seconds = procedure.seconds()[1] - before;
        within += seconds;
        let of = if general.searches() > searches { &mut searching } else { &mut other };
        *of = [of[0] + seconds, of[1] + 1.0];
    }
    // What increments with a search take longer than the others.
    let search = searching[0] - searching[1] * other[0] / other[1].max(1.0);
    let count = general.count();
    let seconds = [all, within, search].map(|sum| sum / 300.0);
    Ok(Row { facets: count.faces, elements: solids.count(), seconds, count })
}
