//! The exponential midpoint rule on u(N)∗: [`ExponentialMidpoint`].

use crate::fields::isospectral_field::IsospectralField;
use crate::matrices::large_matrix::LargeMatrix;
use crate::matrices::products::Products;
use crate::matrices::skew_hermitian::LargeSkewHermitian;
use crate::methods::generator_history::GeneratorHistory;
use crate::methods::generator_sweeps::Sweeps;
use collective_integrators::{Integrator, StateIsMomentum, Step, StepError};
use lie_poisson::State;

/// The exponential midpoint rule for [isospectral equations](IsospectralField): a symmetric Poisson map of order 2.
///
/// The generator is that of the mean of W over the step, and constant in the step:
///
/// ```text
/// B = B( Σ_k ad_hB^k W₀/(k + 1)! ),    W₁ = exp(hB) W₀ exp(−hB),    ad_B W = [B, W]
/// ```
///
/// It is the variational integrator with the discrete Lagrangian h ℓ(log(g₁ g₀⁻¹)/h), where ℓ is the Legendre transform
/// of the Hamiltonian, and therefore a Poisson map if B = ±dh. Since W₀ is conjugated by an exponential, the error does
/// not grow with the spectral radius of h B by itself. A sweep costs one product for each term of the series. Orders
/// above 2 are reached by [`Composition`](collective_integrators::Composition), which is a Poisson map as well.
///
/// Source: Bou-Rabee & Marsden, *Hamilton–Pontryagin integrators on Lie groups*, Found. Comput. Math. 9 (2009), with
/// the exponential as the retraction.
///
/// # Example
/// See [`IsospectralField`] for an equation; the integrator is `ExponentialMidpoint::new(equation)`.
#[derive(Clone, Debug, PartialEq)]
pub struct ExponentialMidpoint<F> {
    field: F,
    tolerance: f64,
}

impl<F: IsospectralField> ExponentialMidpoint<F> {
    /// Creates the integrator. It solves for B to round-off.
    pub fn new(field: F) -> Self {
        Self { field, tolerance: 0.0 }
    }

    /// Returns the integrator with another accuracy of B: the largest accepted h |δB| in the last sweep.
    ///
    /// The spectrum of W is conserved to round-off in any case. The map is Poisson to this accuracy.
    #[must_use]
    pub fn with_tolerance(self, tolerance: f64) -> Self {
        Self { tolerance, ..self }
    }

    /// Returns the equation.
    pub fn field(&self) -> &F {
        &self.field
    }
}

/// The storage of a step of [`ExponentialMidpoint`].
#[derive(Clone, Debug)]
pub struct ExponentialSpace {
    products: Products,
    generator: [LargeSkewHermitian; 1],
    fresh: [LargeSkewHermitian; 1],
    terms: [LargeSkewHermitian; 2],
    mean: LargeSkewHermitian,
    next: LargeSkewHermitian,
    rotation: LargeMatrix,
    history: GeneratorHistory,
}

impl ExponentialSpace {
    /// Writes Σ_k ad_hB^k W/(k + 1)! to the mean, to the given relative accuracy.
    fn set_mean(&mut self, w: &LargeSkewHermitian, step: f64, accuracy: f64) {
        let Self { products, generator: [generator], terms: [term, next], mean, .. } = self;
        mean.assign(w);
        term.assign(w);
        let enough = accuracy * largest(w);
        for k in 1..MOST_TERMS {
            products.commutator(generator, term, next);
            next.scale_in_place(step / (k + 1) as f64);
            mean.add_in_place(next);
            core::mem::swap(term, next);
            let size = largest(term);
            // A NaN ends the series, and the sweeps after it.
            if size.is_nan() || size <= enough {
                break;
            }
        }
    }
}

/// The number of terms of a series after which a step is far too large.
const MOST_TERMS: usize = 60;

/// The accuracy of the mean as a multiple of the last change of B: the error of the series must not be what the next
/// sweep removes.
const AHEAD: f64 = 0.01;

/// Returns the largest magnitude of a coordinate, or NaN.
fn largest(w: &LargeSkewHermitian) -> f64 {
    let (mut largest, mut sum) = ((0.0,), 0.0);
    w.measure(&mut largest, &mut sum);
    if sum.is_nan() { sum } else { largest.0 }
}

impl<F: IsospectralField> Integrator for ExponentialMidpoint<F> {
    type State = LargeSkewHermitian;
    type Momentum = LargeSkewHermitian;
    type Workspace = ExponentialSpace;

    fn workspace(&self) -> ExponentialSpace {
        let zero = || LargeSkewHermitian::zeros(self.field.size());
        ExponentialSpace {
            products: Products::default(),
            generator: [zero()],
            fresh: [zero()],
            terms: [zero(), zero()],
            mean: zero(),
            next: zero(),
            rotation: LargeMatrix::zeros(self.field.size()),
            history: GeneratorHistory::new(&[0.5], 3),
        }
    }

    fn forget(&self, workspace: &mut ExponentialSpace) {
        workspace.history.forget();
    }

    fn step(
        &self,
        w: &LargeSkewHermitian,
        step: f64,
        workspace: &mut ExponentialSpace,
    ) -> Result<Step<LargeSkewHermitian>, StepError> {
        let mut point = w.clone();
        let iterations = self.step_in_place(&mut point, step, workspace)?;
        Ok(Step { point, iterations })
    }

    fn step_in_place(
        &self,
        w: &mut LargeSkewHermitian,
        step: f64,
        workspace: &mut ExponentialSpace,
    ) -> Result<usize, StepError> {
        StepError::check_dimension(w, self.field.size().saturating_pow(2))?;
        let space = workspace;
        if !space.history.predict(w, step, &mut space.generator) {
            self.field.generator_into(w, &mut space.generator[0]);
        }
        let mut sweeps = Sweeps::new(self.tolerance, step);
        loop {
            let accuracy = (AHEAD * sweeps.relative_change()).clamp(f64::EPSILON / 4.0, 1e-4);
            space.set_mean(w, step, accuracy);
            self.field.generator_into(&space.mean, &mut space.fresh[0]);
            let last = sweeps.converged(&space.fresh, &space.generator)?;
            core::mem::swap(&mut space.generator, &mut space.fresh);
            if last {
                break;
            }
        }
        let ExponentialSpace {
            products,
            generator,
            terms: [scaled, _],
            next,
            rotation,
            history,
            ..
        } = space;
        scaled.assign(&generator[0]);
        scaled.scale_in_place(step);
        products.exponential_minus_one(scaled, rotation);
        products.conjugate(rotation, w, next);
        if !next.all_finite() {
            return Err(StepError::NotFinite);
        }
        w.move_from(next);
        history.remember(generator, step, w);
        Ok(sweeps.made)
    }

    fn momentum(&self, w: &LargeSkewHermitian) -> LargeSkewHermitian {
        w.clone()
    }
}

impl<F> StateIsMomentum for ExponentialMidpoint<F> {}
