//! Noise in spherical harmonics: [`HarmonicNoise`].

use crate::error::{SystemError, require_not_negative, require_within};
use crate::matrix_hydrodynamics::quantised_laplacian::QuantisedLaplacian;
use crate::matrix_hydrodynamics::zeitlin::Zeitlin;
use isospectral_flows::{IsospectralNoise, LargeSkewHermitian};
use std::f64::consts::{FRAC_1_SQRT_2, PI};

/// A noise Σ_k ξ_k dW_k in chosen spherical harmonics, with functions ξ_k = σ_k Y_k of the real orthonormal harmonics
///
/// ```text
/// Y_l0,    √2 Re Y_lm,    −√2 Im Y_lm,    m = 1 … l
/// ```
///
/// and independent Brownian motions W_k, in this order for each harmonic in the order in which they were added.
///
/// Its functions are one of two things:
///
/// * stream functions, of noise that carries a fluid along, dW = [P, W]/ħ dt + Σ_k \[ξ_k, W]/ħ ∘ dW_k: transport noise.
///   The strengths σ have the unit 1/√t. The noise is an [`IsospectralNoise`] with the generators ξ_k/ħ, so that each
///   path keeps all Casimirs;
/// * rates of vorticity, dω = Σ_k ξ_k dW_k: a force that is white in time. The strengths σ have the unit 1/(t√t).
///
/// Sources: Holm, *Variational principles for stochastic fluid dynamics*, Proc. R. Soc. A 471 (2015); Ephrati, Cifani,
/// Viviani & Geurts, Phys. Fluids 35 (2023).
///
/// # Example
/// ```
/// use lie_poisson_systems::prelude::*;
/// use std::f64::consts::PI;
/// // All harmonics of degree 2 and 3: 5 + 7 Brownian motions.
/// let noise = HarmonicNoise::none(&Zeitlin::new(16)?).with_shell([2, 3], 0.1)?;
/// assert_eq!(noise.count(), 12);
/// let expected = 0.01 * (2.0 * 3.0 * 5.0 + 3.0 * 4.0 * 7.0) / (16.0 * PI);
/// assert!((noise.eddy_viscosity() - expected).abs() < 1e-16);
/// # Ok::<(), SystemError>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct HarmonicNoise {
    laplacian: QuantisedLaplacian,
    planck_constant: f64,
    terms: Vec<Term>,
}

/// The one or two real harmonics of a degree l and an order m ≥ 0.
#[derive(Clone, Debug, PartialEq)]
struct Term {
    l: usize,
    m: usize,
    strength: f64,
    /// The entries of T_lm beside the diagonal number m.
    entries: Vec<f64>,
}

impl Term {
    /// Returns the number of real harmonics.
    const fn count(&self) -> usize {
        if self.m == 0 { 1 } else { 2 }
    }

    /// Returns l(l + 1).
    fn eigenvalue(&self) -> f64 {
        (self.l * (self.l + 1)) as f64
    }
}

impl HarmonicNoise {
    /// Creates the noise of no harmonics, for a fluid.
    #[must_use]
    pub fn none(fluid: &Zeitlin) -> Self {
        let (laplacian, planck_constant) = (fluid.laplacian().clone(), fluid.planck_constant());
        Self { laplacian, planck_constant, terms: Vec::new() }
    }

    /// Returns this and noise of the strength σ in the harmonics of degree l and order ±m, m ≥ 0.
    ///
    /// # Errors
    /// Returns [`SystemError::OutOfRange`] for a degree that is not 1 … N − 1 or an order that is not 0 … l, and
    /// [`SystemError::NotFinite`] or [`SystemError::Negative`] for a strength that is not finite or is negative.
    pub fn with_harmonic(mut self, l: usize, m: usize, strength: f64) -> Result<Self, SystemError> {
        let highest = self.laplacian.size() as f64 - 1.0;
        require_within("the degree of noise", l as f64, [1.0, highest])?;
        require_within("the order of noise", m as f64, [0.0, l as f64])?;
        require_not_negative("the strength of noise", strength)?;
        let entries = self.laplacian.harmonic(l, m);
        self.terms.push(Term { l, m, strength, entries });
        Ok(self)
    }

