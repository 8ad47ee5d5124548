//! A grid of several kinds of cell, and fields whose every number tells where it belongs.
#![allow(dead_code, clippy::unwrap_used)]

pub mod python;
pub mod reading;

use fe_io::results::fields::FIELDS;
use fe_io::results::{
    FieldInfo, Frame, Grid, GridBlock, HistoryInfo, HistoryRow, JobInfo, Location, ResultsError, ResultsFile,
};
use fe_mesh::CellKind;
use std::path::{Path, PathBuf};

/// A grid with its own arrays.
pub struct Scene {
    pub points: Vec<[f64; 3]>,
    pub node_labels: Vec<u64>,
    pub blocks: Vec<(CellKind, Vec<u64>, Vec<u32>)>,
    pub body: Vec<u32>,
}

/// A row of unit cubes along x: the first `hexes` are hex8, then one cube of five tet4, then one quad4 on its end;
/// a block without a cell is among them.
pub fn scene(hexes: usize) -> Scene {
    let sections = hexes + 2;
    let corner = [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]];
    let points: Vec<[f64; 3]> = (0..sections).flat_map(|i| corner.map(|[y, z]| [i as f64, y, z])).collect();
    let cube = |i: usize| (0..8).map(move |k| (4 * i + k) as u32);
    let hex = (0..hexes).flat_map(cube).collect();
    let c: Vec<u32> = cube(hexes).collect();
    let tets: [[usize; 4]; 5] = [[0, 1, 3, 4], [1, 2, 3, 6], [1, 4, 5, 6], [3, 4, 6, 7], [1, 3, 4, 6]];
    let tet = tets.iter().flatten().map(|&k| c[k]).collect();
    let quad = c[4..8].to_vec();
    let labels = |from: usize, n: usize| (from..from + n).map(|l| l as u64).collect::<Vec<_>>();
    let blocks = vec![
        (CellKind::Hex8, labels(1, hexes), hex),
        (CellKind::Tet10, Vec::new(), Vec::new()),
        (CellKind::Tet4, labels(5000, 5), tet),
        (CellKind::Quad4, labels(9000, 1), quad),
    ];
    let cells = hexes + 6;
    let node_labels = (0..points.len()).map(|i| 10 + 3 * i as u64).collect();
    Scene { points, node_labels, blocks, body: (0..cells).map(|i| u32::from(i >= hexes)).collect() }
}

/// The number that belongs to a field in a frame; exact in double precision. `field`: index into `FIELDS`. Contact
/// fields are not defined in every third row.
pub fn value(frame: usize, field: usize, row: usize, component: usize) -> f64 {
    if FIELDS[field].name.starts_with('C') && row % 3 == 1 {
        return f64::NAN;
    }
    (frame * 1_000_000 + field * 10_000 + row) as f64 + component as f64 / 8.0
}

/// All values of a field in a frame.
pub fn values(frame: usize, field: usize, rows: usize) -> Vec<f64> {
    let width = FIELDS[field].width();
    (0..rows * width).map(|i| value(frame, field, i / width, i % width)).collect()
}

/// Total time of a frame.
pub fn time(frame: usize) -> f64 {
    frame as f64 / 16.0
}

/// Histories of every test file.
pub fn histories() -> Vec<HistoryInfo> {
    let words = |list: &[&str]| list.iter().map(|s| s.to_string()).collect::<Vec<_>>();
    vec![
        HistoryInfo {
            name: "CF UPPER-LOWER".into(),
            columns: words(&["CFN1", "CFN2", "CFN3"]),
            units: words(&["F", "F", "F"]),
            meaning: "force of the pair on its secondary side".into(),
        },
        HistoryInfo {
            name: "Certificate".into(),
            columns: words(&["residual", "overclosure"]),
            units: words(&["1", "L"]),
            meaning: "how well the increment is solved".into(),
        },
    ]
}

impl Scene {
    pub fn cells(&self) -> usize {
        self.body.len()
    }

    pub fn rows(&self, field: &FieldInfo) -> usize {
        if field.location == Location::Point { self.points.len() } else { self.cells() }
    }

    pub fn create(&self, path: &Path) -> Result<ResultsFile, ResultsError> {
        let blocks: Vec<GridBlock> =
            self.blocks.iter().map(|(kind, labels, nodes)| GridBlock { kind: *kind, labels, nodes }).collect();
        let grid = Grid {
            points: &self.points,
            node_labels: &self.node_labels,
            blocks: &blocks,
            body: &self.body,
            instances: &[],
        };
        let job = JobInfo { job: "rows", heading: "Cubes in a row, größer", version: "0.1.0" };
        ResultsFile::create(path, job, &grid, FIELDS, &histories())
    }

    /// Appends frame `frame` with its histories.
    pub fn append(&self, file: &mut ResultsFile, frame: usize) -> Result<(), ResultsError> {
        let fields: Vec<Vec<f64>> = FIELDS.iter().enumerate().map(|(i, f)| values(frame, i, self.rows(f))).collect();
        let fields: Vec<&[f64]> = fields.iter().map(Vec::as_slice).collect();
        let force = [frame as f64, -1.0, 0.5];
        let rows = [
            HistoryRow { name: "CF UPPER-LOWER", values: &force },
            HistoryRow { name: "Certificate", values: &[1e-9, 2e-12] },
        ];
        let step = usize::from(frame > 0);
        file.append(&Frame { time: time(frame), step, increment: frame, fields: &fields }, &rows)
    }
}

/// An empty folder of its own below the target directory.
pub fn folder(name: &str) -> PathBuf {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join(name);
    let _ = std::fs::remove_dir_all(&folder);
    std::fs::create_dir_all(&folder).unwrap();
    folder
}
