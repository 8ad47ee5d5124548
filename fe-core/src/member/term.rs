//! The elements as a term of the virtual work, and what is read from it.

use super::{Members, Uniaxial, norm};
use crate::element::Family;
use crate::freedoms::Freedoms;
use crate::matrix::{BlockMatrix, Couplings};
use crate::reject::Reject;
use crate::term::{Assembly, Motion, Term};

impl Term for Members {
    fn name(&self) -> &str {
        &self.name
    }

    fn couplings(&self, couplings: &mut Couplings) {
        couplings.add_all(&self.nodes, self.element.kind().nodes());
    }

    fn evaluate(&self, at: Motion, _old: &[f64], _new: &mut [f64], out: &mut Assembly) -> Result<(), Reject> {
        let mut energy = 0.0;
        for cell in 0..self.cells.len() {
            let freedoms = self.freedoms_of(cell);
            for (strain, stress, rates, weight) in self.states(cell, at.u) {
                energy += 0.5 * weight * strain.iter().zip(&stress).map(|(e, s)| e * s).sum::<f64>();
                for (s, rates) in stress.iter().zip(rates.chunks_exact(self.per_cell)) {
                    freedoms.iter().zip(rates).for_each(|(&f, b)| out.residual[f as usize] += weight * s * b);
                }
            }
            if let Some(matrix) = out.stiffness.as_deref_mut() {
                self.add_stiffness(cell, matrix);
            }
        }
        out.energy += energy;
        if energy.is_finite() { Ok(()) } else { Err(Reject::NotFinite { place: self.name.clone(), node: None }) }
    }

    fn is_linear(&self) -> bool {
        true
    }
}

impl Members {
    fn freedoms_of(&self, cell: usize) -> &[u32] {
        &self.freedoms[cell * self.per_cell..(cell + 1) * self.per_cell]
    }

