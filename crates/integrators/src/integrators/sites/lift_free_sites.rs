//! Collective methods without a lift for N copies of 𝔤∗: [`LiftFreeSites`].

use crate::error::StepError;
use crate::integrators::state_is_momentum::StateIsMomentum;
use crate::integrators::trajectories::integrator::Integrator;
use crate::schemes::scheme::{Equivariant, Step};
use crate::stage_frame::StageFrame;
use crate::stages::checkpoints::CHECKPOINT;
use crate::vector_field::VectorField;
use lie_poisson::{Covector, LieAlgebra, LiePoisson, Real, Sites, SitesHamiltonian, State};
use momentum_map::{Multiplier, Multipliers};
use std::cell::RefCell;

/// The [lift-free integrator](crate::LiftFree) for N copies of 𝔤∗, with a number N that is known when the program runs.
///
/// The state is μ = (μ₁, …, μ_N) ∈ (𝔤∗)ᴺ. The scheme solves
///
/// ```text
/// dQ_i/dt = ∂h/∂μ_i(ν) Q_i,    Q_i(0) = 1,    ν_j = transport(Q_j, μ_j)
/// ```
///
/// for the [multipliers](Multipliers) Q_i of all sites together, and moves each μ_i by its Q_i. For a symplectic scheme
/// it is a Poisson map of (𝔤∗)ᴺ, of any order, and conserves the Casimirs of each μ_i. It equals
/// [`CollectiveSites`](crate::CollectiveSites) with the same scheme to round-off; there is no lift to choose, and no
/// fibre to drift along. The sign of the bracket is that of the [space](Multipliers::space) of the multipliers. After
/// the first step it allocates nothing, unless a step needs Newton's iteration.
///
/// Source: as for [`LiftFree`](crate::LiftFree), this answers the question that Ohsawa 2019, §5.1, leaves open. The
/// multipliers of all sites form one element of a product of algebras.
///
/// # Example
/// A ring of spins, by Gauss's method of order 4 for N quaternions:
/// ```
/// use collective_integrators::{Integrator, LiftFreeSites, RungeKutta};
/// use lie_poisson::{Covector, Real, Sites, SitesHamiltonian};
/// use momentum_map::Quaternions;
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
/// let gauss = LiftFreeSites::new(RungeKutta::gauss(2)?, Quaternions, Ring);
/// let spin = |i: i32| Vector3::new(f64::from(i).cos(), f64::from(i).sin(), 0.5);
/// let mut spins = Covector((0..10).map(spin).collect::<Sites<_>>());
/// let before = spins.clone();
/// let mut workspace = gauss.workspace();
/// for _ in 0..100 {
///     gauss.step_in_place(&mut spins, 0.1, &mut workspace)?;
/// }
/// assert!((spins.0[3].norm() - before.0[3].norm()).abs() < 1e-14);
/// assert!((Ring.value(&spins) - Ring.value(&before)).abs() < 1e-4);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct LiftFreeSites<S, M, H> {
    scheme: S,
    multipliers: M,
    hamiltonian: H,
}

impl<S: Equivariant, M: Multipliers, H> LiftFreeSites<S, M, H> {
    /// Creates an integrator from a scheme for the multipliers, the multipliers of one site, and a
    /// [`SitesHamiltonian`].
    pub fn new(scheme: S, multipliers: M, hamiltonian: H) -> Self {
        Self { scheme, multipliers, hamiltonian }
    }

    /// Returns the scheme for the multipliers.
    pub fn scheme(&self) -> &S {
        &self.scheme
    }

    /// Returns the Hamiltonian h.
    pub fn hamiltonian(&self) -> &H {
        &self.hamiltonian
    }
}

/// The storage of a step of [`LiftFreeSites`].
#[derive(Debug)]
pub struct LiftFreeSitesWorkspace<W, Q, E> {
    scheme: W,
    velocities: RefCell<(Covector<Sites<E>>, Sites<E>)>,
    one: Sites<Q>,
    course: SitesCourse<Q, E>,
}

