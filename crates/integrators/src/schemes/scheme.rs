//! The interface of one-step methods: [`Scheme`].

use crate::error::StepError;
use crate::vector_field::VectorField;
use lie_poisson::{Pair, Real, State};

/// The result of a step.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Step<V> {
    /// The state after the step; in an [`Increment`], its change.
    pub point: V,
    /// The number of iterations of the stage solver; 0 for explicit methods.
    pub iterations: usize,
}

/// The change δz + δe of a state in a step, where δe has the size of the rounding errors of δz.
pub type Increment<V> = Step<Pair<V, V>>;

impl<V: State> Step<V> {
    /// Makes a step with a copy of a state. An integrator that steps in place can implement its method by value in this
    /// way. The closure advances the copy and returns the number of iterations.
    ///
    /// # Errors
    /// Returns the error of the closure.
    ///
    /// # Example
    /// ```
    /// use collective_integrators::Step;
    /// let twice = |x: &mut nalgebra::Vector1<f64>| {
    ///     *x *= 2.0;
    ///     Ok(0)
    /// };
    /// let start = nalgebra::Vector1::new(3.0);
    /// assert_eq!(Step::of_copy(&start, twice)?.point.x, 6.0);
    /// # Ok::<(), collective_integrators::StepError>(())
    /// ```
    #[cfg_attr(optimised, inline(always))]
    pub fn of_copy(
        state: &V,
        advance: impl FnOnce(&mut V) -> Result<usize, StepError>,
    ) -> Result<Self, StepError> {
        let mut point = state.clone();
        let iterations = advance(&mut point)?;
        Ok(Self { point, iterations })
    }

    /// Returns the step itself if its point is finite.
    ///
    /// # Errors
    /// Returns [`StepError::NotFinite`] if a coordinate is infinite or not a number, in some SIMD lane of the scalar.
    #[cfg_attr(optimised, inline(always))]
    pub fn finite(self) -> Result<Self, StepError> {
        if self.point.is_finite() { Ok(self) } else { Err(StepError::NotFinite) }
    }
}

/// A one-step method z ↦ Φ_h(z) for dz/dt = X(z).
///
/// A scheme does not depend on where the vector field comes from, and works over every scalar.
///
/// # Example
/// A scheme of your own: Heun's method, z₁ = z + (h/2)(X(z) + X(z + h X(z))). Since it commutes with affine maps, it
/// may be used collectively ([`Equivariant`]).
/// ```
/// use collective_integrators::{Direct, Equivariant, Scheme, Start, Step, StepError, VectorField, fitted_order, from_fn};
/// use lie_poisson::{Real, State};
/// use nalgebra::Vector2;
///
/// #[derive(Clone)]
/// struct Heun;
/// impl Scheme for Heun {
///     type Workspace<V: State> = ();
///     fn workspace<V: State>(&self) {}
///     fn increment<T: Real, F: VectorField<T>>(
///         &self,
///         field: &F,
///         z: &F::Point,
///         h: f64,
///         (): &mut (),
///     ) -> Result<Step<F::Point>, StepError> {
///         let mut slope = field.at(z);
///         let mut predicted = z.clone();
///         predicted.add_multiple(T::from_f64(h), &slope);
///         slope.add_in_place(&field.at(&predicted));
///         slope.scale_in_place(T::from_f64(h / 2.0));
///         Ok(Step { point: slope, iterations: 0 })
///     }
///     fn forget<V: State>(&self, (): &mut ()) {}
///     fn order(&self) -> usize {
///         2
///     }
///     fn is_symplectic(&self) -> bool {
///         false
///     }
///     fn is_symmetric(&self) -> bool {
///         false
///     }
/// }
/// impl Equivariant for Heun {}
///
/// let oscillator = from_fn(|z: &Vector2<f64>| Vector2::new(z.y, -z.x));
/// let heun = Direct::new(Heun, oscillator);
/// let errors = [50, 100, 200].map(|steps| {
///     let h = 1.0 / steps as f64;
///     let end = heun.after(&Vector2::new(1.0, 0.0), h, steps).unwrap().state;
///     (h, (end - Vector2::new(1.0_f64.cos(), -1.0_f64.sin())).norm())
/// });
/// assert!((fitted_order(&errors, 1e-12)? - 2.0).abs() < 0.05);
/// # Ok::<(), collective_integrators::OrderFitError>(())
/// ```
pub trait Scheme: Clone {
    /// The storage that a step needs, allocated once per run.
    type Workspace<V: State>;

