//! The collective integrator for N copies of a realisation: [`CollectiveSites`].

use crate::error::StepError;
use crate::integrators::finite_momentum::has_finite_momentum;
use crate::integrators::recentring_threshold::{RecentringThreshold, moves_along};
use crate::integrators::trajectories::integrator::Integrator;
use crate::integrators::trajectories::start::Start;
use crate::schemes::scheme::{Equivariant, Scheme, Step};
use crate::vector_field::VectorField;
use lie_poisson::{Covector, LieAlgebra, LiePoisson, Real, Sites, SitesHamiltonian, State, Vector};
use momentum_map::{Far, Lift, LiftError, PoissonMap, RecentringWorkspace, SourcePoint};
use std::cell::RefCell;

/// The [collective integrator](crate::Collective) for N copies of a realisation M: P → 𝔤∗, with a number N that is
/// known when the program runs.
///
/// The state is z = (z₁, …, z_N) ∈ Pᴺ, and μ_i = M(z_i). For a symplectic scheme the integrator is a Poisson map of
/// (𝔤∗)ᴺ, of any order, and conserves the Casimirs of each μ_i. The sign of the bracket is that of the target of M: a
/// Hamiltonian that is meant for the other bracket gives the motion backwards in time. After the first step it
/// allocates nothing, unless a step needs Newton's iteration.
///
/// # Example
/// A ring of spins with the minus bracket, that of `HOPF`, by Gauss's method of order 4:
/// ```
/// use collective_integrators::{CollectiveSites, Integrator, RungeKutta, Start};
/// use lie_poisson::{Covector, Real, Sites, SitesHamiltonian};
/// use momentum_map::HOPF;
/// use nalgebra::Vector3;
/// # struct Ring;
/// # impl<T: Real> SitesHamiltonian<Vector3<T>> for Ring {
/// #     fn value(&self, s: &Covector<Sites<Vector3<T>>>) -> T {
/// #         let next = s.0.iter().cycle().skip(1);
/// #         s.0.iter().zip(next).fold(T::zero(), |sum, (s, next)| sum - s.dot(next))
/// #     }
/// #     fn differential_into(&self, s: &Covector<Sites<Vector3<T>>>, dh: &mut Sites<Vector3<T>>) {
/// #         let n = s.0.len();
/// #         for (i, dh) in dh.iter_mut().enumerate() {
/// #             *dh = -s.0[(i + n - 1) % n] - s.0[(i + 1) % n];
/// #         }
/// #     }
/// # }
/// // Ring is h(s) = −Σ s_i·s_(i+1)
/// let gauss = CollectiveSites::new(RungeKutta::gauss(2)?, HOPF, Ring);
/// let spins: Sites<_> = (0..10).map(|i| Vector3::new(f64::from(i).cos(), f64::from(i).sin(), 0.5)).collect();
/// let mut z = gauss.start(&Covector(spins.clone()))?;
/// let mut workspace = gauss.workspace();
/// for _ in 0..100 {
///     gauss.step_in_place(&mut z, 0.1, &mut workspace)?;
/// }
/// let after = gauss.momentum(&z);
/// assert!((after.0[3].norm() - spins[3].norm()).abs() < 1e-14);
/// assert!((Ring.value(&after) - Ring.value(&Covector(spins))).abs() < 1e-4);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct CollectiveSites<S, M, H> {
    scheme: S,
    map: M,
    hamiltonian: H,
    /// Which z are moved along their fibres; `None` if none may be moved.
    moves: Option<Far>,
}

impl<S: Equivariant, M: PoissonMap, H> CollectiveSites<S, M, H> {
    /// Creates an integrator from a scheme on Pᴺ, the map M of one site and a [`SitesHamiltonian`].
    ///
    /// Its steps descend to (𝔤∗)ᴺ if the map allows it: see [`Collective::new`](crate::Collective::new).
    pub fn new(scheme: S, map: M, hamiltonian: H) -> Self {
        let moves = Some(moves_along(&map));
        Self { scheme, map, hamiltonian, moves }
    }
}

impl<S, M, H> CollectiveSites<S, M, H> {
    /// Returns the scheme on Pᴺ.
    pub fn scheme(&self) -> &S {
        &self.scheme
    }

    /// Returns the map M of one site.
    pub fn map(&self) -> &M {
        &self.map
    }

    /// Returns the Hamiltonian h.
    pub fn hamiltonian(&self) -> &H {
        &self.hamiltonian
    }
}

/// The storage of a step of [`CollectiveSites`].
#[derive(Debug)]
pub struct CollectiveSitesWorkspace<W, V: Vector, D> {
    scheme: W,
    velocities: RefCell<(Covector<Sites<D>>, Sites<D>)>,
    pool: Vec<Sites<V>>,
    threshold: RecentringThreshold<Sites<V>>,
    recentring: RecentringWorkspace<V::Scalar>,
    /// Whether each point stays where the scheme takes it on its fibre.
    pinned: bool,
}

/// The vector field generator(dh_i(M(z)), z_i) at every site.
struct SitesField<'a, M, H, D> {
    map: &'a M,
    hamiltonian: &'a H,
    velocities: &'a RefCell<(Covector<Sites<D>>, Sites<D>)>,
}

