//! Every element has a volume and is turned the right way, or is named.

use super::tables;
use crate::element::{ElementType, Space};
use crate::structure::Section;
use fe_mesh::{CellId, Mesh, shape};
use rayon::prelude::*;
use std::fmt;

/// An element that cannot be integrated.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[error("element {label} ({}) {defect}", .element.name())]
pub struct BadElement {
    /// The cell.
    pub cell: CellId,
    /// Its label.
    pub label: String,
    /// Its element type.
    pub element: ElementType,
    /// What is wrong.
    pub defect: Defect,
}

/// A brick that is folded at a corner, j < 0 there, and sound at all its integration points: it is computed as it is.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[error(
    "element {label} ({}) is folded at corner {} (node {node}): j = {jacobian:.3e} there", .element.name(), .corner + 1
)]
pub struct FoldedCorner {
    /// The cell.
    pub cell: CellId,
    /// Its label.
    pub label: String,
    /// Its element type.
    pub element: ElementType,
    /// The corner where j is least, from 0.
    pub corner: usize,
    /// Label of its node.
    pub node: String,
    /// j there [L³].
    pub jacobian: f64,
}

/// What is wrong with an element. Jacobians j are determinants of ∂x/∂ξ [L² or L³].
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum Defect {
    /// j < 0 at every corner.
    #[error("is inside out: j = {jacobian:.3e} at {place}; its nodes are numbered the wrong way round")]
    Inverted {
        /// First corner.
        place: Place,
        /// j there.
        jacobian: f64,
    },
    /// j < 0 somewhere: concave, twisted, or mid nodes too far out.
    #[error("is concave or folded: j = {jacobian:.3e} at {place}")]
    Folded {
        /// Where j is least.
        place: Place,
        /// j there.
        jacobian: f64,
    },
    /// j vanishes at an integration point.
    #[error("has no volume: j = {jacobian:.3e} at {place}")]
    NoVolume {
        /// Where j is least.
        place: Place,
        /// j there.
        jacobian: f64,
    },
    /// An axisymmetric element reaches beyond the axis.
    #[error("lies beyond the axis: radius {radius} at {place}")]
    BeyondAxis {
        /// The corner.
        place: Place,
        /// Its radius [L].
        radius: f64,
    },
}

/// A place in an element.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Place {
    /// Corner node, from 0.
    Corner(usize),
    /// Integration point, from 0.
    Point(usize),
    /// The centroid.
    Centroid,
}

impl fmt::Display for Place {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        match self {
            Place::Corner(i) => write!(f, "corner {}", i + 1),
            Place::Point(i) => write!(f, "integration point {}", i + 1),
            Place::Centroid => write!(f, "the centroid"),
        }
    }
}

/// Part of an element's largest Jacobian, or of the cube of its size, that is round-off.
const ROUND_OFF: f64 = 1e-12;

/// Volumes of the cells of a section [L³], or the first bad one.
pub(super) fn volumes(mesh: &Mesh, section: &Section) -> Result<Vec<f64>, BadElement> {
    Ok(examine(mesh, section)?.into_iter().map(|(volume, _)| volume).collect())
}

/// The first cell of a section that cannot be integrated, or the bricks that are folded at a corner.
pub fn check(mesh: &Mesh, section: &Section) -> Result<Vec<FoldedCorner>, BadElement> {
    Ok(examine(mesh, section)?.into_iter().filter_map(|(_, folded)| folded).collect())
}

/// Volume [L³] and folded corner of each cell, or the first bad cell.
fn examine(mesh: &Mesh, section: &Section) -> Result<Vec<(f64, Option<FoldedCorner>)>, BadElement> {
    let checker = Checker::new(section);
    let results: Vec<_> = section.cells.par_iter().map(|&cell| checker.examine(mesh, cell)).collect();
    results.into_iter().collect()
}

/// Shape functions at the places looked at: corners, integration points, centroid.
struct Checker {
    element: ElementType,
    factor: f64,
    places: Vec<(Place, Vec<[f64; 3]>)>,
    points: Vec<(f64, Vec<f64>)>,
    corners: usize,
}

impl Checker {
    fn new(section: &Section) -> Self {
        let (element, kind) = (section.element, section.element.kind());
        let corners = match element {
            ElementType::C3D10 => 4,
            _ => kind.nodes(),
        };
        let rule = tables::rule(element);
        let gradients = |xi: &[f64; 3]| {
            let mut out = vec![[0.0; 3]; kind.nodes()];
            shape::gradients(kind, xi, &mut out);
            out
        };
        let values = |xi: &[f64; 3]| {
            let mut out = vec![0.0; kind.nodes()];
            shape::values(kind, xi, &mut out);
            out
        };
        let mut places = Vec::new();
        places.extend((0..corners).map(|c| (Place::Corner(c), gradients(&shape::nodes(kind)[c]))));
        places.extend(rule.points.iter().enumerate().map(|(p, (xi, _))| (Place::Point(p), gradients(xi))));
        places.push((Place::Centroid, gradients(&shape::centroid(kind))));
        let points = rule.points.iter().map(|(xi, weight)| (*weight, values(xi))).collect();
        let factor = match element.space() {
            Space::Solid | Space::Plane | Space::Any => 1.0,
            Space::PlaneStrain | Space::PlaneStress => section.thickness,
            Space::Axisymmetric => std::f64::consts::TAU,
        };
        Checker { element, factor, places, points, corners }
    }

