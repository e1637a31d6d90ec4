//! Splitting methods from exact flows: [`Splitting`].

use crate::error::StepError;
use crate::integrators::state_is_momentum::StateIsMomentum;
use crate::integrators::trajectories::integrator::Integrator;
use crate::schemes::scheme::Step;
use crate::splittings::exact_flows::ExactFlows;
use crate::splittings::flow_sequence::{FlowSequence, LieTrotter, Strang};
use crate::step_fractions::alternating_substeps::AlternatingSubsteps;
use lie_poisson::{Real, State};

/// The composition of exact flows φ_i(t) in the order of a [`FlowSequence`], each for its fraction of the step:
///
/// ```text
/// Lie–Trotter   φ_n(h) ∘ … ∘ φ_1(h)                                                   order 1
/// Strang        φ_1(h/2) ∘ … ∘ φ_(n−1)(h/2) ∘ φ_n(h) ∘ φ_(n−1)(h/2) ∘ … ∘ φ_1(h/2)    order 2
/// alternating   φ_2(b_m h) ∘ φ_1(a_m h) ∘ … ∘ φ_2(b_1 h) ∘ φ_1(a_1 h)                 two flows
/// ```
///
/// Strang's splitting is symmetric. A [`Composition`](crate::Composition) therefore raises its order with the same
/// [`Substeps`](crate::Substeps) as for any other symmetric method, to [`order_over`](crate::Substeps::order_over)(2,
/// true). All sequences are explicit, and fail only if the result is not finite.
///
/// Source: Strang (1968), Marchuk (1968); McLachlan & Quispel, *Splitting methods*, Acta Numer. 11
/// (2002).
///
/// # Example
/// ```
/// use collective_integrators::{
///     AlternatingSubsteps, Composition, ExactFlows, Splitting, Start, Substeps,
/// };
/// use nalgebra::Vector2;
///
/// /// The pendulum: dq/dt = p, then dp/dt = −sin q.
/// struct Pendulum;
/// impl ExactFlows for Pendulum {
///     type Point = Vector2<f64>;
///     const COUNT: usize = 2;
///     fn flow(&self, index: usize, t: f64, z: &Vector2<f64>) -> Vector2<f64> {
///         match index {
///             0 => Vector2::new(z.x + t * z.y, z.y),
///             1 => Vector2::new(z.x, z.y - t * z.x.sin()),
///             _ => *z,
///         }
///     }
/// }
/// let energy = |z: &Vector2<f64>| 0.5 * z.y * z.y - z.x.cos();
/// let z = Vector2::new(1.0, 0.0);
/// let composed = Composition::new(Splitting::strang(Pendulum), Substeps::kahan_li8());
/// for sample in composed.trajectory(&z, 0.1)?.take(100) {
///     assert!((energy(&sample?.state) - energy(&z)).abs() < 1e-12);
/// }
/// let nystrom = Splitting::alternating(Pendulum, AlternatingSubsteps::blanes_moan6());
/// for sample in nystrom.trajectory(&z, 0.2)?.take(100) {
///     assert!((energy(&sample?.state) - energy(&z)).abs() < 1e-12);
/// }
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// With more or fewer than two flows, a step of the alternating sequence does not compile:
/// ```
/// # use collective_integrators::{AlternatingSubsteps, ExactFlows, Integrator, Splitting};
/// # use nalgebra::Vector3;
/// /// ż = (1, 2, 3), one coordinate after the other.
/// struct Drift;
/// impl ExactFlows for Drift {
///     type Point = Vector3<f64>;
///     const COUNT: usize = 3;
///     fn flow(&self, index: usize, t: f64, z: &Vector3<f64>) -> Vector3<f64> {
///         z + Vector3::ith(index, t * (index + 1) as f64)
///     }
/// }
/// let three = Splitting::strang(Drift);
/// let step = three.step(&Vector3::zeros(), 0.5, &mut ())?;
/// assert_eq!(step.point, Vector3::new(0.5, 1.0, 1.5));
/// # Ok::<(), collective_integrators::StepError>(())
/// ```
/// ```compile_fail,E0080
/// # use collective_integrators::{AlternatingSubsteps, ExactFlows, Integrator, Splitting};
/// # use nalgebra::Vector3;
/// # struct Drift;
/// # impl ExactFlows for Drift {
/// #     type Point = Vector3<f64>;
/// #     const COUNT: usize = 3;
/// #     fn flow(&self, index: usize, t: f64, z: &Vector3<f64>) -> Vector3<f64> {
/// #         z + Vector3::ith(index, t * (index + 1) as f64)
/// #     }
/// # }
/// let three = Splitting::alternating(Drift, AlternatingSubsteps::blanes_moan4());
/// let step = three.step(&Vector3::zeros(), 0.5, &mut ())?; // evaluation panicked: exactly two flows
/// # Ok::<(), collective_integrators::StepError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Splitting<E, S = Strang> {
    flows: E,
    sequence: S,
}

