//! How fast a gmsh file of a million nodes and hexahedra is read: its bytes parsed, and from disk to a mesh; gmsh's own
//! reader beside it, in turn, where it is installed.

use crate::machine::{self, Origin};
use crate::measure;
use crate::rows::{median, quantile};
use fe_mesh::CellKind;
use fe_mesh::generate::Block;
use fe_mesh::gmsh::{Encoding, Kept, parse, write};
use std::error::Error;
use std::fmt::Write as _;
use std::io::Write;
use std::path::{Path, PathBuf};
use std::process::Command;
use std::time::Instant;

/// How the reading is measured.
#[derive(Clone, Debug, PartialEq)]
pub struct Options {
    /// Hexahedra along each edge of the block.
    pub edge: usize,
    /// Counted readings, after one that is not counted.
    pub runs: usize,
    /// Folder of the files.
    pub work: PathBuf,
    /// Folder of the rows.
    pub results: PathBuf,
}

/// One reading.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Sample {
    wall: f64,
    cpu: f64,
}

/// A file, and what reading it took.
struct Reading<'a> {
    encoding: Encoding,
    path: PathBuf,
    /// Size [MB].
    megabytes: f64,
    peer: Option<&'a Peer>,
    /// Nodes and hexahedra that it holds.
    counts: [usize; 2],
    parsed: Vec<Sample>,
    whole: Vec<Sample>,
    peers: Vec<Sample>,
}

/// Rates that are asked for [MB/s], of the bytes of a file on one thread.
const fn target(encoding: Encoding) -> f64 {
    match encoding {
        Encoding::Text => 300.0,
        Encoding::Binary => 1000.0,
    }
}

/// Writes the files, reads them in turn with gmsh, and prints sizes, seconds, rates and ratios.
pub fn study(options: &Options, out: &mut dyn Write) -> Result<(), Box<dyn Error>> {
    let origin = Origin::here();
    let folder = options.work.join("reading");
    std::fs::create_dir_all(&folder)?;
    let peer = Peer::find(&folder);
    // Coordinates of sixteen digits.
    let map = |[x, y, z]: [f64; 3]| [x / 3.0 + 0.1 * y, y / 7.0 - 0.01 * z * z, z / 1.1 + x * y];
    let mesh = Block::hex8([options.edge; 3]).mapped(map);
    let counts = [mesh.points.len(), mesh.cell_count()];
    writeln!(out, "reading: gmsh 4.1, {} nodes, {} hexahedra", counts[0], counts[1])?;
    writeln!(out, "{origin}; one thread; medians of {} readings", options.runs)?;
    if peer.is_none() {
        writeln!(
            out,
            "gmsh is not installed (a `gmsh` program, or its module in python3 or $SIGNORINI_PYTHON): alone"
        )?;
    }
    writeln!(out, "\n{:<8}{:>8}  {:<34}{:>9}{:>9}{:>10}", "file", "MB", "what", "wall s", "cpu s", "MB/cpu s")?;
    let mut rows = String::from("file,megabytes,commit,machine,what,run,wall_s,cpu_s\n");
    for (encoding, name) in [(Encoding::Text, "text"), (Encoding::Binary, "binary")] {
        let path = folder.join(format!("block_{name}.msh"));
        std::fs::write(&path, write(&mesh, encoding))?;
        let megabytes = 1e-6 * std::fs::metadata(&path)?.len() as f64;
        let samples = Vec::new;
        let peer = peer.as_ref();
        let (parsed, whole, peers) = (samples(), samples(), samples());
        let mut reading = Reading { encoding, path, megabytes, peer, counts, parsed, whole, peers };
        reading.measure(options.runs)?;
        reading.print(name, out)?;
        reading.rows(name, &origin, &mut rows);
    }
    std::fs::create_dir_all(&options.results)?;
    let path = options.results.join("reading.csv");
    std::fs::write(&path, rows)?;
    Ok(writeln!(out, "\nrows: {}", path.display())?)
}

