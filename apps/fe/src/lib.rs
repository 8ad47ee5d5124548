//! The program `fe` as a library: a keyword deck in, a certified results file out.
#![cfg_attr(test, allow(clippy::unwrap_used))]

pub mod course;
