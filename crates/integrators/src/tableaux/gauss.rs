//! The coefficients of Gauss–Legendre collocation, in double-double arithmetic.

use crate::error::SchemeError;
use crate::tableaux::tableau::Tableau;
use std::sync::OnceLock;
use twofloat::TwoFloat;

/// The methods that have been computed, by their numbers of stages. To compute one takes as long as a hundred of its steps.
static KNOWN: [OnceLock<Tableau>; 17] = [const { OnceLock::new() }; 17];

impl Tableau {
    /// Creates Gauss–Legendre collocation with s stages: order 2s, symplectic, symmetric.
    ///
    /// The nodes are the zeros of the shifted Legendre polynomial P_s(2c − 1). With x_j = 2c_j − 1 the coefficients are
    ///
    /// ```text
    /// b_j = 1 / ((1 − x_j²) P_s′(x_j)²)
    /// a_ij = b_j Σ_(k<s) (2k+1) P_k(x_j) ∫ P_k(2τ−1) dτ,    the integral from 0 to c_i
    /// ```
    ///
    /// All of them are computed with 106 bits and rounded once. The remainders are kept as [low
    /// parts](Self::with_low_parts).
    ///
    /// Source: Hairer & Wanner, *Solving Ordinary Differential Equations II*, §IV.5.
    ///
    /// # Errors
    /// Returns [`SchemeError::NoStages`] if `stages` is 0.
    pub fn gauss(stages: usize) -> Result<Self, SchemeError> {
        let Some(known) = KNOWN.get(stages) else { return Self::computed(stages) };
        match known.get() {
            Some(tableau) => Ok(tableau.clone()),
            None => Self::computed(stages).map(|tableau| known.get_or_init(|| tableau).clone()),
        }
    }

    /// Computes the coefficients, which are the same each time.
    fn computed(stages: usize) -> Result<Self, SchemeError> {
        let nodes: Vec<_> = (0..stages).map(|i| legendre_zero(stages, i)).collect();
        let values: Vec<_> = nodes.iter().map(|&x| legendre(stages + 1, x)).collect();
        let weights: Vec<_> = (0..stages).map(|j| weight(stages, nodes[j], &values[j])).collect();
        let entry = |i: usize, j: usize| {
            let term = |k: usize| values[j][k] * integral(k, nodes[i], &values[i]);
            weights[j] * (0..stages).map(term).fold(TwoFloat::from(0.0), |sum, x| sum + x)
        };
        let entries = (0..stages * stages).map(|n| entry(n / stages, n % stages));
        let (a, a_low): (Vec<f64>, Vec<f64>) = entries.map(split).unzip();
        let (b, b_low): (Vec<f64>, Vec<f64>) = weights.iter().copied().map(split).unzip();
        Self::new(&a, &b)?.with_low_parts(&a_low, &b_low)
    }
}

/// Splits a number into its value to 53 bits and the remainder.
fn split(x: TwoFloat) -> (f64, f64) {
    let high = f64::from(x);
    (high, f64::from(x - high))
}

/// Returns the values P_0(x), …, P_n(x) by the three-term recurrence.
fn legendre(n: usize, x: TwoFloat) -> Vec<TwoFloat> {
    let mut values = vec![TwoFloat::from(1.0), x];
    for k in 1..n {
        let (k, previous, current) = (k as f64, values[k - 1], values[k]);
        values.push(((x * current) * (2.0 * k + 1.0) - previous * k) / (k + 1.0));
    }
    values
}

/// Returns the derivative P_s′(x) = (2s−1) P(s−1) + (2s−5) P(s−3) + … from the values P(k) of P_k at x.
fn legendre_slope(s: usize, values: &[TwoFloat]) -> TwoFloat {
    let term = |k: usize| values[k] * (2.0 * k as f64 + 1.0);
    (0..s).rev().step_by(2).map(term).fold(TwoFloat::from(0.0), |sum, x| sum + x)
}

