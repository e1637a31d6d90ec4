//! Collective Runge–Kutta methods without a lift: [`LiftFree`].

use crate::error::StepError;
use crate::integrators::compensated::{Compensated, Increments};
use crate::integrators::multiplier_field::{Course, MultiplierField};
use crate::integrators::state_is_momentum::StateIsMomentum;
use crate::integrators::trajectories::integrator::Integrator;
use crate::schemes::scheme::{Equivariant, Increment, Scheme, Step};
use crate::vector_field::VectorField;
use lie_poisson::{Hamiltonian, Pair, Point, Real, Vector};
use momentum_map::{Multiplier, Multipliers};

/// The collective integrator of a linear collective system, computed on 𝔤∗ itself without a lift.
///
/// The scheme solves
///
/// ```text
/// dQ/dt = dh(transport(Q, μ₀)) Q,    Q(0) = 1
/// ```
///
/// for the [multiplier](Multipliers) Q over one step, and μ₁ is μ₀ moved by Q₁.
///
/// For a scheme that commutes with linear maps ([`Equivariant`]) it equals the [`Collective`](crate::Collective)
/// integrator with the same scheme to round-off. There is no lift to choose, and no fibre to drift along. Symplectic
/// schemes conserve the Casimirs up to an unbiased rounding error per step, if the multipliers override
/// [`coadjoint_change`](Multipliers::coadjoint_change), as quaternions and dual quaternions do.
///
/// This generalises the closed form of the collective midpoint rule. For every Runge–Kutta method it answers the
/// question that Ohsawa 2019, §5.1, leaves open: whether there is an integrator that is defined on the symplectic
/// leaves.
///
/// # Example
/// ```
/// use collective_integrators::{LiftFree, RungeKutta, Start};
/// use lie_poisson::{Covector, LiePoisson, So3, from_closure};
/// use momentum_map::Quaternions;
/// use nalgebra::Vector3;
/// let h = from_closure::<LiePoisson<So3>, _>(|Covector(pi)| pi.x * pi.x * 0.5 + pi.y * pi.y);
/// let gauss = LiftFree::new(RungeKutta::gauss(2)?, Quaternions, h);
/// let start = Covector(Vector3::new(1.0, 1.0, 1.0));
/// for sample in gauss.trajectory(&start, 0.1)?.take(1000) {
///     assert!((sample?.momentum.0.norm_squared() - 3.0).abs() < 1e-13);
/// }
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct LiftFree<S, M, H> {
    scheme: S,
    multipliers: M,
    hamiltonian: H,
}

impl<S: Equivariant, M: Multipliers, H> LiftFree<S, M, H> {
    /// Creates an integrator that applies the scheme to the multipliers.
    pub fn new(scheme: S, multipliers: M, hamiltonian: H) -> Self
    where
        H: Hamiltonian<M::Space>,
    {
        Self { scheme, multipliers, hamiltonian }
    }

    /// Returns the integrator with [`Compensated`] summation of μ.
    pub fn compensated(self) -> Compensated<Self> {
        Compensated(self)
    }

    /// Returns the scheme for the multipliers.
    pub fn scheme(&self) -> &S {
        &self.scheme
    }

    /// Returns the Hamiltonian h on 𝔤∗.
    pub fn hamiltonian(&self) -> &H {
        &self.hamiltonian
    }

    /// Advances μ₀ by one step. Returns μ₁ and the multiplier Q₁ of the step:
    ///
    /// ```text
    /// μ₁ = transport(Q₁, μ₀) = μ₀ + coadjoint_change(Q₁, μ₀)
    /// ```
    ///
    /// The multiplier is the motion of the group in the step, and therefore the increment of the attitude. It is the
    /// numerical solution of the equation for Q in the documentation of the [type](Self).
    ///
    /// # Errors
    /// Returns a [`StepError`] if the step has no result.
    #[cfg_attr(optimised, inline(always))]
    pub fn step_with_multiplier<T: Real>(
        &self,
        mu: &Point<M::Space, T>,
        step: f64,
        workspace: &mut MultiplierWorkspace<S, M, T>,
    ) -> WithMultiplier<Step<Point<M::Space, T>>, M, T>
    where
        H: Hamiltonian<M::Space, T>,
    {
        let motion = self.motion_by(
            mu,
            workspace,
            #[cfg_attr(optimised, inline(always))]
            |field, one, storage| self.advance::<T, _>(field, one, step, storage),
        )?;
        motion.end(mu)
    }

