//! Extrapolation of stage derivatives: [`Predictor`].

use crate::iteration::stage_rows::{SIDE_BY_SIDE, StageRow, column};

/// The least distance of nodes, in steps, for which a polynomial through them is used.
const LEAST_DISTANCE: f64 = 1e-3;

/// The extrapolation of the stage derivatives of n steps of equal size to those of the next step:
///
/// ```text
/// k ≈ (1 − (1 − S)^(n−m) (1 − P)) k
/// (Sk)_i is k_i of the step before
/// (Pk)_i = Σ_j ℓ_j(c_i) k_j,    ℓ_j(x) = Π_(l≠j) (x − x_l)/(x_j − x_l),    x = c − m, …, c − 1
/// ```
///
/// P evaluates the polynomial through the stage derivatives of the last m steps. Its error is of the stage order, but
/// it is a smooth function of the step: 1 − S, a backward difference, makes it smaller by a factor of the order of the
/// step.
///
/// Sources: Hairer, Lubich & Wanner, *Geometric Numerical Integration*, 2nd ed. (2006), §VIII.6.1 for P; DLMF,
/// §3.3(iii) for differences.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Predictor {
    pub(crate) stages: usize,
    /// The matrices of the k_j in the guess, oldest step first, for n = 1, 2, …, row by row.
    pub(crate) weights: Vec<Vec<f64>>,
    /// The same matrices, column by column, for stages side by side; none if there are no such stages.
    pub(crate) columns: Vec<Vec<StageRow>>,
}

impl Predictor {
    /// Creates the predictor for stages at the times c, in steps.
    ///
    /// If two of them coincide, there is no prediction. Methods whose stages are solved one after the other are such a
    /// case.
    pub(crate) fn new(nodes: &[f64]) -> Self {
        let (degree, most) = numbers_of_steps(nodes.len());
        let mut weights: Vec<_> = (1..=degree).map_while(|m| polynomial(nodes, m)).collect();
        while let Some(last) = weights.last().filter(|_| weights.len() < most) {
            weights.push(corrected(last, nodes.len()));
        }
        let side_by_side = if SIDE_BY_SIDE.contains(&nodes.len()) { &*weights } else { &[] };
        let columns = side_by_side.iter().map(|matrix| columns(matrix, nodes.len())).collect();
        Self { stages: nodes.len(), weights, columns }
    }

    /// Creates a predictor that makes no predictions, as for explicit methods.
    pub(crate) fn none() -> Self {
        Self { stages: 0, weights: Vec::new(), columns: Vec::new() }
    }

    /// Returns the number of stage derivatives to remember.
    pub(crate) fn capacity(&self) -> usize {
        self.weights.len() * self.stages
    }
}

/// Returns the number m of steps of the polynomial, and the number n of steps to remember, chosen to save the most
/// work.
///
/// The stages of methods with few stages have low order, and their combinations cost little.
fn numbers_of_steps(stages: usize) -> (usize, usize) {
    match stages {
        1 => (1, 10),
        2 => (2, 8),
        3 => (2, 5),
        _ => (1, 1),
    }
}

/// Returns the weights of (Pk)_i for m steps, or `None` if nodes coincide.
fn polynomial(nodes: &[f64], steps: usize) -> Option<Vec<f64>> {
    let past: Vec<f64> =
        (1..=steps).rev().flat_map(|n| nodes.iter().map(move |c| c - n as f64)).collect();
    let others = |j: usize| past.iter().enumerate().filter(move |&(l, _)| l != j).map(|(_, x)| x);
    let apart = |(j, x): (usize, &f64)| others(j).all(|y| (x - y).abs() > LEAST_DISTANCE);
    past.iter().enumerate().all(apart).then(|| {
        nodes
            .iter()
            .flat_map(|&c| (0..past.len()).map(move |j| (c, j)))
            .map(|(c, j)| lagrange_polynomial(&past, j, c))
            .collect()
    })
}

/// Returns the weights that correct those of n steps by the error that they had one step earlier:
///
/// ```text
/// 1 − (1 − S)(1 − W) = W + S(1 − W)
/// ```
fn corrected(weights: &[f64], stages: usize) -> Vec<f64> {
    let old = weights.len() / stages;
    let row = |(i, row): (usize, &[f64])| {
        let mut new = vec![0.0; old + stages];
        new[old + i] = 1.0;
        for (j, w) in row.iter().enumerate() {
            new[j] -= w;
            new[j + stages] += w;
        }
        new
    };
    weights.chunks_exact(old).enumerate().flat_map(row).collect()
}

/// Returns the columns of a matrix with a row for each stage.
fn columns(matrix: &[f64], stages: usize) -> Vec<StageRow> {
    let count = matrix.len().checked_div(stages).unwrap_or(0);
    (0..count).map(|j| column(stages, |i| &matrix[i * count..][..count], j)).collect()
}

