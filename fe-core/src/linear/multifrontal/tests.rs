use super::*;
use crate::freedoms::Freedoms;
use crate::matrix::Couplings;
use nalgebra::{DMatrix, DVector};

/// Small reproducible random numbers (Marsaglia's xorshift).
pub(in crate::linear) struct Random(pub u64);

impl Random {
    fn next(&mut self) -> u64 {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        self.0
    }

    pub fn below(&mut self, n: usize) -> usize {
        (self.next() >> 16) as usize % n
    }

    /// In (−1, 1).
    fn number(&mut self) -> f64 {
        (self.next() >> 11) as f64 / (1u64 << 52) as f64 - 1.0
    }
}

/// Random masks, random groups of nodes, each with a random positive semidefinite matrix; `shift` on the diagonal.
fn random_matrix(random: &mut Random, nodes: usize, shift: f64) -> BlockMatrix {
    let masks: Vec<u8> = (0..nodes).map(|_| random.below(64) as u8).collect();
    let freedoms = Freedoms::new(&masks);
    let mut couplings = Couplings::new(nodes);
    let groups: Vec<Vec<u32>> = (0..nodes + nodes / 2)
        .map(|_| {
            let first = random.below(nodes);
            let mut group: Vec<u32> = (0..4).map(|_| ((first + random.below(7)) % nodes) as u32).collect();
            group.sort_unstable();
            group.dedup();
            group
        })
        .collect();
    groups.iter().for_each(|group| couplings.add(group));
    let mut matrix = BlockMatrix::zero(Arc::new(Pattern::new(&freedoms, &couplings)));
    for group in &groups {
        let of = |node: u32| freedoms.of_node(node as usize).len();
        let parts: Vec<DMatrix<f64>> =
            group.iter().map(|&i| DMatrix::from_fn(of(i), 5, |_, _| random.number())).collect();
        for a in 0..group.len() {
            for b in 0..=a {
                let transposed = &parts[b] * parts[a].transpose(); // column-major of the transpose: row-major
                matrix.add_block(group[a], group[b], transposed.as_slice());
            }
        }
    }
    for node in 0..nodes as u32 {
        let n = freedoms.of_node(node as usize).len();
        matrix.add_block(node, node, (DMatrix::identity(n, n) * shift).as_slice());
    }
    matrix
}

fn dense(matrix: &BlockMatrix) -> DMatrix<f64> {
    let n = matrix.pattern.freedoms.len();
    let mut full = DMatrix::zeros(n, n);
    for j in 0..n {
        let (mut x, mut y) = (vec![0.0; n], vec![0.0; n]);
        x[j] = 1.0;
        matrix.multiply_add(&x, &mut y);
        full.column_mut(j).copy_from_slice(&y);
    }
    full
}

fn factored(matrix: &BlockMatrix, free: &[bool]) -> Result<Multifrontal, Singular> {
    let mut solver = Multifrontal::new();
    solver.analyse(&matrix.pattern, free, &vec![false; matrix.pattern.nodes()]);
    solver.factor(matrix).map(|()| solver)
}

/// Springs along all edges and diagonals of the cells of a lattice: as stiff against every motion of a body as a solid,
/// with the rigid motions of one. `copies` bodies side by side that do not touch.
fn lattice(cells: [usize; 3], copies: usize) -> BlockMatrix {
    let nodes = cells.map(|c| c + 1);
    let number = |at: [usize; 3]| at[0] + nodes[0] * (at[1] + nodes[1] * at[2]);
    let body = nodes.iter().product::<usize>();
    let mut couplings = Couplings::new(body * copies);
    let mut groups = Vec::new();
    for copy in 0..copies {
        for cell in 0..cells.iter().product::<usize>() {
            let at = [cell % cells[0], cell / cells[0] % cells[1], cell / cells[0] / cells[1]];
            let corners: Vec<u32> = (0..8)
                .map(|c| (copy * body + number([at[0] + c % 2, at[1] + c / 2 % 2, at[2] + c / 4])) as u32)
                .collect();
            couplings.add(&corners);
            groups.push(corners);
        }
    }
    let freedoms = Freedoms::new(&vec![0b111; body * copies]);
    let mut matrix = BlockMatrix::zero(Arc::new(Pattern::new(&freedoms, &couplings)));
    for corners in groups {
        for a in 0..8usize {
            for b in 0..a {
                let direction = [1, 2, 4].map(|bit| ((a & bit) / bit) as f64 - ((b & bit) / bit) as f64);
                let length = direction.iter().map(|d| d * d).sum::<f64>().sqrt();
                let block: Vec<f64> = (0..9).map(|k| direction[k / 3] * direction[k % 3] / length.powi(3)).collect();
                let opposite: Vec<f64> = block.iter().map(|v| -v).collect();
                matrix.add_block(corners[a], corners[a], &block);
                matrix.add_block(corners[b], corners[b], &block);
                matrix.add_block(corners[a], corners[b], &opposite);
            }
        }
    }
    matrix
}

