//! The contact patch: two blocks on each other under a constant pressure, E = 1000, ν = 0.3.

use super::deck::{self, Order};
use super::finding::from_value;
use super::run::Solved;
use fe_core::element::{ElementType, Space};
use fe_mesh::generate::Block;
use fe_mesh::{CellKind, Mesh};

/// Young's modulus [F/L²].
pub const YOUNG: f64 = 1000.0;
/// Poisson's ratio [-].
pub const POISSON: f64 = 0.3;
/// Pressure on the top [F/L²].
pub const PRESSURE: f64 = 10.0;

/// Two blocks, [0, 2] wide (and deep) and one high each.
#[derive(Clone, Debug)]
pub struct Patch {
    /// Element type of both.
    pub element: ElementType,
    /// Elements across the lower and the upper block; there are two in height.
    pub across: [usize; 2],
    /// How far the upper block begins inside the lower one [L].
    pub overlap: f64,
    /// The upper block's surface is the secondary one.
    pub upper_is_secondary: bool,
    /// The main surface is secondary of a second pair.
    pub both_ways: bool,
    /// How many times as stiff the lower block is [-].
    pub lower_factor: f64,
    /// Cards of the interaction, after `*SURFACE INTERACTION`.
    pub behavior: String,
    /// `TYPE=` of the pair.
    pub kind: &'static str,
    /// Poisson's ratio.
    pub poisson: f64,
    /// Residual asked for, of the mean force [-].
    pub residual: f64,
}

impl Default for Patch {
    fn default() -> Self {
        Patch {
            element: ElementType::CPE4,
            across: [4, 4],
            overlap: 0.0,
            upper_is_secondary: true,
            both_ways: false,
            lower_factor: 1.0,
            behavior: "*SURFACE BEHAVIOR, PENALTY\n".into(),
            kind: "SURFACE TO SURFACE",
            poisson: POISSON,
            residual: EXACT,
        }
    }
}

impl Patch {
    /// With plane strain squares, so many across the lower and the upper block.
    pub fn plane(lower: usize, upper: usize) -> Self {
        Patch { across: [lower, upper], ..Patch::default() }
    }

    /// True in space; the contact is then normal to z, else to y.
    fn in_space(&self) -> bool {
        self.element.space() == Space::Solid
    }

