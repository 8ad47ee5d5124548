//! Sums over the nodes of a contact surface: what a pressure known at nodes amounts to.

use crate::norm::{NodalPressure, corners, nodal_pressure};
use fe_mesh::quadrature::Rule;
use fe_mesh::{CellKind, Face, Mesh, shape};
use nalgebra::Vector3;
use std::collections::BTreeMap;
use std::f64::consts::TAU;

/// How distances and areas of a contact are counted.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Contact {
    /// About the axis z in space.
    Round,
    /// About the line x = 0, per thickness in a plane mesh.
    Line,
    /// About the axis y of an axisymmetric mesh, the full circumference.
    Turned,
}

/// What the pressure printed at a node means.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Pressure {
    /// The pressure of surface to surface: hat functions lie between the nodes.
    Field,
    /// The pressure of node to surface: the force on the node over the area ∫ φ dA of its hat function.
    Mean,
}

/// A node of the surface.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Node {
    /// Point of the mesh.
    pub point: usize,
    /// Distance from the middle of the contact [L].
    pub distance: f64,
    /// ∫ φ dA [L²], φ the node's hat function.
    pub area: f64,
    /// ∫ φ r² dA [L⁴], r the distance.
    pub moment: f64,
}

/// What a pressure amounts to, and how far it is from one that is known.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sums {
    /// ∫ p dA [F].
    pub force: f64,
    /// ∫ p r² dA [F·L²].
    pub moment: f64,
    /// The difference in L2 over the known pressure in L2, both summed over the nodes with their areas [-].
    pub error: f64,
}

/// The corner nodes of a surface.
pub fn nodes(mesh: &Mesh, surface: &[Face], contact: Contact) -> Vec<Node> {
    let mut found = BTreeMap::<usize, Node>::new();
    for &face in surface {
        let (kind, points) = mesh.face(face);
        let places_of_points: Vec<[f64; 3]> = points.iter().map(|&n| mesh.points[n as usize]).collect();
        for (hats, r, area) in places(kind, &places_of_points, contact) {
            for (&point, hat) in points.iter().zip(&hats) {
                let node = found.entry(point as usize).or_default();
                node.area += hat * area;
                node.moment += hat * area * r * r;
            }
        }
    }
    let whole = |(point, node): (usize, Node)| Node { point, distance: distance(mesh.points[point], contact), ..node };
    found.into_iter().map(whole).collect()
}

fn distance([x, y, _]: [f64; 3], contact: Contact) -> f64 {
    if contact == Contact::Round { x.hypot(y) } else { x.abs() }
}

/// At each place of a rule that integrates φ r² exactly on flat facets: hat functions of the corners, distance, share
/// of the area.
fn places(kind: CellKind, points: &[[f64; 3]], contact: Contact) -> Vec<(Vec<f64>, f64, f64)> {
    let corners = corners(kind);
    let place = |(xi, weight): ([f64; 3], f64)| {
        let (mut hats, mut shapes) = (vec![0.0; corners.nodes()], vec![0.0; points.len()]);
        let mut slopes = vec![[0.0; 3]; points.len()];
        shape::values(corners, &xi, &mut hats);
        shape::values(kind, &xi, &mut shapes);
        shape::gradients(kind, &xi, &mut slopes);
        let along = |axis: usize| -> Vector3<f64> {
            points.iter().zip(&slopes).map(|(x, slope)| Vector3::from(*x) * slope[axis]).sum()
        };
        let at: Vector3<f64> = points.iter().zip(&shapes).map(|(x, shape)| Vector3::from(*x) * *shape).sum();
        let r = distance(at.into(), contact);
        let area = if kind.dimension() == 1 { along(0).norm() } else { along(0).cross(&along(1)).norm() };
        (hats, r, weight * area * if contact == Contact::Turned { TAU * r } else { 1.0 })
    };
    Rule::of(kind, 4).points.into_iter().map(place).collect()
}

/// Force, second moment and error of the pressures `[points]` of the mesh against `exact`, a function of the distance.
///
/// The moment of a field is ∑ p_i ∫ φ_i r² dA. Means stand for their field by weights 2 A_i r_i² − ∫ φ_i r² dA, which
/// take the spread of the hat functions off again: exact to the fourth order in the size of the facets.
pub fn sums(nodes: &[Node], pressures: &[f64], meaning: Pressure, exact: impl Fn(f64) -> f64) -> Sums {
    let sum =
        |term: &dyn Fn(&Node, f64) -> f64| nodes.iter().map(|node| term(node, pressures[node.point])).sum::<f64>();
    let weight = |node: &Node| match meaning {
        Pressure::Field => node.moment,
        Pressure::Mean => 2.0 * node.area * node.distance.powi(2) - node.moment,
    };
    let each =
        |node: &Node| NodalPressure { found: pressures[node.point], exact: exact(node.distance), area: node.area };
    Sums {
        force: sum(&|node, p| node.area * p),
        moment: sum(&|node, p| p * weight(node)),
        error: nodal_pressure(nodes.iter().map(each)),
    }
}

