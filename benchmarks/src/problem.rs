//! What a problem is: a scene at any refinement, and the errors of what was computed of it.

use crate::cards::{self, Digits, Order};
use fe_core::element::ElementType;
use fe_core::material::{Elastic, Material};
use fe_core::{Section, Structure};
use fe_io::results::read::{Table, tables};
use fe_mesh::{CellBlock, Mesh, gmsh};
use std::io;
use std::path::{Path, PathBuf};

/// A problem with a known answer.
pub trait Problem: Sync {
    /// Its name on the command line.
    fn name(&self) -> &'static str;
    /// What it is, and where its answer comes from: a line.
    fn about(&self) -> &'static str;
    /// The errors that are measured, relative ones, in the order of [`Problem::errors`].
    fn norms(&self) -> &'static [Norm];
    /// Its curves: element and enforcement, with their refinements.
    fn curves(&self) -> Vec<Curve>;
    /// Curves and refinements that are run beside CalculiX on the same deck.
    fn compared(&self) -> Vec<(Curve, usize)> {
        Vec::new()
    }
    /// The scene of a curve at a refinement.
    fn scene(&self, curve: &Curve, n: usize) -> Scene;
    /// The errors of the answer to a scene, one for each norm.
    fn errors(&self, scene: &Scene, answer: &Answer) -> Result<Vec<f64>, String>;
}

/// An error that is measured.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Norm {
    /// Name in tables and plots.
    pub name: &'static str,
    /// The error of the model itself, below which no mesh leads; 0 where the answer is exact.
    pub floor: f64,
}

/// One curve of a plot: what stays the same while the mesh is refined.
#[derive(Clone, Debug, PartialEq)]
pub struct Curve {
    /// Element type.
    pub element: ElementType,
    /// Enforcement of contact, or another choice of the deck; empty where there is none.
    pub variant: &'static str,
    /// Refinements, coarse to fine.
    pub sizes: Vec<usize>,
}

impl Curve {
    /// Element and enforcement, as tables and plots name the curve.
    pub fn name(&self) -> String {
        [self.element.name(), self.variant].join(" ").trim().to_string()
    }
}

/// A mesh and the deck on it.
pub struct Scene {
    /// Name of deck and mesh, without ending.
    pub name: String,
    /// The mesh.
    pub mesh: Mesh,
    /// Element types of the element sets.
    pub elements: Vec<(&'static str, ElementType)>,
    /// The deck without heading and mesh.
    pub cards: String,
    /// Free unknowns.
    pub unknowns: usize,
}

/// How a scene hands its mesh over.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum MeshFile {
    /// A gmsh file.
    Gmsh,
    /// Keyword cards, which other programs read too.
    Cards,
}

impl Scene {
    /// Writes deck and mesh into `folder`; the path of the deck.
    pub fn write(&self, folder: &Path, as_file: MeshFile) -> io::Result<PathBuf> {
        std::fs::create_dir_all(folder)?;
        let name = &self.name;
        let mut deck = format!("*HEADING\n{name}\n");
        match as_file {
            MeshFile::Gmsh => {
                std::fs::write(folder.join(format!("{name}.msh")), gmsh::write(&self.mesh, gmsh::Encoding::Binary))?;
                deck += &format!("*MESH, INPUT={name}.msh\n");
                self.elements.iter().for_each(|(set, element)| deck += &format!("{set}, {}\n", element.name()));
            }
            MeshFile::Cards => {
                std::fs::write(
                    folder.join(format!("{name}_mesh.inp")),
                    cards::mesh(&self.mesh, &self.elements, Order::AsMade, Digits::Thirteen),
                )?;
                deck += &format!("*INCLUDE, INPUT={name}_mesh.inp\n");
            }
        }
        deck += &self.cards;
        let path = folder.join(format!("{name}.inp"));
        std::fs::write(&path, deck)?;
        Ok(path)
    }

