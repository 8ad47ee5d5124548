//! Analytical rigid surfaces: profiles of lines and arcs, plane, swept or revolved.

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