    /// Creates the storage for steps. For points on the heap, whose size is not known here, the first step allocates
    /// the rest. The matrix of Newton's iteration is allocated by the first step that needs it.
    fn workspace<V: State>(&self) -> Self::Workspace<V>;

    /// Returns the increment Φ_h(z) − z of one step.
    ///
    /// Its rounding errors are those of a sum h Σ b_i k_i, and h times those of the stages. The method allocates only a
    /// point on the heap, and only if the storage of an earlier point was not given back to
    /// [`temporaries`](Self::temporaries). The caller checks that the increment is finite.
    ///
    /// # Errors
    /// Returns a [`StepError`] if stage equations are not solved. In that case only the workspace is changed.
    fn increment<T: Real, F: VectorField<T>>(
        &self,
        field: &F,
        z: &F::Point,
        step: f64,
        workspace: &mut Self::Workspace<F::Point>,
    ) -> Result<Step<F::Point>, StepError>;

    /// Returns the increment Φ_h(z + e) − (z + e) as δz + δe, for [`Compensated`](crate::Compensated) summation, where
    /// e has the size of the rounding errors of z, and δe the size of the rounding errors of δz.
    ///
    /// A scheme that is able to make its rounding errors small and unbiased overrides this method. The default is
    /// ([`increment`](Self::increment), 0) of a step from z, whose rounding errors are biased.
    ///
    /// # Errors
    /// Returns the errors of [`increment`](Self::increment).
    #[cfg_attr(optimised, inline(always))]
    fn refined_increment<T: Real, F: VectorField<T>>(
        &self,
        field: &F,
        (z, _e): (&F::Point, &F::Point),
        step: f64,
        workspace: &mut Self::Workspace<F::Point>,
    ) -> Result<Increment<F::Point>, StepError> {
        let Step { point, iterations } = self.increment(field, z, step, workspace)?;
        let mut exact = take(self, workspace, z);
        exact.set_zero();
        Ok(Step { point: Pair(point, exact), iterations })
    }

    /// Returns the step Φ_h(z). Allocates only a point on the heap; see [`step_in_place`](Self::step_in_place).
    ///
    /// # Errors
    /// Returns a [`StepError`] if stage equations are not solved, or if the result is not finite. In these cases only
    /// the workspace is changed.
    #[cfg_attr(optimised, inline(always))]
    fn step<T: Real, F: VectorField<T>>(
        &self,
        field: &F,
        z: &F::Point,
        step: f64,
        workspace: &mut Self::Workspace<F::Point>,
    ) -> Result<Step<F::Point>, StepError> {
        let Step { mut point, iterations } = self.increment(field, z, step, workspace)?;
        point.add_in_place(z);
        Step { point, iterations }.finite()
    }

    /// Replaces z by Φ_h(z), in the same storage. Returns the number of iterations.
    ///
    /// With a pool of [`temporaries`](Self::temporaries) no step after the first allocates, unless it needs Newton's
    /// iteration.
    ///
    /// # Errors
    /// Returns the errors of [`step`](Self::step). In that case the point z is not changed.
    #[cfg_attr(optimised, inline(always))]
    fn step_in_place<T: Real, F: VectorField<T>>(
        &self,
        field: &F,
        z: &mut F::Point,
        step: f64,
        workspace: &mut Self::Workspace<F::Point>,
    ) -> Result<usize, StepError> {
        let Step { point: mut end, iterations } = self.step(field, z, step, workspace)?;
        z.move_from(&mut end);
        give(self, workspace, end);
        Ok(iterations)
    }