/// The record of successive steps, in whose coordinates the stages of all steps are one curve.
#[derive(Debug)]
struct SitesCourse<Q, E> {
    /// The momenta where the last step ended.
    end: Covector<Sites<E>>,
    /// The multipliers A_i of all the steps together, and their inverses.
    moved: Sites<Q>,
    back: Sites<Q>,
    /// The number of steps; 0 if the next one begins a course.
    steps: u64,
}

/// The vector field of the multipliers of all sites.
struct MultipliersField<'a, M: Multipliers, H, E, T: Real> {
    multipliers: &'a M,
    hamiltonian: &'a H,
    start: &'a Covector<Sites<E>>,
    velocities: &'a RefCell<(Covector<Sites<E>>, Sites<E>)>,
    /// The multipliers of the course and their inverses.
    frame: [&'a Sites<Multiplier<M, T>>; 2],
    continues: bool,
}

impl<M, H, A, T> VectorField<T> for MultipliersField<'_, M, H, A::Element<T>, T>
where
    M: Multipliers<Space = LiePoisson<A>>,
    H: SitesHamiltonian<A::Element<T>>,
    A: LieAlgebra,
    T: Real,
{
    type Point = Sites<Multiplier<M, T>>;

    fn at(&self, q: &Self::Point) -> Self::Point {
        let mut value = q.zeros_like();
        self.at_into(q, &mut value);
        value
    }

    fn at_into(&self, q: &Self::Point, value: &mut Self::Point) {
        let (mu, dh) = &mut *self.velocities.borrow_mut();
        for ((mu, q), start) in mu.0.iter_mut().zip(q.iter()).zip(self.start.0.iter()) {
            *mu = self.multipliers.transport::<T>(q, &Covector(*start)).0;
        }
        self.hamiltonian.differential_into(mu, dh);
        for ((value, q), dh) in value.iter_mut().zip(q.iter()).zip(dh.iter()) {
            *value = self.multipliers.generate::<T>(dh, q);
        }
    }

    fn stage_frame(&self) -> impl StageFrame<Self::Point> {
        self
    }
}

/// The frame of the course, in which the stage derivatives are k_i A_i.
impl<M, H, E, T> StageFrame<Sites<Multiplier<M, T>>> for &MultipliersField<'_, M, H, E, T>
where
    M: Multipliers,
    T: Real,
{
    fn continues(&self) -> bool {
        self.continues
    }

    fn remember(&self, k: &Sites<Multiplier<M, T>>, past: &mut Sites<Multiplier<M, T>>) {
        past.assign(k);
        multiply_by(self.multipliers, past, self.frame[0]);
    }

    fn recall(&self, k: &mut Sites<Multiplier<M, T>>) {
        multiply_by(self.multipliers, k, self.frame[1]);
    }
}

/// Replaces each q_i by q_i b_i.
fn multiply_by<M: Multipliers, T: Real>(
    multipliers: &M,
    q: &mut Sites<Multiplier<M, T>>,
    b: &Sites<Multiplier<M, T>>,
) {
    for (q, b) in q.iter_mut().zip(b.iter()) {
        *q = multipliers.product::<T>(q, b);
    }
}

impl<S, M, H> LiftFreeSites<S, M, H> {
    /// Prepares the storage for a step from μ.
    fn prepare<W, A, T>(
        &self,
        mu: &Covector<Sites<A::Element<T>>>,
        space: &mut LiftFreeSitesWorkspace<W, Multiplier<M, T>, A::Element<T>>,
    ) where
        M: Multipliers<Space = LiePoisson<A>>,
        A: LieAlgebra,
        T: Real,
    {
        let LiftFreeSitesWorkspace { velocities, one, course, .. } = space;
        let count = mu.0.len();
        if one.len() != count {
            *one = (0..count).map(|_| self.multipliers.one::<T>()).collect();
            *velocities.get_mut() = (State::zeros_of(&count), State::zeros_of(&count));
            (course.moved, course.back) = (one.clone(), one.clone());
            course.end = mu.clone();
            course.steps = 0;
        }
        if course.steps >= CHECKPOINT || course.end != *mu {
            course.steps = 0;
        }
        if course.steps == 0 {
            course.moved.assign(one);
        }
        for (back, moved) in course.back.iter_mut().zip(course.moved.iter()) {
            *back = self.multipliers.inverse::<T>(moved);
        }
    }
}