    /// Returns the increment of a step from (μ, e) for [`Compensated`] summation, with the multiplier Q₁ of the step:
    ///
    /// ```text
    /// (δμ, δe) = (coadjoint_change(Q₁, μ), coadjoint_change(Q₁, e))
    /// ```
    ///
    /// Here e is the part of μ + e that is below the round-off of μ. The multiplier Q₁ is computed from μ alone, and e
    /// moves with it. See [`increment`](Increments::increment).
    ///
    /// # Errors
    /// Returns a [`StepError`] if the step has no result.
    #[cfg_attr(optimised, inline(always))]
    pub fn increment_with_multiplier<T: Real>(
        &self,
        mu: &Point<M::Space, T>,
        e: &Point<M::Space, T>,
        step: f64,
        workspace: &mut MultiplierWorkspace<S, M, T>,
    ) -> WithMultiplier<Increment<Point<M::Space, T>>, M, T>
    where
        H: Hamiltonian<M::Space, T>,
    {
        let motion = self.motion_by(
            mu,
            workspace,
            #[cfg_attr(optimised, inline(always))]
            |field, one, storage| self.refined_advance::<T, _>(field, one, step, storage),
        )?;
        Ok((self.increment_by(&motion, e), motion.multiplier))
    }

    /// Returns the increment of (μ, e) by the motion of μ in a step.
    #[cfg_attr(optimised, inline(always))]
    pub(crate) fn increment_by<T: Real>(
        &self,
        motion: &MultiplierMotion<M, T>,
        e: &Point<M::Space, T>,
    ) -> Increment<Point<M::Space, T>> {
        let rest = self.multipliers.coadjoint_change::<T>(&motion.multiplier, e);
        Step { point: Pair(motion.change, rest), iterations: motion.iterations }
    }

    /// Returns the multiplier after a step from Q = 1 with the field of multipliers, in whatever form it is given.
    #[cfg_attr(optimised, inline(always))]
    pub(crate) fn advance<T: Real, F: VectorField<T, Point = Multiplier<M, T>>>(
        &self,
        field: &F,
        one: &Multiplier<M, T>,
        step: f64,
        storage: &mut S::Workspace<Multiplier<M, T>>,
    ) -> Result<Step<Multiplier<M, T>>, StepError> {
        let next = self.scheme.increment::<T, _>(field, one, step, storage)?;
        Ok(Step { point: *one + next.point, iterations: next.iterations })
    }

    /// Returns the multiplier after a step from Q = 1 with unbiased rounding errors.
    #[cfg_attr(optimised, inline(always))]
    pub(crate) fn refined_advance<T: Real, F: VectorField<T, Point = Multiplier<M, T>>>(
        &self,
        field: &F,
        one: &Multiplier<M, T>,
        step: f64,
        storage: &mut S::Workspace<Multiplier<M, T>>,
    ) -> Result<Step<Multiplier<M, T>>, StepError> {
        let exact = Vector::zero();
        let next = self.scheme.refined_increment::<T, _>(field, (one, &exact), step, storage)?;
        let Pair(change, rest) = next.point;
        Ok(Step { point: *one + (change + rest), iterations: next.iterations })
    }

    /// Returns the multiplier and the change of μ in one step that `make` computes from Q = 1.
    #[cfg_attr(optimised, inline(always))]
    pub(crate) fn motion_by<T: Real>(
        &self,
        mu: &Point<M::Space, T>,
        workspace: &mut MultiplierWorkspace<S, M, T>,
        make: impl FnOnce(
            &MultiplierField<'_, M, H, T>,
            &Multiplier<M, T>,
            &mut S::Workspace<Multiplier<M, T>>,
        ) -> Result<Step<Multiplier<M, T>>, StepError>,
    ) -> Result<MultiplierMotion<M, T>, StepError>
    where
        H: Hamiltonian<M::Space, T>,
    {
        let one = self.multipliers.one::<T>();
        let MultiplierWorkspace { scheme: storage, course } = workspace;
        let (moved, steps) = match course {
            Some(course) if course.goes_on_from(mu) => (course.moved, course.steps),
            _ => (one, 0),
        };
        *course = None;
        if steps == 0 {
            self.scheme.forget(storage);
        }
        let frame = (moved, self.multipliers.inverse::<T>(&moved));
        let (multipliers, hamiltonian) = (&self.multipliers, &self.hamiltonian);
        let continues = steps > 0;
        let field = MultiplierField { multipliers, hamiltonian, start: *mu, frame, continues };
        let Step { point: multiplier, iterations } = make(&field, &one, storage)?;
        let change = self.multipliers.coadjoint_change::<T>(&multiplier, mu);
        // Explicit methods make no iterations and predict nothing.
        if iterations > 0 {
            let moved = self.multipliers.product::<T>(&multiplier, &moved);
            *course = Some(Course { end: *mu + change, moved, steps: steps + 1 });
        }
        Ok(MultiplierMotion { multiplier, change, iterations })
    }
}

