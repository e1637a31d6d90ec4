//! Compensated summation, which carries the rounding errors of the steps along: [`Compensated`].

use crate::error::StepError;
use crate::integrators::trajectories::integrator::Integrator;
use crate::integrators::trajectories::start::Start;
use crate::schemes::scheme::{Increment, Step};
use crate::sums::two_sum::add_compensated;
use lie_poisson::{Pair, Real, State};
use momentum_map::LiftError;

/// An integrator that adds a small increment to its state in each step: z ↦ z + δz.
///
/// [`Compensated`] adds the increments and carries the rounding errors along. Its documentation has an example.
pub trait Increments<T: Real = f64>: Integrator<T> {
    /// Returns the change δz + δe of a state z + e in one step, before it is [`gauged`](Self::gauged). Here e has the
    /// size of the rounding errors of z, and δe the size of the rounding errors of δz.
    ///
    /// The caller checks that the result is finite.
    ///
    /// # Errors
    /// Returns a [`StepError`] if the step has no result.
    fn increment(
        &self,
        state: &Pair<Self::State, Self::State>,
        step: f64,
        workspace: &mut Self::Workspace,
    ) -> Result<Increment<Self::State>, StepError>;

    /// Returns the pool of temporary vectors of a workspace, from which [`increment`](Self::increment) takes its
    /// result.
    ///
    /// The default returns `None`: an increment on the heap is allocated in each step. See
    /// [`Scheme::temporaries`](crate::Scheme::temporaries).
    #[cfg_attr(optimised, inline(always))]
    fn temporaries<'a>(
        &self,
        _workspace: &'a mut Self::Workspace,
    ) -> Option<&'a mut <Self::State as State>::Pool> {
        None
    }

    /// Returns the state from which the next step starts instead of this z + e, with the same momentum.
    ///
    /// If there are fibres, it is another point of the fibre, unless the workspace is [pinned](Integrator::pin). The
    /// default is the state itself.
    #[cfg_attr(optimised, inline(always))]
    fn gauged(
        &self,
        state: Pair<Self::State, Self::State>,
        _workspace: &Self::Workspace,
    ) -> Pair<Self::State, Self::State> {
        state
    }
}

/// An integrator that carries along the rounding error e of the additions z + δz:
///
/// ```text
/// z₁ + e₁ = (z + e) + (δz + δe)
/// ```
///
/// The errors of a step then have the size of the rounding errors of δz, which are smaller than those of z by a factor
/// h|Ω|. The state is (z, e). For a [`LiftFree`](crate::LiftFree) integrator z is μ.
///
/// If the fixed-point iteration solves the stages of an implicit Runge–Kutta method, the increment has about twice the
/// digits, apart from the rounding errors of the field: stages start from z + e, sums over stages keep what they round
/// off, and the effect of both on the field is added back
/// ([`Scheme::refined_increment`](crate::Scheme::refined_increment)). If a [`Collective`](crate::Collective) integrator
/// moves z along its fibre, e moves with it. A [`LiftFree`](crate::LiftFree) integrator moves e with the multiplier
/// that it computes from μ. The errors of invariants then grow as t^½. Other methods, and steps that need Newton's
/// iteration, keep biased rounding errors and may drift.
///
/// Source: W. Kahan, *Further remarks on reducing truncation errors*, Comm. ACM 8 (1965); Hairer,
/// McLachlan & Razakarivony, *Achieving Brouwer's law with implicit Runge–Kutta methods*, BIT 48
/// (2008), §3.
///
/// # Example
/// ```
/// use collective_integrators::{LiftFree, RungeKutta, Start};
/// use lie_poisson::{Covector, LiePoisson, So3, from_closure};
/// use momentum_map::Quaternions;
/// use nalgebra::Vector3;
/// let h = from_closure::<LiePoisson<So3>, _>(|Covector(pi)| pi.x * pi.x * 0.5 + pi.y * pi.y);
/// let gauss = LiftFree::new(RungeKutta::gauss(3)?, Quaternions, h).compensated();
/// let start = Covector(Vector3::new(1.0, 1.0, 1.0));
/// for sample in gauss.trajectory(&start, 0.01)?.take(1000) {
///     assert!((sample?.momentum.0.norm_squared() - 3.0).abs() < 4e-15);
/// }
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Compensated<I>(pub(crate) I);

