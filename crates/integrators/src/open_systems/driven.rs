//! The collective integrator of an orbit field: [`Driven`].

use crate::error::StepError;
use crate::integrators::collective::{Collective, SpaceOf};
use crate::integrators::compensated::{Compensated, Increments};
use crate::integrators::trajectories::integrator::Integrator;
use crate::integrators::trajectories::start::Start;
use crate::open_systems::smooth_pieces::{Window, smooth_pieces};
use crate::schemes::scheme::{Equivariant, Increment, Scheme, Step};
use crate::sums::two_sum::add_compensated;
use crate::vector_field::VectorField;
use lie_poisson::{OrbitField, Pair, Real, Time, TimeAxis, Vector};
use momentum_map::{Identity, Lift, LiftError, PoissonMap, ProductMap, SourcePoint, TargetPoint};

/// The map (M, id): P × R → 𝔤∗ × R of states (z, t).
type MapInTime<M> = ProductMap<M, Identity<TimeAxis>>;

/// The collective integrator of an [orbit field](OrbitField) ξ(μ, t): a scheme for
///
/// ```text
/// dz/dt = ξ(M(z), t)_P(z),    the infinitesimal generator of ξ on the source P of a realisation M: P → 𝔤∗
/// ```
///
/// The momenta of the fibre symmetry are conserved along it, because the two actions commute. They are quadratic in z, so that a
/// Runge–Kutta method that conserves quadratic invariants, such as Gauss's, conserves them, and with them the Casimirs, to
/// round-off, whatever ξ is, if the stages are solved to it. In each step they lose what the stages keep: where ξ itself has lost
/// digits, as sin(μ + ωt) has after a long time, its rounding errors; in steps of a radian some 1e-14, which add up, and in steps of two and more up to 1e-10. Steps
/// are Poisson maps only if ξ = `d_μ` h(μ, t), which [`TimeDependent`](lie_poisson::TimeDependent) has.
///
/// A momentum of this integrator is (μ, t) and a state (z, t): the time is a coordinate, at which stages are evaluated, and which
/// event functions see. A start has the time at which the run begins. A step that contains a [breakpoint](OrbitField::next_break)
/// of the field is divided there. In [lanes](crate::Laned) members whose breakpoints come at different times are advanced one by
/// one. In a run of many steps the time is best summed with [`compensated`](Self::compensated).
///
/// Source: McLachlan, Modin & Verdier, *Collective symplectic integrators*, Nonlinearity 27 (2014), for ξ = dh.
///
/// # Example
/// A spin in a static field e₃ and a rotating one, h = −Π₃ − (Π₁ cos t + Π₂ sin t)/5. In the frame that turns with the field, it
/// turns about the rotating field alone: after π/(1/5) it has gone from one pole to the other (Rabi).
/// ```
/// use collective_integrators::{Driven, RungeKutta, Start};
/// use lie_poisson::{Automatic, Covector, Energy, InTime, LiePoisson, Pair, Point, Real, So3, Time, TimeDependent};
/// use momentum_map::HOPF;
/// use nalgebra::Vector3;
/// use std::f64::consts::PI;
/// struct Resonance;
/// impl Energy for Resonance {
///     type Space = InTime<LiePoisson<So3>>;
///     fn energy<T: Real>(&self, Pair(Covector(pi), Time(t)): &Point<Self::Space, T>) -> T {
///         -pi.z - (pi.x * t.cos() + pi.y * t.sin()) * 0.2
///     }
/// }
/// let gauss = Driven::new(RungeKutta::gauss(4)?, HOPF, TimeDependent(Automatic(Resonance)));
/// let start = Pair(Covector(Vector3::z()), Time(0.0));
/// let Pair(Covector(pi), Time(t)) = gauss.after(&start, PI / 20.0, 100)?.momentum;
/// assert!((t - 5.0 * PI).abs() < 1e-13);
/// assert!((pi + Vector3::z()).norm() < 1e-9 && (pi.norm() - 1.0).abs() < 1e-14);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// [`Collective`] promises Poisson maps, and takes Hamiltonians alone:
/// ```compile_fail
/// use collective_integrators::{Collective, RungeKutta};
/// # use lie_poisson::{Autonomous, Covector, DoubleBracket, InnerProduct, LiePoisson, So3, from_closure};
/// # use momentum_map::HOPF;
/// # let h = from_closure::<LiePoisson<So3>, _>(|Covector(pi)| pi.x * pi.y);
/// let (space, inner_product) = (LiePoisson::minus(So3), InnerProduct::euclidean());
/// let damped = DoubleBracket::new(space, Autonomous(h), 0.1, inner_product)?;
/// let integrator = Collective::new(RungeKutta::implicit_midpoint(), HOPF, damped); // no Hamiltonian
/// # Ok::<(), lie_poisson::DissipationError>(())
/// ```
/// ```
/// use collective_integrators::{Driven, RungeKutta};
/// # use lie_poisson::{Autonomous, Covector, DoubleBracket, InnerProduct, LiePoisson, So3, from_closure};
/// # use momentum_map::HOPF;
/// # let h = from_closure::<LiePoisson<So3>, _>(|Covector(pi)| pi.x * pi.y);
/// let (space, inner_product) = (LiePoisson::minus(So3), InnerProduct::euclidean());
/// let damped = DoubleBracket::new(space, Autonomous(h), 0.1, inner_product)?;
/// let integrator = Driven::new(RungeKutta::implicit_midpoint(), HOPF, damped);
/// # Ok::<(), lie_poisson::DissipationError>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Driven<S, M, X> {
    collective: Collective<S, MapInTime<M>, X>,
}

