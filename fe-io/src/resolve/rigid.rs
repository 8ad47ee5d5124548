//! Analytical rigid surfaces.

use super::lines::line_fields;
use super::motion::Motion;
use super::scene::Scene;
use crate::deck::card::{Line, Token, normalized};
use crate::diagnostic::{Diagnostic, Diagnostics};
use crate::keyword::check::Entry;
use crate::keyword::row::Row;
use crate::keyword::{Field, table};
use fe_contact::rigid::{Piece, RigidSurface, Sweep};

const START: &[Field] = &[
    table::Field::word("START", "the word START"),
    table::Field::number("first coordinate", "L", "x, or the radius"),
    table::Field::number("second coordinate", "L", "y, or z along the axis"),
];
const LINE: &[Field] = &[table::Field::word("LINE", "the word LINE"), START[1], START[2]];
const ARC: &[Field] = &[
    table::Field::word("CIRCL", "the word CIRCL"),
    START[1],
    START[2],
    table::Field::number("first coordinate of the centre", "L", "x, or the radius"),
    table::Field::number("second coordinate of the centre", "L", "y, or z along the axis"),
];

/// Radii at both ends of an arc may differ by so much of the radius: decks give rounded centres.
const ROUNDED: f64 = 1e-3;

/// Reads an analytical surface of some type.
pub fn surface(
    entry: &Entry<'_>,
    name: &str,
    kind: &str,
    scene: &Scene<'_>,
    diagnostics: &mut Diagnostics,
) -> Option<RigidSurface> {
    let mut lines = scene.deck.lines(entry.card);
    let sweep = match kind {
        "SEGMENTS" => Sweep::Segments,
        "CYLINDER" => cylinder(entry, &mut lines, &scene.scope().motion, diagnostics)?,
        "REVOLUTION" => revolution(entry, &mut lines, &scene.scope().motion, diagnostics)?,
        _ => return None,
    };
    let (mut start, mut pieces) = profile(entry, lines, diagnostics)?;
    if sweep == Sweep::Segments {
        let motion = &scene.scope().motion;
        if !motion.keeps_plane() {
            let title = "the instance turns this plane surface out of its plane";
            let fault = Diagnostic::error(entry.card.span, title);
            diagnostics.push(fault.help("plane parts move in x and y and turn about the axis z"));
            return None;
        }
        start = motion.in_plane(start);
        pieces.iter_mut().for_each(|piece| *piece = moved(*piece, motion));
    }
    Some(RigidSurface { name: name.to_owned(), sweep, start, pieces })
}

/// Where an instance puts a piece of a plane profile.
fn moved(piece: Piece, motion: &Motion) -> Piece {
    match piece {
        Piece::Line { to } => Piece::Line { to: motion.in_plane(to) },
        Piece::Arc { to, center } => Piece::Arc { to: motion.in_plane(to), center: motion.in_plane(center) },
    }
}

/// Points of a data line, three coordinates each, where the instance puts them.
fn points<'a, const N: usize>(
    entry: &Entry<'_>,
    lines: &mut impl Iterator<Item = Line<'a>>,
    (kind, motion): (usize, &Motion),
    diagnostics: &mut Diagnostics,
) -> Option<[[f64; 3]; N]> {
    let Some(line) = lines.next() else {
        diagnostics.push(Diagnostic::error(entry.card.span, "the data lines with the axes are missing"));
        return None;
    };
    let row = Row::read(line, line_fields(entry, kind), diagnostics);
    let mut points = [[0.0; 3]; N];
    for (i, value) in points.iter_mut().flatten().enumerate() {
        *value = row.number(i)?;
    }
    row.sound.then(|| points.map(|point| motion.point(point)))
}

fn cylinder<'a>(
    entry: &Entry<'_>,
    lines: &mut impl Iterator<Item = Line<'a>>,
    motion: &Motion,
    diagnostics: &mut Diagnostics,
) -> Option<Sweep> {
    let [a, b] = points(entry, lines, (2, motion), diagnostics)?;
    let [c] = points(entry, lines, (3, motion), diagnostics)?;
    let x = unit(minus(b, a));
    let y = x.and_then(|x| unit(cross(x, minus(c, a))));
    if let (Some(x), Some(y)) = (x, y) {
        return Some(Sweep::Cylinder { origin: a, x, y });
    }
    diagnostics.push(Diagnostic::error(entry.card.span, "the points a, b and c of this surface lie on a line"));
    None
}

