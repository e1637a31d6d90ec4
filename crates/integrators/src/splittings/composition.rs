//! Composition methods: [`Composition`].

use crate::error::StepError;
use crate::integrators::trajectories::integrator::Integrator;
use crate::integrators::trajectories::start::Start;
use crate::schemes::scheme::{Equivariant, Increment, Scheme, Step, give, take};
use crate::step_fractions::substeps::Substeps;
use crate::sums::two_sum::add_compensated;
use crate::vector_field::VectorField;
use lie_poisson::{Pair, Real, State};
use momentum_map::LiftError;

/// The composition Ψ(h) = Φ(γ_s h) ∘ … ∘ Φ(γ₁ h) of a method Φ(h) with itself.
///
/// It is symplectic, equivariant or a Poisson map if Φ is, and conserves an invariant if Φ does. It has a higher order
/// if the [`Substeps`] are suitable for Φ. Φ may be a [`Scheme`], or an [`Integrator`] that is not a scheme, such as a
/// [`Splitting`](crate::Splitting).
///
/// Stages are predicted from the preceding substeps if these have the same size, as in Suzuki's compositions. Otherwise
/// the iteration of a substep starts from the field alone.
///
/// Source: Hairer, Lubich & Wanner, *Geometric Numerical Integration*, 2nd ed. (2006), §II.4 and
/// §V.3.
///
/// # Example
/// ```
/// use collective_integrators::{Composition, RungeKutta, Scheme, Substeps, from_fn};
/// use nalgebra::Vector2;
/// let scheme = Composition::new(RungeKutta::implicit_midpoint(), Substeps::kahan_li8());
/// assert_eq!(scheme.order(), 8);
/// assert!(scheme.is_symplectic() && scheme.is_symmetric());
/// let oscillator = from_fn(|z: &Vector2<f64>| Vector2::new(z.y, -z.x));
/// let step = scheme.step(&oscillator, &Vector2::new(1.0, 0.0), 0.1, &mut scheme.workspace())?;
/// assert!((step.point.x - 0.1_f64.cos()).abs() < 1e-13);
/// # Ok::<(), collective_integrators::StepError>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Composition<S> {
    base: S,
    substeps: Substeps,
}

impl<S> Composition<S> {
    /// Creates the composition of Φ = `base` with the given substeps.
    pub fn new(base: S, substeps: Substeps) -> Self {
        Self { base, substeps }
    }

    /// Returns the method Φ that is composed.
    pub fn base(&self) -> &S {
        &self.base
    }

    /// Returns the substeps γ of the composition.
    pub fn substeps(&self) -> &Substeps {
        &self.substeps
    }

    /// Makes one substep after the other, until one fails. Returns the number of iterations. A substep is told whether it is
    /// the last one.
    #[cfg_attr(optimised, inline(always))]
    fn chain(
        &self,
        step: f64,
        mut substep: impl FnMut(f64, bool) -> Result<usize, StepError>,
    ) -> Result<usize, StepError> {
        let mut iterations = 0;
        let mut fractions = self.substeps.fractions().iter();
        while let Some(gamma) = fractions.next() {
            iterations += substep(gamma * step, fractions.as_slice().is_empty())?;
        }
        Ok(iterations)
    }
}

impl<S: Equivariant> Equivariant for Composition<S> {}

impl<S: Scheme> Scheme for Composition<S> {
    type Workspace<V: State> = S::Workspace<V>;

    fn workspace<V: State>(&self) -> Self::Workspace<V> {
        self.base.workspace()
    }

    /// Returns the sum of the increments of the substeps.
    #[cfg_attr(optimised, inline(always))]
    fn increment<T: Real, F: VectorField<T>>(
        &self,
        field: &F,
        z: &F::Point,
        step: f64,
        workspace: &mut Self::Workspace<F::Point>,
    ) -> Result<Step<F::Point>, StepError> {
        let mut from = take(&self.base, workspace, z);
        from.assign(z);
        // The first increment is the sum so far, with the signs of its zeros, so that one substep is a step of the base.
        let mut sum: Option<F::Point> = None;
        let made = self.chain(
            step,
            #[cfg_attr(optimised, inline(always))]
            |step, is_last| {
                let Step { point, iterations } =
                    self.base.increment(field, &from, step, workspace)?;
                let sum = match &mut sum {
                    None => sum.insert(point),
                    Some(sum) => {
                        sum.add_in_place(&point);
                        give(&self.base, workspace, point);
                        sum
                    }
                };
                if !is_last {
                    from.assign(z);
                    from.add_in_place(sum);
                }
                Ok(iterations)
            },
        );
        give(&self.base, workspace, from);
        match (made, sum) {
            (Ok(iterations), sum) => {
                Ok(Step { point: sum.unwrap_or_else(|| z.zeros_like()), iterations })
            }
            (Err(failed), sum) => {
                if let Some(sum) = sum {
                    give(&self.base, workspace, sum);
                }
                Err(failed)
            }
        }
    }

