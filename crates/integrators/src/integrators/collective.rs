//! The collective integrator: [`Collective`].

use crate::error::StepError;
use crate::integrators::compensated::{Compensated, Increments};
use crate::integrators::finite_momentum::has_finite_momentum;
use crate::integrators::recentring_threshold::{RecentringThreshold, moves_along};
use crate::integrators::trajectories::integrator::Integrator;
use crate::integrators::trajectories::start::Start;
use crate::schemes::scheme::{Equivariant, Increment, Scheme, Step};
use crate::sums::two_sum::exact_sum;
use crate::vector_field::{VectorField, dual_differential};
use lie_poisson::{DualNumber, Hamiltonian, Mask, Pair, Real, Vector, derivative_part, seed};
use momentum_map::{
    CollectiveHamiltonian, Far, Lift, LiftError, PoissonMap, RecentringWorkspace, SourcePoint,
    TargetPoint,
};

/// The collective integrator: a scheme for the Hamiltonian h∘M on the source P of a realisation M: P → 𝔤∗.
///
/// If the scheme Φ_h is symplectic and [`Equivariant`], then μ ↦ M(Φ_h(z)) with M(z) = μ is a Poisson map of 𝔤∗ that
/// does not depend on the lift z: a *collective Lie–Poisson integrator*. It conserves the Casimirs. A few maps M need
/// one more condition; [`descends`](Self::descends) reports whether it holds.
///
/// Source: McLachlan, Modin & Verdier, *Collective symplectic integrators*, Nonlinearity 27
/// (2014); Ohsawa 2019, §5.1.
///
/// # Example
/// A realisation of so(3)∗ by the angular momentum L = q × p:
/// ```
/// use collective_integrators::{Collective, Integrator, RungeKutta};
/// use lie_poisson::{Covector, LiePoisson, Point, RealSpace, Real, So3, from_closure};
/// use momentum_map::{Cotangent, CotangentBundle, PoissonMap};
/// use nalgebra::Vector3;
///
/// #[derive(Clone)]
/// struct AngularMomentum;
/// type Phase = CotangentBundle<RealSpace<3>>;
/// impl PoissonMap for AngularMomentum {
///     type Source = Phase;
///     type Target = LiePoisson<So3>;
///     fn source(&self) -> Phase { CotangentBundle(RealSpace) }
///     fn target(&self) -> LiePoisson<So3> { LiePoisson::plus(So3) }
///     fn apply<T: Real>(&self, z: &Point<Phase, T>) -> Covector<Vector3<T>> {
///         Covector(z.q.cross(&z.p.0))
///     }
/// }
/// let h = from_closure::<LiePoisson<So3>, _>(|Covector(l)| l.x * l.x * 0.5 + l.y * l.y);
/// let integrator = Collective::new(RungeKutta::implicit_midpoint(), AngularMomentum, h);
/// let z = Cotangent::new(Vector3::x(), Covector(Vector3::new(0.5, 2.0, 1.0)));
/// let before = AngularMomentum.apply(&z).0.norm();
/// for sample in integrator.trajectory_from(z, 0.1).take(100) {
///     assert!((sample?.momentum.0.norm() - before).abs() < 1e-13);
/// }
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Collective<S, M, H> {
    scheme: S,
    system: CollectiveHamiltonian<M, H>,
    /// Which z are moved along their fibres; `None` if none may be moved.
    moves: Option<Far>,
}

impl<S: Equivariant, M: PoissonMap, H> Collective<S, M, H> {
    /// Creates an integrator from a scheme that commutes with affine maps, as its bound [`Equivariant`] states.
    ///
    /// Its steps descend to 𝔤∗ if the map allows it: see [`PoissonMap::equivariant_maps_descend`]. This is so for most
    /// maps. For others, such as a `ClebschMap` of a representation that lacks its odd powers, the image of a step
    /// depends on z by an error of the order of the scheme, and the Casimirs are conserved to that order. The error
    /// grows with powers of |z|. So z is moved along its fibre as soon as it has grown by half.
    /// [`descends`](Self::descends) reports which of the two cases applies.
    pub fn new(scheme: S, map: M, hamiltonian: H) -> Self
    where
        H: Hamiltonian<M::Target>,
    {
        Self::of_field(scheme, map, hamiltonian)
    }

