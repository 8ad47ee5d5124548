//! Speed against error: problems with known answers, run through the same entry as `fe`, and what measures them.
#![cfg_attr(test, allow(clippy::unwrap_used))]

pub mod problems;