    /// Returns the pool of temporary vectors of a workspace, to which a caller may give the storage of points that
    /// [`increment`](Self::increment) has returned.
    ///
    /// The default returns `None`, for schemes that keep no temporary vectors. Return a pool only if `increment` takes
    /// its point from it: otherwise the pool grows by one vector with each step in place.
    #[cfg_attr(optimised, inline(always))]
    fn temporaries<'a, V: State>(
        &self,
        _workspace: &'a mut Self::Workspace<V>,
    ) -> Option<&'a mut V::Pool> {
        None
    }

    /// Makes the workspace forget the earlier steps, from which an implicit method predicts its stages.
    ///
    /// The next step then depends on its starting point alone. A scheme that contains another one passes the call on. For
    /// a scheme that remembers nothing it does nothing. The law `forgetting` of the suite `laws::scheme` checks it.
    fn forget<V: State>(&self, workspace: &mut Self::Workspace<V>);

    /// Returns the order of convergence.
    fn order(&self) -> usize;

    /// Returns whether Φ_h is symplectic for every Hamiltonian vector field on a symplectic vector space.
    fn is_symplectic(&self) -> bool;

    /// Returns whether the scheme is symmetric in time, Φ₋ₕ ∘ Φₕ = id.
    fn is_symmetric(&self) -> bool;

    /// Returns whether Φ_h conserves every quadratic function that the exact flow conserves, for every vector field.
    ///
    /// For a Runge–Kutta method this is the same condition as symplecticity. For a partitioned method it is not: a
    /// symplectic one conserves the invariants qᵀDp that are bilinear in q and p, but not other quadratic invariants
    /// that mix them. The default is `false`.
    ///
    /// Source: Bochev & Scovel, *On quadratic invariants and symplectic structure*, BIT 34 (1994);
    /// Hairer, Lubich & Wanner, Thms. IV.2.2, IV.2.3 and VI.4.3.
    fn preserves_quadratic_invariants(&self) -> bool {
        false
    }
}

/// Takes a temporary vector of the space of z from the pool of a workspace, if there is one.
#[cfg_attr(optimised, inline(always))]
pub(crate) fn take<S: Scheme, V: State>(scheme: &S, workspace: &mut S::Workspace<V>, z: &V) -> V {
    match scheme.temporaries(workspace) {
        Some(pool) => V::take(pool, z),
        None => V::take(&mut V::Pool::default(), z),
    }
}

/// Gives a vector back to the pool of a workspace, if there is one.
#[cfg_attr(optimised, inline(always))]
pub(crate) fn give<S: Scheme, V: State>(scheme: &S, workspace: &mut S::Workspace<V>, v: V) {
    if let Some(pool) = scheme.temporaries(workspace) {
        v.give(pool);
    }
}

/// The promise that a scheme commutes with affine changes of variables A: A∘Φ_X = Φ_Y∘A for the transformed field Y =
/// A∗X.
///
/// For every realisation of these crates, the symmetry along the fibres of M acts affinely. An equivariant scheme
/// therefore carries fibres of M to fibres, so that M∘Φ is a map of 𝔤∗. If the scheme is also symplectic, that map is
/// Poisson. Runge–Kutta methods keep the promise. Partitioned methods, which treat q and p differently, do not: they
/// are symplectic on P, but their images are not maps of 𝔤∗.
///
/// Source: McLachlan, Modin & Verdier, *Collective symplectic integrators*, Nonlinearity 27
/// (2014), Thm. 3.2; Hairer, Lubich & Wanner, *Geometric Numerical Integration*, §VI.4.
///
/// # Example
/// The trait bounds a function that needs a step on 𝔤∗. Runge–Kutta methods and their compositions fulfil the bound.
/// For a scheme of your own, see the example of [`Scheme`].
/// ```
/// use collective_integrators::{Composition, Equivariant, RungeKutta, Substeps};
/// fn descends(_: &impl Equivariant) {}
/// descends(&RungeKutta::gauss(2)?);
/// descends(&Composition::new(RungeKutta::implicit_midpoint(), Substeps::yoshida4()));
/// # Ok::<(), collective_integrators::SchemeError>(())
/// ```
/// ```compile_fail
/// use collective_integrators::{Equivariant, FirstHalf, PartitionedRungeKutta};
/// fn descends(_: &impl Equivariant) {}
/// descends(&PartitionedRungeKutta::<FirstHalf>::kick_drift_kick());
/// ```
#[diagnostic::on_unimplemented(
    message = "the scheme `{Self}` does not promise to commute with affine changes of variables",
    label = "its steps need not descend to the dual of the Lie algebra",
    note = "use `RungeKutta` or a `Composition` of it; for a scheme of your own that treats all coordinates alike, \
            write `impl Equivariant for …`",
    note = "partitioned methods, polarisations and splittings of the phase space do not keep the promise"
)]
pub trait Equivariant: Scheme {}
