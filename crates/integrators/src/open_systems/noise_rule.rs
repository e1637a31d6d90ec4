//! How noise enters a step: [`NoiseRule`].

use crate::error::StepError;
use lie_poisson::Real;
use smallvec::{SmallVec, smallvec};

/// The number of fields of a noise up to which a step allocates nothing.
pub(super) const MOST_FIELDS: usize = 16;

/// How noise enters a step of a motion dz = X(z, t) dt + Σ_k `Y_k`(z, t) ∘ dW_k, in Stratonovich's sense, that a scheme makes.
///
/// Source of the second: Ninomiya & Victoir, *Weak approximation of stochastic differential equations and application to
/// derivative pricing*, Appl. Math. Finance 15 (2008).
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum NoiseRule {
    /// One step of the scheme with the field X + Σ_k (ΔW_k/h) `Y_k`; with the midpoint rule, the stochastic midpoint rule of
    /// Milstein, Repin & Tretyakov. The weak order is 1 and the strong order ½, or 1 if the fields of the noise commute.
    #[default]
    Together,
    /// Half a step of the drift X, the fields of the noise one after the other, in this order or the reverse one with equal
    /// probability, and half a step of the drift. The weak order is 2 if that of the scheme is 4 or more: the fields of the noise act
    /// for times of the size √h, so that the midpoint rule leaves the weak order 1.
    Alternating,
}

/// A part of a step, in which the field is a X + Σ_k w_k `Y_k`.
#[derive(Clone, Copy, Debug)]
pub struct NoisePart<'a, T> {
    /// The number a.
    pub drift: f64,
    /// The weights w_k; none if all are 0.
    pub weights: &'a [T],
    /// The size of the part.
    pub step: f64,
}

impl NoiseRule {
    /// Returns the number of components of a Brownian path that a step needs for noise with so many fields.
    pub(super) const fn components(self, fields: usize) -> usize {
        match self {
            Self::Together => fields,
            // The sign of the last one is the order of the fields.
            Self::Alternating => fields + 1,
        }
    }

    /// Makes the parts of a step one after the other, and returns the sum of what they return. `increments` are those of the
    /// [components](Self::components) over the step.
    ///
    /// # Errors
    /// That of the part that fails.
    #[inline]
    pub(super) fn parts<T: Real>(
        self,
        increments: &[T],
        step: f64,
        mut part: impl FnMut(NoisePart<'_, T>) -> Result<usize, StepError>,
    ) -> Result<usize, StepError> {
        let rate = |increment: &T| *increment / step;
        match (self, increments.split_last()) {
            (Self::Together, _) => {
                let weights: SmallVec<[T; MOST_FIELDS]> = increments.iter().map(rate).collect();
                part(NoisePart { drift: 1.0, weights: &weights, step })
            }
            (Self::Alternating, None) => part(NoisePart { drift: 1.0, weights: &[], step }),
            (Self::Alternating, Some((coin, increments))) => {
                let half = NoisePart { drift: 1.0, weights: &[], step: 0.5 * step };
                let mut iterations = part(half)?;
                let mut weights: SmallVec<[T; MOST_FIELDS]> =
                    smallvec![T::zero(); increments.len()];
                let pairs = increments.iter().zip(increments.iter().rev()).enumerate();
                for (k, (forward, backward)) in pairs {
                    // Lanes may go through the fields in different orders.
                    let reversed = increments.len() - 1 - k;
                    let none = T::zero();
                    weights[k] = rate(&coin.select_nonnegative(*forward, none));
                    weights[reversed] = match k == reversed {
                        true => rate(forward),
                        false => rate(&coin.select_nonnegative(none, *backward)),
                    };
                    iterations += part(NoisePart { drift: 0.0, weights: &weights, step })?;
                    (weights[k], weights[reversed]) = (none, none);
                }
                Ok(iterations + part(half)?)
            }
        }
    }
}
