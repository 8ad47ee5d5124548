//! The results file, read back by libraries that did not write it.
#![allow(clippy::unwrap_used, clippy::print_stdout)]

mod results_scene;

use fe_io::results::fields::FIELDS;
use fe_io::results::{Frame, Grid, HistoryRow, JobInfo, ResultsError, ResultsFile};
use hdf5_reader::Hdf5File;
use results_scene::{folder, python, reading, scene, values};

#[test]
fn every_field_reads_back_after_every_frame() {
    let path = folder("results_fields").join("rows.vtkhdf");
    let scene = scene(3);
    let mut file = scene.create(&path).unwrap();
    for frame in 0..5 {
        scene.append(&mut file, frame).unwrap();
        assert_eq!(reading::compare(&path, &scene), frame + 1);
    }
    let read = Hdf5File::open(&path).unwrap();
    let labels: Vec<i64> = scene.node_labels.iter().map(|&l| l as i64).collect();
    assert_eq!(reading::integers(&read, "VTKHDF/PointData/NodeLabel"), labels);
    assert_eq!(reading::integers(&read, "VTKHDF/CellData/ElementLabel"), [1, 2, 3, 5000, 5001, 5002, 5003, 5004, 9000]);
    assert_eq!(reading::integers(&read, "VTKHDF/Offsets"), [0, 8, 16, 24, 28, 32, 36, 40, 44, 48]);
    assert_eq!(reading::rows(&read, "VTKHDF/Points", 19, 1), [4.0, 0.0, 1.0]);
}

#[test]
fn h5py_and_vtk_agree() {
    let python = match python::python() {
        Ok(python) => python,
        Err(why) => return println!("skipped, h5py and VTK did not read the file: {why}"),
    };
    let folder = folder("results_python");
    for (hexes, frames) in [(3, 4), (1, 1), (40, 70)] {
        let path = folder.join(format!("{hexes}.vtkhdf"));
        let scene = scene(hexes);
        let mut file = scene.create(&path).unwrap();
        (0..frames).for_each(|frame| scene.append(&mut file, frame).unwrap());
        python::check(&python, &path, hexes, frames);
        file.finish("completed").unwrap();
        python::check(&python, &path, hexes, frames);
    }
}

/// More rows than a chunk holds, in numbers that chunks of equal length do not divide.
#[test]
fn a_frame_of_several_padded_chunks_reads_back() {
    let path = folder("results_chunks").join("rows.vtkhdf");
    let scene = scene(16385);
    assert_eq!((scene.points.len(), scene.cells()), (4 * 16387, 16391));
    let mut file = scene.create(&path).unwrap();
    (0..2).for_each(|frame| scene.append(&mut file, frame).unwrap());
    assert_eq!(reading::compare(&path, &scene), 2);
    let read = Hdf5File::open(&path).unwrap();
    assert_eq!(read.dataset("VTKHDF/PointData/U").unwrap().shape()[0], 2 * (4 * 16387 + 2));
    assert_eq!(reading::integers(&read, "VTKHDF/Steps/CellDataOffsets/S"), [0, 16392]);
    if let Ok(python) = python::python() {
        python::check(&python, &path, 16385, 2);
    }
}

#[test]
fn a_grid_without_cells_is_kept() {
    let path = folder("results_points").join("points.vtkhdf");
    let points = [[0.0; 3], [1.0, 2.0, 3.0]];
    let grid = Grid { points: &points, node_labels: &[4, 5], blocks: &[], body: &[], instances: &[] };
    let mut file = ResultsFile::create(&path, JobInfo::default(), &grid, FIELDS, &[]).unwrap();
    for frame in 0..3 {
        let fields: Vec<Vec<f64>> =
            FIELDS.iter().enumerate().map(|(i, f)| values(frame, i, file.values_of(f) / f.width())).collect();
        let fields: Vec<&[f64]> = fields.iter().map(Vec::as_slice).collect();
        file.append(&Frame { time: frame as f64, step: 1, increment: frame, fields: &fields }, &[]).unwrap();
    }
    let read = Hdf5File::open(&path).unwrap();
    assert_eq!(reading::frames(&read), 3);
    assert_eq!(read.dataset("VTKHDF/CellData/S").unwrap().shape(), [0, 6]);
    assert_eq!(reading::integers(&read, "VTKHDF/Steps/CellDataOffsets/S"), [0, 0, 0]);
    assert_eq!(reading::rows(&read, "VTKHDF/PointData/U", 4, 2), values(2, 0, 2));
}

#[test]
fn an_earlier_file_is_there_until_the_first_frame_is_complete() {
    let path = folder("results_earlier").join("rows.vtkhdf");
    let small = scene(1);
    let mut file = small.create(&path).unwrap();
    assert!(!path.exists());
    small.append(&mut file, 0).unwrap();
    file.finish("completed").unwrap();
    let large = scene(2);
    let mut file = large.create(&path).unwrap();
    assert_eq!(reading::compare(&path, &small), 1);
    let outcome = |path| Hdf5File::open(path).unwrap().group("Signorini").unwrap().attribute("outcome").unwrap();
    assert_eq!(outcome(&path).read_string().unwrap(), "completed");
    large.append(&mut file, 0).unwrap();
    assert_eq!(reading::compare(&path, &large), 1);
    assert_eq!(outcome(&path).read_string().unwrap(), "running");
    assert_eq!(std::fs::read_dir(path.parent().unwrap()).unwrap().count(), 1);
}

