//! The program: measures problems with known answers.

use benchmarks::problems::cantilever;
use clap::{Parser, Subcommand};
use fe::observer::Silent;
use fe_core::element::ElementType;
use std::error::Error;
use std::io::Write;
use std::path::Path;
use std::process::ExitCode;

/// Speed against error: problems with known answers, run through the same entry as `fe`.
#[derive(Parser)]
#[command(name = "benchmarks", version, about)]
struct Arguments {
    #[command(subcommand)]
    command: Command,
}

#[derive(Subcommand)]
enum Command {
    /// The cantilever: deflection of the tip against unknowns and seconds.
    Cantilever,
}

/// Elements and divisions through the depth of `cantilever`: some 2,000 to 100,000 unknowns.
const CANTILEVER: [(ElementType, usize); 6] = [
    (ElementType::C3D8, 4),
    (ElementType::C3D8, 8),
    (ElementType::C3D8, 14),
    (ElementType::C3D10, 2),
    (ElementType::C3D10, 4),
    (ElementType::C3D10, 7),
];

fn main() -> ExitCode {
    let done = match Arguments::parse().command {
        Command::Cantilever => run_cantilever(Path::new("target/benchmarks")),
    };
    match done {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            // Nothing can be said where standard error is closed.
            let _ = writeln!(std::io::stderr().lock(), "{error}");
            ExitCode::FAILURE
        }
    }
}
/// Runs the cantilever on all meshes and prints error against unknowns, seconds and memory.
fn run_cantilever(folder: &Path) -> Result<(), Box<dyn Error>> {
    std::fs::create_dir_all(folder)?;
    let mut out = std::io::stdout().lock();
    writeln!(
        out,
        "cantilever 10 x 1 x 1, tip deflection against Timoshenko's beam ({:.6}; a clamped solid tends to 0.7 % less)",
        cantilever::reference()
    )?;
    writeln!(out, "element   n  unknowns  against beam  order  assemble  factor   solve   write   total  [s]")?;
    for (element, n) in CANTILEVER {
        let mesh = cantilever::mesh(element, n);
        let name = format!("cantilever_{}_{n}", element.name().to_lowercase());
        let (deck, bytes) = cantilever::files(element, &mesh, &name);
        std::fs::write(folder.join(format!("{name}.msh")), bytes)?;
        let path = folder.join(format!("{name}.inp"));
        std::fs::write(&path, deck)?;
        let report = fe::run(&path, &fe::standard(), &mut Silent)?;
        let error = cantilever::tip(&mesh, &report.last.u) / cantilever::reference() - 1.0;
        let (unknowns, s) = (report.last.u.len() - 3 * mesh.node_sets["XMIN"].len(), report.certificate.seconds);
        let p = s.procedure;
        writeln!(
            out,
            "{:7} {n:3} {unknowns:9} {:12.3} % {:6.2} {:9.2} {:7.2} {:7.2} {:7.2} {:7.2}",
            element.name(),
            100.0 * error,
            p.order,
            p.assemble,
            p.factor,
            p.solve,
            s.write,
            s.total
        )?;
    }
    Ok(())
}