impl<I: Increments> Compensated<I> {
    /// Creates the integrator that adds the increments of another one. Those of this crate have a method `compensated`, too.
    ///
    /// # Example
    /// An integrator of one's own, for dx/dt = 1. The additions of 10⁵ steps round off some 10⁻⁸, which is carried along:
    /// ```
    /// use collective_integrators::{Compensated, Increment, Increments, Integrator, Step, StepError};
    /// use lie_poisson::Pair;
    /// use nalgebra::Vector1;
    ///
    /// struct Walk;
    /// impl Integrator for Walk {
    ///     type State = Vector1<f64>;
    ///     type Momentum = Vector1<f64>;
    ///     type Workspace = ();
    ///     fn workspace(&self) {}
    ///     fn forget(&self, (): &mut ()) {}
    ///     fn step(&self, x: &Vector1<f64>, h: f64, (): &mut ()) -> Result<Step<Vector1<f64>>, StepError> {
    ///         Ok(Step { point: x.add_scalar(h), iterations: 0 })
    ///     }
    ///     fn momentum(&self, x: &Vector1<f64>) -> Vector1<f64> {
    ///         *x
    ///     }
    /// }
    /// impl Increments for Walk {
    ///     fn increment(
    ///         &self,
    ///         _: &Pair<Vector1<f64>, Vector1<f64>>,
    ///         h: f64,
    ///         (): &mut (),
    ///     ) -> Result<Increment<Vector1<f64>>, StepError> {
    ///         Ok(Step { point: Pair(Vector1::new(h), Vector1::zeros()), iterations: 0 })
    ///     }
    /// }
    /// let (zero, steps) = (Vector1::zeros(), 100_000);
    /// let error = |end: Vector1<f64>| (end.x - 1e4).abs();
    /// assert!(error(Walk.after_from(zero, 0.1, steps)?.momentum) > 1e-9);
    /// assert!(error(Compensated::new(Walk).after_from(Pair(zero, zero), 0.1, steps)?.momentum) < 1e-11);
    /// # Ok::<(), collective_integrators::IntegrationError>(())
    /// ```
    pub fn new(integrator: I) -> Self {
        Self(integrator)
    }
}

impl<I> Compensated<I> {
    /// Returns the integrator whose increments are added.
    pub fn base(&self) -> &I {
        &self.0
    }
}

/// Returns (z₁, e₁) from (z, e) and (δz, δe): one addition of [`Compensated`] summation.
///
/// ```
/// use collective_integrators::compensated_sum;
/// use lie_poisson::{Pair, nalgebra::Vector1};
/// let (one, zero) = (Vector1::new(1.0), Vector1::zeros());
/// let tiny = Pair(Vector1::new(f64::EPSILON / 8.0), zero);
/// let sum = (0..8).fold(Pair(one, zero), |sum, _| compensated_sum(&sum, &tiny));
/// assert_eq!(sum, Pair(Vector1::new(1.0 + f64::EPSILON), zero));
/// // without e, each addition would be lost
/// assert_eq!(one + tiny.0, one);
/// ```
#[cfg_attr(optimised, inline(always))]
pub fn compensated_sum<V: State>(sum: &Pair<V, V>, increment: &Pair<V, V>) -> Pair<V, V> {
    let mut next = sum.clone();
    let Pair(dz, de) = increment;
    add_compensated((&mut next.0, &mut next.1), (dz, de), &mut V::Pool::default());
    next
}

impl<I: Increments<T>, T: Real> Integrator<T> for Compensated<I> {
    type State = Pair<I::State, I::State>;
    type Momentum = I::Momentum;
    type Workspace = I::Workspace;

    fn workspace(&self) -> Self::Workspace {
        self.0.workspace()
    }

    #[cfg_attr(optimised, inline(always))]
    fn forget(&self, workspace: &mut Self::Workspace) {
        self.0.forget(workspace);
    }

    fn pin(&self, workspace: &mut Self::Workspace) {
        self.0.pin(workspace);
    }

    #[cfg_attr(optimised, inline(always))]
    fn step(
        &self,
        state: &Self::State,
        step: f64,
        workspace: &mut Self::Workspace,
    ) -> Result<Step<Self::State>, StepError> {
        let Step { point, iterations } = self.0.increment(state, step, workspace)?;
        let point = self.0.gauged(compensated_sum(state, &point), workspace);
        Step { point, iterations }.finite()
    }

    #[cfg_attr(optimised, inline(always))]
    fn step_in_place(
        &self,
        state: &mut Self::State,
        step: f64,
        workspace: &mut Self::Workspace,
    ) -> Result<usize, StepError> {
        let Step { point: Pair(change, error), iterations } =
            self.0.increment(state, step, workspace)?;
        let mut none = Default::default();
        let pool = self.0.temporaries(workspace).unwrap_or(&mut none);
        let [mut z, mut e] = [(); 2].map(|()| I::State::take(pool, &state.0));
        z.assign(&state.0);
        e.assign(&state.1);
        add_compensated((&mut z, &mut e), (&change, &error), pool);
        let mut end = self.0.gauged(Pair(z, e), workspace);
        let pool = self.0.temporaries(workspace).unwrap_or(&mut none);
        let finite = end.is_finite();
        if finite {
            state.move_from(&mut end);
        }
        for vector in [end.0, end.1, change, error] {
            vector.give(pool);
        }
        if finite { Ok(iterations) } else { Err(StepError::NotFinite) }
    }

    #[cfg_attr(optimised, inline(always))]
    fn momentum(&self, state: &Self::State) -> Self::Momentum {
        self.0.momentum(&state.0)
    }
}

impl<I: Increments<T> + Start<T>, T: Real> Start<T> for Compensated<I> {
    /// Returns the state (z, 0) that represents μ.
    fn start(&self, mu: &Self::Momentum) -> Result<Self::State, LiftError> {
        let z = self.0.start(mu)?;
        let exact = z.zeros_like();
        Ok(Pair(z, exact))
    }
}
