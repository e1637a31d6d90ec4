//! The coefficients of a Gauss method and a top, in the form that the solver of the stage equations uses.

use super::row::{Row, WIDTH};
use crate::tops::top::HeavyTop;
use collective_integrators::{Tableau, lagrange_polynomial};
use core::array::from_fn;
use core::cmp::Ordering;

/// The coefficients of Gauss's method in terms of the weighted stage derivatives ℓ_j = h b_j k_j.
///
/// The method reads
///
/// ```text
/// Z_i = z + Σ_j μ_ij ℓ_j,    z₁ = z + Σ_j ℓ_j,    μ_ij = a_ij / b_j
/// ```
///
/// where μ_ij + μ_ji = 1 exactly. The method is therefore symplectic and conserves quadratic invariants,
/// whatever the rounding of the weights.
///
/// Source: Antoñana, Makazaga & Murua, *Reducing and monitoring round-off error propagation for
/// symplectic implicit Runge–Kutta schemes*, Numer. Algorithms 76 (2017).
#[derive(Clone, Debug, PartialEq)]
pub(super) struct GaussCoefficients {
    pub(super) stages: usize,
    /// The columns of the matrix μ.
    pub(super) columns: [Row; WIDTH],
    /// The columns of the matrix that maps the ℓ of the last step, extrapolated, to Σ_j μ_ij ℓ_j.
    pub(super) guess: [Row; WIDTH],
    /// The weights b_j.
    pub(super) weights: Row,
    /// The factors b_j / (4 I_k) that map 2Π_k to (b_j/2) Ω_k.
    pub(super) turn: [Row; 3],
    /// The weighted forces 2 b_j m g l c_k.
    pub(super) pull: [Row; 3],
    /// The ratio |γ|/max 1/I_k, in units of Π²/|Γ|.
    pub(super) reach: f64,
}

impl GaussCoefficients {
    /// Creates the coefficients from the tableau of a Gauss method with at most [`WIDTH`] stages.
    ///
    /// The columns and rows of missing stages are 0.
    pub(super) fn new(gauss: &Tableau, top: &HeavyTop) -> Self {
        let (s, b, c) = (gauss.stages(), gauss.weights(), gauss.nodes());
        let a = |i: usize, j: usize| gauss.row(i)[j];
        let ratio = |i: usize, j: usize| match i.cmp(&j) {
            // This is exact, since the ratio is between ½ and 2 below the diagonal.
            Ordering::Less => 1.0 - a(j, i) / b[i],
            Ordering::Equal => 0.5,
            Ordering::Greater => a(i, j) / b[j],
        };
        // The nodes of the last step are c_l − 1 in the time of this step.
        let nodes: Vec<f64> = c.iter().map(|c| c - 1.0).collect();
        let guess = |i: usize, l: usize| {
            let terms = (0..s).map(|m| a(i, m) * lagrange_polynomial(&nodes, l, c[m]));
            terms.sum::<f64>() / b[l]
        };
        let (inverse_inertia, force) = (top.inverse_inertia(), top.force::<f64>());
        let weighted = |x: f64| Row(from_fn(|j| if j < s { b[j] * x } else { 0.0 }));
        Self {
            stages: s,
            columns: columns(s, ratio),
            guess: columns(s, guess),
            weights: weighted(1.0),
            turn: from_fn(|k| weighted(0.25 * inverse_inertia[k])),
            pull: from_fn(|k| weighted(2.0 * force[k])),
            reach: force.norm() / inverse_inertia.amax(),
        }
    }
}

/// Returns the columns of an s×s matrix.
fn columns(s: usize, entry: impl Fn(usize, usize) -> f64) -> [Row; WIDTH] {
    from_fn(|j| Row(from_fn(|i| if i < s && j < s { entry(i, j) } else { 0.0 })))
}

#[cfg(test)]
#[allow(clippy::unwrap_used)]
mod tests {
    use super::*;

    fn coefficients(s: usize) -> (Tableau, GaussCoefficients) {
        let gauss = Tableau::gauss(s).unwrap();
        let top = HeavyTop::kovalevskaya(1.0, 1.0).unwrap();
        let coefficients = GaussCoefficients::new(&gauss, &top);
        (gauss, coefficients)
    }

    #[test]
    fn ratios_are_symplectic_to_the_last_bit() {
        for s in 1..=WIDTH {
            let (gauss, of) = coefficients(s);
            for (i, j) in (0..s * s).map(|n| (n / s, n % s)) {
                let (mu, transposed) = (of.columns[j].0[i], of.columns[i].0[j]);
                assert_eq!(mu + transposed, 1.0);
                assert_eq!(1.0 - mu, transposed);
                // 2 ulp of a number up to 1 in a_ij
                assert!((mu * gauss.weights()[j] - gauss.row(i)[j]).abs() < 1e-16, "{s} {i} {j}");
            }
        }
        // Negative control: quotients as they are rounded.
        let (gauss, _) = coefficients(8);
        let quotient = |i: usize, j: usize| gauss.row(i)[j] / gauss.weights()[j];
        assert!((0..64).any(|n| quotient(n / 8, n % 8) + quotient(n % 8, n / 8) != 1.0));
    }

    /// The stage derivatives of a polynomial of degree s − 1 are extrapolated exactly.
    #[test]
    fn the_guess_extrapolates_polynomials() {
        for s in 1..=WIDTH {
            let (gauss, of) = coefficients(s);
            let power = s as i32 - 1;
            let last = |l: usize| gauss.weights()[l] * (gauss.nodes()[l] - 1.0).powi(power);
            for i in 0..s {
                let sum: f64 = (0..s).map(|l| of.guess[l].0[i] * last(l)).sum();
                let exact = gauss.nodes()[i].powi(power + 1) / f64::from(power + 1);
                // The sum of the |Lagrange polynomials| at 1 is 2e5 for s = 8.
                assert!((sum - exact).abs() < 1e-10, "{s} {i} {:e}", sum - exact);
            }
        }
    }
}
