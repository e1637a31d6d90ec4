//! The exponential midpoint rule on u(N)∗: [`ExponentialMidpoint`].

use crate::fields::isospectral_field::IsospectralField;
use crate::matrices::products::Products;
use crate::matrices::skew_hermitian::LargeSkewHermitian;
use crate::methods::conjugation::Conjugation;
use crate::methods::generator_history::GeneratorHistory;
use crate::methods::generator_sweeps::Sweeps;
use collective_integrators::{Integrator, StateIsMomentum, Step, StepError};
use lie_poisson::State;

/// The exponential midpoint rule for [isospectral equations](IsospectralField): a symmetric Poisson map of order 2.
///
/// The generator is evaluated at the mean of W over the step, and is constant in the step:
///
/// ```text
/// B = B( Σ_k ad_hB^k W₀/(k + 1)! ),    W₁ = exp(hB) W₀ exp(−hB),    ad_B W = [B, W]
/// ```
///
/// It is the variational integrator with the discrete Lagrangian h ℓ(log(g₁ g₀⁻¹)/h), where ℓ is the Legendre transform
/// of the Hamiltonian, and therefore a Poisson map if B = ±dh. Since W₀ is conjugated by an exponential, the error does
/// not grow with the spectral radius ρ of h B by itself. The series is summed as it stands, so that round-off grows
/// like exp(2ρ): ρ above 5 is of no use, and from about 10 on the step returns an error. A sweep costs one product for
/// each term of the series. Orders above 2 are reached by [`Composition`](collective_integrators::Composition), which
/// is a Poisson map as well.
///
/// Source: Bou-Rabee & Marsden, *Hamilton–Pontryagin integrators on Lie groups*, Found. Comput. Math. 9 (2009), with
/// the exponential as the retraction.
///
/// # Example
/// ```
/// use collective_integrators::{Composition, Integrator, Substeps};
/// use isospectral_flows::{ExponentialMidpoint, IsospectralField, LargeSkewHermitian};
/// use num_complex::Complex;
/// # struct Weighted(usize);
/// # impl IsospectralField for Weighted {
/// #     fn size(&self) -> usize { self.0 }
/// #     fn generator_into(&self, w: &LargeSkewHermitian, b: &mut LargeSkewHermitian) {
/// #         *b = LargeSkewHermitian::from_upper(self.0, |j, k| w.at(j, k) / (1 + j + k) as f64);
/// #     }
/// # }
/// // Weighted(N) is an equation with B_jk = W_jk/(1 + j + k)
/// let mut w = LargeSkewHermitian::from_upper(6, |j, k| Complex::new(0.1 * j as f64, 0.2 * k as f64));
/// let (norm, method) = (w.norm(), Composition::new(ExponentialMidpoint::new(Weighted(6)), Substeps::suzuki4()));
/// let mut workspace = method.workspace();
/// for _ in 0..50 {
///     method.step_in_place(&mut w, 0.1, &mut workspace)?;
/// }
/// assert!((w.norm() - norm).abs() < 1e-14);
/// # Ok::<(), collective_integrators::StepError>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct ExponentialMidpoint<F> {
    field: F,
    tolerance: f64,
}

impl<F: IsospectralField> ExponentialMidpoint<F> {
    /// Creates the integrator of a field. It solves for B to round-off.
    pub fn new(field: F) -> Self {
        Self { field, tolerance: 0.0 }
    }

    /// Returns the integrator with another tolerance for B: the largest accepted h |δB| in the last sweep.
    ///
    /// The spectrum of W is conserved to round-off whatever the tolerance. The map is Poisson to this tolerance.
    #[must_use]
    pub fn with_tolerance(self, tolerance: f64) -> Self {
        Self { tolerance, ..self }
    }

    /// Returns the equation that is integrated.
    pub fn field(&self) -> &F {
        &self.field
    }
}