impl Reading<'_> {
    fn measure(&mut self, runs: usize) -> Result<(), Box<dyn Error>> {
        for run in 0..=runs {
            let (read, parsed, whole) = self.own()?;
            self.check("this program", read)?;
            let peer = self.peer.map(|peer| peer.read(&self.path)).transpose()?;
            if let Some((Some(read), _)) = peer {
                self.check("gmsh", read)?;
            }
            // The first reading brings the file into the system's memory.
            if run > 0 {
                self.parsed.push(parsed);
                self.whole.push(whole);
                self.peers.extend(peer.map(|(_, sample)| sample));
            }
        }
        Ok(())
    }

    /// What was read, parsing the bytes of the file, and going from the disk to the mesh.
    fn own(&self) -> Result<([usize; 2], Sample, Sample), Box<dyn Error>> {
        let bytes = std::fs::read(&self.path)?;
        let (read, parsed) = timed(|| parse(&bytes))?;
        drop((read?, bytes));
        let (mesh, whole) = timed(|| -> Result<_, Box<dyn Error>> {
            Ok(parse(&std::fs::read(&self.path)?)?.into_mesh(Kept::HighestDimension).0)
        })?;
        let mesh = mesh?;
        let hexahedra = mesh.blocks.iter().filter(|block| block.kind == CellKind::Hex8).map(|block| block.len()).sum();
        Ok(([mesh.points.len(), hexahedra], parsed, whole))
    }

    fn check(&self, who: &str, read: [usize; 2]) -> Result<(), String> {
        if read == self.counts { Ok(()) } else { Err(format!("{who} read {read:?} of {:?}", self.counts)) }
    }

    fn print(&self, name: &str, out: &mut dyn Write) -> std::io::Result<()> {
        let mut line = |file: &str, what: &str, samples: &[Sample]| -> std::io::Result<f64> {
            let [wall, cpu] = [median(samples.iter().map(|s| s.wall)), median(samples.iter().map(|s| s.cpu))];
            let rate = self.megabytes / cpu;
            writeln!(out, "{file:<8}{:>8.1}  {what:<34}{wall:>9.3}{cpu:>9.3}{rate:>10.0}", self.megabytes)?;
            Ok(rate)
        };
        let rate = line(name, "signorini, bytes to nodes and cells", &self.parsed)?;
        line(name, "signorini, disk to mesh", &self.whole)?;
        if let Some(peer) = self.peer {
            line(name, &format!("{}, disk to model", peer.version), &self.peers)?;
            let pairs = || self.peers.iter().zip(&self.whole);
            let ratios: [Vec<f64>; 2] =
                [pairs().map(|(p, o)| p.wall / o.wall).collect(), pairs().map(|(p, o)| p.cpu / o.cpu).collect()];
            for (clock, ratios) in ["wall", "cpu"].iter().zip(ratios) {
                let [low, middle, high] = [0.25, 0.5, 0.75].map(|part| quantile(ratios.iter().copied(), part));
                writeln!(out, "{:18}gmsh takes {middle:.2} times as long by {clock} ({low:.2}–{high:.2})", "")?;
            }
        }
        let (target, verdict) =
            (target(self.encoding), if rate >= target(self.encoding) { "reached" } else { "missed" });
        writeln!(out, "{:18}target {target:.0} MB/s of bytes: {verdict}, {rate:.0}", "")
    }

    fn rows(&self, name: &str, origin: &Origin, rows: &mut String) {
        let (megabytes, Origin { commit, machine, .. }) = (self.megabytes, origin);
        for (what, samples) in [("bytes", &self.parsed), ("mesh", &self.whole), ("gmsh", &self.peers)] {
            for (run, Sample { wall, cpu }) in samples.iter().enumerate() {
                // Writing to a string does not fail.
                let _ = writeln!(
                    rows,
                    "{name},{megabytes:.3},{commit},\"{machine}\",{what},{},{wall:.6},{cpu:.6}",
                    run + 1
                );
            }
        }
    }
}

/// The answer, and the time that this process took for it.
fn timed<T>(work: impl FnOnce() -> T) -> std::io::Result<(T, Sample)> {
    let (start, before) = (Instant::now(), measure::own_cpu()?);
    let answer = work();
    let wall = start.elapsed().as_secs_f64();
    Ok((answer, Sample { wall, cpu: measure::own_cpu()? - before }))
}

/// gmsh's own reader.
struct Peer {
    version: String,
    how: How,
}

/// Counts of nodes and hexahedra, where gmsh tells them, and what the reading took.
type PeerReading = (Option<[usize; 2]>, Sample);

enum How {
    /// Its module in this Python, timed around the reading alone.
    Module(String),
    /// The program, timed from launch to exit.
    Program,
}

impl Peer {
    fn find(folder: &Path) -> Option<Self> {
        let output = |program: &str, arguments: &[&str]| {
            let output = Command::new(program).args(arguments).current_dir(folder).output().ok()?;
            let text = [output.stdout, output.stderr].concat();
            output.status.success().then(|| String::from_utf8_lossy(&text).trim().to_string())
        };
        let python = machine::python();
        if let Some(version) = output(&python, &[&script()]) {
            return Some(Peer { version: format!("gmsh {version}"), how: How::Module(python) });
        }
        output("gmsh", &["-version"]).map(|version| Peer { version: format!("gmsh {version}"), how: How::Program })
    }

    fn read(&self, path: &Path) -> Result<PeerReading, Box<dyn Error>> {
        let file = path.canonicalize()?.display().to_string();
        let How::Module(python) = &self.how else {
            let command = ["gmsh", "-nt", "1", "-parse_and_exit", &file].map(String::from);
            let cost = measure::run(&command, path.parent().unwrap_or(Path::new(".")), "gmsh.log", 1)?;
            return Ok((None, Sample { wall: cost.wall, cpu: cost.cpu }));
        };
        let output = Command::new(python).args([&script(), &file]).output()?;
        let text = String::from_utf8_lossy(&output.stdout);
        let numbers: Vec<f64> = text.split_whitespace().filter_map(|word| word.parse().ok()).collect();
        match numbers[..] {
            [wall, cpu, nodes, cells] => Ok((Some([nodes as usize, cells as usize]), Sample { wall, cpu })),
            _ => Err(format!("gmsh did not read {file}: {text}{}", String::from_utf8_lossy(&output.stderr)).into()),
        }
    }
}

/// The script that times gmsh's reader.
fn script() -> String {
    concat!(env!("CARGO_MANIFEST_DIR"), "/scripts/gmsh_read.py").into()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Both encodings of a small block are read whole, and the table and the rows hold each reading.
    #[test]
    fn small_files_are_measured() {
        let folder = std::env::temp_dir().join(format!("reading-{}", std::process::id()));
        let results = folder.join("results");
        let options = Options { edge: 4, runs: 2, work: folder.clone(), results: results.clone() };
        let mut told = Vec::new();
        study(&options, &mut told).unwrap();
        let told = String::from_utf8(told).unwrap();
        assert!(told.contains("125 nodes, 64 hexahedra"), "{told}");
        assert_eq!(told.matches("signorini, disk to mesh").count(), 2, "{told}");
        let rows = std::fs::read_to_string(results.join("reading.csv")).unwrap();
        std::fs::remove_dir_all(folder).unwrap();
        assert_eq!(rows.lines().filter(|row| row.contains(",mesh,")).count(), 4, "{rows}");
    }
}