impl<S: Equivariant, M: PoissonMap, X> Driven<S, M, X> {
    /// Creates an integrator from a scheme that commutes with affine maps.
    pub fn new(scheme: S, map: M, field: X) -> Self
    where
        X: OrbitField<M::Target>,
    {
        let map = ProductMap(map, Identity(TimeAxis));
        Self { collective: Collective::of_field(scheme, map, field) }
    }
}

impl<S, M, X> Driven<S, M, X> {
    /// Returns the scheme on P × R.
    pub fn scheme(&self) -> &S {
        self.collective.scheme()
    }

    /// Returns the map M.
    pub fn map(&self) -> &M {
        &self.collective.system().map.0
    }

    /// Returns the field ξ.
    pub fn field(&self) -> &X {
        &self.collective.system().hamiltonian
    }

    /// Returns whether the steps descend to 𝔤∗: whether M(Φ(z)) depends on M(z) alone.
    pub const fn descends(&self) -> bool {
        self.collective.descends()
    }
}

impl<S, M: PoissonMap, X> Driven<S, M, X> {
    /// Returns the integrator with [`Compensated`] summation of z and t. Its increments are those of the steps, and are not
    /// [refined](Scheme::refined_increment): the time has the rounding errors of a large number, which are no small errors for
    /// a field that varies within a unit of time.
    pub fn compensated(self) -> Compensated<Self> {
        Compensated(self)
    }
}

/// The vector field (ξ(M(z), t)_P(z), 1) at (z, t).
struct Generator<'a, M, X, T> {
    map: &'a M,
    field: &'a X,
    window: Window<T>,
}

impl<M, X, T> VectorField<T> for Generator<'_, M, X, T>
where
    M: PoissonMap,
    X: OrbitField<M::Target, T>,
    T: Real,
{
    type Point = SourcePoint<MapInTime<M>, T>;

    #[cfg_attr(optimised, inline(always))]
    fn at(&self, Pair(z, t): &Self::Point) -> Self::Point {
        let xi = self.field.element(&self.map.apply::<T>(z), self.window.nearest(t.0));
        Pair(self.map.generator::<T>(&xi, z), Time(T::one()))
    }
}

impl<S, M, X> Driven<S, M, X> {
    fn generator<T>(&self, window: Window<T>) -> Generator<'_, M, X, T> {
        Generator { map: self.map(), field: self.field(), window }
    }

    fn next_break<T: Real>(&self) -> impl Fn(f64, bool) -> Option<f64> + '_
    where
        M: PoissonMap,
        X: OrbitField<M::Target, T>,
    {
        |time, forward| self.field().next_break(time, forward)
    }
}