    /// Creates an integrator whose field is of any kind.
    pub(crate) fn of_field(scheme: S, map: M, field: H) -> Self {
        let moves = Some(moves_along(&map));
        Self { scheme, system: CollectiveHamiltonian::new(map, field), moves }
    }
}

impl<S: Scheme, M: PoissonMap, H> Collective<S, M, H> {
    /// Creates an integrator from a scheme that need not descend to 𝔤∗, for comparison.
    ///
    /// A step z ↦ Φ(z) on P gives a map of 𝔤∗ if M(Φ(z)) depends on M(z) alone, that is, if Φ carries fibres of M to
    /// fibres. Fibre symmetries are linear and mix q and p, for example χ ↦ χ + bψ on T∗C². A partitioned scheme treats
    /// q and p differently and does not commute with them, even if it is symplectic. Its result depends on the lift,
    /// and Noether's theorem, which would make the Casimirs constant, does not apply. Symplecticity on P alone is not
    /// enough.
    ///
    /// The table shows the experiment of Ohsawa 2019, §5.2, over 1000 steps of 1/50, where f₁ = 1. Runge–Kutta methods
    /// conserve f₁ to round-off. The two lifts z and z − (5/2)(ψ, 0) have the same momentum.
    ///
    /// | scheme | change of f₁ | two lifts, after one step |
    /// |---|---|---|
    /// | symplectic Euler, implicit in p; in q | −0.98; +33.9 | 2.7e-3; 2.8e-3 apart |
    /// | Störmer–Verlet | −0.033 | 1.7e-5 apart |
    /// | Lobatto IIIA–IIIB, 3 stages | 8e-8 | 4.1e-10 apart |
    ///
    /// This constructor exists to demonstrate this behaviour. Otherwise use [`new`](Self::new), which does not accept
    /// such schemes. The integrator never moves z along its fibre.
    ///
    /// ```compile_fail
    /// use collective_integrators::{Collective, FirstHalf, PartitionedRungeKutta};
    /// # use lie_poisson::{Covector, LiePoisson, So3, from_closure};
    /// # use momentum_map::HOPF;
    /// # let h = from_closure::<LiePoisson<So3>, _>(|Covector(pi)| pi.x * pi.y);
    /// let verlet = PartitionedRungeKutta::<FirstHalf>::kick_drift_kick();
    /// let integrator = Collective::new(verlet, HOPF, h); // not Equivariant
    /// ```
    /// ```
    /// use collective_integrators::{Alternating, Collective, PartitionedRungeKutta};
    /// # use lie_poisson::{Covector, LiePoisson, So3, from_closure};
    /// # use momentum_map::HOPF;
    /// # let h = from_closure::<LiePoisson<So3>, _>(|Covector(pi)| pi.x * pi.y);
    /// let verlet = PartitionedRungeKutta::<Alternating>::kick_drift_kick();
    /// let integrator = Collective::that_does_not_descend(verlet, HOPF, h);
    /// ```
    ///
    /// Source: McLachlan, Modin & Verdier, Nonlinearity 27 (2014), Thm. 3.2. Ohsawa 2019, §5.1, says that any
    /// symplectic scheme will do, but an equivariant one is required.
    pub fn that_does_not_descend(scheme: S, map: M, hamiltonian: H) -> Self
    where
        H: Hamiltonian<M::Target>,
    {
        Self { scheme, system: CollectiveHamiltonian::new(map, hamiltonian), moves: None }
    }
}

impl<S, M, H> Collective<S, M, H> {
    /// Returns the scheme on P.
    pub fn scheme(&self) -> &S {
        &self.scheme
    }

