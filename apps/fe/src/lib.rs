//! The program `fe` as a library: a keyword deck in, a certified results file out.
//!
//! A program with laws of its own is one file: `fe::main(Library { .. })`.
#![cfg_attr(test, allow(clippy::unwrap_used))]

pub mod approach;
pub mod certificate;
pub mod check;
mod cli;
pub mod console;
pub mod contact_fields;
pub mod course;
pub mod explicit;
pub mod fields;
pub mod histories;
pub mod job;
pub mod number;
pub mod observer;
pub mod plan;
pub mod printed;
pub mod reason;
pub mod recorder;
mod step_run;
pub mod terms;

pub use cli::{main, main_with, standard};
pub use fe_io::Library;
pub use job::{JobFailure, Report, run, run_model};
