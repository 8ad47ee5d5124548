//! Spoilt files of every encoding: an answer or an error, never a panic and never more memory than the file is worth.
#![allow(clippy::unwrap_used)]

use fe_mesh::gmsh::{Kept, parse};

/// Small files of every encoding, with every section that is read.
fn files() -> Vec<(String, Vec<u8>)> {
    let mut files = Vec::new();
    for name in ["tetrahedra", "partitioned", "hexahedra", "plane", "every_kind"] {
        for encoding in ["41", "41b", "22", "22b"] {
            let path = format!("{}/tests/data/{name}_{encoding}.msh", env!("CARGO_MANIFEST_DIR"));
            files.push((format!("{name}_{encoding}"), std::fs::read(path).unwrap()));
        }
    }
    files
}

/// Numbers that look random and are the same in every run (a linear congruence, Knuth's constants).
struct Dice(u64);

impl Dice {
    fn below(&mut self, limit: usize) -> usize {
        self.0 = self.0.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
        (self.0 >> 33) as usize % limit
    }
}

/// What can be read must also convert.
fn read(bytes: &[u8]) -> bool {
    match parse(bytes) {
        Ok(mesh) => {
            mesh.into_mesh(Kept::HighestDimension);
            true
        }
        Err(error) => {
            assert!(!error.to_string().is_empty());
            false
        }
    }
}

/// Cut off anywhere before the end of the last section, no file is read: every 7th byte, and the last 40.
#[test]
fn cut_off() {
    for (name, bytes) in files() {
        let end = bytes.len() - bytes.iter().rev().take_while(|byte| byte.is_ascii_whitespace()).count();
        for length in (0..end).step_by(7).chain(end - 40..end) {
            assert!(!read(&bytes[..length]), "{name} cut at {length}");
        }
        assert!(read(&bytes[..end]), "{name}");
    }
}

/// One to four bytes changed at 400 places of each file: single bits, any bytes, digits.
#[test]
fn changed_bytes() {
    let mut dice = Dice(1);
    let mut refused = 0;
    for (_, bytes) in files() {
        for _ in 0..400 {
            let mut bad = bytes.clone();
            for _ in 0..=dice.below(4) {
                let at = dice.below(bad.len());
                bad[at] = match dice.below(3) {
                    0 => bad[at] ^ (1 << dice.below(8)),
                    1 => dice.below(256) as u8,
                    _ => b"0123456789-. \n$e"[dice.below(16)],
                };
            }
            refused += !read(&bad) as usize;
        }
    }
    // Coordinates make up less than half of the bytes; most other changes are seen.
    assert!(refused > 2000, "{refused} of 8000");
}

/// Pieces taken out, doubled or filled with one byte.
#[test]
fn changed_pieces() {
    let mut dice = Dice(2);
    for (_, bytes) in files() {
        for _ in 0..200 {
            let (a, b) = (dice.below(bytes.len()), dice.below(bytes.len()));
            let (start, end) = (a.min(b), a.max(b).min(a.min(b) + 64));
            let piece = match dice.below(3) {
                0 => Vec::new(),
                1 => bytes[start..end].repeat(2),
                _ => vec![[0u8, 0xff, 0x7f, b'9', b'\n'][dice.below(5)]; end - start],
            };
            read(&[&bytes[..start], &piece, &bytes[end..]].concat());
        }
    }
}