impl<S, M, H, A, T> Integrator<T> for LiftFreeSites<S, M, H>
where
    S: Equivariant,
    M: Multipliers<Space = LiePoisson<A>>,
    H: SitesHamiltonian<A::Element<T>>,
    A: LieAlgebra,
    T: Real,
{
    type State = Covector<Sites<A::Element<T>>>;
    type Momentum = Covector<Sites<A::Element<T>>>;
    type Workspace = LiftFreeSitesWorkspace<
        S::Workspace<Sites<Multiplier<M, T>>>,
        Multiplier<M, T>,
        A::Element<T>,
    >;

    fn workspace(&self) -> Self::Workspace {
        let none = || State::zeros_of(&0);
        LiftFreeSitesWorkspace {
            scheme: self.scheme.workspace(),
            velocities: RefCell::new((State::zeros_of(&0), State::zeros_of(&0))),
            one: none(),
            course: SitesCourse { end: State::zeros_of(&0), moved: none(), back: none(), steps: 0 },
        }
    }

    fn step(
        &self,
        mu: &Self::State,
        step: f64,
        workspace: &mut Self::Workspace,
    ) -> Result<Step<Self::State>, StepError> {
        Step::of_copy(mu, |mu| Integrator::<T>::step_in_place(self, mu, step, workspace))
    }

    fn step_in_place(
        &self,
        mu: &mut Self::State,
        step: f64,
        workspace: &mut Self::Workspace,
    ) -> Result<usize, StepError> {
        self.prepare::<_, A, T>(mu, workspace);
        let LiftFreeSitesWorkspace { scheme: storage, velocities, one, course } = workspace;
        let continues = course.steps > 0;
        if !continues {
            self.scheme.forget(storage);
        }
        let field = MultipliersField {
            multipliers: &self.multipliers,
            hamiltonian: &self.hamiltonian,
            start: &*mu,
            velocities,
            frame: [&course.moved, &course.back],
            continues,
        };
        let made = self.scheme.increment::<T, _>(&field, one, step, storage);
        course.steps = if made.is_ok() { course.steps + 1 } else { 0 };
        let Step { point: mut q, iterations } = made?;
        q.add_in_place(one);
        let ends = course.end.0.iter_mut().zip(mu.0.iter()).zip(q.iter());
        ends.for_each(|((end, mu), q)| {
            let mu = Covector(*mu);
            *end = (mu + self.multipliers.coadjoint_change::<T>(q, &mu)).0;
        });
        // Explicit methods make no iterations and predict nothing.
        if iterations > 0 {
            course.moved.iter_mut().zip(q.iter()).for_each(|(moved, q)| {
                *moved = self.multipliers.product::<T>(q, moved);
            });
        } else {
            course.steps = 0;
        }
        if let Some(temporaries) = self.scheme.temporaries(storage) {
            q.give(temporaries);
        }
        if !course.end.is_finite() {
            course.steps = 0;
            return Err(StepError::NotFinite);
        }
        mu.assign(&course.end);
        Ok(iterations)
    }

    fn forget(&self, workspace: &mut Self::Workspace) {
        self.scheme.forget(&mut workspace.scheme);
        workspace.course.steps = 0;
    }

    fn momentum(&self, mu: &Self::State) -> Self::Momentum {
        mu.clone()
    }
}

impl<S, M, H> StateIsMomentum for LiftFreeSites<S, M, H> {}
