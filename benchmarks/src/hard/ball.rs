//! The ball: the lower half of a ball of radius 10 (E = 210000, ν = 0.3) of about 2,000 bricks, its equator held as one
//! and pushed onto a rigid flat by 0.3. No symmetry is used, so that it can be turned.

use super::deck::{self, Order};
use fe_core::element::ElementType;
use fe_mesh::generate::Block;
use fe_mesh::{CellBlock, CellId, CellKind, Face, Mesh};
use std::collections::BTreeMap;
use std::f64::consts::FRAC_PI_4;
use std::fmt::Write;

/// Radius [L].
pub const RADIUS: f64 = 10.0;
/// Young's modulus [F/L²].
pub const YOUNG: f64 = 210e3;
/// How far the equator is pushed [L].
pub const PUSH: f64 = 0.3;
/// Elements across.
const ACROSS: usize = 10;
/// Elements between the inner cube and the surface.
const LAYERS: usize = 5;
/// Half the edge of the inner cube, of the radius [-].
const INNER: f64 = 0.4;

type Point = [f64; 3];

/// Parameters in −1…1 crowd around 0: the elements are smallest at the pole.
fn graded(a: f64) -> f64 {
    a.signum() * a.abs().powf(1.5)
}

/// From a face of the inner cube, given by a point p with one coordinate ±1, to the sphere, t = 0…1.
fn shell(p: Point, t: f64) -> Point {
    let angles = p.map(|a| if a.abs() == 1.0 { a } else { (a * FRAC_PI_4).tan() });
    let length = angles.iter().map(|a| a * a).sum::<f64>().sqrt();
    std::array::from_fn(|c| RADIUS * ((1.0 - t) * INNER * p[c] + t * angles[c] / length))
}

/// The half ball below z = 0, with the pole at z = −10; cell set `BALL`, node set `EQUATOR`, surface `SKIN`.
pub fn mesh() -> Mesh {
    let half = ACROSS / 2;
    let square = |p: Point| [graded(p[0]), graded(p[1]), p[2]];
    let inner = Block::hex8([ACROSS, ACROSS, half]).size([2.0, 2.0, 1.0]).origin([-1.0, -1.0, -1.0]);
    let mut parts = vec![(inner.mapped(|p| square(p).map(|a| RADIUS * INNER * a)), None)];
    // The pole's part: parameters (a, b, t) from the surface inward keep the bricks right way round.
    let pole = Block::hex8([ACROSS, ACROSS, LAYERS]).size([2.0, 2.0, 1.0]).origin([-1.0, -1.0, 0.0]);
    parts.push((pole.mapped(|[a, b, s]| shell([graded(a), graded(b), -1.0], 1.0 - s)), Some("ZMIN")));
    // A side turned about z, four times.
    for turn in 0..4 {
        let side = Block::hex8([LAYERS, ACROSS, half]).size([1.0, 2.0, 1.0]).origin([0.0, -1.0, -1.0]);
        let turned = |[x, y, z]: Point| match turn {
            0 => [x, y, z],
            1 => [-y, x, z],
            2 => [-x, -y, z],
            _ => [y, -x, z],
        };
        parts.push((side.mapped(|[t, b, z]| turned(shell([1.0, graded(b), z], t))), Some("XMAX")));
    }
    joined(&parts)
}

/// One mesh of parts that touch: points at the same place are one.
fn joined(parts: &[(Mesh, Option<&str>)]) -> Mesh {
    let mut mesh = Mesh { blocks: vec![CellBlock::new(CellKind::Hex8)], ..Mesh::default() };
    let mut places: BTreeMap<[i64; 3], u32> = BTreeMap::new();
    let mut skin = Vec::new();
    for (part, side) in parts {
        let mut new = Vec::with_capacity(part.points.len());
        for point in &part.points {
            // Parts differ by round-off, 1e-14, points by more than 0.1.
            let place = point.map(|x| (x * 1e6).round() as i64);
            new.push(*places.entry(place).or_insert_with(|| {
                mesh.points.push(point.map(|x| if x.abs() < 1e-12 { 0.0 } else { x }));
                mesh.points.len() as u32 - 1
            }));
        }
        let first = mesh.blocks[0].labels.len() as u32;
        let block = &part.blocks[0];
        mesh.blocks[0].nodes.extend(block.nodes.iter().map(|&n| new[n as usize]));
        mesh.blocks[0].labels.extend((1..=block.len() as u64).map(|label| u64::from(first) + label));
        let faces = side.map_or(&[][..], |side| &part.surfaces[side]);
        let moved = |cell: CellId| CellId { block: 0, cell: cell.cell + first };
        skin.extend(faces.iter().map(|face| Face { cell: moved(face.cell), face: face.face }));
    }
    mesh.point_labels = (1..=mesh.points.len() as u64).collect();
    mesh.cell_sets.insert("BALL".into(), mesh.cells().collect());
    let equator = (0..mesh.points.len() as u32).filter(|&n| mesh.points[n as usize][2] == 0.0).collect();
    mesh.node_sets.insert("EQUATOR".into(), equator);
    mesh.surfaces.insert("SKIN".into(), skin);
    mesh
}