    /// Returns whether the steps descend to 𝔤∗: whether M(Φ(z)) depends on M(z) alone.
    ///
    /// It is true for an [`Equivariant`] scheme and a map whose
    /// [`equivariant_maps_descend`](PoissonMap::equivariant_maps_descend) is true.
    pub const fn descends(&self) -> bool {
        matches!(self.moves, Some(Far::Digits))
    }

    /// Returns the system h∘M, with M and h.
    pub fn system(&self) -> &CollectiveHamiltonian<M, H> {
        &self.system
    }
}

impl<S, M: PoissonMap, H> Collective<S, M, H> {
    /// Returns the integrator with [`Compensated`] summation of z.
    pub fn compensated(self) -> Compensated<Self> {
        Compensated(self)
    }

    /// Returns the displacement from z to the point of its fibre from which the next step starts, if z may move.
    #[cfg_attr(optimised, inline(always))]
    fn gauge<T: Real>(&self, z: &SourcePoint<M, T>, pinned: bool) -> SourcePoint<M, T> {
        if self.moves.is_some() && !pinned { self.system.map.gauge::<T>(z) } else { Vector::zero() }
    }
}

/// The collective vector field X(z) = generator(dh(M(z)), z) on P, which is the Hamiltonian vector field of h∘M.
///
/// It needs no derivative of M if the map implements its generator.
impl<M, H, T> VectorField<T> for CollectiveHamiltonian<M, H>
where
    M: PoissonMap,
    H: Hamiltonian<M::Target, T>,
    T: Real,
{
    type Point = SourcePoint<M, T>;

    #[cfg_attr(optimised, inline(always))]
    fn at(&self, z: &Self::Point) -> Self::Point {
        self.map.generator::<T>(&self.hamiltonian.differential(&self.map.apply::<T>(z)), z)
    }

    fn derivative(&self, z: &Self::Point, v: &Self::Point) -> Option<Self::Point> {
        let moved: SourcePoint<M, DualNumber<T>> = seed(z, v);
        let image = self.map.apply::<DualNumber<T>>(&moved);
        let dh = dual_differential::<M::Target, T, _>(&self.hamiltonian, &image)?;
        Some(derivative_part(&self.map.generator::<DualNumber<T>>(&dh, &moved)))
    }
}

/// The storage of a step of [`Collective`]: the storage of the scheme, and the data for moving z along its fibre.
#[derive(Clone, Debug)]
pub struct CollectiveWorkspace<W, V: Vector> {
    scheme: W,
    threshold: RecentringThreshold<V>,
    recentring: RecentringWorkspace<V::Scalar>,
    /// Whether z stays where the scheme takes it on its fibre.
    pinned: bool,
}

impl<W, V: Vector> CollectiveWorkspace<W, V> {
    /// Keeps z where the scheme takes it on its fibre.
    pub(crate) const fn pin(&mut self) {
        self.pinned = true;
    }
}

/// The storage of a step of a [`Collective`] integrator with scheme `S` and map `M`.
pub(crate) type SpaceOf<S, M, T> =
    CollectiveWorkspace<<S as Scheme>::Workspace<SourcePoint<M, T>>, SourcePoint<M, T>>;

impl<S: Scheme, M: PoissonMap, H> Collective<S, M, H> {
    /// Returns the storage of the steps, whatever the field.
    pub(crate) fn workspace_of<T: Real>(&self) -> SpaceOf<S, M, T> {
        CollectiveWorkspace {
            scheme: self.scheme.workspace(),
            threshold: RecentringThreshold::default(),
            recentring: RecentringWorkspace::new(self.moves.unwrap_or_default()),
            pinned: false,
        }
    }

    /// Forgets what the steps have learned of the run before.
    #[cfg_attr(optimised, inline(always))]
    pub(crate) fn forget_of<T: Real>(&self, workspace: &mut SpaceOf<S, M, T>) {
        self.scheme.forget(&mut workspace.scheme);
        workspace.threshold = RecentringThreshold::default();
    }