#[test]
fn what_does_not_fit_is_refused_and_leaves_the_file_whole() {
    let path = folder("results_refused").join("rows.vtkhdf");
    let scene = scene(1);
    let mut file = scene.create(&path).unwrap();
    scene.append(&mut file, 0).unwrap();
    let short = [0.0; 5];
    let fields = vec![&short[..]; FIELDS.len()];
    let frame = Frame { time: 0.0, step: 1, increment: 1, fields: &fields };
    assert!(matches!(file.append(&frame, &[]), Err(ResultsError::Length { expected: 36, found: 5, .. })));
    let frame = Frame { fields: &fields[1..], ..frame };
    let refused = file.append(&frame, &[]);
    assert!(
        matches!(refused, Err(ResultsError::Length { expected, found, .. }) if (expected, found) == (FIELDS.len(), FIELDS.len() - 1))
    );
    let unknown = HistoryRow { name: "ALLSE", values: &[1.0] };
    assert!(matches!(file.append_history(0.5, 1, 1, &[unknown]), Err(ResultsError::UnknownHistory(_))));
    let short = HistoryRow { name: "Certificate", values: &[1.0] };
    assert!(matches!(file.append_history(0.5, 1, 1, &[short]), Err(ResultsError::Length { expected: 2, .. })));
    scene.append(&mut file, 1).unwrap();
    assert_eq!(reading::compare(&path, &scene), 2);
}

#[test]
fn histories_go_on_where_no_frame_is_stored() {
    let path = folder("results_history").join("rows.vtkhdf");
    let scene = scene(1);
    let mut file = scene.create(&path).unwrap();
    scene.append(&mut file, 0).unwrap();
    for increment in 1..=600 {
        let row = HistoryRow { name: "Certificate", values: &[increment as f64, f64::NAN] };
        file.append_history(increment as f64, 1, increment, &[row]).unwrap();
    }
    let read = Hdf5File::open(&path).unwrap();
    assert_eq!(read.dataset("Signorini/Certificate").unwrap().shape(), [601, 5]);
    for increment in 1..=600 {
        let row = reading::rows(&read, "Signorini/Certificate", increment, 1);
        assert_eq!(row[..4], [increment as f64, 1.0, increment as f64, increment as f64]);
        assert!(row[4].is_nan());
    }
    assert_eq!(reading::frames(&read), 1);
}

/// The price of an increment does not grow with the increments before it: the file grows by the same amount, and an
/// append takes the same time. The only growing part is re-reading the index of the chunks, far below the factor
/// of two that is allowed between the least times, which other work on the machine hardly changes.
#[test]
fn a_thousand_increments_cost_the_same_each() {
    let path = folder("results_thousand").join("rows.vtkhdf");
    let scene = scene(3);
    let mut file = scene.create(&path).unwrap();
    let (mut times, mut sizes) = (Vec::new(), Vec::new());
    for frame in 0..1000 {
        let begin = std::time::Instant::now();
        scene.append(&mut file, frame).unwrap();
        times.push(begin.elapsed());
        sizes.push(std::fs::metadata(&path).unwrap().len());
    }
    let least = |range: std::ops::Range<usize>| times[range].iter().min().unwrap().as_secs_f64() * 1e3;
    let (early, late) = (least(50..250), least(800..1000));
    println!("append: {early:.2} ms early, {late:.2} ms late; {} bytes in all", sizes[999]);
    assert!(late < 2.0 * early, "{early} ms, later {late} ms");
    let growth = |from: usize, to: usize| (sizes[to] - sizes[from]) as f64;
    assert!(growth(600, 999) < 1.5 * growth(200, 599));
    assert_eq!(reading::compare(&path, &scene), 1000);
}

/// Throughput of large frames; `cargo test --release -p fe-io --test results -- --ignored --nocapture`.
#[test]
#[ignore = "a measurement"]
fn throughput_of_large_frames() {
    let path = folder("results_large").join("rows.vtkhdf");
    let scene = scene(60_000);
    let mut file = scene.create(&path).unwrap();
    // A smooth field, as displacements are.
    let smooth = |rows: usize, width: usize, frame: usize| -> Vec<f64> {
        (0..rows * width).map(|i| (1e-5 * i as f64 + frame as f64).sin() * 1e-3).collect()
    };
    let (mut bytes, mut seconds) = (0, 0.0);
    for frame in 0..4 {
        let fields: Vec<Vec<f64>> = FIELDS.iter().map(|f| smooth(scene.rows(f), f.width(), frame)).collect();
        let fields: Vec<&[f64]> = fields.iter().map(Vec::as_slice).collect();
        let begin = std::time::Instant::now();
        file.append(&Frame { time: frame as f64, step: 1, increment: frame, fields: &fields }, &[]).unwrap();
        seconds += begin.elapsed().as_secs_f64();
        bytes += fields.iter().map(|f| 8 * f.len()).sum::<usize>();
    }
    let stored = std::fs::metadata(&path).unwrap().len() as f64;
    println!("{:.0} MB/s, {:.2} of the numbers' bytes", bytes as f64 / seconds / 1e6, stored / bytes as f64);
    assert_eq!(reading::frames(&Hdf5File::open(&path).unwrap()), 4);
    std::fs::remove_file(&path).unwrap();
}
