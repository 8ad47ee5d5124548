//! A job that is killed leaves all its finished increments.
#![allow(clippy::unwrap_used, clippy::print_stdout)]
#![cfg(unix)]

mod results_scene;

use results_scene::{folder, python, reading, scene};
use std::io::{BufRead, BufReader, Read};
use std::path::Path;
use std::process::{Command, Stdio};
use std::time::Duration;

const CHILD: &str = "SIGNORINI_RESULTS_CHILD";
const HEXES: usize = 3;

/// Not a test of its own: the process that is killed. It says each frame that is finished.
#[test]
fn child() {
    let Some(path) = std::env::var_os(CHILD) else { return };
    let scene = scene(HEXES);
    let mut file = scene.create(Path::new(&path)).unwrap();
    for frame in 0..400 {
        scene.append(&mut file, frame).unwrap();
        println!("frame {frame}");
    }
}

/// Starts a job, lets it finish `frames` frames, waits, kills it; returns how many frames it had finished.
fn killed_after(path: &Path, frames: usize, wait: Duration) -> usize {
    let mut command = Command::new(std::env::current_exe().unwrap());
    command.args(["child", "--exact", "--nocapture", "--test-threads=1"]).env(CHILD, path);
    let mut child = command.stdout(Stdio::piped()).stderr(Stdio::null()).spawn().unwrap();
    let mut lines = BufReader::new(child.stdout.take().unwrap());
    let (mut line, mut finished) = (String::new(), 0);
    while finished < frames {
        line.clear();
        assert!(lines.read_line(&mut line).unwrap() > 0, "the job ended early");
        finished += usize::from(line.contains("frame "));
    }
    std::thread::sleep(wait);
    child.kill().unwrap();
    child.wait().unwrap();
    let mut rest = String::new();
    lines.read_to_string(&mut rest).unwrap();
    finished + rest.matches("frame ").count()
}

#[test]
fn finished_increments_survive_kills() {
    let folder = folder("results_killed");
    let python = python::python();
    if let Err(why) = &python {
        println!("h5py and VTK do not read the files: {why}");
    }
    let scene = scene(HEXES);
    let mut stored = Vec::new();
    for kill in 0..60 {
        let path = folder.join(format!("{kill}.vtkhdf"));
        // Moments spread over the milliseconds that one append takes.
        let wait = Duration::from_micros(170 * (kill as u64 * 7 % 61));
        let finished = killed_after(&path, 1 + kill % 5, wait);
        let frames = reading::compare(&path, &scene);
        assert!(frames == finished || frames == finished + 1, "{finished} finished, {frames} in the file");
        stored.push(frames);
        if let (Ok(python), 0) = (&python, kill % 6) {
            python::check(python, &path, HEXES, frames);
        }
    }
    println!("frames left by the kills: {stored:?}");
    // Some kills must have come later than the frame that was waited for, or nothing was tested.
    assert!((0..60).any(|kill| stored[kill] > 1 + kill % 5));
}
