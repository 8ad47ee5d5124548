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
mod tests {
    use super::*;

    fn surface(sweep: Sweep, start: [f64; 2], pieces: &[Piece]) -> RigidSurface {
        RigidSurface { name: "R".into(), sweep, start, pieces: pieces.to_vec() }
    }

    fn gap(s: &RigidSurface, x: [f64; 3]) -> f64 {
        s.distance(x).unwrap().gap
    }

    /// A line from x₀ to x₁ > x₀ faces +y; it reaches a tenth of its length past its ends and no further.
    #[test]
    fn a_line_faces_to_its_left_and_ends() {
        let s = surface(Sweep::Segments, [-1.0, 0.5], &[Piece::Line { to: [1.0, 0.5] }]);
        assert_eq!(s.distance([0.3, 0.75, 0.0]).unwrap(), Distance { gap: 0.25, normal: [0.0, 1.0, 0.0] });
        assert_eq!(gap(&s, [1.15, 0.25, 0.0]), -0.25);
        assert_eq!(s.distance([1.25, 0.6, 0.0]), None);
    }

    /// A box with its corner at the origin, bodies above and to the right of it: outside a convex corner the
    /// distance is that to the corner, inside it is that to the nearer face; a concave corner the other way.
    #[test]
    fn corners_are_met_from_both_sides() {
        let convex =
            surface(Sweep::Segments, [-4.0, 0.0], &[Piece::Line { to: [0.0, 0.0] }, Piece::Line { to: [0.0, -4.0] }]);
        let at = convex.distance([0.3, 0.4, 0.0]).unwrap();
        assert!(
            (at.gap - 0.5).abs() < 1e-15 && (at.normal[0] - 0.6).abs() < 1e-15 && (at.normal[1] - 0.8).abs() < 1e-15
        );
        assert_eq!(gap(&convex, [-0.1, -0.3, 0.0]), -0.1);
        let n = convex.distance([0.0, 0.0, 0.0]).unwrap().normal;
        assert!((n[0] * n[0] + n[1] * n[1] - 1.0).abs() < 1e-15);
        let concave =
            surface(Sweep::Segments, [0.0, 4.0], &[Piece::Line { to: [0.0, 0.0] }, Piece::Line { to: [4.0, 0.0] }]);
        assert_eq!(gap(&concave, [0.1, 0.3, 0.0]), 0.1);
        assert!((gap(&concave, [-0.3, -0.4, 0.0]) + 0.5).abs() < 1e-15);
    }

    /// Sphere of radius 2 about (1, 0, 3): |x − c| − R, normal from the centre, also on the axis.
    #[test]
    fn an_arc_revolved_is_a_sphere() {
        let sweep = Sweep::Revolution { origin: [1.0, 0.0, 3.0], axis: [0.0, 0.0, 1.0] };
        // Clockwise from the pole over the equator, so that the left is outside.
        let arcs =
            [Piece::Arc { to: [2.0, 0.0], center: [0.0, 0.0] }, Piece::Arc { to: [0.0, -2.0], center: [0.0, 0.0] }];
        let s = surface(sweep, [0.0, 2.0], &arcs);
        s.check().unwrap();
        for x in [[2.0, -1.0, 0.5], [1.0, 0.0, 0.4], [1.0, 0.0, 5.5], [1.5, 1.0, 3.0], [3.5, 1.0, 3.0]] {
            let r = Vector3::from(x) - Vector3::new(1.0, 0.0, 3.0);
            let at = s.distance(x).unwrap();
            assert!((at.gap - (r.norm() - 2.0)).abs() < 1e-14, "{x:?}");
            assert!((Vector3::from(at.normal) - r.normalize()).norm() < 1e-14, "{x:?}");
        }
    }

    /// A trough (arc travelled counter-clockwise, body inside) swept along a tilted generator.
    #[test]
    fn an_arc_swept_is_a_trough() {
        let (e1, e2) = ([0.6, 0.8, 0.0], [0.0, 0.0, 1.0]);
        let s = surface(
            Sweep::Cylinder { origin: [1.0, 2.0, 3.0], x: e1, y: e2 },
            [-1.0, 0.0],
            &[Piece::Arc { to: [0.0, -1.0], center: [0.0, 0.0] }, Piece::Arc { to: [1.0, 0.0], center: [0.0, 0.0] }],
        );
        // Local (0.3, −0.4), anywhere along the generator (0.8, −0.6, 0).
        let at = s.distance([1.0 + 0.18 + 1.6, 2.0 + 0.24 - 1.2, 3.0 - 0.4]).unwrap();
        assert!((at.gap - 0.5).abs() < 1e-14);
        let n = Vector3::new(-0.6 * 0.6, -0.6 * 0.8, 0.8);
        assert!((Vector3::from(at.normal) - n).norm() < 1e-14);
    }

    /// The normal is the gradient of the distance: central differences, error O(step²) with curvature ≤ 1/R.
    #[test]
    fn the_normal_is_the_gradient() {
        let s = surface(
            Sweep::Segments,
            [-3.0, 0.0],
            &[
                Piece::Line { to: [-1.0, 0.0] },
                Piece::Arc { to: [1.0, 0.0], center: [0.0, -1.0] },
                Piece::Line { to: [3.0, 1.0] },
            ],
        );
        for (i, j) in (0..20).flat_map(|i| (0..9).map(move |j| (i, j))) {
            let x = [-2.57 + 0.26 * f64::from(i), 0.031 + 0.17 * f64::from(j), 0.0];
            let at = s.distance(x).unwrap();
            let step = 1e-5;
            for k in 0..2 {
                let (mut a, mut b) = (x, x);
                a[k] -= step;
                b[k] += step;
                let slope = (gap(&s, b) - gap(&s, a)) / (2.0 * step);
                assert!((slope - at.normal[k]).abs() < 1e-8, "{x:?}");
            }
        }
    }

    #[test]
    fn impossible_profiles_are_refused() {
        let bad = |start, pieces: &[Piece]| surface(Sweep::Segments, start, pieces).check().unwrap_err();
        assert_eq!(bad([0.0, 0.0], &[]), RigidFault::NoPieces);
        assert_eq!(bad([0.0, 0.0], &[Piece::Line { to: [0.0, 0.0] }]), RigidFault::NoLength(1));
        assert_eq!(
            bad([1.0, 0.0], &[Piece::Arc { to: [0.0, 2.0], center: [0.0, 0.0] }]),
            RigidFault::NoArc { piece: 1, start: 1.0, end: 2.0 }
        );
        assert_eq!(bad([1.0, 0.0], &[Piece::Arc { to: [-1.0, 0.0], center: [0.0, 0.0] }]), RigidFault::LongArc(1));
    }
}