    /// Returns the sum of the refined increments of the substeps. Each substep starts where the one before it ended,
    /// with the rounding error that is carried along.
    #[cfg_attr(optimised, inline(always))]
    fn refined_increment<T: Real, F: VectorField<T>>(
        &self,
        field: &F,
        (z, e): (&F::Point, &F::Point),
        step: f64,
        workspace: &mut Self::Workspace<F::Point>,
    ) -> Result<Increment<F::Point>, StepError> {
        let [mut from, mut carried] = [(); 2].map(|()| take(&self.base, workspace, z));
        from.assign(z);
        carried.assign(e);
        let mut sum: Option<Pair<F::Point, F::Point>> = None;
        let made = self.chain(
            step,
            #[cfg_attr(optimised, inline(always))]
            |step, is_last| {
                let Step { point: Pair(change, error), iterations } =
                    self.base.refined_increment(field, (&from, &carried), step, workspace)?;
                let mut none = Default::default();
                let pool = self.base.temporaries(workspace).unwrap_or(&mut none);
                if !is_last {
                    add_compensated((&mut from, &mut carried), (&change, &error), pool);
                }
                match &mut sum {
                    None => sum = Some(Pair(change, error)),
                    Some(Pair(sum, rest)) => {
                        add_compensated((sum, rest), (&change, &error), pool);
                        change.give(pool);
                        error.give(pool);
                    }
                }
                Ok(iterations)
            },
        );
        give(&self.base, workspace, from);
        give(&self.base, workspace, carried);
        match (made, sum) {
            (Ok(iterations), sum) => {
                let none = || Pair(z.zeros_like(), z.zeros_like());
                Ok(Step { point: sum.unwrap_or_else(none), iterations })
            }
            (Err(failed), sum) => {
                if let Some(Pair(sum, rest)) = sum {
                    give(&self.base, workspace, sum);
                    give(&self.base, workspace, rest);
                }
                Err(failed)
            }
        }
    }

    #[cfg_attr(optimised, inline(always))]
    fn temporaries<'a, V: State>(
        &self,
        workspace: &'a mut Self::Workspace<V>,
    ) -> Option<&'a mut V::Pool> {
        self.base.temporaries(workspace)
    }

    #[cfg_attr(optimised, inline(always))]
    fn forget<V: State>(&self, workspace: &mut Self::Workspace<V>) {
        self.base.forget(workspace);
    }

    /// Returns the order that [`Substeps::order_over`] gives for the order of the base.
    fn order(&self) -> usize {
        self.substeps.order_over(self.base.order(), self.base.is_symmetric())
    }

    fn is_symplectic(&self) -> bool {
        self.base.is_symplectic()
    }

    fn is_symmetric(&self) -> bool {
        self.base.is_symmetric() && self.substeps.is_symmetric()
    }

    fn preserves_quadratic_invariants(&self) -> bool {
        self.base.preserves_quadratic_invariants()
    }
}

impl<T: Real, I: Integrator<T>> Integrator<T> for Composition<I> {
    type State = I::State;
    type Momentum = I::Momentum;
    /// The storage of a step of the base, and the pool of temporary states.
    type Workspace = (I::Workspace, <I::State as State>::Pool);

    fn workspace(&self) -> Self::Workspace {
        (self.base.workspace(), Default::default())
    }

    #[cfg_attr(optimised, inline(always))]
    fn step(
        &self,
        state: &I::State,
        step: f64,
        (workspace, _): &mut Self::Workspace,
    ) -> Result<Step<I::State>, StepError> {
        Step::of_copy(
            state,
            #[cfg_attr(optimised, inline(always))]
            |z| {
                self.chain(
                    step,
                    #[cfg_attr(optimised, inline(always))]
                    |step, _| self.base.step_in_place(z, step, workspace),
                )
            },
        )
    }

    #[cfg_attr(optimised, inline(always))]
    fn step_in_place(
        &self,
        state: &mut I::State,
        step: f64,
        (workspace, pool): &mut Self::Workspace,
    ) -> Result<usize, StepError> {
        let mut end = I::State::take(pool, state);
        end.assign(state);
        let made = self.chain(step, |step, _| self.base.step_in_place(&mut end, step, workspace));
        if made.is_ok() {
            state.move_from(&mut end);
        }
        end.give(pool);
        made
    }

    #[cfg_attr(optimised, inline(always))]
    fn forget(&self, (workspace, _): &mut Self::Workspace) {
        self.base.forget(workspace);
    }

    fn pin(&self, (workspace, _): &mut Self::Workspace) {
        self.base.pin(workspace);
    }

    fn momentum(&self, state: &I::State) -> I::Momentum {
        self.base.momentum(state)
    }
}

impl<T: Real, I: Start<T>> Start<T> for Composition<I> {
    fn start(&self, mu: &I::Momentum) -> Result<I::State, LiftError> {
        self.base.start(mu)
    }
}