    /// Strains B u, section forces D B u, B and weight at each integration point of a cell.
    fn states<'a>(&'a self, cell: usize, u: &'a [f64]) -> impl Iterator<Item = (Vec<f64>, Vec<f64>, &'a [f64], f64)> {
        let freedoms = self.freedoms_of(cell);
        let size = self.strains * self.per_cell;
        (cell * self.points..(cell + 1) * self.points).map(move |p| {
            let rates = &self.rates[p * size..(p + 1) * size];
            let product = |row: &[f64]| row.iter().zip(freedoms).map(|(b, &f)| b * u[f as usize]).sum();
            let strain: Vec<f64> = rates.chunks_exact(self.per_cell).map(product).collect();
            let respond = |row: &[f64]| row.iter().zip(&strain).map(|(d, e)| d * e).sum();
            let stress = self.moduli.chunks_exact(self.strains).map(respond).collect();
            (strain, stress, rates, self.weights[p])
        })
    }

    /// Strain and stress of trusses at the integration points, `[cells × points]`; nothing of other elements.
    pub fn uniaxial(&self, u: &[f64]) -> Vec<Uniaxial> {
        let (nodes, trusses) = (self.element.kind().nodes(), self.element.family() == Family::Truss);
        let cells = if trusses { self.cells.len() } else { 0 };
        let state = |(strain, force, rates, _): (Vec<f64>, Vec<f64>, &[f64], f64)| {
            // The rates of the second end point along the line.
            let own = self.per_cell / nodes;
            let mut direction = [0.0; 3];
            direction[..own].copy_from_slice(&rates[own..2 * own]);
            let size = norm(&direction);
            Uniaxial { strain: strain[0], stress: force[0] / self.area, direction: direction.map(|d| d / size) }
        };
        (0..cells).flat_map(|cell| self.states(cell, u)).map(state).collect()
    }

    /// Strains and section forces at the integration points of all cells, `[cells × points]`, each in the order of the
    /// element's strains: of a truss ε and N [F]; of a beam ε₀, κ₁, κ₂, φ, γ₁, γ₂ and N, M₁, M₂, T, Q₁, Q₂.
    pub fn section_forces(&self, u: &[f64]) -> Vec<(Vec<f64>, Vec<f64>)> {
        let states = (0..self.cells.len()).flat_map(|cell| self.states(cell, u));
        states.map(|(strain, stress, ..)| (strain, stress)).collect()
    }

    /// Section forces N, Q₁, Q₂ [F] and moments M₁, M₂, T [F L] of each cell, means over its length; those of slender
    /// beams by equilibrium, Q₁ = −M₂′ and Q₂ = M₁′. Nothing of springs.
    pub fn mean_section_forces(&self, u: &[f64]) -> Vec<[f64; 6]> {
        let family = self.element.family();
        let cells = if matches!(family, Family::Truss | Family::Beam) { self.cells.len() } else { 0 };
        let mean = |cell: usize| {
            let (mut sum, mut length, mut ends) = ([0.0; 6], 0.0, Vec::new());
            for (_, force, _, weight) in self.states(cell, u) {
                force.iter().enumerate().for_each(|(i, force)| sum[i] += weight * force);
                length += weight;
                ends.push(force);
            }
            let [n, m1, m2, t, mut q1, mut q2] = sum.map(|s| s / length);
            if let ([first, last], Family::Beam) = (ends.as_slice(), family) {
                let apart = length / 3f64.sqrt();
                (q1, q2) = ((first[2] - last[2]) / apart, (last[1] - first[1]) / apart);
            }
            [n, q1, q2, m1, m2, t]
        };
        (0..cells).map(mean).collect()
    }

    /// Sum of the forces [F] by direction with which the elements resist a displacement: zero but for springs that are
    /// fixed to the ground, or that turn a force.
    pub fn resultant(&self, freedoms: &Freedoms, u: &[f64]) -> [f64; 3] {
        let mut sum = [0.0; 3];
        for cell in 0..self.cells.len() {
            for (_, stress, rates, weight) in self.states(cell, u) {
                for (s, rates) in stress.iter().zip(rates.chunks_exact(self.per_cell)) {
                    for (&f, b) in self.freedoms_of(cell).iter().zip(rates) {
                        if let Some(sum) = sum.get_mut(freedoms.component(f as usize)) {
                            *sum += weight * s * b;
                        }
                    }
                }
            }
        }
        sum
    }

    /// K = Σ w Bᵀ D B, block by block.
    fn add_stiffness(&self, cell: usize, matrix: &mut BlockMatrix) {
        let (n, freedoms, nodes) = (self.per_cell, self.freedoms_of(cell), self.element.kind().nodes());
        let stiffness = self.stiffness(cell);
        let nodes = &self.nodes[cell * nodes..(cell + 1) * nodes];
        for (a, &i) in nodes.iter().enumerate() {
            for &j in &nodes[..=a] {
                let [rows, columns] = [i, j].map(|node| matrix.pattern.freedoms.of_node(node as usize));
                let mut block = vec![0.0; rows.len() * columns.len()];
                for (r, &row) in freedoms.iter().enumerate().filter(|(_, f)| rows.contains(&(**f as usize))) {
                    for (c, &column) in freedoms.iter().enumerate().filter(|(_, f)| columns.contains(&(**f as usize))) {
                        let place = (row as usize - rows.start) * columns.len() + column as usize - columns.start;
                        block[place] = stiffness[r * n + c];
                    }
                }
                matrix.add_block(i, j, &block);
            }
        }
    }

    /// K of a cell, `[freedoms × freedoms]`.
    fn stiffness(&self, cell: usize) -> Vec<f64> {
        let (n, m) = (self.per_cell, self.strains);
        let mut stiffness = vec![0.0; n * n];
        for p in cell * self.points..(cell + 1) * self.points {
            let (b, weight) = (&self.rates[p * m * n..(p + 1) * m * n], self.weights[p]);
            for k in 0..m {
                for l in (0..m).filter(|l| self.moduli[k * m + l] != 0.0) {
                    let modulus = weight * self.moduli[k * m + l];
                    for r in 0..n {
                        for c in 0..n {
                            stiffness[r * n + c] += b[k * n + r] * modulus * b[l * n + c];
                        }
                    }
                }
            }
        }
        stiffness
    }
}
