//! Analytical rigid surfaces: profiles of lines and arcs, plane, swept or revolved.

use nalgebra::{Vector2, Vector3};

/// One piece of a profile, from the end of the piece before it (or the start).
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Piece {
    /// A straight line to a point.
    Line {
        /// End.
        to: [f64; 2],
    },
    /// A circular arc of less than 180° to a point.
    Arc {
        /// End.
        to: [f64; 2],
        /// Centre.
        center: [f64; 2],
    },
}

/// What the profile sweeps.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Sweep {
    /// `TYPE=SEGMENTS`: the profile itself, in a plane or axisymmetric model.
    Segments,
    /// `TYPE=CYLINDER`: swept along a straight generator. The profile is in the local (x, y).
    Cylinder {
        /// Origin a.
        origin: [f64; 3],
        /// Unit local x.
        x: [f64; 3],
        /// Unit local y.
        y: [f64; 3],
    },
    /// `TYPE=REVOLUTION`: revolved about an axis. The profile is in (r, z).
    Revolution {
        /// Origin a.
        origin: [f64; 3],
        /// Unit axis (local z).
        axis: [f64; 3],
    },
}

/// An analytical rigid surface. Bodies may lie on the left of the profile, going from its start.
#[derive(Clone, Debug, PartialEq)]
pub struct RigidSurface {
    /// Name, capitals.
    pub name: String,
    /// What the profile sweeps.
    pub sweep: Sweep,
    /// Start of the profile.
    pub start: [f64; 2],
    /// The pieces.
    pub pieces: Vec<Piece>,
}

/// How far a profile reaches past its ends, of the length of its end pieces [-].
const EXTENSION: f64 = 0.1;

/// Why a rigid surface cannot be used.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum RigidFault {
    /// No pieces.
    #[error("the profile has no LINE and no CIRCL after START")]
    NoPieces,
    /// A piece of no length.
    #[error("piece {0} of the profile ends where it starts; give it another end or leave it out")]
    NoLength(usize),
    /// The ends of an arc are not equally far from its centre.
    #[error("CIRCL in piece {piece}: start and end are {start} and {end} from the centre; they must be equally far")]
    NoArc {
        /// Piece, from 1.
        piece: usize,
        /// Distance of the start [L].
        start: f64,
        /// Distance of the end [L].
        end: f64,
    },
    /// An arc of 180° or more.
    #[error("CIRCL in piece {0} spans 180° or more; cut it into shorter arcs")]
    LongArc(usize),
}

/// Signed distance d [L] to a rigid surface, positive on the left of its profile, and the unit normal ∇d there.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Distance {
    /// d [L].
    pub gap: f64,
    /// ∇d.
    pub normal: [f64; 3],
}

type Point = Vector2<f64>;

/// A piece with both ends: what the closest point is taken of.
#[derive(Clone, Copy)]
struct Segment {
    from: Point,
    to: Point,
    /// Centre, and +1 when counter-clockwise, −1 when clockwise.
    arc: Option<(Point, f64)>,
}

impl Segment {
    fn length(&self) -> f64 {
        match self.arc {
            None => (self.to - self.from).norm(),
            Some((c, _)) => (self.from - c).norm() * (self.from - c).angle(&(self.to - c)),
        }
    }

    /// Normal to the left at a point of the piece.
    fn normal(&self, at: Point) -> Point {
        match self.arc {
            None => left((self.to - self.from).normalize()),
            Some((c, sense)) => (c - at).normalize() * sense,
        }
    }

    /// Where the point's projection falls: `None` on the piece, else the end (0 or 1) beyond which it falls.
    fn beyond(&self, p: Point) -> Option<usize> {
        match self.arc {
            None => {
                let t = self.to - self.from;
                let s = (p - self.from).dot(&t);
                if s < 0.0 { Some(0) } else { (s > t.norm_squared()).then_some(1) }
            }
            Some((c, sense)) => {
                let (a, b, q) = (self.from - c, self.to - c, p - c);
                if q.norm() <= 1e-14 * a.norm() || (sense * a.perp(&q) >= 0.0 && sense * q.perp(&b) >= 0.0) {
                    None
                } else {
                    Some(usize::from((p - self.to).norm() < (p - self.from).norm()))
                }
            }
        }
    }

    /// Signed distance and normal where the projection falls on the piece.
    fn distance(&self, p: Point) -> (f64, Point) {
        match self.arc {
            None => {
                let n = self.normal(p);
                (n.dot(&(p - self.from)), n)
            }
            Some((c, sense)) => {
                let radius = (self.from - c).norm();
                let q = p - c;
                let outward =
                    if q.norm() > 1e-14 * radius { q.normalize() } else { (self.from + self.to - c * 2.0).normalize() };
                (sense * (radius - q.norm()), outward * -sense)
            }
        }
    }
}

fn left(t: Point) -> Point {
    Point::new(-t.y, t.x)
}

