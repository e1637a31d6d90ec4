//! The exponential of a skew-Hermitian matrix.

use crate::matrices::large_matrix::LargeMatrix;
use crate::matrices::products::Products;
use crate::matrices::skew_hermitian::LargeSkewHermitian;
use lie_poisson::State;
use num_complex::Complex;

/// The number of powers of A = Ω² that are computed. Polynomials in A are evaluated in the power A³.
const POWERS: usize = 3;

/// Bounds on the spectral radius ρ of Ω, with the number of groups of three terms that reach round-off below it.
///
/// With q = 3 groups − 1, the first neglected term is Ω²ᑫ⁺³/(2q + 3)!, and ρ²ᑫ⁺²/(2q + 3)! ≤ ε/2, ε = 2⁻⁵².
const GROUPS: [(f64, usize); 5] = [(0.009, 1), (0.3, 2), (1.15, 3), (2.4, 4), (3.9, 5)];

impl Products {
    /// Writes Z = exp(Ω) − 1 for a skew-Hermitian Ω. 1 + Z is unitary to N ε max(1, ρ), where ρ is the spectral radius.
    ///
    /// The Taylor polynomial is split into its even and its odd part, both polynomials in the Hermitian matrix A = Ω²:
    ///
    /// ```text
    /// exp(Ω) − 1 = A C(A) + Ω S(A),    C(A) = Σ Aᵏ/(2k + 2)!,    S(A) = Σ Aᵏ/(2k + 1)!
    /// ```
    ///
    /// They are evaluated by the method of Paterson and Stockmeyer with the powers A, A² and A³. All products but Ω S
    /// are Hermitian and cost half of a product. A matrix with a spectral radius above 3.9 is first divided by a power
    /// of two, and the result is squared as often.
    ///
    /// The result is NaN if Ω or its square is not finite, or if ρ is above 10⁹.
    ///
    /// Source: Higham, *Functions of Matrices* (SIAM 2008), §4.2 and §10.3.
    ///
    /// # Example
    /// ```
    /// use isospectral_flows::{LargeMatrix, LargeSkewHermitian, Products};
    /// use num_complex::Complex;
    /// let omega = LargeSkewHermitian::from_upper(2, |j, k| Complex::new(if j == k { 0.0 } else { 0.3 }, 0.0));
    /// let mut z = LargeMatrix::zeros(2);
    /// Products::default().exponential_minus_one(&omega, &mut z);
    /// assert!((z.at(0, 1).re - 0.3_f64.sin()).abs() < 1e-16);
    /// assert!((z.at(1, 1).re - (0.3_f64.cos() - 1.0)).abs() < 1e-16);
    /// ```
    pub fn exponential_minus_one(&mut self, omega: &LargeSkewHermitian, z: &mut LargeMatrix) {
        let like = omega.matrix();
        let mut powers = [(); POWERS].map(|()| self.take(like));
        let mut scaled = self.take(like);
        scaled.assign(like);
        self.multiply_hermitian(like, like, &mut powers[0]);
        let radius = powers[0].column_norm().sqrt();
        let halvings = halvings(radius);
        if halvings > MOST_HALVINGS {
            // After so many rounding errors no digit of the angles is left.
            z.set_coordinates(|_| f64::NAN);
            return powers.into_iter().chain([scaled]).for_each(|temporary| self.give(temporary));
        }
        if halvings > 0 {
            let scale = 0.5_f64.powi(halvings);
            scaled.scale_in_place(scale);
            powers[0].scale_in_place(scale * scale);
        }
        let radius = radius * 0.5_f64.powi(halvings);
        let groups =
            GROUPS.iter().find(|(most, _)| radius <= *most).map_or(5, |(_, groups)| *groups);
        let [first, second, third] = &mut powers;
        self.multiply_hermitian(first, first, second);
        if groups > 1 {
            self.multiply_hermitian(second, first, third);
        }
        let [mut even, mut odd] = [(); 2].map(|()| self.take(like));
        self.polynomial(&powers, groups, 2, &mut even);
        self.polynomial(&powers, groups, 1, &mut odd);
        self.multiply(&scaled, &odd, z);
        self.multiply_hermitian(&powers[0], &even, &mut odd);
        z.add_in_place(&odd);
        for _ in 0..halvings {
            // (1 + Z)² − 1 = 2Z + Z²
            self.multiply(z, z, &mut odd);
            z.scale_in_place(2.0);
            z.add_in_place(&odd);
        }
        powers.into_iter().chain([scaled, even, odd]).for_each(|temporary| self.give(temporary));
    }

    /// Writes Σ_k Aᵏ/(2k + `first`)! with three terms in each group, by Horner's rule in A³.
    fn polynomial(
        &mut self,
        powers: &[LargeMatrix; POWERS],
        groups: usize,
        first: usize,
        sum: &mut LargeMatrix,
    ) {
        let mut product = self.take(&powers[0]);
        sum.set_zero();
        for group in (0..groups).rev() {
            if group + 1 < groups {
                self.multiply_hermitian(&powers[2], sum, &mut product);
                core::mem::swap(sum, &mut product);
            }
            let [one, linear, square] =
                [0, 1, 2].map(|term| inverse_factorial(2 * (3 * group + term) + first));
            for j in 0..sum.size() {
                sum.set(j, j, sum.at(j, j) + Complex::new(one, 0.0));
            }
            sum.add_combination(&[linear, square], &powers[..2]);
        }
        self.give(product);
    }
}

/// The number of halvings above which no digit of the angles is left.
const MOST_HALVINGS: i32 = 28;

/// Returns the number of times by which a matrix of the given spectral radius is halved.
fn halvings(radius: f64) -> i32 {
    let (most, _) = GROUPS[GROUPS.len() - 1];
    // If a matrix is not finite, none of its powers is finite, and neither is the result.
    if radius <= most || !radius.is_finite() { 0 } else { (radius / most).log2().ceil() as i32 }
}

fn inverse_factorial(n: usize) -> f64 {
    1.0 / (1..=n).map(|k| k as f64).product::<f64>()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn bounds_of_the_radius_reach_round_off() {
        for (radius, groups) in GROUPS {
            let neglected = 6 * groups + 1;
            let size = radius.powi(neglected as i32 - 1) * inverse_factorial(neglected);
            assert!(size <= 0.5 * f64::EPSILON && size > 0.005 * f64::EPSILON, "{radius} {size:e}");
        }
    }
}