/// All freedoms free but those of the first `held` nodes: of more than a line, else the body turns about it.
fn all_but(matrix: &BlockMatrix, held: usize) -> Vec<bool> {
    (0..matrix.pattern.freedoms.len()).map(|f| matrix.pattern.freedoms.node(f) >= held).collect()
}

/// Componentwise backward error of a Cholesky solution (Higham 2002, theorem 10.4, with Cauchy's inequality for
/// |L||Lᵀ|) plus the rounding of the residual itself: |b − Kx|ᵢ ≤ (4n + 1) u √Kᵢᵢ Σⱼ √Kⱼⱼ |xⱼ|.
fn assert_small_residual(matrix: &BlockMatrix, free: &[bool], b: &[f64], x: &[f64]) {
    let n = free.iter().filter(|&&f| f).count() as f64;
    let mut residual: Vec<f64> = b.iter().map(|v| -v).collect();
    matrix.multiply_add(x, &mut residual);
    let root: Vec<f64> = matrix.diagonal().into_iter().map(f64::sqrt).collect();
    let sum: f64 = root.iter().zip(x).map(|(d, x)| d * x.abs()).sum();
    for f in 0..x.len() {
        if free[f] {
            let bound = (4.0 * n + 1.0) * (f64::EPSILON / 2.0) * root[f] * sum;
            assert!(residual[f].abs() <= bound, "freedom {f}: {:e} > {bound:e}", residual[f]);
        } else {
            assert_eq!(x[f], 0.0);
        }
    }
}

#[test]
fn answers_are_those_of_a_dense_factor() {
    let mut random = Random(42);
    for nodes in [1, 2, 3, 10, 40, 80] {
        for _ in 0..6 {
            let matrix = random_matrix(&mut random, nodes, 0.5);
            let n = matrix.pattern.freedoms.len();
            let free: Vec<bool> = (0..n).map(|_| random.below(4) > 0).collect();
            let index: Vec<usize> = (0..n).filter(|&f| free[f]).collect();
            let full = dense(&matrix).select_rows(&index).select_columns(&index);
            let solver = factored(&matrix, &free).unwrap();
            let mut sides: Vec<Vec<f64>> = (0..3).map(|_| (0..n).map(|_| random.number()).collect()).collect();
            let given = sides.clone();
            solver.solve_all(&mut sides);
            for (b, many) in given.iter().zip(&sides) {
                let mut x = b.clone();
                solver.solve(&mut x);
                assert_small_residual(&matrix, &free, b, &x);
                assert_small_residual(&matrix, &free, b, many);
                if index.is_empty() {
                    continue;
                }
                let eigenvalues = full.symmetric_eigenvalues();
                let condition = eigenvalues.max() / eigenvalues.min();
                let right = DVector::from_iterator(index.len(), index.iter().map(|&f| b[f]));
                let exact = full.clone().cholesky().unwrap().solve(&right);
                let found = DVector::from_iterator(index.len(), index.iter().map(|&f| x[f]));
                // both have a backward error of at most (3n + 1) u ‖|L||Lᵀ|‖ ≤ (3n + 1) u tr K, see above
                let backward = (3 * index.len() + 1) as f64 * f64::EPSILON * full.trace() / eigenvalues.max();
                assert!((&found - &exact).norm() <= backward * condition * exact.norm());
            }
            assert_eq!(solver.cost().unknowns, index.len());
        }
    }
}