    /// Forgets the stages of the steps before, but not how far z may move along its fibre.
    #[cfg_attr(optimised, inline(always))]
    pub(crate) fn forget_stages_of<T: Real>(&self, workspace: &mut SpaceOf<S, M, T>) {
        self.scheme.forget(&mut workspace.scheme);
    }

    /// Returns the point of the fibre through z from which a step starts.
    ///
    /// It is z itself, or a point nearer to the origin if a run begins with a z far from the origin, or if z has grown.
    #[cfg_attr(optimised, inline(always))]
    fn recentred<T: Real>(
        &self,
        z: &SourcePoint<M, T>,
        workspace: &mut SpaceOf<S, M, T>,
    ) -> SourcePoint<M, T> {
        let mut moved = *z;
        if let (Some(far), false) = (self.moves, workspace.pinned) {
            let CollectiveWorkspace { threshold, recentring, .. } = workspace;
            threshold.recentre_if_grown(
                &mut moved,
                far,
                #[cfg_attr(optimised, inline(always))]
                |moved, grown| {
                    let near = self.system.map.recentred::<T>(z, recentring);
                    *moved = Vector::select(grown, &near, z);
                },
            );
        }
        moved
    }

    /// Makes a step with the collective vector field, in whatever form it is given.
    #[cfg_attr(optimised, inline(always))]
    pub(crate) fn step_of<T: Real, F: VectorField<T, Point = SourcePoint<M, T>>>(
        &self,
        field: &F,
        state: &SourcePoint<M, T>,
        step: f64,
        workspace: &mut SpaceOf<S, M, T>,
    ) -> Result<Step<SourcePoint<M, T>>, StepError> {
        let start = self.recentred::<T>(state, workspace);
        let Step { point: change, iterations } =
            self.scheme.increment::<T, _>(field, &start, step, &mut workspace.scheme)?;
        let end = start + change;
        let point = end + self.gauge::<T>(&end, workspace.pinned);
        self.require_momentum::<T>(&point)?;
        Ok(Step { point, iterations })
    }

    #[cfg_attr(optimised, inline(always))]
    fn require_momentum<T: Real>(&self, z: &SourcePoint<M, T>) -> Result<(), StepError> {
        if has_finite_momentum::<M, T>(&self.system.map, z) {
            Ok(())
        } else {
            Err(StepError::NotFinite)
        }
    }

    /// Returns the increment of a step with the collective vector field, in whatever form it is given.
    #[cfg_attr(optimised, inline(always))]
    pub(crate) fn increment_of<T: Real, F: VectorField<T, Point = SourcePoint<M, T>>>(
        &self,
        field: &F,
        Pair(state, e): &Pair<SourcePoint<M, T>, SourcePoint<M, T>>,
        step: f64,
        workspace: &mut SpaceOf<S, M, T>,
    ) -> Result<Increment<SourcePoint<M, T>>, StepError> {
        self.increment_by::<T>(
            state,
            workspace,
            #[cfg_attr(optimised, inline(always))]
            |start, scheme| self.scheme.refined_increment::<T, _>(field, (start, e), step, scheme),
        )
    }

    /// Returns the increment from a state, by a function that makes that of the scheme from where the step starts.
    #[cfg_attr(optimised, inline(always))]
    pub(crate) fn increment_by<T: Real>(
        &self,
        state: &SourcePoint<M, T>,
        workspace: &mut SpaceOf<S, M, T>,
        increment: impl FnOnce(
            &SourcePoint<M, T>,
            &mut S::Workspace<SourcePoint<M, T>>,
        ) -> Result<Increment<SourcePoint<M, T>>, StepError>,
    ) -> Result<Increment<SourcePoint<M, T>>, StepError> {
        let start = self.recentred::<T>(state, workspace);
        let Step { point: Pair(change, rest), iterations } =
            increment(&start, &mut workspace.scheme)?;
        self.require_momentum::<T>(&(start + change))?;
        if start == *state {
            return Ok(Step { point: Pair(change, rest), iterations });
        }
        let Pair(moved, below) = exact_sum(&start, &-*state);
        let Pair(change, lost) = exact_sum(&moved, &change);
        Ok(Step { point: Pair(change, rest + below + lost), iterations })
    }

