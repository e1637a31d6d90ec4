//! The spherical midpoint method.

use crate::{Integrator, StageSolver, StateIsMomentum, Step, StepError, VectorField};
use core::array::from_fn;
use lie_poisson::{Covector, Power, Real, Vector};
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

    /// Returns the method with another solver for its implicit equation.
    #[must_use]
    pub fn with_solver(self, solver: StageSolver) -> Self {
        Self { solver, ..self }
    }

    /// Returns the vector field of the method.
    pub fn field(&self) -> &F {
        &self.field
    }
}

/// A point of (so(3)∗)ᴺ, which is a momentum.
type Spheres<T, const N: usize> = Covector<Power<Vector3<T>, N>>;

impl<T, F, const N: usize> Integrator<T> for SphericalMidpoint<F>
where
    T: Real,
    F: VectorField<T, Point = Spheres<T, N>>,
{
    type State = Spheres<T, N>;
    type Momentum = Spheres<T, N>;
    type Workspace = ();

    fn workspace(&self) {}

    /// # Errors
    /// Returns [`StepError::NotConverged`] if the implicit equation is not solved, for example if a w_i is zero or
    /// moves to its antipode.
    #[inline]
    fn step(
        &self,
        w: &Spheres<T, N>,
        step: f64,
        (): &mut (),
    ) -> Result<Step<Spheres<T, N>>, StepError> {
        let mut k = [Vector::zero()];
        let derivative = |_: usize, k: &[Spheres<T, N>]| {
            let middle = k.first().map_or(*w, |k| moved(w, k, 0.5 * step));
            self.field.at(&on_spheres(w, &middle))
        };
        let iterations = self.solver.solve(self.field.at(w), &mut k, derivative)?;
        let point = moved(w, &k[0], step);
        Step { point, iterations }.finite()
    }

    fn momentum(&self, w: &Spheres<T, N>) -> Spheres<T, N> {
        *w
    }
}

impl<F> StateIsMomentum for SphericalMidpoint<F> {}

/// Returns the sum w + s k.
#[inline]
fn moved<V: Vector>(w: &V, k: &V, s: f64) -> V {
    *w + k.scaled(V::Scalar::from_f64(s))
}

/// Returns the points of the spheres through w on the rays through u.
#[inline]
fn on_spheres<T: Real, const N: usize>(w: &Spheres<T, N>, u: &Spheres<T, N>) -> Spheres<T, N> {
    Covector(Power(from_fn(|i| {
        let (w, u) = (&w.0.0[i], &u.0.0[i]);
        u.scaled((w.dot(w) / u.dot(u)).sqrt())
    })))
}
