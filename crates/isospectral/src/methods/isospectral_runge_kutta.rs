//! Collective Runge–Kutta methods on u(N)∗: [`IsospectralRungeKutta`].

use crate::fields::isospectral_field::IsospectralField;
use crate::matrices::large_matrix::LargeMatrix;
use crate::matrices::products::Products;
use crate::matrices::skew_hermitian::LargeSkewHermitian;
use crate::methods::conjugation::Conjugation;
use collective_integrators::{
    Equivariant, Integrator, StateIsMomentum, Step, StepError, VectorField,
};
use lie_poisson::State;
use std::cell::RefCell;

/// The collective integrator of an [isospectral equation](IsospectralField), computed without a lift. For symplectic
/// schemes it is a Poisson map of u(N)∗.
///
/// The scheme solves
///
/// ```text
/// dQ/dt = B(Q W₀ Q*) Q,    Q(0) = 1
/// ```
///
/// for a complex matrix Q over one step, and W₁ = Q₁ W₀ Q₁*. A symplectic Runge–Kutta method gives a unitary Q₁, so
/// that the spectrum is conserved, and the map is the reduction of a symplectic map for Q. These are the isospectral
/// symplectic Runge–Kutta methods of Modin and Viviani. The implicit midpoint rule gives their midpoint method:
///
/// ```text
/// W₀ = (1 − h B/2) Wₘ (1 + h B/2),    W₁ = (1 + h B/2) Wₘ (1 − h B/2),    B = B(Wₘ)
/// ```
///
/// The stages are solved by sweeps. Each costs three products per stage. The error of the method contains that of the
/// Padé approximation of exp(h B), which grows with the spectral radius of h B, and not only with the time scale of the
/// solution. [`GaussMagnus`](crate::GaussMagnus) does not have this error, but is not a Poisson map.
///
/// Source: Modin & Viviani, *Lie–Poisson methods for isospectral flows*, Found. Comput. Math. 20 (2020).
///
/// # Example
/// ```
/// use collective_integrators::{Integrator, RungeKutta};
/// use isospectral_flows::{IsospectralField, IsospectralRungeKutta, LargeSkewHermitian};
/// use num_complex::Complex;
/// /// B(W) is the diagonal of W, multiplied by two.
/// struct Diagonal(usize);
/// impl IsospectralField for Diagonal {
///     fn size(&self) -> usize {
///         self.0
///     }
///     fn generator_into(&self, w: &LargeSkewHermitian, b: &mut LargeSkewHermitian) {
///         *b = LargeSkewHermitian::from_upper(self.0, |j, k| if j == k { 2.0 * w.at(j, j) } else { Complex::ZERO });
///     }
/// }
/// let mut w = LargeSkewHermitian::from_upper(5, |j, k| Complex::new(0.1 * j as f64, 0.2 * k as f64 - 0.3));
/// let (start, diagonal) = (w.clone(), w.at(1, 1));
/// let gauss = IsospectralRungeKutta::new(RungeKutta::gauss(2)?, Diagonal(5));
/// let mut workspace = gauss.workspace();
/// for _ in 0..100 {
///     gauss.step_in_place(&mut w, 0.1, &mut workspace)?;
/// }
/// // the diagonal does not move, and the norm is one of the Casimirs
/// assert!((w.at(1, 1) - diagonal).norm() < 1e-14 && (w.at(0, 1) - start.at(0, 1)).norm() > 0.1);
/// assert!((w.norm() - start.norm()).abs() < 1e-14);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct IsospectralRungeKutta<S, F> {
    scheme: S,
    field: F,
}

impl<S: Equivariant, F: IsospectralField> IsospectralRungeKutta<S, F> {
    /// Creates an integrator that applies the scheme to the matrices Q.
    pub fn new(scheme: S, field: F) -> Self {
        Self { scheme, field }
    }

    /// Returns the scheme for Q.
    pub fn scheme(&self) -> &S {
        &self.scheme
    }

    /// Returns the equation that is integrated.
    pub fn field(&self) -> &F {
        &self.field
    }
}

/// The storage of a step of [`IsospectralRungeKutta`].
#[derive(Debug)]
pub struct IsospectralWorkspace<S: Equivariant> {
    scheme: S::Workspace<LargeMatrix>,
    stages: RefCell<StageStorage>,
    conjugation: Conjugation,
}

