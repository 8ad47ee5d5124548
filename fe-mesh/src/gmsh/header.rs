//! `$MeshFormat`: which format the file has.

use super::binary::{Binary, Encoding};
use super::error::Fault;
use super::source::Source;

/// Layout of the sections.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Version {
    /// 2.0 to 2.2.
    Two,
    /// 4.1.
    Four,
}

/// What `$MeshFormat` says.
#[derive(Clone, Copy, Debug)]
pub(super) struct Header {
    pub version: Version,
    /// `None`: text.
    pub binary: Option<Encoding>,
    /// Offset of the first byte after the section.
    pub end: usize,
}

const ALLOWED: &str = "format 4.1 or 2.2, text or binary (`gmsh old.msh -0 -format msh41 -o new.msh` converts)";
const START: &[u8] = b"$MeshFormat";
const END: &[u8] = b"$EndMeshFormat";

/// Reads the head of a file.
pub(super) fn read(bytes: &[u8]) -> Result<Header, Fault> {
    let start = bytes.iter().position(|b| !b.is_ascii_whitespace()).unwrap_or(bytes.len());
    if start == bytes.len() {
        return Err(Fault::new(start, "the file is empty").allow(ALLOWED));
    }
    if bytes[start..].starts_with(b"$NOD") {
        return Err(Fault::new(start, "the file has gmsh format 1").allow(ALLOWED));
    }
    if !bytes[start..].starts_with(START) {
        return Err(Fault::new(start, "this is no gmsh mesh: it does not start with $MeshFormat").allow(ALLOWED));
    }
    let (line_start, line_end) = line_after(bytes, start);
    let line = String::from_utf8_lossy(&bytes[line_start..line_end]);
    let words: Vec<&str> = line.split_whitespace().collect();
    let [version, kind, size] = words[..] else {
        let what = "$MeshFormat needs three numbers: version, file type, size";
        return Err(Fault::new(line_start, what).allow(ALLOWED));
    };
    let version = match version {
        "4.1" => Version::Four,
        "2" | "2.0" | "2.1" | "2.2" => Version::Two,
        other => {
            let other: String = other.chars().take(16).collect();
            return Err(Fault::new(line_start, format!("the file has gmsh format {other}")).allow(ALLOWED));
        }
    };
    let size_bytes = match size {
        "8" => 8,
        "4" => 4,
        _ => return Err(Fault::new(line_start, "the size of a number is neither 4 nor 8 bytes").allow(ALLOWED)),
    };
    let (binary, after) = match kind {
        "0" => (None, line_end),
        "1" => {
            let big_endian = byte_order(bytes, line_end + 1)?;
            (Some(Encoding { big_endian, size_bytes }), line_end + 5)
        }
        _ => return Err(Fault::new(line_start, "the file type is neither 0 (text) nor 1 (binary)").allow(ALLOWED)),
    };
    let rest = bytes.get(after..).unwrap_or_default();
    let gap = rest.iter().position(|b| !b.is_ascii_whitespace()).unwrap_or(rest.len());
    if !rest[gap..].starts_with(END) {
        return Err(Fault::new(after + gap, "$EndMeshFormat should stand here"));
    }
    Ok(Header { version, binary, end: after + gap + END.len() })
}

/// The line after the one that holds `at`: its start and its end.
fn line_after(bytes: &[u8], at: usize) -> (usize, usize) {
    let end_of_line =
        |from: usize| bytes[from..].iter().position(|&b| b == b'\n').map_or(bytes.len(), |length| from + length);
    let start = (end_of_line(at) + 1).min(bytes.len());
    (start, end_of_line(start))
}

/// Reads the number 1 that tells the byte order: true when it was written the other way round.
fn byte_order(bytes: &[u8], at: usize) -> Result<bool, Fault> {
    let at = at.min(bytes.len());
    let little = Encoding { big_endian: false, size_bytes: 8 };
    match Binary::new(bytes, at, little).int()? {
        1 => Ok(false),
        0x0100_0000 => Ok(true),
        other => {
            let what = format!("the byte order is not to be told: 1 should stand here, not {other}");
            Err(Fault::new(at, what).allow("a binary file that was not copied as text"))
        }
    }
}