    /// Mesh and sections as the program builds them, of one material and thickness 1: what errors are integrated over.
    pub fn structure(&self, elastic: Elastic) -> Structure {
        let section = |&(set, element): &(&str, ElementType)| {
            let cells = self.mesh.cell_sets[set].clone();
            Section { element, cells, material: 0, thickness: 1.0, hourglass: None }
        };
        let of_kind = |block: &CellBlock| self.elements.iter().map(|(_, e)| *e).find(|e| e.kind() == block.kind);
        Structure {
            mesh: self.mesh.clone(),
            elements: self.mesh.blocks.iter().filter_map(of_kind).collect(),
            materials: vec![Material::elastic("M", elastic)],
            sections: self.elements.iter().map(section).collect(),
            ..Structure::default()
        }
    }
}

/// What a program printed of a scene.
pub struct Answer {
    tables: Vec<Table>,
}

impl Answer {
    /// Reads a `.dat` file.
    pub fn read(path: &Path) -> Result<Self, String> {
        let text = std::fs::read_to_string(path).map_err(|error| format!("{}: {error}", path.display()))?;
        Ok(Answer { tables: tables(&text).map_err(|error| format!("{}, {error}", path.display()))? })
    }

    /// The last table whose title begins so, of this set where one is named.
    fn last(&self, title: &str, set: &str) -> Result<&Table, String> {
        let fits = |table: &&Table| table.title.starts_with(title) && (set.is_empty() || table.set == set);
        self.tables.iter().rfind(fits).ok_or_else(|| format!("no table `{title}` was printed for `{set}`"))
    }

    /// Displacements [L] by point of the mesh, from the table of a set of all its nodes.
    pub fn displacements(&self, mesh: &Mesh, set: &str) -> Result<Vec<[f64; 3]>, String> {
        let mut u = vec![[f64::NAN; 3]; mesh.points.len()];
        self.nodal(mesh, self.last("displacements", set)?, |point, values| u[point] = values)?;
        match u.iter().position(|u| u[0].is_nan()) {
            None => Ok(u),
            Some(point) => Err(format!("no displacement of node {} was printed", mesh.point_labels[point])),
        }
    }

    /// Displacements [L] of the nodes of a set, with their points.
    pub fn displacements_of(&self, mesh: &Mesh, set: &str) -> Result<Vec<(usize, [f64; 3])>, String> {
        let mut u = Vec::new();
        self.nodal(mesh, self.last("displacements", set)?, |point, values| u.push((point, values)))?;
        Ok(u)
    }

    /// Contact pressure [F/L²] by point of the mesh, 0 where a point is not in contact.
    pub fn pressures(&self, mesh: &Mesh) -> Result<Vec<f64>, String> {
        let mut pressure = vec![0.0; mesh.points.len()];
        self.nodal(mesh, self.last("contact stress", "")?, |point, values| pressure[point] = values[0])?;
        Ok(pressure)
    }

    /// Sum of the reactions of a set [F].
    pub fn total_force(&self, set: &str) -> Result<[f64; 3], String> {
        let table = self.last("total force", set)?;
        let values = table.rows.first().map(|row| &row.values[..]);
        values.and_then(|v| v.try_into().ok()).ok_or_else(|| format!("`{}` holds no force", table.title))
    }

    /// Gives each row of a table by nodes to `take`, with its point in the mesh. Labels count as the points do.
    fn nodal(&self, mesh: &Mesh, table: &Table, mut take: impl FnMut(usize, [f64; 3])) -> Result<(), String> {
        for row in &table.rows {
            let point = row.labels.first().and_then(|label| mesh.point_labels.binary_search(label).ok());
            match (point, <[f64; 3]>::try_from(&row.values[..])) {
                (Some(point), Ok(values)) => take(point, values),
                _ => return Err(format!("`{}` has a row that is none of a node: {row:?}", table.title)),
            }
        }
        Ok(())
    }
}
