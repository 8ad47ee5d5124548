//! Reads a results file with a library that did not write it, and compares every number.
#![allow(dead_code, clippy::unwrap_used)]

use super::{Scene, time, value};
use fe_io::results::fields::FIELDS;
use hdf5_reader::{Hdf5File, SliceInfo, SliceInfoElem};
use std::path::Path;

/// Rows `first..first + count` of an array.
pub fn rows(file: &Hdf5File, path: &str, first: usize, count: usize) -> Vec<f64> {
    let dataset = file.dataset(path).unwrap();
    let mut selection = SliceInfo::all(dataset.ndim());
    selection.selections[0] = SliceInfoElem::Slice { start: first as u64, end: (first + count) as u64, step: 1 };
    dataset.read_slice::<f64>(&selection).unwrap().into_iter().collect()
}

/// An array of integers.
pub fn integers(file: &Hdf5File, path: &str) -> Vec<i64> {
    file.dataset(path).unwrap().read_array::<i64>().unwrap().into_iter().collect()
}

/// Number of committed frames.
pub fn frames(file: &Hdf5File) -> usize {
    file.group("VTKHDF/Steps").unwrap().attribute("NSteps").unwrap().read_scalar::<i64>().unwrap() as usize
}

/// Compares every field of every committed frame with what was written, bit for bit; returns how many there are.
pub fn compare(path: &Path, scene: &Scene) -> usize {
    let file = Hdf5File::open(path).unwrap();
    let frames = frames(&file);
    let times: Vec<f64> = (0..frames).map(time).collect();
    assert_eq!(file.dataset("VTKHDF/Steps/Values").unwrap().shape(), [frames as u64]);
    assert_eq!(rows(&file, "VTKHDF/Steps/Values", 0, frames), times);
    for (index, field) in FIELDS.iter().enumerate() {
        let name = format!("{:?}Data/{}", field.location, field.name);
        let offsets = integers(&file, &format!("VTKHDF/Steps/{:?}DataOffsets/{}", field.location, field.name));
        let count = scene.rows(field);
        for (frame, &offset) in offsets.iter().enumerate().take(frames) {
            let found = rows(&file, &format!("VTKHDF/{name}"), offset as usize, count);
            assert_eq!(found.len(), count * field.width(), "{name}");
            for (i, found) in found.into_iter().enumerate() {
                let expected = value(frame, index, i / field.width(), i % field.width());
                let same = found == expected || (found.is_nan() && expected.is_nan());
                assert!(same, "{name} frame {frame} number {i}: {found}, not {expected}");
            }
        }
    }
    for frame in 0..frames {
        let head = [time(frame), f64::from(frame > 0), frame as f64];
        assert_eq!(rows(&file, "Signorini/Frames", frame, 1), head);
        let force = rows(&file, "Signorini/History/CF UPPER-LOWER", frame, 1);
        assert_eq!(force, [head[0], head[1], head[2], frame as f64, -1.0, 0.5]);
        assert_eq!(rows(&file, "Signorini/Certificate", frame, 1)[3..], [1e-9, 2e-12]);
    }
    frames
}