#[test]
fn a_large_body_leaves_the_residual_of_rounding() {
    let matrix = lattice([13, 11, 12], 1);
    let free = all_but(&matrix, 15);
    let solver = factored(&matrix, &free).unwrap();
    let mut random = Random(3);
    let b: Vec<f64> = free.iter().map(|_| random.number()).collect();
    let (mut x, mut sides) = (b.clone(), vec![b.clone(); 2]);
    solver.solve(&mut x);
    solver.solve_all(&mut sides);
    assert_small_residual(&matrix, &free, &b, &x);
    sides.iter().for_each(|x| assert_small_residual(&matrix, &free, &b, x));
    let cost = solver.cost();
    assert!(cost.factor_entries > matrix.values.len() / 2 && cost.flops > cost.factor_entries as f64);
}

/// Large enough for shared fronts and for subtrees side by side.
#[test]
fn one_two_and_eight_threads_give_the_same_bits() {
    let (one, many) = (lattice([11, 13, 12], 1), lattice([5, 4, 6], 7));
    for matrix in [one, many] {
        let free: Vec<bool> =
            (0..matrix.pattern.freedoms.len()).map(|f| matrix.pattern.freedoms.node(f) % 42 > 5).collect();
        let results: Vec<_> = [1, 2, 8]
            .into_iter()
            .map(|threads| {
                let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
                pool.install(|| {
                    let solver = factored(&matrix, &free).unwrap();
                    let mut sides = vec![(0..free.len()).map(|f| (f % 17) as f64).collect::<Vec<f64>>(); 2];
                    solver.solve(&mut sides[0]);
                    solver.solve_all(&mut sides[1..]);
                    (solver.factor, sides)
                })
            })
            .collect();
        assert!(results[0].0.iter().all(|v| v.is_finite()));
        assert!(results.iter().all(|r| *r == results[0]));
    }
}

#[test]
fn a_second_matrix_reuses_the_analysis() {
    let mut matrix = lattice([3, 4, 5], 1);
    let free = all_but(&matrix, 5);
    let mut solver = factored(&matrix, &free).unwrap();
    let b = vec![1.0; free.len()];
    let mut first = b.clone();
    solver.solve(&mut first);
    matrix.values.iter_mut().for_each(|v| *v *= 2.0);
    solver.factor(&matrix).unwrap();
    let mut second = b.clone();
    solver.solve(&mut second);
    assert_small_residual(&matrix, &free, &b, &second);
    // the same but for the rounding of √2 in the pivots, which both residuals bound
    let halved: Vec<f64> = first.iter().map(|x| x / 2.0).collect();
    assert_small_residual(&matrix, &free, &b, &halved);
}

/// Blocks among some nodes change, as in contact: those fronts alone are eliminated again, to the same bits.
#[test]
fn what_changed_is_eliminated_again_to_the_same_bits() {
    let mut random = Random(11);
    for (cells, last) in [([5, 4, 6], 0), ([5, 4, 6], 1), ([4, 4, 20], 2), ([3, 2, 2], 99)] {
        let mut matrix = lattice(cells, 2);
        let (body, layer) = (matrix.pattern.nodes() / 2, (cells[0] + 1) * (cells[1] + 1));
        let free: Vec<bool> = (0..6 * body).map(|f| f / 3 % body >= cells[0] + 2).collect();
        let changing: Vec<bool> = (0..2 * body).map(|node| node % body + layer * last >= body).collect();
        let mut solver = Multifrontal::new();
        solver.analyse(&matrix.pattern, &free, &changing);
        solver.factor(&matrix).unwrap();
        for _ in 0..3 {
            for node in (0..2 * body).filter(|&node| changing[node]) {
                let push = 1.0 + random.number();
                matrix.add_block(node as u32, node as u32, (DMatrix::identity(3, 3) * push).as_slice());
            }
            solver.factor_again(&matrix).unwrap();
            let mut anew = Multifrontal::new();
            anew.analyse(&matrix.pattern, &free, &changing);
            anew.factor(&matrix).unwrap();
            assert!(solver.factor == anew.factor);
        }
        let cost = solver.cost();
        assert_eq!(cost.flops_again == 0.0, last == 0);
        assert!(cost.flops_again <= cost.flops);
        assert!(last != 2 || cost.flops_again < 0.5 * cost.flops, "{cost:?}");
    }
}