impl<S: Equivariant> IsospectralWorkspace<S> {
    /// Creates the storage for matrices of a size.
    pub(crate) fn new(scheme: &S, size: usize) -> Self {
        let zero = || LargeSkewHermitian::zeros(size);
        let (moved, generator) = (zero(), zero());
        let conjugation = Conjugation::new(size);
        let stages = RefCell::new(StageStorage { products: Products::default(), moved, generator });
        Self { scheme: scheme.workspace(), stages, conjugation }
    }
}

impl<S: Equivariant> IsospectralWorkspace<S> {
    /// Replaces W by exp(Ω) W exp(−Ω).
    ///
    /// # Errors
    /// Returns [`StepError::NotFinite`], and leaves W unchanged, if the result is not finite.
    pub(crate) fn turn(
        &mut self,
        omega: &LargeSkewHermitian,
        w: &mut LargeSkewHermitian,
    ) -> Result<(), StepError> {
        self.conjugation.by_exponential(&mut self.stages.get_mut().products, omega, w)
    }
}

/// The temporary matrices of an evaluation of B(Q W₀ Q*) Q.
#[derive(Debug)]
struct StageStorage {
    products: Products,
    moved: LargeSkewHermitian,
    generator: LargeSkewHermitian,
}

/// The right-hand side B(Q W₀ Q*) Q for Y = Q − 1.
struct MultiplierField<'a, F> {
    field: &'a F,
    start: &'a LargeSkewHermitian,
    storage: &'a RefCell<StageStorage>,
}

impl<F: IsospectralField> VectorField for MultiplierField<'_, F> {
    type Point = LargeMatrix;

    fn at(&self, y: &LargeMatrix) -> LargeMatrix {
        let mut value = y.zeros_like();
        self.at_into(y, &mut value);
        value
    }

    fn at_into(&self, y: &LargeMatrix, value: &mut LargeMatrix) {
        let StageStorage { products, moved, generator } = &mut *self.storage.borrow_mut();
        products.conjugate(y, self.start, moved);
        self.field.generator_into(moved, generator);
        products.multiply(generator.matrix(), y, value);
        value.add_in_place(generator.matrix());
    }
}

/// Replaces W by W after a step of the scheme for Q. Returns the number of iterations.
///
/// # Errors
/// Those of the step. In that case W is not changed.
pub(crate) fn step_of_multiplier<S: Equivariant, F: IsospectralField>(
    (scheme, field): (&S, &F),
    w: &mut LargeSkewHermitian,
    step: f64,
    workspace: &mut IsospectralWorkspace<S>,
) -> Result<usize, StepError> {
    StepError::check_dimension(w, field.size().saturating_pow(2))?;
    let IsospectralWorkspace { scheme: storage, stages, conjugation } = workspace;
    let mut zero = stages.borrow_mut().products.take(w.matrix());
    zero.set_zero();
    let rate = MultiplierField { field, start: w, storage: stages };
    // In every step Q begins at 1: the stages of the previous step are in another frame.
    scheme.forget(storage);
    let made = scheme.increment(&rate, &zero, step, storage);
    let products = &mut stages.get_mut().products;
    products.give(zero);
    let Step { point: y, iterations } = made?;
    let conjugated = conjugation.by(products, (&y, iterations), w);
    if let Some(pool) = scheme.temporaries(storage) {
        y.give(pool);
    }
    conjugated.map(|()| iterations)
}

impl<S: Equivariant, F: IsospectralField> Integrator for IsospectralRungeKutta<S, F> {
    type State = LargeSkewHermitian;
    type Momentum = LargeSkewHermitian;
    type Workspace = IsospectralWorkspace<S>;

    fn workspace(&self) -> Self::Workspace {
        IsospectralWorkspace::new(&self.scheme, self.field.size())
    }

    fn step(
        &self,
        w: &LargeSkewHermitian,
        step: f64,
        workspace: &mut Self::Workspace,
    ) -> Result<Step<LargeSkewHermitian>, StepError> {
        Step::of_copy(w, |w| self.step_in_place(w, step, workspace))
    }

    fn step_in_place(
        &self,
        w: &mut LargeSkewHermitian,
        step: f64,
        workspace: &mut Self::Workspace,
    ) -> Result<usize, StepError> {
        step_of_multiplier((&self.scheme, &self.field), w, step, workspace)
    }

    /// Every step forgets the stages of the one before.
    fn forget(&self, _: &mut Self::Workspace) {}

    fn momentum(&self, w: &LargeSkewHermitian) -> LargeSkewHermitian {
        w.clone()
    }
}

impl<S, F> StateIsMomentum for IsospectralRungeKutta<S, F> {}
