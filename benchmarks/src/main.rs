//! Speed against error: problems with known answers, run through the same entry as `fe`.

fn main() {}