/// Returns the i-th zero of P_s in increasing order, by Newton's iteration from Tricomi's estimate.
fn legendre_zero(s: usize, i: usize) -> TwoFloat {
    let angle = core::f64::consts::PI * (i as f64 + 0.75) / (s as f64 + 0.5);
    let mut x = TwoFloat::from(-angle.cos());
    // Convergence is quadratic from 3 digits to 16, then by 16 digits per step: six steps leave a reserve.
    for _ in 0..6 {
        let values = legendre(s, x);
        x -= f64::from(values[s]) / f64::from(legendre_slope(s, &values));
    }
    x
}

fn weight(s: usize, x: TwoFloat, values: &[TwoFloat]) -> TwoFloat {
    let slope = legendre_slope(s, values);
    reciprocal((TwoFloat::from(1.0) - x * x) * (slope * slope))
}

/// Returns the reciprocal 1/x by one Newton step from 53 bits.
///
/// The quotient of two `TwoFloat`s in version 0.8 of the crate has no more than these.
fn reciprocal(x: TwoFloat) -> TwoFloat {
    let estimate = TwoFloat::from(1.0 / f64::from(x));
    estimate * (TwoFloat::from(2.0) - x * estimate)
}

/// Returns (2k+1) ∫ P_k(2τ−1) dτ from 0 to c, which is ½ (P(k+1) − P(k−1)) at x = 2c − 1, with P(−1) = −1.
fn integral(k: usize, x: TwoFloat, values: &[TwoFloat]) -> TwoFloat {
    match k {
        0 => (x + 1.0) * 0.5,
        _ => (values[k + 1] - values[k - 1]) * 0.5,
    }
}

#[cfg(test)]
#[allow(clippy::unwrap_used)]
mod tests {
    use super::*;

    #[test]
    fn coefficients_are_correctly_rounded() {
        // From the same formulas with 60 digits.
        let row = |s: usize, i: usize| {
            Tableau::gauss(s).map(|t| t.rows().nth(i).map_or(vec![], <[f64]>::to_vec))
        };
        assert_eq!(row(2, 0), Ok(vec![0.25, -0.038_675_134_594_812_88]));
        assert_eq!(
            row(3, 0),
            Ok(vec![0.138_888_888_888_888_9, -0.035_976_667_524_938_9, 0.009_789_444_015_308_325])
        );
        assert_eq!(
            row(8, 0),
            Ok(vec![
                0.025_307_134_072_594_065,
                -0.009_105_943_305_970_076,
                0.006_280_831_147_030_474,
                -0.004_483_015_613_054_752,
                0.003_078_491_368_326_779_7,
                -0.001_917_675_254_636_952_3,
                0.000_972_757_664_059_263_5,
                -0.000_277_508_327_116_919_2,
            ])
        );
        assert_eq!(Tableau::gauss(3).map(|t| t.weights()[0]), Ok(5.0 / 18.0));
    }

    #[test]
    fn low_parts_restore_symplecticity_beyond_a_double() {
        let square = |x: (f64, f64)| TwoFloat::from(x.0) + x.1;
        let gauss = Tableau::gauss(6).unwrap();
        let a = |i: usize, j: usize| square((gauss.row(i)[j], gauss.row_low(i)[j]));
        let b = |i: usize| square((gauss.weights()[i], gauss.weights_low()[i]));
        for (i, j) in (0..36).map(|n| (n / 6, n % 6)) {
            let defect = b(i) * a(i, j) + b(j) * a(j, i) - b(i) * b(j);
            assert!(f64::from(defect).abs() < 1e-30, "{i} {j} {:e}", f64::from(defect));
        }
    }

    #[test]
    fn gauss_methods_are_symplectic_and_symmetric() {
        for s in 1..=16 {
            let gauss = Tableau::gauss(s);
            assert_eq!(gauss.map(|t| (t.is_symplectic(), t.is_symmetric())), Ok((true, true)));
        }
        assert_eq!(Tableau::gauss(0), Err(SchemeError::NoStages));
    }
}