impl<S, M, X, T> Integrator<T> for Driven<S, M, X>
where
    S: Scheme,
    M: PoissonMap,
    X: OrbitField<M::Target, T>,
    T: Real,
{
    type State = SourcePoint<MapInTime<M>, T>;
    type Momentum = TargetPoint<MapInTime<M>, T>;
    type Workspace = SpaceOf<S, MapInTime<M>, T>;

    fn workspace(&self) -> Self::Workspace {
        self.collective.workspace_of::<T>()
    }

    #[cfg_attr(optimised, inline(always))]
    fn step(
        &self,
        state: &Self::State,
        step: f64,
        workspace: &mut Self::Workspace,
    ) -> Result<Step<Self::State>, StepError> {
        Step::of_copy(
            state,
            #[cfg_attr(optimised, inline(always))]
            |point| {
                smooth_pieces(
                    state.1.0,
                    step,
                    self.next_break::<T>(),
                    #[cfg_attr(optimised, inline(always))]
                    |window, _, step| {
                        let generator = self.generator(window);
                        let made =
                            self.collective.step_of::<T, _>(&generator, point, step, workspace)?;
                        *point = made.point;
                        Ok(made.iterations)
                    },
                )
            },
        )
    }

    #[cfg_attr(optimised, inline(always))]
    fn forget(&self, workspace: &mut Self::Workspace) {
        self.collective.forget_of::<T>(workspace);
    }

    fn pin(&self, workspace: &mut Self::Workspace) {
        workspace.pin();
    }

    #[cfg_attr(optimised, inline(always))]
    fn momentum(&self, Pair(z, t): &Self::State) -> Self::Momentum {
        Pair(self.map().apply::<T>(z), *t)
    }
}

impl<S, M, X, T> Increments<T> for Driven<S, M, X>
where
    S: Scheme,
    M: PoissonMap,
    X: OrbitField<M::Target, T>,
    T: Real,
{
    #[cfg_attr(optimised, inline(always))]
    fn increment(
        &self,
        state: &Pair<Self::State, Self::State>,
        step: f64,
        workspace: &mut Self::Workspace,
    ) -> Result<Increment<Self::State>, StepError> {
        let Pair(begin, _) = state;
        let (mut sum, mut rest) = (Vector::zero(), Vector::zero());
        let iterations =
            smooth_pieces(begin.1.0, step, self.next_break::<T>(), |window, _, step| {
                let (from, generator) = (*begin + sum, self.generator(window));
                let Step { point: Pair(change, lost), iterations } =
                    self.collective.increment_by::<T>(
                        &from,
                        workspace,
                        #[cfg_attr(optimised, inline(always))]
                        |start, scheme| {
                            let made = self.scheme().increment(&generator, start, step, scheme)?;
                            let Step { point, iterations } = made;
                            Ok(Step { point: Pair(point, Vector::zero()), iterations })
                        },
                    )?;
                add_compensated((&mut sum, &mut rest), (&change, &lost), &mut Default::default());
                Ok(iterations)
            })?;
        Ok(Step { point: Pair(sum, rest), iterations })
    }

    #[cfg_attr(optimised, inline(always))]
    fn gauged(
        &self,
        state: Pair<Self::State, Self::State>,
        workspace: &Self::Workspace,
    ) -> Pair<Self::State, Self::State> {
        self.collective.gauged_of::<T>(state, workspace)
    }
}

impl<S, M, X, T> Start<T> for Driven<S, M, X>
where
    S: Scheme,
    M: Lift,
    X: OrbitField<M::Target, T>,
    T: Real,
{
    /// Returns the lift of μ, and the time.
    fn start(&self, Pair(mu, t): &Self::Momentum) -> Result<Self::State, LiftError> {
        Ok(Pair(self.map().lift::<T>(mu)?, *t))
    }
}
