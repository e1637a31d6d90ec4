//! Extrapolation of stage derivatives: [`Predictor`].

/// The least distance of nodes, in steps, for which a polynomial through them is used.
const LEAST_DISTANCE: f64 = 1e-3;

/// The extrapolation of the stage derivatives of n steps of equal size to those of the next step:
///
/// ```text
/// k_i ≈ Σ_j w_ij k_j,    w_ij = Π_(l≠j) (c_i − x_l)/(x_j − x_l),    x = c − n, …, c − 1
/// ```
///
/// It evaluates the polynomial through the stage derivatives.
///
/// Source: Hairer, Lubich & Wanner, *Geometric Numerical Integration*, 2nd ed. (2006), §VIII.6.1.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Predictor {
    pub(crate) stages: usize,
    /// The matrices w for n = 1, 2, …, row by row.
    pub(crate) weights: Vec<Vec<f64>>,
}

impl Predictor {
    /// Creates the predictor for stages at the times c, in steps.
    ///
    /// If two of them coincide, there is no prediction. Methods whose stages are solved one after the other are such a
    /// case.
    pub(crate) fn new(nodes: &[f64]) -> Self {
        let matrices = (1..=most_steps(nodes.len())).map_while(|steps| weights(nodes, steps));
        Self { stages: nodes.len(), weights: matrices.collect() }
    }

    /// Creates a predictor that makes no predictions, as for explicit methods.
    pub(crate) fn none() -> Self {
        Self { stages: 0, weights: Vec::new() }
    }

    /// Returns the number of stage derivatives to remember.
    pub(crate) fn capacity(&self) -> usize {
        self.weights.len() * self.stages
    }
}

/// Returns the number of steps to remember, chosen to save the most iterations.
///
/// The stages of methods with few stages have low order. Their errors would be enlarged by a polynomial of high degree.
/// A single stage has the same error in every step.
fn most_steps(stages: usize) -> usize {
    match stages {
        1 => 10,
        2 | 3 => 2,
        _ => 1,
    }
}

/// Returns the weights w for n steps, or `None` if nodes coincide.
fn weights(nodes: &[f64], steps: usize) -> Option<Vec<f64>> {
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
