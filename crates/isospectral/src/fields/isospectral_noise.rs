//! Noise that conserves the spectrum of a matrix: [`IsospectralNoise`].

use crate::matrices::skew_hermitian::LargeSkewHermitian;
use lie_poisson::State;

/// Noise Σ_k [Ξ_k, W] ∘ dW_k of an [isospectral equation](crate::IsospectralField), with constant generators Ξ_k ∈
/// u(N).
///
/// A Brownian motion W_k has the unit √t, so that Ξ_k has the unit 1/√t. A vector of matrices is the noise that has
/// them as generators.
///
/// Source: Arnaudon, de Castro & Holm, *Noise and dissipation on coadjoint orbits*, J. Nonlinear Sci. 28 (2018).
///
/// # Example
/// See [`NoisyIsospectral`](crate::NoisyIsospectral).
pub trait IsospectralNoise {
    /// Returns the number of generators.
    fn count(&self) -> usize;

    /// Adds Σ_k w_k Ξ_k to a matrix, for as many weights as there are generators. The result is NaN if the matrix does
    /// not have the size of the generators.
    fn add_to(&self, weights: &[f64], generator: &mut LargeSkewHermitian);

    /// Returns λ if the noise is isotropic, Ξ_k = σ E_k with E_k orthonormal in u(N), or in su(N), for a multiple of the scalar
    /// product −tr(V W); none by default. It is the number, in the unit 1/t, with
    ///
    /// ```text
    /// Σ_k [Ξ_k, [Ξ_k, V]] = −λ V    for all V without trace,
    /// ```
    ///
    /// so that the mean of noise alone decays as exp(−λt/2). [Noise that alternates](crate::IsotropicIsospectralNoise#one-exponential) is
    /// then made by one exponential. Noise that only fulfils this equation is not isotropic if it lacks directions.
    fn isotropic_casimir(&self) -> Option<f64> {
        None
    }
}

impl IsospectralNoise for Vec<LargeSkewHermitian> {
    fn count(&self) -> usize {
        self.len()
    }

    fn add_to(&self, weights: &[f64], generator: &mut LargeSkewHermitian) {
        for (weight, xi) in weights.iter().zip(self) {
            match xi.size() == generator.size() {
                true => generator.add_multiple(*weight, xi),
                false => return generator.scale_in_place(f64::NAN),
            }
        }
    }
}

impl<N: IsospectralNoise + ?Sized> IsospectralNoise for &N {
    fn count(&self) -> usize {
        (**self).count()
    }

    fn add_to(&self, weights: &[f64], generator: &mut LargeSkewHermitian) {
        (**self).add_to(weights, generator);
    }

    fn isotropic_casimir(&self) -> Option<f64> {
        (**self).isotropic_casimir()
    }
}