fn revolution<'a>(
    entry: &Entry<'_>,
    lines: &mut impl Iterator<Item = Line<'a>>,
    motion: &Motion,
    diagnostics: &mut Diagnostics,
) -> Option<Sweep> {
    let [a, b] = points(entry, lines, (2, motion), diagnostics)?;
    let axis = unit(minus(b, a));
    if axis.is_none() {
        diagnostics.push(Diagnostic::error(entry.card.span, "the points a and b of the axis are one"));
    }
    Some(Sweep::Revolution { origin: a, axis: axis? })
}

fn profile<'a>(
    entry: &Entry<'_>,
    lines: impl Iterator<Item = Line<'a>>,
    diagnostics: &mut Diagnostics,
) -> Option<([f64; 2], Vec<Piece>)> {
    let (mut start, mut at, mut pieces) = (None, [0.0; 2], Vec::new());
    for line in lines {
        let Some(word) = line.tokens().next() else { continue };
        let fields = match normalized(word.text).as_str() {
            "START" => START,
            "LINE" => LINE,
            "CIRCL" => ARC,
            other => {
                diagnostics.push(unknown(word, other));
                return None;
            }
        };
        let row = Row::read(line, fields, diagnostics);
        let to = [row.number(1)?, row.number(2)?];
        if !row.sound || (start.is_none() != (fields == START)) {
            let order = Diagnostic::error(line.span, "a profile has one START, before all other lines");
            if row.sound {
                diagnostics.push(order);
            }
            return None;
        }
        if start.is_none() {
            start = Some(to);
        } else {
            let piece = match (row.number(3), row.number(4)) {
                (Some(x), Some(y)) => Piece::Arc { to, center: [x, y] },
                _ => Piece::Line { to },
            };
            piece_fault(at, piece, line).into_iter().for_each(|fault| diagnostics.push(fault));
            pieces.push(piece);
        }
        at = to;
    }
    if pieces.is_empty() {
        let fault = Diagnostic::error(entry.card.span, "this surface has no profile");
        diagnostics.push(fault.help("write `START, x, y`, then lines such as `LINE, x, y`"));
        return None;
    }
    Some((start?, pieces))
}

fn unknown(word: Token<'_>, said: &str) -> Diagnostic {
    if said == "PARAB" {
        let fault = Diagnostic::error(word.span, "`PARAB` is not there yet");
        return fault.help("write lines and arcs: `LINE, x, y` and `CIRCL, x, y, centre x, centre y`");
    }
    let fault = Diagnostic::error(word.span, format!("`{said}` begins no line of a profile"));
    fault.known(said, ["START", "LINE", "CIRCL"])
}

/// What is wrong with a piece that begins at a point.
fn piece_fault(from: [f64; 2], piece: Piece, line: Line<'_>) -> Option<Diagnostic> {
    let distance = |a: [f64; 2], b: [f64; 2]| (a[0] - b[0]).hypot(a[1] - b[1]);
    match piece {
        Piece::Line { to } | Piece::Arc { to, .. } if to == from => {
            Some(Diagnostic::error(line.span, "this piece of the profile has no length"))
        }
        Piece::Arc { to, center } => {
            let (r, s) = (distance(from, center), distance(to, center));
            let differ = (r - s).abs() > ROUNDED * r.max(s);
            differ.then(|| {
                let title = format!("the ends of this arc are {r} and {s} away from its centre");
                Diagnostic::error(line.span, title)
            })
        }
        Piece::Line { .. } => None,
    }
}

fn minus(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    [a[0] - b[0], a[1] - b[1], a[2] - b[2]]
}

fn cross(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

/// The direction of a vector; `None` for one that has none.
pub fn unit(v: [f64; 3]) -> Option<[f64; 3]> {
    let length = v.iter().fold(0.0f64, |sum, c| sum.hypot(*c));
    (length > 0.0 && length.is_finite()).then(|| v.map(|c| c / length))
}
