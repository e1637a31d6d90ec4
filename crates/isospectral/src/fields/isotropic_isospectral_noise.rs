//! Noise in all directions of u(N): [`IsotropicIsospectralNoise`].

use crate::fields::isospectral_noise::IsospectralNoise;
use crate::matrices::skew_hermitian::LargeSkewHermitian;
use lie_poisson::{DissipationError, State, thermal_strength};

/// Noise that is the same in all directions of u(N): Ξ_k = σ E_k with N² matrices E_k that are orthonormal for ⟨V, W⟩ = −tr(V W).
///
/// With the [double bracket](crate::IsospectralDoubleBracket) of friction θ and σ² = 2θkT it is Langevin's dynamics at the temperature T:
/// the invariant measure on each orbit is exp(−h/kT) times the uniform one.
///
/// # One exponential
/// With the rule [`Alternating`](collective_integrators::NoiseRule::Alternating) a step of the size h > 0 of
/// [`NoisyIsospectral`](crate::NoisyIsospectral) is half a step of the drift,
///
/// ```text
/// W ↦ exp(Ω) W exp(−Ω),    Ω = c Σ_k ΔW_k Ξ_k,    c² = 1/(1 + λh/24),    λ = 2Nσ²,
/// ```
///
/// and half a step of the drift. The factor c makes the weak order 2; the strong order is ½, as without it. For let `X_k` be the
/// fields [E_k, ·] and Δ = Σ `X_k`². The exact law of the noise alone is exp(½ s Δ) with s = σ²h. The scalar product is invariant under
/// conjugation, so that Δ commutes with each `X_k`, and the structure constants are antisymmetric. They have Σ_ik `c_jik` `c_lik` =
/// 2N δ_jl on su(N), and the centre has the field 0, so that Σ_ij `X_i X_j X_i X_j` = Δ² + N Δ. Two of the three pairings of
/// the fourth moment of normal numbers give Δ² and one gives this sum: functions of W have the mean
///
/// ```text
/// 1 + ½ c²s Δ + c⁴s²/24 (3Δ² + N Δ) + O(s³) = exp(½ s Δ) + O(s³)    if c² = 1 − Ns/12 + O(s²).
/// ```
///
/// The same holds for each compact group with an inner product that is invariant under the adjoint action, with the Casimir C of the
/// adjoint representation in place of 2N: c² = 1/(1 + Cs/24), C = 2 for rotations. Noise without some directions has no such c.
///
/// Besides the symmetry of the increments this needs their second and fourth moments to O(h³). Bounds keep them: √(2ℓ |ln h|)
/// standard deviations change both by parts of the size hˡ, so that ℓ = 2 is enough, and 6 by the parts 4e-9 and 1e-7, at every h.
///
/// # Example
/// ```
/// use isospectral_flows::{IsospectralNoise, IsotropicIsospectralNoise, LargeSkewHermitian};
/// let noise = IsotropicIsospectralNoise::thermal(3, (0.5, 2.0))?;
/// let unit = |k: usize| {
///     let mut xi = LargeSkewHermitian::zeros(3);
///     noise.add_to(&(0..9).map(|i| f64::from(u8::from(i == k))).collect::<Vec<f64>>(), &mut xi);
///     xi
/// };
/// for (k, l) in (0..9).flat_map(|k| (0..9).map(move |l| (k, l))) {
///     let expected = if k == l { 2.0 } else { 0.0 }; // σ² = 2θkT
///     assert!((unit(k).scalar_product(&unit(l)) - expected).abs() < 1e-15);
/// }
/// # Ok::<(), lie_poisson::DissipationError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct IsotropicIsospectralNoise {
    /// The size N.
    pub size: usize,
    /// The strength σ.
    pub strength: f64,
}

impl IsotropicIsospectralNoise {
    /// Returns the noise of a temperature, σ = √(2θkT) with the friction θ and the energy kT. Both must be 0 or positive.
    ///
    /// # Errors
    /// Returns [`DissipationError`] for a negative friction or temperature, or one that is no finite number.
    pub fn thermal(
        size: usize,
        (friction, temperature): (f64, f64),
    ) -> Result<Self, DissipationError> {
        DissipationError::require_friction(friction)?;
        DissipationError::require_temperature(temperature)?;
        Ok(Self { size, strength: thermal_strength(friction, temperature) })
    }
}

impl IsospectralNoise for IsotropicIsospectralNoise {
    fn count(&self) -> usize {
        self.size.saturating_mul(self.size)
    }

    fn add_to(&self, weights: &[f64], generator: &mut LargeSkewHermitian) {
        let n = self.size;
        if generator.size() != n || weights.len() != self.count() {
            return generator.scale_in_place(f64::NAN);
        }
        // A matrix with an entry off the diagonal has a second one.
        let (diagonal, off) = (self.strength, self.strength * 0.5_f64.sqrt());
        generator.change_upper(|re, im| {
            for (k, j) in (0..n).flat_map(|k| (0..=k).map(move |j| (k, j))) {
                let (above, below) = (j + n * k, k + n * j);
                if j == k {
                    im[above] += diagonal * weights[above];
                } else {
                    im[above] += off * weights[above];
                    re[above] += off * weights[below];
                }
            }
        });
    }

    /// Returns λ = 2Nσ²: for −tr(V W) the Casimir of the adjoint representation is 2N on su(N), and the centre acts trivially.
    fn isotropic_casimir(&self) -> Option<f64> {
        Some(2.0 * self.size as f64 * self.strength * self.strength)
    }
}