    /// Returns z + e + gauge(z + e), to first order in e.
    ///
    /// The derivative of a gauge, such as that of a power of two, may have no meaning except along the fibre. M is
    /// constant there.
    #[cfg_attr(optimised, inline(always))]
    pub(crate) fn gauged_of<T: Real>(
        &self,
        state: Pair<SourcePoint<M, T>, SourcePoint<M, T>>,
        workspace: &SpaceOf<S, M, T>,
    ) -> Pair<SourcePoint<M, T>, SourcePoint<M, T>> {
        let Pair(z, carry) = state;
        let slide = self.gauge::<T>(&z, workspace.pinned);
        let still = slide.max_norm().at_most(T::zero());
        if still.all() {
            return state;
        }
        let slides: SourcePoint<M, DualNumber<T>> =
            self.gauge::<DualNumber<T>>(&seed(&z, &carry), false);
        let along: SourcePoint<M, T> = derivative_part(&slides);
        let Pair(slid, rounding) = exact_sum(&z, &slide);
        Vector::select(still, &state, &Pair(slid, carry + along + rounding))
    }
}

impl<S, M, H, T> Integrator<T> for Collective<S, M, H>
where
    S: Scheme,
    M: PoissonMap,
    H: Hamiltonian<M::Target, T>,
    T: Real,
{
    type State = SourcePoint<M, T>;
    type Momentum = TargetPoint<M, T>;
    type Workspace = SpaceOf<S, M, T>;

    fn workspace(&self) -> Self::Workspace {
        self.workspace_of::<T>()
    }

    #[cfg_attr(optimised, inline(always))]
    fn step(
        &self,
        state: &Self::State,
        step: f64,
        workspace: &mut Self::Workspace,
    ) -> Result<Step<Self::State>, StepError> {
        self.step_of::<T, _>(&self.system, state, step, workspace)
    }

    #[cfg_attr(optimised, inline(always))]
    fn forget(&self, workspace: &mut Self::Workspace) {
        self.forget_of::<T>(workspace);
    }

    fn pin(&self, workspace: &mut Self::Workspace) {
        workspace.pin();
    }

    #[cfg_attr(optimised, inline(always))]
    fn momentum(&self, state: &Self::State) -> Self::Momentum {
        self.system.map.apply::<T>(state)
    }
}

impl<S, M, H, T> Increments<T> for Collective<S, M, H>
where
    S: Scheme,
    M: PoissonMap,
    H: Hamiltonian<M::Target, T>,
    T: Real,
{
    #[cfg_attr(optimised, inline(always))]
    fn increment(
        &self,
        state: &Pair<Self::State, Self::State>,
        step: f64,
        workspace: &mut Self::Workspace,
    ) -> Result<Increment<Self::State>, StepError> {
        self.increment_of::<T, _>(&self.system, state, step, workspace)
    }

    #[cfg_attr(optimised, inline(always))]
    fn gauged(
        &self,
        state: Pair<Self::State, Self::State>,
        workspace: &Self::Workspace,
    ) -> Pair<Self::State, Self::State> {
        self.gauged_of::<T>(state, workspace)
    }
}

impl<S, M, H, T> Start<T> for Collective<S, M, H>
where
    S: Scheme,
    M: Lift,
    H: Hamiltonian<M::Target, T>,
    T: Real,
{
    /// Returns the lift of μ.
    fn start(&self, mu: &Self::Momentum) -> Result<Self::State, LiftError> {
        self.system.map.lift::<T>(mu)
    }
}