/// The record of successive steps of a multiplier.
type CourseOf<M, T> = Course<Point<<M as Multipliers>::Space, T>, Multiplier<M, T>>;

/// A step or an increment, with the multiplier of the step, or a [`StepError`].
pub type WithMultiplier<S, M, T> = Result<(S, Multiplier<M, T>), StepError>;

/// The motion of μ in a step.
pub(crate) struct MultiplierMotion<M: Multipliers, T: Real> {
    /// The multiplier Q₁ at the end of the step.
    pub(crate) multiplier: Multiplier<M, T>,
    /// The change of μ under the motion by Q₁.
    pub(crate) change: Point<M::Space, T>,
    pub(crate) iterations: usize,
}

impl<M: Multipliers, T: Real> MultiplierMotion<M, T> {
    /// Returns the end of the step, with the multiplier.
    #[cfg_attr(optimised, inline(always))]
    pub(crate) fn end(
        self,
        mu: &Point<M::Space, T>,
    ) -> WithMultiplier<Step<Point<M::Space, T>>, M, T> {
        let step = Step { point: *mu + self.change, iterations: self.iterations };
        Ok((step.finite()?, self.multiplier))
    }
}

/// The storage of a lift-free step: that of the scheme for multipliers, and a record of the earlier steps.
#[derive(Debug)]
pub struct MultiplierWorkspace<S: Scheme, M: Multipliers, T: Real = f64> {
    scheme: S::Workspace<Multiplier<M, T>>,
    course: Option<CourseOf<M, T>>,
}

impl<S, M, H, T> Integrator<T> for LiftFree<S, M, H>
where
    S: Equivariant,
    M: Multipliers,
    H: Hamiltonian<M::Space, T>,
    T: Real,
{
    type State = Point<M::Space, T>;
    type Momentum = Point<M::Space, T>;
    type Workspace = MultiplierWorkspace<S, M, T>;

    fn workspace(&self) -> Self::Workspace {
        MultiplierWorkspace { scheme: self.scheme.workspace(), course: None }
    }

    #[cfg_attr(optimised, inline(always))]
    fn forget(&self, workspace: &mut Self::Workspace) {
        workspace.course = None;
    }

    #[cfg_attr(optimised, inline(always))]
    fn step(
        &self,
        mu: &Self::State,
        step: f64,
        workspace: &mut Self::Workspace,
    ) -> Result<Step<Self::State>, StepError> {
        Ok(self.step_with_multiplier::<T>(mu, step, workspace)?.0)
    }

    #[cfg_attr(optimised, inline(always))]
    fn momentum(&self, mu: &Self::State) -> Self::Momentum {
        *mu
    }
}

impl<S, M, H, T> Increments<T> for LiftFree<S, M, H>
where
    S: Equivariant,
    M: Multipliers,
    H: Hamiltonian<M::Space, T>,
    T: Real,
{
    /// Returns δμ, the change of μ under the motion by Q₁, which conserves Casimirs for every rounding of Q₁.
    ///
    /// Only the real part of Q₁ = 1 + … is rounded at size 1. This changes the motion by h times a rounding error.
    #[cfg_attr(optimised, inline(always))]
    fn increment(
        &self,
        Pair(mu, e): &Pair<Self::State, Self::State>,
        step: f64,
        workspace: &mut Self::Workspace,
    ) -> Result<Increment<Self::State>, StepError> {
        Ok(self.increment_with_multiplier::<T>(mu, e, step, workspace)?.0)
    }
}

impl<S, M, H> StateIsMomentum for LiftFree<S, M, H> {}