/// The part of the skin that can meet the flat: faces whose corners all lie below this height [L].
pub fn lower_skin(mesh: &mut Mesh, height: f64) {
    let skin = mesh.surfaces["SKIN"].clone();
    let low = |face: &Face| mesh.face(*face).1.iter().all(|&n| mesh.points[n as usize][2] < height);
    let low: Vec<_> = skin.into_iter().filter(low).collect();
    mesh.surfaces.insert("SKIN".into(), low);
}

/// How a ball's deck is made from its mesh.
pub struct Ball {
    /// Takes points to where they are; linear, so that directions go alike.
    pub turn: fn(Point) -> Point,
    /// Factor on lengths.
    pub length: f64,
    /// Factor on forces.
    pub force: f64,
    /// Factor on times.
    pub time: f64,
    /// Order of nodes, elements and faces.
    pub order: Order,
    /// The pairs: secondary surfaces, each against the flat.
    pub pairs: Vec<&'static str>,
}

impl Default for Ball {
    fn default() -> Self {
        Ball { turn: |p| p, length: 1.0, force: 1.0, time: 1.0, order: Order::AsMade, pairs: vec!["SKIN"] }
    }
}

impl Ball {
    /// The deck of a half ball's mesh.
    pub fn deck(&self, mesh: &Mesh) -> String {
        let scaled = |p: Point| (self.turn)(p).map(|x| x * self.length);
        let mut moved = mesh.clone();
        moved.points.iter_mut().for_each(|p| *p = scaled(*p));
        // The flat's profile is a line in a local plane; its reference node stands on it.
        let [a, b, c] = [[0.0, 0.0, -RADIUS], [1.0, 0.0, -RADIUS], [0.0, 1.0, -RADIUS]].map(scaled);
        let reference = mesh.points.len() as u64 + 1;
        let (l, f, t) = (self.length, self.force, self.time);
        let [ux, uy, uz] = scaled([0.0, 0.0, -PUSH]);
        let at = |p: Point| format!("{:e}, {:e}, {:e}", p[0], p[1], p[2]);
        let mut text = deck::cards(&moved, &[("BALL", ElementType::C3D8)], self.order);
        text += &deck::elastic(&["BALL"], YOUNG * f / (l * l), 0.3);
        // Writing to a string does not fail.
        let _ = write!(
            text,
            "*NODE\n{reference}, {}\n*SURFACE, NAME=FLAT, TYPE=CYLINDER\n{}, {}\n{}\nSTART, {:e}, 0.\nLINE, {:e}, 0.\n\
             *RIGID BODY, ANALYTICAL SURFACE=FLAT, REF NODE={reference}\n*SURFACE INTERACTION, NAME=I\n\
             *SURFACE BEHAVIOR, PENALTY\n*CONTACT PAIR, INTERACTION=I, TYPE=SURFACE TO SURFACE\n",
            at(a),
            at(a),
            at(b),
            at(c),
            -20.0 * l,
            20.0 * l,
        );
        self.pairs.iter().for_each(|secondary| text += &format!("{secondary}, FLAT\n"));
        let _ = write!(
            text,
            "*BOUNDARY\n{reference}, 1, 6\n*STEP\n*STATIC\n{t:e}, {t:e}\n*CONTROLS, PARAMETERS=FIELD\n1e-12\n\
             *BOUNDARY\nEQUATOR, 1, 1, {ux:e}\nEQUATOR, 2, 2, {uy:e}\nEQUATOR, 3, 3, {uz:e}\n*END STEP\n"
        );
        text
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The parts fit: inner faces are shared by two bricks, outer ones lie on the sphere (those of the skin) or in the
    /// plane of the equator, 10 × 10 and 4 × 5 × 10 of them.
    #[test]
    fn the_parts_of_the_ball_are_joined() {
        let mesh = mesh();
        assert_eq!(mesh.cell_count(), 500 + 500 + 4 * 250);
        let mut faces: BTreeMap<Vec<u32>, (usize, bool)> = BTreeMap::new();
        for cell in mesh.cells() {
            for face in 0..6 {
                let mut nodes = mesh.face(Face { cell, face }).1;
                let equator = nodes.iter().all(|&n| mesh.points[n as usize][2] == 0.0);
                nodes.sort_unstable();
                faces.entry(nodes).or_insert((0, equator)).0 += 1;
            }
        }
        let outer: Vec<bool> = faces.values().filter(|(count, _)| *count == 1).map(|(_, equator)| *equator).collect();
        assert!(faces.values().all(|(count, _)| *count <= 2));
        assert_eq!(outer.iter().filter(|equator| **equator).count(), 300);
        assert_eq!(outer.iter().filter(|equator| !**equator).count(), mesh.surfaces["SKIN"].len());
        let radius = |n: u32| mesh.points[n as usize].iter().map(|x| x * x).sum::<f64>().sqrt();
        let skin = mesh.surfaces["SKIN"].iter().flat_map(|&face| mesh.face(face).1);
        // Rounding of coordinates of 10.
        assert!(skin.into_iter().all(|n| (radius(n) - RADIUS).abs() < 1e-13));
    }
}
