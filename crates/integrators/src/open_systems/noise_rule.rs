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
    /// probability, and half a step of the drift. The weak order is 2 if the fields of the noise are
    /// [constant](lie_poisson::Noise::is_constant) and the scheme has order 2, as the midpoint rule has: the fields act for times of the
    /// size √h, and the flow of one that is constant is exact. Other fields are made by the scheme, which then needs the order 4 for
    /// the weak order 2; the midpoint rule leaves the weak order 1.
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
    #[cfg_attr(optimised, inline(always))]
    pub(super) fn parts<T: Real>(
        self,
        increments: &[T],
        step: f64,
        mut part: impl FnMut(NoisePart<'_, T>) -> Result<usize, StepError>,
    ) -> Result<usize, StepError> {
        let fields = self.fields(increments.len());
        let parts = match self {
            Self::Together => 1,
            Self::Alternating => fields + 2,
        };
        let mut weights: SmallVec<[T; MOST_FIELDS]> = smallvec![T::zero(); fields];
        let mut iterations = 0;
        // In wide registers the field has to be called at one place, to be inlined there.
        for number in 0..parts {
            let (drift, size) = match self {
                Self::Together => (1.0, step),
                Self::Alternating if number == 0 || number > fields => (1.0, 0.5 * step),
                Self::Alternating => (0.0, step),
            };
            let used = self.write_weights(number, increments, step, &mut weights);
            let weights = weights.get(..used).unwrap_or_default();
            iterations += part(NoisePart { drift, weights, step: size })?;
        }
        Ok(iterations)
    }

    /// Returns the number of fields of noise with so many components.
    const fn fields(self, components: usize) -> usize {
        match self {
            Self::Together => components,
            Self::Alternating => components.saturating_sub(1),
        }
    }

    /// Writes the weights of the fields in a part of a step. Returns how many there are, 0 if all are 0.
    #[cfg_attr(optimised, inline(always))]
    fn write_weights<T: Real>(
        self,
        number: usize,
        increments: &[T],
        step: f64,
        weights: &mut [T],
    ) -> usize {
        let fields = weights.len();
        // In a step of size 0 there is no noise.
        let reciprocal = if step == 0.0 { 0.0 } else { step.recip() };
        match (self, increments.split_last()) {
            (Self::Together, _) => {
                for (weight, increment) in weights.iter_mut().zip(increments) {
                    *weight = *increment * reciprocal;
                }
                fields
            }
            (Self::Alternating, Some((coin, increments))) if (1..=fields).contains(&number) => {
                let (none, k, reversed) = (T::zero(), number - 1, fields - number);
                weights.fill(none);
                // Lanes may go through the fields in different orders.
                weights[k] = coin.select_nonnegative(increments[k], none) * reciprocal;
                weights[reversed] = match k == reversed {
                    true => increments[k] * reciprocal,
                    false => coin.select_nonnegative(none, increments[reversed]) * reciprocal,
                };
                fields
            }
            (Self::Alternating, _) => 0,
        }
    }
}
