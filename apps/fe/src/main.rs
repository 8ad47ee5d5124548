//! The program `fe`.

fn main() -> std::process::ExitCode {
    fe::main(fe::standard())
}
