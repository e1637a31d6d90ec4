//! Equations that conserve the spectrum of a matrix: [`IsospectralField`].

use crate::matrices::products::Products;
use crate::matrices::skew_hermitian::LargeSkewHermitian;
use lie_poisson::State;

/// An isospectral equation for W ∈ u(N), with N known when the program runs:
///
/// ```text
/// dW/dt = [B(W), W] = B W − W B,    B(W) ∈ u(N)
/// ```
///
/// W stays on its orbit under conjugation by unitary matrices, so its eigenvalues do not change. If B = −dh with
/// respect to the scalar product ⟨V, W⟩ = −tr(V W), these are the Lie–Poisson equations dW/dt = `ad*_dh W` of h on
/// u(N)∗ with the minus bracket, and with B = dh those of the plus bracket. The eigenvalues are Casimirs.
///
/// Source: Modin & Viviani, *Lie–Poisson methods for isospectral flows*, Found. Comput. Math. 20 (2020).
///
/// # Example
/// Manakov's rigid body on so(N)∗, with M real and B = −Ω, Ω_jk = M_jk/(J_j + J_k):
/// ```
/// use isospectral_flows::{IsospectralField, LargeSkewHermitian};
/// use num_complex::Complex;
/// struct RigidBody(Vec<f64>);
/// impl IsospectralField for RigidBody {
///     fn size(&self) -> usize {
///         self.0.len()
///     }
///     fn generator_into(&self, m: &LargeSkewHermitian, b: &mut LargeSkewHermitian) {
///         b.change_upper(|re, im| {
///             let n = self.0.len();
///             im.fill(0.0);
///             for (i, entry) in re.iter_mut().enumerate() {
///                 let (j, k) = (i % n, i / n);
///                 *entry = -m.at(j, k).re / (self.0[j] + self.0[k]);
///             }
///         });
///     }
/// }
/// let body = RigidBody(vec![1.0, 2.0, 3.0]);
/// let m = LargeSkewHermitian::from_upper(3, |j, k| Complex::new((j + 2 * k) as f64, 0.0));
/// let rate = body.rate(&m);
/// // tr M² is conserved
/// assert!(rate.scalar_product(&m).abs() < 1e-14);
/// ```
pub trait IsospectralField {
    /// Returns the size N.
    fn size(&self) -> usize;

    /// Writes the generator B(W). The matrix `generator` has the size N, and its previous entries are arbitrary.
    fn generator_into(&self, w: &LargeSkewHermitian, generator: &mut LargeSkewHermitian);

    /// Returns the rate dW/dt = [B(W), W].
    fn rate(&self, w: &LargeSkewHermitian) -> LargeSkewHermitian {
        let (mut generator, mut rate) = (w.zeros_like(), w.zeros_like());
        self.generator_into(w, &mut generator);
        Products::default().commutator(&generator, w, &mut rate);
        rate
    }
}

impl<F: IsospectralField + ?Sized> IsospectralField for &F {
    fn size(&self) -> usize {
        (**self).size()
    }

    fn generator_into(&self, w: &LargeSkewHermitian, generator: &mut LargeSkewHermitian) {
        (**self).generator_into(w, generator);
    }
}
