//! Reads a results file.

use hdf5_reader::Hdf5File;
use std::path::Path;

/// An open results file.
pub struct Results(Hdf5File);

impl Results {
    /// Opens it.
    pub fn open(path: &Path) -> Self {
        Results(Hdf5File::open(path).unwrap_or_else(|e| panic!("{}: {e}", path.display())))
    }

    /// Total times of the frames.
    pub fn times(&self) -> Vec<f64> {
        let frames = self.0.group("VTKHDF/Steps").unwrap().attribute("NSteps").unwrap().read_scalar::<i64>().unwrap();
        let mut times = self.real("VTKHDF/Steps/Values");
        times.truncate(frames as usize);
        times
    }

    /// A whole array.
    pub fn real(&self, name: &str) -> Vec<f64> {
        self.0.dataset(name).unwrap().read_array::<f64>().unwrap().into_iter().collect()
    }

    /// A whole array of integers.
    pub fn integer(&self, name: &str) -> Vec<i64> {
        self.0.dataset(name).unwrap().read_array::<i64>().unwrap().into_iter().collect()
    }

    /// Names of the arrays in a group.
    pub fn names(&self, group: &str) -> Vec<String> {
        self.0.group(group).unwrap().member_names().unwrap().1
    }

    /// A point field of a frame, `[points × width]`.
    pub fn point_field(&self, name: &str, width: usize, frame: usize) -> Vec<f64> {
        let offset = self.integer(&format!("VTKHDF/Steps/PointDataOffsets/{name}"))[frame] as usize;
        let points = self.integer("VTKHDF/NumberOfPoints")[0] as usize;
        self.real(&format!("VTKHDF/PointData/{name}"))[offset * width..(offset + points) * width].to_vec()
    }

    /// Index of the point at a place; fails where there is none within 1e-9.
    pub fn point_at(&self, place: [f64; 3]) -> usize {
        let points = self.real("VTKHDF/Points");
        let near = |p: &[f64]| (0..3).all(|i| (p[i] - place[i]).abs() < 1e-9);
        points.chunks_exact(3).position(near).unwrap_or_else(|| panic!("no point at {place:?}"))
    }
}