impl<E> Splitting<E, Strang> {
    /// Creates Strang's symmetric splitting, of order 2: with n flows φ¹, …, φⁿ, each flow runs for half a step in this
    /// order and then for half a step in the reverse order. See [`Strang`].
    pub const fn strang(flows: E) -> Self {
        Self { flows, sequence: Strang }
    }
}

impl<E> Splitting<E, LieTrotter> {
    /// Creates the splitting of Lie and Trotter, of order 1: each flow runs for the whole step, in the order of their
    /// indices. See [`LieTrotter`].
    pub const fn lie_trotter(flows: E) -> Self {
        Self { flows, sequence: LieTrotter }
    }
}

impl<E> Splitting<E, AlternatingSubsteps> {
    /// Creates the splitting that alternates two flows, for the fractions of the step that the coefficients give.
    ///
    /// A step with more or fewer flows does not compile.
    pub const fn alternating(flows: E, substeps: AlternatingSubsteps) -> Self {
        Self { flows, sequence: substeps }
    }
}

impl<E, S: FlowSequence> Splitting<E, S> {
    /// Creates the splitting that runs the flows in the given sequence.
    pub const fn new(flows: E, sequence: S) -> Self {
        Self { flows, sequence }
    }

    /// Returns the exact flows.
    pub const fn flows(&self) -> &E {
        &self.flows
    }

    /// Returns the sequence of the flows.
    pub const fn sequence(&self) -> &S {
        &self.sequence
    }

    /// Returns whether the splitting is symmetric in time, Φ₋ₕ ∘ Φₕ = id.
    #[must_use]
    pub fn is_symmetric(&self) -> bool {
        self.sequence.is_symmetric()
    }

    /// Returns the order of convergence for generic flows.
    #[must_use]
    pub fn order(&self) -> usize {
        self.sequence.order()
    }
}

impl<T: Real, E: ExactFlows<T>, S: FlowSequence> Integrator<T> for Splitting<E, S> {
    type State = E::Point;
    type Momentum = E::Point;
    /// The pool of temporary points, which is `()` for small ones.
    type Workspace = <E::Point as State>::Pool;

    fn workspace(&self) -> Self::Workspace {
        Self::Workspace::default()
    }

    /// Nothing is remembered from step to step.
    fn forget(&self, _: &mut Self::Workspace) {}

    #[inline]
    fn step(
        &self,
        z: &E::Point,
        step: f64,
        pool: &mut Self::Workspace,
    ) -> Result<Step<E::Point>, StepError> {
        let mut point = z.clone();
        self.sequence.run(&self.flows, step, &mut point, pool);
        Step { point, iterations: 0 }.finite()
    }

    #[inline]
    fn step_in_place(
        &self,
        z: &mut E::Point,
        step: f64,
        pool: &mut Self::Workspace,
    ) -> Result<usize, StepError> {
        let mut end = E::Point::take(pool, z);
        end.assign(z);
        self.sequence.run(&self.flows, step, &mut end, pool);
        let finite = end.is_finite();
        if finite {
            z.move_from(&mut end);
        }
        end.give(pool);
        if finite { Ok(0) } else { Err(StepError::NotFinite) }
    }

    fn momentum(&self, z: &E::Point) -> E::Point {
        z.clone()
    }
}

impl<E, S> StateIsMomentum for Splitting<E, S> {}