    /// Name of the direction of the pressure.
    fn axis(&self) -> &'static str {
        if self.in_space() { "Z" } else { "Y" }
    }

    /// Both blocks, sets and surfaces with the prefixes `LOW_` and `UP_`.
    pub fn mesh(&self) -> Mesh {
        let block = |n: usize, height: f64| {
            let (size, origin) = match self.in_space() {
                true => ([2.0, 2.0, 1.0], [0.0, 0.0, height]),
                false => ([2.0, 1.0, 0.0], [0.0, height, 0.0]),
            };
            let block = match self.element.kind() {
                CellKind::Tet4 => Block::tet4([n, n, 2]),
                CellKind::Tet10 => Block::tet10([n, n, 2]),
                CellKind::Hex8 => Block::hex8([n, n, 2]),
                CellKind::Tri3 => Block::tri3([n, 2]),
                _ => Block::quad4([n, 2]),
            };
            block.size(size).origin(origin).mesh()
        };
        let mut mesh = block(self.across[0], 0.0).prefixed("LOW_");
        mesh.append(&block(self.across[1], 1.0 - self.overlap).prefixed("UP_"));
        mesh
    }

    /// The model's cards but for supports: mesh, material, pair.
    pub fn model(&self, mesh: &Mesh, order: Order) -> String {
        let sets = ["LOW_BLOCK", "UP_BLOCK"];
        let axis = self.axis();
        let sides = [format!("UP_{axis}MIN"), format!("LOW_{axis}MAX")];
        let [secondary, main] = if self.upper_is_secondary { [0, 1] } else { [1, 0] }.map(|i: usize| &sides[i]);
        let second = if self.both_ways { format!("{main}, {secondary}\n") } else { String::new() };
        format!(
            "{}{}{}*SURFACE INTERACTION, NAME=I\n{}*CONTACT PAIR, INTERACTION=I, TYPE={}\n{secondary}, {main}\n{second}",
            deck::cards(mesh, &sets.map(|set| (set, self.element)), order),
            deck::elastic(&sets[1..], YOUNG, self.poisson),
            deck::material("LOWER", &sets[..1], self.lower_factor * YOUNG, self.poisson),
            self.behavior,
            self.kind,
        )
    }

    /// Supports that let both blocks widen freely: the bottom on the ground, and the sides x = 0 (and y = 0).
    fn supports(&self) -> String {
        let (normal, lateral) = if self.in_space() { (3, vec![("X", 1), ("Y", 2)]) } else { (2, vec![("X", 1)]) };
        let sides = lateral.iter().flat_map(|(axis, c)| ["LOW", "UP"].map(|b| format!("{b}_{axis}MIN, {c}\n")));
        format!("*BOUNDARY\nLOW_{}MIN, {normal}\n{}", self.axis(), sides.collect::<String>())
    }

    /// The deck with the pressure on the top.
    pub fn pressed(&self, mesh: &Mesh, order: Order) -> String {
        let load = format!("*DSLOAD\nUP_{}MAX, P, {PRESSURE}\n", self.axis());
        format!("{}{}{}", self.model(mesh, order), self.supports(), step(self.residual, &load))
    }

    /// The deck with the top held where it is: only the overlap presses.
    pub fn held(&self, mesh: &Mesh, order: Order) -> String {
        let normal = if self.in_space() { 3 } else { 2 };
        let top = format!("UP_{}MAX, {normal}\n", self.axis());
        format!("{}{}{top}{}", self.model(mesh, order), self.supports(), step(self.residual, ""))
    }

    /// The deck with the top moved up by `rise` [L].
    pub fn moved(&self, mesh: &Mesh, order: Order, rise: f64) -> String {
        let normal = if self.in_space() { 3 } else { 2 };
        let push = format!("*BOUNDARY\nUP_{}MAX, {normal}, {normal}, {rise:e}\n", self.axis());
        format!("{}{}{}", self.model(mesh, order), self.supports(), step(self.residual, &push))
    }

    /// Pressure over strain in the loaded direction [F/L²].
    pub fn modulus(&self) -> f64 {
        match self.element.space() {
            Space::PlaneStrain => YOUNG / (1.0 - self.poisson * self.poisson),
            _ => YOUNG,
        }
    }

    /// Largest relative errors of a pressed patch: contact pressure, and displacement of the top, which is that of
    /// both blocks and what the penalty gives way, p/k.
    pub fn errors_pressed(&self, solved: &Solved) -> [f64; 2] {
        let top = -(2.0 * PRESSURE / self.modulus() + PRESSURE / solved.stiffness(0));
        [from_value(PRESSURE, &solved.pressures()), from_value(top, &self.top(solved))]
    }

    /// Pressure [F/L²] of a held patch: overlap = 2 p/M + p/k.
    pub fn pressure_held(&self, solved: &Solved) -> f64 {
        self.overlap / (2.0 / self.modulus() + 1.0 / solved.stiffness(0))
    }

    /// Displacements of the top in the direction of the load [L].
    pub fn top(&self, solved: &Solved) -> Vec<f64> {
        let mesh = &solved.terms.structure.mesh;
        let component = if self.in_space() { 2 } else { 1 };
        let nodes = mesh.node_sets.get(&format!("UP_{}MAX", self.axis())).map_or(&[][..], Vec::as_slice);
        nodes.iter().filter_map(|&n| Some(solved.u[solved.terms.freedoms.index(n as usize, component)?])).collect()
    }
}

/// The residual that exact answers need, of the mean force [-].
pub const EXACT: f64 = 1e-12;

/// One step in one increment, down to a residual.
pub fn step(residual: f64, loads: &str) -> String {
    format!("*STEP\n*STATIC\n1., 1.\n*CONTROLS, PARAMETERS=FIELD\n{residual:e}\n{loads}*END STEP\n")
}
