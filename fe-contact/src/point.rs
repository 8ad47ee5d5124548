//! One constraint point of contact: where it sits, how much surface it stands for, what it presses on.

/// The unit rule: the law's number times the measure is the force.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Measure {
    /// An area [L²]: the law's number is a pressure.
    Area(f64),
    /// A length [L]: the law's number is a force per length.
    Length(f64),
    /// A point: the law's number is a force.
    Point,
}

impl Measure {
    /// Area, length, or 1.
    pub fn value(self) -> f64 {
        match self {
            Measure::Area(v) | Measure::Length(v) => v,
            Measure::Point => 1.0,
        }
    }
}

/// Open or closed.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum ContactStatus {
    /// No pressure.
    #[default]
    Open,
    /// Pressed, not slipping (always so without friction).
    Closed,
    /// Pressed and slipping.
    Slipping,
}

/// One constraint. With infinitesimal sliding its gap is linear in the displacement:
/// g = g₀ + Σ d·u over the nodes of both sides, and a force N = p A on it acts on the nodes as −N d
/// (residual: internal minus external force).
#[derive(Clone, Debug, PartialEq)]
pub struct ContactPoint {
    /// The secondary node that it stands for.
    pub node: u32,
    /// Gap g₀ [L] at zero displacement, positive when open.
    pub gap: f64,
    /// Unit normal of the main side, pointing at the secondary.
    pub normal: [f64; 3],
    /// How much surface it stands for.
    pub measure: Measure,
    /// Nodes of both sides, ascending, each with its derivatives ∂g/∂u by freedom of the node: `row` holds,
    /// node after node, as many numbers as the node has freedoms.
    pub nodes: Vec<u32>,
    /// The derivatives [-] (translations) and [L] (rotations).
    pub row: Vec<f64>,
}