    fn examine(&self, mesh: &Mesh, cell: CellId) -> Result<(f64, Option<FoldedCorner>), BadElement> {
        let x: Vec<[f64; 3]> = mesh.cell(cell).iter().map(|&n| mesh.points[n as usize]).collect();
        let jacobians: Vec<f64> = self.places.iter().map(|(_, g)| self.jacobian(&x, g)).collect();
        if let Some(defect) = self.defect(&x, &jacobians) {
            return Err(BadElement { cell, label: mesh.cell_name(cell), element: self.element, defect });
        }
        let axisymmetric = self.element.space() == Space::Axisymmetric;
        let share = |((weight, values), j): (&(f64, Vec<f64>), &f64)| {
            let radius = if axisymmetric { values.iter().zip(&x).map(|(n, x)| n * x[0]).sum() } else { 1.0 };
            weight * j * radius * self.factor
        };
        let volume = self.points.iter().zip(&jacobians[self.corners..]).map(share).sum();
        let folded = self.folded_corner(&jacobians).map(|corner| FoldedCorner {
            cell,
            label: mesh.cell_name(cell),
            element: self.element,
            corner,
            node: mesh.point_name(mesh.cell(cell)[corner]),
            jacobian: jacobians[corner],
        });
        Ok((volume, folded))
    }

    /// The corner with the least j, where that is negative beyond round-off.
    fn folded_corner(&self, jacobians: &[f64]) -> Option<usize> {
        let largest = jacobians.iter().fold(0.0f64, |m, j| m.max(j.abs()));
        let least = (0..self.corners).min_by(|&a, &b| jacobians[a].total_cmp(&jacobians[b]))?;
        (jacobians[least] < -ROUND_OFF * largest).then_some(least)
    }

    fn defect(&self, x: &[[f64; 3]], jacobians: &[f64]) -> Option<Defect> {
        let size = (0..3).map(|i| extent(x, i)).fold(0.0, f64::max);
        let largest = jacobians.iter().fold(0.0f64, |m, j| m.max(j.abs()));
        let least = |range: std::ops::Range<usize>| {
            range.min_by(|&a, &b| jacobians[a].total_cmp(&jacobians[b])).map(|i| (self.places[i].0, jacobians[i]))
        };
        let (place, jacobian) = least(self.corners..jacobians.len())?;
        let all_finite = jacobians.iter().all(|j| j.is_finite());
        if !all_finite || largest <= ROUND_OFF * size.powi(self.element.space().dimension() as i32) {
            let (place, jacobian) = least(0..jacobians.len())?;
            return Some(Defect::NoVolume { place, jacobian });
        }
        if jacobians[..self.corners].iter().all(|&j| j < 0.0) {
            return Some(Defect::Inverted { place: Place::Corner(0), jacobian: jacobians[0] });
        }
        // A brick may fold a little at a corner and still be sound at all its integration points: element 4 of the
        // solid patch of MacNeal and Harder (Finite Elem. Anal. Des. 1 (1985) 3) does.
        if let Some(corner) = self.folded_corner(jacobians).filter(|_| self.element != ElementType::C3D8) {
            return Some(Defect::Folded { place: Place::Corner(corner), jacobian: jacobians[corner] });
        }
        if jacobian < -ROUND_OFF * largest {
            return Some(Defect::Folded { place, jacobian });
        }
        if jacobian <= ROUND_OFF * largest {
            return Some(Defect::NoVolume { place, jacobian });
        }
        let beyond = |&c: &usize| x[c][0] < -ROUND_OFF * size;
        let first = (0..self.corners).filter(|_| self.element.space() == Space::Axisymmetric).find(beyond)?;
        Some(Defect::BeyondAxis { place: Place::Corner(first), radius: x[first][0] })
    }

    fn jacobian(&self, x: &[[f64; 3]], gradients: &[[f64; 3]]) -> f64 {
        // From the first node, so that differences keep their digits far from the origin.
        let (mut j, origin) = ([[0.0; 3]; 3], x[0]);
        for (x, g) in x.iter().zip(gradients) {
            for i in 0..3 {
                for d in 0..3 {
                    j[i][d] += (x[i] - origin[i]) * g[d];
                }
            }
        }
        if self.element.space().dimension() == 2 {
            return j[0][0] * j[1][1] - j[0][1] * j[1][0];
        }
        (0..3).map(|d| j[0][d] * (j[1][(d + 1) % 3] * j[2][(d + 2) % 3] - j[1][(d + 2) % 3] * j[2][(d + 1) % 3])).sum()
    }
}

fn extent(x: &[[f64; 3]], i: usize) -> f64 {
    let (least, most) = x.iter().fold((f64::MAX, f64::MIN), |(l, m), x| (l.min(x[i]), m.max(x[i])));
    most - least
}