/// Returns the value at x of the Lagrange polynomial that is 1 at the node with the index j and 0 at the others:
///
/// ```text
/// ℓ_j(x) = Π_(l≠j) (x − x_l)/(x_j − x_l)
/// ```
///
/// It is not finite if two nodes coincide, and NaN if there is no node with that index.
///
/// Source: DLMF, §3.3(i).
///
/// # Example
/// The polynomial through the values of x² at three nodes is x²:
/// ```
/// use collective_integrators::lagrange_polynomial;
/// let nodes = [0.0_f64, 1.0, 4.0];
/// let sum: f64 = (0..3).map(|j| nodes[j].powi(2) * lagrange_polynomial(&nodes, j, 2.0)).sum();
/// assert!((sum - 4.0).abs() < 1e-14);
/// ```
#[must_use]
pub fn lagrange_polynomial(nodes: &[f64], index: usize, x: f64) -> f64 {
    let Some(own) = nodes.get(index) else { return f64::NAN };
    let others = nodes.iter().enumerate().filter(|&(l, _)| l != index);
    others.map(|(_, node)| (x - node) / (own - node)).product()
}

#[cfg(test)]
#[allow(clippy::unwrap_used)]
mod tests {
    use super::*;
    use crate::iteration::stage_rows::WIDTH;
    use crate::tableaux::tableau::Tableau;

    /// The stage derivatives of the step with the number n: a polynomial of the time of some degree, and at each stage
    /// an error that is a power of n.
    fn derivatives(nodes: &[f64], n: f64, degree: usize, power: Option<usize>) -> Vec<f64> {
        let time = |c: f64| (0.3 * (n + c) - 1.0).powi(degree as i32);
        let error = |i: usize| power.map_or(0.0, |p| 0.1 * (1.0 + i as f64) * n.powi(p as i32));
        nodes.iter().enumerate().map(|(i, c)| time(*c) + error(i)).collect()
    }

    /// Returns the largest error of a prediction of step 0 from n steps.
    fn error(predictor: &Predictor, nodes: &[f64], n: usize, k: (usize, Option<usize>)) -> f64 {
        let past = (1..=n).rev().flat_map(|lag| derivatives(nodes, -(lag as f64), k.0, k.1));
        let past: Vec<_> = past.collect();
        let rows = predictor.weights[n - 1].chunks_exact(past.len());
        let guess = rows.map(|row| row.iter().zip(&past).map(|(w, k)| w * k).sum::<f64>());
        let expected = derivatives(nodes, 0.0, k.0, k.1);
        guess.zip(expected).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max)
    }

    #[test]
    fn columns_are_those_of_the_matrices() {
        for s in 1..=9 {
            let predictor = Predictor::new(Tableau::gauss(s).unwrap().nodes());
            let expected = if (2..=8).contains(&s) { predictor.weights.len() } else { 0 };
            assert_eq!(predictor.columns.len(), expected);
            for (columns, matrix) in predictor.columns.iter().zip(&predictor.weights) {
                let count = columns.len();
                assert_eq!(count * s, matrix.len());
                for (i, (j, column)) in
                    (0..WIDTH).flat_map(|i| columns.iter().enumerate().map(move |c| (i, c)))
                {
                    // Those of missing stages are those of the last one.
                    assert_eq!(column.0[i], matrix[i.min(s - 1) * count + j]);
                }
            }
        }
    }

    #[test]
    fn polynomials_of_the_time_and_errors_that_vary_with_the_step_are_continued() {
        for s in 1..=8 {
            let nodes = Tableau::gauss(s).unwrap().nodes().to_vec();
            let predictor = Predictor::new(&nodes);
            let (steps, most) = numbers_of_steps(s);
            assert_eq!(predictor.weights.len(), most);
            for n in 1..=most {
                // The polynomial has the values of n·s nodes; each correction removes one power of the errors.
                let (degree, corrections) = (n.min(steps) * s, n.saturating_sub(steps));
                let weights = predictor.weights[n - 1].iter().map(|w| w.abs()).sum::<f64>();
                // Rounding errors of the k_j and of the weights, multiplied by the weights.
                let bound = 100.0 * f64::EPSILON * weights * 10.0_f64.powi(corrections as i32);
                let error = |degree, power| error(&predictor, &nodes, n, (degree, power));
                let continued = error(degree - 1, corrections.checked_sub(1));
                assert!(continued < bound, "s = {s}, n = {n}: {continued:e}, {bound:e}");
                // The errors of one stage are all alike: the polynomial continues them too.
                let beyond = if s == 1 { n } else { corrections };
                assert!(error(degree - 1, Some(beyond)) > 10.0 * bound, "s = {s}, n = {n}");
            }
        }
    }
}