impl<M, H, A, T> VectorField<T> for SitesField<'_, M, H, A::Element<T>>
where
    M: PoissonMap<Target = LiePoisson<A>>,
    H: SitesHamiltonian<A::Element<T>>,
    A: LieAlgebra,
    T: Real,
{
    type Point = Sites<SourcePoint<M, T>>;

    fn at(&self, z: &Self::Point) -> Self::Point {
        let mut value = z.zeros_like();
        self.at_into(z, &mut value);
        value
    }

    fn at_into(&self, z: &Self::Point, value: &mut Self::Point) {
        let (mu, dh) = &mut *self.velocities.borrow_mut();
        if mu.0.len() != z.len() {
            *mu = State::zeros_of(&z.len());
            *dh = State::zeros_of(&z.len());
        }
        mu.0.iter_mut().zip(z.iter()).for_each(|(mu, z)| *mu = self.map.apply::<T>(z).0);
        self.hamiltonian.differential_into(mu, dh);
        for ((value, z), dh) in value.iter_mut().zip(z.iter()).zip(dh.iter()) {
            *value = self.map.generator::<T>(dh, z);
        }
    }
}

impl<S, M: PoissonMap, H> CollectiveSites<S, M, H> {
    /// Moves each z_i near to the origin of its fibre if a run begins, or if z has grown.
    fn recentre<T: Real, W, D>(
        &self,
        z: &mut Sites<SourcePoint<M, T>>,
        workspace: &mut CollectiveSitesWorkspace<W, SourcePoint<M, T>, D>,
    ) {
        if let (Some(far), false) = (self.moves, workspace.pinned) {
            let CollectiveSitesWorkspace { threshold, recentring, .. } = workspace;
            threshold.recentre_if_grown(z, far, |z, grown| {
                for z in z.iter_mut() {
                    *z = Vector::select(grown, &self.map.recentred::<T>(z, recentring), z);
                }
            });
        }
    }
}

impl<S, M, H, A, T> Integrator<T> for CollectiveSites<S, M, H>
where
    S: Scheme,
    M: PoissonMap<Target = LiePoisson<A>>,
    H: SitesHamiltonian<A::Element<T>>,
    A: LieAlgebra,
    T: Real,
{
    type State = Sites<SourcePoint<M, T>>;
    type Momentum = Covector<Sites<A::Element<T>>>;
    type Workspace = CollectiveSitesWorkspace<
        S::Workspace<Sites<SourcePoint<M, T>>>,
        SourcePoint<M, T>,
        A::Element<T>,
    >;

    fn workspace(&self) -> Self::Workspace {
        CollectiveSitesWorkspace {
            scheme: self.scheme.workspace(),
            velocities: RefCell::new((State::zeros_of(&0), State::zeros_of(&0))),
            pool: Vec::new(),
            threshold: RecentringThreshold::default(),
            recentring: RecentringWorkspace::new(self.moves.unwrap_or_default()),
            pinned: false,
        }
    }

    fn step(
        &self,
        state: &Self::State,
        step: f64,
        workspace: &mut Self::Workspace,
    ) -> Result<Step<Self::State>, StepError> {
        Step::of_copy(state, |z| Integrator::<T>::step_in_place(self, z, step, workspace))
    }

    fn step_in_place(
        &self,
        state: &mut Self::State,
        step: f64,
        workspace: &mut Self::Workspace,
    ) -> Result<usize, StepError> {
        let mut z = State::take(&mut workspace.pool, state);
        z.assign(state);
        self.recentre::<T, _, _>(&mut z, workspace);
        let CollectiveSitesWorkspace { scheme, velocities, pool, pinned, .. } = workspace;
        let field = SitesField { map: &self.map, hamiltonian: &self.hamiltonian, velocities };
        let made = self.scheme.increment::<T, _>(&field, &z, step, scheme).and_then(|made| {
            z.add_in_place(&made.point);
            if let Some(temporaries) = self.scheme.temporaries(scheme) {
                made.point.give(temporaries);
            }
            if self.moves.is_some() && !*pinned {
                z.iter_mut().for_each(|z| *z += self.map.gauge::<T>(z));
            }
            let finite = z.iter().all(|z| has_finite_momentum::<M, T>(&self.map, z));
            if finite { Ok(made.iterations) } else { Err(StepError::NotFinite) }
        });
        if made.is_ok() {
            state.move_from(&mut z);
        }
        z.give(pool);
        made
    }

    fn forget(&self, workspace: &mut Self::Workspace) {
        self.scheme.forget(&mut workspace.scheme);
        workspace.threshold = RecentringThreshold::default();
    }

    fn pin(&self, workspace: &mut Self::Workspace) {
        workspace.pinned = true;
    }

    fn momentum(&self, state: &Self::State) -> Self::Momentum {
        Covector(state.iter().map(|z| self.map.apply::<T>(z).0).collect())
    }
}

impl<S, M, H, A, T> Start<T> for CollectiveSites<S, M, H>
where
    S: Scheme,
    M: Lift<Target = LiePoisson<A>>,
    H: SitesHamiltonian<A::Element<T>>,
    A: LieAlgebra,
    T: Real,
{
    /// Returns the lift of each μ_i.
    fn start(&self, mu: &Self::Momentum) -> Result<Self::State, LiftError> {
        mu.0.iter()
            .map(|mu| self.map.lift::<T>(&Covector(*mu)))
            .collect::<Result<Vec<_>, _>>()
            .map(Sites::new)
    }
}