impl RigidSurface {
    /// The same surface with coordinates taken from `origin`.
    pub fn seen_from(&self, origin: &Vector3<f64>) -> RigidSurface {
        let less = |p: [f64; 3]| [p[0] - origin.x, p[1] - origin.y, p[2] - origin.z];
        let mut seen = self.clone();
        match &mut seen.sweep {
            Sweep::Cylinder { origin, .. } | Sweep::Revolution { origin, .. } => *origin = less(*origin),
            Sweep::Segments => {
                let less = |p: [f64; 2]| [p[0] - origin.x, p[1] - origin.y];
                seen.start = less(seen.start);
                for piece in &mut seen.pieces {
                    match piece {
                        Piece::Line { to } => *to = less(*to),
                        Piece::Arc { to, center } => (*to, *center) = (less(*to), less(*center)),
                    }
                }
            }
        }
        seen
    }

    /// Checks the profile.
    pub fn check(&self) -> Result<(), RigidFault> {
        if self.pieces.is_empty() {
            return Err(RigidFault::NoPieces);
        }
        for (i, s) in self.segments().iter().enumerate() {
            let piece = i + 1;
            if (s.to - s.from).norm() == 0.0 {
                return Err(RigidFault::NoLength(piece));
            }
            if let Some((c, _)) = s.arc {
                let (start, end) = ((s.from - c).norm(), (s.to - c).norm());
                if (start - end).abs() > 1e-6 * start.max(end) {
                    return Err(RigidFault::NoArc { piece, start, end });
                }
                if (s.from - c).dot(&(s.to - c)) <= -start * end * (1.0 - 1e-12) {
                    return Err(RigidFault::LongArc(piece));
                }
            }
        }
        Ok(())
    }

    /// True when the surface belongs to plane and axisymmetric models.
    pub fn is_plane(&self) -> bool {
        self.sweep == Sweep::Segments
    }

    /// Signed distance at a point, `None` past the ends of the profile.
    pub fn distance(&self, x: [f64; 3]) -> Option<Distance> {
        let x = Vector3::from(x);
        let answer = |gap, normal: Vector3<f64>| Distance { gap, normal: normal.into() };
        match self.sweep {
            Sweep::Segments => self.profile_distance(x.xy()).map(|(d, n)| answer(d, Vector3::new(n.x, n.y, 0.0))),
            Sweep::Cylinder { origin, x: e1, y: e2 } => {
                let (e1, e2, r) = (Vector3::from(e1), Vector3::from(e2), x - Vector3::from(origin));
                let local = Point::new(r.dot(&e1), r.dot(&e2));
                self.profile_distance(local).map(|(d, n)| answer(d, e1 * n.x + e2 * n.y))
            }
            Sweep::Revolution { origin, axis } => {
                let (axis, r) = (Vector3::from(axis), x - Vector3::from(origin));
                let z = r.dot(&axis);
                let radial = r - axis * z;
                let radius = radial.norm();
                let (d, n) = self.profile_distance(Point::new(radius, z))?;
                // On the axis the normal of a body of revolution has no radial part.
                let normal = if radius > 1e-14 * z.abs().max(d.abs()) && radius > 0.0 {
                    radial * (n.x / radius) + axis * n.y
                } else {
                    axis * n.y.signum()
                };
                Some(answer(d, normal))
            }
        }
    }

    fn segments(&self) -> Vec<Segment> {
        let mut from = Point::from(self.start);
        self.pieces
            .iter()
            .map(|piece| {
                let (to, arc) = match *piece {
                    Piece::Line { to } => (Point::from(to), None),
                    Piece::Arc { to, center } => {
                        let (to, c) = (Point::from(to), Point::from(center));
                        (to, Some((c, if (from - c).perp(&(to - c)) > 0.0 { 1.0 } else { -1.0 })))
                    }
                };
                Segment { from: std::mem::replace(&mut from, to), to, arc }
            })
            .collect()
    }

    /// Signed distance and normal in the plane of the profile.
    fn profile_distance(&self, p: Point) -> Option<(f64, Point)> {
        let segments = self.segments();
        let closed = segments.last().is_some_and(|s| s.to == Point::from(self.start));
        let mut best: Option<(f64, Point)> = None;
        let mut offer = |d: f64, n: Point| {
            if best.is_none_or(|(b, _)| d.abs() < b.abs()) {
                best = Some((d, n));
            }
        };
        for (i, s) in segments.iter().enumerate() {
            let Some(end) = s.beyond(p) else {
                let (d, n) = s.distance(p);
                offer(d, n);
                continue;
            };
            let last = segments.len() - 1;
            let neighbour = match (i, end) {
                (0, 0) => closed.then_some(last),
                (i, 1) if i == last => closed.then_some(0),
                (i, 0) => Some(i - 1),
                (i, _) => Some(i + 1),
            };
            let tip = if end == 0 { s.from } else { s.to };
            let (r, n) = (p - tip, s.normal(tip));
            match neighbour {
                // At a corner the closest point is the corner itself; both pieces say so alike.
                Some(j) => {
                    let bisector = (n + segments[j].normal(tip)).normalize();
                    let side = if r.dot(&bisector) < 0.0 { -1.0 } else { 1.0 };
                    let normal = if r.norm() > 1e-14 * s.length() { r.normalize() * side } else { bisector };
                    offer(side * r.norm(), normal);
                }
                None if (r - n * r.dot(&n)).norm() <= EXTENSION * s.length() => offer(r.dot(&n), n),
                None => {}
            }
        }
        best
    }
}

#[cfg(test)]
mod tests;