/// The storage of a step of [`ExponentialMidpoint`].
#[derive(Clone, Debug)]
pub struct ExponentialWorkspace {
    products: Products,
    generator: [LargeSkewHermitian; 1],
    fresh: [LargeSkewHermitian; 1],
    terms: [LargeSkewHermitian; 2],
    mean: LargeSkewHermitian,
    conjugation: Conjugation,
    history: GeneratorHistory,
}

impl ExponentialWorkspace {
    /// Writes Σ_k ad_hB^k W/(k + 1)! to the mean, to the given relative accuracy.
    ///
    /// # Errors
    /// Returns the size of the last term, relative to W, if the series has not converged.
    fn set_mean(&mut self, w: &LargeSkewHermitian, step: f64, accuracy: f64) -> Result<(), f64> {
        let Self { products, generator: [generator], terms: [term, next], mean, .. } = self;
        mean.assign(w);
        term.assign(w);
        let (whole, mut size) = (largest(w), f64::INFINITY);
        for k in 1..MOST_TERMS {
            products.commutator(generator, term, next);
            next.scale_in_place(step / (k + 1) as f64);
            mean.add_in_place(next);
            core::mem::swap(term, next);
            size = largest(term);
            if size.is_nan() || size <= accuracy * whole {
                break;
            }
        }
        if size <= accuracy * whole { Ok(()) } else { Err(size / whole) }
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
    type Workspace = ExponentialWorkspace;

    fn workspace(&self) -> ExponentialWorkspace {
        let zero = || LargeSkewHermitian::zeros(self.field.size());
        ExponentialWorkspace {
            products: Products::default(),
            generator: [zero()],
            fresh: [zero()],
            terms: [zero(), zero()],
            mean: zero(),
            conjugation: Conjugation::new(self.field.size()),
            history: GeneratorHistory::new(&[0.5], 3),
        }
    }

    fn forget(&self, workspace: &mut ExponentialWorkspace) {
        workspace.history.forget();
    }

    fn step(
        &self,
        w: &LargeSkewHermitian,
        step: f64,
        workspace: &mut ExponentialWorkspace,
    ) -> Result<Step<LargeSkewHermitian>, StepError> {
        Step::of_copy(w, |w| self.step_in_place(w, step, workspace))
    }

    fn step_in_place(
        &self,
        w: &mut LargeSkewHermitian,
        step: f64,
        workspace: &mut ExponentialWorkspace,
    ) -> Result<usize, StepError> {
        StepError::check_dimension(w, self.field.size().saturating_pow(2))?;
        let space = workspace;
        if !space.history.predict(w, step, &mut space.generator) {
            self.field.generator_into(w, &mut space.generator[0]);
        }
        let mut sweeps = Sweeps::new(self.tolerance, step);
        loop {
            let accuracy = (AHEAD * sweeps.relative_change()).clamp(f64::EPSILON / 4.0, 1e-4);
            space.set_mean(w, step, accuracy).map_err(|residual| {
                let iterations = sweeps.made + 1;
                StepError::NotConverged { residual, required: accuracy, iterations }
            })?;
            self.field.generator_into(&space.mean, &mut space.fresh[0]);
            let last = sweeps.converged(&space.fresh, &space.generator)?;
            core::mem::swap(&mut space.generator, &mut space.fresh);
            // The mean of the first sweep is not accurate enough to end with.
            if last && sweeps.made > 1 {
                break;
            }
        }
        let ExponentialWorkspace {
            products,
            generator,
            terms: [scaled, _],
            conjugation,
            history,
            ..
        } = space;
        scaled.assign(&generator[0]);
        scaled.scale_in_place(step);
        conjugation.by_exponential(products, scaled, w)?;
        history.remember(generator, step, w);
        Ok(sweeps.made)
    }

    fn momentum(&self, w: &LargeSkewHermitian) -> LargeSkewHermitian {
        w.clone()
    }
}

impl<F> StateIsMomentum for ExponentialMidpoint<F> {}
