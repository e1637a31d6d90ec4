//! The spherical midpoint method: [`SphericalMidpoint`].

use crate::error::StepError;
use crate::integrators::state_is_momentum::StateIsMomentum;
use crate::integrators::trajectories::integrator::Integrator;
use crate::iteration::convergence::unknown;
use crate::iteration::stage_scale::OwnScale;
use crate::iteration::stage_solver::StageSolver;
use crate::schemes::scheme::Step;
use crate::vector_field::VectorField;
use lie_poisson::{Covector, Mask, Power, Real, Sites, State, Vector};
use nalgebra::Vector3;

/// The spherical midpoint method on (so(3)∗)ᴺ, a product of spheres |w_i| = r_i:
///
/// ```text
/// w′ = w + h X(m),    m_i = r_i (w_i + w′_i)/|w_i + w′_i|
/// ```
///
/// The field must be tangent to the spheres, as X_h is. The method is the midpoint rule with the midpoint projected to
/// the spheres: a symmetric Poisson map of order 2, invariant under rotations. For a Hamiltonian that is constant on
/// rays it equals the collective midpoint rule through the Hopf map, without a lift.
///
/// Source: McLachlan, Modin & Verdier, *A minimal-variable symplectic integrator on spheres*, Math.
/// Comp. 86 (2017).
///
/// # Example
/// ```
/// use collective_integrators::{HamiltonianField, SphericalMidpoint, Start};
/// use lie_poisson::{Covector, LiePoisson, Power, PowerAlgebra, So3, from_closure};
/// use nalgebra::Vector3;
/// type Spins = LiePoisson<PowerAlgebra<So3, 2>>;
/// // two spins that attract each other; their sum is conserved
/// let field = HamiltonianField {
///     space: LiePoisson::minus(PowerAlgebra::<_, 2>(So3)),
///     hamiltonian: from_closure::<Spins, _>(|Covector(Power([s, t]))| -s.dot(t)),
/// };
/// let spins = Covector(Power([Vector3::x(), Vector3::new(0.0, 0.6, 0.8)]));
/// for sample in SphericalMidpoint::new(field).trajectory(&spins, 0.1)?.take(100) {
///     let [s, t] = sample?.state.0.0;
///     assert!((s.norm() - 1.0).abs() < 1e-14);
///     assert!((s + t - Vector3::new(1.0, 0.6, 0.8)).norm() < 1e-13);
/// }
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SphericalMidpoint<F> {
    field: F,
    solver: StageSolver,
}

impl<F> SphericalMidpoint<F> {
    /// Creates the method for a field that is tangent to the spheres.
    pub fn new(field: F) -> Self {
        Self { field, solver: StageSolver::default() }
    }

    /// Returns the method with another solver for its implicit equation. Its unknowns are the rates k_i at the midpoint, to
    /// which the tolerance is relative.
    #[must_use]
    pub fn with_solver(self, solver: StageSolver) -> Self {
        Self { solver, ..self }
    }

    /// Returns the vector field of the method.
    pub fn field(&self) -> &F {
        &self.field
    }
}

/// A point w = (w₁, …, w_N) of (so(3)∗)ᴺ, on a product of spheres.
///
/// It is implemented for N known when the program is compiled, and for N known when it runs.
pub trait OnSpheres: State {
    /// Moves each vector along its ray to the sphere that contains the vector of w with the same index:
    ///
    /// ```text
    /// u_i ← u_i |w_i|/|u_i|
    /// ```
    ///
    /// The result is NaN for u_i = 0. It is wrong if |w_i|² or |u_i|² overflows or underflows: keep lengths between 1e-150
    /// and 1e150.
    fn project_to_spheres_of(&mut self, w: &Self);
}

impl<T: Real, const N: usize> OnSpheres for Covector<Power<Vector3<T>, N>> {
    #[inline]
    fn project_to_spheres_of(&mut self, w: &Self) {
        project(&mut self.0.0, &w.0.0);
    }
}

impl<T: Real> OnSpheres for Covector<Sites<Vector3<T>>> {
    #[inline]
    fn project_to_spheres_of(&mut self, w: &Self) {
        project(&mut self.0, &w.0);
    }
}

#[inline]
fn project<T: Real>(u: &mut [Vector3<T>], w: &[Vector3<T>]) {
    for (u, w) in u.iter_mut().zip(w) {
        *u = u.scaled((w.dot(w) / u.dot(u)).sqrt());
    }
}

/// The storage of a step of the [`SphericalMidpoint`] method.
#[derive(Clone, Debug)]
pub struct SphericalWorkspace<V: State> {
    pool: V::Pool,
}

impl<F> SphericalMidpoint<F> {
    /// Returns w + h X(m), with the number of iterations.
    #[inline]
    fn end<T: Real>(
        &self,
        w: &F::Point,
        step: f64,
        pool: &mut <F::Point as State>::Pool,
    ) -> Result<Step<F::Point>, StepError>
    where
        F: VectorField<T, Point: OnSpheres>,
    {
        let mut k = [F::Point::take(pool, w)];
        let [mut spare, mut middle] = [(); 2].map(|()| F::Point::take(pool, w));
        self.field.at_into(w, &mut k[0]);
        let mut derivative = |_: usize, k: &[F::Point], value: &mut F::Point| {
            middle.assign(w);
            middle.add_combination(&[0.5 * step], k);
            middle.project_to_spheres_of(w);
            self.field.at_into(&middle, value);
        };
        let (none, mut pace) = (T::Mask::from_bool(false), unknown());
        let solver = &self.solver;
        let solved =
            solver.solve_from(none, &OwnScale, &mut k, &mut spare, &mut pace, &mut derivative);
        let [k] = k;
        middle.assign(w);
        middle.add_multiple(T::from_f64(step), &k);
        k.give(pool);
        spare.give(pool);
        match solved {
            Ok(iterations) => Ok(Step { point: middle, iterations }),
            Err(unconverged) => {
                middle.give(pool);
                Err(unconverged.error)
            }
        }
    }
}

impl<T, F> Integrator<T> for SphericalMidpoint<F>
where
    T: Real,
    F: VectorField<T, Point: OnSpheres>,
{
    type State = F::Point;
    type Momentum = F::Point;
    type Workspace = SphericalWorkspace<F::Point>;

    fn workspace(&self) -> Self::Workspace {
        SphericalWorkspace { pool: Default::default() }
    }

    /// # Errors
    /// Returns [`StepError::NotConverged`] if the implicit equation is not solved, for example if a w_i is zero or
    /// moves to its antipode.
    #[inline]
    fn step(
        &self,
        w: &F::Point,
        step: f64,
        SphericalWorkspace { pool }: &mut Self::Workspace,
    ) -> Result<Step<F::Point>, StepError> {
        self.end(w, step, pool)?.finite()
    }

    #[inline]
    fn step_in_place(
        &self,
        w: &mut F::Point,
        step: f64,
        SphericalWorkspace { pool }: &mut Self::Workspace,
    ) -> Result<usize, StepError> {
        let Step { point: mut end, iterations } = self.end(w, step, pool)?;
        let finite = end.is_finite();
        if finite {
            w.move_from(&mut end);
        }
        end.give(pool);
        if finite { Ok(iterations) } else { Err(StepError::NotFinite) }
    }

    /// Nothing is remembered from step to step.
    fn forget(&self, _: &mut Self::Workspace) {}

    fn momentum(&self, w: &F::Point) -> F::Point {
        w.clone()
    }
}

impl<F> StateIsMomentum for SphericalMidpoint<F> {}