/// Largest pressure of a contact whose p² falls with r² along a straight line, as Hertz's does: the line that fits best
/// as far as `within` [L], each node with its area for weight.
pub fn peak(nodes: &[Node], pressures: &[f64], within: f64) -> f64 {
    let inner = || nodes.iter().filter(|node| node.distance <= within);
    let sum = |term: &dyn Fn(f64, f64) -> f64| -> f64 {
        inner().map(|node| node.area * term(node.distance.powi(2), pressures[node.point].powi(2))).sum()
    };
    let area = sum(&|_, _| 1.0);
    let (mean_x, mean_y) = (sum(&|x, _| x) / area, sum(&|_, y| y) / area);
    let slope = sum(&|x, y| (x - mean_x) * (y - mean_y)) / sum(&|x, _| (x - mean_x).powi(2));
    (mean_y - slope * mean_x).max(0.0).sqrt()
}

#[cfg(test)]
mod tests {
    use super::*;
    use fe_mesh::generate::Block;

    /// Areas add up to the side's, moments to that of r² over it, whatever the facets: ∫ x² + y² over [0,2]×[0,1] is
    /// 10/3, ∫ x² over [0,2] 8/3, 2π ∫ r³ over [0,2] 8π. Rounding only.
    #[test]
    fn areas_and_moments() {
        let solids = [Block::hex8([3, 2, 1]), Block::tet4([3, 2, 1]), Block::tet10([3, 2, 1])];
        let solids =
            solids.map(|block| (block.size([2.0, 1.0, 1.0]).mesh(), "ZMIN", Contact::Round, [2.0, 10.0 / 3.0]));
        let plane = || Block::quad4([3, 2]).size([2.0, 1.0, 0.0]).mesh();
        let turned = [2.0 * TAU, 4.0 * TAU];
        let planes = [(plane(), "YMIN", Contact::Line, [2.0, 8.0 / 3.0]), (plane(), "YMIN", Contact::Turned, turned)];
        for (mesh, side, contact, [area, moment]) in solids.into_iter().chain(planes) {
            let nodes = nodes(&mesh, &mesh.surfaces[side], contact);
            let total = |part: &dyn Fn(&Node) -> f64| nodes.iter().map(part).sum::<f64>();
            assert!((total(&|node| node.area) / area - 1.0).abs() < 1e-13, "{contact:?}");
            assert!((total(&|node| node.moment) / moment - 1.0).abs() < 1e-13, "{contact:?}");
        }
    }

    /// The means of p = 1 − x² over hat functions of even facets, which the edges |x| = 1 do not cut: force and second
    /// moment are 4/3 and 4/15, in the moment but for the fourth order, so that it falls by 16 when facets are halved
    /// (the next order is the sixth: within a part of h² = 1/16 of that).
    #[test]
    fn moments_of_means_are_of_fourth_order() {
        let found = [16, 32].map(|n: usize| {
            let mesh = Block::quad4([n, 1]).size([4.0, 1.0, 0.0]).origin([-2.0, 0.0, 0.0]).mesh();
            let nodes = nodes(&mesh, &mesh.surfaces["YMIN"], Contact::Line);
            let mut pressures = vec![0.0; mesh.points.len()];
            for &face in &mesh.surfaces["YMIN"] {
                let (kind, points) = mesh.face(face);
                let corners = [0, 1].map(|i| mesh.points[points[i] as usize]);
                for (hats, r, area) in places(kind, &corners, Contact::Line) {
                    let load = area * (1.0 - r * r).max(0.0);
                    points.iter().zip(hats).for_each(|(&point, hat)| pressures[point as usize] += hat * load);
                }
            }
            nodes.iter().for_each(|node| pressures[node.point] /= node.area);
            sums(&nodes, &pressures, Pressure::Mean, |x| (1.0 - x * x).max(0.0))
        });
        assert!(found.iter().all(|sums| (sums.force - 4.0 / 3.0).abs() < 1e-14));
        let [coarse, fine] = found.map(|sums| (sums.moment - 4.0 / 15.0).abs());
        assert!(fine < 1e-3 && (coarse / fine - 16.0).abs() < 1.0, "{coarse} {fine}");
    }

    /// Of Hertz's pressure itself the fit finds the peak exactly.
    #[test]
    fn the_peak_of_hertz() {
        let mesh = Block::quad4([20, 1]).size([2.0, 1.0, 0.0]).mesh();
        let nodes = nodes(&mesh, &mesh.surfaces["YMIN"], Contact::Turned);
        let pressures: Vec<f64> = mesh.points.iter().map(|p| 3.0 * (1.0 - p[0] * p[0]).max(0.0).sqrt()).collect();
        assert!((peak(&nodes, &pressures, 0.5) / 3.0 - 1.0).abs() < 1e-14);
    }
}