#[test]
fn a_floating_body_is_named() {
    for (cells, copies) in [([2, 2, 2], 1), ([3, 2, 2], 3), ([6, 7, 5], 2), ([80, 2, 1], 1), ([10, 10, 10], 1)] {
        let matrix = lattice(cells, copies);
        let body = matrix.pattern.nodes() / copies;
        for floating in 0..copies {
            let held = |node: usize| node / body != floating && node % body < cells[0] + 2;
            let free: Vec<bool> = (0..3 * matrix.pattern.nodes()).map(|f| !held(f / 3)).collect();
            let singular = factored(&matrix, &free).err().unwrap();
            assert_eq!(singular.freedom / 3 / body, floating);
        }
        // with none held, the same one on any number of threads
        let free = vec![true; 3 * matrix.pattern.nodes()];
        let named: Vec<_> = [1, 2, 8]
            .map(|threads| {
                let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
                pool.install(|| factored(&matrix, &free).err().unwrap())
            })
            .to_vec();
        assert!(named.iter().all(|singular| *singular == named[0]));
    }
}

/// The slenderness of a cantilever is no mechanism: its tip keeps 1/(4 n³) or so of a cell's stiffness.
#[test]
fn a_slender_body_is_held() {
    let matrix = lattice([1, 1, 300], 1);
    let free = all_but(&matrix, 4);
    let (freedom, part) = factored(&matrix, &free).unwrap().least_held(&matrix).unwrap();
    assert!(free[freedom] && (1e-9..1e-5).contains(&part), "{part:e}");
}

#[test]
fn a_mechanism_is_named() {
    // held at two nodes, so that it turns about the line through them
    let matrix = lattice([4, 4, 4], 1);
    let mut free = vec![true; 3 * matrix.pattern.nodes()];
    free[..6].fill(false);
    assert!(factored(&matrix, &free).is_err());
    free[3 * 5 + 1] = false; // a third one that turns with it: held in the other plane
    free[3 * 5 + 2] = false;
    assert!(factored(&matrix, &free).is_ok());
}

#[test]
fn a_row_of_nothing_is_named_and_so_is_what_is_not_a_number() {
    let mut matrix = lattice([2, 1, 1], 1);
    let freedom = 3 * 5 + 1;
    let pattern = matrix.pattern.clone();
    for i in 0..pattern.nodes() {
        for k in pattern.row_start[i]..pattern.row_start[i + 1] {
            let start = pattern.value_start[k];
            (0..9)
                .filter(|v| 3 * i + v / 3 == freedom || 3 * pattern.columns[k] as usize + v % 3 == freedom)
                .for_each(|v| matrix.values[start + v] = 0.0);
        }
    }
    let free = all_but(&matrix, 4);
    assert_eq!(factored(&matrix, &free).err(), Some(Singular { freedom }));
    matrix.values.fill(f64::NAN);
    assert!(factored(&matrix, &free).is_err());
}

#[test]
fn a_negative_stiffness_is_named() {
    let mut matrix = lattice([1, 1, 1], 1);
    matrix.add_block(7, 7, &[0.0, 0.0, 0.0, 0.0, -100.0, 0.0, 0.0, 0.0, 0.0]);
    assert!(factored(&matrix, &all_but(&matrix, 4)).is_err());
}

#[test]
fn nothing_to_solve_is_solved() {
    let nothing = BlockMatrix::zero(Arc::new(Pattern::new(&Freedoms::new(&[]), &Couplings::new(0))));
    factored(&nothing, &[]).unwrap().solve(&mut []);
    let matrix = lattice([1, 1, 1], 1);
    let solver = factored(&matrix, &[false; 24]).unwrap();
    let mut x = [1.0; 24];
    solver.solve(&mut x);
    assert_eq!(x, [0.0; 24]);
    solver.solve_all(&mut []);
    assert_eq!(solver.cost(), Cost::default());
}