    /// Returns this and noise of the strength σ in all harmonics of the degrees from the least to the largest one:
    /// isotropic noise.
    ///
    /// # Errors
    /// Those of [`with_harmonic`](Self::with_harmonic), and [`SystemError::OutOfRange`] if the least degree is above
    /// the largest.
    pub fn with_shell(self, [least, most]: [usize; 2], strength: f64) -> Result<Self, SystemError> {
        let highest = self.laplacian.size() as f64 - 1.0;
        require_within("the largest degree of noise", most as f64, [1.0, highest])?;
        require_within("the least degree of noise", least as f64, [1.0, most as f64])?;
        let mut orders = (least..=most).flat_map(|l| (0..=l).map(move |m| (l, m)));
        orders.try_fold(self, |noise, (l, m)| noise.with_harmonic(l, m, strength))
    }

    /// Returns the size N of the matrices.
    #[must_use]
    pub fn size(&self) -> usize {
        self.laplacian.size()
    }

    /// Returns the number of Brownian motions.
    #[must_use]
    pub fn count(&self) -> usize {
        self.terms.iter().map(Term::count).sum()
    }

    /// Returns the viscosity κ that isotropic transport noise gives to the mean vorticity on scales much larger than
    /// its own, and at every N to the mean angular momentum, which decays as exp(−2κt):
    ///
    /// ```text
    /// κ = Σ_l σ_l² l(l + 1)(2l + 1)/16π
    /// ```
    ///
    /// It is a quarter of the mean of |u|² dt for the velocity u of the noise. Noise of degree 1 is a random rotation
    /// of the sphere, for which the mean of every degree decays as exp(−κ l(l + 1) t).
    #[must_use]
    pub fn eddy_viscosity(&self) -> f64 {
        self.sum(|term| term.eigenvalue() / (16.0 * PI))
    }

    /// Returns Σ_l σ_l² (l(l + 1))² (2l + 1)/4π, the mean of |Δξ|² in a unit of time: in a step h transport noise displaces
    /// a fluid as does a flow whose vorticity times h has the mean square of this times h.
    #[must_use]
    pub fn vorticity_variance(&self) -> f64 {
        self.sum(|term| term.eigenvalue() * term.eigenvalue() / (4.0 * PI))
    }

    /// Returns Σ_l (2l + 1) σ_l², the mean rate of the [enstrophy](Zeitlin::enstrophy) by a force that is white in
    /// time.
    #[must_use]
    pub fn enstrophy_injection(&self) -> f64 {
        self.sum(|_| 1.0)
    }

    /// Returns Σ_l (2l + 1) σ_l²/(2l(l + 1)), the mean rate of the [energy](Zeitlin::energy) by a force that is white
    /// in time.
    #[must_use]
    pub fn energy_injection(&self) -> f64 {
        self.sum(|term| 0.5 / term.eigenvalue())
    }

    /// Returns Σ_k σ_k² c_k.
    fn sum(&self, weight: impl Fn(&Term) -> f64) -> f64 {
        let of = |term: &Term| term.count() as f64 * term.strength * term.strength * weight(term);
        self.terms.iter().map(of).sum()
    }

    /// Adds the matrix of Σ_k c_l w_k ξ_k, with a factor c_l for each degree. The result is NaN if the matrix has
    /// another size.
    pub(crate) fn add_functions(
        &self,
        mut weights: &[f64],
        factor: impl Fn(usize) -> f64,
        w: &mut LargeSkewHermitian,
    ) {
        let n = self.laplacian.size();
        let fits = w.size() == n;
        w.change_upper(|re, im| {
            if !fits {
                return re.fill(f64::NAN);
            }
            for term in &self.terms {
                let scale = factor(term.l) * term.strength;
                // The function Σ_m ω_lm Y_lm has the matrix i Σ_m ω_lm T_lm.
                let (cosine, sine) = match (term.m, weights) {
                    (0, [w, ..]) => (*w, 0.0),
                    (_, [c, s, ..]) => (c * FRAC_1_SQRT_2, s * FRAC_1_SQRT_2),
                    _ => return,
                };
                weights = weights.get(term.count()..).unwrap_or_default();
                for (j, t) in term.entries.iter().enumerate() {
                    let place = j + n * (j + term.m);
                    re[place] -= scale * sine * t;
                    im[place] += scale * cosine * t;
                }
            }
        });
    }
}

impl IsospectralNoise for HarmonicNoise {
    fn count(&self) -> usize {
        self.count()
    }

    /// Adds Σ_k w_k ξ_k/ħ.
    fn add_to(&self, weights: &[f64], generator: &mut LargeSkewHermitian) {
        self.add_functions(weights, |_| 1.0 / self.planck_constant, generator);
    }
}
